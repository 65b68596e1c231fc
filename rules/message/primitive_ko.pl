:- encoding(utf8).
:- module(sg_primitive_ko,
          [ primitive_ko//2,            % +What, +Term
            misshapen_ko//1,            % +Term
            comma_ko//1                 % +Argument
          ]).
:- use_module('../csg/csg_term', [misshapen/2, near_operands/2]).
:- use_module(message_parts, [meant_ko//1, shown_count/2]).
:- use_module('../primitive/primitive', [primitive_name/2]).
:- use_module(primitive_en,
              [ comma_forms/3, primitive_names//0, primitive_usage//1,
                surplus_numbers/2
              ]).
:- use_module(library(apply), [maplist/3]).
/** <module> What is wrong with a primitive, in Korean.

The heads are those of primitive_en.pl (tests/rules/primitive/primitive.plt).
*/

%!  misshapen_ko(+Term)// is semidet.
%
%   What should stand in the place of Term, misshapen/2.

misshapen_ko(Term) -->
    { misshapen(Term, Form) },
    [ '~p: ~w 꼴이어야 합니다'-[Term, Form] ].

%!  primitive_ko(+What, +Term)// is det.
%
%   The message for model_error(primitive(What, Term)).

primitive_ko(unknown, Term) -->
    misshapen_ko(Term),
    !.
primitive_ko(unknown, Term) -->
    [ '~p: 기본 입체가 아닙니다'-[Term] ],
    { near_operands(Term, Near) },
    meant_ko(Near),
    [ nl, '  기본 입체:' ],
    primitive_names.
primitive_ko(unknown_argument(A), Term) -->
    { primitive_name(Term, Name) },
    [ '~w 기본 입체에는 인수 ~p이(가) 없습니다'-[Name, A] ],
    primitive_usage(Term).
primitive_ko(missing(Argument), Term) -->
    { primitive_name(Term, Name) },
    [ '~w 기본 입체에 ~w(...) 인수가 필요합니다'-[Name, Argument] ],
    primitive_usage(Term).
primitive_ko(twice(Argument), Term) -->
    { primitive_name(Term, Name) },
    [ '~w 기본 입체에 ~w(...) 인수가 둘 있습니다'-[Name, Argument] ],
    primitive_usage(Term).
primitive_ko(both(A, B), Term) -->
    { primitive_name(Term, Name) },
    [ '~w 기본 입체에 ~w(...) 인수와 ~w(...) 인수가 함께 있습니다'-[Name, A, B], nl,
      '  하나만 남기십시오.' ].
primitive_ko(wrong_argument(A, Types), Term) -->
    { compound_name_arity(A, Name, _),
      maplist(type_ko, Types, Words),
      atomic_list_concat(Words, ', ', Text) },
    [ '~p: ~w(~w) 꼴이어야 합니다'-[A, Name, Text] ],
    comma_usage_ko(A, Types),
    primitive_usage(Term).
primitive_ko(wrong_item(Name, N, Item, Type), Term) -->
    { type_ko(Type, Word) },
    [ '~w(...)의 ~d번째 값 ~p: 있어야 할 것은 ~w'-[Name, N, Item, Word] ],
    primitive_usage(Term).
primitive_ko(few_facets(N, Least), Term) -->
    { primitive_name(Term, Name) },
    [ '이 ~w에는 면이 ~d개 이상 필요한데 ~d개입니다'-[Name, Least, N], nl,
      '  면 하나는 반 바퀴보다 작아야 합니다.' ].
primitive_ko(few(Argument, N, Least), _) -->
    [ '~w(~d): 너무 적습니다'-[Argument, N], nl,
      '  ~d 이상을 주십시오.'-[Least] ].
primitive_ko(odd(Argument, N), _) -->
    [ '~w(~d): 홀수입니다'-[Argument, N], nl,
      '  가장 넓은 원이 두 띠 사이에 있도록 짝수를 주십시오.' ].
primitive_ko(too_many(N), Term) -->
    { shown_count(N, Count) },
    { primitive_name(Term, Name) },
    [ '이 ~w 기본 입체는 한 방향으로 면이 ~w개가 됩니다'-[Name, Count], nl,
      '  허용 오차를 키우거나 면의 수를 줄이십시오.' ].
primitive_ko(too_many_vertices(N, Most), Term) -->
    { shown_count(N, Count) },
    { primitive_name(Term, Name) },
    [ '이 ~w 기본 입체는 꼭짓점이 ~w개가 됩니다. ~D개까지 됩니다'-
          [Name, Count, Most], nl,
      '  허용 오차를 키우거나 면, 띠, 층의 수를 줄이거나 --limits facets=N.' ].
primitive_ko(few_slices(N, Least), _) -->
    { shown_count(Least, Count) },
    [ '이 twist에는 층이 ~d개가 아니라 ~w개 이상 있어야 합니다'-[N, Count],
      nl, '  한 층은 반 바퀴보다 적게 돕니다.' ].
primitive_ko(no_step(Step), _) -->
    [ '~p: 배치 단계가 아닙니다'-[Step], nl,
      '  translate(X, Y, Z), rotate(x, Degrees), \c
       rotate(axis(X, Y, Z), Degrees),', nl,
      '  rotate(from(X, Y, Z), to(X, Y, Z), Degrees), scale(F), \c
       scale(FX, FY, FZ), mirror(x),', nl,
      '  mirror(normal(X, Y, Z)), 세 줄의 matrix([[A, B, C, D], ...]) 단계가 \c
       있습니다. 모델을 납작하게 만들 수는 없습니다.' ].
primitive_ko(no_list(Steps), _) -->
    [ 'at/2에는 단계의 리스트가 필요합니다: ~p'-[Steps], nl,
      '  at([Step, ...], Primitive)로 쓰십시오.' ].
primitive_ko(no_length, Term) -->
    [ '~p: 시작한 곳에서 끝납니다'-[Term], nl,
      '  서로 다른 두 점을 주십시오.' ].
primitive_ko(flat_top, Term) -->
    [ 'top(...)의 반지름 하나만 0입니다: ~p'-[Term], nl,
      '  둘 다 0보다 크게 하거나, 꼭대기가 점이면 top(0)을 주십시오.' ].
primitive_ko(sharp_turn(I), _) -->
    [ '축이 ~d번째 점에서 너무 급하게 꺾입니다'-[I], nl,
      '  마이터 이음은 168도 미만, Y관은 170도 미만입니다. 점이나 조각을 \c
       늘리십시오.' ].
primitive_ko(same_point(I), _) -->
    [ '~d번째 점과 그 다음 점이 같은 곳에 있습니다'-[I], nl,
      '  하나를 지우십시오.' ].
primitive_ko(short_piece(I, Length, Least), _) -->
    [ '조각 ~d의 축 길이는 ~6g인데 마이터 이음에는 ~6g보다 길어야 합니다'-
          [I, Length, Least], nl,
      '  조각을 길게 하거나(엘보는 반지름이나 양 끝을 크게) 지름을 \c
       줄이십시오.' ].
primitive_ko(odd_facets(N), _) -->
    [ 'facets(~d): 홀수입니다'-[N], nl,
      '  Y관의 조각들은 면소 두 개에서 만납니다. 짝수를 주십시오.' ].
primitive_ko(inner_too_large, Term) -->
    [ 'inner(...) 윤곽이 radius(...) 안에 있지 않습니다: ~p'-[Term], nl,
      '  더 작게 하십시오. 면이 적으면 두 다각형이 만나지 않아야 합니다.' ].
primitive_ko(tube_too_large, Term) -->
    [ '원환체가 자기 자신과 만납니다: ~p'-[Term], nl,
      '  tube(...) 값은 radius(...) 값보다 작아야 합니다.' ].
primitive_ko(too_large, _) -->
    [ '기본 입체가 계산하기에 너무 큽니다', nl,
      '  다른 단위를 쓰십시오.' ].
primitive_ko(collapsed, _) -->
    [ '배치한 곳에서 기본 입체의 꼭짓점들이 한 점이 됩니다', nl,
      '  그렇게 먼 곳에 두기에는 너무 작습니다. 다른 단위를 쓰십시오.' ].
primitive_ko(few_points(Loop, N), _) -->
    { loop_ko(Loop, Word) },
    [ '~w의 점이 ~d개입니다'-[Word, N], nl,
      '  다각형에는 점이 셋 이상 필요합니다.' ].
primitive_ko(same_point(Loop, I), _) -->
    { loop_ko(Loop, Word) },
    [ '~w의 점 ~d이(가) 바로 앞의 점과 같습니다'-[Word, I], nl,
      '  점을 한 번씩만 쓰십시오. 다각형은 저절로 닫힙니다.' ].
primitive_ko(crossing(Loop1, I, Loop2, J), _) -->
    { loop_ko(Loop1, Word1),
      loop_ko(Loop2, Word2) },
    [ '~w의 점 ~d에서 시작하는 모서리가 ~w의 점 ~d에서 시작하는 모서리와 \c
       만납니다'-[Word1, I, Word2, J], nl,
      '  다각형의 모서리는 공통 꼭짓점에서만 만날 수 있습니다.' ].
primitive_ko(hole_outside(Loop), _) -->
    { loop_ko(Loop, Word) },
    [ '~w이(가) 윤곽 밖에 있습니다'-[Word], nl,
      '  안으로 옮기거나 따로 기본 입체로 만드십시오.' ].
primitive_ko(hole_in_hole(Loop1, Loop2), _) -->
    { loop_ko(Loop1, Word1),
      loop_ko(Loop2, Word2) },
    [ '~w이(가) ~w 안에 있습니다'-[Word1, Word2], nl,
      '  빼십시오. 더 파낼 것이 없습니다.' ].
primitive_ko(across_axis(R, Z), _) -->
    [ '윤곽의 점 [~w, ~w]이(가) 축 너머에 있습니다'-[R, Z], nl,
      '  점은 [R, Z]이며 R은 축에서의 거리로 0 이상입니다.' ].
primitive_ko(point_on_axis(Z), _) -->
    [ '윤곽이 ~w에서 축과 한 점에서만 만나는데 그 모서리가 수평입니다'-[Z], nl,
      '  축에서 떨어뜨리거나 모서리가 축을 따라가게 하십시오.' ].
primitive_ko(corners_too_round(R), _) -->
    [ '사각형에 반지름 ~w의 둥근 모서리가 들어갈 자리가 없습니다'-[R], nl,
      '  반지름은 짧은 변의 반까지입니다.' ].
primitive_ko(not_convex(X, Y), _) -->
    [ '윤곽이 꼭짓점 [~w, ~w]에서 왼쪽으로 돌지 않습니다'-[X, Y], nl,
      '  변환관의 윤곽은 볼록하고, 꺾이는 곳에만 꼭짓점이 있습니다.' ].
primitive_ko(planes_cross, _) -->
    [ '한 윤곽의 평면이 다른 윤곽을 지나므로 변환관이 없습니다', nl,
      '  tilt(...)를 줄이거나 height(...)를 늘리십시오.' ].
primitive_ko(no_faces, _) -->
    [ '면이 없습니다', nl,
      '  하나 이상 주십시오.' ].
primitive_ko(unknown_point(F, V), _) -->
    [ '면 ~d에 없는 점 ~d이(가) 있습니다'-[F, V], nl,
      '  점은 1부터 셉니다.' ].
primitive_ko(bad_face(F, Fault), _) -->
    [ '면 ~d은(는) 다각형이 아닙니다: '-[F] ],
    face_ko(Fault).
primitive_ko(edge_taken(F, V1, V2), _) -->
    [ '면 ~d에 ~d에서 ~d(으)로 가는 모서리가 있는데 앞의 면에도 있습니다'-
          [F, V1, V2], nl,
      '  이웃한 면은 모서리를 서로 반대로 지납니다. 모든 면을 밖에서 보아 \c
       반시계 방향으로 쓰십시오.' ].
primitive_ko(open_edge(V1, V2), _) -->
    [ '~d에서 ~d(으)로 가는 모서리를 가진 면이 없습니다. 다면체가 열려 있습니다'-
          [V2, V1], nl,
      '  면을 더하거나 sheet(...)로 만드십시오.' ].
primitive_ko(inside_out, _) -->
    [ '다면체가 뒤집혔거나 부피가 없습니다', nl,
      '  모든 면을 밖에서 보아 반시계 방향으로 쓰십시오.' ].
primitive_ko(patch_points(K, N), _) -->
    [ '조각 ~d의 점이 16개가 아니라 ~d개입니다'-[K, N], nl,
      '  네 점씩 네 줄입니다.' ].
primitive_ko(patches_clash(K, L), _) -->
    [ '조각 ~d와(과) ~d이(가) 공통 모서리를 같은 방향으로 지납니다'-[K, L],
      nl,
      '  이웃한 조각은 같은 쪽을 보입니다. 하나를 뒤집으십시오(줄을 거꾸로 \c
       쓰십시오). 한 경계에 조각 셋은 올 수 없습니다.' ].

%!  comma_ko(+Argument)// is det.
%
%   Argument, of a primitive, has two numbers; a comma may be meant as the
%   decimal point.

comma_ko(Argument) -->
    { comma_forms(Argument, Point, Apart) },
    [ '~p: 수가 둘입니다. 쉼표를 소수점으로 썼습니까?'-[Argument],
      nl, '  수가 하나이면 ~p, 둘이면 ~p 꼴로 쓰십시오.'-[Point, Apart] ].

%   comma_usage_ko(A, Types): more numbers than there should be.

comma_usage_ko(A, Types) -->
    (   { surplus_numbers(A, Types) }
    ->  [ nl, '  소수점은 57.15처럼 점으로 씁니다.' ]
    ;   []
    ).

face_ko(list) -->
    [ '건너뛴 곳에 아무것도 없습니다', nl,
      '  음수는 닫힌 루프 뒤에 오며 다음 루프를 시작합니다.' ].
face_ko(edges(N)) -->
    [ '모서리가 ~d개입니다'-[N], nl, '  다각형에는 셋 이상 필요합니다.' ].
face_ko(no_edge(V)) -->
    [ '~d에서 자기 자신으로 갑니다'-[V], nl, '  점을 한 번만 쓰십시오.' ].
face_ko(twice(V1, V2)) -->
    [ '~d에서 ~d(으)로 두 번 갑니다'-[V1, V2], nl,
      '  한 걸음은 한 번만 쓰십시오.' ].
face_ko(open(V)) -->
    [ '~d에서 닫히지 않습니다'-[V], nl,
      '  건너뛴 뒤에는 루프의 첫 점을 다시 쓰십시오.' ].

loop_ko(outline, '윤곽').
loop_ko(hole(N), Word) :-
    format(atom(Word), '구멍 ~d', [N]).

type_ko(length, '0보다 큰 길이').
type_ko(radius, '0 이상의 길이').
type_ko(facets, '3에서 1000000까지의 정수').
type_ko(count, '1에서 1000000까지의 정수').
type_ko(factor, '0 이상의 배율').
type_ko(number, '수').
type_ko(flag, 'true 또는 false').
type_ko(turn, '0보다 크고 360 이하인 각').
type_ko(outline, 'circle(R), ellipse(A, B), rectangle(A, B), \c
                  rectangle(A, B, R) 또는 polygon([[X, Y], ...])').
type_ko(points2, '점 [X, Y]의 리스트').
type_ko(points3, '점 [X, Y, Z]의 리스트').
type_ko(loops2, '점 [X, Y]의 리스트의 리스트').
type_ko(faces, '점 번호의 리스트의 리스트').
type_ko(point2, '점 [X, Y]').
type_ko(point3, '점 [X, Y, Z]').
type_ko(face, '1부터 세는 점 번호의 리스트').
