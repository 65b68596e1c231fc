:- module(sg_true_pipe,
          [ pipe_met/3,                 % +Surface, +Other, -Pipe
            pipe_near_touching/2,       % +Pipe, +Part
            pipe_interval/4,            % +Pipe, +T, -Low, -High
            pipe_height/4,              % +Pipe, +Line, +T, -H
            pipe_crossing/5,            % +Surface, +Other, +T, +H0, -H
            pipe_events/2,              % +Pipe, -Events
            pipe_centers/2              % +Pipe, -Centers
          ]).
:- use_module('../near', [is_exactly/2]).
:- use_module(library(apply), [maplist/3, maplist/4]).
:- use_module(library(lists), [append/2, member/2]).
/** <module> Where the generators of a cylinder go through another cylinder.

The generator at T of one cylinder is a line, and the other one with its two
ends is convex; so it takes one interval of that line, or nothing. Both ends of
the interval have a closed form: a foot, as far as the distance of the two lines
is concerned, less and more a root. With linear trigonometric forms
lin(A, B, C), A + B*cos(T) + C*sin(T), which the coordinates of the other
cylinder are along a section of the first,

    H = Foot(T) - or + sqrt((L-g(T))*(L+g(T)))/L^2

Nearly tangent, L-g is a small number that floating point would lose: the
difference of numbers of the size of the radius. It is the sum of its least
value, which is found exactly, in rational numbers, and of a square:

    L - g(T) = Least1 + 2*G*sin((T-Middle)/2)^2
    L + g(T) = Least2 + 2*G*cos((T-Middle)/2)^2

So tips, where a line begins and ends, are where these are 0: that is what tells
one loop from two, and no facet is asked.

A pipe is pipe(Foot, L, G, Middle, Least1-Least2, Form1-Form2, Up), with Form
and Up lin(A, B, C, PerH): the coordinates across and along the other cylinder.
What bounds its interval is a Line: line(-1) or line(1), on its side, or cap(0)
or cap(1), an end.
*/

%!  pipe_met(+Surface, +Other, -Pipe) is semidet.
%
%   Pipe says where generators of the cylinder Surface go through the cylinder
%   Other. Fails if they run along it.

pipe_met(cylinder(C, U, V, W), cylinder(C2, U2, V2, W2),
         pipe(Foot, L, G, Middle, Least, Form1-Form2, Up)) :-
    maplist(exact, [C,U,V,W,C2,U2,V2,W2], [QC,QU,QV,QW,QC2,QU2,QV2,QW2]),
    cross(QV2, QW2, Row1),
    cross(QW2, QU2, Row2),
    cross(QU2, QV2, Row3),
    dot(QU2, Row1, Volume),
    difference(QC, QC2, From),
    maplist(row_form(Volume, [From,QU,QV,QW]), [Row1,Row2,Row3],
            [A,B,H]),
    A = [A0,A1,A2,A3],
    B = [B0,B1,B2,B3],
    L2 is A3*A3 + B3*B3,
    L is sqrt(float(L2)),
    Radii is float(A1*A1 + B1*B1 + A2*A2 + B2*B2 + L2),
    \+ is_exactly(L2, Radii),
    G0 is B3*A0 - A3*B0,
    G1 is B3*A1 - A3*B1,
    G2 is B3*A2 - A3*B2,
    GG is G1*G1 + G2*G2,
    G is sqrt(float(GG)),
    G > 0.0,
    Middle is atan2(float(G2), float(G1))*180.0/pi,
    least(G0, GG, L2, L, G, Least1),
    MinusG0 is -G0,
    least(MinusG0, GG, L2, L, G, Least2),
    Least = Least1-Least2,
    maplist(foot_part(A3, B3, L2), [A0,A1,A2], [B0,B1,B2], [F0,F1,F2]),
    Foot = lin(F0, F1, F2),
    maplist(as_form, [A,B,H], [Form1,Form2,Up]).

exact(point(X0,Y0,Z0), v(X,Y,Z)) :-
    maplist(as_rational, [X0,Y0,Z0], [X,Y,Z]).
exact(vector(X0,Y0,Z0), v(X,Y,Z)) :-
    maplist(as_rational, [X0,Y0,Z0], [X,Y,Z]).

as_rational(X, Q) :-
    Q is rational(X).

cross(v(X1,Y1,Z1), v(X2,Y2,Z2), v(X,Y,Z)) :-
    X is Y1*Z2 - Z1*Y2,
    Y is Z1*X2 - X1*Z2,
    Z is X1*Y2 - Y1*X2.

dot(v(X1,Y1,Z1), v(X2,Y2,Z2), Dot) :-
    Dot is X1*X2 + Y1*Y2 + Z1*Z2.

difference(v(X1,Y1,Z1), v(X2,Y2,Z2), v(X,Y,Z)) :-
    X is X1-X2,
    Y is Y1-Y2,
    Z is Z1-Z2.

row_form(Volume, Vectors, Row, Form) :-
    maplist(divided_dot(Volume, Row), Vectors, Form).

divided_dot(Volume, Row, Vector, Q) :-
    dot(Row, Vector, Dot),
    Q is rdiv(Dot, Volume).

as_form(List, Form) :-
    maplist(as_float, List, Floats),
    Form =.. [lin|Floats].

as_float(Q, X) :-
    X is float(Q).

foot_part(A3, B3, L2, A, B, F) :-
    F is float(rdiv(-(A3*A + B3*B), L2)).

%   least(G0, GG, L2, L, G, Least): Least is L - G0 - G, G the root of GG and L
%   that of L2, all but G and L exact: it has the sign of, and is 0 with,
%   (L-G0)^2 - GG, of which all but 2*G0*L is rational. What rounding of the
%   coordinates leaves is 0.

least(G0, GG, L2, L, G, Least) :-
    Q is L2 + G0*G0 - GG,
    Twice is 2.0*abs(G0)*L,
    (   G0 =< 0
    ->  Square is float(Q) + Twice
    ;   Q > 0
    ->  Square is float(Q*Q - 4*G0*G0*L2)/(float(Q) + Twice)
    ;   Square is float(Q) - Twice
    ),
    Least0 is Square/(L - float(G0) + G),
    (   is_exactly(Least0, L)
    ->  Least = 0.0
    ;   Least = Least0
    ).

%!  pipe_near_touching(+Pipe, +Part) is semidet.
%
%   True when the sides come nearer to being tangent than Part of the radius of
%   the other cylinder.

pipe_near_touching(pipe(_, L, _, _, Least1-Least2, _, _), Part) :-
    (   abs(Least1) < Part*L
    ;   abs(Least2) < Part*L
    ),
    !.

%!  pipe_interval(+Pipe, +T, -Low, -High) is semidet.
%
%   The other cylinder takes the generator at T from Low to High, each H-Line.
%   Fails if it takes nothing.

pipe_interval(Pipe, T, Low, High) :-
    root(Pipe, T, Root),
    Root > 0.0,
    foot(Pipe, T, Foot),
    Low1 is Foot-Root,
    High1 is Foot+Root,
    Pipe = pipe(_, _, _, _, _, _, Up),
    (   runs_level(Up)
    ->  lin_at(Up, T, 0.0, At),
        At >= 0.0,
        At =< 1.0,
        Low = Low1-line(-1),
        High = High1-line(1)
    ;   pipe_height(Pipe, cap(0), T, H0),
        pipe_height(Pipe, cap(1), T, H1),
        (   H0 < H1
        ->  higher(Low1-line(-1), H0-cap(0), Low),
            lower(High1-line(1), H1-cap(1), High)
        ;   higher(Low1-line(-1), H1-cap(1), Low),
            lower(High1-line(1), H0-cap(0), High)
        )
    ),
    Low = From-_,
    High = To-_,
    From < To.

higher(A-L, B-M, Which) :-
    ( B > A -> Which = B-M ; Which = A-L ).

lower(A-L, B-M, Which) :-
    ( B < A -> Which = B-M ; Which = A-L ).

%   runs_level(Up): generators run along the ends of the other cylinder.

runs_level(lin(_, A, B, PerH)) :-
    is_exactly(PerH, abs(A) + abs(B)).

%   root(Pipe, T, Root): negative if the generator misses the other cylinder.

root(pipe(_, L, G, Middle, Least1-Least2, _, _), T, Root) :-
    Half is (T-Middle)*pi/360.0,
    A is Least1 + 2.0*G*sin(Half)**2,
    B is Least2 + 2.0*G*cos(Half)**2,
    (   A >= 0.0,
        B >= 0.0
    ->  Root is sqrt(A*B)/(L*L)
    ;   Root = -1.0
    ).

foot(pipe(Foot, _, _, _, _, _, _), T, H) :-
    lin_at(Foot, T, H).

lin_at(lin(A, B, C), T, Value) :-
    Radians is T*pi/180.0,
    Value is A + B*cos(Radians) + C*sin(Radians).

lin_at(lin(A, B, C, PerH), T, H, Value) :-
    Radians is T*pi/180.0,
    Value is A + B*cos(Radians) + C*sin(Radians) + PerH*H.

%!  pipe_height(+Pipe, +Line, +T, -H) is det.
%
%   H is where the generator at T goes through Line: line(-1) or line(1), the
%   first or last point of the side (the foot beyond the tips), foot, or cap(K).

pipe_height(Pipe, line(Sign), T, H) :-
    root(Pipe, T, Root),
    foot(Pipe, T, Foot),
    H is Foot + Sign*max(0.0, Root).
pipe_height(Pipe, foot, T, H) :-
    foot(Pipe, T, H).
pipe_height(pipe(_, _, _, _, _, _, Up), cap(K), T, H) :-
    Up = lin(_, _, _, PerH),
    lin_at(Up, T, 0.0, At),
    H is (K-At)/PerH.

%!  pipe_crossing(+Surface, +Other, +T, +H0, -H) is semidet.
%
%   H, of the two near H0 the nearer one, is where the generator at T of the
%   cylinder Surface goes through the side of the cylinder Other.

pipe_crossing(Surface, Other, T, H0, H) :-
    pipe_met(Surface, Other, Pipe),
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
    findall(T-Size,
            ( extreme(Pipe, T0, Least, G),
              tip_size(Least, G, Size0),
              (   Least < 0.0
              ->  ( T is T0-Size0 ; T is T0+Size0 ),
                  Size is min(Size0, 1.0)*0.05
              ;   Least > 0.0,
                  T = T0,
                  Size = Size0
              ) ),
            Centers).

extreme(pipe(_, _, G, Middle, Least-_, _, _), Middle, Least, G).
extreme(pipe(_, _, G, Middle, _-Least, _, _), T, Least, G) :-
    T is Middle + 180.0.

%   tip_size(Least, G, Degrees): how far from the middle the tip is.

tip_size(Least, G, Degrees) :-
    Degrees is 360.0/pi*asin(min(1.0, sqrt(abs(Least)/(2.0*G)))).


                /*******************************
                *            EVENTS            *
                *******************************/

%!  pipe_events(+Pipe, -Events) is det.
%
%   Events is a list of T-What, the generators at which lines change places:
%   tip, both lines are in their foot; both(Line1, Line2), those have one
%   point, Line2 being the plainer one: cap(K) or rim(K), that is H = K; or
%   `side`, the generator lies in an end of the other cylinder.

pipe_events(Pipe, Events) :-
    findall(T-What, event(Pipe, T, What), Events).

event(Pipe, T, tip) :-
    extreme(Pipe, T0, Least, G),
    Least =< 0.0,
    tip_size(Least, G, Size),
    (   Least =:= 0.0
    ->  T = T0
    ;   ( T is T0-Size ; T is T0+Size )
    ).
event(Pipe, T, none) :-
    extreme(Pipe, T, Least, _),
    Least > 0.0,
    pipe_near_touching(Pipe, 0.1).
event(Pipe, T, both(line(Sign), rim(K))) :-
    Pipe = pipe(_, _, _, _, _, Form1-Form2, _),
    member(K, [0,1]),
    maplist(at_height(lin(K, 0.0, 0.0)), [Form1,Form2], [A,B]),
    circle_meets(A, B, T),
    nearer_line(Pipe, T, K, Sign).
event(Pipe, T, What) :-
    Pipe = pipe(_, _, _, _, _, Form1-Form2, Up),
    Up = lin(A, B, C, PerH),
    member(K, [0,1]),
    (   runs_level(Up)
    ->  What = side,
        A1 is K-A,
        angle_of(B, C, A1, T)
    ;   At = lin(H0, H1, H2),
        H0 is (K-A)/PerH,
        H1 is -B/PerH,
        H2 is -C/PerH,
        (   maplist(at_height(At), [Form1,Form2], [Across1,Across2]),
            circle_meets(Across1, Across2, T),
            lin_at(At, T, H),
            What = both(line(Sign), cap(K)),
            nearer_line(Pipe, T, H, Sign)
        ;   member(Rim, [0,1]),
            What = both(cap(K), rim(Rim)),
            Rest is Rim-H0,
            angle_of(H1, H2, Rest, T)
        )
    ).

%   at_height(lin(H0, H1, H2), Form, Lin): Form on the surface at this H.

at_height(lin(H0, H1, H2), lin(A, B, C, PerH), lin(A1, B1, C1)) :-
    A1 is A + PerH*H0,
    B1 is B + PerH*H1,
    C1 is C + PerH*H2.

%   angle_of(B, C, A, T): B*cos(T) + C*sin(T) is A.

angle_of(B, C, A, T) :-
    Size is sqrt(B*B + C*C),
    Size > 0.0,
    abs(A) =< Size,
    Middle is atan2(C, B)*180.0/pi,
    Off is acos(A/Size)*180.0/pi,
    ( T is Middle-Off ; T is Middle+Off ).

nearer_line(Pipe, T, H, Sign) :-
    foot(Pipe, T, Foot),
    (   H < Foot
    ->  Sign = -1
    ;   Sign = 1
    ).

%   circle_meets(A, B, T) is nondet: A^2 + B^2 is 1 there. Between a whole
%   degree, and where it is greatest or least, and the next one it is 1 once at
%   the most. Where it just touches 1 is one of them.

circle_meets(A, B, T) :-
    findall(T0,
            ( between(0, 359, T1),
              T2 is T1+1,
              slope(A, B, T1, D1),
              slope(A, B, T2, D2),
              (   D1*D2 < 0.0
              ->  bisected(slope(A, B), T1, D1, T2, 60, Extreme),
                  over(A, B, Extreme, Over),
                  (   is_exactly(Over, 1.0)
                  ->  T0 = Extreme
                  ;   ( meets_between(A, B, T1, Extreme, T0)
                      ; meets_between(A, B, Extreme, T2, T0)
                      )
                  )
              ;   meets_between(A, B, T1, T2, T0)
              ) ),
            Ts),
    member(T, Ts).

meets_between(A, B, T1, T2, T) :-
    over(A, B, T1, V1),
    over(A, B, T2, V2),
    (   V1 =:= 0.0
    ->  T is float(T1)
    ;   V1*V2 < 0.0
    ->  bisected(over(A, B), T1, V1, T2, 60, T)
    ).

over(A, B, T, Over) :-
    lin_at(A, T, X),
    lin_at(B, T, Y),
    Over is X*X + Y*Y - 1.0.

slope(A, B, T, Slope) :-
    lin_at(A, T, X),
    lin_at(B, T, Y),
    turned(A, A1),
    turned(B, B1),
    lin_at(A1, T, DX),
    lin_at(B1, T, DY),
    Slope is X*DX + Y*DY.

turned(lin(_, B, C), lin(0.0, C, MinusB)) :-
    MinusB is -B.

bisected(_, T1, _, T2, 0, T) :-
    !,
    T is (T1+T2)/2.0.
bisected(Function, T1, V1, T2, N, T) :-
    Middle is (T1+T2)/2.0,
    call(Function, Middle, V),
    N1 is N-1,
    (   V1*V =< 0.0
    ->  bisected(Function, T1, V1, Middle, N1, T)
    ;   bisected(Function, Middle, V, T2, N1, T)
    ).
