:- encoding(utf8).
:- module(test_said, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(readutil)).
:- use_module(unsaid, [unsaid/2]).

/* Every text of the English tables of messages stands in a transcript
   (tests/transcripts), where a command said it; but for those of unsaid/2. So a
   new message must be said by a command before it is right. */

%   text_of(-Table, -Head, -Texts): a clause of a table, with the constant parts
%   of what it says that are long enough to be known again.

text_of(Table, Head, Texts) :-
    expand_file_name('rules/message/*_en.pl', Files0),
    member(File, ['rules/message/messages.pl'|Files0]),
    read_file_to_terms(File, Clauses, [module(test_said)]),
    file_base_name(File, Base),
    file_name_extension(Table, _, Base),
    member((Head --> Body), Clauses),
    findall(Text, ( sub_term(Word, Body), atomic(Word), \+ number(Word),
                    constant_part(Word, Text) ),
            Texts),
    Texts \== [].

sub_term(Term, Term) :-
    nonvar(Term).
sub_term(Inner, Term) :-
    compound(Term),
    Term \= {_},                        % no words, but how they are made
    arg(_, Term, Term1),
    sub_term(Inner, Term1).

constant_part(Word, Part) :-
    split_string(Word, "~", "", [First|Rest0]),
    maplist(without_directive, Rest0, Rest),
    member(Part0, [First|Rest]),
    string_codes(Part0, Codes0),
    without_digits(Codes0, Codes),
    string_codes(Part, Codes),
    string_length(Part, Length),
    Length >= 10.

%   without_directive(Text0, Text): what stands behind "~" without digits and
%   the letter.

without_directive(Text0, Text) :-
    string_codes(Text0, Codes0),
    dropwhile_digits(Codes0, Codes),
    (   Codes = [_|Behind]
    ->  true
    ;   Behind = []
    ),
    string_codes(Text, Behind).

dropwhile_digits([D|Codes0], Codes) :-
    code_type(D, digit),
    !,
    dropwhile_digits(Codes0, Codes).
dropwhile_digits(Codes, Codes).

%   transcripts(-Text): what was said, each line once, numbers as 0.

transcripts(Text) :-
    expand_file_name('tests/transcripts/*.txt', Files),
    findall(Line,
            ( member(File, Files),
              read_file_to_string(File, Text0, [encoding(utf8)]),
              split_string(Text0, "\n", "", Lines),
              member(Line0, Lines),
              \+ sub_string(Line0, 0, _, _, "  $"),
              string_codes(Line0, Codes0),
              without_digits(Codes0, Codes),
              string_codes(Line, Codes) ),
            All),
    sort(All, Unique),
    atomic_list_concat(Unique, '\n', Text).

without_digits([], []).
without_digits([C|Cs0], Cs) :-
    (   digit(C)
    ->  Cs = [0'0|Rest],
        behind_digits(Cs0, Cs1),
        without_digits(Cs1, Rest)
    ;   Cs = [C|Rest],
        without_digits(Cs0, Rest)
    ).

behind_digits([C|Cs0], Cs) :-
    digit(C),
    !,
    behind_digits(Cs0, Cs).
behind_digits(Cs, Cs).

digit(C) :-
    (   0'0 =< C, C =< 0'9
    ->  true
    ;   C =:= 0'.
    ).

said(Text, Texts) :-
    member(Part, Texts),
    sub_string(Text, _, _, _, Part),
    !.

not_said(Pairs) :-
    transcripts(Text),
    findall(Table-Head,
            ( text_of(Table, Head, Texts),
              \+ said(Text, Texts) ),
            Pairs).

:- begin_tests(said).

test(all) :-
    not_said(Pairs),
    forall(( member(Table-Head, Pairs),
             \+ ( unsaid(Table, Known), Known =@= Head ) ),
           ( numbervars(Head, 0, _, [singletons(true)]),
             format(user_error, '~q has no transcript that says ~q~n',
                    [Table,Head]) )),
    forall(( unsaid(Table, Known),
             \+ ( member(Table-Head, Pairs), Head =@= Known ) ),
           ( numbervars(Known, 0, _, [singletons(true)]),
             format(user_error, '~q of ~q is said now: no unsaid/2~n',
                    [Known,Table]) )),
    findall(Table-Head, ( unsaid(Table, Head) ), Knowns),
    length(Pairs, N),
    length(Knowns, N).

:- end_tests(said).
