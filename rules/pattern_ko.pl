:- encoding(utf8).
:- module(sg_pattern_ko,
          [ pattern_ko//1               % +What
          ]).
/** <module> What happened on the way to a pattern on paper, in Korean.

pattern_en.pl has the same heads in English.
*/

%!  pattern_ko(+What)// is det.
%
%   The notice sanggwan(pattern(What)).

pattern_ko(divided(Before, After)) -->
    [ '조각 ~D개 가운데 종이보다 큰 것을 나누어 ~D개가 되었습니다'
      -[Before, After] ].
pattern_ko(without_tab(N)) -->
    [ '이음매 ~D개에는 양쪽 어디에도 자리가 없어 풀칠 날개가 없습니다'-[N] ].
pattern_ko(no_room(Role, N)) -->
    { role_ko(Role, Words) },
    [ '읽을 수 있는 크기로 쓸 자리가 없어 ~w ~D개를 뺐습니다'-[Words, N] ].
pattern_ko(pages(N, Files)) -->
    { atomic_list_concat(Files, ' ', All) },
    [ '~D장: ~w'-[N, All] ].
pattern_ko(taken(Sheets, Pieces, Share)) -->
    [ '조각 ~D개를 ~D장에 놓았고, 종이의 ~1f %를 씁니다'
      -[Pieces, Sheets, Share] ].

role_ko(number, '짝 번호').
role_ko(face_name, '면 이름').
role_ko(angle, '꺾는 각').
