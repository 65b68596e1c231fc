:- module(sg_glue_contact,
          [ contact/4                   % +S, -Kind, -Seat1, -Seat2
          ]).
:- use_module(glue, [glue_operands/2]).
:- use_module('../gluing/triangle_corners', [rational_place/3]).
:- use_module('../kernel', [segments_tolerance/3]).
:- use_module('../penetration/contact', [contact_kind/3]).
:- use_module('../store',
              [ v/5, e/5, p/3, segment/3, edge_polygon/3, from_p/5, lies_in/3
              ]).
:- use_module('../vector', [cross_product/3, difference/3, dot_product/3]).
:- use_module(library(apply), [include/3]).
:- use_module(library(lists), [member/2]).
/** <module> What was glued, feature by feature (NG-1). */

%!  contact(+S, -Kind, -Seat1, -Seat2) is nondet.
%
%   True when the operands of Seat1 and Seat2 of the glue S have a vertex, an
%   edge or a face of it in common. A seat is seat(S0, Item, Place): Item of S
%   is v(V), e(A,B) or p(P), and what of operand S0 is there is Place, as of
%   contact.pl: vertex(V0), edge(A0,B0) or face(P0,none). Kind is as of
%   contact_kind/3. By vertices, then edges, then faces; the operands, which are
%   to have their rows, ascend.

contact(S, Kind, seat(S1,Item,Place1), seat(S2,Item,Place2)) :-
    glue_operands(S, Operands),
    segments_tolerance([S], Reach0, _),
    Reach is rational(Reach0),
    include(is_curve, Operands, Curves),
    item(S, Item),
    findall(S0-P0, item_source(S, Item, S0, P0), Sources0),
    sort(Sources0, Sources),
    findall(S0, ( member(S0, Curves) ; member(S0-_, Sources) ), Ss0),
    sort(Ss0, Ss),
    Ss = [_,_|_],
    findall(seat(S0,Place),
            ( member(S0, Ss),
              memberchk(S0, Operands),
              findall(P0, member(S0-P0, Sources), Ps),
              once(place(Item, S, Reach, S0, Ps, Place)) ),
            Seats),
    member(seat(S1,Place1), Seats),
    member(seat(S2,Place2), Seats),
    S1 < S2,
    contact_kind(Place1, Place2, Kind).

is_curve(S) :-
    segment(S, curve, _),
    !.

%   item(S, Item) is nondet.

item(S, v(V)) :-
    v(S, V, _, _, _).
item(S, e(A,B)) :-
    findall(A0-B0,
            ( e(S, _, V, W, _), A0 is min(V, W), B0 is max(V, W) ), Edges0),
    sort(Edges0, Edges),
    member(A-B, Edges).
item(S, p(P)) :-
    p(S, P, _).

%   item_source(S, Item, S0, P0) is nondet: the polygon P0 of S0 has Item.

item_source(S, Item, S0, P0) :-
    item_polygon(S, Item, P),
    from_p(S, P, S0, P0, _).

item_polygon(_, p(P), P).
item_polygon(S, e(A,B), P) :-
    ( e(S, E, A, B, _) ; e(S, E, B, A, _) ),
    edge_polygon(S, E, P).
item_polygon(S, v(V), P) :-
    (   e(S, E, V, _, _),
        edge_polygon(S, E, P)
    ;   lies_in(S, v(V), p(P))
    ).

%   place(Item, S, Reach, S0, Ps, Place) is nondet: the smallest feature of S0
%   that has Item first. Ps are the polygons of S0 there, [] of a curve.

place(v(V), S, Reach, S0, Ps, vertex(V0)) :-
    rational_place(S, V, At),
    own_edge(S0, Ps, A0, B0),
    member(V0, [A0,B0]),
    rational_place(S0, V0, At0),
    difference(At, At0, D),
    dot_product(D, D, Square),
    Square =< Reach*Reach.
place(v(V), S, Reach, S0, Ps, edge(A0,B0)) :-
    own_edge(S0, Ps, A0, B0),
    is_along(S0, A0, B0, S, V, Reach).
place(e(A,B), S, Reach, S0, Ps, edge(A0,B0)) :-
    own_edge(S0, Ps, A0, B0),
    is_along(S0, A0, B0, S, A, Reach),
    is_along(S0, A0, B0, S, B, Reach).
place(_, _, _, _, [P0|_], face(P0,none)).

own_edge(S0, Ps, A0, B0) :-
    (   Ps == []
    ->  e(S0, _, V, W, 1)
    ;   member(P0, Ps),
        p(S0, P0, Es),
        member(E, Es),
        e(S0, E, V, W, 1)
    ),
    A0 is min(V, W),
    B0 is max(V, W).

%   is_along(S0, A0, B0, S, V, Reach): vertex V of S is on edge A0-B0 of S0.

is_along(S0, A0, B0, S, V, Reach) :-
    rational_place(S0, A0, A),
    rational_place(S0, B0, B),
    rational_place(S, V, At),
    difference(B, A, D),
    difference(At, A, W),
    dot_product(D, D, Length),
    dot_product(W, D, Along),
    cross_product(W, D, X),
    dot_product(X, X, Off),
    Off =< Reach*Reach*Length,
    within(Along, Length, Reach).

%   within(Along, Length, Reach): of the square of the length, and beyond it by
%   Reach at most.

within(Along, Length, Reach) :-
    (   Along < 0
    ->  Along*Along =< Reach*Reach*Length
    ;   Along > Length
    ->  (Along-Length)**2 =< Reach*Reach*Length
    ;   true
    ).
