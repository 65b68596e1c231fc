:- module(sg_hpgl,
          [ write_hpgl/2                % +Out, +Drawing
          ]).
:- use_module(dash, [stroke_dashes/2]).
:- use_module(sheet, [drawing_strokes/2]).
:- use_module(travel, [short_travel/2]).
:- autoload(library(apply), [foldl/4, include/3]).
:- autoload(library(lists), [member/2]).
/** <module> HPGL: strokes for pen plotters.

Pen 1 draws visible lines, pen 2 hidden ones, pen 3 penetration lines. Dashes
are drawn as such, for many plotters and all cutters know no line types; they
are fitted to each line (dash.pl). A unit is 0.025 mm, the origin the lower
left corner of the sheet.
*/

%!  write_hpgl(+Out, +Drawing) is det.
%
%   Write Drawing (sheet.pl) to stream Out, pen by pen, the pen's travel
%   between them short (travel.pl). Texts are not drawn.

write_hpgl(Out, Drawing) :-
    Drawing = drawing(sheet(_,H,_), _),
    drawing_strokes(Drawing, Strokes),
    format(Out, 'IN;~n', []),
    forall(member(Pen, [2,1,3]), plot_pen(Out, H, Strokes, Pen)),
    format(Out, 'PU;SP0;~n', []).

plot_pen(Out, H, Strokes, Pen) :-
    include(stroke_pen(Pen), Strokes, Own),
    (   Own == []
    ->  true
    ;   format(Out, 'PU;SP~d;~n', [Pen]),
        short_travel(Own, Ordered),
        forall(member(Stroke, Ordered), plot(Out, H, Stroke))
    ).

stroke_pen(Pen, stroke(Visibility,Role,_,_,_,_,_)) :-
    pen(Visibility, Role, Pen).

plot(Out, H, Stroke) :-
    Stroke = stroke(Visibility, Role, S, Edges, Points, _, _),
    (   Edges = [E|_]
    ->  format(Out, 'CO "s~de~d ~w ~w";~n', [S, E, Visibility, Role])
    ;   format(Out, 'CO "~w ~w";~n', [Visibility, Role])
    ),
    (   Visibility == hidden
    ->  stroke_dashes(Stroke, Dashes)
    ;   Dashes = [Points]
    ),
    forall(member(Dash, Dashes), plot_line(Out, H, Dash)).

pen(visible, Role, Pen) :-
    (   Role == penetration
    ->  Pen = 3
    ;   Pen = 1
    ).
pen(hidden, _, 2).

plot_line(Out, H, [Point|Points]) :-
    units(H, Point, X, Y),
    format(Out, 'PU~d,~d;PD', [X, Y]),
    foldl(plot_to(Out, H), Points, '', _),
    format(Out, ';~n', []).

plot_to(Out, H, Point, Before, ',') :-
    units(H, Point, X, Y),
    format(Out, '~w~d,~d', [Before, X, Y]).

units(H, X0-Y0, X, Y) :-
    X is (2*X0+25)//50,
    Y is (2*(H-Y0)+25)//50.
