:- module(test_stroke, []).
:- use_module(library(plunit)).
:- use_module(rules(sheet/stroke)).
:- use_module(tests('oracle/stroke')).
:- use_module(tests('rules/sample')).

% A whole edge.
line(Visibility, E, A, B, part(Visibility,outline,1,E,0.0,1.0,A,B)).

stroke_ends(Strokes, Ends) :-
    findall(Start-End, member(stroke(_,_,_,_,_,Start,End), Strokes), Ends).

edges_of(Strokes, Edges) :-
    findall(Es, member(stroke(_,_,_,Es,_,_,_), Strokes), Edges).

% N random edges between points of a small grid, so that many meet.
random_parts(Seed, N, Parts) :-
    set_random(seed(Seed)),
    findall(part(Visibility,Role,S,E,0.0,1.0,XA-YA,XB-YB),
            ( between(1, N, E),
              random_member(Visibility, [visible,hidden]),
              random_member(Role, [outline,penetration]),
              random_between(1, 2, S),
              maplist(random_between(0, 4), [XA,YA,XB,YB])
            ),
            Parts).

% N parts of a few edges, cut at tenths, on a grid so small that many meet in
% a point: what the kernel and the rule must put in the same order.
tangled_parts(Seed, N, Parts) :-
    set_random(seed(Seed)),
    random_member(Size, [1,2,4,9]),
    findall(Part, ( between(1, N, _), tangled_part(Size, Part) ), Parts).

tangled_part(Size, part(Visibility,Role,S,E,From,To,XA-YA,XB-YB)) :-
    random_member(Visibility, [visible,hidden]),
    random_member(Role, [outline,penetration,made_up,other]),
    random_between(1, 3, S),
    random_between(1, 9, E),
    random_between(0, 9, From0),
    random_between(From0, 9, To0),
    From is From0/10.0,
    To is (To0+1)/10.0,
    Least is -Size,
    maplist(random_between(Least, Size), [XA,YA,XB,YB]).

% The straight pieces of strokes, as parts, in whatever direction.
piece(Strokes, piece(Visibility,Role,S,E,Low,High)) :-
    member(stroke(Visibility,Role,S,Es,Points,_,_), Strokes),
    nth0(I, Es, E),
    nth0(I, Points, A),
    J is I+1,
    nth0(J, Points, B),
    msort([A,B], [Low,High]).

part_piece(Parts, piece(Visibility,Role,S,E,Low,High)) :-
    member(part(Visibility,Role,S,E,_,_,A,B), Parts),
    A \== B,
    msort([A,B], [Low,High]).

% Each pair of ends once, of what is there; no other piece.
pieces_are_parts(Parts, Strokes) :-
    findall(Piece, piece(Strokes, Piece), Pieces),
    findall(Piece, part_piece(Parts, Piece), Known),
    forall(member(Piece, Pieces), memberchk(Piece, Known)),
    findall(Low-High, member(piece(_,_,_,_,Low,High), Known), Ends0),
    sort(Ends0, Ends),
    findall(Low-High, member(piece(_,_,_,_,Low,High), Pieces), Drawn0),
    msort(Drawn0, Ends).

% Where the two ends of strokes of one kind meet, at most one visible end.
no_needless_lift(Strokes) :-
    forall(( select(stroke(visible,R,S,_,Points1,Start1,_), Strokes, Others),
             Start1 \== ring,
             Points1 = [Point|_]
           ),
           \+ ( member(stroke(visible,R,S,_,Points2,Start2,_), Others),
                Start2 \== ring,
                ( Points2 = [Point|_] ; last(Points2, Point) )
              )).

:- begin_tests(stroke).

test(nothing, true(Strokes == [])) :-
    strokes([], Strokes).
test(chained, true(Strokes ==
        [ stroke(visible,outline,1,[1,2,3],[0-0,5-0,9-0,9-4],
                 joint,joint) ])) :-
    line(visible, 1, 0-0, 5-0, P1),
    line(visible, 2, 9-0, 5-0, P2),
    line(visible, 3, 9-0, 9-4, P3),
    strokes([P3,P1,P2], Strokes).
test(ring, true(Strokes ==
        [ stroke(visible,outline,1,[1,2,3],[0-0,5-0,5-5,0-0],ring,ring) ])) :-
    line(visible, 1, 0-0, 5-0, P1),
    line(visible, 2, 5-0, 5-5, P2),
    line(visible, 3, 5-5, 0-0, P3),
    strokes([P1,P2,P3], Strokes).
test(hidden_ends_at_corner, true(Edges == [[1],[2]])) :-
    line(hidden, 1, 0-0, 5-0, P1),
    line(hidden, 2, 5-0, 5-5, P2),
    strokes([P1,P2], Strokes),
    edges_of(Strokes, Edges).
test(hidden_runs_on, true(Edges == [[1,2]])) :-
    line(hidden, 1, 0-0, 5-0, P1),
    line(hidden, 2, 5-0, 10-2, P2),
    strokes([P1,P2], Strokes),
    edges_of(Strokes, Edges).
test(straight_on_at_a_crossing, true(Edges == [[1,3],[2,4]])) :-
    line(visible, 1, 0-5, 5-5, P1),
    line(visible, 2, 5-0, 5-5, P2),
    line(visible, 3, 5-5, 9-5, P3),
    line(visible, 4, 5-5, 5-9, P4),
    strokes([P1,P2,P3,P4], Strokes),
    edges_of(Strokes, Edges).
test(apex, true(N-M == 20-40)) :-
    findall(P, ( between(1, 40, E),
                 Angle is E*pi/20,
                 X is round(1000*cos(Angle)),
                 Y is round(1000*sin(Angle)),
                 line(visible, E, 0-0, X-Y, P)
               ), Parts),
    strokes(Parts, Strokes),
    length(Strokes, N),
    edges_of(Strokes, Edges),
    append(Edges, All),
    length(All, M).
test(not_across_kinds, true(N == 4)) :-
    strokes([ part(visible,outline,1,1,0.0,1.0,0-0,5-0),
              part(visible,crease,1,2,0.0,1.0,5-0,9-0),
              part(hidden,crease,1,3,0.0,1.0,9-0,12-0),
              part(hidden,crease,2,4,0.0,1.0,12-0,15-0)
            ], Strokes),
    length(Strokes, N).
test(goes_on_hidden, true(Ends == [cut-joint,joint-cut])) :-
    line(visible, 1, 0-0, 5-0, P1),
    line(hidden, 2, 5-0, 10-1, P2),
    strokes([P1,P2], Strokes),
    stroke_ends(Strokes, Ends).
test(ends_at_corner, true(Ends == [joint-joint,joint-joint])) :-
    line(visible, 1, 0-0, 5-0, P1),
    line(hidden, 2, 5-0, 5-5, P2),
    strokes([P1,P2], Strokes),
    stroke_ends(Strokes, Ends).
test(another_goes_straight_on, true(Ends == [cut-joint,joint-cut])) :-
    strokes([ part(visible,outline,1,1,0.0,1.0,0-0,5-0),
              part(hidden,crease,2,1,0.0,1.0,5-0,9-0) ], Strokes),
    stroke_ends(Strokes, Ends).
test(another_bends, true(Ends == [joint-joint,joint-joint])) :-
    strokes([ part(visible,outline,1,1,0.0,1.0,0-0,5-0),
              part(hidden,crease,2,1,0.0,1.0,5-0,9-1) ], Strokes),
    stroke_ends(Strokes, Ends).
test(dashes_meet, true(Ends == [joint-joint,joint-joint,joint-cut])) :-
    line(visible, 1, 0-0, 5-0, P1),
    line(hidden, 2, 5-0, 10-0, P2),
    line(hidden, 3, 5-0, 5-5, P3),
    strokes([P1,P2,P3], Strokes),
    stroke_ends(Strokes, Ends).
test(same_edge_goes_on, true(Ends == [cut-joint,joint-joint,joint-cut])) :-
    line(hidden, 3, 5-0, 5-5, P3),
    strokes([ part(visible,outline,1,1,0.0,0.5,0-0,5-0),
              part(hidden,outline,1,1,0.5,1.0,5-0,10-0),
              P3 ], Strokes),
    stroke_ends(Strokes, Ends).
test(hidden_by_a_line_alone, true(Ends == [joint-joint])) :-
    strokes([part(hidden,outline,1,1,0.5,0.75,5-0,10-0)], Strokes),
    stroke_ends(Strokes, Ends).
test(cut_ends, true(Strokes ==
        [ stroke(hidden,outline,1,[1],[5-0,10-0],cut,joint),
          stroke(visible,outline,1,[1],[0-0,5-0],joint,cut) ])) :-
    strokes([ part(hidden,outline,1,1,0.5,1.0,5-0,10-0),
              part(visible,outline,1,1,0.0,0.5,0-0,5-0)
            ], Strokes).
test(parts_of_an_edge_join, true(Strokes ==
        [ stroke(visible,outline,1,[1],[0-0,10-0],joint,joint) ])) :-
    strokes([ part(visible,outline,1,1,0.5,1.0,5-0,10-0),
              part(visible,outline,1,1,0.0,0.5,0-0,5-0)
            ], Strokes).
test(no_length, true(Strokes == [])) :-
    line(visible, 1, 5-5, 5-5, P),
    strokes([P], Strokes).
test(visible_hides_the_dashes, true(Edges == [[2]])) :-
    line(hidden, 1, 5-0, 0-0, P1),
    line(visible, 2, 0-0, 5-0, P2),
    strokes([P1,P2], Strokes),
    edges_of(Strokes, Edges).
test(painting_order, true(Kinds == [ hidden-outline, hidden-penetration,
                                     visible-mesh, visible-made_up,
                                     visible-penetration ])) :-
    findall(part(V,R,1,E,0.0,1.0,0-E,9-E),
            nth1(E, [ visible-penetration, visible-mesh, hidden-penetration,
                      hidden-outline, visible-made_up ], V-R),
            Parts),
    strokes(Parts, Strokes),
    findall(V-R, member(stroke(V,R,_,_,_,_,_), Strokes), Kinds).
test(random, [forall(numbered(15, 40, Seed)), true]) :-
    random_parts(Seed, 60, Parts),
    strokes(Parts, Strokes),
    pieces_are_parts(Parts, Strokes),
    no_needless_lift(Strokes).
test(order_of_input, [ forall(between(1, 10, Seed)),
                       true(Again == Strokes) ]) :-
    random_parts(Seed, 60, Parts),
    strokes(Parts, Strokes),
    random_permutation(Parts, Shuffled),
    strokes(Shuffled, Again).
test(kernel_is_rule, [forall(numbered(100, 300, Seed))]) :-
    N is 1 + Seed mod 90,
    tangled_parts(Seed, N, Parts),
    strokes(Parts, Kernel),
    strokes_by_rule(Parts, Rule),
    assertion(Seed-Kernel == Seed-Rule).
test(kernel_is_rule_at_an_apex) :-
    findall(part(Visibility,outline,1,E,0.0,1.0,0-0,X-Y),
            ( between(1, 61, E),
              nth0(V, [visible,hidden], Visibility),
              V =:= E mod 2,
              Angle is E*E*pi/200,
              X is round(1000*cos(Angle)),
              Y is round(1000*sin(Angle)) ),
            Parts),
    strokes(Parts, Kernel),
    strokes_by_rule(Parts, Rule),
    assertion(Kernel == Rule).
test(bad_parts, [forall(member(Parts-Error,
                               [ x-type_error(list, x),
                                 [x]-type_error(part, x),
                                 [part(visible,outline,1,1,0.0,1.0,x,0-0)]
                                 - type_error(pair, x),
                                 [part(1,outline,1,1,0.0,1.0,0-0,1-0)]
                                 - type_error(_, 1)
                               ])),
                 throws(error(Error, _))]) :-
    strokes(Parts, _).
test(length, true(Length =:= 9.0)) :-
    stroke_length(stroke(visible,outline,1,[1,2],[0-0,5-0,5-4],
                         joint,joint),
                  Length).

:- end_tests(stroke).
