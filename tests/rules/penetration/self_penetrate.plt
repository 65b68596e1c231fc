:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(command/check)).
:- use_module(rules(exact)).
:- use_module(rules(model/integrity)).

:- use_module(rules(kernel), [segment_meets_itself/1]).
:- use_module(rules(model/mesh)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests('rules/shells')).
:- use_module(tests('rules/sample')).

/* Segments that are cut by themselves. The oracle: the same shells as segments
   of their own have the same lines. */

%   lines(-Lines): all pieces and contacts by their places, exactly; the ends of
%   each in order. A contact where two shells touch at a piece of others is
%   alone only as long as they are segments: it does not count.

lines(Lines) :-
    findall(Line,
            ( line(_, S, _, A, B, _, _, _, _),
              vertex_exact(S, A, X1, Y1, Z1),
              vertex_exact(S, B, X2, Y2, Z2),
              msort([p(X1,Y1,Z1),p(X2,Y2,Z2)], Line) ),
            Lines0),
    msort(Lines0, Lines1),
    exclude(at_an_end(Lines1), Lines1, Lines).

at_an_end(Lines, [P,P]) :-
    member([A,B], Lines),
    A \== B,
    ( P == A ; P == B ),
    !.

%   Every pair of segments, and nothing made to touch.

separate(Primitives, Lines) :-
    shells(Primitives,
           ( findall(S1-S2,
                     ( segment(S1, _, _), segment(S2, _, _), S1 < S2 ),
                     Pairs),
             penetrate(Pairs, [tolerance(0)]),
             lines(Lines) )).

together(Primitives, Lines, Faults) :-
    one_segment(Primitives,
                ( penetrate([1-1]),
                  lines(Lines),
                  findall(F, limit(5, fault(F)), Faults) )).

same_lines(Primitives) :-
    separate(Primitives, Lines),
    together(Primitives, Lines2, Faults),
    Lines == Lines2,
    Faults == [].

/* - - - what must hold of a segment that was cut by itself - - - */

fault(unbalanced(A, B)) :-
    findall(A-B, ( p(1, _, Es), member(E, Es), e(1, E, A, B, _) ), Edges),
    sort(Edges, Each),
    member(A-B, Each),
    aggregate_all(count, member(A-B, Edges), N),
    aggregate_all(count, member(B-A, Edges), M),
    N =\= M.
fault(line(L, S, P)) :-
    line(L, S1, P1, A1, B1, S2, P2, A2, B2),
    A1 \== B1,
    member(S-P-A-B, [S1-P1-A1-B1,S2-P2-A2-B2]),
    \+ polygon_edge(S, P, A, B).
fault(ends(L)) :-
    line(L, S1, _, A1, B1, S2, _, A2, B2),
    \+ ( vertex_exact(S1, A1, X, Y, Z), vertex_exact(S2, A2, X, Y, Z),
         vertex_exact(S1, B1, U, V, W), vertex_exact(S2, B2, U, V, W) ).
fault(one_polygon(L)) :-
    line(L, S, P, _, _, S, P, _, _).
fault(area(P, Area, Sum)) :-
    p(1, P, Es),
    findall(C, ( member(E, Es), e(1, E, A, B, _), cross(A, B, C) ), Cs),
    vector_sum(Cs, Area),
    findall(C, ( t(1, P, _, V1, V2, V3),
                 member(A-B, [V1-V2,V2-V3,V3-V1]),
                 cross(A, B, C) ), Ts),
    vector_sum(Ts, Sum),
    \+ near(Area, Sum).
fault(still_through(P1, P2)) :-
    model_defect(self_penetration(1, P1, P2)).

polygon_edge(S, P, A, B) :-
    p(S, P, Es),
    member(E, Es),
    ( e(S, E, A, B, _) ; e(S, E, B, A, _) ),
    !.

cross(A, B, v(X,Y,Z)) :-
    v(1, A, X1, Y1, Z1),
    v(1, B, X2, Y2, Z2),
    X is Y1*Z2-Z1*Y2,
    Y is Z1*X2-X1*Z2,
    Z is X1*Y2-Y1*X2.

vector_sum(Vs, v(X,Y,Z)) :-
    aggregate_all(sum(A), member(v(A,_,_), Vs), X),
    aggregate_all(sum(A), member(v(_,A,_), Vs), Y),
    aggregate_all(sum(A), member(v(_,_,A), Vs), Z).

near(v(X1,Y1,Z1), v(X2,Y2,Z2)) :-
    abs(X1-X2) =< 1.0e-9,
    abs(Y1-Y2) =< 1.0e-9,
    abs(Z1-Z2) =< 1.0e-9.

box(A, B, C, X, Y, Z, at([translate(X,Y,Z)], box(size(A,B,C)))).

random_box(at([translate(X,Y,Z)], box(size(A,B,C)))) :-
    maplist([N]>>random_between(1, 3, N), [A,B,C]),
    maplist([N]>>random_between(0, 3, N), [X,Y,Z]).

%   A turned box has no coordinate in common with another.

turned_box(at([rotate(x,U), rotate(z,V), translate(X,Y,Z)],
              box(size(A,B,C)))) :-
    maplist([N]>>random_between(1, 3, N), [A,B,C]),
    maplist([N]>>( N is 3*random_float ), [X,Y,Z]),
    U is 360*random_float,
    V is 360*random_float.

random_shells(Seed, Make, Shells) :-
    set_random(seed(Seed)),
    random_between(2, 4, N),
    length(Shells, N),
    maplist(Make, Shells).

:- begin_tests(self_penetrate).

test(corner_in) :-
    box(2,2,2, 1,1,1, B),
    same_lines([box(size(2,2,2)), B]).
test(apart) :-
    box(2,2,2, 5,1,1, B),
    same_lines([box(size(2,2,2)), B]).
test(bar_through) :-
    box(1,1,4, 0,0,-1, B),
    same_lines([box(size(2,2,2)), B]).
test(standing_on) :-
    box(1,1,1, 0,0,2, B),
    same_lines([box(size(2,2,2)), B]).
test(shared_face) :-
    box(2,2,2, 2,0,0, B),
    same_lines([box(size(2,2,2)), B]).
test(shared_edge) :-
    box(2,2,2, 2,2,0, B),
    same_lines([box(size(2,2,2)), B]).
test(shared_vertex) :-
    box(2,2,2, 2,2,2, B),
    same_lines([box(size(2,2,2)), B]).
test(copy) :-
    same_lines([box(size(2,2,2)), box(size(2,2,2))]).
test(three_boxes_cross) :-
    same_lines([box(size(6,2,2)), box(size(2,6,2)), box(size(2,2,6))]).
test(three_planes) :-
    box(2,2,2, 1,0.5,0.25, B),
    box(2,2,2, 0.5,1,0.75, C),
    same_lines([box(size(2,2,2)), B, C]).

test(random_boxes, Bad == []) :-
    findall(Seed,
            ( numbered(20, 60, Seed),
              random_shells(Seed, random_box, Shells),
              \+ same_lines(Shells) ),
            Bad).
test(random_turned_boxes, Bad == []) :-
    findall(Seed,
            ( numbered(15, 40, Seed),
              random_shells(Seed, turned_box, Shells),
              \+ same_lines(Shells) ),
            Bad).

%   The shells of segment 1 and one more segment: all pairs at once, also in two
%   steps, are as with all shells apart.

test(with_another_segment, Bad == []) :-
    findall(Seed-Steps,
            ( between(101, 130, Seed),
              random_shells(Seed, random_box, Shells),
              random_box(Other),
              append(Shells, [Other], All),
              separate(All, Lines),
              member(Steps, [[[1-1,1-2]], [[1-1],[1-2]], [[1-2],[1-1]]]),
              \+ with_other(Shells, Other, Steps, Lines) ),
            Bad).

with_other(Shells, Other, Steps, Lines) :-
    one_segment(Shells,
                ( add_primitive(Other, 2),
                  complete_segments,
                  forall(member(Pairs, Steps),
                         penetrate(Pairs, [tolerance(0)])),
                  lines(Lines2),
                  findall(F, limit(1, fault(F)), Faults) )),
    Lines == Lines2,
    Faults == [].

test(not_by_default, Ls == []) :-
    box(2,2,2, 1,1,1, B),
    one_segment([box(size(2,2,2)), B],
                ( penetrate, findall(L, line(L,_,_,_,_,_,_,_,_), Ls) )).
test(chains, Kinds-Sorted == [closed]-true) :-
    box(2,2,2, 1,1,1, B),
    one_segment([box(size(2,2,2)), B],
                penetration_chains([1-1], [], Chains)),
    findall(K, member(chain(1,1,K,_,_), Chains), Kinds),
    Chains = [chain(_, _, _, Points, _)],
    (   length(Points, 7)
    ->  Sorted = true
    ;   Sorted = Points
    ).
test(undone_by_a_snapshot, N == 0) :-
    box(2,2,2, 1,1,1, B),
    one_segment([box(size(2,2,2)), B],
                ( facts_snapshot(penetrate([1-1])),
                  aggregate_all(count, line(_,_,_,_,_,_,_,_,_), N) )).

%   Neighbours have nothing to cut but what goes beyond what they share.

test(fold, N == 0) :-
    one_segment([box(size(1,2,3)),
                 at([translate(5,0,0)], sphere(radius(1), facets(12)))],
                ( penetrate([1-1]),
                  aggregate_all(count, line(_,_,_,_,_,_,_,_,_), N) )).
test(through_a_neighbour, Ends == [p(0,0,0)-p(2,1,0)]) :-
    triangles([0-0-0, 4-0-0, 0-4-0, 2-1-(-1), 2-1-1], [[1,2,3], [1,4,5]],
              Ends).
test(folded_over, Ends == [p(0,0,0)-p(1,1,0), p(1,1,0)-p(4,0,0)]) :-
    triangles([0-0-0, 4-0-0, 0-4-0, 1-1-0], [[1,2,3], [2,1,4]], Ends).
test(folded_at_a_corner,
     Ends == [p(0,0,0)-p(1,2,0), p(0,0,0)-p(2,1,0), p(1,2,0)-p(2,1,0)]) :-
    triangles([0-0-0, 4-0-0, 0-4-0, 2-1-0, 1-2-0], [[1,2,3], [1,4,5]], Ends).
test(one_face_twice, Ends == []) :-
    triangles([0-0-0, 4-0-0, 0-4-0], [[1,2,3], [1,2,3]], Ends).

triangles(Points, Faces, Ends) :-
    new_world(World),
    in_world(World,
             ( assert_fact(segment(1, surface, soup)),
               forall(nth1(V, Points, X-Y-Z), assert_fact(v(1, V, X, Y, Z))),
               foldl(triangle, Faces, 1-1, _),
               complete_segments,
               penetrate([1-1]),
               lines(Lines) )),
    findall(A-B, member([A,B], Lines), Ends0),
    msort(Ends0, Ends).

triangle([A,B,C], P-E, P1-E3) :-
    E1 is E+1,
    E2 is E+2,
    E3 is E+3,
    assert_fact(e(1, E, A, B, 1)),
    assert_fact(e(1, E1, B, C, 1)),
    assert_fact(e(1, E2, C, A, 1)),
    assert_fact(p(1, P, [E,E1,E2])),
    P1 is P+1.

%   Whether a segment goes through itself: as the report says.

test(meets_itself, Meets == [apart,apart,crossing,lying,touching_edge]) :-
    box(2,2,2, 5,0,0, Apart),
    box(2,2,2, 1,1,1, Crossing),
    box(2,2,2, 1,0,2, Lying),
    box(2,2,2, 2,2,0, Edge),
    box(2,2,2, 2,2,2, Vertex),
    findall(What,
            ( member(What-B, [apart-Apart,apart-Vertex,crossing-Crossing,
                              lying-Lying,touching_edge-Edge]),
              one_segment([box(size(2,2,2)), B],
                          ( segment_meets_itself(1) -> M = true ; M = false )),
              ( What == apart -> M == false ; M == true ) ),
            Meets).

:- end_tests(self_penetrate).
