:- module(sg_pattern_paper,
          [ pattern_paper/3,            % +Options, +Gap, -Paper
            page_room/3,                % +Sheet, +Gap, -Paper
            sheet_of/4,                 % +Options, +Paper, +Size, -Sheet
            sheet_line/4,               % +Sheet, +Options, +Says, -Line
            line_strokes/4,             % +Lines, +Height, -Strokes, -Texts
            grid_line/3,                % +Step, +Sheet, -Line
            page_sheet/2,               % +Options, -Sheet
            paper_checked/1,            % +Options
            pages_checked/1,            % +Count
            extent_checked/1,           % +Pointss
            sheet_window/2              % +Sheet, -Window
          ]).
:- use_module('../near', [tolerance/2]).
:- use_module(pattern_word, [word_lines/3, word_text/6]).
:- use_module('../sheet/sheet_paper', [paper/3, paper_size/3]).
:- use_module(library(apply), [maplist/3, maplist/4]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(lists), [append/2, max_member/2, member/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> The paper of a pattern: sizes, the check bar, the grid.

    sheet(Width, Height, Left, Bottom, RoomW, RoomH)

is a sheet in millimetres and what is free on it for pieces, from Left to the
right and from Bottom upwards, both measured from the lower left corner. Below
it, in the margin, a bar says how large the sheet came out of the printer. Lines
are line(Role,Points), y up, or line(Role,Word), Word as in pattern_word.pl;
letters are lines too, with a pen of their own, which is not the knife's.
*/

% Millimetres: below the pieces, for the check bar.
band(9.0).

% Millimetres: less is no room for pieces.
least_room(20.0).

% More pages are a mistake of the scale.
most_pages(5000).

%   most_extent(Millimetres): no place on a sheet is farther from the first.

most_extent(1.0e12).

% The page if there have to be pages, and none is asked for.
tile_page('A4').

%!  page_sheet(+Options, -Sheet) is semidet.
%
%   Sheet is an empty page as Options ask for: page(P), a name as for --sheet,
%   `WxH` or W-H in millimetres, or `letter`; of tile(true), pages(N) and
%   fit(true) A4 without that.
%   Fails if there are no pages.
%
%   @error usage_error(pattern(What)): paper(P, Names); margin(Margin, W-H);
%          overlap(Overlap, Most), of a sheet that is to be tiled

page_sheet(Options, sheet(Width,Height,Margin,Bottom,RoomW,RoomH)) :-
    page(Options, Page),
    page_size(Page, Width, Height),
    margin(Options, Margin),
    band(Band),
    Bottom is Margin+Band,
    RoomW is Width-2*Margin,
    RoomH is Height-2*Margin-Band,
    Room is min(RoomW, RoomH),
    least_room(Least),
    (   Room >= Least
    ->  true
    ;   throw(error(usage_error(pattern(margin(Margin, Width-Height))), _))
    ),
    (   option(tile(true), Options),
        option(overlap(Overlap), Options, 10),
        Overlap > Room/2
    ->  Most is Room/2,
        throw(error(usage_error(pattern(overlap(Overlap, Most))), _))
    ;   true
    ).

page(Options, Page) :-
    (   option(page(Page0), Options)
    ->  Page = Page0
    ;   wants_pages(Options)
    ->  tile_page(Page)
    ).

wants_pages(Options) :-
    option(tile(true), Options).
wants_pages(Options) :-
    option(pages(_), Options).
wants_pages(Options) :-
    option(fit(true), Options).

%!  paper_checked(+Options) is det.
%
%   @error usage_error(pattern(What)): as page_sheet/2

paper_checked(Options) :-
    (   page_sheet(Options, _)
    ->  true
    ;   true
    ).

%!  pages_checked(+Count) is det.
%
%   @error usage_error(pattern(pages(Count, Most))): nobody wants so many

pages_checked(Count) :-
    most_pages(Most),
    (   Count =< Most
    ->  true
    ;   throw(error(usage_error(pattern(pages(Count, Most))), _))
    ).

%!  extent_checked(+Pointss) is det.
%
%   Pointss are lists of X-Y in mm. A sheet counts in thousandths of them, which
%   are whole numbers that floats hold.
%
%   @error usage_error(pattern(large(Size, Most))): a side is longer than Most
%   mm

extent_checked(Pointss) :-
    most_extent(Most),
    findall(Far,
            ( member(Points, Pointss),
              member(X-Y, Points),
              Far is max(abs(X), abs(Y)) ),
            Fars),
    (   max_member(Size, Fars),
        Size > Most
    ->  throw(error(usage_error(pattern(large(Size, Most))), _))
    ;   true
    ).

page_size(Page, Width, Height) :-
    (   named_page(Page, Width0, Height0),
        min(Width0, Height0) >= 50,
        max(Width0, Height0) =< 20000
    ->  Width is float(Width0),
        Height is float(Height0)
    ;   findall(Name, paper_size(Name, _, _), Names),
        throw(error(usage_error(pattern(paper(Page, Names))), _))
    ).

named_page(W-H, Width, Height) :-
    !,
    number(W),
    number(H),
    Width = W,
    Height = H.
named_page(Text, Width, Height) :-
    paper(Text, Width, Height),
    !.
named_page(Text, Width, Height) :-
    downcase_atom(Text, Name),
    letter_page(Name, Width, Height),
    !.
named_page(Text, Width, Height) :-
    split_string(Text, "xX", " ", [TextW,TextH]),
    catch(number_string(Width, TextW), error(syntax_error(_), _), fail),
    catch(number_string(Height, TextH), error(syntax_error(_), _), fail).

letter_page(letter, 215.9, 279.4).
letter_page('letter-portrait', 215.9, 279.4).
letter_page('letter-landscape', 279.4, 215.9).

%!  pattern_paper(+Options, +Gap, -Paper) is det.
%
%   Paper is what pieces are nested on (pattern_nest.pl): the room of a page, or
%   one sheet as large as needed if there is no page, or if it is to be tiled.

pattern_paper(Options, Gap, Paper) :-
    (   \+ option(tile(true), Options),
        page_sheet(Options, Sheet)
    ->  page_room(Sheet, Gap, Paper)
    ;   Paper = roll(Gap)
    ).

%!  page_room(+Sheet, +Gap, -Paper) is det.
%
%   Paper is what pieces are nested on if Sheet is their page.

page_room(sheet(_,_,_,_,RoomW,RoomH), Gap, room(RoomW,RoomH,Gap)).

margin(Options, Margin) :-
    option(margin(Margin), Options, 10),
    must_be(number, Margin).

%!  sheet_of(+Options, +Paper, +Size, -Sheet) is det.
%
%   Sheet is a page, or, if Paper is a roll, large enough for pieces of Size,
%   W-H, and for the bar.

sheet_of(Options, room(_,_,_), _, Sheet) :-
    !,
    page_sheet(Options, Sheet).
sheet_of(Options, roll(_), W-H,
         sheet(Width,Height,Left,Bottom,W,H)) :-
    margin(Options, Margin),
    band(Band),
    Width is max(110.0, ceiling(W+2*Margin)),
    Height is ceiling(H+2*Margin+Band),
    Left is (Width-W)/2,
    Bottom is Margin+Band.

%!  sheet_window(+Sheet, -Window) is det.
%
%   Window, rect(X1,Y1,X2,Y2), y up, is what pieces may take of the sheet.

sheet_window(sheet(_,_,Left,Bottom,W,H), rect(Left,Bottom,X2,Y2)) :-
    X2 is Left+W,
    Y2 is Bottom+H.

%!  sheet_line(+Sheet, +Options, +Says, -Line) is nondet.
%
%   The check bar of a sheet: a bar with a tick for every 10 mm, how long it is,
%   and Says, a list of strings, to the right of it.

sheet_line(sheet(Width,_,_,Bottom,_,_), Options, Says, line(bar,Line)) :-
    margin(Options, Margin),
    Left is max(4.0, Margin),
    bar_length(Width-2*Left, Length),
    band(Band),
    Base is max(3.0, Bottom-Band+1.0),
    Right is Left+Length,
    (   bar_line(Left, Base, Length, Line)
    ;   format(string(Text), '~d mm', [Length]),
        length_place(Right, Base, Width, X, Y),
        Line = word(X-Y,1-0,2.5,start,Text)
    ;   Says \== [],
        X is Right+20,
        X+20 < Width,
        atomic_list_concat(Says, '   ', Text0),
        atom_string(Text0, Text),
        Line = word(X-Base,1-0,2.5,start,Text)
    ).

%   On the right of the bar; above it if there the sheet ends.

length_place(Right, Base, Width, X, Y) :-
    (   Right+18 =< Width
    ->  X is Right+2,
        Y = Base
    ;   X is Right-18,
        Y is Base+4.5
    ).

bar_length(Free, Length) :-
    (   Free >= 100
    ->  Length = 100
    ;   Free >= 50
    ->  Length = 50
    ;   Length = 20
    ).

bar_line(Left, Base, Length, [Left-Base,Right-Base]) :-
    Right is Left+Length.
bar_line(Left, Base, Length, [X-Base,X-Top]) :-
    Last is Length//10,
    between(0, Last, I),
    X is Left+10*I,
    (   ( I =:= 0 ; I =:= Last )
    ->  Top is Base+4
    ;   I mod 5 =:= 0
    ->  Top is Base+3
    ;   Top is Base+2
    ).

%!  line_strokes(+Lines, +Height, -Strokes, -Texts) is det.
%
%   Strokes (sheet.pl) are Lines on a sheet of Height mm, Texts the words among
%   them (word_text/6).

line_strokes(Lines, Height, Strokes, Texts) :-
    maplist(own_strokes(Height), Lines, Strokess, Textss),
    append(Strokess, Strokes),
    append(Textss, Texts).

own_strokes(Height, line(Role,Line), Strokes, Texts) :-
    (   Line = word(_, _, _, _, _)
    ->  word_lines(Height, Line, Pointss),
        maplist(line_stroke(Role), Pointss, Strokes),
        word_text(Height, Role, 0, Line, Strokes, Text),
        Texts = [Text]
    ;   maplist(on_paper(Height), Line, Points),
        line_stroke(Role, Points, Stroke),
        Strokes = [Stroke],
        Texts = []
    ).

line_stroke(Role, Points, stroke(visible,Role,0,[],Points,joint,joint)).

on_paper(Height, X0-Y0, X-Y) :-
    X is round(X0*1000),
    Y is round((Height-Y0)*1000).

%!  grid_line(+Step, +Sheet, -Line) is nondet.
%
%   The lines of a grid, Step mm apart, over the room for pieces.

grid_line(Step, Sheet, line(grid,[A,B])) :-
    sheet_window(Sheet, rect(X1,Y1,X2,Y2)),
    (   grid_step(X1, X2, Step, X),
        A = X-Y1,
        B = X-Y2
    ;   grid_step(Y1, Y2, Step, Y),
        A = X1-Y,
        B = X2-Y
    ).

grid_step(From, To, Step, At) :-
    tolerance(rounding, Near),
    Last is floor((To-From)/Step + Near),
    between(0, Last, I),
    At is From+I*Step.
