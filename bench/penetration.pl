/* Rule events of a penetration.

       bench/penetration [FACETS]

   Pairs: two cones of 1200 facets, one turned in the other, whose boxes all
   meet at the apex: candidates from the join, kept or skipped by handle with
   one exact sign and one comparison, and with the full test of PL-8; the last
   column is the rate over the one wanted. Events:
   two crossing cylinders; microseconds for each piece or polygon.
*/
:- use_module('../rules/store').
:- use_module('../rules/kernel').
:- use_module('../rules/primitive/primitive_rows').
:- use_module('../rules/polygon/triangulation').
:- use_module('../rules/penetration/penetration').
:- use_module('../tests/oracle/cut', [cut_pair/3]).
:- use_module(library(lists)).
:- use_module(library(apply)).
:- set_prolog_flag(optimise, true).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, Arguments),
    (   Arguments = [Text]
    ->  atom_number(Text, Facets)
    ;   Facets = 3000
    ),
    new_world(World1),
    in_world(World1, pairs),
    new_world(World2),
    in_world(World2, events(Facets)).

/* - - - pairs - - - */

pairs :-
    Cone = cone(radius(1), height(1), facets(1200)),
    add_primitive(Cone, _),
    add_primitive(at([rotate(x, 20)], Cone), _),
    complete_segments,
    cut_set_open([1-2], Set),
    rate('pairs from the join', walked(Set), 3000000),
    rate('kept or skipped by one sign and one comparison', signed(Set),
         3000000),
    rate('full test of PL-8, cuts entered', entered(Set), 200000),
    cut_set_close(Set).

:- meta_predicate rate(+, 1, +).

rate(What, Goal, Wanted) :-
    seconds(call(Goal, N), Seconds),
    Rate is round(N/Seconds),
    Ratio is Rate/Wanted,
    format("~w~t~48|~t~D~60|~t~D~72| /s~t~2f~84|~n", [What, N, Rate, Ratio]).

walked(Set, N) :-
    counted(cut_candidate(Set, _, _), N).

signed(Set, N) :-
    counted(( cut_candidate(Set, T1, T2),
              ( cut_side(Set, T1, T2, Side), Side =:= 0 -> true ; true ) ),
            N).

entered(Set, N) :-
    counted(( cut_candidate(Set, T1, T2),
              cut_pair(Set, T1, T2) ),
            N).

:- meta_predicate counted(0, -).

counted(Goal, N) :-
    Counter = count(0),
    (   call(Goal),
        arg(1, Counter, N0),
        N1 is N0+1,
        nb_setarg(1, Counter, N1),
        fail
    ;   arg(1, Counter, N)
    ).

:- meta_predicate seconds(0, -).

seconds(Goal, Seconds) :-
    statistics(cputime, T0),
    once(Goal),
    statistics(cputime, T1),
    Seconds is T1-T0.

/* - - - events - - - */

events(Facets) :-
    add_primitive(at([translate(0,0,-2)],
                     cylinder(radius(1), height(4), facets(Facets))), _),
    add_primitive(at([translate(0,0,-2), rotate(x, 90),
                      translate(0.3, 0.2, 0.1)],
                     cylinder(radius(0.8), height(4), facets(Facets))), _),
    complete_segments,
    aggregate_all(count, t(_, _, _, _, _, _), Triangles),
    format("~ntwo cylinders, ~D triangles~n", [Triangles]),
    facts_transaction(steps).

steps :-
    step('open the cut set (trees)', cut_set_open([1-2], Set)),
    step('find the cuts', cut_find(Set)),
    step('order them', cut_seal(Set)),
    step('list the joints', cut_joints(Set, straight, Joints)),
    length(Joints, NJ),
    step('decide which are merged', NJ,
         include(sg_joints:is_merged, Joints, Merged)),
    step('merge', NJ, sg_joints:settle(Set, Merged)),
    step('chain', cut_chains(Set, _)),
    step('list the polygons, name the points', cut_polygons(Set, Polygons)),
    length(Polygons, NP),
    findall(K, ( member(S-P, Polygons), cut_entering(Set, S, P, Ks),
                 member(K, Ks) ), Pieces),
    length(Pieces, NK),
    step('enter the pieces', NK,
         sg_entering:enter_all(Set, Polygons, Works0)),
    step('agree', sg_entering:agree([_]>>true, Set, Works0, Works)),
    step('merge what is nearly straight',
         sg_joints:merge_near_lines(Set, Works)),
    step('write vertices and lines', cut_write_lines(Set)),
    step('write polygons, triangulate', NP,
         sg_cut_rows:write_polygons(Set, Works)),
    aggregate_all(count, line(_, _, _, _, _, _, _, _, _), Lines),
    format("~D lines in ~D polygons~n", [Lines, NP]),
    cut_set_close(Set).

:- meta_predicate step(+, 0), step(+, +, 0).

step(What, Goal) :-
    seconds(Goal, Seconds),
    format("~w~t~56|~t~4f~68| s~n", [What, Seconds]).

step(What, N, Goal) :-
    seconds(Goal, Seconds),
    Each is Seconds/max(N, 1)*1.0e6,
    format("~w~t~56|~t~4f~68| s~t~1f~80| us each~n", [What, Seconds, Each]).
