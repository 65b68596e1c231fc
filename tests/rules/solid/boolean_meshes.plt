:- module(test_boolean_meshes, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(solid/boolean), [boolean/3]).
:- use_module(rules(kernel), [model_tolerance/1]).
:- use_module(rules(model/mesh), [read_mesh/2]).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(tests('rules/boolean_case'), [measured/2, sample/3]).
:- use_module(tests('rules/solid/mesh_pair')).

/* Booleans of meshes of others, where they are: every pair with each operation.
What bounds no solid is refused, with the reason; the rest obeys the laws.
BOOLEAN_PAIRS=all prints a line for each pair; it also takes every two meshes of
mcut, and what takes long. BOOLEAN_CASES=N places N times as many solids. */

:- multifile user:message_hook/3.

user:message_hook(sanggwan(not_flat(_, _, _, _)), warning, _).
user:message_hook(sanggwan(no_area(_, _, _)), warning, _).
user:message_hook(sanggwan(tight(_, _, _, _, _, _)), warning, _).
user:message_hook(sanggwan(Said), warning, _) :-
    functor(Said, flattened, _),
    assertz(test_boolean_meshes:flattened(Said)).

%   What is said about faces that became flat is kept.

:- dynamic flattened/1.

shared :-
    (   exists_directory('../shared/data')
    ->  true
    ;   format("~nskipped: no ../shared/data~n", []),
        fail
    ).

all :-
    getenv('BOOLEAN_PAIRS', all).

fault(Source, Name-Faults) :-
    mesh_pair(Source, Name, First, Second),
    \+ ( Name == 'src-mesh062.off', \+ all ),
    outcome_faults(Name, First, Second, Faults).

placed_fault(Seed-Name-Faults) :-
    sample(placed, 4, Seed),
    placed_pair(Seed, Name, [First,Second]),
    outcome_faults(Name, First, Second, Faults).

%   Whatever the tolerance, what merging makes goes through nothing.

tolerance_fault(Name, Factor-Operation-Measure) :-
    mesh_pair(booleans, Name, file(First), file(Second)),
    new_world(World),
    in_world(World,
             ( read_mesh(First, _),
               read_mesh(Second, _),
               complete_segments,
               model_tolerance(Least),
               findall(Fault, made_fault(Least, Fault), Faults) )),
    member(Factor-Operation-Measure, Faults).

made_fault(Least, Factor-Operation-Measure) :-
    nth1(I, [0.5,16,64,256,1024], Factor),
    nth1(J, [union,intersection,difference], Operation),
    Tolerance is Factor*Least,
    Expression =.. [Operation,[1,2]],
    S is 10*I+J,
    boolean(Expression, S, [tolerance(Tolerance)]),
    measured([S], [Measure]),
    Measure.good \== yes.

%   Of a result that is as without a tolerance nothing is said to have moved.

said_in_vain(Name-Operation-Said) :-
    mesh_pair(booleans, Name, file(First), file(Second)),
    member(Operation, [union,intersection,difference]),
    new_world(World),
    in_world(World,
             ( read_mesh(First, _),
               read_mesh(Second, _),
               complete_segments,
               Expression =.. [Operation,[1,2]],
               retractall(flattened(_)),
               boolean(Expression, 3, []),
               findall(Said, flattened(Said), Saids),
               boolean(Expression, 4, [tolerance(0)]),
               maplist(places, [3,4], [Places,Exact]) )),
    Places == Exact,
    member(Said, Saids).

places(S, Places) :-
    findall(p(X,Y,Z), v(S, _, X, Y, Z), Places0),
    msort(Places0, Places).

outcome_faults(Name, First, Second, Faults) :-
    catch(pair_outcome(First, Second, Outcome), Error,
          Outcome = outcome(unread, [], [Error])),
    (   all
    ->  print_outcome(Name, Outcome)
    ;   true
    ),
    Outcome = outcome(_, _, Faults),
    Faults \== [].

print_outcome(Name, outcome(Closed, Results, Faults)) :-
    format("~p ~w:", [Name,Closed]),
    forall(member(Operation-Result, Results),
           ( result_text(Result, Text), format(" ~w ~w", [Operation,Text]) )),
    length(Faults, N),
    format(" faults ~d~n", [N]).

result_text(made(Seconds, M), Text) :-
    format(atom(Text), "~3fs closed=~w penetrating=~d+~d+~d volume=~6g",
           [Seconds,M.closed,M.crossing,M.overlap,M.in_line,M.volume]).
result_text(refused(error(Formal, _)), Text) :-
    !,
    format(atom(Text), "refused(~p)", [Formal]).
result_text(refused(Error), Text) :-
    format(atom(Text), "refused(~p)", [Error]).

:- begin_tests(boolean_meshes).

test(mcut, [condition(shared), true(Faults == [])]) :-
    findall(F, fault(mcut, F), Faults).
test(booleans, [condition(shared), true(Faults == [])]) :-
    findall(F, fault(booleans, F), Faults).
test(said_in_vain, [condition(shared), true(Saids == [])]) :-
    findall(Said, said_in_vain(Said), Saids).
test(tolerances, [condition(shared), true(Faults == [])]) :-
    findall(F, tolerance_fault('Generic_Twin_7863.1.t0', F), Faults).
test(mcut_all, [condition(( shared, all )), true(Faults == [])]) :-
    findall(F, fault(mcut_all, F), Faults).
test(placed, [condition(shared), true(Faults == [])]) :-
    findall(F, placed_fault(F), Faults).

:- end_tests(boolean_meshes).
