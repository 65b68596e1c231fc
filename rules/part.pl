:- module(sg_part,
          [ whole_program/0,
            whole_program_for/1,        % +Goal
            loaded_rule/2,              % ?Module, -Folder
            carried_file/2              % +File, -Stream
          ]).
:- use_module(kernel, [program_part/3]).
:- use_module(library(occurs), [sub_term/2]).
/** <module> Parts: the program loads a rule file when it is first called.

A verb uses a fifth of the rules, and to load them all would take longer than
most verbs do. So tools/parts.pl makes a part of each module, which the program
carries, compiled. It starts as plain Prolog and loads the core, in which this
file is. A call of a predicate that is not there loads the part of its module.
What is loaded is linked to all it imports, so no rule file knows of parts.

What looks at rules rather than calls them, and what lets several threads run
them, calls whole_program/0 before; it is also called before Prolog loads a
file. Where no program carries the rules, there are no parts.
*/

% part(Module, From, Bytes): the program carries it there; it is not loaded yet.
% carried(File, From, Bytes): and a file.
:- dynamic part/3, carried/3.

%!  whole_program is det.
%
%   Load all rules.

whole_program :-
    forall(part(Module, _, _), ignore(loaded(Module))),
    '$set_source_files'(from_state).

%!  whole_program_for(+Goal) is det.
%
%   Load all rules if Goal looks at what is loaded.

whole_program_for(Goal) :-
    (   part(_, _, _),
        sub_term(Part, Goal),
        callable(Part),
        functor(Part, Name, _),
        looks(Name)
    ->  whole_program
    ;   true
    ).

looks(clause).
looks(nth_clause).
looks(listing).
looks(current_predicate).
looks(predicate_property).
looks(current_module).
looks(module_property).
looks(source_file).

%!  loaded_rule(?Module, -Folder) is nondet.
%
%   True when Module, of a rule file in Folder of rules/, is loaded.

loaded_rule(Module, Folder) :-
    current_module(Module),
    sub_atom(Module, 0, _, _, sg_),
    module_property(Module, file(File)),
    file_directory_name(File, Path),
    file_base_name(Path, Folder).

%!  carried_file(+File, -Stream) is semidet.
%
%   Stream reads the octets of File, which the program carries.

carried_file(File, Stream) :-
    carried(File, From, Bytes),
    program_part(From, Bytes, Stream).

                /*******************************
                *       CALLED BY PROLOG       *
                *******************************/

:- public hooked/0, found/1, load_asked/1.

%   hooked: Prolog calls found/1 and load_asked/1 from now on.

hooked :-
    assertz((user:exception(undefined_predicate, PI, retry) :-
                 sg_part:found(PI))),
    assertz((user:prolog_load_file(File, _) :-
                 sg_part:load_asked(File),
                 fail)).

%   found(PI): PI, which was called and is not there, is of a part. That is
%   loaded now.

found(Module:Name/Arity) :-
    !,
    functor(Head, Name, Arity),
    home(Module, Head, Home),
    loaded(Home).
found(Name/Arity) :-
    found(user:Name/Arity).

home(Module, _, Module) :-
    part(Module, _, _),
    !.
home(Module, Head, Home) :-
    '$get_predicate_attribute'(Module:Head, imported, Home).

%   load_asked(File): Prolog is about to load File. A library that is a part is
%   loaded already when it looks.

load_asked(_:library(Name)) :-
    atom(Name),
    (   loaded(Name)
    ;   module_property(Name, file(_))
    ),
    !.
load_asked(_) :-
    whole_program.

%   loaded(Module) is semidet: it was a part. An interrupt waits: it would leave
%   half a part.

loaded(Module) :-
    part(Module, _, _),
    with_mutex(sg_part,
               setup_call_cleanup(part_loaded(Module), true, true)).

part_loaded(Module) :-
    retract(part(Module, From, Bytes)),
    !,
    program_part(From, Bytes, Stream),
    call_cleanup('$qlf_load'(Module:Stream, _), close(Stream)).
part_loaded(_).

                /*******************************
                *     DIRECTIVES OF PARTS      *
                *******************************/

:- public exported/2, imported/2, predicates_declared/1, flags_set/1.

%   exported(PIs, Module).

exported([], _).
exported([PI|PIs], Module) :-
    export(Module:PI),
    exported(PIs, Module).

%   imported(Imports, Module): Imports are Home-PIs. A Home that is not loaded
%   exports them from now on.

imported([], _).
imported([Home-PIs|Imports], Module) :-
    imported(PIs, Home, Module),
    imported(Imports, Module).

imported([], _, _).
imported([PI|PIs], Home, Module) :-
    export(Home:PI),
    Module:import(Home:PI),
    imported(PIs, Home, Module).

%   predicates_declared(Declarations): what who calls a predicate has to know
%   before it is loaded, such as meta_predicate(Head).

predicates_declared([]).
predicates_declared([Declaration|Declarations]) :-
    call(Declaration),
    predicates_declared(Declarations).

flags_set([]).
flags_set([flag(Name, Value, Type)|Flags]) :-
    (   current_prolog_flag(Name, Value)
    ->  true
    ;   catch(create_prolog_flag(Name, Value, [type(Type)]), error(_, _), true)
    ),
    flags_set(Flags).
