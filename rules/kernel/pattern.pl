:- module(sg_kernel_pattern, []).
:- sg_kernel:export_doors.

/** <module> Laying flat, unrolling, and placing pieces on sheets.

Foreign predicates; see kernel.pl.
*/

/* - - - development_rows.c - - - */

%!  flattening_open(+S:id, +Tolerance:number, +Removed:set(id),
%!                  -Flattening:flattening) is det.
%
%   Flattening is a handle on segment S being laid flat, without the polygons
%   Removed: its faces, each in a frame of its own, and its joints, numbered
%   from 1. A face is a polygon no vertex of which is farther than Tolerance
%   from its plane, or a triangle of another polygon; such a triangle is called
%   by the polygon that it will be, numbered on from those of S, and its chords
%   are edges, numbered on likewise. S should have its triangles. To be closed.
%
%   @error representation_error(int32): no numbers are left for these

%!  flattening_close(+Flattening:flattening) is det.

%!  flattening_restart(+Flattening:flattening) is det.
%
%   Nothing is joined, as at first; what is forbidden stays so.

%!  flattening_lay(+Flattening:flattening, +Root:int) is det.
%
%   Finds where everything lies, as joined by now, see lay.h. Root is a polygon,
%   or 0. Joints whose sides lie on each other become `closed`.
%
%   @error existence_error(polygon, Root)

%!  flattening_measures(+Flattening:flattening, -Measures:flat_measures) is det.
%
%   Measures is measures(Seam, Pieces, Longest, Area, Sheet, Tests, Refused),
%   see measure.h: after flattening_lay/2. Tests is how many
%   triangles were tested against each other, Refused how many joints would
%   have made an overlap.
%
%   @error permission_error(lay, flattening, Flattening)

%!  forbid_joint(+Flattening:flattening, +J:id) is det.
%
%   Joint J is not to be joined.
%
%   @error permission_error(forbid, joint, J): it is joined already

%!  join_faces(+Flattening:flattening, +J:id, -Result:join_result) is det.
%
%   Tries to join the two faces of joint J: `joined`; `same_piece`: they hang
%   together already; overlap(P1, P2): it would lay polygon P2 on P1;
%   `forbidden`; `short`: the edge is too short to hold what would hang on it
%   (SG_FLAT_HOLDS in flattening.h).

%!  join_all(+Flattening:flattening, +Order:count) is det.
%!  join_before(+Flattening:flattening, +Order:count, +J:id) is det.
%
%   join_faces/3 for all joints that are open, as joint_order/3 has them; for
%   those before joint J. With order 0, join_all/2 is the fused kernel of
%   development.pl, joined_by_rule/2.

%!  joint_order(+Flattening:flattening, +Order:count, -Joints:list(id)) is det.
%
%   All joints; those that are flat come first. Order 0 is the default of
%   join_order/3; 1: those that bend least; 2: those that run up and down; 3 and
%   on: as 0, but with lengths changed by up to a tenth, by chance.

%!  joint_path(+Flattening:flattening, +J:id, -Joints:list(id)) is det.
%
%   The joints that are joined on the way from one face of J to the other, []
%   if there is no way.

/* - - - development_read_rows.c - - - */

%!  flattening_counts(+Flattening:flattening, -Faces:count, -Joints:count,
%!                    -Step:number) is det.
%
%   How many faces and joints there are. What differs by less than Step (model
%   units) is mostly equal for joint_order/2: it is rounded to that.

%!  flattening_bent(+Flattening:flattening, -Polygons:list(id)) is det.
%
%   Polygons, ascending, are not flat.

%!  flattening_invalid(+Flattening:flattening, -Polygons:list(id)) is det.
%
%   Polygons, ascending, have an area and no triangles: they cross themselves.

%!  flattening_borders(+Flattening:flattening, -Edges:list(id)) is det.
%
%   Edges are real and have no partner.

%!  flattening_joint(+Flattening:flattening, +J:id, -Joint:joint_fact) is det.
%
%   Joint is joint(E1, E2, P1, P2, Length, p(X,Y,Z), Angle, Kind, State): edge
%   E1 of polygon P1 and its partner E2 of P2, E1 < E2, the length and the
%   middle of them, the angle as in joint/6. Kind is `line` (P1 is P2), `flat`
%   or `bent`. State is `open`, `joined`, `same_piece`, `overlap`, `forbidden`,
%   `point`, or, after flattening_lay/2, `closed`.
%
%   @error existence_error(joint, J)

%!  edge_joint(+Flattening:flattening, +E:id, -J:id) is semidet.
%
%   Joint J has edge E.

/* - - - development_write_rows.c - - - */

%!  flattening_write(+Flattening:flattening, +D:id) is det.
%
%   Writes the rows of the pattern D, which has none: v e p plane t piece joint
%   from_v from_p, after flattening_lay/2.
%
%   @error permission_error(write, segment, D)

/* - - - seam_exchange_rows.c - - - */

%!  exchange_seams(+Flattening:flattening, +Order:count, +Kept:list(id),
%!                 +Objective:exchange_objective, +Effort:count,
%!                 -Exchanges:count) is det.
%
%   What is joined, in the order of joints Order, is exchanged for folds that
%   leave less seam, see seam_exchange.h; the joints Kept stay folds. Objective
%   is `seam`, or `pieces`: fewer of them is worth any seam. Effort is about how
%   many faces may be laid or moved for that. Exchanges is how many have helped.
%   Its rule is tests/oracle/seam_exchange.pl.

%!  join_folds(+Flattening:flattening, +Joints:list(id)) is det.
%
%   Restarts and joins just Joints, as they were joined before: nothing is asked
%   about overlaps.
%
%   @error existence_error(joint, Joints)

%!  seam_length(+Flattening:flattening, -Length:number) is det.
%
%   The length of all joints that are neither joined nor have sides that lie on
%   each other all the same, as joined by now; model units.

%!  flattening_bound(+Flattening:flattening, -Bound:seam_bound) is det.
%
%   Bound is bound(Least, By, Tree): no seam is less than Least, as is proven by
%   `tree`, `forest` or `moats`; Tree is the minimum spanning tree of the
%   vertices. Model units; see seam_bound.h.

%!  fold_path(+Flattening:flattening, +P:id, +Q:id, -Joints:list(id)) is det.
%
%   The joints that are joined on the way between polygons P and Q of the
%   pattern, [] if there is no way.
%
%   @error existence_error(polygon, P)

/* - - - known_facets_rows.c - - - */

%!  known_facets(+Known:list(known_segment), +Ss:set(id),
%!               -Facets:list(known_segment)) is det.
%
%   Facets has known(S, Surfaces, Runs), as of known_surfaces/1, for each of the
%   segments Ss that has polygons which are facets of surfaces, or named faces,
%   by what Known, of known_surfaces/1, says of it, or of those its polygons
%   came from (from_p/5). Surfaces are in the order of their first facets. The
%   fused kernel of segment_facets/3 (known_surface.pl). Inexact where they are
%   moved.

/* - - - roll_rows.c: cylinders and cones unrolled - - -

A surface is a term of primitive_face.pl, or plane(Nx, Ny, Nz, D): Nx*X + Ny*Y +
Nz*Z + D = 0. A roll is roll(Surface, Layer, Start): a cylinder or a cone (but
one with K = 1) is unrolled from the generator at Start, as it is Layer outside
the drawn surface. Degrees; see roll.h.
*/

%!  surface_place(+Surface:offset_surface, +Point:point, -T:number,
%!                -H:number) is det.
%
%   T (-180..180) and H are the parameters of the point of Surface, a cylinder,
%   cone or ruled surface, that Point is taken to: from the axis, at its H.

%!  surface_value(+Surface:offset_surface, +Point:point, -Value:number,
%!                -Normal:vector) is semidet.
%
%   Value is how far Point is from Surface, to first order, negative inside
%   (below a plane); Normal, vector(X, Y, Z), is the unit normal there, outward.
%   Fails where there is none, as on an axis. Rounded.

%!  surfaces_meet(+Surfaces:list(offset_surface), +Reach:number,
%!                +Point0:point, -Point:point) is semidet.
%
%   Point is a point near Point0 on all of one to three Surfaces. Fails if
%   there is none within Reach, or they touch there. Rounded.

%!  roll_points(+Roll:roll_fact, +Places:list(paper_point),
%!              -Points:list(paper_point)) is det.
%
%   Where the points of the surface at Places, a list of T-H, are unrolled:
%   Points is the list of X-Y. T is at most about a turn from the start.

%!  roll_curves(+Roll:roll_fact, +Reach:number, +Tolerance:number,
%!              +Curves:list(roll_curve_fact),
%!              -Lists:list(list(roll_place_fact))) is det.
%
%   Points on Curves between their ends, so many that no chord is farther than
%   Tolerance from the unrolled curve. A curve is curve(T0, Surfaces, From, To):
%   where one to three Surfaces meet, from one point to another, not farther
%   than Reach from the line between them. Each list has place(T, H, X, Y), T
%   within half a turn of T0.

/* - - - nest_rows.c - - - */

%!  shapes_open(+Size:number, -Shapes:shapes) is det.
%
%   Shapes is a handle for convex shapes on paper, none yet, each of them about
%   of this Size (up to a million times as large or small).

%!  shapes_add(+Shapes:shapes, +Shape:list(paper_point)) is det.
%
%   Shape, a list of 2 (a line) to 8 points X-Y in order, is one more.

%!  shapes_free(+Shapes:shapes, +Shape:list(paper_point),
%!              +Tolerance:number) is semidet.
%
%   True when no shape of Shapes overlaps Shape deeper than Tolerance, 0 or
%   more; how deep is how far one of the two has to be moved to be free.

%!  shape_map_open(+Shapes:list(list(paper_point)), +Near:number,
%!                 -Map:shape_map) is det.
%
%   Map is a handle for convex Shapes on paper, each a list of points X-Y,
%   counter-clockwise, of any number.

%!  shape_at(+Map:shape_map, +Point:paper_point, -I:id) is semidet.
%
%   Shape I, from 1, is the first that has Point: it is right of none of its
%   sides, or not farther than Near times that side. Fails if none has it.

%!  turned_boxes(+Points:list(paper_point), +Degrees:list(number),
%!               -Sizes:list(paper_point)) is det.
%
%   How wide and high, W-H, the box round Points is if they are turned by each
%   of Degrees, counterclockwise.

%!  nest_open(+Outlines:list(list(list(paper_point))), -Nest:nest_outlines)
%!       is det.
%
%   Nest is a handle for pieces with these Outlines, each a list of loops, lists
%   of X-Y. It keeps what nest/8 made of them for the next time.

%!  nest(+Size:paper_point, +Square:number, +Gap:int, +One:bool,
%!       +Nest:nest_outlines, +Turns:list(nest_turn), -Places:list(nest_place),
%!       -Work:integer) is det.
%
%   Lays pieces of Nest on sheets of Size, W-H: for each of Turns,
%   turn(I,Degrees), piece I, from 1, one after the other, on the first sheet
%   that takes it, as low and then as far left as can be, turned by one of the
%   Degrees; on a raster of Square, Gap squares of which at least stay free
%   between pieces.
%   One: there is a single sheet. Each of Places is place(Sheet,Turn,DX,DY): the
%   piece, turned counterclockwise, goes DX,DY; Sheet 0 if it fits on none. Work
%   is how many squares were looked at: a measure of time that is the same
%   everywhere. See c_kernels/pattern/nest.h.
