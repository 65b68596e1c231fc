/* Runs the tests of the .plt files named after --, with the rules loaded.

       swipl -p foreign=build tests/plunit.pl -- tests/rules/store.plt

   The last line counts them, for tests/run. Warnings are failures: run with
   --on-warning=status --on-error=status.
*/
:- module(sg_plunit, []).
:- use_module(library(plunit)).

:- multifile user:file_search_path/2.

:- prolog_load_context(directory, Tests),
   file_directory_name(Tests, Root),
   asserta(user:file_search_path(sanggwan, Root)),
   asserta(user:file_search_path(rules, sanggwan(rules))),
   asserta(user:file_search_path(tests, sanggwan(tests))).

:- if(absolute_file_name(rules(sanggwan), _,
                         [file_type(prolog), access(read), file_errors(fail)])).
:- use_module(user:rules(sanggwan)).
:- endif.

:- initialization(main, main).

main :-
    current_prolog_flag(argv, Files),
    forall(member(File, Files), load_files(user:File, [])),
    (   run_tests
    ->  Status = 0
    ;   Status = 1
    ),
    plunit:test_summary(_, Summary),
    _{passed:Passed, failed:Failed, failed_assertions:Asserted} :< Summary,
    Bad is max(Failed, Asserted),
    format("~d passed, ~d failed~n", [Passed, Bad]),
    (   Status + Bad =:= 0
    ->  halt
    ;   halt(1)
    ).
