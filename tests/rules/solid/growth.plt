:- module(test_growth, []).
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(library(time)).
:- use_module(rules(model/mesh), [read_mesh/2]).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(store)).
:- use_module(tests('rules/boolean_case')).
:- use_module(tests('rules/sample')).
:- use_module(tests('rules/solid/grown')).

/* Solids that grow: what it takes to unite one grows with its result, or, where
   each of N shells meets all others, not faster than their pairs. The sizes are
   such that a time which grows one power of N faster than that would be hours;
   the limit is what a busy machine may need. */

limit(100).                             % seconds

%   size(Family, Few, All)

size(wedges, 80, 200).
size(identical, 60, 120).
size(apexes, 200, 500).
size(needles, 150, 400).
size(stack, 150, 400).
size(apart, 700, 2000).
size(row, 1000, 3000).
size(comb, 120, 300).
size(base, 300, 1000).
size(rings, 40, 150).

grown_size(Family, N) :-
    size(Family, Few, All),
    few(Few, All, N).

%   fault(Family, N, Fault): what the checker says of the union of all shells,
%   read from one file, is not right.

fault(Family, N, Fault) :-
    tmp_file_stream(File, Stream, [extension(off)]),
    close(Stream),
    call_cleanup(
        ( grown_file(Family, N, File, Volume),
          limit(Seconds),
          new_world(World),
          in_world(World,
                   ( read_mesh(File, [S]),
                     complete_segments,
                     call_with_time_limit(Seconds, result(union([S]), U)),
                     measured([U], [Measures]) ))
        ),
        delete_file(File)),
    measure_fault(Measures, Volume, Fault).

measure_fault(Measures, Volume, volume(Got, Volume)) :-
    Got = Measures.volume,
    abs(Got-Volume) > 1.0e-9*Volume.
measure_fault(Measures, _, not(Key)) :-
    member(Key, [closed,good]),
    get_dict(Key, Measures, no).

:- begin_tests(growth).

test(united, [forall(grown_size(Family, N)), all(Fault == [])]) :-
    fault(Family, N, Fault).

:- end_tests(growth).
