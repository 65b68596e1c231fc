:- module(test_model, []).
:- use_module(library(plunit)).
:- use_module(rules(store)).
:- use_module(rules(model/model)).
:- use_module(rules(vocabulary)).

in_model(File, Goal) :-
    new_world(World),
    absolute_file_name(sanggwan(File), Path, [access(read)]),
    in_world(World, ( load_model(Path), Goal )).

:- begin_tests(model).

test(load, Count-Planes-Triangles == 6-6-12) :-
    in_model('facts/cube.pl',
             ( aggregate_all(count, p(_, _, _), Count),
               aggregate_all(count, plane(_, _, _, _, _, _), Planes),
               aggregate_all(count, t(_, _, _, _, _, _), Triangles) )).
test(side_by_side, Ss == [1,2,3]) :-
    in_model('facts/cube.pl',
             ( absolute_file_name(sanggwan('facts/two_cubes.pl'), Path),
               load_model([Path]),
               findall(S, segment(S, _, _), Ss) )).
test(all_or_none, Count == 0) :-
    new_world(World),
    absolute_file_name(sanggwan('facts/cube.pl'), Path),
    in_world(World,
             ( catch(load_model([Path, 'no_such_file.pl']), error(_, _), true),
               aggregate_all(count, v(_, _, _, _, _), Count) )).
test(unknown_format, error(model_error(unknown_format(md, _)))) :-
    absolute_file_name(sanggwan('README.md'), Path),
    load_model(Path).
test(no_ending, error(model_error(unknown_format('', _)))) :-
    absolute_file_name(sanggwan('LICENSE'), Path),
    load_model(Path).
test(text_names) :-
    new_world(World),
    absolute_file_name(sanggwan('facts/cube.pl'), Path),
    atom_string(Path, Text),
    in_world(World, ( load_model(Text), load_model([Text, Path]) )).
test(missing, error(model_error(cannot_read(missing)))) :-
    load_model(no_such_file).
test(folder, error(model_error(cannot_read(directory)))) :-
    absolute_file_name(sanggwan('facts'), Path),
    load_model(Path).
test(unknown_output, error(usage_error(ending('a.xyz', _)))) :-
    save_model('a.xyz').

test(twins) :-
    in_model('facts/cube.pl',
             forall(half_edge(H),
                    ( half_edge_twin(H, T),
                      half_edge_twin(T, H),
                      half_edge_ends(H, A, B),
                      half_edge_ends(T, B, A) ))).
test(twin_of_bound_second) :-
    in_model('facts/cube.pl', ( once(half_edge_twin(H, 1-5)),
                                half_edge_twin(1-5, H) )).
test(loops, Ls == [[[4,3,2,1], [5,6,7,8]]]) :-
    in_model('facts/hollow_block.pl',
             findall(L, facet_loops(1-1, L), Ls)).
test(neighbours, Fs == [1-1, 1-2, 1-4, 1-6]) :-
    in_model('facts/cube.pl',
             setof(F, facet_neighbour(1-3, F), Fs)).
test(edges, Count == 12) :-
    in_model('facts/cube.pl',
             aggregate_all(count, edge_facets(_, [_, _]), Count)).
test(edge, Fs == [1-1, 1-3]) :-
    in_model('facts/cube.pl', edge_facets(1-(1, 2), Fs)).
test(border, Count == 6) :-
    in_model('facts/wire_and_roof.pl',
             aggregate_all(count, edge_facets(_, [_]), Count)).
test(curve_edges, Count == 4) :-
    in_model('facts/wire_and_roof.pl',
             aggregate_all(count, edge_facets(_, []), Count)).
test(shell, Count == 10) :-
    in_model('facts/hollow_block.pl',
             ( shell_facets(1-1, Fs), length(Fs, Count) )).
test(plane, P == plane(0.0, 0.0, 1.0, -1.0)) :-
    in_model('facts/cube.pl', facet_plane(1-2, P)).
test(triangles, Count == 2) :-
    in_model('facts/cube.pl',
             aggregate_all(count, facet_triangle(1-1, _), Count)).
test(star, Count == 3) :-
    in_model('facts/cube.pl',
             aggregate_all(count, vertex_half_edge(1-1, _), Count)).

:- end_tests(model).
