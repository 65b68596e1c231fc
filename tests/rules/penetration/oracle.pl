:- module(sg_test_oracle,
          [ triangles_common/4,         % +T1, +T2, -Kind, -Pieces
            segment_common/3,           % +Segment, +T, -Piece
            pieces_ends/4,              % +T1, +T2, +Pieces, -Ends
            piece_ends/4,               % +T1, +T2, +Piece, -End-End
            leaves/2,                   % +S, -Leaves
            common_lines/3,             % +Leaves1, +Leaves2, -Lines
            common_points/3,            % +Leaves1, +Leaves2, -Points
            runs/2,                     % +Pieces, -Runs
            directed_runs/2,            % +Pieces, -Runs
            run_point/3,                % +Runs, +Point, -How
            exact_vertex/3,             % +S, +V, -Point
            origin_point/2,             % +Origin, -Point
            vertex_point/3,             % +S, +V, -Point
            vector_area/2               % +Edges, -Vector
          ]).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(rules(store)).

/** <module> The oracle: penetration by rational arithmetic, quadratic.

What two triangles, and two segments, have in common, said as plainly as it can
be and sharing nothing with the kernels: every coordinate is a rational, a
triangle is the intersection of five half-spaces, and everything is found by
clipping segments with them.

A point is p(X,Y,Z), a triangle tri(A,B,C) of points. A piece is P-Q, two
points, P before Q in standard order (which for rationals is their order), or
the same one. Never use `/` here: it rounds; rdiv does not.
*/

:- set_prolog_flag(optimise, true).

/* - - - vectors - - - */

minus(p(X1,Y1,Z1), p(X2,Y2,Z2), v(X,Y,Z)) :-
    X is X1-X2,
    Y is Y1-Y2,
    Z is Z1-Z2.

cross(v(X1,Y1,Z1), v(X2,Y2,Z2), v(X,Y,Z)) :-
    X is Y1*Z2-Z1*Y2,
    Y is Z1*X2-X1*Z2,
    Z is X1*Y2-Y1*X2.

%   go(+P, +Q, +T, -R): R is T of the way from P to Q.

go(P, _, 0, P) :-
    !.
go(_, Q, 1, Q) :-
    !.
go(p(X1,Y1,Z1), p(X2,Y2,Z2), T, p(X,Y,Z)) :-
    X is X1+T*(X2-X1),
    Y is Y1+T*(Y2-Y1),
    Z is Z1+T*(Z2-Z1).

/* - - - half-spaces - - - */

%   A half-space h(A,B,C,D) holds the points with A*X+B*Y+C*Z+D >= 0.

%   spaces(+Triangle, -Spaces): a triangle with area is what the five
%   half-spaces space(Plane, Back, [In1,In2,In3]) have in common; In1 is
%   bounded by the edge from the first corner to the second, and so on. Fails
%   if there is no area.

spaces(tri(A,B,C), spaces(Plane, Back, [H1,H2,H3])) :-
    minus(B, A, U),
    minus(C, A, W),
    cross(U, W, N),
    N \== v(0,0,0),
    half_space(N, A, Plane),
    opposite(Plane, Back),
    inner(N, A, B, H1),
    inner(N, B, C, H2),
    inner(N, C, A, H3).

opposite(h(A0,B0,C0,D0), h(A,B,C,D)) :-
    A is -A0,
    B is -B0,
    C is -C0,
    D is -D0.

half_space(v(A,B,C), p(X,Y,Z), h(A,B,C,D)) :-
    D is -(A*X+B*Y+C*Z).

inner(N, A, B, H) :-
    minus(B, A, E),
    cross(N, E, In),
    half_space(In, A, H).

value(h(A,B,C,D), p(X,Y,Z), Value) :-
    Value is A*X+B*Y+C*Z+D.

%   part(+U-W, +Spaces, -P-Q): of the segment from U to W, the points from P
%   to Q are in the triangle. Fails if none is.

part(U-W, spaces(Plane, Back, Inner), P-Q) :-
    clip(Plane, U, W, 0, 1, T1, T2),
    clip(Back, U, W, T1, T2, T3, T4),
    clip_all(Inner, U, W, T3, T4, From, To),
    go(U, W, From, P),
    go(U, W, To, Q).

clip_all([], _, _, T1, T2, T1, T2).
clip_all([H|Hs], U, W, T1, T2, From, To) :-
    clip(H, U, W, T1, T2, T3, T4),
    clip_all(Hs, U, W, T3, T4, From, To).

%   Of the part from T1 to T2 on the way from U to W, that from T3 to T4.

clip(H, U, W, T1, T2, T3, T4) :-
    value(H, U, Hu),
    value(H, W, Hw),
    (   Hu >= 0, Hw >= 0
    ->  T3 = T1,
        T4 = T2
    ;   Hu < 0, Hw < 0
    ->  fail
    ;   T is Hu rdiv (Hu-Hw),
        (   Hu < 0
        ->  T3 is max(T, T1),
            T4 = T2
        ;   T3 = T1,
            T4 is min(T, T2)
        ),
        T3 =< T4
    ).

/* - - - two triangles - - - */

%!  triangles_common(+T1, +T2, -Kind, -Pieces) is det.
%
%   What triangles T1 and T2 have in common. Kind is
%
%     - none
%       nothing, or one of them has no area
%     - crossing
%       their planes differ: one piece, maybe a point
%     - coplanar
%       the pieces of the border of each that are in the other; a point only
%       if that is all

triangles_common(T1, T2, Kind, Pieces) :-
    (   spaces(T1, Spaces1),
        spaces(T2, Spaces2)
    ->  common(T1, Spaces1, T2, Spaces2, Kind, Pieces)
    ;   Kind = none,
        Pieces = []
    ).

common(T1, Spaces1, T2, Spaces2, Kind, Pieces) :-
    findall(P-Q,
            (   edge(T1, U-W), part(U-W, Spaces2, P-Q)
            ;   edge(T2, U-W), part(U-W, Spaces1, P-Q)
            ),
            Parts),
    (   Parts == []
    ->  Kind = none,
        Pieces = []
    ;   coplanar(T1, Spaces2)
    ->  Kind = coplanar,
        border_pieces(Parts, Pieces)
    ;   Kind = crossing,
        hull(Parts, Piece),
        Pieces = [Piece]
    ).

edge(tri(A,B,C), Edge) :-
    member(Edge, [A-B,B-C,C-A]).

coplanar(tri(A,B,C), spaces(Plane, _, _)) :-
    value(Plane, A, 0),
    value(Plane, B, 0),
    value(Plane, C, 0).

%   All parts are on one line: from the first point to the last.

hull(Parts, First-Last) :-
    pairs_keys_values(Parts, Ps, Qs),
    append(Ps, Qs, Points0),
    sort(Points0, Points),
    Points = [First|_],
    last(Points, Last).

border_pieces(Parts, Pieces) :-
    maplist(sorted_piece, Parts, Sorted0),
    sort(Sorted0, Sorted),
    exclude(is_point, Sorted, Segments),
    (   Segments == []
    ->  Pieces = Sorted
    ;   Pieces = Segments
    ).

sorted_piece(P-Q, Piece) :-
    (   P @=< Q
    ->  Piece = P-Q
    ;   Piece = Q-P
    ).

is_point(P-P).

%!  segment_common(+U-W, +T, -P-Q) is semidet.
%
%   Of the segment from U to W, the points from P to Q are in triangle T. Fails
%   if there are none, or T has no area.

segment_common(Segment, T, Piece) :-
    spaces(T, Spaces),
    part(Segment, Spaces, Piece).

%!  piece_ends(+T1, +T2, +Piece, -Ends) is det.
%
%   Ends is End1-End2, an end being the simplest pair of features F1-F2 that
%   holds it: a feature of a triangle is the list of the corners (1 to 3) that
%   span it, so that [2] is a vertex, [1,3] an edge and [1,2,3] the face.

piece_ends(T1, T2, P-Q, (Fp1-Fp2)-(Fq1-Fq2)) :-
    spaces(T1, Spaces1),
    spaces(T2, Spaces2),
    feature(Spaces1, P, Fp1),
    feature(Spaces2, P, Fp2),
    feature(Spaces1, Q, Fq1),
    feature(Spaces2, Q, Fq2).

%!  pieces_ends(+T1, +T2, +Pieces, -Ends) is det.
%
%   The ends of all pieces, each as End1-End2 and they themselves in standard
%   order.

pieces_ends(T1, T2, Pieces, Ends) :-
    maplist(piece_ends(T1, T2), Pieces, Ends0),
    maplist(sorted_piece, Ends0, Ends1),
    sort(Ends1, Ends).

%   A point of a triangle is on the edges whose half-spaces end there.

feature(spaces(_, _, Inner), P, F) :-
    maplist(is_on(P), Inner, Ons),
    corners(Ons, F).

is_on(P, H, On) :-
    value(H, P, Value),
    (   Value =:= 0
    ->  On = 1
    ;   On = 0
    ).

corners([0,0,0], [1,2,3]).
corners([1,0,0], [1,2]).
corners([0,1,0], [2,3]).
corners([0,0,1], [1,3]).
corners([1,0,1], [1]).
corners([1,1,0], [2]).
corners([0,1,1], [3]).

/* - - - two segments - - - */

%!  vertex_point(+S, +V, -Point) is det.
%
%   Where the doubles of v/5 are.

vertex_point(S, V, p(X,Y,Z)) :-
    v(S, V, X0, Y0, Z0),
    !,
    X is rational(X0),
    Y is rational(Y0),
    Z is rational(Z0).

%!  leaves(+S, -Leaves) is det.
%
%   The triangles of segment S in the current world that have area:
%   leaf(P, Triangle, Real, Spaces, Box), Real the features that are real
%   edges: edge(Feature, border), or edge(Feature, inside) for one inside a
%   face, which only one other triangle has, the other way round, in the same
%   plane and on its other side.

leaves(S, Leaves) :-
    findall(leaf(P, tri(A,B,C), Real, Spaces, Low-High),
            ( t(S, P, _, V1, V2, V3),
              maplist(vertex_point(S), [V1,V2,V3], [A,B,C]),
              spaces(tri(A,B,C), Spaces),
              findall(edge(F, Where),
                      ( member(F-(V-W-X), [[1,2]-(V1-V2-V3), [2,3]-(V2-V3-V1),
                                           [1,3]-(V3-V1-V2)]),
                        is_real(S, V, W),
                        ( is_inside(S, V, W, X)
                        -> Where = inside
                        ;  Where = border ) ),
                      Real),
              box([A,B,C], Low, High)
            ),
            Leaves).

is_real(S, V, W) :-
    (   e(S, _, V, W, 1)
    ;   e(S, _, W, V, 1)
    ),
    !.

%   is_inside(S, V, W, X): the edge from V to W of the triangle V, W, X.

is_inside(S, V, W, X) :-
    findall(How-U, triangle_at(S, V, W, How, U), Beside),
    msort(Beside, [back-Y, same-X]),
    maplist(vertex_point(S), [V,W,X,Y], [A,B,C,D]),
    spaces(tri(A,B,C), spaces(Plane, _, [Beyond|_])),
    value(Plane, D, 0),
    value(Beyond, D, Side),
    Side < 0.

triangle_at(S, V, W, How, U) :-
    t(S, _, _, A, B, C),
    member(P-Q-U, [A-B-C, B-C-A, C-A-B]),
    (   P-Q == V-W
    ->  How = same
    ;   P-Q == W-V
    ->  How = back
    ).

box(Points, p(X1,Y1,Z1), p(X2,Y2,Z2)) :-
    findall(X, member(p(X,_,_), Points), Xs),
    findall(Y, member(p(_,Y,_), Points), Ys),
    findall(Z, member(p(_,_,Z), Points), Zs),
    maplist(min_list, [Xs,Ys,Zs], [X1,Y1,Z1]),
    maplist(max_list, [Xs,Ys,Zs], [X2,Y2,Z2]).

boxes_meet(p(X1,Y1,Z1)-p(X2,Y2,Z2), p(X3,Y3,Z3)-p(X4,Y4,Z4)) :-
    X1 =< X4, X3 =< X2,
    Y1 =< Y4, Y3 =< Y2,
    Z1 =< Z4, Z3 =< Z2.

%   A pair of leaves and a piece they have in common.

leaf_piece(Leaves1, Leaves2, Leaf1, Leaf2, Kind, Piece) :-
    leaf_pair(Leaves1, Leaves2, Leaf1, Leaf2),
    Leaf1 = leaf(_, T1, _, Spaces1, _),
    Leaf2 = leaf(_, T2, _, Spaces2, _),
    \+ apart(T1, Spaces2),
    \+ apart(T2, Spaces1),
    common(T1, Spaces1, T2, Spaces2, Kind, Pieces),
    member(Piece, Pieces).

%   leaf_pair(+Leaves1, +Leaves2, -Leaf1, -Leaf2): their boxes meet. By a sweep
%   along X, for segments of some thousands of triangles.

leaf_pair(Leaves1, Leaves2, Leaf1, Leaf2) :-
    by_low_x(Leaves1, Sorted1),
    by_low_x(Leaves2, Sorted2),
    foldl(wider, Leaves2, 0, Width),
    sweep(Sorted1, Sorted2, Width, Leaf1, Near),
    Leaf1 = leaf(_, _, _, _, Box1),
    Box1 = _-p(Xmax,_,_),
    near_leaf(Near, Xmax, Leaf2),
    Leaf2 = leaf(_, _, _, _, Box2),
    boxes_meet(Box1, Box2).

by_low_x(Leaves, Sorted) :-
    findall(X-Leaf, ( member(Leaf, Leaves),
                      Leaf = leaf(_, _, _, _, p(X,_,_)-_) ),
            Keyed),
    keysort(Keyed, Sorted).

wider(leaf(_, _, _, _, p(X1,_,_)-p(X2,_,_)), W0, W) :-
    W is max(W0, X2-X1).

%   sweep(+Sorted1, +Sorted2, +Width, -Leaf1, -Near): Near begins with the first
%   of Sorted2 that is not wholly before Leaf1.

sweep([X-Leaf|Sorted1], Sorted2, Width, Leaf1, Near) :-
    From is X-Width,
    begin(Sorted2, From, Near0),
    (   Leaf1 = Leaf,
        Near = Near0
    ;   sweep(Sorted1, Near0, Width, Leaf1, Near)
    ).

begin([X-_|Sorted], From, Near) :-
    X < From,
    !,
    begin(Sorted, From, Near).
begin(Near, _, Near).

near_leaf([X-Leaf|Sorted], High, Near) :-
    X =< High,
    (   Near = Leaf
    ;   near_leaf(Sorted, High, Near)
    ).

%   All corners on one side of the other's plane.

apart(tri(A,B,C), spaces(Plane, _, _)) :-
    value(Plane, A, Da),
    value(Plane, B, Db),
    value(Plane, C, Dc),
    (   Da > 0, Db > 0, Dc > 0
    ;   Da < 0, Db < 0, Dc < 0
    ),
    !.

%!  common_lines(+Leaves1, +Leaves2, -Lines) is det.
%
%   The penetration lines of two segments: P1-P2-Piece for every piece of
%   positive length that polygons P1 and P2 have in common by two of their
%   triangles. In a common plane these are parts of the borders of faces: of
%   real edges that are not inside one, nor of the triangles in polygons.

common_lines(Leaves1, Leaves2, Lines) :-
    findall(P1-P2-(A-B),
            ( leaf_piece(Leaves1, Leaves2, Leaf1, Leaf2, Kind, A-B),
              A \== B,
              is_line(Kind, Leaf1, Leaf2, A-B),
              arg(1, Leaf1, P1),
              arg(1, Leaf2, P2)
            ),
            Lines0),
    sort(Lines0, Lines).

is_line(crossing, _, _, _).
is_line(coplanar, Leaf1, Leaf2, A-B) :-
    member(leaf(_, _, Real, Spaces, _), [Leaf1,Leaf2]),
    feature(Spaces, A, Fa),
    feature(Spaces, B, Fb),
    member(edge(Edge, border), Real),
    subset(Fa, Edge),
    subset(Fb, Edge),
    !.

%!  common_points(+Leaves1, +Leaves2, -Points) is det.
%
%   The points, in standard order, that the leaves of two segments have in
%   common as a point alone, though they may lie on a line of other leaves. In a
%   common plane none that two leaves of the same two segments have in common
%   with more: it is inside what their faces share.

common_points(Leaves1, Leaves2, Points) :-
    findall(Kind-(A-B), leaf_piece(Leaves1, Leaves2, _, _, Kind, A-B), All),
    findall(A, ( member(coplanar-(P-Q), All), P \== Q, member(A, [P,Q]) ),
            Shared0),
    sort(Shared0, Shared),
    findall(A, ( member(Kind-(A-A), All),
                 \+ ( Kind == coplanar, memberchk(A, Shared) ) ),
            Points0),
    sort(Points0, Points).

/* - - - sets of points on lines - - - */

%!  runs(+Pieces, -Runs) is det.
%
%   Runs is the union of Pieces P-Q in a normal form: a list of Line-[From-To,
%   ...], the largest straight parts, in order. Equal lists are equal sets of
%   points. Line is line(Axis, Direction, Point): its direction, 1 along Axis,
%   and its point whose coordinate on Axis is 0; From and To are coordinates
%   on Axis.

runs(Pieces, Runs) :-
    maplist(on_line, Pieces, Keyed0),
    keysort(Keyed0, Keyed),
    group_pairs_by_key(Keyed, Groups),
    maplist(line_runs, Groups, Runs).

line_runs(Line-Parts0, Line-Parts) :-
    sort(Parts0, Parts1),
    together(Parts1, Parts).

on_line(P-Q, line(Axis, v(Dx,Dy,Dz), p(X0,Y0,Z0))-(From-To)) :-
    minus(Q, P, v(X,Y,Z)),
    axis(X, Y, Z, Axis, Along),
    Dx is X rdiv Along,
    Dy is Y rdiv Along,
    Dz is Z rdiv Along,
    arg(Axis, P, At1),
    arg(Axis, Q, At2),
    P = p(Xp,Yp,Zp),
    X0 is Xp-Dx*At1,
    Y0 is Yp-Dy*At1,
    Z0 is Zp-Dz*At1,
    From is min(At1, At2),
    To is max(At1, At2).

axis(X, _, _, 1, X) :-
    X =\= 0,
    !.
axis(_, Y, _, 2, Y) :-
    Y =\= 0,
    !.
axis(_, _, Z, 3, Z).

together([A-B,C-D|Parts], Joined) :-
    C =< B,
    !,
    E is max(B, D),
    together([A-E|Parts], Joined).
together([Part|Parts], [Part|Joined]) :-
    together(Parts, Joined).
together([], []).

%!  directed_runs(+Pieces, -Runs) is det.
%
%   The same for directed Pieces: Forward-Backward, those whose P is before Q
%   and the others.

directed_runs(Pieces, Forward-Backward) :-
    partition(is_forward, Pieces, Forward0, Backward0),
    runs(Forward0, Forward),
    runs(Backward0, Backward).

is_forward(P-Q) :-
    P @< Q.

%!  run_point(+Runs, +Point, -How) is nondet.
%
%   True when Point is on one of Runs, on Line: How is inside(Line) or
%   end(Line).

run_point(Runs, Point, How) :-
    member(Line-Parts, Runs),
    on(Line, Point, At),
    member(From-To, Parts),
    At >= From,
    At =< To,
    (   ( At =:= From ; At =:= To )
    ->  How = end(Line)
    ;   How = inside(Line)
    ).

on(line(Axis, v(Dx,Dy,Dz), p(X0,Y0,Z0)), Point, At) :-
    arg(Axis, Point, At),
    Point = p(X,Y,Z),
    X =:= X0+Dx*At,
    Y =:= Y0+Dy*At,
    Z =:= Z0+Dz*At.

/* - - - what the engine made, exactly - - - */

%!  exact_vertex(+S, +V, -Point) is semidet.
%
%   Where vertex V of segment S is by its origin/3, and by v/5 if it has none,
%   or one within the tolerance only. Fails if the origin does not say.

exact_vertex(S, V, Point) :-
    (   origin(S, v(V), Origin),
        Origin \= near(_)
    ->  origin_point(Origin, Point)
    ;   vertex_point(S, V, Point)
    ).

%!  origin_point(+Origin, -Point) is semidet.
%
%   Where a vertex with this origin is.

origin_point(v(S, V), Point) :-
    exact_vertex(S, V, Point).
origin_point(lpi(S1-(A,B), S2-(C,D,E)), Point) :-
    maplist(exact_vertex(S1), [A,B], [Pa,Pb]),
    plane(S2-(C,D,E), Plane),
    line_point(Plane, Pa, Pb, Point).
origin_point(ll(S1-(A,B), S2-(C,D)), Point) :-
    maplist(exact_vertex(S1), [A,B], [Pa,Pb]),
    maplist(exact_vertex(S2), [C,D], [Pc,Pd]),
    minus(Pb, Pa, U),
    minus(Pd, Pc, W),
    cross(U, W, N),
    cross(N, W, Side),
    half_space(Side, Pc, Plane),        % through C-D, across the common plane
    line_point(Plane, Pa, Pb, Point).
origin_point(tpi(T1, T2, T3), Point) :-
    maplist(plane, [T1,T2,T3], [H1,H2,H3]),
    H1 = h(A1,B1,C1,D1),
    H2 = h(A2,B2,C2,D2),
    H3 = h(A3,B3,C3,D3),
    determinant(A1,B1,C1, A2,B2,C2, A3,B3,C3, W),
    W =\= 0,
    determinant(D1,B1,C1, D2,B2,C2, D3,B3,C3, X0),
    determinant(A1,D1,C1, A2,D2,C2, A3,D3,C3, Y0),
    determinant(A1,B1,D1, A2,B2,D2, A3,B3,D3, Z0),
    X is -X0 rdiv W,
    Y is -Y0 rdiv W,
    Z is -Z0 rdiv W,
    Point = p(X,Y,Z).

plane(S-(A,B,C), Plane) :-
    maplist(exact_vertex(S), [A,B,C], [Pa,Pb,Pc]),
    spaces(tri(Pa,Pb,Pc), spaces(Plane, _, _)).

line_point(Plane, A, B, Point) :-
    value(Plane, A, Da),
    value(Plane, B, Db),
    Da =\= Db,
    T is Da rdiv (Da-Db),
    go(A, B, T, Point).

determinant(A1,B1,C1, A2,B2,C2, A3,B3,C3, D) :-
    D is A1*(B2*C3-C2*B3) - B1*(A2*C3-C2*A3) + C1*(A2*B3-B2*A3).

%!  vector_area(+Edges, -Vector) is det.
%
%   Twice the vector area v(X,Y,Z) that the closed loops Edges, P-Q, go round.

vector_area(Edges, Vector) :-
    foldl(add_area, Edges, v(0,0,0), Vector).

add_area(p(X1,Y1,Z1)-p(X2,Y2,Z2), v(X0,Y0,Z0), v(X,Y,Z)) :-
    X is X0+Y1*Z2-Z1*Y2,
    Y is Y0+Z1*X2-X1*Z2,
    Z is Z0+X1*Y2-Y1*X2.
