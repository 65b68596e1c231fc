:- module(sg_world_state,
          [ world_begun/1,              % +World
            world_is_known/1,           % +World
            world_forgotten/1,          % +World
            in_state/3,                 % +World, +State, :Goal
            state_messages/3,           % +World, +State, -Objects
            made_once/4                 % +World, +Key, :Goal, ?Value
          ]).
:- use_module('../csg/csg_roots',
              [operand_lines/1, operand_lines_added/1, roots_alone/0]).
:- use_module('../message/message_object', [objects_heard/2]).
:- use_module('../penetration/penetration', [penetrate/2]).
:- use_module('../picture/picture_cut', [sewn_cut/1]).
:- use_module('../picture/sew', [borders_sewn/1]).
:- use_module('../store',
              [ assert_fact/1, facts_redo/0, facts_snapshot/1,
                facts_transaction/1, facts_undo/0, in_world/2,
                retractall_facts/1
              ]).
:- use_module(job, [captured/2]).
:- use_module(library(lists), [nth0/3]).
/** <module> What a world of a session was made ready for.

A picture needs more than an answer does, and both need what is the same for all
views. So the world of a revision has states, each made of the one before it, at
the first request that needs it:

  - `loaded`: as the model says
  - `cut`: borders are sewn, and segments have cut each other
  - `shown`: roots alone, with the lines of their operands, as `draw` has them

Each is a step of the world's undo, so going from one to another costs nothing,
and what is kept with the world (scenes, trees) stays right by its stamps. What
is asked in a state is asked in a snapshot, which leaves the steps as they are.
*/

:- meta_predicate in_state(+, +, 0), made_once(+, +, 0, ?).

% at(World, State, Top): by number, from 0; Top is the highest that was made.
% A world that has no such clause was left in the middle. heard(World, State,
% Objects): what was said when it was made. made_of(World, Key, Value): what is
% kept of a request.
:- dynamic at/3, heard/3, made_of/3.

state_number(State, Number) :-
    once(nth0(Number, [loaded,cut,shown], State)).

%!  world_begun(+World) is det.
%
%   World holds a model as it was loaded.

world_begun(World) :-
    world_forgotten(World),
    assertz(at(World, 0, 0)).

%!  world_is_known(+World) is semidet.
%
%   World can be brought into a state: nothing ended in the middle of that.

world_is_known(World) :-
    once(at(World, _, _)).

%!  world_forgotten(+World) is det.

world_forgotten(World) :-
    retractall(at(World, _, _)),
    retractall(heard(World, _, _)),
    retractall(made_of(World, _, _)).

%!  in_state(+World, +State, :Goal) is semidet.
%
%   Call Goal once, World being the current world, in this State. What Goal
%   changes is taken back.
%
%   @error geometry_error(What): the state cannot be made

in_state(World, State, Goal) :-
    state_number(State, Number),
    in_world(World,
             ( sg_world_state:brought(World, Number),
               facts_snapshot(( sg_world_state:mark_hidden, Goal )) )).

brought(World, Wanted) :-
    at(World, Now, _),
    !,
    (   Now =:= Wanted
    ->  true
    ;   stepped(World, Wanted),
        brought(World, Wanted)
    ).

%   stepped(World, Wanted): one state nearer. The clause is gone meanwhile: who
%   is stopped here leaves a world that nobody knows.

stepped(World, Wanted) :-
    retract(at(World, Now, Top)),
    !,
    (   Now > Wanted
    ->  facts_undo,
        Next is Now-1,
        NewTop = Top
    ;   Next is Now+1,
        (   Now < Top
        ->  facts_redo,
            NewTop = Top
        ;   catch(captured(objects_heard(sg_world_state:made(Next), Objects),
                           _),
                  error(Formal, Context),
                  ( assertz(at(World, Now, Top)),
                    throw(error(Formal, Context)) )),
            assertz(heard(World, Next, Objects)),
            NewTop = Next
        )
    ),
    assertz(at(World, Next, NewTop)).

:- public made/1.

made(Number) :-
    facts_transaction(( sg_world_state:marked(Number),
                        sg_world_state:ready(Number) )).

:- public marked/1, mark_hidden/0, ready/1.

%   marked(Number): the step changes the model, also if nothing has to be done.
%   mark_hidden: nobody who asks sees the mark.

marked(Number) :-
    mark_hidden,
    assert_fact(param(' ', Number)).

mark_hidden :-
    retractall_facts(param(' ', _)).

ready(1) :-
    borders_sewn(_),
    penetrate(all, [themselves(true)]).
ready(2) :-
    operand_lines(Lines),
    roots_alone,
    sewn_cut([]),
    operand_lines_added(Lines).

%!  state_messages(+World, +State, -Objects) is det.
%
%   Objects are the messages that were said when World came into State.

state_messages(World, State, Objects) :-
    state_number(State, Number),
    (   heard(World, Number, Objects0)
    ->  Objects = Objects0
    ;   Objects = []
    ).

%!  made_once(+World, +Key, :Goal, ?Value) is semidet.
%
%   Value is what Goal, called once, binds it to; it is kept with World under
%   Key, ground, and the next time Goal is not called.

made_once(World, Key, Goal, Value) :-
    (   made_of(World, Key, Value0)
    ->  Value = Value0
    ;   once(Goal),
        most_kept(Most),
        forall(( predicate_property(made_of(_, _, _), number_of_clauses(N)),
                 N >= Most ),
               once(retract(made_of(_, _, _)))),
        assertz(made_of(World, Key, Value))
    ).

%   most_kept(N): of all worlds; the oldest one goes first.

most_kept(32).
