:- encoding(utf8).
:- module(sg_report,
          [ print_report/2,             % +Format, +Report
            counted/4                   % +Language, +What, +N, -Text
          ]).
:- use_module('../json_layout', [json_laid_out/3]).
:- use_module('../language', [language/1]).
:- use_module('../plain', [plain_json/2, plain_term/2]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [member/2]).
/** <module> How the report of check.pl is printed.

As text in the language of the messages, or as JSON, which has none. The names
of faults are those of model_defect/1; in Korean words stand before them.
*/

%!  print_report(+Format, +Report) is det.
%
%   Print Report to current output as `text` or `json`.

print_report(json, Report) :-
    plain_json(current_output,
               json_laid_out(current_output, Report, 78)),
    nl.
print_report(text, Report) :-
    language(Language),
    forall(member(Parameter, Report.parameters),
           print_parameter(Language, Parameter)),
    forall(member(S, Report.segments), print_segment(Language, S)),
    (   Report.faults =:= 0
    ->  say(Language, no_faults, [])
    ;   counted(Language, fault, Report.faults, Faults),
        say(Language, faults, [Faults])
    ).

print_parameter(Language, Parameter) :-
    format(string(Name), '~q', [Parameter.name]),
    findall(Part, parameter_part(Language, Parameter, Part), Parts),
    atomic_list_concat(Parts, More),
    say(Language, parameter, [Name, Parameter.value, More]).

%   parameter_part(Language, Parameter, Part) is nondet: what more there is to
%   say of it.

parameter_part(Language, Parameter, Part) :-
    part_values(Parameter, Name, Values),
    \+ memberchk(null, Values),
    text(Language, Name, Format),
    format(atom(Part), Format, Values).
parameter_part(Language, Parameter, Part) :-
    Texts = Parameter.text,
    is_dict(Texts),
    (   Text = Texts.get(Language)
    ->  true
    ;   get_dict(_, Texts, Text)
    ->  true
    ),
    atom_concat(': ', Text, Part).

part_values(Parameter, formula, [Parameter.formula]).
part_values(Parameter, default, [Parameter.default]).
part_values(Parameter, range, [Parameter.minimum, Parameter.maximum]).
part_values(Parameter, minimum, [Parameter.minimum]) :-
    Parameter.maximum == null.
part_values(Parameter, maximum, [Parameter.maximum]) :-
    Parameter.minimum == null.
part_values(Parameter, step, [Parameter.step]).

print_segment(Language, S) :-
    word(Language, S.kind, Kind),
    shortened(S.name, Name),
    say(Language, segment, [S.segment, Kind, Name]),
    counted(Language, vertex, S.vertices, Vs),
    counted(Language, edge, S.edges, Es),
    counted(Language, polygon, S.polygons, Ps),
    counted(Language, triangle, S.triangles, Ts),
    say(Language, counts, [Vs, Es, Ps, Ts]),
    [[X1,Y1,Z1], [X2,Y2,Z2]] = S.box,
    say(Language, box, [X1,Y1,Z1, X2,Y2,Z2]),
    (   S.polygons =:= 0
    ->  true
    ;   say(Language, area, [S.area])
    ),
    (   number(S.volume)
    ->  say(Language, volume, [S.volume])
    ;   true
    ),
    (   S.curve_edges =:= 0
    ->  true
    ;   say(Language, length, [S.length])
    ),
    forall(member(Shell, S.shells), print_shell(Language, Shell)),
    (   S.border_edges =:= 0
    ->  true
    ;   counted(Language, border_edge, S.border_edges, Borders),
        say(Language, borders, [Borders])
    ),
    print_defects(Language, fault, S.faults),
    print_defects(Language, remark, S.remarks),
    forall(member(Meeting, S.meetings), print_meeting(Language, Meeting)).

%   A primitive's name is its term, which may be a page long.

shortened(Name0, Name) :-
    Most = 64,
    (   sub_string(Name0, 0, Most, Rest, Start),
        Rest > 3
    ->  string_concat(Start, "...", Name)
    ;   Name = Name0
    ).

print_shell(Language, Shell) :-
    (   Shell.closed == true
    ->  word(Language, closed, Word)
    ;   word(Language, open, Word)
    ),
    counted(Language, polygon, Shell.polygons, Ps),
    (   integer(Shell.euler)
    ->  text(Language, euler, Format1),
        format(string(Euler), Format1, [Shell.euler])
    ;   Euler = ""
    ),
    (   integer(Shell.genus)
    ->  text(Language, genus, Format2),
        format(string(Genus), Format2, [Shell.genus])
    ;   Genus = ""
    ),
    (   Shell.depth > 0
    ->  text(Language, depth, Format3),
        format(string(Depth), Format3, [Shell.depth])
    ;   Depth = ""
    ),
    say(Language, shell, [Ps, Word, Euler, Genus, Depth]).

print_defects(Language, Weight, Dict) :-
    dict_pairs(Dict, _, Pairs),
    word(Language, Weight, Word),
    forall(member(Name-N, Pairs),
           ( defect_text(Language, Name, Text),
             format("  ~w~t~8| ~w: ~D~n", [Word, Text, N]) )).

print_meeting(Language, Meeting) :-
    [P1,P2] = Meeting.polygons,
    [X,Y,Z] = Meeting.at,
    defect_text(Language, Meeting.kind, Text),
    say(Language, meeting, [Text, P1, P2, X, Y, Z]).

%   defect_text(Language, Name, Text): in Korean with the name that queries
%   have.

defect_text(Language, Name0, Text) :-
    atom_string(Name, Name0),
    (   Language == ko,
        defect_ko(Name, Word)
    ->  format(string(Text), "~w(~w)", [Word, Name])
    ;   Text = Name
    ).

defect_ko(open_edge,        '열린 모서리').
defect_ko(turned_edge,      '방향이 어긋난 모서리').
defect_ko(nonmanifold_edge, '셋 이상의 면이 만나는 모서리').
defect_ko(shared_half_edge, '두 면이 함께 쓰는 모서리').
defect_ko(open_polygon,     '닫히지 않은 다각형').
defect_ko(duplicate_face,   '두 번 있는 면').
defect_ko(inside_out,       '안팎이 뒤집힌 입체').
defect_ko(self_penetration, '자기 관통').
defect_ko(wrong_plane,      '맞지 않는 평면').
defect_ko(wrong_triangles,  '맞지 않는 삼각형').
defect_ko(crossed_face,     '자기 자신과 교차하는 면').
defect_ko(self_overlap,     '자기 겹침').
defect_ko(broken_law,       '어긋난 법칙').
defect_ko(unsure_part,      '자리를 알 수 없는 부분').
defect_ko(touching_edge,    '맞닿은 모서리').
defect_ko(nested_shell,     '안에 든 껍질').
defect_ko(turned_shell,     '뒤집힌 껍질').
defect_ko(pinched_vertex,   '면들이 한 점에서만 만나는 꼭짓점').
defect_ko(degenerate_face,  '넓이가 없는 면').
defect_ko(bent_face,        '평평하지 않은 면').
defect_ko(short_edge,       '짧은 모서리').
defect_ko(twin_vertices,    '같은 자리의 꼭짓점').
defect_ko(unused_vertex,    '쓰이지 않는 꼭짓점').
defect_ko(self_touching,    '자기 접촉').

say(Language, Line, Arguments) :-
    text(Language, Line, Format),
    maplist(plain_term, Arguments, Plain),
    format(Format, Plain),
    nl.

%!  counted(+Language, +What, +N, -Text) is det.
%
%   Text is a string such as "1 edge", "2 edges"; What is `vertex`,
%   `edge`, ...

counted(en, What, N, Text) :-
    noun(What, One, Many, _),
    (   N =:= 1
    ->  Word = One
    ;   Word = Many
    ),
    format(string(Text), "~D ~w", [N, Word]).
counted(ko, What, N, Text) :-
    noun(What, _, _, Ko),
    format(string(Text), "~w ~D개", [Ko, N]).

noun(vertex,      vertex,        vertices,       '꼭짓점').
noun(edge,        edge,          edges,          '모서리').
noun(polygon,     polygon,       polygons,       '다각형').
noun(triangle,    triangle,      triangles,      '삼각형').
noun(border_edge, 'border edge', 'border edges', '경계 모서리').
noun(shell,       shell,         shells,         '껍질').
noun(fault,       fault,         faults,         '잘못').

word(Language, Word, Text) :-
    (   translated(Word, English, Korean)
    ->  (   Language == ko
        ->  Text = Korean
        ;   Text = English
        )
    ;   Text = Word
    ).

translated(solid,   solid,   '입체').
translated(surface, surface, '곡면').
translated(curve,   curve,   '곡선').
translated(closed,  closed,  '닫힘').
translated(open,    open,    '열림').
translated(fault,   'FAULT', '잘못').
translated(remark,  remark,  '참고').

text(en, parameter, "parameter ~w = ~w~w").
text(ko, parameter, "매개변수 ~w = ~w~w").
text(en, formula,   ", from ~w").
text(ko, formula,   ", 식 ~w").
text(en, default,   ", which was set (default ~w)").
text(ko, default,   ", 주어진 값 (기본값 ~w)").
text(en, range,     ", ~w to ~w").
text(ko, range,     ", ~w부터 ~w까지").
text(en, minimum,   ", ~w at least").
text(ko, minimum,   ", ~w 이상").
text(en, maximum,   ", ~w at most").
text(ko, maximum,   ", ~w 이하").
text(en, step,      " in steps of ~w").
text(ko, step,      ", 간격 ~w").
text(en, no_faults, "no faults").
text(ko, no_faults, "잘못이 없습니다").
text(_,  faults,    "~w").
text(en, segment,   "segment ~d: ~w ~w").
text(ko, segment,   "세그먼트 ~d: ~w ~w").
text(_,  counts,    "  ~w, ~w, ~w, ~w").
text(en, box,       "  box ~15|~w ~w ~w to ~w ~w ~w").
text(ko, box,       "  범위 ~15|~w ~w ~w에서 ~w ~w ~w까지").
text(en, area,      "  area ~15|~6g").
text(ko, area,      "  넓이 ~15|~6g").
text(en, volume,    "  volume ~15|~6g").
text(ko, volume,    "  부피 ~15|~6g").
text(en, length,    "  length ~15|~6g").
text(ko, length,    "  길이 ~15|~6g").
text(en, shell,     "  shell of ~w: ~w~w~w~w").
text(ko, shell,     "  껍질(~w): ~w~w~w~w").
text(en, depth,     ", inside ~d other").
text(ko, depth,     ", 다른 껍질 ~d개 안").
text(en, euler,     ", Euler characteristic ~d").
text(ko, euler,     ", 오일러 지표 ~d").
text(en, genus,     ", genus ~d").
text(ko, genus,     ", 종수 ~d").
text(_,  borders,   "  ~w").
text(en, meeting,   "  ~w: polygons ~d and ~d at ~6g ~6g ~6g").
text(ko, meeting,   "  ~w: 다각형 ~d, ~d, 위치 ~6g ~6g ~6g").
