:- module(test_speck, []).
:- use_module(library(apply)).
:- use_module(library(plunit)).
:- use_module(rules(sheet/speck)).

stroke(Points, stroke(visible,crease,1,[1],Points,joint,joint)).

%   What is left of strokes, as points, without those shorter than Least.
left(Least, Lines, Left) :-
    maplist(stroke, Lines, Strokes0),
    without_specks(Least, [view('',Strokes0,[text])],
                   [view('',Strokes,[text])]),
    maplist(stroke, Left, Strokes).

:- begin_tests(speck).

test(alone, L == []) :-
    left(0.5, [[0-0,400-0]], L).
test(long_enough, L == [[0-0,400-0,400-100]]) :-
    left(0.5, [[0-0,400-0,400-100]], L).
test(goes_on, L == [[0-0,400-0],[400-0,9000-0]]) :-
    left(0.5, [[0-0,400-0],[400-0,9000-0]], L).
test(closed, L == [[0-0,9-0,9-9,0-0]]) :-
    left(0.5, [[0-0,9-0,9-9,0-0]], L).
test(beside_another, L == [[0-0,9000-0]]) :-
    left(0.5, [[0-0,9000-0],[5-5,9-9]], L).
test(none_asked, L == [[0-0,4-0]]) :-
    left(0, [[0-0,4-0]], L).

:- end_tests(speck).
