:- module(sg_kernel_penetration, []).
:- sg_kernel:export_doors.

/** <module> Cut sets: what segments have in common, and what polygons become.

Foreign predicates; see kernel.pl.
*/

/* - - - cut_rows.c - - - */

%!  cut_set_open(+Pairs:list(id_pair), -Set:cut_set) is det.
%
%   Set is a new cut set for the segments S1-S2 in the list Pairs, as they are
%   now. Each has a tree of boxes round its triangles or, without triangles
%   (a curve), round its edges; trees are kept with the world until their
%   segment has changed. Nothing else is read yet.

%!  cut_set_close(+Set:cut_set) is det.
%
%   Frees what Set holds. Any later use is an existence_error(cut_set, Set);
%   the garbage collector closes what is forgotten.

%!  cut_candidate(+Set:cut_set, -T1:count, -T2:count) is nondet.
%
%   Triangles T1 and T2 of two segments that are to cut each other, T1 of the
%   smaller number, have overlapping boxes. Each pair once; the order depends
%   on the model only. All pairs of segments are joined at the first call; it
%   gives the triangles their handles, 0, 1, ...

%!  curve_candidate(+Set:cut_set, -E:count, -T:count) is nondet.
%
%   The same for a curve's edge E and a triangle T.

%!  cut_side(+Set:cut_set, +T1:count, +T2:count, -Side:int) is det.
%
%   Side is 1 if triangle T1 lies wholly above the plane of T2 (its outside),
%   -1 if wholly below, 0 if it touches or crosses it. Exact.

%!  cut_enter(+Set:cut_set, +T1:count, +T2:count, -Count:int) is det.
%
%   What T1 and T2 have in common goes into Set: Count pieces of positive
%   length. In a common plane only borders of faces count: real edges that are
%   not inside one, no chords. Exact, except what cut_flat_within/2 allows.

%!  cut_without_coincident(+Set:cut_set) is det.
%
%   From now on cut_find/1 leaves out what lies inside where two segments have
%   the same triangles (c_kernels/penetration/cut_coincident.h): nothing changes
%   there from one triangle to the next. A Boolean says so, which asks for each
%   component of a segment on which sides of the others it is.

%!  cut_few_sheets(+Set:cut_set) is det.
%
%   From now on, where more than eight sheets of a segment that is cut by
%   itself have an edge in one place, or many triangles a vertex, and no more in
%   common, not each two of them are candidates: each is with a few, so that all
%   are connected (c_kernels/join/self_sheet.h). It is enough for a picture. Say
%   it before the first candidate is asked for.

%!  cut_find(+Set:cut_set) is det.
%
%   As cut_enter/4 for every cut_candidate/3 of Set whose triangles are on both
%   sides of each other's planes, in that order: the whole join at once.

%!  curve_enter(+Set:cut_set, +E:count, +T:count, -Count:int) is det.
%
%   The points inside curve edge E in which it meets T go into Set. Exact.
%   @see PL-7

%!  cut_triangle(+Set:cut_set, +T:count, -S:id, -P:id, -Id:id) is det.
%
%   Triangle T is t(S, P, Id, ...).

%!  cut_ends(+Set:cut_set, +T1:count, +T2:count, -Cuts:list(triangle_cut))
%!           is det.
%
%   Cuts is the list of cut(Kind, End1, End2) that T1 and T2 have in common, as
%   in tests/oracle/cut.pl, triangle_cut/5. Exact; changes nothing.

/* - - - cut_fold_rows.c - - - */

%!  cut_flat_within(+Set:cut_set, +Tolerance:number) is det.
%
%   Polygons whose vertices are no farther off their planes than four times
%   Tolerance, or the tolerance of the model as it is now, have no folds in Set.
%   Say it before the first cut is found. Of others the chords between triangles
%   divide lines, as real edges do: the polygon keeps its shape. Neighbours that
%   are no farther off one plane are one face.

%!  cut_of_faces(+Set:cut_set) is det.
%
%   From now on lines of Set are of faces, not of polygons: an edge inside a
%   face counts as a chord. A Boolean does not say so: it needs all edges of
%   what was made to touch, and makes faces of what it chose.

/* - - - resolve_rows.c - - - */

%!  cut_own_tolerances(+Set:cut_set) is det.
%
%   From now on two segments of Set reach no farther than the source of the
%   coarser one says (docs/precision.md), whatever Reach is asked for.

%!  cut_resolve(+Set:cut_set, +Reach:number, -What:resolution,
%!              -Vertices:list(vertex_fact), -Polygons:list(resolved_fact))
%!      is det.
%
%   What must change in the segments of Set so that all that is within Reach
%   (model units, positive) touches: Vertices that move or are new, as
%   vertex(S, V, X, Y, Z, Origin), and Polygons as polygon(S, P, Edges,
%   Triangles), Edges a list of w(V1, V2, Et, E), a part of edge E, or a seam
%   if E is 0, and Triangles of t(V1, V2, V3). Both are empty unless What is
%   `changed`. It is `same` if nothing touches but exactly; wide(S, V) if it
%   cannot be done, since vertex V is connected with others over more than
%   three times Reach; or stuck(S, P) if polygon P cannot be triangulated so.
%   Changes nothing.
%   @see resolve.h

%!  cut_touch(+Set:cut_set, +Reach:number, -What:resolution,
%!            -Moves:touch_moves) is det.
%
%   Does what cut_resolve/4 says, as tests/oracle/resolve.pl
%   would: What is `changed`. It is `same` if there is nothing to do, else
%   wide(S, V) or stuck(S, P), and nothing was done. After an exception some of
%   it may be: call it in a transaction.
%
%   Moves says how far things move:
%
%     - little
%       no farther than doubles are rounded
%     - move(moved, S1-S2, p(X, Y, Z), Move, 0.0, N)
%       there are N places, and that at X, Y, Z, where S1 and S2 (0: none)
%       touch, moves farthest
%     - move(tight, S1-S2, p(X, Y, Z), Move, Feature, N)
%       at N places it is more than a hundredth of the smallest feature near
%       there: an edge, a wall or a gap of one segment. X, Y, Z is the worst.
%   @see resolve_feature.h

/* - - - seam_rows.c - - - */

%!  cut_seal(+Set:cut_set) is det.
%
%   When all cuts are entered: orders the points on each real edge, divides
%   the cuts that run along it, and makes equal cuts one piece. The pieces have
%   numbers K, 0, 1, ...

%!  cut_polygons(+Set:cut_set, -Polygons:list(segment_polygon)) is det.
%
%   Polygons is the list of S-P, ascending, of all polygons that pieces enter
%   or whose edges are split. The first call also names every point in its
%   segments.

%!  cut_polygons_of(+Set:cut_set, +Segments:list(id),
%!                  -Polygons:list(segment_polygon)) is det.
%
%   The same, of those that are of Segments, or carry a piece of one.

%!  cut_entering(+Set:cut_set, +S:id, +P:id, -Pieces:list(entering_piece))
%!               is det.
%
%   Pieces is the list of piece(K, V1, V2) that run through the face of polygon
%   P of S, in the order of K; V1 and V2 are vertices of S, many of them new.

%!  cut_was_divided(+Set:cut_set) is semidet.
%
%   True when an edge or a piece was divided while others were entered.

%!  cut_agree(+Set:cut_set) is det.
%
%   Divides the pieces at all points noted, and the real edges they run along.

%!  cut_late_polygons(+Set:cut_set, -Polygons:list(segment_polygon)) is det.
%
%   Polygons is the list of S-P, in no order, maybe repeated, that have a real
%   edge which cut_agree/1 divided.

/* - - - cut_enter_rows.c - - - */

%!  cut_enter_free(+Set:cut_set, +S:id, +P:id, +Work:work) is semidet.
%
%   Enters all pieces of polygon P of S into Work, as enter_by_rule/4 of
%   entering.pl does, if they meet nothing but in shared vertices, which is
%   commonest. Else fails, with Work as it was.

%!  cut_queue(+Set:cut_set, +Polygons:list(segment_polygon)) is det.
%
%   Polygons S-P are those that cut_enter_queued/2 enters, in this order.

%!  cut_enter_queued(+Set:cut_set, -Works:list(work)) is det.
%
%   Works are as of cut_work/4 with all pieces entered, for the polygons in the
%   queue up to the first for which cut_enter_free/4 does not hold. That one is
%   left out; the next call goes on behind it.

%!  cut_work(+Set:cut_set, +S:id, +P:id, -Work:work) is det.
%
%   Work is a new scratch relation (work_rows.c) with the edges of polygon P,
%   labelled with their numbers, divided at the points of cuts on them; it
%   also knows the vertices of cut_entering/4.
%
%   @error existence_error(polygon, P)

/* - - - split_rows.c - - - */

%!  cut_crossing(+Set:cut_set, +Work:work, +S:int, +K:int, +E:int, +V1:id,
%!               +V2:id, -X:id) is det.
%
%   X is the vertex, known or new, in which V1-V2, a part of piece K, crosses
%   edge E of Work, a scratch relation of segment S. Exact.

%!  cut_note(+Set:cut_set, +S:id, +V1:id, +V2:id, +X:id) is det.
%
%   Remembers that vertex X lies between V1 and V2.

%!  cut_between(+Set:cut_set, +Work:work, +S:id, +V1:id, +V2:id, -X:id)
%!              is semidet.
%
%   X was noted between V1 and V2, maybe in another segment; it is a vertex of
%   S (and of Work) now.

%!  cut_divided(+Set:cut_set, +Work:work, +S:id, -Divided:list(id_pair))
%!              is det.
%
%   Divided is the list of E-X: vertex X was noted between the ends of edge E
%   of Work, a scratch relation of segment S; it is a vertex of both now.

/* - - - line_rows.c - - - */

%!  cut_joints(+Set:cut_set, +How:joint_how, -Joints:list(piece_joint))
%!             is det.
%
%   Joints is the list of joint(Point, Piece1, Piece2): exactly two pieces end
%   in Point, they are in line, and no other real edge is there. How is
%   `straight` for those on one line exactly, `near` for those that are only
%   within the tolerance to which their polygons are flat. A piece is
%   piece(S1, P1, S2, P2). To be asked after cut_seal/1 or cut_agree/1.

%!  cut_join(+Set:cut_set, +Point:count) is det.
%
%   Makes one piece of the two at a joint.
%
%   @error domain_error(joint, Point)

%!  cut_merge_near(+Set:cut_set, +Joints:list(piece_joint),
%!                 +Works:list(entered_polygon)) is det.
%
%   Joints of cut_joints/3 that are nearly straight, one by one, become one
%   piece, and one edge pair in the polygons of Works (work(S, P, Work)): where
%   that meets no other edge of both polygons.
%
%   @error domain_error(joint, Joints)

%!  cut_settle(+Set:cut_set) is det.
%
%   After joints and before cut_polygons/2: forgets the points that were joined
%   away; K is numbered anew.

%!  cut_name(+Set:cut_set, +Point:count, +S:id, -V:id) is semidet.
%
%   Point is vertex V of segment S.

%!  cut_lines(+Set:cut_set, -Lines:list(line_fact)) is det.
%
%   Lines is the list of the line/9 rows that the pieces are, numbered on from
%   those of the world.

%!  cut_line(+Set:cut_set, +S:id, +V1:id, +V2:id, -L:id) is semidet.
%
%   L is the first line between vertices V1 and V2 of S, after cut_lines/2.

%!  cut_vertices(+Set:cut_set, -Vertices:list(vertex_fact)) is det.
%
%   Vertices is the list of vertex(S, V, X, Y, Z, Origin) that are new.

%!  cut_write_lines(+Set:cut_set) is det.
%
%   Adds to the current world v/5 and origin/3 of cut_vertices/2, and line/9 of
%   cut_lines/2.

%!  cut_split_edges(+Set:cut_set, +S:id, -Splits:list(edge_split)) is det.
%
%   Splits is the list of split(V1, V2, Vs): edges of S and the vertices on
%   them, in order from V1 to V2.

/* - - - chain_rows.c - - - */

%!  cut_chains(+Set:cut_set, -Chains:list(piece_chain)) is det.
%
%   Chains is the list of chain(S1, S2, Kind, Points, Polygons), as in
%   penetration.pl, penetration_chains/2, of the pieces that Set has now.

%!  line_chains(-Chains:list(line_chain)) is det.
%
%   Chains are those of chains/1; the rule is tests/oracle/chain.pl.

/* - - - cut_write_rows.c - - - */

%!  cut_write(+Set:cut_set, +Works:list(entered_polygon), -N:count) is det.
%
%   As cut_rows.pl, write_polygon_by_rule/2, for the first N of Works, after
%   cut_write_lines/1: all of them, or those before one whose edges cannot be
%   triangulated as they are.
