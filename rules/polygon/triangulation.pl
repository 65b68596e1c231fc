:- module(sg_triangulation,
          [ complete_segments/0,
            complete_segments/1,        % +Ss
            pattern_completed/1,        % +D
            new_segments_complete/0,
            untriangulated/1,           % +S
            work_triangles/2            % +Work, -Triangles
          ]).
:- use_module('../kernel',
              [ fill_triangles/3, untriangulated_segments/1, work_oldest/4,
                work_triangulate/2
              ]).
:- use_module('../limits', [limit_value/2]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [ e/5, from_p/5, p/3, t/6, assert_fact/1, facts_transaction/1,
                fresh_id/3, retractall_facts/1
              ]).
:- use_module(library(apply), [exclude/3, foldl/4, include/3, maplist/3]).
:- use_module(library(lists),
              [append/3, last/2, member/2, selectchk/3]).
:- use_module(library(pairs), [pairs_keys/2]).

/** <module> Polygons into triangles.

The kernel fill_triangles/3 triangulates whole segments (PL-6), work_triangles/2
a polygon that lines have entered. Concave, hollow, several times hollow and
internally cut polygons are all taken alike. tests/oracle/triangulation.pl is
the rule, section 4 of the paper step by step; it gives the same triangles in
the same order.

@see [PL] section 4, row PL-6 of the requirements
*/

%!  work_triangles(+Work, -Triangles) is det.
%
%   Triangles are the triangles t(V1, V2, V3) of the polygon in Work, whose
%   edges are used up.
%
%   @error geometry_error(no_third_vertex(V1, V2)): the polygon is invalid, for
%          its edge V1-V2 has no third vertex

work_triangles(Work, Triangles) :-
    work_triangulate(Work, Triangles),
    (   work_oldest(Work, _, V1, V2)
    ->  throw(error(geometry_error(no_third_vertex(V1, V2)), _))
    ;   true
    ).

%!  new_segments_complete is det.
%
%   complete_segments/1 of the segments that have polygons and not one triangle:
%   those that somebody asserted and nobody completed. What is computed from
%   triangles calls it first; it costs one look at the rows of t/6.

new_segments_complete :-
    untriangulated_segments(Ss),
    (   Ss == []
    ->  true
    ;   complete_segments(Ss)
    ).

%!  untriangulated(+S) is semidet.
%
%   True when segment S has polygons and not one triangle.

untriangulated(S) :-
    \+ t(S, _, _, _, _, _),
    p(S, _, _),
    !.

%!  complete_segments is det.
%!  complete_segments(+Ss:list) is det.
%
%   Gives every polygon (of the segments Ss) that has no plane/6 its plane, and
%   every one that has no t/6 its triangles. A polygon that has no area or is
%   invalid is left without and named in a warning; polygons that are not flat
%   are used as their triangles, with one warning a segment. One whose triangles
%   cover each other however it is seen becomes so many polygons, the first of
%   which keeps its number: no line could be put into it as a whole.
%
%   @error model_error(polygon(S, P, open(V))): polygon P of segment S does
%          not close at V; nothing is changed

complete_segments :-
    filled(all).

complete_segments(Ss) :-
    filled(Ss).

filled(Which) :-
    filled(Which, Faults),
    warn(Faults).

filled(Which, Faults) :-
    limit_value(contacts, Most),
    stage(complete, facts_transaction(( fill_triangles(Which, Most, Faults0),
                                        refuse_open(Faults0),
                                        folded_parted(Faults0, Faults)
                                      ))).

%   folded_parted(Faults0, Faults): polygons that fold over become their
%   triangles; Faults tell of these too.

folded_parted(Faults0, Faults) :-
    findall(S-P, member(fault(S, P, folded), Faults0), Folded),
    include(polygon_parted, Folded, Parted),
    (   Parted == []
    ->  Faults = Faults0
    ;   pairs_keys(Parted, Ss0),
        sort(Ss0, Ss),
        limit_value(contacts, Most),
        fill_triangles(Ss, Most, More),
        append(Faults0, More, Faults)
    ).

%   polygon_parted(S-P): unless its edges are not those of its triangles.

polygon_parted(S-P) :-
    findall([A,B,C], t(S, P, _, A, B, C), Triangles),
    p(S, P, Es),
    findall((A-B)-E, ( member(E, Es), e(S, E, A, B, _) ), Border),
    foldl(triangle_sides, Triangles, Border-Lists, []-[]),
    retractall_facts(p(S, P, _)),
    retractall_facts(t(S, P, _, _, _, _)),
    retractall_facts(plane(S, P, _, _, _, _)),
    Lists = [List|Others],
    triangle_added(S, P, List),
    forall(member(Other, Others),
           ( fresh_id(p, S, New),
             triangle_added(S, New, Other),
             forall(from_p(S, P, S0, P0, Sense),
                    assert_fact(from_p(S, New, S0, P0, Sense))) )).

%   triangle_sides([A,B,C], Border0-[Sides|Lists], Border-Lists): each side is
%   edge(E) of the border, which has it once, or chord(V1, V2).

triangle_sides([A,B,C], Border0-[Sides|Lists], Border-Lists) :-
    foldl(triangle_side, [A-B,B-C,C-A], Sides-Border0, []-Border).

triangle_side(Ends, [Side|Sides]-Border0, Sides-Border) :-
    (   selectchk(Ends-E, Border0, Border)
    ->  Side = edge(E)
    ;   Ends = V1-V2,
        Side = chord(V1, V2),
        Border = Border0
    ).

triangle_added(S, P, Sides) :-
    maplist(side_edge(S), Sides, Es),
    assert_fact(p(S, P, Es)).

side_edge(_, edge(E), E).
side_edge(S, chord(V1, V2), E) :-
    fresh_id(e, S, E),
    assert_fact(e(S, E, V1, V2, 1)).

%!  pattern_completed(+D) is det.
%
%   complete_segments/1 of the pattern D that is being made. A polygon that is
%   invalid is left without triangles and not named: it is no polygon of the
%   user's, who is told of it when the pattern is done (unfold_whole.pl).
%
%   @error as complete_segments/1

pattern_completed(D) :-
    filled([D], Faults0),
    exclude(is_not_simple, Faults0, Faults),
    warn(Faults).

is_not_simple(fault(_, _, not_simple(_,_))).
is_not_simple(fault(_, _, tangled)).

refuse_open(Faults) :-
    (   member(fault(S, P, not_closed(V)), Faults)
    ->  throw(error(model_error(polygon(S, P, open(V))), _))
    ;   true
    ).

warn(Faults) :-
    forall(setof(P-(V1-V2), member(fault(S, P, not_simple(V1, V2)), Faults),
                 Invalid),
           warn_not_simple(S, Invalid)),
    forall(setof(P, member(fault(S, P, tangled), Faults), Ps),
           warn_tangled(S, Ps)),
    forall(setof(P, member(fault(S, P, no_area), Faults), Ps),
           warn_no_area(S, Ps)),
    forall(setof(Off-P, member(fault(S, P, not_flat(Off)), Faults), Pairs),
           warn_not_flat(S, Pairs)).

warn_not_simple(S, [P-(V1-V2)|Others]) :-
    (   Others == []
    ->  warning(polygon_edge(S, P, V1, V2))
    ;   length([P|Others], Count),
        warning(polygon_edges(S, Count, P, V1, V2))
    ).

warn_tangled(S, Ps) :-
    Ps = [P|_],
    length(Ps, Count),
    limit_value(contacts, Most),
    warning(tangled(S, Count, P, Most)).

warn_no_area(S, Ps) :-
    Ps = [P|_],
    length(Ps, Count),
    warning(no_area(S, Count, P)).

warn_not_flat(S, Pairs) :-
    last(Pairs, Off-P),
    length(Pairs, Count),
    warning(not_flat(S, Count, P, Off)).

warning(What) :-
    print_message(warning, sanggwan(What)).
