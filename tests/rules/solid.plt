:- use_module(library(plunit)).
:- use_module(rules(kernel)).
:- use_module(rules(store)).
:- use_module(rules(triangulation)).
:- use_module(rules(primitive)).

/* Solids under way: taken from segments, written as new ones. */

:- meta_predicate with_primitives(+, 0).

with_primitives(Primitives, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Primitive, Primitives),
                      add_primitive(Primitive, _)),
               complete_segments,
               Goal )).

:- begin_tests(solid).

test(take, Counts == counts(16, 12, 24)) :-
    with_primitives([box(size(2,2,2)), box(size(3,3,3))],
                    ( solid_take([2, 1, 2], Solid),
                      solid_counts(Solid, Vertices, Faces, Triangles) )),
    Counts = counts(Vertices, Faces, Triangles).
test(take_one, Vertices-Faces == 8-6) :-
    with_primitives([box(size(2,2,2)), box(size(3,3,3))],
                    ( solid_take([2], Solid),
                      solid_counts(Solid, Vertices, Faces, _) )).
test(take_nothing, Vertices-Faces-Triangles == 0-0-0) :-
    with_primitives([], ( solid_take([7], Solid),
                          solid_counts(Solid, Vertices, Faces, Triangles) )).

test(closed, error(existence_error(solid, _))) :-
    with_primitives([box(size(2,2,2))],
                    ( solid_take([1], Solid),
                      solid_close(Solid),
                      solid_counts(Solid, _, _, _) )).
test(not_a_solid, error(type_error(solid, 1))) :-
    solid_counts(1, _, _, _).
test(no_solid, error(instantiation_error)) :-
    solid_counts(_, _, _, _).
test(not_segments, error(type_error(integer, a))) :-
    solid_take([a], _).

:- end_tests(solid).
