:- module(sg_crossing,
          [ strokes_crossed/2           % +Strokes0, -Strokes
          ]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists), [append/3, member/2, nth1/3]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Where dashed lines cross.

Hidden lines meet in dashes where they cross, as ISO 128 wants it. So a stroke
that others cross knows where: its End is crossed(End0, Marks, Length), Marks
being how far from its start along it, Length how long it is; dash.pl fits its
dashes to that.
*/

:- set_prolog_flag(optimise, true).

%   More pieces than that stay as they are: who would look at each crossing?

most_pieces(3000).

%   In thousandths of the sheet: cells in which pieces are compared; how near an
%   end counts as on a line; how far apart two marks are.

cell_size(10000).
near_enough(20).
apart(200).

%   Lines that cross at less than 10 degrees run beside each other.

least_sine(0.17).

%!  strokes_crossed(+Strokes0, -Strokes) is det.
%
%   Strokes are Strokes0 (stroke.pl), in order, with marks where one crosses
%   another one, or itself, or ends on it. Those that nothing crosses, and all
%   of more than 3,000 pieces, stay as they are.

strokes_crossed(Strokes0, Strokes) :-
    most_pieces(Most),
    (   few_pieces(Strokes0, Most),
        findall(piece(K,I,X1,Y1,X2,Y2),
                ( nth1(K, Strokes0, stroke(_,_,_,_,Points,_,_)),
                  point_piece(Points, 1, I, X1-Y1, X2-Y2) ),
                Pieces),
        crossings(Pieces, Marks),
        Marks = [_|_]
    ->  sort(Marks, Sorted),
        group_pairs_by_key(Sorted, Groups),
        marked(Strokes0, 1, Groups, Strokes)
    ;   Strokes = Strokes0
    ).

%   few_pieces(Strokes, Left): nothing is copied, for there may be millions.

few_pieces([], _).
few_pieces([stroke(_,_,_,_,Points,_,_)|Strokes], Left0) :-
    length(Points, N),
    Left is Left0 + 1 - N,
    Left >= 0,
    few_pieces(Strokes, Left).

point_piece([P,Q|_], I, I, P, Q) :-
    P \== Q.
point_piece([_|Points], I0, I, P, Q) :-
    Points = [_,_|_],
    I1 is I0+1,
    point_piece(Points, I1, I, P, Q).

%   crossings(Pieces, Marks): K-(I-T): the I-th piece of stroke K is crossed at
%   its part T.

crossings(Pieces, Marks) :-
    foldl(farthest, Pieces, 0, Far),
    cell_size(Least),
    Size is max(Least, Far//20),
    findall(Cell-Piece,
            ( member(Piece, Pieces), piece_cell(Piece, Size, Cell) ),
            Keyed0),
    keysort(Keyed0, Keyed),
    group_pairs_by_key(Keyed, Cells),
    findall(Mark,
            ( member(_-InCell, Cells),
              append(_, [A|Others], InCell),
              member(B, Others),
              piece_mark(A, B, Mark) ),
            Marks).

%   farthest(Piece, Far0, Far): how far from the corner of the sheet.

farthest(piece(_,_,X1,Y1,X2,Y2), Far0, Far) :-
    Far is max(Far0, max(max(abs(X1), abs(X2)), max(abs(Y1), abs(Y2)))).

%   piece_cell(Piece, Size, Cell) is nondet: on a large sheet cells are large.

piece_cell(piece(_,_,X1,Y1,X2,Y2), Size, I/J) :-
    I1 is min(X1, X2)//Size,
    I2 is max(X1, X2)//Size,
    J1 is min(Y1, Y2)//Size,
    J2 is max(Y1, Y2)//Size,
    between(I1, I2, I),
    between(J1, J2, J).

piece_mark(piece(K,I,X1,Y1,X2,Y2), piece(L,J,X3,Y3,X4,Y4), Mark) :-
    \+ ( K =:= L, abs(I-J) =< 1 ),
    max(X1, X2) + 20 >= min(X3, X4),
    max(X3, X4) + 20 >= min(X1, X2),
    UX is X2-X1, UY is Y2-Y1,
    VX is X4-X3, VY is Y4-Y3,
    Cross is UX*VY - UY*VX,
    LengthU is sqrt(UX*UX + UY*UY),
    LengthV is sqrt(VX*VX + VY*VY),
    least_sine(Sine),
    abs(Cross) >= Sine*LengthU*LengthV,
    near_enough(Near),
    T is ((X3-X1)*VY - (Y3-Y1)*VX)/float(Cross),
    T*LengthU >= -Near,
    (T-1)*LengthU =< Near,
    U is ((X3-X1)*UY - (Y3-Y1)*UX)/float(Cross),
    U*LengthV >= -Near,
    (U-1)*LengthV =< Near,
    (   Mark = K-(I-T)
    ;   Mark = L-(J-U)
    ).

%   marked(Strokes0, K, Groups, Strokes): of each stroke from the K-th on.

marked([], _, _, []).
marked([Stroke0|Strokes0], K, Groups0, [Stroke|Strokes]) :-
    (   Groups0 = [K-Places|Groups]
    ->  stroke_marked(Stroke0, Places, Stroke)
    ;   Groups = Groups0,
        Stroke = Stroke0
    ),
    K1 is K+1,
    marked(Strokes0, K1, Groups, Strokes).

stroke_marked(stroke(V,Role,S,Es,Points,Start,End), Places,
              stroke(V,Role,S,Es,Points,Start,crossed(End,Marks,Length))) :-
    Points = [First|Rest],
    foldl(farther, Rest, far(First,0.0,Ways), far(_,Length,[])),
    maplist(way_along([0.0|Ways]), Places, Marks0),
    msort(Marks0, Marks1),
    each_apart(Marks1, Marks).

farther(X2-Y2, far(X1-Y1,Far0,[Far|Ways]), far(X2-Y2,Far,Ways)) :-
    Far is Far0 + sqrt((X2-X1)**2 + (Y2-Y1)**2).

way_along(Ways, I-T, Mark) :-
    nth1(I, Ways, A),
    I1 is I+1,
    nth1(I1, Ways, B),
    Mark is A + max(0.0, min(1.0, T))*(B-A).

each_apart([A,B|Marks0], Marks) :-
    apart(Least),
    B-A < Least,
    !,
    each_apart([A|Marks0], Marks).
each_apart([A|Marks0], [A|Marks]) :-
    each_apart(Marks0, Marks).
each_apart([], []).
