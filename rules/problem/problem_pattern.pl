:- module(sg_problem_pattern,
          [ with_patterns/4             % +S, +Own, -Ds, :Goal
          ]).
:- use_module('../store', [facts_snapshot/1]).
:- use_module('../unfolding/unfold',
              [other_parts/3, wanted_of/3, wishes/3]).
:- use_module('../unfolding/unfold_how', [how_wished/3]).
:- use_module('../unfolding/unfold_true', [true_patterns/4]).
:- use_module(library(lists), [append/3]).
/** <module> The patterns that a problem asks for: trimmed, and truly unrolled.
*/

:- meta_predicate with_patterns(+, +, -, 0).

%!  with_patterns(+S, +Own:list, -Ds, :Goal) is semidet.
%
%   Call Goal once, while Ds are the patterns of segment S, trimmed by the
%   others: true_patterns/4, with the options Own. The world stays as it is.
%
%   @error as true_patterns/4

with_patterns(S, Own, Ds, Goal) :-
    facts_snapshot(sg_problem_pattern:made(S, Own, Ds, Goal)).

made(S, Own, Ds, Goal) :-
    other_parts(S, [], Others),
    (   Others == []
    ->  Trim = []
    ;   Trim = [trim(outside),by(Others)]
    ),
    append(Own, Trim, Wanted0),
    how_wished(S, Wanted0, Options),
    wishes(S, Options, Wishes),
    wanted_of(S, Wishes, Wanted),
    true_patterns(S, Wanted, Options, Ds),
    once(Goal).
