:- module(sg_oracle_travel,
          [ short_travel_by_rule/3      % +Start, +Strokes, -Ordered
          ]).
:- use_module('../../rules/drawing/travel', []).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [selectchk/3]).
/** <module> The rule of the way of a lifted pen (rules/drawing/travel.pl).
*/

:- set_prolog_flag(optimise, true).

%!  short_travel_by_rule(+Start, +Strokes, -Ordered) is det.
%
%   What short_travel/3 answers. Quadratic.

short_travel_by_rule(Start, Strokes, Ordered) :-
    maplist(sg_travel:with_ends, Strokes, Lines),
    travel(Lines, Start, Ordered0),
    sg_travel:shorter(Start, Strokes, Ordered0, Ordered).

travel([], _, []) :-
    !.
travel([Line|Lines], At, [Stroke|Strokes]) :-
    nearer_end(Line, At, Way),
    nearest(Lines, At, Way-Line, _-Nearest),
    selectchk(Nearest, [Line|Lines], Rest),
    drawn_from(Nearest, At, Stroke, End),
    travel(Rest, End, Strokes).

nearest([], _, Best, Best).
nearest([Line|Lines], At, Way0-Line0, Best) :-
    nearer_end(Line, At, Way),
    (   Way < Way0
    ->  nearest(Lines, At, Way-Line, Best)
    ;   nearest(Lines, At, Way0-Line0, Best)
    ).

nearer_end(line(First,Last,_), At, Way) :-
    sg_travel:way(At, First, WayFirst),
    sg_travel:way(At, Last, WayLast),
    Way is min(WayFirst, WayLast).

%   drawn_from(Line, At, Stroke, End): Stroke is drawn from the end nearer to
%   At, and stops at End.

drawn_from(line(First,Last,Stroke0), At, Stroke, End) :-
    sg_travel:way(At, First, WayFirst),
    sg_travel:way(At, Last, WayLast),
    (   WayFirst =< WayLast
    ->  Stroke = Stroke0,
        End = Last
    ;   sg_travel:backwards(Stroke0, Stroke),
        End = First
    ).
