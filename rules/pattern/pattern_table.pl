:- module(sg_pattern_table,
          [ pattern_tables/4,           % +Ds, +Options, +Paper, -Tables
            table_name/2,               % +Table, -Name
            table_loops/2,              % +Table, -Loops
            table_lines/2,              % +Table, -Lines
            table_word/2                % +Table, -Word
          ]).
:- use_module('../unrolling/true_table',
              [row_height/2, true_length_marks/4, true_length_rows/2]).
:- use_module(pattern_plate, [bend_table/4]).
:- use_module(library(apply), [convlist/3]).
:- use_module(library(lists), [append/2, append/3, member/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> Tables of true lengths on the sheets of a pattern.

A table is nested like a piece. One that is longer than the paper is divided
between two rows; each part has the names of the columns.

    table(D, Part, Marks, Size)

is Part, 1, 2, ..., of the table of pattern D, or 0 if it is whole, Marks as of
true_length_marks/4, Size W-H.
*/

:- set_prolog_flag(optimise, true).

% Letters, in millimetres: so high, or lower if the paper is narrow, down to
% what can be read.
letters(2.5).
least_letters(1.25).

% A table is made so much smaller rather than divided.
least_share(0.7).

%!  pattern_tables(+Ds, +Options, +Paper, -Tables) is det.
%
%   Tables are those of the patterns Ds that have generators, in parts that
%   Paper (pattern_nest.pl) has room for; none if Options say table(false). With
%   titles(Titles), of pattern_titles/2, each part has the title of its pattern.
%   With plates(Plates), D-Measures of plate_measures/4, there are tables of
%   bends too, table(D,bends,Marks,Size). Those with too many columns for it are
%   left out, and counted in a message.

pattern_tables(Ds, Options, Paper, Tables) :-
    (   option(table(true), Options, true)
    ->  findall(D-Rows,
                ( member(D, Ds),
                  true_length_rows(D, All),
                  length(All, Rows),
                  Rows > 0
                ),
                Trues),
        option(titles(Titles), Options, []),
        convlist(table_parts(Titles, Paper), Trues, Partss),
        append(Partss, Tables0),
        (   option(told(false), Options)
        ->  true
        ;   told_left_out(Trues, Partss)
        )
    ;   Tables0 = []
    ),
    findall(Table, bends(Ds, Options, Paper, Table), Bends),
    append(Tables0, Bends, Tables).

%   bends(Ds, Options, Paper, Table) is nondet: with letters as large as the
%   paper has room for.

bends(Ds, Options, Paper, table(D,bends,Marks,Size)) :-
    option(plates(Plates), Options, []),
    option(titles(Titles), Options, []),
    member(D, Ds),
    memberchk(D-Plate, Plates),
    (   memberchk(D-Title, Titles)
    ->  Named = [title(Title)|Options]
    ;   Named = Options
    ),
    (   member(H, [2.5,2.0,1.6,1.25]),
        bend_table(Plate, [height(H)|Named], Marks, Size),
        table_fits(Paper, Size)
    ->  true
    ;   Plate.bends \== [],
        \+ option(told(false), Options),
        print_message(informational, sanggwan(pattern(no_room(bends,1)))),
        fail
    ).

table_fits(roll(_), _).
table_fits(room(RoomW,RoomH,_), Size) :-
    whole_share(RoomW-RoomH, Size, Share),
    Share >= 1.

told_left_out(All, Shown) :-
    length(All, N0),
    length(Shown, N1),
    (   N0 > N1
    ->  N is N0-N1,
        print_message(informational, sanggwan(pattern(no_room(table,N))))
    ;   true
    ).

%   table_parts(Titles, Paper, D-Rows, Parts) is semidet.

table_parts(Titles, Paper, D-Rows, Parts) :-
    letters(H),
    (   memberchk(D-Title, Titles)
    ->  Named = [title(Title)],
        Heads = 2
    ;   Named = [],
        Heads = 1
    ),
    true_length_marks(D, [height(H)|Named], Marks, W-High),
    (   Paper = roll(_)
    ->  Parts = [table(D,0,Marks,W-High)]
    ;   Paper = room(RoomW, RoomH, _),
        whole_share(RoomW-RoomH, W-High, Share),
        least_share(Least),
        Share >= Least
    ->  Small is H*min(1, Share),
        true_length_marks(D, [height(Small)|Named], SmallMarks, Size),
        Parts = [table(D,0,SmallMarks,Size)]
    ;   Paper = room(RoomW, RoomH, _),
        part_room(RoomW-RoomH, W, Letters, High1),
        row_height(Letters, Row),
        Most is floor(High1/Row)-Heads,
        Most >= 1,
        findall(Part, table_part(D, Rows, Most, [height(Letters)|Named], Part),
                Parts)
    ).

%   How much smaller the whole table has to be, upright or lying; a raster takes
%   a little of the room (pattern_nest.pl).

whole_share(RoomW-RoomH, W-H, Share) :-
    Share is 0.96*max(min(RoomW/W, RoomH/H), min(RoomW/H, RoomH/W)).

%   part_room(Room, W, Letters, High): how high a part may be; upright if that
%   does not take much smaller letters.

part_room(RoomW-RoomH, W, Letters, High) :-
    letters(H),
    Upright is min(1.0, 0.96*RoomW/W),
    Lying is min(1.0, 0.96*RoomH/W),
    least_share(Least),
    (   Upright >= min(Least, Lying)
    ->  Letters is H*Upright,
        High is 0.96*RoomH
    ;   Letters is H*Lying,
        High is 0.96*RoomW
    ),
    least_letters(Smallest),
    Letters >= Smallest.

%   Parts are as long as each other, or nearly.

table_part(D, Rows, Most, Options, table(D,I,Marks,Size)) :-
    Count is ceiling(Rows/Most),
    between(1, Count, I),
    From is (I-1)*Rows//Count + 1,
    To is I*Rows//Count,
    true_length_marks(D, [rows(From,To)|Options], Marks, Size).

%!  table_name(+Table, -Name) is det.
%
%   Name, an atom, is that of its view: table2, or table2-1 for a part.

table_name(table(D,bends,_,_), Name) :-
    !,
    format(atom(Name), 'bends~d', [D]).
table_name(table(D,0,_,_), Name) :-
    !,
    format(atom(Name), 'table~d', [D]).
table_name(table(D,I,_,_), Name) :-
    format(atom(Name), 'table~d-~d', [D,I]).

%!  table_loops(+Table, -Loops) is det.
%
%   Loops has its outline, as that of a piece.

table_loops(table(_,_,_,W0-H0), [[0.0-0.0,W-0.0,W-H,0.0-H]]) :-
    W is float(W0),
    H is float(H0).

%!  table_lines(+Table, -Lines) is det.
%
%   Lines, each of points X-Y, are those of its frame.

table_lines(table(_,_,Marks,_), Lines) :-
    findall(Points, member(line(_,Points), Marks), Lines).

%!  table_word(+Table, -Word) is nondet.
%
%   Word is one of its texts (pattern_word.pl).

table_word(table(_,_,Marks,_), word(X-Y,1-0,High,middle,Text)) :-
    member(text(X,Y,High,Text0), Marks),
    format(string(Text), '~w', [Text0]).
