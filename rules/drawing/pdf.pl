:- module(sg_pdf,
          [ write_pdf/3,                % +Out, +Inked, +Options
            write_pdf_pages/3           % +Out, +Inkeds, +Options
          ]).
:- use_module(ink, [dashes_option/3]).
:- use_module('../kernel', [image_size/3]).
:- use_module(drawing_shading, [page_images/4]).
:- use_module(image_text, [image_flate/2]).
:- use_module(page, [write_page/6, page_layers/2, page_points/2, text_hex/2]).
:- use_module(library(apply), [foldl/5, maplist/3]).
:- use_module(library(lists),
              [append/2, list_to_set/2, member/2, nth0/3, nth1/3]).
:- use_module(library(option), [option/3]).
/** <module> PDF: a page of lines in true millimetres.

PDF 1.5, each page as large as its sheet, nothing compressed, no time and no
name of a user in it: the same drawing gives the same bytes. Layers of the
style are layers of the document, which a viewer can hide. Colours are those
for print. Texts are drawn (lettering.pl), so no font is needed, for Korean
either.

@see ISO 32000-1: 7.5 the structure of a file, 8.5 paths, 8.11 layers
*/

%!  write_pdf(+Out, +Inked, +Options) is det.
%
%   Write Inked (ink.pl) to stream Out. Options: title(Text), dashes(How),
%   `geometry`: each dash is a line.

write_pdf(Out, Inked, Options) :-
    write_pdf_pages(Out, [Inked], Options).

%!  write_pdf_pages(+Out, +Inkeds, +Options) is det.
%
%   The same, with a page for each of Inkeds.

write_pdf_pages(Out, Inkeds, Options) :-
    dashes_option(Options, fitted, How0),
    page_how(How0, How),
    maplist(page_layers, Inkeds, Layerss),
    append(Layerss, Layers0),
    list_to_set(Layers0, Layers),
    character_count(Out, Base),
    write(Out, '%PDF-1.5\n'),
    findall(Object, object(Layers, Inkeds, Options, Object), Objects),
    foldl(write_object(pages(Out,Base,How,Layers,Inkeds,Options)),
          Objects, Starts,
          1-none, Count-_),
    character_count(Out, End0),
    End is End0-Base,
    length(Inkeds, Pages),
    Information is 3*Pages+3,
    cross_references(Out, Starts, Count-Information, End).

page_how(type, fitted) :-
    !.
page_how(How, How).

%   object(Layers, Inkeds, Options, Object): the objects in order: 1 the
%   catalogue, 2 pages; each page, its content and the length of that;
%   information, the layers. Object is its text; content(I), of the I-th page;
%   or `length`, of the content before it, which is known when that is written.

object(Layers, Inkeds, _, Body) :-
    length(Layers, N),
    first_layer(Inkeds, First),
    findall(Reference, layer_reference(First, N, Reference), References),
    atomic_list_concat(References, ' ', All),
    format(string(Body),
           '<< /Type /Catalog /Pages 2 0 R /OCProperties << /OCGs [~w] \c
            /D << /Order [~w] >> >> >>', [All,All]).
object(_, Inkeds, _, Body) :-
    length(Inkeds, Count),
    findall(Reference,
            ( between(1, Count, I),
              Number is 3*I,
              format(atom(Reference), '~d 0 R', [Number])
            ),
            References),
    atomic_list_concat(References, ' ', Kids),
    format(string(Body), '<< /Type /Pages /Kids [~w] /Count ~d >>',
           [Kids,Count]).
object(Layers, Inkeds, _, Object) :-
    first_layer(Inkeds, First),
    nth1(I, Inkeds, Inked),
    (   Number is 3*I+1,
        page_object(Layers, First, Inked, Number, Object)
    ;   Object = content(I)
    ;   Object = length
    ).
object(_, _, Options, Body) :-
    option(title(Title), Options, ''),
    text_hex(Title, Hex),
    format(string(Body), '<< /Title ~w /Producer (Sanggwan) >>', [Hex]).
object(Layers, _, _, Body) :-
    member(Layer, Layers),
    format(string(Body), '<< /Type /OCG /Name (~w) >>', [Layer]).

page_object(Layers, First, inked(sheet(W,H,_),_,_), Content, Body) :-
    page_points(W, Width),
    page_points(H, Height),
    findall(Text,
            ( nth0(N, Layers, _),
              Number is N+First,
              format(atom(Text), '/L~d ~d 0 R', [N,Number])
            ),
            Texts),
    atomic_list_concat(Texts, ' ', Properties),
    format(string(Body),
           '<< /Type /Page /Parent 2 0 R /MediaBox [0 0 ~w ~w] \c
            /Contents ~d 0 R~n/Resources << /Properties << ~w >> >> >>',
           [Width,Height,Content,Properties]).

%   first_layer(Inkeds, Number): the object of the first layer.

first_layer(Inkeds, Number) :-
    length(Inkeds, Pages),
    Number is 3*Pages+4.

layer_reference(First, N, Reference) :-
    Last is First+N-1,
    between(First, Last, Number),
    format(atom(Reference), '~d 0 R', [Number]).

%   write_object(Pages, Object, Start, N0-Length0, N-Length): object N0 begins
%   Start bytes after the beginning; all of the file is ASCII.

write_object(Pages, Object, Start, N0-Length0, N-Length) :-
    Pages = pages(Out, Base, _, _, _, _),
    character_count(Out, At),
    Start is At-Base,
    format(Out, '~d 0 obj~n', [N0]),
    write_body(Object, Pages, N0, Length0, Length),
    format(Out, '~nendobj~n', []),
    N is N0+1.

write_body(content(I), pages(Out,_,How,Layers,Inkeds,Options), N, _, Length) :-
    !,
    LengthObject is N+1,
    format(Out, '<< /Length ~d 0 R >>~nstream~n', [LengthObject]),
    character_count(Out, From),
    nth1(I, Inkeds, Inked),
    write_page(Out, print, How, Layers, Inked,
               sg_pdf:write_images(Out, Options, Inked)),
    character_count(Out, To),
    Length is To-From,
    write(Out, endstream).
write_body(length, pages(Out,_,_,_,_,_), _, Length, Length) :-
    !,
    write(Out, Length).
write_body(Body, pages(Out,_,_,_,_,_), _, Length, Length) :-
    write(Out, Body).

%   write_images(Out, Options, Inked): in line, so they need no objects.

write_images(Out, Options, inked(Sheet,Paper,_)) :-
    page_images(Options, Sheet, Paper, Images),
    forall(member(image(X,Y,W,H,Image), Images),
           ( image_size(Image, Columns, Rows),
             image_flate(Image, Data),
             Below is Y+H,
             format(Out, 'q ~w 0 0 -~w ~w ~w cm~n\c
                          BI /W ~d /H ~d /CS /RGB /BPC 8 /F [/A85 /Fl] \c
                          /DP [null << /Predictor 15 /Colors 3 \c
                          /Columns ~d >>]~n\c
                          ID ~s~nEI~nQ~n',
                    [W,H,X,Below,Columns,Rows,Columns,Data]) )).

cross_references(Out, Starts, Count-Information, End) :-
    format(Out, 'xref~n0 ~d~n0000000000 65535 f ~n', [Count]),
    forall(member(Start, Starts),
           format(Out, '~|~`0t~d~10+ 00000 n ~n', [Start])),
    format(Out,
           'trailer~n<< /Size ~d /Root 1 0 R /Info ~d 0 R >>~n\c
            startxref~n~d~n%%EOF~n', [Count,Information,End]).
