:- module(sg_primitive_en,
          [ primitive_en//2,            % +What, +Term
            comma_en//1,                % +Argument
            misshapen_en//1,            % +Term
            primitive_names//0,         %
            primitive_usage//1,         % +Term
            comma_forms/3,              % +Argument, -Point, -Apart
            surplus_numbers/2           % +Argument, +Types
          ]).
:- use_module('../csg/csg_term', [misshapen/2, near_operands/2]).
:- use_module(message_parts, [meant_en//1, shown_count/2]).
:- use_module('../primitive/primitive',
              [primitive/1, primitive_form/2, primitive_name/2]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3]).
/** <module> What is wrong with a primitive, in English.

primitive_ko.pl has the same heads in Korean
(tests/rules/primitive/primitive.plt).
*/

%!  primitive_names// is det.
%
%   The names of all primitives, in every language.

primitive_names -->
    { findall(Name, primitive(Name), Names),
      atomic_list_concat(Names, ', ', Text) },
    [ nl, '  ~w, at([Step, ...], Primitive), named(Name, Primitive)'-[Text] ].

%!  primitive_usage(+Term)// is det.
%
%   How the primitive Term is written, in every language.

primitive_usage(Term) -->
    { primitive_name(Term, Name),
      primitive_form(Name, Form) },
    !,
    [ nl, '  ~w'-[Form] ].
primitive_usage(_) -->
    [].

%!  misshapen_en(+Term)// is semidet.
%
%   What should stand in the place of Term, misshapen/2.

misshapen_en(Term) -->
    { misshapen(Term, Form) },
    [ '~p should look like ~w'-[Term, Form] ].

%!  primitive_en(+What, +Term)// is det.
%
%   The message for model_error(primitive(What, Term)).

primitive_en(unknown, Term) -->
    misshapen_en(Term),
    !.
primitive_en(unknown, Term) -->
    [ '~p is no primitive'-[Term] ],
    { near_operands(Term, Near) },
    meant_en(Near),
    [ nl, '  There are' ],
    primitive_names.
primitive_en(unknown_argument(A), Term) -->
    { primitive_name(Term, Name) },
    [ '~w has no argument ~p'-[Name, A] ],
    primitive_usage(Term).
primitive_en(missing(Argument), Term) -->
    { primitive_name(Term, Name) },
    [ '~w needs ~w(...)'-[Name, Argument] ],
    primitive_usage(Term).
primitive_en(twice(Argument), Term) -->
    { primitive_name(Term, Name) },
    [ '~w has ~w(...) twice'-[Name, Argument] ],
    primitive_usage(Term).
primitive_en(both(A, B), Term) -->
    { primitive_name(Term, Name) },
    [ '~w has both ~w(...) and ~w(...)'-[Name, A, B], nl,
      '  Keep one of them.' ].
primitive_en(wrong_argument(A, Types), Term) -->
    { compound_name_arity(A, Name, _),
      maplist(type_en, Types, Words),
      atomic_list_concat(Words, ', ', Text) },
    [ '~p should be ~w(~w)'-[A, Name, Text] ],
    comma_usage_en(A, Types),
    primitive_usage(Term).
primitive_en(wrong_item(Name, N, Item, Type), Term) -->
    { type_en(Type, Word) },
    [ 'item ~d of ~w(...) is ~p; it should be ~w'-[N, Name, Item, Word] ],
    primitive_usage(Term).
primitive_en(few_facets(N, Least), Term) -->
    { primitive_name(Term, Name) },
    [ 'this ~w needs ~d facets or more, not ~d'-[Name, Least, N], nl,
      '  A facet takes less than half a turn.' ].
primitive_en(few(Argument, N, Least), _) -->
    [ '~w(~d) is too few'-[Argument, N], nl,
      '  Give ~d or more.'-[Least] ].
primitive_en(odd(Argument, N), _) -->
    [ '~w(~d) is odd'-[Argument, N], nl,
      '  The widest circle lies between two bands: give an even number.' ].
primitive_en(too_many(N), Term) -->
    { shown_count(N, Count) },
    { primitive_name(Term, Name) },
    [ 'this ~w would have ~w facets in one way'-[Name, Count], nl,
      '  Give a larger tolerance, or fewer facets.' ].
primitive_en(too_many_vertices(N, Most), Term) -->
    { primitive_name(Term, Name) },
    { shown_count(N, Count) },
    [ 'this ~w would have ~w vertices; a primitive may have ~D'-
          [Name, Count, Most], nl,
      '  Give a larger tolerance, or fewer facets, bands or slices; or \c
       --limits facets=N.' ].
primitive_en(few_slices(N, Least), _) -->
    { shown_count(Least, Count) },
    [ 'this twist needs ~w slices or more, not ~d'-[Count, N], nl,
      '  A slice turns less than half a turn.' ].
primitive_en(no_step(Step), _) -->
    [ '~p is no step'-[Step], nl,
      '  There are translate(X, Y, Z), rotate(x, Degrees), \c
       rotate(axis(X, Y, Z), Degrees),', nl,
      '  rotate(from(X, Y, Z), to(X, Y, Z), Degrees), scale(F), \c
       scale(FX, FY, FZ), mirror(x),', nl,
      '  mirror(normal(X, Y, Z)) and matrix([[A, B, C, D], ...]) with three \c
       rows; none may make the model flat.' ].
primitive_en(no_list(Steps), _) -->
    [ 'at/2 needs a list of steps, not ~p'-[Steps], nl,
      '  Write at([Step, ...], Primitive).' ].
primitive_en(no_length, Term) -->
    [ '~p begins where it ends'-[Term], nl,
      '  Give two different points.' ].
primitive_en(flat_top, Term) -->
    [ 'one radius of top(...) is 0, the other is not: ~p'-[Term], nl,
      '  Give two above 0, or top(0) for an apex.' ].
primitive_en(sharp_turn(I), _) -->
    [ 'the axis turns back too sharply at its point ~d'-[I], nl,
      '  A mitre takes less than 168 degrees, a wye less than 170: put more \c
       points, or pieces.' ].
primitive_en(same_point(I), _) -->
    [ 'point ~d and the next one are in one place'-[I], nl,
      '  Leave one of them out.' ].
primitive_en(short_piece(I, Length, Least), _) -->
    [ 'piece ~d has an axis of ~6g; its mitres need more than ~6g'-
          [I, Length, Least], nl,
      '  Make it longer (an elbow: a larger radius or longer ends), or the \c
       diameter smaller.' ].
primitive_en(odd_facets(N), _) -->
    [ 'facets(~d) is odd'-[N], nl,
      '  The pieces of a wye meet on two generators: give an even number.' ].
primitive_en(inner_too_large, Term) -->
    [ 'inner(...) is not inside radius(...): ~p'-[Term], nl,
      '  Give a smaller one; with few facets the polygons must not meet.' ].
primitive_en(tube_too_large, Term) -->
    [ 'the torus goes through itself: ~p'-[Term], nl,
      '  tube(...) must be less than radius(...).' ].
primitive_en(too_large, _) -->
    [ 'the primitive is too large to compute with', nl,
      '  Choose other units.' ].
primitive_en(collapsed, _) -->
    [ 'vertices of the primitive fall together where it is placed', nl,
      '  It is too small for so far away: choose other units.' ].
primitive_en(few_points(Loop, N), _) -->
    { loop_en(Loop, Word) },
    [ '~w has ~d points'-[Word, N], nl,
      '  A polygon needs three or more.' ].
primitive_en(same_point(Loop, I), _) -->
    { loop_en(Loop, Word) },
    [ 'point ~d of ~w is the point before it'-[I, Word], nl,
      '  Write every point once; a polygon closes itself.' ].
primitive_en(crossing(Loop1, I, Loop2, J), _) -->
    { loop_en(Loop1, Word1),
      loop_en(Loop2, Word2) },
    [ 'the edge from point ~d of ~w meets the edge from point ~d of ~w'-
          [I, Word1, J, Word2], nl,
      '  The edges of a polygon may meet in their common points only.' ].
primitive_en(hole_outside(Loop), _) -->
    { loop_en(Loop, Word) },
    [ '~w is outside the outline'-[Word], nl,
      '  Move it inside, or make it a primitive of its own.' ].
primitive_en(hole_in_hole(Loop1, Loop2), _) -->
    { loop_en(Loop1, Word1),
      loop_en(Loop2, Word2) },
    [ '~w is inside ~w'-[Word1, Word2], nl,
      '  Leave it out: there is nothing to take away.' ].
primitive_en(across_axis(R, Z), _) -->
    [ 'the point [~w, ~w] of the outline is beyond the axis'-[R, Z], nl,
      '  Points are [R, Z] with R from 0: the distance from the axis.' ].
primitive_en(point_on_axis(Z), _) -->
    [ 'the outline touches the axis in a single point, at ~w, where its edge \c
       is level'-[Z], nl,
      '  Keep it clear of the axis, or let an edge run along the axis.' ].
primitive_en(corners_too_round(R), _) -->
    [ 'a rectangle has no room for corners of radius ~w'-[R], nl,
      '  The radius is half of its shorter side at most.' ].
primitive_en(not_convex(X, Y), _) -->
    [ 'the outline does not turn left at its corner [~w, ~w]'-[X, Y], nl,
      '  Outlines of transitions are convex, and have corners only where they \c
       turn.' ].
primitive_en(planes_cross, _) -->
    [ 'the plane of one outline goes through the other: there is no \c
       transition', nl,
      '  Give a smaller tilt(...), or a greater height(...).' ].
primitive_en(no_faces, _) -->
    [ 'there are no faces', nl,
      '  Give at least one.' ].
primitive_en(unknown_point(F, V), _) -->
    [ 'face ~d has the point ~d, which is not there'-[F, V], nl,
      '  Points are counted from 1.' ].
primitive_en(bad_face(F, Fault), _) -->
    [ 'face ~d is no polygon: '-[F] ],
    face_en(Fault).
primitive_en(edge_taken(F, V1, V2), _) -->
    [ 'face ~d has the edge from ~d to ~d, as a face before it'-[F, V1, V2],
      nl,
      '  Neighbours run along their edge in opposite ways: write all faces \c
       counter-clockwise, seen from outside.' ].
primitive_en(open_edge(V1, V2), _) -->
    [ 'no face has the edge from ~d to ~d: the polyhedron is open'-[V2, V1],
      nl,
      '  Add the face, or make it a sheet(...).' ].
primitive_en(inside_out, _) -->
    [ 'the polyhedron is inside out, or has no volume', nl,
      '  Write all faces counter-clockwise, seen from outside.' ].
primitive_en(patch_points(K, N), _) -->
    [ 'patch ~d has ~d points, not 16'-[K, N], nl,
      '  Four rows of four.' ].
primitive_en(patches_clash(K, L), _) -->
    [ 'patches ~d and ~d run along a common edge the same way'-[K, L], nl,
      '  Neighbours show the same side: turn one of them (write its rows \c
       backwards). Three patches at one border are not possible.' ].

%!  comma_en(+Argument)// is det.
%
%   Argument, of a primitive, has two numbers; a comma may be meant as the
%   decimal point.

comma_en(Argument) -->
    { comma_forms(Argument, Point, Apart) },
    [ '~p has two numbers; is a comma meant as the decimal point?'-[Argument],
      nl, '  Write ~p for one number, ~p for two.'-[Point, Apart] ].

%   comma_usage_en(A, Types): more numbers than there should be.

comma_usage_en(A, Types) -->
    (   { surplus_numbers(A, Types) }
    ->  [ nl, '  The decimal point is a point, as in 57.15.' ]
    ;   []
    ).

%!  comma_forms(+Argument, -Point, -Apart) is det.
%
%   Argument is radius(57, 15). Point is radius(57.15), with a decimal point;
%   Apart is radius(57.0, 15.0).

comma_forms(Argument, Point, Apart) :-
    Argument =.. [Name, Whole, Part],
    atomic_list_concat([Whole, '.', Part], Text),
    atom_number(Text, Number),
    Point =.. [Name, Number],
    A is float(Whole),
    B is float(Part),
    Apart =.. [Name, A, B].

%!  surplus_numbers(+Argument, +Types) is semidet.
%
%   Argument has more numbers than Types, two whole ones side by side.

surplus_numbers(Argument, Types) :-
    compound(Argument),
    compound_name_arguments(Argument, _, Values),
    length(Values, N),
    length(Types, Wanted),
    N > Wanted,
    append(_, [A, B|_], Values),
    integer(A),
    integer(B),
    B >= 0,
    !.

face_en(list) -->
    [ 'a jump leads nowhere', nl,
      '  A negative number follows a closed loop and begins the next one.' ].
face_en(edges(N)) -->
    [ 'it has ~d edges'-[N], nl, '  A polygon needs three or more.' ].
face_en(no_edge(V)) -->
    [ 'it goes from ~d to itself'-[V], nl, '  Write the point once.' ].
face_en(twice(V1, V2)) -->
    [ 'it goes from ~d to ~d twice'-[V1, V2], nl,
      '  Write every step once.' ].
face_en(open(V)) -->
    [ 'it does not close at ~d'-[V], nl,
      '  After a jump write the first point of the loop again.' ].

loop_en(outline, 'the outline').
loop_en(hole(N), Word) :-
    format(atom(Word), 'hole ~d', [N]).

type_en(length, 'a length above 0').
type_en(radius, 'a length from 0').
type_en(facets, 'a whole number from 3 to 1000000').
type_en(count, 'a whole number from 1 to 1000000').
type_en(factor, 'a factor from 0').
type_en(number, 'a number').
type_en(flag, 'true or false').
type_en(turn, 'an angle above 0, to 360').
type_en(outline, 'circle(R), ellipse(A, B), rectangle(A, B), \c
                  rectangle(A, B, R) or polygon([[X, Y], ...])').
type_en(points2, 'a list of points [X, Y]').
type_en(points3, 'a list of points [X, Y, Z]').
type_en(loops2, 'a list of lists of points [X, Y]').
type_en(faces, 'a list of lists of numbers of points').
type_en(point2, 'a point [X, Y]').
type_en(point3, 'a point [X, Y, Z]').
type_en(face, 'a list of numbers of points, from 1').
