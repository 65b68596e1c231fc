:- module(sg_dash,
          [ stroke_dash/3,              % +Stroke, -Dash, -Gap
            stroke_dashes/2             % +Stroke, -Dashes
          ]).
:- use_module(stroke, [stroke_length/2]).
:- autoload(library(lists), [reverse/2]).
/** <module> Dashes that fit the line.

A dashed line begins and ends with a dash, so that corners are closed; where
it goes on as a visible line it begins with a gap, so that one sees where it
is hidden (ISO 128). So dash and gap, 3 mm and 0.9 mm, are stretched or shrunk
a little for each stroke.
*/

:- set_prolog_flag(optimise, true).

natural(3000, 900).

%!  stroke_dash(+Stroke, -Dash, -Gap) is det.
%
%   Dash and Gap fit Stroke, integers in the unit of its points. It begins
%   with a gap if its start is `cut`, else with a dash.

stroke_dash(Stroke, Dash, Gap) :-
    stroke_runs(Stroke, Dash0, Gap0),
    Dash is max(1, round(Dash0)),
    Gap is max(1, round(Gap0)).

%   N dashes with N-1 gaps between them and a gap at each cut end; a ring has
%   as many gaps as dashes.

stroke_runs(Stroke, Dash, Gap) :-
    Stroke = stroke(_, _, _, _, _, Start, End),
    stroke_length(Stroke, Length),
    natural(Dash0, Gap0),
    gaps_more(Start, End, More),
    N is max(1, round((Length+Gap0-More*Gap0)/(Dash0+Gap0))),
    Natural is N*Dash0 + (N-1+More)*Gap0,
    Dash is Dash0*Length/Natural,
    Gap is Gap0*Length/Natural.

gaps_more(ring, _, 1) :-
    !.
gaps_more(Start, End, More) :-
    cut_gap(Start, A),
    cut_gap(End, B),
    More is A+B.

cut_gap(cut, 1).
cut_gap(joint, 0).

%!  stroke_dashes(+Stroke, -Dashes) is det.
%
%   Dashes are the dashes of Stroke as lines: lists of two or more points,
%   each X-Y, integers.

stroke_dashes(Stroke, Dashes) :-
    Stroke = stroke(_, _, _, _, [Point|Points], Start, _),
    stroke_runs(Stroke, Dash, Gap),
    (   Start == cut
    ->  Pen = up,
        Left = Gap
    ;   Pen = down,
        Left = Dash
    ),
    dashes(Points, Point, runs(Dash,Gap), Pen, Left, [Point], Dashes).

%   dashes(Points, At, Runs, Pen, Left, Line, Dashes): the pen is at At, Left
%   before it changes; Line is what was drawn since it came down, last first.

dashes([], _, _, Pen, _, Line, Dashes) :-
    dash_ended(Pen, Line, Dashes, []).
dashes([Point|Points], At, Runs, Pen, Left, Line, Dashes) :-
    At = X0-Y0,
    Point = X-Y,
    Way is sqrt((X-X0)**2 + (Y-Y0)**2),
    (   Way =< Left+0.5
    ->  Left1 is Left-Way,
        dashes(Points, Point, Runs, Pen, Left1, [Point|Line], Dashes)
    ;   X1 is X0 + (X-X0)*Left/Way,
        Y1 is Y0 + (Y-Y0)*Left/Way,
        change(Pen, Runs, Pen1, Left1),
        rounded(X1-Y1, Change),
        dash_ended(Pen, [Change|Line], Dashes, Dashes1),
        dashes([Point|Points], X1-Y1, Runs, Pen1, Left1, [Change], Dashes1)
    ).

change(down, runs(_,Gap), up, Gap).
change(up, runs(Dash,_), down, Dash).

rounded(X0-Y0, X-Y) :-
    X is round(X0),
    Y is round(Y0).

dash_ended(down, [Point,Before|Line], [Dash|Dashes], Dashes) :-
    !,
    reverse([Point,Before|Line], Dash).
dash_ended(_, _, Dashes, Dashes).
