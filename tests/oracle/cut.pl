:- module(sg_oracle_cut,
          [ find_cuts_by_rule/1,        % +Set
            cut_pair/3,                 % +Set, +T1, +T2
            triangle_cut/5              % +S1-T1, +S2-T2, -Kind, -End1, -End2
          ]).
:- use_module('../../rules/kernel',
              [ cut_set_open/2, cut_set_close/1, cut_candidate/3, cut_side/4,
                cut_enter/4, cut_triangle/5, cut_ends/4
              ]).
:- use_module(library(lists), [member/2]).
/** <module> The rule of cuts: which triangles cut each other, and where (PL-8).
*/

%!  find_cuts_by_rule(+Set) is det.
%
%   Puts the cuts of cut set Set into it, as cut_find/1 does. 5.2 *1: of a
%   triangle of each of two segments, their boxes overlapping.

find_cuts_by_rule(Set) :-
    forall(cut_candidate(Set, T1, T2),
           cut_pair(Set, T1, T2)).

%!  cut_pair(+Set, +T1, +T2) is det.
%
%   5.2 2: each must have corners on both sides of the other's plane (or on
%   it). *3: what they have in common goes into the set.

cut_pair(Set, T1, T2) :-
    (   cut_side(Set, T1, T2, 0),
        cut_side(Set, T2, T1, 0)
    ->  cut_enter(Set, T1, T2, _)
    ;   true
    ).

%!  triangle_cut(+Triangle1, +Triangle2, -Kind, -End1, -End2) is nondet.
%
%   True when triangles T1 of segment S1 and T2 of S2 have the points from
%   End1 to End2 in common: one piece if their planes differ (Kind is
%   `crossing`), the borders of each inside the other if not (`coplanar`); a
%   point if the ends are equal. An end is a pair of features,
%   Feature1-Feature2, each one of vertex(V), edge(V1,V2) and face(T). Exact.

triangle_cut(S1-T1, S2-T2, Kind, End1, End2) :-
    cut_set_open([S1-S2], Set),
    setup_call_cleanup(
        true,
        findall(cut(K, A, B), set_cut(Set, S1-T1, S2-T2, cut(K, A, B)), Cuts),
        cut_set_close(Set)),
    member(cut(Kind, End1, End2), Cuts).

set_cut(Set, S1-T1, S2-T2, Cut) :-
    cut_candidate(Set, I, J),
    cut_triangle(Set, I, S1, _, T1),
    cut_triangle(Set, J, S2, _, T2),
    cut_ends(Set, I, J, Cuts),
    member(Cut, Cuts).
