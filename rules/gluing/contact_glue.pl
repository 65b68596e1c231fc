:- module(sg_contact_glue,
          [ vertices_joined/4,          % +S, +V1, +V2, -Change
            mixed_joined/4,             % +S, +Item1, +Item2, -Change
            edges_joined/4,             % +S, +Edge1, +Edge2, -Change
            not_glued/4,                % +S, +Item1, +Item2, +Why
            vertex_inside/3,            % +S, +V, +P
            vertices_between/5          % +S, +A, +B, +Vs, -Inner
          ]).
:- use_module(cells_edit,
              [ cells_edited/3, edge_there/3, edge_divided/4,
                vertices_renamed/3, wires_gone/3, place_of/3 ]).
:- use_module(cycle, [disk/4]).
:- use_module('../near', [tolerance/2]).
:- use_module('../store',
              [ v/5, e/5, p/3, t/6, lies_in/3, assert_fact/1,
                retractall_facts/1, fresh_id/3 ]).
:- use_module('../vector',
              [ cross_product/3, difference/3, dot_product/3, left_of/4 ]).
:- use_module(vertex_disk, [disks_meet/4, disks_touch/2]).
:- use_module(library(error), [existence_error/2]).
:- use_module(library(lists), [append/2, append/3, member/2]).
:- use_module(library(pairs), [pairs_values/2]).
/** <module> Glue in one place: vertices, edges, and vertices and edges with
what is larger (NG-2, NG-3, NG-5).

Each is one transaction on cells, after which regions are found again and both
laws are counted (cells_edit.pl). What coincides has one vertex or edge then.
Nothing else is looked for: `glue` finds all that meets. Of a glue that has
operands, see part_glue.pl.
*/

%!  vertices_joined(+S, +V1, +V2, -Change) is det.
%
%   Vertex V2 of the cells S becomes V1, which is in exactly the same place.
%   Change is as of cells_edited/3.
%
%   @error existence_error(vertex, V); geometry_error(part_glue(not_glued(S,
%          v(V1), v(V2), Why))): Why is `apart`, `crossing` (disk_relation/3
%          says that disks go through each other) or `touching` (edges of both
%          have one direction: these are to be glued, or faces); those of
%          cells_edited/3

vertices_joined(S, V1, V2, Change) :-
    cells_edited(S, sg_contact_glue:vertices_glued(S, V1, V2), Change).

vertices_glued(S, V1, V2) :-
    vertex_place(S, V1, Place1),
    vertex_place(S, V2, Place2),
    (   V1 \== V2,
        Place1 == Place2
    ->  true
    ;   not_glued(S, v(V1), v(V2), apart)
    ),
    forall(( disk(S, V1, D1, _), disk(S, V2, D2, _) ),
           disks_free(S, V1, D1, V2, D2)),
    vertices_renamed(S, V2, V1).

vertex_place(S, V, Place) :-
    (   v(S, V, _, _, _)
    ->  place_of(S, V, Place)
    ;   existence_error(vertex, V)
    ).

disks_free(S, V1, D1, V2, D2) :-
    Disk1 = disk(S,V1,D1),
    Disk2 = disk(S,V2,D2),
    (   disks_touch(Disk1, Disk2)
    ->  not_glued(S, v(V1), v(V2), touching)
    ;   disks_meet(Disk1, Disk2, _, _)
    ->  true
    ;   not_glued(S, v(V1), v(V2), crossing)
    ).

%!  not_glued(+S, +Item1, +Item2, +Why)
%
%   @error geometry_error(part_glue(not_glued(S, Item1, Item2, Why)))

not_glued(S, Item1, Item2, Why) :-
    Fault = not_glued(S, Item1, Item2, Why),
    throw(error(geometry_error(part_glue(Fault)), _)).

%!  mixed_joined(+S, +Item1, +Item2, -Change) is det.
%
%   Glue a vertex to an edge, v(V) and e(E): the edge is divided there; a
%   vertex to a polygon, v(V) and p(P): it is a point loop of P; or an edge to
%   a polygon, e(E) and p(P): it is a seam of P, and its ends, where they are
%   in P, are of the seam. In this order. Change is as of cells_edited/3.
%
%   @error as vertices_joined/4; Why is also `beside`: the vertex is not in the
%          edge, or not inside the polygon

mixed_joined(S, Item1, Item2, Change) :-
    cells_edited(S, sg_contact_glue:mixed_glued(Item1, Item2, S), Change).

mixed_glued(v(V), e(E), S) :-
    !,
    edge_ends(S, E, A, B),
    vertex_place(S, V, _),
    (   between(S, A, B, V, _)
    ->  true
    ;   not_glued(S, v(V), e(E), beside)
    ),
    edge_divided(S, A, B, V).
mixed_glued(v(V), p(P), S) :-
    !,
    vertex_place(S, V, _),
    inside_polygon(S, V, P),
    (   lies_in(S, v(V), p(P))
    ->  true
    ;   assert_fact(lies_in(S, v(V), p(P)))
    ).
mixed_glued(e(E), p(P), S) :-
    edge_ends(S, E, A, B),
    inside_polygon(S, A, P),
    inside_polygon(S, B, P),
    wires_gone(S, A, B),
    p(S, P, Es),
    fresh_id(e, S, E1),
    fresh_id(e, S, E2),
    append(Es, [E1,E2], Es1),
    assert_fact(e(S, E1, A, B, 1)),
    assert_fact(e(S, E2, B, A, 1)),
    retractall_facts(p(S, P, _)),
    retractall_facts(t(S, P, _, _, _, _)),
    retractall_facts(plane(S, P, _, _, _, _)),
    retractall_facts(lies_in(S, v(A), p(P))),
    retractall_facts(lies_in(S, v(B), p(P))),
    assert_fact(p(S, P, Es1)).

edge_ends(S, E, A, B) :-
    (   e(S, E, A0, B0, _)
    ->  A = A0,
        B = B0
    ;   existence_error(edge, E)
    ).

inside_polygon(S, V, P) :-
    (   p(S, P, _)
    ->  true
    ;   existence_error(polygon, P)
    ),
    (   vertex_inside(S, V, P)
    ->  true
    ;   not_glued(S, v(V), p(P), beside)
    ).

%!  vertex_inside(+S, +V, +P) is semidet.
%
%   Vertex V is in a triangle of polygon P, within rounding, and is no corner of
%   the polygon.

vertex_inside(S, V, P) :-
    p(S, P, Es),
    \+ ( member(E, Es), e(S, E, V, _, _) ),
    t(S, P, _, A, B, C),
    in_triangle(S, V, A, B, C),
    !.

in_triangle(S, V, A, B, C) :-
    place_of(S, V, PV),
    place_of(S, A, PA),
    place_of(S, B, PB),
    place_of(S, C, PC),
    difference(PB, PA, U),
    difference(PC, PA, W),
    cross_product(U, W, N),
    dot_product(N, N, Square),
    difference(PV, PA, From),
    dot_product(From, N, Height),
    tolerance(rounding, Near),
    dot_product(U, U, UU),
    abs(float(Height)) =< Near*sqrt(float(Square))*sqrt(float(UU)),
    left_of(N, PA, PB, PV),
    left_of(N, PB, PC, PV),
    left_of(N, PC, PA, PV).

%   between(S, A, B, V, At): V lies in the edge from A to B within rounding, and
%   is no end of it; At grows from A to B.

between(S, A, B, V, At) :-
    V \== A,
    V \== B,
    place_of(S, A, PA),
    place_of(S, B, PB),
    place_of(S, V, PV),
    difference(PB, PA, U),
    difference(PV, PA, W),
    dot_product(U, U, UU),
    dot_product(U, W, At),
    At > 0,
    At < UU,
    cross_product(U, W, N),
    dot_product(N, N, Square),
    tolerance(rounding, Near),
    sqrt(float(Square)) =< Near*float(UU).

%!  edges_joined(+S, +Edge1, +Edge2, -Change) is det.
%
%   Glue the edges Edge1 and Edge2 of the cells S, A-B of two vertices, in
%   what they have in common: each is divided at the ends of the other one,
%   ends in one place are one vertex, and then there is one edge there, with
%   the pages of both. Change is as of cells_edited/3.
%
%   @error existence_error(edge, Edge); geometry_error(part_glue(not_glued(S,
%          e(Edge1), e(Edge2), apart))): they have no line in common; those of
%          cells_edited/3

edges_joined(S, Edge1, Edge2, Change) :-
    cells_edited(S, sg_contact_glue:edges_glued(S, Edge1, Edge2), Change).

edges_glued(S, A-B, C-D) :-
    an_edge(S, A, B),
    an_edge(S, C, D),
    vertices_between(S, A, B, [C,D], Inner1),
    vertices_between(S, C, D, [A,B], Inner2),
    findall(V-W,
            ( member(V, [A,B]), member(W, [C,D]), V \== W,
              place_of(S, V, Place), place_of(S, W, Place) ),
            Same),
    findall(End, ( member(End, Inner1) ; member(End, Inner2)
                 ; member(End-_, Same)
                 ; member(End, [A,B]), memberchk(End, [C,D]) ), Ends0),
    sort(Ends0, Ends),
    (   Ends = [_,_|_]
    ->  true
    ;   not_glued(S, e(A-B), e(C-D), apart)
    ),
    divided(S, A, B, Inner1),
    divided(S, C, D, Inner2),
    forall(member(V-W, Same), vertices_renamed(S, W, V)).

an_edge(S, A, B) :-
    (   edge_there(S, A, B)
    ->  true
    ;   existence_error(edge, A-B)
    ).

%!  vertices_between(+S, +A, +B, +Vs:list, -Inner:list) is det.
%
%   Inner are those of the vertices Vs that lie between A and B, in line within
%   rounding, in order from A.

vertices_between(S, A, B, Vs, Inner) :-
    findall(At-V, ( member(V, Vs), between(S, A, B, V, At) ), Pairs0),
    keysort(Pairs0, Pairs),
    pairs_values(Pairs, Inner).

divided(_, _, _, []).
divided(S, A, B, [V|Vs]) :-
    edge_divided(S, A, B, V),
    divided(S, V, B, Vs).
