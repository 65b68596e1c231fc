:- module(sg_progress,
          [ with_progress/1,            % :Goal
            progress_by/1               % :Goal
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
    progress_by(2).

%!  with_progress(:Goal) is semidet.
%
%   Call Goal once and show its progress on standard error.

with_progress(Goal) :-
    current_prolog_flag(threads, true),
    !,
    nb_setval(sg_progress, none),
    thread_self(Self),
    setup_call_cleanup(
        thread_create(watch(Self), Watcher),
        once(Goal),
        ( thread_send_message(Watcher, done),
          thread_join(Watcher),
          line_cleared
        )).
with_progress(Goal) :-
    once(Goal).

%!  progress_by(:Goal) is det.
%
%   From now on call(Goal, Done, Total) says how far the work is; it is called
%   when somebody wants to know, and may fail or raise when the work is over.

progress_by(Goal) :-
    nb_setval(sg_progress, by(Goal)).

%   watch(Worker): the thread that wakes the worker up; it ends at the message
%   `done`. (library(time) would do, but its alarms can hang the program's
%   end.)

watch(Worker) :-
    get_time(Start),
    thread_self(Self),
    watch(Self, Worker, Start, 2.0).

watch(Self, Worker, Start, Pause) :-
    (   thread_get_message(Self, done, [timeout(Pause)])
    ->  true
    ;   get_time(Now),
        Seconds is Now-Start,
        catch(thread_signal(Worker, sg_progress:look(Seconds)), error(_, _),
              true),
        (   stream_property(user_error, tty(true))
        ->  Pause1 = 0.5
        ;   Pause1 = Seconds
        ),
        watch(Self, Worker, Start, Pause1)
    ).

%   look(Seconds): runs in the worker, between two of its steps.

:- public look/1.

look(Seconds) :-
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
    notice(Part, Stage, Seconds, Notice),
    (   stream_property(user_error, tty(true))
    ->  message_line(Notice, Line),
        format(user_error, '\r~w\e[K', [Line]),
        flush_output(user_error),
        nb_setval(sg_progress_line, true)
    ;   print_message(informational, Notice)
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

line_cleared :-
    (   nb_current(sg_progress_line, true)
    ->  format(user_error, '\r\e[K', []),
        nb_setval(sg_progress_line, false)
    ;   true
    ).
