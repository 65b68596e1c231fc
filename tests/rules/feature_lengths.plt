:- use_module(rules(penetration)).
:- use_module(rules(hidden_lines)).
:- use_module(rules(view)).
:- use_module(rules(store)).
:- use_module(tests('rules/polyhedron')).

% The pairs of peers/hlr_unfold, penetrating, seen from (1.2, -2.0, 1.1): the
% visible feature edges are as long as those of the united solids.
:- begin_tests(feature_lengths).

test(cubes2, V =:= 12.475) :-
    in_new_world(( box(1, p(0.0,0.0,0.0)), box(2, p(0.5,0.4,0.3)),
                   penetrate, visible_length([], V0) )),
    V is round(V0*1000)/1000.
test(cyl2, true(abs(V-23.851) < 1.0e-3)) :-
    in_new_world(( cylinders, penetrate, visible_length([], V) )).
test(kernel_is_rule) :-
    in_new_world(( cylinders, penetrate,
                   set_direction(1.2, -2.0, 1.1),
                   picture([method(kernel),lines(all)]), drawing(Kernel),
                   picture([method(rule),lines(all)]), drawing(Rule),
                   Kernel == Rule )).
test(lines_alone, true(N > 0)) :-
    in_new_world(( cylinders, penetrate,
                   picture([lines(penetration),segments([1])]),
                   \+ ( drawn(_,S,_,_,_,_,Role), S-Role \== 1-penetration ),
                   aggregate_all(count, drawn(_,_,_,_,_,_,_), N) )).
% Not drawn twice: only one of the two segments has the line.
test(one_copy) :-
    in_new_world(( box(1, p(0.0,0.0,0.0)), box(2, p(0.5,0.4,0.3)),
                   penetrate, set_view(300, 60, 9), picture,
                   \+ drawn(_,2,_,_,_,_,penetration),
                   once(drawn(_,1,_,_,_,visible,penetration)) )).

box(S, Low) :-
    moved(by(1.0,1.0,1.0), [Low], [High]),
    box_points(Low, High, Points),
    box_faces(Faces),
    polyhedron(S, solid, Points, Faces).

cylinders :-
    prism(40, 1.0, 4.0, Points1, Faces),
    polyhedron(1, solid, Points1, Faces),
    prism(40, 0.8, 4.0, Points0, Faces),
    moved(axes, Points0, Points2),
    polyhedron(2, solid, Points2, Faces).

set_direction(X, Y, Z) :-
    Theta is atan2(Y, X)*180/pi,
    Phi is acos(Z/sqrt(X*X+Y*Y+Z*Z))*180/pi,
    set_view(Theta, Phi, 9.0).

visible_length(Options, Length) :-
    set_direction(1.2, -2.0, 1.1),
    picture(Options),
    aggregate_all(sum(L), visible_part(L), Length).

visible_part(Length) :-
    drawn(_, S, E, From, To, visible, _),
    e(S, E, V1, V2, _),
    screen(S, V1, X1, Y1, _),
    screen(S, V2, X2, Y2, _),
    Length is (To-From)*sqrt((X2-X1)**2+(Y2-Y1)**2).

drawing(Parts) :-
    findall(d(A,B,C,D,E,F,G), drawn(A,B,C,D,E,F,G), Parts).

:- end_tests(feature_lengths).
