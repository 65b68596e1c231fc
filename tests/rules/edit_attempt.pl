:- module(sg_test_edit_attempt,
          [ attempt/2,                  % :Goal, -Wrong
            tried/1                     % :Goal
          ]).
/** <module> Calls of edits and of questions, and which of their errors no user
should see. With EDIT_SAY in the environment each goal is printed first.
*/

:- meta_predicate
    attempt(0, -),
    tried(0).

%!  attempt(:Goal, -Wrong:list) is det.
%
%   Goal once; whether it is true does not matter.

attempt(Goal, Wrong) :-
    say('~w:  ~q~n', Goal),
    catch(( ignore(once(Goal)), Error = none ), Error, true),
    (   is_wrong(Error)
    ->  strip_module(Goal, _, Plain),
        Wrong = [raised(Plain, Error)]
    ;   Wrong = []
    ).

%!  tried(:Goal) is det.
%
%   As attempt/2, inside one of its goals: what is wrong ends that.

tried(Goal) :-
    say('~w:    ~q~n', Goal),
    catch(( ignore(once(Goal)), Error = none ), Error, true),
    (   is_wrong(Error)
    ->  throw(Error)
    ;   true
    ).

say(Format, Goal) :-
    (   getenv('EDIT_SAY', _)
    ->  thread_self(Me),
        strip_module(Goal, _, Plain),
        format(user_error, Format, [Me,Plain])
    ;   true
    ).

%   is_wrong(Error): no user should see it.

is_wrong(error(existence_error(procedure, Module:_), _)) :-
    \+ sub_atom(Module, 0, _, _, sg_test_edit_).
is_wrong(error(existence_error(procedure, Name/_), _)) :-
    atom(Name).
is_wrong(error(system_error(_), _)).
is_wrong(error(resource_error(_), Context)) :-
    is_dict(Context, stack_overflow).
is_wrong(error(assertion_failed(_), _)).
is_wrong(assertion_failed(_)).
is_wrong(unwind(_)).
