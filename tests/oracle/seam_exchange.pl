:- module(sg_oracle_seam_exchange,
          [ exchanged_by_rule/5     % +Flattening, +Order, +Kept, +Objective,
                                    % -Exchanges
          ]).
:- use_module('../../rules/development/development_search', [folds/2]).
:- use_module('../../rules/kernel',
              [ flattening_counts/4, flattening_joint/3, join_faces/3,
                join_folds/2, joint_order/3, fold_path/4, seam_length/2
              ]).
:- use_module(library(apply), [exclude/3, foldl/4]).
:- use_module(library(lists), [last/2, member/2, nth1/3]).
:- use_module(library(pairs), [pairs_values/2]).
/** <module> The rule of the search for a shorter seam
(rules/development/development_search.pl), turn by turn.
*/

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
