:- module(sg_examples,
          [ example/4                   % ?PI, ?Model, ?Goal, ?Answer
          ]).
/** <module> Examples: one for each predicate that users may call.

help/1 shows them, tests/rules/command/examples.plt runs them.
*/

%!  example(?PI, ?Model, ?Goal, ?Answer) is nondet.
%
%   In a world with Model (`none`: an empty one) the first answer of Goal is
%   Answer. Both are text; in Answer `_` is anything.

% Asking what is there.
example(root_segment/1, 'facts/pipe_tee.pl', "root_segment(S).", "S = 10").
example(node/4, 'docs/l_of_two_boxes.pl', "node(3, Operation, Children, _).",
        "Operation = union, Children = [1,2]").
example(vertex_exact/5, 'facts/two_cubes.pl', "vertex_exact(2, 1, X, Y, Z).",
        "X = 225179981368525r2251799813685248, Y = _, Z = _").
example(edge_polygon/3, 'facts/two_cubes.pl',
        "edge_polygon(1, 1, P).", "P = 1").
example(volume/2, 'facts/two_cubes.pl', "volume(1, V).", "V = 8.0").
example(area/2, 'facts/two_cubes.pl', "area(1, A).", "A = 24.0").
example(bounding_box/3, 'facts/two_cubes.pl', "bounding_box(1, Low, High).",
        "Low = point(-1.0,-1.0,0.0), High = point(1.0,1.0,2.0)").
example(touches/2, 'facts/two_cubes.pl', "touches(1, S).", "S = 2").
example(inside/2, 'facts/two_cubes.pl', "inside(S, point(0, 0, 1)).", "S = 1").
example(winding/3, 'facts/two_cubes.pl', "winding(1, point(0, 0, 5), N).",
        "N = 0").
example(model_defect/1, 'facts/two_cubes.pl', "model_defect(D).", "false").
example(face_of/3, 'facts/pipes.pl', "face_of(1, 1, What).", "What = _").
example(smooth_surface/3, 'facts/pipes.pl',
        "smooth_surface(1, Part, Surface).",
        "Part = side, Surface = cylinder(_,_,_,_)").
example(query/2, 'facts/two_cubes.pl', "query(volume(S, V), []).", "true").
example(relation/3, none, "relation(line, Arity, Doc).",
        "Arity = 9, Doc = _").
example(relation_column/5, none, "relation_column(v, 2, Name, Type, _).",
        "Name = 'X', Type = float").
example(half_edge/1, 'facts/two_cubes.pl', "half_edge(S-E).", "S = 1, E = 1").
example(half_edge_ends/3, 'facts/two_cubes.pl', "half_edge_ends(1-1, V1, V2).",
        "V1 = 4, V2 = 3").
example(half_edge_twin/2, 'facts/two_cubes.pl', "half_edge_twin(1-1, Twin).",
        "Twin = 1-17").
example(half_edge_facet/2, 'facts/two_cubes.pl',
        "half_edge_facet(1-1, Facet).", "Facet = 1-1").
example(facet/1, 'facts/two_cubes.pl', "facet(2-P).", "P = 1").
example(facet_loops/2, 'facts/two_cubes.pl', "facet_loops(1-1, Loops).",
        "Loops = [[4,3,2,1]]").
example(facet_plane/2, 'facts/two_cubes.pl', "facet_plane(1-1, Plane).",
        "Plane = plane(0.0,0.0,-1.0,0.0)").
example(facet_triangle/2, 'facts/two_cubes.pl',
        "facet_triangle(1-1, Triangle).", "Triangle = triangle(4,3,2)").
example(facet_neighbour/2, 'facts/two_cubes.pl',
        "facet_neighbour(1-1, Other).",
        "Other = 1-5").
example(vertex_point/2, 'facts/two_cubes.pl', "vertex_point(1-1, Point).",
        "Point = point(-1.0,-1.0,0.0)").
example(vertex_half_edge/2, 'facts/two_cubes.pl',
        "vertex_half_edge(1-1, Edge).",
        "Edge = 1-4").
example(edge_facets/2, 'facts/two_cubes.pl', "edge_facets(1-(1,2), Facets).",
        "Facets = [1-1,1-3]").
example(shell_facets/2, 'facts/two_cubes.pl', "shell_facets(1-1, Facets).",
        "Facets = [1-1,1-2,1-3,1-4,1-5,1-6]").

% Changing worlds, reading and writing models.
example(load_model/1, none, "load_model('facts/cube.pl'), volume(S, V).",
        "S = 1, V = 1.0").
example(load_model/2, none, "load_model('facts/cube.pl', [complete(false)]).",
        "true").
example(set_parameter/2, 'facts/family.pl',
        "set_parameter(length, 500), param(length, Length).", "Length = 500").
example(save_model/1, 'facts/two_cubes.pl',
        "save_model('cubes.off').", "true").
example(save_model/2, 'facts/two_cubes.pl', "save_model('cubes.pl', []).",
        "true").
example(read_csg/2, none,
        "open('m.csg', write, Out), write(Out, 'cube(size=[1,2,3]);'), \c
         close(Out), read_csg('m.csg', Term).",
        "Out = _, Term = at(_, box(size(1,2,3)))").
example(read_mesh/2, none,
        "convert('facts/cube.pl', 'c.off'), \c
         read_mesh('c.off', Ss).", "Ss = [1]").
example(read_mesh/3, none,
        "convert('facts/cube.pl', 'c.off'), \c
         read_mesh('c.off', Ss, [join(false)]).", "Ss = [1]").
example(write_mesh/2, 'facts/cube.pl', "write_mesh('cube.ply', all).", "true").
example(write_mesh/3, 'facts/cube.pl', "write_mesh('cube.stl', [1], []).",
        "true").
example(convert/2, none, "convert('facts/cube.pl', 'cube.stl').", "true").
example(assert_fact/1, none,
        "assert_fact(segment(1, curve, wire)), segment(S, _, _).", "S = 1").
example(assert_fact/2, none,
        "assert_fact(segment(1, curve, wire), Row).", "Row = 0").
example(retract_fact/1, 'facts/two_cubes.pl', "retract_fact(view(T, P, R)).",
        "T = 300.0, P = 60.0, R = 20.0").
example(retract_fact/2, 'facts/two_cubes.pl',
        "retract_fact(segment(2, _, _), [cascade(true)]), root_segment(S).",
        "S = 1").
example(retractall_facts/1, 'facts/two_cubes.pl',
        "retractall_facts(view(_, _, _)), \\+ view(_, _, _).", "true").
example(fresh_id/3, 'facts/two_cubes.pl', "fresh_id(v, 1, V).", "V = 9").
example(add_primitive/2, none,
        "add_primitive(box(size(1, 2, 3)), S), volume(S, V).",
        "S = 1, V = 6.0").
example(complete_segments/0, none,
        "add_primitive(box(size(1, 1, 1)), 1), complete_segments, \c
         aggregate_all(count, t(1, _, _, _, _, _), N).", "N = 12").
example(facts_transaction/1, 'facts/two_cubes.pl',
        "facts_transaction(( retract_fact(view(_, _, _)), fail )).", "false").
example(facts_transaction/2, 'facts/two_cubes.pl',
        "facts_transaction(retract_fact(segment(2, _, _)), \c
         [cascade(true)]), root_segment(S).", "S = 1").
example(facts_snapshot/1, 'facts/two_cubes.pl',
        "facts_snapshot(( penetrate, once(line(L,_,_,_,_,_,_,_,_)) )).",
        "L = 1").
example(facts_undo/0, 'facts/two_cubes.pl',
        "penetrate, facts_undo, \\+ line(_,_,_,_,_,_,_,_,_).", "true").
example(facts_redo/0, 'facts/two_cubes.pl',
        "penetrate, facts_undo, facts_redo, once(line(L,_,_,_,_,_,_,_,_)).",
        "L = 1").
example(facts_undo_limit/1, 'facts/two_cubes.pl',
        "facts_undo_limit(0), penetrate, facts_undo.", "false").
example(new_world/1, none, "new_world(W), in_world(W, \\+ segment(_, _, _)).",
        "W = _").
example(in_world/2, none,
        "new_world(W), in_world(W, load_model('facts/cube.pl')), \c
         \\+ segment(_, _, _).",
        "W = _").
example(current_world/1, none, "current_world(W).", "W = _").
example(set_world/1, none,
        "current_world(Old), new_world(W), set_world(W), set_world(Old).",
        "Old = _, W = _").
example(set_limit/2, none, "limit_value(depth, D), set_limit(depth, D).",
        "D = 128").
example(limit_value/2, none, "limit_value(digits, Most).", "Most = 2000").

% Cutting: penetration lines.
example(penetrate/0, 'facts/two_cubes.pl',
        "penetrate, aggregate_all(count, line(_,_,_,_,_,_,_,_,_), N).",
        "N = 6").
example(penetrate/1, 'facts/pipes.pl',
        "penetrate([1-3]), chain(C, S1, S2, _, _).",
        "C = 1, S1 = 1, S2 = 3").
example(penetrate/2, 'facts/two_cubes.pl',
        "penetrate(all, [tolerance(0)]), chain(1, _, _, Kind, _).",
        "Kind = closed").
example(chain/5, 'facts/two_cubes.pl', "penetrate, chain(1, S1, S2, Kind, _).",
        "S1 = 1, S2 = 2, Kind = closed").
example(chain_length/2, 'facts/two_cubes.pl',
        "penetrate, chain(1, _, _, _, Lines), chain_length(Lines, Length).",
        "Lines = [1,3,5,6,4,2], Length = 7.200000000000001").
example(chain_points/2, 'facts/two_cubes.pl',
        "penetrate, chain(1, _, _, _, Lines), chain_points(Lines, [First|_]).",
        "Lines = _, First = point(1.0,-0.30000000000000004,0.6)").
example(penetration_chains/1, 'facts/two_cubes.pl',
        "penetration_chains([chain(S1, S2, Kind, _, _)]).",
        "S1 = 1, S2 = 2, Kind = closed").
example(write_lines/1, 'facts/two_cubes.pl',
        "penetrate, write_lines('lines.dxf').", "true").
example(write_lines/2, 'facts/two_cubes.pl',
        "penetrate, write_lines('lines.csv', []).", "true").

% Combining solids.
example(boolean/2, 'facts/two_cubes.pl',
        "boolean(difference([1, 2]), 3), volume(3, V).", "V = _").
example(boolean/3, 'facts/two_cubes.pl',
        "boolean(union([1, 2]), 3, [tolerance(0)]), segment(3, Kind, _).",
        "Kind = solid").
example(evaluate/0, 'docs/l_of_two_boxes.pl',
        "evaluate, evaluated(S).", "S = 3").
example(evaluate/1, 'docs/l_of_two_boxes.pl',
        "evaluate(3), aggregate_all(count, p(3, _, _), N).", "N = 8").
example(evaluate/2, 'docs/l_of_two_boxes.pl',
        "evaluate(all, [tolerance(0)]), evaluated(S).", "S = 3").
example(evaluated/1, 'docs/l_of_two_boxes.pl', "evaluated(S).", "S = 3").
example(trimmed/4, 'facts/two_cubes.pl',
        "trimmed(1, [2], outside, T).", "T = 3").
example(trimmed/5, 'facts/two_cubes.pl', "trimmed(1, [2], inside, [], T).",
        "T = 3").
example(write_solid/2, 'facts/two_cubes.pl', "write_solid('part.stl', 1).",
        "true").
example(write_solid/3, 'facts/two_cubes.pl',
        "write_solid('part.off', 1, [check(all)]).", "true").
example(operand_faults/2, 'facts/two_cubes.pl', "operand_faults(1, Faults).",
        "Faults = []").
example(repair_operand/1, 'facts/two_cubes.pl', "repair_operand(1).", "true").
example(vertex_from/4, 'docs/l_of_two_boxes.pl', "vertex_from(3, V, S, V0).",
        "V = 1, S = 1, V0 = 4").
example(edge_from/3, 'docs/l_of_two_boxes.pl', "edge_from(3, E, cut(_, _)).",
        "E = 1").
example(polygon_from/5, 'docs/l_of_two_boxes.pl',
        "polygon_from(3, 1, S, P, Sense).", "S = 1, P = 1, Sense = 1").
example(operand_face/3, 'docs/l_of_two_boxes.pl', "operand_face(3, P, 2).",
        "P = 3").
example(operand_edge/3, 'docs/l_of_two_boxes.pl', "operand_edge(3, E, 2).",
        "E = 1").
example(regions_made/2, 'facts/two_rooms.pl',
        "regions_made(1, _), region(1, R, Role).", "R = 1, Role = cell").
example(region_neighbour/4, 'facts/two_rooms.pl',
        "regions_made(1, _), region_neighbour(1, 1, 2, P).", "P = 6").
example(region_name/3, 'facts/figures/glue_face.pl',
        "evaluate(3), region_name(3, 2, Name).", "Name = region([2])").
example(region_named/3, 'facts/figures/glue_face.pl',
        "evaluate(3), region_named(3, region([2]), R).", "R = 2").
example(glue_report/2, 'facts/figures/glue_face.pl',
        "glue_report(3, Report), get_dict(counts, Report, Counts), \c
         get_dict(faces, Counts, N).", "N = 13").
example(unglue/1, 'facts/figures/glue_face.pl',
        "unglue(3), \\+ segment(3, _, _), root_segment(S).", "S = 1").
example(loop_cycle/4, 'facts/two_rooms.pl',
        "loop_cycle(1, 1, K, Vs).", "K = 1, Vs = [4,3,2,1]").
example(radial_cycle/4, 'facts/two_rooms.pl',
        "regions_made(1, _), radial_cycle(1, 2, 3, Pages).",
        "Pages = [page(1,_,_),page(6,_,2),page(7,_,_)]").
example(disk/4, 'facts/two_rooms.pl', "disk(1, 13, D, Items).",
        "D = 1, Items = [e(_)]").
example(contact/4, 'facts/figures/glue_face.pl',
        "contact(3, 'face-face', Seat1, Seat2).",
        "Seat1 = seat(1,p(_),face(_,none)), Seat2 = seat(2,_,_)").
example(zone/4, 'facts/two_rooms.pl',
        "regions_made(1, _), zone(1, 1, R, Cycles).",
        "R = 3, Cycles = [[above(_)|_]]").
example(shell/4, 'facts/two_rooms.pl',
        "regions_made(1, _), shell(1, 2, K, Uses).",
        "K = 1, Uses = [e(_)]").
example(disk_arcs/2, 'facts/figures/glue_vertex.pl',
        "disk_arcs(disk(5, 1, 2), [Arc|_]).",
        "Arc = arc(p(1,-1,3),p(-1,-1,3),1,0)").
example(disk_direction/2, 'facts/figures/glue_vertex.pl',
        "disk_direction(disk(5, 1, 4), Direction).", "Direction = p(0,0,-3)").
example(zone_at/3, 'facts/figures/glue_vertex.pl',
        "zone_at(disk(5, 1, 2), p(0,0,1), Zone).", "Zone = 1").
example(euler/3, 'facts/two_rooms.pl',
        "regions_made(1, _), euler(1, make(vertex(_, p(99,0,0))), Change).",
        "Change = change(1,0,0,0,1,0,1,0)").
example(glue_vertices/4, 'facts/two_rooms.pl',
        "regions_made(1, _), v(1, V, X, Y, Z), !, \c
         euler(1, make(vertex(W, p(99,0,0))), _), \c
         retractall_facts(v(1, W, _, _, _)), assert_fact(v(1, W, X, Y, Z)), \c
         glue_vertices(1, V, W, Change), arg(1, Change, N).", "N = -1").
example(glue_edges/4, 'facts/two_rooms.pl',
        "regions_made(1, _), e(1, _, A, B, _), !, \c
         glue_edges(1, A-B, B-A, Change).", "Change = change(0,0,0,0,0,0,0,0)").
example(glue_mixed/4, 'facts/two_rooms.pl',
        "regions_made(1, _), \c
         catch(glue_mixed(1, v(1), p(1), _), error(_, _), true).", "true").
example(glue_faces/4, 'facts/two_rooms.pl',
        "regions_made(1, _), unglued_polygons(1, [6], _), \c
         origin(1, p(Q), slit(6)), glue_faces(1, 6, Q, Change), \c
         arg(3, Change, Faces).", "Faces = -1").
example(unglued_polygons/3, 'facts/two_rooms.pl',
        "regions_made(1, _), unglued_polygons(1, [6], Change), \c
         arg(3, Change, Faces).", "Faces = 1").
example(unglued_region/4, 'facts/two_rooms.pl',
        "regions_made(1, _), unglued_region(1, 1, N, _).", "N = 2").
example(disk_relation/3, 'facts/figures/glue_vertex.pl',
        "disk_relation(disk(5, 1, 2), disk(5, 1, 3), Relation).",
        "Relation = within").

% Drawing: views, pictures, hidden lines.
example(picture/0, 'facts/two_cubes.pl',
        "picture, aggregate_all(count, drawn(_,_,_,_,_,visible,_), N).",
        "N = 17").
example(picture/1, 'facts/two_cubes.pl',
        "picture([]), once(drawn(1, S, _, _, _, _, _)).", "S = 1").
example(draw/1, 'facts/two_cubes.pl', "draw('two.svg').", "true").
example(draw/2, 'facts/two_cubes.pl', "draw('two.pdf', [hidden(removed)]).",
        "true").
example(show/0, 'facts/two_cubes.pl', "show.", "true").
example(show/1, 'facts/two_cubes.pl', "show([width(40)]).", "true").
example(set_view/1, 'facts/two_cubes.pl', "set_view(front), view(T, P, _).",
        "T = 270.0, P = 90.0").
example(set_view/3, 'facts/two_cubes.pl',
        "set_view(300, 60, 20), view(T, _, _).", "T = 300.0").
example(set_direction/3, 'facts/two_cubes.pl',
        "set_direction(0, 0, 1), view(_, P, _).", "P = 0.0").
example(set_projection/1, 'facts/two_cubes.pl',
        "set_projection(central), projection(Kind).", "Kind = central").
example(current_view/4, 'facts/two_cubes.pl', "current_view(T, P, R, Kind).",
        "T = 300.0, P = 60.0, R = 20.0, Kind = parallel").
example(hidden_by/6, 'facts/two_cubes.pl',
        "picture, once(hidden_by(1, 1, S, T, _, _)).", "S = 1, T = 6").
example(shading_scene/2, 'facts/two_cubes.pl',
        "shading_scene(320-200, Scene).", "Scene = scene(_,_,_)").
example(scene_leaf/2, 'facts/two_cubes.pl',
        "shading_scene(320-200, _Scene), scene_leaf(_Scene, Leaf).",
        "Leaf = leaf(1,1,1,_,_)").
example(slice/3, 'facts/two_cubes.pl',
        "shading_scene(320-200, _Scene), \c
         slice(_Scene, 99.9, slice(R, S, F, Sense, _, _, _)).",
        "R = 1, S = 1, F = 2, Sense = 1").
example(met/4, 'facts/two_cubes.pl',
        "shading_scene(320-200, _Scene), \c
         met(_Scene, 160, 99.9, [group(_, Mets)|_]).",
        "Mets = [met(1,_,1)]").
example(seen_at/4, 'facts/two_cubes.pl',
        "shading_scene(320-200, _Scene), seen_at(_Scene, 160, 99.9, Seen).",
        "Seen = seen(1,1,_)").
example(seen_layers/4, 'facts/two_cubes.pl',
        "shading_scene(320-200, _Scene), \c
         seen_layers(_Scene, 160, 99.9, [First|_]).",
        "First = layer(_,1,1,_)").
example(line_layers/3, 'facts/two_cubes.pl',
        "shading_scene(320-200, _Scene), line_layers(_Scene, 99.9, [First|_]).",
        "First = layer(_,_,1,1,_,1.0)").
example(line_spans/3, 'facts/two_cubes.pl',
        "shading_scene(320-200, _Scene), line_spans(_Scene, 99.9, [First|_]).",
        "First = span(_,_,1,1,_)").
example(seen_side/5, 'facts/two_cubes.pl',
        "shading_scene(320-200, _Scene), \c
         seen_side(_Scene, 160, 99.9, Depth, Normal).",
        "Depth = _, Normal = vector(_,_,_)").
example(pick/3, 'facts/two_cubes.pl',
        "pick(pixel(160, 99), [size(320-200)], Picked).",
        "Picked = picked(1,1,side(2),1.0,point(_,_,_))").
example(scan/1, 'facts/two_cubes.pl',
        "scan([size(320-200)]), once(span(100, 0, _, _, R, S, _)).",
        "R = 1, S = 1").
example(render/2, 'facts/two_cubes.pl',
        "tmp_file(shaded, _File), atom_concat(_File, '.png', _Name), \c
         render(_Name, [size(64-40)]), exists_file(_Name), \c
         delete_file(_Name), Written = yes.",
        "Written = yes").
example(hidden_by_polygon/6, 'facts/two_cubes.pl',
        "picture, hidden_by_polygon(1, 4, S, P, From, To).",
        "S = 1, P = 3, From = 0.0, To = 1.0").

% Unfolding: developments and patterns.
example(unfold/2, 'facts/two_cubes.pl', "unfold(1, D), segment(D, Kind, _).",
        "D = 3, Kind = pattern").
example(unfold/3, 'facts/two_cubes.pl', "unfold(1, [root(1)], D).",
        "D = 3").
example(develop/2, 'facts/two_cubes.pl',
        "develop(1, D), aggregate_all(count, joint(D,_,_,_,fold,_), N).",
        "D = 3, N = 5").
example(develop/3, 'facts/two_cubes.pl', "develop(1, [effort(0)], D).",
        "D = 3").
example(development/2, 'facts/two_cubes.pl',
        "develop(1, _), development(1, D).",
        "D = 3").
example(development_measures/2, 'facts/two_cubes.pl',
        "develop(1, D), development_measures(D, M), get_dict(seam, M, Seam).",
        "D = 3, M = _, Seam = 14.0").
example(true_development/4, 'facts/pipes.pl',
        "true_development(1, side, [], D), segment(D, Kind, _).",
        "D = _, Kind = pattern").
example(developable_part/3, 'facts/pipes.pl',
        "developable_part(1, Part, Surface).",
        "Part = side, Surface = cylinder(_,_,_,_)").
example(write_true_lengths/2, 'facts/pipes.pl',
        "true_development(1, _, [], D), write_true_lengths(D, 'table.csv').",
        "D = _").
example(write_true_lengths/3, 'facts/pipes.pl',
        "true_development(1, _, [], D), write_true_lengths(D, \c
         'table.csv', []).",
        "D = _").
example(pattern_bent/2, 'facts/two_cubes.pl',
        "develop(1, D), pattern_bent(D, [thickness(0.01)]).", "D = 3").
example(true_length_rows/2, 'facts/pipes.pl',
        "true_development(1, _, [], D), true_length_rows(D, [Row|_]).",
        "D = _, Row = row(_,_,_,_,_,_,_,_,_)").
example(generator_mark/4, 'facts/pipes.pl',
        "true_development(1, _, [], D), generator_mark(D, 1, From, To).",
        "D = _, From = _, To = _").

% Explaining.
example(explain/1, 'facts/two_cubes.pl',
        "penetrate, explain(line(1)).", "true").
example(explain/2, 'facts/two_cubes.pl', "penetrate, explain(line(1), []).",
        "true").
example(explanation/2, 'facts/two_cubes.pl',
        "penetrate, explanation(line(1), [because(Why, _)|_]).",
        "Why = line(1,1,4,2,1)").
example(explanation/3, 'facts/two_cubes.pl',
        "penetrate, explanation(line(1), [], [because(Why, _)|_]).",
        "Why = line(1,1,4,2,1)").

% Rules that decide, and help.
example(rules/0, none, "rules.", "true").
example(use_rules/1, 'facts/pipes.pl',
        "use_rules('docs/pipes_rules.pl'), penetrate, chain(C, S1, S2, _, _).",
        "C = 1, S1 = 1, S2 = 3").
example(no_rules/1, none,
        "use_rules('docs/pipes_rules.pl'), \c
         no_rules('docs/pipes_rules.pl'), \\+ rule_file(_).",
        "true").
example(rule_file/1, none,
        "use_rules('docs/pipes_rules.pl'), rule_file(File).", "File = _").
example(default/1, none, "default(may_cut(1, 2)).", "true").
example(repl/0, 'facts/two_cubes.pl', "repl.", "true").
example(sanggwan_help/0, none, "sanggwan_help.", "true").
example(sanggwan_help/1, none, "sanggwan_help(volume/2).", "true").
