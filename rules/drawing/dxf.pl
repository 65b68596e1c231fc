:- module(sg_dxf,
          [ write_dxf/3,                % +Out, +Inked, +Options
            group/3,                    % +Out, +Code, +Value
            section/2,                  % +Out, +Name
            (table)/3,                  % +Out, +Name, +N
            application_table/1,        % +Out
            line_type/4                 % +Out, +Name, +Text, +Runs
          ]).
:- use_module(dxf_arc, [arcs_found/4, ring_circle/2]).
:- use_module(dxf_colour, [dxf_colour/2]).
:- use_module(ink,
              [ inked_inks/2, line_of/2, inked_lines/3, inked_texts/2,
                dashes_option/3, ink_colour/3, ink_layer/2, ink_type/2,
                ink_runs/2, ink_lines/4
              ]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists), [member/2, memberchk/2, nth1/3]).
:- use_module(library(option), [option/3]).
/** <module> DXF: strokes as polylines on layers, for CAD programs.

DXF R12 (AC1009), as text: every program reads it. A straight line is a LINE, a
text a TEXT, also one that stands aslant; what has bends is a POLYLINE, a circle
of a true pattern a CIRCLE, and arcs of such a one are arcs of its polyline.
One unit is one millimetre of the sheet, the origin its lower left corner. A
layer for each visibility and role, in capitals (`HIDDEN_OUTLINE`), with its
colour and line type, by the style (style.pl); a line of another look says so
itself. Extended data of application SANGGWAN says at the start of each
straight piece which segment and edge it belongs to.
*/

%!  write_dxf(+Out, +Inked, +Options) is det.
%
%   Write Inked (ink.pl) to stream Out. Options: dashes(How), line types as is
%   usual, or `geometry`: a polyline for each dash, and drawn letters in place
%   of texts; smooth(Segments): outlines of these stand for smooth ones, so that
%   a circle is a CIRCLE, and arcs in a polyline are arcs (dxf_arc.pl); of
%   S-Edges in place of S these edges alone.

write_dxf(Out, Inked, Options) :-
    Inked = inked(sheet(W,H,_), _, _),
    dashes_option(Options, type, How),
    written(How, Inked, Lines, Texts),
    inked_inks(Inked, Inks),
    looks(How, Inks, 1, Looks, Types),
    findall(Layer, first_look(Looks, Layer), Layers),
    header(Out, W, H),
    tables(Out, Types, Layers),
    section(Out, 'ENTITIES'),
    option(smooth(Smooth), Options, []),
    DXF = dxf(Out, H, Looks, Layers, Smooth),
    forall(line_of(Lines, Line), line(DXF, How, Line)),
    forall(member(Text, Texts), text(DXF, Text)),
    group(Out, 0, 'ENDSEC'),
    group(Out, 0, 'EOF').

written(geometry, Inked, Lines, []) :-
    !,
    inked_lines(drawn, Inked, Lines).
written(_, Inked, Lines, Texts) :-
    inked_lines(left, Inked, Lines),
    inked_texts(Inked, Texts).

%   looks(How, Inks, N, Looks, Types): Looks are Ink-look(Layer,Colour,Type),
%   Types the line types they use, type(Name,Runs); N counts those that have no
%   name of their own.

looks(_, [], _, [], []).
looks(How, [Ink|Inks], N0, [Ink-look(Layer,Colour,Type)|Looks], Types) :-
    ink_layer(Ink, Layer0),
    upcase_atom(Layer0, Layer),         % R12 knows no other letters
    ink_colour(screen, Ink, RGB),
    dxf_colour(RGB, Colour),
    ink_runs(Ink, Runs),
    (   ( How == geometry ; Runs == [] )
    ->  Type = 'CONTINUOUS',
        N = N0,
        Types = Types1
    ;   line_type_name(Ink, Runs, N0, N, Type),
        Types = [type(Type,Runs)|Types1]
    ),
    looks(How, Inks, N, Looks, Types1).

%   `dashed` is longer where the line is wider, so its name has the length.

line_type_name(Ink, Runs, N0, N, Name) :-
    ink_type(Ink, Type),
    (   Type == hidden
    ->  Name = 'HIDDEN',
        N = N0
    ;   atom(Type)
    ->  Runs = [Run|_],
        usual_name(Type, Usual),
        atomic_list_concat([Usual,Run], '_', Name),
        N = N0
    ;   atom_concat('DASHES_', N0, Name),
        N is N0+1
    ).

%   usual_name(Type, Name): what CAD systems call a line type of ISO 128.

usual_name(chain, Name) =>
    Name = 'CENTER'.
usual_name(chain_double, Name) =>
    Name = 'PHANTOM'.
usual_name(Type, Name) =>
    upcase_atom(Type, Name).

%   A layer looks as the first line on it does.

first_look(Looks, layer(Layer,Colour,Type)) :-
    nth1(N, Looks, _-look(Layer,Colour,Type)),
    \+ ( nth1(Before, Looks, _-look(Layer,_,_)),
         Before < N
       ).

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
    unit(Out),
    group(Out, 9, '$LTSCALE'),
    group(Out, 40, '1.0'),
    group(Out, 0, 'ENDSEC').

%   Millimetres. These two are younger than R12, which has no unit, but they are
%   what programs of today look for.

unit(Out) :-
    group(Out, 9, '$INSUNITS'),
    group(Out, 70, 4),
    group(Out, 9, '$MEASUREMENT'),
    group(Out, 70, 1).

tables(Out, Types0, Layers0) :-
    sort(Types0, Types),
    length(Types, TypeCount),
    AllTypes is TypeCount+1,
    (   memberchk(layer('0',_,_), Layers0)
    ->  Layers = Layers0
    ;   Layers = [layer('0',7,'CONTINUOUS')|Layers0]
    ),
    section(Out, 'TABLES'),
    table(Out, 'LTYPE', AllTypes),
    line_type(Out, 'CONTINUOUS', 'Solid line', []),
    forall(member(type(Name,Runs), Types), dashed_type(Out, Name, Runs)),
    group(Out, 0, 'ENDTAB'),
    length(Layers, N),
    table(Out, 'LAYER', N),
    forall(member(Layer, Layers), layer(Out, Layer)),
    group(Out, 0, 'ENDTAB'),
    application_table(Out),
    group(Out, 0, 'ENDSEC').

%!  application_table(+Out) is det.
%
%   The table of whose data entities carry: Sanggwan's.

application_table(Out) :-
    table(Out, 'APPID', 1),
    group(Out, 0, 'APPID'),
    group(Out, 2, 'SANGGWAN'),
    group(Out, 70, 0),
    group(Out, 0, 'ENDTAB').

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

%   Runs of an ink; what is off is below zero.

dashed_type(Out, Name, Runs0) :-
    signed(Runs0, Runs),
    runs_text(Runs0, Text),
    line_type(Out, Name, Text, Runs).

signed([], []).
signed([On,Off0|Runs0], [On,Off|Runs]) :-
    Off is -Off0,
    signed(Runs0, Runs).

runs_text([_,_], '__ __ __') :-
    !.
runs_text(_, '____ . ____').

layer(Out, layer(Name,Colour,Type)) :-
    group(Out, 0, 'LAYER'),
    group(Out, 2, Name),
    group(Out, 70, 0),
    group(Out, 62, Colour),
    group(Out, 6, Type).

/* - - - entities - - -

dxf(Out, H, Looks, Layers, Smooth): the stream, the height of the sheet, what
inks look like and what layers do, and which segments are smooth.
*/

line(DXF, How, line(Ink,Stroke)) :-
    ink_lines(How, Ink, Stroke, Lines),
    (   Lines = [Points],
        Stroke = stroke(_, _, _, _, Points, _, _)
    ->  polyline(DXF, Ink, Stroke)
    ;   forall(member(Line, Lines), dash(DXF, Ink, Stroke, Line))
    ).

dash(DXF, Ink, stroke(Visibility,Role,S,_,_,_,_), Points) :-
    polyline(DXF, Ink, stroke(Visibility,Role,S,[],Points,joint,joint)).

polyline(DXF, Ink, stroke(_,_,S,Edges,[A,B],Start,_)) :-
    Start \== ring,
    !,
    DXF = dxf(Out, H, _, _, _),
    group(Out, 0, 'LINE'),
    look(DXF, Ink, _),
    point(Out, H, A),
    end_point(Out, H, B),
    edge_data(Out, S, Edges).
polyline(DXF, Ink, stroke(_,_,S,Edges,Points,ring,_)) :-
    DXF = dxf(Out, H, _, _, Smooth),
    memberchk(S, Smooth),
    ring_circle(Points, circle(X-Y, R)),
    !,
    group(Out, 0, 'CIRCLE'),
    look(DXF, Ink, _),
    point(Out, H, X-Y),
    real(Out, 40, R),
    edge_data(Out, S, Edges).
polyline(DXF, Ink, stroke(_,_,S,Edges,Points,Start,_)) :-
    DXF = dxf(Out, H, _, _, Smooth),
    group(Out, 0, 'POLYLINE'),
    look(DXF, Ink, Layer),
    group(Out, 66, 1),
    point(Out, H, 0-H),
    flags(Start, Flags),
    group(Out, 70, Flags),
    How = vertex(Out, H, Layer, S, Start),
    (   smooth_edges(S, Smooth, Among)
    ->  arcs_found(Points, Edges, Among, Corners),
        forall(member(Corner, Corners), arc_vertex(How, Corner))
    ;   vertices(Points, Edges, How)
    ),
    group(Out, 0, 'SEQEND'),
    group(Out, 8, Layer).

smooth_edges(S, Smooth, Among) :-
    (   memberchk(S, Smooth)
    ->  Among = all
    ;   memberchk(S-Among, Smooth)
    ).

%   On its layer, and what of its look is not as the layer's.

look(dxf(Out,_,Looks,Layers,_), Ink, Layer) :-
    memberchk(Ink-look(Layer,Colour,Type), Looks),
    memberchk(layer(Layer,LayerColour,LayerType), Layers),
    group(Out, 8, Layer),
    (   Colour == LayerColour
    ->  true
    ;   group(Out, 62, Colour)
    ),
    (   Type == LayerType
    ->  true
    ;   group(Out, 6, Type)
    ).

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
    vertex_point(Out, H, Layer, Point),
    edge_data(Out, S, Edge).

vertex_point(Out, H, Layer, Point) :-
    group(Out, 0, 'VERTEX'),
    group(Out, 8, Layer),
    point(Out, H, Point).

arc_vertex(vertex(Out,H,Layer,S,_), corner(Point, Edge, Bulge)) :-
    vertex_point(Out, H, Layer, Point),
    (   Bulge =:= 0
    ->  true
    ;   format(Out, ' 42~n~9f~n', [Bulge])
    ),
    edge_data(Out, S, Edge).
arc_vertex(How, end(Point)) :-
    vertices([Point], [], How).

edge_data(Out, S, Edges) :-
    (   Edges = [E|_]
    ->  group(Out, 1001, 'SANGGWAN'),
        group(Out, 1071, S),
        group(Out, 1071, E)
    ;   true
    ).

end_point(Out, H, X-Y0) :-
    Y is H-Y0,
    real(Out, 11, X),
    real(Out, 21, Y),
    real(Out, 31, 0).

%   11 is where a text is fixed that does not start there, by 72; 50 is how it
%   is turned.

text(DXF, text(Ink,Text)) :-
    turned_text(DXF, Ink, 0, Text).
text(DXF, word(Ink,Angle,Text)) :-
    turned_text(DXF, Ink, Angle, Text).

turned_text(DXF, Ink, Angle, text(X,Y,Height,Anchor,Text)) :-
    DXF = dxf(Out, H, _, _, _),
    group(Out, 0, 'TEXT'),
    look(DXF, Ink, _),
    point(Out, H, X-Y),
    real(Out, 40, Height),
    dxf_text(Text, Written),
    group(Out, 1, Written),
    (   Angle =:= 0
    ->  true
    ;   real(Out, 50, Angle)
    ),
    text_anchor(Anchor, Place),
    (   Place =:= 0
    ->  true
    ;   group(Out, 72, Place),
        end_point(Out, H, X-Y)
    ).

%   R12 is ASCII: other characters as \U+XXXX, of UTF-16, and so are what would
%   begin such a one or, twice, something else (%%d is a degree). A caret or a
%   line's end never.

dxf_text(Text, Written) :-
    string_codes(Text, Codes),
    foldl(dxf_code, Codes, Parts, []),
    atomic_list_concat(Parts, Written).

dxf_code(Code, Parts, Rest) :-
    (   ( Code < 32 ; Code =:= 0'^ )
    ->  Parts = [' '|Rest]
    ;   Code < 127,
        \+ memberchk(Code, [0'\\,0'%])
    ->  char_code(Part, Code),
        Parts = [Part|Rest]
    ;   Code < 0x10000
    ->  unit_text(Code, Part),
        Parts = [Part|Rest]
    ;   High is 0xD800 + ((Code-0x10000) >> 10),
        Low is 0xDC00 + ((Code-0x10000) /\ 0x3FF),
        maplist(unit_text, [High,Low], [First,Second]),
        Parts = [First,Second|Rest]
    ).

unit_text(Unit, Text) :-
    format(atom(Text), '\\U+~|~`0t~16R~4+', [Unit]).

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
