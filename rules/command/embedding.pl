:- module(sg_embedding,
          [ embedded/5                  % +World, +What, -Status, -Text, -Ws
          ]).
:- use_module('../decision', [use_rules/1]).
:- use_module('../kernel', [world_number/1]).
:- use_module('../message/spoken', [spoken_lines/4]).
:- use_module('../model/model', [load_model/1, save_model/1]).
:- use_module('../plain', [plain_term/2]).
:- use_module('../studio/query', [read_goal/3]).
:- use_module('../status', [error_status/2]).
:- use_module('../store', [in_world/2]).
:- use_module(verbs, [draw/2]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(pairs), [pairs_keys_values/3]).
/** <module> What a C program asks for (engine/engine.c, sanggwan.h).

Goals of a host are called in a module of their own, sg_host, which sees the
facade and the module user. Answers come from a Prolog engine, so that any
number of questions can be under way.
*/

%!  embedded(+World, +What, -Status, -Text, -Warnings) is det.
%
%   Do What in World. Status is that of the command line; Text says what was
%   wrong, and Warnings has a line for each message of the kind warning or error
%   that was printed on the way; both are "" when there is nothing to say. What
%   is
%
%     - load(File), use_rules(File), save(File), draw(File, Options): Options is
%       text, a list without its brackets
%     - run(Text): a goal, once
%     - ask(Text, -Names, -Engine): Names = names(Name, ...)
%     - next(Engine, -Row): Row = row(Value, ...); Status 1 when there is none
%     - close(Engine)
%     - enter: World stays the current one

embedded(World, enter, 0, "", "") :-
    !,
    sg_store:set_world(World).
embedded(World, What, Status, Text, Warnings) :-
    setup_call_cleanup(
        asserta(listening, Listening),
        catch(in_world(World, outcome(What, Status, Text, Warnings)), Error,
              ( failed(Error, Status, Text),
                Warnings = ""
              )),
        erase(Listening)).

outcome(What, Status, Text, Warnings) :-
    world_number(World),
    retractall(warned(World, _)),
    (   catch(done(What), Error, failed(Error, Status, Text))
    ->  (   var(Status)
        ->  Status = 0,
            Text = ""
        ;   true
        )
    ;   Status = 1,
        Text = ""
    ),
    findall(Warning, retract(warned(World, Warning)), Lines),
    atomics_to_string_lines(Lines, Warnings).

atomics_to_string_lines(Lines, Text) :-
    atomic_list_concat(Lines, '\n', Atom),
    atom_string(Atom, Text).

done(load(File)) :-
    load_model(File).
done(use_rules(File)) :-
    use_rules(File).
done(save(File)) :-
    save_model(File).
done(draw(File, Text)) :-
    options(Text, Options),
    draw(File, Options).
done(run(Text)) :-
    read_goal(Text, Goal, _),
    host_module(Module),
    once(Module:Goal).
done(ask(Text, NamesTerm, Engine)) :-
    read_goal(Text, Goal, Bindings),
    pairs_keys_values(Bindings, Names, Values),
    NamesTerm =.. [names|Names],
    Row =.. [row|Values],
    host_module(Module),
    engine_create(Row, sg_embedding:answer(Module:Goal), Engine).
done(next(Engine, Row)) :-
    engine_next(Engine, Row).
done(close(Engine)) :-
    engine_destroy(Engine).

options("", []) :-
    !.
options(Text, Options) :-
    format(string(ListText), "[~s]", [Text]),
    read_goal(ListText, Options, _),
    must_be(list, Options).

host_module(sg_host) :-
    (   import_module(sg_host, sanggwan)
    ->  true
    ;   add_import_module(sg_host, sanggwan, start)
    ).

:- public answer/1.
:- meta_predicate answer(0).

%   answer(Goal): called in an engine, which has facts of its own.

answer(Goal) :-
    (   listening
    ->  true
    ;   asserta(listening)
    ),
    call(Goal).


                /*******************************
                *           MESSAGES           *
                *******************************/

failed(Error, Status, Text) :-
    (   interruption(Error)
    ->  Status = 130
    ;   error_status(Error, Status)
    ),
    error_text(Error, Text).

interruption('$aborted').
interruption(unwind(abort)).
interruption(sanggwan_interrupt(_)).

error_text(Error, Text) :-
    (   catch(message_text(Error, Text), _, fail)
    ->  true
    ;   plain_term(Error, Plain),
        format(string(Text), "~q", [Plain])
    ).

message_text(Term, Text) :-
    '$messages':translate_message(Term, Lines0, []),
    spoken_lines(error, Term, Lines0, Lines),
    lines_text(Lines, Text).

lines_text(Lines, Text) :-
    with_output_to(string(Text0),
                   ( current_output(Out),
                     print_message_lines(Out, '', Lines)
                   )),
    split_string(Text0, "", " \n", [Text]).

% listening: messages of this thread or engine are kept. warned(World, Text).
:- thread_local listening/0.
:- dynamic warned/2.

:- multifile user:message_hook/3.

user:message_hook(Term, Kind, Lines) :-
    sg_embedding:listening,
    sg_embedding:heard(Kind, Term, Lines).

:- public heard/3.

heard(informational, _, _).
heard(warning, Term, Lines) :-
    keep(warning, Term, Lines).
heard(error, Term, Lines) :-
    keep(error, Term, Lines).

keep(Kind, Term, Lines0) :-
    world_number(World),
    spoken_lines(Kind, Term, Lines0, Lines),
    lines_text(Lines, Text),
    assertz(warned(World, Text)).
