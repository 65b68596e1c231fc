:- module(test_pattern_want, []).
:- use_module(library(plunit)).
:- use_module(rules(store)).
:- use_module(rules(development/development), [develop/2]).
:- use_module(rules(pattern/pattern_drawing)).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).

/* What is written on pieces, and how much of it finds room. */

:- dynamic left_out/2.

%   left_out(Term, Options, N): so many partner numbers have no room.

left_out(Term, Options, N) :-
    new_world(World),
    retractall(left_out(_, _)),
    setup_call_cleanup(
        asserta((user:message_hook(sanggwan(pattern(What)), _, _) :-
                     (   What = no_room(Role, Count)
                     ->  assertz(test_pattern_want:left_out(Role, Count))
                     ;   true
                     )), Ref),
        in_world(World, ( add_primitive(Term, S), develop(S, D),
                          pattern_drawing([D], Options, _) )),
        erase(Ref)),
    (   left_out(number, N)
    ->  true
    ;   N = 0
    ).

:- begin_tests(pattern_want).

% Short seams choose first, and letters may be 1.3 mm; it were 60 before.
test(ball, true(N =< 30)) :-
    left_out(sphere(radius(30), facets(24)), [tabs(5),page('A4')], N).
test(large, N == 0) :-
    left_out(sphere(radius(60), facets(12)), [tabs(5),page('A3')], N).
test(tiny, true(N >= 20)) :-
    left_out(sphere(radius(5), facets(12)), [], N).

:- end_tests(pattern_want).
