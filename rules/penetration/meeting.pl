:- module(sg_meeting,
          [ contact_pairs/3,            % +Pairs, +Tolerance, -Contacts
            find_curve_points/1,        % +Set
            met_pairs/4,                % +All, +Pairs, +Tolerance, -Met
            touching_pairs/2            % +Pairs, -Contacts
          ]).
:- use_module('../csg/csg_record', [joined_segment/1]).
:- use_module('../kernel',
              [ cut_set_open/2, cut_set_close/1, cut_find/1, curve_candidate/3,
                curve_enter/4, cut_seal/1, cut_polygons/2, cut_lines/2,
                cut_vertices/2, near_pairs/3
              ]).
:- use_module('../csg/leaf', [origin_segment/2]).
:- use_module(resolve, [resolve_contacts/2, tolerance_reach/2]).
:- use_module(library(apply), [exclude/3]).
:- use_module(library(lists), [member/2]).
:- use_module(library(ordsets), [ord_union/3]).

/** <module> Which segments meet, without cutting them.
*/

%!  find_curve_points(+Set) is det.
%
%   Every directed segment of a curve against every triangle: section 5.1.

find_curve_points(Set) :-
    forall(curve_candidate(Set, E, T),
           curve_enter(Set, E, T, _)).

%!  contact_pairs(+Pairs:list, +Tolerance, -Contacts:list) is det.
%
%   Contacts are Pairs, in order, and the other pairs of the same segments whose
%   boxes are not farther apart than Tolerance. A segment with itself is none,
%   but if it is a join (joined_segment/1).

contact_pairs(Pairs0, Tolerance, Contacts) :-
    touching_pairs(Pairs0, Pairs),
    pairs_contacts(Pairs, Tolerance, Contacts).

pairs_contacts([], _, []) :-
    !.
pairs_contacts([Pair], _, [Pair]) :-
    !.
pairs_contacts(Pairs, Tolerance, Contacts) :-
    findall(S, ( member(S1-S2, Pairs), member(S, [S1,S2]) ), Segments),
    tolerance_reach(Tolerance, Reach),
    near_pairs(Reach, Segments, NearPairs),
    ord_union(Pairs, NearPairs, Contacts).

%!  touching_pairs(+Pairs:list, -Contacts:list) is det.
%
%   Contacts are those of Pairs that may be made to touch, as contact_pairs/3
%   says.

touching_pairs(Pairs, Contacts) :-
    exclude(is_one_body, Pairs, Contacts).

is_one_body(S-S) :-
    \+ joined_segment(S).

%!  met_pairs(+All:list, +Pairs:list, +Tolerance, -Met:list) is det.
%
%   Met are those of Pairs that have a line, a contact or a point of a curve in
%   common, in order. What is nearer than Tolerance in the segments of All pairs
%   is made to touch (resolve.pl) and is so afterwards: call it in a
%   facts_snapshot/1.

met_pairs(All, Pairs, Tolerance, Met) :-
    contact_pairs(All, Tolerance, Contacts),
    with_set(Contacts, touching(Tolerance)),
    with_set(Pairs, exactly_met(Met)).

:- meta_predicate with_set(+, 1).

with_set(Pairs, Goal) :-
    cut_set_open(Pairs, Set), % long: no signals in a setup
    setup_call_cleanup(
        true,
        call(Goal, Set),
        cut_set_close(Set)).

touching(Tolerance, Set) :-
    (   resolve_contacts(Set, Tolerance)
    ->  true
    ;   true
    ).

exactly_met(Met, Set) :-
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
