:- module(sg_contour_side,
          [ current_eye/1,              % -Eye
            to_eye/3,                   % +Eye, +Point, -Direction
            towards_eye/4,              % +Sheets, +Eye, +Fan, -G
            corner_g/4,                 % +Sheets, +Gs, +Corner, -G
            side_zero/3                 % +Context, +Side, -F
          ]).
:- use_module(smooth_sheet,
              [ corner_fan/3, fan_normal/3, corner_vertex/3, corner_place/3,
                next_corner/2
              ]).
:- use_module('../vector', [dot_product/3]).
:- use_module(view, [current_view/4, view_matrix/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(assoc), [get_assoc/3]).
/** <module> How smooth surfaces lie to the eye along the sides of triangles.

The side of a vertex that a surface turns to the eye is told by g = normal .
direction to the eye, with the normal of the vertex's fan (smooth_sheet.pl);
along a side it runs linearly.

@see contour.pl
*/

:- set_prolog_flag(optimise, true).

%!  current_eye(-Eye) is det.
%
%   Eye is eye(Kind, Away, Rho, Right, Up) of the current view, vectors p(X,Y,Z)
%   of the model.

current_eye(eye(Kind,Away,Rho,Right,Up)) :-
    current_view(Theta, Phi, Rho, Kind),
    view_matrix(Theta, Phi, Rows),
    maplist(float_row, Rows, [Right,Up,Away]).

float_row(r(A0,B0,C0), p(A,B,C)) :-
    A is float(A0),
    B is float(B0),
    C is float(C0).

%!  to_eye(+Eye, +Point, -Direction) is det.
%
%   Direction, unit, is the way from Point to the eye.

to_eye(eye(Kind,p(A,B,C),Rho,_,_), p(X,Y,Z), p(U,V,W)) :-
    (   Kind == central
    ->  U0 is -Rho*A - X,
        V0 is -Rho*B - Y,
        W0 is -Rho*C - Z
    ;   U0 is -A,
        V0 is -B,
        W0 is -C
    ),
    Size is sqrt(U0*U0 + V0*V0 + W0*W0),
    U is U0/Size,
    V is V0/Size,
    W is W0/Size.

%   How far a point is from the eye, along its line of sight.

distance(eye(Kind,Away,Rho,_,_), Point, Distance) :-
    (   Kind == central
    ->  dot_product(Point, Away, Depth),
        Distance is Depth+Rho
    ;   Distance = 1.0
    ).

%!  towards_eye(+Sheets, +Eye, +Fan, -G) is semidet.
%
%   G is how far the surface is turned to the eye at Fan; an apex has none.
%   Nearly zero is zero.

towards_eye(Sheets, Eye, Fan, G) :-
    fan_normal(Sheets, Fan, Normal),
    corner_place(Sheets, Fan, Place),
    to_eye(Eye, Place, Direction),
    dot_product(Normal, Direction, G0),
    (   abs(G0) < 1.0e-12
    ->  G = 0.0
    ;   G = G0
    ).

%!  corner_g(+Sheets, +Gs, +Corner, -G) is semidet.
%
%   G is that of the fan of Corner; Gs has those of all fans that have one.

corner_g(Sheets, Gs, Corner, G) :-
    corner_fan(Sheets, Corner, Fan),
    get_assoc(Fan, Gs, G).

%!  side_zero(+Context, +Side, -F) is det.
%
%   F is where g is zero on Side, whose ends differ, counted from its smaller
%   vertex, in the picture. Context is of contour.pl.

side_zero(context(_,Sheets,Eye,Gs,_), Side, F) :-
    next_corner(Side, Next),
    corner_vertex(Sheets, Side, V1),
    corner_vertex(Sheets, Next, V2),
    (   V1 < V2
    ->  Low = Side,
        High = Next
    ;   Low = Next,
        High = Side
    ),
    corner_g(Sheets, Gs, Low, G),
    corner_g(Sheets, Gs, High, H),
    Zero is G/(G-H),
    maplist(corner_place(Sheets), [Low,High], [P,Q]),
    distance(Eye, P, NearP),
    distance(Eye, Q, NearQ),
    F is Zero*NearQ/((1.0-Zero)*NearP + Zero*NearQ).
