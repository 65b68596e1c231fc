:- module(sg_contour,
          [ find_contours/2,            % +Segments, +Crease
            smoothness/2,               % +Crease, -Smooth
            faceted_segments/1,         % -Faceted
            smooth_segment/1,           % +S
            dividing_piece/3,           % +S, +T, -K
            contour_ends/4,             % +S, +K, -Start, -End
            line_ends/4,                % +S, +E, -Start, -End
            side_place/5                % +S, +Corners, +I, +F, -Place
          ]).
:- use_module('../csg/known_surface', [known_surfaces/1]).
:- use_module('../decision', [decision/2, decision_is_default/1]).
:- use_module('../kernel', [fill_contour/7]).
:- use_module('../stage', [stage/2]).
:- use_module('../store', [contour/13, e/5, screen/5, segment/3, t/6]).
:- use_module(view, [current_view/4]).
/** <module> Outlines of smooth surfaces, inside their triangles.

The kernel c_kernels/picture/contour.c finds the outlines and fills contour/13:
pieces, each across one triangle or along a side. tests/oracle/contour.pl states
what it does as rules, slowly, and tests compare the two.

The outline goes through the places where the surface turns from the eye. A
piece begins and ends on the surface, which lies above the side that it crosses.
There the surface, and not the triangle, hides what is behind it: instead of the
triangle hide the parts into which the ends of the piece divide it.

@see Hertzmann & Zorin 2000, Illustrating smooth surfaces, section 3.
*/

:- set_prolog_flag(optimise, true).

%!  find_contours(+Segments, +Crease) is det.
%
%   Fill contour/13 and surface_facing/6 of the current world for the view that
%   screen/5 holds, from Segments, `all` or a list. Faces that bend by no more
%   than Crease degrees are connected smoothly.

find_contours(Segments, Crease) :-
    current_view(Theta, Phi, Rho, Kind),
    smoothness(Crease, Smooth),
    stage(join,
          (   fill_contour(Segments, Theta, Phi, Rho, Kind, Smooth, kept)
          ->  true
          ;   known_surfaces(Known),
              fill_contour(Segments, Theta, Phi, Rho, Kind, Smooth, Known)
          )).

%!  smoothness(+Crease, -Smooth) is det.
%
%   Smooth is smooth(Crease, Faceted), Faceted by faceted_segments/1.

smoothness(Crease, smooth(Crease,Faceted)) :-
    faceted_segments(Faceted).

%!  faceted_segments(-Faceted:list) is det.
%
%   Faceted are the segments for which smooth_segment/1 is not true.

faceted_segments(Faceted) :-
    (   decision_is_default(smooth_segment/1)
    ->  Faceted = []
    ;   findall(S, ( segment(S, _, _), \+ smooth_segment(S) ), Faceted)
    ).

:- decision(smooth_segment/1,
            "Which segments have outlines inside their triangles").

%!  smooth_segment(+S) is semidet.
%
%   True when the curved sheets of segment S stand for smooth surfaces, so that
%   their outlines run through their triangles, and facets of primitives for the
%   surfaces of these (known_surface.pl). They always do. A decision: a world
%   can say that a segment is what its facets are.

smooth_segment(_).

/* - - - where lines are in the picture - - - */

%!  line_ends(+S, +E, -Start, -End) is nondet.
%
%   Start and End, X-Y, are where line E of drawn/7 begins and ends in the
%   picture, whatever part of it is drawn: edge E of segment S, or, if E is
%   negative, a piece of contour/13.

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
%   Start and End, X-Y, are where piece K of contour/13 begins and ends in the
%   picture.

contour_ends(S, K, Start, End) :-
    contour(S, K, T, I1, F1, I2, F2, _, _, X1, Y1, X2, Y2),
    t(S, _, T, A, B, C),
    side_place(S, t(A,B,C,A), I1, F1, Side1),
    side_place(S, t(A,B,C,A), I2, F2, Side2),
    risen(Side1, X1-Y1, Start),
    risen(Side2, X2-Y2, End).

risen(X0-Y0, DX-DY, X-Y) :-
    X is X0+DX,
    Y is Y0+DY.

%!  side_place(+S, +Corners, +I, +F, -Place) is det.
%
%   Place, X-Y of the picture, is F of the way along the I-th side, from its
%   smaller vertex to the larger one. Corners is t(V1,V2,V3,V1).

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

%!  dividing_piece(+S, +T, -K) is nondet.
%
%   True when piece K of contour/13 runs across triangle T of segment S, and
%   begins or ends above it on the surface.

dividing_piece(S, T, K) :-
    contour(S, K, T, I1, _, I2, _, _, _, X1, Y1, X2, Y2),
    I1 =\= I2,
    \+ ( X1 =:= 0.0, Y1 =:= 0.0, X2 =:= 0.0, Y2 =:= 0.0 ).
