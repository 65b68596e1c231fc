:- module(sg_pattern_text,
          [ written/5,                  % +Cuts, +Folds, +Wanted, -Strokes,
                                        % -Skipped
            first_of/3                  % +N, +List, -First
          ]).
:- use_module('../near', [tolerance/2, points_left/2]).
:- use_module('../kernel', [shapes_add/2, shapes_free/3, shapes_open/2]).
:- use_module('../sheet/lettering',
              [lettering_drop/3, lettering_width/3]).
:- use_module(library(apply), [foldl/4, include/3]).
:- use_module(library(lists), [append/3, last/2, member/2, sum_list/2]).
:- use_module(library(pairs), [pairs_values/2]).
/** <module> Numbers and names on a pattern, where there is room for them.

A text is as large as fits between the lines and the texts that are there
already; one that would be smaller than can be read is left out and counted.
What is wanted is

    want(Role, D, Text, Heights, along(A,B))       on the left of A to B
    want(Role, D, Text, Heights, beside(ABs))      the same of one of these, or
                           across, if it is short
    want(Role, D, Text, Heights, end_of(A,B,Shapes))
                           on either side, near an end, within Shapes
    want(Role, D, Text, Heights, middle_of(ABs,Shapes))
                           the same, about the middle of one of these
    want(Role, D, Text, Heights, within(Shapes))   in a face
    want(Role, D, Text, Heights, within_any(Shapes))
                           the same, also across its longest side
    want(Role, D, Text, Heights, first_of([Place,...]))
                           in the first of these places that has room
    want(Role, D, Text, Heights, over_folds(Place))
                           small, and perhaps over lines that are not cut
    want(Role, D, Text, Heights, over_lines(Place))
                           the same, but not small

Text is a String, underlined(String), or either(Long,Short): Long where it can
be 2 mm high, else Short, itself one of the others. Heights in millimetres,
largest first; points X-Y, millimetres of the sheet, y up; Shapes are convex,
lists of points.
The letters are those of lettering.pl.
*/

:- set_prolog_flag(optimise, true).

% Millimetres free round a text, and how deep a line may reach into that.
clear(0.35).
touching(0.05).

% What is written over folds is at most so high, in millimetres.
over_folds_height(2.5).

%!  written(+Cuts, +Folds, +Wanted, -Strokes, -Skipped) is det.
%
%   Strokes are letters, letters(Role,D,Under,Word), for those of Wanted that
%   found room, in that order: Under is a list of lines below the letters, Word
%   as in pattern_word.pl. Skipped counts the others by role, a list of
%   Role-Count. Cuts and Folds, lists of points, are what is drawn: what
%   is cut and all else.

written(Cuts, Folds, Wanted, Strokes, Skipped) :-
    append(Cuts, Folds, Lines),
    line_cell(Lines, Cell),
    shapes_open(Cell, Drawn),
    shapes_open(Cell, Cut),
    forall(member(Line, Lines), line_entered(Line, Drawn)),
    forall(member(Line, Cuts), line_entered(Line, Cut)),
    foldl(text_written(drawn(Drawn,Cut)), Wanted, Found0-[], Found-Left),
    Found = [],
    Strokes = Found0,
    role_counts(Left, Skipped).

line_cell(Lines, Cell) :-
    findall(Side,
            ( member([XA-YA,XB-YB|_], Lines),
              Side is max(abs(XB-XA), abs(YB-YA))
            ),
            Sides),
    length(Sides, N),
    sum_list(Sides, Sum),
    Cell is max(2.0, Sum/max(1, N)).

line_entered([_], _) :-
    !.
line_entered([A,B|Points], Shapes) :-
    (   A == B
    ->  true
    ;   shapes_add(Shapes, [A,B])
    ),
    line_entered([B|Points], Shapes).

text_written(Drawn, want(Role,D,Text,Heights,Place), Found0-Left,
             Found-Left1) :-
    (   said_text(Text, Heights, Said, Own),
        text_place(Drawn, Said, Own, Place, Height, At, Way, Box)
    ->  Drawn = drawn(All, Cut),
        shapes_add(All, Box),
        shapes_add(Cut, Box),
        text_word(Said, Height, At, Way, Under, Word),
        Found0 = [letters(Role,D,Under,Word)|Found],
        Left1 = Left
    ;   Found0 = Found,
        Left1 = [Role|Left]
    ).

%   said_text(Text, Heights, Said, Own) is multi.

said_text(either(Long,Short), Heights, Said, Own) :-
    !,
    (   Said = Long,
        include(=<(2.0), Heights, Own)
    ;   Said = Short,
        Own = Heights
    ).
said_text(Text, Heights, Text, Heights).

role_counts(Roles0, Counts) :-
    msort(Roles0, Roles),
    findall(Role, member(Role, Roles), All),
    sort(All, Names),
    findall(Role-N,
            ( member(Role, Names),
              findall(x, member(Role, Roles), Xs),
              length(Xs, N)
            ),
            Counts).

%   text_place(Drawn, Text, Heights, Place, Height, At, Way, Box): the text has
%   the middle of its lowest line At, which is its baseline if it has no tails
%   and is not underlined, and runs along Way, a unit vector.

text_place(Drawn, Text, Heights, Place, Height, At, Way, Box) :-
    touching(Tolerance),
    simple_place(Place, Drawn, Simple, Shapes, Most),
    member(Height, Heights),
    Height =< Most,
    text_size(Text, Height, Width, All),
    place_at(Simple, Width, All, At, Way, Reach),
    clear_at_ends(Simple, Height, Clear),
    text_box(At, Way, Width, All, Clear, Box),
    shapes_free(Shapes, Box, Tolerance),
    reach_free(Reach, At, Way, Width, All, Shapes),
    !.

%   simple_place(Place, Drawn, Simple, Shapes, Most) is nondet: Simple is a
%   place for place_at/6, where nothing of Shapes may be, and letters no higher
%   than Most.

simple_place(first_of(Places), Drawn, Simple, Shapes, Most) :-
    !,
    member(Place, Places),
    simple_place(Place, Drawn, Simple, Shapes, Most).
simple_place(over_folds(Simple), drawn(_,Cut), Simple, Cut, Most) :-
    !,
    over_folds_height(Most).
simple_place(over_lines(Simple), drawn(_,Cut), Simple, Cut, inf) :-
    !.
simple_place(Simple, drawn(All,_), Simple, All, inf).

%   A name ends well before a number beside it: `face 6` and 2 are not face 62.

clear_at_ends(Place, Height, Clear) :-
    clear(Clear0),
    (   ( Place = within(_), Height > 2.5 ; Place = middle_of(_, _) )
    ->  Clear is 0.5*Height
    ;   Clear = Clear0
    ).

%   reach_free(Reach, At, Way, Width, Height, Shapes): nothing is between a
%   text and its edge, where a face or a tab may have ended. Reach says how far
%   from the text the edge is, and whether below it or before it.

reach_free(none, _, _, _, _, _).
reach_free(below(Deep), At, Way, Width, _, Shapes) :-
    Left is -Width/2,
    Right is Width/2,
    Low is -Deep,
    nothing_in(box(Left,Right,Low,0.0), At, Way, Shapes).
reach_free(before(Deep), At, Way, Width, Height, Shapes) :-
    Left is -Width/2-Deep,
    Right is -Width/2,
    nothing_in(box(Left,Right,0.0,Height), At, Way, Shapes).

nothing_in(Box, At, Way, Shapes) :-
    box_corners(Box, At, Way, Corners),
    shapes_free(Shapes, Corners, 0.01).

%   text_size(Text, Height, Width, All): All is how high Text is with its tails
%   or the line below it, if capitals are Height high.

text_size(underlined(String), Height, Width, All) :-
    !,
    lettering_width(String, Height, Width),
    underline_drop(Height, Drop),
    All is Height+Drop.
text_size(String, Height, Width, All) :-
    lettering_width(String, Height, Width),
    lettering_drop(String, Height, Drop),
    All is Height+Drop.

%   underline_drop(Height, Drop): how far the line is below the baseline.

underline_drop(Height, Drop) :-
    Drop is 0.3*Height.

%   place_at(Place, Width, Height, At, Way, Reach) is nondet: best first.

place_at(along(A,B), Width, Height, At, U-V, below(Off)) :-
    A = XA-YA,
    B = XB-YB,
    Length is sqrt((XB-XA)**2 + (YB-YA)**2),
    Width+0.6 < Length,
    Height < max(2.1, 0.28*Length),
    U is (XB-XA)/Length,
    V is (YB-YA)/Length,
    Off is 0.45 + 0.25*Height,
    member(T, [0.5,0.38,0.62,0.27,0.73,0.16,0.84]),
    (   T =:= 0.5
    ->  true
    ;   min(T, 1-T)*Length > Width/2
    ),
    X is XA + T*Length*U - Off*V,
    Y is YA + T*Length*V + Off*U,
    At = X-Y.
place_at(beside(Places), Width, Height, At, Way, Reach) :-
    member(A-B, Places),
    (   place_at(along(A,B), Width, Height, At, Way, Reach)
    ;   place_across(A, B, Width, Height, At, Way, Reach)
    ).
place_at(end_of(XA-YA,XB-YB,Shapes), Width, Height, At, Way, none) :-
    Length is sqrt((XB-XA)**2 + (YB-YA)**2),
    2*Width+4 < Length,
    member(Along, [1.5+Width/2, Length-1.5-Width/2, 4+Width/2]),
    place_within_beside(XA-YA, XB-YB, Along/Length, Shapes, Height, At, Way).
place_at(middle_of(Places,Shapes), Width, Height, At, Way, none) :-
    member((XA-YA)-(XB-YB), Places),
    Length is sqrt((XB-XA)**2 + (YB-YA)**2),
    Width+4 < Length,
    member(Share, [0.5,0.4,0.6,0.3,0.7]),
    min(Share, 1-Share)*Length > Width/2+1,
    place_within_beside(XA-YA, XB-YB, Share, Shapes, Height, At, Way).
place_at(within(Shapes), Width, Height, At, Way, none) :-
    face_way(Shapes, Long),
    place_within(Shapes, [1.0-0.0,Long], Width, Height, At, Way).
place_at(within_any(Shapes), Width, Height, At, Way, none) :-
    face_way(Shapes, U-V),
    upright_way(V, -U, Across),
    place_within(Shapes, [1.0-0.0,U-V,Across], Width, Height, At, Way).

place_within(Shapes, Ways, Width, Height, At, Way) :-
    face_middles(Shapes, Middles),
    member(Middle, Middles),
    member(Way, Ways),
    Width > 0,
    below(Middle, Way, Height/2, At),
    text_ends(At, Way, Width, Height, Ends),
    \+ ( member(End, Ends), \+ in_face(Shapes, End) ).

%   place_within_beside(A, B, Share, Shapes, Height, At, Way) is nondet: on
%   either side of A to B, Share of the way, within Shapes.

place_within_beside(XA-YA, XB-YB, Share, Shapes, Height, At, Way) :-
    Length is sqrt((XB-XA)**2 + (YB-YA)**2),
    U is (XB-XA)/Length,
    V is (YB-YA)/Length,
    Left is 0.45 + 0.25*Height,
    Right is -0.45 - 1.25*Height,
    member(Off, [Left,Right]),
    X is XA + Share*Length*U - Off*V,
    Y is YA + Share*Length*V + Off*U,
    in_face(Shapes, X-Y),
    upright(U-V, X-Y, Height, Way, At).

%   From the middle of a short line into the face.

place_across(XA-YA, XB-YB, Width, Height, X-Y, Way, before(0.9)) :-
    Length is sqrt((XB-XA)**2 + (YB-YA)**2),
    Length < 2*Width+1,
    Length > Height,
    U is (XB-XA)/Length,
    V is (YB-YA)/Length,
    MinusV is -V,
    Deep is 0.9 + Width/2,
    X is (XA+XB)/2 - Deep*V + U*Height/2,
    Y is (YA+YB)/2 + Deep*U + V*Height/2,
    Way = MinusV-U.

%   upright(Way0, At0, Height, Way, At): in the same place, but to be read from
%   below or from the right.

upright(U-V, At0, Height, Way, At) :-
    (   points_left(U, V)
    ->  U1 is -U,
        V1 is -V,
        Up is -Height,
        Way = U1-V1,
        below(At0, U-V, Up, At)
    ;   Way = U-V,
        At = At0
    ).

below(X0-Y0, U-V, Down, X-Y) :-
    X is X0 + Down*V,
    Y is Y0 - Down*U.

%   Where a name may have its middle: in the middle of the face, then in that of
%   its larger triangles.

face_middles(Shapes, Middles) :-
    findall(Less-(Area-Middle),
            ( member(Shape, Shapes),
              shape_middle(Shape, Area, Middle),
              Less is -Area
            ),
            Ranked0),
    keysort(Ranked0, Ranked),
    pairs_values(Ranked, Sized),
    foldl(weighed, Sized, w(0.0,0.0,0.0), w(X0,Y0,All)),
    first_of(6, Sized, Some),
    findall(M, member(_-M, Some), Own),
    (   All > 0
    ->  X is X0/All,
        Y is Y0/All,
        Middles = [X-Y|Own]
    ;   Middles = Own
    ).

weighed(Area-(X-Y), w(X0,Y0,A0), w(X1,Y1,A1)) :-
    X1 is X0+Area*X,
    Y1 is Y0+Area*Y,
    A1 is A0+Area.

%!  first_of(+N, +List, -First:list) is det.
%
%   First are the first N of List, or all if it has no more.

first_of(N, List, First) :-
    (   N > 0,
        List = [X|Xs]
    ->  First = [X|Rest],
        N1 is N-1,
        first_of(N1, Xs, Rest)
    ;   First = []
    ).

shape_middle([XA-YA,XB-YB,XC-YC|More], Area, X-Y) :-
    Area is abs((XB-XA)*(YC-YA) - (XC-XA)*(YB-YA))/2,
    (   More == []
    ->  X is (XA+XB+XC)/3,
        Y is (YA+YB+YC)/3
    ;   findall(X1, member(X1-_, [XA-YA,XB-YB,XC-YC|More]), Xs),
        findall(Y1, member(_-Y1, [XA-YA,XB-YB,XC-YC|More]), Ys),
        length(Xs, N),
        sum_list(Xs, SumX),
        sum_list(Ys, SumY),
        X is SumX/N,
        Y is SumY/N
    ).

%   The direction of the longest side of its triangles, read from below or from
%   the right.

face_way(Shapes, U-V) :-
    foldl(longest_side, Shapes, side(-1.0,0.0,0.0), side(Square,DX,DY)),
    Square >= 0.0,
    Length is sqrt(Square),
    U0 is DX/Length,
    V0 is DY/Length,
    upright_way(U0, V0, U-V).

longest_side(Shape, Side0, Side) :-
    last(Shape, Last),
    longest_side(Shape, Last, Side0, Side).

%   longest_side(Points, Before, Side0, Side): of those that are as long as each
%   other, the last one.

longest_side([], _, Side, Side).
longest_side([XB-YB|Points], XA-YA, Side0, Side) :-
    DX is XB-XA,
    DY is YB-YA,
    Square is DX*DX+DY*DY,
    (   arg(1, Side0, Square0),
        Square < Square0
    ->  Side1 = Side0
    ;   Side1 = side(Square,DX,DY)
    ),
    longest_side(Points, XB-YB, Side1, Side).

%   upright_way(U0, V0, Way): Way, to be read from below or from the right.

upright_way(U0, V0, U-V) :-
    (   points_left(U0, V0)
    ->  U is -U0,
        V is -V0
    ;   U is U0,
        V is V0
    ).

in_face(Shapes, X-Y) :-
    tolerance(rounding, Near),
    member([XA-YA|Points], Shapes),
    left_of_all(Points, XA, YA, XA-YA, X, Y, Near),
    !.

%   left_of_all(Points, XA, YA, First, X, Y, Near): X-Y is not right of any side
%   from XA-YA over Points back to First.

left_of_all([], XA, YA, XB-YB, X, Y, Near) :-
    (XB-XA)*(Y-YA) - (YB-YA)*(X-XA) >= -Near.
left_of_all([XB-YB|Points], XA, YA, First, X, Y, Near) :-
    (XB-XA)*(Y-YA) - (YB-YA)*(X-XA) >= -Near,
    left_of_all(Points, XB, YB, First, X, Y, Near).

%   The middles of the two ends of a text.

text_ends(X0-Y0, U-V, Width, Height, [XA-YA,XB-YB]) :-
    MX is X0 - Height/2*V,
    MY is Y0 + Height/2*U,
    XA is MX - Width/2*U,
    YA is MY - Width/2*V,
    XB is MX + Width/2*U,
    YB is MY + Width/2*V.

%   The box round a text, with some room, at its ends Clear.

text_box(At, Way, Width, Height, Clear, Corners) :-
    clear(Room),
    Left is -Width/2-Clear,
    Right is Width/2+Clear,
    Low is -Room,
    High is Height+Room,
    box_corners(box(Left,Right,Low,High), At, Way, Corners).

%   box_corners(Box, At, Way, Corners): Box, box(Left,Right,Low,High), as seen
%   from At, with Way to the right.

box_corners(box(Left,Right,Low,High), X0-Y0, U-V, Corners) :-
    findall(X-Y,
            ( member(A-B, [Left-Low,Right-Low,Right-High,Left-High]),
              X is X0 + A*U - B*V,
              Y is Y0 + A*V + B*U
            ),
            Corners).

text_word(underlined(String), Height, At0, Way, [[A,B]], Word) :-
    !,
    lettering_width(String, Height, Width),
    Left is -Width/2,
    Right is Width/2,
    beside(At0, Way, Left, A),
    beside(At0, Way, Right, B),
    underline_drop(Height, Drop),
    Up is -Drop,
    below(At0, Way, Up, At),
    text_word(String, Height, At, Way, [], Word).
text_word(String, Height, At0, Way, [], word(At,Way,Height,middle,String)) :-
    lettering_drop(String, Height, Drop),
    Up is -Drop,
    below(At0, Way, Up, At).

beside(X0-Y0, U-V, Along, X-Y) :-
    X is X0 + Along*U,
    Y is Y0 + Along*V.
