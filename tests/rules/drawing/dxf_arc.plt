/* Arcs among the sides of a smooth outline: rules/drawing/dxf_arc.pl. */
:- module(test_dxf_arc, []).
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(library(apply)).
:- use_module(rules(drawing/dxf_arc)).

:- begin_tests(dxf_arc).

%   arc(R, From, To, N, Points): N sides on a circle about 7000-3000, degrees,
%   counter-clockwise as it is seen, so with y down.

arc(R, From, To, N, Points) :-
    findall(X-Y,
            ( between(0, N, I),
              A is (From + (To-From)*I/N)*pi/180,
              X is round(7000 + R*cos(A)),
              Y is round(3000 - R*sin(A)) ),
            Points).

test(circle, forall(member(R-N, [50000-160,3000-120,1000000-400]))) :-
    arc(R, 0, 360, N, Points),
    ring_circle(Points, Circle),
    assertion(Circle == circle(7000-3000, R)).
test(polygon_is_no_circle, [fail]) :-
    arc(50000, 0, 360, 48, Points),
    ring_circle(Points, _).
test(ellipse_is_no_circle, [fail]) :-
    arc(50000, 0, 360, 200, Points0),
    findall(X-Y, ( member(X-Y0, Points0), Y is Y0*101//100 ), Points),
    ring_circle(Points, _).

%   The bulge is the tangent of a quarter of the angle, to the left.

test(arc, forall(member(To, [40,90,216,330]))) :-
    arc(50000, 0, To, 160, Points),
    arcs_found(Points, [], all, [corner(First,[],Bulge),end(Last)]),
    assertion(nth0(0, Points, First)),
    assertion(last(Points, Last)),
    assertion(abs(Bulge - tan(To*pi/720)) < 1.0e-3*Bulge).
test(arc_to_the_right) :-
    arc(50000, 90, 0, 60, Points),
    arcs_found(Points, [], all, [corner(_,_,Bulge),end(_)]),
    assertion(abs(Bulge + tan(pi/8)) < 1.0e-4).

%   A ring segment, as of a cone: two lines, two arcs, each with the edge that
%   begins there.

test(sector) :-
    arc(50000, 0, 100, 80, Out),
    arc(30000, 100, 0, 80, In),
    Out = [First|_],
    append([Out,In,[First]], Points),
    length(Points, N),
    numlist(2, N, Edges),
    arcs_found(Points, Edges, all,
               [ corner(_,[2],B1),corner(_,[82],0),corner(_,[83],B2),
                 corner(_,[163],0),end(First) ]),
    assertion(abs(B1 - tan(100*pi/720)) < 1.0e-4),
    assertion(abs(B2 + tan(100*pi/720)) < 1.0e-4).
test(straight_stays, [true(Bulges == [0,0,0,0])]) :-
    arcs_found([0-0,1000-0,1000-1000,0-1000,0-0], [], all,
               Corners),
    findall(B, member(corner(_,_,B), Corners), Bulges).
test(facets_stay, [true(N == 49)]) :-
    arc(50000, 0, 360, 48, Points),
    arcs_found(Points, [], all, Corners),
    length(Corners, N).

%   Of edges 1 to 40, which lie on one circle in steps of 4.5 degrees, those
%   from 11 to 30 are a relief.

test(relief, [true(Ends == [[11]-true,[31]-false])]) :-
    arc(5000, 0, 180, 40, Points),
    numlist(1, 40, Edges),
    numlist(11, 30, Relief),
    arcs_found(Points, Edges, Relief, Corners),
    length(Corners, 22),
    append(_, [corner(_,E1,B1),corner(_,E2,B2)|_], Corners),
    B1 =\= 0,
    !,
    assertion(abs(B1 - tan(90*pi/720)) < 1.0e-3),
    findall(E-Round,
            ( member(E-B, [E1-B1,E2-B2]),
              ( B =:= 0 -> Round = false ; Round = true ) ),
            Ends).
test(square_relief_stays, [true(Bulges == [0,0,0,0])]) :-
    arcs_found([0-0,1000-0,1000-1000,0-1000,0-0], [1,2,3,4], [1,2,3,4],
               Corners),
    findall(B, member(corner(_,_,B), Corners), Bulges).

:- end_tests(dxf_arc).
