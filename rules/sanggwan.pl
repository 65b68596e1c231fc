:- module(sanggwan, []).
/** <module> The facade: everything that a user or a rule file calls.

`use_module(library(sanggwan))` loads this. It only re-exports; the modules
themselves are named sg_ + file, since Prolog's table of modules is flat.
*/

% The relations, worlds and transactions, and the words for them.
:- reexport(store).
:- reexport(vocabulary).
:- reexport(model).
% The way of the data.
:- reexport(csg, [node/4, root_segment/1, operand_segment/2]).
:- reexport(csg_evaluate, except([csg_statistics_reset/0])).
:- reexport(provenance).
:- reexport(integrity, [model_defect/1]).
:- reexport(primitive, [primitive/1, primitive_form/2]).
:- reexport(primitive_face).
:- reexport(primitive_rows, [add_primitive/2]).
:- reexport(mesh, [read_mesh/2, read_mesh/3, write_mesh/2, write_mesh/3]).
:- reexport(openscad, [read_csg/2]).
:- reexport(solid_file, [write_solid/2, write_solid/3]).
:- reexport(triangulation, [complete_segments/0, polygon_triangles/3]).
:- reexport(arrangement, [with_arrangement/3, components/2]).
:- reexport(boolean, except([stays/3])).
:- reexport(faces, [faces_merged/2]).
:- reexport(trimmed, [trimmed/4, trimmed/5]).
:- reexport(unfold, [unfold/2, unfold/3]).
:- reexport(penetration,
            except([ may_cut/2, leaf_lines/4, touching/2 ])).
:- reexport(development,
            [ develop/2, develop/3, development/2, seam_reason/3 ]).
:- reexport(development_record, [development_measures/2]).
:- reexport(exact, [vertex_exact/5]).
:- reexport(operand).
:- reexport(repair).
:- reexport(inside, [inside/2, winding/3]).
:- reexport(kernel, [exact_statistics/1]).
:- reexport(chain).
:- reexport(explain,
            [explain/1, explain/2, explanation/2, explanation/3]).
:- reexport(lines_out, [write_lines/1, write_lines/2]).
:- reexport(view).
:- reexport(role, [edge_role/5]).
:- reexport(hidden_lines).
:- reexport(drawing, [write_drawing/2, drawing_format/2]).
:- reexport(terminal).
:- reexport(true_development).
:- reexport(true_table).
:- reexport(true_plate, [plate_parts/5]).
:- reexport(true_rim).
:- reexport(bend, [pattern_bent/2]).
% Verbs, questions, other rules.
:- reexport(verbs, [draw/1, draw/2, convert/2]).
:- reexport(query, [query/2]).
:- reexport(decision).
:- reexport(repl, [repl/0]).
:- reexport(help, [help/0, help/1]).
:- use_module(embedding, []).
:- use_module(messages, []).
:- use_module(messages_ko, []).
