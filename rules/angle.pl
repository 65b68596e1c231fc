:- module(sg_angle,
          [ exact_sin_cos/3,            % +Degrees, -Sin, -Cos
            chord_facets/4              % +Radius, +Tolerance, +Degrees, -N
          ]).
/** <module> Angles of primitives: the same on every machine.
*/

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

%!  chord_facets(+Radius, +Tolerance, +Degrees, -N) is det.
%
%   N is the least number of equal chords for an arc of so many Degrees
%   (0 < Degrees =< 360), each less than half a turn, that stay within
%   Tolerance of the arc: Radius*(1 - cos(Degrees/N/2)) =< Tolerance. The
%   estimate may differ by one between machines, the answer does not. Above ten
%   million, N is only some power of ten above it.

chord_facets(Radius, Tolerance, Degrees, N) :-
    Turn is rational(Degrees),
    Least is floor(Turn rdiv 180) + 1,
    Ratio is max(1.0e-300, min(1.0, Tolerance/Radius/2.0)),
    Estimate is float(Turn)*pi/720.0/asin(sqrt(Ratio)),
    (   Estimate > 1.0e7                % more than any primitive may have
    ->  N is 10**ceiling(log10(Estimate))
    ;   N0 is max(Least, ceiling(Estimate)),
        fewer(N0, Least, Radius, Tolerance, Turn, N1),
        more(N1, Radius, Tolerance, Turn, N)
    ).

fewer(N0, Least, Radius, Tolerance, Turn, N) :-
    N1 is N0-1,
    (   N1 >= Least,
        near(N1, Radius, Tolerance, Turn)
    ->  fewer(N1, Least, Radius, Tolerance, Turn, N)
    ;   N = N0
    ).

more(N0, Radius, Tolerance, Turn, N) :-
    (   near(N0, Radius, Tolerance, Turn)
    ->  N = N0
    ;   N1 is N0+1,
        more(N1, Radius, Tolerance, Turn, N)
    ).

near(N, Radius, Tolerance, Turn) :-
    Quarter is Turn rdiv (4*N),
    exact_sin_cos(Quarter, Sin, _),
    2.0*Radius*Sin*Sin =< Tolerance.
