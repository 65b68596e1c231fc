:- module(sg_true_development,
          [ true_development/4,         % +S, ?Part, +Options, -D
            developable_part/3          % ?S, ?Part, -Surface
          ]).
:- use_module('../near',
              [before_angle/2, between_angles/3, longer/2, same_part/2]).
:- use_module('../development/bend', [pattern_bent/2]).
:- use_module('../store', [segment/3, facts_transaction/1]).
:- use_module('../csg/placed_surface', [asked_once/1, placed_surface/3]).
:- use_module('../primitive/primitive_face', [surface_point/4]).
:- use_module(true_coincident, [lines_settled/4]).
:- use_module(true_composed, [composed_unrolled/4]).
:- use_module('../solid/trimmed', [part_named/4]).
:- use_module(true_apex, [apex_opened/5]).
:- use_module(true_border, [rims_kept/4]).
:- use_module(true_divide,
              [facet_divided/7, facet_index/2, generator_spans/5]).
:- use_module(true_layout,
              [ layout/6, layout_points/2, layout_curves/2, layout_marks/6,
                mirrored_half/4
              ]).
:- use_module(true_parts, [facets_as_drawn/4]).
:- use_module(true_pattern, [pattern_written/3]).
:- use_module(true_plate, [plate_layer/2]).
:- use_module(true_seam,
              [farthest_from/3, hole_places/2, shortest_generators/2]).
:- use_module(true_shape,
              [ true_part/5, part_facets/4, facet_middle/2, facets_sense/3,
                shifted_facet/3
              ]).
:- use_module(true_spike, [spikes_cut/3]).
:- use_module(true_sweep, [facets_swept/6]).
:- use_module(true_tip, [tips_moved/4]).
:- use_module(true_touch, [touches_told/4]).
:- use_module(library(apply), [foldl/4, foldl/5, foldl/6, maplist/3]).
:- use_module(library(assoc), [assoc_to_values/2]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(lists),
              [append/2, max_list/2, member/2, min_list/2, nth0/3, nth1/3,
               sum_list/2]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(ordsets), [ord_memberchk/2]).
:- use_module(library(pairs), [pairs_keys/2]).
/** <module> True developments: what a plate of a cylinder or cone is cut to.

Facets unroll to chords: a cylinder of 24 facets comes out 0.3 % too narrow. The
development of the surface they stand for has its true lengths; its facets stay
as they are numbered, and lie between their generators. Every vertex goes where
the true surface unrolls to, those of penetration lines to the line of the true
surfaces (true_shape.pl), and rims and lines are curves: polylines within a
chord tolerance.

@see docs/true_lengths.md; rows DV-2, PL-10
*/

%!  developable_part(?S, ?Part, -Surface) is nondet.
%
%   Part of segment S has a true development: it has facets of Surface, a
%   cylinder, a cone, what is `ruled` between two ellipses, a `transition`, or
%   what is `parallel` to a cylinder or cone.
%   In a segment that was made of primitives, as by trimming, Part is Leaf/Name:
%   the part Name of segment Leaf.

developable_part(S, Part, Surface) :-
    (   integer(S)
    ->  once(segment(S, _, _))
    ;   segment(S, _, _)
    ),
    true_part(S, Part, Leaf, Name, Surface),
    functor(Surface, Kind, _),
    memberchk(Kind, [cylinder, cone, ruled, transition, parallel]),
    \+ ( placed_surface(Leaf, _, transition(pieces(Places))),
         memberchk(piece(Name, _, _, _), Places)
       ).

%!  true_development(+S, ?Part, +Options, -D) is det.
%
%   D is a new segment of kind `pattern`, with the term true_development(S,
%   Part): Part of segment S unrolled (the first part, if Part is free), seen
%   from outside, in place of the one there was. Polygons and edges keep their
%   ids; what is divided gets new ones, with from_p/5 and origin(D, e(E),
%   e(E0)). from_v/4 names the vertex that one was; one on the seam has two
%   copies. joint/6 says `fold` between facets (at 0 degrees: the plate is
%   smooth there), `seam` and `line` as in other patterns. Options:
%
%     - seam(Degrees)
%       The generator at which it is cut open; without it the shortest (of
%       those between facets that no hole interrupts, if there are such, and of
%       equal ones the farthest from holes), and if the part does not go round,
%       none.
%     - half(true)
%       Only the half from the seam on, if the other one is its mirror image.
%     - generators(N)
%       Generators in N equal steps of the parameter, numbered from the seam;
%       without it those between facets. See true_table.pl.
%     - chord(Tolerance)
%       How far rims and lines may be from the true curves: 1.0e-4 of the size,
%       not less than 1.0e-7 of it.
%     - thickness(T), size(Which), k_factor(K), ...
%       Of what plate it is made: true_plate.pl.
%
%   A transition is no surface that unrolls. It is laid out as its facets are,
%   by the true lengths of their sides: the finer the facets, the smaller the
%   difference.
%
%   @error existence_error(segment, S)
%   @error geometry_error(true(What)): no_part(S, Part); moved(S, Part);
%   nothing_left(S, Part), of the true surface; not_symmetric(S, Part), of
%   half(true); flat_part(S, Part, Option), an option that a transition cannot
%   have; no_offset(Kind), true_plate.pl

true_development(S, Part, Options, D) :-
    must_be(positive_integer, S),
    must_be(list, Options),
    must_be(ground, Options),
    (   segment(S, _, _)
    ->  true
    ;   throw(error(existence_error(segment, S), _))
    ),
    (   developable_part(S, Part, _)
    ->  true
    ;   throw(error(geometry_error(true(no_part(S, Part))), _))
    ),
    asked_once(( unrolled(S, Part, Options, Pattern),
                 facts_transaction(
                     sg_true_development:developed(S, Part, Options, Pattern,
                                                   D)) )).

developed(S, Part, Options, Pattern, D) :-
    pattern_written(true_development(S, Part), Pattern, D),
    (   Pattern = pattern(_, creases(Creases), _, _, _, _),
        member(_-Degrees, Creases),
        Degrees =\= 0.0
    ->  option(thickness(T), Options, 0.0),
        option(k_factor(K), Options, 0.5),
        option(bend_radius(R), Options, T),
        pattern_bent(D, [thickness(T), size(neutral), k_factor(K),
                         bend_radius(R)])
    ;   true
    ).

%   unrolled(S, Part, Options, Pattern): Pattern is as true_pattern.pl has it.

unrolled(S, Part, Options, Pattern) :-
    true_part(S, Part, _, _, transition(_)),
    !,
    composed_unrolled(S, Part, Options, Pattern).
unrolled(S, Part, Options,
         pattern(S, Bends, Facets, Points, Curves, Marks)) :-
    part_facets(S, Part, Facets0, Shape0),
    Shape0 = shape(Surface, _, _),
    check_options(Shape0, S-Part, Options),
    (   is_flat(Shape0)
    ->  Bends = bent
    ;   Bends = smooth
    ),
    facets_sense(Facets0, Shape0, Sense),
    (   facets_swept(S, Part, Sense, Shape0, Facets2, Shape4)
    ->  true
    ;   touches_told(S, Part, Surface, Options),
        tips_moved(Facets0, Facets3, Shape0, Shape3),
        rims_kept(Facets3, Facets4, Shape3, Shape2),
        spikes_cut(Facets4, Shape2, Facets5),
        plate_layer(Options, Layer),
        apex_opened(Facets5, Layer, Facets6, Shape2, Shape5),
        facets_as_drawn(S, Facets6, Shape5, Facets7),
        lines_settled(Facets7, Facets2, Shape5, Shape4)
    ),
    (   Facets2 == []
    ->  throw(error(geometry_error(true(nothing_left(S, Part))), _))
    ;   true
    ),
    seam(Facets2, Shape4, Sense, Options, Seam, Around),
    opened(Facets2, S-Part, Seam, Sense, Facets1, Shape4, Shape1),
    half_of(Facets1, S-Part, Seam, Around, Sense, Options, Facets,
            Shape1, Shape),
    layout(Facets, Shape, Seam, Sense, Options, Layout),
    layout_points(Layout, Points),
    layout_curves(Layout, Curves),
    generators(Facets, Seam, Around, Options, Generators),
    layout_marks(Layout, Facets, Sense, Seam, Generators, Marks).

is_flat(shape(ruled(_, _, _, _, _, _), _, _)).

check_options(Shape, S-Part, Options) :-
    (   is_flat(Shape),
        (   option(thickness(T), Options),
            T =\= 0
        ->  Option = thickness
        ;   option(generators(_), Options)
        ->  Option = generators
        )
    ->  throw(error(geometry_error(true(flat_part(S, Part, Option))), _))
    ;   true
    ).


                /*******************************
                *             SEAM             *
                *******************************/

%   seam(Facets, Shape, Sense, Options, Seam, Around): Around is true if the
%   facets go all round; if not, the pattern starts after the gap.

seam(Facets, Shape, Sense, Options, Seam, Around) :-
    facet_starts(Facets, Starts),
    findall(Place,
            ( member(facet(_, _, T2, _), Facets), turn_place(T2, Place) ),
            Ends0),
    sort(Ends0, Ends),
    (   member(T, Starts),
        turn_place(T, Start),
        \+ ord_memberchk(Start, Ends)
    ->  Around = false
    ;   Around = true
    ),
    (   option(seam(Seam0), Options)
    ->  must_be(number, Seam0),
        Turns is floor(rational(Seam0)/360),
        Seam is float(rational(Seam0) - 360*Turns)
    ;   Around == false
    ->  Seam = T
    ;   shortest_generator(Facets, Starts, Shape, Sense, Seam)
    ).

facet_starts(Facets, Ts) :-
    findall(T, member(facet(_, T, _, _), Facets), Ts0),
    sort(Ts0, Ts).

%   turn_place(T, Place): the same for generators in one place.

turn_place(T, Place) :-
    Place is round(T*1.0e6) mod 360000000.

%   shortest_generator(Facets, Starts, Shape, Sense, Seam): of those that no
%   hole interrupts, if there are such; of equally short ones up to rounding
%   the one that is farthest from all holes, or the first.

shortest_generator(Facets, Starts, Shape, Sense, Seam) :-
    facet_index(Facets, Index),
    findall(length(Spans, Length)-T,
            ( member(T, Starts),
              generator_length(Index, T, Sense, Shape, Spans, Length) ),
            All),
    shortest_generators(All, Equal),
    hole_places(Shape, Holes),
    farthest_from(Holes, Equal, Seam).

generator_length(Index, T, Sense, Shape, Count, Length) :-
    Shape = shape(Surface, _, _),
    generator_spans(Index, T, Sense, Shape, Spans),
    length(Spans, Count),
    findall(Part, ( member(H1-H2, Spans), Part is H2-H1 ), Parts),
    sum_list(Parts, Sum),
    surface_point(Surface, T, 0.0, point(X1,Y1,Z1)),
    surface_point(Surface, T, 1.0, point(X2,Y2,Z2)),
    Length is Sum*sqrt((X1-X2)**2 + (Y1-Y2)**2 + (Z1-Z2)**2).


                /*******************************
                *           OPENING            *
                *******************************/

%   opened(Facets0, Name, Seam, Sense, Facets, Shape0, Shape): cut along the
%   generator of the seam, and all between Seam and Seam + 360.

opened(Facets0, Name, Seam, Sense, Facets, Shape0, Shape) :-
    foldl(cut_at(Name, seam, Seam, Sense), Facets0, Lists, 1-Shape0, _-Shape),
    append(Lists, Facets1),
    maplist(turned_to(Seam), Facets1, Facets).

%   cut_at(Name, Option, T0, Sense, Facet, Parts, N0-Shape0, N-Shape): Parts of
%   Facet on both sides of the generator at T0, or a turn or more from it.

cut_at(Name, Option, T0, Sense, Facet, Parts, N0-Shape0, N-Shape) :-
    Facet = facet(_, T1, T2, _),
    facet_middle(Facet, Middle),
    T is T0 + 360.0*round((Middle-T0)/360.0),
    (   \+ between_angles(T1, T, T2)
    ->  Parts = [Facet],
        Shape = Shape0,
        N = N0
    ;   is_flat(Shape0)
    ->  Name = S-Part,
        throw(error(geometry_error(true(flat_part(S, Part, Option))), _))
    ;   facet_divided(Facet, T, Sense, N0, Parts, Shape0, Shape),
        findall(Half,
                ( member(facet(_, _, _, Halves), Parts), member(Half, Halves) ),
                All),
        foldl(later_cut, All, N0, N)
    ).

later_cut(half(_, _, Label), N0, N) :-
    (   Label = cut(I)
    ->  N is max(N0, I+1)
    ;   N = N0
    ).

turned_to(Seam, Facet0, Facet) :-
    facet_middle(Facet0, Middle),
    Turns is -floor((Middle-Seam)/360.0),
    shifted_facet(Turns, Facet0, Facet).

%   half_of(Facets0, Name, Seam, Around, Sense, Options, Facets, Shape0, Shape)

half_of(Facets0, Name, Seam, Around, Sense, Options, Facets, Shape0, Shape) :-
    (   option(half(true), Options)
    ->  Middle is Seam + 180.0,
        (   Around == true,
            mirrored_half(Facets0, Seam, Shape0, Sense)
        ->  true
        ;   Name = S-Part,
            part_named(S, Part, Named, Shown),
            throw(error(geometry_error(true(not_symmetric(Named, Shown))), _))
        ),
        foldl(cut_at(Name, half, Middle, Sense), Facets0, Lists,
              1000000-Shape0, _-Shape),
        append(Lists, Facets1),
        findall(Facet,
                ( member(Facet, Facets1),
                  facet_middle(Facet, T),
                  T < Middle ),
                Facets)
    ;   Facets = Facets0,
        Shape = Shape0
    ).

%   generators(Facets, Seam, Around, Options, Generators): a list of
%   Number-Degrees, those of the pattern from left to right (by T). Both sides
%   of the seam have number 1.

generators(Facets, Seam, Around, Options, Generators) :-
    findall(T,
            ( member(facet(_, T1, T2, _), Facets),
              member(T, [T1,T2]) ),
            Ts0),
    apart(Ts0, Ts),
    max_list(Ts, Last),
    (   option(generators(N), Options)
    ->  must_be(positive_integer, N),
        findall(I-T,
                ( between(0, N, I0),
                  T is Seam + 360.0*I0/N,
                  \+ before_angle(Last, T),
                  generator_number(I0, N, Around, I) ),
                Generators)
    ;   length(Ts, Count),
        N is Count-1,
        findall(I-T,
                ( nth0(I0, Ts, T),
                  \+ before_angle(Last, T),
                  (   \+ before_angle(T, Seam + 360.0)
                  ->  generator_number(I0, N, Around, I)
                  ;   I is I0+1
                  ) ),
                Generators)
    ).

generator_number(I0, N, Around, I) :-
    (   I0 =:= N,
        Around == true
    ->  I = 1
    ;   I is I0+1
    ).

%   apart(Ts0, Ts): in order, each once up to rounding.

apart(Ts0, Ts) :-
    sort(Ts0, Ts1),
    apart_(Ts1, Ts).

apart_([A,B|Ts0], Ts) :-
    \+ before_angle(A, B),
    !,
    apart_([A|Ts0], Ts).
apart_([A|Ts0], [A|Ts]) :-
    apart_(Ts0, Ts).
apart_([], []).
