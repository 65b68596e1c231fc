:- module(sg_true_part_loop,
          [ facet_parted/3              % +Shape, +Facet, -Facets
          ]).
:- use_module(true_shape, [facet_middle/2, key_place/4]).
:- use_module(library(apply), [foldl/4, maplist/3, partition/4]).
:- use_module(library(lists),
              [append/2, append/3, max_member/2, member/2]).
/** <module> Facets that a hole parts.

A hole that goes over a facet from one generator to the other leaves several
parts of it, which are polygons of their own. Where that of the facets does not,
but the true one does (true_tip.pl), they are still one facet.
*/

%!  facet_parted(+Shape, +Facet, -Facets) is det.
%
%   Facets are the parts of Facet (true_shape.pl): one for each outer loop of
%   its half-edges, with the holes in it.

facet_parted(Shape, Facet, Facets) :-
    Facet = facet(P, T1, T2, Halves),
    loops(Halves, Loops),
    (   Loops = [_,_|_],
        facet_middle(Facet, Middle),
        maplist(loop_area(Shape, Middle), Loops, Measured),
        partition(runs_as_outer(Measured), Measured, Outers, Holes),
        Outers = [_,_|_]
    ->  holes_added(Shape, Middle, Outers, Holes, [Whole|Rest]),
        findall(facet(P/0, T1, T2, Part), member(Part, Rest), Parts),
        Facets = [facet(P, T1, T2, Whole)|Parts]
    ;   Facets = [Facet]
    ).

%   loops(Halves, Loops): the connected ones.

loops([], []).
loops([Half|Halves0], [Loop|Loops]) :-
    hanging([Half], Halves0, Loop, Halves),
    loops(Halves, Loops).

hanging([], Halves, [], Halves).
hanging([Half|Queue], Halves0, [Half|Loop], Halves) :-
    partition(touching(Half), Halves0, Next, Halves1),
    append(Next, Queue, Queue1),
    hanging(Queue1, Halves1, Loop, Halves).

touching(half(A, B, _), half(C, D, _)) :-
    ( A == D ; B == C ; A == C ; B == D ),
    !.

%   loop_area(Shape, Middle, Loop, Area-Loop): twice the area, T to the right
%   and H up.

loop_area(Shape, Middle, Loop, Area-Loop) :-
    foldl(half_area(Shape, Middle), Loop, 0.0, Area).

half_area(Shape, Middle, half(K1, K2, _), Area0, Area) :-
    place(Shape, Middle, K1, T1, H1),
    place(Shape, Middle, K2, T2, H2),
    Area is Area0 + (T1-Middle)*H2 - (T2-Middle)*H1.

place(shape(_, _, Nodes), Middle, Key, T, H) :-
    key_place(Nodes, Key, T0, H),
    (   T0 == any
    ->  T = Middle
    ;   T = T0
    ).

%   runs_as_outer(Measured, Area-Loop): as the largest of them does.

runs_as_outer(Measured, Area-_) :-
    findall(Size-Sign,
            ( member(A-_, Measured), Size is abs(A), Sign is sign(A) ),
            Sizes),
    max_member(_-Sign, Sizes),
    Area*Sign > 0.0.

%   holes_added(Shape, Middle, Outers, Holes, Parts): Parts are the half-edges
%   of Outers, each with those of the Holes that it goes round.

holes_added(_, _, Outers, [], Parts) :-
    !,
    findall(Loop, member(_-Loop, Outers), Parts).
holes_added(Shape, Middle, Outers, Holes, Parts) :-
    findall(Part,
            ( member(_-Outer, Outers),
              findall(Hole,
                      ( member(_-Hole, Holes),
                        Hole = [half(Key, _, _)|_],
                        place(Shape, Middle, Key, T, H),
                        goes_round(Shape, Middle, Outer, T, H) ),
                      Within),
              append([Outer|Within], Part) ),
            Parts).

%   goes_round(Shape, Middle, Loop, T, H): a ray upwards crosses it oddly often.

goes_round(Shape, Middle, Loop, T, H) :-
    findall(x,
            ( member(half(K1, K2, _), Loop),
              place(Shape, Middle, K1, T1, H1),
              place(Shape, Middle, K2, T2, H2),
              ( T1 =< T, T < T2 ; T2 =< T, T < T1 ),
              H1 + (T-T1)*(H2-H1)/(T2-T1) > H ),
            Crossings),
    length(Crossings, Count),
    Count mod 2 =:= 1.
