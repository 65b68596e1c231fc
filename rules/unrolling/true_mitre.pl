:- module(sg_true_mitre,
          [ mitre_place/3               % +S, ?V, -Plane
          ]).
:- use_module('../csg/placed_surface',
              [placed_face/3, placed_polygon/4, placed_term/2]).
:- use_module('../primitive/primitive_pipe', [is_mitred/1]).
:- use_module('../store', [e/5, p/3, v/5, from_p/5]).
:- use_module('../vector',
              [cross_product/3, difference/3, dot_product/3, unit/2]).
:- use_module(library(lists), [member/2, nth0/3]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> The mitres of pipes of several pieces.

Two pieces of one primitive (primitive_pipe.pl) meet in a plane. The pattern of
one ends there, as a part ends at another one: so the plane is a surface that
the vertices lie on. It goes through those of the primitive itself, wherever
that is placed; also if others have trimmed it.
*/

%!  mitre_place(+S, ?V, -Plane) is nondet.
%
%   Vertex V of segment S, a primitive or made of some, lies where two pieces of
%   one primitive meet, in Plane.

mitre_place(S, V, Plane) :-
    leaf_of(S, Leaf),
    placed_term(Leaf, Term),
    is_mitred(Term),
    findall(Pair-W, shared_vertex(Leaf, Leaf, Pair, W), All0),
    sort(All0, All),
    group_pairs_by_key(All, Groups),
    (   S == Leaf
    ->  Own = All
    ;   findall(Pair-W, shared_vertex(S, Leaf, Pair, W), Own0),
        sort(Own0, Own)
    ),
    member(Pair-Ws, Groups),
    plane_of(Leaf, Ws, Plane),
    member(Pair-V, Own).

%   leaf_of(S, Leaf): S is made of Leaf, or is Leaf itself. Each leaf is an
%   answer once, not once for each facet.

leaf_of(S, Leaf) :-
    (   from_p(S, _, _, _, _)
    ->  findall(Leaf0, placed_polygon(S, _, Leaf0, _), Leaves0),
        sort(Leaves0, Leaves),
        member(Leaf, Leaves)
    ;   Leaf = S
    ).

%   shared_vertex(S, Leaf, I-J, V): V is a corner of facets of both pieces.

shared_vertex(S, Leaf, Pair, V) :-
    findall(V0-I, corner_of(S, Leaf, V0, I), Corners0),
    sort(Corners0, Corners),
    group_pairs_by_key(Corners, Groups),
    member(V-Is, Groups),
    member(I, Is),
    member(J, Is),
    I @< J,
    Pair = I-J.

corner_of(S, Leaf, V, I) :-
    p(S, P, Es),
    (   S == Leaf
    ->  P0 = P
    ;   placed_polygon(S, P, Leaf, P0)
    ),
    placed_face(Leaf, P0, curved(piece(I), _)),
    member(E, Es),
    e(S, E, V, _, _).

%   plane_of(Leaf, Vs, Plane): through three that are far from each other.

plane_of(Leaf, Vs, plane(A,B,C,D)) :-
    length(Vs, N),
    I is N//3,
    J is (2*N)//3,
    findall(Place,
            ( member(K, [0,I,J]), nth0(K, Vs, V), v(Leaf, V, X, Y, Z),
              Place = p(X,Y,Z) ),
            [P,Q,R]),
    difference(Q, P, PQ),
    difference(R, P, PR),
    cross_product(PQ, PR, Normal),
    unit(Normal, p(A,B,C)),
    dot_product(p(A,B,C), P, Far),
    D is -Far.
