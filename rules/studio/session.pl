:- module(sg_session,
          [ session/2                   % :Run, -Status
          ]).
:- use_module('../kernel', [reader_gone/1, stdio_apart/2]).
:- use_module('../message/message_object', [message_object/3]).
:- use_module('../spelling', [near_words/3]).
:- use_module(job, [verb_job/5]).
:- use_module(protocol, [frame_read/4, frame_write/3]).
/** <module> A session: frames in, frames out (docs/protocol.md).

`sanggwan serve --stdio` is one process for one who asks: a studio, an editor, a
batch, a test. It reads requests from its standard input and answers each, in
their order, on its standard output; what verbs print never gets between the
frames. There is no network in it.

A second thread reads, so that `stop` is heard while the work goes on.
*/

:- meta_predicate session(2, -).

% The sequence number of the request that is being done, and of the last `stop`
% that came: what came before that is not done any more.
:- dynamic under_way/1, stopped_before/1.

%!  session(:Run, -Status) is det.
%
%   Serve standard input and output until the input ends; Status is the exit
%   status. call(Run, Arguments, S) does a verb, as a command line would.

session(Run, Status) :-
    retractall(under_way(_)),
    retractall(stopped_before(_)),
    stdio_apart(In, Out),
    message_queue_create(Queue, [max_size(256)]),
    thread_self(Worker),
    thread_create(reading(In, Out, Worker, Queue, 1), _, [detached(true)]),
    served(session(Run, Out, Queue), Status).

served(Session, Status) :-
    Session = session(_, Out, Queue),
    thread_get_message(Queue, Message),
    (   Message == end
    ->  Status = 0
    ;   Message = request(Sequence, Head, Body),
        answered(Session, Sequence, Head, Body, Reply, Octets),
        (   sent(Out, Reply, Octets)
        ->  (   get_dict(last, Reply, true)
            ->  Status = 0
            ;   served(Session, Status)
            )
        ;   Status = 141
        )
    ).

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

%   answered(Session, Sequence, Head, Body, Reply, Octets): an error of a
%   request is its reply.

answered(Session, Sequence, Head, Body, Reply, Octets) :-
    request_id(Head, Id),
    setup_call_cleanup(
        asserta(under_way(Sequence)),
        catch(( (   is_stopped(Sequence)
                ->  throw(sanggwan_interrupt(int))
                ;   done(Head, Body, Session, Reply0, Octets)
                ),
                retractall(under_way(_))
              ),
              Error, true),
        retractall(under_way(_))),
    (   var(Error)
    ->  true
    ;   message_object(error, Error, Object),
        Reply0 = _{error:Object},
        Octets = ""
    ),
    Reply = Reply0.put(_{id:Id, rev:0}).

request_id(Head, Id) :-
    (   is_dict(Head),
        get_dict(id, Head, Id0),
        ( integer(Id0) ; string(Id0) )
    ->  Id = Id0
    ;   Id = null
    ).

%   done(Head, Body, Session, Reply, Octets)

done(Head, _, _, _, _) :-
    \+ is_dict(Head),
    !,
    throw(Head).
done(Head, Body, Session, Reply, Octets) :-
    (   get_dict(do, Head, Do),
        string(Do)
    ->  atom_string(Request, Do),
        (   offered(Request)
        ->  reply(Request, Head, Body, Session, Reply0, Octets),
            Reply = Reply0.put(do, Do)
        ;   findall(Known, offered(Known), All),
            near_words(Request, All, Near),
            request_error(unknown_do(Request, Near, All))
        )
    ;   request_error(bad_key(do, request))
    ).

request_error(What) :-
    throw(error(request_error(What), _)).

%   offered(Request): what a session does, in the order of docs/protocol.md.

offered(Request) :-
    clause(reply(Request, _, _, _, _, _), _).

%   reply(Request, Head, Body, Session, Reply, Octets)

reply(hello, _, _, _, Reply, "") :-
    findall(Request, offered(Request), Offered),
    current_prolog_flag(pid, Pid),
    Reply = _{protocol:1, program:"sanggwan", pid:Pid, offered:Offered}.
reply(run, Head, Body, session(Run, _, _), Reply, Octets) :-
    verb_job(Run, Head, Body, Reply, Octets).
reply(stop, _, _, _, _{}, "").
