/* An eye that looks at something: where from, which way, and how far. */
:- module(test_eye, []).
:- use_module(library(apply)).
:- use_module(library(plunit)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(sheet/eye)).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   A box from 0, -5, 3 to 2, 1, 11, and one from -5.5, -0.5, 0 to -4.5, 0.5, 1.

:- meta_predicate with_boxes(0).

with_boxes(Goal) :-
    in_new_world(( add_primitive(at([translate(1,-2,3)], box(size(2,6,8))), _),
                   add_primitive(at([translate(-5,0,0)], box(size(1,1,1))), _),
                   complete_segments,
                   call(Goal) )).

near(X, Y) :-
    abs(X-Y) < 1.0e-9.

%   eye(Eye, Target, Theta, Phi, Distance): seen from the target.

eye([10,0,0],   [0,0,0],  0,   90,  10).
eye([0,10,0],   [0,0,0],  90,  90,  10).
eye([0,-7,0],   [0,0,0],  -90, 90,  7).
eye([3,4,0],    [3,4,-5], any, 0,   5).
eye([3,4,-9],   [3,4,-5], any, 180, 4).
eye([4,3,1],    [3,3,0],  0,   45,  Distance) :-
    Distance is sqrt(2).

:- begin_tests(eye).

test(target, [true(Target == [-1.75,-2.0,5.5])]) :-
    with_boxes(eye_target(middle, Target)).
test(target_of_nothing, [true(Target == [0.0,0.0,0.0])]) :-
    in_new_world(eye_target(middle, Target)).
test(given_target, [true(Target == [1,2,3])]) :-
    with_boxes(eye_target([1,2,3], Target)).
test(looks, [forall(eye(Eye, At, Theta, Phi, Distance)),
             true(Rho0-X == 0.0-0.0)]) :-
    with_boxes(( set_eye(Eye, At, parallel),
                 view(Theta0, Phi0, Rho0),
                 once(v(1, 1, X, _, _)) )),
    near(Phi0, Phi),
    (   Theta == any
    ->  true
    ;   Turn is cos((Theta0-Theta)*pi/180),
        near(Turn, 1)
    ),
    number(Distance).
test(central, [forall(eye(Eye, [A,B,C], _, Phi, Distance))]) :-
    with_boxes(( once(v(1, 1, X0, Y0, Z0)),
                 set_eye(Eye, [A,B,C], central),
                 view(_, Phi0, Rho),
                 once(v(1, 1, X, Y, Z)) )),
    maplist(near, [Phi0,Rho], [Phi,Distance]),
    maplist([P,Q,R]>>( D is P-Q, near(D, R) ), [X0,Y0,Z0], [A,B,C], [X,Y,Z]).
test(nowhere, [throws(error(usage_error(sheet(no_direction('--eye', '1,2,3'))),
                            _))]) :-
    with_boxes(eye_view([1,2,3], [1,2,3], _)).

:- end_tests(eye).
