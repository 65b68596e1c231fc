:- module(polygon_sample,
          [ with_polygon/3,           % +Loops, +Place, :Goal
            with_edges/4,             % +Points, +Edges, +Place, :Goal
            random_cells/4,           % +Size, +Seams, -Points, -Edges
            random_walk/3,            % +N, +Grid, -Loops
            ring_loops/2,             % +File, -Loops
            polygon_area/1,           % -Area
            triangles_area/2          % +Triangles, -Area
          ]).
:- use_module(library(http/json)).
:- use_module(library(lists)).
:- use_module(library(apply)).
:- use_module(library(random)).
:- use_module(rules(store)).

/** <module> Polygons to test with, put into a world of their own.

Points are X-Y in the polygon's own plane. A Place says where that is:
`flat`; axis(Axis, Sign): seen along an axis, from its positive or negative
end; plane(U, V, O): X*U + Y*V + O, three triples of numbers. Areas are exact,
doubled, and seen along the largest component of the normal.
*/

:- meta_predicate
    with_polygon(+, +, 0),
    with_edges(+, +, +, 0).

%!  with_polygon(+Loops, +Place, :Goal) is semidet.
%
%   Runs Goal in a world with polygon 1 of segment 1, whose loops are lists of
%   points. Every point gets a vertex of its own, also where places agree.

with_polygon(Loops, Place, Goal) :-
    append(Loops, Points),
    foldl(loop_edges, Loops, Edges, 1, _),
    append(Edges, AllEdges),
    with_edges(Points, AllEdges, Place, Goal).

loop_edges(Loop, Edges, V0, V) :-
    length(Loop, N),
    V is V0+N,
    Last is V-1,
    numlist(V0, Last, Vs),
    Vs = [_|Next],
    append(Next, [V0], Ends),
    pairs_keys_values(Edges, Vs, Ends).

%!  with_edges(+Points, +Edges, +Place, :Goal) is semidet.
%
%   The same from points, vertices 1, 2, ..., and edges V1-V2 in this order.

with_edges(Points, Edges, Place, Goal) :-
    new_world(World),
    in_world(World,
             ( assert_fact(segment(1, surface, sample)),
               forall(nth1(V, Points, Point), add_vertex(V, Place, Point)),
               forall(nth1(E, Edges, V1-V2), assert_fact(e(1, E, V1, V2, 1))),
               length(Edges, N),
               numlist(1, N, Es),
               assert_fact(p(1, 1, Es)),
               call(Goal)
             )).

add_vertex(V, Place, Point) :-
    placed(Place, Point, X0, Y0, Z0),
    X is float(X0),
    Y is float(Y0),
    Z is float(Z0),
    assert_fact(v(1, V, X, Y, Z)).

placed(flat, X-Y, X, Y, 0).
placed(axis(z, 1), X-Y, X, Y, 7).
placed(axis(x, 1), X-Y, 7, X, Y).
placed(axis(y, 1), X-Y, Y, 7, X).
placed(axis(z, -1), X-Y, Y, X, 7).
placed(axis(x, -1), X-Y, 7, Y, X).
placed(axis(y, -1), X-Y, X, 7, Y).
placed(plane([A1,B1,C1], [A2,B2,C2], [A3,B3,C3]), X-Y, A, B, C) :-
    A is X*A1+Y*A2+A3,
    B is X*B1+Y*B2+B3,
    C is X*C1+Y*C2+C3.

%!  random_cells(+Size, +Seams, -Points, -Edges) is det.
%
%   The border of a random set of the cells of a Size by Size board: holes,
%   islands, several pieces, loops that touch themselves and each other in
%   points, straight runs. Of the edges inside, Seams in 100 are pairs (seams,
%   loose chains, closed chains). In random order. Vertices are shared.

random_cells(Size, Seams, Points, Edges) :-
    High is Size-1,
    findall(X/Y, ( between(0, High, X), between(0, High, Y), maybe(0.6) ),
            Cells0),
    (   Cells0 == []
    ->  Cells = [0/0]
    ;   Cells = Cells0
    ),
    findall(A-B, ( member(Cell, Cells), cell_edge(Cells, Seams, Cell, A, B) ),
            Sides),
    findall(Side, ( member(A-B, Sides), member(Side, [A-B]) ), Borders),
    findall(B-A, ( member(A-B, Sides), \+ memberchk(B-A, Sides),
                   seam_sides(Cells, A, B) ),
            Backs),
    append(Borders, Backs, All0),
    sort(All0, All1),
    random_permutation(All1, All),
    findall(P, ( member(A-B, All), member(P, [A,B]) ), Ps0),
    sort(Ps0, Ps),
    random_permutation(Ps, Places),
    findall(X-Y, member(X/Y, Places), Points),
    maplist(edge_of_places(Places), All, Edges).

edge_of_places(Places, A-B, V1-V2) :-
    nth1(V1, Places, A),
    nth1(V2, Places, B),
    !.

%   A side of a cell, counter-clockwise: a border, or by chance a seam.

cell_edge(Cells, Seams, X/Y, A, B) :-
    X1 is X+1,
    Y1 is Y+1,
    Xl is X-1,
    Yl is Y-1,
    member(side(A, B, Neighbour),
           [ side(X/Y, X1/Y, X/Yl), side(X1/Y, X1/Y1, X1/Y),
             side(X1/Y1, X/Y1, X/Y1), side(X/Y1, X/Y, Xl/Y)
           ]),
    (   memberchk(Neighbour, Cells)
    ->  random(R),
        R*200 < Seams
    ;   true
    ).

%   Is there a cell on both sides of A-B?

seam_sides(Cells, XA/YA, XB/YB) :-
    (   XA =:= XB
    ->  Y is min(YA, YB),
        X is XA-1,
        memberchk(X/Y, Cells),
        memberchk(XA/Y, Cells)
    ;   X is min(XA, XB),
        Y is YA-1,
        memberchk(X/Y, Cells),
        memberchk(X/YA, Cells)
    ).

%!  random_walk(+N, +Grid, -Loops) is det.
%
%   A loop of N random points of a grid, and another one: mostly invalid.

random_walk(N, Grid, [Loop1,Loop2]) :-
    length(Loop1, N),
    length(Loop2, 3),
    maplist(random_point(Grid), Loop1),
    maplist(random_point(Grid), Loop2).

random_point(Grid, X-Y) :-
    random_between(0, Grid, X),
    random_between(0, Grid, Y).

%!  ring_loops(+File, -Loops) is det.
%
%   The loops of a file of JSON rings, the first turned counter-clockwise, the
%   others, its holes, clockwise. A last point equal to the first is dropped.

ring_loops(File, [Outer|Holes]) :-
    setup_call_cleanup(open(File, read, In),
                       json_read_dict(In, [Ring|Rings]),
                       close(In)),
    ring_loop(1, Ring, Outer),
    maplist(ring_loop(-1), Rings, Holes).

ring_loop(Turn, Ring, Loop) :-
    findall(X-Y, member([X,Y], Ring), Loop0),
    (   append(Loop1, [Point], Loop0),
        Loop0 = [Point|_],
        Loop1 \== []
    ->  true
    ;   Loop1 = Loop0
    ),
    loop_area(Loop1, Area),
    (   Area*Turn < 0
    ->  reverse(Loop1, Loop)
    ;   Loop = Loop1
    ).

loop_area([], 0).
loop_area([First|Loop], Area) :-
    loop_area(Loop, First, First, 0, Area).

loop_area([], Last, First, Area0, Area) :-
    doubled(Last, First, Area1),
    Area is Area0+Area1.
loop_area([Point|Loop], Last, First, Area0, Area) :-
    doubled(Last, Point, Area1),
    Area2 is Area0+Area1,
    loop_area(Loop, Point, First, Area2, Area).

doubled(X1-Y1, X2-Y2, Area) :-
    Area is rational(X1)*rational(Y2) - rational(X2)*rational(Y1).

%!  polygon_area(-Area) is det.
%
%   The doubled area of polygon 1 of segment 1 of the current world.

polygon_area(Area) :-
    p(1, 1, Es),
    findall(V1-V2, ( member(E, Es), e(1, E, V1, V2, _) ), Pairs),
    seen(Seen),
    foldl(add_edge(Seen), Pairs, 0, Area).

add_edge(Seen, V1-V2, Area0, Area) :-
    seen_point(Seen, V1, P1),
    seen_point(Seen, V2, P2),
    doubled(P1, P2, Area1),
    Area is Area0+Area1.

%!  triangles_area(+Triangles, -Area) is semidet.
%
%   Fails if one does not turn left.

triangles_area(Triangles, Area) :-
    seen(Seen),
    foldl(add_triangle(Seen), Triangles, 0, Area).

add_triangle(Seen, t(V1, V2, V3), Area0, Area) :-
    maplist(seen_point(Seen), [V1,V2,V3], Points),
    loop_area(Points, Area1),
    Area1 > 0,
    Area is Area0+Area1.

%   seen(-Seen): which two coordinates are seen, from the polygon's normal.

seen(Seen) :-
    p(1, 1, Es),
    findall(N, ( member(Two, [x-y, y-z, z-x]),
                 projected(Es, Two, N0),
                 N is float(N0)
               ),
            [Nz,Nx,Ny]),
    (   abs(Nx) >= abs(Ny), abs(Nx) >= abs(Nz)
    ->  turned(Nx, y-z, Seen)
    ;   abs(Ny) >= abs(Nz)
    ->  turned(Ny, z-x, Seen)
    ;   turned(Nz, x-y, Seen)
    ).

turned(N, A-B, Seen) :-
    (   N < 0
    ->  Seen = B-A
    ;   Seen = A-B
    ).

projected(Es, Two, Area) :-
    findall(V1-V2, ( member(E, Es), e(1, E, V1, V2, _) ), Pairs),
    foldl(add_edge(Two), Pairs, 0, Area).

seen_point(A-B, V, X-Y) :-
    v(1, V, Vx, Vy, Vz),
    Axes = [x-Vx, y-Vy, z-Vz],
    memberchk(A-X, Axes),
    memberchk(B-Y, Axes).
