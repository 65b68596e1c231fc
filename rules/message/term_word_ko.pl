:- encoding(utf8).
:- module(sg_term_word_ko,
          [ term_word_ko/2              % ?Word, -Korean
          ]).
/** <module> What the words of a segment's term are called in Korean: kinds of
solids, operations, placements, and sizes.

A form shows the model's own word beside it, which is what the text says.
*/

%!  term_word_ko(?Word:atom, -Korean:atom) is nondet.

% Kinds.

term_word_ko(bezier, '베지에 곡면').
term_word_ko(box, '상자').
term_word_ko(circle, '원').
term_word_ko(cone, '원뿔').
term_word_ko(cylinder, '원기둥').
term_word_ko(egg, '달걀꼴').
term_word_ko(elbow, '엘보').
term_word_ko(ellipse, '타원').
term_word_ko(hemisphere, '반구').
term_word_ko(hollow_cylinder, '속 빈 원기둥').
term_word_ko(line, '선분').
term_word_ko(mitred_pipe, '마이터 이음 관').
term_word_ko(open_transition, '열린 변환관').
term_word_ko(polygon, '다각형').
term_word_ko(polyhedron, '다면체').
term_word_ko(prism, '각기둥').
term_word_ko(pyramid, '각뿔').
term_word_ko(rectangle, '직사각형').
term_word_ko(sheet, '면 모음').
term_word_ko(sphere, '구').
term_word_ko(torus, '원환체').
term_word_ko(transition, '변환관').
term_word_ko(turning, '회전체').
term_word_ko(wye, 'Y관').

% Operations.

term_word_ko(difference, '차집합').
term_word_ko(glue, '접합 연산').
term_word_ko(intersection, '교집합').
term_word_ko(join, '이어 붙이기').
term_word_ko(split, '나누기').
term_word_ko(union, '합집합').

% Placements.

term_word_ko(matrix, '행렬').
term_word_ko(mirror, '대칭').
term_word_ko(normal, '법선').
term_word_ko(plane, '평면').
term_word_ko(rotate, '회전').
term_word_ko(scale, '배율').
term_word_ko(translate, '이동').

% Sizes.

term_word_ko(angle, '각도').
term_word_ko(as, '나눌 윤곽').
term_word_ko(bands, '띠 수').
term_word_ko(base, '밑면').
term_word_ko(diameter, '지름').
term_word_ko(divided, '분할 수').
term_word_ko(down, '아래 높이').
term_word_ko(ends, '양 끝 길이').
term_word_ko(faces, '면').
term_word_ko(facets, '작은 면 수').
term_word_ko(from, '시작점').
term_word_ko(height, '높이').
term_word_ko(holes, '구멍').
term_word_ko(inner, '안쪽 반지름').
term_word_ko(legs, '다리 길이').
term_word_ko(outline, '윤곽').
term_word_ko(patches, '곡면 조각').
term_word_ko(pieces, '조각 수').
term_word_ko(points, '점').
term_word_ko(radius, '반지름').
term_word_ko(shift, '치우침').
term_word_ko(sides, '단면의 면 수').
term_word_ko(size, '크기').
term_word_ko(slices, '층 수').
term_word_ko(smooth, '매끄럽게').
term_word_ko(stem, '줄기 길이').
term_word_ko(through, '지나는 점').
term_word_ko(tilt, '기울기').
term_word_ko(to, '끝점').
term_word_ko(tolerance, '허용 오차').
term_word_ko(top, '윗면').
term_word_ko(tube, '관 반지름').
term_word_ko(turn, '돌리기').
term_word_ko(twist, '비틀림').
term_word_ko(up, '위 높이').
