/* The program under tests/memory/failing_malloc.c, which counts what our library
   asks for. Not a test.
*/
:- module(sg_counted,
          [ sanggwan/2,     % +Arguments, -Status
            request_fails/2, % +N, +After
            stops/1,        % +N
            look_for/1,     % +What
            new_places/1,   % -Numbers
            requests/2,     % -Made, -Held
            requests_of/1   % +Library
          ]).

:- use_module('../load_rules', []).
:- use_module(rules(command/cli), [sanggwan/2]).
:- use_foreign_library(foreign('tests/failing_malloc')).
