:- module(unsaid, [unsaid/2]).

/* Messages that no transcript says, with the reason.

   unsaid(Table, Head): the clause Head of rules/message/Table. said.plt prints
   those that are missing here, or here in vain.
*/

% The top level alone says it.
unsaid(messages, notice_en(greeting)).

% A fault of the program, or a last resort: no model is known that has it.
unsaid(messages, notice_en(no_end)).
unsaid(session_en, session_en(no_end)).
unsaid(messages, fault_en(result_open)).
unsaid(explain_glue_en, role_en(slit)).
unsaid(explain_glue_en, disks_lie_en(cover,_,_)).
unsaid(part_glue_en, not_glued_en(crossing)).
unsaid(messages, notice_en(opened)).
unsaid(messages, notice_en(contacts(_))).
unsaid(messages, fault_en(written(faulty(_,_,_)))).
unsaid(model_en, model_en(refused(_,_))).
unsaid(model_en, model_en(cannot_read(_))).
unsaid(written_en, unwritten_en(open(_))).
unsaid(written_en, unwritten_en(undivided(_))).
unsaid(written_en, unwritten_en(crossing(_))).
unsaid(written_en, unwritten_en(penetrates(_,meeting(_,_,_,_)))).
unsaid(written_en, unwritten_en(touches(_,meeting(_,_,_,_)))).
unsaid(written_en, instead_en(other_file)).
unsaid(true_en, true_en(bent_over(_,_))).

% The studio says it to a page, or listens already: tests/studio/front_test.py.
unsaid(command_en, command_en(port_taken(_))).
unsaid(command_en, command_en(port_refused(_))).
unsaid(command_en, command_en(socket_taken(_))).
unsaid(session_en, session_en(not_offered(_))).
unsaid(session_en, session_en(outside(_))).
unsaid(session_en, session_en(session_ended)).
unsaid(session_en, session_en(open_to_others(_,_))).
unsaid(session_en, session_en(behind(_,_))).
unsaid(session_en, session_en(book_damaged(_,_,_))).
unsaid(session_en, session_en(owner_alone(save))).
unsaid(session_en, session_en(owner_alone(class))).
unsaid(session_en, session_en(owner_alone(show))).
unsaid(session_en, session_en(no_class)).
unsaid(session_en, session_en(not_in_class)).
unsaid(session_en, session_en(answers_inside(_))).
unsaid(session_en, session_en(too_many_sessions(_))).
unsaid(session_en, wanted_en(offered)).
unsaid(session_en, wanted_en(download)).
unsaid(session_en, wanted_en(pupil)).
unsaid(session_en, wanted_en(upload)).
unsaid(session_en, session_en(too_many_uploads(_))).

% Of a view: tests/cli/serve_studio.py.
unsaid(session_en, wanted_en(section)).
unsaid(session_en, wanted_en(one_cut)).

% It has a number of the machine: tests/cli/serve.sh.
unsaid(session_en, wanted_en(least(_))).

% It depends on the time: tests/cli/bad_output.sh, tests/cli/batch.sh. Or it
% takes minutes.
unsaid(messages, notice_en(progress(_,_,_,_,_))).
unsaid(batch_en, batch_en(sorted(_))).

% 2^31 rows.
unsaid(mesh_en, mesh_en(too_large)).

% What programs ask, not commands: tests of rules say it.
unsaid(messages, fault_en(no_third_vertex(_,_))).
unsaid(operand_en, operand_fault_en(no_faces)).
unsaid(operand_en, operand_notice_en(repaired(no_area,_),_)).
unsaid(explain_en, statement_en(changed_since)).

% Shapes that have it are large: tests of rules, or none is known that is short.
unsaid(explain_en, statement_en(substitute_outline)).
unsaid(explain_en, statement_en(joined_already(1,_,_))).
unsaid(explain_en, statement_en(no_length)).
unsaid(explain_pixel_en, pixel_statement_en(back_side(_))).
unsaid(explain_pixel_en, pixel_statement_en(thinner_than_a_dot)).
unsaid(pattern_en, pattern_en(too_large(_))).
unsaid(unfold_en, not_kept_en(overlap)).
unsaid(unfold_en, not_kept_en(same_piece)).
