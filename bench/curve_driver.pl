/* The driver behind bench/curve_driver. */
:- use_module('../rules/model/mesh').
:- use_module('../rules/penetration/penetration').
:- use_module('../rules/stage').
:- use_module('../rules/store').
:- use_module('../rules/polygon/triangulation').
:- use_module(tolerance).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(http/json)).
:- use_module(library(lists)).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, [curve, A, B, _, RepsText]),
    atom_number(RepsText, Reps),
    new_world(World),
    in_world(World, curves(A, B, Reps)).

curves(A, B, Reps) :-
    read_mesh(A, _),
    read_mesh(B, _),
    complete_segments,
    garbage_collect,
    tolerance_options(Options),
    length(Runs, Reps),
    maplist(run(Options), Runs),
    maplist(run_seconds, Runs, Seconds),
    Runs = [First|_],
    First = run(_, Stages, Pieces, Lines),
    json_write_dict(current_output,
                    _{build:0.0, op:Seconds, nt:0, segs:Pieces, lines:Lines,
                      note:"", stages:Stages},
                    [width(0)]),
    nl.

run(Options, run(Seconds, Stages, Pieces, Lines)) :-
    stages_reset,
    statistics(process_cputime, T0),
    penetration_chains(all, Options, Chains),
    statistics(process_cputime, T),
    Seconds is T-T0,
    findall(Name-Part, stage_seconds(Name, Part), Pairs),
    dict_pairs(Stages, _, Pairs),
    length(Chains, Lines),
    aggregate_all(sum(N),
                  ( member(chain(_, _, _, _, Ps), Chains), length(Ps, N) ),
                  Pieces).

run_seconds(run(Seconds, _, _, _), Seconds).
