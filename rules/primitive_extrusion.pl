:- module(sg_primitive_extrusion,
          [ prism_shape/2,              % +Given, -Shape
            pyramid_shape/2             % +Given, -Shape
          ]).
:- use_module(angle, [exact_sin_cos/3]).
:- use_module(outline, [outline_loops/4]).
:- use_module(primitive_argument,
              [ given/3, given_one/3, primitive_error/2, vertices_within/2 ]).
:- use_module(shape, [rectangle_loop/3, vertex_loops/3]).
:- autoload(library(apply), [foldl/4, maplist/3]).
:- autoload(library(lists), [append/2, append/3, numlist/3, reverse/2]).
/** <module> Extrusion: a polygon with holes, drawn up.

It may turn on its way (twist), grow or shrink (scale) and go aside (shift).
First it is turned, then scaled along the fixed axes, then moved, all in
proportion to the height. A scale of 0 gives an apex: a pyramid.

A wall that stays flat is one polygon. One that does not is triangles between
layers, `slices` of them, each quadrilateral divided by its shorter diagonal;
of two as long as each other the one that leans with the turning.

The faces are base, top (none over an apex) and the walls of the first slice,
the second, ...; side(I) is what stands on the I-th edge, counted as the edges
of a turning. For shapes see shape.pl.
*/

%!  prism_shape(+Given, -Shape) is det.
%
%   @error see outline_loops/4; flat_scale if one factor is 0,
%   few_slices(N, Least), too_many_vertices(N, Most)

prism_shape(Given, Shape) :-
    Given = given(Term, _, _),
    given(Given, outline, [Outline]),
    given(Given, holes, [Holes]),
    scale_factors(Given, Scale),
    given(Given, twist, [Twist]),
    slices(Given, Scale, Twist, Slices),
    outline_loops(Outline, Holes, Term, Loops),
    extruded(Given, Loops, Scale, Twist, Slices, Shape).

scale_factors(Given, A-B) :-
    given(Given, scale, Numbers),
    (   Numbers = [A, B]
    ->  true
    ;   Numbers = [A],
        B = A
    ),
    (   A*B =:= 0.0,
        A+B > 0.0
    ->  Given = given(Term, _, _),
        primitive_error(flat_scale, Term)
    ;   true
    ).

%   slices(Given, Scale, Twist, N): one where all walls are flat; otherwise as
%   given, or 40 a turn. Each turns less than half a turn.

slices(Given, A-B, Twist, N) :-
    (   Twist =:= 0.0,
        A =:= B
    ->  N = 1
    ;   Least is floor(abs(rational(Twist)) rdiv 180) + 1,
        given(Given, slices, Slices),
        (   Slices = [N]
        ->  true
        ;   N is max(Least, ceiling(abs(rational(Twist)) rdiv 9))
        ),
        (   N >= Least
        ->  true
        ;   Given = given(Term, _, _),
            primitive_error(few_slices(N, Least), Term)
        )
    ).

%!  pyramid_shape(+Given, -Shape) is det.
%
%   @error see outline_loops/4; both(base, holes)

pyramid_shape(Given, Shape) :-
    given_one(Given, [base, outline], What),
    given(Given, holes, [Holes]),
    base_loops(What, Holes, Given, Loops),
    extruded(Given, Loops, 0.0-0.0, 0.0, 1, Shape).

base_loops(base-[A, B], Holes, given(Term, _, _), [Loop]) :-
    (   Holes == []
    ->  rectangle_loop(A, B, Loop)
    ;   primitive_error(both(base, holes), Term)
    ).
base_loops(outline-[Outline], Holes, given(Term, _, _), Loops) :-
    outline_loops(Outline, Holes, Term, Loops).

%   extruded(Given, Loops, Scale, Twist, Slices, Shape)

extruded(Given, Loops, Scale, Twist, Slices, shape(Points, Faces, [])) :-
    vertex_loops(Loops, Numbers, Count),
    Vertices is Count*(Slices+1),
    vertices_within(Vertices, Given),
    numlist(0, Slices, Js),
    Way = way(Slices, Scale, Twist),
    maplist(layer(Given, Loops, Way), Js, Layers),
    append(Layers, Points),
    maplist(reverse, Numbers, Base),
    (   is_apex(Scale)
    ->  Top = []
    ;   Shift is Slices*Count,
        maplist(maplist(plus(Shift)), Numbers, TopLoops),
        Top = [face(top, TopLoops)]
    ),
    walls(Layers, 0, Count, Numbers, Way, Walls),
    append([[face(base, Base)|Top], Walls], Faces).

is_apex(A-B) :-
    A =:= 0.0,
    B =:= 0.0.

%   layer(Given, Loops, Way, J, Points): layer J, from 0; an apex is one point.

layer(Given, Loops, way(Slices, A-B, Twist), J, Points) :-
    given(Given, height, [H]),
    given(Given, shift, [X, Y]),
    F is J rdiv Slices,
    Angle is rational(Twist)*F,
    exact_sin_cos(Angle, Sin, Cos),
    Up is float(F),
    FA is 1.0 - (1.0-A)*Up,
    FB is 1.0 - (1.0-B)*Up,
    DX is X*Up,
    DY is Y*Up,
    Z is H*Up + 0.0,
    (   F =:= 1,
        A =:= 0.0
    ->  Points = [point(DX, DY, Z)]
    ;   append(Loops, Flat),
        maplist(raised(Sin, Cos, FA, FB, DX, DY, Z), Flat, Points)
    ).

raised(Sin, Cos, FA, FB, DX, DY, Z, X0-Y0, point(X, Y, Z)) :-
    X is FA*(X0*Cos - Y0*Sin) + DX + 0.0,
    Y is FB*(X0*Sin + Y0*Cos) + DY + 0.0.


                /*******************************
                *             WALLS            *
                *******************************/

%   walls(Layers, First, Count, Loops, Way, Faces): between each layer and the
%   next one; vertex V of the base is First+V in the lower layer.

walls([_], _, _, _, _, []) :-
    !.
walls([Low, High|Layers], First, Count, Loops, Way, Faces) :-
    Lows =.. [layer|Low],
    Highs =.. [layer|High],
    Slice = slice(Lows, Highs, First, Count),
    foldl(loop_walls(Slice, Way), Loops, FaceLists, outer, _),
    append(FaceLists, Faces0),
    First1 is First+Count,
    walls([High|Layers], First1, Count, Loops, Way, Faces1),
    append(Faces0, Faces1, Faces).

loop_walls(Slice, Way, Loop, Faces, Which, hole) :-
    Loop = [First|Rest],
    append(Rest, [First], Nexts),
    maplist(wall(Slice, Way, Which), Loop, Nexts, FaceLists),
    append(FaceLists, Faces).

wall(Slice, Way, Which, V, W, Faces) :-
    Slice = slice(_, Highs, First, Count),
    What = side(V),
    A is First+V,
    B is First+W,
    C is A+Count,
    D is B+Count,
    (   functor(Highs, _, 1)
    ->  Apex is First+Count+1,
        Faces = [face(What, [[A, B, Apex]])]
    ;   stays_flat(Slice, Way, V, W)
    ->  Faces = [face(What, [[A, B, D, C]])]
    ;   leans_forward(Slice, Way, Which, V, W)
    ->  Faces = [face(What, [[A, B, D]]), face(What, [[A, D, C]])]
    ;   Faces = [face(What, [[A, B, C]]), face(What, [[B, D, C]])]
    ).

%   stays_flat(Slice, Way, V, W): it keeps its direction on the way up.

stays_flat(slice(Lows, _, _, _), way(_, A-B, Twist), V, W) :-
    Twist =:= 0.0,
    (   A =:= B
    ->  true
    ;   arg(V, Lows, point(X1, Y1, _)),
        arg(W, Lows, point(X2, Y2, _)),
        ( X1 =:= X2 ; Y1 =:= Y2 )
    ->  true
    ).

%   leans_forward(Slice, Way, Which, V, W): the diagonal from V below to W above
%   is the better one. Lengths that differ by 1e-5 are equal.

leans_forward(slice(Lows, Highs, _, _), way(_, _, Twist), Which, V, W) :-
    distance(V, Lows, W, Highs, Forward),
    distance(W, Lows, V, Highs, Back),
    (   abs(Forward-Back)*2.0e5 > Forward+Back
    ->  Forward < Back
    ;   Which == outer
    ->  Twist < 0.0
    ;   Twist >= 0.0
    ).

distance(V, Layer1, W, Layer2, Distance) :-
    arg(V, Layer1, point(X1, Y1, _)),
    arg(W, Layer2, point(X2, Y2, _)),
    Distance is sqrt((X2-X1)*(X2-X1) + (Y2-Y1)*(Y2-Y1)).
