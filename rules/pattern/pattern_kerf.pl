:- module(sg_pattern_kerf,
          [ kerf_strokes/4              % +Kerf, +Piece, +Strokes0, -Strokes
          ]).
:- use_module('../kernel', [shapes_add/2, shapes_free/3, shapes_open/2]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists), [append/3, last/2, member/2]).
/** <module> Outlines with an allowance for the kerf.

A laser, a plasma or a water jet takes away a kerf as wide as its beam. So that
the piece has its true size the beam goes half a kerf outside of the outline,
and half a kerf inside of each hole. A slit whose sides lie on each other stays
as it is: the beam takes half a kerf from each.
*/

:- set_prolog_flag(optimise, true).

% Corners are rounded to thousandths of a millimetre; so much, of these, sides
% may go through each other.
tolerance(2.0).

% A corner sticks out by no more than so many half kerfs; a sharper one is cut
% off.
most_mitre(4.0).

%!  kerf_strokes(+Kerf, +Piece, +Strokes0, -Strokes) is det.
%
%   Strokes are Strokes0 (stroke.pl), what is cut of Piece, where the rings
%   among them are moved outwards by half of Kerf, in millimetres. Each side
%   stays parallel to what it was.
%
%   @error usage_error(pattern(kerf(Kerf, Piece))): something is narrower than
%          that, so that sides would vanish, or cross

kerf_strokes(Kerf, Piece, Strokes0, Strokes) :-
    (   Kerf =:= 0
    ->  Strokes = Strokes0
    ;   Off is Kerf*500,
        (   maplist(stroke_moved(Off), Strokes0, Strokes),
            apart(Strokes)
        ->  true
        ;   throw(error(usage_error(pattern(kerf(Kerf, Piece))), _))
        )
    ).

stroke_moved(Off, stroke(V,Role,D,Es0,[Last|Corners],ring,ring),
             stroke(V,Role,D,Es,[Begin|Moved],ring,ring)) :-
    !,
    Corners = [First|_],
    append([Last|Corners], [First], Round),
    corners_moved(Round, Off, Owns),
    last(Owns, OwnLast),
    sides_moved([Last|Corners], [OwnLast|Owns], Es0, Es, Moved),
    last(Moved, Begin).
stroke_moved(_, Stroke, Stroke).

%   corners_moved([A,B,C|Corners], Off, Owns): Owns are where each of B, C, ...
%   goes: one place, or two if it is sharp.

corners_moved([A,B,C|Corners], Off, Owns) :-
    !,
    corner_moved(A, B, C, Off, Own),
    Owns = [Own|Owns1],
    corners_moved([B,C|Corners], Off, Owns1).
corners_moved(_, _, []).

%   sides_moved(Corners, Owns, Es0, Es, Moved): each side has its direction
%   still. The cut of a sharp corner is of edge 0.

sides_moved([A,B|Corners], [OwnA,OwnB|Owns], [E|Es0], Es, Moved) :-
    !,
    last(OwnA, XP-YP),
    OwnB = [XQ-YQ|_],
    A = XA-YA,
    B = XB-YB,
    (XQ-XP)*(XB-XA) + (YQ-YP)*(YB-YA) > 0,
    append(OwnB, Moved1, Moved),
    (   OwnB = [_,_]
    ->  Es = [E,0|Es1]
    ;   Es = [E|Es1]
    ),
    sides_moved([B|Corners], [OwnB|Owns], Es0, Es1, Moved1).
sides_moved(_, _, _, [], []).

%   On the sheet y is down; seen with y up the piece lies on the left of its
%   sides.

corner_moved(XA-YA, XB-YB, XC-YC, Off, Corners) :-
    direction(XA-YA, XB-YB, U1, V1),
    direction(XB-YB, XC-YC, U2, V2),
    Half is 1 + U1*U2 + V1*V2,
    most_mitre(Most),
    (   V1*U2 > U1*V2,
        Half*Most*Most < 2
    ->  X1 is round(XB - Off*(V1-U1)),
        Y1 is round(YB + Off*(U1+V1)),
        X2 is round(XB - Off*(V2+U2)),
        Y2 is round(YB + Off*(U2-V2)),
        Corners = [X1-Y1,X2-Y2]
    ;   Half > 0,
        X is round(XB - Off*(V1+V2)/Half),
        Y is round(YB + Off*(U1+U2)/Half),
        Corners = [X-Y]
    ).

direction(XA-YA, XB-YB, U, V) :-
    Length is sqrt((XB-XA)**2 + (YB-YA)**2),
    U is (XB-XA)/Length,
    V is (YB-YA)/Length.

%   apart(Strokes): no side of a ring goes through another one.

apart(Strokes) :-
    findall([A,B],
            ( member(stroke(_,_,_,_,Points,ring,_), Strokes),
              append(_, [A,B|_], Points),
              A \== B ),
            Sides),
    foldl(longer, Sides, 0-0, N-Sum),
    Cell is 1.0 + Sum/max(1, N),
    shapes_open(Cell, Shapes),
    tolerance(Tolerance),
    \+ ( member(Side, Sides),
         \+ ( shapes_free(Shapes, Side, Tolerance),
              shapes_add(Shapes, Side) ) ).

longer([XA-YA,XB-YB], N0-Sum0, N-Sum) :-
    N is N0+1,
    Sum is Sum0 + max(abs(XB-XA), abs(YB-YA)).
