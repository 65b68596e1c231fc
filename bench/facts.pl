/* The store beside SWI-Prolog's dynamic facts, the same rows in one run.

       bench/facts [Rows]

   Medians of five; the last column is the store's time over SWI-Prolog's.
   Loading: sg_world_add_many() from arrays against a Prolog loop of assertz/1.
*/
:- use_module('../rules/store').
:- use_module(library(lists)).
:- use_foreign_library(foreign(facts), install_facts).

:- dynamic fv/5, fe/5.

:- initialization(main, main).

main :-
    current_prolog_flag(argv, Argv),
    (   Argv = [Atom|_],
        atom_number(Atom, N)
    ->  true
    ;   N = 1000000
    ),
    format("~D rows of v/5 and of e/5~n", [N]),
    format("~w~t~34| ~t~w~46| ~t~w~58| ~t~w~68|~n",
           [what, store, 'SWI-Prolog', ratio]),
    bytes_and_load(N),
    bytes_and_load_edges(N),
    row('scan v/5, us a row', N, scan_store, scan_swi),
    row('scan v/5 comparing X, us a row', N, compare_store, compare_swi),
    M is N // 2,
    row('v/5 by key, us a call', M, key_store(M, N), key_swi(M, N)),
    row('e/5 by start vertex, us a call', M, start_store(M, N),
        start_swi(M, N)),
    K is N // 10,
    row_once('add from Prolog, us a row', K, add_store(K), add_swi(K)).

% Bytes a row and bulk loading.

bytes_and_load(N) :-
    statistics(cputime, T0),
    forall(between(1, N, I),
           (   X is I*0.5, Y is I*0.25, Z is I*0.125,
               assertz(fv(1, I, X, Y, Z))
           )),
    statistics(cputime, T1),
    Swi is (T1-T0)*1.0e6/N,
    fv(1, 7, _, _, _),                      % its index is made here
    fact_bytes(fv(_,_,_,_,_), SwiBytes),
    load_five(N, Store),
    v(1, 7, _, _, _),
    facts_statistics(v, Statistics),
    Bytes is (Statistics.bytes + Statistics.index_bytes)/N,
    SwiRow is SwiBytes/N,
    print_row('bytes a row of v/5, key index too', Bytes, SwiRow),
    print_row('load v/5 from C / assertz, us a row', Store, Swi).

load_five(N, Median) :-
    bench_vertices(N, _),                   % the pages are touched once
    findall(Us,
            (   between(1, 5, _),
                retractall_facts(v(_,_,_,_,_)),
                bench_vertices(N, Seconds),
                Us is Seconds*1.0e6/N
            ),
            Times),
    median(Times, Median).

bytes_and_load_edges(N) :-
    forall(between(1, N, I),
           (   V1 is (I-1)//3+1, V2 is ((I-1)*7919) mod N + 1,
               assertz(fe(1, I, V1, V2, 1))
           )),
    fe(1, _, 7, _, _),
    fact_bytes(fe(_,_,_,_,_), SwiBytes),
    bench_edges(N, Seconds),
    e(1, _, 7, _, _),
    facts_statistics(e, Statistics),
    Bytes is (Statistics.bytes + Statistics.index_bytes)/N,
    SwiRow is SwiBytes/N,
    print_row('bytes a row of e/5, two indexes', Bytes, SwiRow),
    Us is Seconds*1.0e6/N,
    format("~w~t~34| ~t~3f~46|~n", ['load e/5 from C, us a row', Us]).

fact_bytes(Head, Bytes) :-
    predicate_property(Head, size(Bytes)).

% Timing.

row(Name, N, Store, Swi) :-
    times(N, Store, StoreTime),
    times(N, Swi, SwiTime),
    print_row(Name, StoreTime, SwiTime).

row_once(Name, N, Store, Swi) :-
    time_of(N, Store, StoreTime),
    time_of(N, Swi, SwiTime),
    print_row(Name, StoreTime, SwiTime).

print_row(Name, Store, Swi) :-
    Ratio is Store/Swi,
    format("~w~t~34| ~t~3f~46| ~t~3f~58| ~t~3f~68|~n",
           [Name, Store, Swi, Ratio]).

times(N, Goal, Median) :-
    findall(T, ( between(1, 5, _), time_of(N, Goal, T) ), Times),
    median(Times, Median).

time_of(N, Goal, Us) :-
    garbage_collect,
    statistics(cputime, T0),
    (   call(Goal)
    ->  true
    ;   true
    ),
    statistics(cputime, T1),
    Us is (T1-T0)*1.0e6/N.

median(Times, Median) :-
    msort(Times, Sorted),
    length(Sorted, Length),
    Middle is Length//2,
    nth0(Middle, Sorted, Median).

% The questions, the same for both.

scan_store :- v(_,_,_,_,_), fail.
scan_swi   :- fv(_,_,_,_,_), fail.

compare_store :- v(_,_,X,_,_), X < 0.0, fail.
compare_swi   :- fv(_,_,X,_,_), X < 0.0, fail.

key_store(0, _) :- !.
key_store(M, N) :-
    I is (M*7919) mod N + 1,
    v(1, I, _, _, _),
    M1 is M-1,
    key_store(M1, N).

key_swi(0, _) :- !.
key_swi(M, N) :-
    I is (M*7919) mod N + 1,
    fv(1, I, _, _, _),
    M1 is M-1,
    key_swi(M1, N).

start_store(0, _) :- !.
start_store(M, N) :-
    V is ((M*7919) mod N)//3 + 1,
    ( e(1, _, V, _, _), fail ; true ),
    M1 is M-1,
    start_store(M1, N).

start_swi(0, _) :- !.
start_swi(M, N) :-
    V is ((M*7919) mod N)//3 + 1,
    ( fe(1, _, V, _, _), fail ; true ),
    M1 is M-1,
    start_swi(M1, N).

add_store(K) :-
    forall(between(1, K, I), assert_fact(v(2, I, 0.5, 0.25, 0.125))).
add_swi(K) :-
    forall(between(1, K, I), assertz(fv(2, I, 0.5, 0.25, 0.125))).
