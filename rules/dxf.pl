:- module(sg_dxf,
          [ write_dxf/2,                % +Out, +Drawing
            group/3,                    % +Out, +Code, +Value
            section/2,                  % +Out, +Name
            (table)/3,                  % +Out, +Name, +N
            line_type/4                 % +Out, +Name, +Text, +Runs
          ]).
:- use_module(sheet, [drawing_strokes/2]).
:- autoload(library(apply), [foldl/4, maplist/3]).
:- autoload(library(lists), [list_to_set/2, member/2]).
/** <module> DXF: strokes as polylines on layers, for CAD programs.

DXF R12 (AC1009), as text: every program reads it. One unit is one millimetre
of the sheet, the origin its lower left corner. A layer for each visibility
and role, in capitals (`HIDDEN_OUTLINE`); hidden layers have the line type
HIDDEN. Extended data of application SANGGWAN says at the start of each
straight piece which segment and edge it belongs to.
*/

%!  write_dxf(+Out, +Drawing) is det.
%
%   Write Drawing (sheet.pl) to stream Out.

write_dxf(Out, Drawing) :-
    Drawing = drawing(sheet(W,H,_), Views),
    drawing_strokes(Drawing, Strokes),
    layers(Strokes, Layers),
    header(Out, W, H),
    tables(Out, Layers),
    section(Out, 'ENTITIES'),
    forall(member(Stroke, Strokes), polyline(Out, H, Stroke)),
    forall(( member(view(_,_,Texts), Views), member(Text, Texts) ),
           text(Out, H, Text)),
    group(Out, 0, 'ENDSEC'),
    group(Out, 0, 'EOF').

header(Out, W, H) :-
    section(Out, 'HEADER'),
    group(Out, 9, '$ACADVER'),
    group(Out, 1, 'AC1009'),
    group(Out, 9, '$EXTMIN'),
    point(Out, H, 0-H),
    group(Out, 9, '$EXTMAX'),
    point(Out, H, W-0),
    group(Out, 9, '$LIMMIN'),
    place(Out, H, 0-H),
    group(Out, 9, '$LIMMAX'),
    place(Out, H, W-0),
    group(Out, 9, '$LTSCALE'),
    group(Out, 40, '1.0'),
    group(Out, 0, 'ENDSEC').

tables(Out, Layers) :-
    section(Out, 'TABLES'),
    table(Out, 'LTYPE', 2),
    line_type(Out, 'CONTINUOUS', 'Solid line', []),
    line_type(Out, 'HIDDEN', '__ __ __', [3000,-900]),
    group(Out, 0, 'ENDTAB'),
    length(Layers, N),
    table(Out, 'LAYER', N),
    forall(member(Layer, Layers), layer(Out, Layer)),
    group(Out, 0, 'ENDTAB'),
    table(Out, 'APPID', 1),
    group(Out, 0, 'APPID'),
    group(Out, 2, 'SANGGWAN'),
    group(Out, 70, 0),
    group(Out, 0, 'ENDTAB'),
    group(Out, 0, 'ENDSEC').

%!  section(+Out, +Name) is det.
%
%   Begin a section; `ENDSEC` ends it.

section(Out, Name) :-
    group(Out, 0, 'SECTION'),
    group(Out, 2, Name).

%!  table(+Out, +Name, +N) is det.
%
%   Begin a table of N entries; `ENDTAB` ends it.

table(Out, Name, N) :-
    group(Out, 0, 'TABLE'),
    group(Out, 2, Name),
    group(Out, 70, N).

%!  line_type(+Out, +Name, +Text, +Runs) is det.
%
%   An entry of the table LTYPE; Runs in thousandths, off below zero.

line_type(Out, Name, Text, Runs) :-
    group(Out, 0, 'LTYPE'),
    group(Out, 2, Name),
    group(Out, 70, 0),
    group(Out, 3, Text),
    group(Out, 72, 65),
    length(Runs, N),
    group(Out, 73, N),
    foldl(longer, Runs, 0, Length),
    real(Out, 40, Length),
    forall(member(Run, Runs), real(Out, 49, Run)).

longer(Run, Length0, Length) :-
    Length is Length0+abs(Run).

%   Every layer in use, and layer 0, which R12 wants.

layers(Strokes, [layer('0',visible,none)|Layers]) :-
    maplist(stroke_layer, Strokes, All),
    list_to_set(All, Layers).

stroke_layer(stroke(Visibility,Role,_,_,_,_,_),
             layer(Name,Visibility,Role)) :-
    layer_name(Visibility, Role, Name).

layer_name(Visibility, Role, Name) :-
    atomic_list_concat([Visibility,Role], '_', Name0),
    upcase_atom(Name0, Name).

layer(Out, layer(Name,Visibility,Role)) :-
    group(Out, 0, 'LAYER'),
    group(Out, 2, Name),
    group(Out, 70, 0),
    layer_colour(Visibility, Role, Colour),
    group(Out, 62, Colour),
    layer_line_type(Visibility, Type),
    group(Out, 6, Type).

%   7: black on white paper, white on a black screen; 1: red; 8: grey.

layer_colour(_, penetration, 1) :-
    !.
layer_colour(hidden, _, 8) :-
    !.
layer_colour(_, _, 7).

layer_line_type(hidden, 'HIDDEN').
layer_line_type(visible, 'CONTINUOUS').

/* - - - entities - - - */

polyline(Out, H, Stroke) :-
    Stroke = stroke(Visibility, Role, S, Edges, Points, Start, _),
    layer_name(Visibility, Role, Layer),
    group(Out, 0, 'POLYLINE'),
    group(Out, 8, Layer),
    group(Out, 66, 1),
    point(Out, H, 0-H),
    flags(Start, Flags),
    group(Out, 70, Flags),
    vertices(Points, Edges, vertex(Out,H,Layer,S,Start)),
    group(Out, 0, 'SEQEND'),
    group(Out, 8, Layer).

%   128: the dashes run on round the vertices; 1: closed.

flags(Start, Flags) :-
    (   Start == ring
    ->  Flags = 129
    ;   Flags = 128
    ).

%   A ring does not say its first point again.

vertices([Point,Next|Points], Edges, How) :-
    !,
    (   Edges = [E|Edges1]
    ->  vertex(How, Point, [E])
    ;   Edges1 = [],
        vertex(How, Point, [])
    ),
    vertices([Next|Points], Edges1, How).
vertices([Point], [], How) :-
    (   How = vertex(_, _, _, _, ring)
    ->  true
    ;   vertex(How, Point, [])
    ).

vertex(vertex(Out,H,Layer,S,_), Point, Edge) :-
    group(Out, 0, 'VERTEX'),
    group(Out, 8, Layer),
    point(Out, H, Point),
    (   Edge = [E]
    ->  group(Out, 1001, 'SANGGWAN'),
        group(Out, 1071, S),
        group(Out, 1071, E)
    ;   true
    ).

%   11 is where a text is fixed that does not start there, by 72.

text(Out, H, text(X,Y0,Height,Anchor,Text)) :-
    group(Out, 0, 'TEXT'),
    group(Out, 8, '0'),
    point(Out, H, X-Y0),
    real(Out, 40, Height),
    group(Out, 1, Text),
    text_anchor(Anchor, Place),
    (   Place =:= 0
    ->  true
    ;   Y is H-Y0,
        group(Out, 72, Place),
        real(Out, 11, X),
        real(Out, 21, Y),
        real(Out, 31, 0)
    ).

text_anchor(start, 0).
text_anchor(middle, 1).
text_anchor(end, 2).

point(Out, H, Point) :-
    place(Out, H, Point),
    real(Out, 30, 0).

place(Out, H, X-Y0) :-
    Y is H-Y0,
    real(Out, 10, X),
    real(Out, 20, Y).

%!  group(+Out, +Code, +Value) is det.
%
%   A group: its code on a line, its value on the next.

group(Out, Code, Value) :-
    format(Out, '~t~d~3|~n~w~n', [Code, Value]).

%   Thousandths as a decimal number.

real(Out, Code, N) :-
    format(Out, '~t~d~3|~n~3d~n', [Code, N]).
