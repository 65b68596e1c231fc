:- module(test_shells,
          [ shells/2,                   % +Primitives, :Goal
            one_segment/2,              % +Primitives, :Goal
            welded/0                    %
          ]).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).

/* Primitives as segments of their own, and as the shells of one. */

%   shells(+Primitives, :Goal): Goal holds in a new world where these
%   primitives are segments 1, 2, ...

:- meta_predicate
    shells(+, 0),
    one_segment(+, 0).

shells(Primitives, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Primitive, Primitives),
                      add_primitive(Primitive, _)),
               complete_segments,
               Goal )).

%   one_segment(+Primitives, :Goal): Goal holds in a new world where they are
%   the shells of segment 1.

one_segment(Primitives, Goal) :-
    shells(Primitives, findall(S-Vs-Es-Ps, shell_rows(S, Vs, Es, Ps), Shells)),
    new_world(World),
    in_world(World,
             ( assert_fact(segment(1, solid, shells)),
               foldl(shell_put, Shells, 0-0-0, _),
               complete_segments,
               Goal )).

shell_rows(S, Vs, Es, Ps) :-
    segment(S, _, _),
    findall(v(V,X,Y,Z), v(S, V, X, Y, Z), Vs),
    findall(e(E,A,B,T), e(S, E, A, B, T), Es),
    findall(p(P,List), p(S, P, List), Ps).

shell_put(_-Vs-Es-Ps, V0-E0-P0, V1-E1-P1) :-
    forall(member(v(V,X,Y,Z), Vs),
           ( V2 is V+V0, assert_fact(v(1, V2, X, Y, Z)) )),
    forall(member(e(E,A,B,T), Es),
           ( E2 is E+E0, A2 is A+V0, B2 is B+V0,
             assert_fact(e(1, E2, A2, B2, T)) )),
    forall(member(p(P,List), Ps),
           ( P2 is P+P0, maplist(plus(E0), List, List2),
             assert_fact(p(1, P2, List2)) )),
    aggregate_all(max(V), member(v(V,_,_,_), Vs), MaxV),
    aggregate_all(max(E), member(e(E,_,_,_), Es), MaxE),
    aggregate_all(max(P), member(p(P,_), Ps), MaxP),
    V1 is V0+MaxV,
    E1 is E0+MaxE,
    P1 is P0+MaxP.

%   welded: vertices of segment 1 in one place are one.

welded :-
    findall(p(X,Y,Z)-V, v(1, V, X, Y, Z), Vs0),
    msort(Vs0, Vs),
    findall(W-V, same(Vs, W, V), Renamed),
    facts_transaction(maplist(renamed, Renamed)),
    retractall_facts(t(1, _, _, _, _, _)),
    complete_segments.

same([At-V|Vs], W, V1) :-
    same(Vs, At, V, W, V1).

same([At-V2|Vs], At0, V0, W, V) :-
    (   At == At0
    ->  (   W = V2,
            V = V0
        ;   same(Vs, At0, V0, W, V)
        )
    ;   same(Vs, At, V2, W, V)
    ).

renamed(W-V) :-
    forall(( member(A-B, [W-_,_-W]), e(1, E, A, B, T) ),
           ( retractall_facts(e(1, E, _, _, _)),
             (   A == W
             ->  assert_fact(e(1, E, V, B, T))
             ;   assert_fact(e(1, E, A, V, T))
             ) )),
    forall(member(A-B-C, [W-_-_,_-W-_,_-_-W]),
           retractall_facts(t(1, _, _, A, B, C))),
    retractall_facts(v(1, W, _, _, _)).
