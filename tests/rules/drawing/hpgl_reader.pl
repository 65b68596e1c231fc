:- module(hpgl_reader,
          [ read_hpgl/2                 % +Text, -Document
          ]).
:- use_module(reader_words).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(yall)).
/* A reader of HPGL, for tests: see drawing_reader.pl. */

%!  read_hpgl(+Text, -Document) is det.
%
%   Document is hpgl(Corner, Pens, Pieces): Corner X-Y of IP or none, the pens
%   in order, and piece(Pen, Type, Comment, A, B) of each straight line drawn,
%   in units; Type is solid or type(N,Percent).

read_hpgl(Text, hpgl(Corner,Pens,Pieces)) :-
    split_string(Text, "\n", "", Lines0),
    must(append(["IN;",Size|Lines], ["PU;SP0;",""], Lines0), frame),
    must(string_concat("PS", SizeNumbers, Size), size),
    string_concat(SizeWords, ";", SizeNumbers),
    must(hpgl_points(SizeWords, [_]), size(Size)),
    (   Lines = [First|Lines1],
        string_concat("IP0,0,", Rest, First)
    ->  string_concat(Numbers, ";", Rest),
        hpgl_points(Numbers, [Corner])
    ;   Lines1 = Lines,
        Corner = none
    ),
    foldl(hpgl_line, Lines1, pen(none,up,none,solid,none,[],[]),
          pen(_,_,_,Type,_,Pens0,Pieces0)),
    must(Type == solid, line_type_left(Type)),
    reverse(Pens0, Pens),
    unique(Pens, pens),
    reverse(Pieces0, Pieces).

hpgl_line(Line, pen(Pen0,Down0,At0,Type0,Comment0,Pens0,Pieces0), State) :-
    (   string_concat("PU;SP", Rest, Line)
    ->  string_concat(N, ";", Rest),
        number_of(N, Pen),
        State = pen(Pen,up,At0,Type0,none,[Pen|Pens0],Pieces0)
    ;   string_concat("CO \"", Rest, Line)
    ->  must(string_concat(Comment, "\";", Rest), comment(Line)),
        State = pen(Pen0,Down0,At0,Type0,Comment,Pens0,Pieces0)
    ;   Line == "LT;"
    ->  State = pen(Pen0,Down0,At0,solid,Comment0,Pens0,Pieces0)
    ;   string_concat("LT", Rest, Line)
    ->  string_concat(Numbers, ";", Rest),
        split_string(Numbers, ",", "", Words),
        maplist(number_of, Words, [N,Percent]),
        State = pen(Pen0,Down0,At0,type(N,Percent),Comment0,Pens0,Pieces0)
    ;   split_string(Line, ";", "", Parts0),
        must(append(Parts, [""], Parts0), semicolon(Line)),
        foldl(hpgl_move, Parts,
              pen(Pen0,Down0,At0,Type0,Comment0,Pens0,Pieces0), State)
    ).

hpgl_move(Part, pen(Pen,_,_,Type,Comment,Pens,Pieces),
          pen(Pen,up,At,Type,Comment,Pens,Pieces)) :-
    string_concat("PU", Numbers, Part),
    !,
    hpgl_points(Numbers, Points),
    last(Points, At).
hpgl_move(Part, pen(Pen,_,At0,Type,Comment,Pens,Pieces0),
          pen(Pen,down,At,Type,Comment,Pens,Pieces)) :-
    must(string_concat("PD", Numbers, Part), instruction(Part)),
    must(Pen \== none, no_pen),
    hpgl_points(Numbers, Points),
    foldl(hpgl_piece(Pen, Type, Comment), Points, At0-Pieces0, At-Pieces).

hpgl_piece(Pen, Type, Comment, B, A-Pieces,
           B-[piece(Pen,Type,Comment,A,B)|Pieces]).

hpgl_points(Text, Points) :-
    split_string(Text, ",", "", Words),
    maplist(number_of, Words, Numbers),
    must(maplist(integer, Numbers), integers(Text)),
    hpgl_pairs(Numbers, Points).

hpgl_pairs([], []).
hpgl_pairs([X,Y|Numbers], [X-Y|Points]) :-
    hpgl_pairs(Numbers, Points).
