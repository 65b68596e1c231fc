:- module(sg_unfold_en,
          [ wish_en//3,                 % +S, +Wish, +What
            unfold_en//1,               % +What
            trim_en//1,                 % +What
            known_polygons_listed//2,       % +Ps, +Names
            known_segments/2            % +Known, -Text
          ]).
:- use_module('../unfolding/unfold_wish', [all_forms/1]).
:- use_module(library(lists), [member/2]).
/** <module> What is wrong with an unfolding, in English.

unfold_ko.pl has the same heads in Korean (tests/rules/message/messages.plt).
*/

%!  wish_en(+S, +Wish, +What)// is det.
%
%   The message for unfold(S, Wish, What), as of unfold_wish.pl.

wish_en(S, Wish, What) -->
    [ 'segment ~d cannot be unfolded with ~p: '-[S, Wish] ],
    wish_fault_en(What).

wish_fault_en(no_segment) -->
    [ 'there is no such segment' ].
wish_fault_en(unknown_wish) -->
    { all_forms(Forms),
      atomic_list_concat(Forms, ', ', All) },
    [ 'it is no wish', nl, '  Those are ~w.'-[All] ].
wish_fault_en(form(Form)) -->
    [ 'it should look like ~w'-[Form], nl,
      '  A polygon is a number or a name such as base or side(2); an edge a \c
       number, two polygons such as base-side(2), or its ends, v(1)-v(2).' ].
wish_fault_en(how_form(Form)) -->
    [ 'it should look like ~w'-[Form] ].
wish_fault_en(twice(Other)) -->
    [ 'unfolding/2 says ~p of the same segment'-[Other], nl,
      '  One of the two has to go.' ].
wish_fault_en(needs(Form)) -->
    [ 'it says nothing without ~w'-[Form], nl,
      '  Say that too, in the model or as an option.' ].
wish_fault_en(no_polygon(Name, Ps, Names)) -->
    [ 'there is no polygon ~p'-[Name], nl, '  There are ' ],
    known_polygons_listed(Ps, Names).
wish_fault_en(several(Name, Faces)) -->
    [ '~p is not one polygon: '-[Name] ],
    faces_en(Faces).
wish_fault_en(no_edge(Name)) -->
    [ 'there is no edge ~p'-[Name] ].
wish_fault_en(apart(Name1, Name2, Face, Faces)) -->
    [ '~p and ~p have no edge in common'-[Name1, Name2], nl, '  ' ],
    face_en(Face),
    [ ' has edges in common with ' ],
    faces_en(Faces).
wish_fault_en(border(E, Face)) -->
    [ 'edge ~d of '-[E] ],
    face_en(Face),
    [ ' has no partner, there is nothing to join or to cut' ].
wish_fault_en(cut_and_keep(E, Face1, Face2)) -->
    [ 'edge ~d between '-[E] ],
    two_en(Face1, Face2),
    [ ' is to be cut and to be kept' ].
wish_fault_en(two_roots(Face1, Face2)) -->
    [ 'there is one root, not two: ' ],
    two_en(Face1, Face2).
wish_fault_en(removed_root(Face)) -->
    [ 'the root, ' ],
    face_en(Face),
    [ ', is to be removed' ].
wish_fault_en(removed_all) -->
    [ 'all polygons would be removed' ].
wish_fault_en(removed_keep(E, Face)) -->
    [ 'edge ~d cannot be kept: '-[E] ],
    face_en(Face),
    [ ' is to be removed' ].
wish_fault_en(order_removed(Face)) -->
    face_en(Face),
    [ ' is to be removed' ].
wish_fault_en(order_twice(Face)) -->
    face_en(Face),
    [ ' is in it twice' ].
wish_fault_en(order_root(Root, First)) -->
    [ 'the root is ' ],
    face_en(Root),
    [ ', but the order begins with ' ],
    face_en(First).
wish_fault_en(order_apart(Face, Before)) -->
    face_en(Face),
    [ ' has no edge in common with one before it: ' ],
    faces_en(Before).
wish_fault_en(order_cut(Face, Before)) -->
    [ 'every edge of ' ],
    face_en(Face),
    [ ' and one before it is to be cut: ' ],
    faces_en(Before).
wish_fault_en(ring(E, Face1, Face2)) -->
    [ 'edge ~d between '-[E] ],
    two_en(Face1, Face2),
    [ ' closes a ring of edges to be kept, which cannot lie flat' ].

two_en(Face1, Face2) -->
    face_en(Face1),
    [ ' and ' ],
    face_en(Face2).

face_en(face(P, Name)) -->
    (   { Name == P }
    ->  [ 'polygon ~d'-[P] ]
    ;   [ 'polygon ~d (~p)'-[P, Name] ]
    ).

faces_en(Faces) -->
    listed_en(Faces, 12).

listed_en([], _) -->
    [ 'none' ].
listed_en([Face], _) -->
    !,
    face_en(Face).
listed_en(Faces, 0) -->
    !,
    { length(Faces, N) },
    [ 'and ~D more'-[N] ].
listed_en([Face|Faces], N) -->
    face_en(Face),
    [ ', ' ],
    { N1 is N-1 },
    listed_en(Faces, N1).

%!  known_polygons_listed(+Ps, +Names)// is det.
%
%   Ranges of numbers, and names if there are; the same in all languages.

known_polygons_listed(Ps, Names) -->
    { ranges(Ps, Ranges),
      atomic_list_concat(Ranges, ', ', Numbers) },
    [ '~w'-[Numbers] ],
    (   { Names == [] }
    ->  []
    ;   { findall(Text,
                  ( member(Name, Names), format(atom(Text), '~w', [Name]) ),
                  Texts),
          atomic_list_concat(Texts, ', ', All) },
        [ ' (~w)'-[All] ]
    ).

%   ranges(Ps, Ranges): 1, 2, 3, 7 are '1 - 3' and '7'.

ranges([], []).
ranges([P|Ps], [Range|Ranges]) :-
    run(Ps, P, Last, Rest),
    (   Last == P
    ->  Range = P
    ;   format(atom(Range), '~d - ~d', [P, Last])
    ),
    ranges(Rest, Ranges).

run([P|Ps], P0, Last, Rest) :-
    P =:= P0+1,
    !,
    run(Ps, P, Last, Rest).
run(Ps, Last, Last, Ps).

%!  known_segments(+Known:list, -Text) is det.
%
%   Text has the numbers and titles of Known, a list of S-Title; the same in all
%   languages.

known_segments(Known, Text) :-
    findall(One,
            ( member(S-Title, Known),
              format(atom(One), '~w (~w)', [S, Title]) ),
            All),
    atomic_list_concat(All, ', ', Text).

%!  unfold_en(+What)// is det.
%
%   The message for unfold(What), of an error or a notice.

unfold_en(nothing_to_unfold) -->
    [ 'there is nothing to unfold: the model has no solid and no surface' ].
unfold_en(no_segment(Name, Known)) -->
    { known_segments(Known, All) },
    [ 'there is no segment ~p, only ~w'-[Name, All] ].
unfold_en(kind(S, Kind)) -->
    [ 'segment ~d is a ~w, which has no faces to unfold'-[S, Kind] ].
unfold_en(which_segment(Option, Known)) -->
    { atomic_list_concat(Known, ', ', All) },
    [ 'option ~w says something of one segment, but several are unfolded: ~w'-
      [Option, All], nl, '  Say which one with --only.' ].
unfold_en(no_term(Option, Text)) -->
    [ 'option ~w: ~w cannot be read'-[Option, Text], nl,
      '  Polygons are numbers or names such as base or side(2), edges such as \c
       4-7, base-side(2) or v(1)-v(2); with commas between them.' ].
unfold_en(no_names(Option, Text)) -->
    [ 'option ~w: ~w cannot be read'-[Option, Text], nl,
      '  Segments are numbers or names, with commas between them. A name with \c
       other signs than letters needs quotes in quotes: "\'a b\'".' ].
unfold_en(several_sheets(N)) -->
    [ 'the drawing has ~D sheets, and standard output takes one'-[N], nl,
      '  Write .pdf, which may have several, or a file.' ].
unfold_en(needs(Option, Needed)) -->
    [ 'option ~w says nothing without ~w'-[Option, Needed], nl,
      '  Give ~w as well.'-[Needed] ].
unfold_en(no_table(File)) -->
    [ '~w was not written: no pattern has generators'-[File], nl,
      '  With --true cylinders, cones and transitions have them.' ].
unfold_en(all_trimmed_away) -->
    [ 'nothing is left of any segment: all of them are trimmed away' ].
unfold_en(crosses_itself(S, P)) -->
    [ 'segment ~d: polygon ~d crosses itself, so it would be missing from the \c
       pattern'-[S, P], nl,
      '  Correct it in the model, or leave it out on purpose: --remove ~d.'-[P]
    ].
unfold_en(outline_unrolled(S, P)) -->
    [ 'segment ~d: the true outline of polygon ~d crosses itself, so it would \c
       be missing from the pattern'-[S, P], nl,
      '  Give it, or what cuts it, another number of facets, or unfold it \c
         without --true.' ].
unfold_en(outline_crosses(S, N)) -->
    [ 'segment ~d: bent of this plate its faces lie on each other in the \c
       pattern: sides that are cut cross ~D time(s)'-[S, N], nl,
      '  Cut other edges, or take a smaller --thickness or --bend-radius.' ].
unfold_en(alone(S)) -->
    [ 'segment ~d meets no other: nothing of it is trimmed'-[S] ].
unfold_en(attached(S, Welded, Divided)) -->
    [ 'segment ~d: for its pattern ~D vertex(es) are made one with others in \c
       their place, ~D edge(s) divided where parts attach'-
      [S, Welded, Divided] ].
unfold_en(root_gone(S, face(P, Name))) -->
    [ 'segment ~d: the root, '-[S] ],
    face_en(face(P, Name)),
    [ ', was trimmed away' ].
unfold_en(not_developable(S, Kind, N)) -->
    [ 'segment ~d: --true does not unroll a ~w, which is not developable: ~D \c
       facets of it are laid flat as they are'-[S, Kind, N], nl,
      '  More of them, facets(...) in the model, are closer to it.' ].
unfold_en(nearly_touching(S, By)) -->
    [ 'segment ~d nearly touches segment ~d by its side: how their lines meet \c
       there was decided by facets, and may be wrong'-[S, By], nl,
      '  A smaller --chord makes them finer.' ].
unfold_en(nothing_unrolled) -->
    [ 'nothing was unrolled: the model has no cylinder, cone, transition or \c
       sphere; what has flat faces is flat already'-[], nl,
      '  Without --true the patterns are the same.' ].
unfold_en(mitre_not_set_in(S)) -->
    [ 'segment ~d is not set in: parts of one radius meet in a mitre, by the \c
       middles of their plates'-[S], nl,
      '  --set-in is for a branch that is narrower than its header.' ].
unfold_en(mitre_by_middles(S)) -->
    [ 'segment ~d: --other-thickness changes nothing: parts of one radius \c
       meet by the middles of their plates, by which they are drawn'-[S], nl,
      '  With --size outside or inside it says how large the other one is.' ].
unfold_en(no_sphere(Option)) -->
    [ '~w says nothing: no sphere was unrolled'-[Option] ].
unfold_en(no_bend(Option)) -->
    [ '~w says nothing: no pattern has a bend'-[Option] ].
unfold_en(kept_apart(S, N)) -->
    [ 'segment ~d: ~D edge(s) could not be kept: on one side is what is \c
       unrolled, on the other what is flat, in a pattern of its own'-[S, N] ].
unfold_en(not_kept(S, E, Face1, Face2, Why)) -->
    [ 'segment ~d: edge ~d between '-[S, E] ],
    two_en(Face1, Face2),
    [ ' could not be kept: ' ],
    not_kept_en(Why).

not_kept_en(overlap) -->
    [ 'the pattern would overlap' ].
not_kept_en(same_piece) -->
    [ 'they are joined another way' ].

%!  trim_en(+What)// is det.
%
%   The message for trim(What).

trim_en(nothing_left(S, outside)) -->
    [ 'nothing is left of segment ~d: all of it is inside the others'-[S] ].
trim_en(nothing_left(S, inside)) -->
    [ 'nothing is left of segment ~d: all of it is outside the others'-[S] ].
trim_en(kind(S, Kind)) -->
    [ 'segment ~d is a ~w: it cannot be trimmed, nor trim others'-[S, Kind] ].
trim_en(open(S, V1, V2)) -->
    [ 'segment ~d is open, so nobody can say what is inside it'-[S], nl,
      '  Flat ends are closed for that; but its border that runs from vertex \c
       ~d to ~d is not flat.'-[V1, V2] ].
