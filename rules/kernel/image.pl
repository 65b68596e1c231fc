:- module(sg_kernel_image, []).
:- sg_kernel:export_doors.

/** <module> Pictures in dots, shaded.

Foreign predicates; see kernel.pl. Light is linear, 0 to 65535 (srgb.h); a
scene is that of kernel/shading.pl.
*/

/* - - - image_rows.c - - - */

%!  image_shade(+Scene:shading, +Lines:count, +Looks:list(shading_look),
%!              +Leaves:list(list(count)), +Background:image_background,
%!              -Image:image) is det.
%
%   Image is Scene in dots; Lines, 1, 2, 4, 8 or 16, cross each. Looks are
%   look(Tones, Ramp, Opacity, Shine, Stripes). Tones is sum(Constant, Ways):
%   the tone of a side is that, from 0 to 1, with for each way(X, Y, Z,
%   Factor, Least) Factor times the product of the unit vectors (X, Y, Z) and
%   normal, but at least Least.
%   Or table(Axes, Tones): Axes are 9 numbers, what is right, up and towards
%   the eye in the model, Tones are those of the normals of image_normals/1.
%   Ramp has 1,025 light(R, G, B), of the tones 0, 1/1024, ... 1. Opacity, 0 to
%   1, is how much of its light comes from the face, as in shading_layers/5.
%   Shine is shine(Power, Ways): for each way(X, Y, Z, Factor, _), (X, Y, Z)
%   being half-way between eye and light, white light is added, Factor times
%   the product with the normal to the power Power. Stripes is stripes(Step,
%   Way): dark stripes across a flat face, where X + Way*Y is less than Step/4
%   behind a multiple of Step, in 1/256 dot; Step 0: none. Leaves has
%   places of Looks, as in shading_layers/5. Background is rgb(R, G, B) in
%   bytes, or `none`: dots have an alpha.
%
%   @error domain_error(shading_lines, Lines), domain_error(shading_look, N),
%          domain_error(raster_size, W-H)

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

%!  image_dot(+Image:image, +X:count, +Y:count, -Bytes:list(count)) is det.
%
%   Bytes are those of the dot X of row Y, counted from 0: red, green, blue, and
%   alpha where Image has one.
%
%   @error domain_error(image_dot, X), domain_error(image_dot, Y)

%!  image_png(+Image:image, +PerMetre:count, +Stream:output) is det.
%
%   Writes Image to Stream as a PNG file; PerMetre dots are a metre, 0: the
%   file does not say.

%!  image_ppm(+Image:image, +Stream:output) is det.
%
%   The same as a PPM file (P6).
%
%   @error domain_error(image_without_alpha, Image)
