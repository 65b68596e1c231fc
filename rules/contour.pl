:- module(sg_contour,
          [ find_contours/2,            % +Segments, +Crease
            line_ends/4,                % +S, +E, -Start, -End
            contour_ends/4              % +S, +K, -Start, -End
          ]).
:- use_module(kernel, [fill_contour/6]).
:- use_module(stage, [stage/2]).
:- use_module(store, [contour/9, e/5, screen/5, t/6]).
:- use_module(view, [current_view/4]).
/** <module> Outlines of smooth surfaces, inside their triangles.
*/

:- set_prolog_flag(optimise, true).

%!  find_contours(+Segments, +Crease) is det.
%
%   Fill contour/9 of the current world for the view that screen/5 holds, from
%   Segments, `all` or a list. Faces that bend by no more than Crease degrees
%   hang together smoothly.

find_contours(Segments, Crease) :-
    current_view(Theta, Phi, Rho, Kind),
    stage(join, fill_contour(Segments, Theta, Phi, Rho, Kind, Crease)).

%!  line_ends(+S, +E, -Start, -End) is nondet.
%
%   Start and End, X-Y, are where line E of drawn/7 begins and ends in the
%   picture, whatever part of it is drawn: edge E of segment S, or, if E is
%   negative, a piece of contour/9.

line_ends(S, E, Start, End) :-
    (   E > 0
    ->  e(S, E, V1, V2, _),
        vertex_place(S, V1, Start),
        vertex_place(S, V2, End)
    ;   K is -E,
        contour_ends(S, K, Start, End)
    ).

vertex_place(S, V, X-Y) :-
    screen(S, V, X, Y, _).

%!  contour_ends(+S, +K, -Start, -End) is semidet.
%
%   Start and End, X-Y, are where piece K of contour/9 begins and ends in the
%   picture.

contour_ends(S, K, Start, End) :-
    contour(S, K, T, I1, F1, I2, F2, _, _),
    t(S, _, T, A, B, C),
    side_place(S, t(A,B,C,A), I1, F1, Start),
    side_place(S, t(A,B,C,A), I2, F2, End).

%   On the I-th side, F of the way from its smaller vertex to the larger.

side_place(S, Corners, I, F, X-Y) :-
    J is I+1,
    arg(I, Corners, V),
    arg(J, Corners, W),
    Low is min(V, W),
    High is max(V, W),
    screen(S, Low, X1, Y1, _),
    screen(S, High, X2, Y2, _),
    (   F =:= 1.0
    ->  X = X2,
        Y = Y2
    ;   X is X1 + F*(X2-X1),
        Y is Y1 + F*(Y2-Y1)
    ).
