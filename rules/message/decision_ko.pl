:- encoding(utf8).
:- module(sg_decision_ko,
          [ decision_ko/2               % +Decision, -Text
          ]).
/** <module> What is decided, in Korean (decision.pl).
*/

%!  decision_ko(+Decision, -Text:string) is det.
%
%   Text says what Decision, Name/Arity, decides.

decision_ko(Decision, Text) :-
    ko(Decision, Text),
    !.

ko(merge_faces/2,    "한 면이 되는 같은 평면의 이웃 (CB-5)").
ko(stays_trimmed/4,  "다듬을 때 남는 부분의 조각").
ko(stays/3,          "결과에 남는 입체의 조각 (CB-4)").
ko(tone/3,           "향하는 쪽에 따른 입체의 면의 밝기").
ko(may_section/2,    "음영도의 단면이 자르는 입체").
ko(surface_look/4,   "음영도에서 잎의 면이 보이는 모양").
ko(owner/3,          "음영도에서 겹친 면 가운데 보이는 면").
ko(ramp/3,           "모양의 명암에 따른 색").
ko(pixel_colour/4,   "음영도의 점의 색").
ko(may_join/2,       "전개도에서 이을 수 있는 모서리").
ko(join_order/3,     "전개도의 모서리를 잇는 순서 (DV-6)").
ko(corner_relief/3,  "두 굽힘이 만나는 곳에서 따내는 모양").
ko(tab_shape/4,      "풀칠면이 가질 수 있는 모양").
ko(merge_line/2,     "하나가 되는 한 직선 위의 선 조각 (PL-9)").
ko(may_cut/2,        "서로 자르는 세그먼트 (PL-8)").
ko(may_glue/3,       "붙이는 피연산자의 접촉 (NG-2에서 NG-5)").
ko(disk_relation/3,  "한 꼭짓점의 두 원판이 놓인 관계 (NG-2)").
ko(line_style/4,     "보임, 역할, 세그먼트에 따른 선의 모양").
ko(paper_style/1,    "용지의 색").
ko(edge_role/5,      "그림에서 선의 역할 (PL-13)").
ko(may_hide/4,       "선을 가릴 수 있는 삼각형 (PL-13)").
ko(may_hide/2,       "다른 세그먼트의 선을 가릴 수 있는 세그먼트 (PL-13)").
ko(line_segment/3,   "상관선을 그릴 때 따르는 두 세그먼트의 하나").
ko(smooth_segment/1, "삼각형 안에 외형선이 있는 세그먼트").
