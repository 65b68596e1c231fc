:- module(sg_part_glue,
          [ glue_vertices/4,            % +S, +V1, +V2, -Change
            glue_edges/4,               % +S, +Edge1, +Edge2, -Change
            glue_faces/4,               % +S, +P1, +P2, -Change
            glue_mixed/4                % +S, +Item1, +Item2, -Change
          ]).
:- use_module(csg_evaluate, [evaluate/2]).
:- use_module('../csg/csg', [node/4]).
:- use_module('../csg/csg_record', [recorded/2]).
:- use_module(face_glue, [faces_joined/4]).
:- use_module(glue_contact, [item_context/2, item_seats/3]).
:- use_module(glue_divide, [is_edge/3]).
:- use_module('../gluing/cells_edit', [place_of/3]).
:- use_module('../gluing/contact_glue',
              [ edges_joined/4, mixed_joined/4, not_glued/4, vertices_joined/4
              ]).
:- use_module('../gluing/regions', [regions_report/2]).
:- use_module('../store',
              [ v/5, e/5, p/3, from_p/5, lies_in/3, gluing/2, assert_fact/1,
                retract_fact/1, facts_transaction/1 ]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(error), [existence_error/2]).
:- use_module(library(lists), [member/2]).
/** <module> Glue in one place (NG-2 to NG-5): cells, or a glue with operands.

Cells without operands are edited (contact_glue.pl, face_glue.pl). In a glue
everything is cut already; what a wish or may_glue/3 kept apart in it is glued
by a wish more, gluing(S, glued(Place1, Place2)), and its boundary made anew. So
it stays so in its file, and operands are as they were. */

%!  glue_vertices(+S, +V1, +V2, -Change) is det.
%
%   Vertex V2 of S becomes V1, which is in exactly the same place. Change is
%   change(V, E, F, L, C, R, S, G), how many more there are; one transaction.
%
%   @error existence_error(vertex, V); geometry_error(part_glue(not_glued(S,
%          v(V1), v(V2), Why))): Why is `apart`, `crossing` or `touching`; see
%          vertices_joined/4

glue_vertices(S, V1, V2, Change) :-
    (   node(S, glue, _, _)
    ->  facts_transaction(
            sg_part_glue:items_glued(S, v(V1), v(V2), Change))
    ;   vertices_joined(S, V1, V2, Change)
    ).

%!  glue_edges(+S, +Edge1, +Edge2, -Change) is det.
%
%   The same of edges A-B; of cells in what they have in common: see
%   edges_joined/4.

glue_edges(S, A-B, C-D, Change) :-
    (   node(S, glue, _, _)
    ->  facts_transaction(
            sg_part_glue:items_glued(S, e(A-B), e(C-D), Change))
    ;   edges_joined(S, A-B, C-D, Change)
    ).

%!  glue_faces(+S, +P1, +P2, -Change) is det.
%
%   The same of polygons in one plane; of cells in what they have in common: see
%   faces_joined/4.

glue_faces(S, P1, P2, Change) :-
    (   node(S, glue, _, _)
    ->  facts_transaction(
            sg_part_glue:items_glued(S, p(P1), p(P2), Change))
    ;   faces_joined(S, P1, P2, Change)
    ).

%!  glue_mixed(+S, +Item1, +Item2, -Change) is det.
%
%   Glue v(V) to e(E), v(V) to p(P), or e(E) to p(P), where E is the number of
%   an edge: see mixed_joined/4. In a glue with operands the edge ends, or the
%   polygon has a vertex or an edge, where the other one is.

glue_mixed(S, Item1, Item2, Change) :-
    (   node(S, glue, _, _)
    ->  facts_transaction(
            sg_part_glue:mixed_glued(S, Item1, Item2, Change))
    ;   mixed_joined(S, Item1, Item2, Change)
    ).

mixed_glued(S, Item1, Item2, Change) :-
    known_item(S, Item1),
    known_item(S, Item2),
    (   counterpart(S, Item1, Item2, Own, Other)
    ->  items_glued(S, Own, Other, Change)
    ;   not_glued(S, Item1, Item2, beside)
    ).

%   counterpart(S, Item1, Item2, Own, Other): Other of Item2 is in the place of
%   Item1, or Own.

counterpart(S, v(V), Item2, v(V), v(W)) :-
    item_vertex(S, Item2, W),
    V \== W,
    same_place(S, V, W).
counterpart(S, e(E), p(P), e(A-B), e(C-D)) :-
    once(e(S, E, A, B, _)),
    p(S, P, Es),
    member(E1, Es),
    e(S, E1, C, D, _),
    same_place(S, A, C),
    same_place(S, B, D).

item_vertex(S, e(E), V) :-
    e(S, E, A, B, _),
    ( V = A ; V = B ).
item_vertex(S, p(P), V) :-
    p(S, P, Es),
    member(E, Es),
    e(S, E, V, _, _).
item_vertex(S, p(P), V) :-
    lies_in(S, v(V), p(P)).

same_place(S, V, W) :-
    place_of(S, V, Place),
    place_of(S, W, Place).

known_item(S, Item) :-
    (   there(Item, S)
    ->  true
    ;   item_name(Item, Type, Id),
        existence_error(Type, Id)
    ).

there(v(V), S) :-
    v(S, V, _, _, _).
there(e(E), S) :-
    e(S, E, _, _, _).
there(e(A-B), S) :-
    is_edge(S, A, B).
there(p(P), S) :-
    p(S, P, _).

item_name(v(V), vertex, V).
item_name(e(E), edge, E).
item_name(p(P), polygon, P).

%   items_glued(S, Item1, Item2, Change): by the first wish, of places of their
%   operands, that changes something.

items_glued(S, Item1, Item2, Change) :-
    known_item(S, Item1),
    known_item(S, Item2),
    regions_report(S, Before),
    (   one_place(S, Item1, Item2),
        places(S, Item1, Item2, Place1, Place2),
        catch(wished(S, Place1, Place2), error(geometry_error(Fault), _),
              ( Fault = glue_law(_, _)
              ->  not_glued(S, Item1, Item2, touching)
              ;   throw(error(geometry_error(Fault), _)) )),
        regions_report(S, After),
        changed(Before.counts, After.counts, Change),
        once(( arg(_, Change, More), More =\= 0 ))
    ->  true
    ;   not_glued(S, Item1, Item2, apart)
    ).

one_place(S, v(V), v(W)) :-
    V \== W,
    same_place(S, V, W).
one_place(S, e(A-B), e(C-D)) :-
    (   same_place(S, A, C)
    ->  same_place(S, B, D)
    ;   same_place(S, A, D),
        same_place(S, B, C)
    ).
one_place(_, p(P), p(Q)) :-
    P \== Q.

%   places(S, Item1, Item2, Place1, Place2) is nondet: S0-Item0 of operands.

places(S, p(P), p(Q), S1-p(P1), S2-p(P2)) :-
    !,
    from_p(S, P, S1, P1, _),
    from_p(S, Q, S2, P2, _),
    S1 \== S2.
places(S, Item1, Item2, S1-Own1, S2-Own2) :-
    item_context(S, Context),
    maplist(seats(Context), [Item1,Item2], [Seats1,Seats2]),
    member(seat(S1,_,Place1), Seats1),
    member(seat(S2,_,Place2), Seats2),
    S1 \== S2,
    maplist(place_item, [Place1,Place2], [Own1,Own2]).

seats(Context, Item0, Seats) :-
    (   Item0 = e(A-B)
    ->  V is min(A, B),
        W is max(A, B),
        Item = e(V,W)
    ;   Item = Item0
    ),
    once(item_seats(Context, Item, Seats)).

place_item(vertex(V), v(V)).
place_item(edge(A,B), e(A,B)).
place_item(face(P,_), p(P)).

%   wished(S, Place1, Place2) is nondet: what is wished is so, or is not wished
%   any more.

wished(S, Place1, Place2) :-
    Wish = gluing(S, glued(Place1, Place2)),
    recorded(S, evaluated(glue(_,Tolerance,_))),
    tolerance_options(Tolerance, Options),
    assert_fact(Wish),
    (   evaluate(S, Options)
    ;   retract_fact(Wish),
        evaluate(S, Options),
        fail
    ).

tolerance_options(default, []) :-
    !.
tolerance_options(Tolerance, [tolerance(Tolerance)]).

changed(Before, After, Change) :-
    maplist(more(Before, After),
            [vertices,edges,faces,loops,parts,regions,shells,genus], Mores),
    Change =.. [change|Mores].

more(Before, After, Key, More) :-
    More is After.Key-Before.Key.
