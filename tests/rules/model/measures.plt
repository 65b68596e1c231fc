/* How large segments are, and what touches what. */
:- module(test_measures, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(csg/provenance)).
:- use_module(rules(model/measures)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

box(X, Y, Z, Size, S) :-
    add_primitive(at([translate(X,Y,Z)], box(size(Size,Size,Size))), S).

:- begin_tests(measures).

test(box, V-A == 6.0-22.0) :-
    in_new_world(( add_primitive(box(size(1,2,3)), S),
                   volume(S, V),
                   area(S, A) )).
test(each_root, Volumes == [1-1.0,2-8.0]) :-
    in_new_world(( box(0, 0, 0, 1, _), box(5, 0, 0, 2, _),
                   findall(S-V, volume(S, V), Volumes) )).
test(surface_has_no_volume, Found == []) :-
    in_new_world(( add_primitive(rectangle(size(1,1)), S),
                   findall(V, volume(S, V), Found) )).
test(no_such_segment, fail) :-
    in_new_world(area(7, _)).
test(box_of_points, [Low,High] == [point(5.0,0.0,0.0),point(7.0,2.0,2.0)]) :-
    in_new_world(( add_primitive(at([translate(6,1,0)], box(size(2,2,2))), S),
                   bounding_box(S, Low, High) )).

%   A node is measured by its boundary, which is not there afterwards.

node_world :-
    box(0, 0, 0, 2, _),
    box(1, 0, 0, 2, _),
    assert_fact(segment(3, solid, union([1,2]))).

test(node, V-Rows == 12.0-0) :-
    in_new_world(( node_world, volume(3, V),
                   aggregate_all(count, v(3,_,_,_,_), Rows) )).
test(node_is_the_root, Volumes == [3-12.0]) :-
    in_new_world(( node_world, findall(S-V, volume(S, V), Volumes) )).
test(operand, V == 8.0) :-
    in_new_world(( node_world, volume(1, V) )).

test(touching, Pairs == [1-2]) :-
    in_new_world(( box(0, 0, 0, 2, _), box(2, 0, 0, 2, _), box(9, 0, 0, 2, _),
                   findall(A-B, touches(A, B), Pairs) )).
test(either_way, Found == [2,1]) :-
    in_new_world(( box(0, 0, 0, 2, _), box(1, 0, 0, 2, _),
                   findall(B, touches(1, B), Found1),
                   findall(B, touches(2, B), Found2),
                   append(Found1, Found2, Found) )).
test(inside_is_no_touch, fail) :-
    in_new_world(( box(0, 0, 0, 4, _), box(1, 1, 1, 1, _), touches(_, _) )).
test(near_is_none, fail) :-
    in_new_world(( box(0, 0, 0, 2, _), box(2.001, 0, 0, 2, _),
                   touches(1, 2) )).
test(after_cutting, Lines-Pairs == Lines2-[1-2]) :-
    in_new_world(( box(0, 0, 0, 2, _), box(1, 1, 1, 2, _), penetrate,
                   aggregate_all(count, line(_,_,_,_,_,_,_,_,_), Lines),
                   findall(A-B, touches(A, B), Pairs),
                   aggregate_all(count, line(_,_,_,_,_,_,_,_,_), Lines2) )).

%   Of a difference the hole's faces are of the second operand alone; of a tree
%   within it, of that tree and of its leaf.

test(operands_of_faces, Operands == [1,2,3,4]) :-
    in_new_world(( nested, evaluate(5),
                   findall(O, operand_face(5, _, O), Os),
                   sort(Os, Operands) )).
test(faces_of_the_hole, Equal == true) :-
    in_new_world(( nested, evaluate(5),
                   faces(4, Hole), faces(2, Two), faces(3, Three),
                   union(Two, Three, Both0),
                   sort(Both0, Both),
                   (   Hole == Both, Hole \== []
                   ->  Equal = true
                   ;   Equal = Hole-Both
                   ) )).
test(edges_between) :-
    in_new_world(( nested, evaluate(5),
                   findall(E, ( operand_edge(5, E, 1), operand_edge(5, E, 4) ),
                           Between) )),
    Between \== [].

nested :-
    box(0, 0, 0, 9, _),
    box(-1, 3, 3, 3, _),
    box(1, 4, 4, 3, _),
    assert_fact(segment(4, solid, union([2,3]))),
    assert_fact(segment(5, solid, difference([1,4]))).

faces(Operand, Faces) :-
    findall(P, operand_face(5, P, Operand), Faces0),
    sort(Faces0, Faces).

:- end_tests(measures).
