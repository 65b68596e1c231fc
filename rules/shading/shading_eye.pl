:- module(sg_shading_eye,
          [ eye_rows/3,                 % +Eye, +Place, -Matrix
            eye_axes/3                  % +Eye, -Level, -Axes
          ]).
:- use_module('../picture/view', [view_matrix/3]).
:- use_module(library(apply), [maplist/3, maplist/4]).
:- use_module(library(lists), [append/2]).
/** <module> What an eye makes of the model, for a shaded picture.
*/

%!  eye_rows(+Eye, +Place, -Matrix) is det.
%
%   Matrix is that of kernel/shading.pl for Eye and Place of shaded_scene/5. In
%   a central picture depth is linear along lines of the picture, and near the
%   nearest point as large as in a parallel one.

eye_rows(Eye, place(Scale,Left,Top), Matrix) :-
    eye_axes(Eye, eye(_,_,Rho,Kind,Nearest),
             [[RX,RY,RZ,RD],[UX,UY,UZ,UD],[AX,AY,AZ,AD]]),
    (   Kind == parallel
    ->  W = [0.0,0.0,0.0,1.0],
        Depth = AD
    ;   W = [WX,WY,WZ,WD],
        WD0 is AD+Rho,
        maplist(divided(Nearest), [AX,AY,AZ,WD0], [WX,WY,WZ,WD]),
        Depth is WD0-Nearest
    ),
    row(W, Scale, [RX,RY,RZ,RD], -Scale*Left, Row1),
    row(W, -Scale, [UX,UY,UZ,UD], Scale*Top, Row2),
    row(W, Scale, [AX,AY,AZ,Depth], 0, Row3),
    append([Row1,Row2,Row3,W], Matrix).

%!  eye_axes(+Eye, -Level, -Axes) is det.
%
%   Axes are what is to the right, up and away of where Eye looks at, [A,B,C,D]
%   each: A*X + B*Y + C*Z + D. Level is the eye alone, not turned.

eye_axes(rolled(Eye,Cos,Sin), Level, [Right,Up,Away]) :-
    !,
    eye_axes(Eye, Level, [Right0,Up0,Away]),
    maplist(rolled(Cos, Sin), Right0, Up0, Right),
    Back is -Sin,
    maplist(rolled(Cos, Back), Up0, Right0, Up).
eye_axes(at(Eye,Point), Level, Axes) :-
    !,
    eye_axes(Eye, Level, Axes0),
    maplist(looking_at(Point), Axes0, Axes).
eye_axes(Level, Level, Axes) :-
    Level = eye(Theta,Phi,_,_,_),
    view_matrix(Theta, Phi, Rows),
    maplist(axis, Rows, Axes).

rolled(Cos, Sin, A, B, C) :-
    C is Cos*A + Sin*B + 0.0.

looking_at([X,Y,Z], [A,B,C,D0], [A,B,C,D]) :-
    D is D0 - (A*X + B*Y + C*Z) + 0.0.

axis(r(A0,B0,C0), [A,B,C,0.0]) :-
    maplist(float_of, [A0,B0,C0], [A,B,C]).

float_of(X, F) :-
    F is float(X) + 0.0.

divided(Divisor, X, Quotient) :-
    Quotient is X/Divisor + 0.0.

row([A2,B2,C2,D2], F, [A1,B1,C1,D1], G, [A,B,C,D]) :-
    A is F*A1 + G*A2 + 0.0,
    B is F*B1 + G*B2 + 0.0,
    C is F*C1 + G*C2 + 0.0,
    D is F*D1 + G*D2 + 0.0.
