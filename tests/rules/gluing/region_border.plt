/* The borders of regions: zones at vertices, and shells, which the kernel
   counts too. */
:- module(test_region_border, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(gluing/region_border)).
:- use_module(rules(solid/glue)).
:- use_module(rules(store)).
:- use_module(tests(rules/glue_model)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

:- begin_tests(region_border).

%   As many shells as the kernel counts, and each use is in one.

test(shells, [ forall(( shelled(Name), once(model(Name, Parts, _)) )),
               Told-Uses == Counted-All ]) :-
    in_new_world(shells(Parts, Told, Counted, Uses, All)).

shelled(two(vertex)).
shelled(two(edge)).
shelled(two(nested)).
shelled(fig4(wire)).
shelled(fig6).
shelled(fig8(face)).
shelled(fig8(ridge)).
shelled(large_sheet).
shelled(nested(2)).
shelled(six_pyramids).
shelled(frame(alone)).
shelled(wire(through)).
shelled(wire(inside)).
shelled(wire(round)).
shelled(wire(only)).
shelled(moebius).

shells(Parts, Told, Counted, Uses, All) :-
    glue_made(Parts, [], S),
    glue_report(S, Report),
    findall(N, ( member(Region, Report.regions), N = Region.shells ), Counted),
    findall(N,
            ( region(S, R, _),
              aggregate_all(count, shell(S, R, _, _), N) ),
            Told),
    findall(Use, ( shell(S, _, _, Us), member(Use, Us) ), Uses0),
    msort(Uses0, Uses1),
    length(Uses1, Uses),
    aggregate_all(count, sides(S, _, _, _), Faces),
    aggregate_all(count, lies_in(S, _, r(_)), Items),
    All is 2*Faces+Items.

%   Fig. 4: the pyramid in another one is in a zone of its own; what is outside
%   sees three disks.

test(fig4, Zones == [cell-1,cell-1,cell-2,outside-3]) :-
    model(fig4(wire), Parts, _),
    in_new_world(( glue_made(Parts, [], S),
                   v(S, V, 0.0, 0.0, 0.0),
                   findall(Role-N,
                           ( zone(S, V, R, Cycles),
                             region(S, R, Role),
                             length(Cycles, N) ),
                           Zones0) )),
    msort(Zones0, Zones).

%   Inside of eight cubes there are eight zones at a vertex, with three corners.

test(cubes, Ns == [3,3,3,3,3,3,3,3]) :-
    model(cubes(2), Parts, _),
    in_new_world(( glue_made(Parts, [], S),
                   aggregate_all(count, v(S, _, _, _, _), 27),
                   inner_vertex(S, V),
                   findall(N, ( zone(S, V, _, [Cycle]), length(Cycle, N) ),
                           Ns) )),
    !.

inner_vertex(S, V) :-
    v(S, V, _, _, _),
    findall(E, e(S, E, V, _, _), Es),
    length(Es, 12),
    !.

test(alone, Cycles == [[]]) :-
    in_new_world(( assert_fact(segment(1, cells, point)),
                   assert_fact(v(1, 1, 0, 0, 0)),
                   assert_fact(region(1, 1, outside)),
                   assert_fact(lies_in(1, v(1), r(1))),
                   findall(Cs, zone(1, 1, 1, Cs), Cycles) )).

:- end_tests(region_border).
