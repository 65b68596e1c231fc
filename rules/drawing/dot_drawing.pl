:- module(sg_dot_drawing,
          [ write_dots/2,               % +Out, +Options
            picture_dots/4              % +Pens, +Options, -Size, -Dots
          ]).
:- use_module(ink,
              [ inked/3, line_of/2, inked_lines/3, ink_width/2,
                ink_colour/3, ink_runs/2, ink_type/2
              ]).
:- use_module('../kernel', [raster_dots/4, raster_png/5]).
:- use_module('../sheet/sheet', [sheet_drawing/3, scaled_drawing/3]).
:- use_module('../sheet/stroke', [stroke_key/4]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(error), [domain_error/2]).
:- use_module(library(lists), [list_to_set/2, member/2, nth0/3]).
:- use_module(library(option), [option/2, option/3]).
/** <module> Drawings in dots: Bresenham's lines, as on the paper's screen.

640 x 400 dots unless another size is wanted; pens and patterns grow with it.
Hidden lines are dotted by the paper's pattern: 3 is 3 dots on and 3 off, and
it runs on along a chain.

@see [PL] section 6.4, row PL-14
*/

%!  write_dots(+Out, +Options) is det.
%
%   Write the picture of the current world as PNG in dots to stream Out, which
%   takes bytes. Options as for write_drawing/2.

write_dots(Out, Options) :-
    inked_in_dots(640-400, Options, Inked),
    Inked = inked(_, Paper, _),
    inked_lines(drawn, Inked, Lines),
    findall(RGB, line_colour(Lines, Options, Paper, RGB), Colours),
    list_to_set([Paper|Colours], Palette0),
    fewest_colours(Palette0, Palette),
    drawn_dots(palette(Palette,Paper), pens(640,400,bold), Options, Inked,
               Lines, W-H, Dots),
    raster_png(W, H, Dots, Palette, Bytes),
    format(Out, '~s', [Bytes]).

line_colour(Lines, Options, Paper, RGB) :-
    member(line(Ink,Strokes), Lines),
    dot_colour(Options, Paper, Ink, Strokes, RGB).

%   Hidden lines that are not dotted are faint.

dot_colour(Options, Paper, Ink, Strokes, RGB) :-
    stroke_key(Strokes, Visibility, _, _),
    ink_colour(screen, Ink, RGB0),
    (   Visibility == hidden,
        option(hidden(shown), Options)
    ->  faint(Paper, RGB0, RGB)
    ;   RGB = RGB0
    ).

faint(rgb(R1,G1,B1), rgb(R2,G2,B2), rgb(R,G,B)) :-
    R is (55*R1+45*R2)//100,
    G is (55*G1+45*G2)//100,
    B is (55*B1+45*B2)//100.

fewest_colours(Palette, Palette) :-
    length(Palette, N),
    N =< 256,
    !.
fewest_colours(Palette, _) :-
    length(Palette, N),
    domain_error(palette, N).

%!  picture_dots(+Pens, +Options, -Size, -Dots) is det.
%
%   Dots (raster_dots/4) show the picture of the current world at Size, W-H in
%   dots. Pens is pens(W,H,Bold): at size W x H, which is the default too, a
%   line is one dot wide; wide ones are wider if Bold is `bold`, not if it is
%   `plain`. Inks: 0 paper, 1 visible, 2 penetration line, 3 hidden but drawn
%   solid, 4 hidden, 5 hidden penetration line. Options: size(Size), margin(M),
%   style(Style), hidden(How), pattern(P), drawing(D) with dots(N).
%
%   @error domain_error(raster_size, W-H), domain_error(dot_pattern, P)

picture_dots(Pens, Options, Size, Dots) :-
    Pens = pens(W, H, _),
    inked_in_dots(W-H, Options, Inked),
    inked_lines(drawn, Inked, Lines),
    drawn_dots(roles, Pens, Options, Inked, Lines, Size, Dots).

inked_in_dots(Size, Options, Inked) :-
    sheet_drawing(Size, Options, Drawing0),
    in_dots(Options, Drawing0, Drawing),
    inked(Drawing, Options, Inked).

%   A drawing that was laid out in millimetres.

in_dots(Options, Drawing0, Drawing) :-
    (   option(drawing(_), Options)
    ->  option(dots(Dots), Options, 6),
        scaled_drawing(Dots, Drawing0, Drawing)
    ;   Drawing = Drawing0
    ).

%   drawn_dots(Numbers, Pens, Options, Inked, Lines, Size, Dots): Numbers says
%   what number the dots of an ink have.

drawn_dots(Numbers, pens(W0,H0,Bold), Options, Inked, Lines, W-H, Dots) :-
    option(pattern(Pattern), Options, 3),
    pattern_runs(Pattern, Runs),
    Inked = inked(sheet(Width,Height,_), _, _),
    W is Width//1000,
    H is Height//1000,
    Nib is max(1, min(64, round(min(W/W0, H/H0)))),
    findall(Line, line_of(Lines, Line), Singles),
    maplist(dot_stroke(pen(Numbers,Options,Nib,Bold,Runs)), Singles, Strokes),
    raster_dots(W, H, Strokes, Dots).

pattern_runs(Pattern, Runs) :-
    (   integer(Pattern),
        Pattern > 0
    ->  Runs = [Pattern,Pattern]
    ;   is_list(Pattern),
        Pattern \== [],
        forall(member(Run, Pattern), (integer(Run), Run > 0)),
        length(Pattern, N),
        N mod 2 =:= 0
    ->  Runs = Pattern
    ;   domain_error(dot_pattern, Pattern)
    ).

dot_stroke(pen(Numbers,Options,Nib,Bold,Runs), line(Ink,Stroke),
           stroke(Number,Width,Pattern,Dots)) :-
    Stroke = stroke(_, _, _, _, Points, _, _),
    maplist(dot, Points, Dots),
    number_of(Numbers, Options, Ink, Stroke, Number),
    pen_width(Bold, Nib, Ink, Stroke, Width),
    ink_pattern(Ink, Runs, Nib, Pattern).

number_of(palette(Palette,Paper), Options, Ink, Stroke, Number) :-
    dot_colour(Options, Paper, Ink, Stroke, RGB),
    once(nth0(Number, Palette, RGB)).
number_of(roles, Options, _, stroke(Visibility,Role,_,_,_,_,_), Number) :-
    role_number(Visibility, Role, Options, Number).

role_number(visible, penetration, _, Number) =>
    Number = 2.
role_number(visible, _, _, Number) =>
    Number = 1.
role_number(hidden, _, Options, Number), option(hidden(shown), Options) =>
    Number = 3.
role_number(hidden, penetration, _, Number) =>
    Number = 5.
role_number(hidden, _, _, Number) =>
    Number = 4.

%   A dot for each 0.35 mm, so that thin lines and lines are one dot wide, and
%   penetration lines two; letters are one dot wide.

pen_width(plain, Nib, _, _, Width) =>
    Width = Nib.
pen_width(bold, Nib, _, stroke(_,text,_,_,_,_,_), Width) =>
    Width = Nib.
pen_width(bold, Nib, Ink, _, Width) =>
    ink_width(Ink, Thousandths),
    Width is max(1, min(64, Nib*max(1, (Thousandths+175)//350))).

%   Hidden lines have the pattern of the paper; for another line type there are
%   three dots to a millimetre.

ink_pattern(Ink, Runs, Nib, Pattern) :-
    ink_runs(Ink, InkRuns),
    (   InkRuns == []
    ->  Pattern = []
    ;   ink_type(Ink, hidden)
    ->  nib_runs(Runs, Nib, Pattern)
    ;   maplist(run_dots, InkRuns, DotRuns),
        nib_runs(DotRuns, Nib, Pattern)
    ).

run_dots(Run, Dots) :-
    Dots is max(1, (3*Run+500)//1000).

dot(X0-Y0, X-Y) :-
    X is X0//1000,
    Y is Y0//1000.

%   The runs for a nib: it reaches beyond both ends of a dash.

nib_runs([], _, []).
nib_runs([On0,Off0|Runs0], Nib, [On,Off|Runs]) :-
    On is max(1, On0*Nib-(Nib-1)),
    Off is (On0+Off0)*Nib - On,
    nib_runs(Runs0, Nib, Runs).
