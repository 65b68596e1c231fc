:- module(sg_true_sphere,
          [ sphere_part/2,              % +T, -Part
            sphere_part_polygon/3,      % +T, +Part, ?P
            sphere_development/4        % +T, +Part, +Options, -D
          ]).
:- use_module('../csg/placed_surface',
              [kept_answer/4, placed_face/3, placed_polygon/4]).
:- use_module('../near',
              [is_rounding/2, same_angle/2, same_direction/2, whole_turns/2]).
:- use_module('../store',
              [e/5, from_p/5, origin/3, p/3, v/5, facts_transaction/1]).
:- use_module(sphere_facet, [round_sphere/3, sphere_cut/2]).
:- use_module(true_join, [facets_joined/2]).
:- use_module(true_patch,
              [ borders_kept/5, gore_place/5, sphere_place/4, sphere_radius/2,
                zone_place/5
              ]).
:- use_module(true_pattern, [pattern_written/3]).
:- use_module(true_plate, [plate_layer/2]).
:- use_module(true_seam, [farthest_from/3, shortest_generators/2]).
:- use_module(true_surface, [meeting_surfaces/4]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply),
              [foldl/4, foldl/5, foldl/6, maplist/3, maplist/4]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists),
              [append/2, max_list/2, member/2, min_list/2, sum_list/2]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Spheres in gores and zones.

A sphere does not unroll. What is cut for it, to be bent or pressed into shape,
keeps some of its lengths:

  - a *gore*, between two meridians, those of its middle meridian and of all
    parallels: the point at the longitude T from the middle one and the latitude
    S lies at x = R*(S+90), y = R*T*cos(S), angles in radians. So it has the
    area that it has on the sphere.
  - a *zone*, between two parallels, is the cone, or cylinder, through both of
    them, and unrolls.

R is that of the neutral layer of the plate; zones meet in mitres, so of a layer
L farther out it is R + L/cos(half the latitude of a zone).

A place is place(T, S, Border), degrees, of the sphere that was made for it
(sphere_facet.pl): T from the seam. A *patch* is one gore or zone: gore(I) or
zone(S1, S2, G).

Source: ours; the gore is the sinusoidal projection of geographers.
*/

%!  sphere_part(+T, -Part) is nondet.
%
%   Part of segment T, or Leaf/Name in what was made of leaves, is of a sphere
%   that was made in the facets of gores or zones.

sphere_part(T, Part) :-
    findall(Part0, sphere_facet(T, Part0, _, _, _), Parts0),
    sort(Parts0, Parts),
    member(Part, Parts).

%!  sphere_part_polygon(+T, +Part, ?P) is nondet.
%
%   P is a polygon of that Part.

sphere_part_polygon(T, Part, P) :-
    sphere_facet(T, Part, P, _, _).

%   sphere_facet(T, Part, P, T1-T2, S1-S2) is nondet.

sphere_facet(T, Part, P, Ts, Ss) :-
    kept_answer(sg_true_sphere:found_facet, T, Part, facet(P, Ts, Ss)).

:- public found_facet/3.

found_facet(T, Part, facet(P, Ts, Ss)) :-
    (   once(from_p(T, _, _, _, _))
    ->  placed_polygon(T, P, Leaf, P0),
        Part = Leaf/Name
    ;   p(T, P, _),
        Leaf-P0 = T-P,
        Part = Name
    ),
    placed_face(Leaf, P0, curved(Name, [Ts,Ss])),
    origin(Leaf, node(Leaf), plate(_)),
    once(round_sphere(Leaf, Name, _)).

part_leaf(T, Part, Leaf, Name) :-
    (   Part = Leaf0/Name0
    ->  Leaf-Name = Leaf0-Name0
    ;   Leaf-Name = T-Part
    ).

%!  sphere_development(+T, +Part, +Options, -D) is det.
%
%   D is a new segment of kind `pattern`, true_development(T, Part): Part of
%   segment T in gores or zones, seen from outside, each a piece. Options:
%   gores(N), zones(N) as sphere_cut/2 has them, generators(N): so many parts of
%   the middle meridian of the first gore, 12 by default, and those of
%   plate_layer/2.

sphere_development(T, Part, Options, D) :-
    part_leaf(T, Part, Leaf, Name),
    sphere_cut(Options, Cut),
    once(round_sphere(Leaf, Name, Surface)),
    plate_layer(Options, Layer),
    findall(facet(P, Ts, Ss, Es),
            ( sphere_facet(T, Part, P, Ts, Ss), p(T, P, Es) ),
            Facets0),
    sort(Facets0, Facets),
    meetings(T, Leaf, Facets, Meets),
    patches(Facets, Cut, Patches0),
    maplist(patch_opened(T, Surface, Options), Patches0, Patches),
    lowest(Leaf, Low),
    maplist(patch_laid(T, sphere(Surface, Layer, Low), Meets), Patches,
            Facetss, Pointss),
    apart(Pointss, Surface, Pairs),
    list_to_assoc(Pairs, Points),
    append(Facetss, Laid),
    sort(1, @=<, Laid, Sorted),
    list_to_assoc([], Curves),
    marks(Cut, Options, Surface-Layer, Low, Facetss, Pointss, Marks),
    facts_transaction(
        pattern_written(true_development(T, Part),
                        pattern(T, smooth, Sorted, Points, Curves, Marks),
                        D)).

meetings(T, Leaf, Facets, Meets) :-
    findall(V,
            ( member(facet(_, _, _, Es), Facets),
              member(E, Es),
              e(T, E, V, _, _) ),
            Vs0),
    sort(Vs0, Vs),
    meeting_surfaces(T, Leaf, Vs, Meets).

%   patches(Facets, Cut, Patches): Patch-Facets for each, in order.

patches(Facets, Cut, Patches) :-
    findall(Patch-Facet,
            ( member(Facet, Facets), facet_patch(Cut, Facet, Patch) ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Patches).

facet_patch(gores(N), facet(_, T1-T2, _, _), gore(I, Step)) :-
    Step is 360.0/N,
    I is floor((T1+T2)/2.0/Step).
facet_patch(zones(_), facet(_, _, S1-S2, _), zone(S1, S2, 0.0)).

%   patch_opened(T, Surface, Options, Patch0, Patch): if nobody says where, a
%   zone is cut open at the longitude G that no hole interrupts and is farthest
%   from all. It is then zone(S1, S2, G), and its facets begin there.

patch_opened(T, Surface, Options, zone(S1,S2,_)-Facets0,
             zone(S1,S2,G)-Facets) :-
    \+ option(seam(_), Options),
    zone_vertices(T, Surface, Facets0, Vertices),
    findall(Degrees,
            ( member(at(_,Degrees,S), Vertices),
              \+ same_angle(S, S1),
              \+ same_angle(S, S2) ),
            Holes),
    Holes = [_|_],
    !,
    findall(length(1,Length)-T1,
            ( member(facet(_, T1-_, _, _), Facets0),
              meridian_left(T, Facets0, Vertices, T1, S2-S1, Length) ),
            Candidates0),
    sort(2, @<, Candidates0, Candidates),
    shortest_generators(Candidates, Gs),
    farthest_from(Holes, Gs, G),
    maplist(facet_after(G), Facets0, Facets).
patch_opened(_, _, _, Patch, Patch).

%   zone_vertices(T, Surface, Facets, Vertices): at(V, Degrees, S).

zone_vertices(T, Surface, Facets, Vertices) :-
    findall(at(V,Degrees,S),
            ( member(facet(_, _, _, Es), Facets),
              member(E, Es),
              e(T, E, V, _, _),
              v(T, V, X, Y, Z),
              sphere_place(Surface, point(X,Y,Z), Degrees, S) ),
            Vertices0),
    sort(Vertices0, Vertices).

%   meridian_left(T, Facets, Vertices, Degrees, Whole, Lost): how much is cut
%   out of the meridian that facets of a zone, Whole high, begin at.

meridian_left(T, Facets, Vertices, Degrees, High-Low, Lost) :-
    findall(S, ( member(at(_,D,S), Vertices), same_direction(D, Degrees) ),
            Ss),
    aggregate_all(sum(Part),
                  ( member(facet(_, T1-_, _, Es), Facets),
                    same_direction(T1, Degrees),
                    member(E, Es),
                    e(T, E, A, B, _),
                    on_meridian(Vertices, Degrees, A, S1),
                    on_meridian(Vertices, Degrees, B, S2),
                    Part is abs(S2-S1) ),
                  Left),
    Ss = [_|_],
    Lost0 is High-Low-Left,
    (   same_angle(Lost0, 0.0)          % rounding is not to decide
    ->  Lost = 0.0
    ;   Lost = Lost0
    ).

on_meridian(Vertices, Degrees, V, S) :-
    memberchk(at(V,D,S), Vertices),
    (   same_direction(D, Degrees)
    ->  true
    ;   same_angle(abs(S), 90.0)        % a pole
    ).

facet_after(G, facet(P,T1-T2,Ss,Es), Facet) :-
    (   (T1+T2)/2.0 < G
    ->  U1 is T1+360.0,
        U2 is T2+360.0,
        Facet = facet(P,U1-U2,Ss,Es)
    ;   Facet = facet(P,T1-T2,Ss,Es)
    ).


                /*******************************
                *            PLACES            *
                *******************************/

%   patch_laid(T, Sphere, Meets, Patch-Facets, Laid, Points): Laid are its
%   connected parts as facets of true_shape.pl, Points Key-(X-Y), seen from
%   outside.

patch_laid(T, sphere(Surface, Layer, Low), Meets, Patch-Facets0, Laid,
           Points) :-
    patch_roll(Patch, Surface, Layer-Low, Roll),
    maplist(facet_keyed(T, Patch, Roll, Meets), Facets0, Facets, Placess),
    append(Placess, Places0),
    sort(1, @<, Places0, Places),
    findall(Key-Point,
            ( member(Key-Place, Places), rolled(Roll, Place, Point) ),
            Points0),
    facets_joined(Facets, Laid0),
    borders_kept(Places, Points0, Meets, Laid0, Laid),
    seen_from_outside(Facets, Points0, Points).

%   Roll is how a patch is laid: gore(Surface, R-Low, Middle-Half), x from the
%   latitude Low; or cone(Surface, Flip, R1-R2, Length, G), Surface the cone
%   through its circles, its radii there and how far apart they are, G where it
%   is cut open; Flip says that h = 0 is the upper one.

patch_roll(gore(I, Step), Surface, Layer-Low,
           gore(Surface, R-Low, Middle-Half)) :-
    sphere_radius(Surface, R0),
    R is R0+Layer,
    Half is Step/2.0,
    Middle is (I+0.5)*Step.
patch_roll(zone(S1, S2, G), Surface, Layer-_,
           cone(Cone, Flip, R1-R2, Length, G)) :-
    sphere_radius(Surface, R0),
    Angle is (S2-S1)*pi/360.0,
    R is R0 + Layer/cos(Angle),
    level_radius(S1, Part1),
    level_radius(S2, Part2),
    (   Part1 < Part2,
        \+ is_rounding(Part1-Part2, 1.0)
    ->  Flip = true,
        cone_between(Surface, S2, S1, Cone)
    ;   Flip = false,
        cone_between(Surface, S1, S2, Cone)
    ),
    R1 is R*Part1,
    R2 is R*Part2,
    Length is 2.0*R*sin(Angle).

level_radius(S, Part) :-
    (   same_angle(abs(S), 90.0)
    ->  Part = 0.0
    ;   Part is cos(S*pi/180.0)
    ).

%   cone_between(Sphere, S1, S2, Cone): through the parallels at S1, the larger
%   one, and S2.

cone_between(sphere(point(X0,Y0,Z0), U0, V0, W0), S1, S2, Cone) :-
    level_radius(S1, Part1),
    level_radius(S2, Part2),
    Low is sin(S1*pi/180.0),
    High is sin(S2*pi/180.0),
    Up is High-Low,
    scaled(Low, W0, vector(A,B,C)),
    X is X0+A,
    Y is Y0+B,
    Z is Z0+C,
    scaled(Part1, U0, U),
    scaled(Part1, V0, V),
    scaled(Up, W0, W),
    (   is_rounding(Part1-Part2, 1.0)
    ->  Cone = cylinder(point(X,Y,Z), U, V, W)
    ;   K is Part2/Part1,
        Cone = cone(point(X,Y,Z), U, V, W, K)
    ).

scaled(F, vector(A0,B0,C0), vector(A,B,C)) :-
    A is F*A0,
    B is F*B0,
    C is F*C0.

%   facet_keyed(T, Patch, Roll, Meets, Facet0, Facet, Places): Places are
%   Key-place(...) of its corners.

facet_keyed(T, Patch, Roll, Meets, facet(P, Ts, Ss, Es),
            facet(P, T1, T2, Halves), Places) :-
    Ts = T1-T2,
    maplist(half_keyed(T, Patch, Roll, Meets, Ts-Ss), Es, Halves, Places).

half_keyed(T, Patch, Roll, Meets, Between, E, half(K1, K2, edge(E)),
           K1-Place) :-
    e(T, E, A, B, _),
    vertex_key(T, Patch, Roll, Meets, Between, A, K1, Place),
    vertex_key(T, Patch, Roll, Meets, Between, B, K2, _).

vertex_key(T, gore(I, _), Roll, Meets, _, V, k(V, I), Place) :-
    gore_place(T, Roll, Meets, V, Place).
vertex_key(T, zone(S1, _, _), Roll, Meets, (T1-T2)-_, V, k(V, S1/Turn),
           place(Degrees, H, Border)) :-
    zone_place(T, Roll, Meets, V, place(Degrees0, H, Border)),
    (   Degrees0 == any
    ->  Turn = apex,
        Degrees = 0.0
    ;   whole_turns(Degrees0, By),
        Canonical is Degrees0-By,
        Turn is round(((T1+T2)/2.0 - Canonical)/360.0),
        Degrees is Canonical + 360.0*Turn
    ).


                /*******************************
                *            LAYING            *
                *******************************/

%   rolled(Roll, Place, Point): X east and Y north of a zone; a gore lies on its
%   side, north to the right.

rolled(gore(_, R-Low, _), place(Degrees, S, _), X-Y) :-
    X is R*(S-Low)*pi/180.0,
    level_radius(S, Part),
    Y is -R*Degrees*pi/180.0*Part.
rolled(cone(_, _, R1-R2, Length, G), place(Degrees, H, _), X-Y) :-
    Off is R2-R1,
    Up is H*Length,
    (   is_rounding(Off, max(R1, R2))
    ->  X is R1*Degrees*pi/180.0,
        Y = Up
    ;   Far is abs(R1 + H*Off)*Length/abs(Off),
        Angle is (Degrees-180.0-G)*pi/180.0*abs(Off)/Length,
        X is Far*sin(Angle),
        (   Off < 0.0
        ->  Y is -Far*cos(Angle)
        ;   Y is Far*cos(Angle)
        )
    ).

%   seen_from_outside(Facets, Points0, Points): mirrored, if facets run
%   clockwise: in a hollow, or if the sphere was mirrored.

seen_from_outside(Facets, Points0, Points) :-
    list_to_assoc(Points0, Table),
    findall(Area,
            ( member(facet(_, _, _, Halves), Facets),
              member(half(A, B, _), Halves),
              get_assoc(A, Table, X1-Y1),
              get_assoc(B, Table, X2-Y2),
              Area is X1*Y2 - X2*Y1 ),
            Areas),
    sum_list(Areas, Sum),
    (   Sum < 0.0
    ->  findall(Key-(X-Y), ( member(Key-(X-Y0), Points0), Y is -Y0 ), Points)
    ;   Points = Points0
    ).

%   apart(Pointss, Surface, Points): one patch above the other; a gore stays
%   where it is along its meridian, zones begin at 0.

apart(Pointss, Surface, Points) :-
    sphere_radius(Surface, R),
    Gap is R/20.0,
    Unit is 2.0**(ceiling(log(R)/log(2.0)) - 44),
    foldl(moved_up(Gap, Unit), Pointss, Lists, 0.0, _),
    append(Lists, Points0),
    keysort(Points0, Points).

moved_up(Gap, Unit, Points0, Points, Y0, Y1) :-
    Points0 = [Key0-_|_],
    (   Key0 = k(_, I),
        integer(I)
    ->  Left = 0.0
    ;   findall(X, member(_-(X-_), Points0), Xs),
        min_list(Xs, Left)
    ),
    least_y(Points0, Low),
    findall(Y, member(_-(_-Y), Points0), Ys),
    max_list(Ys, High),
    findall(Key-(X-Y),
            ( member(Key-(X0-Y2), Points0),
              X is round((X0-Left)/Unit)*Unit,
              Y is round((Y2-Low+Y0)/Unit)*Unit ),
            Points),
    Y1 is Y0 + High - Low + Gap.


                /*******************************
                *            MARKS             *
                *******************************/

%   marks(Cut, Options, Surface-Layer, Low, Facetss, Pointss, Marks): of the
%   first gore, across its middle meridian, in equal steps from pole to pole, or
%   from the rim of a hemisphere, at the latitude Low. Marks are as
%   true_layout.pl has them: Degrees is the latitude, Position where it is along
%   the middle meridian, From and To are from there.

marks(zones(_), _, _, _, _, _, []).
marks(gores(M), Options, Surface-Layer, Low, [Facets|_], [Points|_], Marks) :-
    option(generators(N), Options, 12),
    sphere_radius(Surface, R0),
    R is R0+Layer,
    Half is 180.0/M,
    list_to_assoc(Points, Table),
    findall(P-Q,
            ( member(facet(_, _, _, Halves), Facets),
              member(half(A, B, _), Halves),
              get_assoc(A, Table, P),
              get_assoc(B, Table, Q) ),
            Sides),
    least_y(Points, Least),
    findall(mark(Number, S, X, From, To, X-Y1, X-Y2),
            ( between(0, N, J),
              Number is J+1,
              S is Low + (90.0-Low)*J/N,
              X is R*(S-Low)*pi/180.0,
              spans(Sides, gore(R,Low,Half), X, Spans),
              member(From-To, Spans),
              \+ is_rounding(To-From, R),
              Y1 is From-Least,
              Y2 is To-Least ),
            Marks).

least_y(Points, Least) :-
    findall(Y, member(_-(_-Y), Points), Ys),
    min_list(Ys, Least).

%   spans(Sides, Gore, X, Spans): where the upright line at X is within them. A
%   side along the meridian that bounds Gore stands for that, and not for a
%   chord of it.

spans(Sides, Gore, X, Spans) :-
    findall(Y,
            ( member(P-Q, Sides),
              side_crossed(P, Q, Gore, X, Y) ),
            Ys0),
    msort(Ys0, Ys),
    paired(Ys, Spans).

side_crossed(P, Q, Gore, X, Y) :-
    P = X1-Y1,
    Q = X2-Y2,
    (   X1 =< X
    ->  X2 > X
    ;   X2 =< X
    ),
    (   meridian_at(Gore, P, Y1),
        meridian_at(Gore, Q, Y2)
    ->  meridian_y(Gore, X, Y0),
        Y is copysign(Y0, Y1+Y2)
    ;   Y is Y1 + (Y2-Y1)*(X-X1)/(X2-X1)
    ).

%   meridian_y(gore(R, Low, Half), X, Y): Y above the middle is where the
%   meridian Half degrees from it lies at X.

meridian_y(gore(R,Low,Half), X, Y) :-
    S is Low + X*180.0/(R*pi),
    level_radius(S, Part),
    Y is R*Half*pi/180.0*Part.

meridian_at(Gore, X-_, Y) :-
    meridian_y(Gore, X, Y0),
    arg(1, Gore, R),
    is_rounding(abs(Y)-Y0, R).

paired([], []).
paired([From,To|Ys], [From-To|Spans]) :-
    paired(Ys, Spans).

%   lowest(Leaf, Low): the latitude of its lowest parallel.

lowest(Leaf, Low) :-
    findall(S, placed_face(Leaf, _, curved(_, [_,S-_])), Ss),
    min_list(Ss, Low).
