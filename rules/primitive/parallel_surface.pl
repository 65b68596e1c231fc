:- module(sg_parallel_surface,
          [ parallel_point/5,           % +Surface, +Distance, +T, +H, -Point
            parallel_before/5,          % +Surface, +Distance, +T, +H, -H0
            parallel_plane/3,           % +Surface, +T, -Plane
            parallel_generator/4        % +Surface, +T, -Along, -Normal
          ]).
:- use_module('../angle', [exact_sin_cos/3]).
:- use_module('../vector',
              [cross_product/3, dot_product/3, scaled/3, unit/2, vector_sum/3]).
/** <module> Surfaces parallel to cylinders and cones.

parallel(Surface, Distance) is what lies Distance outside Surface, a cylinder or
a cone (primitive_face.pl), oblique and elliptic ones too (negative: within).
Along a generator the normal stays the same; so it consists of these generators,
each moved along its normal by Distance. Its parameter T is that of the
generator that was moved, and H, as that of Surface, the coordinate along W: so
H = 0 and H = 1 are where it meets the planes of base and top.

surface.c computes the same.

@see do Carmo, Differential geometry of curves and surfaces, 3-5
*/

%!  parallel_point(+Surface, +Distance, +T, +H, -Point) is det.
%
%   Point is the point (T, H) of parallel(Surface, Distance); T in degrees.
%   Rounded.

parallel_point(Surface, Distance, T, H, point(X,Y,Z)) :-
    generator(Surface, T, At, Along, Normal),
    height_gained(Surface, Distance, Normal, Gained),
    H0 is H-Gained,
    scaled(H0, Along, Up),
    scaled(Distance, Normal, Out),
    vector_sum(At, Up, Before),
    vector_sum(Before, Out, p(X,Y,Z)).

%!  parallel_before(+Surface, +Distance, +T, +H, -H0) is det.
%
%   The point (T, H) of parallel(Surface, Distance) is Distance outside the
%   point (T, H0) of Surface.

parallel_before(Surface, Distance, T, H, H0) :-
    generator(Surface, T, _, _, Normal),
    height_gained(Surface, Distance, Normal, Gained),
    H0 is H-Gained.

%!  parallel_plane(+Surface, +T, -Plane) is det.
%
%   Plane holds the generator of Surface at T, and its normal: so also that of
%   each surface parallel to it.

parallel_plane(Surface, T, plane(A,B,C,D)) :-
    generator(Surface, T, p(X,Y,Z), Along, Normal),
    cross_product(Normal, Along, p(A,B,C)),
    D is -(A*X + B*Y + C*Z).

%!  parallel_generator(+Surface, +T, -Along, -Normal) is det.
%
%   Along, p(X,Y,Z), leads from H = 0 to H = 1 of the generator of Surface at T;
%   Normal, a unit, is at right angles to Surface there, away from the axis.

parallel_generator(Surface, T, Along, Normal) :-
    generator(Surface, T, _, Along, Normal).

%   generator(Surface, T, At, Along, Normal): At is its point with H = 0, Along
%   leads to that with H = 1; Normal is a unit, away from the axis.

generator(Surface, T, At, Along, Normal) :-
    frame(Surface, C, U, V, W, Narrower),
    exact_sin_cos(T, Sin, Cos),
    Back is -Sin,
    combined(Cos, U, Sin, V, E),
    combined(Back, U, Cos, V, Turn),
    combined(Narrower, E, 1.0, W, Along),
    vector_sum(C, E, At),
    cross_product(Turn, Along, Across),
    dot_product(Across, E, Outward),
    Sign is sign(Outward),
    unit(Across, Unit),
    scaled(Sign, Unit, Normal).

%   height_gained(Surface, Distance, Normal, Gained): how far along W a point
%   comes that goes Distance along Normal, W being 1 long.

height_gained(Surface, Distance, Normal, Gained) :-
    frame(Surface, _, U, V, W, _),
    cross_product(U, V, Up),
    dot_product(Up, Normal, Rise),
    dot_product(Up, W, Whole),
    Gained is Distance*Rise/Whole.

frame(cylinder(C, U, V, W), P, PU, PV, PW, 0.0) :-
    spatial([C,U,V,W], [P,PU,PV,PW]).
frame(cone(C, U, V, W, K), P, PU, PV, PW, Narrower) :-
    Narrower is K-1.0,
    spatial([C,U,V,W], [P,PU,PV,PW]).

spatial([], []).
spatial([Term|Terms], [p(X,Y,Z)|Ps]) :-
    Term =.. [_,X,Y,Z],
    spatial(Terms, Ps).

combined(F, U, G, V, W) :-
    scaled(F, U, FU),
    scaled(G, V, GV),
    vector_sum(FU, GV, W).
