:- module(sg_oracle_smooth_sheet,
          [ smooth_sheets/3,            % +S, +Crease, -Sheets
            smooth_side/3,              % +Sheets, +Side, ?Across
            cut_side/3,                 % +S, +Sheets, +Side
            convex_side/2,              % +Sheets, +Side
            across_side/3,              % +Sheets, +Side, -Across
            curved_triangle/2,          % +Sheets, ?T
            coarse_triangle/2,          % +Sheets, ?T
            side_bulges/2,              % +Sheets, +Side
            corner_surface/3,           % +Sheets, +Corner, -Surface
            corner_height/3,            % +Sheets, +Corner, -Height
            fold_side/2,                % +Sheets, +Side
            corner_fan/3,               % +Sheets, +Corner, -Fan
            fan_corners/3,              % +Sheets, +Fan, -Corners
            fan_normal/3,               % +Sheets, +Fan, -Normal
            fan_unit/3,                 % +Sheets, +Fan, -Vector
            corner_vertex/3,            % +Sheets, +Corner, -V
            corner_place/3,             % +Sheets, +Corner, -Place
            next_corner/2               % +Corner, -Next
          ]).
:- use_module(known_surface,
              [ polygon_face/3, polygon_surface/4, surface_height/4,
                surface_normal/4,
                surface_straight/3
              ]).
:- use_module('../../rules/csg/known_surface', [flat_bend/1]).
:- use_module('../../rules/vector',
              [ angle_between/3, cross_product/3, difference/3, dot_product/3,
                scaled/3, unit/2
              ]).
:- use_module('../../rules/kernel', [scene_edge/5, segments_tolerance/3]).
:- use_module('../../rules/picture/hidden_lines', [open_scene/2]).
:- use_module('../../rules/picture/role', [look_part/3]).
:- use_module('../../rules/store', [e/5, line/9, t/6, v/5]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [foldl/4, maplist/3, maplist/4]).
:- use_module(library(assoc),
              [ assoc_to_keys/2, empty_assoc/1, gen_assoc/3, get_assoc/3,
                list_to_assoc/2, put_assoc/4 ]).
:- use_module(library(lists),
              [append/3, max_list/2, member/2, memberchk/2]).
:- use_module(library(pairs), [group_pairs_by_key/2, pairs_keys_values/3]).
/** <module> Smooth sheets: which triangles of a segment are one smooth surface.

Two triangles are connected smoothly where they alone share a side, run along
it in opposite directions, and their faces bend by no more than the crease
angle, or not at all if a penetration line runs there, and it is no edge by the
terms (known_surface.pl). A component is a *sheet*; the corners of a
sheet at a vertex that are connected are a *fan*. A fan has one normal, the mean
of its faces' normals, weighted by their area and by the angle they fill there;
where a face leans more than the crease angle from it, the vertex is an apex and
has none.

Where polygons are facets of a known surface (known_surface.pl), this says how
much they bend, and which way they look at a vertex; facets of one surface hang
together, even where a penetration line runs.

A sheet is *curved* if it bends along more than one line at a vertex inside it
that is no apex. One that is not (a cylinder, a cone, the sides of a prism) is
folded along straight lines, and its outline lies on these. Facets of spheres
and tori are curved, those of cylinders and cones are not.

A curved sheet is *coarse* if, at more than a quarter of the length of its
sides, a smooth surface would bulge out between the middles of the triangles
there by more than a thousandth of its segment's longest side. Then its outline
is that of its triangles. Facets of known surfaces are never coarse.

A side and a corner of triangle T are T-I, I from 1 to 3; side I runs from
corner I to the next. A fan is named by its least corner.
c_kernels/picture/smooth.c is the fused kernel.
*/

:- set_prolog_flag(optimise, true).

% sheets(Corners, Places, Areas, Sides, Fans, Members, Normals, Curved, Known,
% Coarse, Faces, Reach), assocs:
%   Corners  T -> corners(P, V1, V2, V3)
%   Places   V -> p(X,Y,Z)
%   Areas    P -> p(X,Y,Z), the polygon's normal, as long as twice its area
%   Sides    T-I -> across(T2-J, Bend, Smooth)
%   Fans     T-I -> Fan;  Members Fan -> Corners
%   Normals  Fan -> normal(p(X,Y,Z)), unit, or apex(p(X,Y,Z))
%   Curved   T -> true
%   Known    P -> Id-Surface, by polygon_surface/4
%   Faces    P -> Id, by polygon_face/3
%   Coarse   Size-Assoc: the longest side of the segment; T -> true
%   Reach    a number: how far a vertex may be from where it was meant

%!  smooth_sheets(+S, +Crease, -Sheets) is det.
%
%   Sheets says how the triangles of segment S are connected, for the other
%   predicates here. Crease: degrees.

smooth_sheets(S, Crease, Sheets) :-
    Sheets = sheets(Corners, Places, Areas, Sides, Fans, Members, Normals,
                    Curved, Known, Coarse, Faces, Reach),
    segments_tolerance([S], Tolerance, _),
    Reach is 4*Tolerance,
    findall(T-corners(P,A,B,C), t(S, P, T, A, B, C), Triangles0),
    keysort(Triangles0, Triangles),
    list_to_assoc(Triangles, Corners),
    findall(V-p(X,Y,Z), v(S, V, X, Y, Z), Vs0),
    keysort(Vs0, Vs),
    list_to_assoc(Vs, Places),
    findall(P, t(S, P, _, _, _, _), Ps0),
    sort(Ps0, Ps),
    findall(P-(Id-Surface),
            ( Crease >= 1, member(P, Ps), polygon_surface(S, P, Id, Surface) ),
            Surfaces),
    list_to_assoc(Surfaces, Known),
    findall(P-Id,
            ( Crease >= 1, member(P, Ps), polygon_face(S, P, Id) ),
            FaceList),
    list_to_assoc(FaceList, Faces),
    empty_assoc(None),
    foldl(add_area(Places), Triangles, None, Areas),
    edges_in_picture(S, Crease, Edges),
    findall(Side-Across, side_across(S, Sheets, Triangles, Crease-Edges,
                                     Side, Across), Joined0),
    keysort(Joined0, Joined),
    list_to_assoc(Joined, Sides),
    findall(T-I, ( member(T-_, Triangles), member(I, [1,2,3]) ), All),
    fans(All, Sides, None, Fans, None, Members),
    assoc_to_keys(Members, Names),
    maplist(normal_of(Sheets, Crease), Names, NormalList),
    pairs_keys_values(NormalPairs, Names, NormalList),
    list_to_assoc(NormalPairs, Normals),
    curved_triangles(Triangles, Sheets, None, Curved),
    coarse_triangles(Sheets, Coarse).

add_area(Places, _-corners(P,A,B,C), Areas0, Areas) :-
    triangle_area(Places, A, B, C, p(X1,Y1,Z1)),
    (   get_assoc(P, Areas0, p(X0,Y0,Z0))
    ->  true
    ;   X0 = 0.0,
        Y0 = 0.0,
        Z0 = 0.0
    ),
    X is X0+X1,
    Y is Y0+Y1,
    Z is Z0+Z1,
    put_assoc(P, Areas0, p(X,Y,Z), Areas).

triangle_area(Places, A, B, C, Area) :-
    maplist(place(Places), [A,B,C], [PA,PB,PC]),
    difference(PB, PA, U),
    difference(PC, PA, W),
    cross_product(U, W, Area).

place(Places, V, Place) :-
    get_assoc(V, Places, Place).

/* - - - sides - - - */

%   edges_in_picture(S, Crease, Edges): the ends of what is an edge whatever it
%   bends, also where a crease goes on (tests/c_kernels/picture/crease_test.c).

edges_in_picture(S, Crease, Edges) :-
    open_scene(Scene, [crease(Crease)]),
    findall(Low-High,
            ( scene_edge(Scene, S, E, _, Look), look_part(edge, Look, true),
              E > 0, e(S, E, V1, V2, _),
              Low is min(V1, V2), High is max(V1, V2) ),
            Edges).

side_across(S, Sheets, Triangles, Crease-Edges, Side, Across) :-
    Sheets = sheets(_, _, Areas, _, _, _, _, _, _, _, _, _),
    findall((Low-High)-use(T-I,A,P),
            ( member(T-corners(P,V1,V2,V3), Triangles),
              member(I-A-B, [1-V1-V2, 2-V2-V3, 3-V3-V1]),
              Low is min(A, B),
              High is max(A, B) ),
            Uses0),
    keysort(Uses0, Uses),
    group_pairs_by_key(Uses, Groups),
    member((Low-High)-[use(Side1,A1,P1),use(Side2,A2,P2)], Groups),
    A1 \== A2,
    get_assoc(P1, Areas, Area1),
    get_assoc(P2, Areas, Area2),
    degrees_between(Area1, Area2, Bend),
    (   line_runs(S, Low, High),
        \+ one_surface(Sheets, P1, P2)
    ->  flat_bend(Most),
        Degrees = Bend
    ;   Most is Crease + 1.0e-6,
        surfaces_bend(Sheets, P1, P2, Side1, Bend, Degrees, Edge)
    ),
    (   Degrees =< Most,
        Edge \== true,
        \+ memberchk(Low-High, Edges)
    ->  Smooth = true
    ;   Smooth = false
    ),
    member(Side-Other, [Side1-Side2, Side2-Side1]),
    Across = across(Other, Bend, Smooth).

one_surface(Sheets, P1, P2) :-
    arg(9, Sheets, Known),
    get_assoc(P1, Known, Id-_),
    get_assoc(P2, Known, Id-_).

%   surfaces_bend(Sheets, P1, P2, Side, Bend, Degrees, Edge): the surfaces of
%   polygons that bend by Bend along Side bend by Degrees: not at all if they
%   are one, else by the more of both ends. Facets bend by one degree at most.
%   Edge: different surfaces, or named faces, that are not tangent.

surfaces_bend(Sheets, P1, P2, Side, Bend, Degrees, Edge) :-
    arg(9, Sheets, Known),
    arg(11, Sheets, Faces),
    (   one_surface(Sheets, P1, P2)
    ->  Degrees is min(Bend, 1.0),
        Edge = false
    ;   \+ get_assoc(P1, Known, _),
        \+ get_assoc(P2, Known, _)
    ->  Degrees = Bend,
        (   get_assoc(P1, Faces, Id1),
            get_assoc(P2, Faces, Id2),
            Id1 \== Id2,
            \+ tangent(Sheets, P1, P2, Side, Bend)
        ->  Edge = true
        ;   Edge = false
        )
    ;   side_looks(Sheets, P1, Side, Looks1),
        side_looks(Sheets, P2, Side, Looks2),
        maplist(looks_bend, Looks1, Looks2, Angles),
        max_list(Angles, Most),
        Degrees is max(Most, min(Bend, 1.0)),
        (   \+ turned_together(Known, P1, P2),
            forall(member(P, [P1,P2]),
                   ( known_or_face(Known, Faces, P),
                     \+ is_generator(Sheets, P, Side) )),
            Bend > 0.0,
            known_bend(Looks1, Looks2, Bend, KnownBend),
            \+ tangent(Sheets, P1, P2, Side, KnownBend)
        ->  Edge = true
        ;   Edge = false
        )
    ).

%   tangent(Sheets, P1, P2, Side, Degrees): polygons that bend by Degrees bend
%   by no more than moving their corners by the reach could bend them.

tangent(Sheets, P1, P2, Side, Degrees) :-
    flat_bend(Flat),
    Degrees =< Flat,
    (   arg(9, Sheets, Known),
        member(P, [P1,P2]),
        get_assoc(P, Known, _-surface(Kind,_,_,_)),
        \+ memberchk(Kind, [tapered,turned,sphere,torus])
    ->  true
    ;   arg(12, Sheets, Reach),
        maplist(width_from(Sheets, Side), [P1,P2], [Width1,Width2]),
        Degrees =< (Reach/Width1 + Reach/Width2)*180/pi
    ).

%   width_from(Sheets, Side, P, Width): how far polygon P goes from the line of
%   Side.

width_from(Sheets, Side, P, Width) :-
    arg(1, Sheets, Corners),
    next_corner(Side, Next),
    maplist(corner_place(Sheets), [Side,Next], [A,B]),
    difference(B, A, Way),
    findall(Far,
            ( gen_assoc(T, Corners, corners(P,_,_,_)),
              member(I, [1,2,3]),
              corner_place(Sheets, T-I, C),
              difference(C, A, Off),
              cross_product(Way, Off, Area),
              dot_product(Area, Area, Square),
              dot_product(Way, Way, Length),
              Far is sqrt(Square/Length) ),
            Fars),
    max_list(Fars, Width).

%   side_looks(Sheets, P, Side, Looks): how polygon P looks at both ends: a list
%   of known(Look), of the surface or a flat face, and facet(Look), where the
%   surface has none.

side_looks(Sheets, P, Side, Looks) :-
    next_corner(Side, Next),
    maplist(side_look(Sheets, P), [Side,Next], Looks).

side_look(Sheets, P, Corner, Look) :-
    arg(3, Sheets, Areas),
    arg(9, Sheets, Known),
    get_assoc(P, Areas, Area),
    corner_place(Sheets, Corner, Place),
    (   surface_look(Known, P, Place, Area, Look0)
    ->  Look = known(Look0)
    ;   get_assoc(P, Known, _)
    ->  Look = facet(Area)
    ;   Look = known(Area)
    ).

looks_bend(Look1, Look2, Degrees) :-
    arg(1, Look1, U),
    arg(1, Look2, W),
    degrees_between(U, W, Degrees).

%   known_bend(Looks1, Looks2, Bend, Degrees): where both are known; Bend if
%   that is nowhere.

known_bend([A1,B1], [A2,B2], Bend, Degrees) :-
    findall(Degrees0,
            ( member(Look1-Look2, [A1-A2,B1-B2]),
              Look1 = known(_),
              Look2 = known(_),
              looks_bend(Look1, Look2, Degrees0) ),
            Found),
    (   Found == []
    ->  Degrees = Bend
    ;   max_list(Found, Degrees)
    ).

known_or_face(Known, Faces, P) :-
    (   get_assoc(P, Known, _)
    ->  true
    ;   get_assoc(P, Faces, _)
    ).

%   is_generator(Sheets, P, Side): along a straight line of a tapered surface.

is_generator(Sheets, P, Side) :-
    arg(9, Sheets, Known),
    get_assoc(P, Known, _-Surface),
    next_corner(Side, Next),
    maplist(corner_place(Sheets), [Side,Next], [Place1,Place2]),
    surface_straight(Surface, Place1, Place2).

%   turned_together(Known, P1, P2): both were turned from a divided curve.

turned_together(Known, P1, P2) :-
    get_assoc(P1, Known, _-surface(turned,_,_,_)),
    get_assoc(P2, Known, _-surface(turned,_,_,_)).

%   polygon_look(Known, P, Place, Area, Look): Look is the way the surface of P
%   looks at Place, as long as the Area of P.

polygon_look(Known, P, Place, Area, Look) :-
    (   surface_look(Known, P, Place, Area, Look0)
    ->  Look = Look0
    ;   Look = Area
    ).

surface_look(Known, P, Place, Area, Look) :-
    get_assoc(P, Known, _-Surface),
    surface_normal(Surface, Place, Area, Normal),
    dot_product(Area, Area, Square),
    Size is sqrt(Square),
    scaled(Size, Normal, Look).

line_runs(S, A, B) :-
    (   line(_, S, _, A, B, _, _, _, _)
    ;   line(_, S, _, B, A, _, _, _, _)
    ;   line(_, _, _, _, _, S, _, A, B)
    ;   line(_, _, _, _, _, S, _, B, A)
    ),
    !.

%   A face without area does not bend.
degrees_between(U, W, Degrees) :-
    (   ( U = p(0.0,0.0,0.0) ; W = p(0.0,0.0,0.0) )
    ->  Degrees = 0.0
    ;   angle_between(U, W, Angle),
        Degrees is Angle*180/pi
    ).

%!  across_side(+Sheets, +Side, -Across) is semidet.
%
%   True when Across is the same side of the only other triangle there, which
%   runs along it in the opposite direction.

across_side(Sheets, Side, Across) :-
    arg(4, Sheets, Sides),
    get_assoc(Side, Sides, across(Across, _, _)).

%!  smooth_side(+Sheets, +Side, ?Across) is semidet.
%
%   True when the sheet goes on across Side, where it is Across.

smooth_side(Sheets, Side, Across) :-
    arg(4, Sheets, Sides),
    get_assoc(Side, Sides, across(Across, _, true)).

%!  cut_side(+S, +Sheets, +Side) is semidet.
%
%   True when a penetration line runs along Side, of segment S.

cut_side(S, Sheets, Side) :-
    next_corner(Side, Next),
    corner_vertex(Sheets, Side, V),
    corner_vertex(Sheets, Next, W),
    line_runs(S, V, W).

%!  convex_side(+Sheets, +Side) is semidet.
%
%   True when the triangle across Side lies below that of Side, or in its plane.

convex_side(Sheets, T-I) :-
    across_side(Sheets, T-I, Across),
    next_corner(Across, Next),
    next_corner(Next, Apex),
    corner_place(Sheets, Apex, P),
    corner_place(Sheets, T-I, Q),
    difference(P, Q, U),
    triangle_normal(Sheets, T, N),
    dot_product(U, N, Height),
    Height =< 0.0.

triangle_normal(Sheets, T, N) :-
    Sheets = sheets(Corners, _, Areas, _, _, _, _, _, _, _, _, _),
    get_assoc(T, Corners, corners(P,_,_,_)),
    get_assoc(P, Areas, N).

%!  next_corner(+Corner, -Next) is det.
%
%   Next follows Corner in its triangle.

next_corner(T-I, T-J) :-
    J is I mod 3 + 1.

%!  corner_vertex(+Sheets, +Corner, -V) is det.
%
%   Corner is at vertex V.

corner_vertex(Sheets, T-I, V) :-
    arg(1, Sheets, Corners),
    get_assoc(T, Corners, Term),
    Place is I+1,
    arg(Place, Term, V).

%!  corner_place(+Sheets, +Corner, -Place) is det.
%
%   Place, p(X,Y,Z) of the model, is where Corner is.

corner_place(Sheets, Corner, Place) :-
    corner_vertex(Sheets, Corner, V),
    arg(2, Sheets, Places),
    get_assoc(V, Places, Place).

/* - - - fans - - - */

%   Corners are connected over the two sides of a triangle that meet there.

fans([], _, Fans, Fans, Members, Members).
fans([Corner|Corners], Sides, Fans0, Fans, Members0, Members) :-
    (   get_assoc(Corner, Fans0, _)
    ->  fans(Corners, Sides, Fans0, Fans, Members0, Members)
    ;   connected([Corner], Sides, [], Connected0),
        msort(Connected0, Connected),
        Connected = [Fan|_],
        foldl(put_fan(Fan), Connected, Fans0, Fans1),
        put_assoc(Fan, Members0, Connected, Members1),
        fans(Corners, Sides, Fans1, Fans, Members1, Members)
    ).

put_fan(Fan, Corner, Fans0, Fans) :-
    put_assoc(Corner, Fans0, Fan, Fans).

connected([], _, Seen, Seen).
connected([Corner|Corners], Sides, Seen0, Seen) :-
    (   memberchk(Corner, Seen0)
    ->  connected(Corners, Sides, Seen0, Seen)
    ;   findall(Next, beside_corner(Sides, Corner, Next), Nexts),
        append(Nexts, Corners, More),
        connected(More, Sides, [Corner|Seen0], Seen)
    ).

%   Corner I of a triangle begins its side I and ends the side before.

beside_corner(Sides, Corner, Next) :-
    get_assoc(Corner, Sides, across(Across, _, true)),
    next_corner(Across, Next).
beside_corner(Sides, Corner, Next) :-
    next_corner(Corner, C1),
    next_corner(C1, Side),
    get_assoc(Side, Sides, across(Next, _, true)).

%!  corner_fan(+Sheets, +Corner, -Fan) is det.
%
%   Corner is one of Fan.

corner_fan(Sheets, Corner, Fan) :-
    arg(5, Sheets, Fans),
    get_assoc(Corner, Fans, Fan).

%!  fan_corners(+Sheets, +Fan, -Corners) is det.
%
%   Corners, sorted, are those of Fan.

fan_corners(Sheets, Fan, Corners) :-
    arg(6, Sheets, Members),
    get_assoc(Fan, Members, Corners).

%!  fan_normal(+Sheets, +Fan, -Normal) is semidet.
%
%   Normal, p(X,Y,Z), is the unit normal of Fan. Fails for an apex.

fan_normal(Sheets, Fan, Normal) :-
    arg(7, Sheets, Normals),
    get_assoc(Fan, Normals, normal(Normal)).

%!  fan_unit(+Sheets, +Fan, -Vector) is det.
%
%   The mean of the normals of Fan's faces, also of an apex.

fan_unit(Sheets, Fan, Vector) :-
    arg(7, Sheets, Normals),
    get_assoc(Fan, Normals, Term),
    arg(1, Term, Vector).

normal_of(Sheets, Crease, Fan, Normal) :-
    fan_corners(Sheets, Fan, Own),
    maplist(corner_look(Sheets), Own, Weighted),
    foldl(add_weighted, Weighted, p(0.0,0.0,0.0), Sum),
    unit(Sum, Unit),
    Least is cos(min(Crease, 90)*pi/180),
    (   member(_-Look, Weighted),
        dot_product(Look, Unit, Lean),
        dot_product(Look, Look, Square),
        Lean < Least*sqrt(Square)
    ->  Normal = apex(Unit)
    ;   Normal = normal(Unit)
    ).

%   The angle at a corner, and the way the surface looks there.

corner_look(Sheets, T-I, Angle-Look) :-
    Sheets = sheets(Corners, Places, Areas, _, _, _, _, _, Known, _, _, _),
    get_assoc(T, Corners, corners(P,V1,V2,V3)),
    get_assoc(P, Areas, Area),
    nth_turned(I, V1, V2, V3, A, B, C),
    maplist(place(Places), [A,B,C], [PA,PB,PC]),
    polygon_look(Known, P, PA, Area, Look),
    difference(PB, PA, U),
    difference(PC, PA, W),
    angle_between(U, W, Angle).

nth_turned(1, A, B, C, A, B, C).
nth_turned(2, A, B, C, B, C, A).
nth_turned(3, A, B, C, C, A, B).

add_weighted(Weight-p(X1,Y1,Z1), p(X0,Y0,Z0), p(X,Y,Z)) :-
    X is X0 + Weight*X1,
    Y is Y0 + Weight*Y1,
    Z is Z0 + Weight*Z1.

/* - - - curved sheets - - - */

%!  curved_triangle(+Sheets, ?T) is nondet.
%
%   True when triangle T lies in a curved sheet.

curved_triangle(Sheets, T) :-
    arg(8, Sheets, Curved),
    (   var(T)
    ->  assoc_to_keys(Curved, Ts),
        member(T, Ts)
    ;   get_assoc(T, Curved, true)
    ).

%   All triangles of the sheet of every fan that bends both ways.

curved_triangles([], _, Curved, Curved).
curved_triangles([T-_|Triangles], Sheets, Curved0, Curved) :-
    (   \+ get_assoc(T, Curved0, true),
        member(I, [1,2,3]),
        (   round_corner(Sheets, T-I)
        ->  true
        ;   corner_fan(Sheets, T-I, Fan),
            bends_both_ways(Sheets, Fan)
        )
    ->  spread([T], Sheets, Curved0, Curved1)
    ;   Curved1 = Curved0
    ),
    curved_triangles(Triangles, Sheets, Curved1, Curved).

spread([], _, Curved, Curved).
spread([T|Ts], Sheets, Curved0, Curved) :-
    (   get_assoc(T, Curved0, true)
    ->  spread(Ts, Sheets, Curved0, Curved)
    ;   put_assoc(T, Curved0, true, Curved1),
        findall(T2, ( member(I, [1,2,3]), smooth_side(Sheets, T-I, T2-_) ),
                Nexts),
        append(Nexts, Ts, More),
        spread(More, Sheets, Curved1, Curved)
    ).

round_corner(Sheets, Corner) :-
    corner_surface(Sheets, Corner, _-surface(Kind,_,_,_)),
    memberchk(Kind, [sphere,torus]).

%!  corner_surface(+Sheets, +Corner, -Surface) is semidet.
%
%   Surface, Id-surface(Kind,_,_,_) as known_surface.pl has it, is the known one
%   that the polygon of Corner is a facet of.

corner_surface(sheets(Corners,_,_,_,_,_,_,_,Known,_,_,_), T-_, Surface) :-
    get_assoc(T, Corners, corners(P,_,_,_)),
    get_assoc(P, Known, Surface).

%!  corner_height(+Sheets, +Corner, -Height) is semidet.
%
%   The known surface of Corner is Height above it. Fails where that is not
%   known (surface_height/4).

corner_height(Sheets, T-I, Height) :-
    corner_surface(Sheets, T-I, _-Surface),
    corner_place(Sheets, T-I, Place),
    triangle_normal(Sheets, T, Area),
    surface_height(Surface, Place, Area, Height).

%   Inside its sheet, with a normal, and bent along more than one line, and not
%   on one cylinder or cone.

bends_both_ways(Sheets, Fan) :-
    fan_normal(Sheets, Fan, _),
    fan_corners(Sheets, Fan, Corners),
    \+ on_tapered(Sheets, Corners),
    forall(member(Corner, Corners), smooth_side(Sheets, Corner, _)),
    findall(Direction,
            ( member(Corner, Corners), bend_direction(Sheets, Corner, Direction)
            ),
            Directions),
    not_one_line(Directions).

on_tapered(Sheets, [Corner|Corners]) :-
    corner_surface(Sheets, Corner, Id-surface(Kind,_,_,_)),
    memberchk(Kind, [tapered,turned]),
    forall(member(Other, Corners), corner_surface(Sheets, Other, Id-_)).

bend_direction(Sheets, Corner, Direction) :-
    arg(4, Sheets, Sides),
    get_assoc(Corner, Sides, across(_, Bend, _)),
    flat_bend(Flat),
    Bend > Flat,
    next_corner(Corner, Next),
    corner_place(Sheets, Corner, P),
    corner_place(Sheets, Next, Q),
    difference(Q, P, U),
    unit(U, Direction).

not_one_line([_,_,_|_]).
not_one_line([U,W]) :-
    foldl(add_weighted, [1.0-U,1.0-W], p(0.0,0.0,0.0), Sum),
    dot_product(Sum, Sum, Square),
    Square > 0.02*0.02.

/* - - - coarse sheets, and folds - - - */

%!  coarse_triangle(+Sheets, ?T) is nondet.
%
%   True when triangle T lies in a coarse sheet.

coarse_triangle(Sheets, T) :-
    arg(10, Sheets, _-Coarse),
    (   var(T)
    ->  assoc_to_keys(Coarse, Ts),
        member(T, Ts)
    ;   get_assoc(T, Coarse, true)
    ).

coarse_triangles(Sheets, Size-Coarse) :-
    findall(T, curved_triangle(Sheets, T), Ts),
    longest_side(Sheets, Size),
    empty_assoc(None),
    coarse_sheets(Ts, Sheets, Size, None, None, Coarse).

%   Sheet by sheet; Seen are the triangles of those before.

coarse_sheets([], _, _, _, Coarse, Coarse).
coarse_sheets([T|Ts], Sheets, Size, Seen0, Coarse0, Coarse) :-
    (   get_assoc(T, Seen0, true)
    ->  Seen = Seen0,
        Coarse1 = Coarse0
    ;   empty_assoc(None),
        spread([T], Sheets, None, Sheet),
        assoc_to_keys(Sheet, Own),
        foldl(put_true, Own, Seen0, Seen),
        (   is_coarse(Sheets, Size, Own)
        ->  foldl(put_true, Own, Coarse0, Coarse1)
        ;   Coarse1 = Coarse0
        )
    ),
    coarse_sheets(Ts, Sheets, Size, Seen, Coarse1, Coarse).

put_true(T, Assoc0, Assoc) :-
    put_assoc(T, Assoc0, true, Assoc).

is_coarse(Sheets, Size, Ts) :-
    findall(Length-Bulge,
            ( member(T, Ts), member(I, [1,2,3]),
              smooth_side(Sheets, T-I, Across),
              T-I @< Across,
              side_bulge(Sheets, T-I, Across, Length, Bulge) ),
            Sides),
    foldl(add_side(Size), Sides, 0.0-0.0, All-Over),
    Over > 0.25*All.

add_side(Size, Length-Bulge, All0-Over0, All-Over) :-
    All is All0+Length,
    (   Bulge > 1.0e-3*Size
    ->  Over is Over0+Length
    ;   Over = Over0
    ).

%!  side_bulges(+Sheets, +Side) is semidet.
%
%   True when a smooth surface would bulge out at Side, of a curved sheet of no
%   known surface, by more than a ten-thousandth of the segment's longest side:
%   otherwise the outline of triangles is never seen beside that of the surface.

side_bulges(Sheets, T-I) :-
    curved_triangle(Sheets, T),
    smooth_side(Sheets, T-I, Across),
    side_bulge(Sheets, T-I, Across, _, Bulge),
    arg(10, Sheets, Size-_),
    Bulge > 1.0e-4*Size.

%   The arc from middle to middle of two chords that turn by an angle is a
%   quarter of their lengths times the tangent of a quarter of it high.

side_bulge(Sheets, Side, Across, Length, Bulge) :-
    next_corner(Side, Next),
    maplist(corner_place(Sheets), [Side,Next], [P,Q]),
    difference(Q, P, U),
    dot_product(U, U, Square),
    Square > 0.0,
    Length is sqrt(Square),
    (   corner_surface(Sheets, Side, _)
    ->  Bulge = 0.0
    ;   maplist(triangle_area(Sheets), [Side,Across], [Area1,Area2]),
        arg(4, Sheets, Sides),
        get_assoc(Side, Sides, across(_, Bend, _)),
        Bulge is (Area1+Area2)/Length/4.0*tan(Bend*pi/180.0/4.0)
    ).

triangle_area(Sheets, T-_, Twice) :-
    plain_normal(Sheets, T, Normal),
    dot_product(Normal, Normal, Square),
    Twice is sqrt(Square).

plain_normal(Sheets, T, Normal) :-
    maplist(corner_vertex(Sheets), [T-1,T-2,T-3], [A,B,C]),
    arg(2, Sheets, Places),
    triangle_area(Places, A, B, C, Normal).

longest_side(Sheets, Size) :-
    arg(1, Sheets, Corners),
    assoc_to_keys(Corners, Ts),
    findall(Side,
            ( member(Axis, [1,2,3]),
              aggregate_all(r(min(X),max(X)),
                            ( member(T, Ts), member(I, [1,2,3]),
                              corner_place(Sheets, T-I, Place),
                              arg(Axis, Place, X) ),
                            r(Low,High)),
              Side is High-Low ),
            Sides),
    max_list([0.0|Sides], Size).

%!  fold_side(+Sheets, +Side) is semidet.
%
%   True when the polygon of Side, which is not flat, is folded there, by more
%   than a degree.

fold_side(Sheets, T-I) :-
    across_side(Sheets, T-I, T2-_),
    arg(1, Sheets, Corners),
    get_assoc(T, Corners, corners(P,_,_,_)),
    get_assoc(T2, Corners, corners(P,_,_,_)),
    maplist(plain_normal(Sheets), [T,T2], [M,N]),
    degrees_between(M, N, Degrees),
    Degrees > 1.0.
