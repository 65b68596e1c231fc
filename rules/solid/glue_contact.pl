:- module(sg_glue_contact,
          [ contact/4,                  % +S, -Kind, -Seat1, -Seat2
            contact_counts/2,           % +S, -Counts
            contact_context/2,          % +S, -Context
            item_context/2,             % +S, -Context
            item_seats/3,               % +Context, ?Item, -Seats
            seats_contact/4             % +Seats, -Kind, -Seat1, -Seat2
          ]).
:- use_module('../csg/csg', [glue_operands/2]).
:- use_module('../gluing/triangle_corners', [rational_place/3]).
:- use_module('../kernel', [segments_tolerance/3]).
:- use_module('../penetration/contact', [contact_kind/3]).
:- use_module('../store',
              [ v/5, e/5, p/3, segment/3, edge_polygon/3, from_p/5, lies_in/3
              ]).
:- use_module('../vector', [cross_product/3, difference/3, dot_product/3]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [foldl/4, include/3, maplist/3]).
:- use_module(library(assoc), [gen_assoc/3, get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(ordsets), [ord_memberchk/2, ord_union/3]).
/** <module> What was glued, feature by feature (NG-1).

    seat(S0, Item, Place)     what of operand S0 is at Item of the glue

Item is v(V), e(A,B) with A < B, or p(P) of the glue; Place is as of contact.pl:
vertex(V0), edge(A0,B0) or face(P0,none) of S0. */

%!  contact(+S, -Kind, -Seat1, -Seat2) is nondet.
%
%   True when the operands of Seat1 and Seat2 of the glue S have a vertex, an
%   edge or a face of it in common. Kind is as of contact_kind/3. By vertices,
%   then edges, then faces; the operands, which are to have their rows, ascend.

contact(S, Kind, Seat1, Seat2) :-
    Seat1 = seat(_,Item,_),
    (   var(Item)
    ->  contact_context(S, Context)
    ;   item_context(S, Context)
    ),
    item_seats(Context, Item, Seats),
    seats_contact(Seats, Kind, Seat1, Seat2).

%!  contact_counts(+S, -Counts:list) is det.
%
%   Counts are dicts of kind and count, of all contact/4 of the glue S: the
%   smaller features first.

contact_counts(S, Counts) :-
    contact_context(S, Context),
    findall(Numbers,
            ( item_seats(Context, _, Seats),
              Seats = [_,_|_],
              seat_numbers(Seats, Numbers) ),
            All),
    foldl(pairs_added, All, n(0,0,0,0,0,0), Totals),
    findall(_{kind:Kind, count:N},
            ( arg(I, n('vertex-vertex','vertex-edge','vertex-face','edge-edge',
                       'edge-face','face-face'), Kind),
              arg(I, Totals, N),
              N > 0 ),
            Counts).

%   seat_numbers(Seats, n(V, E, F)): how many are vertices, edges and faces.

seat_numbers(Seats, n(V,E,F)) :-
    maplist(seats_of(Seats), [vertex(_),edge(_,_),face(_,_)], [V,E,F]).

seats_of(Seats, Place, N) :-
    aggregate_all(count, member(seat(_,_,Place), Seats), N).

pairs_added(n(V,E,F), n(VV0,VE0,VF0,EE0,EF0,FF0), n(VV,VE,VF,EE,EF,FF)) :-
    VV is VV0+V*(V-1)//2,
    VE is VE0+V*E,
    VF is VF0+V*F,
    EE is EE0+E*(E-1)//2,
    EF is EF0+E*F,
    FF is FF0+F*(F-1)//2.

%!  contact_context(+S, -Context) is det.
%
%   Context is what item_seats/3 has to know of the glue S to tell of all items.

contact_context(S, context(S,Operands,Curves,Reach,known(Corners))) :-
    item_context(S, context(S,Operands,Curves,Reach,_)),
    findall(at(X,Y,Z)-0-V, v(S, V, X, Y, Z), Own),
    findall(at(X,Y,Z)-S0-V0, ( gen_assoc(S0, Operands, _), v(S0, V0, X, Y, Z) ),
            Theirs),
    append(Own, Theirs, All0),
    sort(All0, All),
    phrase(corners(All), Pairs0),
    keysort(Pairs0, Pairs),
    list_to_assoc(Pairs, Corners).

%   corners(Places)//: V-Ends, of each vertex V of the glue what operands have
%   in exactly its place, S0-V0. Several of the glue are first.

corners([]) -->
    [].
corners([At-S0-V|Places0]) -->
    { there(At, Places0, Places, There),
      own([S0-V|There], Vs, Ends) },
    corners_(Vs, Ends),
    corners(Places).

there(At, [At1-S0-V|Places0], Places, There) :-
    At1 == At,
    !,
    There = [S0-V|There1],
    there(At, Places0, Places, There1).
there(_, Places, Places, []).

own([0-V|There], [V|Vs], Ends) :-
    !,
    own(There, Vs, Ends).
own(Ends, [], Ends).

corners_([], _) -->
    [].
corners_([V|Vs], Ends) -->
    [V-Ends],
    corners_(Vs, Ends).

%!  item_context(+S, -Context) is det.
%
%   The same, to tell of a few items.

item_context(S, context(S,Known,Curves,Reach,unknown)) :-
    glue_operands(S, Operands0),
    sort(Operands0, Operands),
    segments_tolerance([S], Reach0, _),
    Reach is rational(Reach0),
    include(is_curve, Operands, Curves),
    findall(S0-S0, member(S0, Operands), Pairs),
    list_to_assoc(Pairs, Known).

is_curve(S) :-
    segment(S, curve, _),
    !.

%!  seats_contact(+Seats:list, -Kind, -Seat1, -Seat2) is nondet.
%
%   Seat1 and Seat2 are two of Seats, which are of one item.

seats_contact(Seats, Kind, seat(S1,Item,Place1), seat(S2,Item,Place2)) :-
    Seats = [_,_|_],
    member(seat(S1,Item,Place1), Seats),
    member(seat(S2,Item,Place2), Seats),
    S1 < S2,
    contact_kind(Place1, Place2, Kind).

%!  item_seats(+Context, ?Item, -Seats:list) is nondet.
%
%   Seats are those of all operands that have Item, by operand.

item_seats(context(S,Operands,Curves,Reach,Known), Item, Seats) :-
    item(S, Item),
    findall(S0-P0, item_source(S, Item, S0, P0), Sources0),
    sort(Sources0, Sources),
    findall(S0, member(S0-_, Sources), Ss0),
    sort(Ss0, Ss1),
    ord_union(Curves, Ss1, Ss),
    findall(seat(S0,Item,Place),
            ( member(S0, Ss),
              get_assoc(S0, Operands, _),
              findall(P0, member(S0-P0, Sources), Ps),
              once(( known_place(Known, Item, S0, Place)
                   ; place(Item, S, Reach, S0, Ps, Place) )) ),
            Seats).

%   item(S, Item) is nondet.

item(S, v(V)) :-
    v(S, V, _, _, _).
item(S, e(A,B)) :-
    nonvar(A),
    nonvar(B),
    !,
    once(( e(S, _, A, B, _) ; e(S, _, B, A, _) )).
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

%   known_place(Known, Item, S0, Place) is semidet: Item is exactly a vertex or
%   an edge of S0.

known_place(known(Corners), v(V), S0, vertex(V0)) :-
    corner(Corners, V, S0, V0).
known_place(known(Corners), e(A,B), S0, edge(A0,B0)) :-
    corner(Corners, A, S0, V0),
    corner(Corners, B, S0, W0),
    once(( e(S0, _, V0, W0, 1) ; e(S0, _, W0, V0, 1) )),
    A0 is min(V0, W0),
    B0 is max(V0, W0).

corner(Corners, V, S0, V0) :-
    get_assoc(V, Corners, Ends),
    memberchk(S0-V0, Ends).

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
