:- module(test_pattern_strip, []).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(pattern/pattern_strip), []).

/* Along a chord and back: places seen from it. */

random_place(X-Y) :-
    random(A),
    random(B),
    X is 200*A-100,
    Y is 200*B-100.

near(A, B) :-
    abs(A-B) < 1.0e-9.

:- begin_tests(pattern_strip).

test(there_and_back, [ setup(set_random(seed(1988))),
                       forall(between(1, 100, _)) ]) :-
    maplist(random_place, [A,B,P]),
    sg_pattern_strip:chord(A, B, Chord),
    sg_pattern_strip:seen_along(Chord, P, Seen),
    sg_pattern_strip:seen_from(Chord, Seen, Q),
    P = X0-Y0,
    Q = X-Y,
    near(X, X0),
    near(Y, Y0).
% The ends are on the chord; to its right is deep.
test(ends, [ setup(set_random(seed(1989))), forall(between(1, 50, _)) ]) :-
    maplist(random_place, [XA-YA,XB-YB]),
    sg_pattern_strip:chord(XA-YA, XB-YB, Chord),
    Length is sqrt((XB-XA)**2+(YB-YA)**2),
    sg_pattern_strip:seen_along(Chord, XA-YA, A0-AD),
    sg_pattern_strip:seen_along(Chord, XB-YB, B0-BD),
    maplist(near, [A0,AD,B0,BD], [0.0,0.0,Length,0.0]),
    X is XA+(YB-YA),
    Y is YA-(XB-XA),
    sg_pattern_strip:seen_along(Chord, X-Y, Along-Deep),
    maplist(near, [Along,Deep], [0.0,Length]).

:- end_tests(pattern_strip).
