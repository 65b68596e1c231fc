:- module(sg_entering,
          [ enter_polygons/4,           % :Keep, +Set, +Polygons, -Works
            enter_by_rule/4,            % +Set, +S, +P, +Work
            stays_entered/1,            % +Set
            close_works/1               % +Works
          ]).
:- use_module(joints, [merge_near_lines/2, has_near_lines/1]).
:- use_module('../kernel',
              [ cut_entering/4, cut_enter_free/4, cut_queue/2,
                cut_enter_queued/2, cut_work/4, cut_crossing/8, cut_note/5,
                cut_between/6, cut_divided/4, cut_agree/1, cut_was_divided/1,
                cut_late_polygons/2, work_add/6, work_delete/2, work_edge/6,
                work_meeting/6, work_close/1
              ]).
:- use_module(library(apply), [maplist/2]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(ordsets), [ord_subtract/3]).
/** <module> Entering: pieces of lines become edges of polygons.

Each piece of a cut enters both its polygons as an edge pair, so that the
polygons stay what they are: sets of directed edges. Against the edges that are
there it is divided, dropped where it is contained. What was divided in one
polygon is divided in all.

@see [PL] section 5.2; row PL-8 of the requirements
*/

:- meta_predicate enter_polygons(1, +, +, -).

%!  enter_polygons(:Keep, +Set, +Polygons:list, -Works:list) is det.
%
%   The pieces of the cut set Set enter Polygons, a list of S-P. Works are
%   work(S, P, Work), to be closed. call(Keep, Others) is told which polygons
%   are opened beside those, before they are.

enter_polygons(Keep, Set, Polygons, Works) :-
    enter_all(Set, Polygons, Works0),
    agree(Keep, Set, Works0, Works),
    merge_near_lines(Set, Works).

%!  stays_entered(+Set) is semidet.
%
%   True when nothing more happens to polygons of Set once all lines have
%   entered and have met nothing there: nothing was divided anywhere, and no
%   joint is nearly straight.

stays_entered(Set) :-
    \+ cut_was_divided(Set),
    \+ has_near_lines(Set).

%!  close_works(+Works) is det.
%
%   Closes them, if Works is a list that was made.

close_works(Works) :-
    (   ground(Works)
    ->  maplist(close_work, Works)
    ;   true
    ).

close_work(work(_, _, Work)) :-
    work_close(Work).

/* - - - steps 4 and 5: entering a polygon - - - */

%   A polygon's edges, those on which an end of a cut lies already divided
%   there, go into a scratch relation, and then the pieces of cuts one by one.

%   cut_enter_free/4 is the fused kernel for those that meet nothing, and
%   cut_enter_queued/2 does all of these up to one that does.

enter_all(Set, Polygons, Works) :-
    cut_queue(Set, Polygons),
    enter_queued(Set, Polygons, Works).

enter_queued(Set, Polygons, Works) :-
    cut_enter_queued(Set, Free),
    entered(Free, Polygons, Others, Works, Works1),
    (   Others = [Polygon|Others1]
    ->  enter_cuts(Set, Polygon, Work),
        Works1 = [Work|Works2],
        enter_queued(Set, Others1, Works2)
    ;   Works1 = []
    ).

entered([], Polygons, Polygons, Works, Works).
entered([Work|Free], [S-P|Polygons], Others, [work(S, P, Work)|Works], End) :-
    entered(Free, Polygons, Others, Works, End).

enter_cuts(Set, S-P, work(S, P, Work)) :-
    cut_work(Set, S, P, Work),
    (   cut_enter_free(Set, S, P, Work)
    ->  true
    ;   enter_by_rule(Set, S, P, Work)
    ).

%!  enter_by_rule(+Set, +S, +P, +Work) is det.
%
%   All pieces of polygon P of segment S enter Work.

enter_by_rule(Set, S, P, Work) :-
    cut_entering(Set, S, P, Pieces),
    maplist(enter_piece(Set, S, P, Work), Pieces).

enter_piece(Set, S, P, Work, piece(K, V1, V2)) :-
    enter(auxiliary(Set, S, Work, K, P-[]), V1, V2).

%   (1) V1-V2 is an auxiliary segment, (2) the one chosen. (3-1) While an edge
%   contains or crosses it, it is divided and its parts are entered; (3-2)
%   when none does, it joins the polygon as an edge pair. What was divided in
%   another polygon is divided there first, edges too: so everything is
%   divided in the same points and in the same order, wherever it is.

enter(Auxiliary, V1, V2) :-
    Auxiliary = auxiliary(Set, S, Work, _, _),
    (   cut_between(Set, Work, S, V1, V2, X)
    ->  enter_both(Auxiliary, V1, X, V2)
    ;   work_meeting(Work, V1, V2, E, How, Inside),
        meeting_step(How, Inside, Step)
    ->  enter_step(Step, E, Auxiliary, V1, V2)
    ;   add_pair(Auxiliary, V1, V2)
    ).

%   What a meeting asks for. First the edge is divided where an end of the
%   segment lies inside it, then the segment where an end of the edge does.
%   After that only a crossing is left, or an edge that is the segment itself.

meeting_step(crosses, _, crossing) :-
    !.
meeting_step(_, Inside, divide_edge(End)) :-
    member(End, [v1,v2]),
    memberchk(End, Inside),
    !.
meeting_step(_, Inside, divide_segment(End)) :-
    member(End, [start,end]),
    memberchk(End, Inside),
    !.
meeting_step(contained, _, drop).

enter_step(Step, E, Auxiliary, V1, V2) :-
    edge_to_divide(Step),
    Auxiliary = auxiliary(Set, S, Work, _, _),
    work_edge(Work, E, A, B, _, _),
    cut_between(Set, Work, S, A, B, X),
    !,
    divide_pair(Auxiliary, E, X),
    enter(Auxiliary, V1, V2).

%   2-2: both are cut in the point where they cross.

enter_step(crossing, E, Auxiliary, V1, V2) :-
    Auxiliary = auxiliary(Set, S, Work, K, _),
    cut_crossing(Set, Work, S, K, E, V1, V2, X),
    divide_pair(Auxiliary, E, X),
    enter_parts(Auxiliary, V1, X, V2).
enter_step(divide_edge(End), E, Auxiliary, V1, V2) :-
    (   End == v1
    ->  X = V1
    ;   X = V2
    ),
    divide_pair(Auxiliary, E, X),
    enter(Auxiliary, V1, V2).
enter_step(divide_segment(End), E, Auxiliary, V1, V2) :-
    Auxiliary = auxiliary(_, _, Work, _, _),
    work_edge(Work, E, Start, Finish, _, _),
    (   End == start
    ->  X = Start
    ;   X = Finish
    ),
    enter_parts(Auxiliary, V1, X, V2).

%   2-1: the contained part is dropped.

enter_step(drop, _, _, _, _).

edge_to_divide(crossing).
edge_to_divide(divide_edge(_)).

enter_parts(Auxiliary, V1, X, V2) :-
    Auxiliary = auxiliary(Set, S, _, _, _),
    cut_note(Set, S, V1, V2, X),
    enter_both(Auxiliary, V1, X, V2).

%   In a polygon that is far from flat the points on a piece need not be in
%   line, and then have no order: no end of a part may come back inside it.

enter_both(auxiliary(Set, S, Work, K, P-Ends), V1, X, V2) :-
    (   memberchk(X, [V1,V2|Ends])
    ->  throw(error(geometry_error(polygon_edge(S, P, V1, V2)), _))
    ;   Auxiliary = auxiliary(Set, S, Work, K, P-[V1,V2|Ends]),
        enter(Auxiliary, V1, X),
        enter(Auxiliary, X, V2)
    ).

%   The edges of a cut have the number of its piece as label, below zero; the
%   polygon's own have the number of the edge they are or were part of.

add_pair(auxiliary(_, _, Work, K, _), V1, V2) :-
    Label is -1-K,
    work_add(Work, V1, V2, 1, Label, _),
    work_add(Work, V2, V1, 1, Label, _).

%   divide_pair(+Auxiliary, +E, +X): E, and the opposite edge if it is there
%   too, gets X between its ends.

divide_pair(auxiliary(Set, S, Work, _, _), E, X) :-
    work_edge(Work, E, V1, V2, _, _),
    cut_note(Set, S, V1, V2, X),
    divide_at(Work, E-X),
    findall(Opposite-X, work_edge(Work, Opposite, V2, V1, _, _), Opposites),
    maplist(divide_at(Work), Opposites).

divide_at(Work, E-X) :-
    work_edge(Work, E, V1, V2, Et, Label),
    !,
    work_delete(Work, E),
    work_add(Work, V1, X, Et, Label, _),
    work_add(Work, X, V2, Et, Label, _).

/* - - - the same pieces everywhere - - - */

%   A segment that was divided in one polygon is divided in every other one: in
%   those that are open, and in those beside a real edge that no cut had opened.

agree(Keep, Set, Works0, Works) :-
    cut_agree(Set),
    (   cut_was_divided(Set)
    ->  maplist(agree_polygon(Set), Works0),
        late_polygons(Set, Works0, Polygons),
        call(Keep, Polygons),
        enter_all(Set, Polygons, Late),
        append(Works0, Late, Works)
    ;   Works = Works0                  % mostly
    ).

late_polygons(Set, Works, Polygons) :-
    cut_late_polygons(Set, Polygons0),
    (   Polygons0 == []
    ->  Polygons = []
    ;   sort(Polygons0, Polygons1),
        findall(S-P, member(work(S, P, _), Works), Open0),
        sort(Open0, Open),
        ord_subtract(Polygons1, Open, Polygons)
    ).

agree_polygon(Set, work(S, P, Work)) :-
    cut_divided(Set, Work, S, Divided),
    (   Divided == []
    ->  true
    ;   maplist(agree_at(S, P, Work), Divided),
        agree_polygon(Set, work(S, P, Work))
    ).

%   As in enter_both/4: a part that is there already comes back for ever.

agree_at(S, P, Work, E-X) :-
    work_edge(Work, E, V1, V2, _, Label),
    !,
    (   (   work_edge(Work, _, V1, X, _, Label)
        ;   work_edge(Work, _, X, V2, _, Label)
        )
    ->  throw(error(geometry_error(polygon_edge(S, P, V1, V2)), _))
    ;   divide_at(Work, E-X)
    ).
