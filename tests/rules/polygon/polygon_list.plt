:- module(test_polygon_list, []).

:- use_module(library(plunit)).
:- use_module(rules(kernel)).
:- use_module(rules(polygon/polygon_list)).
:- use_module(rules(store)).
:- begin_tests(polygon_list).

test(closes_itself, Es == [1-2, 2-3, 3-1]) :-
    vertex_list_edges([1,2,3], Es).
test(closed_by_hand, Es == [1-2, 2-3, 3-1]) :-
    vertex_list_edges([1,2,3,1], Es).
test(hollow_of_figure_3, Es == [1-2,2-3,3-4,4-1,5-6,6-7,7-8,8-5]) :-
    vertex_list_edges([1,2,3,4,1,-5,6,7,8,5], Es).
test(open_after_jump, Es == [1-2,2-3,4-5,5-6]) :-
    vertex_list_edges([1,2,3,-4,5,6], Es).
test(begins_with_jump, fail) :-
    vertex_list_edges([-1,2,3], _).
test(no_vertex, fail) :-
    vertex_list_edges([0,2,3], _).
test(ends_with_jump, fail) :-
    vertex_list_edges([1,2,3,1,-4], _).
test(jump_to_nothing, fail) :-
    vertex_list_edges([1,2,3,1,-4,-5,6], _).
test(empty, fail) :-
    vertex_list_edges([], _).

test(no_fault, fail) :-
    polygon_fault([1-2,2-3,3-1], _).
test(seam, fail) :-
    polygon_fault([1-2,2-3,3-1,2-4,4-2], _).
test(few, F == edges(2)) :-
    polygon_fault([1-2,2-1], F).
test(same_vertex, F == no_edge(3)) :-
    polygon_fault([1-2,2-3,3-3,3-1], F).
test(stands_twice, F == twice(1,2)) :-
    polygon_fault([1-2,2-1,1-2,2-1], F).
test(open, F == open(1)) :-
    polygon_fault([1-2,2-3,3-4], F).

test(there_and_back, forall(sample(300, List))) :-
    vertex_list_edges(List, Edges),
    edges_vertex_list(Edges, List2),
    vertex_list_edges(List2, Edges).

%   Loops of 3 to 6 of the vertices 1..12, closed.

sample(N, List) :-
    set_random(seed(1988)),
    between(1, N, _),
    random_between(1, 3, Loops),
    length(Ls, Loops),
    maplist(random_loop, Ls),
    joined_loops(Ls, List).

random_loop(Loop) :-
    random_between(3, 6, K),
    randset(K, 12, Set),
    random_permutation(Set, Loop).

%   The kernel takes the lists that are polygons, and makes their edges.

test(as_the_kernel, forall(sample(60, List0))) :-
    forall(( List = List0 ; damaged(List0, List) ),
           (   vertex_list_edges(List, Edges),
               forall(member(V, List), ( N is abs(V), between(1, 12, N) )),
               \+ polygon_fault(Edges, _)
           ->  written_edges(List, Edges)
           ;   \+ written_edges(List, _)
           )).

written_edges(List, Edges) :-
    numlist(1, 12, Vs),
    maplist([V,point(V,0,0)]>>true, Vs, Points),
    new_world(World),
    in_world(World,
             ( shape_write(5, Points, [[3,2,1],List], true),
               p(5, 2, Es),
               findall(V1-V2, ( member(E, Es), e(5, E, V1, V2, 1) ), Edges),
               findall(V, v(5, V, _, _, _), Vs),
               findall(E, e(5, E, _, _, _), [1,2,3|Es])
             )).

%   One number of the list is missing, stands twice, is another vertex or none,
%   or has the other sign.

damaged(List0, List) :-
    append(Before, [V|After], List0),
    W is -V,
    member(Vs, [[],[V,V],[1],[13],[0],[W]]),
    append([Before,Vs,After], List).

test(a_run_of_edges, Edges-Ps == [1-2,2-1,1-3]-[]) :-
    new_world(World),
    in_world(World,
             ( shape_write(1, [point(0,0,0),point(1,0,0),point(0,1,0)],
                           [[1,2,1],[3],[1,3]], false),
               findall(V1-V2, e(1, _, V1, V2, _), Edges),
               findall(P, p(1, P, _), Ps) )).
test(far, error(domain_error(coordinate, -2.0e90))) :-
    new_world(World),
    in_world(World, shape_write(1, [point(0,0,0),point(1,-2.0e90,0)], [],
                                true)).

joined_loops([Loop], Loop) :- !.
joined_loops(Loops, List) :-
    maplist(closed_loop, Loops, [First|Rest]),
    maplist([[V|Vs], [J|Vs]]>>(J is -V), Rest, Jumped),
    append([First|Jumped], List).

closed_loop([V|Vs], Loop) :-
    append([V|Vs], [V], Loop).

:- end_tests(polygon_list).
