:- module(sg_primitive_globe,
          [ sphere_shape/2,             % +Given, -Shape
            egg_shape/2,                % +Given, -Shape
            hemisphere_shape/2,         % +Given, -Shape
            torus_shape/2,              % +Given, -Shape
            globe_parts/4               % +Maker, +Given, -Parts, -Surfaces
          ]).
:- use_module('../angle', [exact_sin_cos/3]).
:- use_module(primitive_argument,
              [given/3, given_facets/4, primitive_error/2, vertices_within/2]).
:- use_module(shape, [ring_points/4, round_angle/4]).
:- use_module(library(apply), [foldl/4, maplist/3, maplist/4]).
:- use_module(library(lists), [append/2, append/3, numlist/3, reverse/2]).
/** <module> Primitives that are curved both ways: sphere, egg, torus.

Sphere, egg and torus have their centre in the origin; the hemisphere stands on
z = 0. Facets are counted round the z axis; bands from pole to pole (of a
hemisphere: to the rim), of the same angle each. Facets are flat: trapezoids,
and triangles at the poles. A tolerance is halved between the two ways. For
shapes see shape.pl.
*/

%!  sphere_shape(+Given, -Shape) is det.

sphere_shape(Given, Shape) :-
    given(Given, radius, Radius),
    three_radii(Radius, [A, B, C]),
    counts(Given, A, B, [C], 180, N, M),
    at_least(Given, bands, M, 2),
    latitudes(M, 180, -90, Lats),
    globe(Lats, N, A-B, C, C, Points, Faces),
    Shape = shape(Points, Faces, [sphere-Surface]),
    sphere_surface(A, B, C, Surface).

three_radii(Numbers, Radii) :-
    (   Numbers = [R]
    ->  Radii = [R, R, R]
    ;   Radii = Numbers
    ).

sphere_surface(A, B, C,
               sphere(point(0.0, 0.0, 0.0), vector(A, 0.0, 0.0),
                      vector(0.0, B, 0.0), vector(0.0, 0.0, C))).

%   counts(Given, A, B, Heights, Degrees, N, M): N facets round, M bands in so
%   many Degrees from low to high.

counts(Given, A, B, Heights, Degrees, N, M) :-
    halved(Given, Half),
    foldl(greater, [B|Heights], A, Greatest),
    Round is max(A, B),
    given_facets(Half, Round, 360, N),
    given(Given, bands, Bands),
    (   Bands = [M]
    ->  true
    ;   given(Given, tolerance, none)
    ->  M is max(1, ceiling(N*Degrees rdiv 360))
    ;   given_facets(Half, Greatest, Degrees, M)
    ),
    Vertices is N*M,
    vertices_within(Vertices, Given).

greater(A, B, C) :-
    C is max(A, B).

%   halved(Given, Half): with half the tolerance.

halved(given(Term, Stretch0, Values), given(Term, Stretch, Values)) :-
    Stretch is 2.0*Stretch0.

at_least(Given, Name, N, Least) :-
    (   N >= Least
    ->  true
    ;   Given = given(Term, _, _),
        primitive_error(few(Name, N, Least), Term)
    ).

%   latitudes(M, Degrees, From, Lats): M+1 of them, rationals.

latitudes(M, Degrees, From, Lats) :-
    Last is M+1,
    numlist(1, Last, Is),
    maplist(latitude(M, Degrees, From), Is, Lats).

latitude(M, Degrees, From, I, Lat) :-
    round_angle(M, Degrees, I, Angle),
    Lat is From+Angle.

%   globe(Lats, N, Radii, Down, Up, Points, Faces): rings at the latitudes
%   Lats, poles where they are -90 and 90; below the equator the half axis is
%   Down, above Up.

globe(Lats, N, Radii, Down, Up, Points, Faces) :-
    maplist(globe_row(N, Radii, Down, Up), Lats, Rows),
    append(Rows, Points),
    globe_faces(Lats, Rows, 1, N, Faces0),
    append(Faces0, Faces).

globe_row(N, A-B, Down, Up, Lat, Row) :-
    exact_sin_cos(Lat, Sin, Cos),
    (   Lat < 0
    ->  Z is Down*Sin + 0.0
    ;   Z is Up*Sin + 0.0
    ),
    (   abs(Lat) =:= 90
    ->  Row = [point(0.0, 0.0, Z)]
    ;   A1 is A*Cos,
        B1 is B*Cos,
        ring_points(A1-B1, point(0.0, 0.0, Z), N, Row)
    ).

globe_faces([_], [_], _, _, []) :-
    !.
globe_faces([Lat1, Lat2|Lats], [Row1, Row2|Rows], First1, N,
            [Faces|Rest]) :-
    length(Row1, Count1),
    First2 is First1+Count1,
    length(Row2, Count2),
    globe_part(Lat1, Lat2, Part),
    numlist(1, N, Is),
    maplist(band_face(Part, N, First1-Count1, First2-Count2), Is, Faces),
    globe_faces([Lat2|Lats], [Row2|Rows], First2, N, Rest).

globe_part(Lat1, Lat2, S1-S2) :-
    S1 is float(Lat1),
    S2 is float(Lat2).

band_face(S, N, Low, High, I, face(curved(sphere, [T1-T2, S]), [Loop])) :-
    J is I mod N + 1,
    I1 is I+1,
    round_angle(N, 360, I, Angle1),
    round_angle(N, 360, I1, Angle2),
    T1 is float(Angle1),
    T2 is float(Angle2),
    row_vertex(Low, I, A),
    row_vertex(Low, J, B),
    row_vertex(High, J, C),
    row_vertex(High, I, D),
    (   A =:= B
    ->  Loop = [A, C, D]
    ;   C =:= D
    ->  Loop = [A, B, C]
    ;   Loop = [A, B, C, D]
    ).

row_vertex(First-Count, I, V) :-
    (   Count =:= 1
    ->  V = First
    ;   V is First+I-1
    ).

%!  globe_parts(+Maker, +Given, -Parts, -Surfaces) is semidet.
%
%   What primitive_parts/3 says of the shape that Maker makes of Given, without
%   making it: globes have many facets. Fails for other shapes.

globe_parts(sphere_shape, Given, [part(Count, curved(sphere, Turn))],
            [sphere-Surface]) :-
    given(Given, radius, Radius),
    three_radii(Radius, [A, B, C]),
    counts(Given, A, B, [C], 180, N, M),
    at_least(Given, bands, M, 2),
    sphere_surface(A, B, C, Surface),
    turn(N, M, 180, Turn),
    Count is N*M.
globe_parts(hemisphere_shape, Given,
            [part(1, flat), part(Count, curved(sphere, Turn))],
            [sphere-Surface]) :-
    given(Given, radius, Radius),
    three_radii(Radius, [A, B, C]),
    counts(Given, A, B, [C], 90, N, M),
    sphere_surface(A, B, C, Surface),
    turn(N, M, 90, Turn),
    Count is N*M.
globe_parts(torus_shape, Given, [part(Count, curved(torus, Turn))],
            [torus-Surface]) :-
    torus_counts(Given, R, Tube, N, M),
    torus_surface(R, Tube, Surface),
    turn(N, M, 360, Turn),
    Count is N*M.

%   turn(N, M, Degrees, Turn): the wider of N facets round and M bands in so
%   many Degrees.

turn(N, M, Degrees, Turn) :-
    Turn is max(360.0/N, float(Degrees)/M).

%!  egg_shape(+Given, -Shape) is det.
%
%   Half an ellipsoid upwards and half another one downwards; parts `upper` and
%   `lower`.
%
%   @error odd(bands, M)

egg_shape(Given, shape(Points, Faces, [lower-Lower, upper-Upper])) :-
    given(Given, radius, [R]),
    given(Given, up, [Up]),
    given(Given, down, [Down]),
    counts(Given, R, R, [Up, Down], 180, N, M0),
    (   M0 mod 2 =:= 0
    ->  M = M0
    ;   given(Given, bands, none)
    ->  M is M0+1
    ;   Given = given(Term, _, _),
        primitive_error(odd(bands, M0), Term)
    ),
    latitudes(M, 180, -90, Lats),
    globe(Lats, N, R-R, Down, Up, Points, Faces0),
    maplist(egg_face, Faces0, Faces),
    sphere_surface(R, R, Down, Lower),
    sphere_surface(R, R, Up, Upper).

egg_face(face(curved(_, [T, S1-S2]), Loops), face(What, Loops)) :-
    (   S1 < 0.0
    ->  Part = lower
    ;   Part = upper
    ),
    What = curved(Part, [T, S1-S2]).

%!  hemisphere_shape(+Given, -Shape) is det.

hemisphere_shape(Given, shape(Points, [face(base, [Base])|Faces],
                              [sphere-Surface])) :-
    given(Given, radius, Radius),
    three_radii(Radius, [A, B, C]),
    counts(Given, A, B, [C], 90, N, M),
    latitudes(M, 90, 0, Lats),
    globe(Lats, N, A-B, C, C, Points, Faces),
    numlist(1, N, Ring),
    reverse(Ring, Base),
    sphere_surface(A, B, C, Surface).

%!  torus_shape(+Given, -Shape) is det.
%
%   The ring lies in the plane z = 0. Vertex I + N*(J-1) is at the I-th facet
%   and the J-th side of the tube, counted from the outermost circle upwards.
%
%   @error tube_too_large

torus_shape(Given, shape(Points, Faces, [torus-Surface])) :-
    torus_counts(Given, R, Tube, N, M),
    torus_surface(R, Tube, Surface),
    numlist(1, M, Js),
    maplist(torus_row(R, Tube, N, M), Js, Rows),
    append(Rows, Points),
    maplist(torus_faces(N, M), Js, Faces0),
    append(Faces0, Faces).

torus_counts(Given, R, Tube, N, M) :-
    Given = given(Term, _, _),
    given(Given, radius, [R]),
    given(Given, tube, [Tube]),
    (   Tube < R
    ->  true
    ;   primitive_error(tube_too_large, Term)
    ),
    halved(Given, Half),
    Outermost is R+Tube,
    given_facets(Half, Outermost, 360, N),
    tube_sides(Given, Half, Tube, N, M),
    Vertices is N*M,
    vertices_within(Vertices, Given).

torus_surface(R, Tube,
              torus(point(0.0, 0.0, 0.0), vector(R, 0.0, 0.0),
                    vector(0.0, R, 0.0), vector(0.0, 0.0, R), K)) :-
    K is Tube/R.

tube_sides(Given, Half, Tube, N, M) :-
    given(Given, sides, Sides),
    (   Sides = [M]
    ->  true
    ;   given(Given, tolerance, none)
    ->  M is max(3, N//2)
    ;   given_facets(Half, Tube, 360, M)
    ).

torus_row(R, Tube, N, M, J, Row) :-
    round_angle(M, 360, J, Angle),
    exact_sin_cos(Angle, Sin, Cos),
    A is R + Tube*Cos,
    Z is Tube*Sin + 0.0,
    ring_points(A-A, point(0.0, 0.0, Z), N, Row).

torus_faces(N, M, J, Faces) :-
    numlist(1, N, Is),
    K is J mod M + 1,
    J1 is J+1,
    round_angle(M, 360, J, Angle1),
    round_angle(M, 360, J1, Angle2),
    S1 is float(Angle1),
    S2 is float(Angle2),
    First1 is N*(J-1)+1,
    First2 is N*(K-1)+1,
    maplist(torus_face(S1-S2, N, First1-N, First2-N), Is, Faces).

torus_face(S, N, Low, High, I, face(curved(torus, Ranges), Loops)) :-
    band_face(S, N, Low, High, I, face(curved(_, Ranges), Loops)).
