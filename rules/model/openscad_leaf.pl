:- module(sg_openscad_leaf,
          [ openscad_leaf/2,            % ?Name, -Arguments
            leaf_made/2,                % +Node, -Meaning
            sound_primitive/2           % +Term, +Place
          ]).
:- use_module('../limits', [within_limit/3]).
:- use_module('../angle', [exact_sin_cos/3]).
:- use_module(openscad_argument,
              [ openscad_argument/4, openscad_argument/5, openscad_knows/2,
                openscad_fragments/3, openscad_error/2
              ]).
:- use_module('../primitive/primitive', [primitive_shape/4]).
:- use_module(library(apply), [exclude/3, maplist/3]).
:- use_module(library(assoc), [get_assoc/3, put_assoc/4]).
:- use_module(library(lists), [append/3, numlist/3, reverse/2]).
/** <module> The leaves of an OpenSCAD .csg file, as primitives of ours.

They are the same polyhedra as OpenSCAD makes: a circle begins on the +x axis,
and a sphere has no poles; its rings lie half a step from them, and the first
and the last one are caps.

@see OpenSCAD User Manual, Primitive Solids, 2D Primitives
*/

%!  openscad_leaf(?Name, -Arguments) is nondet.
%
%   True when a node Name has no children, and these Arguments.

openscad_leaf(cube, [size, center]).
openscad_leaf(sphere, [r | Fineness]) :-
    fineness(Fineness).
openscad_leaf(cylinder, [h, r1, r2, center | Fineness]) :-
    fineness(Fineness).
openscad_leaf(polyhedron, [points, faces, convexity]).
openscad_leaf(square, [size, center]).
openscad_leaf(circle, [r | Fineness]) :-
    fineness(Fineness).
openscad_leaf(polygon, [points, paths, convexity]).

fineness(['$fn', '$fa', '$fs']).

%!  leaf_made(+Node, -Meaning) is det.
%
%   Meaning is what the leaf Node is (openscad.pl).
%
%   @error those of openscad_argument/5; no_point(Name, I)

leaf_made(Node, Meaning) :-
    Node = node(_, Name, _, Children, Place),
    (   Children = [node(_, _, _, _, Inner)|_]
    ->  openscad_error(childless(Name), Inner)
    ;   true
    ),
    openscad_leaf(Name, Arguments),
    openscad_knows(Node, Arguments),
    made(Name, Node, Place, Meaning),
    !.

made(cube, Node, _, Meaning) :-
    openscad_argument(Node, size, size3, [1, 1, 1], [A, B, C]),
    openscad_argument(Node, center, flag, false, Center),
    (   A > 0, B > 0, C > 0
    ->  (   Center == true
        ->  Z is -C/2.0,
            Step = translate(0, 0, Z)
        ;   X is A/2.0,
            Y is B/2.0,
            Step = translate(X, Y, 0)
        ),
        Meaning = solid(at([Step], box(size(A, B, C))))
    ;   Meaning = nothing
    ).
made(sphere, Node, Place, Meaning) :-
    openscad_argument(Node, r, number, 1, R),
    (   R > 0
    ->  openscad_fragments(Node, R, N),
        Corners is N*((N+1)//2),
        within_limit(facets, Corners, Place),
        sphere_profile(R, N, Outline),
        Meaning = solid(turning(outline(Outline), facets(N),
                                smooth(true)))
    ;   Meaning = nothing
    ).
made(cylinder, Node, _, Meaning) :-
    openscad_argument(Node, h, number, 1, H),
    openscad_argument(Node, r1, number, 1, R1),
    openscad_argument(Node, r2, number, 1, R2),
    openscad_argument(Node, center, flag, false, Center),
    Greatest is max(R1, R2),
    (   H > 0, R1 >= 0, R2 >= 0, Greatest > 0
    ->  openscad_fragments(Node, Greatest, N),
        frustum(R1, R2, H, N, Term0),
        lowered(Center, H, Term0, Term),
        Meaning = solid(Term)
    ;   Meaning = nothing
    ).
made(polyhedron, Node, Place, Meaning) :-
    openscad_argument(Node, points, points3, [], Points0),
    openscad_argument(Node, faces, faces, [], Faces0),
    merged_points(Points0, Points, Numbers),
    maplist(merged_face(Numbers, polyhedron, Place), Faces0, Faces1),
    exclude(is_short, Faces1, Faces),
    (   Faces == []
    ->  Meaning = nothing
    ;   Term = polyhedron(points(Points), faces(Faces), smooth(true)),
        sound_primitive(Term, Place),
        Meaning = solid(Term)
    ).
made(square, Node, _, Meaning) :-
    openscad_argument(Node, size, size2, [1, 1], [A, B]),
    openscad_argument(Node, center, flag, false, Center),
    (   A > 0, B > 0
    ->  (   Center == true
        ->  X0 is -A/2.0,
            Y0 is -B/2.0
        ;   X0 = 0.0,
            Y0 = 0.0
        ),
        X1 is X0+A,
        Y1 is Y0+B,
        Meaning = plane(loops([[X0-Y0, X1-Y0, X1-Y1, X0-Y1]]))
    ;   Meaning = nothing
    ).
made(circle, Node, _, Meaning) :-
    openscad_argument(Node, r, number, 1, R),
    (   R > 0
    ->  openscad_fragments(Node, R, N),
        numlist(1, N, Is),
        maplist(circle_point(R, N), Is, Loop),
        Meaning = plane(loops([Loop]))
    ;   Meaning = nothing
    ).
made(polygon, Node, Place, Meaning) :-
    openscad_argument(Node, points, points2, [], Points),
    openscad_argument(Node, paths, faces, all, Paths),
    Table =.. [points|Points],
    (   ( Paths == all ; Paths == [] )
    ->  maplist(flat_point, Points, Loop),
        Loops0 = [Loop]
    ;   maplist(path_loop(Table, Place), Paths, Loops0)
    ),
    exclude(is_short, Loops0, Loops),
    (   Loops == []
    ->  Meaning = nothing
    ;   Meaning = plane(loops(Loops))
    ).

%!  sound_primitive(+Term, +Place) is det.
%
%   Says now, and at Place, what is wrong with a primitive.
%
%   @error those of primitive_shape/4

sound_primitive(Term, Place) :-
    catch(primitive_shape(Term, _, _, _), error(model_error(What), _),
          throw(error(model_error(What), Place))).

%   sphere_profile(R, N, Outline): [R, Z] of the rings, from below.

sphere_profile(R, N, [[0, Low]|Outline]) :-
    Rings is (N+1)//2,
    numlist(1, Rings, Is),
    maplist(ring_point(R, Rings), Is, Points),
    Points = [[_, Low]|_],
    High is -Low,
    append(Points, [[0, High]], Outline).

ring_point(R, Rings, I, [X, Z]) :-
    Angle is (2*I-1)*90 rdiv Rings,
    exact_sin_cos(Angle, Sin, Cos),
    X is R*Sin,
    Z is 0.0 - R*Cos.

frustum(R1, R2, H, N, Term) :-
    (   R1 =:= R2
    ->  Term = cylinder(radius(R1), height(H), facets(N))
    ;   R1 =:= 0
    ->  Term = at([mirror(z), translate(0, 0, H)],
                  cone(radius(R2), height(H), facets(N)))
    ;   Term = cone(radius(R1), top(R2), height(H), facets(N))
    ).

%   lowered(Center, H, Term0, Term): by half its height.

lowered(false, _, Term, Term).
lowered(true, H, Term0, at(Steps, Inner)) :-
    Z is -H/2.0,
    (   Term0 = at(Steps0, Inner)
    ->  append(Steps0, [translate(0, 0, Z)], Steps)
    ;   Steps = [translate(0, 0, Z)],
        Inner = Term0
    ).

circle_point(R, N, I, X-Y) :-
    Angle is (I-1)*360 rdiv N,
    exact_sin_cos(Angle, Sin, Cos),
    X is R*Cos + 0.0,
    Y is R*Sin + 0.0.

flat_point([X0, Y0], X-Y) :-
    X is float(X0),
    Y is float(Y0).

path_loop(Table, Place, Path, Loop) :-
    maplist(path_point(Table, Place), Path, Loop).

path_point(Table, Place, I0, Point) :-
    I is I0+1,
    (   arg(I, Table, Point0)
    ->  flat_point(Point0, Point)
    ;   openscad_error(no_point(polygon, I0), Place)
    ).

%   merged_points(Points0, Points, Numbers): OpenSCAD knows points by where
%   they are; Numbers(I) is the number among Points of point I of Points0.

merged_points(Points0, Points, Numbers) :-
    maplist(float_point, Points0, Floats),
    merged(Floats, 1, t, Points, List),
    Numbers =.. [numbers|List].

float_point(Point0, Point) :-
    maplist(float_number, Point0, Point).

float_number(Number, Float) :-
    Float is Number + 0.0.

merged([], _, _, [], []).
merged([Point|Points0], Next, Known0, Points, [V|Vs]) :-
    (   get_assoc(Point, Known0, V)
    ->  merged(Points0, Next, Known0, Points, Vs)
    ;   V = Next,
        put_assoc(Point, Known0, V, Known),
        Next1 is Next+1,
        Points = [Point|Points1],
        merged(Points0, Next1, Known, Points1, Vs)
    ).

%   merged_face(Numbers, Name, Place, Face0, Face): the other way round, and no
%   point twice in a row.

merged_face(Numbers, Name, Place, Face0, Face) :-
    maplist(point_number(Numbers, Name, Place), Face0, Face1),
    reverse(Face1, Face2),
    no_repeats(Face2, Face).

point_number(Numbers, Name, Place, I0, V) :-
    I is I0+1,
    (   arg(I, Numbers, V0)
    ->  V = V0
    ;   openscad_error(no_point(Name, I0), Place)
    ).

no_repeats(Face0, Face) :-
    (   append(Face1, [Last], Face0),
        Face0 = [Last|_],
        Face1 \== []
    ->  no_repeats(Face1, Face)
    ;   without_repeats(Face0, Face)
    ).

without_repeats([V, V|Vs], Face) :-
    !,
    without_repeats([V|Vs], Face).
without_repeats([V|Vs], [V|Face]) :-
    without_repeats(Vs, Face).
without_repeats([], []).

is_short(List) :-
    \+ List = [_, _, _|_].
