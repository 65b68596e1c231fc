:- module(test_primitive_faults, []).
% covers: plain
:- use_module(library(plunit)).
:- use_module(rules(message/messages)).
:- use_module(rules(message/messages_ko)).
:- use_module(rules(primitive/primitive)).
:- use_module(tests(rules/message_text), [message_text/3]).

refused(Term, What) :-
    catch(primitive_shape(Term, _, _, _),
          error(model_error(primitive(What0, _)), _), true),
    nonvar(What0),
    What0 = What.

% wrong(Term, What): a degenerate or wrong term, and what it is told.
wrong(circle(radius(0)), wrong_argument(radius(0), [length])).
wrong(circle(radius(1), facets(2)), wrong_argument(facets(2), [facets])).
wrong(circle(radius(1,2)), wrong_argument(radius(1,2), [length])).
wrong(ellipse(radius(1)), wrong_argument(radius(1), [length,length])).
wrong(cylinder(height(1)), missing(radius)).
wrong(box(), missing(size)).
wrong(cylinder(radius(), height(1)), wrong_argument(radius(), [length])).
wrong(hollow_cylinder(radius(1), inner(1), height(1)), inner_too_large).
wrong(hollow_cylinder(radius(1), inner(2), height(1)), inner_too_large).
wrong(hollow_cylinder(radius(2.0,1.0), inner(1.5,1), height(1)),
      inner_too_large).
wrong(hollow_cylinder(radius(1), inner(0.1,0.99), height(1), facets(3)),
      inner_too_large).
wrong(cone(radius(1), top(1.0,0.0), height(1)), flat_top).
wrong(sphere(radius(1), bands(1)), few(bands, 1, 2)).
wrong(egg(radius(1), up(1), down(1), bands(3)), odd(bands, 3)).
wrong(torus(radius(1), tube(1)), tube_too_large).
wrong(torus(radius(2), tube(1), sides(2)), wrong_argument(sides(2), _)).
wrong(prism(outline([[0,0],[1,0]]), height(1)), few_points(outline, 2)).
wrong(prism(outline([[0,0],[1,0],x]), height(1)),
      wrong_item(outline, 3, x, point2)).
wrong(prism(outline(x), height(1)), wrong_argument(outline(x), [points2])).
wrong(prism(outline([[0,0],[1,0],[1,1],[0,0]]), height(1)),
      same_point(outline, 1)).
wrong(prism(outline([[0,0],[1,1],[1,0],[0,1]]), height(1)),
      crossing(outline, 1, outline, 3)).
wrong(prism(outline([[0,0],[2,0],[1,0]]), height(1)), crossing(_, _, _, _)).
wrong(prism(outline([[0,0],[2,0],[2,2],[1,0],[0,2]]), height(1)),
      crossing(_, _, _, _)).
wrong(prism(outline([[0,0],[4,0],[4,4]]), height(1),
            holes([[[9,9],[9,8],[8,8]]])), hole_outside(hole(1))).
wrong(prism(outline([[0,0],[9,0],[9,9],[0,9]]), height(1),
            holes([[[1,1],[8,1],[8,8],[1,8]], [[2,2],[3,2],[3,3]]])),
      hole_in_hole(hole(2), hole(1))).
wrong(prism(outline([[0,0],[9,0],[9,9],[0,9]]), height(1),
            holes([[[1,1],[8,1],[8,9]]])), crossing(outline, 3, hole(1), _)).
wrong(prism(outline([[0,0],[1,0],[2,0]]), height(1)), crossing(_, _, _, _)).
wrong(prism(outline([[0,0],[1,0],[0,1]]), height(0)),
      wrong_argument(height(0), [length])).
wrong(prism(outline([[0,0],[1,0],[0,1]]), height(1), scale(-1)),
      wrong_argument(scale(-1), [factor])).
wrong(prism(outline([[0,0],[1,0],[0,1]]), height(1), twist(360), slices(2)),
      few_slices(2, 3)).
wrong(prism(outline([[0,0],[1,0],[0,1]]), height(1), twist(-1.0e9)),
      too_many_vertices(_, 1_000_000)).
wrong(sphere(radius(1), facets(1_000_000_000)), wrong_argument(_, [facets])).
wrong(sphere(radius(1), facets(1_000_000)), too_many_vertices(_, _)).
wrong(sphere(radius(1), tolerance(1.0e-9)), too_many_vertices(_, _)).
wrong(sphere(radius(1), tolerance(1.0e-12)), too_many(_)).
wrong(torus(radius(3), tube(1), facets(100_000)), too_many_vertices(_, _)).
wrong(turning(outline([[1,0],[2,0],[2,1],[1,1],[1,0.9],[1,0.8],[1,0.7],[1,0.6],
                       [1,0.5],[1,0.4],[1,0.3]]), facets(1_000_000)),
      too_many_vertices(_, _)).
wrong(pyramid(base(1,1), height(1), holes([[[0,0],[1,0],[0,1]]])),
      both(base, holes)).
wrong(pyramid(height(1)), missing(base)).
wrong(pyramid(base(1,1), outline([[0,0],[1,0],[0,1]]), height(1)),
      both(base, outline)).
wrong(turning(outline([[0,0],[1,0],[-1,1]])), across_axis(-1.0, 1.0)).
wrong(turning(outline([[0,0],[1,0],[1,1]])), point_on_axis(0.0)).
wrong(turning(outline([[0,0],[1,0],[0,1]]), facets(2)), few_facets(2, 3)).
wrong(turning(outline([[0,0],[1,0],[0,1]]), angle(200), facets(1)),
      few_facets(1, 2)).
wrong(turning(outline([[0,0],[1,0],[0,1]]), angle(361)),
      wrong_argument(angle(361), [turn])).
wrong(polyhedron(points([[0,0,0],[1,0,0],[0,1,0],[0,0,1]]),
                 faces([[1,3,2],[1,2,4],[2,3,4],[1,4,5]])),
      unknown_point(4, 5)).
wrong(polyhedron(points([[0,0,0],[1,0,0],[0,1,0],[0,0,1]]),
                 faces([[1,3,2],[1,2,4],[2,3,4]])), open_edge(_, _)).
wrong(polyhedron(points([[0,0,0],[1,0,0],[0,1,0],[0,0,1]]),
                 faces([[1,2,3],[1,4,2],[2,4,3],[1,3,4]])), inside_out).
wrong(polyhedron(points([[0,0,0],[1,0,0],[0,1,0],[0,0,1]]),
                 faces([[1,3,2],[1,4,2],[2,3,4],[1,4,3]])),
      edge_taken(_, _, _)).
wrong(polyhedron(points([[0,0,0]]), faces([])), no_faces).
wrong(polyhedron(points([[0,0,0]]), faces([[1,1,1]])), bad_face(1, _)).
wrong(sheet(points([[0,0,0],[1,0]]), faces([[1,2,3]])),
      wrong_item(points, 2, [1,0], point3)).
wrong(sheet(points([[0,0,0],[1,0,0],[0,1,0]]), faces([[1,2,0]])),
      wrong_item(faces, 1, [1,2,0], face)).
wrong(bezier(points([[0,0,0]])), patch_points(1, 1)).
wrong(bezier(points([[0,0,0]]),
             patches([[1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,2]])),
      unknown_point(1, 2)).

:- begin_tests(wrong_primitives).

test(refused, forall(wrong(Term, What))) :-
    refused(Term, What).
test(placed_too, forall(wrong(Term, What))) :-
    refused(named(x, at([scale(-2)], Term)), What).
test(told, forall(( wrong(Term, _), member(L, [en,ko]) ))) :-
    catch(primitive_shape(Term, _, _, _), error(model_error(What), _), true),
    message_text(L, error(model_error(What), location('a.pl', 1, 1)), Text),
    sub_string(Text, B, _, A, "\n  "),
    B > 5,
    A > 5,
    !.

:- end_tests(wrong_primitives).

