:- module(sg_run_state,
          [ run_state_reset/0,
            interrupts_noted/1,         % :Goal
            is_interrupted/0,
            stop_begun/0,
            stops/0,
            counted/1,                  % +Outcome
            count_of/2,                 % +Outcome, -N
            run_status/1                % -Status
          ]).
:- use_module(batch_report, [outcome/1]).
/** <module> How a batch stands: what its jobs came to, and whether it goes on.

There is one batch in a process.
*/

:- dynamic stopping/0.

%!  run_state_reset is det.
%
%   No job has ended, and none failed.

run_state_reset :-
    retractall(stopping),
    forall(outcome(Outcome),
           ( counter(Outcome, Counter),
             flag(Counter, _, 0) )).

%!  interrupts_noted(:Goal) is semidet.
%
%   Call Goal once. While it runs, the first Ctrl-C lets jobs end; the second
%   one ends them.

:- meta_predicate interrupts_noted(0).

interrupts_noted(Goal) :-
    flag(sg_batch_interrupts, _, 0),
    setup_call_cleanup(
        on_signal(int, Old, sg_run_state:interrupted),
        once(Goal),
        on_signal(int, _, Old)).

:- public interrupted/1.

interrupted(Signal) :-
    flag(sg_batch_interrupts, N, N+1),
    (   N =:= 0
    ->  true
    ;   throw(sanggwan_interrupt(Signal))
    ).

%!  is_interrupted is semidet.
%
%   There was a Ctrl-C.

is_interrupted :-
    flag(sg_batch_interrupts, N, N),
    N > 0.

%!  stop_begun is det.
%
%   No other job begins.

stop_begun :-
    (   stopping
    ->  true
    ;   assertz(stopping)
    ).

%!  stops is semidet.
%
%   No other job begins: one failed, or there was a Ctrl-C.

stops :-
    (   stopping
    ;   is_interrupted
    ),
    !.

%!  counted(+Outcome) is det.
%!  count_of(+Outcome, -N) is det.
%
%   One more job came to Outcome; N jobs did so far.

counted(Outcome) :-
    counter(Outcome, Counter),
    flag(Counter, N, N+1).

count_of(Outcome, N) :-
    counter(Outcome, Counter),
    flag(Counter, N, N).

counter(Outcome, Counter) :-
    atom_concat(sg_batch_, Outcome, Counter).

%!  run_status(-Status) is det.
%
%   Status is 0, 5 if a job failed, 130 if there was an interrupt.

run_status(Status) :-
    (   is_interrupted
    ->  Status = 130
    ;   outcome(Outcome),
        \+ memberchk(Outcome, [done,cached]),
        count_of(Outcome, N),
        N > 0
    ->  Status = 5
    ;   Status = 0
    ).
