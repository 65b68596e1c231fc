:- module(sg_oracle_stroke,
          [ strokes_by_rule/2,          % +Parts, -Strokes
            sheet_strokes_by_rule/4     % +Default, +Options, -Sheet, -Strokes
          ]).
:- use_module('../../rules/sheet/sheet', [picture_parts/1]).
:- use_module('../../rules/sheet/stroke', []).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [append/2, append/3, last/2, member/2]).
:- use_module(library(pairs), [group_pairs_by_key/2, pairs_values/2]).
/** <module> The rule of strokes (rules/sheet/stroke.pl), part by part.
*/

:- set_prolog_flag(optimise, true).

%!  sheet_strokes_by_rule(+Default, +Options, -Sheet, -Strokes) is det.
%
%   What sheet_strokes/5 answers, but the place.

sheet_strokes_by_rule(Default, Options, Sheet, Strokes) :-
    sg_sheet:hidden_option(Options, Hidden),
    picture_parts(Parts),
    sg_sheet:parts_box(Parts, Box),
    sg_sheet:sheet_place(Box, Default, Options, Sheet, Place),
    sg_sheet:placed_parts(Hidden, Place, Parts, Placed),
    strokes_by_rule(Placed, Strokes).

%!  strokes_by_rule(+Parts, -Strokes) is det.
%
%   What strokes/2 answers.

strokes_by_rule(Parts, Strokes) :-
    whole_parts(Parts, Whole),
    single_parts(Whole, Single),
    part_leavings(Single, Leavings),
    painting_groups(Single, Groups),
    maplist(group_strokes(Leavings), Groups, Chains),
    append(Chains, Strokes).

%   Neighbouring parts of one edge that look alike become one part.

whole_parts(Parts, Whole) :-
    maplist(by_edge, Parts, Keyed0),
    msort(Keyed0, Keyed),
    pairs_values(Keyed, Sorted),
    joined_parts(Sorted, Whole).

by_edge(Part, k(S,E,From)-Part) :-
    Part = part(_, _, S, E, From, _, _, _).

joined_parts([part(V,R,S,E,F,T0,A,_), part(V,R,S,E,F1,T,_,B)|Parts], Whole) :-
    T0 =:= F1,
    !,
    joined_parts([part(V,R,S,E,F,T,A,B)|Parts], Whole).
joined_parts([Part|Parts0], Whole) :-
    (   Part = part(_, _, _, _, _, _, P, P)
    ->  Whole = Parts
    ;   Whole = [Part|Parts]
    ),
    joined_parts(Parts0, Parts).
joined_parts([], []).

%   One part for each pair of ends: the foremost.

single_parts(Parts, Single) :-
    maplist(by_ends, Parts, Keyed0),
    msort(Keyed0, Keyed),
    group_pairs_by_key(Keyed, Groups),
    maplist(foremost, Groups, Single).

by_ends(Part, (Low-High)-front(Front,S,E,From,Part)) :-
    Part = part(Visibility, Role, S, E, From, _, A, B),
    msort([A,B], [Low,High]),
    sg_stroke:paint_rank(Visibility, Role, Rank),
    Front is -Rank.

foremost(_-[front(_,_,_,_,Part)|_], Part).

painting_groups(Parts, Groups) :-
    maplist(by_paint, Parts, Keyed0),
    msort(Keyed0, Keyed),
    group_pairs_by_key(Keyed, Groups).

by_paint(Part, g(Rank,Visibility,Role,S)-p(E,From,Part)) :-
    Part = part(Visibility, Role, S, E, From, _, _, _),
    sg_stroke:paint_rank(Visibility, Role, Rank).

group_strokes(Leavings, g(_,Visibility,Role,S)-Keyed, Strokes) :-
    maplist(arg(3), Keyed, Parts),
    part_net(Parts, Visibility, Net),
    net_chains(Net, Chains),
    maplist(chain_stroke(Leavings, Visibility, Role, S), Chains, Strokes).

%   part_leavings(Parts, Leavings): for each point an end of a part, the
%   leave(Visibility,Role,S,E,DX,DY) there, DX,DY its direction.

part_leavings(Parts, Leavings) :-
    foldl(leaving, Parts, Pairs0, []),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    list_to_assoc(Groups, Leavings).

leaving(part(Visibility,Role,S,E,_,_,A,B),
        [ A-leave(Visibility,Role,S,E,DX,DY),
          B-leave(Visibility,Role,S,E,BackX,BackY)|Pairs], Pairs) :-
    direction(A, B, DX, DY),
    BackX is -DX,
    BackY is -DY.

direction(XA-YA, XB-YB, DX, DY) :-
    X is float(XB-XA),
    Y is float(YB-YA),
    Length is sqrt(X*X + Y*Y),
    DX is X/Length,
    DY is Y/Length.

/* Part I of a group has the ends 2I-1, its start, and 2I, its end. A net holds
the parts, for each end its mate (unbound: none), and for each part whether it
was used (unbound: not yet).
*/

part_net(Parts, Visibility, net(Array,Mates,Used)) :-
    compound_name_arguments(Array, parts, Parts),
    compound_name_arity(Array, _, N),
    N2 is 2*N,
    functor(Mates, mates, N2),
    functor(Used, used, N),
    part_ends(Parts, 1, Ends0),
    msort(Ends0, Ends),
    group_pairs_by_key(Ends, Nodes),
    straightest(Visibility, Least),
    foldl(node_mated(Least), Nodes, Mates, _).

%   Node-end(End,DX,DY): the part leaves the node there towards DX,DY.

part_ends([], _, []).
part_ends([part(_,_,_,_,_,_,A,B)|Parts], I, [A-EndA,B-EndB|Ends]) :-
    Start is 2*I-1,
    End is 2*I,
    direction(A, B, DX, DY),
    BackX is -DX,
    BackY is -DY,
    EndA = end(Start,DX,DY),
    EndB = end(End,BackX,BackY),
    I1 is I+1,
    part_ends(Parts, I1, Ends).

%   The cosine of the sharpest turn that a pen follows; and of one that is no
%   turn.

straightest(visible, -1.1).
straightest(hidden, 0.766).             % 40 degrees
straightest(other, 0.99985).            % 1 degree

node_mated(Least, _-Ends, Mates, Mates) :-
    node_pairs(Ends, Pairs0),
    msort(Pairs0, Pairs),
    pairs_mated(Pairs, Least, Mates).

pairs_mated([], _, _).
pairs_mated([Bend-pair(A,B)|Pairs], Least, Mates) :-
    (   -Bend >= Least,
        arg(A, Mates, MateA),
        var(MateA),
        arg(B, Mates, MateB),
        var(MateB)
    ->  MateA = B,
        MateB = A
    ;   true
    ),
    pairs_mated(Pairs, Least, Mates).

%   Pairs of ends that could be mates, with their bend, -1 straight, 1 back.
%   At a node of many ends (an apex) only those across from each other.

node_pairs([_], []) :-
    !.
node_pairs(Ends, Pairs) :-
    length(Ends, N),
    (   N =< 12
    ->  findall(Pair, two_ends(Ends, Pair), Pairs)
    ;   maplist(by_angle, Ends, Keyed0),
        msort(Keyed0, Keyed),
        pairs_values(Keyed, Round),
        Half is N//2,
        length(First, Half),
        append(First, Second, Round),
        across(First, Second, Pairs)
    ).

two_ends(Ends, Pair) :-
    append(_, [End1|Rest], Ends),
    member(End2, Rest),
    ends_pair(End1, End2, Pair).

ends_pair(end(A,XA,YA), end(B,XB,YB), Bend-pair(A,B)) :-
    Bend is XA*XB + YA*YB.

by_angle(End, Angle-End) :-
    End = end(_, X, Y),
    Angle is atan2(Y, X).

across([], _, []).
across([End1|Ends1], [End2|Ends2], [Pair|Pairs]) :-
    ends_pair(End1, End2, Pair),
    across(Ends1, Ends2, Pairs).

%   Chains from every end without a mate, then the rings that are left.

net_chains(Net, Chains) :-
    Net = net(Array, _, _),
    compound_name_arity(Array, _, N),
    End is 2*N,
    chains_from(1, 1, End, Net, Chains, Rings),
    chains_from(1, 2, End, Net, Rings, []).

chains_from(End, _, Last, _, Chains, Chains) :-
    End > Last,
    !.
chains_from(End, Step, Last, Net, Chains, Tail) :-
    (   chain_starts(Step, End, Net)
    ->  chain(End, Net, Steps),
        Chains = [Steps|Chains1]
    ;   Chains = Chains1
    ),
    Next is End+Step,
    chains_from(Next, Step, Last, Net, Chains1, Tail).

%   Step 1: from ends without a mate; step 2: from the start of any part.

chain_starts(Step, End, net(_,Mates,Used)) :-
    Part is (End+1)//2,
    arg(Part, Used, Taken),
    var(Taken),
    (   Step =:= 2
    ->  true
    ;   arg(End, Mates, Mate),
        var(Mate)
    ).

%   The parts met on the way from End, each forward(Part) or back(Part).

chain(End, Net, Steps) :-
    Net = net(Array, Mates, Used),
    I is (End+1)//2,
    arg(I, Used, Taken),
    (   var(Taken)
    ->  Taken = used,
        arg(I, Array, Part),
        (   End mod 2 =:= 1
        ->  Step = forward(Part),
            Far is End+1
        ;   Step = back(Part),
            Far is End-1
        ),
        Steps = [Step|Steps1],
        arg(Far, Mates, Mate),
        (   var(Mate)
        ->  Steps1 = []
        ;   chain(Mate, Net, Steps1)
        )
    ;   Steps = []
    ).

chain_stroke(Leavings, Visibility, Role, S, [Step|Steps],
             stroke(Visibility,Role,S,Edges,[Point|Points],Start,End)) :-
    step_points(Step, Point, Second),
    steps_line([Step|Steps], Edges, Points, Before-Last),
    (   Point == Last
    ->  Start = ring,
        End = ring
    ;   Edges = [E1|_],
        last(Edges, E2),
        Look = look(Visibility, Role, S),
        end_kind(Leavings, Look, E1, Point, Second, Start),
        end_kind(Leavings, Look, E2, Last, Before, End)
    ).

steps_line([Step|Steps], [E|Edges], [B|Points], Last) :-
    step_edge(Step, E),
    step_points(Step, A, B),
    (   Steps == []
    ->  Last = A-B,
        Edges = [],
        Points = []
    ;   steps_line(Steps, Edges, Points, Last)
    ).

step_edge(forward(part(_,_,_,E,_,_,_,_)), E).
step_edge(back(part(_,_,_,E,_,_,_,_)), E).

step_points(forward(part(_,_,_,_,_,_,A,B)), A, B).
step_points(back(part(_,_,_,_,_,_,A,B)), B, A).

%   end_kind(Leavings, Look, E, Point, Next, Kind): of a stroke that comes from
%   Next along edge E and ends at Point.

end_kind(Leavings, Look, E, Point, Next, Kind) :-
    get_assoc(Point, Leavings, Others),
    (   goes_on(Look, E, Point, Next, Others)
    ->  Kind = cut
    ;   Kind = joint
    ).

goes_on(look(Visibility,_,S), E, _, _, Others) :-
    member(leave(Visibility2,_,S,E,_,_), Others),
    Visibility2 \== Visibility,
    !.
goes_on(look(Visibility,Role,S), _, Point, Next, Others) :-
    findall(x, member(leave(Visibility,_,_,_,_,_), Others), [x]),
    direction(Point, Next, DX, DY),
    member(leave(Visibility2,Role2,S2,_,DX2,DY2), Others),
    Visibility2 \== Visibility,
    Straight is -(DX*DX2 + DY*DY2),
    (   Role2-S2 == Role-S
    ->  straightest(hidden, Least)
    ;   straightest(other, Least)
    ),
    Straight >= Least.
