:- module(sg_primitive_flat,
          [ box_shape/2,                % +Given, -Shape
            rectangle_shape/2,          % +Given, -Shape
            line_shape/2,               % +Given, -Shape
            polyhedron_shape/2,         % +Given, -Shape
            sheet_shape/2               % +Given, -Shape
          ]).
:- use_module(primitive_argument,
              [given/3, primitive_error/2]).
:- use_module('../polygon/polygon_list',
              [polygon_fault/2, vertex_list_edges/2]).
:- use_module(shape, [layer_faces/4, rectangle_loop/3]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3, maplist/4]).
:- use_module(library(lists),
              [ append/2, append/3, member/2, numlist/3, same_length/2,
                sum_list/2
              ]).
:- use_module(library(ordsets), [ord_subtract/3]).
/** <module> Primitives with flat faces. For shapes see shape.pl.
*/

%!  line_shape(+Given, -Shape) is det.
%
%   A curve: the only loop of its only face is an open chain.
%
%   @error no_length

line_shape(Given, shape([point(X1, Y1, Z1), point(X2, Y2, Z2)],
                        [face(line, [[1, 2]])], [])) :-
    given(Given, from, [X1, Y1, Z1]),
    given(Given, to, [X2, Y2, Z2]),
    (   [X1, Y1, Z1] == [X2, Y2, Z2]
    ->  Given = given(Term, _, _),
        primitive_error(no_length, Term)
    ;   true
    ).

%!  rectangle_shape(+Given, -Shape) is det.
%
%   A surface that faces +z.

rectangle_shape(Given, shape(Points, [face(front, [[1, 2, 3, 4]])], [])) :-
    given(Given, size, [A, B]),
    rectangle_loop(A, B, Loop),
    maplist(lifted([0.0, 0.0, 0.0]), Loop, Points).

lifted([X0, Y0, Z], X1-Y1, point(X, Y, Z)) :-
    X is X1 + X0,
    Y is Y1 + Y0.

%!  box_shape(+Given, -Shape) is det.

box_shape(Given, shape(Points, Faces, [])) :-
    given(Given, size, [A, B, H]),
    rectangle_loop(A, B, Loop),
    maplist(lifted([0.0, 0.0, 0.0]), Loop, Low),
    maplist(lifted([0.0, 0.0, H]), Loop, High),
    append(Low, High, Points),
    maplist(side_label, [1, 2, 3, 4], Labels),
    layer_faces([[1, 2, 3, 4]], 4, Labels, Faces).

side_label(I, side(I)).


                /*******************************
                *       POINTS AND FACES       *
                *******************************/

%!  polyhedron_shape(+Given, -Shape) is det.
%
%   @error those of sheet_shape/2; open_edge(V1, V2), inside_out

polyhedron_shape(Given, Shape) :-
    sheet_edges(Given, Shape, Edges),
    Given = given(Term, _, _),
    every_edge_twice(Edges, Term),
    Shape = shape(Points, Faces, _),
    (   volume_sign(Points, Faces, 1)
    ->  true
    ;   primitive_error(inside_out, Term)
    ).

%!  sheet_shape(+Given, -Shape) is det.
%
%   An open surface.
%
%   @error unknown_point(F, V), bad_face(F, Fault) with Fault as in
%   polygon_fault/2 or `list`, edge_taken(F, V1, V2)

sheet_shape(Given, Shape) :-
    sheet_edges(Given, Shape, _).

sheet_edges(Given, shape(Points, Faces, []), Edges) :-
    Given = given(Term, _, _),
    given(Given, points, [Points]),
    given(Given, faces, [Lists]),
    length(Points, Count),
    length(Lists, N),
    (   N >= 1
    ->  numlist(1, N, Fs)
    ;   primitive_error(no_faces, Term)
    ),
    maplist(face_edges(Count, Term), Fs, Lists, Edges0),
    append(Edges0, Edges1),
    sort(Edges1, Edges),
    (   same_length(Edges, Edges1)
    ->  true
    ;   first_taken(Edges0, Term)
    ),
    maplist(sheet_face, Fs, Lists, Faces).

face_edges(Count, Term, F, List, Edges) :-
    (   member(V, List),
        abs(V) > Count
    ->  Unknown is abs(V),
        primitive_error(unknown_point(F, Unknown), Term)
    ;   \+ vertex_list_edges(List, _)
    ->  primitive_error(bad_face(F, list), Term)
    ;   vertex_list_edges(List, Edges),
        (   polygon_fault(Edges, Fault)
        ->  primitive_error(bad_face(F, Fault), Term)
        ;   true
        )
    ).

%   first_taken(EdgeLists, Term): the first face with an edge that an earlier
%   one has already.

first_taken(EdgeLists, Term) :-
    append(Before, [Edges|_], EdgeLists),
    append(Before, Taken0),
    sort(Taken0, Taken),
    member(V1-V2, Edges),
    memberchk(V1-V2, Taken),
    !,
    length(Before, N),
    F is N+1,
    primitive_error(edge_taken(F, V1, V2), Term).

every_edge_twice(Edges, Term) :-
    maplist(opposite, Edges, Opposites0),
    sort(Opposites0, Opposites),
    (   Edges == Opposites
    ->  true
    ;   ord_subtract(Edges, Opposites, [V1-V2|_]),
        primitive_error(open_edge(V1, V2), Term)
    ).

opposite(A-B, B-A).

sheet_face(F, List, face(face(F), Loops)) :-
    (   member(V, List),
        V < 0
    ->  jump_loops(List, Loops)
    ;   append([V0|Vs], [V0], List)
    ->  Loops = [[V0|Vs]]
    ;   Loops = [List]
    ).

%   jump_loops(List, Loops): each is closed by its first vertex.

jump_loops([], []).
jump_loops([V0|List], [[V|Loop]|Loops]) :-
    V is abs(V0),
    append(Loop, [V|Rest], List),
    !,
    jump_loops(Rest, Loops).

%   volume_sign(Points, Faces, Sign): exact; fans from the first vertex, which
%   do for the volume of any polygon.

volume_sign(Points, Faces, Sign) :-
    maplist(rational_point, Points, Rationals),
    Table =.. [points|Rationals],
    findall(V, ( member(face(_, Loops), Faces), member(Loop, Loops),
                 loop_volume(Table, Loop, V) ),
            Volumes),
    sum_list(Volumes, Volume),
    Sign is sign(Volume).

rational_point(point(X0, Y0, Z0), p(X, Y, Z)) :-
    X is rational(X0),
    Y is rational(Y0),
    Z is rational(Z0).

loop_volume(Table, [V|Vs], Volume) :-
    arg(V, Table, A),
    maplist(table_point(Table), Vs, [B|Cs]),
    foldl(fan_volume(A), Cs, B-0, _-Volume).

table_point(Table, V, Point) :-
    arg(V, Table, Point).

fan_volume(p(X1, Y1, Z1), C, B-Volume0, C-Volume) :-
    B = p(X2, Y2, Z2),
    C = p(X3, Y3, Z3),
    Volume is Volume0 + X1*(Y2*Z3 - Z2*Y3) - Y1*(X2*Z3 - Z2*X3)
                      + Z1*(X2*Y3 - Y2*X3).
