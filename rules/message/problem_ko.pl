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
       sheet(Paper, Names, Items),', nl,
      '  pupils(Names)를 쓰십시오.' ].
problem_ko(variable) -->
    [ '변수가 있습니다. 문제 파일의 사실은 데이터입니다', nl,
      '  이름은 소문자로 시작하거나 따옴표로 묶으십시오.' ].
problem_ko(item(Item)) -->
    [ '여기에 쓸 수 없는 항목: ~p'-[Item], nl,
      '  문제에는 given(Views), blank(View), branch(S), generators(N), \c
       planes(Axis), planes(Axis, N), edges(all),', nl,
      '  hide(penetration), show(penetration), \c
       ask(draw(penetration)), ask(draw(penetration, Views)),', nl,
      '  ask(count(loops)), ask(develop(S)), \c
       ask(measure(What, Unit, Tolerance)), \c
       part(S, Language, Text), text(Language, Text),', nl,
      '  용지에는 angle(first), angle(third), title_block(Item, Text), \c
       title_block([class, name, number, date])를 쓸 수 있습니다.' ].
problem_ko(model(Model)) -->
    [ '모델 파일의 이름이 아닙니다: ~p'-[Model], nl,
      '  따옴표로 묶어 쓰십시오. 문제 파일과 같은 폴더에 있어야 합니다.' ].
problem_ko(paper(Paper)) -->
    [ '그런 용지는 없습니다: ~p'-[Paper], nl,
      '  A4부터 A0까지 따옴표로 묶어 쓰십시오. 보기: \'A3\'.' ].
problem_ko(values(Values)) -->
    [ '매개변수 값의 리스트가 아닙니다: ~p'-[Values], nl,
      '  variant(Name, Parameter, [20, 25, 30])처럼 쓰거나, 리스트 대신 20..30, \c
       between(20, 30, 2.5)를 쓰십시오.' ].
problem_ko(seed(Seed)) -->
    [ '씨앗 수가 아닙니다: ~p'-[Seed], nl,
      '  variant(Name, Parameter in [20, 25, 30], seed(2026))처럼 정수를 \c
       쓰십시오.' ].
problem_ko(pupils(Names)) -->
    [ '학생의 리스트가 아닙니다: ~p'-[Names], nl,
      '  pupils([\'김\', \'이\'])처럼 이름을 한 번씩 쓰십시오.' ].
problem_ko(twice(Name)) -->
    [ '이름이 같은 문제가 둘 있습니다: ~p'-[Name], nl,
      '  하나의 이름을 바꾸십시오.' ].
problem_ko(no_problem(Name)) -->
    [ '그런 문제는 없습니다: ~p'-[Name], nl,
      '  problem(Name, Model, Items)의 이름을 쓰십시오.' ].
problem_ko(no_sheet(Name)) -->
    [ '용지에 없는 문제: ~p'-[Name], nl,
      '  sheet(Paper, Names, Items)에 이름을 쓰십시오.' ].
problem_ko(measure(Measure)) -->
    [ '잴 수 있는 것이 아닙니다: ~p'-[Measure], nl,
      '  shortest_generator(S), longest_generator(S), generator(S, I), \c
       edge(S, V, W), angle(S, U, V, W), area(S),', nl,
      '  perimeter(S), sector(S), volume(S), coordinate(I, x)를 쓰십시오. S는 \c
       세그먼트, U, V, W는 꼭짓점, I는 점의 번호입니다.' ].
problem_ko(unit(Measure, Unit, Units)) -->
    { atomic_list_concat(Units, ', ', Text) },
    [ '~p: 이 값에 쓸 수 없는 단위 ~p'-[Measure, Unit], nl,
      '  쓸 수 있는 단위: ~w.'-[Text] ].
problem_ko(tolerance(Measure, Tolerance)) -->
    [ '~p: 허용 오차가 아닙니다: ~p'-[Measure, Tolerance], nl,
      '  0보다 큰 수를 그 단위로 쓰십시오. 보기: 0.1.' ].
problem_ko(all_blank) -->
    [ '모든 투상도가 비어 있어 주어진 것이 없습니다', nl,
      '  given(Views)에 다른 투상도를 더하십시오.' ].
problem_ko(no_view(Measure, Names)) -->
    { atomic_list_concat(Names, ', ', Text) },
    [ '답을 드러내지 않고 점을 보일 투상도가 없습니다: ~p'-[Measure], nl,
      '  다음 투상도 가운데 하나를 비우지 말고 주십시오: ~w.'-[Text] ].
problem_ko(no_segment(S)) -->
    [ '모델에 없는 세그먼트: ~p'-[S], nl,
      '  다른 것의 피연산자가 아닌 segment(S, Kind, Term)의 번호를 쓰십시오.' ].
problem_ko(no_pattern(S)) -->
    [ '세그먼트 ~p: 곡선이므로 전개도가 없습니다'-[S], nl,
      '  ask(develop(S))에 입체나 곡면을 쓰십시오.' ].
problem_ko(no_vertex(S, V)) -->
    [ '세그먼트 ~p에 없는 꼭짓점: ~p'-[S, V], nl,
      '  꼭짓점은 sanggwan query MODEL "v(~w, V, X, Y, Z)" 명령으로 볼 수 \c
       있습니다.'-[S] ].
problem_ko(no_measure(Measure)) -->
    [ '이 모델에서는 값이 없습니다: ~p'-[Measure], nl,
      '  면소는 끝이 밖에 있는 원기둥과 원뿔의 것이고, 부채꼴은 직원뿔의 \c
       것입니다.', nl,
      '  부피는 곡면을 아는 입체의 것이고, 좌표는 상관선 위에 있는 점의 \c
       것입니다.' ].
problem_ko(too_fine(Measure, Tolerance)) -->
    [ '~p: ~p만큼 정확하게는 알 수 없습니다'-[Measure, Tolerance], nl,
      '  허용 오차를 더 크게 쓰십시오.' ].
problem_ko(not_given(Name, Names)) -->
    { atomic_list_concat(Names, ', ', Text) },
    [ '상관선을 그릴 투상도 ~p: 문제에 없는 투상도입니다'-[Name], nl,
      '  given(Views)와 blank(View)의 투상도: ~w.'-[Text] ].
problem_ko(shown_and_asked) -->
    [ '문제에 상관선이 나와 있으므로 숨기거나 그리라고 할 수 없습니다', nl,
      '  show(penetration)을 빼거나, ask(draw(...))와 hide(penetration)을 \c
       빼십시오.' ].
