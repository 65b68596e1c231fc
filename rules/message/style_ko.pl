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
      '  line(보임, 역할, 세그먼트, 속성) 또는 paper(색)으로 쓰십시오.' ].
style_ko(visibility(_)) -->
    [ '선의 보임은 visible, hidden, any 가운데 하나입니다' ].
style_ko(role(_)) -->
    { findall(Role, style_role(Role), Roles),
      atomic_list_concat(Roles, ', ', All)
    },
    [ '선의 역할은 any 이거나 다음 가운데 하나입니다', nl,
      '  ~w.'-[All] ].
style_ko(segment(_)) -->
    [ '세그먼트는 번호, 이름, any 가운데 하나입니다' ].
style_ko(property(Property)) -->
    { findall(Type, line_type(Type, 1, _), Types),
      atomic_list_concat(Types, ', ', All)
    },
    [ '~p: 선의 속성이 아닙니다'-[Property], nl,
      '  width(Mm), colour(C), colour(화면, 인쇄), dashes(D), pen(N), \c
       layer(이름), none, shown을 쓰십시오.', nl,
      '  N은 1에서 255까지, 이름은 a-z, A-Z, 0-9, $, -, _ 로 31자까지입니다.', nl,
      '  dashes는 solid, mm로 쓴 [선, 틈, ...], 또는 ~w입니다.'-[All] ].
style_ko(properties(_)) -->
    [ '속성은 [width(0.5), colour(blue)]처럼 리스트로 씁니다' ].
style_ko(line_style(Style)) -->
    [ '~p: 선의 모양이 아닙니다'-[Style], nl,
      '  line_style/4의 답은 none 또는 style(너비, 색, 파선, 펜, 레이어)이며, \c
       스타일 파일과 같습니다: 0보다 큰 너비(mm),', nl,
      '  색 또는 colour(화면, 인쇄), 파선, 1부터 255까지의 펜, 레이어 이름.' ].
style_ko(colour(Colour)) -->
    { findall(Name, colour_name(Name, _), Names),
      atomic_list_concat(Names, ', ', All)
    },
    [ '~p: 색이 아닙니다'-[Colour], nl,
      '  0부터 255까지의 수로 쓴 rgb(R, G, B) 또는 다음 가운데 하나를 쓰십시오.',
      nl,
      '  ~w.'-[All] ].
