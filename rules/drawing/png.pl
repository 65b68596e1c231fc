:- module(sg_png,
          [ write_png/2                 % +Out, +Options
          ]).
:- use_module(dot_drawing, [write_dots/2]).
:- use_module(ink,
              [ inked/3, line_of/2, inked_lines/3, ink_colour/3,
                ink_width/2, ink_runs/2, ink_lines/4
              ]).
:- use_module(drawing_shading, [shading_images/5]).
:- use_module('../kernel',
              [ canvas_png/6, image_blank/4, image_lines/3, image_png/3,
                image_put/4 ]).
:- use_module('../sheet/sheet', [sheet_drawing/3]).
:- use_module(library(error), [domain_error/2]).
:- use_module(library(lists), [member/2]).
:- use_module(library(option), [option/3]).
/** <module> PNG: a drawing as a picture.

A `smooth` one is the sheet of all other formats, six dots to a millimetre
(152 to the inch), its lines as wide as the style says. One in `dots` is the
paper's (dot_drawing.pl).
*/

%!  write_png(+Out, +Options) is det.
%
%   Write the picture of the current world as PNG to stream Out. Options are
%   those of write_drawing/2; of PNG alone:
%
%     - png(How): `smooth` (default) or `dots`
%     - dots(N): so many dots are a millimetre, default 6
%
%   @error domain_error(png, How), domain_error(raster_size, W-H)

write_png(Out, Options) :-
    option(png(How), Options, smooth),
    (   memberchk(How, [smooth,dots])
    ->  true
    ;   domain_error(png, How)
    ),
    stream_property(Out, encoding(Encoding)),
    setup_call_cleanup(
        set_stream(Out, encoding(octet)),
        write_bytes(How, Out, Options),
        set_stream(Out, encoding(Encoding))).

write_bytes(dots, Out, Options) :-
    write_dots(Out, Options).
write_bytes(smooth, Out, Options) :-
    sheet_drawing(210-148, Options, Drawing),
    inked(Drawing, Options, Inked),
    option(dots(Dots), Options, 6),
    option(shading(Shadeds), Options, []),
    write_smooth(Out, Inked, Dots, Shadeds).

write_smooth(Out, Inked, Dots, Shadeds) :-
    Inked = inked(Sheet, Paper, _),
    Sheet = sheet(Width,Height,_),
    W is max(1, round(Width*Dots/1000)),
    H is max(1, round(Height*Dots/1000)),
    (   max(W, H) < 1<<31               % more are no number for the kernel
    ->  true
    ;   domain_error(raster_size, W-H)
    ),
    Scale is Dots/1000.0,
    inked_lines(drawn, Inked, Lines),
    findall(Line, smooth_line(Lines, Line), Smooth),
    (   Shadeds == []
    ->  canvas_png(W, H, Scale, Paper, Smooth, Bytes),
        format(Out, '~s', [Bytes])
    ;   image_blank(W, H, Paper, Whole),
        shading_images(Shadeds, Sheet, Dots, none, Images),
        forall(member(image(X,Y,_,_,Image), Images),
               ( Left is round(X*Scale),
                 Top is round(Y*Scale),
                 image_put(Whole, Left, Top, Image) )),
        image_lines(Whole, Scale, Smooth),
        PerMetre is round(Scale*1.0e6),
        image_png(Whole, PerMetre, Out)
    ).

%   Dashes are lines of their own, their ends not round.

smooth_line(Lines, line(RGB,Width,Round,Points)) :-
    line_of(Lines, line(Ink,Stroke)),
    ink_colour(screen, Ink, RGB),
    ink_width(Ink, Width),
    ink_runs(Ink, Runs),
    (   Runs == []
    ->  Round = true
    ;   Round = false
    ),
    ink_lines(geometry, Ink, Stroke, Own),
    member(Points, Own).
