:- module(sg_front,
          [ front/3                     % +Model, +Options, -Status
          ]).
:- use_module('../environment', [environment/2]).
:- use_module('../json_value', [json_value/2]).
:- use_module('../model/model', [model_format/2, model_there/1]).
:- use_module('../problem/problem_file', [problems_read/3]).
:- use_module('../version', [version/1]).
:- use_module(visitor_answer,
              [class_begun/2, class_file/1, class_opens/1, class_pupil/2]).
:- use_module(front_socket,
              [called/2, front_socket/4, front_socket_gone/1, http_loaded/0]).
:- use_module(guard,
              [ behind_begun/1, embed_begun/1, host_allowed/2, is_loopback/1,
                new_secret/1, origin_allowed/2, pupil_secret/1, same_secret/2,
                security_header/2 ]).
:- use_module(page_file,
              [page_file/4, page_file_stays/1, page_files_expected/0]).
:- use_module(visitor,
              [ download_taken/3, picture_shown/0,
                visitor_answered/3, visitor_asks/4, visitor_expected/3,
                visitor_joined/4, visitor_left/1, visitor_refused/3,
                visitors_ended/0, visitors_watched/1 ]).
:- use_module(visitor_upload, [upload_taken/2, uploads/2]).
:- use_module(protocol, [text_octets/2]).
:- use_module(library(lists), [member/2]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(process), [process_create/3]).
/** <module> The front of the studio: the page, and the way to the sessions.

The front computes nothing, so it always answers. It serves the files of the
page, and opens a socket for it, on which the page asks what it wants of a
session (visitor.pl). guard.pl says what is let in.

library(http) is loaded when the front starts: no other verb pays for it.
*/

% front_(Front, Token, Model): Front is front(Bound, Port, Folder, Owner).
% class_code(Code): pupils may join with it. open_socket(WebSocket): of a page.
:- dynamic front_/3, class_code/1, open_socket/1.

%   longest(N): octets of a message of a page. most_sockets(N). hello_within(S):
%   the first message of a socket.

longest(1_048_576).
most_sockets(40).
hello_within(10).

%!  front(+Model, +Options, -Status) is det.
%
%   Serve the studio until it is interrupted, which is raised. Model is the
%   file that pages show first, or `none`. Options are those of the verb serve:
%   port(N), host(Address), socket(Path), class(Boolean), problems(File),
%   behind(URL), embed(Origin), open(Boolean).
%
%   @error usage_error(host_needs_class(Host)), usage_error(socket_alone(Path)),
%   and those of front_socket/4

front(Model, Options, 130) :-
    option(problems(Problems0), Options, none),
    problems_file(Problems0, Problems),
    (   Model == none,
        Problems \== none
    ->  file_directory_name(Problems, Folder)
    ;   model_folder(Model, Folder)
    ),
    (   Problems == none
    ->  option(class(Class), Options, false)
    ;   Class = true
    ),
    option(behind(Behind), Options, none),
    behind_begun(Behind),
    option(embed(Embed), Options, none),
    embed_begun(Embed),
    place_checked(Options, Class, Behind),
    front_socket(Options, Socket, Host, Port),
    (   Behind \== none
    ->  Owner = false,
        ( Port == none -> Host = unix(Place) ; Place = Host:Port ),
        print_message(warning, sanggwan(studio(behind(Behind, Place))))
    ;   is_loopback(Host)
    ->  Owner = true
    ;   Owner = false,
        print_message(warning, sanggwan(studio(open_to_others(Host, Port))))
    ),
    new_secret(Token),
    Front = front(Host,Port,Folder,Owner),
    retractall(front_(_, _, _)),
    assertz(front_(Front, Token, Model)),
    class_begun(Problems, Model),       % before anybody may ask
    % While library(http) is loaded, the session opens the model, and the files
    % of the page are made: who opens the page first waits for neither.
    ( Model == none -> true ; visitor_expected(Front, owner, Model) ),
    page_files_expected,
    http_loaded,
    place_name(Host, Name),
    % A connection that waits for its next request has a worker, and a page that
    % was just opened has six of them.
    called(thread_httpd,
           http_server(sg_front:answered,
                       [ port(Name:Port), tcp_socket(Socket), workers(24),
                         timeout(20), keep_alive_timeout(0.2), silent(true) ])),
    page_address(Behind, Host, Port, Page),
    format(string(Address), "~w#~w", [Page, Token]),
    format("~w~n", [Address]),
    class_opened(Class, Page),
    flush_output,
    opened_in_browser(Options, Address),
    setup_call_cleanup(true, watching,
                       ( pages_closed, visitors_ended,
                         front_socket_gone(Host) )).

%   place_checked(Options, Class, Behind): whom the front lets in there is what
%   was asked for.

place_checked(Options, Class, Behind) :-
    (   option(socket(Path), Options)
    ->  (   Behind \== none,
            \+ option(port(_), Options),
            \+ option(host(_), Options)
        ->  true
        ;   throw(error(usage_error(socket_alone(Path)), _))
        )
    ;   option(host(Host), Options, '127.0.0.1'),
        ( is_loopback(Host) ; Class == true ; Behind \== none )
    ->  true
    ;   option(host(Host), Options),
        throw(error(usage_error(host_needs_class(Host)), _))
    ).

%   place_name(Bound, Name): what people call it.

place_name(Bound, Name) :-
    (   Bound = unix(Name)
    ->  true
    ;   Name = Bound
    ).

%   page_address(Behind, Host, Port, Page): where people find the page.

page_address(none, Host, Port, Page) :-
    !,
    shown_at(Host, Name),
    format(atom(Page), "http://~w:~d/", [Name, Port]).
page_address(URL, _, _, Page) :-
    (   sub_atom(URL, _, 1, 0, /)
    ->  Page = URL
    ;   atom_concat(URL, /, Page)
    ).

%   class_opened(Class, Page): the address for pupils is printed too.

class_opened(true, Page) :-
    new_secret(Secret),
    sub_string(Secret, 0, 10, _, Code),
    retractall(class_code(_)),
    assertz(class_code(Code)),
    format("~w#~w~n", [Page, Code]).
class_opened(false, _).

%   problems_file(Problems0, Problems): those of a class; what is wrong with the
%   file is said before anything is opened.

problems_file(none, none) :-
    !.
problems_file(File, Path) :-
    problems_read(File, _, _),
    absolute_file_name(File, Path).

model_folder(none, Folder) :-
    !,
    working_directory(Folder0, Folder0),
    absolute_file_name(Folder0, Folder).
model_folder(Model, Folder) :-
    model_there(Model),
    absolute_file_name(Model, Path),
    file_directory_name(Path, Folder).

shown_at('0.0.0.0', Name) :-
    !,
    Name = localhost.
shown_at(Host, Host).

opened_in_browser(Options, Address) :-
    (   option(open(true), Options, true),
        ( environment('DISPLAY', _) ; environment('WAYLAND_DISPLAY', _) )
    ->  catch(process_create(path('xdg-open'), [Address],
                             [ stdin(null), stdout(null), stderr(null),
                               detached(true), process(_) ]),
              error(_, _), true)
    ;   true
    ).

%   watching: what has to be looked at each second.

watching :-
    repeat,
    sleep(1),
    get_time(Now),
    visitors_watched(Now),
    fail.


                /*******************************
                *             HTTP             *
                *******************************/

:- public answered/1.

%   answered(Request): a request of HTTP, in a thread of library(http).

answered(Request) :-
    front_(Front, _, _),
    (   host_allowed(Request, Front)
    ->  memberchk(method(Method), Request),
        memberchk(path(Path), Request),
        replied(Method, Path, Request)
    ;   reply(400, 'text/plain', "not the address of this program\n")
    ).

replied(get, '/ws', Request) :-
    !,
    front_(Front, _, _),
    (   origin_allowed(Request, Front)
    ->  socket_wanted(Request)
    ;   reply(403, 'text/plain', "not from a page of this program\n")
    ).
replied(get, Path, _) :-
    atom_concat('/x/', Ticket0, Path),
    !,
    atom_string(Ticket0, Ticket),
    (   download_taken(Ticket, File, Name)
    ->  download(File, Name)
    ;   reply(404, 'text/plain', "not there any more\n")
    ).
replied(post, Path, Request) :-
    atom_concat('/up/', Ticket0, Path),
    !,
    front_(Front, _, _),
    atom_string(Ticket0, Ticket),
    (   \+ origin_allowed(Request, Front)
    ->  reply(403, 'text/plain', "not from a page of this program\n")
    ;   upload_taken(Ticket, File)
    ->  uploaded(Request, File)
    ;   reply(404, 'text/plain', "not there any more\n")
    ).
replied(Method, Path, Request) :-
    memberchk(Method, [get,head]),
    ( takes_gzip(Request) -> Coding = gzip ; Coding = plain ),
    page_file(Path, Coding, Type, Octets),
    !,
    reply_page(Path, Coding, Type, Octets).
replied(Method, _, _) :-
    (   memberchk(Method, [get,head])
    ->  reply(404, 'text/plain', "not found\n")
    ;   reply(405, 'text/plain', "not done\n")
    ).

reply(Status, Type, Text) :-
    reply_head(Status, Type, '; charset=UTF-8', []),
    format("~s", [Text]).

%   reply_page(Path, Coding, Type, Octets): a browser keeps what never changes.

reply_page(Path, Coding, Type, Octets) :-
    findall(Header,
            ( Header = 'Vary'-'Accept-Encoding'
            ; Coding == gzip,
              Header = 'Content-Encoding'-gzip
            ; page_file_stays(Path),
              Header = 'Cache-Control'-'max-age=31536000, immutable'
            ),
            Headers),
    reply_head(200, Type, '; charset=UTF-8', Headers),
    set_stream(current_output, encoding(octet)),
    format("~s", [Octets]).

%   takes_gzip(Request): gzip is among what it takes, with any weight but 0.

takes_gzip(Request) :-
    memberchk(accept_encoding(Given), Request),
    split_string(Given, ",", " \t", Codings),
    member(Coding, Codings),
    split_string(Coding, ";", " \t", ["gzip"|Weights]),
    !,
    \+ ( member(Weight, Weights),
         split_string(Weight, "=", " \t", ["q",Q]),
         number_string(Value, Q),
         Value =:= 0 ).

reply_head(Status, Type, Charset, More) :-
    format("Status: ~d~n", [Status]),
    forall(( member(Name-Value, More)
           ; security_header(Name, Value),
             \+ memberchk(Name-_, More) ),
           format("~w: ~w~n", [Name, Value])),
    format("Content-type: ~w~w~n~n", [Type, Charset]).

%   largest(N): octets of a file that a page sends.

largest(20_000_000).

%   uploaded(Request, File): it stands there whole, or not at all.

uploaded(Request, File) :-
    largest(Most),
    (   memberchk(content_length(Length), Request),
        \+ memberchk(transfer_encoding(_), Request)
    ->  (   Length =< Most
        ->  memberchk(input(In), Request),
            copied(In, Length, File),
            reply(200, 'text/plain', "")
        ;   reply(413, 'text/plain', "larger than 20 MB\n")
        )
    ;   reply(411, 'text/plain', "how long it is, is not said\n")
    ).

copied(In, Length, File) :-
    atom_concat(File, '.part', Part),
    setup_call_cleanup(
        open(Part, write, Out, [type(binary)]),
        ( set_stream(In, encoding(octet)),
          copy_stream_data(In, Out, Length)
        ),
        close(Out)),
    size_file(Part, Length),
    rename_file(Part, File).

%   download(File, Name): whatever it is, a page of ours is not made of it.

download(File, Name) :-
    uri_encoded(path, Name, Encoded),
    format(atom(Disposition), "attachment; filename*=UTF-8''~w", [Encoded]),
    reply_head(200, 'application/octet-stream', '',
               ['Content-Disposition'-Disposition]),
    setup_call_cleanup(
        open(File, read, In, [type(binary)]),
        copy_stream_data(In, current_output),
        close(In)),
    catch(delete_file(File), error(_, _), true).

uri_encoded(Part, Text, Encoded) :-
    called(uri, uri_encoded(Part, Text, Encoded)).


                /*******************************
                *            SOCKETS           *
                *******************************/

socket_wanted(Request) :-
    most_sockets(Most),
    predicate_property(open_socket(_), number_of_clauses(Open)),
    (   \+ memberchk(upgrade(_), Request)
    ->  reply(400, 'text/plain', "no websocket\n")
    ;   Open >= Most
    ->  reply(503, 'text/plain', "too many pages are open\n")
    ;   called(thread_httpd,
               http_spawn(sg_front:socket_opened(Request), []))
    ).

:- public socket_opened/1, socket_used/1.

socket_opened(Request) :-
    called(websocket,
           http_upgrade_to_websocket(sg_front:socket_used,
                                     [guarded(false), timeout(90)], Request)).

%   socket_used(WebSocket): until it is closed. A thread that ends by an error
%   says nothing, so there is none.

socket_used(WebSocket) :-
    setup_call_cleanup(
        assertz(open_socket(WebSocket)),
        catch(greeted_socket(WebSocket), _, true),
        ( retractall(open_socket(WebSocket)),
          catch(close(WebSocket, [force(true)]), error(_, _), true)
        )).

%   pages_closed: pages are told that the program ends; their threads end then.

pages_closed :-
    forall(open_socket(WebSocket), ended(WebSocket, 1001, "the program ends")),
    (   between(1, 5, _),
        sleep(0.01),
        \+ open_socket(_)
    ->  true
    ;   true
    ).

greeted_socket(WebSocket) :-
    front_(Front, Token, Model),
    stream_pair(WebSocket, In, _),
    hello_within(Seconds),
    set_stream(In, timeout(Seconds)),
    message(WebSocket, Message),
    (   Message = text(Text),
        json_dict(Text, Head),
        get_dict(do, Head, "hello"),
        get_dict(token, Head, Given),
        joins(Given, Token, Head, Front, Visitor, Own)
    ->  set_stream(In, timeout(90)),
        setup_call_cleanup(
            visitor_joined(Visitor, sg_front:message_sent(WebSocket), Socket,
                           Revision),
            ( welcomed(Socket, Visitor, Own, Model, Revision, Head),
              requests(WebSocket, Own, Socket) ),
            visitor_left(Socket))
    ;   sleep(1),                       % who guesses is slow
        ended(WebSocket, 1008, "not the secret of this program")
    ).

%   joins(Given, Token, Head, Front, Visitor, Own): who knows the secret Token
%   is the owner; who knows the code of the class is a pupil, who has a session
%   of his own, and a Front that lets him write no file. He is known by a secret
%   that his page made.

joins(Given, Token, _, Front, owner, Front) :-
    same_secret(Given, Token),
    !.
joins(Given, _, Head, front(Host,Port,Folder,_), Visitor,
      front(Host,Port,Folder,pupil(Pupil))) :-
    class_code(Code),
    same_secret(Given, Code),
    get_dict(pupil, Head, Pupil),
    pupil_secret(Pupil),
    atom_concat('pupil ', Pupil, Visitor).

:- public message_sent/2.

message_sent(WebSocket, Octets) :-
    called(websocket, ws_send(WebSocket, binary(Octets))).

ended(WebSocket, Code, Why) :-
    catch(called(websocket, ws_send(WebSocket, close(Code, Why))),
          error(_, _), true).

welcomed(Socket, Visitor, front(_,_,Folder,Owner0), Model, Revision, Head) :-
    ( Owner0 == true -> Owner = true ; Owner = false ),
    ( get_dict(id, Head, Id), integer(Id) -> true ; Id = null ),
    version(Version),
    (   Model == none
    ->  File = null
    ;   file_base_name(Model, File)
    ),
    models(Visitor, Folder, Models),
    uploads(Visitor, Uploads),
    class_told(Visitor, Class),
    may_show(Visitor, Shows),
    visitor_answered(Socket, Id,
                     _{ do:"hello", version:Version, file:File, rev:Revision,
                        owner:Owner, models:Models, uploads:Uploads,
                        class:Class, shows:Shows }).

%   may_show(Visitor, Shows): the owner of a class may show pictures to all;
%   they see what he shows.

may_show(Visitor, Shows) :-
    (   Visitor == owner,
        class_code(_)
    ->  Shows = all
    ;   Visitor \== owner,
        picture_shown
    ->  Shows = seen
    ;   Shows = null
    ).

%   class_told(Visitor, Class): null without problems; else whether Visitor is
%   the teacher, and by which name a pupil is in the class.

class_told(Visitor, Class) :-
    (   \+ class_file(_)
    ->  Class = null
    ;   Visitor == owner
    ->  Class = _{teacher:true, name:null}
    ;   class_pupil(Visitor, Pupil)
    ->  Class = _{teacher:false, name:Pupil.name, done:Pupil.done}
    ;   Class = _{teacher:false, name:null}
    ).

%   models(Visitor, Folder, Models): what may be opened, by name.

models(Visitor, Folder, Models) :-
    catch(directory_files(Folder, Files), error(_, _), Files = []),
    findall(Name,
            ( member(File, Files),
              model_format(File, _),
              may_open(Visitor, Folder, File),
              atom_string(File, Name) ),
            Names),
    sort(Names, Models).

may_open(Visitor, Folder, File) :-
    (   Visitor == owner
    ->  true
    ;   atomic_list_concat([Folder,/,File], Path),
        class_opens(Path)
    ).

%   requests(WebSocket, Front, Socket): until the page closes it.

requests(WebSocket, Front, Socket) :-
    message(WebSocket, Message),
    (   Message = text(Text)
    ->  request(Text, Front, Socket),
        requests(WebSocket, Front, Socket)
    ;   Message = ended(Code, Why)
    ->  ended(WebSocket, Code, Why)
    ;   true
    ).

request(Text, Front, Socket) :-
    (   json_dict(Text, Head0)
    ->  (   get_dict(do, Head0, "alive")
        ->  true
        ;   (   get_dict(body, Head0, Body0),
                string(Body0)
            ->  text_octets(Body0, Body)
            ;   Body = ""
            ),
            visitor_asks(Front, Socket, Head0, Body)
        )
    ;   visitor_refused(Socket, null, error(frame_error(not_json), _))
    ).

json_dict(Text, Dict) :-
    json_value(Text, Dict),
    is_dict(Dict).

%   message(WebSocket, Message): text(Text), closed, or ended(Code, Why) when
%   what came is none. library(http) reads messages of any length, so the
%   length is looked at here.

message(WebSocket, Message) :-
    called(websocket, ws_read_header(WebSocket, Opcode, Reserved)),
    longest(Most),
    (   Opcode == end_of_file
    ->  Message = closed
    ;   Opcode =:= 8
    ->  Message = ended(1000, "")
    ;   Limit is Most+1,
        stream_pair(WebSocket, In, _),
        read_string(In, Limit, Text),
        string_length(Text, Length),
        (   Length > Most
        ->  Message = ended(1009, "too long")
        ;   Opcode =:= 1,
            Reserved =:= 0
        ->  Message = text(Text)
        ;   Opcode =:= 9
        ->  pong(WebSocket, Text),
            message(WebSocket, Message)
        ;   Opcode =:= 10
        ->  message(WebSocket, Message)
        ;   Message = ended(1003, "text alone")
        )
    ).

pong(WebSocket, Text) :-
    called(websocket, ws_send(WebSocket, pong(Text))).
