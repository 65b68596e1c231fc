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
    left(0.5, [[0-0,9000-0],[500-251,900-351]], L).
test(ends_on_another, [forall(member(End, [0,250])),
                       L == [[0-0,9000-0],[4321-End,4321-600]]]) :-
    left(0.5, [[0-0,9000-0],[4321-End,4321-600]], L).

%   An outline in pieces, a hair apart, stays whole; wherever it is.
test(outline_in_pieces, [forall(member(X-Y, [0-0,749-999,123456-77777])),
                         L == Lines]) :-
    findall([X1-Y1,X2-Y2],
            ( between(0, 20, I),
              X1 is X + I*1500, Y1 is Y + I*900,
              X2 is X1 + 1350, Y2 is Y1 + 800 ),
            Lines),
    left(2, Lines, L).
test(slanting, L == [[0-0,90001-70003]]) :-
    left(2, [[0-0,90001-70003],[46000-35000,46700-35300]], L).
test(touches_slanting, L == Lines) :-
    Lines = [[0-0,90001-70003],[45000-35000,46000-34000]],
    left(2, Lines, L).
test(none_asked, L == [[0-0,4-0]]) :-
    left(0, [[0-0,4-0]], L).

:- end_tests(speck).
