:- module(test_oracle_models, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(solution_sequences)).
:- use_module(rules(store)).
:- use_module(rules(triangulation)).
:- use_module(tests('rules/grid_model')).
:- use_module(tests('rules/oracle_model')).

/* Random solids and sheets on a coarse grid, two or three together: after
penetrate/0 the lines are those of the oracle, and every polygon is still
divided rightly. Model I is made from seed I. ORACLE_MODELS=N makes N models
(default 200), from number ORACLE_FIRST (default 1) on. */

models(First, Last) :-
    from_environment('ORACLE_FIRST', 1, First),
    from_environment('ORACLE_MODELS', 200, N),
    Last is First+N-1.

from_environment(Name, Default, N) :-
    (   getenv(Name, Text)
    ->  atom_number(Text, N)
    ;   N = Default
    ).

model_shapes(I, Shapes) :-
    set_random(seed(I)),
    random_member(N, [2,2,3]),
    length(Shapes, N),
    maplist(random_shape, Shapes).

shapes_faults(Shapes, Faults) :-
    new_world(World),
    in_world(World,
             ( forall(nth1(S, Shapes, Shape), add_shape(S, Shape)),
               complete_segments,
               catch(penetration_faults(Faults), Error, Faults = [Error]) )).

bad_model(I-Labels-Faults) :-
    models(First, Last),
    between(First, Last, I),
    model_shapes(I, Shapes),
    shapes_faults(Shapes, Faults),
    Faults \== [],
    maplist(shape_label, Shapes, Labels).

:- begin_tests(oracle_models).

test(random_models, Bad == []) :-
    findall(Model, limit(5, bad_model(Model)), Bad).

:- end_tests(oracle_models).
