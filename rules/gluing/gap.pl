:- module(sg_gap,
          [ near_misses/3,              % +Pairs, +Reach, -Misses
            gap_reach/2                 % +S, -Reach
          ]).
:- use_module('../csg/csg_rows', [segment_box/2]).
:- use_module('../kernel', [segment_gaps/3]).
:- use_module('../near', [tolerance/2]).
:- use_module(library(apply), [include/3]).
/** <module> How far apart segments are that were not glued.

What is farther apart than the tolerance is not made to touch. Here is how far
it is, and where, so that a person can say whether that was meant.
*/

%!  gap_reach(+S, -Reach) is semidet.
%
%   Gaps up to Reach may not be meant in segment S.

gap_reach(S, Reach) :-
    segment_box(S, box(X1,Y1,Z1,X2,Y2,Z2)),
    tolerance(gap, Of),
    Reach is Of*max(X2-X1, max(Y2-Y1, Z2-Z1)).

%!  near_misses(+Pairs:list, +Reach, -Misses:list) is det.
%
%   Misses are miss(S1-Of1, S2-Of2, Gap, End1-End2) of the segments S1-S2 of
%   Pairs that come within Reach: Of is the polygon, of a curve the edge. In the
%   order of Pairs; those 0 apart are none.

near_misses(Pairs, Reach, Misses) :-
    segment_gaps(Pairs, Reach, Gaps),
    include(is_apart, Gaps, Misses).

is_apart(miss(_,_,Gap,_)) :-
    Gap > 0.
