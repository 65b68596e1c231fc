/* Doors with several answers: what is known before a call picks among them. */
:- module(test_door_answers, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(kernel)).
:- use_module(rules(model/model)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

:- meta_predicate picked(?, 0).

%   picked(+Template, :Goal): there are several answers, and each of their
%   arguments, known alone or all together, leaves those that have it.

picked(Template, Goal) :-
    findall(Template, Goal, All),
    assertion(All = [_,_|_]),
    forall(member(Answer, All),
           ( findall(Template, ( Template = Answer, Goal ), Same),
             include(==(Answer), All, Wanted),
             assertion(Same == Wanted) )),
    forall(( member(Answer, All), arg(I, Answer, Value) ),
           ( findall(Template, ( arg(I, Template, Value), Goal ), Some),
             include(has(I, Value), All, Wanted),
             assertion(Some == Wanted) )),
    forall(arg(I, Template, _),
           assertion(\+ ( arg(I, Template, 7654321), Goal ))).

has(I, Value, Answer) :-
    arg(I, Answer, Value).

in_model(File, Goal) :-
    in_new_world(( load_model(File),
                   complete_segments,
                   Goal )).

:- begin_tests(door_answers).

test(cut_candidate) :-
    in_model('facts/two_cubes.pl',
             setup_call_cleanup(
                 cut_set_open([1-2], Set),
                 picked(c(A,B), cut_candidate(Set, A, B)),
                 cut_set_close(Set))).
test(near_segments) :-
    in_model('facts/pipe_tee.pl', picked(s(A,B), near_segments(0, A, B))).
test(census_part) :-
    in_model('facts/two_cubes.pl',
             picked(c(S), census_part(S, _))).
test(census_shell) :-
    in_model('facts/two_cubes.pl',
             picked(c(S,P), census_shell(S, P, _, _))).

%   One variable in two places.

test(twice) :-
    in_model('facts/two_cubes.pl',
             setup_call_cleanup(
                 cut_set_open([1-2], Set),
                 ( findall(A, cut_candidate(Set, A, A), Same),
                   findall(A, ( cut_candidate(Set, A, B), A == B ), Wanted) ),
                 cut_set_close(Set))),
    assertion(Same == Wanted).

:- end_tests(door_answers).
