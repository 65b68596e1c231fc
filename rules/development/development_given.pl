:- module(sg_development_given,
          [ given_development/3,        % +D, -S, -Options
            given_measures/3            % +D, -Measures, -Bound
          ]).
:- use_module(laid_joint, [joint_edges/4, joint_length/3]).
:- use_module('../near', [is_rounding/2]).
:- use_module('../kernel',
              [ flattening_bound/2, flattening_close/1, flattening_counts/4,
                flattening_lay/2, flattening_measures/2, flattening_open/4,
                join_faces/3, join_folds/2, segments_tolerance/3
              ]).
:- use_module(part_edges, [edge_length/3]).
:- use_module('../store', [p/3, joint/6, segment/3, from_p/5]).
:- use_module(library(aggregate), [aggregate_all/3]).
/** <module> Patterns that nothing is remembered of: as their rows are.

A pattern that was read from a file says which joints are folds, and that is all
one needs: they are joined again, and what stands against any other joint, or
how long the seam is, can be asked then. The segment has to be there as well,
and to be what the pattern was made from: the same joints, between edges as long
as those of the pattern. A pattern whose bends have taken off something is not.
*/

:- meta_predicate with_folds(+, -, -, 1).

%!  given_development(+D, -S, -Options:list) is semidet.
%
%   Pattern D is one of segment S as it is now. Options of develop/3 that are
%   wanted of it, as far as one can tell: removed(Ps), and cut(Es), edges that
%   could have been joined.

given_development(D, S, [removed(Ps),cut(Es)]) :-
    with_folds(D, S, Ps, cut_here(D, Es)).

%!  given_measures(+D, -Measures, -Bound) is semidet.
%
%   Measures are those of flattening_measures/2 of pattern D, Bound that of
%   flattening_bound/2. Tests of overlap there were none.

given_measures(D, Measures, Bound) :-
    with_folds(D, _, _, measured(Measures, Bound)).

measured(Measures, Bound, Flattening) :-
    flattening_lay(Flattening, 0),
    flattening_measures(Flattening, Measures),
    flattening_bound(Flattening, Bound).

%   with_folds(D, S, Ps, Goal): Goal holds of a flattening of S without the
%   polygons Ps, in which just the folds of D are joined.

with_folds(D, S, Ps, Goal) :-
    segment(D, pattern, development(S)),
    once(p(S, _, _)),
    findall(P, ( p(S, P, _), \+ p(D, P, _), \+ from_p(D, _, _, P, _) ), Ps),
    segments_tolerance([S], Tolerance, _),
    flattening_open(S, Tolerance, Ps, Flattening),
    call_cleanup(( is_of(D, Flattening),
                   folds_joined(D, Flattening),
                   once(call(Goal, Flattening))
                 ),
                 flattening_close(Flattening)).

folds_joined(D, Flattening) :-
    findall(J, joint(D, J, _, _, fold, _), Folds),
    join_folds(Flattening, Folds).

%   is_of(D, Flattening): the joints are those of D.

is_of(D, Flattening) :-
    flattening_counts(Flattening, _, Count, _),
    aggregate_all(count, joint(D, _, _, _, _, _), Count),
    forall(joint(D, J, E1, E2, _, _),
           ( joint_edges(Flattening, J, E1, E2),
             joint_length(Flattening, J, Length),
             edge_length(D, E1, Length1),
             is_rounding(Length1-Length, max(Length, Length1)) )).

%   cut_here(D, Es, Flattening): Es are edges of D that are seams, and could be
%   joined all the same.

cut_here(D, Es, Flattening) :-
    findall(E,
            ( joint(D, J, E, _, seam, _),
              join_faces(Flattening, J, joined),
              folds_joined(D, Flattening) ),
            Es).
