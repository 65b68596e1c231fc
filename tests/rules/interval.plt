/* Sets of intervals, one by one, and against sets of cells of a grid. */
:- module(test_interval, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(yall)).
:- use_module(rules(interval)).

%   Intervals on a grid of 16: a set is the list of its cells, 0 or 1 each.

random_intervals(Intervals) :-
    random_between(0, 4, N),
    findall(From-To,
            ( between(1, N, _),
              random_between(0, 15, A),
              A1 is A+1,
              random_between(A1, 16, B),
              From is A/16.0,
              To is B/16.0 ),
            Intervals0),
    sort(Intervals0, Intervals).

a_random_interval(One) :-
    repeat,
    random_intervals([One|_]),
    !.

cells(Intervals, Cells) :-
    findall(In,
            ( between(0, 15, I),
              Middle is (I+0.5)/16.0,
              (   member(From-To, Intervals),
                  From < Middle,
                  Middle < To
              ->  In = 1
              ;   In = 0
              ) ),
            Cells).

%   disjoint(Cells, Intervals), and turned(Value, Most, Cells0, Cells): runs of
%   Value that are no longer than Most are of the other value.

disjoint(Cells, Intervals) :-
    runs(Cells, 0, Runs),
    findall(From-To,
            ( member(run(1,A,B), Runs), From is A/16.0, To is B/16.0 ),
            Intervals).

runs([], _, []).
runs([Value|Cells], At, [run(Value,At,End)|Runs]) :-
    same(Cells, Value, At, End0, Rest),
    End is End0+1,
    runs(Rest, End, Runs).

same([Value|Cells], Value, At, End, Rest) :-
    !,
    At1 is At+1,
    same(Cells, Value, At1, End, Rest).
same(Rest, _, At, At, Rest).

turned(Value, Most, Cells0, Cells) :-
    runs(Cells0, 0, Runs),
    findall(Cell,
            ( member(run(V,A,B), Runs),
              (   V == Value,
                  B-A =< Most
              ->  Cell is 1-V
              ;   Cell = V
              ),
              Length is B-A,
              between(1, Length, _) ),
            Cells).

combined(union(Most), Intervals, _, Found, Wanted) :-
    Least is Most/16.0,
    intervals_union(Least, Intervals, Found),
    cells(Intervals, Cells0),
    (   Intervals == []
    ->  Wanted = []
    ;   turned(0, Most, Cells0, Cells1),
        turned(1, Most, Cells1, Cells),
        disjoint(Cells, Wanted)
    ).
combined(gaps, Intervals, _, Found, Wanted) :-
    cells(Intervals, Cells),
    disjoint(Cells, Set),
    intervals_gaps(Set, Found),
    maplist([C,D]>>( D is 1-C ), Cells, Others),
    disjoint(Others, Wanted).
combined(Way, Intervals, From-To, Found, Wanted) :-
    memberchk(Way, [subtract,within]),
    cells(Intervals, Cells),
    cells([From-To], Own),
    disjoint(Cells, Set),
    (   Way == subtract
    ->  intervals_subtract(Set, From-To, Found),
        maplist([C,D,E]>>( E is C*(1-D) ), Cells, Own, Left)
    ;   intervals_within(Set, From, To, Found),
        maplist([C,D,E]>>( E is C*D ), Cells, Own, Left)
    ),
    disjoint(Left, Wanted).

:- begin_tests(interval).

test(as_cells, [ forall(member(Way, [ union(0), union(1), union(2), union(5),
                                      gaps, subtract, within ])),
                 true(Wrong == []) ]) :-
    set_random(seed(5)),
    findall(Intervals-One-Found-Wanted,
            ( between(1, 400, _),
              random_intervals(Intervals),
              a_random_interval(One),
              combined(Way, Intervals, One, Found, Wanted),
              Found \== Wanted ),
            Wrong).


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
