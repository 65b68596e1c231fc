/* Points and vectors, of floats and of rationals. */
:- module(test_vector, []).
:- use_module(library(plunit)).
:- use_module(rules(vector)).

:- begin_tests(vector).

test(difference, D == p(1.0,2.0,3.0)) :-
    difference(p(2.0,4.0,6.0), p(1.0,2.0,3.0), D).
test(sum, S == p(3.0,0.0,1.0)) :-
    vector_sum(p(1.0,2.0,3.0), p(2.0,-2.0,-2.0), S).
test(doubled_area, A == p(0r1,0r1,8r9)) :-
    doubled_area([p(0r1,0r1,1r3),p(2r3,0r1,1r3),p(2r3,2r3,1r3),p(0r1,2r3,1r3)],
                 A).
test(right_handed, W == p(0.0,0.0,1.0)) :-
    cross_product(p(1.0,0.0,0.0), p(0.0,1.0,0.0), W).
test(dot, Dot =:= 4.0-10.0+18.0) :-
    dot_product(p(1.0,-2.0,3.0), p(4.0,5.0,6.0), Dot).
test(exact, Dot-W == R-p(0,0,1r3)) :-
    R is 1r9 + 1r3,
    dot_product(p(1r3,1,0), p(1r3,1r3,0), Dot),
    cross_product(p(1r3,0,0), p(0,1,0), W).
test(scaled, V == p(2.0,-4.0,0.0)) :-
    scaled(2.0, p(1.0,-2.0,0.0), V).
test(unit, U == p(0.6,0.8,0.0)) :-
    unit(p(3.0,4.0,0.0), U).
test(unit_of_nothing, U == p(0.0,0.0,0.0)) :-
    unit(p(0.0,0.0,0.0), U).
test(angle, true(abs(Angle-pi/2) < 1.0e-15)) :-
    angle_between(p(2.0,0.0,0.0), p(0.0,0.0,5.0), Angle).
test(opposite, true(abs(Angle-pi) < 1.0e-15)) :-
    angle_between(p(2.0,0.0,0.0), p(-1.0,0.0,0.0), Angle).

test(left_of) :-
    left_of(p(0,0,1), p(0,0,0), p(2,0,0), p(1,1,5)).
test(on_the_way) :-
    left_of(p(0,0,1), p(0,0,0), p(2,0,0), p(3,0,0)).
test(right_of, fail) :-
    left_of(p(0,0,1), p(0,0,0), p(2,0,0), p(1,-1r100,0)).
test(seen_from_behind, fail) :-
    left_of(p(0,0,-1), p(0,0,0), p(2,0,0), p(1,1,0)).
:- end_tests(vector).
