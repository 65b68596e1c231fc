:- module(sg_kernel_drawing, []).
:- sg_kernel:export_doors.

/** <module> From vertices to ink: views, outlines, scenes, strokes, dots.

Foreign predicates; see kernel.pl.
*/

/* - - - view_rows.c - - - */

%!  fill_screen(+Theta:number, +Phi:number, +Rho:number,
%!              +Kind:projection) is det.
%
%   Replaces screen/5 of the current world by where each vertex is seen from
%   there; Kind is `parallel` or `central`. Computes what eye_point/4,
%   screen_point/3 and in_one_place/3 of view.pl define.
%
%   @error domain_error(rho, Rho): in a central projection something is not in
%          front of the eye
%   @see [PL] section 6.1 and 6.2, row PL-11

%!  view_range(+Theta:number, +Phi:number, -Near:number, -Far:number,
%!             -Reach:number) is semidet.
%
%   True when the vertices of the current world have their depth, counted from
%   the origin away from the eye, between Near and Far, and the farthest one
%   is Reach from the origin. Fails if there are no vertices.

%!  view_depth(+Theta:number, +Phi:number, +Rho:number, +Kind:projection,
%!             -Depth:number) is det.
%
%   True when one unit of Zs is Depth model units where the model is nearest:
%   1.0 in a parallel projection.

%!  sine_cosine(+Degrees:number, -Sine:number, -Cosine:number) is det.
%
%   Multiples of 90 degrees are exact; the rest is rounded to 2^-48.

/* - - - turn_rows.c - - - */

%!  turn_points(+Axes:list(int), +Origin:list(number)) is det.
%
%   Every point of the current world (v/5, leaf_v/5) and every plane goes to
%   where turned_point/4 of view.pl says. Axes are 1, 2 and 3 in some order and
%   with some signs. Exact where Origin is [0,0,0]. Call it in a transaction.
%
%   @error domain_error(axes, Axes), representation_error(coordinate): one
%          would be larger than any that v/5 takes

/* - - - contour_rows.c - - - */

%!  fill_contour(+Segments:chosen_segments, +Theta:number, +Phi:number,
%!               +Rho:number, +Kind:projection, +Smooth:smoothness,
%!               +Known:known_model) is semidet.
%
%   Replaces contour/13 and surface_facing/6 of the current world by the
%   outlines of the smooth surfaces of Segments (`all` or a list), seen from
%   there, and by the lines of which a surface says otherwise than its triangles
%   whether they face the eye. contour.pl defines both. Smooth is smooth(Crease,
%   Faceted): two faces that bend by more than Crease degrees are no smooth
%   surface, and the segments Faceted have none. screen/5 holds the same view.
%   Known is known_surfaces/1, or `kept`: what was known when the model of these
%   segments was made, whose rows have not changed since.
%   Fails if none is kept. Inexact.

/* - - - scene_rows.c - - - */

%!  scene_open(+Segments:chosen_segments, +Depth:number, +Tolerance:number,
%!             +Smooth:drawn_outlines, +Lines:scene_lines, +Known:known_model,
%!             -Scene:scene) is semidet.
%
%   Scene is what screen/5, contour/13 and surface_facing/6 of the current world
%   show of Segments, `all` or a list. Smooth is what contour/13 was made with,
%   see fill_contour/7 (there Known, too), or edges(Faceted): all outlines run
%   along edges. Lines is `every`, or drawn(Which, Crease): then the scene has
%   only the lines that fill_drawn/4 draws of these, and the triangles that come
%   near one in the picture. Depth: see view_depth/5; Tolerance: what counts as
%   equal, in a model of size [-1,1] (PL-5). A scene does not follow later
%   changes, and is freed when it is closed, or with its last reference. It is
%   for one thread at a time: what is asked of it is noted in it.

%!  scene_close(+Scene:scene) is det.

%!  scene_edge(+Scene:scene, ?S:id, ?E:int, -Length:number,
%!             -Look:line_look) is nondet.
%
%   True when the real edge E of segment S stands for all edges between its
%   vertices (PL-13 step 3), and is not the second copy of a penetration line.
%   Or, if E is negative, that piece -E of contour/13 is there. Length is its
%   length in the picture, standardised. Look is
%   look(Faces,Towards,Away,Left,Right,Bend,Edge,Solid,Cut,Inside,Speck), see
%   role.pl.
%   In order of S and E.

%!  scene_near(+Scene:scene, -Near:number) is det.
%
%   A substitute outline yields to a line that is nearer than Near,
%   standardised: 1/400 of the picture's longer side.

/* - - - scene_mesh_rows.c - - - */

%!  scene_mesh(+Scene:scene, +Crease:number, -Middle:point,
%!             -Counts:mesh_counts, -Octets:bytes) is det.
%
%   The model of Scene for who turns it himself: numbers of four octets, the
%   lowest first. Middle is that of its box. Octets have the places of its
%   vertices, seen from there, three float32 each; of its triangles three
%   vertices each, numbered from 0; of its lines two, first those that are drawn
%   wherever they are seen from, because they bend by more than Crease degrees
%   or for another reason. Counts is counts(Vertices,Triangles,Lines,Sharp),
%   Sharp of the Lines being these.

/* - - - occluder_rows.c - - - */

%!  occluder(+Scene:scene, +S:id, +E:int, ?S2:id, ?T:id, -From:number,
%!           -To:number) is nondet.
%
%   True when triangle T of segment S2 hides the part of edge E of segment S
%   from From to To (0.0 at its start in the picture, 1.0 at its end), in order
%   of From. A triangle never hides a line in its plane, nor one that lies on
%   its polygon (lies_on/4 of hidden_lines.pl) or beside it (line_facing/7).
%   Triangles seen edge-on and the backs of solids hide nothing. One that an
%   outline divides hides as its parts do (hiding_triangles/3 of
%   tests/oracle/contour_hiding.pl), each an answer. Inexact.
%
%   @error existence_error(drawn_edge, E): scene_edge/5 does not have it
%   @see [PL] section 6.3 step 4, row PL-13

%!  overlap(+Scene:scene, +S:id, +E:int, ?S2:id, ?E2:int, -From:number,
%!          -To:number, -From2:number, -To2:number) is nondet.
%
%   True when the part of edge E of segment S from From to To lies, in the
%   picture, on the part of edge E2 of S2 from From2 to To2. If E is a
%   substitute outline and E2 is not, E need only be near E2 there, and run
%   along it more than across. Inexact.
%
%   @error existence_error(drawn_edge, E)

%!  line_covers(+Scene:scene, +S:id, +E:int, -Covers:list(line_cover)) is det.
%
%   Covers has a covers(S2, T, From, To, Behind1, Behind2) for each triangle T
%   of S2 that hides lines and lies on edge E of S in the picture, from From to
%   To, be it before it or behind. Behind1, Behind2: how far the edge is behind
%   it at these ends, the difference of Zs times screen_depth/1. Nearest
%   triangles first. Inexact.
%
%   @error existence_error(drawn_edge, E)

/* - - - drawn_rows.c - - - */

%!  fill_drawn(+Scene:scene, +Which:lines, +Crease:number,
%!             +Through:list(hide_through)) is det.
%
%   Replaces drawn/7 of the current world by the drawn parts of the lines Which
%   (`all`, `feature`, `penetration`); Crease as in edge_role/5; Through are the
%   S-S2 for which may_hide(S2, S) is not true. The fused kernel of
%   hidden_lines.pl.

/* - - - stroke_rows.c - - - */

%!  stroke_looks(+Parts:list(looking_part), -Looks:list(look_name)) is det.
%
%   Looks are the Visibility-Role that Parts (stroke.pl) have, each once.

%!  stroke_chains(+Parts:list(sheet_part), +Looks:list(ranked_look),
%!                -Strokes:list(sheet_stroke)) is det.
%
%   As strokes/2 of stroke.pl: the fused kernel. Looks are look(Visibility,Role,
%   Rank), in standard order, all that Parts have; Rank is their place in
%   painting.

%!  chain_strokes(+Chains:chains, +From:count, +To:count,
%!                -Strokes:list(sheet_stroke)) is det.
%
%   Strokes are those From to To of Chains, counted from 1.
%
%   @error domain_error(chain, From): it has no such ones

%!  stroke_octets(+Looks:list(ranked_look), +Strokes:list(sheet_stroke),
%!                -Octets:bytes) is det.
%
%   Octets are Strokes in words of 32 bits, the lowest octet of each first: of
%   each stroke the place of its look among Looks, from 0; its segment; how it
%   starts and four times how it ends (`joint` 0, `cut` 1, `ring` 2); how many
%   edges and how many points there are; the edges; x and y of each point.
%
%   @error domain_error(look, Looks), representation_error(sheet_coordinate)

/* - - - points_text_rows.c - - - */

%!  points_text(+Points:list(sheet_point), -Text:bytes) is det.
%
%   Text are Points, integers that are thousandths, as decimal fractions without
%   zeros at the end: a comma between X and Y, a space between points.

%!  thousandths_text(+Numbers:list(integer), -Text:bytes) is det.
%
%   Text are Numbers, as points_text/2 has them: a space between two.

%!  points_written(+Stream:text_output, +Before:name,
%!                 +Points:list(sheet_point), +After:name) is det.
%
%   Write Before, Points as points_text/2 has them, and After.

/* - - - letter_rows.c - - - */

%!  letter_lines(+Glyphs:list(pen_glyph), +Start:number, +Base:number,
%!               +Scale:number, -Lines:list(list(sheet_point))) is det.
%
%   Lines are the strokes of Glyphs, At-Strokes as letter/3 (letter.pl) has
%   them, each At to the right of Start, y DOWN from Base, Scale times as large.
%   A curve becomes four straight pieces.

%!  laid_letters(+Glyphs:list(pen_glyph), +Start:number, +Scale:number,
%!               +At:paper_point, +Way:paper_point, +Move:sheet_move,
%!               +Height:number, -Lines:list(list(sheet_point))) is det.
%
%   Lines are those of letter_lines/5 with Base 0, thousandths, from At and to
%   the right along Way, a unit vector, both in millimetres, y up; then turned,
%   and moved by X + Left, Y + Bottom: Move is move(Cos, Sin, X, Y, Left,
%   Bottom). Lines are on a sheet of Height mm, thousandths, y down.

/* - - - drawn_stroke_rows.c - - - */

%!  drawn_box(-Box:paper_box) is semidet.
%
%   Box is b(X1,Y1,X2,Y2) round the parts that drawn/7 has of edges, in the
%   picture's own coordinates. Fails if there are none.

%!  drawn_strokes(+Place:drawing_place, +Removed:symbol,
%!                +Looks:list(ranked_look), +Others:list(sheet_part),
%!                -Chains:chains, -Runs:list(chain_run)) is det.
%
%   Chains are the strokes of the parts that drawn/7 has of edges, placed as
%   placed_part/3 of sheet.pl says, and of Others, which are placed; those with
%   the visibility Removed are left out, but not of Others. Looks as for
%   stroke_chains/3. Runs are run(Visibility,Role,S,From,To), one after the
%   other: the strokes From to To, counted from 1, a thousand at most. No part
%   and no stroke is ever a term.
%
%   @error representation_error(look), representation_error(sheet_coordinate)

/* - - - round_extent_rows.c - - - */

%!  round_extents(+Known:list(known_segment), +Ss:set(id),
%!                -Extents:list(round_extent)) is det.
%
%   Extents has extent(S, Surface, Low, High, Begin, Turn) of each surface with
%   an axis, as of segment_surfaces/3 (known_surface.pl), that polygons of the
%   segments Ss are facets of, by what Known, of known_surfaces/1, says: along
%   its W they reach from Low to High, about it from Begin by Turn, in degrees
%   from its U to its V; 360 if nowhere an eighth of a turn is free of their
%   vertices. In the order of Ss and of the polygons. Inexact.

/* - - - travel_rows.c - - - */

%!  travel_open(+Start:sheet_point, +How:travel_how,
%!              +Strokes:list(travelled_strokes), -Travel:travel,
%!              -Count:count, -Way:number, -Unsorted:number) is det.
%
%   Travel has the numbers of Strokes (stroke.pl), Count from 1, in the order in
%   which a plotter that begins at Start draws them: if How is `short`, in the
%   order of nearest ends that travel/4 of travel.pl has, where that is shorter;
%   else as they are. Way is how far the pen goes lifted, Unsorted how far it
%   goes if all are drawn as they are; in the unit of their points.
%
%   @error domain_error(stroke, Strokes): of no point;
%          domain_error(sheet_coordinate, X): 2^31 or farther

%!  travel_numbers(+Travel:travel, +From:count, +To:count,
%!                 -Numbers:list(int)) is det.
%
%   Numbers are those of Travel at the places From to To, counted from 1; below
%   zero: drawn backwards.
%
%   @error domain_error(place, From): it has no such ones

/* - - - stroke_crossing_rows.c - - - */

%!  stroke_crossings(+Strokes:list(travelled_stroke),
%!                   -Marks:list(stroke_mark)) is det.
%
%   Marks are K-Way, ascending: the K-th of Strokes (stroke.pl) is crossed by
%   another one, or by itself, so far along it. Pieces that come within 0.02 mm
%   of each other at an end cross too, those at less than 10 degrees never;
%   marks are 0.2 mm apart. Rounded.
%
%   @error domain_error(sheet_coordinate, X): 2^31 or farther

/* - - - raster_rows.c - - - */

%!  raster_dots(+Width:int, +Height:int, +Strokes:list(dot_stroke),
%!              -Dots:bytes) is det.
%
%   Dots is a string of Width*Height codes, by rows from the top: the inks that
%   Strokes leave on paper, whose ink is 0. Each is
%   stroke(Ink, PenWidth, Pattern, Points): Ink 0 to 255, the nib PenWidth dots
%   wide; Pattern a list of run lengths on, off, on, off, ... in dots, `[]`: a
%   solid line; Points a list of X-Y, integers, X to the right, Y DOWN. The
%   pattern runs on across joints; a later stroke covers an earlier one; what
%   is outside is left out. Exact: integers only.
%
%   @error domain_error(raster_size, Width-Height), domain_error(pen, Strokes),
%          domain_error(raster_coordinate, X): farther than 2^20
%   @see [PL] section 6.4, row PL-14

%!  raster_png(+Width:int, +Height:int, +Dots:bytes, +Palette:list(rgb),
%!             -Bytes:bytes) is det.
%
%   Bytes is a string of the bytes of a PNG file that shows Dots; ink N has the
%   N-th colour of Palette, a list of rgb(Red,Green,Blue), counted from 0.
%
%   @error domain_error(palette, Palette): empty, too long, or too short

/* - - - canvas_rows.c - - - */

%!  canvas_png(+Width:int, +Height:int, +Scale:number, +Paper:rgb,
%!             +Lines:list(canvas_line_fact), -Bytes:bytes) is det.
%
%   Bytes are a PNG file, Width x Height dots, three bytes each, of Lines with
%   smooth edges on paper of the colour Paper, rgb(R,G,B). Each of Lines is
%   line(RGB, LineWidth, Round, Points): Round is true if its ends are round;
%   Points are X-Y, X to the right, Y DOWN. Lengths are in a unit that is Scale
%   dots, and a thousandth of a millimetre; the file says so. Inexact.
%
%   @error domain_error(raster_size, Width-Height),
%          domain_error(pen_width, Lines),
%          domain_error(raster_coordinate, Lines): farther than 2^20 dots
