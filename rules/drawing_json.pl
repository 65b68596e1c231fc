:- module(sg_drawing_json,
          [ write_json/3                % +Out, +Inked, +Options
          ]).
:- use_module(ink,
              [ inked_inks/2, inked_texts/2, ink_width/2, ink_colour/3,
                ink_runs/2, ink_pen/2, ink_layer/2
              ]).
:- autoload(library(apply), [foldl/4, maplist/3]).
:- autoload(library(http/json), [json_write/3]).
:- autoload(library(lists), [member/2, nth0/3]).
:- autoload(library(option), [option/3]).
/** <module> JSON: the same lines as the SVG has, for programs.

One line of the drawing to a line of text. Numbers are millimetres. Each line
has the number of its style, counted from 0 in `styles`.
*/

%!  write_json(+Out, +Inked, +Options) is det.
%
%   Write Inked (ink.pl) to stream Out. Options: title(Text).

write_json(Out, Inked, Options) :-
    Inked = inked(sheet(W,H,Scale), _, Views),
    inked_inks(Inked, Inks),
    maplist(thousand, [W,H], [Width,Height]),
    option(title(Title), Options, ''),
    text_to_string(Title, TitleString),
    format(Out, '{ "title": ', []),
    json_on_a_line(Out, TitleString),
    format(Out, ',~n  "unit": "mm", "width": ~w, "height": ~w, ',
           [Width, Height]),
    format(Out, '"scale": ~w,~n', [Scale]),
    maplist(ink_json, Inks, Styles),
    findall(Json, view_json(Views, Inks, Json), Lines),
    write_list(Out, styles, Styles),
    format(Out, ',~n', []),
    write_list(Out, lines, Lines),
    write_texts(Out, Inked, Inks),
    format(Out, '~n}~n', []).

write_list(Out, Name, List) :-
    format(Out, '  "~w": [', [Name]),
    foldl(write_member(Out), List, "\n    ", _),
    format(Out, '~n  ]', []).

write_member(Out, Json, Before, ",\n    ") :-
    write(Out, Before),
    json_on_a_line(Out, Json).

json_on_a_line(Out, Json) :-
    json_write(Out, Json, [width(1 000 000 000)]).

write_texts(Out, Inked, Inks) :-
    inked_texts(Inked, Texts),
    (   Texts == []
    ->  true
    ;   Inked = inked(_, _, Views),
        findall(Json, written_json(Views, Inks, Json), Jsons),
        format(Out, ',~n', []),
        write_list(Out, texts, Jsons)
    ).

%   Of several views each line and text has its own.

view_json(Views, Inks, json(Members)) :-
    member(view(Name,Lines,_), Views),
    member(line(Ink,Stroke), Lines),
    nth0(Style, Inks, Ink),
    stroke_json(Stroke, Style, Own),
    in_view(Name, Own, Members).

written_json(Views, Inks, json(Members)) :-
    member(view(Name,_,Texts), Views),
    member(text(Ink,text(X0,Y0,Height0,Anchor,Text)), Texts),
    nth0(Style, Inks, Ink),
    maplist(thousand, [X0,Y0,Height0], [X,Y,Height]),
    in_view(Name,
            [ text=Text, at=[X,Y], height=Height, anchor=Anchor,
              style=Style ],
            Members).

in_view(Name, Own, Members) :-
    (   Name == ''
    ->  Members = Own
    ;   Members = [view=Name|Own]
    ).

stroke_json(stroke(Visibility,Role,S,Edges,Points,Start,End), Style,
            [ visibility=Visibility, role=Role, segment=S, edges=Edges,
              points=Pairs, start=Start, end=End, style=Style
            ]) :-
    maplist(point_pair, Points, Pairs).

point_pair(X0-Y0, [X,Y]) :-
    thousand(X0, X),
    thousand(Y0, Y).

ink_json(Ink, json([ width=Width, colour=Hex, dashes=Runs, pen=Pen,
                     layer=Layer ])) :-
    ink_width(Ink, Width0),
    thousand(Width0, Width),
    ink_colour(screen, Ink, rgb(R,G,B)),
    format(string(Hex), '#~|~`0t~16r~2+~`0t~16r~2+~`0t~16r~2+', [R,G,B]),
    ink_runs(Ink, Runs0),
    maplist(thousand, Runs0, Runs),
    ink_pen(Ink, Pen),
    ink_layer(Ink, Layer).

%   As a float it prints as short as reads back: 0.1, not 0.10000000000000001.

thousand(N, X) :-
    X is N/1000.0.
