:- encoding(utf8).
:- module(sg_explain_ko,
          [ statement_ko//1,            % +Statement
            hidden_ko//1                % +What
          ]).
:- use_module('../near', [is_rounding/2]).
:- use_module(explain_words, 
              [ other_origin/1, segment_word_ko/2, polygon_word/3, in_order/4,
                exact_text/3, point_text/2
              ]).
:- use_module(explain_glue_ko, [glue_statement_ko//1]).
:- use_module(explain_parameter_ko, [parameter_statement_ko//1]).
:- use_module(explain_pixel_ko, [pixel_statement_ko//1]).
:- use_module(library(apply), [maplist/3]).

/** <module> Explanations in Korean; explain_en.pl has them in English.
*/

%!  statement_ko(+Statement)// is semidet.
%
%   A statement of explain_words.pl in Korean.

statement_ko(line(L, S1, P1, S2, P2)) -->
    { segment_word_ko(S1, W1), segment_word_ko(S2, W2) },
    [ '상관선 ~d: 세그먼트 ~d~w의 다각형 ~d과(와) 세그먼트 ~d~w의 다각형 ~d이(가) \c
       만난다'-[L, S1, W1, P1, S2, W2, P2] ].
statement_ko(touch(L, S1, P1, S2, P2)) -->
    { segment_word_ko(S1, W1), segment_word_ko(S2, W2) },
    [ '상관선 ~d: 세그먼트 ~d~w의 다각형 ~d과(와) 세그먼트 ~d~w의 다각형 ~d이(가) 한 \c
       점에서 닿는다'-[L, S1, W1, P1, S2, W2, P2] ].
statement_ko(point(End, Point, S1, V1, S2, V2)) -->
    { memberchk(End-Word, [start-'시작점', end-'끝점', point-'점']) },
    [ '~w '-[Word] ],
    point(Point),
    [ ', 세그먼트 ~d의 꼭짓점 ~d, 세그먼트 ~d의 꼭짓점 ~d'-
      [S1, V1, S2, V2] ].
statement_ko(contact('vertex-vertex', seat(S1,V1,_), seat(S2,V2,_))) -->
    [ '세그먼트 ~d의 꼭짓점 ~d과(와) 세그먼트 ~d의 꼭짓점 ~d이(가) 한 곳에 있다'-
      [S1, V1, S2, V2] ].
statement_ko(contact('vertex-edge', Seat1, Seat2)) -->
    { in_order(Seat1, Seat2, seat(S1,V1,_), seat(S2,_,Place)) },
    [ '세그먼트 ~d의 꼭짓점 ~d이(가) '-[S1, V1] ],
    place(S2, Place),
    [ '에 있다' ].
statement_ko(contact('vertex-face', Seat1, Seat2)) -->
    { in_order(Seat1, Seat2, seat(S1,V1,_), seat(S2,_,Place)) },
    [ '세그먼트 ~d의 꼭짓점 ~d이(가) '-[S1, V1] ],
    place(S2, Place),
    [ ' 안에 있다' ].
statement_ko(contact('edge-edge', seat(S1,_,Place1), seat(S2,_,Place2))) -->
    place(S1, Place1),
    [ '이(가) ' ],
    place(S2, Place2),
    [ '과(와) 만난다' ].
statement_ko(contact('edge-face', Seat1, Seat2)) -->
    { in_order(Seat1, Seat2, seat(S1,_,Place1), seat(S2,_,Place2)) },
    place(S1, Place1),
    [ '이(가) ' ],
    place(S2, Place2),
    [ '을(를) 뚫는다' ].
statement_ko(contact('edge-in-face', Seat1, Seat2)) -->
    { in_order(Seat1, Seat2, seat(S1,_,Place1), seat(S2,_,Place2)) },
    place(S1, Place1),
    [ '이(가) ' ],
    place(S2, Place2),
    [ ' 안을 지난다' ].
statement_ko(contact('face-face', seat(S1,_,Place1), seat(S2,_,Place2))) -->
    place(S1, Place1),
    [ '과(와) ' ],
    place(S2, Place2),
    [ '의 안에 있다' ].
statement_ko(made(v(S, V))) -->
    [ '세그먼트 ~d의 꼭짓점 ~d이(가) 만들었다'-[S, V] ].
statement_ko(made(on(S-V, _))) -->
    [ '세그먼트 ~d의 꼭짓점 ~d 자리'-[S, V] ].
statement_ko(made(lpi(S1-(A,B), S2-p(P)))) -->
    [ '세그먼트 ~d의 ~d-~d이(가) 세그먼트 ~d의 다각형 ~d을(를) 뚫어 만들었다'-
      [S1, A, B, S2, P] ].
statement_ko(made(lpi(S1-p(P), Face))) -->
    { triangle_text(Face, Text) },
    [ '세그먼트 ~d의 다각형 ~d 안의 선이 ~w을(를) 뚫어 만들었다'-[S1, P, Text] ].
statement_ko(made(lpi(S1-(A,B), S2-(C,D,E)))) -->
    [ '세그먼트 ~d의 ~d-~d이(가) 세그먼트 ~d의 삼각형 ~d-~d-~d을(를) 뚫어 \c
       만들었다'-[S1, A, B, S2, C, D, E] ].
statement_ko(made(ll(S1-(A,B), S2-(C,D)))) -->
    [ '세그먼트 ~d의 ~d-~d과(와) 세그먼트 ~d의 ~d-~d이(가) 교차하여 만들었다'-
      [S1, A, B, S2, C, D] ].
statement_ko(made(ll(S1-p(P), Place))) -->
    { triangle_text(Place, Text) },
    [ '세그먼트 ~d의 다각형 ~d 안의 선과 ~w이(가) 교차하여 만들었다'-
      [S1, P, Text] ].
statement_ko(made(ll(S1-(A,B), S2-p(P)))) -->
    [ '세그먼트 ~d의 ~d-~d과(와) 세그먼트 ~d의 다각형 ~d 안의 선이 교차하여 \c
       만들었다'-[S1, A, B, S2, P] ].
statement_ko(made(tpi(T1, T2, T3))) -->
    { maplist(triangle_text, [T1,T2,T3], [W1,W2,W3]) },
    [ '세 평면이 만들었다: ~w, ~w, ~w'-[W1, W2, W3] ].
statement_ko(made(Origin)) -->
    { other_origin(Origin) },
    [ '모델에 적힌 대로 ~p에서 만들었다'-[Origin] ].
statement_ko(made(near(Origin))) -->
    [ '허용 오차보다 가까워 닿게 했다: ' ],
    statement_ko(made(Origin)).
statement_ko(at(S, V, Point)) -->
    [ '세그먼트 ~d의 꼭짓점 ~d '-[S, V] ],
    point(Point).
statement_ko(side(S, V, Point, Side, Triangle)) -->
    { triangle_text(Triangle, Text) },
    { memberchk(Side-Word, [above-'위', below-'아래', on-'평면 위']) },
    [ '세그먼트 ~d의 꼭짓점 ~d '-[S, V] ],
    point(Point),
    [ '은(는) ~w의 평면에 대해 ~w에 있다'-[Text, Word] ].
statement_ko(exact(X, Y, Z)) -->
    { maplist(exact_word, [X,Y,Z], [Tx,Ty,Tz]) },
    [ '정확히 (~w, ~w, ~w)'-[Tx, Ty, Tz] ].
statement_ko(also(S, V, Place)) -->
    [ '세그먼트 ~d의 꼭짓점 ~d이기도 하다'-[S, V] ],
    (   { Place = vertex(_) }
    ->  []
    ;   [ '. 그 자리는 ' ],
        place(S, Place),
        [ '이다' ]
    ).
statement_ko(not_merged(L, By)) -->
    [ '거기서 상관선 ~d과(와) 잇지 않았다: merge_line/2 (~w)이(가) 거절했다'-[L, By] ].
statement_ko(made_to_touch) -->
    [ '다각형들이 허용 오차보다 가까워 먼저 닿게 했다' ].
statement_ko(touching(1)) -->
    [ '삼각형 쌍 하나가 거기서 닿는다' ].
statement_ko(touching(N)) -->
    { N \== 1 },
    [ '삼각형 쌍 ~d개가 거기서 닿는다'-[N] ].
statement_ko(pieces(1, _)) -->
    [ '두 삼각형의 조각 하나' ].
statement_ko(pieces(N, By)) -->
    { N \== 1 },
    [ '삼각형의 조각 ~d개를 merge_line/2 (~w)이(가) 하나로 이었다'-[N, By] ].
statement_ko(piece(I, T1, T2)) -->
    { maplist(triangle_text, [T1,T2], [W1,W2]) },
    [ '~d: ~w, ~w'-[I, W1, W2] ].
statement_ko(chain(C, point, _, _)) -->
    [ '한 점인 사슬 ~d'-[C] ].
statement_ko(chain(C, Kind, I, N)) -->
    { memberchk(Kind-Word, [open-'열린', closed-'닫힌']) },
    [ '~w 사슬 ~d의 조각 ~d개 가운데 ~d번째'-[Word, C, N, I] ].
statement_ko(chain_head(C, Kind, S1, S2, N, Length)) -->
    { maplist(segment_word_ko, [S1,S2], [W1,W2]),
      memberchk(Kind-Word, [open-'열림', closed-'닫힘', point-'점']) },
    [ '세그먼트 ~d~w과(와) 세그먼트 ~d~w의 사슬 ~d: ~w'-
      [S1, W1, S2, W2, C, Word] ],
    (   { Kind == point }
    ->  []
    ;   [ ', 조각 ~d개, 길이 ~15g'-[N, Length] ]
    ).
statement_ko(derived(S, V, Point, Place)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 꼭짓점 ~d '-[S, Word, V] ],
    point(Point),
    [ '은(는) ' ],
    place(S, Place),
    [ '에 있다' ].
statement_ko(moved(S, V, Point)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 꼭짓점 ~d '-[S, Word, V] ],
    point(Point),
    [ '은(는) 닿도록 옮긴 것이다' ].
statement_ko(was_at(_, _, Point)) -->
    [ '원래 있던 곳: ' ],
    point(Point).
statement_ko(original(S, V, Point)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 꼭짓점 ~d '-[S, Word, V] ],
    point(Point),
    [ '은(는) 모델에 있던 것이다' ].
statement_ko(vertex_of(S, V)) -->
    [ '세그먼트 ~d의 꼭짓점 ~d이었다'-[S, V] ].
statement_ko(lies_on(S, v(V))) -->
    [ '세그먼트 ~d의 꼭짓점 ~d 위에 있다'-[S, V] ].
statement_ko(lies_on(S, e(E))) -->
    [ '세그먼트 ~d의 모서리 ~d 위에 있다'-[S, E] ].
statement_ko(lies_on(S, p(P))) -->
    [ '세그먼트 ~d의 다각형 ~d 위에 있다'-[S, P] ].
statement_ko(vertex_lines(Ls)) -->
    { atomic_list_concat(Ls, ', ', Text) },
    [ '상관선 ~w의 끝이다'-[Text] ].
statement_ko(edge(S, E, V1, V2)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 모서리 ~d, 꼭짓점 ~d에서 ~d까지'-
      [S, Word, E, V1, V2] ].
statement_ko(edge_whole(_, _)) -->
    [ '모델에 있던 것이다' ].
statement_ko(edge_near(_, _)) -->
    [ '다각형들이 닿도록 만들었다' ].
statement_ko(edge_of_line(_)) -->
    [ '상관선이 만들었다' ].
statement_ko(part_of(_, E, V1, V2)) -->
    [ '꼭짓점 ~d에서 ~d까지였던 모서리 ~d의 부분이다'-[V1, V2, E] ].
statement_ko(edge_polygons(_, Ps)) -->
    { atomic_list_concat(Ps, ', ', Text) },
    [ '다각형 ~w에 있다'-[Text] ].
statement_ko(edge_divided(S, E, V1, V2)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 모서리 ~d은(는) 꼭짓점 ~d에서 ~d까지였고 나뉘었다'-
      [S, Word, E, V1, V2] ].
statement_ko(edge_part(_, E, V1, V2)) -->
    [ '모서리 ~d, 꼭짓점 ~d에서 ~d까지'-[E, V1, V2] ].
statement_ko(segments(S1, S2)) -->
    { segment_word_ko(S1, W1), segment_word_ko(S2, W2) },
    [ '세그먼트 ~d~w과(와) 세그먼트 ~d~w'-[S1, W1, S2, W2] ].
statement_ko(lines_between(N)) -->
    [ '상관선 조각 ~d개가 있다'-[N] ].
statement_ko(same_segment) -->
    [ '상관선 없음: 한 세그먼트는 자신을 자르지 않는다 (check 참고)' ].
statement_ko(refused(S1, S2, By)) -->
    [ '상관선 없음: may_cut(~d, ~d)이(가) 거절했다, 규칙: ~w'-[S1, S2, By] ].
statement_ko(no_common_piece) -->
    [ '상관선 없음: 공통 조각이 있는 두 삼각형이 없다' ].
statement_ko(pair(S1, P1, S2, P2)) -->
    { segment_word_ko(S1, W1), segment_word_ko(S2, W2) },
    [ '세그먼트 ~d~w의 다각형 ~d과(와) 세그먼트 ~d~w의 다각형 ~d'-
      [S1, W1, P1, S2, W2, P2] ].
statement_ko(pair_lines(Ls)) -->
    { atomic_list_concat(Ls, ', ', Text) },
    [ '상관선 ~w을(를) 만든다'-[Text] ].
statement_ko(of_line(L)) -->
    [ '상관선 ~d'-[L] ].
statement_ko(boxes_apart(Axis, High, Low, Lower)) -->
    { memberchk(Lower-Words, [first-['첫째','둘째'],
                        second-['둘째','첫째']]),
      Words = [One,Other] },
    [ '상관선 없음: 둘러싼 상자가 서로 떨어져 있다. ~w은(는) ~w = ~w에서 끝나고 ~w은(는) ~w에서 \c
       시작한다'-
      [One, Axis, High, Other, Low] ].
statement_ko(no_line) -->
    [ '상관선을 만들지 않는다' ].
statement_ko(inside_faces) -->
    [ '공통 부분이 면의 안에 있다. 한 세그먼트에서 한 평면으로 이어지는 \c
       다각형들은 한 면이고, 그 경계만 상관선이 된다' ].
statement_ko(elsewhere(L, S1, P1, S2, P2)) -->
    [ '만나는 곳은 세그먼트 ~d의 다각형 ~d과(와) 세그먼트 ~d의 다각형 ~d의 상관선 \c
       ~d이다. 모서리를 따라가는 선은 한 다각형이 가진다'-[S1, P1, S2, P2, L] ].
statement_ko(triangles_apart(N)) -->
    [ '둘러싼 상자가 떨어져 있는 삼각형 쌍: ~d'-[N] ].
statement_ko(triangles(Reason, N)) -->
    { reason_ko(Reason, Text) },
    [ '~w: ~d'-[Text, N] ].
statement_ko(example(T1, T2)) -->
    { maplist(triangle_text, [T1,T2], [W1,W2]) },
    [ '보기: ~w, ~w'-[W1, W2] ].
statement_ko(piece(S, P)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 다각형 ~d'-[S, Word, P] ].
statement_ko(piece_of(S, P, Sense)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 다각형 ~d의 부분이 있다'-[S, Word, P] ],
    sense(Sense).
statement_ko(polygon_in(S0, P0, S)) -->
    { segment_word_ko(S0, W0), segment_word_ko(S, W) },
    [ '세그먼트 ~d~w 안에서 세그먼트 ~d~w의 다각형 ~d'-[S, W, S0, W0, P0] ].
statement_ko(became(S, P, Sense)) -->
    [ '그 부분이나 전체가 세그먼트 ~d의 다각형 ~d에 있다'-[S, P] ],
    sense(Sense).
statement_ko(triangles_of(N, Verdict)) -->
    { verdict_ko(Verdict, Text) },
    [ '자른 뒤의 삼각형 가운데 ~w 것: ~d개. 가장 큰 것:'-[Text, N] ].
statement_ko(witness(Point)) -->
    [ '증거점은 ' ],
    point(Point).
statement_ko(round(S, Below, Above)) -->
    { segment_word_ko(S, Word),
      maplist(inside_ko, [Below,Above], [B,A]) },
    [ '바로 아래는 세그먼트 ~d~w의 ~w, 바로 위는 ~w'-[S, Word, B, A] ].
statement_ko(verdict(kept(Sense), By)) -->
    [ '남았다' ],
    sense(Sense),
    [ '. 한쪽만 안이기 때문이다 (stays/3, ~w)'-[By] ].
statement_ko(verdict(covered(S), _)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 조각과 같은 곳에 있으며 그 조각이 둘을 대신한다'-
      [S, Word] ].
statement_ko(verdict(dropped, By)) -->
    [ '버렸다. 두 쪽 모두 안이거나 모두 밖이기 때문이다 (stays/3, ~w)'-[By] ].
statement_ko(hidden_line(S, E, V1, V2)) -->
    { segment_word_ko(S, Word) },
    [ '선 s~de~d: 세그먼트 ~d~w의 모서리 ~d, 그림에서 꼭짓점 ~d (0)부터 꼭짓점 ~d \c
       (1)까지'-[S, E, S, Word, E, V1, V2] ].
statement_ko(outline_piece(S, E, P, T)) -->
    { segment_word_ko(S, Word) },
    [ '선 s~de~d: 매끄러운 곡면의 실루엣선 조각, 세그먼트 ~d~w의 다각형 ~d, 삼각형 ~d을(를) \c
       지난다. 그림에서 0부터 1까지'-[S, E, S, Word, P, T] ].
statement_ko(behind_fold(From)) -->
    [ '~6g 부터는 제 곡면이 접힌 곳의 뒤에 있다'-[From] ].
statement_ko(substitute_outline) -->
    [ '매끄러운 곡면의 삼각형들이 여기서부터 뒤를 향한다. 보이고 가까이에 다른 선이 \c
       없는 곳에만 그린다' ].
statement_ko(turned_away(S, P, From, To)) -->
    { segment_word_ko(S, Word) },
    [ '~6g부터 ~6g까지는 세그먼트 ~d~w의 다각형 ~d이(가) 나타내는 매끄러운 곡면이 \c
       눈을 등지고 가린다'-[From, To, S, Word, P] ].
statement_ko(same_line(S1, E1, S2, E2)) -->
    [ '세그먼트 ~d의 모서리 ~d은(는) 세그먼트 ~d의 모서리 ~d(으)로 그려진다'-
      [S1, E1, S2, E2] ].
statement_ko(line_role(Role)) -->
    { role_called(Role, Word) },
    [ '역할: ~w'-[Word] ].
statement_ko(not_drawn(Role, Which)) -->
    { role_called(Role, Word) },
    [ '그리지 않는다: --lines ~w 그림에는 ~w 선이 없다'-[Which, Word] ].
statement_ko(faces_bend(Bend)) -->
    [ '면이 ~6g도 꺾이며, 이는 평평한 것으로 본다'-[Bend] ].
statement_ko(end_on) -->
    [ '선의 방향으로 본다: 그림에서 점이므로 그리지 않는다' ].
statement_ko(backs(S, N)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w은(는) 닫힌 입체이고, 이 선에서 만나는 면 중 눈을 향한 것이 \c
       없다 (뒷면: ~d)'-[S, Word, N] ].
statement_ko(hidden_part(From, To)) -->
    [ '가려진 부분: ~6g부터 ~6g까지'-[From, To] ].
statement_ko(surface_goes_on(S, P, From, To)) -->
    [ '~6g부터 ~6g까지 바로 뒤에서 곡면이 이어진다: 세그먼트 ~d의 다각형 \c
       ~d'-[From, To, S, P] ].
statement_ko(hiding_face(S, P, From, To, Behind)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 다각형 ~d이(가) ~6g부터 ~6g까지 가린다. 가운데에서 ~6g만큼 \c
       눈에 더 가깝다'-[S, Word, P, From, To, Behind] ].
statement_ko(ends_with_line(Which, At)) -->
    which_end(Which, At),
    [ ': 선이 끝나는 곳' ].
statement_ko(ends_at_edge(Which, At, S, E, V1, V2)) -->
    which_end(Which, At),
    [ ': 그림에서 세그먼트 ~d의 모서리 ~d (~d-~d)과(와) 교차하는 곳'-
      [S, E, V1, V2] ].
statement_ko(ends_at_outline(Which, At, S, E)) -->
    which_end(Which, At),
    [ ': 그림에서 세그먼트 ~d의 외형선 (~d)과(와) 교차하는 곳'-[S, E] ].
statement_ko(ends_in_face(Which, At, S, P)) -->
    which_end(Which, At),
    [ ': 선이 세그먼트 ~d의 다각형 ~d을(를) 뚫는 곳'-[S, P] ].
statement_ko(visible_part(From, To)) -->
    [ '보이는 부분: ~6g부터 ~6g까지'-[From, To] ].
statement_ko(nowhere_visible) -->
    [ '보이는 부분이 없다: 무엇이 가리는지는 hidden(...)으로 묻는다' ].
statement_ko(nothing_over) -->
    [ '그림에서 그 위에 놓인, 선을 가릴 수 있는 다른 면이 없다' ].
statement_ko(face_behind(S, P, From, To, Before)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 다각형 ~d이(가) 그림에서 ~6g부터 ~6g까지 겹치지만, 선보다 \c
       뒤에 있다 (가운데에서 ~6g)'-[S, Word, P, From, To, Before] ].
statement_ko(line_in_face(S, P)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 다각형 ~d 위에 놓여 있다: 그 면은 이 선을 가리지 않는다'-
      [S, Word, P] ].
statement_ko(let_through(S, P, From, To, Decision, By)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 다각형 ~d이(가) ~6g부터 ~6g까지 앞에 있지만, ~w (~w) \c
       때문에 비쳐 보인다'-[S, Word, P, From, To, Decision, By] ].
statement_ko(drawn_instead(From, To, Visibility, S, E, Role)) -->
    { segment_word_ko(S, Word) },
    [ '~6g부터 ~6g까지는 그림에서 같은 곳에 있는 세그먼트 ~d~w의 모서리 ~d이(가) \c
       그려진다: ~w, ~w'-[From, To, S, Word, E, Visibility, Role] ].
statement_ko(common(_, End1, End2)) -->
    (   { End1 == End2 }
    ->  [ '공통: 점 ~q'-[End1] ]
    ;   [ '공통: ~q부터 ~q까지'-[End1, End2] ]
    ).
statement_ko(seam_edge(S, E, E2, P1, P2, Length)) -->
    { segment_word_ko(S, Word), maplist(polygon_word(S), [P1,P2], [W1,W2]) },
    [ '세그먼트 ~d~w의 모서리 ~d은(는) 길이 ~6g의 접합선이다: 다각형 ~w과(와) \c
       다각형 ~w 사이, 그쪽에서는 모서리 ~d'-[S, Word, E, Length, W1, W2, E2] ].
statement_ko(fold_edge(S, E, E2, P1, P2, Length, Angle)) -->
    { segment_word_ko(S, Word), maplist(polygon_word(S), [P1,P2], [W1,W2]) },
    [ '세그먼트 ~d~w의 모서리 ~d은(는) 길이 ~6g의 접는 선이다: 다각형 ~w과(와) \c
       다각형 ~w 사이, 그쪽에서는 모서리 ~d, ~6g도 꺾인다'-
      [S, Word, E, Length, W1, W2, E2, Angle] ].
statement_ko(border_edge(S, E, P)) -->
    { segment_word_ko(S, Word), polygon_word(S, P, W) },
    [ '세그먼트 ~d~w의 모서리 ~d은(는) 다각형 ~w의 경계이다: 전개도의 다른 \c
       다각형에는 없다'-[S, Word, E, W] ].
statement_ko(line_in_polygon(S, E, E2, P)) -->
    { segment_word_ko(S, Word), polygon_word(S, P, W) },
    [ '세그먼트 ~d~w의 모서리 ~d은(는) 다각형 ~w 안의 상관선이다. 되돌아오는 \c
       모서리는 ~d'-[S, Word, E, W, E2] ].
statement_ko(joined_already(1, E, Length)) -->
    [ '두 다각형은 길이 ~6g의 모서리 ~d에서 먼저 이어졌다'-[Length, E] ].
statement_ko(joined_already(N, E, Length)) -->
    { N \== 1 },
    [ '두 다각형은 접는 선 ~d개로 이미 이어져 있었다. 가장 짧은 것은 길이 ~6g의 \c
       모서리 ~d'-[N, Length, E] ].
statement_ko(fold_on_the_way(E, P1, P2, Length)) -->
    [ '모서리 ~d, 길이 ~6g, 다각형 ~d과(와) 다각형 ~d 사이'-
      [E, Length, P1, P2] ].
statement_ko(joined_in_order(default)) -->
    [ '평평한 모서리를 먼저, 그다음 긴 모서리부터 잇는다 (join_order/3)' ].
statement_ko(joined_in_order(By)) -->
    { By \== default },
    [ '모서리는 ~w의 순서로 잇는다 (join_order/3)'-[By] ].
statement_ko(folds_exchanged) -->
    [ '그런 다음 전개도 전체의 접합선이 짧아지는 곳마다 접는 선을 다른 것으로 \c
       바꾸었다' ].
statement_ko(cut_instead(E, Difference)) -->
    { by_how_much_ko(Difference, Text) },
    [ '대신 모서리 ~d에서 자르면 접합선 ~w'-[E, Text] ].
statement_ko(kept_instead(Difference, Pieces, Before)) -->
    { by_how_much_ko(Difference, Text), pieces_ko(Pieces, Before, PiecesText) },
    [ '여기를 가장 먼저 이으면 전개도 전체의 접합선은 ~w~w'-[Text, PiecesText] ].
statement_ko(not_tried) -->
    [ '너무 많아 다른 선택은 해 보지 않았다. 이 모서리만 물으면 해 본다' ].
statement_ko(held_by_kept) -->
    [ '이 모서리까지 유지할 수는 없다. 유지할 모서리들이 이미 그 다각형들을 \c
       이어 준다' ].
statement_ko(cut_here(Difference, Pieces, Before)) -->
    { by_how_much_ko(Difference, Text), pieces_ko(Pieces, Before, PiecesText) },
    [ '여기를 자르면 전개도 전체의 접합선은 ~w~w'-[Text, PiecesText] ].
statement_ko(cannot_be_kept(S, P1, P2)) -->
    { maplist(polygon_word(S), [P1,P2], [W1,W2]) },
    [ '유지할 수 없다: 다각형 ~w이(가) 다각형 ~w 위에 놓인다'-[W2, W1] ].
statement_ko(would_overlap(S, P1, P2)) -->
    { maplist(polygon_word(S), [P1,P2], [W1,W2]) },
    [ '여기서 이으면 다각형 ~w이(가) 다각형 ~w 위에 놓였을 것이다'-[W2, W1] ].
statement_ko(would_overlap_instead(S, E, P1, P2)) -->
    { maplist(polygon_word(S), [P1,P2], [W1,W2]) },
    [ '여기를 잇고 대신 모서리 ~d을(를) 자르면 다각형 ~w이(가) 다각형 ~w 위에 \c
       놓인다'-[E, W2, W1] ].
statement_ko(cut_by_wish) -->
    [ '자르라고 했다 (unfolding/2, --cut)' ].
statement_ko(could_be_joined) -->
    [ '이어도 되는 곳이다: 자르라고 했거나 규칙이 거절했다' ].
statement_ko(cut_open(Part)) -->
    { surface_named(Part, Word) },
    [ '~w은(는) 둥근 면 그대로 펼친다. 한 바퀴를 돌면 면소 하나를 따라 \c
       자른다. 정하지 않으면(--seam, --cut) 가장 짧은 면소이다'-[Word] ].
statement_ko(unrolled(Part)) -->
    { surface_named(Part, Word) },
    [ '~w은(는) 둥근 면 그대로 펼친다: 그 면들은 둘레의 차례대로 이어져 있다'-
      [Word] ].
statement_ko(kept_by_wish) -->
    [ '유지하라고 했다 (unfolding/2, --keep)' ].
statement_ko(may_not_join(S, E, By)) -->
    [ 'may_join(~d, ~d)이(가) ~w의 규칙으로 거절했다'-[S, E, By] ].
statement_ko(no_length) -->
    [ '두 다각형을 이을 길이가 없다' ].
statement_ko(too_short) -->
    [ '너무 짧다. 거기에 매달릴 부분이 2,048배보다 길다' ].
statement_ko(changed_since) -->
    [ '전개도를 만든 뒤에 세그먼트가 바뀌어 까닭을 더는 알 수 없다' ].
statement_ko(pattern_piece(S, _, N, 1)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 전개도는 조각 하나이다: 다각형 ~d개'-[S, Word, N] ].
statement_ko(pattern_piece(S, K, N, Pieces)) -->
    { Pieces \== 1 },
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w의 조각 ~d개 가운데 ~d번: 다각형 ~d개'-
      [S, Word, Pieces, K, N] ].
statement_ko(seams_out(1)) -->
    [ '접합선 하나가 다른 조각으로 이어진다' ].
statement_ko(seams_out(N)) -->
    { N \== 1 },
    [ '접합선 ~d개가 다른 조각으로 이어진다. 가장 긴 것:'-[N] ].
statement_ko(no_seam_out) -->
    [ '다른 조각으로 이어지는 모서리가 없다' ].
statement_ko(Statement) -->
    parameter_statement_ko(Statement).
statement_ko(Statement) -->
    pixel_statement_ko(Statement).
statement_ko(Statement) -->
    glue_statement_ko(Statement).

%!  hidden_ko(+What)// is det.
%
%   What is said where no line of the picture was asked for.

hidden_ko(nothing(Item)) -->
    [ '~p: 설명할 것이 없습니다'-[Item], nl,
      '  hidden(S, E)는 세그먼트 S의 실제 모서리 E이고 (그림의 data-segment, \c
       data-edge), hidden(s1e7)은 그림에 쓰인 id입니다. Prolog에서는 먼저 \c
       picture나 draw(File)로 그림을 만드십시오.' ].

which_end(from, At) -->
    [ '~6g부터'-[At] ].
which_end(to, At) -->
    [ '~6g까지'-[At] ].

sense(1) -->
    [].
sense(-1) -->
    [ ' (뒤집힘)' ].

%   surface_named(Part, Word): the name of a surface of a primitive.

surface_named(Leaf/Part, Word) :-
    !,
    surface_named(Part, Own),
    format(atom(Word), '~w/~w', [Leaf,Own]).
surface_named(side, '옆면(side)') :- !.
surface_named(inner, '안쪽(inner)') :- !.
surface_named(outer, '바깥쪽(outer)') :- !.
surface_named(Part, Part).

%   role_called(Role, Word): with the name that styles and data have.

role_called(penetration, '상관선(penetration)') :- !.
role_called(outline, '외형선(outline)') :- !.
role_called(crease, '꺾인선(crease)') :- !.
role_called(border, '경계 모서리(border)') :- !.
role_called(curve, '곡선(curve)') :- !.
role_called(section, '단면선(section)') :- !.
role_called(smooth, '매끄러운 모서리(smooth)') :- !.
role_called(mesh, '평평한 모서리(mesh)') :- !.
role_called(Role, Role).

verdict_ko(kept(_), '남은').
verdict_ko(dropped, '버린').
verdict_ko(covered(_), '다른 조각과 같은 곳에 있는').

inside_ko(N, Word) :-
    (   N > 0
    ->  Word = '안'
    ;   Word = '밖'
    ).

reason_ko(one_side(first),
          '첫째 삼각형이 모두 둘째 평면의 한쪽에 있다').
reason_ko(one_side(second),
          '둘째 삼각형이 모두 첫째 평면의 한쪽에 있다').
reason_ko(intervals_apart,
          '서로의 평면을 지나지만 같은 곳이 아니다').
reason_ko(coplanar_apart, '한 평면에서 떨어져 있다').
reason_ko(coplanar_inside, '한 평면에서 경계가 서로의 안에 있다').
reason_ko(point_alone, '점 하나에서만 닿는다').
reason_ko(common_piece, '공통 조각이 있다').

%   place(+S, +Place)//: a feature of segment S.

place(S, vertex(V)) -->
    [ '세그먼트 ~d의 꼭짓점 ~d'-[S, V] ].
place(S, edge(A, B)) -->
    [ '세그먼트 ~d의 모서리 ~d-~d'-[S, A, B] ].
place(S, face(P, Corners)) -->
    [ '세그먼트 ~d의 다각형 ~d'-[S, P] ],
    corners(Corners).

corners(triangle(A, B, C)) -->
    [ ' (그 삼각형 ~d-~d-~d 안)'-[A, B, C] ].
corners(diagonal(A, B)) -->
    [ ' (그 대각선 ~d-~d 위)'-[A, B] ].
corners(none) -->
    [].

point(Point) -->
    { point_text(Point, Text) },
    [ '~w'-[Text] ].

triangle_text(S-p(P), Text) :-
    format(atom(Text), '세그먼트 ~d의 다각형 ~d', [S, P]).
triangle_text(S-(A,B), Text) :-
    integer(B),
    format(atom(Text), '세그먼트 ~d의 ~d-~d', [S, A, B]).
triangle_text(S-(A,B,C), Text) :-
    format(atom(Text), '세그먼트 ~d의 삼각형 ~d-~d-~d', [S, A, B, C]).

%   A rational as people write it; of a long one, how long it is.

exact_word(X, Text) :-
    exact_text(X, Length, Text0),
    (   Length =< 60
    ->  Text = Text0
    ;   format(atom(Text), '~d자리 분수', [Length])
    ).

%   by_how_much_ko(Difference, Text): of a seam beside another one.

by_how_much_ko(Difference, Text) :-
    (   is_rounding(Difference, 1.0)
    ->  Text = '길이가 같다'
    ;   Difference > 0
    ->  format(atom(Text), '~6g만큼 길다', [Difference])
    ;   Less is -Difference,
        format(atom(Text), '~6g만큼 짧다', [Less])
    ).

pieces_ko(Pieces, Pieces, '') :-
    !.
pieces_ko(Pieces, Before, Text) :-
    format(atom(Text), ', 조각은 ~d개가 아니라 ~d개', [Before, Pieces]).
