:- module(sg_arrangement,
          [ with_arrangement/3,         % +Leaves, +Options, :Goal
            components/2,               % +Arrangement, -Components
            arranged_solid/3,           % +Arrangement, +Senses, -Solid
            default_senses/4,           % +Arrangement, +Expression, +Open,
                                        % -Senses
            contact_vertices/2,         % +Arrangement, -Contacts
            pieces_dropped/0,
            pieces_numbers/2,           % +Arrangement, -Numbers
            pieces_changed/3,           % +Arrangement, +Numbers, -Changed
            leaves_around/3,            % +Arrangement, +Leaves, -Around
            part_of_arrangement/3,      % +Arrangement, +Leaves, -Part
            pieces_statistics/1         % -Statistics
          ]).
:- use_module('../kernel',
              [ arrangement_open/5, arrangement_hold/1, arrangement_drop/1,
                arrangement_polygons/3, arrangement_free_polygons/3,
                arrangement_seal/1,
                arrangement_components/2, arrangement_select/3,
                arrangement_senses/4, arrangement_numbers/2,
                pieces_kept/1, keep_pieces/1, trees_dropped/0,
                contact_places/2, near_pairs/3, near_segments_of/3,
                segments_meeting_themselves/2,
                segments_tolerance/3
              ]).
:- use_module('../penetration/entering',
              [enter_polygons/4, close_works/1, stays_entered/1]).
:- use_module('../csg/leaf', [were_cut/2]).
:- use_module('../penetration/penetration', [leaf_lines/4, touching/3]).
:- use_module('../penetration/resolve', [tolerance_reach/2]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [ v/5, e/5, p/3, segment/3, segment_stamps/2, segments_key/2,
                facts_snapshot/1
              ]).
% Loaded with this file, not by the first Boolean that calls them.
:- use_module(library(assoc),
              [ assoc_to_keys/2, assoc_to_values/2, del_assoc/4, empty_assoc/1,
                get_assoc/3, list_to_assoc/2,
                ord_list_to_assoc/2, put_assoc/4
              ]).
:- use_module(library(ordsets), [ord_subtract/3, ord_union/3]).
:- use_module(library(pairs), [pairs_keys/2, pairs_keys_values/3]).
:- use_module(library(apply), [exclude/3, foldl/4, maplist/2, maplist/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(option), [option/2]).
/** <module> Arrangements: leaves cut along all their lines, in pieces.

The leaves of a CSG tree are arranged once, and any expression over them then
only selects: nothing is rounded between two operations, and no cut is made
twice.

The pieces of a leaf depend on that leaf and on those near it. They are kept
with the world under the stamps of these; a leaf that is edited, or moved, makes
stale what it is near to and was near to, and nothing else. Where leaves were
made to touch (resolve.pl) they are connected: all of them are stale at once,
since a vertex that they share is shared by moving it.

@see c_kernels/solid/arrangement.h; rows CB-1, CB-3 and CB-4
*/

:- meta_predicate with_arrangement(+, +, 1).

%!  with_arrangement(+Leaves:list, +Options:list, :Goal) is semidet.
%
%   Call Goal with an arrangement of the segments Leaves added, which is good
%   for this call only. The world stays as it is. Option:
%
%     - tolerance(Tolerance)
%     What is nearer than this (model units) is made to touch first. Default:
%     as segments_tolerance/3 sees the leaves.
%
%   @error geometry_error(undivided(S, P, X, Y, Z, Tolerance)): with its lines,
%          P cannot be triangulated there; or polygon_edge(S, P, V1, V2), if
%          nothing may be moved

with_arrangement(Leaves0, Options, Goal) :-
    sort(Leaves0, Leaves),
    leaves_tolerance(Leaves, Options, Tolerance),
    tolerance_reach(Tolerance, Reach),
    near_segments_of(Reach, Leaves, NearPairs),
    ord_list_to_assoc(NearPairs, Near),
    maplist(leaf_key(Tolerance), NearPairs, Keys),
    setup_call_cleanup(
        with_mutex(sg_pieces, held(Kept, Held)),
        ( current(Leaves, Keys, Kept, Current0, Contacts0, Stale0),
          connected(Stale0, Near, Kept, Stale),
          include_current(Current0, Stale, Current),
          counted(sg_pieces_made, Stale),
          counted(sg_pieces_found, Current),
          catch(fresh_pieces(Stale, Near, Tolerance, Fresh, Touch),
                error(geometry_error(Fault), Context),
                undivided(Fault, Context, Reach)),
          setup_call_cleanup(
              true,
              ( keep(Leaves, Keys, Fresh, Touch),
                append(Current, Fresh, Pieces0),
                sort(1, @<, Pieces0, Pieces),
                contacts(Contacts0, Stale, Touch, Contacts),
                call(Goal, arrangement(Pieces, Contacts, Near))
              ),
              drop_fresh(Fresh))
        ),
        maplist(arrangement_drop, Held)).

%   undivided(Fault, Context, Reach): Fault is thrown with its place.

undivided(polygon_edge(S, P, V1, V2), _, Reach) :-
    Reach > 0,
    (   member(V, [V1,V2])
    ;   p(S, P, Es),
        member(E0, Es),
        E is abs(E0),
        e(S, E, V, _, _)
    ),
    v(S, V, X, Y, Z),
    !,
    throw(error(geometry_error(undivided(S, P, X, Y, Z, Reach)), _)).
undivided(Fault, Context, _) :-
    throw(error(geometry_error(Fault), Context)).

leaves_tolerance(Leaves, Options, Tolerance) :-
    (   option(tolerance(_), Options)
    ->  touching(Options, Leaves, Tolerance)
    ;   segments_tolerance(Leaves, Reach, _),
        Tolerance = own(Reach)
    ).

counted(Flag, Leaves) :-
    length(Leaves, N),
    flag(Flag, N0, N0+N).

drop_fresh([_-Arrangement|_]) :-        % all the same one
    arrangement_drop(Arrangement).
drop_fresh([]).

/* - - - what is near what - - - */

%   Near is an assoc from each leaf to those near it, in order. A leaf's pieces
%   depend on these.

leaf_key(Tolerance, S-Others, key(Tolerance, Key)) :-
    segments_key([S|Others], Key).

/* - - - what is kept - - - */

%   kept(-Kept): an assoc from leaves to their last two
%   entry(Key, Arrangement, Cluster, Contacts), the newest first.

%
%   What is kept is held, once for each entry. Two threads may be at it in one
%   world, so it is only looked at or exchanged under the mutex sg_pieces.

kept(Kept) :-
    (   pieces_kept(Kept0)
    ->  Kept = Kept0
    ;   empty_assoc(Kept)
    ).

%   held(-Kept, -Held): all arrangements in Kept are held; Held: to be dropped.

held(Kept, Held) :-
    kept(Kept),
    assoc_to_values(Kept, Entries),
    findall(A, ( member(Es, Entries), member(entry(_, A, _, _), Es) ), As),
    sort(As, Held),
    maplist(arrangement_hold, Held).

entries(S, Kept, Entries) :-
    (   get_assoc(S, Kept, Entries0)
    ->  Entries = Entries0
    ;   Entries = []
    ).

%   current(+Leaves, +Keys, +Kept, -Current, -Contacts, -Stale): Current has
%   S-Arrangement of those that are kept under their keys, and Contacts S-Places
%   of those among them that have some.

current([], [], _, [], [], []).
current([S|Ss], [Key|Keys], Kept, Current, Contacts, Stale) :-
    entries(S, Kept, Entries),
    (   memberchk(entry(Key, Arrangement, _, Places), Entries)
    ->  Current = [S-Arrangement|Current1],
        Stale = Stale1,
        (   Places == []
        ->  Contacts = Contacts1
        ;   Contacts = [S-Places|Contacts1]
        )
    ;   Current = Current1,
        Contacts = Contacts1,
        Stale = [S|Stale1]
    ),
    current(Ss, Keys, Kept, Current1, Contacts1, Stale1).

%   connected(+Stale0, +Near, +Kept, -Stale): with every leaf, and every
%   one near it, those it was made to touch.

connected(Stale0, Near, Kept, Stale) :-
    around(Stale0, Near, Around),
    findall(S,
            ( member(A, Around),
              entries(A, Kept, Entries),
              member(entry(_, _, Cluster, _), Entries),
              member(S, Cluster),
              get_assoc(S, Near, _)
            ),
            Touching0),
    sort(Touching0, Touching),
    ord_union(Stale0, Touching, Stale1),
    (   Stale1 == Stale0
    ->  Stale = Stale0
    ;   connected(Stale1, Near, Kept, Stale)
    ).

around(Ss, Near, Around) :-
    findall(A,
            ( member(S, Ss),
              (   A = S
              ;   get_assoc(S, Near, Others),
                  member(A, Others)
              )
            ),
            Around0),
    sort(Around0, Around).

include_current(Current0, Stale, Current) :-
    parted(Current0, Stale, _, Current).

%   parted(+Pairs, +Ss, -Of, -Others): the S-X of Pairs with S in Ss, and the
%   others; both ascend.

parted([], _, [], []).
parted([S-X|Pairs], Ss0, Of, Others) :-
    from(Ss0, S, Ss),
    (   Ss = [S|_]
    ->  Of = [S-X|Of1],
        Others = Others1
    ;   Of = Of1,
        Others = [S-X|Others1]
    ),
    parted(Pairs, Ss, Of1, Others1).

from([S0|Ss0], S, Ss) :-
    S0 < S,
    !,
    from(Ss0, S, Ss).
from(Ss, _, Ss).

%   set_of(+Ss, -Set): an assoc with them as its keys.

set_of(Ss, Set) :-
    pairs_keys_values(Pairs, Ss, Ss),
    ord_list_to_assoc(Pairs, Set).

%   keep(+Leaves, +Keys, +Fresh, +Touch): Fresh is kept, for the third last
%   of a leaf, and for those of segments that are there no more.

keep(_, _, [], _) :-
    !.
keep(Leaves, Keys, Fresh, Touch) :-
    fresh_keys(Fresh, Leaves, Keys, Pairs),
    list_to_assoc(Pairs, KeyOf),
    with_mutex(sg_pieces, exchanged(Leaves, KeyOf, Touch, Fresh, Old)),
    maplist(arrangement_drop, Old).

%   fresh_keys(+Fresh, +Leaves, +Keys, -Pairs): S-Key of those in Fresh, which
%   are Leaves; both ascend.

fresh_keys([], _, _, []) :-
    !.
fresh_keys([S-_|Fresh], [S|Ss], [Key|Keys], Pairs) :-
    !,
    Pairs = [S-Key|Pairs1],
    fresh_keys(Fresh, Ss, Keys, Pairs1).
fresh_keys(Fresh, [_|Ss], [_|Keys], Pairs) :-
    fresh_keys(Fresh, Ss, Keys, Pairs).

%   exchanged(+Leaves, +KeyOf, +Touch, +Fresh, -Old): Leaves are alive.

exchanged(Leaves, KeyOf, Touch, Fresh, Old) :-
    kept(Kept0),
    assoc_to_keys(Kept0, Ss),
    ord_subtract(Ss, Leaves, Others),
    exclude(is_alive, Others, Gone),
    findall(A, ( member(S, Gone), get_assoc(S, Kept0, Es),
                 member(entry(_, A, _, _), Es) ),
            Old0),
    foldl(forget_leaf, Gone, Kept0, Kept1),
    Touch = touch(Clusters, Touched0),
    findall(S-Cluster, ( member(Cluster, Clusters), member(S, Cluster) ),
            Connected0),
    maplist(list_to_assoc, [Connected0,Touched0], [Connected,Touched]),
    foldl(keep_leaf(KeyOf, Connected, Touched), Fresh, Kept1-Old0, Kept-Old),
    keep_pieces(Kept).

is_alive(S) :-
    segment(S, _, _),
    !.
is_alive(S) :-
    v(S, _, _, _, _),
    !.

forget_leaf(S, Kept0, Kept) :-
    del_assoc(S, Kept0, _, Kept).

keep_leaf(KeyOf, Connected, Touched, S-Arrangement, Kept0-Old0, Kept-Old) :-
    get_assoc(S, KeyOf, Key),
    entries(S, Connected, Cluster),
    entries(S, Touched, Contacts),
    entries(S, Kept0, Entries0),
    arrangement_hold(Arrangement),
    (   Entries0 = [Last,entry(_, Gone, _, _)|_]
    ->  Entries = [entry(Key, Arrangement, Cluster, Contacts),Last],
        Old = [Gone|Old0]
    ;   Entries = [entry(Key, Arrangement, Cluster, Contacts)|Entries0],
        Old = Old0
    ),
    put_assoc(S, Kept0, Entries, Kept).

%   contacts(+Kept, +Stale, +Touch, -Contacts): the vertices that leaves have in
%   pieces alone, as S-Places, of those that have some (contact_places/2): what
%   is kept of leaves that are not Stale, and what is new.

contacts(Kept, Stale, touch(_, Touched), Contacts) :-
    parted(Kept, Stale, _, Old),
    parted(Touched, Stale, New, _),
    append(Old, New, Contacts).

/* - - - new pieces - - - */

%   fresh_pieces(+Stale, +Near, +Tolerance, -Fresh, -Touch): what is near stale
%   leaves is cut with them, so that all lines that meet one of theirs are
%   there.
%   Touch: touch(Clusters, Touched), those that were made to touch, as lists,
%   and the vertices they got for that.

fresh_pieces([], _, _, [], touch([], [])) :-
    !.
fresh_pieces(Stale, Near, Tolerance, Fresh, touch(Clusters, Touched)) :-
    around(Stale, Near, Segments),
    tolerance_reach(Tolerance, Reach),
    near_pairs(Reach, Segments, Different),
    selves(Segments, Selves),
    ord_union(Different, Selves, Pairs),
    segment_stamps(Segments, Stamps),
    facts_snapshot(sg_arrangement:arranged(Pairs, Stamps, Stale,
                                           Tolerance, Arrangement,
                                           Changed-Touched)),
    findall(S-Arrangement, member(S, Stale), Fresh),
    clusters(Changed, Near, Clusters).

%   selves(+Segments, -Selves): S-S of those that are to be cut by themselves:
%   then winding decides what of them is inside.

selves(Segments, Selves) :-
    stage(self, segments_meeting_themselves(Segments, Meeting0)),
    set_of(Meeting0, Meeting),
    findall(S-S,
            ( member(S, Segments),
              (   get_assoc(S, Meeting, _)
              ->  true
              ;   were_cut(S, S)
              )
            ),
            Selves).

arranged(Pairs, Stamps, Wanted, Tolerance, Arrangement, Changed) :-
    leaf_lines(Pairs, Wanted, Tolerance,
               sg_arrangement:in_pieces(Stamps, Wanted, Tolerance,
                                        Arrangement, Changed)).

in_pieces(Stamps0, Wanted, Tolerance, Arrangement, Changed-Touched, Set,
          Polygons, Weights) :-
    pairs_keys(Stamps0, Segments),
    segment_stamps(Segments, Stamps),
    ord_subtract(Stamps, Stamps0, ChangedStamps),
    pairs_keys(ChangedStamps, Changed),
    findall(S-Contacts,
            ( member(S, Changed), contact_places(S, Contacts) ),
            Touched),
    tolerance_reach(Tolerance, Reach),
    divided(Set, leaves(Segments, Wanted, Weights), Polygons, Reach,
            Arrangement).

%   divided(+Set, +Leaves, +Polygons, +Tolerance, -Arrangement): mostly lines
%   meet nothing in the polygons that they enter. Then a fused kernel enters and
%   divides them; if there is one that is not so, the rules enter all.

divided(Set, Leaves, Polygons, Tolerance, Arrangement) :-
    stays_entered(Set),
    stage(pieces, filled(Set, Leaves,
                         arrangement_free_polygons(Polygons, Tolerance),
                         Arrangement)),
    !.
divided(Set, Leaves, Polygons, Tolerance, Arrangement) :-
    setup_call_cleanup(
        true,
        ( stage(enter, enter_polygons(is_list, Set, Polygons, Works)),
          stage(pieces, filled(Set, Leaves,
                               arrangement_polygons(Works, Tolerance),
                               Arrangement))
        ),
        close_works(Works)).

%   filled(+Set, +Leaves, +Fill, -Arrangement): it has what Fill puts there.

filled(Set, leaves(Segments, Wanted, Weights), Fill, Arrangement) :-
    arrangement_open(Set, Segments, Wanted, Weights, Arrangement),
    (   catch(( filled_with(Fill, Arrangement),
                arrangement_seal(Arrangement)
              ),
              Error,
              ( arrangement_drop(Arrangement),
                throw(Error)
              ))
    ->  true
    ;   arrangement_drop(Arrangement),
        fail
    ).

filled_with(arrangement_free_polygons(Polygons, Tolerance), Arrangement) :-
    arrangement_free_polygons(Arrangement, Polygons, Tolerance).
filled_with(arrangement_polygons(Works, Tolerance), Arrangement) :-
    arrangement_polygons(Arrangement, Works, Tolerance).

%   clusters(+Changed, +Near, -Clusters): what is connected by being near.

clusters(Changed, Near, Clusters) :-
    set_of(Changed, Left),
    clusters(Changed, Near, Left, Clusters).

clusters([], _, _, []).
clusters([S|Ss], Near, Left0, Clusters) :-
    (   del_assoc(S, Left0, _, Left1)
    ->  connected([S], Near, Cluster0, Left1, Left),
        sort(Cluster0, Cluster),
        Clusters = [Cluster|Clusters1]
    ;   Left = Left0,
        Clusters = Clusters1
    ),
    clusters(Ss, Near, Left, Clusters1).

connected([], _, [], Left, Left).
connected([S|Ss], Near, [S|Cluster], Left0, Left) :-
    get_assoc(S, Near, Others),
    foldl(reached, Others, Ss-Left0, Next-Left1),
    connected(Next, Near, Cluster, Left1, Left).

reached(A, Next0-Left0, Next-Left) :-
    (   del_assoc(A, Left0, _, Left)
    ->  Next = [A|Next0]
    ;   Next = Next0,
        Left = Left0
    ).

/* - - - using it - - - */

%!  components(+Arrangement, -Components:list) is det.
%
%   Components are the component(C, S, P, Point, Sides, Which) of an
%   arrangement: arrangement_components/2.

components(arrangement(Pieces, _, _), Components) :-
    arrangement_components(Pieces, Components).

%!  arranged_solid(+Arrangement, +Senses:list, -Solid) is det.
%
%   Solid is a handle of the boundary that the components C with C-Sense in
%   Senses make, turned over where Sense is -1: arrangement_select/3.

arranged_solid(arrangement(Pieces, _, _), Senses, Solid) :-
    arrangement_select(Pieces, Senses, Solid).

%!  contact_vertices(+Arrangement, -Contacts:list) is det.
%
%   Contacts are S-Places of the leaves that were made to touch others, as of
%   contact_places/2: vertices that they have in pieces alone.

contact_vertices(arrangement(_, Contacts, _), Contacts).

%!  default_senses(+Arrangement, +Expression, +Open:list, -Senses:list) is det.
%
%   Senses as the default of stays/3 says (boolean.pl): its fused kernel.

default_senses(arrangement(Pieces, _, _), Expression, Open, Senses) :-
    phrase(nodes(Expression), Nodes),
    arrangement_senses(Pieces, Nodes, Open, Senses).

%   nodes(Expression)//: its nodes, each before its operands.

nodes(Expression) -->
    (   { compound(Expression),
          compound_name_arguments(Expression, Operation, [Operands]),
          is_list(Operands)
        }
    ->  { length(Operands, N) },
        [node(Operation,N)],
        operand_nodes(Operands)
    ;   [node(leaf,Expression)]
    ).

operand_nodes([]) -->
    [].
operand_nodes([Operand|Operands]) -->
    nodes(Operand),
    operand_nodes(Operands).

%!  pieces_dropped is det.
%
%   Nothing is kept of arrangements and of trees in the current world: there is
%   room for what comes, and the next question makes them again.

pieces_dropped :-
    with_mutex(sg_pieces,
               ( kept(Kept),
                 empty_assoc(None),
                 keep_pieces(None)
               )),
    assoc_to_values(Kept, Entries),
    forall(( member(Es, Entries), member(entry(_, A, _, _), Es) ),
           arrangement_drop(A)),
    trees_dropped.

%!  pieces_numbers(+Arrangement, -Numbers:list) is det.
%
%   Numbers has a number for the pieces of each leaf, ascending by leaves:
%   pieces with the same number are the same.

pieces_numbers(arrangement(Pieces, _, _), Numbers) :-
    arrangement_numbers(Pieces, Numbers).

%!  pieces_changed(+Arrangement, +Numbers:list, -Changed:list) is det.
%
%   Changed are the leaves with other pieces than had Numbers, of an earlier
%   arrangement of the same leaves.

pieces_changed(arrangement(Pieces, _, _), Numbers0, Changed) :-
    arrangement_numbers(Pieces, Numbers),
    changed(Pieces, Numbers0, Numbers, Changed).

changed([], [], [], []).
changed([S-_|Pieces], [Number0|Numbers0], [Number|Numbers], Changed) :-
    (   Number0 == Number
    ->  Changed = Changed1
    ;   Changed = [S|Changed1]
    ),
    changed(Pieces, Numbers0, Numbers, Changed1).

%!  leaves_around(+Arrangement, +Leaves:list, -Around:list) is det.
%
%   Around are Leaves and those near them, ascending.

leaves_around(arrangement(_, _, Near), Leaves, Around) :-
    around(Leaves, Near, Around).

%!  part_of_arrangement(+Arrangement, +Leaves:list, -Part) is det.
%
%   Part is an arrangement of those of the leaves of Arrangement that are in
%   Leaves, ascending, with the pieces that they have there.

part_of_arrangement(arrangement(Pieces0, Contacts, Near), Leaves,
                    arrangement(Pieces, Contacts, Near)) :-
    parted(Pieces0, Leaves, Pieces, _).

%!  pieces_statistics(-Statistics:dict) is det.
%
%   Of how many leaves the world keeps the pieces, in how many arrangements; and
%   how many were made, and found as they were, since the process started.

pieces_statistics(_{leaves:Leaves, arrangements:Arrangements, made:Made,
                    found:Found}) :-
    flag(sg_pieces_made, Made, Made),
    flag(sg_pieces_found, Found, Found),
    kept(Kept),
    assoc_to_keys(Kept, Ss),
    length(Ss, Leaves),
    findall(A,
            ( member(S, Ss),
              entries(S, Kept, Entries),
              member(entry(_, A, _, _), Entries)
            ),
            As0),
    sort(As0, As),
    length(As, Arrangements).
