:- encoding(utf8).
:- module(test_terminal, []).
% covers: dot_drawing
:- use_module(library(plunit)).
:- use_module(rules(store)).
:- use_module(rules(drawing/terminal)).

% A world with a wire: a V seen from the front.
in_wire(Goal) :-
    new_world(World),
    in_world(World, ( wire, Goal )).

wire :-
    assert_fact(segment(1, curve, wire)),
    forall(member(V-X-Z, [1-0.0-1.0, 2-1.0-0.0, 3-2.0-1.0]),
           assert_fact(v(1, V, X, 0.0, Z))),
    assert_fact(e(1, 1, 1, 2, 1)),
    assert_fact(e(1, 2, 2, 3, 1)),
    assert_fact(view(270.0, 90.0, 10.0)),
    assert_fact(projection(parallel)).

shown(Options, Lines) :-
    in_wire(with_output_to(string(Text), show(Options))),
    split_string(Text, "\n", "", Lines).

:- begin_tests(terminal).

test(braille, true(Lines == ["⠠⡀ ⡠", " ⠈⠊", ""])) :-
    shown([width(4),height(2),ascii(false)], Lines).
test(ascii, true(Lines == [ " -.           .-",
                            "  '-.       .'",
                            "    '-.   .'",
                            "      '-.'",
                            "" ])) :-
    shown([width(16),height(4),ascii(true)], Lines).
test(fits, true((Widest =< 40, Height =< 13))) :-
    shown([width(40),height(12),ascii(true)], Lines),
    length(Lines, Height),
    aggregate_all(max(N), ( member(L, Lines), string_length(L, N) ), Widest).
test(no_terminal) :-
    shown([], [_,_|_]).
test(nothing, true(Text == "")) :-
    new_world(World),
    in_world(World, with_output_to(string(Text), show)).

:- end_tests(terminal).
