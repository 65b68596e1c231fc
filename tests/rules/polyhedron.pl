:- module(sg_test_polyhedron,
          [ polyhedron/4,               % +S, +Kind, +Points, +Faces
            curve/2,                    % +S, +Points
            box_points/3,               % +Low, +High, -Points
            box_faces/1,                % -Faces
            prism/5,                    % +N, +R, +H, -Points, -Faces
            moved/3,                    % +Move, +Points0, -Points
            in_new_world/1              % :Goal
          ]).
/** <module> Small models for tests, entered into the current world.

Points are p(X,Y,Z); a face is the list of its corners, numbered from 1,
counter-clockwise from outside, convex.
*/

:- use_module(rules(store)).
:- use_module(library(apply)).
:- use_module(library(lists)).

:- meta_predicate in_new_world(0).

%!  in_new_world(:Goal) is semidet.

in_new_world(Goal) :-
    new_world(World),
    in_world(World, Goal).

%!  polyhedron(+S, +Kind, +Points, +Faces) is det.
%
%   Assert segment S with its vertices, polygons, their directed edges, planes
%   and triangles.

polyhedron(S, Kind, Points, Faces) :-
    assert_fact(segment(S, Kind, test)),
    foldl(point(S), Points, 1, _),
    foldl(face(S, Points), Faces, 1-1-1, _).

point(S, p(X0,Y0,Z0), V, V1) :-
    X is float(X0),
    Y is float(Y0),
    Z is float(Z0),
    assert_fact(v(S, V, X, Y, Z)),
    V1 is V+1.

face(S, Points, [A,B|Rest], P-E0-T0, P1-E-T) :-
    append([B|Rest], [A], Nexts),
    foldl(edge(S), [A,B|Rest], Nexts, E0, E),
    Last is E-1,
    numlist(E0, Last, Es),
    assert_fact(p(S, P, Es)),
    plane_of(Points, [A,B|Rest], Nx, Ny, Nz, D),
    assert_fact(plane(S, P, Nx, Ny, Nz, D)),
    fan(Rest, S, P, A, B, T0, T),
    P1 is P+1.

edge(S, A, B, E, E1) :-
    assert_fact(e(S, E, A, B, 1)),
    E1 is E+1.

fan([], _, _, _, _, T, T).
fan([C|Rest], S, P, A, B, T0, T) :-
    assert_fact(t(S, P, T0, A, B, C)),
    T1 is T0+1,
    fan(Rest, S, P, A, C, T1, T).

plane_of(Points, [A|Corners], Nx, Ny, Nz, D) :-
    append(Corners, [A], Nexts),
    foldl(newell(Points), [A|Corners], Nexts, n(0.0,0.0,0.0), n(X,Y,Z)),
    Length is sqrt(X*X+Y*Y+Z*Z),
    Nx is X/Length+0.0,
    Ny is Y/Length+0.0,
    Nz is Z/Length+0.0,
    nth1(A, Points, p(Ax,Ay,Az)),
    D is -(Nx*Ax+Ny*Ay+Nz*Az)+0.0.

newell(Points, A, B, n(X0,Y0,Z0), n(X,Y,Z)) :-
    nth1(A, Points, p(Ax,Ay,Az)),
    nth1(B, Points, p(Bx,By,Bz)),
    X is X0+(Ay-By)*(Az+Bz),
    Y is Y0+(Az-Bz)*(Ax+Bx),
    Z is Z0+(Ax-Bx)*(Ay+By).

%!  curve(+S, +Points) is det.

curve(S, Points) :-
    assert_fact(segment(S, curve, test)),
    foldl(point(S), Points, 1, N),
    forall(( between(3, N, V2), V is V2-1, E is V-1 ),
           assert_fact(e(S, E, E, V, 1))).

%!  box_points(+Low, +High, -Points) is det.

box_points(p(X,Y,Z), p(X1,Y1,Z1),
           [ p(X,Y,Z), p(X1,Y,Z), p(X,Y1,Z), p(X1,Y1,Z),
             p(X,Y,Z1), p(X1,Y,Z1), p(X,Y1,Z1), p(X1,Y1,Z1) ]).

%!  box_faces(-Faces) is det.

box_faces([ [1,3,4,2], [5,6,8,7], [1,2,6,5], [3,7,8,4], [1,5,7,3], [2,4,8,6] ]).

%!  prism(+N, +R, +H, -Points, -Faces) is det.
%
%   A prism about z, centred, with its first corner half a side past +x.

prism(N, R, H, Points, Faces) :-
    Last is N-1,
    findall(p(X,Y,Z),
            (   member(Side, [-1,1]),
                between(0, Last, I),
                X is R*cos(2*pi*(I+0.5)/N),
                Y is R*sin(2*pi*(I+0.5)/N),
                Z is Side*H/2
            ),
            Points),
    findall([A,B,C,D],
            (   between(1, N, A),
                B is A mod N + 1,
                C is B+N,
                D is A+N
            ),
            Sides),
    numlist(1, N, Base),
    reverse(Base, Bottom),
    Low is N+1,
    High is 2*N,
    numlist(Low, High, Top),
    append(Sides, [Bottom,Top], Faces).

%!  moved(+Move, +Points0, -Points) is det.
%
%   Move is by(X,Y,Z), or axes: x y z become y z x.

moved(Move, Points0, Points) :-
    maplist(moved_(Move), Points0, Points).

moved_(by(Dx,Dy,Dz), p(X0,Y0,Z0), p(X,Y,Z)) :-
    X is X0+Dx,
    Y is Y0+Dy,
    Z is Z0+Dz.
moved_(axes, p(X,Y,Z), p(Z,X,Y)).
