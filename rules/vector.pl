:- module(sg_vector,
          [ cross_product/3,            % +U, +V, -W
            dot_product/3,              % +U, +V, -Product
            difference/3,               % +P, +Q, -Vector
            vector_sum/3,               % +U, +V, -Sum
            scaled/3,                   % +Factor, +U, -V
            left_of/4,                  % +Normal, +A, +B, +P
            unit/2,                     % +U, -Unit
            doubled_area/2,             % +Points, -Vector
            angle_between/3             % +U, +V, -Radians
          ]).
/** <module> Points and vectors p(X,Y,Z); products also of vector(X,Y,Z), as
surfaces have them (primitive_face.pl).

Of floats they are rounded; of rationals all but unit/2 and angle_between/3 are
exact.
*/

:- set_prolog_flag(optimise, true).

%!  difference(+P, +Q, -Vector) is det.
%
%   Vector = P - Q: it leads from Q to P.

difference(p(X1,Y1,Z1), p(X2,Y2,Z2), p(X,Y,Z)) :-
    X is X1-X2,
    Y is Y1-Y2,
    Z is Z1-Z2.

%!  vector_sum(+U, +V, -Sum) is det.
%
%   Sum = U + V: a point moved by a vector, too.

vector_sum(p(X1,Y1,Z1), p(X2,Y2,Z2), p(X,Y,Z)) :-
    X is X1+X2,
    Y is Y1+Y2,
    Z is Z1+Z2.

%!  cross_product(+U, +V, -W) is det.
%
%   W = U x V, right-handed: above U and V where V is to the left of U.

cross_product(p(X1,Y1,Z1), p(X2,Y2,Z2), p(X,Y,Z)) :-
    X is Y1*Z2 - Z1*Y2,
    Y is Z1*X2 - X1*Z2,
    Z is X1*Y2 - Y1*X2.
cross_product(vector(X1,Y1,Z1), vector(X2,Y2,Z2), vector(X,Y,Z)) :-
    cross_product(p(X1,Y1,Z1), p(X2,Y2,Z2), p(X,Y,Z)).

%!  dot_product(+U, +V, -Product) is det.
%
%   Product = U . V.

dot_product(p(X1,Y1,Z1), p(X2,Y2,Z2), Product) :-
    Product is X1*X2 + Y1*Y2 + Z1*Z2.
dot_product(vector(X1,Y1,Z1), vector(X2,Y2,Z2), Product) :-
    Product is X1*X2 + Y1*Y2 + Z1*Z2.

%!  scaled(+Factor, +U, -V) is det.
%
%   V = Factor U.

scaled(Factor, U, V) :-
    times(U, Factor, V).

times(p(X0,Y0,Z0), Factor, p(X,Y,Z)) :-
    X is Factor*X0,
    Y is Factor*Y0,
    Z is Factor*Z0.
times(vector(X0,Y0,Z0), Factor, vector(X,Y,Z)) :-
    times(p(X0,Y0,Z0), Factor, p(X,Y,Z)).

%!  doubled_area(+Points:list, -Vector) is det.
%
%   Vector is twice the vector area of the polygon with these corners: it points
%   to where they are seen counter-clockwise.

doubled_area([First|Points], Vector) :-
    fan_added(Points, First, p(0,0,0), Vector).

fan_added([P,Q|Points], First, Sum0, Sum) :-
    !,
    difference(P, First, U),
    difference(Q, First, V),
    cross_product(U, V, W),
    vector_sum(Sum0, W, Sum1),
    fan_added([Q|Points], First, Sum1, Sum).
fan_added(_, _, Sum, Sum).

%!  angle_between(+U, +V, -Radians) is det.
%
%   Radians, 0 to pi, is the angle between U and V; 0 if one of them is 0.

angle_between(U, V, Radians) :-
    cross_product(U, V, W),
    dot_product(W, W, Square),
    dot_product(U, V, Dot),
    Radians is atan2(sqrt(Square), Dot).

%!  left_of(+Normal, +A, +B, +P) is semidet.
%
%   P is to the left of the way from A to B, or on it, seen from where Normal
%   points.

left_of(Normal, A, B, P) :-
    difference(B, A, U),
    difference(P, A, W),
    cross_product(U, W, Across),
    dot_product(Across, Normal, Side),
    Side >= 0.

%!  unit(+U, -Unit) is det.
%
%   Unit is as long as 1 and runs as U does; 0 if U is 0.

unit(U, Unit) :-
    dot_product(U, U, Square),
    (   Square > 0.0
    ->  Size is sqrt(Square),
        divided(U, Size, Unit)
    ;   Unit = U
    ).

divided(p(X0,Y0,Z0), Size, p(X,Y,Z)) :-
    X is X0/Size,
    Y is Y0/Size,
    Z is Z0/Size.
divided(vector(X0,Y0,Z0), Size, vector(X,Y,Z)) :-
    divided(p(X0,Y0,Z0), Size, p(X,Y,Z)).
