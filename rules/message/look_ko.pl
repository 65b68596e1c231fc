:- encoding(utf8).
:- module(sg_look_ko,
          [ look_ko//1,                 % +What
            expected_look_ko//1,        % +Expected
            expected_light_ko//1        % +Expected
          ]).
:- use_module('../colour', [colour_name/2]).
:- use_module(library(apply), [maplist/3]).
/** <module> What is wrong with looks and lights, in Korean.

The heads are those of look_en.pl (tests/rules/model/look_file.plt).
*/

%!  look_ko(+What)// is det.
%
%   The message for model_error(look(What)).

look_ko(no_segment(S)) -->
    [ '이렇게 보일 세그먼트 ~w이(가) 없습니다'-[S], nl,
      '  번호를 고치거나 사실을 지우십시오.' ].
look_ko(twice(S, Slot)) -->
    [ '세그먼트 ~w에 ~w이(가) 둘 있습니다'-[S, Slot], nl,
      '  두 look/2 사실 가운데 하나를 지우십시오.' ].
look_ko(light_twice(N, Slot)) -->
    [ '빛 ~w에 ~w이(가) 둘 있습니다'-[N, Slot], nl,
      '  두 light/2 사실 가운데 하나를 지우십시오.' ].
look_ko(everywhere) -->
    [ '빛 0은 모든 쪽에서 오므로 방향이 없습니다', nl,
      '  이 빛에 1에서 8까지의 번호를 주거나 light(0, strength(F))로 \c
       쓰십시오.' ].
look_ko(no_way(N)) -->
    [ '빛 ~w에 방향이 없습니다'-[N], nl,
      '  light(~w, picture(X, Y, Z))나 light(~w, direction(X, Y, Z))를 \c
       추가하십시오.'-[N, N] ].
look_ko(no_face(S, Face, Names)) -->
    { maplist(term_to_atom, Names, Atoms),
      atomic_list_concat(Atoms, ', ', All)
    },
    [ '세그먼트 ~w에 면 ~w이(가) 없습니다'-[S, Face], nl ],
    (   { Names == [] }
    ->  [ '  그 면들에는 이름이 없습니다. look(~w, Property)로 쓰십시오.'-[S] ]
    ;   [ '  그 면 가운데 하나를 쓰십시오: ~w.'-[All] ]
    ).
look_ko(only(Name, Arity)) -->
    [ '--look 파일에 ~w/~w 사실은 쓸 수 없습니다'-[Name, Arity], nl,
      '  look(Segment, Property)와 light(N, Property)를 쓰십시오.' ].

%!  expected_look_ko(+Expected)// is det.
%!  expected_light_ko(+Expected)// is det.
%
%   What should stand there, see look_expected/2.

expected_look_ko(opacity) -->
    !,
    [ 'opacity(A). A는 0(투명)에서 1(불투명)까지의 수' ].
expected_look_ko(shine) -->
    !,
    [ 'shine(F, N). F는 0에서 1까지의 수, N은 1에서 1000까지의 정수' ].
expected_look_ko(colour) -->
    !,
    { findall(Name, colour_name(Name, _), Names),
      atomic_list_concat(Names, ', ', All)
    },
    [ 'colour(C). C는 0에서 255까지 정수의 rgb(R, G, B) 또는 다음 가운데 하나', nl,
      '  ~w.'-[All] ].
expected_look_ko(_) -->
    [ 'colour(C), opacity(A), shine(F, N), 또는 면 하나만이면 그 가운데 하나를 \c
       넣은 face(Face, Property)' ].

expected_light_ko(strength) -->
    [ 'strength(F). F는 0에서 10까지의 수' ].
expected_light_ko(way) -->
    [ '모두 0은 아닌 세 수의 방향' ].
expected_light_ko(any) -->
    [ 'picture(X, Y, Z) (그림에서 오는 쪽: 오른쪽, 위, 눈 쪽), \c
       direction(X, Y, Z) (모델에서 가는 쪽), 또는 strength(F)' ].
expected_light_ko(colour) -->
    expected_light_ko(any).
expected_light_ko(opacity) -->
    expected_light_ko(any).
expected_light_ko(shine) -->
    expected_light_ko(any).
