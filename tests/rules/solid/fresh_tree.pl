:- module(sg_test_fresh_tree,
          [ tree_world/2,               % +Segments, -World
            fresh/1,                    % -World
            boundary/2,                 % +S, -Boundary
            file_of/2,                  % +S, -Codes
            replaced/2                  % +S, +Term
          ]).
/** <module> A tree in a world, the same in another one, and what they have.
*/

:- use_module(library(apply)).
:- use_module(library(assoc)).
:- use_module(library(lists)).
:- use_module(library(readutil)).
:- use_module(rules(csg/csg), [is_helper/1]).
:- use_module(rules(model/model)).
:- use_module(rules(model/solid_file), [write_solid/2]).
:- use_module(rules(store)).

%!  tree_world(+Segments:list, -World) is det.
%
%   A world with these segment(S, Kind, Term), as if they had been read from a
%   file.

tree_world(Segments, World) :-
    tmp_file_stream(File, Stream, [extension(pl)]),
    forall(member(Segment, Segments), format(Stream, '~q.~n', [Segment])),
    close(Stream),
    new_world(World),
    call_cleanup(in_world(World, load_model(File, [evaluate(false)])),
                 delete_file(File)).

%!  fresh(-World) is det.
%
%   Another world with the segments that are no helpers.

fresh(World) :-
    findall(segment(S, Kind, Term),
            ( segment(S, Kind, Term), \+ is_helper(S) ),
            Segments),
    tree_world(Segments, World).

%!  boundary(+S, -Boundary) is det.
%
%   What a segment has, except for ids: vertices as their places, polygons by
%   these.

boundary(S, boundary(Vertices, Polygons)) :-
    findall(V-(X-Y-Z), v(S, V, X, Y, Z), Pairs),
    list_to_assoc(Pairs, At),
    findall(vertex(Place, Froms, Origins),
            ( member(V-Place, Pairs),
              findall(From, vertex_source(S, V, From), Froms),
              findall(Name, vertex_origin(S, V, Name), Origins)
            ),
            Vertices0),
    msort(Vertices0, Vertices),
    findall(Polygon, polygon(S, At, Polygon), Polygons0),
    msort(Polygons0, Polygons).

%   Helpers have other numbers in another world.

vertex_source(S, V, From) :-
    from_v(S, V, S0, V0),
    known_source(S0, V0, From).

known_source(S0, Id, From) :-
    (   is_helper(S0)
    ->  From = helper(Id)
    ;   From = S0-Id
    ).

vertex_origin(S, V, Name) :-
    origin(S, v(V), Origin),
    (   once(is_helper(_, _))
    ->  functor(Origin, Name, _)
    ;   Name = Origin
    ).

is_helper(S, x) :-
    segment(S, _, _),
    is_helper(S).

polygon(S, At, polygon(Edges, Triangles, Plane, Sources)) :-
    p(S, P, Es),
    findall(e(A, B, Et),
            ( member(E, Es),
              e(S, E, V1, V2, Et),
              get_assoc(V1, At, A),
              get_assoc(V2, At, B)
            ),
            Edges0),
    msort(Edges0, Edges),
    findall(Triangle,
            ( t(S, P, _, V1, V2, V3),
              maplist(place_of(At), [V1,V2,V3], Corners),
              from_least(Corners, Triangle)
            ),
            Triangles0),
    msort(Triangles0, Triangles),
    findall(plane(A, B, C, D), plane(S, P, A, B, C, D), Plane),
    findall(Source-Sense,
            ( from_p(S, P, S0, P0, Sense), known_source(S0, P0, Source) ),
            Sources0),
    msort(Sources0, Sources).

place_of(At, V, Place) :-
    get_assoc(V, At, Place).

from_least([A,B,C], [X,Y,Z]) :-
    min_member(Least, [A,B,C]),
    member([X,Y,Z], [[A,B,C],[B,C,A],[C,A,B]]),
    X == Least,
    !.

%!  file_of(+S, -Codes) is det.
%
%   The mesh file of a segment.

file_of(S, Codes) :-
    (   v(S, _, _, _, _)
    ->  tmp_file_stream(File, Stream, [extension(off)]),
        close(Stream),
        call_cleanup(( write_solid(File, S),
                       read_file_to_codes(File, Codes, [])
                     ),
                     delete_file(File))
    ;   Codes = []
    ).

%!  replaced(+S, +Term) is det.

replaced(S, Term) :-
    retractall_facts(segment(S, _, _)),
    assert_fact(segment(S, solid, Term)).
