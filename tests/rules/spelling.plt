:- module(test_spelling, []).
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(rules(spelling)).

words([size, tabs, thickness, color, colour, 'open-slits', numbers, names]).

near(Word, Near) :-
    words(Words),
    near_words(Word, Words, Near).

:- begin_tests(spelling).

test(left_out, Near == [thickness]) :- near(thicknes, Near).
test(too_many, Near == [thickness]) :- near(thicckness, Near).
test(replaced, Near == [thickness]) :- near(thickmess, Near).
test(changed_places, Near == [tabs]) :- near(tbas, Near).
test(two_steps, Near == [thickness]) :- near(thikcnes, Near).
test(end_left_out, Near == ['open-slits']) :- near(open, Near).
test(end_left_out_is_farther, Near == [tabs]) :-
    near_words(tab, [table,tabs], Near).
test(capitals, Near == [tabs]) :- near('TABS', Near).
% Four letters may have one wrong, three too, but not two.
test(far, Near == []) :- near(tuba, Near).
test(none, Near == []) :- near(banana, Near).
test(one_letter, Near == []) :- near(t, Near).
% The nearest alone, but all of these.
test(nearest, Near == [color]) :- near(color, Near).
test(several, Near == [color,colour]) :- near(colou, Near).
test(no_words, Near == []) :- near_words(tabs, [], Near).

:- end_tests(spelling).
