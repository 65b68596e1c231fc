:- module(sg_true_patch,
          [ sphere_radius/2,            % +Sphere, -R
            sphere_place/4,             % +Sphere, +Point, -Degrees, -S
            gore_place/5,               % +T, +Roll, +Meets, +V, -Place
            zone_place/5,               % +T, +Roll, +Meets, +V, -Place
            borders_kept/5              % +Places, +Points, +Meets, +Facets0,
                                        % -Facets
          ]).
:- use_module('../kernel', [surface_place/4, surfaces_meet/4]).
:- use_module('../near', [is_on_surface/2, is_rounding/2, same_angle/2]).
:- use_module('../store', [v/5]).
:- use_module(true_join, [outer_halves/2]).
:- use_module(true_surface, [generator_plane/3, level_plane/3]).
:- use_module(library(apply), [convlist/3, maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [max_list/2, member/2, min_list/2]).
/** <module> Outlines of gores and zones that go past a border.

The line where another part cuts a sphere truly lies beside that of the facets.
So it may go past the border of a gore or zone before it crosses that, or cross
it where several lines meet, with corners in one place. What is past the border
is in the next patch; here the line ends where it crosses the border.

A place is place(Degrees, S, Border) of a sphere (true_sphere.pl): Border is
on(Side), past(Side), or `none`. Facets are those of true_shape.pl.
*/

                /*******************************
                *            PLACES            *
                *******************************/

%!  sphere_radius(+Sphere, -R) is det.
%
%   R is the radius of the round Sphere.

sphere_radius(sphere(_, vector(A,B,C), _, _), R) :-
    R is sqrt(A*A + B*B + C*C).

%!  gore_place(+T, +Roll, +Meets, +V, -Place) is det.
%
%   Place is where vertex V of segment T lies in the gore Roll (true_sphere.pl):
%   Degrees from its middle, at the latitude S. Meets as meeting_surfaces/4 has
%   it.

gore_place(T, gore(Sphere, _, Middle-Half), Meets, V,
           place(Degrees, S, Border)) :-
    v(T, V, X, Y, Z),
    sphere_place(Sphere, point(X,Y,Z), Degrees0, S0),
    from_middle(Middle, Degrees0, From0),
    (   same_angle(abs(S0), 90.0)       % a pole
    ->  S = S0,
        Degrees = 0.0,
        Border = none
    ;   get_assoc(V, Meets, met([First|More], _))
    ->  gore_border(From0-Half, Sphere, Degrees0, More, Rest),
        met_point([Sphere,First|Rest], Sphere, point(X,Y,Z), Point),
        sphere_place(Sphere, Point, Degrees1, S),
        from_middle(Middle, Degrees1, From1),
        patch_place(From0-Half, From1, Degrees, Border)
    ;   S = S0,
        patch_place(From0-Half, From0, Degrees, Border)
    ).

%   gore_border(From-Half, Sphere, Degrees, More, Rest): Rest is what a vertex
%   stays on, besides Sphere and the first surface that cuts it: the border, or
%   the next one of More.

gore_border(From-Half, Sphere, Degrees, More, Rest) :-
    (   same_angle(abs(From), Half)
    ->  generator_plane(Sphere, Degrees, Plane),
        Rest = [Plane]
    ;   More = [Second|_]
    ->  Rest = [Second]
    ;   Rest = []
    ).

from_middle(Middle, Degrees, From) :-
    From is Degrees - Middle - 360.0*round((Degrees-Middle)/360.0).

met_point(Surfaces, Sphere, Point0, Point) :-
    sphere_radius(Sphere, R),
    Reach is R/10.0,
    (   surfaces_meet(Surfaces, Reach, Point0, Point1)
    ->  Point = Point1
    ;   Point = Point0
    ).

%!  sphere_place(+Sphere, +Point, -Degrees, -S) is det.
%
%   Degrees and S, longitude and latitude, are those of the direction of Point
%   from the centre of Sphere.

sphere_place(sphere(point(X0,Y0,Z0), U, V, W), point(X,Y,Z), Degrees, S) :-
    From = vector(X-X0, Y-Y0, Z-Z0),
    along(From, U, A),
    along(From, V, B),
    along(From, W, C),
    Degrees is atan2(B, A)*180.0/pi,
    S is atan2(C, sqrt(A*A + B*B))*180.0/pi.

along(vector(A,B,C), vector(D,E,F), Along) :-
    Along is A*D + B*E + C*F.

%!  zone_place(+T, +Roll, +Meets, +V, -Place) is det.
%
%   Place is where vertex V of segment T lies on the cone of the zone Roll: S
%   from 0 at the lower parallel to 1; Degrees is `any` at a pole.

zone_place(T, cone(Cone, Flip, _, _, _), Meets, V,
           place(Degrees, H, Border)) :-
    v(T, V, X, Y, Z),
    surface_place(Cone, point(X,Y,Z), Degrees0, H0),
    (   Cone = cone(_, _, _, _, K),
        K =:= 0.0,
        is_rounding(H0-1.0, 1.0)
    ->  Degrees = any,
        H1 = 1.0,
        Border = none
    ;   (   get_assoc(V, Meets, met([First|More], _))
        ->  zone_border(H0, Cone, More, Rest),
            met_on_cone([Cone,First|Rest], point(X,Y,Z), Point),
            surface_place(Cone, Point, Degrees, H2)
        ;   Degrees = Degrees0,
            H2 = H0
        ),
        patch_place((H0-0.5)-0.5, H2-0.5, Off, Border),
        H1 is Off+0.5
    ),
    (   Flip == true
    ->  H is 1.0-H1
    ;   H = H1
    ).

%   zone_border(H, Cone, More, Rest): as gore_border/5.

zone_border(H, Cone, More, Rest) :-
    (   member(Level, [0.0,1.0]),
        is_rounding(H-Level, 1000.0)
    ->  level_plane(Cone, Level, Plane),
        Rest = [Plane]
    ;   More = [Second|_]
    ->  Rest = [Second]
    ;   Rest = []
    ).

met_on_cone(Surfaces, Point0, Point) :-
    Surfaces = [Cone|_],
    arg(2, Cone, vector(A,B,C)),
    Reach is sqrt(A*A + B*B + C*C)/5.0,
    (   surfaces_meet(Surfaces, Reach, Point0, Point1)
    ->  Point = Point1
    ;   Point = Point0
    ).

%   patch_place(Off0-Most, Off1, Off, Border): a vertex of the line is Off1 from
%   the middle of a patch, of the facets' line Off0; the border is Most from
%   there, on both sides. It is laid at Off: on the border if it was there, and
%   a little before it if it is past that.

patch_place(Off0-Most, Off1, Off, Border) :-
    Far is abs(Off0),
    (   same_angle(Far, Most)
    ->  Side is sign(Off0),
        Border = on(Side),
        Off is max(-Most, min(Most, Off1))
    ;   abs(Off1) =< Most
    ->  Border = none,
        Off = Off1
    ;   Side is sign(Off1),
        Border = past(Side),
        Off is Side*(Most - 1.0e-3*abs(Most-Far))
    ).


                /*******************************
                *           OUTLINES           *
                *******************************/

%!  borders_kept(+Places, +Points, +Meets, +Facets0, -Facets) is det.
%
%   Facets are Facets0, with their lines only as far as the border, and as the
%   corner where another begins; corners that are in one place are one. No
%   half-edges that run both ways are left. Places are Key-Place, Points
%   Key-(X-Y).

borders_kept(Places, Points, Meets, Facets0, Facets) :-
    list_to_assoc(Places, Table),
    list_to_assoc(Points, Laid),
    spread(Points, Size),
    convlist(facet_kept(laid(Table, Laid, Size, Meets)), Facets0, Facets).

spread(Points, Size) :-
    findall(X, member(_-(X-_), Points), Xs),
    min_list(Xs, Low),
    max_list(Xs, High),
    Size is High-Low.

facet_kept(Laid, facet(P, T1, T2, Halves0), Facet) :-
    (   needless(Halves0, Laid, A, B)
    ->  maplist(half_from(A, B), Halves0, Halves1),
        findall(Half,
                ( member(Half, Halves1), Half = half(K1, K2, _), K1 \== K2 ),
                Halves2),
        outer_halves([facet(P, T1, T2, Halves2)], Halves),
        facet_kept(Laid, facet(P, T1, T2, Halves), Facet)
    ;   Halves0 \== [],
        Facet = facet(P, T1, T2, Halves0)
    ).

%   needless(Halves, Laid, A, B): key B stands for its neighbour A too: that is
%   past the border that B is on, or in the same place, or past B on a line or
%   border that runs back to it.

needless(Halves, laid(Table, Places, Size, Meets), A, B) :-
    member(half(K1, K2, _), Halves),
    get_assoc(K1, Table, place(_, _, Border1)),
    get_assoc(K2, Table, place(_, _, Border2)),
    (   Border1-Border2 = past(Side)-on(Side)
    ->  A-B = K1-K2
    ;   Border1-Border2 = on(Side)-past(Side)
    ->  A-B = K2-K1
    ;   get_assoc(K1, Places, X1-Y1),
        get_assoc(K2, Places, X2-Y2),
        (   is_on_surface(sqrt((X1-X2)**2 + (Y1-Y2)**2), Size)
        ->  rank(Border1, Rank1),
            rank(Border2, Rank2),
            (   Rank1-K1 @< Rank2-K2
            ->  A-B = K2-K1
            ;   A-B = K1-K2
            )
        ;   member(half(K0, K1, _), Halves),
            K0 \== K2,
            get_assoc(K0, Places, X0-Y0),
            turns_back(X1-Y1, X0-Y0, X2-Y2, Nearer),
            on_one_line(Table, Meets, K0, K1, K2)
        ->  ( Nearer == first -> B = K0 ; B = K2 ),
            A = K1
        )
    ),
    !.

%   on_one_line(Table, Meets, K0, K1, K2): all of them are on one border, or K1
%   on none and all on one other surface.

on_one_line(Table, Meets, K0, K1, K2) :-
    get_assoc(K1, Table, place(_, _, Border)),
    (   Border = on(_)
    ->  get_assoc(K0, Table, place(_, _, Border)),
        get_assoc(K2, Table, place(_, _, Border))
    ;   met_in(Meets, K1, Surface),
        met_in(Meets, K0, Surface),
        met_in(Meets, K2, Surface)
    ),
    !.

met_in(Meets, k(V, _), Surface) :-
    get_assoc(V, Meets, met(Surfaces, _)),
    member(Surface, Surfaces).

%   turns_back(P1, P0, P2, Nearer): from P0 to P1 and to P2 is there and back;
%   Nearer says which of them is nearer to P1, `first` or `last`.

turns_back(X1-Y1, X0-Y0, X2-Y2, Nearer) :-
    AX is X0-X1,
    AY is Y0-Y1,
    BX is X2-X1,
    BY is Y2-Y1,
    Along is AX*BX + AY*BY,
    Along > 0.0,
    abs(AX*BY - AY*BX) < 0.1*Along,
    (   AX*AX + AY*AY < BX*BX + BY*BY
    ->  Nearer = first
    ;   Nearer = last
    ).

%   rank(Border, Rank): what is on a border stays, as in the next patch.

rank(on(_), 0).
rank(past(_), 1).
rank(none, 1).

half_from(A, B, half(K1, K2, Label), half(L1, L2, Label)) :-
    key_from(A, B, K1, L1),
    key_from(A, B, K2, L2).

key_from(A, B, K0, K) :-
    (   K0 == A
    ->  K = B
    ;   K = K0
    ).
