:- module(sg_glue_choice,
          [ may_glue/3,                 % +Kind, +Seat1, +Seat2
            choice_made/1,              % +S
            stays_glued/4,              % +S, +Kind, +Seat1, +Seat2
            dissolved_pairs/2,          % +S, -Pairs
            glue_wish/1,                % @Wish
            stays_parted/1              % +S
          ]).
:- use_module('../decision', [decision/2, decision_is_default/1]).
:- use_module(region_name, [is_region_name/1, region_named/3]).
:- use_module('../store',
              [ e/5, edge_polygon/3, segment/3, origin/3, from_p/5, lies_in/3,
                gluing/2 ]).
:- use_module(library(apply), [maplist/2]).
/** <module> What of a glue is to be glued (NG-2 to NG-5).

    gluing(S, Wish)           a fact of a model: what is wanted of the glue S

    only(What)                vertices, edges or faces: nothing else is glued,
                              but what these have
    apart(S1, S2)             these operands are not glued to each other
    apart(S0-Item)            Item of operand S0 is glued to nothing: v(V),
                              e(A,B) or p(P)
    glued(S1-Item1, S2-Item2) these are glued, whatever else is said
    dissolve(R1, R2)          the faces between these regions go; by number, or
                              better by lasting name (region_name.pl)
    tolerance(T)              what is nearer than T touches (glue_tolerance/3)

Contacts are as of glue_contact.pl. Where one is not glued the operands are cut
all the same, and stay apart. */

%!  may_glue(+Kind, +Seat1, +Seat2) is semidet.
%
%   True when what the operands of Seat1 and Seat2, as of contact/4, have in
%   common is to be glued. What goes through each other is, in any case.

:- decision(may_glue/3, "Which contacts of operands are glued (NG-2 to NG-5)").

may_glue(_, _, _).

%!  choice_made(+S) is semidet.
%
%   Of the glue S it is not so that all is glued.

choice_made(S) :-
    (   gluing(S, Wish),
        Wish \= tolerance(_)
    ->  true
    ;   \+ decision_is_default(may_glue/3)
    ).

%!  stays_parted(+S) is semidet.
%
%   Things of segment S lie in one place and are to stay apart.

stays_parted(S) :-
    (   origin(S, p(_), slit(_))
    ->  true
    ;   segment(S, cells, _),
        choice_made(S)
    ).

%!  stays_glued(+S, +Kind, +Seat1, +Seat2) is semidet.
%
%   This contact of the glue S is to be glued, by what is wished and decided.

stays_glued(S, Kind, Seat1, Seat2) :-
    (   gluing(S, glued(Place1, Place2)),
        joins(Place1, Place2, Seat1, Seat2)
    ->  true
    ;   once(may_glue(Kind, Seat1, Seat2)),
        \+ ( gluing(S, Wish), keeps_apart(Wish, S, Seat1, Seat2) )
    ).

joins(Place1, Place2, Seat1, Seat2) :-
    (   has_place(Seat1, Place1),
        has_place(Seat2, Place2)
    ;   has_place(Seat1, Place2),
        has_place(Seat2, Place1)
    ),
    !.

has_place(seat(S0,_,Place), S0-Item) :-
    place_item(Place, Item0),
    same_item(Item, Item0).

place_item(vertex(V), v(V)).
place_item(edge(A,B), e(A,B)).
place_item(face(P,_), p(P)).

same_item(e(A,B), Item) :-
    !,
    A1 is min(A, B),
    B1 is max(A, B),
    Item = e(A1,B1).
same_item(Item, Item).

%   keeps_apart(Wish, S, Seat1, Seat2): of a polygon also what is at the border
%   that the operands have in common with it.

keeps_apart(only(What), _, seat(_,Item,_), _) :-
    item_kind(Item, Kind),
    Kind \== What.
keeps_apart(apart(S1, S2), _, seat(A,_,_), seat(B,_,_)) :-
    ( S1-S2 == A-B ; S2-S1 == A-B ),
    !.
keeps_apart(apart(S0-Item0), S, Seat1, Seat2) :-
    (   Seat = Seat1,
        arg(1, Seat2, Other)
    ;   Seat = Seat2,
        arg(1, Seat1, Other)
    ),
    Seat = seat(S0,Item,_),
    (   has_place(Seat, S0-Item0)
    ;   Item0 = p(P0),
        from_p(S, P, S0, P0, _),
        from_p(S, P, Other, _, _),
        at_polygon(Item, S, P)
    ),
    !.

at_polygon(v(V), S, P) :-
    (   e(S, E, V, _, _),
        edge_polygon(S, E, P)
    ;   lies_in(S, v(V), p(P))
    ).
at_polygon(e(A,B), S, P) :-
    ( e(S, E, A, B, _) ; e(S, E, B, A, _) ),
    edge_polygon(S, E, P).

item_kind(v(_), vertices).
item_kind(e(_,_), edges).
item_kind(p(_), faces).

%!  dissolved_pairs(+S, -Pairs:list) is det.
%
%   Pairs are R1-R2: the faces between these regions of the glue S are to go.

dissolved_pairs(S, Pairs) :-
    findall(R1-R2,
            ( gluing(S, dissolve(Name1, Name2)),
              region_named(S, Name1, R1),
              region_named(S, Name2, R2) ),
            Pairs).

%!  glue_wish(@Wish) is semidet.
%
%   Wish is a wish, of numbers and items as above.

glue_wish(only(What)) :-
    memberchk(What, [vertices,edges,faces]).
glue_wish(apart(S1, S2)) :-
    maplist(integer, [S1,S2]).
glue_wish(apart(Place)) :-
    is_place(Place).
glue_wish(glued(Place1, Place2)) :-
    maplist(is_place, [Place1,Place2]).
glue_wish(dissolve(R1, R2)) :-
    maplist(is_region_name, [R1,R2]).
glue_wish(tolerance(_)).                % looked at before: glue_tolerance/3

is_place(S-Item) :-
    integer(S),
    compound(Item),
    Item =.. [Name|Ids],
    memberchk(Name-Ids, [v-[_],e-[_,_],p-[_]]),
    maplist(integer, Ids).
