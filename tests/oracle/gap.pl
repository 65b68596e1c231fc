:- module(sg_oracle_gap,
          [ segments_gap/3              % +S1, +S2, -Gap
          ]).
:- use_module('../../rules/gluing/triangle_corners',
              [triangle_corners/5, vertex_place/3]).
:- use_module('../../rules/store', [e/5, t/6]).
:- use_module('../../rules/vector',
              [ cross_product/3, difference/3, dot_product/3, left_of/4,
                scaled/3, vector_sum/3 ]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(lists), [member/2]).
/** <module> How far two segments are apart: of each two of their pieces.

c_kernels/gluing/gap.c is the kernel.

    piece(P, A, B, C)    a triangle of polygon P, its corners p(X,Y,Z)
    piece(E, A, B)       an edge of a curve
*/

%!  segments_gap(+S1, +S2, -Gap) is det.
%
%   Gap is how far the segments S1 and S2 are apart. Rounded.

segments_gap(S1, S2, Gap) :-
    findall(Piece, segment_piece(S1, Piece), Pieces1),
    findall(Piece, segment_piece(S2, Piece), Pieces2),
    aggregate_all(min(Gap0),
                  ( member(Piece1, Pieces1),
                    member(Piece2, Pieces2),
                    features_gap(Piece1, Piece2, Gap0) ),
                  Gap).

segment_piece(S, Piece) :-
    (   t(S, _, _, _, _, _)
    ->  Piece = piece(P,A,B,C),
        triangle_corners(S, P, A, B, C)
    ;   Piece = piece(E,A,B),
        e(S, E, V1, V2, _),
        vertex_place(S, V1, A),
        vertex_place(S, V2, B)
    ).

%   features_gap(Piece1, Piece2, Gap) is nondet: a corner and a triangle, or two
%   edges, are the nearest.

features_gap(Piece1, Piece2, Gap) :-
    corner(Piece1, A),
    over_triangle(Piece2, A, Gap).
features_gap(Piece1, Piece2, Gap) :-
    corner(Piece2, B),
    over_triangle(Piece1, B, Gap).
features_gap(Piece1, Piece2, Gap) :-
    side(Piece1, A, B),
    side(Piece2, C, D),
    sides_gap(A, B, C, D, Gap).

corner(piece(_,A,B,C), Corner) :-
    member(Corner, [A,B,C]).
corner(piece(_,A,B), Corner) :-
    member(Corner, [A,B]).

side(piece(_,A,B,C), From, To) :-
    member(From-To, [A-B,B-C,C-A]).
side(piece(_,A,B), A, B).

%   over_triangle(Piece, Point, Gap): Point is square above the triangle.

over_triangle(piece(_,A,B,C), Point, Gap) :-
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

%   sides_gap(A, B, C, D, Gap): of the sides A-B and C-D.

sides_gap(A, B, C, D, Gap) :-
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
