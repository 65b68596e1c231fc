:- encoding(utf8).
:- module(sg_pattern_ko,
          [ pattern_ko//1,              % +What
            pattern_fault_ko//1         % +What
          ]).
:- use_module('../pattern/pattern_scale', [scale_text/2]).
:- use_module(pattern_en, [some_numbers/2]).
/** <module> What happened on the way to a pattern on paper, in Korean.

pattern_en.pl has the same heads in English.
*/

%!  pattern_ko(+What)// is det.
%
%   The notice sanggwan(pattern(What)).

pattern_ko(divided(Before, After)) -->
    [ '조각 ~D개 가운데 용지보다 큰 것을 나누어 ~D개가 되었습니다'
      -[Before, After], nl,
      '  --tile을 주면 나누지 않고, 이어 붙일 여러 장에 그립니다.' ].
pattern_ko(opened(Before, After)) -->
    [ '틈에 풀칠면이 들어가도록 조각 ~D개를 나누어 ~D개가 되었습니다'
      -[Before, After] ].
pattern_ko(opened_by_itself(Before, After)) -->
    pattern_ko(opened(Before, After)),
    [ nl, '  --no-open-slits를 쓰면 나누지 않지만, 접합선의 많은 부분에 풀칠면이 없습니다.'
    ].
pattern_ko(without_tab(D, N, Share, _, Seam, Es)) -->
    { memberchk(Seam, [lap,lock]) },
    !,
    [ '전개도 ~d: 이음 여유가 들어갈 자리가 없는 접합선 ~D개(전체 길이의 ~3g %)'
      -[D, N, Share] ],
    without_tab_ko(Es).
pattern_ko(without_tab(D, N, Share, Whys, Help, Es)) -->
    [ '전개도 ~d: 접합선 ~D개(모든 길이의 ~3g %)에는 양쪽 어디에도 자리가 없어 \c
       풀칠면이 없습니다'-[D, N, Share], nl, '  ' ],
    whys_ko(Whys),
    without_tab_ko(Es),
    without_tab_help_ko(Help).
pattern_ko(too_large(N)) -->
    [ '조각 ~D개는 풀칠면까지 치면 용지보다 커서, 따로 한 장씩 놓았지만 밖으로 나갑니다'
      -[N], nl,
      '  더 큰 --page나 더 좁은 --tabs를 쓰십시오.' ].
pattern_ko(scale(Scale)) -->
    { scale_text(Scale, Text) },
    [ '척도는 ~w입니다'-[Text] ].
pattern_ko(yield(Share, Sheets)) -->
    { Percent is 100*Share },
    [ '조각들이 용지(~D장)의 ~1f %를 차지합니다'-[Sheets, Percent] ].
pattern_ko(no_room(Role, N)) -->
    { role_ko(Role, Words) },
    [ '읽을 수 있는 크기로 쓸 자리가 없어 ~w ~D개를 뺐습니다'-[Words, N] ].

whys_ko([Why-N|Whys]) -->
    { why_ko(Why, Words) },
    [ '~w: ~D개'-[Words, N] ],
    (   { Whys == [] }
    ->  []
    ;   [ ', ' ],
        whys_ko(Whys)
    ).

why_ko(short, '너무 짧은 것').
why_ko(slit, '너무 좁은 틈에 있는 것').
why_ko(taken, '다른 풀칠면과 겹치는 것').

without_tab_ko([]) -->
    !.
without_tab_ko(Es) -->
    { some_numbers(Es, Text) },
    [ nl, '  모서리: ~w'-[Text] ].

without_tab_help_ko(none) -->
    [].
without_tab_help_ko(open_slits) -->
    [ nl, '  --open-slits를 쓰면 틈에 자리가 생길 때까지 조각을 나눕니다.' ].

role_ko(number, '짝 번호').
role_ko(face_name, '이름').
role_ko(angle, '꺾는 각').
role_ko(generator_number, '면소 번호').
role_ko(table, '실장(실제 길이)표').
role_ko(bends, '굽힘표').

%!  pattern_fault_ko(+What)// is det.
%
%   The message for usage_error(pattern(What)).

pattern_fault_ko(paper(Page, Names)) -->
    { atomic_list_concat(Names, ' ', All) },
    [ '--page ~w: 그런 용지가 없습니다'-[Page], nl,
      '  ~w letter 가운데 하나(-portrait, -landscape를 붙일 수 있음)나 mm 단위의 \c
       WxH(50에서 20000까지)로 쓰십시오.'-[All] ].
pattern_fault_ko(scale(Text)) -->
    [ '--scale ~w: 척도가 아닙니다'-[Text], nl,
      '  절반은 1:2, 다섯 배는 5:1로 쓰십시오.' ].
pattern_fault_ko(no_height) -->
    [ '--height: 펼칠 것에 높이가 없습니다'-[], nl,
      '  --scale, --pages, --fit 가운데 하나를 쓰십시오.' ].
pattern_fault_ko(no_scale) -->
    [ '--pages: 어떤 척도로도 그만큼 적은 쪽에 들어가지 않습니다'-[], nl,
      '  --pages를 늘리거나 더 큰 --page, 더 좁은 --tabs를 쓰십시오.' ].
pattern_fault_ko(kerf(Kerf, Piece)) -->
    [ '--kerf ~w: 조각 ~w의 홈이나 구멍, 풀칠면보다 넓습니다'
      -[Kerf, Piece], nl,
      '  절단 폭을 줄이거나 --scale을 키우십시오.' ].
pattern_fault_ko(margin(Margin, W-H)) -->
    [ '--margin ~w: ~w x ~w mm 쪽에 남는 자리가 없습니다'-[Margin, W, H], nl,
      '  여백을 줄이거나 더 큰 --page를 쓰십시오.' ].
pattern_fault_ko(pages(Count, Most)) -->
    [ '전개도가 ~D쪽이 됩니다. ~D쪽까지만 됩니다'-[Count, Most], nl,
      '  더 작은 --scale이나 더 큰 --page를 쓰십시오.' ].
pattern_fault_ko(large(Size, Most)) -->
    [ '전개도의 크기가 ~4g mm가 됩니다. ~4g mm까지만 됩니다'-[Size, Most], nl,
      '  1:1000처럼 더 작은 --scale을 쓰십시오. 모델의 단위가 맞습니까?' ].
pattern_fault_ko(wide(Option, Width, Most, W-H)) -->
    [ '~w ~w: 조각을 ~1f x ~1f mm 자리에 맞게 나누어야 하는데, 너비가 그만하면 \c
       남는 자리가 너무 작습니다'-[Option, Width, W, H], nl,
      '  ~w 이하로 줄이거나 더 큰 --page를 쓰십시오.'-[Most] ].
pattern_fault_ko(overlap(Overlap, Most)) -->
    [ '--overlap ~w: 쪽에 쓸 수 있는 자리의 절반보다 큽니다'-[Overlap], nl,
      '  ~w 이하로 줄이거나 더 큰 --page를 쓰십시오.'-[Most] ].
