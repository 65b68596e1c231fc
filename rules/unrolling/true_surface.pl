:- module(sg_true_surface,
          [ polygon_surface/3,          % +S, +P, -Surface
            meeting_surfaces/4,         % +S, +Leaf, +Vs, -Table
            generator_plane/3,          % +Surface, +T, -Plane
            level_plane/3,              % +Surface, +H, -Plane
            surface_normal_at/3,        % +Surface, +T, -Normal
            offset_surface/3            % +Surface, +Distance, -Offset
          ]).
:- use_module('../near', [same_direction/2, same_part/2, is_rounding/2]).
:- use_module('../angle', [exact_sin_cos/3]).
:- use_module('../primitive/parallel_surface', [parallel_plane/3]).
:- use_module('../csg/placed_surface',
              [ facet_surface/3, kept_answer/4, placed_face/3,
                placed_feature/4, placed_surface/3
              ]).
:- use_module('../vector',
              [cross_product/3, dot_product/3, scaled/3, unit/2]).
:- use_module('../store',
              [e/5, line/9, plane/6, edge_polygon/3]).
:- use_module(true_mitre, [mitre_place/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(assoc), [list_to_assoc/2]).
:- use_module(library(lists), [member/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> The smooth surfaces that a true development is made of.

A surface is a term of primitive_face.pl, or plane(Nx, Ny, Nz, D). What is cut
by another segment is bordered by where its own surface and that of the other
one meet: not where their facets do.
*/

%!  polygon_surface(+S, +P, -Surface) is semidet.
%
%   Surface is what polygon P of S stands for: the smooth surface of the
%   primitive that it was a facet of, or else its plane.

polygon_surface(S, P, Surface) :-
    (   facet_surface(S, P, Smooth),
        Smooth \= bezier(_)
    ->  Surface = Smooth
    ;   plane(S, P, A, B, C, D),
        Surface = plane(A, B, C, D)
    ),
    !.

%!  meeting_surfaces(+S, +Leaf, +Vs, -Table) is det.
%
%   Table is an assoc from those of Vs, a list of vertices of S or `all`, that
%   lie on penetration lines to met(Surfaces, Guides): Surfaces, each once, of
%   other segments than Leaf that they lie on, and planes of mitres; Guides are
%   planes through generators of these, those between facets that the vertex
%   lies on. S is Leaf, or made of it.

meeting_surfaces(S, Leaf, Vs, Table) :-
    findall(V-Place,
            ( ( Vs == all -> true ; member(V, Vs) ),
              kept_answer(met_place, S, V, Of-Place),
              Of \== Leaf ),
            Pairs0),
    sort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    maplist(group_surfaces, Groups, List),
    list_to_assoc(List, Table).

%   met_place(S, V, Of-Place) is nondet: vertex V of S lies in Place; of the
%   segment Of, if that may be what S is made of.

met_place(S, V, line-on(S2, P2)) :-
    line(_, S, _, A, B, S2, P2, _, _),
    ( V = A ; V = B ).
met_place(S, V, line-on(S1, P1)) :-
    line(_, S1, P1, _, _, S, _, A, B),
    ( V = A ; V = B ).
met_place(S, V, mitre-plane(Plane)) :-
    mitre_place(S, V, Plane).
met_place(S, V, S2-Place) :-
    placed_feature(S, V, S2, Feature),
    (   feature_polygon(Feature, S2, P2),
        Place = on(S2, P2)
    ;   Feature = e(E2),
        S2 \== S,
        Place = along(S2, E2)
    ).

feature_polygon(p(P), _, P).
feature_polygon(e(E), S, P) :-
    e(S, E, A, B, _),
    (   edge_polygon(S, E, P)
    ;   e(S, Twin, B, A, _),
        edge_polygon(S, Twin, P)
    ).
feature_polygon(v(V), S, P) :-
    e(S, E, V, _, _),
    edge_polygon(S, E, P).

group_surfaces(V-Places, V-met(Surfaces, Guides)) :-
    findall(Surface,
            place_surface(Places, Surface),
            Surfaces0),
    sort(Surfaces0, Surfaces1),
    distinct(Surfaces1, Surfaces),
    findall(Guide,
            ( member(along(S, E), Places),
              edge_guide(S, E, Guide) ),
            Guides).

place_surface(Places, Surface) :-
    member(on(S, P), Places),
    polygon_surface(S, P, Surface).
place_surface(Places, Surface) :-
    member(plane(Surface), Places).

%   edge_guide(S, E, Plane): E is an edge between two facets of one surface.

edge_guide(S, E, Plane) :-
    e(S, E, A, B, _),
    e(S, Twin, B, A, _),
    once(edge_polygon(S, E, P)),
    once(edge_polygon(S, Twin, Q)),
    placed_face(S, P, curved(Part, [A1-A2])),
    placed_face(S, Q, curved(Part, [B1-B2])),
    (   same_direction(A2, B1)
    ->  T = A2
    ;   same_direction(A1, B2),
        T = A1
    ),
    placed_surface(S, Part, Surface),
    generator_plane(Surface, T, Plane),
    !.

%   distinct(Surfaces0, Surfaces): polygons of one flat face have planes that
%   differ by rounding.

distinct([], []).
distinct([Surface|Surfaces0], Surfaces) :-
    (   member(Other, Surfaces0),
        same_plane(Surface, Other)
    ->  Surfaces = Rest
    ;   Surfaces = [Surface|Rest]
    ),
    distinct(Surfaces0, Rest).

same_plane(plane(A,B,C,D), plane(A2,B2,C2,D2)) :-
    same_part(A, A2),
    same_part(B, B2),
    same_part(C, C2),
    is_rounding(D-D2, 1.0 + abs(D)).

%!  generator_plane(+Surface, +T, -Plane) is det.
%
%   Plane holds the axis of Surface and its generator at T; of a fan, and of
%   what is parallel to another surface, it holds the generator and the normal.

generator_plane(fan(C, U, V, K), T, Plane) :-
    !,
    A is T*pi/180.0,
    B is A*(K-1.0),
    scaled_sum(A, U, 0.0, V, Along),
    scaled_sum(1.0, V, B, U, Way),
    moved_by(C, Along, Point),
    cross_product(U, V, Across),
    cross_product(Across, Way, Normal),
    point_plane(Point, Normal, Plane).
generator_plane(parallel(Surface, _), T, Plane) :-
    !,
    parallel_plane(Surface, T, Plane).
generator_plane(Surface, T, Plane) :-
    exact_sin_cos(T, Sin, Cos),
    frame(Surface, C, U, V, W),
    scaled_sum(Cos, U, Sin, V, E),
    cross_product(E, W, Normal),
    point_plane(C, Normal, Plane).

%!  level_plane(+Surface, +H, -Plane) is det.
%
%   Plane holds the points of Surface with the parameter H.

level_plane(fan(C, U, V, _), H, Plane) :-
    !,
    scaled_sum(H, V, 0.0, U, Up),
    moved_by(C, Up, Point),
    cross_product(U, V, Across),
    cross_product(U, Across, Normal),
    point_plane(Point, Normal, Plane).
level_plane(parallel(Surface, _), H, Plane) :-
    !,
    level_plane(Surface, H, Plane).
level_plane(Surface, H, Plane) :-
    frame(Surface, point(X,Y,Z), U, V, W),
    scaled_sum(1.0, vector(X,Y,Z), H, W, vector(X1,Y1,Z1)),
    cross_product(U, V, Normal),
    point_plane(point(X1,Y1,Z1), Normal, Plane).

%!  surface_normal_at(+Surface, +T, -Normal) is det.
%
%   Normal is the unit normal of Surface, a cylinder, cone or fan, along its
%   generator at T: to the left of growing H as one goes along growing T.

surface_normal_at(Surface, T, Normal) :-
    direction_along(Surface, T, Along, Up),
    cross_product(Along, Up, Across),
    unit(Across, Normal).

direction_along(fan(_, U, V, _), _, U, V) :-
    !.
direction_along(Surface, T, Along, Up) :-
    exact_sin_cos(T, Sin, Cos),
    frame(Surface, _, U, V, W),
    Back is -Sin,
    scaled_sum(Back, U, Cos, V, Along),
    scaled_sum(Cos, U, Sin, V, E),
    (   Surface = cone(_, _, _, _, K)
    ->  F is K-1.0
    ;   F = 0.0
    ),
    scaled_sum(F, E, 1.0, W, Up).

frame(Surface, C, U, V, W) :-
    Surface =.. [_,C,U,V,W|_].

moved_by(point(X0,Y0,Z0), vector(A,B,C), point(X,Y,Z)) :-
    X is X0+A,
    Y is Y0+B,
    Z is Z0+C.

scaled_sum(F, vector(X1,Y1,Z1), G, vector(X2,Y2,Z2), vector(X,Y,Z)) :-
    X is F*X1 + G*X2,
    Y is F*Y1 + G*Y2,
    Z is F*Z1 + G*Z2.

point_plane(point(X,Y,Z), vector(A,B,C), plane(A,B,C,D)) :-
    D is -(A*X + B*Y + C*Z).

%!  offset_surface(+Surface, +Distance, -Offset) is semidet.
%
%   Offset is Distance outside Surface everywhere (negative: within). Fails if
%   it is none of the surfaces here, or shrinks to nothing: of cylinders and
%   cones the right circular ones have one, of spheres and tori the round ones.

offset_surface(Surface, Distance, Offset) :-
    (   Distance =:= 0.0
    ->  Offset = Surface
    ;   offset_(Surface, Distance, Offset)
    ).

offset_(plane(A,B,C,D), Distance, plane(A,B,C,D1)) :-
    D1 is D - Distance*sqrt(A*A + B*B + C*C).
offset_(cylinder(C,U,V,W), Distance, cylinder(C,U1,V1,W)) :-
    round_axes(U, V, W, R, _),
    F is 1.0 + Distance/R,
    enlarged(F, U, U1),
    enlarged(F, V, V1).
offset_(cone(C,U,V,W,K), Distance, cone(C,U1,V1,W,K1)) :-
    round_axes(U, V, W, R, H),
    Far is H/abs(1.0-K),                % from the base to the apex
    By is Distance*sqrt(Far*Far + R*R)/Far,
    F is 1.0 + By/R,
    enlarged(F, U, U1),
    enlarged(F, V, V1),
    K1 is (K*R + By)/(R + By).
offset_(sphere(C,U,V,W), Distance, sphere(C,U1,V1,W1)) :-
    round_axes(U, V, W, R, R1),
    is_rounding(R-R1, R),
    F is 1.0 + Distance/R,
    enlarged(F, U, U1),
    enlarged(F, V, V1),
    enlarged(F, W, W1).
offset_(torus(C,U,V,W,K), Distance, torus(C,U,V,W,K1)) :-
    round_axes(U, V, W, R, R1),
    is_rounding(R-R1, R),
    K1 is K + Distance/R,
    K1 > 0.0.

enlarged(F, U, V) :-
    F > 0.0,
    scaled(F, U, V).

%   round_axes(U, V, W, R, H): U and V are R long, W is H long, all at right
%   angles.

round_axes(U, V, W, R, H) :-
    dot_product(U, U, UU),
    dot_product(V, V, VV),
    dot_product(W, W, WW),
    R is sqrt(UU),
    H is sqrt(WW),
    is_rounding(UU-VV, UU),
    right_angle(U, V, R*R),
    right_angle(U, W, R*H),
    right_angle(V, W, R*H).

right_angle(A, B, Size) :-
    dot_product(A, B, Dot),
    is_rounding(Dot, Size).
