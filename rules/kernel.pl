:- module(sg_kernel,
          [ % decision4pl.c
            rule_module/2,            % +Slot, -Module
            set_rule_modules/1,       % +Pairs
            world_number/1,           % -Number
            ended_world/1,            % -Number
            % mesh4pl.c
            mesh_add/6,               % +Stream, +Format, +Weld, +One, +S,
                                      % -Result
            mesh_write/5,             % +Stream, +Format, +Ss, +Names, -Result
            % boundary4pl.c
            boundary_open/7,          % +Ss, +Made, +Single, +Grid, +Form,
                                      % +Copies, -Boundary
            boundary_coarsen/3,       % +Boundary, +Grid, -Coarser
            boundary_close/1,         % +Boundary
            boundary_counts/2,        % +Boundary, -Counts
            boundary_meetings/4,      % +Boundary, +All, +Exact, -Meetings
            boundary_add/2,           % +Boundary, +S
            boundary_write/5,         % +Boundary, +Stream, +Format, +Names,
                                      % -Result
            % census4pl.c
            census/1,                 % -Parts
            census_defect/4,          % ?Kind, ?S, ?A, ?B
            % tree4pl.c, near4pl.c
            tree_statistics/1,        % -Statistics
            kept_leaves/2,            % +Ss, -Kinds
            other_segments/1,         % -Ss
            node_origins/2,           % +S, -Origins
            near_segments/3,          % +Reach, -S1, -S2
            near_segments_of/3,       % +Reach, +Ss, -Near
            self_meetings/2,          % +Most, -Segments
            segment_meets_itself/1,   % +S
            segments_meeting_themselves/2, % +Segments, -Which
            segment_operand/2,        % +S, -Operand
            segment_edges/4,          % +S, +Most, -Counts, -Edges
            windings/3,               % +S, +Points, -Windings
            operand_borders/2,        % +Ss, -Borders
            known_facets/3,           % +Known, +Ss, -Facets
            % roll4pl.c
            surface_place/4,          % +Surface, +Point, -T, -H
            surfaces_meet/4,          % +Surfaces, +Reach, +Point0, -Point
            roll_points/3,            % +Roll, +Places, -Points
            roll_curves/5,            % +Roll, +Reach, +Tolerance, +Curves,
                                      % -Lists
            % leaf4pl.c
            leaves_keep/1,            % +Polygons
            % solid4pl.c
            solid_take/2,             % +Segments, -Solid
            solid_move/3,             % +Solid, +Matrix, -Again
            solid_counts/4,           % +Solid, -Vertices, -Faces, -Triangles
            solid_write/2,            % +Solid, +S
            solid_write_over/2,       % +Solid, +S
            solid_close/1,            % +Solid
            solid_is_closed/1,        % +Solid
            solid_vertices/2,         % +Solid, -Vertices
            solid_faces/2,            % +Solid, -Faces
            solid_parts/2,            % +Solid, -Parts
            % face_merge4pl.c
            solid_merge/3,            % +Solid, +Tolerance, +Options
            solid_neighbours/3,       % +Solid, +Tolerance, -Pairs
            % arrangement4pl.c, arrangement_free4pl.c, arrangement_pieces4pl.c
            arrangement_open/4,       % +Set, +Segments, +Wanted, -Arrangement
            arrangement_hold/1,       % +Arrangement
            arrangement_drop/1,       % +Arrangement
            arrangement_polygons/3,   % +Arrangement, +Works, +Reach
            arrangement_free_polygons/3, % +Arrangement, +Polygons, +Reach
            arrangement_seal/1,       % +Arrangement
            arrangement_components/2, % +Pieces, -Components
            arrangement_select/3,     % +Pieces, +Senses, -Solid
            arrangement_senses/4,     % +Pieces, +Expression, +Open, -Senses
            pieces_kept/1,            % -Kept
            keep_pieces/1,            % +Kept
            % cut4pl.c, seam4pl.c, split4pl.c, line4pl.c
            cut_set_open/2,           % +Pairs, -Set
            cut_set_close/1,          % +Set
            cut_flat_within/2,        % +Set, +Tolerance
            cut_resolve/4,            % +Set, +Reach, -Vertices, -Polygons
            cut_touch/3,              % +Set, +Reach, -What
            cut_candidate/3,          % +Set, -T1, -T2
            curve_candidate/3,        % +Set, -E, -T
            cut_find/1,               % +Set
            cut_side/4,               % +Set, +T1, +T2, -Side
            cut_enter/4,              % +Set, +T1, +T2, -Count
            curve_enter/4,            % +Set, +E, +T, -Count
            cut_triangle/5,           % +Set, +T, -S, -P, -Id
            cut_ends/4,               % +Set, +T1, +T2, -Cuts
            cut_seal/1,               % +Set
            cut_polygons/2,           % +Set, -Polygons
            cut_polygons_of/3,        % +Set, +Segments, -Polygons
            cut_entering/4,           % +Set, +S, +P, -Pieces
            cut_enter_free/4,         % +Set, +S, +P, +Work
            cut_enter_polygons/5,     % +Set, +Polygons, -Works, ?End, -Rest
            cut_work/4,               % +Set, +S, +P, -Work
            cut_crossing/8,           % +Set, +Work, +S, +K, +E, +V1, +V2, -X
            cut_note/5,               % +Set, +S, +V1, +V2, +X
            cut_between/6,            % +Set, +Work, +S, +V1, +V2, -X
            cut_divided/4,            % +Set, +Work, +S, -Divided
            cut_agree/1,              % +Set
            cut_was_divided/1,        % +Set
            cut_late_polygons/2,      % +Set, -Polygons
            cut_joints/3,             % +Set, +How, -Joints
            cut_join/2,               % +Set, +Point
            cut_settle/1,             % +Set
            cut_chains/2,             % +Set, -Chains
            cut_write/4,              % +Set, +S, +P, +Work
            line_chains/1,            % -Chains
            cut_name/4,               % +Set, +Point, +S, -V
            cut_lines/2,              % +Set, -Lines
            cut_line/5,               % +Set, +S, +V1, +V2, -L
            cut_vertices/2,           % +Set, -Vertices
            cut_split_edges/3,        % +Set, +S, -Splits
            raster_dots/4,            % +Width, +Height, +Strokes, -Dots
            raster_png/5,             % +Width, +Height, +Dots, +Palette, -Bytes
            % canvas4pl.c
            canvas_png/6,             % +Width, +Height, +Scale, +Paper, +Lines,
                                      % -Bytes
            % view4pl.c
            fill_screen/4,            % +Theta, +Phi, +Rho, +Kind
            view_range/5,             % +Theta, +Phi, -Near, -Far, -Reach
            view_depth/5,             % +Theta, +Phi, +Rho, +Kind, -Depth
            sine_cosine/3,            % +Degrees, -Sine, -Cosine
            % turn4pl.c
            turn_points/2,            % +Axes, +Origin
            % contour4pl.c
            fill_contour/7,           % +Segments, +Theta, +Phi, +Rho, +Kind,
                                      % +Smooth, +Known
            % scene4pl.c
            scene_open/6,             % +Segments, +Depth, +Tolerance,
                                      % +Smooth, +Known, -Scene
            scene_edge/5,             % +Scene, ?S, ?E, -Length, -Look
            occluder/7,               % +Scene, +S, +E, ?S2, ?T, -From, -To
            overlap/9,                % +Scene, +S, +E, ?S2, ?E2, -From, -To,
                                      % -From2, -To2
            line_covers/4,            % +Scene, +S, +E, -Covers
            fill_drawn/4,             % +Scene, +Which, +Crease, +Through
            % stroke4pl.c
            stroke_looks/2,           % +Parts, -Looks
            stroke_chains/3,          % +Parts, +Looks, -Strokes
            % drawn_stroke4pl.c
            drawn_box/1,              % -Box
            drawn_strokes/5,          % +Place, +Removed, +Looks, +Others,
                                      % -Strokes
            % travel4pl.c
            travel_order/2,           % +Strokes, -Order
            % development4pl.c, development_read4pl.c, development_write4pl.c
            flattening_open/4,        % +S, +Tolerance, +Removed, -Flattening
            flattening_close/1,       % +Flattening
            flattening_counts/4,      % +Flattening, -Faces, -Joints, -Step
            flattening_bent/2,        % +Flattening, -Polygons
            flattening_invalid/2,     % +Flattening, -Polygons
            flattening_joint/3,       % +Flattening, +J, -Joint
            flattening_restart/1,     % +Flattening
            flattening_lay/2,         % +Flattening, +Root
            flattening_measures/2,    % +Flattening, -Measures
            flattening_write/2,       % +Flattening, +D
            edge_joint/3,             % +Flattening, +E, -J
            forbid_joint/2,           % +Flattening, +J
            join_faces/3,             % +Flattening, +J, -Result
            join_all/2,               % +Flattening, +Order
            join_before/3,            % +Flattening, +Order, +J
            exchange_seams/6,         % +Flattening, +Order, +Kept, +Objective,
                                      % +Effort, -Exchanges
            join_folds/2,             % +Flattening, +Joints
            seam_length/2,            % +Flattening, -Length
            flattening_bound/2,       % +Flattening, -Bound
            fold_path/4,              % +Flattening, +P, +Q, -Joints
            joint_order/3,            % +Flattening, +Order, -Joints
            joint_path/3,             % +Flattening, +J, -Joints
            % nest4pl.c
            shapes_open/2,            % +Size, -Shapes
            shapes_add/2,             % +Shapes, +Shape
            shapes_free/3,            % +Shapes, +Shape, +Tolerance
            nest/7,                   % +Size, +Square, +Gap, +One, +Pieces,
                                      % -Places, -Work
            % exact4pl.c
            exact_fallbacks/1,        % -Count
            exact_statistics/1,       % -Statistics
            % complete4pl.c
            fill_triangles/1,         % -Faults
            fill_triangles/2,         % +Ss, -Faults
            segments_tolerance/3,     % +Segments, -Tolerance, -Smallest
            segments_grain/2,         % +Segments, -Grain
            model_tolerance/1,        % -Tolerance
            % work4pl.c, work_join4pl.c
            work_open/3,              % +S, +P, -Work
            work_close/1,             % +Work
            work_add/6,               % +Work, +V1, +V2, +Et, +Label, -E
            work_delete/2,            % +Work, +E
            work_split/5,             % +Work, +E, +V, -E1, -E2
            work_resolve/2,           % +Work, +Reach
            work_gap/2,               % +Work, -V
            work_turn/5,              % +Work, +V1, +V2, +V3, -Turn
            work_edge/6,              % +Work, ?E, ?V1, ?V2, ?Et, ?Label
            work_oldest/4,            % +Work, -E, -V1, -V2
            work_meeting/6,           % +Work, +V1, +V2, ?E, ?How, ?Inside
            work_candidate/4,         % +Work, +V1, +V2, ?V3
            work_triangulate/2,       % +Work, -Triangles
            work_thicken/4            % +Work, +Edges, +Triangles0, -Triangles
          ]).

:- if(\+ predicate_property(sg_kernel:raster_dots(_,_,_,_), foreign)).
:- use_foreign_library(foreign(sanggwan)).
:- endif.

/** <module> The kernels: every foreign predicate that is not of the store.

The doors to c_kernels/, documented here and nowhere else. A block for each
glue file.
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

/* - - - mesh4pl.c - - - */

%!  mesh_add(+Stream, +Format, +Weld, +One, +S, -Result) is det.
%
%   Reads the octets of Stream to its end as Format (`stl`, `off`, `obj`,
%   `ply`, `any`) and adds v/5, e/5 and p/3 of the segments in it, numbered
%   from S. Weld is `auto`, `all` or `none`; One is true for one segment
%   whatever the file names. Result is one of
%
%     - loaded(Parts, Grain, passed_over(Degenerate, Repeated, Welded, Ignored,
%       IgnoredLine, Trailing))
%       Parts are part(S, Kind, Name), Name '' if the file has none; Grain is a
%       unit in the last place of the coordinates, 0.0 if they are exact.
%     - fault(Code, Line, Column, Byte, Text, Wanted, Got, Limit)
%       The file is bad, and nothing was added; see c_kernels/mesh.h.
%
%   @error permission_error(write, segment, S1): one of the segments has rows

%!  mesh_write(+Stream, +Format, +Segments, +Names, -Result) is det.
%
%   Writes the listed segments to Stream as Format (also `stl_binary`,
%   `ply_binary`). Segments ascend; Names are theirs, '' for none. Result is
%   `ok`, no_triangles(S, P): polygon P must be written as triangles and has
%   none (nothing was written), or a fault/8 as of mesh_add/6.

/* - - - boundary4pl.c - - - */

%!  boundary_open(+Segments, +Made, +Single, +Grid, +Form, +Copies, -Boundary)
%!                is det.
%
%   Boundary is a handle for the polygons of the segments in the list, as a file
%   will hold them: coordinates as multiples of Grid (a power of two; 0.0: as
%   they are), then as float32 if Single; without what that has collapsed; in an
%   order that depends on where things are alone. See c_kernels/boundary.h and
%   boundary_mesh.h. Made lists S-V of vertices that cuts made: their
%   coordinates are rounded already. Form is `polygons`, `triangles` or `soup`:
%   the triangles of t/6, also those that rounding turned over, which else are
%   taken out.
%   If Copies, every edge has two faces and every vertex one fan.
%
%   @error representation_error(float32): a coordinate is too large

%!  boundary_coarsen(+Boundary, +Grid, -Coarser) is det.
%
%   Coarser is another handle for Boundary, with the vertices of those triangles
%   that go through each other on multiples of Grid, and what is near these.

%!  boundary_close(+Boundary) is det.

%!  boundary_counts(+Boundary, -Counts) is det.
%
%   Counts = counts(Vertices, Faces, Triangles, Open, Crossing, Touching,
%   Copies, Stuck, Cancelled): Open edges lack an opposite; at Crossing edges
%   four or more faces go through each other, at Touching ones not; Copies
%   vertices were added; for Stuck faces no triangles were found; Cancelled
%   faces lay on each other, back to back.

%!  boundary_meetings(+Boundary, +All, +Exact, -Meetings) is det.
%
%   Meetings are meeting(Kind, X, Y, Z), where triangles go through each other
%   (`self_penetration`) or share some area (`self_overlap`), as self_meetings/2
%   says: exactly if Exact, else beyond the tolerance. Unless All, only those
%   where one of the two is not as the segment has it: rounding, a cut, or
%   dividing a polygon has made it.

%!  boundary_add(+Boundary, +S) is det.
%
%   Add the vertices, edges and polygons of Boundary as segment S, of several
%   segments as S, S+1, ...

%!  boundary_write(+Boundary, +Stream, +Format, +Names, -Result) is det.
%
%   As mesh_write/5.

/* - - - census4pl.c - - - */

%!  census(-Parts) is det.
%
%   Parts counts and measures the segments of the current world, in order:
%   part(S, counts(Vertices, HalfEdges, Edges, Polygons, Triangles, CurveEdges),
%   box(X1,Y1,Z1, X2,Y2,Z2), Area, Volume, Length, Shells, Defects). Shells are
%   shell(P, Vertices, Edges, Polygons, Euler, Closed, Pinched, Area, Volume,
%   Depth), P the lowest polygon, Depth how many other shells of the segment go
%   round it; Defects are Kind-Count of census_defect/4.

%!  census_defect(?Kind, ?S, ?A, ?B) is nondet.
%
%   True when segment S has a defect of this Kind; A and B as
%   c_kernels/census.h says. One pass over the world a call.

/* - - - leaf4pl.c - - - */

%!  leaves_keep(+Polygons:list) is semidet.
%
%   As leaf.pl, leaves_kept_by_rule/1. Fails if one is not there.

/* - - - solid4pl.c - - - */

%!  solid_take(+Segments, -Solid) is det.
%
%   Solid is a new handle of a boundary under way (c_kernels/solid.h): the
%   polygons of Segments as they are in t/6, e/5 and v/5, one face for each that
%   has triangles. Segments are taken in ascending order, each once; vertices of
%   different segments stay apart. The handle is freed by atom garbage
%   collection, or at once by solid_close/1.

%!  solid_move(+Solid, +Matrix, -Again:list) is semidet.
%
%   Put Solid somewhere else: three rows [A,B,C,D] of Matrix give the new
%   coordinates, A*X+B*Y+C*Z+D. If Matrix mirrors, triangles turn round. Again
%   are the numbers, from 1, of faces whose triangles no longer cover them, for
%   rounding turned one over. Fails if a coordinate is larger than v/5 takes;
%   Solid is then good for nothing.

%!  solid_counts(+Solid, -Vertices, -Faces, -Triangles) is det.
%
%   How many Solid has.
%
%   @error type_error(solid, Solid)
%   @error existence_error(solid, Solid): closed

%!  solid_write(+Solid, +S) is det.
%
%   As solid_rows.pl, solid_written_by_rule/2: Solid as rows of segment S. Call
%   it in a transaction.
%
%   @error permission_error(write, segment, S): it has rows

%!  solid_write_over(+Solid, +S) is semidet.
%
%   The rows of segment S, which were a solid's, become those of Solid. What is
%   the same stays with its ids, so ids need not be dense: what is new has the
%   least that are free. Fails if S has other rows than a solid becomes, or most
%   faces are new. Call it in a transaction.
%
%   @see c_kernels/solid_over.h

%!  solid_close(+Solid) is det.
%
%   Frees what Solid holds; it cannot be used any more.

/* - - - face_merge4pl.c - - - */

%!  solid_merge(+Solid, +Tolerance, +Options:list) is det.
%
%   Makes coplanar neighbours in Solid one face each and drops vertices that lie
%   straight (c_kernels/face_merge.h). Options: origins(separate): never faces
%   of different segments; apart(Pairs): never these, as of solid_neighbours/3;
%   by_size(true): a Tolerance no larger than 2^-13 of the size of Solid. Others
%   are ignored.

%!  solid_neighbours(+Solid, +Tolerance, -Pairs:list) is det.
%
%   Pairs are the Part1-Part2 of which faces in Solid are neighbours and may lie
%   in one plane. A part is part(S0, P0, Sense), Sense -1 if the face looks the
%   other way than polygon P0 of S0. Sorted by S0, P0 and Sense, 1 before -1,
%   each pair once, the lesser part first.

/* - - - self4pl.c - - - */

%!  self_meetings(+Most:integer, -Segments:list) is det.
%
%   Where segments go through themselves: Segments has a
%   self(S, Counts, Meetings) for each segment, by number. Counts are
%   Kind-Count, Kind one of self_penetration, self_overlap and self_touching
%   (c_kernels/self_cut.h), a pair of polygons counted once; Meetings are the
%   first Most of each as meeting(Kind, P1, P2, X, Y, Z), P1 =< P2, in the order
%   of the polygons: something they have in common is at X, Y, Z.

/* - - - operand4pl.c - - - */

%!  segments_meeting_themselves(+Segments:list, -Which:list) is det.
%
%   Which are those of Segments, each there once, for which
%   segment_meets_itself/1 is true; ascending. Cheaper than one by one.

%!  segment_meets_itself(+S) is semidet.
%
%   True when the triangles of segment S go through each other or lie on each
%   other, by more than the tolerance of its source; so its own cuts count.
%   What neighbours share does not, and vertices in one place are two. Known
%   afterwards, until the segment changes.

%!  segment_operand(+S, -Operand) is det.
%
%   What a Boolean must know of segment S each time: Operand is
%   operand(Triangles, HalfEdges, Balanced, Volume, Error, Star). Balanced:
%   there are as many half-edges one way as the other between any two vertices.
%   Volume is negative where S is inside out as a whole; by rounding it is off
%   by Error at most, seen from the middle. Star: all of its surface is seen
%   from the middle of its box, so it does not go through itself; `false` says
%   nothing. Known afterwards, until the segment changes.

%!  segment_edges(+S, +Most, -Counts, -Edges) is det.
%
%   The edges of segment S that are no pairs of half-edges: Counts is
%   edges(Open, Unbalanced, Crowded), how many are of one half-edge; of more,
%   and not balanced; balanced, and of more than two. Edges are the first Most
%   of the first two sorts by their vertices, edge(V1, V2, Forward, Backward),
%   V1 < V2 or the same: how many half-edges run from V1 to V2, and back.

/* - - - raster4pl.c - - - */

%!  raster_dots(+Width, +Height, +Strokes, -Dots) is det.
%
%   Dots is a string of Width*Height codes, by rows from the top: the inks that
%   Strokes leave on paper, whose ink is 0. Each is
%   stroke(Ink, PenWidth, Pattern, Points): Ink 0 to 255, the nib PenWidth dots
%   wide; Pattern a list of run lengths on, off, on, off, ... in dots, `[]`: a
%   solid line; Points a list of X-Y, integers, X to the right, Y DOWN. The
%   pattern runs on across joints; a later stroke covers an earlier one; what
%   is outside is left out. Exact: integers only.
%
%   @error domain_error(raster_size, Width-Height), domain_error(pen, Stroke),
%          domain_error(raster_coordinate, X): farther than 2^20
%   @see [PL] section 6.4, row PL-14

%!  raster_png(+Width, +Height, +Dots, +Palette, -Bytes) is det.
%
%   Bytes is a string of the bytes of a PNG file that shows Dots; ink N has the
%   N-th colour of Palette, a list of rgb(Red,Green,Blue), counted from 0.
%
%   @error domain_error(palette, Palette): empty, too long, or too short

/* - - - canvas4pl.c - - - */

%!  canvas_png(+Width, +Height, +Scale, +Paper, +Lines, -Bytes) is det.
%
%   Bytes are a PNG file, Width x Height dots, three bytes each, of Lines with
%   smooth edges on paper of the colour Paper, rgb(R,G,B). Each of Lines is
%   line(RGB, LineWidth, Round, Points): Round is true if its ends are round;
%   Points are X-Y, X to the right, Y DOWN. Lengths are in a unit that is Scale
%   dots, and a thousandth of a millimetre; the file says so. Inexact.
%
%   @error domain_error(raster_size, Width-Height), domain_error(pen_width, W),
%          domain_error(raster_coordinate, X): farther than 2^20 dots

/* - - - view4pl.c - - - */

%!  fill_screen(+Theta, +Phi, +Rho, +Kind) is det.
%
%   Replaces screen/5 of the current world by where each vertex is seen from
%   there; Kind is `parallel` or `central`. Computes what eye_point/4,
%   screen_point/3 and in_one_place/3 of view.pl define.
%
%   @error domain_error(rho, Rho): in a central projection something is not in
%          front of the eye
%   @see [PL] section 6.1 and 6.2, row PL-11

%!  view_range(+Theta, +Phi, -Near, -Far, -Reach) is semidet.
%
%   True when the vertices of the current world have their depth, counted from
%   the origin away from the eye, between Near and Far, and the farthest one
%   is Reach from the origin. Fails if there are no vertices.

%!  view_depth(+Theta, +Phi, +Rho, +Kind, -Depth) is det.
%
%   True when one unit of Zs is Depth model units where the model is nearest:
%   1.0 in a parallel projection.

%!  sine_cosine(+Degrees, -Sine, -Cosine) is det.
%
%   Multiples of 90 degrees are exact; the rest is rounded to 2^-48.

/* - - - turn4pl.c - - - */

%!  turn_points(+Axes:list, +Origin:list) is det.
%
%   Every point of the current world (v/5, leaf_v/5) and every plane goes to
%   where turned_point/4 of view.pl says. Axes are 1, 2 and 3 in some order and
%   with some signs. Exact where Origin is [0,0,0]. Call it in a transaction.
%
%   @error domain_error(axes, Axes), representation_error(coordinate): one
%          would be larger than any that v/5 takes

/* - - - contour4pl.c - - - */

%!  fill_contour(+Segments, +Theta, +Phi, +Rho, +Kind, +Smooth, +Known)
%!      is semidet.
%
%   Replaces contour/9 of the current world by the outlines of the smooth
%   surfaces of Segments, `all` or a list, seen from there, as contour.pl
%   defines them. Smooth is smooth(Crease, Faceted): over which bend, in
%   degrees, two faces do not hang together smoothly; which segments have no
%   smooth surfaces. screen/5 holds the same view. Known are known_surfaces/1,
%   or `kept`: what was known when the model of these segments was made, whose
%   rows have not changed since. Fails if none is kept. Inexact.

/* - - - scene4pl.c - - - */

%!  scene_open(+Segments, +Depth, +Tolerance, +Smooth, +Known, -Scene)
%!      is semidet.
%
%   Scene is what screen/5 and contour/9 of the current world show of Segments,
%   `all` or a list. Smooth is what contour/9 was made with, see fill_contour/7
%   (there Known, too), or edges(Faceted): all outlines run along edges. Depth:
%   see view_depth/5; Tolerance: what counts as equal, in a model of size [-1,1]
%   (PL-5). A scene does not follow later changes, and is freed with its last
%   reference. It is for one thread at a time: what is asked of it is noted in
%   it.

%!  scene_edge(+Scene, ?S, ?E, -Length, -Look) is nondet.
%
%   True when the real edge E of segment S stands for all edges between its
%   vertices (PL-13 step 3), and is not the second copy of a penetration line.
%   Or, if E is negative, that piece -E of contour/9 is there. Length is its
%   length in the picture, standardised. Look is
%   look(Faces,Towards,Away,Left,Right,Bend,Solid,Cut,Inside), see role.pl. In
%   order of S and E.

%!  occluder(+Scene, +S, +E, ?S2, ?T, -From, -To) is nondet.
%
%   True when triangle T of segment S2 hides the part of edge E of segment S
%   from From to To (0.0 at its start in the picture, 1.0 at its end), in order
%   of From. A triangle never hides a line in its plane, nor one that lies on
%   its polygon (lies_on/4 of hidden_lines.pl). Triangles seen edge-on and the
%   backs of solids hide nothing. Inexact.
%
%   @error existence_error(drawn_edge, E): scene_edge/5 does not have it
%   @see [PL] section 6.3 step 4, row PL-13

%!  overlap(+Scene, +S, +E, ?S2, ?E2, -From, -To, -From2, -To2) is nondet.
%
%   True when the part of edge E of segment S from From to To lies, in the
%   picture, on the part of edge E2 of S2 from From2 to To2. Inexact.
%
%   @error existence_error(drawn_edge, E)

%!  line_covers(+Scene, +S, +E, -Covers:list) is det.
%
%   Covers has a covers(S2, T, From, To, Behind1, Behind2) for each triangle T
%   of S2 that hides lines and lies on edge E of S in the picture, from From to
%   To, be it before it or behind. Behind1, Behind2: how far the edge is behind
%   it at these ends, the difference of Zs times screen_depth/1. Nearest
%   triangles first. Inexact.
%
%   @error existence_error(drawn_edge, E)

%!  fill_drawn(+Scene, +Which, +Crease, +Through:list) is det.
%
%   Replaces drawn/7 of the current world by the drawn parts of the lines Which
%   (`all`, `feature`, `penetration`); Crease as in edge_role/5; Through are the
%   S-S2 for which hides(S, S2) is not true. The fused kernel of
%   hidden_lines.pl.

/* - - - stroke4pl.c - - - */

%!  stroke_looks(+Parts:list, -Looks:list) is det.
%
%   Looks are the Visibility-Role that Parts (stroke.pl) have, each once.

%!  stroke_chains(+Parts:list, +Looks:list, -Strokes:list) is det.
%
%   As strokes/2 of stroke.pl: the fused kernel. Looks are look(Visibility,Role,
%   Rank), in standard order, all that Parts have; Rank is their place in
%   painting.

/* - - - drawn_stroke4pl.c - - - */

%!  drawn_box(-Box) is semidet.
%
%   Box is b(X1,Y1,X2,Y2) round the parts that drawn/7 has of edges, in the
%   picture's own coordinates. Fails if there are none.

%!  drawn_strokes(+Place, +Removed, +Looks, +Others:list, -Strokes:list) is det.
%
%   Strokes are those of the parts that drawn/7 has of edges, placed as
%   placed_part/3 of sheet.pl says, and of Others, which are placed; those with
%   the visibility Removed are left out, but not of Others. Looks as for
%   stroke_chains/3. No part is ever a term.
%
%   @error representation_error(look), representation_error(sheet_coordinate)

/* - - - travel4pl.c - - - */

%!  travel_order(+Strokes:list, -Order:list) is det.
%
%   Order has the numbers of Strokes, from 1, in the order of short_travel/2 of
%   travel.pl, those drawn backwards below zero: its fused kernel.

/* - - - nest4pl.c - - - */

%!  shapes_open(+Size, -Shapes) is det.
%
%   Shapes is a handle for convex shapes on paper, none yet, each of them about
%   of this Size (up to a million times as large or small).

%!  shapes_add(+Shapes, +Shape) is det.
%
%   Shape, a list of 2 (a line) to 8 points X-Y in order, is one more.

%!  shapes_free(+Shapes, +Shape, +Tolerance) is semidet.
%
%   True when no shape of Shapes overlaps Shape deeper than Tolerance, 0 or
%   more; how deep is how far one of the two has to be moved to be free.

%!  nest(+Size, +Square, +Gap, +One, +Pieces, -Places, -Work) is det.
%
%   Lays Pieces, each piece(Degrees,Loops), on sheets of Size, W-H: one after
%   the other, on the first sheet that takes it, as low and then as far left as
%   can be, turned by one of the Degrees; on a raster of Square, Gap squares of
%   which at least stay free between pieces. Loops are lists of X-Y. One: there
%   is a single sheet. Each of Places is place(Sheet,Turn,DX,DY): the piece,
%   turned counterclockwise, goes DX,DY; Sheet 0 if it fits on none. Work is how
%   many squares were looked at: a measure of time that is the same everywhere.
%   See c_kernels/nest.h.

/* - - - exact4pl.c - - - */

%!  exact_fallbacks(-Count) is det.
%
%   How many exact decisions have needed integers since the process started,
%   because doubles could not decide.

%!  exact_statistics(-Statistics:dict) is det.
%
%   The same for each predicate of the kernels (c_kernels/exact.h): a dict with
%   `orient2d` and `orient3d`, asked of doubles; `turn`, `side`, `along` and
%   `compare`, asked of derived points too.

exact_statistics(_{orient2d:Orient2d, orient3d:Orient3d, turn:Turn, side:Side,
                   along:Along, compare:Compare}) :-
    '$exact_fallbacks'(Orient2d, Orient3d, Turn, Side, Along, Compare).

/* - - - complete4pl.c - - - */

%!  fill_triangles(-Faults) is det.
%!  fill_triangles(+Ss:list, -Faults) is det.
%
%   Adds plane/6 for every polygon of the current world, or of the segments Ss,
%   that has none, and t/6 for every polygon that has none, in row order;
%   computes what polygon_triangles/3 of triangulation.pl says. Faults is a list
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
%
%   The triangles are exact decisions; planes and Distance are rounded.

%!  model_tolerance(-Tolerance) is det.
%
%   How far off a place may be that is meant to be there: the larger of 2^-33
%   of the model's size, made a power of two (so that an edit seldom changes
%   it), and 4 units in the last place of its coordinates, as
%   far as these show where they come from (single precision, or
%   decimals; whole numbers are exact).

%!  segments_tolerance(+Segments:list, -Tolerance, -Smallest) is det.
%
%   The same for Segments alone: by the size of all of them, and the coarsest
%   source of any. Smallest is the longest side of the smallest one's box.

%!  segments_grain(+Segments:list, -Grain) is det.
%
%   Grain is the part of it that the sources say: 4 units in the last place of
%   the coarsest, where coordinates are seen to be float32 or decimals
%   that are not whole, else 0.

/* - - - work4pl.c, work_join4pl.c - - - */

%!  work_open(+S, +P, -Work) is det.
%
%   Work is a scratch relation with the edges of polygon P, in the order of its
%   list, each labelled with its number. Vertices are named as in v/5, edges
%   are numbered anew from 1. The polygon is seen from outside along the
%   largest component of its normal; all decisions on it are exact. It follows
%   neither the world's changes nor its transactions; it is freed by
%   work_close/1 or with its last reference.
%
%   @error existence_error(polygon, P)

%!  work_close(+Work) is det.
%
%   Frees Work now. Using it afterwards is existence_error(work, Work).

%!  work_add(+Work, +V1, +V2, +Et, +Label, -E) is det.
%
%   Adds the edge V1-V2 as the youngest; Et is 0 or 1, Label any integer of 64
%   bits. Nothing is checked against the other edges.
%
%   @error existence_error(work_vertex, V), domain_error(another_vertex, V2)

%!  work_delete(+Work, +E) is det.
%
%   @error existence_error(work_edge, E)

%!  work_split(+Work, +E, +V, -E1, -E2) is det.
%
%   Replaces E by its pieces to and from V, which lies on it; they keep its Et
%   and label.

%!  work_resolve(+Work, +Reach) is det.
%
%   Makes what touches exactly meet in one vertex: vertices in one place become
%   the first of them, edges with a vertex inside are split there, and opposite
%   edges with the polygon on neither side vanish. Does nothing where all
%   contacts are shared vertices. If Reach is above 0.0, what is nearer than
%   that (model units) is made to touch first.

%!  work_gap(+Work, -V) is semidet.
%
%   True when the polygon does not close at vertex V, the first such.

%!  work_turn(+Work, +V1, +V2, +V3, -Turn) is det.
%
%   Turn is 1 if V1, V2, V3 turn left seen from outside, -1 right, 0 neither.

%!  work_edge(+Work, ?E, ?V1, ?V2, ?Et, ?Label) is nondet.
%
%   True when Work has the edge E from V1 to V2. Oldest first; edges that are
%   added meanwhile are not seen. Given E, or V1 or V2, it looks up.

%!  work_oldest(+Work, -E, -V1, -V2) is semidet.
%
%   The first solution of work_edge/6. Fails if there are no edges.

%!  work_meeting(+Work, +V1, +V2, ?E, ?How, ?Inside) is nondet.
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

%!  work_candidate(+Work, +V1, +V2, ?V3) is nondet.
%
%   True when V3 can be the third vertex of the edge V1-V2: steps (3), 4 (I)
%   and 4 (II) of PL-6 as one join. V3 lies to the left, and no edge meets the
%   closed triangle other than in its corners, or along its sides. Ends of
%   edges leaving V2 first, then starts of edges entering V1, then other
%   vertices, near ones first; each once. Exact. Leaves a choice point: commit
%   to one before you change Work.

%!  work_triangulate(+Work, -Triangles) is det.
%
%   Triangles are terms t(V1, V2, V3), as work_triangles/2 of triangulation.pl
%   finds them one by one: the fused kernel. Uses up the edges; any that are
%   left begin with one that has no third vertex.

%!  work_thicken(+Work, +Edges:list, +Triangles0:list, -Triangles:list) is det.
%
%   If one of Triangles0 is so thin that rounding may have turned it over,
%   chords between them are turned: all sides but those of Edges, the V1-V2 that
%   Work had. What may be turned is decided exactly.

/* - - - tree4pl.c, near4pl.c: trees of boxes - - - */

%!  tree_statistics(-Statistics:dict) is det.
%
%   What the current world keeps for joins: a dict with its `trees` (one for
%   each segment that was joined and has not changed since), their `leaves`
%   (triangles, or edges of curves) and `bytes`, and how many were `grown` and
%   how many `found` there since the world was made.

tree_statistics(_{trees:Trees, leaves:Leaves, bytes:Bytes,
                  grown:Grown, found:Found}) :-
    '$tree_statistics'(Trees, Leaves, Bytes, Grown, Found).

%!  kept_leaves(+Ss:list, -Kinds:list) is det.
%
%   Kinds are those of the segments Ss, in order: the kind, as segment/3 has it,
%   of one that is a primitive and has the rows that were made from it, by its
%   record (made_and_kept/2); `other` for the others.

%!  other_segments(-Ss:list) is det.
%
%   Ss are the segments of which kept_leaves/2 says `other`, in the order of the
%   rows of segment/3.

%!  node_origins(+S, -Origins:list) is det.
%
%   Origins are Item-Origin of all origin(S, Item, Origin) with an Item node(_),
%   in the order of their rows.

%!  near_segments(+Reach, -S1, -S2) is nondet.
%
%   True when S1 and S2, S1 < S2, are segments whose boxes (round their
%   vertices) overlap or are not farther apart than Reach along each axis.
%   Ascending, as they are at the first call. Found by a tree of boxes: the
%   other pairs are not looked at.

%!  known_facets(+Known, +Ss:list, -Facets:list) is det.
%
%   Facets has known(S, Surfaces, Runs), as of known_surfaces/1, for each of the
%   segments Ss that has polygons which are facets of surfaces, by what Known,
%   of known_surfaces/1, says of it, or of those its polygons came from
%   (from_p/5). Surfaces are in the order of their first facets. The fused
%   kernel of segment_facets/3 (known_surface.pl). Inexact where they are moved.

%!  near_segments_of(+Reach, +Ss:list, -Near:list) is det.
%
%   Near has S-Others for each of the segments Ss, each once, ascending: Others
%   are those of Ss that near_segments/3 has with S, ascending.

%!  operand_borders(+Ss:list, -Borders:list) is det.
%
%   Borders are border(S, P, V1, V2, Q), ascending by S, V1, V2: S is one of the
%   results Ss, its polygon P has the edge from V1 to V2, V1 < V2, and Q its
%   opposite, and they are parts of operands (from_p/5), of no common one. The
%   fused kernel of operands_meet/2 (csg_roots.pl).

%!  solid_is_closed(+Solid) is semidet.
%
%   True when every edge of its triangles runs as often back as there.

%!  solid_vertices(+Solid, -Vertices:list) is det.
%!  solid_faces(+Solid, -Faces:list) is det.
%!  solid_parts(+Solid, -Parts:list) is det.
%
%   What is in a solid: vertex(V, X, Y, Z, From), V from 1, From S0-V0 or
%   made(Origin); face(S0, P0, Sense, Triangles), Sense -1 if it looks the other
%   way than polygon P0, with its t(V1, V2, V3, Auxiliary), where bit 0 of
%   Auxiliary is for the edge V1-V2, and so on; and after merging
%   part(Face, S0, P0, Sense), Face from 1.

%!  arrangement_open(+Set, +Segments:list, +Wanted:list, -Arrangement) is det.
%!  arrangement_polygons(+Arrangement, +Works:list, +Reach) is det.
%!  arrangement_seal(+Arrangement) is det.
%!  arrangement_hold(+Arrangement) is det.
%!  arrangement_drop(+Arrangement) is det.
%
%   The segments Wanted, which are among Segments, in pieces along the lines of
%   cut set Set, which is sealed. Polygons that were entered are told with what
%   they became, as work(S, P, Work), all at once; what touches within Reach is
%   made one where nothing else helps. Sealing finds what hangs together, and on
%   which side of each segment that is; then the set, and what else it was made
%   from, is let go. An arrangement is held once when it is opened, and closed
%   when it is dropped as often as it was held.
%
%   @error permission_error(fill, arrangement, Arrangement): it is sealed, or
%          sealing it was stopped

%!  arrangement_free_polygons(+Arrangement, +Polygons:list, +Reach) is semidet.
%
%   What arrangement_polygons/3 does after enter_polygons/4 of entering.pl, for
%   all of the polygons S-P together, many at a time. Fails, and nothing is
%   taken in, if a line meets anything in one of them, or one cannot be
%   triangulated.
%
%   @error existence_error(polygon, P)

%!  arrangement_components(+Pieces:list, -Components:list) is det.
%!  arrangement_select(+Pieces:list, +Senses:list, -Solid) is det.
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
%   @see c_kernels/arrangement.h; rows CB-3 and CB-4

%!  arrangement_senses(+Pieces:list, +Expression, +Open:list,
%!                     -Senses:list) is det.
%
%   The fused kernel of boolean.pl, stays/3: Senses are the C-Sense of the
%   components that stay in the boundary of Expression; Open are the segments
%   among its leaves that are surfaces.

%!  pieces_kept(-Kept) is semidet.
%!  keep_pieces(+Kept) is det.
%
%   Kept is the term that was kept last with the current world (arrangement.pl),
%   a copy. What it holds, arrangements too, lives as long.

%!  windings(+S, +Points, -Windings) is det.
%
%   How often the triangles of segment S go round each point(X, Y, Z) of the
%   list, `on` if it lies on one. Numbers of any sort count exactly. Exact.
%   @see winding.h

/* - - - roll4pl.c: cylinders and cones unrolled - - -

A surface is a term of primitive_face.pl, or plane(Nx, Ny, Nz, D): Nx*X + Ny*Y +
Nz*Z + D = 0. A roll is roll(Surface, Layer, Start): a cylinder or a cone (but
one with K = 1) is unrolled from the generator at Start, as it is Layer outside
the drawn surface. Degrees; see roll.h.
*/

%!  surface_place(+Surface, +Point, -T, -H) is det.
%
%   T (-180..180) and H are the parameters of the point of Surface, a cylinder,
%   cone or ruled surface, that Point is taken to: from the axis, at its H.

%!  surfaces_meet(+Surfaces, +Reach, +Point0, -Point) is semidet.
%
%   Point is a point near Point0 on all of one to three Surfaces. Fails if
%   there is none within Reach, or they touch there. Rounded.

%!  roll_points(+Roll, +Places, -Points) is det.
%
%   Where the points of the surface at Places, a list of T-H, are unrolled:
%   Points is the list of X-Y. T is at most about a turn from the start.

%!  roll_curves(+Roll, +Reach, +Tolerance, +Curves, -Lists) is det.
%
%   Points on Curves between their ends, so many that no chord is farther than
%   Tolerance from the unrolled curve. A curve is curve(T0, Surfaces, From, To):
%   where one to three Surfaces meet, from one point to another, not farther
%   than Reach from the line between them. Each list has place(T, H, X, Y), T
%   within half a turn of T0.

/* - - - cut4pl.c: cut sets, the cuts of one penetration - - - */

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

%!  cut_flat_within(+Set, +Tolerance) is det.
%
%   Polygons whose vertices are no farther off their planes than four times
%   Tolerance, or the tolerance of the model as it is now, have no folds in Set.
%   Say it before the first cut is found. Of others the chords between triangles
%   divide lines, as real edges do: the polygon keeps its shape.

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

%!  cut_touch(+Set, +Reach, -What) is det.
%
%   Does what cut_resolve/4 says, as resolve.pl, resolve_contacts_by_rule/2
%   would: What is `changed`. It is `same` if there is nothing to do, else
%   wide(S, V) or stuck(S, P), and nothing was done. After an exception some of
%   it may be: call it in a transaction.

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
%   length. In a common plane only pieces of real edges count, no chords.
%   Exact.

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
%   in penetration.pl, triangle_cut/5. Exact; changes nothing.

/* - - - seam4pl.c, split4pl.c: cuts into polygons - - - */

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

%!  cut_was_divided(+Set) is semidet.
%
%   True when an edge or a piece was divided while others were entered.

%!  cut_work(+Set, +S, +P, -Work) is det.
%
%   Work is a new scratch relation (work4pl.c) with the edges of polygon P,
%   labelled with their numbers, divided at the points of cuts on them; it
%   also knows the vertices of cut_entering/4.
%
%   @error existence_error(polygon, P)

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

%!  cut_agree(+Set) is det.
%
%   Divides the pieces at all points noted, and the real edges they run along.

%!  cut_late_polygons(+Set, -Polygons) is det.
%
%   Polygons is the list of S-P, in no order, maybe repeated, that have a real
%   edge which cut_agree/1 divided.

/* - - - line4pl.c: lines - - - */

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

%!  cut_chains(+Set, -Chains) is det.
%
%   Chains is the list of chain(S1, S2, Kind, Points, Polygons), as in
%   penetration.pl, penetration_chains/2, of the pieces that Set has now.

%!  cut_write(+Set, +S, +P, +Work) is semidet.
%
%   As cut_rows.pl, write_polygon_by_rule/2, for polygon P of S, whose edges
%   are in Work, after cut_lines/2. Fails, and has changed nothing, if these
%   edges cannot be triangulated as they are.

%!  line_chains(-Chains) is det.
%
%   As chain.pl, chains_by_rule/1.

%!  cut_split_edges(+Set, +S, -Splits) is det.
%
%   Splits is the list of split(V1, V2, Vs): edges of S and the vertices on
%   them, in order from V1 to V2.

/* - - - development4pl.c, development_read4pl.c, development_write4pl.c: laying
         flat - - - */

%!  flattening_open(+S, +Tolerance, +Removed:list, -Flattening) is det.
%
%   Flattening is a handle on segment S being laid flat, without the polygons
%   Removed: its faces, each in a frame of its own, and its joints, numbered
%   from 1. A face is a polygon no vertex of which is farther than Tolerance
%   from its plane, or a triangle of another polygon; such a triangle is called
%   by the polygon that it will be, numbered on from those of S, and its chords
%   are edges, numbered on likewise. S should have its triangles. To be closed.
%
%   @error representation_error(int32): no numbers are left for these

%!  flattening_close(+Flattening) is det.

%!  flattening_counts(+Flattening, -Faces, -Joints, -Step) is det.
%
%   How many faces and joints there are. What differs by less than Step (model
%   units) is mostly equal for joint_order/2: it is rounded to that.

%!  flattening_bent(+Flattening, -Polygons:list) is det.
%
%   Polygons, ascending, are not flat.

%!  flattening_invalid(+Flattening, -Polygons:list) is det.
%
%   Polygons, ascending, have an area and no triangles: they cross themselves.

%!  flattening_joint(+Flattening, +J, -Joint) is det.
%
%   Joint is joint(E1, E2, P1, P2, Length, p(X,Y,Z), Angle, Kind, State): edge
%   E1 of polygon P1 and its partner E2 of P2, E1 < E2, the length and the
%   middle of them, the angle as in joint/6. Kind is `line` (P1 is P2), `flat`
%   or `bent`. State is `open`, `joined`, `same_piece`, `overlap`, `forbidden`,
%   `point`, or, after flattening_lay/2, `closed`.
%
%   @error existence_error(joint, J)

%!  flattening_restart(+Flattening) is det.
%
%   Nothing is joined, as at first; what is forbidden stays so.

%!  flattening_lay(+Flattening, +Root) is det.
%
%   Finds where everything lies, as joined by now, see lay.h. Root is a polygon,
%   or 0. Joints whose sides lie on each other become `closed`.
%
%   @error existence_error(polygon, Root)

%!  flattening_measures(+Flattening, -Measures) is det.
%
%   Measures is measures(Seam, Pieces, Longest, Area, Boxes, Tests, Refused),
%   see measure.h: after flattening_lay/2. Tests is how many
%   triangles were tested against each other, Refused how many joints would
%   have made an overlap.
%
%   @error permission_error(lay, flattening, Flattening)

%!  flattening_write(+Flattening, +D) is det.
%
%   Writes the rows of the pattern D, which has none: v e p plane t piece joint
%   from_v from_p, after flattening_lay/2.
%
%   @error permission_error(write, segment, D)

%!  edge_joint(+Flattening, +E, -J) is semidet.
%
%   Joint J has edge E.

%!  forbid_joint(+Flattening, +J) is det.
%
%   Joint J is not to be joined.
%
%   @error permission_error(forbid, joint, J): it is joined already

%!  join_faces(+Flattening, +J, -Result) is det.
%
%   Tries to join the two faces of joint J: `joined`; `same_piece`: they hang
%   together already; overlap(P1, P2): it would lay polygon P2 on P1;
%   `forbidden`; `point`: the edge has no length.

%!  join_all(+Flattening, +Order) is det.
%!  join_before(+Flattening, +Order, +J) is det.
%
%   join_faces/3 for all joints that are open, as joint_order/3 has them; for
%   those before joint J. With order 0, join_all/2 is the fused kernel of
%   development.pl, joined_by_rule/2.

%!  joint_order(+Flattening, +Order, -Joints:list) is det.
%
%   All joints; those that are flat come first. Order 0 is the default of
%   join_order/3; 1: those that bend least; 2: those that run up and down; 3 and
%   on: as 0, but with lengths changed by up to a tenth, by chance.

%!  joint_path(+Flattening, +J, -Joints:list) is det.
%
%   The joints that are joined on the way from one face of J to the other, []
%   if there is no way.

/* - - - seam_exchange4pl.c: folds exchanged - - - */

%!  exchange_seams(+Flattening, +Order, +Kept:list, +Objective, +Effort,
%!                 -Exchanges) is det.
%
%   What is joined, in the order of joints Order, is exchanged for folds that
%   leave less seam, see seam_exchange.h; the joints Kept stay folds. Objective
%   is `seam`, or `pieces`: fewer of them is worth any seam. Effort is about how
%   many faces may be laid or moved for that. Exchanges is how many have helped.
%   The fused kernel of development_search.pl, exchanged_by_rule/5.

%!  join_folds(+Flattening, +Joints:list) is det.
%
%   Restarts and joins just Joints, as they were joined before: nothing is asked
%   about overlaps.
%
%   @error existence_error(joint, Joints)

%!  seam_length(+Flattening, -Length) is det.
%
%   The length of all joints that are neither joined nor have sides that lie on
%   each other all the same, as joined by now; model units.

%!  flattening_bound(+Flattening, -Bound) is det.
%
%   Bound is bound(Least, By, Tree): no seam is less than Least, as is proven by
%   `tree`, `forest` or `moats`; Tree is the minimum spanning tree of the
%   vertices. Model units; see seam_bound.h.

%!  fold_path(+Flattening, +P, +Q, -Joints:list) is det.
%
%   The joints that are joined on the way between polygons P and Q of the
%   pattern, [] if there is no way.
%
%   @error existence_error(polygon, P)
