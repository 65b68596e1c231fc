:- module(sg_test_turned_soup,
          [ turned_faces/2,             % +Faces0, -Faces
            turn_matrix/1               % -Matrix
          ]).
/** <module> Soups of faces turned at random.

Points become doubles once each, so those that were one point are one. Faces of
more than three corners are flat only within rounding then.
*/
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).

%!  turn_matrix(-Matrix) is det.
%
%   Matrix, three rows, is a rotation, from a quaternion at random.

turn_matrix([[XX,XY,XZ],[YX,YY,YZ],[ZX,ZY,ZZ]]) :-
    random_between(1, 99, A),
    random_between(1, 99, B),
    random_between(1, 99, C),
    random_between(1, 99, D),
    N is A*A+B*B+C*C+D*D+0.0,
    XX is (A*A+B*B-C*C-D*D)/N,
    XY is 2*(B*C-A*D)/N,
    XZ is 2*(B*D+A*C)/N,
    YX is 2*(B*C+A*D)/N,
    YY is (A*A-B*B+C*C-D*D)/N,
    YZ is 2*(C*D-A*B)/N,
    ZX is 2*(B*D-A*C)/N,
    ZY is 2*(C*D+A*B)/N,
    ZZ is (A*A-B*B-C*C+D*D)/N.

%!  turned_faces(+Faces0, -Faces) is det.
%
%   Faces, as of made_soup/2, turned about the origin at random.

turned_faces(Faces0, Faces) :-
    turn_matrix(Matrix),
    maplist(maplist(maplist(turned(Matrix))), Faces0, Faces).

turned([[XX,XY,XZ],[YX,YY,YZ],[ZX,ZY,ZZ]], [X0,Y0,Z0], [X,Y,Z]) :-
    X is XX*X0+XY*Y0+XZ*Z0,
    Y is YX*X0+YY*Y0+YZ*Z0,
    Z is ZX*X0+ZY*Y0+ZZ*Z0.
