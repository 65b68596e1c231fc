:- module(test_primitive_solids, []).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(library(readutil)).
:- use_module(rules(angle)).
:- use_module(rules(command/check)).
:- use_module(rules(model/model_file)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(polygon/polygon_list)).
:- use_module(rules(primitive/primitive)).
:- use_module(rules(primitive/primitive_face)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests('rules/polyhedron'), [in_new_world/1]).

% The area of a regular polygon of radius 1 with N corners.
ring(N, Area) :-
    Area is N/2*sin(2*pi/N).

% solid(Term, Volume, Vertices, Polygons, Euler): the closed form of the faceted
% solid.
solid(cylinder(radius(2.0,1.0), height(3), facets(20)), V, 40, 22, 2) :-
    ring(20, A),
    V is 2*A*3.
solid(cylinder(radius(2), height(3), shift(5,1), facets(20)), V, 40, 22, 2) :-
    ring(20, A),
    V is 4*A*3.
solid(hollow_cylinder(radius(2), inner(1), height(3), facets(12)),
      V, 48, 26, 0) :-
    ring(12, A),
    V is (4-1)*A*3.
solid(hollow_cylinder(radius(2.0,3.0), inner(1,2.5), height(3), shift(-4,2),
                      facets(12)), V, 48, 26, 0) :-
    ring(12, A),
    V is (6-2.5)*A*3.
solid(cone(radius(2.0,1.0), height(3), shift(1,1), facets(9)), V, 10, 10, 2) :-
    ring(9, A),
    V is 2*A*3/3.
solid(cone(radius(2), top(1), height(3), shift(0,-4), facets(9)),
      V, 18, 11, 2) :-
    ring(9, A),
    V is A*(4+2+1)*3/3.
solid(cone(radius(2.0,1.0), top(1), height(3), facets(9)), V, 18, 11, 2) :-
    ring(9, A),
    V is A*(2+1+0.5)*3/3.
solid(sphere(radius(1), facets(4), bands(2)), V, 6, 8, 2) :-
    V is 4/3.
solid(sphere(radius(1,2,3), facets(4), bands(2)), 8.0, 6, 8, 2).
solid(sphere(radius(1), facets(12), bands(6)), V, 62, 72, 2) :-
    ring(12, A),
    globe_volume(-90, 30, 6, 1, 1, A, V).
solid(egg(radius(1), up(3), down(2), facets(12), bands(6)), V, 62, 72, 2) :-
    ring(12, A),
    globe_volume(-90, 30, 3, 1, 2, A, V1),
    globe_volume(0, 30, 3, 1, 3, A, V2),
    V is V1+V2.
solid(hemisphere(radius(2), facets(12), bands(3)), V, 37, 37, 2) :-
    ring(12, A),
    globe_volume(0, 30, 3, 2, 2, A, V).
solid(hemisphere(radius(1), facets(4), bands(1)), V, 5, 5, 2) :-
    V is 2/3.
solid(torus(radius(3), tube(1), facets(10), sides(8)), V, 80, 80, 0) :-
    V is 8/2*sin(2*pi/8)*10*sin(2*pi/10)*3.
solid(prism(outline([[0,0],[2,0],[2,1],[1,1],[1,2],[0,2]]), height(2)),
      6.0, 12, 8, 2).
solid(prism(outline([[0,0],[0,4],[4,4],[4,0]]),
            holes([[[1,1],[2,1],[2,2]], [[3,3],[3,3.5],[3.5,3]]]),
            height(2), shift(1,1)), V, 20, 12, -2) :-
    V is 2*(16-0.5-0.125).
solid(prism(outline([[-1,-1],[1,-1],[1,1],[-1,1]]), height(3), scale(0.5)),
      7.0, 8, 6, 2).
solid(prism(outline([[-1,-1],[1,-1],[1,1],[-1,1]]), height(3), scale(0.5,2),
            shift(7,1)), 13.0, 8, 6, 2).
solid(prism(outline([[-1,0],[0,-1],[1,0],[0,1]]), height(3), twist(Degrees),
            slices(10)), V, 44, 82, 2) :-
    member(Degrees, [90, -200]),
    Turn is abs(Degrees)/10*pi/180,
    Middle is 4*cos(Turn/2)*cos((pi/2-Turn)/2)*sin(pi/4),
    V is 3/6*(2+4*Middle+2).
solid(prism(outline([[-1,0],[0,-1],[1,0],[0,1]]), height(3), twist(90),
            scale(0), slices(1)), 2.0, 5, 5, 2).
solid(prism(outline([[-1,-1],[1,-1],[1,1],[-1,1]]), height(3), scale(F,0),
            shift(7,1)), V, 6, 5, 2) :-
    member(F, [1,0.5,4]),
    V is 4*3*(2+F)/6.
solid(prism(outline([[-1,-1],[1,-1],[1,1],[-1,1]]), height(3), scale(0,F),
            slices(4)), V, 18, 17, 2) :-
    member(F, [1,0.5]),
    V is 4*3*(2+F)/6.
solid(prism(outline([[0,0],[2,0],[2,1],[1,1],[1,2],[0,2]]), height(2),
            scale(1,0)), 3.0, 9, 7, 2).
solid(prism(outline([[-1,0],[0,-1],[1,0],[0,1]]), height(3), scale(1,0)),
      3.0, 7, 9, 2).
solid(pyramid(outline([[0,0],[2,0],[2,1],[1,1],[1,2],[0,2]]), height(2),
              shift(5,5)), 2.0, 7, 7, 2).
solid(turning(outline([[0,0],[2,0],[2,3],[0,3]]), facets(9)), V, 18, 11, 2) :-
    ring(9, A),
    V is 4*A*3.
solid(turning(outline([[0,0],[2,0],[0,3]]), facets(9)), V, 10, 10, 2) :-
    ring(9, A),
    V is 4*A*3/3.
solid(turning(outline([[1,3],[2,3],[2,0],[1,0]]), facets(9)), V, 36, 20, 0) :-
    ring(9, A),
    V is 3*A*3.
solid(turning(outline([[0,0],[2,0],[2,2],[0,2],[0,1]]), angle(90), facets(1)),
      4.0, 7, 5, 2).
solid(turning(outline([[1,0],[5,0],[5,4],[1,4]]),
              holes([[[2,1],[3,1],[3,3],[2,3]]]), facets(4)), V, 32, 20, 0) :-
    V is 2*((25-1)*4 - (9-4)*2).
solid(turning(outline([[1,0],[5,0],[5,4],[1,4]]),
              holes([[[2,1],[3,1],[3,3],[2,3]]]), angle(180), facets(2)),
      V, 24, 14, 0) :-
    V is (25-1)*4 - (9-4)*2.
solid(polyhedron(points([[0,0,0],[1,0,0],[0,1,0],[0,0,1]]),
                 faces([[1,3,2],[1,2,4],[2,3,4],[1,4,3]])), V, 4, 4, 2) :-
    V is 1/6.
solid(polyhedron(points([[0,0,0],[4,0,0],[4,4,0],[0,4,0],
                         [0,0,1],[4,0,1],[4,4,1],[0,4,1],
                         [1,1,0],[3,1,0],[3,3,0],[1,3,0],
                         [1,1,1],[3,1,1],[3,3,1],[1,3,1]]),
                 faces([[4,3,2,1,4,-9,10,11,12,9],
                        [5,6,7,8,5,-16,15,14,13,16],
                        [1,2,6,5],[2,3,7,6],[3,4,8,7],[4,1,5,8],
                        [10,9,13,14],[11,10,14,15],[12,11,15,16],
                        [9,12,16,13]])), 12.0, 16, 10, 0).

% Frusta between the latitudes of a globe.
globe_volume(_, _, 0, _, _, _, 0.0) :-
    !.
globe_volume(Lat1, Step, N, R, C, A, V) :-
    Lat2 is Lat1+Step,
    R1 is R*cos(Lat1*pi/180),
    R2 is R*cos(Lat2*pi/180),
    H is C*(sin(Lat2*pi/180) - sin(Lat1*pi/180)),
    N1 is N-1,
    globe_volume(Lat2, Step, N1, R, C, A, V1),
    V is V1 + A*H/3*(R1*R1 + R1*R2 + R2*R2).

% What `check` says of Term alone.
checked(Term, Segment) :-
    in_new_world(( add_primitive(Term, _),
                   complete_segments,
                   check_report(Report) )),
    [Segment] = Report.segments.

sound(Term, Volume) :-
    checked(Term, Segment),
    faultless(Segment),
    near(Segment.volume, Volume).

faultless(Segment) :-
    dict_pairs(Segment.faults, _, []),
    dict_pairs(Segment.remarks, _, Remarks),
    subtract(Remarks, [nested_shell-_], []),
    Segment.border_edges =:= 0.

near(A, B) :-
    abs(A-B) =< 1.0e-11*(abs(A)+abs(B)).

refused(Term, What) :-
    catch(primitive_shape(Term, _, _, _),
          error(model_error(primitive(What0, _)), _), true),
    nonvar(What0),
    What0 = What.

point_distance(point(X1, Y1, Z1), point(X2, Y2, Z2), D) :-
    D is sqrt((X1-X2)**2 + (Y1-Y2)**2 + (Z1-Z2)**2).

% The loops of a polygon's edges, by the squares of twice their areas.
outer_first(S, Es) :-
    edge_loops(S, Es, Loops),
    maplist(loop_square(S), Loops, [First|Others]),
    forall(member(Other, Others), Other < First).

edge_loops(_, [], []).
edge_loops(S, [E|Es], [[E|Loop]|Loops]) :-
    e(S, E, From, To, _),
    loop_goes_on(S, Es, To, From, Loop, Rest),
    edge_loops(S, Rest, Loops).

loop_goes_on(_, Es, At, At, [], Es) :-
    !.
loop_goes_on(S, [E|Es], At, From, [E|Loop], Rest) :-
    e(S, E, At, To, _),
    loop_goes_on(S, Es, To, From, Loop, Rest).

loop_square(S, Es, Square) :-
    foldl(edge_area(S), Es, n(0,0,0), n(A,B,C)),
    Square is A*A+B*B+C*C.

edge_area(S, E, n(A0,B0,C0), n(A,B,C)) :-
    e(S, E, V1, V2, _),
    v(S, V1, X1, Y1, Z1),
    v(S, V2, X2, Y2, Z2),
    A is A0+Y1*Z2-Z1*Y2,
    B is B0+Z1*X2-X1*Z2,
    C is C0+X1*Y2-Y1*X2.

:- begin_tests(primitive_solids).

%   Chords pass the inner corners of the rings but for rounding.

test(turned_rings,
     [forall(member(Degrees, [301.9460226322922,17,33,71,123]))]) :-
    sound(at([rotate(axis(-876.5, -752, 516), Degrees)],
             hollow_cylinder(radius(1.2), inner(0.6), height(0.73),
                             facets(12))),
          2.3652).
test(closed_form, forall(solid(Term, Volume, Vertices, Polygons, Euler))) :-
    checked(Term, Segment),
    faultless(Segment),
    near(Segment.volume, Volume),
    Segment.vertices =:= Vertices,
    Segment.polygons =:= Polygons,
    findall(E, ( member(Shell, Segment.shells), Shell.closed == true,
                 E = Shell.euler ),
            Es),
    sum_list(Es, Euler).
% Of the loops of a polygon the first is the one round all others.
test(first_loop_is_outer, forall(solid(Term, _, _, _, _))) :-
    in_new_world(( add_primitive(Term, S),
                   forall(( p(S, P, Es), \+ outer_first(S, Es) ),
                          ( format(user_error, '~w: ~w~n', [Term,P]), fail ))
                 )).
test(mirrored, forall(( solid(Term, V, _, _, _),
                        member(Step-F, [ mirror(x)-1, mirror(y)-1,
                                         mirror(z)-1, scale(-1)-1,
                                         mirror(normal(1,2,3))-1,
                                         scale(2,-1,3)-6,
                                         matrix([[0,1,0,3], [1,0,0,4],
                                                 [0.5,0,2,5]])-2
                                       ]) ))) :-
    W is F*V,
    sound(at([Step], Term), W).
% All walls meet in the apex.
test(pyramid_with_a_hole, Remarks == [pinched_vertex-1]) :-
    checked(pyramid(outline([[0,0],[10,0],[10,10],[0,10]]), height(3),
                    holes([[[2,2],[8,2],[8,8],[2,8]]])), Segment),
    dict_pairs(Segment.faults, _, []),
    dict_pairs(Segment.remarks, _, Remarks),
    near(Segment.volume, 64.0).
test(outline_touching_the_axis,
     [ forall(member(r(Degrees, N, Expected), [ r(360, 8, [pinched_vertex-1]),
                                                r(90, 3, []),
                                                r(200, 5, []) ])),
       true(Remarks == Expected) ]) :-
    checked(turning(outline([[0,0],[2,-1],[2,1]]), angle(Degrees), facets(N)),
            Segment),
    dict_pairs(Segment.faults, _, []),
    dict_pairs(Segment.remarks, _, Remarks),
    Area is N/2*sin(Degrees/N*pi/180),
    near(Segment.volume, 4*Area*4/3).
test(mirrored_surface, Chains == [[1,4,3,2]]) :-
    primitive_shape(at([mirror(x)], rectangle(size(1,2))), _, _, Chains).
test(not_mirrored_twice, Chains == [[1,2,3,4]]) :-
    primitive_shape(at([mirror(x), scale(1,-1,1)], rectangle(size(1,2))), _,
                    _, Chains).
test(curve_keeps_its_way, Chains == [[1,2]]) :-
    primitive_shape(at([mirror(x)], line(from(1,0,0), to(2,0,0))), _, _,
                    Chains).

%   joins(Term, X1-Y1, X2-Y2): of Term, scaled by 2 and 1/2 on its way up, an
%   edge goes from the first place below to the second above.

joins(Term, X1-Y1, X2-Y2) :-
    X is X2*2,
    Y is Y2*0.5,
    in_new_world(( add_primitive(Term, S),
                   v(S, V, X1, Y1, 0.0), v(S, W, X, Y, 1.0),
                   ( e(S, _, V, W, _) ; e(S, _, W, V, _) ) )),
    !.

% Both walls have diagonals of one length; that of a hole is the other one, as
% seen from inside the solid.
test(equal_diagonals, [ forall(member(P-Q, [(4.0-10.0)-(0.0-6.0),
                                            (1.0-2.5)-(0.0-1.5)])) ]) :-
    Term = prism(outline([[-20,-20],[20,-20],[4,10],[0,6]]),
                 holes([[[1,2.5],[0,1.5],[2,0]]]), height(1), scale(2,0.5),
                 slices(1)),
    assertion(joins(Term, Q, P)),
    assertion(\+ joins(Term, P, Q)).

:- end_tests(primitive_solids).

:- begin_tests(placing).

moved_to(Steps, X, Y, Z) :-
    primitive_shape(at(Steps, line(from(0,0,0), to(1,2,3))), _, [_, P], _),
    point_distance(P, point(X, Y, Z), D),
    D < 1.0e-14.

test(any_axis) :-
    moved_to([rotate(axis(1,1,1), 120)], 3, 1, 2).
test(axis_of_any_length) :-
    moved_to([rotate(axis(1.0e-80,1.0e-80,1.0e-80), 120)], 3, 1, 2).
test(axis_is_an_axis, forall(member(A-V, [ x-axis(7,0,0), y-axis(0,2,0),
                                           z-axis(0,0,0.1) ]))) :-
    primitive_shape(at([rotate(A, 33)], box(size(1,2,3))), _, Ps, _),
    primitive_shape(at([rotate(V, 33)], box(size(1,2,3))), _, Qs, _),
    forall(nth1(I, Ps, P), ( nth1(I, Qs, Q), point_distance(P, Q, D),
                             D < 1.0e-14 )).
test(any_line) :-
    moved_to([rotate(from(1,2,0), to(1,2,5), 70)], 1, 2, 3).
test(half_turn_about_a_line) :-
    moved_to([rotate(from(2,0,0), to(2,1,0), 180)], 3, 2, -3).
test(scaled) :-
    moved_to([scale(2), scale(1,2,-1)], 2, 8, -6).
test(mirror_in_a_plane) :-
    moved_to([mirror(normal(1,-1,0))], 2, 1, 3).
test(matrix) :-
    moved_to([matrix([[1,0,0,10], [0,0,1,20], [0,1,0,30]])], 11, 23, 32).
test(no_step, forall(member(Step, [ scale(0), scale(1,0,1), mirror(w),
                                    mirror(normal(0,0,0)), rotate(w, 1),
                                    rotate(axis(0,0,0), 1),
                                    rotate(from(1,1,1), to(1,1,1), 5),
                                    rotate(x, a), scale(a), translate(1,2),
                                    matrix([[1,0,0,0], [0,1,0,0]]),
                                    matrix([[1,2,3,0], [4,5,6,0],
                                            [7,8,9,0]]), turn
                                  ]))) :-
    refused(at([Step], box(size(1,1,1))), no_step(Step)).
test(too_far) :-
    refused(at([translate(1.0e30,0,0)], box(size(1,1,1))), collapsed).
test(too_large) :-
    refused(at([scale(1.0e300), scale(1.0e300)], box(size(1,1,1))),
            too_large).

:- end_tests(placing).

:- begin_tests(tolerance).

% The chords of N facets are within T, those of N-1 are not.
test(chords, forall(( member(R, [0.001, 1, 7.3, 1.0e6]),
                      member(K, [1.0e-9, 1.0e-6, 1.0e-3, 0.01, 0.3]),
                      member(D, [360, 90, 200.5]) ))) :-
    T is R*K,
    chord_facets(R, T, D, N),
    Sagitta is R*2*sin(D*pi/720/N)**2,
    Sagitta =< T*(1+1.0e-4),
    Least is floor(D/180)+1,
    (   N =:= Least
    ->  true
    ;   R*2*sin(D*pi/720/(N-1))**2 > T*(1-1.0e-4)
    ).
% The midpoints of edges and polygons are within T of the smooth surface.
test(respected, forall(member(Term, [ sphere(radius(2), tolerance(0.01)),
                                      hemisphere(radius(2), tolerance(0.01))
                                    ]))) :-
    primitive_shape(Term, _, Ps, Chains),
    Table =.. [t|Ps],
    forall(( member(Chain, Chains), length(Chain, N), N =< 4,
             append(_, [A|Cs], Chain), member(B, Cs) ),
           ( arg(A, Table, point(X1,Y1,Z1)),
             arg(B, Table, point(X2,Y2,Z2)),
             2 - sqrt((X1+X2)**2 + (Y1+Y2)**2 + (Z1+Z2)**2)/2 =< 0.01 )).
test(in_units_of_the_model, N1 == N2) :-
    primitive_shape(cylinder(radius(10), height(1), tolerance(0.1)), _, _, P),
    primitive_shape(at([rotate(x, 10), scale(10), translate(1,2,3)],
                       cylinder(radius(1), height(1), tolerance(0.1))), _, _,
                    Q),
    length(P, N1),
    length(Q, N2).
test(finer, true(N1 < N2)) :-
    primitive_shape(torus(radius(2), tube(1), tolerance(0.1)), _, _, P),
    primitive_shape(torus(radius(2), tube(1), tolerance(0.01)), _, _, Q),
    length(P, N1),
    length(Q, N2).
test(both) :-
    refused(circle(radius(1), facets(9), tolerance(1)),
            both(facets, tolerance)).
test(absurd, forall(member(T, [1.0e-300, 5.0e-324, 1.0e-17]))) :-
    refused(circle(radius(1), tolerance(T)), too_many(_)).
test(too_many_facets) :-
    refused(sphere(radius(1), facets(1_000_000_000)), wrong_argument(_, _)).

:- end_tests(tolerance).

:- begin_tests(bezier).

flat_patch([[0,0,0],[1,0,0],[2,0,0],[3,0,0], [0,1,0],[1,1,0],[2,1,0],[3,1,0],
            [0,2,0],[1,2,0],[2,2,0],[3,2,0], [0,3,0],[1,3,0],[2,3,0],[3,3,0]]).

pot(Term) :-
    in_new_world(( absolute_file_name(sanggwan('facts/primitives.pl'), File),
                   read_model(File, [], _),
                   once(segment(_, _, named(pot, at(_, Term)))) )).

test(flat) :-
    flat_patch(Ps),
    checked(bezier(points(Ps), facets(4)), Segment),
    Segment.vertices =:= 25,
    Segment.polygons =:= 32,
    Segment.border_edges =:= 16,
    near(Segment.area, 9).
test(points_are_on_the_surface) :-
    flat_patch(Ps),
    primitive_shape(bezier(points(Ps), facets(3)), surface, Points, _),
    memberchk(point(1.0,2.0,0.0), Points).
test(one_surface) :-
    pot(Term),
    checked(Term, Segment),
    faultless(Segment),
    [Shell] = Segment.shells,
    Shell.closed == true,
    Shell.euler =:= 2,
    Shell.volume > 2.5,
    Segment.vertices =:= 31*24 + 15*24 + 2 + 24.
test(borders_either_way, true(N =:= 16+16-4)) :-
    % the second patch begins at the other end of the common side
    Ps = [[0,0,0],[1,0,1],[2,0,1],[3,0,0.3], [0,1,0],[1,1,0],[2,1,0],[3,1,0],
          [0,2,0],[1,2,0],[2,2,0],[3,2,0], [0,3,0],[1,3,0],[2,3,0],[3,3,0],
          [0,-1,0],[1,-1,0],[2,-1,0],[3,-1,0],
          [0,-2,0],[1,-2,0],[2,-2,0],[3,-2,0],
          [0,-3,0],[1,-3,0],[2,-3,0],[3,-3,0]],
    primitive_shape(bezier(points(Ps), facets(3),
                           patches([[1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16],
                                    [4,3,2,1,20,19,18,17,24,23,22,21,28,27,
                                     26,25]])), _, Points, _),
    length(Points, N).
test(clash) :-
    flat_patch(Ps),
    numlist(1, 16, L),
    refused(bezier(points(Ps), patches([L,L])), patches_clash(1, 2)).
test(collapsed_side, Lengths-N == [3]-6) :-
    Ps = [[0,0,0],[0,0,0],[0,0,0],[0,0,0], [0,1,0],[1,1,0],[2,1,0],[3,1,0],
          [0,2,0],[1,2,0],[2,2,0],[3,2,0], [0,3,0],[1,3,0],[2,3,0],[3,3,0]],
    primitive_shape(bezier(points(Ps), facets(2)), _, Points, Chains),
    findall(L, ( member(C, Chains), length(C, L) ), Ls),
    sort(Ls, Lengths),
    length(Chains, N),
    length(Points, 7).
% Points between the corners of a triangle are within T of some point of the
% patch: those of the cell, taken finely.
test(tolerance, true(Worst =< 0.01)) :-
    Ps = [[0,0,0],[1,0,2],[2,0,-1],[3,0,0], [0,1,1],[1,1,3],[2,1,0],[3,1,2],
          [0,2,0],[1,2,-2],[2,2,1],[3,2,0], [0,3,1],[1,3,0],[2,3,2],[3,3,0]],
    in_new_world(( add_primitive(bezier(points(Ps), tolerance(0.01)), S),
                   findall(D, centre_distance(S, D), Ds) )),
    max_list(Ds, Worst).

% The middle of a diagonal and the surface at the middle of its cell.
centre_distance(S, D) :-
    smooth_surface(S, Part, Surface),
    face_of(S, P, curved(Part, [U1-U2, V1-V2])),
    p(S, P, Es),
    U is (U1+U2)/2,
    V is (V1+V2)/2,
    surface_point(Surface, U, V, Point),
    findall(D0, ( member(E, Es),
                  e(S, E, A, B, _),
                  v(S, A, X1, Y1, Z1),
                  v(S, B, X2, Y2, Z2),
                  X is (X1+X2)/2,
                  Y is (Y1+Y2)/2,
                  Z is (Z1+Z2)/2,
                  point_distance(point(X,Y,Z), Point, D0) ),
            Ds),
    min_list(Ds, D).

:- end_tests(bezier).

:- begin_tests(faces).

round_term(cylinder(radius(2.0,1.0), height(3), shift(1,2))).
round_term(cone(radius(2), height(3))).
round_term(cone(radius(2), top(1), height(3), shift(0,1))).
round_term(cone(radius(2.0,1.0), top(1.0,1.0), height(3))).
round_term(hollow_cylinder(radius(2), inner(1), height(3))).
round_term(turning(outline([[0,0],[3,1],[3,2],[1,5],[0,5]]))).
round_term(turning(outline([[1,0],[3,1],[3,2],[1,5]]), angle(100))).
round_term(sphere(radius(1,2,3))).
round_term(egg(radius(1), up(2), down(1))).
round_term(hemisphere(radius(2))).
round_term(torus(radius(3), tube(1))).

% Every corner of a curved facet is on its surface, at an end of its ranges.
test(on_the_surface, forall(round_term(Term))) :-
    Placed = named(x, at([rotate(axis(1,2,3), 40), scale(1,-2,1),
                          translate(1,2,3)], Term)),
    in_new_world(( add_primitive(Placed, S),
                   forall(curved_corner(S, What, Surface, Point),
                          corner_on(What, Surface, Point)),
                   once(curved_corner(S, _, _, _)) )).
test(flat_faces, all(What == [base,top,side(1),side(2),side(3),side(4)])) :-
    in_new_world(( add_primitive(box(size(1,1,1)), S),
                   findall(W, face_of(S, _, W), Whats) )),
    member(What, Whats).
test(one_face, What == curved(side, [90.0-180.0])) :-
    in_new_world(( add_primitive(cylinder(radius(1), height(1), facets(4)),
                                 S),
                   face_of(S, 4, What) )).
test(generators, all(P == [3,4,5])) :-
    in_new_world(( add_primitive(cylinder(radius(1), height(1), facets(3)),
                                 S),
                   findall(P0, face_of(S, P0, curved(side, _)), Ps) )),
    member(P, Ps).
test(axis_and_radius, Surface == cylinder(point(1.0,0.0,0.0),
                                          vector(0.0,2.0,0.0),
                                          vector(-2.0,0.0,0.0),
                                          vector(0.0,0.0,3.0))) :-
    in_new_world(( add_primitive(at([rotate(z,90), translate(1,0,0)],
                                    cylinder(radius(2), height(3))), S),
                   smooth_surface(S, side, Surface) )).
test(not_of_others, fail) :-
    in_new_world(( assert_fact(segment(1, solid, cube)),
                   face_of(1, _, _) )).

curved_corner(S, What, Surface, point(X, Y, Z)) :-
    face_of(S, P, What),
    What = curved(Part, _),
    once(smooth_surface(S, Part, Surface)),
    p(S, P, Es),
    member(E, Es),
    e(S, E, V, _, _),
    v(S, V, X, Y, Z).

corner_on(curved(_, [T1-T2]), Surface, Point) :-
    member(T, [T1, T2]),
    member(H, [0.0, 1.0]),
    close_to(Surface, T, H, Point),
    !.
corner_on(curved(_, [T1-T2, S1-S2]), Surface, Point) :-
    member(T, [T1, T2]),
    member(S, [S1, S2]),
    close_to(Surface, T, S, Point),
    !.

close_to(Surface, T, H, Point) :-
    surface_point(Surface, T, H, Point2),
    point_distance(Point, Point2, D),
    D < 1.0e-12.

:- end_tests(faces).

:- begin_tests(sweep).

% Random primitives, placed at random, through `check`.
test(random, [ setup(set_random(seed(1988))), forall(between(1, 150, I)) ]) :-
    random_term(I, Term),
    random_between(-9, 9, A),
    random_between(1, 359, D),
    random_member(F, [-3, -0.5, 0.25, 2]),
    random_member(G, [-1, 1, 1.5]),
    Placed = at([rotate(axis(A, 2, 5), D), scale(F, G, 1),
                 translate(A, D, F)], Term),
    checked(Term, Segment),
    checked(Placed, Moved),
    told_if_wrong(Term, Segment, Moved),
    Volume is abs(F*G)*Segment.volume,
    Segment.volume > 0.0,
    abs(Moved.volume - Volume) < 1.0e-9*Volume.

told_if_wrong(Term, Segment, Moved) :-
    (   faultless(Segment),
        faultless(Moved)
    ->  true
    ;   format(user_error, "~p: ~p ~p~n", [Term, Segment.faults,
                                          Moved.faults]),
        fail
    ).

length_of(R) :-
    random_between(1, 40, N),
    R is N/8.

random_term(I, Term) :-
    K is I mod 9,
    random_between(3, 17, N),
    random_between(3, 9, M),
    maplist(length_of, [A, B, C]),
    random_between(-8, 8, X),
    random_between(-8, 8, Y),
    once(random_term(K, N, M, A, B, C, X, Y, Term)).

random_term(0, N, _, A, B, C, X, Y,
            cylinder(radius(A,B), height(C), shift(X,Y), facets(N))).
random_term(1, N, _, A, B, C, X, Y,
            cone(radius(A), top(B), height(C), shift(X,Y), facets(N))).
random_term(2, N, _, A, B, C, X, Y,
            hollow_cylinder(radius(R), inner(A), height(C), shift(X,Y),
                            facets(N))) :-
    R is A+B.
random_term(3, N, M, A, B, C, _, _,
            sphere(radius(A,B,C), facets(N), bands(M))).
random_term(4, N, M, A, B, _, _, _,
            torus(radius(R), tube(A), facets(N), sides(M))) :-
    R is A+B.
random_term(5, N, M, A, B, C, _, _,
            egg(radius(A), up(B), down(C), facets(N), bands(K))) :-
    K is 2*M.
random_term(6, N, M, A, B, C, _, _,
            turning(outline(Points), angle(D), facets(N))) :-
    star(M, A, B, C, Points),
    D is 360*(1 - (M mod 3)/4).
random_term(7, _, M, A, B, C, X, Y,
            prism(outline(Points), height(C), shift(X,Y))) :-
    star(M, A, B, 0, Points).
random_term(8, _, M, A, B, C, X, Y,
            pyramid(outline(Points), height(C), shift(X,Y))) :-
    star(M, A, B, 0, Points).

% A star of 2*M points, right of the axis.
star(M, A, B, C, Points) :-
    N is 2*M,
    findall([X, Y],
            ( between(1, N, I),
              T is I*360/N,
              exact_sin_cos(T, Sin, Cos),
              (   I mod 2 =:= 0 -> R = A ; R = B ),
              X is C + max(A, B) + R*Cos,
              Y is R*Sin ),
            Points).

:- end_tests(sweep).

:- begin_tests(documented_primitives).

% The rows of the table in docs/model_files.md: name and example.
documented(Name, Example) :-
    absolute_file_name(sanggwan('docs/model_files.md'), File),
    read_file_to_string(File, Text, [encoding(utf8)]),
    split_string(Text, "\n", "", Lines),
    member(Line, Lines),
    split_string(Line, "|", " ", ["", Form, Kind, Cell, ""]),
    memberchk(Kind, ["solid", "surface", "curve"]),
    split_string(Form, "`(", "", ["", Name0|_]),
    atom_string(Name, Name0),
    split_string(Cell, "`", "", ["", Example0|_]),
    Example = Kind-Example0.

test(all, Names == Documented) :-
    findall(Name, primitive(Name), Names0),
    sort(Names0, Names),
    findall(Name, documented(Name, _), Documented0),
    sort(Documented0, Documented).
test(examples, forall(( documented(Name, Kind-Text), Name \== bezier ))) :-
    term_string(Term, Text),
    primitive_name(Term, Name),
    primitive_shape(Term, Kind0, _, _),
    atom_string(Kind0, Kind).
test(model_of_all, Left == []) :-
    in_new_world(( absolute_file_name(sanggwan('facts/primitives.pl'), File),
                   read_model(File, [], _),
                   complete_segments,
                   check_report(Report),
                   findall(Name, ( segment(_, _, Term),
                                   primitive_name(Term, Name) ),
                           Shown) )),
    Report.faults =:= 0,
    Report.remarks =:= 0,
    findall(Name, ( primitive(Name), \+ memberchk(Name, Shown) ), Left).

:- end_tests(documented_primitives).
