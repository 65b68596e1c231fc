:- module(sg_solid_rows,
          [ solid_written/2             % +Solid, +S
          ]).
:- use_module(kernel, [solid_vertices/2, solid_faces/2, solid_parts/2]).
:- use_module(store, [assert_fact/1]).
:- autoload(library(apply), [foldl/4]).
:- autoload(library(lists), [member/2, nth1/3]).
:- autoload(library(ordsets), [ord_memberchk/2]).
/** <module> The rows of a solid.

@see c_kernels/solid.h
*/

%!  solid_written(+Solid, +S) is det.
%
%   Appends v/5, e/5, p/3, plane/6, t/6, from_v/4, from_p/5 and origin/3 of
%   segment S, which must have none: a polygon for each face, whose edges are
%   those of its triangles without an opposite one in the same face.

solid_written(Solid, S) :-
    solid_vertices(Solid, Vertices),
    solid_faces(Solid, Faces),
    solid_parts(Solid, Parts),
    forall(member(Vertex, Vertices), write_vertex(S, Vertex)),
    Places =.. [places|Vertices],
    foldl(write_face(S, Places), Faces, 1-1-1, _),
    (   Parts == []
    ->  forall(nth1(P, Faces, face(S0, P0, Sense, _)),
               assert_fact(from_p(S, P, S0, P0, Sense)))
    ;   forall(member(part(P, S0, P0, Sense), Parts),
               assert_fact(from_p(S, P, S0, P0, Sense)))
    ).

write_vertex(S, vertex(V, X, Y, Z, From)) :-
    assert_fact(v(S, V, X, Y, Z)),
    (   From = S0-V0
    ->  assert_fact(from_v(S, V, S0, V0))
    ;   From = made(Origin),
        assert_fact(origin(S, v(V), Origin))
    ).

write_face(S, Places, face(_, _, _, Triangles), P0-E0-T0, P1-E1-T1) :-
    findall(A-B, ( member(T, Triangles), half_edge(T, A, B, _) ), Pairs0),
    sort(Pairs0, Pairs),
    findall(e(A, B, Et),
            ( member(T, Triangles),
              half_edge(T, A, B, Et),
              \+ ord_memberchk(B-A, Pairs)
            ),
            Edges),
    foldl(write_edge(S), Edges, []-E0, Es-E1),
    assert_fact(p(S, P0, Es)),
    foldl(add_turn(Places), Triangles, n(0.0, 0.0, 0.0), n(X, Y, Z)),
    write_plane(S, P0, Places, Triangles, X, Y, Z),
    foldl(write_triangle(S, P0), Triangles, T0, T1),
    P1 is P0+1.

half_edge(t(A, B, _, Bits), A, B, Et) :-
    Et is 1 - Bits /\ 1.
half_edge(t(_, B, C, Bits), B, C, Et) :-
    Et is 1 - (Bits>>1) /\ 1.
half_edge(t(A, _, C, Bits), C, A, Et) :-
    Et is 1 - (Bits>>2) /\ 1.

write_edge(S, e(A, B, Et), Es-E0, [E0|Es]-E1) :-
    assert_fact(e(S, E0, A, B, Et)),
    E1 is E0+1.

add_turn(Places, t(A, B, C, _), n(X0, Y0, Z0), n(X, Y, Z)) :-
    place(Places, A, Xa, Ya, Za),
    place(Places, B, Xb, Yb, Zb),
    place(Places, C, Xc, Yc, Zc),
    X is X0 + (Yb-Ya)*(Zc-Za) - (Zb-Za)*(Yc-Ya),
    Y is Y0 + (Zb-Za)*(Xc-Xa) - (Xb-Xa)*(Zc-Za),
    Z is Z0 + (Xb-Xa)*(Yc-Ya) - (Yb-Ya)*(Xc-Xa).

place(Places, V, X, Y, Z) :-
    arg(V, Places, vertex(_, X, Y, Z, _)).

write_plane(S, P, Places, [t(A, _, _, _)|_], X, Y, Z) :-
    Length is sqrt(X*X + Y*Y + Z*Z),
    (   Length > 0.0
    ->  place(Places, A, Xa, Ya, Za),
        Nx is X/Length,
        Ny is Y/Length,
        Nz is Z/Length,
        D is -(Nx*Xa + Ny*Ya + Nz*Za),
        assert_fact(plane(S, P, Nx, Ny, Nz, D))
    ;   true
    ).

write_triangle(S, P, t(A, B, C, _), T0, T1) :-
    assert_fact(t(S, P, T0, A, B, C)),
    T1 is T0+1.
