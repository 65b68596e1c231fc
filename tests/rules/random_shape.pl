:- module(sg_test_random_shape,
          [ random_shape/3              % +Facets, +Away, -Term
          ]).
/** <module> Solids of any kind in any place, for tests of Booleans.
*/

:- use_module(library(apply)).
:- use_module(library(random)).

%!  random_shape(+Facets, +Away, -Term) is det.
%
%   Term is a sphere, a cylinder or a box of size about 1, turned and moved; its
%   centre is in the cube of side 2 round (Away,Away,Away). A circle has Facets
%   corners. Depends on library(random).

random_shape(Facets, Away,
             at([rotate(axis(X,Y,Z), Degrees), translate(U,V,W)], Shape)) :-
    findall(Some, shape(Facets, Some), Shapes),
    random_member(Shape, Shapes),
    maplist(random(-1.0, 1.0), [X,Y,Z,U0,V0,W0]),
    random(0.0, 360.0, Degrees),
    maplist(sum(Away), [U0,V0,W0], [U,V,W]).

sum(A, B, C) :-
    C is A+B.

shape(Facets, sphere(radius(R), facets(Facets), bands(Bands))) :-
    Bands is Facets//2,
    random(0.5, 1.5, R).
shape(Facets, cylinder(radius(R), height(2), facets(Facets))) :-
    random(0.2, 1.0, R).
shape(_, box(size(A, B, C))) :-
    maplist(random(0.2, 2.0), [A,B,C]).
