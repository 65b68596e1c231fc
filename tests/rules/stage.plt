:- module(test_stage, []).
:- use_module(library(plunit)).
:- use_module(library(lists), [member/2]).
:- use_module(library(readutil), [read_file_to_string/3]).
:- use_module(rules(stage)).

near(Name, Seconds) :-
    stage_seconds(Name, S),
    S >= Seconds-0.001,
    S < Seconds+0.15.

:- begin_tests(stage, [setup(stages_reset)]).

test(inner_time_is_not_outer) :-
    stages_reset,
    stage(rules, ( sleep(0.05), stage(join, sleep(0.1)),
                   stage(join, sleep(0.1)) )),
    near(rules, 0.05),
    near(join, 0.2).
test(once, X == 1) :-
    stage(a, member(X, [1,2])).
test(fails, fail) :-
    stage(a, fail).
test(raises, throws(ball)) :-
    stage(a, throw(ball)).
test(counted_when_it_raises) :-
    stages_reset,
    catch(stage(a, ( sleep(0.05), throw(ball) )), ball, true),
    near(a, 0.05).
test(current, S == inner) :-
    stage(outer, stage(inner, current_stage(S))).
test(back_outside, S == outer) :-
    stage(outer, ( stage(inner, true), current_stage(S) )).
test(none_open, fail) :-
    current_stage(_).
test(none_open_after_error, fail) :-
    catch(stage(a, throw(ball)), ball, true),
    current_stage(_).

test(all_are_printed, Unknown == []) :-
    expand_file_name('rules/*/*.pl', Files),
    findall(Name,
            ( member(File, Files),
              read_file_to_string(File, Text, [encoding(utf8)]),
              sub_string(Text, Before, _, _, "stage("),
              Start is Before+6,
              sub_string(Text, Start, 20, _, Rest),
              split_string(Rest, ",", "", [Word,_|_]),
              atom_string(Name, Word),
              \+ stage_name(Name)
            ),
            Unknown).

:- end_tests(stage).

