:- module(sg_true_pieces,
          [ pieces_found/4,             % +S, +Part, -Leaf, -Pieces
            piece_facets/2,             % +Piece, -Facets
            place_of/3,                 % +Piece, +G, -T
            direction_of/3,             % +Piece, +T, -G
            composed_seam/5,            % +Pieces, +Borders, +Options, -Seam,
                                        % -Around
            on_border/2,                % +Borders, +G
            divided_at/3,               % +G, +Pieces0, -Pieces
            from_seam/3,                % +Pieces0, +Seam, -Pieces
            creases/3,                  % +Pieces, +Around, -Creases
            is_round/1                  % +Piece
          ]).
:- use_module('../near',
              [ tolerance/2, same_angle/2, between_angles/3, same_direction/2,
                whole_turns/2, longer/2
              ]).
:- use_module('../primitive/primitive_face', [surface_point/4]).
:- use_module('../vector', [cross_product/3, dot_product/3, scaled/3]).
:- use_module(true_border, [rims_kept/4]).
:- use_module(true_divide,
              [facet_divided/7, facet_index/2, generator_spans/5]).
:- use_module(true_parts, [facets_as_drawn/4]).
:- use_module(true_seam,
              [farthest_from/3, hole_places/2, shortest_generators/2]).
:- use_module(true_shape,
              [ facet_middle/2, facets_sense/3, piece_shape/6,
                pieces_facets/4, shifted_facet/3, true_part/5
              ]).
:- use_module(true_surface, [surface_normal_at/3]).
:- use_module(true_spike, [spikes_cut/3]).
:- use_module(true_tip, [tips_moved/4]).
:- use_module(library(apply), [foldl/5, foldl/6, maplist/3, maplist/4]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(lists), [append/2, append/3, member/2]).
:- use_module(library(option), [option/2]).
:- use_module(library(pairs), [pairs_keys_values/3]).
/** <module> The pieces of a transition, as they are unrolled.

A piece is piece(Part, End, T1-T2, G1-G2, Facets, Shape, Sense): a part of the
transition (primitive_transition.pl) and what is left of its facets
(true_shape.pl). T are its own parameters and G directions, degrees; between T1
and T2 both go in equal steps. H = 0 is at its End, base or top. Sense is 1 if
facets run counter-clockwise with T to the right and H up, else -1.
*/


                /*******************************
                *            PIECES            *
                *******************************/

%!  pieces_found(+S, +Part, -Leaf, -Pieces) is det.
%
%   Pieces are those of Part of segment S, a transition: the primitive Leaf, or
%   made of it. Of some nothing may be left.

pieces_found(S, Part, Leaf, Pieces) :-
    once(true_part(S, Part, Leaf, _, transition(pieces(Places)))),
    pieces_facets(S, Part, Leaf, Table),
    maplist(piece_found(S, Part, Table), Places, Pieces0),
    senses_known(Pieces0, Pieces).

piece_found(S, Part, Table, piece(Name, End, T1-T2, G1-G2),
            piece(Name, End, T1-T2, G1-G2, Facets, Shape, Sense)) :-
    piece_shape(S, Part, Table, Name, Facets1, Shape0),
    (   Facets1 = [_|_]
    ->  maplist(turned_to(T1), Facets1, Facets0),
        facets_sense(Facets0, Shape0, Sense),
        tips_moved(Facets0, Facets2, Shape0, Shape2),
        rims_kept(Facets2, Facets3, Shape2, Shape),
        spikes_cut(Facets3, Shape, Facets4),
        facets_as_drawn(S, Facets4, Shape, Facets)
    ;   Facets = [],
        Sense = none,
        Shape = Shape0
    ).

turned_to(T1, Facet0, Facet) :-
    facet_middle(Facet0, Middle),
    Turns is -floor((Middle-T1)/360.0),
    shifted_facet(Turns, Facet0, Facet).

%   senses_known(Pieces0, Pieces): also of those of which nothing is left.

senses_known(Pieces0, Pieces) :-
    once(( member(piece(_, End, _, _, _, _, Sense0), Pieces0),
           Sense0 \== none )),
    up_sign(End, Sign),
    Sense is Sign*Sense0,
    maplist(piece_sense(Sense), Pieces0, Pieces).

up_sign(base, 1).
up_sign(top, -1).

piece_sense(Up, piece(Name, End, Ts, Gs, Facets, Shape, _),
            piece(Name, End, Ts, Gs, Facets, Shape, Sense)) :-
    up_sign(End, Sign),
    Sense is Sign*Up.

%!  place_of(+Piece, +G, -T) is det.
%!  direction_of(+Piece, +T, -G) is det.
%
%   G is the direction, degrees, of the generator at T of Piece.

place_of(piece(_, _, T1-T2, G1-G2, _, _, _), G0, T) :-
    tolerance(angle, Near),
    G is G0 + 360.0*ceiling((G1 - Near - G0)/360.0),
    T is T1 + (T2-T1)*(G-G1)/(G2-G1).

direction_of(piece(_, _, T1-T2, G1-G2, _, _, _), T, G) :-
    G is G1 + (G2-G1)*(T-T1)/(T2-T1).


                /*******************************
                *             SEAM             *
                *******************************/

%!  composed_seam(+Pieces, +Borders, +Options, -Seam, -Around) is det.
%
%   Seam is the direction in which the pattern begins: seam(Degrees) of Options,
%   or by default the shortest generator, in the middle of a flat side, if there
%   is one, else in one of the directions Borders. Around is false if there is a
%   gap: the pattern starts after it.

composed_seam(Pieces, Borders, Options, Seam, Around) :-
    findall(From-To,
            ( member(Piece, Pieces),
              piece_facets(Piece, Facets),
              member(facet(_, T1, T2, _), Facets),
              direction_of(Piece, T1, From),
              direction_of(Piece, T2, To) ),
            Ranges),
    pairs_keys_values(Ranges, Froms, Tos),
    (   member(Start, Froms),
        \+ ( member(To, Tos), same_direction(Start, To) )
    ->  Around = false
    ;   Around = true
    ),
    (   option(seam(Seam0), Options)
    ->  must_be(number, Seam0),
        Seam is float(rational(Seam0) - 360*floor(rational(Seam0)/360))
    ;   Around == false
    ->  Seam = Start
    ;   shortest_seam(Pieces, Borders, Seam)
    ).

%!  piece_facets(+Piece, -Facets) is det.

piece_facets(piece(_, _, _, _, Facets, _, _), Facets).

%!  on_border(+Borders, +G) is semidet.
%
%   G is one of the directions Borders, up to rounding.

on_border(Borders, G) :-
    member(Border, Borders),
    same_direction(Border, G),
    !.

%   shortest_seam(Pieces, Borders, Seam): in the middle of a flat side, if there
%   is one that no hole interrupts there; of equal ones that which is farthest
%   from all holes, and of these the one with the smallest direction.

shortest_seam(Pieces, Borders, Seam) :-
    seam_candidates(Pieces, flat, Borders, Flat),
    seam_candidates(Pieces, round, Borders, Round),
    (   member(Found, [Flat,Round]),
        memberchk(length(1,_)-_, Found)
    ->  true
    ;   Round == []
    ->  Found = Flat
    ;   Found = Round
    ),
    shortest_generators(Found, Shortest),
    findall(G, ( member(Piece, Pieces), hole_direction(Piece, G) ), Holes),
    farthest_from(Holes, Shortest, Seam).

%   seam_candidates(Pieces, Which, Borders, Candidates): by direction,
%   length(Spans, Length)-G.

seam_candidates(Pieces, Which, Borders, Candidates) :-
    findall(length(Spans,Length)-G,
            seam_candidate(Pieces, Which, Borders, Spans, Length, G),
            Candidates0),
    sort(2, @<, Candidates0, Candidates).

seam_candidate(Pieces, Which, Borders, Count, Length, G) :-
    member(Piece, Pieces),
    Piece = piece(_, _, T1-T2, _, Facets, Shape, Sense),
    Shape = shape(Surface, _, _),
    (   Surface = fan(_, _, _, _)
    ->  Which = flat,
        T is (T1+T2)/2.0
    ;   Which = round,
        member(facet(_, T, _, _), Facets),
        direction_of(Piece, T, G0),
        on_border(Borders, G0)
    ),
    facet_index(Facets, Index),
    generator_spans(Index, T, Sense, Shape, Spans),
    length(Spans, Count),
    Count > 0,
    direction_of(Piece, T, G1),
    whole_turns(G1, By),
    G is G1 - By,
    generator_length(Surface, T, Length).

%   hole_direction(Piece, G) is nondet: a corner of a hole lies there.

hole_direction(Piece, G) :-
    Piece = piece(_, _, T1-T2, _, _, Shape, _),
    hole_places(Shape, Ts),
    member(T0, Ts),
    T is T0 - 360.0*round((T0 - (T1+T2)/2.0)/360.0),
    direction_of(Piece, T, G).

generator_length(Surface, T, Length) :-
    surface_point(Surface, T, 0.0, point(X1,Y1,Z1)),
    surface_point(Surface, T, 1.0, point(X2,Y2,Z2)),
    Length is sqrt((X1-X2)**2 + (Y1-Y2)**2 + (Z1-Z2)**2).


                /*******************************
                *           DIVIDING           *
                *******************************/

%!  divided_at(+G, +Pieces0, -Pieces) is det.
%
%   The piece that the direction G goes through becomes two.

divided_at(G, Pieces0, Pieces) :-
    maplist(piece_divided(G), Pieces0, Lists),
    append(Lists, Pieces).

piece_divided(G, Piece, Pieces) :-
    Piece = piece(Name, End, T1-T2, G1-G2, Facets0, Shape0, Sense),
    place_of(Piece, G, T),
    (   \+ between_angles(T1, T, T2)
    ->  Pieces = [Piece]
    ;   foldl(facet_at(T, Sense), Facets0, Lists, Shape0, Shape),
        append(Lists, Facets),
        direction_of(Piece, T, GT),
        findall(Facet, ( member(Facet, Facets), left_of(Facet, T) ), Left),
        findall(Facet, ( member(Facet, Facets), \+ left_of(Facet, T) ), Right),
        Pieces = [piece(Name, End, T1-T, G1-GT, Left, Shape, Sense),
                  piece(Name, End, T-T2, GT-G2, Right, Shape, Sense)]
    ).

left_of(Facet, T) :-
    facet_middle(Facet, Middle),
    Middle < T.

facet_at(T, Sense, Facet, Parts, Shape0, Shape) :-
    Facet = facet(_, T1, T2, _),
    (   \+ between_angles(T1, T, T2)
    ->  Parts = [Facet],
        Shape = Shape0
    ;   facet_divided(Facet, T, Sense, 1, Parts, Shape0, Shape)
    ).

%!  from_seam(+Pieces0, +Seam, -Pieces) is det.
%
%   From the one that begins at the seam on, or, if it goes through a gap, from
%   the first after it. Directions go from Seam to Seam + 360.

from_seam(Pieces0, Seam, Pieces) :-
    maplist(seam_order(Seam), Pieces0, Keyed0),
    keysort(Keyed0, Keyed),
    pairs_keys_values(Keyed, _, Pieces).

seam_order(Seam, Piece0, Off-Piece) :-
    Piece0 = piece(Name, End, Ts, G1-G2, Facets, Shape, Sense),
    tolerance(angle, Near),
    Turns is floor((G1 + Near - Seam)/360.0),
    H1 is G1 - 360.0*Turns,
    H2 is G2 - 360.0*Turns,
    Off = H1,
    Piece = piece(Name, End, Ts, H1-H2, Facets, Shape, Sense).


                /*******************************
                *           CREASES            *
                *******************************/

%!  creases(+Pieces, +Around, -Creases) is det.
%
%   Creases is a list of G-Degrees: by what the plate bends where two pieces
%   meet, positive outward; less than a millionth is nothing. Where a part of a
%   cone begins there is no bend: outlines with arcs are smooth there, and so is
%   what lies between them; cones that take turns only stand for that.

creases(Pieces, Around, Creases) :-
    Pieces = [First|Rest],
    (   Around == true
    ->  append(Rest, [First], Nexts),
        Firsts = Pieces
    ;   Nexts = Rest,
        append(Firsts, [_], Pieces)
    ),
    maplist(crease, Firsts, Nexts, Creases).

crease(Piece1, Piece2, G-0.0) :-
    Piece1 = piece(_, _, _, _-G, _, _, _),
    ( is_round(Piece1) ; is_round(Piece2) ),
    !.
crease(Piece1, Piece2, G-Degrees) :-
    Piece1 = piece(_, _, _-T1, _-G, _, _, _),
    Piece2 = piece(_, _, T2-_, _, _, _, _),
    outward(Piece1, T1, N1, Way),
    outward(Piece2, T2, N2, _),
    dot_product(N1, N2, Cos),
    cross_product(N1, N2, Across),
    dot_product(Across, Way, Sin),
    Degrees0 is atan2(Sin, Cos)*180.0/pi,
    (   same_angle(Degrees0, 0.0)
    ->  Degrees = 0.0
    ;   Degrees = Degrees0
    ).

%!  is_round(+Piece) is semidet.
%
%   Piece is a part of a cone or cylinder; else it is flat.

is_round(piece(_, _, _, _, _, shape(Surface, _, _), _)) :-
    Surface \= fan(_, _, _, _).

%   outward(Piece, T, Normal, Way): unit; Way is along the generator at T, so
%   that a bend about it is positive outward.

outward(piece(_, _, _, _, _, shape(Surface, _, _), Sense), T, Normal, Way) :-
    surface_normal_at(Surface, T, Normal0),
    surface_point(Surface, T, 0.0, point(X1,Y1,Z1)),
    surface_point(Surface, T, 1.0, point(X2,Y2,Z2)),
    X is X2-X1,
    Y is Y2-Y1,
    Z is Z2-Z1,
    F is Sense/sqrt(X*X + Y*Y + Z*Z),
    scaled(F, vector(X,Y,Z), Way),
    scaled(Sense, Normal0, Normal).
