:- module(test_kept_leaves, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(csg/csg_record)).
:- use_module(rules(kernel), [kept_leaves/2, other_segments/1]).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).

/* Leaves that need no visit: kept_leaves/2 against made_and_kept/2. */

:- begin_tests(kept_leaves).

%   evaluated_then(Change, Kinds): two boxes united, then changed.

evaluated_then(Change, Kinds) :-
    new_world(World),
    in_world(World,
             ( add_primitive(box(size(1,2,3)), _),
               add_primitive(at([translate(0.5,0,0)], box(size(1,2,3))), _),
               assert_fact(segment(3, solid, union([1,2]))),
               complete_segments,
               evaluate(3),
               call(Change),
               kept_leaves([1,2,3,9], Kinds),
               maplist(by_rule, [1,2,3,9], Kinds),
               findall(S, ( segment(S, _, _), by_rule(S, other) ), Others),
               other_segments(Others) )).

by_rule(S, Kind) :-
    (   segment(S, Kind0, Term),
        made_and_kept(S, leaf(primitive(Term)))
    ->  Kind == Kind0
    ;   Kind == other
    ).

term_becomes(S, Term) :-
    retractall_facts(segment(S, _, _)),
    assert_fact(segment(S, solid, Term)).

test(kept, Kinds == [solid,solid,other,other]) :-
    evaluated_then(true, Kinds).
test(other_size, Kinds == [other,solid,other,other]) :-
    evaluated_then(term_becomes(1, box(size(1,2,4))), Kinds).
test(other_place, Kinds == [solid,other,other,other]) :-
    evaluated_then(term_becomes(2, at([translate(0.75,0,0)],
                                      box(size(1,2,3)))), Kinds).
test(longer_term, Kinds == [other,solid,other,other]) :-
    evaluated_then(term_becomes(1, named(b, box(size(1,2,3)))), Kinds).
test(other_rows, Kinds == [solid,other,other,other]) :-
    evaluated_then(assert_fact(v(2, 99, 0, 0, 0)), Kinds).
% 1 and three that are 1, or another one, in 32 bits.
test(no_segments, Kinds == [solid,other,other,other]) :-
    evaluated_then(kept_leaves([1,4294967297,-4294967295,0], Kinds), _).
test(no_list, error(type_error(list, 1))) :-
    in_no_change(kept_leaves(1, _)).

in_no_change(Goal) :-
    new_world(World),
    in_world(World, Goal).

:- end_tests(kept_leaves).
