:- module(sg_penetration,
          [ penetrate/0,
            penetrate/1,                % +Pairs
            penetrate/2,                % +Pairs, +Options
            may_cut/2,                  % +S1, +S2
            penetration_chains/1,       % -Chains
            penetration_chains/3,       % +Pairs, +Options, -Chains
            leaf_lines/4,               % +Pairs, +Wanted, +Tolerance, :Goal
            touching/3,                 % +Options, +Segments, -Tolerance
            touches/2                   % ?S1, ?S2
          ]).
:- use_module('../csg/csg_record', [joined_segment/1]).
:- use_module('../csg/csg_roots', [aside_segments/1]).
:- use_module(cut_rows, [write_polygons/2, split_curves/2]).
:- use_module('../decision', [decision/2]).
:- use_module(entering, [enter_polygons/4, close_works/1]).
:- use_module(joints, [merge_joints/2]).
:- use_module('../kernel',
              [ cut_set_open/2, cut_set_close/1, cut_flat_within/2,
                cut_of_faces/1,
                cut_without_coincident/1, cut_few_sheets/1, cut_find/1,
                near_segments/3, segment_copies_dropped/2,
                cut_seal/1, cut_chains/2, cut_polygons/2, cut_write_lines/1,
                cut_polygons_of/3, model_tolerance/1, segments_tolerance/3,
                segments_meeting_themselves/2, segment_sewn/2
              ]).
:- use_module('../csg/leaf',
              [ leaves_kept/1, were_cut/2, earlier_cuts/2, leaves_restored/1
              ]).
:- use_module(meeting,
              [ contact_pairs/3, find_curve_points/1, met_pairs/4,
                touching_pairs/2
              ]).
:- use_module('../polygon/triangulation', [new_segments_complete/0]).
:- use_module(resolve,
              [resolve_contacts/2, resolved_seams/0, tolerance_reach/2]).
:- use_module('../stage', [stage/2]).
:- use_module('../store', [segment/3, facts_snapshot/1, facts_transaction/1]).
:- use_module(library(apply), [maplist/2, partition/4]).
:- use_module(library(assoc), [get_assoc/3, ord_list_to_assoc/2]).
:- use_module(library(error), [domain_error/2, must_be/2]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(option), [option/2]).
:- use_module(library(ordsets), [ord_subtract/3, ord_union/3]).

/** <module> Penetration lines: where segments go through each other.

The rules of section 5 of the paper, over the joins of kernel.pl:

  1. Candidate pairs of leaf triangles come from trees of boxes; what a pair
     has in common is a *cut*, exact, its ends known by their features. In a
     common plane only borders of faces are lines: a connected flat part is
     one face, of however many polygons (a mesh's triangles), and an edge inside
     it is none.
  2. Each piece of a cut enters both its polygons as an edge pair, so that the
     polygons stay what they are: sets of directed edges. Against the edges
     that are there it is divided, dropped where it is contained (step 4).
  3. What was divided in one polygon is divided in all, so that a line has the
     same pieces in both its segments.
  4. Straight runs of pieces that nothing else meets become one (PL-9), and
     the polygons are triangulated again (PL-6).

Vertices and edges made here have an origin/3; the same term in both segments:

    origin(S, v(V), lpi(S1-(A,B), S2-(C,D,E)))   line A-B, triangle C,D,E
    origin(S, v(V), ll(S1-(A,B), S2-(C,D)))      two lines in one plane
    origin(S, v(V), tpi(S1-(A,B,C), S2-(...), S3-(...)))   three planes
    origin(S, v(V), v(S1, V1))                   a vertex of the other segment
    origin(S, e(E), e(Old))                      a part of an edge that was
    origin(S, e(E), line(L))                     an edge of a penetration line

The triangles are named by their corners, because corners stay and triangles
do not. line/9 has every piece once, with its vertices in both segments. A
polygon or curve that is cut keeps its leaves (leaf.pl).

@see [PL] section 5; rows PL-7, PL-8 and PL-9 of the requirements
*/

:- decision(may_cut/2, "Which segments cut each other (PL-8)").

%!  may_cut(+S1, +S2) is semidet.
%
%   Decision: segments S1 and S2, S1 < S2, cut each other. The default: those
%   that have not done so before.

may_cut(S1, S2) :-
    \+ were_cut(S1, S2).

%!  penetrate is det.
%
%   Find all penetration lines of the segments of the current world, put them
%   into the polygons and write line/9. One transaction; a world whose
%   segments do not meet stays as it is. Operands of a CSG tree are no part of
%   the model (root_segment/1). Segments that were cut by each other
%   before are not cut again (the decision may_cut/2), so it may be called
%   after loading more. The decision is asked for segments whose boxes touch
%   within the tolerance, not of two curves, and for no others; where boxes of
%   many overlap, only for those whose triangles come near each other.

penetrate :-
    penetrate(all, []).

%!  penetrate(+Pairs) is det.
%
%   The same for the segments S1-S2 of the list Pairs only. S-S is the segment S
%   with itself: where it goes through itself or lies on itself, but not where
%   its triangles are neighbours (share vertices). Nothing is made to touch
%   inside S first, unless it is a join (joined_segment/1): then each part of it
%   that is connected is made to touch the others. Its lines have S1 = S2, and
%   an edge pair in each polygon.

penetrate(Pairs) :-
    penetrate(Pairs, []).

%!  penetrate(+Pairs, +Options:list) is det.
%
%   The same, Pairs a list or `all`. Option:
%
%     - tolerance(Tolerance)
%     What is nearer than this (model units, not negative) is made to touch
%     first, see resolve.pl. 0: nothing is, the model is taken as it is.
%     Default: as model_tolerance/1 sees the model.
%
%     - themselves(true)
%     With `all`: the segments that go through themselves
%     (segment_meets_itself/1) are also cut by themselves, and joins.
%
%     - shown(true)
%     With themselves(true): only the picture matters. Of shells of a segment
%     that are equal, in one place, two are left; and where many sheets have one
%     edge in common, not each two of them get a line there.
%
%   @error type_error(list, Which) or of Options
%   @error geometry_error(polygon_edge(S, P, V1, V2)): with its lines,
%          polygon P cannot be triangulated
%   @error geometry_error(tolerance(T, Most)), as touching/3

penetrate(Which, Options) :-
    must_be(list, Options),
    (   Which == all
    ->  true
    ;   must_be(list, Which)
    ),
    (   option(shown(true), Options)
    ->  facts_transaction(( new_segments_complete,
                            sg_penetration:copies_dropped,
                            sg_penetration:penetrated(Which, Options, few) ))
    ;   penetrated(Which, Options, all)
    ).

%   penetrated(Which, Options, Sheets): Sheets is `few` if it is for a picture.

penetrated(Which, Options, Sheets) :-
    asked_segments(Which, Segments),
    touching(Options, Segments, Tolerance),
    pairs_to_cut(Which, Tolerance, Pairs0),
    (   Which == all,
        option(themselves(true), Options)
    ->  pairs_with_themselves(Selves),
        append(Selves, Pairs0, Pairs)
    ;   Pairs = Pairs0
    ),
    facts_transaction(( new_segments_complete,
                        sg_penetration:penetrated_leaves(Pairs, Tolerance,
                                                         Sheets) )).

%   copies_dropped: a picture shows no third copy of a shell.

copies_dropped :-
    forall(( segment(S, Kind, _), Kind \== curve, \+ joined_segment(S) ),
           ignore(segment_copies_dropped(S, 2))).

%   pairs_with_themselves(-Pairs): S-S for what is to be cut by itself.

pairs_with_themselves(Pairs) :-
    asked_segments(all, Own),
    findall(S, ( member(S, Own), \+ were_cut(S, S) ), Ss),
    partition(joined_segment, Ss, Joins, Others),
    segments_meeting_themselves(Others, Meeting),
    findall(S-S, ( member(S, Joins) ; member(S, Meeting) ), Pairs0),
    sort(Pairs0, Pairs).

pairs_to_cut(all, Tolerance, Pairs) :-
    !,
    aside_segments(Aside),
    findall(S-aside, member(S, Aside), Marked),
    ord_list_to_assoc(Marked, Marks),
    tolerance_reach(Tolerance, Reach),
    findall(S1-S2,
            ( near_segments(Reach, S1, S2),
              \+ get_assoc(S1, Marks, _),
              \+ get_assoc(S2, Marks, _),
              may_cut(S1, S2)
            ),
            Pairs).
pairs_to_cut(Pairs, _, Pairs).

%   asked_segments(+Which, -Segments): a set.

asked_segments(all, Segments) :-
    !,
    aside_segments(Aside),
    findall(S, ( segment(S, Kind, _), Kind \== curve ), All0),
    sort(All0, All),
    ord_subtract(All, Aside, Segments).
asked_segments(Pairs, Segments) :-
    findall(S, ( member(S1-S2, Pairs), member(S, [S1,S2]) ), All),
    sort(All, Segments).

%!  touching(+Options:list, +Segments:list, -Tolerance) is det.
%
%   Tolerance is what option tolerance(T) says, or else model_tolerance/1 and no
%   more than what is said of two segments (tolerance_reach/2).
%
%   @error geometry_error(tolerance(T, Most)): T is more than a sixteenth of the
%          smallest of Segments. With a tolerance as large as the parts,
%          everything is one point.

touching(Options, Segments, Tolerance) :-
    (   option(tolerance(Tolerance), Options)
    ->  tolerance_reach(Tolerance, Reach),
        must_be(number, Reach),
        (   Reach >= 0
        ->  true
        ;   domain_error(not_less_than_zero, Tolerance)
        ),
        refuse_large(Tolerance, Segments)
    ;   model_tolerance(Reach),
        Tolerance = own(Reach)
    ).

refuse_large(own(_), _) :-
    !.
refuse_large(_, []) :-
    !.
refuse_large(Tolerance, Segments) :-
    segments_tolerance(Segments, _, Smallest),
    Most is Smallest/16,
    (   Tolerance > Most,
        Tolerance > 0
    ->  throw(error(geometry_error(tolerance(Tolerance, Most)), _))
    ;   true
    ).

%!  touches(?S1, ?S2) is nondet.
%
%   True when segments S1 and S2 have a point of their boundaries in common, as
%   they are, or within the tolerance of penetrate/0. Nothing is cut. Of two
%   unbound segments S1 is the smaller one.

touches(S1, S2) :-
    facts_snapshot(sg_penetration:pairs_touching(S1, S2, Met)),
    member(Pair, Met),
    asked_pair(S1, S2, Pair).

pairs_touching(S1, S2, Met) :-
    new_segments_complete,
    touching([], [], Tolerance),
    tolerance_reach(Tolerance, Reach),
    findall(Low-High,
            ( near_segments(Reach, Low, High), asked_pair(S1, S2, Low-High) ),
            Pairs),
    earlier_cuts(Pairs, Earlier),
    ord_union(Earlier, Pairs, All),
    met_leaves(All, Pairs, Tolerance, Met).

%   asked_pair(?S1, ?S2, +Pair) is semidet: S1 and S2 are Pair, in either order
%   if one of them is known.

asked_pair(S1, S2, Low-High) :-
    (   S1 = Low,
        S2 = High
    ->  true
    ;   S1 = High,
        S2 = Low
    ).

%   Cuts are taken between leaves (leaf.pl): where Pairs meet, what earlier
%   cuts made is taken back, and all are taken at once.

penetrated_leaves(Pairs0, Tolerance, Sheets) :-
    sort(Pairs0, Pairs),
    earlier_cuts(Pairs, Earlier),
    (   Earlier == []
    ->  cut_leaves(Pairs, Tolerance, Sheets)
    ;   ord_union(Earlier, Pairs, All),
        facts_snapshot(sg_penetration:met_leaves(All, Pairs, Tolerance, Met)),
        penetrated_again(Met, All, Tolerance, Sheets)
    ).

penetrated_again([], _, _, _) :-
    !.
penetrated_again(_, All, Tolerance, Sheets) :-
    leaves_restored(All),
    cut_leaves(All, Tolerance, Sheets).

%   met_leaves(+All, +Pairs, +Tolerance, -Met): those of Pairs with leaves that
%   meet when All are cut.

met_leaves(All, Pairs, Tolerance, Met) :-
    leaves_restored(All),
    met_pairs(All, Pairs, Tolerance, Met).

%   Contacts are connected, so they are made to touch in all pairs of these
%   segments. Mostly those are the pairs that are to be cut.

cut_leaves(Pairs, Tolerance, Sheets) :-
    contact_pairs(Pairs, Tolerance, Contacts),
    (   Sheets == few
    ->  Next = arranged_few
    ;   Next = arranged
    ),
    touched(Pairs, Contacts, Tolerance, Next, Resolved),
    (   Resolved == true
    ->  resolved_seams
    ;   true
    ).

%   touched(+Pairs, +Contacts, +Tolerance, :Next, -Resolved): Next is done with
%   the cut set of Pairs after the contacts of Contacts were made.

touched(Pairs, Contacts, Tolerance, Next, Resolved) :-
    (   Contacts == Pairs
    ->  with_cut_set(Pairs, Tolerance, resolved(Next, Tolerance, Resolved)),
        Done = Resolved
    ;   with_cut_set(Contacts, Tolerance,
                     resolved(nothing, Tolerance, Resolved)),
        Done = true
    ),
    (   Done == true
    ->  with_cut_set(Pairs, Tolerance, Next)
    ;   true
    ).

nothing(_, _).

:- meta_predicate with_cut_set(+, +, 2).

%   What was made to touch within Tolerance is off its plane by a little more.

with_cut_set(Pairs, Tolerance, Goal) :-
    stage(tree, cut_set_open(Pairs, Set)), % long: no signals in a setup
    setup_call_cleanup(
        true,
        ( tolerance_reach(Tolerance, Reach),
          cut_flat_within(Set, Reach),
          call(Goal, Pairs, Set) ),
        cut_set_close(Set)).

%   If contacts had to be made, what comes Next starts from what that made.

resolved(Next, Tolerance, Resolved, Pairs, Set) :-
    (   stage(resolve, resolve_contacts(Set, Tolerance))
    ->  Resolved = true
    ;   Resolved = false,
        call(Next, Pairs, Set)
    ).

arranged(Pairs, Set) :-
    arranged(write_polygons, Pairs, Set).

%   Not each two of many sheets on one edge get a line.

arranged_few(Pairs, Set) :-
    cut_few_sheets(Set),
    arranged(write_polygons, Pairs, Set).

%   Write is how polygons are written.

arranged(Write, Pairs, Set) :-
    cut_of_faces(Set),
    stage(rules, ( find_lines(Set),
                   enter_lines(Write, Set),
                   split_curves(Pairs, Set)
                 )).

%!  penetration_chains(-Chains:list) is det.
%!  penetration_chains(+Pairs, +Options:list, -Chains:list) is det.
%
%   Chains are the penetration lines that penetrate/0 (or penetrate/2) would
%   enter, in order; the world stays as it is. A list of
%
%       chain(S1, S2, Kind, Points, Polygons)
%
%   where Kind is `open`, `closed` or `point`, Points are the point(X, Y, Z,
%   Origin) from end to end (of a closed one the last is the first again), and
%   Polygons the P1-P2 of each piece from one point to the next, polygons of S1
%   and S2; a point alone has those two that touch.
%   Origin is as in origin/3. The order is that of chains/1.
%
%   This is the first stage of penetrate/1. Entering the lines into polygons may
%   still divide them, where lines of three segments meet, and keeps joints that
%   are only nearly straight (polygons are flat within a tolerance) where the
%   straight edge would meet another.

penetration_chains(Chains) :-
    penetration_chains(all, [], Chains).

penetration_chains(Which, Options, Chains) :-
    asked_segments(Which, Segments),
    touching(Options, Segments, Tolerance),
    pairs_to_cut(Which, Tolerance, Pairs),
    facts_snapshot(
        sg_penetration:chains_of_leaves(Pairs, Tolerance, Chains)).

chains_of_leaves(Pairs, Tolerance, Chains) :-
    new_segments_complete,
    earlier_cuts(Pairs, Earlier),
    (   Earlier == []
    ->  true
    ;   leaves_restored(Earlier)
    ),
    touching_pairs(Pairs, Contacts),
    touched(Pairs, Contacts, Tolerance, chained(Chains), _).

%!  leaf_lines(+Pairs:list, +Wanted:list, +Tolerance, :Goal) is semidet.
%
%   The lines of Pairs, before they enter any polygon:
%   call(Goal, Set, Polygons, Weights) gets the cut set and, as S-P, the
%   polygons of the segments Wanted in which lines run, and those in which lines
%   of these run.
%   What touches within Tolerance is made to touch first, in the world, and
%   earlier cuts of these segments are taken back: call it in a
%   facts_snapshot/1. Solids S with S-S in Pairs are sewn then (segment_sewn/2):
%   Weights has the weight(S, P, Weight) of their polygons.

:- meta_predicate leaf_lines(+, +, +, 3).

leaf_lines(Pairs, Wanted, Tolerance, Goal) :-
    earlier_cuts(Pairs, Earlier),
    (   Earlier == []
    ->  true
    ;   leaves_restored(Earlier)
    ),
    contact_pairs(Pairs, Tolerance, Contacts),
    touched(Pairs, Contacts, Tolerance, sewn(Wanted, Tolerance, Goal), _).

%   What is sewn has other rows than Set was opened with.

sewn(Wanted, Tolerance, Goal, Pairs, Set) :-
    findall(S-Weights,
            ( member(S-S, Pairs),
              segment(S, solid, _),
              segment_sewn(S, Weights)
            ),
            Sewn),
    (   Sewn == []
    ->  lined(Wanted, Goal, [], Pairs, Set)
    ;   findall(weight(S, P, Weight),
                ( member(S-Weights, Sewn), member(P-Weight, Weights) ),
                All),
        with_cut_set(Pairs, Tolerance, lined(Wanted, Goal, All))
    ).

lined(Wanted, Goal, Weights, _, Set) :-
    cut_without_coincident(Set),
    stage(rules, find_lines(Set)),
    cut_polygons_of(Set, Wanted, Polygons),
    call(Goal, Set, Polygons, Weights).

chained(Chains, _, Set) :-
    cut_of_faces(Set),
    stage(rules, ( find_lines(Set),
                   merge_joints(Set, near),
                   stage(chain, cut_chains(Set, Chains))
                 )).

find_lines(Set) :-
    stage(join, cut_find(Set)),
    stage(join, find_curve_points(Set)),
    stage(join, cut_seal(Set)),
    merge_joints(Set, straight).

enter_lines(Write, Set) :-
    cut_polygons(Set, Polygons),
    stage(write, leaves_kept(Polygons)),
    setup_call_cleanup(
        true,
        ( stage(enter, enter_polygons(leaves_kept, Set, Polygons, Works)),
          stage(write, cut_write_lines(Set)),
          stage(write, call(Write, Set, Works))
        ),
        close_works(Works)).
