:- module(sg_cut_rows,
          [ write_polygons/2,           % +Set, +Works
            write_polygon_by_rule/2,    % +Set, +Work
            split_curves/2              % +Pairs, +Set
          ]).
:- use_module('../kernel',
              [ cut_line/5, cut_write/3,
                cut_split_edges/3, model_tolerance/1,
                work_add/6, work_delete/2, work_edge/6, work_resolve/2
              ]).
:- use_module('../csg/leaf', [curve_kept/1, curve_segment/1]).
:- use_module('../store',
              [ e/5, p/3, t/6, origin/3,
                assert_fact/1, retract_fact/1, retractall_facts/1, fresh_id/3,
                edge_polygon/3
              ]).
:- use_module('../polygon/triangulation', [work_triangles/2]).
:- use_module(library(apply),
              [exclude/3, foldl/4, include/3, maplist/2, maplist/3]).
:- use_module(library(lists), [append/3, member/2, reverse/2]).

/** <module> The rows that a penetration leaves.

What penetration.pl has put into a cut set and into scratch relations, back in
the world: after the lines (cut_write_lines/1) the polygons that were cut, with
their new edges and triangles (PL-6).

@see [PL] section 5; rows PL-6 to PL-9
*/

%!  write_polygons(+Set, +Works) is det.
%!  write_polygon_by_rule(+Set, +Work) is det.
%
%   The polygon of each of Works, work(S, P, Edges), keeps its number; its edges
%   and its triangles are replaced, after cut_write_lines/1. cut_write/3 is the
%   fused kernel of the rule, for what needs no resolving; a test holds the two
%   together.
%
%   @error geometry_error(polygon_edge(S, P, V1, V2)): it cannot be triangulated

write_polygons(Set, Works) :-
    cut_write(Set, Works, N),
    length(Written, N),
    append(Written, Others, Works),
    (   Others = [Work|Rest]
    ->  write_polygon_by_rule(Set, Work),
        write_polygons(Set, Rest)
    ;   true
    ).

write_polygon_by_rule(Set, work(S, P, Work)) :-
    findall(w(V1, V2, Et, Label),
            work_edge(Work, _, V1, V2, Et, Label),
            Edges),
    p(S, P, Es0),
    !,
    exclude(mere_fold(Set, S), Edges, Written),
    retract_once(p(S, P, Es0)),
    drop_divided(S, Es0, Written),
    maplist(write_edge(Set, S), Written, Es),
    assert_fact(p(S, P, Es)),
    write_triangles(S, P, Work, Edges).

%   mere_fold(Set, S, Edge): a fold of a polygon that is not flat (type and
%   label 0), along which no line runs. The triangles keep to it, the polygon
%   has no such edge.

mere_fold(Set, S, w(V1, V2, 0, 0)) :-
    \+ cut_line(Set, S, V1, V2, _).

retract_once(Fact) :-
    retract_fact(Fact),
    !.

%   The edges of the polygon that are there no more as they were, and that no
%   other polygon has.

drop_divided(S, Es, Edges) :-
    forall(( member(E, Es),
             e(S, E, V1, V2, _),
             \+ memberchk(w(V1, V2, _, E), Edges),
             \+ edge_polygon(S, E, _)
           ),
           retractall_facts(e(S, E, _, _, _))).

write_edge(_, S, w(V1, V2, _, Label), Label) :-
    Label > 0,
    e(S, Label, V1, V2, _),
    !.
write_edge(_, S, w(V1, V2, _, Label), E) :-
    Label > 0,
    e(S, E, V1, V2, _),
    origin(S, e(E), e(Label)),
    !.
write_edge(Set, S, w(V1, V2, Et0, Label), E) :-
    edge_origin(Set, S, V1, V2, Label, Origin),
    (   Label =:= 0
    ->  Et = 1
    ;   Et = Et0
    ),
    fresh_id(e, S, E),
    assert_fact(e(S, E, V1, V2, Et)),
    assert_fact(origin(S, e(E), Origin)).

edge_origin(_, _, _, _, Label, e(Label)) :-
    Label > 0,
    !.
edge_origin(Set, S, V1, V2, _, line(L)) :-
    cut_line(Set, S, V1, V2, L).

%   A polygon without area or that crosses itself had no triangles.

write_triangles(S, P, Work, Edges) :-
    (   t(S, P, _, _, _, _)
    ->  retractall_facts(t(S, P, _, _, _, _)),
        polygon_triangles(S-P, Work, Edges, [none, 0.0, tolerance],
                          Triangles),
        maplist(write_triangle(S, P), Triangles)
    ;   true
    ).

%   A polygon that touches itself must be resolved before, as it was when it
%   was triangulated for the first time. That is rare, so it is tried only
%   when the exact way got stuck: with what touches exactly, then with what
%   does so within the tolerance.

polygon_triangles(S-P, Work, Edges, [Reach|Reaches], Triangles) :-
    resolve(Reach, Work, Edges),
    catch(work_triangles(Work, Triangles0),
          error(geometry_error(no_third_vertex(V1, V2)), _),
          Stuck = true),
    (   Stuck \== true
    ->  Triangles = Triangles0
    ;   Reaches == []
    ->  throw(error(geometry_error(polygon_edge(S, P, V1, V2)), _))
    ;   polygon_triangles(S-P, Work, Edges, Reaches, Triangles)
    ).

resolve(none, _, _) :-
    !.
resolve(tolerance, Work, Edges) :-
    !,
    model_tolerance(Reach),
    resolve(Reach, Work, Edges).
resolve(Reach, Work, Edges) :-
    findall(E, work_edge(Work, E, _, _, _, _), Rest),
    maplist(work_delete(Work), Rest),
    forall(( member(w(V1, V2, Et, Label), Edges), V1 \== V2 ),
           work_add(Work, V1, V2, Et, Label, _)),
    work_resolve(Work, Reach).

write_triangle(S, P, t(V1, V2, V3)) :-
    fresh_id(t, S, T),
    assert_fact(t(S, P, T, V1, V2, V3)).

/* - - - 5.1: curves - - - */

%!  split_curves(+Pairs, +Set) is det.
%
%   The edges of curves in Pairs are divided at their points.

split_curves(Pairs, Set) :-
    findall(S, ( member(S1-S2, Pairs), member(S, [S1,S2]) ), Ss0),
    sort(Ss0, Ss),
    include(curve_segment, Ss, Curves),
    forall(( member(S, Curves),
             cut_split_edges(Set, S, Splits),
             member(split(V1, V2, Vs), Splits)
           ),
           split_curve_edge(S, V1, V2, Vs)).

split_curve_edge(S, V1, V2, Vs) :-
    reverse(Vs, Back),
    split_directed(S, V1, V2, Vs),
    split_directed(S, V2, V1, Back).

split_directed(S, V1, V2, Vs) :-
    findall(E-Et, e(S, E, V1, V2, Et), Es),
    forall(member(E-Et, Es),
           ( curve_kept(S-E),
             retractall_facts(e(S, E, _, _, _)),
             foldl(write_part(S, E, Et), Vs, V1, V),
             write_part(S, E, Et, V2, V, _)
           )).

write_part(S, Old, Et, V2, V1, V2) :-
    fresh_id(e, S, E),
    assert_fact(e(S, E, V1, V2, Et)),
    assert_fact(origin(S, e(E), e(Old))).
