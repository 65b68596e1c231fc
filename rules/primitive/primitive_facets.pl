:- module(sg_primitive_facets,
          [ finer_primitive/3           % +Term0, +Turn, -Term
          ]).
:- use_module(library(apply), [exclude/3]).
:- use_module(library(lists), [selectchk/3]).
/** <module> A primitive with more facets.
*/

%   Facets to a full turn: at a radius of 1,000 dots a chord of it is an eighth
%   of a dot from its arc.

fine_facets(192).

%!  finer_primitive(+Term0, +Turn, -Term) is semidet.
%
%   Term is the primitive Term0, whose widest facets are Turn degrees wide, with
%   more of them, so many times as many that it is fine enough for a picture.
%   Fails if it is, or if it is not divided by facets(N).

finer_primitive(at(Steps,Term0), Turn, at(Steps,Term)) :-
    !,
    finer_primitive(Term0, Turn, Term).
finer_primitive(named(Name,Term0), Turn, named(Name,Term)) :-
    !,
    finer_primitive(Term0, Turn, Term).
finer_primitive(Term0, Turn, Term) :-
    fine_facets(Fine),
    Times is ceiling(Turn*Fine/360),
    Times > 1,
    compound_name_arguments(Term0, Name, Arguments0),
    (   selectchk(facets(N0), Arguments0, Arguments1)
    ->  true
    ;   exclude(is_tolerance, Arguments0, Arguments1),
        (   memberchk(angle(Degrees), Arguments0),
            Name == turning
        ->  true
        ;   Degrees = 360
        ),
        N0 is max(1, round(Degrees/Turn))
    ),
    N is N0*Times,
    Term =.. [Name,facets(N)|Arguments1].

is_tolerance(tolerance(_)).
