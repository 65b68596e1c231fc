:- module(sg_drawing,
          [ write_drawing/2,            % +File, +Options
            write_drawing_stream/3,     % +Format, +Out, +Options
            drawing_format/2            % ?Format, ?Type
          ]).
:- use_module(dot_drawing, [write_png/2]).
:- use_module(dxf, [write_dxf/2]).
:- use_module(hpgl, [write_hpgl/2]).
:- use_module(output, [writing/3]).
:- use_module(sheet, [sheet_drawing/3]).
:- use_module(svg, [write_svg/3]).
:- autoload(library(apply), [foldl/4, maplist/3]).
:- autoload(library(error), [domain_error/2]).
:- autoload(library(http/json), [json_write/3]).
:- autoload(library(lists), [member/2]).
:- autoload(library(option), [option/3]).
/** <module> Drawings: the picture of the current world, written to files.

What drawn/7 and screen/5 hold (hidden_lines.pl fills them) is laid on a sheet
(sheet.pl), chained into strokes (stroke.pl) and written. Same picture, same
bytes: no times, no names of users, no hash order.
*/

%!  drawing_format(?Format, ?Type) is nondet.
%
%   True when drawings can be written as Format, which is also the ending of
%   such files; Type is `text` or `binary`.

drawing_format(svg, text).
drawing_format(png, binary).
drawing_format(json, text).
drawing_format(dxf, text).
drawing_format(hpgl, text).

%!  write_drawing(+File, +Options) is det.
%
%   Write the drawing of the current world to File, in the format that its
%   ending names, see drawing_format/2. Options:
%
%     - size(Size): `WxH`, or W-H, in millimetres, default 210x148; for PNG in
%       dots, default 640x400
%     - margin(M), scale(S): see sheet_drawing/3
%     - hidden(H): `dashed` (default; dotted in PNG), `removed`, or `shown`:
%       not dashed, in SVG and PNG
%     - pattern(P): dots on and off of hidden lines in PNG: N, or a list
%     - title(Text): in SVG and JSON
%     - drawing(Drawing): this one (sheet.pl), not the picture of the world;
%       for PNG with dots(N) dots to a millimetre, default 6
%
%   A world without a picture gives a valid, empty drawing.
%
%   @error domain_error(drawing_format, Ending), and those of writing/3 and
%   sheet_drawing/3.

write_drawing(File, Options) :-
    file_name_extension(_, Ending, File),
    downcase_atom(Ending, Format),
    format_type(Format, Type),
    writing(File, Type, drawing_written(Format, Options)).

drawing_written(Format, Options, Out) :-
    write_drawing_stream(Format, Out, Options).

format_type(Format, Type) :-
    (   drawing_format(Format, Type0)
    ->  Type = Type0
    ;   domain_error(drawing_format, Format)
    ).

%!  write_drawing_stream(+Format, +Out, +Options) is det.
%
%   Like write_drawing/2, to stream Out. For a binary format Out may be a text
%   stream: it is set to bytes while this writes.

write_drawing_stream(Format, Out, Options) :-
    format_type(Format, _),
    write_format(Format, Out, Options).

write_format(png, Out, Options) :-
    !,
    write_png(Out, Options).
write_format(Format, Out, Options) :-
    sheet_drawing(210-148, Options, Drawing),
    write_lines(Format, Out, Drawing, Options).

write_lines(svg, Out, Drawing, Options) :-
    write_svg(Out, Drawing, Options).
write_lines(json, Out, Drawing, Options) :-
    write_json(Out, Drawing, Options).
write_lines(dxf, Out, Drawing, _) :-
    write_dxf(Out, Drawing).
write_lines(hpgl, Out, Drawing, _) :-
    write_hpgl(Out, Drawing).

%   The same lines as the SVG has, for programs; one to a line of text.

write_json(Out, Drawing, Options) :-
    Drawing = drawing(sheet(W,H,Scale), _),
    maplist(thousand, [W,H], [Width,Height]),
    option(title(Title), Options, ''),
    text_to_string(Title, TitleString),
    format(Out, '{ "title": ', []),
    json_on_a_line(Out, TitleString),
    format(Out, ',~n  "unit": "mm", "width": ~w, "height": ~w, ',
           [Width, Height]),
    format(Out, '"scale": ~w,~n', [Scale]),
    findall(Json, drawing_json(line, Drawing, Json), Lines),
    findall(Json, drawing_json(text, Drawing, Json), Texts),
    format(Out, '  "lines": [', []),
    foldl(write_json_line(Out), Lines, "\n    ", _),
    format(Out, '~n  ]', []),
    (   Texts == []
    ->  true
    ;   format(Out, ',~n  "texts": [', []),
        foldl(write_json_line(Out), Texts, "\n    ", _),
        format(Out, '~n  ]', [])
    ),
    format(Out, '~n}~n', []).

%   Of several views each line and text has its own.

drawing_json(What, drawing(_,Views), json(Members)) :-
    member(view(Name,Strokes,Texts), Views),
    (   Name == ''
    ->  Members = Own
    ;   Members = [view=Name|Own]
    ),
    view_json(What, Strokes, Texts, json(Own)).

view_json(line, Strokes, _, Json) :-
    member(Stroke, Strokes),
    stroke_json(Stroke, Json).
view_json(text, _, Texts, json([ text=Text, at=[X,Y], height=Height,
                                 anchor=Anchor ])) :-
    member(text(X0,Y0,Height0,Anchor,Text), Texts),
    maplist(thousand, [X0,Y0,Height0], [X,Y,Height]).

write_json_line(Out, Json, Before, ",\n    ") :-
    write(Out, Before),
    json_on_a_line(Out, Json).

json_on_a_line(Out, Json) :-
    json_write(Out, Json, [width(1 000 000 000)]).

stroke_json(stroke(Visibility,Role,S,Edges,Points,Start,End),
            json([ visibility=Visibility, role=Role, segment=S, edges=Edges,
                   points=Pairs, start=Start, end=End
                 ])) :-
    maplist(point_pair, Points, Pairs).

point_pair(X0-Y0, [X,Y]) :-
    thousand(X0, X),
    thousand(Y0, Y).

%   As a float it prints as short as reads back: 0.1, not 0.10000000000000001.

thousand(N, X) :-
    X is N/1000.0.
