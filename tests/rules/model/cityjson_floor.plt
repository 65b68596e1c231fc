/* Floors of what is open: rings by hand. */
:- module(test_cityjson_floor, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(model/cityjson_floor)).

%   walls(Corners, Way, Low, Faces, Points): walls round Corners, [X,Y], a floor
%   high, looking out (Way 1) or in; indices of points from Low on.

walls(Corners, Way, Low, Faces, Points) :-
    length(Corners, N),
    findall([[A,B,C,D]],
            ( nth0(I, Corners, _),
              J is (I+1) mod N,
              wall(Way, N, Low, I, J, [A,B,C,D]) ),
            Faces),
    findall(p(X,Y,Z), ( member(Z, [0.0,3.0]), member([X,Y], Corners) ),
            Points).

wall(1, N, Low, I, J, [A,B,C,D]) :-
    A is Low+I,
    B is Low+J,
    C is B+N,
    D is A+N.
wall(-1, N, Low, I, J, [D,C,B,A]) :-
    wall(1, N, Low, I, J, [A,B,C,D]).

square(Size, [X,Y], [[X,Y],[X1,Y],[X1,Y1],[X,Y1]]) :-
    X1 is X+Size,
    Y1 is Y+Size.

added(Points, Faces0, New) :-
    compound_name_arguments(Vertices, vertices, Points),
    floors_added(Vertices, Faces0, Faces),
    append(Faces0, New, Faces).

:- begin_tests(cityjson_floor).

%   Walls of a square: a floor and a roof, each against the walls.

test(walls, Floors == [[0,3,2,1],[4,5,6,7]]) :-
    square(4.0, [0.0,0.0], Square),
    walls(Square, 1, 0, Faces, Points),
    added(Points, Faces, Floors0),
    findall(Ring, ( member([Ring0], Floors0), from_least(Ring0, Ring) ),
            Floors1),
    sort(Floors1, Floors).

from_least(Ring0, Ring) :-
    min_list(Ring0, Least),
    append(Before, [Least|After], Ring0),
    append([Least|After], Before, Ring).

%   A courtyard is a hole, and so is one seen along another axis; a house in a
%   courtyard has floors of its own.

test(courtyard, [ forall(member(Turn, [xyz,yzx,zxy])), Rings == [2,2] ]) :-
    square(9.0, [0.0,0.0], Outer),
    square(3.0, [2.0,2.0], Inner),
    walls(Outer, 1, 0, Faces1, Points1),
    walls(Inner, -1, 8, Faces2, Points2),
    append(Faces1, Faces2, Faces),
    append(Points1, Points2, Points0),
    maplist(turned(Turn), Points0, Points),
    added(Points, Faces, Floors),
    maplist(length, Floors, Rings).
test(house_in_courtyard, Rings == [1,1,2,2]) :-
    foldl(ring_of_walls, [9.0-1,5.0-(-1),1.0-1], []-[], Faces-Points),
    added(Points, Faces, Floors),
    maplist(length, Floors, Rings0),
    msort(Rings0, Rings).

ring_of_walls(Size-Way, Faces0-Points0, Faces-Points) :-
    Low0 is (10.0-Size)/2,
    square(Size, [Low0,Low0], Corners),
    length(Points0, Low),
    walls(Corners, Way, Low, Faces1, Points1),
    append(Faces0, Faces1, Faces),
    append(Points0, Points1, Points).

turned(xyz, P, P).
turned(yzx, p(X,Y,Z), p(Y,Z,X)).
turned(zxy, p(X,Y,Z), p(Z,X,Y)).

%   A border that is not flat, one that does not close, and none.

test(bent, fail) :-
    square(4.0, [0.0,0.0], Square),
    walls(Square, 1, 0, Faces, [p(X,Y,_)|Points]),
    added([p(X,Y,-0.5)|Points], Faces, _).
test(nothing_open, fail) :-
    added([p(0.0,0.0,0.0),p(1.0,0.0,0.0),p(0.0,1.0,0.0),p(0.0,0.0,1.0)],
          [[[0,2,1]],[[0,1,3]],[[1,2,3]],[[2,0,3]]], _).

:- end_tests(cityjson_floor).
