:- encoding(utf8).
/* The verb cells: its report as text in two languages and as JSON, and files.
   What it says to the letter is in tests/transcripts/cells.txt. */
:- module(test_verbs_cells, []).
:- use_module(library(http/json)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(command/verbs_cells)).
:- use_module(rules(model/model)).
:- use_module(rules(space_limit), [with_stack_limit/2]).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

rooms(File) :-
    absolute_file_name(sanggwan('facts/two_rooms.pl'), File).

printed(Language, Options, Status, Text) :-
    rooms(File),
    current_prolog_flag(message_language, Old),
    setup_call_cleanup(
        set_prolog_flag(message_language, Language),
        with_output_to(string(Text),
                       in_new_world(cells_run([File], Options, Status))),
        set_prolog_flag(message_language, Old)).

lines(Language, Options, N) :-
    printed(Language, Options, 0, Text),
    split_string(Text, "\n", "", Lines),
    length(Lines, N).

:- begin_tests(verbs_cells).

test(same_lines, En-Neighbours == Ko-NeighboursKo) :-
    lines(en, [], En),
    lines(ko, [], Ko),
    lines(en, [neighbours(true)], Neighbours),
    lines(ko, [neighbours(true)], NeighboursKo),
    Neighbours =:= En+3.
test(json, Roles == ["cell","cell","outside"]) :-
    printed(en, [json(true)], 0, Text),
    atom_json_dict(Text, [Report], []),
    findall(Role, ( member(Region, Report.regions), Role = Region.role ),
            Roles).
test(file, Kind-N == cells-11) :-
    rooms(File),
    tmp_file_stream(Model, Stream, [extension(pl), encoding(utf8)]),
    close(Stream),
    with_output_to(string(_),
                   in_new_world(cells_run([File], [output([Model])], _))),
    in_new_world(( load_model(Model),
                   segment(1, Kind, _),
                   aggregate_all(count, sides(1, _, _, _), N) )),
    delete_file(Model).

%   A report that does not go into the stacks as they are: as JSON.

test(stacks, N == 1001) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [extension(off)]),
          cubes_written(Out, 10),
          close(Out) ),
        with_stack_limit(8 000 000,
            with_output_to(string(Text),
                in_new_world(cells_run([File], [json(true)], 0)))),
        delete_file(File)),
    aggregate_all(count, sub_string(Text, _, _, _, "\"role\""), N).

%   cubes_written(Out, N): N^3 cubes, each face once.

cubes_written(Out, N) :-
    M is N+1,
    V is M**3,
    F is 3*N*N*M,
    format(Out, "OFF~n~d ~d 0~n", [V,F]),
    forall(( between(0, N, X), between(0, N, Y), between(0, N, Z) ),
           format(Out, "~d ~d ~d~n", [X,Y,Z])),
    forall(( between(0, N, X), between(0, N, Y), between(0, N, Z),
             K is (X*M+Y)*M+Z,
             member(face(I,J,A,B), [face(Y,Z,M,1),face(Z,X,1,M*M),
                                    face(X,Y,M*M,M)]),
             I < N,
             J < N ),
           ( W is K+A,
             U is W+B,
             T is K+B,
             format(Out, "4 ~d ~d ~d ~d~n", [K,W,U,T]) )).

:- end_tests(verbs_cells).
