:- use_module(rules(view)).
:- use_module(rules(kernel)).
:- use_module(rules(store)).
:- use_module(tests('rules/polyhedron')).

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
    abs(Z1-Z) < 1e-13.

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

:- end_tests(view).
