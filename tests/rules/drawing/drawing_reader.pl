:- module(drawing_reader, []).
:- reexport(pdf_reader).
:- reexport(ps_reader).
:- reexport(dxf_reader).
:- reexport(hpgl_reader).
:- reexport(svg_reader).
:- reexport(png_reader).
:- reexport(dashes_fit).
/** <module> Readers of drawings, for tests: they share nothing with writers.

Each reads a whole file and throws wrong(What) where the file is not what its
format says: an offset, a length, a name that is not defined, a number used
twice. What they find of lines is

    path(Layer, RGB, Width, Cap, Runs, Offset, Points)

with lengths in thousandths of a millimetre, y down, as the drawing has them;
what a format does not say is `none`.
*/
