:- module(sg_contour_told,
          [ untold_side/2               % +Context, +Side
          ]).
:- use_module(contour_beside, [side_place/5]).
:- use_module(smooth_sheet,
              [ smooth_side/3, convex_side/2, corner_fan/3, fan_corners/3,
                next_corner/2, side_bulges/2
              ]).
:- use_module(store, [screen/5, t/6]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(assoc), [get_assoc/3]).
:- use_module(library(lists), [member/2]).
/** <module> Which outlines of triangles no piece of a smooth outline tells of.

The triangles of a smooth sheet hide what lies behind them, so where they turn
from the eye the picture has an edge. As a rule a piece of the smooth outline
runs near it. Where the surface is coarser than it bends, some triangles are
turned from the eye though the surface is not, at all of their corners: nothing
would be drawn there, and other lines would end for no reason that is seen. So
such an outline of triangles is drawn as it is, where

  - the surface bends down at it, for else its own triangles hide it,
  - a smooth surface would bulge at one of the two triangles,
  - neither of them is crossed by a piece whose nearer half is turned to the
    eye,
  - nor does a piece across a triangle of the fans at its ends run nearer to its
    middle than a thousandth of the picture of its segment, in which they could
    not be told apart.

c_kernels/contour_told.c is the fused kernel.

@see contour.pl
*/

:- set_prolog_flag(optimise, true).

%!  untold_side(+Context, +Side) is semidet.
%
%   True when Side, at which triangles of a sheet that is drawn as smooth turn
%   from the eye, is an outline. Context is of contour.pl.

untold_side(Context, T-I) :-
    Context = context(S, Sheets, _, _, _),
    smooth_side(Sheets, T-I, T2-_),
    convex_side(Sheets, T-I),
    \+ piece_towards(Context, T),
    \+ piece_towards(Context, T2),
    once(( member(Bulging, [T,T2]), member(J, [1,2,3]),
           side_bulges(Sheets, Bulging-J) )),
    side_middle(S, T-I, Middle),
    picture_size(S, Size),
    Near is 1.0e-3*Size,
    next_corner(T-I, Next),
    \+ ( member(Corner, [T-I,Next]),
         tells(Context, Corner, Middle, Near) ).

piece_towards(context(_,_,_,_,Found), T) :-
    get_assoc(T, Found, across(_, 1)).

%   A piece across a triangle of the fan of Corner is so near to Middle.

tells(context(S,Sheets,_,_,Found), Corner, Middle, Near) :-
    corner_fan(Sheets, Corner, Fan),
    fan_corners(Sheets, Fan, Corners),
    member(T-_, Corners),
    get_assoc(T, Found, across(piece(T,I1,F1,I2,F2,_,_), _)),
    t(S, _, T, A, B, C),
    side_place(S, t(A,B,C,A), I1, F1, Start),
    side_place(S, t(A,B,C,A), I2, F2, End),
    distance(Middle, Start, End, Distance),
    Distance < Near.

distance(X-Y, X1-Y1, X2-Y2, Distance) :-
    U is X2-X1,
    V is Y2-Y1,
    Square is U*U + V*V,
    (   Square > 0.0
    ->  Part is min(max(((X-X1)*U + (Y-Y1)*V)/Square, 0.0), 1.0)
    ;   Part = 0.0
    ),
    Distance is sqrt((X-X1-Part*U)**2 + (Y-Y1-Part*V)**2).

side_middle(S, T-I, Middle) :-
    t(S, _, T, A, B, C),
    side_place(S, t(A,B,C,A), I, 0.5, Middle).

%   The longer side of the picture of segment S.

picture_size(S, Size) :-
    aggregate_all(r(min(X),max(X),min(Y),max(Y)), screen(S, _, X, Y, _),
                  r(X1,X2,Y1,Y2)),
    Size is max(X2-X1, Y2-Y1).
