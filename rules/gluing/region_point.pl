:- module(sg_region_point,
          [ region_point/3              % +S, +R, -Point
          ]).
:- use_module('../near', [tolerance/2]).
:- use_module('../store', [sides/4]).
:- use_module(triangle_corners, [triangle_corners/5]).
:- use_module('../vector',
              [ cross_product/3, difference/3, dot_product/3, scaled/3,
                vector_sum/3 ]).
:- use_module(library(lists), [last/2, member/2]).
/** <module> A point inside a region.

From the middle of a triangle at the region's border straight in, to the next
face of the region: between the two is nothing but the region. The point is half
way, from where there is most room, of up to sixteen of the largest triangles.
*/

%!  region_point(+S, +R, -Point) is semidet.
%
%   Point, p(X,Y,Z), lies inside region R of segment S, as far from the faces as
%   it was easy to find. Fails of a region without end, or without volume.

region_point(S, R, Point) :-
    findall(triangle(A,B,C), region_triangle(S, R, A, B, C), Triangles),
    findall(Area-in(Corners,Middle,Normal),
            ( border_triangle(S, R, Corners),
              middle(Corners, Middle, Normal, Area) ),
            Starts0),
    sort(1, @>=, Starts0, Starts),
    largest(16, Starts, Large),
    findall(Room-Point0,
            ( member(_-Start, Large),
              half_way(Start, Triangles, Room, Point0) ),
            Points0),
    keysort(Points0, Points),
    last(Points, _-Point).

largest(N, List0, List) :-
    (   N > 0,
        List0 = [X|Rest0]
    ->  List = [X|Rest],
        N1 is N-1,
        largest(N1, Rest0, Rest)
    ;   List = []
    ).

%   region_triangle(S, R, A, B, C): of any face that R is beside.

region_triangle(S, R, A, B, C) :-
    (   sides(S, P, R, _)
    ;   sides(S, P, Below, R),
        Below =\= R
    ),
    triangle_corners(S, P, A, B, C).

%   border_triangle(S, R, Corners): so turned that its normal points into R.

border_triangle(S, R, c(A,C,B)) :-
    sides(S, P, R, Above),
    Above =\= R,
    triangle_corners(S, P, A, B, C).
border_triangle(S, R, c(A,B,C)) :-
    sides(S, P, Below, R),
    Below =\= R,
    triangle_corners(S, P, A, B, C).

%   middle(Corners, Middle, Normal, Square): Square grows with the area; none of
%   a triangle without area.

middle(c(A,B,C), Middle, Normal, Square) :-
    difference(B, A, U),
    difference(C, A, W),
    cross_product(U, W, Normal),
    dot_product(Normal, Normal, Square),
    Square > 0,
    vector_sum(A, B, Two),
    vector_sum(Two, C, Three),
    scaled(1r3, Three, Exact),
    Exact = p(X0,Y0,Z0),
    X is float(X0),
    Y is float(Y0),
    Z is float(Z0),
    Middle = p(X,Y,Z).

%   half_way(Start, Triangles, Room, Point): Room is how far it is to the next
%   face, in parts of the normal times its length.

half_way(in(Corners,Middle,Normal), Triangles, Room, Point) :-
    findall(At, ( member(Triangle, Triangles),
                  \+ same_corners(Corners, Triangle),
                  hit(Middle, Normal, Triangle, At) ),
            Ats0),
    sort(Ats0, [At|_]),
    Half is At/2,
    scaled(Half, Normal, Way),
    vector_sum(Middle, Way, Point),
    dot_product(Way, Way, Square),
    Room is sqrt(Square).

same_corners(c(A,B,C), triangle(D,E,F)) :-
    msort([A,B,C], Corners),
    msort([D,E,F], Corners).

%   hit(From, Way, Triangle, At): From + At*Way lies in the triangle, or so near
%   that rounding does not tell; At is above 0.

hit(From, Way, triangle(A,B,C), At) :-
    difference(B, A, U),
    difference(C, A, W),
    cross_product(Way, W, Square),
    dot_product(U, Square, Volume),
    Volume =\= 0,
    difference(From, A, T),
    dot_product(T, Square, P0),
    P is P0/Volume,
    tolerance(rounding, Near),
    P >= -Near,
    P =< 1+Near,
    cross_product(T, U, Q0),
    dot_product(Way, Q0, R0),
    R is R0/Volume,
    R >= -Near,
    P+R =< 1+Near,
    dot_product(W, Q0, At0),
    At is At0/Volume,
    At > 0.
