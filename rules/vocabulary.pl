:- module(sg_vocabulary,
          [ half_edge/1,                % ?HalfEdge
            half_edge_ends/3,           % ?HalfEdge, ?V1, ?V2
            half_edge_twin/2,           % ?HalfEdge, ?Twin
            half_edge_facet/2,          % ?HalfEdge, ?Facet
            facet/1,                    % ?Facet
            facet_loops/2,              % ?Facet, -Loops
            edge_loops/2,               % +Edges, -Loops
            facet_plane/2,              % ?Facet, ?Plane
            facet_triangle/2,           % ?Facet, ?Triangle
            facet_neighbour/2,          % ?Facet, ?Neighbour
            vertex_point/2,             % ?Vertex, ?Point
            vertex_half_edge/2,         % ?Vertex, ?HalfEdge
            edge_facets/2,              % ?Edge, -Facets
            shell_facets/2              % +Facet, -Facets
          ]).
:- use_module(store, [v/5, e/5, p/3, plane/6, t/6, edge_polygon/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3, selectchk/3]).
:- use_module(library(ordsets), [ord_subtract/3, ord_union/3]).
/** <module> The words that rules speak in.

The paper's relations are storage: v, e, p, t. Rules read better over the
words of GLOSSARY.md. A thing is named by its segment and its number:

    HalfEdge = S-E      a directed edge; its twin runs the other way
    Facet    = S-P      one polygon of the model
    Vertex   = S-V
    Edge     = S-(V1,V2)  undirected, V1 < V2
*/

%!  half_edge(?HalfEdge) is nondet.

half_edge(S-E) :-
    e(S, E, _, _, _).

%!  half_edge_ends(?HalfEdge, ?V1, ?V2) is nondet.
%
%   True when HalfEdge = S-E runs from vertex V1 to V2 of its segment.

half_edge_ends(S-E, V1, V2) :-
    e(S, E, V1, V2, _).

%!  half_edge_twin(?HalfEdge, ?Twin) is nondet.
%
%   True when Twin joins the same two vertices the other way round (PL-1). On
%   the border of a surface there is none; at the seam of a penetration line
%   the twin lies in the same facet.

half_edge_twin(S-E, S-Twin) :-
    (   integer(E)
    ->  e(S, E, V1, V2, _),
        e(S, Twin, V2, V1, _)
    ;   integer(Twin)
    ->  e(S, Twin, V2, V1, _),
        e(S, E, V1, V2, _)
    ;   e(S, E, V1, V2, _),
        e(S, Twin, V2, V1, _)
    ).

%!  half_edge_facet(?HalfEdge, ?Facet) is nondet.
%
%   True when HalfEdge is in the border of Facet = S-P, or a seam in it.

half_edge_facet(S-E, S-P) :-
    edge_polygon(S, E, P).

%!  facet(?Facet) is nondet.

facet(S-P) :-
    p(S, P, _).

%!  facet_loops(?Facet, -Loops) is nondet.
%
%   True when Loops are the cycles of vertices round Facet, each a list that
%   begins with the start of its first half-edge: the outer loop
%   counter-clockwise from outside, holes clockwise (PL-3). A seam is walked
%   there and back.

facet_loops(S-P, Loops) :-
    p(S, P, Es),
    maplist(edge_ends(S), Es, Edges),
    edge_loops(Edges, Loops).

edge_ends(S, E, V1-V2) :-
    once(e(S, E, V1, V2, _)).

%!  edge_loops(+Edges:list, -Loops:list) is semidet.
%
%   Loops are the cycles of vertices that Edges, V1-V2, make, as of
%   facet_loops/2. Fails if they do not close.

edge_loops([], []).
edge_loops([V1-V2|Edges], [[V1|Loop]|Loops]) :-
    loop(V2, V1, Edges, Rest, Loop),
    edge_loops(Rest, Loops).

loop(V, V, Rest, Rest, []) :-
    !.
loop(V, First, Edges, Rest, [V|Loop]) :-
    selectchk(V-Next, Edges, Edges1),
    loop(Next, First, Edges1, Rest, Loop).

%!  facet_plane(?Facet, ?Plane) is nondet.
%
%   True when Plane = plane(Nx, Ny, Nz, D) is the plane of Facet, the normal
%   outward.

facet_plane(S-P, plane(Nx, Ny, Nz, D)) :-
    plane(S, P, Nx, Ny, Nz, D).

%!  facet_triangle(?Facet, ?Triangle) is nondet.
%
%   True when Triangle = triangle(V1, V2, V3) is one of those Facet is divided
%   into.

facet_triangle(S-P, triangle(V1, V2, V3)) :-
    t(S, P, _, V1, V2, V3).

%!  facet_neighbour(?Facet, ?Neighbour) is nondet.
%
%   True when Facet and Neighbour are two facets with a common edge, which
%   they use in opposite directions. Once for each such edge.

facet_neighbour(Facet, Neighbour) :-
    half_edge_facet(HalfEdge, Facet),
    half_edge_twin(HalfEdge, Twin),
    half_edge_facet(Twin, Neighbour),
    Neighbour \== Facet.

%!  vertex_point(?Vertex, ?Point) is nondet.
%
%   True when Point = point(X, Y, Z) is where Vertex is.

vertex_point(S-V, point(X, Y, Z)) :-
    v(S, V, X, Y, Z).

%!  vertex_half_edge(?Vertex, ?HalfEdge) is nondet.
%
%   True when HalfEdge starts at Vertex.

vertex_half_edge(S-V, S-E) :-
    e(S, E, V, _, _).

%!  edge_facets(?Edge, -Facets) is nondet.
%
%   True when Facets are the facets on both sides of Edge = S-(V1,V2), V1 <
%   V2, in the order of their numbers: two in a solid, one at a border, none
%   of a curve.

edge_facets(S-(V1, V2), Facets) :-
    e(S, E, A, B, _),
    V1 is min(A, B),
    V2 is max(A, B),
    \+ ( joins(S, A, B, E1), E1 < E ),
    findall(S-P, ( joins(S, A, B, H), edge_polygon(S, H, P) ), Facets0),
    sort(Facets0, Facets).

joins(S, A, B, E) :-
    (   e(S, E, A, B, _)
    ;   e(S, E, B, A, _)
    ).

%!  shell_facets(+Facet, -Facets) is det.
%
%   Facets are those that can be reached from Facet over common edges, Facet
%   among them, in order.

shell_facets(Facet, Facets) :-
    shell([Facet], [Facet], Facets).

shell([], Facets, Facets).
shell([Facet|Queue], Seen0, Facets) :-
    findall(Neighbour, facet_neighbour(Facet, Neighbour), Found0),
    sort(Found0, Found),
    ord_subtract(Found, Seen0, New),
    ord_union(Seen0, New, Seen),
    append(New, Queue, Queue1),
    shell(Queue1, Seen, Facets).
