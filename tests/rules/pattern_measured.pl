:- module(test_pattern_measured, [pattern_measured/2]).
:- use_module(rules(command/unfold_report), [pattern_measures/3]).
:- use_module(rules(kernel), [census/1]).
/** <module> The measures of one pattern, for tests.
*/

%!  pattern_measured(+D, -Measures) is det.
%
%   Measures are what unfold_measures/3 says of pattern D.

pattern_measured(D, Measures) :-
    census(Parts),
    pattern_measures(Parts, D, Measures).
