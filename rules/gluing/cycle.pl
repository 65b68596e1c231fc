:- module(sg_cycle,
          [ loop_cycle/4,               % ?S, ?P, -K, -Vs
            radial_cycle/4,             % ?S, ?A, ?B, -Pages
            disk/4                      % ?S, ?V, -D, -Items
          ]).
:- use_module('../exact', [vertex_exact/5]).
:- use_module('../store',
              [ v/5, e/5, p/3, t/6, edge_polygon/3, vertex_triangle/3, sides/4,
                lies_in/3 ]).
:- use_module('../vector', [cross_product/3, difference/3, dot_product/3]).
:- use_module('../vocabulary', [facet_loops/2]).
:- use_module(library(lists),
              [append/3, member/2, nth1/3, select/3]).
:- use_module(library(ordsets), [ord_intersect/2, ord_union/3]).
:- use_module(library(pairs), [pairs_values/2]).
:- use_module(library(sort), [predsort/3]).

/** <module> The three cycles of what is no manifold (NG-1).

Edges round a face, pages round an edge, and what hangs together round a vertex.
Nothing of them is kept: they are joins (PL-1), and the order round an edge is
decided by rationals. For a whole segment c_kernels/gluing/regions.h does the
same.
*/

%!  loop_cycle(?S, ?P, -K, -Vs) is nondet.
%
%   True when the K-th cycle round polygon P of segment S is through the
%   vertices Vs: loops as its list has them, a seam walked there and back; then
%   vertices of others that lie inside, each a loop [V].

loop_cycle(S, P, K, Vs) :-
    p(S, P, _),
    facet_loops(S-P, Loops),
    findall([V], lies_in(S, v(V), p(P)), Points),
    append(Loops, Points, All),
    nth1(K, All, Vs).

%!  radial_cycle(?S, ?A, ?B, -Pages) is nondet.
%
%   True when Pages are the faces round the edge between the vertices A and B of
%   segment S, A < B: page(P, E, R) has edge E of polygon P, and R is the region
%   that follows it, or `none` if sides/4 does not say. They go round as the
%   fingers of the right hand whose thumb points from A to B, from the lowest P
%   on. [] of a wire. Exact, also of vertices that a cut made. Polygons need
%   their triangles (complete_segments/0).

radial_cycle(S, A, B, Pages) :-
    edge_between(S, A, B),
    findall(P-E, page_edge(S, A, B, P, E), Edges0),
    sort(Edges0, Edges),
    (   Edges = [_,_,_|_]
    ->  pages_in_order(S, A, B, Edges, Ordered)
    ;   Ordered = Edges
    ),
    pages(Ordered, S, A, Pages0),
    twins_in_order(Pages0, Pages).

%   edge_between(?S, ?A, ?B): each edge once.

edge_between(S, A, B) :-
    (   integer(A),
        integer(B)
    ->  A < B,
        once(an_edge(S, A, B))
    ;   findall(S-(A,B), ( an_edge(S, A0, B0), A0 \== B0,
                           in_order(A0, B0, A, B) ), Edges0),
        sort(Edges0, Edges),
        member(S-(A,B), Edges)
    ).

in_order(A0, B0, A, B) :-
    A is min(A0, B0),
    B is max(A0, B0).

an_edge(S, A, B) :-
    (   integer(A)
    ->  ( e(S, _, A, B, _) ; e(S, _, B, A, _) )
    ;   integer(B)
    ->  ( e(S, _, A, B, _) ; e(S, _, B, A, _) )
    ;   e(S, _, A, B, _)
    ).

page_edge(S, A, B, P, E) :-
    (   e(S, E, A, B, _)
    ;   e(S, E, B, A, _)
    ),
    edge_polygon(S, E, P).

%   pages(Edges, S, A, Pages): with what is before each page and after it.

pages([], _, _, []).
pages([P-E|Edges], S, A, [page(P, E, Before, After)|Pages]) :-
    (   sides(S, P, Below, Above)
    ->  true
    ;   Below = none,
        Above = none
    ),
    (   e(S, E, A, _, _)
    ->  Before = Below,
        After = Above
    ;   Before = Above,
        After = Below
    ),
    pages(Edges, S, A, Pages).

%   twins_in_order(Pages0, Pages): faces that lie on each other come by the
%   regions between them.

twins_in_order([], []).
twins_in_order([page(P, E, _, After)|Pages0], [page(P, E, After)|Pages]) :-
    (   Pages0 = [page(_, _, After, _)|_]
    ->  Pages1 = Pages0
    ;   select(Next, Pages0, Others),
        Next = page(_, _, After, _)
    ->  Pages1 = [Next|Others]
    ;   Pages1 = Pages0
    ),
    twins_in_order(Pages1, Pages).

%   pages_in_order(S, A, B, Edges0, Edges): by the angle to the first.

pages_in_order(S, A, B, [First|Edges0], [First|Edges]) :-
    exact_place(S, A, From),
    exact_place(S, B, To),
    difference(To, From, Axis),
    page_direction(S, From, First, Side),
    square_to(Axis, Side, U),
    cross_product(Axis, U, W),
    findall(angle(Quarter, X, Y)-Edge,
            ( member(Edge, Edges0),
              page_direction(S, From, Edge, Direction),
              dot_product(Direction, U, X),
              dot_product(Direction, W, Y),
              quarter(X, Y, Quarter) ),
            Angles0),
    predsort(by_angle, Angles0, Angles),
    pairs_values(Angles, Edges).

exact_place(S, V, p(X,Y,Z)) :-
    once(vertex_exact(S, V, X, Y, Z)).

%   square_to(Axis, Side, U): U is what of Side is square to Axis.

square_to(p(X,Y,Z), p(A,B,C), p(U,V,W)) :-
    Along is (X*A+Y*B+Z*C) rdiv (X*X+Y*Y+Z*Z),
    U is A-Along*X,
    V is B-Along*Y,
    W is C-Along*Z.

%   page_direction(S, From, P-E, Direction): to a point of the page beside E.

page_direction(S, From, P-E, Direction) :-
    once(e(S, E, V1, V2, _)),
    once(( vertex_triangle(S, V1, T),
           t(S, P, T, A, B, C),
           third(A, B, C, V1, V2, V) )),
    exact_place(S, V, Place),
    difference(Place, From, Direction).

third(A, B, C, A, B, C).
third(A, B, C, B, C, A).
third(A, B, C, C, A, B).

%   quarter(X, Y, Quarter): 0 on the first page, 1, 2 opposite, 3.

quarter(X, Y, Quarter) :-
    (   Y > 0
    ->  Quarter = 1
    ;   Y < 0
    ->  Quarter = 3
    ;   X > 0
    ->  Quarter = 0
    ;   Quarter = 2
    ).

by_angle(Order, angle(Q1,X1,Y1)-E1, angle(Q2,X2,Y2)-E2) :-
    compare(Order0, Q1, Q2),
    (   Order0 == (=),
        Q1 mod 2 =:= 1,
        Turn is X1*Y2-X2*Y1,
        Turn =\= 0
    ->  (   Turn > 0
        ->  Order = (<)
        ;   Order = (>)
        )
    ;   Order0 == (=)
    ->  compare(Order, E1, E2)
    ;   Order = Order0
    ).

%!  disk(?S, ?V, -D, -Items) is nondet.
%
%   True when the D-th disk at vertex V of segment S has Items, in order: the
%   edges e(E) that end or start at V and the polygons p(P) there that hang
%   together by them. A wire is a disk of its own, and so is a polygon inside of
%   which V lies. Disks come in the order of their first items.

disk(S, V, D, Items) :-
    v(S, V, _, _, _),
    findall(Items0, disk_part(S, V, Items0), Parts),
    united(Parts, Disks0),
    sort(Disks0, Disks),
    nth1(D, Disks, Items).

%   disk_part(S, V, Items): a wire, a corner, or a point loop. Edges between the
%   same two vertices hang together.

disk_part(S, V, Items) :-
    edge_at(S, V, E, W),
    findall(e(E1), ( edge_at(S, V, E1, W) ), Es),
    findall(p(P), ( edge_polygon(S, E, P) ), Ps),
    append(Es, Ps, Items0),
    sort(Items0, Items).
disk_part(S, V, [p(P)]) :-
    lies_in(S, v(V), p(P)).

edge_at(S, V, E, W) :-
    e(S, E, V, W, _).
edge_at(S, V, E, W) :-
    e(S, E, W, V, _).

united([], []).
united([Part|Parts], Disks) :-
    united(Parts, Disks0),
    united(Disks0, Part, Disks).

united([], Part, [Part]).
united([Disk|Disks0], Part, Disks) :-
    (   ord_intersect(Disk, Part)
    ->  ord_union(Disk, Part, Part1),
        united(Disks0, Part1, Disks)
    ;   Disks = [Disk|Disks1],
        united(Disks0, Part, Disks1)
    ).
