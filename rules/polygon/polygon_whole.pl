:- module(sg_polygon_whole,
          [ crosses_itself/2            % +S, +P
          ]).
:- use_module('../near', [is_straight/2]).
:- use_module('../store', [e/5, p/3, t/6, v/5]).
:- use_module('../vector', [cross_product/3, difference/3, dot_product/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [member/2]).
/** <module> Polygons that no triangles fill.
*/

%!  crosses_itself(+S, +P) is semidet.
%
%   Polygon P of segment S, whose polygons have their triangles, has none, and
%   its corners are not on a straight line: it crosses or overlaps itself. What
%   is made of triangles would lack it.

crosses_itself(S, P) :-
    \+ t(S, P, _, _, _, _),
    p(S, P, Es),
    findall(p(X,Y,Z), ( member(E, Es), e(S, E, V, _, _), v(S, V, X, Y, Z) ),
            [First|Places]),
    findall(Way, ( member(Place, Places), difference(Place, First, Way) ),
            Ways),
    member(U, Ways),
    member(W, Ways),
    cross_product(U, W, Cross),
    maplist(square, [U,W,Cross], [UU,WW,CC]),
    \+ is_straight(sqrt(CC), max(UU, WW)),
    !.

square(U, UU) :-
    dot_product(U, U, UU).
