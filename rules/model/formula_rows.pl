:- module(sg_formula_rows,
          [ parameters_added/3,         % +Parameters, +File, -Renamed
            default_kept/2,             % +Name, +Written
            default_of/2,               % ?Name, -Written
            formula_kept/2,             % +Row, +Written
            written_fact/2,             % +Fact, -Written
            made_by_formula/1,          % +S
            made_from/2,                % ?S, -Written
            placed_from/3,              % ?S, ?V, -Place
            placed_by_formula/1         % +S
          ]).
:- use_module(formula_term, [formed_term/3, formed_wish/3, operand_formulas/4]).
:- use_module(model_text, [model_float/2, world_parameter/2]).
:- use_module('../csg/csg_term', [is_node_term/1]).
:- use_module('../formula', [formed/3, has_formula/1, renamed_parameters/3]).
:- use_module('../store',
              [ v/5, e/5, p/3, leaf_v/5, leaf_e/5, leaf_p/3, origin/3, param/2,
                formula/2, segment/3, assert_fact/1, retractall_facts/1
              ]).
:- use_module('../polygon/polygon_list', [vertex_list_edges/2]).
:- use_module('../primitive/primitive', [primitive_shape/4]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/2, append/3, member/2, numlist/3]).
:- use_module(library(pairs), [pairs_values/2]).
/** <module> Parameters in the world, and what was made from them.

`param(Name, Value)` has the parameters, formula(Row, Fact) the facts as their
file has them:

    formula(param(Name), param(Name, Formula))
    formula(segment(S), segment(S, Kind, Term))
    formula(v(S, V), v(S, V, X, Y, Z))
    formula(title_block(Item), title_block(Item, Formula))
    formula(Row, Fact)                      of any other Row
    formula(set(Name), param(Name, Default))    of a parameter that was set

A formula holds as long as its values are what is in the row, and as long as
nothing was done to the segment: what was cut, or changed in another way, is no
longer made from parameters, and is written as it is.
*/

%!  parameters_added(+Parameters, +File, -Renamed) is det.
%
%   Parameters, as file_parameters/3 gives them for File, are in the world.
%   Renamed has Old-New of those whose names were taken by other ones; those
%   that are written alike, and have the same value, are one.

parameters_added(Parameters, File, Renamed) :-
    added(Parameters, Parameters, File, [], Renamed).

added([], _, _, Renamed, Renamed).
added([parameter(Name, Written0, Value)|Rest], All, File, Renamed0, Renamed) :-
    renamed_parameters(Renamed0, Written0, Written),
    (   \+ param(Name, _)
    ->  parameter_row(Name, Written, Value),
        Renamed1 = Renamed0
    ;   param(Name, Value),
        parameter_written(Name, Written)
    ->  Renamed1 = Renamed0
    ;   free_name(Name, All, New),
        parameter_row(New, Written, Value),
        print_message(informational,
                      sanggwan(parameter(renamed(File, Name, New)))),
        Renamed1 = [Name-New|Renamed0]
    ),
    added(Rest, All, File, Renamed1, Renamed).

parameter_row(Name, Written, Value) :-
    assert_fact(param(Name, Value)),
    (   has_formula(Written)
    ->  assert_fact(formula(param(Name), param(Name, Written)))
    ;   true
    ).

parameter_written(Name, Written) :-
    (   formula(param(Name), param(Name, Written0))
    ->  Written == Written0
    ;   \+ has_formula(Written)
    ).

%!  default_kept(+Name, +Written) is det.
%
%   The world remembers that the parameter Name was set; Written, a number or a
%   formula, is what its file has.

default_kept(Name, Written) :-
    (   default_of(Name, _)
    ->  true
    ;   assert_fact(formula(set(Name), param(Name, Written)))
    ).

%!  default_of(?Name, -Written) is nondet.
%
%   The parameter Name was set; its file has Written.

default_of(Name, Written) :-
    formula(set(Name), param(_, Written)).

free_name(Name, All, New) :-
    between(2, inf, N),
    atomic_list_concat([Name, N], '_', New),
    \+ param(New, _),
    \+ memberchk(parameter(New, _, _), All),
    !.


                /*******************************
                *           FORMULAS           *
                *******************************/

%!  formula_kept(+Row, +Written) is det.
%
%   The world remembers that Row was made from the fact Written, with the
%   segment and line numbers of the world. Of a node whose operands got numbers
%   each has its own formulas.

formula_kept(segment(S, Kind, Term), segment(_, _, Written)) :-
    !,
    (   is_node_term(Term)
    ->  operand_formulas(Written, Term, Own, Operands),
        forall(member(S1-Operand, Operands), operand_kept(S1, Operand))
    ;   Own = Written
    ),
    (   formed_term(Own, world_parameter, Formed),
        Formed \== Own
    ->  formula_added(segment(S), segment(S, Kind, Own))
    ;   true
    ).
formula_kept(Row, Written) :-
    row_name(Row, Name),
    formula_added(Name, Written).

formula_added(Name, Written) :-
    retractall_facts(formula(Name, _)),
    assert_fact(formula(Name, Written)).

operand_kept(S, Written) :-
    segment(S, Kind, Term),
    formula_kept(segment(S, Kind, Term), segment(S, Kind, Written)).

row_name(v(S, V, _, _, _), v(S, V)) :-
    !.
row_name(title_block(Item, _), title_block(Item)) :-
    !.
row_name(Row, Row).

%!  written_fact(+Fact, -Written) is det.
%
%   Written is Fact, a row of the world, as its file had it, if it still is what
%   its formulas say; else Fact.

written_fact(Fact, Written) :-
    (   fact_formula(Fact, Written0)
    ->  Written = Written0
    ;   Written = Fact
    ).

fact_formula(segment(S, Kind, Term), segment(S, Kind, Written)) :-
    !,
    formula(segment(S), segment(_, _, Written)),
    term_holds(Written, Term),
    (   is_node_term(Term)
    ->  true
    ;   as_made(S, Kind, Term)
    ).
fact_formula(param(Name, Value), param(Name, Written)) :-
    !,
    formula(param(Name), param(_, Written)),
    holds(Written, Value).
fact_formula(Row, Written) :-
    row_name(Row, Name),
    formula(Name, Written),
    (   Row = v(S, _, _, _, _)
    ->  untouched(S)
    ;   true
    ),
    compound_name_arguments(Row, _, Values),
    compound_name_arguments(Written, _, Arguments),
    maplist(argument_holds, Arguments, Values).

argument_holds(Argument, Value) :-
    (   Argument == Value
    ->  true
    ;   float(Value)
    ->  holds(Argument, Number),
        model_float(Number, Value)
    ;   catch(formed_wish(Argument, world_parameter, Value0),
              error(model_error(_), _), fail),
        Value0 == Value
    ).

term_holds(Written, Term) :-
    catch(formed_term(Written, world_parameter, Term0),
          error(model_error(_), _), fail),
    Term0 == Term.

%   holds(Written, Term): Term is Written with the parameters of the world.

holds(Written, Term) :-
    catch(formed(Written, world_parameter, Term0), error(model_error(_), _),
          fail),
    Term = Term0.

%!  made_by_formula(+S) is semidet.
%
%   True when segment S is a primitive with formulas, just as it was made.

made_by_formula(S) :-
    formula(segment(S), segment(_, _, Written)),
    segment(S, Kind, Term),
    \+ is_node_term(Term),
    term_holds(Written, Term),
    as_made(S, Kind, Term).

%!  made_from(?S, -Written) is nondet.
%
%   The term of segment S, whatever was done to it since, comes from the
%   formulas in Written.

made_from(S, Written) :-
    formula(segment(S), segment(_, _, Written)),
    segment(S, _, Term),
    term_holds(Written, Term).

%!  placed_from(?S, ?V, -Place) is nondet.
%
%   Vertex V of segment S is, or was before it was cut, at the formulas
%   Place, (X,Y,Z).

placed_from(S, V, (X,Y,Z)) :-
    formula(v(S, V), v(_, _, X, Y, Z)),
    (   leaf_v(S, V, X0, Y0, Z0)
    ->  true
    ;   v(S, V, X0, Y0, Z0)
    ),
    maplist(argument_holds, [X,Y,Z], [X0,Y0,Z0]).

%!  placed_by_formula(+S) is semidet.
%
%   True when vertices of segment S have formulas, and nothing was done to it.

placed_by_formula(S) :-
    formula(v(S, _), _),
    !,
    untouched(S).

%   untouched(S): it was not cut, and no vertex was moved to touch another one.

untouched(S) :-
    \+ leaf_v(S, _, _, _, _),
    \+ leaf_e(S, _, _, _, _),
    \+ leaf_p(S, _, _),
    \+ ( origin(S, Item, _), functor(Item, Name, 1),
         memberchk(Name, [v,e,p,s]) ).

%   as_made(S, Kind, Term): the rows of S are those of the primitive Term.

as_made(S, Kind, Term) :-
    untouched(S),
    catch(primitive_shape(Term, Kind, Points, Chains),
          error(model_error(_), _), fail),
    in_order(V-point(X, Y, Z), v(S, V, X, Y, Z), Points),
    findall(Edges,
            ( member(Chain, Chains), chain_edges(Kind, Chain, Edges) ),
            Wanted),
    append(Wanted, Pairs),
    in_order(E-(V1-V2), e(S, E, V1, V2, 1), Pairs),
    (   Kind == curve
    ->  true
    ;   made_polygons(Wanted, 1, 1, S, Last),
        \+ ( p(S, P, _), P > Last )
    ).

:- meta_predicate in_order(+, 0, -).

%   in_order(Id-Item, Goal, Items): by their numbers, whatever the rows' order.

in_order(Pair, Goal, Items) :-
    findall(Pair, Goal, Pairs0),
    keysort(Pairs0, Pairs),
    pairs_values(Pairs, Items).

chain_edges(curve, Chain, Edges) :-
    !,
    findall(V-W, append(_, [V,W|_], Chain), Edges).
chain_edges(_, Chain, Edges) :-
    vertex_list_edges(Chain, Edges).

made_polygons([], P, _, _, Last) :-
    Last is P-1.
made_polygons([Edges|Rest], P, E, S, Last) :-
    length(Edges, N),
    E1 is E+N,
    End is E1-1,
    numlist(E, End, Es),
    p(S, P, Es),
    !,
    P1 is P+1,
    made_polygons(Rest, P1, E1, S, Last).
