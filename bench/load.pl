/* Reading and checking a mesh: see bench/load. */
:- use_module('../rules/store').
:- use_module('../rules/kernel', [solid_take/2, solid_write/2]).
:- use_module('../rules/model/mesh').
:- use_module('../rules/polygon/triangulation').
:- use_module('../rules/command/check').
:- autoload(library(lists), [sum_list/2]).
:- autoload(library(readutil), [read_file_to_string/3]).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, [File]),
    new_world(World),
    in_world(World, measured(File)).

measured(File) :-
    seconds(read_mesh(File, _), Read),
    seconds(complete_segments, Complete),
    seconds(check_report(Report), Check),
    report_faults(Report, Faults),
    aggregate_all(count, p(_, _, _), Polygons),
    findall(B, ( member(R, [v,e,p,plane,t]), facts_statistics(R, S),
                 get_dict(bytes, S, B) ), Bytes),
    sum_list(Bytes, Sum),
    PerPolygon is Sum/Polygons,
    format("~D triangles: read ~3f s, complete ~3f s, check ~3f s \c
            (~d faults); ~D bytes in relations, ~1f a triangle~n",
           [Polygons, Read, Complete, Check, Faults, Sum, PerPolygon]),
    written,
    peak(Peak),
    format("  most memory: ~w~n", [Peak]).

%   written: what rows cost that a kernel has made.

written :-
    rows(Rows0),
    solid_take([1], Solid),
    seconds(facts_transaction(solid_write(Solid, 2)), Write),
    rows(Rows),
    Written is Rows-Rows0,
    PerRow is Write*1.0e9/Written,
    format("  written as ~D rows of a segment: ~3f s, ~0f ns a row~n",
           [Written, Write, PerRow]).

rows(Rows) :-
    findall(N, ( relation(R, _, _), facts_statistics(R, S),
                 get_dict(rows, S, N) ), Ns),
    sum_list(Ns, Rows).

seconds(Goal, Seconds) :-
    get_time(T0),
    once(Goal),
    get_time(T1),
    Seconds is T1-T0.

peak(Peak) :-
    exists_file('/proc/self/status'),
    !,
    read_file_to_string('/proc/self/status', Text, []),
    split_string(Text, "\n", "", Lines),
    member(Line, Lines),
    string_concat("VmHWM:", Peak0, Line),
    !,
    split_string(Peak0, "", " \t", [Peak]).
peak(unknown).
