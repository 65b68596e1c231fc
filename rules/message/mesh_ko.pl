:- encoding(utf8).
:- module(sg_mesh_ko,
          [ mesh_ko//1,                 % +Fault
            simplify_ko//1              % +What
          ]).
/** <module> What is wrong with a mesh file, in Korean.

mesh_en.pl has the same heads in English.
*/

%!  simplify_ko(+What)// is det.
%
%   The notice sanggwan(simplify(What)).

simplify_ko(made(Left, Before)) -->
    [ '단순화: 삼각형 ~D개가 ~D개로 되었습니다'-[Before, Left] ].
simplify_ko(not_fewer(Faces, Left)) -->
    [ '--faces ~D: 삼각형을 ~D개보다 줄일 수 없습니다'-[Faces, Left], nl,
      '  닫힌 부분마다 적어도 네 개, 구멍마다 세 개가 더 필요합니다.' ].
simplify_ko(meets_itself(S, Name)) -->
    [ '세그먼트 ~d(~p): 단순화한 뒤 자기 자신과 만납니다'-[S, Name], nl,
      '  --faces를 늘리십시오. 만나는 곳은 check가 알립니다.' ].

%!  mesh_ko(+Fault)// is semidet.
%
%   The message for model_error(mesh(Fault)).

mesh_ko(empty_file) -->
    [ '파일이 비어 있습니다', nl,
      '  온전한 파일을 구하십시오. 쓴 프로그램이 실패했을 수 있습니다.' ].
mesh_ko(no_faces) -->
    [ '메시에 다각형도 곡선도 없습니다', nl,
      '  면과 함께 모델을 다시 내보내십시오.' ].
mesh_ko(unknown_format) -->
    [ 'STL, OFF, OBJ, PLY 어느 메시로도 보이지 않습니다', nl,
      '  형식에 맞는 확장자를 주십시오.' ].
mesh_ko(unsupported(Text)) -->
    [ '~w: 이 형식 가운데 읽지 않는 종류입니다'-[Text], nl,
      '  텍스트 형식으로 저장하십시오.' ].
mesh_ko(expected(Wanted, '')) -->
    [ '~w이(가) 와야 할 곳에 아무것도 없습니다'-[Wanted], nl,
      '  줄을 채우십시오. 파일이 여기서 끝나면 온전한 파일을 구하십시오.' ].
mesh_ko(expected(Wanted, Text)) -->
    { Text \== '' },
    [ '~w이(가) 와야 할 곳에 ~w이(가) 있습니다'-[Wanted, Text], nl,
      '  줄을 고치십시오. 확장자에 맞는 형식입니까?' ].
mesh_ko(bad_number(Text)) -->
    [ '수가 아닙니다: ~w'-[Text], nl,
      '  -12.5나 1e-3처럼 점을 찍어 쓰십시오.' ].
mesh_ko(not_finite(Text)) -->
    [ '좌표가 ~w입니다. 유한한 수여야 합니다'-[Text], nl,
      '  모델을 만든 프로그램에서 고치십시오.' ].
mesh_ko(no_float32) -->
    [ '좌표가 STL에 쓰기에는 너무 큽니다. STL의 수는 3.4e38 까지입니다', nl,
      '  .off, .obj, .ply로 쓰거나 다른 단위를 고르십시오.' ].
mesh_ko(crosses_itself(S, P)) -->
    [ '세그먼트 ~d: 다각형 ~d의 변이 서로 교차하여 빠지게 됩니다'-[S, P], nl,
      '  모델에서 고치십시오.' ].
mesh_ko(too_far(Text)) -->
    [ '좌표 ~w이(가) 1.0e90을 넘습니다'-[Text], nl,
      '  다른 단위를 쓰십시오. 이 크기로는 계산할 수 없습니다.' ].
mesh_ko(bad_index(Index, Lowest, Highest)) -->
    { Lowest =< Highest },
    [ '꼭짓점 ~d은(는) 없습니다. 있는 것은 ~d부터 ~d까지입니다'-
      [Index, Lowest, Highest], nl,
      '  번호를 고치거나 꼭짓점을 추가하십시오.' ].
mesh_ko(bad_index(Index, Lowest, Highest)) -->
    { Lowest > Highest },
    [ '꼭짓점 ~d은(는) 없습니다. 아직 하나도 없습니다'-[Index], nl,
      '  꼭짓점을 먼저 주십시오.' ].
mesh_ko(bad_count(What, Text)) -->
    [ '~w의 수가 될 수 없습니다: ~q'-[What, Text], nl,
      '  0 이상의 정수를 쓰십시오.' ].
mesh_ko(truncated(What, Present, Needed)) -->
    [ '너무 짧습니다: ~w ~D개여야 하지만 많아야 ~D개 있습니다'-
      [What, Needed, Present], nl,
      '  잘린 파일입니다. 온전한 파일을 구하십시오.' ].
mesh_ko(short_face(Corners)) -->
    [ '면이나 선의 꼭짓점이 모자랍니다: ~d개'-[Corners], nl,
      '  면은 셋, 선은 둘이 필요합니다. 고치거나 지우십시오.' ].
mesh_ko(too_large) -->
    [ '꼭짓점이나 모서리가 2,147,483,647개보다 많습니다', nl,
      '  모델을 여러 파일로 나누십시오.' ].
mesh_ko(no_property(Property, Element)) -->
    [ '요소 ~w에 속성 ~w이(가) 하나 필요합니다'-[Element, Property], nl,
      '  모델을 일반적인 PLY로 다시 내보내십시오.' ].
