:- module(sg_oracle_near_joints,
          [ merge_near_by_rule/3        % +Set, +Joints, +Works
          ]).
:- use_module('../../rules/kernel',
              [ cut_join/2, cut_name/4, work_add/6, work_delete/2,
                work_edge/6, work_meeting/6
              ]).
:- use_module(library(apply), [maplist/2]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [member/2]).
/** <module> The rule of cut_merge_near/3: joints that are nearly straight.
*/

%!  merge_near_by_rule(+Set, +Joints:list, +Works:list) is det.
%
%   As cut_merge_near/3 of rules/kernel/penetration.pl.

merge_near_by_rule(Set, Joints, Works) :-
    works_by_polygon(Works, ByPolygon),
    maplist(merge_near(Set, ByPolygon), Joints).

works_by_polygon(Works, ByPolygon) :-
    findall(S-P-Work, member(work(S, P, Work), Works), Pairs),
    list_to_assoc(Pairs, ByPolygon).

merge_near(Set, ByPolygon, joint(Point, piece(S1, P1, S2, P2), _)) :-
    (   get_assoc(S1-P1, ByPolygon, Work1),
        get_assoc(S2-P2, ByPolygon, Work2),
        cut_name(Set, Point, S1, V1),
        cut_name(Set, Point, S2, V2),
        is_free_without(Work1, V1),
        is_free_without(Work2, V2)
    ->  cut_join(Set, Point),
        merge_at(Work1, V1),
        merge_at(Work2, V2)
    ;   true
    ).

%   is_free_without(+Work, +V): the edge that would replace those through V
%   meets no other.

is_free_without(Work, V) :-
    work_edge(Work, _, V1, V, _, _),
    work_edge(Work, _, V, V2, _, _),
    V2 \== V1,
    !,
    \+ ( work_meeting(Work, V1, V2, E, _, _),
         work_edge(Work, E, A, B, _, _),
         A \== V,
         B \== V
       ).

%   The edges through V become one, in each direction that is there.

merge_at(Work, V) :-
    findall(E-V1, work_edge(Work, E, V1, V, _, _), Entering),
    maplist(merge_through(Work, V), Entering).

merge_through(Work, V, E1-V1) :-
    work_edge(Work, E1, V1, V, Et, Label),
    work_edge(Work, E2, V, V2, _, _),
    V2 \== V1,
    !,
    work_delete(Work, E1),
    work_delete(Work, E2),
    work_add(Work, V1, V2, Et, Label, _).
