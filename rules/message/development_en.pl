:- module(sg_development_en,
          [ development_en//2,          % +S, +What
            development_notice_en//2    % +S, +What
          ]).
:- use_module(explain_words, [segment_word/2, face_word/2]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3]).
/** <module> What is wrong with a development, in English.

development_ko.pl has the same heads in Korean
(tests/rules/development/development.plt).
*/

%!  development_en(+S, +What)// is det.
%
%   The message for geometry_error(development(S, What)).

development_en(S, What) -->
    { segment_word(S, Name) },
    [ 'segment ~d~w cannot be laid flat: '-[S, Name] ],
    what_en(What).

what_en(kind(curve)) -->
    [ 'it is a curve and has no faces' ].
what_en(kind(pattern)) -->
    [ 'it is a pattern, which is flat already', nl,
      '  Name the segment that it was made from.' ].
what_en(kind(Kind)) -->
    { \+ memberchk(Kind, [curve,pattern]) },
    [ 'it is of kind ~w'-[Kind], nl,
      '  Solids and surfaces can be.' ].
what_en(empty) -->
    [ 'it has no polygons' ].
what_en(not_simple(Ps)) -->
    [ 'these polygons cross themselves: ' ],
    some_en(Ps).
what_en(not_flat(Ps)) -->
    [ 'these polygons are not flat: ' ],
    some_en(Ps),
    [ nl, '  Without strict(true) their triangles are used.' ].
what_en(overlap(edge(E, Face3, Face4), Face1, Face2)) -->
    { maplist(face_word, [Face1,Face2,Face3,Face4], [W1,W2,W3,W4]) },
    [ 'joined at edge ~d between polygon ~w and polygon ~w, which is to be \c
       kept, polygon ~w would lie on polygon ~w'-[E, W3, W4, W2, W1], nl,
      '  Keep other edges, or let this one be a seam.' ].
what_en(no_joint(E)) -->
    [ 'no two faces meet at edge ~d'-[E], nl,
      '  Name an edge that two polygons have.' ].
what_en(edge_length(E)) -->
    [ 'edge ~d is too short to hold what would hang on it'-[E] ].
what_en(no_numbers) -->
    [ 'polygons that are not flat become triangles, and no numbers above \c
       those of its polygons and edges are left for these', nl,
      '  Give its polygons and edges smaller numbers than 2147483647.' ].
what_en(no_polygon(P)) -->
    [ 'it has no polygon ~p'-[P] ].

%   some_en(Ids): the first ones.

some_en(Ids) -->
    { length(Ids, Count),
      length(First, 10)
    },
    (   { Count =< 10 }
    ->  { atomic_list_concat(Ids, ', ', Text) },
        [ '~w'-[Text] ]
    ;   { append(First, _, Ids),
          atomic_list_concat(First, ', ', Text)
        },
        [ '~w, ... (~D in all)'-[Text, Count] ]
    ).

%!  development_notice_en(+S, +What)// is det.
%
%   The message for the warning sanggwan(development(S, What)).

development_notice_en(S, border(Kind, Sides)) -->
    { segment_word(S, Name) },
    [ 'segment ~d~w: '-[S, Name] ],
    border_en(Kind, Sides).
development_notice_en(S, in_triangles(Ps)) -->
    { segment_word(S, Name) },
    [ 'segment ~d~w: these polygons are not flat and are laid out as their \c
       triangles: '-[S, Name] ],
    some_en(Ps).

border_en(open, Sides) -->
    [ 'a solid, but these edges have no partner: ' ],
    sides_en(Sides),
    [ nl, '  They are borders of its pattern; is a face missing there?' ].
border_en(turned, Sides) -->
    [ 'polygons run along these edges in the same direction: ' ],
    sides_en(Sides),
    [ nl, '  They are not joined there: one of them is turned over.' ].
border_en(crowded, Sides) -->
    [ 'these edges have more than two polygons, and no partner is left for \c
       them: ' ],
    sides_en(Sides),
    [ nl, '  Two that run in opposite directions are joined; others come \c
           apart there.' ].

%   sides_en(Sides): the first ones.

sides_en(Sides) -->
    { length(Sides, Count) },
    sides_en(Sides, 6),
    (   { Count =< 6 }
    ->  []
    ;   [ ', ... (~D in all)'-[Count] ]
    ).

sides_en([side(E, P, Name)|Sides], Most) -->
    [ '~d of polygon ~d'-[E, P] ],
    (   { Name == P }
    ->  []
    ;   [ ' (~p)'-[Name] ]
    ),
    (   { Sides = [_|_], Most > 1 }
    ->  { Most1 is Most-1 },
        [ ', ' ],
        sides_en(Sides, Most1)
    ;   []
    ).
