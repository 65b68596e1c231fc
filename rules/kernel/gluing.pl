:- module(sg_kernel_gluing, []).
:- sg_kernel:export_doors.

/** <module> The regions of space between the faces of a segment.

Foreign predicates; see kernel.pl and c_kernels/gluing/regions.h.
*/

/* - - - regions_rows.c - - - */

%!  regions_open(+S:id, +Loops:list(point_loop_fact), -Regions:regions) is det.
%
%   Regions is what the faces, wires and lone vertices of segment S make of
%   space. V-P in Loops: vertex V lies inside polygon P. Regions are numbered by
%   the last polygon that each is behind, or else the last one that it is
%   before; the outside is last. If S is of kind `solid`, a bounded region that
%   no polygon has behind it is a `void`.
%
%   @error geometry_error(open_polygon(S, P)): the loops of P do not close
%   @error geometry_error(wrong_triangles(S, P)): t/6 does not end where P does,
%          or a vertex that is told to lie inside P does not

%!  regions_told(+S:id, +Loops:list(point_loop_fact),
%!               +Meetings:list(zone_meeting_fact), -Regions:regions) is det.
%
%   As regions_open/3, but how the disks at a vertex lie to each other is
%   told: meet(V, E1, Above1, E2, Above2), at vertex V two sides have one
%   zone. E is the edge that starts at V, of a polygon, or of a wire; or -P,
%   polygon P inside of which V lies. Above is true of the side where the
%   normal points. Of what is not told each cycle has a zone of its own.
%
%   @error as regions_open/3; existence_error(edge, E)

%!  regions_close(+Regions:regions) is det.

%!  regions_counted(+Regions:regions, -Counts:region_counts) is det.
%
%   Counts is counts(V, E, F, L, C, R, S, G, Twisted, Dropped, Doubtful):
%   vertices, edges, faces, connected parts of their borders, parts, regions,
%   shells and their genus; shells that no surface is, polygons without area,
%   parts that lie on faces of others.

%!  regions_listed(+Regions:regions, -List:list(region_fact)) is det.
%
%   List has region(Role, Faces, Shells, Genus, Wires, Lone, Volume, Area) for
%   each, in the order of their numbers. Volume and Area are rounded.

%!  regions_neighbours(+Regions:regions,
%!                     -List:list(region_neighbours_fact)) is det.
%
%   List has neighbours(R1, R2, Faces, Area), R1 < R2, for regions with faces
%   between them, ascending.

%!  regions_items(+Regions:regions, -Wires:list(region_item),
%!                -Lone:list(region_item)) is det.
%
%   Wires and Lone have Id-R: the edge or the vertex Id lies in region R. Of
%   edges without a face between the same two vertices the first.

%!  regions_written(+Regions:regions) is det.
%
%   Writes region/3 and sides/4. There are none of the segment.

/* - - - region_content_rows.c - - - */

%!  contents_written(+S:id, +Solids:set(id), -Nothing:list(int),
%!                   -Wrong:count) is det.
%
%   Writes from_r/4 of segment S, a glue of which there is none and whose
%   regions are known: which of Solids each is inside. Nothing are the regions
%   that are inside none, the outside too, ascending.

/* - - - cell_added_rows.c - - - */

%!  cell_added(+S:id, +N:id, +Solid:solid, +Reach:number,
%!             +Made:set(id)) is semidet.
%
%   Segment N, the solid that is Solid, with its faces merged, becomes one more
%   operand of the glue S: what it shares is known to be made of it too, the
%   rest gets rows, and only sides and regions beside it change. Fails, and
%   writes nothing, where S and N do not meet in equal features alone, within
%   Reach, where a polygon of S near N has one of the vertices Made, of which
%   v/5 does not say where they are exactly, or where regions change otherwise
%   than by one more, or a void less.
%
%   @see c_kernels/gluing/cell_added.h

%!  cell_completed(+S:id, +N:id, +Solid:solid, +Reach:number, +Made:set(id),
%!                 +Was:list(id_pair), -Faces:count) is semidet.
%
%   So many Faces of segment N, an operand of the glue S that is Solid, with its
%   faces merged, are not in S, and get rows; of sides/4 they have none. P0-P in
%   Was, ascending: polygon P0 of N becomes P. Fails, and writes nothing, where
%   one has no number there, or two have one, or Made is near.

/* - - - regions_joined_rows.c - - - */

%!  regions_joined(+S:id, +N:id, +Polygons:set(id)) is semidet.
%
%   Operand N goes from the glue S, and Polygons with it, which no other operand
%   has: the regions on their two sides become one, and sides/4, region/3 and
%   from_r/4 say so, with the numbers that regions_open/3 would give. Fails, and
%   writes nothing, where the regions that become one are inside different
%   operands else, and where there is a slit. N may be S: no operand goes, and
%   regions get their numbers anew.

/* - - - gap_rows.c - - - */

%!  segment_gaps(+Pairs:list(id_pair), +Reach:number,
%!               -Gaps:list(segment_gap)) is det.
%
%   Gaps has miss(S1-Of1, S2-Of2, Gap, End1-End2) for each S1-S2 of Pairs, in
%   their order, that are no farther apart than Reach: how far they are, the
%   polygons that are nearest to each other, of curves the edges, and where. Of
%   several that are as near the first by their numbers. Rounded; of polygons
%   that go through each other Gap is 0 only where a corner or two edges touch.

%!  polygon_gap(+Facet1:id_pair, +Facet2:id_pair, -Gap:number,
%!              -Ends:gap_ends) is semidet.
%
%   Gap is the distance of the polygons Facet1 and Facet2, S-P, and Ends is
%   End1-End2, where they are as near as that. The same. Fails if one has no
%   triangles.
