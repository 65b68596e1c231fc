:- module(sanggwan_rows, []).
/** <module> Rows that the program makes, exact answers, and single steps.

What cuts, glues, patterns and pictures are made of, for those who ask more than
a first model does. sanggwan.pl has what that needs.
*/
:- use_module(topics, [topic/2]).
:- use_module(topology, []).

:- set_module(base(sanggwan_topology)).

:- topic(made_rows, "Relations that cuts, glues, patterns and pictures make").
:- reexport(store,
            [ from_v/4, from_p/5, leaf_v/5, leaf_e/5, leaf_p/3, leaf_t/6,
              region/3, sides/4, from_r/4, lies_in/3, piece/3, joint/6,
              screen/5, contour/13, surface_facing/6, drawn/7, span/7 ]).

:- topic(answers, "Asking more exactly").
:- reexport(exact, [vertex_exact/5]).
:- reexport(store, [edge_polygon/3, relation/3, relation_column/5]).
:- reexport(solid/inside, [winding/3]).
:- reexport(primitive/primitive_face, [face_of/3, smooth_surface/3]).
:- reexport(penetration/penetration, [penetration_chains/1]).
:- reexport(penetration/chain, [chain_length/2, chain_points/2]).
:- reexport(solid/operand, [operand_faults/2]).
:- reexport(csg/provenance, [vertex_from/4, edge_from/3, polygon_from/5]).
:- reexport(picture/view, [current_view/4]).
:- reexport(shading/seen, [seen_at/4]).
:- reexport(development/development_record, [development_measures/2]).
:- reexport(unrolling/true_development, [developable_part/3]).
:- reexport(unrolling/true_table, [true_length_rows/2, generator_mark/4]).

:- topic(steps, "Single steps, and limits").
:- reexport(store, [fresh_id/3, facts_undo_limit/1]).
:- reexport(limits, [set_limit/2, limit_value/2]).
:- reexport(model/openscad, [read_csg/2]).
:- reexport(polygon/triangulation, [complete_segments/0]).
:- reexport(solid/trimmed, [trimmed/4, trimmed/5]).
:- reexport(solid/repair, [repair_operand/1]).
:- reexport(gluing/regions, [regions_made/2]).
:- reexport(picture/view, [set_direction/3, set_projection/1]).
:- reexport(unrolling/true_development, [true_development/4]).
:- reexport(unrolling/true_table,
            [write_true_lengths/2, write_true_lengths/3]).
:- reexport(development/bend, [pattern_bent/2]).
:- reexport(decision, [rule_file/1]).
