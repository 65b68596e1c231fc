:- module(test_mesh_written, []).
% covers: mesh_export
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(occurs)).
:- use_module(library(random)).
:- use_module(library(readutil)).
:- use_module(library(yall)).
:- use_module(mesh_reader).
:- use_module(rules(model/mesh)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module('../random_solid').

/* Mesh files as they are written, read by readers of our own (mesh_reader.pl):
   the faces are the polygons of the model, or its triangles, in their order. */

format_options(stl, stl, []).
format_options(stl_binary, stl, [binary(true)]).
format_options(off, off, []).
format_options(obj, obj, []).
format_options(ply, ply, []).
format_options(ply_binary, ply, [binary(true)]).

%   faces_read(Format, Faces): of the world, as a file of Format has it.

faces_read(Format, Faces) :-
    format_options(Format, Ending, Options),
    setup_call_cleanup(
        tmp_file_stream(File, Out, [encoding(octet), extension(Ending)]),
        ( close(Out),
          write_mesh(File, all, Options),
          read_file_to_codes(File, Codes, [type(binary)]) ),
        delete_file(File)),
    read_faces(Format, Codes, Faces).

%   faces_known(Format, Faces): by the facts.

faces_known(Format, Faces) :-
    (   memberchk(Format, [stl,stl_binary])
    ->  findall(S-P-T-[A,B,C], t(S, P, T, A, B, C), Triangles0),
        sort(Triangles0, Triangles),
        findall(Face, ( member(S-_-_-Vs, Triangles),
                        findall(Point, corner(S, Vs, Point), Face) ),
                Faces0)
    ;   findall(S-P, p(S, P, _), Ps0),
        sort(Ps0, Ps),
        findall(Face, ( member(S-P, Ps), once(p(S, P, Es)),
                        findall(Point, ( member(E, Es), e(S, E, V, _, _),
                                         corner(S, [V], Point) ),
                                Face) ),
                Faces0)
    ),
    (   Format == stl_binary
    ->  maplist([Points0,Points]>>maplist(single, Points0, Points), Faces0,
                Faces)
    ;   Faces = Faces0
    ).

corner(S, Vs, X-Y-Z) :-
    member(V, Vs),
    v(S, V, X, Y, Z).

single(X0-Y0-Z0, X-Y-Z) :-
    maplist(as_float32, [X0,Y0,Z0], [X,Y,Z]).

%   The same cycles of corners, in the same order.

same_faces([], []).
same_faces([Face0|Faces0], [Face|Faces]) :-
    append(Front, Back, Face0),
    append(Back, Front, Face),
    !,
    same_faces(Faces0, Faces).

%   A polygon with holes is written as triangles.

has_holes(Term) :-
    sub_term(Inner, Term),
    compound(Inner),
    compound_name_arity(Inner, Name, _),
    memberchk(Name, [hollow_cylinder,holes]),
    !.

case(Seed, Format) :-
    between(1, 12, Seed),
    format_options(Format, _, _).

:- begin_tests(mesh_written).

test(faces, forall(case(Seed, Format))) :-
    set_random(seed(Seed)),
    new_world(World),
    in_world(World,
             ( repeat,
               random_placed(Term),
               \+ has_holes(Term),
               catch(add_primitive(Term, _), error(_, _), fail),
               !,
               complete_segments,
               faces_known(Format, Known),
               faces_read(Format, Read) )),
    Known \== [],
    (   same_faces(Known, Read)
    ->  true
    ;   format(user_error, 'seed ~w, ~w~n', [Seed,Format]),
        fail
    ).

:- end_tests(mesh_written).
