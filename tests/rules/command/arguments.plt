:- module(test_arguments, []).
% covers: decimal
:- use_module(library(plunit)).
:- use_module(rules(command/arguments)).

specs([ option(output, o, each, 'FILE', ''),
        option(quiet, q, flag, '', ''),
        option(view, v, value, 'VIEW', ''),
        option(hidden, '', one_of([dashed, removed]), 'HOW', ''),
        option(limit, '', number(1), 'N', ''),
        option(part, '', number(0,1), 'F', ''),
        option(chord, '', above(0), 'T', ''),
        option(count, '', whole(2,9), 'N', '')
      ]).

parsed(Text, Files, Options) :-
    specs(Specs),
    split_string(Text, " ", "", Strings),
    maplist([S, A]>>atom_string(A, S), Strings, Arguments),
    parsed_arguments(Specs, Arguments, Files, Options).

refused(Text, What) :-
    catch(parsed(Text, _, _), error(usage_error(What0), _), true),
    What == What0.

:- begin_tests(arguments).

test(files, F-O == [a, b]-[]) :- parsed("a b", F, O).
test(after_files, F-O == [a, b]-[quiet(true)]) :- parsed("a -q b", F, O).
test(equals, O == [view('1,2')]) :- parsed("--view=1,2", _, O).
test(next, O == [view('-1,2')]) :- parsed("--view -1,2", _, O).
test(attached, O == [view('1,2')]) :- parsed("-v1,2", _, O).
test(together, O == [quiet(true), output([x])]) :- parsed("-qo x", _, O).
test(repeated, O == [output([x, -, z])]) :-
    parsed("-o x -o - --output=z", _, O).
test(negative, O == [quiet(false)]) :- parsed("--no-quiet", _, O).
test(dash_is_a_file, F == [-]) :- parsed("-", F, _).
test(end, F-O == ['-q', '--view']-[]) :- parsed("-- -q --view", F, O).
test(number, O == [limit(3)]) :- parsed("--limit 3", _, O).
test(empty_value, O == [view('')]) :- parsed("--view=", _, O).

test(unknown) :- refused("--colour", unknown_option('--colour', [])).
test(unknown_short) :- refused("-x", unknown_option('-x', [])).
test(meant) :- refused("--limt 3", unknown_option('--limt', ['--limit'])).
test(meant_no) :-
    refused("--no-quite", unknown_option('--no-quite', ['--no-quiet'])).
test(needs) :- refused("a --view", needs_value('--view', 'VIEW')).
test(needs_not_option) :-
    refused("--view --quiet", needs_value('--view', 'VIEW')).
test(needs_not_letter) :- refused("-v -q", needs_value('-v', 'VIEW')).
test(no_value) :- refused("--quiet=1", no_value('--quiet')).
test(no_negative_of_values) :-
    refused("--no-view", unknown_option('--no-view', [])).
test(twice) :- refused("-v 1 --view 2", option_twice('--view')).
test(word) :-
    refused("--hidden x", bad_value('--hidden', x, one_of([dashed, removed]))).
test(low) :- refused("--limit 0", bad_value('--limit', '0', number(1))).
test(no_number) :- refused("--limit x", bad_value('--limit', x, number(1))).
test(within, O == [part(1)]) :- parsed("--part 1", _, O).
test(high) :- refused("--part 1.1", bad_value('--part', '1.1', number(0,1))).
test(above, O == [chord(1.0e-9)]) :- parsed("--chord 1e-9", _, O).
test(not_above) :- refused("--chord 0", bad_value('--chord', '0', above(0))).
test(whole, O == [count(9)]) :- parsed("--count 9.0", _, O).
test(not_whole) :-
    refused("--count 2.5", bad_value('--count', '2.5', whole(2,9))).
test(too_many) :-
    refused("--count 1e300", bad_value('--count', '1e300', whole(2,9))).

:- end_tests(arguments).
