:- module(sg_visitor,
          [ visitor_joined/4,           % +Visitor, :Send, -Socket, -Revision
            visitor_left/1,             % +Socket
            visitor_expected/3,         % +Front, +Visitor, +Model
            visitor_asks/4,             % +Front, +Socket, +Head, +Body
            visitor_answered/3,         % +Socket, +Id, +Reply
            visitor_refused/3,          % +Socket, +Id, +Error
            visitors_watched/1,         % +Now
            visitors_ended/0,
            picture_shown/0,
            download_taken/3            % +Ticket, -Path, -Name
          ]).
:- use_module('../message/message_object', [message_object/3]).
:- use_module('../plain', [plain_json/2]).
:- use_module(visitor_answer, [answers_recorded/2, class_request/4]).
:- use_module(guard,
              [journal_folder/2, new_secret/1, request_allowed/3]).
:- use_module(visitor_path, [paths_untold/5]).
:- use_module(visitor_upload, [upload_ticket/3, visitor_folder/2]).
:- use_module(protocol, [frame_read/4, frame_write/3, text_octets/2]).
:- use_module(request, [request_error/1]).
:- use_module(library(filesex), [delete_directory_and_contents/1]).
:- use_module(library(http/json), [json_write_dict/3]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(process),
              [process_create/3, process_kill/2, process_wait/2]).
/** <module> Visitors of the studio, and the session process of each.

A visitor has one session, and as many sockets as pages are open: two windows
show one document. What a page asks goes to the session, its answer comes back
to that page, and the other pages hear that there is a new revision. A session
that ends, for whatever reason, is told to its pages; the next request has a new
one, and the journal of the document has all that was answered.
*/

:- meta_predicate visitor_joined(+, 1, -, -).

% session_(Visitor, Generation, Pid, In); socket_(Socket, Visitor, Send);
% pending_(Number, Visitor, Socket, Id, Do, Since, File): Number is the id that
% the session knows. revision_(Visitor, Revision); used_(Visitor, Time);
% answered_(Visitor, Time): of the last reply of the session;
% opened_(Visitor, File, Time): what is open, and when it was written, as far as
% pages know. download_(Ticket, Path, Name, Until); folder_(Folder): of these.
:- dynamic session_/4, socket_/3, pending_/7, revision_/2, used_/2,
           answered_/2, opened_/3, download_/4, folder_/1.

%   What a visitor may have: waiting requests, seconds for one until it is
%   stopped and until its session is killed, seconds of the processor for one,
%   seconds without any, megabytes of a session, seconds until a download is
%   fetched. And how many sessions there may be.

most(waiting,  64).
most(stopped,  60).
most(killed,   75).
most(cpu,      90).
most(sessions, 40).
most(idle,     1800).
most(memory,   1000).
most(download, 60).


                /*******************************
                *            PAGES             *
                *******************************/

%!  visitor_joined(+Visitor, :Send, -Socket, -Revision) is det.
%
%   A page of Visitor has opened Socket; call(Send, Octets) sends it a message,
%   and Revision is that of the document, 0 if there is none.

visitor_joined(Visitor, Send, Socket, Revision) :-
    flag(sg_visitor_socket, N, N+1),
    Socket is N+1,
    assertz(socket_(Socket, Visitor, Send)),
    used_now(Visitor),
    (   revision_(Visitor, Revision0)
    ->  Revision = Revision0
    ;   Revision = 0
    ).

used_now(Visitor) :-
    get_time(Now),
    retractall(used_(Visitor, _)),
    assertz(used_(Visitor, Now)).

%!  visitor_left(+Socket) is det.
%
%   Socket is closed. The session stays for a while: the page may come back.

visitor_left(Socket) :-
    retractall(socket_(Socket, _, _)),
    retractall(heard_of_picture_(Socket)),
    forall(retract(pending_(Number, Visitor, Socket, Id, Do, Since, File)),
           assertz(pending_(Number, Visitor, none, Id, Do, Since, File))).

%!  visitor_answered(+Socket, +Id, +Reply:dict) is det.
%
%   The front itself answers request Id of Socket.

visitor_answered(Socket, Id, Reply) :-
    sent(Socket, Reply.put(id, Id), "").

%!  visitor_refused(+Socket, +Id, +Error) is det.
%
%   Request Id of Socket is not done, because of Error.

visitor_refused(Socket, Id, Error) :-
    message_object(error, Error, Object),
    sent(Socket, _{id:Id, error:Object}, "").

told(Visitor, But, Head) :-
    forall(( socket_(Socket, Visitor, _), Socket \== But ),
           sent(Socket, Head, "")).

%   sent(Socket, Head, Body): four octets, the length of the head; the head; the
%   body. A page that is gone gets nothing.

sent(Socket, Head, Body) :-
    (   socket_(Socket, _, Send)
    ->  with_output_to(string(Text),
                       plain_json(current_output,
                                  json_write_dict(current_output, Head,
                                                  [width(0)]))),
        text_octets(Text, Json),
        string_length(Json, H),
        A is H>>24,
        B is H>>16 /\ 255,
        C is H>>8 /\ 255,
        D is H /\ 255,
        format(string(Message), "~s~s~s", [[A,B,C,D], Json, Body]),
        catch(call(Send, Message), error(_, _), true)
    ;   true
    ).


                /*******************************
                *           REQUESTS           *
                *******************************/

%!  visitor_asks(+Front, +Socket, +Head:dict, +Body) is det.
%
%   The page of Socket sends the request Head. It is answered some time.

visitor_asks(Front, Socket, Head, Body) :-
    socket_(Socket, Visitor, _),
    page_id(Head, Id),
    catch(front_or_session(Front, Visitor, Socket, Id, Head, Body), Error,
          visitor_refused(Socket, Id, Error)).

%!  visitor_expected(+Front, +Visitor, +Model) is det.
%
%   A page of Visitor is about to ask for the file Model, and a picture of it:
%   they are made before it does. What is wrong with it, the page hears.

visitor_expected(Front, Visitor, Model) :-
    file_base_name(Model, Base),
    atom_string(Base, File),
    catch(( asked(Front, Visitor, none, null, _{do:"open", file:File}, ""),
            asked(Front, Visitor, none, null,
                  _{ do:"view", format:"strokes", view:"isometric",
                     size:[160,120] }, "") ),
          error(_, _), true).

%   front_or_session(Front, Visitor, Socket, Id, Head, Body): what is about the
%   class as a whole, the front answers.

front_or_session(Front, Visitor, Socket, Id, Head, Body) :-
    (   get_dict(do, Head, "upload")
    ->  upload_ticket(Visitor, Head, Ticket),
        visitor_answered(Socket, Id, _{do:"upload", ticket:Ticket})
    ;   get_dict(do, Head, "show")
    ->  nothing_shown(Visitor),
        visitor_answered(Socket, Id, _{do:"show"})
    ;   get_dict(do, Head, "shown")
    ->  retractall(heard_of_picture_(Socket)),
        ( shown_(Picture, Octets) -> true ; Picture = _{}, Octets = "" ),
        sent(Socket, Picture.put(_{id:Id, do:"shown"}), Octets)
    ;   get_dict(do, Head, Do),
        class_request(Visitor, Do, Head, Reply)
    ->  visitor_answered(Socket, Id, Reply),
        (   Do == "join"
        ->  told(owner, none, _{event:"class"})
        ;   true
        )
    ;   asked(Front, Visitor, Socket, Id, Head, Body)
    ).

page_id(Head, Id) :-
    (   get_dict(id, Head, Id0),
        integer(Id0)
    ->  Id = Id0
    ;   Id = null
    ).

asked(Front, Visitor, Socket, Id, Head, Body) :-
    request_allowed(Front, Head, Allowed0),
    most(waiting, Most),
    findall(x, pending_(_, Visitor, _, _, _, _, _), Waiting),
    length(Waiting, Length),
    (   Length < Most
    ->  true
    ;   request_error(too_many(Most))
    ),
    used_now(Visitor),
    flag(sg_visitor_request, N, N+1),
    Number is N+1,
    request_known(Socket, Allowed0, Allowed1),
    download_begun(Head, Number, Allowed1, Allowed, File0),
    file_opened(Front, Allowed, File0, File),
    (   Visitor == owner,
        get_dict(shown, Head, true)
    ->  assertz(shows_(Number))
    ;   true
    ),
    visitor_mutex(Visitor, Mutex),
    get_time(Now),
    with_mutex(Mutex,
        ( session_ready(Front, Visitor, In),
          assertz(pending_(Number, Visitor, Socket, Id, Allowed.do, Now,
                           File)),
          catch(frame_write(In, Allowed.put(id, Number), Body),
                error(io_error(_, _), _), true) )).

visitor_mutex(Visitor, Mutex) :-
    atom_concat('sg_visitor ', Visitor, Mutex).

%   request_known(Socket, Head0, Head): the id of a question, or of a request
%   that is stopped, as the session knows it. 0, if that one is done.

:- dynamic question_/3.

request_known(Socket, Head0, Head) :-
    (   get_dict(of, Head0, Id),
        memberchk(Head0.do, ["next","stop"])
    ->  (   (   Head0.do == "next"
            ->  question_(Socket, Id, Number)
            ;   pending_(Number, _, Socket, Id, _, _, _)
            )
        ->  true
        ;   Head0.do == "stop"
        ->  Number = 0
        ;   request_error(no_answers_left(Id))
        ),
        Head = Head0.put(of, Number)
    ;   Head = Head0
    ).

%   session_ready(Front, Visitor, In): there is a session; In leads to it.

session_ready(_, Visitor, In) :-
    session_(Visitor, _, _, In0),
    !,
    In = In0.
session_ready(_, _, _) :-
    most(sessions, Most),
    predicate_property(session_(_, _, _, _), number_of_clauses(N)),
    N >= Most,
    !,
    request_error(too_many_sessions(Most)).
session_ready(front(_,_,Folder,_), Visitor, In) :-
    process_create('/proc/self/exe', [serve, '--stdio'],
                   [ stdin(pipe(In, [type(binary)])),
                     stdout(pipe(Out, [type(binary)])),
                     stderr(null), cwd(Folder), detached(true), process(Pid)
                   ]),
    set_stream(In, buffer(full)),
    flag(sg_visitor_session, N, N+1),
    assertz(session_(Visitor, N, Pid, In)),
    untold_folders(Visitor, Folder, Folders),
    thread_create(sg_visitor:reading(Visitor, N, Folders, Out), _,
                  [detached(true)]),
    most(memory, Megabytes),
    most(cpu, Seconds),
    frame_write(In, _{id:0, do:"hello", memory_mb:Megabytes, cpu_s:Seconds},
                "").

%   untold_folders(Visitor, Folder, Folders): the innermost first.

untold_folders(Visitor, Folder, [Downloads,Uploads,Class,State,Folder]) :-
    download_folder(Downloads),
    visitor_folder(Visitor, Uploads),
    journal_folder(owner, State),
    journal_folder(pupil, Class).

:- public reading/4.

%   reading(Visitor, Generation, Folders, Out): the thread that reads what a
%   session answers.

reading(Visitor, Generation, Folders, Out) :-
    catch(frame_read(Out, reply, Head, Body), error(_, _), Head = end_of_file),
    (   Head == end_of_file
    ->  catch(close(Out, [force(true)]), error(_, _), true),
        session_gone(Visitor, Generation)
    ;   paths_untold(Folders, Head, Body, Told, ToldBody),
        catch(routed(Visitor, Told, ToldBody), error(_, _), true),
        reading(Visitor, Generation, Folders, Out)
    ).

%   routed(Visitor, Head, Body): to the page that asked.

routed(Visitor, Head, Body) :-
    get_dict(id, Head, Number),
    (   get_dict(progress, Head, _)
    ->  pending_(Number, Visitor, Socket, Id, _, _, _),
        sent(Socket, Head.put(id, Id), Body)
    ;   pending_(Number, Visitor, Socket, Id, Do, _, File),
        file_heard(Do, Visitor, File, Head),
        retractall(pending_(Number, Visitor, _, _, _, _, _)),
        get_time(Now),
        retractall(answered_(Visitor, _)),
        assertz(answered_(Visitor, Now)),
        (   Do == "ask"
        ->  retractall(question_(Socket, Id, _)),
            assertz(question_(Socket, Id, Number))
        ;   true
        ),
        download_ready(File, Head, Head1),
        book_kept(Do, Visitor, Head1, Head2),
        (   retract(shows_(Number))
        ->  shown_to_all(Head2, Body)
        ;   true
        ),
        revision_heard(Do, Visitor, Socket, Head),
        sent(Socket, Head2.put(id, Id), Body),
        saving_heard(Do, Visitor, Socket, Head)
    ),
    !.
routed(_, _, _).

%   file_heard(Do, Visitor, Opened, Head): which file is open; it is as the
%   session read it, or wrote it, at least until now.

file_heard(Do, Visitor, Opened, Head) :-
    (   memberchk(Do, ["open","save","reload"]),
        \+ get_dict(error, Head, _),
        ( Opened = opened(File) -> true ; opened_(Visitor, File, _) )
    ->  file_time(File, Time),
        retractall(opened_(Visitor, _, _)),
        assertz(opened_(Visitor, File, Time))
    ;   true
    ).

file_time(File, Time) :-
    catch(time_file(File, Time), error(_, _), Time = 0.0).

%   files_watched: pages hear that their file is another one, unless they are
%   about to hear that it was saved. In this order: what is saved meanwhile is
%   still pending, or its time is noted already.

files_watched :-
    forall(( opened_(Visitor, File, Time0),
             file_time(File, Time),
             Time =\= 0,
             Time =\= Time0,
             \+ pending_(_, Visitor, _, _, "save", _, _),
             retract(opened_(Visitor, File, Time0)) ),
           ( assertz(opened_(Visitor, File, Time)),
             told(Visitor, none, _{event:"file"}) )).

%   book_kept(Do, Visitor, Head0, Head): what a pupil answered stands in the
%   book of the class before he hears whether it is right.

book_kept(Do, Visitor, Head0, Head) :-
    (   Do \== "problem"
    ->  Head = Head0
    ;   catch(answers_recorded(Visitor, Head0), Error, true)
    ->  (   var(Error)
        ->  told(owner, none, _{event:"class"}),
            Head = Head0
        ;   message_object(error, Error, Object),
            Head = _{rev:Head0.rev, error:Object}
        )
    ;   Head = Head0
    ).

%   revision_heard(Do, Visitor, Socket, Head): the other pages hear of a new
%   revision, and of another file; before the page that asked: one that comes
%   after that is greeted with this revision. At no moment there is none.

revision_heard(Do, Visitor, Socket, Head) :-
    Revision = Head.rev,
    (   revision_(Visitor, Revision)
    ->  true
    ;   assertz(revision_(Visitor, Revision)),
        forall(( revision_(Visitor, Before), Before =\= Revision ),
               retractall(revision_(Visitor, Before))),
        (   Do == "open",
            get_dict(file, Head, File)
        ->  Event = _{event:"revision", rev:Revision, file:File}
        ;   Event = _{event:"revision", rev:Revision}
        ),
        told(Visitor, Socket, Event)
    ).

%   saving_heard(Do, Visitor, Socket, Head): what is saved has no new revision.

saving_heard(Do, Visitor, Socket, Head) :-
    (   Do == "save",
        \+ get_dict(error, Head, _)
    ->  told(Visitor, Socket, _{event:"saved"})
    ;   true
    ).

%   session_gone(Visitor, Generation): what was asked of it is not answered any
%   more.

session_gone(Visitor, Generation) :-
    (   retract(session_(Visitor, Generation, Pid, In))
    ->  catch(close(In, [force(true)]), error(_, _), true),
        catch(process_wait(Pid, _), error(_, _), true),
        retractall(revision_(Visitor, _)),
        retractall(answered_(Visitor, _)),
        forall(retract(pending_(_, Visitor, Socket, Id, _, _, _)),
               visitor_refused(Socket, Id,
                               error(request_error(session_ended), _))),
        told(Visitor, none, _{event:"restarted"})
    ;   true
    ).



                /*******************************
                *         SHOWN TO ALL         *
                *******************************/

% shown_(Head, Body): the picture of the owner that all others may see now.
% shows_(Number): the reply to that request will be one.
% heard_of_picture_(Socket): its page was told that there is another one, and
% has not asked for it yet: who never reads holds up nobody.
:- dynamic shown_/2, shows_/1, heard_of_picture_/1.

%!  picture_shown is semidet.
%
%   The owner shows a picture to all.

picture_shown :-
    shown_(_, _),
    !.

%   shown_to_all(Head, Body): a reply to the owner, if it is a picture.

shown_to_all(Head, Body) :-
    (   get_dict(kind, Head, Kind),
        memberchk(Kind, ["strokes","png"])
    ->  retractall(shown_(_, _)),
        del_dict(rev, Head, _, Picture),
        assertz(shown_(Picture, Body)),
        others_hear(true)
    ;   true
    ).

nothing_shown(Visitor) :-
    (   Visitor == owner
    ->  retractall(shown_(_, _)),
        retractall(heard_of_picture_(_)),
        others_hear(false)
    ;   request_error(owner_alone(show))
    ).

others_hear(Shown) :-
    forall(( socket_(Socket, Visitor, _),
             Visitor \== owner,
             \+ heard_of_picture_(Socket) ),
           ( assertz(heard_of_picture_(Socket)),
             sent(Socket, _{event:"shown", shown:Shown}, "") )).


                /*******************************
                *          DOWNLOADS           *
                *******************************/

%   download_begun(Head, Number, Allowed0, Allowed, File): an export goes into a
%   folder of the front, and is fetched there under the name that the page gave
%   it. File is file(Path, Name), or none.

download_begun(Head, Number, Allowed0, Allowed, File) :-
    (   Allowed0.do == "export"
    ->  (   get_dict(name, Head, Name0),
            string(Name0),
            download_name(Name0, Name)
        ->  true
        ;   request_error(bad_key(name, download))
        ),
        download_folder(Folder),
        format(atom(Path), "~w/~d-~w", [Folder, Number, Name]),
        append(Allowed0.argv, ["-o",Path], Argv0),
        findall(Word, ( member(Word0, Argv0),
                        format(string(Word), "~w", [Word0]) ),
                Argv),
        Allowed = Allowed0.put(argv, Argv),
        File = file(Path,Name)
    ;   Allowed = Allowed0,
        File = none
    ).

%   file_opened(Front, Allowed, File0, File): File is opened(Path) of a request
%   that names the file of the document.

file_opened(front(_,_,Folder,_), Allowed, File0, File) :-
    (   memberchk(Allowed.do, ["open","save"]),
        get_dict(file, Allowed, Name)
    ->  absolute_file_name(Name, Path, [relative_to(Folder)]),
        File = opened(Path)
    ;   File = File0
    ).

%   download_name(Name0, Name): letters of any language, digits, `-`, `_`, dots
%   inside.

download_name(Name0, Name) :-
    string_length(Name0, Length),
    Length =< 100,
    file_name_extension(_, Ending, Name0),
    memberchk(Ending, [svg,pdf,png,dxf,json,pl,stl,off,obj,ply,eps,ps,hpgl,
                       fold,csv]),
    string_codes(Name0, [First|Codes]),
    forall(member(Code, [First|Codes]),
           ( code_type(Code, csym) ; memberchk(Code, `-.`) )),
    First \== 0'.,
    First \== 0'-,
    atom_string(Name, Name0).

download_folder(Folder) :-
    with_mutex(sg_visitor_folder,
        (   folder_(Folder0)
        ->  Folder = Folder0
        ;   new_secret(Secret),
            tmp_file(sanggwan, Tmp),
            atom_concat(Tmp, Secret, Folder),
            make_directory(Folder),
            assertz(folder_(Folder))
        )).

download_ready(none, Head, Head).
download_ready(opened(_), Head, Head).
download_ready(file(Path,Name), Head0, Head) :-
    (   get_dict(status, Head0, 0),
        exists_file(Path)
    ->  new_secret(Ticket),
        get_time(Now),
        most(download, Seconds),
        Until is Now+Seconds,
        assertz(download_(Ticket, Path, Name, Until)),
        Head = Head0.put(_{ticket:Ticket, name:Name})
    ;   Head = Head0
    ).

%!  download_taken(+Ticket:string, -Path, -Name) is semidet.
%
%   Ticket stood for the file Path, which is to be called Name; it does no more.

download_taken(Ticket, Path, Name) :-
    retract(download_(Ticket, Path, Name, _)),
    !.


                /*******************************
                *           WATCHING           *
                *******************************/

%!  visitors_watched(+Now) is det.
%
%   Requests that take too long are stopped, sessions that do not stop killed,
%   and those that nobody uses ended.

visitors_watched(Now) :-
    most(stopped, Stopped),
    most(killed, Killed),
    most(idle, Idle),
    findall(age(Visitor, Number, Age),
            ( session_(Visitor, _, _, _),
              request_under_way(Visitor, Number, Since),
              Age is Now-Since ),
            Ages),
    forall(( member(age(Visitor, _, Age), Ages), Age > Killed ),
           session_killed(Visitor)),
    forall(( member(age(Visitor, Number, Age), Ages), Age > Stopped ),
           session_stopped(Visitor, Number)),
    forall(( session_(Visitor, _, _, _),
             \+ socket_(_, Visitor, _),
             used_(Visitor, Time),
             Now-Time > Idle ),
           session_killed(Visitor)),
    files_watched,
    forall(( download_(Ticket, Path, _, Until), Until < Now ),
           ( retractall(download_(Ticket, _, _, _)),
             catch(delete_file(Path), error(_, _), true) )).

%   request_under_way(Visitor, Number, Since): the first of those that wait. It
%   began when it was asked, or when the one before was answered.

request_under_way(Visitor, Number, Since) :-
    aggregate_all(min(Number0, Asked),
                  pending_(Number0, Visitor, _, _, _, Asked, _),
                  min(Number, Asked)),
    (   answered_(Visitor, Answered)
    ->  Since is max(Asked, Answered)
    ;   Since = Asked
    ).

%   session_stopped(Visitor, Number): what waits behind request Number is done.

session_stopped(Visitor, Number) :-
    visitor_mutex(Visitor, Mutex),
    with_mutex(Mutex,
        (   session_(Visitor, _, _, In)
        ->  catch(frame_write(In, _{id:0, do:"stop", of:Number}, ""),
                  error(_, _), true)
        ;   true
        )).

session_killed(Visitor) :-
    forall(session_(Visitor, _, Pid, _),
           catch(process_kill(Pid, kill), error(_, _), true)).

%!  visitors_ended is det.
%
%   All sessions are ended; what they were told is in their journals.

visitors_ended :-
    forall(session_(_, _, Pid, In),
           ( catch(close(In, [force(true)]), error(_, _), true),
             catch(process_kill(Pid, kill), error(_, _), true) )),
    forall(retract(folder_(Folder)),
           catch(delete_directory_and_contents(Folder), error(_, _), true)).
