:- module(sg_kernel,
          [ mesh_add/6,               % +Stream, +Format, +Weld, +One, +S,
                                      % -Result
            raster_dots/4,            % +Width, +Height, +Strokes, -Dots
            raster_png/5,             % +Width, +Height, +Dots, +Palette, -Bytes
            % view4pl.c
            fill_screen/4,            % +Theta, +Phi, +Rho, +Kind
            view_range/5,             % +Theta, +Phi, -Near, -Far, -Reach
            view_depth/5,             % +Theta, +Phi, +Rho, +Kind, -Depth
            sine_cosine/3,            % +Degrees, -Sine, -Cosine
            % scene4pl.c
            scene_open/4,             % +Segments, +Depth, +Tolerance, -Scene
            scene_edge/5,             % +Scene, ?S, ?E, -Length, -Look
            occluder/7,               % +Scene, +S, +E, ?S2, ?T, -From, -To
            overlap/9,                % +Scene, +S, +E, ?S2, ?E2, -From, -To,
                                      % -From2, -To2
            fill_drawn/3              % +Scene, +Which, +Crease
          ]).

:- if(\+ predicate_property(sg_kernel:raster_dots(_,_,_,_), foreign)).
:- use_foreign_library(foreign(sanggwan)).
:- endif.

/** <module> The kernels: every foreign predicate that is not of the store.

The doors to c_kernels/, documented here and nowhere else. A block for each
glue file.
*/

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

/* - - - view4pl.c - - - */

%!  fill_screen(+Theta, +Phi, +Rho, +Kind) is det.
%
%   Replaces screen/5 of the current world by where each vertex is seen from
%   there; Kind is `parallel` or `central`. Computes what eye_point/4 and
%   screen_point/3 of view.pl define. Inexact.
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

/* - - - scene4pl.c - - - */

%!  scene_open(+Segments, +Depth, +Tolerance, -Scene) is det.
%
%   Scene is what screen/5 of the current world shows of Segments, `all` or a
%   list. Depth: see view_depth/5; Tolerance: what counts as equal, in a model
%   of size [-1,1] (PL-5). A scene does not follow later changes, and is freed
%   with its last reference.

%!  scene_edge(+Scene, ?S, ?E, -Length, -Look) is nondet.
%
%   True when the real edge E of segment S stands for all edges between its
%   vertices (PL-13 step 3), and is not the second copy of a penetration line.
%   Length is its length in the picture, standardised. Look is
%   look(Faces,Towards,Away,Left,Right,Bend,Solid,Cut), see role.pl. In order of
%   S and E.

%!  occluder(+Scene, +S, +E, ?S2, ?T, -From, -To) is nondet.
%
%   True when triangle T of segment S2 hides the part of edge E of segment S
%   from From to To (0.0 at its start in the picture, 1.0 at its end), in order
%   of From. A triangle never hides a line in its plane. Triangles seen edge-on
%   and the backs of solids hide nothing. Inexact.
%
%   @error existence_error(drawn_edge, E): scene_edge/5 does not have it
%   @see [PL] section 6.3 step 4, row PL-13

%!  overlap(+Scene, +S, +E, ?S2, ?E2, -From, -To, -From2, -To2) is nondet.
%
%   True when the part of edge E of segment S from From to To lies, in the
%   picture, on the part of edge E2 of S2 from From2 to To2. Inexact.
%
%   @error existence_error(drawn_edge, E)

%!  fill_drawn(+Scene, +Which, +Crease) is det.
%
%   Replaces drawn/7 of the current world by the drawn parts of the lines Which
%   (`all`, `feature`, `penetration`); Crease as in edge_role/5. The fused kernel
%   of hidden_lines.pl.
