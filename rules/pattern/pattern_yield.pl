:- module(sg_pattern_yield,
          [ pattern_yield/2             % +Drawings, -Yield
          ]).
:- use_module(pattern_outline, [loop_area/2]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(lists), [append/3, member/2]).
/** <module> How much of the sheets the pieces use.
*/

%!  pattern_yield(+Drawings:list, -Yield:dict) is det.
%
%   Yield is of the sheets Drawings (pattern_drawing.pl), before they are tiled:
%   sheets, how many there are; sheet_area, of all of them, with their margins;
%   piece_area, of what is cut out, tabs and all, without holes; yield, the one
%   over the other, from 0 to 1. Areas are in square millimetres of the sheet.

pattern_yield(Drawings, _{sheets:Sheets, sheet_area:All, piece_area:Used,
                          yield:Yield}) :-
    length(Drawings, Sheets),
    aggregate_all(sum(W*H/1.0e6),
                  member(drawing(sheet(W,H,_),_), Drawings), All),
    aggregate_all(sum(Area),
                  ( member(drawing(_,Views), Drawings),
                    member(view(_,Strokes,_), Views),
                    member(stroke(_,cut,_,_,Points,ring,_), Strokes),
                    ring_area(Points, Area) ),
                  Used),
    Yield is Used/All.

%   The piece lies on the left of its rings as seen with y up; so below zero
%   are outlines, above it holes.

ring_area(Points, Area) :-
    append(Corners, [_], Points),
    loop_area(Corners, Area0),
    Area is -Area0/1.0e6.
