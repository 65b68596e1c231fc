:- module(test_loose_crease,
          [ loose_creases/1             % -Ends
          ]).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(rules(store)).
/** <module> Creases of a picture that end where no other line is, for tests.
*/

%!  loose_creases(-Ends:list) is det.
%
%   Ends are the vertices, S-V, in which one crease of the picture ends, and no
%   other crease, border, outline along edges, penetration line or curve.
%   Hidden lines count.

loose_creases(Ends) :-
    findall(end(S,V)-Role,
            ( distinct_edge(S, E, Role), E > 0, e(S, E, V1, V2, _),
              member(V, [V1,V2]) ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    findall(S-V, member(end(S,V)-[crease], Groups), Ends).

distinct_edge(S, E, Role) :-
    findall(edge(S,E,Role), drawn(_, S, E, _, _, _, Role), Edges0),
    sort(Edges0, Edges),
    member(edge(S,E,Role), Edges).
