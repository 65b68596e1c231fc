:- module(sg_explain_parameter_en,
          [ parameter_statement_en//1   % +Statement
          ]).
:- use_module(explain_words, [segment_word/2]).
/** <module> Explanations of parameters in English; explain_parameter_ko.pl has
them in Korean.
*/

%!  parameter_statement_en(+Statement)// is semidet.
%
%   A statement of explain_parameter.pl in English.

parameter_statement_en(parameter(Name, Value)) -->
    [ 'parameter ~w = ~w'-[Name, Value] ].
parameter_statement_en(parameter_text(English, Korean)) -->
    { English == none -> Text = Korean ; Text = English },
    [ '~w'-[Text] ].
parameter_statement_en(parameter_formula(Formula)) -->
    [ 'it is ~p'-[Formula] ].
parameter_statement_en(parameter_set(Default)) -->
    [ 'it was set (--set, set_parameter); its default is ~p'-[Default] ].
parameter_statement_en(parameter_range(Least, Most, Step)) -->
    [ 'its range:' ],
    end_en(Least, 'from'),
    end_en(Most, 'to'),
    end_en(Step, 'in steps of').
parameter_statement_en(parameter_unused) -->
    [ 'nothing is made from it' ].
parameter_statement_en(used_by_parameter(Name, Formula)) -->
    [ 'parameter ~w is ~p'-[Name, Formula] ].
parameter_statement_en(used_by_row(Fact)) -->
    [ 'it is in ~p'-[Fact] ].
parameter_statement_en(segment(S, Kind)) -->
    { segment_word(S, Word) },
    [ 'segment ~d~w is a ~w'-[S, Word, Kind] ].
parameter_statement_en(no_size_from_parameter) -->
    [ 'none of its sizes comes from a parameter' ].
parameter_statement_en(vertex_place(S, V, Place)) -->
    [ 'vertex ~d of segment ~d is at ~p'-[V, S, Place] ].
parameter_statement_en(size(Value, Formula)) -->
    (   { Value =.. [Name, Number],
          number(Number),
          Formula =.. [Name, Of] }
    ->  [ '~w is ~p, ~w'-[Name, Of, Number] ]
    ;   [ '~p is ~p'-[Formula, Value] ]
    ).

end_en(none, _) -->
    !.
end_en(Number, Word) -->
    [ ' ~w ~w'-[Word, Number] ].
