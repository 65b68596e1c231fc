:- module(sg_formula_term,
          [ formed_term/3,              % +Term0, :Known, -Term
            formed_wish/3,              % +Wish0, :Known, -Wish
            operand_formulas/4          % +Written, +Term, -Own, -Operands
          ]).
:- use_module('../csg/csg_term',
              [is_node_term/1, map_operands/3, node_parts/4]).
:- use_module('../formula',
              [ formed/3, formula_parameter/2, has_formula/1, is_formula/1 ]).
:- use_module('../primitive/primitive', [is_primitive/1]).
/** <module> Formulas in the terms of segments, primitives and trees, and in
wishes.

Numbers stand in the arguments of primitives, in the steps of at/2 and in the
planes of split/3. Names, and the terms of segments that are neither, stay as
they are: `bolt-8` is a name. Where a wish of unfolding/2 names polygons and
edges, `A-B` is a pair, as always, and no difference.
*/

:- meta_predicate
    formed_term(+, 2, -),
    formed_wish(+, 2, -).

%!  formed_term(+Term0, :Known, -Term) is det.
%
%   Term is the term Term0 of a segment with the values of its formulas in their
%   places; Known as in formula_value/3.
%
%   @error as formula_value/3

formed_term(named(Name, Inner0), Known, Term) :-
    !,
    Term = named(Name, Inner),
    formed_term(Inner0, Known, Inner).
formed_term(at(Steps0, Inner0), Known, Term) :-
    !,
    Term = at(Steps, Inner),
    formed(Steps0, Known, Steps),
    formed_term(Inner0, Known, Inner).
formed_term(split(Operand0, By0, Side), Known, Term) :-
    !,
    Term = split(Operand, By, Side),
    formed_term(Operand0, Known, Operand),
    (   By0 = plane(_, _, _, _)
    ->  formed(By0, Known, By)
    ;   formed_term(By0, Known, By)
    ).
formed_term(Term0, Known, Term) :-
    is_node_term(Term0),
    !,
    compound_name_arguments(Term0, Name, [Operands0]),
    (   is_list(Operands0)
    ->  formed_operands(Operands0, Known, Operands)
    ;   Operands = Operands0
    ),
    compound_name_arguments(Term, Name, [Operands]).
formed_term(Term0, Known, Term) :-
    is_primitive(Term0),
    !,
    formed(Term0, Known, Term).
formed_term(Term, _, Term).

:- meta_predicate formed_operands(+, 2, -).

formed_operands([], _, []).
formed_operands([Term0|Terms0], Known, [Term|Terms]) :-
    formed_term(Term0, Known, Term),
    formed_operands(Terms0, Known, Terms).

%!  formed_wish(+Wish0, :Known, -Wish) is det.
%
%   The same of a wish.

formed_wish(Wish0, Known, Wish) :-
    (   compound(Wish0),
        compound_name_arguments(Wish0, Name, Arguments0),
        memberchk(Name, [root,cut,keep,order,removed])
    ->  formed_places(Arguments0, Known, Arguments),
        compound_name_arguments(Wish, Name, Arguments)
    ;   formed(Wish0, Known, Wish)
    ).

:- meta_predicate
    formed_place(+, 2, -),
    formed_places(+, 2, -).

%   formed_place(Place0, Known, Place): polygons and edges, by number or name.

formed_place(A0-B0, Known, Place) :-
    !,
    Place = A-B,
    formed_place(A0, Known, A),
    formed_place(B0, Known, B).
formed_place(Place0, Known, Place) :-
    (   \+ formula_parameter(Place0, _)
    ->  Place = Place0
    ;   is_formula(Place0)
    ->  formed(Place0, Known, Place)
    ;   compound_name_arguments(Place0, Name, Arguments0),
        formed_places(Arguments0, Known, Arguments),
        compound_name_arguments(Place, Name, Arguments)
    ).

formed_places([], _, []).
formed_places([Place0|Places0], Known, [Place|Places]) :-
    formed_place(Place0, Known, Place),
    formed_places(Places0, Known, Places).

%!  operand_formulas(+Written, +Term, -Own, -Operands) is det.
%
%   Written is a node with formulas, Term the same node after its operands got
%   numbers. Own is Written with these numbers, and Operands has S-Operand for
%   every operand that has formulas and is segment S now.

operand_formulas(Written, Term, Own, Operands) :-
    node_parts(Written, _, Operands0, _),
    node_parts(Term, _, Numbers, _),
    with_formulas(Operands0, Numbers, Operands),
    numbered(Written, Term, Own).

with_formulas([Operand|Operands0], [S|Numbers], Operands) :-
    !,
    (   integer(S),
        has_formula(Operand)
    ->  Operands = [S-Operand|Operands1]
    ;   Operands = Operands1
    ),
    with_formulas(Operands0, Numbers, Operands1).
with_formulas(_, _, []).

%   numbered(Written, Term, Own): steps and planes of Written, operands of Term.

numbered(Written, Term, Own) :-
    node_parts(Term, _, Numbers, _),
    Left = left(Numbers),
    map_operands(next_number(Left), Written, Own).

next_number(Left, _, S) :-
    arg(1, Left, [S|Numbers]),
    nb_setarg(1, Left, Numbers).
