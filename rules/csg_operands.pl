:- module(sg_csg_operands,
          [ check_operands/1            % +Leaves
          ]).
:- use_module(csg_term, [csg_error/1]).
:- use_module(kernel, [census/1, model_tolerance/1]).
:- autoload(library(lists), [member/2]).
/** <module> Which segments a Boolean operation takes: solids with a volume.
*/

%!  check_operands(+Leaves) is det.
%
%   Leaves are the segments of an expression, ascending.
%
%   @error model_error(csg(no_volume(S))): the solid is thinner, on the mean,
%   than the tolerance of the model

check_operands(Leaves) :-
    census(Parts),
    model_tolerance(Tolerance),
    forall(( member(S, Leaves),
             memberchk(part(S, _, _, Area, Volume, _, _, _), Parts) ),
           (   abs(Volume) > Tolerance*Area
           ->  true
           ;   csg_error(no_volume(S))
           )).
