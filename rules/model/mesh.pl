:- module(sg_mesh,
          [ read_mesh/2,                % +File, -Segments
            read_mesh/3,                % +File, -Segments, +Options
            write_mesh/2,               % +File, +Segments
            write_mesh/3,               % +File, +Segments, +Options
            mesh_ending/2,              % ?Ending, ?Format
            mesh_file_format/3,         % +File, +Options, -Format
            mesh_to_file/2,             % +File, :Goal
            mesh_names/4,               % +File, +Format, +Names0, -Names
            mesh_outcome/1              % +Outcome
          ]).
:- use_module('../kernel',
              [ mesh_add/6, mesh_write/5, boundary_open/7, boundary_write/5,
                boundary_close/1
              ]).
:- use_module('../output', [asked_for/2, writing/3]).
:- use_module('../plain', [plain_text/2]).
:- use_module('../text_file', [with_bytes/3]).
:- use_module('../store',
              [ segment/3, assert_fact/1, facts_transaction/1, fresh_id/3 ]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [foldl/5, maplist/2, maplist/3]).
:- use_module(library(error), [domain_error/2, existence_error/2, must_be/2]).
:- use_module(library(lists), [member/2]).
:- use_module(library(option), [option/3]).
:- use_module(library(pairs), [pairs_keys_values/3]).
/** <module> Mesh files: STL, OFF, OBJ and PLY into the world.

A file is one segment, unless it names several: the solids of a text STL, the
objects of an OBJ or, without objects, its groups. A segment is a `solid` if
every directed edge has as many opposite ones, else a `surface`, and a `curve`
without polygons. It has its name from the file, or else the file's name.
Vertices, edges and polygons are numbered from 1 in the order of the file. If
the coordinates are rounded (float32, or 6 to 15 digits), `origin(S, s(S),
source(Grain))` holds one unit in their last place (docs/precision.md).

What is taken and what is passed over: c_kernels/model/mesh.h.

Errors are error(model_error(mesh(Fault)), location(File, Line, Column)), in
binary data error(model_error(mesh(Fault, Byte)), location(File, 0, 0)):

    empty_file  no_faces  unknown_format  unsupported(Text)
    expected(Wanted, Text)  bad_number(Text)  not_finite(Text)
    too_far(Text)
    bad_index(Index, Lowest, Highest)  bad_count(What, Text)
    truncated(What, Present, Needed)  short_face(Corners)  too_large
    no_property(Property, Element)

and cannot_read(Why), as for model files.
*/

%!  mesh_ending(?Ending, ?Format) is nondet.
%
%   True when the names of files in Format end in `.`Ending.

mesh_ending(stl, stl).
mesh_ending(off, off).
mesh_ending(obj, obj).
mesh_ending(ply, ply).

%!  read_mesh(+File, -Segments) is det.
%!  read_mesh(+File, -Segments, +Options) is det.
%
%   Add the mesh in File (`-`: standard input) to the current world; Segments
%   are the numbers of the new segments. Options:
%
%     - format(Format)
%       `stl`, `off`, `obj`, `ply` or `any`: what it looks like. By default by
%       the file's ending.
%     - weld(Which)
%       Join vertices of equal coordinates: `all`, `none` or `auto`: always
%       in STL, elsewhere if no two faces share a vertex.
%     - segments(Which)
%       `named`, or `one` for one segment whatever the file names.
%
%   @error model_error(Fault), see above; the world is then as before.

read_mesh(File, Segments) :-
    read_mesh(File, Segments, []).

read_mesh(File, Segments, Options) :-
    file_format(File, Format0),
    option(format(Format), Options, Format0),
    option(weld(Weld), Options, auto),
    option(segments(Which), Options, named),
    must_be(oneof([one,named]), Which),
    (   Which == one
    ->  One = true
    ;   One = false
    ),
    facts_transaction(sg_mesh:mesh_added(File, Format, Weld, One, Segments)).

mesh_added(File, Format, Weld, One, Segments) :-
    fresh_id(segment, 0, S),
    with_bytes(File, Stream,
               mesh_add(Stream, Format, Weld, One, S, Result)),
    mesh_taken(Result, File, Segments).

file_format(File, Format) :-
    file_name_extension(_, Ending0, File),
    downcase_atom(Ending0, Ending),
    (   mesh_ending(Ending, Format0)
    ->  Format = Format0
    ;   Format = any
    ).

mesh_taken(loaded(Parts, Grain, PassedOver), File, Segments) :-
    file_base(File, Base),
    maplist(part_named(Base, Grain), Parts, Segments),
    passed_over(PassedOver, File).
mesh_taken(fault(Code, Line, Column, Byte, Text, Wanted, Got, Limit), File,
           _) :-
    place(File, Name),
    fault_term(Code, Text, Wanted, Got, Limit, Fault),
    (   Line =:= 0
    ->  throw(error(model_error(mesh(Fault, Byte)), location(Name, 0, 0)))
    ;   throw(error(model_error(mesh(Fault)), location(Name, Line, Column)))
    ).

part_named(Base, Grain, part(S, Kind, Name0), S) :-
    (   Name0 == ''
    ->  Name = Base
    ;   Name = Name0
    ),
    assert_fact(segment(S, Kind, Name)),
    (   Grain > 0.0
    ->  assert_fact(origin(S, s(S), source(Grain)))
    ;   true
    ).

file_base(-, stdin) :-
    !.
file_base(File, Base) :-
    file_base_name(File, Name),
    file_name_extension(Base, _, Name).

place(-, '<stdin>') :-
    !.
place(File, File).

fault_term(unsupported, Text, _, _, _, unsupported(Text)) :- !.
fault_term(expected, Text, Wanted, _, _, expected(Wanted, Text)) :- !.
fault_term(bad_number, Text, _, _, _, bad_number(Text)) :- !.
fault_term(not_finite, Text, _, _, _, not_finite(Text)) :- !.
fault_term(too_far, Text, _, _, _, too_far(Text)) :- !.
fault_term(bad_index, _, Wanted, Got, Limit, bad_index(Got, Lowest, Limit)) :-
    !,
    atom_number(Wanted, Lowest).
fault_term(bad_count, Text, Wanted, _, _, bad_count(Wanted, Text)) :- !.
fault_term(truncated, _, Wanted, Got, Limit, truncated(Wanted, Got, Limit)) :-
    !.
fault_term(short_face, _, _, Got, _, short_face(Got)) :- !.
fault_term(no_property, Text, Wanted, _, _, no_property(Wanted, Text)) :- !.
fault_term(Code, _, _, _, _, Code).

%   passed_over(Counts, File): warn of what was in the file and is not in the
%   world. (Corners repeated in a face and welded vertices lose nothing.)

passed_over(passed_over(Degenerate, _, _, Ignored, Line, Trailing), File) :-
    place(File, Name),
    warned(Degenerate, mesh(Name, degenerate(Degenerate))),
    warned(Ignored, mesh(Name, ignored(Ignored, Line))),
    warned(Trailing, mesh(Name, trailing(Trailing))).

warned(0, _) :-
    !.
warned(_, What) :-
    print_message(warning, sanggwan(What)).

%!  write_mesh(+File, +Segments) is det.
%!  write_mesh(+File, +Segments, +Options) is det.
%
%   Write the listed segments of the current world, or `all`, to File (`-`:
%   standard output). Text has the shortest decimals that read back to the same
%   coordinates. Options:
%
%     - format(Format)
%       `stl`, `off`, `obj` or `ply`, by default by the file's ending.
%     - binary(Bool)
%       Of STL (rounds to float32) and PLY (doubles); default `false`.
%     - canonical(true)
%       Each segment in an order that depends on where things are alone, and
%       cleaned, as write_solid/3 does; its curves are left out. By default
%       vertices and faces stay in the order they have.
%
%   A polygon with holes is written as its triangles, in STL every polygon; so
%   complete_segments/0 must have been called for these. STL and OBJ keep
%   segments and names, OFF and PLY put all in one.
%
%   @error existence_error(segment, S), domain_error(mesh_ending, File),
%          geometry_error(no_triangles(S, P)),
%          geometry_error(mesh_write(Fault)): binary STL holds no coordinate
%          above 3.4e38

write_mesh(File, Segments) :-
    write_mesh(File, Segments, []).

write_mesh(File, Segments0, Options) :-
    mesh_file_format(File, Options, Format),
    segments_names(Segments0, Segments, Names0),
    mesh_names(File, Format, Names0, Names),
    option(canonical(Canonical), Options, false),
    must_be(boolean, Canonical),
    (   Canonical == true
    ->  mesh_to_file(File, sg_mesh:canonical_written(Format, Segments, Names))
    ;   mesh_to_file(File, sg_mesh:mesh_written(Format, Segments, Names)),
        without_curves(Format, File, Segments)
    ).

:- meta_predicate mesh_to_file(+, 1).

%!  mesh_to_file(+File, :Goal) is det.
%
%   Call Goal with one more argument, a binary stream that is File (`-`:
%   standard output) afterwards.

mesh_to_file(-, Goal) :-
    !,
    setup_call_cleanup(
        set_stream(user_output, type(binary)),
        call(Goal, user_output),
        set_stream(user_output, type(text))).
mesh_to_file(File, Goal) :-
    writing(File, binary, Goal).

%!  mesh_names(+File, +Format, +Names0:list, -Names:list) is det.
%
%   Names are those of segments, Names0, as a File in Format has them: its names
%   are a line each, and it has no escapes, so what is not seen stands there as
%   in plain_text/2, line ends and tabs as blanks. That is a warning.

mesh_names(File, Format, Names0, Names) :-
    (   memberchk(Format, [stl, obj])
    ->  foldl(mesh_name, Names0, Names, 0, N),
        asked_for(File, Target),
        warned(N, mesh(Target, other_names(N)))
    ;   Names = Names0
    ).

mesh_name(Name0, Name, N0, N) :-
    (   ( atom(Name0) ; string(Name0) )
    ->  Text0 = Name0
    ;   format(string(Text0), "~q", [Name0])
    ),
    atom_codes(Text0, Codes0),
    maplist(line_code, Codes0, Codes),
    string_codes(Text1, Codes),
    plain_text(Text1, Text),
    (   string_codes(Text, Codes0)
    ->  Name = Text0,
        N = N0
    ;   Name = Text,
        N is N0+1
    ).

line_code(Code0, Code) :-
    (   between(9, 13, Code0)
    ->  Code = 32
    ;   Code = Code0
    ).

%   without_curves(Format, File, Segments): warn of what STL cannot hold.

without_curves(Format, File, Segments) :-
    memberchk(Format, [stl, stl_binary]),
    aggregate_all(count,
                  ( member(S, Segments), segment(S, curve, _) ), Curves),
    !,
    asked_for(File, Target),
    warned(Curves, mesh(Target, no_curves(Curves))).
without_curves(_, _, _).

%!  mesh_file_format(+File, +Options, -Format) is det.
%
%   Format, as mesh_write/5 knows it, is that of File by its ending and the
%   options format(_) and binary(_).
%
%   @error domain_error(mesh_ending, File)

mesh_file_format(File, Options, Format) :-
    file_format(File, Format0),
    option(format(Format1), Options, Format0),
    (   mesh_ending(_, Format1)
    ->  true
    ;   domain_error(mesh_ending, File)
    ),
    option(binary(Binary), Options, false),
    must_be(boolean, Binary),
    (   Binary == true,
        binary_format(Format1, Format2)
    ->  Format = Format2
    ;   Format = Format1
    ).

binary_format(stl, stl_binary).
binary_format(ply, ply_binary).

segments_names(all, Segments, Names) :-
    !,
    findall(S-Name, ( segment(S, Kind, Name), Kind \== pattern ), Pairs0),
    sort(1, @=<, Pairs0, Pairs),
    pairs_keys_values(Pairs, Segments, Names).
segments_names(Segments0, Segments, Names) :-
    sort(Segments0, Segments),
    maplist(segment_name, Segments, Names).

segment_name(S, Name) :-
    (   segment(S, _, Name0)
    ->  Name = Name0
    ;   existence_error(segment, S)
    ).

mesh_written(Format, Segments, Names, Stream) :-
    mesh_write(Stream, Format, Segments, Names, Result),
    mesh_outcome(Result).

%   canonical_written(Format, Segments, Names, Stream)

canonical_written(Format, Segments, Names, Stream) :-
    (   memberchk(Format, [stl, stl_binary])
    ->  Form = triangles,
        Copies = false
    ;   Form = polygons,
        Copies = true
    ),
    (   Format == stl_binary
    ->  Single = true
    ;   Single = false
    ),
    setup_call_cleanup(
        boundary_open(Segments, [], Single, 0.0, Form, Copies, Boundary),
        boundary_write(Boundary, Stream, Format, Names, Result),
        boundary_close(Boundary)),
    mesh_outcome(Result).

%!  mesh_outcome(+Outcome) is det.
%
%   Raise what went wrong, as mesh_write/5 gives it.

mesh_outcome(Result) :-
    (   Result == ok
    ->  true
    ;   Result = no_triangles(_, _)
    ->  throw(error(geometry_error(Result), _))
    ;   Result = fault(Code, _, _, _, Text, Wanted, Got, Limit),
        fault_term(Code, Text, Wanted, Got, Limit, Fault),
        throw(error(geometry_error(mesh_write(Fault)), _))
    ).
