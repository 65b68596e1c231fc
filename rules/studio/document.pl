:- module(sg_document,
          [ document_opened/3,          % +Head, -Reply, -Commit
            document_changed/5,         % +Request, +Head, +Body, -Reply,
                                        % -Commit
            document_saved/2,           % +Head, -Reply
            document_text/2,            % -Text, -Reply
            document_world/1,           % -World
            document_revision/1,        % -Revision
            document_file/1,            % -File
            document_input/2            % -File, -Text
          ]).
:- use_module('../message/message_object', [objects_heard/2]).
:- use_module('../model/model', [load_model/1]).
:- use_module('../output', [writing/3]).
:- use_module('../store', [in_world/2, new_world/1, segment/3]).
:- use_module(journal,
              [ journal_begun/4, journal_closed/1, journal_line/2,
                journal_steps/3
              ]).
:- use_module(job, [with_input/2]).
:- use_module(protocol, [octets_text/2]).
:- use_module(text_edit, [number_place/5, number_replaced/5]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(readutil), [read_file_to_string/3]).
:- use_module(library(sha), [sha_hash/3, hash_atom/2]).
/** <module> The document of a session: one model, its text, and how it became
what it is.

The text is the truth; a change makes another text, which must load, or there is
no change. Each change has a new number, the revision, also when it is taken
back. What the model of a text is does not depend on the way to it, so the
worlds of the last texts are kept, and undo finds them again.
*/

% document(File, Kind, Revision, Text, Past, Future, Saved, Journal): Kind is
% `text` or `other`, of which there is no text here; Past and Future are texts,
% the nearest first; Saved is the digest of what the file holds; Journal a
% stream or `none`. kept_world(Digest, World): the last used one comes last.
:- dynamic document/8, kept_world/2, last_number/1.

%   most_worlds(N), most_steps(N): kept to go back to.

most_worlds(16).
most_steps(1000).

request_error(What) :-
    throw(error(request_error(What), _)).

%!  document_revision(-Revision:integer) is det.
%
%   0 while there is no document.

document_revision(Revision) :-
    (   document(_, _, Revision0, _, _, _, _, _)
    ->  Revision = Revision0
    ;   Revision = 0
    ).

%!  document_world(-World) is det.
%
%   World holds the model of the document, and is empty if there is none.

document_world(World) :-
    (   document(File, Kind, _, Text, _, _, _, _)
    ->  model_world(Kind, File, Text, World, _)
    ;   new_world(World)
    ).

%!  document_file(-File) is semidet.
%
%   The name of the document's file, as it was opened.

document_file(File) :-
    document(File, _, _, _, _, _, _, _).

%!  document_input(-File, -Text) is semidet.
%
%   What a verb is to read: File is the name of the file, or `-`, when its text
%   was changed since and is to be read as standard input. Fails if there is no
%   document.

document_input(File, Text) :-
    document(File0, Kind, _, Text0, _, _, Saved, _),
    (   Kind == text,
        digest(Text0, Digest),
        Digest \== Saved
    ->  File = (-),
        Text = Text0
    ;   File = File0,
        Text = ""
    ).

%!  document_text(-Text, -Reply:dict) is det.
%
%   @error request_error(no_document), request_error(no_text)

document_text(Text, _{}) :-
    text_document(_, _, Text, _, _, _, _).

text_document(File, Revision, Text, Past, Future, Saved, Journal) :-
    (   document(File, Kind, Revision, Text, Past, Future, Saved, Journal)
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


                /*******************************
                *            WORLDS            *
                *******************************/

%   model_world(Kind, File, Text, World, Objects): World holds the model;
%   Objects are the messages of loading, [] if it is there already.

model_world(Kind, File, Text, World, Objects) :-
    world_key(Kind, File, Text, Key),
    (   retract(kept_world(Key, World0))
    ->  World = World0,
        Objects = []
    ;   new_world(World),
        in_world(World, objects_heard(model_loaded(Kind, File, Text),
                                      Objects))
    ),
    assertz(kept_world(Key, World)),
    forget_worlds.

world_key(text, _, Text, Key) :-
    digest(Text, Key).
world_key(other, File, _, file(File)).

%   A text is read as if it came from standard input.

model_loaded(other, File, _) :-
    load_model(File).
model_loaded(text, _, Text) :-
    with_input(Text, load_model(-)).

forget_worlds :-
    most_worlds(Most),
    predicate_property(kept_world(_, _), number_of_clauses(N)),
    (   N > Most,
        retract(kept_world(_, _))
    ->  forget_worlds
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
                    document(File, Kind, Text, Past, Future, Digest),
                    Journal0, Steps0)) :-
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
        replayed(Steps0, state(Saved, [], []), state(Text, Past, Future))
    ;   Kind = other,
        Text = "",
        Digest = "",
        Past = [],
        Future = [],
        Steps0 = [],
        Journal0 = none
    ),
    retractall(kept_world(file(File), _)),
    model_world(Kind, File, Text, World, Objects),
    length(Steps0, Replayed),
    shape(World, Objects, Shape),
    Reply = Shape.put(_{file:Name, replayed:Replayed}).

:- public open_committed/3.

open_committed(document(File, Kind, Text, Past, Future, Digest), Journal0,
               Steps) :-
    journal_opened(Journal0, File, Digest, Steps, Journal),
    (   document(_, _, _, _, _, _, _, OldJournal)
    ->  journal_closed(OldJournal),
        retractall(document(_, _, _, _, _, _, _, _))
    ;   true
    ),
    next_revision(Revision),
    assertz(document(File, Kind, Revision, Text, Past, Future, Digest,
                     Journal)).

%   model_text(File, Text, Steps, Journal, Head): Journal is file(Path) or none.

model_text(File, Text, Steps, Journal, Head) :-
    catch(read_file_to_string(File, Text, [encoding(utf8)]), error(_, _),
          load_model(File)),            % says what is wrong
    digest(Text, Digest),
    journal_path(Head, File, Path),
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
            ;   Steps = Steps0
            )
        ;   Steps = []
        )
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
    journal_begun(New, File, Digest, Journal),
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
    in_world(World,
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
%   Request is `edit`, `text`, `undo` or `redo`. Reply has the keys segments
%   and messages; of `edit` also `was`, the number that was replaced. When
%   Commit has been called, the change stands in the journal, and the document
%   has it.
%
%   @error request_error(What), model_error(What)

document_changed(Request, Head, Body, Reply,
                 sg_document:change_committed(Kept,
                                              state(Text, Past, Future))) :-
    text_document(File, _, Text0, Past0, Future0, _, _),
    change_step(Request, Head, Body, Text0, Step, More),
    stepped(Step, state(Text0, Past0, Future0), state(Text, Past, Future)),
    model_world(text, File, Text, World, Objects),
    kept_step(Step, Text, Kept),
    shape(World, Objects, Shape),
    Reply = Shape.put(More).

:- public change_committed/2.

%   A journal that could not be written is not gone on with: nothing is
%   changed until the document is opened again.

change_committed(Kept, state(Text, Past, Future)) :-
    document(File, Kind, Revision0, Text0, Past0, Future0, Saved, Journal),
    catch(journal_line(Journal, Kept), Error, true),
    (   nonvar(Error)
    ->  retractall(document(_, _, _, _, _, _, _, _)),
        assertz(document(File, Kind, Revision0, Text0, Past0, Future0, Saved,
                         failed(Journal, Error))),
        throw(Error)
    ;   true
    ),
    next_revision(Revision),
    retractall(document(_, _, _, _, _, _, _, _)),
    assertz(document(File, text, Revision, Text, Past, Future, Saved,
                     Journal)).

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

%   stepped(Step, State0, State): states are state(Text, Past, Future).

stepped(Step, State0, State) :-
    Step.do = Do,
    stepped(Do, Step, State0, State).

stepped("undo", Step, state(Text, Past, Future), State) :-
    (   Past = [Before|Rest]
    ->  State = state(Before, Rest, [Text|Future])
    ;   get_dict(text, Step, Before)
    ->  State = state(Before, [], [Text|Future])
    ;   request_error(nothing_to(undo))
    ).
stepped("redo", Step, state(Text, Past, Future), State) :-
    (   Future = [After|Rest]
    ->  State = state(After, [Text|Past], Rest)
    ;   get_dict(text, Step, After)
    ->  State = state(After, [Text|Past], [])
    ;   request_error(nothing_to(redo))
    ).
stepped("text", Step, state(Text, Past, _), state(Step.text, Steps, [])) :-
    remembered(Text, Past, Steps).
stepped("edit", Step, state(Text, Past, _), state(New, Steps, [])) :-
    number_replaced(Text, Step.from, Step.to, Step.with, New),
    remembered(Text, Past, Steps).

%   kept_step(Step, Text, Kept): as the journal keeps it. A journal begins when
%   the file is saved; what can be taken back may be older.

kept_step(Step, Text, Kept) :-
    (   memberchk(Step.do, ["undo","redo"])
    ->  Kept = Step.put(text, Text)
    ;   Kept = Step
    ).

remembered(Text, Past, Steps) :-
    most_steps(Most),
    (   length(Start, Most),
        append(Start, [_|_], [Text|Past])
    ->  Steps = Start
    ;   Steps = [Text|Past]
    ).

replayed([], State, State).
replayed([Step|Steps], State0, State) :-
    stepped(Step, State0, State1),
    replayed(Steps, State1, State).


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
    text_document(File0, Revision, Text, Past, Future, Saved, Journal0),
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
    digest(Text, Digest),
    journal_line(Journal0, _{do:"save", digest:Digest}),
    writing(File, text, sg_document:text_written(Text)),
    (   Journal0 == none
    ->  Journal = none
    ;   journal_path_of(Journal0, Path),
        journal_closed(Journal0),
        journal_opened(file(Path), File, Digest, [], Journal)
    ),
    retractall(document(_, _, _, _, _, _, _, _)),
    assertz(document(File, text, Revision, Text, Past, Future, Digest,
                     Journal)),
    atom_string(File, FileName),
    Reply = _{file:FileName}.

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
