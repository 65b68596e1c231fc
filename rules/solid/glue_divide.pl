:- module(sg_glue_divide,
          [ edge_divided/5,             % +S, +V, +Edge, +Changed0, -Changed
            seam_added/4,               % +S, +P, +V1, +V2
            polygons_divided/2,         % +S, +Ps
            is_edge/3,                  % +S, ?V1, ?V2
            has_vertex/3                % +S, +P, +V
          ]).
:- use_module('../polygon/triangulation', [complete_segments/1]).
:- use_module('../gluing/triangle_corners', [rational_place/3]).
:- use_module('../store',
              [ e/5, p/3, t/6, plane/6, edge_polygon/3, from_p/5, lies_in/3,
                assert_fact/1, fresh_id/3, retract_fact/1,
                retractall_facts/1
              ]).
:- use_module('../vector', [cross_product/3, difference/3, left_of/4]).
:- use_module(library(apply), [foldl/4, maplist/2]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [append/2, append/3, member/2]).
:- use_module(library(ordsets), [ord_memberchk/2, ord_subtract/3]).
/** <module> Edges and faces divided by what was glued to them.

An edge gets a vertex in all the faces at it. A face gets a seam, an edge there
and back; where seams part it, it becomes several: what its triangles say.
*/

%!  is_edge(+S, ?V1, ?V2) is semidet.
%
%   V1 and V2 of segment S are the ends of an edge, whichever way it runs.

is_edge(S, V1, V2) :-
    (   e(S, _, V1, V2, _)
    ;   e(S, _, V2, V1, _)
    ),
    !.

%!  has_vertex(+S, +P, +V) is semidet.
%
%   V is on the border of polygon P of segment S.

has_vertex(S, P, V) :-
    e(S, E, V, _, _),
    edge_polygon(S, E, P),
    !.

%!  edge_divided(+S, +V, +Edge, +Changed0:list, -Changed:list) is det.
%
%   The edge V1-V2 of segment S, in all polygons and as a wire, goes by way of
%   vertex V. Changed has the polygons at it before those of Changed0.

edge_divided(S, V, V1-V2, Changed0, Changed) :-
    findall(half(E, A, B, Real),
            (   e(S, E, V1, V2, Real),
                A-B = V1-V2
            ;   e(S, E, V2, V1, Real),
                A-B = V2-V1
            ),
            Halves),
    foldl(half_divided(S, V), Halves, Changed0, Changed).

half_divided(S, V, half(E, A, B, Real), Changed0, Changed) :-
    findall(P, edge_polygon(S, E, P), Ps),
    fresh_id(e, S, E1),
    fresh_id(e, S, E2),
    assert_fact(e(S, E1, A, V, Real)),
    assert_fact(e(S, E2, V, B, Real)),
    forall(member(P, Ps), list_changed(S, P, E, [E1,E2])),
    retractall_facts(e(S, E, _, _, _)),
    forall(member(P, Ps), retractall_facts(lies_in(S, v(V), p(P)))),
    append(Ps, Changed0, Changed).

list_changed(S, P, E, New) :-
    p(S, P, Es0),
    append(Before, [E|After], Es0),
    !,
    append([Before,New,After], Es),
    retractall_facts(p(S, P, _)),
    assert_fact(p(S, P, Es)).

%!  seam_added(+S, +P, +V1, +V2) is det.
%
%   Polygon P of segment S gets an edge from V1 to V2 and back, which runs in
%   it. Its triangles are not what they were: polygons_divided/2.

seam_added(S, P, V1, V2) :-
    fresh_id(e, S, There),
    fresh_id(e, S, Back),
    assert_fact(e(S, There, V1, V2, 1)),
    assert_fact(e(S, Back, V2, V1, 1)),
    p(S, P, Es0),
    (   seam_at(S, V1, Es0, [There,Back], Es)
    ->  true
    ;   seam_at(S, V2, Es0, [Back,There], Es)
    ->  true
    ;   append(Es0, [There,Back], Es)
    ),
    retractall_facts(p(S, P, _)),
    assert_fact(p(S, P, Es)),
    forall(member(V, [V1,V2]), retractall_facts(lies_in(S, v(V), p(P)))).

%   seam_at(S, V, Es0, Seam, Es): before an edge of the list that starts at V.

seam_at(S, V, Es0, Seam, Es) :-
    append(Before, [E|After], Es0),
    e(S, E, V, _, _),
    !,
    append([Before,Seam,[E|After]], Es).

%!  polygons_divided(+S, +Ps:list) is det.
%
%   The polygons Ps of segment S, whose borders are new, get their triangles;
%   where seams part one, its other parts become polygons from the same
%   operands.
%
%   @error geometry_error(wrong_triangles(S, P)): there are no such triangles

polygons_divided(_, []) :-
    !.
polygons_divided(S, Ps) :-
    forall(member(P, Ps), retractall_facts(t(S, P, _, _, _, _))),
    complete_segments([S]),
    maplist(polygon_parted(S), Ps).

polygon_parted(S, P) :-
    findall(T-[A,B,C], t(S, P, T, A, B, C), Triangles),
    p(S, P, Es),
    findall((A-B)-E, ( member(E, Es), e(S, E, A, B, _) ), Sides0),
    sort(Sides0, Sides),
    list_to_assoc(Sides, Border),
    (   ends_where(Triangles, Border, Sides)
    ->  true
    ;   throw(error(geometry_error(wrong_triangles(S, P)), _))
    ),
    parts(Triangles, Border, Parts),
    Parts = [_|Others],
    maplist(part_taken(S, P, Border), Others).

%   ends_where(Triangles, Border, Sides): they have each side of the polygon.

ends_where(Triangles, Border, Sides) :-
    findall(A-B,
            ( member(_-Corners, Triangles),
              side(Corners, A, B),
              get_assoc(A-B, Border, _) ),
            Found0),
    sort(Found0, Found),
    findall(Side, member(Side-_, Sides), Wanted),
    Found == Wanted.

side([A,B,C], V, W) :-
    member(V-W, [A-B,B-C,C-A]).

%   parts(Triangles, Border, Parts): those that hang together by sides that are
%   no edges.

parts([], _, []).
parts([Triangle|Triangles], Border, [Part|Parts]) :-
    grown([Triangle], Triangles, Border, [Triangle], Part, Rest),
    parts(Rest, Border, Parts).

grown([], Rest, _, Part, Part, Rest).
grown([_-Corners|Front0], Triangles0, Border, Part0, Part, Rest) :-
    findall(Other,
            ( side(Corners, A, B),
              \+ get_assoc(A-B, Border, _),
              member(Other, Triangles0),
              Other = _-Corners1,
              side(Corners1, B, A) ),
            Next0),
    sort(Next0, Next),
    sort(Triangles0, Set),
    ord_subtract(Set, Next, Triangles),
    append(Next, Front0, Front),
    append(Part0, Next, Part1),
    grown(Front, Triangles, Border, Part1, Part, Rest).

%   part_taken(S, P, Border, Part): the triangles Part of polygon P, its edges
%   and the vertices that lie in it become a polygon.

part_taken(S, P, Border, Part) :-
    fresh_id(p, S, New),
    findall(E,
            ( member(_-Corners, Part),
              side(Corners, A, B),
              get_assoc(A-B, Border, E) ),
            Taken0),
    sort(Taken0, Taken),
    p(S, P, Es),
    findall(E, ( member(E, Es), ord_memberchk(E, Taken) ), Es1),
    findall(E, ( member(E, Es), \+ ord_memberchk(E, Taken) ), Es2),
    retractall_facts(p(S, P, _)),
    assert_fact(p(S, P, Es2)),
    assert_fact(p(S, New, Es1)),
    forall(plane(S, P, X, Y, Z, D), assert_fact(plane(S, New, X, Y, Z, D))),
    forall(member(T-[A,B,C], Part),
           ( retractall_facts(t(S, P, T, _, _, _)),
             assert_fact(t(S, New, T, A, B, C)) )),
    forall(from_p(S, P, S0, P0, Sense),
           assert_fact(from_p(S, New, S0, P0, Sense))),
    forall(( lies_in(S, v(V), p(P)), in_part(S, V, Part) ),
           ( retract_fact(lies_in(S, v(V), p(P))),
             assert_fact(lies_in(S, v(V), p(New))) )).

in_part(S, V, Part) :-
    rational_place(S, V, At),
    member(_-Corners, Part),
    Corners = [A,B,C],
    rational_place(S, A, From),
    rational_place(S, B, To),
    rational_place(S, C, Last),
    difference(To, From, U),
    difference(Last, From, W),
    cross_product(U, W, N),
    left_of(N, From, To, At),
    left_of(N, To, Last, At),
    left_of(N, Last, From, At),
    !.
