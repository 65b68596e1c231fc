:- module(sg_explain_parameter,
          [ parameter_because/2,        % +Name, -Because
            segment_because/3,          % ?S, -Statement, -Because
            sizes_because/2,            % +S, -Because
            pair_sizes/3,               % +S1, +S2, -Because
            place_because/3             % +S, +V, -Because
          ]).
:- use_module('../csg/csg_term', [is_node_term/1, node_parts/4]).
:- use_module('../formula', [formula_parameter/2, is_formula/1]).
:- use_module('../model/formula_rows',
              [default_of/2, made_from/2, placed_from/3, written_fact/2]).
:- use_module('../model/parameter_about', [about_text/3, range_of/4]).
:- use_module('../store', [formula/2, param/2, segment/3]).
:- use_module(library(apply), [foldl/4, maplist/3, maplist/4]).
:- use_module(library(lists), [append/2, append/3, member/2]).
/** <module> Explain: parameters, and the sizes that come from them.
*/

%!  parameter_because(+Name, -Because) is det.
%
%   Because is why the parameter Name has its value, and what is made from it.

parameter_because(Name, Because) :-
    value_because(Name, Value),
    range_of(Name, Least, Most, Step),
    (   [Least,Most,Step] == [none,none,none]
    ->  Range = []
    ;   Range = [because(parameter_range(Least, Most, Step), [])]
    ),
    findall(Use, use_because(Name, Use), Uses0),
    (   Uses0 == []
    ->  Uses = [because(parameter_unused, [])]
    ;   Uses = Uses0
    ),
    append([Value, Range, Uses], Because).

%   value_because(Name, Because): where its value comes from.

value_because(Name, Because) :-
    maplist(text_or_none(Name), [en,ko], Texts),
    (   Texts == [none,none]
    ->  Words = []
    ;   Words = [because(Statement, [])],
        Statement =.. [parameter_text|Texts]
    ),
    param(Name, Value),
    written_fact(param(Name, Value), param(_, Written)),
    (   default_of(Name, Default)
    ->  From = [because(parameter_set(Default), [])]
    ;   Written \== Value
    ->  parameters_of(Written, Needed),
        From = [because(parameter_formula(Written), Needed)]
    ;   From = []
    ),
    append(Words, From, Because).

text_or_none(Name, Language, Text) :-
    (   about_text(Name, Language, Text0)
    ->  Text = Text0
    ;   Text = none
    ).

%   parameters_of(Formula, Because): the parameters in it.

parameters_of(Formula, Because) :-
    findall(Name, formula_parameter(Formula, Name), Names0),
    sort(Names0, Names),
    findall(because(parameter(Name, Value), Why),
            ( member(Name, Names),
              param(Name, Value),
              value_because(Name, Why) ),
            Because).

%   use_because(Name, Use) is nondet: something made from the parameter Name.

use_because(Name, because(used_by_parameter(Other, Written), [])) :-
    param(Other, Value),
    written_fact(param(Other, Value), param(_, Written)),
    in_formula(Name, Written).
use_because(Name, because(segment(S, Kind), Uses)) :-
    segment(S, Kind, _),
    findall(because(size(Value, Written), []),
            ( segment_size(S, Value, Written), in_formula(Name, Written) ),
            Sizes),
    findall(because(vertex_place(S, V, Place), []),
            ( placed_from(S, V, Place), in_formula(Name, Place) ),
            Places),
    append(Sizes, Places, Uses),
    Uses \== [].
use_because(Name, because(used_by_row(Written), [])) :-
    formula(Row, Written),
    \+ functor(Row, segment, 1),
    \+ functor(Row, param, 1),
    \+ functor(Row, set, 1),
    \+ functor(Row, v, 2),
    in_formula(Name, Written).

in_formula(Name, Formula) :-
    once(( formula_parameter(Formula, Found), Found == Name )).

%!  segment_because(?S, -Statement, -Because) is nondet.
%
%   Because says which sizes of segment S come from parameters.

segment_because(S, segment(S, Kind), Because) :-
    segment(S, Kind, _),
    own_sizes(S, Own),
    findall(Operand,
            ( operand_of(S, S1), sizes_because(S1, Operands),
              member(Operand, Operands) ),
            Others),
    append(Own, Others, Because0),
    (   Because0 == []
    ->  Because = [because(no_size_from_parameter, [])]
    ;   Because = Because0
    ).

own_sizes(S, Because) :-
    findall(because(size(Value, Written), Parameters),
            ( segment_size(S, Value, Written),
              parameters_of(Written, Parameters) ),
            Sizes),
    findall(because(vertex_place(S, V, Place), Parameters),
            ( placed_from(S, V, Place), parameters_of(Place, Parameters) ),
            Places),
    append(Sizes, Places, Because).

operand_of(S, S1) :-
    segment(S, _, Term),
    is_node_term(Term),
    node_parts(Term, _, Operands, _),
    member(Operand, Operands),
    operand_segment(Operand, S1).

operand_segment(S, S) :-
    integer(S),
    !.
operand_segment(at(_, Operand), S) :-
    operand_segment(Operand, S).

%!  sizes_because(+S, -Because) is det.
%
%   Because are the segment S and its operands, in as far as their sizes come
%   from parameters.

sizes_because(S, Because) :-
    (   formula(_, _),
        segment_because(S, Statement, Why),
        Why \= [because(no_size_from_parameter, _)]
    ->  Because = [because(Statement, Why)]
    ;   Because = []
    ).

%!  pair_sizes(+S1, +S2, -Because) is det.
%
%   Because is what sizes_because/2 says of each of the two segments, which may
%   be one.

pair_sizes(S, S, Because) :-
    !,
    sizes_because(S, Because).
pair_sizes(S1, S2, Because) :-
    sizes_because(S1, Because1),
    sizes_because(S2, Because2),
    append(Because1, Because2, Because).

%!  place_because(+S, +V, -Because) is det.
%
%   Because is the place of vertex V of segment S as formulas, or else what
%   sizes of S come from parameters.

place_because(S, V, Because) :-
    (   placed_from(S, V, Place)
    ->  parameters_of(Place, Parameters),
        Because = [because(vertex_place(S, V, Place), Parameters)]
    ;   sizes_because(S, Because)
    ).

%   segment_size(S, Value, Written) is nondet: a part Value of the term of S,
%   such as radius(57.15), comes from Written, such as radius(param(d)/2).

segment_size(S, Value, Written) :-
    made_from(S, Written0),
    segment(S, _, Term),
    sizes(Written0, Term, [], Sizes),
    member(size(Value, Written), Sizes).

sizes(Written, Term, Sizes0, Sizes) :-
    (   Written == Term
    ->  Sizes = Sizes0
    ;   compound(Written),
        compound(Term),
        compound_name_arguments(Written, Name, As),
        compound_name_arguments(Term, Name, Bs),
        maplist(pair, As, Bs, Pairs)
    ->  (   Written \= [_|_],
            member(Argument, As),
            holds_formula(Argument)
        ->  append(Sizes0, [size(Term, Written)], Sizes)
        ;   foldl(sizes_of_pair, Pairs, Sizes0, Sizes)
        )
    ;   Sizes = Sizes0
    ).

pair(A, B, A-B).

sizes_of_pair(Written-Term, Sizes0, Sizes) :-
    sizes(Written, Term, Sizes0, Sizes).

%   holds_formula(Argument): it is a formula, or a list with one in it.

holds_formula(Argument) :-
    (   Argument = [_|_]
    ->  member(Item, Argument),
        holds_formula(Item)
    ;   is_formula(Argument)
    ),
    !.
