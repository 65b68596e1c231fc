/* The tolerance of our side of the peers' programs. Not a program. */
:- module(bench_tolerance, [tolerance_options/1]).

%!  tolerance_options(-Options:list) is det.
%
%   From the environment's TOLERANCE, if it is set: 0 is what the peers do, who
%   make nothing touch.

tolerance_options(Options) :-
    (   getenv('TOLERANCE', Text)
    ->  atom_number(Text, Tolerance),
        Options = [tolerance(Tolerance)]
    ;   Options = []
    ).
