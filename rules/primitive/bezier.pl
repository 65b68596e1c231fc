:- module(sg_bezier,
          [ bezier_shape/2              % +Given, -Shape
          ]).
:- use_module('../kernel', [bezier_grid/4]).
:- use_module(primitive_argument,
              [given/3, primitive_error/2, vertices_within/2]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(assoc), [empty_assoc/1, get_assoc/3, put_assoc/4]).
:- use_module(library(lists),
              [append/2, append/3, max_list/2, member/2, numlist/3, reverse/2]).
/** <module> Bicubic Bezier patches and nets of them.

A patch has 16 points, four rows of four: u goes along a row, v from row to
row, and the front is where u x v points. Points of the surface are computed
exactly, as rationals, and rounded once; so a border that two patches have in
common gives the same vertices in both, whichever way it runs there, and they
become one vertex. A side that is one point gives triangles.

For shapes see shape.pl.
*/

default_facets(10).
most_facets(1000).

%!  bezier_shape(+Given, -Shape) is det.
%
%   Every patch is divided N by N, the same N for all. Faces are triangles
%   curved(patch(K), [U1-U2, V1-V2]), by the shorter diagonal of each cell.
%
%   @error patch_points(K, N) of a patch of N points, not 16;
%   unknown_point(K, V), no_faces, patches_clash(K, L) of patches that run
%   along an edge the same way, both(facets, tolerance), too_many(N),
%   too_many_vertices(N, Most)

bezier_shape(Given, shape(Points, Faces, Surfaces)) :-
    Given = given(Term, _, _),
    given(Given, points, [Controls]),
    patch_lists(Given, Controls, Lists),
    control_points(Lists, 1, Controls, Term, Patches),
    patch_facets(Given, Patches, N),
    length(Patches, Count),
    Vertices is Count*(N+1)*(N+1),
    vertices_within(Vertices, Given),
    empty_assoc(Known),
    patches_added(Patches, 1, N, net(1, Known, []), Net, FaceLists),
    no_clash(FaceLists, Term),
    append(FaceLists, Faces),
    Net = net(_, _, Backwards),
    reverse(Backwards, Points),
    patch_surfaces(Patches, 1, Surfaces).

%   patch_lists(Given, Controls, Lists): the control points of each patch;
%   without patches, all are those of one.

patch_lists(Given, Controls, Lists) :-
    Given = given(Term, _, _),
    given(Given, patches, Patches),
    (   Patches = [[]]
    ->  primitive_error(no_faces, Term)
    ;   Patches = [Lists]
    ->  true
    ;   length(Controls, N),
        numlist(1, N, List),
        Lists = [List]
    ).

control_points([], _, _, _, []).
control_points([List|Lists], K, Controls, Term, [Patch|Patches]) :-
    length(List, N),
    (   N =:= 16
    ->  true
    ;   primitive_error(patch_points(K, N), Term)
    ),
    Table =.. [points|Controls],
    maplist(control_point(Table, K, Term), List, Patch),
    K1 is K+1,
    control_points(Lists, K1, Controls, Term, Patches).

control_point(Table, K, Term, V, Point) :-
    (   V > 0,
        arg(V, Table, Point)
    ->  true
    ;   primitive_error(unknown_point(K, V), Term)
    ).

%   patch_surfaces(Patches, K, Surfaces)

patch_surfaces([], _, []).
patch_surfaces([Patch|Patches], K, [patch(K)-bezier(Patch)|Surfaces]) :-
    K1 is K+1,
    patch_surfaces(Patches, K1, Surfaces).


                /*******************************
                *          HOW MANY            *
                *******************************/

%   patch_facets(Given, Patches, N): by tolerance, from the greatest second
%   derivatives: a triangle of N*N cells is no farther than
%   (Muu + 2*Muv + Mvv)/(8*N*N) from the surface.
%
%   Source: D. Filip, R. Magedson, R. Markot, Surface algorithms using bounds
%   on derivatives, CAGD 3, 1986.

patch_facets(Given, Patches, N) :-
    Given = given(Term, Stretch, _),
    given(Given, facets, Facets),
    given(Given, tolerance, Tolerance),
    (   Facets = [N],
        Tolerance == none
    ->  true
    ;   Facets = [_]
    ->  primitive_error(both(facets, tolerance), Term)
    ;   Tolerance = [T]
    ->  maplist(patch_bend, Patches, Bends),
        max_list(Bends, Bend),
        N is max(1, ceiling(sqrt(Bend*Stretch/T/8.0)))
    ;   default_facets(N)
    ),
    most_facets(Most),
    (   N > Most
    ->  primitive_error(too_many(N), Term)
    ;   true
    ).

patch_bend(Patch, Bend) :-
    Table =.. [points|Patch],
    greatest([V, U1, V, U2, V, U2, V, U3]-
                 ( between(0, 3, V), between(0, 1, U1),
                   U2 is U1+1, U3 is U1+2 ),
             Table, Along),
    greatest([V1, U, V2, U, V2, U, V3, U]-
                 ( between(0, 3, U), between(0, 1, V1),
                   V2 is V1+1, V3 is V1+2 ),
             Table, Across),
    greatest([V1, U1, V1, U2, V2, U1, V2, U2]-
                 ( between(0, 2, U1), between(0, 2, V1),
                   U2 is U1+1, V2 is V1+1 ),
             Table, Twist),
    Bend is 6.0*Along + 2.0*9.0*Twist + 6.0*Across.

%   greatest(Places-Goal, Table, Greatest): the longest A - B - C + D of the
%   four control points at Places = [VA, UA, VB, UB, ...].

greatest(Places-Goal, Table, Greatest) :-
    findall(Length,
            ( call(Goal),
              Places = [V1, U1, V2, U2, V3, U3, V4, U4],
              control(Table, V1, U1, point(X1, Y1, Z1)),
              control(Table, V2, U2, point(X2, Y2, Z2)),
              control(Table, V3, U3, point(X3, Y3, Z3)),
              control(Table, V4, U4, point(X4, Y4, Z4)),
              Length is sqrt((X1-X2-X3+X4)**2 + (Y1-Y2-Y3+Y4)**2
                             + (Z1-Z2-Z3+Z4)**2) ),
            Lengths),
    max_list(Lengths, Greatest).

control(Table, V, U, Point) :-
    I is 4*V + U + 1,
    arg(I, Table, Point).


                /*******************************
                *            POINTS            *
                *******************************/

%   patches_added(Patches, K, N, Net0, Net, FaceLists): a net is net(Next,
%   Known, Backwards): the next vertex, the vertices of borders by their place,
%   and all points, the last first.

patches_added([], _, _, Net, Net, []).
patches_added([Patch|Patches], K, N, Net0, Net, [Faces|FaceLists]) :-
    foldl(coordinates, Patch, Controls, []),
    bezier_grid(Controls, N, Points, Turned),
    rows_entered(0, N, Points, Net0, Net1, Rows),
    Table =.. [rows|Rows],
    cells_faces(Turned, 0, Table, K, N, Faces),
    K1 is K+1,
    patches_added(Patches, K1, N, Net1, Net, FaceLists).

coordinates(point(X0, Y0, Z0), [X, Y, Z|Numbers], Numbers) :-
    X is float(X0),
    Y is float(Y0),
    Z is float(Z0).

%   rows_entered(J, N, Points, Net0, Net, Rows): rows of vertices, from J on.

rows_entered(J, N, Points0, Net0, Net, Rows) :-
    (   J > N
    ->  Net = Net0,
        Rows = []
    ;   row_entered(0, J, N, Points0, Points, Net0, Net1, List),
        Row =.. [row|List],
        Rows = [Row|Rows1],
        J1 is J+1,
        rows_entered(J1, N, Points, Net1, Net, Rows1)
    ).

row_entered(I, J, N, Points0, Points, Net0, Net, Row) :-
    (   I > N
    ->  Points = Points0,
        Net = Net0,
        Row = []
    ;   Points0 = [P|Points1],
        Row = [V|Row1],
        (   ( I =:= 0 ; I =:= N ; J =:= 0 ; J =:= N )
        ->  border_entered(P, Net0, Net1, V)
        ;   entered(P, Net0, Net1, V)
        ),
        I1 is I+1,
        row_entered(I1, J, N, Points1, Points, Net1, Net, Row1)
    ).

border_entered(P, Net0, Net, V) :-
    arg(2, Net0, Known0),
    (   get_assoc(P, Known0, V)
    ->  Net = Net0
    ;   entered(P, Net0, net(Next, _, Points), V),
        put_assoc(P, Known0, V, Known),
        Net = net(Next, Known, Points)
    ).

entered(p(X, Y, Z), net(V, Known, Points),
        net(V1, Known, [point(X, Y, Z)|Points]), V) :-
    V1 is V+1.


                /*******************************
                *            FACES             *
                *******************************/

%   cells_faces(Turned, Cell, Table, K, N, Faces): the triangles of the cells,
%   counted from 0, with three vertices.

cells_faces([], _, _, _, _, []).
cells_faces([Turn|Turned], Cell, Table, K, N, Faces) :-
    J is Cell//N + 1,
    I is Cell mod N + 1,
    cell_loops(Turn, Table, J, I, Loops),
    U1 is (I-1)/float(N),
    U2 is I/float(N),
    V1 is (J-1)/float(N),
    V2 is J/float(N),
    findall(face(curved(patch(K), [U1-U2, V1-V2]), [Loop]),
            ( member(Loop, Loops), sort(Loop, [_, _, _]) ),
            Faces, Faces1),
    Next is Cell+1,
    cells_faces(Turned, Next, Table, K, N, Faces1).

cell_loops(Turn, Table, J, I, Loops) :-
    J1 is J+1,
    arg(J, Table, Row),
    arg(J1, Table, Row1),
    I1 is I+1,
    arg(I, Row, A),
    arg(I1, Row, B),
    arg(I1, Row1, C),
    arg(I, Row1, D),
    (   Turn =:= 0
    ->  Loops = [[A, B, C], [A, C, D]]
    ;   Loops = [[A, B, D], [B, C, D]]
    ).

%   no_clash(FaceLists, Term): no directed edge stands twice.

no_clash(FaceLists, Term) :-
    findall(A-B-K,
            ( member(Faces, FaceLists),
              member(face(curved(patch(K), _), [[V1, V2, V3]]), Faces),
              member(A-B, [V1-V2, V2-V3, V3-V1]) ),
            Edges0),
    msort(Edges0, Edges),
    (   append(_, [Edge-K, Edge-L|_], Edges)
    ->  primitive_error(patches_clash(K, L), Term)
    ;   true
    ).
