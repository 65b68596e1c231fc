:- module(sg_provenance,
          [ vertex_from/4,              % ?S, ?V, ?S0, ?V0
            vertex_on/4,                % ?S, ?V, ?S0, ?Feature
            polygon_from/5,             % ?S, ?P, ?S0, ?P0, ?Sense
            edge_from/3,                % ?S, ?E, ?From
            operand_face/3,             % ?S, ?P, ?Operand
            operand_edge/3,             % ?S, ?E, ?Operand
            origin_feature/3            % +Origin, ?S, ?Feature
          ]).
:- use_module(csg, [is_node/1, is_helper/1, operand_segment/2]).
:- use_module('../exact', [vertex_exact/5]).
:- use_module('../store',
              [ e/5, p/3, t/6, from_v/4, from_p/5, origin/3, edge_polygon/3,
                vertex_triangle/3
              ]).
:- use_module(library(apply), [maplist/2, maplist/3]).
:- use_module(library(error), [instantiation_error/1]).
:- use_module(library(lists), [member/2]).
:- use_module(library(solution_sequences), [distinct/2]).
/** <module> Where the vertices, edges and faces of a result come from.

Over from_v/4 and from_p/5, which name the segments that were combined, also
those that only evaluation made; here these are followed to the leaves of the
tree. A placed leaf has the numbers of the leaf itself.
*/

%!  vertex_from(?S, ?V, ?S0, ?V0) is nondet.
%
%   True when vertex V of S, a node's boundary, was vertex V0 of the leaf S0.
%   A vertex that a cut made has an origin/3 instead: vertex_on/4.

vertex_from(S, V, S0, V0) :-
    from_v(S, V, S1, V1),
    (   made(S1)
    ->  vertex_from(S1, V1, S0, V0)
    ;   S0 = S1,
        V0 = V1
    ).

%!  vertex_on(?S, ?V, ?S0, ?Feature) is nondet.
%
%   True when vertex V of S, a node's boundary, came to lie on Feature of the
%   leaf S0: the vertex v(V0) or edge e(E0) or polygon p(P0) that a cut met
%   there, or that it was made to touch (contact_origins/2).

vertex_on(S, V, S0, Feature) :-
    origin(S, v(V), Origin),
    origin_feature(Origin, S1, Feature1),
    (   made(S1)
    ->  leaf_feature(Feature1, S1, S0, Feature)
    ;   S0 = S1,
        Feature = Feature1
    ).

%!  origin_feature(+Origin, ?S, ?Feature) is nondet.
%
%   True when a vertex with this Origin (origin/3) lies on Feature of segment S,
%   as it was made: S may be a helper or a node.
%
%   @error instantiation_error

origin_feature(Origin, _, _) :-
    var(Origin),
    !,
    instantiation_error(Origin).
origin_feature(near(Origin), S, Feature) :-
    !,
    origin_feature(Origin, S, Feature).
origin_feature(on(_, Places), S, Feature) :-
    !,
    member(S-Feature, Places).
origin_feature(Origin, S, Feature) :-
    Origin =.. [_|Places],
    member(S-Place, Places),
    place_feature(Place, S, Feature).

place_feature((A,B), S, Feature) :-
    integer(B),
    (   ( e(S, E, A, B, _) ; e(S, E, B, A, _) )
    ->  Feature = e(E)
    ;   vertex_triangle(S, A, T),       % between triangles of a polygon
        vertex_triangle(S, B, T)
    ->  t(S, P, T, _, _, _),
        Feature = p(P)
    ).
place_feature((A,B,C), S, p(P)) :-
    integer(B),
    once(( vertex_triangle(S, A, T),
           t(S, P, T, X, Y, Z),
           memberchk(X-Y-Z, [A-B-C,B-C-A,C-A-B]) )).
place_feature(p(P), _, p(P)).
place_feature(e(E), _, e(E)).

leaf_feature(v(V), S, S0, v(V0)) :-
    vertex_from(S, V, S0, V0).
leaf_feature(e(E), S, S0, e(E0)) :-
    leaf_edge(S, E, S0, E0).
leaf_feature(p(P), S, S0, p(P0)) :-
    once(polygon_from(S, P, S0, P0, _)).

%!  polygon_from(?S, ?P, ?S0, ?P0, ?Sense) is nondet.
%
%   True when polygon P of S, a node's boundary, has a part of polygon P0 of the
%   leaf S0, or all of it. Sense is 1 if its outside is the same, -1 if it was
%   turned over, as that of a hole is.

polygon_from(S, P, S0, P0, Sense) :-
    from_p(S, P, S1, P1, Sense1),
    (   made(S1)
    ->  polygon_from(S1, P1, S0, P0, Sense2),
        Sense is Sense1*Sense2
    ;   S0 = S1,
        P0 = P1,
        Sense = Sense1
    ).

made(S) :-
    (   is_helper(S)
    ->  true
    ;   is_node(S)
    ),
    once(from_p(S, _, _, _, _)).

%!  operand_face(?S, ?P, ?Operand) is nondet.
%
%   True when polygon P of S, a node's boundary, has a part of a face of
%   Operand: one of the operands of S, or of their operands, down to the leaves.
%   A segment that several operands use belongs to all of them.

operand_face(S, P, Operand) :-
    distinct(S-P-Operand,
             ( polygon_from(S, P, Leaf, _, _),
               operand_above(S, Leaf, Operand)
             )).

%!  operand_edge(?S, ?E, ?Operand) is nondet.
%
%   True when half-edge E of S, a node's boundary, lies on an edge of Operand,
%   or where a face of Operand meets another one. Operand is as in
%   operand_face/3.

operand_edge(S, E, Operand) :-
    distinct(S-E-Operand,
             ( edge_from(S, E, From),
               edge_leaf(From, Leaf),
               operand_above(S, Leaf, Operand)
             )).

edge_leaf(edge(S0,_), S0).
edge_leaf(cut(S1-_,_), S1).
edge_leaf(cut(_,S2-_), S2).

%   operand_above(+S, +Leaf, -Operand): Operand is Leaf, or has it among its
%   operands, and is below S.

operand_above(S, Leaf, Operand) :-
    operand_segment(Above, S),
    (   Above == Leaf
    ->  Operand = Leaf
    ;   operand_above(Above, Leaf, _)
    ->  (   Operand = Above
        ;   operand_above(Above, Leaf, Operand)
        )
    ).

%!  edge_from(?S, ?E, ?From) is nondet.
%
%   True when the half-edge E of S, a node's boundary, came about as From says:
%
%     - edge(S0, E0)
%       it is a part of the edge E0 of the leaf S0, or of its twin, or all of it
%     - cut(S1-P1, S2-P2)
%       the polygons P1 and P2 of leaves meet there; that of P1 is the one whose
%       part E borders
%
%   Decided by the origins of its ends, or else exactly by where they are.

edge_from(S, E, From) :-
    e(S, E, V1, V2, _),
    twin_polygon(S, E, V1, V2, P, Q),
    from_p(S, P, S1, P1, _),
    from_p(S, Q, S2, P2, _),
    S1-P1 \== S2-P2,
    (   S1 == S2,
        common_edge(S1, P1, P2, E1),
        on_edge(S, V1, S1, E1),
        on_edge(S, V2, S1, E1),
        leaf_edge(S1, E1, S0, E0)
    ->  From = edge(S0, E0)
    ;   leaf_polygon(S1, P1, Place1),
        leaf_polygon(S2, P2, Place2),
        From = cut(Place1, Place2)
    ).

leaf_polygon(S1, P1, S0-P0) :-
    (   made(S1)
    ->  polygon_from(S1, P1, S0, P0, _)
    ;   S0 = S1,
        P0 = P1
    ).

%   leaf_edge(S1, E1, S0, E0): E1 of S1 is edge E0 of the leaf S0, or its twin.

leaf_edge(S1, E1, S0, E0) :-
    (   made(S1)
    ->  e(S1, E1, A1, B1, _),
        from_v(S1, A1, S2, A2),
        from_v(S1, B1, S2, B2),
        once(( e(S2, E2, A2, B2, _) ; e(S2, E2, B2, A2, _) )),
        leaf_edge(S2, E2, S0, E0)
    ;   S0 = S1,
        E0 = E1
    ).

twin_polygon(S, E, V1, V2, P, Q) :-
    edge_polygon(S, E, P),
    e(S, Twin, V2, V1, _),
    edge_polygon(S, Twin, Q).

%   common_edge(S, P, Q, E): E of P has its twin in Q.

common_edge(S, P, Q, E) :-
    p(S, P, Es),
    member(E, Es),
    e(S, E, V1, V2, _),
    e(S, Twin, V2, V1, _),
    edge_polygon(S, Twin, Q).

%   on_edge(S, V, S0, E0): V of S lies on the line of edge E0 of S0.

on_edge(S, V, S0, E0) :-
    e(S0, E0, A, B, _),
    (   from_v(S, V, S0, V0),
        ( V0 == A ; V0 == B )
    ->  true
    ;   origin(S, v(V), Origin),
        names_edge(Origin, S0, E0, A, B)
    ->  true
    ;   maplist(exact_place, [S-V, S0-A, S0-B], [P, P1, P2]),
        collinear(P, P1, P2)
    ).

names_edge(near(Origin), S0, E0, A, B) :-
    !,
    names_edge(Origin, S0, E0, A, B).
names_edge(on(_, Places), S0, E0, A, B) :-
    !,
    member(S0-Feature, Places),
    (   Feature = e(E1)
    ->  ( E1 == E0 ; e(S0, E1, B, A, _) )
    ;   Feature = v(V),
        ( V == A ; V == B )
    ).
names_edge(Origin, S0, _, A, B) :-
    Origin =.. [_|Parts],
    member(S0-(C,D), Parts),
    ( C-D == A-B ; C-D == B-A ).

exact_place(S-V, p(X,Y,Z)) :-
    once(vertex_exact(S, V, X, Y, Z)).

collinear(p(X0,Y0,Z0), p(X1,Y1,Z1), p(X2,Y2,Z2)) :-
    A1 is X1-X0,
    B1 is Y1-Y0,
    C1 is Z1-Z0,
    A2 is X2-X0,
    B2 is Y2-Y0,
    C2 is Z2-Z0,
    A1*B2 =:= A2*B1,
    B1*C2 =:= B2*C1,
    C1*A2 =:= C2*A1.
