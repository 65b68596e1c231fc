:- encoding(utf8).
:- module(sg_about_ko,
          [ about_ko/2,                 % ?Name, -Text
            form_about_ko/2             % +Form, -Korean
          ]).
:- use_module(library(apply), [foldl/4]).
/** <module> What relations and predicates are, in Korean, for who looks for one
of them (complete.pl). In English their own documentation says it.
*/

%!  about_ko(?Name:atom, -Text:string) is nondet.
%
%   Text is a line about what has this Name/Arity; if all of a name are one
%   thing, about this Name.

% Relations.

about_ko(contour/13, "매끄러운 면의 외형선이 삼각형을 지나는 한 토막").
about_ko(drawn/7, "그림에서 모서리의 한 부분").
about_ko(e/5, "방향이 있는 모서리").
about_ko(formula/2, "파일에 쓰인 그대로의 행, 매개변수를 쓴 식과 함께").
about_ko(from_p/5, "결과의 다각형이 어느 피연산자의 어느 다각형에서 왔는가").
about_ko(from_r/4, "접합 결과의 영역이 어느 피연산자 안에 있는가").
about_ko(from_v/4, "결과의 꼭짓점이 피연산자의 어느 꼭짓점이었는가").
about_ko(gluing/2, "접합 연산에 바라는 것 (NG-2부터 NG-5)").
about_ko(joint/6, "전개한 모서리와 전개도에서 그 짝. 이음이 없는 실제 모서리는 가장자리이다").
about_ko(leaf_e/5, "자르기 전의 다각형이나 곡선의 모서리").
about_ko(leaf_p/3, "자르기 전의 다각형").
about_ko(leaf_t/6, "자르기 전의 다각형의 삼각형").
about_ko(leaf_v/5, "다른 세그먼트에 닿도록 옮기기 전의 꼭짓점 위치").
about_ko(lies_in/3, "다각형의 어느 루프에도 없는 것이 놓인 곳").
about_ko(light/2, "음영 그림의 빛").
about_ko(line/9, "상관선의 한 토막, 두 다각형에서. 또는 한 점에서만 닿은 곳").
about_ko(look/2, "음영 그림에서 모델의 한 부분이 보이는 모양").
about_ko(origin/3, "만들어진 것이 어디에서 왔는가").
about_ko(p/3, "다각형: 방향이 있는 모서리의 집합, 순서는 없다").
about_ko(param/2, "모델의 매개변수와 그 값").
about_ko(param_about/2, "매개변수의 범위와 설명").
about_ko(piece/3, "다각형이 전개도의 어느 조각에 있는가").
about_ko(plane/6, "다각형의 평면, 법선은 바깥쪽").
about_ko(projection/1, "투상 방법").
about_ko(question/2, "모델과 함께 저장한 질문").
about_ko(region/3, "세그먼트의 면 사이에 있는 공간의 영역").
about_ko(screen/5, "그림에서 본 꼭짓점 (PL-11)").
about_ko(segment/3, "모델의 한 부분").
about_ko(sides/4, "다각형 양쪽의 영역").
about_ko(span/7, "주사선에서 한 면이 보이는 부분 (CB-7)").
about_ko(surface_facing/6, "매끄러운 면 위의 선이 그 삼각형과 다르게 눈을 향하는 곳").
about_ko(t/6, "다각형의 삼각형, 바깥에서 보아 시계 반대 방향").
about_ko(title_block/2, "표제란에 쓰는 것").
about_ko(unfolding/2, "전개에 바라는 것 (DV-7)").
about_ko(v/5, "꼭짓점과 그 위치").
about_ko(view/3, "눈: 구면 좌표, 도 단위, phi는 +z에서 잰다").

% Predicates.

about_ko(add_primitive, "기본 입체를 지금 세계에 새 세그먼트로 더한다.").
about_ko(area, "세그먼트 S의 모든 다각형의 넓이, 모델 단위.").
about_ko(assert_fact, "assertz/1처럼 사실을 더한다.").
about_ko(boolean, "식의 경계가 세그먼트 S의 행이 된다. 그 번호의 입체가 없으면 만든다.").
about_ko(bounding_box, "세그먼트 S의 꼭짓점은 Low와 High 사이에 있다.").
about_ko(chain, "세그먼트 S1과 S2의 C번째 상관선 사슬의 종류와 선.").
about_ko(chain_length, "사슬의 실제 길이, 모델 단위.").
about_ko(chain_points, "사슬을 따라 놓인 점, 첫 세그먼트에 있는 대로.").
about_ko(complete_segments, "평면이 없는 다각형에 평면을, 삼각형이 없는 다각형에 삼각형을 준다.").
about_ko(contact, "접합 S의 두 피연산자가 꼭짓점, 모서리, 면을 함께 가진다.").
about_ko(convert, "파일의 모델을 다른 파일에 쓴다. 확장자가 형식이다.").
about_ko(current_view, "지금 세계를 보는 방법: view/3과 projection/1, 없으면 기본값.").
about_ko(current_world, "이 스레드의 지금 세계.").
about_ko(default, "지금 세계가 무엇을 따르든 그 결정의 기본값을 부른다.").
about_ko(develop, "전개도 D는 세그먼트 S를 펼친 것이다. 전에 있던 것은 없어진다.").
about_ko(developable_part,
    "세그먼트 S의 부분 Part는 정확히 전개된다: 원기둥, 원뿔 등의 작은 면을 가진다.").
about_ko(development, "D는 세그먼트 S의 전개도이다.").
about_ko(development_measures, "전개도 D가 얼마나 좋은가.").
about_ko(disk, "꼭짓점 V의 D번째 원판에 있는 모서리와 다각형, 순서대로.").
about_ko(disk_arcs, "원판의 삼각형마다 그 호와 아래위의 구역.").
about_ko(disk_direction, "꼭짓점에서 원판의 무엇을 따라가는 방향.").
about_ko(disk_relation, "결정: 한 곳의 두 원판의 안쪽이 서로 놓인 관계.").
about_ko(draw, "지금 세계를 draw 명령처럼 파일에 그린다. 확장자가 형식이다.").
about_ko(edge_facets, "모서리 양쪽의 면: 입체는 둘, 가장자리는 하나, 곡선은 없다.").
about_ko(edge_from, "결과의 반모서리 E가 어떻게 생겼는가.").
about_ko(edge_polygon, "모서리 E는 세그먼트 S의 다각형 P에 있다.").
about_ko(euler, "셀 S를 오일러 연산 하나로만 바꾼다.").
about_ko(evaluate, "모든 뿌리, 또는 노드 S의 경계를 낡았으면 새로 만든다.").
about_ko(evaluated, "노드 S에 경계가 있고, 지금 피연산자의 것이다.").
about_ko(explain, "왜 그러한지를 메시지의 언어로 쓴다.").
about_ko(explanation, "왜 그러한지를 because(Statement, Because)의 리스트로 준다.").
about_ko(face_of, "다각형 P는 세그먼트 S를 만든 기본 입체의 어느 면이다.").
about_ko(facet, "면.").
about_ko(facet_loops, "면을 도는 꼭짓점의 루프: 바깥 루프는 시계 반대 방향, 구멍은 시계 방향 (PL-3).").
about_ko(facet_neighbour, "두 면은 한 모서리를 서로 반대 방향으로 함께 쓴다.").
about_ko(facet_plane, "면의 평면, 법선은 바깥쪽.").
about_ko(facet_triangle, "면을 나눈 삼각형의 하나.").
about_ko(facts_redo, "마지막 facts_undo/0을 되돌린다.").
about_ko(facts_snapshot, "Goal을 한 번 하고, 성공해도 바꾼 것을 되돌린다.").
about_ko(facts_transaction, "Goal을 한 번 한다. 전부 되거나 아무것도 되지 않는다.").
about_ko(facts_undo, "마지막 바깥 트랜잭션과 그 뒤에 바꾼 것을 되돌린다.").
about_ko(facts_undo_limit, "지금 세계가 기억하는 단계의 수. 0이면 없다.").
about_ko(fresh_id, "세그먼트 S에서 쓴 적이 없는 가장 작은 번호.").
about_ko(generator_mark, "몇 번 면소가 어디에서 어디까지 그려지는가.").
about_ko(glue_edges, "모서리 A와 B를 접합한다. 셀에서는 함께 가진 부분을.").
about_ko(glue_faces, "한 평면의 다각형을 접합한다. 셀에서는 함께 가진 부분을.").
about_ko(glue_mixed, "꼭짓점을 모서리에, 꼭짓점을 다각형에, 모서리를 다각형에 접합한다.").
about_ko(glue_report, "접합 S의 경계에 대한 보고. 영역마다 어느 피연산자 안인지 말한다.").
about_ko(glue_vertices, "꼭짓점 V2가 정확히 같은 곳에 있는 V1이 된다.").
about_ko(half_edge, "반모서리.").
about_ko(half_edge_ends, "반모서리 S-E는 꼭짓점 V1에서 V2로 간다.").
about_ko(half_edge_facet, "반모서리는 면의 가장자리나 그 안의 접합선에 있다.").
about_ko(half_edge_twin, "같은 두 꼭짓점을 반대 방향으로 잇는 짝 (PL-1).").
about_ko(hidden_by, "세그먼트 S2의 삼각형 T가 그림에서 모서리 E의 From부터 To까지를 가린다.").
about_ko(hidden_by_polygon, "세그먼트 S2의 다각형 P가 그림에서 모서리 E의 From부터 To까지를 가린다.").
about_ko(in_world, "World를 지금 세계로 하여 Goal을 한 번 한다.").
about_ko(inside, "점은 입체 S의 안에 있다. 면 위에 있지 않다.").
about_ko(limit_value, "Name이라는 것의 상한.").
about_ko(line_layers, "주사선 Y에서 빛의 어느 부분이 어느 면에서 오는가.").
about_ko(line_spans, "주사선 Y에서 왼쪽부터 어디에 어느 면이 보이는가.").
about_ko(load_model,
    "파일의 모델을 지금 세계에 더한다. 다각형에는 평면과 삼각형이, CSG 트리의 뿌리에는 경계가 생긴다.").
about_ko(loop_cycle, "다각형 P를 도는 K번째 루프의 꼭짓점.").
about_ko(met, "점 (X, Y)의 시선이 만나는 것, 깊이 순서로.").
about_ko(model_defect, "지금 세계의 결함.").
about_ko(new_world, "빈 세계를 새로 만든다.").
about_ko(no_rules, "규칙 파일을 더 따르지 않는다.").
about_ko(node, "세그먼트 N은 노드이다: 연산, 피연산자, 배치.").
about_ko(operand_edge, "결과의 반모서리 E가 어느 피연산자의 모서리에 있는가.").
about_ko(operand_face, "결과의 다각형 P에 어느 피연산자의 면이 있는가.").
about_ko(operand_faults, "세그먼트 S가 피연산자가 될 수 없는 까닭. 될 수 있으면 [].").
about_ko(pattern_bent, "접는 선으로 이은 평면 전개도 D가 판재의 전개도가 된다.").
about_ko(penetrate, "지금 세계의 세그먼트의 상관선을 모두 찾아 다각형에 넣고 line/9를 쓴다.").
about_ko(penetration_chains, "penetrate/0이 넣을 상관선, 순서대로. 세계는 그대로 있다.").
about_ko(pick, "그림의 점 가운데에 보이는 면과 그 위의 위치.").
about_ko(picture, "지금 세계의 그림을 만든다: screen/5와 drawn/7을 채운다.").
about_ko(polygon_from, "결과의 다각형 P에 잎 S0의 다각형 P0의 전부나 일부가 있다.").
about_ko(query, "Goal의 모든 답을 찾는 순서대로 쓴다.").
about_ko(radial_cycle, "꼭짓점 A와 B 사이의 모서리를 도는 면과 영역.").
about_ko(read_csg, "OpenSCAD의 .csg 파일에 있는 모델, CSG 트리의 피연산자로.").
about_ko(read_mesh, "파일의 메시를 지금 세계에 더한다.").
about_ko(region_name, "세그먼트 S의 영역 R의 변하지 않는 이름.").
about_ko(region_named, "그 이름을 가진 세그먼트 S의 영역 R.").
about_ko(region_neighbour, "다각형 P는 서로 다른 영역 R1과 R2 사이에 있다.").
about_ko(regions_made, "세그먼트 S의 region/3, sides/4, lies_in/3을 새로 쓴다.").
about_ko(relation, "Name/Arity는 스키마의 관계이다.").
about_ko(relation_column, "관계의 열의 이름과 형, 어느 관계의 행을 가리키는가.").
about_ko(render, "지금 세계의 입체의 음영 그림을 파일에 쓴다. 확장자에 따라 PNG 또는 PPM.").
about_ko(repair_operand, "세그먼트 S를 고친다. 고친 종류마다 경고를 쓴다.").
about_ko(repl, "입력이 끝나거나 halt까지 목표를 읽고 답한다.").
about_ko(retract_fact, "사실 하나를 지운다, retract/1처럼.").
about_ko(retractall_facts, "맞는 사실을 모두 지운다.").
about_ko(root_segment, "세그먼트 S는 노드의 피연산자도 전개도도 아니다.").
about_ko(rule_file, "지금 세계는 이 파일을 따른다. 먼저 결정하는 것이 먼저 온다.").
about_ko(rules, "결정, 무엇을 결정하는지, 지금 세계에서 누가 정의하는지를 쓴다.").
about_ko(sanggwan_help, "어디에서 시작하는지, 또는 주제, 관계, 술어의 설명을 보인다.").
about_ko(save_model, "지금 세계를 파일에 쓴다. 확장자가 형식이다.").
about_ko(scan, "보이는 것으로 span/7을 채운다.").
about_ko(scene_leaf, "장면의 잎, 번호로.").
about_ko(seen_at, "점 (X, Y)에 어느 면이 보이는가.").
about_ko(seen_layers, "모두 비친다면 점 (X, Y)에 보일 것, 가까운 것부터.").
about_ko(seen_side, "점 (X, Y)에 보이는 것의 깊이와 법선.").
about_ko(set_direction, "무한히 먼 그 방향에서 본다. +z가 위쪽이다.").
about_ko(set_limit, "프로세스가 끝날 때까지 Name이라는 것의 상한.").
about_ko(set_parameter, "매개변수에 값을 주고, 그것으로 만든 것을 다시 만든다.").
about_ko(set_projection, "평행 투상(parallel) 또는 중심 투상(central)으로 한다.").
about_ko(set_view, "이름이 있는 쪽에서, 또는 그 각도와 거리에서 본다.").
about_ko(set_world, "World를 이 스레드의 지금 세계로 한다.").
about_ko(shading_scene, "지금 세계의 뿌리의 그림, 크기에 맞게.").
about_ko(shell, "세그먼트 S의 영역 R의 K번째 껍질: 이어진 경계.").
about_ko(shell_facets, "면에서 함께 쓰는 모서리를 넘어 닿을 수 있는 면.").
about_ko(show, "지금 세계의 그림을 터미널의 너비로 쓴다.").
about_ko(slice, "주사선 Y에서 어느 면이 어디에서 어디까지 있는가.").
about_ko(smooth_surface, "세그먼트 S의 휜 면 Part가 나타내는 곡면.").
about_ko(touches, "세그먼트 S1과 S2의 경계에 함께 가진 점이 있다.").
about_ko(trimmed, "T는 다른 것들의 바깥이나 안에 있는 S의 조각으로 된 새 세그먼트이다.").
about_ko(true_development, "D는 세그먼트 S의 부분을 정확히 펼친 새 전개도이다.").
about_ko(true_length_rows, "전개도 D의 면소마다 한 행인 실장표.").
about_ko(unfold, "D는 입체나 면인 세그먼트 S의 새 전개도이다.").
about_ko(unglue, "접합 S를 없앤다. 피연산자는 전과 같다.").
about_ko(unglued_polygons, "셀 S의 다각형이 하나마다 둘로 나뉜다.").
about_ko(unglued_region, "셀 S의 셀 R이 입체 N이 된다. 나머지는 접합되어 있다.").
about_ko(use_rules, "지금 세계가 규칙 파일을 따르게 한다.").
about_ko(vertex_exact, "꼭짓점 V의 정확한 위치, 유리수로.").
about_ko(vertex_from, "결과의 꼭짓점 V는 잎 S0의 꼭짓점 V0이었다.").
about_ko(vertex_half_edge, "반모서리는 이 꼭짓점에서 시작한다.").
about_ko(vertex_point, "꼭짓점의 위치.").
about_ko(volume, "입체 S의 부피, 모델 단위.").
about_ko(winding, "세그먼트 S의 삼각형이 점을 몇 번 도는가.").
about_ko(write_lines, "상관선을 파일에 쓴다.").
about_ko(write_mesh, "지금 세계의 세그먼트를 파일에 쓴다.").
about_ko(write_solid, "지금 세계의 입체 S를 파일에 쓴다.").
about_ko(write_true_lengths, "전개도 D의 실장표를 CSV로 파일에 쓴다.").
about_ko(zone, "영역 R이 꼭짓점 V에 있고, 그 구역의 둘레.").
about_ko(zone_at, "방향이 가리키는 원판의 구역.").

%!  form_about_ko(+Form:string, -Korean:atom) is det.
%
%   Korean is the Form of a primitive, what it says in words in Korean.

form_about_ko(Form, Korean) :-
    findall(En-Ko, said_ko(En, Ko), Pairs),
    foldl(replaced, Pairs, Form, Korean).

replaced(En-Ko, Form0, Form) :-
    atomic_list_concat(Parts, En, Form0),
    atomic_list_concat(Parts, Ko, Form).

said_ko(', or ', ', 또는 ').
said_ko(', as transition(...)', ', transition(...)과 같음').
said_ko(', Outline one of ', ', Outline은 다음의 하나: ').
