:- module(sg_worker,
          [ worker_started/2,           % +Folder, -Worker
            worker_asked/2,             % +Worker, +Head
            workers_ready/3,            % +Workers, +Seconds, -Ready
            worker_answer/3,            % +Worker, -Head, -Body
            worker_ended/2,             % +Worker, -How
            worker_kilobytes/2,         % +Worker, -Kilobytes
            worker_killed/1             % +Worker
          ]).
:- use_module('../studio/protocol', [frame_read/4, frame_write/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [member/2]).
:- use_module(library(process),
              [ process_create/3, process_kill/2, process_wait/2,
                process_wait/3 ]).
:- use_module(library(readutil), [read_file_to_string/3]).
/** <module> Workers: processes that do one job after the other.

A worker is worker(Pid, In, Out): the program again, as a session that reads
frames (studio/protocol.pl). It is in a group of processes of its own, so Ctrl-C
is for the batch alone; it ends when the pipe to it is closed, however that
comes about.
*/

%!  worker_started(+Folder, -Worker) is det.
%
%   Worker is a new process whose working directory is Folder. It does not wait
%   for disks: what a loss of power leaves of a result is found out by its size.

worker_started(Folder, worker(Pid, In, Out)) :-
    process_create('/proc/self/exe', [serve, '--stdio'],
                   [ stdin(pipe(In, [type(binary)])),
                     stdout(pipe(Out, [type(binary)])),
                     stderr(null), cwd(Folder), detached(true), process(Pid),
                     environment(['SANGGWAN_SYNC'=no])
                   ]),
    set_stream(Out, timeout(20)),
    set_stream(In, buffer(full)).

%!  worker_asked(+Worker, +Head) is semidet.
%
%   Send Worker the frame with Head. Fails if it is gone.

worker_asked(worker(_, In, _), Head) :-
    catch(( frame_write(In, Head, ""),
            flush_output(In) ),
          error(io_error(_, _), _), fail).

%!  workers_ready(+Workers, +Seconds, -Ready) is det.
%
%   Ready are those of Workers that have answered or ended; none after so many
%   Seconds.

workers_ready(Workers, Seconds, Ready) :-
    maplist(worker_out, Workers, Outs),
    wait_for_input(Outs, There, Seconds),
    findall(Worker, ( member(Worker, Workers),
                      worker_out(Worker, Out),
                      memberchk(Out, There) ),
            Ready).

worker_out(worker(_, _, Out), Out).

%!  worker_answer(+Worker, -Head, -Body) is det.
%
%   The frame that Worker has sent; Head is `end_of_file` if it has ended, or
%   what it sent is no frame.

worker_answer(worker(_, _, Out), Head, Body) :-
    catch(frame_read(Out, reply, Head0, Body0), error(_, _), true),
    (   nonvar(Head0)
    ->  Head = Head0,
        Body = Body0
    ;   Head = end_of_file,
        Body = ""
    ).

%!  worker_ended(+Worker, -How) is det.
%
%   Wait for the end of Worker: How is exit(Status) or killed(Signal). What has
%   not ended after a second is killed.

worker_ended(worker(Pid, In, Out), How) :-
    closed(In),
    closed(Out),
    process_wait(Pid, How0, [timeout(1)]),
    (   How0 == timeout
    ->  killed(Pid),
        process_wait(Pid, How)
    ;   How = How0
    ).

%!  worker_kilobytes(+Worker, -Kilobytes) is semidet.
%
%   Worker has so much memory of its own, as Linux counts it.

worker_kilobytes(worker(Pid, _, _), Kilobytes) :-
    format(atom(File), '/proc/~d/status', [Pid]),
    catch(read_file_to_string(File, Text, []), error(_, _), fail),
    sub_string(Text, _, _, After, "VmData:"),
    sub_string(Text, _, After, 0, Rest),
    split_string(Rest, "\n", " \tkB", [Number|_]),
    number_string(Kilobytes, Number).

%!  worker_killed(+Worker) is det.
%
%   Worker is gone, whatever it was doing.

worker_killed(Worker) :-
    Worker = worker(Pid, In, Out),
    killed(Pid),
    closed(In),
    closed(Out),
    process_wait(Pid, _).

killed(Pid) :-
    catch(process_kill(Pid, kill), error(_, _), true).

closed(Stream) :-
    catch(close(Stream, [force(true)]), error(_, _), true).
