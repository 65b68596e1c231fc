:- module(test_twins, []).
% covers: cut_coincident
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(yall)).
:- use_module(rules(penetration/penetration), [penetrate/0]).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(solid/arrangement)).
:- use_module(rules(store)).
:- use_module(tests('rules/boolean_case')).
:- use_module(tests('rules/polyhedron')).
:- use_module(tests('rules/sample')).
:- use_module(tests('rules/solid/grown')).

/* Segments that have triangles in common, all or some: a Boolean does not cut
   them there, and comes to the same. */

ball(N, Points, Faces, Volume) :-
    once(grown(ball, N, [shell(Points, Faces)], Volume)).

:- meta_predicate in_balls(+, +, 0).

%   in_balls(+N, +Second, :Goal): segment 1 is a ball, 2 is Second of it, which
%   is moved(Seed) or turned.

in_balls(N, Second, Goal) :-
    ball(N, Points, Faces, _),
    second(Second, Points, Faces, Points2, Faces2),
    new_world(World),
    in_world(World,
             ( polyhedron(1, solid, Points, Faces),
               polyhedron(2, solid, Points2, Faces2),
               complete_segments,
               Goal )).

second(same, Points, Faces, Points, Faces).
%   Some vertices in or out.
second(moved(Seed), Points0, Faces, Points, Faces) :-
    set_random(seed(Seed)),
    Odds is 0.02*(1+Seed mod 6),
    maplist(displaced(Odds), Points0, Points).
%   A hollow of this form in a cube.
second(hollow, Points0, Faces0, Points, Faces) :-
    prism_shell(Outer),
    maplist(reverse, Faces0, Faces1),
    shells_solid([shell(Points0, Faces1),Outer], Points, Faces).
%   Others begin with another corner, in another order.
second(shuffled, Points0, Faces0, Points, Faces) :-
    length(Points0, N),
    reverse(Points0, Points),
    maplist(maplist({N}/[V,W]>>( W is N+1-V )), Faces0, Faces1),
    maplist([[A,B,C],[B,C,A]]>>true, Faces1, Faces2),
    reverse(Faces2, Faces).

displaced(Odds, p(X,Y,Z), P) :-
    (   maybe(Odds)
    ->  random(0.8, 1.2, F),
        X1 is F*X, Y1 is F*Y, Z1 is F*Z,
        P = p(X1,Y1,Z1)
    ;   P = p(X,Y,Z)
    ).

prism_shell(shell([p(-2,-2,-2),p(2,-2,-2),p(2,2,-2),p(-2,2,-2),
                   p(-2,-2,2),p(2,-2,2),p(2,2,2),p(-2,2,2)],
                  [[1,4,3,2],[5,6,7,8],[1,2,6,5],[2,3,7,6],[3,4,8,7],
                   [4,1,5,8]])).

%   components_of(-N): of both segments.

components_of(N) :-
    with_arrangement([1,2], [],
                     [Arrangement]>>( components(Arrangement, Components),
                                      length(Components, N0),
                                      nb_setval(test_twins, N0) )),
    nb_getval(test_twins, N).

%   volumes(+Expressions, -Volumes): of good results; an empty one has none.

volumes(Expressions, Volumes) :-
    maplist(volume, Expressions, Volumes).

volume(Expression, Volume) :-
    result(Expression, S),
    (   p(S, _, _)
    ->  measured([S], [Measures]),
        (   Measures.good == yes,
            Measures.closed == yes
        ->  Volume = Measures.volume
        ;   format("~p: ~p~n", [Expression,Measures]),
            Volume = none
        )
    ;   Volume = 0
    ).

near(A, B) :-
    abs(A-B) =< 1.0e-9*(1+abs(B)).

case(Seed) :-
    few(12, 60, N),
    between(1, N, Seed).

:- begin_tests(twins).

test(same, [forall(member(Second, [same,shuffled])),
            true(Faults == [])]) :-
    ball(400, _, _, Volume),
    in_balls(400, Second,
             ( components_of(N),
               volumes([union([1,2]),intersection([1,2]),difference([1,2]),
                        difference([2,1])],
                       [U,I,D,E]) )),
    findall(Fault,
            ( member(Fault-Goal,
                     [ components(N)-(N =:= 2),
                       union(U)-near(U, Volume),
                       intersection(I)-near(I, Volume),
                       difference(D)-(D =:= 0),
                       difference(E)-(E =:= 0) ]),
              \+ Goal ),
            Faults).
%   All of the 384 triangles are touched from outside.
test(hollow, Volumes == [true,0]) :-
    in_balls(400, hollow,
             ( volumes([union([1,2]),intersection([1,2])], [U,I]),
               components_of(N) )),
    (   near(U, 64), N =< 3
    ->  Volumes = [true,I]
    ;   Volumes = [U-N,I]
    ).
test(some, [forall(case(Seed)), true(Faults == [])]) :-
    in_balls(300, moved(Seed),
             ( components_of(N),
               measured([1,2], [M1,M2]),
               volumes([union([1,2]),intersection([1,2]),difference([1,2]),
                        difference([2,1])],
                       [U,I,D,E]) )),
    A = M1.volume,
    B = M2.volume,
    findall(Fault,
            ( member(Fault-Goal,
                     [ components(N)-(N < 500),
                       both(U,I,A,B)-near(U+I, A+B),
                       first(D,I,A)-near(D+I, A),
                       second(E,I,B)-near(E+I, B) ]),
              \+ Goal ),
            Faults).
%   A penetration has the lines all the same: 432 edges, less the diagonals of
%   126 quadrangles.
test(lines, N == 306) :-
    in_balls(300, same,
             ( penetrate,
               findall(x, line(_, _, _, _, _, _, _, _, _), Lines) )),
    length(Lines, N).

:- end_tests(twins).
