:- module(sg_true_convex,
          [ convex_resized/3            % +S, +By, -S1
          ]).
:- use_module('../near', [tolerance/2, is_rounding/2, is_on_surface/2]).
:- use_module('../primitive/primitive_rows', [add_shape/5]).
:- use_module('../store', [p/3, plane/6, segment/3, v/5]).
:- use_module('../vector',
              [ cross_product/3, dot_product/3, difference/3, scaled/3, unit/2,
                vector_sum/3
              ]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists),
              [append/3, max_list/2, member/2, nth1/3, numlist/3]).
:- use_module(library(pairs), [pairs_values/2]).
/** <module> The other surface of a convex solid.

A convex solid is what lies behind all planes of its faces. Moved outward, or
inward, these planes bound another one; where more than three of them met in a
corner, as in the apex of a pyramid that is not square, that parts in several,
with edges between them: there faces are cut where their moved planes meet.
*/

%!  convex_resized(+S, +By, -S1) is semidet.
%
%   S1 is a new segment: S, a convex solid, with each face By farther out (model
%   units; negative: within). Polygons and the term have their numbers and
%   names, vertices and edges do not. Fails if S is not convex, if two of its
%   polygons lie in one plane, or if a face would vanish.

convex_resized(S, By, S1) :-
    segment(S, solid, Term),
    findall(P, p(S, P, _), Ps0),
    sort(Ps0, Ps),
    length(Ps, Count),
    numlist(1, Count, Ps),
    maplist(unit_plane(S), Ps, Planes0),
    findall(p(X,Y,Z), v(S, _, X, Y, Z), Corners),
    extent(Corners, Size),
    tolerance(rounding, Rounding),
    Near is Rounding*Size,
    \+ ( member(Plane, Planes0), member(Corner, Corners),
         above(Plane, Corner, Off),
         Off > 0.0, \+ is_on_surface(Off, Size) ),
    maplist(moved_plane(By), Planes0, Planes),
    findall(Point,
            ( three(Planes, A, B, C),
              common_point(A, B, C, Point),
              \+ ( member(Plane, Planes), above(Plane, Point, Off),
                   Off > Near ) ),
            Points0),
    foldl(apart(Near), Points0, [], Points),
    maplist(face_loop(Points, Near), Planes, Loops),
    findall(point(X,Y,Z), member(p(X,Y,Z), Points), Places),
    add_shape(solid, Term, Places, Loops, S1).

unit_plane(S, P, plane(Normal, D)) :-
    plane(S, P, A, B, C, D0),
    !,
    Length is sqrt(A*A + B*B + C*C),
    unit(p(A,B,C), Normal),
    D is D0/Length.

moved_plane(By, plane(Normal, D0), plane(Normal, D)) :-
    D is D0-By.

above(plane(Normal, D), Point, Off) :-
    dot_product(Normal, Point, Along),
    Off is Along+D.

extent(Corners, Size) :-
    findall(Far,
            ( member(p(X,Y,Z), Corners),
              Far is max(abs(X), max(abs(Y), abs(Z))) ),
            Fars),
    max_list(Fars, Size).

three(Planes, A, B, C) :-
    append(_, [A|Rest1], Planes),
    append(_, [B|Rest2], Rest1),
    member(C, Rest2).

%   common_point(A, B, C, Point): of three planes, if they have one.

common_point(plane(N1,D1), plane(N2,D2), plane(N3,D3), Point) :-
    cross_product(N2, N3, C1),
    cross_product(N3, N1, C2),
    cross_product(N1, N2, C3),
    dot_product(N1, C1, Volume),
    \+ is_rounding(Volume, 1.0),
    F1 is -D1/Volume,
    F2 is -D2/Volume,
    F3 is -D3/Volume,
    scaled(F1, C1, P1),
    scaled(F2, C2, P2),
    scaled(F3, C3, P3),
    vector_sum(P1, P2, P12),
    vector_sum(P12, P3, Point).

%   apart(Near, Point, Points0, Points): each place once.

apart(Near, Point, Points0, Points) :-
    (   member(Other, Points0),
        difference(Point, Other, Way),
        dot_product(Way, Way, Square),
        Square =< 4.0*Near*Near
    ->  Points = Points0
    ;   Points = [Point|Points0]
    ).

%   face_loop(Points, Near, Plane, Loop): the numbers of Points on Plane, three
%   or more, counter-clockwise seen from outside.

face_loop(Points, Near, Plane, Loop) :-
    findall(I-Point,
            ( nth1(I, Points, Point),
              above(Plane, Point, Off),
              abs(Off) =< 4.0*Near ),
            On),
    On = [_-First,_,_|_],
    pairs_values(On, Around),
    foldl(vector_sum, Around, p(0.0,0.0,0.0), Sum),
    length(On, Count),
    Part is 1.0/Count,
    scaled(Part, Sum, Middle),
    Plane = plane(Normal, _),
    difference(First, Middle, U),
    cross_product(Normal, U, V),
    findall(Angle-I,
            ( member(I-Point, On),
              difference(Point, Middle, Way),
              dot_product(Way, U, X),
              dot_product(Way, V, Y),
              Angle is atan2(Y, X) ),
            Turns0),
    keysort(Turns0, Turns),
    pairs_values(Turns, Loop).
