:- module(sg_travel,
          [ short_travel/2              % +Strokes, -Ordered
          ]).
:- autoload(library(apply), [maplist/3]).
:- autoload(library(lists), [last/2, reverse/2, selectchk/3]).
/** <module> Travel: strokes in an order that a lifted pen likes.

From where a stroke ends the pen goes to the nearest end of those not yet
drawn, and draws from there. With very many strokes it looks only at the next
few hundred.
*/

:- set_prolog_flag(optimise, true).

% So many strokes are looked at for the next one.
window(400).

%!  short_travel(+Strokes, -Ordered) is det.
%
%   Ordered are Strokes (stroke.pl) in a better order for a plotter that
%   begins at 0-0, some of them backwards.

short_travel(Strokes, Ordered) :-
    window(N),
    maplist(with_ends, Strokes, Lines),
    travel(Lines, N, 0-0, Ordered).

%   line(First,Last,Stroke)

with_ends(Stroke, line(First,Last,Stroke)) :-
    Stroke = stroke(_, _, _, _, Points, _, _),
    Points = [First|_],
    last(Points, Last).

travel([], _, _, []) :-
    !.
travel([Line|Lines], N, At, [Stroke|Strokes]) :-
    nearer_end(Line, At, Way),
    nearest(Lines, N, At, Way-Line, _-Nearest),
    selectchk(Nearest, [Line|Lines], Rest),
    drawn_from(Nearest, At, Stroke, End),
    travel(Rest, N, End, Strokes).

nearest([Line|Lines], N, At, Way0-Line0, Best) :-
    N > 0,
    !,
    nearer_end(Line, At, Way),
    N1 is N-1,
    (   Way < Way0
    ->  nearest(Lines, N1, At, Way-Line, Best)
    ;   nearest(Lines, N1, At, Way0-Line0, Best)
    ).
nearest(_, _, _, Best, Best).

nearer_end(line(First,Last,_), At, Way) :-
    way(At, First, WayFirst),
    way(At, Last, WayLast),
    Way is min(WayFirst, WayLast).

%   The square of the way: it is only compared.

way(XA-YA, XB-YB, Way) :-
    Way is (XB-XA)*(XB-XA) + (YB-YA)*(YB-YA).

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
