:- encoding(utf8).
:- module(sg_explain_words,
          [ statement_keys/2,           % ?Name, ?Keys
            other_origin/1,             % +Origin
            segment_word/2,             % +S, -Word
            segment_word_ko/2,          % +S, -Word
            polygon_word/3,             % +S, +P, -Word
            face_word/2,                % +Face, -Word
            bytes_word/2,               % +Bytes, -Word
            in_order/4,                 % +Seat1, +Seat2, -Small, -Large
            exact_text/3,               % +X, -Length, -Text
            point_text/2                % +Point, -Text
          ]).
:- use_module('../development/polygon_name', [polygon_name/3]).
:- use_module('../store', [segment/3]).
:- use_module(library(terms), [mapargs/3]).

/** <module> The statements of an explanation.

What explain.pl says, statement by statement, with the names of its parts as
JSON has them. Each has a clause in explain_en.pl and in explain_ko.pl.
*/

%!  statement_keys(?Name, ?Keys) is nondet.
%
%   True when the statement Name has the parts Keys, in this order.

statement_keys(line, [line, segment1, polygon1, segment2, polygon2]).
statement_keys(touch, [line, segment1, polygon1, segment2, polygon2]).
statement_keys(point, [end, point, segment1, vertex1, segment2, vertex2]).
statement_keys(contact, [kind, seat1, seat2]).
statement_keys(made, [origin]).
statement_keys(at, [segment, vertex, point]).
statement_keys(side, [segment, vertex, point, side, triangle]).
statement_keys(exact, [x, y, z]).
statement_keys(also, [segment, vertex, place]).
statement_keys(not_merged, [line, rules]).
statement_keys(made_to_touch, []).
statement_keys(touching, [count]).
statement_keys(pieces, [count, rules]).
statement_keys(piece, [number, triangle1, triangle2]).
statement_keys(chain, [chain, kind, number, count]).
statement_keys(chain_head, [chain, kind, segment1, segment2, count, length]).
statement_keys(derived, [segment, vertex, point, place]).
statement_keys(moved, [segment, vertex, point]).
statement_keys(was_at, [segment, vertex, point]).
statement_keys(original, [segment, vertex, point]).
statement_keys(vertex_lines, [lines]).
statement_keys(vertex_of, [segment, vertex]).
statement_keys(lies_on, [segment, feature]).
statement_keys(edge, [segment, edge, start, end]).
statement_keys(edge_whole, [segment, edge]).
statement_keys(edge_near, [segment, edge]).
statement_keys(edge_of_line, [line]).
statement_keys(part_of, [segment, edge, start, end]).
statement_keys(edge_polygons, [segment, polygons]).
statement_keys(edge_divided, [segment, edge, start, end]).
statement_keys(edge_part, [segment, edge, start, end]).
statement_keys(segments, [segment1, segment2]).
statement_keys(lines_between, [count]).
statement_keys(same_segment, []).
statement_keys(refused, [segment1, segment2, rules]).
statement_keys(no_common_piece, []).
statement_keys(pair, [segment1, polygon1, segment2, polygon2]).
statement_keys(pair_lines, [lines]).
statement_keys(of_line, [line]).
statement_keys(boxes_apart, [axis, high, low, lower]).
statement_keys(no_line, []).
statement_keys(inside_faces, []).
statement_keys(elsewhere, [line, segment1, polygon1, segment2, polygon2]).
statement_keys(triangles_apart, [count]).
statement_keys(triangles, [reason, count]).
statement_keys(example, [triangle1, triangle2]).
statement_keys(common, [kind, end1, end2]).
statement_keys(piece, [segment, polygon]).
statement_keys(piece_of, [segment, polygon, sense]).
statement_keys(polygon_in, [segment, polygon, node]).
statement_keys(became, [segment, polygon, sense]).
statement_keys(triangles_of, [count, verdict]).
statement_keys(witness, [point]).
statement_keys(round, [segment, below, above]).
statement_keys(verdict, [verdict, rules]).
statement_keys(hidden_line, [segment, edge, start, end]).
statement_keys(outline_piece, [segment, edge, polygon, triangle]).
statement_keys(behind_fold, [from]).
statement_keys(substitute_outline, []).
statement_keys(turned_away, [segment, polygon, from, to]).
statement_keys(same_line, [segment1, edge1, segment2, edge2]).
statement_keys(line_role, [role]).
statement_keys(not_drawn, [role, lines]).
statement_keys(faces_bend, [degrees]).
statement_keys(end_on, []).
statement_keys(backs, [segment, count]).
statement_keys(hidden_part, [from, to]).
statement_keys(hiding_face, [segment, polygon, from, to, distance]).
statement_keys(surface_goes_on, [segment, polygon, from, to]).
statement_keys(ends_with_line, [which, at]).
statement_keys(ends_at_edge, [which, at, segment, edge, start, end]).
statement_keys(ends_at_outline, [which, at, segment, edge]).
statement_keys(ends_in_face, [which, at, segment, polygon]).
statement_keys(visible_part, [from, to]).
statement_keys(nothing_over, []).
statement_keys(nowhere_visible, []).
statement_keys(face_behind, [segment, polygon, from, to, distance]).
statement_keys(line_in_face, [segment, polygon]).
statement_keys(let_through,
               [segment, polygon, from, to, decision, rules]).
statement_keys(drawn_instead, [from, to, visibility, segment, edge, role]).
statement_keys(seam_edge,
               [segment, edge, partner, polygon1, polygon2, length]).
statement_keys(fold_edge,
               [segment, edge, partner, polygon1, polygon2, length, angle]).
statement_keys(border_edge, [segment, edge, polygon]).
statement_keys(line_in_polygon, [segment, edge, partner, polygon]).
statement_keys(joined_already, [count, edge, length]).
statement_keys(fold_on_the_way, [edge, polygon1, polygon2, length]).
statement_keys(joined_in_order, [rules]).
statement_keys(folds_exchanged, []).
statement_keys(cut_instead, [edge, difference]).
statement_keys(held_by_kept, []).
statement_keys(not_tried, []).
statement_keys(kept_instead, [difference, pieces, pieces_before]).
statement_keys(cut_here, [difference, pieces, pieces_before]).
statement_keys(cannot_be_kept, [segment, polygon1, polygon2]).
statement_keys(would_overlap, [segment, polygon1, polygon2]).
statement_keys(would_overlap_instead, [segment, edge, polygon1, polygon2]).
statement_keys(cut_by_wish, []).
statement_keys(could_be_joined, []).
statement_keys(cut_open, [part]).
statement_keys(unrolled, [part]).
statement_keys(kept_by_wish, []).
statement_keys(may_not_join, [segment, edge, rules]).
statement_keys(no_length, []).
statement_keys(too_short, []).
statement_keys(changed_since, []).
statement_keys(pattern_piece, [segment, piece, polygons, pieces]).
statement_keys(seams_out, [count]).
statement_keys(no_seam_out, []).

statement_keys(pixel, [x, y, bytes]).
statement_keys(seen_part, [percent, face, leaf, segment, name, root]).
statement_keys(background_part, [percent, colour]).
statement_keys(seen_place, [point]).
statement_keys(placed_as, [segment]).
statement_keys(operand_of, [operand, count, operation, segment, away]).
statement_keys(inner_side, []).
statement_keys(owner, [rules]).
statement_keys(not_owner, [face, leaf, segment, name]).
statement_keys(passed, [way, face, leaf, segment, name, before]).
statement_keys(outside_all, [operation, segment, count, root]).
statement_keys(taken_away, [operand, operation, segment, root]).
statement_keys(outside_leaf, [leaf, segment, name, root]).
statement_keys(lets_through, [root]).
statement_keys(let_through, [root,rules]).
statement_keys(cut_away, [root]).
statement_keys(see_through, [opacity]).
statement_keys(shine, [strength, power, light]).
statement_keys(hatched, []).
statement_keys(hidden_face, [face, leaf, segment, name, root, behind]).
statement_keys(look_by_rule, [colour, rules]).
statement_keys(look_of, [segment, colour]).
statement_keys(look_of_palette, [colour, by]).
statement_keys(normal, [right, up, towards]).
statement_keys(tone, [tone, rules]).
statement_keys(light_from_everywhere, [strength]).
statement_keys(light_stopped, [percent, face, leaf, segment, name, root]).
statement_keys(light_from, [right, up, towards, factor, share]).
statement_keys(ramp, [shade, rules, colour]).
statement_keys(not_in_picture, [segment, kind]).
statement_keys(seen_after_all, [segment, dots, x, y]).
statement_keys(unseen, [segment]).
statement_keys(unseen_where, [count, x, y]).
statement_keys(hidden_by_leaf, [leaf, segment, name, root]).
statement_keys(owned_by_face, [face, leaf, segment, name, root, rules]).
statement_keys(buried_in, [root]).
statement_keys(back_side, [root]).
statement_keys(thinner_than_a_dot, []).
statement_keys(out_of_the_picture, []).

statement_keys(parameter, [name, value]).
statement_keys(parameter_formula, [formula]).
statement_keys(parameter_set, [default]).
statement_keys(parameter_range, [minimum, maximum, step]).
statement_keys(parameter_text, [en, ko]).
statement_keys(parameter_unused, []).
statement_keys(used_by_parameter, [name, formula]).
statement_keys(used_by_row, [fact]).
statement_keys(segment, [segment, kind]).
statement_keys(no_size_from_parameter, []).
statement_keys(vertex_place, [segment, vertex, place]).
statement_keys(size, [value, formula]).
statement_keys(glued_vertex, [segment, vertex, point]).
statement_keys(glued_edge, [segment, edge, start, end]).
statement_keys(glued_polygon, [segment, polygon]).
statement_keys(was_vertex, [segment, vertex, moved]).
statement_keys(was_polygon, [segment, polygon, sense]).
statement_keys(cut_vertex, [segments]).
statement_keys(point_loop, [polygon]).
statement_keys(in_region, [region]).
statement_keys(disk, [disk, edges, polygons]).
statement_keys(disks_lie, [disk1, disk2, relation, by]).
statement_keys(page, [polygon, region]).
statement_keys(between, [below, above]).
statement_keys(inner_loop, [vertices]).
statement_keys(region, [segment, region, role, volume]).
statement_keys(inner_point, [point]).
statement_keys(inside, [segment]).
statement_keys(beyond, [region, faces, area]).
statement_keys(laminar, [polygon]).
statement_keys(wire_in, [edge]).
statement_keys(is_glued, [segment1, polygon1, segment2, polygon2]).
statement_keys(not_glued, [segment1, polygon1, segment2, polygon2]).
statement_keys(kept_apart, [by]).
statement_keys(in_common, [vertices]).
statement_keys(gap, [distance, point1, point2]).
statement_keys(plane_angle, [angle]).

%!  other_origin(+Origin) is semidet.
%
%   True when Origin, of a vertex, is none that this program makes: a model file
%   or a program has it.

other_origin(Origin) :-
    \+ made_origin(Origin).

made_origin(v(_, _)).
made_origin(on(_, _)).
made_origin(lpi(_, _)).
made_origin(ll(_, _)).
made_origin(tpi(_, _, _)).
made_origin(near(_)).

%!  segment_word(+S, -Word) is det.
%!  segment_word_ko(+S, -Word) is det.
%
%   Word is the name of segment S, or of the primitive it was made from, in
%   parentheses and with a space before; '' if it has none. Of one that another
%   segment was placed as it says so, in English or in Korean.

segment_word(S, Word) :-
    named_word(S, 'segment ~d, placed', Word).

segment_word_ko(S, Word) :-
    named_word(S, '배치된 세그먼트 ~d', Word).

named_word(S, Placed, Word) :-
    (   segment(S, _, Name0),
        plain_name(Name0, Placed, Name),
        Name \== ''
    ->  format(atom(Word), ' (~w)', [Name])
    ;   Word = ''
    ).

plain_name(named(Name, _), _, Name) :-
    !.
plain_name(at(_, Name0), Placed, Name) :-
    !,
    plain_name(Name0, Placed, Name).
plain_name(S, Placed, Name) :-
    integer(S),
    !,
    format(atom(Name), Placed, [S]).
plain_name(Name0, _, Name) :-
    (   compound(Name0)
    ->  functor(Name0, Name, _)
    ;   Name = Name0
    ).

%!  polygon_word(+S, +P, -Word) is det.
%
%   Word is the number of polygon P of segment S and, in parentheses, what it is
%   of the primitive that S was made from, if it is one.

polygon_word(S, P, Word) :-
    polygon_name(S, P, Name),
    face_word(face(P, Name), Word).

%!  face_word(+Face, -Word) is det.
%
%   Likewise of face(P, Name), Name as of polygon_name/3.

face_word(face(P, Name0), Word) :-
    (   Name0 == P
    ->  Word = P
    ;   plain_numbers(Name0, Name),
        format(atom(Word), '~w (~w)', [P, Name])
    ).

%!  bytes_word(+Bytes, -Word) is det.
%
%   Word is rgb(R,G,B) or rgba(R,G,B,A) of a list of bytes.

bytes_word(Bytes, Word) :-
    atomic_list_concat(Bytes, ', ', Text),
    (   Bytes = [_,_,_]
    ->  format(atom(Word), 'rgb(~w)', [Text])
    ;   format(atom(Word), 'rgba(~w)', [Text])
    ).

%   plain_numbers(Term0, Term): with 15 instead of 15.0.

plain_numbers(Term0, Term) :-
    (   float(Term0),
        Term0 =:= truncate(Term0)
    ->  Term is truncate(Term0)
    ;   compound(Term0)
    ->  mapargs(plain_numbers, Term0, Term)
    ;   Term = Term0
    ).

%!  in_order(+Seat1, +Seat2, -Small, -Large) is det.
%
%   The two seats, that on the smaller feature first: a vertex, an edge, a
%   face.

in_order(Seat1, Seat2, Small, Large) :-
    arg(3, Seat1, Place1),
    arg(3, Seat2, Place2),
    place_size(Place1, Size1),
    place_size(Place2, Size2),
    (   Size1 =< Size2
    ->  Small = Seat1,
        Large = Seat2
    ;   Small = Seat2,
        Large = Seat1
    ).

place_size(vertex(_), 0).
place_size(edge(_, _), 1).
place_size(face(_, _), 2).

%!  exact_text(+X, -Length, -Text) is det.
%
%   Text is the rational X as people write it, Length characters.

exact_text(X, Length, Text) :-
    rational(X, N, D),
    (   D =:= 1
    ->  format(atom(Text), '~d', [N])
    ;   format(atom(Text), '~d/~d', [N, D])
    ),
    atom_length(Text, Length).

%!  point_text(+Point, -Text) is det.
%
%   Text is point(X,Y,Z) to 15 digits, for people.

point_text(point(X,Y,Z), Text) :-
    format(atom(Text), '(~15g, ~15g, ~15g)', [X, Y, Z]).
