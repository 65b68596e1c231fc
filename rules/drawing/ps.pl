:- module(sg_ps,
          [ write_ps/4                  % +Kind, +Out, +Inked, +Options
          ]).
:- use_module(ink, [dashes_option/3]).
:- use_module(drawing_shading, [page_images/4]).
:- use_module(image_text, [image_lzw_text/2]).
:- use_module('../kernel', [image_size/3]).
:- use_module(page, [write_page/6, page_layers/2, page_points/2]).
:- use_module(library(lists), [member/2]).
:- use_module(library(option), [option/3]).
/** <module> PostScript, and EPS to be put into documents.

Language level 2, true millimetres. No time and no name of a user: the same
drawing gives the same bytes. Colours are those for print; texts are drawn.

@see Adobe: PostScript Language Document Structuring Conventions 3.0, EPSF 3.0
*/

%!  write_ps(+Kind, +Out, +Inked, +Options) is det.
%
%   Write Inked (ink.pl) to stream Out; Kind is `ps`, a page as large as the
%   sheet, or `eps`. Options: title(Text), dashes(How) as for write_pdf/3.

write_ps(Kind, Out, Inked, Options) :-
    Inked = inked(Sheet, Paper, _),
    Sheet = sheet(W,H,_),
    page_images(Options, Sheet, Paper, Images),
    dashes_option(Options, fitted, How0),
    ( How0 == type -> How = fitted ; How = How0 ),
    page_points(W, Width),
    page_points(H, Height),
    heading(Kind, Heading),
    format(Out, '~w~n', [Heading]),
    whole_points(W, WholeWidth),
    whole_points(H, WholeHeight),
    format(Out, '%%BoundingBox: 0 0 ~d ~d~n', [WholeWidth,WholeHeight]),
    format(Out, '%%HiResBoundingBox: 0 0 ~w ~w~n', [Width,Height]),
    option(title(Title), Options, ''),
    ascii(Title, Ascii),
    format(Out, '%%Title: ~w~n%%Creator: Sanggwan~n', [Ascii]),
    format(Out, '%%LanguageLevel: 2~n%%Pages: 1~n%%EndComments~n', []),
    operators(Out),
    page_size(Kind, Out, Width, Height),
    format(Out, '%%Page: 1 1~ngsave~n', []),
    page_layers(Inked, Layers),
    write_page(Out, print, How, Layers, Inked,
               sg_ps:write_images(Out, Images)),
    format(Out, 'grestore~nshowpage~n%%EOF~n', []).

%   write_images(Out, Images): data in line, for the filters of level 2.

write_images(Out, Images) :-
    forall(member(image(X,Y,W,H,Image), Images),
           ( image_size(Image, Columns, Rows),
             image_lzw_text(Image, Data),
             format(Out, 'gsave ~w ~w translate ~w ~w scale~n\c
                          /DeviceRGB setcolorspace~n\c
                          << /ImageType 1 /Width ~d /Height ~d \c
                          /BitsPerComponent 8 /Decode [0 1 0 1 0 1]~n\c
                          /ImageMatrix [~d 0 0 ~d 0 0] \c
                          /DataSource currentfile /ASCII85Decode filter~n\c
                          /LZWDecode filter >> image~n~s~ngrestore~n',
                    [X,Y,W,H,Columns,Rows,Columns,Rows,Data]) )).

heading(ps, '%!PS-Adobe-3.0').
heading(eps, '%!PS-Adobe-3.0 EPSF-3.0').

whole_points(Length, Points) :-
    Points is ceiling(Length*72 rdiv 25400).

%   A comment is ASCII and one line, of 255 characters at most.

ascii(Title, Ascii) :-
    text_to_string(Title, String),
    string_length(String, Length),
    Most is min(Length, 200),
    sub_string(String, 0, Most, _, Short),
    string_codes(Short, Codes0),
    findall(Code, ( member(Code0, Codes0), ascii_code(Code0, Code) ), Codes),
    atom_codes(Ascii, Codes).

ascii_code(Code, Code) :-
    Code >= 32,
    Code < 127,
    !.
ascii_code(_, 0'?).

%   Those of a page of PDF, with `cm` for six numbers.

operators(Out) :-
    format(Out, '%%BeginProlog~n', []),
    forall(operator(Name, Body), format(Out, '/~w{~w}bind def~n',
                                        [Name,Body])),
    format(Out, '%%EndProlog~n', []).

operator(cm, '6 array astore concat').
operator(m, 'moveto').
operator(l, 'lineto').
operator(h, 'closepath').
operator('S', 'stroke').
operator(w, 'setlinewidth').
operator('J', 'setlinecap').
operator(j, 'setlinejoin').
operator(d, 'setdash').
operator('RG', 'setrgbcolor').
operator(rg, 'setrgbcolor').
operator(re, '4 2 roll moveto dup 0 exch rlineto exch 0 rlineto neg 0 exch \c
rlineto closepath').
operator(f, 'fill').
operator('BDC', 'pop pop').
operator('EMC', '').

page_size(ps, Out, Width, Height) :-
    format(Out, '%%BeginSetup~n<< /PageSize [~w ~w] >> setpagedevice~n\c
                 %%EndSetup~n', [Width,Height]).
page_size(eps, _, _, _).
