:- module(sg_oracle_travel,
          [ short_travel_by_rule/3      % +Start, +Strokes, -Ordered
          ]).
:- use_module('../../rules/drawing/travel', []).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists), [last/2, selectchk/3]).
/** <module> The rule of the way of a lifted pen (rules/drawing/travel.pl).
*/

:- set_prolog_flag(optimise, true).

%!  short_travel_by_rule(+Start, +Strokes, -Ordered) is det.
%
%   Strokes as travel/4 has them drawn, shortly. Quadratic.

short_travel_by_rule(Start, Strokes, Ordered) :-
    maplist(with_ends, Strokes, Lines),
    travel(Lines, Start, Ordered0),
    shorter(Start, Strokes, Ordered0, Ordered).

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
    way(At, First, WayFirst),
    way(At, Last, WayLast),
    Way is min(WayFirst, WayLast).

%   drawn_from(Line, At, Stroke, End): Stroke is drawn from the end nearer to
%   At, and stops at End.

drawn_from(line(First,Last,Stroke0), At, Stroke, End) :-
    way(At, First, WayFirst),
    way(At, Last, WayLast),
    (   WayFirst =< WayLast
    ->  Stroke = Stroke0,
        End = Last
    ;   sg_travel:backwards(Stroke0, Stroke),
        End = First
    ).

shorter(Start, Strokes0, Strokes1, Strokes) :-
    travel_length(Start, Strokes0, Length0),
    travel_length(Start, Strokes1, Length1),
    (   Length1 < Length0
    ->  Strokes = Strokes1
    ;   Strokes = Strokes0
    ).

travel_length(Start, Strokes, Length) :-
    foldl(travelled, Strokes, Start-0.0, _-Length).

travelled(Stroke, At-Length0, Last-Length) :-
    with_ends(Stroke, line(First,Last,_)),
    way(At, First, Way),
    Length is Length0 + sqrt(Way).

%   line(First,Last,Stroke)

with_ends(Stroke, line(First,Last,Stroke)) :-
    Stroke = stroke(_, _, _, _, Points, _, _),
    Points = [First|_],
    last(Points, Last).

%   The square of the way: it is only compared.

way(XA-YA, XB-YB, Way) :-
    X is float(XB-XA),
    Y is float(YB-YA),
    Way is X*X + Y*Y.
