/* Penetration lines of meshes of others, where they are: they come out without
   error, with a line where the files meet and no edge without an opposite. */
:- module(test_penetration_meshes, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(rules(store)).
:- use_module(rules(model/mesh)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests(rules/penetration_fault),
              [chain_fault/1, edge_fault/1, line_fault/1]).

:- multifile user:message_hook/3.

user:message_hook(sanggwan(not_flat(_, _, _, _)), warning, _).
user:message_hook(sanggwan(no_area(_, _, _)), warning, _).

shared(Folder) :-
    atom_concat('../shared/data/', Folder, Path),
    (   exists_directory(Path)
    ->  true
    ;   format("skipped: ~w is not there~n", [Path]),
        fail
    ).

mesh_pair(Path, Second, First-Cut) :-
    atomic_list_concat([Path, /, '*'], Pattern),
    expand_file_name(Pattern, Files),
    member(First, Files),
    atomic_list_concat([Begin, End], 'src-mesh', First),
    atomic_list_concat([Begin, Second, End], Cut).
mesh_pair(Path, _, Left-Right) :-
    atom_concat(Path, '/*_left.obj', Pattern),
    expand_file_name(Pattern, Files),
    member(Left, Files),
    atom_concat(Begin, '_left.obj', Left),
    atom_concat(Begin, '_right.obj', Right).

meshes_fault(First-Second, Fault) :-
    new_world(World),
    in_world(World,
             ( read_mesh(First, _),
               read_mesh(Second, _),
               complete_segments,
               findall(F, mesh_fault(F), Faults0),
               penetrate,
               findall(F, mesh_fault(F), Faults)
             )),
    member(Fault, Faults),
    \+ memberchk(Fault, Faults0).

mesh_fault(Fault) :- edge_fault(Fault).
mesh_fault(Fault) :- line_fault(Fault).
mesh_fault(Fault) :- chain_fault(Fault).

:- begin_tests(penetration_meshes).

% 062 has triangles without area; their edges lie on one another.
test(mcut, [condition(shared(mcut)), true(Bad == [])]) :-
    findall(First-Fault,
            ( mesh_pair('../shared/data/mcut', 'cut-mesh', First-Second),
              \+ sub_atom(First, _, _, 0, '062.off'),
              meshes_fault(First-Second, Fault) ),
            Bad).
test(mcut_meet, [condition(shared(mcut)), true(N >= 30)]) :-
    aggregate_all(count,
                  ( mesh_pair('../shared/data/mcut', 'cut-mesh', A-B),
                    new_world(World),
                    in_world(World,
                             ( read_mesh(A, _), read_mesh(B, _),
                               complete_segments, penetrate,
                               once(line(_,_,_,_,_,_,_,_,_)) )) ),
                  N).
test(booleans, [condition(shared(booleans)), true(Bad == [])]) :-
    findall(First-Fault,
            ( mesh_pair('../shared/data/booleans', none, First-Second),
              meshes_fault(First-Second, Fault) ),
            Bad).

:- end_tests(penetration_meshes).
