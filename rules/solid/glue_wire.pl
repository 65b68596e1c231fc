:- module(sg_glue_wire,
          [ wires_written/3             % +S, +Curves, +Reach
          ]).
:- use_module(glue_divide,
              [ edge_divided/5, seam_added/4, polygons_divided/2, is_edge/3,
                has_vertex/3 ]).
:- use_module('../gluing/triangle_corners', [rational_place/3]).
:- use_module('../near', [boxes_near/3]).
:- use_module('../store',
              [ v/5, e/5, t/6, lies_in/3, assert_fact/1, fresh_id/3 ]).
:- use_module('../vector',
              [ cross_product/3, difference/3, dot_product/3, left_of/4,
                scaled/3, vector_sum/3 ]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3, maplist/4]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(pairs), [pairs_values/2]).
/** <module> Wires among faces that are glued (NG-5).

The edges of curves become wires: divided where they go through vertices, edges
of faces and other wires, and through faces. An end on a vertex is that vertex.
An end in the middle of a face, and where a wire goes through one, is a point
loop of it. What runs in a face is a seam of it, or parts it (glue_divide.pl);
what runs along an edge is that edge. Decided by the rationals of the doubles of
v/5, which the regions are decided by; what is no farther apart than the
tolerance is in one place.
*/

%!  wires_written(+S, +Curves:list, +Reach) is det.
%
%   Add the edges and the lone vertices of the segments Curves to the faces of
%   segment S, with from_v/4 and lies_in/3. What is no farther apart than Reach
%   is one.
%
%   @error geometry_error(wrong_triangles(S, P)): of polygons_divided/2

wires_written(_, [], _) :-
    !.
wires_written(S, Curves, Reach0) :-
    Reach is rational(Reach0),
    findall(triangle(P, A, B, C, Box),
            ( t(S, P, _, V1, V2, V3),
              maplist(rational_place(S), [V1,V2,V3], [A,B,C]),
              points_box([A,B,C], Box) ),
            Triangles),
    foldl(curve_written(S, Reach, Triangles), Curves, [], Changed0),
    sort(Changed0, Changed),
    polygons_divided(S, Changed).

curve_written(S, Reach, Triangles, S0, Changed0, Changed) :-
    findall(V0-At, ( v(S0, V0, _, _, _), rational_place(S0, V0, At) ), Places),
    foldl(vertex_taken(S, Reach, Triangles, S0), Places, []-Changed0,
          Known-Changed1),
    findall(V1-V2,
            ( e(S0, _, A0, B0, 1),
              memberchk(A0-V1, Known),
              memberchk(B0-V2, Known) ),
            Edges),
    foldl(edge_written(S, Reach, Triangles), Edges, Changed1, Changed).

%   vertex_taken(S, Reach, Triangles, S0, V0-At, ...): V of S, there or new, is
%   where V0 of S0 is.

vertex_taken(S, Reach, Triangles, S0, V0-At, Known-Changed0,
             [V0-V|Known]-Changed) :-
    (   near_vertex(S, Reach, At, V)
    ->  Changed = Changed0
    ;   vertex_added(S, At, V),
        assert_fact(from_v(S, V, S0, V0)),
        point_noted(S, Reach, Triangles, V, At, Changed0, Changed)
    ).

%   near_vertex(S, Reach, At, V): the nearest.

near_vertex(S, Reach, At, V) :-
    findall(Square-V1,
            ( v(S, V1, _, _, _),
              rational_place(S, V1, Place),
              square_between(At, Place, Square),
              Square =< Reach*Reach ),
            Near0),
    keysort(Near0, [_-V|_]).

square_between(A, B, Square) :-
    difference(A, B, D),
    dot_product(D, D, Square).

vertex_added(S, p(X0,Y0,Z0), V) :-
    fresh_id(v, S, V),
    X is float(X0),
    Y is float(Y0),
    Z is float(Z0),
    assert_fact(v(S, V, X, Y, Z)).

%   point_noted(S, Reach, Triangles, V, At, Changed0, Changed): the new vertex V
%   divides the edges that it is on; else it may lie in faces.

point_noted(S, Reach, Triangles, V, At, Changed0, Changed) :-
    findall(V1-V2,
            ( an_edge(S, V1, V2),
              V1 =\= V,
              V2 =\= V,
              rational_place(S, V1, A),
              rational_place(S, V2, B),
              on_way(A, B, At, Reach, _) ),
            Edges0),
    sort(Edges0, Edges),
    foldl(edge_divided(S, V), Edges, Changed0, Changed),
    forall(( in_triangle(Triangles, Reach, At, P),
             \+ has_vertex(S, P, V),
             \+ lies_in(S, v(V), p(P)) ),
           assert_fact(lies_in(S, v(V), p(P)))).

%   an_edge(S, V1, V2): V1 < V2, as often as there are half-edges.

an_edge(S, V1, V2) :-
    e(S, _, A, B, _),
    V1 is min(A, B),
    V2 is max(A, B).

%   on_way(A, B, At, Reach, Along): At is on the way from A to B, not at its
%   ends; Along grows with how far.

on_way(A, B, At, Reach, Along) :-
    difference(B, A, D),
    difference(At, A, W),
    dot_product(W, D, Along),
    Along > 0,
    dot_product(D, D, Length),
    Along < Length,
    cross_product(W, D, X),
    dot_product(X, X, Off),
    Off =< Reach*Reach*Length.

%   in_triangle(Triangles, Reach, At, P): At is in a triangle of polygon P.

in_triangle(Triangles, Reach, At, P) :-
    points_box([At], Box),
    member(triangle(P, A, B, C, Around), Triangles),
    boxes_near(Box, Around, Reach),
    normal(A, B, C, N),
    near_plane(N, A, At, Reach, _),
    between_sides(N, At, A, B, C).

normal(A, B, C, N) :-
    difference(B, A, U),
    difference(C, A, W),
    cross_product(U, W, N).

near_plane(N, A, At, Reach, Side) :-
    difference(At, A, D),
    dot_product(N, D, Side),
    dot_product(N, N, Length),
    Side*Side =< Reach*Reach*Length.

between_sides(N, At, A, B, C) :-
    left_of(N, A, B, At),
    left_of(N, B, C, At),
    left_of(N, C, A, At).

%   Boxes are of doubles, so that most triangles are told apart at once.

points_box(Points, box(X1,Y1,Z1,X2,Y2,Z2)) :-
    findall(X, member(p(X,_,_), Points), Xs),
    findall(Y, member(p(_,Y,_), Points), Ys),
    findall(Z, member(p(_,_,Z), Points), Zs),
    maplist(extent, [Xs,Ys,Zs], [X1,Y1,Z1], [X2,Y2,Z2]).

extent(Ns, Low, High) :-
    msort(Ns, [Low0|_]),
    sort(0, @>=, Ns, [High0|_]),
    Low is float(Low0),
    High is float(High0).


                /*******************************
                *             EDGES            *
                *******************************/

%   edge_written(S, Reach, Triangles, V1-V2, Changed0, Changed): first it is
%   divided where it crosses edges, which it divides, then at all vertices.

edge_written(S, Reach, Triangles, V1-V2, Changed0, Changed) :-
    rational_place(S, V1, A),
    rational_place(S, V2, B),
    findall(At-edges(Edge), crossed(S, Reach, A, B, Edge, At), Crossed),
    foldl(crossing_divided(S, Reach), Crossed, Changed0, Changed1),
    findall(Along-V,
            ( v(S, V, _, _, _),
              V =\= V1,
              V =\= V2,
              rational_place(S, V, Q),
              on_way(A, B, Q, Reach, Along) ),
            Pairs0),
    keysort(Pairs0, Pairs),
    pairs_values(Pairs, Vs),
    append(Vs, [V2], Ends),
    foldl(part_written(S, Reach, Triangles), Ends, V1-Changed1, _-Changed).

%   crossed(S, Reach, A, B, V1-V2, At): the way from A to B passes edge V1-V2 of
%   S at At, and neither ends there.

crossed(S, Reach, A, B, V1-V2, At) :-
    points_box([A,B], Box),
    findall(V1-V2, an_edge(S, V1, V2), Edges0),
    sort(Edges0, Edges),
    member(V1-V2, Edges),
    rational_place(S, V1, C),
    rational_place(S, V2, D),
    points_box([C,D], Around),
    boxes_near(Box, Around, Reach),
    \+ in_line(A, B, C, D, Reach),
    \+ in_line(C, D, A, B, Reach),
    passing(A, B, C, D, At1, At2),
    square_between(At1, At2, Square),
    Square =< Reach*Reach,
    \+ ( member(End, [A,B]), square_between(End, At2, Near),
         Near =< Reach*Reach ),
    \+ ( member(End, [C,D]), square_between(End, At1, Near),
         Near =< Reach*Reach ),
    vector_sum(At1, At2, Twice),
    scaled(1r2, Twice, At).

%   in_line(A, B, C, D, Reach): C and D are on the line through A and B, so what
%   is between meets it in no one point.

in_line(A, B, C, D, Reach) :-
    difference(B, A, Way),
    dot_product(Way, Way, Length),
    \+ ( member(End, [C,D]),
         difference(End, A, W),
         cross_product(W, Way, X),
         dot_product(X, X, Off),
         Off > Reach*Reach*Length ).

%   passing(A, B, C, D, At1, At2): where lines through A and B, and C and D, are
%   nearest, between these ends.

passing(A, B, C, D, At1, At2) :-
    difference(B, A, U),
    difference(D, C, V),
    difference(C, A, W),
    maplist(dot_product, [U,U,V], [U,V,V], [UU,UV,VV]),
    maplist(dot_product(W), [U,V], [WU,WV]),
    Cross is UU*VV-UV*UV,
    Cross > 0,
    T is (WU*VV-WV*UV) rdiv Cross,
    T > 0,
    T < 1,
    K is (WU*UV-WV*UU) rdiv Cross,
    K > 0,
    K < 1,
    point_at(A, B, T, At1),
    point_at(C, D, K, At2).

crossing_divided(S, Reach, At-edges(Edge), Changed0, Changed) :-
    (   near_vertex(S, Reach, At, V)
    ->  true
    ;   vertex_added(S, At, V)
    ),
    edge_divided(S, V, Edge, Changed0, Changed).

%   part_written(S, Reach, Triangles, V2, V1-Changed0, V2-Changed): from V1 to
%   V2, if that is no edge.

part_written(S, Reach, Triangles, V2, V1-Changed0, V2-Changed) :-
    rational_place(S, V1, A),
    rational_place(S, V2, B),
    (   ( V1 =:= V2 ; is_edge(S, V1, V2) )
    ->  Changed = Changed0
    ;   runs_in(Triangles, Reach, A, B, P)
    ->  seam_added(S, P, V1, V2),
        Changed = [P|Changed0]
    ;   Changed = Changed0,
        findall(T-P, pierced(Triangles, Reach, A, B, T, P), Through0),
        sort(Through0, Through),
        pierced_written(Through, S, A, B, V1, V2)
    ).

%   runs_in(Triangles, Reach, A, B, P): both ends are in the plane of polygon P,
%   and the middle is in P: as nothing is met in between, all is.

runs_in(Triangles, Reach, A, B, P) :-
    vector_sum(A, B, Twice),
    scaled(1r2, Twice, Middle),
    points_box([Middle], Box),
    member(triangle(P, C1, C2, C3, Around), Triangles),
    boxes_near(Box, Around, Reach),
    normal(C1, C2, C3, N),
    near_plane(N, C1, A, Reach, _),
    near_plane(N, C1, B, Reach, _),
    between_sides(N, Middle, C1, C2, C3),
    !.

%   pierced(Triangles, Reach, A, B, T, P): polygon P is gone through at
%   A+T*(B-A), not at an end.

pierced(Triangles, Reach, A, B, T, P) :-
    points_box([A,B], Box),
    member(triangle(P, C1, C2, C3, Around), Triangles),
    boxes_near(Box, Around, Reach),
    normal(C1, C2, C3, N),
    side(N, C1, A, S1),
    side(N, C1, B, S2),
    sign(S1)*sign(S2) < 0,
    T is S1 rdiv (S1-S2),
    point_at(A, B, T, Q),
    between_sides(N, Q, C1, C2, C3),
    \+ ( member(End, [A,B]), square_between(End, Q, Square),
         Square =< Reach*Reach ).

side(N, C, At, Side) :-
    difference(At, C, D),
    dot_product(N, D, Side).

point_at(A, B, T, At) :-
    difference(B, A, D),
    scaled(T, D, Way),
    vector_sum(A, Way, At).

%   pierced_written(Through, S, A, B, V1, V2): the parts of a wire between the
%   faces that it goes through.

pierced_written([], S, _, _, V1, V2) :-
    fresh_id(e, S, E),
    assert_fact(e(S, E, V1, V2, 1)).
pierced_written([T-P|Through0], S, A, B, V1, V2) :-
    point_at(A, B, T, At),
    vertex_added(S, At, V),
    same_place(Through0, T, Ps, Through),
    forall(member(Q, [P|Ps]), assert_fact(lies_in(S, v(V), p(Q)))),
    fresh_id(e, S, E),
    assert_fact(e(S, E, V1, V, 1)),
    pierced_written(Through, S, A, B, V, V2).

same_place([T-P|Through0], T, [P|Ps], Through) :-
    !,
    same_place(Through0, T, Ps, Through).
same_place(Through, _, [], Through).
