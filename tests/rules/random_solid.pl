:- module(sg_test_random_solid,
          [ random_blocks/2,            % -Blocks, -Primitive
            random_primitive/1,         % -Primitive
            random_placed/1,            % -Primitive
            random_rotation/1,          % -Steps
            placed/3                    % +Steps, +Primitive0, -Primitive
          ]).
/** <module> Random solids: some on a coarse grid, some anywhere.

Seed the generator first: set_random(seed(N)).
*/

:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).

%!  random_blocks(-Blocks, -Primitive) is det.
%
%   A box, or a prism on an L, of whole units in the cube from 0 to 4, along
%   any axis: as blocks for voxel.pl, and as a primitive with the same corners
%   exactly.

random_blocks(Blocks, Primitive) :-
    random_member(How, [box,box,l]),
    random_member(Axis, [1,2,3]),
    random_blocks(How, Axis, Blocks, Primitive).

random_blocks(box, _, [block(X0,Y0,Z0,X1,Y1,Z1)], Primitive) :-
    maplist(random_interval, [X0-X1,Y0-Y1,Z0-Z1]),
    A is X1-X0, B is Y1-Y0, C is Z1-Z0,
    X is (X0+X1)/2.0, Y is (Y0+Y1)/2.0,
    Primitive = at([translate(X,Y,Z0)], box(size(A,B,C))).
random_blocks(l, Axis, Blocks, Primitive) :-
    random_interval2(X0, X1, X2),
    random_interval2(Y0, Y1, Y2),
    random_interval(Z0-Z1),
    H is Z1-Z0,
    cyclic(Axis, Matrix),
    maplist(turned_block(Axis),
            [block(X0,Y0,Z0,X2,Y1,Z1), block(X0,Y1,Z0,X1,Y2,Z1)], Blocks),
    Primitive = at([translate(0,0,Z0),matrix(Matrix)],
                   prism(outline([[X0,Y0],[X2,Y0],[X2,Y1],[X1,Y1],
                                  [X1,Y2],[X0,Y2]]),
                         height(H))).

random_interval(A-B) :-
    random_between(0, 3, A),
    Low is A+1,
    random_between(Low, 4, B).

random_interval2(A, B, C) :-
    random_between(0, 2, A),
    Low is A+1,
    random_between(Low, 3, B),
    Next is B+1,
    random_between(Next, 4, C).

%   x y z become the axes after a cyclic exchange.

cyclic(1, [[1,0,0,0],[0,1,0,0],[0,0,1,0]]).
cyclic(2, [[0,0,1,0],[1,0,0,0],[0,1,0,0]]).
cyclic(3, [[0,1,0,0],[0,0,1,0],[1,0,0,0]]).

turned_block(1, Block, Block).
turned_block(2, block(X,Y,Z,X1,Y1,Z1), block(Z,X,Y,Z1,X1,Y1)).
turned_block(3, block(X,Y,Z,X1,Y1,Z1), block(Y,Z,X,Y1,Z1,X1)).

%!  random_primitive(-Primitive) is det.
%
%   A solid primitive of about unit size.

random_primitive(Primitive) :-
    maplist(random_length, [A,B,C]),
    random_between(3, 14, N0),
    N is max(3, N0),
    random_member(Primitive,
                  [ box(size(A,B,C)),
                    cylinder(radius(A), height(B), facets(N)),
                    hollow_cylinder(radius(1.2), inner(0.6), height(B),
                                    facets(N)),
                    cone(radius(A), height(B), facets(N)),
                    cone(radius(A), top(C), height(B), facets(N)),
                    sphere(radius(A), facets(12), bands(6)),
                    torus(radius(1), tube(0.4), facets(N), sides(6)),
                    pyramid(base(A,B), height(C)),
                    prism(outline([[0,0],[2,0],[2,1],[1,1],[1,2],[0,2]]),
                          height(B)) ]).

random_length(L) :-
    random(R),
    L is 0.5+R.

%!  random_placed(-Primitive) is det.
%
%   A solid primitive turned and moved at random: no two meet but by crossing.

random_placed(at(Steps, Primitive)) :-
    random_primitive(Primitive),
    random_rotation(Rotation),
    maplist(random_shift, [X,Y,Z]),
    append(Rotation, [translate(X,Y,Z)], Steps).

random_shift(D) :-
    random(R),
    D is 2*R-1.

%!  random_rotation(-Steps) is det.

random_rotation([rotate(axis(X,Y,Z), Degrees)]) :-
    maplist(random_between(-1000, 1000), [X0,Y,Z]),
    X is X0+0.5,
    random(R),
    Degrees is 360*R.

%!  placed(+Steps, +Primitive0, -Primitive) is det.

placed(Steps, Primitive, at(Steps, Primitive)).
