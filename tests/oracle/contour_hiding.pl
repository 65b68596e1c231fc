:- module(sg_oracle_contour_hiding,
          [ hiding_triangles/3          % +S, +T, -Triangles
          ]).
:- use_module('../../rules/picture/contour',
              [contour_ends/4, dividing_piece/3]).
:- use_module('../../rules/store', [contour/13, screen/5, t/6]).
:- use_module(library(lists), [member/2]).
/** <module> What hides lines near the outline of a smooth surface.

An outline that has risen to a known surface (contour.pl) runs in the picture
beside the triangle that it crosses, as the surface does. What hides lines there
is the surface: instead of such a triangle hide the three that the two ends of
the piece divide it into. Neighbours have the same ends; so what hides ends
where the outline runs, and a line that passes behind the surface ends there.

A triangle that two pieces cross, by way of a corner of it, hides as either of
them divides it. The join occluder/7 keeps to this; the fused kernel is
c_kernels/picture/scene_divided.c.
*/

:- set_prolog_flag(optimise, true).

%!  hiding_triangles(+S, +T, -Triangles) is det.
%
%   Triangles, each a list of three places X-Y of the picture, hide lines as
%   triangle T of segment S: itself, or what the outline divides it into.

hiding_triangles(S, T, Triangles) :-
    t(S, _, T, A, B, C),
    Corners = t(A,B,C),
    findall(Part, ( dividing_piece(S, T, K), part(S, Corners, K, Part) ),
            Parts),
    (   Parts == []
    ->  findall(Place, ( member(I, [1,2,3]), corner_place(S, Corners, I, Place)
                       ),
                Places),
        Triangles = [Places]
    ;   Triangles = Parts
    ).

%   P is the corner that the piece parts from Q and R; it crosses the side from
%   P to Q at A, that from R to P at B.

part(S, Corners, K, Part) :-
    contour(S, K, _, I1, _, I2, _, _, _, _, _, _, _),
    contour_ends(S, K, Start, End),
    (   I1 =:= I2 mod 3 + 1
    ->  I = I1, A = Start, B = End
    ;   I = I2, A = End, B = Start
    ),
    J is I mod 3 + 1,
    L is J mod 3 + 1,
    corner_place(S, Corners, I, P),
    corner_place(S, Corners, J, Q),
    corner_place(S, Corners, L, R),
    (   Part = [A,B,P]
    ;   beyond(A, B, Q, R, Part)
    ).

%   The two triangles beyond the piece, parted from A to R, or, if only then
%   they do not fold, from B to Q.

beyond(A, B, Q, R, Part) :-
    (   \+ turn_alike(A, Q, R, B),
        turn_alike(B, A, Q, R)
    ->  member(Part, [[B,A,Q], [B,Q,R]])
    ;   member(Part, [[A,Q,R], [A,R,B]])
    ).

turn_alike(A, B, C, D) :-
    left_turn(A, B, C, One),
    left_turn(A, C, D, Other),
    One == Other.

left_turn(X1-Y1, X2-Y2, X3-Y3, Left) :-
    (   (X2-X1)*(Y3-Y1) - (Y2-Y1)*(X3-X1) > 0.0
    ->  Left = true
    ;   Left = false
    ).

corner_place(S, Corners, I, X-Y) :-
    arg(I, Corners, V),
    screen(S, V, X, Y, _).
