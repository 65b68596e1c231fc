:- encoding(utf8).
:- module(test_term_word, []).
% covers: term_word_ko
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(csg/csg_term)).
:- use_module(rules(message/term_word_ko)).
:- use_module(rules(primitive/primitive)).

/* Whatever a form or the tree names has one word in Korean. */

word(Name) :-
    primitive(Name).
word(Argument) :-
    primitive_numbers(_, Argument, _).
word(Name) :-
    operation_form(Name, _).
word(Name) :-
    member(Name, [translate,rotate,scale,mirror,matrix,plane,normal]).
word(Outline) :-
    member(Outline, [circle,ellipse,rectangle,polygon]).

:- begin_tests(term_word).

test(all, Missing == []) :-
    setof(Word, word(Word), Words),
    findall(Word, ( member(Word, Words), \+ term_word_ko(Word, _) ), Missing).
test(no_others, Others == []) :-
    findall(Word, ( term_word_ko(Word, _), \+ word(Word) ), Others).
test(once, Twice == []) :-
    findall(Word, ( term_word_ko(Word, A), term_word_ko(Word, B), A @< B ),
            Twice).
test(different, Same == []) :-              % in one form two are told apart
    findall(A-B,
            ( primitive_numbers(Name, A, _), primitive_numbers(Name, B, _),
              A @< B, term_word_ko(A, Ko), term_word_ko(B, Ko) ),
            Same).

:- end_tests(term_word).
