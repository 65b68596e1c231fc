/* What users may call: one list, by topic, each with a true example. */
:- module(test_examples, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(filesex)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(sanggwan)).
:- use_module(rules(command/examples)).
:- use_module(rules(command/help)).
:- use_module(rules(topics)).

called(Topic, PI) :-
    topic_predicates(Topic, _, PIs),
    \+ memberchk(Topic, [relations,made_rows]),
    member(PI, PIs).

example_of(PI, example(Model, Goal, Answer)) :-
    example(PI, Model, Goal, Answer).

%   Goals run where nothing is but links to facts and docs.

here :-
    tmp_file(examples, Folder),
    make_directory(Folder),
    forall(member(Name, [facts,docs]),
           ( absolute_file_name(sanggwan(Name), Path, [file_type(directory)]),
             directory_file_path(Folder, Name, Link),
             link_file(Path, Link, symbolic)
           )),
    working_directory(Old, Folder),
    nb_setval(test_examples_here, Old-Folder).

back :-
    nb_getval(test_examples_here, Old-Folder),
    working_directory(_, Old),
    delete_directory_and_contents(Folder).

%   answer(+Example, -Wrong): [] if the first answer is the one that is told.

answer(example(Model, GoalText0, AnswerText), Wrong) :-
    atom_concat(GoalText, '.', GoalText0),
    format(string(Text), "((~w) :- (~w))", [GoalText, AnswerText]),
    term_string((Goal :- Answer), Text),
    new_world(World),
    in_world(World, asked(Model, Goal, Answer, Wrong)).

asked(Model, Goal, Answer, Wrong) :-
    (   Model == none
    ->  true
    ;   load_model(Model)
    ),
    comma_list(Answer, Wanted),
    maplist(answer_value, Wanted, Pairs),
    (   with_output_to(string(_), once(user:Goal))
    ->  (   Answer == false
        ->  Wrong = yes
        ;   include(differs, Pairs, Wrong)
        )
    ;   Answer == false
    ->  Wrong = []
    ;   Wrong = no
    ).

answer_value(A, A-Value) :-
    (   A = (_ = Value)
    ->  true
    ;   Value = none
    ).

differs((Got = _)-Value) :-
    \+ subsumes_term(Value, Got).

quiet(Goal) :-
    setup_call_cleanup(
        ( asserta((user:message_hook(_, _, _) :- true), Hook),
          current_input(In) ),
        ( open_string("", Empty),
          set_input(Empty),
          call(Goal) ),
        ( set_input(In),
          erase(Hook) )).

:- multifile user:message_hook/3.
:- dynamic user:message_hook/3.

:- begin_tests(examples).

test(how_many, true((60 =< N, N =< 100))) :-
    aggregate_all(count, offered(_, sanggwan), N).
test(every_relation, Missing == []) :-
    findall(PI,
            ( member(Topic, [relations,made_rows]),
              topic_predicates(Topic, _, PIs),
              member(PI, PIs) ),
            All),
    findall(Name/Arity,
            ( relation(Name, Arity, _), \+ memberchk(Name/Arity, All) ),
            Missing).
test(nothing_else, All == Listed) :-
    findall(PI, offered(PI, _), All0),
    msort(All0, All),
    findall(PI, ( topic_predicates(_, _, PIs), member(PI, PIs) ), Listed0),
    msort(Listed0, Listed).
test(each_has_one, Pairs == Called) :-
    findall(PI, called(_, PI), Called0),
    sort(Called0, Called),
    findall(PI, example(PI, _, _, _), Pairs0),
    msort(Pairs0, Pairs).
test(documented, [ condition(sg_help:documented(_, _, _, _, _, _)),
                   Missing == [] ]) :-
    findall(Name/Arity,
            ( called(_, Name/Arity),
              \+ ( sg_help:called(Name, Arity, Module),
                   sg_help:documented(Module, Name, Arity, _, _, _) ) ),
            Missing).
test(true, [ setup(here), cleanup(back),
             forall(example_of(PI, Example)),
             Wrong-PI == []-PI ]) :-
    quiet(answer(Example, Wrong)).
test(help_shows_it, condition(sg_help:documented(_, _, _, _, _, _))) :-
    with_output_to(string(Text), sanggwan_help(volume/2)),
    sub_string(Text, _, _, _, "?- volume(1, V).\n    V = 8.0."),
    !.
test(topic, condition(sg_help:documented(_, _, _, _, _, _))) :-
    with_output_to(string(Text), sanggwan_help(asking)),
    sub_string(Text, _, _, _, "\n  volume/2 "),
    !.
test(start_here) :-
    with_output_to(string(Text), sanggwan_help),
    sub_string(Text, 0, _, _, "Start here:"),
    \+ sub_string(Text, _, _, _, "sg_").

:- end_tests(examples).
