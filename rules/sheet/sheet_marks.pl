:- module(sg_sheet_marks,
          [ plane_marks/6,              % +View, +Section, +Box, +Scale,
                                        % +Others, -Marks
            plane_line/3,               % +View, +Section, -Line
            interrupted/2,              % +Marks, -Interrupted
            label_marks/4,              % +Letter, +Box, +Scale, -Marks
            marks_pads/4,               % +Marks, +Box, +Scale, -Pads
            hatching/2,                 % +Regions, -Hatching
            hatching_strokes/3,         % +Hatching, +Regions, -Strokes
            chain_line/5                % +A, +B, +Dash, +Role, -Lines
          ]).
:- use_module('../near', [tolerance/2, is_rounding/2]).
:- use_module(hatching, [hatch_lines/4, region_area/2]).
:- use_module(sheet_view, [view_axes/4]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3, maplist/4]).
:- use_module(library(lists),
              [ append/2, max_list/2, member/2, min_list/2, nth0/3, nth1/3,
                sum_list/2 ]).
:- use_module(library(yall), [(>>)/5]).
/** <module> Marks on a sheet: cutting planes, their names, hatching.

A mark is line(Role,Points) or text(X,Y,Height,Text), in millimetres of the
sheet from the origin of the picture, y up; the text has the middle of its
baseline at X,Y. Forms and sizes follow ISO 128: a thin chain line with thick
ends, arrows on them that show which way one looks, and letters.
*/

% Millimetres.
beyond(7.0).                            % the view, the line reaches
thick(6.0).                             % the length of its thick ends
shaft(10.0).                            % of an arrow
head(3.5).
letter(5.0).                            % how high

%!  plane_marks(+View, +Section, +Box, +Scale, +Others, -Marks) is semidet.
%
%   Marks show where the plane of Section, a view, cuts what View shows within
%   Box; they reach out so far that arrows and letters stand beside Box, and
%   with the thick ends keep clear of those of Others. Fails if View does not
%   see the plane edge-on, or its line goes past Box.

plane_marks(View, Section, box(X1,Y1,X2,Y2), Scale, Others, Marks) :-
    Section = view(Letter, _, _, _),
    plane_line(View, Section, line(U,V,At0)),
    At is At0*Scale,
    maplist(scaled(Scale), [X1,Y1,X2,Y2], [A1,B1,A2,B2]),
    line_ends(U, V, At, box(A1,B1,A2,B2), P, Q),
    Cut = cut(P,Q,U-V,Letter),
    least_beyond(Cut, rect(A1,B1,A2,B2), Least),
    between(0, 40, Step),               % two of a section, 24 sections
    Out is Least + 9*Step,
    chain_marks(Cut, Out, Marks),
    ends_clear(Marks, Others),
    !.

scaled(Scale, X0, X) :-
    X is X0*Scale.

%!  plane_line(+View, +Section, -Line) is semidet.
%
%   View sees the plane of the view Section edge-on: Line is line(U,V,At), U*X +
%   V*Y + At = 0 in its picture, U and V a unit vector.

plane_line(View, view(_,_,_,section(plane(A,B,C,D),_,_)), line(U,V,At)) :-
    view_axes(View, Right, Up, Away),
    maplist(product([A,B,C]), [Right,Up,Away], [U0,V0,W]),
    Length is sqrt(U0*U0+V0*V0),
    is_rounding(W, Length),
    U is U0/Length,
    V is V0/Length,
    At is D/Length.

%   least_beyond(Cut, View, Least): Least is how far the line of Cut has to go
%   on beyond View, a rectangle, so that its arrows and letters are not in
%   there; but a line that is all but along a side need not go as far as that.

least_beyond(Cut, View, Least) :-
    beyond(Beyond),
    (   between(0, 60, More),
        Out is Beyond + More,
        chain_marks(Cut, Out, Marks),
        \+ reaches_into(Marks, View)
    ->  Least = Out
    ;   Least = Beyond
    ).

reaches_into(Marks, View) :-
    member(Mark, Marks),
    Mark \= line(cutting_end,_),
    end_rectangle(Mark, Rectangle),
    overlap(Rectangle, View).

%   ends_clear(Marks, Others): their arrows, letters and thick ends do not
%   overlap.

ends_clear(Marks, Others) :-
    \+ ( member(Mark, Marks),
         end_rectangle(Mark, R1),
         member(Other, Others),
         end_rectangle(Other, R2),
         overlap(R1, R2)
       ).

end_rectangle(line(Role,Points), rect(X1,Y1,X2,Y2)) :-
    end_role(Role),
    maplist(x_y, Points, Xs, Ys),
    margin(Xs, X1, X2),
    margin(Ys, Y1, Y2).
end_rectangle(text(X,Y,High,_), rect(X1,Y1,X2,Y2)) :-
    X1 is X-High*0.6,
    X2 is X+High*0.6,
    Y1 is Y-High*0.2,
    Y2 is Y+High*1.2.

end_role(arrow).
end_role(cutting_end).

x_y(X-Y, X, Y).

margin(Xs, Low, High) :-
    min_list(Xs, Low0),
    max_list(Xs, High0),
    Low is Low0-0.5,
    High is High0+0.5.

overlap(rect(A1,B1,A2,B2), rect(C1,D1,C2,D2)) :-
    A1 < C2,
    C1 < A2,
    B1 < D2,
    D1 < B2.

product(Xs, Ys, Product) :-
    maplist([X,Y,Z]>>(Z is X*Y), Xs, Ys, Zs),
    sum_list(Zs, Product).

%   line_ends(U, V, At, Box, P, Q): the line U*X + V*Y + At = 0 within Box.

line_ends(U, V, At, box(X1,Y1,X2,Y2), PX-PY, QX-QY) :-
    MX is (X1+X2)/2,
    MY is (Y1+Y2)/2,
    Off is U*MX + V*MY + At,
    FX is MX - Off*U,
    FY is MY - Off*V,
    range(FX, V, X1, X2, LowX, HighX),
    Back is -U,
    range(FY, Back, Y1, Y2, LowY, HighY),
    Low is max(LowX, LowY),
    High is min(HighX, HighY),
    Low < High,
    PX is FX + Low*V,
    PY is FY - Low*U,
    QX is FX + High*V,
    QY is FY - High*U.

%   range(F, Step, X1, X2, Low, High): F + T*Step is from X1 to X2.

range(F, Step, X1, X2, Low, High) :-
    (   is_rounding(Step, 1.0)
    ->  tolerance(paper, Near),
        F >= X1 - Near,
        F =< X2 + Near,
        Low = -1.0e30,
        High = 1.0e30
    ;   A is (X1-F)/Step,
        B is (X2-F)/Step,
        Low is min(A, B),
        High is max(A, B)
    ).

%   chain_marks(cut(P,Q,Normal,Letter), Beyond, Marks): the line goes on beyond
%   P and Q; the eye is on the side of Normal.

chain_marks(cut(P0,Q0,Normal,Letter), Beyond, Marks) :-
    thick(Thick),
    Back is -Beyond,
    towards(P0, Q0, Back, P),
    towards(Q0, P0, Back, Q),
    towards(P, Q, Thick, P1),
    towards(Q, P, Thick, Q1),
    chain_line(P1, Q1, 9.0, cutting, Chain),
    maplist(end_marks(Normal, Letter), [P,Q], Ends),
    append([ [line(cutting_end,[P,P1]), line(cutting_end,[Q,Q1])|Chain]
           | Ends
           ], Marks).

end_marks(U-V, Letter, X-Y, [line(arrow,[Tail,X-Y]), line(arrow,[A,X-Y,B]),
                             text(TextX,TextY,High,Letter)]) :-
    shaft(Shaft),
    head(Head),
    letter(High),
    shifted(X-Y, U, V, Shaft, Tail),
    shifted(X-Y, U, V, Head, HX-HY),
    Wide is Head*0.27,
    AX is HX - Wide*V,
    AY is HY + Wide*U,
    BX is HX + Wide*V,
    BY is HY - Wide*U,
    A = AX-AY,
    B = BX-BY,
    Far is Shaft + 1.5 + High*0.5,
    shifted(X-Y, U, V, Far, TextX-MiddleY),
    TextY is MiddleY - High/2.

shifted(X0-Y0, U, V, Far, X-Y) :-
    X is X0 + Far*U,
    Y is Y0 + Far*V.

towards(X1-Y1, X2-Y2, Far, X-Y) :-
    Length is sqrt((X2-X1)**2 + (Y2-Y1)**2),
    T is Far/Length,
    X is X1 + T*(X2-X1),
    Y is Y1 + T*(Y2-Y1).

%!  interrupted(+Marks, -Interrupted) is det.
%
%   Interrupted are Marks, those of one view, without what its thin chain lines
%   have in common with the place of a letter: no line goes through one.

interrupted(Marks, Interrupted) :-
    findall(Rectangle,
            ( member(Mark, Marks),
              Mark = text(_,_,_,_),
              end_rectangle(Mark, Rectangle) ),
            Letters),
    maplist(spared(Letters), Marks, Parts),
    append(Parts, Interrupted).

spared(Letters, Mark, Parts) :-
    (   Mark = line(cutting,[A,B])
    ->  foldl(without, Letters, [A-B], Pieces),
        findall(line(cutting,[P,Q]), member(P-Q, Pieces), Parts)
    ;   Parts = [Mark]
    ).

%   without(Rectangle, Pieces, Outside): what of Pieces, From-To, is not within
%   Rectangle.

without(Rectangle, Pieces, Outside) :-
    findall(Piece,
            ( member(Piece0, Pieces),
              outside(Rectangle, Piece0, Piece) ),
            Outside).

outside(rect(X1,Y1,X2,Y2), A-B, Piece) :-
    A = AX-AY,
    B = BX-BY,
    Length is sqrt((BX-AX)**2 + (BY-AY)**2),
    U is (BX-AX)/Length,
    V is (BY-AY)/Length,
    (   range(AX, U, X1, X2, LowX, HighX),
        range(AY, V, Y1, Y2, LowY, HighY),
        Low is max(0.0, max(LowX, LowY)),
        High is min(Length, min(HighX, HighY)),
        Low < High
    ->  (   Low > 0.0,
            towards(A, B, Low, P),
            Piece = A-P
        ;   High < Length,
            towards(A, B, High, Q),
            Piece = Q-B
        )
    ;   Piece = A-B
    ).

%!  chain_line(+A, +B, +Dash, +Role, -Lines) is det.
%
%   Lines, line(Role,Points), are a chain line from A to B: long dashes and
%   points between them, fitted so that it begins and ends with a dash of about
%   Dash; what is too short for two dashes is one.

chain_line(A, B, Dash, Role, Lines) :-
    A = X1-Y1,
    B = X2-Y2,
    Length is sqrt((X2-X1)**2 + (Y2-Y1)**2),
    Gap is Dash/6,
    Dot is Dash/18,
    Period is Dash + 2*Gap + Dot,
    N is max(0, round((Length-Dash)/Period)),
    (   N =:= 0
    ->  Lines = [line(Role,[A,B])]
    ;   Fit is Length/(N*Period + Dash),
        findall(line(Role,[P,Q]),
                ( between(0, N, I),
                  From is I*Period*Fit,
                  (   To is From + Dash*Fit
                  ->  ( Start = From, End = To
                      ; I < N,
                        Start is To + Gap*Fit,
                        End is Start + Dot*Fit
                      )
                  ),
                  towards(A, B, Start, P),
                  towards(A, B, End, Q)
                ),
                Lines)
    ).

%!  label_marks(+Letter, +Box, +Scale, -Marks) is det.
%
%   The name of a section, above its view.

label_marks(Letter, box(X1,_,X2,Y2), Scale, [text(X,Y,High,Text)]) :-
    letter(High),
    X is (X1+X2)/2*Scale,
    Y is Y2*Scale + High,
    format(string(Text), '~w-~w', [Letter, Letter]).

%!  marks_pads(+Marks, +Box, +Scale, -Pads) is det.
%
%   Pads, for sheet_layout.pl, is how far Marks reach beyond Box.

marks_pads(Marks, box(X1,Y1,X2,Y2), Scale, pads(L,A,R,B)) :-
    findall(X-Y, ( member(Mark, Marks), mark_point(Mark, X-Y) ), Points),
    foldl(farther, Points,
          box(X1*Scale,Y1*Scale,X2*Scale,Y2*Scale), box(X3,Y3,X4,Y4)),
    L is X1*Scale-X3,
    R is X4-X2*Scale,
    A is Y4-Y2*Scale,
    B is Y1*Scale-Y3.

mark_point(line(_,Points), Point) :-
    member(Point, Points).
mark_point(text(X,Y,High,Text), Point) :-
    string_length(Text, N),
    Half is N*High*0.45,
    (   X1 is X-Half,
        Point = X1-Y
    ;   X1 is X+Half,
        Y1 is Y+High,
        Point = X1-Y1
    ).

farther(X-Y, box(X1,Y1,X2,Y2), box(X3,Y3,X4,Y4)) :-
    X3 is min(X1, X),
    Y3 is min(Y1, Y),
    X4 is max(X2, X),
    Y4 is max(Y2, Y).

%!  hatching(+Regions, -Hatching) is det.
%
%   Hatching is hatching(Spacing,Hatched), how to hatch all Regions of a sheet,
%   region(Of,Edges) as of sheet_view.pl, points in millimetres: about twelve
%   lines across the largest, from 1.5 to 6 mm apart, in half millimetres.

hatching(Regions, hatching(Spacing,Hatched)) :-
    findall(Of, member(region(Of,_), Regions), Hatched0),
    sort(Hatched0, Hatched),
    foldl(larger_region, Regions, 0, Largest),
    Spacing is max(1.5, min(6.0, round(sqrt(Largest)/6)/2)).

larger_region(region(_,Edges), Area0, Area) :-
    region_area(Edges, Own),
    Area is max(Area0, Own).

%!  hatching_strokes(+Hatching, +Regions, -Strokes) is det.
%
%   Strokes (sheet.pl) hatch Regions, whose points are thousandths of a
%   millimetre on the sheet. A segment is hatched alike in all views; those of
%   neighbouring numbers lean the other way, those of every third and fourth
%   are closer, and of every fifth and sixth closer still.

hatching_strokes(hatching(Spacing0,Hatched), Regions, Strokes) :-
    Spacing is Spacing0*1000,
    findall(Stroke,
            ( member(Region, Regions),
              Region = region(Of, _),
              nth1(I, Hatched, Of),
              hatch_stroke(I, Spacing, Region, Stroke)
            ),
            Strokes).

hatch_stroke(I, Spacing0, region(Of,Edges), stroke(visible,hatching,S,[],[A,B],
                                                   joint,joint)) :-
    (   Of = S-_
    ->  true
    ;   S = Of
    ),
    (   I mod 2 =:= 1
    ->  Way = rising
    ;   Way = falling
    ),
    Pair is (I-1) mod 6 // 2,
    nth0(Pair, [1,0.7,0.5], Part),
    Spacing is Spacing0*Part,
    hatch_lines(Edges, Way, Spacing, Lines),
    member(A-B, Lines).
