/* Writes the reference: each relation with its columns, each predicate that
   users may call with its modes and text.

       swipl -p foreign=build tools/reference.pl -- build/docs/reference.md
*/
:- module(sg_reference, []).
:- use_module(library(aggregate)).
:- use_module(library(lists)).

:- prolog_load_context(directory, Tools),
   atom_concat(Tools, '/../rules/sanggwan.pl', Facade),
   load_files(user:Facade, [silent(true)]).

:- initialization(main, main).

main :-
    current_prolog_flag(argv, [File]),
    setup_call_cleanup(open(File, write, Out, [encoding(utf8)]),
                       with_output(Out),
                       close(Out)).

with_output(Out) :-
    current_output(Old),
    setup_call_cleanup(set_output(Out), reference, set_output(Old)).

reference :-
    format("# Reference~n~nMade by tools/reference.pl.~n~n## Relations~n"),
    forall(sg_store:relation(Name, Arity, Doc),
           relation_written(Name, Arity, Doc)),
    forall(aggregate(set(p(Name,Arity)), public(Module, Name, Arity), Set),
           ( file_of(Module, File),
             format("~n## ~w~n", [File]),
             forall(member(p(Name,Arity), Set),
                    predicate_written(Module, Name, Arity))
           )).

relation_written(Name, Arity, Doc) :-
    format("~n### ~w/~w~n~n~w~n~n| column | type | |~n|---|---|---|~n",
           [Name, Arity, Doc]),
    forall(sg_store:relation_column(Name, Position, Column, Type, _),
           ( sg_store:column_doc(Name, Position, Text)
           -> format("| ~w | ~w | ~w |~n", [Column, Type, Text])
           ;  format("| ~w | ~w | |~n", [Column, Type])
           )).

%   public(-Module, -Name, -Arity): Module defines what users may call.

public(Module, Name, Arity) :-
    sg_topics:offered(Name/Arity, Facade),
    functor(Head, Name, Arity),
    (   predicate_property(Facade:Head, imported_from(Module))
    ->  true
    ;   Module = Facade
    ),
    \+ sg_store:relation(Name, Arity, _).

file_of(Module, File) :-
    module_property(Module, file(Path)),
    file_base_name(Path, File).

predicate_written(Module, Name, Arity) :-
    sg_help:documented(Module, Name, Arity, Modes, _, Text),
    !,
    format("~n### ~w/~w~n~n~~~~~~prolog~n~w~n~~~~~~~n~w~n",
           [Name, Arity, Modes, Text]).
predicate_written(_, Name, Arity) :-
    format("~n### ~w/~w~n", [Name, Arity]).
