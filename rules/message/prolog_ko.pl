:- encoding(utf8).
:- module(sg_prolog_ko,
          [ prolog_ko//2,               % +Formal, +Context
            korean_syntax//1                % +What
          ]).
:- use_module(message_parts,
              [ endless_goal/2, near_predicates/3, number_fault/3, meant_ko//1,
                syntax_words//1 ]).
/** <module> Errors of Prolog that people meet, in Korean.

prolog_en.pl has the same heads in English.
*/

%!  prolog_ko(+Formal, +Context)// is semidet.
%
%   The message for error(Formal, Context).

prolog_ko(resource_error(nesting_of_terms), _) -->
    [ '항이 너무 깊게 겹쳐 있어 세계에 둘 수 없습니다' ].
prolog_ko(resource_error(What), Context) -->
    { What \== nesting_of_terms,
      endless_goal(Context, Goal)
    },
    !,
    [ '~p: 끝없이 자기 자신을 부릅니다. Prolog의 스택이 찼습니다'-[Goal] ].
prolog_ko(resource_error(What), _) -->
    { What \== nesting_of_terms },
    [ '메모리가 모자랍니다. Prolog의 스택이 찼습니다', nl,
      '  한 번에 더 적게 물으십시오: 더 작은 모델, 답을 모두 모으지 않는 목표.' ].
prolog_ko(io_error(Action, _), context(_, Why)) -->
    [ '파일이나 스트림에 잘못이 있습니다: ~w (~w)'-[Action, Why], nl,
      '  디스크와, 쓴 것을 읽는 쪽을 확인하십시오.' ].
prolog_ko(existence_error(procedure, PI), _) -->
    { near_predicates(PI, Plain, Near) },
    [ '~q: 없는 술어입니다'-[Plain] ],
    meant_ko(Near),
    [ nl, '  help. 라고 물으면 있는 것을 모두 볼 수 있습니다.' ].
prolog_ko(existence_error(Kind, What), _) -->
    { Kind \== procedure },
    [ '~w ~p: 없습니다'-[Kind, What] ].
prolog_ko(instantiation_error, _) -->
    [ '변수의 값이 아직 없습니다. 부르기 전에 값이 있어야 합니다' ].
prolog_ko(type_error(evaluable, What), _) -->
    [ '~p은(는) 계산할 수 있는 식이 아닙니다'-[What] ].
prolog_ko(type_error(Type, What), _) -->
    { Type \== evaluable },
    [ '~p: 형이 맞지 않습니다. 있어야 할 것: ~w'-[What, Type] ].
prolog_ko(domain_error(Domain, What), _) -->
    [ '~p: 쓸 수 있는 값이 아닙니다 (~w)'-[What, Domain] ].
prolog_ko(representation_error(What), _) -->
    [ '담을 수 없습니다: ~w'-[What] ].
prolog_ko(evaluation_error(What), _) -->
    { number_fault(What, _, Words) },
    !,
    [ '계산할 수 없습니다: ~w'-[Words] ].
prolog_ko(evaluation_error(What), _) -->
    [ '계산할 수 없습니다: ~w'-[What] ].
prolog_ko(permission_error(Action, Kind, What), _) -->
    [ '허락되지 않습니다: ~w ~w ~p'-[Action, Kind, What] ].
prolog_ko(syntax_error(What), _) -->
    [ 'Prolog 문법에 맞지 않습니다: ' ],
    korean_syntax(What).
prolog_ko(timeout_error(Action, _), _) -->
    [ '시간이 너무 오래 걸렸습니다: ~w'-[Action] ].
prolog_ko(thrown(Ball), _) -->
    [ '~p: 처리되지 않은 예외입니다'-[Ball] ].
prolog_ko(warning(once(Names)), _) -->
    [ '한 번만 나오는 변수: ~w'-[Names], nl,
      '  값이 쓰이지 않으면 _ 로 쓰십시오.' ].
prolog_ko(warning(often(Names)), _) -->
    [ '이름이 _ 로 시작하는데 여러 번 나오는 변수: ~w'-[Names] ].
prolog_ko(warning(branch(Name)), _) -->
    [ '한 갈래에서만 쓰이는 변수: ~w'-[Name] ].
prolog_ko(warning(always_same(Compared)), _) -->
    [ '결과가 늘 같은 검사: ~p'-[Compared] ].
prolog_ko(warning(apart(PI)), _) -->
    [ '~p의 절들이 떨어져 있습니다'-[PI], nl,
      '  모으거나 :- discontiguous ~p. 를 쓰십시오.'-[PI] ].
prolog_ko(warning(failed(Goal)), _) -->
    [ '이 지시문이 실패했습니다: ~p'-[Goal] ].

%!  korean_syntax(+What)// is det.
%
%   What is wrong with a text that Prolog cannot read, as syntax_words//1.

korean_syntax(What) -->
    { korean_syntax_word(What, Words) },
    !,
    [ '~w'-[Words] ].
korean_syntax(What) -->
    syntax_words(What).

korean_syntax_word(float_overflow, '수가 너무 큽니다').
korean_syntax_word(end_of_clause, '마침표가 너무 일찍 나옵니다').
korean_syntax_word(end_of_clause_expected, '마침표가 올 자리입니다').
korean_syntax_word(end_of_file, '글이 도중에 끝납니다').
korean_syntax_word(end_of_file_in_block_comment, '주석 /* ... */ 도중에 글이 끝납니다').
korean_syntax_word(end_of_file_in_quoted(_), '따옴표가 닫히지 않고 글이 끝납니다').
korean_syntax_word(illegal_number, '수를 잘못 썼습니다').
korean_syntax_word(operator_clash, '연산자의 우선순위가 맞지 않습니다').
korean_syntax_word(operator_expected, '연산자가 올 자리입니다').
korean_syntax_word(operator_balance, '연산자의 짝이 맞지 않습니다').
korean_syntax_word(quoted_punctuation, '쉼표나 막대 대신 항이 올 자리입니다').
korean_syntax_word(list_rest, '리스트의 나머지에 쉼표나 막대가 또 있습니다').
korean_syntax_word(cannot_start_term, '항이 이렇게 시작할 수 없습니다').
korean_syntax_word(punct(_, _), '구두점이나 괄호가 잘못되었습니다').
korean_syntax_word(undefined_char_escape(_), '따옴표 안에 모르는 \\ 문자가 있습니다').
korean_syntax_word(void_not_allowed, '빈 인수 "()"은 쓸 수 없습니다').
