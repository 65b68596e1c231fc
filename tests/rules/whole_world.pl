:- module(sg_test_whole_world,
          [ dangling/2                  % -Row, -Missing
          ]).
/** <module> What is not there in a world, found without the store's own check.
*/

:- use_module(library(lists)).
:- use_module(rules(store)).

%!  dangling(-Row, -Missing) is nondet.
%
%   True when Row refers to the row Missing, Relation(S, Id), that is not there,
%   by the columns of relation_column/5.

dangling(Row, Missing) :-
    relation_column(Name, Position, _, _, Refers),
    Refers \== none,
    relation(Name, Arity, _),
    functor(Row, Name, Arity),
    segment_of(Name, Position, Of),
    Argument is Position+1,
    call(Row),
    arg(Of, Row, S),
    arg(Argument, Row, Value),
    (   is_list(Value)
    ->  member(Id, Value)
    ;   Id = Value
    ),
    meant(Name, Refers, Id, Relation, Wanted),
    \+ is_there(Relation, S, Wanted),
    Missing =.. [Relation,S,Wanted].

%   A drawn part of a piece of an outline names it by a negative number.

meant(drawn, e, Id, contour, K) :-
    Id < 0,
    !,
    K is -Id.
meant(_, Relation, Id, Relation, Id).

segment_of(Name, Position, Argument) :-
    (   relation_column(Name, Position, Column, _, _),
        sub_atom(Column, 0, _, _, 'S')
    ->  Argument is Position+1
    ;   Before is Position-1,
        segment_of(Name, Before, Argument)
    ).

is_there(v, S, V) :- v(S, V, _, _, _), !.
is_there(e, S, E) :- e(S, E, _, _, _), !.
is_there(p, S, P) :- p(S, P, _), !.
is_there(t, S, T) :- t(S, _, T, _, _, _), !.
is_there(region, S, R) :- region(S, R, _), !.
is_there(leaf_e, S, E) :- leaf_e(S, E, _, _, _), !.
is_there(contour, S, K) :- contour(S, K, _, _, _, _, _, _, _, _, _, _, _), !.
