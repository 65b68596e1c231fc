:- module(sg_travel,
          [ short_travel/2,             % +Strokes, -Ordered
            short_travel_by_rule/2,     % +Strokes, -Ordered
            travel_length/2             % +Strokes, -Length
          ]).
:- use_module('../kernel', [travel_order/2]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists), [last/2, reverse/2, selectchk/3]).
/** <module> Travel: strokes in an order that a lifted pen likes.

From where a stroke ends the pen goes to the nearest end of those not yet
drawn, and draws from there.
*/

:- set_prolog_flag(optimise, true).

%!  short_travel(+Strokes, -Ordered) is det.
%
%   Ordered are Strokes (stroke.pl) in a better order for a plotter that
%   begins at 0-0, some of them backwards.

short_travel(Strokes, Ordered) :-
    travel_order(Strokes, Order),
    compound_name_arguments(Array, strokes, Strokes),
    maplist(ordered_stroke(Array), Order, Ordered).

ordered_stroke(Array, I, Stroke) :-
    (   I > 0
    ->  arg(I, Array, Stroke)
    ;   J is -I,
        arg(J, Array, Stroke0),
        backwards(Stroke0, Stroke)
    ).

%!  short_travel_by_rule(+Strokes, -Ordered) is det.
%
%   The same: what short_travel/2 means. The kernel travel_order/2 stands in
%   for it. Quadratic.

short_travel_by_rule(Strokes, Ordered) :-
    maplist(with_ends, Strokes, Lines),
    travel(Lines, 0-0, Ordered).

%   line(First,Last,Stroke)

with_ends(Stroke, line(First,Last,Stroke)) :-
    Stroke = stroke(_, _, _, _, Points, _, _),
    Points = [First|_],
    last(Points, Last).

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

%   The square of the way: it is only compared.

way(XA-YA, XB-YB, Way) :-
    X is float(XB-XA),
    Y is float(YB-YA),
    Way is X*X + Y*Y.

%   drawn_from(Line, At, Stroke, End): Stroke is drawn from the end nearer to
%   At, and stops at End.

drawn_from(line(First,Last,Stroke0), At, Stroke, End) :-
    way(At, First, WayFirst),
    way(At, Last, WayLast),
    (   WayFirst =< WayLast
    ->  Stroke = Stroke0,
        End = Last
    ;   backwards(Stroke0, Stroke),
        End = First
    ).

backwards(stroke(Visibility,Role,S,Es0,Points0,Start,End),
          stroke(Visibility,Role,S,Es,Points,End,Start)) :-
    reverse(Es0, Es),
    reverse(Points0, Points).

%!  travel_length(+Strokes, -Length) is det.
%
%   Length is how far the pen goes lifted, from 0-0 on, if it draws Strokes in
%   this order; in the unit of their points.

travel_length(Strokes, Length) :-
    foldl(travelled, Strokes, (0-0)-0.0, _-Length).

travelled(Stroke, At-Length0, Last-Length) :-
    with_ends(Stroke, line(First,Last,_)),
    way(At, First, Way),
    Length is Length0 + sqrt(Way).
