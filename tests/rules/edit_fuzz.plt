:- module(test_edit_fuzz, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(filesex)).
:- use_module(library(lists)).
:- use_module(library(process)).
:- use_module(library(readutil)).
:- use_module(rules(sanggwan), [in_world/2, new_world/1]).
:- use_module(rules(topics), [offered/2]).
:- use_module(tests('rules/edit_question'), [asked/1, unfit/1]).
:- use_module(tests('rules/sample'), [few/3]).

/* Random edits and random questions (edit_script.pl), in processes of their
own, so that one that ends or that never ends is seen, and named by its number.

From the environment: EDIT_FUZZ=COUNT and EDIT_FUZZ_FROM=FIRST run others than
those below; of threads that share a world a tenth of COUNT. One alone, and what
it does:

    EDIT_SAY=1 EDIT_SCRATCH=/tmp swipl -p foreign=build \
        tests/rules/edit_child.pl -- 7 7 0 1
*/

setting(Name, Default, Value) :-
    (   getenv(Name, Text),
        atom_number(Text, Value0)
    ->  Value = Value0
    ;   Value = Default
    ).

%   prolog(Program, Options): what runs Prolog, as in tests/run.

prolog(Program, Options) :-
    (   getenv('SWIPL', Text)
    ->  split_string(Text, " ", " ", [Program|Options])
    ;   Program = "swipl",
        Options = []
    ).

%   scripts(First, Last, Threads, Folder, Wrong): Wrong is the list of what
%   was wrong, terms wrong(Seed, What). A process has 500 scripts at most, so
%   what an early one left behind is never far.

scripts(First, Last, _, _, []) :-
    First > Last,
    !.
scripts(First, Last, Threads, Folder, Wrong) :-
    Until is min(Last, First+499),
    child([First,Until], Threads, Folder, Lines, Status),
    findall(wrong(Seed, What), told(Lines, Seed, What), Wrong1),
    (   last(Lines, "done")
    ->  Wrong2 = [],
        Next is Until+1
    ;   last_case(Lines, First, Seed),
        Wrong2 = [wrong(Seed, ended(Status))],
        Next is Seed+1
    ),
    scripts(Next, Last, Threads, Folder, Wrong3),
    append([Wrong1, Wrong2, Wrong3], Wrong).

%   child(Range, Threads, Folder, Lines, Status): 500 scripts take some ten
%   seconds; after twenty minutes one of them has no end.

child([First,Last], Threads, Folder, Lines, Status) :-
    prolog(Program, Options),
    absolute_file_name(tests('rules/edit_child.pl'), Child, [access(read)]),
    absolute_file_name(foreign(sanggwan), Foreign,
                       [file_type(executable), access(read)]),
    file_directory_name(Foreign, Build),
    format(atom(Where), 'foreign=~w', [Build]),
    (   memberchk("--no-threads", Options)
    ->  Seconds = 0
    ;   Seconds = 120
    ),
    append(Options, ['-p',Where,Child,'--',First,Last,Seconds,Threads],
           Arguments),
    process_create(path(timeout),
                   ['-s','KILL',1200,Program|Arguments],
                   [ stdout(pipe(Out)), stderr(null), cwd(Folder),
                     environment(['EDIT_SCRATCH'=Folder]), process(Id) ]),
    call_cleanup(lines(Out, Lines), close(Out)),
    process_wait(Id, Status).

lines(Out, Lines) :-
    read_string(Out, _, Text),
    split_string(Text, "\n", "", Lines0),
    exclude(==(""), Lines0, Lines).

told(Lines, Seed, What) :-
    member(Line, Lines),
    string_concat("wrong ", Rest, Line),
    once(sub_string(Rest, Before, 1, _, " ")),
    sub_string(Rest, 0, Before, _, Number),
    number_string(Seed, Number),
    sub_string(Rest, Before, _, 0, What).

last_case(Lines, First, Seed) :-
    (   reverse(Lines, Reversed),
        member(Line, Reversed),
        string_concat("case ", Number, Line)
    ->  number_string(Seed, Number)
    ;   Seed = First
    ).

with_folder(Folder, Goal) :-
    tmp_file(edit, Folder),
    setup_call_cleanup(make_directory(Folder), Goal,
                       delete_directory_and_contents(Folder)).

%   run(Count, First, Threads, Wrong)

run(Count, First, Threads, Wrong) :-
    Last is First+Count-1,
    with_folder(Folder, once(scripts(First, Last, Threads, Folder, Wrong))).

known(Name/Arity) :-
    functor(Head, Name, Arity),
    predicate_property(sg_test_edit_question:Head, imported_from(_)).

%   calls(Count, PIs): what so many questions ask.

calls(Count, PIs) :-
    set_random(seed(20260731)),
    setenv('EDIT_SCRATCH', '/nowhere'),
    new_world(World),
    in_world(World,
             findall(Name/Arity,
                     ( between(1, Count, _),
                       asked(Goal),
                       functor(Goal, Name, Arity) ),
                     All)),
    sort(All, PIs).

:- begin_tests(edit_fuzz).

%   Every export of the facades is asked, but for two that say why not.

test(every_export_is_asked, Missing == [repl/0,use_rules/1]) :-
    calls(8000, Asked),
    findall(PI, ( offered(PI, _), \+ memberchk(PI, Asked) ), Missing0),
    sort(Missing0, Missing),
    forall(member(PI, Missing), unfit(PI)).
test(every_export_is_there, Missing == []) :-
    findall(PI, ( offered(PI, _), \+ known(PI) ), Missing).

test(scripts, Wrong == []) :-
    few(100, 400, Few),
    setting('EDIT_FUZZ', Few, Count),
    setting('EDIT_FUZZ_FROM', 1, First),
    run(Count, First, 1, Wrong),
    format("counted: ~d scripts of edits and questions~n", [Count]).
test(threads, [condition(current_prolog_flag(threads, true)), Wrong == []]) :-
    few(100, 400, Few),
    setting('EDIT_FUZZ', Few, Count),
    setting('EDIT_FUZZ_FROM', 1, First),
    Worlds is max(1, Count//10),
    run(Worlds, First, 3, Wrong),
    format("counted: ~d worlds edited by 3 threads~n", [Worlds]).

:- end_tests(edit_fuzz).
