:- module(sg_primitive_extrusion,
          [ prism_shape/2,              % +Given, -Shape
            pyramid_shape/2,            % +Given, -Shape
            straight_sides/2            % +Shape, -Sides
          ]).
:- use_module('../angle', [exact_sin_cos/3]).
:- use_module('../near', [is_rounding/2]).
:- use_module(outline, [outline_loops/4]).
:- use_module(primitive_argument,
              [ given/3, given_one/3, primitive_error/2, vertices_within/2 ]).
:- use_module(shape, [rectangle_loop/3, vertex_loops/3]).
:- use_module(library(apply), [foldl/4, foldl/5, maplist/3, maplist/4]).
:- use_module(library(lists),
              [ append/2, append/3, last/2, max_list/2, member/2, memberchk/2,
                min_list/2, nth1/3, numlist/3, reverse/2
              ]).
/** <module> Extrusion: a polygon with holes, drawn up.

It may turn on its way (twist), grow or shrink (scale) and go aside (shift).
First it is turned, then scaled along the fixed axes, then moved, all in
proportion to the height. A scale of 0 gives an apex: a pyramid; one factor of 0
gives a ridge, with a vertex where the outline has one below it. Over a part of
the outline that is no single stretch across the ridge, as over a hole, more
than two walls meet there.

A wall that stays flat is one polygon. One that does not is triangles between
layers, `slices` of them, each quadrilateral divided by its shorter diagonal;
of two as long as each other the one that leans with the turning. Below a ridge
all lean forward: so no two triangles stand on one vertex and lie on each other
where the outline turns back.

The faces are base, top (none over an apex or a ridge) and the walls of the
first slice, the second, ...; side(I) is what stands on the I-th edge, counted
as the edges
of a turning. For shapes see shape.pl.
*/

%!  prism_shape(+Given, -Shape) is det.
%
%   @error see outline_loops/4; few_slices(N, Least), too_many_vertices(N, Most)

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
    ridge(Scale, Layers, Ridge, AllPoints),
    append(AllPoints, Points),
    maplist(reverse, Numbers, Base),
    (   ends_flat(Scale)
    ->  Top = []
    ;   Shift is Slices*Count,
        maplist(maplist(plus(Shift)), Numbers, TopLoops),
        Top = [face(top, TopLoops)]
    ),
    walls(Layers, 0, Count, Numbers, Way, Ridge, Walls),
    append([[face(base, Base)|Top], Walls], Faces).

%   ends_flat(Scale): in an apex or a ridge.

ends_flat(A-B) :-
    A*B =:= 0.0.

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
        A =:= 0.0,
        B =:= 0.0
    ->  Points = [point(DX, DY, Z)]
    ;   append(Loops, Flat),
        maplist(raised(Sin, Cos, FA, FB, DX, DY, Z), Flat, Points)
    ).

raised(Sin, Cos, FA, FB, DX, DY, Z, X0-Y0, point(X, Y, Z)) :-
    X is FA*(X0*Cos - Y0*Sin) + DX + 0.0,
    Y is FB*(X0*Sin + Y0*Cos) + DY + 0.0.


                /*******************************
                *             RIDGE            *
                *******************************/

%   ridge(Scale, Layers, Ridge, Points): Points are those of each of the Layers;
%   of the last one, where it is a ridge, each place once, in order along it.
%   Ridge is then places(I1, I2, ...), for each vertex of the base the place
%   above it, else `none`. Places no farther apart than 2^-40 of how far the
%   ridge reaches, as turning leaves them, are one.

ridge(A-B, Layers, Ridge, Points) :-
    (   A*B =:= 0.0,
        A+B > 0.0
    ->  append(Lower, [High], Layers),
        ( B =:= 0.0 -> Axis = 1 ; Axis = 2 ),
        maplist(arg(Axis), High, Ways),
        sort(Ways, Sorted),
        max_list(Sorted, Last),
        min_list(Sorted, First),
        Apart is (Last-First)*2.0** -40,
        places(Sorted, Apart, Places),
        maplist(place_number(Places, Apart), Ways, Numbers),
        Ridge =.. [places|Numbers],
        High = [Point|_],
        maplist(place_point(Axis, Point), Places, Top),
        append(Lower, [Top], Points)
    ;   Ridge = none,
        Points = Layers
    ).

%   places(Ways, Apart, Places): of each run in the ascending Ways that begins
%   within Apart, the first.

places([], _, []).
places([Way|Ways0], Apart, [Way|Places]) :-
    beyond(Ways0, Way, Apart, Ways),
    places(Ways, Apart, Places).

beyond([Way|Ways0], First, Apart, Ways) :-
    Way-First =< Apart,
    !,
    beyond(Ways0, First, Apart, Ways).
beyond(Ways, _, _, Ways).

place_number(Places, Apart, Way, I) :-
    nth1(I, Places, Place),
    Way-Place =< Apart,
    !.

place_point(1, point(_, Y, Z), X, point(X, Y, Z)).
place_point(2, point(X, _, Z), Y, point(X, Y, Z)).


                /*******************************
                *             WALLS            *
                *******************************/

%   walls(Layers, First, Count, Loops, Way, Ridge, Faces): between each layer
%   and the next one; vertex V of the base is First+V in the lower layer.

walls([_], _, _, _, _, _, []) :-
    !.
walls([Low, High|Layers], First, Count, Loops, Way, Ridge, Faces) :-
    Lows =.. [layer|Low],
    Highs =.. [layer|High],
    ( Layers == [] -> Above = Ridge ; Above = none ),
    Slice = slice(Lows, Highs, First, Count, Above),
    foldl(loop_walls(Slice, Way), Loops, FaceLists, outer, _),
    append(FaceLists, Faces0),
    First1 is First+Count,
    walls([High|Layers], First1, Count, Loops, Way, Ridge, Faces1),
    append(Faces0, Faces1, Faces).

loop_walls(Slice, Way, Loop, Faces, Which, hole) :-
    Loop = [First|Rest],
    append(Rest, [First], Nexts),
    maplist(wall(Slice, Way, Which), Loop, Nexts, FaceLists),
    append(FaceLists, Faces).

wall(Slice, Way, Which, V, W, Faces) :-
    Slice = slice(_, _, First, _, _),
    What = side(V),
    A is First+V,
    B is First+W,
    upper_edge(Slice, V, W, Upper),
    (   ( Upper = [_] ; stays_flat(Slice, Way, V, W) )
    ->  Faces = [face(What, [[A, B|Upper]])]
    ;   leans_forward(Slice, Way, Which, V, W)
    ->  Upper = [D|_],
        Faces = [face(What, [[A, B, D]]), face(What, [[A|Upper]])]
    ;   last(Upper, C),
        Faces = [face(What, [[A, B, C]]), face(What, [[B|Upper]])]
    ).

%   upper_edge(Slice, V, W, Upper): the vertices above, from W to V: one below
%   an apex, and below a ridge all the places on the way.

upper_edge(slice(_, Highs, First, Count, Above), V, W, Upper) :-
    Next is First+Count,
    (   functor(Highs, _, 1)
    ->  Apex is Next+1,
        Upper = [Apex]
    ;   Above == none
    ->  C is Next+V,
        D is Next+W,
        Upper = [D, C]
    ;   arg(V, Above, I),
        arg(W, Above, J),
        C is Next+I,
        D is Next+J,
        (   D =< C
        ->  numlist(D, C, Upper)
        ;   numlist(C, D, Back),
            reverse(Back, Upper)
        )
    ).

%   stays_flat(Slice, Way, V, W): it keeps its direction on the way up.

stays_flat(slice(Lows, _, _, _, _), way(_, A-B, Twist), V, W) :-
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

leans_forward(slice(_, _, _, _, Above), _, _, _, _) :-
    Above \== none,
    !.
leans_forward(slice(Lows, Highs, _, _, _), way(_, _, Twist), Which, V, W) :-
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

%!  straight_sides(+Shape, -Sides:list) is det.
%
%   Sides has side(V)-side(U) for each wall of the Shape of a prism that
%   stands on an edge which goes on straight from the one before it: U is the
%   first edge on that line. What a line sweeps is one surface, also where the
%   prism turns.

straight_sides(shape(Points, Faces, _), Sides) :-
    memberchk(face(base, Base), Faces),
    Places =.. [places|Points],
    findall(Side,
            ( member(Back, Base),
              reverse(Back, Loop),
              last(Loop, Last),
              append([[Last],Loop,Loop], Round),
              straight_on(Round, Places, none, OfLoop),
              member(Side, OfLoop) ),
            Sides0),
    sort(Sides0, Sides).

%   straight_on(Round, Places, First, Sides): Round goes twice round a loop,
%   which may begin in the middle of a line; First is the first edge on the
%   line of the last one, `none` before the first corner.

straight_on([U,V,W|Round], Places, First0, Sides) :-
    !,
    (   \+ goes_straight(Places, U, V, W)
    ->  First = V,
        Sides = Sides1
    ;   First = First0,
        (   First == none
        ->  Sides = Sides1
        ;   Sides = [side(V)-side(First)|Sides1]
        )
    ),
    straight_on([V,W|Round], Places, First, Sides1).
straight_on(_, _, _, []).

%   goes_straight(Places, U, V, W): but for rounding.

goes_straight(Places, U, V, W) :-
    arg(U, Places, point(X1, Y1, _)),
    arg(V, Places, point(X2, Y2, _)),
    arg(W, Places, point(X3, Y3, _)),
    A is X2-X1, B is Y2-Y1, C is X3-X2, D is Y3-Y2,
    Along is A*C+B*D,
    Along > 0.0,
    is_rounding(A*D-B*C, Along).
