/* Pictures of trees that are placed anyhow: turned, stretched, mirrored, from
   1e-8 to 1e6 large. Against rays that know solids by inequalities, against the
   triangles of the evaluated boundary, and against the frame of these. */
% covers: extent
:- module(test_placed_picture, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(csg/csg_matrix)).
:- use_module(rules(kernel)).
:- use_module(rules(shading/shaded_picture)).
:- use_module(rules(shading/shading_facets)).
:- use_module(rules(shading/shading_scene)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(store)).
:- use_module(tests('rules/polyhedron')).
:- use_module(tests('rules/sample')).

:- begin_tests(placed_picture).

% ---- random trees ----------------------------------------------------------

leaf(0, box(size(A,B,C))) :- maplist(long, [A,B,C]).
leaf(1, sphere(radius(A,B,C),facets(12))) :- maplist(long, [A,B,C]).
leaf(2, hemisphere(radius(A),facets(12))) :- long(A).
leaf(3, egg(radius(A),up(B),down(C),facets(12))) :- maplist(long, [A,B,C]).
leaf(4, cylinder(radius(A,B),height(C),facets(12))) :-
    maplist(long, [A,B,C]).
leaf(5, cone(radius(A),top(B),height(C),facets(12),shift(D,E))) :-
    maplist(long, [A,B,C,D,E]).
leaf(6, hollow_cylinder(radius(A),inner(B),height(C),facets(12))) :-
    maplist(long, [A,C]),
    B is A*0.6.

long(X) :-
    X is 0.3 + 2*random_float.

step(0, rotate(axis(A,B,C),D)) :-
    maplist(long, [A,B,C]),
    D is 360*random_float.
step(1, translate(A,B,C)) :-
    maplist(long, [A,B,C0]),
    C is C0 - 2.
step(2, scale(A,B,C)) :-
    maplist(long, [A,B,C0]),
    random_member(Sign, [1,-1]),
    C is Sign*C0.
step(3, mirror(Axis)) :-
    random_member(Axis, [x,y,z]).

steps(Steps) :-
    random_between(0, 3, N),
    length(Steps, N),
    maplist([Step]>>(random_between(0, 3, I), once(step(I, Step))), Steps).

tree(Deep, at(Steps,Term)) :-
    steps(Steps),
    (   Deep =:= 0
    ->  random_between(0, 6, I),
        once(leaf(I, Term))
    ;   Fewer is Deep-1,
        random_between(2, 3, N),
        length(Operands, N),
        maplist(tree(Fewer), Operands),
        random_member(Name, [union,intersection,difference]),
        Term =.. [Name,Operands]
    ).

random_tree(Seed, at([scale(Scale,Scale,Scale)],Tree), View) :-
    set_random(seed(Seed)),
    Deep is 1 + Seed mod 2,
    tree(Deep, Tree),
    nth_of(Seed, [1,1.0e-8,1.0e6,0.001,1000], Scale),
    nth_of(Seed, [view(300.0,65.0,0.0,parallel),view(17.0,133.0,0.0,parallel),
                  view(300.0,65.0,Far,central)], View),
    Far is 40*Scale.

nth_of(Seed, List, Element) :-
    length(List, N),
    I is Seed mod N,
    nth0(I, List, Element).

% ---- pictures --------------------------------------------------------------

size(32).

%   The picture of segment 1: of Term as a Kind of surfaces, `true` or `facets`.
%   Fails if nothing is seen.
scene(Term, Kind, View, Place, Scene) :-
    assert_fact(segment(1, solid, Term)),
    shaded_model([1], Model0),
    (   Kind == facets
    ->  faceted_model(Model0, Model)
    ;   Model = Model0
    ),
    shaded_eye(Model, View, Eye),
    size(N),
    picture_place(Model, Eye, [size(N-N)], _, Place),
    shaded_scene(Model, Eye, Place, N-N, Scene).

%   wrong(Scene, Oracle, Wrong): dots in whose middle the picture is as deep as
%   Oracle does not say, where that says the same all round.
wrong(Scene, Oracle, X-Y-Depth-Right) :-
    size(N),
    between(1, N, Column),
    between(1, N, Row),
    X is Column-0.5,
    Y is Row-0.5,
    scene_handle(Scene, Handle),
    (   shading_point(Handle, X, Y, _, Depth0, _)
    ->  Depth = Depth0
    ;   Depth = none
    ),
    depth(Oracle, Handle, X, Y, Right),
    \+ near(Depth, Right, 0.02),
    forall(member(DX-DY, [0.02-0,-0.02-0,0-0.02,0-(-0.02)]),
           ( X1 is X+DX, Y1 is Y+DY, depth(Oracle, Handle, X1, Y1, Other),
             near(Other, Right, 0.5) )).

near(none, none, _) :-
    !.
near(A, B, Most) :-
    number(A),
    number(B),
    abs(A-B) =< Most.

% ---- rays ------------------------------------------------------------------

%   depth(Oracle, Handle, X, Y, Depth): `none` where nothing is.
depth(rays(Plan), Handle, X, Y, Depth) :-
    shading_place(Handle, X, Y, -30.0, point(A,B,C)),
    shading_place(Handle, X, Y, -29.0, point(D,E,F)),
    maplist(minus, [D,E,F], [A,B,C], Way),
    ray_places(Plan, [A,B,C], Way, Ts0, []),
    sort(Ts0, Ts),
    (   append(_, [T1,T2|_], Ts),
        T2-T1 > 1.0e-6*abs(T1),
        T is (T1+T2)/2,
        holds(Plan, [A,B,C], Way, T)
    ->  ray_depth(Handle, X, Y, [A,B,C], Way, T1, Depth)
    ;   Depth = none
    ).
depth(triangles(All), _, X, Y, Depth) :-
    (   aggregate_all(min(Z), ( member(Triangle, All),
                                in_triangle(Triangle, X, Y, Z) ), Z1)
    ->  Depth = Z1
    ;   Depth = none
    ).

minus(X, Y, Z) :-
    Z is X-Y.

moved(T, X, D, Z) :-
    Z is X + T*D.

%   A place T along a line of sight is a quotient of linear forms of the depth.
ray_depth(Handle, X, Y, P, Way, T, Depth) :-
    place_along(Handle, X, Y, P, Way, 0.0, T1),
    place_along(Handle, X, Y, P, Way, 30.0, T2),
    C is (2*T1 - T2)/(60*(T2 - T1)),
    A is T1/30 * (30*C + 1),
    Depth is T/(A - C*T) - 30.

place_along(Handle, X, Y, P, Way, Depth, T) :-
    shading_place(Handle, X, Y, Depth, point(A,B,C)),
    maplist(minus, [A,B,C], P, [U,V,W]),
    Way = [D,E,F],
    T is (U*D + V*E + W*F)/(D*D + E*E + F*F).

plan(at(Steps,Term), Matrix0, Plan) :-
    !,
    steps_matrix(Steps, Matrix1),
    matrix_product(Matrix0, Matrix1, Matrix),
    plan(Term, Matrix, Plan).
plan(Term, Matrix, Plan) :-
    Term =.. [Name,Operands],
    memberchk(Name, [union,intersection,difference]),
    !,
    maplist({Matrix}/[O,P]>>plan(O, Matrix, P), Operands, Plans),
    Plan =.. [Name,Plans].
plan(Term, Matrix, leaf(Term,Inverse)) :-
    inverse(Matrix, Inverse).

inverse([[A,B,C,P],[D,E,F,Q],[G,H,I,R]], Rows) :-
    Det is A*(E*I-F*H) + B*(F*G-D*I) + C*(D*H-E*G),
    Cofactors = [[E*I-F*H,C*H-B*I,B*F-C*E],[F*G-D*I,A*I-C*G,C*D-A*F],
                 [D*H-E*G,B*G-A*H,A*E-B*D]],
    maplist({Det,P,Q,R}/[[X,Y,Z],[X1,Y1,Z1,W]]>>
                ( X1 is float((X)/Det), Y1 is float((Y)/Det),
                  Z1 is float((Z)/Det),
                  W is float(-((X)*P + (Y)*Q + (Z)*R)/Det) ),
            Cofactors, Rows).

ray_places(leaf(Term,Inverse), P, D, Ts0, Ts) :-
    !,
    local(Inverse, P, D, At, Way),
    findall(T, ( shape(Term, Forms, _), member(Form, Forms),
                 form_place(Form, At, Way, T) ), Found),
    append(Found, Ts, Ts0).
ray_places(Node, P, D, Ts0, Ts) :-
    arg(1, Node, Operands),
    foldl({P,D}/[O,A,B]>>ray_places(O, P, D, A, B), Operands, Ts0, Ts).

local(Inverse, [X,Y,Z], [U,V,W], At, Way) :-
    maplist({X,Y,Z}/[[A,B,C,D],N]>>(N is A*X + B*Y + C*Z + D), Inverse, At),
    maplist({U,V,W}/[[A,B,C,_],N]>>(N is A*U + B*V + C*W), Inverse, Way).

holds(leaf(Term,Inverse), P, D, T) :-
    local(Inverse, P, D, At0, Way),
    maplist(moved(T), At0, Way, At),
    shape(Term, Forms, Inside),
    maplist(value(At), Forms, Values),
    call(Inside, Values).
holds(union(Plans), P, D, T) :-
    member(Plan, Plans),
    holds(Plan, P, D, T),
    !.
holds(intersection(Plans), P, D, T) :-
    forall(member(Plan, Plans), holds(Plan, P, D, T)).
holds(difference([Plan|Plans]), P, D, T) :-
    holds(Plan, P, D, T),
    \+ holds(union(Plans), P, D, T).

%   shape(Term, Forms, Inside): what bounds a primitive, each at least 0 inside
%   or not, as Inside says of the values of all. A form is a sum of squares of
%   linear forms, S-[A,B,C,D] with its sign, or one linear form.
shape(box(size(A,B,C)), [[1,0,0,A1],[-1,0,0,A1],[0,1,0,B1],[0,-1,0,B1],
                         [0,0,1,0],[0,0,-1,C]], all) :-
    A1 is A/2,
    B1 is B/2.
shape(sphere(radius(A,B,C),_), [Ball], all) :-
    ball(A, B, C, Ball).
shape(hemisphere(radius(A),_), [Ball,[0,0,1,0]], all) :-
    ball(A, A, A, Ball).
shape(egg(radius(A),up(B),down(C),_), [Up,Down,[0,0,1,0]], half) :-
    ball(A, A, B, Up),
    ball(A, A, C, Down).
shape(cylinder(radius(A,B),height(C),_), [Side,[0,0,1,0],[0,0,-1,C]], all) :-
    X is 1/A,
    Y is 1/B,
    Side = [1-[0,0,0,1],-1-[X,0,0,0],-1-[0,Y,0,0]].
shape(cone(radius(A),top(B),height(C),_,shift(D,E)),
      [[1-[0,0,G,A],-1-[1,0,X,0],-1-[0,1,Y,0]],[0,0,1,0],[0,0,-1,C]], all) :-
    G is (B-A)/C,
    X is -D/C,
    Y is -E/C.
shape(hollow_cylinder(radius(A),inner(B),height(C),_),
      [[1-[0,0,0,A]|Round],[-1-[0,0,0,B],1-[1,0,0,0],1-[0,1,0,0]],
       [0,0,1,0],[0,0,-1,C]], all) :-
    Round = [-1-[1,0,0,0],-1-[0,1,0,0]].

ball(A, B, C, [1-[0,0,0,1],-1-[X,0,0,0],-1-[0,Y,0,0],-1-[0,0,Z,0]]) :-
    maplist([L,I]>>(I is 1/L), [A,B,C], [X,Y,Z]).

all(Values) :-
    forall(member(Value, Values), Value > 0).

half([Up,Down,Z]) :-
    (   Z > 0
    ->  Up > 0
    ;   Down > 0
    ).

value([X,Y,Z], [A,B,C,D], Value) :-
    number(A),
    !,
    Value is A*X + B*Y + C*Z + D.
value(At, Form, Value) :-
    aggregate_all(sum(S*V*V), ( member(S-Linear, Form),
                                value(At, Linear, V) ), Value).

form_place(Form, At, [U,V,W], T) :-
    value(At, Form, C),
    (   Form = [A,B,C1,_],
        number(A)
    ->  Slope is A*U + B*V + C1*W,
        Slope =\= 0,
        T is -C/Slope
    ;   aggregate_all(r(sum(S*M*M),sum(S*M*N)),
                      ( member(S-Linear, Form), value(At, Linear, N),
                        Linear = [A,B,D,_], M is A*U + B*V + D*W ),
                      r(E,F)),
        Square is F*F - E*C,
        Square > 0,
        Big is -F - copysign(sqrt(Square), F),
        (   E =\= 0,
            T is Big/E
        ;   Big =\= 0,
            T is C/Big
        )
    ).

% ---- triangles -------------------------------------------------------------

in_triangle(tri(X1,Y1,Z1,X2,Y2,Z2,X3,Y3,Z3), X, Y, Z) :-
    Area is (X2-X1)*(Y3-Y1) - (X3-X1)*(Y2-Y1),
    Area =\= 0,
    A is ((X2-X)*(Y3-Y) - (X3-X)*(Y2-Y))/Area,
    A >= 0,
    B is ((X3-X)*(Y1-Y) - (X1-X)*(Y3-Y))/Area,
    B >= 0,
    C is 1-A-B,
    C >= 0,
    Z is A*Z1 + B*Z2 + C*Z3.

boundary(Scene, Triangles) :-
    scene_matrix(Scene, Matrix),
    findall(tri(X1,Y1,Z1,X2,Y2,Z2,X3,Y3,Z3),
            ( t(1, _, _, V1, V2, V3),
              seen(Matrix, V1, X1, Y1, Z1),
              seen(Matrix, V2, X2, Y2, Z2),
              seen(Matrix, V3, X3, Y3, Z3) ),
            Triangles).

%   Parallel: from where three axes and the origin are.
scene_matrix(Scene, Matrix) :-
    scene_handle(Scene, Handle),
    maplist({Handle}/[[X,Y,Z],P]>>( shading_place(Handle, X, Y, Z,
                                                  point(A,B,C)),
                                    P = [A,B,C] ),
            [[0.0,0.0,0.0],[1.0,0.0,0.0],[0.0,1.0,0.0],[0.0,0.0,1.0]],
            [[A0,B0,C0]|Ends]),
    maplist(minus_all([A0,B0,C0]), Ends, [[A1,B1,C1],[A2,B2,C2],[A3,B3,C3]]),
    inverse([[A1,A2,A3,A0],[B1,B2,B3,B0],[C1,C2,C3,C0]], Matrix).

minus_all(From, To, Way) :-
    maplist(minus, To, From, Way).

seen(Matrix, V, X, Y, Z) :-
    v(1, V, A, B, C),
    maplist(value([A,B,C]), Matrix, [X,Y,Z]).

% ---- tests -----------------------------------------------------------------

test(rays, [ forall(numbered(6, 150, Seed)), true(Wrong == []) ]) :-
    random_tree(Seed, Term, View),
    in_new_world((
        scene(Term, true, View, _, Scene)
    ->  identity_matrix(Identity),
        plan(Term, Identity, Plan),
        findall(Bad, wrong(Scene, rays(Plan), Bad), Wrong)
    ;   Wrong = []
    )).
test(boundary, [ forall(numbered(6, 150, Seed)), true(Wrong == []) ]) :-
    boundary_case(Seed, Scene, Triangles),
    findall(Bad, wrong(Scene, triangles(Triangles), Bad), Wrong).

%   A tenth of the side is free all round, the shorter way: tips are found.
test(frame, [ forall(numbered(6, 150, Seed)), true(Off < 0.02) ]) :-
    boundary_case(Seed, _, Triangles),
    (   aggregate_all(r(min(X),max(X),min(Y),max(Y)),
                      ( member(Triangle, Triangles),
                        corner(Triangle, X, Y) ),
                      r(X1,X2,Y1,Y2))
    ->  size(N),
        Off is max(abs(max(X2-X1, Y2-Y1) - 0.8*N),
                   max(abs(X1+X2-N), abs(Y1+Y2-N)))
    ;   Off = 0
    ).

corner(tri(X1,Y1,_,X2,Y2,_,X3,Y3,_), X, Y) :-
    member(X-Y, [X1-Y1,X2-Y2,X3-Y3]).

boundary_case(Seed, Scene, Triangles) :-
    random_tree(Seed, Term, View0),
    (   View0 = view(_,_,_,parallel)
    ->  View = View0
    ;   View = view(300.0,65.0,0.0,parallel)
    ),
    in_new_world((
        scene(Term, facets, View, _, Scene)
    ->  evaluate,
        boundary(Scene, Triangles)
    ;   in_new_world(shaded_scene(model([],[],[]),
                                  eye(300.0,65.0,0.0,parallel,1.0),
                                  place(1.0,0.0,0.0), 32-32, Scene)),
        Triangles = []
    )).

% What is thinner than a dot, a leaf or what is left of one, is in the frame.
test(thin, [forall(member(Thin-Thick, [0.001-0.02,1.0e-6-0.02]))]) :-
    maplist(thin_scale(leaf), [Thin,Thick], [A,B]),
    abs(A/B-1) < 0.02,
    maplist(thin_scale(left), [Thin,Thick], [C,D]),
    abs(C/D-1) < 0.02.

thin_scale(How, Thick, Scale) :-
    thin_plate(How, Thick, Plate),
    in_new_world((
        assert_fact(segment(1, solid, union([sphere(radius(0.5)),
                                             at([translate(0,0,2)],Plate)]))),
        shaded_model([1], Model),
        shaded_eye(Model, view(270.0,90.0,0.0,parallel), Eye),
        picture_place(Model, Eye, [size(400-300)], _, place(Scale,_,_))
    )).

thin_plate(leaf, Thick, box(size(9,0.3,Thick))).
thin_plate(left, Thick, difference([box(size(9,0.3,1)),
                                    at([translate(0,0,Thick)],
                                       box(size(20,9,9)))])).

:- end_tests(placed_picture).
