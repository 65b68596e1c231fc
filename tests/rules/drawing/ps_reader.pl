:- module(ps_reader,
          [ read_ps/2                   % +Text, -Document
          ]).
:- use_module(painted).
:- use_module(reader_words).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(yall)).
/* A reader of PostScript, for tests: see drawing_reader.pl. */

%!  read_ps(+Text, -Document) is det.
%
%   Document is ps(Kind, Title, Page).

read_ps(Text, ps(Kind,Title,page(W,H,Fills,Paths))) :-
    split_string(Text, "\n", "", Lines),
    must(append([First,Box,HighBox,TitleLine,"%%Creator: Sanggwan",
                 "%%LanguageLevel: 2","%%Pages: 1","%%EndComments",
                 "%%BeginProlog"], Rest, Lines), comments),
    must(kind(First, Kind), kind(First)),
    must(string_concat("%%BoundingBox: 0 0 ", Box1, Box), box),
    must(string_concat("%%HiResBoundingBox: 0 0 ", HighBox1, HighBox), box),
    words(Box1, Whole0),
    words(HighBox1, High0),
    maplist(number_of, Whole0, Whole),
    maplist(number_of, High0, [W,H]),
    must(maplist([A,B]>>( integer(A), A >= B-0.001, A-1 < B ), Whole, [W,H]),
         box(Whole, W, H)),
    must(string_concat("%%Title: ", Title, TitleLine), title),
    append(Defined, ["%%EndProlog"|Body0], Rest),
    !,
    maplist(definition, Defined, Defs),
    pairs_keys(Defs, Names),
    unique(Names, operators),
    (   Kind == ps
    ->  format(string(Size), "<< /PageSize [~3f ~3f] >> setpagedevice", [W,H]),
        must(append(["%%BeginSetup",Size,"%%EndSetup"], Body1, Body0), Size)
    ;   Body1 = Body0
    ),
    must(append(["%%Page: 1 1","gsave"], Body2, Body1), page),
    must(append(Body, ["grestore","showpage","%%EOF",""], Body2), end),
    atomic_list_concat(Body, '\n', Content),
    painted(Content, ps, Defs, H, [], Fills, Paths).

kind("%!PS-Adobe-3.0", ps).
kind("%!PS-Adobe-3.0 EPSF-3.0", eps).

definition(Line, Name-Words) :-
    must(string_concat("/", Rest, Line), definition(Line)),
    must(once(sub_string(Rest, B, 1, _, "{")), definition(Line)),
    sub_string(Rest, 0, B, _, Name),
    must(sub_string(Rest, _, _, 0, "}bind def"), definition(Line)),
    From is B+1,
    string_length(Rest, Length),
    Inner is Length-From-9,
    sub_string(Rest, From, Inner, _, Body),
    words(Body, Words).
