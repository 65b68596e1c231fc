:- encoding(utf8).
:- module(test_explain_hidden, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(occurs)).
:- use_module(rules(decision), [use_rules/1]).
:- use_module(rules(explanation/explain)).
:- use_module(rules(picture/contour), [contour_ends/4, dividing_piece/3]).
:- use_module(tests('oracle/view'), [screen_plane/5]).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(primitive/primitive)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(picture/view)).
:- use_module(tests('rules/polyhedron')).
:- use_module(tests('rules/sample')).

/* Explanations of lines of the picture: by hand, and what must hold of every
   line of random scenes, found again from the model's points. */

%   behind_a_square: a curve from x = -1 to 1, behind a square from -0.5 to 0.5.

behind_a_square :-
    curve(1, [p(-1,1,0), p(1,1,0)]),
    square(2, 0),
    set_view(front).

square(S, Y) :-
    polyhedron(S, surface, [p(-0.5,Y,-1),p(0.5,Y,-1),p(0.5,Y,1),p(-0.5,Y,1)],
               [[1,2,3,4]]).

%   said(Item, Statement, Under): Under are the statements below it.

said(Item, Statement, Under) :-
    explanation(Item, Because),
    sub_term(Term, Because),
    nonvar(Term),
    Term = because(Statement, Below),
    findall(Under0, member(because(Under0, _), Below), Under).

said(Item, Statement) :-
    said(Item, Statement, _).

in_rules(Text, Goal) :-
    tmp_file_stream(File, Out, [encoding(utf8),extension(pl)]),
    call_cleanup(( write(Out, Text), close(Out), use_rules(File), Goal ),
                 delete_file(File)).

random_scene(Seed) :-
    set_random(seed(Seed)),
    forall(between(1, 3, S), random_prism(S)),
    curve(4, [p(-2,-2,-1), p(2,1.5,1), p(1,-2,0.2)]),
    polyhedron(5, surface, [p(-2,0,-1),p(2,0.2,-1),p(1,0.1,1)], [[1,2,3]]),
    random_member(Cut, [true,false]),
    (   Cut == true
    ->  penetrate
    ;   true
    ),
    Theta is 360*random_float,
    Phi is 180*random_float,
    set_view(Theta, Phi, 12),
    random_member(Kind, [parallel,central]),
    set_projection(Kind),
    picture([lines(all)]).

random_prism(S) :-
    random_between(3, 6, N),
    R is 0.3+random_float,
    prism(N, R, 1.5, Points0, Faces),
    random_point(X, Y, Z),
    moved(by(X,Y,Z), Points0, Points1),
    random_member(Move, [axes,by(0,0,0)]),
    moved(Move, Points1, Points),
    polyhedron(S, solid, Points, Faces).

random_point(X, Y, Z) :-
    X is 2*random_float-1,
    Y is 2*random_float-1,
    Z is 2*random_float-1.

%   smooth_scene: a torus seen from aslant, in part behind a box.

smooth_scene :-
    add_primitive(torus(radius(2), tube(0.7)), _),
    add_primitive(at([translate(0,-4,0)], box(size(1,1,1))), _),
    complete_segments,
    set_view(280, 65, 0),
    picture.

/* - - - what must hold - - - */

%   bad_line(Fault): the explanation of a line, with all that is drawn of it.

bad_line(S-E-Fault) :-
    explanation(hidden(S, E), [because(outline_piece(S, E, _, _), Because)]),
    fault(S, E, none, Because, Fault).
bad_line(S-E-Fault) :-
    explanation(hidden(S, E), [because(hidden_line(S, E, V1, V2), Because)]),
    line_points(S, V1, V2, Line),
    fault(S, E, Line, Because, Fault).

fault(S, E, _, Because, not_drawn_where(From, To)) :-
    drawn(_, S, E, From, To, Visibility, _),
    \+ ( member(because(Part, _), Because),
         part(Visibility, Part, From1, To1),
         From1 =< From+1.0e-9,
         To =< To1+1.0e-9 ).
fault(_, _, _, Because, gap(Ends)) :-
    findall(From-To, ( member(because(Part, _), Because),
                       part(_, Part, From, To) ), Ends),
    Ends \== [],
    \+ end_to_end(Ends, 0.0).
fault(_, _, _, Because, not_covered(From, To)) :-
    member(because(hidden_part(From, To), Under), Because),
    \+ member(because(backs(_, _), _), Under),
    findall(A-B, ( member(because(hiding_face(_,_,A,B,_), _), Under)
                 ; member(because(turned_away(_,_,A,B), _), Under)
                 ; member(because(behind_fold(A), _), Under), B = 1.0 ),
            Faces0),
    msort(Faces0, Faces),
    \+ reaches(Faces, From, To).
fault(_, _, Line, Because, wrong_end(Statement)) :-
    Line \== none,
    sub_term(Term, Because),
    nonvar(Term),
    Term = because(Statement, _),
    wrong_end(Statement, Line).
fault(_, _, Line, Because, wrong_side(Statement)) :-
    Line \== none,
    sub_term(Term, Because),
    nonvar(Term),
    Term = because(Statement, _),
    wrong_side(Statement, Line).

part(hidden, hidden_part(From, To), From, To).
part(visible, visible_part(From, To), From, To).

end_to_end([], At) :-
    At =:= 1.0.
end_to_end([From-To|Ends], At) :-
    From =:= At,
    end_to_end(Ends, To).

reaches(_, At, To) :-
    At >= To-1.0e-6,
    !.
reaches([A-B|Faces], At, To) :-
    A =< At+1.0e-6,
    At1 is max(At, B),
    reaches(Faces, At1, To).

%   Points of the picture: the line's own, those of an edge, the plane of a
%   polygon.

line_points(S, V1, V2, Z1-Z2) :-
    screen(S, V1, X1, Y1, D1),
    screen(S, V2, X2, Y2, D2),
    Z1 = p(X1,Y1,D1),
    Z2 = p(X2,Y2,D2).

at(p(X1,Y1,Z1)-p(X2,Y2,Z2), T, p(X,Y,Z)) :-
    X is X1+T*(X2-X1),
    Y is Y1+T*(Y2-Y1),
    Z is Z1+T*(Z2-Z1).

wrong_end(ends_at_outline(_, At, S, E), Line) :-
    at(Line, At, p(X,Y,_)),
    K is -E,
    contour_ends(S, K, Start, End),
    off(0.01, X-Y, Start, End).
wrong_end(ends_at_edge(_, At, S, E, V1, V2), Line) :-
    \+ risen(S, E),
    at(Line, At, p(X,Y,_)),
    line_points(S, V1, V2, p(X1,Y1,_)-p(X2,Y2,_)),
    off(1.0e-7, X-Y, X1-Y1, X2-Y2).
wrong_end(ends_in_face(_, At, S, P), Line) :-
    at(Line, At, p(X,Y,Z)),
    face_depth(S, P, X, Y, Face),
    abs(Z-Face) > 1.0e-6.
wrong_end(ends_with_line(_, At), _) :-
    At =\= 0.0,
    At =\= 1.0.

%   Where what an outline divides folds in the picture, the outline is near.

off(Most, X-Y, X1-Y1, X2-Y2) :-
    Length is sqrt((X2-X1)**2+(Y2-Y1)**2),
    Off is abs((X2-X1)*(Y-Y1)-(Y2-Y1)*(X-X1))/Length,
    Along is ((X2-X1)*(X-X1)+(Y2-Y1)*(Y-Y1))/Length,
    \+ ( Off < Most, Along > -Most, Along < Length+Most ).

%   What an outline on the surface divides is not where its plane is.

risen(S, E) :-
    edge_polygon(S, E, P),
    divided(S, P).

divided(S, P) :-
    t(S, P, T, _, _, _),
    dividing_piece(S, T, _),
    !.

wrong_side(Statement, _) :-
    (   Statement = hiding_face(S,P,_,_,Off)
    ;   Statement = face_behind(S,P,_,_,Off)
    ),
    divided(S, P),
    !,
    Off < 0.0.
wrong_side(hiding_face(S, P, From, To, Behind), Line) :-
    \+ in_middle(Line, S, P, From, To, Behind).
wrong_side(face_behind(S, P, From, To, Before), Line) :-
    Behind is -Before,
    \+ in_middle(Line, S, P, From, To, Behind).

in_middle(Line, S, P, From, To, Behind) :-
    Middle is (From+To)/2,
    at(Line, Middle, p(X,Y,Z)),
    face_depth(S, P, X, Y, Face),
    (   current_view(_, _, _, parallel)
    ->  abs(Z-Face-Behind) < 1.0e-6
    ;   Z-Face =\= 0.0,
        sign(Z-Face) =:= sign(Behind)
    ).

%   The depth of polygon P at X, Y: of the plane of its largest triangle.

face_depth(S, P, X, Y, Z) :-
    aggregate_all(max(Size, T), ( t(S, P, T, A, B, C),
                                  picture_area(S, A, B, C, Size) ),
                  max(_, T)),
    screen_plane(S, T, A1, B1, D1),
    Z is -(A1*X + B1*Y + D1).

picture_area(S, A, B, C, Area) :-
    line_points(S, A, B, p(X1,Y1,_)-p(X2,Y2,_)),
    screen(S, C, X3, Y3, _),
    Area is abs((X2-X1)*(Y3-Y1)-(X3-X1)*(Y2-Y1)).

:- begin_tests(explain_hidden).

test(hidden_by_a_square) :-
    in_new_world(( behind_a_square, picture,
                   once(said(hidden(1, 1), hidden_part(0.25, 0.75), [Face])),
                   Face = hiding_face(2, 1, 0.25, 0.75, 1.0),
                   findall(E, said(hidden(1, 1), ends_at_edge(_,_,2,E,_,_)),
                           Es0),
                   msort(Es0, [2,4]) )).
test(nothing_over) :-
    in_new_world(( behind_a_square, picture,
                   findall(F-U, said(why_not(hidden(1, 1)),
                                     visible_part(F, _), U),
                           [0.0-[nothing_over],0.75-[nothing_over]]),
                   \+ said(why_not(hidden(1, 1)), hidden_part(_, _)) )).
test(nowhere_visible) :-
    in_new_world(( behind_a_square,
                   curve(3, [p(-0.3,1,0.2), p(0.3,1,0.2)]), picture,
                   once(said(why_not(hidden(3, 1)), nowhere_visible)),
                   \+ said(hidden(3, 1), nowhere_visible),
                   \+ said(why_not(hidden(1, 1)), nowhere_visible) )).
test(nearest_first, Ps == [3,2]) :-
    in_new_world(( behind_a_square, square(3, -1), picture,
                   findall(P, said(hidden(1, 1), hiding_face(P,_,_,_,_)),
                           Ps) )).
test(from_near, [forall(member(Rho, [3,10,100]))]) :-
    in_new_world(( behind_a_square, set_view(270, 90, Rho),
                   set_projection(central), picture,
                   once(said(hidden(1, 1), hiding_face(2,1,_,_,Behind))) )),
    assertion(abs(Behind-1) < 1.0e-9).
test(in_front, Before =:= 1.0) :-
    in_new_world(( curve(1, [p(-1,-1,0), p(1,-1,0)]), square(2, 0),
                   set_view(front), picture,
                   once(said(why_not(hidden(1, 1)),
                             face_behind(2, 1, 0.25, 0.75, Before))) )).
test(goes_through) :-
    in_new_world(( curve(1, [p(-0.25,-1,0), p(0.25,1,0)]), square(2, 0),
                   set_view(front), picture,
                   once(said(hidden(1, 1), hiding_face(2, 1, 0.5, 1.0, B),
                             [ends_in_face(from, 0.5, 2, 1),
                              ends_with_line(to, 1.0)])),
                   B =:= 0.5 )).
test(backs) :-
    in_new_world(( box_points(p(0,0,0), p(1,1,1), Points), box_faces(Faces),
                   polyhedron(1, solid, Points, Faces), set_view(300, 60, 5),
                   picture, once(drawn(_, S, E, 0.0, 1.0, hidden, crease)),
                   once(said(hidden(S, E), hidden_part(0.0, 1.0),
                             [backs(1, 2)|_])) )).
test(own_faces, Under == [line_in_face(2, 1), nothing_over]) :-
    in_new_world(( square(2, 0), set_view(front), picture,
                   once(said(hidden(2, 1), visible_part(0.0, 1.0), Under)) )).
test(end_on) :-
    in_new_world(( curve(1, [p(0,0,0), p(0,1,0), p(1,1,0)]), set_view(front),
                   picture, once(said(hidden(1, 1), end_on)) )).
test(not_drawn) :-
    in_new_world(( polyhedron(1, surface,
                              [p(0,0,0),p(1,0,0),p(1,0,1),p(0,0,1)],
                              [[1,2,3],[1,3,4]]),
                   set_view(front), picture, e(1, E, 1, 3, 1),
                   once(said(hidden(1, E), not_drawn(mesh, feature), [])) )).
test(bends_less, true(Bend < 0.01)) :-
    in_new_world(( polyhedron(1, surface,
                              [p(0,0,0),p(1,0,0),p(1,1.0e-6,1),p(0,0,1)],
                              [[1,2,3],[1,3,4]]),
                   set_view(front), picture, e(1, E, 1, 3, 1),
                   once(said(hidden(1, E), not_drawn(mesh, feature),
                             [faces_bend(Bend)])) )).
test(drawn_instead) :-
    in_new_world(( curve(1, [p(0,0,0), p(1,0,0)]),
                   curve(2, [p(0.5,1,0), p(2,1,0)]), set_view(front), picture,
                   once(said(hidden(2, 1),
                             drawn_instead(0.0, To, visible, 1, 1, curve))) )),
    abs(To-1/3) < 1.0e-9.
test(twin) :-
    in_new_world(( square(2, 0), set_view(front), picture,
                   findall(E, ( e(2, E, _, _, _),
                                \+ explanation(hidden(2, E), _) ), []) )).
test(names, [forall(member(Name, [s1e1, 's1e1', s1e1-2, 's1e1-2', "s1e1"]))]) :-
    in_new_world(( behind_a_square, picture,
                   explanation(hidden(Name), Because),
                   explanation(hidden(1, 1), Because) )).
test(no_such, [forall(member(Item, [hidden(7, 1), hidden(1, 9), hidden(s1e9),
                                    hidden(s1), hidden(e1), hidden(_),
                                    why_not(hidden(1, 9)), why_not(line(1))])),
               fail]) :-
    in_new_world(( behind_a_square, picture, explanation(Item, _) )).
test(no_picture, fail) :-
    in_new_world(( behind_a_square, explanation(hidden(1, 1), _) )).
test(every_line, N == 5) :-
    in_new_world(( behind_a_square, picture,
                   aggregate_all(count, explanation(hidden(_, _), _), N) )).
test(divided, Parts == [0.0-1.0,0.0-1.0]) :-
    in_new_world(( curve(1, [p(-0.25,-1,0), p(0.25,1,0)]), square(2, 0),
                   penetrate, set_view(front), picture,
                   findall(F-T, ( said(hidden(1, 1), Part),
                                  part(_, Part, F, T) ), Parts),
                   aggregate_all(count, said(hidden(1, 1), part_of(1,1,_,_)),
                                 2) )).
test(glass, true(By \== default)) :-
    in_new_world(( behind_a_square,
                   in_rules("may_hide(S, _, _, _) :- S =\\= 2.",
                            ( picture,
                              once(said(why_not(hidden(1, 1)),
                                        let_through(2, 1, 0.25, 0.75,
                                                    may_hide/4, By))) )) )).
test(some_segments, fail) :-
    in_new_world(( behind_a_square, picture([segments([1])]),
                   explanation(hidden(1, 1), [segments([1])], Because),
                   sub_term(Term, Because),
                   nonvar(Term),
                   Term = hiding_face(_,_,_,_,_) )).
test(outline, true(N > 20)) :-
    in_new_world(( smooth_scene,
                   aggregate_all(count, ( said(hidden(_, E), Piece),
                                          Piece = outline_piece(_,E,_,_) ),
                                 N),
                   once(said(hidden(_, _), behind_fold(_))),
                   findall(Fault, bad_line(Fault), Faults) )),
    assertion(Faults == []).
test(outline_name) :-
    in_new_world(( smooth_scene, once(drawn(_, S, E, _, _, _, _)), E < 0,
                   K is -E,
                   format(atom(Name), 's~de', [S]),
                   explanation(hidden(Name-K), Because),
                   explanation(hidden(S, E), Because) )).
test(text, First == "line s1e1: edge 1 of segment 1 (test), in the picture \c
                     from vertex 1 (0) to vertex 2 (1)") :-
    in_new_world(( behind_a_square, picture,
                   with_output_to(string(Text), explain(hidden(s1e1))) )),
    split_string(Text, "\n", "", [First|_]).
test(random, [forall(numbered(15, 40, Seed))]) :-
    in_new_world(( random_scene(Seed),
                   findall(Fault, bad_line(Fault), Faults) )),
    assertion(Seed-Faults == Seed-[]).

:- end_tests(explain_hidden).
