:- module(sg_triangle_corners,
          [ triangle_corners/5,         % +S, ?P, -A, -B, -C
            vertex_place/3,             % +S, +V, -Place
            rational_place/3            % +S, +V, -Place
          ]).
:- use_module('../store', [v/5, t/6]).
/** <module> Where the triangles of polygons are. */

%!  triangle_corners(+S, ?P, -A, -B, -C) is nondet.
%
%   A, B and C, p(X,Y,Z), are the corners of a triangle of polygon P of segment
%   S, as the polygon runs.

triangle_corners(S, P, A, B, C) :-
    t(S, P, _, V1, V2, V3),
    vertex_place(S, V1, A),
    vertex_place(S, V2, B),
    vertex_place(S, V3, C).

%!  vertex_place(+S, +V, -Place) is det.
%
%   Place is p(X,Y,Z), where vertex V of segment S is.

vertex_place(S, V, p(X,Y,Z)) :-
    once(v(S, V, X, Y, Z)).

%!  rational_place(+S, +V, -Place) is det.
%
%   The same, of the rationals that the doubles are.

rational_place(S, V, p(X,Y,Z)) :-
    vertex_place(S, V, p(X0,Y0,Z0)),
    X is rational(X0),
    Y is rational(Y0),
    Z is rational(Z0).
