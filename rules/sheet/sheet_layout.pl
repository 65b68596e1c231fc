:- module(sg_sheet_layout,
          [ layout/4                    % +Sights, +Room, +Scale, -Places
          ]).
:- use_module(library(apply), [include/3, maplist/3, maplist/4]).
:- use_module(library(lists),
              [ append/3, max_list/2, member/2, min_list/2, nth0/3, sum_list/2
              ]).
:- use_module(library(pairs), [pairs_values/2]).
:- use_module(library(yall), [(>>)/4]).
/** <module> Where the views of a sheet stand.

    sight(Name, Cell, Box, Pads)    a view that wants a place
    Cell    at(Column,Row), integers, right and down; or free
    Box     box(X1,Y1,X2,Y2) round its lines in the picture, y up
    Pads    pads(Left,Above,Right,Below), mm, for what is written round it
    Room    room(Rectangle, Taken): the free part of the sheet, without Taken
    place(Name, X, Y, Left, Top)    the point X,Y of the picture comes to
                                    Left,Top on the sheet

A rectangle is rect(X1,Y1,X2,Y2), mm, y down. Views in one column have the same
X and Left, those in one row the same Y and Top; so a point that they share is
in them at the very same place across the sheet, or down it. A free view comes
where there is most room. No two views overlap, nor a view and what is Taken.
*/

:- set_prolog_flag(optimise, true).

% At least so many millimetres between views.
gap(12.0).

%!  layout(+Sights, +Room, +Scale, -Places) is semidet.
%
%   Places has a place for each of Sights, Scale being millimetres for a unit of
%   the picture. Fails if there is not room for all.

layout(Sights, Room, Scale, Places) :-
    partition_sights(Sights, Fixed, Free),
    tracks(column, Fixed, Scale, Columns),
    tracks(row, Fixed, Scale, Rows),
    Room = room(rect(X1,Y1,X2,Y2), Taken),
    Width is X2-X1,
    Height is Y2-Y1,
    spread(Spread),
    track_starts(Columns, Spread, Width, Starts, BlockWidth),
    track_starts(Rows, Spread, Height, Tops, BlockHeight),
    stand(At),
    At = DX-DY,
    Left is X1 + (Width-BlockWidth)*DX,
    Top is Y1 + (Height-BlockHeight)*DY,
    maplist(fixed_place(Columns, Starts, Left, Rows, Tops, Top), Fixed,
            FixedPlaces),
    maplist(place_rectangle(Scale), Fixed, FixedPlaces, Rectangles),
    \+ ( member(R1, Rectangles), member(R2, Taken), overlap(R1, R2) ),
    append(Taken, Rectangles, Taken1),
    free_places(Free, Scale, rect(X1,Y1,X2,Y2), Taken1, FreePlaces),
    append(FixedPlaces, FreePlaces, Places),
    !.

%   What is tried first: views spread over the sheet, in the middle.

spread(1.0).
spread(0.5).
spread(0.0).

stand(DX-DY) :-
    member(DX-DY, [ 0.5-0.5, 0.3-0.5, 0.5-0.3, 0.3-0.3, 0.0-0.5, 0.5-0.0,
                    0.0-0.0, 1.0-0.5, 1.0-0.0, 0.5-1.0, 0.0-1.0, 1.0-1.0 ]).

partition_sights(Sights, Fixed, Free) :-
    include(is_fixed, Sights, Fixed),
    findall(Area-Sight,
            ( member(Sight, Sights),
              Sight = sight(_, free, box(X1,Y1,X2,Y2), _),
              Area is (X1-X2)*(Y2-Y1)
            ),
            Keyed0),
    keysort(Keyed0, Keyed),             % the largest first
    pairs_values(Keyed, Free).

is_fixed(sight(_,at(_,_),_,_)).


                /*******************************
                *       COLUMNS AND ROWS       *
                *******************************/

%   tracks(Which, Sights, Scale, Tracks): a track is track(N,Origin,Before,
%   Length): column or row N, the picture's coordinate at its start (the left,
%   or the upper end), millimetres before that for pads, and how long it is.

tracks(Which, Sights, Scale, Tracks) :-
    findall(N, ( member(Sight, Sights), sight_span(Which, Sight, N, _, _, _, _)
               ),
            Ns0),
    sort(Ns0, Ns),
    maplist(track(Which, Sights, Scale), Ns, Tracks).

track(Which, Sights, Scale, N, track(N,Origin,Before,Length)) :-
    findall(span(From,To,PadFrom,PadTo),
            ( member(Sight, Sights),
              sight_span(Which, Sight, N, From, To, PadFrom, PadTo)
            ),
            Spans),
    maplist([span(A,_,_,_),A]>>true, Spans, Froms),
    maplist([span(_,A,_,_),A]>>true, Spans, Tos),
    maplist([span(_,_,A,_),A]>>true, Spans, PadsFrom),
    maplist([span(_,_,_,A),A]>>true, Spans, PadsTo),
    min_list(Froms, Low),
    max_list(Tos, High),
    max_list(PadsFrom, Before),
    max_list(PadsTo, After),
    start_coordinate(Which, Low, High, Origin),
    Length is Before + (High-Low)*Scale + After.

sight_span(column, sight(_,at(N,_),box(X1,_,X2,_),pads(L,_,R,_)), N, X1, X2,
           L, R).
sight_span(row, sight(_,at(_,N),box(_,Y1,_,Y2),pads(_,A,_,B)), N, Y1, Y2, A,
           B).

start_coordinate(column, Low, _, Low).
start_coordinate(row, _, High, High).

%   track_starts(Tracks, Spread, Room, Starts, Length): where each starts, from
%   the start of the first, and how long all are with the gaps between them.

track_starts(Tracks, Spread, Room, Starts, Length) :-
    maplist([track(_,_,_,L),L]>>true, Tracks, Lengths),
    sum_list(Lengths, Sum),
    length(Lengths, N),
    gap(Least),
    Even is (Room-Sum)/(N+1),
    Gap is Least + Spread*max(0, min(Even, 4*Least)-Least),
    Length is Sum + max(0, N-1)*Gap,
    Length =< Room,
    starts(Lengths, 0.0, Gap, Starts).

starts([], _, _, []).
starts([Length|Lengths], At, Gap, [At|Starts]) :-
    Next is At+Length+Gap,
    starts(Lengths, Next, Gap, Starts).

fixed_place(Columns, Starts, Left0, Rows, Tops, Top0,
            sight(Name,at(Column,Row),_,_), place(Name,X,Y,Left,Top)) :-
    track_place(Columns, Starts, Left0, Column, X, Left),
    track_place(Rows, Tops, Top0, Row, Y, Top).

track_place(Tracks, Starts, From, N, Origin, At) :-
    nth0(I, Tracks, track(N,Origin,Before,_)),
    !,
    nth0(I, Starts, Start),
    At is From+Start+Before.

%   place_rectangle(Scale, Sight, Place, Rectangle): with its pads.

place_rectangle(Scale, sight(_,_,box(X1,Y1,X2,Y2),pads(L,A,R,B)),
                place(_,X,Y,Left,Top), rect(RX1,RY1,RX2,RY2)) :-
    RX1 is Left + (X1-X)*Scale - L,
    RX2 is Left + (X2-X)*Scale + R,
    RY1 is Top + (Y-Y2)*Scale - A,
    RY2 is Top + (Y-Y1)*Scale + B.

overlap(rect(A1,B1,A2,B2), rect(C1,D1,C2,D2)) :-
    A1 < C2,
    C1 < A2,
    B1 < D2,
    D1 < B2.


                /*******************************
                *          FREE VIEWS          *
                *******************************/

%   free_places(Sights, Scale, Whole, Taken, Places): one after the other, each
%   in the middle of the largest empty rectangle that holds it.

free_places([], _, _, _, []).
free_places([Sight|Sights], Scale, Whole, Taken, [Place|Places]) :-
    Sight = sight(Name, _, box(X1,_,_,Y2), pads(L,A,_,_)),
    sight_size(Sight, Scale, W, H),
    maplist(with_gap, Taken, Around),
    findall(Area-Empty,
            ( empty_rectangle(Whole, Around, W, Empty),
              Empty = rect(EX1,EY1,EX2,EY2),
              EX2-EX1 >= W,
              EY2-EY1 >= H,
              Area is (EX1-EX2)*(EY2-EY1)
            ),
            Found0),
    keysort(Found0, [_-rect(EX1,EY1,EX2,EY2)|_]),
    Left is (EX1+EX2-W)/2 + L,
    Top is (EY1+EY2-H)/2 + A,
    Place = place(Name, X1, Y2, Left, Top),
    place_rectangle(Scale, Sight, Place, Rectangle),
    free_places(Sights, Scale, Whole, [Rectangle|Taken], Places).

sight_size(sight(_,_,box(X1,Y1,X2,Y2),pads(L,A,R,B)), Scale, W, H) :-
    W is (X2-X1)*Scale + L + R,
    H is (Y2-Y1)*Scale + A + B.

with_gap(rect(X1,Y1,X2,Y2), rect(A1,B1,A2,B2)) :-
    gap(Gap0),
    Gap is Gap0*0.75,
    A1 is X1-Gap,
    B1 is Y1-Gap,
    A2 is X2+Gap,
    B2 is Y2+Gap.

%   empty_rectangle(Whole, Taken, W, Empty): a rectangle in Whole that is at
%   least W wide and no higher one of that place is empty.

empty_rectangle(rect(X1,Y1,X2,Y2), Taken, W, rect(EX1,EY1,EX2,EY2)) :-
    (   EX1 = X1
    ;   member(rect(_,_,EX1,_), Taken), EX1 > X1
    ),
    (   EX2 = X2
    ;   member(rect(EX2,_,_,_), Taken), EX2 < X2
    ),
    EX2-EX1 >= W,
    findall(B1-B2,
            ( member(rect(A1,B1,A2,B2), Taken), A1 < EX2, EX1 < A2 ),
            Bands0),
    msort(Bands0, Bands),
    free_band(Bands, Y1, Y2, EY1, EY2).

%   free_band(Bands, From, To, Y1, Y2): between bands, by ascending start.

free_band([], Y1, Y2, Y1, Y2) :-
    Y1 < Y2.
free_band([B1-B2|Bands], From, To, Y1, Y2) :-
    (   From < B1,
        Y1 = From,
        Y2 is min(B1, To)
    ;   Next is max(From, B2),
        free_band(Bands, Next, To, Y1, Y2)
    ).
