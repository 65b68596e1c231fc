:- module(sg_placing,
          [ step_motion/2,              % +Step, -Motion
            moved/3,                    % +Motions, +Point0, -Point
            moved_vector/3,             % +Motions, +Vector0, -Vector
            motion_mirrors/1,           % +Motions
            motion_stretch/2            % +Motions, -Factor
          ]).
:- use_module('../angle', [exact_sin_cos/3]).
:- use_module(primitive_argument, [finite_number/2]).
:- use_module(library(apply), [foldl/4, maplist/3, maplist/4]).
:- use_module(library(lists), [max_list/2, member/2, sum_list/2]).
/** <module> Placing primitives: any affine map, as a list of steps.

The steps of at/2 are done from left to right, about the fixed axes of the
model:

    translate(X, Y, Z)
    rotate(x, Degrees)   rotate(y, Degrees)   rotate(z, Degrees)
    rotate(axis(X, Y, Z), Degrees)       about a line through the origin
    rotate(from(X, Y, Z), to(X, Y, Z), Degrees)    about any line
    scale(F)   scale(FX, FY, FZ)         not 0; negative ones mirror
    mirror(x)   mirror(y)   mirror(z)    that coordinate changes its sign
    mirror(normal(X, Y, Z))              in the plane through the origin
    matrix([[A,B,C,D], [E,F,G,H], [I,J,K,L]])      X' = A*X+B*Y+C*Z+D, ...

Rotations are counter-clockwise seen from the positive end of the axis. A
motion is a step with its numbers worked out. Points are point(X, Y, Z) of
floats. Constructions: rounded, step by step.
*/

%!  step_motion(+Step, -Motion) is semidet.
%
%   Motion is the checked Step, its sines and cosines worked out. Fails if
%   Step is none, or squeezes space flat.

step_motion(Step, Motion) :-
    nonvar(Step),
    motion(Step, Motion),
    !.

motion(translate(X0, Y0, Z0), translate(X, Y, Z)) :-
    numbers([X0, Y0, Z0], [X, Y, Z]).
motion(rotate(Axis, Degrees), rotate(Axis, Sin, Cos)) :-
    atom(Axis),
    member(Axis, [x, y, z]),
    angle(Degrees, Sin, Cos).
motion(rotate(axis(X0, Y0, Z0), Degrees), Motion) :-
    numbers([X0, Y0, Z0], Axis),
    axis_motion(Axis, [0.0, 0.0, 0.0], Degrees, Motion).
motion(rotate(from(X0, Y0, Z0), to(X1, Y1, Z1), Degrees), Motion) :-
    numbers([X0, Y0, Z0], From),
    numbers([X1, Y1, Z1], To),
    maplist(difference, From, To, Axis),
    axis_motion(Axis, From, Degrees, Motion).
motion(scale(F0), scale(F, F, F)) :-
    factors([F0], [F]).
motion(scale(X0, Y0, Z0), scale(X, Y, Z)) :-
    factors([X0, Y0, Z0], [X, Y, Z]).
motion(mirror(Axis), scale(X, Y, Z)) :-
    atom(Axis),
    member(Axis-[X, Y, Z], [ x-[-1.0, 1.0, 1.0], y-[1.0, -1.0, 1.0],
                             z-[1.0, 1.0, -1.0] ]).
motion(mirror(normal(X0, Y0, Z0)), matrix(Rows)) :-
    numbers([X0, Y0, Z0], Normal),
    unit(Normal, [X, Y, Z]),
    maplist(mirror_row([X, Y, Z]),
            [X-[1.0, 0.0, 0.0], Y-[0.0, 1.0, 0.0], Z-[0.0, 0.0, 1.0]],
            Rows).
motion(matrix(Rows0), matrix(Rows)) :-
    is_list(Rows0),
    maplist(numbers, Rows0, Rows),
    Rows = [[_, _, _, _], [_, _, _, _], [_, _, _, _]],
    determinant(Rows, Determinant),
    Determinant =\= 0.

numbers(Values, Floats) :-
    is_list(Values),
    maplist(finite_number, Values, Floats).

factors(Values, Factors) :-
    numbers(Values, Factors),
    \+ ( member(F, Factors), F =:= 0.0 ).

angle(Degrees, Sin, Cos) :-
    finite_number(Degrees, _),
    exact_sin_cos(Degrees, Sin, Cos).

difference(A, B, C) :-
    C is B - A.

%   unit(Vector, Unit): the longest coordinate is made 1 first, so that
%   squares neither overflow nor vanish.

unit(Vector, Unit) :-
    maplist(size, Vector, Sizes),
    max_list(Sizes, Most),
    Most > 0.0,
    maplist(quotient(Most), Vector, [X, Y, Z]),
    Length is sqrt(X*X + Y*Y + Z*Z),
    maplist(quotient(Length), [X, Y, Z], Unit).

size(X, Size) :-
    Size is abs(X).

quotient(Divisor, X, Quotient) :-
    Quotient is X/Divisor.

mirror_row([X, Y, Z], N-[A0, B0, C0], [A, B, C, 0.0]) :-
    A is A0 - 2.0*N*X,
    B is B0 - 2.0*N*Y,
    C is C0 - 2.0*N*Z.

%   axis_motion(Axis, Through, Degrees, Motion): the formula of Rodrigues.

axis_motion(Axis, Through, Degrees, about(Through, matrix(Rows))) :-
    unit(Axis, [X, Y, Z]),
    angle(Degrees, S, C),
    T is 1.0 - C,
    A1 is T*X*X + C,
    A2 is T*X*Y - S*Z,
    A3 is T*X*Z + S*Y,
    B1 is T*X*Y + S*Z,
    B2 is T*Y*Y + C,
    B3 is T*Y*Z - S*X,
    C1 is T*X*Z - S*Y,
    C2 is T*Y*Z + S*X,
    C3 is T*Z*Z + C,
    Rows = [[A1, A2, A3, 0.0], [B1, B2, B3, 0.0], [C1, C2, C3, 0.0]].

%   determinant(Rows, D): of the linear part, exact.

determinant(Rows, D) :-
    maplist(rational_row, Rows, [[A1, A2, A3], [B1, B2, B3], [C1, C2, C3]]),
    D is A1*(B2*C3 - B3*C2) - A2*(B1*C3 - B3*C1) + A3*(B1*C2 - B2*C1).

rational_row([A0, B0, C0|_], [A, B, C]) :-
    A is rational(A0),
    B is rational(B0),
    C is rational(C0).

%!  moved(+Motions, +Point0, -Point) is det.
%
%   Point is point(X, Y, Z) after Motions, a list of motions.

moved(Motions, Point0, Point) :-
    foldl(moved_once, Motions, Point0, Point).

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
moved_once(scale(A, B, C), point(X0, Y0, Z0), point(X, Y, Z)) :-
    X is X0*A + 0.0,
    Y is Y0*B + 0.0,
    Z is Z0*C + 0.0.
moved_once(matrix([A, B, C]), point(X0, Y0, Z0), point(X, Y, Z)) :-
    row_times(A, X0, Y0, Z0, X),
    row_times(B, X0, Y0, Z0, Y),
    row_times(C, X0, Y0, Z0, Z).
moved_once(about([A, B, C], Motion), point(X0, Y0, Z0), Point) :-
    X1 is X0 - A,
    Y1 is Y0 - B,
    Z1 is Z0 - C,
    moved_once(Motion, point(X1, Y1, Z1), Point2),
    moved_once(translate(A, B, C), Point2, Point).

turned(A0, B0, Sin, Cos, A, B) :-
    A is A0*Cos - B0*Sin + 0.0,
    B is A0*Sin + B0*Cos + 0.0.

row_times([A, B, C, D], X, Y, Z, W) :-
    W is A*X + B*Y + C*Z + D + 0.0.

%!  moved_vector(+Motions, +Vector0, -Vector) is det.
%
%   The same for vector(X, Y, Z): a direction with a length, which is not
%   translated.

moved_vector(Motions, Vector0, Vector) :-
    foldl(vector_once, Motions, Vector0, Vector).

vector_once(translate(_, _, _), Vector, Vector) :-
    !.
vector_once(about(_, Motion), Vector0, Vector) :-
    !,
    vector_once(Motion, Vector0, Vector).
vector_once(Motion0, vector(X0, Y0, Z0), vector(X, Y, Z)) :-
    (   Motion0 = matrix(Rows0)
    ->  maplist(linear_row, Rows0, Rows),
        Motion = matrix(Rows)
    ;   Motion = Motion0
    ),
    moved_once(Motion, point(X0, Y0, Z0), point(X, Y, Z)).

linear_row([A, B, C, _], [A, B, C, 0.0]).

%!  motion_mirrors(+Motions) is semidet.
%
%   True when Motions make a left hand of a right hand: what is
%   counter-clockwise before is clockwise after. Exact.

motion_mirrors(Motions) :-
    foldl(signed, Motions, 1, Sign),
    Sign < 0.

signed(Motion, Sign0, Sign) :-
    motion_sign(Motion, Sign1),
    Sign is Sign0*Sign1.

motion_sign(scale(A, B, C), Sign) :-
    !,
    Sign is integer(sign(A)*sign(B)*sign(C)).
motion_sign(matrix(Rows), Sign) :-
    !,
    determinant(Rows, D),
    Sign is sign(D).
motion_sign(_, 1).

%!  motion_stretch(+Motions, -Factor) is det.
%
%   No distance becomes more than Factor times as long, and Factor is 1.0 if
%   nothing is scaled. Of scaling by three factors and of matrices it is an
%   upper bound (Gershgorin, of the matrix times its transpose).

motion_stretch(Motions, Factor) :-
    foldl(stretched, Motions, 1.0, Factor).

stretched(Motion, Factor0, Factor) :-
    stretch_once(Motion, Once),
    Factor is Factor0*Once.

stretch_once(scale(A, B, C), Factor) :-
    !,
    Factor is max(abs(A), max(abs(B), abs(C))).
stretch_once(matrix(Rows), Factor) :-
    !,
    maplist(gershgorin(Rows), Rows, Sums),
    max_list(Sums, Most),
    Factor is sqrt(Most).
stretch_once(_, 1.0).

gershgorin(Lines, Line, Sum) :-
    maplist(size_of_product(Line), Lines, Sizes),
    sum_list(Sizes, Sum).

size_of_product([A, B, C, _], [D, E, F, _], Size) :-
    Size is abs(A*D + B*E + C*F).
