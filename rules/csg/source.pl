:- module(sg_source,
          [ source_noted/2,             % +S, +Grain
            source_kept/3               % +Sources, +Scale, +S
          ]).
:- use_module('../kernel', [segment_grain/2]).
:- use_module('../store', [assert_fact/1, retractall_facts/1]).
/** <module> How fine the numbers of a segment are: what is known of its source.

origin(S, s(S), source(Grain)) says what a unit is in the last place of the
coordinates of segment S, in model units. Without it they are doubles. A file
that is read says it, and what is made of segments keeps it: the tolerance of
an operation follows from where its numbers come from (c_kernels/polygon/
flatness.h), never from what they are.

@see docs/precision.md
*/

%!  source_noted(+S, +Grain) is det.
%
%   Grain is that of segment S from now on; 0: doubles.

source_noted(S, Grain) :-
    segment_grain(S, Grain0),
    (   Grain0 =:= Grain
    ->  true
    ;   retractall_facts(origin(S, s(S), _)),
        (   Grain > 0
        ->  Float is float(Grain),
            assert_fact(origin(S, s(S), source(Float)))
        ;   true
        )
    ).

%!  source_kept(+Sources:list, +Scale, +S) is det.
%
%   Segment S was made of the segments Sources, what is 1 long in them being at
%   most Scale long in S: it is as coarse as the coarsest of them.

source_kept(Sources, Scale, S) :-
    coarsest(Sources, 0.0, Grain0),
    Grain is Grain0*Scale,
    source_noted(S, Grain).

coarsest([], Grain, Grain).
coarsest([S|Ss], Grain0, Grain) :-
    segment_grain(S, Grain1),
    Grain2 is max(Grain0, Grain1),
    coarsest(Ss, Grain2, Grain).
