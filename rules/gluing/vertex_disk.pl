:- module(sg_vertex_disk,
          [ disk_zones/2,               % +Disk, -Zones
            disk_arcs/2,                % +Disk, -Arcs
            disk_direction/2,           % +Disk, -Direction
            zone_at/3,                  % +Disk, +Direction, -Zone
            seen_in/3,                  % +Disk1, +Disk2, -Zone
            arcs_cross/2,               % +Disk1, +Disk2
            disks_touch/2,              % +Disk1, +Disk2
            disk_relation/3,            % +Disk1, +Disk2, -Relation
            disks_meet/4                % +Disk1, +Disk2, -Zone1, -Zone2
          ]).
:- use_module(cycle, [disk/4, radial_cycle/4]).
:- use_module('../decision', [decision/2]).
:- use_module('../disjoint_sets', [set_root/3, sets_joined/4]).
:- use_module('../exact', [vertex_exact/5]).
:- use_module('../store', [e/5, p/3, t/6, vertex_triangle/3, lies_in/3]).
:- use_module('../vector',
              [ cross_product/3, difference/3, dot_product/3, scaled/3,
                vector_sum/3 ]).
:- use_module(library(apply), [foldl/4, partition/4]).
:- use_module(library(assoc), [empty_assoc/1]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(lists), [append/2, append/3, member/2, nth0/3]).
:- use_module(library(pairs), [group_pairs_by_key/2, pairs_values/2]).
/** <module> How disks at one place lie to each other (NG-2).

disk(S, V, D) is the D-th disk at vertex V of segment S, as of disk/4. Seen from
its vertex a triangle is an arc of a sphere of directions, and a wire a point. A
disk divides the sphere into zones. Of each zone it is known which sides of what
is there it has:

    below(E), above(E)         of a polygon's corner where its edge E starts
    below(p(P)), above(p(P))   of polygon P, inside of which the vertex lies
    e(E)                       of a wire

Zones are numbered from 0, those outside first; most disks have one outside, 0.
Exact: rationals decide. What it says of all disks at a vertex is said faster
by the kernel, c_kernels/gluing/sphere_map.h; a test compares the two. */

%!  disk_zones(+Disk, -Zones:list) is det.
%
%   Zones are the zones of Disk, each a list of its sides: first those outside,
%   then the insides, which have nothing but below(_).

disk_zones(disk(S,V,D), Zones) :-
    once(disk(S, V, D, Items)),
    disk_corners(S, V, Items, Corners),
    findall(Side, item_side(S, V, Items, Corners, Side), Sides),
    findall(One-Other, sides_beside(S, V, Items, Corners, One, Other), Links),
    empty_assoc(Sets0),
    foldl(link_joined, Links, Sets0, Sets),
    findall(Root-Side, ( member(Side, Sides), set_root(Sets, Side, Root) ),
            Pairs0),
    sort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    pairs_values(Groups, Lists),
    sort(Lists, Zones0),
    partition(is_inside, Zones0, Inner, Outer),
    append(Outer, Inner, Zones).

link_joined(One-Other, Sets0, Sets) :-
    sets_joined(One, Other, Sets0, Sets).

is_inside(Zone) :-
    \+ ( member(Side, Zone), Side \= below(_) ).

%   inside(Disk, Zone, Inside): 1 of an inside of Disk, else 0.

inside(Disk, Zone, Inside) :-
    disk_zones(Disk, Zones),
    nth0(Zone, Zones, Sides),
    (   is_inside(Sides)
    ->  Inside = 1
    ;   Inside = 0
    ).

%   item_side(S, V, Items, Corners, Side) is nondet.

item_side(_, _, _, Corners, Side) :-
    member(corner(_,Out,_,_), Corners),
    side_of(Out, Side).
item_side(_, _, [e(E)|Es], [], e(E1)) :-
    member(e(E1), [e(E)|Es]).

side_of(Out, below(Out)).
side_of(Out, above(Out)).

%   disk_corners(S, V, Items, Corners): corner(P, Out, In, Fan) is a corner of
%   polygon P: its edges Out and In start and end at V; Fan are the vertices
%   opposite V from one to the other. Of a point loop Out is p(P), In `none`,
%   and Fan a list of pairs A-B.

disk_corners(S, V, Items, Corners) :-
    findall(Corner,
            ( member(p(P), Items), polygon_corner(S, V, P, Corner) ),
            Corners).

polygon_corner(S, V, P, corner(P,Out,In,Fan)) :-
    p(S, P, Es),
    (   member(Out, Es),
        once(e(S, Out, V, A, _)),
        corner_fan(S, V, P, Es, A, A, In, Fan)
    ;   once(lies_in(S, v(V), p(P))),
        Out = p(P),
        In = none,
        findall(Pair, opposite(S, V, P, Pair), Fan)
    ).

corner_fan(S, V, P, Es, First, A, In, [A-B|Fan]) :-
    once(( vertex_triangle(S, V, T),
           t(S, P, T, C1, C2, C3),
           turned(C1, C2, C3, V, A, B) )),
    (   once(( member(In0, Es), e(S, In0, B, V, _) ))
    ->  In = In0,
        Fan = []
    ;   B == First
    ->  In = none,
        Fan = []
    ;   corner_fan(S, V, P, Es, First, B, In, Fan)
    ).

turned(A, B, C, A, B, C).
turned(A, B, C, B, C, A).
turned(A, B, C, C, A, B).

%   opposite(S, V, P, A-B) is nondet: a side of a triangle of P that has V, as a
%   corner or where it is, from which V is seen.

opposite(S, V, P, Pair) :-
    t(S, P, _, C1, C2, C3),
    (   turned(C1, C2, C3, V, A, B)
    ->  Pair = A-B
    ;   inside_triangle(S, V, C1, C2, C3, Sides),
        member(Pair-1, Sides)
    ).

inside_triangle(S, V, A, B, C, [(A-B)-D1,(B-C)-D2,(C-A)-D3]) :-
    direction(S, V, A, P),
    direction(S, V, B, Q),
    direction(S, V, C, R),
    difference(Q, P, U),
    difference(R, P, W),
    cross_product(U, W, N),
    turn(N, P, Q, D1),
    turn(N, Q, R, D2),
    turn(N, R, P, D3),
    D1 >= 0,
    D2 >= 0,
    D3 >= 0.

direction(S, V, W, Direction) :-
    once(vertex_exact(S, V, X0, Y0, Z0)),
    once(vertex_exact(S, W, X, Y, Z)),
    difference(p(X,Y,Z), p(X0,Y0,Z0), Direction).

%   turn(N, A, B, Turn): 1 if B is less than half a circle to the left of A,
%   seen from where N points to; 0, -1.

turn(N, A, B, Turn) :-
    cross_product(A, B, C),
    dot_product(C, N, Product),
    Turn is sign(Product).

%   sides_beside(S, V, Items, Corners, One, Other) is nondet: what is after a
%   page of an edge at V is before the next one; and of edges of no polygon
%   between the same two vertices.

sides_beside(S, V, Items, Corners, One, Other) :-
    findall(W,
            ( member(e(E), Items), once(e(S, E, V1, V2, _)),
              ( V1 == V -> W = V2 ; W = V1 ) ),
            Ws0),
    sort(Ws0, Ws),
    member(W, Ws),
    A is min(V, W),
    B is max(V, W),
    once(radial_cycle(S, A, B, Pages)),
    (   Pages = [First|_]
    ->  append(Pages, [First], Round),
        append(_, [Page,Next|_], Round),
        page_sides(S, A, Page, Corners, _, One),
        page_sides(S, A, Next, Corners, Other, _)
    ;   Items = [Wire|Rest],
        One = Wire,
        member(Other, Rest)
    ).

page_sides(S, A, page(_,E,_), Corners, Before, After) :-
    once(( member(corner(_,Out,In,_), Corners), ( Out == E ; In == E ) )),
    (   once(e(S, E, A, _, _))
    ->  Before = below(Out),
        After = above(Out)
    ;   Before = above(Out),
        After = below(Out)
    ).

%!  disk_arcs(+Disk, -Arcs:list) is det.
%
%   Arcs has arc(A, B, Below, Above) for each triangle at Disk: A and B lead
%   from the vertex to its other corners, p(X,Y,Z) of rationals; below it is
%   zone Below of Disk, and above it, where A x B points, zone Above. [] of a
%   wire.

disk_arcs(disk(S,V,D), Arcs) :-
    disk_zones(disk(S,V,D), Zones),
    once(disk(S, V, D, Items)),
    disk_corners(S, V, Items, Corners),
    findall(arc(A,B,Below,Above),
            ( member(corner(_,Out,_,Fan), Corners),
              zone_of(Zones, below(Out), Below),
              zone_of(Zones, above(Out), Above),
              member(V1-V2, Fan),
              direction(S, V, V1, A),
              direction(S, V, V2, B) ),
            Arcs).

zone_of(Zones, Side, Zone) :-
    nth0(Zone, Zones, Sides),
    memberchk(Side, Sides),
    !.

%!  disk_direction(+Disk, -Direction) is nondet.
%
%   Direction, p(X,Y,Z), leads from the vertex along something of Disk: a wire,
%   the ends of its arcs, then their middles. Exact.

disk_direction(disk(S,V,D), Direction) :-
    disk_arcs(disk(S,V,D), Arcs),
    (   Arcs == []
    ->  once(disk(S, V, D, [e(E)|_])),
        once(e(S, E, V1, V2, _)),
        (   V1 == V
        ->  direction(S, V, V2, Direction)
        ;   direction(S, V, V1, Direction)
        )
    ;   member(arc(Direction,_,_,_), Arcs)
    ;   member(arc(_,Direction,_,_), Arcs)
    ;   member(arc(A,B,_,_), Arcs),
        vector_sum(A, B, Direction)
    ).

%!  seen_in(+Disk1, +Disk2, -Zone) is det.
%
%   Zone of Disk2 is the one that Disk1 lies in: one direction of Disk1 that
%   is not on Disk2 says so, as they do not cross. If all of Disk1 lies on
%   Disk2, it is 0.

seen_in(Disk1, Disk2, Zone) :-
    disk_arcs(Disk2, Arcs),
    (   Arcs = [arc(_,_,Zone0,_)|_],
        \+ ( member(arc(_,_,Below,Above), Arcs),
             ( Below =\= Zone0 ; Above =\= Zone0 ) )
    ->  Zone = Zone0
    ;   disk_direction(Disk1, P),
        zone_among(P, Arcs, Zone0)
    ->  Zone = Zone0
    ;   Zone = 0
    ).

on_arcs(P, Arcs) :-
    member(arc(A,B,_,_), Arcs),
    on_arc(P, A, B),
    !.

on_arc(P, A, B) :-
    cross_product(A, B, N),
    dot_product(N, P, 0),
    turn(N, A, P, Turn1),
    turn(N, P, B, Turn2),
    Turn1 >= 0,
    Turn2 >= 0,
    vector_sum(A, B, Middle),
    dot_product(Middle, P, Along),
    Along > 0.

%!  zone_at(+Disk, +Direction, -Zone) is semidet.
%
%   Zone of Disk is the one that Direction points into. Fails if it lies on
%   Disk.

zone_at(Disk, P, Zone) :-
    disk_arcs(Disk, Arcs),
    (   Arcs == []
    ->  \+ on_disk(P, Disk, []),
        Zone = 0
    ;   zone_among(P, Arcs, Zone)
    ).

%   zone_among(P, Arcs, Zone): on the way from P to a point of an arc the first
%   arc is met from Zone. The way goes through no end of an arc.

zone_among(P, Arcs, Zone) :-
    \+ on_arcs(P, Arcs),
    (   met_from(P, Arcs, Zone0)
    ->  Zone = Zone0
    ;   Arcs = [arc(_,_,Zone,_)|_]      % all in one plane with P
    ).

met_from(P, Arcs, Zone) :-
    member(arc(A,B,_,_), Arcs),
    member(Part, [1,1r2,2,1r3,3,2r5,5r2]),
    scaled(Part, B, B1),
    vector_sum(A, B1, To),
    cross_product(P, To, N),
    N \== p(0,0,0),
    findall(Met, ( member(Arc, Arcs), arc_met(Arc, P, To, N, Met) ), Mets),
    \+ memberchk(unsure, Mets),
    Mets = [Met1|Mets1],
    foldl(first_met(N), Mets1, Met1, at(_,Zone)).

first_met(N, at(X,ZoneX), at(Y,ZoneY), First) :-
    (   turn(N, X, Y, 1)
    ->  First = at(X,ZoneX)
    ;   First = at(Y,ZoneY)
    ).

arc_met(arc(A,B,Below,Above), P, To, N, Met) :-
    dot_product(A, N, SideA),
    dot_product(B, N, SideB),
    Signs is sign(SideA)*sign(SideB),
    (   SideA =:= 0,
        on_way(N, P, To, A)
    ->  Met = unsure
    ;   SideB =:= 0,
        on_way(N, P, To, B)
    ->  Met = unsure
    ;   Signs < 0,
        scaled(abs(SideB), A, A1),
        scaled(abs(SideA), B, B1),
        vector_sum(A1, B1, At),
        on_way(N, P, To, At)
    ->  cross_product(A, B, Normal),
        dot_product(Normal, P, Side),
        (   Side > 0
        ->  Met = at(At,Above)
        ;   Met = at(At,Below)
        )
    ).

%   on_way(N, P, To, At): At, square to N, is after P on the way to To, or
%   there.

on_way(N, P, To, At) :-
    turn(N, P, At, 1),
    turn(N, At, To, Turn),
    Turn >= 0.

%!  arcs_cross(+Disk1, +Disk2) is semidet.
%
%   True when Disk1 and Disk2 go through each other: two arcs cross, or one of
%   the disks lies in several zones of the other one, which it touches.

arcs_cross(Disk1, Disk2) :-
    disk_arcs(Disk1, Arcs1),
    disk_arcs(Disk2, Arcs2),
    (   member(Arc1, Arcs1),
        member(Arc2, Arcs2),
        arcs_through(Arc1, Arc2)
    ->  true
    ;   touching(Disk1, Arcs1, Disk2, Arcs2)
    ->  (   in_several_zones(Disk1, Arcs2)
        ->  true
        ;   in_several_zones(Disk2, Arcs1)
        )
    ).

arcs_through(arc(A,B,_,_), arc(C,D,_,_)) :-
    cross_product(A, B, N1),
    cross_product(C, D, N2),
    dot_product(N1, C, SideC),
    dot_product(N1, D, SideD),
    sign(SideC)*sign(SideD) < 0,
    dot_product(N2, A, SideA),
    dot_product(N2, B, SideB),
    sign(SideA)*sign(SideB) < 0,
    scaled(abs(SideD), C, C1),
    scaled(abs(SideC), D, D1),
    vector_sum(C1, D1, At),
    turn(N1, A, At, 1),
    turn(N1, At, B, 1).

in_several_zones(Disk, Arcs) :-
    findall(Zone,
            ( disk_direction(Disk, P), zone_among(P, Arcs, Zone) ),
            Zones0),
    sort(Zones0, [_,_|_]).

%!  disks_touch(+Disk1, +Disk2) is semidet.
%
%   True when a direction of Disk1, an end of an arc or a wire, is on Disk2, or
%   the other way round: an edge is to be glued first, or an edge and a face.

disks_touch(Disk1, Disk2) :-
    disk_arcs(Disk1, Arcs1),
    disk_arcs(Disk2, Arcs2),
    touching(Disk1, Arcs1, Disk2, Arcs2).

touching(Disk1, Arcs1, Disk2, Arcs2) :-
    (   disk_direction(Disk1, P),
        on_disk(P, Disk2, Arcs2)
    ->  true
    ;   disk_direction(Disk2, P),
        on_disk(P, Disk1, Arcs1)
    ->  true
    ).

on_disk(P, Disk, Arcs) :-
    (   Arcs == []
    ->  disk_direction(Disk, Q),
        cross_product(P, Q, p(0,0,0)),
        dot_product(P, Q, Along),
        Along > 0
    ;   on_arcs(P, Arcs)
    ).

%!  disk_relation(+Disk1, +Disk2, -Relation) is det.
%
%   A decision: how the insides of two disks at one place lie to each other, as
%   of disk_zones/2; a wire has none.
%
%     - disjoint: neither is in the other
%     - cover: together they are all of space
%     - within: Disk1 is in Disk2
%     - around: Disk2 is in Disk1
%     - cross: they go through each other, and are to be cut first (NG-6)
%
%   Two locations say it: in which zone of the other one each of them lies.

:- decision(disk_relation/3,
            "How two disks at one vertex lie to each other (NG-2)").

disk_relation(Disk1, Disk2, Relation) :-
    (   arcs_cross(Disk1, Disk2)
    ->  Relation = cross
    ;   seen_in(Disk2, Disk1, Zone1),
        seen_in(Disk1, Disk2, Zone2),
        inside(Disk1, Zone1, Inside1),
        inside(Disk2, Zone2, Inside2),
        zones_relation(Inside1, Inside2, Relation)
    ).

%   zones_relation(Inside1, Inside2, Relation): 1: Disk2 lies in an inside of
%   Disk1, Disk1 in one of Disk2.

zones_relation(0, 0, disjoint).
zones_relation(1, 1, cover).
zones_relation(0, 1, within).
zones_relation(1, 0, around).

%!  disks_meet(+Disk1, +Disk2, -Zone1, -Zone2) is semidet.
%
%   Zone1 of Disk1 is where Disk2 lies, Zone2 of Disk2 where Disk1 lies, as
%   disk_relation/3 has it: if nothing else is between them, they are one. Fails
%   if they cross.
%
%   @error domain_error(disk_relation, Relation): it is none

disks_meet(Disk1, Disk2, Zone1, Zone2) :-
    once(disk_relation(Disk1, Disk2, Relation)),
    must_be(oneof([disjoint,cover,within,around,cross]), Relation),
    zones_relation(Inside1, Inside2, Relation),
    zone_seen(Inside1, Disk2, Disk1, Zone1),
    zone_seen(Inside2, Disk1, Disk2, Zone2).

zone_seen(Inside, Disk1, Disk2, Zone) :-
    (   findall(Zone0, inside(Disk2, Zone0, Inside), [One])
    ->  Zone = One
    ;   seen_in(Disk1, Disk2, Zone)
    ).
