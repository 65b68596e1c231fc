:- module(sg_development_search,
          [ usual_effort/3,         % +Flattening, +Options, -Effort
            objective_effort/3,     % +Options, +Orders, -Effort
            exchanged/6,            % +Flattening, +Order, +Kept, +Objective,
                                    % +Effort, -Exchanges
            folds/2                 % +Flattening, -Js
          ]).
:- use_module(laid_joint, [joint_state/3]).
:- use_module('../kernel', [flattening_counts/4, exchange_seams/6]).
:- use_module('../stage', [stage/2]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> A shorter seam: folds of a development taken back for better ones.

Joining in the order of the least seam (DV-6) gives the least seam only where no
joint is refused. Otherwise a joint that was refused may be worth more than the
folds in its way. So each seam is tried once more, in the order of joints: what
is in its way is taken back, the seam is joined, and what came off is joined
again where it can be. If the whole seam is shorter then, it stays so. That goes
round and round, until a whole round has not helped.

tests/oracle/seam_exchange.pl says the same turn by turn.

@see c_kernels/development/seam_exchange.h
*/

%!  usual_effort(+Flattening, +Options:list, -Effort) is det.
%
%   Effort is how many faces may be laid or moved to find a shorter seam where
%   no objective is given: as the option effort(Millions) says; otherwise 3
%   million for models of up to 10,000 faces, and 0 for others.

usual_effort(Flattening, Options, Effort) :-
    (   option(effort(Millions), Options)
    ->  must_be(nonneg, Millions),
        Effort is Millions*1_000_000
    ;   flattening_counts(Flattening, Faces, _, _),
        Faces =< 10_000
    ->  Effort = 3_000_000
    ;   Effort = 0
    ).

%!  objective_effort(+Options:list, +Orders, -Effort) is det.
%
%   Likewise for each of so many Orders of joints that are tried for an
%   objective: a part of effort(Millions); 48, of any model.

objective_effort(Options, Orders, Effort) :-
    option(effort(Millions), Options, 48),
    must_be(nonneg, Millions),
    Effort is Millions*1_000_000//Orders.

%!  exchanged(+Flattening, +Order, +Kept:list, +Objective, +Effort,
%!            -Exchanges) is det.
%
%   Folds of Flattening, whose joints were tried in Order (joint_order/3), are
%   exchanged so that Objective is met better; Exchanges is how often that was
%   found. The joints Kept stay folds. Only of `seam` and `pieces` one knows at
%   each turn whether it helped; for other objectives nothing is exchanged.

exchanged(Flattening, Order, Kept, Objective, Effort, Exchanges) :-
    (   Effort > 0,
        memberchk(Objective, [seam,pieces])
    ->  stage(join, exchange_seams(Flattening, Order, Kept, Objective, Effort,
                                   Exchanges))
    ;   Exchanges = 0
    ).

%!  folds(+Flattening, -Js:list) is det.
%
%   Js are the joints that are joined, ascending.

folds(Flattening, Js) :-
    flattening_counts(Flattening, _, Count, _),
    findall(J, ( between(1, Count, J), is_joined(Flattening, J) ), Js).

is_joined(Flattening, J) :-
    joint_state(Flattening, J, joined).
