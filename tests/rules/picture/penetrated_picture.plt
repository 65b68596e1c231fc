:- use_module(rules(solid/boolean)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(picture/view)).
:- use_module(rules(store)).
:- use_module(tests('rules/picture/picture_checked')).
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
% And of the united solids themselves, hidden ones too.
test(cubes2_united, V/H == 12.475/6.892) :-
    in_new_world(( box(1, p(0.0,0.0,0.0)), box(2, p(0.5,0.4,0.3)),
                   united_lengths(V, H) )).
test(cyl2_united, V/H == 23.851/10.033) :-
    in_new_world(( cylinders, united_lengths(V, H) )).
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

visible_length(Options, Length) :-
    set_direction(1.2, -2.0, 1.1),
    picture(Options),
    aggregate_all(sum(L), visible_part(L), Length).

united_lengths(Visible, Hidden) :-
    boolean(union([1,2]), 3),
    set_direction(1.2, -2.0, 1.1),
    picture([segments([3])]),
    drawn_lengths(Visible0, Hidden0),
    Visible is round(Visible0*1000)/1000,
    Hidden is round(Hidden0*1000)/1000.

visible_part(Length) :-
    drawn(_, S, E, From, To, visible, _),
    e(S, E, V1, V2, _),
    screen(S, V1, X1, Y1, _),
    screen(S, V2, X2, Y2, _),
    Length is (To-From)*sqrt((X2-X1)**2+(Y2-Y1)**2).

drawing(Parts) :-
    findall(d(A,B,C,D,E,F,G), drawn(A,B,C,D,E,F,G), Parts).

:- end_tests(feature_lengths).

% Pictures of penetrating solids against rays through the triangles that were
% there before: the middle of each drawn part is seen from the eye, or not.
:- begin_tests(penetrated_pictures).

test(rays) :-
    forall(between(1, 25, Seed), rays_agree(Seed)).

rays_agree(Seed) :-
    set_random(seed(Seed)),
    in_new_world((
        forall(between(1, 3, S), random_prism(S)),
        findall(Triangle, model_triangle(Triangle), Triangles),
        penetrate,
        Theta is 360*random_float,
        Phi is 180*random_float,
        set_view(Theta, Phi, 9),
        picture([lines(all)]),
        towards_eye(Theta, Phi, Ray),
        forall(middle(Point, D, Visibility),
               agree(Seed-D, Point, Ray, Triangles, Visibility))
    )).

random_prism(S) :-
    random_between(3, 7, N),
    R is 0.5+0.5*random_float,
    prism(N, R, 2.0, Points0, Faces),
    random_member(Move, [axes,by(0,0,0)]),
    moved(Move, Points0, Points1),
    X is random_float-0.5,
    Y is random_float-0.5,
    Z is random_float-0.5,
    moved(by(X,Y,Z), Points1, Points),
    polyhedron(S, solid, Points, Faces).

model_triangle(triangle(A, B, C)) :-
    t(S, _, _, V1, V2, V3),
    point(S, V1, A),
    point(S, V2, B),
    point(S, V3, C).

point(S, V, p(X,Y,Z)) :-
    v(S, V, X, Y, Z).

towards_eye(Theta, Phi, p(X,Y,Z)) :-
    X is sin(Phi*pi/180)*cos(Theta*pi/180),
    Y is sin(Phi*pi/180)*sin(Theta*pi/180),
    Z is cos(Phi*pi/180).

middle(p(X,Y,Z), D, Visibility) :-
    drawn(D, S, E, From, To, Visibility, _),
    e(S, E, V1, V2, _),
    v(S, V1, X1, Y1, Z1),
    v(S, V2, X2, Y2, Z2),
    T is (From+To)/2,
    X is X1+T*(X2-X1),
    Y is Y1+T*(Y2-Y1),
    Z is Z1+T*(Z2-Z1).

agree(Case, Point, Ray, Triangles, Visibility) :-
    (   member(Triangle, Triangles),
        blocks(Point, Ray, Triangle, 1.0e-6)
    ->  Seen = hidden
    ;   member(Triangle, Triangles),
        blocks(Point, Ray, Triangle, -1.0e-6)
    ->  Seen = Visibility                     % too close to a side to say
    ;   Seen = visible
    ),
    (   Seen == Visibility
    ->  true
    ;   throw(ray_disagrees(Case))
    ).

%   The ray from Point meets the triangle, farther than Close from its sides
%   and not where it begins.
blocks(P, Ray, triangle(A, B, C), Close) :-
    minus(B, A, U),
    minus(C, A, W),
    minus(P, A, Q),
    det(U, W, Ray, D),
    abs(D) > 1.0e-9,
    det(Q, W, Ray, X0),
    det(U, Q, Ray, Y0),
    det(U, W, Q, T0),
    X is X0/D,
    Y is Y0/D,
    X > Close,
    Y > Close,
    X+Y < 1-Close,
    -T0/D > 1.0e-6.

minus(p(X,Y,Z), p(X0,Y0,Z0), p(Dx,Dy,Dz)) :-
    Dx is X-X0,
    Dy is Y-Y0,
    Dz is Z-Z0.

det(p(A,B,C), p(D,E,F), p(G,H,I), Det) :-
    Det is A*(E*I-F*H) - B*(D*I-F*G) + C*(D*H-E*G).

:- end_tests(penetrated_pictures).
