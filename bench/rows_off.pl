:- module(bench_rows_off, [write_rows_off/2]).
/** <module> The triangles of a segment as an OFF file, straight from its rows.

Nothing of the way out of the program is in it: no merging, no rounding.
*/

:- use_module('../rules/store').
:- use_module(library(aggregate)).

%!  write_rows_off(+S, +File) is det.

write_rows_off(S, File) :-
    aggregate_all(count, v(S, _, _, _, _), Vertices),
    aggregate_all(count, t(S, _, _, _, _, _), Triangles),
    setup_call_cleanup(
        open(File, write, Out, [buffer(full)]),
        ( format(Out, "OFF~n~d ~d 0~n", [Vertices,Triangles]),
          numbered_vertices(S, Out, Numbers),
          forall(t(S, _, _, A, B, C), triangle(Out, Numbers, A, B, C))
        ),
        close(Out)).

%   numbered_vertices(S, Out, Numbers): an argument for every vertex number.

numbered_vertices(S, Out, Numbers) :-
    aggregate_all(max(V), ( V = 1 ; v(S, V, _, _, _) ), Most),
    functor(Numbers, numbers, Most),
    Next = next(0),
    forall(v(S, V, X, Y, Z),
           ( format(Out, "~w ~w ~w~n", [X,Y,Z]),
             arg(1, Next, I),
             nb_setarg(V, Numbers, I),
             I1 is I+1,
             nb_setarg(1, Next, I1)
           )).

triangle(Out, Numbers, A, B, C) :-
    arg(A, Numbers, I),
    arg(B, Numbers, J),
    arg(C, Numbers, K),
    format(Out, "3 ~d ~d ~d~n", [I,J,K]).
