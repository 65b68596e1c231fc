/* The program under tests/memory/failing_malloc.c, which counts what our library
   asks for. Not a test.
*/
:- module(sg_counted,
          [ sanggwan/2,     % +Arguments, -Status
            request_fails/2, % +N, +After
            requests/2,     % -Made, -Held
            requests_of/1   % +Library
          ]).

:- multifile user:file_search_path/2.

:- prolog_load_context(directory, Memory),
   file_directory_name(Memory, Tests),
   file_directory_name(Tests, Root),
   asserta(user:file_search_path(sanggwan, Root)),
   asserta(user:file_search_path(rules, sanggwan(rules))).

:- use_module(rules(command/cli), [sanggwan/2]).
:- use_module(user:rules(sanggwan)).
:- use_foreign_library(foreign('tests/failing_malloc')).
