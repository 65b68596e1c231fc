:- encoding(utf8).
:- module(sg_language,
          [ interrupted_word/2,         % +Language, -Word
            language/1,                 % ?Language
            language_of_environment/0,
            result_language/1,          % -Language
            with_result_language/2      % +Language, :Goal
          ]).
:- use_module(environment, [environment/2]).
:- use_module(library(lists), [member/2]).
/** <module> The language that people are spoken to in.

Messages go through prolog:message//2, which has its own ways. This is for the
text that the program prints as its result: usage and reports.
*/

%!  language(?Language) is semidet.
%
%   Language is `ko` when the flag message_language says Korean, else `en`.

language(Language) :-
    current_prolog_flag(message_language, Flag),
    (   sub_atom(Flag, 0, _, _, ko)
    ->  Language0 = ko
    ;   Language0 = en
    ),
    Language = Language0.

%!  language_of_environment is det.
%
%   Messages and reports are in the language that the environment says: of
%   LC_ALL, LC_MESSAGES and LANG the first that says something.

language_of_environment :-
    (   member(Variable, ['LC_ALL', 'LC_MESSAGES', 'LANG']),
        environment(Variable, Value)
    ->  atomic_list_concat([Language|_], '.', Value)
    ;   Language = en
    ),
    (   memberchk(Language, ['C', 'POSIX'])
    ->  set_prolog_flag(message_language, en)
    ;   set_prolog_flag(message_language, Language)
    ).

%!  interrupted_word(+Language, -Word) is det.
%
%   Word is what is said of an interrupt. engine/signals.c has it from the
%   start, so it needs no other message.

interrupted_word(en, interrupted).
interrupted_word(ko, '중단되었습니다').

:- meta_predicate with_result_language(+, 0).

:- thread_local
    of_results/1.

%!  with_result_language(+Language, :Goal) is semidet.
%!  result_language(-Language) is det.
%
%   Call Goal once; meanwhile what is drawn on sheets for others is in Language.
%   Else that is the language of people.

with_result_language(Language, Goal) :-
    setup_call_cleanup(asserta(of_results(Language), Ref), once(Goal),
                       erase(Ref)).

result_language(Language) :-
    (   of_results(Language0)
    ->  Language = Language0
    ;   language(Language)
    ).
