:- encoding(utf8).
:- module(sg_session_ko,
          [ session_ko//1               % +What
          ]).
:- use_module(message_parts, [meant_ko//1]).
/** <module> What is wrong with a frame or a request of a session, in Korean;
session_en.pl has the same heads.
*/

%!  session_ko(+What)// is semidet.
%
%   What is wrong, and what to do.

session_ko(frame(truncated)) -->
    [ '입력이 프레임 도중에 끝납니다' ].
session_ko(frame(too_large(N))) -->
    [ '~D바이트의 프레임은 너무 큽니다'-[N], nl,
      '  프레임은 1,048,576바이트까지입니다. 대신 파일 이름을 쓰십시오.' ].
session_ko(frame(short(N))) -->
    [ '~D바이트의 프레임에는 머리의 길이가 들어갈 자리가 없습니다'-[N] ].
session_ko(frame(head_too_long(H))) -->
    [ '프레임의 머리가 ~D바이트라고 하나 프레임보다 깁니다'-[H] ].
session_ko(frame(not_utf8)) -->
    [ '프레임의 내용이 UTF-8이 아닙니다. 머리 또는 본문의 글' ].
session_ko(frame(not_json)) -->
    [ '프레임의 머리가 JSON이 아닙니다' ].
session_ko(frame(not_an_object)) -->
    [ '프레임의 머리가 JSON이지만 객체 {...}가 아닙니다' ].
session_ko(frame(too_deep(Most))) -->
    [ '프레임의 머리에 객체와 리스트가 ~D겹 넘게 겹쳐 있습니다'-[Most] ].
session_ko(unknown_do(Do, Near, All)) -->
    { atomic_list_concat(All, ', ', Known) },
    [ '세션은 "~w" 요청을 하지 않습니다'-[Do] ],
    meant_ko(Near),
    [ nl, '  하는 것: ~w.'-[Known] ].
session_ko(bad_key(Key, Wanted)) -->
    { said_alone(Wanted) },
    [ '"~w": '-[Key] ],
    wanted_ko(Wanted).
session_ko(bad_key(Key, Wanted)) -->
    { \+ said_alone(Wanted) },
    [ '요청에는 "~w" 키가 있어야 합니다: '-[Key] ],
    wanted_ko(Wanted).
session_ko(verb_refused(Verb)) -->
    [ '세션은 ~w 명령을 하지 않습니다'-[Verb], nl,
      '  따로 프로세스를 시작하십시오.' ].
session_ko(no_folder(Folder)) -->
    [ '"cwd"가 있는 폴더의 이름이 아닙니다: ~p'-[Folder] ].
session_ko(printed(Most)) -->
    [ '명령이 ~D바이트 넘게 출력했습니다'-[Most], nl,
      '  파일에 쓰게 하십시오: -o FILE.' ].

session_ko(no_end) -->
    [ '요청이 끝도 결과도 없이 멈췄습니다. 프로그램의 잘못입니다', nl,
      '  모델과 요청을 만든 이들에게 보내 주십시오.' ].
session_ko(no_document) -->
    [ '문서가 없습니다', nl,
      '  먼저 모델을 여십시오: "do":"open".' ].
session_ko(no_text) -->
    [ '문서가 사실 파일이 아니어서 여기서 고칠 수 없습니다', nl,
      '  변환하십시오: sanggwan convert MODEL -o MODEL.pl' ].
session_ko(other_revision(At, Revision)) -->
    [ '판 ~p에 대한 요청이나 문서는 판 ~d입니다'-[At, Revision], nl,
      '  지금의 문서를 보고 다시 요청하십시오.' ].
session_ko(nothing_to(undo)) -->
    [ '되돌릴 변경이 없습니다' ].
session_ko(nothing_to(redo)) -->
    [ '다시 할 변경이 없습니다' ].
session_ko(file_changed(File)) -->
    [ '~w이(가) 열었을 때와 다릅니다'-[File], nl,
      '  다시 열어 변경을 버리거나, 다른 이름으로 저장하거나, "force":true로 \c
       저장하십시오.' ].
session_ko(no_journal(Path)) -->
    [ '~w은(는) 이미 있으며 일지가 아닙니다. 덮어쓰지 않습니다'-[Path], nl,
      '  일지에 다른 이름을 주십시오.' ].
session_ko(journal_of_another(Path)) -->
    [ '일지 ~w의 변경은 파일에 있는 것과 다른 글의 것입니다'-[Path], nl,
      '  "replay":false로 열어 버리거나, 일지 없이 여십시오.' ].
session_ko(journal_damaged(Path, Done, Kept)) -->
    [ '일지 ~w이(가) 손상되었습니다. 변경 ~D개를 했고, 그 다음 것은 할 수 \c
       없습니다'-[Path, Done], nl,
      '  일지는 그대로 남아 있습니다: ~w.'-[Kept] ].
session_ko(edit(no_fact(segment(S, _)))) -->
    [ '글에 segment(~p, ...) 사실이 없습니다'-[S] ].
session_ko(edit(no_fact(param(Name)))) -->
    [ '글에 param(~p, ...) 사실이 없습니다'-[Name] ].
session_ko(edit(no_path(Path))) -->
    [ '사실의 경로 ~p에 아무것도 없습니다'-[Path], nl,
      '  경로는 인자의 번호, 그 안의 인자의 번호로 이어집니다.' ].
session_ko(edit(no_number(Path))) -->
    [ '사실의 경로 ~p에 있는 것은 수가 아닙니다'-[Path] ].
session_ko(unsafe_goal(Goal)) -->
    [ '질문은 읽기만 할 수 있습니다. 그 밖의 일을 할 수 있는 것: ~p'-[Goal] ].
session_ko(thrown(Text)) -->
    [ '목표가 던진 예외: ~s'-[Text] ].
session_ko(no_answers_left(Id)) -->
    [ '질문 ~p의 답이 남아 있지 않습니다'-[Id] ].
session_ko(too_long(seconds, Most)) -->
    [ '목표가 ~w초 넘게 걸렸습니다'-[Most], nl,
      '  한 번에 더 적게 물으십시오.' ].
session_ko(too_long(inferences, Most)) -->
    [ '목표가 추론 ~D번을 넘었습니다'-[Most], nl,
      '  한 번에 더 적게 물으십시오.' ].
session_ko(edit(no_edge(Text))) -->
    [ '"~w"은(는) 모서리의 번호도 이름도 아닙니다'-[Text], nl,
      '  모서리의 이름은 7, base-side(3), v(3)-v(8)과 같습니다.' ].
session_ko(edit(no_wish(S, Edge))) -->
    [ '글에 세그먼트 ~p의 모서리 ~p을(를) 자르는지가 없습니다'-[S, Edge] ].
session_ko(edit(no_question(Name))) -->
    [ '글에 ~q(이)라는 질문이 없습니다'-[Name] ].
session_ko(no_name(Name)) -->
    [ '그림에 ~w(이)라는 것이 없습니다'-[Name], nl,
      '  이름은 s1e7처럼 그림의 선과 부분의 이름입니다. 변경 뒤에는 다시 \c
       물으십시오.' ].
session_ko(owner_alone(rules)) -->
    [ '규칙은 코드를 실행하므로 주인만 시험하거나 남길 수 있습니다', nl,
      '  주인은 "owner":true라고 합니다.' ].
session_ko(owner_alone(save)) -->
    [ '저장은 주인만 합니다. 학생이 바꾼 것은 그 학생에게만 남습니다' ].
session_ko(owner_alone(class)) -->
    [ '모두의 답은 주인만 봅니다' ].
session_ko(owner_alone(show)) -->
    [ '모두에게 보여 주는 것은 주인만 합니다' ].
session_ko(no_class) -->
    [ '여기에는 문제를 푸는 수업이 없습니다', nl,
      '  시작하십시오: sanggwan serve --problems FILE' ].
session_ko(answers_inside(File)) -->
    [ '~w에는 이 수업의 답이 들어 있어 선생님만 엽니다'-[File] ].
session_ko(not_in_class) -->
    [ '누구의 답인지 알아야 합니다. 먼저 이름을 쓰십시오' ].
session_ko(owner_alone(journal)) -->
    [ '일지에 코드를 실행하는 규칙이 있어 주인만 다시 할 수 있습니다', nl,
      '  주인은 "owner":true라고 합니다. "replay":false는 변경을 뺍니다.' ].
session_ko(not_offered(Do)) -->
    [ '페이지에서는 "~w" 요청을 하지 않습니다'-[Do] ].
session_ko(outside(File)) -->
    [ '이 스튜디오의 폴더에 있는 모델이 아닙니다: ~w'-[File], nl,
      '  그 폴더에서 시작하십시오: sanggwan serve MODEL' ].
session_ko(too_many(Most)) -->
    [ '이 페이지에서 기다리는 요청이 ~D개를 넘습니다'-[Most], nl,
      '  답이 온 뒤에 다시 요청하십시오.' ].
session_ko(session_ended) -->
    [ '세션이 답하기 전에 끝났습니다', nl,
      '  답한 것은 모두 남아 있고 이 요청은 하지 않았습니다.' ].
session_ko(open_to_others(Host, Port)) -->
    [ '~w:~w 주소에 닿고 아래 주소를 아는 사람은 누구나 이 모델을 보고 고칩니다. \c
       암호화는 없습니다'-[Host, Port], nl,
      '  코드를 실행하는 규칙은 거기서 바꾸지 못합니다. --host를 빼면 이 \c
       컴퓨터에서만 열 수 있습니다.' ].
session_ko(book_damaged(Path, Count, Kept)) -->
    [ '학급 기록 ~w의 ~D줄이 기록된 그대로가 아닙니다. 그 줄을 빼고 이어 가며, 원래 \c
       기록은 ~w에 그대로 두었습니다'-[Path, Count, Kept], nl,
      '  정전 뒤에는 아무에게도 알리지 않은 답의 줄이 반만 남아 있을 수 있습니다.' ].
session_ko(behind(URL, Place)) -->
    [ '~w의 프록시를 지나고 아래 주소를 아는 사람은 누구나 이 모델을 보고 \c
       고칩니다'-[URL], nl,
      '  이 프로그램은 ~w에서 받습니다. 코드를 실행하는 규칙은 거기서 바꾸지 \c
       못합니다.'-[Place] ].
session_ko(too_many_uploads(Most)) -->
    [ '보낸 파일이 이미 ~D개라 더 보낼 수 없습니다'-[Most], nl,
      '  이미 있는 이름으로 보내면 그것을 바꿉니다.' ].
session_ko(too_many_sessions(Most)) -->
    [ '스튜디오에 이미 세션이 ~D개 있어 더 열 수 없습니다'-[Most], nl,
      '  다른 사람이 나간 뒤 다시 시도하십시오.' ].
session_ko(nothing_tried) -->
    [ '시험하는 규칙이 없습니다', nl,
      '  먼저 시험하십시오: 규칙의 글을 본문으로 하여 "do":"rules".' ].

session_ko(does(hello)) -->
    [ '상대가 누구이고 무엇을 하는지 말합니다' ].
session_ko(does(run)) -->
    [ '빈 세계에서 명령을 실행합니다' ].
session_ko(does(stop)) -->
    [ '하던 일과 기다리는 일을 끝냅니다' ].
session_ko(does(help)) -->
    [ '세션이 하는 일이나 낱말의 뜻을 말합니다' ].
session_ko(does(complete)) -->
    [ '낱말의 처음이 무엇이 될 수 있는지 말합니다' ].
session_ko(does(open)) -->
    [ '모델을 문서로 엽니다' ].
session_ko(does(view)) -->
    [ '문서를 그립니다' ].
session_ko(does(ask)) -->
    [ '목표의 답을 찾습니다' ].
session_ko(does(next)) -->
    [ '질문의 답을 더 줍니다' ].
session_ko(does(explain)) -->
    [ '문서의 어떤 것이 왜 그러한지 말합니다' ].
session_ko(does(export)) -->
    [ '문서로 명령을 실행합니다' ].
session_ko(does(select)) -->
    [ '문서에 있는 이름이 무엇인지 말하고 기억합니다' ].
session_ko(does(sheet)) -->
    [ '문서를 용지에 배치하여 획으로 줍니다' ].
session_ko(does(shaded)) -->
    [ '문서를 음영 그림(PNG)으로 그립니다' ].
session_ko(does(unfold)) -->
    [ '문서를 전개하여 획으로 줍니다' ].
session_ko(does(fold)) -->
    [ '문서를 전개하여 FOLD 파일로 줍니다' ].
session_ko(does(problems)) -->
    [ '파일에 있는 문제들을 보입니다' ].
session_ko(does(problem)) -->
    [ '문제를 내고 답이 맞는지 말합니다' ].
session_ko(does(edit)) -->
    [ '모델의 수 하나를 바꿉니다' ].
session_ko(does(cut)) -->
    [ '전개도에서 모서리를 자를지 이을지 정합니다' ].
session_ko(does(question)) -->
    [ '질문을 모델과 함께 남기거나 지웁니다' ].
session_ko(does(text)) -->
    [ '모델의 글을 주거나 다른 글로 바꿉니다' ].
session_ko(does(tree)) -->
    [ '텍스트의 세그먼트와 매개변수를 양식에 보일 꼴로 줍니다' ].
session_ko(does(undo)) -->
    [ '마지막 변경을 되돌립니다' ].
session_ko(does(redo)) -->
    [ '되돌린 것을 다시 합니다' ].
session_ko(does(rules)) -->
    [ '결정을 늘어놓습니다. 규칙을 시험하고 남기거나 버립니다' ].
session_ko(does(reload)) -->
    [ '다른 프로그램이 파일에 쓴 글을 가져옵니다' ].
session_ko(does(save)) -->
    [ '모델의 글을 파일에 씁니다' ].

said_alone(no_view(_, _, _)).
said_alone(no_segment(_, _)).

wanted_ko(verb) -->
    [ '["draw", "tee.pl", "-o", "tee.svg"]처럼 명령과 그 인자. 문자 0은 없이' ].
wanted_ko(request) -->
    [ '할 일. "run"처럼' ].
wanted_ko(language) -->
    [ '"en" 또는 "ko"' ].
wanted_ko(positive) -->
    [ '0보다 큰 수' ].
wanted_ko(least(Megabytes)) -->
    [ '~D 이상. 세션이 이미 그만큼 쓰고 있습니다'-[Megabytes] ].
wanted_ko(goal) -->
    [ '목표. "segment(S, Kind, Name)"처럼' ].
wanted_ko(ask) -->
    [ '답이 남은 질문의 id' ].
wanted_ko(file) -->
    [ '모델의 이름. "tee.pl"처럼' ].
wanted_ko(journal) -->
    [ 'true 또는 파일 이름' ].
wanted_ko(set) -->
    [ '{"segment":2, "path":[1,1], "value":0.8} 또는 {"param":"d", \c
       "value":80}' ].
wanted_ko(item) -->
    [ '설명할 것. "line(1)"처럼' ].
wanted_ko(options) -->
    [ '명령의 옵션 리스트' ].
wanted_ko(export) -->
    [ '모델이 없는 명령과 옵션' ].
wanted_ko(offered) -->
    [ '파일을 읽거나 쓰지 않는 옵션의 리스트' ].
wanted_ko(download) -->
    [ '파일의 이름, 예를 들어 "tee.pdf"' ].
wanted_ko(port) -->
    [ '포트의 이름' ].
wanted_ko(format) -->
    [ '"strokes", "svg", "json", "pdf", "png", "dxf" 가운데 하나' ].
wanted_ko(view) -->
    [ '시점의 이름, 또는 [theta, phi]나 [theta, phi, rho]' ].
wanted_ko(section) -->
    [ '"x=5", "x", "1,0,0,-5" 같은 평면' ].
wanted_ko(factor) -->
    [ '0부터 100까지의 수' ].
wanted_ko(one_cut) -->
    [ '"section"과 "explode" 가운데 하나' ].
wanted_ko(size) -->
    [ '[너비, 높이] 밀리미터' ].
wanted_ko(segments) -->
    [ '세그먼트 번호의 리스트' ].
wanted_ko(no_view(Name, Near, All)) -->
    { atomic_list_concat(All, ', ', Known) },
    [ '"~w"(이)라는 시점은 없습니다'-[Name] ],
    meant_ko(Near),
    [ nl, '  있는 것: ~w. 또는 [theta, phi]도.'-[Known] ].
wanted_ko(no_segment(S, [])) -->
    [ '세그먼트 ~p은(는) 없습니다. 그림에 세그먼트가 없습니다'-[S] ].
wanted_ko(no_segment(S, [First|More])) -->
    { atomic_list_concat([First|More], ', ', Known) },
    [ '그림에 세그먼트 ~p은(는) 없고 ~w이(가) 있습니다'-[S, Known] ].
wanted_ko(id) -->
    [ '답이 지닐 정수 또는 글' ].
wanted_ko(word) -->
    [ '낱말. "line/9"처럼' ].
wanted_ko(text) -->
    [ '낱말의 처음. 200자까지' ].
wanted_ko(question) -->
    [ '질문의 이름' ].
wanted_ko(question_goal) -->
    [ '목표의 텍스트, 또는 null' ].
wanted_ko(names) -->
    [ '이름의 리스트. ["s1e7", "s2"]처럼, 1,000개까지' ].
wanted_ko(edge) -->
    [ '"segment"는 번호, "edge"는 번호 또는 "base-side(3)" 같은 이름, \c
       "keep"은 true, false 또는 null' ].
wanted_ko(segment) -->
    [ '세그먼트의 번호' ].
wanted_ko(sheet(Sheets)) -->
    [ '1부터 ~d까지의 용지 번호'-[Sheets] ].
wanted_ko(upload) -->
    [ '폴더 없는 모델 이름 (.pl, .csg, .stl, .off, .obj, .ply)' ].
wanted_ko(pupil) -->
    [ '60자까지의 이름' ].
wanted_ko(variant(Count)) -->
    [ '1부터 ~d까지의 변형 번호'-[Count] ].
wanted_ko(answers(Count)) -->
    [ '글 ~d개의 리스트'-[Count] ].
wanted_ko(boolean) -->
    [ 'true 또는 false' ].
wanted_ko(one_of(Words)) -->
    { atomic_list_concat(Words, ', ', All) },
    [ '다음의 하나: ~w'-[All] ].
