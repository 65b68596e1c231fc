:- module(sg_transition_outline,
          [ outline_curves/3,           % +Outline, +Term, -Curves
            outline_frame/3,            % +Given, -Base, -Top
            outline_widest/2,           % +Outline, -Radius
            outline_middle/2,           % +Outline, -Middle
            outline_rings/4,            % +N, +Placed1, +Placed2, -Rings
            placed_curves/3,            % +Frame, +Curves, -Placed
            arc_point/3                 % +Arc, +T, -P
          ]).
:- use_module('../near', [tolerance/2, less_part/2]).
:- use_module('../angle', [exact_sin_cos/3]).
:- use_module(outline, [outline_loops/4]).
:- use_module(primitive_argument, [given/3, primitive_error/2]).
:- use_module(shape, [rectangle_loop/3]).
:- use_module('../vector',
              [ cross_product/3, difference/3, dot_product/3, scaled/3,
                vector_sum/3
              ]).
:- use_module(library(apply), [foldl/4, maplist/3, maplist/4]).
:- use_module(library(lists),
              [append/2, append/3, last/2, member/2]).
/** <module> Outlines of transitions: convex, of straight edges and arcs.

An outline is circle(R), ellipse(A, B), rectangle(A, B), rectangle(A, B, R) with
rounded corners, or polygon([X-Y, ...]). Its *curves*, counter-clockwise round
the origin, are line(X-Y, X-Y) and arc(X-Y, A-B, T1, T2): the points
X + A*cos(t), Y + B*sin(t), degrees.

*Placed*, in a plane of space, they are line(P, Q) and arc(Arc, T1, T2), with
Arc = arc(C, U, V): C + cos(t)*U + sin(t)*V. Points and vectors are p(X,Y,Z). A
*ring* is a list of node(P, Step): a corner of the polygon that stands for the
outline, and what leads to the next one: `line`, or arc(Arc, T1, T2).
*/

%!  outline_widest(+Outline, -Radius) is det.
%
%   Radius is the greatest of its arcs, 1.0 if it has none.

outline_widest(circle(R), R).
outline_widest(ellipse(A, B), R) :-
    R is max(A, B).
outline_widest(rectangle(_, _), 1.0).
outline_widest(rectangle(_, _, R), R).
outline_widest(polygon(_), 1.0).

%!  outline_middle(+Outline, -Middle) is det.
%
%   Middle, X-Y, is inside: of a polygon the mean of its corners, else the
%   origin.

outline_middle(Outline, X-Y) :-
    (   Outline = polygon(Corners)
    ->  length(Corners, N),
        foldl(corner_sum, Corners, 0.0-0.0, X0-Y0),
        X is X0/N,
        Y is Y0/N
    ;   X-Y = 0.0-0.0
    ).

corner_sum(X1-Y1, X0-Y0, X-Y) :-
    X is X0+X1,
    Y is Y0+Y1.

%!  outline_curves(+Outline, +Term, -Curves) is det.
%
%   Curves are those of Outline, an argument of the primitive Term.
%
%   @error model_error(primitive(What, Term)): corners_too_round(R),
%   not_convex(X, Y), and those of outline_loops/4

outline_curves(circle(R), _, [arc(0.0-0.0, R-R, 0.0, 360.0)]).
outline_curves(ellipse(A, B), _, [arc(0.0-0.0, A-B, 0.0, 360.0)]).
outline_curves(rectangle(A, B), _, Lines) :-
    rectangle_loop(A, B, Loop),
    loop_lines(Loop, Lines).
outline_curves(rectangle(A, B, R), Term, Curves) :-
    X is A/2.0 - R,
    Y is B/2.0 - R,
    (   ( X < 0.0 ; Y < 0.0 )
    ->  primitive_error(corners_too_round(R), Term)
    ;   true
    ),
    Corners = [corner(1, 1, 0.0), corner(-1, 1, 90.0), corner(-1, -1, 180.0),
               corner(1, -1, 270.0)],
    maplist(round_corner(X, Y, R), Corners, Arcs),
    joined_arcs(Arcs, Curves).
outline_curves(polygon(Points), Term, Lines) :-
    outline_loops(Points, [], Term, [Loop]),
    convex(Loop, Term),
    loop_lines(Loop, Lines).

loop_lines(Loop, Lines) :-
    Loop = [First|Rest],
    append(Rest, [First], Nexts),
    maplist(straight, Loop, Nexts, Lines).

straight(P, Q, line(P, Q)).

round_corner(X0, Y0, R, corner(SX, SY, T1), arc(X-Y, R-R, T1, T2)) :-
    X is SX*X0,
    Y is SY*Y0,
    T2 is T1 + 90.0.

%   joined_arcs(Arcs, Curves): with the straight edges between them.

joined_arcs(Arcs, Curves) :-
    Arcs = [First|Rest],
    append(Rest, [First], Nexts),
    maplist(arc_and_line, Arcs, Nexts, Lists),
    append(Lists, Curves).

arc_and_line(Arc, Next, Curves) :-
    arc_end(Arc, 4, P),
    arc_end(Next, 3, Q),
    (   P == Q
    ->  Curves = [Arc]
    ;   Curves = [Arc,line(P, Q)]
    ).

arc_end(Arc, Which, X-Y) :-
    Arc = arc(X0-Y0, A-B, _, _),
    arg(Which, Arc, T),
    exact_sin_cos(T, Sin, Cos),
    X is X0 + A*Cos,
    Y is Y0 + B*Sin.

%   convex(Loop, Term): it turns left at every corner.

convex(Loop, Term) :-
    last(Loop, Last),
    Loop = [First|_],
    append([Last|Loop], [First], Round),
    (   append(_, [X1-Y1,X2-Y2,X3-Y3|_], Round),
        Turn is (rational(X2)-rational(X1))*(rational(Y3)-rational(Y2))
              - (rational(Y2)-rational(Y1))*(rational(X3)-rational(X2)),
        Turn =< 0
    ->  primitive_error(not_convex(X2, Y2), Term)
    ;   true
    ).


                /*******************************
                *           IN SPACE           *
                *******************************/

%!  outline_frame(+Given, -Base, -Top) is det.
%
%   Base and Top are frame(O, E1, E2): where the origins of the outlines are,
%   and where their x and y point. The top is at `height`, moved by `shift`, its
%   plane leans by `tilt` degrees, and it is turned in it by `turn`.

outline_frame(Given, frame(p(0.0,0.0,0.0), p(1.0,0.0,0.0), p(0.0,1.0,0.0)),
              frame(p(X,Y,H), E1, E2)) :-
    given(Given, height, [H]),
    given(Given, shift, [X,Y]),
    given(Given, tilt, Tilt),
    (   Tilt = [Lean,Towards]
    ->  true
    ;   Tilt = [Lean],
        Towards = 0.0
    ),
    given(Given, turn, [Turn]),
    leaning(Lean, Towards, F1, F2),
    exact_sin_cos(Turn, Sin, Cos),
    combined(Cos, F1, Sin, F2, E1),
    Back is 0.0 - Sin,
    combined(Back, F1, Cos, F2, E2).

%   leaning(Lean, Towards, E1, E2): x and y, turned by Lean about the level line
%   at right angles to the direction Towards.

leaning(Lean, Towards, p(X1,XY,Z1), p(XY,Y2,Z2)) :-
    exact_sin_cos(Lean, SinL, CosL),
    exact_sin_cos(Towards, SinT, CosT),
    Rest is 1.0 - CosL,
    X1 is CosL + SinT*SinT*Rest,
    XY is 0.0 - SinT*CosT*Rest,
    Z1 is 0.0 - CosT*SinL,
    Y2 is CosL + CosT*CosT*Rest,
    Z2 is 0.0 - SinT*SinL.

combined(F, P, G, Q, Sum) :-
    scaled(F, P, A),
    scaled(G, Q, B),
    vector_sum(A, B, Sum).

%!  placed_curves(+Frame, +Curves, -Placed) is det.

placed_curves(Frame, Curves, Placed) :-
    maplist(placed_curve(Frame), Curves, Placed).

placed_curve(Frame, Curve, Placed) :-
    (   Curve = line(P0, Q0)
    ->  Placed = line(P, Q),
        placed_point(Frame, P0, P),
        placed_point(Frame, Q0, Q)
    ;   placed_arc(Curve, Frame, Placed)
    ).

placed_arc(arc(C0, A-B, T1, T2), Frame, arc(arc(C, U, V), T1, T2)) :-
    placed_point(Frame, C0, C),
    Frame = frame(_, E1, E2),
    scaled(A, E1, U),
    scaled(B, E2, V).

placed_point(frame(O, E1, E2), X-Y, P) :-
    combined(X, E1, Y, E2, By),
    vector_sum(O, By, P).


                /*******************************
                *            RINGS             *
                *******************************/

%!  outline_rings(+N, +Placed1, +Placed2, -Rings) is det.
%
%   Rings is Ring1-Ring2 of two outlines; arcs have N facets a full turn, and a
%   corner where the plane through an edge of the other outline touches them.

outline_rings(N, Placed1, Placed2, Ring1-Ring2) :-
    placed_middle(Placed1, M1),
    placed_middle(Placed2, M2),
    maplist(curve_nodes(N, M1, Placed2-M2), Placed1, Lists1),
    maplist(curve_nodes(N, M2, Placed1-M1), Placed2, Lists2),
    append(Lists1, Ring1),
    append(Lists2, Ring2).

%   placed_middle(Placed, Middle): a point inside.

placed_middle(Placed, Middle) :-
    maplist(curve_middle, Placed, Points),
    foldl(vector_sum, Points, p(0.0,0.0,0.0), Sum),
    length(Points, N),
    F is 1.0/N,
    scaled(F, Sum, Middle).

curve_middle(Curve, Middle) :-
    (   Curve = line(Middle, _)
    ->  true
    ;   Curve = arc(arc(Middle, _, _), _, _)
    ).

curve_nodes(N, Own, Other, Curve, Nodes) :-
    (   Curve = line(P, _)
    ->  Nodes = [node(P, line)]
    ;   arc_nodes(Curve, N, Own, Other, Nodes)
    ).

arc_nodes(arc(Arc, T1, T2), N, Own, Other-Middle, Nodes) :-
    findall(T,
            ( member(line(P, Q), Other),
              touching(Arc, P, Q, Own, Middle, T0),
              within_arc(T1, T2, T0, T) ),
            Touching),
    arc_places(N, T1, T2, Touching, Ts),
    closed_turn(T1, T2, Ts, Closed),
    steps(Closed, Arc, Nodes).

%   touching(Arc, P, Q, Own, Middle, T): the plane through P and Q touches Arc
%   at T, and Own and Middle, which lie inside of either outline, are on one
%   side of it. With the tangent D there, det(Arc(T) - P, Q - P, D) = 0.

touching(Arc, P, Q, Own, Middle, T) :-
    Arc = arc(C, U, V),
    difference(Q, P, Along),
    difference(C, P, From),
    determinant(From, Along, V, A),
    determinant(From, Along, U, B),
    determinant(U, Along, V, F),
    R is sqrt(A*A + B*B),
    abs(F) =< R,
    Base is -atan2(B, A),
    Off is acos(max(-1.0, min(1.0, -F/R))),
    member(Sign, [1.0,-1.0]),
    T is (Base + Sign*Off)*180.0/pi,
    arc_point(Arc, T, X),
    difference(X, P, To),
    cross_product(Along, To, Normal),
    above(Normal, P, Own, Above1),
    above(Normal, P, Middle, Above2),
    Above1*Above2 > 0.0.

above(Normal, P, X, Above) :-
    difference(X, P, To),
    dot_product(Normal, To, Above).

determinant(A, B, C, Determinant) :-
    cross_product(A, B, AB),
    dot_product(AB, C, Determinant).

within_arc(T1, T2, T0, T) :-
    T is T0 + 360.0*ceiling((T1-T0)/360.0),
    T < T2.

%   arc_places(N, T1, T2, Touching, Ts): equal steps and the Touching, but no
%   step nearer to one of these than a tenth of its width.

arc_places(N, T1, T2, Touching0, Ts) :-
    Whole is rational(T2)-rational(T1),
    Count is max(1, round(N*Whole/360)),
    findall(T,
            ( between(0, Count, I),
              T is float(rational(T1) + Whole*I/Count) ),
            Regular),
    sort(Touching0, Touching1),
    tolerance(angle, Rounding),
    findall(T,
            ( member(T, Touching1),
              \+ near_one(Regular, Rounding, T) ),
            Touching),
    Near is float(Whole/Count)/10.0,
    (   Whole =:= 360
    ->  findall(T, ( member(T0, Touching), member(By, [-360.0,0.0,360.0]),
                     T is T0+By ),
                Giving),
        From is T1 - 1.0
    ;   Giving = Touching,
        From = T1
    ),
    To is T2 - (From-T1),
    findall(T,
            ( member(T, Regular),
              \+ ( T > From, T < To, near_one(Giving, Near, T) ) ),
            Kept),
    append(Kept, Touching, All),
    sort(All, Ts).

near_one(Places, Near, T) :-
    member(Place, Places),
    abs(Place-T) < Near,
    !.

%   closed_turn(T1, T2, Ts, Closed): of a full turn whose ends gave way, back to
%   the first.

closed_turn(T1, T2, Ts, Closed) :-
    Ts = [First|_],
    last(Ts, Last),
    (   T2-T1 =:= 360.0,
        less_part(Last-First, 360.0)
    ->  End is First + 360.0,
        append(Ts, [End], Closed)
    ;   Closed = Ts
    ).

%   steps(Ts, Arc, Nodes): from the first to the last but one.

steps([T1,T2|Ts], Arc, [node(P, arc(Arc, T1, T2))|Nodes]) :-
    !,
    arc_point(Arc, T1, P),
    steps([T2|Ts], Arc, Nodes).
steps([_], _, []).

%!  arc_point(+Arc, +T, -P) is det.
%
%   P is the point of Arc, in space, at T degrees.

arc_point(arc(C, U, V), T, P) :-
    exact_sin_cos(T, Sin, Cos),
    combined(Cos, U, Sin, V, By),
    vector_sum(C, By, P).
