/* How large stacks may become: rules/space_limit.pl. */
:- module(test_space_limit, []).
:- use_module(library(plunit)).
:- use_module(library(lists), [last/2, numlist/3]).
:- use_module(rules(space_limit)).

:- begin_tests(space_limit).

limit(Octets) :-
    current_prolog_flag(stack_limit, Octets).

held :-
    numlist(1, 10000000, Ns),
    last(Ns, _),
    Ns = [_|_].

test(within, Inner-After == 50000000-Before) :-
    limit(Before),
    with_stack_limit(50000000, limit(Inner)),
    limit(After).
test(after_failure, After == Before) :-
    limit(Before),
    \+ with_stack_limit(50000000, fail),
    limit(After).
test(too_much, error(resource_error(_))) :-
    with_stack_limit(20000000, held).
test(grows, Inner =:= 10*Before) :-
    limit(Before),
    with_stack_for(10, Before, limit(Inner)).
test(never_less, Inner == Before) :-
    limit(Before),
    with_stack_for(3, 1000, limit(Inner)).

:- end_tests(space_limit).
