:- module(test_process_state, []).
:- use_module(library(plunit)).
:- use_module(rules(command/cli), []).
:- use_module(rules(formula), []).
:- use_module(rules(model/item_where), []).
:- use_module(rules(primitive/primitive), []).
:- use_module(rules(primitive/shape), []).
:- use_module(rules(studio/process_state), []).

/* The caches that may change while code of users runs are those of the program.
What else a process has afterwards is tested through a session (serve.py).
*/

:- begin_tests(process_state).

listed(Module:Name/Arity) :-
    sg_process_state:cache(Module:PI),
    nonvar(PI),
    PI = Name/Arity.

test(caches, [forall(listed(Module:Name/Arity))]) :-
    functor(Head, Name, Arity),
    predicate_property(Module:Head, dynamic).

:- end_tests(process_state).
