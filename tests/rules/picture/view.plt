:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(picture/view)).
:- use_module(rules(kernel)).
:- use_module(rules(store)).
:- use_module(tests('rules/polyhedron')).
:- use_module(tests('oracle/view')).

:- begin_tests(view).

% In a new world with the corners of a box.
boxed(Goal) :-
    in_new_world((
        box_points(p(-1.0,-2.0,-3.0), p(1.0,2.0,3.0), Points),
        box_faces(Faces),
        polyhedron(1, solid, Points, Faces),
        Goal
    )).

seen(V, Xs, Ys, Zs) :-
    screen(1, V, Xs, Ys, Zs).

test(default) :-
    in_new_world(current_view(300.0, 65.0, 1.0, parallel)).
test(set) :-
    in_new_world(( set_view(30, 40, 50), set_view(10, 20, 30),
                   set_projection(central), set_projection(parallel),
                   current_view(10.0, 20.0, 30.0, parallel),
                   findall(x, view(_,_,_), [x]),
                   findall(x, projection(_), [x]) )).
test(names, all(Name == [front,right,top,left,back,bottom,iso,isometric,
                          dimetric,trimetric])) :-
    named_view(Name, _, _).
test(distance) :-
    boxed(( set_view(front), current_view(270.0, 90.0, Rho, _),
            Rho =:= 3*sqrt(14) )).
test(no_name, error(domain_error(view_name, frnt))) :-
    set_view(frnt).
test(negative_rho, error(domain_error(not_less_than_zero, -1))) :-
    in_new_world(set_view(0, 0, -1)).
test(no_number, error(type_error(number, x))) :-
    set_view(x, 0, 0).
test(kind, error(domain_error(projection, oblique))) :-
    set_projection(oblique).
test(eye_in_model, error(geometry_error(eye_in_model(-1.0)))) :-
    boxed(( set_view(270, 90, 1), set_projection(central), project_world )).
test(eye_on_model, error(geometry_error(eye_in_model(0.0)))) :-
    boxed(( set_view(270, 90, 2), set_projection(central), project_world )).
test(nothing_half_done) :-
    boxed(( set_view(270, 90, 2), project_world, seen(8, X, Y, Z),
            set_projection(central), catch(project_world, _, true),
            seen(8, X, Y, Z) )).
test(empty_world) :-
    in_new_world(( set_projection(central), project_world,
                   \+ screen(_,_,_,_,_) )).

% p(1,2,3) is corner 8: what the sides show is exact.
test(sides, forall(shown(Side, Seen))) :-
    boxed(( set_view(Side), project_world, call(Seen) )).

shown(front, seen(8, 1.0, 3.0, 2.0)).
shown(right, seen(8, 2.0, 3.0, -1.0)).
shown(top, seen(8, 1.0, 2.0, -3.0)).
shown(left, seen(8, -2.0, 3.0, 1.0)).
shown(back, seen(8, -1.0, 3.0, -2.0)).
shown(bottom, seen(8, 1.0, -2.0, 3.0)).
test(no_minus_zero) :-
    in_new_world(( curve(1, [p(0,0,0), p(-0.0,1,0)]),
                   forall(named_view(Name, _, _),
                          ( set_view(Name), project_world,
                            \+ ( screen(_,_,X,Y,Z), member(C, [X,Y,Z]),
                                 C =:= 0, C \== 0.0 ) )) )).

% The kernel against the rules, PL-11.
test(kernel_is_rule_parallel) :-
    same_as_rule(parallel).
test(kernel_is_rule_central) :-
    same_as_rule(central).

same_as_rule(Kind) :-
    set_random(seed(11)),
    forall(between(1, 60, _),
           boxed(( random_view, set_projection(Kind), project_world,
                   rule_view(View),
                   forall(screen(S, V, X, Y, Z),
                          rule_sees(View, S, V, X, Y, Z))
                 ))).

random_view :-
    Theta is 360*random_float,
    Phi is 180*random_float,
    set_view(Theta, Phi, 7).

rule_view(View) :-
    current_view(Theta, Phi, Rho, Kind),
    (   Kind == parallel
    ->  View = Theta-Phi-parallel
    ;   view_range(Theta, Phi, Near, Far, _),
        D is Near+Rho,
        F is Far+Rho,
        View = Theta-Phi-central(Rho, D, F)
    ).

rule_sees(Theta-Phi-How, S, V, X, Y, Z) :-
    v(S, V, X0, Y0, Z0),
    eye_point(Theta, Phi, p(X0,Y0,Z0), Eye),
    screen_point(How, Eye, p(X1,Y1,Z1)),
    abs(X1-X) < 1e-14,
    abs(Y1-Y) < 1e-14,
    abs(Z1-Z) < 1e-13,
    (   How == parallel
    ->  X1-Y1-Z1 == X-Y-Z
    ;   true
    ).

% Rounded to 30 bits after the point, and then exact.
test(matrix, M == [ r(1,0,0), r(0,0,1), r(0,1,0) ]) :-
    view_matrix(270.0, 90.0, M).
test(matrix_rounded) :-
    view_matrix(123.4, 56.7, Rows),
    forall(( member(r(A,B,C), Rows), member(X, [A,B,C]) ),
           ( N is X*2**30, integer(N) )),
    forall(( member(R1, Rows), member(R2, Rows) ),
           ( dot(R1, R2, Dot),
             ( R1 == R2 -> Want = 1 ; Want = 0 ),
             abs(Dot-Want) < 4.0e-9 )).
test(exact, all(E == [p(0.0,0.0,-3.0e40)])) :-
    eye_point(300.0, 35.0, p(1.0e40,1.0e40,1.0e40), _),
    eye_point(270.0, 0.0, p(0.0,0.0,3.0e40), E).

dot(r(A,B,C), r(D,E,F), Dot) :-
    Dot is A*D+B*E+C*F.

% Directions: as named views; any length; from above as `top`.
test(directions) :-
    forall(member(Name-(X,Y,Z), [ front-(0,-2,0), right-(3,0,0), top-(0,0,5),
                                  left-(-1.0e-300,0,0), back-(0,1.0e300,0),
                                  bottom-(0,0,-1), iso-(1,-1,1) ]),
           in_new_world(( set_direction(X, Y, Z), view(Theta, Phi, 0.0),
                          named_view(Name, Theta1, Phi1),
                          view_matrix(Theta, Phi, M),
                          view_matrix(Theta1, Phi1, M) ))).
test(no_direction, error(domain_error(direction, p(0,0.0,0)))) :-
    set_direction(0, 0.0, 0).

% What is nearly in one place is in one place: the kernel against the rule.
test(one_place,
     Ps == [p(0.0,0.0),p(3.0,0.0),p(0.0,0.0),p(3.0,0.0),p(1.9,0.0)]) :-
    in_one_place(1.0, [p(0.0,0.0),p(3.0,0.0),p(0.6,0.6),p(3.5,0.0),p(1.9,0.0)],
                 Ps).
test(kernel_is_rule_in_one_place) :-
    set_random(seed(12)),
    forall(between(1, 40, _),
           in_new_world(( clustered_points(Points), curve(1, Points),
                          set_view(front), project_world,
                          findall(p(X,Y), screen(1,_,X,Y,_), Seen),
                          findall(p(X,Z), v(1,_,X,_,Z), Points0),
                          picture_side(Points0, Side),
                          Close is 1.0e-7*Side,
                          in_one_place(Close, Points0, Seen0),
                          Seen == Seen0,
                          sort(Seen, Places),
                          length(Places, N), N < 200 ))).

clustered_points(Points) :-
    findall(p(X,Y,Z),
            ( between(1, 300, _),
              random_between(0, 3, I),
              random_between(0, 3, J),
              X is I+3.0e-7*random_float,
              Y is random_float,
              Z is J+3.0e-7*random_float ),
            Points).

picture_side(Points, Side) :-
    aggregate_all(r(max(X),min(X),max(Y),min(Y)), member(p(X,Y), Points),
                  r(X1,X0,Y1,Y0)),
    Side is max(X1-X0, Y1-Y0).

% A box turned anyhow and seen squarely is square, also with the numbers of a
% file of floats of 32 bits.
test(turned_square, [forall(member(Digits, [all,single]))]) :-
    set_random(seed(13)),
    forall(between(1, 50, _), square_when_turned(Digits)).

square_when_turned(Digits) :-
    Theta is 360*random_float,
    Phi is 180*random_float,
    turned_box(Theta, Phi, Digits, Points),
    box_faces(Faces),
    in_new_world(( polyhedron(1, solid, Points, Faces),
                   set_view(Theta, Phi, 0), project_world,
                   findall(X-Y, screen(1,_,X,Y,_), Seen),
                   sort(Seen, Places), length(Places, 4) )).

%   A box of which the rows of PL-11 are the directions of its sides.
turned_box(Theta, Phi, Digits, Points) :-
    box_points(p(-1.0,-0.5,-0.75), p(1.0,0.5,0.75), Points0),
    T is Theta*pi/180,
    P is Phi*pi/180,
    maplist(turned_point(T, P, Digits), Points0, Points).

turned_point(T, P, Digits, p(X,Y,Z), p(X1,Y1,Z1)) :-
    X0 is -X*sin(T) - Y*cos(T)*cos(P) - Z*sin(P)*cos(T),
    Y0 is X*cos(T) - Y*sin(T)*cos(P) - Z*sin(T)*sin(P),
    Z0 is Y*sin(P) - Z*cos(P),
    maplist(digits(Digits), [X0,Y0,Z0], [X1,Y1,Z1]).

digits(all, X, X).
digits(single, X, Y) :-
    Y is round(X*2**24)/2.0**24.

% PL-12: the plane of a triangle, also in a central picture.
test(screen_plane) :-
    boxed(( set_view(300, 60, 9), set_projection(central), project_world,
            forall(t(1, _, T, _, _, _), plane_holds(T)) )).

plane_holds(T) :-
    t(1, P, T, _, _, _),
    screen_plane(1, T, A, B, D),
    forall(( t(1, P, _, V1, V2, V3), member(V, [V1,V2,V3]) ),
           ( seen(V, X, Y, Z), abs(A*X+B*Y+Z+D) < 1e-12 )).

test(no_screen_plane_edge_on, fail) :-
    boxed(( set_view(front), project_world, t(1, 1, T, _, _, _), !,
            screen_plane(1, T, _, _, _) )).

% Central pictures: D = F, and a depth that is linear along lines.
test(flat_model) :-
    in_new_world(( polyhedron(1, surface, [p(0,0,0),p(1,0,0),p(0,0,1)],
                              [[1,2,3]]),
                   set_view(270, 90, 4), set_projection(central),
                   project_world, screen_depth(4.0),
                   forall(seen(_, _, _, Z), Z == 0.0),
                   seen(2, 1.0, 0.0, _) )).
test(middle_of_a_line) :-
    in_new_world(( curve(1, [p(-1,-1,0.5), p(0,0,1), p(1,1,1.5)]),
                   set_view(250, 70, 4), set_projection(central),
                   project_world,
                   seen(1, X1, _, Z1), seen(2, X2, _, Z2), seen(3, X3, _, Z3),
                   abs((X2-X1)/(X3-X1) - (Z2-Z1)/(Z3-Z1)) < 1e-12 )).

% Where a vertex of a world is that is turned so that Axis points up.
turned(Axis, X, Y, Z) :-
    in_new_world(( assert_fact(segment(1, curve, w)),
                   assert_fact(v(1, 1, 1.0, 2.0, 3.0)),
                   turn_up(Axis),
                   v(1, 1, X, Y, Z) )).

test(up_z, p(X,Y,Z) == p(1.0,2.0,3.0)) :-
    turned(z, X, Y, Z).
test(up_y, p(X,Y,Z) == p(1.0,-3.0,2.0)) :-
    turned(y, X, Y, Z).
test(up_x, p(X,Y,Z) == p(-3.0,2.0,1.0)) :-
    turned(x, X, Y, Z).
test(up_and_back, [ forall(member(Axis, [x,y,z])), After == Before ]) :-
    boxed(( findall(V-p(X,Y,Z), v(1, V, X, Y, Z), Before0),
            sort(Before0, Before),
            with_up(Axis, v(1, 1, _, _, _)),
            findall(V-p(X,Y,Z), v(1, V, X, Y, Z), After0),
            sort(After0, After) )).
% The kernel does what the rule says.
test(turned, [ forall(member(Axes-Origin, [[1,-3,2]-[0,0,0], [-3,2,1]-[0,0,0],
                                           [3,2,-1]-[0,0,0],
                                           [1,2,3]-[0.1,-7,1.0e-3],
                                           [-2,-3,1]-[1,2,3]])),
               Kernel == Rule ]) :-
    boxed(( penetrate([]), assert_fact(leaf_v(1, 1, 0.1, -0.0, 3.0)),
            facts_snapshot(( turn_points(Axes, Origin), places(Kernel) )),
            turned_by_rule(Axes, Origin),
            places(Rule) )).
test(turned_no_axes, error(domain_error(axes, [1,2,2]))) :-
    boxed(turn_points([1,2,2], [0,0,0])).
test(moved_out, error(representation_error(coordinate))) :-
    in_new_world(( assert_fact(segment(1, curve, w)),
                   assert_fact(v(1, 1, 9.0e89, 2.0, 3.0)),
                   turn_points([1,2,3], [-9.0e89,0,0]) )).

places(Places) :-
    findall(v(S,V,X,Y,Z), v(S, V, X, Y, Z), Vs),
    findall(l(S,V,X,Y,Z), leaf_v(S, V, X, Y, Z), Ls),
    findall(p(S,P,X,Y,Z,D), plane(S, P, X, Y, Z, D), Ps),
    Places = Vs-Ls-Ps.

test(up_no_axis, error(domain_error(up, w))) :-
    boxed(turn_up(w)).

:- end_tests(view).
