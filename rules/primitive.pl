:- module(sg_primitive,
          [ primitive/1,                % ?Name
            is_primitive/1,             % @Term
            primitive_shape/4,          % +Term, -Kind, -Points, -Chains
            exact_sin_cos/3             % +Degrees, -Sin, -Cos
          ]).
:- autoload(library(apply), [foldl/4, maplist/3, maplist/4]).
:- autoload(library(lists),
            [append/3, member/2, numlist/3, reverse/2, selectchk/3]).
/** <module> Primitive terms: box, cylinder, cone, pyramid, rectangle, line.

A primitive stands on the plane z = 0, its base centred on the z axis, and
rises along +z:

    box(size(A, B, C))                            solid
    cylinder(radius(R), height(H), facets(N))     solid
    cone(radius(R), height(H), facets(N))         solid, apex up
    cone(radius(R), top(R2), height(H), facets(N))  solid, apex cut off
    pyramid(base(A, B), height(H))                solid
    rectangle(size(A, B))                         surface facing +z
    line(from(X, Y, Z), to(X, Y, Z))              curve
    at(Steps, Primitive)                          placed
    named(Name, Primitive)                        with a name for rules

The arguments are named, in any order; facets(N) may be left out (40). The
first corner of a round base lies on the +x axis. Steps of at/2 are done from
left to right, each about the fixed axes of the model:

    translate(X, Y, Z)
    rotate(x, Degrees)   rotate(y, Degrees)   rotate(z, Degrees)

counter-clockwise seen from the positive end of the axis. So
`at([rotate(x, 90), translate(0, 0, 1)], cylinder(radius(1), height(4)))` lies
along -y at height 1.

Solids are closed, of true polygons (a cap is one polygon), counter-clockwise
seen from outside (PL-2, PL-3). The same term gives the same coordinates on
every machine: sines are rounded to 2^-48, multiples of 90 degrees are exact,
and angles that mirror each other have the same sine and cosine.

To add a primitive: a clause of primitive_arguments/3 and one of shape/5.
*/

default_facets(40).
most_facets(1_000_000).

%!  primitive(?Name) is nondet.
%
%   True when Name is the functor name of a primitive.

primitive(Name) :-
    primitive_arguments(Name, _, _).

%   primitive_arguments(Name, Kind, Arguments): Arguments lists
%   argument(Name, Types) or argument(Name, Types, Default).

primitive_arguments(box, solid,
                    [ argument(size, [length, length, length]) ]).
primitive_arguments(cylinder, solid,
                    [ argument(radius, [length]),
                      argument(height, [length]),
                      argument(facets, [facets], [N])
                    ]) :-
    default_facets(N).
primitive_arguments(cone, solid,
                    [ argument(radius, [length]),
                      argument(top, [radius], [0.0]),
                      argument(height, [length]),
                      argument(facets, [facets], [N])
                    ]) :-
    default_facets(N).
primitive_arguments(pyramid, solid,
                    [ argument(base, [length, length]),
                      argument(height, [length])
                    ]).
primitive_arguments(rectangle, surface,
                    [ argument(size, [length, length]) ]).
primitive_arguments(line, curve,
                    [ argument(from, [number, number, number]),
                      argument(to, [number, number, number])
                    ]).

%!  is_primitive(@Term) is semidet.
%
%   True when Term looks like a primitive: at/2, named/2, or a compound with the
%   name of one. Its arguments may still be wrong.

is_primitive(Term) :-
    compound(Term),
    compound_name_arity(Term, Name, Arity),
    (   memberchk(Name/Arity, [at/2, named/2])
    ->  true
    ;   primitive(Name)
    ->  true
    ).

%!  primitive_shape(+Term, -Kind, -Points, -Chains) is det.
%
%   True when the primitive Term is a segment of this Kind (`solid`, `surface`
%   or `curve`) with these Points, a list of point(X, Y, Z) of floats that
%   become the vertices 1, 2, ... Chains are vertex lists: polygons as in
%   PL-2, or, of a curve, the open chains of its edges.
%
%   @error model_error(primitive(What, Term)), where What is
%     unknown, unknown_argument(A), missing(Name), twice(Name),
%     wrong_argument(A, Type), no_step(Step) or no_list(Steps)

primitive_shape(Term, Kind, Points, Chains) :-
    placed(Term, Primitive, Steps),
    compound_name_arguments(Primitive, Name, Given),
    primitive_arguments(Name, Kind, Wanted),
    !,
    given_values(Given, Wanted, Primitive, Values),
    shape(Name, Values, Primitive, Points0, Chains),
    maplist(moved(Steps), Points0, Points).

%   placed(Term, Primitive, Motion): at/2 and named/2 taken off; the inner steps
%   first.

placed(Term, _, _) :-
    \+ is_primitive(Term),
    !,
    primitive_error(unknown, Term).
placed(at(Steps, Inner), Primitive, Motion) :-
    !,
    (   is_list(Steps)
    ->  true
    ;   primitive_error(no_list(Steps), at(Steps, Inner))
    ),
    maplist(step_motion, Steps, Motion2),
    placed(Inner, Primitive, Motion1),
    append(Motion1, Motion2, Motion).
placed(named(_, Inner), Primitive, Motion) :-
    !,
    placed(Inner, Primitive, Motion).
placed(Primitive, Primitive, []).

primitive_error(What, Term) :-
    throw(error(model_error(primitive(What, Term)), _)).


                /*******************************
                *           ARGUMENTS          *
                *******************************/

%   given_values(Given, Wanted, Term, Values): Values has Name-Numbers for
%   every wanted argument, in the order of primitive_arguments/3.

given_values(Given, Wanted, Term, Values) :-
    maplist(known_argument(Wanted, Term), Given, Named),
    no_argument_twice(Named, Term),
    maplist(argument_value(Named, Term), Wanted, Values).

known_argument(Wanted, Term, Argument, Name-Numbers) :-
    (   compound(Argument),
        compound_name_arguments(Argument, Name, Values),
        argument_types(Wanted, Name, Types)
    ->  (   maplist(argument_number, Types, Values, Numbers)
        ->  true
        ;   primitive_error(wrong_argument(Argument, Types), Term)
        )
    ;   primitive_error(unknown_argument(Argument), Term)
    ).

argument_types(Wanted, Name, Types) :-
    (   member(argument(Name, Types), Wanted)
    ;   member(argument(Name, Types, _), Wanted)
    ),
    !.

no_argument_twice(Named, Term) :-
    (   append(_, [Name-_|Rest], Named),
        member(Name-_, Rest)
    ->  primitive_error(twice(Name), Term)
    ;   true
    ).

argument_value(Named, Term, Wanted, Name-Numbers) :-
    arg(1, Wanted, Name),
    (   member(Name-Given, Named)
    ->  Numbers = Given
    ;   Wanted = argument(_, _, Default)
    ->  Numbers = Default
    ;   primitive_error(missing(Name), Term)
    ).

argument_number(facets, N, N) :-
    integer(N),
    N >= 3,
    most_facets(Most),
    N =< Most.
argument_number(length, Value, Number) :-
    finite_number(Value, Number),
    Number > 0.0.
argument_number(radius, Value, Number) :-
    finite_number(Value, Number),
    Number >= 0.0.
argument_number(number, Value, Number) :-
    finite_number(Value, Number).

%   finite_number(Value, Float): as in a column of coordinates: an integer or
%   a finite float, never a rational, never -0.0.

finite_number(Value, Float) :-
    integer(Value),
    !,
    catch(Float is float(Value), error(evaluation_error(_), _), fail).
finite_number(Value, Float) :-
    float(Value),
    float_class(Value, Class),
    finite_class(Class),
    Float is Value + 0.0.

finite_class(zero).
finite_class(normal).
finite_class(subnormal).


                /*******************************
                *            SHAPES            *
                *******************************/

%   shape(Name, Values, Term, Points, Chains)

shape(box, [size-[A, B, H]], _, Points,
      [ [4, 3, 2, 1], [5, 6, 7, 8],
        [1, 2, 6, 5], [2, 3, 7, 6], [3, 4, 8, 7], [4, 1, 5, 8]
      ]) :-
    rectangle_points(A, B, 0.0, Bottom),
    rectangle_points(A, B, H, Top),
    append(Bottom, Top, Points).
shape(pyramid, [base-[A, B], height-[H]], _, Points,
      [ [4, 3, 2, 1], [1, 2, 5], [2, 3, 5], [3, 4, 5], [4, 1, 5] ]) :-
    rectangle_points(A, B, 0.0, Base),
    append(Base, [point(0.0, 0.0, H)], Points).
shape(rectangle, [size-[A, B]], _, Points, [[1, 2, 3, 4]]) :-
    rectangle_points(A, B, 0.0, Points).
shape(line, [from-[X1, Y1, Z1], to-[X2, Y2, Z2]], Term,
      [point(X1, Y1, Z1), point(X2, Y2, Z2)], [[1, 2]]) :-
    (   [X1, Y1, Z1] == [X2, Y2, Z2]
    ->  primitive_error(no_length, Term)
    ;   true
    ).
shape(cylinder, [radius-[R], height-[H], facets-[N]], _, Points, Polygons) :-
    frustum(R, R, H, N, Points, Polygons).
shape(cone, [radius-[R], top-[Top], height-[H], facets-[N]], _, Points,
      Polygons) :-
    (   Top =:= 0.0
    ->  pointed_cone(R, H, N, Points, Polygons)
    ;   frustum(R, Top, H, N, Points, Polygons)
    ).

rectangle_points(A, B, Z,
                 [ point(X0, Y0, Z), point(X1, Y0, Z),
                   point(X1, Y1, Z), point(X0, Y1, Z)
                 ]) :-
    X1 is A/2.0,
    X0 is -X1,
    Y1 is B/2.0,
    Y0 is -Y1.

%   frustum(...): base ring 1..N, top ring N+1..2N; polygon 1 is the base, 2
%   the top, then the sides in order.

frustum(R, Top, H, N, Points, [Base, Cap|Sides]) :-
    ring(R, 0.0, N, Points1),
    ring(Top, H, N, Points2),
    append(Points1, Points2, Points),
    base_ring(N, Base),
    First is N+1,
    Last is 2*N,
    numlist(First, Last, Cap),
    numlist(1, N, Is),
    maplist(frustum_side(N), Is, Sides).

frustum_side(N, I, [I, J, J2, I2]) :-
    J is I mod N + 1,
    I2 is N+I,
    J2 is N+J.

pointed_cone(R, H, N, Points, [Base|Sides]) :-
    ring(R, 0.0, N, Points1),
    append(Points1, [point(0.0, 0.0, H)], Points),
    base_ring(N, Base),
    numlist(1, N, Is),
    maplist(cone_side(N), Is, Sides).

cone_side(N, I, [I, J, Apex]) :-
    J is I mod N + 1,
    Apex is N+1.

base_ring(N, Base) :-
    numlist(1, N, Ring),
    reverse(Ring, Base).

ring(R, Z, N, Points) :-
    numlist(1, N, Is),
    maplist(ring_point(R, Z, N), Is, Points).

ring_point(R, Z, N, I, point(X, Y, Z)) :-
    Angle is (I-1)*360 rdiv N,
    exact_sin_cos(Angle, Sin, Cos),
    X is R*Cos + 0.0,
    Y is R*Sin + 0.0.


                /*******************************
                *            PLACING           *
                *******************************/

%   step_motion(Step, Motion): Step checked, its sine and cosine worked out.

step_motion(Step, Motion) :-
    (   motion(Step, Motion0)
    ->  Motion = Motion0
    ;   primitive_error(no_step(Step), Step)
    ).

motion(translate(X0, Y0, Z0), translate(X, Y, Z)) :-
    finite_number(X0, X),
    finite_number(Y0, Y),
    finite_number(Z0, Z).
motion(rotate(Axis, Degrees), rotate(Axis, Sin, Cos)) :-
    nonvar(Axis),
    member(Axis, [x, y, z]),
    finite_number(Degrees, _),
    exact_sin_cos(Degrees, Sin, Cos),
    !.

moved(Motion, Point0, Point) :-
    foldl(moved_once, Motion, Point0, Point).

moved_once(translate(A, B, C), point(X0, Y0, Z0), point(X, Y, Z)) :-
    X is X0 + A + 0.0,
    Y is Y0 + B + 0.0,
    Z is Z0 + C + 0.0.
moved_once(rotate(x, Sin, Cos), point(X, Y0, Z0), point(X, Y, Z)) :-
    turned(Y0, Z0, Sin, Cos, Y, Z).
moved_once(rotate(y, Sin, Cos), point(X0, Y, Z0), point(X, Y, Z)) :-
    turned(Z0, X0, Sin, Cos, Z, X).
moved_once(rotate(z, Sin, Cos), point(X0, Y0, Z), point(X, Y, Z)) :-
    turned(X0, Y0, Sin, Cos, X, Y).

turned(A0, B0, Sin, Cos, A, B) :-
    A is A0*Cos - B0*Sin + 0.0,
    B is A0*Sin + B0*Cos + 0.0.

%!  exact_sin_cos(+Degrees, -Sin, -Cos) is det.
%
%   Sine and cosine of an angle given as a number of Degrees, each a multiple
%   of 2^-48, so that they do not depend on the machine's library. The angle
%   is reduced exactly (as a rational) to 0..45 degrees: multiples of 90 are
%   exact, and sin(A) = cos(90-A) holds to the last bit.

exact_sin_cos(Degrees, Sin, Cos) :-
    Turn is rational(Degrees),
    Quarter is floor(Turn rdiv 90),
    Rest is Turn - 90*Quarter,
    quarter_sin_cos(Rest, S, C),
    Place is Quarter mod 4,
    quarter_turned(Place, S, C, Sin, Cos).

quarter_turned(0, S, C, S, C).
quarter_turned(1, S, C, C, Cos) :- Cos is 0.0 - S.
quarter_turned(2, S, C, Sin, Cos) :- Sin is 0.0 - S, Cos is 0.0 - C.
quarter_turned(3, S, C, Sin, S) :- Sin is 0.0 - C.

quarter_sin_cos(Degrees, Sin, Cos) :-
    (   Degrees =< 45
    ->  Radians is float(Degrees)*pi/180.0,
        Sin is round(sin(Radians)*2.0**48)/2.0**48,
        Cos is round(cos(Radians)*2.0**48)/2.0**48
    ;   Other is 90 - Degrees,
        quarter_sin_cos(Other, Cos, Sin)
    ).
