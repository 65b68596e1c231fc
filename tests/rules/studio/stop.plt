/* Which requests are stopped: by numbers, as they came. */
:- module(test_stop, []).
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(rules(studio/stop)).

%   done(Sequence, Id, Goal, How): done, or stopped.

:- meta_predicate done(+, +, 0, -).

done(Sequence, Id, Goal, How) :-
    thread_self(Me),
    nb_setval(test_stop_me, Me),
    catch(( stoppable(Sequence, Id, Goal), How = done ),
          sanggwan_interrupt(int), How = stopped),
    assertion(\+ under_way(_)).

me(Me) :-
    nb_getval(test_stop_me, Me).

%   a stop of Head that comes as request Sequence while another one is done.

stop(Sequence, Head) :-
    me(Me),
    stop_asked(Me, Sequence, Head),
    true.

after(Stops, Sequence, Id, How) :-
    stops_forgotten,
    thread_self(Me),
    forall(member(N-Head, Stops), stop_asked(Me, N, Head)),
    done(Sequence, Id, true, How),
    stops_forgotten.

during(N-Head, Sequence, Id, How) :-
    stops_forgotten,
    done(Sequence, Id, stop(N, Head), How),
    stops_forgotten.

:- begin_tests(stop).

test(before, [ forall(member(Stops-How,
       [ []-done, [6-_{}]-stopped, [5-_{}]-done, [4-_{}]-done,
         [6-_{of:7}]-stopped, [6-_{of:"7"}]-done, [6-_{of:8}]-done,
         [4-_{of:7}]-done, [6-_{of:null}]-done, [6-_{of:7.5}]-done,
         [6-_{},7-_{}]-stopped, [6-_{of:7},7-_{of:9}]-stopped ])),
               true(Found == How) ]) :-
    after(Stops, 5, 7, Found).
test(named_by_text, Found == stopped) :-
    after([6-_{of:"a"}], 5, "a", Found).
test(during, [ forall(member(Stop-How,
       [ (6-_{})-stopped, (5-_{})-done, (6-_{of:7})-stopped,
         (6-_{of:9})-done ])),
               true(Found == How) ]) :-
    during(Stop, 5, 7, Found).
%   What is changed already is not stopped, and nothing after it.
test(committed, How-Did == done-yes) :-
    stops_forgotten,
    done(5, 7, committed(( stop(6, _{}), nb_setval(test_stop_did, yes) )), How),
    nb_getval(test_stop_did, Did),
    stops_forgotten.
test(later_one_is_done, Hows == [stopped,done]) :-
    stops_forgotten,
    thread_self(Me),
    stop_asked(Me, 6, _{}),
    done(5, 1, true, How1),
    done(7, 2, true, How2),
    stops_forgotten,
    Hows = [How1,How2].
test(answered, Hows == [stopped,done]) :-
    stops_forgotten,
    thread_self(Me),
    stop_asked(Me, 6, _{of:7}),
    done(5, 7, true, How1),
    stop_answered(6, _{of:7}),
    done(5, 7, true, How2),
    stops_forgotten,
    Hows = [How1,How2].
test(answered_badly, [ forall(member(Of, [null,7.5,[1]])),
                       error(request_error(bad_key(of, id)), _) ]) :-
    stop_answered(6, _{of:Of}).
test(answered_well, [ forall(member(Head, [_{},_{of:1},_{of:"x"}])) ]) :-
    stop_answered(6, Head).
test(under_way, Inside == [5]) :-
    stops_forgotten,
    stoppable(5, 7, findall(S, under_way(S), Inside)).
test(not_under_way_when_committed, Inside == []) :-
    stops_forgotten,
    stoppable(5, 7, committed(findall(S, under_way(S), Inside))).
test(fails, Under == []) :-
    stops_forgotten,
    \+ stoppable(5, 7, fail),
    findall(S, under_way(S), Under).

:- end_tests(stop).
