/* Which sessions are ended: those that nobody uses, and those that do not stop.
   A process that sleeps stands for each. */
:- module(test_visitor, []).
:- use_module(library(plunit)).
:- use_module(library(process)).
:- use_module(rules('studio/visitor'), [visitors_watched/1]).

:- begin_tests(visitor).

%   watched(Used, Since, After, Status): a session that was last used at Used,
%   and has a request since Since (none: no request); at After the front looks,
%   and then Status is how it ended, or running.

watched(Used, Since, After, Status) :-
    process_create(path(sleep), [30], [process(Pid), stdin(pipe(In))]),
    setup_call_cleanup(
        assertz(sg_visitor:session_(someone, 7, Pid, In), Session),
        ( assertz(sg_visitor:used_(someone, Used), UsedClause),
          (   Since == none
          ->  Clauses = [UsedClause]
          ;   assertz(sg_visitor:pending_(1, someone, none, 1, "view", Since,
                                          none),
                      Pending),
              Clauses = [UsedClause,Pending]
          ),
          visitors_watched(After),
          forall(member(Clause, Clauses), erase(Clause)),
          sleep(0.2),
          (   process_wait(Pid, Status0, [timeout(0)]),
              Status0 \== timeout
          ->  Status = Status0
          ;   Status = running,
              process_kill(Pid, kill),
              process_wait(Pid, _)
          )
        ),
        erase(Session)).

test(used, Status == running) :-
    watched(1000, none, 2700, Status).
test(idle, Status == killed(9)) :-
    watched(1000, none, 2801, Status).
test(busy, Status == running) :-
    watched(1000, 1000, 1074, Status).
test(stuck, Status == killed(9)) :-
    watched(1000, 1000, 1076, Status).

:- end_tests(visitor).
