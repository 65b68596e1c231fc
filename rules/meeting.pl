:- module(sg_meeting,
          [ find_curve_points/1,        % +Set
            met_pairs/3                 % +Pairs, +Tolerance, -Met
          ]).
:- use_module(kernel,
              [ cut_set_open/2, cut_set_close/1, cut_find/1, curve_candidate/3,
                curve_enter/4, cut_seal/1, cut_polygons/2, cut_lines/2,
                cut_vertices/2
              ]).
:- use_module(leaf, [origin_segment/2]).
:- use_module(resolve, [resolve_contacts/2]).
:- autoload(library(lists), [member/2]).

/** <module> Which segments meet, without cutting them.
*/

%!  find_curve_points(+Set) is det.
%
%   Every directed segment of a curve against every triangle: section 5.1.

find_curve_points(Set) :-
    forall(curve_candidate(Set, E, T),
           curve_enter(Set, E, T, _)).

%!  met_pairs(+Pairs:list, +Tolerance, -Met:list) is det.
%
%   Met are those of Pairs that have a line, a contact or a point of a curve in
%   common, in order. What is nearer than Tolerance is made to touch
%   (resolve.pl) and is so afterwards: call it in a facts_snapshot/1.

met_pairs(Pairs, Tolerance, Met) :-
    setup_call_cleanup(
        cut_set_open(Pairs, Set),
        met_pairs(Pairs, Set, Tolerance, Met),
        cut_set_close(Set)).

met_pairs(Pairs, Set, Tolerance, Met) :-
    (   resolve_contacts(Set, Tolerance)
    ->  setup_call_cleanup(
            cut_set_open(Pairs, Resolved),
            exactly_met(Resolved, Met),
            cut_set_close(Resolved))
    ;   exactly_met(Set, Met)
    ).

exactly_met(Set, Met) :-
    cut_find(Set),
    find_curve_points(Set),
    cut_seal(Set),
    cut_polygons(Set, _),               % gives the points names
    findall(Pair, met_pair(Set, Pair), Met0),
    sort(Met0, Met).

met_pair(Set, S1-S2) :-
    cut_lines(Set, Lines),
    member(line(_, S1, _, _, _, S2, _, _, _), Lines).
met_pair(Set, S1-S2) :-
    cut_vertices(Set, Vertices),
    member(vertex(S, _, _, _, _, Origin), Vertices),
    origin_segment(Origin, Other),
    Other \== S,
    msort([S,Other], [S1,S2]).
