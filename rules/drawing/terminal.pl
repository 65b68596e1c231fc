:- encoding(utf8).
:- module(sg_terminal,
          [ show/0,
            show/1                      % +Options
          ]).
:- use_module('../environment', [environment/2]).
:- use_module(dot_drawing, [picture_dots/4]).
:- use_module('../picture/hidden_lines', [picture/1]).
:- use_module('../store', [drawn/7]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(ansi_term), [ansi_format/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [member/2, reverse/2]).
:- use_module(library(option), [merge_options/3, option/2, option/3]).
/** <module> The picture in the terminal.

A character shows two dots beside and four above one another: a braille
pattern (U+2800 to U+28FF), or where the terminal does not know UTF-8 the
ASCII character that looks most like the dots. Hidden lines are dotted and, in
colour terminals, dim; penetration lines are red.
*/

%!  show is det.
%!  show(+Options) is det.
%
%   Make the picture of the current world and print it on the current output,
%   as wide as the terminal. Options are those of picture/1 and:
%
%     - width(Columns), height(Rows): not wider, not higher; default: the
%       terminal, or 80 x 24
%     - ascii(Bool): plain characters; default: unless the locale is UTF-8
%     - hidden(How), pattern(P): as for write_drawing/2

show :-
    show([]).

show(Options) :-
    picture(Options),
    (   drawn(_, _, _, _, _, _, _)
    ->  show_drawn(Options)
    ;   print_message(informational, sanggwan(nothing_drawn))
    ).

show_drawn(Options) :-
    terminal_size(Options, Columns, Rows),
    Width is 2*Columns,
    Height is 4*Rows,
    merge_options([size(Width-Height),margin(1)], Options, DotOptions),
    picture_dots(pens(Width,Height,plain), DotOptions, _, Dots),
    glyphs(Options, Glyphs),
    findall(Cells, cell_row(Columns, Rows, Dots, Cells), Lines0),
    without_margin(Lines0, Lines),
    forall(member(Line, Lines), print_cells(Line, Glyphs)).

%   The last column and row stay free: many terminals break or scroll there.

terminal_size(Options, Columns, Rows) :-
    current_output(Out),
    (   catch(tty_size(Rows0, Columns0), error(_, _), fail),
        stream_property(Out, tty(true))
    ->  Rows1 is Rows0-2,
        Columns1 is Columns0-1
    ;   Rows1 = 24,
        Columns1 = 80
    ),
    option(width(Columns2), Options, Columns1),
    option(height(Rows2), Options, Rows1),
    Columns is max(4, min(1000, Columns2)),
    Rows is max(2, min(1000, Rows2)).

glyphs(Options, Glyphs) :-
    (   option(ascii(Ascii), Options)
    ->  true
    ;   knows_utf8
    ->  Ascii = false
    ;   Ascii = true
    ),
    (   Ascii == true
    ->  Glyphs = ascii
    ;   Glyphs = braille
    ).

%   The stream writes UTF-8 always; whether the terminal reads it, the locale
%   says.

knows_utf8 :-
    current_output(Out),
    stream_property(Out, encoding(utf8)),
    member(Variable, ['LC_ALL','LC_CTYPE','LANG']),
    environment(Variable, Locale),
    !,
    downcase_atom(Locale, Lower),
    (   sub_atom(Lower, _, _, _, 'utf-8')
    ;   sub_atom(Lower, _, _, _, utf8)
    ),
    !.

/* - - - cells - - -

cell(Bits,Ink): which of the eight dots are set, numbered as Unicode numbers
those of braille; the ink that matters most among them.
*/

cell_row(Columns, Rows, Dots, Cells) :-
    LastRow is Rows-1,
    LastColumn is Columns-1,
    Stride is 2*Columns,
    between(0, LastRow, Row),
    findall(Cell,
            ( between(0, LastColumn, Column),
              Corner is 4*Row*Stride + 2*Column,
              cell(Corner, Stride, Dots, Cell)
            ),
            Cells0),
    right_trimmed(Cells0, Cells).

cell(Corner, Stride, Dots, cell(Bits,Ink)) :-
    findall(Value-DotInk,
            ( dot_place(X, Y, Value),
              Index is Corner + Y*Stride + X + 1,
              string_code(Index, Dots, DotInk),
              DotInk > 0
            ),
            Set),
    aggregate_all(sum(Value), member(Value-_, Set), Bits),
    (   foremost(Ink),
        memberchk(_-Ink, Set)
    ->  true
    ;   Ink = 0
    ).

dot_place(0, 0, 0x01).
dot_place(0, 1, 0x02).
dot_place(0, 2, 0x04).
dot_place(1, 0, 0x08).
dot_place(1, 1, 0x10).
dot_place(1, 2, 0x20).
dot_place(0, 3, 0x40).
dot_place(1, 3, 0x80).

foremost(2).
foremost(1).
foremost(5).
foremost(4).
foremost(3).

right_trimmed(Cells0, Cells) :-
    reverse(Cells0, Reversed0),
    blank_skipped(Reversed0, Reversed),
    reverse(Reversed, Cells).

blank_skipped([cell(0,_)|Cells0], Cells) :-
    !,
    blank_skipped(Cells0, Cells).
blank_skipped(Cells, Cells).

%   Without the empty lines above and below.

without_margin(Lines0, Lines) :-
    empty_skipped(Lines0, Lines1),
    reverse(Lines1, Lines2),
    empty_skipped(Lines2, Lines3),
    reverse(Lines3, Lines).

empty_skipped([[]|Lines0], Lines) :-
    !,
    empty_skipped(Lines0, Lines).
empty_skipped(Lines, Lines).

/* - - - characters - - - */

print_cells([], _) :-
    nl.
print_cells([cell(Bits,Ink)|Cells], Glyphs) :-
    run(Cells, Ink, Same, Rest),
    maplist(cell_code(Glyphs), [cell(Bits,Ink)|Same], Codes),
    ink_style(Ink, Style),
    ansi_format(Style, '~s', [Codes]),
    print_cells(Rest, Glyphs).

%   The cells that follow in the same ink.

run([cell(Bits,Ink)|Cells], Ink, [cell(Bits,Ink)|Same], Rest) :-
    !,
    run(Cells, Ink, Same, Rest).
run(Rest, _, [], Rest).

ink_style(Ink, Style) :-
    (   Ink =:= 2
    ->  Style = [bold,fg(red)]
    ;   Ink =:= 5
    ->  Style = [faint,fg(red)]
    ;   Ink =:= 3
    ->  Style = [faint]
    ;   Ink =:= 4
    ->  Style = [faint]
    ;   Style = []
    ).

cell_code(_, cell(0,_), 0'\s) :-
    !.
cell_code(braille, cell(Bits,_), Code) :-
    Code is 0x2800+Bits.
cell_code(ascii, cell(Bits,_), Code) :-
    findall(Unlike-Look, ( looks(Look, Bits1),
                           Unlike is popcount(xor(Bits,Bits1))
                         ),
            Looks),
    keysort(Looks, [_-Code|_]).

%   Which dots a character has, more or less.

looks(0'-,  0x12).
looks(0'-,  0x24).
looks(0'-,  0x09).
looks(0'_,  0xc0).
looks(0'|,  0x47).
looks(0'|,  0xb8).
looks(0'/,  0x5c).
looks(0'/,  0x38).
looks(0'/,  0x58).
looks(0'\\, 0xa3).
looks(0'\\, 0xa7).
looks(0'',  0x01).
looks(0'',  0x08).
looks(0'',  0x03).
looks(0'',  0x18).
looks(0'.,  0x40).
looks(0'.,  0x80).
looks(0'.,  0x44).
looks(0'.,  0xa0).
looks(0'+,  0x3f).
looks(0'#,  0xff).
