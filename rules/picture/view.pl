:- module(sg_view,
          [ set_view/3,                 % +Theta, +Phi, +Rho
            set_view/1,                 % +Name
            set_direction/3,            % +X, +Y, +Z
            set_projection/1,           % +Kind
            current_view/4,             % -Theta, -Phi, -Rho, -Kind
            named_view/3,               % ?Name, ?Theta, ?Phi
            turn_up/1,                  % +Axis
            move_origin/1,              % +Point
            turned_by_rule/2,           % +Axes, +Origin
            turned_point/4,             % +Axes, +Origin, +Place0, -Place
            with_up/2,                  % +Axis, :Goal
            project_world/0,
            view_matrix/3,              % +Theta, +Phi, -Matrix
            eye_point/4,                % +Theta, +Phi, +Point, -EyePoint
            screen_point/3,             % +View, +EyePoint, -ScreenPoint
            in_one_place/3,             % +Close, +Points0, -Points
            screen_plane/5,             % +S, +T, -A, -B, -D
            screen_depth/1,             % -Depth
            screen_distance/2           % +Zs, -Ze
          ]).
:- use_module(library(error), [must_be/2, domain_error/2]).
:- use_module(library(apply),
              [foldl/5, foldl/6, maplist/2, maplist/3, maplist/4]).
:- use_module(library(lists),
              [append/3, member/2, memberchk/2, nth1/3, nth1/4]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [ view/3, projection/1, screen/5, t/6, v/5, leaf_v/5, plane/6,
                assert_fact/1, retractall_facts/1, facts_transaction/1
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
place but for that rounding, and in_one_place/3 makes it one: points of the
picture that are nearer than 1e-7 of its longer side. A turned box that is seen
squarely is square.

The rules eye_point/4, screen_point/3 and in_one_place/3 say where points are
seen; the kernel fill_screen/4 does the same for a whole world and fills
screen/5.

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

%   turned_points(Axes, Origin): turned_point/4 of all there is, also of the
%   surfaces that facets stand for.

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

%!  turned_by_rule(+Axes:list, +Origin:list) is det.
%
%   What the kernel turn_points/2 does: all rows of the current world that have
%   a point, or a plane, are turned. One transaction.

turned_by_rule(Axes, Origin) :-
    findall(New, ( placed_row(Old, Place0, New, Place), Old,
                   turned_point(Axes, Origin, Place0, Place) ),
            Rows),
    facts_transaction(
        ( retractall_facts(v(_,_,_,_,_)),
          retractall_facts(leaf_v(_,_,_,_,_)),
          retractall_facts(plane(_,_,_,_,_,_)),
          maplist(assert_fact, Rows) )).

%   placed_row(Old, Place0, New, Place): rows that have a point, or a plane.

placed_row(v(S,V,X0,Y0,Z0), [X0,Y0,Z0], v(S,V,X,Y,Z), [X,Y,Z]).
placed_row(leaf_v(S,V,X0,Y0,Z0), [X0,Y0,Z0], leaf_v(S,V,X,Y,Z), [X,Y,Z]).
placed_row(plane(S,P,X0,Y0,Z0,D0), plane([X0,Y0,Z0],D0),
           plane(S,P,X,Y,Z,D), plane([X,Y,Z],D)).

%!  turned_point(+Axes, +Origin, +Place0, -Place) is det.
%
%   Place is to where Place0 goes, a point [X,Y,Z] or plane(Normal, D), when
%   Origin becomes the origin and then the axes become others: the number N of
%   Axes means the N-th before, -N the same the other way.

turned_point(Axes, Origin, plane(Normal0,D0), plane(Normal,D)) :-
    !,
    maplist(taken_from(Normal0), Axes, Normal),
    foldl(product_added, Normal0, Origin, D0, D).
turned_point(Axes, Origin, Point0, Point) :-
    maplist(less, Point0, Origin, Point1),
    maplist(taken_from(Point1), Axes, Point).

taken_from(Point, Axis, X) :-
    N is abs(Axis),
    nth1(N, Point, X0),
    X is sign(Axis)*X0 + 0.0.

less(X0, Origin, X) :-
    X is X0-Origin.

product_added(A, B, D0, D) :-
    D is D0 + A*B.

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

%!  screen_point(+View, +EyePoint, -ScreenPoint) is det.
%
%   PL-11: from the eye's coordinates to the picture's. View is `parallel`
%   (PL-11 a) or central(Rho, D, F) (PL-11 b, with S = 1), where D and F are the
%   smallest and largest Ze of the model; if they are equal every depth is 0.

screen_point(parallel, Point, Point).
screen_point(central(Rho,D,F), p(Xe,Ye,Ze0), p(Xs,Ys,Zs)) :-
    Ze is Ze0+Rho,
    W is Ze/D,
    Xs is Xe/W,
    Ys is Ye/W,
    (   F-D =< F*2.0** -40
    ->  Zs = 0.0
    ;   Zs is (Ze/D-1)/(1-D/F)/W
    ).

%!  in_one_place(+Close, +Points0, -Points) is det.
%
%   Points are Points0, p(X,Y) of the picture in their order, each moved to the
%   first before it that was not moved itself and is not farther than Close.

in_one_place(Close, Points0, Points) :-
    foldl(placed(Close), Points0, Points, [], _).

placed(Close, Point, Place, Places, Places) :-
    member(Place, Places),
    near(Close, Point, Place),
    !.
placed(_, Point, Point, Places0, Places) :-
    append(Places0, [Point], Places).

near(Close, p(X0,Y0), p(X,Y)) :-
    (X-X0)*(X-X0) + (Y-Y0)*(Y-Y0) =< Close*Close.

%!  screen_plane(+S, +T, -A, -B, -D) is semidet.
%
%   PL-12: True when A*Xs + B*Ys + Zs + D = 0 is the plane of triangle T in the
%   picture. Fails for a triangle seen edge-on.

screen_plane(S, T, A, B, D) :-
    t(S, _, T, V1, V2, V3),
    screen(S, V1, X1, Y1, Z1),
    screen(S, V2, X2, Y2, Z2),
    screen(S, V3, X3, Y3, Z3),
    Det is (X2-X1)*(Y3-Y1) - (X3-X1)*(Y2-Y1),
    Det =\= 0.0,
    A is ((Y2-Y1)*(Z3-Z1) - (Y3-Y1)*(Z2-Z1)) / Det,
    B is ((X3-X1)*(Z2-Z1) - (X2-X1)*(Z3-Z1)) / Det,
    D is -(A*X1 + B*Y1 + Z1).

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
