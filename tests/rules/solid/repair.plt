:- module(test_repair, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(model/integrity)).
:- use_module(rules(kernel), [census/1, segment_operand/2]).
:- use_module(rules(solid/operand)).
:- use_module(rules(solid/repair)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(tests('rules/shells')).

/* Repairs: each once, what must stay as it is, and that nothing is done that
   was not asked for. */

%   soup: every polygon of segment 1 gets vertices of its own.

soup :-
    findall(P, p(1, P, _), Ps),
    retractall_facts(t(1, _, _, _, _, _)),
    maplist(apart, Ps),
    complete_segments.

apart(P) :-
    p(1, P, Es),
    findall(V, ( member(E, Es), e(1, E, V, _, _) ), Vs),
    findall(V-W, ( member(V, Vs), new_vertex(V, W) ), New),
    forall(( member(E, Es), e(1, E, A, B, T), memberchk(A-A2, New),
             memberchk(B-B2, New) ),
           facts_transaction(( retractall_facts(e(1, E, _, _, _)),
                               assert_fact(e(1, E, A2, B2, T)) ))).

new_vertex(V, W) :-
    v(1, V, X, Y, Z),
    fresh_id(v, 1, W),
    assert_fact(v(1, W, X, Y, Z)).

turned(P) :-
    p(1, P, Es),
    facts_transaction(
        forall(( member(E, Es), e(1, E, A, B, T) ),
               ( retractall_facts(e(1, E, _, _, _)),
                 assert_fact(e(1, E, B, A, T)) ))),
    retractall_facts(t(1, P, _, _, _, _)),
    retractall_facts(plane(1, P, _, _, _, _)),
    complete_segments.

face(Vs) :-
    fresh_id(p, 1, P),
    Vs = [First|Rest],
    append(Rest, [First], Nexts),
    maplist([A,B,E]>>( fresh_id(e, 1, E), assert_fact(e(1, E, A, B, 1)) ),
            Vs, Nexts, Es),
    assert_fact(p(1, P, Es)).

%   after(+Shells, :Damage, -Repairs, -Faults, -Volume)

:- meta_predicate after(+, 0, -, -, -).

after(Shells, Damage, Repairs, Faults, Volume) :-
    one_segment(Shells,
                ( Damage,
                  repaired(1, Repairs),
                  operand_faults(1, Faults),
                  segment_operand(1, operand(_,_,_,Volume0,_,_)) )),
    Volume is round(Volume0*1.0e9)/1.0e9.

box(A, B, C, X, Y, Z, at([translate(X,Y,Z)], box(size(A,B,C)))).

:- begin_tests(repair).

test(nothing, R-F-V == []-[]-6.0) :-
    after([box(size(1,2,3))], true, R, F, V).
test(no_segment, throws(error(existence_error(segment, 7), _))) :-
    new_world(World),
    in_world(World, repair_operand(7)).
test(welded, R-F-V == [repaired(welded, N)]-[]-6.0) :-
    after([box(size(1,2,3))], soup, R, F, V),
    R = [repaired(welded, N)],
    N > 15.
test(twice, R-F-V == [repaired(duplicate, 1)]-[]-6.0) :-
    after([box(size(1,2,3))],
          ( p(1, 3, Es),
            findall(V0, ( member(E, Es), e(1, E, V0, _, _) ), Vs),
            face(Vs),
            complete_segments ),
          R, F, V).
test(no_area, R-F-V == [repaired(no_area, 1)]-[]-6.0) :-
    after([box(size(1,2,3))],
          ( fresh_id(p, 1, P),
            fresh_id(e, 1, E1), assert_fact(e(1, E1, 1, 2, 1)),
            fresh_id(e, 1, E2), assert_fact(e(1, E2, 2, 1, 1)),
            assert_fact(p(1, P, [E1,E2])) ),
          R, F, V).
test(inside_out, R-F-V == [repaired(turned, 1)]-[]-6.0) :-
    after([box(size(1,2,3))],
          ( findall(P, p(1, P, _), Ps), maplist(turned, Ps) ), R, F, V).
test(one_shell_inside_out, R-F-V == [repaired(turned, 1)]-[]-9.0) :-
    box(1,1,1, 5,0,0, B),
    after([box(size(2,2,2)), B],
          ( numlist(7, 12, Ps), maplist(turned, Ps) ), R, F, V).
test(a_hollow_stays, R-F-V == []-[]-7.0) :-
    box(1,1,1, 0,0,0.5, B),
    after([box(size(2,2,2)), B],
          ( numlist(7, 12, Ps), maplist(turned, Ps) ), R, F, V).
test(all_inside_out, R-F-V == [repaired(turned, 2)]-[]-7.0) :-
    box(1,1,1, 0,0,0.5, B),
    after([box(size(2,2,2)), B],
          ( numlist(1, 6, Ps), maplist(turned, Ps) ), R, F, V).
test(a_hole_stays, F == [4]) :-
    after([box(size(1,1,1))],
          ( p(1, 1, Es),
            retractall_facts(t(1, 1, _, _, _, _)),
            retractall_facts(plane(1, 1, _, _, _, _)),
            retractall_facts(p(1, 1, _)),
            forall(member(E, Es), retractall_facts(e(1, E, _, _, _))) ),
          _, Faults, _),
    findall(N, member(open_edges(N, _), Faults), F).

:- end_tests(repair).
