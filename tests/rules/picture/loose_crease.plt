:- module(test_loose_crease_lines, []).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(model/model), [load_model/1]).
:- use_module(rules(model/mesh), [read_mesh/2, write_mesh/2]).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(picture/view)).
:- use_module(rules(polygon/triangulation), [complete_segments/1]).
:- use_module(rules(solid/csg_evaluate), [evaluate/0]).
:- use_module(rules(store)).
:- use_module(tests('rules/picture/loose_crease')).
:- use_module(tests('rules/polyhedron'), [in_new_world/1]).

/* covers: crease

Creases of meshes go on where they fade (c_kernels/picture/crease.h): how many
end where no other line is. Without that it was as many as the second number
says.
*/

:- multifile user:message_hook/3.

user:message_hook(sanggwan(not_flat(_, _, _, _)), warning, _).

most_loose('cow.obj', 35, 338).
most_loose('suzanne.obj', 3, 33).
most_loose('beetle.obj', 10, 119).
most_loose('teapot.obj', 26, 33).
most_loose('thingi10k-88566.stl', 0, 0).

mesh(Name, File) :-
    most_loose(Name, _, _),
    atom_concat('../shared/data/meshes/', Name, Path),
    absolute_file_name(sanggwan(Path), File, []),
    exists_file(File).

no_meshes :-
    \+ mesh(_, _),
    format("loose_crease: skipped: no ../shared/data/meshes~n").

% A cone through a cylinder, united: on two sides the faces bend by
% less than 30 degrees where they meet.
united(union([ at([translate(0,0,-2)],
                  cylinder(radius(0.7), height(4), facets(40))),
               at([rotate(y,90), translate(-1.3,0,Z)],
                  cone(radius(1.2), height(3), facets(40))) ])) :-
    member(Z, [0.2, 0.3]).

% As a mesh that was written and read again, of which nothing is known.
loose_of_mesh(Term, Ends) :-
    tmp_file_stream(File, Out, [extension(off)]),
    close(Out),
    in_new_world(( assert_fact(segment(1, solid, Term)),
                   evaluate,
                   complete_segments([1]),
                   write_mesh(File, [1]) )),
    in_new_world(( read_mesh(File, [S]),
                   complete_segments([S]),
                   set_view(isometric),
                   picture,
                   once(drawn(_, S, _, _, _, _, crease)),
                   loose_creases(Ends) )).

:- begin_tests(loose_crease).

test(none, condition(no_meshes)) :-
    true.
test(meshes, [ forall(mesh(Name, File)), true(N =< Most) ]) :-
    most_loose(Name, Most, _),
    in_new_world(( load_model(File),
                   findall(S, segment(S, _, _), Ss),
                   complete_segments(Ss),
                   set_view(isometric),
                   picture,
                   loose_creases(Ends) )),
    length(Ends, N).
test(united, [ forall(united(Term)), Ends == [] ]) :-
    loose_of_mesh(Term, Ends).

:- end_tests(loose_crease).
