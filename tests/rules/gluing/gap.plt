/* How far faces are apart that were not glued: against distances known by
   construction, in place and turned; and against a rule that compares each
   two pieces.
   covers: triangle_corners */
:- module(test_gap, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(gluing/gap)).
:- use_module(rules(kernel), [polygon_gap/4, segment_gaps/3]).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(store)).
:- use_module(tests(oracle/gap)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   apart(Name, Terms, Gap): segments 1 and 2, and how far they are apart: a
%   corner over a face, edges that pass each other, a corner beside a corner,
%   faces that look at each other, a face beside an edge, a wire over a face,
%   its end over one.

apart(corner, [box(size(2,2,2)),
               at([rotate(axis(1,-1,0),54.735610317245346),
                   translate(0,0,4.5)], box(size(1,1,1)))], Gap) :-
    Gap is 2.5-(sqrt(3)/2-0.5).
apart(edges, [at([rotate(x,45)], box(size(9,1,1))),
              at([rotate(y,45),translate(0,0,2)], box(size(1,9,1)))], _).
apart(corners, [box(size(1,1,1)),at([translate(2,3,3)], box(size(1,1,1)))],
      3.0).
apart(faces, [box(size(2,2,1)),at([translate(0.25,0.5,1.125)],
                                  box(size(2,2,1)))], 0.125).
apart(wire, [box(size(2,2,1)),line(from(-9,0.1,1.5), to(9,0.1,1.5))], 0.5).
apart(end, [box(size(2,2,1)),line(from(0.5,0.1,1.25), to(0.5,0.1,9))], 0.25).
apart(wires, [line(from(-9,0,0), to(9,0,0)),line(from(0,-9,3), to(0,9,3))],
      3.0).

gap(Terms, Steps, Reach, Misses) :-
    in_new_world(( forall(member(Term, Terms),
                          add_primitive(at(Steps, Term), _)),
                   complete_segments,
                   near_misses([1-2], Reach, Misses) )).

turned(Seed, [rotate(axis(X,Y,Z),Angle),translate(A,B,C)]) :-
    set_random(seed(Seed)),
    maplist(random(-3.0, 3.0), [X,Y,Z,A,B,C]),
    random(0.0, 360.0, Angle).

:- begin_tests(gap).

test(known, [ forall(( apart(Name, Terms, Gap),
                       member(Name, [corners,faces,wire,end,wires]),
                       member(Steps, [[],turn(1),turn(2)]) )) ]) :-
    steps(Steps, Placing),
    gap(Terms, Placing, 5, [miss(1-_,2-_,Found,End1-End2)]),
    abs(Found-Gap) < 1.0e-12,
    between_ends(End1, End2, Between),
    abs(Found-Between) < 1.0e-12.

steps(turn(Seed), Steps) :-
    !,
    turned(Seed, Steps).
steps(Steps, Steps).

between_ends(p(X1,Y1,Z1), p(X2,Y2,Z2), D) :-
    D is sqrt((X1-X2)**2+(Y1-Y2)**2+(Z1-Z2)**2).

%   Edges that pass each other, neither of them at an end.

test(edges, true(abs(Found-Gap) < 1.0e-12)) :-
    Terms = [at([rotate(x,45)], box(size(9,1,1))),
             at([rotate(y,45),translate(0,0,2)], box(size(1,9,1)))],
    gap(Terms, [], 5, [miss(_,_,Found,_)]),
    lowest_highest(Terms, Low2, High1),
    Gap is Low2-High1.

lowest_highest(Terms, Low2, High1) :-
    in_new_world(( forall(member(Term, Terms), add_primitive(Term, _)),
                   findall(Z, v(1, _, _, _, Z), Zs1),
                   findall(Z, v(2, _, _, _, Z), Zs2) )),
    max_list(Zs1, High1),
    min_list(Zs2, Low2).

%   Too far, or in touch: none.

test(far, Misses == []) :-
    gap([box(size(1,1,1)),at([translate(2,3,3)], box(size(1,1,1)))], [], 2.9,
        Misses).
test(touching, Misses == []) :-
    gap([box(size(1,1,1)),at([translate(0,0,1)], box(size(1,1,1)))], [], 2.9,
        Misses).
test(polygons, Gap-End1-End2 == 0.125 - 1.0 - 1.125) :-
    apart(faces, Terms, _),
    in_new_world(( forall(member(Term, Terms), add_primitive(Term, _)),
                   complete_segments,
                   top(1, P1, 1.0),
                   top(2, P2, 1.125),
                   polygon_gap(1-P1, 2-P2, Gap, p(_,_,End1)-p(_,_,End2)),
                   \+ polygon_gap(1-P1, 2-99, _, _) )).

top(S, P, Z) :-
    p(S, P, Es),
    forall(member(E, Es), ( e(S, E, V, _, _), v(S, V, _, _, Z) )),
    !.

%   Random solids, sheets and curves, at all distances: as the rule has them. A
%   pair is there if it is within reach, and all pairs are asked at once.

test(random, [ forall(between(1, 6, Seed)), Wrong == [] ]) :-
    set_random(seed(Seed)),
    length(Terms, 7),
    maplist(random_term, Terms),
    findall(I-K, ( between(1, 6, I), between(I, 6, K0), K is K0+1 ), Pairs),
    in_new_world(( forall(member(Term, Terms), add_primitive(Term, _)),
                   complete_segments,
                   segment_gaps(Pairs, 4, Gaps),
                   findall(Pair, ( member(Pair, Pairs),
                                   \+ as_the_rule(Pair, 4, Gaps) ), Wrong) )).

as_the_rule(S1-S2, Reach, Gaps) :-
    segments_gap(S1, S2, Gap),
    (   memberchk(miss(S1-_,S2-_,Found,End1-End2), Gaps)
    ->  abs(Found-Gap) < 1.0e-12,
        Found =< Reach,
        between_ends(End1, End2, Between),
        abs(Found-Between) < 1.0e-9
    ;   Gap > Reach-1.0e-12
    ).

random_term(Term) :-
    maplist(random(-4.0, 4.0), [X,Y,Z,A,B,C,U,V,W]),
    random(0.0, 360.0, Angle),
    random_member(Shape, [ box(size(1,2,0.5)),
                           cylinder(radius(0.7), height(2), facets(5)),
                           rectangle(size(2,1)),
                           line(from(X,Y,Z), to(U,V,W)) ]),
    Term = at([rotate(axis(A,B,C),Angle),translate(X,Y,Z)], Shape).

%   A wall of many facets before another one is found at once, however far
%   they reach; of those that are as near the first.

test(large, Gap-P == 0.25-Top) :-
    in_new_world(( add_primitive(cylinder(radius(9), height(1), facets(512)),
                                 _),
                   add_primitive(at([translate(0,0,1.25)],
                                    cylinder(radius(9), height(1),
                                             facets(512))), _),
                   complete_segments,
                   top(1, Top, 1.0),
                   call_with_inference_limit(
                       near_misses([1-2], 5.0, [miss(1-P,2-_,Gap,_)]),
                       10000, !) )).

%   Of balls in each other only those beside each other are measured: all pairs
%   have the same gaps, and take not much longer, though they are 40 times as
%   many. With itself each is in a pair, too.

test(in_each_other, true(Most < 10)) :-
    N = 80,
    in_new_world(( forall(between(1, N, I),
                          ( R is 1+I/N,
                            add_primitive(sphere(radius(R), facets(8)), _) )),
                   complete_segments,
                   findall(I-J, ( between(1, N, I), between(I, N, J) ), All),
                   include(beside, All, Few),
                   gaps_in(Few, N, Gaps, T1),
                   gaps_in(All, N, Gaps, T2) )),
    length(Gaps, Length),
    assertion(Length =:= 2*N-1),
    Most is T2/max(T1, 0.005).

beside(I-J) :-
    J-I =< 1.

%   The least time of three.

gaps_in(Pairs, N, Gaps, Time) :-
    Reach is 1.2/N,
    findall(T, ( between(1, 3, _),
                 statistics(process_cputime, T0),
                 segment_gaps(Pairs, Reach, _),
                 statistics(process_cputime, T1),
                 T is T1-T0 ), Ts),
    min_list(Ts, Time),
    segment_gaps(Pairs, Reach, Gaps).

:- end_tests(gap).
