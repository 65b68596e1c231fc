:- module(sg_decision,
          [ decision/2,                 % directive: +Name/Arity, +Doc
            decision/4,                 % ?Decision, -Doc, -Place, -By
            decision_is_default/1,      % +Name/Arity
            default/1,                  % :Goal
            decided_at/2,               % :Goal, -Location
            use_rules/1,                % +File
            use_rules_of/2,             % +Text, +Name
            no_rules/0,
            no_rules/1,                 % +File
            rule_file/1,                % ?File
            rules/0
          ]).
/** <module> Decisions: rules that a world may replace.

What happens at an event is a decision: a documented predicate with a default.

    :- decision(merge_line/3, "Which collinear pieces become one (PL-9)").

    merge_line(A, B, AB) :- ...

A rule file defines some of these names again, and use_rules/1 makes the current
world follow it; other worlds, in other threads of the same process, do not
notice. In a rule file default/1 calls what it replaces:

    merge_line(A, B, AB) :-
        \+ on_plane_of_symmetry(A),
        default(merge_line(A, B, AB)).

Rule files are programs and are trusted. They may load libraries and define
predicates of their own, as long as something in the file calls them: a
predicate that is neither a decision nor called is taken for a misspelt decision
and refused.

How it works: the clauses written as merge_line/3 become those of
'merge_line default'/3, and merge_line/3 itself asks the world which module
decides. Files with decisions are known when they are compiled, so a decision
has a fixed slot in each world's table (decision4pl.c).
*/

:- use_module(kernel,
              [ rule_module/2, set_rule_modules/1, world_number/1,
                ended_world/1
              ]).
:- use_module(part, [whole_program/0]).
:- use_module(limits, [limit_value/2]).
:- use_module(text_file, [with_text/4]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [member/2, memberchk/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(occurs), [sub_term/2]).

:- meta_predicate default(:), decided_at(:, -), with_first_error(0, -).

% What decides only reads (sandbox.pl).
:- multifile sandbox:safe_primitive/1.

% declared(Name, Arity, Module, Slot, Doc, File, Line), and how to call its
% default: clauses that the directive leaves in the file that has it.
:- multifile declared/7, default_goal/2.
:- discontiguous declared/7, default_goal/2.
:- dynamic declared/7, default_goal/2.

% slot_(Module, Name, Arity, Slot): taken, also while the file is reloaded.
:- dynamic slot_/4.

% followed(World, File, Module, Decisions, Id): the latest file comes first.
% World is a number, so that this keeps no world alive.
:- dynamic followed/5.


                /*******************************
                *          DECLARING           *
                *******************************/

%!  decision(+Decision, +Doc)
%
%   Directive: the predicate Decision = Name/Arity, whose clauses follow, is a
%   decision that a world may replace. Doc is a string of one line.

decision(Decision, _) :-
    throw(error(permission_error(call, directive, decision(Decision)), _)).

:- thread_local watching/0, first_error/1.
:- public decision_clauses/4, default_clause/3, clause_of/2, ends_program/1,
          one_clause_more/0.

system:term_expansion((:- decision(Decision, Doc)), Clauses) :-
    prolog_load_context(module, Module),
    predicate_property(Module:decision(_, _), imported_from(sg_decision)),
    decision_clauses(Decision, Doc, Module, Clauses).
system:term_expansion(Clause, Renamed) :-
    prolog_load_context(module, Module),
    slot_(Module, _, _, _),
    default_clause(Clause, Module, Renamed).

decision_clauses(Name/Arity, Doc, Module,
                 [ sg_decision:declared(Name, Arity, Module, Slot, Doc, File,
                                        Line),
                   sg_decision:default_goal(Head, Module:Default),
                   sandbox:safe_primitive(Module:Head),
                   (   Head :-
                           (   sg_kernel:rule_module(Slot, Rules)
                           ->  Rules:Head
                           ;   Default
                           )
                   ),
                   (:- sg_decision:keep_slot(Module, Name, Arity, Slot))
                 ]) :-
    must_be(atom, Name),
    must_be(string, Doc),
    take_slot(Module, Name, Arity, Slot),
    functor(Head, Name, Arity),
    default_head(Head, Default),
    source_location(File, Line).

take_slot(Module, Name, Arity, Slot) :-
    slot_(Module, Name, Arity, Slot),
    !.
take_slot(_, Name, Arity, _) :-
    slot_(_, Name, Arity, _),
    !,
    throw(error(permission_error(redeclare, decision, Name/Arity), _)).
take_slot(Module, Name, Arity, Slot) :-
    predicate_property(slot_(_, _, _, _), number_of_clauses(Slot)),
    assertz(slot_(Module, Name, Arity, Slot)).

%   keep_slot(+Module, +Name, +Arity, +Slot): again where the compiled file is
%   loaded, in a process that never saw its source.

:- public keep_slot/4.

keep_slot(Module, Name, Arity, Slot) :-
    (   slot_(Module, Name, Arity, _)
    ->  true
    ;   assertz(slot_(Module, Name, Arity, Slot))
    ).

%   default_clause(+Clause, +Module, -Renamed) is semidet.
%
%   Renamed is a clause of the default: Clause's head is a decision of Module.

default_clause((Head :- Body), Module, (Default :- Body)) :-
    !,
    renamed_head(Head, Module, Default).
default_clause((Head, Guard => Body), Module, (Default, Guard => Body)) :-
    !,
    renamed_head(Head, Module, Default).
default_clause((Head => Body), Module, (Default => Body)) :-
    !,
    renamed_head(Head, Module, Default).
default_clause(Head, Module, Default) :-
    renamed_head(Head, Module, Default).

renamed_head(Head, Module, Default) :-
    callable(Head),
    functor(Head, Name, Arity),
    slot_(Module, Name, Arity, _),
    default_head(Head, Default).

default_head(Head, Default) :-
    Head =.. [Name|Arguments],
    atom_concat(Name, ' default', DefaultName),
    Default =.. [DefaultName|Arguments].


                /*******************************
                *           ASKING             *
                *******************************/

%!  decision(?Decision, -Doc, -Place, -By) is nondet.
%
%   True when Decision = Name/Arity may be replaced; Doc says what it decides,
%   Place = File:Line where it is declared, and By is who defines it in the
%   current world: `default`, or a rule file.

decision(Name/Arity, Doc, File:Line, By) :-
    declared(Name, Arity, _, Slot, Doc, File, Line),
    (   rule_module(Slot, Module),
        followed(_, RuleFile, Module, _, _)
    ->  By = RuleFile
    ;   By = default
    ).

%!  decision_is_default(+Decision) is semidet.
%
%   True when no rule file replaces Decision = Name/Arity in the current world:
%   only then may a kernel stand in for it.
%
%   @error existence_error(decision, Decision)

decision_is_default(Name/Arity) :-
    (   declared(Name, Arity, _, Slot, _, _, _)
    ->  \+ rule_module(Slot, _)
    ;   throw(error(existence_error(decision, Name/Arity), _))
    ).

%!  default(:Goal) is nondet.
%
%   Call the default of the decision that Goal names, whatever the current world
%   follows.
%
%   @error existence_error(decision, Decision)

default(_:Goal) :-
    must_be(callable, Goal),
    (   default_goal(Goal, Default)
    ->  call(Default)
    ;   functor(Goal, Name, Arity),
        throw(error(existence_error(decision, Name/Arity), _))
    ).

%!  decided_at(:Goal, -Location) is det.
%
%   Location, location(File, Line, 0), is where the clause stands by which a
%   rule file of the current world gives Goal, an answer of a decision: for
%   errors in it. Unbound if Goal is not of a rule file.

decided_at(_:Goal, Location) :-
    functor(Goal, Name, Arity),
    (   declared(Name, Arity, _, Slot, _, _, _),
        rule_module(Slot, Module),
        clause(Module:Goal, Body, Ref),
        catch(once(Module:Body), error(_, _), fail),
        clause_property(Ref, file(File)),
        clause_property(Ref, line_count(Line))
    ->  Location = location(File, Line, 0)
    ;   true
    ).

%!  rules is det.
%
%   List the decisions, what they decide, and who defines each in the current
%   world.

rules :-
    forall(decision(Decision, Doc, _, By),
           print_message(help, sanggwan(decision(Decision, Doc, By)))).

%!  rule_file(?File) is nondet.
%
%   True when the current world follows File; the one that decides first comes
%   first.

rule_file(File) :-
    world_number(World),
    followed(World, File, _, _, _).


                /*******************************
                *          FOLLOWING           *
                *******************************/

%!  use_rules(+File) is det.
%
%   Make the current world follow the rule file File, in one step, before those
%   it follows already. A file it already follows is read again.
%
%   @error model_error(cannot_read(Why)) with location(Spec, 0, 0): Why is
%          `missing`, `directory` or `permission`.
%   @error model_error(rules(What)) with location(File, Line, Column): it is no
%          Prolog, or it defines what is no decision. Nothing has changed.

use_rules(Spec) :-
    readable_file(Spec, File),
    world_number(World),
    with_mutex(sg_rules, follow(World, File, File)).

%!  use_rules_of(+Text, +Name) is det.
%
%   The same of what the file Text, or standard input, `-`, holds; the rules are
%   known as Name.

use_rules_of(Text, Name) :-
    world_number(World),
    with_mutex(sg_rules, follow(World, Text, Name)).

readable_file(Spec, File) :-
    absolute_file_name(Spec, File0,
                       [extensions(['', pl]), access(read),
                        file_errors(fail)]),
    !,
    File = File0.
readable_file(Spec, _) :-
    absolute_file_name(Spec, Path),
    (   exists_directory(Path)
    ->  Why = directory
    ;   exists_file(Path)
    ->  Why = permission
    ;   Why = missing
    ),
    throw(error(model_error(cannot_read(Why)), location(Spec, 0, 0))).

follow(World, Text, File) :-
    whole_program,
    forget_ended,
    new_module(Module),
    module_id(Module, File, Id),
    catch(( load_rules(Text, File, Module, Id),
            rules_defined(Module, File, Decisions)
          ),
          Error,
          ( free_module(Module, Id),
            throw(Error)
          )),
    forget(World, File),
    asserta(followed(World, File, Module, Decisions, Id)),
    set_slots(World).

%!  no_rules is det.
%
%   Stop following all rule files: the current world has its default decisions.

no_rules :-
    world_number(World),
    (   followed(World, _, _, _, _)
    ->  with_mutex(sg_rules, ( forall(followed(World, File, _, _, _),
                                      forget(World, File)),
                               set_slots(World)
                             ))
    ;   true
    ).

%!  no_rules(+File) is det.
%
%   Stop following File: what it replaced is as it was before.
%
%   @error existence_error(rules, File) if the current world does not follow it.

no_rules(Spec) :-
    absolute_file_name(Spec, File, [extensions(['', pl]), file_errors(error)]),
    world_number(World),
    (   followed(World, File, _, _, _)
    ->  with_mutex(sg_rules, ( forget(World, File),
                               set_slots(World)
                             ))
    ;   throw(error(existence_error(rules, File), _))
    ).

%   The slots of the current world, from its files: the first one that defines
%   a decision has it.

set_slots(World) :-
    findall(Slot-Module,
            ( slot_(_, Name, Arity, Slot),
              once(( followed(World, _, Module, Decisions, _),
                     memberchk(Name/Arity, Decisions)
                   ))
            ),
            Pairs),
    set_rule_modules(Pairs).

forget(World, File) :-
    forall(retract(followed(World, File, Module, _, Id)),
           free_module(Module, Id)).

%   Worlds that are gone leave their modules behind.

forget_ended :-
    ended_world(World),
    !,
    forall(retract(followed(World, _, Module, _, Id)),
           free_module(Module, Id)),
    forget_ended.
forget_ended.


                /*******************************
                *        READING A FILE        *
                *******************************/

new_module(Module) :-
    flag(sg_rules, N, N+1),
    atom_concat('sg_rules ', N, Module),
    set_module(Module:class(temporary)),
    add_import_module(Module, sg_decision, start),
    (   current_module(sanggwan)
    ->  add_import_module(Module, sanggwan, start)
    ;   true
    ).

%   A file can be loaded into one module only, so it is loaded from a stream,
%   under a name of its own where another world follows it too, or where it was
%   loaded in part before an error: Prolog remembers its module.

module_id(Module, File, Id) :-
    (   ( source_file(File)
        ; followed(_, _, _, _, File)
        ; source_file_property(File, load_context(_, _, _))
        )
    ->  atomic_list_concat([File, ' (', Module, ')'], Id)
    ;   Id = File
    ).

free_module(Module, Id) :-
    unload_file(Id),
    catch('$destroy_module'(Module), error(_, _), true).

load_rules(Text, File, Module, Id) :-
    nb_setval(sg_rule_clauses, 0-none),
    with_text(program, Text, text(_, _, Stream),
              with_first_error(
                  load_files(Module:Id, [stream(Stream), silent(true)]),
                  Error)),
    (   var(Error)
    ->  not_a_module(File, Id)
    ;   throw_rules_error(Error, File)
    ).

%   A file defines predicates of its own. Those of others it may add clauses to
%   if they are dynamic or multifile; the program needs the rest as they are.

system:term_expansion(Clause, _) :-
    watching,
    one_clause_more,
    (   ends_program(Clause)
    ->  Why = ends_program
    ;   clause_of(Clause, Module:Head),
        \+ prolog_load_context(module, Module),
        predicate_property(Module:Head, defined),
        \+ predicate_property(Module:Head, dynamic),
        \+ predicate_property(Module:Head, multifile),
        functor(Head, Name, Arity),
        Why = defined_elsewhere(Module:Name/Arity)
    ),
    throw(error(Why, _)).

%   ends_program(Clause): a directive that would end it, in silence.

ends_program(Clause) :-
    nonvar(Clause),
    ( Clause = (:- Goal) ; Clause = (?- Goal) ),
    nonvar(Goal),
    memberchk(Goal, [halt,halt(_)]).

%   one_clause_more: not above the limit, else the file is read no further.

one_clause_more :-
    nb_getval(sg_rule_clauses, N0-Last),
    prolog_load_context(term_position, Position),
    stream_position_data(char_count, Position, Place),
    (   Place == Last                   % another module expands it
    ->  true
    ;   N is N0+1,
        nb_setval(sg_rule_clauses, N-Place),
        within_clauses(N)
    ).

within_clauses(N) :-
    limit_value(clauses, Most),
    (   N =< Most
    ->  true
    ;   throw(error(limit(clauses, Most), _))
    ).

%   clause_of(+Clause, -Head) is semidet: Head is Module:Plain.

clause_of(Clause, _) :-
    var(Clause),
    !,
    fail.
clause_of((Head :- _), Qualified) :-
    !,
    clause_of(Head, Qualified).
clause_of(Module:Head, Module:Head) :-
    atom(Module),
    callable(Head).

not_a_module(File, Id) :-
    (   module_property(_, file(Id))
    ->  throw(error(model_error(rules(module_file)), location(File, 1, 0)))
    ;   true
    ).

:- multifile user:message_hook/3.

%   Errors while loading are messages: keep the first, print none, and read no
%   further. One that does not know its place is kept as at(Error, Line).

user:message_hook(Error, error, _) :-
    watching,
    (   first_error(_)
    ->  true
    ;   \+ placed(Error, _, _, _),
        source_location(_, Line)
    ->  assertz(first_error(at(Error, Line)))
    ;   assertz(first_error(Error))
    ),
    to_end_of_file.

to_end_of_file :-
    (   prolog_load_context(stream, Stream)
    ->  catch(seek(Stream, 0, eof, _), error(_, _), true)
    ;   true
    ).

%   with_first_error(:Goal, -Error): Error is unbound when there was none. What
%   ends a load may be told, with its place, and thrown.

with_first_error(Goal, Error) :-
    setup_call_cleanup(
        asserta(watching),
        catch(Goal, Thrown, true),
        retractall(watching)),
    (   retract(first_error(First))
    ->  Error = First
    ;   Error = Thrown
    ).

throw_rules_error(Error, File) :-
    (   placed(Error, Formal, Line, Column)
    ->  true
    ;   Error = at(Ball, Line)
    ->  ball_formal(Ball, Formal),
        Column = 0
    ;   ball_formal(Error, Formal),
        Line = 0,
        Column = 0
    ),
    (   Formal = limit(_, _)
    ->  What = Formal
    ;   What = rules(Formal)
    ),
    throw(error(model_error(What), location(File, Line, Column))).

placed(error(Formal, Context), Formal, Line, Column) :-
    nonvar(Context),
    error_place(Context, Line, Column).

ball_formal(error(Formal, _), Formal) :-
    !.
ball_formal(Ball, thrown(Ball)).

error_place(file(_, Line, Column, _), Line, Column).
error_place(file(_, Line), Line, 0).
error_place(stream(_, Line, Column, _), Line, Column).


                /*******************************
                *      WHAT A FILE DEFINES     *
                *******************************/

%   rules_defined(+Module, +File, -Decisions) is det.
%
%   Decisions are those that the clauses in Module define.
%
%   @error model_error(rules(no_decision(PI))), model_error(rules(no_decisions))

rules_defined(Module, File, Decisions) :-
    findall(Name/Arity, defined(Module, Name, Arity), Defined),
    findall(PI, ( member(PI, Defined), is_decision(PI) ), Decisions),
    mentions(Module, Defined, Mentions),
    forall(( member(PI, Defined),
             \+ is_decision(PI),
             \+ mentioned(PI, Mentions)
           ),
           no_decision(Module, PI, File)),
    (   Decisions == []
    ->  throw(error(model_error(rules(no_decisions)), location(File, 1, 0)))
    ;   true
    ).

defined(Module, Name, Arity) :-
    current_predicate(Module:Name/Arity),
    functor(Head, Name, Arity),
    \+ predicate_property(Module:Head, imported_from(_)),
    \+ predicate_property(Module:Head, dynamic).

is_decision(Name/Arity) :-
    slot_(_, Name, Arity, _),
    !.

%   mentions(Module, Defined, Mentions): Mentions has, by the names of Defined,
%   which of Defined have this name in the body of a clause: a call, or a
%   closure that lacks some of its arguments.

mentions(Module, Defined, Mentions) :-
    findall(Name-true, member(Name/_, Defined), Names0),
    sort(Names0, Names1),
    list_to_assoc(Names1, Names),
    findall(Of-(Name/Arity),
            ( member(Name/Arity, Defined),
              functor(Head, Name, Arity),
              clause(Module:Head, Body),
              sub_term(Goal, Body),
              callable(Goal),
              functor(Goal, Of, _),
              get_assoc(Of, Names, true)
            ),
            Pairs0),
    sort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    list_to_assoc(Groups, Mentions).

%   mentioned(PI, Mentions): by another predicate than itself.

mentioned(Name/Arity, Mentions) :-
    get_assoc(Name, Mentions, By),
    member(Other, By),
    Other \== Name/Arity,
    !.

no_decision(Module, Name/Arity, File) :-
    functor(Head, Name, Arity),
    (   predicate_property(Module:Head, line_count(Line))
    ->  true
    ;   Line = 0
    ),
    throw(error(model_error(rules(no_decision(Name/Arity))),
                location(File, Line, 0))).
