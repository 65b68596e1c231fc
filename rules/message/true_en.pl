:- module(sg_true_en,
          [ true_en//1                  % +What
          ]).
/** <module> What is wrong with a true development, in English.

true_ko.pl has the same heads in Korean
(tests/rules/unrolling/true_development.plt).
*/

%!  true_en(+What)// is det.
%
%   The message for geometry_error(true(What)).

true_en(no_part(S, Part)) -->
    { var(Part) },
    !,
    [ 'nothing of segment ~d has a true development'-[S], nl,
      '  It has no facets of a cylinder, cone or transition.' ].
true_en(no_part(S, Part)) -->
    [ 'segment ~d has no part ~p that has a true development'-[S, Part], nl,
      '  A part is named as in face_of/3: side, outer, edge(1); of a segment \c
         that was trimmed 2/side, the side of segment 2.' ].
true_en(moved(S, Part)) -->
    [ 'the part ~p of segment ~d is not where its primitive is'-[Part, S], nl,
      '  Place the primitive itself, not a copy of it.' ].
true_en(nothing_left(S, Part)) -->
    [ 'nothing is left of the part ~p of segment ~d: its facets stand out, \c
       the true surface does not'-[Part, S], nl,
      '  Unfold it without --true, or other segments only: --only.' ].
true_en(not_symmetric(S, Part)) -->
    [ 'half a pattern is not enough: the halves of part ~p of segment ~d \c
       differ'-[Part, S], nl,
      '  Give another seam, or take the whole pattern.' ].
true_en(flat_part(S, Part, Option)) -->
    [ 'part ~p of segment ~d lies between ellipses of different proportions: \c
       it does not unroll, and cannot have the option ~w'-[Part, S, Option],
      nl,
      '  Make it a transition(base(ellipse(A, B)), top(ellipse(C, D)), \c
         height(H)), which does.' ].
true_en(no_option(S, Option)) -->
    [ 'segment ~d is a sphere in gores or zones, to which the option ~w says \c
       nothing'-[S, Option], nl,
      '  A gore is symmetric, and a zone goes round: leave the option out.' ].
true_en(no_offset(S)) -->
    [ 'the surfaces of a plate of segment ~d are not known'-[S], nl,
      '  With a thickness, penetrations are found for cylinders and cones, \c
         round spheres and tori, transitions,', nl,
      '  and what has flat faces and is convex, or has corners of three; and \c
         the plate must be thinner than there is room for within.' ].
true_en(too_thick(S, T, Most)) -->
    [ 'a plate ~p thick leaves nothing hollow in segment ~d: it must be less \c
       than ~6g thick'-[T, S, Most], nl,
      '  Take a smaller thickness, or make the part wider.' ].
true_en(bend(S, P1, P2, Degrees)) -->
    [ 'segment ~d: the fold between polygons ~d and ~d turns by ~2f degrees: \c
       no bend has such an angle'-[S, P1, P2, Degrees], nl,
      '  Bends turn by less than 170 degrees.' ].
true_en(bend_too_wide(S, P, Width)) -->
    [ 'segment ~d: polygon ~d is narrower than what its bends and seams take \c
       off, ~4f'-
      [S, P, Width], nl,
      '  Take a smaller --bend-radius or --thickness, or leave faces out that \c
         are not needed: --remove base.' ].
true_en(no_relief(S, P, Wide)) -->
    [ 'segment ~d: polygon ~d has no room for the cut in its corner, ~4f \c
       from where its bends meet'-[S, P, Wide], nl,
      '  Give --relief none, or a smaller --bend-radius or --thickness.' ].
true_en(bent_over(S, P)) -->
    [ 'segment ~d: what bends and seams leave of polygon ~d crosses itself: \c
       it cannot be cut'-[S, P], nl,
      '  Take a smaller --thickness or --bend-radius, or cut other edges.' ].
true_en(bent_facet(S, P, Kind, Width)) -->
    [ 'segment ~d: polygon ~d, a facet of a ~w, is narrower than what its \c
       bends take off, ~4f'-[S, P, Kind, Width], nl,
      '  A ~w is not developable: a plate cannot be rolled to it, only bent \c
         between flat facets.'-[Kind], nl,
      '  Give it fewer facets, a smaller --bend-radius or --thickness; or \c
         unfold it without --thickness, as thin sheet.' ].
