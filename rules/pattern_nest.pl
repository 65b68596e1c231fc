:- module(sg_pattern_nest,
          [ nested/3,                   % +Outlines, +Paper, -Nested
            fits_on/2,                  % +Points, +Paper
            least_box/4                 % +Points, -Degrees, -Width, -Height
          ]).
:- use_module(kernel, [nest/6]).
:- autoload(library(apply), [foldl/4, maplist/3, maplist/4]).
:- autoload(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- autoload(library(lists),
            [ append/2, append/3, last/2, max_list/2, member/2, reverse/2,
              sum_list/2
            ]).
:- autoload(library(pairs), [pairs_keys_values/3, pairs_values/2]).
/** <module> Pieces laid on sheets: turned, close together, none on another.

The kernel nest/6 places them; here it is decided at which angles and in which
order they are tried: upright, lying and with the least box round them; the
large ones first. Paper is what is free of a sheet,

    room(Width, Height, Gap)     a page, as many as are needed
    roll(Gap)                    one sheet, as large as needed

in millimetres; Gap is how far apart pieces stay.
*/

:- set_prolog_flag(optimise, true).

%!  nested(+Outlines, +Paper, -Nested) is det.
%
%   Nested is nested(Size,Places). Outlines are Name-Loops, lists of X-Y; Places
%   are Name-place(Sheet,Degrees,DX,DY) in the same order: turned
%   counter-clockwise, then moved. Size, W-H, is that of the room, or of what is
%   needed of a roll.

nested(Outlines, Paper, nested(Size,Places)) :-
    maplist(outline_ways, Outlines, Ranked0),
    keysort(Ranked0, Ranked),
    pairs_values(Ranked, Sorted),
    maplist(outline_piece, Sorted, Names, Pieces),
    paper_nesting(Paper, Sorted, W-H, One, Gap),
    square(W, H, Gap, Paper, Square),
    Squares is max(1, ceiling(Gap/Square)),
    nest(W-H, Square, Squares, One, Pieces, Places0),
    pairs_keys_values(Pairs0, Names, Places0),
    list_to_assoc(Pairs0, ByName),
    findall(Name-Place,
            ( member(Name-_, Outlines), get_assoc(Name, ByName, Place) ),
            Places),
    used_size(Paper, W-H, Sorted, Pairs0, Size).

outline_piece(way(Name,Loops,Angles,_,_), Name, piece(Angles,Loops)).

%   The larger a piece is the earlier it is placed. A table, table(D,Part), is
%   read from below or from the right.

outline_ways(Name-Loops, Rank-way(Name,Loops,[0.0,90.0],W,H)) :-
    Name = table(_, _),
    !,
    append(Loops, Points),
    points_box(Points, W, H),
    Rank is -round(1000*max(W,H)).
outline_ways(Name-Loops, Rank-way(Name,Loops,Angles,Width,Height)) :-
    append(Loops, Points),
    points_box(Points, W, H),
    least_box(Points, Degrees, LeastW, LeastH),
    (   LeastW*LeastH > 0.98*W*H
    ->  Width = W,
        Height = H,
        Angles = [0.0,90.0,180.0,270.0]
    ;   Width = LeastW,
        Height = LeastH,
        findall(Angle,
                ( member(Turn, [0.0,90.0,180.0,270.0]),
                  ( Angle is Degrees+Turn ; Angle = Turn )
                ),
                Angles)
    ),
    Rank is -round(1000*max(W,H)).

paper_nesting(room(W,H,Gap), _, W-H, false, Gap).
paper_nesting(roll(Gap), Ways, Width-Height, true, Gap) :-
    findall(Area, ( member(way(_,_,_,W,H), Ways),
                    Area is (W+Gap)*(H+Gap) ), Areas),
    sum_list(Areas, All),
    findall(W, member(way(_,_,_,W,_), Ways), Ws),
    findall(Side, ( member(way(_,_,_,W,H), Ways), Side is max(W, H)+Gap ),
            Sides),
    max_list([1.0|Ws], Widest),
    sum_list(Sides, Longest),
    Width is max(Widest*1.02+Gap, sqrt(1.15*All)),
    Height is max(1.0, min(Longest*1.1+Gap, 40*Width)).

%   About 400 squares along the longer side of a page; of a roll along the
%   width.

square(W, H, Gap, room(_,_,_), Square) :-
    !,
    Square is max(max(W,H)/400, Gap/90).
square(W, H, Gap, roll(_), Square) :-
    Square is max(max(W/400, H/16000), Gap/90).

used_size(room(_,_,_), Size, _, _, Size).
used_size(roll(_), _, Ways, Pairs, W-H) :-
    findall(X-Y,
            ( member(way(Name,Loops,_,_,_), Ways),
              memberchk(Name-place(_,Degrees,DX,DY), Pairs),
              member(Loop, Loops),
              member(Point, Loop),
              turned(Degrees, Point, X0-Y0),
              X is X0+DX,
              Y is Y0+DY
            ),
            Points),
    foldl(farther, Points, 1.0-1.0, W-H).

farther(X-Y, X0-Y0, X1-Y1) :-
    X1 is max(X0, X),
    Y1 is max(Y0, Y).

turned(Degrees, X0-Y0, X-Y) :-
    Angle is Degrees*pi/180,
    X is X0*cos(Angle) - Y0*sin(Angle),
    Y is X0*sin(Angle) + Y0*cos(Angle).

%!  fits_on(+Points, +Paper) is semidet.
%
%   True when a piece with these Points can be nested on one sheet.

fits_on(_, roll(_)) :-
    !.
fits_on(Points, Paper) :-
    Paper = room(RoomW, RoomH, Gap),
    square(RoomW, RoomH, Gap, Paper, Square),
    Width is RoomW-2.1*Square,
    Height is RoomH-2.1*Square,
    (   points_box(Points, W, H)
    ;   least_box(Points, _, W, H)
    ),
    (   W =< Width,
        H =< Height
    ;   H =< Width,
        W =< Height
    ),
    !.

points_box(Points, W, H) :-
    Points = [X-Y|_],
    foldl(boxed, Points, box(X,Y,X,Y), box(X1,Y1,X2,Y2)),
    W is X2-X1,
    H is Y2-Y1.

boxed(X-Y, box(X1,Y1,X2,Y2), box(X3,Y3,X4,Y4)) :-
    X3 is min(X1, X),
    Y3 is min(Y1, Y),
    X4 is max(X2, X),
    Y4 is max(Y2, Y).

%!  least_box(+Points, -Degrees, -Width, -Height) is det.
%
%   Turned by Degrees the box round Points has the least area of all that lie
%   along a side of their hull; it is not higher than wide.

least_box(Points, Degrees, Width, Height) :-
    hull(Points, Hull),
    hull_degrees(Hull, Angles),
    findall(box(Area,Angle,W,H),
            ( member(Angle, Angles),
              maplist(turned(Angle), Hull, Turned),
              points_box(Turned, W, H),
              Area is round(W*H*1.0e6)
            ),
            Boxes),
    msort(Boxes, [box(_,Degrees0,W0,H0)|_]),
    (   W0 >= H0
    ->  Degrees = Degrees0, Width = W0, Height = H0
    ;   Degrees is Degrees0+90, Width = H0, Height = W0
    ).

%   At most some hundred directions.

hull_degrees(Hull, Angles) :-
    last(Hull, Last),
    append(Hull, [], Points),
    length(Points, N),
    Step is max(1, N//100),
    hull_sides(Points, Last, Step, 0, Angles0),
    sort([0.0|Angles0], Angles).

hull_sides([], _, _, _, []).
hull_sides([X-Y|Points], X0-Y0, Step, I, Angles) :-
    (   I mod Step =:= 0,
        ( X =\= X0 ; Y =\= Y0 )
    ->  Angle0 is -atan2(Y-Y0, X-X0)*180/pi,
        Angle is Angle0 - 90*floor(Angle0/90),
        Angles = [Angle|Angles1]
    ;   Angles = Angles1
    ),
    I1 is I+1,
    hull_sides(Points, X-Y, Step, I1, Angles1).

hull(Points, Hull) :-
    sort(Points, Sorted),
    (   Sorted = [_,_,_|_]
    ->  half_hull(Sorted, Lower),
        reverse(Sorted, Backwards),
        half_hull(Backwards, Upper),
        append(Lower, Upper, Hull)
    ;   Hull = Sorted
    ).

%   Without its last point, which begins the other half.

half_hull(Points, Half) :-
    foldl(hulled, Points, [], [_|Half]).

hulled(C, [B,A|Rest], Hull) :-
    A = XA-YA,
    B = XB-YB,
    C = XC-YC,
    (XB-XA)*(YC-YA) - (YB-YA)*(XC-XA) =< 0,
    !,
    hulled(C, [A|Rest], Hull).
hulled(C, Points, [C|Points]).
