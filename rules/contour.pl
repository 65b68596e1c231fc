:- module(sg_contour,
          [ find_contours/2,            % +Segments, +Crease
            smoothness/2,               % +Crease, -Smooth
            faceted_segments/1,         % -Faceted
            smooth_segment/1,           % +S
            contour_pieces/3,           % +S, +Crease, -Pieces
            contour_ends/4,             % +S, +K, -Start, -End
            line_ends/4                 % +S, +E, -Start, -End
          ]).
:- use_module(contour_beside,
              [ beside_piece/3, side_place/5, triangle_facing/3 ]).
:- use_module(decision, [decision/2, decision_is_default/1]).
:- use_module(kernel, [fill_contour/7]).
:- use_module(known_surface, [known_surfaces/1]).
:- use_module(smooth_sheet,
              [ smooth_sheets/3, smooth_side/3, across_side/3,
                coarse_triangle/2, curved_triangle/2, fold_side/2, corner_fan/3,
                fan_corners/3, fan_normal/3, corner_vertex/3, corner_place/3,
                next_corner/2
              ]).
:- use_module(smooth_vector, [cross_product/3, difference/3, dot_product/3]).
:- use_module(stage, [stage/2]).
:- use_module(store, [contour/9, e/5, screen/5, segment/3, t/6]).
:- use_module(view, [current_view/4, view_matrix/3]).
:- autoload(library(apply), [foldl/4, maplist/3]).
:- autoload(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- autoload(library(lists), [max_list/2, member/2, min_list/2]).
/** <module> Outlines of smooth surfaces, inside their triangles.

The side of a vertex that a surface turns to the eye is told by g = normal .
direction to the eye, with the normal of the vertex's fan (smooth_sheet.pl).
Along the sides of a curved sheet's triangles g runs linearly, and the outline
goes through its zeros: across a triangle whose corners differ runs one piece.
Zero counts as turned to the eye, so that pieces hang together whatever lies
where.

Where a piece reaches the end of its sheet (a crease, a border, a penetration
line) it goes to that end of the side there at which the triangles themselves
turn from the eye: there the crease is outermost in the picture, and the two
meet. At an apex, which has no normal, a piece ends in it.

Of the surface beside an outline one half is nearer the eye. If g is positive
there, the surface bends away from the line of sight; if not, it comes between
the outline and the eye, and hides it, if it is the surface of a solid. Between
them lies a cusp; there a piece is divided, and those that are seen nearly end
on, which show the mesh and not the surface, are left out. Which triangles lie
beside a piece and therefore never hide it is said in contour_beside.pl.

The outline of a coarse sheet runs along the sides of its triangles, between one
that is turned to the eye and one that is not: that of the smooth surface would
lie visibly inside what is seen of it, and triangles would hide it. So does that
of a polygon that is not flat, where its triangles fold.

Sheets that are not curved, cylinders and cones for example, are folded along
straight lines: their outlines are edges, as role.pl finds them. The fused
kernel of all this is c_kernels/contour.c.

@see Hertzmann & Zorin 2000, Illustrating smooth surfaces, section 3.
*/

:- set_prolog_flag(optimise, true).

%!  find_contours(+Segments, +Crease) is det.
%
%   Fill contour/9 of the current world for the view that screen/5 holds, from
%   Segments, `all` or a list. Faces that bend by no more than Crease degrees
%   hang together smoothly.

find_contours(Segments, Crease) :-
    current_view(Theta, Phi, Rho, Kind),
    smoothness(Crease, Smooth),
    stage(join,
          (   fill_contour(Segments, Theta, Phi, Rho, Kind, Smooth, kept)
          ->  true
          ;   known_surfaces(Known),
              fill_contour(Segments, Theta, Phi, Rho, Kind, Smooth, Known)
          )).

%!  smoothness(+Crease, -Smooth) is det.
%
%   Smooth is smooth(Crease, Faceted), Faceted by faceted_segments/1.

smoothness(Crease, smooth(Crease,Faceted)) :-
    faceted_segments(Faceted).

%!  faceted_segments(-Faceted:list) is det.
%
%   Faceted are the segments for which smooth_segment/1 is not true.

faceted_segments(Faceted) :-
    (   decision_is_default(smooth_segment/1)
    ->  Faceted = []
    ;   findall(S, ( segment(S, _, _), \+ smooth_segment(S) ), Faceted)
    ).

:- decision(smooth_segment/1,
            "Which segments have outlines inside their triangles").

%!  smooth_segment(+S) is semidet.
%
%   True when the curved sheets of segment S stand for smooth surfaces, so that
%   their outlines run through their triangles, and facets of primitives for the
%   surfaces of these (known_surface.pl). They always do. A decision: a world
%   can say that a segment is what its facets are.

smooth_segment(_).

%!  contour_pieces(+S, +Crease, -Pieces) is det.
%
%   Pieces, sorted, are piece(T, I1, F1, I2, F2, To, Ts) for the pieces of
%   contour/9 that segment S has in the picture of screen/5: the rule that
%   find_contours/2 follows. Slow.

contour_pieces(S, Crease, Pieces) :-
    smooth_sheets(S, Crease, Sheets),
    current_eye(Eye),
    Context = context(S, Sheets, Eye, Gs, Radials, Senses),
    findall(T, curved_triangle(Sheets, T), Ts),
    fan_values(towards_eye(Sheets, Eye), Sheets, Ts, Gs),
    fan_values(grows(Sheets, Eye, Gs), Sheets, Ts, Radials),
    findall(T-(Piece/Sense),
            ( member(T, Ts), \+ coarse_triangle(Sheets, T),
              piece_across(Context, T, Piece, Sense, _) ),
            Found),
    findall(T-Sense, member(T-(_/Sense), Found), Senses0),
    list_to_assoc(Senses0, Senses),
    findall(Piece,
            ( member(T, Ts), \+ coarse_triangle(Sheets, T),
              piece_across(Context, T, Piece, _, Radial),
              \+ is_unsure(Context, T, Radial),
              \+ is_point(S, Piece), besides(Context, Piece)
            ; piece_along(Context, Piece),
              \+ is_point(S, Piece)
            ),
            Pieces0),
    sort(Pieces0, Pieces).

%   piece_along(Context, Piece): a side of a coarse sheet, or a fold of a
%   polygon that is not flat, between a triangle that is turned to the eye and
%   one that is not.

piece_along(context(S,Sheets,_,_,_,_), piece(T,I,0.0,I,1.0,1.0,Ts)) :-
    t(S, _, T, _, _, _),
    (   coarse_triangle(Sheets, T)
    ->  Coarse = true
    ;   curved_triangle(Sheets, T)
    ->  fail
    ;   Coarse = false
    ),
    member(I, [1,2,3]),
    across_side(Sheets, T-I, T2-I2),
    T-I @< T2-I2,
    (   Coarse == true
    ->  smooth_side(Sheets, T-I, _)
    ;   fold_side(Sheets, T-I)
    ),
    triangle_facing(S, T, Facing),
    triangle_facing(S, T2, Facing2),
    once(( Facing > 0, Facing2 =< 0 ; Facing =< 0, Facing2 > 0 )),
    sort([T,T2], Ts).

%   What its own surface hides has nothing beside it.

besides(Context, Piece) :-
    Piece = piece(_,_,_,_,_,To,Ts),
    (   To > 0.0
    ->  beside_piece(Context, Piece, Ts)
    ;   Ts = []
    ).

is_point(S, piece(T,I1,F1,I2,F2,_,_)) :-
    t(S, _, T, A, B, C),
    side_place(S, t(A,B,C,A), I1, F1, Place1),
    side_place(S, t(A,B,C,A), I2, F2, Place2),
    Place1 == Place2.

%   Values: Fan -> the value that Goal gives for each fan of triangles Ts.

:- meta_predicate fan_values(2, +, +, -).

fan_values(Goal, Sheets, Ts, Values) :-
    findall(Fan, ( member(T, Ts), member(I, [1,2,3]),
                   corner_fan(Sheets, T-I, Fan) ),
            Fans0),
    sort(Fans0, Fans),
    findall(Fan-Value, ( member(Fan, Fans), call(Goal, Fan, Value) ), Pairs),
    list_to_assoc(Pairs, Values).

/* - - - the eye - - - */

%   eye(Kind, Away, Rho, Right, Up), vectors p(X,Y,Z) of the model.

current_eye(eye(Kind,Away,Rho,Right,Up)) :-
    current_view(Theta, Phi, Rho, Kind),
    view_matrix(Theta, Phi, Rows),
    maplist(float_row, Rows, [Right,Up,Away]).

float_row(r(A0,B0,C0), p(A,B,C)) :-
    A is float(A0),
    B is float(B0),
    C is float(C0).

%   to_eye(Eye, Point, Direction): unit.

to_eye(eye(Kind,p(A,B,C),Rho,_,_), p(X,Y,Z), p(U,V,W)) :-
    (   Kind == central
    ->  U0 is -Rho*A - X,
        V0 is -Rho*B - Y,
        W0 is -Rho*C - Z
    ;   U0 is -A,
        V0 is -B,
        W0 is -C
    ),
    Size is sqrt(U0*U0 + V0*V0 + W0*W0),
    U is U0/Size,
    V is V0/Size,
    W is W0/Size.

%   How far a point is from the eye, along its line of sight.

distance(eye(Kind,Away,Rho,_,_), Point, Distance) :-
    (   Kind == central
    ->  dot_product(Point, Away, Depth),
        Distance is Depth+Rho
    ;   Distance = 1.0
    ).


/* - - - g, and how it grows on the way to the eye - - - */

%   towards_eye(Sheets, Eye, Fan, G); an apex has none. Nearly zero is zero.

towards_eye(Sheets, Eye, Fan, G) :-
    fan_normal(Sheets, Fan, Normal),
    corner_place(Sheets, Fan, Place),
    to_eye(Eye, Place, Direction),
    dot_product(Normal, Direction, G0),
    (   abs(G0) < 1.0e-12
    ->  G = 0.0
    ;   G = G0
    ).

%   The mean over the triangles of Fan. In each of them g is linear.

grows(Sheets, Eye, Gs, Fan, Radial) :-
    fan_normal(Sheets, Fan, _),
    fan_corners(Sheets, Fan, Corners),
    findall(Growth-Area,
            ( member(T-_, Corners), growth(Sheets, Eye, Gs, T, Growth, Area) ),
            Pairs),
    foldl(added, Pairs, 0.0-0.0, Growth-Area),
    (   Area > 0.0
    ->  Radial is Growth/Area
    ;   Radial = 0.0
    ).

added(G1-A1, G0-A0, G-A) :-
    G is G0+G1,
    A is A0+A1.

%   Growth of g in triangle T on the way to the eye, times Area, which is twice
%   that of T. Fails if a corner is an apex.

growth(Sheets, Eye, Gs, T, Growth, Area) :-
    maplist(corner_g(Sheets, Gs), [T-1,T-2,T-3], [G1,G2,G3]),
    maplist(corner_place(Sheets), [T-1,T-2,T-3], [P1,P2,P3]),
    difference(P3, P2, E1),
    difference(P1, P3, E2),
    difference(P2, P1, E3),
    cross_product(E1, E2, Normal),
    dot_product(Normal, Normal, Square),
    Area is sqrt(Square),
    to_eye(Eye, P1, Direction),
    maplist(height_gained(Normal, Direction), [E1,E2,E3], [H1,H2,H3]),
    (   Area > 0.0
    ->  Growth is (G1*H1 + G2*H2 + G3*H3)/Area
    ;   Growth = 0.0
    ).

%   How fast one goes towards the corner across Side, on the way to the eye.
height_gained(Normal, Direction, Side, Height) :-
    cross_product(Normal, Side, Across),
    dot_product(Across, Direction, Height).

corner_g(Sheets, Gs, Corner, G) :-
    corner_fan(Sheets, Corner, Fan),
    get_assoc(Fan, Gs, G).

/* - - - pieces - - - */

%   piece_across(Context, T, Piece, Sense, Radial): Sense is 1 if the nearer
%   half beside it is turned to the eye, -1 if not, 0 if both. Radial is that of
%   its middle.

piece_across(Context, T, piece(T,I1,F1,I2,F2,To,_), Sense, Radial) :-
    findall(End, piece_end(Context, T, End), Ends),
    (   Ends = [end(J1,H1,R1), end(J2,H2,R2)]
    ->  true
    ;   Ends = [end(J1,H1,R1)],
        R2 = R1,
        apex_end(Context, T, J2, H2)
    ),
    (   R1 >= R2
    ->  I1-F1-I2-F2 = J1-H1-J2-H2,
        Most-Least = R1-R2
    ;   I1-F1-I2-F2 = J2-H2-J1-H1,
        Most-Least = R2-R1
    ),
    Radial is (Most+Least)/2.0,
    Context = context(S, _, _, _, _, _),
    (   Least >= 0.0
    ->  Sense = 1
    ;   Most < 0.0
    ->  Sense = -1
    ;   Sense = 0
    ),
    (   ( Sense =:= 1 ; \+ is_solid(S) )
    ->  To = 1.0
    ;   Sense =:= -1
    ->  To = 0.0
    ;   To is Most/(Most-Least)
    ).

%   is_unsure(Context, T, Radial): the piece across T runs so nearly along the
%   line of sight that its place in the picture is no more than what T is off
%   the smooth surface: its direction is off the line of sight by less than 0.6
%   of what the normals of T turn, and half of that is how well it is known, for
%   G is linear in T. Only a saddle has such pieces.

is_unsure(context(_,Sheets,_,Gs,_,_), T, Radial) :-
    Corners = [T-1,T-2,T-3],
    maplist(corner_fan(Sheets), Corners, Fans),
    maplist(fan_normal(Sheets), Fans, Normals),
    maplist(corner_place(Sheets), Corners, Places),
    maplist(triangle_normal, [Places,Normals], [Normal,Turned]),
    dot_product(Normal, Turned, Way),
    Way < 0.0,
    maplist(corner_g(Sheets, Gs), Corners, Values),
    max_list(Values, High),
    min_list(Values, Low),
    slope(Places, Values, Normal, Slope),
    abs(Radial) < 0.6*(High-Low)*Slope.

triangle_normal([P1,P2,P3], Normal) :-
    difference(P2, P1, U),
    difference(P3, P1, W),
    cross_product(U, W, Normal).

%   How steeply a function grows that is linear in a triangle, from its Values
%   at the corners: the gradient is across the normal and (V2-V1)*(P3-P1) -
%   (V3-V1)*(P2-P1).

slope([P1,P2,P3], [V1,V2,V3], Normal, Slope) :-
    difference(P2, P1, p(X2,Y2,Z2)),
    difference(P3, P1, p(X3,Y3,Z3)),
    G2 is V2-V1,
    G3 is V3-V1,
    X is G2*X3 - G3*X2,
    Y is G2*Y3 - G3*Y2,
    Z is G2*Z3 - G3*Z2,
    dot_product(Normal, Normal, Square),
    Slope is sqrt((X*X + Y*Y + Z*Z)/Square).

%   end(I,F,Radial): on a side whose corners differ.

piece_end(Context, T, end(I,F,Radial)) :-
    Context = context(_, Sheets, _, Gs, Radials, _),
    member(I0, [1,2,3]),
    next_corner(T-I0, T-J0),
    corner_g(Sheets, Gs, T-I0, G),
    corner_g(Sheets, Gs, T-J0, H),
    sign_of(G, Sign),
    sign_of(H, Other),
    Sign =\= Other,
    maplist(corner_g(Sheets, Radials), [T-I0,T-J0], [R1,R2]),
    Zero is G/(G-H),
    Radial is (1.0-Zero)*R1 + Zero*R2,
    (   smooth_side(Sheets, T-I0, _)
    ->  I = I0,
        side_zero(Context, T-I0, T-J0, F)
    ;   outermost(Context, T, I0-Sign, J0-Other, I),
        corner_on_side(Sheets, T-I, F)
    ).

sign_of(G, Sign) :-
    (   G >= 0.0
    ->  Sign = 1
    ;   Sign = -1
    ).

%   The corner that is turned the other way than its triangle.

outermost(context(S,_,_,_,_,_), T, I1-Sign1, I2-_, I) :-
    triangle_facing(S, T, Facing),
    (   Facing < 0
    ->  Wanted = 1
    ;   Wanted = -1
    ),
    (   Sign1 =:= Wanted
    ->  I = I1
    ;   I = I2
    ).

apex_end(context(_,Sheets,_,_,_,_), T, I, F) :-
    last_apex(Sheets, T, I),
    corner_on_side(Sheets, T-I, F).

last_apex(Sheets, T, I) :-
    member(I, [3,2,1]),
    corner_fan(Sheets, T-I, Fan),
    \+ fan_normal(Sheets, Fan, _),
    !.

%   Side I begins at corner I: F is 0 there if its vertex is the smaller one.

corner_on_side(Sheets, Corner, F) :-
    next_corner(Corner, Next),
    corner_vertex(Sheets, Corner, V),
    corner_vertex(Sheets, Next, W),
    (   V < W
    ->  F = 0.0
    ;   F = 1.0
    ).

%   A zero of the model, counted from the side's start, in the picture, counted
%   from its smaller vertex.

side_zero(context(_,Sheets,Eye,Gs,_,_), C1, C2, F) :-
    corner_vertex(Sheets, C1, V1),
    corner_vertex(Sheets, C2, V2),
    (   V1 < V2
    ->  Low = C1,
        High = C2
    ;   Low = C2,
        High = C1
    ),
    corner_g(Sheets, Gs, Low, G),
    corner_g(Sheets, Gs, High, H),
    Zero is G/(G-H),
    maplist(corner_place(Sheets), [Low,High], [P,Q]),
    distance(Eye, P, NearP),
    distance(Eye, Q, NearQ),
    F is Zero*NearQ/((1.0-Zero)*NearP + Zero*NearQ).

%   A solid with a border, or inside out, is none.

is_solid(S) :-
    segment(S, solid, _).

/* - - - where lines are in the picture - - - */

%!  line_ends(+S, +E, -Start, -End) is nondet.
%
%   Start and End, X-Y, are where line E of drawn/7 begins and ends in the
%   picture, whatever part of it is drawn: edge E of segment S, or, if E is
%   negative, a piece of contour/9.

line_ends(S, E, Start, End) :-
    (   E > 0
    ->  e(S, E, V1, V2, _),
        vertex_place(S, V1, Start),
        vertex_place(S, V2, End)
    ;   K is -E,
        contour_ends(S, K, Start, End)
    ).

vertex_place(S, V, X-Y) :-
    screen(S, V, X, Y, _).

%!  contour_ends(+S, +K, -Start, -End) is semidet.
%
%   Start and End, X-Y, are where piece K of contour/9 begins and ends in the
%   picture.

contour_ends(S, K, Start, End) :-
    contour(S, K, T, I1, F1, I2, F2, _, _),
    t(S, _, T, A, B, C),
    side_place(S, t(A,B,C,A), I1, F1, Start),
    side_place(S, t(A,B,C,A), I2, F2, End).
