% covers: shading_leaf, shading_half, shading, shading_rows, span, shading_ring,
% covers: shading_segment_rows, slice, sweep, walk, crossing, flush,
% covers: shading_eye, shading_body, shading_point, primitive_facets
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(csg/csg)).
:- use_module(rules(kernel)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(shading/seen)).
:- use_module(rules(shading/shading_leaf)).
:- use_module(rules(shading/shading_scene)).
:- use_module(rules(store)).
:- use_module(tests('rules/polyhedron')).

/* Scenes of terms: where spans are, how large what is seen is, how deep. */

:- begin_tests(shading_scene).

% Goal in a world where Terms are the segments 1, 2, ...
world_of(Terms, Goal) :-
    in_new_world((
        forall(nth1(S, Terms, Term), assert_fact(segment(S, solid, Term))),
        Goal
    )).

% The picture of all roots, 10 dots to a unit, the origin in the middle.
scene(View, Scene) :-
    findall(S, root_segment(S), Roots),
    shaded_model(Roots, Model),
    shaded_eye(Model, View, Eye),
    shaded_scene(Model, Eye, place(10.0,-5.0,5.0), 100-100, Scene).

spans(Terms, View, Y, Spans) :-
    world_of(Terms, ( scene(View, Scene), scene_spans(Scene, Y, Spans) )).

% From above, from left to right.
leaves_seen(Term, Leaves) :-
    top(View),
    spans([Term], View, 50.2, Spans),
    findall(Leaf, member(span(_,_,1,Leaf,_), Spans), Leaves).

scene_spans(Scene, Y, Spans) :-
    scene_handle(Scene, Handle),
    shading_spans(Handle, Y, Spans).

% Dots that are seen of leaves whose Number is in Leaves, 4 lines a dot.
area(Terms, View, Leaves, Area) :-
    world_of(Terms,
             ( scene(View, Scene),
               aggregate_all(sum(X2-X1),
                             ( between(0, 399, I),
                               Y is (I+0.5)/4,
                               scene_spans(Scene, Y, Spans),
                               member(span(X1,X2,_,Leaf,_), Spans),
                               memberchk(Leaf, Leaves) ),
                             Sum) )),
    Area is Sum/1024.

raised(v(S,V,X,Y,Z0)) :-
    retract_fact(v(S, V, X, Y, Z0)),
    Z is Z0+1,
    assert_fact(v(S, V, X, Y, Z)).

top_eye(Phi, Rho, view(270.0,Phi,Rho,parallel)).

front(view(270.0,90.0,0.0,parallel)).
top(view(270.0,0.0,0.0,parallel)).

test(box, Spans == [span(7680,17920,1,1,3)]) :-
    front(View),
    spans([box(size(4,2,3))], View, 30.0, Spans).
test(above_box, Spans == []) :-
    front(View),
    spans([box(size(4,2,3))], View, 19.9, Spans).
test(hole_in_box, Spans == [span(7680,10240,1,1,2),span(15360,17920,1,1,2)]) :-
    top(View),
    spans([difference([box(size(4,4,3)),
                       at([translate(0,0,-1)], box(size(2,2,9)))])],
          View, 50.2, Spans).
test(notch_has_the_leaf_that_cut, Spans == [span(10240,15360,1,2,1)]) :-
    top(View),
    spans([difference([box(size(2,2,3)),
                       at([translate(0,0,2)], box(size(9,9,9)))])],
          View, 50.2, Spans).
% A hole that is filled again, flush: the filling is seen, not the plate.
test(plug, Leaves == [1,3,1]) :-
    leaves_seen(union([difference([box(size(4,4,3)), box(size(2,2,3))]),
                       box(size(2,2,3))]), Leaves).
test(plug_before_its_plate, Leaves == [2,1,2]) :-
    leaves_seen(union([box(size(2,2,3)),
                       difference([box(size(4,4,3)), box(size(2,2,3))])]),
                Leaves).
test(hole_of_a_ring, Leaves == [2,1,2,1,2]) :-
    leaves_seen(union([hollow_cylinder(radius(2),inner(1),height(2)),
                       cylinder(radius(3),height(2))]), Leaves).
test(hole_of_what_is_taken_away, Leaves == [2,4,2]) :-
    Wide = at([translate(0,0,1)], box(size(4,4,9))),
    Small = at([translate(0,0,1)], box(size(2,2,9))),
    leaves_seen(difference([box(size(4,4,3)),difference([Wide,Small]),Small]),
                Leaves).
test(flush, Spans == []) :-
    top(View),
    spans([difference([box(size(2,2,3)), box(size(2,2,3))])], View, 50.2,
          Spans).
test(in_front, Spans == [span(10240,12800,1,1,2),span(12800,17920,2,2,2)]) :-
    top(View),
    spans([box(size(2,2,2)), at([translate(1,0,1)], box(size(2,2,2)))], View,
          50.2, Spans).
test(split, Area =:= 800.0) :-
    top(View),
    area([split(box(size(4,4,4)), plane(1,1,0,0), below)], View, [1], Area0),
    Area is round(Area0*10)/10.
test(disc) :-
    top(View),
    area([sphere(radius(3),facets(32))], View, [1], Area),
    abs(Area-pi*900) < 0.5.
test(egg) :-
    front(View),
    area([egg(radius(2),up(4),down(3),facets(32))], View, [1], Area),
    abs(Area-pi*200*3.5) < 0.25.
test(cylinder) :-
    area([cylinder(radius(2),height(3),facets(32))],
         view(300.0,60.0,0.0,parallel), [1], Area),
    abs(Area - (2*20*30*sin(pi/3) + pi*400*cos(pi/3))) < 0.5.
test(hollow_cylinder) :-
    top(View),
    area([hollow_cylinder(radius(2),inner(1),height(3),facets(32))], View, [1],
         Area),
    abs(Area-pi*300) < 0.3.
test(few_facets_are_flat) :-
    top(View),
    area([cylinder(radius(2),height(3),facets(6))], View, [1], Area),
    abs(Area-600*sqrt(3)) < 4.
test(central_sphere) :-                 % a ball of 2 seen from 10
    View = view(270.0,90.0,10.0,central),
    area([sphere(radius(2),facets(32))], View, [1], Area),
    % at its nearest point, 8 away, it is shown in its own size
    Radius is 8*2/sqrt(96)*10,
    abs(Area-pi*Radius*Radius) < 0.5.
test(depth_and_normal) :-
    front(View),
    world_of([sphere(radius(2),facets(32))],
             ( scene(View, Scene),
               scene_handle(Scene, Handle),
               shading_point(Handle, 60.0, 50.0, Span, Depth,
                             vector(NX,NY,NZ)) )),
    Span = span(_,_,1,1,1),
    abs(Depth + sqrt(300)) < 1.0e-9,
    abs(NX-0.5) < 1.0e-9,
    abs(NY+sqrt(0.75)) < 1.0e-9,
    abs(NZ) < 1.0e-9.
test(mirrored) :-
    front(View),
    Cone = cone(radius(2),top(1),height(3),facets(32)),
    area([Cone], View, [1], Area1),
    area([at([mirror(x)], Cone)], View, [1], Area1).
test(torus) :-                          % from above: 4 pi R r
    top(View),
    area([torus(radius(3),tube(1),facets(24))], View, [1], Area),
    abs(Area-1200*pi) < 377/8.          % an eighth of a dot along its outline
test(torus_has_true_normals) :-
    top(View),
    world_of([torus(radius(3),tube(1),facets(24))],
             ( scene(View, Scene),
               seen_side(Scene, 85.0, 50.0, _, vector(NX,NY,NZ)) )),
    abs(NX-0.5) < 0.01,
    abs(NY) < 0.01,
    abs(NZ-sqrt(0.75)) < 0.01.
test(turning_has_true_normals) :-       % a cylinder, said as a turning
    top_eye(60.0, 0.0, View),
    world_of([turning(outline([[0,0],[3,0],[3,4],[0,4]]),facets(12))],
             ( scene(View, Scene),
               findall(X-N,
                       ( member(X, [51.3,62.7,74.1]),
                         seen_side(Scene, X, 60.0, _, N) ),
                       Seen),
               scene_leaf(Scene, leaf(1,1,1,_,Faces)) )),
    Faces == [1-ring(1),2-curved(edge(2)),3-ring(3)],
    forall(member(X-vector(NX,_,NZ), Seen),
           ( abs(NX-(X-50.0)/30) < 0.001, abs(NZ) < 1.0e-9 )).
test(turning_is_fine) :-                % seen from above: pi R^2
    top(View),
    area([turning(outline([[0,0],[4,0],[4,1],[0,1]]),facets(12))], View, [1],
         Area),
    abs(Area-1600*pi) < 3.
test(turning_of_few_facets_is_a_prism, Area =:= 3200) :-
    top(View),
    area([turning(outline([[0,0],[4,0],[4,1],[0,1]]),facets(4))], View, [1],
         Area).
test(elbow_has_true_normals) :-         % its upright piece
    front(View),
    world_of([elbow(diameter(4),radius(6),pieces(3),angle(90),facets(24))],
             ( scene(View, Scene),
               seen_side(Scene, 60.0, 45.0, _, vector(NX,_,NZ)) )),
    abs(NX-0.5) < 0.001,
    abs(NZ) < 1.0e-9.
test(bent_faces_are_triangles, Face-Bent == 2-bent(1,2,Bent1)) :-
    Bent_term = polyhedron(points([[0,0,0],[4,0,0],[4,4,0],[0,4,0],
                                   [0,0,3],[4,0,3],[4,4,4],[0,4,3]]),
                           faces([[4,3,2,1],[5,6,7,8],[1,2,6,5],[2,3,7,6],
                                  [3,4,8,7],[4,1,5,8]])),
    bent_faces(Bent_term, Bent),
    Bent = bent(_,_,Bent1),
    abs(Bent1-0.2462) < 0.001,
    top(View),
    world_of([Bent_term],
             ( scene(View, Scene),
               scene_handle(Scene, Handle),
               shading_slices(Handle, 30.0, Slices),
               scene_spans(Scene, 30.0, [span(_,_,1,1,Face)|_]) )),
    findall(1, member(slice(1,2,_,_,_,_), Slices), [1,1]).
test(flat_faces_are_faces, fail) :-
    bent_faces(polyhedron(points([[0,0,0],[1,0,0],[0,1,0],[0,0,1]]),
                          faces([[3,2,1],[1,2,4],[2,3,4],[3,1,4]])), _).
test(rows_are_a_leaf, [Spans,Rows] == [[A],[A]]) :-
    front(View),
    Term = box(size(4,2,3)),
    spans([Term], View, 30.0, Spans),
    Spans = [A],
    in_new_world(( add_primitive(Term, 1),
                   retractall_facts(segment(1, _, _)),
                   assert_fact(segment(1, solid, mesh)),
                   scene(View, Scene),
                   scene_leaf(Scene, leaf(1,1,1,rows,[])),
                   scene_spans(Scene, 30.0, Rows) )).
test(placed_rows, Rows == [span(10240,20480,2,1,3)]) :-
    front(View),
    in_new_world(( add_primitive(box(size(4,2,3)), 1),
                   retractall_facts(segment(1, _, _)),
                   assert_fact(segment(1, solid, mesh)),
                   assert_fact(segment(2, solid, at([translate(1,0,0)],1))),
                   scene(View, Scene),
                   scene_spans(Scene, 30.0, Rows) )).
test(curves_in_a_tree, error(model_error(csg(curve(2,1))), nodes(_))) :-
    in_new_world(( add_primitive(line(from(0,0,0),to(1,1,1)), 1),
                   assert_fact(segment(2, solid, union([1]))),
                   shaded_model([2], _) )).
test(near_torus) :-                     % the eye is half a unit from it
    View = view(315.0,90.0,4.5,central),
    spans([torus(radius(3),tube(1),facets(24))], View, 50.2, [_|_]).
test(leaf_behind_eye, error(geometry_error(leaf_behind_eye(1)))) :-
    world_of([sphere(radius(1),facets(24))],
             ( shaded_model([1], Model),
               shaded_scene(Model, eye(270.0,90.0,0.5,central,0.5),
                            place(10.0,-5.0,5.0), 100-100, _) )).
test(surfaces_in_a_difference,
     error(model_error(csg(surface(2,1,difference))), nodes(_))) :-
    in_new_world(( add_primitive(rectangle(size(1,1)), 1),
                   assert_fact(segment(2, solid,
                                       difference([box(size(2,2,2)),1]))),
                   shaded_model([2], _) )).
test(surfaces_united, Spans == [span(7680,17920,2,1,1)]) :-
    top(View),
    in_new_world(( add_primitive(rectangle(size(4,4)), 1),
                   assert_fact(segment(2, surface, union([1]))),
                   scene(View, Scene),
                   scene_spans(Scene, 50.2, Spans) )).
test(as_its_term, Terms == [box(size(2,2,2))]) :-
    in_new_world(( add_primitive(box(size(2,2,2)), 1),
                   top(View),
                   scene(View, Scene),
                   findall(Term, scene_leaf(Scene, leaf(_,_,_,Term,_)), Terms)
                 )).
test(edited_by_hand, Terms == [rows]) :-
    in_new_world(( add_primitive(box(size(2,2,2)), 1),
                   findall(v(1,V,X,Y,Z), v(1, V, X, Y, Z), Vertices),
                   facts_transaction(
                       forall(member(Vertex, Vertices), raised(Vertex))),
                   top(View),
                   scene(View, Scene),
                   findall(Term, scene_leaf(Scene, leaf(_,_,_,Term,_)), Terms)
                 )).
test(eye_in_model, error(geometry_error(eye_in_model(_)))) :-
    spans([box(size(4,4,4))], view(270.0,90.0,1.0,central), 50.0, _).
test(cycle, error(model_error(csg(cycle([1,2,1]))), nodes(_))) :-
    world_of([union([2]),union([1])], shaded_model([1], _)).
test(missing, error(model_error(csg(missing(1,7))), nodes(_))) :-
    world_of([union([7])], shaded_model([1], _)).
test(scan_line, error(domain_error(scan_line, 100.0))) :-
    front(View),
    spans([box(size(4,4,4))], View, 100.0, _).

:- end_tests(shading_scene).
