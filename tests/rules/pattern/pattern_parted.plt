:- module(test_pattern_parted, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(pattern/pattern_parted)).

% Turned by 1 radian and moved, so that nothing is exact.
turned(X-Y, U-V) :-
    C is cos(1.0),
    S is sin(1.0),
    U is C*X - S*Y + 217.3,
    V is S*X + C*Y - 43.1.

turned_segment(A0-B0, A-B) :-
    turned(A0, A),
    turned(B0, B).

counts(Segments, Counts) :-
    parted_segments(Segments, Partss),
    maplist(length, Partss, Counts).

:- begin_tests(pattern_parted).

test(none, Partss == []) :-
    parted_segments([], Partss).
test(long_on_two_short, Parts == [(0.0-0.0)-(4.0-0.0), (4.0-0.0)-(10.0-0.0)]) :-
    parted_segments([(0.0-0.0)-(10.0-0.0), (4.0-0.0)-(0.0-0.0),
                     (10.0-0.0)-(4.0-0.0)],
                    [Parts,_,_]).
test(parts_run_as_the_line,
     Parts == [(10.0-0.0)-(4.0-0.0), (4.0-0.0)-(0.0-0.0)]) :-
    parted_segments([(10.0-0.0)-(0.0-0.0), (4.0-0.0)-(12.0-0.0)], [Parts,_]).
test(both_are_parted, Counts == [2,2]) :-
    counts([(0.0-0.0)-(10.0-0.0), (4.0-0.0)-(12.0-0.0)], Counts).
test(ends_alone_part_nothing, Counts == [1,1,1]) :-
    counts([(0.0-0.0)-(4.0-0.0), (4.0-0.0)-(9.0-0.0), (4.0-0.0)-(4.0-3.0)],
           Counts).
test(crossings_part_nothing, Counts == [1,1]) :-
    counts([(0.0-0.0)-(4.0-0.0), (2.0-1.0)-(2.0-(-1.0))], Counts).
test(the_same_line_twice, Counts == [1,1]) :-
    counts([(0.0-0.0)-(4.0-0.0), (4.0-0.0)-(0.0-0.0)], Counts).
test(beside_each_other, Counts == [1,1]) :-
    counts([(0.0-0.0)-(10.0-0.0), (4.0-0.001)-(6.0-0.001)], Counts).
test(turned, Counts == [3,1,2,1,1]) :-
    maplist(turned_segment,
            [(0.0-0.0)-(10.0-0.0), (1.0-0.0)-(4.0-0.0), (4.0-0.0)-(11.0-0.0),
             (11.0-0.0)-(14.0-0.0), (0.0-0.0)-(0.0-9.0)],
            Segments),
    counts(Segments, Counts).
% Rounding takes a line to either side of the axes, where the angle turns over.
test(along_the_axes, Counts == [2,1,2,1]) :-
    counts([(5.0-0.0)-(5.0-10.0), (5.0000000001-4.0)-(5.0-0.0),
            (0.0-7.0)-(10.0-7.0), (4.0-7.0000000001)-(0.0-7.0)],
           Counts).

:- end_tests(pattern_parted).
