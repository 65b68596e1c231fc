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
test(swapped_at_the_start, Near == [tabs]) :- near(atbs, Near).

%   Words as long as may be, and longer: no search without end.

test(long_words, Near == []) :-
    length(As, 60),
    maplist(=(a), As),
    length(Bs, 60),
    maplist(=(b), Bs),
    length(Cs, 3000),
    maplist(=(a), Cs),
    maplist(atom_chars, [A,B,C], [As,Bs,Cs]),
    call_with_inference_limit(( near_words(A, [B], Near1),
                                near_words(C, [A,B], Near2) ), 200000, _),
    nonvar(Near2),
    append(Near1, Near2, Near).

:- end_tests(spelling).
