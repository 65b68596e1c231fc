:- encoding(utf8).
:- module(sg_explain_parameter_ko,
          [ parameter_statement_ko//1   % +Statement
          ]).
:- use_module(true_ko, [segment_kind_word/2]).
:- use_module(explain_words, [segment_word_ko/2]).
/** <module> Explanations of parameters in Korean; explain_parameter_en.pl has
them in English.
*/

%!  parameter_statement_ko(+Statement)// is semidet.
%
%   A statement of explain_parameter.pl in Korean.

parameter_statement_ko(parameter(Name, Value)) -->
    [ '매개변수 ~w = ~w'-[Name, Value] ].
parameter_statement_ko(parameter_text(English, Korean)) -->
    { Korean == none -> Text = English ; Text = Korean },
    [ '~w'-[Text] ].
parameter_statement_ko(parameter_formula(Formula)) -->
    [ '식: ~p'-[Formula] ].
parameter_statement_ko(parameter_set(Default)) -->
    [ '주어진 값이다 (--set, set_parameter). 기본값: ~p'-[Default] ].
parameter_statement_ko(parameter_range(Least, Most, Step)) -->
    [ '범위:' ],
    end_ko(Least, '부터'),
    end_ko(Most, '까지'),
    end_ko(Step, ' 간격').
parameter_statement_ko(parameter_unused) -->
    [ '이것으로 만든 것이 없다' ].
parameter_statement_ko(used_by_parameter(Name, Formula)) -->
    [ '매개변수 ~w의 식: ~p'-[Name, Formula] ].
parameter_statement_ko(used_by_row(Fact)) -->
    [ '이것이 있는 곳: ~p'-[Fact] ].
parameter_statement_ko(segment(S, Kind)) -->
    { segment_word_ko(S, Word),
      segment_kind_word(Kind, Korean) },
    [ '세그먼트 ~d~w: ~w'-[S, Word, Korean] ].
parameter_statement_ko(no_size_from_parameter) -->
    [ '매개변수로 정한 치수가 없다' ].
parameter_statement_ko(vertex_place(S, V, Place)) -->
    [ '세그먼트 ~d의 꼭짓점 ~d의 위치: ~p'-[S, V, Place] ].
parameter_statement_ko(size(Value, Formula)) -->
    (   { Value =.. [Name, Number],
          number(Number),
          Formula =.. [Name, Of] }
    ->  [ '~w = ~p, ~w'-[Name, Of, Number] ]
    ;   [ '~p = ~p'-[Formula, Value] ]
    ).

end_ko(none, _) -->
    !.
end_ko(Number, Word) -->
    [ ' ~w~w'-[Number, Word] ].
