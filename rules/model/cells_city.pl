:- module(sg_cells_city,
          [ write_city/5          % +Out, +Names, +Vertices, +Faces, +Cells
          ]).
:- use_module(cells_face, [face_border/4, face_flat/2, region_shells/3]).
:- use_module('../disjoint_sets', [set_root/3, sets_joined/4]).
:- use_module('../gluing/exploded', [wire_seam/4]).
:- use_module('../json_layout', [json_laid_out/3]).
:- use_module('../store',
              [v/5, e/5, t/6, segment/3, sides/4, edge_polygon/3]).
:- use_module('../vector', [doubled_area/2, dot_product/3, vector_sum/3]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [foldl/4, maplist/3, partition/4]).
:- use_module(library(assoc), [empty_assoc/1, get_assoc/3]).
:- use_module(library(lists),
              [append/2, append/3, member/2, nth1/3, reverse/2]).
:- use_module(library(pairs),
              [group_pairs_by_key/2, pairs_keys_values/3, pairs_values/2]).
/** <module> Cells as CityJSON 2.0.

What hangs together by faces is a CompositeSolid, whose members are its cells;
sheets that are no border of a cell are a MultiSurface, wires a MultiLineString,
also those that run in faces: so they come again when all is glued.
Vertices are shared by all. They are integers times a power of ten, which keeps
twelve digits of the largest coordinate, or as many as the coordinates have, if
these are fewer.
*/

%!  write_city(+Out, +Names:list, +Vertices, +Faces:list, +Cells:list) is det.
%
%   Write the model to stream Out, which cells_file.pl describes: Names are S-V
%   in the order of their numbers, Vertices the numbers by names, Faces are S-P
%   and Cells cell(S, R, Role).

write_city(Out, Names, Vertices, Faces, Cells) :-
    findall(p(X,Y,Z), ( member(S-V, Names), once(v(S, V, X, Y, Z)) ), Points),
    scale_of(Points, Scale),
    maplist(scaled_place(Scale), Points, Places),
    findall(Id-Object, city_object(Vertices, Faces, Cells, Id, Object), Pairs),
    dict_pairs(Objects, _, Pairs),
    Written is float(Scale),
    json_laid_out(Out,
                  _{ type:"CityJSON", version:"2.0",
                     transform:_{ scale:[Written,Written,Written],
                                  translate:[0.0,0.0,0.0] },
                     'CityObjects':Objects, vertices:Places },
                  inf),
    nl(Out).

%   scale_of(Points, Scale): the largest power of ten of which all coordinates
%   are multiples, but no less than twelve digits below the largest.

scale_of(Points, Scale) :-
    aggregate_all(max(Size),
                  ( member(p(X,Y,Z), Points),
                    Size is max(abs(X), max(abs(Y), abs(Z))) ),
                  Largest0),
    !,
    Largest is max(Largest0, 1.0e-300),
    Least is ceiling(log10(Largest))-12,
    findall(Q,
            ( member(p(X,Y,Z), Points),
              member(N, [X,Y,Z]),
              Q is rationalize(N) ),
            Qs0),
    sort(Qs0, Qs),
    Most is Least+12,
    scale_down(Most, Least, Qs, Scale).
scale_of(_, 1).

scale_down(K, Least, Qs, Scale) :-
    power_of_ten(K, Scale0),
    (   ( K =< Least ; all_multiples(Qs, Scale0) )
    ->  Scale = Scale0
    ;   K1 is K-1,
        scale_down(K1, Least, Qs, Scale)
    ).

power_of_ten(K, Power) :-
    (   K >= 0
    ->  Power is 10^K
    ;   Power is 1 rdiv 10^(-K)
    ).

all_multiples(Qs, Scale) :-
    \+ ( member(Q, Qs),
         Ratio is Q rdiv Scale,
         \+ integer(Ratio) ).

scaled_place(Scale, p(X,Y,Z), Place) :-
    maplist(scaled_number(Scale), [X,Y,Z], Place).

scaled_number(Scale, N, I) :-
    I is round(rationalize(N) rdiv Scale).

%   city_object(Vertices, Faces, Cells, Id, Object) is nondet.

city_object(Vertices, _, Cells, Id, Object) :-
    findall(S-R, member(cell(S,R,cell), Cells), Solids),
    connected(Solids, Groups),
    nth1(K, Groups, Group),
    Group = [S-_|_],
    format(atom(Id), 'segment_~d_part_~d', [S, K]),
    maplist(solid_boundary(Vertices), Group, Boundaries),
    object("CompositeSolid", Boundaries, Object).
city_object(Vertices, Faces, Cells, Id, Object) :-
    segment(S, _, _),
    findall(Rings,
            ( member(S-P, Faces),
              \+ bounds_cell(S, P, Cells),
              face_rings(Vertices, S, P, 1, Rings) ),
            Boundaries),
    Boundaries \== [],
    format(atom(Id), 'segment_~d_faces', [S]),
    object("MultiSurface", Boundaries, Object).
city_object(Vertices, _, _, Id, Object) :-
    segment(S, _, _),
    findall(Line,
            ( wire(S, V1, V2),
              msort([V1,V2], Vs),
              maplist(index_of(Vertices, S), Vs, Line) ),
            Lines0),
    sort(Lines0, Lines),
    Lines \== [],
    format(atom(Id), 'segment_~d_wires', [S]),
    object("MultiLineString", Lines, Object).

%   wire(S, V1, V2): also one that runs in a face, or between two that would be
%   one without it: a face has no seams here.

wire(S, V1, V2) :-
    e(S, E, V1, V2, 1),
    \+ edge_polygon(S, E, _).
wire(S, V1, V2) :-
    wire_seam(S, _, V1, V2).

object(Type, Boundaries,
       _{ type:"GenericCityObject",
          geometry:[_{ type:Type, lod:"1", boundaries:Boundaries }] }).

bounds_cell(S, P, Cells) :-
    sides(S, P, Below, Above),
    Below =\= Above,
    member(R, [Below,Above]),
    memberchk(cell(S,R,cell), Cells).

%   connected(Solids, Groups): cells with a face between them, in order.

connected(Solids, Groups) :-
    empty_assoc(Sets0),
    findall((S-R1)-(S-R2),
            ( sides_between(S, R1, R2),
              memberchk(S-R1, Solids),
              memberchk(S-R2, Solids) ),
            Links),
    foldl(link, Links, Sets0, Sets),
    findall(Root-Solid, ( member(Solid, Solids),
                          set_root(Sets, Solid, Root) ),
            Rooted0),
    keysort(Rooted0, Rooted),
    group_pairs_by_key(Rooted, Grouped),
    pairs_values(Grouped, Groups0),
    sort(Groups0, Groups).

sides_between(S, R1, R2) :-
    findall(S-(R1-R2), ( segment(S, _, _), sides(S, _, R1, R2), R1 \== R2 ),
            All0),
    sort(All0, All),
    member(S-(R1-R2), All).

link(A-B, Sets0, Sets) :-
    sets_joined(A, B, Sets0, Sets).

%   solid_boundary(Vertices, S-R, Shells): each face so turned that it looks out
%   of the cell.

solid_boundary(Vertices, S-R, Boundary) :-
    region_shells(S, R, Shells),
    findall(Surfaces,
            ( member(Uses, Shells),
              findall(Rings,
                      ( member(use(P,Side), Uses),
                        face_rings(Vertices, S, P, Side, Rings) ),
                      Surfaces) ),
            Boundary).

%   face_rings(Vertices, S, P, Side, Rings) is nondet: of a face that is not
%   flat each triangle.

face_rings(Vertices, S, P, Side, Rings) :-
    (   face_flat(S, P)
    ->  flat_loops(S, P, Loops)
    ;   t(S, P, _, A, B, C),
        Loops = [[A,B,C]]
    ),
    findall(Ring,
            ( member(Loop, Loops),
              maplist(index_of(Vertices, S), Loop, Ring0),
              turned(Side, Ring0, Ring) ),
            Rings).

%   flat_loops(S, P, Loops): a hole that touches another ring is one of its own,
%   so that no ring has a vertex twice: unless the face would be several then.

flat_loops(S, P, Loops) :-
    face_border(S, P, Loops0, _),
    maplist(rings_of, Loops0, Lists),
    append(Lists, Simple),
    (   length(Simple, N),
        \+ length(Loops0, N),
        one_outer(S, Simple, Loops1)
    ->  Loops = Loops1
    ;   Loops = Loops0
    ).

%   rings_of(Loop, Rings): parted where a vertex comes again.

rings_of(Loop, Rings) :-
    walked(Loop, [], [], Rings).

walked([], Behind, Rings, [Ring|Rings]) :-
    reverse(Behind, Ring).
walked([V|Vs], Behind0, Rings0, Rings) :-
    (   append(Around, [V|Behind], Behind0)
    ->  reverse([V|Around], Turned),
        walked([V|Vs], Behind, [Turned|Rings0], Rings)
    ;   walked(Vs, [V|Behind0], Rings0, Rings)
    ).

%   one_outer(S, Rings, Ordered): one of them runs the other way round than all
%   others, and encloses more: it comes first.

one_outer(S, Rings, [Outer|Holes]) :-
    maplist(ring_area(S), Rings, Areas),
    pairs_keys_values(Pairs, Areas, Rings),
    foldl(vector_sum, Areas, p(0,0,0), Sum),
    partition(looks_as(Sum), Pairs, [_-Outer], Inner),
    pairs_values(Inner, Holes).

ring_area(S, Ring, Area) :-
    findall(p(X,Y,Z), ( member(V, Ring), once(v(S, V, X, Y, Z)) ), Points),
    doubled_area(Points, Area).

looks_as(Sum, Area-_) :-
    dot_product(Sum, Area, Product),
    Product > 0.

turned(1, Ring, Ring).
turned(-1, Ring0, Ring) :-
    reverse(Ring0, Ring).

index_of(Vertices, S, V, I) :-
    get_assoc(S-V, Vertices, N),
    I is N-1.
