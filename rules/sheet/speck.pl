:- module(sg_speck,
          [ without_specks/3            % +Least, +Views0, -Views
          ]).
:- use_module(stroke, [all_strokes/2]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists), [last/2, member/2]).
:- use_module(library(rbtrees), [rb_empty/1, rb_insert_new/4, rb_lookup/3,
                                 rb_update/5]).
/** <module> Specks: short lines that hang on no other one.

A scanned surface is rough, and where it bends for a moment there is a crease
that leads nowhere. Such lines are left out if somebody asks for that; a short
line that goes on as another one stays, and so does one that ends on another
one, or so near to it that they touch as they are drawn. So an outline keeps
its pieces, though they may end a hair from one another.

Ends of short lines are in squares of the sheet; a line is looked at in those
that it passes.
*/

%   How near lines touch as they are drawn, how wide the squares are, and how
%   far apart the points are at which a line is looked up, in thousandths of a
%   millimetre. Squares within Near and half of Step of an end have all lines
%   that touch it.

touching(250).
square(1000).
step(500).

%!  without_specks(+Least, +Views0, -Views) is det.
%
%   Views are Views0 without the strokes of segments that are shorter than Least
%   millimetres, do not close, and at whose ends no other stroke of their view
%   is, within a quarter of a millimetre.

without_specks(Least, Views, Views) :-
    Least =:= 0,
    !.
without_specks(Least, Views0, Views) :-
    maplist(view_without(Least), Views0, Views).

view_without(Least, view(Name,Strokess,Texts), view(Name,Strokes,Texts)) :-
    all_strokes(Strokess, Strokes0),
    Most is Least*1000,
    rb_empty(None),
    foldl(ends_entered(Most), Strokes0, None, Squares0),
    (   Squares0 == None
    ->  Strokes = Strokes0
    ;   foldl(pieces_entered, Strokes0, 1-Squares0, _-Squares),
        without(Strokes0, 1, Most, Squares, Strokes)
    ).

%   without(Strokes0, I, Most, Squares, Strokes): I is the number of the first.

without([], _, _, _, []).
without([Stroke|Strokes0], I, Most, Squares, Strokes) :-
    (   is_speck(Most, Squares, Stroke, I)
    ->  Strokes = Strokes1
    ;   Strokes = [Stroke|Strokes1]
    ),
    J is I+1,
    without(Strokes0, J, Most, Squares, Strokes1).

stroke_ends(stroke(_,_,_,_,Points,_,_), First, Last) :-
    Points = [First|_],
    last(Points, Last).

%   short_ends(Most, Stroke, First, Last): of one of a segment that is shorter
%   than Most, thousandths, and open.

short_ends(Most, Stroke, First, Last) :-
    Stroke = stroke(_,_,S,_,[Start|Points],_,_),
    S > 0,                              % not of the sheet
    stroke_ends(Stroke, First, Last),
    First \== Last,
    foldl(longer, Points, Start-0, _-Length),
    Length < Most.

longer(X-Y, (X0-Y0)-Length0, (X-Y)-Length) :-
    Length is Length0 + sqrt((X-X0)**2 + (Y-Y0)**2).

is_speck(Most, Squares, Stroke, I) :-
    short_ends(Most, Stroke, First, Last),
    \+ ( member(End, [First,Last]), touches(Squares, I, End) ).

%   touches(Squares, I, End): a stroke other than I does.

touches(Squares, I, End) :-
    end_square(End, Square),
    rb_lookup(Square, Pieces, Squares),
    member(piece(J,A,B), Pieces),
    J =\= I,
    touching(Near),
    square_off(End, A, B, Off),
    Off =< Near*Near,
    !.

%   square_off(P, A, B, Square): the square of how far P is from the line A-B.

square_off(X-Y, XA-YA, XB-YB, Square) :-
    DX is XB-XA,
    DY is YB-YA,
    Length is DX*DX + DY*DY,
    (   Length =:= 0
    ->  At = 0
    ;   At is max(0, min(1, ((X-XA)*DX + (Y-YA)*DY)/Length))
    ),
    Square is (X - XA - At*DX)**2 + (Y - YA - At*DY)**2.


                /*******************************
                *            SQUARES           *
                *******************************/

ends_entered(Most, Stroke, Squares0, Squares) :-
    (   short_ends(Most, Stroke, First, Last)
    ->  findall(Square, ( member(End, [First,Last]), end_square(End, Square) ),
                New),
        foldl(square_entered, New, Squares0, Squares)
    ;   Squares = Squares0
    ).

square_entered(Square, Squares0, Squares) :-
    (   rb_insert_new(Squares0, Square, [], Squares1)
    ->  Squares = Squares1
    ;   Squares = Squares0
    ).

%   end_square(End, Square) is nondet.

end_square(X-Y, at(I,J)) :-
    touching(Near),
    step(Step),
    Reach is Near + Step//2,
    square(Size),
    I0 is (X-Reach) div Size,
    I1 is (X+Reach) div Size,
    J0 is (Y-Reach) div Size,
    J1 is (Y+Reach) div Size,
    between(I0, I1, I),
    between(J0, J1, J).

%   pieces_entered(Stroke, I-Squares0, J-Squares): the pieces of stroke I, in
%   squares that are there.

pieces_entered(stroke(_,_,_,_,[Start|Points],_,_), I-Squares0, J-Squares) :-
    J is I+1,
    foldl(piece_entered(I), Points, Start-Squares0, _-Squares).

piece_entered(I, B, A-Squares0, B-Squares) :-
    findall(Square, piece_square(A, B, Square), Passed0),
    sort(Passed0, Passed),
    foldl(passed(piece(I,A,B)), Passed, Squares0, Squares).

piece_square(XA-YA, XB-YB, at(I,J)) :-
    step(Step),
    square(Size),
    Steps is max(abs(XB-XA), abs(YB-YA))//Step + 1,
    between(0, Steps, K),
    I is (XA + (XB-XA)*K//Steps) div Size,
    J is (YA + (YB-YA)*K//Steps) div Size.

passed(Piece, Square, Squares0, Squares) :-
    (   rb_update(Squares0, Square, Pieces, [Piece|Pieces], Squares1)
    ->  Squares = Squares1
    ;   Squares = Squares0
    ).
