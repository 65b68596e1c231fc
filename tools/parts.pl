/* parts.pl -- the rules, compiled, as the program carries them: the core, which
   it loads when it starts, and parts, which it loads when they are called
   (rules/part.pl). Loaded into build/boot:

       parts(Core, Parts, Files)

   writes the core and, one after the other, the parts and Files.
*/
:- module(sg_parts, [parts/3]).

% plain_predicate(Module, Head), plain_flag(Name, Value): of Prolog without
% rules. A library that is loaded already does not count: the next start may not
% load it.
% of_program(Module): it was there before what only this file needs.
:- dynamic plain_predicate/2, plain_flag/2, of_program/1.

% Prolog's own modules are to be seen too.
:- set_prolog_flag(access_level, system),
   forall(( current_module(Module),
            \+ ( module_property(Module, file(_)),
                 \+ module_property(Module, class(system))
               ),
            current_predicate(_, Module:Head),
            \+ predicate_property(Module:Head, imported_from(_))
          ),
          assertz(plain_predicate(Module, Head))),
   forall(current_prolog_flag(Name, Value), assertz(plain_flag(Name, Value))),
   set_prolog_flag(access_level, user).

:- load_files(user:'rules/command/cli.pl', []).

% Prolog that is told to autoload no more loads at once what its libraries have
% declared to load when it is first needed.
:- set_prolog_flag(autoload, false),
   set_prolog_flag(autoload, true).

:- forall(( current_module(Module), Module \== sg_parts ),
          assertz(of_program(Module))).

:- use_module(library(apply), [foldl/4, partition/4]).
:- use_module(library(lists), [member/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
:- use_module(library(qsave), []).

parts(Core, Parts, Files) :-
    findall(Module, of_program(Module), Modules0),
    sort(Modules0, Modules),
    partition(is_part, Modules, Later, Now),
    set_prolog_flag(access_level, system),
    setup_call_cleanup(
        open(Parts, write, Out, [type(binary)]),
        ( foldl(part_written(Out), Later, 0, End),
          foldl(file_written(Out), Files, End, _)
        ),
        close(Out)),
    core_written(Core, Now, Later).

%   is_part(Module): nothing needs Module before it is called. One with nothing
%   in it is never called; one with a predicate of the name of a built-in one
%   would never be missed.

is_part(Module) :-
    Module \== sg_part,
    \+ module_property(Module, class(system)),
    module_property(Module, file(_)),
    once(has_clauses(Module) ; starts(Module, _)),
    \+ ( module_property(Module, exports(PIs)),
         member(PI, PIs),
         hides_other(Module, PI)
       ).

has_clauses(Module) :-
    own(Module, Head),
    predicate_property(Module:Head, number_of_clauses(_)).

%   starts(Module, Goal): its file has Goal run at every start, such as one that
%   loads a foreign library.

starts(Module, Goal) :-
    module_property(Module, file(File)),
    clause(system:'$init_goal'(-, Goal, File:_), true).

own(Module, Head) :-
    current_predicate(_, Module:Head),
    \+ predicate_property(Module:Head, imported_from(_)).

hides_other(Module, Name/Arity) :-
    functor(Head, Name, Arity),
    \+ predicate_property(Module:Head, imported_from(_)),
    member(Other, [user, system]),
    '$c_current_predicate'(_, Other:Head),
    \+ predicate_property(Other:Head, imported_from(Module)).

                /*******************************
                *            PARTS             *
                *******************************/

part_written(Out, Module, From, To) :-
    tmp_file_stream(File, Scratch, [encoding(octet)]),
    close(Scratch),
    compiled(File, [Module], true),
    part_copied(File, Out, Bytes),
    delete_file(File),
    assertz(sg_part:part(Module, From, Bytes)),
    To is From+Bytes.

file_written(Out, File, From, To) :-
    part_copied(File, Out, Bytes),
    assertz(sg_part:carried(File, From, Bytes)),
    To is From+Bytes.

part_copied(File, Out, Bytes) :-
    size_file(File, Bytes),
    setup_call_cleanup(
        open(File, read, In, [type(binary)]),
        copy_stream_data(In, Out),
        close(In)).

:- meta_predicate compiled(+, +, 0).

%   compiled(File, Modules, Also): File has all of Modules and, at its end, what
%   the goal Also adds. What Prolog compiles begins with a module; if that had a
%   source, Prolog would remove what other modules have of it already.

compiled(File, Modules, Also) :-
    setup_call_cleanup(
        '$qlf_open'(File),
        ( '$qlf_start_module'(sg_no_file),
          forall(member(Module, Modules), module_written(Module)),
          call(Also),
          '$qlf_end_part'
        ),
        '$qlf_close').

module_written(Module) :-
    '$qlf_start_sub_module'(Module),
    header_written(Module),
    qsave:save_unknown(Module),
    forall(( own(Module, Head), \+ installed(Module, Head) ),
           predicate_written(Module, Head)),
    exports_written(Module),
    imports_written(Module),
    qsave:save_module_operators(Module),
    started(Module),
    '$qlf_end_part'.

%   installed(Module, Head): our own C defines it before the core is read.

installed(Module, Head) :-
    sub_atom(Module, 0, _, _, sg_),
    predicate_property(Module:Head, foreign).

%   predicate_written(Module, Head): of what plain Prolog has, what rules and
%   their libraries add. Those with $ are what it has noted while it compiled.

predicate_written(Module, Head) :-
    \+ plain_predicate(Module, Head),
    !,
    ignore(qsave:save_predicate(Module:Head, development)).
predicate_written(Module, Head) :-
    functor(Head, Name, _),
    (   sub_atom(Name, 0, _, _, $)
    ->  true
    ;   forall(( nth_clause(Module:Head, _, Clause),
                 clause_property(Clause, file(File)),
                 \+ plain_file(File)
               ),
               '$qlf_assert_clause'(Clause, development))
    ).

plain_file(File) :-
    current_prolog_flag(home, Home),
    atom_concat(Home, '/boot/', Boot),
    sub_atom(File, 0, _, _, Boot).

header_written(Module) :-
    module_property(Module, file(File)),
    module_property(Module, line_count(Line)),
    module_property(Module, class(Class)),
    import_module(Module, Super),
    !,
    '$add_directive_wic'('$declare_module'(Module, Class, Super, File, Line,
                                           false)).
header_written(_).

exports_written(Module) :-
    module_property(Module, exports(Exports0)),
    sort(Exports0, Exports),
    '$add_directive_wic'(sg_part:exported(Exports, Module)).

imports_written(Module) :-
    findall(Home-(Name/Arity),
            ( predicate_property(Module:Head, imported_from(Home)),
              \+ qsave:default_import(Module, Head, Home),
              functor(Head, Name, Arity)
            ),
            Pairs0),
    sort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Imports),
    '$add_directive_wic'(sg_part:imported(Imports, Module)).

%   started(Module): it starts when it is loaded. library(sandbox) only looks at
%   its own table, which is right.

started(Module) :-
    forall(( starts(Module, Goal), Goal \= sandbox:_ ),
           '$add_directive_wic'(Goal)).

                /*******************************
                *           THE CORE           *
                *******************************/

%   Prolog's own modules are there, but for what the rules add to them.

core_written(File, Modules, Later) :-
    compiled(File, [sg_part],
             ( '$add_directive_wic'(sg_part:hooked),
               module_added(system),
               forall(( member(Module, Modules), Module \== sg_part ),
                      (   module_property(Module, class(system))
                      ->  true
                      ;   module_written(Module)
                      )),
               declarations_written(Later),
               flags_written
             )).

module_added(Module) :-
    '$qlf_start_sub_module'(Module),
    forall(own(Module, Head), predicate_written(Module, Head)),
    '$qlf_end_part'.

declarations_written(Later) :-
    findall(Declaration,
            ( member(Module, Later),
              module_property(Module, exports(PIs0)),
              sort(PIs0, PIs),
              member(PI, PIs),
              declared(Module, PI, Declaration)
            ),
            Declarations),
    '$add_directive_wic'(sg_part:predicates_declared(Declarations)).

declared(Module, Name/Arity, Declaration) :-
    functor(Head, Name, Arity),
    \+ predicate_property(Module:Head, imported_from(_)),
    (   predicate_property(Module:Head, meta_predicate(Meta))
    ->  Declaration = meta_predicate(Module:Meta)
    ;   predicate_property(Module:Head, transparent)
    ->  Declaration = module_transparent(Module:Name/Arity)
    ).

%   Flags: those of libraries, and how the program runs wherever it was built.

flags_written :-
    findall(flag(Name, Value, Type),
            ( '$current_prolog_flag'(Name, Value, _, write, Type),
              \+ plain_flag(Name, _)
            ),
            Flags0),
    sort([ flag(color_term,false,boolean), flag(hyperlink_term,false,boolean),
           flag(on_error,status,atom), flag(optimise,true,boolean) | Flags0
         ], Flags),
    '$add_directive_wic'(sg_part:flags_set(Flags)).
