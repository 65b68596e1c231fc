:- module(sg_true_pipe,
          [ pipe_met/4,                 % +Kind, +Surface, +Other, -Pipe
            pipe_near_touching/1,       % +Pipe
            pipe_interval/4,            % +Pipe, +T, -Low, -High
            pipe_height/4,              % +Pipe, +Line, +T, -H
            pipe_crossing/5,            % +Surface, +Other, +T, +H0, -H
            pipe_events/2,              % +Pipe, -Events
            pipe_centers/2              % +Pipe, -Centers
          ]).
:- use_module('../near', [is_exactly/2]).
:- use_module(true_quadratic,
              [ on_circle/3, coordinate/3, quadratic/5, discriminant/5,
                signed_form/3, slope_sign/3, value_sign/3
              ]).
:- use_module('../vector',
              [cross_product/3, difference/3, dot_product/3]).
:- use_module(library(apply), [foldl/4, maplist/3, maplist/4]).
:- use_module(library(lists), [append/2, append/3, member/2, min_list/2]).
/** <module> Where generators of a cylinder or cone go through a convex solid.

The generator at T is a line; a cylinder, a cone, a sphere or a hemisphere with
its ends is convex, so it takes one interval of that line, or nothing. In the
coordinates X, Y, Z of the other surface it is X^2 + Y^2 + S*N^2 =< Const, with
N linear in Z, and these are linear in H along the generator; so there

    A*H^2 + 2*B*H + C =< 0,     H = (-B - or + sqrt(D))/A,   D = B^2 - A*C

with A, B, C polynomials of the cosine and sine of T. Nearly tangent, D is a
small number that floating point would lose. Here it is exact: the tangent of
half of T, which is a number of the machine, makes the cosine and sine rational,
and a pair of them that is exactly on the circle.

So tips, where a line begins and ends, are where D is 0: that is what tells one
loop from two, and no facet is asked. An extreme of D that is 0 but for rounding
of coordinates is a touch: D is taken less that, round it.

A pipe is pipe(Rows, Other, Caps, Extremes): Rows are the coordinates X, Y and
Z, each row(A0, A1, A2, A3, F) for A0 + A3*H + (1+F*H)*(A1*cos(T) + A2*sin(T));
Other is quadric(S, N0, N1, Const), N being N0 + N1*Z; Caps are the Z at which
it ends. An extreme is extreme(T, D, Foot, Near): D is exact there, and least or
greatest; Near is true if the surfaces nearly touch, in parts of both. What
bounds an interval is a Line: line(-1) or line(1), on the side, or cap(0) or
cap(1), an end.
*/

%!  pipe_met(+Kind, +Surface, +Other, -Pipe) is semidet.
%
%   Pipe says where generators of Surface, a cylinder or cone, go through a
%   solid of this Kind (cylinder, cone, sphere, hemisphere) with the side Other.
%   Fails if they run along it.

pipe_met(Kind, Surface, Other, pipe(Rows, Quadric, Caps, Extremes)) :-
    own_frame(Surface, [C,U,V,W], F),
    other_frame(Kind, Other, [C2,U2,V2,W2], Quadric, Caps),
    maplist(exact, [C,U,V,W,C2,U2,V2,W2], [QC,QU,QV,QW,QC2,QU2,QV2,QW2]),
    cross_product(QV2, QW2, Row1),
    cross_product(QW2, QU2, Row2),
    cross_product(QU2, QV2, Row3),
    dot_product(QU2, Row1, Volume),
    difference(QC, QC2, From),
    maplist(row_form(Volume, F, [From,QU,QV,QW]), [Row1,Row2,Row3], Rows),
    \+ runs_along(Rows, Quadric),
    extremes(Rows, Quadric, Caps, Extremes).

own_frame(cylinder(C,U,V,W), [C,U,V,W], 0).
own_frame(cone(C,U,V,W,K), [C,U,V,W], F) :-
    F is rational(K) - 1.

other_frame(cylinder, cylinder(C,U,V,W), [C,U,V,W], quadric(0, 0, 0, 1),
            [0,1]).
other_frame(cone, cone(C,U,V,W,K), [C,U,V,W], quadric(-1, 1, F, 0), [0,1]) :-
    F is rational(K) - 1.
other_frame(sphere, sphere(C,U,V,W), [C,U,V,W], quadric(1, 0, 1, 1), []).
other_frame(hemisphere, sphere(C,U,V,W), [C,U,V,W], quadric(1, 0, 1, 1), [0]).

runs_along([row(_, A1, A2, A3, 0),row(_, B1, B2, B3, 0)|_],
           quadric(0, _, _, _)) :-
    Along is float(A3*A3 + B3*B3),
    Radii is float(A1*A1 + B1*B1 + A2*A2 + B2*B2 + A3*A3 + B3*B3),
    is_exactly(Along, Radii).

exact(point(X0,Y0,Z0), p(X,Y,Z)) :-
    maplist(as_rational, [X0,Y0,Z0], [X,Y,Z]).
exact(vector(X0,Y0,Z0), p(X,Y,Z)) :-
    maplist(as_rational, [X0,Y0,Z0], [X,Y,Z]).

as_rational(X, Q) :-
    Q is rational(X).

row_form(Volume, F, Vectors, Row, row(A0, A1, A2, A3, F)) :-
    maplist(divided_dot(Volume, Row), Vectors, [A0,A1,A2,A3]).

divided_dot(Volume, Row, Vector, Q) :-
    dot_product(Row, Vector, Dot),
    Q is rdiv(Dot, Volume).


                /*******************************
                *           EXTREMES           *
                *******************************/

%   extremes(Rows, Quadric, Caps, Extremes): one in a degree at the most.

extremes(Rows, Quadric, Caps, Extremes) :-
    signed_form(Rows, Quadric, Form),
    findall(Sign,
            ( between(0, 360, T), slope_sign(Form, T, Sign) ),
            Signs),
    extremes_(Signs, 0, Form, Caps, Extremes).

extremes_([S1,S2|Signs], T1, Form, Caps, Extremes) :-
    !,
    T2 is T1+1,
    (   between_signs(S1, S2)
    ->  bisected(slope_sign(Form), T1, S1, T2, 52, T),
        extreme(Form, Caps, T, Extreme),
        Extremes = [Extreme|Extremes1]
    ;   Extremes = Extremes1
    ),
    extremes_([S2|Signs], T2, Form, Caps, Extremes1).
extremes_([_], _, _, _, []).

between_signs(V1, V2) :-
    (   V1 =:= 0
    ->  true
    ;   V2 =\= 0,
        V1*V2 < 0
    ).

%   extreme(Form, Caps, T, Extreme): where the line does not cross the surface,
%   Off is how far, the radius of that 1 or so.

extreme(form(Rows, Quadric, _), Caps, T, extreme(T, D, Foot, Near)) :-
    quadratic(Rows, Quadric, T, abc(A, B, C), _),
    D is B*B - A*C,
    (   A > 0
    ->  Foot is float(rdiv(-B, A)),
        Off is float(rdiv(D, A)),
        Size is 1.0 + float(abs(C)),
        (   is_exactly(Off, Size)
        ->  Near = touch
        ;   abs(Off) < 0.1,
            Foot > -0.1,
            Foot < 1.1,
            foot_in_reach(Caps, Rows, T, Foot)
        ->  Near = true
        ;   Near = false
        )
    ;   Foot = none,
        Near = false
    ).

foot_in_reach([], _, _, _) :-
    !.
foot_in_reach(_, [_,_,Up], T, Foot) :-
    up_at(Up, T, U0, U1),
    Z is U0 + U1*Foot,
    Z > -0.1,
    Z < 1.1.

%!  pipe_near_touching(+Pipe) is semidet.
%
%   True when the sides come nearer to being tangent than a twentieth of the
%   radius of the other surface, or touch.

pipe_near_touching(pipe(_, _, _, Extremes)) :-
    member(extreme(_, _, _, Near), Extremes),
    Near \== false,
    !.

%   settled_root(Pipe, T, A, B, C, Root): Root is that of the discriminant, D,
%   at T; round a touch D is taken less what it is there. Fails if it is
%   negative.

settled_root(pipe(Rows, Quadric, _, Extremes), T, A, B, C, Root) :-
    quadratic(Rows, Quadric, T, abc(A, B, C), _),
    (   member(extreme(T0, D0, _, touch), Extremes),
        Off is T - T0 - 360.0*round((T-T0)/360.0),
        abs(Off) < 0.5
    ->  D is B*B - A*C - D0
    ;   D is B*B - A*C
    ),
    D >= 0,
    Root is sqrt(float(D)).

%   root_height(A, B, C, Root, Sign, H): of the two numbers H where A*H^2 +
%   2*B*H + C is 0, that where it falls (-1) or grows (1).

root_height(A, B, C, Root, Sign, H) :-
    FB is float(B),
    (   Sign*FB > 0.0
    ->  H is float(C)/(-FB - Sign*Root)
    ;   A =:= 0
    ->  H is Sign*1.0e300
    ;   H is (Sign*Root - FB)/float(A)
    ).

%!  pipe_interval(+Pipe, +T, -Low, -High) is semidet.
%
%   The other solid takes the generator at T from Low to High, each H-Line.
%   Fails if it takes nothing.

pipe_interval(Pipe, T, Low, High) :-
    settled_root(Pipe, T, A, B, C, Root),
    Root > 0.0,
    maplist(root_height(A, B, C, Root), [-1,1], [H1,H2]),
    Pipe = pipe([_,_,Up], Quadric, Caps, _),
    up_at(Up, T, U0, U1),
    (   A > 0
    ->  Low0 = H1-line(-1),
        High0 = H2-line(1)
    ;   quadric_side(Quadric, U0, U1, H2)
    ->  Low0 = -1.0e300-none,
        High0 = H2-line(1)
    ;   Low0 = H1-line(-1),
        High0 = 1.0e300-none
    ),
    foldl(cut_by_cap(U0, U1), Caps, Low0-High0, Low-High),
    Low = From-_,
    High = To-_,
    From < To.

%   quadric_side(Quadric, U0, U1, H): that half of the cone which is meant.

quadric_side(quadric(_, N0, N1, _), U0, U1, H) :-
    N0 + float(N1)*(U0 + U1*H) >= 0.0.

cut_by_cap(U0, U1, K, Low0-High0, Low-High) :-
    (   is_exactly(U1, 1.0 + abs(U0))
    ->  ( K =:= 0 -> U0 >= 0.0 ; U0 =< 1.0 ),
        Low = Low0,
        High = High0
    ;   H is (K-U0)/U1,
        (   (K-0.5)*U1 < 0.0
        ->  higher(Low0, H-cap(K), Low),
            High = High0
        ;   Low = Low0,
            lower(High0, H-cap(K), High)
        )
    ).

higher(A-L, B-M, Which) :-
    ( B > A -> Which = B-M ; Which = A-L ).

lower(A-L, B-M, Which) :-
    ( B < A -> Which = B-M ; Which = A-L ).

%   up_at(Up, T, U0, U1): Z is U0 + U1*H along the generator at T.

up_at(row(A0, A1, A2, A3, F), T, U0, U1) :-
    Radians is T*pi/180.0,
    Across is float(A1)*cos(Radians) + float(A2)*sin(Radians),
    U0 is float(A0) + Across,
    U1 is float(A3) + float(F)*Across.

%!  pipe_height(+Pipe, +Line, +T, -H) is det.
%
%   H is where the generator at T goes through Line: line(-1) or line(1), the
%   first or last point of the side (the foot beyond the tips), foot, or cap(K).

pipe_height(Pipe, line(Sign), T, H) :-
    (   settled_root(Pipe, T, A, B, C, Root)
    ->  root_height(A, B, C, Root, Sign, H)
    ;   pipe_height(Pipe, foot, T, H)
    ).
pipe_height(pipe(Rows, Quadric, _, _), foot, T, H) :-
    quadratic(Rows, Quadric, T, abc(A, B, _), _),
    (   A =:= 0
    ->  H = 0.0
    ;   H is float(rdiv(-B, A))
    ).
pipe_height(pipe([_,_,Up], _, _, _), cap(K), T, H) :-
    up_at(Up, T, U0, U1),
    H is (K-U0)/U1.

%!  pipe_crossing(+Surface, +Other, +T, +H0, -H) is semidet.
%
%   H, of the two near H0 the nearer one, is where the generator at T of
%   Surface, a cylinder or cone, goes through Other, a cylinder, cone or sphere.

pipe_crossing(Surface, Other, T, H0, H) :-
    functor(Other, Kind, _),
    pipe_met(Kind, Surface, Other, Pipe),
    maplist(pipe_line(Pipe, T), [-1,1], [H1,H2]),
    (   abs(H1-H0) =< abs(H2-H0)
    ->  H = H1
    ;   H = H2
    ).

pipe_line(Pipe, T, Sign, H) :-
    pipe_height(Pipe, line(Sign), T, H).

%!  pipe_centers(+Pipe, -Centers) is det.
%
%   Centers is a list of T-Size: round T, within Size degrees and some times
%   that, the line turns faster than a circle does.

pipe_centers(Pipe, Centers) :-
    Pipe = pipe(_, _, _, Extremes),
    findall(T-Size,
            (   pipe_tip(Pipe, T),
                from_extremes(Extremes, T, Off),
                Size is min(Off, 1.0)*0.05
            ;   member(extreme(T, D, _, true), Extremes),
                D > 0,
                bend_size(Pipe, T, D, Size)
            ),
            Centers).

from_extremes(Extremes, T, Off) :-
    findall(Off1,
            ( member(extreme(T0, _, _, _), Extremes),
              Off1 is abs(T-T0 - 360.0*round((T-T0)/360.0)) ),
            Offs),
    min_list(Offs, Off).

%   bend_size(Pipe, T, D, Degrees): so far from T, where it is least, the
%   discriminant has grown as much as it is there.

bend_size(pipe(Rows, Quadric, _, _), T, D, Degrees) :-
    Step = 0.0078125,
    T1 is T-Step,
    T2 is T+Step,
    discriminant(Rows, Quadric, T1, _, S1),
    discriminant(Rows, Quadric, T2, _, S2),
    Bend is float(S2-S1)/(2.0*Step*pi/180.0),
    Bend > 0.0,
    Degrees is sqrt(2.0*float(D)/Bend)*180.0/pi.

%   pipe_tip(Pipe, T) is nondet: D is 0 at T, between two extremes that have
%   other signs.

pipe_tip(pipe(Rows, Quadric, _, Extremes), T) :-
    Extremes = [extreme(First, D, Foot, Near)|_],
    Again is First+360.0,
    append(Extremes, [extreme(Again, D, Foot, Near)], Round),
    append(_, [extreme(T1, D1, _, Near1),extreme(T2, D2, _, Near2)|_], Round),
    Near1 \== touch,
    Near2 \== touch,
    D1*D2 < 0,
    signed_form(Rows, Quadric, Form),
    Sign is sign(D1),
    bisected(value_sign(Form), T1, Sign, T2, 60, T).


                /*******************************
                *            EVENTS            *
                *******************************/

%!  pipe_events(+Pipe, -Events) is det.
%
%   Events is a list of T-What, the generators at which lines change places:
%   tip, both lines are in their foot; both(Line1, Line2), those have one
%   point, Line2 being the plainer one: cap(K) or rim(K), that is H = K; or
%   `side`, the generator lies in an end of the other solid.

pipe_events(Pipe, Events) :-
    findall(T-What, event(Pipe, T, What), Events).

event(Pipe, T, tip) :-
    pipe_tip(Pipe, T).
event(pipe(_, _, _, Extremes), T, What) :-
    member(extreme(T, D, _, Near), Extremes),
    (   Near == touch
    ->  What = tip
    ;   Near == true,
        D > 0,
        What = none
    ).
event(Pipe, T, both(line(Sign), rim(K))) :-
    member(K, [0,1]),
    goes_to_zero(over_rim(Pipe, K), T),
    nearer_line(Pipe, T, K, Sign).
event(Pipe, T, What) :-
    Pipe = pipe([_,_,Up], _, Caps, _),
    Up = row(A0, A1, A2, A3, F),
    member(K, Caps),
    (   runs_level(Up, K)
    ->  What = side,
        Rest is float(K-A0),
        angle_of(A1, A2, Rest, T)
    ;   goes_to_zero(over_cap(Pipe, K), T),
        pipe_height(Pipe, cap(K), T, H),
        abs(H) < 1.0e6,
        What = both(line(Sign), cap(K)),
        nearer_line(Pipe, T, H, Sign)
    ;   member(Rim, [0,1]),
        What = both(cap(K), rim(Rim)),
        Rest is float(K - A0 - A3*Rim),
        By is 1 + F*Rim,
        By =\= 0,
        B is By*A1,
        C is By*A2,
        angle_of(B, C, Rest, T)
    ).

%   runs_level(Up, K): generators run along that end of the other solid, or, of
%   a cone, its apex lies in the plane of that.

runs_level(row(A0, A1, A2, A3, F), K) :-
    Off is float(A3 - F*(A0-K)),
    is_exactly(Off, float(abs(A1) + abs(A2) + abs(A3))).

%   over_rim(Pipe, K, T, Over, Slope): how far out the generator is at H = K.

over_rim(pipe(Rows, Quadric, _, _), K, T, Over, Slope) :-
    quadratic(Rows, Quadric, T, abc(A, B, C), abc(DA, DB, DC)),
    Over is A*K*K + 2*B*K + C,
    Slope is DA*K*K + 2*DB*K + DC.

%   over_cap(Pipe, K, T, Over, Slope): how far out the generator is where it
%   goes through an end, times the square of how steeply it does.

over_cap(pipe(Rows, Quadric, _, _), K, T, Over, Slope) :-
    quadratic(Rows, Quadric, T, abc(A, B, C), abc(DA, DB, DC)),
    on_circle(T, Cos, Sin),
    Rows = [_,_,Up],
    coordinate(Cos-Sin, Up, c(U0, U1, D0, D1)),
    R is K-U0,
    Over is A*R*R + 2*B*R*U1 + C*U1*U1,
    Slope is DA*R*R - 2*A*R*D0 + 2*DB*R*U1 - 2*B*D0*U1 + 2*B*R*D1
           + DC*U1*U1 + 2*C*U1*D1.

%   angle_of(B, C, A, T): B*cos(T) + C*sin(T) is A.

angle_of(B0, C0, A, T) :-
    B is float(B0),
    C is float(C0),
    Size is sqrt(B*B + C*C),
    Size > 0.0,
    abs(A) =< Size,
    Middle is atan2(C, B)*180.0/pi,
    Off is acos(A/Size)*180.0/pi,
    ( T is Middle-Off ; T is Middle+Off ).

nearer_line(Pipe, T, H, Sign) :-
    maplist(pipe_line(Pipe, T), [-1,1], [H1,H2]),
    (   abs(H1-H) =< abs(H2-H)
    ->  Sign = -1
    ;   Sign = 1
    ).

%   goes_to_zero(Over, T) is nondet: call(Over, T, 0, _). Between a whole
%   degree, and where it is greatest or least, and the next one that is so
%   once at the most. Where it just touches 0 is one of them.

goes_to_zero(Over, T) :-
    findall(V-S,
            ( between(0, 360, T0),
              call(Over, T0, V0, S),
              ( is_exactly(float(V0), 1.0) -> V = 0 ; V = V0 ) ),
            Values),
    findall(T1,
            ( nth0_pair(Values, T0, V1-S1, V2-S2),
              T2 is T0+1,
              (   S1*S2 < 0
              ->  bisected(over_slope(Over), T0, S1, T2, 52, Extreme),
                  call(Over, Extreme, V, _),
                  (   is_exactly(float(V), 1.0)
                  ->  T1 = Extreme
                  ;   ( zero_between(Over, T0, V1, Extreme, V, T1)
                      ; zero_between(Over, Extreme, V, T2, V2, T1)
                      )
                  )
              ;   zero_between(Over, T0, V1, T2, V2, T1)
              ) ),
            Ts),
    member(T, Ts).

nth0_pair(Values, I, V1, V2) :-
    nth0_pair_(Values, 0, I, V1, V2).

nth0_pair_([A,B|Values], I0, I, V1, V2) :-
    (   I = I0,
        V1 = A,
        V2 = B
    ;   I1 is I0+1,
        nth0_pair_([B|Values], I1, I, V1, V2)
    ).

zero_between(Over, T1, V1, T2, V2, T) :-
    (   V1 =:= 0
    ->  T is float(T1)
    ;   V1*V2 < 0
    ->  bisected(over_value(Over), T1, V1, T2, 60, T)
    ).

over_value(Over, T, V) :-
    call(Over, T, V, _).

over_slope(Over, T, S) :-
    call(Over, T, _, S).

bisected(_, T1, _, T2, 0, T) :-
    !,
    T is (T1+T2)/2.0.
bisected(Function, T1, V1, T2, N, T) :-
    Middle is (T1+T2)/2.0,
    call(Function, Middle, V),
    N1 is N-1,
    (   V1*V =< 0
    ->  bisected(Function, T1, V1, Middle, N1, T)
    ;   bisected(Function, Middle, V, T2, N1, T)
    ).
