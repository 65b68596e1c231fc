:- module(sg_test_checked,
          [ checked/2,                  % +Files, -Results
            checked/3,                  % +Options, +Files, -Results
            write_off/3                 % +File, +Points, +Faces
          ]).
/** <module> The independent checker of results, from Prolog.

The program is tests/checker, which shares nothing with the engine.
*/

:- use_module(library(apply)).
:- use_module(library(dcg/basics)).
:- use_module(library(lists)).
:- use_module(library(process)).
:- use_module(library(pure_input)).

%!  checked(+Files, -Results) is det.
%!  checked(+Options, +Files, -Results) is det.
%
%   Results are what the checker says of each of Files: a dict of numbers and of
%   the atoms `yes` and `no`, as tests/checker/solid_checker.c lists them.
%   Options are arguments: '-i', '-q'.
%
%   @error existence_error(mesh, File) if a file cannot be read.

checked(Files, Results) :-
    checked([], Files, Results).

checked(_, [], []) :-
    !.
checked(Options, Files, Results) :-
    absolute_file_name(foreign('tests/solid_checker'), Program,
                       [access(execute)]),
    append(Options, Files, Arguments),
    setup_call_cleanup(
        process_create(Program, Arguments,
                       [stdout(pipe(Out)), process(Pid)]),
        phrase_from_stream(results(Files, Results), Out),
        ( close(Out),
          process_wait(Pid, _)
        )).

results([], []) -->
    [].
results([File|Files], [Result|Results]) -->
    string_without(`:`, _),
    ": ",
    result(File, Result),
    !,
    results(Files, Results).

result(File, _) -->
    "unreadable",
    { throw(error(existence_error(mesh, File), _)) }.
result(_, Result) -->
    words(Pairs),
    "\n",
    { dict_pairs(Result, checked, Pairs) }.

words([Key-Value|Words]) -->
    string_without(`=\n`, Codes),
    "=",
    value(Value),
    { atom_codes(Key, Codes) },
    (   " "
    ->  words(Words)
    ;   { Words = [] }
    ).

value(Value) -->
    number(Value),
    !.
value(Value) -->
    string_without(` \n`, Codes),
    { atom_codes(Value, Codes) }.

%!  write_off(+File, +Points, +Faces) is det.
%
%   Points are p(X,Y,Z); a face lists its corners, numbered from 1.

write_off(File, Points, Faces) :-
    setup_call_cleanup(
        open(File, write, Out),
        ( length(Points, NPoints),
          length(Faces, NFaces),
          format(Out, "OFF~n~d ~d 0~n", [NPoints,NFaces]),
          forall(member(p(X,Y,Z), Points),
                 ( maplist(float_of, [X,Y,Z], Floats),
                   format(Out, "~w ~w ~w~n", Floats) )),
          forall(member(Face, Faces), write_face(Out, Face))
        ),
        close(Out)).

float_of(X, Float) :-
    Float is float(X).

write_face(Out, Face) :-
    length(Face, N),
    format(Out, "~d", [N]),
    forall(member(V, Face), ( I is V-1, format(Out, " ~d", [I]) )),
    nl(Out).
