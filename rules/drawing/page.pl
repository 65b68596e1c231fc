:- module(sg_page,
          [ write_page/6,               % +Out, +Medium, +How, +Layers, +Inked,
                                        % :Images
            page_layers/2,              % +Inked, -Layers
            page_points/2,              % +Length, -Points
            text_hex/2                  % +Text, -Hex
          ]).
:- use_module('../sheet/dash', [stroke_runs/4]).
:- use_module(ink,
              [ fold_lines/4, inked_inks/2, inked_lines/3, ink_width/2,
                ink_colour/3, ink_runs/2, ink_layer/2, ink_lines/4
              ]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists), [append/3, list_to_set/2, member/2, nth0/3]).
/** <module> A page of PDF, or of PostScript that has PDF's operators.

The unit is a thousandth of a millimetre, y down, so all numbers are those of
the drawing, and exact. The operators are those of PDF 1.5: `m l h S`, `w J d`,
`RG`, and `BDC EMC` round the lines of a layer; ps.pl defines them.
*/

:- set_prolog_flag(optimise, true).

%!  write_page(+Out, +Medium, +How, +Layers, +Inked, :Images) is det.
%
%   Write the lines and texts of Inked (ink.pl) to stream Out; dashes are
%   `fitted` or `geometry`, see dashes_option/3, colours those for Medium.
%   Images, a goal, writes what comes between paper and lines.

:- meta_predicate write_page(+, +, +, +, +, 0).

write_page(Out, Medium, How, Layers, Inked, Images) :-
    Inked = inked(sheet(W,H,_), Paper, _),
    scale(Scale),
    points_text(H, HeightText),
    format(Out, '~w 0 0 -~w 0 ~w cm~n', [Scale,Scale,HeightText]),
    paper(Paper, Out, W, H),
    call(Images),
    format(Out, '1 j~n', []),
    inked_lines(drawn, Inked, Lines),
    fold_lines(line(page(Out,Medium,How,Layers)), Lines, none, State),
    layer_ended(State, Out).

%!  page_layers(+Inked, -Layers) is det.
%
%   Layers are the names of the layers that Inked uses, in painting order.

page_layers(Inked, Layers) :-
    inked_inks(Inked, Inks),
    maplist(ink_layer, Inks, Layers0),
    list_to_set(Layers0, Layers).

%!  page_points(+Length, -Points) is det.
%
%   Points, as text, are a Length in thousandths of a millimetre in points of
%   PDF and PostScript, 72 of which are an inch.

page_points(Length, Points) :-
    points_text(Length, Points).

points_text(Length, Text) :-
    N is round(Length*72000 rdiv 25400),
    format(atom(Text), '~3d', [N]).

scale('0.0028346456693').                % 72/25400

%   White paper is there already.

paper(rgb(255,255,255), _, _, _) :-
    !.
paper(RGB, Out, W, H) :-
    rgb_text(RGB, Text),
    format(Out, '~w rg 0 0 ~d ~d re f~n', [Text,W,H]).

rgb_text(rgb(R,G,B), Text) :-
    part_text(R, RText),
    part_text(G, GText),
    part_text(B, BText),
    atomic_list_concat([RText,GText,BText], ' ', Text).

part_text(0, '0') :-
    !.
part_text(255, '1') :-
    !.
part_text(N, Text) :-
    Thousandths is (2000*N+255)//510,
    format(atom(Text), '~3d', [Thousandths]).

%   The state is the ink that is set, or none.

line(Page, line(Ink,Stroke), Last, Ink) :-
    Page = page(Out, Medium, How, Layers),
    (   Ink == Last
    ->  true
    ;   layer_changed(Out, Layers, Last, Ink),
        ink_set(Out, Medium, Ink)
    ),
    dashes_set(How, Out, Ink, Stroke),
    ink_lines(How, Ink, Stroke, Lines),
    forall(member(Points, Lines), path(Out, Points)).

layer_changed(Out, Layers, Last, Ink) :-
    ink_layer(Ink, Layer),
    (   Last \== none,
        ink_layer(Last, Layer)
    ->  true
    ;   layer_ended(Last, Out),
        nth0(N, Layers, Layer)
    ->  format(Out, '/OC /L~d BDC~n', [N])
    ).

layer_ended(none, _) :-
    !.
layer_ended(_, Out) :-
    format(Out, 'EMC~n', []).

%   Round ends would fill the gaps of dashes.

ink_set(Out, Medium, Ink) :-
    ink_colour(Medium, Ink, RGB),
    rgb_text(RGB, Text),
    ink_width(Ink, Width),
    ink_runs(Ink, Runs),
    (   Runs == []
    ->  Cap = 1
    ;   Cap = 0
    ),
    format(Out, '~w RG ~d w ~d J [] 0 d~n', [Text,Width,Cap]).

dashes_set(fitted, Out, Ink, Stroke) :-
    ink_runs(Ink, Runs),
    Runs = [_|_],
    !,
    stroke_runs(Stroke, Runs, Fitted, Offset),
    atomic_list_concat(Fitted, ' ', Text),
    format(Out, '[~w] ~d d ', [Text,Offset]).
dashes_set(_, _, _, _).

path(Out, [X-Y|Points]) :-
    format(Out, '~d ~d m', [X,Y]),
    (   append(Points1, [X-Y], Points),
        Points1 = [_,_|_]
    ->  forall(member(XB-YB, Points1), format(Out, ' ~d ~d l', [XB,YB])),
        format(Out, ' h S~n', [])
    ;   forall(member(XB-YB, Points), format(Out, ' ~d ~d l', [XB,YB])),
        format(Out, ' S~n', [])
    ).

%!  text_hex(+Text, -Hex) is det.
%
%   Hex is Text as a string of PDF, in hexadecimal UTF-16.

text_hex(Text, Hex) :-
    text_to_string(Text, String),
    string_codes(String, Codes),
    foldl(code_hex, Codes, Parts, []),
    atomic_list_concat(['<FEFF'|Parts], Hex0),
    atom_concat(Hex0, '>', Hex).

code_hex(Code, [Hex|Parts], Parts) :-
    (   Code < 0x10000
    ->  format(atom(Hex), '~|~`0t~16R~4+', [Code])
    ;   High is 0xD800 + (Code-0x10000)>>10,
        Low is 0xDC00 + ((Code-0x10000) /\ 0x3FF),
        format(atom(Hex), '~|~`0t~16R~4+~`0t~16R~4+', [High,Low])
    ).
