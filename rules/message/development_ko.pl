:- encoding(utf8).
:- module(sg_development_ko,
          [ development_ko//2,          % +S, +What
            development_notice_ko//2    % +S, +What
          ]).
:- use_module(explain_words, [segment_word_ko/2, face_word/2]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3]).
/** <module> What is wrong with a development, in Korean.

development_en.pl has the same heads in English.
*/

%!  development_ko(+S, +What)// is det.
%
%   The message for geometry_error(development(S, What)).

development_ko(S, What) -->
    { segment_word_ko(S, Name) },
    [ '세그먼트 ~d~w은(는) 펼칠 수 없습니다: '-[S, Name] ],
    what_ko(What).

what_ko(kind(curve)) -->
    [ '곡선이어서 면이 없습니다' ].
what_ko(kind(pattern)) -->
    [ '이미 평면인 전개도입니다', nl,
      '  전개도를 만든 세그먼트를 지정하십시오.' ].
what_ko(kind(Kind)) -->
    { \+ memberchk(Kind, [curve,pattern]) },
    [ '종류가 ~w입니다'-[Kind], nl,
      '  입체와 곡면만 펼칠 수 있습니다.' ].
what_ko(empty) -->
    [ '다각형이 없습니다' ].
what_ko(not_simple(Ps)) -->
    [ '자기 자신과 교차하는 다각형: ' ],
    some_ko(Ps).
what_ko(not_flat(Ps)) -->
    [ '평면이 아닌 다각형: ' ],
    some_ko(Ps),
    [ nl, '  strict(true)가 없으면 그 삼각형들을 씁니다.' ].
what_ko(overlap(edge(E, Face3, Face4), Face1, Face2)) -->
    { maplist(face_word, [Face1,Face2,Face3,Face4], [W1,W2,W3,W4]) },
    [ '다각형 ~w와(과) 다각형 ~w 사이의 유지해야 할 모서리 ~d에서 붙이면 \c
       다각형 ~w이(가) 다각형 ~w 위에 놓입니다'-[W3, W4, E, W2, W1], nl,
      '  다른 모서리를 유지하거나 이 모서리를 접합선으로 두십시오.' ].
what_ko(no_joint(E)) -->
    [ '모서리 ~d에서 만나는 두 면이 없습니다'-[E], nl,
      '  두 다각형이 공유하는 모서리를 지정하십시오.' ].
what_ko(edge_length(E)) -->
    [ '모서리 ~d은(는) 너무 짧아, 거기에 매달릴 부분을 붙들 수 없습니다'-[E] ].
what_ko(no_numbers) -->
    [ '평면이 아닌 다각형은 삼각형이 되는데, 다각형과 모서리의 번호 뒤에 남은 \c
       번호가 모자랍니다', nl,
      '  다각형과 모서리에 2147483647보다 작은 번호를 주십시오.' ].
what_ko(no_polygon(P)) -->
    [ '다각형 ~p이(가) 없습니다'-[P] ].

some_ko(Ids) -->
    { length(Ids, Count),
      length(First, 10)
    },
    (   { Count =< 10 }
    ->  { atomic_list_concat(Ids, ', ', Text) },
        [ '~w'-[Text] ]
    ;   { append(First, _, Ids),
          atomic_list_concat(First, ', ', Text)
        },
        [ '~w, ... (모두 ~D개)'-[Text, Count] ]
    ).

%!  development_notice_ko(+S, +What)// is det.
%
%   The message for the warning sanggwan(development(S, What)).

development_notice_ko(S, border(Kind, Sides)) -->
    { segment_word_ko(S, Name) },
    [ '세그먼트 ~d~w: '-[S, Name] ],
    border_ko(Kind, Sides).
development_notice_ko(S, in_triangles(Ps)) -->
    { segment_word_ko(S, Name) },
    [ '세그먼트 ~d~w: 평면이 아닌 다각형은 삼각형으로 펼칩니다: '-[S, Name] ],
    some_ko(Ps).

border_ko(open, Sides) -->
    [ '입체인데 다음 모서리에 짝이 없습니다: ' ],
    sides_ko(Sides),
    [ nl, '  전개도의 가장자리가 됩니다. 면이 빠졌습니까?' ].
border_ko(turned, Sides) -->
    [ '다각형들이 다음 모서리를 같은 방향으로 지납니다: ' ],
    sides_ko(Sides),
    [ nl, '  그곳에서는 붙이지 않습니다. 그중 하나가 뒤집혀 있습니다.' ].
border_ko(crowded, Sides) -->
    [ '다음 모서리에는 다각형이 셋 이상이어서 짝이 남지 않습니다: ' ],
    sides_ko(Sides),
    [ nl, '  서로 반대 방향인 둘은 붙이고, 나머지는 그곳에서 떨어집니다.' ].

%   sides_ko(Sides): the first ones.

sides_ko(Sides) -->
    { length(Sides, Count) },
    sides_ko(Sides, 6),
    (   { Count =< 6 }
    ->  []
    ;   [ ', ... (모두 ~D개)'-[Count] ]
    ).

sides_ko([side(E, P, Name)|Sides], Most) -->
    [ '다각형 ~d'-[P] ],
    (   { Name == P }
    ->  []
    ;   [ ' (~p)'-[Name] ]
    ),
    [ '의 모서리 ~d'-[E] ],
    (   { Sides = [_|_], Most > 1 }
    ->  { Most1 is Most-1 },
        [ ', ' ],
        sides_ko(Sides, Most1)
    ;   []
    ).
