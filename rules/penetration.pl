:- module(sg_penetration,
          [ penetrate/0,
            penetrate/1,                % +Pairs
            penetrate/2,                % +Pairs, +Options
            may_cut/2,                  % +S1, +S2
            merge_line/2,               % +Piece1, +Piece2
            penetration_chains/1,       % -Chains
            penetration_chains/3,       % +Pairs, +Options, -Chains
            leaves_entered/4,           % +Pairs, +Wanted, +Tolerance, :Goal
            touching/2,                 % +Options, -Tolerance
            triangle_cut/5              % +S1-T1, +S2-T2, -Kind, -End1, -End2
          ]).
:- use_module(csg_record, [joined_segment/1]).
:- use_module(csg_roots, [aside_segments/1]).
:- use_module(cut_rows,
              [ write_vertices/1, write_lines/1, write_polygon/2, split_curves/2
              ]).
:- use_module(decision, [decision/2]).
:- use_module(kernel,
              [ cut_set_open/2, cut_set_close/1, cut_candidate/3, cut_find/1,
                cut_side/4, cut_enter/4, cut_triangle/5, cut_ends/4,
                near_segments/3, cut_seal/1, cut_joints/3, cut_join/2,
                cut_settle/1, cut_chains/2, cut_polygons/2, cut_polygons_of/3,
                cut_entering/4,
                cut_enter_free/4,
                cut_work/4, cut_crossing/8, cut_note/5, cut_between/6,
                cut_divided/4, cut_agree/1, cut_late_polygons/2, cut_name/4,
                model_tolerance/1, work_add/6, work_delete/2, work_edge/6,
                work_meeting/6, work_close/1, segments_meeting_themselves/2
              ]).
:- use_module(leaf,
              [ leaves_kept/1, were_cut/2, earlier_cuts/2, leaves_restored/1
              ]).
:- use_module(meeting,
              [ contact_pairs/3, find_curve_points/1, met_pairs/4,
                touching_pairs/2
              ]).
:- use_module(resolve, [resolve_contacts/2, resolved_seams/0]).
:- use_module(stage, [stage/2]).
:- use_module(store, [segment/3, facts_snapshot/1, facts_transaction/1]).
:- autoload(library(apply),
            [exclude/3, include/3, maplist/2, maplist/3, partition/4]).
:- autoload(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- autoload(library(error), [domain_error/2, must_be/2]).
:- autoload(library(lists), [append/3, member/2]).
:- autoload(library(option), [option/2]).
:- autoload(library(ordsets), [ord_memberchk/2, ord_union/3]).

/** <module> Penetration lines: where segments go through each other.

The rules of section 5 of the paper, over the joins of kernel.pl:

  1. Candidate pairs of leaf triangles come from trees of boxes; what a pair
     has in common is a *cut*, exact, its ends known by their features.
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

:- decision(merge_line/2,
            "Which collinear pieces of a line become one (PL-9)").

%!  merge_line(+Piece1, +Piece2) is semidet.
%
%   Decision: two pieces become one. A piece is
%   piece(S1, Polygon1, S2, Polygon2); the two meet in a vertex where no other
%   edge is, and are in line. The default: those of the same two polygons.

merge_line(Piece, Piece).

%!  penetrate is det.
%
%   Find all penetration lines of the segments of the current world, put them
%   into the polygons and write line/9. One transaction; a world whose
%   segments do not meet stays as it is. Operands of a CSG tree are no part of
%   the model (root_segment/1). Segments that were cut by each other
%   before are not cut again (the decision may_cut/2), so it may be called
%   after loading more. The decision is asked for segments whose boxes touch
%   within the tolerance, and for no others.

penetrate :-
    penetrate(all, []).

%!  penetrate(+Pairs) is det.
%
%   The same for the segments S1-S2 of the list Pairs only. S-S is the segment S
%   with itself: where it goes through itself or lies on itself, but not where
%   its triangles are neighbours (share vertices). Nothing is made to touch
%   inside S first, unless it is a join (joined_segment/1): then each part of it
%   that hangs together is made to touch the others. Its lines have S1 = S2, and
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
%   @error geometry_error(polygon_edge(S, P, V1, V2)): with its lines,
%          polygon P cannot be triangulated

penetrate(Which, Options) :-
    touching(Options, Tolerance),
    pairs_to_cut(Which, Tolerance, Pairs0),
    (   Which == all,
        option(themselves(true), Options)
    ->  pairs_with_themselves(Selves),
        append(Selves, Pairs0, Pairs)
    ;   Pairs = Pairs0
    ),
    facts_transaction(sg_penetration:penetrated_leaves(Pairs, Tolerance)).

%   pairs_with_themselves(-Pairs): S-S for what is to be cut by itself.

pairs_with_themselves(Pairs) :-
    aside_segments(Aside),
    findall(S,
            ( segment(S, Kind, _),
              Kind \== curve,
              \+ ord_memberchk(S, Aside),
              \+ were_cut(S, S)
            ),
            Ss),
    partition(joined_segment, Ss, Joins, Others),
    segments_meeting_themselves(Others, Meeting),
    findall(S-S, ( member(S, Joins) ; member(S, Meeting) ), Pairs0),
    sort(Pairs0, Pairs).

pairs_to_cut(all, Tolerance, Pairs) :-
    !,
    aside_segments(Aside),
    findall(S1-S2,
            ( near_segments(Tolerance, S1, S2),
              \+ ord_memberchk(S1, Aside),
              \+ ord_memberchk(S2, Aside),
              may_cut(S1, S2)
            ),
            Pairs).
pairs_to_cut(Pairs, _, Pairs).

%!  touching(+Options:list, -Tolerance) is det.
%
%   Tolerance is what option tolerance(T) says, or else model_tolerance/1.

touching(Options, Tolerance) :-
    (   option(tolerance(Tolerance), Options)
    ->  must_be(number, Tolerance),
        (   Tolerance >= 0
        ->  true
        ;   domain_error(not_less_than_zero, Tolerance)
        )
    ;   model_tolerance(Tolerance)
    ).

%   Cuts are taken between leaves (leaf.pl): where Pairs meet, what earlier
%   cuts made is taken back, and all are taken at once.

penetrated_leaves(Pairs0, Tolerance) :-
    sort(Pairs0, Pairs),
    earlier_cuts(Pairs, Earlier),
    (   Earlier == []
    ->  penetrated(Pairs, Tolerance)
    ;   ord_union(Earlier, Pairs, All),
        facts_snapshot(sg_penetration:met_leaves(All, Pairs, Tolerance, Met)),
        penetrated_again(Met, All, Tolerance)
    ).

penetrated_again([], _, _) :-
    !.
penetrated_again(_, All, Tolerance) :-
    leaves_restored(All),
    penetrated(All, Tolerance).

%   met_leaves(+All, +Pairs, +Tolerance, -Met): those of Pairs with leaves that
%   meet when All are cut.

met_leaves(All, Pairs, Tolerance, Met) :-
    leaves_restored(All),
    met_pairs(All, Pairs, Tolerance, Met).

%   Contacts hang together, so they are made to touch in all pairs of these
%   segments. Mostly those are the pairs that are to be cut.

penetrated(Pairs, Tolerance) :-
    contact_pairs(Pairs, Tolerance, Contacts),
    touched(Pairs, Contacts, Tolerance, arranged, Resolved),
    (   Resolved == true
    ->  resolved_seams
    ;   true
    ).

%   touched(+Pairs, +Contacts, +Tolerance, :Next, -Resolved): Next is done with
%   the cut set of Pairs after the contacts of Contacts were made.

touched(Pairs, Contacts, Tolerance, Next, Resolved) :-
    (   Contacts == Pairs
    ->  with_cut_set(Pairs, resolved(Next, Tolerance, Resolved)),
        Done = Resolved
    ;   with_cut_set(Contacts, resolved(nothing, Tolerance, Resolved)),
        Done = true
    ),
    (   Done == true
    ->  with_cut_set(Pairs, Next)
    ;   true
    ).

nothing(_, _).

:- meta_predicate with_cut_set(+, 2).

with_cut_set(Pairs, Goal) :-
    stage(tree, cut_set_open(Pairs, Set)), % long: no signals in a setup
    setup_call_cleanup(
        true,
        call(Goal, Pairs, Set),
        cut_set_close(Set)).

%   If contacts had to be made, what comes Next starts from what that made.

resolved(Next, Tolerance, Resolved, Pairs, Set) :-
    (   stage(resolve, resolve_contacts(Set, Tolerance))
    ->  Resolved = true
    ;   Resolved = false,
        call(Next, Pairs, Set)
    ).

arranged(Pairs, Set) :-
    arranged(write_polygon, Pairs, Set).

%   Write is how a polygon is written.

arranged(Write, Pairs, Set) :-
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
    touching(Options, Tolerance),
    pairs_to_cut(Which, Tolerance, Pairs),
    facts_snapshot(
        sg_penetration:chains_of_leaves(Pairs, Tolerance, Chains)).

chains_of_leaves(Pairs, Tolerance, Chains) :-
    earlier_cuts(Pairs, Earlier),
    (   Earlier == []
    ->  true
    ;   leaves_restored(Earlier)
    ),
    touching_pairs(Pairs, Contacts),
    touched(Pairs, Contacts, Tolerance, chained(Chains), _).

%!  leaves_entered(+Pairs:list, +Wanted:list, +Tolerance, :Goal) is semidet.
%
%   The lines of Pairs enter the polygons of the segments Wanted, and those in
%   which lines of these run, but nothing of that is written:
%   call(Goal, Set, Works) gets the cut set and a list of work(S, P, Work).
%   What touches within Tolerance is made to touch first, in the world, and
%   earlier cuts of these segments are taken back: call it in a
%   facts_snapshot/1.

:- meta_predicate leaves_entered(+, +, +, 2).

leaves_entered(Pairs, Wanted, Tolerance, Goal) :-
    earlier_cuts(Pairs, Earlier),
    (   Earlier == []
    ->  true
    ;   leaves_restored(Earlier)
    ),
    contact_pairs(Pairs, Tolerance, Contacts),
    touched(Pairs, Contacts, Tolerance, entered(Wanted, Goal), _).

entered(Wanted, Goal, _, Set) :-
    stage(rules, find_lines(Set)),
    cut_polygons_of(Set, Wanted, Polygons),
    setup_call_cleanup(
        true,
        ( stage(enter, enter_polygons(is_list, Set, Polygons, Works)),
          call(Goal, Set, Works)
        ),
        ( ground(Works) -> maplist(close_work, Works) ; true )).

chained(Chains, _, Set) :-
    stage(rules, ( find_lines(Set),
                   merge_joints(Set, near),
                   stage(chain, cut_chains(Set, Chains))
                 )).

find_lines(Set) :-
    stage(join, cut_find(Set)),
    stage(join, find_curve_points(Set)),
    stage(join, cut_seal(Set)),
    merge_joints(Set, straight).

merge_joints(Set, How) :-
    stage(join, cut_joints(Set, How, Joints)),
    stage(rules, include(is_merged, Joints, Merged)),
    stage(join, settle(Set, Merged)).

settle(Set, Joints) :-
    (   Joints == []
    ->  true
    ;   maplist(join(Set), Joints),
        cut_settle(Set)
    ).

enter_lines(Write, Set) :-
    cut_polygons(Set, Polygons),
    stage(write, leaves_kept(Polygons)),
    setup_call_cleanup(
        true,
        ( stage(enter, enter_polygons(leaves_kept, Set, Polygons, Works)),
          stage(write, write_vertices(Set)),
          stage(write, write_lines(Set)),
          stage(write, maplist(call(Write, Set), Works))
        ),
        ( ground(Works) -> maplist(close_work, Works) ; true )).

%   Keep is told, as a list, which polygons are opened beside Polygons.

enter_polygons(Keep, Set, Polygons, Works) :-
    maplist(enter_cuts(Set), Polygons, Works0),
    agree(Keep, Set, Works0, Works),
    merge_near_lines(Set, Works).

close_work(work(_, _, Work)) :-
    work_close(Work).

/* - - - steps 1 to 3: the cuts - - - */

%   5.2 *1: a triangle of each of two segments, their boxes overlapping.
%   cut_find/1 is the fused kernel of these two rules; a test holds them
%   together.

find_cuts_by_rule(Set) :-
    forall(cut_candidate(Set, T1, T2),
           cut_pair(Set, T1, T2)).

%   5.2 2: each must have corners on both sides of the other's plane (or on
%   it). *3: what they have in common goes into the set.

cut_pair(Set, T1, T2) :-
    (   cut_side(Set, T1, T2, 0),
        cut_side(Set, T2, T1, 0)
    ->  cut_enter(Set, T1, T2, _)
    ;   true
    ).

%!  triangle_cut(+Triangle1, +Triangle2, -Kind, -End1, -End2) is nondet.
%
%   True when triangles T1 of segment S1 and T2 of S2 have the points from
%   End1 to End2 in common: one piece if their planes differ (Kind is
%   `crossing`), the borders of each inside the other if not (`coplanar`); a
%   point if the ends are equal. An end is a pair of features,
%   Feature1-Feature2, each one of vertex(V), edge(V1,V2) and face(T). Exact.

triangle_cut(S1-T1, S2-T2, Kind, End1, End2) :-
    cut_set_open([S1-S2], Set),
    setup_call_cleanup(
        true,
        findall(cut(K, A, B), set_cut(Set, S1-T1, S2-T2, cut(K, A, B)), Cuts),
        cut_set_close(Set)),
    member(cut(Kind, End1, End2), Cuts).

set_cut(Set, S1-T1, S2-T2, Cut) :-
    cut_candidate(Set, I, J),
    cut_triangle(Set, I, S1, _, T1),
    cut_triangle(Set, J, S2, _, T2),
    cut_ends(Set, I, J, Cuts),
    member(Cut, Cuts).

/* - - - steps 4 and 5: entering a polygon - - - */

%   A polygon's edges, those on which an end of a cut lies already divided
%   there, go into a scratch relation, and then the pieces of cuts one by one.

%   cut_enter_free/4 is the fused kernel for those that meet nothing.

enter_cuts(Set, S-P, work(S, P, Work)) :-
    cut_work(Set, S, P, Work),
    (   cut_enter_free(Set, S, P, Work)
    ->  true
    ;   enter_by_rule(Set, S, P, Work)
    ).

enter_by_rule(Set, S, P, Work) :-
    cut_entering(Set, S, P, Pieces),
    maplist(enter_piece(Set, S, P, Work), Pieces).

enter_piece(Set, S, P, Work, piece(K, V1, V2)) :-
    enter(auxiliary(Set, S, Work, K, P-[]), V1, V2).

%   (1) V1-V2 is an auxiliary segment, (2) the one chosen. (3-1) While an edge
%   contains or crosses it, it is divided and its parts are entered; (3-2)
%   when none does, it joins the polygon as an edge pair. What was divided in
%   another polygon is divided there first, edges too: so everything is
%   divided in the same points and in the same order, wherever it is.

enter(Auxiliary, V1, V2) :-
    Auxiliary = auxiliary(Set, S, Work, _, _),
    (   cut_between(Set, Work, S, V1, V2, X)
    ->  enter_both(Auxiliary, V1, X, V2)
    ;   work_meeting(Work, V1, V2, E, How, Inside),
        meeting_step(How, Inside, Step)
    ->  enter_step(Step, E, Auxiliary, V1, V2)
    ;   add_pair(Auxiliary, V1, V2)
    ).

%   What a meeting asks for. First the edge is divided where an end of the
%   segment lies inside it, then the segment where an end of the edge does.
%   After that only a crossing is left, or an edge that is the segment itself.

meeting_step(crosses, _, crossing) :-
    !.
meeting_step(_, Inside, divide_edge(End)) :-
    member(End, [v1,v2]),
    memberchk(End, Inside),
    !.
meeting_step(_, Inside, divide_segment(End)) :-
    member(End, [start,end]),
    memberchk(End, Inside),
    !.
meeting_step(contained, _, drop).

enter_step(Step, E, Auxiliary, V1, V2) :-
    edge_to_divide(Step),
    Auxiliary = auxiliary(Set, S, Work, _, _),
    work_edge(Work, E, A, B, _, _),
    cut_between(Set, Work, S, A, B, X),
    !,
    divide_pair(Auxiliary, E, X),
    enter(Auxiliary, V1, V2).

%   2-2: both are cut in the point where they cross.

enter_step(crossing, E, Auxiliary, V1, V2) :-
    Auxiliary = auxiliary(Set, S, Work, K, _),
    cut_crossing(Set, Work, S, K, E, V1, V2, X),
    divide_pair(Auxiliary, E, X),
    enter_parts(Auxiliary, V1, X, V2).
enter_step(divide_edge(End), E, Auxiliary, V1, V2) :-
    (   End == v1
    ->  X = V1
    ;   X = V2
    ),
    divide_pair(Auxiliary, E, X),
    enter(Auxiliary, V1, V2).
enter_step(divide_segment(End), E, Auxiliary, V1, V2) :-
    Auxiliary = auxiliary(_, _, Work, _, _),
    work_edge(Work, E, Start, Finish, _, _),
    (   End == start
    ->  X = Start
    ;   X = Finish
    ),
    enter_parts(Auxiliary, V1, X, V2).

%   2-1: the contained part is dropped.

enter_step(drop, _, _, _, _).

edge_to_divide(crossing).
edge_to_divide(divide_edge(_)).

enter_parts(Auxiliary, V1, X, V2) :-
    Auxiliary = auxiliary(Set, S, _, _, _),
    cut_note(Set, S, V1, V2, X),
    enter_both(Auxiliary, V1, X, V2).

%   In a polygon that is far from flat the points on a piece need not be in
%   line, and then have no order: no end of a part may come back inside it.

enter_both(auxiliary(Set, S, Work, K, P-Ends), V1, X, V2) :-
    (   memberchk(X, [V1,V2|Ends])
    ->  throw(error(geometry_error(polygon_edge(S, P, V1, V2)), _))
    ;   Auxiliary = auxiliary(Set, S, Work, K, P-[V1,V2|Ends]),
        enter(Auxiliary, V1, X),
        enter(Auxiliary, X, V2)
    ).

%   The edges of a cut have the number of its piece as label, below zero; the
%   polygon's own have the number of the edge they are or were part of.

add_pair(auxiliary(_, _, Work, K, _), V1, V2) :-
    Label is -1-K,
    work_add(Work, V1, V2, 1, Label, _),
    work_add(Work, V2, V1, 1, Label, _).

%   divide_pair(+Auxiliary, +E, +X): E, and the opposite edge if it is there
%   too, gets X between its ends.

divide_pair(auxiliary(Set, S, Work, _, _), E, X) :-
    work_edge(Work, E, V1, V2, _, _),
    cut_note(Set, S, V1, V2, X),
    divide_at(Work, E-X),
    findall(Opposite-X, work_edge(Work, Opposite, V2, V1, _, _), Opposites),
    maplist(divide_at(Work), Opposites).

divide_at(Work, E-X) :-
    work_edge(Work, E, V1, V2, Et, Label),
    !,
    work_delete(Work, E),
    work_add(Work, V1, X, Et, Label, _),
    work_add(Work, X, V2, Et, Label, _).

/* - - - the same pieces everywhere - - - */

%   A segment that was divided in one polygon is divided in every other one: in
%   those that are open, and in those beside a real edge that no cut had opened.

agree(Keep, Set, Works0, Works) :-
    cut_agree(Set),
    maplist(agree_polygon(Set), Works0),
    late_polygons(Set, Works0, Polygons),
    call(Keep, Polygons),
    maplist(enter_cuts(Set), Polygons, Late),
    append(Works0, Late, Works).

late_polygons(Set, Works, Polygons) :-
    cut_late_polygons(Set, Polygons0),
    (   Polygons0 == []
    ->  Polygons = []
    ;   sort(Polygons0, Polygons1),
        findall(S-P, member(work(S, P, _), Works), Open0),
        sort(Open0, Open),
        ord_subtract(Polygons1, Open, Polygons)
    ).

agree_polygon(Set, work(S, P, Work)) :-
    cut_divided(Set, Work, S, Divided),
    (   Divided == []
    ->  true
    ;   maplist(agree_at(S, P, Work), Divided),
        agree_polygon(Set, work(S, P, Work))
    ).

%   As in enter_both/4: a part that is there already comes back for ever.

agree_at(S, P, Work, E-X) :-
    work_edge(Work, E, V1, V2, _, Label),
    !,
    (   (   work_edge(Work, _, V1, X, _, Label)
        ;   work_edge(Work, _, X, V2, _, Label)
        )
    ->  throw(error(geometry_error(polygon_edge(S, P, V1, V2)), _))
    ;   divide_at(Work, E-X)
    ).

/* - - - 5.3: straight parts become one - - - */

%   Joints that are straight exactly are merged all at once, before anything
%   enters a polygon; there, lines may cross and be divided again. The others,
%   in polygons flat within the tolerance only, are merged one by one at the
%   end, where the new edge meets nothing.

is_merged(joint(_, Piece1, Piece2)) :-
    merge_line(Piece1, Piece2).

join(Set, joint(Point, _, _)) :-
    cut_join(Set, Point).

merge_near_lines(Set, Works) :-
    cut_joints(Set, near, Joints),
    include(is_merged, Joints, Merged),
    (   Merged == []
    ->  true
    ;   works_by_polygon(Works, ByPolygon),
        maplist(merge_near(Set, ByPolygon), Merged)
    ).

works_by_polygon(Works, ByPolygon) :-
    findall(S-P-Work, member(work(S, P, Work), Works), Pairs),
    list_to_assoc(Pairs, ByPolygon).

merge_near(Set, ByPolygon, joint(Point, piece(S1, P1, S2, P2), _)) :-
    (   get_assoc(S1-P1, ByPolygon, Work1),
        get_assoc(S2-P2, ByPolygon, Work2),
        cut_name(Set, Point, S1, V1),
        cut_name(Set, Point, S2, V2),
        is_free_without(Work1, V1),
        is_free_without(Work2, V2)
    ->  cut_join(Set, Point),
        merge_at(Work1, V1),
        merge_at(Work2, V2)
    ;   true
    ).

%   is_free_without(+Work, +V): the edge that would replace those through V
%   meets no other.

is_free_without(Work, V) :-
    work_edge(Work, _, V1, V, _, _),
    work_edge(Work, _, V, V2, _, _),
    V2 \== V1,
    !,
    \+ ( work_meeting(Work, V1, V2, E, _, _),
         work_edge(Work, E, A, B, _, _),
         A \== V,
         B \== V
       ).

%   The edges through V become one, in each direction that is there.

merge_at(Work, V) :-
    findall(E-V1, work_edge(Work, E, V1, V, _, _), Entering),
    maplist(merge_through(Work, V), Entering).

merge_through(Work, V, E1-V1) :-
    work_edge(Work, E1, V1, V, Et, Label),
    work_edge(Work, E2, V, V2, _, _),
    V2 \== V1,
    !,
    work_delete(Work, E1),
    work_delete(Work, E2),
    work_add(Work, V1, V2, Et, Label, _).
