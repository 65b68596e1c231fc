:- module(sg_true_seam,
          [ shortest_generators/2,      % +Candidates, -Gs
            hole_places/2,              % +Shape, -Degrees
            farthest_from/3             % +Holes, +Gs, -G
          ]).
:- use_module('../near', [before_angle/2, longer/2, same_part/2]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(assoc), [assoc_to_values/2]).
:- use_module(library(lists), [max_list/2, member/2, min_list/2, nth1/3]).
:- use_module(library(pairs), [pairs_keys/2]).
/** <module> At which generator a true pattern is cut open, if nobody says it.

At the shortest that no hole interrupts; of equal ones at the one that is
farthest from all holes.
*/

%!  shortest_generators(+Candidates, -Gs) is det.
%
%   Gs are those of Candidates, length(Spans, Length)-G, that are in one span,
%   if there are such, and are shortest, up to rounding; in the order of
%   Candidates.

shortest_generators(Candidates, Gs) :-
    findall(Length-G, member(length(1,Length)-G, Candidates), Whole),
    (   Whole == []
    ->  findall(Length-G, member(length(_,Length)-G, Candidates), Lengths)
    ;   Lengths = Whole
    ),
    pairs_keys(Lengths, Ls),
    min_list(Ls, Least),
    findall(G, ( member(Length-G, Lengths), \+ longer(Length, Least) ), Gs).

%!  hole_places(+Shape, -Degrees:list) is det.
%
%   Degrees are the parameters of the corners of what is cut out: those off the
%   rims. Ascending.

hole_places(shape(_,_,Nodes), Degrees) :-
    assoc_to_values(Nodes, Places),
    findall(T,
            ( member(node(T,H,_,_), Places),
              T \== any,
              \+ same_part(H, 0.0),
              \+ same_part(H, 1.0) ),
            Degrees0),
    sort(Degrees0, Degrees).

%!  farthest_from(+Holes, +Gs, -G) is det.
%
%   G is the first of the directions Gs that is farthest from all Holes,
%   degrees.

farthest_from(Holes, Gs, G) :-
    (   Gs = [_,_|_],
        Holes \== []
    ->  maplist(nearest_angle(Holes), Gs, Offs),
        max_list(Offs, Most),
        once(( nth1(I, Offs, Off),
               \+ before_angle(Off, Most),
               nth1(I, Gs, G) ))
    ;   Gs = [G|_]
    ).

nearest_angle(Holes, T, Off) :-
    findall(Off0,
            ( member(Hole, Holes),
              Off0 is abs(T-Hole - 360.0*round((T-Hole)/360.0)) ),
            Offs),
    min_list(Offs, Off).
