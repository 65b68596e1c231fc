:- encoding(utf8).
:- module(sg_explain_pixel_ko,
          [ pixel_statement_ko//1,      % +Statement
            pixel_nothing_ko//1         % +Item
          ]).
:- use_module(explain_words, [bytes_word/2, segment_word_ko/2]).
/** <module> Explanations of shaded pictures in Korean; explain_pixel_en.pl has
them in English.
*/

%!  pixel_statement_ko(+Statement)// is semidet.
%
%   A statement of explain_pixel.pl in Korean.

pixel_statement_ko(pixel(X, Y, Bytes)) -->
    { bytes_word(Bytes, Word) },
    [ '왼쪽 위에서 0부터 세어 ~d번째 점, ~d번째 행: ~w'-[X, Y, Word] ].
pixel_statement_ko(seen_part(Percent, Face, Leaf, S, Name, R)) -->
    { leaf(Leaf, S, Name, Word), root(R, Root) },
    [ '그 ~4g %에 보이는 면: ~w의 ~w의 ~p'-[Percent, Root, Word, Face] ].
pixel_statement_ko(background_part(Percent, Colour)) -->
    [ '그 ~4g %에 보이는 것: 바탕, ~p'-[Percent, Colour] ].
pixel_statement_ko(seen_place(point(X,Y,Z))) -->
    [ '그 부분의 가운데에서 모델의 점 (~6g, ~6g, ~6g)'-[X, Y, Z] ].
pixel_statement_ko(placed_as(N)) -->
    { root(N, Word) },
    [ '놓인 곳: ~w'-[Word] ].
pixel_statement_ko(operand_of(I, Count, Operation, N, Away)) -->
    { of_node(Operation, N, Word) },
    [ '~w의 피연산자 ~d개 가운데 ~d번째'-[Word, Count, I] ],
    (   { Away == taken_away }
    ->  [ ', 빼내는 것이다' ]
    ;   []
    ).
pixel_statement_ko(inner_side) -->
    [ '시선이 거기서 리프 밖으로 나온다. 리프의 안쪽이 보인다' ].
pixel_statement_ko(owner(By)) -->
    { chosen_by(By, Why) },
    [ '다른 면이 이 면과 겹쳐 있다. ~w 이 면이 보인다'-[Why] ].
pixel_statement_ko(not_owner(Face, Leaf, S, Name)) -->
    { leaf(Leaf, S, Name, Word) },
    [ '보이지 않는 면: ~w의 ~p'-[Word, Face] ].
pixel_statement_ko(passed(Way, Face, Leaf, S, Name, Before)) -->
    { leaf(Leaf, S, Name, Word),
      memberchk(Way-Does, [enters-'안으로 들어간다', leaves-'밖으로 나온다']) },
    [ '~6g만큼 앞에서 시선이 ~w의 ~p을(를) 지나 ~w'-
      [Before, Word, Face, Does] ].
pixel_statement_ko(outside_all(Operation, N, Count, R)) -->
    { of_node(Operation, N, Word), root(R, Root) },
    [ '~w은(는) 아직 없다. ~w의 피연산자 ~d개 모두의 밖이다'-
      [Root, Word, Count] ].
pixel_statement_ko(taken_away(J, Operation, N, R)) -->
    { of_node(Operation, N, Word), root(R, Root) },
    [ '~w은(는) 아직 없다. ~w의 ~d번째 피연산자가 빼낸다'-[Root, Word, J] ].
pixel_statement_ko(outside_leaf(Leaf, S, Name, R)) -->
    { leaf(Leaf, S, Name, Word), root(R, Root) },
    [ '~w은(는) 아직 없다. ~w의 밖이다'-[Root, Word] ].
pixel_statement_ko(lets_through(R)) -->
    { root(R, Root) },
    [ '~w은(는) 거기에 있고, 뒤에서 오는 빛이 지나간다'-[Root] ].
pixel_statement_ko(let_through(R, By)) -->
    { root(R, Root) },
    [ '~w은(는) 거기에 있지만, may_hide/2(~w)에 따라 뒤에 있는 것이 보인다'-
      [Root, By] ].
pixel_statement_ko(cut_away(R)) -->
    { root(R, Root) },
    [ '~w은(는) 거기에 없다. 평면이 잘라 낸다'-[Root] ].
pixel_statement_ko(see_through(A)) -->
    [ '반투명하다. 빛 가운데 ~4g만 자신의 것이다'-[A] ].
pixel_statement_ko(shine(F, N, Added)) -->
    [ 'shine(~w, ~w)이(가) 흰 빛 ~5g을(를) 더한다'-[F, N, Added] ].
pixel_statement_ko(hatched) -->
    [ '단면이므로 해칭한다. 넷 가운데 하나가 어둡다' ].
pixel_statement_ko(hidden_face(Face, Leaf, S, Name, R, Behind)) -->
    { leaf(Leaf, S, Name, Word), root(R, Root) },
    [ '~6g만큼 뒤에 있는 ~w의 ~w의 ~p을(를) 가린다'-
      [Behind, Root, Word, Face] ].
pixel_statement_ko(look_by_rule(Colour, By)) -->
    [ '색은 ~p: ~w의 surface_look/4에 따른다'-[Colour, By] ].
pixel_statement_ko(dot_by_rule(By)) -->
    [ '점의 색은 ~w의 pixel_colour/4가 답한 것이고, 답이 없으면 이 부분들의 합이다'-
      [By] ].
pixel_statement_ko(nearest_of_palette(Most)) -->
    [ '많아야 ~d가지인 팔레트의 색 가운데 가장 가까운 것이다'-[Most] ].
pixel_statement_ko(look_of(N, Colour)) -->
    { root(N, Word) },
    [ '색은 ~p: 색이 있는 것 가운데 가장 가까운 ~w의 look/2에 따른다'-
      [Colour, Word] ].
pixel_statement_ko(look_of_palette(Colour, By)) -->
    { memberchk(By-Which, [root-'루트별', leaf-'리프별']) },
    [ '색은 ~p: ~w 기본 색이다. look/2로 정한 색이 없다'-[Colour, Which] ].
pixel_statement_ko(normal(Right, Up, Towards)) -->
    [ '법선은 오른쪽으로 ~4g, 위로 ~4g, 눈 쪽으로 ~4g'-[Right, Up, Towards] ].
pixel_statement_ko(tone(Tone, By)) -->
    [ '명암은 ~5g'-[Tone] ],
    by_rule('tone/3', By).
pixel_statement_ko(light_from_everywhere(Strength)) -->
    [ '사방에서 오는 빛 ~5g'-[Strength] ].
pixel_statement_ko(light_from(Right, Up, Towards, Factor, Share)) -->
    [ '(~4g, ~4g, ~4g) (오른쪽, 위, 눈 쪽)에서 오는 세기 ~4g의 빛 ~5g'-
      [Right, Up, Towards, Factor, Share] ].
pixel_statement_ko(light_stopped(Percent, Face, Leaf, S, Name, R)) -->
    { leaf(Leaf, S, Name, Word), root(R, Root) },
    [ '그 ~4g %는 ~w의 ~w의 ~p에 막힌다'-[Percent, Root, Word, Face] ].
pixel_statement_ko(ramp(Shade, By, Bytes)) -->
    { bytes_word(Bytes, Word) },
    [ '그 명암에서 ~w, 음영 ~p'-[Word, Shade] ],
    by_rule('ramp/3', By).
pixel_statement_ko(not_in_picture(S, Kind)) -->
    { segment_word_ko(S, Word) },
    (   { Kind == solid }
    ->  [ '세그먼트 ~d~w: 그림에 나오는 어느 것에도 들어 있지 않다'-[S, Word] ]
    ;   { memberchk(Kind-KindKo, [surface-'곡면', curve-'곡선']) },
        [ '세그먼트 ~d~w: ~w이다. 음영은 입체와 곡면에만 준다'-[S, Word, KindKo] ]
    ).
pixel_statement_ko(seen_after_all(S, Dots, X, Y)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w: 약 ~d개의 점에 보인다. 그 하나는 pixel(~d, ~d)'-
      [S, Word, Dots, X, Y] ].
pixel_statement_ko(unseen(S)) -->
    { segment_word_ko(S, Word) },
    [ '세그먼트 ~d~w: 보이는 곳이 없다'-[S, Word] ].
pixel_statement_ko(unseen_where(Count, X, Y)) -->
    [ '물어본 곳 가운데 ~d곳, 그 하나는 pixel(~d, ~d)'-[Count, X, Y] ].
pixel_statement_ko(hidden_by_leaf(Leaf, S, Name, R)) -->
    { leaf(Leaf, S, Name, Word), root(R, Root) },
    [ '가리는 것: ~w의 ~w'-[Root, Word] ].
pixel_statement_ko(owned_by_face(Face, Leaf, S, Name, R, By)) -->
    { leaf(Leaf, S, Name, Word), root(R, Root), chosen_by(By, Why) },
    [ '~w의 ~w의 ~p이(가) 겹쳐 있고, ~w 그 면이 보인다'-
      [Root, Word, Face, Why] ].
pixel_statement_ko(buried_in(R)) -->
    { root(R, Root) },
    [ '그 면의 앞도 뒤도 ~w의 안이다'-[Root] ].
pixel_statement_ko(back_side(R)) -->
    { root(R, Root) },
    [ '~w이(가) 끝나는 뒷면이다'-[Root] ].
pixel_statement_ko(thinner_than_a_dot) -->
    [ '거기서 가장 가깝지만 그림에 나타나기에는 너무 얇다' ].
pixel_statement_ko(out_of_the_picture) -->
    [ '그림의 틀 안에 그 면이 없다' ].

%!  pixel_nothing_ko(+Item)// is det.
%
%   What is said where the picture has no such dot, or the model no such
%   segment.

pixel_nothing_ko(Item) -->
    [ '~p: 설명할 것이 없습니다'-[Item], nl,
      '  pixel(X, Y)는 같은 옵션으로 render가 만드는 그림에서 0부터 센 행 Y의 \c
       점 X입니다. why_not(seen(S))의 S는 모델의 세그먼트입니다.' ].

leaf(Leaf, 0, Name, Word) :-
    !,
    format(atom(Word), '리프 ~d (~w)', [Leaf, Name]).
leaf(Leaf, S, Name, Word) :-
    format(atom(Word), '리프 ~d (~w, 세그먼트 ~d)', [Leaf, Name, S]).

root(R, Word) :-
    segment_word_ko(R, Own),
    format(atom(Word), '세그먼트 ~d~w', [R, Own]).

of_node(Operation, 0, Word) :-
    !,
    format(atom(Word), '연산 ~w', [Operation]).
of_node(Operation, N, Word) :-
    root(N, Own),
    format(atom(Word), '연산 ~w ~w', [Operation, Own]).

%   chosen_by(By, Why): by whom owner/3 is said.

chosen_by(default, '리프 순서로') :-
    !.
chosen_by(By, Why) :-
    format(atom(Why), '~w의 owner/3에 따라', [By]).

by_rule(_, default) -->
    !.
by_rule(Decision, By) -->
    [ ', ~w의 ~w에 따른다'-[By, Decision] ].
