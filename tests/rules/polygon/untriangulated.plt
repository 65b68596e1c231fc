/* What somebody asserted and nobody completed counts like what a file brought:
   whatever asks for triangles makes them first. */
:- module(test_untriangulated, []).
:- use_module(library(aggregate)).
:- use_module(library(plunit)).
:- use_module(rules(model/measures)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(solid/boolean)).
:- use_module(rules(solid/inside)).
:- use_module(rules(solid/operand)).
:- use_module(rules(solid/trimmed)).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

two(How) :-
    add_primitive(box(size(2,2,2)), _),
    add_primitive(at([translate(1,1,1)], box(size(2,2,2))), _),
    (   How == complete
    ->  complete_segments
    ;   true
    ).

%   answer(+Question, -Answer) in the world of two/1.

question(lines).
question(chains).
question(touch).
question(drawn(visible)).
question(drawn(hidden)).
question(union).
question(trimmed).
question(inside).
question(outside).
question(faults).
question(volume).

answer(lines, N) :-
    penetrate,
    aggregate_all(count, line(_,_,_,_,_,_,_,_,_), N).
answer(chains, N) :-
    penetration_chains(Chains),
    length(Chains, N).
answer(touch, S) :-
    touches(1, S),
    !.
answer(drawn(Visibility), N) :-
    picture,
    aggregate_all(count, drawn(_,_,_,_,_,Visibility,_), N).
answer(union, V) :-
    boolean(union([1,2]), 3),
    volume(3, V).
answer(trimmed, N) :-
    trimmed(1, [2], outside, T),
    aggregate_all(count, p(T,_,_), N).
answer(inside, W) :-
    winding(1, point(0.5,0.5,0.5), W).
answer(outside, N) :-
    aggregate_all(count, inside(_, point(9,9,9)), N).
answer(faults, Faults) :-
    operand_faults(1, Faults).
answer(volume, V) :-
    volume(1, V).

:- begin_tests(untriangulated).

test(same, [forall(question(Question)), Raw-Question == Complete-Question]) :-
    in_new_world(( two(raw), once(answer(Question, Raw)) )),
    in_new_world(( two(complete), once(answer(Question, Complete)) )).
test(once_completed, Rows == Rows2) :-
    in_new_world(( two(complete), triangles(Rows), new_segments_complete,
                   triangles(Rows2) )).
test(only_those, [S,T] == [false,true]) :-
    in_new_world(( two(complete), add_primitive(box(size(1,1,1)), New),
                   truth(untriangulated(1), S),
                   truth(untriangulated(New), T) )).

triangles(Rows) :-
    findall(t(S,P,T,A,B,C), t(S,P,T,A,B,C), Rows).

truth(Goal, Truth) :-
    (   call(Goal)
    ->  Truth = true
    ;   Truth = false
    ).

:- end_tests(untriangulated).
