:- module(sg_arrangement,
          [ with_arrangement/3,         % +Leaves, +Options, :Goal
            components/2                % +Arrangement, -Components
          ]).
:- use_module(kernel,
              [ arrangement_open/3, arrangement_close/1, arrangement_polygon/5,
                arrangement_seal/1, arrangement_components/2, near_segments/3
              ]).
:- use_module(penetration, [leaves_entered/3, touching/2]).
:- use_module(stage, [stage/2]).
:- use_module(store, [facts_snapshot/1]).
:- autoload(library(apply), [maplist/2]).
:- autoload(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- autoload(library(lists), [member/2]).
/** <module> Arrangements: leaves cut along all their lines, in pieces.

The leaves of a CSG tree are arranged once, and any expression over them then
only selects: nothing is rounded between two operations, and no cut is made
twice.

@see c_kernels/arrangement.h; rows CB-3 and CB-4
*/

:- meta_predicate with_arrangement(+, +, 1).

%!  with_arrangement(+Leaves:list, +Options:list, :Goal) is semidet.
%
%   Call Goal with an arrangement of the segments Leaves added. The world stays
%   as it is; the arrangement is closed afterwards. Option:
%
%     - tolerance(Tolerance)
%     What is nearer than this (model units) is made to touch first. Default:
%     as model_tolerance/1 sees the model.
%
%   @error geometry_error(polygon_edge(S, P, V1, V2)): with its lines, P cannot
%          be triangulated

with_arrangement(Leaves, Options, Goal) :-
    touching(Options, Tolerance),
    facts_snapshot(sg_arrangement:arranged(Leaves, Tolerance, Goal)).

arranged(Leaves, Tolerance, Goal) :-
    near_pairs(Leaves, Tolerance, Pairs),
    leaves_entered(Pairs, Tolerance,
                   sg_arrangement:in_pieces(Leaves, Tolerance, Goal)).

near_pairs(Leaves, Tolerance, Pairs) :-
    findall(S-in, member(S, Leaves), In0),
    list_to_assoc(In0, In),
    findall(S1-S2,
            ( near_segments(Tolerance, S1, S2),
              get_assoc(S1, In, _),
              get_assoc(S2, In, _)
            ),
            Pairs0),
    sort(Pairs0, Pairs).

in_pieces(Leaves, Tolerance, Goal, Set, Works) :-
    arrangement_open(Set, Leaves, Arrangement),
    setup_call_cleanup(
        true,
        ( stage(pieces, filled(Arrangement, Tolerance, Works)),
          call(Goal, Arrangement)
        ),
        arrangement_close(Arrangement)).

filled(Arrangement, Tolerance, Works) :-
    maplist(taken_in(Arrangement, Tolerance), Works),
    arrangement_seal(Arrangement).

taken_in(Arrangement, Tolerance, work(S, P, Work)) :-
    arrangement_polygon(Arrangement, S, P, Work, Tolerance).

%!  components(+Arrangement, -Components:list) is det.
%
%   Components are the component(C, S, P, Point, Sides, Which) of an open
%   arrangement: arrangement_components/2.

components(Arrangement, Components) :-
    arrangement_components(Arrangement, Components).
