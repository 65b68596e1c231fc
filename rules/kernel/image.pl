:- module(sg_kernel_image, []).
:- sg_kernel:export_doors.

/** <module> Pictures in dots, shaded.

Foreign predicates; see kernel.pl. Light is linear, 0 to 65535 (srgb.h); a
scene is that of kernel/shading.pl.
*/

/* - - - image_rows.c - - - */

%!  image_shade(+Scene:shading, +How:image_how, +Looks:list(shading_look),
%!              +Leaves:list(list(count)), -Image:image) is det.
%
%   Image is Scene in dots. How is how(Lines, Background, Edges, Shadows):
%   Lines, 1, 2, 4, 8 or 16, cross each; or 0: what is in the middle of a dot
%   has all of it. Background is rgb(R, G, B) in bytes, or
%   `none`: dots have an alpha. Edges 1: a black line is where other faces
%   begin, 0: there is none. Shadows are scenes of the same solids seen
%   from where the lights of all looks come, in their order; []: there are no
%   shadows. Looks are
%   look(Tones, Ramp, Opacity, Shine, Stripes). Tones is sum(Constant, Ways):
%   the tone of a side is that, from 0 to 1, with for each way(X, Y, Z,
%   Factor, Least) Factor times the product of the unit vectors (X, Y, Z) and
%   normal, but at least Least.
%   Or table(Axes, Tones): Axes are 9 numbers, what is right, up and towards
%   the eye in the model, Tones are those of the normals of image_normals/1.
%   Ramp has 1,025 light(R, G, B), of the tones 0, 1/1024, ... 1; or two, from
%   which those between follow evenly. Opacity, 0 to
%   1, is how much of its light comes from the face, as in shading_layers/5.
%   Shine is shine(Power, Ways): for each way(X, Y, Z, Factor, _), (X, Y, Z)
%   being half-way between eye and light, white light is added, Factor times
%   the product with the normal to the power Power. Stripes is stripes(Step,
%   Way): dark stripes across a flat face, where X + Way*Y is less than Step/4
%   behind a multiple of Step, in 1/256 dot; Step 0: none. Leaves has
%   places of Looks, as in shading_layers/5.
%
%   @error domain_error(shading_lines, How), domain_error(shading_look, N),
%          domain_error(scene_of_light, How), domain_error(raster_size, W-H)

%!  image_scanned(+Scan:scan, +Scene:shading, +How:image_how,
%!                +Looks:list(shading_look), +Leaves:list(list(count)),
%!                -Image:image) is det.
%
%   The same, quicker: Scan (kernel/shading.pl) has the spans of Scene, by the
%   opacities of Looks.
%
%   @error as for image_shade/5, and domain_error(shading_scan, Scan): it is one
%          of another scene

%!  image_again(+Image0:image, +Bands:list(count), +From:count, +To:count,
%!              +Scene:shading, +How:image_how, +Looks:list(shading_look),
%!              +Leaves:list(list(count)), -Image:image) is det.
%
%   The same for Bands of 16 rows, from 0, alone, and of these for the dots From
%   up to, not with, To; the other dots of Image are those of Image0.
%
%   @error as for image_shade/5, domain_error(image_of_scene, Image0): it has
%          another size; domain_error(image_band, Bands),
%          domain_error(image_column, To)

%!  image_parts(+Scene:shading, +How:image_how, +Looks:list(shading_look),
%!              +Leaves:list(list(count)), +Y:count,
%!              -Parts:list(image_part)) is det.
%
%   Parts are part(X, Root, Leaf, Face, Share, light(R, G, B)): Share of the dot
%   X of row Y, counted from 0, shows that face, which sends that light there.
%   By X, Leaf and Face, each once. The others are as for image_shade/5, but
%   Lines is not 0.
%
%   @error as for image_shade/5, and domain_error(image_dot, Y)

%!  image_strokes(+Scene:shading, +Tone:number, +Looks:list(shading_look),
%!                +Leaves:list(list(count)), +Spacing:number, +Step:number,
%!                -Strokes:list(image_stroke)) is det.
%
%   Strokes are stroke(Y, X1, X2), in dots: between X1 and X2 what is seen on
%   the line Y is darker than Tone. The first line is half of Spacing from
%   above,
%   others are Spacing apart. A bent face is looked at every Step dots.
%
%   @error domain_error(tone, Tone), domain_error(spacing, Spacing), and those
%          of image_shade/5

%!  image_normals(-Normals:list(vector)) is det.
%
%   Normals are unit vectors, to the right, up and towards the eye, in the
%   order of a table of tones.

%!  image_extent(+Scene:shading, -Extent:shading_extent) is semidet.
%
%   Extent is extent(X1, Y1, X2, Y2), in dots of Scene, round what is seen of
%   it on the lines in the middle of its dots, and up to where these end. Fails
%   if there is nothing.

%!  srgb_light(+Byte:count, -Light:count) is det.
%
%   Light is that of Byte.
%
%   @error domain_error(byte, Byte)

%!  light_srgb(+Light:count, -Byte:count) is det.
%
%   Byte is the one whose light is the nearest to Light.
%
%   @error domain_error(light, Light)

%!  image_size(+Image:image, -Width:count, -Height:count) is det.
%
%   The size of Image in dots.

%!  image_dot(+Image:image, +X:count, +Y:count, -Bytes:list(count)) is det.
%
%   Bytes are those of the dot X of row Y, counted from 0: red, green, blue, and
%   alpha where Image has one.
%
%   @error domain_error(image_dot, X), domain_error(image_dot, Y)

/* - - - image_file_rows.c - - - */

%!  image_png(+Image:image, +PerMetre:count, +Stream:output) is det.
%
%   Writes Image to Stream as a PNG file; PerMetre dots are a metre, 0: the
%   file does not say.

%!  image_lzw(+Image:image, +Stream:output) is det.
%
%   Writes the bytes of its dots to Stream, packed for the filter LZWDecode.
%
%   @error domain_error(image_without_alpha, Image)

%!  image_ppm(+Image:image, +Stream:output) is det.
%
%   The same as a PPM file (P6).
%
%   @error domain_error(image_without_alpha, Image)

%!  image_written(+Scene:shading, +How:image_how, +Looks:list(shading_look),
%!                +Leaves:list(list(count)), +File:image_file,
%!                +Stream:output) is det.
%
%   Writes to Stream the picture of image_shade/5, part after part as it is
%   made: so it may have 1,048,576 dots a side, and 2147483648 in all. File is
%   file(Format, PerMetre, Colours, Blocks): Format is png, ppm (P6), or pgm
%   (P5), of dots that are grey; PerMetre is that of image_png/3, Colours those
%   of image_colours/2, or []: as they are. So many Blocks of 64 rows, or if
%   these have more than 8 MB of fewer, are made at once; 0: as memory allows.
%   The bytes are the same.
%
%   @error as for image_shade/5 and image_colours/2, and
%          domain_error(picture_size, Scene),
%          domain_error(image_without_alpha, Scene)

/* - - - image_change_rows.c - - - */

%!  image_blank(+Width:int, +Height:int, +Colour:rgb, -Image:image) is det.
%
%   Image is of one Colour.
%
%   @error domain_error(raster_size, W-H)

%!  image_put(+Image:image, +X:int, +Y:int, +Part:image) is det.
%
%   The image Part comes over Image, its first dot at X, Y; what is outside is
%   left out. Where Part is clear Image is seen.
%
%   @error domain_error(image_without_alpha, Image)

%!  image_row(+Image:image, +Y:count, +Dots:list(rgb)) is det.
%
%   The dots of row Y of Image, counted from 0, become Dots.
%
%   @error domain_error(image_without_alpha, Image), domain_error(image_dot, Y),
%          domain_error(image_row, Dots)

%!  image_colours(+Image:image, +Colours:list(rgb)) is det.
%
%   Each dot of Image gets the nearest of Colours, at most 256.
%
%   @error domain_error(image_without_alpha, Image),
%          domain_error(colours, Colours)

%!  image_lines(+Image:image, +Scale:number,
%!              +Lines:list(canvas_line_fact)) is det.
%
%   Lines are drawn on Image, as by canvas_png/6.
%
%   @error domain_error(image_without_alpha, Image)
