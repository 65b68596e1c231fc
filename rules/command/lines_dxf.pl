:- module(sg_lines_dxf,
          [ write_lines_dxf/2           % +Out, +Chains
          ]).
:- use_module('../penetration/chain', [chain_points/2, chain_vertices/3]).
:- use_module('../drawing/dxf',
              [ application_table/1, group/3, line_type/4, section/2,
                (table)/3
              ]).
:- use_module('../store', [line/9]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/3, maplist/4]).
:- use_module(library(lists), [append/3, last/2, max_list/2, member/2,
                               min_list/2, nth1/3]).

/** <module> Penetration lines as DXF: polylines in space, for CAD programs.

DXF R12 (AC1009), as text. One unit is one unit of the model; R12 cannot say
which that is. Each chain is a 3D POLYLINE on a layer that says what it is:

    PENETRATION_CLOSED      a loop
    PENETRATION_OPEN        from a free end to a free end
    PENETRATION_BRANCH      one that begins or ends where others meet it
    PENETRATION_POINT       a chain of one point, as a POINT

Extended data of application SANGGWAN: at a chain its number and its two
segments, at each point its vertex in either.
*/

%!  write_lines_dxf(+Out, +Chains:list) is det.
%
%   Write Chains, as chains/1 of chain.pl has them, to stream Out.

write_lines_dxf(Out, Chains) :-
    maplist(chain_drawn, Chains, Drawn),
    header(Out, Drawn),
    tables(Out, Drawn),
    section(Out, 'ENTITIES'),
    forall(nth1(C, Drawn, Chain), entity(Out, C, Chain)),
    group(Out, 0, 'ENDSEC'),
    group(Out, 0, 'EOF').

%   drawn(Layer, S1, S2, Points, V1s, V2s), the first point of a loop once.

chain_drawn(chain(S1, S2, Kind, Lines),
            drawn(Layer, S1, S2, Points, V1s, V2s)) :-
    chain_points(Lines, Points0),
    chain_vertices(Lines, S1, V1s0),
    chain_vertices(Lines, S2, V2s0),
    maplist(once_round(Kind), [Points0,V1s0,V2s0], [Points,V1s,V2s]),
    layer_of(Kind, S1, S2, V1s0, Layer).

once_round(closed, All, Round) :-
    !,
    append(Round, [_], All),
    !.
once_round(_, All, All).

layer_of(closed, _, _, _, 'PENETRATION_CLOSED').
layer_of(point, _, _, _, 'PENETRATION_POINT').
layer_of(open, S1, S2, Vs, Layer) :-
    Vs = [First|_],
    last(Vs, Last),
    (   member(V, [First,Last]),
        branches(S1, S2, V)
    ->  Layer = 'PENETRATION_BRANCH'
    ;   Layer = 'PENETRATION_OPEN'
    ).

%   branches(+S1, +S2, +V): three or more pieces of S1 and S2 end in V of S1.

branches(S1, S2, V) :-
    aggregate_all(count,
                  ( line(_, S1, _, V, _, S2, _, _, _)
                  ; line(_, S1, _, _, V, S2, _, _, _)
                  ),
                  N),
    N > 2.

header(Out, Drawn) :-
    section(Out, 'HEADER'),
    group(Out, 9, '$ACADVER'),
    group(Out, 1, 'AC1009'),
    findall(Point, ( member(drawn(_,_,_,Points,_,_), Drawn),
                     member(Point, Points) ), All),
    extents(All, Low, High),
    group(Out, 9, '$EXTMIN'),
    place(Out, Low),
    group(Out, 9, '$EXTMAX'),
    place(Out, High),
    group(Out, 0, 'ENDSEC').

extents([], point(0.0,0.0,0.0), point(0.0,0.0,0.0)) :-
    !.
extents(Points, point(X1,Y1,Z1), point(X2,Y2,Z2)) :-
    maplist(extent(Points), [1,2,3], [X1,Y1,Z1], [X2,Y2,Z2]).

extent(Points, Axis, Low, High) :-
    findall(X, ( member(Point, Points), arg(Axis, Point, X) ), Xs),
    min_list(Xs, Low),
    max_list(Xs, High).

%   Every layer in use, and layer 0, which R12 wants.

tables(Out, Drawn) :-
    section(Out, 'TABLES'),
    table(Out, 'LTYPE', 1),
    line_type(Out, 'CONTINUOUS', 'Solid line', []),
    group(Out, 0, 'ENDTAB'),
    findall(Layer, member(drawn(Layer,_,_,_,_,_), Drawn), Layers0),
    sort(['0'|Layers0], Layers),
    length(Layers, N),
    table(Out, 'LAYER', N),
    forall(member(Layer, Layers), layer(Out, Layer)),
    group(Out, 0, 'ENDTAB'),
    application_table(Out),
    group(Out, 0, 'ENDSEC').

layer(Out, Layer) :-
    group(Out, 0, 'LAYER'),
    group(Out, 2, Layer),
    group(Out, 70, 0),
    layer_colour(Layer, Colour),
    group(Out, 62, Colour),
    group(Out, 6, 'CONTINUOUS').

%   1 red, 5 blue, 30 orange, 6 magenta; 7 black on white paper.

layer_colour('PENETRATION_CLOSED', 1).
layer_colour('PENETRATION_OPEN', 5).
layer_colour('PENETRATION_BRANCH', 30).
layer_colour('PENETRATION_POINT', 6).
layer_colour('0', 7).

/* - - - entities - - - */

entity(Out, C, drawn('PENETRATION_POINT', S1, S2, [Point|_], _, _)) :-
    !,
    group(Out, 0, 'POINT'),
    group(Out, 8, 'PENETRATION_POINT'),
    place(Out, Point),
    extended(Out, [C,S1,S2]).
entity(Out, C, drawn(Layer, S1, S2, Points, V1s, V2s)) :-
    group(Out, 0, 'POLYLINE'),
    group(Out, 8, Layer),
    group(Out, 66, 1),
    place(Out, point(0.0,0.0,0.0)),
    flags(Layer, Flags),
    group(Out, 70, Flags),
    extended(Out, [C,S1,S2]),
    maplist(vertex(Out, Layer), Points, V1s, V2s),
    group(Out, 0, 'SEQEND'),
    group(Out, 8, Layer).

%   8: in space; 1: closed.

flags('PENETRATION_CLOSED', 9) :-
    !.
flags(_, 8).

vertex(Out, Layer, Point, V1, V2) :-
    group(Out, 0, 'VERTEX'),
    group(Out, 8, Layer),
    place(Out, Point),
    group(Out, 70, 32),
    extended(Out, [V1,V2]).

extended(Out, Numbers) :-
    group(Out, 1001, 'SANGGWAN'),
    forall(member(Number, Numbers), group(Out, 1071, Number)).

%   All digits, as the vertices have them.

place(Out, point(X,Y,Z)) :-
    group(Out, 10, X),
    group(Out, 20, Y),
    group(Out, 30, Z).
