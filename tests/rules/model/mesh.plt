:- encoding(utf8).
:- use_module(library(plunit)).
:- use_module(rules(kernel), [mesh_add/6]).
:- use_module(rules(model/mesh)).
:- use_module(rules(message/messages)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).

% Mesh files into the world and out of it. What the readers take and refuse in
% detail is in tests/c_kernels/model/mesh_test.c.

:- begin_tests(mesh, [setup(quiet), cleanup(loud)]).

:- dynamic warned/1.
:- multifile user:message_hook/3.

user:message_hook(sanggwan(mesh(_, What)), warning, _) :-
    assertz(plunit_mesh:warned(What)).

quiet :- retractall(warned(_)).
loud :- retractall(warned(_)).

:- meta_predicate fresh(0), with_text(+, +, -, 0).

fresh(Goal) :-
    new_world(World),
    in_world(World, Goal).

with_text(Ending, Text, File, Goal) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Stream, [extension(Ending), encoding(utf8)]),
          write(Stream, Text),
          close(Stream)
        ),
        fresh(once(Goal)),
        delete_file(File)).

cube_off("OFF 8 6 12\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n2 2 2\n0 2 2\n\c
4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n").

counts(V, E, P) :-
    aggregate_all(count, v(_, _, _, _, _), V),
    aggregate_all(count, e(_, _, _, _, _), E),
    aggregate_all(count, p(_, _, _), P).

contents(Vs, Ps) :-
    findall(v(V,X,Y,Z), v(_, V, X, Y, Z), Vs),
    findall(Cs, ( p(S, _, Es), findall(V1, ( member(E, Es),
                                            e(S, E, V1, _, _) ), Cs) ), Ps).

test(cube, Kind-V-E-P == solid-8-24-6) :-
    cube_off(Text),
    with_text(off, Text, File,
              ( read_mesh(File, [S]), segment(S, Kind, _), counts(V, E, P) )).
test(only_into_an_empty_segment, error(permission_error(write, segment, 1))) :-
    cube_off(Text),
    with_text(off, Text, File,
              ( read_mesh(File, [1]),
                setup_call_cleanup(open(File, read, In, [type(binary)]),
                                   mesh_add(In, off, auto, true, 1, _),
                                   close(In)) )).
test(into_an_emptied_segment, Counts == counts(8, 24, 6)) :-
    cube_off(Text),
    with_text(off, Text, File,
              ( read_mesh(File, [1]),
                maplist(retractall_facts,
                        [p(1,_,_), e(1,_,_,_,_), v(1,_,_,_,_)]),
                setup_call_cleanup(open(File, read, In, [type(binary)]),
                                   mesh_add(In, off, auto, true, 1, _),
                                   close(In)),
                counts(V, E, P) )),
    Counts = counts(V, E, P).
test(name, Name == Base) :-
    cube_off(Text),
    with_text(off, Text, File, ( read_mesh(File, _), segment(1, _, Name) )),
    file_base_name(File, Long),
    file_name_extension(Base, _, Long).
test(exact_source, fail) :-
    cube_off(Text),
    with_text(off, Text, File, ( read_mesh(File, _), origin(_, _, _) )).
test(rounded_source, Grain =:= 1.0e-6) :-
    with_text(obj, "v 0.123456 0 0\nv 0.9 0 0\nv 0 0.5 0\nf 1 2 3\n", File,
              ( read_mesh(File, _), origin(1, s(1), source(Grain)) )).
test(open_is_a_surface, Kind == surface) :-
    with_text(obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", File,
              ( read_mesh(File, _), segment(1, Kind, _) )).
test(only_lines_is_a_curve, Kind-Es == curve-[1-2,2-3]) :-
    with_text(obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n", File,
              ( read_mesh(File, _), segment(1, Kind, _),
                findall(A-B, e(1, _, A, B, 1), Es) )).
test(names, Ss == [1-surface-'왼쪽', 2-surface-'b c']) :-
    with_text(obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\no 왼쪽\nf 1 2 3\n\c
                    o b c\nf 2 3 4\n", File,
              ( read_mesh(File, _), findall(S-K-N, segment(S, K, N), Ss) )).
test(own_vertices, Vs == [1-1.0, 2-0.0, 3-5.0]) :-
    with_text(obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\no a\nf 1 2 3\n\c
                    o b\nf 2 3 4\n", File,
              ( read_mesh(File, _), findall(V-X, v(2, V, X, _, _), Vs) )).
test(one_segment, S == [1]) :-
    with_text(obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\no a\nf 1 2 3\no b\nf 3 2 1\n",
              File, read_mesh(File, S, [segments(one)])).
test(after_what_is_there, S == [2]) :-
    cube_off(Text),
    with_text(off, Text, File, ( read_mesh(File, _), read_mesh(File, S) )).
test(warning, W == [degenerate(1)]) :-
    quiet,
    with_text(obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\n", File,
              read_mesh(File, _)),
    findall(X, warned(X), W).

% Errors: named, placed, and nothing half-loaded.

fault(Ending, Text, What, Line) :-
    with_text(Ending, Text, File,
              ( catch(read_mesh(File, _),
                      error(model_error(What), location(File, Line, _)),
                      true),
                nonvar(What),
                counts(0, 0, 0),
                \+ segment(_, _, _),
                phrase(prolog:message(error(model_error(What),
                                            location(File, Line, 1))), [_|_])
              )).

test(empty, W-L == mesh(empty_file)-1) :-
    fault(stl, "", W, L).
test(no_faces, W-L == mesh(no_faces)-3) :-
    fault(stl, "solid a\nendsolid a\n", W, L).
test(number, W-L == mesh(bad_number(x))-2) :-
    fault(obj, "v 0 0 0\nv 0 x 0\n", W, L).
test(nan, W-L == mesh(not_finite('NaN'))-1) :-
    fault(obj, "v 0 0 NaN\n", W, L).
test(index, W-L == mesh(bad_index(4,1,3))-4) :-
    fault(obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", W, L).
test(truncated, W-L == mesh(truncated(vertices,1,8))-4) :-
    fault(off, "OFF\n8 0 0\n0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n",
          W, L).
test(property, W-L == mesh(no_property(y,vertex))-3) :-
    fault(ply, "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n\c
                property float z\nend_header\n0 0\n", W, L).
test(missing, W == cannot_read(missing)) :-
    fresh(catch(read_mesh('/no/such.stl', _),
                error(model_error(W), location('/no/such.stl', 0, 0)), true)).
test(folder, W == cannot_read(directory)) :-
    fresh(catch(read_mesh('/tmp', _, [format(stl)]),
                error(model_error(W), _), true)).

% Writing: what is written reads back to the same rows.

round(Ending, Options) :-
    cube_off(Text),
    with_text(off, Text, File,
              ( read_mesh(File, _),
                complete_segments,
                contents(Vs, Ps),
                tmp_file_stream(Copy, Stream, [extension(Ending)]),
                close(Stream),
                write_mesh(Copy, all, Options),
                fresh(( read_mesh(Copy, _), contents(Vs1, Ps1) )),
                delete_file(Copy)
              )),
    msort(Vs, Vs2),
    msort(Vs1, Vs2),
    Ps == Ps1.

test(off) :- round(off, []).
test(obj) :- round(obj, []).
test(ply) :- round(ply, []).
test(ply_binary) :- round(ply, [binary(true)]).

as_triangles(Options, Kind-T) :-
    cube_off(Text),
    with_text(off, Text, File,
              ( read_mesh(File, _),
                complete_segments,
                tmp_file_stream(Copy, Stream, [extension(stl)]),
                close(Stream),
                write_mesh(Copy, [1], Options),
                fresh(( read_mesh(Copy, _), segment(1, Kind, _),
                        counts(8, _, T) )),
                delete_file(Copy)
              )).

test(stl, X == solid-12) :- as_triangles([], X).
test(stl_binary, X == solid-12) :- as_triangles([binary(true)], X).
test(no_such_segment, error(existence_error(segment, 7))) :-
    fresh(write_mesh('/tmp/never.off', [7])).
test(no_triangles, error(geometry_error(no_triangles(1, 1)), _)) :-
    cube_off(Text),
    with_text(off, Text, File,
              ( read_mesh(File, _),
                write_mesh('/tmp/never.stl', all) )).
test(nothing_left, fail) :-
    exists_file('/tmp/never.stl').

%   Names that are a line each: of these characters the first and the last that
%   are a blank, and those beside them.

test(names_of_lines, [ forall(member(Format, [stl,obj])),
                       true(Names-W == ["a b c d e f","\u2408a\u240eb",c]-
                                       [other_names(2)]) ]) :-
    quiet,
    mesh_names('a.stl', Format, ["a\tb\nc\vd\fe\rf","\u0008a\u000eb",c],
               Names),
    findall(X, warned(X), W).
test(names_with_escapes, Names-W == ["a\tb"]-[]) :-
    quiet,
    mesh_names('a.ply', ply, ["a\tb"], Names),
    findall(X, warned(X), W).

% Files from elsewhere, where they are.

data(Folder, File) :-
    atomic_list_concat(['../shared/data', Folder, File], /, Name),
    absolute_file_name(sanggwan(Name), Path,
                       [access(read), file_errors(fail)]),
    !,
    nb_setval(sg_data, Path).

has_data :-
    (   data(bad, 'empty.stl')
    ->  true
    ;   format("skipped: ../shared/data is not there~n"),
        fail
    ).

bad_file(File, What, Line) :-
    data(bad, File),
    nb_getval(sg_data, Path),
    fresh(catch(read_mesh(Path, _),
                error(model_error(mesh(What)), location(Path, Line, _)),
                true)).

:- if(has_data).
test(bad_empty, W == empty_file) :- bad_file('empty.stl', W, _).
test(bad_empty2, W == no_faces) :- bad_file('empty2.stl', W, _).
test(bad_vertex, W-L == bad_number(blah)-89) :-
    bad_file('invalidvertex.stl', W, L).
test(bad_many, W-L == expected(endloop,vertex)-91) :-
    bad_file('toomanyvertices.stl', W, L).
test(bad_text, W = bad_number(_)) :- bad_file('unparseable.stl', W, 4).
test(meshes, forall(member(File-K-V-P, [ 'cow.obj'-solid-2903-5804,
                                         'suzanne.obj'-surface-507-500,
                                         'thingi10k-65004.stl'-solid-731-1466
                                       ]))) :-
    data(meshes, File),
    nb_getval(sg_data, Path),
    fresh(( read_mesh(Path, _), segment(1, K, _), counts(V, _, P) )).
:- endif.

:- end_tests(mesh).
