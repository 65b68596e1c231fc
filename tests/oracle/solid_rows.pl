:- module(sg_oracle_solid_rows,
          [ solid_written_by_rule/2,    % +Solid, +S
            solid_counts/4              % +Solid, -Vertices, -Faces, -Triangles
          ]).
:- use_module('../../rules/kernel',
              [solid_vertices/2, solid_faces/2, solid_parts/2]).
:- use_module('../../rules/store', [assert_fact/1]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [foldl/4, foldl/5]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists),
              [append/3, member/2, nth1/3, selectchk/3]).
/** <module> The rule of solid_write/2: the rows of a solid, one by one.

@see c_kernels/solid/solid.h
*/

%!  solid_counts(+Solid, -Vertices, -Faces, -Triangles) is det.
%
%   How many Solid has.

solid_counts(Solid, Vertices, Faces, Triangles) :-
    solid_vertices(Solid, Vs),
    solid_faces(Solid, Fs),
    length(Vs, Vertices),
    length(Fs, Faces),
    aggregate_all(count, ( member(face(_, _, _, Ts), Fs), member(_, Ts) ),
                  Triangles).

%!  solid_written_by_rule(+Solid, +S) is det.
%
%   Appends v/5, e/5, p/3, plane/6, t/6, from_v/4, from_p/5 and origin/3 of
%   segment S, which must have none. Vertices that no triangle has are left out,
%   the others numbered in their order. A polygon for each face: its edges are
%   the half-edges of its triangles except those that have an opposite one in
%   it, one for one. Its plane is missing if it has no area.

solid_written_by_rule(Solid, S) :-
    solid_vertices(Solid, Vertices),
    solid_faces(Solid, Faces),
    solid_parts(Solid, Parts),
    used_vertices(Faces, Used),
    findall(V-Id, nth1(Id, Used, V), Pairs),
    list_to_assoc(Pairs, Number),
    Places =.. [places|Vertices],
    forall(member(V-Id, Pairs), write_vertex(S, Places, V, Id)),
    foldl(write_face(S, Places, Number), Faces, 1-1-1, _),
    forall(nth1(P, Faces, Face), write_sources(S, P, Face, Parts)).

used_vertices(Faces, Used) :-
    findall(V, ( member(face(_, _, _, Triangles), Faces),
                 member(t(A, B, C, _), Triangles),
                 member(V, [A,B,C]) ),
            Used0),
    sort(Used0, Used).

write_vertex(S, Places, V, Id) :-
    arg(V, Places, vertex(_, X, Y, Z, From)),
    assert_fact(v(S, Id, X, Y, Z)),
    (   From = S0-V0
    ->  assert_fact(from_v(S, Id, S0, V0))
    ;   From = made(Origin),
        assert_fact(origin(S, v(Id), Origin))
    ).

write_sources(S, P, face(S0, P0, Sense, _), Parts) :-
    findall(S1-P1-Sense1, member(part(P, S1, P1, Sense1), Parts), Others),
    sort([S0-P0-Sense|Others], Sources),
    forall(member(S1-P1-Sense1, Sources),
           assert_fact(from_p(S, P, S1, P1, Sense1))).

write_face(S, Places, Number, face(_, _, _, Triangles), P0-E0-T0, P-E-T) :-
    findall(e(A, B, Et),
            ( member(Triangle, Triangles), half_edge(Triangle, A, B, Et) ),
            HalfEdges),
    foldl(unpaired, HalfEdges, [], Edges),
    foldl(write_edge(S, Number), Edges, Es, E0, E),
    assert_fact(p(S, P0, Es)),
    foldl(add_turn(Places), Triangles, n(0.0, 0.0, 0.0), n(X, Y, Z)),
    write_plane(S, P0, Places, Triangles, X, Y, Z),
    foldl(write_triangle(S, P0, Number), Triangles, T0, T),
    P is P0+1.

%   unpaired(Edge, Edges0, Edges): Edge is one more, or takes its opposite one
%   away.

unpaired(e(A, B, Et), Edges0, Edges) :-
    (   selectchk(e(B, A, _), Edges0, Edges1)
    ->  Edges = Edges1
    ;   append(Edges0, [e(A, B, Et)], Edges)
    ).

half_edge(t(A, B, _, Bits), A, B, Et) :-
    Et is 1 - Bits /\ 1.
half_edge(t(_, B, C, Bits), B, C, Et) :-
    Et is 1 - (Bits>>1) /\ 1.
half_edge(t(A, _, C, Bits), C, A, Et) :-
    Et is 1 - (Bits>>2) /\ 1.

write_edge(S, Number, e(A, B, Et), E0, E0, E) :-
    get_assoc(A, Number, V1),
    get_assoc(B, Number, V2),
    assert_fact(e(S, E0, V1, V2, Et)),
    E is E0+1.

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

write_triangle(S, P, Number, t(A, B, C, _), T0, T) :-
    get_assoc(A, Number, V1),
    get_assoc(B, Number, V2),
    get_assoc(C, Number, V3),
    assert_fact(t(S, P, T0, V1, V2, V3)),
    T is T0+1.
