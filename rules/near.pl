:- module(sg_near,
          [ tolerance/2,                % ?Of, -Tolerance
            same_angle/2,               % +T1, +T2
            before_angle/2,             % +T1, +T2
            between_angles/3,           % +T1, +T, +T2
            same_direction/2,           % +T1, +T2
            whole_turns/2,              % +T, -By
            same_part/2,                % +H1, +H2
            less_part/2,                % +H1, +H2
            off_sign/2,                 % +Off, -Sign
            is_rounding/2,              % +Off, +Size
            is_exactly/2,               % +Off, +Size
            longer/2,                   % +Length1, +Length2
            is_on_surface/2,            % +Off, +Size
            is_straight/2,              % +Cross, +Square
            is_bend/1,                  % +Degrees
            below_zero/2,               % +Product, +Square
            points_left/2,              % +X, +Y
            boxes_near/3                % +Box1, +Box2, +Reach
          ]).
/** <module> Numbers that are meant to be equal, and differ by rounding.

What has an id is compared by its id. These are for what was computed and has
none: where a generator is on a surface, where a line ends on paper. Each kind
of number has one tolerance, here, with its reason. Arguments may be
expressions.
*/

:- set_prolog_flag(optimise, true).

%!  tolerance(?Of, -Tolerance) is nondet.
%
%   Numbers that differ by no more than Tolerance are one.
%
%     - angle: of generators, in degrees. That of a point is known to rounding
%       over its distance from the axis, far less; facets are far wider.
%     - rounding: of numbers of the size of one: heights from 0 to 1, whole
%       turns, a length over another. Thousands of roundings.
%     - exact: of numbers made in a few steps of coordinates, over their size:
%       some roundings.
%     - event: of generators where lines of true surfaces change places, in
%       degrees: roots of closed forms.
%     - place: of points of a pattern, over its size: sums along all its pieces.
%     - surface: of points where surfaces meet, over the size of the model: they
%       are found by steps, which end at less.
%     - gap: of faces that were not glued, over the size of the model: one up to
%       this may not be meant. Nothing is moved, it is only told.
%     - paper: of millimetres, of directions, and of places over their size: far
%       below what a knife can do, far above rounding.
%     - fold: of folds of a plate, in degrees: below what a brake can bend.

tolerance(angle,    1.0e-6).
tolerance(rounding, 1.0e-9).
tolerance(exact,    2.0e-13).
tolerance(event,    5.0e-8).
tolerance(place,    1.0e-7).
tolerance(surface,  1.0e-6).
tolerance(gap,      1.0e-3).
tolerance(paper,    1.0e-6).
tolerance(fold,     1.0e-2).

%!  same_angle(+T1, +T2) is semidet.
%
%   True when T1 and T2, degrees, are one generator.

same_angle(T1, T2) :-
    tolerance(angle, Near),
    abs(T1-T2) =< Near.

%!  before_angle(+T1, +T2) is semidet.
%
%   True when T1 is less than T2, and not the same_angle/2.

before_angle(T1, T2) :-
    tolerance(angle, Near),
    T1 < T2 - Near.

%!  between_angles(+T1, +T, +T2) is semidet.
%
%   True when T lies between T1 and T2, and is neither.

between_angles(T1, T, T2) :-
    before_angle(T1, T),
    before_angle(T, T2).

%!  same_direction(+T1, +T2) is semidet.
%
%   True when T1 and T2, degrees, differ by whole turns.

same_direction(T1, T2) :-
    Turns is (T1-T2)/360.0,
    same_part(Turns, round(Turns)).

%!  whole_turns(+T, -By) is det.
%
%   By, degrees, are whole turns: T-By is from 0 up to 360; what is 360 up to
%   rounding is about 0.

whole_turns(T, By) :-
    tolerance(rounding, Near),
    By is 360.0*floor((T + Near)/360.0).

%!  same_part(+H1, +H2) is semidet.
%
%   True when H1 and H2, parts of one thing, are the same.

same_part(H1, H2) :-
    is_rounding(H1-H2, 1.0).

%!  less_part(+H1, +H2) is semidet.
%
%   True when H1 is less than H2, and not the same_part/2.

less_part(H1, H2) :-
    tolerance(rounding, Near),
    H1 < H2 - Near.

%!  off_sign(+Off, -Sign) is det.
%
%   Sign, -1, 0 or 1, is that of Off, a difference of parts of one thing.

off_sign(Off, Sign) :-
    (   is_rounding(Off, 1.0)
    ->  Sign = 0
    ;   Off < 0.0
    ->  Sign = -1
    ;   Sign = 1
    ).

%!  is_rounding(+Off, +Size) is semidet.
%
%   True when Off is what rounding makes of 0 in numbers of this Size.

is_rounding(Off, Size) :-
    tolerance(rounding, Near),
    abs(Off) =< Near*Size.

%!  is_exactly(+Off, +Size) is semidet.
%
%   True when Off is what a few roundings make of 0 in numbers of this Size.

is_exactly(Off, Size) :-
    tolerance(exact, Near),
    abs(Off) =< Near*Size.

%!  longer(+Length1, +Length2) is semidet.
%
%   True when Length1 is more than Length2, and not by rounding.

longer(Length1, Length2) :-
    tolerance(rounding, Near),
    Length1 > Length2*(1.0 + Near).

%!  is_on_surface(+Off, +Size) is semidet.
%
%   True when what is Off a surface, or Off another point, lies there;
%   coordinates are of this Size.

is_on_surface(Off, Size) :-
    tolerance(surface, Near),
    abs(Off) =< Near*Size.

%!  is_bend(+Degrees) is semidet.
%
%   True when a plate is bent where its faces fold by Degrees, either way.

is_bend(Degrees) :-
    tolerance(fold, Near),
    abs(Degrees) >= Near.

%!  is_straight(+Cross, +Square) is semidet.
%!  below_zero(+Product, +Square) is semidet.
%
%   True when the product of two ways on paper, whose size is that of Square, is
%   0, or less than that.

is_straight(Cross, Square) :-
    tolerance(paper, Near),
    abs(Cross) =< Near*Square.

below_zero(Product, Square) :-
    tolerance(paper, Near),
    Product < -Near*Square.

%!  points_left(+X, +Y) is semidet.
%
%   True when the way X, Y on paper points to the left, or straight down: text
%   along it would be upside down.

points_left(X, Y) :-
    Length is sqrt(X*X + Y*Y),
    (   below_zero(X, Length)
    ->  true
    ;   is_straight(X, Length),
        Y < 0
    ).

%!  boxes_near(+Box1, +Box2, +Reach) is semidet.
%
%   True when Box1 and Box2, box(X1,Y1,Z1,X2,Y2,Z2) from the lowest to the
%   highest corner, are no farther apart than Reach along each axis. Exact for
%   rationals.

boxes_near(box(X1,Y1,Z1,X2,Y2,Z2), box(A1,B1,C1,A2,B2,C2), Reach) :-
    X1 =< A2+Reach,
    A1 =< X2+Reach,
    Y1 =< B2+Reach,
    B1 =< Y2+Reach,
    Z1 =< C2+Reach,
    C1 =< Z2+Reach.
