/* The fact engine from Prolog: every relation in every instantiation mode
   against a plain list of the same facts, and changes; worlds.plt has
   transactions, worlds and threads.
*/
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(library(apply)).
:- use_module(library(aggregate)).
:- use_module(library(sandbox), [safe_goal/1]).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

:- begin_tests(store, [setup(( new_world(W), set_world(W) ))]).

vs(Vs) :-
    findall(V, v(1,V,_,_,_), Vs).

add(V) :-
    assert_fact(v(1,V,0,0,0)).

%   answers(:Goal, -Answers, -Det): all answers, and whether the last one left
%   no choice point.

:- meta_predicate answers(0, -, -).

answers(Goal, Answers, Det) :-
    State = state(true),
    strip_module(Goal, _, Plain),
    findall(Plain,
            (   call_cleanup(Goal, Exit = true),
                (   Exit == true
                ->  nb_setarg(1, State, exit)
                ;   nb_setarg(1, State, choice)
                )
            ),
            Answers),
    arg(1, State, Last),
    (   Answers == []
    ->  Det = exit
    ;   Det = Last
    ).

%   Rows enough to make every argument match some and miss others.

rows([ segment(1, solid, cube), segment(2, surface, "a name"),
       segment(3, curve, box(1,2.5,[a,"b"|c])),
       v(1,1, 0.0,0.0,0.0), v(1,2, 1.0,0.0,0.0), v(1,3, 1.0,1.0,0.0),
       v(1,4, 0.0,1.0,0.0), v(2,1, 1.0,1.0,1.0), v(2,2, 0.0,0.0,1.0),
       v(2,4, 4.0,2.0,2.0),
       e(1,1,1,2,1), e(1,2,2,3,1), e(1,3,3,1,0), e(1,4,1,3,0), e(1,5,3,4,1),
       e(1,6,4,1,1), e(1,7,2,2,1), e(2,1,1,2,1), e(2,2,2,1,1),
       p(1,1,[1,2,3]), p(1,2,[4,5,6]), p(1,3,[]), p(2,1,[1,2]), p(2,2,[2,1]),
       plane(1,1, 0.0,0.0,1.0,0.0), plane(1,2, 0.0,0.0,1.0,-1.0),
       plane(2,1, 1.0,0.0,0.0,0.0),
       t(1,1,1,1,2,3), t(1,2,2,1,3,4), t(1,2,3,3,4,1), t(2,1,1,1,2,4),
       t(2,1,2,1,1,1),
       origin(1,v(2),lpi(1-(3-4),2-7)), origin(1,e(2),e(1)),
       origin(2,v(2),lpi(1-(3-4),2-7)), origin(2,p(1),[x,1r3,-0.5,"s"]),
       from_v(2,1,1,1), from_v(2,2,1,3),
       from_p(2,1,1,1,1), from_p(2,1,1,2,1), from_p(2,2,1,1,-1),
       line(1, 1,1,1,2, 2,1,1,2), line(2, 1,1,2,3, 2,2,1,2),
       line(3, 1,2,1,2, 2,1,2,1),
       view(30.0,60.0,10.0), view(30.0,45.0,10.0), view(30.0,60.0,10.0),
       projection(parallel), projection(central),
       title_block(name, 'A part'), title_block(date, "2026"),
       title_block(number, "2026"),
       look(1,colour(red)), look(1,shine(0.5)), look(2,colour(rgb(1,2,3))),
       light(0,strength(0.5)), light(2,picture(1,2,3)), light(2,strength(1)),
       screen(1,1,0.0,0.0,0.0), screen(1,2,0.5,0.0,1.0),
       screen(2,1,0.5,0.5,1.0),
       contour(1,1,1,1,0.5,2,0.25,visible,[1,2],0.125,0.0,0.0,0.5),
       contour(1,2,1,2,0.25,3,0.0,hidden,[],0.0,0.0,0.0,0.0),
       surface_facing(1,1,3,0.0,0.5,[2]), surface_facing(1,2,1,0.0,0.0,[]),
       drawn(5,1,-1,0.0,0.5,visible,outline),
       drawn(1,1,1,0.0,1.0,visible,outline), drawn(2,1,2,0.0,0.5,hidden,mesh),
       drawn(3,1,2,0.5,1.0,visible,mesh), drawn(4,2,1,0.0,1.0,visible,border)
     ]).

fill(Rows) :-
    rows(Rows),
    maplist(assert_fact, Rows).

%   A query: the row's arguments where the mask has a bit, else variables.

query(Row, Mask, Query) :-
    Row =.. [Name|Args],
    query_args(Args, 0, Mask, Vars),
    Query =.. [Name|Vars].

query_args([], _, _, []).
query_args([A|As], I, Mask, [Q|Qs]) :-
    (   Mask /\ (1<<I) =\= 0
    ->  Q = A
    ;   true
    ),
    I1 is I+1,
    query_args(As, I1, Mask, Qs).

wrong_mode(Rows, Query) :-
    findall(Query, member(Query, Rows), Expected),
    answers(Query, Answers, Det),
    \+ ( Answers == Expected, Det == exit ).

relation_mode(Rows, Name, Query) :-
    relation(Name, Arity, _),
    functor(Row, Name, Arity),
    member(Row, Rows),
    Last is (1<<Arity)-1,
    between(0, Last, Mask),
    query(Row, Mask, Query).

test(every_mode, Wrong == []) :-
    in_new_world(( fill(Rows),
             findall(Query,
                     ( relation_mode(Rows, _, Query),
                       wrong_mode(Rows, Query) ),
                     Wrong) )).

test(every_pair_of_variables, Wrong == []) :-
    in_new_world(( fill(Rows),
             findall(Query,
                     ( relation_pair(Query), wrong_mode(Rows, Query) ),
                     Wrong) )).

relation_pair(Query) :-
    relation(Name, Arity, _),
    functor(Query, Name, Arity),
    between(1, Arity, I),
    between(1, Arity, J),
    I < J,
    arg(I, Query, X),
    arg(J, Query, X).

test(partial_terms, Wrong == []) :-
    in_new_world(( fill(Rows),
             findall(Query,
                     ( partial(Query), wrong_mode(Rows, Query) ),
                     Wrong) )).

partial(p(_,_,[_|_])).
partial(p(1,_,[1,_,_])).
partial(p(_,P,[P|_])).
partial(p(_,_,[X,Y|_])) :- X = Y.
partial(p(_,_,_-_)).
partial(p(_,_,[_|x])).
partial(p(_,_,[1.0,2,3])).
partial(segment(_,_,box(1,_,[a|_]))).
partial(segment(_,_,box(X,X,_))).
partial(origin(S,v(_),lpi(S-_,_))).
partial(origin(_,v(V),lpi(_,V-_))).
partial(origin(S,_,lpi(_,S-_))).
partial(origin(_,_,[x|_])).

test(values_that_no_row_has, Answers == []) :-
    in_new_world(( fill(Rows),
             findall(Query, ( stranger(Rows, Query), call(Query) ),
                     Answers) )).

stranger(Rows, Query) :-
    member(Row, Rows),
    functor(Row, _, Arity),
    between(0, Arity, I),
    I < Arity,
    member(Value, [a, "a", -1, 0.25, 1r3, 99, 99999999999999999999, f(x), [],
                   [a], nan, -0.0, 1.0Inf]),
    query(Row, 0, Query),
    I1 is I+1,
    arg(I1, Query, Value),
    \+ memberchk(Query, Rows).

test(integer_is_no_float, [fail]) :-
    in_new_world(( assert_fact(v(1,1,1,2,3)), v(1,1,1,_,_) )).

% Changes and what is wrong with them.

test(numbers_become_floats, X-Y-Z == 1.0-0.5-0.0) :-
    in_new_world(( assert_fact(v(1,1,1,1r2,-0.0)), v(1,1,X,Y,Z) )).
test(terms_read_back, true(Back =@= Term)) :-
    Term = f(1, -7, 134217727, 134217728, -134217728, -134217729,
             9223372036854775807, -9223372036854775808, 9223372036854775808,
             -123456789012345678901234567890, 1r3, -22r7,
             1000000000000000000000r3, 0.1, -0.0, 1.0e300,
             '', a, 'A b', [], '[]', "", "text", "a\u0000b",
             '\uAC00\U0001F600', [1,2|3], [[]], g(), -(1), 1-(2-3), {x},
             'a,b'(c)),
    in_new_world(( assert_fact(segment(1,solid,Term)), segment(1,_,Back) )).
test(long_list_in_a_term, Last == 100000) :-
    numlist(1, 100000, List),
    in_new_world(( assert_fact(segment(1,solid,List)), segment(1,_,Back) )),
    last(Back, Last).
test(term_is_found_by_its_words, S == 7) :-
    in_new_world(( forall(between(1, 20, I),
                    assert_fact(origin(I,v(1),f(I,"x",[1.5,a])))),
             origin(S, _, f(7,"x",[1.5,a])) )).

refused(v(1,_,0,0,0),      instantiation_error).
refused(_,                 instantiation_error).
refused(17,                type_error(callable, 17)).
refused(w(1),              existence_error(relation, w/1)).
refused(v(1,2),            existence_error(relation, v/2)).
refused(v(a,1,0,0,0),      type_error(integer, a)).
refused(v(1.0,1,0,0,0),    type_error(integer, 1.0)).
refused(v(1,0,0,0,0),      domain_error(positive_integer, 0)).
refused(v(1,-1,0,0,0),     type_error(nonneg, -1)).
refused(v(1,2147483648,0,0,0), representation_error(int32)).
refused(v(1,99999999999999999999,0,0,0), representation_error(int32)).
refused(drawn(1,1,-2147483648,0,1,visible,outline),
        representation_error(int32)). % 2147483648 is the piece it would name
refused(v(1,9,a,0,0),      type_error(float, a)).
refused(v(1,9,"1",0,0),    type_error(float, "1")).
refused(v(1,9,0,X,0),      domain_error(finite_float, X)) :- X is inf.
refused(v(1,9,0,0,X),      domain_error(finite_float, _)) :- X is nan.
refused(v(1,1,5,5,5),      permission_error(assert, fact, v(1,1,5,5,5))).
refused(v(1,9,0,-1.1e90,0), domain_error(coordinate, -1.1e90)).
refused(e(1,9,1,99,1),     existence_error(v, 1-99)).
refused(e(2,9,1,2,1),      existence_error(v, 2-1)).
refused(e(1,9,1,2,2),      domain_error(oneof([0,1]), 2)).
refused(e(1,9,1,2,x),      type_error(integer, x)).
refused(p(1,9,[1,99]),     existence_error(e, 1-99)).
refused(p(1,9,[1|_]),      instantiation_error).
refused(p(1,9,[1,_]),      instantiation_error).
refused(p(1,9,x),          type_error(list, x)).
refused(p(1,9,[x]),        type_error(integer, x)).
refused(from_p(1,1,2,1,0),
        domain_error(oneof([1,-1]), 0)).
refused(from_p(1,1,2,1,-2),
        domain_error(oneof([1,-1]), -2)).
refused(from_v(1,99,2,1),  existence_error(v, 1-99)).
refused(p(1,9,[-1]),       type_error(nonneg, -1)).
refused(t(1,9,1,1,2,2),    existence_error(p, 1-9)).
refused(segment(9,blob,x),
        domain_error(oneof([solid,surface,curve,cells,pattern]),
                                        blob)).
refused(segment(9,solid,_), instantiation_error).
refused(segment(9,solid,f(S)), type_error(storable_term, f(S))) :-
    current_output(S).

few :-
    two,
    assert_fact(e(1,1,1,2,1)).

two :-
    maplist(assert_fact, [v(1,1,0,0,0), v(1,2,1,0,0)]).

test(refused, [forall(refused(Fact, Formal)), error(Formal, _)]) :-
    in_new_world(( few, assert_fact(Fact) )).
test(refused_changes_nothing, N == 2) :-
    in_new_world(( few,
             forall(refused(Fact, _),
                    catch(assert_fact(Fact), error(_, _), true)),
             aggregate_all(count, v(_,_,_,_,_), N) )).
test(deep_term, error(resource_error(nesting_of_terms))) :-
    numlist(1, 20_000, Is),
    foldl([_,T,f(T,x)]>>true, Is, x, Deep),
    assert_fact(segment(9, solid, Deep)).
test(cyclic_term, error(type_error(storable_term, _), _)) :-
    X = f(X),
    in_new_world(assert_fact(segment(1,solid,X))).

test(retract_is_nondet, Vs-Left == [1,2]-[]) :-
    in_new_world(( two,
             findall(V, retract_fact(v(1,V,_,_,_)), Vs),
             findall(V, v(1,V,_,_,_), Left) )).
test(retract_one, Left == [2]) :-
    in_new_world(( two,
             once(retract_fact(v(_,_,_,_,_))),
             findall(V, v(1,V,_,_,_), Left) )).
test(retract_last_is_det) :-
    in_new_world(( two,
             call_cleanup(retract_fact(v(1,2,_,_,_)), Det = true),
             Det == true )).
test(retract_skips_what_is_gone, Vs == [1]) :-
    in_new_world(( two,
             findall(V,
                     ( retract_fact(v(1,V,_,_,_)),
                       retractall_facts(v(_,_,_,_,_)) ),
                     Vs) )).
test(retractall_by_pattern, Left == [e(1,1,1,2,1)]) :-
    in_new_world(( few,
             assert_fact(e(1,2,2,2,1)),
             retractall_facts(e(_,_,V,V,_)),
             findall(e(A,B,C,D,E), e(A,B,C,D,E), Left) )).
test(retractall_of_segment, Left == [e(2,1,1,2,1)]) :-
    in_new_world(( forall(member(S, [1,2]),
                    ( assert_fact(v(S,1,0,0,0)), assert_fact(v(S,2,1,0,0)),
                      assert_fact(e(S,1,1,2,1)) )),
             assert_fact(e(1,2,2,1,1)),
             retractall_facts(e(1,_,_,_,_)),
             findall(e(S,E,A,B,T), e(S,E,A,B,T), Left),
             \+ e(1,_,1,_,_),
             v(1,2,_,_,_) )).
test(retractall_of_segment_twice_a_variable, N == 1) :-
    in_new_world(( assert_fact(v(1,1,0,0,0)), assert_fact(v(1,2,1,0,0)),
             assert_fact(e(1,1,1,2,1)),
             retractall_facts(e(1,_,V,V,_)),
             aggregate_all(count, e(_,_,_,_,_), N) )).
test(retractall_of_no_segment) :-
    in_new_world(( assert_fact(v(1,1,0,0,0)),
             forall(member(S, [0,-1,9,2147483648,1.0,a]),
                    retractall_facts(v(S,_,_,_,_))),
             v(1,1,_,_,_) )).
test(retractall_of_nothing) :-
    in_new_world(retractall_facts(v(1,foo,_,_,_))).
test(retractall_unknown, error(existence_error(relation, w/1), _)) :-
    retractall_facts(w(_)).

% Logical update view.

test(scan_sees_no_addition, N == 3) :-
    in_new_world(( forall(between(1, 3, V), assert_fact(v(1,V,0,0,0))),
             aggregate_all(count,
                           ( v(1,V,_,_,_),
                             V2 is V+100,
                             assert_fact(v(1,V2,0,0,0)) ),
                           N) )).
test(scan_sees_no_retraction, Vs == [1,2,3]) :-
    in_new_world(( forall(between(1, 3, V), assert_fact(v(1,V,0,0,0))),
             findall(V,
                     ( v(1,V,_,_,_), retractall_facts(v(_,_,_,_,_)) ),
                     Vs) )).
test(lookup_sees_no_change, Es == [1,2,3]) :-
    in_new_world(( few,
             forall(between(2, 3, E), assert_fact(e(1,E,1,2,0))),
             findall(E,
                     ( e(1,E,1,_,_),
                       retractall_facts(e(_,_,_,_,_)),
                       E2 is E+10,
                       assert_fact(e(1,E2,1,2,1)) ),
                     Es) )).
test(lists_of_retracted_rows_stay, Ls == [[1],[1,1],[1,1,1]]) :-
    in_new_world(( few,
             assert_fact(p(1,1,[1])),
             assert_fact(p(1,2,[1,1])),
             assert_fact(p(1,3,[1,1,1])),
             findall(L,
                     ( p(1,_,L),
                       retractall_facts(p(_,_,_)),
                       forall(between(10, 500, P), assert_fact(p(1,P,[1]))),
                       retractall_facts(p(_,_,_)) ),
                     Ls) )).

% Rows by number, members, ids.

test(rows_by_number, Rows == Numbered) :-
    in_new_world(( fill(_),
             findall(v(S,V,X,Y,Z), v(S,V,X,Y,Z), Rows),
             findall(F,
                     ( fact_row(v(_,_,_,_,_), R),
                       F = v(_,_,_,_,_),
                       fact_row(F, R) ),
                     Numbered) )).
test(row_of_new_fact, X == 4.0) :-
    in_new_world(( assert_fact(v(1,1,4,0,0), Row),
                   fact_row(v(_,_,X,_,_), Row) )).
test(no_such_row, fail) :-
    in_new_world(fact_row(v(_,_,_,_,_), 12345)).
test(members, Wrong == []) :-
    in_new_world(( fill(_),
             findall(S-I, wrong_members(S, I), Wrong) )).

wrong_members(S, I) :-
    between(1, 3, S),
    between(1, 8, I),
    findall(P, ( p(S,P,Es), memberchk(I, Es) ), Ps),
    findall(T, ( t(S,_,T,A,B,C), memberchk(I, [A,B,C]) ), Ts),
    answers(edge_polygon(S,I,_), Ps1, Det1),
    answers(vertex_triangle(S,I,_), Ts1, Det2),
    \+ ( maplist([edge_polygon(_,_,P),P]>>true, Ps1, Ps),
         maplist([vertex_triangle(_,_,T),T]>>true, Ts1, Ts),
         Det1 == exit,
         Det2 == exit ).

test(member_given, [true]) :-
    in_new_world(( fill(_), edge_polygon(1, 4, 2), vertex_triangle(1, 3, 1) )).
test(fresh_ids, Ids == [1,2,6,7,1]) :-
    in_new_world(( fresh_id(v,1,A), fresh_id(v,1,B),
             assert_fact(v(1,5,0,0,0)),
             fresh_id(v,1,C),
             facts_snapshot(fresh_id(v,1,D0)),
             fresh_id(v,1,D), D == D0,
             fresh_id(v,2,E),
             Ids = [A,B,C,D,E] )).
test(fresh_of_none, error(domain_error(relation_with_ids, view), _)) :-
    fresh_id(view, 1, _).

% The schema.

test(every_relation_is_exported, Missing == []) :-
    findall(Name/Arity,
            ( relation(Name, Arity, _),
              \+ ( module_property(sg_store, exports(Es)),
                   memberchk(Name/Arity, Es) ) ),
            Missing).
% All of them are found by name, and the other way round.
test(every_relation_is_listed, Listed == Named) :-
    module_property(sg_store, exports(Es)),
    findall(Name/Arity, ( member(Name/Arity, Es), relation(Name, Arity, _) ),
            Named0),
    findall(Name/Arity, relation(Name, Arity, _), Listed0),
    msort(Named0, Named),
    msort(Listed0, Listed).
test(columns, Columns == ['S'-int, 'P'-int, 'Es'-list]) :-
    findall(C-T, relation_column(p, _, C, T, _), Columns).
test(refers, R == v) :-
    relation_column(e, 2, 'V1', int, R).
test(reading_is_safe, Unsafe == []) :-
    findall(G,
            ( relation(N, A, _), functor(G, N, A),
              \+ catch(safe_goal(sg_store:G), _, fail) ),
            Unsafe).
test(changing_is_not_safe, error(permission_error(call, sandboxed, _), _)) :-
    safe_goal(sg_store:assert_fact(v(1,1,0,0,0))).
test(statistics, true(Lookups >= 1)) :-
    in_new_world(( add(1), v(1,1,_,_,_),
             facts_statistics(v, Statistics),
             _{rows:1, lookups:Lookups} :< Statistics )).

% Random changes against SWI-Prolog's own facts.

:- dynamic mirror/5.

test(random_against_dynamic_facts, Wrong == []) :-
    in_new_world(( retractall(mirror(_,_,_,_,_)),
             set_random(seed(20261121)),
             forall(between(1, 12, V), add(V)),
             findall(Step, ( between(1, 3000, Step), random_wrong ),
                     Wrong) )).

random_wrong :-
    random_between(1, 12, A),
    random_between(1, 12, B),
    random_between(1, 60, E),
    random_between(0, 99, What),
    random_step(What, E, A, B),
    random_query(E, A, B, Query),
    findall(Query, call(Query), Found),
    Query =.. [_|Args],
    Mirror =.. [mirror|Args],
    findall(Query, call(Mirror), Expected),
    msort(Found, Sorted),
    msort(Expected, SortedExpected),
    Sorted \== SortedExpected.

random_step(What, E, A, B) :-
    What < 50,
    !,
    (   mirror(1,E,_,_,_)
    ->  true
    ;   assert_fact(e(1,E,A,B,1)),
        assertz(mirror(1,E,A,B,1))
    ).
random_step(What, E, _, _) :-
    What < 80,
    !,
    retractall_facts(e(1,E,_,_,_)),
    retractall(mirror(1,E,_,_,_)).
random_step(What, _, A, _) :-
    What < 95,
    !,
    ignore(retract_fact(e(1,_,A,_,_))),
    retractall(mirror(1,_,_,_,_)),
    forall(e(S,E,V1,V2,Et), assertz(mirror(S,E,V1,V2,Et))).
random_step(_, _, A, _) :-
    \+ facts_transaction(( retractall_facts(e(_,_,A,_,_)), fail )).

random_query(E, A, B, Query) :-
    random_member(Query, [ e(1,E,_,_,_), e(1,_,A,_,_), e(1,_,_,B,_),
                           e(1,_,A,B,_), e(_,_,A,A,_), e(_,_,_,_,_) ]).

:- end_tests(store).
