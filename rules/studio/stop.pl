:- module(sg_stop,
          [ stops_forgotten/0,
            stop_all/2,                 % +Worker, +Sequence
            stop_asked/3,               % +Worker, +Sequence, +Head
            stop_answered/2,            % +Sequence, +Head
            stoppable/3,                % +Sequence, +Id, :Goal
            committed/1,                % :Goal
            under_way/1                 % ?Sequence
          ]).
:- use_module(request, [request_error/1]).
/** <module> Which requests of a session are stopped.

The thread that reads hears a `stop` while another one works. Requests are
numbered as they come: a `stop` is of those that came before it, all of them or
the one that it names.
*/

:- meta_predicate stoppable(+, +, 0), committed(0).

% under_way_(Sequence, Id): the request that is being done. stopped_before_(S):
% the last `stop` of all. stopped_one_(Id, Sequence): a `stop` of request Id,
% until it is answered.
:- dynamic under_way_/2, stopped_before_/1, stopped_one_/2.

%!  stops_forgotten is det.
%
%   Nothing is under way, and nothing was stopped.

stops_forgotten :-
    retractall(under_way_(_, _)),
    retractall(stopped_before_(_)),
    retractall(stopped_one_(_, _)).

%!  stop_asked(+Worker, +Sequence, +Head:dict) is det.
%
%   The `stop` Head has come, as request Sequence; Worker is the thread that
%   works. If Head has `of`, it is of that request alone, else of all before.

stop_asked(Worker, Sequence, Head) :-
    (   \+ get_dict(of, Head, _)
    ->  stop_all(Worker, Sequence)
    ;   stopped_id(Head, Id)
    ->  assertz(stopped_one_(Id, Sequence)),
        disturbed(Worker)
    ;   true
    ).

stopped_id(Head, Id) :-
    get_dict(of, Head, Id),
    ( integer(Id) ; string(Id) ),
    !.

%!  stop_all(+Worker, +Sequence) is det.
%
%   All that came before Sequence is stopped.

stop_all(Worker, Sequence) :-
    asserta(stopped_before_(Sequence)),
    forall(( stopped_before_(S), S \== Sequence ),
           retract(stopped_before_(S))),
    disturbed(Worker).

disturbed(Worker) :-
    catch(thread_signal(Worker, sg_stop:stop_heard), error(_, _), true).

:- public stop_heard/0.

%   stop_heard: in the thread that works, between two of its steps.

stop_heard :-
    (   under_way_(Sequence, Id)
    ->  not_stopped(Sequence, Id)
    ;   true
    ).

not_stopped(Sequence, Id) :-
    (   ( stopped_before_(Stop) ; stopped_one_(Id, Stop) ),
        Sequence < Stop
    ->  throw(sanggwan_interrupt(int))
    ;   true
    ).

%!  stop_answered(+Sequence, +Head:dict) is det.
%
%   The `stop` Head is answered: nothing is left of what came before it.
%
%   @error request_error(bad_key(of, id))

stop_answered(Sequence, Head) :-
    retractall(stopped_one_(_, Sequence)),
    (   get_dict(of, Head, _),
        \+ stopped_id(Head, _)
    ->  request_error(bad_key(of, id))
    ;   true
    ).

%!  stoppable(+Sequence, +Id, :Goal) is semidet.
%
%   Goal, once, does request Sequence, which the one who asks calls Id. Nobody
%   can stop it but between the beginning and the end of this.

stoppable(Sequence, Id, Goal) :-
    setup_call_cleanup(
        asserta(under_way_(Sequence, Id)),
        ( not_stopped(Sequence, Id),
          once(Goal),
          not_stopped_now
        ),
        not_stopped_now).

not_stopped_now :-
    retractall(under_way_(_, _)).

%!  committed(:Goal) is semidet.
%
%   Goal, once: what has begun to change the document is not stopped any more.

committed(Goal) :-
    sig_atomic(( not_stopped_now,
                 once(Goal) )).

%!  under_way(?Sequence) is semidet.
%
%   Request Sequence is being done, and may be stopped.

under_way(Sequence) :-
    under_way_(Sequence, _).
