:- module(sg_glue_grown,
          [ glue_grown/2                % +S, +Tolerance
          ]).
:- use_module('../csg/csg', [complete_leaf/4]).
:- use_module('../csg/csg_record', [record/2]).
:- use_module('../csg/csg_rows', [drop_views/1]).
:- use_module('../csg/csg_term', [is_node_term/1]).
:- use_module('../csg/source', [source_kept/3]).
:- use_module('../decision', [decision_is_default/1]).
:- use_module(faces, [faces_merged/2]).
:- use_module(glue_whole, [is_elsewhere/1]).
:- use_module('../gluing/glue_choice', [choice_made/1]).
:- use_module('../kernel',
              [ cell_added/4, changed_leaves/3, newer_segments/3,
                segments_tolerance/3, solid_close/1, solid_take/2
              ]).
:- use_module('../polygon/triangulation', [complete_segments/1]).
:- use_module('../primitive/primitive', [is_primitive/1]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [segment/3, origin/3, segment_stamp/2, facts_transaction/1]).
:- use_module(library(apply), [maplist/2]).
:- use_module(library(lists), [append/3, is_set/1, member/2]).
/** <module> A glue that got more operands: only what is near them changes.

Where an operand more is a solid that meets the glue in equal features alone,
and makes one region more, or fills one, the rows are those that the glue of
all would have. What it takes depends on what is near (cell_added/4), but for
one look at the rows. In all other cases the glue is made anew.

@see c_kernels/gluing/cell_added.h
*/

%!  glue_grown(+S, +Tolerance) is semidet.
%
%   True when segment S is a glue that has got operands after those that its
%   rows were made from, with this Tolerance (evaluate/2), and now they are made
%   from these too. Else it fails, and nothing has changed.

glue_grown(S, Tolerance) :-
    segment(S, cells, glue(Operands)),
    origin(S, node(S), evaluated(made(glue(Known, Tolerance0, []), Stamp))),
    Tolerance0 == Tolerance,
    segment_stamp(S, Stamp),
    append(Known, News, Operands),
    few(News),
    are_new(News, Known),
    changed_leaves(Known, Stamp, Others),
    newer_segments(Others, Stamp, []),
    maplist(is_as_made, Others),
    decision_is_default(disk_relation/3),
    \+ choice_made(S),
    \+ is_elsewhere(S),
    facts_transaction(sg_glue_grown:grown(S, News, Tolerance)),
    record(S, evaluated(glue(Operands, Tolerance, []))).

%   few(News): with more of them, all at once is faster.

few(News) :-
    length(News, N),
    N > 0,
    N < 8.

are_new(News, Known) :-
    maplist(integer, News),
    is_set(News),
    \+ ( member(New, News), memberchk(New, Known) ).

%   is_as_made(S): there is nothing to be made of operand S.

is_as_made(S) :-
    segment(S, _, Term),
    \+ is_node_term(Term),
    \+ is_primitive(Term),
    !.

grown(S, News, Tolerance) :-
    drop_views(S),
    maplist(operand_added(S, Tolerance), News).

operand_added(S, Tolerance, N) :-
    complete_leaf(S, N, solid, Incomplete),
    complete_segments(Incomplete),
    \+ is_elsewhere(N),
    reach_kept(Tolerance, S, N, Reach, Merging),
    solid_take([N], Solid),
    call_cleanup(
        ( stage(faces, faces_merged(Solid,
                                    [ tolerance(Merging), origins(separate),
                                      cells(true)
                                    ])),
          stage(join, cell_added(S, N, Solid, Reach))
        ),
        solid_close(Solid)),
    source_kept([S,N], 1, S).

%   reach_kept(Tolerance, S, N, Reach, Merging): what is near is what it was
%   before solid N came.

reach_kept(default, S, N, Reach, own(Reach)) :-
    !,
    sort([S,N], Both),
    segments_tolerance([S], Reach, _),
    segments_tolerance(Both, Now, _),
    Now =:= Reach.
reach_kept(Tolerance, _, N, Tolerance, Tolerance) :-
    number(Tolerance),
    segments_tolerance([N], _, Smallest),
    Tolerance =< Smallest/16.
