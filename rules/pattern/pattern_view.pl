:- module(sg_pattern_view,
          [ moved/3,                    % +Move, +Point0, -Point
            sheet_move/3,               % +Sheet, +Place, -Move
            piece_view/5,               % +Height, +Kerf, +Letters, +Placed,
                                        % -View
            table_view/3,               % +Sheet, +Laid, -View
            letters_by_piece/2          % +Letters, -ByPiece
          ]).
:- use_module(pattern_kerf, [kerf_strokes/4]).
:- use_module(pattern_lines, [outline_strokes/3]).
:- use_module(pattern_table, [table_lines/2, table_name/2, table_word/2]).
:- use_module(pattern_word, [word_lines/3, word_lines/4, word_text/6]).
:- use_module(library(apply),
              [ convlist/3, foldl/4, foldl/6, maplist/3, maplist/4, maplist/5
              ]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [append/2, append/3, last/2, member/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
:- use_module(library(rbtrees), [list_to_rbtree/2, rb_insert_new/4]).
/** <module> What is drawn of a piece or a table of a pattern, on its sheet.

Views and strokes as in sheet.pl, thousandths of a millimetre, y down.
*/

%!  moved(+Move, +Point0, -Point) is det.
%
%   Point is Point0, X-Y, by a Move of sheet_move/3.

moved(move(Cos,Sin,DX,DY,Left,Bottom), X0-Y0, X-Y) :-
    X is X0*Cos - Y0*Sin + DX + Left,
    Y is X0*Sin + Y0*Cos + DY + Bottom.

%!  sheet_move(+Sheet, +Place, -Move) is det.
%
%   Move is where Place, as of nested/3, is on Sheet. Right angles are exact.

sheet_move(sheet(_,_,Left,Bottom,_,_), place(_,Degrees,DX,DY),
           move(Cos,Sin,DX,DY,Left,Bottom)) :-
    turning(Degrees, Cos, Sin).

turning(Degrees, Cos, Sin) :-
    (   turn(Degrees, Cos0, Sin0)
    ->  Cos = Cos0,
        Sin = Sin0
    ;   Cos is cos(Degrees*pi/180),
        Sin is sin(Degrees*pi/180)
    ).

turn(0.0,    1, 0).
turn(90.0,   0, 1).
turn(180.0, -1, 0).
turn(270.0,  0, -1).

%!  piece_view(+Height, +Kerf, +Letters, +Placed, -View) is det.
%
%   View of a piece that is placed/5 (pattern_drawing.pl) on a sheet of this
%   Height: letters, marks and folds first, so that it still hangs together when
%   they are made; then holes, the outline last.

piece_view(Height, Kerf, Letters, placed(Name,_,Loops0,Lines0,_),
           view(View,Strokes,Words)) :-
    Name = name(D, _, _),
    view_name(Name, View),
    (   get_assoc(Name, Letters, Own)
    ->  maplist(letters_drawn(Height, D), Own, Textss, Wordss),
        append(Textss, Texts),
        append(Wordss, Words)
    ;   Texts = [],
        Words = []
    ),
    findall(Role-stroke(visible,Role,D,Es,[A,B],joint,joint),
            ( member(line(Role,E,A0,B0), Lines0),
              on_paper(Height, A0, A),
              on_paper(Height, B0, B),
              A \== B,
              edge_list(E, Es)
            ),
            Lines),
    maplist(paper_loop(Height), Loops0, Loops),
    single_lines(Lines, Loops, Single),
    in_painting_order(Single, Inner),
    outline_strokes(Loops, D, Cut0),
    kerf_strokes(Kerf, View, Cut0, Cut),
    append([Texts, Inner, Cut], Strokes).

%   single_lines(Lines, Loops, Single): those of Lines, Role-Stroke, that lie on
%   no line that is cut, nor on one before them.

single_lines(Lines, Loops, Single) :-
    findall(Key-true,
            ( member(Loop, Loops), member(edge(_,A,B), Loop),
              msort([A,B], Key) ),
            Keys0),
    sort(1, @<, Keys0, Keys),
    list_to_rbtree(Keys, Cut),
    foldl(single_line, Lines, Cut-Single, _-[]).

single_line(Line, Seen0-Single0, Seen-Single) :-
    Line = _-stroke(_, _, _, _, Points, _, _),
    msort(Points, Key),
    (   rb_insert_new(Seen0, Key, true, Seen)
    ->  Single0 = [Line|Single]
    ;   Seen = Seen0,
        Single0 = Single
    ).

%   A side that a line made is no edge of the model.

edge_list(0, []) :-
    !.
edge_list(E, [E]).

in_painting_order(Lines, Strokes) :-
    findall(Stroke,
            ( member(Role, [mark,generator,penetration_line,fold_up,fold_down]),
              member(Role-Stroke, Lines)
            ),
            Strokes).

view_name(name(D,K,Part), View) :-
    (   Part =:= 0
    ->  format(atom(View), 'p~d-~d', [D,K])
    ;   format(atom(View), 'p~d-~d-~d', [D,K,Part])
    ).

%!  table_view(+Sheet, +Laid, -View) is det.
%
%   View of a table that is laid on Sheet.

table_view(Sheet, laid(Table,_,Place), view(Name,Strokes,Texts)) :-
    Table = table(D, _, _, _),
    Sheet = sheet(_, Height, _, _, _, _),
    table_name(Table, Name),
    table_lines(Table, Lines),
    sheet_move(Sheet, Place, Move),
    maplist(table_line(Move, Height), Lines, Framed),
    maplist(table_stroke(D), Framed, Frame),
    findall(Word, table_word(Table, Word), Words),
    maplist(table_text(Move, Height, D), Words, Letters, Texts),
    append([Frame|Letters], Strokes).

table_text(Move, Height, D, Word, Strokes, Text) :-
    word_lines(Height, Move, Word, Lines),
    maplist(table_stroke(D), Lines, Strokes),
    moved_word(Move, Word, Moved),
    word_text(Height, table, D, Moved, Strokes, Text).

moved_word(Move, word(At0,U0-V0,High,Anchor,String),
           word(At,U-V,High,Anchor,String)) :-
    Move = move(Cos, Sin, _, _, _, _),
    U is U0*Cos - V0*Sin,
    V is U0*Sin + V0*Cos,
    moved(Move, At0, At).

table_line(Move, Height, Points0, Points) :-
    maplist(moved(Move), Points0, Points1),
    maplist(on_paper(Height), Points1, Points).

table_stroke(D, Points, stroke(visible,table,D,[],Points,joint,joint)).

%!  letters_by_piece(+Letters:list, -ByPiece) is det.
%
%   ByPiece is an assoc from the names of pieces to the Letters on them.

letters_by_piece(Letters, ByPiece) :-
    findall(Name-letters(Role,Under,Word),
            member(letters(Role,Name,Under,Word), Letters),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    list_to_assoc(Groups, ByPiece).

%   letters_drawn(Height, D, Letters, Strokes, Texts): the strokes of all of it,
%   and what of it is a text.

letters_drawn(Height, D, letters(Role,Under,Word), Strokes, [Text]) :-
    word_lines(Height, Word, Lines),
    maplist(maplist(on_paper(Height)), Under, Under1),
    convlist(letter_stroke(Role, D), Under1, Below),
    convlist(letter_stroke(Role, D), Lines, Letters),
    append(Below, Letters, Strokes),
    word_text(Height, Role, D, Word, Letters, Text).

letter_stroke(Role, D, Points, stroke(visible,Role,D,[],Points,End,End)) :-
    Points = [First|Rest],
    Rest \== [],
    last(Rest, Last),
    (   First == Last
    ->  End = ring
    ;   End = joint
    ).

paper_loop(Height, Loop0, Loop) :-
    maplist(paper_edge(Height), Loop0, Loop).

paper_edge(Height, edge(E,A0,B0), edge(E,A,B)) :-
    on_paper(Height, A0, A),
    on_paper(Height, B0, B).

on_paper(Height, X0-Y0, X-Y) :-
    X is round(X0*1000),
    Y is round((Height-Y0)*1000).
