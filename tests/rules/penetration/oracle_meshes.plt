:- module(test_oracle_meshes, []).
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(library(solution_sequences)).
:- use_module(rules(decision)).
:- use_module(rules(kernel)).
:- use_module(rules(model/mesh)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(penetration/resolve)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests('rules/penetration/oracle')).
:- use_module(tests('rules/penetration/oracle_model')).
:- use_module(tests('rules/sample')).

/* All pairs of meshes of others, where they are, against the oracle, as they
come: open sheets, contacts, polygons that are not flat. Collinear pieces are
not merged, since polygons flat only within the tolerance have joints that are
straight only within it. ORACLE_MESHES=all: also what takes long, such as the
one large pair (062, 15,000 triangles, some without area). */

:- multifile user:message_hook/3.

user:message_hook(sanggwan(not_flat(_, _, _, _)), warning, _).
user:message_hook(sanggwan(no_area(_, _, _)), warning, _).

shared(Folder) :-
    atom_concat('../shared/data/', Folder, Path),
    (   exists_directory(Path)
    ->  true
    ;   format("~nskipped: ~w is not there~n", [Path]),
        fail
    ).

pair(mcut, First, Second) :-
    expand_file_name('../shared/data/mcut/src-mesh*.off', Files),
    member(First, Files),
    \+ left_out(First),
    atomic_list_concat([Begin,End], 'src-mesh', First),
    atomic_list_concat([Begin,End], 'cut-mesh', Second).
pair(booleans, First, Second) :-
    expand_file_name('../shared/data/booleans/*_left.obj', Files),
    member(First, Files),
    atom_concat(Begin, '_left.obj', First),
    atom_concat(Begin, '_right.obj', Second).

left_out(File) :-
    sub_atom(File, _, _, 0, '062.off'),
    \+ getenv('ORACLE_MESHES', all).

%   penetrated(+First, +Second, -Faults): what model_fault/2 finds, but for
%   points in which pieces were not merged; and dead ends of closed segments: a
%   piece that goes through one face of each goes on.

penetrated(How, First, Second, Faults) :-
    new_world(World),
    in_world(World,
             ( unmerged,
               read_mesh(First, _),
               read_mesh(Second, _),
               complete_segments,
               made_ready(How),
               model_before(Before),
               penetrate(all, [tolerance(0)]),
               findall(Fault, limit(3, fault(Before, Fault)), Faults) )).

%   As it is, or so that what is meant to touch does.

made_ready(exact).
made_ready(resolved) :-
    findall(S1-S2, ( segment(S1, _, _), segment(S2, _, _), S1 < S2 ), Pairs),
    model_tolerance(Tolerance),
    setup_call_cleanup(
        cut_set_open(Pairs, Set),
        ignore(resolve_contacts(Set, Tolerance)),
        cut_set_close(Set)).

unmerged :-
    setup_call_cleanup(
        tmp_file_stream(File, Out, [extension(pl), encoding(utf8)]),
        write(Out, 'merge_line(_, _) :- fail.\n'), close(Out)),
    use_rules(File),
    delete_file(File).

fault(Before, Fault) :-
    model_fault(Before, Fault),
    Fault \= needlessly_divided(_, _, _).
fault(before(_, Lines), dead_end(S, V)) :-
    \+ segment(_, surface, _),
    line(L, S, _, A, B, S2, _, _, _),
    A \== B,
    member(V, [A,B]),
    \+ ( line(M, S, _, C, D, _, _, _, _), M \== L, memberchk(V, [C,D]) ),
    memberchk(lines(S, S2, Common, _), Lines),
    exact_vertex(S, A, Pa),
    exact_vertex(S, B, Pb),
    msort([Pa,Pb], [P,Q]),
    findall(x, member(_-(P-Q), Common), [_]).

mesh_fault(How, Folder, First-Faults) :-
    one_in(3, pair(Folder, First, Second)),
    catch(penetrated(How, First, Second, Faults), Error, Faults = [Error]),
    Faults \== [].

:- begin_tests(oracle_meshes).

test(mcut, [condition(shared(mcut)), true(Bad == [])]) :-
    findall(B, mesh_fault(exact, mcut, B), Bad).
test(mcut_resolved, [condition(shared(mcut)), true(Bad == [])]) :-
    findall(B, mesh_fault(resolved, mcut, B), Bad).
test(booleans, [condition(shared(booleans)), true(Bad == [])]) :-
    findall(B, mesh_fault(exact, booleans, B), Bad).
test(booleans_resolved,
     [ condition(( getenv('ORACLE_MESHES', all), shared(booleans) )),
       true(Bad == [])
     ]) :-
    findall(B, mesh_fault(resolved, booleans, B), Bad).

:- end_tests(oracle_meshes).
