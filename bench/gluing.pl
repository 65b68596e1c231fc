/* Gluing, for bench/gluing.

       bench/gluing.pl [N...]

   N^3 unit cubes that fill a larger one, in place and turned; seconds of the
   processor for the glue alone, without making the cubes. The same cubes as a
   soup of faces without operands: seconds for the regions, and microseconds for
   each of all answers about neighbours. Then the regions of a book of pages at
   one edge.
*/
:- use_module('../rules/sanggwan').
:- use_module('../rules/gluing/regions').
:- use_module('../rules/polygon/triangulation').
:- use_module('../rules/store').

:- initialization(main, main).

main :-
    current_prolog_flag(argv, Words),
    (   Words == []
    ->  Sizes = [5,10,22]
    ;   maplist(atom_number, Words, Sizes)
    ),
    format("~w~t~8|~w~t~10+~w~n", [cubes,glue,turned]),
    forall(member(N, Sizes), cubes_told(N)),
    last(Sizes, Most),
    Larger is round(1.82*Most),
    format("~n~w~t~8|~w~t~10+~w~t~10+~w~n", [cells,faces,regions,answer]),
    forall(( member(N, Sizes) ; N = Larger ), soup_told(N)),
    format("~n~w~t~8|~w~n", [pages,seconds]),
    forall(member(K, [10,100,1000]), book_told(K)).

cubes_told(N) :-
    Cubes is N**3,
    in_world(glued(N, [], Glue)),
    in_world(glued(N, [rotate(axis(1,2,3),17.3)], Turned)),
    format("~d~t~8|~w~t~10+~w~n", [Cubes,Glue,Turned]).

soup_told(N) :-
    Cells is N**3,
    in_world(soup(N, Seconds, Faces, Each)),
    format("~d~t~8|~d~t~10+~w~t~10+~w~n", [Cells,Faces,Seconds,Each]).

in_world(Goal) :-
    facts_snapshot(( retractall_facts(segment(_, _, _)), Goal )).

timed(Goal, Seconds) :-
    garbage_collect,
    statistics(cputime, T0),
    call(Goal),
    statistics(cputime, T1),
    Seconds is round((T1-T0)*10000)/10000.

glued(N, Steps, Seconds) :-
    M is N-1,
    findall(at([translate(X,Y,Z)|Steps], box(size(1,1,1))),
            ( between(0, M, X), between(0, M, Y), between(0, M, Z) ), Terms),
    foldl([Term,S,S1]>>( assert_fact(segment(S, solid, Term)), S1 is S+1 ),
          Terms, 1, Last),
    complete_segments,
    Most is Last-1,
    numlist(1, Most, Ss),
    assert_fact(segment(Last, cells, glue(Ss))),
    timed(evaluate(Last), Seconds).

soup(N, Seconds, Faces, Each) :-
    assert_fact(segment(1, cells, soup)),
    M is N+1,
    forall(( between(0, N, X), between(0, N, Y), between(0, N, Z) ),
           ( number(M, X, Y, Z, V), assert_fact(v(1, V, X, Y, Z)) )),
    findall(Face, face(N, M, Face), All),
    foldl(face_written, All, 1-1, _),
    complete_segments,
    length(All, Faces),
    timed(regions_made(1, _), Seconds),
    timed(aggregate_all(count, region_neighbour(1, _, _, _), Answers), Asked),
    Each is round(Asked/max(1, Answers)*1000000000)/1000.

number(M, X, Y, Z, V) :-
    V is (X*M+Y)*M+Z+1.

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
    in_world(book(K, Seconds)),
    format("~d~t~8|~w~n", [K,Seconds]).

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
