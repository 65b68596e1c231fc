:- module(sanggwan, []).
/** <module> The facade: everything that a user or a rule file calls.

`use_module(library(sanggwan))` loads this. It only re-exports; the modules
themselves are named sg_ + file, since Prolog's table of modules is flat.
*/

% The relations, worlds and transactions, and the words for them.
:- reexport(store).
:- reexport(vocabulary).
:- reexport(model/model).
% The way of the data.
:- reexport(csg/csg, [node/4, root_segment/1, operand_segment/2]).
:- reexport(solid/csg_evaluate, except([csg_statistics_reset/0])).
:- reexport(csg/provenance).
:- reexport(model/integrity, [model_defect/1]).
:- reexport(primitive/primitive, [primitive/1, primitive_form/2]).
:- reexport(primitive/primitive_face).
:- reexport(primitive/primitive_rows, [add_primitive/2]).
:- reexport(model/mesh, [read_mesh/2, read_mesh/3, write_mesh/2, write_mesh/3]).
:- reexport(model/openscad, [read_csg/2]).
:- reexport(model/solid_file, [write_solid/2, write_solid/3]).
:- reexport(polygon/triangulation, [complete_segments/0]).
:- reexport(solid/arrangement, [with_arrangement/3, components/2]).
:- reexport(solid/boolean, except([stays/3, senses_by_rule/3])).
:- reexport(solid/faces, [faces_merged/2]).
:- reexport(solid/trimmed, [trimmed/4, trimmed/5]).
:- reexport(unfolding/unfold, [unfold/2, unfold/3]).
:- reexport(penetration/penetration,
            except([ may_cut/2, leaf_lines/4, touching/2 ])).
:- reexport(development/development,
            [ develop/2, develop/3, development/2, seam_reason/3 ]).
:- reexport(development/development_record, [development_measures/2]).
:- reexport(exact, [vertex_exact/5]).
:- reexport(solid/operand).
:- reexport(solid/repair).
:- reexport(solid/inside, [inside/2, winding/3]).
:- reexport(kernel, [exact_statistics/1]).
:- reexport(penetration/chain).
:- reexport(explanation/explain,
            [explain/1, explain/2, explanation/2, explanation/3]).
:- reexport(command/lines_out, [write_lines/1, write_lines/2]).
:- reexport(picture/view).
:- reexport(picture/role, [edge_role/5]).
:- reexport(picture/hidden_lines).
:- reexport(drawing/drawing, [write_drawing/2, drawing_format/2]).
:- reexport(drawing/terminal).
:- reexport(unrolling/true_development).
:- reexport(unrolling/true_table).
:- reexport(unrolling/true_plate, [plate_parts/5]).
:- reexport(unrolling/true_rim).
:- reexport(development/bend, [pattern_bent/2]).
% Verbs, questions, other rules.
:- reexport(command/verbs, [draw/1, draw/2, convert/2]).
:- reexport(command/query, [query/2]).
:- reexport(decision).
:- reexport(command/repl, [repl/0]).
:- reexport(limits, [limit_value/2, set_limit/2]).
:- reexport(command/help, [help/0, help/1]).
:- use_module(command/embedding, []).
:- use_module(sandbox, []).
:- use_module(message/messages, []).
:- use_module(message/messages_ko, []).
