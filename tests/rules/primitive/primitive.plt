:- module(test_primitive, []).
:- use_module(library(plunit)).
:- use_module(rules(angle)).
:- use_module(rules(primitive/primitive)).
:- use_module(rules(polygon/polygon_list)).

% The directed edges of all polygons, and whether each has its opposite.
shape_edges(Chains, Edges) :-
    maplist(vertex_list_edges, Chains, Lists),
    append(Lists, Edges).

closed(Edges) :-
    sort(0, @<, Edges, Set),
    same_length(Edges, Set),
    forall(member(A-B, Edges), memberchk(B-A, Set)).

% Six times the volume, by the fan of each polygon from its first vertex.
volume6(Points, Chains, Volume) :-
    Table =.. [t|Points],
    foldl(fan_volume(Table), Chains, 0.0, Volume).

fan_volume(Table, [A|Vs], Volume0, Volume) :-
    foldl(tetrahedron(Table, A), Vs, Volume0-none, Volume-_).

tetrahedron(_, _, V, Sum-none, Sum-V) :-
    !.
tetrahedron(Table, A, C, Sum0-B, Sum-C) :-
    arg(A, Table, point(X1, Y1, Z1)),
    arg(B, Table, point(X2, Y2, Z2)),
    arg(C, Table, point(X3, Y3, Z3)),
    Sum is Sum0 + X1*(Y2*Z3 - Z2*Y3) - Y1*(X2*Z3 - Z2*X3)
                + Z1*(X2*Y3 - Y2*X3).

solid(box(size(2, 3, 4)), 24.0).
solid(pyramid(base(2, 3), height(4)), 8.0).
solid(cylinder(radius(1), height(4), facets(4)), 8.0).
solid(cone(radius(1), height(3), facets(4)), 2.0).
solid(cone(radius(2), top(1), height(3), facets(4)), 14.0).

% The area of a regular polygon of radius 1 with N corners.
ring_area(N, Area) :-
    Area is N/2*sin(2*pi/N).

refused(Term, What) :-
    catch(primitive_shape(Term, _, _, _),
          error(model_error(primitive(What0, _)), _), true),
    What == What0.

%   nested_inferences(N, Inferences): of a box in N placings.

nested_inferences(N, Inferences) :-
    numlist(1, N, Is),
    foldl([_,T,at([translate(1,0,0)],T)]>>true, Is, box(size(1,1,1)), Term),
    statistics(inferences, I0),
    primitive_shape(Term, solid, _, _),
    statistics(inferences, I1),
    Inferences is I1-I0.

:- begin_tests(primitive).

test(nested, true(Many < 5*Few)) :-
    nested_inferences(200, Few),
    nested_inferences(800, Many).

test(closed, forall(solid(Term, _))) :-
    primitive_shape(Term, solid, _, Chains),
    shape_edges(Chains, Edges),
    closed(Edges).
test(outward, forall(solid(Term, Volume))) :-
    primitive_shape(Term, solid, Points, Chains),
    volume6(Points, Chains, V6),
    abs(V6/6 - Volume) < 1.0e-12.
test(outward_when_placed, forall(solid(Term, Volume))) :-
    Placed = at([rotate(x, 33), rotate(z, -71.5), translate(5, -6, 7)],
                Term),
    primitive_shape(Placed, solid, Points, Chains),
    volume6(Points, Chains, V6),
    abs(V6/6 - Volume) < 1.0e-9.
test(many_facets) :-
    primitive_shape(cylinder(radius(1), height(2), facets(100)), solid,
                    Points, Chains),
    volume6(Points, Chains, V6),
    ring_area(100, Area),
    abs(V6/6 - 2*Area) < 1.0e-9,
    length(Points, 200),
    length(Chains, 102).
test(caps_are_polygons) :-
    primitive_shape(cylinder(radius(1), height(2), facets(7)), _, _,
                    [Base, Cap|Sides]),
    length(Base, 7),
    length(Cap, 7),
    length(Sides, 7).
test(stands_on_z_0, Zs == [0.0, 3.0]) :-
    primitive_shape(cylinder(radius(1), height(3)), _, Points, _),
    setof(Z, X^Y^member(point(X, Y, Z), Points), Zs).
test(default_facets) :-
    primitive_shape(cone(height(1), radius(1)), _, Points, _),
    length(Points, 41).
test(rectangle, Kind-Chains == surface-[[1,2,3,4]]) :-
    primitive_shape(rectangle(size(1, 2)), Kind, _, Chains).
test(line, Kind-Points == curve-[point(0.0,0.0,0.0), point(1.0,2.0,3.0)]) :-
    primitive_shape(line(from(0,0,0), to(1,2,3)), Kind, Points, _).

test(steps_left_to_right, Points == [point(1.0,1.0,0.0),
                                     point(1.0,2.0,0.0)]) :-
    primitive_shape(at([rotate(z, 90), translate(1, 1, 0)],
                       line(from(0,0,0), to(1,0,0))), _, Points, _).
test(inner_steps_first, Points == [point(0.0,1.0,0.0), point(0.0,2.0,0.0)]) :-
    primitive_shape(at([rotate(z, 90)],
                       at([translate(1, 0, 0)],
                          line(from(0,0,0), to(1,0,0)))), _, Points, _).
test(named, Kind-Points == curve-[point(1.0,0.0,0.0), point(2.0,0.0,0.0)]) :-
    primitive_shape(named(pipe(1), at([translate(1, 0, 0)],
                                      line(from(0,0,0), to(1,0,0)))),
                    Kind, Points, _).
test(named_what, throws(error(model_error(primitive(unknown, ball)), _))) :-
    primitive_shape(named(pipe(1), ball), _, _, _).
test(right_handed, all(D-P == [x-point(0.0,0.0,1.0), y-point(1.0,0.0,0.0),
                               z-point(0.0,1.0,0.0)])) :-
    member(D-P0, [x-to(0,1,0), y-to(0,0,1), z-to(1,0,0)]),
    primitive_shape(at([rotate(D, 90)], line(from(0,0,0), P0)), _, [_, P], _).

test(quarters, all(S-C == [0.0-1.0, 1.0-0.0, 0.0-(-1.0), -1.0-0.0, 0.0-1.0,
                           -1.0-0.0])) :-
    member(D, [0, 90, 180, 270, 360, -90.0]),
    exact_sin_cos(D, S, C).
test(no_minus_zero, forall(member(D, [0, 90, 180, 270, 360, 540, -720]))) :-
    exact_sin_cos(D, S, C),
    S \== -0.0,
    C \== -0.0.
test(mirrored, forall(between(1, 359, D))) :-
    D2 is 90-D,
    exact_sin_cos(D, S, C),
    exact_sin_cos(D2, C, S).
test(dyadic, forall(between(1, 89, D))) :-
    exact_sin_cos(D, S, _),
    0.0 =:= S*2.0**48 - truncate(S*2.0**48).
test(equal_cylinders_share_levels) :-
    primitive_shape(cylinder(radius(1), height(2)), _, Ps, _),
    primitive_shape(at([rotate(y, 90)], cylinder(radius(1), height(2))), _,
                    Qs, _),
    setof(Y, X^Z^member(point(X, Y, Z), Ps), Ys),
    setof(Y, X^Z^member(point(X, Y, Z), Qs), Ys).

test(unknown) :-
    refused(ball(radius(1)), unknown).
test(variable) :-
    refused(_, unknown).
test(missing) :-
    refused(box(), missing(size)).
test(unknown_argument) :-
    refused(box(size(1,1,1), colour(red)), unknown_argument(colour(red))).
test(twice) :-
    refused(pyramid(base(1,1), height(1), height(2)), twice(height)).
test(flat) :-
    refused(box(size(1,1,0)),
            wrong_argument(size(1,1,0), [length,length,length])).
test(negative) :-
    refused(cone(radius(-1), height(1)), wrong_argument(radius(-1), [length])).
test(few_facets) :-
    refused(cylinder(radius(1), height(1), facets(2)),
            wrong_argument(facets(2), [facets])).
test(infinite) :-
    Inf is inf,
    refused(cylinder(radius(Inf), height(1)),
            wrong_argument(radius(Inf), [length])).
test(no_number) :-
    refused(cylinder(radius(r), height(1)),
            wrong_argument(radius(r), [length])).
test(no_step) :-
    refused(at([scale(0)], box(size(1,1,1))), no_step(scale(0))).
test(no_list) :-
    refused(at(rotate(x, 1), box(size(1,1,1))), no_list(rotate(x, 1))).
test(no_length) :-
    refused(line(from(1,1,1), to(1,1,1)), no_length).

:- end_tests(primitive).
