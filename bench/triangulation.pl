/* Triangulation (PL-6): events and growth.

       bench/triangulation [LARGEST]

   Event: a triangle cut by an open chain of K segments from side to side; its
   edges entered into a scratch relation, then triangulated, microseconds.
   Growth: polygons of N vertices, milliseconds, the best of three; exponent:
   the kernel's time grows with this power of N, from the line before.
*/
:- use_module('../rules/store').
:- use_module('../rules/kernel').
:- use_module('../rules/polygon/triangulation').
:- use_module('../tests/oracle/triangulation').
:- use_module(library(lists)).
:- use_module(library(apply)).
:- use_module(library(random)).
:- set_prolog_flag(optimise, true).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, Arguments),
    (   Arguments = [Text]
    ->  atom_number(Text, Largest)
    ;   Largest = 20000
    ),
    format("~w~t~10|~t~w~20|~t~w~30|~t~w~40|~t~w~50|~t~w~60|  us an event~n",
           [event, triangles, enter, rule, kernel, 'rule/krnl']),
    forall(member(K, [1,2,5,16,50]), event(K)),
    format("~n~w~t~10|~t~w~20|~t~w~30|~t~w~40|~t~w~50|~t~w~60|~t~w~70|  \c
            ms a polygon~n",
           [polygon, vertices, triangles, rule, kernel, 'rule/krnl',
            exponent]),
    forall(member(Shape, [star,ragged,comb,tilted,spiral,strip]),
           ( findall(N, ( member(N, [2500,5000,10000,20000]), N =< Largest ),
                     Ns),
             foldl(growth(Shape), Ns, none, _)
           )).

/* - - - events - - - */

event(K) :-
    new_world(World),
    in_world(World,
             ( cut_triangle(K),
               Rounds is 20000//K,
               each(Rounds, entered, Enter),
               each(Rounds, by_rule(_), Rule),
               each(Rounds, by_kernel(_), Kernel),
               by_rule(Triangles),
               by_kernel(Triangles),
               length(Triangles, Count),
               Rule1 is Rule-Enter,
               Kernel1 is Kernel-Enter,
               Ratio is Rule1/Kernel1,
               format("k=~d~t~10|~t~d~20|~t~1f~30|~t~1f~40|~t~1f~50|\c
                       ~t~2f~60|~n",
                      [K, Count, Enter, Rule1, Kernel1, Ratio])
             )).

%   The edges from the store into a scratch relation.

entered :-
    work_open(1, 1, Work),
    work_close(Work).

by_rule(Triangles) :-
    work_open(1, 1, Work),
    work_triangles_by_rule(Work, Triangles),
    work_close(Work).

by_kernel(Triangles) :-
    work_open(1, 1, Work),
    work_triangles(Work, Triangles),
    work_close(Work).

%   cut_triangle(+K): corners 1, 2, 3; the cut from 4 on side 1-2 to 5 on side
%   3-1.

cut_triangle(K) :-
    assert_fact(segment(1, surface, event)),
    place(1, 0.0, 0.0),
    place(2, 10.0, 0.0),
    place(3, 0.0, 10.0),
    place(4, 4.0, 0.0),
    place(5, 0.0, 4.0),
    Inner is K-1,
    findall(V, ( between(1, Inner, I), V is 5+I,
                 X is 4*(1-I/K)+0.7*(I mod 2),
                 Y is 4*I/K+0.3*(I mod 2),
                 place(V, X, Y)
               ),
            Vs),
    append([4|Vs], [5], Chain),
    findall(Edge, ( nextto(A, B, Chain), member(Edge, [A-B, B-A]) ), Cut),
    append([1-4, 4-2, 2-3, 3-5, 5-1], Cut, Edges),
    forall(nth1(E, Edges, A-B), assert_fact(e(1, E, A, B, 1))),
    length(Edges, N),
    numlist(1, N, Es),
    assert_fact(p(1, 1, Es)).

place(V, X0, Y0) :-
    X is float(X0),
    Y is float(Y0),
    assert_fact(v(1, V, X, Y, 0.0)).

/* - - - growth - - - */

%   growth(+Shape, +N, +Before, -Now): both are N-Kernel, or `none`.

growth(Shape, N, Before, N-Kernel) :-
    shape(Shape, N, Points),
    new_world(World),
    in_world(World, grown(Shape, N, Points, Before, Kernel)).

grown(Shape, N, Points, Before, Kernel) :-
    assert_fact(segment(1, surface, Shape)),
    forall(nth1(V, Points, X-Y), place(V, X, Y)),
    numlist(1, N, Es),
    forall(member(E, Es),
           ( Next is E mod N+1, assert_fact(e(1, E, E, Next, 1)) )),
    assert_fact(p(1, 1, Es)),
    best(polygon_triangles(1, 1, Triangles), Rule),
    best(kernel_triangles(Triangles), Kernel),
    length(Triangles, Count),
    Ratio is Rule/Kernel,
    (   Before = N0-Kernel0
    ->  Power is log(Kernel/Kernel0)/log(N/N0),
        format(string(Exponent), "~2f", [Power])
    ;   Exponent = '-'
    ),
    format("~w~t~10|~t~d~20|~t~d~30|~t~1f~40|~t~1f~50|~t~2f~60|~t~w~70|~n",
           [Shape, N, Count, Rule, Kernel, Ratio, Exponent]).

kernel_triangles(Triangles) :-
    work_open(1, 1, Work),
    work_resolve(Work, 0.0),
    work_triangles(Work, Triangles),
    work_close(Work).

shape(star, N, Points) :-
    findall(X-Y, ( between(1, N, I), R is 0.4+0.6*(I mod 2),
                   round_point(I, N, R, X, Y) ),
            Points).
shape(ragged, N, Points) :-
    set_random(seed(7)),
    findall(X-Y, ( between(1, N, I), random(Q), R is 0.2+Q,
                   round_point(I, N, R, X, Y) ),
            Points).
shape(comb, N, Points) :-
    Teeth is N-2,
    findall(X-Y, ( between(1, Teeth, I), X is -I/Teeth, Y is I mod 2 ), Tips),
    append([-0.9-(-0.1), 0.1-(-0.1)], Tips, Points).
shape(tilted, N, Points) :-
    shape(comb, N, Points0),
    findall(X-Y, ( member(A-B, Points0),
                   X is A*0.8-B*0.6,
                   Y is A*0.6+B*0.8 ),
            Points).
shape(spiral, N, Points) :-
    Half is N//2,
    numlist(1, Half, There),
    reverse(There, Back),
    findall(X-Y, ( member(I, There), spiral_point(I, Half, 5, X, Y) ), Outer),
    findall(X-Y, ( member(I, Back), spiral_point(I, Half, 2, X, Y) ), Inner),
    append(Outer, Inner, Points).
shape(strip, N, Points) :-
    Half is N//2,
    High is Half-1,
    numlist(0, High, There),
    reverse(There, Back),
    findall(X-0, member(X, There), Low),
    findall(X-10, member(X, Back), Top),
    append(Low, Top, Points).

round_point(I, N, R, X, Y) :-
    A is 2*pi*I/N,
    X is R*cos(A),
    Y is R*sin(A).

spiral_point(I, N, R0, X, Y) :-
    A is 40*pi*I/N,
    R is R0+A,
    X is R*cos(A),
    Y is R*sin(A).

/* - - - measuring - - - */

:- meta_predicate each(+, 0, -), best(0, -).

each(Rounds, Goal, Microseconds) :-
    garbage_collect,
    statistics(cputime, T0),
    (   between(1, Rounds, _),
        \+ \+ Goal,
        fail
    ;   true
    ),
    statistics(cputime, T1),
    Microseconds is (T1-T0)*1.0e6/Rounds.

best(Goal, Milliseconds) :-
    findall(T, ( between(1, 3, _), statistics(cputime, T0), \+ \+ Goal,
                 statistics(cputime, T1), T is (T1-T0)*1000 ),
            Times),
    min_list(Times, Milliseconds),
    once(Goal).
