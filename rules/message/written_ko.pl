:- encoding(utf8).
:- module(sg_written_ko,
          [ written_ko//1,              % +What
            unwritten_ko//1             % +What
          ]).
/** <module> Messages about solids written to files, in Korean.
*/

%!  written_ko(+What)// is det.
%
%   As written_en//1.

written_ko(rounds(1)) -->
    [ '반올림된 입체가 자신을 뚫고 지나가거나 자신에 닿아서, 더 성긴 격자에서 자신과 한 번 합했습니다' ].
written_ko(rounds(N)) -->
    { N > 1 },
    [ '반올림된 입체가 자신을 뚫고 지나가거나 자신에 닿아서, 더 성긴 격자에서 자신과 ~D번 합했습니다'-[N] ].
written_ko(empty) -->
    [ '입체가 비어 있습니다. 파일에 면이 없습니다' ].
written_ko(collapsed) -->
    [ '입체가 좌표의 반올림보다 얇습니다. 파일에 면이 없습니다', nl,
      '  원점 가까이로 옮기거나 배정밀도 형식(.off, .ply)으로 쓰십시오.' ].

%!  unwritten_ko(+What)// is det.
%
%   As unwritten_en//1.

unwritten_ko(open(N)) -->
    [ '모서리 ~D개에서 열려 있습니다'-[N], nl,
      '  닫힌 경계만 입체로 쓸 수 있습니다. check 명령으로 살펴보십시오.' ].
unwritten_ko(undivided(N)) -->
    [ '면 ~D개를 삼각형으로 나눌 수 없습니다'-[N] ],
    instead_ko(other_file).
unwritten_ko(crossing(N)) -->
    [ '모서리 ~D개를 따라 면들이 서로 교차합니다'-[N] ],
    instead_ko(other_file).
unwritten_ko(penetrates(N, meeting(_, X, Y, Z))) -->
    [ '~D곳에서 자신을 뚫고 지나갑니다. 처음은 ~g ~g ~g 근처입니다'-[N,X,Y,Z] ],
    instead_ko(other_file).
unwritten_ko(touches(N, meeting(_, X, Y, Z))) -->
    [ '~D곳에서 선을 따라 자신에 닿습니다. 처음은 ~g ~g ~g 근처입니다'-[N,X,Y,Z] ],
    instead_ko(other_file).

instead_ko(other_file) -->
    [ nl,
      '  있는 그대로 담는 .pl로 쓰십시오. .stl이라면 배정밀도 형식(.off, .ply)으로도 \c
       될 수 있습니다.' ].
