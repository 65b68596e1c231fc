:- module(test_travel, []).
:- use_module(library(plunit)).
:- use_module(rules(drawing/travel)).
:- use_module(tests('oracle/travel')).

%   short_travel(Start, Strokes, Ordered), travel_length(Start, Strokes, Length)

short_travel(Start, Strokes, Ordered) :-
    travel(Start, short, Strokes, Travel),
    fold_travel(listed, Travel, Ordered, []),
    Travel = travel(_, Count, _, _, Way, Unsorted),
    assertion(length(Strokes, Count)),
    assertion(travel_length(Start, Ordered, Way)),
    assertion(travel_length(Start, Strokes, Unsorted)).

travel_length(Start, Strokes, Length) :-
    travel(Start, kept, Strokes, Travel),
    fold_travel(listed, Travel, Kept, []),
    assertion(Kept == Strokes),
    Travel = travel(_, _, _, _, Length, Length).

listed(Stroke, [Stroke|Strokes], Strokes).

line(E, A, B, stroke(visible,outline,1,[E],[A,B],joint,joint)).

random_strokes(Seed, N, Strokes) :-
    set_random(seed(Seed)),
    numlist(1, N, Es),
    maplist(random_line, Es, Strokes).

random_line(E, Stroke) :-
    maplist(random_between(0, 1000), [X,Y,DX,DY]),
    X1 is X+DX//20,
    Y1 is Y+DY//20,
    line(E, X-Y, X1-Y1, Stroke).

edges(Strokes, Edges) :-
    findall(E, ( member(stroke(_,_,_,Es,_,_,_), Strokes), member(E, Es) ),
            Edges0),
    msort(Edges0, Edges).

:- begin_tests(travel).

test(nothing, true(Ordered == [])) :-
    short_travel(0-0, [], Ordered).
test(backwards, true(Ordered ==
        [stroke(hidden,outline,1,[2,1],[0-0,5-0,9-0],joint,cut)])) :-
    short_travel(0-0, [stroke(hidden,outline,1,[1,2],[9-0,5-0,0-0],cut,joint)],
                 Ordered).
test(nearest, true(Edges == [2,3,1])) :-
    line(1, 90-0, 100-0, L1),
    line(2, 0-0, 10-0, L2),
    line(3, 50-0, 12-0, L3),
    short_travel(0-0, [L1,L2,L3], Ordered),
    findall(E, member(stroke(_,_,_,[E],_,_,_), Ordered), Edges).
test(kernel_is_rule, [forall(between(1, 60, Seed))]) :-
    N is Seed*3,
    random_strokes(Seed, N, Strokes),
    short_travel(0-0, Strokes, Kernel),
    short_travel_by_rule(0-0, Strokes, Rule),
    assertion(Seed-Kernel == Seed-Rule).
test(kernel_is_rule_on_a_grid, [forall(between(1, 60, Seed))]) :-
    set_random(seed(Seed)),
    findall(Line, ( between(1, 70, E),
                    maplist(random_between(0, 4), [X,Y,X1,Y1]),
                    line(E, X-Y, X1-Y1, Line) ), Strokes),
    short_travel(0-0, Strokes, Kernel),
    short_travel_by_rule(0-0, Strokes, Rule),
    assertion(Seed-Kernel == Seed-Rule).
test(length, true(Length =:= 30.0)) :-
    line(1, 3-4, 9-9, L1),
    line(2, 9-34, 0-0, L2),
    travel_length(0-0, [L1,L2], Length).
test(bad, [forall(member(Strokes-Error,
                         [ x-type_error(list, x), [x]-type_error(stroke, x),
                           [stroke(_,_,_,_,[],_,_)]-domain_error(stroke, _),
                           [stroke(_,_,_,_,[x],_,_)]-type_error(pair, x) ])),
           throws(error(Error, _))]) :-
    short_travel(0-0, Strokes, _).
%   The nearest end next may be the longer way: the order is then as it was.

test(never_longer, Longer == []) :-
    findall(Seed, ( between(1, 1000, Seed), longer(Seed) ), Longer).

longer(Seed) :-
    set_random(seed(Seed)),
    random_between(1, 9, N),
    random_between(1, 12, Wide),
    findall(Line, ( between(1, N, E),
                    maplist(random_between(0, Wide), [X,Y,X1,Y1]),
                    line(E, X-Y, X1-Y1, Line) ), Strokes),
    maplist(random_between(0, Wide), [X0,Y0]),
    short_travel(X0-Y0, Strokes, Ordered),
    short_travel_by_rule(X0-Y0, Strokes, Rule),
    travel_length(X0-Y0, Strokes, Before),
    travel_length(X0-Y0, Ordered, After),
    edges(Strokes, Edges),
    \+ ( Ordered == Rule,
         After =< Before,
         edges(Ordered, Edges) ).
test(all_and_shorter, [forall(between(1, 10, Seed)), true]) :-
    random_strokes(Seed, 600, Strokes),
    short_travel(0-0, Strokes, Ordered),
    edges(Strokes, Edges),
    edges(Ordered, Edges),
    travel_length(0-0, Strokes, Before),
    travel_length(0-0, Ordered, After),
    After < Before/5.

:- end_tests(travel).
