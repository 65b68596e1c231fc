:- module(sg_chain,
          [ chains/1,                   % -Chains
            chains_by_rule/1,           % -Chains
            chain/5,                    % ?C, ?S1, ?S2, ?Kind, ?Lines
            chain_vertices/3,           % +Lines, +S, -Vs
            chain_points/2,             % +Lines, -Points
            chain_length/2              % +Lines, -Length
          ]).
:- use_module('../kernel', [line_chains/1]).
:- use_module('../store', [v/5, line/9]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [last/2, member/2, nth1/3]).
:- use_module(library(nb_set), [add_nb_set/3, empty_nb_set/1]).

/** <module> Chains: the pieces of penetration lines in order.

The pieces line/9 of two segments form a graph on their points, each a vertex
of either segment (of two vertices in one place too). A *chain* is
a run of pieces through vertices that have exactly two: from end to end where
there are ends (a vertex with one piece, or a branch point with three or
more), or round, back to where it began: then it is closed. It is a list of
line numbers, with a minus sign where a line is walked from its end to its
start. A contact in a point alone, a piece whose start is its end, is a chain of
its own: one point.

Two closed solids in general position have closed chains only. The order is
settled by line numbers alone: chains with ends first, each from the smaller
line at one, then the others from their smallest line, in its direction.

@see [PL] section 5.2, rows PL-8 and PL-9
*/

%!  chains(-Chains:list) is det.
%
%   Chains is a list of chain(S1, S2, Kind, Lines), by S1 and S2, then in the
%   order above; Kind is `open`, `closed` or `point`. Through the fused kernel,
%   in linear time but for sorting.

chains(Chains) :-
    line_chains(Chains).

%!  chains_by_rule(-Chains:list) is det.
%
%   The same by the rule; tests/rules/penetration/chain.plt holds the two
%   together.

chains_by_rule(Chains) :-
    findall(S1-S2, line(_, S1, _, _, _, S2, _, _, _), Pairs0),
    sort(Pairs0, Pairs),
    findall(Chain, ( member(S1-S2, Pairs), pair_chain(S1, S2, Chain) ),
            Chains).

%!  chain(?C, ?S1, ?S2, ?Kind, ?Lines) is nondet.
%
%   True when chain number C, counted from 1, of segments S1 and S2 is Kind
%   and consists of Lines. Makes all chains: ask once, not in a loop.

chain(C, S1, S2, Kind, Lines) :-
    chains(Chains),
    nth1(C, Chains, chain(S1, S2, Kind, Lines)).

pair_chain(S1, S2, chain(S1, S2, Kind, Lines)) :-
    findall(L-(A1/A2-B1/B2), line(L, S1, _, A1, B1, S2, _, A2, B2), Ends0),
    sort(Ends0, Ends),
    list_to_assoc(Ends, LineEnds),
    vertex_lines(Ends, Lists),
    list_to_assoc(Lists, VertexLines),
    empty_nb_set(Seen),
    Graph = graph(LineEnds, VertexLines, Seen),
    (   member(L-(A-B), Ends),
        start_at_end(L, A, B, Graph, Step)
    ;   member(Step-_, Ends)
    ),
    add_nb_set_line(Step, Seen),
    walk(Step, Graph, Lines),
    chain_kind(Lines, Graph, Kind).

%   A chain that comes back to where it began is closed, also if that is a
%   branch point; one that never left is a point.

chain_kind(Lines, Graph, Kind) :-
    Lines = [First|_],
    last(Lines, Last),
    Back is -First,
    step_end(Back, Graph, Start),
    step_end(First, Graph, Next),
    step_end(Last, Graph, End),
    (   Start == Next
    ->  Kind = point
    ;   Start == End
    ->  Kind = closed
    ;   Kind = open
    ).

%   vertex_lines(+Ends, -Lists): Lists has V-Lines for each vertex, Lines the
%   numbers of the lines there, ascending.

vertex_lines(Ends, Lists) :-
    findall(V-L,
            ( member(L-(A-B), Ends), ( V = A ; V = B ) ),
            Pairs0),
    sort(Pairs0, Pairs),
    group(Pairs, Lists).

group([], []).
group([V-L|Pairs], [V-[L|Ls]|Lists]) :-
    same_vertex(V, Pairs, Ls, Rest),
    group(Rest, Lists).

same_vertex(V, [V-L|Pairs], [L|Ls], Rest) :-
    !,
    same_vertex(V, Pairs, Ls, Rest).
same_vertex(_, Rest, [], Rest).

%   A line that starts or ends at an end of chains begins one there.

start_at_end(L, A, _, Graph, L) :-
    chain_end(A, Graph).
start_at_end(L, A, B, Graph, Back) :-
    \+ chain_end(A, Graph),
    chain_end(B, Graph),
    Back is -L.

chain_end(V, graph(_, VertexLines, _)) :-
    get_assoc(V, VertexLines, Lines),
    Lines \= [_,_].

%   add_nb_set_line(+Step, !Seen): fails when the line was walked before.

add_nb_set_line(Step, Seen) :-
    L is abs(Step),
    add_nb_set(L, Seen, true).

%   walk(+Step, +Graph, -Lines): the steps from this one to the chain's end,
%   or until it comes round.

walk(Step, Graph, [Step|Steps]) :-
    step_end(Step, Graph, V),
    (   next_step(V, Graph, Next)
    ->  walk(Next, Graph, Steps)
    ;   Steps = []
    ).

step_end(Step, graph(LineEnds, _, _), V) :-
    L is abs(Step),
    get_assoc(L, LineEnds, A-B),
    (   Step > 0
    ->  V = B
    ;   V = A
    ).

next_step(V, graph(LineEnds, VertexLines, Seen), Step) :-
    get_assoc(V, VertexLines, [L1,L2]),
    member(L, [L1,L2]),
    add_nb_set_line(L, Seen),
    !,
    get_assoc(L, LineEnds, A-_),
    (   A == V
    ->  Step = L
    ;   Step is -L
    ).

%!  chain_vertices(+Lines, +S, -Vs) is semidet.
%
%   Vs are the vertices of segment S along the chain; of a closed one the last
%   is the first again, of a point there is one. Fails when S is not one of the
%   chain's two segments.

chain_vertices([Step|Steps], S, [V|Vs]) :-
    step_vertices(Step, S, V, V1),
    (   Steps == [],
        is_point(Step)
    ->  Vs = []
    ;   chain_vertices_(Steps, S, V1, Vs)
    ).

is_point(Step) :-
    L is abs(Step),
    line(L, _, _, A1, A1, _, _, A2, A2).

chain_vertices_([], _, V, [V]).
chain_vertices_([Step|Steps], S, V, [V|Vs]) :-
    step_vertices(Step, S, V, V1),
    chain_vertices_(Steps, S, V1, Vs).

step_vertices(Step, S, From, To) :-
    L is abs(Step),
    line(L, S1, _, A1, B1, S2, _, A2, B2),
    (   S == S1
    ->  A = A1, B = B1
    ;   S == S2
    ->  A = A2, B = B2
    ),
    (   Step > 0
    ->  From = A, To = B
    ;   From = B, To = A
    ).

%!  chain_points(+Lines, -Points) is det.
%
%   Points are the point(X,Y,Z) along the chain, as its first segment has
%   them.

chain_points(Lines, Points) :-
    Lines = [Step|_],
    L is abs(Step),
    line(L, S, _, _, _, _, _, _, _),
    chain_vertices(Lines, S, Vs),
    maplist(vertex_point(S), Vs, Points).

vertex_point(S, V, point(X,Y,Z)) :-
    v(S, V, X, Y, Z).

%!  chain_length(+Lines, -Length) is det.
%
%   Length is the true length of the chain in model units.

chain_length(Lines, Length) :-
    chain_points(Lines, [Point|Points]),
    foldl(longer, Points, Point-0.0, _-Length).

longer(Point, Last-Length0, Point-Length) :-
    point_distance(Last, Point, Distance),
    Length is Length0+Distance.

point_distance(point(X1,Y1,Z1), point(X2,Y2,Z2), D) :-
    D is sqrt((X2-X1)**2 + (Y2-Y1)**2 + (Z2-Z1)**2).
