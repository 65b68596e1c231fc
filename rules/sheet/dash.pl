:- module(sg_dash,
          [ stroke_runs/4,              % +Stroke, +Runs, -Fitted, -Offset
            stroke_dashes/3             % +Stroke, +Runs, -Dashes
          ]).
:- use_module(stroke, [stroke_length/2]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [last/2, reverse/2, sum_list/2]).
/** <module> Dashes that fit the line.

A dashed line begins and ends with a dash, so that corners are closed; where
it goes on as a visible line it begins with a gap, so that one sees where it
is hidden (ISO 128). So its runs are stretched or shrunk a little for each
stroke.

Runs are lengths of a dash, a gap, a dash, a gap, ... in the unit of the
points of a stroke, positive, an even number of them: [3000,900] is a dashed
line, [6000,750,125,750] a chain of long dashes and dots. It begins with the
first dash and ends with it, so a chain has a long dash at both ends.
*/

:- set_prolog_flag(optimise, true).

%!  stroke_runs(+Stroke, +Runs, -Fitted, -Offset) is det.
%
%   Fitted are Runs fitted to Stroke, integers; it begins Offset after the
%   start of the first dash.

stroke_runs(Stroke, Runs, Fitted, Offset) :-
    fitted_runs(Stroke, Runs, Exact),
    maplist(whole_run, Exact, Fitted),
    first_run(Stroke, Fitted, _, Offset).

whole_run(Run, Whole) :-
    Whole is max(1, round(Run)).

%   A number of periods and the first dash once more, and a gap at each cut
%   end; in a ring a number of periods.

fitted_runs(Stroke, Runs, Fitted) :-
    Stroke = stroke(_, _, _, _, _, Start, End),
    stroke_length(Stroke, Length),
    sum_list(Runs, Period),
    ends_length(Start, End, Runs, Ends, Least),
    N is max(Least, round((Length-Ends)/Period)),
    Stretch is Length/(N*Period+Ends),
    maplist(stretched(Stretch), Runs, Fitted).

ends_length(ring, _, _, 0, 1) :-
    !.
ends_length(Start, End, Runs, Length, 0) :-
    Runs = [Dash,Gap|_],
    last(Runs, LastGap),
    cut_gap(Start, LastGap, Before),
    cut_gap(End, Gap, After),
    Length is Before+Dash+After.

cut_gap(cut, Gap, Gap).
cut_gap(joint, _, 0).

stretched(Stretch, Run0, Run) :-
    Run is Run0*Stretch.

%   first_run(Stroke, Runs, Index, Offset): the stroke begins with the run of
%   that Index, from 0, which begins Offset after the first dash.

first_run(stroke(_,_,_,_,_,cut,_), Runs, Index, Offset) :-
    !,
    length(Runs, N),
    Index is N-1,
    last(Runs, Gap),
    sum_list(Runs, Period),
    Offset is Period-Gap.
first_run(_, _, 0, 0).

%!  stroke_dashes(+Stroke, +Runs, -Dashes) is det.
%
%   Dashes are the dashes of Stroke as lines: lists of two or more points,
%   each X-Y, integers. Runs are fitted to it.

stroke_dashes(Stroke, Runs, Dashes) :-
    Stroke = stroke(_, _, _, _, [Point|Points], _, _),
    fitted_runs(Stroke, Runs, Fitted),
    compound_name_arguments(Pattern, runs, Fitted),
    first_run(Stroke, Fitted, Index, _),
    run(Pattern, Index, Left),
    dashes(Points, Point, Pattern, Index, Left, [Point], Dashes).

run(Pattern, Index, Length) :-
    Argument is Index+1,
    arg(Argument, Pattern, Length).

%   dashes(Points, At, Pattern, Index, Left, Line, Dashes): the pen is at At,
%   in the run of that Index, a dash if it is even, of which Left is left; Line
%   is what was drawn since the run began, last point first.

dashes([], _, _, Index, _, Line, Dashes) :-
    dash_ended(Index, Line, Dashes, []).
dashes([Point|Points], At, Pattern, Index, Left, Line, Dashes) :-
    At = X0-Y0,
    Point = X-Y,
    Way is sqrt((X-X0)**2 + (Y-Y0)**2),
    (   Way =< Left+0.5
    ->  Left1 is Left-Way,
        dashes(Points, Point, Pattern, Index, Left1, [Point|Line], Dashes)
    ;   X1 is X0 + (X-X0)*Left/Way,
        Y1 is Y0 + (Y-Y0)*Left/Way,
        rounded(X1-Y1, Change),
        dash_ended(Index, [Change|Line], Dashes, Dashes1),
        next_run(Pattern, Index, Index1),
        run(Pattern, Index1, Left1),
        dashes([Point|Points], X1-Y1, Pattern, Index1, Left1, [Change],
               Dashes1)
    ).

next_run(Pattern, Index0, Index) :-
    compound_name_arity(Pattern, _, N),
    Index is (Index0+1) mod N.

rounded(X0-Y0, X-Y) :-
    X is round(X0),
    Y is round(Y0).

dash_ended(Index, [Point,Before|Line], [Dash|Dashes], Dashes) :-
    Index mod 2 =:= 0,
    !,
    reverse([Point,Before|Line], Dash).
dash_ended(_, _, Dashes, Dashes).
