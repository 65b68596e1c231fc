:- module(sg_development,
          [ develop/2,                  % +S, -D
            develop/3,                  % +S, +Options, -D
            development/2,              % ?S, ?D
            seam_reason/3,              % +D, ?J, -Reason
            join_order/3,               % +S, +E, -Key
            may_join/2,                 % +S, +E
            joined_by_rule/2,           % +S, +Flattening
            with_flattening/3           % +S, +Options, :Goal
          ]).
:- use_module(laid_joint,
              [ joint_edges/4, joint_faces/4, joint_length/3, joint_middle/3,
                joint_kind/3, joint_state/3
              ]).
:- use_module('../near', [longer/2]).
:- use_module('../csg/csg_rows', [drop_boundary/1]).
:- use_module('../decision', [decision/2, decision_is_default/1]).
:- use_module(development_border, [borders_told/2]).
:- use_module(development_record,
              [ record_development/5, recorded_development/4, score/3,
                cannot_develop/2
              ]).
:- use_module(development_search,
              [usual_effort/3, objective_effort/3, exchanged/6, folds/2]).
:- use_module('../kernel',
              [ flattening_open/4, flattening_close/1, flattening_counts/4,
                flattening_bent/2, flattening_invalid/2, flattening_restart/1,
                flattening_lay/2, flattening_measures/2, flattening_bound/2,
                flattening_write/2, edge_joint/3, forbid_joint/2,
                join_faces/3, join_all/2, join_before/3, join_folds/2,
                joint_order/3, joint_path/3, seam_length/2,
                segments_tolerance/3
              ]).
:- use_module(polygon_name, [polygon_name/3]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [ p/3, joint/6, segment/3, assert_fact/1, facts_transaction/1,
                fresh_id/3
              ]).
:- use_module('../polygon/triangulation', [complete_segments/1]).
:- use_module(library(apply), [exclude/3, foldl/4, maplist/2, maplist/3]).
:- use_module(library(error), [existence_error/2, must_be/2]).
:- use_module(library(lists), [append/3, last/2, member/2]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(pairs), [pairs_values/2]).
/** <module> Developments: a segment laid flat, face by face, joined at edges.

Each face lies in a frame of its own (DV-4). Two faces that share an edge are
joined by laying the one with its edge on that of the other. All joints are
tried, in an order; one is taken if its faces are not connected already and
nothing would overlap. What is joined is a piece; a joint that is not taken is a
seam. The order is that of the least seam (DV-6): flat edges first, then the
longest; then folds are exchanged for better ones (development_search.pl). So a
piece never overlaps itself (which DV-8 could not help), and another one begins
where it would.

The pattern is a segment of kind `pattern`, called development(S), flat in z = 0
and seen from outside of S. Its polygons, edges and triangles have the ids that
they have in S; only vertices are new.

@see H.-C. Chae and I.-S. Chung 1989; rows DV-4 to DV-8;
c_kernels/development/flattening.h
*/

:- set_prolog_flag(optimise, true).

:- meta_predicate with_flattening(+, +, 1).

%!  develop(+S, -D) is det.
%!  develop(+S, +Options:list, -D) is det.
%
%   Pattern D is segment S laid flat; what it was before is gone. One
%   transaction. Options:
%
%     - removed(Ps)
%       Polygons that are left out.
%     - root(P)
%       Piece 1 is that of polygon P, which lies unturned: its longest edge goes
%       up from the origin.
%     - cut(Es)
%       Edges that are not joined.
%     - keep(Es)
%       Edges that are joined before all others.
%     - order(Ps)
%       These polygons are laid in this order, each at the first edge, in the
%       order of joints, that it shares with one laid before (DV-7).
%     - minimize(Objective)
%       `seam`, `pieces`, `longest` (the longest weld) or `area` (of the sheet
%       that the pieces lie on): several orders are tried and the best is kept.
%       Default is the order of the least seam alone.
%     - tries(Count)
%       So many orders are tried; default 8.
%     - effort(Millions)
%       How long folds are exchanged for better ones (development_search.pl):
%       about so many million faces may be laid again; 0 is not at all.
%     - strict(Strict)
%       If `true`, polygons that are not flat are an error; default is that
%       their triangles are used, with a warning.
%
%   @error existence_error(segment, S)
%   @error geometry_error(development(S, What)): What is empty, kind(Kind),
%          not_flat(Ps), not_simple(Ps), no_polygon(P), no_joint(E),
%          edge_length(E), overlap(edge(E, Face3, Face4), Face1, Face2) of an
%          edge that is to be kept; a Face is face(P, Name), see polygon_name/3

develop(S, D) :-
    develop(S, [], D).

develop(S, Options, D) :-
    checked_segment(S),
    must_be(list, Options),
    must_be(ground, Options),
    facts_transaction(sg_development:developed(S, Options, D)).

checked_segment(S) :-
    must_be(nonvar, S),
    (   segment(S, Kind, _)
    ->  true
    ;   existence_error(segment, S)
    ),
    (   memberchk(Kind, [solid,surface])
    ->  true
    ;   cannot_develop(S, kind(Kind))
    ),
    (   p(S, _, _)
    ->  true
    ;   cannot_develop(S, empty)
    ).

developed(S, Options, D) :-
    complete_segments([S]),
    with_flattening(S, Options, written(S, Options, D)).

written(S, Options, D, Flattening) :-
    all_valid(S, Flattening),
    flat_or_warned(S, Options, Flattening),
    borders_told(S, Flattening),
    option(root(Root), Options, 0),
    best_laid(S, Options, Root, Flattening, Order, Measures),
    stage(join, flattening_bound(Flattening, Bound)),
    pattern_segment(S, D),
    stage(write, flattening_write(Flattening, D)),
    record_development(D, S, Options, Order, Measures-Bound).

all_valid(S, Flattening) :-
    flattening_invalid(Flattening, Ps),
    (   Ps == []
    ->  true
    ;   cannot_develop(S, not_simple(Ps))
    ).

flat_or_warned(S, Options, Flattening) :-
    flattening_bent(Flattening, Ps),
    (   Ps == []
    ->  true
    ;   option(strict(true), Options, false)
    ->  cannot_develop(S, not_flat(Ps))
    ;   print_message(warning, sanggwan(development(S, in_triangles(Ps))))
    ).

%!  development(?S, ?D) is nondet.
%
%   True when D is the pattern of segment S.

development(S, D) :-
    segment(D, pattern, development(S)).

pattern_segment(S, D) :-
    (   development(S, D0)
    ->  D = D0,
        drop_boundary(D)
    ;   fresh_id(segment, 0, D),
        assert_fact(segment(D, pattern, development(S)))
    ).

%!  with_flattening(+S, +Options:list, :Goal) is semidet.
%
%   Call Goal, once, with a handle on segment S being laid flat: see
%   flattening_open/4. What is to be cut is forbidden already.
%
%   @error as develop/3

with_flattening(S, Options, Goal) :-
    segments_tolerance([S], Tolerance, _),
    option(removed(Removed), Options, []),
    option(root(Root), Options, 0),
    maplist(has_polygon(S), Removed),
    (   Root == 0
    ->  true
    ;   has_polygon(S, Root)
    ),
    opened(S, Tolerance, Removed, Flattening),
    call_cleanup(( edges_cut(S, Flattening, Options),
                   once(call(Goal, Flattening))
                 ),
                 flattening_close(Flattening)).

opened(S, Tolerance, Removed, Flattening) :-
    catch(stage(join, flattening_open(S, Tolerance, Removed, Flattening)),
          error(representation_error(int32), _),
          cannot_develop(S, no_numbers)).

has_polygon(S, P) :-
    (   p(S, P, _)
    ->  true
    ;   cannot_develop(S, no_polygon(P))
    ).

/* - - - joining - - - */

%   best_laid(S, Options, Root, Flattening, Order, Measures): of all plans that
%   one stays laid which meets the objective best.

best_laid(S, Options, Root, Flattening, Order, Measures) :-
    plans(Flattening, Options, Objective, Plans0),
    maplist(tried(S, Options, Root, Flattening, Objective), Plans0, Tried0),
    findall(plan(Order0, Objective, 0),
            member(tried(_, plan(Order0, _, _), _, _, deceived), Tried0),
            Plans1),
    maplist(tried(S, Options, Root, Flattening, Objective), Plans1, Tried1),
    append(Tried0, Tried1, Tried),
    sort(Tried, [tried(_, Best, Order, Measures, _)|_]),
    (   last(Tried, tried(_, Best, _, _, _))
    ->  true
    ;   laid(S, Options, Root, Flattening, Best, _)
    ).

%   tried(S, Options, Root, Flattening, Objective, Plan, Tried): Tried is
%   tried(Score, Plan, Exchanged, Measures, How). How is `deceived` if sides
%   that seemed to lie on each other when folds were exchanged do not quite, so
%   that the seam is longer than it should have become; else `true`.

tried(S, Options, Root, Flattening, Objective, Plan,
      tried(Score, Plan, Exchanged, Measures, How)) :-
    laid(S, Options, Root, Flattening, Plan, Exchanged),
    stage(join, flattening_measures(Flattening, Measures)),
    score(Objective, Measures, Score),
    (   Exchanged = exchanged(_),
        arg(1, Measures, Seam),
        seam_length(Flattening, Hoped),
        longer(Seam, Hoped)
    ->  How = deceived
    ;   How = true
    ).

%   laid(S, Options, Root, Flattening, Plan, Exchanged): Exchanged is the order
%   of the Plan, or exchanged(Order) if folds were exchanged.

laid(S, Options, Root, Flattening, plan(Order, Objective, Effort),
     Exchanged) :-
    flattening_restart(Flattening),
    wishes_joined(S, Flattening, Options),
    kept_folds(Options, Flattening, Kept),
    stage(rules, all_joined(S, Flattening, Order)),
    (   decision_is_default(join_order/3)
    ->  exchanged(Flattening, Order, Kept, Objective, Effort, Exchanges)
    ;   Exchanges = 0
    ),
    (   Exchanges =:= 0
    ->  Exchanged = Order
    ;   Exchanged = exchanged(Order)
    ),
    stage(join, flattening_lay(Flattening, Root)).

%   kept_folds(Options, Flattening, Kept): what is joined because it was wanted.

kept_folds(Options, Flattening, Kept) :-
    (   member(Option, Options),
        functor(Option, Name, 1),
        memberchk(Name, [keep,order]),
        \+ arg(1, Option, [])
    ->  folds(Flattening, Kept)
    ;   Kept = []
    ).

%   plans(Flattening, Options, Objective, Plans): Plans are plan(Order, For,
%   Effort): joined in this order, then folds exchanged For an objective. What
%   is done without an objective is always among them, so no objective makes it
%   worse.

plans(Flattening, Options, Objective, Plans) :-
    usual_effort(Flattening, Options, Usual),
    (   option(minimize(Objective0), Options),
        decision_is_default(join_order/3)
    ->  Objective = Objective0,
        option(tries(Count), Options, 8),
        must_be(positive_integer, Count),
        objective_effort(Options, Count, Effort),
        Last is Count-1,
        findall(plan(Order, Objective, Effort), between(0, Last, Order),
                Plans1),
        Plans = [plan(0, seam, Usual)|Plans1]
    ;   Objective = seam,
        Plans = [plan(0, seam, Usual)]
    ).

all_joined(S, Flattening, Order) :-
    (   by_kernel
    ->  stage(join, join_all(Flattening, Order))
    ;   joined_by_rule(S, Flattening)
    ).

by_kernel :-
    decision_is_default(join_order/3),
    decision_is_default(may_join/2).

%!  joined_by_rule(+S, +Flattening) is det.
%
%   Joins the faces of segment S: what join_all/2 does, joint by joint,
%   following join_order/3 and may_join/2.

joined_by_rule(S, Flattening) :-
    joints_to_try(S, Flattening, Js),
    forall(member(J, Js), join_faces(Flattening, J, _)).

%!  joints_to_try(+S, +Flattening, -Js:list) is det.
%
%   Js are the joints that are open and may be joined, in the order in which
%   joined_by_rule/2 tries them. Those that may not be are forbidden.

joints_to_try(S, Flattening, Js) :-
    flattening_counts(Flattening, _, Count, _),
    findall(Key-J,
            ( between(1, Count, J), joint_to_try(S, Flattening, J, Key) ),
            Keyed),
    msort(Keyed, Sorted),
    pairs_values(Sorted, Js).

joint_to_try(S, Flattening, J, Key) :-
    joint_state(Flattening, J, open),
    \+ joint_kind(Flattening, J, line),
    joint_edges(Flattening, J, E, _),
    b_setval(sg_flattening, Flattening),
    (   may_join(S, E)
    ->  join_order(S, E, Key)
    ;   forbid_joint(Flattening, J),
        fail
    ).

%!  joint_key(+S, +Flattening, +J, -Key) is semidet.
%
%   Key is that of joint J by join_order/3, if it may be joined.

joint_key(S, Flattening, J, Key) :-
    joint_edges(Flattening, J, E, _),
    b_setval(sg_flattening, Flattening),
    may_join(S, E),
    join_order(S, E, Key).

:- decision(may_join/2, "Which edges of a development may be joined").

%!  may_join(+S, +E) is semidet.
%
%   True when the two faces at edge E of segment S may be joined in its
%   development. They always may. A decision: a world can keep seams where
%   they should be.

may_join(_, _).

:- decision(join_order/3,
            "In which order the edges of a development are joined (DV-6)").

%!  join_order(+S, +E, -Key) is det.
%
%   Key says when edge E of segment S is joined in its development: the first in
%   the standard order of terms is tried first. Of two partners E is that with
%   the smaller id. Flat edges come first, then the longest; equal ones by where
%   they are: the highest, then the largest y and x. To be asked while S is
%   developed.

join_order(_, E, key(Rank,Length,Z,Y,X)) :-
    b_getval(sg_flattening, Flattening),
    edge_joint(Flattening, E, J),
    joint_length(Flattening, J, Length0),
    joint_middle(Flattening, J, p(X0,Y0,Z0)),
    joint_kind(Flattening, J, Kind),
    flattening_counts(Flattening, _, _, Step),
    (   Kind == flat
    ->  Rank = 0
    ;   Rank = 1
    ),
    Length is -round(Length0/Step),
    X is -round(X0/Step),
    Y is -round(Y0/Step),
    Z is -round(Z0/Step).

/* - - - wishes (DV-7) - - - */

edges_cut(S, Flattening, Options) :-
    option(cut(Es), Options, []),
    maplist(edge_cut(S, Flattening), Es).

edge_cut(S, Flattening, E) :-
    joint_at(S, Flattening, E, J),
    forbid_joint(Flattening, J).

%   wishes_joined(S, Flattening, Options): what is to be joined before all else.

wishes_joined(S, Flattening, Options) :-
    option(keep(Es), Options, []),
    maplist(edge_kept(S, Flattening), Es),
    option(order(Ps), Options, []),
    maplist(has_polygon(S), Ps),
    foldl(polygon_laid(S, Flattening), Ps, [], _).

edge_kept(S, Flattening, E) :-
    joint_at(S, Flattening, E, J),
    join_faces(Flattening, J, Result),
    (   Result = overlap(P1, P2)
    ->  joint_faces(Flattening, J, P3, P4),
        maplist(named_face(S), [P1,P2,P3,P4], [F1,F2,F3,F4]),
        cannot_develop(S, overlap(edge(E, F3, F4), F1, F2))
    ;   Result == short
    ->  cannot_develop(S, edge_length(E))
    ;   true
    ).

named_face(S, P, face(P, Name)) :-
    polygon_name(S, P, Name).

joint_at(S, Flattening, E, J) :-
    (   edge_joint(Flattening, E, J)
    ->  true
    ;   cannot_develop(S, no_joint(E))
    ).

%   polygon_laid(S, Flattening, P, Laid0, Laid): P is joined to one of the
%   polygons Laid0, if it can be.

polygon_laid(S, Flattening, P, Laid, [P|Laid]) :-
    p(S, P, Es),
    findall(Key-J,
            ( member(E, Es),
              edge_joint(Flattening, E, J),
              joint_faces(Flattening, J, P1, P2),
              other(P, P1, P2, Other),
              memberchk(Other, Laid),
              joint_key(S, Flattening, J, Key)
            ),
            Keyed),
    msort(Keyed, Sorted),
    (   member(_-J, Sorted),
        join_faces(Flattening, J, joined)
    ->  true
    ;   true
    ).

other(P, P, Other, Other) :-
    !.
other(P, Other, P, Other).

/* - - - why an edge is a seam - - - */

%!  seam_reason(+D, ?J, -Reason) is nondet.
%
%   True when joint J of pattern D is a seam, for this Reason, found by joining
%   again up to J:
%
%     - cycle(Js)
%       Its faces hung together already, by the joints Js, in order from one to
%       the other.
%     - overlap(P1, P2)
%       Joined, it would have laid polygon P2 on P1.
%     - exchange(Js, J2, P1, P2)
%       Its faces are connected by the joints Js, of which J2 comes after it in
%       the order. With J2 cut instead, polygon P2 would lie on P1.
%     - cut_by_wish
%       It was to be cut.
%     - forbidden
%       may_join/2 is not true of it.
%     - short
%       The edge is too short to hold what would hang on it, or has no length.
%     - chosen(Js)
%       Its faces are connected by the joints Js, one of which could be cut
%       instead, for a shorter seam: it was to be cut, or no effort was left.
%     - free
%       Nothing is against it, in a pattern of which only the rows are known: it
%       was to be cut, or a rule was against it.
%
%   @error existence_error(development, D): it is no pattern, or its segment has
%          changed since

seam_reason(D, J, Reason) :-
    recorded_development(D, S, Options, Order),
    joint(D, J, E, _, seam, _),
    with_flattening(S, Options,
                    joint_reason(D, S, Options, Order, J, E, Reason)).

joint_reason(D, S, Options, Order, J, E, Reason, Flattening) :-
    joint_edges(Flattening, J, E, _),
    joint_state(Flattening, J, State),
    (   Order == given
    ->  pattern_folds(D, Folds),
        given_reason(Folds, Flattening, J, Reason)
    ;   State == forbidden
    ->  Reason = cut_by_wish
    ;   Order = exchanged(Order0)
    ->  pattern_folds(D, Folds),
        reason_among(Folds, Flattening, Order0, J, Reason)
    ;   wishes_joined(S, Flattening, Options),
        joined_before(S, Flattening, Order, J),
        join_faces(Flattening, J, Result),
        result_reason(Result, Flattening, J, Reason)
    ).

%   given_reason(Folds, Flattening, J, Reason): what could be joined is
%   forbidden in it (given_development/3).

given_reason(Folds, Flattening, J, Reason) :-
    (   joint_state(Flattening, J, forbidden)
    ->  Reason = free
    ;   reason_among(Folds, Flattening, 0, J, Reason)
    ).

pattern_folds(D, Folds) :-
    findall(J, joint(D, J, _, _, fold, _), Folds).

%   reason_among(Folds, Flattening, Order, J, Reason): why J is a seam where
%   Folds are joined.

reason_among(Folds, Flattening, Order, J, Reason) :-
    join_folds(Flattening, Folds),
    join_faces(Flattening, J, Result),
    (   Result == same_piece
    ->  joint_path(Flattening, J, Way),
        way_reason(Way, Folds, Flattening, Order, J, Reason)
    ;   result_reason(Result, Flattening, J, Reason)
    ).

%   A fold on the way that comes after J would have been given up for it, but
%   for what would overlap then.

way_reason(Way, Folds, Flattening, Order, J, Reason) :-
    (   parted(Way, Folds, Flattening, Order, J, [Last|_], Result),
        exchange_reason(Result, Flattening, Way, J, Last, Reason0)
    ->  Reason = Reason0
    ;   Reason = cycle(Way)
    ).

%   parted(Way, Folds, Flattening, Order, J, Lasts, Result): with the folds
%   Lasts cut the faces of J are not connected, and joining J has this
%   Result. There are several ways where faces close all round a flat vertex.

parted(Way, Folds0, Flattening, Order, J, [Last|Lasts], Result) :-
    last_after(Flattening, Order, J, Way, Last),
    exclude(==(Last), Folds0, Folds),
    join_folds(Flattening, Folds),
    join_faces(Flattening, J, Result0),
    (   Result0 == same_piece
    ->  joint_path(Flattening, J, Way1),
        parted(Way1, Folds, Flattening, Order, J, Lasts, Result)
    ;   Lasts = [],
        Result = Result0
    ).

exchange_reason(overlap(P1,P2), _, Way, _, Last, exchange(Way, Last, P1, P2)).
exchange_reason(joined, Flattening, Way, J, Last, chosen(Way)) :-
    joint_length(Flattening, J, Length),
    joint_length(Flattening, Last, Shorter),
    flattening_counts(Flattening, _, _, Step),
    Length-Shorter > Step.

last_after(Flattening, Order, J, Way, Last) :-
    joint_order(Flattening, Order, Js),
    append(_, [J|After0], Js),
    !,
    findall(Fold, ( member(Fold, After0), memberchk(Fold, Way) ), After),
    last(After, Last).

joined_before(S, Flattening, Order, J) :-
    (   by_kernel
    ->  join_before(Flattening, Order, J)
    ;   joints_to_try(S, Flattening, Js),
        (   member(J0, Js),
            (   J0 == J
            ->  true
            ;   join_faces(Flattening, J0, _),
                fail
            )
        ->  true
        ;   true
        )
    ).

result_reason(same_piece, Flattening, J, cycle(Js)) :-
    joint_path(Flattening, J, Js).
result_reason(overlap(P1,P2), _, _, overlap(P1,P2)).
result_reason(forbidden, _, _, forbidden).
result_reason(short, _, _, short).
