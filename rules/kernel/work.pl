:- module(sg_kernel_work, []).
:- sg_kernel:export_doors.

/** <module> The edges of one polygon as a scratch relation, which lines enter.

Foreign predicates; see kernel.pl.
*/

/* - - - work_rows.c - - - */

%!  work_open(+S:id, +P:id, -Work:work) is det.
%
%   Work is a scratch relation with the edges of polygon P, in the order of its
%   list, each labelled with its number. Vertices are named as in v/5, edges
%   are numbered anew from 1. The polygon is seen from outside along the
%   largest component of its normal; all decisions on it are exact. It follows
%   neither the world's changes nor its transactions; it is freed by
%   work_close/1 or with its last reference.
%
%   @error existence_error(polygon, P)

%!  work_close(+Work:work) is det.
%
%   Frees Work now. Using it afterwards is existence_error(work, Work).

%!  work_add(+Work:work, +V1:id, +V2:id, +Et:int, +Label:integer, -E:id) is det.
%
%   Adds the edge V1-V2 as the youngest; Et is 0 or 1, Label any integer of 64
%   bits. Nothing is checked against the other edges.
%
%   @error existence_error(work_vertex, V), domain_error(another_vertex, V2)

%!  work_delete(+Work:work, +E:id) is det.
%
%   @error existence_error(work_edge, E)

%!  work_resolve(+Work:work, +Reach:number) is det.
%
%   Makes what touches exactly meet in one vertex: vertices in one place become
%   the first of them, edges with a vertex inside are split there, and opposite
%   edges with the polygon on neither side vanish. Does nothing where all
%   contacts are shared vertices. If Reach is above 0.0, what is nearer than
%   that (model units) is made to touch first.

%!  work_gap(+Work:work, -V:id) is semidet.
%
%   True when the polygon does not close at vertex V, the first such.

/* - - - work_join_rows.c - - - */

%!  work_edge(+Work:work, ?E:id, ?V1:id, ?V2:id, -Et:int, -Label:integer)
%!      is nondet.
%
%   True when Work has the edge E from V1 to V2. Oldest first, as they
%   are at the first call. Given E, or V1 or V2, it looks up.

%!  work_oldest(+Work:work, -E:id, -V1:id, -V2:id) is semidet.
%
%   The first solution of work_edge/6. Fails if there are no edges.

%!  work_meeting(+Work:work, +V1:id, +V2:id, -E:id, -How:meeting_how,
%!               -Inside:list(meeting_end)) is nondet.
%
%   True when edge E meets the segment V1-V2 other than in a shared end.
%   Oldest edge first, as they are at the first call. How is
%
%     - crosses
%       in one point inside both
%     - touches
%       in one point, an end of at least one of them
%     - contained
%       the whole segment lies on the edge
%     - overlaps
%       on one line, with a part in common that is not the whole segment
%
%   Inside lists the ends that lie inside the other one: of `v1` and `v2`
%   (inside the edge), `start` and `end` (of the edge, inside the segment).
%   Also `v1_at_start`, `v1_at_end`, `v2_at_start`, `v2_at_end`: different
%   vertices in one place. Exact.

%!  work_candidate(+Work:work, +V1:id, +V2:id, +N:count, -V3:id) is semidet.
%
%   V3 is number N, from 0, of the vertices that can be the third one of the
%   edge V1-V2: steps (3), 4 (I)
%   and 4 (II) of PL-6 as one join. V3 lies to the left, and no edge meets the
%   closed triangle other than in its corners, or along its sides. Ends of
%   edges leaving V2 first, then starts of edges entering V1, then other
%   vertices, near ones first; each once. Exact.

%!  work_triangulate(+Work:work, -Triangles:list(corners)) is det.
%
%   Triangles are terms t(V1, V2, V3), as work_triangles/2 of triangulation.pl
%   finds them one by one: the fused kernel. Uses up the edges; any that are
%   left begin with one that has no third vertex.

%!  work_thicken(+Work:work, +Edges:list(id_pair), +Triangles0:list(corners),
%!               -Triangles:list(corners)) is det.
%
%   If one of Triangles0 is so thin that rounding may have turned it over,
%   chords between them are turned: all sides but those of Edges, the V1-V2 that
%   Work had. What may be turned is decided exactly.

/* - - - outline_rows.c - - - */

%!  loops_are_sound(+Loops:list(list(paper_point))) is semidet.
%
%   True when Loops, lists of three or more X-Y, of which no two that follow
%   each other are equal, are an outline and its holes: no two edges have a
%   point in common but neighbours the one between them, and each loop after
%   the first is inside of the first and in no other. Exact.
