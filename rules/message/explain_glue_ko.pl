:- encoding(utf8).
:- module(sg_explain_glue_ko,
          [ glue_statement_ko//1,       % +Statement
            glue_nothing_ko//1          % +Item
          ]).
:- use_module(explain_words, [segment_word_ko/2, point_text/2]).
/** <module> Explanations of what is glued in Korean; explain_glue_en.pl has
them in English.
*/

%!  glue_statement_ko(+Statement)// is semidet.
%
%   A statement of explain_glue.pl in Korean.

glue_statement_ko(glued_vertex(S, V, Point)) -->
    { segment_word_ko(S, Word), point_text(Point, Text) },
    [ '세그먼트 ~d~w의 꼭짓점 ~d번은 ~w에 있다'-[S, Word, V, Text] ].
glue_statement_ko(glued_edge(S, E, V1, V2)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 모서리 ~d번은 꼭짓점 ~d번에서 ~d번까지이다'-
      [S, Word, E, V1, V2] ].
glue_statement_ko(glued_polygon(S, P)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 다각형 ~d번'-[S, Word, P] ].
glue_statement_ko(was_vertex(S, V, Moved)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 꼭짓점 ~d번이었고 '-[S, Word, V] ],
    moved_ko(Moved).
glue_statement_ko(was_polygon(S, P, Sense)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 다각형 ~d번의 일부이다'-[S, Word, P] ],
    (   { Sense =:= 1 }
    ->  []
    ;   [ '(뒤집힘)' ]
    ).
glue_statement_ko(cut_vertex(Ss)) -->
    { atomic_list_concat(Ss, ', ', List) },
    [ '이 세그먼트들의 면이 여기서 만난다: ~w'-[List] ].
glue_statement_ko(point_loop(P)) -->
    [ '다각형 ~d번 안에 있으며 그 자체가 루프이다'-[P] ].
glue_statement_ko(in_region(R)) -->
    [ '영역 ~d 안에 있다'-[R] ].
glue_statement_ko(disks_lie(D1, D2, Relation, By)) -->
    disks_lie_ko(Relation, D1, D2),
    (   { By == default }
    ->  []
    ;   [ ', ~w의 규칙에 따라 (disk_relation/3)'-[By] ]
    ).
glue_statement_ko(disk(D, Es, Ps)) -->
    { atomic_list_concat(Es, ', ', Edges),
      atomic_list_concat(Ps, ', ', Polygons) },
    [ '원반 ~d: '-[D] ],
    (   { Es == [] }
    ->  [ '다각형 ~w, 사방으로 이어진다'-[Polygons] ]
    ;   { Ps == [] }
    ->  [ '선 ~w'-[Edges] ]
    ;   [ '모서리 ~w, 다각형 ~w'-[Edges, Polygons] ]
    ).
glue_statement_ko(page(P, R)) -->
    [ '오른손 방향으로: 다각형 ~d번, 다음은 영역 ~w'-[P, R] ].
glue_statement_ko(between(R, R)) -->
    !,
    [ '양쪽이 모두 영역 ~d이다'-[R] ].
glue_statement_ko(between(Below, Above)) -->
    [ '뒤는 영역 ~d, 앞은 영역 ~d이다'-[Below, Above] ].
glue_statement_ko(inner_loop([V])) -->
    !,
    [ '꼭짓점 ~d번이 그 안에 있다'-[V] ].
glue_statement_ko(inner_loop(Vs)) -->
    { atomic_list_concat(Vs, ', ', List) },
    [ '그 안에 루프 ~w이(가) 있다'-[List] ].
glue_statement_ko(region(S, R, Role, Volume)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 영역 ~d: '-[S, Word, R] ],
    role_ko(Role),
    (   { Volume == none }
    ->  []
    ;   [ ', 부피 ~6g'-[Volume] ]
    ).
glue_statement_ko(inner_point(Point)) -->
    { point_text(Point, Text) },
    [ '~w이(가) 그 안의 점이다'-[Text] ].
glue_statement_ko(inside(S)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 안이다'-[S, Word] ].
glue_statement_ko(beyond(R, Faces, Area)) -->
    [ '넓이 ~6g인 면 ~D개 너머는 영역 ~d이다'-[Area, Faces, R] ].
glue_statement_ko(laminar(P)) -->
    [ '다각형 ~d번이 그 안에 있고 양쪽이 모두 이 영역이다'-[P] ].
glue_statement_ko(wire_in(E)) -->
    [ '선 ~d번이 그 안에 있다'-[E] ].
glue_statement_ko(is_glued(S1, P1, S2, P2)) -->
    pair_ko(S1, P1, S2, P2),
    [ '은 붙어 있다' ].
glue_statement_ko(not_glued(S1, P1, S2, P2)) -->
    pair_ko(S1, P1, S2, P2),
    [ '은 함께 가진 면이 없다' ].
glue_statement_ko(kept_apart(By)) -->
    [ '서로 포개져 있으나 ~w에 따라 떨어져 있다'-[By] ].
glue_statement_ko(in_common(Vs)) -->
    { atomic_list_concat(Vs, ', ', List) },
    [ '붙인 모델의 꼭짓점 ~w번을 함께 가진다'-[List] ].
glue_statement_ko(gap(Gap, Point1, Point2)) -->
    { point_text(Point1, Text1), point_text(Point2, Text2) },
    (   { Gap =:= 0 }
    ->  [ '~w에서 닿는다'-[Text1] ]
    ;   [ '~w에서 ~w까지 ~6g 떨어져 있다'-[Text1, Text2, Gap] ]
    ).
glue_statement_ko(plane_angle(Angle)) -->
    (   { Angle =:= 0 }
    ->  [ '두 평면은 평행하다' ]
    ;   [ '두 평면이 이루는 각은 ~6g도이다'-[Angle] ]
    ).

moved_ko(Moved) -->
    (   { Moved =:= 0 }
    ->  [ '정확히 그 자리이다' ]
    ;   [ '~6g 옮겨졌다'-[Moved] ]
    ).

role_ko(outside) -->
    [ '바깥' ].
role_ko(cell) -->
    [ '세포' ].
role_ko(void) -->
    [ '빈 곳: 닫혀 있지만 어느 피연산자의 안도 아니다' ].
role_ko(slit) -->
    [ '틈: 겹친 면 사이' ].

pair_ko(S1, P1, S2, P2) -->
    { segment_word_ko(S1, W1), segment_word_ko(S2, W2) },
    [ '세그먼트 ~d~w의 다각형 ~d번과 세그먼트 ~d~w의 다각형 ~d번'-
      [S1, W1, P1, S2, W2, P2] ].

%!  glue_nothing_ko(+Item)// is det.
%
%   That there is nothing to explain in Item: what can be asked.

glue_nothing_ko(Item) -->
    [ '~p에는 설명할 것이 없습니다'-[Item], nl,
      '  glued(S, v(V)), glued(S, e(E)), glued(S, p(P))는 붙인 것 S의 것, \c
       region(S, R)은 영역이 있는 세그먼트의 것, \c
       why_not(glued(S1-P1, S2-P2))는 피연산자의 다각형입니다.' ].

disks_lie_ko(disjoint, D1, D2) -->
    [ '원반 ~d번과 ~d번은 서로의 바깥에 있다'-[D1, D2] ].
disks_lie_ko(cover, D1, D2) -->
    [ '원반 ~d번과 ~d번의 안을 합하면 공간 전체이다'-[D1, D2] ].
disks_lie_ko(within, D1, D2) -->
    [ '원반 ~d번은 원반 ~d번 안에 있다'-[D1, D2] ].
disks_lie_ko(around, D1, D2) -->
    [ '원반 ~d번은 원반 ~d번 안에 있다'-[D2, D1] ].
disks_lie_ko(cross, D1, D2) -->
    [ '원반 ~d번과 ~d번은 서로를 뚫고 지나간다'-[D1, D2] ].
