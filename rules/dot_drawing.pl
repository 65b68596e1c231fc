:- module(sg_dot_drawing,
          [ write_png/2,                % +Out, +Options
            picture_dots/4              % +Pens, +Options, -Size, -Dots
          ]).
:- use_module(kernel, [raster_dots/4, raster_png/5]).
:- use_module(sheet, [sheet_drawing/3, drawing_strokes/2, scaled_drawing/3]).
:- autoload(library(apply), [maplist/3]).
:- autoload(library(error), [domain_error/2]).
:- autoload(library(option), [option/2, option/3]).
/** <module> Drawings in dots: Bresenham's lines, as on the paper's screen.

640 x 400 dots unless another size is wanted; pens and patterns grow with it.
Hidden lines are dotted by the paper's pattern: 3 is 3 dots on and 3 off, and
it runs on along a chain.

@see [PL] section 6.4, row PL-14
*/

%!  write_png(+Out, +Options) is det.
%
%   Write the picture of the current world as PNG to stream Out. Options as
%   for write_drawing/2.

write_png(Out, Options) :-
    picture_dots(pens(640,400,2), Options, W-H, Dots),
    palette(Palette),
    raster_png(W, H, Dots, Palette, Bytes),
    stream_property(Out, encoding(Encoding)),
    setup_call_cleanup(
        set_stream(Out, encoding(octet)),
        format(Out, '~s', [Bytes]),
        set_stream(Out, encoding(Encoding))).

%   By ink, see picture_dots/4.

palette([Paper,Line,Penetration,Hidden,Line,Penetration]) :-
    Paper = rgb(255,255,255),
    Line = rgb(0,0,0),
    Penetration = rgb(170,0,0),
    Hidden = rgb(140,140,140).

%!  picture_dots(+Pens, +Options, -Size, -Dots) is det.
%
%   Dots (raster_dots/4) show the picture of the current world at Size, W-H in
%   dots. Pens is pens(W,H,Bold): at size W x H, which is the default too, a
%   line is one dot wide; a penetration line is Bold times as wide as others.
%   Inks: 0 paper, 1 visible, 2 penetration line, 3 hidden but drawn solid,
%   4 hidden, 5 hidden penetration line. Options: size(Size), margin(M),
%   hidden(How), pattern(P), drawing(D) with dots(N).
%
%   @error domain_error(raster_size, W-H), domain_error(dot_pattern, P)

picture_dots(pens(W0,H0,Bold), Options, W-H, Dots) :-
    option(hidden(Hidden), Options, dashed),
    option(pattern(Pattern), Options, 3),
    pattern_runs(Pattern, Runs),
    sheet_drawing(W0-H0, Options, Drawing0),
    in_dots(Options, Drawing0, Drawing),
    Drawing = drawing(sheet(Width,Height,_), _),
    drawing_strokes(Drawing, Strokes),
    W is Width//1000,
    H is Height//1000,
    Nib is max(1, min(64, round(min(W/W0, H/H0)))),
    maplist(dot_stroke(pen(Hidden,Nib,Bold,Runs)), Strokes, DotStrokes),
    raster_dots(W, H, DotStrokes, Dots).

%   A drawing that was laid out in millimetres.

in_dots(Options, Drawing0, Drawing) :-
    (   option(drawing(_), Options)
    ->  option(dots(Dots), Options, 6),
        scaled_drawing(Dots, Drawing0, Drawing)
    ;   Drawing = Drawing0
    ).

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

dot_stroke(pen(Hidden,Nib,Bold,Runs), stroke(Visibility,Role,_,_,Points,_,_),
           stroke(Ink,Width,Pattern,Dots)) :-
    maplist(dot, Points, Dots),
    (   Visibility == visible
    ->  visible_pen(Role, Nib, Bold, Ink, Width),
        Pattern = []
    ;   Hidden == shown
    ->  Ink = 3,
        Width = Nib,
        Pattern = []
    ;   hidden_ink(Role, Ink),
        Width = Nib,
        nib_runs(Runs, Nib, Pattern)
    ).

visible_pen(Role, Nib, Bold, Ink, Width) :-
    (   Role == penetration
    ->  Ink = 2,
        Width is min(64, Bold*Nib)
    ;   Ink = 1,
        Width = Nib
    ).

hidden_ink(Role, Ink) :-
    (   Role == penetration
    ->  Ink = 5
    ;   Ink = 4
    ).

dot(X0-Y0, X-Y) :-
    X is X0//1000,
    Y is Y0//1000.

%   The runs for a nib: it reaches beyond both ends of a dash.

nib_runs([], _, []).
nib_runs([On0,Off0|Runs0], Nib, [On,Off|Runs]) :-
    On is max(1, On0*Nib-(Nib-1)),
    Off is (On0+Off0)*Nib - On,
    nib_runs(Runs0, Nib, Runs).
