:- module(sg_oracle_contour_side,
          [ current_eye/1,              % -Eye
            to_eye/3,                   % +Eye, +Point, -Direction
            towards_eye/4,              % +Sheets, +Eye, +Fan, -G
            corner_g/4,                 % +Sheets, +Gs, +Corner, -G
            side_zero/3,                % +Context, +Side, -F
            side_rise/3                 % +Context, +Side, -Rise
          ]).
:- use_module(smooth_sheet,
              [ corner_fan/3, fan_corners/3, fan_normal/3, fan_unit/3,
                corner_vertex/3, corner_height/3, corner_place/3,
                corner_surface/3, cut_side/3, next_corner/2, smooth_side/3,
                curved_triangle/2
              ]).
:- use_module('../../rules/store', [line/9, screen/5]).
:- use_module('../../rules/vector', [difference/3, dot_product/3]).
:- use_module('../../rules/picture/view', [current_view/4, view_matrix/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(assoc), [get_assoc/3]).
:- use_module(library(lists), [max_member/2, member/2, memberchk/2]).
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

side_zero(Context, Side, F) :-
    Context = context(_, Sheets, Eye, _, _),
    model_zero(Context, Side, Low, High, Zero),
    maplist(corner_place(Sheets), [Low,High], [P,Q]),
    distance(Eye, P, NearP),
    distance(Eye, Q, NearQ),
    F is Zero*NearQ/((1.0-Zero)*NearP + Zero*NearQ).

%   model_zero(Context, Side, Low, High, Zero): the same in the model, and the
%   corners of the side, the one with the smaller vertex first.

model_zero(context(_,Sheets,_,Gs,_), Side, Low, High, Zero) :-
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
    Zero is G/(G-H).

%!  side_rise(+Context, +Side, -Rise) is det.
%
%   Rise, X-Y, leads in the picture from the zero of Side, whose ends differ, to
%   the smooth surface, which rises there as a circle does that has the normals
%   of both ends: along the normal N by
%
%       Zero*(1-Zero)/2 * (N2-N1).(P2-P1)
%
%   up to the fourth power of its angle, and by what a line's ends in a facet
%   are sunk. Where a line runs on the surface the outline meets it on the side;
%   and the normals of other than known surfaces are not known so well: there
%   Rise is 0.

side_rise(Context, Side, Rise) :-
    Context = context(S, Sheets, _, _, _),
    (   known_side(S, Sheets, Side)
    ->  surface_rise(Context, Side, Rise)
    ;   Rise = 0.0-0.0
    ).

%   known_side(S, Sheets, Side): both triangles of a curved sheet at Side stand
%   on known surfaces: with all corners, or by as much as these are sunk. None
%   of them touches a line that runs through the sheet: there outline and line
%   meet in the facets.

known_side(S, Sheets, T-I) :-
    curved_triangle(Sheets, T),
    smooth_side(Sheets, T-I, T2-_),
    stands(S, Sheets, T),
    stands(S, Sheets, T2).

stands(S, Sheets, T) :-
    corner_surface(Sheets, T-1, _-surface(Kind,_,_,_)),
    \+ ( member(I, [1,2,3]),
         corner_vertex(Sheets, T-I, V),
         line_ends_at(S, V),
         (   \+ memberchk(Kind, [tapered,turned,sphere,torus])
         ;   runs_through(S, Sheets, T-I)
         ) ).

runs_through(S, Sheets, Corner) :-
    corner_fan(Sheets, Corner, Fan),
    fan_corners(Sheets, Fan, Corners),
    member(C, Corners),
    next_corner(C, Next),
    next_corner(Next, Before),
    member(Side, [C,Before]),
    smooth_side(Sheets, Side, _),
    cut_side(S, Sheets, Side),
    !.

%   sunk(S, Sheets, Corner, Height): the surface is Height above Corner, where a
%   line ends in a facet; of the surfaces of its fan that which is farthest off.

sunk(S, Sheets, Corner, Height) :-
    corner_vertex(Sheets, Corner, V),
    (   line_ends_at(S, V),
        corner_fan(Sheets, Corner, Fan),
        fan_corners(Sheets, Fan, Corners),
        findall(Far-H, ( member(C, Corners), corner_height(Sheets, C, H),
                         Far is abs(H) ),
                Heights),
        max_member(_-Height0, Heights)
    ->  Height = Height0
    ;   Height = 0.0
    ).

line_ends_at(S, V) :-
    (   line(_, S, _, V, _, _, _, _, _)
    ;   line(_, S, _, _, V, _, _, _, _)
    ;   line(_, _, _, _, _, S, _, V, _)
    ;   line(_, _, _, _, _, S, _, _, V)
    ),
    !.

surface_rise(Context, Side, X-Y) :-
    Context = context(S, Sheets, Eye, _, _),
    model_zero(Context, Side, Low, High, Zero),
    maplist(corner_place(Sheets), [Low,High], [P1,P2]),
    maplist(corner_unit(Sheets), [Low,High], [N1,N2]),
    difference(P2, P1, Along),
    difference(N2, N1, Turn),
    part_way(N1, Turn, Zero, Normal),
    part_way(P1, Along, Zero, OnSide),
    dot_product(Turn, Along, Bend),
    dot_product(Normal, Normal, Square),
    maplist(sunk(S, Sheets), [Low,High], [Sunk1,Sunk2]),
    Height is ( Zero*(1.0-Zero)/2.0*Bend + (1.0-Zero)*Sunk1 + Zero*Sunk2
              )/sqrt(Square),
    part_way(OnSide, Normal, Height, Risen),
    maplist(eye_place(Eye), [OnSide,Risen], [X1-Y1,X2-Y2]),
    picture_scale(S, Sheets, Eye, [Low,High], Scale),
    X is Scale*(X2-X1),
    Y is Scale*(Y2-Y1).

corner_unit(Sheets, Corner, Unit) :-
    corner_fan(Sheets, Corner, Fan),
    fan_unit(Sheets, Fan, Unit).

part_way(p(X0,Y0,Z0), p(U,V,W), Part, p(X,Y,Z)) :-
    X is X0 + Part*U,
    Y is Y0 + Part*V,
    Z is Z0 + Part*W.

%   In the picture, except for its scale.

eye_place(Eye, Point, X-Y) :-
    Eye = eye(_, _, _, Right, Up),
    distance(Eye, Point, Distance),
    dot_product(Point, Right, X0),
    dot_product(Point, Up, Y0),
    X is X0/Distance,
    Y is Y0/Distance.

%   picture_scale(S, Sheets, Eye, Corners, Scale): what one is in the picture at
%   the distance 1, told by the place of the corner that is farther from the
%   middle; 0 if none is.

picture_scale(S, Sheets, Eye, Corners, Scale) :-
    (   arg(1, Eye, central)
    ->  findall(Off-Corner,
                ( member(Corner, Corners),
                  corner_place(Sheets, Corner, Point),
                  eye_place(Eye, Point, X-Y),
                  Off is sqrt(X*X + Y*Y) ),
                Offs),
        max_member(Most-Farthest, Offs),
        corner_vertex(Sheets, Farthest, V),
        screen(S, V, XS, YS, _),
        (   Most > 0.0
        ->  Scale is sqrt(XS*XS + YS*YS)/Most
        ;   Scale = 0.0
        )
    ;   Scale = 1.0
    ).
