:- module(sg_cityjson_floor,
          [ floors_added/3              % +Vertices, +Faces0, -Faces
          ]).
:- use_module('../near', [tolerance/2]).
:- use_module('../vector',
              [difference/3, dot_product/3, doubled_area/2]).
:- use_module(library(apply), [maplist/3, partition/4]).
:- use_module(library(lists), [append/3, member/2, selectchk/3]).
:- use_module(library(ordsets), [ord_subtract/3]).
/** <module> Floors for buildings that have none.

A solid of a city model may be open where it stands on the ground. Where its
border is flat it is closed by faces with the same border; a courtyard is a hole
of such a floor. */

%!  floors_added(+Vertices, +Faces0:list, -Faces:list) is semidet.
%
%   Faces are Faces0 and flat faces that close them: lists of rings of indices,
%   from 0, of Vertices, a compound of p(X,Y,Z). Fails if a border does not
%   close, or is not flat.

floors_added(Vertices, Faces0, Faces) :-
    border(Faces0, Steps),
    Steps \== [],
    loops(Steps, Loops),
    maplist(measured(Vertices), Loops, Rings0),
    sort(1, @>=, Rings0, Rings),
    floors(Rings, Floors),
    append(Faces0, Floors, Faces).

%   border(Faces, Steps): A-B for each edge from B to A that has no opposite,
%   in order.

border(Faces, Steps) :-
    findall(A-B,
            ( member(Rings, Faces), member(Ring, Rings), step(Ring, A, B) ),
            Edges0),
    sort(Edges0, Edges),
    findall(B-A, member(A-B, Edges), Turned0),
    sort(Turned0, Turned),
    ord_subtract(Turned, Edges, Steps).

step([First|Rest], A, B) :-
    append(Rest, [First], Nexts),
    pair([First|Rest], Nexts, A, B).

pair([A|_], [B|_], A, B).
pair([_|As], [_|Bs], A, B) :-
    pair(As, Bs, A, B).

loops([], []).
loops([A-B|Steps0], [[A|Loop]|Loops]) :-
    loop(B, A, Steps0, Steps, Loop),
    loops(Steps, Loops).

loop(A, A, Steps, Steps, []) :-
    !.
loop(A, First, Steps0, Steps, [A|Loop]) :-
    selectchk(A-B, Steps0, Steps1),
    loop(B, First, Steps1, Steps, Loop).

%   measured(Vertices, Loop, ring(Square, Area, Points, Loop)): Area is its
%   vector area, twice, Square the square of that; of rationals.

measured(Vertices, Loop, ring(Square,Area,Points,Loop)) :-
    maplist(place(Vertices), Loop, Points),
    doubled_area(Points, Area),
    dot_product(Area, Area, Square).

place(Vertices, Index, p(X,Y,Z)) :-
    Arg is Index+1,
    arg(Arg, Vertices, p(X0,Y0,Z0)),
    X is rational(X0),
    Y is rational(Y0),
    Z is rational(Z0).

%   floors(Rings, Floors): the largest ring first; those in its plane that run
%   the other way, inside it, are its holes.

floors([], []).
floors([Ring|Rings0], [[Loop|Holes]|Floors]) :-
    Ring = ring(Square,_,_,Loop),
    Square > 0,
    in_plane(Ring, Ring),
    partition(hole_of(Ring), Rings0, Inner, Rings),
    findall(Hole, member(ring(_,_,_,Hole), Inner), Holes),
    floors(Rings, Floors).

hole_of(Outer, Ring) :-
    Outer = ring(_,Area,_,_),
    Ring = ring(_,Area1,[Point|_],_),
    dot_product(Area, Area1, Way),
    Way < 0,
    in_plane(Outer, Ring),
    is_inside(Outer, Point).

%   in_plane(Outer, Ring): the points of Ring are in the plane of Outer, within
%   rounding.

in_plane(ring(Square,Area,[Origin|_],_), ring(_,_,Points,_)) :-
    tolerance(rounding, Near0),
    Near is rational(Near0),
    \+ ( member(Point, Points),
         difference(Point, Origin, Way),
         dot_product(Way, Area, Off),
         Off**4 > Near**4*Square**3 ).

%   is_inside(Outer, Point): the ring goes round Point an odd number of times,
%   seen along the largest axis of its normal.

is_inside(ring(_,p(NX,NY,NZ),Points,_), Point) :-
    AX is abs(NX),
    AY is abs(NY),
    AZ is abs(NZ),
    (   AZ >= AX, AZ >= AY
    ->  I = 1, J = 2
    ;   AY >= AX
    ->  I = 1, J = 3
    ;   I = 2, J = 3
    ),
    arg(I, Point, X),
    arg(J, Point, Y),
    Points = [First|_],
    append(Points, [First], Round),
    findall(x,
            ( append(_, [A,B|_], Round),
              arg(J, A, Y1),
              arg(J, B, Y2),
              once(( Y1 =< Y, Y < Y2 ; Y2 =< Y, Y < Y1 )),
              arg(I, A, X1),
              arg(I, B, X2),
              X < X1+(Y-Y1)*(X2-X1) rdiv (Y2-Y1) ),
            Crossings),
    length(Crossings, N),
    N mod 2 =:= 1.
