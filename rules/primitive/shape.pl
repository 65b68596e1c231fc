:- module(sg_shape,
          [ ring_points/4,              % +Radii, +Centre, +N, -Points
            ring_ranges/2,              % +N, -Ranges
            rectangle_loop/3,           % +A, +B, -Loop
            round_angle/4,              % +N, +Degrees, +I, -Angle
            layer_faces/4,              % +Loops, +Shift, +Labels, -Faces
            vertex_loops/3,             % +Loops, -Numbers, -Count
            loops_vertex_list/2,        % +Loops, -List
            mirrored_faces/2,           % +Faces0, -Faces
            bent_sides_split/2          % +Faces0, -Faces
          ]).
:- use_module('../angle', [exact_sin_cos/3]).
:- use_module(library(apply), [maplist/3, maplist/4]).
:- use_module(library(lists), [append/2, append/3, numlist/3, reverse/2]).
/** <module> What shapes of primitives are made of.

A maker gives shape(Points, Faces, Surfaces):

  - Points, a list of point(X, Y, Z), become the vertices 1, 2, ...
  - Faces, a list of face(What, Loops), become the polygons 1, 2, ... Loops
    are lists of vertex numbers: the outside, counter-clockwise seen from
    outside the body, then the holes, clockwise. What says what the polygon is
    (face_of/3 in primitive_face.pl).
  - Surfaces, a list of Part-Surface, are the smooth surfaces that faces
    curved(Part, Ranges) stand for (smooth_surface/3).
*/

%!  ring_points(+Radii, +Centre, +N, -Points) is det.
%
%   Points are N on the ellipse with Radii = A-B round Centre = point(X, Y, Z),
%   counter-clockwise from the +x side.

ring_points(Radii, Centre, N, Points) :-
    ring_list(N, corners, Ring),
    maplist(ring_point(Radii, Centre), Ring, Points).

ring_point(A-B, point(X0, Y0, Z), Cos-Sin, point(X, Y, Z)) :-
    X is A*Cos + X0,
    Y is B*Sin + Y0.

%!  ring_ranges(+N, -Ranges) is det.
%
%   Ranges is a list of T1-T2, degrees: from where to where on a turn each of
%   its N facets is.

ring_ranges(N, Ranges) :-
    ring_list(N, ranges, Ranges).

%   ring_list(N, What, List): List has, for each of N facets of a turn, Cos-Sin
%   of where it begins (`corners`) or T1-T2 (`ranges`). Those of a few N are
%   kept: models have many rings of one N, and so have the jobs of a process.

:- dynamic ring_kept/3.                 % N, What, List

ring_list(N, What, List) :-
    (   ring_kept(N, What, List0)
    ->  List = List0
    ;   findall(Item, ring_item(What, N, Item), List),
        ring_remembered(N, What, List)
    ).

ring_item(corners, N, Cos-Sin) :-
    between(1, N, I),
    round_angle(N, 360, I, Angle),
    exact_sin_cos(Angle, Sin, Cos).
ring_item(ranges, N, T1-T2) :-
    between(1, N, I),
    J is I+1,
    round_angle(N, 360, I, Angle1),
    round_angle(N, 360, J, Angle2),
    T1 is float(Angle1),
    T2 is float(Angle2).

%   rings_kept(Lists, Facets): so many, of rings with no more facets.

rings_kept(16, 512).

ring_remembered(N, What, List) :-
    rings_kept(Most, Facets),
    (   N =< Facets
    ->  predicate_property(ring_kept(_, _, _), number_of_clauses(Count)),
        (   Count >= Most
        ->  retractall(ring_kept(_, _, _))
        ;   true
        ),
        asserta(ring_kept(N, What, List))
    ;   true
    ).

%!  rectangle_loop(+A, +B, -Loop) is det.
%
%   Loop are the corners X-Y of a rectangle, A along x and B along y, round the
%   origin.

rectangle_loop(A, B, [X0-Y0, X1-Y0, X1-Y1, X0-Y1]) :-
    X1 is A/2.0,
    X0 is -X1,
    Y1 is B/2.0,
    Y0 is -Y1.

%!  round_angle(+N, +Degrees, +I, -Angle) is det.
%
%   Angle, a rational, is where the I-th of N facets of a turn of so many
%   Degrees begins.

round_angle(N, Degrees, I, Angle) :-
    Angle is (I-1)*rational(Degrees)/N.

%!  vertex_loops(+Loops, -Numbers, -Count) is det.
%
%   Numbers are Loops with 1, 2, ... for their points, Count in all.

vertex_loops(Loops, Numbers, Count) :-
    numbered(Loops, 1, Numbers, Count).

numbered([], Next, [], Count) :-
    Count is Next-1.
numbered([Loop|Loops], First, [Numbers|Rest], Count) :-
    length(Loop, N),
    Last is First+N-1,
    numlist(First, Last, Numbers),
    Next is Last+1,
    numbered(Loops, Next, Rest, Count).

%!  layer_faces(+Loops, +Shift, +Labels, -Faces) is det.
%
%   Faces are a base with Loops (lists of vertices, the outer one
%   counter-clockwise seen from above, holes clockwise), a top with the same
%   vertices plus Shift, and a side for every edge, in order, named by Labels.

layer_faces(Loops, Shift, Labels, [face(base, Base), face(top, Top)|Sides]) :-
    maplist(reverse, Loops, Base),
    maplist(maplist(plus(Shift)), Loops, Top),
    maplist(loop_sides(Shift), Loops, Sides0),
    append(Sides0, Sides1),
    maplist(labelled, Labels, Sides1, Sides).

loop_sides(Shift, Loop, Sides) :-
    Loop = [First|Rest],
    append(Rest, [First], Nexts),
    maplist(side(Shift), Loop, Nexts, Sides).

side(Shift, I, J, [I, J, J2, I2]) :-
    I2 is I+Shift,
    J2 is J+Shift.

labelled(What, Loop, face(What, [Loop])).

%!  loops_vertex_list(+Loops, -List) is det.
%
%   List is the vertex list (polygon_list.pl) of a polygon with Loops.

loops_vertex_list([Loop], List) :-
    !,
    List = Loop.
loops_vertex_list([Loop|Loops], List) :-
    closed(Loop, List0),
    maplist(jumped, Loops, Lists),
    append([List0|Lists], List).

closed([V|Vs], List) :-
    append([V|Vs], [V], List).

jumped([V|Vs], [Jump|Rest]) :-
    Jump is -V,
    append(Vs, [V], Rest).

%!  mirrored_faces(+Faces0, -Faces) is det.
%
%   Faces go the other way round, beginning where they began.

mirrored_faces(Faces0, Faces) :-
    maplist(mirrored_face, Faces0, Faces).

mirrored_face(face(What, Loops0), face(What, Loops)) :-
    maplist(mirrored_loop, Loops0, Loops).

mirrored_loop([V|Vs0], [V|Vs]) :-
    reverse(Vs0, Vs).

%!  bent_sides_split(+Faces0, -Faces) is det.
%
%   Faces are Faces0 with every curved quadrilateral in two triangles.

bent_sides_split([], []).
bent_sides_split([Face|Faces0], Faces) :-
    (   Face = face(What, [[A, B, C, D]]),
        What = curved(_, _)
    ->  Faces = [face(What, [[A, B, C]]), face(What, [[A, C, D]])|Faces1]
    ;   Faces = [Face|Faces1]
    ),
    bent_sides_split(Faces0, Faces1).
