:- module(sg_stage,
          [ stage/2,                    % +Name, :Goal
            stages_reset/0,
            stage_name/1,               % ?Name
            stage_seconds/2,            % ?Name, -Seconds
            current_stage/1             % -Name
          ]).
/** <module> Stages: where the time of an operation goes.

Goals are wrapped as `stage(join, Goal)`. Stages nest, and the time of an
inner stage does not count for the outer one: with the calls of kernels
wrapped, `stage(rules, Goal)` measures the rules alone. stage_name/1 has the
names. --timings prints the sums. Everything is per thread.
*/

:- meta_predicate stage(+, 0).

%!  stage(+Name, :Goal) is semidet.
%
%   Call Goal once; the time it takes, less that of stages inside it, is added
%   to stage Name, also if Goal fails or raises.

stage(Name, Goal) :-
    clock(T0),
    b_or_nothing(sg_stage_open, Open),
    setup_call_cleanup(
        b_setval(sg_stage_open, [Name|Open]),
        ( nb_or_zero(sg_stage_inner, Outer),
          nb_setval(sg_stage_inner, 0.0),
          once(Goal)
        ),
        stage_closed(Name, T0, Outer)),
    b_setval(sg_stage_open, Open).

stage_closed(Name, T0, Outer0) :-
    (   var(Outer0)
    ->  Outer = 0.0
    ;   Outer = Outer0
    ),
    clock(T1),
    Whole is T1-T0,
    nb_or_zero(sg_stage_inner, Inner),
    atom_concat('sg_stage ', Name, Key),
    nb_or_zero(Key, Sum0),
    Sum is Sum0 + Whole - Inner,
    nb_setval(Key, Sum),
    AllInner is Outer + Whole,
    nb_setval(sg_stage_inner, AllInner).

clock(T) :-
    get_time(T).

nb_or_zero(Key, Value) :-
    (   nb_current(Key, Value0)
    ->  Value = Value0
    ;   Value = 0.0
    ).

b_or_nothing(Key, Value) :-
    (   nb_current(Key, Value0)
    ->  Value = Value0
    ;   Value = []
    ).

%!  stages_reset is det.
%
%   Set the time of every stage to zero.

stages_reset :-
    forall(( nb_current(Key, _), atom_concat('sg_stage ', _, Key) ),
           nb_setval(Key, 0.0)),
    nb_setval(sg_stage_inner, 0.0).

%!  stage_name(?Name) is nondet.
%
%   The names of stages, in the order in which --timings prints them.

stage_name(load).
stage_name(tree).                       % search structures
stage_name(complete).                   % planes, triangles of new polygons
stage_name(operands).                   % whether they bound volumes
stage_name(self).                       % operands that go through themselves
stage_name(resolve).                    % contacts
stage_name(join).                       % kernels that walk relations
stage_name(chain).                      % lines in order
stage_name(rules).
stage_name(enter).                      % lines into polygons
stage_name(pieces).                     % which parts of faces stay
stage_name(faces).                      % merged
stage_name(regions).                    % of space
stage_name(develop).
stage_name(shade).
stage_name(write).

%!  stage_seconds(?Name, -Seconds) is nondet.
%
%   True when stage Name took Seconds since the last stages_reset/0.

stage_seconds(Name, Seconds) :-
    (   nonvar(Name)
    ->  atom_concat('sg_stage ', Name, Key),
        nb_current(Key, Seconds)
    ;   nb_current(Key, Seconds),
        atom_concat('sg_stage ', Name, Key)
    ).

%!  current_stage(-Name) is semidet.
%
%   The innermost stage that is open in this thread.

current_stage(Name) :-
    b_or_nothing(sg_stage_open, [Name|_]).
