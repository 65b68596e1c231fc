:- module(sg_leaf,
          [ leaves_kept/1,              % +Polygons
            curve_segment/1,            % ?S
            curve_kept/1,               % +Curve
            were_cut/2,                 % ?S1, ?S2
            origin_segment/2,           % +Origin, -S
            earlier_cuts/2,             % +Pairs, -Earlier
            leaves_restored/1           % +Pairs
          ]).
:- use_module('../kernel', [leaves_keep/1]).
:- use_module('../store',
              [ v/5, e/5, p/3, t/6, leaf_v/5, leaf_e/5, leaf_p/3, leaf_t/6,
                segment/3, origin/3, line/9, edge_polygon/3,
                assert_fact/1, retract_fact/1, retractall_facts/1
              ]).
:- use_module(library(apply), [exclude/3, include/3, maplist/2]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(ordsets), [ord_subtract/3, ord_union/3]).
:- use_module(library(pairs), [pairs_keys_values/3]).

/** <module> Leaves: what the segments were before any cut.

The join of a penetration is taken between *leaf* triangles only, so that
every point is named by original vertices and no rational grows, however many
penetrations there were. Where a polygon is cut, its edges, its list and its
triangles as they were stay as leaf_e/5, leaf_p/3 and leaf_t/6.

A penetration that comes after another one brings the leaves back, and then
all cuts are taken at once, the earlier pairs with the new ones: so it makes
no difference in which order the segments came. What is put back is that of
the segments that are connected with the new pairs by earlier cuts; the
others are left alone.

@see docs/internals/penetration.md
*/

%!  leaves_kept(+Polygons:list) is det.
%
%   Writes leaf_e/5, leaf_p/3 and leaf_t/6 of the polygons S-P, which are
%   about to be cut; those that have them keep them.

leaves_kept(Polygons) :-
    leaves_keep(Polygons).

leaf_edge_kept(S, E) :-
    (   leaf_e(S, E, _, _, _)
    ->  true
    ;   e(S, E, V1, V2, Et)
    ->  assert_fact(leaf_e(S, E, V1, V2, Et))
    ).

%!  curve_kept(+Curve) is det.
%
%   Writes leaf_e/5 of the edge S-E of a curve.

curve_kept(S-E) :-
    leaf_edge_kept(S, E).

%!  were_cut(?S1, ?S2) is nondet.
%
%   True when S1 and S2, S1 < S2, were cut by each other before: there is a
%   line of both, or one is a curve that has a point on the other (or as a
%   curve, for no polygon of it has area). The same pair may come more than
%   once.

were_cut(S1, S2) :-
    line(_, S1, _, _, _, S2, _, _, _).
were_cut(S1, S2) :-
    S1 \== S2,
    findall(Curve-(S1-S2),
            ( ( Curve = S1, Other = S2 ; Curve = S2, Other = S1 ),
              may_be_curve(Curve),
              origin(Curve, v(_), Origin),
              origin_segment(Origin, Other),
              S1 < S2 ),
            Named0),
    sort(Named0, Named),                % is_curve/1 is dear: once for each
    member(Curve-(S1-S2), Named),
    is_curve(Curve).

%!  curve_segment(?S) is nondet.
%
%   True when segment S is cut as a curve: it has no triangles, whatever it is
%   called. Solids are none.

curve_segment(S) :-
    may_be_curve(S),
    is_curve(S).

%   may_be_curve(?S): solids are none, so the origins that results have, which
%   are many, are not looked at.

may_be_curve(S) :-
    segment(S, Kind, _),
    memberchk(Kind, [surface,curve,cells]).

%   is_curve(+S): it has no triangles. That is looked for among all, so last.

is_curve(S) :-
    \+ t(S, _, _, _, _, _).

%!  origin_segment(+Origin, -S) is nondet.
%
%   True when the origin of a vertex on a line or curve names segment S.

origin_segment(v(S, _), S).
origin_segment(ll(S-_, _), S).
origin_segment(ll(_, S-_), S).
origin_segment(lpi(S-_, _), S).
origin_segment(lpi(_, S-_), S).

%!  earlier_cuts(+Pairs:list, -Earlier:list) is det.
%
%   Earlier are the pairs S1-S2 that were cut by each other before, of segments
%   that are in Pairs or were cut by such, and so on; in order. None if a
%   polygon of theirs was cut whose leaves were not kept (in a file that lacks
%   them): then what is there now is what is cut.

earlier_cuts(Pairs, Earlier) :-
    all_cuts(Cuts),
    pair_segments(Pairs, Group0),
    connected(Cuts, Group0, Group),
    exclude(is_outside(Group), Cuts, Earlier0),
    (   Earlier0 \== [],
        all_kept(Group)
    ->  Earlier = Earlier0
    ;   Earlier = []
    ).

%   all_cuts(-Cuts): all S1-S2 that were_cut/2, each once, in order.

all_cuts(Cuts) :-
    findall(S1-S2, line(_, S1, _, _, _, S2, _, _, _), Lines0),
    sort(Lines0, Lines),
    findall(S1-S2, curve_cut(S1, S2), Curves0),
    sort(Curves0, Curves),
    ord_union(Lines, Curves, Cuts).

%   curve_cut(-S1, -S2): one of them is a curve that has a point on the other.

curve_cut(S1, S2) :-
    curve_segment(Curve),
    origin(Curve, v(_), Origin),
    origin_segment(Origin, Other),
    Other \== Curve,
    msort([Curve,Other], [S1,S2]).

pair_segments(Pairs, Ss) :-
    pairs_keys_values(Pairs, S1s, S2s),
    append(S1s, S2s, Ss0),
    sort(Ss0, Ss).

%   connected(+Cuts, +Group0, -Group): with all that were cut by them.

connected(Cuts, Group0, Group) :-
    list_assoc(Group0, In),
    findall(S, ( member(S1-S2, Cuts), one_in(In, S1, S2, S) ), New0),
    sort(New0, New),
    (   New == []
    ->  Group = Group0
    ;   ord_union(Group0, New, Group1),
        connected(Cuts, Group1, Group)
    ).

%   one_in(+In, +S1, +S2, -S): S is the one that is not in, the other is.

one_in(In, S1, S2, S) :-
    (   get_assoc(S1, In, _)
    ->  \+ get_assoc(S2, In, _),
        S = S2
    ;   get_assoc(S2, In, _),
        S = S1
    ).

is_outside(Group, S1-_) :-
    \+ memberchk(S1, Group).

list_assoc(Ss, Assoc) :-
    findall(S-in, member(S, Ss), Pairs),
    list_to_assoc(Pairs, Assoc).

%   all_kept(+Group): every polygon with an edge of an earlier cut has leaves.

all_kept(Group) :-
    list_assoc(Group, In),
    \+ ( origin(S, e(E), Origin),
         cut_edge(Origin),
         get_assoc(S, In, _),
         \+ has_leaf(S, E, Origin) ).

cut_edge(e(_)).
cut_edge(line(_)).

has_leaf(S, E, _) :-
    edge_polygon(S, E, P),
    !,
    leaf_p(S, P, _),
    !.
has_leaf(S, _, e(Old)) :-
    leaf_e(S, Old, _, _, _),
    !.

%!  leaves_restored(+Pairs:list) is det.
%
%   The segments of Pairs are as they were before any cut: their polygons,
%   curves, triangles, and where vertices were. Vertices, edges, origins, lines
%   and leaves that the cuts made are gone.

leaves_restored(Pairs) :-
    pair_segments(Pairs, Group),
    list_assoc(Group, In),
    findall(L, ( line(L, S, _, _, _, _, _, _, _), get_assoc(S, In, _) ), Ls),
    forall(member(L, Ls), retractall_facts(line(L, _, _, _, _, _, _, _, _))),
    findall(leaf(S, P, Es),
            ( leaf_p(S, P, Es), get_assoc(S, In, _) ),
            Leaves),
    maplist(polygon_restored, Leaves),
    findall(edge(S, E, V1, V2, Et),
            ( leaf_e(S, E, V1, V2, Et), get_assoc(S, In, _) ),
            Edges),
    include(curve_segment, Group, Curves),
    maplist(leaf_edge_dropped(Curves), Edges),
    findall(place(S, V, X, Y, Z),
            ( leaf_v(S, V, X, Y, Z), get_assoc(S, In, _) ),
            Places),
    maplist(place_restored, Places),
    findall(S-V, ( origin(S, v(V), _), get_assoc(S, In, _) ), Vertices),
    maplist(unused_dropped, Vertices).

polygon_restored(leaf(S, P, Es)) :-
    (   p(S, P, Es1)
    ->  once(retract_fact(p(S, P, Es1))),
        sort(Es, Kept),
        sort(Es1, Edges),
        ord_subtract(Edges, Kept, Cut),
        maplist(edge_dropped(S), Cut),
        maplist(edge_restored(S), Es),
        assert_fact(p(S, P, Es)),
        triangles_restored(S, P)
    ;   true
    ),
    retractall_facts(leaf_p(S, P, _)).

edge_dropped(S, E) :-
    retractall_facts(e(S, E, _, _, _)),
    retractall_facts(origin(S, e(E), _)).

edge_restored(S, E) :-
    (   e(S, E, _, _, _)
    ->  true
    ;   leaf_e(S, E, V1, V2, Et)
    ->  assert_fact(e(S, E, V1, V2, Et))
    ).

triangles_restored(S, P) :-
    retractall_facts(t(S, P, _, _, _, _)),
    forall(leaf_t(S, P, T, V1, V2, V3),
           assert_fact(t(S, P, T, V1, V2, V3))),
    retractall_facts(leaf_t(S, P, _, _, _, _)).

place_restored(place(S, V, X, Y, Z)) :-
    retractall_facts(v(S, V, _, _, _)),
    assert_fact(v(S, V, X, Y, Z)),
    retractall_facts(origin(S, v(V), _)),
    retractall_facts(leaf_v(S, V, _, _, _)).

%   An edge of a curve comes back here; of a polygon it is there.

leaf_edge_dropped(Curves, edge(S, E, V1, V2, Et)) :-
    (   memberchk(S, Curves)
    ->  findall(Part, origin(S, e(Part), e(E)), Parts),
        maplist(edge_dropped(S), Parts),
        assert_fact(e(S, E, V1, V2, Et))
    ;   true
    ),
    retractall_facts(leaf_e(S, E, _, _, _)).

%   A vertex that a cut made is of no edge now.

unused_dropped(S-V) :-
    (   has_edge(S, V)
    ->  true
    ;   retractall_facts(origin(S, v(V), _)),
        retractall_facts(v(S, V, _, _, _))
    ).

has_edge(S, V) :-
    e(S, _, V, _, _),
    !.
has_edge(S, V) :-
    e(S, _, _, V, _),
    !.
