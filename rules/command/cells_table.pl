:- module(sg_cells_table,
          [ write_cells_table/3         % +File, +Reports, +Options
          ]).
:- use_module('../output', [writing/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> Regions as a table, and who is beside whom as a graph.

`.csv` has a row for each region,

    segment region role inside faces shells genus wires vertices area volume

or, with neighbours(true), for each two with faces between them,

    segment region1 region2 faces area

Operands in `inside` stand with blanks between them; the outside has no volume.
`.dot` is a graph for Graphviz: a node for each region, an edge for each two
neighbours, which has the area that they share.
*/

%!  write_cells_table(+File, +Reports:list, +Options) is det.
%
%   Write Reports, dicts as of verbs_cells.pl, to File. Options: format(F),
%   `csv` or `dot`, by default the ending of File; neighbours(true).

write_cells_table(File, Reports, Options) :-
    file_name_extension(_, Ending, File),
    option(format(Format), Options, Ending),
    writing(File, text, sg_cells_table:written(Format, Reports, Options)).

written(csv, Reports, Options, Out) :-
    (   option(neighbours(true), Options)
    ->  write_row(Out, [segment, region1, region2, faces, area]),
        forall(( member(Report, Reports),
                 member(Pair, Report.neighbours) ),
               ( Pair.regions = [R1,R2],
                 write_row(Out, [ Report.segment, R1, R2, Pair.faces,
                                  Pair.area ]) ))
    ;   Keys = [faces,shells,genus,wires,vertices,area],
        append([segment,region,role,inside|Keys], [volume], Head),
        write_row(Out, Head),
        forall(( member(Report, Reports),
                 member(Region, Report.regions) ),
               region_row(Out, Report.segment, Keys, Region))
    ).
written(dot, Reports, _, Out) :-
    format(Out, "graph regions {~n  node [shape=box];~n", []),
    forall(( member(Report, Reports),
             member(Region, Report.regions) ),
           region_node(Out, Report.segment, Region)),
    forall(( member(Report, Reports),
             member(Pair, Report.neighbours) ),
           ( Pair.regions = [R1,R2],
             S = Report.segment,
             format(Out, "  \"~d.~d\" -- \"~d.~d\" [label=\"~6g\"];~n",
                    [S, R1, S, R2, Pair.area]) )),
    format(Out, "}~n", []).

region_row(Out, S, Keys, Region) :-
    atomic_list_concat(Region.get(inside, []), ' ', Inside),
    findall(Value, ( member(Key, Keys), Value = Region.Key ), Values),
    volume_text(Region.volume, Volume),
    append([S,Region.region,Region.role,Inside|Values], [Volume], Row),
    write_row(Out, Row).

volume_text(Volume0, Volume) :-
    (   Volume0 == null
    ->  Volume = ''
    ;   Volume = Volume0
    ).

write_row(Out, Values) :-
    atomic_list_concat(Values, ',', Line),
    format(Out, "~w~n", [Line]).

%   region_node(Out, S, Region): what it is inside, or its role; its volume.

region_node(Out, S, Region) :-
    R = Region.region,
    (   Region.get(inside, []) = [_|_]
    ->  atomic_list_concat(Region.inside, ', ', Inside),
        format(atom(What), "~w in ~w", [Region.role, Inside])
    ;   What = Region.role
    ),
    (   Region.volume == null
    ->  format(Out, "  \"~d.~d\" [label=\"~d: ~w\"];~n", [S, R, R, What])
    ;   format(Out, "  \"~d.~d\" [label=\"~d: ~w\\n~6g\"];~n",
               [S, R, R, What, Region.volume])
    ).
