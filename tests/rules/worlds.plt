/* Transactions, snapshots, undo; worlds and threads; keys of segments. */
:- module(test_worlds, []).
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(library(aggregate)).
:- use_module(library(time), [call_with_time_limit/2]).
:- use_module(rules(picture/hidden_lines), [picture/0]).
:- use_module(rules(picture/view), [set_view/1]).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

:- begin_tests(worlds, [setup(( new_world(W), set_world(W) ))]).

% Transactions.

vs(Vs) :-
    findall(V, v(1,V,_,_,_), Vs).

add(V) :-
    assert_fact(v(1,V,0,0,0)).

test(commit, Vs == [1,2]) :-
    in_new_world(( facts_transaction(( add(1), add(2) )), vs(Vs) )).
test(failure_rolls_back, Vs == [1]) :-
    in_new_world(( add(1), \+ facts_transaction(( add(2), fail )), vs(Vs) )).
test(exception_rolls_back, Vs == [1]) :-
    in_new_world(( add(1),
             catch(facts_transaction(( add(2), throw(x) )), x, true),
             vs(Vs) )).
test(time_limit_rolls_back, Vs == [1]) :-
    in_new_world(( add(1),
             catch(call_with_time_limit(0.05,
                       facts_transaction(( add(2), repeat, fail ))),
                   time_limit_exceeded, true),
             vs(Vs) )).
test(abort_rolls_back,
     [ condition(current_prolog_flag(threads, true)),
       Status-Vs == exception('$aborted')-[1]
     ]) :-
    new_world(W),
    in_world(W, add(1)),
    thread_self(Me),
    thread_create(in_world(W,
                           facts_transaction(( add(2),
                                               thread_send_message(Me, in),
                                               repeat, fail ))),
                  Id),
    thread_get_message(in),
    thread_signal(Id, abort),
    thread_join(Id, Status),
    in_world(W, vs(Vs)).
test(nested, Vs == [1,3]) :-
    in_new_world(( facts_transaction(( add(1),
                                 \+ facts_transaction(( add(2), fail )),
                                 facts_transaction(add(3)) )),
             vs(Vs) )).
test(inner_commit_outer_rollback, Vs == []) :-
    in_new_world(( \+ facts_transaction(( facts_transaction(add(1)), fail )),
             vs(Vs) )).
test(transaction_is_once, Vs == [1]) :-
    in_new_world(( findall(V,
                     facts_transaction(( member(V, [1,2]), add(V) )),
                     _),
             vs(Vs) )).
test(snapshot, Inside-Vs == [1,2]-[1]) :-
    in_new_world(( add(1),
             facts_snapshot(( add(2), vs(Inside) )),
             vs(Vs) )).
test(undo_and_redo, States == [[1,2],[1],[],[1],[1,2]]) :-
    in_new_world(( facts_transaction(add(1)),
             facts_transaction(add(2)),
             vs(A), facts_undo, vs(B), facts_undo, vs(C),
             \+ facts_undo,
             facts_redo, vs(D), facts_redo, vs(E),
             \+ facts_redo,
             States = [A,B,C,D,E] )).
% What was done before a picture is taken back, and can be done again after one.
test(picture_is_no_step, Ns == [2,1,0,2]-drawn) :-
    in_new_world(( add_primitive(box(size(1,1,1)), _),
                   facts_transaction(add_primitive(box(size(2,1,1)), _)),
                   complete_segments, set_view(front), picture,
                   once(drawn(_,_,_,_,_,_,_)), N1 = 2,
                   facts_undo,
                   aggregate_all(count, segment(_,_,_), N2),
                   facts_undo,
                   aggregate_all(count, segment(_,_,_), N3),
                   facts_redo, facts_redo,
                   picture, Drawn = drawn,
                   aggregate_all(count, segment(_,_,_), N4),
                   Ns0 = [N1,N2,N3,N4] )),
    Ns = Ns0-Drawn.
test(change_forgets_redo, fail) :-
    in_new_world(( facts_transaction(add(1)), facts_undo, add(2), facts_redo )).
test(unchanged_is_no_step, fail) :-
    in_new_world(( facts_transaction(true), facts_undo )).
test(undo_limit, N == 3) :-
    in_new_world(( facts_undo_limit(3),
             forall(between(1, 10, V), facts_transaction(add(V))),
             aggregate_all(count, ( between(1, 10, _), facts_undo ), N) )).
test(undo_inside, error(permission_error(undo, open_transaction, _), _)) :-
    in_new_world(facts_transaction(facts_undo)).
test(open_call_survives_rollback, Vs == [1,2,3]) :-
    in_new_world(( add(1), add(2), add(3),
             findall(V,
                     ( v(1,V,_,_,_),
                       \+ facts_transaction(( retractall_facts(v(_,_,_,_,_)),
                                              add(V), fail )) ),
                     Vs) )).

% Worlds and threads.

test(worlds_are_apart, A-B == [1]-[2]) :-
    new_world(W1),
    new_world(W2),
    in_world(W1, add(1)),
    in_world(W2, add(2)),
    in_world(W1, vs(A)),
    in_world(W2, vs(B)).
test(in_world_restores, W == W1) :-
    current_world(W),
    new_world(W2),
    catch(in_world(W2, throw(x)), x, true),
    \+ in_world(W2, fail),
    current_world(W1).
test(transaction_in_another_world, Vs == []) :-
    new_world(W),
    in_new_world(\+ facts_transaction(( set_world(W), add(1), fail ))),
    in_world(W, vs(Vs0)),
    assertion(Vs0 == [1]),                  % that world had no transaction
    in_new_world(vs(Vs)).
test(no_world,
     [ condition(current_prolog_flag(threads, true)),
       Status == exception(existence_error(sg_world, current))
     ]) :-
    thread_create(catch(v(_,_,_,_,_), error(E, _), throw(E)), Id),
    thread_join(Id, Status).
test(no_handle, error(type_error(sg_world, x), _)) :-
    set_world(x).
test(handles_compare, Order == (<)) :-
    new_world(A),
    new_world(B),
    compare(Order, A, B).
test(other_thread_sees_before,
     [condition(current_prolog_flag(threads, true)), Seen == [1]]) :-
    new_world(W),
    in_world(W, ( add(1),
                  facts_transaction(( add(2),
                                      thread_create(( set_world(W), vs(Vs),
                                                      thread_exit(Vs) ),
                                                    Id),
                                      thread_join(Id, exited(Seen)) )) )).
test(writers_take_turns,
     [condition(current_prolog_flag(threads, true)), N == 400]) :-
    new_world(W),
    findall(Id,
            ( between(1, 4, T),
              thread_create(in_world(W, add_hundred(T)), Id) ),
            Ids),
    forall(member(Id, Ids), thread_join(Id, true)),
    in_world(W, aggregate_all(count, v(_,_,_,_,_), N)).

add_hundred(T) :-
    forall(between(1, 100, V),
           facts_transaction(( assert_fact(v(T,V,0,0,0)), v(T,V,_,_,_) ))).

test(worlds_are_collected) :-
    forall(between(1, 300, _),
           in_new_world(forall(between(1, 20, V), add(V)))),
    garbage_collect_atoms.
test(pruned_calls_let_go, true(Versions =< 3)) :-
    in_new_world(( add(1), add(2), add(3),
             forall(between(1, 50, V0),
                    ( V is V0+10, once(v(_,_,_,_,_)), add(V) )),
             facts_statistics(v, Statistics),
             Versions = Statistics.versions )).

:- end_tests(worlds).

:- begin_tests(segments_key).

%   keys(+Changes, -Keys): of segments 1 and 2 at first and after each change.

keys(Changes, [Key|Keys]) :-
    new_world(World),
    in_world(World,
             ( assert_fact(v(1, 1, 0.0, 0.0, 0.0)),
               assert_fact(v(2, 1, 0.0, 0.0, 0.0)),
               assert_fact(v(3, 1, 0.0, 0.0, 0.0)),
               segments_key([1,2], Key),
               findall(K, ( member(Change, Changes), call(Change),
                            segments_key([1,2], K) ),
                       Keys) )).

test(nothing_changes, true(K == K1)) :-
    keys([true], [K,K1]).
test(another_segment, true(K == K1)) :-
    keys([assert_fact(v(3, 2, 1.0, 0.0, 0.0))], [K,K1]).
test(one_of_them, true(K \== K1)) :-
    keys([assert_fact(v(2, 2, 1.0, 0.0, 0.0))], [K,K1]).
test(undo, true(K-K1 == K2-K3)) :-
    keys([facts_transaction(assert_fact(v(2, 2, 1.0, 0.0, 0.0))), facts_undo,
          facts_redo],
         [K,K1,K2,K3]).
test(order, true(K1 \== K2)) :-
    new_world(World),
    in_world(World,
             ( assert_fact(v(1, 1, 0.0, 0.0, 0.0)),
               segments_key([1,2], K1),
               segments_key([2,1], K2) )).
test(no_list, error(type_error(list, a))) :-
    segments_key(a, _).

:- end_tests(segments_key).
