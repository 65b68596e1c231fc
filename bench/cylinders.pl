/* Two cylinders of 1,596 triangles that cross at right angles, their axes in
   one plane, as the smaller ones of peers/boolean/gen.c:

       swipl bench/cylinders.pl -- FOLDER

   writes FOLDER/cyl1600_a.off and cyl1600_b.off. They touch along all of the
   curve, as edges of both meet in it.
*/
:- use_module(library(lists)).

:- initialization(main, main).

sides(400).

main :-
    current_prolog_flag(argv, [Folder]),
    forall(member(Name-Axis, [a-z,b-x]), write_cylinder(Folder, Name, Axis)).

write_cylinder(Folder, Name, Axis) :-
    format(atom(File), '~w/cyl1600_~w.off', [Folder,Name]),
    setup_call_cleanup(open(File, write, Out),
                       write_off(Out, Axis),
                       close(Out)).

write_off(Out, Axis) :-
    sides(N),
    findall(P, corner(N, Axis, P), Ps),
    findall(T, triangle(N, Axis, T), Ts),
    length(Ps, Vertices),
    length(Ts, Triangles),
    format(Out, "OFF~n~d ~d 0~n", [Vertices,Triangles]),
    forall(member([X,Y,Z], Ps), format(Out, "~q ~q ~q~n", [X,Y,Z])),
    forall(member([A,B,C], Ts), format(Out, "3 ~d ~d ~d~n", [A,B,C])).

corner(N, Axis, P) :-
    member(H, [-2.0,2.0]),
    Last is N-1,
    between(0, Last, K),
    X is cos(2*pi*K/N),
    Y is sin(2*pi*K/N),
    (   Axis == z
    ->  P = [X,Y,H]
    ;   P = [H,Y,X]
    ).

triangle(N, Axis, T) :-
    (   Last is N-1,
        between(0, Last, A),
        B is (A+1) mod N,
        A1 is N+A,
        B1 is N+B,
        member(T0, [[A,B,B1],[A,B1,A1]])
    ;   Last is N-2,
        between(1, Last, A),
        B is A+1,
        A1 is N+A,
        B1 is N+B,
        member(T0, [[0,B,A],[N,A1,B1]])
    ),
    (   Axis == z
    ->  T = T0
    ;   reverse(T0, T)
    ).
