:- module(sg_glue_wire,
          [ wires_written/3             % +S, +Curves, +Reach
          ]).
:- use_module('../store',
              [ v/5, e/5, t/6, edge_polygon/3, lies_in/3, assert_fact/1,
                fresh_id/3
              ]).
:- use_module('../vector', [cross_product/3, difference/3, dot_product/3]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(pairs), [pairs_values/2]).
/** <module> Wires among faces that are glued (NG-5).

The edges of curves become wires: divided where they go through vertices and
faces. An end on a vertex is that vertex; an end in the middle of a face, and
where a wire goes through one, is a point loop of it. What runs along an edge of
a face is that edge. Decided by the rationals of the doubles of v/5, which the
regions are decided by.

@see docs/limits.md for what wires do not do
*/

%!  wires_written(+S, +Curves:list, +Reach) is det.
%
%   Add the edges and the lone vertices of the segments Curves to the faces of
%   segment S, with from_v/4 and lies_in/3. Vertices no farther apart than Reach
%   are one.
%
%   @error geometry_error(glue_wire(S0, E0, P)): edge E0 of curve S0 meets the
%          border of polygon P of S beside its vertices, or runs in P

wires_written(_, [], _) :-
    !.
wires_written(S, Curves, Reach0) :-
    Reach is rational(Reach0),
    findall(triangle(P, V1-A, V2-B, V3-C),
            ( t(S, P, _, V1, V2, V3),
              place(S, V1, A),
              place(S, V2, B),
              place(S, V3, C) ),
            Triangles),
    maplist(curve_written(S, Reach, Triangles), Curves).

place(S, V, p(X,Y,Z)) :-
    once(v(S, V, X0, Y0, Z0)),
    X is rational(X0),
    Y is rational(Y0),
    Z is rational(Z0).

curve_written(S, Reach, Triangles, S0) :-
    findall(V0-V, curve_vertex(S, Reach, Triangles, S0, V0, V), Known),
    findall(E0-(V1-V2),
            ( e(S0, E0, A0, B0, 1),
              memberchk(A0-V1, Known),
              memberchk(B0-V2, Known) ),
            Edges),
    maplist(edge_written(S, S0, Reach, Triangles), Edges).

%   curve_vertex(S, Reach, Triangles, S0, V0, V): V of S, there or new, is where
%   V0 of S0 is.

curve_vertex(S, Reach, Triangles, S0, V0, V) :-
    v(S0, V0, X, Y, Z),
    (   near_vertex(S, Reach, X, Y, Z, V1)
    ->  V = V1
    ;   vertex_added(S, X, Y, Z, V),
        assert_fact(from_v(S, V, S0, V0)),
        place(S, V, At),
        point_noted(S, S0-V0, Reach, V, At, Triangles)
    ).

near_vertex(S, _, X, Y, Z, V) :-
    v(S, V, X, Y, Z),
    !.
near_vertex(S, Reach, X, Y, Z, V) :-
    v(S, V, X1, Y1, Z1),
    (X1-X)**2+(Y1-Y)**2+(Z1-Z)**2 =< Reach*Reach,
    !.

vertex_added(S, X, Y, Z, V) :-
    fresh_id(v, S, V),
    assert_fact(v(S, V, X, Y, Z)).

%   point_noted(S, S0-V0, Reach, V, At, Triangles): V, which is no corner, may
%   lie in a face.

point_noted(S, S0-V0, Reach, V, At, Triangles) :-
    forall(( member(Triangle, Triangles),
             in_triangle(S, wire(S0, V0), Reach, At, Triangle, P),
             \+ lies_in(S, v(V), p(P)) ),
           assert_fact(lies_in(S, v(V), p(P)))).

in_triangle(S, Wire, Reach, At, Triangle, P) :-
    Triangle = triangle(P, _-A, _-B, _-C),
    normal(A, B, C, N),
    side(N, A, At, Side),
    dot_product(N, N, Length),
    Side*Side =< Reach*Reach*Length,
    between_sides(N, At, A, B, C),
    inside_polygon(S, Wire, Triangle, N, At).

normal(A, B, C, N) :-
    difference(B, A, U),
    difference(C, A, W),
    cross_product(U, W, N).

between_sides(N, At, A, B, C) :-
    left_of(N, A, B, At),
    left_of(N, B, C, At),
    left_of(N, C, A, At).

left_of(N, A, B, At) :-
    along(N, A, B, At, Side),
    Side >= 0.

%   along(N, A, B, At, Side): positive if At is left of the line from A to B, as
%   seen from where N points.

along(N, A, B, At, Side) :-
    difference(B, A, U),
    difference(At, A, W),
    cross_product(U, W, X),
    dot_product(N, X, Side).


                /*******************************
                *             EDGES            *
                *******************************/

edge_written(S, S0, Reach, Triangles, E0-(V1-V2)) :-
    through_vertices(S, Reach, V1, V2, Vs),
    append(Vs, [V2], Ends),
    foldl(part_written(S, wire(S0, E0), Triangles), Ends, V1, _).

%   through_vertices(S, Reach, V1, V2, Vs): the vertices of S between V1 and V2,
%   in order.

through_vertices(S, Reach, V1, V2, Vs) :-
    place(S, V1, A),
    place(S, V2, B),
    difference(B, A, D),
    dot_product(D, D, Length),
    findall(Along-V,
            ( v(S, V, _, _, _),
              V =\= V1,
              V =\= V2,
              place(S, V, Q),
              difference(Q, A, W),
              dot_product(W, D, Along),
              Along > 0,
              Along < Length,
              cross_product(W, D, X),
              dot_product(X, X, Off),
              Off =< Reach*Reach*Length ),
            Pairs0),
    keysort(Pairs0, Pairs),
    pairs_values(Pairs, Vs).

%   part_written(S, Wire, Triangles, V2, V1, V2): from V1 to V2, if that is no
%   edge.

part_written(S, Wire, Triangles, V2, V1, V2) :-
    (   V1 =:= V2
    ->  true
    ;   an_edge(S, V1, V2)
    ->  true
    ;   place(S, V1, A),
        place(S, V2, B),
        findall(T-P,
                ( pierced(S, Wire, A, B, Triangles, T, P),
                  \+ lies_in(S, v(V1), p(P)),
                  \+ lies_in(S, v(V2), p(P)) ),
                Through0),
        sort(Through0, Through),
        pierced_written(Through, S, A, B, V1, V2)
    ).

an_edge(S, V1, V2) :-
    (   e(S, _, V1, V2, _)
    ;   e(S, _, V2, V1, _)
    ),
    !.

%   pierced(S, Wire, A, B, Triangles, T, P): polygon P is gone through at
%   A+T*(B-A).

pierced(S, Wire, A, B, Triangles, T, P) :-
    member(Triangle, Triangles),
    Triangle = triangle(P, _-C1, _-C2, _-C3),
    normal(C1, C2, C3, N),
    side(N, C1, A, S1),
    side(N, C1, B, S2),
    (   S1 =:= 0,
        S2 =:= 0
    ->  beside(Wire, A, B, N, Triangle),
        fail
    ;   sign(S1)*sign(S2) < 0
    ),
    T is S1 rdiv (S1-S2),
    point_at(A, B, T, Q),
    between_sides(N, Q, C1, C2, C3),
    inside_polygon(S, Wire, Triangle, N, Q).

side(N, C, At, Side) :-
    difference(At, C, D),
    dot_product(N, D, Side).

point_at(p(X1,Y1,Z1), p(X2,Y2,Z2), T, p(X,Y,Z)) :-
    X is X1+T*(X2-X1),
    Y is Y1+T*(Y2-Y1),
    Z is Z1+T*(Z2-Z1).

%   inside_polygon(S, Wire, Triangle, N, Q): Q, on Triangle, is on no edge of
%   its polygon.

inside_polygon(S, Wire, triangle(P, V1-A, V2-B, V3-C), N, Q) :-
    forall(( member(side(V,From,W,To),
                    [side(V1,A,V2,B),side(V2,B,V3,C),side(V3,C,V1,A)]),
             along(N, From, To, Q, 0),
             border(S, P, V, W) ),
           refused(Wire, P)).

border(S, P, V, W) :-
    (   e(S, E, V, W, _)
    ;   e(S, E, W, V, _)
    ),
    edge_polygon(S, E, P),
    !.

refused(wire(S0, E0), P) :-
    throw(error(geometry_error(glue_wire(S0, E0, P)), _)).

%   beside(Wire, A, B, N, Triangle): a wire in the plane of Triangle has no
%   point inside it: one of its sides, or the wire, is between them.

beside(Wire, A, B, N, triangle(P, _-C1, _-C2, _-C3)) :-
    (   member(From-To, [C1-C2,C2-C3,C3-C1]),
        along(N, From, To, A, S1),
        S1 =< 0,
        along(N, From, To, B, S2),
        S2 =< 0
    ->  true
    ;   maplist(along(N, A, B), [C1,C2,C3], Sides),
        (   forall(member(Side, Sides), Side >= 0)
        ->  true
        ;   forall(member(Side, Sides), Side =< 0)
        )
    ->  true
    ;   refused(Wire, P)
    ).

%   pierced_written(Through, S, A, B, V1, V2): the parts of a wire between the
%   faces that it goes through.

pierced_written([], S, _, _, V1, V2) :-
    fresh_id(e, S, E),
    assert_fact(e(S, E, V1, V2, 1)).
pierced_written([T-P|Through0], S, A, B, V1, V2) :-
    point_at(A, B, T, p(X0,Y0,Z0)),
    X is float(X0)+0.0,
    Y is float(Y0)+0.0,
    Z is float(Z0)+0.0,
    vertex_added(S, X, Y, Z, V),
    same_place(Through0, T, Ps, Through),
    forall(member(Q, [P|Ps]), assert_fact(lies_in(S, v(V), p(Q)))),
    fresh_id(e, S, E),
    assert_fact(e(S, E, V1, V, 1)),
    pierced_written(Through, S, A, B, V, V2).

same_place([T-P|Through0], T, [P|Ps], Through) :-
    !,
    same_place(Through0, T, Ps, Through).
same_place(Through, _, [], Through).
