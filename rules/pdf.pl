:- module(sg_pdf,
          [ write_pdf/3                 % +Out, +Inked, +Options
          ]).
:- use_module(ink, [dashes_option/3]).
:- use_module(page, [write_page/5, page_layers/2, page_points/2, text_hex/2]).
:- autoload(library(apply), [foldl/4]).
:- autoload(library(lists), [member/2, nth0/3]).
:- autoload(library(option), [option/3]).
/** <module> PDF: a page of lines in true millimetres.

PDF 1.5, one page as large as the sheet, nothing compressed, no time and no
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
    dashes_option(Options, fitted, How0),
    page_how(How0, How),
    page_layers(Inked, Layers),
    with_output_to(string(Content),
                   ( current_output(Page),
                     write_page(Page, print, How, Layers, Inked) )),
    findall(Body, object(Layers, Inked, Content, Options, Body), Bodies),
    Header = "%PDF-1.5\n",
    string_length(Header, Start),
    write(Out, Header),
    foldl(write_object(Out), Bodies, 1-Start, Count-End),
    cross_references(Out, Bodies, Start, Count, End).

page_how(type, fitted) :-
    !.
page_how(How, How).

%   object(Layers, Inked, Content, Options, Body): the objects in order: 1
%   catalogue, 2 pages, 3 page, 4 content, 5 information, 6 on the layers.

object(Layers, _, _, _, Body) :-
    length(Layers, N),
    findall(Reference, layer_reference(N, Reference), References),
    atomic_list_concat(References, ' ', All),
    format(string(Body),
           '<< /Type /Catalog /Pages 2 0 R /OCProperties << /OCGs [~w] \c
            /D << /Order [~w] >> >> >>', [All,All]).
object(_, _, _, _, "<< /Type /Pages /Kids [3 0 R] /Count 1 >>").
object(Layers, inked(sheet(W,H,_),_,_), _, _, Body) :-
    page_points(W, Width),
    page_points(H, Height),
    findall(Text,
            ( nth0(N, Layers, _),
              Number is N+6,
              format(atom(Text), '/L~d ~d 0 R', [N,Number])
            ),
            Texts),
    atomic_list_concat(Texts, ' ', Properties),
    format(string(Body),
           '<< /Type /Page /Parent 2 0 R /MediaBox [0 0 ~w ~w] \c
            /Contents 4 0 R~n/Resources << /Properties << ~w >> >> >>',
           [Width,Height,Properties]).
object(_, _, Content, _, Body) :-
    string_length(Content, Length),
    format(string(Body), '<< /Length ~d >>~nstream~n~wendstream',
           [Length,Content]).
object(_, _, _, Options, Body) :-
    option(title(Title), Options, ''),
    text_hex(Title, Hex),
    format(string(Body), '<< /Title ~w /Producer (Sanggwan) >>', [Hex]).
object(Layers, _, _, _, Body) :-
    member(Layer, Layers),
    format(string(Body), '<< /Type /OCG /Name (~w) >>', [Layer]).

layer_reference(N, Reference) :-
    between(1, N, I),
    Number is I+5,
    format(atom(Reference), '~d 0 R', [Number]).

write_object(Out, Body, N0-At0, N-At) :-
    object_text(N0, Body, Text),
    write(Out, Text),
    string_length(Text, Length),
    N is N0+1,
    At is At0+Length.

object_text(N, Body, Text) :-
    format(string(Text), '~d 0 obj~n~w~nendobj~n', [N,Body]).

%   Where each object begins, in bytes; all of the file is ASCII.

cross_references(Out, Bodies, Start, Count, End) :-
    format(Out, 'xref~n0 ~d~n0000000000 65535 f ~n', [Count]),
    foldl(cross_reference(Out), Bodies, 1-Start, _),
    format(Out,
           'trailer~n<< /Size ~d /Root 1 0 R /Info 5 0 R >>~n\c
            startxref~n~d~n%%EOF~n', [Count,End]).

cross_reference(Out, Body, N0-At0, N-At) :-
    format(Out, '~|~`0t~d~10+ 00000 n ~n', [At0]),
    object_text(N0, Body, Text),
    string_length(Text, Length),
    N is N0+1,
    At is At0+Length.
