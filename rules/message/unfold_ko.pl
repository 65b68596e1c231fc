:- encoding(utf8).
:- module(sg_unfold_ko,
          [ wish_ko//3,                 % +S, +Wish, +What
            unfold_ko//1,               % +What
            trim_ko//1                  % +What
          ]).
:- use_module(true_ko, [kind_word/2, segment_kind_word/2]).
:- use_module(unfold_en, [known_polygons_listed//2, known_segments/2]).
:- use_module('../unfolding/unfold_wish', [all_forms/1]).
/** <module> What is wrong with an unfolding, in Korean.

unfold_en.pl has the same heads in English.
*/

%!  wish_ko(+S, +Wish, +What)// is det.
%
%   The message for unfold(S, Wish, What), as of unfold_wish.pl.

wish_ko(S, Wish, What) -->
    [ '세그먼트 ~d: ~p 지정대로 전개할 수 없습니다: '-[S, Wish] ],
    wish_fault_ko(What).

wish_fault_ko(no_segment) -->
    [ '그런 세그먼트가 없습니다' ].
wish_fault_ko(unknown_wish) -->
    { all_forms(Forms),
      atomic_list_concat(Forms, ', ', All) },
    [ '그런 지정은 없습니다', nl, '  쓸 수 있는 것: ~w.'-[All] ].
wish_fault_ko(form(Form)) -->
    [ '~w 꼴이어야 합니다'-[Form], nl,
      '  다각형은 번호나 base, side(2) 같은 이름이고, 모서리는 번호, \c
       base-side(2) 같은 두 다각형, 또는 양 끝 v(1)-v(2)입니다.' ].
wish_fault_ko(how_form(Form)) -->
    [ '~w 꼴이어야 합니다'-[Form] ].
wish_fault_ko(twice(Other)) -->
    [ '같은 세그먼트에 unfolding/2 사실이 ~p도 지정합니다'-[Other], nl,
      '  둘 중 하나를 지우십시오.' ].
wish_fault_ko(needs(Form)) -->
    [ '~w 없이는 아무 뜻이 없습니다'-[Form], nl,
      '  모델이나 옵션에서 함께 지정하십시오.' ].
wish_fault_ko(no_polygon(Name, Ps, Names)) -->
    [ '다각형 ~p: 없습니다'-[Name], nl, '  있는 것: ' ],
    known_polygons_listed(Ps, Names).
wish_fault_ko(several(Name, Faces)) -->
    [ '~p: 다각형 하나가 아닙니다: '-[Name] ],
    faces_ko(Faces).
wish_fault_ko(no_edge(Name)) -->
    [ '모서리 ~p: 없습니다'-[Name] ].
wish_fault_ko(apart(Name1, Name2, Face, Faces)) -->
    [ '~p, ~p: 함께 가진 모서리가 없습니다'-[Name1, Name2], nl, '  ' ],
    face_ko(Face),
    [ '의 이웃: ' ],
    faces_ko(Faces).
wish_fault_ko(border(E, Face)) -->
    face_ko(Face),
    [ '의 모서리 ~d은(는) 짝이 없어, 잇거나 자를 것이 없습니다'-[E] ].
wish_fault_ko(cut_and_keep(E, Face1, Face2)) -->
    two_ko(Face1, Face2),
    [ ' 사이의 모서리 ~d을(를) 자르라고도(--cut) 이으라고도(--keep) 했습니다'-[E] ].
wish_fault_ko(two_roots(Face1, Face2)) -->
    [ '기준면은 하나여야 합니다: ' ],
    two_ko(Face1, Face2).
wish_fault_ko(removed_root(Face)) -->
    [ '기준면 ' ],
    face_ko(Face),
    [ '을(를) 빼라고 했습니다' ].
wish_fault_ko(removed_all) -->
    [ '다각형을 모두 빼면 남는 것이 없습니다' ].
wish_fault_ko(removed_keep(E, Face)) -->
    [ '모서리 ~d을(를) 이을 수 없습니다: '-[E] ],
    face_ko(Face),
    [ '을(를) 빼라고 했습니다' ].
wish_fault_ko(order_removed(Face)) -->
    face_ko(Face),
    [ '을(를) 빼라고 했습니다' ].
wish_fault_ko(order_twice(Face)) -->
    face_ko(Face),
    [ '이(가) 두 번 있습니다' ].
wish_fault_ko(order_root(Root, First)) -->
    [ '기준면은 ' ],
    face_ko(Root),
    [ '인데 차례는 ' ],
    face_ko(First),
    [ '에서 시작합니다' ].
wish_fault_ko(order_apart(Face, Before)) -->
    face_ko(Face),
    [ '은(는) 앞의 것들과 함께 가진 모서리가 없습니다: ' ],
    faces_ko(Before).
wish_fault_ko(order_cut(Face, Before)) -->
    face_ko(Face),
    [ '와(과) 앞의 것들 사이의 모서리를 모두 자르라고 했습니다: ' ],
    faces_ko(Before).
wish_fault_ko(ring(E, Face1, Face2)) -->
    two_ko(Face1, Face2),
    [ ' 사이의 모서리 ~d까지 이으면 루프가 되어 평평하게 놓을 수 없습니다'-[E] ].

two_ko(Face1, Face2) -->
    face_ko(Face1),
    [ '와(과) ' ],
    face_ko(Face2).

face_ko(face(P, Name)) -->
    (   { Name == P }
    ->  [ '다각형 ~d'-[P] ]
    ;   [ '다각형 ~d (~p)'-[P, Name] ]
    ).

faces_ko(Faces) -->
    listed_ko(Faces, 12).

listed_ko([], _) -->
    [ '없음' ].
listed_ko([Face], _) -->
    !,
    face_ko(Face).
listed_ko(Faces, 0) -->
    !,
    { length(Faces, N) },
    [ '그 밖에 ~D개'-[N] ].
listed_ko([Face|Faces], N) -->
    face_ko(Face),
    [ ', ' ],
    { N1 is N-1 },
    listed_ko(Faces, N1).

%!  unfold_ko(+What)// is det.
%
%   The message for unfold(What), of an error or a notice.

unfold_ko(nothing_to_unfold) -->
    [ '전개할 것이 없습니다: 모델에 입체도 곡면도 없습니다' ].
unfold_ko(no_segment(Name, Known)) -->
    { known_segments(Known, All) },
    [ '세그먼트 ~p: 없습니다. 있는 것: ~w'-[Name, All] ].
unfold_ko(kind(S, Kind)) -->
    { segment_kind_word(Kind, Word) },
    [ '세그먼트 ~d은(는) ~w(이)라 전개할 면이 없습니다'-[S, Word] ].
unfold_ko(which_segment(Option, Known)) -->
    { atomic_list_concat(Known, ', ', All) },
    [ '~w 옵션은 한 세그먼트에 대한 것인데 여럿을 전개합니다: ~w'-
      [Option, All], nl, '  --only 옵션으로 하나를 고르십시오.' ].
unfold_ko(no_term(Option, Text)) -->
    [ '~w 옵션: 읽을 수 없습니다: ~w'-[Option, Text], nl,
      '  다각형은 번호나 base, side(2) 같은 이름, 모서리는 4-7, base-side(2), \c
       v(1)-v(2)이며 쉼표로 나눕니다.' ].
unfold_ko(no_names(Option, Text)) -->
    [ '~w 옵션: 읽을 수 없습니다: ~w'-[Option, Text], nl,
      '  세그먼트는 번호나 이름이며 쉼표로 나눕니다. 글자가 아닌 것이 든 이름은 \c
       "\'a b\'" 처럼 따옴표 안에 따옴표로 씁니다.' ].
unfold_ko(several_sheets(N)) -->
    [ '도면이 ~D장이라 표준 출력에 쓸 수 없습니다'-[N], nl,
      '  여러 장을 담는 .pdf나 파일에 쓰십시오.' ].
unfold_ko(needs(Option, Needed)) -->
    [ '~w 옵션은 ~w 옵션 없이는 쓰이지 않습니다'-[Option, Needed], nl,
      '  ~w 옵션도 주십시오.'-[Needed] ].
unfold_ko(no_table(File)) -->
    [ '~w 파일을 쓰지 않았습니다. 면소가 있는 전개도가 없습니다'-[File], nl,
      '  --true로 펼친 원기둥, 원뿔, 변환관에 있습니다.' ].
unfold_ko(all_trimmed_away) -->
    [ '모든 세그먼트가 다 잘려 나가 남는 것이 없습니다' ].
unfold_ko(crosses_itself(S, P)) -->
    [ '세그먼트 ~d: 다각형 ~d의 변이 서로 교차하여 전개도에서 빠지게 됩니다'-[S, P], nl,
      '  모델에서 고치거나, 일부러 빼려면 --remove ~d을(를) 쓰십시오.'-[P]
    ].
unfold_ko(outline_unrolled(S, P)) -->
    [ '세그먼트 ~d: 다각형 ~d의 실제 윤곽이 서로 교차하여 전개도에서 빠지게 됩니다'-[S, P], nl,
      '  그것이나 그것을 자르는 것의 facets(N)을 바꾸거나, --true 없이 전개하십시오.' ].
unfold_ko(outline_crosses(S, N)) -->
    [ '세그먼트 ~d: 이 판재로 굽히면 전개도에서 면들이 겹칩니다: 절단선이 ~D번 \c
       교차합니다'-[S, N], nl,
      '  다른 모서리를 자르거나 --thickness나 --bend-radius를 줄이십시오.' ].
unfold_ko(alone(S)) -->
    [ '세그먼트 ~d은(는) 다른 것과 만나지 않아 잘라 낼 것이 없습니다'-[S] ].
unfold_ko(attached(S, Welded, Divided)) -->
    [ '세그먼트 ~d: 전개도를 위해 같은 자리의 꼭짓점 ~D개를 합치고, 일부만 \c
       맞닿는 모서리 ~D개를 나누었습니다'-[S, Welded, Divided] ].
unfold_ko(root_gone(S, face(P, Name))) -->
    [ '세그먼트 ~d: 기준면 '-[S] ],
    face_ko(face(P, Name)),
    [ '이(가) 잘려 나갔습니다' ].
unfold_ko(not_developable(S, Kind, N)) -->
    { kind_word(Kind, Word) },
    [ '세그먼트 ~d: ~w 면은 전개할 수 없어 --true로 펴지 않습니다. 그 조각 ~D개를 \c
       있는 그대로 평면에 놓습니다'-[S, Word, N], nl,
      '  모델에서 facets(...)를 늘리면 더 가까워집니다.' ].
unfold_ko(nearly_touching(S, By)) -->
    [ '세그먼트 ~d의 옆면이 세그먼트 ~d에 거의 접합니다. 거기서 선이 어떻게 만나는지는 작은 \c
       면으로 정했으므로 틀릴 수 있습니다'-[S, By], nl,
      '  --chord를 줄이면 작은 면이 더 촘촘해집니다.' ].
unfold_ko(nothing_unrolled) -->
    [ '편 것이 없습니다. 모델에 원기둥, 원뿔, 변환관, 구가 없고 평면은 이미 \c
       펴져 있습니다'-[], nl,
      '  --true 없이도 전개도가 같습니다.' ].
unfold_ko(mitre_not_set_in(S)) -->
    [ '세그먼트 ~d: 꽂기(--set-in)로 하지 않습니다. 반지름이 같은 관은 판재의 가운데끼리 \c
       마이터 이음으로 만납니다'-[S], nl,
      '  --set-in은 주관보다 가는 지관에 쓰십시오.' ].
unfold_ko(mitre_by_middles(S)) -->
    [ '세그먼트 ~d: --other-thickness는 아무것도 바꾸지 않습니다. 반지름이 같은 관은 \c
       판재의 가운데끼리 만나고, 치수도 가운데를 기준으로 합니다'-[S], nl,
      '  --size outside나 inside에서는 다른 관의 치수를 정합니다.' ].
unfold_ko(no_sphere(Option)) -->
    [ '~w 옵션은 뜻이 없습니다. 편 구가 없습니다'-[Option] ].
unfold_ko(no_bend(Option)) -->
    [ '~w 옵션은 뜻이 없습니다. 굽힘이 있는 전개도가 없습니다'-[Option] ].
unfold_ko(kept_apart(S, N)) -->
    [ '세그먼트 ~d: 모서리 ~D개를 이을 수 없습니다. 한쪽은 말린 것을 펴고 다른 \c
       쪽은 평평하여 따로 전개합니다'-[S, N] ].
unfold_ko(not_kept(S, E, Face1, Face2, Why)) -->
    [ '세그먼트 ~d: '-[S] ],
    two_ko(Face1, Face2),
    [ ' 사이의 모서리 ~d을(를) 이을 수 없습니다: '-[E] ],
    not_kept_ko(Why).

not_kept_ko(overlap) -->
    [ '전개도가 겹칩니다' ].
not_kept_ko(same_piece) -->
    [ '다른 길로 이미 이어졌습니다' ].

%!  trim_ko(+What)// is det.
%
%   The message for trim(What).

trim_ko(nothing_left(S, outside)) -->
    [ '세그먼트 ~d은(는) 모두 다른 것의 안에 있어 남는 것이 없습니다'-[S] ].
trim_ko(nothing_left(S, inside)) -->
    [ '세그먼트 ~d은(는) 모두 다른 것의 밖에 있어 남는 것이 없습니다'-[S] ].
trim_ko(kind(S, Kind)) -->
    { segment_kind_word(Kind, Word) },
    [ '세그먼트 ~d은(는) ~w(이)라 잘라 낼 수도, 다른 것을 자를 수도 \c
       없습니다'-[S, Word] ].
trim_ko(open(S, V1, V2)) -->
    [ '세그먼트 ~d은(는) 열려 있어 안쪽을 알 수 없습니다'-[S], nl,
      '  평평한 끝은 막아서 보지만, 꼭짓점 ~d에서 ~d(으)로 가는 경계는 평평하지 \c
       않습니다.'-[V1, V2] ].
