/* Which lines came, went, or changed, from one world to another. */
:- module(test_line_change, []).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(store)).
:- use_module(rules(studio/line_change)).
:- use_module(rules(studio/world_state)).

%   worlds(Terms1, Terms2, Reply): of a picture seen from the front.

worlds(Terms1, Terms2, Reply) :-
    world(Terms1, World1),
    world(Terms2, World2),
    changed_lines(World1, World2, _{do:"try", view:"front"}, Reply),
    world_forgotten(World1),
    world_forgotten(World2).

world(Terms, World) :-
    new_world(World),
    in_world(World, forall(member(Term, Terms), add_primitive(Term, _))),
    world_begun(World).

counts(Reply, N1-N2-N3) :-
    length(Reply.came, N1),
    length(Reply.went, N2),
    length(Reply.changed, N3),
    assertion(_{came:N1, went:N2, changed:N3} :< Reply.count).

starts(Names, Start) :-
    forall(member(Name, Names), sub_string(Name, 0, _, _, Start)).

:- begin_tests(line_change).

box(box(size(2,2,2))).
aside(At, at([translate(At,0,0)], box(size(1,1,1)))).

test(same, Counts == 0-0-0) :-
    box(Box),
    worlds([Box], [Box], Reply),
    counts(Reply, Counts).
test(came, true) :-
    box(Box),
    aside(9, Aside),
    worlds([Box], [Box,Aside], Reply),
    counts(Reply, N-0-0),
    N > 3,
    starts(Reply.came, "s2e").
test(went, true) :-
    box(Box),
    aside(9, Aside),
    worlds([Box,Aside], [Box], Reply),
    counts(Reply, 0-N-0),
    N > 3,
    starts(Reply.went, "s2e").
test(all_went, true) :-
    box(Box),
    worlds([Box], [], Reply),
    counts(Reply, 0-N-0),
    N > 3.
test(moved, true) :-
    box(Box),
    aside(9, Aside),
    aside(10, Farther),
    worlds([Box,Aside], [Box,Farther], Reply),
    counts(Reply, 0-0-N),
    N > 3,
    starts(Reply.changed, "s2e").
%   Each compared with the next ones of the other.
test(order, Parts == [["s5e1"],["s3e1","s4e2"],["s2e1"]]) :-
    Old = [(2-1)-a,(3-1)-a,(4-1)-b,(4-2)-c],
    New = [(2-1)-b,(4-1)-b,(5-1)-a],
    sg_line_change:compared(Old, New, Came, Went, Changed),
    Parts = [Came,Went,Changed].

:- end_tests(line_change).
