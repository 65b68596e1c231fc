:- module(test_ask_hidden, []).
:- use_module(library(plunit)).
:- use_module(rules(sanggwan)).
:- use_module(rules('studio/ask_hidden')).
:- use_module(rules('studio/answer_name'), [shown_names/2]).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

/* Two cubes, one behind the other, and one beside them. */

:- begin_tests(ask_hidden).

cubes :-
    add_primitive(at([translate(0, 0, 0)], box(size(1, 1, 1))), 1),
    add_primitive(at([translate(0, 3, 0)], box(size(1, 1, 1))), 2),
    add_primitive(at([translate(5, 0, 0)], box(size(1, 1, 1))), 3),
    complete_segments,
    penetrate.

seen(Theta, Pairs) :-
    in_new_world(( cubes,
                   set_view(Theta, 82, 0),
                   picture,
                   findall(A-B, hides(A, B), Pairs) )).

test(front, Pairs == [1-1,1-2,2-2,3-3]) :-
    seen(266, Pairs).
test(back, Pairs == [1-1,2-1,2-2,3-3]) :-
    seen(94, Pairs).
test(side, Pairs == [1-1,2-2,3-1,3-3]) :-
    seen(4, Pairs).
test(lines, Names == Hidden) :-
    in_new_world(( cubes,
                   set_view(30, 60, 0),
                   picture,
                   findall(E, drawn(_, 2, E, _, _, hidden, _), Es0),
                   sort(Es0, Es),
                   findall(Name, ( member(E, Es),
                                   format(string(Name), "s2e~d", [E]) ),
                           Hidden0),
                   sort(Hidden0, Hidden),
                   findall(Name, ( hides(S, 2),
                                   shown_names(hides(S, 2), Ns),
                                   member(Name, Ns) ),
                           Names0),
                   sort(Names0, Names) )).
test(of_the_picture) :-
    asks_of_picture((segment(S, _, _), \+ hides(S, _))).
test(not_of_the_picture, fail) :-
    asks_of_picture((segment(S, _, _), line(_, S, _, _, _, _, _, _, _))).

:- end_tests(ask_hidden).
