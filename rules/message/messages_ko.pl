:- encoding(utf8).
:- module(sg_messages_ko,
          [ korean//1                   % +Term
          ]).
:- use_module('../language', [interrupted_word/2]).
:- use_module(batch_ko, [manifest_ko//1, batch_ko//1]).
:- use_module(command_ko, [command_ko//1]).
:- use_module(csg_ko, [csg_ko//1]).
:- use_module(explain_ko, [statement_ko//1, hidden_ko//1]).
:- use_module(explain_glue_ko, [glue_nothing_ko//1]).
:- use_module(explain_pixel_ko, [pixel_nothing_ko//1]).
:- use_module(openscad_ko, [openscad_ko//1]).
:- use_module(problem_ko, [problem_ko//1]).
:- use_module(style_ko, [style_ko//1]).
:- use_module(sheet_ko, [sheet_tiny_ko//3]).
:- use_module(parameter_ko, [parameter_ko//1]).
:- use_module(pattern_ko, [pattern_ko//1]).
:- use_module(written_ko, [written_ko//1, unwritten_ko//1]).
:- use_module(development_ko,
              [ development_ko//2, development_notice_ko//2 ]).
:- use_module(mesh_ko, [mesh_ko//1, simplify_ko//1]).
:- use_module(part_glue_ko, [part_glue_ko//1]).
:- use_module(message_parts,
              [ dots_that_fit/5, loading_fault//2, located//1, manual_page//1,
                shown_names/2, shown_number/3
              ]).
:- use_module(session_ko, [session_ko//1]).
:- use_module(prolog_ko, [prolog_ko//2]).
:- use_module(model_ko, [model_ko//1]).
:- use_module(operand_ko, [operand_ko//2, operand_notice_ko//2]).
:- use_module(true_ko, [true_ko//1]).
:- use_module(unfold_ko, [wish_ko//3, unfold_ko//1, trim_ko//1]).
:- use_module(particle, [lines_joined/2]).
:- use_module(primitive_ko, [comma_ko//1, primitive_ko//2]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(pairs), [pairs_keys/2]).
/** <module> Messages in Korean; messages.pl has them in English.

The heads are the same as in messages.pl, clause by clause
(tests/rules/message/messages.plt).
*/

:- multifile prolog:message//2.

%   By phrase/3: a rule file may have defined append/3 of library(lists) anew.

prolog:message(ko, Term, Lines, Rest) :-
    phrase(korean(Term), Lines0),
    lines_joined(Lines0, Lines1),
    phrase(Lines1, Lines, Rest).

%!  korean(+Term)// is semidet.
%
%   The message for Term in Korean.

korean(error(model_error(What), Context)) -->
    located(Context),
    wrong_ko(What).
korean(error(geometry_error(What), Context)) -->
    located(Context),
    wrong_ko(What).
korean(error(frame_error(What), _)) -->
    session_ko(frame(What)).
korean(error(request_error(What), _)) -->
    session_ko(What).
korean(error(usage_error(What), _)) -->
    command_ko(What).
korean(error(domain_error(Domain, Value), _)) -->
    drawing_ko(domain(Domain, Value)).
korean(error(existence_error(directory, Folder), context(Writer, _))) -->
    { Writer == sg_output:writing/3 },
    command_ko(no_folder(Folder)).
korean(error(representation_error(What), _)) -->
    { What == float32 },
    mesh_ko(no_float32).
korean(error(representation_error(What), _)) -->
    { What == max_path_length },
    model_ko(cannot_read(long_name)).
korean(error(resource_error(What), _)) -->
    { What == memory },
    notice_ko(no_memory).
korean(error(cannot_write(File, Why), _)) -->
    command_ko(cannot_write(File, Why)).
korean(sanggwan_interrupt(_)) -->
    notice_ko(interrupted).
korean(sanggwan(What)) -->
    notice_ko(What).

:- discontiguous
    fault_ko//1,
    notice_ko//1.

notice_ko(request(Do)) -->
    session_ko(does(Do)).
notice_ko(studio(What)) -->
    session_ko(What).

%   wrong_ko(What)//: what is wrong with a model, and what to do.

wrong_ko(What) -->
    (   fault_ko(What)
    ->  []
    ;   model_ko(What)
    ).

fault_ko(primitive(What, Term)) -->
    primitive_ko(What, Term).
fault_ko(manifest(What)) -->
    (   { What = usage(Wrong) }
    ->  command_ko(Wrong)
    ;   manifest_ko(What)
    ).
fault_ko(csg(What)) -->
    csg_ko(What).
fault_ko(development(S, What)) -->
    development_ko(S, What).
fault_ko(operand(S, Faults)) -->
    operand_ko(S, Faults).
fault_ko(unfold(S, Wish, What)) -->
    wish_ko(S, Wish, What).
fault_ko(unfold(What)) -->
    unfold_ko(What).
fault_ko(trim(What)) -->
    trim_ko(What).
fault_ko(true(What)) -->
    true_ko(What).
fault_ko(problem(What)) -->
    (   { What = of(Number, Formal) }
    ->  [ '~w: '-[Number] ],
        korean(error(Formal, _))
    ;   problem_ko(What)
    ).
fault_ko(style(What)) -->
    style_ko(What).
fault_ko(not_whole(Row, Missing)) -->
    [ '~p이(가) 가리키는 ~p이(가) 없습니다'-[Row, Missing], nl,
      '  같은 facts_transaction/1 안에서 함께 지우거나 ~p을(를) 다시 넣으십시오. \c
       옵션 cascade(true)는 그것을 가리키는 것도 지웁니다.'-[Missing] ].
fault_ko(referred(Fact, Row)) -->
    [ '~p을(를) 지우지 않았습니다. ~p이(가) 가리킵니다'-[Fact, Row], nl,
      '  facts_transaction/1 하나에서 함께 바꾸거나 함께 지우십시오: \c
       retract_fact(Fact, [cascade(true)]).' ].


                /*******************************
                *            verbs             *
                *******************************/

notice_ko(do_not_meet) -->
    [ '세그먼트들이 만나지 않아 상관선이 없습니다' ].
notice_ko(points_alone(N)) -->
    [ '세그먼트들이 점 ~D개에서만 만납니다: explain vertex(S, V)'-[N] ].
notice_ko(batch(What)) -->
    batch_ko(What).
notice_ko(trim(What)) -->
    trim_ko(What).
notice_ko(unfold(What)) -->
    unfold_ko(What).
notice_ko(development(S, What)) -->
    development_notice_ko(S, What).
notice_ko(operand(What, S)) -->
    operand_notice_ko(What, S).
notice_ko(comma(Argument, Location)) -->
    located(Location),
    comma_ko(Argument).
notice_ko(parameter(What)) -->
    parameter_ko(What).
notice_ko(pattern(What)) -->
    pattern_ko(What).
notice_ko(one_segment) -->
    [ '세그먼트가 하나뿐이라 상관선이 없습니다' ].
notice_ko(empty_result(S, Name)) -->
    [ '세그먼트 ~d(~p)이(가) 비었습니다. 피연산자에서 남은 것이 없습니다'-[S, Name] ].
notice_ko(summary_sent(File)) -->
    [ '~w 파일에는 결과가 아니라 요약이 들어갔습니다'-[File], nl,
      '  > ~w 대신 -o ~w 옵션을 쓰십시오.'-[File, File] ].
notice_ko(wrote(File)) -->
    [ '~w 파일을 썼습니다'-[File] ].
notice_ko(pen_travel(N, Way, Unsorted)) -->
    { Metres0 is Way/1.0e6,
      Before0 is Unsorted/1.0e6,
      maplist(shown_number(3), [Metres0,Before0], [Metres,Before])
    },
    [ '펜이 그리는 선 ~D개, 그 사이에 들고 가는 길이 ~w m (차례를 바꾸지 않으면 ~w m)'-
      [N, Metres, Before] ].
notice_ko(each_failed(Bad, Count, Files)) -->
    { shown_names(Files, Text) },
    [ '파일 ~D개 가운데 ~D개가 실패했습니다: ~w'-[Count, Bad, Text] ].
notice_ko(interrupted) -->
    { interrupted_word(ko, Word) },
    [ Word ].
notice_ko(greeting) -->
    [ '목표를 물어보십시오. 마침표로 끝나며 halt. 로 나갑니다.', nl,
      '  모델은 v/5 e/5 p/3 t/6 segment/3입니다. penetrate. \c
       draw(\'a.svg\'). show. rules.' ].
notice_ko(segment(S, Kind, Name)) -->
    [ '세그먼트 ~d: ~w ~p'-[S, Kind, Name] ].
notice_ko(uncaught(What)) -->
    [ '목표나 규칙이 throw(~p)(으)로 끝났습니다'-[What], nl,
      '  거기에서 잡거나 error(Formal, Context)를 던지십시오.' ].
notice_ko(no_answer) -->
    [ '답이 없습니다' ].
notice_ko(more_warnings(N)) -->
    [ '보이지 않은 것이 ~D개 더 있습니다'-[N] ].
notice_ko(warnings_are_errors(N)) -->
    [ '경고 ~d개, --strict 옵션이 주어졌습니다'-[N] ].
notice_ko(nothing_written(N)) -->
    [ '경고가 ~d개 있고 --strict 옵션이 주어져서 아무것도 쓰지 않습니다'-[N], nl,
      '  경고한 것을 고치거나 --strict를 빼십시오.' ].
notice_ko(no_memory) -->
    [ '메모리가 모자랍니다', nl,
      '  아무것도 바뀌지 않았습니다. 나누거나 면을 줄이면 덜 듭니다.' ].
notice_ko(no_end) -->
    [ '일이 결과 없이 끝났습니다. 프로그램의 잘못입니다', nl,
      '  모델과 명령을 만든 사람에게 보내 주십시오.' ].
notice_ko(progress(Stage, Seconds)) -->
    [ '~w: ~0f초'-[Stage, Seconds] ].
notice_ko(progress(Stage, Done, Total, Rate, Left)) -->
    [ '~w: ~D / ~D, 초당 ~0f, 남은 시간 ~0f초'-
      [Stage, Done, Total, Rate, Left] ].


notice_ko(not_utf8(File, Line)) -->
    [ '~w:~d: 파일에 UTF-8이 아닌 바이트가 있습니다. 처음은 여기서 끝나는 사실입니다'-
      [File, Line], nl,
      '  파일을 UTF-8로 저장하십시오. 이름이 잘못되었을 수 있습니다.' ].


                /*******************************
                *             mesh             *
                *******************************/

fault_ko(openscad(What)) -->
    openscad_ko(What).
fault_ko(mesh(Fault)) -->
    mesh_ko(Fault).
fault_ko(mesh(Fault, Byte)) -->
    [ '~D번째 바이트: '-[Byte] ],
    mesh_ko(Fault).

fault_ko(mesh_write(unsupported(Text))) -->
    [ '이 형식에는 담을 수 없습니다: ~w'-[Text], nl,
      '  .obj나 .ply로 쓰십시오.' ].

fault_ko(written(faulty(S, Rounds, What))) -->
    [ '세그먼트 ~d을(를) 쓰지 않았습니다. ~D번 고친 뒤: '-[S, Rounds] ],
    unwritten_ko(What).
fault_ko(no_triangles(S, P)) -->
    [ '세그먼트 ~d의 다각형 ~d에 삼각형이 없습니다'-[S, P], nl,
      '  잘못된 다각형일 수 있습니다: check로 살펴보거나 complete_segments를 \c
       부르십시오.' ].

notice_ko(mesh(File, degenerate(N))) -->
    [ '~w: 서로 다른 세 꼭짓점이 없는 면 ~D개를 뺐습니다'-[File, N] ].
notice_ko(mesh(File, ignored(N, Line))) -->
    [ '~w: 모르는 항목 ~D개를 건너뛰었습니다. 처음은 ~D번째 줄'-
      [File, N, Line] ].
notice_ko(mesh(File, no_curves(N))) -->
    [ '~w: STL에는 곡선이 없어 ~D개를 뺐습니다'-[File, N] ].
notice_ko(mesh(File, other_names(N))) -->
    [ '~w: 이름 ~D개에서 보이지 않는 글자를 그림(␛)이나 빈칸으로 바꾸었습니다'-
      [File, N] ].
notice_ko(simplify(What)) -->
    simplify_ko(What).
notice_ko(written(File, What)) -->
    [ '~w: '-[File] ],
    written_ko(What).
notice_ko(mesh(File, trailing(Bytes))) -->
    [ '~w: 메시 뒤의 ~D 바이트를 건너뛰었습니다'-[File, Bytes] ].


                /*******************************
                *            drawing           *
                *******************************/

drawing_ko(domain(sheet_size, W0-H0)) -->
    { number(W0),
      number(H0),
      maplist(shown_number(0), [W0,H0], [W,H])
    },
    [ '그림이 ~w x ~w mm입니다'-[W,H], nl,
      '  --scale 값을 줄이십시오. 각 변은 0보다 크고 100000 mm 이하여야 합니다.' ].
drawing_ko(domain(sheet_size, Size)) -->
    [ '~p: 용지의 크기가 아닙니다'-[Size], nl,
      '  너비x높이를 210x148처럼 mm로, 100000까지 쓰십시오.' ].
drawing_ko(domain(raster_size, W-H)) -->
    [ '그림은 ~p x ~p 점이 될 수 없습니다'-[W, H], nl,
      '  한 변은 1에서 16384까지, 모두 6700만 점까지입니다.' ],
    (   { dots_that_fit(W, H, Wide, High, By) }
    ->  [ nl, '  이 비율로는 ~d x ~d 점이 들어갑니다. --dpi 값을(--png dots이면 \c
               --size 값을) ~w분의 1로 줄이십시오.'-[Wide, High, By] ]
    ;   []
    ).
drawing_ko(domain(dot_pattern, Pattern)) -->
    [ '~p: 점의 무늬가 아닙니다'-[Pattern], nl,
      '  N개 찍고 N개 비우는 N이나 리스트 [찍음, 비움, ...]으로 쓰십시오.' ].
drawing_ko(domain(drawing_format, Ending)) -->
    [ '.~w: 그림의 확장자가 아닙니다'-[Ending], nl,
      '  그림은 .svg .pdf .eps .ps .png .dxf .hpgl .json .pl 파일입니다.' ].
drawing_ko(domain(dashes, How)) -->
    [ '파선은 auto, geometry, type 가운데 하나여야 합니다: ~p'-[How] ].
drawing_ko(domain(png, How)) -->
    [ 'PNG는 smooth 또는 dots여야 합니다: ~p'-[How] ].

notice_ko(sheet_tiny(N:M, How)) -->
    sheet_tiny_ko(N, M, How).
notice_ko(nothing_drawn) -->
    [ '그릴 것이 없습니다' ].
notice_ko(look_in_vain(Name, Names)) -->
    [ '모양 사실에 ~p이(가) 있지만 그런 이름의 세그먼트가 없습니다'-[Name],
      nl ],
    (   { Names == [] }
    ->  [ '  이름이 있는 세그먼트가 없습니다. 번호를 쓰십시오.' ]
    ;   { atomic_list_concat(Names, ', ', All) },
        [ '  모델에 있는 이름: ~w. 나머지는 번호로 가리킵니다.'-[All] ]
    ).
notice_ko(pixel_colour_asked(Dots)) -->
    [ 'pixel_colour/4의 규칙이 있습니다. 점 ~D개에 하나씩 묻습니다'-[Dots] ].
notice_ko(pixel_colour_in_vain) -->
    [ 'pixel_colour/4의 규칙이 있지만 투명한 점이 있는 그림에는 묻지 \c
       않습니다', nl,
      '  --background에 색을 주십시오.' ].
notice_ko(shadows_in_vain) -->
    [ '그림자를 모르는 tone/3을 규칙이 정하므로 --shadows는 아무것도 바꾸지 않습니다' ].
notice_ko(facets_off(Dots0)) -->
    { shown_number(1, Dots0, Dots) },
    [ '둥근 것은 둥글게 보입니다. 파일의 면은 거기서 많아야 ~w점 떨어져 있습니다 (--surface \c
facets는 그 면을 보입니다)'-[Dots] ].
notice_ko(format_option(Option, Format)) -->
    [ '~w 옵션은 .~w 파일에 관한 것인데, 그런 파일이 없어 아무것도 바꾸지 \c
       않습니다'-[Option, Format] ].
notice_ko(points_in_vain) -->
    [ '상관선이 없어 번호를 붙일 점이 없습니다' ].
notice_ko(nothing_seen) -->
    [ '보이는 것이 없습니다. 그림은 바탕뿐입니다', nl,
      '  모델에 입체가 없거나 모두 빼 버렸습니다.' ].
notice_ko(thinner_than_lines) -->
    [ '보이는 것이 그림의 두 줄 사이에 들어갈 만큼 얇습니다. 그림은 바탕뿐입니다',
      nl, '  --size 값을 키우거나 --smooth 16 또는 더 가까운 --window를 주십시오.' ].
notice_ko(nothing_in_window) -->
    [ '창 안에 보이는 것이 없습니다. 그림은 바탕뿐입니다', nl,
      '  --window 값을 바꾸십시오. 빼면 보이는 것이 그림을 채웁니다.' ].
notice_ko(not_shaded(S, cells)) -->
    !,
    [ '세그먼트 ~p은(는) 그림에 없습니다. 피연산자가 없는 셀입니다'-[S], nl,
      '  피연산자를 아직 지닌 glue 모델을 음영하십시오. draw는 셀도 그립니다.' ].
notice_ko(not_shaded(S, glued(Kind))) -->
    !,
    [ '세그먼트 ~p은(는) 그림에 없습니다. 종류가 ~w인데, glue에서는 입체만 음영을 \c
       줍니다'-[S, Kind], nl,
      '  draw는 그것도 그립니다.' ].
notice_ko(not_shaded(S, Kind)) -->
    [ '세그먼트 ~p은(는) 그림에 없습니다. 종류가 ~w인데, 음영은 입체와 곡면만 \c
       그립니다'-[S, Kind], nl,
      '  draw는 그것도 그립니다.' ].
notice_ko(surface_uncut(S)) -->
    [ '세그먼트 ~p은(는) 그림에 없습니다. 곡면인데, 단면은 입체만 자릅니다'-[S], nl,
      '  draw --section은 곡면도 자릅니다.' ].
notice_ko(surface_see_through(S)) -->
    [ '세그먼트 ~p에는 열린 곡면이 있습니다. 비치는 부분 뒤에 있는 그 세그먼트의 다른 것은 보이지 \c
않습니다'-[S], nl,
      '  곡면을 합집합에 넣지 말고 따로 세그먼트로 만드십시오.' ].
notice_ko(style_in_vain(Segment)) -->
    [ '모양 파일이 세그먼트 ~p의 선을 정하지만, 모델에 그런 세그먼트가 \c
       없습니다'-[Segment] ].
notice_ko(penetration_in_vain(Segment)) -->
    [ '모양 파일이 세그먼트 ~p의 상관선을 정하지만, 그 세그먼트의 선으로 그린 상관선이 \c
없습니다'-[Segment], nl,
      '  상관선은 두 세그먼트 가운데 번호가 작은 쪽의 선입니다. line_segment/3 결정으로 \c
바꿀 수 있습니다(docs/rules.md).' ].


                /*******************************
                *             view             *
                *******************************/

fault_ko(eye_in_model(D)) -->
    [ '시점이 모델 안이나 뒤에 있습니다: 가장 가까운 점이 ~4g입니다'-[D], nl,
      '  더 멀리 가거나(--eye, 더 큰 RHO) 평행 투상을 쓰십시오.' ].
fault_ko(leaf_behind_eye(N)) -->
    [ '트리의 리프 ~D 번이 시점 앞에 있지 않습니다'-[N], nl,
      '  더 멀리 가거나(--eye, 더 큰 RHO) 평행 투상을 쓰십시오.' ].


                /*******************************
                *           decision           *
                *******************************/

fault_ko(rules(no_decision(PI))) -->
    [ '~q: 결정의 이름이 아니고, 이 규칙 파일에서 부르지도 않습니다'-[PI],
      nl,
      '  이름을 고치거나(rules/0이 이름을 보여 줍니다) 지우십시오.' ].
fault_ko(rules(no_decisions)) -->
    [ '이 규칙 파일은 아무 결정도 바꾸지 않습니다', nl,
      '  rules/0이 보여 주는 결정 가운데 하나를 정의하십시오.' ].
fault_ko(rules(module_file)) -->
    [ '규칙 파일에는 모듈 머리말이 없어야 합니다', nl,
      '  지시문 :- module(...)을 지우십시오.' ].
fault_ko(rules(defined_elsewhere(M:PI))) -->
    [ '~q: 다른 곳에서 정의되었고, 프로그램에 그대로 필요합니다'-[M:PI], nl,
      '  ~w:을 빼고 자신의 술어를 정의하십시오.'-[M] ].
fault_ko(rules(ends_program)) -->
    [ '규칙 파일은 프로그램을 끝내지 않습니다', nl,
      '  지시문 :- halt를 지우십시오.' ].
fault_ko(rules(Formal)) -->
    { \+ memberchk(Formal, [ no_decision(_), no_decisions, module_file,
                             defined_elsewhere(_), ends_program
                           ]) },
    [ '이 규칙 파일을 읽을 수 없습니다: ' ],
    loading_fault(prolog_ko, Formal),
    [ nl, '  고치십시오. 규칙은 전과 같습니다.' ].

notice_ko(decision(Name/Arity, Doc, By)) -->
    [ '~q/~d: ~w'-[Name, Arity, Doc], nl,
      '    정의한 곳: ~w'-[By] ].


                /*******************************
                *            regions           *
                *******************************/

fault_ko(open_polygon(S, P)) -->
    [ '세그먼트 ~d의 다각형 ~d번은 면이 아닙니다: 모서리가 이어져 닫히지 \c
       않습니다'-[S, P], nl,
      '  p/3의 리스트를 고치십시오.' ].
fault_ko(wrong_triangles(S, P)) -->
    [ '세그먼트 ~d의 다각형 ~d번은 면이 아닙니다: t/6의 삼각형들이 다각형의 \c
       경계에서 끝나지 않습니다'-[S, P], nl,
      '  그 삼각형들을 빼면 다시 만듭니다.' ].

notice_ko(cells_apart(S, N, P1, P2)) -->
    [ '세그먼트 ~d: 다각형들이 공통 모서리나 꼭짓점 없이 만나는 곳이 \c
       ~D군데입니다(처음은 ~d번과 ~d번)'-[S, N, P1, P2], nl,
      '  그곳에서 영역이 서로 이어질 수 있습니다. 만나는 곳에서 다각형을 \c
       나누십시오.' ].


                /*******************************
                *         triangulation        *
                *******************************/

fault_ko(no_third_vertex(V1, V2)) -->
    [ '꼭짓점 ~d에서 ~d(으)로 가는 모서리에 셋째 꼭짓점이 없습니다'-[V1, V2], nl,
      '  다각형이 그곳에서 자기 자신과 교차하거나 겹칩니다.' ].
fault_ko(polygon_edge(S, P, V1, V2)) -->
    invalid_polygon_ko(S, P, V1, V2).

notice_ko(polygon_edge(S, P, V1, V2)) -->
    invalid_polygon_ko(S, P, V1, V2),
    [ nl, '  빼고 계속합니다.' ].
notice_ko(polygon_edges(S, Count, P, V1, V2)) -->
    [ '세그먼트 ~d의 다각형 ~D개가 자기 자신과 교차하거나 겹칩니다 (처음은 다각형 ~d의 \c
       꼭짓점 ~d, ~d 사이)'-[S, Count, P, V1, V2], nl,
      '  빼고 계속합니다.' ].
notice_ko(tangled(S, Count, P, Most)) -->
    [ '세그먼트 ~d의 다각형 ~D개는 자기 자신과 너무 자주 닿거나 교차합니다 \c
       (처음은 ~d)'-[S, Count, P], nl,
      '  나누려면 변을 ~D번 넘게 살펴야 합니다. 빼고 계속합니다.'-[Most], nl,
      '  자기 자신과 닿지 않는 다각형으로 나누거나 --limits contacts=N을 \c
       주십시오.' ].
notice_ko(no_area(S, Count, P)) -->
    [ '세그먼트 ~d의 다각형 ~D개는 넓이가 없습니다 (처음은 ~d)'-
      [S, Count, P], nl,
      '  선이거나, 자기 자신과 교차하여 넓이가 상쇄됩니다.', nl,
      '  빼고 계속합니다.' ].
fault_ko(tolerance(Tolerance, Most)) -->
    [ '허용 오차 ~4g은(는) 너무 큽니다: 그보다 별로 크지 않은 부분이 있습니다'-
      [Tolerance], nl,
      '  --tolerance를 ~4g 이하로 주거나 빼십시오.'-[Most] ].
fault_ko(tight(S1, S2, At, Move, Feature, N)) -->
    tight_ko(S1, S2, At, Move, Feature, N).
fault_ko(unasked(Moved, Reach)) -->
    notice_ko(Moved),
    { Enough is 1.01*Reach },
    [ nl,
      '  원본의 반올림일 수도, 뜻한 것일 수도 있습니다. --tolerance ~3g을(를) 주면 \c
       허용하고, --tolerance 0을 주면 아무것도 옮기지 않습니다.'-[Enough] ].
fault_ko(flattened(S, At, Move, Beside, N)) -->
    flattened_ko(tight, S, At, Move, Beside, N).
fault_ko(result_open) -->
    [ '결과가 닫히지 않습니다', nl,
      '  --tolerance를 바꾸거나 --repair로 피연산자를 고치십시오.' ].

fault_ko(glue_law(S, Faults0)) -->
    { pairs_keys(Faults0, Faults),
      atomic_list_concat(Faults, ', ', Text) },
    [ '세그먼트 ~d: 붙인 것이 법칙에 어긋나(~w) 아무것도 붙이지 않았습니다'-
      [S, Text], nl,
      '  --tolerance를 바꾸거나 --repair로 피연산자를 고치거나 --rules를 고치십시오.' ].
fault_ko(undivided(S, P, X, Y, Z, Tolerance)) -->
    [ '세그먼트 ~d의 다각형 ~d을(를) ~6g ~6g ~6g에서 나눌 수 없습니다. 그곳의 것이 허용 오차 ~3g만큼 \c
       작습니다'-[S, P, X, Y, Z, Tolerance], nl,
      '  더 작은 값을 주십시오. --tolerance 0은 아무것도 옮기지 않습니다.' ].
fault_ko(thin_operand(S, Thick, Reach, X, Y, Z)) -->
    [ '세그먼트 ~d의 두께가 ~6g ~6g ~6g에서 ~3g쯤인데 ~3g보다 가까우면 한 점이 됩니다. 그래서 붙이지 \c
       않았습니다'-[S, X, Y, Z, Thick, Reach], nl,
      '  그것을 빼거나 두껍게 하거나, 아무것도 옮기지 않는 --tolerance 0을 주십시오.' ].
fault_ko(part_glue(What)) -->
    part_glue_ko(What).
fault_ko(glue_meets(S, P1, P2, X, Y, Z)) -->
    [ '세그먼트 ~d: 다각형 ~d번과 ~d번이 ~6g ~6g ~6g에서 공통 요소 없이 \c
       만나게 되어 아무것도 붙이지 않았습니다'-[S, P1, P2, X, Y, Z], nl,
      '  --tolerance를 바꾸거나 --repair로 피연산자를 고치십시오.' ].

notice_ko(glue_overlap(S, S1, S2, R, Volume)) -->
    [ '세그먼트 ~d: 피연산자 ~d번과 ~d번이 겹칩니다: 부피 ~6g인 영역 ~d이(가) \c
       둘 다의 안입니다'-[S, S1, S2, Volume, R] ].
notice_ko(glue_apart(S)) -->
    [ '세그먼트 ~d: 피연산자들이 아무 데서도 닿지 않습니다'-[S] ].
notice_ko(glue_overlaps(S, N)) -->
    [ '세그먼트 ~d: 여러 피연산자의 안인 영역이 ~D개 더 있습니다'-[S, N] ].
notice_ko(glue_surface(S, R, S0)) -->
    [ '세그먼트 ~d: 피연산자 ~d번은 곡면인데 영역 ~d을(를) 둘러쌉니다. 그래서 그 \c
       영역은 빈 곳입니다'-[S, S0, R], nl,
      '  입체여야 한다면 --repair를 주십시오.' ].
notice_ko(glue_surfaces(S, N)) -->
    [ '세그먼트 ~d: 곡면이 둘러싸는 영역이 ~D개 더 있습니다'-[S, N] ].
notice_ko(glue_thin(S, N, Most)) -->
    [ '세그먼트 ~d: 피연산자가 겹치는 영역 가운데 ~D개가 얇습니다. 두께는 \c
       ~6g 이하입니다'-[S, N, Most], nl,
      '  그곳에서 면이 닿아야 한다면 그 몇 배의 --tolerance를 주십시오.' ].
notice_ko(glue_gap(S, S1, S2, Gap, p(X,Y,Z))) -->
    [ '세그먼트 ~d: 피연산자 ~d번과 ~d번이 ~6g ~6g ~6g에서 ~6g 떨어져 있어 \c
       붙지 않았습니다'-[S, S1, S2, X, Y, Z, Gap] ].
notice_ko(glue_gaps(S, N)) -->
    [ '세그먼트 ~d: 그만큼 가깝지만 붙지 않은 피연산자 쌍이 ~D개 더 있습니다'-
      [S, N], nl,
      '  틈보다 큰 --tolerance를 주면 닿게 됩니다.' ].
notice_ko(cityjson_open(File, N)) -->
    [ '~w: 열린 입체 ~D개는 곡면으로 읽습니다'-[File, N] ].
notice_ko(cityjson_floors(File, N)) -->
    [ '~w: 열린 입체 ~D개를 평평한 면으로 닫았습니다'-[File, N] ].
notice_ko(cityjson_left_out(File, N)) -->
    [ '~w: 템플릿은 읽지 않습니다. ~D개를 뺐습니다'-[File, N] ].
notice_ko(cityjson_no_area(File, N)) -->
    [ '~w: 넓이가 없는 면 ~D개를 뺐습니다'-[File, N] ].
notice_ko(cells_parted(S, N)) -->
    [ '세그먼트 ~d에는 피연산자가 없습니다. 세포 ~d개가 저마다 입체가 되었습니다'-
      [S, N] ].
notice_ko(nothing_glued) -->
    [ '이 모델에는 붙인 것이 없습니다' ].
notice_ko(opened) -->
    [ '거의 닿는 곳을 그대로 두었습니다: 아니면 결과가 열립니다', nl,
      '  부스러기가 남을 수 있습니다.' ].
notice_ko(contacts(Why)) -->
    contacts_ko(Why),
    [ nl, '  선은 모델 그대로에 대해 정확하지만, 가는 조각이 있을 수 있습니다.' ].
notice_ko(moved(S1, S2, At, Move, N)) -->
    [ '닿게 한 곳 ~D개, 가장 많이 옮긴 거리 ~4g: '-[N, Move] ],
    place_ko(At, S1, S2).
notice_ko(tight(S1, S2, At, Move, Feature, N)) -->
    tight_ko(S1, S2, At, Move, Feature, N).
notice_ko(flattened(S, At, Move, Beside, N)) -->
    flattened_ko(tight, S, At, Move, Beside, N).
notice_ko(as_rounded(flattened(S, At, Move, Beside, N))) -->
    flattened_ko(moved, S, At, Move, Beside, N).
notice_ko(not_flat(S, Count, P, Off)) -->
    [ '세그먼트 ~d의 다각형 ~D개는 평평하지 않습니다 (가장 심한 ~d: ~4g)'-
      [S, Count, P, Off], nl,
      '  삼각형으로 나누어 씁니다.' ].

tight_ko(S1, S2, At, Move, Feature, N) -->
    (   { Move =:= Feature }
    ->  [ '반올림으로 설명되지 않는 ~4g 만큼의 틈을 닿게 하였습니다: '-
          [Move] ]
    ;   [ '닿게 하느라 ~4g만큼 옮겼지만 그곳의 요소는 크기가 ~4g뿐입니다: '-
          [Move, Feature] ]
    ),
    place_ko(At, S1, S2),
    other_places_ko(tight, N).

flattened_ko(How, S, At, Move, Beside, N) -->
    [ '한 면으로 합치느라 ~4g만큼 벗어난 곳의 '-[Move] ],
    beside_ko(Beside),
    [ ': ' ],
    place_ko(At, S, 0),
    other_places_ko(How, N).

beside_ko(edge(Length)) -->
    [ '모서리 길이가 ~4g뿐입니다'-[Length] ].
beside_ko(wall(Thickness)) -->
    [ '벽이나 틈의 두께가 ~4g뿐입니다'-[Thickness] ].

other_places_ko(How, N) -->
    (   { N > 1 }
    ->  [ '; 그런 곳이 ~D개 있습니다'-[N] ]
    ;   []
    ),
    (   { How == tight }
    ->  [ nl,
          '  반올림 이상일 수 있습니다: 그곳을 살펴보거나, 아무것도 옮기지 않는 \c
           --tolerance 0을 주십시오.'
        ]
    ;   []
    ).

place_ko([X, Y, Z], S1, S2) -->
    [ '~8g ~8g ~8g'-[X, Y, Z] ],
    (   { S2 =:= 0 }
    ->  [ ' (세그먼트 ~d)'-[S1] ]
    ;   [ ' (세그먼트 ~d, ~d)'-[S1, S2] ]
    ).

invalid_polygon_ko(S, P, V1, V2) -->
    [ '세그먼트 ~d의 다각형 ~d은(는) 꼭짓점 ~d과(와) ~d 사이에서 자기 자신과 \c
       교차하거나 겹칩니다'-[S, P, V1, V2] ].


                /*******************************
                *         hidden_lines         *
                *******************************/

notice_ko(lines_by_rules(Lines, Each)) -->
    [ '선 ~D개를 커널이 아니라 규칙으로 그렸습니다: 결정이 바뀌었습니다'-[Lines], nl,
      '  선마다 ~1f 마이크로초'-[Each] ].


                /*******************************
                *             help             *
                *******************************/

notice_ko(no_help(What, Names)) -->
    [ '~p에 대한 도움말이 없습니다'-[What], nl ],
    (   { Names == [] }
    ->  [ '  help. 를 입력하면 목록을 볼 수 있습니다.' ]
    ;   { atomic_list_concat(Names, ', ', All) },
        [ '  비슷한 이름: ~w. 전체 목록은 help. 로 볼 수 있습니다.'-[All] ]
    ).
notice_ko(prolog_help(PI, Where)) -->
    [ '~q은(는) Prolog 자체의 것입니다 (~q). 설명서:'-[PI, Where], nl ],
    manual_page(PI).


                /*******************************
                *            explain           *
                *******************************/

notice_ko(because(Statement)) -->
    statement_ko(Statement).
notice_ko(nothing_to_explain(piece(S, P))) -->
    !,
    [ '~p에는 설명할 것이 없습니다'-[piece(S, P)], nl,
      '  piece(S, P)는 입체의 연산인 세그먼트 S의 다각형 P이고, \c
       piece(S, S0-P0)는 그 피연산자 S0의 다각형 P0입니다.' ].
notice_ko(nothing_to_explain(Item)) -->
    { memberchk(Item, [pixel(_), pixel(_, _), why_not(seen(_))]) },
    !,
    pixel_nothing_ko(Item).
notice_ko(nothing_to_explain(Item)) -->
    { memberchk(Item, [glued(_), glued(_, _), region(_), region(_, _),
                       why_not(glued(_))]) },
    !,
    glue_nothing_ko(Item).
notice_ko(nothing_to_explain(Item)) -->
    { memberchk(Item, [hidden(_), hidden(_, _), why_not(_)]) },
    !,
    hidden_ko(nothing(Item)).
notice_ko(nothing_to_explain(Item)) -->
    [ '~p: 설명할 것이 없습니다'-[Item], nl,
      '  line(L), vertex(S, V), edge(S, E), pair(S1-P1, S2-P2), \c
       pair(S1, S2), piece(S, P), piece(S, S0-P0)를 모델의 번호로 \c
       물어보십시오. segment(S), param(이름)도 됩니다. 선은 penetrate \c
       다음에 있습니다. hidden(S, E)는 그림, pixel(X, Y)는 음영 그림에 관한 \c
       것이고, seam(S, E), fold(S, E), pattern(S, K)는 세그먼트 S의 전개도, \c
       glued(S, p(P)), region(S, R)은 glue에 관한 것입니다.' ].
%   허용 오차 안의 접촉을 맞추지 못한 까닭 (resolve.pl).

contacts_ko(wide(S, V)) -->
    [ '세그먼트 ~d의 꼭짓점 ~d이(가) 허용 오차의 세 배보다 넓게 다른 것과 '-
      [S, V], '이어져 있습니다.', nl,
      '  허용 오차 안에서 닿는 것을 그대로 두었습니다.' ].
contacts_ko(stuck(S, P)) -->
    [ '세그먼트 ~d의 다각형 ~d이(가) 허용 오차 안에서 닿는 것을 모두 '-
      [S, P], '받아들이지 못합니다.', nl, '  그대로 두었습니다.' ].
