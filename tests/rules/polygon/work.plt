:- module(test_work, []).
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(rules(store)).
:- use_module(rules(kernel)).
:- use_module(tests('rules/polygon/polygon_sample')).

/* A square with a loose vertex in the middle of side 1-2 and a hole:

       4 . . . . 3        (0,8)        (8,8)
       .  7 . 6  .
       .   . .   .           hole 5, 7, 6
       .    5    .
       1 . . . . 2        (0,0)        (8,0)
*/
points([0-0, 8-0, 8-8, 0-8, 4-2, 6-6, 2-6]).
edges([1-2, 2-3, 3-4, 4-1, 5-7, 7-6, 6-5]).

:- meta_predicate in_work(-, 0).

in_work(Work, Goal) :-
    points(Points),
    edges(Edges),
    with_edges(Points, Edges, flat, ( work_open(1, 1, Work), Goal )).

candidate(Work, V1, V2, V3) :-
    between(0, inf, N),
    (   work_candidate(Work, V1, V2, N, V)
    ->  V3 = V
    ;   !,
        fail
    ).

:- begin_tests(work).

test(edge, true(E == [1,1,2,1,1])) :-
    in_work(W, findall(X, ( work_edge(W, 1, A, B, T, L),
                            member(X, [1,A,B,T,L]) ), E)).
test(edge_all, true(Es == [1,2,3,4,5,6,7])) :-
    in_work(W, findall(E, work_edge(W, E, _, _, _, _), Es)).
test(edge_leaving, true(Ends == [7])) :-
    in_work(W, findall(V, work_edge(W, _, 5, V, _, _), Ends)).
test(edge_entering, true(Starts == [6])) :-
    in_work(W, findall(V, work_edge(W, _, V, 5, _, _), Starts)).
test(edge_pair, true(E == 6)) :-
    in_work(W, work_edge(W, E, 7, 6, _, _)).
test(edge_no_pair, fail) :-
    in_work(W, work_edge(W, _, 6, 7, _, _)).
test(edge_no_vertex, fail) :-
    in_work(W, work_edge(W, _, 99, _, _, _)).
test(edge_label, true(E == 3)) :-
    in_work(W, findall(E0, work_edge(W, E0, _, _, _, 3), [E])).
% However it is asked, given values that are there, and such that are not, the
% answers are those of all edges that agree.
test(edge_modes, forall(( member(E, [_,1,7,8]), member(A, [_,1,5,9]),
                          member(B, [_,2,7,9]), member(L, [_,3,8]) ))) :-
    in_work(W, ( findall(edge(E0,A0,B0,T0,L0), work_edge(W, E0, A0, B0, T0, L0),
                         All),
                 findall(edge(E,A,B,T,L), member(edge(E,A,B,T,L), All),
                         Wanted),
                 findall(edge(E,A,B,T,L), work_edge(W, E, A, B, T, L),
                         Found) )),
    Found == Wanted.
test(edge_type, error(type_error(integer, a))) :-
    in_work(W, work_edge(W, a, _, _, _, _)).
test(edge_pair_is_last) :-
    in_work(W, work_edge(W, _, 5, 7, _, _)).
test(edges_added_are_not_seen, true(N == 7)) :-
    in_work(W, aggregate_all(count,
                             ( work_edge(W, E, A, B, _, _),
                               work_delete(W, E),
                               work_add(W, A, B, 1, 0, _)
                             ),
                             N)).
test(oldest, true(E-A-B == 2-2-3)) :-
    in_work(W, ( work_delete(W, 1), work_oldest(W, E, A, B) )).
test(oldest_none, fail) :-
    in_work(W, ( forall(between(1, 7, E), work_delete(W, E)),
                 work_oldest(W, _, _, _) )).
test(delete_twice, error(existence_error(work_edge, 1))) :-
    in_work(W, ( work_delete(W, 1), work_delete(W, 1) )).
test(add, true(A-B-T-L == 1-3-0-(-5))) :-
    in_work(W, ( work_add(W, 1, 3, 0, -5, E), work_edge(W, E, A, B, T, L) )).
test(add_loop, error(domain_error(another_vertex, 3))) :-
    in_work(W, work_add(W, 3, 3, 1, 0, _)).
test(add_unknown, error(existence_error(work_vertex, 99))) :-
    in_work(W, work_add(W, 3, 99, 1, 0, _)).
test(add_type, error(domain_error(edge_type, 2))) :-
    in_work(W, work_add(W, 1, 3, 2, 0, _)).
test(gap, true(V == 2)) :-
    in_work(W, ( work_delete(W, 2), work_gap(W, V) )).
test(no_gap, fail) :-
    in_work(W, work_gap(W, _)).

test(meeting_only_ends, true(Met == [1-contained])) :-
    in_work(W, findall(E-How, work_meeting(W, 1, 2, E, How, _), Met)).
test(meeting_itself, true(How-Inside == contained-[])) :-
    in_work(W, work_meeting(W, 1, 2, 1, How, Inside)).
test(meeting_diagonal,
     true(Met == [5-crosses-[], 6-touches-[end], 7-touches-[start]])) :-
    in_work(W, findall(E-H-I, work_meeting(W, 1, 3, E, H, I), Met)).
test(meeting_contained, true(How-Inside == contained-[v2])) :-
    in_work(W, ( work_add(W, 1, 3, 1, 0, E),
                 work_meeting(W, 1, 6, E, How, Inside) )).
test(meeting_overlaps, true(How-Inside == overlaps-[start])) :-
    in_work(W, ( work_add(W, 6, 3, 1, 0, E),
                 work_meeting(W, 1, 3, E, How, Inside) )).
test(meeting_beyond, fail) :-
    in_work(W, ( work_add(W, 6, 3, 1, 0, E),
                 work_meeting(W, 1, 6, E, _, _) )).
test(meeting_same, error(domain_error(another_vertex, 1))) :-
    in_work(W, work_meeting(W, 1, 1, _, _, _)).

test(candidates, true(Vs == [5])) :-
    in_work(W, findall(V, candidate(W, 1, 2, V), Vs)).
test(candidate_test) :-
    in_work(W, work_candidate(W, 1, 2, 0, 5)).
test(candidate_wrong, fail) :-
    in_work(W, candidate(W, 1, 2, 3)).
test(candidate_right_side, true(Vs == [])) :-
    in_work(W, findall(V, candidate(W, 2, 1, V), Vs)).
test(triangulate, true(N == 7)) :-
    in_work(W, ( work_triangulate(W, Ts), length(Ts, N),
                 \+ work_oldest(W, _, _, _) )).
test(closed, error(existence_error(work, _))) :-
    in_work(W, ( work_close(W), work_oldest(W, _, _, _) )).
test(no_work, error(type_error(work, a))) :-
    work_oldest(a, _, _, _).
test(no_polygon, error(existence_error(polygon, 7))) :-
    in_work(_, work_open(1, 7, _)).

:- end_tests(work).
