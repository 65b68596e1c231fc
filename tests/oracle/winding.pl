:- module(sg_oracle_winding,
          [ winding_by_rule/3           % +S, +Point, -Winding
          ]).
:- use_module('../../rules/store', [v/5, t/6]).
:- use_module('../../rules/vector',
              [cross_product/3, difference/3, dot_product/3]).
:- use_module(library(aggregate), [aggregate_all/3]).
/** <module> The rule of winding numbers (rules/solid/inside.pl), triangle by
triangle, in rationals.
*/

%!  winding_by_rule(+S, +Point, -Winding) is det.
%
%   Winding is that of winding/3.

winding_by_rule(S, point(X0,Y0,Z0), Winding) :-
    X is rational(X0),
    Y is rational(Y0),
    Z is rational(Z0),
    P = p(X,Y,Z),
    (   triangle(S, A, B, C),
        is_on(A, B, C, P)
    ->  Winding = on
    ;   aggregate_all(sum(Turn),
                      ( triangle(S, A, B, C), leaves(A, B, C, P, Turn) ),
                      Winding)
    ).

triangle(S, A, B, C) :-
    t(S, _, _, V1, V2, V3),
    corner(S, V1, A),
    corner(S, V2, B),
    corner(S, V3, C).

corner(S, V, p(X,Y,Z)) :-
    v(S, V, X0, Y0, Z0),
    X is rational(X0),
    Y is rational(Y0),
    Z is rational(Z0).

%   leaves(+A, +B, +C, +P, -Turn): the ray from P leaves (1) or enters (-1)
%   through the triangle. Seen from +x, the shifted point is on the same side of
%   all three edges; and P lies before the plane.

leaves(A, B, C, P, Turn) :-
    turn(A, B, C, Area),
    Area =\= 0,
    shifted_turn(A, B, P, Turn),
    shifted_turn(B, C, P, Turn),
    shifted_turn(C, A, P, Turn),
    height(A, B, C, P, Height),
    Turn*Height < 0.

%   turn(+A, +B, +C, -Turn): twice the area of A, B, C seen from +x.

turn(p(_,Ya,Za), p(_,Yb,Zb), p(_,Yc,Zc), Turn) :-
    Turn is (Yb-Ya)*(Zc-Za) - (Zb-Za)*(Yc-Ya).

shifted_turn(A, B, P, Turn) :-
    A = p(_,Ya,Za),
    B = p(_,Yb,Zb),
    turn(A, B, P, Turn0),
    (   Turn0 =\= 0
    ->  Turn is sign(Turn0)
    ;   Za =\= Zb
    ->  Turn is sign(Za-Zb)
    ;   Turn is sign(Yb-Ya)
    ).

%   height(+A, +B, +C, +P, -Height): above zero where P is on the side from
%   which A, B, C runs counter-clockwise.

height(A, B, C, P, Height) :-
    difference(B, A, U),
    difference(C, A, W),
    difference(P, A, V),
    cross_product(U, W, Normal),
    dot_product(V, Normal, Height).

%   is_on(+A, +B, +C, +P): P = A + I (B-A) + J (C-A), with I and J not below
%   zero nor above one together. A triangle without area counts nothing.

is_on(A, B, C, P) :-
    height(A, B, C, P, 0),
    difference(B, A, U),
    difference(C, A, W),
    difference(P, A, V),
    dot_product(U, U, UU),
    dot_product(U, W, UW),
    dot_product(W, W, WW),
    dot_product(V, U, VU),
    dot_product(V, W, VW),
    Square is UU*WW-UW*UW,
    Square > 0,
    I is VU*WW-VW*UW,
    J is VW*UU-VU*UW,
    I >= 0,
    J >= 0,
    I+J =< Square.
