:- module(test_explain_parameter, []).
% covers: explain_parameter_en, explain_parameter_ko
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(explanation/explain)).
:- use_module(rules(model/model), [load_model/2]).
:- use_module(rules(model/parameter_change), [set_parameter/2]).
:- use_module(rules(penetration/penetration), [penetrate/0]).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

/* Explanations of parameters, and of the sizes that come from them. */

model("param(d, 168.3). param_about(d, [min(20), text(en, outside)]).
param(x, param(d)/4). param(idle, 3).
segment(1, solid, cylinder(radius(param(d)/2), height(100), facets(8))).
segment(2, solid, difference([box(size(param(x), 2, 300)),
    at([translate(param(x), 0, 0)], sphere(radius(1), facets(6), bands(4)))])).
v(5, 1, param(x), 0, 0). v(5, 2, 0, 0, 0). curve(5, [1,2]).
segment(6, solid, box(size(1, 1, 1))).
view(param(d), 0, 0).").

explained(Item, Options, Because) :-
    model(Text),
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
          write(Out, Text),
          close(Out) ),
        in_new_world(( load_model(File, Options),
                       penetrate,
                       once(explanation(Item, Because)) )),
        delete_file(File)).

%   says(Item, Options, Statements): all of them, wherever they stand.

says(Item, Options, Statements) :-
    explained(Item, Options, Because),
    findall(Statement, said(Because, Statement), Statements).

said(Because, Statement) :-
    member(because(Statement0, Inner), Because),
    (   Statement = Statement0
    ;   said(Inner, Statement)
    ).

:- begin_tests(explain_parameter).

test(size_of_primitive, Because == [because(segment(1, solid),
        [because(size(radius(57.15), radius(param(d)/2)),
            [because(parameter(d, 114.3),
                [because(parameter_text(outside, none), []),
                 because(parameter_set(168.3), [])])])])]) :-
    explained(segment(1), [parameters([d=114.3])], Because).
test(by_another, Said == [ parameter(x, 42.075),
                           parameter_formula(param(d)/4),
                           parameter(d, 168.3) ]) :-
    says(segment(2), [], All),
    append(_, [size(size(42.075, 2, 300), size(param(x), 2, 300))|Rest], All),
    append(Said, [parameter_text(_, _)|_], Rest),
    !.
test(step, true) :-
    says(segment(2), [], All),
    memberchk(size(translate(42.075, 0, 0), translate(param(x), 0, 0)), All).
test(vertex, true) :-
    says(vertex(5, 1), [], All),
    memberchk(vertex_place(5, 1, (param(x),0,0)), All).
%   Of an edge the formulas of its ends; if they have none, the sizes of its
%   segment, once.
test(edge_of_formulas, Places == [1]) :-
    says(edge(5, 1), [], [edge_divided(5, 1, 1, 2)|All]),
    findall(V, member(vertex_place(5, V, _), All), Places),
    \+ memberchk(segment(_, _), All).
test(part_of_formulas, Places == [1]) :-
    says(edge(5, 2), [], [edge(5, 2, 1, 3), part_of(5, 1, 1, 2)|All]),
    findall(V, member(vertex_place(5, V, _), All), Places),
    \+ memberchk(segment(_, _), All).
test(edge_of_primitive, Rs-Places == [84.15]-[]) :-
    says(edge(1, 1), [], [edge(1, 1, _, _)|All]),
    findall(R, member(size(radius(R), _), All), Rs),
    findall(V, member(vertex_place(_, V, _), All), Places).
test(edge_divided, Sizes-Parts == 1-2) :-
    between(1, 24, E),
    says(edge(2, E), [], [edge_divided(2, E, _, _)|All]),
    !,
    aggregate_all(count, member(size(size(_, _, _), _), All), Sizes),
    aggregate_all(count, member(edge_part(2, _, _, _), All), Parts).
test(edge_without, All == []) :-
    says(edge(6, 1), [], [edge(6, 1, _, _), edge_whole(6, 1),
                          edge_polygons(6, [_])|All]).
test(line, true) :-
    says(line(1), [], All),
    memberchk(size(radius(84.15), radius(param(d)/2)), All),
    memberchk(size(size(42.075, 2, 300), _), All).
test(none, All == [segment(6, solid), no_size_from_parameter]) :-
    says(segment(6), [], All).
test(uses, All == [ parameter(d, 168.3), parameter_text(outside, none),
                    parameter_range(20, none, none),
                    used_by_parameter(x, param(d)/4), segment(1, solid),
                    size(radius(84.15), radius(param(d)/2)),
                    used_by_row(view(param(d), 0, 0)) ]) :-
    says(param(d), [], All).
test(uses_of_operands, true) :-
    says(param(x), [], All),
    memberchk(vertex_place(5, 1, _), All),
    memberchk(size(translate(_, _, _), _), All),
    \+ memberchk(parameter_unused, All).
test(idle, All == [parameter(idle, 3), parameter_unused]) :-
    says(param(idle), [], All).

%   What was set no longer comes from what its formula needs.
test(set_over_formula, true) :-
    says(param(d), [parameters([x=7])], All),
    \+ memberchk(used_by_parameter(_, _), All).

test(both_languages, forall(explained(param(d), [parameters([d=100])],
                                      Because))) :-
    forall(said(Because, Statement),
           ( statement_text(Statement, Text), Text \== "" )).

:- end_tests(explain_parameter).
