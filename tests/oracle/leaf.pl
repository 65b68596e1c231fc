:- module(sg_oracle_leaf,
          [ leaves_kept_by_rule/1,      % +Polygons
            place_kept/1                % +Vertex
          ]).
:- use_module('../../rules/csg/leaf', [curve_kept/1]).
:- use_module('../../rules/store',
              [v/5, p/3, t/6, leaf_v/5, leaf_p/3, assert_fact/1]).
:- use_module(library(apply), [maplist/2]).
:- use_module(library(lists), [member/2]).
/** <module> The rule of leaves_kept/1 (rules/csg/leaf.pl), polygon by polygon.
*/

%!  leaves_kept_by_rule(+Polygons:list) is det.
%
%   Writes leaf_e/5, leaf_p/3 and leaf_t/6 of the polygons S-P, which are
%   about to be cut; those that have them keep them.

leaves_kept_by_rule(Polygons) :-
    maplist(leaf_kept, Polygons).

leaf_kept(S-P) :-
    (   leaf_p(S, P, _)
    ->  true
    ;   p(S, P, Es)
    ->  forall(member(E, Es), curve_kept(S-E)),
        assert_fact(leaf_p(S, P, Es)),
        forall(t(S, P, T, V1, V2, V3),
               assert_fact(leaf_t(S, P, T, V1, V2, V3)))
    ).

%!  place_kept(+Vertex) is det.
%
%   Writes leaf_v/5 of the vertex S-V, which is about to be moved.

place_kept(S-V) :-
    (   leaf_v(S, V, _, _, _)
    ->  true
    ;   v(S, V, X, Y, Z)
    ->  assert_fact(leaf_v(S, V, X, Y, Z))
    ;   true
    ).
