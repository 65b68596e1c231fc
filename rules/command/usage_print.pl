:- module(sg_usage_print,
          [ print_usage/1,              % +Language
            print_usage/2               % +Verb, +Language
          ]).
:- encoding(utf8).
:- use_module('../message/usage_word', [form_ko/2]).
:- use_module(usage, [verb/4, verb_options/2, example/2]).
:- use_module(usage_ko, [option_ko/2, verb_option_ko/3]).
:- use_module(usage_render, [render_option_ko/2]).
:- use_module(usage_unfold, [wish_option/1, unfold_option_ko/2]).
:- use_module(library(lists), [member/2]).
/** <module> The text of --help, in English and in Korean.
*/

%!  print_usage(+Language) is det.
%!  print_usage(+Verb, +Language) is det.
%
%   The text of --help on standard output; Language is `en` or `ko`.

print_usage(Language) :-
    heading(Language, what, What),
    heading(Language, usage, Usage),
    in_words(Language, 'VERB [OPTION...] MODEL...', Form),
    format("~w~n~n~w  sanggwan ~w~n", [What, Usage, Form]),
    format("        sanggwan --help | --version~n~n"),
    forall(verb(Verb, _, Summary, SummaryKo),
           ( in_language(Language, Summary, SummaryKo, Text),
             format("  ~w~t~16|~w~n", [Verb, Text]) )),
    heading(Language, more, More),
    format("~n~w~n", [More]).

print_usage(Verb, Language) :-
    verb(Verb, Arguments, Summary, SummaryKo),
    in_language(Language, Summary, SummaryKo, Text),
    heading(Language, usage, Usage),
    heading(Language, options, Options),
    heading(Language, examples, Examples),
    format("sanggwan ~w: ~w~n~n", [Verb, Text]),
    atom_concat('[OPTION...] ', Arguments, Form0),
    in_words(Language, Form0, Form),
    format("~w  sanggwan ~w ~w~n~n~w~n", [Usage, Verb, Form, Options]),
    verb_options(Verb, Specs),
    forall(member(Spec, Specs), print_option(Language, Verb, Spec)),
    format("~n~w~n", [Examples]),
    forall(example(Verb, Command), format("  ~w~n", [Command])).

print_option(Language, Verb, option(Name, Short, _, Meta, Help)) :-
    (   Short == ''
    ->  Letter = '    '
    ;   format(atom(Letter), '-~w, ', [Short])
    ),
    (   Meta == ''
    ->  Value = ''
    ;   Value = '='
    ),
    (   Language == ko,
        help_ko(Verb, Name, HelpKo)
    ->  form_ko(HelpKo, Text)
    ;   Text = Help
    ),
    in_words(Language, Meta, Form),
    format("  ~w--~w~w~w ~t~28|~w~n", [Letter, Name, Value, Form, Text]).

%   in_words(Language, Form0, Form): what stands for a word, in Language.

in_words(ko, Form0, Form) :-
    !,
    form_ko(Form0, Form).
in_words(_, Form, Form).

%   help_ko(Verb, Name, Help): where verbs share an option, what it says is that
%   of the table which the verb has it from.

help_ko(Verb, Name, Help) :-
    verb_option_ko(Verb, Name, Help),
    !.
help_ko(Verb, Name, Help) :-
    ( memberchk(Verb, [unfold,convert])
    ; Verb == explain, wish_option(option(Name, _, _, _, _)) ),
    unfold_option_ko(Name, Help),
    !.
help_ko(Verb, Name, Help) :-
    memberchk(Verb, [render,explain]),
    render_option_ko(Name, Help),
    !.
help_ko(_, Name, Help) :-
    option_ko(Name, Help),
    !.

in_language(ko, _, Text, Text) :-
    !.
in_language(_, Text, _, Text).

heading(ko, Key, Text) :-
    heading_ko(Key, Text),
    !.
heading(_, Key, Text) :-
    heading_en(Key, Text).

heading_en(what, 'Sanggwan: penetration lines, hidden lines, and models as \c
relations.').
heading_en(usage, 'Usage:').
heading_en(options, 'Options:').
heading_en(examples, 'Examples:').
heading_en(more, 'sanggwan VERB --help says more, with examples.\n\c
Exit codes: 0 done; 1 the answer is no; 2 wrong usage; 3 input unreadable\n\c
or invalid; 4 geometry not possible; 5 some jobs of a batch, or some files\n\c
of --each, failed; 130 interrupted.').

heading_ko(what, '상관: 상관선, 숨은선, 그리고 관계로서의 모델.').
heading_ko(usage, '사용법:').
heading_ko(options, '옵션:').
heading_ko(examples, '보기:').
heading_ko(more, 'sanggwan 명령 --help에 자세한 설명과 보기가 있다.\n종료 코드: \c
0 끝남; 1 답이 없음; 2 잘못된 사용; 3 입력을 읽을 수 없거나 잘못됨;\n\c
4 기하 계산 불가; 5 일괄 작업이나 --each 파일 일부 실패; 130 중단됨.').
