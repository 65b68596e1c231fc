:- encoding(utf8).
/* The verb cells: its report as text in two languages and as JSON, and files.
   What it says to the letter is in tests/transcripts/cells.txt. */
:- module(test_verbs_cells, []).
:- use_module(library(http/json)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(command/verbs_cells)).
:- use_module(rules(model/model)).
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

:- end_tests(verbs_cells).
