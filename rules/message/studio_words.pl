:- encoding(utf8).
:- module(sg_studio_words,
          [ studio_word/3               % ?Key, -English, -Korean
          ]).
/** <module> The words of the studio's page, in both languages.
*/

%!  studio_word(?Key, -English, -Korean) is nondet.
%
%   What the page says for Key; {0}, {1} are filled in there.

studio_word(title, 'Sanggwan', '상관').
studio_word(saved, 'saved', '저장됨').
studio_word(changed, 'not saved', '저장 안 됨').
studio_word(connecting, 'connecting …', '연결하는 중 …').
studio_word(away,
    'The program does not answer. What it answered before is kept; the \c
     page tries again.',
    '프로그램이 답하지 않습니다. 지금까지 답한 것은 남아 있으며 페이지가 다시 연결합니다.').
studio_word(no_secret,
    'This address is not complete, or of an earlier start. Open the one \c
     that the program printed.',
    '주소가 완전하지 않거나 이전 실행의 것입니다. 프로그램이 출력한 주소를 여십시오.').
studio_word(undo, 'Undo', '실행 취소').
studio_word(redo, 'Redo', '다시 실행').
studio_word(save, 'Save', '저장').
studio_word(export, 'Export', '내보내기').
studio_word(open, 'Open', '열기').
studio_word(upload, 'A file of this computer …', '이 컴퓨터의 파일 …').
studio_word(show_all, 'Show to all', '모두에게 보이기').
studio_word(taught, 'shown by the teacher', '선생님이 보여 줌').
studio_word(language, '한국어', 'English').
studio_word(tree, 'Tree', '트리').
studio_word(form, 'Sizes', '치수').
studio_word(text, 'Text', '텍스트').
studio_word(rules, 'Rules', '규칙').
studio_word(ask, 'Ask', '질문').
studio_word(ask_why, 'Ask, why', '질문·이유').
studio_word(why, 'Why', '이유').
studio_word(question, 'Question', '질문').
studio_word(parameters, 'Parameters', '매개변수').
studio_word(no_sizes, 'Choose a segment in the tree.', '트리에서 세그먼트를 고르십시오.').
studio_word(no_numbers, 'It has no sizes of its own.', '고칠 치수가 없습니다.').
studio_word(no_why,
    'Click a line: here stands why it is drawn so.',
    '선을 누르면 왜 그렇게 그려졌는지 여기에 나옵니다.').
studio_word(nothing_why, 'There is no more to say of it.', '더 설명할 것이 없습니다.').
studio_word(shows, 'seen with it', '함께 보이는 것').
studio_word(answers, '{0} answers', '답 {0}개').
studio_word(answers_here, 'Answers', '답').
studio_word(one_answer, '1 answer', '답 1개').
studio_word(answers_cut, 'the first {0} answers', '처음 답 {0}개').
studio_word(no_answers, 'no answers', '답이 없습니다').
studio_word(no, 'no', '아니요').
studio_word(none_hold,
    'It holds of nothing in this model.',
    '이 모델에는 해당하는 것이 없습니다.').
studio_word(earlier,
    'answers of before: ask again',
    '바뀌기 전의 답입니다. 다시 물으십시오.').
studio_word(details, 'Details', '자세히').
studio_word(yes, 'yes', '예').
studio_word(more, '{0} more', '{0}개 더').
studio_word(save_question, 'Keep', '남기기').
studio_word(question_name,
    'Called (Enter keeps it with the model):',
    '질문의 이름 (엔터를 누르면 모델과 함께 남습니다):').
studio_word(saved_questions, 'Questions kept with the model', '모델과 함께 남긴 질문').
studio_word(remove_question, 'Remove the question {0}', '질문 {0} 지우기').
studio_word(clear, 'Clear', '지우기').
studio_word(view, 'View of this port', '이 뷰포트의 투상도').
studio_word(iso, 'pictorial', '입체도').
studio_word(front, 'front', '정면도').
studio_word(top, 'top', '평면도').
studio_word(right, 'right', '우측면도').
studio_word(left, 'left', '좌측면도').
studio_word(back, 'back', '배면도').
studio_word(bottom, 'bottom', '저면도').
studio_word(unfold, 'flat pattern', '전개도').
studio_word(segment_of, 'Segment of the pattern', '전개할 세그먼트').
studio_word(all_segments, 'all', '전부').
studio_word(folded, 'folded up', '접기').
studio_word(section, 'section', '단면도').
studio_word(shaded, 'shaded', '음영').
studio_word(sheet, 'sheet', '도면 용지').
studio_word(apart, 'cells apart', '셀 분해').
studio_word(plane, 'Where the plane cuts', '절단 평면의 위치').
studio_word(cut_face, 'Here the plane {0} cuts this face.',
            '절단 평면({0})이 이 면을 자르는 선이다.').
studio_word(plane_at, '{0} = {1}', '{0} = {1}').
studio_word(axis, 'Axis of the plane', '절단 평면의 축').
studio_word(apart_by, 'How far apart', '벌리는 정도').
studio_word(fold_by, 'How far it is folded', '접은 정도').
studio_word(shade, 'Shading', '음영 방식').
studio_word(shade_lambert, 'matt', '무광').
studio_word(shade_gooch, 'cold to warm', '찬 색에서 따뜻한 색').
studio_word(shade_cel, 'steps', '단계').
studio_word(shade_zebra, 'stripes', '줄무늬').
studio_word(shade_flat, 'flat', '단색').
studio_word(paper, 'Paper', '용지').
studio_word(pens, 'pens', '펜').
studio_word(pen_way, 'How far the pens are', '펜이 간 정도').
studio_word(pen_sums,
    '{0} pens, {1} strokes: {2} m drawn, {3} m lifted, {4} min at 200 mm/s',
    '펜 {0}개, 획 {1}개: 그리기 {2} m, 들기 {3} m, 200 mm/s로 {4}분').
studio_word(pen_sum,
    'pen {0}: {1} strokes, {2} m drawn, {3} m lifted, {4} min',
    '펜 {0}: 획 {1}개, 그리기 {2} m, 들기 {3} m, {4}분').
studio_word(shaded_picture, 'shaded picture of {0}', '{0}의 음영 그림').
studio_word(shaded_of, 'shaded', '음영').
studio_word(folded_of,
    'pattern of {0} faces, being folded',
    '면 {0}개의 전개도, 접는 중').
studio_word(no_folds, 'rolled: it has no folds', '접는 선 없이 말아서 만듭니다').
studio_word(larger, 'This port alone', '이 뷰포트만').
studio_word(next_port, 'Next port', '다음 뷰포트').
studio_word(previous_port, 'Previous port', '이전 뷰포트').
studio_word(ports, 'Ports', '뷰포트').
studio_word(hidden, 'Hidden lines', '숨은선').
studio_word(dashed, 'dashed', '파선').
studio_word(removed, 'left out', '생략').
studio_word(shown, 'drawn through', '실선').
studio_word(lines, 'Lines', '선').
studio_word(feature, 'edges of the shape', '형상의 모서리').
studio_word(all, 'all edges', '모든 모서리').
studio_word(penetration, 'penetration lines alone', '상관선만').
studio_word(too_long,
    'This is more than a megabyte. Open it as a file of this computer.',
    '1메가바이트보다 깁니다. 이 컴퓨터의 파일로 여십시오.').
studio_word(up, 'Axis that points up', '위를 향하는 축').
studio_word(two_windows, 'In a window of its own', '따로 창으로').
studio_word(central, 'Perspective', '중심 투상').
studio_word(file, 'File', '파일').
studio_word(menu, 'View', '보기').
studio_word(solid, 'Solid', '입체').
studio_word(unfolding, 'Unfold', '전개').
studio_word(sheets, 'Sheet', '도면').
studio_word(fit, 'Fit the port', '뷰포트에 맞춤').
studio_word(views, 'Views', '투상도').
studio_word(cuts, 'Sections', '단면').
studio_word(scale, 'Scale', '척도').
studio_word(unit, 'Unit', '단위').
studio_word(angle, 'Angle', '각법').
studio_word(auto, 'as fits', '자동').
studio_word(third, 'third', '제3각법').
studio_word(first, 'first', '제1각법').
studio_word(inch, 'inch', '인치').
studio_word(isometric, 'isometric', '등각 투상도').
studio_word(title_block, 'Title block in the text', '텍스트의 표제란').
studio_word(half_ports, 'ports', '뷰포트').
studio_word(half_left, 'tree, text, questions', '트리·텍스트·질문').
studio_word(turn,
    'Drag, or use the arrow keys, to turn. Enter goes into the lines.',
    '끌거나 화살표 키로 돌립니다. 엔터를 누르면 선으로 들어갑니다.').
studio_word(drawing,
    '{0}: {1} lines, {2} of them hidden',
    '{0}: 선 {1}개, 그중 숨은선 {2}개').
studio_word(ms, '{0} ms', '{0} ms').
studio_word(line, 'line {0}', '선 {0}').
studio_word(restarted,
    'The session ended and began again; all that was answered is there.',
    '세션이 끝나서 다시 시작했습니다. 응답한 것은 모두 남아 있습니다.').
studio_word(file_new,
    'The file was changed by another program, and the model here.',
    '다른 프로그램이 파일을 고쳤고, 여기서도 모델을 고쳤습니다.').
studio_word(take, 'Take the file', '파일 내용 가져오기').
studio_word(taken,
    'The file was changed by another program; its text was taken. Undo \c
     takes it back.',
    '다른 프로그램이 고친 파일의 텍스트를 가져왔습니다. 실행 취소로 되돌립니다.').
studio_word(compare_texts, 'Compare', '비교').
studio_word(keep_mine, 'Keep what is here', '여기 내용 두기').
studio_word(in_file, 'In the file', '파일').
studio_word(in_page, 'Here', '여기').
studio_word(keep_rules, 'Keep', '유지').
studio_word(discard, 'Discard', '버리기').
studio_word(came, '{0} came', '{0}개 생김').
studio_word(went, '{0} went', '{0}개 없어짐').
studio_word(changed_role, '{0} changed their role', '{0}개 역할이 바뀜').
studio_word(decisions, 'Decisions', '결정').
studio_word(recover, 'Take the journal', '일지 내용 가져오기').
studio_word(forget, 'Discard the journal', '일지 버리기').
studio_word(force, 'Write it nevertheless', '그래도 쓰기').
studio_word(close, 'Close', '닫기').
studio_word(replayed,
    'Changes of last time are there again: {0}',
    '지난번에 바꾼 것 {0}개를 되살렸습니다.').
studio_word(cut, 'Cut here', '여기서 자르기').
studio_word(join, 'Keep joined', '이어 두기').
studio_word(either, 'Either', '상관없음').
studio_word(help, 'Help', '도움말').
studio_word(find, 'Find a command, a name or a predicate',
    '명령, 이름, 술어 찾기').
studio_word(pointing,
    'Drag turns · wheel or two fingers: closer · click a line: why · double \c
     click it, or hold a finger on it: its goal',
    '끌기: 돌리기 · 휠 또는 두 손가락: 확대 · 선 클릭: 이유 · 선 두 번 클릭 또는 \c
     길게 누르기: 목표').
studio_word(problems, 'Problems', '문제').
studio_word(problem, 'problem', '문제').
studio_word(pupils, 'Pupils', '학생').
studio_word(pupil_name, 'Name', '이름').
studio_word(begin, 'Begin', '시작').
studio_word(variant, 'Variant', '변형').
studio_word(check, 'Check', '확인').
studio_word(show_answer, 'Show the answer', '정답 보기').
studio_word(show_noted,
    'Show it: your teacher sees that',
    '그래도 보기 (선생님께 표시됩니다)').
studio_word(draw_rest,
    'What is to be drawn, draw on paper; the answer sheet shows it.',
    '그릴 것은 종이에 그리십시오. 정답지에서 볼 수 있습니다.').
studio_word(compare,
    'The sheet shows the answer: compare your drawing with it.',
    '정답지가 나와 있습니다. 그린 것과 비교하십시오.').
studio_word(said_right, 'Right.', '맞습니다.').
studio_word(said_more, 'Too great.', '너무 큽니다.').
studio_word(said_less, 'Too small.', '너무 작습니다.').
studio_word(said_no_number, 'Not a number.', '수가 아닙니다.').
studio_word(said_none, 'Nothing is written here yet.', '아직 답이 없습니다.').
studio_word(it_is, 'It is {0}.', '정답: {0}.').
studio_word(was_shown, 'was shown', '정답을 보았음').
studio_word(not_yet, 'not right yet', '아직 틀림').
studio_word(tries, '{0} tries', '{0}번').
studio_word(working, 'working …', '계산 중 …').
studio_word(stop, 'Stop', '중단').
studio_word(page_of, 'this page', '이 페이지').
studio_word(keeping,
    'making a file of the page: {0} %',
    '페이지를 파일로 만드는 중: {0} %').
studio_word(kept_only,
    'This page is a file: it has what was recorded. The program can do more.',
    '이 페이지는 파일이므로 기록된 것만 있습니다. 프로그램에서는 더 할 수 있습니다.').
studio_word(drawing_of, 'drawing', '도면').
studio_word(pattern_of, 'flat pattern', '전개도').
studio_word(model_of, 'model', '모델').
