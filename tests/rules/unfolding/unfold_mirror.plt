:- module(test_unfold_mirror, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(rules(store)).
:- use_module(rules(development/development), [develop/2]).
:- use_module(rules(development/seam_measure), [pattern_area/2]).
:- use_module(rules(pattern/pattern_title)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(unfolding/unfold_mirror)).

/* The other hand: the same numbers, the same joints, x the other way; and each
   face still counter-clockwise as it is seen. */

:- meta_predicate with_wedge(2).

with_wedge(Goal) :-
    new_world(World),
    in_world(World,
             ( add_primitive(prism(outline([[0,0],[40,0],[0,30]]),
                                   height(20)), S),
               complete_segments,
               develop(S, D),
               mirrored_pattern(D, M),
               call(Goal, D, M) )).

doubled(S, V1, V2, V3, Area) :-
    v(S, V1, XA, YA, _),
    v(S, V2, XB, YB, _),
    v(S, V3, XC, YC, _),
    Area is (XB-XA)*(YC-YA) - (XC-XA)*(YB-YA).

places(D, M) :-
    forall(v(D, V, X, Y, _), ( v(M, V, X1, Y, _), X1 =:= -X )).

upright(_, M) :-
    forall(t(M, _, _, A, B, C), ( doubled(M, A, B, C, Area), Area > 0 )).

planes(D, M) :-
    forall(( member(S, [D,M]), p(S, P, _) ), plane(S, P, 0.0, 0.0, 1.0, 0.0)).

joints(D, M) :-
    findall(j(J,A,B,K,T), joint(D, J, A, B, K, T), Js),
    findall(j(J,A,B,K,T), joint(M, J, A, B, K, T), Js).

areas(D, M) :-
    pattern_area(D, Area),
    pattern_area(M, Area),
    abs(Area-3600) < 1.0e-9.

%   Each edge goes on where another of its polygon ended.

loops(_, M) :-
    forall(( p(M, _, Es), member(E, Es), e(M, E, _, B, _) ),
           ( member(F, Es), e(M, F, B, _, _) )).

titles(D, M) :-
    pattern_titles([D,M], [D-Plain,M-Mirrored]),
    string_concat(Plain, ", mirrored", Mirrored).

marked(D, M) :-
    \+ is_mirrored(D),
    is_mirrored(M).

:- begin_tests(unfold_mirror).

test(mirrored, forall(member(What, [ places,upright,planes,joints,areas,loops,
                                     titles,marked ]))) :-
    with_wedge(What).

:- end_tests(unfold_mirror).
