/* Memory of ours that nobody gives back.

       LD_PRELOAD=build/tests/failing_malloc.so swipl -p foreign=build \
           tests/memory/held.pl -- COMMANDS

   Each line of the file COMMANDS is a command of the program, its words between
   tabs; none is wrong usage. All run twice in one process, and what our library
   holds has not grown, when Prolog has collected what it held of it. If it has,
   and twice more, those are named that do the same alone. The last line counts.
*/
:- module(sg_held, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(readutil)).
:- use_module(counted, [sanggwan/2, requests/2, requests_of/1]).

:- initialization(main, main).

:- multifile user:message_hook/3.
:- dynamic user:message_hook/3.

%   Before the program's own, which prints.

:- initialization(asserta((user:message_hook(_, _, _) :- true))).

main :-
    current_prolog_flag(argv, [File]),
    read_file_to_string(File, Text, [encoding(utf8)]),
    split_string(Text, "\n", "", Lines0),
    exclude(==(""), Lines0, Lines),
    maplist([Line,Words]>>atomic_list_concat(Words, '\t', Line), Lines,
            Commands),
    requests_of('sanggwan.so'),
    (   grows(Commands)
    ->  include([Command]>>grows([Command]), Commands, Growing)
    ;   Growing = []
    ),
    findall(Command, misused(Command), Misused0),
    sort(Misused0, Misused),
    maplist(said('holds more each time'), Growing),
    maplist(said('is wrong usage'), Misused),
    maplist(length, [Commands,Growing,Misused], [Count,N1,N2]),
    Failed is N1+N2,
    Passed is Count-Failed,
    format("~d passed, ~d failed~n", [Passed,Failed]),
    (   Failed =:= 0
    ->  halt
    ;   halt(1)
    ).

said(What, Command) :-
    atomic_list_concat(Command, ' ', Shown),
    format("FAILED: ~w: ~w~n", [Shown,What]).

%   grows(+Commands) is semidet: each time more is held, four times; Prolog may
%   hold something of the last world for a while.

grows(Commands) :-
    held_after(Commands, Held1),
    held_after(Commands, Held2),
    Held1 < Held2,
    held_after(Commands, Held3),
    Held2 < Held3,
    held_after(Commands, Held4),
    Held3 < Held4.

:- dynamic misused/1.

held_after(Commands, Held) :-
    forall(member(Command, Commands), runs(Command)),
    runs([check,'facts/cube.pl']),      % what it holds is held every time
    garbage_collect,
    garbage_collect_atoms,
    garbage_collect_atoms,
    requests(_, Held).

runs(Command) :-
    with_output_to(string(_), sanggwan(Command, Status)),
    (   Status =:= 2
    ->  assertz(misused(Command))
    ;   true
    ).
