:- module(sg_drawing,
          [ write_drawing/2,            % +File, +Options
            write_drawing_stream/3,     % +Format, +Out, +Options
            drawing_format/2            % ?Format, ?Type
          ]).
:- use_module(pdf, [write_pdf/3]).
:- use_module(ps, [write_ps/4]).
:- use_module(png, [write_png/2]).
:- use_module(drawing_facts, [write_facts/3]).
:- use_module(drawing_json, [write_json/3]).
:- use_module(dxf, [write_dxf/3]).
:- use_module(hpgl, [write_hpgl/3]).
:- use_module(ink, [inked/3]).
:- use_module('../output', [writing/3]).
:- use_module('../plain', [plain_text/2]).
:- use_module('../sheet/sheet', [sheet_drawing/3]).
:- use_module(svg, [write_svg/3]).
:- use_module(library(error), [domain_error/2]).
:- use_module(library(option), [option/2, select_option/3]).
/** <module> Drawings: the picture of the current world, written to files.

What drawn/7 and screen/5 hold (hidden_lines.pl fills them) is laid on a sheet
(sheet.pl), chained into strokes (stroke.pl), inked by its style (ink.pl) and
written. Same picture, same
bytes: no times, no names of users, no hash order.
*/

%!  drawing_format(?Format, ?Type) is nondet.
%
%   True when drawings can be written as Format, which is also the ending of
%   such files; Type is `text` or `binary`.

drawing_format(svg, text).
drawing_format(pdf, text).
drawing_format(eps, text).
drawing_format(ps, text).
drawing_format(png, binary).
drawing_format(json, text).
drawing_format(dxf, text).
drawing_format(hpgl, text).
drawing_format(pl, text).

%!  write_drawing(+File, +Options) is det.
%
%   Write the drawing of the current world to File, in the format that its
%   ending names, see drawing_format/2. Options:
%
%     - size(Size): `WxH`, or W-H, in millimetres, default 210x148; with
%       png(dots) in dots, default 640x400
%     - margin(M), scale(S): see sheet_drawing/3
%     - hidden(H): `dashed` (default), `removed`, or `shown`: not dashed
%     - style(Style): a style file, or its rows; see style_rows/2
%     - dashes(How): `auto` (default), `geometry`: each dash is a line, or
%       `type`: by line types that a plotter or CAD program has
%     - title(Text): in SVG, PDF, PostScript and JSON
%     - drawing(Drawing): this one (sheet.pl), not the picture of the world
%     - shading(Shadeds): of drawing_shading.pl, under the lines, in SVG, PDF,
%       PostScript and smooth PNG
%     - png(How), dots(N): see write_png/2; pattern(P): dots on and off of
%       hidden lines with png(dots): N, or a list
%
%   A world without a picture gives a valid, empty drawing.
%
%   @error domain_error(drawing_format, Ending), and those of writing/3 and
%   sheet_drawing/3.

write_drawing(File, Options) :-
    file_name_extension(_, Ending, File),
    downcase_atom(Ending, Format),
    format_type(Format, Type),
    writing(File, Type, drawing_written(Format, Options)).

drawing_written(Format, Options, Out) :-
    write_drawing_stream(Format, Out, Options).

format_type(Format, Type) :-
    (   drawing_format(Format, Type0)
    ->  Type = Type0
    ;   domain_error(drawing_format, Format)
    ).

%!  write_drawing_stream(+Format, +Out, +Options) is det.
%
%   Like write_drawing/2, to stream Out. For a binary format Out may be a text
%   stream: it is set to bytes while this writes.

write_drawing_stream(Format, Out, Options) :-
    format_type(Format, _),
    write_format(Format, Out, Options).

write_format(png, Out, Options) :-
    !,
    write_png(Out, Options).
write_format(Format, Out, Options0) :-
    (   select_option(title(Title0), Options0, Rest)
    ->  plain_text(Title0, Title),
        Options = [title(Title)|Rest]
    ;   Options = Options0
    ),
    sheet_drawing(210-148, Options, Drawing),
    words_of(Format, Options, Words),
    inked(Drawing, [words(Words)|Options], Inked),
    write_inked(Format, Out, Inked, Options).

%   words_of(Format, Options, Words): DXF has texts that stand aslant; a cutter
%   that wants dashes as lines wants letters so too.

words_of(Format, Options, Words) :-
    (   Format == dxf,
        \+ option(dashes(geometry), Options)
    ->  Words = kept
    ;   Words = drawn
    ).

write_inked(svg, Out, Inked, Options) :-
    write_svg(Out, Inked, Options).
write_inked(pdf, Out, Inked, Options) :-
    write_pdf(Out, Inked, Options).
write_inked(eps, Out, Inked, Options) :-
    write_ps(eps, Out, Inked, Options).
write_inked(ps, Out, Inked, Options) :-
    write_ps(ps, Out, Inked, Options).
write_inked(pl, Out, Inked, Options) :-
    write_facts(Out, Inked, Options).
write_inked(json, Out, Inked, Options) :-
    write_json(Out, Inked, Options).
write_inked(dxf, Out, Inked, Options) :-
    write_dxf(Out, Inked, Options).
write_inked(hpgl, Out, Inked, Options) :-
    write_hpgl(Out, Inked, Options).
