/* The document of a session: its text, its file and its journal, through all
   that is done to it. */
% covers: document_journal, document_content
:- module(test_document, []).
:- use_module(library(apply)).
:- use_module(library(filesex)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(rules(store)).
:- use_module(rules(studio/document)).

%   in_folder(Goal): call(Goal), where `a.pl` and so on are files of a new
%   folder, and so is what the system keeps for programs.

:- meta_predicate in_folder(0).

in_folder(Goal) :-
    tmp_file(document, Folder),
    make_directory(Folder),
    working_directory(Here, Folder),
    ( getenv('XDG_STATE_HOME', Old) -> true ; Old = none ),
    atom_concat(Folder, '/state', State),
    setenv('XDG_STATE_HOME', State),
    setup_call_cleanup(
        box(1, Text),
        ( put('a.pl', Text),
          call(Goal) ),
        ( closed,
          working_directory(_, Here),
          ( Old == none -> unsetenv('XDG_STATE_HOME')
          ; setenv('XDG_STATE_HOME', Old) ),
          delete_directory_and_contents(Folder) )).

closed :-
    forall(retract(sg_document:document(_, _, _, _, _, Journal)),
           sg_journal:journal_closed(Journal)),
    retractall(sg_document:tried_(_)).

box(N, Text) :-
    format(string(Text), "segment(~d, solid, box(size(1,2,~d))).~n", [N,N]).

put(File, Text) :-
    setup_call_cleanup(open(File, write, Out, [encoding(utf8)]),
                       write(Out, Text),
                       close(Out)).

got(File, Text) :-
    read_file_to_string(File, Text, [encoding(utf8)]).

opened(Head) :-
    opened(Head, _).

opened(Head, Reply) :-
    document_opened(Head, Reply, Commit),
    call(Commit).

changed(Request, Head, Body) :-
    changed(Request, Head, Body, _).

changed(Request, Head, Body, Reply) :-
    document_changed(Request, Head, Body, Reply, Commit),
    call(Commit).

text(N) :-
    box(N, Text),
    changed(text, _{}, Text).

saved(Head) :-
    document_saved(Head, _).

is(N) :-
    box(N, Text),
    document_text(Found),
    assertion(Found == Text).

:- meta_predicate refused(0, -), revisions(0, -).

refused(Goal, What) :-
    catch(( Goal, What = none ),
          error(Formal, _),
          ( Formal = request_error(What) -> true ; What = Formal )).

%   revisions(Goal, N): how many new ones Goal made.

revisions(Goal, N) :-
    document_revision(Before),
    call(Goal),
    document_revision(After),
    N is After-Before.

journal(_{file:"a.pl", journal:"a.journal"}).

%   killed(Name): the program is gone, and its file and journal are now Name.pl
%   and Name.journal.

killed(Name) :-
    closed,
    forall(member(Ending, [pl,journal]),
           ( atomic_list_concat(['a.',Ending], From),
             atomic_list_concat([Name,'.',Ending], To),
             copy_file(From, To) )).

:- begin_tests(document).

test(nothing_open, Whats == [no_document]) :-
    closed,
    findall(What,
            ( member(Goal, [ document_text(_), document_world(_),
                             document_rules(_, _), document_is_saved(_) ]),
              refused(Goal, What) ),
            Whats0),
    sort(Whats0, Whats),
    document_revision(0),
    \+ document_file(_),
    \+ document_input(_, _).
test(bad_file, [ forall(member(Head, [_{},_{file:""},_{file:5}])),
                 What == bad_key(file, file) ]) :-
    refused(document_opened(Head, _, _), What).
test(way) :-
    in_folder(( opened(_{file:"a.pl"}, Reply),
                assertion(_{file:"a.pl", replayed:0, messages:[]} :< Reply),
                is(1),
                document_file('a.pl'),
                document_is_saved(true),
                document_input('a.pl', ""),
                revisions(text(2), 1),
                is(2),
                document_is_saved(false),
                box(2, Text2),
                document_input(-, Text2),
                revisions(changed(undo, _{}, ""), 1),
                is(1),
                document_is_saved(true),
                revisions(changed(redo, _{}, ""), 1),
                is(2),
                revisions(saved(_{}), 0),
                document_is_saved(true),
                document_input('a.pl', ""),
                got('a.pl', Text2),
                changed(undo, _{}, ""),
                is(1),
                document_is_saved(false) )).
test(what_a_pane_shows, Shown == [ [2,curve,"wire",false],
                                   [7,solid,"box(size(1,2,7))",true] ]) :-
    in_folder(( put('b.pl', "segment(7, solid, box(size(1,2,7))).\n\c
                             segment(2, curve, wire).\n\c
                             v(2, 1, 0.0, 0.0, 0.0).\n\c
                             v(2, 2, 1.0, 0.0, 0.0).\ncurve(2, [1,2]).\n"),
                opened(_{file:"b.pl"}, Reply),
                findall([S,Kind,Name,Unfolds],
                        ( get_dict(segments, Reply, Segments),
                          member(Segment, Segments),
                          _{segment:S, kind:Kind, name:Name,
                            unfolds:Unfolds} :< Segment ),
                        Shown) )).
test(other_formats, Whats == [no_text,no_text]) :-
    in_folder(( put('b.obj', "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
                opened(_{file:"b.obj"}),
                refused(document_text(_), What1),
                refused(text(1), What2),
                document_rules("", false),
                document_input('b.obj', ""),
                document_world(_),
                Whats = [What1,What2] )).
test(nothing_to, Whats == [nothing_to(undo),nothing_to(redo)]) :-
    in_folder(( opened(_{file:"a.pl"}),
                refused(changed(undo, _{}, ""), What1),
                refused(changed(redo, _{}, ""), What2),
                Whats = [What1,What2] )).
%   What does not load is no change.
test(not_loaded) :-
    in_folder(( opened(_{file:"a.pl"}),
                revisions(( refused(changed(text, _{}, "segment(1,"), What),
                            assertion(What = model_error(_)) ), 0),
                is(1) )).
test(replies, [true([Was,Wish,Question] == [2,"unfolding(1, cut(3))",
                                            "question(q, true)"])]) :-
    in_folder(( opened(_{file:"a.pl"}),
                changed(edit, _{set:_{segment:1, path:[1,2], value:5}}, "",
                        Reply1),
                document_text(Text),
                assertion(Text == "segment(1, solid, box(size(1,5,1))).\n"),
                get_dict(was, Reply1, Was0),
                Was is Was0,
                changed(cut, _{segment:1, edge:3}, "", Reply2),
                get_dict(wish, Reply2, Wish),
                changed(question, _{name:"q", goal:"true"}, "", Reply3),
                get_dict(question, Reply3, Question) )).
test(no_such_segment, What == bad_key(segment, no_segment(4, [1]))) :-
    in_folder(( opened(_{file:"a.pl"}),
                refused(changed(cut, _{segment:4, edge:3}, ""), What) )).

% --- the journal -------------------------------------------------------------

test(killed, Replayed == 3) :-
    in_folder(( journal(Head),
                opened(Head),
                text(2), text(3), changed(undo, _{}, ""),
                killed(b),
                opened(_{file:"b.pl", journal:"b.journal"}, Reply),
                get_dict(replayed, Reply, Replayed),
                is(2),
                changed(redo, _{}, ""),
                is(3),
                changed(undo, _{}, ""), changed(undo, _{}, ""),
                is(1) )).
test(killed_after_saving, Replayed == 1) :-
    in_folder(( journal(Head),
                opened(Head),
                text(2), saved(_{}), text(3),
                killed(b),
                opened(_{file:"b.pl", journal:"b.journal"}, Reply),
                get_dict(replayed, Reply, Replayed),
                is(3) )).
test(without_a_file, Replayed == 1) :-
    in_folder(( journal(Head),
                opened(Head),
                text(2),
                killed(b),
                delete_file('b.pl'),
                opened(_{file:"b.pl", journal:"b.journal"}, Reply),
                get_dict(replayed, Reply, Replayed),
                is(2) )).
test(changes_not_wanted, Replayed == 0) :-
    in_folder(( journal(Head),
                opened(Head),
                text(2),
                killed(b),
                opened(_{file:"b.pl", journal:"b.journal", replay:false},
                       Reply),
                get_dict(replayed, Reply, Replayed),
                is(1) )).
test(of_another_text, What == journal_of_another('b.journal')) :-
    in_folder(( journal(Head),
                opened(Head),
                text(2),
                killed(b),
                box(9, Text),
                put('b.pl', Text),
                refused(opened(_{file:"b.pl", journal:"b.journal"}), What) )).
test(what_the_journal_has) :-
    in_folder(( journal(Head),
                opened(Head),
                text(2),
                killed(b),
                box(9, Text),
                put('b.pl', Text),
                opened(_{file:"b.pl", journal:"b.journal", replay:"journal"}),
                is(2) )).
test(no_journal, What == no_journal('b.journal')) :-
    in_folder(( put('b.journal', "something\n"),
                refused(opened(_{file:"a.pl", journal:"b.journal"}), What) )).
test(bad_journal, [ forall(member(Journal, [5,"",false])),
                    What == bad_key(journal, journal) ]) :-
    in_folder(refused(opened(_{file:"a.pl", journal:Journal}), What)).
test(opened_again, New-Replayed-Other == 0-2-1) :-
    in_folder(( journal(Head),
                opened(Head),
                text(2), text(3),
                revisions(opened(Head, Reply), New),
                get_dict(replayed, Reply, Replayed),
                is(3),
                revisions(opened(Head.put(replay, false)), Other),
                is(1) )).
test(damaged, Messages-Replayed == 1-1) :-
    in_folder(( journal(Head),
                opened(Head),
                text(2), text(3),
                killed(b),
                got('b.journal', Text0),
                string_concat(Text1, "\n", Text0),
                sub_string(Text1, 0, _, 1, Text2),
                string_concat(Text2, "!\n", Text),
                put('b.journal', Text),
                opened(_{file:"b.pl", journal:"b.journal"}, Reply),
                get_dict(replayed, Reply, Replayed),
                get_dict(messages, Reply, Said),
                length(Said, Messages),
                is(2),
                got('b.journal.damaged-1', Text),
                \+ exists_file('b.journal.damaged-2') )).
test(usual_place, Files == [1,1]) :-
    in_folder(( opened(_{file:"a.pl", journal:true}),
                text(2),
                kept(a, N1),
                saved(_{file:"c.pl"}),
                kept(a, 0),
                kept(c, N2),
                text(3),
                Files = [N1,N2] )).

kept(Name, N) :-
    format(atom(Pattern), 'state/sanggwan/~w.pl-*.journal', [Name]),
    expand_file_name(Pattern, Files0),
    include(exists_file, Files0, Files),
    length(Files, N).

% --- saving ------------------------------------------------------------------

test(another_wrote_it, Whats == [file_changed('a.pl'),none]) :-
    in_folder(( opened(_{file:"a.pl"}),
                text(2),
                box(9, Text),
                put('a.pl', Text),
                refused(saved(_{}), What1),
                got('a.pl', Text),
                refused(saved(_{force:true}), What2),
                box(2, Text2),
                got('a.pl', Text2),
                Whats = [What1,What2] )).
test(file_gone) :-
    in_folder(( opened(_{file:"a.pl"}),
                delete_file('a.pl'),
                saved(_{}),
                box(1, Text),
                got('a.pl', Text) )).
test(elsewhere, Whats == [file_changed('b.pl'),none]) :-
    in_folder(( opened(_{file:"a.pl"}),
                text(2),
                put('b.pl', ""),
                refused(saved(_{file:"b.pl"}), What1),
                document_file('a.pl'),
                refused(saved(_{file:"c.pl"}), What2),
                document_file('c.pl'),
                document_is_saved(true),
                box(1, Text1),
                box(2, Text2),
                got('a.pl', Text1),
                got('c.pl', Text2),
                Whats = [What1,What2] )).
test(no_name, [ forall(member(Name, ["b.obj",5,"b"])),
                What == bad_key(file, file) ]) :-
    in_folder(( opened(_{file:"a.pl"}),
                refused(saved(_{file:Name}), What) )).

% --- reading again -----------------------------------------------------------

test(reloaded, New == 1) :-
    in_folder(( journal(Head),
                opened(Head),
                box(5, Text),
                put('a.pl', Text),
                document_reloaded(_{look:true}, _, Octets, true),
                assertion(Octets == Text),
                is(1),
                revisions(( document_reloaded(_{}, _, "", Commit),
                            call(Commit) ), New),
                is(5),
                document_is_saved(true),
                saved(_{}),
                changed(undo, _{}, ""),
                is(1) )).
test(reloaded_the_same, New == 0) :-
    in_folder(( opened(_{file:"a.pl"}),
                revisions(( document_reloaded(_{}, Reply, "", Commit),
                            call(Commit) ), New),
                get_dict(segments, Reply, [_]),
                document_is_saved(true) )).
test(reloaded_gone, What == model_error(cannot_read(missing))) :-
    in_folder(( opened(_{file:"a.pl"}),
                delete_file('a.pl'),
                refused(document_reloaded(_{}, _, _, _), What) )).

% --- rules -------------------------------------------------------------------

test(tried, New == [1,1,1]) :-
    in_folder(( opened(_{file:"a.pl"}),
                document_rules("", false),
                document_world(World0),
                Owner = _{owner:true},
                Rules = "may_cut(1, 2).",
                document_tried(Owner, Rules, Before-After, Commit1),
                assertion(( Before == World0, After \== Before )),
                revisions(call(Commit1), New1),
                document_rules(Rules, true),
                document_world(After),
                document_world_before(World0),
                trial_ended(Commit2),
                revisions(call(Commit2), New2),
                document_rules("", false),
                document_world(World0),
                document_tried(Owner, Rules, _, Commit3),
                call(Commit3),
                revisions(changed(rules, Owner, ""), New3),
                document_rules(Rules, false),
                is(1),
                changed(undo, _{}, ""),
                document_rules("", false),
                New = [New1,New2,New3] )).
test(not_tried, Whats == [nothing_tried,nothing_tried,owner_alone(rules),
                          owner_alone(rules)]) :-
    in_folder(( opened(_{file:"a.pl"}),
                refused(trial_ended(_), What1),
                refused(changed(rules, _{owner:true}, ""), What2),
                refused(changed(rules, _{}, ""), What3),
                refused(document_tried(_{}, "", _, _), What4),
                Whats = [What1,What2,What3,What4] )).
test(rules_of_a_journal, What-Rules == owner_alone(journal)-"may_cut(1, 2).") :-
    in_folder(( journal(Head),
                opened(Head),
                document_tried(_{owner:true}, "may_cut(1, 2).", _, Commit),
                call(Commit),
                changed(rules, _{owner:true}, ""),
                killed(b),
                Again = _{file:"b.pl", journal:"b.journal"},
                refused(opened(Again), What),
                opened(Again.put(owner, true)),
                document_rules(Rules, false),
                saved(_{}),
                document_rules(Rules, false) )).
test(tried_while_it_changes) :-
    in_folder(( opened(_{file:"a.pl"}),
                document_tried(_{owner:true}, "may_cut(1, 2).", _, Commit),
                call(Commit),
                text(2),
                document_rules("may_cut(1, 2).", true),
                opened(_{file:"a.pl"}),
                document_rules("", false) )).

:- end_tests(document).
