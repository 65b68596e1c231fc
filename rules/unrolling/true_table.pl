:- module(sg_true_table,
          [ generator_mark/4,           % +D, ?Number, -From, -To
            true_length_rows/2,         % +D, -Rows
            true_length_columns/3,      % +D, +Unit, -Columns
            write_true_lengths/2,       % +D, +File
            write_true_lengths/3,       % +D, +File, +Options
            true_length_marks/4,        % +D, +Options, -Marks, -Size
            table_marks/4,              % +Table, +Options, -Marks, -Size
            row_height/2                % +Height, -Row
          ]).
:- use_module('../csg/placed_surface', [placed_surface/3]).
:- use_module('../near', [tolerance/2]).
:- use_module('../language', [result_language/1, with_result_language/2]).
:- use_module('../sheet/lettering', [lettering_width/3]).
:- use_module('../output', [writing/3]).
:- use_module('../store', [e/5, origin/3, segment/3, v/5]).
:- use_module(true_words, [column_word/3]).
:- use_module(library(apply), [foldl/4, maplist/3, maplist/4]).
:- use_module(library(lists),
              [ append/2, append/3, last/2, max_list/2, member/2, nth1/3,
                sum_list/2
              ]).
:- use_module(library(option), [option/2, option/3]).
/** <module> Generators of a true development, and the table of true lengths.

A generator is an auxiliary edge of the pattern, of no polygon, with

    origin(D, e(E), generator(Number, Degrees, Position, From, To))

It runs from below: from its end at the smaller H to that at the larger. Where a
hole interrupts it, it is several edges of one number. Both sides of the seam
are number 1.
*/

%!  generator_mark(+D, ?Number, -From, -To) is nondet.
%
%   Generator Number is drawn from From to To, each X-Y. In order.

generator_mark(D, Number, X1-Y1, X2-Y2) :-
    origin(D, e(E), generator(Number, _, _, _, _)),
    e(D, E, A, B, _),
    v(D, A, X1, Y1, _),
    v(D, B, X2, Y2, _).

%!  true_length_rows(+D, -Rows) is det.
%
%   Rows is the list of row(Number, Degrees, Position, From, To, Length,
%   StepFrom, StepTo, Diagonal), one for each generator of pattern D, in order
%   (empty if D has none). Length is that of the generator; Degrees its
%   parameter. Of a cylinder Position is the arc from the left side of the
%   pattern, From and To are how far its ends are above the base line; of a cone
%   Position is the angle at the apex, degrees, from the seam, From and To are
%   the distances of its ends from the apex (of a layer whose generators do not
%   meet, from that of the drawn surface: no column has them); of a transition
%   they say nothing more than Length. StepFrom and StepTo are the distances in
%   the pattern of its ends from those of the next generator, Diagonal that of
%   its first end from the next one's last: so the pattern can be drawn with
%   compasses, triangle by triangle. They are `none` where there is no next one,
%   and for the further parts of one that holes interrupt.

true_length_rows(D, Rows) :-
    findall(generator(Number, Degrees, Position, From, To)-(P-Q),
            ( origin(D, e(E), Origin),
              Origin = generator(Number, Degrees, Position, From, To),
              edge_ends(D, E, P, Q) ),
            Generators),
    rows(Generators, Rows).

edge_ends(D, E, X1-Y1, X2-Y2) :-
    e(D, E, A, B, _),
    v(D, A, X1, Y1, _),
    v(D, B, X2, Y2, _).

%   rows(Generators, Rows): the parts of a generator that holes interrupt are
%   rows of one number; the first of them has the steps to the next one.

rows([], []).
rows([First|Generators0], [Row|Rows]) :-
    First = Mark-(P-Q),
    more_parts(Generators0, Mark, More, Generators),
    last([First|More], _-(_-Last)),
    (   Generators = [Next-(P2-_)|_]
    ->  more_parts(Generators, Next, NextParts, _),
        last(NextParts, _-(_-Last2)),
        distance(P, P2, StepFrom),
        distance(Last, Last2, StepTo),
        distance(P, Last2, Diagonal)
    ;   StepFrom = none,
        StepTo = none,
        Diagonal = none
    ),
    mark_row(Mark, P-Q, StepFrom, StepTo, Diagonal, Row),
    findall(Other,
            ( member(Mark1-Ends, More),
              mark_row(Mark1, Ends, none, none, none, Other) ),
            Others),
    append(Others, Rest, Rows),
    rows(Generators, Rest).

%   more_parts(Generators0, Mark, Parts, Generators): those at the beginning
%   that have the number and the place of Mark.

more_parts([Part|Generators0], Mark, [Part|Parts], Generators) :-
    Mark = generator(Number, _, Position, _, _),
    Part = generator(Number, _, Position0, _, _)-_,
    Position0 =:= Position,
    !,
    more_parts(Generators0, Mark, Parts, Generators).
more_parts(Generators, _, [], Generators).

mark_row(generator(Number, Degrees, Position, From, To), P-Q, StepFrom, StepTo,
         Diagonal,
         row(Number, Degrees, Position, From, To, Length, StepFrom, StepTo,
             Diagonal)) :-
    distance(P, Q, Length).

distance(X1-Y1, X2-Y2, D) :-
    D is sqrt((X1-X2)**2 + (Y1-Y2)**2).

%!  true_length_columns(+D, +Unit, -Columns) is det.
%
%   Columns is the list of the names of the columns of the table, with units, in
%   the language of results (result_language/1); Unit is that of the model.

true_length_columns(D, Unit, Columns) :-
    pattern_kind(D, Kind),
    place_columns(Kind, Places),
    append([[number-none,parameter-degrees], Places,
            [length-unit,step_from-unit,step_to-unit,diagonal-unit]],
           Names),
    result_language(Language),
    maplist(column_name(Language, Unit), Names, Columns).

%   pattern_kind(D, Kind): of which surface D is; cone_moved: of a layer of a
%   cone whose generators have no one point in common.

pattern_kind(D, Kind) :-
    surface_kind(D, Kind0),
    (   Kind0 == cone,
        \+ one_apex(D)
    ->  Kind = cone_moved
    ;   Kind = Kind0
    ).

%   one_apex(D): the distances from the apex that its generators name are, in
%   the pattern, those from one point.

one_apex(D) :-
    findall(X-Y,
            ( origin(D, e(E), generator(_, _, _, From, To)),
              edge_ends(D, E, X1-Y1, X2-Y2),
              From =\= To,
              X is X1 + (X2-X1)*From/(From-To),
              Y is Y1 + (Y2-Y1)*From/(From-To) ),
            Apexes),
    findall(To, origin(D, e(_), generator(_, _, _, _, To)), Tos),
    findall(From, origin(D, e(_), generator(_, _, _, From, _)), Froms),
    append(Froms, Tos, Distances),
    max_list([0.0|Distances], Size),
    tolerance(place, Of),
    (   Apexes = [Apex|Others]
    ->  forall(member(Other, Others),
               ( distance(Apex, Other, Off), Off < Of*Size ))
    ;   true
    ).

surface_kind(D, Kind) :-
    (   segment(D, _, true_development(S, Part)),
        (   Part = Leaf/Name
        ->  true
        ;   Leaf-Name = S-Part
        ),
        once(placed_surface(Leaf, Name, Surface0))
    ->  (   Surface0 = parallel(Surface, _)
        ->  true
        ;   Surface = Surface0
        ),
        functor(Surface, Kind, _)
    ;   Kind = cylinder
    ).

place_columns(cylinder, [arc-unit,from-unit,to-unit]).
place_columns(sphere, [arc-unit,from-unit,to-unit]).
place_columns(cone, [angle-degrees,apex_from-unit,apex_to-unit]).
place_columns(cone_moved, [angle-degrees]).
place_columns(ruled, []).
place_columns(transition, []).

column_name(Language, Unit, Column-Measure, Name) :-
    column_word(Column, Language, Word),
    (   Measure == none
    ->  Name = Word
    ;   Measure == degrees
    ->  column_word(degrees, Language, Degrees),
        atomic_list_concat([Word, ' (', Degrees, ')'], Name)
    ;   atomic_list_concat([Word, ' (', Unit, ')'], Name)
    ).

%!  write_true_lengths(+D, +File) is det.
%!  write_true_lengths(+D, +File, +Options) is det.
%
%   Writes the table of pattern D to File (`-`: standard output) as CSV: a row
%   with the names and units of the columns, then a row for each generator;
%   nothing in a cell that has no value. Options: unit(Unit) (`mm`), decimals(N)
%   (6), scale(F): all lengths are multiplied by it (1). The file is data for
%   programs: its columns have English names, whoever reads them.

write_true_lengths(D, File) :-
    write_true_lengths(D, File, []).

write_true_lengths(D, File, Options) :-
    with_result_language(en, table(D, Options, 6, Lines)),
    (   File == (-)
    ->  lines_written(Lines, user_output)
    ;   writing(File, text, sg_true_table:lines_written(Lines))
    ).

lines_written(Lines, Stream) :-
    forall(member(Line, Lines),
           ( atomic_list_concat(Line, ',', Text),
             format(Stream, '~w~n', [Text]) )).

%   table(D, Options, Decimals, Lines): lists of texts, the first the columns.

table(D, Options, Decimals0, [Columns|Lines]) :-
    option(unit(Unit), Options, mm),
    option(decimals(Decimals), Options, Decimals0),
    option(scale(F), Options, 1),
    true_length_columns(D, Unit, Columns),
    pattern_kind(D, Kind),
    true_length_rows(D, Rows),
    maplist(line(Decimals, F, Kind), Rows, Lines).

line(Decimals, F, Kind, Row, [Number,Degrees|Texts]) :-
    Row =.. [row,Number,Degrees0,Position,From,To|Lengths],
    number_text(Decimals, 1, Degrees0, Degrees),
    place_texts(Kind, Decimals, F, Position, [From,To], Places),
    maplist(number_text(Decimals, F), Lengths, Rest),
    append(Places, Rest, Texts).

place_texts(cylinder, Decimals, F, Position, Ends, Texts) :-
    maplist(number_text(Decimals, F), [Position|Ends], Texts).
place_texts(sphere, Decimals, F, Position, Ends, Texts) :-
    place_texts(cylinder, Decimals, F, Position, Ends, Texts).
place_texts(cone, Decimals, F, Position, Ends, [Angle|Texts]) :-
    number_text(Decimals, 1, Position, Angle),
    maplist(number_text(Decimals, F), Ends, Texts).
place_texts(cone_moved, Decimals, _, Position, _, [Angle]) :-
    number_text(Decimals, 1, Position, Angle).
place_texts(ruled, _, _, _, _, []).
place_texts(transition, _, _, _, _, []).

number_text(_, _, none, '') :-
    !.
number_text(Decimals, F, Value0, Text) :-
    Scale is 10**Decimals,
    Value is round(Value0*F*Scale)/Scale + 0.0,
    format(atom(Text), '~*f', [Decimals, Value]).


                /*******************************
                *          ON A SHEET          *
                *******************************/

%!  true_length_marks(+D, +Options, -Marks, -Size) is det.
%
%   Marks are the table as it is drawn on a sheet: line(frame, Points) and
%   text(X, Y, Height, Text) as in sheet_marks.pl, millimetres, y up, the text
%   centred on X; from the lower left corner 0, 0; Size is Width-Height.
%   Options: height(H) of the letters (2.5), rows(From,To): only these, under
%   the names of the columns, title(Text): a row above these, and those of
%   write_true_lengths/3, with two decimals. The columns are as wide whichever
%   rows are drawn.

true_length_marks(D, Options, Marks, Width-High) :-
    table(D, Options, 2, Table),
    table_marks(Table, Options, Marks, Width-High).

%!  table_marks(+Table, +Options, -Marks, -Size) is det.
%
%   The same of a Table of lists of texts, the first the names of its columns.

table_marks([Columns|Rows], Options, Marks, Width-High) :-
    option(height(H), Options, 2.5),
    columns_width([Columns|Rows], H, Widths),
    sum_list(Widths, Width),
    length(Rows, Last),
    (   option(rows(From,To), Options)
    ->  true
    ;   From = 1,
        To = Last
    ),
    findall(Row, ( between(From, To, I), nth1(I, Rows, Row) ), Own),
    Lines = [Columns|Own],
    length(Lines, Count),
    row_height(H, Row),
    Under is Count*Row,
    title_marks(Options, H, Under, Width, High, Title),
    findall(Mark,
            ( nth1(I, Lines, Line),
              Y is Under - I*Row + 0.5*H,
              line_text(Line, Widths, 0.0, H, Y, Mark) ),
            Texts),
    frame_lines(Count, Row, Width, Under, Widths, Frame),
    append([Frame,Title,Texts], Marks).

%   title_marks(Options, H, Under, Width, High, Marks): the title in a row of
%   its own above Under, over all columns; in lower letters if it is a long one.

title_marks(Options, H, Under, Width, High, Marks) :-
    (   option(title(Title), Options)
    ->  row_height(H, Row),
        High is Under+Row,
        lettering_width(Title, H, Long),
        Letters is H*min(1.0, (Width-H)/Long),
        X is Width/2.0,
        Y is Under + (Row-Letters)/2.0,
        Marks = [ line(frame, [0.0-Under,0.0-High,Width-High,Width-Under]),
                  text(X, Y, Letters, Title) ]
    ;   High = Under,
        Marks = []
    ).

%!  row_height(+H, -Row) is det.
%
%   Row is how high a row is with letters of height H.

row_height(H, Row) :-
    Row is 2.0*H.

columns_width(Lines, H, Widths) :-
    Lines = [Columns|_],
    findall(0.0, member(_, Columns), None),
    foldl(wider_columns(H), Lines, None, Widths).

wider_columns(H, Line, Widths0, Widths) :-
    maplist(wider_column(H), Line, Widths0, Widths).

wider_column(H, Text, Width0, Width) :-
    format(string(String), '~w', [Text]),
    lettering_width(String, H, Letters),
    Width is max(Width0, Letters+1.7*H).

line_text([Text|Texts], [Width|Widths], X0, H, Y, Mark) :-
    (   Text \== '',
        X is X0 + Width/2.0,
        Mark = text(X, Y, H, Text)
    ;   X1 is X0+Width,
        line_text(Texts, Widths, X1, H, Y, Mark)
    ).

%   Lines between rows and columns.

frame_lines(Count, Row, Width, High, Widths, Lines) :-
    findall(line(frame, [0.0-Y,Width-Y]),
            ( between(0, Count, I), Y is I*Row ),
            Across),
    edges_at(Widths, 0.0, Xs),
    findall(line(frame, [X-0.0,X-High]), member(X, Xs), Up),
    append(Across, Up, Lines).

edges_at([], X, [X]).
edges_at([Width|Widths], X, [X|Xs]) :-
    X1 is X+Width,
    edges_at(Widths, X1, Xs).
