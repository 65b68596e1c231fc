:- encoding(utf8).
:- module(sg_part_glue_ko,
          [ part_glue_ko//1            % +What
          ]).
/** <module> Korean for what is glued, or unglued, in part.

Faults geometry_error(part_glue(What)) of rules/gluing.
*/

%!  part_glue_ko(+What)// is semidet.

part_glue_ko(disks_cross(S, V, D1, D2)) -->
    [ '세그먼트 ~d: disk_relation/3에 따르면 꼭짓점 ~d번의 원반 ~d번과 ~d번이 \c
       서로를 뚫고 지나갑니다'-[S, V, D1, D2], nl,
      '  먼저 자르거나 다른 --rules를 쓰십시오.' ].
part_glue_ko(unglued(S, Item)) -->
    unglued_ko(Item, S).
part_glue_ko(one_cells(N)) -->
    [ '뗄 모델에 세포가 ~D개 있습니다'-[N], nl,
      '  --region, --face, --between은 하나의 것입니다: 그 파일만 주십시오.' ].
part_glue_ko(not_glued(S, Item1, Item2, Why)) -->
    [ '세그먼트 ~d: ~p와(과) ~p을(를) 붙이지 않았습니다: '-[S, Item1, Item2] ],
    not_glued_ko(Why).
part_glue_ko(euler_change(S, Operation, Change)) -->
    [ '세그먼트 ~d: ~p의 결과 ~p은(는) 그 연산의 변화가 아니어서 아무것도 바꾸지 \c
       않았습니다'-[S, Operation, Change], nl,
      '  만드는 것이 다른 것과 만납니다: 먼저 그것을 붙이십시오.' ].

part_glue_ko(wish(S, Wish)) -->
    [ 'gluing(~d, ~p)은(는) 붙인 것 ~d에 있는 것을 가리키지 않습니다'-
      [S, Wish, S], nl,
      '  only(vertices), only(edges), only(faces), apart(S1, S2), \c
       apart(S1-Item), glued(S1-Item1, S2-Item2), dissolve(R1, R2), \c
       tolerance(T) 가운데 하나를 쓰십시오. Item은 피연산자의 v(V), e(A,B), \c
       p(P)이고, R1과 R2는 맞닿은 유한한 영역으로, 번호나 \c
       region(피연산자들)로 쓰며, T는 0 이상입니다.' ].
part_glue_ko(no_side(S)) -->
    [ '세그먼트 ~d: 떨어져 있는 것이 면 위에 놓여 있어 그 면의 어느 쪽인지 알 \c
       수 없습니다'-[S], nl,
      '  어딘가에서 그 면에 붙게 하십시오.' ].

unglued_ko(p(P), S) -->
    [ '세그먼트 ~d의 다각형 ~d번은 두 세포 사이에 있지 않아 뗄 수 없습니다'-
      [S, P], nl,
      '  cells --neighbours로 어느 영역들 사이에 면이 있는지 보십시오.' ].
unglued_ko(r(R), S) -->
    [ '세그먼트 ~d의 영역 ~d번은 세포가 아니어서 뗄 수 없습니다'-[S, R], nl,
      '  cells로 세포를 보십시오.' ].
unglued_ko(R1-R2, S) -->
    [ '세그먼트 ~d에는 영역 ~d번과 ~d번 사이에 다각형이 없습니다'-
      [S, R1, R2], nl,
      '  cells --neighbours로 어느 영역들 사이에 면이 있는지 보십시오.' ].

not_glued_ko(apart) -->
    [ '한자리에 있지 않습니다' ].
not_glued_ko(beside) -->
    [ '첫째가 둘째 안에 있지 않습니다' ].
not_glued_ko(crossing) -->
    [ '그곳의 것들이 서로를 뚫고 지나갑니다 (disk_relation/3)', nl,
      '  먼저 자르십시오.' ].
not_glued_ko(touching) -->
    [ '두 쪽의 모서리가 한 방향으로 나갑니다', nl,
      '  그 모서리들이나 면을 붙이십시오.' ].
