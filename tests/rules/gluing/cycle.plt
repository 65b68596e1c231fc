/* Cycles of what is no manifold: round faces, edges and vertices; and whether
   the kernel's regions agree with the order that rationals decide. */
:- module(test_cycle, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(gluing/cycle)).
:- use_module(rules(gluing/regions)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(store)).
:- use_module(tests(rules/gluing/face_soup)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   on_axis(T, Point), beside(T, A-B, Point): on the line through 0 along
%   (1,2,2), and off it by A*u + B*w, which are square to it and to each other,
%   as long, and turn by its right hand. Integers stay integers.

on_axis(T, [T,Y,Y]) :-
    Y is 2*T.

beside(T, A-B, [X,Y,Z]) :-
    X is T+2*A-2*B,
    Y is 2*T+A+2*B,
    Z is 2*T-2*A-B.

page(Low-High, Way, [[P,Q,R,S]]) :-
    on_axis(Low, P),
    on_axis(High, Q),
    beside(High, Way, R),
    beside(Low, Way, S).

%   numbers(+Pages, -Ps): the polygons of a radial cycle.

numbers(Pages, Ps) :-
    findall(P, member(page(P, _, _), Pages), Ps).

%   The cycle round the edge between two points, by the right hand from the
%   first to the second; from its lowest polygon on.

round(Low, High, Ps) :-
    on_axis(Low, Point1),
    on_axis(High, Point2),
    vertex_at(Point1, V1),
    vertex_at(Point2, V2),
    (   V1 < V2
    ->  radial_cycle(1, V1, V2, Pages),
        numbers(Pages, Ps)
    ;   radial_cycle(1, V2, V1, Pages),
        numbers(Pages, [First|Back]),
        reverse(Back, Rest),
        Ps = [First|Rest]
    ).

%   ways(+N, -Ways): N directions, no two the same.

ways(N, Ways) :-
    Most is 2*N+20,
    findall(Way,
            ( between(1, Most, _),
              random_between(-99, 99, A),
              random_between(-99, 99, B),
              A*A+B*B > 0,
              D is gcd(A, B),
              A1 is A//D,
              B1 is B//D,
              Way = A1-B1 ),
            Ways0),
    list_to_set(Ways0, Ways1),
    length(Ways, N),
    append(Ways, _, Ways1),
    !.

angle(A-B, Angle) :-
    Angle is atan2(B, A).

%   by_angle(+Ways, -Ps): their places in Ways in the order of their angles, the
%   first way first.

by_angle(Ways, Ps) :-
    findall(Angle-P, ( nth1(P, Ways, Way), angle(Way, Angle) ), Pairs0),
    keysort(Pairs0, Pairs),
    pairs_values(Pairs, Sorted),
    once(append(Before, [1|After], Sorted)),
    append([1|After], Before, Ps).

%   agrees(S): round every edge what follows a page is before the next one, as
%   sides/4 has it.

agrees(S) :-
    forall(( radial_cycle(S, A, _, Pages), Pages = [First|_] ),
           ( append(Pages, [First], Again),
             forall(append(_, [page(_, _, R)|[Next|_]], Again),
                    before(S, A, Next, R)) )).

before(S, A, page(P, E, _), R) :-
    sides(S, P, Below, Above),
    (   e(S, E, A, _, _)
    ->  R == Below
    ;   R == Above
    ).

:- begin_tests(cycle).

%   Round from the first page: on it, between, opposite, between.

test(quarters, Quarters == [0,1,1,1,2,3,3,3]) :-
    findall(Quarter,
            ( member(X-Y, [1-0,1-1,0-1,(-1)-1,(-1)-0,(-1)-(-1),0-(-1),1-(-1)]),
              sg_cycle:quarter(X, Y, Quarter) ),
            Quarters).

test(book, [forall(member(N, [3,4,5,17,200])), true(Ps == Wanted)]) :-
    set_random(seed(N)),
    ways(N, Ways),
    by_angle(Ways, Wanted),
    maplist(page(0-3), Ways, Faces),
    in_new_world(( made_soup(Faces, []), regions_made(1, _),
                   round(0, 3, Ps) )).

%   Pages that doubles hardly tell apart.

test(thin_book, Ps == [1,5,3,2,4]) :-
    findall([[[0,0,0],[0,0,1],[1,Y,1],[1,Y,0]]],
            ( member(K, [0,3,2,4,1]), Y is K*1.0e-15 ),
            Faces),
    in_new_world(( made_soup(Faces, []), regions_made(1, _),
                   vertex_at([0,0,0], A), vertex_at([0,0,1], B),
                   radial_cycle(1, A, B, Pages) )),
    numbers(Pages, Ps).
test(wire, Pages == []) :-
    in_new_world(( made_soup([], [[[0,0,0],[1,0,0]]]),
                   radial_cycle(1, 1, 2, Pages) )).
test(no_edge, fail) :-
    in_new_world(( made_soup([], [[[0,0,0],[1,0,0],[1,1,0]]]),
                   radial_cycle(1, 1, 3, _) )).
test(one_page_has_one_region, Regions == [1]) :-
    page(0-1, 1-0, Face),
    in_new_world(( made_soup([Face], []), regions_made(1, _),
                   findall(R, ( radial_cycle(1, _, _, [page(1, _, R0)]),
                                R = R0 ),
                           Rs) )),
    sort(Rs, Regions).

%   Edge glue, in part: what both edges have is one edge of five pages.

test(edges_in_part, [N,A,B,C] == [[14,18,5,5,1,1,1,0],[1,2,3],[1,2,3,4,5],
                                  [4,5]]) :-
    findall(Face,
            ( member(Low-Mid-High-Ways, [0-1-3-[2-0,1-2,(-1)-2],
                                         1-3-4-[(-2)-(-1),1-(-2)]]),
              member(Way, Ways),
              on_axis(Low, P), on_axis(Mid, Q), on_axis(High, R),
              beside(High, Way, S), beside(Low, Way, T),
              Face = [[P,Q,R,S,T]] ),
            Faces),
    in_new_world(( made_soup(Faces, []), regions_made(1, Report),
                   round(0, 1, A), round(1, 3, B), round(3, 4, C),
                   agrees(1) )),
    report_counts(Report, N).

model(cubes, Faces) :-
    findall([X,Y,Z], ( member(X, [0,1]), member(Y, [0,1]), member(Z, [0,1]) ),
            Lows),
    cubes_faces(Lows, Faces).
model(some_cubes, Faces) :-
    cubes_faces([[0,0,0],[1,1,0],[1,0,1],[0,1,1]], Faces).
model(turned_cubes, Faces) :-
    model(cubes, Faces0),
    maplist(maplist(maplist(turned)), Faces0, Faces).
model(book(N), Faces) :-
    set_random(seed(N)),
    ways(N, Ways),
    maplist(page(0-1), Ways, Faces).

turned([X,Y,Z], [X1,Y1,Z1]) :-
    C is cos(0.302),
    S is sin(0.302),
    X1 is C*X-S*Y,
    Y2 is S*X+C*Y,
    Y1 is C*Y2-S*Z,
    Z1 is S*Y2+C*Z.

test(agrees, [forall(member(Model, [cubes,some_cubes,turned_cubes,book(50)]))]
    ) :-
    model(Model, Faces),
    in_new_world(( made_soup(Faces, []), regions_made(1, _), agrees(1) )).
test(inner_edges_have_four_pages, Lengths == [4-6,3-24,2-24]) :-
    model(cubes, Faces),
    in_new_world(( made_soup(Faces, []), complete_segments,
                   findall(L, ( radial_cycle(1, _, _, Pages),
                                length(Pages, L) ),
                           Ls0) )),
    msort(Ls0, Ls),
    clumped_lengths(Ls, Lengths0),
    reverse(Lengths0, Lengths).

clumped_lengths(Ls, Lengths) :-
    pairs_keys_values(Pairs, Ls, Ls),
    group_pairs_by_key(Pairs, Groups),
    findall(L-N, ( member(L-Group, Groups), length(Group, N) ), Lengths).

%   Round a face: its border, a hole the other way round, a seam there and back,
%   and a point.

test(loops, Turns == [4-left,4-right]) :-
    Face = [ [[0,0,0],[4,0,0],[4,4,0],[0,4,0]],
             [[1,1,0],[1,2,0],[2,2,0],[2,1,0]] ],
    in_new_world(( made_soup([Face], []),
                   findall(N-Turn,
                           ( loop_cycle(1, 1, _, Vs),
                             length(Vs, N),
                             turn(Vs, Turn) ),
                           Turns) )).

turn(Vs, Turn) :-
    Vs = [First|Rest],
    append(Rest, [First], Nexts),
    foldl(area, Vs, Nexts, 0, Area),
    (   Area > 0
    ->  Turn = left
    ;   Turn = right
    ).

area(V1, V2, A0, A) :-
    v(1, V1, X1, Y1, _),
    v(1, V2, X2, Y2, _),
    A is A0+X1*Y2-X2*Y1.

test(seam_and_point, Loops == [4,2,1]) :-
    Face = [ [[0,0,0],[4,0,0],[4,4,0],[0,4,0]], [[1,1,0],[2,1,0]] ],
    in_new_world(( made_soup([Face], [[[3,3,0]]]),
                   vertex_at([3,3,0], V),
                   assert_fact(lies_in(1, v(V), p(1))),
                   findall(N, ( loop_cycle(1, 1, _, Vs), length(Vs, N) ),
                           Loops) )).

%   Round a vertex: two cubes that touch there, and a wire.

test(disks, Disks == [1-6,2-6,3-1]) :-
    cubes_faces([[0,0,0],[1,1,1]], Faces),
    in_new_world(( made_soup(Faces, [[[1,1,1],[2,0,2]]]),
                   vertex_at([1,1,1], V),
                   findall(D-N,
                           ( disk(1, V, D, Items),
                             count_edges(Items, N) ),
                           Disks0) )),
    msort(Disks0, Disks).

%   Each of the three edges of a cube there and back.

count_edges(Items, N) :-
    findall(E, member(e(E), Items), Es),
    length(Es, N).

test(one_disk_of_neighbours, N == 1) :-
    cubes_faces([[0,0,0],[1,0,0],[1,1,0]], Faces),
    in_new_world(( made_soup(Faces, []),
                   vertex_at([1,1,0], V),
                   aggregate_all(count, disk(1, V, _, _), N) )).
test(point_in_a_face_has_its_disk, Kinds == [[e],[p]]) :-
    in_new_world(( made_soup([[[[0,0,0],[4,0,0],[4,4,0],[0,4,0]]]],
                             [[[1,1,0],[1,1,1]]]),
                   vertex_at([1,1,0], V),
                   assert_fact(lies_in(1, v(V), p(1))),
                   findall(Names,
                           ( disk(1, V, _, Items),
                             findall(Name, ( member(Item, Items),
                                             functor(Item, Name, 1) ),
                                     Names) ),
                           Kinds) )).

:- end_tests(cycle).
