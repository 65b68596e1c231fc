:- module(test_oracle_triangles, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(random)).
:- use_module(library(solution_sequences)).
:- use_module(rules(store)).
:- use_module(rules(kernel)).
:- use_module(rules(penetration/penetration)).
:- use_module(tests('rules/penetration/oracle')).
:- use_module(tests('oracle/cut')).
:- use_module(tests('rules/sample')).

/* Two triangles with corners on a small grid: the engine and the oracle see
the same pieces, their ends in the same features. The classes that occurred are
counted, and each must occur. ORACLE_PAIRS=N makes N pairs (default 12000, or
30000),
ORACLE_SEED=N other ones. */

pairs(N) :-
    few(12000, 30000, Few),
    from_environment('ORACLE_PAIRS', Few, N).

seed(Seed) :-
    from_environment('ORACLE_SEED', 19880301, Seed).

from_environment(Name, Default, N) :-
    (   getenv(Name, Text)
    ->  atom_number(Text, N)
    ;   N = Default
    ).

/* - - - sampling - - - */

%   random_pair(-How, -T1, -T2): both anywhere; with common corners; in one
%   plane; the second with corners on the first; or one of them without area.

random_pair(How, T1, T2) :-
    random_member(How, [any, any, any, corners, corners, plane, plane, plane,
                        on, on, on, on, flat]),
    random_member(N, [2,2,3,4]),
    random_pair(How, N, T1, T2).

random_pair(any, N, T1, T2) :-
    random_triangle(N, T1),
    random_triangle(N, T2).
random_pair(corners, N, T1, T2) :-
    random_triangle(N, T1),
    T1 = tri(A,B,_),
    random_point(N, Q),
    random_point(N, R),
    random_member(Corners, [[A,Q,R], [A,B,R], [B,A,R]]),
    random_permutation(Corners, [X,Y,Z]),
    T2 = tri(X,Y,Z).
random_pair(plane, N, T1, T2) :-
    random_between(-1, 1, A),
    random_between(-1, 1, B),
    M is N+2,
    length(Ps, 6),
    maplist(in_plane(A, B, M), Ps),
    random_permutation([1,2,3], Axes),
    maplist(turned(Axes), Ps, [P1,P2,P3,P4,P5,P6]),
    T1 = tri(P1,P2,P3),
    T2 = tri(P4,P5,P6).
random_pair(on, N, T1, T2) :-
    random_triangle(N, T0),
    grown_triangle(T0, T1),
    M is 6*N,
    maplist(corner_on(M, T1), [P,Q,R]),
    T2 = tri(P,Q,R).
random_pair(flat, N, T1, T2) :-
    random_triangle(N, T0),
    grown_triangle(T0, T3),
    M is 6*N,
    maplist(corner_on(M, T3), [P,Q]),
    middle(P, Q, R),
    random_member(T4, [tri(P,Q,R), tri(P,Q,Q), tri(P,P,P)]),
    random_member(T1-T2, [T3-T4,T4-T3]).

random_triangle(N, tri(A,B,C)) :-
    maplist(random_point(N), [A,B,C]).

random_point(N, p(X,Y,Z)) :-
    maplist(random_between(0, N), [X,Y,Z]).

in_plane(A, B, N, p(X,Y,Z)) :-
    random_between(0, N, X),
    random_between(0, N, Y),
    Z is A*X+B*Y.

turned([I,J,K], P, p(X,Y,Z)) :-
    arg(I, P, X),
    arg(J, P, Y),
    arg(K, P, Z).

%   Six times as large: middles are on the grid then.

grown_triangle(tri(A0,B0,C0), tri(A,B,C)) :-
    maplist(grown, [A0,B0,C0], [A,B,C]).

grown(p(X0,Y0,Z0), p(X,Y,Z)) :-
    X is 6*X0,
    Y is 6*Y0,
    Z is 6*Z0.

middle(p(X1,Y1,Z1), p(X2,Y2,Z2), p(X,Y,Z)) :-
    X is (X1+X2)//2,
    Y is (Y1+Y2)//2,
    Z is (Z1+Z2)//2.

middle(p(X1,Y1,Z1), p(X2,Y2,Z2), p(X3,Y3,Z3), p(X,Y,Z)) :-
    X is (X1+X2+X3)//3,
    Y is (Y1+Y2+Y3)//3,
    Z is (Z1+Z2+Z3)//3.

%   A corner of the triangle, the middle of an edge, its own, or anywhere.

corner_on(M, tri(A,B,C), P) :-
    random_member(How, [corner,edge,face,any]),
    corner_on(How, M, A, B, C, P).

corner_on(corner, _, A, B, C, P) :-
    random_member(P, [A,B,C]).
corner_on(edge, _, A, B, C, P) :-
    random_member(Q-R, [A-B,B-C,C-A]),
    middle(Q, R, P).
corner_on(face, _, A, B, C, P) :-
    middle(A, B, C, P).
corner_on(any, M, _, _, _, P) :-
    random_point(M, P).

/* - - - the engine's answer - - - */

%   In batches of 500, each in one world: pair I is segments 2I-1 and 2I.

batch(500).

%   pairs_cuts(+Pairs, -Cuts): for every pair, numbered from 1, the list of
%   I-cut(Kind, End1, End2).

pairs_cuts(Pairs, Cuts) :-
    new_world(World),
    in_world(World,
             ( foldl(add_pair, Pairs, 1, _),
               length(Pairs, N),
               findall(S1-S2,
                       ( between(1, N, I), S1 is 2*I-1, S2 is 2*I ),
                       Ss),
               setup_call_cleanup(
                   cut_set_open(Ss, Set),
                   findall(I-Cut, pair_cut(Set, I, Cut), Cuts),
                   cut_set_close(Set)) )).

add_pair(pair(_, T1, T2), I, I1) :-
    I1 is I+1,
    S1 is 2*I-1,
    S2 is 2*I,
    add_triangle(S1, T1),
    add_triangle(S2, T2).

add_triangle(S, tri(A,B,C)) :-
    assert_fact(segment(S, surface, triangle)),
    forall(nth1(V, [A,B,C], p(X0,Y0,Z0)),
           ( X is float(X0), Y is float(Y0), Z is float(Z0),
             assert_fact(v(S, V, X, Y, Z)) )),
    forall(nth1(E, [1-2,2-3,3-1], V-W), assert_fact(e(S, E, V, W, 1))),
    assert_fact(p(S, 1, [1,2,3])),
    assert_fact(t(S, 1, 1, 1, 2, 3)).

pair_cut(Set, I, Cut) :-
    cut_candidate(Set, L1, L2),
    cut_triangle(Set, L1, S1, _, _),
    I is (S1+1)//2,
    cut_ends(Set, L1, L2, Cuts),
    member(Cut, Cuts).

%   What the engine says, in the oracle's words.

engine_answer(Cuts, Kind, Ends) :-
    (   Cuts == []
    ->  Kind = none,
        Ends = []
    ;   Cuts = [cut(Kind,_,_)|_],
        maplist(cut_ends(Kind), Cuts, Ends0),
        sort(Ends0, Ends)
    ).

cut_ends(Kind, cut(Kind,A,B), E-F) :-
    ends(A, C),
    ends(B, D),
    msort([C,D], [E,F]).

ends(F-G, C-D) :-
    corners(F, C),
    corners(G, D).

corners(vertex(V), [V]).
corners(edge(V,W), [V,W]).
corners(face(_), [1,2,3]).

/* - - - classes - - - */

%   class(?Class): one that must occur.

class(crossing(segment)).
class(crossing(point)).
class(end(Pair)) :-
    member(Pair, [vv,ve,ee,vf,ef]).
class(point(Pair)) :-
    member(Pair, [vv,ve,ee,vf]).
class(along(How)) :-
    member(How, [edge-face,edge-edge]).
class(coplanar(corners(N))) :-
    between(3, 6, N).
class(coplanar(same)).
class(coplanar(edge)).
class(coplanar(point(Pair))) :-
    member(Pair, [vv,ve]).
class(coplanar_apart).
class(no_area(How)) :-
    member(How, [point,segment]).
class(apart).

%   pair_class(+T1, +T2, +Kind, +Pieces, +Ends, -Class): nondet, also of
%   classes that need not occur.

pair_class(T1, T2, _, _, _, no_area(How)) :-
    member(tri(A,B,C), [T1,T2]),
    on_a_line(A, B, C),
    (   A == B, B == C
    ->  How = point
    ;   How = segment
    ).
pair_class(T1, T2, none, _, _, Class) :-
    T1 = tri(A,B,C),
    \+ on_a_line(A, B, C),
    T2 = tri(D,E,F),
    \+ on_a_line(D, E, F),
    (   maplist(on_plane(T1), [D,E,F])
    ->  Class = coplanar_apart
    ;   Class = apart
    ).
pair_class(_, _, crossing, [P-Q], _, crossing(What)) :-
    (   P == Q
    ->  What = point
    ;   What = segment
    ).
pair_class(_, _, crossing, [P-Q], [E1-E2], Class) :-
    (   P == Q
    ->  features(E1, Pair),
        Class = point(Pair)
    ;   member(E, [E1,E2]),
        features(E, Pair),
        Class = end(Pair)
    ).
pair_class(_, _, crossing, [P-Q], [(F1-G1)-(F2-G2)], along(How)) :-
    P \== Q,
    along(F1, F2, A),
    along(G1, G2, B),
    msort([A,B], [C,D]),
    C-D \== face-face,
    How = C-D.
pair_class(T1, T2, coplanar, Pieces, Ends, coplanar(What)) :-
    pairs_keys_values(Pieces, Ps, Qs),
    append(Ps, Qs, Points0),
    sort(Points0, Points),
    length(Points, N),
    length(Pieces, M),
    (   N =:= 1
    ->  Ends = [End-_],
        features(End, Pair),
        What = point(Pair)
    ;   M =:= 1
    ->  What = edge
    ;   T1 =.. [_|Cs1],
        T2 =.. [_|Cs2],
        msort(Cs1, Cs),
        msort(Cs2, Cs)
    ->  What = same
    ;   What = corners(N)
    ).

features(F-G, Pair) :-
    length(F, N),
    length(G, M),
    msort([N,M], [K,L]),
    nth1(K, [v,e,f], A),
    nth1(L, [v,e,f], B),
    atom_concat(A, B, Pair).

along(F, G, How) :-
    union(F, G, H),
    (   length(H, 2)
    ->  How = edge
    ;   How = face
    ).

on_a_line(A, B, C) :-
    \+ triangle_has_area(tri(A,B,C)).

triangle_has_area(T) :-
    vector_area_of(T, N),
    N \== v(0,0,0).

vector_area_of(tri(A,B,C), N) :-
    vector_area([A-B,B-C,C-A], N).

on_plane(tri(A,B,C), D) :-
    vector_area_of(tri(A,B,C), v(X,Y,Z)),
    A = p(Xa,Ya,Za),
    D = p(Xd,Yd,Zd),
    0 =:= X*(Xd-Xa)+Y*(Yd-Ya)+Z*(Zd-Za).

/* - - - the comparison - - - */

:- dynamic count/2.

begin :-
    seed(Seed),
    set_random(seed(Seed)),
    retractall(count(_, _)).

counted(Class) :-
    (   retract(count(Class, N0))
    ->  true
    ;   N0 = 0
    ),
    N is N0+1,
    assertz(count(Class, N)).

%   disagreement(+N, -Pair): one of N sampled pairs; counts the classes.

disagreement(N, Bad) :-
    batch(Size),
    Batches is (N+Size-1)//Size,
    between(1, Batches, _),
    findall(pair(How, T1, T2),
            ( between(1, Size, _), random_pair(How, T1, T2) ),
            Pairs),
    pairs_cuts(Pairs, Cuts0),
    keysort(Cuts0, Cuts),
    pairs_disagreement(Pairs, 1, Cuts, Bad).

pairs_disagreement([Pair|Pairs], I, Cuts, Bad) :-
    own_cuts(Cuts, I, Own, Rest),
    (   pair_disagrees(Pair, Own, Bad)
    ;   I1 is I+1,
        pairs_disagreement(Pairs, I1, Rest, Bad)
    ).

own_cuts([I-Cut|Cuts], I, [Cut|Own], Rest) :-
    !,
    own_cuts(Cuts, I, Own, Rest).
own_cuts(Rest, _, [], Rest).

pair_disagrees(pair(How, T1, T2), Cuts, Bad) :-
    triangles_common(T1, T2, Kind, Pieces),
    pieces_ends(T1, T2, Pieces, Ends),
    forall(distinct_class(T1, T2, Kind, Pieces, Ends, Class),
           counted(Class)),
    engine_answer(Cuts, EngineKind, EngineEnds),
    EngineKind-EngineEnds \== Kind-Ends,
    Bad = bad(How, T1, T2, oracle(Kind, Ends),
              engine(EngineKind, EngineEnds)).

distinct_class(T1, T2, Kind, Pieces, Ends, Class) :-
    findall(Class, pair_class(T1, T2, Kind, Pieces, Ends, Class), Classes0),
    sort(Classes0, Classes),
    member(Class, Classes).

%   One line, which tests/run shows.

print_counts(N) :-
    findall(Class-M, count(Class, M), Counts0),
    msort(Counts0, Counts),
    format("~ncounted: ~d pairs:", [N]),
    forall(member(Class-M, Counts), format(" ~w ~d", [Class, M])),
    nl.

:- begin_tests(oracle_triangles,
               [ setup(begin) ]).

test(agree, Bad == []) :-
    pairs(N),
    findall(B, limit(3, disagreement(N, B)), Bad),
    print_counts(N).
test(all_classes, Missing == []) :-
    findall(Class, ( class(Class), \+ count(Class, _) ), Missing).

% The same by the public predicate, a world for each pair.
test(triangle_cut, Bad == []) :-
    findall(T1-T2,
            ( numbered(100, 300, _),
              random_pair(_, T1, T2),
              public_cuts(T1, T2, Cuts),
              engine_answer(Cuts, Kind, Ends),
              triangles_common(T1, T2, OracleKind, Pieces),
              pieces_ends(T1, T2, Pieces, OracleEnds),
              Kind-Ends \== OracleKind-OracleEnds ),
            Bad).

public_cuts(T1, T2, Cuts) :-
    new_world(World),
    in_world(World,
             ( add_triangle(1, T1),
               add_triangle(2, T2),
               findall(cut(K, A, B), triangle_cut(1-1, 2-1, K, A, B), Cuts)
             )).

% A curve is divided where it meets the face or comes to the border (PL-7).
test(curves, Bad == []) :-
    findall(U-W-T,
            ( between(1, 1500, _),
              random_pair(_, T, tri(U,W,_)),
              U \== W,
              curve_points(U, W, T, Points),
              ( segment_common(U-W, T, P-Q) -> Ends = [P,Q] ; Ends = [] ),
              sort(Ends, Expected0),
              subtract(Expected0, [U,W], Expected),
              Points \== Expected ),
            Bad).

curve_points(U, W, T, Points) :-
    new_world(World),
    in_world(World,
             ( add_triangle(1, T),
               assert_fact(segment(2, curve, line)),
               forall(nth1(V, [U,W], p(X0,Y0,Z0)),
                      ( X is float(X0), Y is float(Y0), Z is float(Z0),
                        assert_fact(v(2, V, X, Y, Z)) )),
               assert_fact(e(2, 1, 1, 2, 1)),
               penetrate(all, [tolerance(0)]),
               findall(P, ( origin(2, v(V), _), exact_vertex(2, V, P) ),
                       Points0),
               msort(Points0, Points) )).

% The oracle itself, by hand.
test(oracle_crossing, Kind-Pieces == crossing-[p(0,0,0)-p(1r2,0,0)]) :-
    triangles_common(tri(p(0,0,0), p(2,0,0), p(0,2,0)),
                     tri(p(-1,0,-1), p(-1,0,1), p(1r2,0,0)), Kind, Pieces).
test(oracle_star, N == 6) :-
    triangles_common(tri(p(0,0,0), p(6,0,0), p(3,6,0)),
                     tri(p(0,4,0), p(3,-2,0), p(6,4,0)), coplanar, Pieces),
    length(Pieces, N).
test(oracle_no_area, Kind == none) :-
    triangles_common(tri(p(0,0,0), p(2,0,0), p(4,0,0)),
                     tri(p(0,0,0), p(2,0,0), p(0,2,0)), Kind, _).

:- end_tests(oracle_triangles).
