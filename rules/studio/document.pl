:- module(sg_document,
          [ document_opened/3,          % +Head, -Reply, -Commit
            document_changed/5,         % +Request, +Head, +Body, -Reply,
                                        % -Commit
            document_reloaded/4,        % +Head, -Reply, -Text, -Commit
            document_saved/2,           % +Head, -Reply
            document_text/1,            % -Text
            document_world/1,           % -World
            document_revision/1,        % -Revision
            document_file/1,            % -File
            document_input/2,           % -File, -Text
            document_rules/2,           % -Rules, -Tried
            document_tried/4,           % +Head, +Rules, -Worlds, -Commit
            trial_ended/1               % -Commit
          ]).
:- use_module('../decision', [use_rules_of/2]).
:- use_module('../development/leaf_face', [roots_alone_named/0]).
:- use_module('../message/message_object', [objects_heard/2]).
:- use_module('../model/model', [load_model/1]).
:- use_module('../output', [writing/3]).
:- use_module('../store', [in_world/2, new_world/1, segment/3]).
:- use_module('../unfolding/unfold', [unfoldable/1, wanted_of/3, wishes/3]).
:- use_module(journal,
              [ journal_begun/5, journal_closed/1, journal_line/2,
                journal_steps/3, journal_whole/3
              ]).
:- use_module(job, [with_input/2]).
:- use_module(protocol, [octets_text/2, text_octets/2]).
:- use_module(text_edit, [number_place/5, text_replaced/5, wish_place/6]).
:- use_module(world_state, 
              [ in_state/3, world_begun/1, world_forgotten/1,
                world_is_known/1 ]).
:- use_module(request, [request_error/1]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(readutil), [read_file_to_string/3]).
:- use_module(library(sha), [sha_hash/3, hash_atom/2]).
/** <module> The document of a session: one model, its text, and how it became
what it is.

The text is the truth, with the rules that it follows; a change makes another
text, which must load, or there is no change. Each change has a new number, the
revision, also when it is taken back. What the model of a text is does not
depend on the way to it, so the worlds of the last texts are kept, and undo
finds them again.

Rules may be tried: then the document follows them, with a revision of its own,
until they are kept, which is a change, or discarded.
*/

% document(File, Kind, Revision, State, Saved, Journal): Kind is `text` or
% `other`, of which there is no text here. State is state(Now, Past, Future),
% keys of content_/3, the nearest first; Saved is the digest of what the file
% holds; Journal a stream or `none`. content_(Key, Text, Rules): Rules "" are
% none. kept_world(Key, World): the last used one comes last. tried_(Rules):
% are tried now.
:- dynamic document/6, content_/3, kept_world/2, last_number/1, tried_/1.

%   most_worlds(N), most_steps(N): kept to go back to.

most_worlds(16).
most_steps(1000).

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
        ->  content_(Now, Text, _),
            content(Text, Rules, Key)
        ;   Key = Now
        ),
        model_world(Kind, File, Key, World, _)
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
        content_(Now, Text0, _),
        digest(Text0, Digest),
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
    content_(Now, Text, _).

text_document(File, Revision, State, Saved, Journal) :-
    (   document(File, Kind, Revision, State, Saved, Journal)
    ->  (   Kind == text
        ->  true
        ;   request_error(no_text)
        )
    ;   request_error(no_document)
    ).

digest(Text, Digest) :-
    sha_hash(Text, Hash, [algorithm(sha256), encoding(utf8)]),
    hash_atom(Hash, Digest0),
    atom_string(Digest0, Digest).

%   content(Text, Rules, Key): Key is that of these.

content(Text, Rules, Key) :-
    digest(Text, Of),
    (   Rules == ""
    ->  Key = Of
    ;   digest(Rules, By),
        atomics_to_string([Of,+,By], Key)
    ),
    (   content_(Key, _, _)
    ->  true
    ;   assertz(content_(Key, Text, Rules))
    ).

%   contents_swept: those that nobody goes back to are gone.

contents_swept :-
    most_steps(Most),
    predicate_property(content_(_, _, _), number_of_clauses(N)),
    (   N > Most+256
    ->  (   document(_, _, _, state(Now, Past, Future), _, _)
        ->  append([Now|Past], Future, Keys0),
            sort(Keys0, Keys)
        ;   Keys = []
        ),
        forall(( content_(Key, _, _),
                 \+ memberchk(Key, Keys) ),
               retractall(content_(Key, _, _)))
    ;   true
    ).


                /*******************************
                *            WORLDS            *
                *******************************/

%   model_world(Kind, File, Key, World, Objects): World holds the model;
%   Objects are the messages of loading, [] if it is there already.

model_world(Kind, File, Key, World, Objects) :-
    (   retract(kept_world(Key, World0)),
        world_is_known(World0)
    ->  World = World0,
        Objects = []
    ;   new_world(World),
        in_world(World, objects_heard(model_loaded(Kind, File, Key),
                                      Objects)),
        world_begun(World)
    ),
    assertz(kept_world(Key, World)),
    forget_worlds.

%   A text is read as if it came from standard input.

model_loaded(other, File, _) :-
    load_model(File).
model_loaded(text, _, Key) :-
    content_(Key, Text, Rules),
    (   Rules == ""
    ->  true
    ;   with_input(Rules, use_rules_of(-, rules))
    ),
    with_input(Text, load_model(-)).

forget_worlds :-
    most_worlds(Most),
    predicate_property(kept_world(_, _), number_of_clauses(N)),
    (   N > Most,
        retract(kept_world(_, World))
    ->  world_forgotten(World),
        forget_worlds
    ;   true
    ).


                /*******************************
                *             OPEN             *
                *******************************/

%!  document_opened(+Head:dict, -Reply:dict, -Commit:callable) is det.
%
%   When Commit has been called, the document is the model in the file
%   Head.file; with a journal, with all that was changed since it was saved.
%
%   @error model_error(What), request_error(What)

document_opened(Head, Reply,
                sg_document:open_committed(
                    opened(File, Kind, State, Digest), Journal0, Steps0)) :-
    (   get_dict(file, Head, Name),
        string(Name),
        Name \== ""
    ->  atom_string(File, Name)
    ;   request_error(bad_key(file, file))
    ),
    file_name_extension(_, Ending, File),
    (   Ending == pl
    ->  Kind = text,
        model_text(File, Saved, Steps0, Journal0, Head),
        digest(Saved, Digest),
        content(Saved, "", Begin),
        replayed(Steps0, state(Begin, [], []), State)
    ;   Kind = other,
        Digest = "",
        State = state(file(File), [], []),
        Steps0 = [],
        Journal0 = none
    ),
    forall(retract(kept_world(file(File), Old)), world_forgotten(Old)),
    State = state(Key, _, _),
    model_world(Kind, File, Key, World, Objects),
    length(Steps0, Replayed),
    shape(World, Objects, Shape),
    Reply = Shape.put(_{file:Name, replayed:Replayed}).

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
    contents_swept.

%   model_text(File, Text, Steps, Journal, Head): Journal is file(Path) or none.

model_text(File, Text, Steps, Journal, Head) :-
    catch(read_file_to_string(File, Text0, [encoding(utf8)]), error(_, _),
          load_model(File)),            % says what is wrong
    journal_path(Head, File, Path),
    (   get_dict(replay, Head, "journal"),
        Path \== none,
        journal_whole(Path, Text, Steps)
    ->  Journal = file(Path),
        rules_allowed(Steps, Head)
    ;   Text = Text0,
        text_steps(Path, Text, Head, Steps, Journal)
    ).

%   text_steps(Path, Text, Head, Steps, Journal): the steps from Text on that
%   the journal Path has.

text_steps(Path, Text, Head, Steps, Journal) :-
    digest(Text, Digest),
    (   Path == none
    ->  Steps = [],
        Journal = none
    ;   Journal = file(Path),
        (   exists_file(Path),
            \+ journal_steps(Path, Digest, _)
        ->  request_error(no_journal(Path))
        ;   true
        ),
        (   get_dict(replay, Head, false)
        ->  Steps = []
        ;   journal_steps(Path, Digest, Steps0)
        ->  (   Steps0 == other
            ->  request_error(journal_of_another(Path))
            ;   Steps = Steps0,
                rules_allowed(Steps, Head)
            )
        ;   Steps = []
        )
    ).

%   rules_allowed(Steps, Head): rules run code, those of a journal too.

rules_allowed(Steps, Head) :-
    (   member(Step, Steps),
        get_dict(rules, Step, Rules),
        Rules \== ""
    ->  of_owner(Head, journal)
    ;   true
    ).

%   of_owner(Head, What): the request is the owner's.

of_owner(Head, What) :-
    (   get_dict(owner, Head, true)
    ->  true
    ;   request_error(owner_alone(What))
    ).

journal_path(Head, File, Path) :-
    (   get_dict(journal, Head, Wanted)
    ->  (   Wanted == true
        ->  usual_path(File, Path)
        ;   string(Wanted),
            Wanted \== ""
        ->  atom_string(Path, Wanted)
        ;   request_error(bad_key(journal, journal))
        )
    ;   Path = none
    ).

%   usual_path(File, Path): one for each file.

usual_path(File, Path) :-
    (   getenv('XDG_STATE_HOME', State),
        State \== ''
    ->  true
    ;   getenv('HOME', Home),
        atom_concat(Home, '/.local/state', State)
    ),
    absolute_file_name(File, Absolute),
    digest(Absolute, Digest),
    sub_string(Digest, 0, 16, _, Short),
    file_base_name(File, Base),
    format(atom(Path), "~w/sanggwan/~w-~w.journal", [State, Base, Short]).

%   journal_opened(Where, File, Digest, Steps, Journal): it is written anew,
%   with the complete lines that it had.

journal_opened(none, _, _, _, none).
journal_opened(file(Path), File, Digest, Steps, Journal) :-
    atom_concat(Path, '.new', New),
    content_(Digest, Text, ""),
    journal_begun(New, File, Digest, Text, Journal),
    catch(( forall(member(Step, Steps), journal_line(Journal, Step)),
            rename_file(New, Path)
          ),
          Error,
          ( journal_closed(Journal),
            throw(Error)
          )).

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
             findall(_{segment:S, kind:Kind, name:Text},
                     ( segment(S, Kind, Name),
                       format(string(Text), "~W",
                              [Name, [quoted(true), max_depth(20)]]) ),
                     Segments)).


                /*******************************
                *            CHANGE            *
                *******************************/

%!  document_changed(+Request, +Head:dict, +Body, -Reply:dict,
%!                   -Commit:callable) is det.
%
%   Request is `edit`, `cut`, `text`, `undo`, `redo` or `rules`. Reply has the
%   keys segments and messages; of `edit` also `was`, the number that was
%   replaced, of `cut` `wish`, the fact that is there now. When
%   Commit has been called, the change stands in the journal, and the document
%   has it.
%
%   @error request_error(What), model_error(What)

document_changed(Request, Head, Body, Reply,
                 sg_document:change_committed(Kept, State)) :-
    text_document(File, _, State0, _, _),
    contents_swept,
    State0 = state(Key0, _, _),
    content_(Key0, Text0, _),
    change_step(Request, Head, Body, Text0, Step, More),
    stepped(Step, State0, State),
    State = state(Key, _, _),
    seen_key(Request, Key, Seen),
    model_world(text, File, Seen, World, Objects),
    change_checked(Request, Head, World),
    kept_step(Step, Key, Kept),
    shape(World, Objects, Shape),
    Reply = Shape.put(More).

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
    ->  content_(Key, Text, _),
        content(Text, Rules, Seen)
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
    contents_swept.

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
    content_(Now, Text0, Rules),
    digest(Text, Digest),
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

%   change_step(Request, Head, Body, Text, Step, More): Step as in the journal.

change_step(undo, _, _, _, _{do:"undo"}, _{}).
change_step(redo, _, _, _, _{do:"redo"}, _{}).
change_step(text, _, Body, _, _{do:"text", text:Text}, _{}) :-
    octets_text(Body, Text).
change_step(edit, Head, _, Text, _{do:"edit", from:From, to:To, with:Value},
            _{was:Number}) :-
    (   get_dict(set, Head, Set),
        is_dict(Set),
        get_dict(value, Set, Value),
        number(Value),
        edited(Set, Which)
    ->  number_place(Text, Which, From, To, Number)
    ;   request_error(bad_key(set, set))
    ).
change_step(cut, Head, _, Text, _{do:"edit", from:From, to:To, with:Fact},
            _{wish:Wish}) :-
    (   get_dict(segment, Head, S),
        integer(S),
        get_dict(edge, Head, Edge),
        ( integer(Edge) ; string(Edge) ),
        wished(Head, Name)
    ->  wish_place(Text, wish(S, Name, Edge), From, To, Fact, Wish)
    ;   request_error(bad_key(edge, edge))
    ).
change_step(rules, Head, _, _, _{do:"rules", rules:Rules}, _{}) :-
    of_owner(Head, rules),
    (   tried_(Rules)
    ->  true
    ;   request_error(nothing_tried)
    ).

wished(Head, Name) :-
    (   get_dict(keep, Head, Keep)
    ->  (   Keep == true
        ->  Name = keep
        ;   Keep == false
        ->  Name = cut
        ;   Keep == null,
            Name = none
        )
    ;   Name = cut
    ).

edited(Set, param(Name)) :-
    get_dict(param, Set, Text),
    !,
    string(Text),
    atom_string(Name, Text).
edited(Set, segment(S, Path)) :-
    get_dict(segment, Set, S),
    integer(S),
    get_dict(path, Set, Path),
    is_list(Path),
    forall(member(I, Path), ( integer(I), I > 0 )).

%   stepped(Step, State0, State): states are state(Now, Past, Future), of keys.

stepped(Step, State0, State) :-
    Step.do = Do,
    stepped(Do, Step, State0, State).

stepped("undo", Step, state(Now, Past, Future), State) :-
    (   Past = [Before|Rest]
    ->  State = state(Before, Rest, [Now|Future])
    ;   step_content(Step, Before)
    ->  State = state(Before, [], [Now|Future])
    ;   request_error(nothing_to(undo))
    ).
stepped("redo", Step, state(Now, Past, Future), State) :-
    (   Future = [After|Rest]
    ->  State = state(After, [Now|Past], Rest)
    ;   step_content(Step, After)
    ->  State = state(After, [Now|Past], [])
    ;   request_error(nothing_to(redo))
    ).
stepped("text", Step, State0, State) :-
    State0 = state(Now, _, _),
    content_(Now, _, Rules),
    content(Step.text, Rules, Key),
    gone_on(Key, State0, State).
stepped("edit", Step, State0, State) :-
    State0 = state(Now, _, _),
    content_(Now, Text, Rules),
    text_replaced(Text, Step.from, Step.to, Step.with, New),
    content(New, Rules, Key),
    gone_on(Key, State0, State).
stepped("rules", Step, State0, State) :-
    State0 = state(Now, _, _),
    content_(Now, Text, _),
    content(Text, Step.rules, Key),
    gone_on(Key, State0, State).

gone_on(Key, state(Now, Past, _), state(Key, Steps, [])) :-
    most_steps(Most),
    (   length(Start, Most),
        append(Start, [_|_], [Now|Past])
    ->  Steps = Start
    ;   Steps = [Now|Past]
    ).

%   step_content(Step, Key) is semidet: Step says what it led to.

step_content(Step, Key) :-
    get_dict(text, Step, Text),
    (   get_dict(rules, Step, Rules)
    ->  true
    ;   Rules = ""
    ),
    content(Text, Rules, Key).

%   kept_step(Step, Key, Kept): as the journal keeps it. A journal begins when
%   the file is saved; what can be taken back may be older.

kept_step(Step, Key, Kept) :-
    (   memberchk(Step.do, ["undo","redo"])
    ->  content_(Key, Text, Rules),
        (   Rules == ""
        ->  Kept = Step.put(text, Text)
        ;   Kept = Step.put(_{text:Text, rules:Rules})
        )
    ;   Kept = Step
    ).

replayed([], State, State).
replayed([Step|Steps], State0, State) :-
    stepped(Step, State0, State1),
    replayed(Steps, State1, State).


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
    ->  content_(Now, _, Rules),
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
    text_document(File, _, state(Now, _, _), _, _),
    of_owner(Head, rules),
    model_world(text, File, Now, Before, _),
    content_(Now, Text, _),
    content(Text, Rules, Key),
    model_world(text, File, Key, After, _).

:- public trial_committed/1.

trial_committed(Rules) :-
    retractall(tried_(_)),
    assertz(tried_(Rules)),
    revision_made,
    contents_swept.

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
    content_(Now, Text, Rules),
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
    content(Text, "", Digest),
    first_steps(Rules, Steps),
    save_step(Rules, Digest, Step),
    journal_line(Journal0, Step),
    writing(File, text, sg_document:text_written(Text)),
    (   Journal0 == none
    ->  Journal = none
    ;   journal_path_of(Journal0, Path0),
        path_saved(File0, File, Path0, Path),
        journal_closed(Journal0),
        journal_opened(file(Path), File, Digest, Steps, Journal)
    ),
    retractall(document(_, _, _, _, _, _)),
    assertz(document(File, text, Revision, State, Digest, Journal)),
    old_journal_gone(Journal, Path0, Path),
    atom_string(File, FileName),
    Reply = _{file:FileName}.

%   path_saved(File0, File, Path0, Path): a journal in the usual place goes with
%   the name of the file.

path_saved(File0, File, Path0, Path) :-
    usual_path(File0, Usual),
    (   Usual == Path0
    ->  usual_path(File, Path)
    ;   Path = Path0
    ).

old_journal_gone(Journal, Path0, Path) :-
    (   Journal \== none,
        Path0 \== Path
    ->  catch(delete_file(Path0), error(_, _), true)
    ;   true
    ).

%   first_steps(Rules, Steps): a file of a model has no rules, its journal has.

first_steps("", []) :-
    !.
first_steps(Rules, [_{do:"rules", rules:Rules}]).

save_step(Rules, Digest, Step) :-
    Step0 = _{do:"save", digest:Digest},
    (   Rules == ""
    ->  Step = Step0
    ;   Step = Step0.put(rules, Rules)
    ).

:- public text_written/2.

text_written(Text, Out) :-
    format(Out, "~s", [Text]).

journal_path_of(Journal, Path) :-
    stream_property(Journal, file_name(New)),
    (   atom_concat(Path0, '.new', New)
    ->  Path = Path0
    ;   Path = New
    ).

not_changed(File, File0, Saved) :-
    (   File == File0
    ->  (   catch(read_file_to_string(File, Text, [encoding(utf8)]),
                  error(_, _), fail),
            digest(Text, Digest),
            Digest \== Saved
        ->  request_error(file_changed(File))
        ;   true
        )
    ;   exists_file(File)
    ->  request_error(file_changed(File))
    ;   true
    ).
