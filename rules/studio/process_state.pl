:- module(sg_process_state,
          [ with_process_kept/3,        % +Arguments, :Goal, -Kept
            runs_users_code/1           % +Arguments
          ]).
:- use_module('../environment', [environment/2]).
:- use_module('../part', [whole_program/0]).
:- use_module(library(gensym), [reset_gensym/0]).
:- use_module(library(lists), [member/2]).
/** <module> What goals and rule files of users leave in a process, put back.

Verbs themselves leave nothing behind but caches. The goal of `query` and a rule
file may do anything: set a flag, define a predicate, load a library. What can
be put back is put back; where something else changed, the process has to be
replaced by a new one.
*/

:- meta_predicate with_process_kept(+, 0, -).

%!  with_process_kept(+Arguments, :Goal, -Kept:boolean) is semidet.
%
%   Call Goal, the verb with these Arguments, once. Kept is false if users' code
%   ran in it, and left what cannot be taken back.

with_process_kept(Arguments, Goal, Kept) :-
    (   runs_users_code(Arguments)
    ->  whole_program,
        process_state(State),
        call_cleanup(once(Goal), put_back(State)),
        process_state(After),
        (   State == After
        ->  Kept = true
        ;   Kept = false
        )
    ;   once(Goal),
        Kept = true
    ).

%!  runs_users_code(+Arguments) is semidet.
%
%   The verb with these Arguments runs a goal or a rule file of users.

runs_users_code(Arguments) :-
    member(Argument, Arguments),
    (   Argument == query
    ;   sub_atom(Argument, 0, _, _, '--rules')
    ),
    !.

%   process_state(State): flags, flag/3 keys, operators, predicates and clauses
%   of the module user, global variables, threads, streams, environment, clauses
%   that goals can add to.

process_state(state(Flags, Keys, Operators, Predicates, Globals, Threads,
                    Streams, Environment, Clauses)) :-
    findall(Flag-Value, kept_flag(Flag, Value), Flags0),
    msort(Flags0, Flags),
    findall(Key-Value, kept_key(Key, Value), Keys0),
    msort(Keys0, Keys),
    findall(op(P, T, Name), kept_operator(P, T, Name), Operators0),
    msort(Operators0, Operators),
    findall(PI, users_predicate(PI), Predicates0),
    msort(Predicates0, Predicates),
    findall(Key-Value, kept_global(Key, Value), Globals0),
    msort(Globals0, Globals),
    findall(Id, kept_thread(Id), Threads0),
    msort(Threads0, Threads),
    findall(Stream, stream_property(Stream, mode(_)), Streams0),
    msort(Streams0, Streams),
    findall(Name-Value,
            ( member(Name, ['LC_ALL','LC_MESSAGES','LANG','TMPDIR','TZ',
                            'PATH','HOME']),
              environment(Name, Value) ),
            Environment),
    findall(PI, counted_predicate(PI), Clauses).

%   Prolog makes the flag xref when it first loads a file.

kept_flag(Flag, Value) :-
    current_prolog_flag(Flag, Value),
    \+ memberchk(Flag, [message_language,heartbeat,xref]).

%   A key that was never used and one whose value is 0 are the same.

kept_key(Key, Value) :-
    current_flag(Key),
    flag(Key, Value, Value),
    Value \== 0.

kept_operator(Priority, Type, Name) :-
    current_op(Priority, Type, user:Name).

%   Prolog itself starts the thread `gc`, when it first collects atoms: at any
%   moment.

kept_thread(Id) :-
    thread_property(Thread, id(Id)),
    \+ thread_property(Thread, alias(gc)).

users_predicate(Name/Arity-Clauses) :-
    current_predicate(user:Name/Arity),
    functor(Head, Name, Arity),
    \+ predicate_property(user:Head, imported_from(_)),
    predicate_property(user:Head, number_of_clauses(Clauses)).

%   What the program keeps itself begins with sg_; it is set anew by each verb.

kept_global(Key, Value) :-
    nb_current(Key, Value),
    \+ sub_atom(Key, 0, _, _, sg_),
    \+ sub_atom(Key, 0, _, _, $).

%   counted_predicate(M:N/A-Clauses): of the dynamic and the multifile ones of
%   the program and of Prolog's hooks, which are looked for once.

:- dynamic counted/2, looked_for/0.

counted_predicate(Module:Name/Arity-Clauses) :-
    (   looked_for
    ->  true
    ;   forall(open_predicate(Module0, Head0),
               assertz(counted(Module0, Head0))),
        assertz(looked_for)
    ),
    counted(Module, Head),
    functor(Head, Name, Arity),
    predicate_property(Module:Head, number_of_clauses(Clauses)).

open_predicate(Module, Head) :-
    current_module(Module),
    (   sub_atom(Module, 0, _, _, sg_)
    ->  \+ sub_atom(Module, 0, _, _, 'sg_rules ')
    ;   memberchk(Module, [sanggwan,prolog,user,system,prolog_edit,sandbox])
    ),
    current_predicate(_, Module:Head),
    \+ predicate_property(Module:Head, imported_from(_)),
    (   predicate_property(Module:Head, dynamic)
    ->  true
    ;   predicate_property(Module:Head, multifile)
    ),
    functor(Head, Name, Arity),
    \+ sub_atom(Name, 0, _, _, $),
    \+ cache(Module:Name/Arity).

%   cache(PI): it holds what does not depend on goals, or is empty between
%   verbs.

cache(sg_model_text:relation_types_/3).
cache(sg_primitive:last_parts/3).
cache(sg_primitive:comma_parts_/1).
cache(sg_formula:formula_parts_/1).
cache(sg_shape:ring_kept/3).
cache(sg_item_where:text_read/3).
cache(sg_cli:told/1).
cache(sg_cli:told_once/0).
cache(sg_process_state:_).
cache(sg_session:_).
cache(sg_stop:_).
cache(sg_files_read:_).

%   put_back(State): as far as it can be. What is then still another is found
%   by comparing.

put_back(State) :-
    reset_gensym,
    process_state(Now),
    forall(arg(I, State, Was),
           ( arg(I, Now, Is),
             (   Was == Is
             ->  true
             ;   part_put_back(I, Was, Is)
             ) )).

part_put_back(1, Was, Is) :-
    forall(( member(Flag-Value, Was), \+ memberchk(Flag-Value, Is) ),
           catch(set_prolog_flag(Flag, Value), error(_, _), true)).
part_put_back(2, Was, Is) :-
    forall(( member(Key-Value, Is), \+ memberchk(Key-Value, Was) ),
           flag(Key, _, 0)),
    forall(member(Key-Value, Was), flag(Key, _, Value)).
part_put_back(3, Was, Is) :-
    forall(( member(op(P, T, Name), Is), \+ memberchk(op(P, T, Name), Was) ),
           catch(op(0, T, user:Name), error(_, _), true)),
    forall(( member(op(P, T, Name), Was), \+ memberchk(op(P, T, Name), Is) ),
           catch(op(P, T, user:Name), error(_, _), true)).
part_put_back(4, Was, Is) :-
    forall(( member(PI-_, Is), \+ memberchk(PI-_, Was) ),
           catch(abolish(user:PI), error(_, _), true)).
part_put_back(5, Was, Is) :-
    forall(( member(Key-_, Is), \+ memberchk(Key-_, Was) ),
           nb_delete(Key)),
    forall(( member(Key-Value, Was), \+ memberchk(Key-Value, Is) ),
           nb_setval(Key, Value)).
part_put_back(6, _, _).
part_put_back(7, Was, Is) :-
    forall(( member(Stream, Is), \+ memberchk(Stream, Was) ),
           catch(close(Stream, [force(true)]), error(_, _), true)).
part_put_back(8, Was, Is) :-
    forall(( member(Name-_, Is), \+ memberchk(Name-_, Was) ),
           unsetenv(Name)),
    forall(member(Name-Value, Was), setenv(Name, Value)).
part_put_back(9, _, _).
