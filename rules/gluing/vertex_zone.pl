:- module(sg_vertex_zone,
          [ zones_told/2,               % +S, -Meetings
            zone_meeting/3              % +S, +V, -Sides
          ]).
:- use_module(cycle, [disk/4]).
:- use_module(vertex_disk, [disk_zones/2, disks_meet/4]).
:- use_module('../store', [v/5, edge_polygon/3]).
:- use_module(library(lists), [member/2, nth0/3]).
/** <module> The zones at vertices as a rule says them.

What disk_relation/3 says of each two disks at a vertex, put together. The
kernel for the default is c_kernels/gluing/sphere_map.h. */

%!  zones_told(+S, -Meetings:list) is det.
%
%   Meetings, as of regions_told/4, are the zones of segment S that two disks
%   at a vertex have in common, by disk_relation/3: those in which they see
%   each other, if no third disk sees them in different ones.
%
%   @error geometry_error(part_glue(disks_cross(S, V, D1, D2))): two disks go
%          through each other, as disk_relation/3 has it

zones_told(S, Meetings) :-
    findall(Meeting, ( crowded(S, V, Ds), meeting(S, V, Ds, Meeting) ),
            Meetings).

%!  zone_meeting(+S, +V, -Sides) is nondet.
%
%   The two disks that have Sides, One-Other as of disk_zones/2, at vertex V of
%   segment S have a zone in common, of which these are.
%
%   @error as zones_told/2

zone_meeting(S, V, One-Other) :-
    crowded(S, V, Ds),
    meeting(S, V, Ds, meet(_,E1,Above1,E2,Above2)),
    told_side(S, E1, Above1, One),
    told_side(S, E2, Above2, Other).

told_side(S, E, Above, Side) :-
    (   E < 0
    ->  P is -E,
        Item = p(P)
    ;   Item = E
    ),
    (   E > 0,
        \+ edge_polygon(S, E, _)
    ->  Side = e(E)
    ;   Above == true
    ->  Side = above(Item)
    ;   Side = below(Item)
    ).

crowded(S, V, Ds) :-
    v(S, V, _, _, _),
    findall(D, disk(S, V, D, _), Ds),
    Ds = [_,_|_].

meeting(S, V, Ds, meet(V,E1,Above1,E2,Above2)) :-
    findall(D1-Sees,
            ( member(D1, Ds), findall(D2-Zone, sees(S, V, Ds, D1, D2, Zone),
                                      Sees) ),
            Views),
    member(D1-Sees1, Views),
    member(D2-Sees2, Views),
    D1 < D2,
    \+ ( member(D3-Sees3, Views),
         D3 =\= D1,
         D3 =\= D2,
         memberchk(D1-Zone31, Sees3),
         memberchk(D2-Zone32, Sees3),
         Zone31 =\= Zone32 ),
    memberchk(D2-Zone1, Sees1),
    memberchk(D1-Zone2, Sees2),
    zone_side(disk(S,V,D1), Zone1, E1, Above1),
    zone_side(disk(S,V,D2), Zone2, E2, Above2).

%   sees(S, V, Ds, D1, D2, Zone) is nondet: disk D2 lies in Zone of disk D1.

sees(S, V, Ds, D1, D2, Zone) :-
    member(D2, Ds),
    D1 =\= D2,
    (   D1 < D2
    ->  met(S, V, D1, D2, Zone, _)
    ;   met(S, V, D2, D1, _, Zone)
    ).

met(S, V, D1, D2, Zone1, Zone2) :-
    (   disks_meet(disk(S,V,D1), disk(S,V,D2), Zone1, Zone2)
    ->  true
    ;   throw(error(geometry_error(part_glue(disks_cross(S, V, D1, D2))), _))
    ).

%   zone_side(Disk, Zone, E, Above): one of its sides; -P of a polygon inside of
%   which the vertex lies.

zone_side(Disk, Zone, E, Above) :-
    disk_zones(Disk, Zones),
    nth0(Zone, Zones, [Side|_]),
    side(Side, E, Above).

side(above(Item), E, true) :-
    item(Item, E).
side(below(Item), E, false) :-
    item(Item, E).
side(e(E), E, false).

item(p(P), E) :-
    !,
    E is -P.
item(E, E).
