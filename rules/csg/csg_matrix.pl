:- module(sg_csg_matrix,
          [ identity_matrix/1,          % -Matrix
            steps_matrix/2,             % +Steps, -Matrix
            matrix_product/3,           % +Matrix1, +Matrix2, -Matrix
            matrix_sign/2,              % +Matrix, -Sign
            matrix_plane/3,             % +Matrix, +Plane0, -Plane
            rounded_matrix/2,           % +Matrix, -Rounded
            matrix_scale/2              % +Matrix, -Scale
          ]).
:- use_module('../primitive/placing', [step_motion/2]).
:- use_module(library(apply), [foldl/4, maplist/3]).
/** <module> Placements multiplied together, exactly.

A matrix is three rows [A, B, C, D] of rationals: X' = A*X + B*Y + C*Z + D, ...
Sines and cosines are those of placing.pl, rounded once each; from there on
nothing is rounded until rounded_matrix/2, so placements that undo each other
are no placement.
*/

%!  identity_matrix(-Matrix) is det.

identity_matrix([[1,0,0,0], [0,1,0,0], [0,0,1,0]]).

%!  steps_matrix(+Steps, -Matrix) is det.
%
%   Matrix does Steps (placing.pl), which are checked, the first one first.

steps_matrix(Steps, Matrix) :-
    identity_matrix(Identity),
    foldl(step_after, Steps, Identity, Matrix).

step_after(Step, Matrix0, Matrix) :-
    step_motion(Step, Motion),
    motion_matrix(Motion, Then),
    matrix_product(Then, Matrix0, Matrix).

motion_matrix(about([X0,Y0,Z0], Motion), Matrix) :-
    !,
    maplist(rational, [X0,Y0,Z0], [X,Y,Z]),
    maplist(minus, [X,Y,Z], [U,V,W]),
    motion_matrix(Motion, Turn),
    matrix_product(Turn, [[1,0,0,U], [0,1,0,V], [0,0,1,W]], Matrix1),
    matrix_product([[1,0,0,X], [0,1,0,Y], [0,0,1,Z]], Matrix1, Matrix).
motion_matrix(Motion, Matrix) :-
    motion_rows(Motion, Rows),
    maplist(maplist(rational), Rows, Matrix).

minus(X, Y) :-
    Y is -X.

rational(X, Y) :-
    Y is rational(X).

motion_rows(translate(X, Y, Z), [[1,0,0,X], [0,1,0,Y], [0,0,1,Z]]).
motion_rows(scale(X, Y, Z), [[X,0,0,0], [0,Y,0,0], [0,0,Z,0]]).
motion_rows(rotate(x, S, C), [[1,0,0,0], [0,C,T,0], [0,S,C,0]]) :-
    T is -S.
motion_rows(rotate(y, S, C), [[C,0,S,0], [0,1,0,0], [T,0,C,0]]) :-
    T is -S.
motion_rows(rotate(z, S, C), [[C,T,0,0], [S,C,0,0], [0,0,1,0]]) :-
    T is -S.
motion_rows(matrix(Rows), Rows).

%!  matrix_product(+Matrix1, +Matrix2, -Matrix) is det.
%
%   Matrix does Matrix2, then Matrix1.

matrix_product(Matrix1, [R1,R2,R3], Matrix) :-
    maplist(row_product([R1,R2,R3,[0,0,0,1]]), Matrix1, Matrix).

row_product([[A1,B1,C1,D1], [A2,B2,C2,D2], [A3,B3,C3,D3], [A4,B4,C4,D4]],
            [U,V,W,T], [A,B,C,D]) :-
    A is U*A1 + V*A2 + W*A3 + T*A4,
    B is U*B1 + V*B2 + W*B3 + T*B4,
    C is U*C1 + V*C2 + W*C3 + T*C4,
    D is U*D1 + V*D2 + W*D3 + T*D4.

%!  matrix_sign(+Matrix, -Sign) is det.
%
%   Sign is -1 if Matrix mirrors, 0 if it squeezes space flat, else 1.

matrix_sign(Matrix, Sign) :-
    cofactors(Matrix, [[A,B,C]|_]),
    Matrix = [[X,Y,Z,_]|_],
    Sign is sign(A*X + B*Y + C*Z).

%   cofactors(Matrix, Rows): the cofactors of its linear part.

cofactors([[A,B,C,_], [D,E,F,_], [G,H,I,_]],
          [[A1,B1,C1], [D1,E1,F1], [G1,H1,I1]]) :-
    A1 is E*I - F*H,
    B1 is F*G - D*I,
    C1 is D*H - E*G,
    D1 is C*H - B*I,
    E1 is A*I - C*G,
    F1 is B*G - A*H,
    G1 is B*F - C*E,
    H1 is C*D - A*F,
    I1 is A*E - B*D.

%!  matrix_plane(+Matrix, +Plane0, -Plane) is det.
%
%   Plane is where Plane0 = plane(A, B, C, D), of any numbers, is after Matrix;
%   in rationals. What is below stays below.

matrix_plane(Matrix, plane(A0,B0,C0,D0), plane(A,B,C,D)) :-
    maplist(rational, [A0,B0,C0,D0], [U,V,W,T]),
    cofactors(Matrix, Rows),
    matrix_sign(Matrix, Sign),
    Matrix = [[X1,Y1,Z1,P], [_,_,_,Q], [_,_,_,R]],
    Rows = [[A1,B1,C1], [A2,B2,C2], [A3,B3,C3]],
    A is Sign*(U*A1 + V*B1 + W*C1),
    B is Sign*(U*A2 + V*B2 + W*C2),
    C is Sign*(U*A3 + V*B3 + W*C3),
    Size is abs(X1*A1 + Y1*B1 + Z1*C1),
    D is T*Size - A*P - B*Q - C*R.

%!  rounded_matrix(+Matrix, -Rounded) is det.
%
%   Rounded has the numbers of Matrix as floats, each rounded once.
%
%   @error evaluation_error(float_overflow)

rounded_matrix(Matrix, Rounded) :-
    maplist(maplist(rounded), Matrix, Rounded).

rounded(X, Y) :-
    Y is float(X) + 0.0.

%!  matrix_scale(+Matrix, -Scale) is det.
%
%   Scale is how long Matrix makes the longest of the three unit vectors along
%   the axes.

matrix_scale([[A1,B1,C1,_], [A2,B2,C2,_], [A3,B3,C3,_]], Scale) :-
    Scale is sqrt(max(A1*A1 + A2*A2 + A3*A3,
                      max(B1*B1 + B2*B2 + B3*B3, C1*C1 + C2*C2 + C3*C3))).
