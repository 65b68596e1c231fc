:- module(sg_true_ko,
          [ true_ko//1,                 % +What
            kind_word/2,                % ?Kind, -Word
            segment_kind_word/2           % +Kind, -Word
          ]).
:- encoding(utf8).
/** <module> What is wrong with a true development, in Korean.

The heads are those of true_en.pl.
*/

%!  true_ko(+What)// is det.
%
%   The message for geometry_error(true(What)).

true_ko(no_part(S, Part)) -->
    { var(Part) },
    !,
    [ '세그먼트 ~d에는 실제 길이로 펼칠 부분이 없습니다'-[S], nl,
      '  원기둥, 원뿔, 변환관의 작은 면이 없습니다.' ].
true_ko(no_part(S, Part)) -->
    [ '세그먼트 ~d에는 실제 길이로 펼칠 부분이 없습니다: ~p'-[S, Part], nl,
      '  부분의 이름은 face_of/3에 있는 대로 side, outer, edge(1)이고, 잘라낸 \c
         세그먼트에서는 2/side(세그먼트 2의 옆면)입니다.' ].
true_ko(moved(S, Part)) -->
    [ '세그먼트 ~d의 부분이 기본 입체의 자리에 있지 않습니다: ~p'-[S, Part], nl,
      '  사본이 아니라 기본 입체 자체를 배치하십시오.' ].
true_ko(nothing_left(S, Part)) -->
    [ '세그먼트 ~d의 부분 ~p에서 남는 것이 없습니다: 작은 면만 나와 있고 실제 \c
       곡면은 나와 있지 않습니다'-[S, Part], nl,
      '  --true 없이 전개하거나 --only로 다른 세그먼트만 전개하십시오.' ].
true_ko(not_symmetric(S, Part)) -->
    [ '반쪽 전개도로는 모자랍니다: 세그먼트 ~d의 부분 ~p: 두 쪽이 \c
       다릅니다'-[S, Part], nl,
      '  다른 접합선을 주거나 전체를 전개하십시오.' ].
true_ko(flat_part(S, Part, Option)) -->
    [ '세그먼트 ~d의 부분 ~p: 비율이 다른 두 타원 사이에 있어 펴지지 않으므로 \c
       ~w 옵션을 쓸 수 없습니다'-[S, Part, Option], nl,
      '  펴지는 transition(base(ellipse(A, B)), top(ellipse(C, D)), height(H)) \c
         으로 만드십시오.' ].
true_ko(no_option(S, Option)) -->
    [ '세그먼트 ~d: 고어나 구대로 나눈 구에는 ~w 옵션이 뜻이 없습니다'-[S, Option], nl,
      '  이 옵션을 빼십시오.' ].
true_ko(no_offset(S)) -->
    [ '세그먼트 ~d의 판재 두께 쪽 곡면을 알 수 없습니다'-[S], nl,
      '  두께가 있으면 원기둥과 원뿔(타원·빗원 포함), 구, 원환체, 변환관,', nl,
      '  그리고 볼록하거나 한 꼭짓점에 면이 셋씩 만나는 평면 입체의 \c
         상관선만 찾을 수 있습니다.', nl,
      '  판재는 그 안에 들어갈 만큼 얇아야 합니다.' ].
true_ko(too_thick(S, T, Most)) -->
    [ '두께 ~p인 판재로는 세그먼트 ~d의 안이 남지 않습니다: ~6g보다 얇아야 \c
       합니다'-[T, S, Most], nl,
      '  두께를 줄이거나 부품을 더 넓게 하십시오.' ].
true_ko(bend(S, P1, P2, Degrees)) -->
    [ '세그먼트 ~d: 다각형 ~d과(와) ~d 사이가 ~2f도 접힙니다: 그런 굽힘은 없습니다'-
      [S, P1, P2, Degrees], nl, '  굽힘은 170도보다 작아야 합니다.' ].
true_ko(bend_too_wide(S, P, Width)) -->
    [ '세그먼트 ~d: 다각형 ~d이(가) 굽힘과 접합선으로 줄어드는 길이 ~4f보다 좁습니다'-
      [S, P, Width], nl,
      '  --bend-radius나 --thickness를 줄이거나, 필요 없는 면을 빼십시오: \c
         --remove base.' ].
true_ko(no_relief(S, P, Wide)) -->
    [ '세그먼트 ~d: 굽힘이 만나는 곳에서 ~4f까지 모퉁이를 따내기에는 다각형 ~d이(가) \c
       너무 작습니다'-[S, Wide, P], nl,
      '  --relief none을 주거나, --bend-radius나 --thickness를 줄이십시오.' ].
true_ko(bent_over(S, P)) -->
    [ '세그먼트 ~d: 굽힘과 접합선으로 줄어든 다각형 ~d이(가) 자기 자신과 교차하여 자를 수 \c
       없습니다'-[S, P], nl,
      '  --thickness나 --bend-radius를 줄이거나 다른 모서리를 자르십시오.' ].
true_ko(bent_facet(S, P, Kind, Width)) -->
    { kind_word(Kind, Word) },
    [ '세그먼트 ~d: ~w의 다각형 ~d이(가) 굽힘으로 줄어드는 길이 ~4f보다 좁습니다'-
      [S, Word, P, Width], nl,
      '  ~w 면은 전개할 수 없습니다: 판재를 말아서는 만들 수 없고, 평면 조각 \c
         사이를 굽힐 수만 있습니다.'-[Word], nl,
      '  조각 수(facets)나 --bend-radius, --thickness를 줄이거나, --thickness \c
         없이 얇은 판재로 펼치십시오.' ].

%!  kind_word(?Kind, -Word) is nondet.
%
%   Word is Korean for a surface of this Kind that is not developable.

kind_word(sphere, '구').
kind_word(torus, '원환체').
kind_word(bezier, '베지어 곡면').

%!  segment_kind_word(+Kind, -Word) is det.
%
%   Word is Korean for the Kind of a segment.

segment_kind_word(Kind, Word) :-
    (   memberchk(Kind-Word0, [ solid-'입체', surface-'곡면', curve-'곡선',
                                pattern-'전개도' ])
    ->  Word = Word0
    ;   Word = Kind
    ).
