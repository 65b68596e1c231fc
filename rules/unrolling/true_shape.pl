:- module(sg_true_shape,
          [ true_part/5,                % ?S, ?Part, -Leaf, -Name, -Surface
            part_facet/5,               % +S, +Part, ?P, -T1, -T2
            part_facets/4,              % +S, +Part, -Facets, -Shape
            pieces_facets/4,            % +S, +Part, +Leaf, -Table
            piece_shape/6,              % +S, +Part, +Table, +Piece, -Facets,
                                        % -Shape
            key_place/4,                % +Nodes, +Key, -T, -H
            edge_curve/4,               % +Shape, +Key1, +Key2, -Curve
            same_generator/3,           % +Nodes, +Key1, +Key2
            facet_middle/2,             % +Facet, -T
            facets_sense/3,             % +Facets, +Shape, -Sense
            shifted_facet/3             % +Turns, +Facet, -Shifted
          ]).
:- use_module('../near',
              [ same_angle/2, before_angle/2, same_part/2,
                less_part/2
              ]).
:- use_module('../kernel', [surface_place/4, surfaces_meet/4]).
:- use_module('../csg/placed_surface',
              [ kept_answer/4, placed_face/3, placed_polygon/4,
                placed_surface/3
              ]).
:- use_module('../primitive/primitive_face', [surface_point/4]).
:- use_module('../store', [e/5, p/3, v/5, from_p/5]).
:- use_module(true_surface,
              [generator_plane/3, level_plane/3, meeting_surfaces/4]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(assoc),
              [empty_assoc/1, get_assoc/3, list_to_assoc/2, put_assoc/4]).
:- use_module(library(lists), [member/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Facets of a smooth surface, and where their vertices truly are.

A *facet* is facet(P, T1, T2, Halves): polygon P (P/I: a part of it) stands for
the surface between the generators T1 and T2, degrees, T1 < T2. Halves are its
half-edges half(Key1, Key2, Label), Label edge(E), or cut(N) and -cut(N) where a
facet was divided.

A *key* k(Id, Turn) names a point of the unrolled surface: Id is a vertex of the
segment, or a term where dividing made a point; Turn counts how often it was
carried round, so that the two copies of a point of the seam have keys of their
own (`apex`: that of a cone). *Nodes* is an assoc from Id to node(T, H, Point,
Surfaces): its parameters (T is `any` at an apex), the point in space, and the
surfaces of other segments it lies on. Its parameters in the pattern are T +
360*Turn and H.

A vertex of a penetration line is not taken as it is: facets met there. It goes
to where the smooth surfaces meet, along its generator if it is on one that is
an edge of facets.

A *shape* is shape(Surface, Reach, Nodes); Reach is how far a true point may be
from that of the facets.
*/

%!  true_part(?S, ?Part, -Leaf, -Name, -Surface) is nondet.
%
%   Segment S has facets of Surface, which is the part Name of the primitive
%   Leaf. Part names it in S: Name if S is a primitive itself, Leaf/Name if S
%   was made of it.

true_part(S, Part, S, Part, Surface) :-
    placed_surface(S, Part, Surface),
    \+ from_p(S, _, _, _, _),
    once(part_facet(S, Part, _, _, _)).
true_part(S, Leaf/Name, Leaf, Name, Surface) :-
    kept_answer(made_part, S, Leaf/Name, _),
    placed_surface(Leaf, Name, Surface).

made_part(S, Leaf/Name, made) :-
    findall(Leaf-Name,
            ( placed_polygon(S, _, Leaf, P0),
              facet_of(Leaf, P0, Name, _, _) ),
            Parts0),
    sort(Parts0, Parts),
    member(Leaf-Name, Parts).

%   facet_of(Leaf, P, Name, T1, T2): polygon P of the primitive Leaf is a facet
%   of its part Name. Also of those of which a transition is made, and of all of
%   the transition.

facet_of(Leaf, P, Name, T1, T2) :-
    placed_face(Leaf, P, What),
    facet_part(What, Leaf, Name, T1, T2).

facet_part(curved(Name, [T1-T2]), _, Name, T1, T2).
facet_part(side(I), Leaf, side(I), 0.0, 90.0) :-
    placed_surface(Leaf, side(I), fan(_, _, _, _)).
facet_part(What, Leaf, Whole, 0.0, 0.0) :-
    (   What = side(_)
    ->  Name = What
    ;   What = curved(Name, _)
    ),
    placed_surface(Leaf, Whole, transition(pieces(Places))),
    memberchk(piece(Name, _, _, _), Places).

%!  part_facet(+S, +Part, ?P, -T1, -T2) is nondet.
%
%   Polygon P of segment S is a facet of Part, between the generators T1 and T2,
%   degrees.

part_facet(S, Part, P, T1, T2) :-
    (   Part = _/_
    ->  kept_answer(made_facet, S, Part, facet(P, T1, T2))
    ;   kept_answer(own_facet, S, Part, facet(P, T1, T2))
    ).

made_facet(S, Leaf/Name, facet(P, T1, T2)) :-
    placed_polygon(S, P, Leaf, P0),
    facet_of(Leaf, P0, Name, T1, T2).

own_facet(S, Part, facet(P, T1, T2)) :-
    facet_of(S, P, Part, T1, T2).

%!  part_facets(+S, +Part, -Facets, -Shape) is det.
%
%   Facets, in the order of their polygons, are those of Part of segment S, and
%   Shape has their vertices in true places.
%
%   @error geometry_error(true(moved(S, Part))): S is not where the primitive is

part_facets(S, Part, Facets, shape(Surface, Reach, Nodes)) :-
    once(true_part(S, Part, Leaf, _, Surface)),
    findall(facet(P, T1, T2, Halves),
            ( part_facet(S, Part, P, T1, T2),
              facet_halves(S, P, Halves) ),
            Facets0),
    (   Surface = ruled(_, _, _, _, _, _)
    ->  list_to_assoc([], Meets)
    ;   findall(V,
                ( member(facet(_, _, _, Halves), Facets0),
                  member(half(V, _, _), Halves) ),
                Vs0),
        sort(Vs0, Vs),
        meeting_surfaces(S, Leaf, Vs, Meets)
    ),
    facets_placed(S, Part, Meets, Surface, Facets0, Facets,
                  shape(Surface, Reach, Nodes)).

%   facets_placed(S, Part, Meets, Surface, Facets0, Facets, Shape)

facets_placed(S, Part, Meets, Surface, Facets0, Facets,
              shape(Surface, Reach, Nodes)) :-
    facets_reach(S, Facets0, Reach),
    empty_assoc(Nodes0),
    Shape0 = shape(Surface, Reach, Nodes0),
    foldl(facet_nodes(S, Shape0, Meets), Facets0, Nodes0, Nodes1),
    foldl(kept_in_order(Shape0, 1), Facets0, Nodes1, Nodes),
    (   in_place(Facets0, Nodes)
    ->  maplist(keyed_facet(Nodes), Facets0, Facets)
    ;   throw(error(geometry_error(true(moved(S, Part))), _))
    ).

%!  pieces_facets(+S, +Part, +Leaf, -Table) is det.
%!  piece_shape(+S, +Part, +Table, +Piece, -Facets, -Shape) is det.
%
%   As part_facets/4, of the parts of which a transition is made, many as they
%   may be: Part of S is all of the transition Leaf. Facets is [] if nothing is
%   left of the part Piece.

pieces_facets(S, Part, Leaf, pieces(Facets, Surfaces, Meets)) :-
    findall(Name-facet(P, T1, T2, Halves),
            ( piece_polygon(S, Part, Leaf, P, P0),
              placed_face(Leaf, P0, What),
              piece_of(What, Name, T1, T2),
              facet_halves(S, P, Halves) ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    list_to_assoc(Groups, Facets),
    findall(Name-Surface,
            ( placed_surface(Leaf, Name, Surface),
              Surface \= transition(_) ),
            Named),
    list_to_assoc(Named, Surfaces),
    meeting_surfaces(S, Leaf, all, Meets).

piece_polygon(S, Part, Leaf, P, P0) :-
    (   Part = Leaf/_
    ->  placed_polygon(S, P, Leaf, P0)
    ;   p(S, P, _),
        P0 = P
    ).

piece_of(curved(Name, [T1-T2]), Name, T1, T2).
piece_of(side(I), side(I), 0.0, 90.0).

piece_shape(S, Part, pieces(Facets0, Surfaces, Meets), Piece, Facets, Shape) :-
    get_assoc(Piece, Surfaces, Surface),
    (   get_assoc(Piece, Facets0, Own)
    ->  facets_placed(S, Part, Meets, Surface, Own, Facets, Shape)
    ;   Facets = [],
        empty_assoc(Nodes),
        Shape = shape(Surface, 0.0, Nodes)
    ).

facet_halves(S, P, Halves) :-
    p(S, P, Es),
    findall(half(A, B, edge(E)),
            ( member(E, Es), e(S, E, A, B, _) ),
            Halves).

facets_reach(S, Facets, Reach) :-
    findall(X-Y-Z,
            ( member(facet(_, _, _, Halves), Facets),
              member(half(V, _, _), Halves),
              v(S, V, X, Y, Z) ),
            [X0-Y0-Z0|Points]),
    foldl(wider, Points, box(X0,X0,Y0,Y0,Z0,Z0), box(A,B,C,D,E,F)),
    Reach is max(B-A, max(D-C, F-E))/4.0.

wider(X-Y-Z, box(A0,B0,C0,D0,E0,F0), box(A,B,C,D,E,F)) :-
    A is min(A0, X),
    B is max(B0, X),
    C is min(C0, Y),
    D is max(D0, Y),
    E is min(E0, Z),
    F is max(F0, Z).

%   in_place(Facets, Nodes): corners lie between the generators of their
%   facets: a leaf that was placed elsewhere is not where its surface is.

in_place(Facets, Nodes) :-
    \+ ( member(facet(_, T1, T2, Halves), Facets),
         Middle is (T1+T2)/2.0,
         Most is (T2-T1)*0.51,
         member(half(V, _, _), Halves),
         get_assoc(V, Nodes, node(T, _, _, [])),
         T \== any,
         before_angle(Most, abs(T - 360.0*round((T-Middle)/360.0) - Middle))
       ).


                /*******************************
                *             NODES            *
                *******************************/

facet_nodes(S, Shape, Meets, Facet, Nodes0, Nodes) :-
    Facet = facet(_, _, _, Halves),
    foldl(half_node(S, Shape, Meets, Facet), Halves, Nodes0, Nodes).

half_node(S, Shape, Meets, Facet, half(V, _, _), Nodes0, Nodes) :-
    (   get_assoc(V, Nodes0, _)
    ->  Nodes = Nodes0
    ;   v(S, V, X, Y, Z),
        (   get_assoc(V, Meets, Met)
        ->  true
        ;   Met = met([], [])
        ),
        vertex_node(Shape, Facet, point(X,Y,Z), Met, Node),
        put_assoc(V, Nodes0, Node, Nodes)
    ).

vertex_node(Shape, Facet, Point0, Met, node(T, H, Point, Surfaces)) :-
    Met = met(Surfaces, _),
    Shape = shape(Surface, _, _),
    facet_place(Surface, Facet, Point0, Border, T0, H0),
    (   Border == apex
    ->  T = any,
        H = H0,
        Point = Point0
    ;   Surface = ruled(_, _, _, _, _, _)
    ->  T = T0,
        H = H0,
        Point = Point0
    ;   true_point(Shape, Border, T0-H0, Met, Point0, Point1)
    ->  Point = Point1,
        surface_place(Surface, Point, T2, H1),
        near_turn(T0, T2, T1),
        level(H1, H, _),
        (   Border == generator
        ->  T = T0
        ;   T = T1
        )
    ;   T = T0,
        H = H0,
        surface_point(Surface, T, H, Point)
    ).

%   facet_place(Surface, Facet, Point, Border, T, H): of a point of the facet;
%   Border is what border of the facet it is on: `generator`, `level`, `apex`,
%   or `none`.

facet_place(Surface, facet(_, T1, T2, _), Point, Border, T, H) :-
    Middle is (T1+T2)/2.0,
    surface_place(Surface, Point, T0, H0),
    near_turn(Middle, T0, T3),
    level(H0, H, Level),
    (   ( Surface = cone(_, _, _, _, K) ; Surface = fan(_, _, _, K) ),
        same_part(1.0, H*(1.0-K))
    ->  T = any,
        Border = apex
    ;   member(T, [T1,T2]),
        same_angle(T, T3)
    ->  Border = generator
    ;   T = T3,
        Border = Level
    ).

near_turn(Middle, T0, T) :-
    T is T0 + 360.0*round((Middle-T0)/360.0).

level(H0, H, Border) :-
    (   member(H, [0.0,1.0]),
        same_part(H, H0)
    ->  Border = level
    ;   H = H0,
        Border = none
    ).

%   true_point(Shape, Border, T-H, Met, Point0, Point): where the surface meets
%   what the point lies on, on the border of its facet. With two other surfaces
%   it is their corner, if it is free to go there; else it stays on the
%   generator of the other surface: then points keep their order.

true_point(shape(Surface, Reach, _), Border, Place, Met, Point0, Point) :-
    Met = met(Surfaces, _),
    member(First, Surfaces),
    more_surfaces(Border, Place, Surface, First, Met, More),
    surfaces_meet([Surface,First|More], Reach, Point0, Point),
    !.

more_surfaces(generator, T-_, Surface, _, _, [Plane]) :-
    generator_plane(Surface, T, Plane).
more_surfaces(level, _-H, Surface, _, _, [Plane]) :-
    level_plane(Surface, H, Plane).
more_surfaces(none, _, _, First, met(Surfaces, _), [Second]) :-
    member(Second, Surfaces),
    Second @> First.
more_surfaces(none, _, _, _, met([_], Guides), [Guide]) :-
    member(Guide, Guides).
more_surfaces(none, _, _, _, _, []).


%   kept_in_order(Shape, I, Facet, Nodes0, Nodes): along the line of the facets
%   a point comes before one on a generator; where the true point is past the
%   generator, it would run back: it is kept a little before it, the Ith a
%   little more than those that came after it.

kept_in_order(Shape, I, Facet, Nodes0, Nodes) :-
    Facet = facet(_, _, _, Halves),
    (   is_past(Facet, Nodes0)          % mostly none is
    ->  findall(V-T,
                ( member(half(A, B, _), Halves),
                  ( V-W = A-B ; V-W = B-A ),
                  past(Facet, I, Nodes0, V, W, T) ),
                Pasts0)
    ;   Pasts0 = []
    ),
    (   Pasts0 == []
    ->  Nodes = Nodes0
    ;   sort(1, @<, Pasts0, Pasts),
        foldl(moved_back(Shape), Pasts, Nodes0, Nodes1),
        (   Nodes1 == Nodes0            % none of them can go there
        ->  Nodes = Nodes0
        ;   I1 is I+1,
            kept_in_order(Shape, I1, Facet, Nodes1, Nodes)
        )
    ).

%   is_past(Facet, Nodes): a corner of Facet is past a generator of it.

is_past(Facet, Nodes) :-
    Facet = facet(_, T1, T2, Halves),
    facet_middle(Facet, Middle),
    member(half(V, _, _), Halves),
    node_near(Nodes, Middle, V, T),
    (   less_part(T2, T)
    ;   less_part(T, T1)
    ),
    !.

%   past(Facet, I, Nodes, V, W, T): V is past a generator of Facet, and W is on
%   it, or was moved back from there; T is the place for V.

past(facet(_, T1, T2, _), I, Nodes, V, W, T) :-
    Middle is (T1+T2)/2.0,
    node_near(Nodes, Middle, V, TV),
    (   less_part(T2, TV)
    ->  T is T2 - I*1.0e-3*(T2-T1),
        node_near(Nodes, Middle, W, TW),
        \+ less_part(T2, TW),
        \+ less_part(TW, T)
    ;   less_part(TV, T1),
        T is T1 + I*1.0e-3*(T2-T1),
        node_near(Nodes, Middle, W, TW),
        \+ less_part(TW, T1),
        \+ less_part(T, TW)
    ).

node_near(Nodes, Middle, V, T) :-
    get_assoc(V, Nodes, node(T0, _, _, _)),
    T0 \== any,
    near_turn(Middle, T0, T).

moved_back(Shape, V-T, Nodes0, Nodes) :-
    Shape = shape(Surface, _, _),
    get_assoc(V, Nodes0, node(_, _, Point0, Surfaces)),
    (   true_point(Shape, generator, T-none, met(Surfaces, []), Point0, Point)
    ->  surface_place(Surface, Point, _, H),
        put_assoc(V, Nodes0, node(T, H, Point, Surfaces), Nodes)
    ;   Nodes = Nodes0
    ).


                /*******************************
                *             KEYS             *
                *******************************/

%!  facet_middle(+Facet, -T) is det.
%
%   T, degrees, is the parameter halfway between the generators of Facet.

facet_middle(facet(_, T1, T2, _), Middle) :-
    Middle is (T1+T2)/2.0.

keyed_facet(Nodes, Facet, facet(P, T1, T2, Halves)) :-
    Facet = facet(P, T1, T2, Halves0),
    facet_middle(Facet, Middle),
    maplist(keyed_half(Nodes, Middle), Halves0, Halves).

keyed_half(Nodes, Middle, half(A, B, Label), half(K, L, Label)) :-
    vertex_key(Nodes, Middle, A, K),
    vertex_key(Nodes, Middle, B, L).

vertex_key(Nodes, Middle, V, k(V, Turn)) :-
    get_assoc(V, Nodes, node(T, _, _, _)),
    (   T == any
    ->  Turn = apex
    ;   Turn is round((Middle-T)/360.0)
    ).

%!  key_place(+Nodes, +Key, -T, -H) is det.
%
%   The parameters of Key in the pattern; T is `any` at an apex.

key_place(Nodes, k(Id, Turn), T, H) :-
    get_assoc(Id, Nodes, node(T0, H, _, _)),
    (   T0 == any
    ->  T = any
    ;   T is T0 + 360.0*Turn
    ).

%!  shifted_facet(+Turns, +Facet, -Shifted) is det.
%
%   Shifted is Facet carried round so many times.

shifted_facet(0, Facet, Facet) :-
    !.
shifted_facet(Turns, facet(P, T1, T2, Halves0), facet(P, T3, T4, Halves)) :-
    T3 is T1 + 360.0*Turns,
    T4 is T2 + 360.0*Turns,
    maplist(shifted_half(Turns), Halves0, Halves).

shifted_half(Turns, half(K0, L0, Label), half(K, L, Label)) :-
    shifted_key(Turns, K0, K),
    shifted_key(Turns, L0, L).

shifted_key(Turns, k(Id, Turn0), k(Id, Turn)) :-
    (   Turn0 == apex
    ->  Turn = apex
    ;   Turn is Turn0+Turns
    ).

%!  facets_sense(+Facets, +Shape, -Sense) is det.
%
%   Sense is 1 if Facets run counter-clockwise with T to the right and H up, or
%   else -1: by the area of all. A single one may have been turned over where
%   its vertices went to the true surfaces.

facets_sense(Facets, shape(_, _, Nodes), Sense) :-
    foldl(facet_area(Nodes), Facets, 0.0, Area),
    (   Area > 0.0
    ->  Sense = 1
    ;   Sense = -1
    ).

facet_area(Nodes, Facet, Area0, Area) :-
    Facet = facet(_, _, _, Halves),
    facet_middle(Facet, Middle),
    foldl(half_area(Nodes, Middle), Halves, Area0, Area).

half_area(Nodes, Middle, half(K1, K2, _), Area0, Area) :-
    place_near(Nodes, K1, Middle, T1, H1),
    place_near(Nodes, K2, Middle, T2, H2),
    Area is Area0 + (T1-Middle)*H2 - (T2-Middle)*H1.

place_near(Nodes, Key, Middle, T, H) :-
    key_place(Nodes, Key, T0, H),
    (   T0 == any
    ->  T = Middle
    ;   T = T0
    ).


                /*******************************
                *             EDGES            *
                *******************************/

%!  same_generator(+Nodes, +Key1, +Key2) is semidet.
%
%   An edge between them runs along a generator.

same_generator(Nodes, Key1, Key2) :-
    key_place(Nodes, Key1, T1, _),
    key_place(Nodes, Key2, T2, _),
    (   ( T1 == any ; T2 == any )
    ->  true
    ;   same_part(T1, T2)
    ).

%!  edge_curve(+Shape, +Key1, +Key2, -Curve) is det.
%
%   What an edge between the keys truly is: `straight` in the pattern; level(H),
%   a part of the rim of the primitive; meets(Surface): where that of another
%   segment meets the part's own; or tip(H), all of one height, where a cone was
%   cut off (true_apex.pl).

edge_curve(Shape, Key1, Key2, Curve) :-
    Shape = shape(Surface, _, Nodes),
    (   same_generator(Nodes, Key1, Key2)
    ->  Curve = straight
    ;   same_height(Nodes, Key1, Key2, H),
        level_curve(Surface, H, Curve0)
    ->  Curve = Curve0
    ;   met_by_both(Shape, Key1, Key2, Met)
    ->  Curve = meets(Met)
    ;   narrowing(Surface),
        same_height(Nodes, Key1, Key2, H)
    ->  Curve = tip(H)
    ;   Curve = straight
    ).

same_height(Nodes, Key1, Key2, H) :-
    key_place(Nodes, Key1, _, H),
    key_place(Nodes, Key2, _, H2),
    H =:= H2.

level_curve(Surface, H, Curve) :-
    Surface \= fan(_, _, _, _),
    level(H, H, level),
    (   H > 0.5,
        pointed(Surface)
    ->  Curve = tip(H)
    ;   Curve = level(H)
    ).

pointed(cone(_, _, _, _, K)) :-
    K =:= 0.0.

narrowing(parallel(Surface, _)) :-
    narrowing(Surface).
narrowing(cone(_, _, _, _, K)) :-
    K < 1.0.

%   Of several surfaces that both ends lie on it is the one that the middle of
%   the edge is nearest to.

met_by_both(shape(Surface, Reach, Nodes), k(A,_), k(B,_), Met) :-
    get_assoc(A, Nodes, node(_, _, Point1, Surfaces1)),
    Surfaces1 \== [],
    get_assoc(B, Nodes, node(_, _, Point2, Surfaces2)),
    middle_point(Point1, Point2, Middle),
    findall(Off-Other,
            ( member(Other, Surfaces1),
              memberchk(Other, Surfaces2),
              (   surfaces_meet([Surface,Other], Reach, Middle, Point)
              ->  distance(Middle, Point, Off)
              ;   A = swept(_, _),      % true_sweep.pl: that is known
                  Off = Reach
              ) ),
            Mets),
    keysort(Mets, [_-Met|_]).

middle_point(point(X1,Y1,Z1), point(X2,Y2,Z2), point(X,Y,Z)) :-
    X is (X1+X2)/2.0,
    Y is (Y1+Y2)/2.0,
    Z is (Z1+Z2)/2.0.

distance(point(X1,Y1,Z1), point(X2,Y2,Z2), D) :-
    D is sqrt((X1-X2)**2 + (Y1-Y2)**2 + (Z1-Z2)**2).
