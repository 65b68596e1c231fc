:- module(sg_true_tip,
          [ tips_moved/4,               % +Facets0, -Facets, +Shape0, -Shape
            tips_cancelled/2            % +Halves0, -Halves
          ]).
:- use_module('../near',
              [ tolerance/2, same_angle/2, before_angle/2,
                same_part/2, less_part/2
              ]).
:- use_module('../kernel', [roll_curves/5]).
:- use_module(true_divide, [crossing_near/7]).
:- use_module(true_shape,
              [edge_curve/4, facet_middle/2, key_place/4, shifted_facet/3]).
:- use_module(library(apply), [exclude/3, foldl/5, maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2, put_assoc/4]).
:- use_module(library(lists),
              [append/2, append/3, member/2, nth1/3, reverse/2, select/3]).
:- use_module(library(pairs), [group_pairs_by_key/2, pairs_keys_values/3]).
/** <module> Tips: where a true line goes past a generator that facets missed.

The line of the true surfaces lies beside that of the facets. Where it turns
back near a generator, as at the sides of a hole, it may reach the next facet,
where the line of the facets does not. The part past the generator, a *tip*, is
given to that facet: it gets the half-edges of the tip, and both facets the
piece of the generator between its ends, each in its own direction; what is
there twice, once each way, vanishes: of a hole that is all of the piece, which
lies in the hole now. A tip may go on past the next generator.
*/

%!  tips_moved(+Facets0, -Facets, +Shape0, -Shape) is det.
%
%   Facets are Facets0, with all tips in the facets where they are. Tips that
%   reach past a generator by less than where surfaces meet is known may stay.

tips_moved(Facets0, Facets, Shape0, Shape) :-
    Shape0 = shape(_, Reach, _),
    tolerance(surface, Near),
    Tolerance is 4.0*Near*Reach,
    findall(N-Facet, nth1(N, Facets0, Facet), Numbered),
    list_to_assoc(Numbered, Table0),
    ends_table(Numbered, Ends),
    facets_beyond(Numbered, Tolerance, Shape0, Queue),
    moved(Queue, 10000, Ends, Tolerance, Table0, Table, Shape0, Shape),
    findall(Facet,
            ( member(N-_, Numbered), get_assoc(N, Table, Facet) ),
            Facets).

%   ends_table(Numbered, Ends): an assoc from start(Place) and end(Place) to the
%   numbers of the facets that start or end at this generator.

ends_table(Numbered, Ends) :-
    findall(End-N,
            ( member(N-facet(_, T1, T2, _), Numbered),
              (   turn_place(T1, Place), End = start(Place)
              ;   turn_place(T2, Place), End = end(Place)
              ) ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    list_to_assoc(Groups, Ends).

turn_place(T, Place) :-
    Place is round(T*1.0e6) mod 360000000.

moved([], _, _, _, Table, Table, Shape, Shape) :-
    !.
moved(_, 0, _, _, Table, Table, Shape, Shape) :-
    !.
moved([N|Queue], Most0, Ends, Tolerance, Table0, Table, Shape0, Shape) :-
    Most is Most0-1,
    get_assoc(N, Table0, Facet0),
    (   facet_tip(Facet0, Ends, Table0, Tolerance, Tip, Facet1, Shape0, Shape1)
    ->  Tip = tip(_, Q, _, _, _, _),
        tip_given(Tip, N, Facet1, Table0, Table1, Shape1),
        moved([N,Q|Queue], Most, Ends, Tolerance, Table1, Table, Shape1, Shape)
    ;   moved(Queue, Most, Ends, Tolerance, Table0, Table, Shape0, Shape)
    ).

%   facets_beyond(Numbered, Tolerance, Shape, Ns): Ns are the numbers of the
%   facets that have a line that is past one of their generators somewhere: most
%   have none. All lines are asked for at once.

facets_beyond(Numbered, Tolerance, Shape, Ns) :-
    findall(asked(N, Facet, Line),
            ( member(N-Facet, Numbered),
              Facet = facet(_, _, _, Halves),
              line_edges(Halves, Shape, Lines),
              member(Line, Lines) ),
            Asked),
    (   Asked = [asked(_, facet(_, Start, _, _), _)|_]
    ->  maplist(asked_line(Shape), Asked, Curves),
        Shape = shape(Surface, Reach, _),
        roll_curves(roll(Surface, 0.0, Start), Reach, Tolerance, Curves, Lists),
        pairs_keys_values(Pairs, Asked, Lists),
        findall(N,
                ( member(asked(N, facet(_, T1, T2, _), Line)-Places, Pairs),
                  line_places(Shape, Line, Places, Ss),
                  is_beyond(Ss, T1, T2) ),
                Ns0),
        sort(Ns0, Ns)
    ;   Ns = []
    ).

asked_line(Shape, asked(_, Facet, Line), Curve) :-
    facet_middle(Facet, Middle),
    asked_line(Shape, Middle, Line, Curve).

%   facet_tip(Facet0, Ends, Table, Tolerance, Tip, Facet, Shape0, Shape): the
%   first tip of Facet0: tip(T, Q, Turns, Chain, From, To): the half-edges of
%   Chain run from key From to To, both on the generator at T, and belong to
%   facet Q carried round by Turns. Facet has the rest.

facet_tip(Facet0, Ends, Table, Tolerance, tip(T, Q, Turns, Chain, From, To),
          facet(P, T1, T2, Rest), Shape0, Shape) :-
    Facet0 = facet(P, T1, T2, Halves0),
    line_edges(Halves0, Shape0, Lines),
    Lines \== [],
    lines_parted(Lines, Facet0, Tolerance, Parted, Shape0, Shape),
    Parted \== [],
    list_to_assoc(Parted, Parts),
    maplist(half_parts(Parts, Facet0, Shape), Halves0, Lists),
    append(Lists, Zoned),
    member(Side-T, [start-T1,end-T2]),
    chain(Zoned, Side, T, Shape, Chain, From, To),
    neighbour(Side, T, From-To, Ends, Table, Shape, Q, Turns),
    findall(Half,
            ( member(_-Half, Zoned), \+ memberchk(Half, Chain) ),
            Rest),
    !.

%   line_edges(Halves, Shape, Lines): line(Key1, Key2, Other), Key1 @< Key2, of
%   those half-edges along which Other meets the surface.

line_edges(Halves, Shape, Lines) :-
    Shape = shape(_, _, Nodes),
    findall(line(A, B, Other),
            ( member(half(K1, K2, _), Halves),
              is_met(Nodes, K1),
              is_met(Nodes, K2),
              msort([K1,K2], [A,B]),
              edge_curve(Shape, A, B, meets(Other)) ),
            Lines0),
    sort(Lines0, Lines).

is_met(Nodes, k(Id, _)) :-
    get_assoc(Id, Nodes, node(_, _, _, [_|_])).


                /*******************************
                *             PARTS            *
                *******************************/

%   lines_parted(Lines, Facet, Tolerance, Parted, Shape0, Shape): Parted is the
%   list of Key1-Key2-Parts for the lines that are past a generator of the facet
%   somewhere; Parts, from Key1 to Key2, are part(Zone, KeyA, KeyB): a part is
%   `in`, or beyond the `start` or `end` of the facet, and ends at a generator.

lines_parted(Lines, Facet, Tolerance, Parted, Shape0, Shape) :-
    Facet = facet(_, T1, T2, _),
    facet_middle(Facet, Middle),
    Shape0 = shape(Surface, Reach, _),
    maplist(asked_line(Shape0, Middle), Lines, Curves),
    roll_curves(roll(Surface, 0.0, T1), Reach, Tolerance, Curves, Lists),
    foldl(line_parted(T1, T2), Lines, Lists, []-Shape0, Parted-Shape).

asked_line(shape(Surface, _, Nodes), Middle, line(A, B, Other),
           curve(Middle, [Surface,Other], From, To)) :-
    A = k(Id1, _),
    B = k(Id2, _),
    get_assoc(Id1, Nodes, node(_, _, From, _)),
    get_assoc(Id2, Nodes, node(_, _, To, _)).

line_parted(T1, T2, Line, Places, Parted0-Shape0, Parted-Shape) :-
    Line = line(A, B, _),
    line_places(Shape0, Line, Places, [First|Rest]),
    (   is_beyond([First|Rest], T1, T2),
        parts(First, Rest, line(A, B, T1, T2), A, in, Parts0, Shape0, Shape1),
        exclude(is_point, Parts0, Parts),
        Parts \= [part(in, _, _)]
    ->  Parted = [(A-B)-Parts|Parted0],
        Shape = Shape1
    ;   Parted = Parted0,
        Shape = Shape0
    ).

%   line_places(Shape, Line, Places, Ss): s(T, H, Key) along Line, Key `none`
%   but for its ends.

line_places(shape(_, _, Nodes), line(A, B, _), Places,
            [s(TA, HA, A)|Ss]) :-
    key_place(Nodes, A, TA, HA),
    key_place(Nodes, B, TB, HB),
    findall(s(T, H, none), member(place(T, H, _, _), Places), Inner),
    append(Inner, [s(TB, HB, B)], Ss).

is_beyond(Ss, T1, T2) :-
    member(s(T, _, _), Ss),
    zone(T1, T2, T, Zone),
    Zone \== in,
    !.

is_point(part(_, Key, Key)).

zone(T1, T2, T, Zone) :-
    (   before_angle(T, T1)
    ->  Zone = start
    ;   before_angle(T2, T)
    ->  Zone = end
    ;   Zone = in
    ).

%   parts(S, Ss, Line, Start, Zone0, Parts, Shape0, Shape): the part that runs
%   began at key Start and has been in Zone0 until S.

parts(S1, Ss, Line, Start, Zone0, Parts, Shape0, Shape) :-
    Line = line(_, _, T1, T2),
    S1 = s(TS1, _, Key1),
    zone(T1, T2, TS1, Zone1),
    (   Zone0 == in
    ->  Zone = Zone1
    ;   Zone = Zone0
    ),
    (   Ss == []
    ->  Parts = [part(Zone, Start, Key1)],
        Shape = Shape0
    ;   Ss = [S2|Ss2],
        S2 = s(TS2, _, Key2),
        zone(T1, T2, TS2, Zone2),
        (   (   Zone1 == Zone2
            ;   Zone1 == in, Key1 \== none, on_border(Zone2, TS1, T1, T2)
            ;   Zone2 == in, Key2 \== none, on_border(Zone1, TS2, T1, T2)
            )
        ->  parts(S2, Ss2, Line, Start, Zone, Parts, Shape0, Shape)
        ;   border(Zone1, Zone2, T1, T2, T),
            line_crossing(Line, T, S1, S2, Key, Shape0, Shape1),
            Parts = [part(Zone, Start, Key)|Parts1],
            parts(S2, Ss2, Line, Key, in, Parts1, Shape1, Shape)
        )
    ).

%   on_border(Zone, T, T1, T2): T is where Zone begins.

on_border(start, T, T1, _) :-
    same_angle(T, T1).
on_border(end, T, _, T2) :-
    same_angle(T, T2).

border(Zone1, Zone2, T1, T2, T) :-
    (   ( Zone1 == start ; Zone2 == start )
    ->  T = T1
    ;   T = T2
    ).

%   line_crossing(Line, T, S1, S2, Key, Shape0, Shape): Line crosses the
%   generator at T between S1 and S2 in Key: an end of it, if it is there. Else
%   the part between two points that are one would be crossed without end.

line_crossing(line(A, B, _, _), T, s(TS1, H1, _), s(TS2, H2, _), Key, Shape0,
              Shape) :-
    H is H1 + (H2-H1)*(T-TS1)/(TS2-TS1),
    crossing_near(A, B, T, H, Key1, Shape0, Shape1),
    Shape1 = shape(_, _, Nodes),
    key_place(Nodes, Key1, _, H3),
    (   member(End, [A,B]),
        on_generator(Shape1, T, End),
        key_place(Nodes, End, _, H4),
        same_part(H3, H4)
    ->  Key = End,
        Shape = Shape0
    ;   Key = Key1,
        Shape = Shape1
    ).

%   half_parts(Parts, Facet, Shape, Half, Zoned): a half-edge that is no such
%   line, as one along a generator, may be beyond the facet as a whole.

half_parts(Parts, Facet, Shape, Half, Zoned) :-
    Half = half(K1, K2, Label),
    (   get_assoc(K1-K2, Parts, List)
    ->  findall(Zone-half(A, B, Label), member(part(Zone, A, B), List), Zoned)
    ;   get_assoc(K2-K1, Parts, List)
    ->  findall(Zone-half(B, A, Label), member(part(Zone, A, B), List), Zoned0),
        reverse(Zoned0, Zoned)
    ;   half_zone(Facet, Shape, Half, Zone),
        Zoned = [Zone-Half]
    ).

half_zone(facet(_, T1, T2, _), shape(_, _, Nodes), half(A, B, _), Zone) :-
    (   key_place(Nodes, A, TA, _),
        TA \== any,
        key_place(Nodes, B, TB, _),
        TB \== any,
        zone(T1, T2, TA, Zone0),
        zone(T1, T2, TB, Zone0)
    ->  Zone = Zone0
    ;   Zone = in
    ).


                /*******************************
                *             TIPS             *
                *******************************/

%   chain(Zoned, Side, T, Shape, Chain, From, To): half-edges end to end beyond
%   the side, from one point of its generator to another.

chain(Zoned, Side, T, Shape, [First|Chain], From, To) :-
    member(Side-First, Zoned),
    First = half(From, _, _),
    on_generator(Shape, T, From),
    chain_on(First, Zoned, Side, T, Shape, Chain, To).

chain_on(half(A, B, _), Zoned, Side, T, Shape, Chain, To) :-
    (   on_generator(Shape, T, B)
    ->  Chain = [],
        To = B
    ;   member(Side-Next, Zoned),
        Next = half(B, C, _),
        C \== A
    ->  Chain = [Next|Chain1],
        chain_on(Next, Zoned, Side, T, Shape, Chain1, To)
    ).

on_generator(shape(_, _, Nodes), T, Key) :-
    key_place(Nodes, Key, T1, _),
    (   T1 == any
    ->  true
    ;   same_angle(T1, T)
    ).

%   neighbour(Side, T, From-To, Ends, Table, Shape, Q, Turns): facet Q, carried
%   round by Turns, is on the other side of the generator at T, and has a part
%   of it where the tip is.

neighbour(Side, T, From-To, Ends, Table, Shape, Q, Turns) :-
    turn_place(T, Place),
    (   Side == end
    ->  get_assoc(start(Place), Ends, Qs)
    ;   get_assoc(end(Place), Ends, Qs)
    ),
    Shape = shape(_, _, Nodes),
    key_place(Nodes, From, _, H1),
    key_place(Nodes, To, _, H2),
    member(Q, Qs),
    get_assoc(Q, Table, facet(P, TQ1, TQ2, Halves)),
    Turns is round((T-TQ1)/360.0),      % a facet is less than half a turn
    shifted_facet(Turns, facet(P, TQ1, TQ2, Halves), facet(_, _, _, Shifted)),
    member(half(A, B, _), Shifted),
    on_generator(Shape, T, A),
    on_generator(Shape, T, B),
    key_place(Nodes, A, _, H3),
    key_place(Nodes, B, _, H4),
    \+ less_part(max(H1, H2), min(H3, H4)),
    \+ less_part(max(H3, H4), min(H1, H2)),
    !.

%   tip_given(Tip, N, Facet, Table0, Table, Shape): facet N is Facet, without
%   the tip; both it and Q get the piece of the generator.

tip_given(tip(T, Q, Turns, Chain, From, To), N, Facet0, Table0, Table, Shape) :-
    Facet0 = facet(P, T1, T2, Halves0),
    get_assoc(Q, Table0, FacetQ0),
    shifted_facet(Turns, FacetQ0, facet(PQ, TQ1, TQ2, HalvesQ0)),
    HalvesP1 = [half(From, To, tip)|Halves0],
    append(Chain, [half(To, From, tip)|HalvesQ0], HalvesQ1),
    append(HalvesP1, HalvesQ1, All),
    settled(HalvesP1, T, Shape, All, HalvesP),
    settled(HalvesQ1, T, Shape, All, HalvesQ),
    put_assoc(N, Table0, facet(P, T1, T2, HalvesP), Table1),
    Back is -Turns,
    shifted_facet(Back, facet(PQ, TQ1, TQ2, HalvesQ), FacetQ),
    put_assoc(Q, Table1, FacetQ, Table).

%   settled(Halves0, T, Shape, All, Halves): Halves are Halves0, where those
%   along generator T are divided at all ends of the half-edges All that lie on
%   it; two that are opposite vanish, if one came with a tip.

settled(Halves0, T, Shape, All, Halves) :-
    generator_keys(All, T, Shape, Keys),
    findall(Half,
            ( member(Half0, Halves0),
              elementary(Half0, T, Shape, Keys, Half) ),
            Halves1),
    tips_cancelled(Halves1, Halves).

%   generator_keys(Halves, T, Shape, Keys): H-Key of all on generator T, in
%   order.

generator_keys(Halves, T, Shape, Keys) :-
    findall(H-Key,
            ( member(half(A, B, _), Halves),
              ( Key = A ; Key = B ),
              generator_height(Shape, T, Key, H) ),
            Keys0),
    sort(Keys0, Keys).

generator_height(Shape, T, Key, H) :-
    on_generator(Shape, T, Key),
    Shape = shape(_, _, Nodes),
    key_place(Nodes, Key, _, H).

elementary(half(A, B, Label), T, Shape, Keys, Half) :-
    (   generator_height(Shape, T, A, H1),
        generator_height(Shape, T, B, H2)
    ->  findall(Key,
                ( member(H-Key, Keys),
                  H > min(H1, H2),
                  H < max(H1, H2) ),
                Between0),
        (   H1 =< H2
        ->  Between = Between0
        ;   reverse(Between0, Between)
        ),
        append([A|Between], [B], Way),
        append(_, [C,D|_], Way),
        Half = half(C, D, Label)
    ;   Half = half(A, B, Label)
    ).

%!  tips_cancelled(+Halves0, -Halves) is det.
%
%   Halves are Halves0 without two that are opposite, if one of these came with
%   a tip.

tips_cancelled(Halves0, Halves) :-
    (   select(half(A, B, tip), Halves0, Halves1),
        select(half(B, A, _), Halves1, Halves2)
    ->  tips_cancelled(Halves2, Halves)
    ;   Halves = Halves0
    ).
