:- module(sg_pattern_kerf,
          [ kerf_strokes/4              % +Kerf, +Piece, +Strokes0, -Strokes
          ]).
:- use_module('../kernel', [shapes_add/2, shapes_free/3, shapes_open/2]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists), [append/3, last/2, member/2, selectchk/3]).
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

% A step so long, where bends of two kinds meet, may go.
longest_step(100).

%!  kerf_strokes(+Kerf, +Piece, +Strokes0, -Strokes) is det.
%
%   Strokes are Strokes0 (stroke.pl), what is cut of Piece, where the rings
%   among them are moved outwards by half of Kerf, in millimetres. Each side
%   stays parallel to what it was; a step of 0.1 mm or less may go.
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

stroke_moved(Off, stroke(V,Role,D,Es0,Points,ring,ring),
             stroke(V,Role,D,Es,[Begin|Moved],ring,ring)) :-
    !,
    sides(Points, Es0, Sides),
    sides_moved(Sides, Off, Es, Moved),
    last(Moved, Begin).
stroke_moved(_, Stroke, Stroke).

%   sides(Points, Es, Sides): Sides are side(A, B, U, V, E), in direction U, V.

sides([A,B|Points], [E|Es], [side(A,B,U,V,E)|Sides]) :-
    !,
    direction(A, B, U, V),
    sides([B|Points], Es, Sides).
sides(_, _, []).

%   sides_moved(Sides, Off, Es, Moved): each side has its direction still. A
%   step that would turn round goes, and its neighbours meet.

sides_moved(Sides, Off, Es, Moved) :-
    last(Sides, Last),
    corners_moved([Last|Sides], Off, [Own|Owns]),
    append(Owns, [Own], Ends),
    (   turned(Sides, [Own|Owns], Ends, Side)
    ->  is_step(Side),
        selectchk(Side, Sides, Fewer),
        Fewer = [_,_,_|_],
        sides_moved(Fewer, Off, Es, Moved)
    ;   sides_ended(Sides, Ends, Es, Moved)
    ).

%   turned(Sides, Begins, Ends, Side) is semidet: Side is the first that turns
%   round.

turned([Side0|Sides], [Begin|Begins], [End|Ends], Side) :-
    Side0 = side(_,_,U,V,_),
    last(Begin, XP-YP),
    End = [XQ-YQ|_],
    (   (XQ-XP)*U + (YQ-YP)*V > 0
    ->  turned(Sides, Begins, Ends, Side)
    ;   Side = Side0
    ).

%   is_step(Side) is semidet: shorter than anybody cuts.

is_step(side(XA-YA,XB-YB,U,V,_)) :-
    longest_step(Most),
    (XB-XA)*U + (YB-YA)*V =< Most.

%   The cut of a sharp corner is of edge 0.

sides_ended([side(_,_,_,_,E)|Sides], [End|Ends], Es, Moved) :-
    append(End, Moved1, Moved),
    (   End = [_,_]
    ->  Es = [E,0|Es1]
    ;   Es = [E|Es1]
    ),
    sides_ended(Sides, Ends, Es1, Moved1).
sides_ended([], [], [], []).

%   corners_moved([S,T|Sides], Off, Owns): Owns are where the corner of S and T,
%   and of those that follow, goes: one place, or two if it is sharp.

corners_moved([S,T|Sides], Off, [Own|Owns]) :-
    !,
    S = side(_,_,U1,V1,_),
    T = side(_,_,U2,V2,_),
    corner_of(S, T, Off, X, Y),
    corner_moved(U1, V1, X, Y, U2, V2, Off, Own),
    corners_moved([T|Sides], Off, Owns).
corners_moved(_, _, []).

%   corner_of(S, T, Off, X, Y) is semidet: where they meet, not far from their
%   ends if there was a side between them.

corner_of(side(_,X-Y,_,_,_), side(X-Y,_,_,_,_), _, X, Y) :-
    !.
corner_of(side(_,XB-YB,U1,V1,_), side(XC-YC,_,U2,V2,_), Off, X, Y) :-
    Sine is U1*V2 - V1*U2,
    Far is (XC-XB)*V2 - (YC-YB)*U2,
    abs(Far) =< 4*Off*abs(Sine),
    abs(Sine) > 0,
    X is XB + Far/Sine*U1,
    Y is YB + Far/Sine*V1.

%   On the sheet y is down; seen with y up the piece lies on the left of its
%   sides.

corner_moved(U1, V1, XB, YB, U2, V2, Off, Corners) :-
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
