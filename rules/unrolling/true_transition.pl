:- module(sg_true_transition,
          [ transition_points/3         % +Facets, +Shape, -Pairs
          ]).
:- use_module('../near', [same_angle/2]).
:- use_module(true_shape, [key_place/4]).
:- use_module('../vector',
              [ cross_product/3, difference/3, dot_product/3, unit/2,
                vector_sum/3
              ]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(assoc),
              [assoc_to_list/2, get_assoc/3, list_to_assoc/2, put_assoc/4]).
:- use_module(library(lists), [member/2, selectchk/3]).
/** <module> A transition laid flat, facet by facet.

Between two ellipses of different proportions lies no surface that unrolls: its
generators turn as they go. The trade divides it into triangles by generators
and diagonals, and lays these out by the true lengths of their sides. So its
development is that of its facets, one beside the other.
*/

%!  transition_points(+Facets, +Shape, -Pairs) is det.
%
%   Pairs is the list of Key-(X-Y) for all keys of Facets. The first generator
%   stands upright.

transition_points(Facets, Shape, Pairs) :-
    Shape = shape(_, _, Nodes),
    maplist(facet_sort, Facets, Sorted0),
    keysort(Sorted0, Sorted),
    findall(Facet, member(_-Facet, Sorted), InOrder),
    first_laid(InOrder, Nodes, Placed0),
    all_laid(InOrder, Nodes, Placed0, Placed),
    assoc_to_list(Placed, Pairs).

facet_sort(Facet, T-Facet) :-
    Facet = facet(_, T, _, _).

%   The half-edge along the first generator goes down, or up, along the y axis.

first_laid(Facets, Nodes, Placed) :-
    member(facet(_, T, _, Halves), Facets),
    member(half(A, B, _), Halves),
    key_place(Nodes, A, T1, H1),
    key_place(Nodes, B, T2, H2),
    same_angle(T1, T),
    same_angle(T2, T),
    !,
    space_point(Nodes, A, P),
    space_point(Nodes, B, Q),
    difference(Q, P, D),
    dot_product(D, D, Square),
    Length is sqrt(Square),
    (   H1 > H2
    ->  list_to_assoc([A-(0.0-Length),B-(0.0-0.0)], Placed)
    ;   list_to_assoc([A-(0.0-0.0),B-(0.0-Length)], Placed)
    ).

%   all_laid(Facets, Nodes, Placed0, Placed): always the first that has an edge
%   in the pattern already; a part of its own is laid where it is.

all_laid([], _, Placed, Placed) :-
    !.
all_laid(Facets0, Nodes, Placed0, Placed) :-
    member(Facet, Facets0),
    Facet = facet(_, _, _, Halves),
    member(half(A, B, _), Halves),
    get_assoc(A, Placed0, _),
    get_assoc(B, Placed0, _),
    !,
    selectchk(Facet, Facets0, Facets),
    facet_laid(Halves, A, B, Nodes, Placed0, Placed1),
    all_laid(Facets, Nodes, Placed1, Placed).

%   facet_laid(Halves, A, B, Nodes, Placed0, Placed): each vertex by how far it
%   is along A-B and to the left of it, in the plane of the facet.

facet_laid(Halves, A, B, Nodes, Placed0, Placed) :-
    space_point(Nodes, A, P),
    space_point(Nodes, B, Q),
    difference(Q, P, Way),
    unit(Way, Along),
    normal(Halves, Nodes, Normal),
    cross_product(Normal, Along, Left),
    get_assoc(A, Placed0, AX-AY),
    get_assoc(B, Placed0, BX-BY),
    Length is sqrt((BX-AX)**2 + (BY-AY)**2),
    CX is (BX-AX)/Length,
    CY is (BY-AY)/Length,
    foldl(vertex_laid(Nodes, P, Along, Left, AX-AY, CX-CY), Halves,
          Placed0, Placed).

vertex_laid(Nodes, P, Along, Left, AX-AY, CX-CY, half(Key, _, _), Placed0,
            Placed) :-
    (   get_assoc(Key, Placed0, _)
    ->  Placed = Placed0
    ;   space_point(Nodes, Key, R),
        difference(R, P, D),
        dot_product(D, Along, U),
        dot_product(D, Left, V),
        X is AX + U*CX - V*CY,
        Y is AY + U*CY + V*CX,
        put_assoc(Key, Placed0, X-Y, Placed)
    ).

space_point(Nodes, k(Id, _), p(X,Y,Z)) :-
    get_assoc(Id, Nodes, node(_, _, point(X,Y,Z), _)).

%   normal(Halves, Nodes, Normal): unit, by the cross products of the half-edges
%   seen from one of them.

normal(Halves, Nodes, Normal) :-
    Halves = [half(First, _, _)|_],
    space_point(Nodes, First, O),
    foldl(half_cross(Nodes, O), Halves, p(0.0,0.0,0.0), Sum),
    unit(Sum, Normal).

half_cross(Nodes, O, half(A, B, _), Sum0, Sum) :-
    space_point(Nodes, A, P),
    space_point(Nodes, B, Q),
    difference(P, O, U),
    difference(Q, O, V),
    cross_product(U, V, W),
    vector_sum(Sum0, W, Sum).
