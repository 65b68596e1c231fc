/* Angles of primitives against arithmetic. */
:- module(test_angle, []).
:- use_module(library(plunit)).
:- use_module(rules(angle)).

%   chords(Radius, Tolerance, Degrees, N): counted up from the fewest.

chords(Radius, Tolerance, Degrees, N) :-
    Least is floor(Degrees/180)+1,
    between(Least, inf, N),
    Radius*(1-cos(Degrees/N/2*pi/180)) =< Tolerance,
    !.

:- begin_tests(angle).

test(sine_and_cosine, [ forall(( between(-80, 160, K),
                                 member(Part, [0,0.5,7r3]) )),
                        true(( Off1 < 2.0e-14, Off2 < 2.0e-14 )) ]) :-
    Degrees is K*9+Part,
    exact_sin_cos(Degrees, Sin, Cos),
    Off1 is abs(Sin-sin(Degrees*pi/180)),
    Off2 is abs(Cos-cos(Degrees*pi/180)),
    0.0 =:= Sin*2.0**48-truncate(Sin*2.0**48),
    0.0 =:= Cos*2.0**48-truncate(Cos*2.0**48).
test(to_the_last_bit, forall(between(0, 90, Degrees))) :-
    Other is 90-Degrees,
    exact_sin_cos(Degrees, Sin, Cos),
    exact_sin_cos(Other, Cos1, Sin1),
    Sin =:= Sin1,
    Cos =:= Cos1.
test(quarters, Found == [0.0/1.0,1.0/0.0,0.0/(-1.0),(-1.0)/0.0]) :-
    findall(S/C, ( member(D, [360,-270,180,630]), exact_sin_cos(D, S0, C0),
                   S is S0+0.0, C is C0+0.0 ), Found).
test(chords, [ forall(( member(Radius, [0.3,1,40]),
                        member(Tolerance, [0.7,0.31,0.05,0.0013,39]),
                        member(Degrees, [360,359,181,180,179,90,7]) )),
               true(N == Counted) ]) :-
    chord_facets(Radius, Tolerance, Degrees, N),
    chords(Radius, Tolerance, Degrees, Counted).
test(too_many, true(Ns == [100 000 000,1000 000 000])) :-
    findall(N, ( member(T, [1.0e-14,1.0e-16]), chord_facets(1, T, 180, N) ),
            Ns).

:- end_tests(angle).
