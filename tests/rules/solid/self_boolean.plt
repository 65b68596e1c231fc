:- module(test_self_boolean, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(solid/boolean)).
:- use_module(rules(model/integrity)).
:- use_module(rules(kernel), [segment_operand/2]).
:- use_module(rules(model/mesh)).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(penetration/penetration), [penetrate/1]).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(tests('rules/shells')).
:- use_module(tests('rules/sample')).

/* Booleans of segments that go through themselves: what they go round at least
   once is inside. The oracle: the union of their shells as segments. */

%   result(+Expression, -Volume, -Faults): of the result, segment 9.

result(Expression, Volume, Faults) :-
    boolean(Expression, 9),
    segment_operand(9, operand(_, _, Balanced, Volume, _, _)),
    findall(Defect,
            ( model_defect(Defect), arg(1, Defect, 9),
              functor(Defect, Name, _), defect_weight(Name, fault) ),
            Faults0),
    (   Balanced == true
    ->  Faults = Faults0
    ;   Faults = [open|Faults0]
    ).

as_apart(Shells) :-
    one_segment(Shells, result(union([1]), Volume, Faults)),
    length(Shells, N),
    numlist(1, N, Ss),
    shells(Shells, result(union(Ss), Volume2, _)),
    Faults == [],
    abs(Volume-Volume2) =< 1.0e-9.

random_box(at([translate(X,Y,Z)], box(size(A,B,C)))) :-
    maplist([N]>>random_between(1, 3, N), [A,B,C]),
    maplist([N]>>random_between(0, 3, N), [X,Y,Z]).

random_solid(at([rotate(z,Angle), translate(X,Y,Z)], Solid)) :-
    random_member(Solid,
                  [ box(size(2,2,2)),
                    pyramid(base(2,2), height(2)),
                    prism(outline([[0,0],[2,0],[0,2]]), height(1)),
                    cylinder(radius(1), height(2), facets(8)),
                    cone(radius(1), height(2), facets(6))
                  ]),
    random_member(Angle, [0,90,180,45,30.1]),
    maplist([N]>>( random_between(0, 4, M), N is M/2 ), [X,Y,Z]).

random_shells(Seed, Make, Shells) :-
    set_random(seed(Seed)),
    random_between(2, 4, N),
    length(Shells, N),
    maplist(Make, Shells).

box(A, B, C, X, Y, Z, at([translate(X,Y,Z)], box(size(A,B,C)))).

:- begin_tests(self_boolean).

test(cross) :-
    as_apart([box(size(6,2,2)), box(size(2,6,2)), box(size(2,2,6))]).
test(copy) :-
    as_apart([box(size(2,2,2)), box(size(2,2,2))]).
test(nested) :-
    box(1,1,1, 0,0,0.5, B),
    as_apart([box(size(2,2,2)), B]).
test(flush) :-
    box(2,2,3, 1,0,0, B),
    as_apart([box(size(2,2,2)), B]).
test(random_boxes, Bad == []) :-
    findall(Seed, ( numbered(12, 40, Seed),
                    random_shells(Seed, random_box, Shells),
                    \+ as_apart(Shells) ), Bad).
test(random_solids, Bad == []) :-
    findall(Seed, ( numbered(12, 40, Seed),
                    random_shells(Seed, random_solid, Shells),
                    \+ as_apart(Shells) ), Bad).

%   With another operand.

test(with_another, Bad == []) :-
    findall(Seed-Operation,
            ( numbered(8, 20, Seed),
              random_shells(Seed, random_box, Shells),
              random_box(Other),
              member(Operation, [union,intersection,difference]),
              \+ with_other(Shells, Other, Operation) ),
            Bad).

with_other(Shells, Other, Operation) :-
    one_segment(Shells,
                ( add_primitive(Other, 2),
                  complete_segments,
                  Expression =.. [Operation, [1,2]],
                  result(Expression, Volume, Faults) )),
    length(Shells, N),
    numlist(1, N, Ss),
    S is N+1,
    append(Shells, [Other], All),
    Expression2 =.. [Operation, [union(Ss),S]],
    shells(All, result(Expression2, Volume2, _)),
    Faults == [],
    abs(Volume-Volume2) =< 1.0e-9.

%   A segment that was cut by itself before.

test(cut_before, V-Fs == 15.0-[]) :-
    box(2,2,2, 1,1,1, B),
    one_segment([box(size(2,2,2)), B],
                ( penetrate([1-1]), result(union([1]), V0, Fs) )),
    V is round(V0*1.0e9)/1.0e9.

%   Shells that have vertices in common, and edges; and a segment that is cut
%   already where it goes through itself, but nothing says so.

test(welded, Bad == []) :-
    findall(Seed, ( numbered(10, 30, Seed),
                    random_shells(Seed, random_box, Shells),
                    \+ as_apart(Shells, welded) ), Bad).
test(welded_solids, Bad == []) :-
    findall(Seed, ( between(1030, 1045, Seed),
                    random_shells(Seed, random_solid, Shells),
                    \+ as_apart(Shells, welded) ), Bad).
test(cut_and_forgotten, Bad == []) :-
    findall(Seed, ( between(31, 60, Seed),
                    random_shells(Seed, random_box, Shells),
                    \+ as_apart(Shells, cut_and_forgotten) ), Bad).

:- meta_predicate as_apart(+, 0).

as_apart(Shells, First) :-
    one_segment(Shells, ( First, result(union([1]), Volume, Faults) )),
    length(Shells, N),
    numlist(1, N, Ss),
    shells(Shells, result(union(Ss), Volume2, _)),
    Faults == [],
    abs(Volume-Volume2) =< 1.0e-9.

cut_and_forgotten :-
    penetrate([1-1]),
    retractall_facts(line(_, _, _, _, _, _, _, _, _)),
    retractall_facts(origin(_, _, _)),
    retractall_facts(leaf_e(_, _, _, _, _)),
    retractall_facts(leaf_p(_, _, _)),
    retractall_facts(leaf_t(_, _, _, _, _, _)),
    welded.

:- end_tests(self_boolean).
