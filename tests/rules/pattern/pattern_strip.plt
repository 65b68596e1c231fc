:- module(test_pattern_strip, []).
:- use_module(library(apply)).
:- use_module(library(assoc)).
:- use_module(library(lists)).
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

%   runs(Width, Seams, Runs): the numbers of the seams that share a tab, of
%   seams Length-Degrees that follow each other.

runs(Width, Seams, Runs) :-
    findall(J-Length, nth1(J, Seams, Length-_), Lengths0),
    findall(J-Way, ( nth1(J, Seams, _-Degrees), Way is Degrees*pi/180 ), Ways0),
    maplist(list_to_assoc, [Lengths0,Ways0], [Lengths,Ways]),
    findall(J-partner, nth1(J, Seams, _), Strand),
    findall(Js,
            ( sg_pattern_strip:strand_run(Strand, Width, Lengths, Ways, Run),
              findall(J, member(J-partner, Run), Js) ),
            Runs).

sizes(Width, Seams, Sizes) :-
    runs(Width, Seams, Runs),
    maplist(length, Runs, Sizes).

equal(N, Length, Turn, Seams) :-
    findall(Length-Degrees,
            ( between(1, N, I), Degrees is (I-1)*Turn ),
            Seams).

%   forms(Points, Width, Least, Forms): Deep-Slope-Area of each, in order, Deep
%   and Area in hundredths. How deep it is and how steep its ends are is read
%   from the outline.

forms(Points, Width, Least, Forms) :-
    findall(Form,
            ( sg_pattern_strip:strip_form(Points, Width, Least,
                                          strip([X0-Y0,X1-Y1|_],_), Area),
              Deep is Y0-Y1,
              Slope is (X1-X0)/Deep,
              hundredths(Deep, Slope, Area, Form) ),
            Forms).

hundredths(D0, S0, A0, D-S-A) :-
    D is round(100*D0),
    S is round(S0),
    A is round(100*A0).

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

% At most two and a half widths, in equal parts; half of the next seam counts.
test(equal_runs, [ forall(member(N-Width-Sizes,
                                 [ 20-2-[5,5,5,5], 21-2-[4,4,4,4,5],
                                   10-4-[10], 11-4-[6,5], 7-4-[7] ])),
                   true(Sizes0 == Sizes) ]) :-
    equal(N, 1.0, 0, Seams),
    sizes(Width, Seams, Sizes0).
% Nine tenths of a width are too long; what is between those is apart.
test(short_ones, Runs == [[1,2],[4,5,6]]) :-
    runs(2, [1.0-0,1.7-0,1.8-0,0.5-0,1.0-0,1.79-0,2.0-0,1.0-0], Runs).
test(one_is_no_run, Runs == []) :-
    runs(2, [1.0-0,3.0-0,1.0-0], Runs).
% A run turns by 25 degrees or less; the last one goes with those before it.
test(turned, [ forall(member(Turn-Sizes, [12.5-[3,3],12.6-[2,2,2],8.3-[4,2],
                                          8.4-[3,3],-8.3-[4,2],26-[2]])),
               true(Sizes0 == Sizes) ]) :-
    equal(6, 1.0, Turn, Seams),
    sizes(5, Seams, Sizes0).
% Of a straight line: all of the width, then less; flat ends before steep ones.
test(straight, Forms == [400-1-2400,300-1-2100,220-1-1716,220-2-1232,160-1-1344,
                         160-2-1088]) :-
    forms([0.0-0.0,4.0-0.0,10.0-0.0], 4.0, 1.0, Forms).
test(least_depth, Forms == [400-1-2400,300-1-2100]) :-
    forms([0.0-0.0,10.0-0.0], 4.0, 2.5, Forms).
% No deeper than 0.45 of the chord, and a tenth of that is left on top.
test(short_chord, Forms == [135-1-358,99-1-298,72-1-236,72-2-184]) :-
    forms([0.0-0.0,4.0-0.0], 9.0, 0.5, Forms).

:- end_tests(pattern_strip).
