:- module(unsaid, [unsaid/2]).

/* Messages that no transcript says: what a machine has to be short of, what
   needs a large or a broken file, and what another test provokes.

   unsaid(Table, Head): the clause Head of rules/message/Table. said.plt prints
   those that are missing here, or here in vain.
*/

unsaid(messages, notice_en(greeting)).
unsaid(messages, notice_en(no_memory)).
unsaid(messages, notice_en(no_end)).
unsaid(messages, notice_en(progress(_,_,_,_,_))).
unsaid(messages, fault_en(mesh_write(unsupported(_)))).
unsaid(messages, fault_en(written(faulty(_,_,_)))).
unsaid(messages, fault_en(no_third_vertex(_,_))).
unsaid(messages, fault_en(result_open)).
unsaid(messages, notice_en(opened(contacts))).
unsaid(messages, notice_en(opened(faces))).
unsaid(messages, notice_en(contacts(_))).
unsaid(messages, flattened_en(_,_,_,_,_)).
unsaid(csg_en, csg_en(no_front(_))).
unsaid(development_en, what_en(kind(_))).
unsaid(development_en, what_en(edge_length(_))).
unsaid(development_en, what_en(no_numbers)).
unsaid(explain_en, statement_en(made(crossing))).
unsaid(explain_en, statement_en(edge_near(_,_))).
unsaid(explain_en, statement_en(verdict(covered(_),_))).
unsaid(explain_en, statement_en(substitute_outline)).
unsaid(explain_en, statement_en(joined_already(1,_,_))).
unsaid(explain_en, statement_en(no_length)).
unsaid(explain_en, statement_en(too_short)).
unsaid(explain_en, statement_en(changed_since)).
unsaid(mesh_en, mesh_en(unknown_format)).
unsaid(mesh_en, mesh_en(no_float32)).
unsaid(mesh_en, mesh_en(too_large)).
unsaid(model_en, model_en(cannot_read(permission))).
unsaid(model_en, model_en(cannot_read(_))).
unsaid(model_en, model_en(refused(_,_))).
unsaid(model_en, expected_en(ids)).
unsaid(model_en, limit_en(nodes)).
unsaid(operand_en, operand_fault_en(no_faces)).
unsaid(operand_en, operand_notice_en(repaired(welded,_),_)).
unsaid(operand_en, operand_notice_en(repaired(no_area,_),_)).
unsaid(pattern_en, pattern_en(opened_by_itself(_,_))).
unsaid(pattern_en, pattern_en(too_large(_))).
unsaid(pattern_en, pattern_fault_en(large(_,_))).
unsaid(primitive_en, primitive_en(too_large,_)).
unsaid(primitive_en, primitive_en(patches_clash(_,_),_)).
unsaid(prolog_en, prolog_en(resource_error(nesting_of_terms),_)).
unsaid(prolog_en, prolog_en(resource_error(_),_)).
unsaid(prolog_en, prolog_en(resource_error(_),_)).
unsaid(prolog_en, prolog_en(io_error(_,_),context(_,_))).
unsaid(prolog_en, prolog_en(representation_error(_),_)).
unsaid(prolog_en, prolog_en(timeout_error(_,_),_)).
unsaid(style_en, style_en(segment(_))).
unsaid(true_en, true_en(no_part(_,_))).
unsaid(true_en, true_en(no_part(_,_))).
unsaid(true_en, true_en(no_offset(_))).
unsaid(true_en, true_en(bend(_,_,_,_))).
unsaid(unfold_en, unfold_en(all_trimmed_away)).
unsaid(unfold_en, unfold_en(attached(_,_,_))).
unsaid(unfold_en, unfold_en(kept_apart(_,_))).
unsaid(unfold_en, unfold_en(not_kept(_,_,_,_,_))).
unsaid(unfold_en, not_kept_en(overlap)).
unsaid(unfold_en, not_kept_en(same_piece)).
unsaid(unfold_en, trim_en(kind(_,_))).
unsaid(written_en, unwritten_en(open(_))).
unsaid(written_en, unwritten_en(undivided(_))).
unsaid(written_en, unwritten_en(crossing(_))).
unsaid(written_en, unwritten_en(penetrates(_,meeting(_,_,_,_)))).
unsaid(written_en, unwritten_en(touches(_,meeting(_,_,_,_)))).
unsaid(written_en, instead_en(other_file)).
