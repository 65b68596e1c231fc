/* Which sessions are ended: those that nobody uses, and those that do not stop.
   What the front stops. A process that sleeps stands for each. */
:- module(test_visitor, []).
:- use_module(library(plunit)).
:- use_module(library(process)).
:- use_module(rules('studio/protocol'), [frame_read/4]).
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
%   stopped(Asked, Answered, After, Of): at After the front stops request Of of
%   a session of which Asked, Number-Since, wait, and which answered another
%   one at Answered; none, if nothing.

stopped(Asked, Answered, After, Of) :-
    tmp_file_stream(File, Out, [encoding(octet)]),
    findall(Clause,
            ( (   member(Number-Since, Asked),
                  Fact = pending_(Number, someone, none, 1, "view", Since, none)
              ;   member(Fact, [ session_(someone, 7, 0, Out),
                                 answered_(someone, Answered),
                                 used_(someone, After) ])
              ),
              assertz(sg_visitor:Fact, Clause) ),
            Clauses),
    visitors_watched(After),
    forall(member(Clause, Clauses), erase(Clause)),
    close(Out),
    setup_call_cleanup(open(File, read, In, [type(binary)]),
                       frame_read(In, request, Head, _),
                       close(In)),
    delete_file(File),
    (   is_dict(Head)
    ->  get_dict(of, Head, Of)
    ;   Of = none
    ).

test(idle, Status == killed(9)) :-
    watched(1000, none, 2801, Status).
test(busy, Status == running) :-
    watched(1000, 1000, 1074, Status).
test(stuck, Status == killed(9)) :-
    watched(1000, 1000, 1076, Status).

% What waits behind a slow request is not slow itself.
test(slow, Of == 1) :-
    stopped([2-1000,1-1000], 900, 1061, Of).
test(next, Of == none) :-
    stopped([3-1000,2-1000], 1061, 1074, Of).
test(next_slow, Of == 2) :-
    stopped([3-1000,2-1000], 1001, 1062, Of).

:- end_tests(visitor).
