:- module(sg_development,
          [ develop/2,                  % +S, -D
            develop/3,                  % +S, +Options, -D
            development/2,              % ?S, ?D
            join_order/3,               % +S, +E, -Key
            may_join/2,                 % +S, +E
            joined_by_rule/2            % +S, +Flattening
          ]).
:- use_module(csg_rows, [drop_boundary/1]).
:- use_module(decision, [decision/2, decision_is_default/1]).
:- use_module(kernel,
              [ flattening_open/4, flattening_close/1, flattening_counts/4,
                flattening_bent/2, flattening_joint/3, flattening_write/3,
                edge_joint/3, forbid_joint/2, join_faces/3, join_all/1,
                segments_tolerance/3
              ]).
:- use_module(stage, [stage/2]).
:- use_module(store,
              [ p/3, segment/3, assert_fact/1, retractall_facts/1,
                facts_transaction/1, fresh_id/3
              ]).
:- use_module(triangulation, [complete_segments/1]).
:- autoload(library(apply), [maplist/2]).
:- autoload(library(error), [existence_error/2]).
:- autoload(library(lists), [last/2, member/2]).
:- autoload(library(option), [option/3]).
/** <module> Developments: a segment laid flat, face by face, joined at edges.

Each face lies in a frame of its own (DV-4). Two faces that share an edge are
joined by laying the one with its edge on that of the other. All joints are
tried, in an order; one is taken if its faces do not hang together already and
nothing would overlap. What is joined is a piece; a joint that is not taken is a
seam. The order is that of the least seam (DV-6): flat edges first, then the
longest. So a piece never overlaps itself (which DV-8 could not help), and
another one begins where it would.

The pattern is a segment of kind `pattern`, called development(S), flat in z = 0
and seen from outside of S. Its polygons, edges and triangles have the ids that
they have in S; only vertices are new.

@see H.-C. Chae and I.-S. Chung 1989; rows DV-4 to DV-8; c_kernels/flattening.h
*/

:- set_prolog_flag(optimise, true).

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
%     - strict(Strict)
%       If `true`, polygons that are not flat are an error; default is that
%       their triangles are used, with a warning.
%
%   @error existence_error(segment, S)
%   @error geometry_error(development(S, What)): What is empty, kind(Kind),
%          not_flat(Ps), overlap(E, P1, P2) (of an edge that is to be kept),
%          no_joint(E), edge_length(E)

develop(S, D) :-
    develop(S, [], D).

develop(S, Options, D) :-
    checked_segment(S),
    facts_transaction(sg_development:developed(S, Options, D)).

checked_segment(S) :-
    (   segment(S, Kind, _)
    ->  true
    ;   existence_error(segment, S)
    ),
    (   memberchk(Kind, [solid,surface])
    ->  true
    ;   cannot(S, kind(Kind))
    ),
    (   p(S, _, _)
    ->  true
    ;   cannot(S, empty)
    ).

cannot(S, What) :-
    throw(error(geometry_error(development(S, What)), _)).

developed(S, Options, D) :-
    complete_segments([S]),
    segments_tolerance([S], Tolerance, _),
    option(removed(Removed), Options, []),
    option(root(Root), Options, 0),
    setup_call_cleanup(
        flattening_open(S, Tolerance, Removed, Flattening),
        ( joined(S, Options, Flattening),
          pattern_segment(S, D),
          stage(write, flattening_write(Flattening, Root, D))
        ),
        flattening_close(Flattening)).

%!  development(?S, ?D) is nondet.
%
%   True when D is the pattern of segment S.

development(S, D) :-
    segment(D, pattern, development(S)).

pattern_segment(S, D) :-
    (   development(S, D0)
    ->  D = D0,
        drop_boundary(D),
        retractall_facts(joint(D, _, _, _, _, _)),
        retractall_facts(piece(D, _, _))
    ;   fresh_id(segment, 0, D),
        assert_fact(segment(D, pattern, development(S)))
    ).

/* - - - joining - - - */

joined(S, Options, Flattening) :-
    flat_or_warned(S, Options, Flattening),
    option(cut(Cut), Options, []),
    option(keep(Kept), Options, []),
    maplist(edge_cut(S, Flattening), Cut),
    maplist(edge_kept(S, Flattening), Kept),
    stage(rules, all_joined(S, Flattening)).

flat_or_warned(S, Options, Flattening) :-
    flattening_bent(Flattening, Ps),
    (   Ps == []
    ->  true
    ;   option(strict(true), Options, false)
    ->  cannot(S, not_flat(Ps))
    ;   print_message(warning, sanggwan(development(S, in_triangles(Ps))))
    ).

edge_cut(S, Flattening, E) :-
    joint_of(S, Flattening, E, J),
    forbid_joint(Flattening, J).

edge_kept(S, Flattening, E) :-
    joint_of(S, Flattening, E, J),
    join_faces(Flattening, J, Result),
    (   Result = overlap(P1, P2)
    ->  cannot(S, overlap(E, P1, P2))
    ;   Result == point
    ->  cannot(S, edge_length(E))
    ;   true
    ).

joint_of(S, Flattening, E, J) :-
    (   edge_joint(Flattening, E, J)
    ->  true
    ;   cannot(S, no_joint(E))
    ).

all_joined(S, Flattening) :-
    (   decision_is_default(join_order/3),
        decision_is_default(may_join/2)
    ->  stage(join, join_all(Flattening))
    ;   joined_by_rule(S, Flattening)
    ).

%!  joined_by_rule(+S, +Flattening) is det.
%
%   Joins the faces of segment S: what join_all/1 does, joint by joint, following
%   join_order/3 and may_join/2.

joined_by_rule(S, Flattening) :-
    b_setval(sg_flattening, Flattening),
    flattening_counts(Flattening, _, Count, _),
    findall(Key-J, joint_to_try(S, Flattening, Count, Key, J), Keyed),
    msort(Keyed, Sorted),
    forall(member(_-J, Sorted), join_faces(Flattening, J, _)).

joint_to_try(S, Flattening, Count, Key, J) :-
    between(1, Count, J),
    flattening_joint(Flattening, J, joint(E,_,_,_,_,_,_,Kind,open)),
    Kind \== line,
    (   may_join(S, E)
    ->  join_order(S, E, Key)
    ;   forbid_joint(Flattening, J),
        fail
    ).

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
    flattening_joint(Flattening, J, joint(_,_,_,_,Length0,p(X0,Y0,Z0),_,Kind,_)),
    flattening_counts(Flattening, _, _, Step),
    (   Kind == flat
    ->  Rank = 0
    ;   Rank = 1
    ),
    Length is -round(Length0/Step),
    X is -round(X0/Step),
    Y is -round(Y0/Step),
    Z is -round(Z0/Step).
