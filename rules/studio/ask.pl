:- module(sg_ask,
          [ question_state/2,           % +Head, -State
            asked/3,                    % +Head, +Id, -Reply
            next_answers/2,             % +Head, -Reply
            asks_forgotten/0
          ]).
:- use_module('../space_limit', [with_stack_limit/2]).
:- use_module('../store', [facts_snapshot/1]).
:- use_module(ask_hidden, [asks_of_picture/1, hides/2]).
:- use_module(question_part, [data_error/2, unsafe_part/2]).
:- use_module(query, [answer_json/2, read_goal/3]).
:- use_module(answer_name, [shown_names/2]).
:- use_module(request, [request_error/1]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3]).
:- use_module(library(pairs), [pairs_keys_values/3]).
:- use_module(library(sandbox), [safe_goal/1]).
:- use_module(library(solution_sequences), [limit/2]).
/** <module> Questions to the document of a session, with limits.

A goal of somebody is called if library(sandbox) finds that it can only read
(sandbox.pl), and it names nothing that question_part.pl lists; that of the
owner whatever it does. Either way the document is as before afterwards. All
answers are of one revision: they are found at once, as many as there may be,
and handed out in parts.
*/

% asked_(Id, Names, Rows, More): the rows of question Id that were not handed
% out yet; More as in the reply.
:- dynamic asked_/4.

%   ask_limits(Seconds, Inferences, Octets, Answers, Part)

ask_limits(5, 100 000 000, 256 000 000, 10 000, 50).

%!  question_state(+Head:dict, -State) is det.
%
%   State is `picture` if the goal Head.goal asks for what only a picture has,
%   else `cut`: what the world has to be for it.
%
%   @error request_error(What), usage_error(bad_goal(Text, Why))

question_state(Head, State) :-
    question_goal(Head, Goal, _),
    (   asks_of_picture(Goal)
    ->  State = picture
    ;   State = cut
    ).

question_goal(Head, Goal, Bindings) :-
    (   get_dict(goal, Head, Text),
        string(Text)
    ->  true
    ;   request_error(bad_key(goal, goal))
    ),
    read_goal(Text, Goal, Bindings).

%!  asked(+Head:dict, +Id, -Reply:dict) is det.
%
%   Reply has the first answers of the goal Head.goal: names, answers, left,
%   cut; `shows` has of each answer the names (select.pl) of what it is about.
%
%   @error request_error(What), usage_error(bad_goal(Text, Why)), what the goal
%   raises

asked(Head, Id, Reply) :-
    (   get_dict(owner, Head, true)
    ->  Owner = true
    ;   Owner = false
    ),
    question_goal(Head, Goal, Bindings),
    in_module(Owner, Module, answers(Owner, Module:Goal, Bindings, Names, Rows,
                                     Cut)),
    parted(Id, Names, Rows, Cut, Reply0),
    Reply = Reply0.put(_{names:Names, owner:Owner}).

%   in_module(Owner, Module, Goal): goals of others are called in a module that
%   is gone afterwards: there they may assert.

:- meta_predicate in_module(+, -, 0).

in_module(true, user, Goal) :-
    !,
    once(Goal).
in_module(false, Module, Goal) :-
    flag(sg_asks, N, N+1),
    atom_concat('sg_ask ', N, Module),
    setup_call_cleanup(
        question_module(Module),
        once(Goal),
        '$destroy_module'(Module)).

question_module(Module) :-
    set_module(Module:class(temporary)),
    Module:import(sg_ask_hidden:hides/2).

answers(true, Goal, Bindings, Names, Rows, Cut) :-
    answers(Goal, Bindings, Names, Rows, Cut).
answers(false, Goal, Bindings, Names, Rows, Cut) :-
    goal_is_safe(Goal),
    catch(answers(Goal, Bindings, Names, Rows, Cut), Error0,
          ( data_error(Error0, Error), throw(Error) )).

answers(Goal, Bindings, Names, Rows, Cut) :-
    pairs_keys_values(Bindings, Names, Values),
    ask_limits(Seconds, Inferences, Octets, Most, _),
    Enough is Most+1,
    with_stack_limit(Octets,
        within_seconds(Seconds,
            within_inferences(Inferences,
                facts_snapshot(
                    findall(Row,
                            limit(Enough, sg_ask:row(Goal, Values, Row)),
                            Rows0))))),
    length(Rows0, N),
    (   N > Most
    ->  length(Rows, Most),
        append(Rows, _, Rows0),
        Cut = true
    ;   Rows = Rows0,
        Cut = false
    ).

:- public row/3.

row(Goal, Values, Row-Shown) :-
    call(Goal),
    maplist(answer_json, Values, Row),
    shown_names(Goal, Shown).

goal_is_safe(Module:Goal) :-
    (   unsafe_part(Goal, Part)
    ->  unsafe(permission_error(call, sandboxed, Part))
    ;   catch(safe_goal(Module:Goal), error(Formal, _), unsafe(Formal))
    ).

unsafe(permission_error(_, sandboxed, Culprit)) :-
    !,
    numbervars(Culprit, 0, _),          % so it always reads the same
    request_error(unsafe_goal(Culprit)).
unsafe(Formal) :-
    throw(error(Formal, _)).

%   parted(Id, Names, Rows, Cut, Reply): what is not in the Reply is kept.

parted(Id, Names, Rows, Cut, Reply) :-
    ask_limits(_, _, _, _, Part),
    retractall(asked_(Id, _, _, _)),
    (   length(First, Part),
        append(First, [Next|Rest], Rows)
    ->  assertz(asked_(Id, Names, [Next|Rest], Cut)),
        length(Rest, Left0),
        Left is Left0+1
    ;   First = Rows,
        Left = 0
    ),
    pairs_keys_values(First, Answers, Shown),
    Reply = _{answers:Answers, shows:Shown, left:Left, cut:Cut}.

%!  next_answers(+Head:dict, -Reply:dict) is det.
%
%   The next answers of the question with the id Head.of.
%
%   @error request_error(no_answers_left(Id))

next_answers(Head, Reply) :-
    (   get_dict(of, Head, Id),
        asked_(Id, Names, Rows, Cut)
    ->  parted(Id, Names, Rows, Cut, Reply0),
        Reply = Reply0.put(names, Names)
    ;   get_dict(of, Head, Id)
    ->  request_error(no_answers_left(Id))
    ;   request_error(bad_key(of, ask))
    ).

%!  asks_forgotten is det.
%
%   No answers are left: the document is another one now.

asks_forgotten :-
    retractall(asked_(_, _, _, _)).


                /*******************************
                *            LIMITS            *
                *******************************/

:- meta_predicate
    within_seconds(+, 0),
    within_inferences(+, 0).

within_inferences(Most, Goal) :-
    call_with_inference_limit(once(Goal), Most, Result),
    (   Result == inference_limit_exceeded
    ->  request_error(too_long(inferences, Most))
    ;   true
    ).

%   within_seconds(Seconds, Goal): library(time) would do, but see progress.pl.

within_seconds(Seconds, Goal) :-
    thread_self(Self),
    setup_call_cleanup(
        ( nb_setval(sg_ask_timed, true),
          thread_create(sg_ask:timer(Self, Seconds), Timer)
        ),
        once(Goal),
        ( nb_setval(sg_ask_timed, false),
          thread_send_message(Timer, done),
          thread_join(Timer)
        )).

:- public timer/2.

timer(Worker, Seconds) :-
    thread_self(Self),
    (   thread_get_message(Self, done, [timeout(Seconds)])
    ->  true
    ;   catch(thread_signal(Worker, sg_ask:time_is_over(Seconds)),
              error(_, _), true),
        thread_get_message(Self, done)
    ).

:- public time_is_over/1.

time_is_over(Seconds) :-
    (   nb_getval(sg_ask_timed, true)
    ->  request_error(too_long(seconds, Seconds))
    ;   true
    ).
