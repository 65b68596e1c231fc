:- module(test_spelling, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(yall)).
:- use_module(rules(spelling)).

words([size, tabs, thickness, color, colour, 'open-slits', numbers, names]).

near(Word, Near) :-
    words(Words),
    near_words(Word, Words, Near).

%   far(As, Bs, N): as the definition says it, from the ends of both.

far([], Bs, N) :-
    !,
    length(Bs, N).
far(As, [], N) :-
    !,
    length(As, N).
far([A|As], [B|Bs], N) :-
    findall(Steps, steps(A, As, B, Bs, Steps), All),
    min_list(All, N).

steps(A, As, A, Bs, N) :-
    far(As, Bs, N).
steps(_, As, B, Bs, N) :-
    far(As, [B|Bs], N0),
    N is N0+1.
steps(A, As, _, Bs, N) :-
    far([A|As], Bs, N0),
    N is N0+1.
steps(_, As, _, Bs, N) :-
    far(As, Bs, N0),
    N is N0+1.
steps(A, [B|As], B, [A|Bs], N) :-
    far(As, Bs, N0),
    N is N0+1.

random_word(Word) :-
    random_between(1, 6, Length),
    findall(Letter, ( between(1, Length, _), random_member(Letter, [a,b,c]) ),
            Letters),
    atom_chars(Word, Letters).

nearest(Word, Words, Near) :-
    atom_chars(Word, As),
    length(As, Length),
    Most is max(1, Length//3),
    findall(N-Other,
            ( member(Other, Words),
              atom_chars(Other, Bs),
              Length >= 3,
              far(As, Bs, N0),
              (   N0 =< Most
              ->  N = N0
              ;   atom_concat(Word, _, Other)
              ->  N is Most+1
              ) ),
            Pairs),
    (   Pairs == []
    ->  Near = []
    ;   findall(N, member(N-_, Pairs), Ns),
        min_list(Ns, Least),
        findall(Other, member(Least-Other, Pairs), Near0),
        sort(Near0, Near)
    ).

:- begin_tests(spelling).

test(as_defined, true(Wrong == [])) :-
    set_random(seed(3)),
    findall(Word-Words-Near,
            ( between(1, 60, _),
              random_word(Word),
              findall(Other, ( between(1, 4, _), random_word(Other) ), Words),
              near_words(Word, Words, Near),
              \+ nearest(Word, Words, Near) ),
            Wrong).
% So long that only what begins with it is near.
test(longest, true(Nears == [[Other64],[]])) :-
    findall(Word, ( member(N, [64,65]), length(As, N), maplist(=(a), As),
                    atom_chars(Word, As) ), [Word64,Word65]),
    maplist([Word,Other]>>sub_atom(Word, 1, _, 0, Other), [Word64,Word65],
            [Other64,Other65]),
    near_words(Word64, [Other64], Near1),
    near_words(Word65, [Other65], Near2),
    Nears = [Near1,Near2].

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
