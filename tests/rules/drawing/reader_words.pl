:- module(reader_words,
          [ must/2,                     % :Goal, +What
            unique/2,                   % +Keys, +What
            number_of/2,                % +Text, -Number
            words/2,                    % +Text, -Words
            near/3                      % +A, +B, +Least
          ]).
:- use_module(library(apply)).
:- use_module(library(lists)).
/* What the readers of drawings (drawing_reader.pl) have in common. */

must(Goal, What) :-
    (   call(Goal)
    ->  true
    ;   throw(wrong(What))
    ).

:- meta_predicate must(0, +).

unique(Keys, What) :-
    sort(Keys, Sorted),
    same_length(Keys, Sorted)
    ->  true
    ;   throw(wrong(twice(What, Keys))).

number_of(Text, Number) :-
    must(catch(number_string(Number, Text), _, fail), no_number(Text)).

words(Text, Words) :-
    split_string(Text, " \n", " \n", Words0),
    exclude(==(""), Words0, Words).

near(A, B, Least) :-
    abs(A-B) =< Least.
