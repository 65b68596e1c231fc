:- module(sg_front_socket,
          [ front_socket/4,             % +Options, -Socket, -Bound, -Port
            front_socket_gone/1,        % +Bound
            http_loaded/0,
            called/2                    % +Module, +Goal
          ]).
:- use_module('../kernel', [passed_socket/1, passed_taken/1]).
:- use_module(library(filesex), [chmod/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> Where the front of the studio listens: at a port, or at a Unix
socket, which a proxy on the same machine asks. Who starts the program, such as
systemd, may have opened that socket, and passes it.

library(socket) and library(zlib) are loaded when the front starts, and
library(http) when it has begun what can be done meanwhile: no other verb pays
for them.
*/

% made_here(Path): a Unix socket that is gone with the program.
:- dynamic made_here/1.

usual_port(1989).

%!  front_socket(+Options, -Socket, -Bound, -Port) is det.
%
%   Socket listens at Bound:Port. Of option socket(Path), Bound is unix(Path)
%   and Port is `none`; otherwise they are those of the options host(Address)
%   and port(N), if these are there.
%
%   @error usage_error(port_taken(Port)), usage_error(port_refused(Port)),
%   usage_error(no_address(Host)), usage_error(socket_taken(Path)),
%   usage_error(no_socket(Path)), usage_error(socket_passed(Path))

front_socket(Options, Socket, Bound, Port) :-
    loaded([library(socket),library(zlib)]),
    (   option(socket(Path), Options)
    ->  Bound = unix(Path),
        Port = none,
        (   passed_socket(Passed)
        ->  passed_path(Path, Passed, Socket)
        ;   bound_path(Path, Socket)
        )
    ;   passed_socket(Passed)
    ->  throw(error(usage_error(socket_passed(Passed)), _))
    ;   option(host(Bound), Options, '127.0.0.1'),
        bound_port(Bound, Options, Socket, Port)
    ).

%!  called(+Module, +Goal) is semidet.
%
%   Call Goal, of a library that is loaded late.

called(Module, Goal) :-
    Module:Goal.

%!  http_loaded is det.

http_loaded :-
    loaded([ library(http/thread_httpd), library(http/websocket),
             library(http/http_dispatch) ]).

loaded(Libraries) :-
    load_files(Libraries, [if(not_loaded), imports([]), silent(true)]).

%   bound_port(Host, Options, Socket, Port): answers are sent at once; a socket
%   that waits for more to send costs 40 ms each.

bound_port(Host, Options, Socket, Port) :-
    (   option(port(Port0), Options)
    ->  bound(Host, Port0, Socket, Port)
    ;   usual_port(Usual),
        catch(bound(Host, Usual, Socket, Port),
              error(usage_error(port_taken(_)), _),
              bound(Host, _, Socket, Port))
    ).

bound(Host, Port, Socket, Port) :-
    called(socket, tcp_socket(Socket)),
    called(socket, tcp_setopt(Socket, reuseaddr)),
    called(socket, tcp_setopt(Socket, nodelay(true))),
    catch(called(socket, tcp_bind(Socket, Host:Port)), error(Why, _),
          ( called(socket, tcp_close_socket(Socket)),
            not_bound(Why, Host, Port) )),
    called(socket, tcp_listen(Socket, 64)).

not_bound(Why, Host, Port) :-
    (   Why = socket_error(eaddrinuse, _)
    ->  throw(error(usage_error(port_taken(Port)), _))
    ;   Why = socket_error(eacces, _)
    ->  throw(error(usage_error(port_refused(Port)), _))
    ;   throw(error(usage_error(no_address(Host)), _))
    ).

%   passed_path(Path, Passed, Socket): Socket is the one that was passed, which
%   listens at Path. It stays when the program ends.

passed_path(Path, Passed, Socket) :-
    (   Passed \== '',
        catch(same_file(Path, Passed), error(_, _), fail)
    ->  called(socket, unix_domain_socket(Socket)),
        called(socket, tcp_getopt(Socket, file_no(Fd))),
        passed_taken(Fd)
    ;   throw(error(usage_error(socket_passed(Passed)), _))
    ).

%   bound_path(Path, Socket): the user and his group may connect. What another
%   front left there when it was killed is taken away, and nothing else.

bound_path(Path, Socket) :-
    (   connects(Path)
    ->  throw(error(usage_error(socket_taken(Path)), _))
    ;   exists_file(Path)
    ->  throw(error(usage_error(no_socket(Path)), _))
    ;   left_behind(Path)
    ->  socket_deleted(Path)
    ;   true
    ),
    called(socket, unix_domain_socket(Socket)),
    catch(called(socket, tcp_bind(Socket, Path)), error(_, _),
          ( called(socket, tcp_close_socket(Socket)),
            throw(error(usage_error(no_socket(Path)), _)) )),
    assertz(made_here(Path)),
    chmod(Path, 0o660),
    called(socket, tcp_listen(Socket, 64)).

connects(Path) :-
    catch(setup_call_cleanup(
              called(socket, unix_domain_socket(Socket)),
              called(socket, tcp_connect(Socket, Path)),
              called(socket, tcp_close_socket(Socket))),
          error(_, _), fail).

left_behind(Path) :-
    access_file(Path, exist),
    \+ exists_directory(Path).

%!  front_socket_gone(+Bound) is det.
%
%   A Unix socket is a file, which is deleted, if it was not passed.

front_socket_gone(Bound) :-
    (   Bound = unix(Path),
        retract(made_here(Path))
    ->  socket_deleted(Path)
    ;   true
    ).

socket_deleted(Path) :-
    catch(delete_file(Path), error(_, _), true).
