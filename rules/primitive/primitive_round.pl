:- module(sg_primitive_round,
          [ circle_shape/2,             % +Given, -Shape
            cylinder_shape/2,           % +Given, -Shape
            cone_shape/2,               % +Given, -Shape
            hollow_cylinder_shape/2     % +Given, -Shape
          ]).
:- use_module(primitive_argument,
              [given/3, given_facets/4, primitive_error/2]).
:- use_module(outline, [outline_loops/4]).
:- use_module(shape,
              [ bent_sides_split/2, layer_faces/4, ring_points/4,
                ring_ranges/2, vertex_loops/3
              ]).
:- use_module(library(apply), [maplist/3, maplist/4]).
:- use_module(library(lists), [append/3, member/2, numlist/3, reverse/2]).
/** <module> Primitives between two ellipses: discs, cylinders, cones.

The radii are one number, or two: along x and along y. The top is the base
moved by the shift and the height (oblique unless the shift is 0, 0). For
shapes see shape.pl.
*/

%!  circle_shape(+Given, -Shape) is det.
%
%   A disc, one polygon that faces +z.

circle_shape(Given, shape(Points, [face(front, [Loop])], [])) :-
    radii(Given, radius, Radii),
    facets(Given, Radii, N),
    ring_points(Radii, point(0.0, 0.0, 0.0), N, Points),
    numlist(1, N, Loop).

radii(Given, Name, A-B) :-
    given(Given, Name, Numbers),
    (   Numbers = [A, B]
    ->  true
    ;   Numbers = [A],
        B = A
    ).

facets(Given, A-B, N) :-
    Radius is max(A, B),
    given_facets(Given, Radius, 360, N).

%!  cylinder_shape(+Given, -Shape) is det.

cylinder_shape(Given, Shape) :-
    radii(Given, radius, Radii),
    facets(Given, Radii, N),
    frustum(Given, Radii, Radii, 1.0, N, Shape).

%!  cone_shape(+Given, -Shape) is det.
%
%   @error flat_top if one radius of the top is 0

cone_shape(Given, Shape) :-
    radii(Given, radius, Radii),
    top_radii(Given, Radii, A-B, Ratio),
    Radii = A0-B0,
    Greatest is max(max(A0, B0), max(A, B)),
    given_facets(Given, Greatest, 360, N),
    (   A =:= 0.0,
        B =:= 0.0
    ->  pointed_cone(Given, Radii, N, Shape)
    ;   ( A =:= 0.0 ; B =:= 0.0 )
    ->  Given = given(Term, _, _),
        primitive_error(flat_top, Term)
    ;   frustum(Given, Radii, A-B, Ratio, N, Shape)
    ).

%   top_radii(Given, Base, Top, Ratio): one number has the proportions of the
%   base; Ratio is `none` where two have others.

top_radii(Given, A-B, A2-B2, Ratio) :-
    given(Given, top, Top),
    (   Top = [A2]
    ->  B2 is B*A2/A,
        Ratio is A2/A
    ;   Top = [A2, B2],
        (   rational(A)*rational(B2) =:= rational(A2)*rational(B)
        ->  Ratio is A2/A
        ;   Ratio = none
        )
    ).

%   frustum(...): base ring 1..N, top ring N+1..2N; polygon 1 is the base, 2
%   the top, then the sides in order. Sides between rings of different
%   proportions are not flat: two triangles each.

frustum(Given, Radii, Top, Ratio, N, shape(Points, Faces, [side-Surface])) :-
    given(Given, height, [H]),
    given(Given, shift, [X, Y]),
    ring_points(Radii, point(0.0, 0.0, 0.0), N, Low),
    ring_points(Top, point(X, Y, H), N, High),
    append(Low, High, Points),
    numlist(1, N, Ring),
    curved_labels(side, N, Labels),
    layer_faces([Ring], N, Labels, Faces0),
    side_surface(Ratio, Radii, Top, vector(X, Y, H), Surface),
    (   Ratio == none
    ->  bent_sides_split(Faces0, Faces)
    ;   Faces = Faces0
    ).

side_surface(Ratio, A-B, A2-B2, W, Surface) :-
    C = point(0.0, 0.0, 0.0),
    U = vector(A, 0.0, 0.0),
    V = vector(0.0, B, 0.0),
    (   Ratio == none
    ->  Surface = ruled(C, U, V, W, vector(A2, 0.0, 0.0),
                        vector(0.0, B2, 0.0))
    ;   Ratio =:= 1.0
    ->  Surface = cylinder(C, U, V, W)
    ;   Surface = cone(C, U, V, W, Ratio)
    ).

curved_labels(Part, N, Labels) :-
    ring_ranges(N, Ranges),
    findall(curved(Part, [Range]), member(Range, Ranges), Labels).

pointed_cone(Given, A-B, N,
             shape(Points, [face(base, [Base])|Sides], [side-Surface])) :-
    given(Given, height, [H]),
    given(Given, shift, [X, Y]),
    ring_points(A-B, point(0.0, 0.0, 0.0), N, Low),
    append(Low, [point(X, Y, H)], Points),
    numlist(1, N, Ring),
    reverse(Ring, Base),
    curved_labels(side, N, Labels),
    maplist(cone_side(N), Ring, Labels, Sides),
    side_surface(0.0, A-B, _, vector(X, Y, H), Surface).

cone_side(N, I, What, face(What, [[I, J, Apex]])) :-
    J is I mod N + 1,
    Apex is N+1.

%!  hollow_cylinder_shape(+Given, -Shape) is det.
%
%   Base and top are one polygon each, with a hole.
%
%   @error inner_too_large

hollow_cylinder_shape(Given, shape(Points, Faces, Surfaces)) :-
    given(Given, height, [H]),
    given(Given, shift, [X, Y]),
    radii(Given, radius, Outer),
    inner_radii(Given, Outer, Inner),
    facets(Given, Outer, N),
    C = point(0.0, 0.0, 0.0),
    ring_points(Outer, C, N, LowOuter),
    ring_points(Inner, C, N, LowInner),
    inner_fits(Given, LowOuter, LowInner),
    append(LowOuter, LowInner, Low),
    top_points(Low, X, Y, H, High),
    append(Low, High, Points),
    vertex_loops([LowOuter, LowInner], [Ring, Hole0], Count),
    Hole0 = [First|Rest0],
    reverse(Rest0, Rest),
    curved_labels(outer, N, Labels1),
    curved_labels(inner, N, Labels0),
    reverse(Labels0, Labels2),
    append(Labels1, Labels2, Labels),
    layer_faces([Ring, [First|Rest]], Count, Labels, Faces),
    W = vector(X, Y, H),
    side_surface(1.0, Outer, Outer, W, OuterSurface),
    side_surface(1.0, Inner, Inner, W, InnerSurface),
    Surfaces = [outer-OuterSurface, inner-InnerSurface].

inner_radii(Given, A-B, A2-B2) :-
    given(Given, inner, Inner),
    (   Inner = [A2]
    ->  B2 is B*A2/A
    ;   Inner = [A2, B2]
    ),
    (   A2 < A,
        B2 < B
    ->  true
    ;   Given = given(Term, _, _),
        primitive_error(inner_too_large, Term)
    ).

%   inner_fits(Given, Outer, Inner): with few facets, an inner polygon of
%   other proportions can cross the outer one.

inner_fits(Given, Outer, Inner) :-
    Given = given(Term, _, _),
    maplist(flat_point, Outer, Outline),
    maplist(flat_point, Inner, Hole),
    catch(outline_loops(Outline, [Hole], Term, _),
          error(model_error(primitive(_, _)), _),
          primitive_error(inner_too_large, Term)).

flat_point(point(X, Y, _), X-Y).

top_points([], _, _, _, []).
top_points([point(X0, Y0, _)|Low], X1, Y1, H, [point(X, Y, H)|High]) :-
    X is X0+X1,
    Y is Y0+Y1,
    top_points(Low, X1, Y1, H, High).
