:- module(sg_csg_half_space,
          [ half_space/3                % +Plane, +Box, -Half
          ]).
:- use_module('../vector', [cross_product/3, scaled/3, unit/2, vector_sum/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(yall), [(>>)/4]).
/** <module> A half-space as a solid that is large enough.

To split a solid by a plane it is cut with a tetrahedron: one face lies in the
plane, and all of the solid that is below the plane is inside.

The corners of that face are rounded, so the plane through them is off the
given one by less than 2^-48 of the solid's size; a plane square to an axis is
met exactly if its place on the axis is a double. The face is one triangle, so
it is flat whatever the rounding.

@see row DV-3
*/

%!  half_space(+Plane, +Box, -Half) is det.
%
%   Half is a primitive, polyhedron(...), for what is below Plane = plane(A, B,
%   C, D) (rationals) within Box; or `all` or `none`, if Plane passes Box at a
%   distance.

half_space(plane(A0,B0,C0,D0), box(X1,Y1,Z1,X2,Y2,Z2), Half) :-
    Most is max(abs(A0), max(abs(B0), abs(C0))),
    maplist(divided(Most), [A0,B0,C0,D0], [A,B,C,D]),
    maplist(middle, [X1-X2, Y1-Y2, Z1-Z2], [X,Y,Z]),
    R is max(sqrt((X2-X1)**2 + (Y2-Y1)**2 + (Z2-Z1)**2)*0.55, 1.0e-80),
    Length is sqrt(float(A*A + B*B + C*C)),
    Height is float(A*rational(X) + B*rational(Y) + C*rational(Z) + D)/Length,
    (   Height > R
    ->  Half = none
    ;   Height < -R
    ->  Half = all
    ;   maplist(part(Length), [A,B,C], [NX,NY,NZ]),
        tetrahedron(p(NX,NY,NZ), plane(A,B,C,D), p(X,Y,Z), Height, R, Half)
    ).

%   divided(Divisor, N, Quotient): exactly, so that floats hold the squares.

divided(Divisor, N, Quotient) :-
    Quotient is N rdiv Divisor.

middle(Low-High, Middle) :-
    Middle is (Low+High)/2.0.

part(Length, A, X) :-
    X is float(A)/Length.

%   tetrahedron(N, Plane, Centre, Height, R, Half): its face is the triangle in
%   Plane round the foot of Centre with a circle of radius 2 R in it; its apex
%   lies 5 R below. So a ball of radius R round Centre is inside, as far as it
%   is below Plane.

tetrahedron(N, Plane, Centre, Height, R, Half) :-
    frame(N, U, V),
    Foot is -Height,
    along(Centre, Foot, N, Middle),
    Far is 4.0*R,
    Near is -2.0*R,
    Wide is 2.0*sqrt(3.0)*R,
    Back is -Wide,
    maplist(corner(Plane, Middle, U, V), [Far-0.0, Near-Wide, Near-Back],
            [P1,P2,P3]),
    Deep is -5.0*R,
    along(Middle, Deep, N, p(X4,Y4,Z4)),
    Half = polyhedron(points([P1,P2,P3,[X4,Y4,Z4]]),
                      faces([[1,2,3], [1,4,2], [2,4,3], [3,4,1]])).

%   frame(N, U, V): unit vectors with U x V = N. U is square to the axis that N
%   has least of.

frame(N, U, V) :-
    N = p(A, B, C),
    (   abs(A) =< abs(B),
        abs(A) =< abs(C)
    ->  Square = p(0.0, C, MinusB),
        MinusB is -B
    ;   abs(B) =< abs(C)
    ->  Square = p(MinusC, 0.0, A),
        MinusC is -C
    ;   Square = p(B, MinusA, 0.0),
        MinusA is -A
    ),
    unit(Square, U),
    cross_product(N, U, V).

along(P, T, Way, Q) :-
    scaled(T, Way, Step),
    vector_sum(P, Step, Q).

%   corner(Plane, Middle, U, V, S-T, Corner): brought into Plane along the axis
%   that is nearest to its normal, exactly except for the rounding of that
%   coordinate.

corner(plane(A,B,C,D), Middle, U, V, S-T, Corner) :-
    along(Middle, S, U, M),
    along(M, T, V, p(X0,Y0,Z0)),
    maplist([N,F]>>(F is rational(N)), [X0,Y0,Z0], [X,Y,Z]),
    (   abs(C) >= abs(A),
        abs(C) >= abs(B)
    ->  Z1 is float(-(A*X + B*Y + D)/C) + 0.0,
        Corner = [X0,Y0,Z1]
    ;   abs(B) >= abs(A)
    ->  Y1 is float(-(A*X + C*Z + D)/B) + 0.0,
        Corner = [X0,Y1,Z0]
    ;   X1 is float(-(B*Y + C*Z + D)/A) + 0.0,
        Corner = [X1,Y0,Z0]
    ).
