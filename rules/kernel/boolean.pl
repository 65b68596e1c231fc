:- module(sg_kernel_boolean, []).
:- sg_kernel:export_doors.

/** <module> Operands, arrangements, and solids under way.

Foreign predicates; see kernel.pl.
*/

/* - - - self_rows.c - - - */

%!  self_meetings(+Most:integer, -Segments:list(self_segment)) is det.
%
%   Where segments go through themselves: Segments has a
%   self(S, Counts, Meetings) for each segment, by number. Counts are
%   Kind-Count, Kind one of self_penetration, self_overlap and self_touching
%   (c_kernels/join/self_cut.h), a pair of polygons counted once; Meetings are
%   the first Most of each as meeting(Kind, P1, P2, X, Y, Z), P1 =< P2, in the
%   order of the polygons: something they have in common is at X, Y, Z.

%!  segment_meetings(+S:id, +Most:integer,
%!                   -Segments:list(self_segment)) is det.
%
%   As self_meetings/2, of segment S alone, and looked for at each call.

%!  self_meeting(?Kind:self_kind, ?S:int, ?P1:int, -P2:int) is nondet.
%
%   True when polygons P1 =< P2 of segment S meet so: all that self_meetings/2
%   can list. Found once, and kept until a row changes.

/* - - - operand_rows.c - - - */

%!  segments_meeting_themselves(+Segments:set(id), -Which:list(id)) is det.
%
%   Which are those of Segments, each there once, for which
%   segment_meets_itself/1 is true; ascending. Cheaper than one by one.

%!  segment_meets_itself(+S:id) is semidet.
%
%   True when the triangles of segment S go through each other or lie on each
%   other, by more than the tolerance of its source; so its own cuts count.
%   What neighbours share does not, and vertices in one place are two. Known
%   afterwards, until the segment changes.

%!  segment_operand(+S:id, -Operand:operand_facts) is det.
%
%   What a Boolean must know of segment S each time: Operand is
%   operand(Triangles, HalfEdges, Balanced, Volume, Error, Star). Balanced:
%   there are as many half-edges one way as the other between any two vertices.
%   Volume is negative where S is inside out as a whole; by rounding it is off
%   by Error at most, seen from the middle. Star: all of its surface is seen
%   from the middle of its box, so it does not go through itself; `false` says
%   nothing. Known afterwards, until the segment changes.

%!  segment_edges(+S:id, +Most:int, -Counts:edge_counts,
%!                -Edges:list(operand_edge)) is det.
%
%   The edges of segment S that are no pairs of half-edges: Counts is
%   edges(Open, Unbalanced, Crowded), how many are of one half-edge; of more,
%   and not balanced; balanced, and of more than two. Edges are the first Most
%   of the first two sorts by their vertices, edge(V1, V2, Forward, Backward),
%   V1 < V2 or the same: how many half-edges run from V1 to V2, and back.

/* - - - operand_border_rows.c - - - */

%!  operand_borders(+Ss:set(id), -Borders:list(operand_border)) is det.
%
%   Borders are border(S, P, V1, V2, Q), ascending by S, V1, V2: S is one of the
%   results Ss, its polygon P has the edge from V1 to V2, V1 < V2, and Q its
%   opposite, and they are parts of operands (from_p/5), of no common one. The
%   rule is tests/oracle/operand_border.pl.

/* - - - winding_rows.c - - - */

%!  windings(+S:id, +Points:list(exact_point),
%!           -Windings:list(winding)) is det.
%
%   How often the triangles of segment S go round each point(X, Y, Z) of the
%   list, `on` if it lies on one. Numbers of any sort count exactly. Exact.
%   @see winding.h

/* - - - csg_rows.c - - - */

%!  newer_segments(+Ss:list(id), +Stamp:integer, -Newer:list(int)) is det.
%
%   Newer are those of Ss with a segment_stamp/2 above Stamp: their rows changed
%   since that of another segment was given.

%!  changed_leaves(+Ss:list(id), +Stamp:integer, -Others:list(int)) is det.
%
%   Others are those of Ss that are newer (newer_segments/3), or of which
%   kept_leaves/2 says `other`.

%!  kept_leaves(+Ss:list(integer), -Kinds:list(symbol)) is det.
%
%   Kinds are those of the segments Ss, in order: the kind, as segment/3 has it,
%   of one that is a primitive and has the rows that were made from it, by its
%   record (made_and_kept/2); `other` for the others.

%!  other_segments(-Ss:list(id)) is det.
%
%   Ss are the segments of which kept_leaves/2 says `other`, in the order of the
%   rows of segment/3.

%!  node_origins(+S:id, -Origins:list(node_origin)) is det.
%
%   Origins are Item-Origin of all origin(S, Item, Origin) with an Item node(_),
%   in the order of their rows.

/* - - - leaf_copy_rows.c - - - */

%!  leaf_copies(+Ss:set(id), +Most:count, -Copies:list(id_pair)) is det.
%
%   Of those of Ss that are one thing several times the first Most are left, 1
%   at least; Copies are the others, ascending, as S-First. They are of one kind
%   and from as fine a source, with the same vertices, edges, polygons and
%   triangles in the same places, in the same order. What was cut is equal to
%   none. Exact.

/* - - - solid_rows.c - - - */

%!  solid_take(+Segments:set(id), -Solid:solid) is det.
%
%   Solid is a new handle of a boundary under way (c_kernels/solid/solid.h): the
%   polygons of Segments as they are in t/6, e/5 and v/5, one face for each that
%   has triangles. Segments are taken in ascending order, each once; vertices of
%   different segments stay apart. The handle is freed by atom garbage
%   collection, or at once by solid_close/1.

%!  solid_move(+Solid:solid, +Matrix:list(list(number)),
%!             -Again:list(count)) is semidet.
%
%   Put Solid somewhere else: three rows [A,B,C,D] of Matrix give the new
%   coordinates, A*X+B*Y+C*Z+D. If Matrix mirrors, triangles turn round. Again
%   are the numbers, from 1, of faces whose triangles no longer cover them, for
%   rounding turned one over. Fails if a coordinate is larger than v/5 takes;
%   Solid is then good for nothing.

%!  solid_close(+Solid:solid) is det.
%
%   Frees what Solid holds; it cannot be used any more.
%
%   @error type_error(solid, Solid), existence_error(solid, Solid): closed

%!  solid_is_closed(+Solid:solid) is semidet.
%
%   True when every edge of its triangles runs as often back as there.

%!  solid_vertices(+Solid:solid, -Vertices:list(solid_vertex_fact)) is det.
%!  solid_faces(+Solid:solid, -Faces:list(solid_face_fact)) is det.
%!  solid_parts(+Solid:solid, -Parts:list(solid_part_fact)) is det.
%
%   What is in a solid: vertex(V, X, Y, Z, From), V from 1, From S0-V0 or
%   made(Origin); face(S0, P0, Sense, Triangles), Sense -1 if it looks the other
%   way than polygon P0, with its t(V1, V2, V3, Auxiliary), where bit 0 of
%   Auxiliary is for the edge V1-V2, and so on; and after merging
%   part(Face, S0, P0, Sense), Face from 1.

%!  solid_coincident_faces(+Solid:solid, +Tolerance:number,
%!                         -Doubles:count) is det.
%
%   Vertices of Solid in one place become one. Faces that lie on each other,
%   turned round or not, become one, the first, which has the parts of all;
%   Doubles of them have gone.
%
%   @see c_kernels/solid/coincident_faces.h

%!  solid_is_whole(+Solid:solid, +Solids:set(id), +Reach:number) is semidet.
%
%   True when all that meets in Solid, after solid_coincident_faces/3, are equal
%   features: so nothing of it is to be cut. Solids, ascending: those segments
%   of it that are to bound something.
%
%   @see c_kernels/solid/whole_contacts.h

/* - - - solid_write_rows.c - - - */

%!  solid_write(+Solid:solid, +S:id) is det.
%
%   Appends the rows of Solid to segment S, which must have none; the rule is
%   tests/oracle/solid_rows.pl. Call it in a transaction.
%
%   @error permission_error(write, segment, S): it has rows

%!  solid_write_cells(+Solid:solid, +S:id,
%!                    -Loops:list(point_loop_fact)) is det.
%
%   As solid_write/2, of what is glued: a polygon also ends where it has an edge
%   of others in its middle, there and back. Loops are V-P: vertex V lies in the
%   middle of polygon P.
%
%   @see c_kernels/solid/solid_seams.h

/* - - - solid_over_rows.c - - - */

%!  solid_write_over(+Solid:solid, +S:id) is semidet.
%
%   The rows of segment S, which were a solid's, become those of Solid. What is
%   the same stays with its ids, so ids need not be dense: what is new has the
%   least that are free. Fails if S has other rows than a solid becomes, or most
%   faces are new. Call it in a transaction.
%
%   @see c_kernels/solid/solid_over.h

%!  solid_write_region(+Solid:solid, +S:id, +Region:region) is semidet.
%
%   As solid_write_over/2, of the faces of Region alone, which was read from
%   segment S: they become those of Solid. Fails, and changes nothing, if S has
%   changed since; if the new faces are not bounded by the edges that the old
%   ones were; or if a new vertex is where another one of S is.
%
%   @see c_kernels/solid/solid_over.h

%!  solid_region(+S:id, +Leaves:set(id), -Region:region) is semidet.
%
%   Region is a handle of the faces of segment S, a solid's rows, that come from
%   Leaves: and from those that such faces come from, too, and so on. Fails if S
%   has other rows than a solid becomes. It is closed by garbage collection, or
%   at once by region_close/1.
%
%   @see c_kernels/solid/solid_old.h

%!  region_leaves(+Region:region, -Leaves:list(id)) is det.
%
%   Leaves are those of Region, ascending.
%
%   @error type_error(region, Region); existence_error(region, Region): closed

%!  region_close(+Region:region) is det.
%
%   @error as region_leaves/2

/* - - - face_merge_rows.c - - - */

%!  solid_merge(+Solid:solid, +Tolerance:merge_tolerance,
%!              +Options:list(merge_option), -Moved:merge_move) is semidet.
%
%   Makes coplanar neighbours in Solid one face each and drops vertices that lie
%   straight (c_kernels/solid/face_merge.h). Tolerance is a number, or
%   own(Number), which follows from the coarsest segment. Options:
%   origins(separate): never faces of different segments; cells(true): edges of
%   more than two half-edges stay, also in the middle of faces; apart(Pairs):
%   never these, as of solid_neighbours/3; by_size(true): a Tolerance no larger
%   than 2^-13 of the size of Solid; region(Region): Solid is a part of a larger
%   one, of which only the faces of Region (solid_region/3) are wanted and left;
%   then it fails if one of these and another might become one.
%
%   Moved is `none`, or move(How, S0, p(X, Y, Z), Move, Beside, N) if N vertices
%   vanish farther from what stays than a hundredth of something there, and than
%   doubles are rounded; the worst is Move away beside edge(Length), an edge of
%   operand S0, or wall(Thickness), a wall of S0 or a slot that it cuts. How is
%   `moved` if their own sources explain that, else `tight`.

%!  solid_neighbours(+Solid:solid, +Tolerance:merge_tolerance,
%!                   -Pairs:list(merge_pair)) is det.
%
%   Pairs are the Part1-Part2 of which faces in Solid are neighbours and may lie
%   in one plane. A part is part(S0, P0, Sense), Sense -1 if the face looks the
%   other way than polygon P0 of S0. Sorted by S0, P0 and Sense, 1 before -1,
%   each pair once, the lesser part first.

/* - - - sewing_rows.c - - - */

%!  segment_sewn(+S:id, -Weights:list(polygon_weight)) is semidet.
%
%   Vertices of segment S that are in one place become one, the first of them,
%   and so do polygons that lie on each other, turned round or not: those that
%   count for several are the P-Weight in Weights, ascending, Weight not 1: how
%   often they count, turned over if it is negative. Polygons that cancel each
%   other fall out. Vertices stay, used or not. Fails, and changes nothing, if
%   no two vertices are in one place. Call it in a facts_snapshot/1.
%
%   @see c_kernels/solid/sewing.h

%!  segment_welded(+S:id, -Doubles:count) is det.
%
%   Vertices of S in one place become one. Polygons that lie on each other stay
%   once, the first of them, turned as it is; Doubles of them have gone.

/* - - - shell_copy_rows.c - - - */

%!  segment_copies_dropped(+S:id, +Most:count) is semidet.
%
%   Of shells of segment S that are equal, in one place, the first Most are
%   left: the others go with their vertices. Fails, and changes nothing, if
%   there are not so many, or if something was made from S: leaves, lines, a
%   picture, a pattern, or S from others.
%
%   @see c_kernels/join/shell_copy.h

/* - - - arrangement_rows.c - - - */

%!  arrangement_open(+Set:cut_set, +Segments:set(id), +Wanted:set(id),
%!                   +Weights:list(arrangement_weight),
%!                   -Arrangement:arrangement) is det.
%!  arrangement_polygons(+Arrangement:arrangement,
%!                       +Works:list(entered_polygon), +Reach:number) is det.
%!  arrangement_seal(+Arrangement:arrangement) is det.
%!  arrangement_hold(+Arrangement:arrangement) is det.
%!  arrangement_drop(+Arrangement:arrangement) is det.
%
%   The segments Wanted, which are among Segments, in pieces along the lines of
%   cut set Set, which is sealed. Polygons that were entered are told with what
%   they became, as work(S, P, Work), all at once; what touches within Reach is
%   made one where nothing else helps. Sealing finds the components, and on
%   which side of each segment that is; then the set, and what else it was made
%   from, is let go. An arrangement is held once when it is opened, and closed
%   when it is dropped as often as it was held.
%
%   @error permission_error(fill, arrangement, Arrangement): it is sealed, or
%          sealing it was stopped

%!  arrangement_free_polygons(+Arrangement:arrangement,
%!                            +Polygons:list(segment_polygon),
%!                            +Reach:number) is semidet.
%
%   What arrangement_polygons/3 does after enter_polygons/4 of entering.pl, for
%   all of the polygons S-P together, many at a time. Fails, and nothing is
%   taken in, if a line meets anything in one of them, or one cannot be
%   triangulated.
%
%   @error existence_error(polygon, P)

/* - - - contact_places_rows.c - - - */

%!  contact_places(+S:id, -Contacts:contacts) is semidet.
%!  contact_facts(+Contacts:contacts, -Facts:list(contact_fact)) is det.
%
%   Contacts is a handle of where segment S was made to touch others: true only
%   inside the snapshot of resolve.pl, where S has the vertices that it got for
%   that. Fails if it has none. Facts are V-place(Origin, Feature, Polygons),
%   one for each such vertex V, as their origins stand. Origin is as of
%   resolve.pl. Feature is v(V) if V was moved, otherwise the edge e(E) or face
%   p(P) that V was put on; Polygons are then those that have V.

/* - - - contact_origin_rows.c - - - */

%!  contact_origins(+S:id, +Contacts:list(leaf_contacts)) is det.
%
%   Rewrites from_v/4 and origin/3 of the result S so that they name nothing of
%   Contacts, a list of S0-Contacts0 as contact_places/2 gave it for leaf S0,
%   which has its own rows again.
%
%   @see c_kernels/solid/contact_places.h

/* - - - arrangement_piece_rows.c - - - */

%!  arrangement_components(
%!      +Pieces:list(arrangement_piece),
%!      -Components:list(component_fact)) is det.
%!  arrangement_numbers(+Pieces:list(arrangement_piece),
%!                      -Numbers:list(integer)) is det.
%
%   Numbers are those of the arrangements in Pieces, a list of S-Arrangement, in
%   order. In the life of the process each arrangement has a number of its own.

%!  arrangement_select(+Pieces:list(arrangement_piece),
%!                     +Senses:list(component_sense), -Solid:solid) is det.
%
%   Pieces are S-Arrangement, for each segment S an arrangement in which it was
%   wanted. A component is
%
%       component(C, S, P, point(X, Y, Z), Sides, Which)
%
%   with a polygon P of it and a point in that (rounded), and Sides a list of
%   side(S1, Below, Above): how often S1 goes round the points just below and
%   just above it; of segments that are not there, 0. Which is `second` if it
%   lies on a piece of an earlier segment (or on an earlier one of its own),
%   `unknown` if it has no area, else `only`. C counts through. Senses are C-1
%   for components to be chosen, and C-(-1) for those to be turned over. Exact.
%
%   @error geometry_error(polygon_edge(S, P, V1, V2)): with its lines, P cannot
%          be triangulated
%   @see c_kernels/solid/arrangement.h; rows CB-3 and CB-4

/* - - - arrangement_kept4pl.c - - - */

%!  pieces_kept(-Kept) is semidet.
%!  keep_pieces(+Kept) is det.
%
%   Kept is the term that was kept last with the current world (arrangement.pl),
%   a copy. What it holds, arrangements too, lives as long.

/* - - - expression_rows.c - - - */

%!  arrangement_senses(+Pieces:list(arrangement_piece),
%!                     +Expression:list(expression_node_fact),
%!                     +Open:list(id), -Senses:list(component_sense)) is det.
%
%   The fused kernel of boolean.pl, stays/3: Senses are the C-Sense of the
%   components that stay in the boundary of Expression; Open are the segments
%   among its leaves that are surfaces. Expression has its nodes, each before
%   its operands: node(leaf, S), or node(Operation, N) with N operands.
