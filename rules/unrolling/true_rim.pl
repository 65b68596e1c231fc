:- module(sg_true_rim,
          [ rims_rounded/3,             % +D, +S, +Options
            pattern_measured/1          % +D
          ]).
:- use_module('../near', [same_part/2, is_rounding/2, is_on_surface/2]).
:- use_module('../csg/placed_surface', [facet_surface/3, placed_polygon/4]).
:- use_module('../primitive/primitive_face', [surface_point/4]).
:- use_module('../kernel',
              [ roll_curves/5, surface_place/4, surface_value/4,
                surfaces_meet/4
              ]).
:- use_module('../development/development_record', [record_drawn/4]).
:- use_module('../development/seam_measure', [pattern_area/2, seam_drawn/3]).
:- use_module('../store',
              [ e/5, edge_polygon/3, from_p/5, joint/6, p/3, plane/6, v/5,
                assert_fact/1, facts_transaction/1, fresh_id/3,
                retractall_facts/1
              ]).
:- use_module('../polygon/triangulation', [pattern_completed/1]).
:- use_module(true_surface, [meeting_surfaces/4]).
:- use_module('../vector', [cross_product/3, dot_product/3]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3]).
:- use_module(library(assoc),
              [empty_assoc/1, get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [append/2, append/3, member/2, reverse/2]).
:- use_module(library(option), [option/3]).
/** <module> Flat ends of what is rolled, and holes in what is flat.

Facets end in chords. In a pattern of the flat faces that close a cylinder or a
cone, the edges that were rims become arcs, so that they fit what is unrolled;
and a hole that a pipe leaves in a flat face has the true curve. Where such a
hole goes over a fold, facets of the pipe meet the fold in a corner that is on
no true curve: the corner goes along the fold to where the pipe meets it.
*/

%!  rims_rounded(+D, +S, +Options) is det.
%
%   In pattern D of segment S, a border edge of a flat polygon that was an edge
%   of a facet, on its rim, becomes a polyline along that of the true surface;
%   so does one where the polygon was cut by a curved surface of another
%   segment, whose ends are moved along folds to that. The edges it is divided
%   into have origin(D, e(New), e(E)). One transaction. Option:
%   chord(Tolerance), 1.0e-4 of the size of the surface by default.

rims_rounded(D, S, Options) :-
    facts_transaction(sg_true_rim:rounded(D, S, Options)).

rounded(D, S, Options) :-
    meeting_tables(D, S, Meets),
    corners_moved(D, S, Meets, Corners),
    findall(P-Arcs,
            ( p(D, P, Es),
              findall(Fold, ( member(Fold, Es), flat_neighbour(S, Fold, _) ),
                      Folds),
              findall(arc(E, Points),
                      ( member(E, Es),
                        border_edge(D, E),
                        true_arc(D, S, P, E, Meets, Corners, Options, Points),
                        \+ ( member(Fold, Folds),
                             goes_over(D, E, Points, Fold)
                           ) ),
                      Arcs),
              Arcs \== [] ),
            Changes),
    forall(member(P-Arcs, Changes), polygon_rounded(D, P, Arcs)),
    (   Changes == [],
        empty_assoc(Corners)
    ->  true
    ;   pattern_completed(D),
        pattern_measured(D)
    ).

%!  pattern_measured(+D) is det.
%
%   Remember how long the seams of pattern D are and how large it is now: after
%   it was laid it was changed.

pattern_measured(D) :-
    seam_drawn(D, Seam, Longest),
    pattern_area(D, Area),
    record_drawn(D, Seam, Longest, Area).

true_arc(D, S, P, E, Meets, Corners, Options, Points) :-
    (   rim_arc(D, S, P, E, Options, Points)
    ->  true
    ;   line_arc(D, S, P, E, Meets, Corners, Options, Points)
    ).

%   goes_over(D, E, Points, Fold): the arc of E, which has no end in common
%   with Fold, would go over that, as where facets just miss a fold and the true
%   surface does not. There facets are what can be drawn.

goes_over(D, E, Points, Fold) :-
    Fold \== E,
    e(D, Fold, V, W, _),
    e(D, E, A, B, _),
    \+ ( member(End, [V,W]), memberchk(End, [A,B]) ),
    maplist(pattern_place(D), [V,W,B], [Low,High,Last]),
    append(Points, [Last], Ends),
    pattern_place(D, A, First),
    foldl(crossing(Low, High), Ends, First-false, _-true).

pattern_place(D, V, X-Y) :-
    v(D, V, X, Y, _),
    !.

%   crossing(P, Q, B, A-Crosses0, B-Crosses): true if A-B crosses P-Q.

crossing(P, Q, B, A-Crosses0, B-Crosses) :-
    (   maplist(turn(P, Q), [A,B], [TA,TB]),
        maplist(turn(A, B), [P,Q], [TP,TQ]),
        TA*TB < 0.0,
        TP*TQ < 0.0
    ->  Crosses = true
    ;   Crosses = Crosses0
    ).

turn(X1-Y1, X2-Y2, X3-Y3, Turn) :-
    Turn is (X2-X1)*(Y3-Y1) - (Y2-Y1)*(X3-X1).

border_edge(D, E) :-
    \+ joint(D, _, E, _, _, _),
    \+ joint(D, _, _, E, _, _).

%   rim_arc(D, S, P, E, Options, Points): edge E of flat polygon P is a rim;
%   Points, X-Y, are those of the arc between its ends in D.

rim_arc(D, S, P, E, Options, Points) :-
    e(S, E, A, B, _),
    e(S, Twin, B, A, _),
    once(edge_polygon(S, Twin, Q)),
    unrolled_surface(S, Q, Surface),
    \+ unrolled_surface(S, P, _),
    rim_place(S, A, Surface, TA, H),
    rim_place(S, B, Surface, TB0, H),
    TB is TB0 + 360.0*round((TA-TB0)/360.0),
    arc_count(Surface, TA, TB, H, Options, N),
    N > 1,
    e(D, E, WA, WB, _),
    vertex_point(S, A, PA),
    vertex_point(S, B, PB),
    frame(S, P, PA, PB, D, WA, WB, Frame),
    Last is N-1,
    findall(Point,
            ( between(1, Last, I),
              T is TA + (TB-TA)*I/N,
              surface_point(Surface, T, H, Place),
              in_frame(Frame, Place, Point) ),
            Points).

%   meeting_tables(D, S, Meets): Leaf-Table of meeting_surfaces/4 for the leaves
%   that the polygons of D are of.

meeting_tables(D, S, Meets) :-
    findall(Leaf, ( p(D, P, _), polygon_leaf(S, P, Leaf) ), Leaves0),
    sort(Leaves0, Leaves),
    findall(Leaf-Table,
            ( member(Leaf, Leaves), meeting_surfaces(S, Leaf, all, Table) ),
            Meets).

polygon_leaf(S, P, Leaf) :-
    (   from_p(S, P, _, _, _)
    ->  once(placed_polygon(S, P, Leaf, _))
    ;   Leaf = S
    ).

%   line_arc(D, S, P, E, Meets, Corners, Options, Points): edge E of flat
%   polygon P is where a curved surface cut it. A corner that is not on the true
%   curve stays as it is, and so does its edge.

line_arc(D, S, P, E, Meets, Corners, Options, Points) :-
    \+ unrolled_surface(S, P, _),
    cutting_surface(S, P, E, Meets, Surface),
    e(S, E, A, B, _),
    true_point(S, Corners, A, PA),
    true_point(S, Corners, B, PB),
    maplist(on_curve(Surface), [PA,PB]),
    \+ ( member(V-Point, [A-PA,B-PB]),
         curve_leaves(S, P, E, V, Meets, Surface),
         \+ on_surface(Surface, Point)
       ),
    e(D, E, WA, WB, _),
    frame(S, P, PA, PB, D, WA, WB, Frame),
    curve_between(S, P, Surface, PA, PB, Frame, Options, Places),
    Places \== [],
    !,
    maplist(laid_in(Frame), Places, Points).

%   on_curve(Surface, Point): a Point that facets of Surface have on their
%   generators is on Surface too; one that they have between these, as where
%   the other part ends, is not, and no curve can begin there. Spheres and tori
%   have no generators; of them it is taken as it is.

on_curve(Surface, point(X,Y,Z)) :-
    (   functor(Surface, Kind, _),
        memberchk(Kind, [cylinder,cone,ruled,parallel])
    ->  surface_place(Surface, point(X,Y,Z), T, H),
        surface_point(Surface, T, H, point(X1,Y1,Z1)),
        Off is abs(X-X1) + abs(Y-Y1) + abs(Z-Z1),
        is_on_surface(Off, 1.0 + abs(X) + abs(Y) + abs(Z))
    ;   true
    ).

%   curve_leaves(S, P, E, V, Meets, Surface): beyond V, an end of E, the border
%   of P is another line: at a rim, say. A corner of that and of facets of a
%   sphere may lie so that the true curve, drawn to it, goes over the rim.

curve_leaves(S, P, E, V, Meets, Surface) :-
    once(p(S, P, Es)),
    member(Other, Es),
    Other \== E,
    e(S, Other, V1, V2, _),
    memberchk(V, [V1,V2]),
    \+ ( cutting_surface(S, P, Other, Meets, Surface1),
         Surface1 == Surface
       ),
    !.

on_surface(Surface, Point) :-
    surface_value(Surface, Point, Value, vector(A,B,C)),
    Point = point(X,Y,Z),
    is_on_surface(Value, sqrt(A*A + B*B + C*C)
                         *(1.0 + abs(X) + abs(Y) + abs(Z))).

%   cutting_surface(S, P, E, Meets, Surface): both ends of E, an edge of P, were
%   met by facets of Surface, which is not flat. Where the rim of what cut it
%   ends there, both of them lie in its flat end too: then E runs along it, if
%   its middle does.

cutting_surface(S, P, E, Meets, Surface) :-
    polygon_leaf(S, P, Leaf),
    memberchk(Leaf-Table, Meets),
    e(S, E, A, B, _),
    get_assoc(A, Table, met(Surfaces1, _)),
    get_assoc(B, Table, met(Surfaces2, _)),
    member(Surface, Surfaces1),
    Surface \= plane(_, _, _, _),
    memberchk(Surface, Surfaces2),
    \+ ( member(Flat, Surfaces1),
         Flat = plane(_, _, _, _),
         memberchk(Flat, Surfaces2),
         runs_in(S, P, A-B, Flat, Surface)
       ).

%   runs_in(S, P, A-B, Flat, Surface): polygon P does not lie in Flat, and the
%   middle between the vertices is no farther from it than from Surface.

runs_in(S, P, A-B, Flat, Surface) :-
    polygon_plane(S, P, plane(NX,NY,NZ,_)),
    Flat = plane(X,Y,Z,_),
    cross_product(p(NX,NY,NZ), p(X,Y,Z), Along),
    dot_product(Along, Along, Square),
    \+ is_rounding(Square, 1.0),
    maplist(vertex_point(S), [A,B], [PA,PB]),
    along_fold(PA, PA, PB, 0.5, Middle),
    off_surface(Flat, Middle, Near),
    \+ ( off_surface(Surface, Middle, Off),
         Off < Near
       ).

off_surface(Surface, Point, Off) :-
    surface_value(Surface, Point, Value, _),
    Off is abs(Value).

%   curve_between(S, P, Surface, PA, PB, Frame, Options, Places): unrolled in
%   the plane of P as a fan, from PA along PB.

curve_between(S, P, Surface, PA, PB, Frame, Options, Places) :-
    Frame = frame(PA, [UX,UY,UZ], [VX,VY,VZ], _, _),
    polygon_plane(S, P, Plane),
    Fan = fan(PA, vector(UX,UY,UZ), vector(VX,VY,VZ), 1.0),
    chord_wanted(Surface, Options, Chord),
    arc_reach(PA, PB, Reach),
    roll_curves(roll(Fan, 0.0, 0.0), Reach, Chord,
                [curve(0.0, [Plane,Surface], PA, PB)], [Places]).

polygon_plane(S, P, plane(NX,NY,NZ,N)) :-
    plane(S, P, NX, NY, NZ, N),
    !.

vertex_point(S, V, point(X,Y,Z)) :-
    v(S, V, X, Y, Z),
    !.

arc_reach(point(X1,Y1,Z1), point(X2,Y2,Z2), Reach) :-
    Reach is sqrt((X1-X2)**2 + (Y1-Y2)**2 + (Z1-Z2)**2).

laid_in(frame(_, _, _, X1-Y1, CX-CY), place(_, _, U, V), X-Y) :-
    X is X1 + U*CX - V*CY,
    Y is Y1 + U*CY + V*CX.

%   unrolled_surface(S, P, Surface): polygon P is a facet of a surface that is
%   straight one way.

unrolled_surface(S, P, Surface) :-
    facet_surface(S, P, Surface),
    functor(Surface, Kind, _),
    memberchk(Kind, [cylinder, cone, ruled, parallel]).

rim_place(S, V, Surface, T, H) :-
    v(S, V, X, Y, Z),
    surface_place(Surface, point(X,Y,Z), T, H0),
    member(H, [0.0,1.0]),
    same_part(H, H0),
    surface_point(Surface, T, H, point(X1,Y1,Z1)),
    Off is abs(X-X1) + abs(Y-Y1) + abs(Z-Z1),
    is_rounding(Off, 1.0 + abs(X) + abs(Y) + abs(Z)),
    !.

%   arc_count(Surface, T1, T2, H, Options, N): N equal chords are near enough.

arc_count(Surface, T1, T2, H, Options, N) :-
    chord_wanted(Surface, Options, Chord),
    Middle is (T1+T2)/2.0,
    surface_point(Surface, T1, H, point(X1,Y1,Z1)),
    surface_point(Surface, T2, H, point(X2,Y2,Z2)),
    surface_point(Surface, Middle, H, point(X,Y,Z)),
    Off is sqrt((X-(X1+X2)/2)**2 + (Y-(Y1+Y2)/2)**2 + (Z-(Z1+Z2)/2)**2),
    N is max(1, ceiling(sqrt(Off/Chord))).

%   chord_wanted(Surface, Options, Chord): the size of Surface does not depend
%   on which of its ends is the lower one, nor on which two conjugate diameters
%   of an end it is given by.

chord_wanted(Surface, Options, Chord) :-
    half_width(Surface, Half),
    Usual is 1.0e-4*2.0*Half,
    option(chord(Chord0), Options, Usual),
    Chord is max(Chord0, Usual*1.0e-3).

half_width(parallel(Surface, _), Half) =>
    half_width(Surface, Half).
half_width(cone(_, U, V, _, K), Half) =>
    ellipse_radius(U, V, Radius),
    Half is Radius*max(1.0, abs(K)).
half_width(ruled(_, U1, V1, _, U2, V2), Half) =>
    ellipse_radius(U1, V1, Radius1),
    ellipse_radius(U2, V2, Radius2),
    Half is max(Radius1, Radius2).
half_width(Surface, Half) =>
    arg(2, Surface, U),
    arg(3, Surface, V),
    ellipse_radius(U, V, Half).

%   The root of the mean square of its half axes.

ellipse_radius(vector(AX,AY,AZ), vector(BX,BY,BZ), Radius) :-
    Radius is sqrt((AX*AX + AY*AY + AZ*AZ + BX*BX + BY*BY + BZ*BZ)/2.0).

%   frame(S, P, PA, PB, D, WA, WB, Frame): P of S, at PA-PB, is laid at WA-WB of
%   D. Fails if corners that were moved are in one place.

frame(S, P, point(XA,YA,ZA), point(XB,YB,ZB), D, WA, WB,
      frame(point(XA,YA,ZA), Along, Left, X1-Y1, CX-CY)) :-
    DX is XB-XA,
    DY is YB-YA,
    DZ is ZB-ZA,
    Length is sqrt(DX*DX + DY*DY + DZ*DZ),
    Length > 0.0,
    AX is DX/Length,
    AY is DY/Length,
    AZ is DZ/Length,
    Along = [AX,AY,AZ],
    once(plane(S, P, NX, NY, NZ, _)),
    LX is NY*AZ - NZ*AY,
    LY is NZ*AX - NX*AZ,
    LZ is NX*AY - NY*AX,
    Left = [LX,LY,LZ],
    v(D, WA, X1, Y1, _),
    v(D, WB, X2, Y2, _),
    Flat is sqrt((X2-X1)**2 + (Y2-Y1)**2),
    Flat > 0.0,
    CX is (X2-X1)/Flat,
    CY is (Y2-Y1)/Flat.

in_frame(frame(point(XA,YA,ZA), [AX,AY,AZ], [LX,LY,LZ], X1-Y1, CX-CY),
         point(X0,Y0,Z0), X-Y) :-
    U is (X0-XA)*AX + (Y0-YA)*AY + (Z0-ZA)*AZ,
    V is (X0-XA)*LX + (Y0-YA)*LY + (Z0-ZA)*LZ,
    X is X1 + U*CX - V*CY,
    Y is Y1 + U*CY + V*CX.


                /*******************************
                *            CORNERS           *
                *******************************/

%   corners_moved(D, S, Meets, Corners): each corner of D that a hole has on a
%   fold or seam of flat faces is moved along that to where the true surface
%   meets it. Corners is an assoc from such vertices of S to their true places,
%   or to `none`, where the surface does not meet the fold near.

corners_moved(D, S, Meets, Corners) :-
    findall(A-Place-corner(P, Fold),
            ( p(D, P, Es),
              \+ unrolled_surface(S, P, _),
              member(Fold, Es),
              corner(S, P, Es, Fold, Meets, A, Place) ),
            Found0),
    sort(Found0, Found),
    findall(A-Place, member(A-Place-_, Found), Places0),
    sort(1, @<, Places0, Places),
    list_to_assoc(Places, Corners),
    findall(W-At,
            ( member(A-_-corner(_, Fold), Found),
              get_assoc(A, Corners, Place),
              Place \== none,
              laid_along(D, S, Fold, A, Place, W, At) ),
            Moves0),
    sort(1, @<, Moves0, Moves),
    forall(member(W-At, Moves), vertex_laid(D, W, At)).

%   corner(S, P, Es, Fold, Meets, A, Place): at A, an end of Fold, the polygon P
%   of the edges Es was cut by a curved surface.

corner(S, P, Es, Fold, Meets, A, Place) :-
    flat_neighbour(S, Fold, Q),
    e(S, Fold, From, To, _),
    member(A, [From,To]),
    member(E, Es),
    E \== Fold,
    e(S, E, V1, V2, _),
    memberchk(A, [V1,V2]),
    \+ flat_neighbour(S, E, _),
    once(cutting_surface(S, P, E, Meets, Surface)),
    maplist(vertex_point(S), [From,To], Ends),
    vertex_point(S, A, Point),
    maplist(polygon_plane(S), [P,Q], Planes),
    (   kept_side(S, P, V1, V2, Surface, Side),
        met_on_fold(Surface, Planes, Ends, Point, Side, Place0)
    ->  Place = Place0
    ;   Place = none
    ).

%   kept_side(S, P, V1, V2, Surface, Side): beside its edge V1-V2, which runs
%   along Surface, P lies outside of that, 1, or inside, -1.

kept_side(S, P, V1, V2, Surface, Side) :-
    maplist(vertex_point(S), [V1,V2], [Point1,Point2]),
    along_fold(Point1, Point1, Point2, 0.5, Middle),
    surface_value(Surface, Middle, _, vector(A,B,C)),
    polygon_plane(S, P, plane(NX,NY,NZ,_)),
    way(Point1, Point2, X, Y, Z),
    cross_product(p(NX,NY,NZ), p(X,Y,Z), Within),
    dot_product(Within, p(A,B,C), Along),
    Side is float(sign(Along)).

%   met_on_fold(Surface, Planes, Ends, Point, Side, Place): Surface meets the
%   fold, between Planes and Ends, near its end Point, so that the fold is on
%   that Side of it. A fold may go through it twice, near Point: what is found
%   first may be where it comes out again.

met_on_fold(Surface, Planes, Ends, Point, Side, Place) :-
    Ends = [End1,End2],
    arc_reach(End1, End2, Reach),
    Wide is 8.0*Reach,
    far_end(Ends, Point, Far),
    member(Times, [0.0,1.0,-1.0,4.0,-4.0]),
    along_fold(Point, Point, Far, Times, Start),
    surfaces_meet([Surface|Planes], Wide, Start, Place),
    fold_leaves(Surface, Place, Far, Side),
    arc_reach(Point, Place, Off),
    Off =< Reach,
    !.

far_end([End1,End2], Point, Far) :-
    (   End1 == Point
    ->  Far = End2
    ;   Far = End1
    ).

%   fold_leaves(Surface, Place, Far, Side): from Place, which is on Surface, to
%   Far one comes to that Side of it.

fold_leaves(Surface, Place, Far, Side) :-
    surface_value(Surface, Place, _, vector(A,B,C)),
    way(Place, Far, X, Y, Z),
    Side*(A*X + B*Y + C*Z) > 0.0.

along_fold(point(X0,Y0,Z0), Point, Far, Times, point(X,Y,Z)) :-
    way(Point, Far, DX, DY, DZ),
    X is X0 + Times*DX,
    Y is Y0 + Times*DY,
    Z is Z0 + Times*DZ.

%   flat_neighbour(S, E, Q): beyond edge E there is the flat polygon Q.

flat_neighbour(S, E, Q) :-
    e(S, E, A, B, _),
    e(S, Twin, B, A, _),
    edge_polygon(S, Twin, Q),
    \+ unrolled_surface(S, Q, _),
    !.

%   true_point(S, Corners, V, Point): fails for a corner that has none.

true_point(S, Corners, V, Point) :-
    (   get_assoc(V, Corners, Place)
    ->  Place = point(_,_,_),
        Point = Place
    ;   vertex_point(S, V, Point)
    ).

%   laid_along(D, S, Fold, A, Place, W, At): Place, on Fold of S near its end A,
%   is At in D, where A is W.

laid_along(D, S, Fold, A, Place, W, At) :-
    e(S, Fold, From, To, _),
    e(D, Fold, W1, W2, _),
    (   A == From
    ->  B = To, W = W1, Other = W2
    ;   B = From, W = W2, Other = W1
    ),
    vertex_point(S, A, PA),
    vertex_point(S, B, PB),
    way(PB, PA, AX, AY, AZ),
    way(PA, Place, MX, MY, MZ),
    Part is (MX*AX + MY*AY + MZ*AZ)/(AX*AX + AY*AY + AZ*AZ),
    v(D, W, X1, Y1, _),
    v(D, Other, X2, Y2, _),
    X is X1 + Part*(X1-X2),
    Y is Y1 + Part*(Y1-Y2),
    At = X-Y.

way(point(X1,Y1,Z1), point(X2,Y2,Z2), X, Y, Z) :-
    X is X2-X1,
    Y is Y2-Y1,
    Z is Z2-Z1.

%   vertex_laid(D, W, At): W is At now, and its polygons are divided anew.

vertex_laid(D, W, X-Y) :-
    retractall_facts(v(D, W, _, _, _)),
    assert_fact(v(D, W, X, Y, 0.0)),
    forall(( ( e(D, E, W, _, _) ; e(D, E, _, W, _) ), edge_polygon(D, E, P) ),
           not_completed(D, P)).

not_completed(D, P) :-
    retractall_facts(t(D, P, _, _, _, _)),
    retractall_facts(plane(D, P, _, _, _, _)).

                /*******************************
                *             ROWS             *
                *******************************/

polygon_rounded(D, P, Arcs) :-
    once(p(D, P, Es0)),
    maplist(edge_divided(D, Arcs), Es0, Lists),
    append(Lists, Es),
    not_completed(D, P),
    retractall_facts(p(D, P, Es0)),
    assert_fact(p(D, P, Es)),
    forall(member(arc(E, _), Arcs), retractall_facts(e(D, E, _, _, _))).

edge_divided(D, Arcs, E, Es) :-
    (   member(arc(E, Points), Arcs)
    ->  e(D, E, A, B, Et),
        findall(W,
                ( member(X-Y, Points),
                  fresh_id(v, D, W),
                  assert_fact(v(D, W, X, Y, 0.0)) ),
                Ws0),
        append(Ws0, [B], Ws),
        foldl(piece_written(D, E, Et), Ws, A-[], _-Es1),
        reverse(Es1, Es)
    ;   Es = [E]
    ).

piece_written(D, E, Et, W, V-Es, W-[New|Es]) :-
    fresh_id(e, D, New),
    assert_fact(e(D, New, V, W, Et)),
    assert_fact(origin(D, e(New), e(E))).
