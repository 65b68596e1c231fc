:- module(sg_region,
          [ region_islands/2,           % +Region, -Islands
            region_moved/3              % +Matrix, +Region0, -Region
          ]).
:- use_module(box_tree,
              [box_tree/2, boxes_meet/2, points_box/2, tree_fold/5]).
:- use_module(planar_map, [planar_map/2, map_border/3, map_point/3]).
:- use_module(library(apply),
              [ convlist/3, exclude/3, foldl/4, foldl/5, foldl/6, maplist/2,
                maplist/3, partition/4
              ]).
:- use_module(library(assoc),
              [empty_assoc/1, get_assoc/3, ord_list_to_assoc/2, put_assoc/4]).
:- use_module(library(lists),
              [ append/2, append/3, last/2, max_list/2, member/2, nth1/3,
                reverse/2
              ]).
/** <module> Regions of the plane: Boolean operations on polygons.

A region is

    loops([Loop, ...])         what the loops, lists of X-Y, go round oddly
                               often
    union([Region, ...])   intersection([Region, ...])
    difference([Region, ...])  the first without the others

Its border is found exactly, all edges at once (planar_map.pl), and rounded
once; if rounding makes anything cross, that is resolved in the same way.
*/

%!  region_moved(+Matrix, +Region0, -Region) is det.
%
%   Region is Region0 after X' = A*X + B*Y + C, Y' = D*X + E*Y + F, with Matrix
%   = [[A, B, C], [D, E, F]]. Rounded.

region_moved(Matrix, loops(Loops0), Region) :-
    !,
    Region = loops(Loops),
    maplist(maplist(point_moved(Matrix)), Loops0, Loops).
region_moved(Matrix, Region0, Region) :-
    Region0 =.. [Operation, Regions0],
    maplist(region_moved(Matrix), Regions0, Regions),
    Region =.. [Operation, Regions].

point_moved([[A, B, C], [D, E, F]], X0-Y0, X-Y) :-
    X is A*X0 + B*Y0 + C + 0.0,
    Y is D*X0 + E*Y0 + F + 0.0.

%!  region_islands(+Region, -Islands) is det.
%
%   Islands are the parts of Region that are connected, each island(Outline,
%   Holes, Bays): Outline a counter-clockwise loop, Holes the clockwise loops of
%   its holes. Bays are those of holes that touch another loop in a point. No
%   loop meets itself, and no three points in a row are on one line. Of a region
%   without area, none; splinters no wider than 2^-33 of how far the region
%   reaches, which rounding leaves where figures were to meet, are passed over.

region_islands(Region, Islands) :-
    region_loops(Region, 5, Loops0),
    splinter_width(Loops0, Width),
    exclude(is_splinter(Width), Loops0, Loops),
    partition(counter_clockwise, Loops, Outlines, Holes),
    islands(Outlines, Holes, Islands).

counter_clockwise(loop(Points, _, _)) :-
    area2(Points, Area),
    Area > 0.

splinter_width(Loops, Width) :-
    findall(Reach,
            ( member(loop(Points, _, _), Loops),
              member(p(X, Y), Points),
              Reach is max(abs(X), abs(Y)) ),
            Reaches),
    max_list([0|Reaches], Most),
    Width is float(Most)*2.0** -33.

%   is_splinter(Width, Loop): the area is that of a strip as long as half the
%   way round, and no wider than Width.

is_splinter(Width, loop(Points, _, _)) :-
    area2(Points, Area),
    last(Points, Last),
    foldl(with_length, Points, Last-0.0, _-Length),
    abs(float(Area)) =< Width*Length.

with_length(P, p(X0, Y0)-Length0, P-Length) :-
    P = p(X, Y),
    Length is Length0 + sqrt(float((X-X0)**2 + (Y-Y0)**2)).

%   region_loops(Region, Rounds, Loops): Loops are loop(Points, Touching,
%   Middle): points of rationals that are floats; whether it touches; a point of
%   it that no other loop has.

region_loops(Region, Rounds, Loops) :-
    figures(Region, Figures, Inside),
    planar_map(Figures, Map),
    map_border(Map, holds(Inside), Cycles),
    maplist(simple_cycles, Cycles, Simple0),
    append(Simple0, Simple),
    shared_points(Simple, Shared),
    maplist(cycle_loop(Map, Shared), Simple, Loops0),
    (   Rounds > 0,
        member(loop(Points, _, _), Loops0),
        \+ maplist(is_rounded, Points)
    ->  maplist(rounded_loop, Loops0, Rounded),
        Rounds1 is Rounds-1,
        region_loops(loops(Rounded), Rounds1, Loops)
    ;   Loops = Loops0
    ).

is_rounded(p(X, Y)) :-
    rational(float(X)) =:= X,
    rational(float(Y)) =:= Y.

rounded_loop(loop(Points, _, _), Loop) :-
    maplist(rounded_point, Points, Loop).

rounded_point(p(X0, Y0), X-Y) :-
    X is float(X0) + 0.0,
    Y is float(Y0) + 0.0.


                /*******************************
                *            INSIDE            *
                *******************************/

%   figures(Region, Figures, Inside): Figures are the leaves of Region, and
%   Inside says with their bits what is inside: all(Mask, Others),
%   any(Mask, Others), minus(One, Other).

figures(Region, Figures, Inside) :-
    inside(Region, Inside, 0, _, Figures, []).

inside(loops(Loops), all(Mask, []), N0, N, [Loops|Figures], Figures) :-
    Mask is 1<<N0,
    N is N0+1.
inside(union(Regions), any(Mask, Others), N0, N, Figures0, Figures) :-
    insides(Regions, Insides, N0, N, Figures0, Figures),
    gathered(Insides, Mask, Others).
inside(intersection(Regions), all(Mask, Others), N0, N, Figures0, Figures) :-
    insides(Regions, Insides, N0, N, Figures0, Figures),
    gathered(Insides, Mask, Others).
inside(difference([First|Rest]), minus(Inside1, any(Mask, Others)), N0, N,
       Figures0, Figures) :-
    inside(First, Inside1, N0, N1, Figures0, Figures1),
    insides(Rest, Insides, N1, N, Figures1, Figures),
    gathered(Insides, Mask, Others).

insides([], [], N, N, Figures, Figures).
insides([Region|Regions], [Inside|Insides], N0, N, Figures0, Figures) :-
    inside(Region, Inside, N0, N1, Figures0, Figures1),
    insides(Regions, Insides, N1, N, Figures1, Figures).

%   gathered(Insides, Mask, Others): the leaves in one mask.

gathered(Insides, Mask, Others) :-
    partition(is_leaf, Insides, Leaves, Others),
    foldl(with_mask, Leaves, 0, Mask).

is_leaf(all(Mask, [])) :-
    Mask /\ (Mask-1) =:= 0.

with_mask(all(Mask, _), Mask0, Mask1) :-
    Mask1 is Mask0 \/ Mask.

%   holds(Inside, Bits)

holds(all(Mask, Others), Bits) :-
    Bits /\ Mask =:= Mask,
    \+ ( member(Other, Others), \+ holds(Other, Bits) ).
holds(any(Mask, Others), Bits) :-
    (   Bits /\ Mask =\= 0
    ->  true
    ;   member(Other, Others),
        holds(Other, Bits)
    ->  true
    ).
holds(minus(One, Other), Bits) :-
    holds(One, Bits),
    \+ holds(Other, Bits).


                /*******************************
                *             LOOPS            *
                *******************************/

%   simple_cycles(Cycle, Cycles): at a point where it comes by again, a cycle is
%   two.

simple_cycles(Cycle, Cycles) :-
    shared_points([Cycle], Shared),
    (   empty_assoc(Shared)
    ->  Cycles = [Cycle]
    ;   simple(Cycle, Shared, [], Cycles)
    ).

%   simple(Vs, Times, Path, Cycles): Path is the way so far, the last point
%   first. Times has how often points that come again are on it.

simple([], _, Path, [Cycle]) :-
    reverse(Path, Cycle).
simple([V|Vs], Times0, Path0, Cycles) :-
    (   get_assoc(V, Times0, 1)
    ->  once(append(Before, [V|Path], Path0)),
        foldl(off_path, Before, Times0, Times),
        reverse([V|Before], Cycle),
        Cycles = [Cycle|Cycles1],
        simple(Vs, Times, [V|Path], Cycles1)
    ;   on_path(V, 1, Times0, Times),
        simple(Vs, Times, [V|Path0], Cycles)
    ).

off_path(V, Times0, Times) :-
    on_path(V, 0, Times0, Times).

on_path(V, N, Times0, Times) :-
    (   get_assoc(V, Times0, _)
    ->  put_assoc(V, Times0, N, Times)
    ;   Times = Times0
    ).

%   shared_points(Cycles, Shared): the points that are there more than once, as
%   keys; of value 0.

shared_points(Cycles, Shared) :-
    append(Cycles, Vs0),
    msort(Vs0, Vs),
    repeated(Vs, Repeated0),
    sort(Repeated0, Repeated),
    ord_list_to_assoc(Repeated, Shared).

repeated([V, V|Vs], [V-0|Repeated]) :-
    !,
    repeated([V|Vs], Repeated).
repeated([_|Vs], Repeated) :-
    !,
    repeated(Vs, Repeated).
repeated([], []).

cycle_loop(Map, Shared, Vs, loop(Points, Touching, Middle)) :-
    (   member(V, Vs),
        get_assoc(V, Shared, _)
    ->  Touching = true
    ;   Touching = false
    ),
    maplist(map_point(Map), Vs, Points0),
    Points0 = [p(X1, Y1), p(X2, Y2)|_],
    Middle = p(X, Y),
    X is (X1+X2) rdiv 2,
    Y is (Y1+Y2) rdiv 2,
    without_straight(Points0, Points).

%   without_straight(Points0, Points): without points between their neighbours.

without_straight(Points0, Points) :-
    last(Points0, Last),
    Points0 = [First|_],
    append(Points0, [First], Round),
    bends(Round, Last, Points).

bends([P, Q|Round], Before, Points) :-
    !,
    (   side(Before, P, Q, 0)
    ->  Points = Points1
    ;   Points = [P|Points1]
    ),
    bends([Q|Round], P, Points1).
bends(_, _, []).

side(p(X1, Y1), p(X2, Y2), p(X3, Y3), Sign) :-
    Sign is sign((X2-X1)*(Y3-Y1) - (Y2-Y1)*(X3-X1)).

area2(Points, Area) :-
    last(Points, Last),
    foldl(trapezoid, Points, Last-0, _-Area).

trapezoid(P, p(X0, Y0)-Area0, P-Area) :-
    P = p(X, Y),
    Area is Area0 + X0*Y - X*Y0.


                /*******************************
                *            ISLANDS           *
                *******************************/

%   islands(Outlines, Holes, Islands): each hole belongs to the least outline
%   round it; to none, if that was a splinter.

islands(Outlines, Holes, Islands) :-
    (   Holes == []
    ->  Items = []
    ;   findall(Box-outline(N, Area, Sides),
                ( nth1(N, Outlines, loop(Points, _, _)),
                  area2(Points, Area),
                  points_box(Points, Box),
                  side_tree(Points, Sides) ),
                Items)
    ),
    box_tree(Items, Tree),
    convlist(hole_place(Tree), Holes, Places0),
    keysort(Places0, Places),
    islands(Outlines, 1, Places, Islands).

islands([], _, _, []).
islands([loop(Points, _, _)|Outlines], N, Places0, [Island|Islands]) :-
    places_of(Places0, N, Holes, Places),
    island(Points, Holes, Island),
    N1 is N+1,
    islands(Outlines, N1, Places, Islands).

places_of([N-Hole|Places0], N, [Hole|Holes], Places) :-
    !,
    places_of(Places0, N, Holes, Places).
places_of(Places, _, [], Places).

hole_place(Tree, Hole, N-Hole) :-
    Hole = loop(_, _, Middle),
    points_box([Middle], Box),
    tree_fold(Tree, is_beside(Box), least_round(Middle), none,
              outline(N, _, _)).

is_beside(Box, Box2, _) :-
    \+ boxes_meet(Box, Box2).

least_round(Point, Outline, Least0, Least) :-
    Outline = outline(_, Area, Sides),
    (   (   Least0 = outline(_, Area0, _)
        ->  Area < Area0
        ;   true
        ),
        goes_round(Sides, Point)
    ->  Least = Outline
    ;   Least = Least0
    ).

%   side_tree(Points, Tree): of A-B, the sides of a loop.

side_tree(Points, Tree) :-
    last(Points, Last),
    foldl(side_item, Points, Items, Last, _),
    box_tree(Items, Tree).

side_item(B, Box-(A-B), A, B) :-
    points_box([A, B], Box).

%   goes_round(Sides, Point): a ray to the right leaves what they go round.

goes_round(Sides, Point) :-
    points_box([Point], Box),
    tree_fold(Sides, is_off_ray(Box), ray_crossed(Point), 0, Count),
    Count mod 2 =:= 1.

is_off_ray(b(X, Y1, _, Y2), b(_, Y3, X4, Y4), _) :-
    (   X4 < X
    ->  true
    ;   Y4 < Y1
    ->  true
    ;   Y3 > Y2
    ).

ray_crossed(P, A-B, Count0, Count) :-
    P = p(_, Y),
    A = p(_, Y1),
    B = p(_, Y2),
    (   Y1 =< Y, Y < Y2,
        side(A, B, P, 1)
    ->  Count is Count0+1
    ;   Y2 =< Y, Y < Y1,
        side(A, B, P, -1)
    ->  Count is Count0+1
    ;   Count = Count0
    ).

island(Points, Places, island(Outline, Holes, Bays)) :-
    maplist(rounded_point, Points, Outline),
    findall(Hole, member(loop(Hole, false, _), Places), Holes0),
    findall(Hole, member(loop(Hole, true, _), Places), Bays0),
    maplist(maplist(rounded_point), Holes0, Holes),
    maplist(maplist(rounded_point), Bays0, Bays).
