:- module(sg_sandbox, []).
/** <module> What library(sandbox) lets strangers ask: all that only reads.

A predicate is safe if it leaves every world, every file and every handle as it
was. What is kept on the way is no row: trees, pieces and scenes, which are
there under the stamps of the rows they were made from. evaluate/0 and picture/0
make rows, so they are not safe, although others can be asked only after them.

Predicates of the store are declared there, decisions by decision/2. Here are
the kernels that only read, so that library(sandbox) can follow what calls them,
and the exports that it cannot follow: these call what a table names, or use a
handle of their own and close it.

A test has every export of sanggwan.pl in one of two lists, what reads and what
writes (tests/rules/sandbox.plt).
*/

:- multifile
    sandbox:safe_primitive/1,
    sandbox:safe_meta/2,
    sandbox:safe_meta_predicate/1.

                /*******************************
                *            KERNELS           *
                *******************************/

sandbox:safe_primitive(sg_kernel_world:rule_module(_,_)).
sandbox:safe_primitive(sg_kernel_world:world_number(_)).
sandbox:safe_primitive(sg_kernel_world:model_tolerance(_)).
sandbox:safe_primitive(sg_kernel_world:segments_tolerance(_,_,_)).
sandbox:safe_primitive(sg_kernel_world:near_segments(_,_,_)).
sandbox:safe_primitive(sg_kernel_world:segment_borders(_,_)).
sandbox:safe_primitive(sg_kernel_world:census(_)).
sandbox:safe_primitive(sg_kernel_world:census_part(_,_)).
sandbox:safe_primitive(sg_kernel_world:census_shell(_,_,_,_)).
sandbox:safe_primitive(sg_kernel_world:census_defect(_,_,_,_)).
sandbox:safe_primitive(sg_kernel_world:exact_statistics(_)).
sandbox:safe_primitive(sg_kernel_penetration:line_chains(_)).
sandbox:safe_primitive(sg_kernel_boolean:segment_operand(_,_)).
sandbox:safe_primitive(sg_kernel_boolean:segment_edges(_,_,_,_)).
sandbox:safe_primitive(sg_kernel_boolean:segment_meets_itself(_)).
sandbox:safe_primitive(sg_kernel_boolean:self_meetings(_,_)).
sandbox:safe_primitive(sg_kernel_boolean:self_meeting(_,_,_,_)).
sandbox:safe_primitive(sg_kernel_boolean:windings(_,_,_)).
sandbox:safe_primitive(sg_kernel_boolean:kept_leaves(_,_)).
sandbox:safe_primitive(sg_kernel_boolean:arrangement_components(_,_)).
sandbox:safe_primitive(sg_kernel_drawing:view_range(_,_,_,_,_)).
sandbox:safe_primitive(sg_kernel_drawing:view_depth(_,_,_,_,_)).
sandbox:safe_primitive(sg_kernel_drawing:sine_cosine(_,_,_)).
sandbox:safe_primitive(sg_kernel_drawing:scene_edge(_,_,_,_,_)).

                /*******************************
                *            EXPORTS           *
                *******************************/

sandbox:safe_primitive(sg_limits:limit_value(_,_)).
sandbox:safe_primitive(sg_primitive_face:face_of(_,_,_)).
sandbox:safe_primitive(sg_primitive_face:smooth_surface(_,_,_)).
sandbox:safe_primitive(sg_csg_evaluate:csg_statistics(_)).
sandbox:safe_primitive(sg_true_development:developable_part(_,_,_)).
sandbox:safe_primitive(sg_penetration:penetration_chains(_)).
sandbox:safe_primitive(sg_penetration:penetration_chains(_,_,_)).
sandbox:safe_primitive(sg_boolean:select_boundary(_,_,_)).
sandbox:safe_primitive(sg_development:seam_reason(_,_,_)).
sandbox:safe_primitive(sg_development_record:development_measures(_,_)).
sandbox:safe_primitive(sg_hidden_lines:open_scene(_,_)).
sandbox:safe_primitive(sg_shading_scene:shading_scene(_,_)).
sandbox:safe_primitive(sg_shading_scene:scene_leaf(_,_)).
sandbox:safe_primitive(sg_seen:slice(_,_,_)).
sandbox:safe_primitive(sg_seen:met(_,_,_,_)).
sandbox:safe_primitive(sg_seen:seen_at(_,_,_,_)).
sandbox:safe_primitive(sg_seen:seen_layers(_,_,_,_)).
sandbox:safe_primitive(sg_surface_look:line_layers(_,_,_)).
sandbox:safe_primitive(sg_seen:line_spans(_,_,_)).
sandbox:safe_primitive(sg_seen:seen_side(_,_,_,_,_)).
sandbox:safe_primitive(sg_pick:pick(_,_,_)).
sandbox:safe_primitive(sg_hidden_lines:hidden_by(_,_,_,_,_,_)).
sandbox:safe_primitive(sg_hidden_lines:hidden_by_polygon(_,_,_,_,_,_)).
sandbox:safe_primitive(sg_penetration:touches(_,_)).
sandbox:safe_primitive(sg_measures:volume(_,_)).
sandbox:safe_primitive(sg_inside:inside(_,_)).
sandbox:safe_primitive(sg_inside:winding(_,_,_)).
sandbox:safe_primitive(sg_operand:operand_faults(_,_)).
sandbox:safe_primitive(sg_measures:area(_,_)).
sandbox:safe_primitive(sg_measures:bounding_box(_,_,_)).
sandbox:safe_primitive(sg_hidden_lines:hidden_interval(_,_,_,_,_)).
sandbox:safe_primitive(sg_explain:explain(_)).
sandbox:safe_primitive(sg_explain:explain(_,_)).
sandbox:safe_primitive(sg_explain:explanation(_,_)).
sandbox:safe_primitive(sg_explain:explanation(_,_,_)).

%   Safe if the goal is. What default/1 can call is a decision.

sandbox:safe_meta_predicate(sg_store:facts_snapshot/1).
sandbox:safe_meta_predicate(sg_store:in_world/2).
sandbox:safe_meta(sg_query:query(Goal,_), [Goal]).
sandbox:safe_meta(sg_decision:default(_), []).
