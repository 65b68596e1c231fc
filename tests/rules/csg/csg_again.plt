/* What is evaluated again after a change, and what is not. */
:- module(test_csg_again, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(rules(solid/boolean), [boolean/2]).
:- use_module(rules(csg/csg)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(csg/csg_roots)).
:- use_module(rules(model/model)).
:- use_module(rules(store)).
:- use_module(rules(command/verbs), [draw/2]).
:- use_module(tests('rules/csg/csg_tree'),
              [helpers/1, near/2, statistics/2, volume/2, with_tree/2]).

:- begin_tests(csg_again).

%   A tree of three levels: 5 and 6 share the leaf 2.

tree([ box(size(4,4,4)), at([translate(2,0,0)], cylinder(radius(1), height(9),
                                                         facets(8))),
       box(size(1,1,9)), at([translate(0,9,0)], sphere(radius(2), facets(8))),
       difference([1,2]), union([4,3]), difference([5,3]) ]).

test(nothing_twice, [E1-R1, E2-R2] == [0-2, 1-1]) :-
    tree(Terms),
    with_tree(Terms,
              ( evaluate, statistics(E1, R1),
                evaluate(5), evaluate(5), statistics(E2, R2) )).
test(leaf_edited, [E-R, Stale] == [1-1, [6]]) :-
    tree(Terms),
    with_tree(Terms,
              ( evaluate(5),
                once(v(4, 1, X, Y, Z)),
                Z1 is Z+0.125,
                facts_transaction(( retract_fact(v(4, 1, X, Y, Z)),
                                    assert_fact(v(4, 1, X, Y, Z1)) )),
                stale(Stale),
                csg_statistics_reset,
                evaluate,
                statistics(E, R) )).

%   What is said of segments alone, in facts, is a tree as in a file.

test(leaves_of_facts, V == 6.0) :-
    with_tree([ box(size(2,2,2)) ],
              ( facts_transaction(
                    ( assert_fact(segment(7, solid, box(size(1,1,2)))),
                      assert_fact(segment(8, solid, difference([1,7]))) )),
                evaluate,
                volume(8, V) )).

%   stale(Ss): nodes that had a boundary which is not right now.

stale(Ss) :-
    findall(S, ( node(S, Operation, _, _), Operation \== leaf,
                 once(p(S, _, _)), \+ evaluated(S) ),
            Ss0),
    sort(Ss0, Ss).

test(placement_edited, [Stale, V1, V2] == [[3,4,5], 6.0, 4.0]) :-
    with_tree([ box(size(2,2,2)), box(size(9,9,9)), at([translate(1,0,1)], 1),
                difference([1,3]), union([4]), difference([2,1]) ],
              ( evaluate(4), volume(4, V1),
                retract_fact(segment(3, _, _)),
                assert_fact(segment(3, solid, at([translate(1,0,0)], 1))),
                stale(Stale),
                evaluate(4), volume(4, V2) )).
test(undo, [E-R, V1, V2] == [0-1, 4.0, 4.0]) :-
    with_tree([ box(size(2,2,2)), at([translate(1,0,0)], box(size(2,2,2))),
                difference([1,2]) ],
              ( volume(3, V1),
                facts_transaction(
                    ( retractall_facts(segment(3, _, _)),
                      assert_fact(segment(3, solid, union([1,2]))) )),
                evaluate,
                facts_undo,
                facts_undo,
                csg_statistics_reset,
                evaluate,
                statistics(E, R),
                volume(3, V2) )).
test(rolled_back, V == 4.0) :-
    with_tree([ box(size(2,2,2)), at([translate(1,0,0)], box(size(2,2,2))),
                difference([1,2]) ],
              ( \+ facts_transaction(
                       ( retractall_facts(segment(3, _, _)),
                         assert_fact(segment(3, solid, union([1,2]))),
                         evaluate,
                         fail )),
                evaluated(3),
                volume(3, V) )).
test(own_rows_edited, V == 4.0) :-
    with_tree([ box(size(2,2,2)), at([translate(1,0,0)], box(size(2,2,2))),
                difference([1,2]) ],
              ( once(retract_fact(p(3, _, _))),
                evaluate,
                volume(3, V) )).
test(equal_placements_are_one_instance, [N1, N2] == [1, 0]) :-
    with_tree([ box(size(1,1,1)), box(size(1,1,2)),
                at([translate(3,0,0)], union([1,2])),
                at([translate(1,0,0), translate(2,0,0)], difference([1,2])),
                at([translate(3,0,0)], 2) ],
              ( helpers(N1),
                retractall_facts(segment(3, _, _)),
                retractall_facts(segment(4, _, _)),
                evaluate,
                helpers(N2) )).
test(no_placement_is_the_leaf, N == 0) :-
    with_tree([ box(size(1,1,1)), box(size(1,1,2)),
                at([translate(3,0,0), translate(-3,0,0)], union([1,2])) ],
              helpers(N)).
test(edited_leaf_moves_its_instances, [V1, V2] == [8.0, 12.0]) :-
    with_tree([ box(size(1,1,1)), at([scale(2)], union([1])) ],
              ( volume(2, V1),
                forall(( v(1, V, X, Y, Z), Z > 0.5 ),
                       facts_transaction(
                           ( retract_fact(v(1, V, X, Y, Z)),
                             assert_fact(v(1, V, X, Y, 1.5)) ))),
                evaluate,
                volume(2, V2) )).
test(leaves_stay, Same == true) :-
    Terms = [ box(size(2,2,2)), at([translate(1,0,0)], box(size(2,2,2))) ],
    with_tree(Terms, rows(Rows1)),
    append(Terms, [union([1,2])], Terms3),
    with_tree(Terms3, rows(Rows2)),
    (   Rows1 == Rows2
    ->  Same = true
    ;   Same = false
    ).

rows(Rows) :-
    findall(Row, ( member(S, [1,2]),
                   member(Row, [ v(S, _, _, _, _), e(S, _, _, _, _),
                                 p(S, _, _), t(S, _, _, _, _, _) ]),
                   call(Row) ),
            Rows).

test(penetrated_leaves_count_as_they_were, V == 12.0) :-
    with_tree([ box(size(2,2,2)), at([translate(1,0,0)], box(size(2,2,2))),
                at([translate(0,0,5)], union([1,2])) ],
              ( penetrate([1-2]),
                evaluate,
                volume(3, V) )).
test(cut_roots_are_made_anew, [L, V] == [0, 4.0]) :-
    with_tree([ box(size(2,2,2)), at([translate(1,0,0)], box(size(2,2,2))),
                difference([1,2]), box(size(9,9,1)) ],
              ( penetrate,
                line(_, 3, _, _, _, 4, _, _, _),
                !,
                evaluate,
                aggregate_all(count, line(_, _, _, _, _, _, _, _, _), L),
                volume(3, V) )).
test(operands_are_not_cut, Pairs == [3-4]) :-
    with_tree([ box(size(2,2,2)), at([translate(1,0,0)], box(size(2,2,2))),
                difference([1,2]), box(size(9,9,1)) ],
              ( penetrate,
                findall(A-B, line(_, A, _, _, _, B, _, _, _), Pairs0),
                sort(Pairs0, Pairs) )).
test(roots_alone, Segments == [3-solid-lens]) :-
    with_tree([ box(size(2,2,2)), at([translate(1,0,0)], box(size(2,2,2))),
                at([translate(7,7,7)], named(lens, intersection([1,2]))) ],
              ( roots_alone,
                findall(S-K-T, segment(S, K, T), Segments),
                findall(What-Origin, origin(3, What, Origin), Origins),
                Origins == [surfaces-on([],[run(1,6,0)])], % named faces
                \+ ( origin(S2, _, _), S2 =\= 3 ),
                \+ from_p(_, _, _, _, _),
                \+ ( v(S1, _, _, _, _), S1 =\= 3 ),
                volume(3, V),
                near(V, 4.0) )).
test(operands_meet_in_penetration_lines,
     Roles-Lines == [crease,outline,penetration]-0) :-
    with_tree([ box(size(4,4,1)), cylinder(radius(1), height(3)),
                union([1,2]) ],
              ( setup_call_cleanup(
                    tmp_file_stream(File, Stream, [extension(svg)]),
                    ( close(Stream), draw(File, [view(300,60)]) ),
                    delete_file(File)),
                findall(Role, ( drawn(_, S, _, _, _, visible, Role), S == 3 ),
                        Roles0),
                aggregate_all(count, line(_, _, _, _, _, _, _, _, _), Lines) )),
    sort(Roles0, Roles).
test(written_and_read, V1 == V2) :-
    tree(Terms),
    tmp_file_stream(File, Stream, [extension(pl)]),
    close(Stream),
    with_tree(Terms, ( save_model(File), volume(7, V1) )),
    new_world(World),
    in_world(World,
             ( load_model(File),
               node(7, difference, [5,3], []),
               volume(7, V2) )),
    delete_file(File).
test(same_as_boolean, true(near(V1, V2))) :-
    tree(Terms),
    with_tree(Terms,
              ( volume(7, V1),
                boolean(difference([difference([1,2]),3]), 100),
                volume(100, V2) )).

test(primitive_edited, [V1, V2, V3] == [4.0, 6.0, 7.0]) :-
    with_tree([ box(size(2,2,2)), at([translate(1,0,0)], box(size(2,2,2))),
                difference([1,2]) ],
              ( volume(3, V1),
                evaluated(3),
                term_changed(2, at([translate(1.5,0,0)], box(size(2,2,2)))),
                \+ evaluated(3),
                evaluate,
                volume(3, V2),
                term_changed(2, at([translate(0,0,1)], box(size(1,1,1)))),
                evaluate,
                volume(3, V3) )).
test(primitive_edited_and_rows_edited, V == 4.0) :-
    with_tree([ box(size(2,2,2)), at([translate(1,0,0)], box(size(2,2,2))),
                difference([1,2]) ],
              ( facts_transaction(( once(retract_fact(v(2, 1, X, Y, Z))),
                                    assert_fact(v(2, 1, X, Y, Z)) )),
                term_changed(2, at([translate(1.5,0,0)], box(size(2,2,2)))),
                evaluate,
                volume(3, V) )).
test(edited_in_steps_undone, [V1, V2, E] == [6.0, 4.0, 0]) :-
    with_tree([ box(size(2,2,2)), at([translate(1,0,0)], box(size(2,2,2))),
                difference([1,2]) ],
              ( facts_transaction(
                    ( term_changed(2, at([translate(1.5,0,0)],
                                         box(size(2,2,2)))),
                      evaluate )),
                volume(3, V1),
                facts_undo,
                csg_statistics_reset,
                evaluate,
                statistics(E, _),
                volume(3, V2) )).

test(undone_without_evaluating, Same == [true,true]) :-
    with_tree([ box(size(2,2,2)), at([translate(1,0,0)], box(size(2,2,2))),
                difference([1,2]) ],
              ( node_rows(3, Rows0),
                facts_transaction(
                    ( term_changed(2, at([translate(1.5,0,0)],
                                         box(size(2,2,2)))),
                      evaluate )),
                node_rows(3, Rows1),
                Rows1 \== Rows0,
                findall(Is,
                        ( member(Step-Rows, [facts_undo-Rows0,
                                             facts_redo-Rows1]),
                          call(Step),
                          node_rows(3, Rows2),
                          (   Rows2 == Rows,
                              evaluated(3)
                          ->  Is = true
                          ;   Is = false
                          ) ),
                        Same) )).

%   node_rows(S, Rows): its vertices, polygons and triangles, and its record.

node_rows(S, Rows) :-
    findall(Row,
            ( member(Row, [ v(S, _, _, _, _), p(S, _, _), t(S, _, _, _, _, _),
                            origin(S, node(S), _) ]),
              call(Row) ),
            Rows).

term_changed(S, Term) :-
    retract_fact(segment(S, Kind, _)),
    !,
    assert_fact(segment(S, Kind, Term)).

:- end_tests(csg_again).
