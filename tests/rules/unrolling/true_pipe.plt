/* Where generators go through a convex solid, against points of the generator
   that are inside of it or not. */
:- module(test_true_pipe, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(primitive/primitive_face), [surface_point/4]).
:- use_module(rules(unrolling/true_pipe)).
:- use_module(rules(vector), [cross_product/3, dot_product/3, difference/3]).
:- use_module(tests(rules/sample)).

%   random_frame(Size, Point, U, V, W): right-angled; W is any length.

random_frame(Size, point(X,Y,Z), U, V, W) :-
    maplist(random_number(-10, 10), [X,Y,Z,A,B,C,D,E,F]),
    unit(p(A,B,C), P),
    cross_product(P, p(D,E,F), Q0),
    unit(Q0, Q),
    cross_product(P, Q, R),
    random_number(15, 50, Length),
    maplist(scaled, [Size,Size,Length], [P,Q,R], [U,V,W]).

random_number(Low, High, X) :-
    random(F),
    X is Low + F*(High-Low).

unit(p(X0,Y0,Z0), p(X,Y,Z)) :-
    Length is sqrt(X0*X0 + Y0*Y0 + Z0*Z0),
    X is X0/Length,
    Y is Y0/Length,
    Z is Z0/Length.

scaled(F, p(X0,Y0,Z0), vector(X,Y,Z)) :-
    X is X0*F,
    Y is Y0*F,
    Z is Z0*F.

random_surface(Kind, Surface) :-
    random_number(6, 14, R),
    random_frame(R, C, U, V, W),
    (   Kind == cylinder
    ->  Surface = cylinder(C, U, V, W)
    ;   Kind == cone
    ->  random_member(K, [0.0,0.3,0.8,1.6,3.0]),
        Surface = cone(C, U, V, W, K)
    ;   W = vector(A0,B0,C0),
        F is R/sqrt(A0*A0 + B0*B0 + C0*C0),
        A is A0*F,
        B is B0*F,
        D is C0*F,
        Surface = sphere(C, U, V, vector(A,B,D))
    ).

%   depth(Kind, Surface, Point, Depth): more than 0 inside of the solid, by its
%   equations as they stand in books.

depth(Kind, Surface, Point, Depth) :-
    Surface =.. [_,C,U,V,W|Rest],
    maplist(along(C, Point), [U,V,W], [A,B,H]),
    Across is sqrt(A*A + B*B),
    (   Kind == cylinder
    ->  Depth is min(1-Across, min(H, 1-H))
    ;   Kind == cone
    ->  Rest = [K],
        Depth is min(1 + (K-1)*H - Across, min(H, 1-H))
    ;   Kind == sphere
    ->  Depth is 1 - sqrt(Across*Across + H*H)
    ;   Depth is min(1 - sqrt(Across*Across + H*H), H)
    ).

along(point(X0,Y0,Z0), point(X,Y,Z), vector(A,B,C), Part) :-
    difference(p(X,Y,Z), p(X0,Y0,Z0), Off),
    dot_product(Off, p(A,B,C), Dot),
    dot_product(p(A,B,C), p(A,B,C), Square),
    Part is Dot/Square.

at(Own, Kind, Other, T, H, Depth) :-
    surface_point(Own, T, H, Point),
    depth(Kind, Other, Point, Depth).

%   case(Kind, Own, Other): the generators are long, so many reach it.

case(Seed, Kind, Own, Other) :-
    set_random(seed(Seed)),
    Kinds = [cylinder,cone,sphere,hemisphere],
    I is Seed mod 4,
    nth0(I, Kinds, Kind),
    J is Seed // 4 mod 2,
    nth0(J, [cylinder,cone], OwnKind),
    random_surface(OwnKind, Own),
    random_surface(Kind, Other).

%   right(Kind, Own, Other, Pipe, T): between its ends a generator is inside,
%   past them it is not; the ends are where their lines say.

right(Kind, Own, Other, Pipe, T) :-
    (   pipe_interval(Pipe, T, Low-Line1, High-Line2)
    ->  Step is 1.0e-6*(1 + abs(Low) + abs(High)),
        (   High-Low < 10*Step
        ->  true
        ;   forall(member(End-Sense-Line, [Low-1-Line1,High-(-1)-Line2]),
                   (   Line == none
                   ->  true
                   ;   Within is End + Sense*Step,
                       Beyond is End - Sense*Step,
                       at(Own, Kind, Other, T, Within, Depth1),
                       at(Own, Kind, Other, T, Beyond, Depth2),
                       Depth1 > 0,
                       Depth2 < 0,
                       pipe_height(Pipe, Line, T, H),
                       abs(H-End) < 1.0e-9*(1 + abs(H))
                   )),
            Middle is (max(Low, -1.0e3) + min(High, 1.0e3))/2,
            at(Own, Kind, Other, T, Middle, Depth),
            Depth > 0
        )
    ;   forall(between(-150, 150, I),
               ( H is I/50,
                 at(Own, Kind, Other, T, H, Depth),
                 Depth < 1.0e-9 ))
    ).

:- begin_tests(true_pipe).

test(interval, forall(numbered(24, 80, Seed))) :-
    case(Seed, Kind, Own, Other),
    (   pipe_met(Kind, Own, Other, Pipe)
    ->  forall(( between(0, 35, I), T is 10.0*I+1.0 ),
               (   right(Kind, Own, Other, Pipe, T)
               ->  true
               ;   throw(wrong(Kind, Own, Other, T))
               ))
    ;   true
    ).

%   Of the two the nearer one, and it lies on the surface.

test(crossing, forall(numbered(16, 40, Seed))) :-
    case(Seed, _, Own, Other),
    functor(Other, Name, _),
    (   pipe_met(Name, Own, Other, Pipe)
    ->  forall(( between(0, 17, I), T is 20.0*I+1.0,
                 pipe_interval(Pipe, T, Low-line(_), High-line(_)),
                 member(Near-H, [0.1-Low,0.9-High]) ),
               ( H0 is Low + (High-Low)*Near,
                 pipe_crossing(Own, Other, T, H0, H1),
                 abs(H1-H) < 1.0e-9*(1 + abs(H)) ))
    ;   true
    ).

%   Where the lines that bound a generator are others than four degrees before,
%   an event is between; and where there is a tip, an interval begins or ends.

bounds(Pipe, T, Lines) :-
    (   pipe_interval(Pipe, T, _-Line1, _-Line2)
    ->  Lines = Line1-Line2
    ;   Lines = nothing
    ).

is_between(T1, T2, T0) :-
    T is T0 - 360.0*floor((T0-T1)/360.0),
    T =< T2.

test(events, forall(numbered(24, 160, Seed))) :-
    case(Seed, Kind, Own, Other),
    (   pipe_met(Kind, Own, Other, Pipe)
    ->  pipe_events(Pipe, Events),
        forall(( between(0, 89, I), T1 is 4*I+0.125, T2 is T1+4.0,
                 bounds(Pipe, T1, Lines1), bounds(Pipe, T2, Lines2),
                 Lines1 \== Lines2 ),
               (   member(T-_, Events),
                   is_between(T1, T2, T)
               ->  true
               ;   throw(no_event(Seed, T1, Lines1, Lines2))
               )),
        forall(member(T-tip, Events),
               (   T1 is T-1.0e-4,
                   T2 is T+1.0e-4,
                   bounds(Pipe, T1, Lines1),
                   bounds(Pipe, T2, Lines2),
                   ( Lines1 == nothing ; Lines2 == nothing )
               ->  true
               ;   throw(no_tip(Seed, T))
               ))
    ;   true
    ).

%   A pipe along the axis of another one, or across it.

pipe(Axis, R, cylinder(point(0,0,0), U, V, W)) :-
    (   Axis == z
    ->  U = vector(R,0,0),
        V = vector(0,R,0),
        W = vector(0,0,40)
    ;   U = vector(0,R,0),
        V = vector(0,0,R),
        W = vector(40,0,0)
    ).

test(runs_along, fail) :-
    pipe(z, 10, Pipe),
    pipe(z, 20, Other),
    pipe_met(cylinder, Pipe, Other, _).
test(touching, Near == [true,true,false]) :-
    pipe(x, 10, Pipe),
    findall(Is,
            ( member(R, [10,10.4,12]),
              pipe(z, R, Other),
              pipe_met(cylinder, Pipe, Other, Met),
              ( pipe_near_touching(Met) -> Is = true ; Is = false ) ),
            Near).

:- end_tests(true_pipe).
