:- module(sg_true_quadratic,
          [ on_circle/3,                % +T, -Cos, -Sin
            coordinate/3,               % +Place, +Row, -Coordinate
            quadratic/5,                % +Rows, +Quadric, +T, -ABC, -Growth
            discriminant/5,             % +Rows, +Quadric, +T, -D, -Slope
            signed_form/3,              % +Rows, +Quadric, -Form
            slope_sign/3,               % +Form, +T, -Sign
            value_sign/3                % +Form, +T, -Sign
          ]).
:- use_module(library(apply), [maplist/3]).
/** <module> Where a generator goes through a quadric: A*H^2 + 2*B*H + C =< 0.

Rows and Quadric are those of a pipe (true_pipe.pl). A, B and C are rational
numbers, of a point that is exactly on the circle. Of the discriminant B^2 - A*C
and its slope often only signs are asked: a filter in floating point decides
almost all of them, and the exact numbers the rest.
*/

%!  on_circle(+T, -Cos, -Sin) is det.
%
%   Cos and Sin of T degrees are rational, and on the circle.

on_circle(T, Cos, Sin) :-
    Half is rational(tan(T*pi/360.0)),
    Square is Half*Half,
    Cos is rdiv(1 - Square, 1 + Square),
    Sin is rdiv(2*Half, 1 + Square).

%!  coordinate(+Place, +Row, -Coordinate) is det.
%
%   Place is Cos-Sin of T. Coordinate is c(X0, X1, D0, D1): X0 + X1*H along the
%   generator, and how these grow with T in radians.

coordinate(Cos-Sin, row(A0, A1, A2, A3, F), c(X0, X1, D0, D1)) :-
    Across is A1*Cos + A2*Sin,
    X0 is A0 + Across,
    X1 is A3 + F*Across,
    D0 is A2*Cos - A1*Sin,
    D1 is F*D0.

%!  quadratic(+Rows, +Quadric, +T, -ABC, -Growth) is det.
%
%   ABC is abc(A, B, C), exact, and Growth how these grow with T.

quadratic(Rows, Quadric, T, ABC, Growth) :-
    on_circle(T, Cos, Sin),
    maplist(coordinate(Cos-Sin), Rows, Coordinates),
    quadratic_of(Coordinates, Quadric, ABC, Growth).

quadratic_of([c(X0, X1, XD0, XD1),c(Y0, Y1, YD0, YD1),c(Z0, Z1, ZD0, ZD1)],
             quadric(S, N0, N1, Const), abc(A, B, C), abc(DA, DB, DC)) :-
    M0 is N0 + N1*Z0,
    M1 is N1*Z1,
    MD0 is N1*ZD0,
    MD1 is N1*ZD1,
    A is X1*X1 + Y1*Y1 + S*M1*M1,
    B is X0*X1 + Y0*Y1 + S*M0*M1,
    C is X0*X0 + Y0*Y0 + S*M0*M0 - Const,
    DA is 2*(X1*XD1 + Y1*YD1 + S*M1*MD1),
    DB is XD0*X1 + X0*XD1 + YD0*Y1 + Y0*YD1 + S*(MD0*M1 + M0*MD1),
    DC is 2*(X0*XD0 + Y0*YD0 + S*M0*MD0).

%!  discriminant(+Rows, +Quadric, +T, -D, -Slope) is det.
%
%   D is the discriminant at T, exact, and Slope how it grows with T.

discriminant(Rows, Quadric, T, D, Slope) :-
    quadratic(Rows, Quadric, T, ABC, Growth),
    discriminant_of(ABC, Growth, D, Slope).

discriminant_of(abc(A, B, C), abc(DA, DB, DC), D, Slope) :-
    D is B*B - A*C,
    Slope is 2*B*DB - DA*C - A*DC.


                /*******************************
                *            SIGNS             *
                *******************************/

%!  signed_form(+Rows, +Quadric, -Form) is det.
%
%   Form is form(Rows, Quadric, Filter), for slope_sign/3 and value_sign/3.
%   Filter is filter(FRows, FQuadric, Bound), the same in floating point: a
%   discriminant or slope that is computed from it is off by less than Bound. It
%   is `none` if numbers are too large or small for that.
%
%   Size is what A + C would be if all terms had one sign and the cosine and
%   sine were 1. Then B is at most half of Size, and DA, DB and DC at most twice
%   A, B and C; so the terms of both sum to 2*Size^2 at the most. Each comes of
%   fewer than 128 roundings, by 2^-53 of it each.

signed_form(Rows, Quadric, form(Rows, Quadric, Filter)) :-
    maplist(largest_coordinate, Rows, Largest),
    Quadric = quadric(S, N0, N1, Const),
    S1 is abs(S),
    M0 is abs(N0),
    M1 is abs(N1),
    Less is -abs(Const),
    quadratic_of(Largest, quadric(S1, M0, M1, Less), abc(A, _, C), _),
    Size is A+C,
    (   Size*10**100 > 1,
        Size < 10**100
    ->  maplist(float_arguments, Rows, FRows),
        float_arguments(Quadric, FQuadric),
        Bound is 2.0*float(Size)**2 * 2.0**(-46),
        Filter = filter(FRows, FQuadric, Bound)
    ;   Filter = none
    ).

largest_coordinate(row(A0, A1, A2, A3, F), c(X0, X1, D0, D1)) :-
    D0 is abs(A1) + abs(A2),
    D1 is abs(F)*D0,
    X0 is abs(A0) + D0,
    X1 is abs(A3) + D1.

float_arguments(Term0, Term) :-
    compound_name_arguments(Term0, Name, Arguments0),
    maplist(as_float, Arguments0, Arguments),
    compound_name_arguments(Term, Name, Arguments).

as_float(Q, X) :-
    X is float(Q).

%!  slope_sign(+Form, +T, -Sign) is det.
%
%   Sign is that of how the discriminant grows at T: less than 0, 0 or more. It
%   is exact: where floating point cannot tell, the exact slope does.

slope_sign(form(Rows, Quadric, Filter), T, Sign) :-
    (   filtered(Filter, T, _, Slope, Bound),
        abs(Slope) > Bound
    ->  true
    ;   discriminant(Rows, Quadric, T, _, Slope)
    ),
    Sign is sign(Slope).

%!  value_sign(+Form, +T, -Sign) is det.
%
%   Sign is that of the discriminant at T, as slope_sign/3 has that of its
%   slope.

value_sign(form(Rows, Quadric, Filter), T, Sign) :-
    (   filtered(Filter, T, D, _, Bound),
        abs(D) > Bound
    ->  true
    ;   discriminant(Rows, Quadric, T, D, _)
    ),
    Sign is sign(D).

filtered(filter(Rows, Quadric, Bound), T, D, Slope, Bound) :-
    Half is tan(T*pi/360.0),
    Square is Half*Half,
    Cos is (1.0-Square)/(1.0+Square),
    Sin is 2.0*Half/(1.0+Square),
    maplist(coordinate(Cos-Sin), Rows, Coordinates),
    quadratic_of(Coordinates, Quadric, ABC, Growth),
    discriminant_of(ABC, Growth, D, Slope).
