:- module(test_oracle_models, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(solution_sequences)).
:- use_module(rules(decision)).
:- use_module(rules(store)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests('rules/grid_model')).
:- use_module(tests('rules/penetration/oracle_model')).
:- use_module(tests('rules/sample')).

/* Random solids and sheets on a coarse grid, half of them then mapped to planes
in all directions, two to four together: after
penetrate/0 the lines are those of the oracle, and every polygon is still
divided rightly. Model I is made from seed I. ORACLE_MODELS=N makes N models
(default 50, or 150), from number ORACLE_FIRST (default 1) on. */

models(First, Last) :-
    from_environment('ORACLE_FIRST', 1, First),
    few(50, 150, Few),
    from_environment('ORACLE_MODELS', Few, N),
    Last is First+N-1.

from_environment(Name, Default, N) :-
    (   getenv(Name, Text)
    ->  atom_number(Text, N)
    ;   N = Default
    ).

model_shapes(I, Shapes) :-
    set_random(seed(I)),
    random_member(N, [2,2,3,4]),
    length(Shapes0, N),
    maplist(random_shape, Shapes0),
    (   random_member(grid, [grid,map])
    ->  Shapes = Shapes0
    ;   random_map(Map),
        maplist(mapped_shape(Map), Shapes0, Shapes)
    ).

shapes_faults(Shapes, Faults) :-
    new_world(World),
    in_world(World,
             ( foldl(add_next, Shapes, 1, _),
               complete_segments,
               catch(penetration_faults(Faults), Error, Faults = [Error]) )).

%   The same lines if the last shape comes when the others have been cut.

two_steps_faults(Shapes, Faults) :-
    new_world(Together),
    in_world(Together,
             ( foldl(add_next, Shapes, 1, _),
               complete_segments,
               model_before(Before) )),
    append(Shapes1, [Shape], Shapes),
    new_world(World),
    in_world(World,
             ( foldl(add_next, Shapes1, 1, S),
               complete_segments,
               catch(( penetrate,
                       add_shape(S, Shape),
                       complete_segments,
                       penetrate,
                       model_faults(Before, Faults) ),
                     Error, Faults = [Error]) )).

%   Turned in decimals, so that almost nothing that touched still does, but is
%   off by a rounding; and polygons are no longer flat. Without a tolerance, and
%   without merging, since joints are straight only within one.

turned_faults(Shapes0, Faults) :-
    Turn = [p(0.36,0.48,-0.8), p(-0.8,0.6,0.0), p(0.48,0.64,0.6)],
    maplist(mapped_shape(Turn), Shapes0, Shapes),
    new_world(World),
    in_world(World,
             ( follow("merge_line(_, _) :- fail."),
               foldl(add_next, Shapes, 1, _),
               complete_segments,
               catch(( penetration_faults(Faults0),
                       exclude(is_needless, Faults0, Faults) ),
                     Error, Faults = [Error]) )).

is_needless(needlessly_divided(_, _, _)).

add_next(Shape, S, S1) :-
    add_shape(S, Shape),
    S1 is S+1.

%   bad_model(:Faults, +Share, -Bad): of the models, one in Share is tried.

bad_model(Faults_, Share, I-Labels-Faults) :-
    models(First, Last0),
    Last is First+(Last0-First)//Share,
    between(First, Last, I),
    model_shapes(I, Shapes),
    call(Faults_, Shapes, Faults0),
    findall(Fault, limit(3, member(Fault, Faults0)), Faults),
    Faults \== [],
    maplist(shape_label, Shapes, Labels).

%   follow(+Rules): the current world follows the rules in a text.

follow(Rules) :-
    setup_call_cleanup(
        tmp_file_stream(File, Out, [extension(pl), encoding(utf8)]),
        write(Out, Rules), close(Out)),
    use_rules(File),
    delete_file(File).

:- multifile user:message_hook/3.

user:message_hook(sanggwan(not_flat(_, _, _, _)), warning, _).

:- begin_tests(oracle_models).

test(random_models, Bad == []) :-
    findall(Model, limit(5, bad_model(shapes_faults, 1, Model)), Bad).
test(in_two_steps, Bad == []) :-
    findall(Model, limit(5, bad_model(two_steps_faults, 1, Model)), Bad).

test(turned, Bad == []) :-
    findall(Model, limit(5, bad_model(turned_faults, 4, Model)), Bad).

% A box stands on a table, a sheet hangs under it and does not cut the box:
% where its line crosses the edges of the box, these are divided on both sides.
test(late_points, Faults == []) :-
    box(Box),
    sheet([p(0,0,0), p(4,0,0), p(4,4,0), p(0,4,0)], Table),
    sheet([p(2,0,-2), p(2,4,-2), p(2,4,0), p(2,0,0)], Sheet),
    not_first_and_third([Box,Table,Sheet], Faults).

% Two sheets have an edge in common; the third divides it, but only that of the
% second.
test(edges_on_each_other, Faults == []) :-
    sheet([p(0,0,0), p(4,0,0), p(4,0,2), p(0,0,2)], Upper),
    sheet([p(0,0,-2), p(4,0,-2), p(4,0,0), p(0,0,0)], Lower),
    sheet([p(2,-1,-2), p(2,1,-2), p(2,1,0), p(2,-1,0)], Across),
    not_first_and_third([Upper,Lower,Across], Faults).

box(shape(box, solid,
          [ p(1,1,0), p(3,1,0), p(3,3,0), p(1,3,0),
            p(1,1,2), p(3,1,2), p(3,3,2), p(1,3,2) ],
          [ [[4,3,2,1]], [[5,6,7,8]], [[1,2,6,5]], [[2,3,7,6]], [[3,4,8,7]],
            [[4,1,5,8]] ])).

sheet(Points, shape(sheet, surface, Points, [[[1,2,3,4]]])).

%   not_first_and_third(+Shapes, -Faults): of three, these do not cut each
%   other.

not_first_and_third(Shapes, Faults) :-
    new_world(World),
    in_world(World,
             ( follow("may_cut(S1, S2) :- S1-S2 \\== 1-3."),
               foldl(add_next, Shapes, 1, _),
               complete_segments,
               model_before(Before0),
               without(1, 3, Before0, Before),
               penetrate,
               model_faults(Before, Faults) )).

without(S1, S2, before(Segments, Lines0), before(Segments, Lines)) :-
    exclude(is_of(S1, S2), Lines0, Lines).

is_of(S1, S2, lines(S1, S2, _, _)).

:- end_tests(oracle_models).
