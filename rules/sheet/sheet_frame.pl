:- module(sg_sheet_frame,
          [ frame/5,                    % +Width, +Height, +Facts, -Marks,
                                        % -Room
            bare_room/3                 % +Width, +Height, -Room
          ]).
:- use_module(sheet_marks, [chain_line/5]).
:- use_module(sheet_words, [sheet_word/3]).
:- use_module(library(apply), [foldl/4]).
:- use_module(library(lists), [append/2, append/3, member/2, memberchk/2]).
/** <module> The frame of a sheet and its title block.

Marks are line(Role,Points) and text(X,Y,Height,Anchor,Text), millimetres, y
down. The frame leaves 20 mm on the left, for filing, and 10 mm elsewhere, with
centring marks and a grid of letters and numbers (ISO 5457); the title block,
180 mm wide, stands in the lower right corner (ISO 7200).

Facts is a list of Item-Text of the items of title_block/2 and of

  - language: `en` or `ko`
  - angle: `first` or `third`, whose symbol is shown (ISO 5456-2)
  - scale, paper: texts
  - label(Item): what stands above the field, if not the usual word
*/

border(left, 20.0).
border(other, 10.0).

block(180.0, 36.0).

%!  bare_room(+Width, +Height, -Room) is det.
%
%   Room (sheet_layout.pl) of a sheet without a frame.

bare_room(Width, Height, room(rect(10.0,10.0,X2,Y2),[])) :-
    X2 is Width-10.0,
    Y2 is Height-10.0.

%!  frame(+Width, +Height, +Facts, -Marks, -Room) is det.
%
%   Marks are frame and title block of a sheet of Width x Height mm, and Room
%   (sheet_layout.pl) is what is left of it.

frame(Width, Height, Facts, Marks, room(rect(X3,Y3,X4,Y4),[Block])) :-
    border(left, X1),
    border(other, Y1),
    X2 is Width-Y1,
    Y2 is Height-Y1,
    Rectangle = rect(X1,Y1,X2,Y2),
    border_marks(Width, Height, Rectangle, Border),
    block(BlockWidth, BlockHeight),
    Left is X2-BlockWidth,
    Top is Y2-BlockHeight,
    block_marks(Left-Top, Facts, Title),
    append(Border, Title, Marks),
    X3 is X1+6,
    Y3 is Y1+6,
    X4 is X2-6,
    Y4 is Y2-6,
    BlockX is Left-6,
    BlockY is Top-6,
    Block = rect(BlockX,BlockY,X2,Y2).


                /*******************************
                *            BORDER            *
                *******************************/

border_marks(Width, Height, Rectangle, Marks) :-
    rectangle_line(frame, Rectangle, Frame),
    Rectangle = rect(X1,Y1,X2,Y2),
    XA is X1-5,
    YA is Y1-5,
    XB is X2+5,
    YB is Y2+5,
    rectangle_line(field, rect(XA,YA,XB,YB), Grid),
    MX is Width/2,
    MY is Height/2,
    block(BlockWidth, _),
    (   MX > X2-BlockWidth
    ->  Inside = 0                      % the title block is there
    ;   Inside = 5
    ),
    centring(MX, MY, Rectangle, Inside, Centring),
    zones(Width, MX, X1, X2, Xs),
    zones(Height, MY, Y1, Y2, Ys),
    findall(Mark,
            (   zone_mark(Xs, number, across(YA,Y1), Mark)
            ;   zone_mark(Xs, number, across(Y2,YB), Mark)
            ;   zone_mark(Ys, letter, down(XA,X1), Mark)
            ;   zone_mark(Ys, letter, down(X2,XB), Mark)
            ),
            Zones),
    append([[Frame,Grid], Centring, Zones], Marks).

rectangle_line(Role, rect(X1,Y1,X2,Y2),
               line(Role,[X1-Y1,X2-Y1,X2-Y2,X1-Y2,X1-Y1])).

%   centring(MX, MY, Rectangle, Inside, Marks): the lower one reaches Inside mm
%   into the frame, the others 5.

centring(MX, MY, rect(X1,Y1,X2,Y2), Inside, [line(frame,[MX-T1,MX-T2]),
                                     line(frame,[MX-B1,MX-B2]),
                                     line(frame,[L1-MY,L2-MY]),
                                     line(frame,[R1-MY,R2-MY])]) :-
    T1 is Y1-5, T2 is Y1+5,
    B1 is Y2-Inside, B2 is Y2+5,
    L1 is X1-5, L2 is X1+5,
    R1 is X2-5, R2 is X2+5.

%   zones(Side, Middle, From, To, Fields): From-To of the fields of the grid,
%   50 mm from the middle outwards, as many as ISO 5457 has; the last ones take
%   the difference.

zones(Side, Middle, From, To, Fields) :-
    Each is max(1, round((Side/2-10)/50)),
    Low is -(Each-1),
    High is Each-1,
    findall(X, ( between(Low, High, I), X is Middle+50*I ), Cuts),
    append([[From|Cuts],[To]], Ends),
    findall(A-B, append(_, [A,B|_], Ends), Fields).

%   zone_mark(Fields, What, Band, Mark)

zone_mark(Fields, What, Band, Mark) :-
    append(Before, [From-To|After], Fields),
    (   After \== [],
        band_line(Band, To, Mark)
    ;   length(Before, I),
        zone_text(What, I, Text),
        Middle is (From+To)/2,
        band_text(Band, Middle, Text, Mark)
    ).

band_line(across(Y1,Y2), X, line(field,[X-Y1,X-Y2])).
band_line(down(X1,X2), Y, line(field,[X1-Y,X2-Y])).

band_text(across(Y1,Y2), X, Text, text(X,Y,2.5,middle,Text)) :-
    Y is (Y1+Y2)/2+1.25.
band_text(down(X1,X2), Y0, Text, text(X,Y,2.5,middle,Text)) :-
    X is (X1+X2)/2,
    Y is Y0+1.25.

zone_text(number, I, Text) :-
    N is I+1,
    format(string(Text), '~d', [N]).

%   Letters without I and O.

zone_text(letter, I, Text) :-
    sub_atom('ABCDEFGHJKLMNPQRSTUVWXYZ', I, 1, _, Letter),
    atom_string(Letter, Text).


                /*******************************
                *          TITLE BLOCK         *
                *******************************/

%   field(Item, X, Y, Width, Height, TextHeight): millimetres from the upper
%   left corner of the block.

field(drawn_by,     0,  0,  45,  9, 3.5).
field(date,        45,  0,  35,  9, 3.5).
field(checked_by,   0,  9,  45,  9, 3.5).
field(material,    45,  9,  35,  9, 3.5).
field(company,      0, 18,  80, 18, 5.0).
field(name,        80,  0, 100, 18, 5.0).
field(scale,       80, 18,  25,  9, 3.5).
field(angle,      105, 18,  25, 18, 0).
field(paper,       80, 27,  25,  9, 3.5).
field(number,     130, 18,  50,  9, 3.5).
field(revision,   130, 27,  25,  9, 3.5).
field(sheet,      155, 27,  25,  9, 3.5).

block_marks(Corner, Facts, Marks) :-
    block(Width, Height),
    Corner = X1-Y1,
    X2 is X1+Width,
    Y2 is Y1+Height,
    rectangle_line(frame, rect(X1,Y1,X2,Y2), Outline),
    findall(Mark,
            ( field(Item, X, Y, W, H, High),
              field_mark(Item, cell(X,Y,W,H), High, Facts, Corner, Mark)
            ),
            Fields),
    Marks = [Outline|Fields].

%   Its right and lower side, where it is not that of the block; its label; its
%   text.

field_mark(_, cell(X,Y,W,H), _, _, X0-Y0, Mark) :-
    block(Width, Height),
    XA is X0+X, XB is XA+W,
    YA is Y0+Y, YB is YA+H,
    (   X+W < Width,
        Mark = line(field,[XB-YA,XB-YB])
    ;   Y+H < Height,
        Mark = line(field,[XA-YB,XB-YB])
    ).
field_mark(Item, cell(X,Y,_,_), _, Facts, X0-Y0,
           text(TX,TY,1.8,start,Label)) :-
    (   memberchk(label(Item)-Label0, Facts)
    ->  Label = Label0
    ;   memberchk(language-Language, Facts),
        sheet_word(Item, Language, Label)
    ),
    TX is X0+X+1.2,
    TY is Y0+Y+2.8.
field_mark(angle, cell(X,Y,W,H), _, Facts, X0-Y0, Mark) :-
    memberchk(angle-Angle, Facts),
    MX is X0+X+W/2,
    MY is Y0+Y+H/2+1,
    symbol(Angle, MX, MY, Marks),
    member(Mark, Marks).
field_mark(Item, cell(X,Y,W,H), High0, Facts, X0-Y0,
           text(TX,TY,High,middle,Text)) :-
    Item \== angle,
    memberchk(Item-Text0, Facts),
    Text0 \== "",
    fitting_text(Text0, W-3, High0, Text, High),
    TX is X0+X+W/2,
    TY is Y0+Y+(H+2.8+High)/2.

%   fitting_text(Text0, Width, High0, Text, High): as high as Width allows, but
%   no lower than can be read: then the end is left out.

fitting_text(Text0, Width, High0, Text, High) :-
    fitting_height(Text0, Width, High0, High1),
    least_height(Least),
    (   High1 >= Least
    ->  Text = Text0,
        High = High1
    ;   string_codes(Text0, Codes),
        Room is Width/Least - 2.7,      % of three dots
        codes_within(Codes, Room, Kept),
        string_codes(Start, Kept),
        string_concat(Start, "...", Text),
        High = Least
    ).

least_height(1.0).

codes_within([Code|Codes], Room0, Kept) :-
    wider(Code, 0, Wide),
    Room is Room0-Wide,
    Room >= 0,
    !,
    Kept = [Code|Kept1],
    codes_within(Codes, Room, Kept1).
codes_within(_, _, []).

%   fitting_height(Text, Width, High0, High): as high as Width allows.

fitting_height(Text, Width, High0, High) :-
    string_codes(Text, Codes),
    foldl(wider, Codes, 0.0, Wide),
    High is min(High0, Width/max(Wide, 0.1)).

%   How wide a letter is in heights of a capital, roughly and rather too much:
%   Korean and Chinese ones are square.

wider(Code, Wide0, Wide) :-
    (   Code >= 0x1100
    ->  Wide is Wide0+1.42
    ;   Wide is Wide0+0.9
    ).

%   symbol(Angle, X, Y, Marks): a cone cut off, from the side and from its
%   narrow end; in a first-angle drawing what is seen from the left stands on
%   the right.

symbol(Angle, X, Y, Marks) :-
    (   Angle == first
    ->  Cone is X-5.5,
        Circle is X+5.5
    ;   Cone is X+5.5,
        Circle is X-5.5
    ),
    X1 is Cone-3.5, X2 is Cone+3.5,
    Y1 is Y-1.75, Y2 is Y+1.75,
    Y3 is Y-3.5, Y4 is Y+3.5,
    circle(Circle-Y, 3.5, Large),
    circle(Circle-Y, 1.75, Small),
    XA is Cone-4.7, XB is Cone+4.7,
    XC is Circle-4.7, XD is Circle+4.7,
    YC is Y-4.7, YD is Y+4.7,
    chain_line(XA-Y, XB-Y, 3.2, axis, Axis1),
    chain_line(XC-Y, XD-Y, 3.2, axis, Axis2),
    chain_line(Circle-YC, Circle-YD, 3.2, axis, Axis3),
    append([ [ line(symbol,[X1-Y1,X2-Y3,X2-Y4,X1-Y2,X1-Y1]),
               line(symbol,Large), line(symbol,Small) ],
             Axis1, Axis2, Axis3
           ], Marks).

circle(X0-Y0, R, Points) :-
    findall(X-Y,
            ( between(0, 48, I),
              Angle is 2*pi*(I mod 48)/48,
              X is X0 + R*cos(Angle),
              Y is Y0 + R*sin(Angle)
            ),
            Points).
