:- module(sg_kernel_world, []).
:- sg_kernel:export_doors.

/** <module> What the world is: its rules, triangles, tolerances, trees, census.

Foreign predicates; see kernel.pl.
*/

/* - - - decision4pl.c - - - */

%!  rule_module(+Slot, -Module) is semidet.
%
%   True when the current world follows a rule file, loaded into Module, that
%   replaces the decision with this Slot. Fails too where there is no world.

%!  set_rule_modules(+Pairs) is det.
%
%   Replace all slots of the current world by those of Pairs, a list of
%   Slot-Module, in one step.

%!  world_number(-Number) is det.
%
%   Number names the current world; no other world of this process has it or
%   ever had it.

%!  ended_world(-Number) is semidet.
%
%   True when the world Number had set_rule_modules/1 called for it and has
%   ended. Each call of set_rule_modules/1 is reported once.

/* - - - fill_rows.c - - - */

%!  fill_triangles(+Ss:segments_asked, +Contacts:count,
%!                 -Faults:list(fault_fact)) is det.
%
%   Adds plane/6 for every polygon of the segments Ss, a list, or `all`,
%   that has none, and t/6 for every polygon that has none, in row order;
%   computes what tests/oracle/triangulation.pl says. Faults is a list
%   of fault(S, P, What) in the order of the polygons, What being
%
%     - not_closed(V)
%       more edges end in vertex V than start there, or fewer: no plane, no
%       triangles
%     - no_area
%       no plane, no triangles
%     - not_simple(V1, V2)
%       the edge V1-V2 has no third vertex (PL-6): no triangles
%     - not_flat(Distance)
%       a vertex is that far off the plane, more than the model's precision
%       explains; the triangles are used all the same
%     - folded
%       not flat either: along its normal its triangles cover each other
%     - tangled
%       it touches or crosses itself so often that more than Contacts looks at
%       edges would be needed, beyond those that its size asks for: no triangles
%
%   The triangles are exact decisions; planes and Distance are rounded.

%!  untriangulated_segments(-Ss:list(id)) is det.
%
%   Ss are the segments of segment/3 that have polygons and not one triangle,
%   ascending.

/* - - - shape_rows.c - - - */

%!  shape_write(+S:id, +Points:list(point), +Chains:list(list(int)),
%!              +Closed:bool) is semidet.
%
%   Adds Points as the vertices of segment S, and Chains as its polygons, vertex
%   lists as of polygon_list.pl; if Closed is false, as runs of edges from each
%   vertex to the next. All numbers go from 1. Fails, and adds nothing, if one
%   of Chains is no polygon (polygon_fault/2).
%
%   @error domain_error(coordinate, D),
%          permission_error(write, segment, S): it has rows

/* - - - bezier_grid_rows.c - - - */

%!  bezier_grid(+Controls:list(number), +N:count,
%!              -Points:list(space_point), -Turned:list(int)) is det.
%
%   Points, p(X,Y,Z), are those of the Bezier patch with these 16 control points
%   (48 numbers) at u = I/N, v = J/N, row by row, I from 0 to N in each; exact,
%   and rounded once. Turned is for each cell, row by row, 1 where the diagonal
%   from its first corner is the longer one, else 0; exact.
%
%   @error domain_error(patch, Controls), domain_error(facets, N)

/* - - - tolerance_rows.c - - - */

%!  model_tolerance(-Tolerance:number) is det.
%
%   What is nearer than this is in one place: the larger of 2^-44 of the
%   farthest coordinate, made a power of two (so that an edit seldom changes
%   it), and 7/8 of a unit in the last place of the coarsest source
%   (segment_grain/2).

%!  segments_tolerance(+Segments:set(id), -Tolerance:number,
%!                     -Smallest:number) is det.
%
%   The same for Segments alone. Smallest is the longest side of the smallest
%   one's box.

%!  segment_grain(+S:id, -Grain:number) is det.
%
%   Grain is a unit in the last place of the source of segment S, in model
%   units, as origin(S, s(S), source(Grain)) says; 0.0: doubles.

/* - - - exact_rows.c - - - */

%!  exact_fallbacks(-Count:count) is det.
%
%   How many exact decisions have needed integers since the process started,
%   because doubles could not decide.

%!  exact_statistics(-Statistics:exact_counts) is det.
%
%   The same for each predicate of the kernels (c_kernels/number/exact.h): a
%   dict with `orient2d` and `orient3d`, asked of doubles; `turn`, `side`,
%   `along` and `compare`, asked of derived points too.

/* - - - leaf_rows.c - - - */

%!  leaves_keep(+Polygons:list(segment_polygon)) is semidet.
%
%   As leaf.pl, leaves_kept/1. Fails if one is not there.

/* - - - border_rows.c - - - */

%!  segment_borders(+S:id, -Es:list(id)) is det.
%
%   Es are the edges of polygons of segment S that no other edge of one runs
%   along, ascending: its border_edge defects (census_defect/4), at the cost of
%   S alone, whatever else changed in the world.

/* - - - census_rows.c - - - */

%!  census(-Parts:list(census_part)) is det.
%
%   Parts counts and measures the segments of the current world, in order:
%   part(S, counts(Vertices, HalfEdges, Edges, Polygons, Triangles, CurveEdges),
%   box(X1,Y1,Z1, X2,Y2,Z2), Area, Volume, Length, Shells, Defects). Shells are
%   shell(P, Vertices, Edges, Polygons, Euler, Closed, Pinched, Area, Volume,
%   Depth), P the lowest polygon, Depth how many other shells of the segment go
%   round it; Defects are Kind-Count of census_defect/4.

%!  census_part(?S:int, -Part:census_part) is nondet.
%
%   Part is what census/1 says of segment S.

%!  census_shell(?S:int, ?P:int, -Shells:count, -Shell:census_shell) is nondet.
%
%   Shell, of census/1, is one of the Shells that segment S has, P its lowest
%   polygon.

%!  census_defect(?Kind:defect_kind, ?S:int, ?A:int, -B:int) is nondet.
%
%   True when segment S has a defect of this Kind; A and B as
%   c_kernels/model/census.h says. One pass over the world, which is kept
%   until a row changes (c_kernels/rows/census_kept_rows.h): then they are
%   looked up.

/* - - - tree_rows.c - - - */

%!  tree_statistics(-Statistics:tree_counts) is det.
%
%   What the current world keeps for joins: a dict with its `trees` (one for
%   each segment that was joined and has not changed since), their `leaves`
%   (triangles, or edges of curves) and `bytes`, and how many were `grown` and
%   how many `found` there since the world was made.

%!  trees_dropped is det.
%
%   The current world keeps no trees: there is room for what comes, and the next
%   join grows them again.

/* - - - near_rows.c - - - */

%!  near_segments(+Reach:number, ?S1:id, ?S2:id) is nondet.
%
%   True when S1 and S2, S1 < S2, are segments whose boxes (round their
%   vertices) overlap or are not farther apart than Reach along each axis.
%   Ascending, as they are at the first call. Found by a tree of boxes: the
%   other pairs are not looked at. Segments with more than 16 such others, as
%   long thin ones askew may have, are looked at in boxes along their own axes
%   too; two that are plainly apart so are not near. Where most segments have
%   so many others, as in each other, those are near whose triangles come as
%   near as 512 times Reach, unless that is so of very many triangles, as in one
%   place. Two curves are not near, for they do not cut each other: many may
%   come from one point.

%!  near_pairs(+Reach:number, +Ss:set(id), -Pairs:list(id_pair)) is det.
%
%   Pairs are the S1-S2 that near_segments/3 has of the segments Ss.

%!  near_segments_of(+Reach:number, +Ss:set(id),
%!                   -Near:list(near_others)) is det.
%
%   Near has S-Others for each of the segments Ss, each once, ascending: Others
%   are those of Ss whose boxes are near that of S, as of near_segments/3,
%   ascending: also those in S, and of curves the near curves.
