:- module(sg_unfold_whole,
          [ pattern_whole/1             % +D
          ]).
:- use_module('../development/bend', [named_segment/2]).
:- use_module('../polygon/polygon_whole', [crosses_itself/2]).
:- use_module('../store', [from_p/5, p/3]).
:- use_module(unfold, [pattern_of/2]).
/** <module> A pattern with each of its faces.

A polygon that crosses itself has no triangles, so nothing is drawn of it. Who
cuts the pattern out would find a hole in the model: there is no such pattern.
*/

%!  pattern_whole(+D) is det.
%
%   Each polygon of pattern D, and each that it was made of, has its triangles,
%   or its corners are on a straight line, so that there is nothing to cut out.
%
%   @error geometry_error(unfold(crosses_itself(S, P))): polygon P of segment S,
%          as the model has them, has none; outline_unrolled(S, P): it has, but
%          not where it is laid

pattern_whole(D) :-
    pattern_of(D, T),
    (   p(D, P, _),
        laid_from(D, P, T, P1),
        (   crosses_itself(T, P1)
        ->  Name = crosses_itself
        ;   crosses_itself(D, P),
            Name = outline_unrolled
        )
    ->  named_segment(D, S),
        (   from_p(T, P1, _, P0, _)
        ->  true
        ;   P0 = P1
        ),
        What =.. [Name,S,P0],
        throw(error(geometry_error(unfold(What)), _))
    ;   true
    ).

laid_from(D, P, T, P1) :-
    (   from_p(D, P, T, P1, _)
    ->  true
    ;   P1 = P
    ).
