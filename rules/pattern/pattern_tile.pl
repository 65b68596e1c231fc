:- module(sg_pattern_tile,
          [ tiled/4                     % +Options, +Drawing, +Says, -Pages
          ]).
:- use_module('../near', [tolerance/2]).
:- use_module(pattern_paper,
              [line_strokes/4, page_sheet/2, pages_checked/1, sheet_line/4]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(option), [option/3]).
/** <module> A large sheet on many small pages.

Pages are named as the fields of a chess board, columns by letters from the left
and rows by numbers from the top: A1, B1, A2. Neighbours overlap; in the overlap
there are the same registration marks on both, and corners where the page can be
cropped.
*/

:- set_prolog_flag(optimise, true).

%!  tiled(+Options, +Drawing, +Says, -Pages) is det.
%
%   Pages are drawings of page(P) of Options, A4 if not given, that show
%   Drawing, each without its margin(M), 10 mm, and with an overlap(O), 10 mm;
%   pages on which nothing is drawn are left out. Says are strings beside each
%   check bar.

tiled(Options, drawing(sheet(W,H,Scale),Views), Says, Pages) :-
    page_sheet(Options, Page),
    Page = sheet(PageW, PageH, _, _, FreeW, FreeH),
    option(overlap(Overlap), Options, 10),
    columns(W/1000, FreeW, Overlap, Columns),
    columns(H/1000, FreeH, Overlap, Rows),
    Count is Columns*Rows,
    pages_checked(Count),
    Tiling = tiling(Page, Overlap, Columns, Rows),
    findall(drawing(sheet(PaperW,PaperH,Scale),PageViews),
            ( between(1, Rows, Row),
              between(1, Columns, Column),
              page_views(Tiling, Views, Options, Says, Column, Row,
                         PageViews),
              PaperW is round(PageW*1000),
              PaperH is round(PageH*1000)
            ),
            Pages).

columns(Size, Free, Overlap, N) :-
    tolerance(paper, Near),
    N is max(1, ceiling((Size-Overlap)/(Free-Overlap) - Near)).

page_views(Tiling, Views0, Options, Says0, Column, Row, [Marks|Views]) :-
    Tiling = tiling(Page, Overlap, _, _),
    Page = sheet(_, PageH, Margin, _, FreeW, FreeH),
    Left is round(1000*(Column-1)*(FreeW-Overlap)),
    Top is round(1000*(Row-1)*(FreeH-Overlap)),
    Right is Left + round(1000*FreeW),
    Bottom is Top + round(1000*FreeH),
    Window = rect(Left,Top,Right,Bottom),
    DX is round(1000*Margin)-Left,
    DY is round(1000*Margin)-Top,
    findall(view(Name,Strokes,Texts),
            ( member(view(Name,Strokes0,Texts0), Views0),
              findall(Stroke,
                      ( member(Stroke0, Strokes0),
                        clipped_stroke(Stroke0, Window, DX, DY, Stroke)
                      ),
                      Strokes),
              Strokes \== [],
              findall(Text,
                      ( member(Text0, Texts0),
                        text_within(Text0, Window, DX, DY, Text)
                      ),
                      Texts)
            ),
            Views),
    member(view(Any,_,_), Views),
    Any \== sheet,
    !,
    page_name(Column, Row, PageName),
    findall(Mark, page_mark(Tiling, Column, Row, Mark), Crops),
    findall(Mark, sheet_line(Page, Options, [PageName|Says0], Mark), Bar),
    append(Crops, Bar, All),
    line_strokes(All, PageH, Strokes, Texts),
    atom_concat('page-', PageName, PageView),
    Marks = view(PageView, Strokes, Texts).

%   text_within(Text0, Window, DX, DY, Text) is semidet: all of a word is in
%   Window; one that is cut stays lines.

text_within(word(Role,S,Angle,text(X0,Y0,High,Anchor,String),Strokes0),
            Window, DX, DY,
            word(Role,S,Angle,text(X,Y,High,Anchor,String),Strokes)) :-
    forall(member(stroke(_,_,_,_,Points,_,_), Strokes0),
           points_within(Points, Window)),
    shifted(DX, DY, X0-Y0, X-Y),
    findall(Stroke,
            ( member(Stroke0, Strokes0),
              clipped_stroke(Stroke0, Window, DX, DY, Stroke)
            ),
            Strokes).

page_name(Column, Row, Name) :-
    column_letters(Column, Letters),
    format(string(Name), '~w~d', [Letters,Row]).

column_letters(Column, Letters) :-
    Low is (Column-1) mod 26,
    sub_atom('ABCDEFGHIJKLMNOPQRSTUVWXYZ', Low, 1, _, Letter),
    High is (Column-1)//26,
    (   High =:= 0
    ->  Letters = Letter
    ;   column_letters(High, Before),
        atom_concat(Before, Letter, Letters)
    ).

%   Corners outside of what is free, and crosses in the middle of the overlap.

page_mark(tiling(sheet(_,PageH,Margin,_,FreeW,FreeH),_,_,_), _, _,
          line(crop,[A,B])) :-
    Top is PageH-Margin,
    Bottom is Top-FreeH,
    Right is Margin+FreeW,
    member(X-OutX, [Margin-(-1),Right-1]),
    member(Y-OutY, [Bottom-(-1),Top-1]),
    Far is min(5.0, 0.8*Margin),
    (   XA is X+OutX*Far,
        XB is X+OutX*1.0,
        A = XA-Y,
        B = XB-Y
    ;   OutY =:= 1,
        YA is Y+OutY*Far,
        YB is Y+OutY*1.0,
        A = X-YA,
        B = X-YB
    ).
page_mark(Tiling, Column, Row, line(crop,[A,B])) :-
    Tiling = tiling(Page, Overlap, Columns, Rows),
    Page = sheet(_, PageH, Margin, _, FreeW, FreeH),
    joint_place(Column, Columns, FreeW, Overlap, X0, BesideX),
    joint_place(Row, Rows, FreeH, Overlap, Y0, BesideY),
    once(( BesideX == true ; BesideY == true )),
    X is Margin+X0,
    Y is PageH-Margin-Y0,
    Half = 3.0,
    (   XA is X-Half, XB is X+Half, A = XA-Y, B = XB-Y
    ;   YA is Y-Half, YB is Y+Half, A = X-YA, B = X-YB
    ).

%   joint_place(I, N, Free, Overlap, At, Beside): the middle of the overlap with
%   the page before or after, or the middle of the page.

joint_place(I, _, _, Overlap, At, true) :-
    I > 1,
    At is Overlap/2.
joint_place(I, N, Free, Overlap, At, true) :-
    I < N,
    At is Free-Overlap/2.
joint_place(_, _, Free, _, At, false) :-
    At is Free/2.

%   clipped_stroke(Stroke0, Window, DX, DY, Stroke) is nondet: what is in Window
%   of it, moved.

clipped_stroke(stroke(Vis,Role,S,Es,Points,Start,End), Window, DX, DY,
               Stroke) :-
    (   points_within(Points, Window)
    ->  maplist(shifted(DX, DY), Points, Moved),
        Stroke = stroke(Vis, Role, S, Es, Moved, Start, End)
    ;   point_pieces(Points, Es, Window, Pieces),
        window_chains(Pieces, Chains),
        member(Chain, Chains),
        findall(E, ( member(piece(E,_,_), Chain), E \== none ), Own),
        Chain = [piece(_,A,_)|_],
        findall(B, member(piece(_,_,B), Chain), Bs),
        maplist(shifted(DX, DY), [A|Bs], Moved),
        Stroke = stroke(Vis, Role, S, Own, Moved, joint, joint)
    ).

shifted(DX, DY, X0-Y0, X-Y) :-
    X is X0+DX,
    Y is Y0+DY.

points_within(Points, rect(X1,Y1,X2,Y2)) :-
    \+ ( member(X-Y, Points),
         ( X < X1 ; X > X2 ; Y < Y1 ; Y > Y2 )
       ).

%   piece(E,A,B): what is left of each straight part, `none` of those that are
%   no edges.

point_pieces([A,B|Points], Es, Window, Pieces) :-
    !,
    (   Es = [E|Es1]
    ->  true
    ;   E = none,
        Es1 = []
    ),
    (   within(A, B, Window, A1, B1),
        A1 \== B1
    ->  Pieces = [piece(E,A1,B1)|Pieces1]
    ;   Pieces = Pieces1
    ),
    point_pieces([B|Points], Es1, Window, Pieces1).
point_pieces(_, _, _, []).

%   Liang and Barsky's way: the part of A to B in the window.

within(XA-YA, XB-YB, rect(X1,Y1,X2,Y2), P, Q) :-
    DX is XB-XA,
    DY is YB-YA,
    MinusX is -DX,
    MinusY is -DY,
    narrowed([ MinusX-(XA-X1), DX-(X2-XA), MinusY-(YA-Y1), DY-(Y2-YA) ],
             0.0, 1.0, From, To),
    part_point(XA-YA, XB-YB, From, P),
    part_point(XA-YA, XB-YB, To, Q).

narrowed([], From, To, From, To).
narrowed([Step-Room0|Rest], From0, To0, From, To) :-
    Room is Room0,
    (   Step =:= 0
    ->  Room >= 0,
        From1 = From0,
        To1 = To0
    ;   T is Room/float(Step),
        (   Step < 0
        ->  From1 is max(From0, T),
            To1 = To0
        ;   From1 = From0,
            To1 is min(To0, T)
        )
    ),
    From1 < To1,
    narrowed(Rest, From1, To1, From, To).

part_point(A, B, T, P) :-
    (   T =:= 0
    ->  P = A
    ;   T =:= 1
    ->  P = B
    ;   A = XA-YA,
        B = XB-YB,
        X is round(XA + T*(XB-XA)),
        Y is round(YA + T*(YB-YA)),
        P = X-Y
    ).

window_chains([], []).
window_chains([Piece|Pieces], [[Piece|Chain]|Chains]) :-
    chained(Pieces, Piece, Chain, Rest),
    window_chains(Rest, Chains).

chained([Piece|Pieces], piece(_,_,At), [Piece|Chain], Rest) :-
    Piece = piece(_, At, _),
    !,
    chained(Pieces, Piece, Chain, Rest).
chained(Rest, _, [], Rest).
