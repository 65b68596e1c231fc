:- use_module(rules(interval)).

:- begin_tests(interval).

test(union_empty, X == [])               :- intervals_union(0.01, [], X).
test(union_one, X == [0.2-0.5]) :-
    intervals_union(0.01, [0.2-0.5], X).
test(union_two, X == [0.2-0.7]) :-
    intervals_union(0.01, [0.2-0.5,0.4-0.7], X).
test(union_inside, X == [0.2-0.8]) :-
    intervals_union(0.01, [0.2-0.8,0.4-0.7], X).
test(union_apart, X == [0.2-0.3,0.4-0.7]) :-
    intervals_union(0.01, [0.2-0.3,0.4-0.7], X).
test(union_gap, X == [0.2-0.7]) :-
    intervals_union(0.01, [0.2-0.3,0.305-0.7], X).
test(union_to_ends, X == [0.0-1.0]) :-
    intervals_union(0.01, [0.005-0.3,0.3-0.995], X).
test(union_short, X == []) :-
    intervals_union(0.01, [0.5-0.505], X).

test(gaps_none, X == [0.0-1.0])          :- intervals_gaps([], X).
test(gaps_all, X == [])                  :- intervals_gaps([0.0-1.0], X).
test(gaps, X == [0.0-0.2,0.5-1.0])       :- intervals_gaps([0.2-0.5], X).
test(gaps_between, X == [0.3-0.6]) :-
    intervals_gaps([0.0-0.3,0.6-1.0], X).

test(subtract_middle, X == [0.0-0.3,0.6-1.0]) :-
    intervals_subtract([0.0-1.0], 0.3-0.6, X).
test(subtract_beside, X == [0.0-0.3]) :-
    intervals_subtract([0.0-0.3], 0.3-0.6, X).
test(subtract_all, X == []) :-
    intervals_subtract([0.1-0.2,0.3-0.4], 0.0-1.0, X).
test(subtract_ends, X == [0.1-0.15,0.35-0.4]) :-
    intervals_subtract([0.1-0.2,0.3-0.4], 0.15-0.35, X).

test(within, X == [0.2-0.3,0.5-0.6]) :-
    intervals_within([0.1-0.3,0.5-0.9], 0.2, 0.6, X).
test(within_none, X == []) :-
    intervals_within([0.1-0.3], 0.3, 0.6, X).

:- end_tests(interval).
