/* Unglue in part: slits, cuts that open, regions by themselves; counts by
   hand. */
:- module(test_unglue, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(gluing/regions)).
:- use_module(rules(gluing/unglue)).
:- use_module(rules(model/integrity)).
:- use_module(rules(store)).
:- use_module(tests(rules/gluing/cells_rows)).
:- use_module(tests(rules/gluing/face_soup)).
:- use_module(tests(rules/gluing/turned_soup)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   cubes(N, Turned): n^3 of them, as cells.

cubes(N, Turned) :-
    Most is N-1,
    findall([X,Y,Z],
            ( between(0, Most, X), between(0, Most, Y), between(0, Most, Z) ),
            Lows),
    cubes_faces(Lows, Faces0),
    (   Turned == true
    ->  turned_faces(Faces0, Faces)
    ;   Faces = Faces0
    ),
    made_soup(Faces, []),
    regions_made(1, _).

counts(Counts) :-
    regions_report(1, Report),
    \+ law_fault(Report, _, _),
    report_counts(Report, Counts).

inner(P) :-
    region(1, Out, outside),
    sides(1, P, Below, Above),
    Below =\= Out,
    Above =\= Out.

roles(Role, N) :-
    aggregate_all(count, region(1, _, Role), N).

%   level(P, Z): all of polygon P is at Z.

level(P, Z) :-
    p(1, P, Es),
    forall(member(E, Es), ( e(1, E, V, _, _), v(1, V, _, _, Z) )).

:- begin_tests(unglue, [setup(set_random(seed(8)))]).

%   Of the cube in the middle: a slit inside.

test(slit, [forall(member(Turned, [false,true])),
            true(C-N == [64,144,109,109,1,29,29,0]-1)]) :-
    in_new_world(( cubes(3, Turned),
                   middle_face(P),
                   unglued_polygons(1, [P], _),
                   counts(C),
                   roles(slit, N) )).

%   A face between two cells that touch nothing but cells: of the middle cube.

middle_face(P) :-
    region(1, Out, outside),
    inner(P),
    sides(1, P, R, _),
    \+ region_neighbour(1, R, Out, _),
    !.

%   Of eight cubes each inner face reaches the surface: the cut opens.

test(opens, [forall(member(Turned, [false,true])),
             true(Cs-N == [[28,56,37,37,1,9,9,0]]-12)]) :-
    in_new_world(( cubes(2, Turned),
                   findall(P, inner(P), Ps),
                   length(Ps, N),
                   findall(C, ( member(P, Ps), opened(P, C) ), Cs0),
                   sort(Cs0, Cs) )).

opened(P, C) :-
    facts_snapshot(( unglued_polygons(1, [P], _), counts(C), roles(slit, 0) )).

test(plane, C == [36,66,40,40,2,9,10,0]) :-
    in_new_world(( cubes(2, false),
                   findall(P, level(P, 1.0), Ps),
                   unglued_polygons(1, Ps, _),
                   counts(C) )).

%   Plane after plane, in any order: eight cubes apart.

test(all_of_it, [forall(member(Turned, [false,true])),
                 true(C == [64,96,48,48,8,9,16,0])]) :-
    in_new_world(( cubes(2, Turned),
                   findall(P, inner(P), Ps0),
                   random_permutation(Ps0, Ps),
                   forall(member(P, Ps), unglued_polygons(1, [P], _)),
                   counts(C) )).
test(between, Change == change(4,4,1,1,1,0,1,0)) :-
    cubes_faces([[0,0,0],[1,0,0]], Faces),
    in_new_world(( made_soup(Faces, []), regions_made(1, _),
                   unglued_between(1, 1, 2, Change) )).
test(stays_apart, C-C2 == [16,24,12,12,2,3,4,0]-[16,24,12,12,2,3,4,0]) :-
    cubes_faces([[0,0,0],[1,0,0]], Faces),
    in_new_world(( made_soup(Faces, []), regions_made(1, _),
                   unglued_between(1, 1, 2, _), counts(C),
                   regions_made(1, Report) )),
    report_counts(Report, C2).
test(undone, Rows1 == Rows) :-
    in_new_world(( cubes(2, true), cells_rows(1, Rows),
                   once(inner(P)), unglued_polygons(1, [P], _), facts_undo,
                   cells_rows(1, Rows1) )).

%   A corner cube by itself: three faces of it stay.

test(region, [forall(member(Turned, [false,true])),
              true(C-F-D == [26,51,33,33,1,8,8,0]-6-[])]) :-
    in_new_world(( cubes(2, Turned),
                   unglued_region(1, 1, N, _),
                   counts(C),
                   aggregate_all(count, p(N, _, _), F),
                   findall(Defect, model_defect(Defect), D) )).
test(outside_is_no_cell, error(geometry_error(part_glue(unglued(1, r(9)))))) :-
    in_new_world(( cubes(2, false), unglued_region(1, 9, _, _) )).
test(no_region, error(geometry_error(part_glue(unglued(1, r(77)))))) :-
    in_new_world(( cubes(2, false), unglued_region(1, 77, _, _) )).
test(not_glued, error(geometry_error(part_glue(unglued(1, p(P)))))) :-
    in_new_world(( cubes(2, false), p(1, P, _), \+ inner(P),
                   unglued_polygons(1, [P], _) )).
test(no_neighbours, error(geometry_error(part_glue(unglued(1, 1-1))))) :-
    in_new_world(( cubes(2, false), unglued_between(1, 1, 1, _) )).

:- end_tests(unglue).
