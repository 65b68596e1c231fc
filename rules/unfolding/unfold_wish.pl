:- module(sg_unfold_wish,
          [ wanted/3,                   % +S, +Wishes, -Wanted
            wanted_in/4,                % +T, +S, +Wanted, -Options
            wish_form/2,                % ?Name, -Form
            all_forms/1                 % -Forms
          ]).
:- use_module('../development/development', [develop/3]).
:- use_module('../development/part_edges', [edge_length/3]).
:- use_module('../development/polygon_name',
              [ polygons_named/3, edges_named/3, joined_by/4, known_polygons/3,
                neighbours/3, polygon_name/3
              ]).
:- use_module(unfold_how, [how_form/2, how_given/3]).
:- use_module('../store',
              [ e/5, p/3, from_p/5, origin/3, joint/6, edge_polygon/3,
                facts_snapshot/1
              ]).
:- use_module(library(apply), [exclude/3, foldl/4, maplist/2, maplist/3]).
:- use_module(library(assoc), [empty_assoc/1, get_assoc/3, put_assoc/4]).
:- use_module(library(lists), [append/3, last/2, member/2, nth1/3]).
:- use_module(library(ordsets), [ord_subtract/3]).
/** <module> What a user wants of a development (DV-7).

A wish is wish(Wish, From), From `fact` (unfolding/2 of the model) or `flag`
(an option). Wish is one of

    root(Polygon)        where the laying out begins
    cut(Edge)            the two sides of Edge are not joined
    keep(Edge)           they are, before any others
    order(Polygons)      these are joined one after the other, each to one
                         before it, at their longest edge
    removed(Polygon)     is left out; removed([Polygon, ...])

or one that says how the whole is unfolded (unfold_how.pl), with polygons and
edges by number or by name (polygon_name.pl). What is wanted
is then

    wanted(Root, Cut, Keep, Removed)

Root a polygon or `none`, Cut and Keep lists of edge(E, P, Q) between polygons P
and Q, Removed polygons. The edges of an order are among those to keep.

What cannot be is said of the wish that comes last: error(Fault, _), Fault
model_error(unfold(S, Wish, What)) of a fact and usage_error(unfold(S, Wish,
What)) of an option, What one of

    unknown_wish                        form(Form), how_form(Form)
    no_polygon(Name, Ps, Names)         several(Name, Ps)
    no_edge(Name)                       border(E, P)
    apart(Name1, Name2, P, Qs)          cut_and_keep(E, P, Q)
    two_roots(P, Q)                     removed_root(P)
    removed_all                         removed_keep(E, P)
    order_removed(P)                    order_twice(P)
    order_root(Root, First)             order_apart(P, Before)
    order_cut(P, Before)                ring(E, P, Q)
    twice(Wish1)                        needs(Form)

with face(P, Name) for polygons (polygon_name/3).

@see row DV-7
*/

%!  wish_form(?Name, -Form) is nondet.
%
%   Form is an atom that says how the wish Name is written.

wish_form(root, 'root(Polygon)').
wish_form(cut, 'cut(Edge)').
wish_form(keep, 'keep(Edge)').
wish_form(order, 'order([Polygon, ...])').
wish_form(removed, 'removed(Polygon) or removed([Polygon, ...])').

%!  all_forms(-Forms:list) is det.
%
%   Forms say how every wish is written.

all_forms(Forms) :-
    findall(Form, ( wish_form(_, Form) ; how_form(_, Form) ), Forms).

%!  wanted(+S, +Wishes:list, -Wanted) is det.
%
%   Wanted is what the Wishes say of segment S together.
%
%   @error model_error(unfold(S, Wish, What)), usage_error(unfold(S, Wish,
%          What)): see above

wanted(S, Wishes, wanted(Root, Cut, Keep, Removed)) :-
    maplist(known_wish(S), Wishes),
    how_once(S, Wishes),
    removed_polygons(S, Wishes, Removed),
    root_polygon(S, Wishes, Removed, Root0),
    wished_edges(S, Wishes, cut, Cut0),
    exclude(edge_removed(Removed), Cut0, Cut),
    wished_edges(S, Wishes, keep, Keep0),
    kept_not_cut(S, Wishes, Cut, Removed),
    kept_sets(S, Wishes, Sets0),
    orders(S, Wishes, Cut, Removed, Root0, Root, Sets0, Keep1),
    append(Keep0, Keep1, Keep).

%   An edge of a polygon that is removed is a border: it is cut.

edge_removed(Removed, edge(_, P, Q)) :-
    (   memberchk(P, Removed)
    ->  true
    ;   memberchk(Q, Removed)
    ).

wish_fault(From, S, Wish, What0) :-
    called(S, What0, What),
    (   From == fact
    ->  throw(error(model_error(unfold(S, Wish, What)), _))
    ;   throw(error(usage_error(unfold(S, Wish, What)), _))
    ).

%   called(S, What0, What): with what the polygons are called, as face(P, Name).

called(S, What0, What) :-
    What0 =.. [Name|Arguments0],
    (   polygon_places(Name, Places)
    ->  findall(Argument,
                ( nth1(I, Arguments0, Argument0),
                  (   memberchk(I, Places)
                  ->  called_polygons(S, Argument0, Argument)
                  ;   Argument = Argument0
                  ) ),
                Arguments),
        What =.. [Name|Arguments]
    ;   What = What0
    ).

polygon_places(several, [2]).
polygon_places(apart, [3,4]).
polygon_places(border, [2]).
polygon_places(cut_and_keep, [2,3]).
polygon_places(two_roots, [1,2]).
polygon_places(removed_root, [1]).
polygon_places(removed_keep, [2]).
polygon_places(order_removed, [1]).
polygon_places(order_twice, [1]).
polygon_places(order_root, [1,2]).
polygon_places(order_apart, [1,2]).
polygon_places(order_cut, [1,2]).
polygon_places(ring, [2,3]).

called_polygons(S, Ps, Faces) :-
    is_list(Ps),
    !,
    maplist(called_polygons(S), Ps, Faces).
called_polygons(S, P, face(P, Name)) :-
    polygon_name(S, P, Name).

known_wish(S, wish(Wish, From)) :-
    (   callable(Wish),
        functor(Wish, How, _),
        how_form(How, HowForm)
    ->  (   how_given(How, Wish, _)
        ->  true
        ;   wish_fault(From, S, Wish, how_form(HowForm))
        )
    ;   compound(Wish),
        Wish =.. [Name, Value]
    ->  (   wish_form(Name, Form)
        ->  (   well_formed(Name, Value)
            ->  true
            ;   wish_fault(From, S, Wish, form(Form))
            )
        ;   wish_fault(From, S, Wish, unknown_wish)
        )
    ;   wish_fault(From, S, Wish, unknown_wish)
    ).

%   how_once(S, Wishes): how it is unfolded is not said in two ways.

how_once(S, Wishes) :-
    forall(( append(Before, [wish(Wish, fact)|_], Wishes),
             functor(Wish, How, N),
             how_form(How, _),
             functor(Other, How, N),
             member(wish(Other, fact), Before),
             Other \== Wish ),
           wish_fault(fact, S, Wish, twice(Other))).

well_formed(order, Names) :-
    !,
    is_list(Names),
    Names = [_|_],
    maplist(polygon_word, Names).
well_formed(removed, Names) :-
    is_list(Names),
    !,
    Names = [_|_],
    maplist(polygon_word, Names).
well_formed(Name, Edge) :-
    memberchk(Name, [cut,keep]),
    !,
    (   integer(Edge)
    ->  true
    ;   Edge = A-B,
        ground(Edge),
        (   A = v(_)
        ->  B = v(_)
        ;   polygon_word(A),
            polygon_word(B)
        )
    ).
well_formed(_, Name) :-
    polygon_word(Name).

polygon_word(Name) :-
    (   integer(Name)
    ->  true
    ;   callable(Name),
        ground(Name),
        \+ is_list(Name),
        Name \= _-_,
        Name \= v(_)
    ).


                /*******************************
                *           POLYGONS           *
                *******************************/

%   some_polygons(From, S, Wish, Name, Ps): at least one.

some_polygons(From, S, Wish, Name, Ps) :-
    polygons_named(S, Name, Ps),
    (   Ps == []
    ->  known_polygons(S, All, Names),
        wish_fault(From, S, Wish, no_polygon(Name, All, Names))
    ;   true
    ).

one_polygon(From, S, Wish, Name, P) :-
    some_polygons(From, S, Wish, Name, Ps),
    (   Ps = [P]
    ->  true
    ;   wish_fault(From, S, Wish, several(Name, Ps))
    ).

removed_polygons(S, Wishes, Removed) :-
    findall(P, ( member(Wish, Wishes), removed_by(S, Wish, P) ), Removed0),
    sort(Removed0, Removed),
    (   Removed == []
    ->  true
    ;   findall(P, p(S, P, _), Ps0),
        sort(Ps0, Ps),
        ord_subtract(Ps, Removed, []),
        member(wish(removed(Last), From), Wishes)
    ->  wish_fault(From, S, removed(Last), removed_all)
    ;   true
    ).

removed_by(S, wish(removed(Names0), From), P) :-
    (   is_list(Names0)
    ->  Names = Names0
    ;   Names = [Names0]
    ),
    member(Name, Names),
    some_polygons(From, S, removed(Names0), Name, Ps),
    member(P, Ps).

root_polygon(S, Wishes, Removed, Root) :-
    findall(P-wish(root(Name), From),
            ( member(wish(root(Name), From), Wishes),
              one_polygon(From, S, root(Name), Name, P) ),
            Roots),
    (   Roots = [P-_|More]
    ->  forall(( member(Q-wish(Wish, From), More), Q \== P ),
               wish_fault(From, S, Wish, two_roots(P, Q))),
        last(Roots, _-wish(Last, LastFrom)),
        (   memberchk(P, Removed)
        ->  wish_fault(LastFrom, S, Last, removed_root(P))
        ;   Root = P
        )
    ;   Root = none
    ).


                /*******************************
                *             EDGES            *
                *******************************/

%   wished_edges(S, Wishes, Name, Edges): all that are to be cut, or kept, each
%   once, in the order of the wishes.

wished_edges(S, Wishes, Name, Edges) :-
    findall(Edge,
            ( member(wish(Wish, From), Wishes),
              Wish =.. [Name, Value],
              wished_edge(From, S, Wish, Value, Edge) ),
            Edges0),
    once_each(Edges0, [], Edges).

once_each([], _, []).
once_each([Edge|Edges0], Seen, Edges) :-
    (   memberchk(Edge, Seen)
    ->  Edges = Edges1
    ;   Edges = [Edge|Edges1]
    ),
    once_each(Edges0, [Edge|Seen], Edges1).

wished_edge(From, S, Wish, Value, Edge) :-
    named_edges(From, S, Wish, Value, Es),
    member(E, Es),
    edge_sides(S, E, Sides),
    (   Sides = [P,Q]
    ->  Edge = edge(E, P, Q)
    ;   Sides = [P|_]
    ->  wish_fault(From, S, Wish, border(E, P))
    ;   wish_fault(From, S, Wish, no_edge(Value))
    ).

named_edges(From, S, Wish, Value, Es) :-
    (   Value = A-B,
        A \= v(_)
    ->  some_polygons(From, S, Wish, A, Ps),
        some_polygons(From, S, Wish, B, _),
        edges_named(S, Value, Es),
        (   Es == []
        ->  Ps = [P|_],
            neighbours(S, P, Qs),
            wish_fault(From, S, Wish, apart(A, B, P, Qs))
        ;   true
        )
    ;   edges_named(S, Value, Es),
        Es = [_|_]
    ->  true
    ;   wish_fault(From, S, Wish, no_edge(Value))
    ).

%   edge_sides(S, E, Ps): the polygons of E and its partner, or of E alone.

edge_sides(S, E, Ps) :-
    once(e(S, E, A, B, _)),
    findall(P, edge_polygon(S, E, P), Ps1),
    findall(Q, ( e(S, F, B, A, _), edge_polygon(S, F, Q) ), Ps2),
    append(Ps1, Ps2, Ps0),
    (   Ps0 = [P,Q|_]
    ->  Ps = [P,Q]
    ;   Ps = Ps0
    ).

kept_not_cut(S, Wishes, Cut, Removed) :-
    forall(( member(wish(keep(Value), From), Wishes),
             wished_edge(From, S, keep(Value), Value, edge(E, P, Q)) ),
           (   memberchk(edge(E, _, _), Cut)
           ->  last_of_two(S, Wishes, E, From, keep(Value), Wish, Blamed),
               wish_fault(Blamed, S, Wish, cut_and_keep(E, P, Q))
           ;   member(Gone, [P,Q]),
               memberchk(Gone, Removed)
           ->  wish_fault(From, S, keep(Value), removed_keep(E, Gone))
           ;   true
           )).

%   last_of_two(S, Wishes, E, From0, Keep, Wish, From): the option, if it
%   contradicts a fact.

last_of_two(S, Wishes, E, fact, _, cut(Value), flag) :-
    member(wish(cut(Value), flag), Wishes),
    wished_edge(flag, S, cut(Value), Value, edge(E, _, _)),
    !.
last_of_two(_, _, _, From, Keep, Keep, From).


                /*******************************
                *             ORDER            *
                *******************************/

%   kept_sets(S, Wishes, Sets): Sets say which polygons are connected by edges
%   that are kept. They cannot go round, unless that lies flat.

kept_sets(S, Wishes, Sets) :-
    empty_assoc(None),
    findall(kept(Edge, keep(Value), From),
            ( member(wish(keep(Value), From), Wishes),
              wished_edge(From, S, keep(Value), Value, Edge) ),
            Kept),
    kept_joined(Kept, S, [], None, Sets).

kept_joined([], _, _, Sets, Sets).
kept_joined([kept(edge(E, P, Q), Wish, From)|Kept], S, Seen, Sets0, Sets) :-
    (   memberchk(E, Seen)
    ->  Sets1 = Sets0
    ;   \+ together(P, Q, Sets0)
    ->  joined(P, Q, Sets0, Sets1)
    ;   lies_closed(S, E, Seen)
    ->  Sets1 = Sets0
    ;   wish_fault(From, S, Wish, ring(E, P, Q))
    ),
    kept_joined(Kept, S, [E|Seen], Sets1, Sets).

%   lies_closed(S, E, Kept): with the edges Kept joined the sides of E lie on
%   each other, as all round a flat vertex. So a ring may be kept.

lies_closed(S, E, Kept) :-
    facts_snapshot(( develop(S, [keep(Kept),effort(0)], D),
                     once(( joint(D, _, E, _, fold, _)
                          ; joint(D, _, _, E, fold, _) )) )).

together(P, Q, Sets) :-
    first_of(P, Sets, First),
    first_of(Q, Sets, First).

first_of(P, Sets, First) :-
    (   get_assoc(P, Sets, P1)
    ->  first_of(P1, Sets, First)
    ;   First = P
    ).

joined(P, Q, Sets0, Sets) :-
    first_of(P, Sets0, P1),
    first_of(Q, Sets0, Q1),
    put_assoc(Q1, Sets0, P1, Sets).

%   orders(S, Wishes, Cut, Removed, Root0, Root, Sets, Keep)

orders(S, Wishes, Cut, Removed, Root0, Root, Sets, Keep) :-
    findall(order(Names, From), member(wish(order(Names), From), Wishes),
            Orders),
    foldl(one_order(S, Cut, Removed), Orders, so_far(Root0, Sets, []),
          so_far(Root, _, Keep)).

one_order(S, Cut, Removed, order(Names, From), so_far(Root0, Sets0, Keep0),
          so_far(Root, Sets, Keep)) :-
    Wish = order(Names),
    findall(P, ( member(Name, Names),
                 some_polygons(From, S, Wish, Name, Ps1),
                 member(P, Ps1) ),
            Ps),
    Ps = [First|Rest],
    forall(( member(P, Ps), memberchk(P, Removed) ),
           wish_fault(From, S, Wish, order_removed(P))),
    (   append(Before, [P|_], Ps),
        memberchk(P, Before)
    ->  wish_fault(From, S, Wish, order_twice(P))
    ;   Root0 == none
    ->  Root = First
    ;   memberchk(Root0, Rest)
    ->  wish_fault(From, S, Wish, order_root(Root0, First))
    ;   Root = Root0
    ),
    in_order(Rest, [First], order(S, Wish, From, Cut), Sets0, Sets, Edges),
    append(Keep0, Edges, Keep).

in_order([], _, _, Sets, Sets, []).
in_order([P|Ps], Before, Order, Sets0, Sets, Edges) :-
    (   member(B, Before),
        together(P, B, Sets0)
    ->  Sets1 = Sets0,
        Edges = Edges1
    ;   longest_edge(Order, P, Before, edge(E, P, Q)),
        joined(Q, P, Sets0, Sets1),
        Edges = [edge(E, P, Q)|Edges1]
    ),
    in_order(Ps, [P|Before], Order, Sets1, Sets, Edges1).

%   longest_edge(Order, P, Before, Edge): by which P is joined to one before it,
%   of equal ones the one with the smallest number.

longest_edge(order(S, Wish, From, Cut), P, Before, edge(E, P, Q)) :-
    findall(Less-E1-Q1,
            ( joined_by(S, P, Q1, E1),
              memberchk(Q1, Before),
              edge_length(S, E1, Length),
              Less is -Length ),
            All0),
    sort(All0, All),
    (   member(_-E-Q, All),
        \+ memberchk(edge(E, _, _), Cut)
    ->  true
    ;   All == []
    ->  wish_fault(From, S, Wish, order_apart(P, Before))
    ;   wish_fault(From, S, Wish, order_cut(P, Before))
    ).


                /*******************************
                *      AS IT HAS BECOME        *
                *******************************/

%!  wanted_in(+T, +S, +Wanted, -Options:list) is det.
%
%   Options of develop/3 are what is Wanted of segment S, said of T: S itself,
%   perhaps with penetration lines by now, or what was trimmed of it. What is
%   there no more is not wanted.

wanted_in(T, S, wanted(Root, Cut0, Keep0, Removed0), Options) :-
    (   Root \== none,
        polygon_in(T, S, Root, P)
    ->  Options = [root(P)|Options1]
    ;   Options = Options1
    ),
    findall(Q, ( member(Q0, Removed0), polygon_in(T, S, Q0, Q) ), Removed),
    edges_in(T, S, Cut0, Cut),
    edges_in(T, S, Keep0, Keep),
    Options1 = [removed(Removed), cut(Cut), keep(Keep)].

polygon_in(S, S, P, P) :-
    !.
polygon_in(T, S, P0, P) :-
    findall(P1, from_p(T, P1, S, P0, _), Ps0),
    sort(Ps0, Ps),
    member(P, Ps).

edges_in(T, S, Edges0, Es) :-
    findall(E, ( member(Edge, Edges0), edge_in(T, S, Edge, E) ), Es).

%   edge_in(T, S, Edge, E): E is Edge, or a part of it.

edge_in(S, S, edge(E0, P, Q), E) :-
    !,
    (   edge_polygon(S, E0, _)
    ->  E = E0
    ;   origin(S, e(_), e(E0))
    ->  origin(S, e(E1), e(E0)),
        edge_in(S, S, edge(E1, P, Q), E)
    ;   joined_by(S, P, Q, E)
    ).
edge_in(T, S, edge(_, P0, Q0), E) :-
    polygon_in(T, S, P0, P),
    joined_by(T, P, Q, E),
    from_p(T, Q, S, Q0, _).
