:- module(sg_primitive_transition,
          [ transition_shape/2,         % +Given, -Shape
            open_transition_shape/2     % +Given, -Shape
          ]).
:- use_module('../near',
              [tolerance/2, same_angle/2, whole_turns/2, same_part/2]).
:- use_module(primitive_argument,
              [given/3, given_facets/4, primitive_error/2]).
:- use_module('../vector',
              [ cross_product/3, difference/3, dot_product/3, scaled/3,
                vector_sum/3
              ]).
:- use_module(transition_division, [rings_divided/3]).
:- use_module(transition_outline,
              [ outline_curves/3, outline_frame/3, outline_middle/2,
                outline_rings/4, outline_widest/2, placed_curves/3
              ]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists),
              [append/2, append/3, last/2, member/2, numlist/3, reverse/2]).
/** <module> Transitions: from one outline to another, of flat plates and cones.

The convex hull of two convex outlines in two planes, the classical transition
piece of sheet metal: an edge of one outline and the point of the other that is
seen farthest out from it span a flat triangle, a corner of one and an arc of
the other a part of an oblique cone; edges that are parallel span a trapezoid,
arcs that are similar a part of a cone or cylinder. Such parts touch each other
smoothly, so what is made of them unrolls. Between arcs that are not similar
facets of either arc take turns, each part of a cone with its apex on the other.

The outlines are walked round together (rotating calipers): always the step is
taken that leaves all else below the plane of the new triangle.
*/

%!  transition_shape(+Given, -Shape) is det.
%!  open_transition_shape(+Given, -Shape) is det.
%
%   Polygon 1 is the base, 2 the top (an open one has neither), then the sides,
%   in order: side(I) flat, and facets of curved(cone(I), _). Besides the
%   surfaces of these Surfaces has side(I)-fan(...), and side-transition(
%   pieces(Pieces)), with piece(Part, End, T1-T2, G1-G2) for each part, in
%   order: it lies between the generators T1 and T2 of its surface; h = 0 is at
%   its base, or top, as End says; and G1 and G2 are directions in degrees.
%
%   A *direction* is the mean of those in which the two ends of a generator are
%   seen, from +x, from the middles of the outlines, in their planes.
%
%   divided(N) of Given: each step along an arc is N. Between arcs that are not
%   similar these have cones of their own, nearer to the smooth surface.
%   as(Base, Top): it has the parts that it would have between these outlines,
%   which are a little smaller or larger, if there is as much of each.
%
%   @error model_error(primitive(What, Term)): planes_cross, and what
%   outline_curves/3 raises

transition_shape(Given, shape(Points, [face(base, [Base]), face(top, [Top])
                                      |Sides], Surfaces)) :-
    sides_made(Given, N, M, Points, Sides, Surfaces),
    numlist(1, N, Ring),
    reverse(Ring, Base),
    First is N+1,
    Last is N+M,
    numlist(First, Last, Top).

open_transition_shape(Given, shape(Points, Sides, Surfaces)) :-
    sides_made(Given, _, _, Points, Sides, Surfaces).

sides_made(Given, N, M, Points, Sides, Surfaces) :-
    Given = given(Term, _, _),
    given(Given, base, [Outline1]),
    given(Given, top, [Outline2]),
    rings(Given, Term, Outline1-Outline2, Ring1, Ring2, Frames),
    below_each_other(Ring1, Ring2, Frames, Term),
    tables(Given, Ring1, Ring2, Tables),
    Tables = Table1-Table2,
    steps_made(Given, Term, Tables, Steps),
    functor(Table1, _, N),
    functor(Table2, _, M),
    pieces(Steps, Table1, Table2, Pieces0),
    named_pieces(Pieces0, 1, 1, Pieces),
    maplist(piece_faces(Tables), Pieces, Lists),
    append(Lists, Sides),
    maplist(piece_surface(Tables), Pieces, Own),
    outlines_seen(Given, Frames, Seen1, Seen2),
    maplist(piece_place(Tables, Seen1, Seen2), Pieces, Places),
    append(Own, [side-transition(pieces(Places))], Surfaces),
    table_points(Table1, Points1),
    table_points(Table2, Points2),
    append(Points1, Points2, Points).

table_points(Table, Points) :-
    Table =.. [ring|Ring],
    maplist(node_point, Ring, Points).

outlines_seen(Given, Base-Top, Seen1, Seen2) :-
    given(Given, base, [Outline1]),
    given(Given, top, [Outline2]),
    given(Given, turn, [Turn]),
    seen_from(Base, Outline1, 0.0, Seen1),
    seen_from(Top, Outline2, Turn, Seen2).

node_point(node(p(X,Y,Z), _), point(X,Y,Z)).

%   rings(Given, Term, Outlines, Ring1, Ring2, Frames)

rings(Given, Term, Outline1-Outline2, Ring1, Ring2, Base-Top) :-
    as_drawn(Given, Outline1-Outline2, Drawn1-Drawn2),
    outline_widest(Drawn1, R1),
    outline_widest(Drawn2, R2),
    Widest is max(R1, R2),
    given_facets(Given, Widest, 360, N),
    outline_frame(Given, Base, Top),
    outline_curves(Outline1, Term, Curves1),
    outline_curves(Outline2, Term, Curves2),
    placed_curves(Base, Curves1, Placed1),
    placed_curves(Top, Curves2, Placed2),
    outline_rings(N, Placed1, Placed2, Ring1-Ring2).

as_drawn(Given, Outlines, Drawn1-Drawn2) :-
    (   given(Given, as, [Drawn1,Drawn2])
    ->  true
    ;   Outlines = Drawn1-Drawn2
    ).

tables(Given, Ring1, Ring2, Tables) :-
    ring_table(Ring1, Whole1),
    ring_table(Ring2, Whole2),
    given(Given, divided, [Times]),
    rings_divided(Times, Whole1-Whole2, Tables).

ring_table(Ring, Table) :-
    Table =.. [ring|Ring].

%   steps_made(Given, Term, Tables, Steps): those round other outlines, if it is
%   to be walked as round these, and can be.

steps_made(Given, Term, Table1-Table2, Steps) :-
    (   given(Given, as, [Outline1,Outline2]),
        rings(Given, Term, Outline1-Outline2, Ring1, Ring2, _),
        tables(Given, Ring1, Ring2, Other1-Other2),
        same_size(Table1, Other1),
        same_size(Table2, Other2),
        steps_round(Other1, Other2, Steps),
        \+ ( member(step(both, I, J), Steps),
             step_at(Table1, I, Step1),
             step_at(Table2, J, Step2),
             \+ similar(Step1, Step2, _)
           )
    ->  true
    ;   steps_round(Table1, Table2, Steps)
    ).

same_size(Table1, Table2) :-
    functor(Table1, _, N),
    functor(Table2, _, N).

%   below_each_other(Ring1, Ring2, Frames, Term): each is on one side of the
%   plane of the other.

below_each_other(Ring1, Ring2, frame(O1, X1, Y1)-frame(O2, X2, Y2), Term) :-
    cross_product(X1, Y1, Up1),
    cross_product(X2, Y2, Up2),
    (   member(node(P, _), Ring1),
        height_over(O2, Up2, P, Height),
        Height >= 0.0
    ->  primitive_error(planes_cross, Term)
    ;   member(node(P, _), Ring2),
        height_over(O1, Up1, P, Height),
        Height =< 0.0
    ->  primitive_error(planes_cross, Term)
    ;   true
    ).

height_over(O, Up, P, Height) :-
    difference(P, O, From),
    dot_product(Up, From, Height).


                /*******************************
                *           WALKING            *
                *******************************/

%   steps_round(Table1, Table2, Steps): a step is step(Kind, I, J): from the
%   generator between the corners I of the base and J of the top to the next:
%   Kind is `base` (to I+1), `top` (to J+1) or `both`.

steps_round(Table1, Table2, Steps) :-
    functor(Table1, _, N),
    functor(Table2, _, M),
    first_corner(Table1, Table2, M, J),
    walked(N, M, at(1, J), Table1, Table2, Steps).

%   first_corner(Table1, Table2, M, J): the first corner of the top that no
%   other is above the plane of, through the first edge of the base.

first_corner(Table1, Table2, M, J) :-
    corner(Table1, 1, P),
    corner(Table1, 2, Q),
    numlist(2, M, Ks),
    foldl(farther_out(P, Q, Table2), Ks, 1, J0),
    first_of_equal(M, P, Q, Table2, J0, J).

farther_out(P, Q, Table2, K, J0, J) :-
    corner(Table2, J0, B),
    corner(Table2, K, X),
    (   beyond(P, Q, B, X, 1)
    ->  J = K
    ;   J = J0
    ).

first_of_equal(Most, P, Q, Table2, J0, J) :-
    corner(Table2, J0, B),
    functor(Table2, _, M),
    J1 is (J0-2) mod M + 1,
    corner(Table2, J1, X),
    (   Most > 0,
        beyond(P, Q, B, X, 0)
    ->  Less is Most-1,
        first_of_equal(Less, P, Q, Table2, J1, J)
    ;   J = J0
    ).

corner(Table, I, P) :-
    functor(Table, _, N),
    K is (I-1) mod N + 1,
    arg(K, Table, node(P, _)).

%   beyond(P, Q, R, X, Side): X is above (1), in (0) or below (-1) the plane
%   through P, Q and R, seen counter-clockwise.

beyond(P, Q, R, X, Side) :-
    difference(Q, P, U),
    difference(R, P, V),
    difference(X, P, W),
    cross_product(U, V, Normal),
    dot_product(Normal, W, Volume),
    dot_product(U, U, UU),
    dot_product(V, V, VV),
    dot_product(W, W, WW),
    least_volume(Of),
    Least is Of*sqrt(UU*VV*WW),
    (   Volume > Least
    ->  Side = 1
    ;   Volume < -Least
    ->  Side = -1
    ;   Side = 0
    ).

%   least_volume(Of): a volume that is less than Of times its three sides is
%   rounding: coordinates may be a hundred thousand times as large as sides.

least_volume(1.0e-11).

%   walked(N, M, at(I, J), Table1, Table2, Steps): N and M steps are left to go
%   round the base and the top.

walked(0, 0, _, _, _, []) :-
    !.
walked(N0, M0, at(I, J), Table1, Table2, [step(Kind, I, J)|Steps]) :-
    next_step(N0, M0, I, J, Table1, Table2, Kind),
    (   Kind == top
    ->  N = N0,
        I1 = I
    ;   N is N0-1,
        I1 is I+1
    ),
    (   Kind == base
    ->  M = M0,
        J1 = J
    ;   M is M0-1,
        J1 is J+1
    ),
    walked(N, M, at(I1, J1), Table1, Table2, Steps).

next_step(_, 0, _, _, _, _, base) :-
    !.
next_step(0, _, _, _, _, _, top) :-
    !.
next_step(_, _, I, J, Table1, Table2, Kind) :-
    I1 is I+1,
    J1 is J+1,
    corner(Table1, I, P),
    corner(Table1, I1, Q),
    corner(Table2, J, R),
    corner(Table2, J1, X),
    beyond(P, Q, R, X, Side),
    step_kind(Side, I, J, Table1, Table2, Kind).

step_kind(1, _, _, _, _, top).
step_kind(-1, _, _, _, _, base).
step_kind(0, I, J, Table1, Table2, Kind) :-
    step_at(Table1, I, Step1),
    step_at(Table2, J, Step2),
    (   similar(Step1, Step2, _)
    ->  Kind = both
    ;   Kind = base
    ).

step_at(Table, I, Step) :-
    functor(Table, _, N),
    K is (I-1) mod N + 1,
    arg(K, Table, node(_, Step)).

%   similar(Step1, Step2, K): what lies between them is flat, or a cone; the
%   second is K times as large.

similar(line, line, _).
similar(arc(arc(_, U1, V1), T1, T2), arc(arc(_, U2, V2), T3, T4), K) :-
    same_angle(T1, T3),
    same_angle(T2, T4),
    dot_product(U1, U1, Square1),
    dot_product(U1, U2, Square2),
    K is Square2/Square1,
    times(K, U1, U2),
    times(K, V1, V2).

times(K, U1, U2) :-
    scaled(K, U1, U),
    difference(U, U2, Off),
    dot_product(Off, Off, Square),
    dot_product(U2, U2, Size),
    Square =< 1.0e-24*Size.


                /*******************************
                *            PIECES            *
                *******************************/

%   pieces(Steps, Table1, Table2, Pieces): a piece is Kind-Steps, Kind `flat` or
%   what all steps of a cone have in common. What goes on at the end is where it
%   began.

pieces(Steps, Table1, Table2, Pieces) :-
    foldl(step_in_piece(Table1, Table2), Steps, [], Back),
    foldl(piece_forward, Back, [], Pieces0),
    (   Pieces0 = [Kind-First|Rest0],
        append(Rest, [Kind-Last], Rest0),
        Kind \== flat
    ->  append(Last, First, Steps1),
        Pieces = [Kind-Steps1|Rest]
    ;   Pieces = Pieces0
    ).

piece_forward(Kind-Back, Pieces, [Kind-Steps|Pieces]) :-
    reverse(Back, Steps).

step_in_piece(Table1, Table2, Step, Pieces0, Pieces) :-
    piece_kind(Step, Table1, Table2, Kind),
    (   Kind \== flat,
        Pieces0 = [Kind-Back|Pieces1]
    ->  Pieces = [Kind-[Step|Back]|Pieces1]
    ;   Pieces = [Kind-[Step]|Pieces0]
    ).

piece_kind(step(top, I, J), Table1, Table2, Kind) :-
    !,
    corner(Table1, I, Apex),
    step_at(Table2, J, Way),
    way_kind(Way, top(Apex), Kind).
piece_kind(step(base, I, J), Table1, Table2, Kind) :-
    !,
    corner(Table2, J, Apex),
    step_at(Table1, I, Way),
    way_kind(Way, base(Apex), Kind).
piece_kind(step(both, I, J), Table1, Table2, Kind) :-
    step_at(Table1, I, Way),
    step_at(Table2, J, Way2),
    (   Way2 = arc(Other, _, _)
    ->  way_kind(Way, both(Other), Kind)
    ;   Kind = flat
    ).

way_kind(line, _, flat).
way_kind(arc(Arc, _, _), To, cone(Arc, To)).

%   named_pieces(Pieces, I, K, Named): piece(Part, Kind, Steps).

named_pieces([], _, _, []).
named_pieces([Kind-Steps|Pieces], I, K, [piece(Part, Kind, Steps)|Named]) :-
    (   Kind == flat
    ->  Part = side(I),
        I1 is I+1,
        K1 = K
    ;   Part = cone(K),
        I1 = I,
        K1 is K+1
    ),
    named_pieces(Pieces, I1, K1, Named).

%   piece_faces(Tables, Piece, Faces)

piece_faces(Tables, piece(Part, Kind, Steps), Faces) :-
    maplist(step_face(Tables, Part, Kind), Steps, Faces).

step_face(Tables, Part, Kind, Step, face(What, [Loop])) :-
    step_loop(Step, Tables, Loop),
    (   Kind == flat
    ->  What = Part
    ;   step_turn(Step, Tables, T1, T2),
        What = curved(Part, [T1-T2])
    ).

step_loop(step(Kind, I0, J0), Table1-Table2, Loop) :-
    functor(Table1, _, N),
    functor(Table2, _, M),
    I is (I0-1) mod N + 1,
    I1 is I0 mod N + 1,
    J is N + (J0-1) mod M + 1,
    J1 is N + J0 mod M + 1,
    kind_loop(Kind, I, I1, J, J1, Loop).

kind_loop(base, I, I1, J, _, [I,I1,J]).
kind_loop(top, I, _, J, J1, [I,J1,J]).
kind_loop(both, I, I1, J, J1, [I,I1,J1,J]).

%   step_turn(Step, Tables, T1, T2): the arc that it goes along.

step_turn(step(Kind, I, J), Table1-Table2, T1, T2) :-
    (   Kind == top
    ->  step_at(Table2, J, arc(_, T1, T2))
    ;   step_at(Table1, I, arc(_, T1, T2))
    ).


                /*******************************
                *           SURFACES           *
                *******************************/

%   piece_surface(Tables, Piece, Part-Surface)

piece_surface(Tables, piece(Part, Kind, Steps), Part-Surface) :-
    (   Kind = cone(Arc, To)
    ->  cone_surface(To, Arc, Surface)
    ;   Steps = [Step],
        fan_surface(Step, Tables, Surface)
    ).

cone_surface(base(Apex), Arc, Surface) :-
    tapered(Arc, Apex, 0.0, Surface).
cone_surface(top(Apex), Arc, Surface) :-
    tapered(Arc, Apex, 0.0, Surface).
cone_surface(both(arc(C2, U2, _)), Arc, Surface) :-
    Arc = arc(_, U, _),
    dot_product(U, U, Square),
    dot_product(U, U2, Square2),
    K is Square2/Square,
    tapered(Arc, C2, K, Surface).

tapered(arc(C0, U0, V0), To, K, Surface) :-
    difference(To, C0, W0),
    as_point(C0, C),
    maplist(as_vector, [U0,V0,W0], [U,V,W]),
    (   same_part(K, 1.0)
    ->  Surface = cylinder(C, U, V, W)
    ;   Surface = cone(C, U, V, W, K)
    ).

%   A fan is 90 degrees wide.

fan_surface(step(Kind, I, J), Table1-Table2, fan(C, U, V, K)) :-
    I1 is I+1,
    J1 is J+1,
    maplist(corner(Table1), [I,I1], [P1,Q1]),
    maplist(corner(Table2), [J,J1], [P2,Q2]),
    (   Kind == top
    ->  P-Q-To = P2-Q2-P1
    ;   P-Q-To = P1-Q1-P2
    ),
    difference(Q, P, Edge),
    F is 2.0/pi,
    scaled(F, Edge, U0),
    difference(To, P, V0),
    (   Kind == both
    ->  difference(Q2, P2, Edge2),
        dot_product(Edge, Edge, Square),
        dot_product(Edge, Edge2, Square2),
        K is Square2/Square
    ;   K = 0.0
    ),
    as_point(P, C),
    maplist(as_vector, [U0,V0], [U,V]).

as_point(p(X,Y,Z), point(X,Y,Z)).

as_vector(p(X,Y,Z), vector(X,Y,Z)).


                /*******************************
                *          DIRECTIONS          *
                *******************************/

%   piece_place(Tables, Seen1, Seen2, Piece, Place): Place as in Surfaces.

piece_place(Tables, Seen1, Seen2, piece(Part, Kind, Steps),
            piece(Part, End, T1-T2, G1-G2)) :-
    Steps = [First|_],
    last(Steps, Last),
    First = step(Which, I1, J1),
    (   Which == top
    ->  End = top
    ;   End = base
    ),
    (   Kind == flat
    ->  T1 = 0.0,
        T2 = 90.0
    ;   step_turn(First, Tables, T1, _),
        foldl(turn_more(Tables), Steps, T1, T2)
    ),
    after(Last, I2, J2),
    direction(Tables, Seen1, Seen2, I1, J1, G1),
    direction(Tables, Seen1, Seen2, I2, J2, G0),
    tolerance(rounding, Near),
    G2 is G0 + 360.0*ceiling((G1 + Near - G0)/360.0).

turn_more(Tables, Step, T0, T) :-
    step_turn(Step, Tables, T1, T2),
    T is T0 + T2-T1.

after(step(Kind, I, J), I1, J1) :-
    (   Kind == top
    ->  I1 = I
    ;   I1 is I+1
    ),
    (   Kind == base
    ->  J1 = J
    ;   J1 is J+1
    ).

%   direction(Tables, Seen1, Seen2, I, J, G): 0.0 =< G < 360.0.

direction(Table1-Table2, seen(O1, X1, Y1, Turn1), seen(O2, X2, Y2, Turn2), I,
          J, G) :-
    corner(Table1, I, P),
    corner(Table2, J, Q),
    seen_at(O1, X1, Y1, Turn1, P, A),
    seen_at(O2, X2, Y2, Turn2, Q, B0),
    B is B0 + 360.0*round((A-B0)/360.0),
    G0 is (A+B)/2.0,
    whole_turns(G0, By),
    G is G0 - By.

seen_at(O, X, Y, Turn, P, A) :-
    difference(P, O, From),
    dot_product(X, From, U),
    dot_product(Y, From, V),
    A is atan2(V, U)*180.0/pi + Turn.

%   seen_from(Frame, Outline, Turn, Seen): Seen is seen(O, X, Y, Turn): O is in
%   the middle of the outline.

seen_from(frame(O0, X, Y), Outline, Turn, seen(O, X, Y, Turn)) :-
    outline_middle(Outline, U-V),
    scaled(U, X, A),
    scaled(V, Y, B),
    vector_sum(A, B, By),
    vector_sum(O0, By, O).
