:- module(sg_true_layout,
          [ layout/6,                   % +Facets, +Shape, +Seam, +Sense,
                                        % +Options, -Layout
            chord_tolerance/3,          % +Options, +Size, -Chord
            layout_points/2,            % +Layout, -Points
            layout_curves/2,            % +Layout, -Curves
            layout_marks/6,             % +Layout, +Facets, +Sense, +Seam,
                                        % +Generators, -Marks
            mirrored_half/4,            % +Facets, +Seam, +Shape, +Sense
            strip_ends/3,               % +Strip, +Places, -Ends
            strip_layout/6              % +Strip, +Facets, +Motion, +Chord,
                                        % -Points, -Curves
          ]).
:- use_module('../near',
              [ tolerance/2, same_angle/2, before_angle/2, whole_turns/2,
                same_part/2, is_on_surface/2
              ]).
:- use_module('../kernel', [roll_curves/5, roll_points/3]).
:- use_module('../primitive/parallel_surface', [parallel_before/5]).
:- use_module('../primitive/primitive_face', [surface_point/4]).
:- use_module(true_divide, [facet_index/2, generator_spans/5]).
:- use_module(true_plate, [plate_layer/2]).
:- use_module(true_shape, [edge_curve/4, key_place/4]).
:- use_module(true_surface, [level_plane/3, offset_surface/3]).
:- use_module(true_transition, [transition_points/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(assoc),
              [get_assoc/3, list_to_assoc/2]).
:- use_module(library(error), [domain_error/2, must_be/2]).
:- use_module(library(lists),
              [append/2, append/3, max_list/2, member/2, min_list/2]).
:- use_module(library(option), [option/3]).
:- use_module(library(pairs), [group_pairs_by_key/2, pairs_keys_values/3]).
/** <module> Where a true development lies in its plane.

What the kernel unrolls starts anywhere; a *frame* brings it to paper: seen from
outside, H upwards (in the middle, for a cone), and lowest and leftmost at 0. Of
a cylinder y is then measured from the *base line*, which runs at right angles
to the generators through the lowest point.

A layout is layout(Kind, Shape, Layer-Seam, Frame, Points, Curves): Kind is
`cylinder`, `cone` or `flat`, Points an assoc from keys to X-Y.
*/

%!  layout(+Facets, +Shape, +Seam, +Sense, +Options, -Layout) is det.
%
%   Layout, as above, is where the Facets of Shape (true_shape.pl) lie when they
%   are opened at Seam, degrees. Sense is 1 if facets run counter-clockwise with
%   T to the right and H up, else -1. Options are those of true_development/4:
%   chord(Tolerance), and what plate_layer/2 has. In model units.
%
%   @error domain_error(chord, Tolerance)

layout(Facets, Shape, Seam, Sense, Options,
       layout(Kind, Shape, Layer-Seam, frame(Turn, X0, Y0), Points, Curves)) :-
    plate_layer(Options, Layer),
    Shape = shape(Surface, _, _),
    rolled_form(Surface, Form),
    (   Form == ruled
    ->  Kind = flat,
        transition_points(Facets, Shape, Pairs0),
        Turn = turn(1.0, 1.0, 0.0)
    ;   Kind = Form,
        facet_keys(Facets, Keys0),
        keys_unrolled(Shape, Layer, Seam, Keys0, Pairs0),
        turn(Shape, Layer, Seam, Facets, Sense, Turn)
    ),
    pairs_keys_values(Pairs0, Keys, Raw),
    maplist(turned(Turn), Raw, Turned),
    corner(Turned, _, _, Size),
    chord_tolerance(Options, Size, Chord),
    curves(Kind, Shape, Layer-Seam, Facets, Chord, RawCurves),
    pairs_keys_values(RawCurves, Edges, RawLists),
    maplist(maplist(turned(Turn)), RawLists, TurnedLists),
    append([Turned|TurnedLists], All),
    corner(All, X0, Y0, _),
    in_frame(frame(Turn, X0, Y0), Keys-Raw, Edges-RawLists, Points, Curves).

%   rolled_form(Surface, Form): `cylinder`, `cone` or `ruled`.

rolled_form(Surface, Form) :-
    (   Surface = parallel(Inner, _)
    ->  functor(Inner, Form, _)
    ;   functor(Surface, Form, _)
    ).

in_frame(Frame, Keys-Raw, Edges-RawLists, Points, Curves) :-
    maplist(framed(Frame), Raw, Placed),
    pairs_keys_values(Pairs, Keys, Placed),
    list_to_assoc(Pairs, Points),
    maplist(maplist(framed(Frame)), RawLists, Lists),
    pairs_keys_values(EdgePairs, Edges, Lists),
    list_to_assoc(EdgePairs, Curves).

%!  strip_ends(+Strip, +Places, -Ends) is det.
%
%   Ends are the points X-Y at Places, T-H, of the strip unrolled in no frame
%   yet, but as seen from outside. A strip is strip(Shape, Rolled, Sense): a
%   piece of what is composed. Rolled is rolled(Surface, T1-T2, U1-U2): not that
%   of Shape but Surface is unrolled, from U1 on; a place at T1 goes to U1, and
%   one at T2 to U2.

strip_ends(strip(_, Rolled, Sense), Places, Ends) :-
    rolled_points(Rolled, Places, Raw),
    Rolled = rolled(Surface, _, _),
    mirror(Surface, Sense, Mirror),
    maplist(turned(turn(Mirror, 1.0, 0.0)), Raw, Ends).

rolled_points(rolled(Surface, T1-T2, U1-U2), Places0, Points) :-
    F is (U2-U1)/(T2-T1),
    maplist(place_rolled(T1, U1, F), Places0, Places),
    roll_points(roll(Surface, 0.0, U1), Places, Points).

place_rolled(T1, U1, F, T-H, U-H) :-
    U is U1 + F*(T-T1).

%!  strip_layout(+Strip, +Facets, +Motion, +Chord, -Points, -Curves) is det.
%
%   As layout/6: what strip_ends/3 gives is moved by Motion, motion(Cos, Sin, X,
%   Y): turned, then moved. Chord is in model units.

strip_layout(Strip, Facets, motion(Cos, Sin, X, Y), Chord, Points, Curves) :-
    Strip = strip(Shape, Rolled, Sense),
    Shape = shape(_, _, Nodes),
    Rolled = rolled(Surface, T1-_, _),
    mirror(Surface, Sense, Mirror),
    facet_keys(Facets, Keys),
    maplist(key_pair(Nodes, T1), Keys, Places),
    rolled_points(Rolled, Places, Raw),
    curve_places(Shape, T1, Facets, Chord, CurvePlaces),
    pairs_keys_values(CurvePlaces, Edges, PlaceLists),
    maplist(rolled_points(Rolled), PlaceLists, RawLists),
    X0 is -X,
    Y0 is -Y,
    in_frame(frame(turn(Mirror, Cos, Sin), X0, Y0), Keys-Raw, Edges-RawLists,
             Points, Curves).

%   curve_places(Shape, Start, Facets, Chord, Places): Key1-Key2-List, List of
%   T-H on the curve.

curve_places(Shape, Start, Facets, Chord, Places) :-
    edges_curved(Shape, Facets, Curved),
    asked_curves(Shape, Curved, Asked),
    pairs_keys_values(Asked, Edges, Curves),
    Shape = shape(Surface, Reach, _),
    roll_curves(roll(Surface, 0.0, Start), Reach, Chord, Curves, Lists),
    pairs_keys_values(Pairs, Edges, Lists),
    findall((A-B)-List,
            ( member(edge(A, B, T1, T2)-Found, Pairs),
              Found \== [],
              findall(T-H,
                      ( member(place(T0, H, _, _), Found),
                        T is max(T1, min(T2, T0)) ),
                      List) ),
            Places).

%   edges_curved(Shape, Facets, Curved): Edge-Curve (edge_curve/4) of all edges
%   that are not straight.

edges_curved(Shape, Facets, Curved) :-
    facet_edges(Facets, Edges),
    findall(Edge-Curve,
            ( member(Edge, Edges),
              Edge = edge(A, B, _, _),
              edge_curve(Shape, A, B, Curve),
              Curve \== straight ),
            Curved).

asked_curves(Shape, Curved, Asked) :-
    findall(Edge-Asking,
            ( member(Edge-Curve, Curved),
              asked_curve(Curve, Shape, Edge, Asking) ),
            Asked).

%!  chord_tolerance(+Options, +Size, -Chord) is det.
%
%   Chord is how far off its curve an outline may be, in model units: that of
%   option chord(Chord), or 1.0e-4 of Size; not so small that points lie on each
%   other.
%
%   @error domain_error(chord, Chord): it is not larger than 0

chord_tolerance(Options, Size, Chord) :-
    Usual is 1.0e-4*Size,
    option(chord(Chord0), Options, Usual),
    must_be(number, Chord0),
    (   Chord0 > 0
    ->  tolerance(place, Of),
        Chord is max(Chord0, Of*Size)
    ;   domain_error(chord, Chord0)
    ).

%!  layout_points(+Layout, -Points) is det.
%
%   Points is an assoc from the keys of corners of facets to X-Y.

layout_points(layout(_, _, _, _, Points, _), Points).

%!  layout_curves(+Layout, -Curves) is det.
%
%   Curves is an assoc from Key1-Key2, Key1 @< Key2, of edges that are curves in
%   the pattern, to the points X-Y between their ends.

layout_curves(layout(_, _, _, _, _, Curves), Curves).

facet_keys(Facets, Keys) :-
    findall(Key,
            ( member(facet(_, _, _, Halves), Facets),
              member(half(Key, _, _), Halves) ),
            Keys0),
    sort(Keys0, Keys).

keys_unrolled(Shape, Layer, Seam, Keys, Pairs) :-
    Shape = shape(_, _, Nodes),
    roll(Shape, Layer, Seam, Roll),
    Middle is Seam + 180.0,
    maplist(key_pair(Nodes, Middle), Keys, Places),
    roll_points(Roll, Places, Points),
    pairs_keys_values(Pairs, Keys, Points).

roll(shape(Surface, _, _), Layer, Seam, roll(Surface, Layer, Seam)).

%   An apex is where any generator has it: in a layer that is not drawn there is
%   none (true_apex.pl).

key_pair(Nodes, Middle, Key, T-H) :-
    key_place(Nodes, Key, T0, H),
    (   T0 == any
    ->  T = Middle
    ;   T = T0
    ).

%   turn(Shape, Layer, Seam, Facets, Sense, Turn): Turn is turn(Mirror, Cos,
%   Sin): x is multiplied by Mirror, then all is turned. The generator in the
%   middle of a cone stands upright.

turn(Shape, Layer, Seam, Facets, Sense, turn(Mirror, Cos, Sin)) :-
    Shape = shape(Surface, _, _),
    mirror(Surface, Sense, Mirror),
    (   rolled_form(Surface, cone)
    ->  roll(Shape, Layer, Seam, Roll),
        middle_generator(Facets, T),
        roll_points(Roll, [T-0.0,T-1.0], [X1-Y1,X2-Y2]),
        DX is Mirror*(X2-X1),
        DY is Y2-Y1,
        Length is sqrt(DX*DX + DY*DY),
        Cos is DY/Length,
        Sin is DX/Length
    ;   Cos = 1.0,
        Sin = 0.0
    ).

%   mirror(Surface, Sense, Mirror): -1.0 if what is unrolled shows its inside.

mirror(Surface0, Sense, Mirror) :-
    (   Surface0 = parallel(Surface, _)
    ->  true
    ;   Surface = Surface0
    ),
    (   Surface = cone(_, _, _, _, K)
    ->  Mirror is Sense*sign(1.0-K)
    ;   Mirror is float(Sense)
    ).

middle_generator(Facets, T) :-
    findall(T1, member(facet(_, T1, _, _), Facets), Starts),
    findall(T2, member(facet(_, _, T2, _), Facets), Ends),
    min_list(Starts, First),
    max_list(Ends, Last),
    T is (First+Last)/2.0.

turned(turn(Mirror, Cos, Sin), X0-Y0, X-Y) :-
    X1 is Mirror*X0,
    X is Cos*X1 - Sin*Y0,
    Y is Sin*X1 + Cos*Y0.

framed(frame(Turn, X0, Y0), Raw, X-Y) :-
    turned(Turn, Raw, X1-Y1),
    X is X1-X0,
    Y is Y1-Y0.

corner(Points, X0, Y0, Size) :-
    pairs_keys_values(Points, Xs, Ys),
    min_list(Xs, X0),
    min_list(Ys, Y0),
    max_list(Xs, X1),
    max_list(Ys, Y1),
    Size is max(X1-X0, Y1-Y0).


                /*******************************
                *            CURVES            *
                *******************************/

%   curves(Kind, Shape, Seam, Facets, Chord, Curves): Curves is the list of
%   Key1-Key2-Points, unrolled and not yet in the frame.

curves(flat, _, _, _, _, []) :-
    !.
curves(_, Shape, Layer-Seam, Facets, Chord, Curves) :-
    Shape = shape(_, Reach, _),
    edges_curved(Shape, Facets, Curved),
    asked_curves(Shape, Curved, Asked),
    pairs_keys_values(Asked, Edges1, Curves1),
    roll(Shape, Layer, Seam, Roll),
    roll_curves(Roll, Reach, Chord, Curves1, Lists),
    pairs_keys_values(Pairs, Edges1, Lists),
    findall(Edge-Points,
            ( member(edge(A, B, T1, T2)-Places, Pairs),
              Places \== [],
              Edge = A-B,
              maplist(place_point(Roll, T1, T2), Places, Points) ),
            Met),
    findall((A-B)-Points,
            ( member(edge(A, B, _, _)-tip(_), Curved),
              tip_curve(Shape, Roll, Chord, A, B, Points) ),
            Tips),
    append(Met, Tips, Curves).

%   tip_curve(Shape, Roll, Chord, A, B, Points): Points, one or more, between A
%   and B, where a cone was cut off: halved until no middle is farther than
%   Chord from its chord.

tip_curve(Shape, Roll, Chord, A, B, Points) :-
    Shape = shape(_, _, Nodes),
    key_place(Nodes, A, T1, H),
    key_place(Nodes, B, T2, _),
    roll_points(Roll, [T1-H,T2-H], [P,Q]),
    halved(tip(Roll, H, Chord), T1-P, T2-Q, Points, []),
    Points \== [].

halved(Tip, T1-P, T2-Q, Points0, Points) :-
    Tip = tip(Roll, H, Chord),
    T is (T1+T2)/2.0,
    roll_points(Roll, [T-H], [M]),
    (   off_chord(P, Q, M, Off),
        Off > Chord,
        abs(T2-T1) > 0.1
    ->  halved(Tip, T1-P, T-M, Points0, [M|Points1]),
        halved(Tip, T-M, T2-Q, Points1, Points)
    ;   Points0 = Points
    ).

off_chord(X1-Y1, X2-Y2, X-Y, Off) :-
    Off is sqrt((X - (X1+X2)/2.0)**2 + (Y - (Y1+Y2)/2.0)**2).

%   place_point(Roll, T1, T2, Place, Point): a curve stays on its facet, between
%   T1 and T2.

place_point(Roll, T1, T2, place(T, H, X, Y), Point) :-
    (   T >= T1,
        T =< T2
    ->  Point = X-Y
    ;   T3 is max(T1, min(T2, T)),
        roll_points(Roll, [T3-H], [Point])
    ).

%   facet_edges(Facets, Edges): of edge(Key1, Key2, T1, T2), Key1 @< Key2, each
%   once. T1 to T2 is the facet, less a little at its generators.

facet_edges(Facets, Edges) :-
    tolerance(surface, Of),
    findall(edge(A, B, T1, T2),
            ( member(facet(_, Start, End, Halves), Facets),
              Margin is Of*(End-Start),
              T1 is Start + Margin,
              T2 is End - Margin,
              member(half(K1, K2, _), Halves),
              msort([K1,K2], [A,B]) ),
            Edges0),
    sort(Edges0, Edges).

%   asked_curve(Curve, Shape, Edge, Asking): Asking is what roll_curves/5 is
%   asked of an edge.

asked_curve(Curve, shape(Surface, _, Nodes), edge(A, B, _, _),
            curve(Near, [Surface,Other], From, To)) :-
    key_place(Nodes, A, T1, _),
    key_place(Nodes, B, T2, _),
    (   Curve = level(H)
    ->  level_plane(Surface, H, Other),
        surface_point(Surface, T1, H, From),
        surface_point(Surface, T2, H, To)
    ;   Curve = meets(Other),
        A = k(Id1, _),
        B = k(Id2, _),
        get_assoc(Id1, Nodes, node(_, _, From, _)),
        get_assoc(Id2, Nodes, node(_, _, To, _))
    ),
    Near is (T1+T2)/2.0.


                /*******************************
                *          GENERATORS          *
                *******************************/

%!  layout_marks(+Layout, +Facets, +Sense, +Seam, +Generators, -Marks) is det.
%
%   Marks, in the order of Generators, a list of Number-T, are
%   mark(Number, Degrees, Position, From, To, X1-Y1, X2-Y2), one for each part
%   of a generator that lies on facets, from below. Degrees is its parameter, 0
%   to 360. Of a cylinder Position is x, From and To are y; of a cone Position
%   is the angle from the seam, degrees, and From and To are distances from the
%   apex (of the layer that is unrolled, if it has one), From being at the lower
%   H; of a transition Position is 0.0 and From to
%   To its length from 0.0.

layout_marks(Layout, Facets, Sense, Seam, Generators, Marks) :-
    Layout = layout(Kind, Shape, _, _, _, _),
    facet_index(Facets, Index),
    findall(Mark,
            ( member(Number-T, Generators),
              generator_spans(Index, T, Sense, Shape, Spans),
              member(H1-H2, Spans),
              mark_ends(Kind, Layout, Facets, T, H1, H2, P, Q),
              measures(Kind, Layout, Seam, T, H1-P, H2-Q, Position, From, To),
              whole_turns(T, By),
              Degrees is T - By + 0.0,
              Mark = mark(Number, Degrees, Position, From, To, P, Q) ),
            Marks).

mark_ends(flat, layout(_, Shape, _, _, Points, _), Facets, T, H1, H2, P, Q) :-
    !,
    key_at(Facets, Shape, T, H1, K1),
    key_at(Facets, Shape, T, H2, K2),
    get_assoc(K1, Points, P),
    get_assoc(K2, Points, Q).
mark_ends(_, layout(_, Shape, Layer-Seam, Frame, _, _), _, T, H1, H2, P, Q) :-
    roll(Shape, Layer, Seam, Roll),
    roll_points(Roll, [T-H1,T-H2], Raw),
    maplist(framed(Frame), Raw, [P,Q]).

key_at(Facets, shape(_, _, Nodes), T, H, Key) :-
    member(facet(_, _, _, Halves), Facets),
    member(half(Key, _, _), Halves),
    key_place(Nodes, Key, T1, H1),
    same_angle(T, T1),
    same_part(H, H1),
    !.

measures(cylinder, _, _, _, _-(X-Y1), _-(_-Y2), X, Y1, Y2).
measures(cone, layout(_, Shape, Layer-_, _, _, _), Seam, T, H1-_, H2-_,
         Angle, R1, R2) :-
    Shape = shape(Surface0, _, _),
    before_moving(Surface0, T, H1, Surface, B1),
    before_moving(Surface0, T, H2, Surface, B2),
    Surface = cone(_, _, _, _, K),
    roll_points(roll(Surface, 0.0, Seam), [T-0.0], [X-Y]),
    Angle0 is atan2(Y, X)*180.0/pi,
    (   before_angle(Angle0, 0.0)
    ->  Angle is Angle0 + 360.0
    ;   Angle is max(0.0, Angle0)
    ),
    Apex is 1.0/(1.0-K),
    surface_point(Surface, T, 0.0, P),
    surface_point(Surface, T, Apex, Q),
    far(P, Q, Far),
    apex_farther(Surface0, Layer, Farther),
    R1 is Far*abs(1.0 - B1*(1.0-K)) + Farther,
    R2 is Far*abs(1.0 - B2*(1.0-K)) + Farther.
measures(flat, _, _, _, _-(X1-Y1), _-(X2-Y2), 0.0, 0.0, Length) :-
    Length is sqrt((X1-X2)**2 + (Y1-Y2)**2).

%   apex_farther(Surface, Layer, Farther): by how much an apex of that layer is
%   farther than that of Surface. Only the generators of a right circular cone
%   meet in one point there too; those of others end where they end.

apex_farther(Surface, Layer, Farther) :-
    (   Layer =\= 0.0,
        Surface = cone(_, U, _, W, K),
        offset_surface(Surface, Layer, _)
    ->  vector_length(U, R),
        vector_length(W, H),
        Farther is Layer*H/(abs(1.0-K)*R)
    ;   Farther = 0.0
    ).

vector_length(vector(X,Y,Z), Length) :-
    Length is sqrt(X*X + Y*Y + Z*Z).

%   before_moving(Surface0, T, H0, Surface, H): the point (T, H0) of Surface0 is
%   that of Surface at (T, H), moved along the normal.

before_moving(Surface0, T, H0, Surface, H) :-
    (   Surface0 = parallel(Surface, Distance)
    ->  parallel_before(Surface, Distance, T, H0, H)
    ;   Surface = Surface0,
        H = H0
    ).


                /*******************************
                *           HALVES             *
                *******************************/

%!  mirrored_half(+Facets, +Seam, +Shape, +Sense) is semidet.
%
%   The pattern opened at Seam is its own mirror image: each point has one at
%   the mirrored parameter, and the surface unrolls the same way both ways.

mirrored_half(Facets, Seam, Shape, _) :-
    Shape = shape(Surface, _, Nodes),
    Surface \= ruled(_, _, _, _, _, _),
    facet_keys(Facets, Keys),
    findall(T-H,
            ( member(Key, Keys),
              key_place(Nodes, Key, T, H),
              T \== any ),
            Places),
    findall(Bin-(T-H),
            ( member(T-H, Places),
              Bin is round(T*10.0) ),
            Bins),
    keysort(Bins, SortedBins),
    group_pairs_by_key(SortedBins, Groups),
    list_to_assoc(Groups, Table),
    Twice is 2.0*(Seam+180.0),
    \+ ( member(T-H, Places),
         \+ has_image(Table, Twice, T, H) ),
    mirrors_surface(Surface, Seam, Twice, Places).

has_image(Table, Twice, T, H) :-
    Image is Twice - T,
    Middle is round(Image*10.0),
    From is Middle-1,
    To is Middle+1,
    between(From, To, Bin),
    get_assoc(Bin, Table, Places),
    member(T2-H2, Places),
    same_angle(T2, Image),
    is_on_surface(H2-H, 1.0),
    !.

mirrors_surface(Surface, Seam, Twice, Places) :-
    Roll = roll(Surface, 0.0, Seam),
    findall(T2-H, ( member(T-H, Places), T2 is Twice-T ), Images),
    roll_points(Roll, Places, Points1),
    roll_points(Roll, Images, Points2),
    End is Seam + 360.0,
    roll_points(Roll, [Seam-0.0,End-0.0], [P,Q]),
    pairs_keys_values(Pairs, Points1, Points2),
    corner([P,Q|Points1], _, _, Size),
    tolerance(place, Of),
    Off is Of*Size,
    rolled_form(Surface, Kind),
    \+ ( member(A-B, Pairs),
         \+ mirrors(Kind, P, Q, A, B, Off) ).

%   Of a cylinder x and y, of a cone distances from the apex and to the sides.

mirrors(cylinder, X1-_, X2-_, AX-AY, BX-BY, Off) :-
    abs(AX-X1 - (X2-BX)) < Off,
    abs(AY-BY) < Off.
mirrors(cone, P, Q, A, B, Off) :-
    apart(0.0-0.0, A, R1),
    apart(0.0-0.0, B, R2),
    abs(R1-R2) < Off,
    apart(P, A, D1),
    apart(Q, B, D2),
    abs(D1-D2) < Off.

far(point(X1,Y1,Z1), point(X2,Y2,Z2), D) :-
    D is sqrt((X1-X2)**2 + (Y1-Y2)**2 + (Z1-Z2)**2).

apart(X1-Y1, X2-Y2, D) :-
    D is sqrt((X1-X2)**2 + (Y1-Y2)**2).
