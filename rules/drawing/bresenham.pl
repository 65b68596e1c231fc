:- module(sg_bresenham,
          [ line_dot/3,                 % +A, +B, -Dot
            chain_dots/3                % +Points, +Pattern, -Dots
          ]).
:- use_module(library(lists), [append/3]).
/** <module> Bresenham's algorithm with a dot pattern, as a rule.

What the kernel raster_dots/4 draws with a pen one dot wide; the kernel is
held against this (tests/rules/drawing/bresenham.plt). Integers only. The paper
changed the algorithm so that it draws solid and dotted lines alike, repeating
a pattern: 3 is three dots drawn, three not.

@see [PL] section 6.4, row PL-14
*/

:- set_prolog_flag(optimise, true).

%!  line_dot(+A, +B, -Dot) is multi.
%
%   Dot, X-Y, is on the line from A to B; on backtracking in that order, A and
%   B among them.

line_dot(A, B, Dot) :-
    A = XA-YA,
    B = XB-YB,
    DX is abs(XB-XA),
    DY is abs(YB-YA),
    StepX is sign(XB-XA),
    StepY is sign(YB-YA),
    Error is DX-DY,
    dot_from(A, B, line(DX,DY,StepX,StepY), Error, Dot).

%   Error says how far the true line has left the dots: twice of it decides
%   whether the next dot goes on in x, in y, or in both.

dot_from(B, B, _, _, Dot) :-
    !,
    Dot = B.
dot_from(A, _, _, _, A).
dot_from(X0-Y0, B, Line, Error0, Dot) :-
    Line = line(DX, DY, StepX, StepY),
    (   2*Error0 > -DY
    ->  X is X0+StepX,
        Error1 is Error0-DY
    ;   X = X0,
        Error1 = Error0
    ),
    (   2*Error0 < DX
    ->  Y is Y0+StepY,
        Error is Error1+DX
    ;   Y = Y0,
        Error = Error1
    ),
    dot_from(X-Y, B, Line, Error, Dot).

%!  chain_dots(+Points, +Pattern, -Dots) is det.
%
%   Dots are drawn for the chain through Points, in order. Pattern is a list
%   of run lengths on, off, on, off, ...; `[]`: all. It runs on across joints,
%   and the dot at a joint counts once.

chain_dots(Points, Pattern, Dots) :-
    findall(Dot, chain_dot(Points, Dot), All),
    (   Pattern == []
    ->  Dots = All
    ;   drawn(All, Pattern, Pattern, Dots)
    ).

chain_dot([Point|_], Point).
chain_dot(Points, Dot) :-
    append(_, [A,B|_], Points),
    line_dot(A, B, Dot),
    Dot \== A.

%   drawn(Dots, Runs, Pattern, Drawn): the first of Runs is on, and what is
%   left of it.

drawn([], _, _, []) :-
    !.
drawn(Dots, [], Pattern, Drawn) :-
    !,
    drawn(Dots, Pattern, Pattern, Drawn).
drawn(Dots, [On,Off|Runs], Pattern, Drawn) :-
    taken(On, Dots, Dots1, Drawn, Drawn1),
    taken(Off, Dots1, Dots2, _, []),
    drawn(Dots2, Runs, Pattern, Drawn1).

%   taken(N, Dots, Rest, Taken, Tail): N dots, or all if there are fewer.

taken(N, [Dot|Dots], Rest, [Dot|Taken], Tail) :-
    N > 0,
    !,
    N1 is N-1,
    taken(N1, Dots, Rest, Taken, Tail).
taken(_, Dots, Dots, Tail, Tail).
