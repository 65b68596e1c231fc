:- module(sg_drawing_json,
          [ write_json/3                % +Out, +Inked, +Options
          ]).
:- use_module(ink,
              [ fold_lines/4, inked_inks/2, inked_texts/2, ink_width/2,
                ink_colour/3, ink_runs/2, ink_pen/2, ink_layer/2
              ]).
:- use_module('../plain', [plain_json/2]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(http/json), [json_write/3]).
:- use_module('../sheet/dash', [plain_end/2]).
:- use_module(library(lists), [member/2, nth0/3]).
:- use_module(library(option), [option/3]).
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
    list_head(Out, styles),
    foldl(write_member(Out), Styles, "\n    ", _),
    list_end(Out),
    format(Out, ',~n', []),
    list_head(Out, lines),
    foldl(view_lines(Out, Inks), Views, "\n    ", _),
    list_end(Out),
    write_texts(Out, Inked, Inks),
    format(Out, '~n}~n', []).

list_head(Out, Name) :-
    format(Out, '  "~w": [', [Name]).

list_end(Out) :-
    format(Out, '~n  ]', []).

write_member(Out, Json, Before, ",\n    ") :-
    format(Out, '~w ', [Before]),
    json_on_a_line(Out, Json).

json_on_a_line(Out, Json) :-
    plain_json(Out, json_write(current_output, Json, [width(1 000 000 000)])).

write_texts(Out, Inked, Inks) :-
    inked_texts(Inked, Texts),
    (   Texts == []
    ->  true
    ;   Inked = inked(_, _, Views),
        findall(Json, written_json(Views, Inks, Json), Jsons),
        format(Out, ',~n', []),
        list_head(Out, texts),
        foldl(write_member(Out), Jsons, "\n    ", _),
        list_end(Out)
    ).

%   Of several views each line and text has its own. The lines are most of the
%   text: they are written without a term for it. Their words are our own and
%   need no escapes.

view_lines(Out, Inks, view(Name,Lines,_), Before0, Before) :-
    view_member(Name, View),
    fold_lines(line_written(Out, Inks, View), Lines, Before0, Before).

view_member('', "") :-
    !.
view_member(Name, View) :-
    with_output_to(string(Text),
                   ( current_output(Out), json_on_a_line(Out, Name) )),
    format(string(View), '"view":~s, ', [Text]).

line_written(Out, Inks, View, line(Ink,Stroke), Before, ",\n    ") :-
    Stroke = stroke(Visibility,Role,S,Edges,Points,Start,End0),
    plain_end(End0, End),
    once(nth0(Style, Inks, Ink)),
    format(Out, '~w {~w"visibility":"~w", "role":"~w", "segment":~d, \c
                 "edges": [', [Before,View,Visibility,Role,S]),
    foldl(edge_written(Out), Edges, '', _),
    format(Out, '], "points": [', []),
    foldl(point_written(Out), Points, '', _),
    format(Out, '], "start":"~w", "end":"~w", "style":~d}',
           [Start,End,Style]).

edge_written(Out, E, Before, ', ') :-
    format(Out, '~w~d', [Before,E]).

point_written(Out, X0-Y0, Before, ', ') :-
    thousand(X0, X),
    thousand(Y0, Y),
    format(Out, '~w[~w, ~w]', [Before,X,Y]).

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
