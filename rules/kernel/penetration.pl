:- module(sg_kernel_penetration, []).
:- sg_kernel:export_doors.

/** <module> Cut sets: what segments have in common, and what polygons become.

Foreign predicates; see kernel.pl.
*/

/* - - - cut4pl.c - - - */

%!  cut_set_open(+Pairs, -Set) is det.
%
%   Set is a new cut set for the segments S1-S2 in the list Pairs, as they are
%   now. Each has a tree of boxes round its triangles or, without triangles
%   (a curve), round its edges; trees are kept with the world until their
%   segment has changed. Nothing else is read yet.

%!  cut_set_close(+Set) is det.
%
%   Frees what Set holds. Any later use is an existence_error(cut_set, Set);
%   the garbage collector closes what is forgotten.

%!  cut_candidate(+Set, -T1, -T2) is nondet.
%
%   Triangles T1 and T2 of two segments that are to cut each other, T1 of the
%   smaller number, have overlapping boxes. Each pair once; the order depends
%   on the model only. All pairs of segments are joined at the first call; it
%   gives the triangles their handles, 0, 1, ...

%!  curve_candidate(+Set, -E, -T) is nondet.
%
%   The same for a curve's edge E and a triangle T.

%!  cut_side(+Set, +T1, +T2, -Side) is det.
%
%   Side is 1 if triangle T1 lies wholly above the plane of T2 (its outside),
%   -1 if wholly below, 0 if it touches or crosses it. Exact.

%!  cut_enter(+Set, +T1, +T2, -Count) is det.
%
%   What T1 and T2 have in common goes into Set: Count pieces of positive
%   length. In a common plane only borders of faces count: real edges that are
%   not inside one, no chords. Exact, but for what cut_flat_within/2 allows.

%!  cut_without_twins(+Set) is det.
%
%   From now on cut_find/1 leaves out what lies inside where two segments have
%   the same triangles (c_kernels/penetration/cut_twin.h): nothing changes there
%   from one triangle to the next. A Boolean says so, which asks for each
%   component of a segment on which sides of the others it is.

%!  cut_find(+Set) is det.
%
%   As cut_enter/4 for every cut_candidate/3 of Set whose triangles are on both
%   sides of each other's planes, in that order: the whole join at once.

%!  curve_enter(+Set, +E, +T, -Count) is det.
%
%   The points inside curve edge E in which it meets T go into Set. Exact.
%   @see PL-7

%!  cut_triangle(+Set, +T, -S, -P, -Id) is det.
%
%   Triangle T is t(S, P, Id, ...).

%!  cut_ends(+Set, +T1, +T2, -Cuts) is det.
%
%   Cuts is the list of cut(Kind, End1, End2) that T1 and T2 have in common, as
%   in tests/oracle/cut.pl, triangle_cut/5. Exact; changes nothing.

/* - - - cut_fold4pl.c - - - */

%!  cut_flat_within(+Set, +Tolerance) is det.
%
%   Polygons whose vertices are no farther off their planes than four times
%   Tolerance, or the tolerance of the model as it is now, have no folds in Set.
%   Say it before the first cut is found. Of others the chords between triangles
%   divide lines, as real edges do: the polygon keeps its shape. Neighbours that
%   are no farther off one plane are one face.

%!  cut_of_faces(+Set) is det.
%
%   From now on lines of Set are of faces, not of polygons: an edge inside a
%   face counts as a chord. A Boolean does not say so: it needs all edges of
%   what was made to touch, and makes faces of what it chose.

/* - - - resolve4pl.c - - - */

%!  cut_own_tolerances(+Set) is det.
%
%   From now on two segments of Set reach no farther than the source of the
%   coarser one says (docs/precision.md), whatever Reach is asked for.

%!  cut_resolve(+Set, +Reach, -Vertices, -Polygons) is det.
%
%   What must change in the segments of Set so that all that is within Reach
%   (model units, positive) touches: Vertices that move or are new, as
%   vertex(S, V, X, Y, Z, Origin), and Polygons as polygon(S, P, Edges,
%   Triangles), Edges a list of w(V1, V2, Et, E), a part of edge E, or a seam
%   if E is 0, and Triangles of t(V1, V2, V3). Both are empty if nothing
%   touches but exactly. If that cannot be done Vertices is wide(S, V) (vertex
%   V hangs together with others over more than three times Reach) or
%   stuck(S, P) (polygon P cannot be triangulated so). Changes nothing.
%   @see resolve.h

%!  cut_touch(+Set, +Reach, -What, -Moves) is det.
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
%     - moved(S1, S2, X, Y, Z, Move, 0.0, N)
%       there are N places, and that at X, Y, Z, where S1 and S2 (0: none)
%       touch, moves farthest
%     - tight(S1, S2, X, Y, Z, Move, Feature, N)
%       at N places it is more than a hundredth of the smallest feature near
%       there: an edge, a wall or a gap of one segment. X, Y, Z is the worst.
%   @see resolve_feature.h

/* - - - seam4pl.c - - - */

%!  cut_seal(+Set) is det.
%
%   When all cuts are entered: orders the points on each real edge, divides
%   the cuts that run along it, and makes equal cuts one piece. The pieces have
%   numbers K, 0, 1, ...

%!  cut_polygons(+Set, -Polygons) is det.
%
%   Polygons is the list of S-P, ascending, of all polygons that pieces enter
%   or whose edges are split. The first call also names every point in its
%   segments.

%!  cut_polygons_of(+Set, +Segments:list, -Polygons) is det.
%
%   The same, of those that are of Segments, or carry a piece of one.

%!  cut_entering(+Set, +S, +P, -Pieces) is det.
%
%   Pieces is the list of piece(K, V1, V2) that run through the face of polygon
%   P of S, in the order of K; V1 and V2 are vertices of S, many of them new.

%!  cut_was_divided(+Set) is semidet.
%
%   True when an edge or a piece was divided while others were entered.

%!  cut_agree(+Set) is det.
%
%   Divides the pieces at all points noted, and the real edges they run along.

%!  cut_late_polygons(+Set, -Polygons) is det.
%
%   Polygons is the list of S-P, in no order, maybe repeated, that have a real
%   edge which cut_agree/1 divided.

/* - - - cut_enter4pl.c - - - */

%!  cut_enter_free(+Set, +S, +P, +Work) is semidet.
%
%   Enters all pieces of polygon P of S into Work, as enter_by_rule/4 of
%   entering.pl does, if they meet nothing but in shared vertices, which is
%   commonest. Else fails, with Work as it was.

%!  cut_enter_polygons(+Set, +Polygons:list, -Works, ?End, -Rest:list) is det.
%
%   Of the polygons S-P from the first on those for which cut_enter_free/4
%   holds: Works are their work(S, P, Work), with cut_work/4, and then End. Rest
%   begins with the first for which it does not.

%!  cut_work(+Set, +S, +P, -Work) is det.
%
%   Work is a new scratch relation (work4pl.c) with the edges of polygon P,
%   labelled with their numbers, divided at the points of cuts on them; it
%   also knows the vertices of cut_entering/4.
%
%   @error existence_error(polygon, P)

/* - - - split4pl.c - - - */

%!  cut_crossing(+Set, +Work, +S, +K, +E, +V1, +V2, -X) is det.
%
%   X is the vertex, known or new, in which V1-V2, a part of piece K, crosses
%   edge E of Work, a scratch relation of segment S. Exact.

%!  cut_note(+Set, +S, +V1, +V2, +X) is det.
%
%   Remembers that vertex X lies between V1 and V2.

%!  cut_between(+Set, +Work, +S, +V1, +V2, -X) is semidet.
%
%   X was noted between V1 and V2, maybe in another segment; it is a vertex of
%   S (and of Work) now.

%!  cut_divided(+Set, +Work, +S, -Divided) is det.
%
%   Divided is the list of E-X: vertex X was noted between the ends of edge E
%   of Work, a scratch relation of segment S; it is a vertex of both now.

/* - - - line4pl.c - - - */

%!  cut_joints(+Set, +How, -Joints) is det.
%
%   Joints is the list of joint(Point, Piece1, Piece2): exactly two pieces end
%   in Point, they are in line, and no other real edge is there. How is
%   `straight` for those on one line exactly, `near` for those that are only
%   within the tolerance to which their polygons are flat. A piece is
%   piece(S1, P1, S2, P2). To be asked after cut_seal/1 or cut_agree/1.

%!  cut_join(+Set, +Point) is det.
%
%   Makes one piece of the two at a joint.
%
%   @error domain_error(joint, Point)

%!  cut_settle(+Set) is det.
%
%   After joints and before cut_polygons/2: forgets the points that were joined
%   away; K is numbered anew.

%!  cut_name(+Set, +Point, +S, -V) is semidet.
%
%   Point is vertex V of segment S.

%!  cut_lines(+Set, -Lines) is det.
%
%   Lines is the list of the line/9 rows that the pieces are, numbered on from
%   those of the world.

%!  cut_line(+Set, +S, +V1, +V2, -L) is semidet.
%
%   L is the first line between vertices V1 and V2 of S, after cut_lines/2.

%!  cut_vertices(+Set, -Vertices) is det.
%
%   Vertices is the list of vertex(S, V, X, Y, Z, Origin) that are new.

%!  cut_split_edges(+Set, +S, -Splits) is det.
%
%   Splits is the list of split(V1, V2, Vs): edges of S and the vertices on
%   them, in order from V1 to V2.

/* - - - chain4pl.c - - - */

%!  cut_chains(+Set, -Chains) is det.
%
%   Chains is the list of chain(S1, S2, Kind, Points, Polygons), as in
%   penetration.pl, penetration_chains/2, of the pieces that Set has now.

%!  line_chains(-Chains) is det.
%
%   Chains are those of chains/1; the rule is tests/oracle/chain.pl.

/* - - - cut_write4pl.c - - - */

%!  cut_write(+Set, +S, +P, +Work) is semidet.
%
%   As cut_rows.pl, write_polygon_by_rule/2, for polygon P of S, whose edges
%   are in Work, after cut_lines/2. Fails, and has changed nothing, if these
%   edges cannot be triangulated as they are.
