:- module(sg_usage_render,
          [ render_option/1,            % ?Spec
            shown_option/1,             % ?Spec
            render_option_ko/2,         % ?Name, -Help
            render_example/1            % -Command
          ]).
:- encoding(utf8).
:- use_module(library(lists), [member/2]).
/** <module> The options of the verb render (usage.pl).
*/

%!  render_option(?Spec) is nondet.
%
%   Spec is an option as in arguments.pl.

render_option(option(output, o, each, 'FILE',
    'where to (.png .ppm, .pl: spans, looks and view as facts); may be \c
     repeated')).
render_option(option(format, '', one_of([png, ppm, pl]), 'FORMAT',
    'the format for -o -')).
render_option(option(size, '', value, 'WxH',
    'dots, such as 640x400; default 1260x888')).
render_option(option(window, '', value, 'X1,Y1,X2,Y2[,D]',
    'this part of the picture fills the frame, in its own units, in \c
     perspective measured at the distance D from the eye, else at what is \c
     nearest; without it what is seen, with a margin')).
render_option(option(smooth, '', one_of(['1', '2', '4', '8', '16']), 'N',
    'scan lines that cross a dot (4, as is usual)')).
render_option(option(shade, '', value, 'SHADE',
    'lambert (as is usual), gooch (cold to warm), cel=N (N steps), zebra=N (N \c
     stripes along which it is equally light), flat or xray')).
render_option(option(edges, '', flag, '',
    'a black line where other faces begin')).
render_option(option(shadows, '', flag, '',
    'what is behind something, seen from a light, has none of that light')).
render_option(option(surface, '', one_of([true, facets]), 'WHICH',
    'what is round as it is (true, as is usual), or the facets that files \c
     have')).
render_option(option(colours, '', one_of([root, leaf]), 'BY',
    'what says no colour has one by its root (as is usual) or its leaf')).
render_option(option(look, '', value, 'FILE',
    'colours and lights: facts such as look(1, colour(red)) (docs/render.md)')).
render_option(option(light, '', value, 'X,Y,Z',
    'the light comes from there in the picture: X to the right, Y up, Z \c
     towards the eye')).
render_option(option('see-through', '', each, 'N[=A]',
    'segment N, a number or a name, lets through what is behind it; A: how \c
     opaque it is, 0 to 1 (0.3, as is usual); may be repeated')).
render_option(option(section, '', each, 'PLANE',
    'cut open and hatched at x=5, y=5 or z=5; at x, y or z, through the \c
     middle; or at A,B,C,D, without what is where A*X + B*Y + C*Z + D > 0; \c
     may be repeated')).
render_option(option(background, '', value, 'COLOUR',
    'a name, or R,G,B, 0 to 255 (white, as is usual); none: clear, in .png')).
render_option(option(palette, '', value, 'N',
    'no more than N colours (2 to 256), as on the screens of 1989')).
render_option(option(buffer, '', each, 'KIND=FILE',
    'what is known of the dots: depth=FILE.pfm, normal=FILE.pfm, \c
     tone=FILE.pgm, id=FILE.csv (docs/render.md); may be repeated')).
render_option(option(spans, '', value, 'FILE.csv',
    'what is seen on each line, as rows')).
render_option(option('scan-line', '', each, 'Y=FILE',
    'the scan line Y dots below the upper edge as a drawing, seen from above: \c
     slices of the faces, those that may be seen wider, what is seen red; may \c
     be repeated')).
render_option(option(dpi, '', number(1,1000000), 'N',
    'dots to the inch, written into a .png')).

%!  shown_option(?Spec) is nondet.
%
%   Those that say how a picture is shown: explain pixel(X, Y) has them too.

shown_option(Spec) :-
    Spec = option(Name, _, _, _, _),
    member(Name, [ size, window, smooth, shade, colours, look, light,
                   'see-through', section, background, palette, shadows,
                   surface ]),
    render_option(Spec).

%!  render_option_ko(?Name, -Help) is nondet.
%
%   The same in Korean, where no other verb has it.

render_option_ko(output,
    '결과 파일 (.png .ppm, .pl: 구간과 모습과 시점). 여러 번 쓸 수 있다').
render_option_ko(edges, '다른 면이 시작하는 곳에 검은 선').
render_option_ko(shadows, '빛 쪽에서 보아 무엇의 뒤에 있으면 그 빛을 받지 않는다').
render_option_ko(surface,
    '둥근 것을 그대로(true, 기본값), 또는 파일에 있는 대로 평면으로(facets)').
render_option_ko(spans, '각 주사선에 보이는 것을 행으로 적는다').
render_option_ko(size, '점의 수. 640x400 등. 기본값 1260x888').
render_option_ko(window,
    '그림의 이 부분(그림 자신의 단위)이 틀을 채운다. 투시도에서는 눈에서 D만큼 떨어진 \c
곳에서 잰 단위이고, D가 없으면 가장 가까운 것의 자리에서 잰다. 없으면 보이는 것 모두와 여백').
render_option_ko(smooth, '한 점을 지나는 주사선의 수 (기본값 4)').
render_option_ko(shade,
    'lambert(기본값), gooch(찬 색에서 따뜻한 색으로), cel=N(N단계), zebra=N(밝기가 \c
같은 N개의 줄무늬), flat, xray(X선)').
render_option_ko(colours,
    '색이 정해지지 않은 것의 색: 루트마다(root, 기본값) 또는 리프마다(leaf)').
render_option_ko(look,
    '색과 빛: look(1, colour(red)) 같은 사실 파일 (docs/render.md)').
render_option_ko(light,
    '빛이 그림에서 오는 쪽: X는 오른쪽, Y는 위, Z는 눈 쪽').
render_option_ko('see-through',
    '세그먼트 N(번호나 이름)을 통해 뒤의 것이 보인다. A: 불투명도 0~1(기본값 0.3). 여러 번 쓸 수 있다').
render_option_ko(section,
    'x=5, y=5, z=5에서, x, y, z는 가운데에서 잘라 해칭한다. A,B,C,D는 \c
A*X + B*Y + C*Z + D > 0인 쪽을 뗀다. 여러 번 쓸 수 있다').
render_option_ko(background,
    '색 이름이나 R,G,B(0~255). 기본값 white. none: 투명(.png)').
render_option_ko(palette, '색은 많아야 N가지(2~256). 1989년의 화면처럼').
render_option_ko(buffer,
    '점마다 아는 것: depth=FILE.pfm(깊이), normal=FILE.pfm(법선), \c
tone=FILE.pgm(밝기), id=FILE.csv \c
(docs/render.md). 여러 번 쓸 수 있다').
render_option_ko('scan-line',
    '위에서 Y점 아래의 주사선을 위에서 본 도면: 면의 절편, 보일 수 있는 것은 굵게, \c
보이는 것은 빨갛게. 여러 번 쓸 수 있다').
render_option_ko(dpi, '.png에 적는 인치당 점의 수').

%!  render_example(-Command) is nondet.

render_example('sanggwan render facts/pipe_tee.pl -o tee.png').
render_example('sanggwan render bracket.csg --view iso --size 1920x1080 \c
-o bracket.png').
render_example('sanggwan render facts/pipe_tee.pl --shade cel=4 \c
--colours leaf --background none -o tee.png').
