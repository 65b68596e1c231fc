:- module(sg_true_join,
          [ facets_joined/2,            % +Facets0, -Facets
            facets_connected/2,         % +Facets, -Parts
            facets_between/3,           % +Facets, -T1, -T2
            outer_halves/2              % +Facets, -Halves
          ]).
:- use_module(library(apply), [maplist/3, partition/4]).
:- use_module(library(lists),
              [append/3, max_list/2, member/2, min_list/2, selectchk/3]).
:- use_module(library(ordsets), [ord_memberchk/2]).
/** <module> Facets that are put together to one.

Facets are those of true_shape.pl. What was cut in fine facets has one polygon
in the pattern for all that belong together.
*/

%!  facets_joined(+Facets0, -Facets) is det.
%
%   Facets are the connected parts of Facets0, each as one facet.

facets_joined([Facet], [Facet]) :-
    !.
facets_joined(Facets0, Facets) :-
    facets_connected(Facets0, Parts),
    maplist(one_of_pieces, Parts, Facets).

one_of_pieces([Facet], Facet) :-
    !.
one_of_pieces(Part, facet(P, G1, G2, Halves)) :-
    sort(1, @=<, Part, [facet(P, _, _, _)|_]),      % a number before P/I
    facets_between(Part, G1, G2),
    outer_halves(Part, Halves).

%!  facets_between(+Facets, -T1, -T2) is det.
%
%   Facets are between the generators T1 and T2.

facets_between(Facets, T1, T2) :-
    findall(T, member(facet(_, T, _, _), Facets), Froms),
    findall(T, member(facet(_, _, T, _), Facets), Tos),
    min_list(Froms, T1),
    max_list(Tos, T2).

%!  outer_halves(+Facets, -Halves) is det.
%
%   Halves are the half-edges of Facets without those between them.

outer_halves(Facets, Halves) :-
    findall(Half, ( member(facet(_, _, _, Hs), Facets), member(Half, Hs) ),
            Halves0),
    uncancelled(Halves0, Halves).

%!  facets_connected(+Facets, -Parts) is det.
%
%   Parts are lists of Facets: those with a half-edge in common, once each way,
%   are of one part.

facets_connected([], []).
facets_connected([Facet|Facets], [Part|Parts]) :-
    grown([Facet], Facets, Part, Rest),
    facets_connected(Rest, Parts).

grown([], Rest, [], Rest).
grown([Facet|Queue], Others, [Facet|Part], Rest) :-
    Facet = facet(_, _, _, Halves),
    findall(B-A, member(half(A, B, _), Halves), Backs0),
    sort(Backs0, Backs),
    partition(beside(Backs), Others, Beside, Others1),
    append(Beside, Queue, Queue1),
    grown(Queue1, Others1, Part, Rest).

beside(Backs, facet(_, _, _, Halves)) :-
    member(half(A, B, _), Halves),
    ord_memberchk(A-B, Backs),
    !.

%   uncancelled(Halves0, Halves): without pairs that run both ways; where tips
%   were given, one may run there twice and back once.

uncancelled(Halves0, Halves) :-
    findall(B-A, member(half(A, B, _), Halves0), Backs0),
    sort(Backs0, Backs),
    partition(runs_back(Backs), Halves0, Both, Once),
    pairs_cancelled(Both, Left),
    append(Once, Left, Halves).

runs_back(Backs, half(A, B, _)) :-
    ord_memberchk(A-B, Backs).

pairs_cancelled([], []).
pairs_cancelled([half(A, B, Label)|Halves0], Halves) :-
    (   selectchk(half(B, A, _), Halves0, Halves1)
    ->  pairs_cancelled(Halves1, Halves)
    ;   Halves = [half(A, B, Label)|Halves2],
        pairs_cancelled(Halves0, Halves2)
    ).
