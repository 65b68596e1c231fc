:- encoding(utf8).
/* Korean for what options take: rules/message/usage_word.pl. */
:- module(test_usage_word, []).
:- use_module(library(plunit)).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(rules(command/usage)).
:- use_module(rules(message/usage_word)).

:- begin_tests(usage_word).

test(words, forall(member(Form-Korean, [ 'NAME=VALUE'-'이름=값',
                                         'FILE.csv'-'파일.csv',
                                         'N:M'-'N:M', ''-'' ]))) :-
    form_ko(Form, Found),
    assertion(Found == Korean).

% No option of any verb has an English word left.
test(all, English == []) :-
    findall(Form,
            ( verb(Verb, _, _, _),
              verb_options(Verb, Specs),
              member(option(_, _, _, Form, _), Specs),
              form_ko(Form, Korean),
              atom_chars(Korean, Chars),
              append(_, [A,B|_], Chars),
              char_type(A, upper), char_type(B, upper) ),
            English0),
    sort(English0, English).

:- end_tests(usage_word).
