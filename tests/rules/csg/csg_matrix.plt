/* The matrices of placings, and what they do to the grain of a segment. */
:- module(test_csg_matrix, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(solid/csg_half_space)).
:- use_module(rules(csg/csg_matrix)).
:- use_module(rules(primitive/placing), [step_motion/2, moved/3]).
:- use_module(rules(store)).
:- use_module(tests('rules/polyhedron'), [box_points/3, box_faces/1]).
:- use_module(tests('rules/random_solid'), [random_rotation/1]).
:- use_module(tests('rules/csg/csg_tree'), [near/2, with_tree/2]).

:- begin_tests(csg_matrix).

%   steps(Steps): each kind of step.

steps([translate(1,2,3)]).
steps([rotate(x,30), rotate(y,40), rotate(z,50)]).
steps([scale(2), scale(1,-1,3), mirror(y)]).
steps([rotate(axis(1,2,3),77), translate(1,0,0), rotate(z,90)]).
steps([rotate(from(1,2,3),to(4,4,4),20), mirror(normal(1,1,0))]).
steps([matrix([[1,2,0,4],[0,1,1,5],[1,0,1,6]]), translate(0.1,0.2,0.3)]).

test(as_placing, [forall(steps(Steps)), true(Far < 1.0e-14)]) :-
    Points = [point(1.0,0.0,0.0), point(0.3,-2.0,5.0), point(0.0,0.0,0.0)],
    steps_matrix(Steps, Matrix),
    maplist(step_motion, Steps, Motions),
    findall(D, ( member(P, Points), moved(Motions, P, Q),
                 by_matrix(Matrix, P, R), apart(Q, R, D) ),
            Ds),
    max_list(Ds, Far).

by_matrix(Matrix, point(X,Y,Z), Point) :-
    maplist(row(X, Y, Z), Matrix, Values),
    Point =.. [point|Values].

row(X, Y, Z, [A,B,C,D], W) :-
    W is float(A*rational(X) + B*rational(Y) + C*rational(Z) + D).

apart(point(X1,Y1,Z1), point(X2,Y2,Z2), D) :-
    D is max(abs(X1-X2), max(abs(Y1-Y2), abs(Z1-Z2)))/10.

test(undone, Matrix == Identity) :-
    steps_matrix([translate(0.1,0.2,0.3), rotate(z,90), rotate(z,-90),
                  translate(-0.1,-0.2,-0.3)], Matrix),
    identity_matrix(Identity).
test(sign, Signs == [1, 1, 1, 1, -1, 1]) :-
    findall(Sign, ( steps(Steps), steps_matrix(Steps, Matrix),
                    matrix_sign(Matrix, Sign) ),
            Signs).
test(plane_goes_along, forall(steps(Steps))) :-
    steps_matrix(Steps, Matrix),
    matrix_plane(Matrix, plane(1,-2,3,0.5), plane(A,B,C,D)),
    forall(member(X-Y-Z, [0-0-0, 1-2-1, -7-1-2, 3-3-3]),
           ( Side0 is sign(X - 2*Y + 3*Z + 1r2),
             maplist(exact_row(X, Y, Z), Matrix, [X1,Y1,Z1]),
             Side is sign(A*X1 + B*Y1 + C*Z1 + D),
             Side =:= Side0 )).

exact_row(X, Y, Z, [A,B,C,D], W) :-
    W is A*X + B*Y + C*Z + D.

%   Every point of the box below the plane is in the tetrahedron, every one
%   above is not: the corners and the middle, of random planes and boxes.

test(half_space, forall(between(1, 300, Seed))) :-
    set_random(seed(Seed)),
    length(Numbers, 3),
    maplist([N]>>(N is random(2001)-1000), Numbers),
    Numbers = [A,B,C],
    ( A =\= 0 ; B =\= 0 ; C =\= 0 ),
    !,
    length(Corner, 3),
    maplist([N]>>(N is random_float*10-5), Corner),
    length(Size, 3),
    maplist([N]>>(N is random_float*3+0.01), Size),
    maplist([P,S,Q]>>(Q is P+S), Corner, Size, Far),
    D is -(A*random_float + B*random_float + C*random_float),
    Corner = [X1,Y1,Z1],
    Far = [X2,Y2,Z2],
    maplist([N,M]>>(M is rational(N)), [A,B,C,D], [E,F,G,H]),
    half_space(plane(E,F,G,H), box(X1,Y1,Z1,X2,Y2,Z2), Half),
    forall(( member(X, [X1,X2]), member(Y, [Y1,Y2]), member(Z, [Z1,Z2]) ),
           rightly(Half, plane(E,F,G,H), X, Y, Z)).

%   However small or large its numbers are, a plane is the same one.

test(half_space_of_any_size, [ forall(member(F, [1r10**320,10**320])),
                               true(Half == Half1) ]) :-
    maplist({F}/[N,M]>>(M is N*F), [1,-2,3,1r4], [A,B,C,D]),
    half_space(plane(1,-2,3,1r4), box(0.0,0.0,0.0,1.0,1.0,1.0), Half),
    half_space(plane(A,B,C,D), box(0.0,0.0,0.0,1.0,1.0,1.0), Half1).

rightly(Half, plane(A,B,C,D), X, Y, Z) :-
    Height is A*rational(X) + B*rational(Y) + C*rational(Z) + D,
    (   Half == all
    ->  Height < 0
    ;   Half == none
    ->  Height > 0
    ;   abs(Height) < 1.0e-10           % as near as its rounding
    ->  true
    ;   Half = polyhedron(points(Points), faces(Faces)),
        (   forall(member(Face, Faces), behind(Face, Points, X, Y, Z))
        ->  Height < 0
        ;   Height > 0
        )
    ).

nth_of(Points, I, Point) :-
    nth1(I, Points, Point).

behind(Face, Points, X, Y, Z) :-
    maplist(nth_of(Points), Face, Corners),
    Corners = [[A1,B1,C1],[A2,B2,C2],[A3,B3,C3]],
    U1 is A2-A1, V1 is B2-B1, W1 is C2-C1,
    U2 is A3-A1, V2 is B3-B1, W2 is C3-C1,
    (V1*W2-W1*V2)*(X-A1) + (W1*U2-U1*W2)*(Y-B1) + (U1*V2-V1*U2)*(Z-C1) < 0.

:- end_tests(csg_matrix).

:- begin_tests(grain).

%   Two boxes of an L, turned and rounded to float32: they miss each other by
%   what was rounded. A fact says so, also of them turned once more.

turned_single(Seed, Low, High, polyhedron(Points, Faces)) :-
    set_random(seed(Seed)),
    random_rotation([rotate(axis(X,Y,Z), Angle)]),
    steps_matrix([rotate(axis(X,Y,Z), Angle)], Matrix),
    box_points(Low, High, Points0),
    maplist(turned_place(Matrix), Points0, Points1),
    Points =.. [points,Points1],
    box_faces(Faces0),
    Faces =.. [faces,Faces0].

turned_place(Matrix, p(X,Y,Z), Place) :-
    maplist(turned_single(X, Y, Z), Matrix, Place).

turned_single(X, Y, Z, [A,B,C,_], Single) :-
    Double is float(A*X + B*Y + C*Z),
    to_single(Double, Single).

to_single(Double, Single) :-               % 24 bits
    (   Double =:= 0
    ->  Single = 0.0
    ;   Exponent is floor(log(abs(Double))/log(2)),
        Unit is 2.0**(Exponent-23),
        Single is round(Double/Unit)*Unit
    ).

test(instance_of_single, [ forall(between(1, 6, Seed)),
                           true(Faces-Vertices == 8-12) ]) :-
    turned_single(Seed, p(0,0,0), p(2,1,1), A),
    turned_single(Seed, p(0,0,1), p(1,1,2), B),
    Turn = [rotate(axis(1,2,3), 25), scale(0.7)],
    Grain is 2.0** -22,                 % of coordinates below 4
    with_tree([ A, B, union([at(Turn, 1), at(Turn, 2)]),
                fact(origin(1, s(1), source(Grain))),
                fact(origin(2, s(2), source(Grain))) ],
              ( evaluate(3),
                aggregate_all(count, p(3, _, _), Faces),
                findall(V, ( e(3, _, V, _, 1) ), Vs0),
                sort(Vs0, Vs),
                length(Vs, Vertices),
                origin(3, s(3), source(Grain3)) )),
    assertion(abs(Grain3-0.7*Grain) < 1.0e-12).

:- end_tests(grain).
