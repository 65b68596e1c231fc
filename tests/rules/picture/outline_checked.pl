:- module(sg_test_outline_checked,
          [ open_outlines/1,            % -Pictures
            add_outline/2,              % +Pictures, +Name
            check_outlines/2            % +Pictures, -Results
          ]).
/** <module> The checker of silhouettes, from Prolog.

The program is tests/outline_checker, which shares nothing with the engine: it
fills the triangles that are seen and asks if a visible line is drawn wherever
they end.
*/

:- use_module(library(apply)).
:- use_module(library(dcg/basics)).
:- use_module(library(process)).
:- use_module(library(pure_input)).
:- use_module(rules(picture/contour), [line_ends/4]).
:- use_module(rules(store)).

%!  open_outlines(-Pictures) is det.
%
%   Begin a heap of pictures, to be checked all at once.

open_outlines(pictures(File, Out)) :-
    tmp_file_stream(File, Out, [extension(txt), encoding(utf8)]).

%!  add_outline(+Pictures, +Name) is det.
%
%   Add the picture of the current world as Name, an atom without spaces.

add_outline(pictures(_, Out), Name) :-
    forall(drawn(_, S, E, From, To, visible, _),
           ( line_ends(S, E, X0-Y0, X1-Y1),
             maplist(between(X0, Y0, X1, Y1), [From,To], [XA-YA,XB-YB]),
             format(Out, "l ~15g ~15g ~15g ~15g~n", [XA,YA,XB,YB]) )),
    forall(( t(S, _, _, A, B, C),
             screen(S, A, XA, YA, _),
             screen(S, B, XB, YB, _),
             screen(S, C, XC, YC, _) ),
           format(Out, "t ~15g ~15g ~15g ~15g ~15g ~15g~n",
                  [XA,YA,XB,YB,XC,YC])),
    format(Out, "end ~w~n", [Name]).

between(X0, Y0, X1, Y1, F, X-Y) :-
    X is X0 + F*(X1-X0),
    Y is Y0 + F*(Y1-Y0).

%!  check_outlines(+Pictures, -Results:list) is det.
%
%   Results are outline(Name, Silhouette, Bare, Run, Farthest, At), in dots
%   of a picture of 1000: how many dots the silhouette has, how many of them no
%   visible line within 2.5 dots, the most of these that are connected, how far
%   the farthest is from a line, and where the run begins, X-Y of the picture.

check_outlines(pictures(File, Out), Results) :-
    close(Out),
    absolute_file_name(foreign('tests/outline_checker'), Program,
                       [access(execute)]),
    setup_call_cleanup(
        process_create(Program, [file(File)],
                       [stdout(pipe(Told)), process(Process)]),
        phrase_from_stream(results(Results), Told),
        ( close(Told), process_wait(Process, exit(0)), delete_file(File) )).

results([outline(Name,Silhouette,Bare,Run,Farthest,X-Y)|Results]) -->
    string_without(`:\n`, Codes),
    ": silhouette=", integer(Silhouette),
    " bare=", integer(Bare),
    " run=", integer(Run),
    " farthest=", number(Farthest),
    " at=", number(X), ",", number(Y), "\n",
    !,
    { atom_codes(Name, Codes) },
    results(Results).
results([]) -->
    [].
