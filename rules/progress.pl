:- module(sg_progress,
          [ with_progress/1,            % :Goal
            progress/2                  % +Done, +Total
          ]).
:- use_module(stage, [current_stage/1]).
:- use_module(library(time), [alarm/4, remove_alarm/1]).
/** <module> Progress: nothing runs over two seconds silently.

While a goal runs under with_progress/1, an alarm looks at the open stage
(stage.pl) after two seconds and prints where the work is: on a terminal one
line that is written over twice a second, elsewhere plain lines at 2, 4, 8, ...
seconds. Rules that know how far they are call progress/2; then the time left is
shown too. Long kernels poll, so the alarm fires in them as well.
*/

:- meta_predicate with_progress(0).

%!  with_progress(:Goal) is semidet.
%
%   Call Goal once and show its progress on standard error.

with_progress(Goal) :-
    get_time(Start),
    nb_setval(sg_progress, none),
    setup_call_cleanup(
        armed(2.0, Start),
        once(Goal),
        ( disarmed,
          line_cleared
        )).

%!  progress(+Done, +Total) is det.
%
%   Of the open stage, Done of Total parts are done.

progress(Done, Total) :-
    nb_setval(sg_progress, Done/Total).

armed(Seconds, Start) :-
    alarm(Seconds, sg_progress:look(Start), Alarm, [remove(false)]),
    nb_setval(sg_progress_alarm, Alarm).

disarmed :-
    nb_getval(sg_progress_alarm, Alarm),
    catch(remove_alarm(Alarm), error(_, _), true).

%   look(Start): runs in the alarm. The next look is half a second later on a
%   terminal, and as far away as the start elsewhere.

:- public look/1.

look(Start) :-
    get_time(Now),
    Seconds is Now-Start,
    (   current_stage(Stage)
    ->  true
    ;   Stage = run
    ),
    nb_getval(sg_progress, Part),
    notice(Part, Stage, Seconds, Notice),
    disarmed,
    (   stream_property(user_error, tty(true))
    ->  message_line(Notice, Line),
        format(user_error, '\r~w\e[K', [Line]),
        flush_output(user_error),
        nb_setval(sg_progress_line, true),
        armed(0.5, Start)
    ;   print_message(informational, Notice),
        armed(Seconds, Start)
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
