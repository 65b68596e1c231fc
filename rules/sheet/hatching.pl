:- module(sg_hatching,
          [ hatch_lines/4,              % +Edges, +Way, +Spacing, -Lines
            region_area/2               % +Edges, -Area
          ]).
:- use_module(library(apply), [foldl/4, maplist/3]).
/** <module> Hatching: parallel lines that fill a region of the sheet.

A region is the list of its directed edges A-B, points X-Y, integers, with the
region always on the same side of them; holes are more such loops. Hatching
lines are those of X-Y = C (`falling`: the sheet's y runs down) or X+Y = C
(`rising`). C is half an integer, so no line goes through a corner, and which
edges it crosses is decided exactly; it is inside between the first and the
second crossing, the third and the fourth, and so on. Only where a crossing is
drawn is rounded.
*/

:- set_prolog_flag(optimise, true).

%!  hatch_lines(+Edges, +Way, +Spacing, -Lines) is det.
%
%   Lines, each A-B, fill the region with Edges at 45 degrees; Way is `rising`
%   or `falling`. Spacing is from line to line, square to them, in the unit of
%   the points. Regions of one Way and Spacing are hatched in line.

hatch_lines(Edges, Way, Spacing, Lines) :-
    maplist(turned_edge(Way), Edges, Turned),
    Step is max(1, round(Spacing*sqrt(2))),
    foldl(edge_crossings(Step), Turned, [], Crossings0),
    msort(Crossings0, Crossings),
    crossing_lines(Crossings, Way, Lines).

%   In C-X coordinates.

turned_edge(Way, A0-B0, A-B) :-
    turned(Way, A0, A),
    turned(Way, B0, B).

turned(falling, X-Y, C-X) :-
    C is X-Y.
turned(rising, X-Y, C-X) :-
    C is X+Y.

%   The lines K*Step + 1/2 that an edge crosses: from its lower C, included, to
%   its higher one. Crossings are K-X.

edge_crossings(Step, A-B, Crossings0, Crossings) :-
    (   A @< B
    ->  A = C1-X1,
        B = C2-X2
    ;   B = C1-X1,
        A = C2-X2
    ),
    K is -((-C1) div Step),
    crossings(K, line(C1,X1,C2,X2), Step, Crossings0, Crossings).

crossings(K, Line, Step, Crossings0, Crossings) :-
    Line = line(C1,X1,C2,X2),
    C is K*Step,
    (   C < C2
    ->  X is X1 + (X2-X1)*(C+0.5-C1)/(C2-C1),
        K1 is K+1,
        crossings(K1, Line, Step, [K-(C-X)|Crossings0], Crossings)
    ;   Crossings = Crossings0
    ).

crossing_lines([K-(C-XA),K-(_-XB)|Crossings], Way, Lines) :-
    !,
    hatch_point(Way, C, XA, A),
    hatch_point(Way, C, XB, B),
    (   A == B
    ->  Lines = Lines1
    ;   Lines = [A-B|Lines1]
    ),
    crossing_lines(Crossings, Way, Lines1).
crossing_lines(_, _, []).

hatch_point(Way, C, X0, X-Y) :-
    X is round(X0),
    hatch_y(Way, C, X0, Y).

hatch_y(falling, C, X, Y) :-
    Y is round(X-(C+0.5)).
hatch_y(rising, C, X, Y) :-
    Y is round(C+0.5-X).

%!  region_area(+Edges, -Area) is det.
%
%   Area, an integer or half of one, of the region with Edges.

region_area(Edges, Area) :-
    foldl(edge_area, Edges, 0, Twice),
    Area is abs(Twice)/2.

edge_area((X1-Y1)-(X2-Y2), Twice0, Twice) :-
    Twice is Twice0 + X1*Y2 - X2*Y1.
