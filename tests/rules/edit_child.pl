/* Runs edit scripts FIRST .. LAST, one line of standard output before each and
   one for what was wrong in it; edit_fuzz.plt reads them.

       swipl -p foreign=build tests/rules/edit_child.pl -- \
         FIRST LAST SECONDS THREADS

   SECONDS: the time of a script, 0 for no limit (a Prolog without threads).
   THREADS: how many edit its world at once.
*/
:- module(sg_test_edit_child, []).

:- use_module('../load_rules', []).
:- use_module(tests('rules/edit_script')).
:- use_module(library(lists)).
:- use_module(library(time)).

:- multifile user:message_hook/3.

user:message_hook(_, Kind, _) :-
    Kind \== error,
    \+ getenv('EDIT_SAY', _).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, Argv),
    maplist(atom_number, Argv, [First,Last,Seconds,Threads]),
    stream_property(Out, alias(user_output)),
    open_null_stream(Null),
    set_output(Null),
    forall(between(First, Last, Seed),
           ( format(Out, 'case ~d~n', [Seed]),
             flush_output(Out),
             run(Seconds, Threads, Seed, Wrong),
             forall(member(W, Wrong),
                    format(Out, 'wrong ~d ~W~n',
                           [Seed, W, [quoted(true),max_depth(12)]])) )),
    format(Out, 'done~n', []),
    flush_output(Out).

run(Seconds, Threads, Seed, Wrong) :-
    (   Seconds > 0
    ->  catch(call_with_time_limit(Seconds, script(Threads, Seed, Wrong)),
              time_limit_exceeded, Wrong = [no_end])
    ;   script(Threads, Seed, Wrong)
    ).
