:- module(sg_oracle_bezier_normal,
          [ patch_normal/3              % +Numbers, +Point, -Normal
          ]).
:- use_module('../../rules/vector',
              [cross_product/3, difference/3, dot_product/3]).
:- use_module(library(apply), [foldl/4]).
:- use_module(library(lists), [member/2]).
/** <module> The normal of a bicubic Bezier patch at a point of it.

The parameters of the point are those of the nearest point of a net of five by
five, and what steps of Gauss and Newton make of them.
c_kernels/picture/bezier_patch.c is the fused kernel.

@see bezier.pl
*/

:- set_prolog_flag(optimise, true).

%!  patch_normal(+Numbers, +Point, -Normal) is semidet.
%
%   Normal is u x v, of any length, where the patch is nearest to Point; both
%   are p(X,Y,Z). Numbers are the coordinates of its control points, four rows
%   of four. Fails where it has none: at a side that is one point.

patch_normal(Numbers, Point, Normal) :-
    points(Numbers, Controls),
    nearest_of_net(Controls, Point, U0, V0),
    stepped(12, Controls, Point, U0, V0, U, V),
    place(Controls, U, V, place(_,Along,Across)),
    cross_product(Along, Across, Normal),
    dot_product(Normal, Normal, Square),
    dot_product(Along, Along, UU),
    dot_product(Across, Across, VV),
    sqrt(Square) > 1.0e-9*sqrt(UU)*sqrt(VV).

points([], []).
points([X,Y,Z|Numbers], [p(X,Y,Z)|Points]) :-
    points(Numbers, Points).

nearest_of_net(Controls, Point, U, V) :-
    findall(Square-(U0-V0),
            ( member(J, [0,1,2,3,4]), member(I, [0,1,2,3,4]),
              U0 is I/4.0,
              V0 is J/4.0,
              place(Controls, U0, V0, place(P,_,_)),
              difference(P, Point, Off),
              dot_product(Off, Off, Square) ),
            [First|Net]),
    foldl(nearer, Net, First, _-(U-V)).

nearer(Square1-At1, Square0-At0, Nearer) :-
    (   Square1 < Square0
    ->  Nearer = Square1-At1
    ;   Nearer = Square0-At0
    ).

stepped(N, Controls, Point, U0, V0, U, V) :-
    (   N > 0,
        step(Controls, Point, U0, V0, U1, V1)
    ->  N1 is N-1,
        stepped(N1, Controls, Point, U1, V1, U, V)
    ;   U = U0,
        V = V0
    ).

%   Fails where no direction is known, or where it is there.

step(Controls, Point, U0, V0, U, V) :-
    place(Controls, U0, V0, place(P,Along,Across)),
    difference(Point, P, Off),
    dot_product(Along, Along, UU),
    dot_product(Across, Across, VV),
    dot_product(Along, Across, UV),
    dot_product(Off, Along, DownU),
    dot_product(Off, Across, DownV),
    Volume is UU*VV - UV*UV,
    Volume > 1.0e-18*UU*VV,
    ByU is (VV*DownU - UV*DownV)/Volume,
    ByV is (UU*DownV - UV*DownU)/Volume,
    abs(ByU) + abs(ByV) > 1.0e-14,
    U is min(max(U0+ByU, 0.0), 1.0),
    V is min(max(V0+ByV, 0.0), 1.0).

%   place(Controls, U, V, place(Point, Along, Across)): where it is, and where u
%   and v go there.

place(Controls, U, V, place(P,Along,Across)) :-
    bernstein(U, Us, SlopeUs),
    bernstein(V, Vs, SlopeVs),
    mixed(Controls, Us, Vs, P),
    mixed(Controls, SlopeUs, Vs, Along),
    mixed(Controls, Us, SlopeVs, Across).

bernstein(T, [A,B,C,D], [E,F,G,H]) :-
    M is 1.0-T,
    A is M*M*M,
    B is 3.0*M*M*T,
    C is 3.0*M*T*T,
    D is T*T*T,
    E is -3.0*M*M,
    F is 3.0*M*M - 6.0*M*T,
    G is 6.0*M*T - 3.0*T*T,
    H is 3.0*T*T.

mixed(Controls, Us, Vs, P) :-
    findall(W, ( member(F, Vs), member(G, Us), W is G*F ), Weights),
    weighted(Weights, Controls, p(0.0,0.0,0.0), P).

weighted([], [], P, P).
weighted([W|Ws], [p(X1,Y1,Z1)|Points], p(X0,Y0,Z0), P) :-
    X is X0 + W*X1,
    Y is Y0 + W*Y1,
    Z is Z0 + W*Z1,
    weighted(Ws, Points, p(X,Y,Z), P).
