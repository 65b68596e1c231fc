/* Trees and joins at scale: see bench/scale.

   grow: opening the cut set of two segments whose rows have just changed.
   kept: the same once more. join: all candidates, nothing cut. The medians of
   five.
*/
:- use_module('../rules/store').
:- use_module('../rules/kernel').
:- use_module('../rules/mesh').
:- use_module('../rules/model_file').
:- use_module('../rules/triangulation').
:- autoload(library(aggregate), [aggregate_all/3]).
:- autoload(library(apply), [foldl/4, maplist/2]).
:- autoload(library(lists), [last/2, member/2, nth0/3, sum_list/2]).
:- autoload(library(readutil), [read_file_to_string/3]).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, [What|Files]),
    call(What, Files).

/* - - - two spheres - - - */

pairs(Files) :-
    format("~w~t~14|~t~w~24|~t~w~34|~t~w~44|~t~w~56|~t~w~66|~n",
           ['triangles', 'grow, ms', 'kept, ms', 'join, ms', candidates,
            'bytes each']),
    pair_rows(Files, Rows),
    Rows = [N1-T1|_],
    last(Rows, N2-T2),
    (   N2 > N1
    ->  Exponent is log(T2/T1)/log(N2/N1),
        format("grow and join: time grows as n^~2f~n", [Exponent])
    ;   true
    ).

pair_rows([], []).
pair_rows([A,B|Files], [N-T|Rows]) :-
    new_world(World),
    in_world(World, pair_row(A, B, N-T)),
    garbage_collect_atoms,
    pair_rows(Files, Rows).

pair_row(A, B, N-T) :-
    maplist(read_mesh, [A,B], _),
    complete_segments,
    aggregate_all(count, t(_, _, _, _, _, _), N),
    findall(Trial, ( between(1, 5, _), trial(Trial) ), Trials),
    maplist(median(Trials), [1,2,3], [Grow,Kept,Join]),
    aggregate_all(count, trial_candidate, Candidates),
    tree_statistics(Statistics),
    Bytes is Statistics.bytes/Statistics.leaves,
    format("~D~t~14|~t~2f~24|~t~2f~34|~t~2f~44|~t~D~56|~t~1f~66|~n",
           [N, Grow, Kept, Join, Candidates, Bytes]),
    T is Grow+Join.

trial(trial(Grow, Kept, Join)) :-
    maplist(touch, [1,2]),
    milliseconds(cut_set_open([1-2], Set1), Grow),
    cut_set_close(Set1),
    milliseconds(cut_set_open([1-2], Set2), Kept),
    milliseconds(joined(Set2), Join),
    cut_set_close(Set2).

joined(Set) :-
    (   cut_candidate(Set, _, _)
    ->  true
    ;   true
    ).

trial_candidate :-
    setup_call_cleanup(cut_set_open([1-2], Set),
                       cut_candidate(Set, _, _),
                       cut_set_close(Set)).

%   The segment has changed, but nothing in it is different.

touch(S) :-
    v(S, V, X, Y, Z),
    !,
    retractall_facts(v(S, V, _, _, _)),
    assert_fact(v(S, V, X, Y, Z)).

median(Trials, K, Median) :-
    findall(Value, ( member(Trial, Trials), arg(K, Trial, Value) ), Values),
    sort(0, @=<, Values, Sorted),
    length(Sorted, N),
    Middle is N//2,
    nth0(Middle, Sorted, Median).

milliseconds(Goal, T) :-
    get_time(T0),
    call(Goal),
    !,
    get_time(T1),
    T is (T1-T0)*1000.

/* - - - a scene - - - */

%   Spheres in a grid, each overlapping its neighbours.

scene(Files) :-
    new_world(World),
    in_world(World, scene_(Files)).

scene_(Files) :-
    maplist(read_mesh, Files, _),
    complete_segments,
    aggregate_all(count, t(_, _, _, _, _, _), N),
    aggregate_all(count, segment(_, _, _), Segments),
    milliseconds(findall(S1-S2, near_segments(0, S1, S2), Pairs), Near),
    length(Pairs, Count),
    milliseconds(cut_set_open(Pairs, Set), Open),
    milliseconds(joined(Set), Join),
    milliseconds(cut_find(Set), Find),
    cut_set_close(Set),
    format("~n~D spheres, ~D triangles: ~D pairs near in ~2f ms, \c
            trees ~2f ms, join ~2f ms, cuts ~2f ms~n",
           [Segments, N, Count, Near, Open, Join, Find]).

/* - - - a large mesh and a box - - - */

big([File]) :-
    new_world(World),
    in_world(World, big_(File)).

big_(File) :-
    milliseconds(read_mesh(File, _), Read),
    add_primitive(at([translate(7, 1, 1)], box(size(5, 5, 5))), _),
    milliseconds(complete_segments, Complete),
    aggregate_all(count, t(1, _, _, _, _, _), N),
    peak(Loaded),
    findall(B, ( member(R, [v,e,p,plane,t]), facts_statistics(R, S),
                 get_dict(bytes, S, B1), get_dict(index_bytes, S, B2),
                 B is B1+B2 ), Bytes),
    sum_list(Bytes, Relations),
    milliseconds(cut_set_open([1-2], Set), Open),
    peak(Grown),
    milliseconds(cut_find(Set), Find),
    peak(Found),
    cut_set_close(Set),
    tree_statistics(Trees),
    milliseconds(cut_set_open([1-2], Set2), Open2),
    milliseconds(cut_find(Set2), Find2),
    cut_set_close(Set2),
    Each is Relations/N,
    EachTree is Trees.bytes/N,
    format("~D triangles and a box: read ~2f s, complete ~2f s~n",
           [N, Read/1000, Complete/1000]),
    format("  trees ~1f ms, cuts ~1f ms; again ~2f ms, ~1f ms~n",
           [Open, Find, Open2, Find2]),
    format("  bytes a triangle: relations and indexes ~1f, tree ~1f~n",
           [Each, EachTree]),
    format("  most memory, MB: loaded ~D, with trees ~D, with cuts ~D~n",
           [Loaded, Grown, Found]).

%   The most memory the process has had so far, in MB.

peak(MB) :-
    read_file_to_string('/proc/self/status', Text, []),
    split_string(Text, "\n", "", Lines),
    member(Line, Lines),
    string_concat("VmHWM:", Peak0, Line),
    !,
    split_string(Peak0, "", " \tkB", [Peak]),
    number_string(KB, Peak),
    MB is KB//1024.
