:- module(sg_polygon_list,
          [ vertex_list_edges/2,        % +List, -Edges
            edges_vertex_list/2,        % +Edges, -List
            polygon_fault/2             % +Edges, -Fault
          ]).
:- use_module(library(lists), [append/3, last/2, member/2]).
:- use_module(library(pairs), [pairs_keys/2, pairs_values/2]).
/** <module> Polygons as they are typed in: vertex lists (PL-2).

A vertex list goes counter-clockwise round the outside, seen from outside, and
clockwise round each hole. A negative number is a jump: the step to it is no
edge. A list without jumps closes itself; with jumps, every loop is closed by
writing its first vertex again.

    [1, 2, 3, 4]                        one loop of four edges
    [1, 2, 3, 4, 1, -5, 6, 7, 8, 5]     an outer loop and a hole
*/

%!  vertex_list_edges(+List, -Edges) is semidet.
%
%   Edges are the directed edges V1-V2 of the vertex list List, in its order.
%   Fails if List is empty, begins with a jump, or jumps to a vertex only to
%   jump away again.

vertex_list_edges([V|Vs], Edges) :-
    V > 0,
    steps(Vs, V, Edges0, Jumps),
    (   Jumps == true
    ->  last([V|Vs], Last),
        Last > 0,
        Edges = Edges0
    ;   last([V|Vs], V)
    ->  Edges = Edges0
    ;   last([V|Vs], Last),
        append(Edges0, [Last-V], Edges)
    ).

%   steps(Vs, From, Edges, Jumps)

steps([], _, [], _).
steps([V|Vs], From, Edges, Jumps) :-
    (   V > 0
    ->  Edges = [From-V|Edges1],
        steps(Vs, V, Edges1, Jumps)
    ;   Jumps = true,
        Vs = [Next|_],
        Next > 0,
        To is -V,
        steps(Vs, To, Edges, Jumps)
    ).

%!  edges_vertex_list(+Edges, -List) is semidet.
%
%   List is the vertex list that gives exactly Edges, in this order. Fails if
%   there is none: two loops that go through the same vertex one after the
%   other cannot be told from one loop, but then one list gives both.

edges_vertex_list(Edges, List) :-
    Edges = [A-B|Rest],
    joined(Rest, B, Tail, Jumps),
    Full = [A, B|Tail],
    (   Jumps == true
    ->  List = Full
    ;   append(List, [A], Full)
    ->  true
    ;   List = Full
    ),
    vertex_list_edges(List, Edges).

joined([], _, [], _).
joined([A-B|Rest], From, List, Jumps) :-
    (   A == From
    ->  List = [B|List1]
    ;   Jumps = true,
        Jump is -A,
        List = [Jump, B|List1]
    ),
    joined(Rest, B, List1, Jumps).

%!  polygon_fault(+Edges, -Fault) is semidet.
%
%   True when the directed edges V1-V2 in the list Edges are not the border of
%   a polygon. Fault is the first of
%
%     - edges(N): fewer than three edges
%     - no_edge(V): an edge from V to V
%     - twice(V1, V2): an edge stands twice
%     - open(V): not as many edges end at V as start there

polygon_fault(Edges, Fault) :-
    length(Edges, N),
    (   N < 3
    ->  Fault = edges(N)
    ;   member(V-V, Edges)
    ->  Fault = no_edge(V)
    ;   msort(Edges, Sorted),
        append(_, [V1-V2, V1-V2|_], Sorted)
    ->  Fault = twice(V1, V2)
    ;   unbalanced(Edges, V),
        Fault = open(V)
    ).

unbalanced(Edges, V) :-
    pairs_keys(Edges, Starts0),
    pairs_values(Edges, Ends0),
    msort(Starts0, Starts),
    msort(Ends0, Ends),
    first_difference(Starts, Ends, V).

first_difference([A|As], [B|Bs], V) :-
    (   A == B
    ->  first_difference(As, Bs, V)
    ;   V is min(A, B)
    ).
