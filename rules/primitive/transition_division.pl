:- module(sg_transition_division,
          [ rings_divided/3             % +N, +Rings0, -Rings
          ]).
:- use_module(transition_outline, [arc_point/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/2]).
/** <module> Finer facets of the same transition.

Between arcs that are not similar a transition stands for cones that take turns,
one for each step along an arc (primitive_transition.pl): it is as near to the
smooth surface between the outlines as these steps are to the arcs. Finer ones
have the corners of the coarse ones among theirs, and so its flat sides.
*/

%!  rings_divided(+N, +Rings0, -Rings) is det.
%
%   Rings0 is Ring1-Ring2, terms ring(Node, ...) of the nodes of both outlines,
%   as transition_outline.pl has them. In Rings each step along an arc is N, in
%   equal parts of the parameter; N >= 1.

rings_divided(N, Ring1-Ring2, Divided1-Divided2) :-
    ring_divided(N, Ring1, Divided1),
    ring_divided(N, Ring2, Divided2).

ring_divided(N, Ring, Divided) :-
    Ring =.. [ring|Nodes],
    maplist(node_divided(N), Nodes, Lists),
    append(Lists, All),
    Divided =.. [ring|All].

node_divided(N, node(P, Step), Nodes) :-
    (   Step = arc(Arc, T1, T2)
    ->  findall(node(P1, arc(Arc, T3, T4)),
                ( between(1, N, I),
                  arc_part(I, N, T1, T2, T3, T4),
                  part_start(I, P, Arc, T3, P1) ),
                Nodes)
    ;   Nodes = [node(P, Step)]
    ).

%   arc_part(I, N, T1, T2, T3, T4): the Ith of N equal parts.

arc_part(I, N, T1, T2, T3, T4) :-
    T3 is T1 + (T2-T1)*(I-1)/N,
    (   I =:= N
    ->  T4 = T2
    ;   T4 is T1 + (T2-T1)*I/N
    ).

part_start(1, P, _, _, P) :-
    !.
part_start(_, _, Arc, T, P) :-
    arc_point(Arc, T, P).
