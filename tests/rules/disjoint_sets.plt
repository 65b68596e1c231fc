/* Connected components, against reaching each member from another. */
:- module(test_disjoint_sets, []).
:- use_module(library(aggregate)).
:- use_module(library(assoc)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(library(ugraphs)).
:- use_module(rules(disjoint_sets)).

joined([], Sets, Sets).
joined([A-B|Pairs], Sets0, Sets) :-
    sets_joined(A, B, Sets0, Sets1),
    joined(Pairs, Sets1, Sets).

way(Sets, Member, Length) :-
    (   get_assoc(Member, Sets, on(Next))
    ->  way(Sets, Next, Length0),
        Length is Length0+1
    ;   Length = 0
    ).

:- begin_tests(disjoint_sets).

test(components, [ forall(between(1, 30, Seed)), true(Wrong == []) ]) :-
    set_random(seed(Seed)),
    findall(A-B, ( between(1, 25, _), random_between(1, 30, A),
                   random_between(1, 30, B) ), Pairs),
    empty_assoc(Empty),
    joined(Pairs, Empty, Sets),
    findall(Edge, ( member(A-B, Pairs), ( Edge = A-B ; Edge = B-A ) ), Edges),
    numlist(1, 30, Members),
    vertices_edges_to_ugraph(Members, Edges, Graph),
    findall(A-B,
            ( member(A, Members),
              reachable(A, Graph, Reached),
              member(B, Members),
              set_root(Sets, A, RootA),
              set_root(Sets, B, RootB),
              \+ ( memberchk(B, Reached) -> RootA == RootB
                 ; RootA \== RootB ) ),
            Wrong).
%   The smaller one hangs on the larger: no way is long, however they are
%   joined.
test(ways, [ forall(member(Order, [up,down])), true(Most =< 10) ]) :-
    findall(A-B, ( between(1, 1023, I),
                   ( Order == up -> A = I, B is I+1
                   ; A is 1025-I, B is 1024-I ) ), Pairs),
    empty_assoc(Empty),
    joined(Pairs, Empty, Sets),
    aggregate_all(max(Length), ( between(1, 1024, M), way(Sets, M, Length) ),
                  Most).
test(sizes, Most == 3) :-               % trees of equal size, joined in pairs
    empty_assoc(Empty),
    joined([1-2,3-4,5-6,7-8,1-3,5-7,1-5], Empty, Sets),
    aggregate_all(max(Length), ( between(1, 8, M), way(Sets, M, Length) ),
                  Most).

:- end_tests(disjoint_sets).
