:- module(test_part_edges, []).
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(rules(sanggwan)).
:- use_module(rules(kernel)).
:- use_module(rules(development/part_edges)).

% Borders that lie on parts of each other are divided, so that parts attach to
% parts; vertices in one place become one.

% with_polygons(+Polygons, :Goal): segment 1 of polygons of points X-Y-Z, each
% with vertices of its own (`apart`), or with one vertex for each place.
with_polygons(How, Polygons, Goal) :-
    new_world(World),
    in_world(World,
             ( assert_fact(segment(1, surface, raw)),
               foldl(polygon(How), Polygons, 1-1-1, _),
               complete_segments,
               call(Goal) )).

polygon(How, Points, P-V0-E0, P1-V-E) :-
    foldl(vertex(How), Points, Vs, V0, V),
    Vs = [First|Rest],
    append(Rest, [First], Nexts),
    foldl(edge, Vs, Nexts, Es, E0, E),
    assert_fact(p(1, P, Es)),
    P1 is P+1.

vertex(How, X0-Y0-Z0, V, V0, V1) :-
    X is float(X0),
    Y is float(Y0),
    Z is float(Z0),
    (   How == shared,
        v(1, V, X, Y, Z)
    ->  V1 = V0
    ;   V = V0,
        assert_fact(v(1, V, X, Y, Z)),
        V1 is V0+1
    ).

edge(A, B, E, E, E1) :-
    assert_fact(e(1, E, A, B, 1)),
    E1 is E+1.

% A strip of length 3 with three squares along one side, points 1, 2, 4, 9 of
% figure 5, and one that reaches over its end on the other side.
figure5([ [0-0-0, 3-0-0, 3-1-0, 0-1-0],
          [1-0-0, 0-0-0, 0-0-1, 1-0-1],
          [2-0-0, 1-0-0, 1-0-1, 2-0-1],
          [3-0-0, 2-0-0, 2-0-1, 3-0-1],
          [1-1-0, 4-1-0, 4-1-1, 1-1-1] ]).

partners(Pairs) :-
    findall(P-Q,
            ( p(1, P, Es), member(E, Es), e(1, E, A, B, _),
              e(1, F, B, A, _), edge_polygon(1, F, Q), P @< Q ),
            Pairs0),
    msort(Pairs0, Pairs).

closed_polygons :-
    forall(p(1, P, Es),
           ( findall(A, ( member(E, Es), e(1, E, A, _, _) ), As0),
             findall(B, ( member(E, Es), e(1, E, _, B, _) ), Bs0),
             msort(As0, Vs),
             msort(Bs0, Vs),
             once(t(1, P, _, _, _, _)) )).

attached(Changes) :-
    parts_attached(1, 1.0e-6, Changes),
    closed_polygons.

:- begin_tests(part_edges).

test(figure5, Pairs == [1-2,1-3,1-4,1-5,2-3,3-4],
     forall(member(How, [shared,apart]))) :-
    figure5(Polygons),
    with_polygons(How, Polygons, ( attached(_), partners(Pairs) )).
test(before, Pairs == [2-3,3-4]) :-
    figure5(Polygons),
    with_polygons(shared, Polygons, partners(Pairs)).
test(divided, Ns == [2,2,3]) :-
    figure5(Polygons),
    with_polygons(shared, Polygons, attached(changes(_, Divided))),
    findall(N, ( member(_-Es, Divided), length(Es, N) ), Ns0),
    msort(Ns0, Ns).
test(in_order) :-                       % parts run from end to end
    figure5(Polygons),
    with_polygons(shared, Polygons,
                  ( e(1, E, 1, 2, _),
                    parts_attached(1, 1.0e-6, changes(_, Divided)),
                    memberchk(E-[E1,E2,E3], Divided),
                    e(1, E1, 1, A, _), e(1, E2, A, B, _), e(1, E3, B, 2, _) )).
test(nothing, Changes == changes([], [])) :-
    new_world(World),
    in_world(World,
             ( add_primitive(box(size(1, 1, 1)), _), complete_segments,
               parts_attached(1, 1.0e-6, Changes) )).
test(nothing_to_attach, Changes == changes([], [])) :-
    with_polygons(shared, [[0-0-0, 1-0-0, 1-1-0, 0-1-0]],
                  parts_attached(1, 1.0e-6, Changes)).
test(within_tolerance, Pairs == [1-2,1-3]) :-
    with_polygons(shared,
                  [ [0-0-0, 2-0-0, 2-1-0, 0-1-0],
                    [1-1.0e-7-0, 0-0-0, 0.5-0-1],
                    [2-0-0, 1-1.0e-7-0, 1.5-0-1] ],
                  ( attached(_), partners(Pairs) )).
test(farther, Pairs == []) :-
    with_polygons(shared,
                  [ [0-0-0, 2-0-0, 2-1-0, 0-1-0],
                    [1-1.0e-3-0, 0-0-0, 0.5-0-1],
                    [2-0-0, 1-1.0e-3-0, 1.5-0-1] ],
                  ( attached(_), partners(Pairs) )).
test(length_whose_square_is_0, Ls == [3.0e-200,4.0e-200,5.0e-200]) :-
    new_world(World),
    in_world(World,
             ( assert_fact(segment(1, surface, raw)),
               polygon(shared, [0-0-0, 3.0e-200-0-0, 0-4.0e-200-0], 1-1-1, _),
               findall(L, ( e(1, E, _, _, _), edge_length(1, E, L) ), Ls0),
               msort(Ls0, Ls) )).
test(world_only_in_snapshot, Before == After) :-
    figure5(Polygons),
    with_polygons(apart, Polygons,
                  ( findall(P-Es, p(1, P, Es), Before),
                    facts_snapshot(attached(_)),
                    findall(P-Es, p(1, P, Es), After) )).

% A wall of bricks, each course half a brick on: every brick meets two above.
test(bricks, N == M) :-
    numlist(0, 9, Js),
    findall([X0-0-J, X1-0-J, X1-0-J1, X0-0-J1],
            ( member(J, Js), between(0, 9, I),
              X0 is 2*I + J mod 2, X1 is X0+2, J1 is J+1 ),
            Polygons),
    with_polygons(apart, Polygons, ( attached(_), partners(Pairs) )),
    length(Pairs, N),
    M is 10*9 + 9*19.

% The borders of a segment are what the census of the world says of them.

test(borders, [ forall(member(How, [apart, shared])), Borders == Defects ]) :-
    figure5(Polygons),
    with_polygons(How, Polygons,
                  ( assert_fact(segment(2, surface, raw)),
                    forall(nth1(V, [0-0-9,1-0-9,0-1-9], X-Y-Z),
                           assert_fact(v(2, V, X, Y, Z))),
                    forall(member(A-B, [1-2,2-3,3-1]),
                           assert_fact(e(2, A, A, B, 1))),
                    assert_fact(p(2, 1, [1,2,3])),
                    complete_segments,
                    findall(S-E, ( member(S, [1,2,3]),
                                   segment_borders(S, Es),
                                   member(E, Es) ),
                            Borders),
                    findall(S-E, census_defect(border_edge, S, E, _), Defects0),
                    sort(Defects0, Defects) )),
    memberchk(1-_, Borders),
    memberchk(2-_, Borders).

:- end_tests(part_edges).
