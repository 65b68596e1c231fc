:- module(sg_document,
          [ document_opened/3,          % +Head, -Reply, -Commit
            document_changed/5,         % +Request, +Head, +Body, -Reply,
                                        % -Commit
            document_reloaded/4,        % +Head, -Reply, -Text, -Commit
            document_saved/2,           % +Head, -Reply
            document_text/1,            % -Text
            document_is_saved/1,        % -Boolean
            document_world/1,           % -World
            document_world_before/1,    % -World
            document_revision/1,        % -Revision
            document_file/1,            % -File
            document_input/2,           % -File, -Text
            document_rules/2,           % -Rules, -Tried
            document_tried/4,           % +Head, +Rules, -Worlds, -Commit
            trial_ended/1               % -Commit
          ]).
:- use_module('../development/leaf_face', [roots_alone_named/0]).
:- use_module('../message/message_object', [message_object/3]).
:- use_module('../model/model', [model_format/2]).
:- use_module('../output', [writing/3]).
:- use_module('../store', [segment/3]).
:- use_module('../unfolding/unfold', [unfoldable/1, wanted_of/3, wishes/3]).
:- use_module(document_content,
              [ content/3, content_key/3, contents_swept/1,
                file_world_forgotten/1, model_world/5, text_digest/2
              ]).
:- use_module(document_journal,
              [ damaged_path/2, first_steps/2, journal_opened/5, journal_path/2,
                model_text/5, path_saved/4, save_step/3, wanted_path/3
              ]).
:- use_module(document_step,
              [ change_step/6, checkpoint/3, kept_step/3, replayed/4,
                stepped/3, steps_changes/2
              ]).
:- use_module(journal, [journal_closed/1, journal_gone/1, journal_line/2]).
:- use_module(protocol, [text_octets/2]).
:- use_module(request, [of_owner/2, request_error/1]).
:- use_module(world_state, [in_state/3]).
:- use_module(library(lists), [append/3]).
:- use_module(library(ordsets), [ord_memberchk/2]).
:- use_module(library(readutil), [read_file_to_string/3]).
/** <module> The document of a session: one model, its text, and how it became
what it is.

The text is the truth, with the rules that it follows; a change makes another
text, which must load, or there is no change. Each change has a new number, the
revision, also when it is taken back.

Rules may be tried: then the document follows them, with a revision of its own,
until they are kept, which is a change, or discarded.
*/

% document(File, Kind, Revision, State, Saved, Journal): Kind is `text` or
% `other`, of which there is no text here. State is that of document_step.pl, or
% state(file(File), [], []); Saved is the digest of what the file holds; Journal
% a stream or `none`. tried_(Rules): are tried now.
:- dynamic document/6, last_number/1, tried_/1.

%!  document_revision(-Revision:integer) is det.
%
%   0 while there is no document.

document_revision(Revision) :-
    (   document(_, _, Revision0, _, _, _)
    ->  Revision = Revision0
    ;   Revision = 0
    ).

%!  document_world(-World) is det.
%
%   World holds the model of the document, by the rules that it follows, or that
%   are tried.
%
%   @error request_error(no_document)

document_world(World) :-
    (   document(File, Kind, _, state(Now, _, _), _, _)
    ->  (   tried_(Rules)
        ->  content(Now, Text, _),
            content_key(Text, Rules, Key)
        ;   Key = Now
        ),
        model_world(Kind, File, Key, World, _)
    ;   request_error(no_document)
    ).

%!  document_world_before(-World) is det.
%
%   World holds the model by the rules that the document follows, whatever is
%   tried.
%
%   @error request_error(no_document)

document_world_before(World) :-
    (   document(File, Kind, _, state(Now, _, _), _, _)
    ->  model_world(Kind, File, Now, World, _)
    ;   request_error(no_document)
    ).

%!  document_file(-File) is semidet.
%
%   The name of the document's file, as it was opened.

document_file(File) :-
    document(File, _, _, _, _, _).

%!  document_input(-File, -Text) is semidet.
%
%   What a verb is to read: File is the name of the file, or `-`, when its text
%   was changed since and is to be read as standard input. Fails if there is no
%   document.

document_input(File, Text) :-
    document(File0, Kind, _, state(Now, _, _), Saved, _),
    (   Kind == text,
        content(Now, Text0, _),
        text_digest(Text0, Digest),
        Digest \== Saved
    ->  File = (-),
        Text = Text0
    ;   File = File0,
        Text = ""
    ).

%!  document_text(-Text) is det.
%
%   @error request_error(no_document), request_error(no_text)

document_text(Text) :-
    text_document(_, _, state(Now, _, _), _, _),
    content(Now, Text, _).

%!  document_is_saved(-Boolean) is det.
%
%   `true` if the text is that of its file, as it was read or written last, and
%   otherwise `false`.
%
%   @error request_error(no_document), request_error(no_text)

document_is_saved(Boolean) :-
    text_document(_, _, state(Now, _, _), Saved, _),
    content(Now, Text, _),
    (   text_digest(Text, Saved)
    ->  Boolean = true
    ;   Boolean = false
    ).

text_document(File, Revision, State, Saved, Journal) :-
    (   document(File, Kind, Revision, State, Saved, Journal)
    ->  (   Kind == text
        ->  true
        ;   request_error(no_text)
        )
    ;   request_error(no_document)
    ).


                /*******************************
                *             OPEN             *
                *******************************/

%!  document_opened(+Head:dict, -Reply:dict, -Commit:callable) is det.
%
%   When Commit has been called, the document is the model in the file
%   Head.file; with a journal, with all that was changed since it was saved.
%   A document with a journal that is opened again stays as it is.
%
%   @error model_error(What), request_error(What)

document_opened(Head, Reply, Commit) :-
    (   get_dict(file, Head, Name),
        string(Name),
        Name \== ""
    ->  atom_string(File, Name)
    ;   request_error(bad_key(file, file))
    ),
    (   model_format(File, pl)
    ->  Kind = text,
        text_opened(File, Head, State, Replayed, Said, Commit)
    ;   Kind = other,
        State = state(file(File), [], []),
        Replayed = 0,
        Said = [],
        Commit = sg_document:open_committed(opened(File, Kind, State, ""),
                                            none, [])
    ),
    file_world_forgotten(File),
    State = state(Key, _, _),
    catch(model_world(Kind, File, Key, World, Objects0), Error,
          not_loaded(Replayed, Head, File, Error)),
    append(Said, Objects0, Objects),
    shape(World, Objects, Shape),
    Reply = Shape.put(_{file:Name, replayed:Replayed}).

%   not_loaded(Replayed, Head, File, Error): what is wrong stands in no file if
%   changes were made to it: it names both, the file and the journal.

not_loaded(Replayed, Head, File, Error) :-
    (   Replayed > 0,
        Error = error(What, location('<stdin>', Line, Column)),
        wanted_path(Head, File, Path)
    ->  atomic_list_concat([File,Path], ' + ', Both),
        throw(error(What, location(Both, Line, Column)))
    ;   throw(Error)
    ).

%   text_opened(File, Head, State, Replayed, Said, Commit): Said are messages of
%   the journal.

text_opened(File, Head, State, Replayed, Said, Commit) :-
    get_time(Begun),
    model_text(File, Saved, Steps0, Journal0, Head),
    text_digest(Saved, Digest),
    (   open_already(File, Digest, Journal0, Head, State)
    ->  steps_changes(Steps0, Replayed),
        Said = [],
        Commit = true
    ;   content_key(Saved, "", First),
        replayed(Steps0, state(First, [], []), State, Steps),
        steps_changes(Steps, Replayed),
        (   Steps == Steps0
        ->  Journal = Journal0,
            Said = []
        ;   Journal0 = file(Path),
            damaged_path(Path, Kept),
            Journal = damaged(Path, Kept),
            message_object(warning,
                           error(request_error(journal_damaged(Path, Replayed,
                                                               Kept)), _),
                           Object),
            Said = [Object]
        ),
        content_key(Saved, "", First),
        get_time(Now),
        next_steps(Begun, Now, Steps, Replayed, State, Next),
        Commit = sg_document:open_committed(
                     opened(File, text, State, Digest), Journal, Next)
    ).

%   open_already(File, Digest, Journal, Head, State) is semidet: the document is
%   that of File, which holds what it held then, and all changes since are in
%   the same Journal: it stays as it is, and so does its revision.

open_already(File, Digest, file(Path), Head, State) :-
    \+ get_dict(replay, Head, _),
    \+ tried_(_),
    document(File, text, _, State, Digest, Journal),
    is_stream(Journal),
    journal_path(Journal, Path),
    exists_file(Path).

%   next_steps(Begun, Now, Steps, Changes, State, Next): a journal begins with
%   Next. Who waited too long for Steps does not wait for them again.

most_replay_seconds(2).

next_steps(Begun, Now, Steps, Changes, State, Next) :-
    most_replay_seconds(Most),
    (   Now-Begun > Most
    ->  Next = [Checkpoint],
        checkpoint(State, Changes, Checkpoint)
    ;   Next = Steps
    ).

:- public open_committed/3.

open_committed(opened(File, Kind, State, Digest), Journal0, Steps) :-
    journal_opened(Journal0, File, Digest, Steps, Journal),
    (   document(_, _, _, _, _, OldJournal)
    ->  journal_closed(OldJournal),
        retractall(document(_, _, _, _, _, _))
    ;   true
    ),
    retractall(tried_(_)),
    next_revision(Revision),
    assertz(document(File, Kind, Revision, State, Digest, Journal)),
    contents_swept(State).

next_revision(Revision) :-
    (   retract(last_number(N))
    ->  true
    ;   N = 0
    ),
    Revision is N+1,
    assertz(last_number(Revision)).

%   shape(World, Objects, Shape): what a pane shows of a model first.

shape(World, Objects, _{segments:Segments, messages:Objects}) :-
    in_state(World, loaded,
             ( findall(S, unfoldable(S), Unfoldable),
               findall(Shape, segment_shape(Unfoldable, Shape), Shapes) )),
    sort(segment, @<, Shapes, Segments).

segment_shape(Unfoldable,
              _{segment:S, kind:Kind, name:Text, unfolds:Unfolds}) :-
    segment(S, Kind, Name),
    format(string(Text), "~W", [Name, [quoted(true), max_depth(20)]]),
    (   ord_memberchk(S, Unfoldable)
    ->  Unfolds = true
    ;   Unfolds = false
    ).


                /*******************************
                *            CHANGE            *
                *******************************/

%!  document_changed(+Request, +Head:dict, +Body, -Reply:dict,
%!                   -Commit:callable) is det.
%
%   Request is `edit`, `cut`, `question`, `text`, `undo`, `redo` or `rules`.
%   Reply has the keys segments and messages; of `edit` also `was`, the number
%   that was replaced, of `cut` `wish` and of `question` `question`, the fact
%   that is there now. When Commit has been called, the change stands in the
%   journal, and the document has it.
%
%   @error request_error(What), model_error(What)

document_changed(Request, Head, Body, Reply,
                 sg_document:change_committed(Kept, State)) :-
    text_document(File, _, State0, _, _),
    contents_swept(State0),
    State0 = state(Key0, _, _),
    content(Key0, Text0, _),
    asked_step(Request, Head, Body, Text0, Step, More),
    stepped(Step, State0, State),
    State = state(Key, _, _),
    seen_key(Request, Key, Seen),
    model_world(text, File, Seen, World, Objects),
    change_checked(Request, Head, World),
    kept_step(Step, Key, Kept),
    shape(World, Objects, Shape),
    Reply = Shape.put(More).

%   asked_step(Request, Head, Body, Text, Step, More): as change_step/6; rules
%   that are tried may be kept.

asked_step(rules, Head, _, _, Step, More) :-
    !,
    Step = _{do:"rules", rules:Rules},
    More = _{},
    of_owner(Head, rules),
    (   tried_(Rules)
    ->  true
    ;   request_error(nothing_tried)
    ).
asked_step(Request, Head, Body, Text, Step, More) :-
    change_step(Request, Head, Body, Text, Step, More).

%   change_checked(Request, Head, World): patterns of World can have the wish.

change_checked(Request, Head, World) :-
    (   Request == cut
    ->  get_dict(segment, Head, S),
        (   in_state(World, loaded, unfoldable(S))
        ->  true
        ;   in_state(World, loaded, findall(Known, unfoldable(Known), All)),
            request_error(bad_key(segment, no_segment(S, All)))
        ),
        in_state(World, loaded,
                 ( roots_alone_named,
                   wishes(S, [], Wishes),
                   wanted_of(S, Wishes, _) ))
    ;   true
    ).

%   seen_key(Request, Key, Seen): of the world that is seen then; what is tried
%   stays tried, until it is kept.

seen_key(Request, Key, Seen) :-
    (   Request \== rules,
        tried_(Rules)
    ->  content(Key, Text, _),
        content_key(Text, Rules, Seen)
    ;   Seen = Key
    ).

:- public change_committed/2.

%   A journal that could not be written is not gone on with: nothing is
%   changed until the document is opened again.

change_committed(Kept, State) :-
    document(File, Kind, Revision0, State0, Saved, Journal),
    catch(journal_line(Journal, Kept), Error, true),
    (   nonvar(Error)
    ->  retractall(document(_, _, _, _, _, _)),
        assertz(document(File, Kind, Revision0, State0, Saved,
                         failed(Journal, Error))),
        throw(Error)
    ;   true
    ),
    (   get_dict(do, Kept, "rules")
    ->  retractall(tried_(_))
    ;   true
    ),
    next_revision(Revision),
    retractall(document(_, _, _, _, _, _)),
    assertz(document(File, text, Revision, State, Saved, Journal)),
    contents_swept(State).

%!  document_reloaded(+Head:dict, -Reply:dict, -Octets,
%!                    -Commit:callable) is det.
%
%   Another program wrote the file. When Commit has been called, its text is
%   that of the document: a change like any other. With Head.look true nothing
%   is changed, and Octets is the text of the file.
%
%   @error model_error(What), request_error(What)

document_reloaded(Head, Reply, Octets, Commit) :-
    text_document(File, _, State, _, Journal),
    (   catch(read_file_to_string(File, Text, [encoding(utf8)]), error(_, _),
              fail)
    ->  true
    ;   throw(error(model_error(cannot_read(missing)), location(File, 0, 0)))
    ),
    text_octets(Text, Octets0),
    State = state(Now, _, _),
    content(Now, Text0, Rules),
    text_digest(Text, Digest),
    (   get_dict(look, Head, true)
    ->  Octets = Octets0,
        Reply = _{},
        Commit = true
    ;   Octets = "",
        save_step(Rules, Digest, Step),
        (   Text == Text0
        ->  document_world(World),
            shape(World, [], Reply),
            Change = true
        ;   document_changed(text, Head, Octets0, Reply, Change)
        ),
        Commit = sg_document:reload_committed(Change, Journal, Step, Digest)
    ).

:- public reload_committed/4.

%   The journal says that the file holds this text now, as when it is saved.

reload_committed(Change, Journal, Step, Digest) :-
    call(Change),
    journal_line(Journal, Step),
    retract(document(File, Kind, Revision, State, _, Journal)),
    assertz(document(File, Kind, Revision, State, Digest, Journal)).


                /*******************************
                *             RULES            *
                *******************************/

%!  document_rules(-Rules, -Tried) is det.
%
%   Rules is the text of the rules that the document follows, "" if there are
%   none; Tried is true if they are only tried.
%
%   @error request_error(no_document)

document_rules(Rules, Tried) :-
    (   tried_(Rules0)
    ->  Rules = Rules0,
        Tried = true
    ;   document(_, text, _, state(Now, _, _), _, _)
    ->  content(Now, _, Rules),
        Tried = false
    ;   document(_, _, _, _, _, _)
    ->  Rules = "",
        Tried = false
    ;   request_error(no_document)
    ).

%!  document_tried(+Head:dict, +Rules, -Worlds, -Commit:callable) is det.
%
%   When Commit has been called, the document follows the text Rules, to try
%   them. Worlds is Before-After, of the rules that it had and of these.
%
%   @error request_error(owner_alone(rules)), model_error(rules(What))

document_tried(Head, Rules, Before-After,
               sg_document:trial_committed(Rules)) :-
    text_document(File, _, State, _, _),
    of_owner(Head, rules),
    contents_swept(State),
    State = state(Now, _, _),
    model_world(text, File, Now, Before, _),
    content(Now, Text, _),
    content_key(Text, Rules, Key),
    model_world(text, File, Key, After, _).

:- public trial_committed/1.

trial_committed(Rules) :-
    retractall(tried_(_)),
    assertz(tried_(Rules)),
    revision_made.

%!  trial_ended(-Commit:callable) is det.
%
%   When Commit has been called, no rules are tried.
%
%   @error request_error(nothing_tried)

trial_ended(sg_document:trial_left) :-
    (   tried_(_)
    ->  true
    ;   request_error(nothing_tried)
    ).

:- public trial_left/0.

trial_left :-
    retractall(tried_(_)),
    revision_made.

revision_made :-
    retract(document(File, Kind, _, State, Saved, Journal)),
    next_revision(Revision),
    assertz(document(File, Kind, Revision, State, Saved, Journal)).


                /*******************************
                *             SAVE             *
                *******************************/

%!  document_saved(+Head:dict, -Reply:dict) is det.
%
%   The text stands in its file, or in Head.file, which is the document's from
%   now on; its journal begins anew.
%
%   @error request_error(file_changed(File)): another one wrote it since, and
%   Head has no `"force":true`

document_saved(Head, Reply) :-
    text_document(File0, Revision, State, Saved, Journal0),
    State = state(Now, _, _),
    content(Now, Text, Rules),
    (   get_dict(file, Head, Name)
    ->  (   string(Name),
            file_name_extension(_, pl, Name)
        ->  atom_string(File, Name)
        ;   request_error(bad_key(file, file))
        )
    ;   File = File0
    ),
    (   get_dict(force, Head, true)
    ->  true
    ;   not_changed(File, File0, Saved)
    ),
    content_key(Text, "", Digest),
    first_steps(Rules, Steps),
    save_step(Rules, Digest, Step),
    journal_line(Journal0, Step),
    writing(File, text, sg_document:text_written(Text)),
    (   Journal0 == none
    ->  Journal = none
    ;   journal_path(Journal0, Path0),
        path_saved(File0, File, Path0, Path),
        journal_closed(Journal0),
        journal_opened(file(Path), File, Digest, Steps, Journal)
    ),
    retractall(document(_, _, _, _, _, _)),
    assertz(document(File, text, Revision, State, Digest, Journal)),
    old_journal_gone(Journal, Path0, Path),
    atom_string(File, FileName),
    Reply = _{file:FileName}.

old_journal_gone(Journal, Path0, Path) :-
    (   Journal \== none,
        Path0 \== Path
    ->  journal_gone(Path0)
    ;   true
    ).

:- public text_written/2.

text_written(Text, Out) :-
    format(Out, "~s", [Text]).

not_changed(File, File0, Saved) :-
    (   File == File0
    ->  (   catch(read_file_to_string(File, Text, [encoding(utf8)]),
                  error(_, _), fail),
            text_digest(Text, Digest),
            Digest \== Saved
        ->  request_error(file_changed(File))
        ;   true
        )
    ;   exists_file(File)
    ->  request_error(file_changed(File))
    ;   true
    ).
