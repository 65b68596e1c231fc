:- module(sg_development_search,
          [ usual_effort/3,         % +Flattening, +Options, -Effort
            objective_effort/3,     % +Options, +Orders, -Effort
            exchanged/6,            % +Flattening, +Order, +Kept, +Objective,
                                    % +Effort, -Exchanges
            exchanged_by_rule/5,    % +Flattening, +Order, +Kept, +Objective,
                                    % -Exchanges
            folds/2                 % +Flattening, -Js
          ]).
:- use_module('../kernel',
              [ flattening_counts/4, flattening_joint/3, exchange_seams/6,
                join_faces/3, join_folds/2, joint_order/3, fold_path/4,
                seam_length/2
              ]).
:- use_module('../stage', [stage/2]).
:- use_module(library(apply), [exclude/3, foldl/4]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(lists), [last/2, member/2, nth1/3]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(pairs), [pairs_values/2]).
/** <module> A shorter seam: folds of a development taken back for better ones.

Joining in the order of the least seam (DV-6) gives the least seam only where no
joint is refused. Otherwise a joint that was refused may be worth more than the
folds in its way. So each seam is tried once more, in the order of joints: what
is in its way is taken back, the seam is joined, and what came off is joined
again where it can be. If the whole seam is shorter then, it stays so. That goes
round and round, until a whole round has not helped.

exchanged/6 is the fused kernel, exchanged_by_rule/5 says the same turn by turn.

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
    flattening_joint(Flattening, J, joint(_,_,_,_,_,_,_,_,joined)).

/* - - - the rule - - - */

%!  exchanged_by_rule(+Flattening, +Order, +Kept:list, +Objective,
%!                    -Exchanges) is det.
%
%   As exchanged/6, turn by turn, with all the effort that it takes.

exchanged_by_rule(Flattening, Order, Kept, Objective, Exchanges) :-
    joint_order(Flattening, Order, Js),
    ranks(Js, Ranks),
    findall(J, ( member(J, Js), may_fold(Flattening, J) ), Tried),
    Search = search(Flattening, Tried, Ranks, Kept, Objective),
    rounds(Tried, Search, 0, Exchanges).

%   ranks(Js, Ranks): argument J of Ranks is the place of joint J in the order.

ranks(Js, Ranks) :-
    findall(J-Rank, nth1(Rank, Js, J), Pairs0),
    keysort(Pairs0, Pairs),
    pairs_values(Pairs, Values),
    Ranks =.. [ranks|Values].

may_fold(Flattening, J) :-
    flattening_joint(Flattening, J, joint(_,_,_,_,_,_,_,Kind,State)),
    Kind \== line,
    State \== forbidden.

%   rounds(Js, Search, Exchanges0, Exchanges): the seams among Js are tried
%   round and round, as long as that helps.

rounds(Js, Search, Exchanges0, Exchanges) :-
    foldl(seam_tried(Search), Js, Exchanges0, Exchanges1),
    (   Exchanges1 > Exchanges0
    ->  rounds(Js, Search, Exchanges1, Exchanges)
    ;   Exchanges = Exchanges1
    ).

seam_tried(Search, J, Exchanges0, Exchanges) :-
    arg(1, Search, Flattening),
    folds(Flattening, Folds),
    (   memberchk(J, Folds)
    ->  Exchanges = Exchanges0
    ;   measure(Search, Folds, Before),
        seam_joined(Search, J, Folds),
        joined_again(Search),
        folds(Flattening, Folds1),
        measure(Search, Folds1, After),
        is_better(Search, After, Before)
    ->  Exchanges is Exchanges0+1
    ;   join_folds(Flattening, Folds),
        Exchanges = Exchanges0
    ).

%   seam_joined(Search, J, Folds): J is joined, and of Folds those are taken
%   back that are in its way.

seam_joined(Search, J, Folds0) :-
    Search = search(Flattening, _, Ranks, _, _),
    flattening_joint(Flattening, J, joint(_,_,P1,P2,_,_,_,_,_)),
    (   fold_way(Search, P1-P2, Way),
        Way = [_|_]
    ->  last_fold(Search, Way, Last),
        arg(J, Ranks, Rank),
        arg(Last, Ranks, LastRank),
        LastRank > Rank,
        taken_back(Flattening, Last, Folds0, Folds)
    ;   Folds = Folds0
    ),
    joined_at_last(4, Search, J, Folds).

joined_at_last(Cuts, Search, J, Folds0) :-
    arg(1, Search, Flattening),
    join_faces(Flattening, J, Result),
    (   Result == joined
    ->  true
    ;   Result = overlap(P, Q),
        Cuts > 0,
        flattening_joint(Flattening, J, joint(_,_,P1,P2,_,_,_,_,_)),
        findall(Fold,
                ( member(From, [P1,P2]),
                  member(To, [P,Q]),
                  fold_way(Search, From-To, Way),
                  member(Fold, Way) ),
                InWay),
        last_fold(Search, InWay, Last),
        taken_back(Flattening, Last, Folds0, Folds),
        Cuts1 is Cuts-1,
        joined_at_last(Cuts1, Search, J, Folds)
    ).

%   fold_way(Search, P-Q, Way): Way are the folds between P and Q.

fold_way(search(Flattening, _, _, _, _), P-Q, Way) :-
    fold_path(Flattening, P, Q, Way).

%   last_fold(Search, Folds, Last): of those that may be taken back the one that
%   comes last in the order of joints.

last_fold(search(Flattening, _, Ranks, Kept, _), Folds, Last) :-
    findall(Rank-Fold,
            ( member(Fold, Folds),
              \+ memberchk(Fold, Kept),
              flattening_joint(Flattening, Fold,
                               joint(_,_,_,_,_,_,_,bent,_)),
              arg(Fold, Ranks, Rank) ),
            Ranked),
    keysort(Ranked, Sorted),
    pairs_values(Sorted, Values),
    last(Values, Last).

taken_back(Flattening, J, Folds0, Folds) :-
    exclude(==(J), Folds0, Folds),
    join_folds(Flattening, Folds).

%   joined_again(Search): what can be joined is, in order.

joined_again(search(Flattening, Js, _, _, _)) :-
    forall(member(J, Js), join_faces(Flattening, J, _)).

%   measure(Search, Folds, Measure): what is to be less, with Folds joined.

measure(search(Flattening, _, _, _, Objective), Folds, Measure) :-
    seam_length(Flattening, Seam),
    (   Objective == pieces
    ->  length(Folds, Count),
        Fewer is -Count,
        Measure = Fewer-Seam
    ;   Measure = 0-Seam
    ).

is_better(search(Flattening, _, _, _, _), Pieces1-Seam1, Pieces0-Seam0) :-
    flattening_counts(Flattening, _, _, Step),
    (   Pieces1 < Pieces0
    ->  true
    ;   Pieces1 =:= Pieces0,
        Seam0-Seam1 > Step
    ).
