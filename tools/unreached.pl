:- module(sg_unreached,
          [ unreached/1,                % -PI
            load_oracles/0
          ]).
:- use_module(library(lists)).
:- use_module(library(occurs)).
:- use_module(library(prolog_codewalk)).
:- use_module(library(readutil)).
/* Which predicates of the loaded rules nothing reaches that a user can do: then
   only a test runs them, and they belong to tests/oracle/, or nothing does.

   A user runs what C calls, what the facade exports, and the hooks of Prolog.
   A predicate reaches what its clauses call, and what they name: an atom or
   term that, perhaps with more arguments, is a predicate there. So a table may
   name makers.
   Doors may also be asked by oracles alone: these hold the kernel to its rule.
*/

:- dynamic calls/2, reached/1.

%!  unreached(-PI) is nondet.
%
%   PI, Module:Name/Arity, is a predicate of rules/ that nothing reaches.

unreached(PI) :-
    retractall(calls(_, _)),
    prolog_walk_code([ undefined(ignore), autoload(false),
                       module_class([user]), source(false),
                       trace_reference(_), on_trace(call_found) ]),
    reach_from(user_root),
    findall(P, ( rule_predicate(P), \+ reached(P) ), Ps0),
    reach_from(oracle_root),
    member(PI, Ps0),
    \+ ( is_foreign(PI), reached(PI) ).

%!  load_oracles is det.
%
%   Load tests/oracle/. To be called before unreached/1.

load_oracles :-
    expand_file_name('tests/oracle/*.pl', Files),
    forall(member(File, Files),
           load_files(sg_unreached_oracles:File, [silent(true), imports([])])).

call_found(Callee, Caller, _) :-
    (   predicate_named(Callee, To),
        ( predicate_named(Caller, From) -> true ; From = Caller ),
        \+ calls(From, To)
    ->  assertz(calls(From, To))
    ;   true
    ).

%   predicate_named(+M:Head, -PI): where it is defined.

predicate_named(Module:Head, Home:Name/Arity) :-
    atom(Module),
    callable(Head),
    functor(Head, Name, Arity),
    (   predicate_property(Module:Head, imported_from(Home0))
    ->  Home = Home0
    ;   Home = Module
    ).


                /*******************************
                *           THE ROOTS          *
                *******************************/

user_root(PI) :-
    read_file_to_string('engine/main.c', Main, []),
    read_file_to_string('engine/engine.c', Engine, []),
    member(Text, [Main,Engine]),
    called_of_c(Text, PI).
user_root(PI) :-
    sg_topics:offered(Name/Arity, Facade),
    functor(Head, Name, Arity),
    predicate_named(Facade:Head, PI).
user_root(PI) :-
    calls(PI, _),
    \+ rule_predicate(PI),
    \+ oracle_root(PI).
user_root(PI) :-
    rule_predicate(PI),
    PI = Module:Name/Arity,
    functor(Head, Name, Arity),
    predicate_property(Module:Head, public).

%   called_of_c(Text, PI): PL_predicate("name", arity, "module").

called_of_c(Text, Module:Name/Arity) :-
    sub_string(Text, _, _, After, "PL_predicate(\""),
    sub_string(Text, _, After, 0, Rest),
    split_string(Rest, "\"", "", [NameText,Between,ModuleText|_]),
    split_string(Between, ",", " ", [_,ArityText|_]),
    number_string(Arity, ArityText),
    atom_string(Name, NameText),
    atom_string(Module, ModuleText).

oracle_root(PI) :-
    calls(PI, _),
    PI = Module:_,
    atom_concat(sg_oracle_, _, Module).


                /*******************************
                *           REACHING           *
                *******************************/

:- meta_predicate reach_from(1).

reach_from(Root) :-
    retractall(reached(_)),
    forall(call(Root, PI), reach(PI)).

reach(PI) :-
    (   reached(PI)
    ->  true
    ;   assertz(reached(PI)),
        forall(reaches(PI, Other), reach(Other))
    ).

reaches(PI, Other) :-
    calls(PI, Other).
reaches(Module:Name/Arity, Other) :-
    functor(Head, Name, Arity),
    \+ predicate_property(Module:Head, imported_from(_)),
    predicate_property(Module:Head, number_of_clauses(_)),
    catch(clause(Module:Head, Body), _, fail),
    sub_term(Term, Head-Body),
    nonvar(Term),
    names(Module, Term, Other).

%   names(Module, Term, PI): Term is the beginning of a call of PI.

names(_, Module:Term, PI) :-
    !,
    atom(Module),
    nonvar(Term),
    names(Module, Term, PI).
names(Module, Term, PI) :-
    callable(Term),
    functor(Term, Name, Given),
    current_predicate(Module:Name/Arity),
    (   Arity > Given
    ->  true
    ;   Arity =:= Given,
        Given > 0
    ),
    functor(Head, Name, Arity),
    predicate_named(Module:Head, PI),
    rule_predicate(PI).

%   rule_predicate(?PI): it is one of rules/, and no fact that compiling leaves.

rule_predicate(Module:Name/Arity) :-
    (   var(Module)
    ->  current_module(Module)
    ;   true
    ),
    module_property(Module, file(File)),
    sub_atom(File, _, _, _, '/rules/'),
    current_predicate(Module:Name/Arity),
    \+ sub_atom(Name, 0, _, _, $),
    \+ sub_atom(Name, 0, _, _, '__'),
    functor(Head, Name, Arity),
    \+ predicate_property(Module:Head, imported_from(_)),
    \+ predicate_property(Module:Head, dynamic).

is_foreign(Module:Name/Arity) :-
    functor(Head, Name, Arity),
    predicate_property(Module:Head, foreign).
