:- module(sg_usage_unfold,
          [ unfold_option/1,            % ?Option
            wish_option/1,              % ?Option
            unfold_option_ko/2,         % ?Name, -Help
            unfold_example/1            % -Command
          ]).
:- encoding(utf8).
/** <module> The options of the verb unfold; usage.pl has all others.
*/

%!  unfold_option(?Option) is nondet.
%
%   Option is option(Name, Short, Type, Meta, Help), as in arguments.pl, in the
%   order of the usage text.

unfold_option(option(output, o, each, 'FILE',
    'where to: a drawing (.svg .pdf .eps .ps .png .dxf .hpgl .json), .fold of \c
     origami programs, facts (.pl), a flat mesh (.obj .off); may be repeated')).
unfold_option(option(format, '',
    one_of([svg, pdf, eps, ps, png, dxf, hpgl, json, fold, pl, obj, off]),
    'FORMAT',
    'the format for -o -')).
unfold_option(option(only, '', value, 'S,...',
    'only these segments, by number or name')).
unfold_option(option(cells, '', flag, '',
    'cell by cell: each cell that faces bound is a solid; faces that two \c
     cells have bear the same number in both')).
unfold_option(option(trim, '', one_of([outside, inside]), 'SIDE',
    'first take away what is inside of the other segments, and leave what is \c
     outside; or the other way round')).
unfold_option(option(by, '', value, 'S,...',
    'with --trim: only these trim others')).
unfold_option(option(lines, '', flag, '',
    'without trimming: the penetration lines with the other segments, as is \c
     usual; --no-lines: without them')).
unfold_option(option(faces, '', whole(4,100000000), 'N',
    'first simplify the model to at most N triangles: closed parts stay \c
     closed, and flat faces flat')).
unfold_option(option(root, '', value, 'P',
    'the polygon that the laying out begins with, by number or name, such as \c
     top or side(2)')).
unfold_option(option(cut, '', each, 'E,...',
    'edges that are not to be joined: by number, by their polygons, such as \c
     4-7 or base-side(2), or by their ends, v(1)-v(2)')).
unfold_option(option(keep, '', each, 'E,...',
    'edges that are to be joined before all others')).
unfold_option(option(order, '', each, 'P,...',
    'polygons that are joined one after the other')).
unfold_option(option(remove, '', each, 'P,...',
    'polygons that are left out, such as base,top')).
unfold_option(option(minimize, '', one_of([seam, pieces, longest, area]),
    'WHAT',
    'what should be small: the seam (as is usual), the number of pieces, the \c
     longest weld, or the area of the sheet')).
unfold_option(option(effort, '', whole(0,1000), 'N',
    'how hard to look for a shorter seam: about N million faces may be laid \c
     anew for it; usually 3 for up to 10,000 faces, else 0, and 48 with \c
     --minimize')).
unfold_option(option(true, '', flag, '',
    'what is round is unrolled to its true lengths, not facet by facet: \c
     cylinders, cones, transitions, and spheres in gores or zones')).
unfold_option(option(seam, '', value, 'DEGREES',
    'with --true: the generator at which it is cut open')).
unfold_option(option(generators, '', whole(2,3600), 'N',
    'with --true: so many generators, 2 to 3600, in equal steps, numbered')).
unfold_option(option(half, '', flag, '',
    'with --true: half of what is symmetric')).
unfold_option(option(gores, '', whole(2,360), 'N',
    'with --true: a sphere is cut to so many gores between meridians, 12 as \c
     is usual')).
unfold_option(option(zones, '', whole(2,360), 'N',
    'with --true: a sphere is cut to so many zones between parallels, each a \c
     cone')).
unfold_option(option(chord, '', above(0), 'T',
    'with --true: how far curves may be from true ones, in model units')).
unfold_option(option(table, '', value, 'FILE.csv',
    'with --true: the table of true lengths; of several patterns FILE-1.csv \c
     and so on')).
unfold_option(option(lengths, '', flag, '',
    'with --true: that table on the sheets, as is usual; --no-lengths: \c
     without it')).
unfold_option(option(thickness, '', number(0), 'T',
    'of the plate, in model units: bends take off what they need')).
unfold_option(option(size, '', one_of([inside, middle, outside]), 'WHICH',
    'with --thickness: which side of the plate the model shows (middle, as is \c
     usual)')).
unfold_option(option(kfactor, '', number(0,1), 'K',
    'with --thickness: where the layer is that keeps its length, K times T \c
     from the inside of a bend, 0 to 1; default 0.44, with --true 0.5')).
unfold_option(option('bend-radius', '', number(0), 'R',
    'with --thickness: inside each bend; default T')).
unfold_option(option(relief, '', one_of([square, round, none]), 'HOW',
    'with --thickness: what is cut out of a corner where two bends meet; \c
     default square')).
unfold_option(option(material, '',
    one_of([steel, stainless, aluminium, copper, brass, zinc, titanium]),
    'NAME',
    'with --thickness: the report has the weight of each pattern')).
unfold_option(option(bends, '', flag, '',
    'with --thickness: the bends are numbered on the sheets in their \c
     sequence, with a table of them')).
unfold_option(option('set-in', '', flag, '',
    'with --true, --trim and --thickness: a branch goes through the wall of \c
     the header; without it, it is set on')).
unfold_option(option('other-thickness', '', number(0), 'T',
    'with --true, --trim and --thickness: of the plate of the other segments')).
unfold_option(option(tolerance, '', number(0), 'T',
    'what is nearer than T (model units) touches')).
unfold_option(option(scale, '', value, 'N:M',
    'true scale of the drawing (1:1, as is usual), such as 1:2 or 5:1')).
unfold_option(option(unit, '', one_of([mm, cm, m, inch]), 'UNIT',
    'what one is in the model, for the scale; default mm')).
unfold_option(option(height, '', above(0), 'MM',
    'the scale at which the model is so high')).
unfold_option(option(up, '', one_of([x, y, z]), 'AXIS',
    'with --height: which axis of the model points up (z, as is usual; y in \c
     most .obj files)')).
unfold_option(option(pages, '', whole(1,5000), 'N',
    'the largest scale at which all is on N pages; A4, if --page does not say \c
     another')).
unfold_option(option(fit, '', flag, '',
    'the largest scale at which no piece has to be divided for the page')).
unfold_option(option(page, '', value, 'PAPER',
    'pages of this size, A4 to A0, A3-landscape, letter or WxH in mm; larger \c
     pieces are divided; without it one sheet as large as needed')).
unfold_option(option(tile, '', flag, '',
    'pieces are not divided, but the sheet is, into pages that overlap; A4, \c
     if --page does not say another')).
unfold_option(option(overlap, '', number(0), 'MM',
    'with --tile: how far these overlap; default 10')).
unfold_option(option(margin, '', number(0), 'MM',
    'free all round a page; default 10')).
unfold_option(option(gap, '', number(0), 'MM', 'between pieces; default 3')).
unfold_option(option(kerf, '', number(0), 'MM',
    'how wide a cut is: outlines go outwards by half of that, holes inwards')).
unfold_option(option(tabs, '', number(0), 'MM',
    'tabs to glue, so wide, on one side of each seam')).
unfold_option(option('tab-sides', '', one_of([one, both, alternate]), 'WHICH',
    'with --tabs: on one side of each seam, as is usual, on both, or on the \c
     two in turn')).
unfold_option(option(lap, '', number(0), 'MM',
    'lap seams: an allowance so wide on one side of each seam')).
unfold_option(option('lock-seam', '', number(0), 'MM',
    'grooved lock seams with pockets so wide: one and a half times that on \c
     both sides of each seam, and where it is folded over')).
unfold_option(option('open-slits', '', flag, '',
    'with --tabs: pieces are parted at folds wherever a slit has no room for \c
     tabs; --no-open-slits: nowhere; without either where more than a tenth \c
     of the seam would have none')).
unfold_option(option(numbers, '', flag, '',
    'numbers of partners on both sides of each seam, as is usual; \c
     --no-numbers: none')).
unfold_option(option(names, '', one_of([numbers, words, pieces]), 'HOW',
    'name the faces, by their numbers or by words such as base; or each piece \c
     (as is usual of several patterns)')).
unfold_option(option(angles, '', flag, '', 'how far each fold bends')).
unfold_option(option('fold-threshold', '', number(0), 'DEGREES',
    'folds that bend less are not drawn; default 0.5')).
unfold_option(option(inside, '', flag, '',
    'the patterns as they are seen from inside')).
unfold_option(option(mirror, '', flag, '',
    'also the other hand of each pattern: its mirror image')).
unfold_option(option(grid, '', number(0.5), 'MM',
    'a grid with lines so far apart, 0.5 or more, for a check')).
unfold_option(option(style, '', value, 'FILE',
    'how lines look: a file of facts (docs/drawings.md)')).
unfold_option(option(dashes, '', one_of([auto, geometry, type]), 'HOW',
    'dashes as suits the format (auto), as lines of their own (geometry, for \c
     cutters), or as line types of plotters (type)')).
unfold_option(option(dpi, '', number(1,1000000), 'N',
    'dots to the inch of a .png')).
unfold_option(option(json, '', flag, '', 'the report as JSON')).

%!  wish_option(?Option) is nondet.
%
%   Those that say what is wanted of a pattern, which `explain` has as well.

wish_option(Option) :-
    Option = option(Name, _, _, _, _),
    unfold_option(Option),
    memberchk(Name, [ only,faces,root,cut,keep,order,remove,minimize,effort,
                      trim,by,true,seam,half,gores,zones ]).

%!  unfold_option_ko(?Name, -Help) is nondet.
%
%   Help says in Korean what the option Name does.

unfold_option_ko(only, '이 세그먼트만. 번호나 이름').
unfold_option_ko(cells,
    '세포마다. 면이 둘러싼 세포는 저마다 입체이고, 두 세포가 함께 가진 면은 양쪽에서 번호가 같다').
unfold_option_ko(trim,
    '먼저 다른 세그먼트의 안에 있는 부분을 잘라 내고 바깥(outside)을 남긴다. \c
inside는 그 반대').
unfold_option_ko(by, '--trim과 함께: 이 세그먼트만 다른 것을 잘라 낸다').
unfold_option_ko(lines,
    '잘라 내지 않을 때 다른 세그먼트와의 상관선을 그린다(기본값). --no-lines: 없이').
unfold_option_ko(faces,
    '먼저 모델을 삼각형 N개 이하로 단순화한다. 닫힌 것은 닫힌 채로, 평평한 면은 \c
평평한 채로').
unfold_option_ko(root, '펼치기 시작하는 다각형. 번호나 top, side(2) 같은 이름').
unfold_option_ko(cut,
    '잇지 않을 모서리. 번호, 4-7이나 base-side(2) 같은 두 다각형, 또는 \c
양 끝 v(1)-v(2)').
unfold_option_ko(keep, '다른 것보다 먼저 이을 모서리').
unfold_option_ko(order, '차례로 이어 갈 다각형들').
unfold_option_ko(remove, '뺄 다각형. 보기: base,top').
unfold_option_ko(minimize,
    '줄일 것: seam(접합선의 길이, 기본값), pieces(조각의 수), longest(가장 긴 \c
용접선), area(판재의 넓이)').
unfold_option_ko(effort,
    '더 짧은 접합선을 얼마나 찾을지: 면을 약 N백만 번까지 다시 놓아 본다. 기본값은 \c
면 10,000개까지 3, 더 많으면 0, --minimize와 함께는 48').

unfold_option_ko(true,
    '둥근 것은 면마다가 아니라 실제 길이로 펼친다. 원기둥, 원뿔, 변환관, 그리고 \c
고어나 구대로 나눈 구').
unfold_option_ko(seam, '--true와 함께: 접합선이 될 면소의 각도').
unfold_option_ko(generators,
    '--true와 함께: 번호를 단 등분 면소의 수. 2에서 3600까지').
unfold_option_ko(half, '--true와 함께: 대칭인 것의 반쪽').
unfold_option_ko(gores,
    '--true와 함께: 구를 자오선을 따라 나눈 고어의 수. 기본값 12').
unfold_option_ko(zones,
    '--true와 함께: 구를 위선을 따라 나눈 구대의 수. 구대마다 원뿔이다').
unfold_option_ko(chord, '--true와 함께: 곡선이 참값에서 벗어나도 되는 거리').
unfold_option_ko(table,
    '--true와 함께: 실장(실제 길이)표. 전개도가 여럿이면 FILE-1.csv 등').
unfold_option_ko(lengths,
    '--true와 함께: 그 표를 용지에도 넣는다(기본값). --no-lengths: 넣지 않는다').
unfold_option_ko(thickness, '판재의 두께(모델 단위). 굽힘만큼 줄인다').
unfold_option_ko(size,
    '--thickness와 함께: 모델이 판재의 어느 면인가: inside(안쪽), middle(가운데, \c
기본값), outside(바깥)').
unfold_option_ko(kfactor,
    '--thickness와 함께: 길이가 변하지 않는 층. 굽힘의 안쪽에서 두께의 K배, \c
0에서 1까지. 기본값 0.44, --true는 0.5').
unfold_option_ko('bend-radius',
    '--thickness와 함께: 굽힘의 안쪽 반지름. 기본값은 두께').
unfold_option_ko(relief,
    '--thickness와 함께: 두 굽힘이 만나는 모퉁이를 어떻게 따낼지: square(네모, \c
기본값), round(둥글게), none(그대로)').
unfold_option_ko(material, '--thickness와 함께: 전개도마다 무게를 알린다').
unfold_option_ko(bends,
    '--thickness와 함께: 굽힘의 차례를 용지에 쓰고, 굽힘표를 넣는다').
unfold_option_ko('set-in',
    '--true, --trim, --thickness와 함께: 지관이 주관의 벽을 뚫고 들어간다. \c
없으면 위에 얹힌다').
unfold_option_ko('other-thickness',
    '--true, --trim, --thickness와 함께: 다른 세그먼트의 두께').
unfold_option_ko(scale, '도면의 척도. 1:2, 5:1 등. 기본값 1:1').
unfold_option_ko(height, '모델의 높이가 이만큼 되는 척도').
unfold_option_ko(up,
    '--height와 함께: 모델의 어느 축이 위인가 (기본값 z, .obj 파일은 흔히 y)').
unfold_option_ko(pages,
    '모두 N쪽에 들어가는 가장 큰 척도. --page가 없으면 A4').
unfold_option_ko(fit, '쪽에 맞추어 조각을 나누지 않아도 되는 가장 큰 척도').
unfold_option_ko(page,
    '이 크기의 쪽들. A4~A0, A3-landscape, letter, WxH(mm). 더 큰 조각은 \c
나눈다. 없으면 필요한 크기의 용지 한 장').
unfold_option_ko(tile,
    '조각을 나누지 않고, 용지를 겹치는 쪽들로 나눈다. --page가 없으면 A4').
unfold_option_ko(overlap, '--tile과 함께: 쪽이 겹치는 너비. 기본값 10').
unfold_option_ko(margin, '쪽 둘레의 여백. 기본값 10').
unfold_option_ko(gap, '조각 사이의 간격. 기본값 3').
unfold_option_ko(kerf,
    '절단 폭: 윤곽은 그 반만큼 바깥으로, 구멍은 안쪽으로 옮긴다').
unfold_option_ko(tabs, '접합선마다 한쪽에 붙이는 풀칠면의 너비').
unfold_option_ko('tab-sides',
    '--tabs와 함께: 접합선의 한쪽(one, 기본값), 양쪽(both), 번갈아(alternate)').
unfold_option_ko(lap, '겹침 이음: 접합선마다 한쪽에 이만큼의 여유').
unfold_option_ko('lock-seam',
    '거멀접기(그루브 심): 포켓의 너비. 접합선 양쪽에 그 1.5배의 여유와 접는 선').
unfold_option_ko('open-slits',
    '--tabs와 함께: 틈이 좁아 풀칠면이 들어가지 않는 곳마다 접는 선에서 조각을 나눈다. \c
     --no-open-slits: 나누지 않는다. 둘 다 없으면 접합선의 10분의 1 넘게 풀칠면이 없을 때만').
unfold_option_ko(numbers,
    '접합선 양쪽에 짝의 번호를 쓴다(기본값). --no-numbers: 쓰지 않는다').
unfold_option_ko(names, '면의 이름: numbers(번호)나 words(base 같은 말); pieces: 조각의 이름').
unfold_option_ko(angles, '접는 각도를 쓴다').
unfold_option_ko('fold-threshold', '이보다 적게 꺾이는 곳은 그리지 않는다. 기본값 0.5').
unfold_option_ko(inside, '안쪽에서 본 전개도').
unfold_option_ko(mirror, '전개도마다 좌우 대칭인 것도').
unfold_option_ko(grid, '확인하기 위한 모눈. 간격은 0.5 이상').

%!  unfold_example(-Command) is multi.
%
%   Command is an example for the usage text.

unfold_example('sanggwan unfold facts/cube.pl -o cube.svg').
unfold_example('sanggwan unfold facts/gallery/saddle.pl --trim outside \c
--page A4 -o saddle.pdf').
unfold_example('sanggwan unfold facts/patterns/house.pl --tabs 6 \c
--page A4-landscape -o house.pdf').
unfold_example('sanggwan unfold cow.obj --faces 300 --height 200 --up y \c
--tabs 6 --page A4 -o cow.pdf').
unfold_example('sanggwan unfold pipes.pl --trim outside --only branch \c
--remove base,top -o branch.dxf').
unfold_example('sanggwan unfold facts/patterns/saddle.pl --trim outside \c
--true --generators 24 --table saddle.csv -o saddle.pdf').
unfold_example('sanggwan unfold part.stl --minimize pieces -o part.svg \c
-o part.pl').
