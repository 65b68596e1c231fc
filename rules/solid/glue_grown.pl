:- module(sg_glue_grown,
          [ glue_grown/2                % +S, +Tolerance
          ]).
:- use_module('../csg/csg', [complete_leaf/4]).
:- use_module('../csg/csg_record', [record/2]).
:- use_module('../csg/csg_rows', [drop_views/1, was_cut/1]).
:- use_module('../csg/csg_term', [is_node_term/1]).
:- use_module('../csg/source', [source_kept/3]).
:- use_module('../decision', [decision_is_default/1]).
:- use_module(faces, [faces_merged/2]).
:- use_module(glue_left, [operand_gone/3, made_first/4, made_vertices/2]).
:- use_module(glue_whole, [is_elsewhere/1]).
:- use_module('../gluing/glue_choice', [choice_made/1]).
:- use_module('../kernel',
              [ cell_added/5, changed_leaves/3, newer_segments/3,
                segments_tolerance/3, solid_close/1, solid_take/2
              ]).
:- use_module('../polygon/triangulation', [complete_segments/1]).
:- use_module('../primitive/primitive', [is_primitive/1]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [ segment/3, origin/3, gluing/2, segment_stamp/2,
                facts_transaction/1 ]).
:- use_module(library(apply), [exclude/3, foldl/4, maplist/2]).
:- use_module(library(lists), [same_length/2]).
:- use_module(library(ordsets), [ord_union/3]).
/** <module> A glue whose operands came, went or changed: only what is near them
changes.

Where an operand more is a solid that meets the glue in equal features alone,
and makes one region more, or fills one, the rows are those that the glue of
all would have. What it takes depends on what is near (cell_added/5), but for
one look at the rows; what was cut elsewhere does not matter. An operand that
goes takes with it what only it had (glue_left.pl); one that changed goes, and
comes as it is now. If that is the last one, ids are those of the glue of all
too. In all other cases the glue is made anew.

@see c_kernels/gluing/cell_added.h
*/

%!  glue_grown(+S, +Tolerance) is semidet.
%
%   True when segment S is a glue some of whose operands came, went or changed
%   after its rows were made, with this Tolerance (evaluate/2), and now they are
%   made from those that are. Else it fails, and nothing has changed.

glue_grown(S, Tolerance) :-
    segment(S, cells, glue(Operands)),
    findall(Wish, gluing(S, Wish), Wishes),
    From = glue(Known, Tolerance0, Wishes0),
    origin(S, node(S), evaluated(made(From, Stamp))),
    Tolerance0-Wishes0 == Tolerance-Wishes,
    segment_stamp(S, Stamp),
    operands_compared(Known, Operands, Stayed, Gone, News0),
    changed_leaves(Stayed, Stamp, Others),
    newer_segments(Others, Stamp, Newer),
    exclude(is_as_made(Newer), Others, Changed0),
    sort(Changed0, Changed),
    ord_union(Changed, Gone, Leaving),
    ord_union(Changed, News0, News),
    few(Leaving, News),
    maplist(is_leaf, News),
    decision_is_default(disk_relation/3),
    \+ choice_made(S),
    \+ was_cut(S),
    sort(0, @>=, Stayed, [Last|_]),
    facts_transaction(sg_glue_grown:grown(S, Last, Leaving, News, Tolerance)),
    record(S, evaluated(glue(Operands, Tolerance, Wishes))).

%   operands_compared(Known, Operands, Stayed, Gone, News): as sets. Mostly they
%   differ in few places, and both are in order.

operands_compared(Known, Operands, Stayed, Gone, News) :-
    sort(Known, Set0),
    sort(Operands, Set),
    same_length(Set, Operands),
    sets_compared(Set0, Set, Stayed, Gone, News),
    Stayed \== [],
    maplist(integer, News).

%   sets_compared(Set0, Set, Stayed, Gone, News): the end that both have is
%   looked at by one comparison.

sets_compared(Set, Set1, Stayed, Gone, News) :-
    Set == Set1,
    !,
    Stayed = Set,
    Gone = [],
    News = [].
sets_compared(Set0, Set, Stayed, Gone, News) :-
    sets_differ(Set0, Set, Stayed, Gone, News).

sets_differ([], News, [], [], News) :-
    !.
sets_differ(Gone, [], [], Gone, []) :-
    !.
sets_differ([X|Xs], [Y|Ys], Stayed, Gone, News) :-
    compare(Order, X, Y),
    sets_differ(Order, X, Xs, Y, Ys, Stayed, Gone, News).

sets_differ(=, X, Xs, _, Ys, [X|Stayed], Gone, News) :-
    sets_differ(Xs, Ys, Stayed, Gone, News).
sets_differ(<, X, Xs, Y, Ys, Stayed, [X|Gone], News) :-
    sets_compared(Xs, [Y|Ys], Stayed, Gone, News).
sets_differ(>, X, Xs, Y, Ys, Stayed, Gone, [Y|News]) :-
    sets_compared([X|Xs], Ys, Stayed, Gone, News).

is_leaf(S) :-
    segment(S, _, Term),
    \+ is_node_term(Term),
    !.

%   few(Leaving, News): with more of them, all at once is faster.

few(Leaving, News) :-
    length(Leaving, M),
    length(News, N),
    M+N > 0,
    M+N < 8.

%   is_as_made(Newer, S): operand S is none of Newer, and there is nothing to be
%   made of it.

is_as_made(Newer, S) :-
    \+ memberchk(S, Newer),
    is_leaf(S),
    once(segment(S, _, Term)),
    \+ is_primitive(Term).

%   grown(S, Last, Leaving, News, Tolerance): Last is the greatest of those that
%   stay.

grown(S, Last, Leaving, News, Tolerance) :-
    drop_views(S),
    foldl(last_first, Leaving, [], Reversed),
    maplist(operand_gone(S, Tolerance), Reversed),
    maplist(operand_added(S, Last, Tolerance), News).

last_first(N, Ns, [N|Ns]).

operand_added(S, Last, Tolerance, N) :-
    complete_leaf(S, N, solid, Incomplete),
    complete_segments(Incomplete),
    \+ is_elsewhere(N),
    made_vertices(S, Made),
    reach_kept(Tolerance, S, N, Reach, Merging),
    solid_take([N], Solid),
    call_cleanup(
        ( stage(faces, faces_merged(Solid,
                                    [ tolerance(Merging), origins(separate),
                                      cells(true)
                                    ])),
          stage(join, cell_added(S, N, Solid, Reach, Made))
        ),
        solid_close(Solid)),
    (   N > Last
    ->  true
    ;   made_first(S, N, Reach, Merging)
    ),
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
