/* The tolerance of a glue: what evaluate/2 was given stays, and it counts under
   a Boolean. */
:- module(test_glue_tolerance, []).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(store)).
:- use_module(tests('rules/boolean_case'), [in_scene/2]).

%   Two boxes with a gap of 0.0001 between them are 3, and a third one 4. The
%   root is 5.

gap(Root, Goal) :-
    box(0, One),
    box(1.0001, Two),
    box(5, Other),
    in_scene([One,Two,Other],
             ( assert_fact(segment(4, cells, glue([1,2]))),
               assert_fact(segment(5, solid, Root)),
               Goal )).

box(X, at([translate(X,0,0)], box(size(1,1,1)))).

:- meta_predicate gap(+, 0).

vertices(S, N) :-
    aggregate_all(count, v(S, _, _, _, _), N).

%   That the gap was closed is said each time.

:- dynamic quiet/0.
:- multifile user:message_hook/3.

user:message_hook(_, warning, _) :-
    test_glue_tolerance:quiet.

:- begin_tests(glue_tolerance,
               [ setup(assertz(test_glue_tolerance:quiet)),
                 cleanup(retractall(test_glue_tolerance:quiet))
               ]).

test(stays, Ns-Wishes == [12,12]-[tolerance(0.01)]) :-
    gap(union([3,4]),
        ( evaluate(4, [tolerance(0.01)]),
          vertices(4, N1),
          retract_fact(segment(2, _, Term)),
          assert_fact(segment(2, solid, Term)),
          evaluate(4),
          vertices(4, N2),
          findall(Wish, gluing(4, Wish), Wishes),
          Ns = [N1,N2] )).
test(another_one, Ns == [12,16]-[tolerance(1.0e-5)]) :-
    gap(union([3,4]),
        ( evaluate(4, [tolerance(0.01)]),
          vertices(4, N1),
          evaluate(4, [tolerance(1.0e-5)]),
          vertices(4, N2),
          findall(Wish, gluing(4, Wish), Wishes),
          Ns = [N1,N2]-Wishes )).
test(default_says_nothing, Wishes == []) :-
    gap(union([3,4]), ( evaluate(4), findall(Wish, gluing(4, Wish), Wishes) )).
test(one_step_of_undo, N-Wishes == 0-[]) :-
    gap(union([3,4]),
        ( evaluate(4, [tolerance(0.01)]),
          facts_undo,
          vertices(4, N),
          findall(Wish, gluing(4, Wish), Wishes) )).

%   A box of 2.0001 by 1 by 1, and one apart from it; deeper in the tree; and a
%   tolerance that is less than that of the leaves.

test(under_a_boolean,
     [forall(member(Root-Tolerance-N,
                    [ union([3,4])-0.01-16,
                      union([3,union([4])])-0.01-16,
                      difference([4,3])-0.01-8,
                      union([3,4])-1.0e-5-24,
                      union([3,4])-0-24 ])),
      true(Vertices == N)]) :-
    gap(Root,
        ( assert_fact(gluing(4, tolerance(Tolerance))),
          evaluate(5),
          vertices(5, Vertices) )).

:- end_tests(glue_tolerance).
