/* Runs the tests of the .plt files named after --, with the rules loaded.

       swipl -p foreign=build tests/plunit.pl -- tests/rules/store.plt

   The last line counts them, for tests/run. Warnings are failures: run with
   --on-warning=status --on-error=status.
*/
:- module(sg_plunit, []).
:- use_module(library(plunit)).
:- use_module(load_rules, []).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, Files),
    all_is_shown,
    forall(member(File, Files), load_files(user:File, [])),
    all_ran(Status, Summary),
    counted([passed], Summary, Passed),
    counted([failed,failed_assertions,timeout], Summary, Failed),
    format("~d passed, ~d failed~n", [Passed, Failed]),
    (   Status + Failed =:= 0
    ->  halt
    ;   halt(1)
    ).

% What a test prints is for its log. An older plunit never holds it back and
% knows no such option.
all_is_shown :-
    catch(set_test_options([output(always),format(log)]), error(_, _), true).

% A newer plunit forgets its summary, but gives it to who asks with the tests.
all_ran(0, Summary) :-
    current_predicate(plunit:run_tests/2),
    !,
    plunit:run_tests(all, [summary(Summary)]).
all_ran(Status, Summary) :-
    (   run_tests
    ->  Status = 0
    ;   Status = 1
    ),
    plunit:test_summary(_, Summary).

% Which keys there are depends on the release of Prolog.
counted(Keys, Summary, N) :-
    aggregate_all(sum(Value),
                  ( member(Key, Keys),
                    get_dict(Key, Summary, Value) ),
                  N).
