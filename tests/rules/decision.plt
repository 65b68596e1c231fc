/* Two decisions of a module made for the test, and worlds that replace them. */
:- module(test_decision, []).
:- use_module(rules(decision)).
:- use_module(rules(store), [new_world/1, in_world/2]).
:- use_module(library(plunit)).
:- use_module(library(filesex), [directory_file_path/3]).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

:- decision(pick/3, "Which of two numbers is taken").

pick(A, B, C) :-
    (   A =< B
    ->  C = A
    ;   C = B
    ).

:- decision(parts/2, "What a number falls into").

parts(N, Part) :-
    member(Part, [N, half(N)]).

:- dynamic file/2.

%   rule_file_of(+Name, +Clauses): a rule file called Name in a temporary
%   folder.

rule_file_of(Name, Text, File) :-
    folder(Folder),
    directory_file_path(Folder, Name, File),
    setup_call_cleanup(open(File, write, Out, [encoding(utf8)]),
                       write(Out, Text),
                       close(Out)).

folder(Folder) :-
    (   file(folder, Folder)
    ->  true
    ;   tmp_file(sanggwan, Folder),
        make_directory(Folder),
        assertz(file(folder, Folder))
    ).

%   A new thread has no world.

in_no_world(Goal) :-
    thread_self(Me),
    thread_create(( catch(Goal, Error, true),
                    thread_send_message(Me, done(Goal, Error))
                  ),
                  Thread),
    thread_join(Thread, Status),
    must_be(oneof([true]), Status),
    thread_get_message(done(Goal0, Error0)),
    (   var(Error0)
    ->  Goal = Goal0
    ;   throw(Error0)
    ).

larger("pick(A, B, C) :- larger(A, B, C).\n\c
        larger(A, B, C) :- C is max(A, B).\n").
same("pick(A, B, same) :- A == B, !.\n\c
      pick(A, B, C) :- default(pick(A, B, C)).\n").

:- begin_tests(decision).

test(default, C == 1) :-
    in_new_world(pick(1, 2, C)).
test(default_without_a_world,
     [condition(current_prolog_flag(threads, true)), C == 1]) :-
    in_no_world(pick(1, 2, C)).
test(listed, [By, Doc] == [default, "Which of two numbers is taken"]) :-
    in_new_world(decision(pick/3, Doc, _, By)).
test(placed) :-
    decision(pick/3, _, File:Line, _),
    file_base_name(File, 'decision.plt'),
    Line == 9.
test(is_default) :-
    in_new_world(decision_is_default(pick/3)).
test(is_no_decision,
     error(existence_error(decision, no_such_decision/1), _)) :-
    decision_is_default(no_such_decision/1).
test(replaced, C == 2) :-
    larger(Text),
    rule_file_of('larger.pl', Text, File),
    in_new_world(( use_rules(File), pick(1, 2, C) )).
test(replaced_is_not_default, fail) :-
    larger(Text),
    rule_file_of('larger.pl', Text, File),
    in_new_world(( use_rules(File), decision_is_default(pick/3) )).
test(by, By == File) :-
    larger(Text),
    rule_file_of('larger.pl', Text, File),
    in_new_world(( use_rules(File), decision(pick/3, _, _, By) )).
test(nondeterministic, all(P == [1, 2])) :-
    rule_file_of('parts.pl', "parts(_, 1).\nparts(_, 2).\n", File),
    new_world(World),
    in_world(World, use_rules(File)),
    in_world(World, findall(Q, parts(7, Q), Qs)),
    member(P, Qs).
test(default_in_rule_file, [C, D] == [same, 1]) :-
    same(Text),
    rule_file_of('same.pl', Text, File),
    in_new_world(( use_rules(File), pick(2, 2, C), pick(1, 2, D) )).
test(other_world_keeps_default, [C, D] == [2, 1]) :-
    larger(Text),
    rule_file_of('larger.pl', Text, File),
    new_world(W1),
    new_world(W2),
    in_world(W1, use_rules(File)),
    in_world(W1, pick(1, 2, C)),
    in_world(W2, pick(1, 2, D)).
test(two_worlds_two_rules, [C, D] == [2, same]) :-
    larger(Larger),
    same(Same),
    rule_file_of('larger.pl', Larger, F1),
    rule_file_of('same.pl', Same, F2),
    new_world(W1),
    new_world(W2),
    in_world(W1, use_rules(F1)),
    in_world(W2, use_rules(F2)),
    in_world(W1, pick(2, 2, C)),
    in_world(W2, pick(2, 2, D)).
test(one_file_two_worlds, [C, D, E] == [2, 2, 1]) :-
    larger(Text),
    rule_file_of('larger.pl', Text, File),
    new_world(W1),
    new_world(W2),
    in_world(W1, use_rules(File)),
    in_world(W2, use_rules(File)),
    in_world(W1, pick(1, 2, C)),
    in_world(W1, no_rules(File)),
    in_world(W2, pick(1, 2, D)),
    in_world(W1, pick(1, 2, E)).
test(two_threads,
     [condition(current_prolog_flag(threads, true)), [C, D] == [2, 1]]) :-
    larger(Text),
    rule_file_of('larger.pl', Text, File),
    new_world(W1),
    in_world(W1, use_rules(File)),
    thread_self(Me),
    thread_create(( in_new_world(pick(1, 2, X)),
                    thread_send_message(Me, got(X))
                  ),
                  Thread),
    in_world(W1, pick(1, 2, C)),
    thread_join(Thread),
    thread_get_message(got(D)).
test(removed, [C, By] == [1, default]) :-
    larger(Text),
    rule_file_of('larger.pl', Text, File),
    in_new_world(( use_rules(File),
                   no_rules(File),
                   pick(1, 2, C),
                   decision(pick/3, _, _, By)
                 )).
test(not_followed, error(existence_error(rules, _), _)) :-
    larger(Text),
    rule_file_of('larger.pl', Text, File),
    in_new_world(no_rules(File)).
test(the_later_file_decides, [C, D] == [same, 2]) :-
    larger(Larger),
    same(Same),
    rule_file_of('larger.pl', Larger, F1),
    rule_file_of('same.pl', Same, F2),
    in_new_world(( use_rules(F1),
                   use_rules(F2),
                   pick(2, 2, C),
                   no_rules(F2),
                   pick(1, 2, D)
                 )).
test(read_again, [C, D] == [2, one]) :-
    rule_file_of('again.pl', "pick(_, B, B).\n", File),
    new_world(World),
    in_world(World, use_rules(File)),
    in_world(World, pick(1, 2, C)),
    rule_file_of('again.pl', "pick(_, _, one).\n", File),
    in_world(World, use_rules(File)),
    in_world(World, pick(1, 2, D)).
test(misspelt,
     error(model_error(rules(no_decision(pikc/3))), location(_, 2, _))) :-
    rule_file_of('misspelt.pl', "pick(_, B, B).\npikc(_, B, B).\n", File),
    in_new_world(use_rules(File)).
test(misspelt_changes_nothing, C == 2) :-
    larger(Larger),
    rule_file_of('larger.pl', Larger, F1),
    rule_file_of('bad.pl', "pick(_, _, bad).\npikc(_, B, B).\n", F2),
    in_new_world(( use_rules(F1),
                   catch(use_rules(F2), error(model_error(rules(_)), _), true),
                   pick(1, 2, C)
                 )).
test(syntax, error(model_error(rules(syntax_error(_))), location(_, 2, _))) :-
    rule_file_of('syntax.pl', "pick(_, B, B).\npick(_, B B).\n", File),
    in_new_world(use_rules(File)).
test(empty, error(model_error(rules(no_decisions)), _)) :-
    rule_file_of('empty.pl', "% nothing\n", File),
    in_new_world(use_rules(File)).
test(module_file, error(model_error(rules(module_file)), _)) :-
    rule_file_of('module.pl', ":- module(m, [pick/3]).\npick(_, B, B).\n",
                 File),
    in_new_world(use_rules(File)).
test(defined_elsewhere,
     error(model_error(rules(defined_elsewhere(lists:append/3))),
           location(_, 2, _))) :-
    rule_file_of('append.pl',
                 "pick(_, B, B).\nlists:append(_, _, none).\n", File),
    in_new_world(use_rules(File)).
test(what_is_elsewhere_stays, Xs == [a,b]) :-
    append([a], [b], Xs).
test(no_file, error(model_error(cannot_read(missing)), _)) :-
    in_new_world(use_rules('no_such_file.pl')).
test(no_world,
     [ condition(current_prolog_flag(threads, true)),
       error(existence_error(sg_world, _), _)
     ]) :-
    larger(Text),
    rule_file_of('larger.pl', Text, File),
    in_no_world(use_rules(File)).
test(default_of_nothing, error(existence_error(decision, foo/0), _)) :-
    default(foo).
test(worlds_end) :-
    larger(Text),
    rule_file_of('larger.pl', Text, File),
    forall(between(1, 40, _), in_new_world(use_rules(File))),
    few_followed(File, 100).

%   What worlds that have ended followed is forgotten: not at once, for atoms
%   are collected in a thread of their own too.

few_followed(File, Tries) :-
    garbage_collect_atoms,
    in_new_world(use_rules(File)),
    aggregate_all(count, sg_decision:followed(_, _, _, _, _), N),
    (   N < 30
    ->  true
    ;   Tries > 0,
        sleep(0.02),
        Tries1 is Tries-1,
        few_followed(File, Tries1)
    ).

:- end_tests(decision).
