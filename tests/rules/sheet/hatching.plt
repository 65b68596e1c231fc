:- module(test_hatching, []).
:- use_module(library(plunit)).
:- use_module(rules(sheet/hatching)).
:- use_module(rules(sheet/sheet_marks)).
:- use_module(tests('rules/sample')).

% The edges of loops of points.
loop_edges(Points, Edges) :-
    Points = [First|Rest],
    append(Rest, [First], Next),
    maplist([A,B,A-B]>>true, Points, Next, Edges).

region(Loops, Edges) :-
    maplist(loop_edges, Loops, Edges0),
    append(Edges0, Edges).

rectangle(X1, Y1, X2, Y2, [X1-Y1,X2-Y1,X2-Y2,X1-Y2]).

length_of((X1-Y1)-(X2-Y2), L) :-
    L is sqrt((X2-X1)**2 + (Y2-Y1)**2).

total(Lines, Total) :-
    maplist(length_of, Lines, Lengths),
    sum_list(Lengths, Total).

% Length times spacing is the area, but for the ends.
fills(Edges, Way, Spacing) :-
    hatch_lines(Edges, Way, Spacing, Lines),
    total(Lines, Total),
    region_area(Edges, Area),
    abs(Total*Spacing/Area - 1) < 0.02.

% A point is inside if a ray to the right crosses oddly many edges.
inside(X-Y, Edges) :-
    aggregate_all(count,
                  ( member((X1-Y1)-(X2-Y2), Edges),
                    ( Y1 =< Y, Y < Y2 ; Y2 =< Y, Y < Y1 ),
                    X1 + (X2-X1)*(Y-Y1)/(Y2-Y1) > X ),
                  N),
    N mod 2 =:= 1.

% Loops of a star round 0-0 and a small star in it.
random_region(Seed, Edges) :-
    set_random(seed(Seed)),
    star(40 000, 90 000, 0, Outer),
    star(5 000, 30 000, 0, Hole0),
    reverse(Hole0, Hole),
    region([Outer,Hole], Edges).

star(Low, High, At, Points) :-
    findall(X-Y,
            ( between(0, 16, I),
              Angle is 2*pi*I/17,
              random_between(Low, High, R),
              X is At + round(R*cos(Angle)),
              Y is At + round(R*sin(Angle))
            ),
            Points).

:- begin_tests(hatching).

test(square, [forall(member(Way, [rising,falling]))]) :-
    rectangle(0, 0, 60 000, 60 000, Square),
    region([Square], Edges),
    fills(Edges, Way, 3000).
test(ring, [forall(member(Way, [rising,falling]))]) :-
    rectangle(0, 0, 80 000, 60 000, Outer),
    rectangle(20 000, 15 000, 60 000, 45 000, Hole0),
    reverse(Hole0, Hole),
    region([Outer,Hole], Edges),
    region_area(Edges, Area),
    Area =:= 80 000*60 000 - 40 000*30 000,
    fills(Edges, Way, 2000).
test(all_random,
     [forall(( numbered(20, 60, Seed), member(Way, [rising,falling]) ))]) :-
    random_region(Seed, Edges),
    fills(Edges, Way, 1500).
test(inside_only, [forall(numbered(15, 40, Seed))]) :-
    random_region(Seed, Edges),
    hatch_lines(Edges, rising, 2000, Lines),
    Lines = [_,_,_|_],
    forall(( member((X1-Y1)-(X2-Y2), Lines),
             max(abs(X2-X1), abs(Y2-Y1)) > 20 ),
           ( X is (X1+X2)/2, Y is (Y1+Y2)/2, inside(X-Y, Edges) )).
test(ends_on_the_edges) :-
    rectangle(0, 0, 50 000, 20 000, R),
    region([R], Edges),
    hatch_lines(Edges, falling, 3000, Lines),
    forall(( member(A-B, Lines), member(X-Y, [A,B]) ),
           once(( memberchk(X, [0,50 000]) ; memberchk(Y, [0,20 000]) ))).
test(leans) :-
    rectangle(0, 0, 50 000, 20 000, R),
    region([R], Edges),
    hatch_lines(Edges, rising, 3000, Up),
    hatch_lines(Edges, falling, 3000, Down),
    forall(member((X1-Y1)-(X2-Y2), Up), abs(X1+Y1-X2-Y2) =< 1),
    forall(member((X1-Y1)-(X2-Y2), Down), abs(X1-Y1-X2+Y2) =< 1).
test(in_line) :-                        % two regions of one hatching
    rectangle(0, 0, 20 000, 20 000, R1),
    rectangle(33 000, 7000, 60 000, 20 000, R2),
    region([R1], E1),
    region([R2], E2),
    hatch_lines(E1, rising, 3000, L1),
    hatch_lines(E2, rising, 3000, L2),
    Step is round(3000*sqrt(2)),
    findall(C, ( ( member((X-Y)-_, L1) ; member((X-Y)-_, L2) ),
                 C is (X+Y) mod Step ), Cs),
    forall(member(C, Cs), ( min(C, Step-C) =< 1 )).
test(nothing, true(Lines == [])) :-
    hatch_lines([], rising, 3000, Lines).
test(smaller_than_spacing) :-
    rectangle(100, 100, 300, 300, R),
    region([R], Edges),
    hatch_lines(Edges, rising, 3000, Lines),
    length(Lines, N),
    N =< 1.

% Segments 1 to 8 of a section: which way, and how far apart in tenths of the
% spacing. A square of 60 mm, 3 mm apart.
segment_hatched(1, rising, 10).
segment_hatched(2, falling, 10).
segment_hatched(3, rising, 7).
segment_hatched(4, falling, 7).
segment_hatched(5, rising, 5).
segment_hatched(6, falling, 5).
segment_hatched(7, rising, 10).
segment_hatched(8, falling, 10).

test(segments_differ, forall(segment_hatched(I, Way, Tenths))) :-
    findall(S, ( between(1, 8, K), S is 10*K ), Segments),
    Segment is 10*I,
    rectangle(0, 0, 60 000, 60 000, R),
    region([R], Edges),
    hatching_strokes(hatching(3,Segments), [region(Segment,Edges)], Strokes),
    findall(Points, member(stroke(visible,hatching,Segment,[],Points,joint,
                                  joint), Strokes), Lines),
    same_length(Lines, Strokes),
    findall(C, ( member([X-Y,X1-Y1], Lines),
                 (   Way == rising
                 ->  abs(X+Y-X1-Y1) =< 1,
                     C is X+Y
                 ;   abs(X-Y-X1+Y1) =< 1,
                     C is X-Y
                 )
               ),
            Cs0),
    same_length(Cs0, Lines),
    sort(Cs0, Cs),
    Step is 300*Tenths*sqrt(2),
    forall(append(_, [C1,C2|_], Cs), abs(C2-C1-Step) =< 2).
% A twelfth of the root of the largest area, in half millimetres, 1.5 to 6.
test(spacing, [forall(member(Side-Spacing, [ 1-1.5, 24-2.0, 36-3.0, 60-5.0,
                                             300-6.0 ])),
               true(Found =:= Spacing)]) :-
    Small is Side/3,
    rectangle(0, 0, Side, Side, R1),
    rectangle(0, 0, Small, Small, R2),
    region([R1], E1),
    region([R2], E2),
    hatching([region(7,E2),region(3,E1),region(3,E2)], hatching(Found,[3,7])).

:- end_tests(hatching).
