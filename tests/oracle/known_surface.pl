:- module(sg_oracle_known_surface,
          [ polygon_surface/4,          % +S, +P, -Id, -Surface
            polygon_face/3,             % +S, +P, -Id
            segment_facets/3,           % +S, -Surfaces, -Runs
            surface_normal/4,           % +Surface, +Point, +Facet, -Normal
            surface_height/4,           % +Surface, +Point, +Facet, -Height
            surface_straight/3          % +Surface, +Point1, +Point2
          ]).
:- use_module(bezier_normal, [patch_normal/3]).
:- use_module('../../rules/csg/known_surface',
              [moved_join/2, moved_surface/3, segment_surfaces/3]).
:- use_module('../../rules/store', [from_p/5, p/3]).
:- use_module('../../rules/vector',
              [ angle_between/3, cross_product/3, difference/3, dot_product/3,
                scaled/3 ]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists),
              [append/3, last/2, member/2, memberchk/2, nth1/3, reverse/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> The rule of which surface a polygon is a facet of.

It asks polygon by polygon what rules/csg/known_surface.pl says of segments, and
where the surface looks at a point. c_kernels/picture/known_surface.c does the
same for a whole world.
*/

%!  polygon_surface(+S, +P, -Id, -Surface) is semidet.
%
%   True when polygon P of segment S is a facet of Surface. Id is S0-K for the
%   K-th of segment S0 by segment_surfaces/3, moved(S1, Id1) for that of Id1
%   moved with the join S1. Of what was combined the first part of P counts.

polygon_surface(S, P, Id, Surface) :-
    polygon_part(S, P, Id, surface(Surface)).

%!  polygon_face(+S, +P, -Id) is semidet.
%
%   True when polygon P of segment S is (a part of) a face that a term names,
%   and no facet of a surface. Id is S0-face(P0) for polygon P0 of segment S0,
%   S0-K for face K of it by segment_surfaces/3, or moved(S1, Id1).

polygon_face(S, P, Id) :-
    polygon_part(S, P, Id, face).

polygon_part(S, P, Id, What) :-
    most_steps(Steps),
    polygon_part_(Steps, S, P, Id, What).

polygon_part_(Steps, S, P, Id, What) :-
    (   segment_surfaces(S, Surfaces, Runs)
    ->  member(run(P1,P2,K), Runs),
        P >= P1,
        P =< P2,
        !,
        run_part(K, S, P, Surfaces, Id, What)
    ;   Steps > 1,
        Steps1 is Steps-1,
        once(from_p(S, P, S0, P0, _)),
        polygon_part_(Steps1, S0, P0, Id0, What0),
        (   moved_join(S, Matrix)
        ->  moved_part(What0, Matrix, What),
            Id = moved(S,Id0)
        ;   What = What0,
            Id = Id0
        )
    ).

run_part(0, S, P, _, Id, What) =>
    Id = S-face(P),
    What = face.
run_part(K, S, _, Surfaces, Id, What), K > 0 =>
    nth1(K, Surfaces, Surface),
    Id = S-K,
    What = surface(Surface).
run_part(K, S, _, _, Id, What) =>
    Id = S-K,
    What = face.

moved_part(face, _, face).
moved_part(surface(Surface0), Matrix, surface(Surface)) :-
    moved_surface(Matrix, Surface0, Surface).

%   How many results a polygon can have come through.

most_steps(32).

%!  segment_facets(+S, -Surfaces, -Runs) is det.
%
%   As segment_surfaces/3, but of any segment, by polygon_surface/4 and
%   polygon_face/3: Surfaces are in the order of their first facets, faces that
%   several polygons are of too, and Runs are as long as can be.

segment_facets(S, Surfaces, Runs) :-
    findall(P, p(S, P, _), Ps0),
    sort(Ps0, Ps),
    findall(P-Part, ( member(P, Ps), part_of_polygon(S, P, Part) ), Parts),
    faces_shared(Parts, Shared),
    foldl(polygon_numbered(Shared), Parts, Numbers, numbers([],[]), Last),
    group_pairs_by_key(Numbers, Groups),
    foldl(run_added, Groups, [], Runs0),
    reverse(Runs0, Runs),
    Last = numbers(Numbered,_),
    findall(Surface, member(_-Surface, Numbered), Surfaces0),
    reverse(Surfaces0, Surfaces).

part_of_polygon(S, P, Part) :-
    (   polygon_part(S, P, Id, What)
    ->  Part = part(Id,What)
    ;   Part = none
    ).

%   faces_shared(Parts, Shared): the faces that several polygons are of.

faces_shared(Parts, Shared) :-
    findall(Id, member(_-part(Id,face), Parts), Ids0),
    msort(Ids0, Ids),
    findall(Id, append(_, [Id,Id|_], Ids), Shared0),
    sort(Shared0, Shared).

%   polygon_numbered(Shared, P-Part, K-P, Numbers0, Numbers): K as in a run, or
%   `none`. Numbers are numbers(Surfaces, Faces), Id-Surface and Id of those
%   that have a number, the latest first.

polygon_numbered(_, P-none, none-P, Numbers, Numbers).
polygon_numbered(Shared, P-part(Id,face), K-P, numbers(Surfaces,Faces0),
                 numbers(Surfaces,Faces)) :-
    (   memberchk(Id, Shared)
    ->  numbered(Id, Faces0, Faces, I),
        K is -I
    ;   K = 0,
        Faces = Faces0
    ).
polygon_numbered(_, P-part(Id,surface(Surface)), K-P, numbers(Surfaces0,Faces),
                 numbers(Surfaces,Faces)) :-
    numbered(Id-Surface, Surfaces0, Surfaces, K).

%   numbered(Item, Items0, Items, I): I is the place of Item from the end.

numbered(Item, Items0, Items, I) :-
    (   append(_, [Item|Rest], Items0)
    ->  Items = Items0,
        length([Item|Rest], I)
    ;   Items = [Item|Items0],
        length(Items, I)
    ).

run_added(none-_, Runs, Runs) :-
    !.
run_added(K-Ps, Runs, [run(P1,P2,K)|Runs]) :-
    Ps = [P1|_],
    last(Ps, P2).

%!  surface_normal(+Surface, +Point, +Facet, -Normal) is semidet.
%
%   Normal is the unit normal of Surface at Point, on it or near it, on the side
%   of Facet, the normal of a facet there. Points and vectors are p(X,Y,Z).
%   Fails where there is none, or where it is more than 78 degrees from Facet.
%
%   With [U V W] the matrix of the frame, the gradient of what is zero on the
%   surface is mapped by the transpose of its inverse.

surface_normal(surface(Kind,Frame,A,B), Point, Facet, Normal) :-
    (   Kind == bezier
    ->  patch_normal(Frame, Point, Gradient)
    ;   placed_gradient(Kind, Frame, A, B, Point, Gradient)
    ),
    on_side(Gradient, Facet, Normal).

placed_gradient(Kind, Frame, A, B, Point, p(X,Y,Z)) :-
    Kind \== free,
    surface_inverse(Frame, Volume, Rows),
    Rows = [RowU,RowV,RowW],
    surface_coordinates(Frame, Volume, Rows, Point, Local),
    gradient(Kind, A, B, Local, [GX,GY,GZ]),
    scaled(GX, RowU, p(X1,Y1,Z1)),
    scaled(GY, RowV, p(X2,Y2,Z2)),
    scaled(GZ, RowW, p(X3,Y3,Z3)),
    X is X1+X2+X3,
    Y is Y1+Y2+Y3,
    Z is Z1+Z2+Z3.

%!  surface_height(+Surface, +Point, +Facet, -Height) is semidet.
%
%   Surface is Height above Point, which is near it, along its normal there, by
%   the first step of Newton's method. Fails where there is no normal, as
%   above, and for other kinds than are measured here.

surface_height(surface(Kind,Frame,A,B), Point, Facet, Height) :-
    surface_inverse(Frame, Volume, Rows),
    surface_coordinates(Frame, Volume, Rows, Point, Local),
    value(Kind, A, B, Local, Value),
    placed_gradient(Kind, Frame, A, B, Point, p(X,Y,Z)),
    on_side(p(X,Y,Z), Facet, Normal),
    dot_product(p(X,Y,Z), Normal, Lean),
    Height is -Value/(Lean/Volume).

%   Half of what is zero on the surface.

value(tapered, A, B, [X,Y,H], Value) :-
    U is X/(1.0-H+H*A),
    V is Y/(1.0-H+H*B),
    Value is (U*U + V*V - 1.0)/2.
value(turned, A, B, Local, Value) :-
    value(tapered, A, B, Local, Value).
value(sphere, _, _, [X,Y,H], Value) :-
    Value is (X*X + Y*Y + H*H - 1.0)/2.
value(torus, A, _, [X,Y,H], Value) :-
    Off is sqrt(X*X + Y*Y) - 1.0,
    Value is (Off*Off + H*H - A*A)/2.

%   surface_inverse(Frame, Volume, Rows): Rows are those of the inverse of the
%   matrix of U, V and W, times Volume.

surface_inverse([_,_,_,UX,UY,UZ,VX,VY,VZ,WX,WY,WZ], Volume,
                [RowU,RowV,RowW]) :-
    U = p(UX,UY,UZ),
    V = p(VX,VY,VZ),
    W = p(WX,WY,WZ),
    cross_product(V, W, RowU),
    cross_product(W, U, RowV),
    cross_product(U, V, RowW),
    dot_product(U, RowU, Volume),
    Volume =\= 0.0.

surface_coordinates([CX,CY,CZ|_], Volume, Rows, Point, Local) :-
    difference(Point, p(CX,CY,CZ), From),
    maplist(coordinate(From, Volume), Rows, Local).

coordinate(From, Volume, Row, Coordinate) :-
    dot_product(From, Row, Product),
    Coordinate is Product/Volume.

%!  surface_straight(+Surface, +Point1, +Point2) is semidet.
%
%   True when Surface is tapered or turned, and both points, p(X,Y,Z), on it or
%   near it, are on one straight line of it.

surface_straight(surface(Kind,Frame,A,B), Point1, Point2) :-
    memberchk(Kind, [tapered,turned]),
    surface_inverse(Frame, Volume, Rows),
    maplist(way_from_axis(Frame, Volume, Rows, A, B), [Point1,Point2], Ways),
    (   memberchk(apex, Ways)
    ->  true
    ;   Ways = [Way1,Way2],
        angle_between(Way1, Way2, Angle),
        Angle*180/pi < 1.0e-4
    ).

way_from_axis(Frame, Volume, Rows, A, B, Point, Way) :-
    surface_coordinates(Frame, Volume, Rows, Point, [X,Y,H]),
    RA is 1.0-H+H*A,
    RB is 1.0-H+H*B,
    (   ( RA < 1.0e-9 ; RB < 1.0e-9 )
    ->  Way = apex
    ;   U is X/RA,
        V is Y/RB,
        Way = p(U,V,0.0)
    ).

gradient(tapered, A, B, [X,Y,H], [GX,GY,GH]) :-
    RA is 1.0-H+H*A,
    RB is 1.0-H+H*B,
    RA >= 1.0e-9,
    RB >= 1.0e-9,
    U is X/RA,
    V is Y/RB,
    Radius is sqrt(U*U + V*V),
    Radius >= 1.0e-9,
    GX is Radius*U/RA,
    GY is Radius*V/RB,
    GH is -(U*U*(A-1.0)/RA + V*V*(B-1.0)/RB).
gradient(turned, A, B, Local, Gradient) :-
    gradient(tapered, A, B, Local, Gradient).
gradient(sphere, _, _, Local, Local).
gradient(torus, _, _, [X,Y,H], [GX,GY,H]) :-
    Radius is sqrt(X*X + Y*Y),
    Radius >= 1.0e-9,
    GX is (Radius-1.0)*X/Radius,
    GY is (Radius-1.0)*Y/Radius.

on_side(Gradient, Facet, Normal) :-
    dot_product(Gradient, Gradient, Square),
    dot_product(Facet, Facet, FacetSquare),
    dot_product(Gradient, Facet, Lean),
    abs(Lean) > 0.2*sqrt(Square*FacetSquare),
    Factor is copysign(1.0/sqrt(Square), Lean),
    scaled(Factor, Gradient, Normal).
