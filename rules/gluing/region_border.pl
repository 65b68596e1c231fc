:- module(sg_region_border,
          [ zone/4,                     % ?S, ?V, -R, -Cycles
            shell/4                     % ?S, ?R, -K, -Uses
          ]).
:- use_module(cycle, [disk/4]).
:- use_module(vertex_disk, [disk_zones/2]).
:- use_module(vertex_zone, [zone_meeting/3]).
:- use_module('../disjoint_sets', [set_root/3, sets_joined/4]).
:- use_module('../store', [v/5, e/5, edge_polygon/3, region/3, sides/4,
                           lies_in/3]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(assoc), [empty_assoc/1]).
:- use_module(library(lists), [member/2, nth1/3]).
:- use_module(library(pairs), [group_pairs_by_key/2, pairs_values/2]).
/** <module> The borders of regions: at a vertex, and all round (NG-1).

Nothing of them is kept. A zone is what a region is at a vertex; what the zones
at all vertices connect are the shells. For a whole segment
c_kernels/gluing/regions.h does the same. */

%!  zone(?S, ?V, -R, -Cycles) is nondet.
%
%   True when region R of segment S is at vertex V, and in that zone of it has
%   the Cycles, one of each disk: lists of the sides below(E) and above(E) of
%   the corner of a polygon where its edge E starts at V, below(p(P)) and
%   above(p(P)) of a polygon inside of which V lies, and e(E) of a wire. Of a
%   vertex that is alone Cycles is []. Needs regions_made/2.

zone(S, V, R, Cycles) :-
    v(S, V, _, _, _),
    vertex_zones(S, V, Zones),
    (   Zones == []
    ->  lies_in(S, v(V), r(R)),
        Cycles = []
    ;   member(Cycles, Zones),
        Cycles = [[Side|_]|_],
        side_region(S, Side, R)
    ).

vertex_zones(S, V, Zones) :-
    findall(Cycle,
            ( disk(S, V, D, _),
              disk_zones(disk(S,V,D), Cycles),
              member(Cycle, Cycles) ),
            All),
    findall(One-Other,
            ( zone_meeting(S, V, Side1-Side2),
              once(( member(One, All), memberchk(Side1, One) )),
              once(( member(Other, All), memberchk(Side2, Other) )) ),
            Meetings),
    joined(All, Meetings, Zones).

%   joined(All, Links, Groups): All, by what Links, One-Other, connect.

joined(All, Links, Groups) :-
    empty_assoc(Sets0),
    foldl(link_joined, Links, Sets0, Sets),
    findall(Root-One, ( member(One, All), set_root(Sets, One, Root) ), Pairs0),
    sort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Grouped),
    pairs_values(Grouped, Groups0),
    sort(Groups0, Groups).

link_joined(One-Other, Sets0, Sets) :-
    sets_joined(One, Other, Sets0, Sets).

%   side_region(S, Side, R): of several wires between two vertices one says it.

side_region(S, Side, R) :-
    side_use(S, Side, Use),
    use_region(S, Use, R).

side_use(_, e(E), e(E)).
side_use(S, below(Item), P-below) :-
    item_polygon(S, Item, P).
side_use(S, above(Item), P-above) :-
    item_polygon(S, Item, P).

item_polygon(_, p(P), P) :-
    !.
item_polygon(S, E, P) :-
    once(edge_polygon(S, E, P)).

use_region(S, P-below, R) :-
    sides(S, P, R, _).
use_region(S, P-above, R) :-
    sides(S, P, _, R).
use_region(S, e(E), R) :-
    once(e(S, E, V1, V2, _)),
    once(( ( e(S, E1, V1, V2, _) ; e(S, E1, V2, V1, _) ),
           lies_in(S, e(E1), r(R)) )).

%!  shell(?S, ?R, -K, -Uses) is nondet.
%
%   True when Uses are the K-th shell, a connected border, of region R of
%   segment S: P-below and P-above of polygons, e(E) of wires, v(V) of a vertex
%   that is alone. Shells come in the order of their first uses. Needs
%   regions_made/2.

shell(S, R, K, Uses) :-
    region(S, R, _),
    findall(Use, region_use(S, R, Use), All),
    findall(One-Other,
            ( border_vertex(S, All, V),
              zone(S, V, R, Cycles),
              zone_uses(S, Cycles, [One|Others]),
              member(Other, Others) ),
            Links),
    joined(All, Links, Shells),
    nth1(K, Shells, Uses).

region_use(S, R, Use) :-
    (   sides(S, P, R, _),
        Use = P-below
    ;   sides(S, P, _, R),
        Use = P-above
    ;   lies_in(S, Item, r(R)),
        Use = Item
    ).

border_vertex(S, Uses, V) :-
    findall(V0, ( member(Use, Uses), use_vertex(S, Use, V0) ), Vs0),
    sort(Vs0, Vs),
    member(V, Vs).

use_vertex(S, P-_, V) :-
    (   edge_polygon(S, E, P),
        e(S, E, V, _, _)
    ;   lies_in(S, v(V), p(P))
    ).
use_vertex(S, e(E), V) :-
    once(e(S, E, V1, V2, _)),
    member(V, [V1,V2]).

%   zone_uses(S, Cycles, Uses): those that region_use/3 names.

zone_uses(S, Cycles, Uses) :-
    findall(Use,
            ( member(Cycle, Cycles),
              member(Side, Cycle),
              side_use(S, Side, Use),
              named_use(S, Use) ),
            Uses0),
    sort(Uses0, Uses).

named_use(S, Use) :-
    (   Use = e(E)
    ->  once(lies_in(S, e(E), r(_)))
    ;   true
    ).
