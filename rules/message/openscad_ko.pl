:- encoding(utf8).
:- module(sg_openscad_ko,
          [ openscad_ko//1              % +What
          ]).
:- use_module(particle, [particle/3]).
:- use_module(openscad_en, [openscad_names//1, openscad_value/2]).
/** <module> What is wrong with an OpenSCAD .csg file, in Korean.

openscad_en.pl has the same heads in English (tests/rules/model/openscad.plt).
*/

%!  openscad_ko(+What)// is det.
%
%   The message for model_error(openscad(What)).

openscad_ko(expected(Wanted, Found)) -->
    { wanted_ko(Wanted, Word),
      found_ko(Found, Text)
    },
    [ '~w이(가) 와야 할 곳에 ~w이(가) 있습니다'-[Word, Text], nl,
      '  .csg 파일은 `openscad -o FILE.csg` 가 쓰는 것입니다. .scad 파일은 \c
       먼저 그것으로 바꾸십시오.' ].
openscad_ko(open_string) -->
    [ '여기서 시작한 문자열이 끝나지 않습니다', nl,
      '  뒤에 따옴표(")를 쓰십시오.' ].
openscad_ko(open_comment) -->
    [ '여기서 시작한 주석이 끝나지 않습니다', nl,
      '  뒤에 */ 표시를 쓰십시오.' ].
openscad_ko(strange(Character)) -->
    [ '문자 ~q: 여기서 뜻이 없습니다'-[Character], nl,
      '  .csg 파일은 `openscad -o FILE.csg` 가 쓰는 것입니다. .scad 파일은 \c
       먼저 그것으로 바꾸십시오.' ].
openscad_ko(unsupported(Name, Names)) -->
    [ '~w: 읽지 않습니다. 읽는 것은'-[Name] ],
    openscad_names(Names),
    [ nl, '  OpenSCAD에 맡기고(`openscad -o FILE.stl`) 그 메시를 \c
           쓰십시오.' ].
openscad_ko(unknown(Name, Names)) -->
    [ '~w: 없습니다. 읽는 것은'-[Name] ],
    openscad_names(Names),
    [ nl, '  .scad 파일은 먼저 `openscad -o FILE.csg` 로 바꾸십시오.' ].
openscad_ko(missing(Name, Argument)) -->
    { argument_ko(Argument, Word) },
    [ '~w에는 ~w이(가) 있어야 합니다'-[Name, Word], nl,
      '  OpenSCAD로 파일을 쓰거나, 더하십시오.' ].
openscad_ko(argument(Name, Argument, Value, Type)) -->
    { argument_ko(Argument, Word),
      value_type_ko(Type, Wanted),
      openscad_value(Value, Text)
    },
    [ '~w의 ~w: ~w. 있어야 할 것: ~w'-[Name, Word, Text, Wanted],
      nl, '  값을 고치십시오.' ].
openscad_ko(unknown_argument(Name, Argument, Names)) -->
    { argument_ko(Argument, Word) },
    [ '~w의 ~w: 읽지 않습니다. 읽는 것은'-[Name, Word] ],
    openscad_names(Names),
    [ nl, '  .scad 파일은 먼저 `openscad -o FILE.csg` 로 바꾸십시오.' ].
openscad_ko(childless(Name)) -->
    [ '~w 아래에 무엇이 있습니다'-[Name], nl,
      '  그 옆에, group() 아래에 두십시오.' ].
openscad_ko(no_point(Name, I)) -->
    [ '이 ~w에 없는 점 ~d이(가) 쓰였습니다'-[Name, I], nl,
      '  점은 0부터 셉니다.' ].
openscad_ko(flat) -->
    [ '모델이 평평합니다. 입체가 아니라 평면 그림입니다', nl,
      '  linear_extrude()나 rotate_extrude() 아래에 두십시오.' ].
openscad_ko(mixed(Name)) -->
    [ '한 ~w 아래에 입체와 평면 도형이 함께 있습니다'-[Name], nl,
      '  평면 도형을 밀어내거나 빼십시오.' ].
openscad_ko(flat_extrusion(Name)) -->
    [ '~w에 입체를 주었습니다. 평면 도형이어야 합니다'-[Name], nl,
      '  square(), circle(), polygon()을 주십시오.' ].
openscad_ko(across_axis(X1, X2)) -->
    [ '돌릴 도형이 축의 양쪽에 있습니다: x = ~w에서 ~w까지'-[X1, X2], nl,
      '  한쪽으로 옮기거나 축에서 자르십시오.' ].
openscad_ko(nothing) -->
    [ '모델에 아무것도 없습니다', nl,
      '  빈 group, 크기 0, 앞에 *나 %가 있는 것은 세지 않습니다.' ].

wanted_ko(name, '노드의 이름') :- !.
wanted_ko(body, '; 또는 { 기호') :- !.
wanted_ko(value, '값') :- !.
wanted_ko(Sign, Word) :-
    named_sign(Sign, Word).

found_ko(end, '파일의 끝') :- !.
found_ko(Found, Text) :-
    openscad_value(Found, Word),
    named_sign(Word, Text).

%   named_sign(Word0, Word): what cannot be read aloud is called a sign.

named_sign(Word0, Word) :-
    particle(Word0, '이(가)', Particle),
    (   Particle == "이(가)"
    ->  format(string(Word), '~w 기호', [Word0])
    ;   Word = Word0
    ).

argument_ko(N, Word) :-
    (   integer(N)
    ->  format(atom(Word), '인수 ~d', [N])
    ;   Word = N
    ).

value_type_ko(number, '수').
value_type_ko(count, '수').
value_type_ko(flag, 'true 또는 false').
value_type_ko(size2, '수 또는 [X, Y]').
value_type_ko(size3, '수 또는 [X, Y, Z]').
value_type_ko(factors, '0 이상의 배율 또는 [X, Y]').
value_type_ko(points2, '점 [X, Y]의 리스트').
value_type_ko(points3, '점 [X, Y, Z]의 리스트').
value_type_ko(faces, '점 번호의 리스트의 리스트').
value_type_ko(matrix, '네 수의 네 줄, 마지막은 [0, 0, 0, 1]').
