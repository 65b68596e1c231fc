/* Gluing, for bench/gluing.

       bench/gluing.pl [N...]

   N^3 unit cubes that fill a larger one: seconds of the processor for the
   glue, without making the cubes, in place and turned; the exponent of the
   first from the size before; and how much higher the peak of memory is, in
   bytes a cube. Then milliseconds for one cube more (asserted, and evaluated
   again), for one in the middle that goes, where others went before and the
   indexes are there, and one that moves to the outside; for undo of that, and
   for unglue. The same cubes, and ten times as many, as a soup of faces without
   operands, read from an OFF file by a process of its own: seconds for the
   regions with their rows and their report, their exponent, and microseconds
   for each of all answers about neighbours. Then the regions of a book of
   pages at one edge.
*/
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(process)).
:- use_module(library(readutil)).
:- use_module(library(yall)).
:- use_module('../rules/csg/csg', [complete_tree/2]).
:- use_module('../rules/sanggwan').
:- use_module('../rules/gluing/regions').
:- use_module('../rules/model/model', [load_model/2]).
:- use_module('../rules/polygon/triangulation').
:- use_module('../rules/space_limit', [with_stack_limit/2]).
:- use_module('../rules/store').

:- initialization(main, main).

main :-
    current_prolog_flag(argv, Words),
    (   Words = [peak,N,What]
    ->  atom_number(N, Number),
        child_told(What, Number)
    ;   Words == []
    ->  told([5,10,22,46])
    ;   maplist(atom_number, Words, Sizes),
        told(Sizes)
    ).

told(Sizes) :-
    table([cubes,glue,exponent,turned,bytes,more,goes,moves,undo,unglue]),
    foldl(cubes_told, Sizes, none, _),
    last(Sizes, Most),
    Larger is round(10**(1/3)*Most),
    append(Sizes, [Larger], Soups),
    nl,
    table([cells,faces,regions,exponent,answer]),
    foldl(soup_told, Soups, none, _),
    nl,
    table([pages,seconds]),
    forall(member(K, [10,100,1000]), book_told(K)).

table([First|Others]) :-
    findall("~t~w~10+", member(_, Others), Columns),
    atomic_list_concat(['~w~t~8|'|Columns], Format),
    format(Format, [First|Others]),
    nl.

cubes_told(N, Before, Cubes-Glue) :-
    Cubes is N**3,
    in_new_world(glued(N, [], Glue, [More,Goes,Moves,Undo,Unglue])),
    in_new_world(glued(N, [rotate(axis(1,2,3),17.3)], Turned, _)),
    maplist(peak(N), [cubes,glue], [Without,With]),
    Bytes is round((With-Without)/Cubes),
    exponent(Before, Cubes-Glue, Exponent),
    table([Cubes,Glue,Exponent,Turned,Bytes,More,Goes,Moves,Undo,Unglue]).

soup_told(N, Before, Cells-Seconds) :-
    Cells is N**3,
    child(N, soup, soup(Seconds,Faces,Each)),
    exponent(Before, Cells-Seconds, Exponent),
    table([Cells,Faces,Seconds,Exponent,Each]).

exponent(none, _, -).
exponent(N0-T0, N-T, Exponent) :-
    Exponent is round(log(T/T0)/log(N/N0)*100)/100.

:- meta_predicate in_new_world(0), timed(0, -).

in_new_world(Goal) :-
    new_world(World),
    in_world(World, Goal).

timed(Goal, Seconds) :-
    garbage_collect,
    statistics(cputime, T0),
    call(Goal),
    statistics(cputime, T1),
    Seconds is round((T1-T0)*10000)/10000.

milliseconds(Goal, Milliseconds) :-
    timed(Goal, Seconds),
    Milliseconds is round(Seconds*10000)/10.

%   peak(N, What, Bytes): the most memory of a process of its own that makes
%   the cubes, and glues them if What is `glue`.

peak(N, What, Bytes) :-
    child(N, What, Bytes).

%   child(N, What, Answer): what a process of its own says.

child(N, What, Answer) :-
    once(file_search_path(foreign, Build)),
    current_prolog_flag(executable, Swipl),
    source_file(main, Script),
    format(string(Foreign), "foreign=~w", [Build]),
    setup_call_cleanup(
        process_create(Swipl, ['-p',Foreign,Script,'--',peak,N,What],
                       [stdout(pipe(Out))]),
        read_term(Out, Answer, []),
        close(Out)).

child_told(soup, N) :-
    !,
    soup(N, Seconds, Faces, Each),
    format("~q.~n", [soup(Seconds,Faces,Each)]).
child_told(What, N) :-
    peak_told(N, What).

peak_told(N, What) :-
    cubes_made(N, [], S),
    (   What == glue
    ->  evaluate(S)
    ;   true
    ),
    read_file_to_string('/proc/self/status', Text, []),
    split_string(Text, "\n", "", Lines),
    member(Line, Lines),
    split_string(Line, "\t ", "\t ", ["VmHWM:"|Words]),
    member(Word, Words),
    number_string(KiB, Word),
    !,
    Bytes is KiB*1024,
    format("~d.~n", [Bytes]).

cube(Steps, X-Y-Z, at([translate(X,Y,Z)|Steps], box(size(1,1,1)))).

%   cubes_made(N, Steps, S): S is the glue of them, which is not made yet.

cubes_made(N, Steps, S) :-
    M is N-1,
    findall(Term,
            ( between(0, M, X), between(0, M, Y), between(0, M, Z),
              cube(Steps, X-Y-Z, Term) ),
            Terms),
    foldl([Term,K,K1]>>( assert_fact(segment(K, solid, Term)), K1 is K+1 ),
          Terms, 1, S),
    Cubes is S-1,
    numlist(1, Cubes, Ss),
    assert_fact(segment(S, cells, glue(Ss))),
    facts_transaction(( complete_tree([S], Incomplete),
                        complete_segments(Incomplete) )).

glued(N, Steps, Seconds, [More,Goes,Moves,Undo,Unglue]) :-
    cubes_made(N, Steps, S),
    timed(evaluate(S), Seconds),
    cube(Steps, N-0-0, Term),
    milliseconds(one_more(S, Term), More),
    facts_undo,
    Middle is (S+1)//2,
    forall(between(1, 3, _), ( one_less(S, Middle), facts_undo )),
    milliseconds(one_less(S, Middle), Goes),
    facts_undo,
    milliseconds(one_moved(S, Middle, Term), Moves),
    milliseconds(facts_undo, Undo),
    milliseconds(unglue(S), Unglue).

one_less(S, N) :-
    segment(S, cells, glue(Ss)),
    selectchk(N, Ss, Others),
    facts_transaction(( retractall_facts(segment(S, _, _)),
                        assert_fact(segment(S, cells, glue(Others))),
                        evaluate(S) )).

one_moved(S, N, Term) :-
    facts_transaction(( retractall_facts(segment(N, _, _)),
                        assert_fact(segment(N, solid, Term)),
                        evaluate(S) )).

one_more(S, Term) :-
    N is S+1,
    segment(S, cells, glue(Ss)),
    append(Ss, [N], All),
    facts_transaction(( assert_fact(segment(N, solid, Term)),
                        retractall_facts(segment(S, _, _)),
                        assert_fact(segment(S, cells, glue(All))),
                        evaluate(S) )).

soup(N, Seconds, Faces, Each) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [extension(off)]),
          soup_written(Out, N, Faces),
          close(Out) ),
        load_model([File], []),
        delete_file(File)),
    with_stack_limit(8 000 000 000, timed(regions_made(1, _), Seconds)),
    timed(aggregate_all(count, region_neighbour(1, _, _, _), Answers), Asked),
    Each is round(Asked/max(1, Answers)*1000000000)/1000.

soup_written(Out, N, Faces) :-
    M is N+1,
    Vertices is M**3,
    Faces is 3*N*N*M,
    format(Out, "OFF~n~d ~d 0~n", [Vertices,Faces]),
    forall(( between(0, N, X), between(0, N, Y), between(0, N, Z) ),
           format(Out, "~d ~d ~d~n", [X,Y,Z])),
    forall(face(N, M, [A,B,C,D]),
           format(Out, "4 ~d ~d ~d ~d~n", [A,B,C,D])).

%   number(M, X, Y, Z, V): V counts from 0.

number(M, X, Y, Z, V) :-
    V is (X*M+Y)*M+Z.

face(N, M, Vs) :-
    between(0, N, X),
    between(0, N, Y),
    between(0, N, Z),
    member(axis(A,B), [axis(d(0,1,0),d(0,0,1)),axis(d(0,0,1),d(1,0,0)),
                       axis(d(1,0,0),d(0,1,0))]),
    maplist(corner(N, M, X, Y, Z, A, B), [0-0,1-0,1-1,0-1], Vs).

corner(N, M, X, Y, Z, d(X1,Y1,Z1), d(X2,Y2,Z2), I-J, V) :-
    P is X+I*X1+J*X2,
    Q is Y+I*Y1+J*Y2,
    R is Z+I*Z1+J*Z2,
    P =< N,
    Q =< N,
    R =< N,
    number(M, P, Q, R, V).

face_written([A,B,C,D], E-P, E4-P1) :-
    foldl([V-W,K,K1]>>( assert_fact(e(1, K, V, W, 1)), K1 is K+1 ),
          [A-B,B-C,C-D,D-A], E, E4),
    Last is E4-1,
    numlist(E, Last, Es),
    assert_fact(p(1, P, Es)),
    P1 is P+1.

book_told(K) :-
    in_new_world(book(K, Seconds)),
    table([K,Seconds]).

book(K, Seconds) :-
    assert_fact(segment(1, surface, book)),
    assert_fact(v(1, 1, 0, 0, 0)),
    assert_fact(v(1, 2, 0, 0, 1)),
    forall(between(1, K, I),
           ( V is 2*I+1,
             W is V+1,
             X is cos(2*pi*I/K),
             Y is sin(2*pi*I/K),
             assert_fact(v(1, V, X, Y, 0)),
             assert_fact(v(1, W, X, Y, 1)) )),
    findall([1,V,W,2], ( between(1, K, I), V is 2*I+1, W is V+1 ), Pages),
    foldl(face_written, Pages, 1-1, _),
    complete_segments,
    timed(regions_report(1, _), Seconds).
