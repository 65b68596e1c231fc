:- module(sg_cityjson,
          [ read_cityjson/2             % +File, +Options
          ]).
:- use_module('../kernel', [shape_write/4]).
:- use_module(cityjson_floor, [floors_added/3]).
:- use_module('../store', [assert_fact/1, fresh_id/3]).
:- use_module('../text_file', [with_text/4]).
:- use_module(library(apply),
              [ exclude/3, foldl/4, foldl/5, maplist/2, maplist/3,
                partition/4 ]).
:- use_module(library(assoc),
              [get_assoc/3, ord_list_to_assoc/2]).
:- use_module(library(lists),
              [ append/2, append/3, last/2, member/2, nth0/3, nth1/3,
                same_length/2 ]).
:- use_module(library(option), [option/2]).
/** <module> CityJSON: buildings and terrain as solids, surfaces and lines.

Versions 1.0, 1.1 and 2.0. Each geometry of each object is a segment, named by
the object: a Solid is a solid, a MultiSolid as many, a CompositeSolid the glue
of as many; surfaces, lines and points are surfaces and curves. Of an object
with several levels of detail the highest is read, or the one that was asked
for. A Solid that is open, as one without a floor, is a surface, or
gets a floor (cityjson_floor.pl).

Coordinates are integers times a scale, moved: that is computed by rationals,
and rounded once. Nothing is read of what has a fault: the error names the path
in the file.

library(http/json) is loaded with the first such file.
*/

%!  read_cityjson(+File, +Options) is det.
%
%   Add the geometries in File to the current world. Options: lod(Text), the
%   level of detail; close(true): open solids get flat floors. A warning says
%   how many solids were open, one how many geometries were left out, and one
%   how many surfaces have no area. Call it in a transaction.
%
%   @error error(model_error(cityjson(Path, Why)), location(File, Line, 0)),
%   and as of with_text/4: a text that is too large or too deep

read_cityjson(File, Options) :-
    json_of(File, Json),
    catch(city_read(Json, Options, Counts), cityjson(Path, Why),
          throw(error(model_error(cityjson(Path, Why)),
                      location(File, 0, 0)))),
    Counts = counts(_, Open, Left, Floors, Flat),
    (   integer(Floors),
        Floors > 0
    ->  print_message(informational, sanggwan(cityjson_floors(File, Floors)))
    ;   true
    ),
    (   Open > 0
    ->  print_message(warning, sanggwan(cityjson_open(File, Open)))
    ;   true
    ),
    (   Left > 0
    ->  print_message(warning, sanggwan(cityjson_left_out(File, Left)))
    ;   true
    ),
    (   Flat > 0
    ->  print_message(warning, sanggwan(cityjson_no_area(File, Flat)))
    ;   true
    ).

json_of(File, Json) :-
    use_module(library(http/json), []),
    with_text(json, File, text(Name, _, In),
              sg_cityjson:json_in(In, Name, Json)).

json_in(In, Name, Json) :-
    catch(json:json_read_dict(In, Json, [value_string_as_atom(false)]),
          error(syntax_error(_), Context),
          ( place(Context, Line),
            throw(error(model_error(cityjson('/', syntax)),
                        location(Name, Line, 0))) )).

place(Context, Line) :-
    (   nonvar(Context),
        Context = stream(_, Line, _, _)
    ->  true
    ;   Line = 0
    ).

fault(Path, Why) :-
    path_text(Path, Text),
    throw(cityjson(Text, Why)).

%   city_read(Json, Options, Counts): counts(Segments, Open, LeftOut, Floors,
%   Flat): Floors of solids that got some, or `none` if that is not asked for.

city_read(Json, Options, Counts) :-
    (   is_dict(Json),
        get_dict(type, Json, "CityJSON")
    ->  true
    ;   fault('/type', no_cityjson)
    ),
    needed(version, Json, '/', Version),
    (   string(Version),
        member(Known, ["1.0","1.1","2.0"]),
        string_concat(Known, _, Version)
    ->  true
    ;   fault('/version', version(Version))
    ),
    needed('CityObjects', Json, '/', Objects),
    needed(vertices, Json, '/', List),
    transform(Json, Transform),
    placed_vertices(List, Transform, Vertices),
    (   is_dict(Objects)
    ->  dict_pairs(Objects, _, Pairs)
    ;   fault('/CityObjects', nesting)
    ),
    (   option(close(true), Options)
    ->  Floors = 0
    ;   Floors = none
    ),
    foldl(object_read(Vertices, Options), Pairs, counts(0,0,0,Floors,0),
          Counts),
    (   Counts = counts(0, _, _, _, _),
        option(lod(Lod), Options)
    ->  fault('/CityObjects', no_lod(Lod))
    ;   true
    ).

needed(Key, Dict, Path, Value) :-
    (   \+ is_dict(Dict)
    ->  fault(Path, nesting)
    ;   get_dict(Key, Dict, Value)
    ->  true
    ;   fault(Path, missing(Key))
    ).

transform(Json, transform(Scale,Translate)) :-
    (   get_dict(transform, Json, Dict)
    ->  needed(scale, Dict, '/transform', Scale0),
        needed(translate, Dict, '/transform', Translate0),
        exact_triple(Scale0, '/transform/scale', Scale),
        exact_triple(Translate0, '/transform/translate', Translate)
    ;   Scale = [1,1,1],
        Translate = [0,0,0]
    ).

exact_triple(List, Path, Exact) :-
    (   is_list(List),
        length(List, 3),
        maplist(exact, List, Exact)
    ->  true
    ;   fault(Path, triple)
    ).

%   exact(Number, Rational): the decimal number that was written.

exact(Number, Rational) :-
    number(Number),
    catch(Rational is rationalize(Number), error(_, _), fail).

%   placed_vertices(List, Transform, Vertices): a term with a point for each.

placed_vertices(List, Transform, Vertices) :-
    (   is_list(List)
    ->  true
    ;   fault('/vertices', nesting)
    ),
    foldl(placed_vertex(Transform), List, Points, 0, _),
    compound_name_arguments(Vertices, vertices, Points).

placed_vertex(transform(Scale,Translate), Triple, p(X,Y,Z), I, I1) :-
    (   is_list(Triple),
        length(Triple, 3),
        foldl(placed, Triple, Scale, Translate-[X,Y,Z], []-[])
    ->  true
    ;   format(atom(Path), '/vertices/~d', [I]),
        fault(Path, triple)
    ),
    (   abs(X) =< 1.0e90,
        abs(Y) =< 1.0e90,
        abs(Z) =< 1.0e90
    ->  true
    ;   format(atom(Far), '/vertices/~d', [I]),
        fault(Far, too_far)
    ),
    I1 is I+1.

placed(N, Scale, [Move|Moves]-[X|Xs], Moves-Xs) :-
    exact(N, Exact),
    catch(X is float(Exact*Scale+Move)+0.0, error(_, _), X = inf).


                /*******************************
                *           OBJECTS            *
                *******************************/

object_read(Vertices, Options, Id-Object, Counts0, Counts) :-
    format(atom(Path), '/CityObjects/~w', [Id]),
    (   is_dict(Object)
    ->  true
    ;   fault(Path, nesting)
    ),
    (   get_dict(geometry, Object, Geometries)
    ->  (   is_list(Geometries)
        ->  true
        ;   fault(Path, nesting)
        )
    ;   Geometries = []
    ),
    findall(I-Geometry, nth0(I, Geometries, Geometry), Numbered),
    wanted(Numbered, Path, Options, Wanted),
    foldl(geometry_read(Vertices, Id, Path), Wanted, Counts0, Counts).

%   wanted(Numbered, Path, Options, Wanted): those of the level of detail.

wanted(Numbered, Path, Options, Wanted) :-
    findall(Lod-(I-Geometry),
            ( member(I-Geometry, Numbered),
              lod_of(Geometry, Path, I, Lod) ),
            Pairs),
    (   option(lod(Asked0), Options)
    ->  atom_string(Asked0, Asked)
    ;   findall(Lod, member(Lod-_, Pairs), Lods0),
        sort(Lods0, Lods),
        (   last(Lods, Asked)
        ->  true
        ;   Asked = ""
        )
    ),
    findall(One, member(Asked-One, Pairs), Wanted).

lod_of(Geometry, Path, I, Lod) :-
    (   is_dict(Geometry)
    ->  true
    ;   format(atom(At), '~w/geometry/~d', [Path, I]),
        fault(At, nesting)
    ),
    (   get_dict(lod, Geometry, Lod0)
    ->  format(string(Lod), '~w', [Lod0])
    ;   Lod = ""
    ).

geometry_read(Vertices, Id, Path0, I-Geometry, Counts0, Counts) :-
    format(atom(Path), '~w/geometry/~d', [Path0, I]),
    needed(type, Geometry, Path, Type),
    (   Type == "GeometryInstance"
    ->  Counts0 = counts(N, Open, Left0, Floors, Flat),
        Left is Left0+1,
        Counts = counts(N, Open, Left, Floors, Flat)
    ;   needed(boundaries, Geometry, Path, Boundaries),
        atom_concat(Path, '/boundaries', At),
        (   geometry_type(Type, Depth)
        ->  nested(Depth, Boundaries, At),
            type_read(Type, Boundaries, At, Vertices, Id, Counts0, Counts)
        ;   fault(Path, geometry(Type))
        )
    ).

%   geometry_type(Type, Depth): its boundaries are lists Depth deep, of indices.

geometry_type("MultiPoint",       1).
geometry_type("MultiLineString",  2).
geometry_type("MultiSurface",     3).
geometry_type("CompositeSurface", 3).
geometry_type("Solid",            4).
geometry_type("MultiSolid",       5).
geometry_type("CompositeSolid",   5).

nested(Depth, List, Path) :-
    (   is_list(List)
    ->  true
    ;   fault(Path, nesting)
    ),
    (   Depth =:= 1,
        maplist(integer, List)
    ->  true
    ;   items_nested(List, 0, Depth, Path)
    ).

items_nested([], _, _, _).
items_nested([Item|Items], I, Depth, Path) :-
    item_path(Path, I, At),
    (   Depth > 1
    ->  Depth1 is Depth-1,
        nested(Depth1, Item, At)
    ;   integer(Item)
    ->  true
    ;   fault(At, index(Item))
    ),
    I1 is I+1,
    items_nested(Items, I1, Depth, Path).

%   item_path(Path, I, At): a path is an atom, or Path/I: it is seldom told.

item_path(Path, I, Path/I).

path_text(Path/I, Text) :-
    !,
    path_text(Path, Text0),
    format(atom(Text), '~w/~d', [Text0, I]).
path_text(Path, Path).

type_read("Solid", Shells, Path, Vertices, Id, Counts0, Counts) :-
    solid_read(Id, Vertices, Path, Shells, _, Counts0, Counts).
type_read("MultiSolid", Solids, Path, Vertices, Id, Counts0, Counts) :-
    solids_read(Id, Solids, Path, Vertices, _, Counts0, Counts).
type_read("CompositeSolid", Solids, Path, Vertices, Id, Counts0, Counts) :-
    solids_read(Id, Solids, Path, Vertices, Ss, Counts0, Counts),
    (   Ss == []
    ->  true
    ;   fresh_id(segment, 0, S),
        assert_fact(segment(S, cells, named(Id, glue(Ss))))
    ).
type_read("MultiSurface", Surfaces, Path, Vertices, Id, Counts0, Counts) :-
    surface_read(Id, Vertices, Path, Surfaces, Counts0, Counts).
type_read("CompositeSurface", Surfaces, Path, Vertices, Id, Counts0,
          Counts) :-
    surface_read(Id, Vertices, Path, Surfaces, Counts0, Counts).
type_read("MultiLineString", Lines, Path, Vertices, Id, Counts0, Counts) :-
    curve_read(Id, Vertices, Path, Lines),
    counted(Counts0, 0, 0, Counts).
type_read("MultiPoint", Points, Path, Vertices, Id, Counts0, Counts) :-
    findall([Point], member(Point, Points), Lines),
    curve_read(Id, Vertices, Path, Lines),
    counted(Counts0, 0, 0, Counts).

%   counted(Counts0, More, Flat, Counts): one segment more, More of which are
%   open; Flat of its surfaces have no area.

counted(counts(N0, Open0, Left, Floors, Flat0), More, Flat1,
        counts(N, Open, Left, Floors, Flat)) :-
    N is N0+1,
    Open is Open0+More,
    Flat is Flat0+Flat1.

solids_read(Id, Solids, Path, Vertices, Ss, Counts0, Counts) :-
    findall(I-Shells, nth0(I, Solids, Shells), Numbered),
    foldl(member_read(Id, Vertices, Path), Numbered, Ss, Counts0, Counts).

member_read(Id, Vertices, Path, I-Shells, S, Counts0, Counts) :-
    item_path(Path, I, At),
    K is I+1,
    atomic_list_concat([Id,K], '.', Name),
    solid_read(Name, Vertices, At, Shells, S, Counts0, Counts).

%   solid_read(Name, Vertices, Path, Shells, S, Counts0, Counts): its shells are
%   one segment, a surface if an edge has no opposite.

solid_read(Name, Vertices, Path, Shells, S, Counts0, Counts) :-
    findall(At-Surface,
            ( nth0(I, Shells, Surfaces),
              nth0(J, Surfaces, Surface),
              At = Path/I/J ),
            Numbered),
    surfaces_rings(Numbered, Vertices, Faces0, Flat),
    solid_faces(Faces0, Vertices, Faces, Kind, More, Counts0, Counts1),
    faces_written(Kind, Name, Vertices, Faces, S),
    counted(Counts1, More, Flat, Counts).

solid_faces(Faces, _, Faces, solid, 0, Counts, Counts) :-
    closed(Faces),
    !.
solid_faces(Faces0, Vertices, Faces, solid, 0,
            counts(N,Open,Left,Floors0,Flat),
            counts(N,Open,Left,Floors,Flat)) :-
    integer(Floors0),
    floors_added(Vertices, Faces0, Faces),
    closed(Faces),
    !,
    Floors is Floors0+1.
solid_faces(Faces, _, Faces, surface, 1, Counts, Counts).

surface_read(Name, Vertices, Path, Surfaces, Counts0, Counts) :-
    findall(At-Surface,
            ( nth0(I, Surfaces, Surface), item_path(Path, I, At) ),
            Numbered),
    surfaces_rings(Numbered, Vertices, Faces, Flat),
    faces_written(surface, Name, Vertices, Faces, _),
    counted(Counts0, 0, Flat, Counts).

%   surfaces_rings(Numbered, Vertices, Faces, Flat): rings of indices, checked.
%   Surfaces whose outer ring has no area are left out, Flat of them, and such
%   holes.

surfaces_rings(Numbered, Vertices, Faces, Flat) :-
    compound_name_arity(Vertices, _, Count),
    findall(Rings,
            ( member(Path-Surface, Numbered),
              (   Surface == []
              ->  fault(Path, ring)
              ;   true
              ),
              findall(Ring,
                      ( nth0(I, Surface, Ring0),
                        item_path(Path, I, At),
                        ring(Ring0, At, Count, Ring) ),
                      Rings) ),
            All),
    partition(has_area, All, Faces0, None),
    maplist(exclude(==([])), Faces0, Faces),
    length(None, Flat).

has_area([[_|_]|_]).

%   ring(Ring0, Path, Count, Ring): a vertex that is there again at once is
%   there once, also if the ring ends where it begins. Of fewer than three
%   nothing is left then.

ring(Ring0, Path, Count, Ring) :-
    indices_there(Ring0, Path, Count),
    (   Ring0 = [_,_,_|_]
    ->  true
    ;   fault(Path, ring)
    ),
    once_each(Ring0, Each),
    (   Each = [First,_|_],
        append(Open, [First], Each)
    ->  true
    ;   Open = Each
    ),
    (   sort(Open, [_,_,_|_])
    ->  Ring = Open
    ;   Ring = []
    ).

once_each([], []).
once_each([A,B|As], Bs) :-
    A == B,
    !,
    once_each([B|As], Bs).
once_each([A|As], [A|Bs]) :-
    once_each(As, Bs).

indices_there(Indices, Path, Count) :-
    (   nth0(I, Indices, Index),
        ( Index < 0 ; Index >= Count )
    ->  item_path(Path, I, At),
        fault(At, index(Index, Count))
    ;   true
    ).

%   closed(Faces): each edge has its opposite.

closed(Faces) :-
    findall(A-B, ( member(Rings, Faces), member(Ring, Rings),
                   ring_edge(Ring, A, B) ), Edges0),
    msort(Edges0, Edges),
    findall(B-A, member(A-B, Edges0), Turned0),
    msort(Turned0, Edges).

ring_edge([First|Rest], A, B) :-
    pair_of([First|Rest], First, A, B).

pair_of([A], First, A, First).
pair_of([A,B|_], _, A, B).
pair_of([_,B|Rest], First, A0, B0) :-
    pair_of([B|Rest], First, A0, B0).


                /*******************************
                *             ROWS             *
                *******************************/

faces_written(Kind, Name, Vertices, Faces, S) :-
    fresh_id(segment, 0, S),
    assert_fact(segment(S, Kind, Name)),
    append(Faces, Rings),
    append(Rings, Indices0),
    sort(Indices0, Indices),
    numbered(Indices, Ids),
    (   maplist(same_length([_]), Faces),
        maplist(maplist(id_of(Ids)), Rings, Chains),
        maplist(place_of(Vertices), Indices, Points),
        shape_write(S, Points, Chains, true)
    ->  true
    ;   foldl(vertex_written(S, Vertices), Indices, 1, _),
        foldl(face_written(S, Ids), Faces, 1-1, _)
    ).

%   numbered(Indices, Ids): those of vertices, in order, from 1.

numbered(Indices, Ids) :-
    findall(Index-V, nth1(V, Indices, Index), Pairs),
    ord_list_to_assoc(Pairs, Ids).

place_of(Vertices, Index, point(X,Y,Z)) :-
    Arg is Index+1,
    arg(Arg, Vertices, p(X,Y,Z)).

vertices_written(S, Indices0, Vertices, Ids) :-
    sort(Indices0, Indices),
    numbered(Indices, Ids),
    foldl(vertex_written(S, Vertices), Indices, 1, _).

vertex_written(S, Vertices, Index, V, V1) :-
    place_of(Vertices, Index, point(X,Y,Z)),
    assert_fact(v(S, V, X, Y, Z)),
    V1 is V+1.

face_written(S, Ids, Rings, P-E0, P1-E) :-
    foldl(ring_written(S, Ids), Rings, E0-[], E-Es),
    assert_fact(p(S, P, Es)),
    P1 is P+1.

ring_written(S, Ids, Ring, E0-Es0, E-Es) :-
    maplist(id_of(Ids), Ring, Vs),
    Vs = [First|Rest],
    append(Rest, [First], Nexts),
    edges_written(Vs, Nexts, S, E0, E, New),
    append(Es0, New, Es).

id_of(Ids, Index, V) :-
    get_assoc(Index, Ids, V).

edges_written([], _, _, E, E, []).
edges_written([A|As], [B|Bs], S, E0, E, [E0|Es]) :-
    assert_fact(e(S, E0, A, B, 1)),
    E1 is E0+1,
    edges_written(As, Bs, S, E1, E, Es).

curve_read(Name, Vertices, Path, Lines) :-
    compound_name_arity(Vertices, _, Count),
    forall(nth0(I, Lines, Line),
           ( item_path(Path, I, At), indices_there(Line, At, Count) )),
    fresh_id(segment, 0, S),
    assert_fact(segment(S, curve, Name)),
    append(Lines, Indices),
    vertices_written(S, Indices, Vertices, Ids),
    foldl(line_written(S, Ids), Lines, 1, _).

line_written(S, Ids, Line, E0, E) :-
    maplist(id_of(Ids), Line, Vs),
    (   Vs = [_|Nexts],
        append(Starts, [_], Vs)
    ->  edges_written(Starts, Nexts, S, E0, E, _)
    ;   E = E0
    ).
