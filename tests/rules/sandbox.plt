/* What library(sandbox) lets strangers ask: every export of the facade is in
   one of two lists here. What reads is safe and leaves the world as it is; what
   writes, a world, a file or a handle, is not safe. */
:- module(test_sandbox, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(sandbox), [safe_goal/1]).
:- use_module(library(solution_sequences), [limit/2]).
:- use_module(rules(sanggwan)).
:- use_module(rules(spans)).
:- use_module(rules(topology)).
:- use_module(rules(topics), [offered/2]).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

reads([ area/2, bounding_box/3, contact/4, zone/4, shell/4,
        chain/5, chain_length/2, chain_points/2,
        contour/13, current_view/4, current_world/1, default/1,
        developable_part/3, development/2, development_measures/2,
        drawn/7, span/7, e/5, edge_facets/2, edge_from/3, edge_polygon/3,
        explain/1, explain/2, explanation/2, explanation/3, face_of/3,
        facet/1, facet_loops/2, facet_neighbour/2, facet_plane/2,
        facet_triangle/2, disk/4, disk_arcs/2, disk_direction/2,
        disk_relation/3, zone_at/3, facts_snapshot/1,
        formula/2, from_p/5, gluing/2,
        from_v/4, generator_mark/4, half_edge/1, half_edge_ends/3,
        half_edge_facet/2, half_edge_twin/2, hidden_by/6,
        hidden_by_polygon/6, in_world/2, inside/2, joint/6, leaf_e/5,
        from_r/4, leaf_p/3, leaf_t/6, leaf_v/5, lies_in/3, light/2,
        limit_value/2,
        line/9, loop_cycle/4, radial_cycle/4, region/3, region_name/3,
        region_named/3, region_neighbour/4,
        sides/4,
        line_layers/3, line_spans/3, look/2, met/4, scene_leaf/2, seen_at/4,
        seen_layers/4, seen_side/5,
        shading_scene/2, slice/3,
        model_defect/1, node/4, operand_edge/3, operand_face/3,
        operand_faults/2, origin/3, p/3, param/2, param_about/2,
        penetration_chains/1, pick/3, piece/3, plane/6, polygon_from/5,
        projection/1, query/2, question/2, relation/3, relation_column/5,
        root_segment/1, rule_file/1, rules/0, screen/5, segment/3,
        shell_facets/2, smooth_surface/3, surface_facing/6, t/6,
        title_block/2, touches/2, true_length_rows/2, unfolding/2,
        v/5, vertex_exact/5, vertex_from/4, vertex_half_edge/2,
        vertex_point/2, view/3, volume/2, winding/3
      ]).

writes([ euler/3, glue_edges/4, glue_faces/4, glue_mixed/4,
         glue_vertices/4, unglued_polygons/3, unglued_region/4,
         add_primitive/2, assert_fact/1, assert_fact/2, boolean/2, boolean/3,
         complete_segments/0, convert/2, develop/2, develop/3,
         draw/1, draw/2, evaluate/0, evaluate/1, evaluate/2,
         evaluated/1, facts_redo/0, facts_transaction/1,
         facts_transaction/2, facts_undo/0, facts_undo_limit/1,
         fresh_id/3, glue_report/2, load_model/1, load_model/2, new_world/1,
         no_rules/1, pattern_bent/2, penetrate/0, penetrate/1,
         penetrate/2, picture/0, picture/1, render/2, scan/1, read_csg/2,
         read_mesh/2,
         read_mesh/3, regions_made/2, repair_operand/1, repl/0, retract_fact/1,
         retract_fact/2, retractall_facts/1, sanggwan_help/0,
         sanggwan_help/1, save_model/1, save_model/2,
         set_direction/3, set_limit/2, set_parameter/2,
         set_projection/1, set_view/1, set_view/3, set_world/1, unglue/1,
         show/0, show/1, trimmed/4, trimmed/5, true_development/4,
         unfold/2, unfold/3, use_rules/1, write_lines/1,
         write_lines/2, write_mesh/2, write_mesh/3, write_solid/2,
         write_solid/3, write_true_lengths/2, write_true_lengths/3
       ]).

%   is_safe(PI): with its arguments free; a meta-predicate with a goal that is
%   safe (safe/2) and not with one that writes.

is_safe(Name/Arity) :-
    functor(Head, Name, Arity),
    is_safe_goal(Head).

is_safe_goal(Goal) :-
    catch(safe_goal(sanggwan:Goal), error(_, _), fail).

with_goal(Goal, facts_snapshot(Goal)).
with_goal(Goal, in_world(_, Goal)).
with_goal(Goal, query(Goal, [])).

facade_export(Name/Arity) :-
    offered(Name/Arity, _).

%   What is printed on the way is no answer.

:- dynamic asking/0.
:- multifile user:message_hook/3.

user:message_hook(_, _, _) :-
    test_sandbox:asking.

:- begin_tests(sandbox).

test(every_export_is_in_one_list, Wrong == []) :-
    reads(Reads),
    writes(Writes),
    findall(PI, facade_export(PI), PIs),
    append(Reads, Writes, Listed),
    msort(PIs, All),
    msort(Listed, AllListed),
    findall(PI, ( member(PI, All), \+ memberchk(PI, AllListed)
                ; member(PI, AllListed), \+ memberchk(PI, All)
                ; member(PI, Reads), memberchk(PI, Writes)
                ), Wrong).
test(what_reads_is_safe, Unsafe == []) :-
    reads(Reads),
    exclude(is_safe, Reads, Unsafe0),
    exclude(is_meta, Unsafe0, Unsafe).
test(what_writes_is_not, Safe == []) :-
    writes(Writes),
    include(is_safe, Writes, Safe).
test(goals_within, Wrong == []) :-
    findall(Goal,
            ( with_goal(v(_,_,_,_,_), Goal), \+ is_safe_goal(Goal)
            ; with_goal(evaluate, Goal), is_safe_goal(Goal)
            ), Wrong).

is_meta(Name/Arity) :-
    with_goal(_, Goal),
    functor(Goal, Name, Arity),
    !.

%   What reads leaves the world as it was: every row of every relation.

test(what_reads_leaves_the_world, Changed == []) :-
    reads(Reads),
    in_new_world(( world_made,
                   findall(PI, ( member(PI, Reads), changes(PI) ),
                           Changed) )).

world_made :-
    absolute_file_name(sanggwan('facts/two_cubes.pl'), File),
    load_model(File),
    penetrate,
    picture,
    develop(1, _),
    assert_fact(segment(9, solid, union([1, 2]))).

changes(PI) :-
    rows(Before),
    setup_call_cleanup(asserta(test_sandbox:asking), asked(PI),
                       retract(test_sandbox:asking)),
    rows(After),
    Before \== After.

rows(Rows) :-
    findall(Row,
            ( relation(Name, Arity, _), functor(Row, Name, Arity), call(Row) ),
            Rows).

%   asked(PI): as far as it goes, with free arguments, then with some of what a
%   segment, a polygon or a point may be.

asked(Name/Arity) :-
    functor(Free, Name, Arity),
    answered(Free),
    forall(( member(Value, [1, 2, 9, 0.5, [1, 2], union([1, 2])]),
             member(Last, [free, []]) ),
           ( filled(Name, Arity, Value, Last, Goal),
             answered(Goal) )).

filled(Name, Arity, Value, Last, Goal) :-
    functor(Goal, Name, Arity),
    (   Arity >= 1
    ->  arg(1, Goal, Value)
    ;   true
    ),
    (   Arity >= 2,
        Last == []
    ->  arg(2, Goal, [])
    ;   Arity >= 3
    ->  arg(2, Goal, Value)
    ;   true
    ).

answered(Goal) :-
    with_output_to(string(_),
        forall(limit(3, catch(call_with_inference_limit(Goal, 300000, _),
                              _, true)), true)).

:- end_tests(sandbox).
