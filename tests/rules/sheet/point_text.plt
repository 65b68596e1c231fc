/* Numbers beside points: none on another, none on a line if there is room. */
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(sheet/lettering)).
:- use_module(rules(sheet/point_text)).

:- begin_tests(point_text).

%   box(Text, Box): what the letters of Text take.

box(text(X,Y,Height,middle,String), box(Left,Top,Right,Y)) :-
    lettering_width(String, Height, Width),
    Left is X-Width/2,
    Right is X+Width/2,
    Top is Y-Height.

overlap(box(L1,T1,R1,B1), box(L2,T2,R2,B2)) :-
    L1 < R2,
    L2 < R1,
    T1 < B2,
    T2 < B1.

placed_boxes(Placed, Boxes) :-
    findall(Box, ( member(placed(Text,_), Placed), box(Text, Box) ), Boxes).

overlaps(Boxes, Pairs) :-
    findall(A-B,
            ( append(_, [A|More], Boxes), member(B, More), overlap(A, B) ),
            Pairs).

%   crowd(Name, Points): points much nearer to each other than numbers are wide.

crowd(row, Points) :-
    findall(point(front,X-50000,String),
            ( between(1, 20, I), X is 50000+400*I, number_string(I, String) ),
            Points).
crowd(ring, Points) :-
    findall(point(top,X-Y,String),
            ( between(1, 24, I),
              T is I*pi/12,
              X is 60000 + round(2500*cos(T)),
              Y is 60000 + round(1500*sin(T)),
              format(string(String), "~d,~d", [I,I]) ),
            Points).
crowd(block, Points) :-
    findall(point(front,X-Y,String),
            ( between(1, 6, I),
              between(1, 6, J),
              X is 70000+700*I,
              Y is 70000+700*J,
              N is 6*I+J,
              number_string(N, String) ),
            Points).

test(none_on_another, [forall(crowd(_, Points)), Pairs == []]) :-
    point_texts([], [], Points, Placed),
    length(Points, N),
    length(Placed, N),
    placed_boxes(Placed, Boxes),
    overlaps(Boxes, Pairs).

test(none_on_a_point, [forall(crowd(_, Points)), Hit == []]) :-
    point_texts([], [], Points, Placed),
    placed_boxes(Placed, Boxes),
    findall(P,
            ( member(point(_,P,_), Points),
              P = X-Y,
              member(Box, Boxes),
              overlap(box(X,Y,X,Y), Box) ),
            Hit).

%   A number that is not beside its point has a line to it.
test(line, [forall(crowd(_, Points)), Lost == []]) :-
    point_texts([], [], Points, Placed),
    findall(P,
            ( nth1(I, Points, point(_,P,_)),
              nth1(I, Placed, placed(Text,[])),
              box(Text, box(Left,Top,Right,Bottom)),
              P = X-Y,
              Off is max(max(Left-X, X-Right), max(Top-Y, Y-Bottom)),
              Off > 2500 ),
            Lost),
    once(( member(placed(_,Line), Placed), Line = [_,_] )).

%   A line through the point: the number stands on either side of it, of a light
%   one, too.
test(lines, [forall(member(Drawn-Lights, [[Line]-[],[]-[Line]])), Hit == []]) :-
    Line = [20000.0-50000.0,90000.0-50000.0],
    point_texts(Drawn, Lights, [point(front,50000-50000,"12")], [placed(T,[])]),
    box(T, Box),
    findall(x, overlap(Box, box(20000,50000,90000,50000)), Hit).

%   On a page full of lines a number is still beside its point.
test(over_light_lines) :-
    findall([0.0-Y,200000.0-Y], ( between(0, 500, I), Y is 400.0*I ), Lights),
    point_texts([], Lights, [point(front,50000-50000,"12")], [placed(_,[])]).
test(over_lines) :-
    findall([0.0-Y,200000.0-Y], ( between(0, 500, I), Y is 400.0*I ), Drawn),
    point_texts(Drawn, [], [point(front,50000-50000,"12")],
                [placed(text(_,_,2000,middle,"12"),_)]).

%   The number is away from a neighbour.
test(away, true(X < 50000)) :-
    point_texts([], [], [ point(front,50000-50000,"1"),
                          point(front,51000-50000,"2") ],
                [placed(text(X,_,_,_,_),[])|_]).

%   Points of another view do not matter.
test(views, Placed1 == Placed2) :-
    point_texts([], [], [point(front,50000-50000,"1")], [Placed1]),
    point_texts([], [], [ point(front,50000-50000,"1"),
                          point(top,50000-90000,"1") ], [Placed2,_]).

:- end_tests(point_text).
