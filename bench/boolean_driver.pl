/* The driver behind bench/boolean_driver. */
:- use_module('../rules/solid/boolean').
:- use_module('../rules/model/mesh').
:- use_module('../rules/stage').
:- use_module('../rules/store').
:- use_module('../rules/polygon/triangulation').
:- use_module(rows_off).
:- use_module(tolerance).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(http/json)).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, [Mode, A, B, Out, RepsText]),
    mode_expression(Mode, Expression),
    atom_number(RepsText, Reps),
    new_world(World),
    in_world(World, driven(Expression, A, B, Out, Reps)).

mode_expression(union, union([1,2])).
mode_expression(inter, intersection([1,2])).
mode_expression(diff, difference([1,2])).

driven(Expression, A, B, Out, Reps) :-
    read_mesh(A, _),
    read_mesh(B, _),
    complete_segments,
    garbage_collect,
    tolerance_options(Options),
    length(Runs, Reps),
    maplist(run(Expression, Options), Runs),
    maplist(run_seconds, Runs, Seconds),
    Runs = [run(_, Stages, S)|_],
    aggregate_all(count, t(S, _, _, _, _, _), Triangles),
    (   Out == (-)
    ->  true
    ;   write_rows_off(S, Out)
    ),
    json_write_dict(current_output,
                    _{build:0.0, op:Seconds, nt:Triangles, segs:0, lines:0,
                      note:"", stages:Stages},
                    [width(0)]),
    nl.

run(Expression, Options, run(Seconds, Stages, S)) :-
    fresh_id(segment, 0, S),
    stages_reset,
    statistics(process_cputime, T0),
    boolean(Expression, S, Options),
    statistics(process_cputime, T),
    Seconds is T-T0,
    findall(Name-Part, stage_seconds(Name, Part), Pairs),
    dict_pairs(Stages, _, Pairs).

run_seconds(run(Seconds, _, _), Seconds).
