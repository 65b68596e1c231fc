/* Trees and joins at scale: see bench/scale.

   grow: opening the cut set of two segments whose rows have just changed.
   kept: the same once more. join: all candidates, nothing cut. The medians of
   five. cpu is the time of all threads together, which other work on the
   machine hardly changes.
*/
:- use_module('../rules/store').
:- use_module('../rules/kernel').
:- use_module('../rules/model/mesh').
:- use_module('../rules/primitive/primitive_rows').
:- use_module('../rules/polygon/triangulation').
:- autoload(library(aggregate), [aggregate_all/3]).
:- autoload(library(apply), [maplist/2, maplist/3]).
:- autoload(library(lists), [last/2, member/2, nth0/3]).
:- autoload(library(readutil), [read_file_to_string/3]).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, [What|Files]),
    call(What, Files).

/* - - - two spheres - - - */

pairs(Files) :-
    format("~w~t~12|~t~w~22|~t~w~30|~t~w~40|~t~w~50|~t~w~58|~t~w~70|~t~w~81|~n",
           ['triangles', 'grow, ms', cpu, 'kept, ms', 'join, ms', cpu,
            candidates, 'bytes each']),
    pair_rows(Files, Rows),
    Rows = [N1-T1|_],
    last(Rows, N2-T2),
    (   N2 > N1
    ->  Exponent is log(T2/T1)/log(N2/N1),
        format("cpu of grow and join together grows as n^ ~2f~n", [Exponent])
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
    maplist(median(Trials), [1,2,3,4,5], [Grow,GrowCPU,Kept,Join,JoinCPU]),
    aggregate_all(count, trial_candidate, Candidates),
    tree_statistics(Statistics),
    Bytes is Statistics.bytes/Statistics.leaves,
    format("~D~t~12|~t~2f~22|~t~2f~30|~t~2f~40|~t~2f~50|~t~2f~58|~t~D~70|\c
            ~t~1f~81|~n",
           [N, Grow, GrowCPU, Kept, Join, JoinCPU, Candidates, Bytes]),
    T is GrowCPU+JoinCPU.

trial(trial(Grow, GrowCPU, Kept, Join, JoinCPU)) :-
    maplist(touch, [1,2]),
    milliseconds(cut_set_open([1-2], Set1), Grow, GrowCPU),
    cut_set_close(Set1),
    milliseconds(cut_set_open([1-2], Set2), Kept, _),
    milliseconds(joined(Set2), Join, JoinCPU),
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
    facts_transaction(( retractall_facts(v(S, V, _, _, _)),
                        assert_fact(v(S, V, X, Y, Z))
                      )).

median(Trials, K, Median) :-
    findall(Value, ( member(Trial, Trials), arg(K, Trial, Value) ), Values),
    sort(0, @=<, Values, Sorted),
    length(Sorted, N),
    Middle is N//2,
    nth0(Middle, Sorted, Median).

milliseconds(Goal, Wall, CPU) :-
    get_time(T0),
    statistics(process_cputime, C0),
    call(Goal),
    !,
    get_time(T1),
    statistics(process_cputime, C1),
    Wall is (T1-T0)*1000,
    CPU is (C1-C0)*1000.

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
    milliseconds(findall(S1-S2, near_segments(0, S1, S2), Pairs), _, Near),
    length(Pairs, Count),
    milliseconds(cut_set_open(Pairs, Set), _, Open),
    milliseconds(joined(Set), _, Join),
    milliseconds(cut_find(Set), _, Find),
    cut_set_close(Set),
    format("~n~D spheres, ~D triangles: ~D of the pairs are near~n\c
            cpu, ms: near ~2f , trees ~2f , join ~2f , cuts ~2f~n",
           [Segments, N, Count, Near, Open, Join, Find]).

/* - - - a large mesh and a box - - - */

big([File]) :-
    new_world(World),
    in_world(World, big_(File)).

big_(File) :-
    milliseconds(read_mesh(File, _), _, Read),
    add_primitive(at([translate(7, 1, 1)], box(size(5, 5, 5))), _),
    milliseconds(complete_segments, _, Complete),
    aggregate_all(count, t(1, _, _, _, _, _), N),
    peak(Loaded),
    aggregate_all(sum(B), relation_bytes(B), Relations),
    milliseconds(cut_set_open([1-2], Set), _, Open),
    peak(Grown),
    milliseconds(cut_find(Set), _, Find),
    peak(Found),
    cut_set_close(Set),
    tree_statistics(Trees),
    milliseconds(cut_set_open([1-2], Set2), _, Open2),
    milliseconds(cut_find(Set2), _, Find2),
    cut_set_close(Set2),
    Each is Relations/N,
    EachTree is Trees.bytes/N,
    Total is Read+Complete,
    format("~D triangles and a box~n\c
            cpu, ms: load ~0f , trees ~1f , cuts ~1f ; again ~2f , ~1f~n",
           [N, Total, Open, Find, Open2, Find2]),
    format("bytes a triangle: relations and indexes ~1f , tree ~1f~n",
           [Each, EachTree]),
    format("most memory, MB: loaded ~D , with trees ~D , with cuts ~D~n",
           [Loaded, Grown, Found]).

relation_bytes(Bytes) :-
    member(Relation, [v,e,p,plane,t]),
    facts_statistics(Relation, S),
    Bytes is S.bytes+S.index_bytes.

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
