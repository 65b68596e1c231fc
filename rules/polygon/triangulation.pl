:- module(sg_triangulation,
          [ complete_segments/0,
            complete_segments/1,        % +Ss
            pattern_completed/1,        % +D
            new_segments_complete/0,
            untriangulated/1,           % +S
            work_triangles/2            % +Work, -Triangles
          ]).
:- use_module('../kernel',
              [ fill_triangles/2, untriangulated_segments/1, work_oldest/4,
                work_triangulate/2
              ]).
:- use_module('../stage', [stage/2]).
:- use_module('../store', [p/3, t/6, facts_transaction/1]).
:- use_module(library(apply), [exclude/3]).
:- use_module(library(lists), [last/2, member/2]).

/** <module> Polygons into triangles.

The kernel fill_triangles/2 triangulates whole segments (PL-6), work_triangles/2
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
%   are used as their triangles, with one warning a segment.
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
    stage(complete, facts_transaction(( fill_triangles(Which, Faults),
                                        refuse_open(Faults)
                                      ))).

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

refuse_open(Faults) :-
    (   member(fault(S, P, not_closed(V)), Faults)
    ->  throw(error(model_error(polygon(S, P, open(V))), _))
    ;   true
    ).

warn(Faults) :-
    forall(member(fault(S, P, not_simple(V1, V2)), Faults),
           warning(polygon_edge(S, P, V1, V2))),
    forall(setof(P, member(fault(S, P, no_area), Faults), Ps),
           warn_no_area(S, Ps)),
    forall(setof(Off-P, member(fault(S, P, not_flat(Off)), Faults), Pairs),
           warn_not_flat(S, Pairs)).

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
