/* Runs the tests of the .plt files named after --, with the rules loaded.

       swipl -p foreign=build tests/plunit.pl -- tests/rules/store.plt

   The last line counts them, for tests/run. Warnings are failures: run with
   --on-warning=status --on-error=status. With FIRST=1 in the environment the
   first failure is the end (tools/mutants).
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

:- multifile user:message_hook/3.
:- dynamic user:message_hook/3.

user:message_hook(plunit(Failure), error, _) :-
    compound(Failure),
    compound_name_arity(Failure, Name, _),
    memberchk(Name, [failed,failed_assertion,error]),
    getenv('FIRST', '1'),
    print_message_lines(user_error, 'first: ', ['~q'-[Failure], nl]),
    halt(1).

% Which keys there are depends on the release of Prolog.
counted(Keys, Summary, N) :-
    aggregate_all(sum(Value),
                  ( member(Key, Keys),
                    get_dict(Key, Summary, Value) ),
                  N).
