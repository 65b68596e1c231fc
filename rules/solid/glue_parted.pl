:- module(sg_glue_parted,
          [ choice_parted/1,            % +S
            twins_turned/1,             % +S
            choice_dissolved/2          % +S, -Insides
          ]).
:- use_module('../csg/csg', [glue_operands/2]).
:- use_module('../disjoint_sets', [set_root/3, sets_joined/4]).
:- use_module(glue_contact,
              [contact_context/2, item_seats/3, seats_contact/4]).
:- use_module(glue_divide, [is_edge/3]).
:- use_module('../gluing/cells_edit', [polygon_gone/2, regions_again/2]).
:- use_module('../gluing/cycle', [radial_cycle/4]).
:- use_module('../gluing/glue_choice',
              [dissolved_pairs/2, glue_wish/1, stays_glued/4]).
:- use_module('../gluing/region_name', [is_region_name/1, region_named/3]).
:- use_module('../gluing/regions', [region_neighbour/4]).
:- use_module('../gluing/triangle_corners', [rational_place/3]).
:- use_module('../gluing/unglue',
              [twin_there/3, vertex_parted/4]).
:- use_module('../store',
              [ v/5, e/5, p/3, t/6, segment/3, edge_polygon/3, from_p/5,
                from_r/4, from_v/4, origin/3, region/3, sides/4, lies_in/3,
                gluing/2, assert_fact/1, retractall_facts/1, fresh_id/3 ]).
:- use_module('../vector', [cross_product/3, difference/3, dot_product/3]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3]).
:- use_module(library(assoc), [empty_assoc/1, get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists),
              [append/2, append/3, member/2, permutation/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> What may not be glued, parted again in a glue (NG-2 to NG-6).

All operands are glued first, which cuts them. Then the contacts that are not to
be glued are undone: a polygon becomes one for each set of operands that are
glued to each other in it, with slits between; and a vertex one for each set of
operands that are glued to each other in what is at it. So what is glued is
glued with its borders, and an edge is parted where one of its ends is. Operands
that go through each other at an edge are glued there in any case. */

%!  choice_parted(+S) is det.
%
%   Part what of the glue S, whose regions are known, is not to be glued. Its
%   regions are to be found again then.
%
%   @error geometry_error(part_glue(wish(S, Wish))): S has no such things

choice_parted(S) :-
    forall(gluing(S, Wish), wish_checked(S, Wish)),
    contact_context(S, Context),
    findall(Item-Seats, item_seats(Context, Item, Seats), Items),
    findall(contact(Item,Seat1,Seat2,Glued),
            item_contact(S, Items, Item, Seat1, Seat2, Glued),
            Contacts),
    (   memberchk(contact(_,_,_,false), Contacts)
    ->  findall(Item-(S1-S2),
                ( member(contact(Item,Seat1,Seat2,Glued), Contacts),
                  once(( Glued == true ; pass_through(S, Seat1, Seat2) )),
                  arg(1, Seat1, S1),
                  arg(1, Seat2, S2) ),
                Links0),
        sort(Links0, Links),
        items_parted(S, Items, Links)
    ;   true
    ).

item_contact(S, Items, Item, Seat1, Seat2, Glued) :-
    member(Item-Seats, Items),
    seats_contact(Seats, Kind, Seat1, Seat2),
    (   stays_glued(S, Kind, Seat1, Seat2)
    ->  Glued = true
    ;   Glued = false
    ).

%   pass_through(S, Seat1, Seat2): round an edge one meets faces of both by
%   turns, in whatever order those are that both have; or at a vertex a wire
%   goes from one region to another, or from one side of a face to the other.

pass_through(S, seat(S1,e(A,B),_), seat(S2,_,_)) :-
    radial_cycle(S, A, B, Pages),
    findall(Owners,
            ( member(page(P,_,_), Pages), owners(S, P, S1, S2, Owners) ),
            Lists),
    \+ by_turns_once(Lists).
pass_through(S, seat(S1,v(V),_), seat(S2,_,_)) :-
    once(( member(Curve, [S1,S2]), segment(Curve, curve, _) )),
    wire_at(S, V, E1, W1),
    wire_at(S, V, E2, W2),
    E1 \== E2,
    (   lies_in(S, e(E1), r(R1)),
        lies_in(S, e(E2), r(R2)),
        R1 \== R2
    ;   lies_in(S, v(V), p(P)),
        side_of(S, P, V, W1, Side1),
        side_of(S, P, V, W2, Side2),
        Side1*Side2 < 0
    ),
    !.

%   owners(S, P, S1, S2, Owners): those of S1 and S2 that polygon P comes from.

owners(S, P, S1, S2, Owners) :-
    findall(S0, ( member(S0, [S1,S2]), once(from_p(S, P, S0, _, _)) ), Owners),
    Owners \== [].

%   by_turns_once(Lists): one owner after the other, all round, can be changed
%   twice at most.

by_turns_once(Lists) :-
    maplist(permutation, Lists, Orders),
    append(Orders, Owners),
    (   Owners = [First|_]
    ->  append(Owners, [First], Round),
        findall(x, ( append(_, [X,Y|_], Round), X \== Y ), Changes),
        \+ Changes = [_,_,_|_]
    ;   true
    ),
    !.

wire_at(S, V, E, W) :-
    ( e(S, E, V, W, _) ; e(S, E, W, V, _) ),
    \+ edge_polygon(S, E, _).

%   side_of(S, P, V, W, Side): the sign is that of the side of polygon P, which
%   V is in, where W is.

side_of(S, P, V, W, Side) :-
    once(t(S, P, _, A, B, C)),
    maplist(rational_place(S), [A,B,C,V,W], [PA,PB,PC,PV,PW]),
    difference(PB, PA, U1),
    difference(PC, PA, U2),
    cross_product(U1, U2, N),
    difference(PW, PV, Way),
    dot_product(N, Way, Side).

items_parted(S, Items, Links) :-
    findall(V-Pair,
            ( member(Item-Pair, Links), item_vertex(S, Item, V) ),
            Near0),
    sort(Near0, Near),
    groups_assoc(Near, Joined),
    groups_assoc(Links, Linked),
    findall(wire(S0,A,B),
            ( member(e(A,B)-Seats, Items), member(seat(S0,_,_), Seats),
              segment(S0, curve, _) ),
            Wires),
    forall(member(p(P)-Seats, Items), polygon_parted(S, P, Seats, Linked)),
    findall(Image,
            ( member(v(V)-Seats, Items),
              vertex_image(S, V, Seats, Joined, Image) ),
            Images0),
    list_to_assoc(Images0, Images),
    wires_again(S, Wires, Images).

groups_assoc(Pairs, Assoc) :-
    group_pairs_by_key(Pairs, Groups),
    list_to_assoc(Groups, Assoc).

item_vertex(_, v(V), V).
item_vertex(_, e(A,B), V) :-
    ( V = A ; V = B ).
item_vertex(S, p(P), V) :-
    polygon_vertex(S, P, V).

polygon_vertex(S, P, V) :-
    p(S, P, Es),
    member(E, Es),
    e(S, E, V, _, _).
polygon_vertex(S, P, V) :-
    lies_in(S, v(V), p(P)).

%   classes(Key, Seats, Linked, Classes): lists of seats, whose operands are
%   linked at Key.

classes(Key, Seats, Linked, Classes) :-
    (   get_assoc(Key, Linked, Pairs)
    ->  true
    ;   Pairs = []
    ),
    empty_assoc(Sets0),
    foldl(linked, Pairs, Sets0, Sets),
    findall(Root-Seat,
            ( member(Seat, Seats), arg(1, Seat, S0), set_root(Sets, S0, Root) ),
            Rooted0),
    keysort(Rooted0, Rooted),
    group_pairs_by_key(Rooted, Groups),
    findall(Class, member(_-Class, Groups), Classes0),
    sort(Classes0, Classes).

linked(S1-S2, Sets0, Sets) :-
    sets_joined(S1, S2, Sets0, Sets).

in_class(S0, Class) :-
    memberchk(seat(S0,_,_), Class).

%   polygon_parted(S, P, Seats, Linked): P stays that of the first class, and
%   each other one gets a twin.

polygon_parted(S, P, Seats, Linked) :-
    classes(p(P), Seats, Linked, [First|Others]),
    findall(Q-Class, ( member(Class, Others), twin_there(S, P, Q) ), Twins),
    forall(member(Q-Class, [P-First|Twins]),
           forall(( from_p(S, Q, S0, P0, Sense), \+ in_class(S0, Class) ),
                  retractall_facts(from_p(S, Q, S0, P0, Sense)))).

%   vertex_image(S, V, Seats, Joined, Image) is nondet: parts V; each Image is
%   (V-S0)-W: W is where operand S0 had V.

vertex_image(S, V, Seats, Joined, (V-S0)-W) :-
    classes(V, Seats, Joined, [First|Others]),
    Others \== [],
    findall(W1-Class,
            ( member(Class, Others), class_parted(S, V, Class, W1) ),
            Parted),
    forall(member(W1-Class, [V-First|Parted]), vertex_named(S, W1, Class)),
    member(W-Class, Parted),
    member(seat(S0,_,_), Class).

class_parted(S, V, Class, W) :-
    findall(P,
            ( ( e(S, E, V, _, _), edge_polygon(S, E, P)
              ; lies_in(S, v(V), p(P)) ),
              from_p(S, P, S0, _, _),
              in_class(S0, Class) ),
            Ps0),
    sort(Ps0, Ps),
    vertex_parted(S, V, Ps, W),
    forall(( member(P, Ps), lies_in(S, v(V), p(P)) ),
           ( retractall_facts(lies_in(S, v(V), p(P))),
             assert_fact(lies_in(S, v(W), p(P))) )).

vertex_named(S, V, Class) :-
    retractall_facts(from_v(S, V, _, _)),
    (   member(seat(S0,_,vertex(V0)), Class)
    ->  assert_fact(from_v(S, V, S0, V0))
    ;   true
    ).

%   wires_again(S, Wires, Images): the wires of each curve between the vertices
%   that it has now.

wires_again(S, Wires, Images) :-
    forall(( member(wire(_,A,B), Wires),
             ( e(S, E, A, B, _) ; e(S, E, B, A, _) ),
             \+ edge_polygon(S, E, _) ),
           retractall_facts(e(S, E, _, _, _))),
    forall(member(wire(S0,A0,B0), Wires),
           ( image(Images, S0, A0, A),
             image(Images, S0, B0, B),
             wire_there(S, A, B) )).

image(Images, S0, V, W) :-
    (   get_assoc(V-S0, Images, W0)
    ->  W = W0
    ;   W = V
    ).

wire_there(S, A, B) :-
    (   is_edge(S, A, B)
    ->  true
    ;   fresh_id(e, S, E),
        assert_fact(e(S, E, A, B, 1))
    ).

geometry_error(What) :-
    throw(error(geometry_error(What), _)).

%!  twins_turned(+S) is det.
%
%   Of polygons of S that lie on each other, with a slit between, the one at the
%   inside of a solid comes from that solid. Whose border they share, their
%   regions do not tell one from the other.

twins_turned(S) :-
    forall(( origin(S, p(Q), slit(P)),
             findall(S0, ( member(Of, [P,Q]), looks_into_slit(S, Of, S0) ),
                     [_|_]) ),
           sources_exchanged(S, P, Q)).

looks_into_slit(S, P, S0) :-
    sides(S, P, Below, Above),
    from_p(S, P, S0, _, Sense),
    segment(S0, solid, _),
    (   Sense =:= 1
    ->  region(S, Below, slit)
    ;   region(S, Above, slit)
    ).

sources_exchanged(S, P, Q) :-
    findall(from(S0,P0,Sense), from_p(S, P, S0, P0, Sense), OfP),
    findall(from(S0,P0,Sense), from_p(S, Q, S0, P0, Sense), OfQ),
    forall(member(Of-Froms, [P-OfQ,Q-OfP]),
           ( retractall_facts(from_p(S, Of, _, _, _)),
             forall(member(from(S0,P0,Sense), Froms),
                    assert_fact(from_p(S, Of, S0, P0, Sense))) )).

                /*******************************
                *            WISHES            *
                *******************************/

wish_checked(S, Wish) :-
    (   glue_wish(Wish),
        forall(wish_names(Wish, Name), is_named(Name, S))
    ->  true
    ;   geometry_error(part_glue(wish(S, Wish)))
    ).

%   wish_names(Wish, Name) is nondet: Name is operand(S0), S0-Item or two names
%   of regions.

wish_names(apart(S1, S2), operand(S0)) :-
    ( S0 = S1 ; S0 = S2 ).
wish_names(apart(Place), Place).
wish_names(glued(Place1, Place2), Place) :-
    ( Place = Place1 ; Place = Place2 ).
wish_names(dissolve(R1, R2), R1-R2).

is_named(operand(S0), S) :-
    glue_operands(S, Operands),
    memberchk(S0, Operands).
is_named(S0-Item, S) :-
    compound(Item),
    \+ is_region_name(Item),
    is_named(operand(S0), S),
    operand_item(Item, S0),
    !.
is_named(Name1-Name2, S) :-
    is_region_name(Name2),
    region_named(S, Name1, R1),
    region_named(S, Name2, R2),
    once(region_neighbour(S, R1, R2, _)),
    \+ ( member(R, [R1,R2]), region(S, R, outside) ).

operand_item(v(V), S0) :-
    v(S0, V, _, _, _).
operand_item(e(A,B), S0) :-
    is_edge(S0, A, B).
operand_item(p(P), S0) :-
    p(S0, P, _).

%!  choice_dissolved(+S, -Insides:list) is semidet.
%
%   The faces between regions of the glue S that are to be one go, and what had
%   no other face. Insides are R-Operands of its regions, which were found
%   again. Fails if there is nothing to dissolve.

choice_dissolved(S, Insides) :-
    dissolved_pairs(S, Pairs),
    Pairs \== [],
    findall(P, ( member(R1-R2, Pairs), region_neighbour(S, R1, R2, P) ), Ps0),
    sort(Ps0, Ps),
    findall(V, ( member(P, Ps), polygon_vertex(S, P, V) ), Vs0),
    sort(Vs0, Vs),
    findall((P-Side)-Inside,
            ( side(S, P, Side, R), findall(S0, from_r(S, R, S0, _), Inside) ),
            Known0),
    list_to_assoc(Known0, Known),
    maplist(polygon_gone(S), Ps),
    forall(( member(V, Vs), is_bare(S, V) ), vertex_gone(S, V)),
    regions_again(S, _),
    findall(R-Inside, region_insides(S, Known, R, Inside), Insides).

side(S, P, below, R) :-
    sides(S, P, R, _).
side(S, P, above, R) :-
    sides(S, P, _, R).

is_bare(S, V) :-
    \+ e(S, _, V, _, _),
    \+ e(S, _, _, V, _),
    \+ lies_in(S, v(V), p(_)).

vertex_gone(S, V) :-
    retractall_facts(from_v(S, V, _, _)),
    retractall_facts(origin(S, v(V), _)),
    retractall_facts(lies_in(S, v(V), _)),
    retractall_facts(v(S, V, _, _, _)).

region_insides(S, Known, R, Inside) :-
    region(S, R, _),
    findall(S0,
            ( side(S, P, Side, R), get_assoc(P-Side, Known, Ss),
              member(S0, Ss) ),
            Inside0),
    sort(Inside0, Inside).
