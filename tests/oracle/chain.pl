:- module(sg_oracle_chain,
          [ chains_by_rule/1            % -Chains
          ]).
:- use_module('../../rules/store', [line/9]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [last/2, member/2]).
:- use_module(library(nb_set), [add_nb_set/3, empty_nb_set/1]).
/** <module> The rule of chains (rules/penetration/chain.pl), piece by piece.
*/

%!  chains_by_rule(-Chains:list) is det.
%
%   Chains are those of chains/1.

chains_by_rule(Chains) :-
    findall(S1-S2, line(_, S1, _, _, _, S2, _, _, _), Pairs0),
    sort(Pairs0, Pairs),
    findall(Chain, ( member(S1-S2, Pairs), pair_chain(S1, S2, Chain) ),
            Chains).

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
