/* Lists whose end or whose elements are not known yet, in every argument of
   every export of the facade: an answer or an error comes soon. A list without
   end is walked for ever, until the memory is full. */
:- module(test_open_list, []).
:- use_module(library(apply)).
:- use_module(library(filesex)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(library(time)).
:- use_module(rules(sanggwan)).
:- use_module(tests('rules/edit_question')).
:- use_module(tests('rules/polyhedron'), [in_new_world/1]).
:- use_module(tests('rules/sample'), [few/3]).

open_value(_).
open_value([_]).
open_value([_|_]).
open_value([1|_]).
open_value([1-_]).
open_value([_-_|_]).
open_value(f(_)).

%   open_value(Word, Value): for an argument that is called Word.

open_value('Options', Value) :-
    !,
    (   open_value(Value)
    ;   member(Name, [ segments,wanted,cut,keep,order,removed,root,trim,by,
                       lines,views,thickness,tolerance,sections,remove,only,
                       names ]),
        open_value(A),
        Value =.. [Name,A]
    ).
open_value(_, Value) :-
    open_value(Value).

%   case(Draws, Part, Goal): so many random ones for each value, or a Part of
%   all; other arguments are what could be meant.

case(Draws, Part, Goal) :-
    exported(All),
    member(Name/Arity, All),
    Arity > 0,
    Name \== set_world,                 % no snapshot takes that back
    documented_words(Name, Arity, Words),
    nth1(K, Words, Word),
    open_value(Word, Value0),
    value_list(Word, Value0, Value),
    between(1, Draws, _),
    maybe(Part),
    maplist(argument, Words, Arguments0),
    nth1(K, Arguments0, _, Rest),
    nth1(K, Arguments, Value, Rest),
    Goal0 =.. [Name|Arguments],
    with_files(Goal0, Goal).

value_list('Options', Value0, Value) :-
    compound(Value0),
    \+ Value0 = [_|_],
    !,
    Value = [Value0].
value_list(_, Value, Value).

has_no_end(Goal) :-
    catch(( call_with_time_limit(20, facts_snapshot(ignore(once(Goal)))),
            Error = none ),
          Error, true),
    no_end(Error).

no_end(Error) :-
    nonvar(Error),
    (   Error = time_limit_exceeded
    ;   Error = error(resource_error(_), _)
    ).

model :-
    add_primitive(box(size(2,2,2)), _),
    add_primitive(at([translate(1,1,1)],
                     cylinder(radius(1), height(2), facets(8))),
                  _),
    penetrate,
    unfold(1, _),
    picture.

:- dynamic is_quiet/0.
:- multifile user:message_hook/3.

user:message_hook(_, _, _) :-
    is_quiet.

%   Little memory, so that a list without end is soon at its own; what is said
%   and written is not looked at.

with_little(Goal) :-
    current_prolog_flag(stack_limit, Limit),
    tmp_file(open_list, Folder),
    open_null_stream(Null),
    current_output(Current),
    stream_property(Out, alias(user_output)),
    setup_call_cleanup(
        ( make_directory(Folder),
          working_directory(Here, Folder),
          setenv('EDIT_SCRATCH', Folder),
          set_prolog_flag(stack_limit, 100_000_000),
          set_stream(Null, alias(user_output)),
          set_output(Null),
          assertz(is_quiet) ),
        Goal,
        ( retractall(is_quiet),
          working_directory(_, Here),
          set_stream(Out, alias(user_output)),
          set_output(Current),
          close(Null),
          set_prolog_flag(stack_limit, Limit),
          delete_directory_and_contents(Folder) )).

wants_options(develop(1, Options, _), Options).
wants_options(unfold(1, Options, _), Options).
wants_options(true_development(2, _, Options, _), Options).
wants_options(explain(seam(1,1), Options), Options).
wants_options(explanation(seam(1,1), Options, _), Options).

raised(Goal, Formal) :-
    catch(( ignore(Goal), Formal = none ), error(Formal, _), true).

:- begin_tests(open_list).

%   These went through what is not there yet, without end.

test(options, Others == []) :-
    in_new_world(( model,
                   with_little(findall(Goal-Formal,
                                       ( open_value('Options', Options),
                                         \+ ground(Options),
                                         wants_options(Goal, Options),
                                         raised(Goal, Formal),
                                         \+ memberchk(Formal,
                                                      [ instantiation_error,
                                                        type_error(list, _)
                                                      ]) ),
                                       Others)) )).

test(each, Endless == []) :-
    few(1-0.2, 20-1.0, Draws-Part),
    set_random(seed(16)),
    State = count(0),
    in_new_world(( model,
                   with_little(findall(Goal,
                                       ( case(Draws, Part, Goal),
                                         arg(1, State, N0),
                                         N is N0+1,
                                         nb_setarg(1, State, N),
                                         has_no_end(Goal) ),
                                       Endless)) )),
    arg(1, State, N),
    format("counted: ~d calls with lists that are not whole~n", [N]).

:- end_tests(open_list).
