:- module(sg_development_border,
          [ borders_told/2              % +S, +Flattening
          ]).
:- use_module('../kernel', [flattening_borders/2]).
:- use_module(polygon_name, [polygon_name/3]).
:- use_module('../store', [e/5, segment/3, edge_polygon/3]).
:- use_module(library(lists), [member/2]).
/** <module> Edges that have no partner where one would think that they have.

The border of a surface is one of its pattern. But an edge of a solid without a
partner, two polygons that run along an edge in the same direction (one of them
is turned over), and a third polygon at an edge make a pattern fall apart for no
reason that could be seen in it.
*/

%!  borders_told(+S, +Flattening) is det.
%
%   A warning for each kind of fault at the borders of segment S, with the
%   polygons that have such edges.

borders_told(S, Flattening) :-
    flattening_borders(Flattening, Es),
    findall(Kind-E, ( member(E, Es), border_fault(S, E, Kind) ), Faults),
    forall(member(Kind, [open,turned,crowded]),
           kind_told(Kind, S, Faults)).

kind_told(Kind, S, Faults) :-
    findall(side(E, P, Name),
            ( member(Kind-E, Faults),
              once(edge_polygon(S, E, P)),
              polygon_name(S, P, Name) ),
            Sides),
    (   Sides == []
    ->  true
    ;   print_message(warning,
                      sanggwan(development(S, border(Kind, Sides))))
    ).

%   border_fault(S, E, Kind): what is wrong at border edge E of segment S.
%   Nothing, if its partner is a polygon that is left out.

border_fault(S, E, Kind) :-
    once(e(S, E, A, B, _)),
    sides_between(S, A, B, Along),
    sides_between(S, B, A, Against),
    fault_of(Along, Against, S, Kind).

sides_between(S, A, B, Count) :-
    findall(F, ( e(S, F, A, B, 1), once(edge_polygon(S, F, _)) ), Fs),
    length(Fs, Count).

fault_of(1, 0, S, open) :-
    once(segment(S, solid, _)).
fault_of(Along, 0, _, turned) :-
    Along > 1.
fault_of(Along, Against, _, crowded) :-
    Against > 0,
    Along > Against.
