:- module(sg_space_limit,
          [ with_stack_limit/2,         % +Octets, :Goal
            with_stack_for/3            % +Count, +Octets, :Goal
          ]).
/** <module> How large Prolog's stacks may become for a goal.
*/

:- meta_predicate
    with_stack_limit(+, 0),
    with_stack_for(+, +, 0).

%!  with_stack_limit(+Octets, :Goal) is semidet.
%
%   As once(Goal), in which the stacks of this thread may have so many Octets.
%
%   @error resource_error(stack_overflow)

with_stack_limit(Octets, Goal) :-
    current_prolog_flag(stack_limit, Old),
    setup_call_cleanup(
        set_prolog_flag(stack_limit, Octets),
        once(Goal),
        set_prolog_flag(stack_limit, Old)).

%!  with_stack_for(+Count, +Octets, :Goal) is semidet.
%
%   As with_stack_limit/2, for what grows with the model: no less than before,
%   and so many Octets for each of Count things.

with_stack_for(Count, Octets, Goal) :-
    current_prolog_flag(stack_limit, Old),
    Limit is max(Old, Count*Octets),
    with_stack_limit(Limit, Goal).
