:- module(test_region, []).
% covers: planar_map
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(polygon/region)).
:- use_module(tests('rules/sample')).

square(X, Y, A, loops([[X-Y, X1-Y, X1-Y1, X-Y1]])) :-
    X1 is X+A,
    Y1 is Y+A.

islands(Region, Sorted) :-
    region_islands(Region, Islands),
    msort(Islands, Sorted).

area(Region, Area) :-
    region_islands(Region, Islands),
    findall(A, ( member(island(Outline, Holes, Bays), Islands),
                 ( member(Loop, [Outline|Holes]) ; member(Loop, Bays) ),
                 loop_area(Loop, A) ),
            As),
    sum_list(As, Area).

loop_area(Loop, Area) :-
    last(Loop, Last),
    foldl(slab, Loop, Last-0, _-Area).

slab(X-Y, (X0-Y0)-A0, (X-Y)-A) :-
    A is A0 + (rational(X0)*rational(Y) - rational(X)*rational(Y0)) / 2.

:- begin_tests(region).

test(beside_each_other, Islands ==
     [island([0.0-0.0, 2.0-0.0, 2.0-1.0, 0.0-1.0], [], [])]) :-
    square(0, 0, 1, A),
    square(1, 0, 1, B),
    islands(union([A, B]), Islands).
test(touching_in_a_point, N == 2) :-
    square(0, 0, 1, A),
    square(1, 1, 1, B),
    islands(union([A, B]), Islands),
    length(Islands, N).
test(hole, Islands ==
     [island([0.0-0.0, 3.0-0.0, 3.0-3.0, 0.0-3.0],
             [[1.0-2.0, 2.0-2.0, 2.0-1.0, 1.0-1.0]], [])]) :-
    square(0, 0, 3, A),
    square(1, 1, 1, B),
    islands(difference([A, B]), Islands).
test(bay, [Holes, Bays] == [[], [[2.0-2.0, 2.0-1.0, 1.0-1.0, 1.0-2.0]]]) :-
    square(0, 0, 3, A),
    square(1, 1, 1, B),
    square(0, 2, 1, C),
    islands(difference([A, B, C]), [island(_, Holes, Bays)]).
test(island_in_a_hole, [N, Area] == [2, 33r4]) :-
    square(0, 0, 3, A),
    square(1, 1, 1, B),
    square(1.25, 1.25, 0.5, C),
    Region = union([difference([A, B]), C]),
    islands(Region, Islands),
    length(Islands, N),
    area(Region, Area).
test(hole_of_the_inner_one, Corners == [(0.0-0.0)-(1.0-8.0),
                                        (2.0-2.0)-(3.0-6.0)]) :-
    findall(S, ( member(I-A, [0-9, 1-7, 2-5, 3-3]), square(I, I, A, S) ),
            [S9, S7, S5, S3]),
    islands(union([difference([S9, S7]), difference([S5, S3])]), Islands),
    findall(P-Q, member(island([P|_], [[Q|_]], []), Islands), Corners).
test(crossing_itself, Area == 1r2) :-
    Region = loops([[0-0, 1-1, 1-0, 0-1]]),
    islands(Region, [_, _]),
    area(Region, Area).
test(oddly, Area == 8) :-
    square(0, 0, 3, loops([A])),
    square(1, 1, 1, loops([B])),
    area(loops([A, B]), Area).
test(twice_is_not, Islands == []) :-
    square(0, 0, 3, loops([A])),
    islands(loops([A, A]), Islands).
test(nothing_left, Islands == []) :-
    square(0, 0, 3, A),
    islands(difference([A, A]), Islands).
test(touching_from_outside, Islands == []) :-
    square(0, 0, 3, A),
    square(3, 0, 3, B),
    islands(intersection([A, B]), Islands).
test(splinter) :-
    Splinter = loops([[5.0-0.0, 5.000000000000001-1.0, 5.0-2.0]]),
    Hole = loops([[0.5-0.5, 0.5000000000000001-1.0, 0.5-2.0]]),
    square(0, 0, 3, A),
    islands(union([difference([A, Hole]), Splinter]), [island(_, [], [])]),
    islands(Splinter, []).
test(no_splinter, N == 1) :-
    islands(loops([[5.0-0.0, 5.0001-1.0, 5.0-2.0]]), Islands),
    length(Islands, N).
test(moved, Area =:= 18) :-
    square(0, 0, 3, A),
    region_moved([[1, 1, 7], [-1, 1, 3]], A, B),
    area(B, Area).

% Squares on a coarse grid, so that they touch: area(A)+area(B) is that of union
% and intersection; A-B, B-A and the intersection make the union.
test(random, [ setup(set_random(seed(1988))),
               forall(numbered(70, 200, _)) ]) :-
    random_region(A),
    random_region(B),
    maplist(area, [A, B, union([A, B]), intersection([A, B]),
                   difference([A, B]), difference([B, A])],
            [AA, AB, AU, AI, AD1, AD2]),
    AA+AB =:= AU+AI,
    AU =:= AD1+AD2+AI.

% Turned ones: what is found does not meet itself, so it is found again.
test(turned, [ setup(set_random(seed(1989))),
               forall(numbered(20, 60, _)) ]) :-
    random_turned(A),
    random_turned(B),
    random_turned(C),
    islands(union([difference([A, B]), C]), Islands),
    findall(Loop, ( member(island(Outline, Holes, Bays), Islands),
                    ( member(Loop, [Outline|Holes]) ; member(Loop, Bays) ) ),
            Loops),
    islands(loops(Loops), Again),
    same_points(Islands, Again).

% Cells of a chessboard, some of them there: all corners lie at the heights of
% others. Islands are the cells that are connected by sides, no hole is lost.
test(cells, [ setup(set_random(seed(1990))),
              forall(numbered(40, 120, I)) ]) :-
    Share is 0.3+0.1*(I mod 6),
    findall(X-Y, ( between(1, 6, X), between(1, 6, Y), maybe(Share) ), Cells),
    findall(S, ( member(X-Y, Cells), square(X, Y, 1, S) ), Squares),
    region_islands(union(Squares), Islands),
    findall(A, ( member(Island, Islands), island_area(Island, A) ), As0),
    msort(As0, As),
    patches(Cells, Sizes0),
    msort(Sizes0, Sizes),
    maplist([A,N]>>( A =:= N ), As, Sizes),
    forall(member(island(Outline, Holes, Bays), Islands),
           forall(( member(Hole, Holes) ; member(Hole, Bays) ),
                  within(Hole, Outline))).
% The same, taken out of a plate.
test(cells_out, [ setup(set_random(seed(1991))),
                  forall(numbered(20, 60, _)) ]) :-
    findall(X-Y, ( between(1, 6, X), between(1, 6, Y), maybe(0.35) ), Cells),
    findall(S, ( member(X-Y, Cells), square(X, Y, 1, S) ), Squares),
    square(0, 0, 8, Plate),
    region_islands(difference([Plate|Squares]), Islands),
    findall(A, ( member(Island, Islands), island_area(Island, A) ), As),
    sum_list(As, Area),
    length(Cells, N),
    Area =:= 64-N.

island_area(island(Outline, Holes, Bays), Area) :-
    append([[Outline],Holes,Bays], Loops),
    maplist(loop_area, Loops, As),
    sum_list(As, Area).

% Every corner lies in the box of the outline.
within(Hole, Outline) :-
    pairs_keys_values(Hole, Xs, Ys),
    pairs_keys_values(Outline, Us, Vs),
    maplist(min_list, [Xs,Ys,Us,Vs], [X0,Y0,U0,V0]),
    maplist(max_list, [Xs,Ys,Us,Vs], [X1,Y1,U1,V1]),
    X0 >= U0, Y0 >= V0, X1 =< U1, Y1 =< V1.

% How many cells are connected, patch by patch.
patches([], []).
patches([Cell|Cells], [Size|Sizes]) :-
    patch([Cell], Cells, Left, 0, Size),
    patches(Left, Sizes).

patch([], Left, Left, Size, Size).
patch([X-Y|Rest], Cells, Left, Size0, Size) :-
    findall(U-V, ( member(DX-DY, [1-0,-1-0,0-1,0-(-1)]),
                   U is X+DX, V is Y+DY, memberchk(U-V, Cells) ), Next),
    subtract(Cells, Next, Cells1),
    append(Next, Rest, Rest1),
    Size1 is Size0+1,
    patch(Rest1, Cells1, Left, Size1, Size).

same_points(Islands1, Islands2) :-
    all_points(Islands1, Points),
    all_points(Islands2, Points).

all_points(Islands, Points) :-
    findall(P, ( member(island(Outline, Holes, Bays), Islands),
                 ( member(Loop, [Outline|Holes]) ; member(Loop, Bays) ),
                 member(P, Loop) ),
            Points0),
    sort(Points0, Points).

random_region(union(Squares)) :-
    random_between(1, 5, N),
    findall(S, ( between(1, N, _), random_between(0, 6, X),
                 random_between(0, 6, Y), random_between(1, 4, A),
                 square(X, Y, A, S) ),
            Squares).

random_turned(Region) :-
    random_region(Region0),
    random(Angle),
    Cos is cos(Angle),
    Sin is sin(Angle),
    Minus is -Sin,
    region_moved([[Cos, Minus, 0.3], [Sin, Cos, 0.1]], Region0, Region).

:- end_tests(region).
