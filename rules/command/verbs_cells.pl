:- encoding(utf8).
:- module(sg_verbs_cells,
          [ cells_run/3,                % +Files, +Options, -Status
            print_cells/3,              % +Language, +Options, +Report
            print_totals/3              % +Language, +Word, +Counts
          ]).
:- use_module('../csg/csg', [node/4, root_segment/1]).
:- use_module('../csg/csg_roots', [roots_alone/0]).
:- use_module('../gluing/exploded', [cells_exploded/1]).
:- use_module('../gluing/regions', [regions_made/2, law_fault/3]).
:- use_module('../gluing/unglue', [meetings_unmeant/2]).
:- use_module('../json_layout', [json_laid_out/3]).
:- use_module('../language', [language/1]).
:- use_module('../model/cells_file', [cells_format/1, write_cells/2]).
:- use_module('../model/model', [load_model/2, save_model/1, save_model/2]).
:- use_module('../plain', [plain_json/2, plain_text/2]).
:- use_module('../solid/glue', [glue_report/2]).
:- use_module('../space_limit', [with_stack_for/3]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [p/3, segment/3, facts_snapshot/1, facts_transaction/1]).
:- use_module(cells_table, [write_cells_table/3]).
:- use_module(solid_verbs, [empty_roots_warned/0]).
:- use_module(verb_output,
              [ some_files/2, outputs/3, no_model_replaced/2, output_written/2,
                reported/2, summary_sent_told/2
              ]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [member/2, sum_list/2]).
:- use_module(library(option), [option/2]).
/** <module> The verb cells: the regions of space between faces.

Each segment is a soup of its own: its faces, turned any way and with any number
at an edge, divide space. Of a glue the regions are known. The report is a list
of dicts, one for each segment: segment, name, counts, regions and neighbours as
regions_report/2 has them, and faults, a dict of counts.
*/

%!  cells_run(+Files, +Options, -Status) is det.
%
%   As verb_run/4: 1 if a segment has a fault.

cells_run(Files, Options, Status) :-
    some_files(Files, 'MODEL'),
    outputs(Options, [pl,csv,dot,poly,geo,obj,off,stl,json], Outputs),
    no_model_replaced(Files, Outputs),
    load_model(Files, Options),
    empty_roots_warned,
    with_report_stack(cells_reported(Outputs, Options, Status)).

:- meta_predicate with_report_stack(0).

%   with_report_stack(Goal): as much of the stacks as a report of all polygons
%   takes, also as JSON.

with_report_stack(Goal) :-
    aggregate_all(count, p(_, _, _), Polygons),
    polygon_octets(Octets),
    with_stack_for(Polygons, Octets, Goal).

polygon_octets(8000).

cells_reported(Outputs, Options, Status) :-
    findall(S-Report,
            ( root_segment(S), node(S, glue, _, _), glue_report(S, Report) ),
            Glues),
    roots_alone,
    findall(S-Name, segment(S, _, Name), Segments0),
    sort(Segments0, Segments),
    stage(regions, facts_transaction(
                       maplist(sg_verbs_cells:segment_report(Glues),
                               Segments, Reports))),
    apart_warned(Glues),
    reported(Outputs, sg_verbs_cells:with_report_stack(
                                         printed(Options, Reports))),
    summary_sent_told(Outputs, [pl,dot,poly,geo,obj,off,stl]),
    forall(member(Output, Outputs),
           output_written(sg_verbs_cells:written(Output, Reports, Options),
                          Output)),
    (   member(Report, Reports),
        Report.faults \= _{}
    ->  Status = 1
    ;   Status = 0
    ).

written(output(_, Format), Reports, Options, File) :-
    (   Format == pl
    ->  save_model(File)
    ;   cells_format(Format)
    ->  stage(write, write_cells(File, Format))
    ;   Format == stl
    ->  facts_snapshot(( cells_exploded(0),
                         save_model(File, [format(stl)]) ))
    ;   write_cells_table(File, Reports, [format(Format)|Options])
    ).

segment_report(Glues, S-Term, Report) :-
    (   memberchk(S-Regions, Glues)
    ->  true
    ;   regions_made(S, Regions)
    ),
    format(string(Name), '~w', [Term]),
    findall(Fault-N, law_fault(Regions, Fault, N), Pairs),
    dict_pairs(Faults, _, Pairs),
    Report = Regions.put(_{segment:S, name:Name, faults:Faults}).

%   apart_warned: where polygons meet and have no edge in common, regions run
%   together. Of Glues it is known where.

apart_warned(Glues) :-
    meetings_unmeant(1, Segments),
    forall(( member(self(S, Counts, [meeting(_, P1, P2, _, _, _)]), Segments),
             \+ memberchk(S-_, Glues),
             findall(N, member(_-N, Counts), Ns),
             sum_list(Ns, Sum) ),
           print_message(warning, sanggwan(cells_apart(S, Sum, P1, P2)))).

printed(Options, Reports) :-
    (   option(json(true), Options)
    ->  plain_json(current_output,
                   json_laid_out(current_output, Reports, 78)),
        nl
    ;   language(Language),
        forall(member(Report, Reports),
               print_cells(Language, Options, Report))
    ).


                /*******************************
                *             TEXT             *
                *******************************/

%!  print_totals(+Language, +Word, +Counts) is det.
%
%   A line: Word, and Counts as print_cells/3 has them.

print_totals(Language, Word, Counts) :-
    words(Language, Word, Text),
    counts_text(Language, Counts,
                [vertices,edges,faces,loops,parts,regions,shells,genus], All),
    format("~w: ~w~n", [Text, All]).

%!  print_cells(+Language, +Options, +Report) is det.
%
%   The report of one segment; with neighbours(true) the pairs of regions too.

print_cells(Language, Options, Report) :-
    plain_text(Report.name, Name),
    words(Language, segment, Segment),
    format("~w ~d: ~w~n", [Segment, Report.segment, Name]),
    Counts = Report.counts,
    print_counts(Language, Counts,
                 [vertices,edges,faces,loops,parts,regions,shells,genus]),
    print_counts(Language, Counts, [dropped]),
    forall(member(Region, Report.regions), print_region(Language, Region)),
    (   option(neighbours(true), Options)
    ->  forall(member(Pair, Report.neighbours),
               print_neighbours(Language, Pair))
    ;   true
    ),
    words(Language, fault, Fault),
    dict_pairs(Report.faults, _, Faults),
    forall(member(Which-N, Faults),
           format("  ~w ~w: ~D~n", [Fault, Which, N])).

%   print_counts(Language, Counts, Keys): of one key only if it is not 0.

print_counts(Language, Counts, Keys) :-
    (   Keys = [Key],
        Counts.Key =:= 0
    ->  true
    ;   counts_text(Language, Counts, Keys, Text),
        format("  ~w~n", [Text])
    ).

counts_text(Language, Counts, Keys, Text) :-
    findall(Part,
            ( member(Key, Keys), count_words(Language, Key, Counts.Key, Part) ),
            Parts),
    atomic_list_concat(Parts, ', ', Text).

print_region(Language, Region) :-
    findall(Key,
            ( member(Key, [faces,shells,genus,wires,vertices]),
              once(( Key == faces ; Region.Key =\= 0 )) ),
            Keys),
    counts_text(Language, Region, Keys, Text),
    words(Language, region, Word),
    words(Language, Region.role, Role),
    format("  ~w ~d: ~w", [Word, Region.region, Role]),
    print_inside(Language, Region.get(inside, [])),
    format(", ~w", [Text]),
    (   Region.volume == null
    ->  nl
    ;   words(Language, area, Area),
        words(Language, volume, Volume),
        format(", ~w ~6g, ~w ~6g~n",
               [Area, Region.area, Volume, Region.volume])
    ).

print_inside(_, []) :-
    !.
print_inside(Language, Operands) :-
    atomic_list_concat(Operands, ', ', List),
    (   Language == ko
    ->  format("(~w 안)", [List])
    ;   format(" in ~w", [List])
    ).

print_neighbours(Language, Pair) :-
    Pair.regions = [R1,R2],
    words(Language, region, Word),
    words(Language, area, Area),
    count_words(Language, faces, Pair.faces, Faces),
    format("  ~w ~d-~d: ~w, ~w ~6g~n", [Word, R1, R2, Faces, Area, Pair.area]).

count_words(en, genus, N, Text) :-
    !,
    format(string(Text), "genus ~D", [N]).
count_words(en, Key, N, Text) :-
    noun(Key, One, Many, _),
    (   N =:= 1
    ->  Word = One
    ;   Word = Many
    ),
    format(string(Text), "~D ~w", [N, Word]).
count_words(ko, Key, N, Text) :-
    noun(Key, _, _, Word),
    (   Key == genus
    ->  format(string(Text), "~w ~D", [Word, N])
    ;   format(string(Text), "~w ~D개", [Word, N])
    ).

noun(vertices, vertex, vertices, '꼭짓점').
noun(edges,    edge, edges, '모서리').
noun(faces,    face, faces, '면').
noun(loops,    loop, loops, '루프').
noun(parts,    part, parts, '부분').
noun(regions,  region, regions, '영역').
noun(shells,   shell, shells, '껍질').
noun(genus,    genus, genus, '종수').
noun(wires,    wire, wires, '선').
noun(dropped,  'polygon without area', 'polygons without area',
     '넓이 없는 다각형').

words(ko, Key, Text) :-
    word_ko(Key, Text),
    !.
words(en, fault, 'FAULT') :-
    !.
words(_, Key, Key).

word_ko(segment, '세그먼트').
word_ko(before,  '붙이기 전').
word_ko(region,  '영역').
word_ko(outside, '바깥').
word_ko(cell,    '세포').
word_ko(void,    '빈 곳').
word_ko(slit,    '틈').
word_ko(area,    '넓이').
word_ko(volume,  '부피').
word_ko(fault,   '잘못').
