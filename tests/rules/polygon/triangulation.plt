:- module(test_triangulation, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(store)).
:- use_module(rules(kernel)).
:- use_module(rules(model/mesh)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests('rules/polygon/polygon_sample')).
:- use_module(tests('rules/sample')).
:- use_module(tests('oracle/triangulation')).

% ---- samples

sample(square, [[0-0, 4-0, 4-4, 0-4]]).
sample(reflex_start, [[2-2, 4-0, 4-4, 0-4]]).
sample(collinear_start, [[0-0, 2-0, 4-0, 4-4, 2-4, 0-4, 0-2]]).
sample(hollow, [[0-0, 9-0, 9-9, 0-9], [3-3, 3-6, 6-6, 6-3]]).
sample(twice_hollow,
       [ [0-0, 20-0, 20-9, 0-9], [3-3, 3-6, 6-6, 6-3], [12-2, 11-6, 16-7]
       ]).
sample(island, [[0-0, 9-0, 9-9, 0-9], [2-2, 2-7, 7-7, 7-2],
                [4-4, 5-4, 5-5, 4-5]]).
sample(hole_touches_corner, [[0-0, 9-0, 9-9, 0-9], [0-0, 3-6, 6-3]]).
sample(hole_touches_side, [[0-0, 9-0, 9-9, 0-9], [4-0, 3-6, 6-3]]).
sample(hole_shares_part_of_side, [[0-0, 9-0, 9-9, 0-9],
                                  [3-0, 3-4, 6-4, 6-0]]).
sample(hole_shares_side, [[0-0, 9-0, 9-9, 0-9], [0-0, 4-4, 9-0]]).
sample(holes_touch, [[0-0, 9-0, 9-9, 0-9], [1-1, 1-4, 4-4, 4-1],
                     [4-4, 4-7, 7-7, 7-4]]).
sample(holes_share_side, [[0-0, 9-0, 9-9, 0-9], [1-1, 1-4, 4-4, 4-1],
                          [4-1, 4-4, 7-4, 7-1]]).
sample(inner_spike, [[0-0, 9-0, 9-9, 5-9, 5-4, 5-9, 0-9]]).
sample(outer_spike, [[0-0, 9-0, 9-9, 5-9, 5-14, 5-9, 0-9]]).
sample(touches_itself, [[0-0, 8-0, 8-8, 4-0, 0-8]]).
sample(doubled_point, [[0-0, 4-0, 4-0, 4-4, 0-4]]).
sample(tenths, [[0.1-0.1, 0.7-0.1, 0.7-0.3, 0.3-0.3, 0.3-0.7, 0.1-0.7]]).

% Seams, by points and edges; each with the number of triangles.
cut(seam_across, [0-0, 4-0, 4-4, 0-4],
    [1-2, 2-3, 3-4, 4-1, 1-3, 3-1], 2).
cut(seam_from_the_border, [0-0, 4-0, 4-4, 0-4, 2-2],
    [1-2, 2-3, 3-4, 4-1, 1-5, 5-1], 4).
cut(loose_chain, [0-0, 8-0, 8-8, 0-8, 2-2, 5-3, 4-6],
    [1-2, 2-3, 3-4, 4-1, 5-6, 6-5, 6-7, 7-6], 8).
cut(closed_chain, [0-0, 9-0, 9-9, 0-9, 3-3, 6-3, 4-6],
    [1-2, 2-3, 3-4, 4-1, 5-6, 6-7, 7-5, 6-5, 7-6, 5-7], 8).
cut(lone_cross, [0-0, 9-0, 9-9, 0-9, 4-4, 4-7, 7-4, 4-2, 2-4],
    [ 1-2, 2-3, 3-4, 4-1, 5-6, 6-5, 5-7, 7-5, 5-8, 8-5, 5-9, 9-5 ], 12).
cut(seam_joins_hole, [0-0, 9-0, 9-9, 0-9, 3-3, 3-6, 6-6, 6-3],
    [1-2, 2-3, 3-4, 4-1, 5-6, 6-7, 7-8, 8-5, 1-5, 5-1], 8).

place(flat).
place(axis(Axis, Sign)) :-
    member(Axis, [x,y,z]),
    member(Sign, [1,-1]).
place(plane([2,1,-1], [0,3,1], [5,-7,11])).         % exactly flat
place(plane([-1,4,2], [3,1,-5], [0,0,0])).
place(plane([0.36,0.48,-0.8], [-0.8,0.6,0.1], [0.1,0.2,0.3])).

% A point inside an edge is beside it when it is rounded.
rounded_touch(Name, plane([0.36|_], _, _)) :-
    memberchk(Name, [hole_touches_side, hole_shares_part_of_side,
                     touches_itself]).

% What the invalid ones are named for is their own business; that they are is
% not.
invalid(crossing, [[0-0, 4-0, 4-4, 1-(-1)]]).
invalid(hole_outside, [[0-0, 4-0, 4-4, 0-4], [6-1, 6-3, 8-3, 8-1]]).
invalid(hole_crosses, [[0-0, 4-0, 4-4, 0-4], [2-1, 2-3, 6-3, 6-1]]).
invalid(hole_round_all, [[0-0, 4-0, 4-4, 0-4], [1-1, 1-2, 2-2, 2-1],
                         [1-1, 1-2, 2-2, 2-1]]).

% ---- what is asked

% The rule and the kernel give the same triangles, they cover the polygon, and
% a polygon without points inside edges needs N of them.
good :-
    polygon_triangles(1, 1, Triangles),
    triangles_area(Triangles, Area),
    polygon_area(Expected),
    Area =:= Expected,
    same_as_kernel(Triangles).

nearly_good :-
    polygon_triangles(1, 1, Triangles),
    triangles_area(Triangles, Area),
    polygon_area(Expected),
    abs(Area-Expected) < 1.0e-12*Expected,
    same_as_kernel(Triangles).

same_as_kernel(Triangles) :-
    fill_triangles(all, 1_000_000, Faults),
    forall(member(fault(_, _, Fault), Faults), Fault = not_flat(_)),
    findall(t(V1, V2, V3), t(1, 1, _, V1, V2, V3), Stored),
    assertion(Stored == Triangles).

rule_outcome(Outcome) :-
    catch(( polygon_triangles(1, 1, Triangles),
            Outcome = triangles(Triangles)
          ),
          error(geometry_error(polygon_edge(1, 1, V1, V2)), _),
          Outcome = not_simple(V1, V2)).

kernel_outcome(Outcome) :-
    fill_triangles(all, 1_000_000, Faults),
    (   member(fault(1, 1, not_simple(V1, V2)), Faults)
    ->  Outcome = not_simple(V1, V2)
    ;   memberchk(fault(1, 1, no_area), Faults)
    ->  Outcome = no_area
    ;   findall(t(V1, V2, V3), t(1, 1, _, V1, V2, V3), Triangles),
        Outcome = triangles(Triangles)
    ).

same_outcome :-
    kernel_outcome(Kernel),
    (   Kernel == no_area
    ->  true
    ;   rule_outcome(Rule),
        assertion(Rule == Kernel)
    ).

data(Path) :-
    absolute_file_name(sanggwan('../shared/data/polygons'), Folder,
                       [file_type(directory), file_errors(fail)]),
    atom_concat(Folder, '/*.json', Pattern),
    expand_file_name(Pattern, Paths),
    member(Path, Paths).

% Two of the files do cross themselves (checked edge by edge, in fractions);
% one has no area; in one a hole shares edges with the border, rounded apart.
data_outcome('bad-hole', invalid).
data_outcome(water, invalid).
data_outcome(degenerate, no_area).
data_outcome(issue142, nearly_covered).

note_data :-
    (   data(_)
    ->  true
    ;   format("skipped: ../shared/data/polygons is not there~n")
    ).

:- begin_tests(triangulation, [setup(note_data)]).

test(sample, forall(( sample(Name, Loops), place(Place),
                      \+ rounded_touch(Name, Place) ))) :-
    with_polygon(Loops, Place, good).
test(rounded_touch, forall(( sample(Name, Loops), place(Place),
                             rounded_touch(Name, Place) ))) :-
    with_polygon(Loops, Place, nearly_good).
test(cut, [forall(( cut(_, Points, Edges, N), place(Place) )),
           true(Count == N)]) :-
    with_edges(Points, Edges, Place,
               ( good, polygon_triangles(1, 1, Triangles) )),
    length(Triangles, Count).
test(counts, true(N == 8)) :-
    sample(hollow, Loops),
    with_polygon(Loops, flat, polygon_triangles(1, 1, Triangles)),
    length(Triangles, N).

% The paper's Fig. 4: the first edge with the end of the next one.
test(first_triangle, true(T == t(1, 2, 3))) :-
    sample(square, Loops),
    with_polygon(Loops, flat, polygon_triangles(1, 1, [T|_])).

% Any order of the edges will do.
test(order, forall(numbered(15, 50, Seed))) :-
    set_random(seed(Seed)),
    cut(seam_joins_hole, Points, Edges0, _),
    random_permutation(Edges0, Edges),
    with_edges(Points, Edges, flat, good).

test(invalid, forall(invalid(_, Loops))) :-
    with_polygon(Loops, flat,
                 ( rule_outcome(not_simple(V1, V2)),
                   kernel_outcome(not_simple(V1, V2))
                 )).
test(open, error(model_error(polygon(1, 1, open(3))))) :-
    with_edges([0-0, 4-0, 4-4, 0-4], [1-2, 2-3, 4-1], flat,
               polygon_triangles(1, 1, _)).
test(no_area, true(Faults == [fault(1, 1, no_area)])) :-
    with_polygon([[0-0, 1-1, 2-2]], flat, fill_triangles(all, 1000, Faults)).

test(data, [forall(sampled([Path,Place], ( member(Place, [flat, axis(x, -1)]),
                                           data(Path) ))),
            true(Base-Outcome == Base-Expected)]) :-
    file_base_name(Path, Name),
    file_name_extension(Base, json, Name),
    ring_loops(Path, Loops),
    (   data_outcome(Base, Expected)
    ->  true
    ;   Expected = covered
    ),
    with_polygon(Loops, Place, outcome(Outcome)).

% Turned anywhere: points inside edges are rounded off them, so areas agree to
% rounding; and what is invalid stays so.
test(data_turned, [forall(( data(Path),
                            \+ sub_atom(Path, _, _, _, degenerate),
                            numbered(1, 3, Seed) )),
                   setup(set_random(seed(Seed))),
                   true(Base-Outcome == Base-Expected)]) :-
    file_base_name(Path, Name),
    file_name_extension(Base, json, Name),
    ring_loops(Path, Loops),
    random_plane(Place),
    (   data_outcome(Base, Expected0),
        Expected0 \== nearly_covered
    ->  Expected = Expected0
    ;   Expected = covered
    ),
    with_polygon(Loops, Place, outcome(Outcome0)),
    (   Outcome0 == nearly_covered
    ->  Outcome = covered
    ;   Outcome = Outcome0
    ).

outcome(Outcome) :-
    kernel_outcome(Kernel),
    (   Kernel = triangles(Triangles)
    ->  rule_outcome(Kernel),
        triangles_area(Triangles, Area),
        polygon_area(Expected),
        covering(Area, Expected, Outcome)
    ;   Kernel == no_area
    ->  Outcome = no_area
    ;   Kernel = not_simple(_, _),
        rule_outcome(not_simple(_, _)), % the kernel may name an edge that is
        Outcome = invalid               % crossed, before one gets stuck
    ).

covering(Area, Expected, Outcome) :-
    (   Area =:= Expected
    ->  Outcome = covered
    ;   abs(Area-Expected) < 1.0e-12*Expected
    ->  Outcome = nearly_covered
    ;   Outcome = areas(Area, Expected)
    ).

random_plane(plane(U, V, O)) :-
    maplist([N]>>( random(R), N is R*2-1 ), [A1,A2,A3,B1,B2,B3,O1,O2,O3]),
    U = [A1,A2,A3],
    V = [B1,B2,B3],
    O = [O1,O2,O3].

% Real polygons: those of mesh files that are no triangles.
test(mesh, [forall(one_in(4, mesh_data(Path))), true(Differ == [])]) :-
    new_world(World),
    in_world(World, mesh_differences(Path, Differ)).

mesh_data(Path) :-
    absolute_file_name(sanggwan('../shared/data'), Folder,
                       [file_type(directory), file_errors(fail)]),
    member(Pattern, ['/meshes/suzanne.obj', '/mcut/*.off']),
    atom_concat(Folder, Pattern, Files),
    expand_file_name(Files, Paths),
    member(Path, Paths).

mesh_differences(Path, Differ) :-
    read_mesh(Path, _),
    fill_triangles(all, 1_000_000, _),
    findall(S-P, ( p(S, P, Es), length(Es, N), N > 3 ), Polygons),
    exclude(same_triangles, Polygons, Differ).

same_triangles(S-P) :-
    polygon_triangles(S, P, Triangles),
    findall(t(V1, V2, V3), t(S, P, _, V1, V2, V3), Triangles).

% Kernel against rule: thousands of polygons.
test(random_cells, [forall(numbered(120, 1500, Seed)),
                    setup(set_random(seed(Seed)))]) :-
    Size is 2+Seed mod 5,
    Seams is Seed mod 7*15,
    random_cells(Size, Seams, Points, Edges),
    findall(Place, place(Place), Places),
    random_member(Place, Places),
    with_edges(Points, Edges, Place, cells_good(Place)).
test(random_walk, [forall(numbered(120, 1500, Seed)),
                   setup(set_random(seed(Seed)))]) :-
    N is 4+Seed mod 9,
    Grid is 2+Seed mod 4,
    random_walk(N, Grid, Loops),
    with_polygon(Loops, flat, same_outcome).

% Where points are rounded, straight runs may bend: then any answer is right
% if it is the same.
cells_good(plane([0.36|_], _, _)) :-
    !,
    same_outcome.
cells_good(_) :-
    good.

:- end_tests(triangulation).

% A comb of 100,000 vertices takes much longer than that.
comb(Loop) :-
    findall(X-Y, ( between(1, 100000, I), X is -I, Y is (I*7919) mod 1000 ),
            Tips),
    append([-99900-(-9), 0-(-10)], Tips, Loop).

count_triangles(N) :-
    aggregate_all(count, t(_, _, _, _, _, _), N).

:- dynamic noted/1.

warnings(Goal, Warnings) :-
    retractall(noted(_)),
    setup_call_cleanup(
        asserta((user:message_hook(sanggwan(What), warning, _) :-
                     assertz(test_triangulation:noted(What))),
                Hook),
        call(Goal),
        erase(Hook)),
    findall(What, noted(What), Warnings).

:- begin_tests(complete_segments).

test(plane, true(Plane == plane(0.0, 0.0, 1.0, -7.0))) :-
    sample(reflex_start, Loops),
    with_polygon(Loops, axis(z, 1),
                 ( complete_segments, plane(1, 1, A, B, C, D) )),
    Plane = plane(A, B, C, D).
test(plane_hollow, true(Plane == plane(0.0, -1.0, 0.0, 7.0))) :-
    sample(hollow, Loops),
    with_polygon(Loops, axis(y, -1),
                 ( complete_segments, plane(1, 1, A, B, C, D) )),
    Plane = plane(A, B, C, D).
test(nothing_twice, true(N1-N2 == 2-2)) :-
    sample(square, Loops),
    with_polygon(Loops, flat,
                 ( complete_segments, count_triangles(N1),
                   complete_segments, count_triangles(N2)
                 )).
test(only_triangles, true(Planes-N == 1-2)) :-
    sample(square, Loops),
    with_polygon(Loops, flat,
                 ( complete_segments,
                   retractall_facts(t(_, _, _, _, _, _)),
                   complete_segments,
                   count_triangles(N),
                   aggregate_all(count, plane(_, _, _, _, _, _), Planes)
                 )).
test(of_some_segments, true(Ts == [[], [2,2], [1,1,2,2]])) :-
    sample(square, Loops),
    with_polygon(Loops, flat,
                 ( forall(v(1, V, X, Y, Z), assert_fact(v(2, V, X, Y, Z))),
                   forall(e(1, E, A, B, T), assert_fact(e(2, E, A, B, T))),
                   assert_fact(segment(2, surface, again)),
                   forall(p(1, P, Es), assert_fact(p(2, P, Es))),
                   findall(Segments,
                           ( member(Ss, [[], [9,2,2], [1]]),
                             complete_segments(Ss),
                             findall(S, t(S, _, _, _, _, _), Segments0),
                             msort(Segments0, Segments) ),
                           Ts)
                 )).
test(open_changes_nothing, true(N-M == 0-0)) :-
    with_edges([0-0, 4-0, 4-4, 0-4], [1-2, 2-3, 4-1], flat,
               ( catch(complete_segments,
                       error(model_error(polygon(1, 1, open(3))), _),
                       true),
                 count_triangles(N),
                 aggregate_all(count, plane(_, _, _, _, _, _), M)
               )).
test(ids, true(Ts == [1-1, 1-2, 2-1, 2-2, 1-3])) :-
    sample(square, Loops),
    with_polygon(Loops, flat,
                 ( forall(v(1, V, X, Y, Z), assert_fact(v(2, V, X, Y, Z))),
                   forall(e(1, E, A, B, T), assert_fact(e(2, E, A, B, T))),
                   assert_fact(segment(2, surface, again)),
                   assert_fact(p(2, 1, [1,2,3,4])),
                   assert_fact(e(1, 5, 1, 3, 1)),
                   assert_fact(p(1, 2, [5,3,4])),
                   complete_segments,
                   findall(S-T, t(S, _, T, _, _, _), Ts)
                 )).
test(invalid_is_named, true(Warning == [polygon_edge(1, 1, 1, 2)])) :-
    invalid(crossing, Loops),
    with_polygon(Loops, flat, warnings(complete_segments, Warning)).
test(no_area_is_named, true(Warning == [no_area(1, 1, 1)])) :-
    with_polygon([[0-0, 1-1, 2-2]], flat,
                 warnings(complete_segments, Warning)).
test(bent_is_named, true(N == 2)) :-
    sample(square, Loops),
    with_polygon(Loops, flat,
                 ( facts_transaction(( retract_fact(v(1, 4, X, Y, _)),
                                       assert_fact(v(1, 4, X, Y, 1.0)) )),
                   warnings(complete_segments, [not_flat(1, 1, 1, Off)]),
                   count_triangles(N)
                 )),
    Off > 0.2,
    Off < 0.3.

test(stopped, true(E-N == time_limit_exceeded-0)) :-
    comb(Loop),
    with_polygon([Loop], flat,
                 ( statistics(cputime, T0),
                   catch(call_with_time_limit(0.02, complete_segments),
                         E, true),
                   statistics(cputime, T1),
                   count_triangles(N)
                 )),
    assertion(T1-T0 < 0.5).

:- end_tests(complete_segments).
