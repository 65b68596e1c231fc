/* Streams that doors write to: whole, and counted. */
:- module(test_streams, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(rules(kernel)).
:- use_module(rules(model/model)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   written(Format, Options, Set, Bytes, Count): a mesh as Format, after one
%   byte, to a file that was opened with Options and Set; Count is what the
%   stream says of itself.

:- meta_predicate written(+, +, 1, -, -).

written(Format, Options, Set, Bytes, Count-Chars) :-
    tmp_file_stream(File, Out0, [encoding(octet)]),
    close(Out0),
    in_new_world(( load_model('facts/cube.pl'),
                   complete_segments,
                   setup_call_cleanup(
                       open(File, write, Out, Options),
                       ( call(Set, Out),
                         format(Out, "x", []),
                         mesh_write(Out, Format, [1], [cube], ok),
                         byte_count(Out, Count),
                         character_count(Out, Chars) ),
                       close(Out)) )),
    read_file_to_codes(File, Bytes, [encoding(octet)]),
    delete_file(File).

as_it_is(_).

binary([encoding(octet),newline(posix)]).

:- begin_tests(streams).

test(counted, [ forall(member(Format, [stl_binary,ply_binary,off,obj])),
                true(Counted == N-N) ]) :-
    binary(Options),
    written(Format, Options, as_it_is, Bytes, Counted),
    length(Bytes, N),
    assertion(N > 100).

%   Whatever the buffer and the encoding are.

test(same, [forall(( member(Format, [stl_binary,off]),
                     member(Options, [ [encoding(utf8)],
                                       [buffer(false),encoding(octet)],
                                       [buffer(line),encoding(octet)] ]) )),
            true(Bytes == Wanted)]) :-
    binary(Binary),
    written(Format, Binary, as_it_is, Wanted, _),
    written(Format, Options, as_it_is, Bytes, _).

%   What went wrong is raised.

test(full, error(io_error(write, _))) :-
    setup_call_cleanup(
        open('/dev/full', write, Out, [encoding(octet)]),
        in_new_world(( load_model('facts/cube.pl'),
                       complete_segments,
                       mesh_write(Out, stl_binary, [1], [cube], _),
                       flush_output(Out) )),
        close(Out, [force(true)])).

test(wrong_way, error(permission_error(output, stream, _))) :-
    setup_call_cleanup(
        open('facts/cube.pl', read, In),
        in_new_world(( load_model('facts/cube.pl'),
                       complete_segments,
                       mesh_write(In, stl_binary, [1], [cube], _) )),
        close(In)).

:- end_tests(streams).
