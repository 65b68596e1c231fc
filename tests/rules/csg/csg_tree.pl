:- module(sg_test_csg_tree,
          [ with_tree/2,                % +Terms, :Goal
            volume/2,                   % +S, -Volume
            near/2,                     % +X, +Y
            faults/1,                   % -N
            statistics/2,               % -Evaluated, -Reused
            helpers/1,                  % -N
            written/3                   % +Stream, +S, +Term
          ]).
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(csg/csg), [is_helper/1]).
:- use_module(rules(model/integrity), [model_defect/1, defect_weight/2]).
:- use_module(rules(kernel), [census/1]).
:- use_module(rules(model/model)).
:- use_module(rules(store)).
/** <module> CSG trees from terms, and what tests ask of them. */

:- meta_predicate with_tree(+, 0).

%!  with_tree(+Terms, :Goal) is semidet.
%
%   Goal once, in a world whose segments 1, 2, ... are Terms (or Kind-Term).

with_tree(Terms, Goal) :-
    new_world(World),
    in_world(World,
             ( tmp_file_stream(File, Stream, [extension(pl)]),
               forall(nth1(S, Terms, Term), written(Stream, S, Term)),
               close(Stream),
               call_cleanup(load_model(File), delete_file(File)),
               csg_statistics_reset,
               Goal )).

%!  written(+Stream, +S, +Term) is det.
%
%   Segment S as a fact on Stream; Term as for with_tree/2. fact(Fact) is Fact
%   itself.

written(Stream, _, fact(Fact)) :-
    !,
    format(Stream, '~q.~n', [Fact]).
written(Stream, S, Kind-Term) :-
    !,
    format(Stream, '~q.~n', [segment(S, Kind, Term)]).
written(Stream, S, Term) :-
    written(Stream, S, solid-Term).

%!  volume(+S, -Volume) is det.

volume(S, Volume) :-
    census(Parts),
    (   memberchk(part(S, _, _, _, Volume0, _, _, _), Parts)
    ->  Volume = Volume0
    ;   segment(S, _, _),               % it is empty
        Volume = 0.0
    ).

%!  near(+X, +Y) is semidet.
%
%   The same up to rounding.

near(X, Y) :-
    abs(X-Y) < 1.0e-12*max(1.0, abs(Y)).

%!  faults(-N) is det.
%
%   How many the model has.

faults(N) :-
    aggregate_all(count,
                  ( model_defect(Defect), functor(Defect, Name, _),
                    defect_weight(Name, fault) ),
                  N).

%!  statistics(-Evaluated, -Reused) is det.
%
%   How many nodes were, since this was asked.

statistics(Evaluated, Reused) :-
    csg_statistics(Dict),
    Evaluated = Dict.evaluated,
    Reused = Dict.reused,
    csg_statistics_reset.

%!  helpers(-N) is det.
%
%   How many segments are helpers of a tree.

helpers(N) :-
    aggregate_all(count, ( segment(S, _, _), is_helper(S) ), N).
