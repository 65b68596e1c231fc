:- encoding(utf8).
:- module(sg_problem_ko,
          [ problem_ko//1               % +What
          ]).
/** <module> What is wrong with a file of problems, in Korean.
*/

%!  problem_ko(+What)// is det.
%
%   The message for model_error(problem(What)).

problem_ko(fact(Name, Arity)) -->
    [ '문제 파일에는 ~w/~w 사실이 없습니다'-[Name, Arity], nl,
      '  problem(Name, Model, Items), variant(Name, Parameter, Values), \c
       sheet(Paper, Names, Items)를 쓰십시오.' ].
problem_ko(variable) -->
    [ '변수가 있습니다. 문제 파일의 사실은 데이터입니다', nl,
      '  이름은 소문자로 시작하거나 따옴표로 묶으십시오.' ].
problem_ko(item(Item)) -->
    [ '여기에 쓸 수 없는 항목: ~p'-[Item], nl,
      '  문제에는 given(Views), branch(S), generators(N), \c
       ask(draw(penetration)), ask(count(loops)), ask(develop(S)),', nl,
      '  text(Language, Text), 용지에는 angle(first), angle(third), \c
       title_block(Item, Text)를 쓸 수 있습니다.' ].
problem_ko(model(Model)) -->
    [ '모델 파일의 이름이 아닙니다: ~p'-[Model], nl,
      '  따옴표로 묶어 쓰십시오. 문제 파일과 같은 폴더에 있어야 합니다.' ].
problem_ko(paper(Paper)) -->
    [ '그런 용지는 없습니다: ~p'-[Paper], nl,
      '  A4부터 A0까지 따옴표로 묶어 쓰십시오. 보기: \'A3\'.' ].
problem_ko(values(Values)) -->
    [ '매개변수 값의 리스트가 아닙니다: ~p'-[Values], nl,
      '  variant(Name, Parameter, [20, 25, 30])처럼 쓰십시오.' ].
problem_ko(twice(Name)) -->
    [ '이름이 같은 문제가 둘 있습니다: ~p'-[Name], nl,
      '  하나의 이름을 바꾸십시오.' ].
problem_ko(no_problem(Name)) -->
    [ '그런 문제는 없습니다: ~p'-[Name], nl,
      '  problem(Name, Model, Items)의 이름을 쓰십시오.' ].
problem_ko(no_sheet(Name)) -->
    [ '용지에 없는 문제: ~p'-[Name], nl,
      '  sheet(Paper, Names, Items)에 이름을 쓰십시오.' ].
