:- module(test_near, []).
:- use_module(library(plunit)).
:- use_module(rules(near)).

/* What is one but for rounding, and what is not, on both sides of each
   tolerance. */

:- begin_tests(near).

%   Each tolerance is that of its relation: a tenth less is one, a tenth more
%   is not.
test(edges, [ forall(relation(Of, Least, Goal, Off)),
              true(Truths == [true,false]) ]) :-
    tolerance(Of, Tolerance),
    assertion(Tolerance =:= Least),
    findall(Truth,
            ( member(Part, [0.9,1.1]),
              Off is Part*Least,
              truth(Goal, Truth) ),
            Truths).

test(angle, Same-Before == [true,false]-[false,true]) :-
    findall(Truth, ( member(T, [30.0000009,30.0000012]),
                     truth(same_angle(30.0, T), Truth) ), Same),
    findall(Truth, ( member(T, [30.0000009,30.0000012]),
                     truth(before_angle(30.0, T), Truth) ), Before).
test(between, Truths == [true,false,false,false]) :-
    findall(Truth, ( member(T, [5,0,10,11]),
                     truth(between_angles(0, T, 10), Truth) ), Truths).
test(direction, Truths == [true,true,false]) :-
    findall(Truth, ( member(T, [370.0,-350.0,190.0]),
                     truth(same_direction(10.0, T), Truth) ), Truths).
test(turns, Bys == [0.0,360.0,-360.0,360.0]) :-
    findall(By, ( member(T, [10.0,370.0,-10.0,360.0-1.0e-12]),
                  T1 is T, whole_turns(T1, By) ), Bys).
test(part, Truths == [true,false]) :-
    findall(Truth, ( member(H, [0.5+1.0e-10,0.5+1.0e-8]),
                     truth(same_part(0.5, H), Truth) ), Truths).
test(sign, Signs == [-1,0,0,0,1]) :-
    findall(Sign, ( member(Off, [-1.0e-8,-1.0e-10,0.0,1.0e-10,1.0e-8]),
                    off_sign(Off, Sign) ), Signs).
test(longer, Truths == [false,false,true]) :-
    findall(Truth, ( member(L, [999.0,1000.0000001,1000.1]),
                     truth(longer(L, 1000.0), Truth) ), Truths).
test(surface_of_its_size, Truths == [true,false]) :-
    findall(Truth, ( member(Size, [1000.0,1.0]),
                     truth(is_on_surface(1.0e-4, Size), Truth) ), Truths).
test(bend, Truths == [false,false,true,true]) :-
    findall(Truth, ( member(Degrees, [0.0,-0.009,-0.011,90.0]),
                     truth(is_bend(Degrees), Truth) ), Truths).
test(less, Truths == [false,false,true]) :-
    findall(Truth, ( member(H, [0.4,0.5+1.0e-10,0.5+1.0e-8]),
                     truth(less_part(0.5, H), Truth) ), Truths).
test(exactly, Truths == [true,false]) :-
    findall(Truth, ( member(Off, [-1.0e-13,1.0e-12]),
                     truth(is_exactly(Off, 1.0), Truth) ), Truths).
test(straight, Truths == [true,false,false]) :-
    findall(Truth, ( member(Cross, [-5.0e-5,2.0e-4,-2.0e-4]),
                     truth(is_straight(Cross, 100.0), Truth) ), Truths).
test(below, Truths == [false,false,true]) :-
    findall(Truth, ( member(Product, [2.0e-4,-5.0e-5,-2.0e-4]),
                     truth(below_zero(Product, 100.0), Truth) ), Truths).
test(nothing_has_no_size) :-
    is_on_surface(0.0, 0.0),
    is_rounding(0.0, 0.0),
    is_straight(0.0, 0.0),
    \+ below_zero(0.0, 0.0).
test(left, Truths == [true,false,true,false]) :-
    findall(Truth, ( member(X-Y, [(-1)-5,1-(-5),0-(-1),0-1]),
                     truth(points_left(X, Y), Truth) ), Truths).

test(boxes, Truths == [true,false,true,false,false]) :-
    findall(Truth,
            ( member(box(X,Y,Z)-Reach,
                     [box(2,0,0)-1,box(2,0,0)-(1 rdiv 2),box(-2,1,-2)-1,
                      box(0,3,0)-1,box(0,0,-3)-1]),
              X1 is X+1, Y1 is Y+1, Z1 is Z+1,
              truth(boxes_near(box(0,0,0,1,1,1), box(X,Y,Z,X1,Y1,Z1), Reach),
                    Truth) ), Truths).

:- end_tests(near).

:- meta_predicate truth(0, -).

relation(angle,    1.0e-6,  same_angle(0.0, Off), Off).
relation(rounding, 1.0e-9,  is_rounding(Off, 1.0), Off).
relation(rounding, 1.0e-9,  same_part(Off, 0.0), Off).
relation(exact,    2.0e-13, is_exactly(Off, 1.0), Off).
relation(surface,  1.0e-6,  is_on_surface(Off, 1.0), Off).
relation(paper,    1.0e-6,  is_straight(Off, 1.0), Off).
relation(fold,     1.0e-2,  \+ is_bend(Off), Off).

truth(Goal, Truth) :-
    (   call(Goal)
    ->  Truth = true
    ;   Truth = false
    ).
