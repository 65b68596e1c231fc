:- module(sg_view,
          [ set_view/3,                 % +Theta, +Phi, +Rho
            set_view/1,                 % +Name
            set_direction/3,            % +X, +Y, +Z
            set_projection/1,           % +Kind
            current_view/4,             % -Theta, -Phi, -Rho, -Kind
            named_view/3,               % ?Name, ?Theta, ?Phi
            turn_up/1,                  % +Axis
            move_origin/1,              % +Point
            with_up/2,                  % +Axis, :Goal
            project_world/0,
            view_matrix/3,              % +Theta, +Phi, -Matrix
            eye_point/4,                % +Theta, +Phi, +Point, -EyePoint
            screen_depth/1,             % -Depth
            screen_distance/2           % +Zs, -Ze
          ]).
:- use_module(library(error), [must_be/2, domain_error/2]).
:- use_module(library(apply), [maplist/2, maplist/3, maplist/4]).
:- use_module(library(lists), [append/3, memberchk/2, nth1/3, nth1/4]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [ view/3, projection/1, assert_fact/1, retractall_facts/1,
                facts_transaction/1
              ]).
:- use_module('../csg/known_surface',
              [facets_moved/1, remembered_facets/1, remember_only/1]).
:- use_module('../kernel',
              [ fill_screen/4, view_range/5, view_depth/5, sine_cosine/3,
                turn_points/2
              ]).
:- set_prolog_flag(optimise, true).
:- meta_predicate with_up(+, 0).

/** <module> Views: from the model to the picture.

The eye stands at spherical (Rho, Theta, Phi), degrees, Phi from +z, and looks
at the origin. In the picture x runs to the right, y up and z away from the
eye (a left-handed system). A parallel picture is in model units; a central one
too, as large as the model is at its nearest point.

The view is a matrix, rounded to 30 bits after the point; where a point is seen
by it is exact, rounded once. So what lies behind one another is seen in one
place up to that rounding, and is made one: points of the picture that are
nearer than 1e-7 of its longer side. A turned box that is seen squarely is
square.

The kernel fill_screen/4 fills screen/5 for a whole world; tests/oracle/view.pl
and eye_point/4 are its rules.

@see [PL] section 6.1 and 6.2: PL-11, PL-12.
*/

% What is seen when the model says nothing.
default_view(300.0, 65.0, 0.0).

%!  set_view(+Theta, +Phi, +Rho) is det.
%
%   Look from there; Theta and Phi in degrees, Rho in model units. A Rho of 0
%   is three times as far as the farthest vertex. Replaces view/3.
%
%   @error domain_error(not_less_than_zero, Rho)

set_view(Theta0, Phi0, Rho0) :-
    must_be(number, Theta0),
    must_be(number, Phi0),
    must_be(number, Rho0),
    (   Rho0 < 0
    ->  domain_error(not_less_than_zero, Rho0)
    ;   true
    ),
    Theta is float(Theta0)+0.0,
    Phi is float(Phi0)+0.0,
    Rho is float(Rho0)+0.0,
    facts_transaction(
        (   retractall_facts(view(_,_,_)),
            assert_fact(view(Theta, Phi, Rho))
        )).

%!  set_view(+Name) is det.
%
%   Look from a named side, see named_view/3, from as far away as needed.
%
%   @error domain_error(view_name, Name)

set_view(Name) :-
    must_be(atom, Name),
    (   named_view(Name, Theta, Phi)
    ->  set_view(Theta, Phi, 0.0)
    ;   domain_error(view_name, Name)
    ).

%!  set_direction(+X, +Y, +Z) is det.
%
%   Look from there, as from infinitely far away: from (X,Y,Z) to the origin, of
%   any length, with +z upwards. In a central projection the eye is as far away
%   as needed.
%
%   @error domain_error(direction, p(X,Y,Z)) if all are 0

set_direction(X, Y, Z) :-
    direction_angles(X, Y, Z, Theta, Phi),
    set_view(Theta, Phi, 0.0).

%   Straight from above or below the picture is that of `top` and `bottom`.

direction_angles(X, Y, Z, Theta, Phi) :-
    must_be(number, X),
    must_be(number, Y),
    must_be(number, Z),
    Largest is max(abs(X), max(abs(Y), abs(Z))),
    (   Largest =:= 0
    ->  domain_error(direction, p(X,Y,Z))
    ;   X =:= 0,
        Y =:= 0
    ->  Theta = 270.0
    ;   Theta is atan2(Y/Largest, X/Largest)*(180/pi)
    ),
    Phi is atan2(sqrt((X/Largest)**2+(Y/Largest)**2), Z/Largest)*(180/pi).

%!  named_view(?Name, ?Theta, ?Phi) is nondet.
%
%   The sides that have a name. The front is seen from -y; iso (isometric)
%   looks along a diagonal of a cube, from the right, the front and above;
%   dimetric is nearer to the front, so that depths are half as long as widths
%   and heights; trimetric is how a model is seen that says nothing.

named_view(front,  270.0,  90.0).
named_view(right,    0.0,  90.0).
named_view(top,    270.0,   0.0).
named_view(left,   180.0,  90.0).
named_view(back,    90.0,  90.0).
named_view(bottom, 270.0, 180.0).
named_view(iso,    315.0,  54.735610317245346).
named_view(isometric, 315.0, 54.735610317245346).
named_view(dimetric, 290.7048110546354, 70.52877936550931).
named_view(trimetric, 300.0, 65.0).

%!  set_projection(+Kind) is det.
%
%   Project in parallel or from a centre: Kind is `parallel` or `central`.
%
%   @error domain_error(projection, Kind)

set_projection(Kind) :-
    must_be(atom, Kind),
    (   memberchk(Kind, [parallel,central])
    ->  true
    ;   domain_error(projection, Kind)
    ),
    facts_transaction(
        (   retractall_facts(projection(_)),
            assert_fact(projection(Kind))
        )).

%!  current_view(-Theta, -Phi, -Rho, -Kind) is det.
%
%   True when this is how the current world is looked at: view/3 and
%   projection/1, or what stands for them when there are none. Rho is never 0.

current_view(Theta, Phi, Rho, Kind) :-
    (   view(Theta0, Phi0, Rho0)
    ->  true
    ;   default_view(Theta0, Phi0, Rho0)
    ),
    Theta = Theta0,
    Phi = Phi0,
    eye_distance(Rho0, Rho),
    (   projection(Kind0)
    ->  Kind = Kind0
    ;   Kind = parallel
    ).

eye_distance(Rho0, Rho) :-
    (   Rho0 > 0.0
    ->  Rho = Rho0
    ;   view_range(0.0, 0.0, _, _, Reach),
        Reach > 0.0
    ->  Rho is 3*Reach
    ;   Rho = 1.0
    ).

%!  turn_up(+Axis) is det.
%
%   Turn the current world so that its Axis, `x`, `y` or `z`, points up in
%   pictures: a quarter turn about the y or the x axis makes it the z axis.
%   Exact.
%
%   @error domain_error(up, Axis)

turn_up(Axis) :-
    must_be(atom, Axis),
    (   quarter_turn(Axis, up, _)
    ->  facts_transaction(sg_view:turned(Axis, up))
    ;   domain_error(up, Axis)
    ).

%!  with_up(+Axis, :Goal) is semidet.
%
%   While Goal runs, once, the current world is turned as by turn_up/1. One
%   transaction.

with_up(Axis, Goal) :-
    facts_transaction(
        (   remembered_facets(Facets),
            turn_up(Axis),
            once(Goal),
            sg_view:turned(Axis, back),
            remember_only(Facets)
        )).

turned(Axis, Way) :-
    quarter_turn(Axis, Way, Axes),
    (   Axes == [1,2,3]
    ->  true
    ;   turned_points(Axes, [0,0,0])
    ).

%   turned_points(Axes, Origin): Origin becomes the origin, and then the axes
%   become others: the number N of Axes means the N-th before, -N the same the
%   other way. Also of the surfaces that facets stand for.

turned_points(Axes, Origin) :-
    turn_points(Axes, Origin),
    maplist(turned_row(Origin), Axes, Matrix),
    facets_moved(Matrix).

turned_row(Origin, Axis, Row) :-
    N is abs(Axis),
    Sign is sign(Axis),
    nth1(N, Origin, X0),
    D is -Sign*X0,
    nth1(N, Row0, Sign, [0,0]),
    append(Row0, [D], Row).

%   quarter_turn(Axis, Way, Axes): the axes that x, y and z are taken from; with
%   a minus sign the other way.

quarter_turn(z, _,    [1,2,3]).
quarter_turn(y, up,   [1,-3,2]).
quarter_turn(y, back, [1,3,-2]).
quarter_turn(x, up,   [-3,2,1]).
quarter_turn(x, back, [3,2,-1]).

%!  move_origin(+Point:list) is det.
%
%   Move the current world so that Point, [X,Y,Z], is the origin: rounded. One
%   transaction.

move_origin(Point) :-
    facts_transaction(sg_view:turned_points([1,2,3], Point)).

%!  project_world is det.
%
%   Fill screen/5 of the current world: where each vertex is in the picture.
%
%   @error geometry_error(eye_in_model(D)): in a central projection the nearest
%          vertex is at D =< 0, in or behind the eye

project_world :-
    current_view(Theta, Phi, Rho, Kind),
    check_distance(Kind, Theta, Phi, Rho),
    facts_transaction(stage(join, fill_screen(Theta, Phi, Rho, Kind))).

check_distance(central, Theta, Phi, Rho) :-
    view_range(Theta, Phi, Near, _, _),
    D is Near+Rho,
    D =< 0.0,
    !,
    throw(error(geometry_error(eye_in_model(D)), _)).
check_distance(_, _, _, _).

%!  view_matrix(+Theta, +Phi, -Matrix) is det.
%
%   Matrix is [Right,Up,Away], each row r(A,B,C), rational numbers: what is to
%   the right in the picture, up in it, and away from the eye, in the model. The
%   numbers are those of PL-11, rounded to 30 bits after the point.

view_matrix(Theta, Phi, [ r(Rx,Ry,0), r(Ux,Uy,Uz), r(Ax,Ay,Az) ]) :-
    sine_cosine(Theta, St, Ct),
    sine_cosine(Phi, Sp, Cp),
    rounded(-St, Rx),
    rounded(Ct, Ry),
    rounded(-Ct*Cp, Ux),
    rounded(-St*Cp, Uy),
    rounded(Sp, Uz),
    rounded(-Sp*Ct, Ax),
    rounded(-St*Sp, Ay),
    rounded(-Cp, Az).

rounded(Expression, Number) :-
    Number is round(Expression*2**30) rdiv 2**30.

%!  eye_point(+Theta, +Phi, +Point, -EyePoint) is det.
%
%   PL-11: where p(X,Y,Z) is for the eye: p(Xe,Ye,Ze-Rho), by view_matrix/3,
%   rounded once. Depth is counted from the origin, so that Rho cannot spoil its
%   last digits.

eye_point(Theta, Phi, p(X0,Y0,Z0), p(Xe,Ye,Ze)) :-
    view_matrix(Theta, Phi, [Right,Up,Away]),
    Point = p(X,Y,Z),
    X is rational(X0),
    Y is rational(Y0),
    Z is rational(Z0),
    along(Right, Point, Xe),
    along(Up, Point, Ye),
    along(Away, Point, Ze).

along(r(A,B,C), p(X,Y,Z), Coordinate) :-
    Coordinate is float(A*X + B*Y + C*Z).

%!  screen_depth(-Depth) is det.
%
%   True when one unit of Zs is Depth model units, at the model's nearest point.

screen_depth(Depth) :-
    current_view(Theta, Phi, Rho, Kind),
    view_depth(Theta, Phi, Rho, Kind, Depth).

%!  screen_distance(+Zs, -Ze) is det.
%
%   True when what is at depth Zs in the picture of the current world is Ze away
%   from the eye along its line of sight, counted from the origin: PL-11
%   backwards, in model units.

screen_distance(Zs, Ze) :-
    current_view(Theta, Phi, Rho, Kind),
    (   Kind == parallel
    ->  Ze = Zs
    ;   view_range(Theta, Phi, Near, Far, _),
        D is Near+Rho,
        F is Far+Rho,
        Ze is D/(1 - Zs*(1-D/F)) - Rho
    ).
