:- module(sg_primitive,
          [ primitive/1,                % ?Name
            primitive_form/2,           % ?Name, -Form
            primitive_numbers/3,        % ?Name, ?Argument, -Types
            primitive_name/2,           % +Term, -Name
            is_primitive/1,             % @Term
            comma_argument/2,           % +Term, -Argument
            primitive_kind/2,           % +Term, -Kind
            primitive_shape/4,          % +Term, -Kind, -Points, -Chains
            primitive_faces/3,          % +Term, -Whats, -Surfaces
            primitive_parts/3           % +Term, -Parts, -Surfaces
          ]).
:- use_module(bezier, [bezier_shape/2]).
:- use_module('../kernel', [has_part/2]).
:- use_module(placing,
              [ motion_mirrors/1, motion_stretch/2, moved/3, moved_vector/3,
                step_motion/2
              ]).
:- use_module(primitive_argument,
              [given/3, given_values/4, primitive_error/2]).
:- use_module(primitive_extrusion,
              [prism_shape/2, pyramid_shape/2, straight_sides/2]).
:- use_module(primitive_flat,
              [ box_shape/2, line_shape/2, polyhedron_shape/2,
                rectangle_shape/2, sheet_shape/2
              ]).
:- use_module(primitive_globe,
              [ egg_shape/2, globe_parts/4, hemisphere_shape/2, sphere_shape/2,
                torus_shape/2
              ]).
:- use_module(primitive_pipe,
              [elbow_shape/2, mitred_pipe_shape/2, wye_shape/2]).
:- use_module(primitive_round,
              [ circle_shape/2, cone_shape/2, cylinder_shape/2,
                hollow_cylinder_shape/2
              ]).
:- use_module(primitive_transition,
              [open_transition_shape/2, transition_shape/2]).
:- use_module(primitive_turning, [turning_shape/2]).
:- use_module(shape, [loops_vertex_list/2, mirrored_faces/2]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2, put_assoc/4]).
:- use_module(library(lists),
              [append/3, last/2, max_list/2, member/2, nth1/3, same_length/2]).
/** <module> Primitives: the table of them, and how they are placed.

A primitive is a term with named arguments, in any order (the table below;
docs/model_files.md has an example of each), and

    at(Steps, Primitive)        placed: placing.pl
    named(Name, Primitive)      with a name for rules

It stands on the plane z = 0, its base centred on the z axis, and rises along
+z; sphere, egg and torus have their centre in the origin; prism, turning,
polyhedron, sheet and bezier are where their points are. The first corner of
what is round lies on the +x axis.

Solids are closed, of true polygons (a cap is one polygon), counter-clockwise
seen from outside (PL-2, PL-3), also when mirrored. The same term gives the
same coordinates on every machine (angle.pl).

What is round is divided by facets(N), or by tolerance(T): no farther than T
from the smooth surface, in units of the model, after placing.

To add a primitive: a row of the table, and a maker (shape.pl). Its arguments
are typed in primitive_argument.pl; its faces are named in primitive_face.pl.

@see [DV] row DV-2
*/

%   primitive_row(Name, Kind, Arguments, Maker, Form)

primitive_row(line, curve,
              [ argument(from, [[number, number, number]], needed),
                argument(to, [[number, number, number]], needed)
              ],
              line_shape, 'line(from(X, Y, Z), to(X, Y, Z))').
primitive_row(rectangle, surface,
              [ argument(size, [[length, length]], needed) ],
              rectangle_shape, 'rectangle(size(A, B))').
primitive_row(circle, surface,
              [ argument(radius, [[length]], needed) | Fineness ],
              circle_shape, 'circle(radius(R), facets(N))') :-
    fineness(Fineness).
primitive_row(ellipse, surface,
              [ argument(radius, [[length, length]], needed) | Fineness ],
              circle_shape, 'ellipse(radius(A, B), facets(N))') :-
    fineness(Fineness).
primitive_row(box, solid,
              [ argument(size, [[length, length, length]], needed) ],
              box_shape, 'box(size(A, B, C))').
primitive_row(cylinder, solid,
              [ argument(radius, [[length], [length, length]], needed),
                argument(height, [[length]], needed),
                Shift | Fineness
              ],
              cylinder_shape,
              'cylinder(radius(R), height(H), facets(N), shift(X, Y)), \c
               or radius(A, B)') :-
    shift(Shift),
    fineness(Fineness).
primitive_row(hollow_cylinder, solid,
              [ argument(radius, [[length], [length, length]], needed),
                argument(inner, [[length], [length, length]], needed),
                argument(height, [[length]], needed),
                Shift | Fineness
              ],
              hollow_cylinder_shape,
              'hollow_cylinder(radius(R), inner(R2), height(H), facets(N), \c
               shift(X, Y)), or radius(A, B), inner(A2, B2)') :-
    shift(Shift),
    fineness(Fineness).
primitive_row(cone, solid,
              [ argument(radius, [[length], [length, length]], needed),
                argument(top, [[radius], [radius, radius]], [0.0]),
                argument(height, [[length]], needed),
                Shift | Fineness
              ],
              cone_shape,
              'cone(radius(R), top(R2), height(H), facets(N), shift(X, Y)), \c
               or radius(A, B), top(A2, B2)') :-
    shift(Shift),
    fineness(Fineness).
primitive_row(sphere, solid, [Radius, Bands | Fineness],
              sphere_shape,
              'sphere(radius(R), facets(N), bands(M)), or radius(A, B, C)') :-
    globe(Radius, Bands, Fineness).
primitive_row(egg, solid,
              [ argument(radius, [[length]], needed),
                argument(up, [[length]], needed),
                argument(down, [[length]], needed),
                Bands | Fineness
              ],
              egg_shape,
              'egg(radius(R), up(H1), down(H2), facets(N), bands(M))') :-
    globe(_, Bands, Fineness).
primitive_row(hemisphere, solid, [Radius, Bands | Fineness],
              hemisphere_shape,
              'hemisphere(radius(R), facets(N), bands(M)), \c
               or radius(A, B, C)') :-
    globe(Radius, Bands, Fineness).
primitive_row(torus, solid,
              [ argument(radius, [[length]], needed),
                argument(tube, [[length]], needed),
                argument(sides, [[facets]], none) | Fineness
              ],
              torus_shape,
              'torus(radius(R), tube(R2), facets(N), sides(M))') :-
    fineness(Fineness).
primitive_row(pyramid, solid,
              [ argument(base, [[length, length]], none),
                argument(outline, [[points2]], none),
                argument(holes, [[loops2]], [[]]),
                argument(height, [[length]], needed),
                Shift, Smooth
              ],
              pyramid_shape,
              'pyramid(base(A, B), height(H), shift(X, Y)), \c
               or outline([[X, Y], ...]), holes([[[X, Y], ...], ...]), \c
               smooth(true)') :-
    shift(Shift),
    smooth(Smooth).
primitive_row(prism, solid,
              [ argument(outline, [[points2]], needed),
                argument(holes, [[loops2]], [[]]),
                argument(height, [[length]], needed),
                argument(twist, [[number]], [0.0]),
                argument(scale, [[factor], [factor, factor]], [1.0]),
                argument(slices, [[count]], none),
                Shift, Smooth
              ],
              prism_shape,
              'prism(outline([[X, Y], ...]), holes([[[X, Y], ...], ...]), \c
               height(H), shift(X, Y), twist(Degrees), scale(FX, FY), \c
               slices(N), smooth(true))') :-
    shift(Shift),
    smooth(Smooth).
primitive_row(turning, solid,
              [ argument(outline, [[points2]], needed),
                argument(holes, [[loops2]], [[]]),
                argument(angle, [[turn]], [360.0]),
                argument(facets, [[count]], none),
                argument(tolerance, [[length]], none),
                Smooth
              ],
              turning_shape,
              'turning(outline([[R, Z], ...]), holes([[[R, Z], ...], ...]), \c
               angle(Degrees), facets(N), smooth(true))') :-
    smooth(Smooth).
primitive_row(transition, solid, Arguments, transition_shape,
              'transition(base(Outline), top(Outline), height(H), \c
               shift(X, Y), tilt(Degrees, Towards), turn(Degrees), \c
               facets(N), divided(M)), Outline one of circle(R), \c
               ellipse(A, B), rectangle(A, B), rectangle(A, B, R), \c
               polygon([[X, Y], ...])') :-
    transition_arguments(Arguments).
primitive_row(open_transition, surface, Arguments, open_transition_shape,
              'open_transition(...), as transition(...)') :-
    transition_arguments(Arguments).
primitive_row(polyhedron, solid, Arguments,
              polyhedron_shape,
              'polyhedron(points([[X, Y, Z], ...]), faces([[1, 2, 3], ...]), \c
               smooth(true))') :-
    points_and_faces(Arguments).
primitive_row(sheet, surface, Arguments,
              sheet_shape,
              'sheet(points([[X, Y, Z], ...]), faces([[1, 2, 3], ...]), \c
               smooth(true))') :-
    points_and_faces(Arguments).
primitive_row(bezier, surface,
              [ argument(points, [[points3]], needed),
                argument(patches, [[faces]], none),
                argument(facets, [[count]], none),
                argument(tolerance, [[length]], none)
              ],
              bezier_shape,
              'bezier(points([[X, Y, Z], ...]), patches([[1, ..., 16], ...]), \c
               facets(N))').

primitive_row(elbow, solid,
              [ argument(diameter, [[length]], needed),
                argument(radius, [[length]], needed),
                argument(pieces, [[count]], [4]),
                argument(angle, [[turn]], [90.0]),
                argument(ends, [[radius]], [0.0]) | Fineness
              ],
              elbow_shape,
              'elbow(diameter(D), radius(R), pieces(N), angle(A), ends(L), \c
               facets(F))') :-
    fineness(Fineness).
primitive_row(mitred_pipe, solid,
              [ argument(diameter, [[length]], needed),
                argument(through, [[points3]], needed) | Fineness
              ],
              mitred_pipe_shape,
              'mitred_pipe(diameter(D), through([[X, Y, Z], ...]), \c
               facets(F))') :-
    fineness(Fineness).
primitive_row(wye, solid,
              [ argument(diameter, [[length]], needed),
                argument(angle, [[turn]], [60.0]),
                argument(stem, [[length]], needed),
                argument(legs, [[length]], needed) | Fineness
              ],
              wye_shape,
              'wye(diameter(D), angle(A), stem(L1), legs(L2), facets(F))') :-
    fineness(Fineness).

fineness([ argument(facets, [[facets]], none),
           argument(tolerance, [[length]], none)
         ]).

shift(argument(shift, [[number, number]], [0.0, 0.0])).

smooth(argument(smooth, [[flag]], [false])).

globe(argument(radius, [[length], [length, length, length]], needed),
      argument(bands, [[count]], none), Fineness) :-
    fineness(Fineness).

transition_arguments([ argument(base, [[outline]], needed),
                       argument(top, [[outline]], needed),
                       argument(height, [[length]], needed),
                       argument(tilt, [[number], [number, number]], [0.0]),
                       argument(turn, [[number]], [0.0]),
                       argument(divided, [[count]], [1]),
                       argument(as, [[outline,outline]], none),
                       Shift | Fineness
                     ]) :-
    shift(Shift),
    fineness(Fineness).

points_and_faces([ argument(points, [[points3]], needed),
                   argument(faces, [[faces]], needed),
                   Smooth
                 ]) :-
    smooth(Smooth).

%!  primitive(?Name) is nondet.
%
%   True when Name is the functor name of a primitive.

primitive(Name) :-
    primitive_row(Name, _, _, _, _).

%!  primitive_form(?Name, -Form) is nondet.
%
%   Form is an atom that says how the primitive Name is written.

primitive_form(Name, Form) :-
    primitive_row(Name, _, _, _, Form).

%!  primitive_numbers(?Name, ?Argument, -Types) is nondet.
%
%   The primitive Name has Argument; Types are those (primitive_argument.pl) of
%   the longest list of values that it may have.

primitive_numbers(Name, Argument, Types) :-
    primitive_row(Name, _, Arguments, _, _),
    member(argument(Argument, Forms, _), Arguments),
    last(Forms, Types).

%!  primitive_name(+Term, -Name) is det.
%
%   Name is the functor name of the primitive that Term places or names, or of
%   Term.

primitive_name(Term, Name) :-
    (   ( Term = named(_, Inner) ; Term = at(_, Inner) )
    ->  primitive_name(Inner, Name)
    ;   compound(Term)
    ->  compound_name_arity(Term, Name, _)
    ;   Name = Term
    ).

%!  is_primitive(@Term) is semidet.
%
%   True when Term looks like a primitive: at/2, named/2, or a compound with the
%   name of one. Its arguments may still be wrong.

is_primitive(Term) :-
    compound(Term),
    compound_name_arity(Term, Name, Arity),
    (   memberchk(Name/Arity, [at/2, named/2])
    ->  true
    ;   primitive(Name)
    ->  true
    ).

%!  comma_argument(+Term, -Argument) is nondet.
%
%   A primitive in Term, a primitive or a tree, has the Argument radius(57, 15)
%   or such: two whole lengths where one would do as well, so 57.15 may be meant
%   and a comma be written for the point. Angles and factors are left alone.

comma_argument(Term, Argument) :-
    comma_parts(Parts),
    has_part(Term, Parts),
    comma_argument_in(Term, Argument).

%   comma_parts(Parts): all such arguments that there are, as of has_part/2.

:- dynamic comma_parts_/1.

comma_parts(Parts) :-
    comma_parts_(Parts),
    !.
comma_parts(Parts) :-
    findall(Of/2,
            ( primitive_row(_, _, Wanted, _, _), comma_form(Wanted, Of) ),
            List0),
    sort(List0, List),
    Parts =.. [parts|List],
    assertz(comma_parts_(Parts)).

comma_form(Wanted, Of) :-
    member(argument(Of, Forms, _), Wanted),
    member(Length, [length,radius]),
    memberchk([Length], Forms),
    memberchk([Length, Length], Forms).

comma_argument_in(Term, Argument) :-
    compound(Term),
    compound_name_arguments(Term, Name, Arguments),
    (   primitive_row(Name, _, Wanted, _, _)
    ->  member(Argument, Arguments),
        compound(Argument),
        compound_name_arguments(Argument, Of, [Whole, Part]),
        integer(Whole),
        integer(Part),
        Part >= 0,
        comma_form(Wanted, Of)
    ;   member(Inner, Arguments),
        comma_argument_in(Inner, Argument)
    ).

%!  primitive_kind(+Term, -Kind) is det.
%
%   Kind is that of the primitive Term, whose arguments are right, as of
%   primitive_shape/4, of which nothing is made.
%
%   @error as primitive_shape/4, but of what placing it does to its points

primitive_kind(Term, Kind) :-
    known_parts(Term, Kind, _, _).

%!  primitive_shape(+Term, -Kind, -Points, -Chains) is det.
%
%   True when the primitive Term is a segment of this Kind (`solid`, `surface`
%   or `curve`) with these Points, a list of point(X, Y, Z) of floats that
%   become the vertices 1, 2, ... Chains are vertex lists: polygons as in
%   PL-2, or, of a curve, the open chains of its edges.
%
%   @error model_error(primitive(What, Term)), where What is
%     unknown, no_step(Step), no_list(Steps), too_large, collapsed, or what the
%     modules of arguments and makers raise

primitive_shape(Term, Kind, Points, Chains) :-
    made(Term, Kind, Motions, shape(Points0, Faces0, _)),
    catch(maplist(moved(Motions), Points0, Points),
          error(evaluation_error(_), _), primitive_error(too_large, Term)),
    still_distinct(Points0, Points, Term),
    (   Kind \== curve,
        motion_mirrors(Motions)
    ->  mirrored_faces(Faces0, Faces)
    ;   Faces = Faces0
    ),
    maplist(face_list, Faces, Chains).

face_list(face(_, Loops), List) :-
    loops_vertex_list(Loops, List).

%   made(Term, Kind, Motions, Shape): before placing.

made(Term, Kind, Motions, Shape) :-
    placed(Term, Primitive, [], Motions),
    stretched(Primitive, Motions, Stretch),
    shaped(Primitive, Kind, Maker, Stretch, Given),
    catch(call(Maker, Given, Shape),
          error(evaluation_error(_), _), primitive_error(too_large, Term)).

%   shaped(Primitive, Kind, Maker, Stretch, Given): what Maker is given.

shaped(Primitive, Kind, Maker, Stretch, given(Primitive, Stretch, Values)) :-
    compound_name_arguments(Primitive, Name, Given),
    primitive_row(Name, Kind, Wanted, Maker, _),
    !,
    given_values(Given, Wanted, Primitive, Values).

stretched(Primitive, Motions, Stretch) :-
    catch(motion_stretch(Motions, Stretch),
          error(evaluation_error(_), _),
          primitive_error(too_large, Primitive)).

%   placed(Term, Primitive, Outer, Motions): at/2 and named/2 taken off; the
%   inner steps first, then Outer.

placed(Term, _, _, _) :-
    \+ is_primitive(Term),
    !,
    primitive_error(unknown, Term).
placed(at(Steps, Inner), Primitive, Outer0, Motions) :-
    !,
    (   is_list(Steps)
    ->  true
    ;   primitive_error(no_list(Steps), at(Steps, Inner))
    ),
    maplist(known_step, Steps, Own),
    append(Own, Outer0, Outer),
    placed(Inner, Primitive, Outer, Motions).
placed(named(_, Inner), Primitive, Outer, Motions) :-
    !,
    placed(Inner, Primitive, Outer, Motions).
placed(Primitive, Primitive, Motions, Motions).

known_step(Step, Motion) :-
    (   step_motion(Step, Motion0)
    ->  Motion = Motion0
    ;   primitive_error(no_step(Step), Step)
    ).

%   still_distinct(Points0, Points, Term): vertices that were apart are not in
%   one place because they are so small, or so far away.

still_distinct(Points0, Points, Term) :-
    sort(Points0, Set0),
    sort(Points, Set),
    (   same_length(Set0, Set)
    ->  true
    ;   primitive_error(collapsed, Term)
    ).

%!  primitive_faces(+Term, -Whats, -Surfaces) is det.
%
%   Whats are what the polygons 1, 2, ... of the primitive Term are, Surfaces
%   the Part-Surface of its smooth surfaces, as placed (primitive_face.pl).
%
%   @error as primitive_shape/4

primitive_faces(Term, Whats, Surfaces) :-
    made(Term, _, Motions, shape(_, Faces, Surfaces0)),
    maplist(face_what, Faces, Whats),
    maplist(moved_surface(Motions), Surfaces0, Surfaces).

face_what(face(What, _), What).

%!  primitive_parts(+Term, -Parts, -Surfaces) is det.
%
%   Parts are the polygons of the primitive Term, in order: part(N, flat) are N
%   faces, part(N, wall(I)) N of a face or wall, I, that is several polygons,
%   part(N, divided) N of what was divided before (an argument smooth(true)),
%   and part(N, curved(Part, Turn)) N facets of one of Surfaces, Part-Surface as
%   placed, that are Turn degrees of it wide. Surfaces that were turned from a
%   divided outline are turned(Surface). What was made last is remembered: most
%   terms come again with every picture.
%
%   @error as primitive_shape/4

primitive_parts(Term, Parts, Surfaces) :-
    known_parts(Term, _, Parts, Surfaces).

known_parts(Term, Kind, Parts, Surfaces) :-
    placed(Term, Primitive, [], Motions),
    stretched(Primitive, Motions, Stretch),
    remembered_parts(Primitive-Stretch, Kind, Parts, Surfaces0),
    maplist(moved_surface(Motions), Surfaces0, Surfaces).

:- thread_local last_parts/3.           % Hash, Key, Known

remembered_parts(Key, Kind, Parts, Surfaces) :-
    term_hash(Key, Hash),
    last_parts(Hash, Key0, Known),
    Key0 == Key,
    !,
    Known = known(Kind,Parts,Surfaces).
remembered_parts(Primitive-Stretch, Kind, Parts, Surfaces) :-
    shaped(Primitive, Kind, Maker, Stretch, Given),
    (   globe_parts(Maker, Given, Parts, Surfaces)
    ->  true
    ;   call(Maker, Given, Shape),
        Shape = shape(_, Faces, Surfaces0),
        (   given(Given, smooth, [true])
        ->  maplist(divided_part, Faces, Each),
            maplist(divided_surface, Surfaces0, Surfaces)
        ;   walls_numbered(Maker, Shape, Walls),
            maplist(face_part(Walls), Faces, Each),
            Surfaces = Surfaces0
        ),
        parts_counted(Each, Parts)
    ),
    ignore(( predicate_property(last_parts(_, _, _), number_of_clauses(1000)),
             retractall(last_parts(_, _, _)) )),
    term_hash(Primitive-Stretch, Hash),
    assertz(last_parts(Hash, Primitive-Stretch, known(Kind,Parts,Surfaces))).

%   walls_numbered(Maker, Shape, Walls): Walls, an assoc, numbers what is flat
%   and more than one polygon; the sides of a prism that stand on one line have
%   one number.

walls_numbered(Maker, Shape, Walls) :-
    Shape = shape(_, Faces, _),
    findall(What, ( member(face(What, _), Faces), What \= curved(_, _) ), Flat),
    msort(Flat, Sorted),
    findall(What, append(_, [What,What|_], Sorted), Several0),
    sort(Several0, Several),
    findall(What-I, nth1(I, Several, What), Numbered0),
    list_to_assoc(Numbered0, Alone),
    (   Maker == prism_shape
    ->  straight_sides(Shape, Straight),
        foldl(same_wall, Straight, Alone, Walls)
    ;   Walls = Alone
    ).

same_wall(Side-First, Walls0, Walls) :-
    (   get_assoc(First, Walls0, I),
        get_assoc(Side, Walls0, _)
    ->  put_assoc(Side, Walls0, I, Walls)
    ;   Walls = Walls0
    ).

face_part(Walls, face(What, _), Part) :-
    (   What = curved(Name, Ranges)
    ->  curved_part(Name, Ranges, Part)
    ;   get_assoc(What, Walls, I)
    ->  Part = wall(I)
    ;   Part = flat
    ).

curved_part(Name, Ranges, curved(Name, Width)) :-
    maplist(range_width, Ranges, Widths),
    max_list(Widths, Width0),
    Width is round(Width0*1.0e6)/1.0e6.

%   Ends that are no part of what was divided are faces.

divided_part(face(What, _), Part) :-
    (   What = curved(Name, Ranges)
    ->  curved_part(Name, Ranges, Part)
    ;   ( memberchk(What, [base,top]) ; What = cap(_) )
    ->  Part = flat
    ;   Part = divided
    ).

divided_surface(Part-Surface, Part-turned(Surface)).

%   Neighbours that are alike are one part.

parts_counted([], []).
parts_counted([Part|Each], [part(N, Part)|Parts]) :-
    alike(Each, Part, 1, N, Rest),
    parts_counted(Rest, Parts).

alike([Next|Each], Part, N0, N, Rest) :-
    Next == Part,
    !,
    N1 is N0+1,
    alike(Each, Part, N1, N, Rest).
alike(Rest, _, N, N, Rest).

range_width(From-To, Width) :-
    Width is abs(To-From).

%   moved_surface(Motions, Part-Surface0, Part-Surface): moved.

moved_surface(Motions, Part-Surface0, Part-Surface) :-
    (   Surface0 = turned(Inner0)
    ->  moved_surface(Motions, Part-Inner0, Part-Inner),
        Surface = turned(Inner)
    ;   compound_name_arguments(Surface0, Name, Items0),
        maplist(moved_item(Motions), Items0, Items),
        compound_name_arguments(Surface, Name, Items)
    ).

moved_item(Motions, Item0, Item) :-
    (   Item0 = point(_, _, _)
    ->  moved(Motions, Item0, Item)
    ;   Item0 = vector(_, _, _)
    ->  moved_vector(Motions, Item0, Item)
    ;   is_list(Item0)
    ->  maplist(moved(Motions), Item0, Item)
    ;   Item = Item0
    ).
