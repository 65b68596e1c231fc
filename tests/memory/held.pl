/* Memory of ours that nobody gives back.

       LD_PRELOAD=build/tests/failing_malloc.so swipl -p foreign=build \
           tests/memory/held.pl -- COMMANDS

   Each line of the file COMMANDS is a command of the program, its words between
   tabs; none is wrong usage. All run twice in one process; no file is left open,
   and what our library holds has not grown, when Prolog has collected what it
   held of it. If it has, and twice more, those are named that do the same alone.
   Then again, stopped where a kernel asks whether it is to stop, and refused
   memory where it asks for some: in some of all such places, all if TEST_ALL.
   Such a command fails, or it can do without: it gives what it gave before. The
   last line counts.
*/
:- module(sg_held, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(readutil)).
:- use_module(counted,
              [ sanggwan/2, look_for/1, new_places/1, request_fails/2,
                requests/2, requests_of/1, stops/1
              ]).

:- initialization(main, main).

:- multifile user:message_hook/3.
:- dynamic user:message_hook/3.

%   Before the program's own, which prints.

:- initialization(asserta((user:message_hook(Term, Kind, _) :-
                               sg_held:heard(Kind, Term)))).

:- dynamic last_error/1.

heard(Kind, Term) :-
    (   Kind == error
    ->  retractall(last_error(_)),
        assertz(last_error(Term))
    ;   true
    ).

main :-
    current_prolog_flag(argv, [File]),
    read_file_to_string(File, Text, [encoding(utf8)]),
    split_string(Text, "\n", "", Lines0),
    exclude(==(""), Lines0, Lines),
    maplist([Line,Words-none]>>atomic_list_concat(Words, '\t', Line), Lines,
            Commands),
    requests_of('sanggwan.so'),
    set_random(seed(16)),
    findall(Given,
            ( member(Kind, [stop,refuse]),
              foldl(faulty(Kind), Commands, Given0, []),
              sample(Kind, Given0, Given) ),
            Givens),
    findall(Growing,
            ( member(Given, [Commands|Givens]),
              grows(Given),
              member(Growing, Given),
              grows([Growing]) ),
            Growings),
    findall(Command, misused(Command), Misused0),
    sort(Misused0, Misused),
    maplist(said('holds more each time'), Growings),
    maplist(said('is wrong usage'), Misused),
    findall(Command, left_open(Command), Open0),
    sort(Open0, Open),
    maplist(said('leaves a file open'), Open),
    findall(Command, gives_other(Command), Others0),
    sort(Others0, Others),
    maplist(said('gives something else'), Others),
    foldl([Given,N0,N]>>( length(Given, Own), N is N0+Own ),
          [Commands|Givens], 0, Count),
    maplist(length, [Growings,Misused,Open,Others], Ns),
    sum_list(Ns, Failed),
    Passed is Count-Failed,
    format("~d passed, ~d failed~n", [Passed,Failed]),
    (   Failed =:= 0
    ->  halt
    ;   halt(1)
    ).

%   faulty(+Kind, +Command, -Given, ?Rest): Command, stopped where a question is
%   asked in a place of our library that none asked in before, or refused memory
%   in such a place. A place is a few functions that call each other.

faulty(Kind, Command-none, Given0, Given) :-
    request_fails(0, false),
    stops(0),
    (   Kind == stop
    ->  look_for(1)
    ;   look_for(2)
    ),
    runs(Command-none),
    new_places(Ns),
    look_for(0),
    findall(Command-Fault, ( member(N, Ns), Fault =.. [Kind,N] ), Own),
    append(Own, Given, Given0).

%   sample(+Kind, +All, -Some): all if TEST_ALL, else one in so many.

sample(Kind, All, Some) :-
    (   getenv('TEST_ALL', _)
    ->  Some = All
    ;   part(Kind, Part),
        include(drawn(Part), All, Some)
    ).

part(stop,   4).
part(refuse, 30).

drawn(Part, _) :-
    random(Part) =:= 0.

said(What, Command-Fault) :-
    atomic_list_concat(Command, ' ', Shown),
    format("FAILED: ~w (~w): ~w~n", [Shown,Fault,What]).

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

:- dynamic misused/1, left_open/1, gives_other/1, gave/2.

held_after(Commands, Held) :-
    forall(member(Command, Commands), runs(Command)),
    runs([check,'facts/cube.pl']-none),      % what it holds is held every time
    garbage_collect,
    garbage_collect_atoms,
    garbage_collect_atoms,
    requests(_, Held).

runs(Command-Fault) :-
    open_files(Before),
    setup_call_cleanup(
        set(Fault),
        catch(with_output_to(string(Printed), sanggwan(Command, Status)),
              stopped, Status = stopped),
        unset(Fault)),
    see_given(Command, Fault, Status, Printed),
    (   Fault == none,
        Status == 2
    ->  assertz(misused(Command-Fault))
    ;   true
    ),
    open_files(After),
    (   After > Before
    ->  assertz(left_open(Command-Fault))
    ;   true
    ).

%   A command without a fault gives the same each time.

see_given(_, Fault, Status, _) :-
    fails_so(Fault, Status),
    !.
see_given(Command, Fault, Status, Printed) :-
    (   append(_, ['-o',File|_], Command),
        exists_file(File)
    ->  read_file_to_codes(File, Written, [type(binary)])
    ;   Written = []
    ),
    variant_sha1(given(Status,Printed,Written), Given),
    (   gave(Command, Given)
    ->  true
    ;   Fault == none,
        \+ gave(Command, _)
    ->  assertz(gave(Command, Given))
    ;   assertz(gives_other(Command-Fault))
    ).

%   fails_so(?Fault, ?Status): with this status where it could not go on.

fails_so(stop(_), stopped).
fails_so(stop(_), 2).
fails_so(refuse(_), 4).
fails_so(refuse(_), 2) :-
    last_error(Term),
    format(atom(Said), '~q', [Term]),
    sub_atom(Said, _, _, _, 'Cannot allocate memory').   % of the system's errno

open_files(Count) :-
    aggregate_all(count, stream_property(_, file_name(_)), Count).

set(none).
set(stop(N)) :-
    stops(N).
set(refuse(N)) :-
    request_fails(N, false).

unset(none).
unset(stop(_)) :-
    stops(0).
unset(refuse(_)) :-
    request_fails(0, false).
