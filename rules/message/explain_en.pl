:- module(sg_explain_en,
          [ statement_en//1,            % +Statement
            hidden_en//1                % +What
          ]).
:- use_module('../near', [is_rounding/2]).
:- use_module(explain_words, 
              [ other_origin/1, segment_word/2, polygon_word/3, in_order/4,
                exact_text/3, point_text/2
              ]).
:- use_module(explain_glue_en, [glue_statement_en//1]).
:- use_module(explain_parameter_en, [parameter_statement_en//1]).
:- use_module(explain_pixel_en, [pixel_statement_en//1]).
:- use_module(library(apply), [maplist/3]).

/** <module> Explanations in English; explain_ko.pl has them in Korean.
*/

%!  statement_en(+Statement)// is semidet.
%
%   A statement of explain_words.pl in English.

statement_en(line(L, S1, P1, S2, P2)) -->
    { segment_word(S1, W1), segment_word(S2, W2) },
    [ 'line ~d: polygon ~d of segment ~d~w meets polygon ~d of segment ~d~w'-
      [L, P1, S1, W1, P2, S2, W2] ].
statement_en(touch(L, S1, P1, S2, P2)) -->
    { segment_word(S1, W1), segment_word(S2, W2) },
    [ 'line ~d: polygon ~d of segment ~d~w touches polygon ~d of segment ~d~w \c
       in one point'-
      [L, P1, S1, W1, P2, S2, W2] ].
statement_en(point(End, Point, S1, V1, S2, V2)) -->
    { memberchk(End-Word, [start-'starts at', end-'ends at', point-at]) },
    [ '~w '-[Word] ],
    point(Point),
    [ ', vertex ~d of segment ~d and vertex ~d of segment ~d'-
      [V1, S1, V2, S2] ].
statement_en(contact('vertex-vertex', seat(S1,V1,_), seat(S2,V2,_))) -->
    [ 'vertex ~d of segment ~d and vertex ~d of segment ~d are in one place'-
      [V1, S1, V2, S2] ].
statement_en(contact('vertex-edge', Seat1, Seat2)) -->
    { in_order(Seat1, Seat2, seat(S1,V1,_), seat(S2,_,Place)) },
    [ 'vertex ~d of segment ~d lies on '-[V1, S1] ],
    place(S2, Place).
statement_en(contact('vertex-face', Seat1, Seat2)) -->
    { in_order(Seat1, Seat2, seat(S1,V1,_), seat(S2,_,Place)) },
    [ 'vertex ~d of segment ~d lies inside '-[V1, S1] ],
    place(S2, Place).
statement_en(contact('edge-edge', seat(S1,_,Place1), seat(S2,_,Place2))) -->
    place(S1, Place1),
    [ ' meets ' ],
    place(S2, Place2).
statement_en(contact('edge-face', Seat1, Seat2)) -->
    { in_order(Seat1, Seat2, seat(S1,_,Place1), seat(S2,_,Place2)) },
    place(S1, Place1),
    [ ' pierces ' ],
    place(S2, Place2).
statement_en(contact('edge-in-face', Seat1, Seat2)) -->
    { in_order(Seat1, Seat2, seat(S1,_,Place1), seat(S2,_,Place2)) },
    place(S1, Place1),
    [ ' runs inside ' ],
    place(S2, Place2).
statement_en(contact('face-face', seat(S1,_,Place1), seat(S2,_,Place2))) -->
    [ 'inside ' ],
    place(S1, Place1),
    [ ' and inside ' ],
    place(S2, Place2).
statement_en(made(v(S, V))) -->
    [ 'made by vertex ~d of segment ~d'-[V, S] ].
statement_en(made(on(S-V, _))) -->
    [ 'at vertex ~d of segment ~d'-[V, S] ].
statement_en(made(lpi(S1-(A,B), S2-p(P)))) -->
    [ 'made by ~d-~d of segment ~d through polygon ~d of segment ~d'-
      [A, B, S1, P, S2] ].
statement_en(made(lpi(S1-p(P), Face))) -->
    { triangle_text(Face, Text) },
    [ 'made by a line in polygon ~d of segment ~d through ~w'-[P, S1, Text] ].
statement_en(made(lpi(S1-(A,B), S2-(C,D,E)))) -->
    [ 'made by ~d-~d of segment ~d through triangle ~d-~d-~d of segment ~d'-
      [A, B, S1, C, D, E, S2] ].
statement_en(made(ll(S1-(A,B), S2-(C,D)))) -->
    [ 'made by ~d-~d of segment ~d and ~d-~d of segment ~d, which cross'-
      [A, B, S1, C, D, S2] ].
statement_en(made(ll(S1-p(P), Place))) -->
    { triangle_text(Place, Text) },
    [ 'made by a line in polygon ~d of segment ~d and ~w, which cross'-
      [P, S1, Text] ].
statement_en(made(ll(S1-(A,B), S2-p(P)))) -->
    [ 'made by ~d-~d of segment ~d and a line in polygon ~d of segment ~d, \c
       which cross'-[A, B, S1, P, S2] ].
statement_en(made(tpi(T1, T2, T3))) -->
    { maplist(triangle_text, [T1,T2,T3], [W1,W2,W3]) },
    [ 'made by three planes: of ~w, ~w and ~w'-[W1, W2, W3] ].
statement_en(made(Origin)) -->
    { other_origin(Origin) },
    [ 'made from ~p, as the model says'-[Origin] ].
statement_en(made(near(Origin))) -->
    [ 'made to touch, being nearer than the tolerance: ' ],
    statement_en(made(Origin)).
statement_en(at(S, V, Point)) -->
    [ 'vertex ~d of segment ~d is at '-[V, S] ],
    point(Point).
statement_en(side(S, V, Point, Side, Triangle)) -->
    { triangle_text(Triangle, Text) },
    [ 'vertex ~d of segment ~d at '-[V, S] ],
    point(Point),
    [ ' is ~w the plane of ~w'-[Side, Text] ].
statement_en(exact(X, Y, Z)) -->
    { maplist(exact_word, [X,Y,Z], [Tx,Ty,Tz]) },
    [ 'exactly (~w, ~w, ~w)'-[Tx, Ty, Tz] ].
statement_en(also(S, V, Place)) -->
    [ 'is vertex ~d of segment ~d too'-[V, S] ],
    (   { Place = vertex(_) }
    ->  []
    ;   [ ', on ' ],
        place(S, Place)
    ).
statement_en(not_merged(L, By)) -->
    [ 'not merged with line ~d there: merge_line/2 (~w) refused it'-[L, By] ].
statement_en(made_to_touch) -->
    [ 'its polygons were made to touch first, being nearer than the \c
       tolerance' ].
statement_en(touching(1)) -->
    [ 'one pair of triangles touches there' ].
statement_en(touching(N)) -->
    { N \== 1 },
    [ '~d pairs of triangles touch there'-[N] ].
statement_en(pieces(1, _)) -->
    [ 'one cut of two triangles' ].
statement_en(pieces(N, By)) -->
    { N \== 1 },
    [ 'merged from ~d cuts of triangles by merge_line/2 (~w)'-[N, By] ].
statement_en(piece(I, T1, T2)) -->
    { maplist(triangle_text, [T1,T2], [W1,W2]) },
    [ '~d: ~w with ~w'-[I, W1, W2] ].
statement_en(chain(C, point, _, _)) -->
    [ 'alone in chain ~d, which is a point'-[C] ].
statement_en(chain(C, Kind, I, N)) -->
    { Kind \== point },
    [ 'piece ~d of the ~d in chain ~d, which is ~w'-[I, N, C, Kind] ].
statement_en(chain_head(C, Kind, S1, S2, N, Length)) -->
    { maplist(segment_word, [S1,S2], [W1,W2]) },
    [ 'chain ~d of segment ~d~w and segment ~d~w: '-[C, S1, W1, S2, W2] ],
    (   { Kind == point }
    ->  [ 'a point' ]
    ;   { N =:= 1 }
    ->  [ '~w, 1 piece, length ~15g'-[Kind, Length] ]
    ;   [ '~w, ~d pieces, length ~15g'-[Kind, N, Length] ]
    ).
statement_en(derived(S, V, Point, Place)) -->
    { segment_word(S, Word) },
    [ 'vertex ~d of segment ~d~w at '-[V, S, Word] ],
    point(Point),
    [ ', on ' ],
    place(S, Place).
statement_en(moved(S, V, Point)) -->
    { segment_word(S, Word) },
    [ 'vertex ~d of segment ~d~w at '-[V, S, Word] ],
    point(Point),
    [ ', moved there so that it touches' ].
statement_en(was_at(_, _, Point)) -->
    [ 'was at ' ],
    point(Point).
statement_en(original(S, V, Point)) -->
    { segment_word(S, Word) },
    [ 'vertex ~d of segment ~d~w at '-[V, S, Word] ],
    point(Point),
    [ ', as the model has it' ].
statement_en(vertex_of(S, V)) -->
    [ 'was vertex ~d of segment ~d'-[V, S] ].
statement_en(lies_on(S, v(V))) -->
    [ 'on vertex ~d of segment ~d'-[V, S] ].
statement_en(lies_on(S, e(E))) -->
    [ 'on edge ~d of segment ~d'-[E, S] ].
statement_en(lies_on(S, p(P))) -->
    [ 'on polygon ~d of segment ~d'-[P, S] ].
statement_en(vertex_lines(Ls)) -->
    { atomic_list_concat(Ls, ', ', Text) },
    [ 'an end of penetration line ~w'-[Text] ].
statement_en(edge(S, E, V1, V2)) -->
    { segment_word(S, Word) },
    [ 'edge ~d of segment ~d~w from vertex ~d to vertex ~d'-
      [E, S, Word, V1, V2] ].
statement_en(edge_whole(_, _)) -->
    [ 'as the model has it' ].
statement_en(edge_near(_, _)) -->
    [ 'made so that the polygons touch' ].
statement_en(edge_of_line(_)) -->
    [ 'made by a penetration line' ].
statement_en(part_of(_, E, V1, V2)) -->
    [ 'a part of edge ~d, which ran from vertex ~d to vertex ~d'-[E, V1, V2] ].
statement_en(edge_polygons(_, Ps)) -->
    { atomic_list_concat(Ps, ', ', Text) },
    [ 'in polygon ~w'-[Text] ].
statement_en(edge_divided(S, E, V1, V2)) -->
    { segment_word(S, Word) },
    [ 'edge ~d of segment ~d~w ran from vertex ~d to vertex ~d; \c
       it was divided'-
      [E, S, Word, V1, V2] ].
statement_en(edge_part(_, E, V1, V2)) -->
    [ 'edge ~d from vertex ~d to vertex ~d'-[E, V1, V2] ].
statement_en(segments(S1, S2)) -->
    { segment_word(S1, W1), segment_word(S2, W2) },
    [ 'segment ~d~w and segment ~d~w'-[S1, W1, S2, W2] ].
statement_en(lines_between(N)) -->
    [ 'have ~d pieces of penetration lines in common'-[N] ].
statement_en(same_segment) -->
    [ 'no line: one segment is not cut by itself (see check)' ].
statement_en(refused(S1, S2, By)) -->
    [ 'no line: may_cut(~d, ~d) refused it, by the rules of ~w'-[S1, S2, By] ].
statement_en(no_common_piece) -->
    [ 'no line: no two of their triangles have a piece in common' ].
statement_en(pair(S1, P1, S2, P2)) -->
    { segment_word(S1, W1), segment_word(S2, W2) },
    [ 'polygon ~d of segment ~d~w and polygon ~d of segment ~d~w'-
      [P1, S1, W1, P2, S2, W2] ].
statement_en(pair_lines(Ls)) -->
    { atomic_list_concat(Ls, ', ', Text) },
    [ 'give line ~w'-[Text] ].
statement_en(of_line(L)) -->
    [ 'line ~d'-[L] ].
statement_en(boxes_apart(Axis, High, Low, Lower)) -->
    { memberchk(Lower-Words, [first-[first,second], second-[second,first]]),
      Words = [One,Other] },
    [ 'no line: their boxes are apart, the ~w ends at ~w = ~w, \c
       the ~w begins at ~w'-
      [One, Axis, High, Other, Low] ].
statement_en(no_line) -->
    [ 'give no line' ].
statement_en(inside_faces) -->
    [ 'their common part is inside faces: polygons of one segment that go on \c
       in one plane are one face, and only its border is a line' ].
statement_en(elsewhere(L, S1, P1, S2, P2)) -->
    [ 'where they meet is line ~d, of polygon ~d of segment ~d and polygon ~d \c
       of segment ~d; along an edge one polygon has it'-[L, P1, S1, P2, S2] ].
statement_en(triangles_apart(N)) -->
    [ 'pairs of triangles whose boxes are apart: ~d'-[N] ].
statement_en(triangles(Reason, N)) -->
    { reason_en(Reason, Text) },
    [ '~w: ~d'-[Text, N] ].
statement_en(example(T1, T2)) -->
    { maplist(triangle_text, [T1,T2], [W1,W2]) },
    [ 'such as ~w with ~w'-[W1, W2] ].
statement_en(piece(S, P)) -->
    { segment_word(S, Word) },
    [ 'polygon ~d of segment ~d~w'-[P, S, Word] ].
statement_en(piece_of(S, P, Sense)) -->
    { segment_word(S, Word) },
    [ 'has a part of polygon ~d of segment ~d~w'-[P, S, Word] ],
    sense(Sense).
statement_en(polygon_in(S0, P0, S)) -->
    { segment_word(S0, W0), segment_word(S, W) },
    [ 'polygon ~d of segment ~d~w in segment ~d~w'-[P0, S0, W0, S, W] ].
statement_en(became(S, P, Sense)) -->
    [ 'a part of it, or all, is in polygon ~d of segment ~d'-[P, S] ],
    sense(Sense).
statement_en(triangles_of(N, Verdict)) -->
    { verdict_en(Verdict, Text) },
    [ 'triangles of it, after the cuts, that are ~w: ~d; the largest:'-
      [Text, N] ].
statement_en(witness(Point)) -->
    [ 'its witness is ' ],
    point(Point).
statement_en(round(S, Below, Above)) -->
    { segment_word(S, Word),
      maplist(inside_en, [Below,Above], [B,A]) },
    [ 'just below it is ~w segment ~d~w, just above it ~w'-[B, S, Word, A] ].
statement_en(verdict(kept(Sense), By)) -->
    [ 'kept' ],
    sense(Sense),
    [ ', since one side alone is inside (stays/3, ~w)'-[By] ].
statement_en(verdict(covered(S), _)) -->
    { segment_word(S, Word) },
    [ 'in the place of a piece of segment ~d~w, which stands for both'-
      [S, Word] ].
statement_en(verdict(dropped, By)) -->
    [ 'dropped, since both sides are inside or both outside (stays/3, ~w)'-
      [By] ].
statement_en(hidden_line(S, E, V1, V2)) -->
    { segment_word(S, Word) },
    [ 'line s~de~d: edge ~d of segment ~d~w, in the picture from vertex ~d \c
       (0) to vertex ~d (1)'-[S, E, E, S, Word, V1, V2] ].
statement_en(outline_piece(S, E, P, T)) -->
    { segment_word(S, Word) },
    [ 'line s~de~d: a piece of the outline of a smooth surface, across \c
       triangle ~d of polygon ~d of segment ~d~w, in the picture from 0 to 1'-
      [S, E, T, P, S, Word] ].
statement_en(behind_fold(From)) -->
    [ 'from ~6g on it lies behind the fold of its own surface'-[From] ].
statement_en(substitute_outline) -->
    [ 'there triangles of a smooth surface turn from the eye: it is drawn \c
       where it is seen and no other line is near' ].
statement_en(turned_away(S, P, From, To)) -->
    { segment_word(S, Word) },
    [ 'from ~6g to ~6g the smooth surface that polygon ~d of segment ~d~w \c
       stands for is turned away there, and hides it'-[From, To, P, S, Word] ].
statement_en(same_line(S1, E1, S2, E2)) -->
    [ 'edge ~d of segment ~d is drawn as edge ~d of segment ~d'-
      [E1, S1, E2, S2] ].
statement_en(line_role(Role)) -->
    [ 'its role is ~w'-[Role] ].
statement_en(not_drawn(Role, Which)) -->
    [ 'not drawn: of the lines of a drawing with lines ~w none is ~w'-
      [Which, Role] ].
statement_en(faces_bend(Bend)) -->
    [ 'its faces bend by ~6g degrees, which counts as flat'-[Bend] ].
statement_en(end_on) -->
    [ 'seen end-on: a point in the picture, which is not drawn' ].
statement_en(backs(S, N)) -->
    { segment_word(S, Word) },
    [ 'segment ~d~w is a closed solid, and of the faces at the line none \c
       looks towards the eye (away: ~d)'-[S, Word, N] ].
statement_en(hidden_part(From, To)) -->
    [ 'hidden from ~6g to ~6g'-[From, To] ].
statement_en(surface_goes_on(S, P, From, To)) -->
    [ 'from ~6g to ~6g the surface goes on near behind it, in polygon ~d of \c
       segment ~d'-[From, To, P, S] ].
statement_en(hiding_face(S, P, From, To, Behind)) -->
    { segment_word(S, Word) },
    [ 'polygon ~d of segment ~d~w hides it from ~6g to ~6g; in the middle it \c
       is nearer to the eye by ~6g'-[P, S, Word, From, To, Behind] ].
statement_en(ends_with_line(Which, At)) -->
    which_end(Which, At),
    [ ', where the line ends' ].
statement_en(ends_at_edge(Which, At, S, E, V1, V2)) -->
    which_end(Which, At),
    [ ', where it crosses edge ~d of segment ~d (~d-~d) in the picture'-
      [E, S, V1, V2] ].
statement_en(ends_at_outline(Which, At, S, E)) -->
    which_end(Which, At),
    [ ', where it crosses the outline (~d) of segment ~d in the picture'-
      [E, S] ].
statement_en(ends_in_face(Which, At, S, P)) -->
    which_end(Which, At),
    [ ', where the line goes through polygon ~d of segment ~d'-[P, S] ].
statement_en(visible_part(From, To)) -->
    [ 'visible from ~6g to ~6g'-[From, To] ].
statement_en(nowhere_visible) -->
    [ 'no part of it is visible: ask hidden(...) what hides it' ].
statement_en(nothing_over) -->
    [ 'no other face that could hide it lies on it in the picture' ].
statement_en(face_behind(S, P, From, To, Before)) -->
    { segment_word(S, Word) },
    [ 'polygon ~d of segment ~d~w lies on it in the picture from ~6g to ~6g, \c
       but behind it, in the middle by ~6g'-[P, S, Word, From, To, Before] ].
statement_en(line_in_face(S, P)) -->
    { segment_word(S, Word) },
    [ 'it lies on polygon ~d of segment ~d~w: that never hides it'-
      [P, S, Word] ].
statement_en(let_through(S, P, From, To, Decision, By)) -->
    { segment_word(S, Word) },
    [ 'polygon ~d of segment ~d~w lies before it from ~6g to ~6g, but ~w (~w) \c
       lets it be seen'-[P, S, Word, From, To, Decision, By] ].
statement_en(drawn_instead(From, To, Visibility, S, E, Role)) -->
    { segment_word(S, Word) },
    [ 'from ~6g to ~6g edge ~d of segment ~d~w is drawn, which lies there in \c
       the picture: ~w, ~w'-[From, To, E, S, Word, Visibility, Role] ].
statement_en(common(_, End1, End2)) -->
    (   { End1 == End2 }
    ->  [ 'in common: the point of ~q'-[End1] ]
    ;   [ 'in common: from ~q to ~q'-[End1, End2] ]
    ).
statement_en(seam_edge(S, E, E2, P1, P2, Length)) -->
    { segment_word(S, Word), maplist(polygon_word(S), [P1,P2], [W1,W2]) },
    [ 'edge ~d of segment ~d~w is a seam ~6g long, between polygon ~w and \c
       polygon ~w, where it is edge ~d'-[E, S, Word, Length, W1, W2, E2] ].
statement_en(fold_edge(S, E, E2, P1, P2, Length, Angle)) -->
    { segment_word(S, Word), maplist(polygon_word(S), [P1,P2], [W1,W2]) },
    [ 'edge ~d of segment ~d~w is a fold ~6g long, between polygon ~w and \c
       polygon ~w, where it is edge ~d; it is bent by ~6g degrees'-
      [E, S, Word, Length, W1, W2, E2, Angle] ].
statement_en(border_edge(S, E, P)) -->
    { segment_word(S, Word), polygon_word(S, P, W) },
    [ 'edge ~d of segment ~d~w is a border of polygon ~w: no other polygon \c
       of the pattern has it'-[E, S, Word, W] ].
statement_en(line_in_polygon(S, E, E2, P)) -->
    { segment_word(S, Word), polygon_word(S, P, W) },
    [ 'edge ~d of segment ~d~w is a penetration line inside polygon ~w; back \c
       it is edge ~d'-[E, S, Word, W, E2] ].
statement_en(joined_already(1, E, Length)) -->
    [ 'its polygons were joined before, at edge ~d, ~6g long'-[E, Length] ].
statement_en(joined_already(N, E, Length)) -->
    { N \== 1 },
    [ 'its polygons hung together already, by ~d folds; the shortest is edge \c
       ~d, ~6g long'-[N, E, Length] ].
statement_en(fold_on_the_way(E, P1, P2, Length)) -->
    [ 'edge ~d, ~6g long, between polygon ~d and polygon ~d'-
      [E, Length, P1, P2] ].
statement_en(joined_in_order(default)) -->
    [ 'edges are joined flat ones first, then the longest (join_order/3)' ].
statement_en(joined_in_order(By)) -->
    { By \== default },
    [ 'edges are joined in the order of ~w (join_order/3)'-[By] ].
statement_en(folds_exchanged) -->
    [ 'then folds were taken back for others, wherever that made the seam of \c
       the whole pattern shorter' ].
statement_en(cut_instead(E, Difference)) -->
    { by_how_much_en(Difference, Text) },
    [ 'cut at edge ~d instead, the seam would be ~w'-[E, Text] ].
statement_en(kept_instead(Difference, Pieces, Before)) -->
    { by_how_much_en(Difference, Text), pieces_en(Pieces, Before, PiecesText) },
    [ 'joined here before all others, the seam of the whole pattern would be \c
       ~w~w'-[Text, PiecesText] ].
statement_en(not_tried) -->
    [ 'what another choice would cost was not tried for so many: ask for this \c
       edge alone' ].
statement_en(held_by_kept) -->
    [ 'it cannot be kept as well: edges that are to be kept hold its polygons \c
       together already' ].
statement_en(cut_here(Difference, Pieces, Before)) -->
    { by_how_much_en(Difference, Text), pieces_en(Pieces, Before, PiecesText) },
    [ 'cut here, the seam of the whole pattern would be ~w~w'-
      [Text, PiecesText] ].
statement_en(cannot_be_kept(S, P1, P2)) -->
    { maplist(polygon_word(S), [P1,P2], [W1,W2]) },
    [ 'it cannot be kept: polygon ~w would lie on polygon ~w'-[W2, W1] ].
statement_en(would_overlap(S, P1, P2)) -->
    { maplist(polygon_word(S), [P1,P2], [W1,W2]) },
    [ 'joined here, polygon ~w would have come to lie on polygon ~w'-
      [W2, W1] ].
statement_en(would_overlap_instead(S, E, P1, P2)) -->
    { maplist(polygon_word(S), [P1,P2], [W1,W2]) },
    [ 'joined here, and cut at edge ~d instead, polygon ~w would lie on \c
       polygon ~w'-[E, W2, W1] ].
statement_en(cut_by_wish) -->
    [ 'it was to be cut (unfolding/2, --cut)' ].
statement_en(could_be_joined) -->
    [ 'nothing is against joining it: it was to be cut, or a rule was \c
       against it' ].
statement_en(cut_open(Part)) -->
    [ '~w is unrolled as the round surface it is; where that goes round, it \c
       is cut open along one generator: the shortest, or as --seam or --cut \c
       say'-[Part] ].
statement_en(unrolled(Part)) -->
    [ '~w is unrolled as the round surface it is: its facets are connected in \c
       the order that they have round it'-[Part] ].
statement_en(kept_by_wish) -->
    [ 'it was to be kept (unfolding/2, --keep)' ].
statement_en(may_not_join(S, E, By)) -->
    [ 'may_join(~d, ~d) refused it, by the rules of ~w'-[S, E, By] ].
statement_en(no_length) -->
    [ 'it has no length that could hold two polygons together' ].
statement_en(too_short) -->
    [ 'it is too short: what would hang on it is more than 2,048 times as \c
       long' ].
statement_en(changed_since) -->
    [ 'the segment has changed since its pattern was made: why is not known \c
       any more' ].
statement_en(pattern_piece(S, _, N, 1)) -->
    { segment_word(S, Word) },
    [ 'the pattern of segment ~d~w is one piece, of ~d polygons'-
      [S, Word, N] ].
statement_en(pattern_piece(S, K, N, Pieces)) -->
    { Pieces \== 1 },
    { segment_word(S, Word) },
    [ 'piece ~d of the ~d of segment ~d~w has ~d polygons'-
      [K, Pieces, S, Word, N] ].
statement_en(seams_out(1)) -->
    [ 'one seam leads to another piece' ].
statement_en(seams_out(N)) -->
    { N \== 1 },
    [ '~d seams lead to other pieces; the longest:'-[N] ].
statement_en(no_seam_out) -->
    [ 'no edge leads to another piece' ].
statement_en(Statement) -->
    parameter_statement_en(Statement).
statement_en(Statement) -->
    pixel_statement_en(Statement).
statement_en(Statement) -->
    glue_statement_en(Statement).

%!  hidden_en(+What)// is det.
%
%   What is said where no line of the picture was asked for.

hidden_en(nothing(Item)) -->
    [ 'there is nothing to explain in ~p'-[Item], nl,
      '  hidden(S, E) is a real edge E of segment S, as in data-segment and \c
       data-edge of a drawing; hidden(s1e7) is its id there. From Prolog, \c
       make the picture first: picture, or draw(File).' ].

which_end(from, At) -->
    [ 'from ~6g'-[At] ].
which_end(to, At) -->
    [ 'to ~6g'-[At] ].

sense(1) -->
    [].
sense(-1) -->
    [ ', turned over' ].

verdict_en(kept(_), kept).
verdict_en(dropped, dropped).
verdict_en(covered(_), 'in the place of others').

inside_en(N, Word) :-
    (   N > 0
    ->  Word = inside
    ;   Word = outside
    ).

reason_en(one_side(first),
          'the first triangle is wholly on one side of the other').
reason_en(one_side(second),
          'the second triangle is wholly on one side of the other').
reason_en(intervals_apart,
          'each crosses the other\'s plane, but not in one place').
reason_en(coplanar_apart, 'in one plane, and apart').
reason_en(coplanar_inside, 'in one plane, with borders inside each other').
reason_en(point_alone, 'they touch in one point alone').
reason_en(common_piece, 'they have a piece in common').

%   place(+S, +Place)//: a feature of segment S.

place(S, vertex(V)) -->
    [ 'vertex ~d of segment ~d'-[V, S] ].
place(S, edge(A, B)) -->
    [ 'edge ~d-~d of segment ~d'-[A, B, S] ].
place(S, face(P, Corners)) -->
    [ 'polygon ~d of segment ~d'-[P, S] ],
    corners(Corners).

corners(triangle(A, B, C)) -->
    [ ' (in its triangle ~d-~d-~d)'-[A, B, C] ].
corners(diagonal(A, B)) -->
    [ ' (on its diagonal ~d-~d)'-[A, B] ].
corners(none) -->
    [].

point(Point) -->
    { point_text(Point, Text) },
    [ '~w'-[Text] ].

triangle_text(S-p(P), Text) :-
    format(atom(Text), 'polygon ~d of segment ~d', [P, S]).
triangle_text(S-(A,B), Text) :-
    integer(B),
    format(atom(Text), '~d-~d of segment ~d', [A, B, S]).
triangle_text(S-(A,B,C), Text) :-
    format(atom(Text), 'triangle ~d-~d-~d of segment ~d', [A, B, C, S]).

%   A rational as people write it; of a long one, how long it is.

exact_word(X, Text) :-
    exact_text(X, Length, Text0),
    (   Length =< 60
    ->  Text = Text0
    ;   format(atom(Text), 'a fraction of ~d digits', [Length])
    ).

%   by_how_much_en(Difference, Text): of a seam beside another one.

by_how_much_en(Difference, Text) :-
    (   is_rounding(Difference, 1.0)
    ->  Text = 'as long'
    ;   Difference > 0
    ->  format(atom(Text), '~6g longer', [Difference])
    ;   Less is -Difference,
        format(atom(Text), '~6g shorter', [Less])
    ).

pieces_en(Pieces, Pieces, '') :-
    !.
pieces_en(Pieces, Before, Text) :-
    format(atom(Text), ', in ~d pieces instead of ~d', [Pieces, Before]).
