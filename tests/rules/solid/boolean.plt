/* Union, intersection and difference: rules/solid/boolean.pl. */
:- use_module(library(plunit)).
:- use_module(rules(solid/arrangement)).
:- use_module(rules(solid/boolean)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(occurs)).

:- begin_tests(boolean).

%   result(+Terms, +Expression, -Volume, -Counts): of solids 1, 2, ...

result(Terms, Expression, Volume, counts(Vertices, Polygons, Open)) :-
    new_world(World),
    in_world(World,
             ( maplist(added, Terms),
               complete_segments,
               boolean(Expression, 100),
               volume(100, Volume),
               aggregate_all(count, v(100, _, _, _, _), Vertices),
               aggregate_all(count, p(100, _, _), Polygons),
               aggregate_all(count, open_edge(100), Open)
             )).

added(Term) :-
    add_primitive(Term, _).

open_edge(S) :-
    e(S, _, A, B, _),
    aggregate_all(count, e(S, _, A, B, _), N),
    aggregate_all(count, e(S, _, B, A, _), M),
    N =\= M.

volume(S, Volume) :-
    aggregate_all(sum(Part), part_volume(S, Part), Volume).

part_volume(S, Part) :-
    t(S, _, _, A, B, C),
    v(S, A, X1, Y1, Z1),
    v(S, B, X2, Y2, Z2),
    v(S, C, X3, Y3, Z3),
    Part is (X1*(Y2*Z3-Z2*Y3) + Y1*(Z2*X3-X2*Z3) + Z1*(X2*Y3-Y2*X3)) / 6.

near(X, Y) :-
    abs(X-Y) < 1.0e-12.

boxes([ box(size(2, 2, 2)),
        at([translate(1, 0.5, 0.7)], box(size(2, 2, 2)))
      ]).

test(union, [true((near(V, 14.05), Open =:= 0, Vs =:= 20))]) :-
    boxes(Boxes),
    result(Boxes, union([1,2]), V, counts(Vs, _, Open)).
test(intersection, [true((near(V, 1.95), Open =:= 0, Counts == 8-6))]) :-
    boxes(Boxes),
    result(Boxes, intersection([1,2]), V, counts(Vs, Ps, Open)),
    Counts = Vs-Ps.
test(difference, [true((near(V, 6.05), Open =:= 0, Counts == 14-9))]) :-
    boxes(Boxes),
    result(Boxes, difference([1,2]), V, counts(Vs, Ps, Open)),
    Counts = Vs-Ps.
test(nothing_left, [true(V-Counts == 0-counts(0, 0, 0))]) :-
    result([box(size(2, 2, 2))], difference([1,1]), V, Counts).
test(itself, [true((near(V, 8.0), Open =:= 0))]) :-
    result([box(size(2, 2, 2)), box(size(2, 2, 2))], union([1,2]), V,
           counts(_, _, Open)).
test(common_face_goes, [true((near(V, 16.0), Ps =:= 6, Open =:= 0))]) :-
    result([box(size(2, 2, 2)), at([translate(2, 0, 0)], box(size(2, 2, 2)))],
           union([1,2]), V, counts(_, Ps, Open)).
test(hollow, [true((near(V, 7.0), Counts == 16-12, Open =:= 0))]) :-
    result([ box(size(2, 2, 2)),
             at([translate(0, 0, 0.5)], box(size(1, 1, 1)))
           ], difference([1,2]), V, counts(Vs, Ps, Open)),
    Counts = Vs-Ps.
test(any_number, [true((near(V, 17.0), Open =:= 0))]) :-
    findall(at([translate(X, 0, 0)], box(size(2, 2, 2))),
            ( between(0, 15, I), X is 0.15*I ),
            Boxes),
    numlist(1, 16, Ss),
    result(Boxes, union(Ss), V, counts(_, _, Open)).
test(nested_expression, [true((near(V, 6.05), Open =:= 0))]) :-
    boxes(Boxes),
    result(Boxes, intersection([1, difference([union([1,2]), 2])]), V,
           counts(_, _, Open)).
test(operands_stay_as_they_are) :-
    boxes(Boxes),
    new_world(World),
    in_world(World,
             ( maplist(added, Boxes),
               complete_segments,
               findall(t(S, P, T, A, B, C), t(S, P, T, A, B, C), Before),
               boolean(union([1,2]), 3),
               findall(t(S, P, T, A, B, C),
                       ( t(S, P, T, A, B, C), S < 3 ), After)
             )),
    Before == After.
test(polygons_know_their_origin) :-
    boxes(Boxes),
    new_world(World),
    in_world(World,
             ( maplist(added, Boxes),
               complete_segments,
               boolean(difference([1,2]), 3),
               findall(S0-Sense, ( p(3, P, _), from_p(3, P, S0, _, Sense) ),
                       From0),
               findall(O, origin(3, v(_), O), Made)
             )),
    msort(From0, From),
    From == [1-1,1-1,1-1,1-1,1-1,1-1,2-(-1),2-(-1),2-(-1)],
    length(Made, 6).
test(sides_of_a_component, [true(Sides == [[side(1, 1, 0)],
                                           [side(1, 1, 0), side(2, 1, 1)],
                                           [side(1, 1, 1), side(2, 1, 0)],
                                           [side(2, 1, 0)]])]) :-
    boxes(Boxes),
    new_world(World),
    in_world(World,
             ( maplist(added, Boxes),
               complete_segments,
               with_arrangement([1,2], [], components_of(Cs))
             )),
    findall(Sides0, member(component(_, _, _, _, Sides0, only), Cs), Sides1),
    msort(Sides1, Sides).

components_of(Cs, Arrangement) :-
    components(Arrangement, Cs).

%   The rule and its fused kernel, on expressions over some that overlap, touch,
%   lie in each other and coincide, and on an open surface.

test(rule_and_kernel, [forall(some_expression(Expression))]) :-
    new_world(World),
    in_world(World,
             ( maplist(added,
                       [ box(size(2, 2, 2)),
                         at([translate(1, 0.5, 0.7)], box(size(2, 2, 2))),
                         at([translate(2, 0, 0)], box(size(2, 2, 2))),
                         box(size(2, 2, 2)),
                         at([translate(0, 0, 0.5)], box(size(1, 1, 1))),
                         at([translate(0, 0, 1)], rectangle(size(5, 5)))
                       ]),
               complete_segments,
               with_arrangement([1,2,3,4,5,6], [], both_senses(Expression))
             )).

both_senses(Expression, Arrangement) :-
    senses_by_rule(Arrangement, Expression, ByRule),
    expression_leaves(Expression, Leaves),
    include(==(6), Leaves, Open),
    default_senses(Arrangement, Expression, Open, Senses),
    assertion(Senses == ByRule).

some_expression(union([1,2,3,4,5])).
some_expression(intersection([1,2])).
some_expression(intersection([1,2,4])).
some_expression(difference([1,2,5])).
some_expression(difference([union([1,3]), intersection([2,4])])).
some_expression(union([1,6])).
some_expression(3).

%   What is no expression is an error of the kernel.

test(no_expression, [forall(no_expression(Expression, Error)),
                     error(Error)]) :-
    new_world(World),
    in_world(World,
             ( maplist(added, [box(size(2, 2, 2)), box(size(1, 1, 1))]),
               complete_segments,
               with_arrangement([1,2], [], senses_of(Expression)) )).

senses_of(Expression, Arrangement) :-
    default_senses(Arrangement, Expression, [], _).

no_expression(union(1, 2),    type_error(integer, union(1, 2))).
no_expression(union([1|_]),   type_error(integer, _)).
no_expression(union([1,a]),   type_error(integer, a)).
no_expression(together([1]),  domain_error(operation, together)).
no_expression(difference([]), domain_error(operands, _)).
no_expression(union([1,0]),   domain_error(segment, _)).

test(surface_outside_stays, [true(Vs-Ps-Open == 16-11-16)]) :-
    result([ box(size(2, 2, 2)),
             at([translate(0, 0, 1)], rectangle(size(5, 5)))
           ], union([1,2]), _, counts(Vs, Ps, Open)).
%   Boxes that share part of a face, turned: they are made to touch in vertices
%   that they have only for that.

test(no_origin_names_what_is_not_there, [true(Gone-Named == []-[])]) :-
    Turn = rotate(axis(3,1,2), 37),
    in_new_world_of([ at([Turn], box(size(2, 2, 2))),
                      at([translate(0.5,0.3,2),Turn], box(size(1, 1, 1))) ],
                    ( boolean(union([1,2]), 3, [faces(pieces)]),
                      findall(V, ( from_v(3, V, S0, V0),
                                   \+ v(S0, V0, _, _, _) ), Gone),
                      findall(O, ( origin(3, v(_), O),
                                   sub_term(S1-(A,_), O),
                                   \+ O = near(_),
                                   \+ v(S1, A, _, _, _) ), Named) )).
test(tolerance_as_large_as_a_part,
     [error(geometry_error(tolerance(1, 0.125)))]) :-
    boxes(Boxes),
    in_new_world_of(Boxes, boolean(union([1,2]), 100, [tolerance(1)])).

in_new_world_of(Terms, Goal) :-
    new_world(World),
    in_world(World,
             ( maplist(added, Terms),
               complete_segments,
               call(Goal)
             )).

test(no_such_segment, [error(existence_error(segment, 7))]) :-
    result([box(size(1, 1, 1))], union([1,7]), _, _).
test(no_such_operation, [error(type_error(expression, glue([1])))]) :-
    result([box(size(1, 1, 1))], glue([1]), _, _).
test(no_operands, [error(domain_error(operands, []))]) :-
    result([box(size(1, 1, 1))], union([]), _, _).

%   What is open is named.

test(open_operand, error(geometry_error(operand(2, [open_edges(4, _)])))) :-
    boxes(Boxes),
    new_world(World),
    in_world(World,
             ( maplist(added, Boxes),
               complete_segments,
               facts_transaction(a_face_gone(2)),
               boolean(union([1,2]), 3)
             )).

a_face_gone(S) :-
    once(p(S, P, Es)),
    retractall_facts(t(S, P, _, _, _, _)),
    retractall_facts(plane(S, P, _, _, _, _)),
    retractall_facts(p(S, P, _)),
    forall(member(E, Es), retractall_facts(e(S, E, _, _, _))).

%   Deeper than the stack of C.

test(deep_expression, [true(Polygons == 6)]) :-
    new_world(World),
    in_world(World,
             ( added(box(size(1, 1, 1))),
               complete_segments,
               numlist(1, 150_000, Ns),
               foldl(nested, Ns, 1, Expression),
               assert_fact(segment(2, solid, deep)),
               boolean(Expression, 2),
               aggregate_all(count, p(2, _, _), Polygons)
             )).

nested(_, Expression, union([Expression])).

:- end_tests(boolean).
