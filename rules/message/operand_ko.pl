:- encoding(utf8).
:- module(sg_operand_ko,
          [ operand_ko//2,              % +S, +Faults
            operand_notice_ko//2        % +What, +S
          ]).
:- use_module(explain_words, [segment_word_ko/2]).
:- use_module('../csg/operand_name', [operand_name_ko//1]).
/** <module> What is wrong with an operand of a Boolean, in Korean.

operand_en.pl has the same heads in English.
*/

%!  operand_ko(+S, +Faults)// is det.
%
%   The message for geometry_error(operand(S, Faults)).

operand_ko(S, Faults) -->
    operand_ko(S),
    [ '은(는) 집합 연산(불 연산)에 쓸 수 없습니다:' ],
    faults_ko(Faults),
    [ nl, '  만든 곳에서 고치십시오. repair 옵션은 고칠 수 있는 것을 \c
           고칩니다.' ].

operand_ko(S) -->
    { integer(S) },
    !,
    { segment_word_ko(S, Name) },
    [ '세그먼트 ~d~w'-[S, Name] ].
operand_ko(Name) -->
    operand_name_ko(Name).

faults_ko([]) -->
    [].
faults_ko([Fault|Faults]) -->
    [ nl, '  ' ],
    operand_fault_ko(Fault),
    faults_ko(Faults).

operand_fault_ko(no_faces) -->
    [ '면이 없습니다' ].
operand_fault_ko(zero_volume) -->
    [ '부피가 없습니다' ].
operand_fault_ko(open_edges(N, Edges)) -->
    [ '닫혀 있지 않습니다: 한쪽에만 면이 있는 모서리 ~D개'-[N] ],
    edges_ko(Edges).
operand_fault_ko(unbalanced_edges(N, Edges)) -->
    [ '양쪽의 면 수가 다른 모서리 ~D개'-[N] ],
    edges_ko(Edges).

edges_ko([]) -->
    [].
edges_ko([edge(V1, V2, [X1,Y1,Z1], [X2,Y2,Z2], N)|Edges]) -->
    [ nl, '    ~d-~d: (~6g, ~6g, ~6g)에서 (~6g, ~6g, ~6g)까지, 면 ~d개'-
          [V1,V2,X1,Y1,Z1,X2,Y2,Z2,N] ],
    edges_ko(Edges).

%!  operand_notice_ko(+What, +S)// is det.
%
%   The message for sanggwan(operand(What, S)).

operand_notice_ko(inside_out, S) -->
    { segment_word_ko(S, Name) },
    [ '세그먼트 ~d~w은(는) 안팎이 뒤집혀 있어 그 안에 아무것도 없습니다'-
      [S, Name], nl,
      '  다각형의 방향을 뒤집으십시오. repair 옵션이 그렇게 합니다.' ].
operand_notice_ko(surface(Faults), S) -->
    { segment_word_ko(S, Name) },
    [ '세그먼트 ~d~w을(를) 곡면으로 봅니다. 입체 밖에 있는 부분만 \c
       남습니다'-[S, Name] ],
    faults_ko(Faults),
    [ nl, '  입체여야 한다면 만든 곳에서 고치십시오. repair 옵션은 고칠 수 있는 \c
           것을 고칩니다.' ].
operand_notice_ko(repaired(welded, N), S) -->
    [ '세그먼트 ~d: 같은 곳의 꼭짓점 ~D개를 하나로 합쳤습니다'-[S, N] ].
operand_notice_ko(repaired(no_area, N), S) -->
    [ '세그먼트 ~d: 넓이 없는 면 ~D개를 버렸습니다'-[S, N] ].
operand_notice_ko(repaired(duplicate, N), S) -->
    [ '세그먼트 ~d: 두 번 있는 면 ~D개를 버렸습니다'-[S, N] ].
operand_notice_ko(repaired(turned, N), S) -->
    [ '세그먼트 ~d: 뒤집힌 껍질 ~D개를 바로잡았습니다'-[S, N] ].
