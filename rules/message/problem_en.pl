:- module(sg_problem_en,
          [ problem_en//1               % +What
          ]).
/** <module> What is wrong with a file of problems, in English.

problem_ko.pl has the same heads in Korean (tests/rules/problem/).
*/

%!  problem_en(+What)// is det.
%
%   The message for model_error(problem(What)).

problem_en(fact(Name, Arity)) -->
    [ 'a file of problems has no facts ~w/~w'-[Name, Arity], nl,
      '  Write problem(Name, Model, Items), variant(Name, Parameter, Values) \c
       and sheet(Paper, Names, Items).' ].
problem_en(variable) -->
    [ 'this has a variable: facts of problems are data', nl,
      '  Begin names with a small letter, or quote them.' ].
problem_en(item(Item)) -->
    [ '~p is no item here'-[Item], nl,
      '  A problem has given(Views), branch(S), generators(N), \c
       ask(draw(penetration)), ask(count(loops)), ask(develop(S)),', nl,
      '  text(Language, Text); a sheet angle(first), angle(third), \c
       title_block(Item, Text).' ].
problem_en(model(Model)) -->
    [ '~p is no name of a model file'-[Model], nl,
      '  Write it in quotes: it lies beside the file of problems.' ].
problem_en(paper(Paper)) -->
    [ '~p is no paper'-[Paper], nl,
      '  Write A4 to A0 in quotes, such as \'A3\'.' ].
problem_en(values(Values)) -->
    [ '~p is no list of values of a parameter'-[Values], nl,
      '  Write variant(Name, Parameter, [20, 25, 30]).' ].
problem_en(twice(Name)) -->
    [ 'there are two problems ~p'-[Name], nl,
      '  Give one of them another name.' ].
problem_en(no_problem(Name)) -->
    [ 'there is no problem ~p'-[Name], nl,
      '  Names are those of problem(Name, Model, Items).' ].
problem_en(no_sheet(Name)) -->
    [ 'problem ~p stands on no sheet'-[Name], nl,
      '  Name it in sheet(Paper, Names, Items).' ].
