:- module(test_scaled, []).
:- use_module(library(plunit)).
:- use_module(rules(sanggwan)).

/* The same model in other units: times a power of two, which rounds nothing,
   everything is times that power, to the last bit; times a power of ten, as
   many rows of each kind. So no length is compared with a number of the
   program. */

% Two parts of a model, in the place of which others of the same size stand.
parts(boxes, [box(size(4,3,2)), at([translate(1,1,0.5)], box(size(4,3,2)))]).
parts(turned, [box(size(4,4,4)),
               at([rotate(axis(1,2,3),40),translate(1,0.5,0.25)],
                  box(size(3,3,5)))]).
parts(pipe, [cylinder(radius(2), height(6), facets(12)),
             at([rotate(y,90),translate(-3,0.25,3)],
                cylinder(radius(1), height(6), facets(9)))]).
parts(touching, [box(size(4,4,2)),
                 at([translate(0,0,2)], cylinder(radius(1), height(2),
                                                 facets(8)))]).
parts(ball, [sphere(radius(2), facets(10), bands(6)),
             at([translate(0.5,0.25,1)], box(size(2,2,4)))]).

% In a new world of the parts times Factor.
:- meta_predicate in_scaled(+, +, 0).
in_scaled(Name, Factor, Goal) :-
    parts(Name, Parts),
    new_world(World),
    in_world(World,
             ( forall(member(Part, Parts),
                      add_primitive(at([scale(Factor)], Part), _)),
               complete_segments,
               call(Goal) )).

places(S, Factor, Places) :-
    findall(V-[X,Y,Z],
            ( v(S, V, X0, Y0, Z0),
              X is X0/Factor, Y is Y0/Factor, Z is Z0/Factor ),
            Places0),
    sort(Places0, Places).

polygons(S, Polygons) :-
    findall(P-Vs,
            ( p(S, P, Es),
              findall(A, ( member(E, Es), e(S, E, A, _, _) ), Vs) ),
            Polygons0),
    sort(Polygons0, Polygons).

operated(Name, Operation, Factor, Places/Polygons) :-
    in_scaled(Name, Factor,
              ( Expression =.. [Operation,[1,2]],
                boolean(Expression, 3),
                places(3, Factor, Places),
                polygons(3, Polygons) )).

penetrated(Name, Factor, Lines/Places) :-
    in_scaled(Name, Factor,
              ( penetrate,
                findall(line(L,S1,P1,A1,B1,S2,P2,A2,B2),
                        line(L,S1,P1,A1,B1,S2,P2,A2,B2), Lines),
                places(1, Factor, Places) )).

pictured(Name, Factor, Drawn/Points) :-
    in_scaled(Name, Factor,
              ( penetrate,
                picture,
                findall(drawn(S,E,From,To,Visibility,Role),
                        drawn(_,S,E,From,To,Visibility,Role), Drawn0),
                sort(Drawn0, Drawn),
                findall(S-V-[X,Y],
                        ( screen(S,V,X0,Y0,_),
                          X is X0/Factor, Y is Y0/Factor ),
                        Points0),
                sort(Points0, Points) )).

developed(Name, Factor, Places) :-
    in_scaled(Name, Factor,
              ( develop(1, [], D),
                places(D, Factor, Places) )).

same(A, B, _) :-
    A == B,
    !.
same(A, B, What) :-
    A = [_|_],
    B = [_|_],
    length(A, N),
    length(B, M),
    (   nth1(I, A, X),
        nth1(I, B, Y),
        X \== Y
    ->  true
    ;   X = none,
        Y = none
    ),
    format(user_error, '~w: ~d and ~d, first ~q, ~q~n', [What,N,M,X,Y]),
    fail.
same(A/B, C/D, What) :-
    same(A, C, What),
    same(B, D, What).

power(K) :-
    member(K, [-60,-25,25,60]).

counts(A/B, N/M) :-
    !,
    length(A, N),
    length(B, M).
counts(A, N) :-
    length(A, N).

:- begin_tests(scaled).

test(boolean, forall(( parts(Name, _),
                       member(Operation, [union,difference,intersection]),
                       power(K) ))) :-
    Factor is 2.0**K,
    operated(Name, Operation, 1.0, Here),
    operated(Name, Operation, Factor, There),
    same(Here, There, Name-Operation-K).
test(penetration, forall(( parts(Name, _), power(K) ))) :-
    Factor is 2.0**K,
    penetrated(Name, 1.0, Here),
    penetrated(Name, Factor, There),
    same(Here, There, Name-K).
test(picture, forall(( parts(Name, _), power(K) ))) :-
    Factor is 2.0**K,
    pictured(Name, 1.0, Here),
    pictured(Name, Factor, There),
    same(Here, There, Name-K).
test(development, forall(( parts(Name, _), power(K) ))) :-
    Factor is 2.0**K,
    developed(Name, 1.0, Here),
    developed(Name, Factor, There),
    same(Here, There, Name-K).
% And there is something to compare.
test(not_empty, forall(parts(Name, _))) :-
    operated(Name, union, 1.0, [_|_]/[_|_]),
    operated(Name, difference, 1.0, [_|_]/[_|_]),
    penetrated(Name, 1.0, Lines/_),
    ( Name == touching -> true ; Lines = [_,_,_|_] ),
    pictured(Name, 1.0, [_|_]/[_|_]),
    developed(Name, 1.0, [_|_]).
test(tens, forall(( parts(Name, _), member(K, [-6,-3,3,6]) ))) :-
    Factor is 10.0**K,
    operated(Name, union, 1.0, A),
    operated(Name, union, Factor, B),
    penetrated(Name, 1.0, C),
    penetrated(Name, Factor, D),
    pictured(Name, 1.0, E),
    pictured(Name, Factor, F),
    maplist(counts, [A,C,E], Counts),
    maplist(counts, [B,D,F], Counts).

:- end_tests(scaled).
