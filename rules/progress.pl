:- module(sg_progress,
          [ with_progress/1,            % :Goal
            with_progress_told/3,       % +Seconds, :Tell, :Goal
            progress_by/1,              % :Goal
            progress_line/1,            % +Notice
            line_cleared/0
          ]).
:- use_module(stage, [current_stage/1]).
/** <module> Progress: nothing runs over two seconds silently.

While a goal runs under with_progress/1, a second thread makes it look at the
open stage (stage.pl) after two seconds and print where the work is: on a
terminal one line that is written over twice a second, elsewhere plain lines
at 2, 4, 8, ... seconds. Rules that can say how far they are call
progress_by/1; then the time left is shown too. Long kernels poll for signals,
so they are seen too.
*/

:- meta_predicate
    with_progress(0),
    with_progress_told(+, 3, 0),
    watched(+, 3, 0),
    progress_by(2).

%!  with_progress(:Goal) is semidet.
%
%   Call Goal once and show its progress on standard error, unless that is
%   memory, as of a session, which nobody looks at meanwhile.

with_progress(Goal) :-
    (   stream_property(user_error, file_no(_))
    ->  call_cleanup(watched(growing(2.0), sg_progress:printed, Goal),
                     line_cleared)
    ;   once(Goal)
    ).

%!  with_progress_told(+Seconds, :Tell, :Goal) is semidet.
%
%   Call Goal once, and meanwhile, each Seconds, call(Tell, Stage, Part, Now)
%   in the same thread: Stage is the open one (stage.pl), Part Done/Total or
%   `none`, Now how many seconds ago Goal began.

with_progress_told(Seconds, Tell, Goal) :-
    watched(each(Seconds), Tell, Goal).

%   watched(Pause, Tell, Goal): Pause is each(Seconds), or growing(Seconds),
%   the first one, when the others are as long as all before them; or shorter,
%   on a terminal.

watched(Pause, Tell, Goal) :-
    current_prolog_flag(threads, true),
    !,
    nb_setval(sg_progress, none),
    thread_self(Self),
    setup_call_cleanup(
        thread_create(watch(Self, Pause, Tell), Watcher),
        once(Goal),
        ( thread_send_message(Watcher, done),
          thread_join(Watcher)
        )).
watched(_, _, Goal) :-
    once(Goal).

%!  progress_by(:Goal) is det.
%
%   From now on call(Goal, Done, Total) says how far the work is; it is called
%   when somebody wants to know, and may fail or raise when the work is over.

progress_by(Goal) :-
    nb_setval(sg_progress, by(Goal)).

%   watch(Worker, Pause, Tell): the thread that wakes the worker up; it ends at
%   the message `done`. (library(time) would do, but its alarms can hang the
%   program's end.)

watch(Worker, Pause, Tell) :-
    get_time(Start),
    thread_self(Self),
    arg(1, Pause, First),
    watch(Self, Worker, Start, First, Pause, Tell).

watch(Self, Worker, Start, Seconds, Pause, Tell) :-
    (   thread_get_message(Self, done, [timeout(Seconds)])
    ->  true
    ;   get_time(Now),
        Passed is Now-Start,
        catch(thread_signal(Worker, sg_progress:look(Tell, Passed)),
              error(_, _), true),
        next_pause(Pause, Passed, Seconds1),
        watch(Self, Worker, Start, Seconds1, Pause, Tell)
    ).

next_pause(each(Seconds), _, Seconds).
next_pause(growing(_), Passed, Seconds) :-
    (   stream_property(user_error, tty(true))
    ->  Seconds = 0.5
    ;   Seconds = Passed
    ).

%   look(Tell, Seconds): runs in the worker, between two of its steps.

:- public look/2, printed/3.

look(Tell, Seconds) :-
    (   current_stage(Stage)
    ->  true
    ;   Stage = run
    ),
    nb_getval(sg_progress, Part0),
    (   Part0 = by(Goal),
        catch(call(Goal, Done, Total), error(_, _), fail)
    ->  Part = Done/Total
    ;   Part = none
    ),
    call(Tell, Stage, Part, Seconds).

printed(Stage, Part, Seconds) :-
    notice(Part, Stage, Seconds, Notice),
    (   stream_property(user_error, tty(true))
    ->  progress_line(Notice)
    ;   print_message(informational, Notice)
    ).

%!  progress_line(+Notice) is det.
%
%   On a terminal Notice, a message, is a line that the next one is written
%   over; elsewhere nothing is shown.

progress_line(Notice) :-
    (   stream_property(user_error, tty(true))
    ->  message_line(Notice, Line),
        format(user_error, '\r~w\e[K', [Line]),
        flush_output(user_error),
        nb_setval(sg_progress_line, true)
    ;   true
    ).

notice(none, Stage, Seconds, sanggwan(progress(Stage, Seconds))).
notice(Done/Total, Stage, Seconds, Notice) :-
    (   Done > 0
    ->  Left is Seconds*(Total-Done)/Done,
        Rate is Done/Seconds,
        Notice = sanggwan(progress(Stage, Done, Total, Rate, Left))
    ;   notice(none, Stage, Seconds, Notice)
    ).

message_line(Notice, Line) :-
    phrase('$messages':translate_message(Notice), Lines),
    with_output_to(string(Line),
                   print_message_lines(current_output, '', Lines)).

%!  line_cleared is det.
%
%   There is no line of progress_line/1 any more.

line_cleared :-
    (   nb_current(sg_progress_line, true)
    ->  format(user_error, '\r\e[K', []),
        nb_setval(sg_progress_line, false)
    ;   true
    ).
