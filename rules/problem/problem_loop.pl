:- module(sg_problem_loop,
          [ whole_chains/1,             % -Chains
            step_ends/5                 % +S, +Step, -P, -Q, -Other
          ]).
:- use_module('../penetration/chain', [chains/1]).
:- use_module('../store', [line/9, v/5]).
:- use_module('../vector', [difference/3, dot_product/3, unit/2]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists),
              [append/2, append/3, last/2, list_to_set/2, member/2, nth1/3,
               reverse/2, select/3]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
:- use_module(library(yall), [(>>)/4]).
/** <module> Penetration lines as a pupil counts them.

A chain ends where more than two pieces meet: two equal cylinders meet in four
chains between two points. Whoever draws them sees two curves that cross. So
chains go on here through such a point, in pairs, the straightest first.
*/

%!  whole_chains(-Chains:list) is det.
%
%   Chains are those of chains/1, but open ones that go on as one another are
%   one, `closed` if it comes back to where it began.

whole_chains(Chains) :-
    chains(Chains0),
    findall(S1-S2, member(chain(S1, S2, _, _), Chains0), Pairs0),
    list_to_set(Pairs0, Pairs),
    maplist(pair_chains(Chains0), Pairs, Lists),
    append(Lists, Chains).

pair_chains(Chains0, S1-S2, Chains) :-
    findall(Steps, member(chain(S1, S2, open, Steps), Chains0), Open),
    findall(chain(S1, S2, Kind, Steps),
            ( member(chain(S1, S2, Kind, Steps), Chains0), Kind \== open ),
            Others),
    links(S1, Open, Links),
    followed(Open, Links, Joined),
    findall(chain(S1, S2, Kind, Steps), member(Kind-Steps, Joined), Whole),
    append(Whole, Others, Chains).

%   links(S, Open, Links): end(I, Side) of chain I, `first` or `last`, goes on
%   as another one: both ways.

links(S, Open, Links) :-
    findall(P-end(I, Side, Way),
            ( nth1(I, Open, Steps), chain_end(S, Steps, Side, P, Way) ),
            Ends0),
    keysort(Ends0, Ends),
    group_pairs_by_key(Ends, Groups),
    maplist(group_links, Groups, Lists),
    append(Lists, Links).

chain_end(S, Steps, first, P, Way) :-
    Steps = [Step|_],
    step_ends(S, Step, P, Q, _),
    way(P, Q, Way).
chain_end(S, Steps, last, Q, Way) :-
    last(Steps, Step),
    step_ends(S, Step, P, Q, _),
    way(Q, P, Way).

way(P, Q, Way) :-
    difference(Q, P, PQ),
    unit(PQ, Way).

group_links(_-[A,B], Links) :-
    !,
    linked(A, B, Links).
group_links(_-Ends, Links) :-
    findall(Dot-(A-B),
            ( append(_, [A|Rest], Ends),
              member(B, Rest),
              A = end(_, _, U),
              B = end(_, _, V),
              dot_product(U, V, Dot),
              Dot < 0.0 ),
            Ranked0),
    keysort(Ranked0, Ranked),
    foldl(straightest, Ranked, Ends-[], _-Links).

straightest(_-(A-B), Ends0-Links0, Ends-Links) :-
    (   select(A, Ends0, Ends1),
        select(B, Ends1, Ends2)
    ->  linked(A, B, Own),
        append(Links0, Own, Links),
        Ends = Ends2
    ;   Ends = Ends0,
        Links = Links0
    ).

linked(end(I, A, _), end(J, B, _), [I/A-J/B, J/B-I/A]).

%   followed(Open, Links, Joined): Kind-Steps of each whole line.

followed(Open, Links, Joined) :-
    findall(I, nth1(I, Open, _), Is),
    followed_from(Is, [], Open, Links, Joined).

followed_from([], _, _, _, []).
followed_from([I|Is], Done, Open, Links, Joined) :-
    (   memberchk(I, Done)
    ->  Joined = Joined1,
        Done1 = Done
    ;   onward(I/first, I/last, Links, Ways, Kind),
        (   Kind == closed
        ->  All = [I/first|Ways]
        ;   onward(I/last, I/first, Links, Before, _),
            maplist(turned, Before, Turned0),
            reverse(Turned0, Turned),
            append(Turned, [I/first|Ways], All)
        ),
        maplist(way_steps(Open), All, Lists),
        append(Lists, Steps),
        findall(J, member(J/_, All), Js),
        append(Js, Done, Done1),
        Joined = [Kind-Steps|Joined1]
    ),
    followed_from(Is, Done1, Open, Links, Joined1).

%   onward(From, End, Links, Ways, Kind): Ways, each I/Side where chain I is
%   entered, come after End; `closed` if they come back to From.

onward(From, End, Links, Ways, Kind) :-
    (   memberchk(End-Next, Links)
    ->  (   Next == From
        ->  Ways = [],
            Kind = closed
        ;   other_end(Next, Far),
            Ways = [Next|Ways1],
            onward(From, Far, Links, Ways1, Kind)
        )
    ;   Ways = [],
        Kind = open
    ).

other_end(I/first, I/last).
other_end(I/last, I/first).

turned(Way, Other) :-
    other_end(Way, Other).

way_steps(Open, I/Side, Steps) :-
    nth1(I, Open, Steps0),
    (   Side == first
    ->  Steps = Steps0
    ;   reverse(Steps0, Steps1),
        maplist([Step0,Step]>>(Step is -Step0), Steps1, Steps)
    ).

%!  step_ends(+S, +Step, -P, -Q, -Other) is det.
%
%   Step of a chain of segment S goes from P to Q, p(X,Y,Z), in Other, a polygon
%   S2-P2 of the other segment.

step_ends(S, Step, P, Q, Other) :-
    L is abs(Step),
    line(L, S1, P1, A1, B1, S2, P2, A2, B2),
    (   S1 == S
    ->  ends(S1, A1, B1, From, To),
        Other = S2-P2
    ;   ends(S2, A2, B2, From, To),
        Other = S1-P1
    ),
    (   Step > 0
    ->  P-Q = From-To
    ;   P-Q = To-From
    ).

ends(S, A, B, p(X1,Y1,Z1), p(X2,Y2,Z2)) :-
    v(S, A, X1, Y1, Z1),
    v(S, B, X2, Y2, Z2),
    !.
