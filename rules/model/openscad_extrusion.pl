:- module(sg_openscad_extrusion,
          [ linear_extruded/3,          % +Node, +Region, -Terms
            rotate_extruded/3           % +Node, +Region, -Terms
          ]).
:- use_module(openscad_argument,
              [ openscad_argument/5, openscad_knows/2, openscad_fragments/3,
                openscad_error/2
              ]).
:- use_module(openscad_leaf, [sound_primitive/2]).
:- use_module('../polygon/region', [region_islands/2]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3, max_list/2, member/2, min_list/2]).
/** <module> Extrusions of an OpenSCAD .csg file.

The region below the node is worked out in the plane first, as OpenSCAD does:
how fine an extrusion is depends on how far out the whole of it reaches, and
walls that twist on the outline of the whole. Every island becomes a primitive
of its own; a hole that touches a border in a point is taken away as one.
*/

%!  linear_extruded(+Node, +Region, -Terms) is det.
%
%   Terms are the solids of the linear_extrude Node over Region, none if it has
%   no height.
%
%   @error those of openscad_argument/5

linear_extruded(Node, Region, Terms) :-
    openscad_knows(Node, [ height, center, convexity, twist, slices, scale,
                           '$fn', '$fa', '$fs' ]),
    openscad_argument(Node, height, number, 1, H),
    openscad_argument(Node, center, flag, false, Center),
    openscad_argument(Node, twist, number, 0, Twist),
    openscad_argument(Node, scale, factors, [1, 1], Scale),
    (   H > 0
    ->  region_islands(Region, Islands),
        outline_points(Islands, Points),
        slices(Node, Points, H, Twist, Scale, Slices),
        smooth_argument(Node, Smooth),
        Turn is -Twist,
        Maker = extrusion(Node, Smooth, H, Turn, Scale, Slices),
        maplist(island_term(Maker), Islands, Terms0),
        maplist(centred(Center, H), Terms0, Terms)
    ;   Terms = []
    ).

outline_points(Islands, Points) :-
    findall(Point, ( member(island(Outline, _, _), Islands),
                     member(Point, Outline) ),
            Points).

centred(false, _, Term, Term).
centred(true, H, Term, at([translate(0, 0, Z)], Term)) :-
    Z is -H/2.0.

extrusion(Node, Smooth, H, Turn, [A, B], Slices, Outline, Holes, Term) :-
    Node = node(_, _, _, _, Place),
    (   Holes == []
    ->  Arguments = [height(H)|Smooth]
    ;   Arguments = [holes(Holes), height(H)|Smooth]
    ),
    (   Turn =:= 0,
        A =:= 0,
        B =:= 0
    ->  Term =.. [pyramid, outline(Outline)|Arguments]
    ;   Turn =:= 0,
        A =:= 1,
        B =:= 1
    ->  Term =.. [prism, outline(Outline)|Arguments]
    ;   append(Arguments, [twist(Turn), scale(A, B), slices(Slices)], More),
        Term =.. [prism, outline(Outline)|More]
    ),
    sound_primitive(Term, Place).

%   smooth_argument(Node, Arguments): a circle below Node is a divided curve, so
%   no wall over it is a face for itself.

smooth_argument(Node, Arguments) :-
    (   below(Node, circle)
    ->  Arguments = [smooth(true)]
    ;   Arguments = []
    ).

below(node(_, _, _, Children, _), Name) :-
    member(Child, Children),
    (   Child = node(_, Name, _, _, _)
    ;   below(Child, Name)
    ),
    !.

:- meta_predicate island_term(3, +, -).

%   island_term(Maker, Island, Term): call(Maker, Outline, Holes, Term) makes a
%   solid of an outline with holes.

island_term(Maker, island(Outline0, Holes0, Bays0), Term) :-
    maplist(listed, [Outline0|Holes0], [Outline|Holes]),
    maplist(listed, Bays0, Bays),
    call(Maker, Outline, Holes, Body),
    (   Bays == []
    ->  Term = Body
    ;   maplist(bay_term(Maker), Bays, Cuts),
        Term = difference([Body|Cuts])
    ).

bay_term(Maker, Bay, Term) :-
    call(Maker, Bay, [], Term).

listed(Loop, Points) :-
    maplist(listed_point, Loop, Points).

listed_point(X-Y, [X, Y]).


                /*******************************
                *            SLICES            *
                *******************************/

%   slices(Node, Points, H, Twist, Scale, N): as OpenSCAD 2021 counts them: by
%   the length of the way of the point farthest out, in steps of $fs, but not
%   more than one in $fa degrees, nor fewer than one in 120. Scaling by two
%   different factors is counted by the longest way in the plane.

slices(Node, Points, H, Twist, [A, B], N) :-
    openscad_argument(Node, slices, count, none, Given),
    (   Given \== none
    ->  N is max(1, Given)
    ;   Twist =:= 0,
        A =:= B
    ->  N = 1
    ;   Fineness = fineness(_, _, _),
        fineness(Node, Fineness),
        turning_slices(Points, H, Twist, A-B, Fineness, N1),
        (   A =:= B
        ->  N = N1
        ;   straight_slices(Points, H, A-B, Fineness, N2),
            N is max(N1, N2)
        )
    ).

fineness(Node, fineness(Count, Angle, Size)) :-
    openscad_argument(Node, '$fn', number, 0, Count),
    openscad_argument(Node, '$fa', number, 12, Angle0),
    openscad_argument(Node, '$fs', number, 2, Size0),
    Angle is max(0.01, Angle0),
    Size is max(0.01, Size0).

turning_slices(_, _, Twist, _, _, 1) :-
    Twist =:= 0,
    !.
turning_slices(Points, H, Twist, A-B, fineness(Count, Angle, Size), N) :-
    Turn is abs(Twist),
    Least is max(1, ceiling(Turn/120.0)),
    (   Count > 0
    ->  N is max(Least, ceiling(Turn*Count/360.0))
    ;   findall(R, ( member(X-Y, Points), R is sqrt(X*X + Y*Y) ), Rs),
        max_list(Rs, Radius),
        Radians is Turn*pi/180.0,
        (   ( A =\= B ; A =:= 1 )
        ->  Length is Radians*sqrt(Radius*Radius + (H/Radians)**2)
        ;   spiral_length(Radius, Radians, A, Spiral),
            Length is sqrt(Spiral*Spiral + H*H)
        ),
        N is max(Least, min(ceiling(Turn/Angle), ceiling(Length/Size)))
    ).

%   spiral_length(Radius, Turn, Scale, Length): of the spiral of Archimedes
%   from Radius to Radius*Scale in Turn (radians).

spiral_length(Radius, Turn, Scale, Length) :-
    (   Scale > 1
    ->  End is Turn*Scale/(Scale-1)
    ;   End is Turn/(1-Scale)
    ),
    Start is End-Turn,
    A is Radius/End,
    archimedes(A, End, Length1),
    archimedes(A, Start, Length2),
    Length is Length1-Length2.

archimedes(A, T, Length) :-
    Length is 0.5*A*(T*sqrt(1+T*T) + asinh(T)).

straight_slices(Points, H, A-B, fineness(Count, _, Size), N) :-
    (   Count > 0
    ->  N is max(1, truncate(Count))
    ;   findall(D, ( member(X-Y, Points),
                     D is ((1-A)*X)**2 + ((1-B)*Y)**2 ),
                Ds),
        max_list(Ds, Most),
        N is max(1, ceiling(sqrt(Most + H*H)/Size))
    ).


                /*******************************
                *            TURNING           *
                *******************************/

%!  rotate_extruded(+Node, +Region, -Terms) is det.
%
%   Terms are the solids of the rotate_extrude Node over Region, none if it
%   turns by nothing.
%
%   @error those of openscad_argument/5; across_axis(X1, X2)

rotate_extruded(Node, Region, Terms) :-
    openscad_knows(Node, [angle, start, convexity, '$fn', '$fa', '$fs']),
    openscad_argument(Node, angle, number, 360, Angle0),
    openscad_argument(Node, start, number, none, Start),
    (   ( Angle0 > 360 ; Angle0 =< -360 )
    ->  Angle = 360
    ;   Angle = Angle0
    ),
    region_islands(Region, Islands0),
    (   ( Islands0 == [] ; Angle =:= 0 )
    ->  Terms = []
    ;   outline_points(Islands0, Points),
        findall(X, member(X-_, Points), Xs),
        min_list([0.0|Xs], Low),
        max_list([0.0|Xs], High),
        axis_side(Low, High, Node, Side),
        maplist(island_beside(Side), Islands0, Islands),
        Radius is High-Low,
        openscad_fragments(Node, Radius, N0),
        N is max(1, truncate(N0*abs(Angle)/360)),
        Degrees is abs(Angle),
        first_angle(Start, Angle, Side, First),
        smooth_argument(Node, Smooth),
        maplist(turned_island(Node, Smooth, Degrees, N, First), Islands, Terms)
    ).

%   axis_side(Low, High, Node, Side): 1 when the region is right of the axis.

axis_side(Low, High, Node, Side) :-
    (   Low =:= 0
    ->  Side = 1
    ;   High =:= 0
    ->  Side = -1
    ;   Node = node(_, _, _, _, Place),
        openscad_error(across_axis(Low, High), Place)
    ).

island_beside(1, Island, Island).
island_beside(-1, island(Outline0, Holes0, Bays0),
              island(Outline, Holes, Bays)) :-
    mirrored_loop(Outline0, Outline),
    maplist(mirrored_loop, Holes0, Holes),
    maplist(mirrored_loop, Bays0, Bays).

mirrored_loop(Loop0, Loop) :-
    maplist(mirrored_point, Loop0, Loop).

mirrored_point(X0-Y, X-Y) :-
    X is 0.0-X0.

%   first_angle(Start, Angle, Side, First): where the turning, which goes
%   counter-clockwise, begins. OpenSCAD begins a full turn on the other side of
%   the axis.

first_angle(Start, Angle, Side, First) :-
    (   number(Start)
    ->  First0 = Start
    ;   Angle =:= 360
    ->  First0 = 180
    ;   First0 = 0
    ),
    (   Side =:= 1
    ->  First1 = First0
    ;   First1 is First0+180
    ),
    First is First1 + min(0, Angle).

turned_island(Node, Smooth, Degrees, N, First, Island, Term) :-
    island_term(turning_term(Node, Smooth, Degrees, N), Island, Term0),
    (   turns_into_itself(Degrees, N, First)
    ->  Term = Term0
    ;   Term = at([rotate(z, First)], Term0)
    ).

turns_into_itself(Degrees, N, First) :-
    (   First =:= 0
    ->  true
    ;   Degrees =:= 360,
        Steps is rational(First)*N/360,
        integer(Steps)
    ).

turning_term(Node, Smooth, Degrees, N, Outline, Holes, Term) :-
    Node = node(_, _, _, _, Place),
    (   Degrees =:= 360
    ->  Arguments = [facets(N)|Smooth]
    ;   Arguments = [angle(Degrees), facets(N)|Smooth]
    ),
    (   Holes == []
    ->  Term =.. [turning, outline(Outline)|Arguments]
    ;   Term =.. [turning, outline(Outline), holes(Holes)|Arguments]
    ),
    sound_primitive(Term, Place).
