:- module(sg_gap,
          [ polygon_gap/5,              % +Facet1, +Facet2, +Most, -Gap, -Ends
            near_misses/3,              % +Pairs, +Reach, -Misses
            gap_reach/2                 % +S, -Reach
          ]).
:- use_module('../csg/csg_rows', [segment_box/2]).
:- use_module('../near', [boxes_near/3, tolerance/2]).
:- use_module('../store', [e/5, t/6]).
:- use_module(triangle_corners, [triangle_corners/5, vertex_place/3]).
:- use_module('../vector',
              [ cross_product/3, difference/3, dot_product/3, left_of/4,
                scaled/3, vector_sum/3 ]).
:- use_module(library(apply), [convlist/3, foldl/4, include/3, maplist/3]).
:- use_module(library(lists), [member/2]).
/** <module> How far apart faces are that were not glued.

What is farther apart than the tolerance is not made to touch. Here is how far
it is, and where, so that a person can say whether that was meant.

    piece(P, A, B, C)    a triangle of polygon P, its corners p(X,Y,Z)
    piece(E, A, B)       an edge of a curve
*/

%!  polygon_gap(+Facet1, +Facet2, +Most, -Gap, -Ends) is semidet.
%
%   Gap is the distance of the polygons Facet1 and Facet2, S-P, and Ends is
%   End1-End2, where they are as near as that. Fails if it is more than Most.
%   Rounded; of polygons that go through each other it is 0 only where a corner
%   or two edges touch.

polygon_gap(S1-P1, S2-P2, Most, Gap, Ends) :-
    findall(Piece, polygon_piece(S1, P1, Piece), Pieces1),
    findall(Piece, polygon_piece(S2, P2, Piece), Pieces2),
    nearest(Pieces1, Pieces2, Most, miss(Gap,_,_,Ends)).

polygon_piece(S, P, piece(P,A,B,C)) :-
    triangle_corners(S, P, A, B, C).

%   nearest(Pieces1, Pieces2, Most, Miss): the first of the nearest. What is
%   farther apart than the nearest until then is not looked at, by its boxes.

nearest(Pieces1, Pieces2, Most, Miss) :-
    maplist(piece_box, Pieces1, Boxes1),
    maplist(piece_box, Pieces2, Boxes2),
    foldl(nearer(Boxes2), Boxes1, within(Most), Miss),
    Miss = miss(_,_,_,_).

nearer(Boxes2, Box1-Piece1, Miss0, Miss) :-
    foldl(nearer(Box1, Piece1), Boxes2, Miss0, Miss).

nearer(Box1, Piece1, Box2-Piece2, Miss0, Miss) :-
    arg(1, Miss0, Most),
    (   boxes_near(Box1, Box2, Most),
        pieces_gap(Piece1, Piece2, Gap, Ends),
        (   Miss0 = within(_)
        ->  Gap =< Most
        ;   Gap < Most
        )
    ->  arg(1, Piece1, Of1),
        arg(1, Piece2, Of2),
        Miss = miss(Gap,Of1,Of2,Ends)
    ;   Miss = Miss0
    ).

piece_box(Piece, box(X1,Y1,Z1,X2,Y2,Z2)-Piece) :-
    extent(1, Piece, X1, X2),
    extent(2, Piece, Y1, Y2),
    extent(3, Piece, Z1, Z2).

extent(Axis, piece(_,A,B,C), Low, High) :-
    !,
    arg(Axis, A, X),
    arg(Axis, B, Y),
    arg(Axis, C, Z),
    Low is min(X, min(Y, Z)),
    High is max(X, max(Y, Z)).
extent(Axis, piece(_,A,B), Low, High) :-
    arg(Axis, A, X),
    arg(Axis, B, Y),
    Low is min(X, Y),
    High is max(X, Y).

%   pieces_gap(Piece1, Piece2, Gap, Ends): a corner and a triangle, or two
%   edges, are the nearest.

pieces_gap(Piece1, Piece2, Gap, Ends) :-
    findall(Gap0-Ends0, features_gap(Piece1, Piece2, Gap0, Ends0), All),
    keysort(All, [Gap-Ends|_]).

features_gap(Piece1, Piece2, Gap, A-B) :-
    corner(Piece1, A),
    over_triangle(Piece2, A, Gap, B).
features_gap(Piece1, Piece2, Gap, A-B) :-
    corner(Piece2, B),
    over_triangle(Piece1, B, Gap, A).
features_gap(Piece1, Piece2, Gap, Ends) :-
    side(Piece1, A, B),
    side(Piece2, C, D),
    sides_gap(A, B, C, D, Gap, Ends).

corner(piece(_,A,B,C), Corner) :-
    member(Corner, [A,B,C]).
corner(piece(_,A,B), Corner) :-
    member(Corner, [A,B]).

side(piece(_,A,B,C), From, To) :-
    member(From-To, [A-B,B-C,C-A]).
side(piece(_,A,B), A, B).

%   over_triangle(Piece, Point, Gap, Foot): Foot is in the triangle, square
%   below Point.

over_triangle(piece(_,A,B,C), Point, Gap, Foot) :-
    difference(B, A, U),
    difference(C, A, W),
    cross_product(U, W, N),
    dot_product(N, N, Square),
    Square > 0,
    difference(Point, A, From),
    dot_product(From, N, Height),
    Down is -Height/Square,
    scaled(Down, N, Way),
    vector_sum(Point, Way, Foot),
    left_of(N, A, B, Foot),
    left_of(N, B, C, Foot),
    left_of(N, C, A, Foot),
    Gap is abs(Height)/sqrt(Square).

%   sides_gap(A, B, C, D, Gap, Ends): of the sides A-B and C-D.

sides_gap(A, B, C, D, Gap, End1-End2) :-
    difference(B, A, U),
    difference(D, C, V),
    difference(A, C, W),
    dot_product(U, U, UU),
    dot_product(V, V, VV),
    dot_product(U, V, UV),
    dot_product(U, W, UW),
    dot_product(V, W, VW),
    UU > 0,
    VV > 0,
    Cross is UU*VV-UV*UV,
    (   Cross > UU*VV*epsilon
    ->  S0 is min(1.0, max(0.0, (UV*VW-VV*UW)/Cross))
    ;   S0 = 0.0
    ),
    T0 is (UV*S0+VW)/VV,
    T is min(1.0, max(0.0, T0)),
    S is min(1.0, max(0.0, (UV*T-UW)/UU)),
    scaled(S, U, Way1),
    vector_sum(A, Way1, End1),
    scaled(T, V, Way2),
    vector_sum(C, Way2, End2),
    difference(End1, End2, Between),
    dot_product(Between, Between, Square),
    Gap is sqrt(Square).

%!  gap_reach(+S, -Reach) is semidet.
%
%   Gaps up to Reach may not be meant in segment S.

gap_reach(S, Reach) :-
    segment_box(S, box(X1,Y1,Z1,X2,Y2,Z2)),
    tolerance(gap, Of),
    Reach is Of*max(X2-X1, max(Y2-Y1, Z2-Z1)).

%!  near_misses(+Pairs:list, +Reach, -Misses:list) is det.
%
%   Misses are miss(S1-Of1, S2-Of2, Gap, End1-End2) of the segments S1-S2 of
%   Pairs that come within Reach: Of is the polygon, of a curve the edge. In the
%   order of Pairs; those 0 apart are none.

near_misses(Pairs, Reach, Misses) :-
    convlist(near_miss(Reach), Pairs, Misses).

near_miss(Reach, S1-S2, miss(S1-Of1,S2-Of2,Gap,Ends)) :-
    segment_box(S1, Box1),
    segment_box(S2, Box2),
    segment_pieces(S1, Box2, Reach, Pieces1),
    Pieces1 \== [],
    segment_pieces(S2, Box1, Reach, Pieces2),
    nearest(Pieces1, Pieces2, Reach, miss(Gap,Of1,Of2,Ends)),
    Gap > 0.

segment_pieces(S, Box, Reach, Pieces) :-
    findall(Piece, segment_piece(S, Piece), Pieces0),
    include(near_box(Box, Reach), Pieces0, Pieces).

segment_piece(S, Piece) :-
    (   t(S, _, _, _, _, _)
    ->  polygon_piece(S, _, Piece)
    ;   Piece = piece(E,A,B),
        e(S, E, V1, V2, _),
        vertex_place(S, V1, A),
        vertex_place(S, V2, B)
    ).

near_box(Box, Reach, Piece) :-
    piece_box(Piece, Of-_),
    boxes_near(Box, Of, Reach).
