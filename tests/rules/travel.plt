:- module(test_travel, []).
:- use_module(library(plunit)).
:- use_module(rules(travel)).

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

% The pen's way in the air.
travelled([], _, 0.0).
travelled([stroke(_,_,_,_,[X-Y|Points],_,_)|Strokes], X0-Y0, Way) :-
    last(Points, End),
    travelled(Strokes, End, Way0),
    Way is Way0 + sqrt((X-X0)**2 + (Y-Y0)**2).

edges(Strokes, Edges) :-
    findall(E, ( member(stroke(_,_,_,Es,_,_,_), Strokes), member(E, Es) ),
            Edges0),
    msort(Edges0, Edges).

:- begin_tests(travel).

test(nothing, true(Ordered == [])) :-
    short_travel([], Ordered).
test(backwards, true(Ordered ==
        [stroke(hidden,outline,1,[2,1],[0-0,5-0,9-0],joint,cut)])) :-
    short_travel([stroke(hidden,outline,1,[1,2],[9-0,5-0,0-0],cut,joint)],
                 Ordered).
test(nearest, true(Edges == [2,3,1])) :-
    line(1, 90-0, 100-0, L1),
    line(2, 0-0, 10-0, L2),
    line(3, 50-0, 12-0, L3),
    short_travel([L1,L2,L3], Ordered),
    findall(E, member(stroke(_,_,_,[E],_,_,_), Ordered), Edges).
test(all_and_shorter, [forall(between(1, 10, Seed)), true]) :-
    random_strokes(Seed, 600, Strokes),
    short_travel(Strokes, Ordered),
    edges(Strokes, Edges),
    edges(Ordered, Edges),
    travelled(Strokes, 0-0, Before),
    travelled(Ordered, 0-0, After),
    After < Before/5.

:- end_tests(travel).
