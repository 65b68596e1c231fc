:- module(sg_simplify,
          [ simplified_roots/1          % +Faces
          ]).
:- use_module('../csg/csg', [root_segment/1]).
:- use_module('../csg/csg_roots', [roots_alone/0]).
:- use_module('../csg/csg_rows', [drop_boundary/1]).
:- use_module('../csg/csg_term', [plain_name/2]).
:- use_module('../csg/source', [source_noted/2]).
:- use_module('../kernel',
              [ segment_grain/2, segments_meeting_themselves/2,
                self_meeting/4, simplified_add/2, simplified_close/1,
                simplified_open/2, simplified_run/3, simplified_weigh/4 ]).
:- use_module('../polygon/polygon_whole', [crosses_itself/2]).
:- use_module('../polygon/triangulation', [complete_segments/0]).
:- use_module('../store',
              [ e/5, p/3, segment/3, t/6, assert_fact/1,
                retractall_facts/1, facts_transaction/1
              ]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/2, maplist/3]).
:- use_module(library(lists), [member/2]).
:- use_module(library(ordsets), [ord_subtract/3]).
/** <module> A model with fewer faces.

Solids and surfaces become meshes of fewer triangles, near what they were
(c_kernels/model/simplify.h); where detail costs least it goes first, whichever
part it is of. What is closed stays closed. Where a part would go through itself
its shape matters more, and all is made again.
*/

% How often what goes through itself is made, and how much more its shape
% matters there each time.
most_runs(6).
matters_more(16.0).

%!  simplified_roots(+Faces) is det.
%
%   The roots of the world become plain segments (roots_alone/0), and those with
%   polygons meshes of at most Faces triangles together. If they have no more
%   than that they stay as they are. What a face was of a primitive is not known
%   afterwards. One transaction. A message says how many there are; warnings
%   that it could not be so few, and that a part goes through itself that did
%   not before.
%
%   @error geometry_error(mesh(crosses_itself(S, P))): polygon P has no
%          triangles, and would be missing

simplified_roots(Faces) :-
    facts_transaction(sg_simplify:roots_simplified(Faces)).

roots_simplified(Faces) :-
    roots_alone,
    complete_segments,
    findall(S, ( root_segment(S), \+ \+ p(S, _, _) ), Ss0),
    sort(Ss0, Ss),
    aggregate_all(count, ( member(S, Ss), t(S, _, _, _, _, _) ), Before),
    (   Before =< Faces
    ->  true
    ;   maplist(has_all_triangles, Ss),
        segments_meeting_themselves(Ss, Met),
        setup_call_cleanup(
            simplified_open(Ss, Simplified),
            made_simple(Ss, Met, Faces, Simplified, Left),
            simplified_close(Simplified)),
        print_message(informational,
                      sanggwan(simplify(made(Left, Before)))),
        (   Left =< Faces
        ->  true
        ;   print_message(warning, sanggwan(simplify(not_fewer(Faces, Left))))
        )
    ).

has_all_triangles(S) :-
    (   p(S, P, _),
        crosses_itself(S, P)
    ->  throw(error(geometry_error(mesh(crosses_itself(S, P))), _))
    ;   true
    ).

made_simple(Ss, Met, Faces, Simplified, Left) :-
    maplist(known_as, Ss, Knowns),
    most_runs(Most),
    made_again(Most, Ss, Met, Faces, Simplified, Left, Meeting),
    maplist(known_again, Ss, Knowns),
    forall(member(S, Meeting),
           ( segment(S, _, Name),
             print_message(warning,
                           sanggwan(simplify(meets_itself(S, Name)))) )).

%   made_again(Runs, Ss, Met, Faces, Simplified, Left, Meeting): Meeting go
%   through themselves after all, and are not among those that did before.

made_again(Runs0, Ss, Met, Faces, Simplified, Left, Meeting) :-
    simplified_run(Simplified, Faces, Left0),
    maplist(drop_boundary, Ss),
    maplist(simplified_add(Simplified), Ss),
    complete_segments,
    segments_meeting_themselves(Ss, Meeting0),
    ord_subtract(Meeting0, Met, Meeting1),
    Runs is Runs0-1,
    (   Meeting1 \== [],
        Runs > 0
    ->  maplist(meeting_weighed(Simplified), Meeting1),
        made_again(Runs, Ss, Met, Faces, Simplified, Left, Meeting)
    ;   Left = Left0,
        Meeting = Meeting1
    ).

meeting_weighed(Simplified, S) :-
    findall(V,
            ( self_meeting(_, S, P1, P2),
              member(P, [P1,P2]),
              p(S, P, Es),
              member(E, Es),
              e(S, E, V, _, _) ),
            Vs0),
    sort(Vs0, Vs),
    matters_more(Factor),
    simplified_weigh(Simplified, S, Vs, Factor).

%   known_as(S, Known): what stays of S, known(Grain, Kind, Name).

known_as(S, known(Grain, Kind, Name)) :-
    segment(S, Kind, Term),
    segment_grain(S, Grain),
    plain_name(Term, Name).

known_again(S, known(Grain, Kind, Name)) :-
    retractall_facts(segment(S, _, _)),
    assert_fact(segment(S, Kind, Name)),
    retractall_facts(origin(S, _, _)),
    source_noted(S, Grain).
