:- module(sg_test_cone,
          [ cone_made/2                 % +S, +Cone
          ]).
/** <module> Cones for tests: what a vertex sees, with the origin as vertex 1.

    faces(Points)    triangles from the origin to each two points in turn;
                     what is to the right of them, seen from outside, is behind
    arcs(Pairs)      triangles from the origin to A and B, of A-B
    wire(Point)
*/
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(store)).

%!  cone_made(+S, +Cone) is det.

cone_made(S, faces([Point|Points])) :-
    append(Points, [Point], Next),
    pairs([Point|Points], Next, Pairs),
    cone_made(S, arcs(Pairs)).
cone_made(S, arcs(Pairs)) :-
    assert_fact(segment(S, surface, cone)),
    findall(P, ( member(A-B, Pairs), member(P, [A,B]) ), Points0),
    sort(Points0, Points),
    points_made(S, [[0,0,0]|Points]),
    foldl(triangle_made(S, [[0,0,0]|Points]), Pairs, 1, _).
cone_made(S, wire(Point)) :-
    assert_fact(segment(S, curve, cone)),
    points_made(S, [[0,0,0],Point]),
    assert_fact(e(S, 1, 1, 2, 1)).

pairs([], [], []).
pairs([A|As], [B|Bs], [A-B|Pairs]) :-
    pairs(As, Bs, Pairs).

points_made(S, Points) :-
    forall(nth1(V, Points, Point),
           ( maplist(coordinate, Point, [X,Y,Z]),
             assert_fact(v(S, V, X, Y, Z)) )).

coordinate(X0, X) :-
    X is float(X0)+0.0.

triangle_made(S, Points, A-B, P, P1) :-
    nth1(V, Points, A),
    nth1(W, Points, B),
    !,
    E is 3*P,
    E1 is E+1,
    E2 is E+2,
    assert_fact(e(S, E, 1, V, 1)),
    assert_fact(e(S, E1, V, W, 1)),
    assert_fact(e(S, E2, W, 1, 1)),
    assert_fact(p(S, P, [E,E1,E2])),
    P1 is P+1.
