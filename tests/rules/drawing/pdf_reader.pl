:- module(pdf_reader,
          [ read_pdf/2                  % +Text, -Document
          ]).
:- use_module(painted).
:- use_module(reader_words).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(readutil)).
:- use_module(library(yall)).
:- use_module(library(zlib)).
/* A reader of PDF, for tests: see drawing_reader.pl. */

%!  read_pdf(+Text, -Document) is det.
%
%   Document is pdf(Title, Layers, Pages), a page page(W, H, Fills, Paths); W
%   and H in points.

read_pdf(Text, pdf(Title,Layers,Pages)) :-
    must(string_concat("%PDF-1.5\n", _, Text), header),
    must(sub_string(Text, _, 6, 0, "%%EOF\n"), end),
    sub_string(Text, B, _, _, "\nstartxref\n"),
    B1 is B+11,
    sub_string(Text, B1, _, 0, Tail),
    split_string(Tail, "\n", "", [At0|_]),
    number_of(At0, At),
    objects(Text, At, Count, Objects, TrailerAt),
    sub_string(Text, TrailerAt, _, 0, Trailer),
    must(string_concat("trailer\n<< ", _, Trailer), trailer),
    entry(Trailer, "Size", Size),
    must(number_string(Count, Size), size(Size, Count)),
    follow(Trailer, "Root", Objects, Root),
    must(entry(Root, "Type", "/Catalog"), catalogue),
    follow(Root, "Pages", Objects, PageTree),
    must(entry(PageTree, "Type", "/Pages"), pages),
    list_of(PageTree, "Kids", Kids),
    length(Kids, PageCount),
    must(( entry(PageTree, "Count", C), number_string(PageCount, C) ), count),
    unique(Kids, kids),
    list_of(Root, "OCGs", Groups),
    list_of(Root, "Order", Order),
    must(Groups == Order, order),
    unique(Groups, layers),
    maplist(layer_name(Objects), Groups, Layers),
    unique(Layers, layer_names),
    follow(Trailer, "Info", Objects, Info),
    must(sub_string(Info, _, _, _, "/Producer (Sanggwan)"), producer),
    entry(Info, "Title", Title),
    maplist(pdf_page(Objects, Root, Layers), Kids, Pages),
    Made is 3*PageCount+3,
    length(Groups, LayerCount),
    must(Count =:= Made+LayerCount+1, objects(Count)).

%   objects(Text, At, Count, Objects, End): N-Object for each number of the
%   table of cross references at At.

objects(Text, At, Count, Objects, End) :-
    sub_string(Text, At, _, 0, Table),
    must(string_concat("xref\n0 ", Table1, Table), xref(At)),
    split_string(Table1, "\n", "", [Count0|_]),
    number_of(Count0, Count),
    string_length(Count0, Digits),
    First is At+8+Digits,
    sub_string(Text, First, 20, _, Free),
    must(Free == "0000000000 65535 f \n", free),
    Last is Count-1,
    findall(N-Object,
            ( between(1, Last, N),
              From is First+20*N,
              sub_string(Text, From, 20, _, Row),
              must(sub_string(Row, 10, 10, 0, " 00000 n \n"), row(N)),
              sub_string(Row, 0, 10, _, Offset0),
              number_of(Offset0, Offset),
              sub_string(Text, Offset, _, 0, Rest),
              format(string(Head), "~d 0 obj\n", [N]),
              must(string_concat(Head, Body, Rest), offset(N)),
              must(once(sub_string(Body, Length, _, _, "\nendobj\n")),
                   endobj(N)),
              sub_string(Body, 0, Length, _, Object)
            ),
            Objects),
    aggregate_all(count, sub_string(Text, _, _, _, "\nendobj\n"), Written),
    must(Written =:= Last, unlisted(Written)),
    End is First+20*Count.

%   entry(Object, Name, Value): the value of a key of a dictionary.

entry(Object, Name, Value) :-
    format(string(Key), "/~w ", [Name]),
    must(once(sub_string(Object, B, _, _, Key)), no(Name)),
    string_length(Key, Length),
    From is B+Length,
    sub_string(Object, From, _, 0, Rest),
    (   string_concat("[", List, Rest)
    ->  once(sub_string(List, L, _, _, "]")),
        sub_string(List, 0, L, _, Value)
    ;   split_string(Rest, " \n", "", [Value|_])
    ).

reference(Object, Name, N) :-
    entry(Object, Name, N0),
    format(string(Whole), "/~w ~w 0 R", [Name,N0]),
    must(sub_string(Object, _, _, _, Whole), no_reference(Name)),
    number_of(N0, N).

follow(Object, Name, Objects, Found) :-
    reference(Object, Name, N),
    must(memberchk(N-Found, Objects), no_object(N)).

list_of(Object, Name, Numbers) :-
    entry(Object, Name, Text),
    words(Text, Words),
    references(Words, Numbers).

references([], []).
references([N0,"0","R"|Words], [N|Ns]) :-
    number_of(N0, N),
    references(Words, Ns).

layer_name(Objects, N, Name) :-
    must(memberchk(N-Object, Objects), no_layer(N)),
    must(entry(Object, "Type", "/OCG"), no_group(N)),
    entry(Object, "Name", Name0),
    string_concat("(", Name1, Name0),
    string_concat(Name, ")", Name1).

pdf_page(Objects, Root, Layers, N, page(W,H,Fills,Paths)) :-
    must(memberchk(N-Page, Objects), no_page(N)),
    must(entry(Page, "Type", "/Page"), page_type(N)),
    reference(Root, "Pages", Tree),
    must(reference(Page, "Parent", Tree), parent(N)),
    entry(Page, "MediaBox", Box),
    words(Box, ["0","0",W0,H0]),
    maplist(number_of, [W0,H0], [W,H]),
    entry(Page, "Properties", _),
    findall(Label-Layer,
            ( nth0(I, Layers, Layer),
              list_of(Root, "OCGs", Groups),
              nth0(I, Groups, Group),
              format(string(Property), "/L~d ~d 0 R", [I,Group]),
              must(sub_string(Page, _, _, _, Property), property(I)),
              format(string(Label), "/L~d", [I])
            ),
            Labels),
    follow(Page, "Contents", Objects, Content),
    follow(Content, "Length", Objects, Length0),
    must(once(sub_string(Content, B, _, _, " >>\nstream\n")), stream),
    From is B+11,
    number_of(Length0, Length),
    must(sub_string(Content, From, Length, After, Stream), length(Length)),
    must(After =:= 9, length(Length)),
    must(sub_string(Content, _, 9, 0, "endstream"), endstream),
    painted(Stream, pdf, [], H, Labels, Fills, Paths).
