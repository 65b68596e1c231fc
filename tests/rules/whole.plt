:- module(test_whole, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(aggregate)).
:- use_module(library(random)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(store)).
:- use_module(rules(kernel), [census/1]).
:- use_module(rules(model/integrity), [model_defect/1]).
:- use_module(rules(model/model)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(picture/view)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(tests('rules/whole_world')).

/* A world that has been edited is whole, or the edit was refused; dangling/2
   looks at all rows, the store at what was changed. */

:- meta_predicate in_new_world(0), with_box(0), raised(0, -).

in_new_world(Goal) :-
    new_world(World),
    in_world(World, Goal).

with_box(Goal) :-
    in_new_world(( add_primitive(box(size(2,2,2)), 1),
                   complete_segments,
                   Goal )).

raised(Goal, Formal) :-
    catch(( ignore(Goal), Formal = none ), error(Formal, _), true).

count(Goal, N) :-
    aggregate_all(count, Goal, N).

%   moved(V): a vertex of the box goes elsewhere.

moved(V) :-
    retract_fact(v(1, V, X, Y, Z)),
    !,
    X1 is X+1,
    assert_fact(v(1, V, X1, Y, Z)).

%   silently(Goal): its warnings are not printed: that polygons are invalid.

:- meta_predicate silently(0).
:- dynamic silent/0.
:- multifile user:message_hook/3.

user:message_hook(sanggwan(_), warning, _) :-
    test_whole:silent.

silently(Goal) :-
    setup_call_cleanup(assertz(silent), once(Goal), retractall(silent)).

:- begin_tests(whole).

% Outside a transaction.
test(vertex_of_an_edge,
     error(model_error(referred(v(1,1,_,_,_), e(1,_,_,_,_))), _)) :-
    with_box(retract_fact(v(1, 1, _, _, _))).
test(edge_of_a_polygon,
     error(model_error(referred(e(1,1,_,_,_), p(1,_,_))), _)) :-
    with_box(retract_fact(e(1, 1, _, _, _))).
test(refused_stays, N == 8) :-
    with_box(( raised(retract_fact(v(1, 1, _, _, _)), _),
               count(v(1, _, _, _, _), N) )).
test(many_refused_stay, N-F == 8-model_error(not_whole(E, v(1, V)))) :-
    with_box(( raised(retractall_facts(v(1, _, _, _, _)), F),
               F = model_error(not_whole(E, v(1, V))),
               count(v(1, _, _, _, _), N) )).
test(all_of_a_relation, error(model_error(not_whole(_, v(1, _))), _)) :-
    with_box(retractall_facts(v(_, _, _, _, _))).
test(polygon_goes_with_what_was_made_of_it, [P,T] == [5,10]) :-
    with_box(( retract_fact(p(1, 1, _)),
               count(plane(1, _, _, _, _, _), P),
               count(t(1, _, _, _, _, _), T) )).
test(polygons_go_with_what_was_made_of_them, [P,T] == [0,0]) :-
    with_box(( retractall_facts(p(1, _, _)),
               count(plane(1, _, _, _, _, _), P),
               count(t(1, _, _, _, _, _), T) )).
test(unused_vertex, N == 8) :-
    with_box(( assert_fact(v(1, 9, 0, 0, 0)),
               retract_fact(v(1, 9, _, _, _)),
               count(v(1, _, _, _, _), N) )).
test(early, error(existence_error(v, 1-99), _)) :-
    with_box(assert_fact(e(1, 99, 1, 99, 1))).
test(change_alone_is_no_step) :-
    in_new_world(( forall(between(1, 3, V), assert_fact(v(1, V, 0, 0, 0))),
                   retractall_facts(v(1, _, _, _, _)),
                   \+ facts_undo )).

% Cascades.
test(cascade, [V,E,P] == [7,18,3]) :-
    with_box(( retract_fact(v(1, 1, _, _, _), [cascade(true)]),
               count(v(1, _, _, _, _), V),
               count(e(1, _, _, _, _), E),
               count(p(1, _, _), P) )).
test(cascade_in_a_transaction, [V,E,P,T] == [7,18,3,6]) :-
    with_box(( facts_transaction(retract_fact(v(1, 1, _, _, _)),
                                 [cascade(true)]),
               count(v(1, _, _, _, _), V),
               count(e(1, _, _, _, _), E),
               count(p(1, _, _), P),
               count(t(1, _, _, _, _, _), T) )).
test(cascade_undone, [V,E,P,T] == [8,24,6,12]) :-
    with_box(( facts_transaction(retract_fact(v(1, 1, _, _, _)),
                                 [cascade(true)]),
               facts_undo,
               count(v(1, _, _, _, _), V),
               count(e(1, _, _, _, _), E),
               count(p(1, _, _), P),
               count(t(1, _, _, _, _, _), T) )).
test(cascade_of_all, N == 0) :-
    with_box(( facts_transaction(retractall_facts(v(_, _, _, _, _)),
                                 [cascade(true)]),
               count(( e(_, _, _, _, _) ; p(_, _, _) ; t(_, _, _, _, _, _) ),
                     N) )).
test(cascade_is_nondet, Vs-N == [1,2,3,4,5,6,7,8]-0) :-
    with_box(( findall(V, retract_fact(v(1, V, _, _, _), [cascade(true)]), Vs),
               count(e(_, _, _, _, _), N) )).
test(no_boolean, error(type_error(_, _), _)) :-
    with_box(retract_fact(v(1, 1, _, _, _), [cascade(perhaps)])).

% Inside a transaction.
test(moved, Defects == []) :-
    with_box(( facts_transaction(moved(1)),
               findall(D, dangling(D, _), Defects) )).
test(in_any_order, N == 1) :-
    in_new_world(( facts_transaction(( assert_fact(p(1, 1, [1,2,3])),
                                       assert_fact(e(1, 1, 1, 2, 1)),
                                       assert_fact(e(1, 2, 2, 3, 1)),
                                       assert_fact(e(1, 3, 3, 1, 1)),
                                       assert_fact(v(1, 1, 0, 0, 0)),
                                       assert_fact(v(1, 2, 1, 0, 0)),
                                       assert_fact(v(1, 3, 0, 1, 0)) )),
                   count(p(1, _, _), N) )).
test(never_there, [F,N] == [model_error(not_whole(e(1,1,1,2,1), v(1,2))), 0]) :-
    in_new_world(( raised(facts_transaction(( assert_fact(e(1, 1, 1, 2, 1)),
                                              assert_fact(v(1, 1, 0, 0, 0)) )),
                          F),
                   count(( v(_, _, _, _, _) ; e(_, _, _, _, _) ), N) )).
test(after, error(existence_error(v, 1-1), _)) :-
    in_new_world(facts_transaction(assert_after(e(1, 1, 1, 2, 1)))).
test(not_there_in_the_end, [F,N] == [model_error(not_whole(e(1,E,A,B,T),
                                                           v(1,1))), 8]) :-
    with_box(( raised(facts_transaction(retract_fact(v(1, 1, _, _, _))), F),
               F = model_error(not_whole(e(1, E, A, B, T), _)),
               count(v(1, _, _, _, _), N) )).
test(only_the_outermost_looks, N == 8) :-
    with_box(( facts_transaction(
                   ( facts_transaction(retract_fact(v(1, 1, X, Y, Z))),
                     facts_transaction(assert_fact(v(1, 1, X, Y, Z))) )),
               count(v(1, _, _, _, _), N) )).
test(inner_one_taken_back, N == 8) :-
    with_box(( facts_transaction(
                   ( ignore(facts_transaction(( retract_fact(v(1, 1, _, _, _)),
                                                fail ))),
                     retract_fact(v(1, 2, X, Y, Z)),
                     assert_fact(v(1, 2, X, Y, Z)) )),
               count(v(1, _, _, _, _), N) )).
test(snapshot, N == 8) :-
    with_box(( facts_snapshot(retractall_facts(v(1, _, _, _, _))),
               count(v(1, _, _, _, _), N) )).
test(very_many, [F,N] == [model_error(not_whole(e(1,1,1,2,1), v(1,1))), 1]) :-
    in_new_world(( forall(between(1, 3, V), assert_fact(v(1, V, 0, 0, 0))),
                   assert_fact(e(1, 1, 1, 2, 1)),
                   raised(facts_transaction(
                              ( forall(between(1, 40_000, I),
                                       ( W is I+10,
                                         assert_fact(v(1, W, 0, 0, 0)),
                                         retract_fact(v(1, W, _, _, _)) )),
                                retract_fact(v(1, 1, _, _, _)),
                                forall(between(1, 40_000, I),
                                       ( W is I+10,
                                         assert_fact(v(1, W, 0, 0, 0)),
                                         retract_fact(v(1, W, _, _, _)) )) )),
                          F),
                   count(e(_, _, _, _, _), N) )).

% Kernels in the middle.
kernel(census(_)).
kernel(model_defect(_)).
kernel(picture).
kernel(penetrate).
kernel(complete_segments).
kernel(project_world).

test(asked_in_the_middle,
     [ forall(kernel(Goal)),
       true(F = model_error(not_whole(e(1,_,_,_,_), v(1,1)))) ]) :-
    with_box(( add_primitive(box(size(1,1,1)), 2),
               set_view(front),
               facts_transaction(( retract_fact(v(1, 1, X, Y, Z)),
                                   raised(Goal, F),
                                   assert_fact(v(1, 1, X, Y, Z)) )) )).
test(asked_when_whole_again, N == 0) :-
    with_box(facts_transaction(( moved(1),
                                 census(_),
                                 count(dangling(_, _), N) ))).
test(asked_after_what_was_made_goes, T == 10) :-
    with_box(facts_transaction(( retract_fact(p(1, 1, _)),
                                 census(_),
                                 count(t(_, _, _, _, _, _), T) ))).
test(refused_question_changes_nothing, T == 12) :-
    with_box(facts_transaction(( retract_fact(p(1, 1, Es)),
                                 retract_fact(v(1, 1, X, Y, Z)),
                                 raised(census(_), model_error(_)),
                                 assert_fact(v(1, 1, X, Y, Z)),
                                 assert_fact(p(1, 1, Es)),
                                 count(t(_, _, _, _, _, _), T) ))).
test(others_see_a_whole_world,
     [condition(current_prolog_flag(threads, true)), Status-N == true-24]) :-
    with_box(( current_world(World),
               facts_transaction(
                   ( retract_fact(v(1, 1, X, Y, Z)),
                     thread_self(Me),
                     thread_create(( set_world(World),
                                     census(_),
                                     aggregate_all(count, e(1, _, _, _, _), N0),
                                     thread_send_message(Me, edges(N0)) ),
                                   Id),
                     thread_join(Id, Status),
                     thread_get_message(edges(N)),
                     assert_fact(v(1, 1, X, Y, Z)) )) )).

% What kernels write over what others made.
test(picture_of_edges_that_were_cut, Left == []) :-
    in_new_world(( add_primitive(box(size(2,2,2)), 1),
                   add_primitive(at([translate(1,1,1)], box(size(2,2,2))), 2),
                   set_view(30, 60, 9),
                   picture,
                   penetrate,
                   findall(Row-Missing, dangling(Row, Missing), Left) )).
test(outline_of_triangles_that_were_cut, Left == []) :-
    in_new_world(( add_primitive(cylinder(radius(1), height(4)), 1),
                   add_primitive(at([translate(1,0,1)], box(size(2,2,2))), 2),
                   set_view(30, 60, 9),
                   picture,
                   penetrate,
                   findall(Row-Missing, dangling(Row, Missing), Left) )).

% Two polygons of one half-edge, as bad meshes have them: the edge stays when it
% is cut in one of them alone, whoever cuts it.
test(edge_of_two_polygons,
     [ forall(member(X-Y, [0-(-4),2-0])), true(Left == []) ]) :-
    in_new_world(( maplist(assert_fact,
                           [ segment(1,surface,twice), v(1,1,0,0,0),
                             v(1,2,4,0,0), v(1,3,0,4,0), v(1,4,X,Y,0),
                             e(1,1,1,2,1), e(1,2,2,3,1), e(1,3,3,1,1),
                             e(1,4,2,4,1), e(1,5,4,1,1), p(1,1,[1,2,3]),
                             p(1,2,[1,4,5]) ]),
                   add_primitive(at([translate(1,1,-1)], box(size(1,1,2))), 2),
                   add_primitive(at([translate(2,0.25,-1)],
                                    box(size(0.5,1,2))), 3),
                   silently(( complete_segments, penetrate )),
                   p(1, 1, _), p(1, 2, _),
                   findall(Row-Missing, dangling(Row, Missing), Left) )).

% What a user adds to the rows of a result goes when it is made again.
test(added_to_a_result, Left == []) :-
    in_new_world(( add_primitive(box(size(2,2,2)), 1),
                   add_primitive(at([translate(1,1,1)], box(size(2,2,2))), 2),
                   assert_fact(segment(3, solid, difference([1,2]))),
                   evaluate,
                   once(p(3, _, [A,B|_])),
                   assert_fact(p(3, 99, [A,B])),
                   facts_transaction(forall(v(2, V, X, Y, Z),
                                            ( retract_fact(v(2, V, X, Y, Z)),
                                              X1 is X+0.25,
                                              assert_fact(v(2, V, X1, Y, Z))
                                            ))),
                   evaluate,
                   findall(Row-Missing, dangling(Row, Missing), Left) )).

% Every column that refers: its row goes, or keeps what it refers to.
test(every_reference, Wrong == []) :-
    findall(Name-Position,
            ( relation_column(Name, Position, _, _, Refers),
              Refers \== none,
              \+ kept_or_gone(Name, Position) ),
            Wrong).

%   kept_or_gone(Name, Position): retracting what a row of Name refers to is
%   refused, or takes the row along.

kept_or_gone(Name, Position) :-
    in_new_world(
        ( filled,
          relation(Name, Arity, _),
          functor(Row, Name, Arity),
          once(Row),
          dangling_target(Row, Position, Target),
          raised(once(retract_fact(Target)), F),
          (   F = model_error(referred(_, _))
          ->  call(Row), call(Target)
          ;   F == none,
              \+ call(Row), \+ call(Target)
          ),
          \+ dangling(_, _) )).

filled :-
    maplist(assert_fact,
            [ v(1,1,0,0,0), v(1,2,1,0,0), v(1,3,0,1,0), e(1,1,1,2,1),
              e(1,2,2,3,1), e(1,3,3,1,1), p(1,1,[1,2,3]), plane(1,1,0,0,1,0),
              t(1,1,1,1,2,3), leaf_v(1,1,0,0,0), leaf_e(1,1,1,2,1),
              leaf_p(1,1,[1]), leaf_t(1,1,1,1,2,3), from_v(1,1,7,7),
              from_p(1,1,7,7,1), line(1,1,1,1,2,1,1,1,2), piece(1,1,1),
              region(1,1,outside), region(1,2,cell), sides(1,1,2,1),
              from_r(1,2,7,1),
              joint(1,1,1,2,fold,90), screen(1,1,0,0,0),
              contour(1,1,1,1,0,2,0,hidden,[1],0,0,0,0),
              surface_facing(1,1,1,0,1,[1]),
              drawn(1,1,1,0,1,visible,outline) ]).

dangling_target(Row, Position, Target) :-
    functor(Row, Name, _),
    relation_column(Name, Position, _, _, Refers),
    Argument is Position+1,
    arg(Argument, Row, Value),
    (   Value = [Id|_]
    ->  true
    ;   Id = Value
    ),
    target(Refers, Id, Target),
    once(Target).

target(v, V, v(1, V, _, _, _)).
target(e, E, e(1, E, _, _, _)).
target(p, P, p(1, P, _)).
target(t, T, t(1, _, T, _, _, _)).
target(region, R, region(1, R, _)).
target(leaf_e, E, leaf_e(1, E, _, _, _)).

test(piece_of_an_outline_that_goes, N == 0) :-
    in_new_world(( filled,
                   assert_fact(drawn(2,1,-1,0,1,visible,outline)),
                   retract_fact(contour(1,1,_,_,_,_,_,_,_,_,_,_,_)),
                   count(drawn(2,_,_,_,_,_,_), N) )).
test(piece_that_is_not_there, error(existence_error(contour, 1-7), _)) :-
    in_new_world(( filled, assert_fact(drawn(2,1,-7,0,1,visible,outline)) )).

% Few edits of many rows, and many: by index and by a look at all rows.
test(strip, [forall(member(Gone, [1,3,50,700])), true(Bad == [])]) :-
    in_new_world(( strip(800),
                   findall(B, ( between(1, 12, I), edited(Gone, I, B) ),
                           Bad) )).

%   strip(N): N triangles in a row.

strip(N) :-
    facts_transaction(
        ( Vs is N+2,
          forall(between(1, Vs, V),
                 ( X is V/2, Y is V mod 2, assert_fact(v(1, V, X, Y, 0)) )),
          forall(between(1, N, P),
                 ( B is P+1, C is P+2, E is 3*P, E1 is E-1, E2 is E-2,
                   assert_fact(e(1, E2, P, B, 1)),
                   assert_fact(e(1, E1, B, C, 1)),
                   assert_fact(e(1, E, C, P, 1)),
                   assert_fact(p(1, P, [E2,E1,E])),
                   assert_fact(t(1, P, P, P, B, C)) )) )).

%   edited(Gone, I, Wrong): is that many rows' going found out, at the right
%   row, and taken back?

edited(Gone, I, Wrong) :-
    Relation is I mod 3,
    target_relation(Relation, Name),
    First is I*7,
    raised(facts_transaction(forall(between(1, Gone, K),
                                    gone(Name, First, K))),
           F),
    (   Name == p
    ->  Expected = none,
        ignore(facts_undo)
    ;   F = model_error(not_whole(Row, Missing)),
        \+ \+ Row,
        \+ \+ ( Missing =.. [_,S,Id], target(Name, Id, T), arg(1, T, S), T )
    ->  Expected = F
    ;   Expected = missed
    ),
    count(( v(_,_,_,_,_) ; e(_,_,_,_,_) ; p(_,_,_) ; t(_,_,_,_,_,_) ), N),
    (   F == Expected,
        N =:= 802+2400+800+800,
        \+ dangling(_, _)
    ->  fail
    ;   Wrong = wrong(Gone, I, F, N)
    ).

target_relation(0, v).
target_relation(1, e).
target_relation(2, p).

gone(Name, First, K) :-
    Id is (First+K) mod 790 + 1,
    target(Name, Id, Fact),
    ignore(retract_fact(Fact)).

:- end_tests(whole).
