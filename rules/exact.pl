:- module(sg_exact,
          [ vertex_exact/5,             % ?S, ?V, -X, -Y, -Z
            origin_exact/4,             % +Origin, -X, -Y, -Z
            vertex_side/4               % +S, +V, +Triangle, -Side
          ]).
:- use_module(store, [v/5, origin/3]).
:- use_module(vector, [cross_product/3, difference/3, dot_product/3]).
:- use_module(library(error), [domain_error/2, existence_error/2]).

/** <module> Where a vertex is, exactly.

The doubles of v/5 are where a vertex is, unless it was made by a cut. Then
they are a point rounded once, and origin/3 says which point: it names lines
and planes by *original* vertices, those without an origin of their own, whose
doubles are exact. So one step leads from any vertex to its rationals, however
many penetrations there were.

@see ARCHITECTURE.md, section 5
*/

%!  vertex_exact(?S, ?V, -X, -Y, -Z) is nondet.
%
%   True when vertex V of segment S is at X, Y, Z: rational numbers, exact for
%   original vertices and derived ones. v/5 has each of them correctly rounded
%   (to the nearest double, ties to even). In the order of v/5.
%
%       ?- vertex_exact(1, V, X, Y, Z).
%
%   Origins that name no place leave a vertex where v/5 has it: near(_), of
%   one that was moved or made to touch (resolve.pl), and `crossing`, in a
%   polygon that is flat only within the tolerance.
%
%   @error domain_error(original_vertex, S-V) if an origin names a vertex that
%          has itself an origin; domain_error(vertex_origin, Origin) if the
%          lines or planes of an origin do not meet in one point;
%          existence_error(vertex, S-V) if they name one that is not there

vertex_exact(S, V, X, Y, Z) :-
    v(S, V, X0, Y0, Z0),
    (   origin(S, v(V), Origin),
        names_place(Origin)
    ->  origin_point(Origin, p(X,Y,Z))
    ;   X is rational(X0),
        Y is rational(Y0),
        Z is rational(Z0)
    ).

%!  origin_exact(+Origin, -X, -Y, -Z) is semidet.
%
%   True when a vertex with this Origin would be at X, Y, Z, rational numbers.
%   Fails when it names no single point.

origin_exact(Origin, X, Y, Z) :-
    names_place(Origin),
    made_point(Origin, p(X,Y,Z)).

%!  vertex_side(+S, +V, +Triangle, -Side) is semidet.
%
%   Side is `above` (outside), `below` or `on`: where vertex V of segment S is,
%   exactly, to the plane of Triangle = S2-(A,B,C), three original vertices
%   counter-clockwise from outside.

vertex_side(S, V, Triangle, Side) :-
    once(vertex_exact(S, V, X, Y, Z)),
    plane(Triangle, Normal, At),
    dot_product(Normal, p(X,Y,Z), Height),
    Sign is sign(Height-At),
    side(Sign, Side).

side(1, above).
side(0, on).
side(-1, below).

names_place(v(_, _)).
names_place(lpi(_, _)).
names_place(ll(_, _)).
names_place(tpi(_, _, _)).

origin_point(Origin, Point) :-
    (   made_point(Origin, Point0)
    ->  Point = Point0
    ;   domain_error(vertex_origin, Origin)
    ).

%   made_point(+Origin, -Point) is semidet: Point is p(X,Y,Z), rationals. Fails
%   when there is no such single point.

made_point(v(S, V), Point) :-
    corner(S, V, Point).
made_point(lpi(S1-(A,B), S2-(C,D,E)), Point) :-
    plane(S2-(C,D,E), Normal, At),
    corner(S1, A, P),
    corner(S1, B, Q),
    dot_product(Normal, P, P0),
    dot_product(Normal, Q, Q0),
    Q0 =\= P0,
    T is (At-P0) rdiv (Q0-P0),
    on_line(P, Q, T, Point).
made_point(ll(S1-(A,B), S2-(C,D)), Point) :-
    corner(S1, A, P),
    corner(S1, B, Q),
    corner(S2, C, R),
    corner(S2, D, R1),
    difference(Q, P, Along),
    difference(R1, R, Across),
    difference(R, P, Between),
    cross_product(Along, Across, Normal),
    cross_product(Between, Across, Part),
    dot_product(Normal, Normal, Length),
    Length =\= 0,
    dot_product(Part, Normal, Share),
    T is Share rdiv Length,
    on_line(P, Q, T, Point).
made_point(tpi(T1, T2, T3), p(X,Y,Z)) :-
    plane(T1, N1, D1),
    plane(T2, N2, D2),
    plane(T3, N3, D3),
    cross_product(N2, N3, p(X1,Y1,Z1)),
    cross_product(N3, N1, p(X2,Y2,Z2)),
    cross_product(N1, N2, p(X3,Y3,Z3)),
    dot_product(N1, p(X1,Y1,Z1), Det),
    Det =\= 0,
    X is (D1*X1 + D2*X2 + D3*X3) rdiv Det,
    Y is (D1*Y1 + D2*Y2 + D3*Y3) rdiv Det,
    Z is (D1*Z1 + D2*Z2 + D3*Z3) rdiv Det.

%   corner(+S, +V, -Point): an original vertex.

corner(S, V, p(X,Y,Z)) :-
    (   v(S, V, X0, Y0, Z0)
    ->  true
    ;   existence_error(vertex, S-V)
    ),
    (   origin(S, v(V), Origin),
        names_place(Origin)
    ->  domain_error(original_vertex, S-V)
    ;   true
    ),
    X is rational(X0),
    Y is rational(Y0),
    Z is rational(Z0).

%   plane(+S-(A,B,C), -Normal, -At): the points P with Normal . P = At.

plane(S-(A,B,C), Normal, At) :-
    corner(S, A, P),
    corner(S, B, Q),
    corner(S, C, R),
    difference(Q, P, U),
    difference(R, P, W),
    cross_product(U, W, Normal),
    dot_product(Normal, P, At).

on_line(p(X1,Y1,Z1), p(X2,Y2,Z2), T, p(X,Y,Z)) :-
    X is X1 + T*(X2-X1),
    Y is Y1 + T*(Y2-Y1),
    Z is Z1 + T*(Z2-Z1).
