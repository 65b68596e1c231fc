:- module(sg_joints,
          [ merge_line/2,               % +Piece1, +Piece2
            merge_joints/2,             % +Set, +How
            merge_near_lines/2,         % +Set, +Works
            has_near_lines/1            % +Set
          ]).
:- use_module('../decision', [decision/2]).
:- use_module('../kernel',
              [cut_joints/3, cut_join/2, cut_merge_near/3, cut_settle/1]).
:- use_module('../stage', [stage/2]).
:- use_module(library(apply), [include/3, maplist/2]).
/** <module> Joints: straight parts of a penetration line become one.

A joint is a point in which just two pieces of a line meet, in line, and nothing
else does.

@see [PL] section 5.3; row PL-9 of the requirements
*/

:- decision(merge_line/2,
            "Which collinear pieces of a line become one (PL-9)").

%!  merge_line(+Piece1, +Piece2) is semidet.
%
%   Decision: two pieces become one. A piece is
%   piece(S1, Polygon1, S2, Polygon2); the two meet in a vertex where no other
%   edge is, and are in line. The default: those of the same two polygons.

merge_line(Piece, Piece).

/* - - - straight exactly - - - */

%!  merge_joints(+Set, +How) is det.
%
%   Joints of the cut set Set that are straight vanish, as merge_line/2 decides:
%   How is `straight`, exactly, or `near`, as far as polygons are flat.

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

/* - - - nearly straight - - - */

%   Joints that are straight exactly are merged all at once, before anything
%   enters a polygon; there, lines may cross and be divided again. The others,
%   in polygons flat within the tolerance only, are merged one by one at the
%   end, where the new edge meets nothing.

is_merged(joint(_, Piece1, Piece2)) :-
    merge_line(Piece1, Piece2).

join(Set, joint(Point, _, _)) :-
    cut_join(Set, Point).

%!  merge_near_lines(+Set, +Works:list) is det.
%
%   Joints that are nearly straight vanish from the polygons of Works, a list of
%   work(S, P, Work).

merge_near_lines(Set, Works) :-
    near_joints(Set, Merged),
    (   Merged == []
    ->  true
    ;   cut_merge_near(Set, Merged, Works)
    ).

near_joints(Set, Merged) :-
    cut_joints(Set, near, Joints),
    include(is_merged, Joints, Merged).

%!  has_near_lines(+Set) is semidet.
%
%   True when merge_near_lines/2 may have something to do.

has_near_lines(Set) :-
    near_joints(Set, [_|_]).
