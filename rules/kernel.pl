:- module(sg_kernel,
          [ raster_dots/4,            % +Width, +Height, +Strokes, -Dots
            raster_png/5              % +Width, +Height, +Dots, +Palette, -Bytes
          ]).

:- if(\+ predicate_property(sg_kernel:raster_dots(_,_,_,_), foreign)).
:- use_foreign_library(foreign(sanggwan)).
:- endif.

/** <module> The kernels: every foreign predicate that is not of the store.

The doors to c_kernels/, documented here and nowhere else. A block for each
glue file.
*/

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
