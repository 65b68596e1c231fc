:- module(sg_true_coincident,
          [ lines_settled/4             % +Facets0, -Facets, +Shape0, -Shape
          ]).
:- use_module('../near', [is_on_surface/2, same_angle/2, same_part/2]).
:- use_module(true_shape, [edge_curve/4, key_place/4]).
:- use_module(true_spike, [lies_on/5]).
:- use_module(library(apply), [convlist/3, foldl/4, maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2, put_assoc/4]).
:- use_module(library(lists), [append/2, append/3, member/2, reverse/2]).
:- use_module(library(ordsets), [ord_memberchk/2, ord_union/3]).
:- use_module(library(pairs), [group_pairs_by_key/2, pairs_values/2]).
/** <module> True lines that fall together.

Facets of two surfaces with one base circle, or of two that are one, meet in
lines beside each other, with hairs between them; the true lines are one, or go
along a rim. Then several points of them are in one place, or one lies on the
line between two others. Here they are one point, and such a line is divided
there; what is then there twice is left out, and a hair vanishes.

A line that ends in a facet, or goes through it where that is not divided, runs
in it both ways: so it still does.
*/

%!  lines_settled(+Facets0, -Facets, +Shape0, -Shape) is det.
%
%   Facets are Facets0, where no point of a line lies on another line, a rim or
%   a generator that does not end there, nor in the place of another point.
%   Those of which nothing is left are not among them.

lines_settled(Facets0, Facets, Shape0, Shape) :-
    points_merged(Facets0, Shape0, Moved, Shape),
    list_to_assoc(Moved, Table),
    findall(Edge-Key, edge_divided(Facets0, Table, Shape, Edge, Key),
            Divided0),
    (   Moved == [],
        Divided0 == []
    ->  Facets = Facets0
    ;   sort(Divided0, Divided1),
        group_pairs_by_key(Divided1, Divided2),
        list_to_assoc(Divided2, Divided),
        convlist(facet_settled(Table, Divided), Facets0, Facets)
    ).


                /*******************************
                *            POINTS            *
                *******************************/

%   points_merged(Facets, Shape0, Moved, Shape): Moved is the list of
%   Id-to(Id1, Turns): vertex Id is where Id1 is, carried round by Turns. That
%   lies on the surfaces of both in Shape.

points_merged(Facets, Shape0, Moved, Shape) :-
    findall(Pair,
            ( member(Facet, Facets),
              facet_keys(Facet, Shape0, Keys),
              maplist(keyed_node(Shape0), Keys, Placed),
              append(_, [Placed1|Rest], Placed),
              member(Placed2, Rest),
              one_place(Shape0, Placed1, Placed2, Pair) ),
            Pairs0),
    sort(Pairs0, Pairs),
    foldl(pair_merged, Pairs, []-Shape0, Moved0-Shape),
    keysort(Moved0, Moved).

%   facet_keys(Facet, Shape, Keys): its keys, if a line goes through it.

facet_keys(facet(_, _, _, Halves), Shape, Keys) :-
    findall(Key, ( member(half(A, B, _), Halves), ( Key = A ; Key = B ) ),
            Keys0),
    sort(Keys0, Keys),
    once(( member(Key, Keys), is_met(Shape, Key) )).

is_met(shape(_, _, Nodes), k(Id, _)) :-
    get_assoc(Id, Nodes, node(_, _, _, [_|_])).

%   keyed_node(Shape, Key, Key-Node): each is looked for once.

keyed_node(shape(_, _, Nodes), Key, Key-Node) :-
    Key = k(Id, _),
    get_assoc(Id, Nodes, Node).

%   one_place(Shape, Key1-Node1, Key2-Node2, Pair): Pair is Id2-to(Id1, Turns).

one_place(shape(_, Reach, _), k(Id1, Turn1)-node(T1, _, Point1, Met1),
          k(Id2, Turn2)-node(T2, _, Point2, Met2), Id2-to(Id1, Turns)) :-
    Id1 \== Id2,
    T1 \== any,
    T2 \== any,
    ( Met1 \== [] ; Met2 \== [] ),
    distance(Point1, Point2, Off),
    is_on_surface(Off, Reach),
    abs(T1 + 360.0*Turn1 - T2 - 360.0*Turn2) < 180.0,
    !,
    Turns is Turn1-Turn2.

distance(point(X1,Y1,Z1), point(X2,Y2,Z2), D) :-
    D is sqrt((X1-X2)**2 + (Y1-Y2)**2 + (Z1-Z2)**2).

%   pair_merged(Pair, Moved0-Shape0, Moved-Shape): unless one of both is away
%   from there already.

pair_merged(Id2-to(Id10, Turns0), Moved0-Shape0, Moved-Shape) :-
    (   memberchk(Id10-to(Id1, More), Moved0)
    ->  Turns is Turns0+More
    ;   Id1 = Id10,
        Turns = Turns0
    ),
    (   ( Id1 == Id2 ; memberchk(Id2-_, Moved0) )
    ->  Moved-Shape = Moved0-Shape0
    ;   Shape0 = shape(Surface, Reach, Nodes0),
        get_assoc(Id1, Nodes0, node(T, H, Point, Met1)),
        get_assoc(Id2, Nodes0, node(_, _, _, Met2)),
        sort(Met1, Set1),
        sort(Met2, Set2),
        ord_union(Set1, Set2, Met),
        put_assoc(Id1, Nodes0, node(T, H, Point, Met), Nodes),
        Shape = shape(Surface, Reach, Nodes),
        Moved = [Id2-to(Id1, Turns)|Moved0]
    ).

key_moved(Table, k(Id0, Turn0), Key) :-
    (   get_assoc(Id0, Table, to(Id, Turns))
    ->  Turn is Turn0+Turns,
        Key = k(Id, Turn)
    ;   Key = k(Id0, Turn0)
    ).


                /*******************************
                *             LINES            *
                *******************************/

%   edge_divided(Facets, Table, Shape, Edge, Part-Key) is nondet: of an Edge of
%   a facet, A-B without the turns of both, the key lies between its ends, at
%   Part of it.

edge_divided(Facets, Table, Shape, Edge, Part-Key) :-
    member(Facet0, Facets),
    facet_moved(Table, Facet0, Facet),
    facet_keys(Facet, Shape, Keys),
    maplist(keyed_node(Shape), Keys, Placed),
    Facet = facet(_, _, _, Halves),
    member(half(K1, K2, _), Halves),
    msort([K1,K2], [A,B]),
    memberchk(A-node(_, _, PA, _), Placed),
    memberchk(B-node(_, _, PB, _), Placed),
    distance(PA, PB, Whole),
    member(C-node(_, _, PC, _), Placed),
    may_divide(PA, PB, Whole, PC, Part),        % first what is cheap
    C \== A,
    C \== B,
    edge_curve(Shape, A, B, Curve),
    on_curve(Curve, Shape, A, B, C),
    edge_known(A, B, Turn, Edge),
    back(C, Turn, Key).

%   edge_known(A, B, Turn, Edge): Edge is the same however often it was carried
%   round.

edge_known(A, B, Turn, A1-B1) :-
    A = k(_, Turn0),
    B = k(_, Turn1),
    (   Turn0 == apex
    ->  Turn = Turn1
    ;   Turn = Turn0
    ),
    back(A, Turn, A1),
    back(B, Turn, B1).

back(k(Id, Turn0), By, k(Id, Turn)) :-
    (   ( Turn0 == apex ; By == apex )
    ->  Turn = Turn0
    ;   Turn is Turn0-By
    ).

%   may_divide(PA, PB, Whole, PC, Part): C is near the line between A and B,
%   Whole apart, and not beyond B.

may_divide(PA, PB, Whole, PC, Part) :-
    Most is 1.2*Whole,
    distance(PA, PC, Before),
    Before < Most,
    distance(PC, PB, After),
    Before + After < Most,
    Before*Before < Whole*Whole + After*After,
    Part is Before/(Before+After).

on_curve(straight, Shape, A, B, C) :-
    maplist(place(Shape), [A,B,C], [TA-HA,TB-HB,TC-HC]),
    generator_of(TA, TB, T),
    TC \== any,
    same_angle(T, TC),
    lies_between(HA, HB, HC).
on_curve(level(H), Shape, A, B, C) :-
    maplist(place(Shape), [A,B,C], [TA-_,TB-_,TC-HC]),
    same_part(H, HC),
    lies_between(TA, TB, TC).
on_curve(tip(H), Shape, A, B, C) :-
    on_curve(level(H), Shape, A, B, C).
on_curve(meets(Other), Shape, A, B, C) :-
    is_met(Shape, C),
    lies_on(Shape, Other, A, B, C).

place(shape(_, _, Nodes), Key, T-H) :-
    key_place(Nodes, Key, T, H).

generator_of(TA, TB, T) :-
    (   TA == any
    ->  T = TB
    ;   TB == any
    ->  T = TA
    ;   same_angle(TA, TB),
        T = TA
    ),
    T \== any.

lies_between(A, B, C) :-
    C \== any,
    C > min(A, B),
    C < max(A, B).


                /*******************************
                *            FACETS            *
                *******************************/

facet_moved(Table, facet(P, T1, T2, Halves0), facet(P, T1, T2, Halves)) :-
    findall(half(A, B, Label),
            ( member(half(A0, B0, Label), Halves0),
              key_moved(Table, A0, A),
              key_moved(Table, B0, B),
              A \== B ),
            Halves).

%   facet_settled(Table, Divided, Facet0, Facet) is semidet: fails if
%   nothing is left.

facet_settled(Table, Divided, Facet0, Facet) :-
    Facet0 = facet(P, T1, T2, Halves0),
    lines_both_ways(Halves0, Lines),
    findall(Way-Half,
            ( member(Half0, Halves0),
              half_way(Lines, Half0, Way),
              half_parts(Table, Divided, Half0, Parts),
              member(Half, Parts) ),
            Halves1),
    (   maplist(same_half, Halves1, Halves0)
    ->  Facet = Facet0
    ;   once_each(Halves1, Halves),
        member(outline-_, Halves),
        !,
        pairs_values(Halves, Halves2),
        Facet = facet(P, T1, T2, Halves2)
    ).

same_half(_-Half, Half).

%   lines_both_ways(Halves, Lines): A-B that run both ways, with B-A.

lines_both_ways(Halves, Lines) :-
    findall(A-B, member(half(A, B, _), Halves), Ways0),
    sort(Ways0, Ways),
    findall(A-B, ( member(A-B, Ways), ord_memberchk(B-A, Ways) ), Lines).

half_way(Lines, half(A, B, _), Way) :-
    (   ord_memberchk(A-B, Lines)
    ->  Way = line
    ;   Way = outline
    ).

%   half_parts(Table, Divided, Half, Parts): with its ends where they are now,
%   divided where others lie on it.

half_parts(Table, Divided, half(A0, B0, Label), Parts) :-
    key_moved(Table, A0, A),
    key_moved(Table, B0, B),
    (   A == B
    ->  Parts = []
    ;   msort([A,B], [C,D]),
        edge_known(C, D, Turn, Edge),
        get_assoc(Edge, Divided, Keys0)
    ->  Forth is -Turn,
        findall(Key, ( member(_-Key0, Keys0), back(Key0, Forth, Key) ),
                Keys1),
        (   A == C
        ->  Keys = Keys1
        ;   reverse(Keys1, Keys)
        ),
        append([[A],Keys,[B]], Way),
        findall(half(K1, K2, Label), append(_, [K1,K2|_], Way), Parts)
    ;   Parts = [half(A, B, Label)]
    ).

%   once_each(Halves0, Halves): of what runs both ways as often, one each if
%   some of it is a line, none if it is outline; else what is more one way, of
%   the outline first.

once_each(Halves0, Halves) :-
    findall(Ends-(Way-half(A, B, Label)),
            ( member(Way-half(A, B, Label), Halves0),
              msort([A,B], Ends) ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    findall(Half, ( member(Group, Groups), left_of(Group, Half) ), Halves).

left_of([A,_]-Group, Way-Half) :-
    findall(Way1-half(A, B, Label), member(Way1-half(A, B, Label), Group),
            Forth0),
    findall(Way1-half(B, A, Label),
            ( member(Way1-half(B, A, Label), Group), B \== A ),
            Back0),
    outline_first(Forth0, Forth),
    outline_first(Back0, Back),
    length(Forth, N),
    length(Back, M),
    (   N > M
    ->  More is N-M,
        first(More, Forth, Kept0)
    ;   N < M
    ->  More is M-N,
        first(More, Back, Kept0)
    ;   memberchk(line-_, Group)
    ->  last_of(Forth, F),
        last_of(Back, G),
        Kept0 = [F,G]
    ;   Kept0 = []
    ),
    member(_-Half, Kept0),
    (   N =:= M
    ->  Way = line
    ;   Way = outline
    ).

outline_first(Halves0, Halves) :-
    findall(Half, ( Half = outline-_, member(Half, Halves0) ), Outline),
    findall(Half, ( Half = line-_, member(Half, Halves0) ), Lines),
    append(Outline, Lines, Halves).

first(N, List, First) :-
    length(First, N),
    append(First, _, List).

last_of(List, Last) :-
    append(_, [Last], List),
    !.
