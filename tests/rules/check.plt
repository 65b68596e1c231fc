:- module(test_check, []).
:- use_module(library(plunit)).
:- use_module(library(http/json)).
:- use_module(rules(store)).
:- use_module(rules(model)).
:- use_module(rules(check)).
:- use_module(rules(integrity)).

with_text(Text, Goal) :-
    new_world(World),
    setup_call_cleanup(
        tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
        ( write(Out, Text),
          close(Out),
          in_world(World, ( load_model(File), Goal ))
        ),
        delete_file(File)).

with_file(Name, Goal) :-
    absolute_file_name(sanggwan(Name), File, [access(read)]),
    new_world(World),
    in_world(World, ( load_model(File), Goal )).

% Goal, its warnings unheard.
quietly(Goal) :-
    setup_call_cleanup(
        asserta((user:message_hook(_, warning, _) :- true), Ref),
        once(Goal),
        erase(Ref)).

report_of(Name, Report) :-
    with_file(Name, check_report(Report)).

tetrahedron("v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,0,1,0). v(1,4,0,0,1).
             p(1,1,[1,3,2]). p(1,2,[1,2,4]). p(1,3,[2,3,4]).").

:- multifile user:message_hook/3.
:- dynamic user:message_hook/3.

:- begin_tests(check).

test(cube, A-V-G-F == 6.0-1.0-0-0) :-
    report_of('facts/cube.pl', R),
    R.segments = [S],
    A = S.area, V = S.volume, G = S.genus, F = R.faults.
test(ring, G-V == 1-12.0) :-
    report_of('facts/hollow_block.pl', R),
    R.segments = [S],
    G = S.genus, V = S.volume.
test(surface, B-F == 6-0) :-
    report_of('facts/wire_and_roof.pl', R),
    R.segments = [S|_],
    B = S.border_edges, F = R.faults.
test(box, B == [0.0,0.0,0.0,1.0,1.0,1.0]) :-
    report_of('facts/cube.pl', R),
    R.segments = [S],
    B = S.box.
test(no_defect, fail) :-
    with_file('facts/two_cubes.pl', model_defect(_)).
test(open, Ds == [open_edge(1,1,3), open_edge(1,4,1), open_edge(1,3,4)]) :-
    tetrahedron(Text),
    string_concat(Text, " segment(1, solid, x).", Text1),
    with_text(Text1, findall(D, model_defect(D), Ds)).
test(inside_out, Ds == [inside_out(1)]) :-
    with_text("v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,0,1,0). v(1,4,0,0,1).
               p(1,1,[1,2,3]). p(1,2,[1,4,2]). p(1,3,[2,4,3]).
               p(1,4,[3,4,1]).", findall(D, model_defect(D), Ds)).
test(unpaired, Ds == [unpaired_edge(1,1,2)]) :-
    with_text("v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,0,1,0). v(1,4,0,-1,0).
               p(1,1,[1,2,3]). p(1,2,[1,2,4]).",
              findall(D, model_defect(D), Ds)).
test(non_manifold, Ds == [non_manifold_edge(1,1,2,3)]) :-
    with_text("v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,0,1,0). v(1,4,0,-1,0).
               v(1,5,0,0,1). p(1,1,[1,2,3]). p(1,2,[2,1,4]). p(1,3,[1,2,5]).",
              findall(D, model_defect(D), Ds)).
test(no_area, Ds == [degenerate_face(1,1)]) :-
    quietly(with_text("v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,2,0,0).
                       p(1,1,[1,2,3]).",
                      findall(D, model_defect(D), Ds))).
test(json, F == 0) :-
    report_of('facts/cube.pl', R),
    with_output_to(string(Text), print_report(json, R)),
    atom_json_dict(Text, Dict, []),
    F = Dict.faults.
test(text) :-
    report_of('facts/cube.pl', R),
    with_output_to(string(Text), print_report(text, R)),
    once(sub_string(Text, _, _, _, "no defects")).

:- end_tests(check).
