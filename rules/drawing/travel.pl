:- module(sg_travel,
          [ short_travel/3,             % +Start, +Strokes, -Ordered
            travel_length/3             % +Start, +Strokes, -Length
          ]).
:- use_module('../kernel', [travel_order/3]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists), [last/2, member/2, reverse/2]).
/** <module> Travel: strokes in an order that a lifted pen likes.

From where a stroke ends the pen goes to the nearest end of those not yet
drawn, and draws from there. That may leave ends behind that are far away; where
the way is no shorter than in the order that was given, that order stays.
*/

:- set_prolog_flag(optimise, true).

%!  short_travel(+Start, +Strokes, -Ordered) is det.
%
%   Ordered are Strokes (stroke.pl) in an order in which a plotter that begins
%   at Start, X-Y, has no longer way, some of them backwards.

short_travel(Start, Strokes, Ordered) :-
    travel_order(Start, Strokes, Order),
    compound_name_arguments(Array, strokes, Strokes),
    maplist(ordered_stroke(Array), Order, Ordered0),
    shorter(Start, Strokes, Ordered0, Ordered).

shorter(Start, Strokes0, Strokes1, Strokes) :-
    travel_length(Start, Strokes0, Length0),
    travel_length(Start, Strokes1, Length1),
    (   Length1 < Length0
    ->  Strokes = Strokes1
    ;   Strokes = Strokes0
    ).

ordered_stroke(Array, I, Stroke) :-
    (   I > 0
    ->  arg(I, Array, Stroke)
    ;   J is -I,
        arg(J, Array, Stroke0),
        backwards(Stroke0, Stroke)
    ).

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

backwards(stroke(Visibility,Role,S,Es0,Points0,Start,crossed(End,Marks0,L)),
          Stroke) :-
    !,
    findall(Mark, ( member(Mark0, Marks0), Mark is L-Mark0 ), Marks1),
    reverse(Marks1, Marks),
    backwards(stroke(Visibility,Role,S,Es0,Points0,crossed(Start,Marks,L),End),
              Stroke).
backwards(stroke(Visibility,Role,S,Es0,Points0,Start,End),
          stroke(Visibility,Role,S,Es,Points,End,Start)) :-
    reverse(Es0, Es),
    reverse(Points0, Points).

%!  travel_length(+Start, +Strokes, -Length) is det.
%
%   Length is how far the pen goes lifted, from Start on, if it draws Strokes in
%   this order; in the unit of their points.

travel_length(Start, Strokes, Length) :-
    foldl(travelled, Strokes, Start-0.0, _-Length).

travelled(Stroke, At-Length0, Last-Length) :-
    with_ends(Stroke, line(First,Last,_)),
    way(At, First, Way),
    Length is Length0 + sqrt(Way).
