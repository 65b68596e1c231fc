:- module(sg_session,
          [ session/4                   % :Run, :Makers, :Help, -Status
          ]).
:- use_module('../decision', [decision/4]).
:- use_module('../kernel', [reader_gone/1, stdio_apart/2]).
:- use_module('../message/decision_ko', [decision_ko/2]).
:- use_module('../message/message_object', [message_object/3, objects_heard/2]).
:- use_module('../progress', [with_progress_told/3]).
:- use_module('../spelling', [near_words/3]).
:- use_module('../store', [in_world/2]).
:- use_module('../version', [version/1]).
:- use_module(ask,
              [asked/3, asks_forgotten/0, next_answers/2, question_state/2]).
:- use_module(ask_problem, [problems_listed/2, problem_posed/3]).
:- use_module(line_change, [changed_lines/4]).
:- use_module(complete, [completed/4]).
:- use_module(document,
              [ document_changed/5, document_file/1, document_input/2,
                document_is_saved/1, document_opened/3, document_reloaded/4,
                document_revision/1, document_rules/2, document_saved/2,
                document_text/1, document_tried/4,
                document_world/1, document_world_before/1, trial_ended/1
              ]).
:- use_module(document_verb, [of_the_document/6]).
:- use_module(job, [captured/2, verb_job/5, worlds_collected/0]).
:- use_module(laid_out, [sheet_laid/4, shaded/4, unfolded/4, folded/4]).
:- use_module(model_tree, [text_tree/2]).
:- use_module(port, [view_port/2, viewed/4, with_picture/3]).
:- use_module(process_limit,
              [ limits_forgotten/0, few_collections/0, memory_limited/1,
                cpu_wanted/1, cpu_limited/0 ]).
:- use_module(protocol, [frame_read/4, frame_write/3, octets_text/2,
                         text_octets/2]).
:- use_module(request, [request_error/1, request_options/2]).
:- use_module(select, [selected/3, selection_forgotten/0]).
:- use_module(stop, [committed/1, stop_all/2, stop_answered/2, stop_asked/3,
                     stoppable/3, stops_forgotten/0, under_way/1]).
:- use_module(world_state, [in_state/3]).
:- use_module(library(apply), [maplist/2]).
/** <module> A session: frames in, frames out (docs/protocol.md).

`sanggwan serve --stdio` is one process for one who asks: a studio, an editor, a
batch, a test. It reads requests from its standard input and answers each, in
their order, on its standard output; what verbs print never gets between the
frames. There is no network in it.

A second thread reads, so that `stop` is heard while the work goes on.

All that does not change the document is asked of its world in a snapshot, in
the state that the request needs (world_state.pl), which is made once a
revision.
*/

:- meta_predicate session(2, :, :, -).

% newest(Port, Sequence): the last `view` that came for Port.
:- dynamic newest/2.

%!  session(:Run, +Makers, +Help, -Status) is det.
%
%   Serve standard input and output until the input ends; Status is the exit
%   status. call(Run, Arguments, S) does a verb, as a command line would. Makers
%   is makers(Patterns, Sheet, Shaded), of the current world:
%   call(Patterns, Words, Ds, Options) makes its patterns, Ds, as `unfold` with
%   the options Words would, and Options are those of pattern_drawing/3;
%   call(Sheet, Words, File, Drawing, Pens) its sheet, as `draw`, and what pens
%   draw of it (pen_plan.pl); call(Shaded, Words, Octets) a picture in PNG, as
%   `render`. Help is help(What, Names, Explain): call(What, Word)
%   prints what Word is, call(Names, Kind, Word, Doc) is true of each Word that
%   a user may call, and call(Explain, Arguments, S) explains, as the verb
%   would, an item of the current world.

session(Run, _:Makers, _:Help, Status) :-
    stops_forgotten,
    retractall(newest(_, _)),
    limits_forgotten,
    few_collections,
    stdio_apart(In, Out),
    message_queue_create(Queue, [max_size(256)]),
    thread_self(Worker),
    thread_create(reading(In, Out, Worker, Queue, 1), _, [detached(true)]),
    served(session(Run, Makers, Help, Out), Queue, Status).

session_run(session(Run, _, _, _), Run).
session_makers(session(_, Makers, _, _), Makers).
session_help(session(_, _, Help, _), Help).
session_out(session(_, _, _, Out), Out).

%   served(Session, Queue, Status): until the input ends, or nobody reads the
%   replies.

served(Session, Queue, Status) :-
    session_out(Session, Out),
    repeat,
    thread_get_message(Queue, Message),
    (   Message == end
    ->  Status = 0
    ;   answered(Session, Message, Reply, Octets),
        (   sent(Out, Reply, Octets)
        ->  get_dict(last, Reply, true),
            Status = 0
        ;   Status = 141
        )
    ),
    !.

%   sent(Out, Reply, Octets): fails when nobody reads replies any more.

sent(Out, Reply, Octets) :-
    catch(frame_write(Out, Reply, Octets), error(io_error(write, _), _), fail).


                /*******************************
                *           READING            *
                *******************************/

%   reading(In, Out, Worker, Queue, Sequence): the thread that reads.

reading(In, Out, Worker, Queue, Sequence) :-
    catch(frame_read(In, request, Head, Body), Error, true),
    (   nonvar(Error)
    ->  thread_send_message(Queue, request(Sequence, Error, "")),
        next_read(In, Out, Worker, Queue, Sequence)
    ;   Head == end_of_file
    ->  thread_send_message(Queue, end),
        orphan_watched(Out, Worker)
    ;   (   get_dict(do, Head, "stop")
        ->  stop_asked(Worker, Sequence, Head)
        ;   get_dict(do, Head, "view"),
            catch(view_port(Head, Port), error(_, _), fail)
        ->  retractall(newest(Port, _)),
            assertz(newest(Port, Sequence))
        ;   true
        ),
        thread_send_message(Queue, request(Sequence, Head, Body)),
        next_read(In, Out, Worker, Queue, Sequence)
    ).

next_read(In, Out, Worker, Queue, Sequence) :-
    Next is Sequence+1,
    reading(In, Out, Worker, Queue, Next).

%   orphan_watched(Out, Worker): what was asked is still done, unless nobody
%   reads the replies.

orphan_watched(Out, Worker) :-
    (   catch(reader_gone(Out), error(_, _), true)
    ->  stop_all(Worker, inf)
    ;   sleep(0.2),
        orphan_watched(Out, Worker)
    ).


                /*******************************
                *          ANSWERING           *
                *******************************/

%   answered(Session, Message, Reply, Octets): an error of a request is its
%   reply, and so is that it failed, a fault of ours.

answered(Session, Request, Reply, Octets) :-
    Request = request(_, Head, _),
    request_id(Head, Id),
    catch(( worked(Session, Request, Reply0, Octets)
          ->  true
          ;   request_error(no_end)
          ),
          Error,
          true),
    (   var(Error)
    ->  true
    ;   message_object(error, Error, Object0),
        of_document(Head, Object0, Object),
        Reply0 = _{error:Object},
        Octets = ""
    ),
    document_revision(Revision),
    Reply = Reply0.put(_{id:Id, rev:Revision}).

worked(Session, request(Sequence, Head, Body), Reply, Octets) :-
    request_id(Head, Id),
    stoppable(Sequence, Id,
              ( cpu_limited,
                with_progress_wanted(Session, Sequence, Head,
                    done(Session, Sequence, Head, Body, Reply, Octets)) )).

:- meta_predicate with_progress_wanted(+, +, +, 0).

with_progress_wanted(Session, Sequence, Head, Goal) :-
    (   is_dict(Head),
        get_dict(progress, Head, true)
    ->  session_out(Session, Out),
        request_id(Head, Id),
        with_progress_told(0.2, sg_session:progress_sent(Out, Sequence, Id),
                           Goal)
    ;   once(Goal)
    ).

:- public progress_sent/6.

%   progress_sent(Out, Sequence, Id, Stage, Part, Seconds): a frame, while the
%   request is under way.

progress_sent(Out, Sequence, Id, Stage, Part, Seconds) :-
    (   under_way(Sequence)
    ->  (   Part = Done/Total
        ->  true
        ;   Done = null,
            Total = null
        ),
        document_revision(Revision),
        sent_or_not(Out, _{ id:Id, rev:Revision,
                            progress:_{ stage:Stage, done:Done, total:Total,
                                        seconds:Seconds } })
    ;   true
    ).

%   Who reads no more is noticed at the reply.

sent_or_not(Out, Head) :-
    (   sent(Out, Head, "")
    ->  true
    ;   true
    ).

request_id(Head, Id) :-
    (   is_dict(Head),
        get_dict(id, Head, Id0),
        ( integer(Id0) ; string(Id0) )
    ->  Id = Id0
    ;   Id = null
    ).

%   of_document(Head, Object0, Object): the text of a document is read as
%   standard input; people know it as its file.

of_document(Head, Object0, Object) :-
    (   Object0.file == "<stdin>",
        (   is_dict(Head),
            get_dict(file, Head, File)
        ->  true
        ;   document_file(File)
        )
    ->  Object = Object0.put(file, File)
    ;   Object = Object0
    ).

%   done(Session, Sequence, Head, Body, Reply, Octets)

done(_, _, Head, _, _, _) :-
    \+ is_dict(Head),
    !,
    throw(Head).
done(Session, Sequence, Head, Body, Reply, Octets) :-
    right_id(Head),
    (   get_dict(do, Head, Do),
        string(Do)
    ->  atom_string(Request, Do),
        (   request(Request, Needs, Handler)
        ->  right_revision(Head),
            there(Needs),
            captured(call(Handler, request(Sequence, Head, Body), Session,
                          Reply0, Octets),
                     _),
            Reply = Reply0.put(do, Do)
        ;   findall(Known, request(Known, _, _), All),
            near_words(Request, All, Near),
            request_error(unknown_do(Request, Near, All))
        )
    ;   request_error(bad_key(do, request))
    ).

right_id(Head) :-
    (   get_dict(id, Head, Id),
        Id \== null,
        \+ integer(Id),
        \+ string(Id)
    ->  request_error(bad_key(id, id))
    ;   true
    ).

%   right_revision(Head): what was asked of an older revision is not done.

right_revision(Head) :-
    (   get_dict(at, Head, At)
    ->  document_revision(Revision),
        (   At == Revision
        ->  true
        ;   request_error(other_revision(At, Revision))
        )
    ;   true
    ).

there(nothing).
there(document) :-
    (   document_revision(0)
    ->  request_error(no_document)
    ;   true
    ).

%   request(Do, Needs, Handler): what a session does, in the order of
%   docs/protocol.md; Needs is `nothing` or `document`. call(Handler,
%   request(Sequence, Head, Body), Session, Reply, Octets) does it.

request(hello,    nothing,  greeted).
request(run,      nothing,  run).
request(stop,     nothing,  stopped).
request(help,     nothing,  helped).
request(complete, nothing,  words_completed).
request(open,     nothing,  opened).
request(view,     document, seen).
request(ask,      document, answers).
request(next,     nothing,  more_answers).
request(explain,  document, explained).
request(export,   document, exported).
request(problems, nothing,  problems_told).
request(problem,  nothing,  problem_told).
request(select,   document, pointed_at).
request(sheet,    document, laid(sheet_laid)).
request(shaded,   document, laid(shaded)).
request(unfold,   document, laid(unfolded)).
request(fold,     document, laid(folded)).
request(edit,     document, changed(edit)).
request(cut,      document, changed(cut)).
request(question, document, changed(question)).
request(text,     document, text).
request(tree,     document, treed).
request(undo,     document, changed(undo)).
request(redo,     document, changed(redo)).
request(rules,    document, rules).
request(reload,   document, reloaded).
request(save,     document, saved).

greeted(request(_, Head, _), _, Reply, "") :-
    memory_limited(Head),
    cpu_wanted(Head),
    findall(Request, request(Request, _, _), Offered),
    current_prolog_flag(pid, Pid),
    version(Version),
    Reply = _{ protocol:1, program:"sanggwan", version:Version, pid:Pid,
               offered:Offered }.

run(request(_, Head, Body), Session, Reply, Octets) :-
    session_run(Session, Run),
    verb_job(Run, Head, Body, Reply, Octets).

stopped(request(Sequence, Head, _), _, _{}, "") :-
    stop_answered(Sequence, Head).

%   helped: the list of requests, or what one word is.

helped(request(_, Head, _), Session, Reply, Octets) :-
    (   get_dict(of, Head, Word)
    ->  (   string(Word)
        ->  true
        ;   request_error(bad_key(of, word))
        ),
        session_help(Session, help(What, _, _)),
        captured(objects_heard(call(What, Word), Objects), Octets),
        Reply = _{messages:Objects}
    ;   findall(_{do:Do, needs:Needs, words:Words},
                ( request(Do, Needs, _), request_words(Do, Words) ),
                Requests),
        Reply = _{requests:Requests},
        Octets = ""
    ).

request_words(Do, Words) :-
    message_object(informational, sanggwan(request(Do)), Object),
    Words = Object.words.

words_completed(request(_, Head, _), Session, Reply, "") :-
    (   document_revision(0)
    ->  World = none
    ;   document_world(World)
    ),
    session_help(Session, help(_, Names, _)),
    completed(World, sg_session:callable_word(Names), Head, Reply).

:- public callable_word/4.

callable_word(_, "request", Name, Doc) :-
    request(Do, _, _),
    atom_string(Do, Name),
    request_words(Do, Doc).
callable_word(Names, Kind, Name, Doc) :-
    call(Names, Kind, Name, Doc).

opened(request(_, Head, _), _, Reply, "") :-
    document_opened(Head, Reply, Commit),
    committed(Commit),
    selection_forgotten,
    moved_on.

%   moved_on: the document is another one now.

moved_on :-
    asks_forgotten,
    worlds_collected.

seen(request(Sequence, Head, _), _, Reply, Octets) :-
    view_port(Head, Port),
    (   newest(Port, Newest),
        Newest > Sequence
    ->  Reply = _{replaced:true},
        Octets = ""
    ;   (   get_dict(before, Head, true)
        ->  document_world_before(World)
        ;   document_world(World)
        ),
        viewed(World, Head, Reply, Octets)
    ).

answers(request(_, Head, _), _, Reply, Octets) :-
    request_id(Head, Id),
    document_world(World),
    question_state(Head, State),
    captured(objects_heard(in_question(State, World, Head,
                                       asked(Head, Id, Reply0)),
                           Objects),
             Octets),
    Reply = Reply0.put(messages, Objects).

:- meta_predicate in_question(+, +, +, 0).

in_question(cut, World, _, Goal) :-
    in_state(World, cut, Goal).
in_question(picture, World, Head, Goal) :-
    with_picture(World, Head, Goal).

more_answers(request(_, Head, _), _, Reply, "") :-
    next_answers(Head, Reply).

%   explained: in the world of the document, if no option is about loading it.

explained(request(_, Head, _), Session, Reply, Octets) :-
    (   get_dict(item, Head, Item),
        string(Item)
    ->  true
    ;   request_error(bad_key(item, item))
    ),
    request_options(Head, Options),
    (   maplist(of_looking, Options)
    ->  session_help(Session, help(_, _, Explain)),
        document_world(World),
        verb_job(sg_session:explained_there(World, Explain),
                 Head.put(argv, [Item|Options]), "", Reply, Octets)
    ;   session_run(Session, Run),
        of_the_document(Run, [explain], [Item|Options], Head, Reply,
                        Octets)
    ).

:- public explained_there/4.

%   A line of the picture is explained where pictures are made: its segments
%   have cut each other already.

explained_there(World, Explain, Arguments, Status) :-
    Arguments = [Item|_],
    (   string_concat("hidden(", _, Item)
    ->  State = shown
    ;   State = loaded
    ),
    in_state(World, State, call(Explain, Arguments, Status)).

%   of_looking(Word): a word of an option that says how the model is seen, or
%   how the answer is written.

of_looking(Word) :-
    string(Word),
    (   string_concat("-", _, Word),
        \+ number_string(_, Word)
    ->  split_string(Word, "=", "", [Name|_]),
        memberchk(Name, [ "--view","--eye","--target","--projection","--lines",
                          "--crease","--up","--json","--no-json" ])
    ;   true
    ).

exported(request(_, Head, _), Session, Reply, Octets) :-
    (   get_dict(argv, Head, [Verb|Options]),
        string(Verb)
    ->  true
    ;   request_error(bad_key(argv, export))
    ),
    session_run(Session, Run),
    of_the_document(Run, [Verb], Options, Head, Reply, Octets).

problems_told(request(_, Head, _), _, Reply, "") :-
    problems_listed(Head, Reply).

problem_told(request(_, Head, _), _, Reply, Octets) :-
    problem_posed(Head, Reply, Octets),
    worlds_collected.

pointed_at(request(_, Head, _), _, Reply, "") :-
    document_world(World),
    selected(World, Head, Reply).

%   laid(Goal): by laid_out.pl.

laid(Goal, request(_, Head, _), Session, Reply, Octets) :-
    session_makers(Session, Makers),
    call(Goal, Head, Makers, Reply, Octets).

changed(Request, request(_, Head, Body), _, Reply, "") :-
    document_changed(Request, Head, Body, Reply, Commit),
    committed(Commit),
    moved_on.

text(Request, Session, Reply, Octets) :-
    Request = request(_, _, Body),
    (   Body == ""
    ->  document_text(Text),
        text_octets(Text, Octets),
        Reply = _{}
    ;   changed(text, Request, Session, Reply, Octets)
    ).

reloaded(request(_, Head, _), _, Reply, Octets) :-
    document_reloaded(Head, Reply, Octets, Commit),
    committed(Commit),
    moved_on.

treed(_, _, Reply, "") :-
    document_text(Text),
    text_tree(Text, Tree),
    document_is_saved(Saved),
    Reply = Tree.put(saved, Saved).

saved(request(_, Head, _), _, Reply, "") :-
    committed(document_saved(Head, Reply)).

%   rules: the list of decisions; or rules are tried, kept, or discarded.

rules(Request, Session, Reply, Octets) :-
    Request = request(_, Head, Body),
    (   get_dict(keep, Head, Keep)
    ->  (   Keep == true
        ->  changed(rules, Request, Session, Reply, Octets)
        ;   Keep == false
        ->  trial_ended(Commit),
            committed(Commit),
            moved_on,
            rules_told(Reply, Octets)
        ;   request_error(bad_key(keep, boolean))
        )
    ;   ( Body \== "" ; get_dict(try, Head, true) )
    ->  octets_text(Body, Rules),
        objects_heard(( document_tried(Head, Rules, Before-After, Commit),
                        changed_lines(Before, After, Head, Reply0) ),
                      Objects),
        committed(Commit),
        moved_on,
        Reply = Reply0.put(_{tried:true, messages:Objects}),
        Octets = ""
    ;   rules_told(Reply, Octets)
    ).

rules_told(_{decisions:Decisions, tried:Tried}, Octets) :-
    document_rules(Rules, Tried),
    document_world(World),
    in_world(World,
             findall(_{decision:Name, words:_{en:Doc, ko:Ko}, by:By},
                     ( decision(PI, Doc, _, By0), decision_ko(PI, Ko),
                       format(string(Name), "~w", [PI]),
                       atom_string(By0, By) ),
                     Decisions)),
    text_octets(Rules, Octets).
