:- module(sg_pattern_text,
          [ written/5                   % +Cuts, +Folds, +Wanted, -Strokes,
                                        % -Skipped
          ]).
:- use_module('../near', [points_left/2]).
:- use_module('../kernel', [shapes_add/2, shapes_free/3, shapes_open/2]).
:- use_module(pattern_face, [face_point/2, text_faces/2, upright_way/3]).
:- use_module('../sheet/lettering',
              [lettering_reach/3]).
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
    text_faces(Wanted, Faced),
    foldl(text_written(drawn(Drawn,Cut)), Faced, Found0-[], Found-Left),
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
        text_reach(Said, Reach),
        text_place(Drawn, Reach, Own, Place, Height, At, Way, Box)
    ->  Drawn = drawn(All, Cut),
        shapes_add(All, Box),
        shapes_add(Cut, Box),
        text_word(Said, Reach, Height, At, Way, Under, Word),
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

%   text_place(Drawn, Reach, Heights, Place, Height, At, Way, Box): the text has
%   the middle of its lowest line At, which is its baseline if it has no tails
%   and is not underlined, and runs along Way, a unit vector.

text_place(Drawn, Reach, Heights, Place, Height, At, Way, Box) :-
    touching(Tolerance),
    simple_place(Place, Drawn, Simple, Shapes, Most),
    member(Height, Heights),
    Height =< Most,
    text_size(Reach, Height, Width, All),
    place_at(Simple, Width, All, At, Way, Edge),
    clear_at_ends(Simple, Height, Clear),
    text_box(At, Way, Width, All, Clear, Box),
    shapes_free(Shapes, Box, Tolerance),
    reach_free(Edge, At, Way, Width, All, Shapes),
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

%   text_reach(Text, Reach): Reach is reach(Width,Drop,Line): of its letters, if
%   capitals are 6 high (lettering_reach/3), and whether there is a line below.

text_reach(underlined(String), reach(Width,Drop,true)) :-
    !,
    lettering_reach(String, Width, Drop).
text_reach(String, reach(Width,Drop,false)) :-
    lettering_reach(String, Width, Drop).

%   text_size(Reach, Height, Width, All): All is how high a text is with its
%   tails or the line below it, if capitals are Height high.

text_size(reach(Width0,Drop0,Line), Height, Width, All) :-
    Width is Width0*Height/6,
    (   Line == true
    ->  underline_drop(Height, Drop)
    ;   Drop is Drop0*Height/6
    ),
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
place_at(end_of(XA-YA,XB-YB,Face), Width, Height, At, Way, none) :-
    Length is sqrt((XB-XA)**2 + (YB-YA)**2),
    2*Width+4 < Length,
    member(Along, [1.5+Width/2, Length-1.5-Width/2, 4+Width/2]),
    place_within_beside(XA-YA, XB-YB, Along/Length, Face, Height, At, Way).
place_at(middle_of(Places,Face), Width, Height, At, Way, none) :-
    member((XA-YA)-(XB-YB), Places),
    Length is sqrt((XB-XA)**2 + (YB-YA)**2),
    Width+4 < Length,
    member(Share, [0.5,0.4,0.6,0.3,0.7]),
    min(Share, 1-Share)*Length > Width/2+1,
    place_within_beside(XA-YA, XB-YB, Share, Face, Height, At, Way).
place_at(within(Face), Width, Height, At, Way, none) :-
    Face = face(_, _, Long),
    place_within(Face, [1.0-0.0,Long], Width, Height, At, Way).
place_at(within_any(Face), Width, Height, At, Way, none) :-
    Face = face(_, _, U-V),
    upright_way(V, -U, Across),
    place_within(Face, [1.0-0.0,U-V,Across], Width, Height, At, Way).

place_within(Face, Ways, Width, Height, At, Way) :-
    Face = face(_, Middles, _),
    member(Middle, Middles),
    member(Way, Ways),
    Width > 0,
    below(Middle, Way, Height/2, At),
    text_ends(At, Way, Width, Height, Ends),
    \+ ( member(End, Ends), \+ face_point(Face, End) ).

%   place_within_beside(A, B, Share, Face, Height, At, Way) is nondet: on either
%   side of A to B, Share of the way, within Face.

place_within_beside(XA-YA, XB-YB, Share, Face, Height, At, Way) :-
    Length is sqrt((XB-XA)**2 + (YB-YA)**2),
    U is (XB-XA)/Length,
    V is (YB-YA)/Length,
    Left is 0.45 + 0.25*Height,
    Right is -0.45 - 1.25*Height,
    member(Off, [Left,Right]),
    X is XA + Share*Length*U - Off*V,
    Y is YA + Share*Length*V + Off*U,
    face_point(Face, X-Y),
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

text_word(underlined(String), Reach, Height, At0, Way, [[A,B]], Word) :-
    !,
    text_size(Reach, Height, Width, _),
    Left is -Width/2,
    Right is Width/2,
    beside(At0, Way, Left, A),
    beside(At0, Way, Right, B),
    underline_drop(Height, Drop),
    Up is -Drop,
    below(At0, Way, Up, At),
    text_word(String, Reach, Height, At, Way, [], Word).
text_word(String, reach(_,Drop0,_), Height, At0, Way, [],
          word(At,Way,Height,middle,String)) :-
    Up is -(Drop0*Height/6),
    below(At0, Way, Up, At).

beside(X0-Y0, U-V, Along, X-Y) :-
    X is X0 + Along*U,
    Y is Y0 + Along*V.
