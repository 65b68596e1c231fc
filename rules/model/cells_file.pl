:- module(sg_cells_file,
          [ write_cells/2,              % +File, +Format
            cells_format/1              % ?Format
          ]).
:- use_module(cells_city, [write_city/5]).
:- use_module(cells_face,
              [ face_border/4, face_flat/2, face_points/3, face_shapes/3,
                region_shells/3 ]).
:- use_module('../gluing/region_point', [region_point/3]).
:- use_module('../output', [writing/3]).
:- use_module('../store',
              [ v/5, e/5, p/3, segment/3, region/3, sides/4, lies_in/3,
                edge_polygon/3 ]).
:- use_module(library(apply), [foldl/4, maplist/3, maplist/4]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [append/3, member/2, nextto/3, nth1/3]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
:- use_module(library(yall), [(>>)/4]).
/** <module> Regions in files of other programs.

Each vertex and each face stands in the file once, so meshes of neighbours fit
each other.

  - `.poly`: a complex for TetGen (`tetgen -pA`), a point for each cell, whose
    number is its attribute, a hole for each void; the marker of a facet is the
    number of its polygon
  - `.geo`: a model for Gmsh, a physical volume `region_R` for each cell
  - `.obj`, `.off`: the faces; in OBJ in groups `sides_BELOW_ABOVE`
  - `.json`: CityJSON (cells_city.pl)

Regions are numbered as they are, of several segments one after the other;
segments without regions have faces alone.
*/

%!  cells_format(?Format) is nondet.
%
%   The endings of such files.

cells_format(poly).
cells_format(geo).
cells_format(obj).
cells_format(off).
cells_format(json).

%!  write_cells(+File, +Format) is det.
%
%   Write all segments of the current world to File, in a Format of
%   cells_format/1. Regions must be known (regions_made/2).

write_cells(File, Format) :-
    findall(S, segment(S, _, _), Ss0),
    sort(Ss0, Ss),
    findall(S-V, ( member(S, Ss), v(S, V, _, _, _) ), Names0),
    sort(Names0, Names),
    findall(Name-N, nth1(N, Names, Name), Pairs),
    list_to_assoc(Pairs, Vertices),
    findall(S-P, ( member(S, Ss), p(S, P, _) ), Faces0),
    sort(Faces0, Faces),
    findall(cell(S,R,Role),
            ( member(S, Ss),
              region(S, R, Role),
              memberchk(Role, [cell,void]) ),
            Cells0),
    sort(Cells0, Cells),
    writing(File, text,
            sg_cells_file:written(Format,
                                  parts(Names, Vertices, Faces, Cells))).

written(poly, Parts, Out) :-
    poly_written(Parts, Out).
written(geo, Parts, Out) :-
    geo_written(Parts, Out).
written(obj, Parts, Out) :-
    obj_written(Parts, Out).
written(off, Parts, Out) :-
    off_written(Parts, Out).
written(json, parts(Names, Vertices, Faces, Cells), Out) :-
    write_city(Out, Names, Vertices, Faces, Cells).

number_of(Vertices, S, V, N) :-
    get_assoc(S-V, Vertices, N).

numbers_of(Vertices, S, Vs, Ns) :-
    maplist(number_of(Vertices, S), Vs, Ns).

%   wire(S, V1, V2): an edge that no face has, once.

wire(S, V1, V2) :-
    findall(S-(V1-V2),
            ( segment(S, _, _),
              e(S, E, A, B, 1),
              \+ edge_polygon(S, E, _),
              V1 is min(A, B),
              V2 is max(A, B) ),
            Wires0),
    sort(Wires0, Wires),
    member(S-(V1-V2), Wires).


                /*******************************
                *            TetGen            *
                *******************************/

poly_written(parts(Names, Vertices, Faces, Cells), Out) :-
    length(Names, Count),
    format(Out, "# vertices~n~d 3 0 0~n", [Count]),
    forall(nth1(N, Names, S-V),
           ( once(v(S, V, X, Y, Z)),
             format(Out, "~d ~w ~w ~w~n", [N, X, Y, Z]) )),
    findall(facet(S, P, Shape),
            ( member(S-P, Faces),
              face_shapes(S, P, Shapes),
              member(Shape, Shapes) ),
            Facets),
    findall(S-(V1-V2), wire(S, V1, V2), Wires),
    length(Facets, Count1),
    length(Wires, Count2),
    Count3 is Count1+Count2,
    format(Out, "# facets~n~d 1~n", [Count3]),
    forall(member(facet(S, P, Shape), Facets),
           poly_facet(Out, Vertices, S, P, Shape)),
    forall(member(S-(V1-V2), Wires),
           ( numbers_of(Vertices, S, [V1,V2], [N1,N2]),
             format(Out, "1 0 0~n2 ~d ~d~n", [N1,N2]) )),
    points_of(void, Cells, Holes),
    length(Holes, HoleCount),
    format(Out, "# holes~n~d~n", [HoleCount]),
    forall(nth1(I, Holes, _-p(X,Y,Z)),
           format(Out, "~d ~w ~w ~w~n", [I, X, Y, Z])),
    points_of(cell, Cells, Points),
    length(Points, PointCount),
    format(Out, "# regions~n~d~n", [PointCount]),
    forall(nth1(I, Points, N-p(X,Y,Z)),
           format(Out, "~d ~w ~w ~w ~d~n", [I, X, Y, Z, N])).

poly_facet(Out, Vertices, S, P, shape(Vs,Points)) :-
    length(Points, Inner),
    Polygons is Inner+1,
    format(Out, "~d 0 ~d~n", [Polygons, P]),
    poly_polygon(Out, Vertices, S, Vs),
    forall(member(V, Points), poly_polygon(Out, Vertices, S, [V])).

poly_polygon(Out, Vertices, S, Vs) :-
    numbers_of(Vertices, S, Vs, Ns),
    length(Ns, N),
    atomic_list_concat([N|Ns], ' ', Line),
    format(Out, "~w~n", [Line]).

%   points_of(Role, Cells, Points): N-Point, N being the number of the cell.

points_of(Role, Cells, Points) :-
    findall(N-Point,
            ( nth1(N, Cells, cell(S,R,Role)),
              region_point(S, R, Point) ),
            Points).


                /*******************************
                *             Gmsh             *
                *******************************/

%   geo_written(Parts, Out): edges are numbered once, whichever way faces run
%   along them. A face is a surface, or, if it is not flat, one for each of its
%   triangles: bent(S, P, Shape).

geo_written(parts(Names, Vertices, Faces, Cells), Out) :-
    forall(nth1(N, Names, S-V),
           ( once(v(S, V, X, Y, Z)),
             format(Out, "Point(~d) = {~w, ~w, ~w};~n", [N, X, Y, Z]) )),
    findall(Surface,
            ( member(Face, Faces), geo_surface(Face, Surface) ),
            Surfaces),
    findall(A-B,
            ( file_edge(Vertices, A, B)
            ; side_of_bent(Surfaces, Vertices, A, B)
            ),
            Edges0),
    sort(Edges0, Edges),
    findall(Edge-N, nth1(N, Edges, Edge), EdgePairs),
    list_to_assoc(EdgePairs, EdgeNumbers),
    forall(member((A-B)-N, EdgePairs),
           format(Out, "Line(~d) = {~d, ~d};~n", [N, A, B])),
    findall(Surface-N, nth1(N, Surfaces, Surface), SurfacePairs),
    foldl(geo_face(Out, Vertices, EdgeNumbers), SurfacePairs, 1, _),
    findall((S-P)-N,
            ( member(Surface-N, SurfacePairs), surface_face(Surface, S-P) ),
            FacePairs0),
    keysort(FacePairs0, FacePairs1),
    group_pairs_by_key(FacePairs1, FacePairs),
    list_to_assoc(FacePairs, FaceNumbers),
    foldl(geo_cell(Out, Vertices, EdgeNumbers, FaceNumbers), Cells, 1-1, _).

file_edge(Vertices, A, B) :-
    segment(S, _, _),
    e(S, _, V1, V2, 1),
    numbers_of(Vertices, S, [V1,V2], Ns),
    msort(Ns, [A,B]).

geo_surface(S-P, Surface) :-
    (   face_flat(S, P)
    ->  Surface = S-P
    ;   face_shapes(S, P, Shapes),
        member(Shape, Shapes),
        Surface = bent(S,P,Shape)
    ).

surface_face(S-P, S-P).
surface_face(bent(S,P,_), S-P).

side_of_bent(Surfaces, Vertices, A, B) :-
    member(bent(S,_,shape(Vs,_)), Surfaces),
    numbers_of(Vertices, S, Vs, Ns),
    Ns = [First|_],
    append(Ns, [First], Round),
    nextto(N1, N2, Round),
    msort([N1,N2], [A,B]).

geo_face(Out, Vertices, Edges, bent(S,_,shape(Vs,Points))-N, Loop0, Loop) :-
    !,
    geo_loop(Out, Vertices, Edges, S, Vs, Loop0, Loop),
    format(Out, "Plane Surface(~d) = {~d};~n", [N, Loop0]),
    geo_points(Out, Vertices, S, Points, N).
geo_face(Out, Vertices, Edges, (S-P)-N, Loop0, Loop) :-
    face_border(S, P, Loops, Seams),
    foldl(geo_loop(Out, Vertices, Edges, S), Loops, Loop0, Loop),
    Last is Loop-1,
    findall(K, between(Loop0, Last, K), Ks),
    listed(Ks, List),
    format(Out, "Plane Surface(~d) = {~w};~n", [N, List]),
    forall(member(V1-V2, Seams),
           ( edge_number(Vertices, Edges, S, V1, V2, E),
             Line is abs(E),
             format(Out, "Curve{~d} In Surface{~d};~n", [Line, N]) )),
    face_points(S, P, Points),
    geo_points(Out, Vertices, S, Points, N).

geo_points(Out, Vertices, S, Points, N) :-
    forall(( member(V, Points), number_of(Vertices, S, V, Point) ),
           format(Out, "Point{~d} In Surface{~d};~n", [Point, N])).

geo_loop(Out, Vertices, Edges, S, Vs, Loop0, Loop) :-
    Vs = [First|Rest],
    append(Rest, [First], Nexts),
    maplist(edge_number(Vertices, Edges, S), Vs, Nexts, Numbers),
    listed(Numbers, List),
    format(Out, "Curve Loop(~d) = {~w};~n", [Loop0, List]),
    Loop is Loop0+1.

edge_number(Vertices, Edges, S, V1, V2, E) :-
    numbers_of(Vertices, S, [V1,V2], [A,B]),
    (   A < B
    ->  get_assoc(A-B, Edges, E)
    ;   get_assoc(B-A, Edges, E0),
        E is -E0
    ).

%   geo_cell(Out, ..., Cell, N0-Loop0, N-Loop): a void is numbered, and no
%   volume.

geo_cell(_, _, _, _, cell(_,_,void), N0-Loop, N-Loop) :-
    !,
    N is N0+1.
geo_cell(Out, Vertices, Edges, Faces, cell(S,R,cell), N0-Loop0, N-Loop) :-
    region_shells(S, R, Shells),
    foldl(geo_shell(Out, Faces, S), Shells, Loop0, Loop),
    Last is Loop-1,
    findall(K, between(Loop0, Last, K), Ks),
    listed(Ks, List),
    format(Out, "Volume(~d) = {~w};~n", [N0, List]),
    forall(( sides(S, P, R, R), get_assoc(S-P, Faces, Ns), member(Face, Ns) ),
           format(Out, "Surface{~d} In Volume{~d};~n", [Face, N0])),
    findall(Line, inner_line(Vertices, Edges, S, R, Line), Lines0),
    sort(Lines0, Lines),
    forall(member(Line, Lines),
           format(Out, "Curve{~d} In Volume{~d};~n", [Line, N0])),
    format(Out, "Physical Volume(\"region_~d\", ~d) = {~d};~n", [N0, N0, N0]),
    N is N0+1.

geo_shell(Out, Faces, S, Uses, Loop0, Loop) :-
    findall(Surface,
            ( member(use(P,Side), Uses),
              get_assoc(S-P, Faces, Ns),
              member(Face, Ns),
              Surface is Side*Face ),
            Surfaces),
    listed(Surfaces, List),
    format(Out, "Surface Loop(~d) = {~w};~n", [Loop0, List]),
    Loop is Loop0+1.

inner_line(Vertices, Edges, S, R, Line) :-
    lies_in(S, e(E), r(R)),
    once(e(S, E, V1, V2, _)),
    edge_number(Vertices, Edges, S, V1, V2, Line0),
    Line is abs(Line0).

listed(Numbers, List) :-
    atomic_list_concat(Numbers, ', ', List).


                /*******************************
                *          OBJ, OFF            *
                *******************************/

obj_written(parts(Names, Vertices, Faces, _), Out) :-
    forall(member(S-V, Names),
           ( once(v(S, V, X, Y, Z)),
             format(Out, "v ~w ~w ~w~n", [X, Y, Z]) )),
    findall(Sides-(S-P),
            ( member(S-P, Faces), face_sides(S, P, Sides) ),
            Grouped0),
    keysort(Grouped0, Grouped),
    foldl(obj_face(Out, Vertices), Grouped, none, _),
    findall(S-(V1-V2), wire(S, V1, V2), Wires),
    forall(member(S-(V1-V2), Wires),
           ( numbers_of(Vertices, S, [V1,V2], [N1,N2]),
             format(Out, "g wires~nl ~d ~d~n", [N1,N2]) )).

face_sides(S, P, sides(S, Below, Above)) :-
    (   sides(S, P, Below, Above)
    ->  true
    ;   Below = none,
        Above = none
    ).

obj_face(Out, Vertices, Sides-(S-P), Last, Sides) :-
    (   Sides == Last
    ->  true
    ;   Sides = sides(_, Below, Above),
        format(Out, "g sides_~w_~w~n", [Below, Above])
    ),
    face_shapes(S, P, Shapes),
    forall(member(shape(Vs,_), Shapes),
           ( numbers_of(Vertices, S, Vs, Ns),
             atomic_list_concat([f|Ns], ' ', Line),
             format(Out, "~w~n", [Line]) )).

off_written(parts(Names, Vertices, Faces, _), Out) :-
    findall(Ns,
            ( member(S-P, Faces),
              face_shapes(S, P, Shapes),
              member(shape(Vs,_), Shapes),
              numbers_of(Vertices, S, Vs, Ns) ),
            All),
    length(Names, Count),
    length(All, FaceCount),
    format(Out, "OFF~n~d ~d 0~n", [Count, FaceCount]),
    forall(member(S-V, Names),
           ( once(v(S, V, X, Y, Z)),
             format(Out, "~w ~w ~w~n", [X, Y, Z]) )),
    forall(member(Ns, All),
           ( maplist([N,M]>>(M is N-1), Ns, Ms),
             length(Ms, Corners),
             atomic_list_concat([Corners|Ms], ' ', Line),
             format(Out, "~w~n", [Line]) )).
