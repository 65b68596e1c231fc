/* Facets that a hole parts: which loops become one polygon. */
:- module(test_true_part_loop, []).
:- use_module(library(apply)).
:- use_module(library(assoc)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(unrolling/true_part_loop)).

%   facet(Loops, Shape, Facet): each loop a list of T-H, in the order of its
%   corners; corner I of loop N is 10*N+I.

facet(Loops, shape(none,none,Nodes), facet(7,0.0,90.0,Halves)) :-
    findall(Id-node(T,H,none,none), corner(Loops, _, Id, T-H), Pairs),
    list_to_assoc(Pairs, Nodes),
    findall(half(k(A,0),k(B,0),none),
            ( corner(Loops, N-I, A, _),
              nth1(N, Loops, Loop),
              length(Loop, Count),
              B is 10*N + I mod Count + 1 ),
            Halves).

corner(Loops, N-I, Id, At) :-
    nth1(N, Loops, Loop),
    nth1(I, Loop, At),
    Id is 10*N+I.

%   parted(Loops, Parts): the numbers of the loops of each part, by its name.

parted(Loops, Parts) :-
    facet(Loops, Shape, Facet),
    facet_parted(Shape, Facet, Facets),
    maplist(named, Facets, Parts).

named(facet(P,0.0,90.0,Halves), P-Ns) :-
    findall(N, ( member(half(k(Id,_),_,_), Halves), N is Id//10 ), Ns0),
    sort(Ns0, Ns).

%   Two outer loops that lean, so that what is round a point is seen only where
%   it crosses; the left one goes up, the right one down.

left([0.0-0.0,40.0-30.0,40.0-70.0,0.0-40.0]).
right([50.0-30.0,90.0-0.0,90.0-40.0,50.0-70.0]).

hole(T, H, [T1-H,T-H2,T2-H]) :-         % runs the other way
    T1 is T+2.0,
    T2 is T-2.0,
    H2 is H-2.0.

:- begin_tests(true_part_loop).

test(whole, Parts == [7-[1]]) :-
    left(A),
    parted([A], Parts).
test(one_with_a_hole, Parts == [7-[1,2]]) :-
    left(A),
    hole(20.0, 30.0, B),
    parted([A,B], Parts).
test(two, Parts == [7-[1],(7/0)-[2]]) :-
    left(A),
    right(B),
    parted([A,B], Parts).

%   A hole anywhere in one of two: by its top or bottom, at either end.

test(holes, [ forall(( member(T, [4.0,20.0,36.0]),
                       member(Up, [4.0,20.0,38.0]) )),
              true(Parts == [7-[1,3],(7/0)-[2,4]]) ]) :-
    left(A),
    right(B),
    H1 is 0.75*T+Up,
    T2 is 50.0+T,
    H2 is 30.0-0.75*T+Up,
    hole(T, H1, C),
    hole(T2, H2, D),
    parted([A,B,C,D], Parts).

%   One above the other: what a ray upwards enters again, through a corner, and
%   leaves.

test(above, Parts == [7-[1,4],(7/0)-[2,3]]) :-
    A = [0.0-0.0,40.0-0.0,40.0-20.0,0.0-20.0],
    B = [0.0-30.0,22.0-35.0,40.0-30.0,40.0-60.0,0.0-60.0],
    hole(20.0, 45.0, C),
    hole(20.0, 10.0, D),
    parted([A,B,C,D], Parts).

%   All of it seen from the other side.

test(turned, Parts == [7-[1,4],(7/0)-[2,3]]) :-
    left(A0),
    right(B0),
    hole(70.0, 30.0, C0),
    hole(20.0, 30.0, D0),
    maplist(reverse, [A0,B0,C0,D0], Loops),
    parted(Loops, Parts).

%   A corner of the loop is on the ray.

test(corner_on_the_ray, Parts == [7-[1,3],(7/0)-[2]]) :-
    A = [0.0-0.0,22.0-5.0,40.0-0.0,22.0-40.0],
    right(B),
    hole(20.0, 15.0, C),
    parted([A,B,C], Parts).

:- end_tests(true_part_loop).
