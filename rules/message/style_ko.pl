:- encoding(utf8).
:- module(sg_style_ko,
          [ style_ko//1                 % +What
          ]).
:- use_module('../colour', [colour_name/2]).
:- use_module('../drawing/style', [line_type/3, style_role/1]).
/** <module> What is wrong with a style file, in Korean.

The heads are those of style_en.pl (tests/rules/drawing/style.plt).
*/

%!  style_ko(+What)// is det.
%
%   The message for model_error(style(What)).

style_ko(fact(Name, Arity)) -->
    [ '모양 파일에 ~w/~w 사실은 없습니다'-[Name, Arity], nl,
      '  line(보임, 구실, 세그먼트, 속성) 또는 paper(색)으로 쓰십시오.' ].
style_ko(visibility(_)) -->
    [ '선의 보임은 visible, hidden, any 가운데 하나입니다' ].
style_ko(role(_)) -->
    { findall(Role, style_role(Role), Roles),
      atomic_list_concat(Roles, ', ', All)
    },
    [ '선의 구실은 any 이거나 다음 가운데 하나입니다', nl,
      '  ~w.'-[All] ].
style_ko(segment(_)) -->
    [ '세그먼트는 번호, 이름, any 가운데 하나입니다' ].
style_ko(property(Property)) -->
    { findall(Type, line_type(Type, 1, _), Types),
      atomic_list_concat(Types, ', ', All)
    },
    [ '~p 은(는) 선의 속성이 아닙니다'-[Property], nl,
      '  width(Mm), colour(C), colour(화면, 인쇄), dashes(D), pen(N), \c
       layer(이름), none, shown 으로 쓰십시오.', nl,
      '  N 은 1에서 255까지, 이름은 a-z, A-Z, 0-9, $, -, _ 로 31자까지입니다.', nl,
      '  dashes 는 solid, mm 로 쓴 [선, 틈, ...], 또는 ~w 입니다.'-[All] ].
style_ko(properties(_)) -->
    [ '속성은 [width(0.5), colour(blue)] 처럼 목록으로 씁니다' ].
style_ko(colour(_)) -->
    { findall(Name, colour_name(Name, _), Names),
      atomic_list_concat(Names, ', ', All)
    },
    [ '색은 0에서 255까지의 수로 쓴 rgb(R, G, B) 이거나 다음 가운데 \c
       하나입니다', nl,
      '  ~w.'-[All] ].
