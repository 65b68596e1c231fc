:- module(test_bisection, []).
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(rules(bisection)).

/* The largest number of which something holds. */

:- begin_tests(bisection).

test(no_step, Largest == 3) :-
    bisection(0, >(5), 3, 9, Largest).
test(within_the_last_step, true((Largest =< 5.0, Largest > 5.0-6.0/2**20))) :-
    bisection(20, >=(5.0), 3.0, 9.0, Largest).
test(asked_once_a_step, Asked-Largest == [6.0,4.5,5.25]-4.5) :-
    nb_setval(asked, []),
    bisection(3, asked_below(5.0), 3.0, 9.0, Largest),
    nb_getval(asked, Asked0),
    reverse(Asked0, Asked).

:- end_tests(bisection).

asked_below(Most, N) :-
    nb_getval(asked, Asked),
    nb_setval(asked, [N|Asked]),
    N =< Most.
