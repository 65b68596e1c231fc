:- module(sg_kernel_shading, []).
:- sg_kernel:export_doors.

/** <module> Shaded pictures, scan line by scan line.

Foreign predicates; see kernel.pl. Axes of a picture: x to the right and y DOWN,
in dots from its upper left corner; z away from the eye. Matrix has 16 numbers,
row by row: a point (X, Y, Z, 1) of the model is seen at Matrix times it,
divided by the fourth coordinate.

Leaves are, each with its Number, which several may have:

    flat(Number, Points, Surfaces, Polygons)
                                      polygon(Face, Surface, Loops): loops of
                                      places in Points, from 1,
                                      counter-clockwise seen from outside, holes
                                      clockwise; it has the normals of the one
                                      of Surfaces (known_surface.pl) for which
                                      it stands, 0: its own
    round(Number, Pieces)             piece(Kind, Frame, K, Low, LowFace, High,
                                      HighFace, Face): what is bounded by the
                                      surface of Kind `sphere` or `tapered` and
                                      Frame (known_surface.pl), K its taper, and
                                      by the planes h = Low and h = High; a face
                                      0 is where another piece goes on, -1 says
                                      that it is not bounded there
    ring(Number, Frame, K, Face)      a torus of Frame and K, made of facets
                                      for the picture, with its own normals
    net(Number, Patches)              patch(Controls, Face): a bicubic Bezier
                                      patch, its 16 control points (48 numbers),
                                      made of facets for the picture, with its
                                      own normals; seen from both sides
    rows(Number, S, Map)              the triangles of segment S, its polygons
                                      being the faces, where Map brings them:
                                      12 numbers, X' = A*X + B*Y + C*Z + D, ...
*/

/* - - - shading_rows.c - - - */

%!  shading_open(+Frame:shading_frame_fact, +Leaves:list(shading_leaf_fact),
%!               +Roots:list(shading_root_fact), -Scene:shading) is det.
%
%   Scene is the picture of Roots. Frame is frame(Matrix, Width, Height,
%   Tolerance): the size in dots; what is nearer in depth than Tolerance dots is
%   in one place. Each root(S, Nodes) is segment S: Nodes are
%   node(Operation, Count), each before its operands, and node(leaf, Place),
%   Place that of a leaf in Leaves, from 1; each leaf comes once.
%
%   @error geometry_error(leaf_behind_eye(Number)): a leaf is not in front of
%          the eye

%!  shading_box(+Frame:shading_frame_fact, +Leaves:list(shading_leaf_fact),
%!              -Box:shading_box_fact) is semidet.
%
%   Box is box(X1,Y1,Z1,X2,Y2,Z2) round all Leaves, in the picture. Fails if
%   they have no faces.
%
%   @error as shading_open/4

%!  shading_spans(+Scene:shading, +Y:number, -Spans:list(shading_span)) is det.
%
%   Spans are span(X1, X2, Root, Leaf, Face) from left to right: what is seen on
%   the line Y (dots), X1 and X2 in 1/256 dot.
%
%   @error domain_error(scan_line, Y): not in the picture

%!  shading_layers(+Scene:shading, +Y:number, +Opacities:list(number),
%!                 +Leaves:list(list(count)),
%!                 -Layers:list(shading_layer)) is det.
%
%   Layers are layer(X1, X2, Root, Leaf, Face, Part): what is seen on the line Y
%   where faces are see-through, Part of the light there being that face's.
%   Opacities are how opaque looks are, 0 to 1. Leaves has for leaf 1, 2, ... of
%   Scene the places of looks, from 0: first that of the leaf, then those of its
%   faces 1, 2, ..., as many as differ. At each face where a root begins or ends
%   as much of the light is its own as it is opaque, and the rest comes from
%   behind. Where a face is opaque nothing behind it is seen.
%
%   @error domain_error(scan_line, Y), domain_error(opacity, Opacities),
%          domain_error(shading_look, Leaves)

%!  shading_point(+Scene:shading, +X:number, +Y:number, -Span:shading_span,
%!                -Depth:number, -Normal:vector) is semidet.
%
%   True when Span is seen at (X, Y), in dots, so deep, on a side that looks
%   along the unit vector Normal, in the axes of the model.
%
%   @error domain_error(scan_line, Y)

%!  shading_place(+Scene:shading, +X:number, +Y:number, +Depth:number,
%!                -Place:point) is det.
%
%   Place is the point of the model that is seen at (X, Y), in dots, when it is
%   Depth dots deep.

%!  shading_size(+Scene:shading, -Width:count, -Height:count) is det.
%
%   The size of Scene in dots.

%!  shading_slices(+Scene:shading, +Y:number,
%!                 -Slices:list(shading_slice)) is det.
%
%   Slices are slice(Place, Face, Sense, X1, X2, Depth), what the faces of leaf
%   Place have in common with the plane of the line Y, in no order. Sense is 1
%   where the line of sight enters, -1 where it leaves the leaf, 0 unknown.
%   X1, X2 in 1/256 dot. Depth is line(X0, A, B): A + B*T with T = X - X0; or
%   arc(Sign, X0, A, B, E, F, G): A + B*T + Sign*sqrt(max(0, E*T*T + F*T + G));
%   or ring(Root, Roots, X0, Z0, Size, Low, High, Forms): Z0 + Size*Z, where Z
%   is that Root, from 1, of the real Roots of A*A - 4*B*W, and Forms are six
%   numbers each of A, B and W: of T*T, T*Z, Z*Z, T, Z and 1. T is
%   (X - X0)/Size, and between Low and High.
%
%   @error domain_error(scan_line, Y)

/* - - - owner_rows.c - - - */

%!  shading_ask_owners(+Scene:shading) is det.
%
%   From here on Scene notes the groups of faces of one root that lie in one
%   another where the root begins, or ends.

%!  shading_let_through(+Scene:shading, +Pairs:list(shading_pair)) is det.
%
%   From here on, of each Front-Behind of Pairs, segments of roots of Scene, the
%   first one does not hide the second one.

%!  shading_groups(+Scene:shading, -Groups:list(shading_group)) is det.
%
%   Groups are group(Root, Begins, Faces), in no order: those that were met in
%   Scene and have no answer yet. Faces are Leaf-Face, two or more. The first
%   one is seen until there is an answer. [] if Scene does not note them.

%!  shading_owners(+Scene:shading, +Owners:list(count)) is det.
%
%   Answers the first ones of the groups of shading_groups/2: for each which of
%   its faces is seen, from 0.
%
%   @error domain_error(shading_owners, Owners): there is no such group or face

/* - - - scan_rows.c - - - */

%!  shading_scan(+Scene:shading, +Lines:count, +Opacities:list(number),
%!               +Leaves:list(list(count)), -Scan:scan) is det.
%
%   Scan has the spans of all lines of Scene, Lines to a dot. Opacities and
%   Leaves are as for shading_layers/5.
%
%   @error domain_error(shading_lines, Lines), and those of shading_layers/5

%!  fill_spans(+Scan:scan, +Segments:list(int)) is det.
%
%   Replaces span/7 of the current world by those of Scan. Segments are those of
%   leaf 1, 2, ... of its scene, 0: of none.
%
%   @error domain_error(shading_segments, Segments): too few

/* - - - depth_buffer_rows.c - - - */

%!  shading_depth_pfm(+Scene:shading, +Plane:list(number),
%!                    +Stream:output) is det.
%
%   Writes how deep what is seen in the middle of each dot of Scene is, as a PFM
%   file (floats, rows from below): A*X + B*Y + C*Z + D of its place, Plane
%   being
%   [A, B, C, D]; infinite where nothing is seen.
%
%   @error domain_error(plane, Plane)

%!  shading_normal_pfm(+Scene:shading, +Stream:output) is det.
%
%   The same of unit normals, in the axes of the model: three floats a dot, 0
%   where nothing is seen.
