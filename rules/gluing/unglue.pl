:- module(sg_unglue,
          [ unglued_polygons/3,         % +S, +Ps, -Change
            unglued_between/4,          % +S, +R1, +R2, -Change
            unglued_region/4,           % +S, +R, -N, -Change
            meetings_unmeant/2,         % +Most, -Selves
            twin_there/3,               % +S, +P, -Q
            vertex_parted/4             % +S, +V, +Ps, -W
          ]).
:- use_module(cells_edit,
              [ cells_edited/3, polygon_gone/2, regions_again/2 ]).
:- use_module(cycle, [disk/4, radial_cycle/4]).
:- use_module('../disjoint_sets', [set_root/3, sets_joined/4]).
:- use_module(exploded, [region_copied/3]).
:- use_module(glue_choice, [stays_parted/1]).
:- use_module('../kernel', [self_meetings/2, segment_meetings/3]).
:- use_module('../limits', [limit_value/2]).
:- use_module(regions, [region_neighbour/4]).
:- use_module('../store',
              [ v/5, e/5, p/3, t/6, edge_polygon/3, origin/3, from_p/5,
                from_v/4, region/3, sides/4, lies_in/3, assert_fact/1,
                retractall_facts/1, fresh_id/3 ]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(assoc), [empty_assoc/1]).
:- use_module(library(lists), [append/3, list_to_set/2, member/2, nth1/3]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Unglue in part: faces that are parted, a region by itself.

A face that is unglued is there twice, with a slit between. Where slits, voids
or the outside divide the pages round an edge of it, the edge parts, and so
its ends do: a cut that reaches the surface opens, and one inside stays a
slit, whose border is shared. An edge both of whose ends are shared stays one.

origin(S, p(Q), slit(P)) remembers that Q lies on P and is to stay apart from
it, so vertices of S in one place are not made one again (regions_made/2). */

%!  unglued_polygons(+S, +Ps:list, -Change) is det.
%
%   Polygons Ps of the cells S, with different regions on their sides, become
%   two each. Change is as of cells_edited/3; one transaction.
%
%   @error geometry_error(part_glue(unglued(S, p(P)))): there is none, or a
%          side of it is no cell, or both are one; those of cells_edited/3

unglued_polygons(S, Ps, Change) :-
    cells_edited(S, sg_unglue:polygons_parted(S, Ps), Change).

%!  unglued_between(+S, +R1, +R2, -Change) is det.
%
%   The same of all polygons between the regions R1 and R2.
%
%   @error geometry_error(part_glue(unglued(S, R1-R2))): there are none

unglued_between(S, R1, R2, Change) :-
    findall(P, region_neighbour(S, R1, R2, P), Ps0),
    sort(Ps0, Ps),
    (   Ps \== []
    ->  unglued_polygons(S, Ps, Change)
    ;   geometry_error(part_glue(unglued(S, R1-R2)))
    ).

polygons_parted(S, Ps) :-
    forall(member(P, Ps), glued_polygon(S, P)),
    maplist(twin_there(S), Ps, Twins),
    regions_again(S, _),
    append(Ps, Twins, Faces),
    vertices_of(S, Faces, Vs),
    findall(V-Classes,
            ( member(V, Vs), classes_at(S, V, Faces, Classes),
              Classes = [_,_|_] ),
            Parted),
    forall(member(V-[_|Classes], Parted),
           forall(member(Class, Classes), vertex_parted(S, V, Class, _))).

glued_polygon(S, P) :-
    (   sides(S, P, Below, Above),
        Below =\= Above,
        \+ gap(S, Below),
        \+ gap(S, Above)
    ->  true
    ;   geometry_error(part_glue(unglued(S, p(P))))
    ).

geometry_error(What) :-
    throw(error(geometry_error(What), _)).

gap(S, R) :-
    region(S, R, Role),
    Role \== cell,
    !.

%!  twin_there(+S, +P, -Q) is det.
%
%   Q is polygon P of the cells S once more, and lies on it.

twin_there(S, P, Q) :-
    p(S, P, Es),
    fresh_id(p, S, Q),
    maplist(edge_again(S), Es, Es1),
    assert_fact(p(S, Q, Es1)),
    assert_fact(origin(S, p(Q), slit(P))),
    forall(from_p(S, P, S0, P0, Sense),
           assert_fact(from_p(S, Q, S0, P0, Sense))),
    forall(lies_in(S, v(V), p(P)), assert_fact(lies_in(S, v(V), p(Q)))).

edge_again(S, E, E1) :-
    e(S, E, A, B, Real),
    fresh_id(e, S, E1),
    assert_fact(e(S, E1, A, B, Real)).

vertices_of(S, Ps, Vs) :-
    findall(V, ( member(P, Ps), p(S, P, Es), member(E, Es), e(S, E, V, _, _) ),
            Vs0),
    sort(Vs0, Vs).

%   classes_at(S, V, Faces, Classes): lists of polygons at V that hang
%   together by edges as they part; the first also has the disks that none of
%   Faces is in.

classes_at(S, V, Faces, Classes) :-
    findall(Items, ( disk(S, V, _, Items0), polygons(Items0, Items),
                     member(P, Items), memberchk(P, Faces) ), Disks0),
    list_to_set(Disks0, Disks),
    findall(Class, ( member(Disk, Disks), parted_disk(S, V, Disk, Class) ),
            Classes).

polygons(Items, Ps) :-
    findall(P, member(p(P), Items), Ps).

parted_disk(S, V, Disk, Class) :-
    findall(A-B, run_at(S, V, A, B), Links),
    empty_assoc(Sets0),
    foldl(linked, Links, Sets0, Sets),
    findall(Root-P, ( member(P, Disk), set_root(Sets, P, Root) ), Pairs0),
    sort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups0),
    findall(Least-Ps, ( member(_-Ps, Groups0), Ps = [Least|_] ), Groups1),
    sort(Groups1, Groups),
    member(_-Class, Groups).

linked(A-B, Sets0, Sets) :-
    sets_joined(A, B, Sets0, Sets).

%   run_at(S, V, P, Q) is nondet: pages P and Q of an edge at V stay together:
%   P is before Q and no gap is between, or the edge does not part.

run_at(S, V, P, Q) :-
    findall(W, ( e(S, _, V, W, _) ; e(S, _, W, V, _) ), Ws0),
    sort(Ws0, Ws),
    member(W, Ws),
    A is min(V, W),
    B is max(V, W),
    once(radial_cycle(S, A, B, Pages)),
    Pages = [First|_],
    findall(R, ( member(page(_,_,R), Pages), gap(S, R) ), Gaps),
    (   Gaps = [_,_|_],
        member(Slit, Gaps),
        region(S, Slit, slit)
    ->  append(Pages, [First], Round),
        append(_, [page(P,_,R),page(Q,_,_)|_], Round),
        \+ gap(S, R)
    ;   First = page(P,_,_),
        member(page(Q,_,_), Pages)
    ).

%!  vertex_parted(+S, +V, +Ps:list, -W) is det.
%
%   A new vertex W in the place of V is that of the polygons Ps of S.

vertex_parted(S, V, Ps, W) :-
    once(v(S, V, X, Y, Z)),
    fresh_id(v, S, W),
    assert_fact(v(S, W, X, Y, Z)),
    forall(origin(S, v(V), Origin), assert_fact(origin(S, v(W), Origin))),
    forall(from_v(S, V, S0, V0), assert_fact(from_v(S, W, S0, V0))),
    forall(( member(P, Ps), p(S, P, Es), member(E, Es),
             e(S, E, A0, B0, Real), ( A0 == V ; B0 == V ) ),
           ( other(V, W, A0, A),
             other(V, W, B0, B),
             retractall_facts(e(S, E, _, _, _)),
             assert_fact(e(S, E, A, B, Real)) )),
    forall(( member(P, Ps), t(S, P, T, A0, B0, C0),
             memberchk(V, [A0,B0,C0]) ),
           ( maplist(other(V, W), [A0,B0,C0], [A,B,C]),
             retractall_facts(t(S, P, T, _, _, _)),
             assert_fact(t(S, P, T, A, B, C)) )).

other(V, W, A0, A) :-
    (   A0 == V
    ->  A = W
    ;   A = A0
    ).

%!  unglued_region(+S, +R, -N, -Change) is det.
%
%   Cell R of the cells S is the solid N then, and sheets in it are surfaces;
%   the rest of S stays glued. Change is that of S; one transaction.
%
%   @error geometry_error(part_glue(unglued(S, r(R)))): there is no such cell;
%          those of cells_edited/3

unglued_region(S, R, N, Change) :-
    cells_edited(S, sg_unglue:region_parted(S, R, N), Change).

region_parted(S, R, N) :-
    (   region(S, R, cell)
    ->  true
    ;   geometry_error(part_glue(unglued(S, r(R))))
    ),
    region_copied(S, R, [N|_]),
    findall(P,
            ( sides(S, P, Below, Above),
              of_region_alone(S, R, Below, Above) ),
            Ps),
    vertices_of(S, Ps, Vs),
    findall(E, lies_in(S, e(E), r(R)), Wires),
    forall(member(E, Wires),
           ( retractall_facts(lies_in(S, e(E), _)),
             retractall_facts(e(S, E, _, _, _)) )),
    forall(member(P, Ps), polygon_gone(S, P)),
    forall(( member(V, Vs), \+ e(S, _, V, _, _), \+ e(S, _, _, V, _) ),
           ( retractall_facts(lies_in(S, v(V), _)),
             retractall_facts(origin(S, v(V), _)),
             retractall_facts(from_v(S, V, _, _)),
             retractall_facts(v(S, V, _, _, _)) )).

%   of_region_alone(S, R, Below, Above): no cell is on the other side.

of_region_alone(_, R, R, R).
of_region_alone(S, R, R, Above) :-
    Above =\= R,
    gap(S, Above).
of_region_alone(S, R, Below, R) :-
    Below =\= R,
    gap(S, Below).

%!  meetings_unmeant(+Most, -Selves:list) is det.
%
%   Selves are as of self_meetings/2, without what lies on each other, or
%   touches in corners, because it was unglued.

meetings_unmeant(Most, Selves) :-
    self_meetings(Most, Selves0),
    maplist(without_slits(Most), Selves0, Selves).

without_slits(Most, self(S, Counts0, Meetings0), self(S, Counts, Meetings)) :-
    (   stays_parted(S)
    ->  segment_unmeant(S, Unmeant),
        findall(Kind-Meeting,
                ( member(Meeting, Unmeant), arg(1, Meeting, Kind) ),
                Pairs0),
        keysort(Pairs0, Pairs),
        group_pairs_by_key(Pairs, Groups),
        findall(Kind-N, ( member(Kind-List, Groups), length(List, N) ), Counts),
        findall(Meeting, ( nth1(I, Pairs, _-Meeting), I =< Most ), Meetings)
    ;   Counts = Counts0,
        Meetings = Meetings0
    ).

%   segment_unmeant(S, Meetings): those of segment S with itself, without the
%   same.

segment_unmeant(S, Meetings) :-
    limit_value(facets, All),
    segment_meetings(S, All, Segments),
    findall(Meeting,
            ( member(self(S, _, Meetings1), Segments),
              member(Meeting, Meetings1),
              \+ slit_meeting(S, Meeting) ),
            Meetings).

slit_meeting(S, meeting(self_overlap, P, Q, _, _, _)) :-
    (   origin(S, p(Q), slit(P))
    ;   origin(S, p(P), slit(Q))
    ),
    !.
slit_meeting(S, meeting(self_touching, P, Q, _, _, _)) :-
    corner(S, P, X, Y, Z),
    corner(S, Q, X, Y, Z),
    !.

corner(S, P, X, Y, Z) :-
    p(S, P, Es),
    member(E, Es),
    e(S, E, V, _, _),
    v(S, V, X, Y, Z).
