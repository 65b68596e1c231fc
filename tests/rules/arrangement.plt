/* Pieces that are kept, and what an edit makes stale: rules/arrangement.pl. */
:- use_module(library(plunit)).
:- use_module('../../rules/arrangement').
:- use_module('../../rules/boolean').
:- use_module('../../rules/model_file').
:- use_module('../../rules/store').
:- use_module('../../rules/triangulation').
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).

:- begin_tests(arrangement).

/* - - - scenes - - - */

%   scene(+Kind, +Seed): ten solids. Of kind `apart` in any places; of kind
%   `touching` boxes and prisms on a grid, all turned alike, so that many have
%   parts of faces in common but for rounding.

scene(Kind, Seed) :-
    set_random(seed(Seed)),
    forall(between(1, 10, I),
           ( random_solid(Kind, I, Term),
             add_primitive(Term, _) )),
    complete_segments.

random_solid(apart, I, at([rotate(axis(1,2,3),Degrees),translate(X,Y,Z)],
                          Solid)) :-
    maplist(random_between(0, 1000), [A,B,C,D]),
    maplist(scaled, [A,B,C], [X,Y,Z]),
    Degrees is D/7,
    nth1(K, [ box(size(1, 0.8, 0.9)), sphere(radius(0.7), facets(8), bands(4)),
              cylinder(radius(0.5), height(1.1), facets(7)) ], Solid),
    K =:= 1 + I mod 3,
    !.
random_solid(touching, _, at([translate(X,Y,Z),rotate(axis(3,1,2),37)],
                             box(size(A,B,C)))) :-
    maplist(random_between(0, 3), [X,Y,Z]),
    maplist(random_between(1, 2), [A,B,C]).

scaled(I, X) :-
    X is I/450.

expression(Expression) :-
    numlist(1, 7, Added),
    Expression = difference([union(Added),8,intersection([9,10])]).

%   rows(-Rows): what the boundary looks like, whatever the numbers of its rows.

rows(Ps-Edges) :-
    findall(p(X,Y,Z), v(100, _, X, Y, Z), Ps0),
    sort(Ps0, Ps),
    findall(e(A,B,C,D,E,F),
            ( e(100, _, V1, V2, _),
              v(100, V1, A, B, C),
              v(100, V2, D, E, F) ),
            Edges0),
    msort(Edges0, Edges).

evaluated(Rows) :-
    expression(Expression),
    facts_snapshot(( boolean(Expression, 100), rows(Rows) )).

%   The facts of this world in a new one, which keeps no pieces.

afresh(Rows) :-
    findall(Fact, of_model(Fact), Facts),
    new_world(World),
    in_world(World,
             ( maplist(assert_fact, Facts),
               evaluated(Rows) )).

of_model(segment(S, K, N)) :- segment(S, K, N).
of_model(v(S, V, X, Y, Z)) :- v(S, V, X, Y, Z).
of_model(e(S, E, A, B, T)) :- e(S, E, A, B, T).
of_model(p(S, P, Es)) :- p(S, P, Es).
of_model(plane(S, P, A, B, C, D)) :- plane(S, P, A, B, C, D).
of_model(t(S, P, T, A, B, C)) :- t(S, P, T, A, B, C).

/* - - - edits - - - */

edit(Kind) :-
    random_between(1, 10, S),
    move_by(Kind, By),
    forall(v(S, V, X, Y, Z),
           ( retract_fact(v(S, V, X, Y, Z)),
             X1 is X+By,
             assert_fact(v(S, V, X1, Y, Z)) )),
    forall(plane(S, P, A, B, C, D), retract_fact(plane(S, P, A, B, C, D))),
    complete_segments.

move_by(apart, 0.0625).
move_by(touching, By) :-
    random_member(By, [0.5, 1.0, -1.0, 0.25]).

in_new_world(Goal) :-
    new_world(World),
    in_world(World, Goal).

test(edited_as_if_new, [forall(( member(Kind, [apart,touching]),
                                 between(1, 6, Seed) ))]) :-
    in_new_world(( scene(Kind, Seed),
                   evaluated(_),
                   forall(between(1, 5, _),
                          ( edit(Kind),
                            evaluated(Rows),
                            afresh(Rows1),
                            assertion(Rows == Rows1) )) )).

%   A row of boxes each of which meets the next: those near an edit are cut
%   again, the others are not; and undo finds all of them.

test(stale_is_what_is_near, [true(Made == [20,2,0,0])]) :-
    in_new_world(( forall(between(0, 19, I),
                          ( X is 0.9*I,
                            add_primitive(at([translate(X,0,0)],
                                             box(size(1,1,1))), _) )),
                   complete_segments,
                   numlist(1, 20, Leaves),
                   made(Leaves, First),
                   facts_transaction(lifted(20)),
                   made(Leaves, Second),
                   made(Leaves, Third),
                   facts_undo,
                   made(Leaves, Fourth) )),
    Made = [First,Second,Third,Fourth].

lifted(S) :-
    forall(v(S, V, X, Y, Z),
           ( retract_fact(v(S, V, X, Y, Z)),
             Z1 is Z+0.5,
             assert_fact(v(S, V, X, Y, Z1)) )).

%   made(+Leaves, -N): of how many the pieces had to be made.

made(Leaves, N) :-
    pieces_statistics(Before),
    with_arrangement(Leaves, [], components_there),
    pieces_statistics(After),
    N is After.made-Before.made.

components_there(Arrangement) :-
    components(Arrangement, [_|_]).

%   Pieces are forgotten with segments that are there no more.

test(forgotten_with_the_segment, [true(Kept == [2,2,2])]) :-
    in_new_world(findall(N, ( between(1, 3, I), kept_of_two(I, N) ), Kept)).

kept_of_two(I, N) :-
    add_primitive(box(size(1,1,1)), A),
    add_primitive(at([translate(0.5,0.5,I)], box(size(1,1,2))), B),
    complete_segments,
    with_arrangement([A,B], [], components_there),
    pieces_statistics(Statistics),
    N = Statistics.leaves,
    maplist(segment_dropped, [A,B]).

segment_dropped(S) :-
    retractall_facts(t(S, _, _, _, _, _)),
    retractall_facts(plane(S, _, _, _, _, _)),
    retractall_facts(p(S, _, _)),
    retractall_facts(e(S, _, _, _, _)),
    retractall_facts(v(S, _, _, _, _)),
    retractall_facts(segment(S, _, _)).

%   Pieces look into their world, and the world keeps them: it ends all the
%   same when nobody has it, and they with it.

test(world_ends, [true(Left =< 2)]) :-
    forall(between(1, 6, _),
           in_new_world(( scene(apart, 1), evaluated(_) ))),
    forall(between(1, 4, _),
           ( garbage_collect,
             garbage_collect_atoms )),
    aggregate_all(count, current_blob(_, arrangement), Left).

%   Two threads that make stale, and use, the same pieces.

test(threads, [ condition(current_prolog_flag(threads, true)),
                true(Ends == [true,true]) ]) :-
    in_new_world(( scene(apart, 2),
                   current_world(World),
                   findall(Id,
                           ( member(T, [1.0e-9,1.0e-8]),
                             thread_create(in_world(World, asked_often(T)),
                                           Id) ),
                           Ids),
                   maplist(thread_join, Ids, Ends) )).

asked_often(Tolerance) :-
    numlist(1, 10, Leaves),
    forall(between(1, 12, I),
           ( T is Tolerance*(1+I mod 3),
             with_arrangement(Leaves, [tolerance(T)], components_there) )).

:- end_tests(arrangement).
