:- module(sg_hpgl,
          [ write_hpgl/3                % +Out, +Sheet, +Strokes
          ]).
:- use_module(dash, [stroke_dashes/2]).
:- autoload(library(apply), [foldl/4]).
/** <module> HPGL: strokes for pen plotters.

Pen 1 draws visible lines, pen 2 hidden ones, pen 3 penetration lines. Dashes
are drawn as such, for many plotters and all cutters know no line types; they
are fitted to each line (dash.pl). A unit is 0.025 mm, the origin the lower
left corner of the sheet.
*/

%!  write_hpgl(+Out, +Sheet, +Strokes) is det.
%
%   Write Strokes on Sheet (sheet.pl) to stream Out. Strokes follow one
%   another pen by pen in their own order.

write_hpgl(Out, sheet(_,H,_), Strokes) :-
    format(Out, 'IN;~n', []),
    foldl(plot(Out, H), Strokes, 0, _),
    format(Out, 'PU;SP0;~n', []).

plot(Out, H, Stroke, Pen0, Pen) :-
    Stroke = stroke(Visibility, Role, S, [E|_], Points, _, _),
    pen(Visibility, Role, Pen),
    (   Pen == Pen0
    ->  true
    ;   format(Out, 'PU;SP~d;~n', [Pen])
    ),
    format(Out, 'CO "s~de~d ~w ~w";~n', [S, E, Visibility, Role]),
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
