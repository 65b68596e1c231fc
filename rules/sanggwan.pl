:- module(sanggwan, []).
/** <module> The facade: everything that a user or a rule file calls.

`use_module(library(sanggwan))` loads this. It only re-exports, topic by topic;
sanggwan_help/0 lists the topics. rows.pl, topology.pl and spans.pl go on with
what a first model does not need; goals of the command line, rule files and
hosts see them too. What is in none can be imported from the module that has it.
*/
:- use_module(topics, [topic/2]).
:- use_module(rows, []).

:- set_module(base(sanggwan_rows)).

:- topic(relations, "The relations: rows that you can ask and change").
:- reexport(store,
            [ segment/3, v/5, e/5, p/3, plane/6, t/6, line/9, origin/3,
              gluing/2, unfolding/2, view/3, projection/1, title_block/2,
              look/2, light/2, param/2, param_about/2, formula/2, question/2 ]).

:- topic(asking, "Asking what is there").
:- reexport(csg/csg, [root_segment/1, node/4]).
:- reexport(model/measures, [volume/2, area/2, bounding_box/3]).
:- reexport(penetration/penetration, [touches/2]).
:- reexport(solid/inside, [inside/2]).
:- reexport(model/integrity, [model_defect/1]).
:- reexport(studio/query, [query/2]).

:- topic(changing, "Changing worlds, reading and writing models").
:- reexport(model/model,
            [ load_model/1, load_model/2, save_model/1, save_model/2 ]).
:- reexport(model/parameter_change, [set_parameter/2]).
:- reexport(model/mesh, [read_mesh/2, read_mesh/3, write_mesh/2, write_mesh/3]).
:- reexport(command/verbs, [convert/2]).
:- reexport(store,
            [ assert_fact/1, assert_fact/2, retract_fact/1, retract_fact/2,
              retractall_facts/1, facts_transaction/1, facts_transaction/2,
              facts_snapshot/1, facts_undo/0, facts_redo/0, new_world/1,
              current_world/1, set_world/1, in_world/2 ]).
:- reexport(primitive/primitive_rows, [add_primitive/2]).

:- topic(cutting, "Cutting: penetration lines").
:- reexport(penetration/penetration,
            [penetrate/0, penetrate/1, penetrate/2]).
:- reexport(penetration/chain, [chain/5]).
:- reexport(command/lines_out, [write_lines/1, write_lines/2]).

:- topic(combining, "Combining solids").
:- reexport(solid/boolean, [boolean/2, boolean/3]).
:- reexport(solid/csg_evaluate,
            [ evaluate/0, evaluate/1, evaluate/2, evaluated/1 ]).
:- reexport(model/solid_file, [write_solid/2, write_solid/3]).
:- reexport(solid/glue, [unglue/1, glue_report/2]).
:- reexport(solid/glue_contact, [contact/4]).
:- reexport(csg/provenance,
            [operand_face/3, operand_edge/3]).

:- topic(drawing, "Drawing: views, pictures, hidden lines").
:- reexport(picture/hidden_lines,
            [ picture/0, picture/1, hidden_by/6, hidden_by_polygon/6 ]).
:- reexport(command/verbs, [draw/1, draw/2]).
:- reexport(drawing/terminal, [show/0, show/1]).
:- reexport(picture/view,
            [set_view/1, set_view/3]).
:- reexport(shading/picture_file, [render/2]).

:- topic(unfolding, "Unfolding: developments and patterns").
:- reexport(unfolding/unfold, [unfold/2, unfold/3]).
:- reexport(development/development,
            [ develop/2, develop/3, development/2 ]).
:- topic(explaining, "Explaining").
:- reexport(explanation/explain,
            [ explain/1, explain/2, explanation/2, explanation/3 ]).

:- topic(rules, "Rules that decide, and help").
:- reexport(decision,
            [ rules/0, use_rules/1, no_rules/1, default/1 ]).
:- reexport(command/repl, [repl/0]).
:- reexport(command/help, [sanggwan_help/0, sanggwan_help/1]).

% What goals and messages need, without a name for users.
:- use_module(command/embedding, []).
:- use_module(sandbox, []).
:- use_module(message/messages, []).
:- use_module(message/messages_ko, []).
