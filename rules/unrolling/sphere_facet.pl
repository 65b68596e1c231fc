:- module(sg_sphere_facet,
          [ sphere_cut/2,               % +Options, -Cut
            round_sphere/3,             % +S, ?Part, -Surface
            has_sphere/1,               % +S
            sphere_grid/3,              % +S, +Options, -Grid
            grid_term/3,                % +Grid, +Sphere, -Term
            sphere_faces_known/3        % +S, +S1, -Pairs
          ]).
:- use_module('../csg/placed_surface', [placed_face/3, placed_surface/3]).
:- use_module('../near', [is_rounding/2, whole_turns/2]).
:- use_module('../solid/csg_flat', [flat_expression/2, flat_leaves/2]).
:- use_module('../csg/csg', [is_node/1]).
:- use_module('../vector', [dot_product/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [member/2]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> The facets in which a sphere is cut for its gores or zones.

A sphere does not unroll: plate is cut to *gores*, between meridians, or to
*zones*, between parallels, and each of these is laid flat (true_sphere.pl). So
the sphere is made again (true_parts.pl) with facets whose borders are theirs.
*/

%!  sphere_cut(+Options, -Cut) is det.
%
%   Cut is gores(N) or zones(N), how Options have it: gores(12) by default.

sphere_cut(Options, Cut) :-
    (   option(zones(N), Options)
    ->  Cut = zones(N)
    ;   option(gores(N), Options, 12),
        Cut = gores(N)
    ).

%!  round_sphere(+S, ?Part, -Surface) is nondet.
%
%   Part of the primitive S, or of a copy, stands for a sphere, and for no
%   ellipsoid.

round_sphere(S, Part, Surface) :-
    placed_surface(S, Part, Surface),
    Surface = sphere(_, U, V, W),
    dot_product(U, U, Square),
    \+ ( member(A-B, [V-V,W-W]),
         dot_product(A, B, Other),
         \+ is_rounding(Other-Square, Square) ),
    \+ ( member(A-B, [U-V,U-W,V-W]),
         dot_product(A, B, Product),
         \+ is_rounding(Product, Square) ).

%!  has_sphere(+S) is semidet.
%
%   Segment S is a sphere, or the result of a CSG tree with a sphere among its
%   leaves.

has_sphere(S) :-
    (   round_sphere(S, _, _)
    ->  true
    ;   is_node(S),
        flat_expression(S, Expression),
        flat_leaves(Expression, Leaves),
        member(Leaf, Leaves),
        round_sphere(Leaf, _, _)
    ->  true
    ).

%!  sphere_grid(+S, +Options, -Grid) is det.
%
%   Grid is grid(Facets, Bands, Turn): of what facets the sphere S is made, and
%   by how many degrees it is turned about its axis first. If it is `cut`
%   (cut(true)), all are fine; else those alone that go along a gore or zone.

sphere_grid(S, Options, grid(Facets, Bands, Turn)) :-
    sphere_cut(Options, Cut),
    option(seam(Turn), Options, 0),
    fine_count(S, Options, Fine),
    grid_counts(Cut, Options, S, Fine, Facets, Bands).

grid_counts(gores(N), Options, S, Fine, Facets, Bands) :-
    (   option(cut(true), Options)
    ->  Facets is N*ceiling(Fine/N)
    ;   Facets is N*ceiling(60/N)
    ),
    half_turn_part(S, Part),
    Bands is max(2, ceiling(Fine*Part/2)).
grid_counts(zones(N), _, _, Fine, Fine, N).

%   half_turn_part(S, Part): of a sphere the bands go over half a turn, of a
%   hemisphere over a quarter.

half_turn_part(S, Part) :-
    (   placed_face(S, _, base)
    ->  Part = 0.5
    ;   Part = 1.0
    ).

%   fine_count(S, Options, N): so many facets round are within the chord
%   tolerance of the sphere, a two-thousandth of its radius by default.

fine_count(S, Options, N) :-
    once(round_sphere(S, _, sphere(_, U, _, _))),
    dot_product(U, U, Square),
    R is sqrt(Square),
    Usual is 5.0e-4*R,
    option(chord(Chord0), Options, Usual),
    Chord is min(R/20.0, max(R/100000.0, Chord0)),
    N is 4*ceiling(pi/acos(1.0 - Chord/R)/4).

%!  grid_term(+Grid, +Sphere, -Term) is det.
%
%   Term is the primitive Sphere in the facets of Grid.

grid_term(grid(Facets, Bands, Turn), Sphere0, Term) :-
    Sphere0 =.. [Name|Arguments0],
    findall(Argument,
            ( member(Argument, Arguments0),
              functor(Argument, Of, _),
              \+ memberchk(Of, [facets,tolerance,bands]) ),
            Arguments),
    Sphere =.. [Name,facets(Facets),bands(Bands)|Arguments],
    (   Turn =:= 0
    ->  Term = Sphere
    ;   Term = at([rotate(z, Turn)], Sphere)
    ).

%!  sphere_faces_known(+S, +S1, -Pairs) is det.
%
%   Pairs are P1-P: polygon P1 of the sphere S1, made of the sphere S in other
%   facets (and another size), stands for polygon P of S.

sphere_faces_known(S, S1, Pairs) :-
    round_sphere(S, Part, sphere(_, U, V, _)),
    round_sphere(S1, Part, sphere(_, U1, _, _)),
    dot_product(U1, U, X),
    dot_product(U1, V, Y),
    Turn is atan2(Y, X)*180.0/pi,
    findall(at(Degrees, Lat)-P1,
            ( placed_face(S1, P1, curved(Part, [A-B,C-D])),
              Degrees0 is (A+B)/2.0 + Turn,
              whole_turns(Degrees0, By),
              Degrees is Degrees0 - By,
              Lat is (C+D)/2.0 ),
            Fine),
    findall(column(A, B)-band(C, D, P),
            placed_face(S, P, curved(Part, [A-B,C-D])),
            Drawn0),
    keysort(Drawn0, Drawn1),
    group_pairs_by_key(Drawn1, Drawn),
    maplist(drawn_at(Drawn), Fine, Pairs).

drawn_at(Drawn, at(Degrees, Lat)-P1, P1-P) :-
    (   member(column(A, B)-Bands, Drawn),
        Degrees >= A,
        Degrees =< B
    ->  true
    ;   Drawn = [_-Bands|_]
    ),
    (   member(band(C, D, P), Bands),
        Lat >= C,
        Lat =< D
    ->  true
    ;   Bands = [band(_, _, P)|_]
    ).
