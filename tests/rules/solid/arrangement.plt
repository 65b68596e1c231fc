/* Pieces that are kept, and what an edit makes stale:
rules/solid/arrangement.pl. */ :- use_module(library(plunit)).
:- use_module(rules(solid/arrangement)).
:- use_module(rules(solid/boolean)).
:- use_module(rules(penetration/entering)).
:- use_module(rules(penetration/joints), [merge_joints/2]).
:- use_module(rules(kernel),
              [ cut_set_open/2, cut_set_close/1, cut_find/1, cut_seal/1,
                cut_polygons_of/3, arrangement_open/5, arrangement_drop/1,
                arrangement_polygons/3, arrangement_free_polygons/3,
                arrangement_seal/1, arrangement_components/2,
                arrangement_select/3, solid_close/1, solid_write/2,
                tree_statistics/1
              ]).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

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
    facts_transaction(
        forall(v(S, V, X, Y, Z),
               ( retract_fact(v(S, V, X, Y, Z)),
                 X1 is X+By,
                 assert_fact(v(S, V, X1, Y, Z)) ))),
    forall(plane(S, P, A, B, C, D), retract_fact(plane(S, P, A, B, C, D))),
    complete_segments.

move_by(apart, 0.0625).
move_by(touching, By) :-
    random_member(By, [0.5, 1.0, -1.0, 0.25]).

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
    facts_transaction(
        forall(v(S, V, X, Y, Z),
               ( retract_fact(v(S, V, X, Y, Z)),
                 Z1 is Z+0.5,
                 assert_fact(v(S, V, X, Y, Z1)) ))).

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

%   What is dropped is made again, and is the same; trees go with it.

test(dropped, [true(Made-Trees-Same == [3,0,3]-0-true)]) :-
    in_new_world(( forall(member(X, [0,0.5,1.0]),
                          add_primitive(at([translate(X,0.1,0.2)],
                                           box(size(0.9,1,1))), _)),
                   complete_segments,
                   Leaves = [1,2,3],
                   numbers_made(Leaves, First, Numbers1),
                   numbers_made(Leaves, Second, _),
                   pieces_dropped,
                   tree_statistics(Statistics),
                   numbers_made(Leaves, Third, Numbers2) )),
    Made = [First,Second,Third],
    Trees = Statistics.trees,
    (   Numbers1 == Numbers2
    ->  Same = true
    ;   Same = false
    ).

numbers_made(Leaves, N, Counts) :-
    pieces_statistics(Before),
    with_arrangement(Leaves, [], counted_components(Counts)),
    pieces_statistics(After),
    N is After.made-Before.made.

counted_components(N, Arrangement) :-
    components(Arrangement, Components),
    length(Components, N).

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

%   Polygons whose lines meet nothing are entered and divided by one kernel. It
%   makes the pieces that the rules of entering.pl and then
%   arrangement_polygons/3 make; where a line meets another it makes none.

test(free_polygons, [true(Compared-Crossed == 14-true)]) :-
    findall(How, ( between(1, 24, Seed), pieces_alike(2, Seed, How) ), Hows),
    \+ member(other, Hows),
    aggregate_all(count, member(alike, Hows), Compared),
    (   between(1, 8, Seed),
        pieces_alike(10, Seed, crossed)
    ->  Crossed = true
    ;   Crossed = false
    ).

%   Nothing more is filled into what is sealed; what is not has no pieces.

test(sealed_twice, error(permission_error(fill, arrangement, _))) :-
    with_two_boxes([Set]>>( arrangement_open(Set, [1,2], [1,2], [],
                                     Arrangement),
                            cut_polygons_of(Set, [1,2], Polygons),
                            arrangement_free_polygons(Arrangement, Polygons,
                                                      0.0),
                            arrangement_seal(Arrangement),
                            arrangement_seal(Arrangement) )).
test(filled_late, error(permission_error(fill, arrangement, _))) :-
    with_two_boxes([Set]>>( arrangement_open(Set, [1,2], [1,2], [],
                                     Arrangement),
                            arrangement_seal(Arrangement),
                            arrangement_free_polygons(Arrangement, [], 0.0) )).
test(selected_early, error(permission_error(select, arrangement, _))) :-
    with_two_boxes([Set]>>( arrangement_open(Set, [1,2], [1,2], [],
                                     Arrangement),
                            arrangement_select([1-Arrangement], [], _) )).

with_two_boxes(Goal) :-
    in_new_world(( add_primitive(box(size(1,1,1)), _),
                   add_primitive(at([translate(0.5,0.25,0.3)],
                                    box(size(1,1,1))), _),
                   complete_segments,
                   setup_call_cleanup(
                       cut_set_open([1-2], Set),
                       ( cut_find(Set),
                         cut_seal(Set),
                         merge_joints(Set, straight),
                         call(Goal, Set) ),
                       cut_set_close(Set)) )).

%   pieces_alike(+N, +Seed, -How): of a scene of N octahedra: `alike`, `other`,
%   `crossed` (not all polygons are free) or `apart`.

pieces_alike(N, Seed, How) :-
    in_new_world(( set_random(seed(Seed)),
                   forall(between(1, N, _),
                          ( octahedron(Term),
                            add_primitive(Term, _) )),
                   complete_segments,
                   numlist(1, N, Ss),
                   findall(A-B, ( member(A, Ss), member(B, Ss), A < B ),
                           Pairs),
                   setup_call_cleanup(
                       cut_set_open(Pairs, Set),
                       alike_in(Set, Ss, How),
                       cut_set_close(Set)) )).

octahedron(at([rotate(axis(1,2,3),Degrees),translate(X,Y,Z)],
              polyhedron(points([[1,0,0],[0,1,0],[0,0,1],
                                 [-1,0,0],[0,-1,0],[0,0,-1]]),
                         faces([[1,2,3],[2,4,3],[4,5,3],[5,1,3],
                                [2,1,6],[4,2,6],[5,4,6],[1,5,6]])))) :-
    maplist(random_between(0, 1000), [A,B,C,D]),
    maplist(scaled, [A,B,C], [X,Y,Z]),
    Degrees is D/7.

alike_in(Set, Ss, How) :-
    cut_find(Set),
    cut_seal(Set),
    merge_joints(Set, straight),
    cut_polygons_of(Set, Ss, Polygons),
    stays_entered(Set),
    arrangement_open(Set, Ss, Ss, [], Fused),
    (   Polygons == []
    ->  How = apart
    ;   arrangement_free_polygons(Fused, Polygons, 0.0)
    ->  enter_polygons(is_list, Set, Polygons, Works),
        arrangement_open(Set, Ss, Ss, [], Ruled),
        arrangement_polygons(Ruled, Works, 0.0),
        close_works(Works),
        maplist(chosen(Ss), [Fused,Ruled], [Rows1,Rows2]),
        arrangement_drop(Ruled),
        (   Rows1 == Rows2
        ->  How = alike
        ;   How = other
        )
    ;   How = crossed
    ),
    arrangement_drop(Fused).

%   All pieces of an arrangement, as rows, with what they came from.

chosen(Ss, Arrangement, Rows-Sources-Components) :-
    arrangement_seal(Arrangement),
    findall(S-Arrangement, member(S, Ss), Pieces),
    arrangement_components(Pieces, Components),
    findall(C-1, member(component(C,_,_,_,_,_), Components), Senses),
    arrangement_select(Pieces, Senses, Solid),
    facts_snapshot(( solid_write(Solid, 100),
                     rows(Rows),
                     findall(P-S0-P0, from_p(100, P, S0, P0, _), Sources) )),
    solid_close(Solid).

:- end_tests(arrangement).
