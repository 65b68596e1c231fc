:- module(sg_session,
          [ session/3                   % :Run, :Draw, -Status
          ]).
:- use_module('../kernel', [reader_gone/1, stdio_apart/2]).
:- use_module('../message/message_object', [message_object/3, objects_heard/2]).
:- use_module('../penetration/penetration', [penetrate/2]).
:- use_module('../picture/sew', [borders_sewn/1]).
:- use_module('../spelling', [near_words/3]).
:- use_module('../store', [facts_snapshot/1, in_world/2]).
:- use_module(ask, [asked/3, asks_forgotten/0, next_answers/2]).
:- use_module(document,
              [ document_changed/5, document_file/1, document_input/2,
                document_opened/3,
                document_revision/1, document_saved/2, document_text/2,
                document_world/1
              ]).
:- use_module(job, [captured/2, verb_job/5]).
:- use_module(port, [view_port/2, viewed/4]).
:- use_module(protocol, [frame_read/4, frame_write/3, text_octets/2]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3]).
/** <module> A session: frames in, frames out (docs/protocol.md).

`sanggwan serve --stdio` is one process for one who asks: a studio, an editor, a
batch, a test. It reads requests from its standard input and answers each, in
their order, on its standard output; what verbs print never gets between the
frames. There is no network in it.

A second thread reads, so that `stop` is heard while the work goes on.

All that does not change the document happens inside of one open snapshot of its
world, in which it is cut once; a change ends the snapshot, and the next one is
of the new revision.
*/

:- meta_predicate session(2, 2, -).

% The sequence number of the request that is being done, and of the last `stop`
% that came: what came before that is not done any more. newest(Port, Sequence):
% of the last `view` that came for Port.
:- dynamic under_way/1, stopped_before/1, newest/2.

%!  session(:Run, :Draw, -Status) is det.
%
%   Serve standard input and output until the input ends; Status is the exit
%   status. call(Run, Arguments, S) does a verb, as a command line would;
%   call(Draw, File, Options) draws the current world.

session(Run, Draw, Status) :-
    retractall(under_way(_)),
    retractall(stopped_before(_)),
    retractall(newest(_, _)),
    stdio_apart(In, Out),
    message_queue_create(Queue, [max_size(256)]),
    thread_self(Worker),
    thread_create(reading(In, Out, Worker, Queue, 1), _, [detached(true)]),
    served(session(Run, Draw, Out, Queue), Status).

session_run(session(Run, _, _, _), Run).
session_draw(session(_, Draw, _, _), Draw).
session_out(session(_, _, Out, _), Out).

%   served(Session, Status): a snapshot for each revision.

served(Session, Status) :-
    document_world(World),
    in_world(World, facts_snapshot(asked_in_snapshot(Session, Left))),
    (   Left = status(Status0)
    ->  Status = Status0
    ;   Left = change(Request),
        answered(Session, Request, Reply, Octets),
        session_out(Session, Out),
        (   sent(Out, Reply, Octets)
        ->  served(Session, Status)
        ;   Status = 141
        )
    ).

%   asked_in_snapshot(Session, Left): answers until Left: status(Status), or
%   change(Request) of the document.

asked_in_snapshot(Session, Left) :-
    Session = session(_, _, Out, Queue),
    nb_setval(sg_session_derived, false),
    repeat,
    thread_get_message(Queue, Message),
    (   Message == end
    ->  Left = status(0)
    ;   Message = request(_, Head, Body),
        changes(Head, Body)
    ->  Left = change(Message)
    ;   answered(Session, Message, Reply, Octets),
        (   sent(Out, Reply, Octets)
        ->  get_dict(last, Reply, true),
            Left = status(0)
        ;   Left = status(141)
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
        ->  stop(Worker, Sequence)
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
    ->  stop(Worker, inf)
    ;   sleep(0.2),
        orphan_watched(Out, Worker)
    ).

stop(Worker, Sequence) :-
    asserta(stopped_before(Sequence)),
    catch(thread_signal(Worker, sg_session:stop_heard), error(_, _), true).

:- public stop_heard/0.

%   stop_heard: in the thread that works, between two of its steps.

stop_heard :-
    (   under_way(Sequence),
        is_stopped(Sequence)
    ->  throw(sanggwan_interrupt(int))
    ;   true
    ).

is_stopped(Sequence) :-
    stopped_before(Stop),
    Sequence < Stop,
    !.


                /*******************************
                *          ANSWERING           *
                *******************************/

%   answered(Session, Message, Reply, Octets): an error of a request is its
%   reply.

answered(Session, Request, Reply, Octets) :-
    Request = request(_, Head, _),
    request_id(Head, Id),
    catch(worked(Session, Request, Reply0, Octets), Error, true),
    (   var(Error)
    ->  true
    ;   message_object(error, Error, Object0),
        of_document(Head, Object0, Object),
        Reply0 = _{error:Object},
        Octets = ""
    ),
    document_revision(Revision),
    Reply = Reply0.put(_{id:Id, rev:Revision}).

%   worked(Session, Request, Reply, Octets): nobody can stop it but between the
%   beginning and the end of this.

worked(Session, request(Sequence, Head, Body), Reply, Octets) :-
    setup_call_cleanup(
        asserta(under_way(Sequence)),
        ( (   is_stopped(Sequence)
          ->  throw(sanggwan_interrupt(int))
          ;   done(Session, Sequence, Head, Body, Reply, Octets)
          ),
          not_stopped_now
        ),
        not_stopped_now).

not_stopped_now :-
    retractall(under_way(_)).

%   committed(Goal): what has begun to change the document is not stopped any
%   more.

:- meta_predicate committed(0).

committed(Goal) :-
    sig_atomic(( not_stopped_now,
                 once(Goal) )).

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
    (   get_dict(do, Head, Do),
        string(Do)
    ->  atom_string(Request, Do),
        (   offered(Request)
        ->  right_revision(Head),
            reply(Request, request(Sequence, Head, Body), Session, Reply0,
                  Octets),
            Reply = Reply0.put(do, Do)
        ;   findall(Known, offered(Known), All),
            near_words(Request, All, Near),
            request_error(unknown_do(Request, Near, All))
        )
    ;   request_error(bad_key(do, request))
    ).

request_error(What) :-
    throw(error(request_error(What), _)).

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

%   offered(Request): what a session does, in the order of docs/protocol.md.

offered(Request) :-
    clause(reply(Request, _, _, _, _), _).

%   changes(Head, Body): the document, so no snapshot of it may be open.

changes(Head, Body) :-
    is_dict(Head),
    get_dict(do, Head, Do),
    (   memberchk(Do, ["open","edit","undo","redo"])
    ->  true
    ;   Do == "text",
        Body \== ""
    ).

%   reply(Request, request(Sequence, Head, Body), Session, Reply, Octets)

reply(hello, _, _, Reply, "") :-
    findall(Request, offered(Request), Offered),
    current_prolog_flag(pid, Pid),
    Reply = _{protocol:1, program:"sanggwan", pid:Pid, offered:Offered}.
reply(run, request(_, Head, Body), Session, Reply, Octets) :-
    session_run(Session, Run),
    verb_job(Run, Head, Body, Reply, Octets).
reply(stop, _, _, _{}, "").
reply(open, request(_, Head, _), _, Reply, "") :-
    captured(document_opened(Head, Reply, Commit), _),
    committed(Commit),
    asks_forgotten.
reply(edit, Request, _, Reply, "") :-
    changed(edit, Request, Reply).
reply(undo, Request, _, Reply, "") :-
    changed(undo, Request, Reply).
reply(redo, Request, _, Reply, "") :-
    changed(redo, Request, Reply).
reply(text, Request, _, Reply, Octets) :-
    Request = request(_, _, Body),
    (   Body == ""
    ->  document_text(Text, Reply),
        text_octets(Text, Octets)
    ;   changed(text, Request, Reply),
        Octets = ""
    ).
reply(save, request(_, Head, _), _, Reply, "") :-
    committed(document_saved(Head, Reply)).
reply(view, request(Sequence, Head, _), Session, Reply, Octets) :-
    a_document,
    view_port(Head, Port),
    (   newest(Port, Newest),
        Newest > Sequence
    ->  Reply = _{replaced:true},
        Octets = ""
    ;   session_draw(Session, Draw),
        derived,
        viewed(Draw, Head, Reply, Octets)
    ).
reply(ask, request(_, Head, _), _, Reply, Octets) :-
    a_document,
    derived,
    request_id(Head, Id),
    captured(objects_heard(asked(Head, Id, Reply0), Objects), Octets),
    Reply = Reply0.put(messages, Objects).
reply(next, request(_, Head, _), _, Reply, "") :-
    next_answers(Head, Reply).
reply(explain, request(_, Head, _), Session, Reply, Octets) :-
    (   get_dict(item, Head, Item),
        string(Item)
    ->  true
    ;   request_error(bad_key(item, item))
    ),
    options(Head, Options),
    of_the_document(Session, [explain], [Item|Options], Head, Reply, Octets).
reply(export, request(_, Head, _), Session, Reply, Octets) :-
    (   get_dict(argv, Head, [Verb|Options]),
        string(Verb)
    ->  true
    ;   request_error(bad_key(argv, export))
    ),
    of_the_document(Session, [Verb], Options, Head, Reply, Octets).

changed(Request, request(_, Head, Body), Reply) :-
    captured(document_changed(Request, Head, Body, Reply, Commit), _),
    committed(Commit),
    asks_forgotten.

a_document :-
    (   document_revision(0)
    ->  request_error(no_document)
    ;   true
    ).

options(Head, Options) :-
    (   get_dict(options, Head, Options0)
    ->  (   is_list(Options0)
        ->  Options = Options0
        ;   request_error(bad_key(options, options))
        )
    ;   Options = []
    ).

%   of_the_document(Session, Before, After, Head, Reply, Octets): a verb of the
%   command line, with the document as its model.

of_the_document(Session, Before, After, Head, Reply, Octets) :-
    (   document_input(File, Text)
    ->  true
    ;   request_error(no_document)
    ),
    atom_string(File, Name),
    append(Before, [Name|After], Words0),
    maplist(word_text, Words0, Words),
    session_run(Session, Run),
    text_octets(Text, Body),
    verb_job(Run, Head.put(argv, Words), Body, Reply, Octets).

word_text(Word, Text) :-
    (   atom(Word)
    ->  atom_string(Word, Text)
    ;   Text = Word
    ).

%   derived: patches are sewn and segments cut, once a revision, in the snapshot
%   that is open.

derived :-
    (   nb_getval(sg_session_derived, true)
    ->  true
    ;   captured(( borders_sewn(_),
                   penetrate(all, [themselves(true)]) ), _),
        nb_setval(sg_session_derived, true)
    ).
