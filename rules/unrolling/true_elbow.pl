:- module(sg_true_elbow,
          [ throat_and_heel/3           % +D, -Throat, -Heel
          ]).
:- use_module('../csg/placed_surface', [placed_term/2]).
:- use_module('../near', [is_on_surface/2, same_direction/2]).
:- use_module('../primitive/primitive_pipe', [is_mitred/1]).
:- use_module('../solid/trimmed', [part_named/2, part_named/4]).
:- use_module('../store', [origin/3, segment/3]).
:- use_module(true_leaf, [composed_leaves/2]).
:- use_module(true_plate, [part_role/4]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [last/2, member/2, selectchk/3]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Where the pattern of a piece has its throat and its heel.

A round pipe that ends in planes has generators as long as a + b cos(t - t0):
the shortest is its throat, the longest, opposite to it, its heel. So it is for
the pieces of a primitive, and for pipes that planes split; what the planes are
is not asked. A pipe that ends on a saddle has no such generators.
*/

%!  throat_and_heel(+D, -Throat, -Heel) is semidet.
%
%   Throat and Heel are the degrees of the shortest and of the longest generator
%   of the pattern D of a pipe that ends in planes, one of them at least a mitre
%   with another pipe of its radius. Fails if none of its generators is there.

throat_and_heel(D, Throat, Heel) :-
    segment(D, pattern, true_development(S, Name)),
    in_mitre(S, Name),
    generator_lengths(D, Pairs),
    keysort(Pairs, Sorted),
    Sorted = [Short-Throat|_],
    last(Sorted, Long-_),
    \+ is_on_surface(Long-Short, Long),
    Half is (Long-Short)/2.0,
    Middle is (Long+Short)/2.0,
    forall(member(Length-Degrees, Pairs),
           ( Off is Length - Middle + Half*cos((Degrees-Throat)*pi/180.0),
             is_on_surface(Off, Long) )),
    Opposite is Throat+180.0,
    once(( member(_-Heel, Sorted), same_direction(Heel, Opposite) )).

%   in_mitre(T, Name): the surface Name of T is of a pipe that meets another one
%   of its radius, or of a primitive of several pieces. What T was made of, as
%   the user knows it, says so.

in_mitre(T, Name) :-
    part_named(T, Name, S, Part),
    (   Part = piece(_),
        placed_term(S, Term),
        is_mitred(Term)
    ->  true
    ;   segment(T, _, trimmed(_, _, Others0)),
        maplist(part_named, Others0, Others),
        part_role([], S, Others, mitre)
    ->  true
    ;   Part = Leaf/_,
        composed_leaves(S, Leaves),
        selectchk(Leaf, Leaves, Others),
        part_role([], Leaf, Others, mitre)
    ).

%   generator_lengths(D, Pairs): Length-Degrees for each generator, as long as
%   from its first end to its last, whatever holes interrupt it.

generator_lengths(D, Pairs) :-
    findall(Number-ends(From,To,Degrees),
            origin(D, e(_), generator(Number,Degrees,_,From,To)), Ends0),
    keysort(Ends0, Ends),
    group_pairs_by_key(Ends, Groups),
    findall(Length-Degrees,
            ( member(_-Own, Groups),
              Own = [ends(_,_,Degrees)|_],
              aggregate_all(max(To), member(ends(_,To,_), Own), High),
              aggregate_all(min(From), member(ends(From,_,_), Own), Low),
              Length is High-Low ),
            Pairs),
    Pairs = [_,_,_|_].
