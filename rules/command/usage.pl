:- module(sg_usage,
          [ verb/4,                     % ?Verb, -Arguments, -Summary, -Ko
            verb_options/2,             % +Verb, -Specs
            job_options/2,              % +Verb, -Specs
            common_option/1,            % ?Spec
            example/2                   % ?Verb, -Command
          ]).
:- encoding(utf8).
:- use_module('../picture/role', [usual_crease/1]).
:- use_module(usage_render,
              [render_option/1, shown_option/1, render_example/1]).
:- use_module(usage_unfold,
              [unfold_option/1, wish_option/1, unfold_example/1]).
:- use_module(library(apply), [exclude/3]).
:- use_module(library(lists), [append/3, member/2]).
/** <module> What the program can do: verbs, options, examples.

These tables are the command line: arguments.pl reads the options they list,
--help (usage_print.pl) prints them, and the man page is made from the same
text. The Korean is in usage_ko.pl.

To add a verb: verb/4, verb_option/2, option_ko/2, example/2, and a clause of
verb_run/3 in verbs.pl.
*/

%!  verb(?Verb, -Arguments, -Summary, -SummaryKo) is nondet.
%
%   The verbs in the order of the usage text.

verb(check, 'MODEL...',
     'counts, box, area, volume, and what is wrong with the model',
     '개수, 크기, 넓이, 부피와 모델의 잘못').
verb(cells, 'MODEL...',
     'the regions of space that faces make, and which of them are neighbours',
     '면들이 공간을 나눈 영역, 서로 이웃한 영역').
verb(glue, 'MODEL MODEL...',
     'one model in which what coincides is there once, with its regions',
     '겹치는 것은 한 번만 있는 한 모델과 그 영역들').
verb(unglue, 'MODEL... -o FILE',
     'the operands of what was glued, as they were',
     '붙인 것의 피연산자들을 원래대로').
verb(convert, 'MODEL... -o FILE',
     'between model files (.pl) and meshes (.stl .off .obj .ply)',
     '모델 파일(.pl)과 메시(.stl .off .obj .ply) 사이의 변환').
verb(penetrate, 'MODEL... [-o FILE]',
     'the penetration lines of all segments, ordered into loops',
     '모든 세그먼트의 상관선, 차례로 이은 루프').
verb(draw, 'MODEL... -o FILE',
     'a drawing with its hidden lines',
     '숨은선을 처리한 도면').
verb(render, 'MODEL... -o FILE',
     'a shaded picture, straight from the CSG trees',
     'CSG 트리에서 바로 그리는 음영 그림').
verb(union, 'MODEL MODEL...',
     'the solid of all that is in any of the models',
     '모델들 가운데 어느 하나에라도 있는 것의 입체').
verb(intersection, 'MODEL MODEL...',
     'the solid of what is in all of the models',
     '모든 모델에 공통으로 있는 것의 입체').
verb(difference, 'MODEL MODEL...',
     'the solid of what is in the first model and in no other',
     '첫 모델에서 다른 모델들을 뺀 입체').
verb(split, 'MODEL... --plane A,B,C,D | --by MODEL',
     'a solid in two, by a plane, another solid or a surface',
     '평면, 다른 입체, 곡면으로 둘로 나눈 입체').
verb(eval, 'TREE...',
     'the solids of a CSG tree',
     'CSG 트리의 입체').
verb(unfold, 'MODEL... [-o FILE]',
     'flat patterns of solids and surfaces, to cut out and fold',
     '입체와 곡면의 전개도, 오려 내어 접는다').
verb(batch, 'MANIFEST -o FOLDER | --merge REPORT... -o FILE',
     'many jobs from a file of facts, in processes of their own',
     '사실 파일에 적힌 많은 작업, 각각 따로 된 프로세스에서').
verb(query, 'MODEL... GOAL',
     'all answers of a Prolog goal about the model',
     '모델에 대한 Prolog 목표의 모든 답').
verb(explain, 'MODEL... ITEM',
     'why a line, a vertex or an edge is there, or two polygons give no line',
     '상관선, 꼭짓점, 모서리가 왜 있는지, 두 다각형에서 왜 상관선이 나오지 않는지').
verb(repl, '[MODEL...]',
     'the Prolog top level with the model loaded',
     '모델을 읽은 Prolog 최상위').
verb(problems, 'FILE -o FOLDER',
     'questions, answers and a key for a class (docs/problems.md)',
     '수업을 위한 문제지, 답안지, 정답 (docs/problems.md)').
verb(serve, '[MODEL] | --stdio',
     'the studio: a model in the browser (docs/studio.md); or a session',
     '스튜디오: 브라우저에서 보는 모델 (docs/studio.md). 또는 세션').

%   verb_option(Verb, Option): Option as in arguments.pl, help in English.

verb_option(check, option(json, '', flag, '', 'the report as JSON')).

verb_option(Verb, option(each, '', flag, '',
    'each file alone, one result for each, also after one that failed; in \c
     -o FILE % is the name of the file without folder and ending')) :-
    each_verb(Verb).
verb_option(Verb, option(json, '', flag, '',
    'with --each: a line of JSON for each file')) :-
    line_of_each(Verb).

verb_option(cells, option(neighbours, '', flag, '',
    'also which regions have faces between them, how many and of what area')).
verb_option(cells, option(json, '', flag, '', 'the report as JSON')).
verb_option(cells, option(output, o, each, 'FILE',
    'the model with its regions (.pl), a table (.csv; with --neighbours of \c
     pairs), a graph of neighbours (.dot), what meshes are made from (.poly \c
     .geo), faces once (.obj .off), CityJSON (.json), cells apart (.stl); \c
     may be repeated')).
verb_option(cells, option(format, '',
    one_of([pl,csv,dot,poly,geo,obj,off,stl,json]), 'FORMAT',
    'the format for -o -')).

verb_option(glue, option(output, o, each, 'FILE',
    'the operands and what glues them (.pl); may be repeated')).
verb_option(glue, option(format, '', one_of([pl]), 'FORMAT',
    'the format for -o -')).
verb_option(glue, option(only, '',
    one_of([vertices,edges,faces]), 'WHAT',
    'glue vertices, edges or faces alone, and what these have; the rest \c
     is cut and stays apart')).
verb_option(glue, option('dry-run', '', flag, '',
    'write nothing: what would be glued, each contact and near miss')).
verb_option(glue, option(tolerance, '', number(0), 'T',
    'what is nearer than T (model units) touches; 0: nothing else does')).
verb_option(glue, option(repair, '', flag, '', 'mend the operands first')).
verb_option(glue, option(neighbours, '', flag, '',
    'also which regions have faces between them, how many and of what area')).
verb_option(glue, option(json, '', flag, '', 'the report as JSON')).
verb_option(unglue, option(region, '', whole(1, 2147483647), 'R',
    'only cell R: it is a solid of its own; the rest stays glued, without \c
     its operands')).
verb_option(unglue, option(face, '', whole(1, 2147483647), 'P',
    'only polygon P, which is there twice then')).
verb_option(unglue, option(between, '', value, 'R1,R2',
    'only the polygons between two regions')).
verb_option(unglue, option(output, o, each, 'FILE',
    'where to (.pl); may be repeated')).
verb_option(unglue, option(format, '', one_of([pl]), 'FORMAT',
    'the format for -o -')).

verb_option(convert, option(output, o, each, 'FILE',
    'where to; the ending decides the format; may be repeated')).
verb_option(convert, option(format, '', one_of([pl, stl, off, obj, ply]),
    'FORMAT', 'the format for -o -')).
verb_option(convert, Option) :-
    Option = option(faces, _, _, _, _),
    unfold_option(Option).

verb_option(penetrate, option(output, o, each, 'FILE',
    'where to (.pl .obj .dxf .svg; tables .csv .tsv .txt); may be repeated; \c
     default: - as .pl')).
verb_option(penetrate, option(format, '',
    one_of([pl, obj, csv, tsv, txt, svg, dxf]),
    'FORMAT', 'the format for -o -')).
verb_option(penetrate, option(exact, '', flag, '',
    'in tables coordinates as fractions, not rounded')).
verb_option(penetrate, option(tolerance, '', number(0), 'T',
    'what is nearer than T (model units) touches; 0: nothing else does')).
verb_option(penetrate, option(json, '', flag, '',
    'print a summary as JSON')).

verb_option(draw, option(output, o, each, 'FILE',
    'where to (.svg .pdf .eps .ps .png .dxf .hpgl .json .pl); may be \c
     repeated')).
verb_option(draw, option(format, '',
    one_of([svg, pdf, eps, ps, png, dxf, hpgl, json, pl]), 'FORMAT',
    'the format for -o -')).
verb_option(Verb, option(view, '', value, 'VIEW',
    'front, back, left, right, top, bottom, isometric, dimetric, \c
     trimetric, or THETA,PHI[,RHO] in degrees')) :-
    looking_verb(Verb).
verb_option(Verb, option(direction, '', value, 'X,Y,Z',
    'look in this direction')) :-
    looking_verb(Verb).
verb_option(Verb, option(eye, '', value, 'X,Y,Z',
    'look from this point')) :-
    looking_verb(Verb).
verb_option(Verb, option(target, '', value, 'X,Y,Z',
    'with --eye: towards this point, instead of the middle of the model')) :-
    looking_verb(Verb).
verb_option(Verb, option(up, '', one_of([x, y, z]), 'AXIS',
    'which axis of the model points up (z, as is usual; y in most .obj \c
     files): the model is turned first, and all views, directions and \c
     sections are of the turned one, whose z points up')) :-
    looking_verb(Verb).
verb_option(Verb, option(projection, '', one_of([parallel, central]), 'KIND',
    'parallel or central')) :-
    looking_verb(Verb).
verb_option(draw, option(hidden, '', one_of([dashed, removed, shown]), 'HOW',
    'hidden lines dashed (as is usual), removed or shown')).
verb_option(Verb, option(lines, '', one_of([feature, all, penetration]),
    'WHICH', 'feature (as is usual), all, or penetration lines alone')) :-
    picture_verb(Verb).
verb_option(Verb, option(crease, '', number(0), 'DEGREES', Help)) :-
    usual_crease(Usual),
    format(atom(Help),
           'faces of a mesh that bend by no more than DEGREES (as is \c
            usual, ~w) are one smooth surface', [Usual]),
    picture_verb(Verb).
verb_option(Verb, option(segment, '', each, 'N',
    'only segment N; may be repeated')) :-
    looking_verb(Verb).
verb_option(draw, option(explode, '', number(0), 'F',
    'the cells of what is glued apart, moved by F times their way from the \c
     middle')).
verb_option(draw, option(cutaway, '', value, 'PLANE',
    'cut open and hatched at x=5, y=5 or z=5; at x, y or z, through the \c
     middle; or at A,B,C,D, without what is where A*X + B*Y + C*Z + D > 0; \c
     seen from anywhere, in parallel projection')).
verb_option(draw, option(scale, '', value, 'N:M',
    'true scale, such as 1:2 or 5:1; or fit, as large as there is room')).
verb_option(draw, option(unit, '', one_of([mm, cm, m, inch]), 'UNIT',
    'what one is in the model, for the scale; default mm')).
verb_option(draw, option(sheet, '', value, 'PAPER',
    'a framed sheet, A4 to A0, also A3-portrait or A4-landscape; default of \c
     the options below: A3')).
verb_option(draw, option(views, '', value, 'VIEWS',
    'the views on it, such as front,top,right,isometric (those if nothing \c
     else is said)')).
verb_option(draw, option(angle, '', one_of([first, third]), 'ANGLE',
    'first-angle or third-angle projection (third, as is usual)')).
verb_option(draw, option(section, '', each, 'PLANE',
    'also cut open and hatched at x=5, y=5 or z=5; at x, y or z, through the \c
     middle; or at A,B,C,D, seen from where A*X + B*Y + C*Z + D > 0; may be \c
     repeated')).
verb_option(draw, option('title-block', '', value, 'FILE',
    'facts for the title block, such as title_block(name, "Bracket").')).
verb_option(draw, option(language, '', one_of([en, ko]), 'LANGUAGE',
    'language of the title block; default that of --lang, else en')).
verb_option(draw, option('no-frame', '', flag, '',
    'a sheet without frame and title block')).
verb_option(draw, option(shade, '', value, 'SHADE',
    'shading under the lines, as of render: lambert, gooch, cel=N, zebra=N, \c
     xray or \c
     flat; or hatch, pen strokes where it is dark, in any format; on a sheet \c
     in pictorial views')).
verb_option(draw, option(size, '', value, 'WxH',
    'size of the sheet in mm')).

verb_option(draw, option(style, '', value, 'FILE',
    'how lines look: a file of facts (docs/drawings.md)')).
verb_option(draw, option(dashes, '', one_of([auto, geometry, type]), 'HOW',
    'dashes as suits the format (auto), as lines of their own (geometry, for \c
     cutters), or as line types of plotters (type)')).
verb_option(draw, option(png, '', one_of([smooth, dots]), 'HOW',
    'a .png with smooth lines, as is usual, or in dots, as on the screens of \c
     1988; --size is then in dots')).
verb_option(draw, option(dpi, '', number(1,1000000), 'N',
    'dots to the inch of a smooth .png, and of --shade in other files')).

verb_option(draw, option(points, '', value, 'N',
    'number N points of each penetration line, the same in all views; all: \c
     every corner of it')).
verb_option(draw, option('centre-lines', '', flag, '',
    'the axes of what is round, in a picture too; a sheet has them in any \c
     case')).
verb_option(draw, option('min-line', '', number(0), 'MM',
    'lines shorter than MM on the sheet that no other line touches at its \c
     ends are left out: specks of a scan')).
verb_option(draw, option(tolerance, '', number(0), 'T',
    'what is nearer than T (model units) touches; 0: nothing else does')).

verb_option(Verb, option(output, o, each, 'FILE',
    'where to (.pl .stl .off .obj .ply); may be repeated; without it: a line \c
     of counts and measures')) :-
    solid_verb(Verb).
verb_option(Verb, option(format, '', one_of([pl, stl, off, obj, ply]),
    'FORMAT', 'the format for -o -')) :-
    solid_verb(Verb).
verb_option(Verb, option(tolerance, '', number(0), 'T',
    'what is nearer than T (model units) touches; 0: nothing else does')) :-
    solid_verb(Verb).
verb_option(Verb, option(repair, '', flag, '',
    'mend operands first: weld vertices, drop faces that are there twice or \c
     have no sides, turn shells that are inside out')) :-
    solid_verb(Verb).
verb_option(split, option(plane, '', value, 'A,B,C,D',
    'the plane A*X + B*Y + C*Z + D = 0')).
verb_option(split, option(by, '', value, 'MODEL',
    'a solid, or an open surface that goes all the way through')).
verb_option(split, option(side, '', value, 'SIDE',
    'of a plane below (A*X + B*Y + C*Z + D < 0) or above, of a surface below \c
     (behind it) or above, of a solid inside or outside; without it both, \c
     -o x.stl as x-below.stl and x-above.stl, likewise .off and .ply')).
verb_option(Verb, option(json, '', flag, '',
    'counts and measures as JSON')) :-
    solid_verb(Verb).

verb_option(unfold, Option) :-
    unfold_option(Option).
verb_option(render, Option) :-
    render_option(Option).

verb_option(query, option(format, '', one_of([table, csv, json, prolog]),
    'FORMAT', 'table (as is usual), csv, json or prolog')).
verb_option(query, option(json, '', flag, '', 'the same as --format json')).
verb_option(query, option(limit, '', number(1), 'N', 'the first N answers')).

verb_option(batch, option(output, o, each, 'FOLDER',
    'where results go: FOLDER/NAME.svg is a link into FOLDER/store; with \c
     --merge a file (.json, .xml of JUnit, .html), may be repeated')).
verb_option(batch, option(jobs, j, whole(1,1024), 'N',
    'how many at once, each in a process; usually one for each processor')).
verb_option(batch, option(shard, '', value, 'I/N',
    'only part I of N of the jobs; slurm: the part of this task of an array')).
verb_option(batch, option(resume, '', flag, '',
    'what failed before is not tried again (what was done never is)')).
verb_option(batch, option('keep-going', '', flag, '',
    'go on after a job that failed')).
verb_option(batch, option(only, '', each, 'NAME',
    'only the job NAME; may be repeated')).
verb_option(batch, option(list, '', flag, '',
    'print the names of the jobs, and do none')).
verb_option(batch, option(report, '', value, 'FILE',
    'a line of JSON for each job goes there, not to standard output')).
verb_option(batch, option(copy, '', flag, '',
    'results are copies, not links')).
verb_option(batch, option(merge, '', flag, '',
    'reports become one: JSON, JUnit, or pages of pictures')).
verb_option(batch, option(sheets, '', flag, '',
    'MANIFEST is a file of problems: the same as the verb problems, with its \c
     options')).
verb_option(batch, Option) :-
    sheets_option(Option).

verb_option(explain, option(tolerance, '', number(0), 'T',
    'what is nearer than T (model units) touches; 0: nothing else does')).
verb_option(explain, Option) :-
    wish_option(Option).
verb_option(explain, Option) :-
    shown_option(Option).
verb_option(explain, option(json, '', flag, '', 'the reasons as JSON')).

verb_option(problems, option(output, o, value, 'FOLDER',
    'where to; it is made if it is not there')).
verb_option(problems, Option) :-
    sheets_option(Option).

verb_option(serve, option(port, '', whole(1, 65535), 'N',
    'where browsers find it; default 1989, or one that is free')).
verb_option(serve, option(host, '', value, 'ADDRESS',
    'the address to listen at; default 127.0.0.1, this machine alone; another \c
     one needs --class')).
verb_option(serve, option(class, '', flag, '',
    'pupils join with a code, which is printed too; each has the model, and \c
     a session, for himself')).
verb_option(serve, option(problems, '', value, 'FILE',
    'the problems of a class (docs/problems.md), which pupils answer in the \c
     page; as --class')).
verb_option(serve, option(behind, '', value, 'URL',
    'where a proxy shows the page, like https://h.example/sanggwan/')).
verb_option(serve, option(socket, '', value, 'PATH',
    'listen at a Unix socket, for the proxy of --behind, not at a port')).
verb_option(serve, option(embed, '', value, 'ORIGIN',
    'whose pages may show this one in a frame, like https://h.example')).
verb_option(serve, option(open, '', flag, '',
    'open the page in the browser of this desktop (as is usual)')).
verb_option(serve, option(stdio, '', flag, '',
    'no page: frames on standard input and output (docs/protocol.md)')).

%   How problem sheets are made.

sheets_option(option(format, '',
    one_of([svg, pdf, eps, ps, png, dxf, hpgl]), 'FORMAT',
    'the format of the sheets; default svg')).
sheets_option(option(angle, '', one_of([first, third]), 'ANGLE',
    'first-angle or third-angle projection (third, as is usual)')).
sheets_option(option(language, '', one_of([en, ko]), 'LANGUAGE',
    'language of the questions; default en')).

%   What may be done with each of many files.

line_of_each(convert).
line_of_each(draw).

each_verb(check).
each_verb(convert).
each_verb(draw).
each_verb(unfold).

%   What makes a picture: explain hidden(S, E) does as well.

picture_verb(draw).
picture_verb(explain).

looking_verb(render).
looking_verb(Verb) :-
    picture_verb(Verb).

solid_verb(union).
solid_verb(intersection).
solid_verb(difference).
solid_verb(split).
solid_verb(eval).

%!  common_option(?Spec) is nondet.
%
%   The options of every verb, in the order of the usage text.

common_option(option(lod, '', value, 'LOD',
    'of CityJSON: the level of detail, else the highest of each object')).
common_option(option(close, '', flag, '',
    'of CityJSON: solids that are open where they are flat are closed')).
common_option(option(from, '',
    one_of([pl, csg, stl, off, obj, ply, json]), 'FORMAT',
    'what - (standard input) is; default pl')).
common_option(option(rules, '', each, 'FILE',
    'rules that replace decisions; may be repeated')).
common_option(option(set, '', each, 'NAME=VALUE',
    'the value of a parameter, param(NAME, Default) of a model, a number or a \c
     formula of numbers; may be repeated')).
common_option(option(limits, '', value, 'NAME=N,...',
    'how much a text may ask for: depth, blocks, digits, name, fact, file, \c
     text, facets, nodes')).
common_option(option(strict, '', flag, '',
    'after a warning nothing is written, and the exit code is 1; 4 if it \c
     would tell of a move')).
common_option(option(quiet, q, flag, '', 'no notices, no progress')).
common_option(option(timings, '', flag, '',
    'the seconds of each stage, as JSON on standard error')).
common_option(option(stats, '', flag, '',
    'rows, bytes and index use, as JSON on standard error')).
common_option(option(lang, '', one_of([en, ko]), 'LANGUAGE',
    'language of the messages')).
common_option(option(help, h, flag, '', 'this text')).

%!  example(?Verb, -Command) is nondet.
%
%   A command line that shows what Verb is for.

example(check, 'sanggwan check facts/cube.pl').
example(check, 'sanggwan check --json part.stl').
example(cells, 'sanggwan cells facts/two_rooms.pl --neighbours').
example(glue, 'sanggwan glue facts/cube.pl facts/pipe_tee.pl -o glued.pl').
example(unglue, 'sanggwan unglue glued.pl -o parts.pl').
example(unglue, 'sanggwan unglue glued.pl --region 1 -o parts.pl').
example(convert, 'sanggwan convert part.stl -o part.pl -o part.off').
example(convert, 'sanggwan convert --from off --format pl -o - - < part.off').
example(penetrate, 'sanggwan penetrate facts/figures/fig13.pl -o lines.csv').
example(penetrate, 'sanggwan penetrate cylinder.stl cone.stl -o lines.svg').
example(penetrate, 'sanggwan penetrate facts/two_cubes.pl --format txt').
example(penetrate, 'sanggwan penetrate facts/two_cubes.pl --format csv \c
--exact').
example(draw, 'sanggwan draw facts/figures/fig13.pl -o fig13.svg').
example(draw, 'sanggwan draw facts/figures/fig12.pl --segment 1 \c
--view 300,60 -o cone.svg').
example(draw, 'sanggwan draw part.stl --view iso --hidden removed \c
--png dots --size 640x400 -o part.png').
example(draw, 'sanggwan draw facts/pipe_tee.pl --sheet A3 --unit cm \c
--section y -o tee.pdf').
example(draw, 'sanggwan draw facts/pipe_tee.pl --cutaway y \c
--hidden removed -o tee.svg').
example(draw, 'sanggwan draw part.stl --sheet A4 \c
--views front,top,isometric --angle first --scale 1:2 -o part.svg').
example(render, Command) :-
    render_example(Command).
example(union, 'sanggwan union a.stl b.stl c.stl -o all.stl').
example(union, 'sanggwan union facts/cube.pl facts/pipe_tee.pl').
example(intersection, 'sanggwan intersection a.off b.off -o common.obj').
example(difference, 'sanggwan difference block.stl drill.stl -o part.stl').
example(split, 'sanggwan split part.stl --plane 0,0,1,-2.5 -o halves.obj').
example(split, 'sanggwan split part.stl --by tool.stl --side inside \c
-o core.stl').
example(eval, 'sanggwan eval facts/pipe_tee.pl -o pipe_tee.stl').
example(eval, 'sanggwan eval bracket.csg -o bracket.stl').
example(unfold, Command) :-
    unfold_example(Command).
example(batch, 'sanggwan batch facts/batch.pl -o out -j 4').
example(batch, 'sanggwan batch big.pl -o out --shard 2/8 --keep-going \c
--report out/2.jsonl').
example(batch, 'sanggwan batch --merge out/*.jsonl -o out/index.html').
example(query, 'sanggwan query facts/cube.pl \'v(1, V, X, Y, Z)\'').
example(query, 'sanggwan query facts/figures/fig13.pl --format csv \c
\'penetrate, line(L, 1, P1, _, _, 2, P2, _, _)\'').
example(explain, 'sanggwan explain facts/two_cubes.pl \'line(1)\'').
example(explain, 'sanggwan explain facts/two_cubes.pl \'vertex(1, 9)\'').
example(explain, 'sanggwan explain facts/two_cubes.pl \c
\'pair(1-1, 2-2)\'').
example(explain, 'sanggwan explain facts/patterns/fig09.pl \'seam(_)\' \c
--cut 1 --root top').
example(explain, 'sanggwan explain facts/two_cubes.pl \'hidden(1, 7)\' \c
--view iso').
example(explain, 'sanggwan explain facts/pipe_tee.pl \'pixel(320, 200)\' \c
--size 640x400').
example(explain, 'sanggwan explain facts/pipe_tee.pl \'why_not(seen(3))\'').
example(problems, 'sanggwan problems facts/problems/collection.pl -o sheets').
example(problems, 'sanggwan problems facts/problems/collection.pl \c
--language ko --angle first --format pdf -o sheets').
example(serve, 'sanggwan serve facts/pipe_tee.pl').
example(serve, 'sanggwan serve --problems facts/problems/collection.pl').
example(serve, 'sanggwan serve --stdio < requests > replies').
example(repl, 'sanggwan repl facts/figures/fig13.pl').

%!  job_options(+Verb, -Specs) is det.
%
%   Specs are those of verb_options/2 that a job of a batch may have. It is one
%   of many itself, so they are without `each` and what belongs to it.

job_options(Verb, Specs) :-
    verb_options(Verb, Specs0),
    exclude(option_of_each(Verb), Specs0, Specs).

option_of_each(_, option(each, _, _, _, _)).
option_of_each(Verb, option(json, _, _, _, _)) :-
    line_of_each(Verb).

%!  verb_options(+Verb, -Specs) is det.
%
%   The options of Verb, as in arguments.pl, the common ones last.

verb_options(Verb, Specs) :-
    findall(Spec, verb_option(Verb, Spec), Own),
    findall(Spec, ( common_option(Spec), \+ not_of(Verb, Spec) ), Common),
    append(Own, Common, Specs).

%   not_of(Verb, Spec): a session is no work on a model; its requests say what
%   is wanted.

not_of(serve, option(Name, _, _, _, _)) :-
    \+ memberchk(Name, [lang,help]).
