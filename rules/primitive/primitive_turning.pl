:- module(sg_primitive_turning,
          [ turning_shape/2             % +Given, -Shape
          ]).
:- use_module(outline, [outline_loops/4]).
:- use_module(primitive_argument,
              [given/3, given_facets/4, primitive_error/2, vertices_within/2]).
:- use_module('../angle', [exact_sin_cos/3]).
:- use_module(shape, [round_angle/4]).
:- use_module(library(apply), [foldl/4, foldl/5, maplist/2, maplist/3]).
:- use_module(library(lists),
              [append/2, append/3, last/2, max_list/2, member/2, nth1/3,
               numlist/3, reverse/2]).
/** <module> Turning: a polygon with holes, turned round the z axis.

The outline is a list of [R, Z], distance from the axis and height. A full turn
has no caps; less than a turn goes from the +x side counter-clockwise, and has
caps cap(1) and cap(2). An edge of the outline at one height gives one flat
polygon, ring(I); any other edge gives facets curved(edge(I), [T1-T2]); an edge
on the axis gives nothing. Edges are counted from 1: those of the outline as it
runs counter-clockwise (R to the right, Z up), then those of the holes.

For shapes see shape.pl.
*/

%!  turning_shape(+Given, -Shape) is det.
%
%   @error those of outline_loops/4; across_axis(R, Z), point_on_axis(Z),
%   too_many_vertices(N, Most)

turning_shape(Given, shape(Points, Faces, Surfaces)) :-
    Given = given(Term, _, _),
    given(Given, outline, [Outline]),
    given(Given, holes, [Holes]),
    given(Given, angle, [Degrees]),
    right_of_axis(Outline, Term),
    outline_loops(Outline, Holes, Term, Loops),
    maplist(beside_axis(Term), Loops),
    findall(R, ( member(Loop, Loops), member(R-_, Loop) ), Rs),
    max_list(Rs, Greatest),
    given_facets(Given, Greatest, Degrees, N),
    length(Rs, Count),
    Vertices is Count*(N+1),
    vertices_within(Vertices, Given),
    Turn = turn(N, Degrees),
    foldl(loop_rows(Turn), Loops, RowLoops, 1, _),
    row_points(Turn, RowLoops, Points),
    foldl(loop_faces(Turn), RowLoops, Faces0, 1, _),
    append(Faces0, Faces1),
    caps(Turn, RowLoops, Caps),
    append(Caps, Faces1, Faces),
    foldl(loop_surfaces, RowLoops, Surfaces0, 1, _),
    append(Surfaces0, Surfaces).

right_of_axis(Outline, Term) :-
    (   member(R-Z, Outline),
        R < 0.0
    ->  primitive_error(across_axis(R, Z), Term)
    ;   true
    ).

%   beside_axis(Term, Loop): where it touches the axis it runs along it, or
%   comes in and goes out slantwise: all facets there meet in one vertex.

beside_axis(Term, Loop) :-
    (   loop_step(Loop, A, B, C),
        B = R-Z,
        R =:= 0.0,
        \+ on_axis(A),
        \+ on_axis(C),
        ( A = _-ZA, ZA =:= Z ; C = _-ZC, ZC =:= Z )
    ->  primitive_error(point_on_axis(Z), Term)
    ;   true
    ).

on_axis(R-_) :-
    R =:= 0.0.

loop_step(Loop, A, B, C) :-
    last(Loop, Last),
    Loop = [First|_],
    append([Last|Loop], [First], Round),
    append(_, [A, B, C|_], Round).


                /*******************************
                *             ROWS             *
                *******************************/

%   Every point of the profile is a row: row(R, Z, First, Count) has the
%   vertices First, First+1, ..., Count of them: one on the axis, none where a
%   full turn leaves only a point within a disc or in the body.

loop_rows(turn(N, Degrees), Loop, Rows, Next0, Next) :-
    findall(R-Z-Used,
            ( loop_step(Loop, A, R-Z, C),
              (   on_axis(R-Z)
              ->  (   Degrees =:= 360.0, \+ apex_of(R-Z, [A, C])
                  ->  Used = 0
                  ;   Used = 1
                  )
              ;   Degrees =:= 360.0
              ->  Used = N
              ;   Used is N+1
              ) ),
            Counts),
    foldl(numbered_row, Counts, Rows, Next0, Next).

%   apex_of(Point, Neighbours): Point on the axis is a corner of facets.

apex_of(_-Z, Neighbours) :-
    member(R1-Z1, Neighbours),
    R1 > 0.0,
    Z1 =\= Z,
    !.

numbered_row(R-Z-Count, row(R, Z, Next0, Count), Next0, Next) :-
    Next is Next0+Count.

row_points(Turn, RowLoops, Points) :-
    findall(Point,
            ( member(Rows, RowLoops),
              member(row(R, Z, _, Count), Rows),
              between(1, Count, I),
              row_point(Turn, R, Z, I, Point) ),
            Points).

row_point(turn(N, Degrees), R, Z, I, point(X, Y, Z)) :-
    round_angle(N, Degrees, I, Angle),
    exact_sin_cos(Angle, Sin, Cos),
    X is R*Cos + 0.0,
    Y is R*Sin + 0.0.

row_vertex(row(_, _, First, Count), I, V) :-
    (   Count =:= 1
    ->  V = First
    ;   V is First + (I-1) mod Count
    ).

row_vertices(Row, Vs) :-
    Row = row(_, _, First, Count),
    (   Count =:= 0
    ->  Vs = []
    ;   Last is First+Count-1,
        numlist(First, Last, Vs)
    ).


                /*******************************
                *             FACES            *
                *******************************/

loop_faces(Turn, Rows, Faces, E0, E) :-
    Rows = [First|Rest],
    append(Rest, [First], Nexts),
    edges_faces(Rows, Nexts, Turn, E0, E, Faces0),
    append(Faces0, Faces).

edges_faces([], [], _, E, E, []).
edges_faces([P|Ps], [Q|Qs], Turn, E0, E, [Faces|Rest]) :-
    edge_faces(P, Q, Turn, E0, Faces),
    E1 is E0+1,
    edges_faces(Ps, Qs, Turn, E1, E, Rest).

edge_faces(P, Q, Turn, E, Faces) :-
    P = row(R1, Z1, _, _),
    Q = row(R2, Z2, _, _),
    (   R1 =:= 0.0,
        R2 =:= 0.0
    ->  Faces = []
    ;   Z1 =:= Z2
    ->  flat_loops(P, Q, Turn, Loops),
        Faces = [face(ring(E), Loops)]
    ;   Turn = turn(N, _),
        numlist(1, N, Is),
        maplist(facet(P, Q, Turn, E), Is, Faces)
    ).

%   flat_loops(P, Q, Turn, Loops): the polygon faces down if it goes outwards
%   from P to Q.

flat_loops(P, Q, turn(_, Degrees), Loops) :-
    P = row(R1, _, _, _),
    Q = row(R2, _, _, _),
    row_vertices(P, Ps),
    row_vertices(Q, Qs),
    reverse(Qs, Back),
    (   Degrees < 360.0
    ->  append(Ps, Back, Loop),
        Loops = [Loop]
    ;   on_axis(R1-_)
    ->  Loops = [Back]
    ;   on_axis(R2-_)
    ->  Loops = [Ps]
    ;   R1 < R2
    ->  Loops = [Back, Ps]
    ;   Loops = [Ps, Back]
    ).

facet(P, Q, turn(N, Degrees), E, I, face(What, [Loop])) :-
    J is I+1,
    round_angle(N, Degrees, I, Angle1),
    round_angle(N, Degrees, J, Angle2),
    T1 is float(Angle1),
    T2 is float(Angle2),
    What = curved(edge(E), [T1-T2]),
    row_vertex(P, I, A),
    row_vertex(P, J, B),
    row_vertex(Q, J, C),
    row_vertex(Q, I, D),
    (   A =:= B
    ->  Loop = [A, C, D]
    ;   C =:= D
    ->  Loop = [A, B, C]
    ;   Loop = [A, B, C, D]
    ).

%   caps(Turn, RowLoops, Caps): the profile at the beginning and at the end.

caps(turn(_, Degrees), RowLoops, Caps) :-
    (   Degrees < 360.0
    ->  maplist(maplist(row_first), RowLoops, Firsts),
        maplist(maplist(row_last), RowLoops, Lasts0),
        maplist(reverse, Lasts0, Lasts),
        Caps = [face(cap(1), Firsts), face(cap(2), Lasts)]
    ;   Caps = []
    ).

row_first(row(_, _, First, _), First).

row_last(row(_, _, First, Count), Last) :-
    Last is First+Count-1.

%   loop_surfaces(Rows, Surfaces, E0, E): cylinders and cones; the larger
%   circle is the base.

loop_surfaces(Rows, Surfaces, E0, E) :-
    Rows = [First|Rest],
    append(Rest, [First], Nexts),
    findall(edge(I)-Surface,
            ( nth1(K, Rows, row(R1, Z1, _, _)),
              nth1(K, Nexts, row(R2, Z2, _, _)),
              Z1 =\= Z2,
              max(R1, R2) > 0.0,
              I is E0+K-1,
              edge_surface(R1, Z1, R2, Z2, Surface) ),
            Surfaces),
    length(Rows, Count),
    E is E0+Count.

edge_surface(R1, Z1, R2, Z2, Surface) :-
    (   R1 >= R2
    ->  round_surface(R1, Z1, R2, Z2, Surface)
    ;   round_surface(R2, Z2, R1, Z1, Surface)
    ).

round_surface(R1, Z1, R2, Z2, Surface) :-
    H is Z2-Z1,
    K is R2/R1,
    C = point(0.0, 0.0, Z1),
    U = vector(R1, 0.0, 0.0),
    V = vector(0.0, R1, 0.0),
    W = vector(0.0, 0.0, H),
    (   R1 =:= R2
    ->  Surface = cylinder(C, U, V, W)
    ;   Surface = cone(C, U, V, W, K)
    ).
