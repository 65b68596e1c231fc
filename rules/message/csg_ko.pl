:- encoding(utf8).
:- module(sg_csg_ko,
          [ csg_ko//1                   % +What
          ]).
:- use_module('../csg/csg_term',
              [near_operands/2, operation_form/2, operation_names/1]).
:- use_module('../limits', [limit_value/2]).
:- use_module(message_parts, [meant_ko//1]).
:- use_module(primitive_en, [primitive_names//0]).
:- use_module(primitive_ko, [misshapen_ko//1]).
:- use_module('../csg/operand_name', [operand_name_ko//1]).
/** <module> What is wrong with a CSG tree, in Korean.

The heads are those of csg_en.pl (tests/rules/csg/csg_faults.plt).
*/

%!  csg_ko(+What)// is det.
%
%   The message for model_error(csg(What)).

csg_ko(no_list(Name, Operands)) -->
    { operation_form(Name, Form) },
    [ '~w의 피연산자는 리스트여야 합니다: ~p'-[Name, Operands], nl,
      '  이렇게 쓰십시오: ~w'-[Form] ].
csg_ko(no_operands(Name)) -->
    [ '~w에 피연산자가 없습니다'-[Name], nl,
      '  세그먼트 번호, 기본 입체, 연산을 하나 이상 주십시오.' ].
csg_ko(unknown(Operand)) -->
    misshapen_ko(Operand),
    !,
    [ nl,
      '  피연산자는 세그먼트 번호, 기본 입체, 연산입니다.' ].
csg_ko(unknown(Operand)) -->
    { operation_names(Names) },
    [ '~p: 피연산자가 아닙니다'-[Operand] ],
    { near_operands(Operand, Near) },
    meant_ko(Near),
    [ nl,
      '  피연산자는 세그먼트 번호, 연산(~w), 기본 입체입니다:'-[Names] ],
    primitive_names.
csg_ko(side(Side, Sides)) -->
    { atomic_list_concat(Sides, ', ', Text) },
    [ '여기서 나눈 쪽은 ~w 가운데 하나여야 합니다: ~p'-[Text, Side], nl,
      '  평면과 열린 곡면에는 below와 above, 입체에는 inside와 outside가 \c
       있습니다.' ].
csg_ko(plane(By)) -->
    [ '~p: 평면이 아닙니다'-[By], nl,
      '  A*X + B*Y + C*Z + D = 0을 plane(A, B, C, D)로 쓰십시오. A, B, C가 \c
       모두 0일 수는 없습니다.' ].
csg_ko(missing(S, Child)) -->
    operand_name_ko(S),
    [ '의 피연산자 ~d이(가) 없습니다'-[Child], nl,
      '  세그먼트 ~d을(를) 추가하거나 번호를 고치십시오.'-[Child] ].
csg_ko(cycle(Path)) -->
    { atomic_list_concat(Path, ' -> ', Text) },
    [ '세그먼트가 자기 자신의 피연산자입니다: ~w'-[Text], nl,
      '  이 가운데 하나를 앞 세그먼트의 피연산자에서 빼십시오.' ].
csg_ko(too_many(S, Leaves)) -->
    { limit_value(nodes, Most) },
    operand_name_ko(S),
    [ '은(는) 리프 ~D개로 이루어지게 됩니다'-[Leaves], nl,
      '  ~D개까지입니다. 피연산자를 덜 쓰거나 --limits nodes=N.'-[Most] ].
csg_ko(no_front(S)) -->
    operand_name_ko(S),
    [ '은(는) 사방을 향하므로 입체를 나눌 수 없습니다', nl,
      '  전체로 보아 앞이 있는 곡면을 주십시오.' ].
csg_ko(not_through(S)) -->
    [ '열린 곡면인 ' ],
    operand_name_ko(S),
    [ '이(가) 입체를 끝까지 가르지 않습니다', nl,
      '  그 경계와 경계의 바로 뒤쪽은 입체 밖에 있어야 합니다.' ].
csg_ko(curve(S, Child)) -->
    operand_ko(S, Child),
    [ '은(는) 입체가 아니라 곡선입니다', nl,
      '  연산은 입체에 합니다. 곡선이 지나는 곳은 penetrate가 보여 줍니다.' ].
csg_ko(cells(S, Child, Name)) -->
    operand_ko(S, Child),
    [ '은(는) 세포 모델입니다. ~w에는 입체가 있어야 합니다'-[Name], nl,
      '  그 부분들을 주십시오. 붙인 것은 다시 붙이거나 집합 연산(불 연산)을 할 수 있습니다.' ].
csg_ko(placed(S)) -->
    operand_name_ko(S),
    [ '은(는) 붙인 것인데 다른 자리에 놓였습니다', nl,
      '  붙일 것을 놓으십시오: glue([at(Steps, Operand), ...]).' ].
csg_ko(surface(S, Child, Name)) -->
    operand_ko(S, Child),
    [ '은(는) 열린 곡면입니다. ~w에는 안과 밖이 있어야 합니다'-[Name], nl,
      '  열린 곡면은 union, join을 하거나 입체를 나눌 수 있습니다. 닫거나 \c
       입체를 주십시오.' ].

operand_ko(S, Child) -->
    { integer(Child) },
    !,
    operand_name_ko(S),
    [ '의 피연산자 ~d'-[Child] ].
operand_ko(_, Child) -->
    operand_name_ko(Child).
