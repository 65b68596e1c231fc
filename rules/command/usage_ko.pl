:- module(sg_usage_ko,
          [ option_ko/2,                % ?Option, -Help
            verb_option_ko/3            % ?Verb, ?Name, -Help
          ]).
:- encoding(utf8).
:- use_module('../picture/role', [usual_crease/1]).
/** <module> What options do, in Korean.

The English stands with the options in usage.pl; those of render and unfold have
their Korean beside them.
*/

%!  option_ko(?Option, -Help) is nondet.
%
%   Help of an option of any verb, in Korean

option_ko(json, '보고를 JSON으로').
option_ko(each,
    '파일마다 따로, 결과도 파일마다. 실패한 파일이 있어도 나머지를 계속한다. \c
-o FILE의 %는 폴더와 확장자를 뺀 파일 이름').
option_ko(region,
    '영역 R만 떼어 입체 하나로. 나머지는 피연산자 없이 붙은 채로 둔다').
option_ko(face, '다각형 P만 떼어 둘로').
option_ko(between, '두 영역 사이의 다각형들만 뗀다').
option_ko(neighbours, '사이에 면이 있는 영역들, 그 면의 수와 넓이도').
option_ko(stdio,
    '페이지 없이 표준 입력과 표준 출력의 프레임 (docs/protocol.md)').
option_ko(port, '브라우저가 찾는 번호. 기본값 1989, 쓰고 있으면 빈 번호').
option_ko(host, '받는 주소. 기본값 127.0.0.1, 이 컴퓨터에서만').
option_ko(class, '학생들이 코드로 들어온다 (코드를 출력한다). 저마다 모델과 \c
                  세션을 하나씩 가진다').
option_ko(problems, '학생들이 페이지에서 푸는 수업의 문제 (docs/problems.md). \c
                     --class와 같이 들어온다').
option_ko(embed, '이 페이지를 틀 안에 보일 수 있는 출처. 보기: https://h.example').
option_ko(behind, '프록시가 페이지를 보이는 주소. 보기: https://h.example/sanggwan/').
option_ko(socket, '번호 대신 유닉스 소켓에서 받는다. --behind의 프록시가 묻는다').
option_ko(open, '이 데스크톱의 브라우저에서 페이지를 연다 (기본)').
option_ko(output, '결과 파일. 확장자가 형식을 정하며 여러 번 쓸 수 있다').
option_ko(format, '-o - 의 형식').
option_ko(close, 'CityJSON: 평평한 곳이 열린 입체를 닫는다').
option_ko(lod, 'CityJSON의 상세 수준. 없으면 객체마다 가장 높은 것').
option_ko(view,
    'front(정면도), back(배면도), left(좌측면도), right(우측면도), top(평면도), \c
bottom(저면도), isometric(등각), dimetric(이축), trimetric(삼축) 또는 \c
각도 THETA,PHI[,RHO](도)').
option_ko(direction, '이 방향으로 본다').
option_ko(eye, '이 점에서 본다').
option_ko(target, '--eye와 함께: 이 점을 본다. 없으면 모델의 가운데').
option_ko(up,
    '모델의 어느 축이 위인가 (기본값 z, .obj 파일은 흔히 y). 먼저 그 축이 \c
z가 되게 모델을 돌리고, 시점, 방향, 단면은 돌린 모델의 것이다').
option_ko(scale, '척도. 1:2, 5:1 등, 또는 fit(자리에 맞추어 가장 크게)').
option_ko(explode,
    '붙인 것의 세포들을 떼어 그린다. 가운데에서 떨어진 거리의 F배만큼 옮긴다').
option_ko(cutaway,
    'x=5, y=5, z=5에서, x, y, z는 가운데에서 잘라 열고 해칭한다. A,B,C,D는 \c
A*X + B*Y + C*Z + D > 0인 쪽을 없앤다. 어디에서나 볼 수 있다(평행 투상)').
option_ko(unit, '척도를 위한 모델의 단위. 기본값 mm').
option_ko(sheet,
    '윤곽선과 표제란이 있는 도면. 용지 A4~A0, A3-portrait(세로), A4-landscape(가로) 등. \c
아래 옵션만 있으면 A3').
option_ko(views,
    '도면의 투상도들. 기본값 front,top,right,isometric').
option_ko(angle, 'first(제1각법) 또는 third(제3각법, 기본값)').
option_ko(section,
    '단면도. x=5, y=5, z=5에서, x, y, z는 가운데에서, A,B,C,D는 \c
A*X + B*Y + C*Z + D > 0인 쪽에서 본다. 여러 번 쓸 수 있다').
option_ko('title-block',
    '표제란의 사실 파일. 보기: title_block(name, "받침대").').
option_ko(language, '표제란의 언어. 기본값은 --lang으로 준 언어, 없으면 en').
option_ko('no-frame', '윤곽선과 표제란 없이').
option_ko(shade,
    '선 아래의 음영: render처럼 lambert, gooch, cel=N, zebra=N, flat. hatch는 \c
펜으로 긋는 음영(모든 형식). 용지에서는 입체도에만').
option_ko(projection, 'parallel(평행 투상) 또는 central(중심 투상, 투시)').
option_ko(hidden, '숨은선: dashed(파선, 기본값), removed(생략), shown(실선)').
option_ko(lines, 'feature(기본값), all(모두), penetration(상관선만)').
option_ko(crease, Help) :-
    usual_crease(Usual),
    format(atom(Help),
           '메시에서 이 각도(기본값 ~w도) 이하로 꺾인 면은 이어진 매끄러운 \c
            곡면으로 본다', [Usual]).
option_ko(segment, '세그먼트 N만. 여러 번 쓸 수 있다').
option_ko(size, '용지 크기 mm. 기본값 210x148').
option_ko(style, '선의 모양을 정하는 사실 파일 (docs/drawings.md)').
option_ko(dashes,
    '파선: auto(형식에 맞게, 기본값), geometry(한 선씩 따로, 절단기), \c
type(플로터의 선 종류)').
option_ko(png, '.png: smooth(매끈한 선, 기본값), dots(1988년 화면의 점. --size는 점의 수)').
option_ko(points,
    '상관선마다 점 N개에 번호를 붙인다. 모든 투상도에서 같은 번호. all: 꺾인 점 모두').
option_ko('centre-lines',
    '용지 없는 그림에도 둥근 것의 중심선을 그린다. 용지(--sheet)에는 언제나 있다').
option_ko('min-line',
    '용지에서 MM보다 짧고 양 끝이 다른 선에 닿지 않는 선은 그리지 않는다(스캔한 \c
메시의 티)').
option_ko(dpi, '매끈한 .png, 또는 다른 파일의 --shade의 인치당 점의 수').
option_ko(exact, '표의 좌표를 반올림하지 않은 분수로').
option_ko(only,
    '꼭짓점, 모서리, 면 가운데 하나와 그것에 딸린 것만 붙인다. 나머지는 자르되 \c
     떨어진 채로 둔다').
option_ko('dry-run',
    '아무것도 쓰지 않는다: 무엇이 붙을지, 접촉과 닿지 않은 틈을 모두').
option_ko(tolerance, 'T(모델 단위)보다 가까우면 닿은 것으로 본다. 0: 그대로').
option_ko(repair,
    '먼저 입체를 고친다: 꼭짓점 합치기, 두 번 있거나 넓이가 없는 면 버리기, \c
뒤집힌 껍질 바로잡기').
option_ko(plane, '평면 A*X + B*Y + C*Z + D = 0').
option_ko(by, '나누는 입체, 또는 끝까지 가르는 열린 곡면').
option_ko(side,
    '평면의 below(A*X + B*Y + C*Z + D < 0)나 above, 곡면의 below(뒤)나 above, \c
입체의 inside나 outside. 없으면 둘 다').
option_ko(jobs, '한꺼번에 할 작업 수, 각각 한 프로세스. 기본값은 프로세서 수').
option_ko(shard,
    '작업의 N개 부분 가운데 I번째만. slurm: 배열의 이 태스크에 맞는 부분').
option_ko(resume, '전에 실패한 작업은 다시 하지 않는다 (끝난 작업은 늘 그렇다)').
option_ko('keep-going', '작업이 실패해도 계속한다').
option_ko(list, '작업 이름만 쓰고 하지는 않는다').
option_ko(report, '작업마다 JSON 한 줄을 표준 출력 대신 이 파일에 쓴다').
option_ko(copy, '결과를 링크가 아니라 복사본으로 둔다').
option_ko(merge, '보고 파일들을 하나로: JSON, JUnit, 그림을 모은 쪽').
option_ko(sheets, '문제 파일로 문제지를 만든다. problems 명령과 같다').
option_ko(limit, '처음 N개의 답만').
option_ko(from, '표준 입력(-)의 형식. 기본값 pl').
option_ko(set, '모델의 매개변수 param(NAME, 기본값)의 값, 수 또는 수로 된 식. \c
     여러 번 쓸 수 있다').
option_ko(rules, '결정을 바꾸는 규칙 파일. 여러 번 쓸 수 있다').
option_ko(limits, '텍스트가 쓸 수 있는 크기: depth, blocks, digits, name, fact, file, \c
text, facets, nodes').
option_ko(strict,
    '경고가 있으면 아무것도 쓰지 않고 종료 코드 1, 점을 옮긴다는 경고면 4').
option_ko(quiet, '알림과 진행 표시 없이').
option_ko(timings, '단계별 시간을 JSON으로 표준 오류에').
option_ko(stats, '행, 바이트, 색인 사용을 JSON으로 표준 오류에').
option_ko(lang, '메시지의 언어').
option_ko(help, '이 설명').

%!  verb_option_ko(?Verb, ?Name, -Help) is nondet.
%
%   Help of an option in Korean, where Verb says another thing.

verb_option_ko(Verb, json, '--each와 함께: 파일마다 JSON 한 줄') :-
    memberchk(Verb, [convert,draw]).
verb_option_ko(explain, json, '이유를 JSON으로').
verb_option_ko(penetrate, json, '요약을 JSON으로').
verb_option_ko(query, json, '--format json과 같다').
verb_option_ko(query, format, 'table(기본값), csv, json 또는 prolog').
verb_option_ko(Verb, Name, Help) :-
    memberchk(Verb, [union,difference,intersection,eval,split]),
    solid_option_ko(Name, Help).
verb_option_ko(Verb, Name, Help) :-
    memberchk(Verb, [problems,batch]),
    sheets_option_ko(Name, Help).
verb_option_ko(problems, output, '결과 폴더. 없으면 만든다').
verb_option_ko(penetrate, output,
    '결과 파일(.pl .obj .dxf .svg, 표 .csv .tsv .txt). 여러 번 쓸 수 있다. 기본값 -, \c
.pl로').
verb_option_ko(draw, output,
    '결과 파일(.svg .pdf .eps .ps .png .dxf .hpgl .json .pl). 여러 번 쓸 수 있다').
verb_option_ko(unfold, output,
    '결과 파일: 도면(.svg .pdf .eps .ps .png .dxf .hpgl .json), 종이접기 프로그램의 \c
.fold, 사실(.pl), 평평한 메시(.obj .off). 여러 번 쓸 수 있다').
verb_option_ko(cells, output,
    '영역이 있는 모델(.pl), 표(.csv, --neighbours와 함께: 이웃한 쌍의 표), 이웃 \c
그래프(.dot), 메시를 만드는 프로그램의 입력(.poly .geo), 면을 한 번씩(.obj .off), \c
CityJSON(.json), 세포를 따로따로(.stl). 여러 번 쓸 수 있다').
verb_option_ko(glue, output,
    '피연산자와 그것을 붙이는 것(.pl). 여러 번 쓸 수 있다').
verb_option_ko(unglue, output, '결과 파일(.pl). 여러 번 쓸 수 있다').
verb_option_ko(glue, repair, '먼저 피연산자를 고친다').
verb_option_ko(unfold, tolerance,
    'T(모델 단위)보다 가까우면 닿은 것으로 본다').
verb_option_ko(unfold, dpi, '.png의 인치당 점의 수').
verb_option_ko(batch, only, '이름이 NAME인 작업만. 여러 번 쓸 수 있다').
verb_option_ko(batch, output,
    '결과 폴더: FOLDER/NAME.svg는 FOLDER/store로 가는 링크. --merge와 함께: 파일 \c
(.json, JUnit의 .xml, .html), 여러 번 쓸 수 있다').

solid_option_ko(json, '개수와 넓이, 부피를 JSON으로').
solid_option_ko(output,
    '결과 파일(.pl .stl .off .obj .ply). 여러 번 쓸 수 있다. 없으면 개수와 넓이, \c
부피를 한 줄로').

sheets_option_ko(format, '도면의 형식. 기본값 svg').
sheets_option_ko(language, '문제의 언어. 기본값 en').
