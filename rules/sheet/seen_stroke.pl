:- module(sg_seen_stroke,
          [ seen_strokes/5,             % +Place, +Hatching, +Seen, -Own,
                                        % -Hatched
            placed_point/3,             % +Place, +Point0, -Point
            region_millimetres/3        % +PerUnit, +Region0, -Region
          ]).
:- use_module(sheet, [placed_part/3]).
:- use_module(sheet_marks, [hatching_strokes/3]).
:- use_module(stroke, [strokes/2]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [member/2]).
/** <module> What is seen in a view (sheet_view.pl), as strokes on a sheet.
*/

%!  seen_strokes(+Place, +Hatching, +Seen, -Own, -Hatched) is det.
%
%   Own are the strokes of the parts of Seen, which come to Place (placed_part/3
%   of sheet.pl), and Hatched those that hatch its regions, as Hatching
%   (hatching/2 of sheet_marks.pl) says.

seen_strokes(Place, Hatching, seen(_, Parts, Regions, _), Own, Hatched) :-
    maplist(placed_part(Place), Parts, Placed),
    strokes(Placed, Own),
    maplist(placed_region(Place), Regions, PlacedRegions),
    hatching_strokes(Hatching, PlacedRegions, Hatched).

placed_region(Place, region(S,Edges0), region(S,Edges)) :-
    maplist(placed_edge(Place), Edges0, Edges).

placed_edge(Place, A0-B0, A-B) :-
    placed_point(Place, A0, A),
    placed_point(Place, B0, B).

%!  placed_point(+Place, +Point0, -Point) is det.
%
%   The point Point0, X-Y, of the picture comes to Point, as placed_part/3 of
%   sheet.pl has it.

placed_point(place(Scale,X0,Y0,Left,Top), X-Y, A-B) :-
    A is round((X-X0)*Scale + Left),
    B is round((Y0-Y)*Scale + Top).

%!  region_millimetres(+PerUnit, +Region0, -Region) is det.
%
%   Region is Region0, region(S, Edges), in millimetres of the sheet, of which
%   one unit of the picture has PerUnit.

region_millimetres(PerUnit, region(S,Edges0), region(S,Edges)) :-
    findall((A1-B1)-(A2-B2),
            ( member((X1-Y1)-(X2-Y2), Edges0),
              maplist(times(PerUnit), [X1,Y1,X2,Y2], [A1,B1,A2,B2]) ),
            Edges).

times(Factor, X, Y) :-
    Y is X*Factor.
