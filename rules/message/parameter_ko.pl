:- encoding(utf8).
:- module(sg_parameter_ko,
          [ parameter_ko//1             % +What
          ]).
:- use_module(message_parts, [meant_ko//1, shown_value/2]).
/** <module> What is wrong with parameters and formulas, in Korean.

parameter_en.pl has the same heads in English.
*/

%!  parameter_ko(+What)// is det.
%
%   The message for a fault of the parameters of a model, or of what sets them.

parameter_ko(formula(What, Formula)) -->
    formula_ko(What, Formula).
parameter_ko(cycle(Names)) -->
    { atomic_list_concat(Names, ', ', Text) },
    [ '매개변수가 서로를 필요로 하여 돌고 돕니다: ~w'-[Text], nl,
      '  그 가운데 하나에 수를 주십시오.' ].
parameter_ko(renamed(File, Name, New)) -->
    [ '~w 파일의 매개변수 ~w: 다른 모델에도 있어서 여기서는 ~w(이)라고 부릅니다'-
      [File, Name, New] ].
parameter_ko(unset(Name, Near, Names)) -->
    (   { Names == [] }
    ->  [ '--set ~w: 모델에 매개변수가 없습니다'-[Name], nl,
          '  파일에 param(~w, 기본값). 을 쓰고 수가 있을 자리에 param(~w) 항을 \c
           쓰십시오.'-[Name, Name] ]
    ;   { atomic_list_concat(Names, ', ', All) },
        [ '--set ~w: 그런 매개변수를 가진 모델이 없습니다'-[Name] ],
        meant_ko(Near),
        [ nl, '  있는 것: ~w'-[All] ]
    ).
parameter_ko(set_twice(Name)) -->
    [ '매개변수의 값이 두 번 주어졌습니다: ~w'-[Name], nl,
      '  값을 하나만 주십시오.' ].
parameter_ko(setting(Text, What)) -->
    { What \= limit(_, _) },
    [ '--set ~w: '-[Text] ],
    setting_ko(What).
parameter_ko(unused(Name)) -->
    [ '--set ~w: 모델에 이 매개변수로 만든 것이 없습니다'-[Name], nl,
      '  수가 있을 자리에 param(~w) 항을 쓰십시오.'-[Name] ].
parameter_ko(range(Name, Value, Least, Most)) -->
    [ '매개변수 ~w의 값 ~w이(가) 범위를 벗어났습니다: '-[Name, Value] ],
    range_ko(Least, Most).
parameter_ko(about(What)) -->
    about_ko(What).
parameter_ko(decimal_comma(Call, Name, Point)) -->
    [ '~w(~w, ...)에 수가 둘 있습니다. 쉼표를 소수점으로 썼습니까?'-
      [Call, Name], nl,
      '  ~w(~w, ~w). 로 쓰십시오.'-[Call, Name, Point] ].

range_ko(none, Most) -->
    !,
    [ '~w 이하'-[Most] ].
range_ko(Least, none) -->
    !,
    [ '~w 이상'-[Least] ].
range_ko(Least, Most) -->
    [ '~w부터 ~w까지'-[Least, Most] ].

about_ko(no_parameter(Name, Near)) -->
    [ 'param_about(~w, ...): 파일에 그런 매개변수가 없습니다'-[Name] ],
    meant_ko(Near),
    [ nl, '  같은 파일에 param(~w, 기본값). 을 쓰십시오.'-[Name] ].
about_ko(list(Items)) -->
    { shown_value(Items, Shown) },
    [ '매개변수에 대해 말하는 것의 리스트가 아닙니다: ~p'-[Shown], nl ],
    about_ko(items).
about_ko(item(Item)) -->
    { shown_value(Item, Shown) },
    [ '매개변수에 대해 말할 수 없는 것입니다: ~p'-[Shown], nl ],
    about_ko(items).
about_ko(item_twice(Item)) -->
    [ '앞에서 이미 말한 것입니다: ~p'-[Item], nl,
      '  한 번만 쓰십시오.' ].
about_ko(order(Least, Most)) -->
    [ '~w부터 ~w까지는 아무 수도 없습니다'-[Least, Most], nl,
      '  가장 작은 값은 min(...), 가장 큰 값은 max(...)입니다.' ].

about_ko(items) -->
    [ '  보기: [min(20), max(200), step(0.5), text(ko, \'지름\')]. 간격은 0보다 \c
       크고, 언어는 en과 ko입니다.' ].

formula_ko(unknown(Name, Near), _) -->
    [ '매개변수가 없습니다: ~w'-[Name] ],
    meant_ko(Near),
    [ nl, '  같은 파일에 param(~w, 기본값). 을 쓰십시오.'-[Name] ].
formula_ko(no_number(Item), Formula) -->
    { shown_value(Item, Shown) },
    [ '수가 아닙니다: ~p (식 ~p)'-[Shown, Formula], nl ],
    (   { atom(Item), Item \== [] }
    ->  [ '  매개변수는 param(~w) 항으로 씁니다.'-[Item] ]
    ;   [ '  수, param(이름), pi, 식의 함수를 쓰십시오.' ]
    ).
formula_ko(no_function(Name, Arity, Near), Formula) -->
    [ '식에 쓸 수 없는 함수입니다: ~w/~d (식 ~p)'-[Name, Arity, Formula] ],
    meant_ko(Near),
    [ nl,
      '  쓸 수 있는 것: + - * / ** sqrt abs min max floor ceiling round sin \c
       cos tan asin acos atan atan2 (도).' ].
formula_ko(division_by_zero, Formula) -->
    [ '0으로 나눕니다: ~p'-[Formula], nl,
      '  매개변수의 값을 확인하십시오.' ].
formula_ko(not_real, Formula) -->
    [ '실수가 아닙니다: ~p'-[Formula], nl,
      '  제곱근은 0 이상의 수, asin과 acos은 -1부터 1까지의 수에 씁니다.' ].
formula_ko(too_large, Formula) -->
    [ '값이 너무 큽니다: ~p'-[Formula], nl,
      '  매개변수의 값을 확인하십시오.' ].
formula_ko(power, Formula) -->
    [ '~p: 지수는 -1000부터 1000까지의 정수이거나 0.5여야 합니다'-[Formula], nl,
      '  제곱근은 sqrt(X)입니다.' ].

setting_ko(form) -->
    [ '이름=값 꼴이어야 합니다', nl,
      '  보기: --set d=114.3' ].
setting_ko(comma(Point)) -->
    [ '소수점은 점으로 씁니다', nl,
      '  ~w(으)로 쓰십시오.'-[Point] ].
setting_ko(unit(Unit)) -->
    [ '매개변수는 단위가 없는 수입니다: ~w'-[Unit], nl,
      '  길이는 모델의 단위, 각은 도입니다.' ].
setting_ko(formula(unknown(Name, _), _)) -->
    !,
    [ 'param(~w): 수가 아닙니다. 매개변수의 값은 수입니다'-[Name], nl,
      '  114.3이나 6.625*25.4처럼 수를 쓰십시오.' ].
setting_ko(formula(What, Formula)) -->
    formula_ko(What, Formula).
setting_ko(number) -->
    [ '값이 수가 아닙니다', nl,
      '  114.3, -2.5e-3, 6.625*25.4처럼 숫자로 쓰십시오.' ].
