/* The CSG tree: nodes, evaluation, copies. */
:- module(test_csg, []).
% covers: csg_behind, csg_flat, primitive_flat
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(csg/csg)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(csg/csg_rows)).
:- use_module(rules(csg/csg_matrix)).
:- use_module(rules(kernel), [census/1, node_origins/2]).
:- use_module(rules(model/model)).
:- use_module(rules(csg/provenance)).
:- use_module(rules(store)).
:- use_module(tests('rules/polyhedron'), [polyhedron/4]).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(tests('rules/csg/csg_tree'),
              [faults/1, near/2, volume/2, with_tree/2, written/3]).

:- begin_tests(csg).

test(node, all(N-Operation-Children-Steps ==
               [ 1-leaf-[]-[], 2-leaf-[]-[], 3-difference-[1,4,2]-[scale(2)],
                 4-same-[2]-[translate(1,0,0)] ])) :-
    with_tree([ box(size(4,4,4)), sphere(radius(1), facets(8)),
                at([scale(2)], difference([1, at([translate(1,0,0)], 2), 2])) ],
              findall(n(N0,O0,C0,P0), node(N0, O0, C0, P0), Nodes)),
    sort(Nodes, Sorted),
    member(n(N,Operation,Children,Steps), Sorted).
test(roots, Roots == [3,5]) :-
    with_tree([ box(size(1,1,1)), box(size(2,2,2)), union([1,4]),
                intersection([2,1]), box(size(3,3,3)) ],
              findall(S, root_segment(S), Roots)).
test(roots_after, Roots == [5]) :-
    with_tree([ box(size(1,1,1)), box(size(2,2,2)), union([1,4]),
                intersection([2,1]), box(size(3,3,3)) ],
              root_segments_after(4, Roots)).
test(nested_get_numbers, Terms == [ 4-difference([1,6]), 5-sphere(radius(1)),
                                    6-union([7,8]), 7-at([translate(1,0,0)],1),
                                    8-box(size(1,1,2)) ]) :-
    with_tree([ box(size(4,4,4)), box(size(1,1,1)), box(size(1,1,1)),
                difference([1, union([at([translate(1,0,0)], 1),
                                      box(size(1,1,2))])]),
                sphere(radius(1)) ],
              findall(S-Term, ( between(4, 8, S), segment(S, _, Term) ),
                      Terms)).
test(second_file_is_renumbered, Children == [4,6]) :-
    Terms = [box(size(1,1,1)), difference([1, box(size(1,1,2))])],
    new_world(World),
    in_world(World,
             ( maplist(loaded(Terms), [a,b]),
               node(5, _, Children, _) )).

loaded(Terms, _) :-
    tmp_file_stream(File, Stream, [extension(pl)]),
    forall(nth1(S, Terms, Term), written(Stream, S, Term)),
    close(Stream),
    call_cleanup(load_model(File, [evaluate(false)]), delete_file(File)).

%   volume_of(Term, Volume): of segment 4; 1 is a cube of side 2, 2 the same
%   moved by 1, 3 a slab that holds the lower half of 1.

volume_of(union([1,2]), 12.0).
volume_of(intersection([1,2]), 4.0).
volume_of(difference([1,2]), 4.0).
volume_of(difference([1,2,3]), 2.0).
volume_of(union([1]), 8.0).
volume_of(intersection([1,2,3]), 2.0).
volume_of(difference([union([1,2]),3]), 6.0).
volume_of(difference([1,union([2,3])]), 2.0).
volume_of(difference([1,1]), 0.0).
volume_of(intersection([1,difference([1,1])]), 0.0).
volume_of(union([1,difference([1,1])]), 8.0).
volume_of(difference([1,difference([1,1])]), 8.0).
volume_of(at([scale(2)], difference([1,2])), 32.0).
volume_of(at([mirror(x)], difference([1,3])), 4.0).
volume_of(named(part, at([rotate(z,90)], difference([1,2]))), 4.0).
volume_of(union([1,at([translate(0,0,1)],1)]), 12.0).
volume_of(difference([1,at([mirror(x), translate(1,0,0)],2)]), 0.0).
volume_of(difference([at([translate(1,0,0)],union([1,2])),2]), 4.0).
volume_of(at([translate(5,0,0)], 1), 8.0).
volume_of(named(again, 1), 8.0).
volume_of(join([1,2]), 16.0).
volume_of(at([scale(2)], join([1,at([translate(9,0,0)],2)])), 128.0).
volume_of(union([join([1,2])]), 12.0).
volume_of(difference([join([1,2]),3]), 6.0).
volume_of(split(1, plane(0,0,1,-0.5), below), 2.0).
volume_of(split(1, plane(0,0,1,-0.5), above), 6.0).
volume_of(split(1, plane(0,0,-1,0.5), below), 6.0).
volume_of(split(1, plane(1,1,0,0), below), 4.0).
volume_of(split(1, plane(1,0,0,-9), below), 8.0).
volume_of(split(1, plane(1,0,0,-9), above), 0.0).
volume_of(split(1, plane(1,0,0,-1), below), 8.0).
volume_of(split(1, plane(1,0,0,1), below), 0.0).
volume_of(at([rotate(z,90)], split(1, plane(1,0,0,-0.5), above)), 2.0).
volume_of(split(1, 2, inside), 4.0).
volume_of(split(1, 2, outside), 4.0).
volume_of(split(union([1,2]), plane(0,0,1,-0.5), below), 3.0).

test(volume, [forall(volume_of(Term, Volume)), true(near(Found, Volume))]) :-
    with_tree([ box(size(2,2,2)), at([translate(1,0,0)], box(size(2,2,2))),
                box(size(9,9,1)), Term ],
              ( volume(4, Found), faults(Faults) )),
    (   Term = join(_)                  % its shells may meet
    ->  true
    ;   Faults =:= 0
    ).
%   A roof of two faces, and a wavy one, through a cube of side 2; a bent one
%   that is placed. Volumes below are those of prisms.

roof(sheet(points([[-2,-2,0.5],[2,-2,0.5],[2,0,1.5],[-2,0,1.5],
                   [2,2,0.5],[-2,2,0.5]]),
           faces([[1,2,3,4],[4,3,5,6]]))).

split_by_surface(surface-Roof, split(1, 2, below), 5.0) :-
    roof(Roof).
split_by_surface(surface-Roof, split(1, 2, above), 3.0) :-
    roof(Roof).
split_by_surface(surface-at([translate(0,0,5)], Roof), split(1, 2, below),
                 8.0) :-
    roof(Roof).
split_by_surface(surface-at([translate(0,0,5)], Roof), split(1, 2, above),
                 0.0) :-
    roof(Roof).
split_by_surface(surface-Roof, at([rotate(x,90)], split(1, 2, above)), 3.0) :-
    roof(Roof).
split_by_surface(surface-Roof,
                 split(1, at([translate(0,0,0.25)], 2), below), 6.0) :-
    roof(Roof).

test(split_by_surface,
     [ forall(split_by_surface(Surface, Term, Volume)),
       true((abs(Found-Volume) < 1.0e-9, Faults == 0)) ]) :-
    with_tree([ box(size(2,2,2)), Surface, Term ],
              ( volume(3, Found), faults(Faults) )).
test(faces_of_the_surface, Ps == [1,2]) :-
    roof(Roof),
    with_tree([ box(size(2,2,2)), surface-Roof, split(1, 2, below) ],
              findall(P, polygon_from(3, _, 2, P, 1), Ps0)),
    sort(Ps0, Ps).
test(not_through, error(model_error(csg(not_through(2))), _)) :-
    with_tree([ box(size(2,2,2)),
                surface-at([translate(0,0,1)], rectangle(size(1,9))),
                split(1, 2, below) ],
              true).

%   A sheet of two triangles that look opposite ways has no side behind it.

test(no_front, error(model_error(csg(no_front(2))), _)) :-
    with_tree([ box(size(2,2,2)) ],
              ( polyhedron(2, surface,
                           [p(-3,-3,1), p(3,-3,1), p(3,3,1), p(-3,3,1)],
                           [[1,2,3], [1,4,3]]),
                complete_segments,
                assert_fact(segment(3, solid, split(1, 2, below))),
                evaluate )).

%   The helper of a split is larger than the model; what is near is not.

test(near_by_the_operands_alone,
     [forall(member(Gap-Ps, [4.0e-15-5, 4.0e-13-10])), true(N == Ps)]) :-
    Turned = rotate(axis(1,2,3),33),
    Z is 1+Gap,
    with_tree([ at([Turned], box(size(1,1,1))),
                at([translate(0,0,Z),Turned], box(size(1,1,1))),
                split(union([1,2]), plane(1,0,0,0.1), below) ],
              aggregate_all(count, p(3, _, _), N)).

test(empty, N == 0) :-
    with_tree([box(size(1,1,1)), difference([1,1])],
              aggregate_all(count, v(2, _, _, _, _), N)).
test(surface_joins_a_union, Kind-Border == surface-3) :-
    with_tree([ box(size(1,1,1)),
                surface-sheet(points([[5,0,0],[6,0,0],[5,1,0]]),
                              faces([[1,2,3]])),
                union([1, 2]) ],
              ( segment(3, Kind, _),
                aggregate_all(count,
                              ( e(3, _, A, B, _), \+ e(3, _, B, A, _) ),
                              Border) )).

test(surface_outside_alone_stays, true(near(Area, 6.0+0.5))) :-
    with_tree([ box(size(1,1,1)),
                surface-at([translate(0.5,0,0.5)], rectangle(size(1,0.5))),
                union([1, 2]) ],
              ( census(Parts),
                memberchk(part(3, _, _, Area0, _, _, _, _), Parts) )),
    Area is Area0+0.25.

:- end_tests(csg).

:- begin_tests(csg_copies).

%   copied(Terms): segments that are copied, the last as a node.

copied([hollow_cylinder(radius(2), inner(1), height(3), facets(9))]).
copied([sphere(radius(1), facets(8), bands(4)), box(size(1,2,3))]).
copied([ box(size(2,2,2)), at([translate(1,0,0)], box(size(1,1,9))),
         difference([1,2]) ]).

placed([]).
placed([rotate(axis(1,2,3),77), translate(1,0,0), scale(3)]).
placed([mirror(normal(1,1,0)), translate(0.1,0.2,0.3)]).
placed([matrix([[1,2,0,4],[0,1,1,5],[1,0,1,6]])]).

%   The kernel says what the rule says: the same vertices, the same edges round
%   the polygons they come from, and triangles that cover these.

test(as_by_rule, [ forall(( copied(Terms), placed(Steps) )),
                   true(Kernel == Rule) ]) :-
    steps_matrix(Steps, Matrix0),
    rounded_matrix(Matrix0, Matrix),
    with_tree(Terms,
              ( findall(S, segment(S, _, _), Ss),
                forall(member(K, [100,101]),
                       assert_fact(segment(K, solid, copy))),
                copy_segments(Ss, Matrix, 100),
                copied_by_rule(Ss, Matrix, 101),
                copy_seen(100, Kernel),
                copy_seen(101, Rule) )).

copy_seen(S, seen(Vertices, Polygons, Edges)) :-
    findall(S0-V0-p(X,Y,Z), ( v(S, V, X, Y, Z), from_v(S, V, S0, V0) ),
            Vertices0),
    sort(Vertices0, Vertices),
    findall(S0-P0-Sense-N,
            ( from_p(S, P, S0, P0, Sense),
              aggregate_all(count, t(S, P, _, _, _, _), N) ),
            Polygons0),
    msort(Polygons0, Polygons),
    findall(S0-P0-(A0-B0-Et),
            ( p(S, P, Es), from_p(S, P, S0, P0, _), member(E, Es),
              e(S, E, A, B, Et), from_v(S, A, _, A0), from_v(S, B, _, B0) ),
            Edges0),
    msort(Edges0, Edges).

test(planes, Bad == []) :-
    with_tree([ box(size(2,3,4)),
                at([mirror(x), rotate(axis(1,2,3),20)], 1) ],
              findall(P, ( plane(2, P, A, B, C, D),
                           t(2, P, _, V1, V2, V3),
                           plane_fault(A, B, C, D, 2, [V1,V2,V3]) ), Bad)).

vertex_place(S, V, p(X, Y, Z)) :-
    v(S, V, X, Y, Z).

plane_fault(A, B, C, D, S, Vs) :-
    (   member(V, Vs),
        v(S, V, X, Y, Z),
        abs(A*X + B*Y + C*Z + D) > 1.0e-12
    ;   maplist(vertex_place(S), Vs,
                [p(X1,Y1,Z1),p(X2,Y2,Z2),p(X3,Y3,Z3)]),
        A*((Y2-Y1)*(Z3-Z1)-(Z2-Z1)*(Y3-Y1)) +
        B*((Z2-Z1)*(X3-X1)-(X2-X1)*(Z3-Z1)) +
        C*((X2-X1)*(Y3-Y1)-(Y2-Y1)*(X3-X1)) =< 0
    ).

%   A face nearly on a line when it is there: rounding may turn triangles, which
%   are found anew.

test(flattened, [forall(between(1, 40, I)), true(Faults == 0)]) :-
    Degrees is 9*I,
    with_tree([ polyhedron(points([[0,0,0],[1,0,0],[2,0,0],[2,1,0],[1,1,0],
                                   [0,1,0],[1,0.5,1]]),
                           faces([[6,5,4,3,2,1],[1,2,7],[2,3,7],[3,4,7],
                                  [4,5,7],[5,6,7],[6,1,7]])),
                at([scale(1,1,0.000001), rotate(axis(3,1,2),Degrees)], 1) ],
              faults(Faults)).
test(too_far, error(_)) :-
    with_tree([ box(size(1,1,1)), at([scale(1.0e60), scale(1.0e60)], 1) ],
              true).

:- end_tests(csg_copies).

:- begin_tests(node_origins).

%   What the boundary of a node leaves there when it goes: what was said of
%   nodes, in order, and nothing of vertices.

kept_origins(S, Kept) :-
    findall(node(N)-Origin, origin(S, node(N), Origin), Kept).

test(found, Origins == Kept) :-
    with_tree([ box(size(2,2,2)), at([translate(1,1,1)], box(size(2,2,2))),
                union([1,2]) ],
              ( evaluate(3),
                assert_fact(origin(3, node(9), operand(2))),
                once(origin(3, v(_), _)),
                node_origins(3, Origins),
                kept_origins(3, Kept) )),
    length(Kept, 3).
test(left, Left-Kept == []-Before) :-
    with_tree([ box(size(2,2,2)), at([translate(1,1,1)], box(size(2,2,2))),
                union([1,2]) ],
              ( evaluate(3),
                assert_fact(origin(3, node(9), operand(2))),
                kept_origins(3, Before),
                drop_boundary(3),
                findall(V, origin(3, v(V), _), Left),
                kept_origins(3, Kept) )).
test(none, Origins == []) :-
    with_tree([box(size(2,2,2))], node_origins(7, Origins)).

:- end_tests(node_origins).
