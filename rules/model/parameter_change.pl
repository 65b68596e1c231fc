:- module(sg_parameter_change,
          [ set_parameter/2             % +Name, +Value
          ]).
:- use_module('../csg/csg_rows', [drop_boundary/1, drop_pictures/1]).
:- use_module('../csg/csg_term', [is_node_term/1]).
:- use_module('../csg/leaf', [leaves_restored/1, were_cut/2]).
:- use_module('../formula', [formed/3]).
:- use_module('../penetration/penetration', [penetrate/1]).
:- use_module('../polygon/triangulation', [complete_segments/0]).
:- use_module('../primitive/primitive_rows', [primitive_rows/3]).
:- use_module('../solid/csg_evaluate', [evaluate/0]).
:- use_module('../store',
              [ v/5, plane/6, leaf_v/5, joint/6, segment/3, unfolding/2, view/3,
                title_block/2, param/2, formula/2, assert_fact/1,
                retractall_facts/1, facts_transaction/1
              ]).
:- use_module(formula_rows, [default_kept/2, written_fact/2]).
:- use_module(formula_term, [formed_term/3, formed_wish/3]).
:- use_module(model_text, [model_float/2, world_parameter/2]).
:- use_module(parameter, [file_parameters/3]).
:- use_module(parameter_about, [ranges_told/0]).
:- use_module(library(apply), [maplist/2, maplist/3, maplist/4]).
:- use_module(library(error),
              [existence_error/2, must_be/2, type_error/2]).
:- use_module(library(lists), [member/2]).
/** <module> A parameter of the world gets another value.
*/

%!  set_parameter(+Name:atom, +Value:number) is det.
%
%   Gives the parameter Name of the current world this Value, and makes again
%   what was made from it: parameters with formulas, segments, vertices, the
%   view, the title block, wishes. If the world was cut, cuts are taken back
%   first, and all segments cut each other again afterwards. What was changed
%   by hand keeps its place. It is one transaction, so facts_undo/0 takes all of
%   it back. Pictures and patterns are to be made again.
%
%   @error existence_error(parameter, Name); type_error(float, Value); what
%   load_model/2 raises of a file with this value, without a place

set_parameter(Name, Value) :-
    must_be(atom, Name),
    (   model_float(Value, _)
    ->  true
    ;   type_error(float, Value)
    ),
    (   param(Name, _)
    ->  true
    ;   existence_error(parameter, Name)
    ),
    facts_transaction(sg_parameter_change:parameter_set(Name, Value)).

parameter_set(Name, Value) :-
    uncut(WereCut),
    findall(formula(Row, Written), valid_formula(Row, Written), Formulas),
    findall(given(Other, Written, none),
            ( param(Other, Old),
              written_fact(param(Other, Old), param(_, Written)) ),
            Items),
    memberchk(given(Name, Default, _), Items),
    default_kept(Name, Default),
    file_parameters(Items, [Name-Value], Parameters),
    retractall_facts(formula(param(Name), _)),
    maplist(parameter_row, Parameters),
    forall(member(formula(Row, Written), Formulas), made_again(Row, Written)),
    complete_segments,
    evaluate,
    (   WereCut == true
    ->  penetrate(all)
    ;   true
    ),
    ranges_told.

%   uncut(WereCut): the segments are as they were before any cut.

uncut(WereCut) :-
    findall(S1-S2, were_cut(S1, S2), Pairs0),
    sort(Pairs0, Pairs),
    (   Pairs == []
    ->  WereCut = false
    ;   leaves_restored(Pairs),
        WereCut = true
    ).

%   valid_formula(Row, Written): Row of the world is what Written says.

valid_formula(Row, Written) :-
    formula(Name, _),
    \+ memberchk(Name, [param(_),set(_)]),
    named_row(Name, Row),
    call(Row),
    written_fact(Row, Written),
    Written \== Row.

named_row(segment(S), Row) :-
    !,
    Row = segment(S, _, _).
named_row(v(S, V), Row) :-
    !,
    Row = v(S, V, _, _, _).
named_row(title_block(Item), Row) :-
    !,
    Row = title_block(Item, _).
named_row(Row, Row).

parameter_row(parameter(Name, _, Value)) :-
    (   param(Name, Value)
    ->  true
    ;   retractall_facts(param(Name, _)),
        assert_fact(param(Name, Value))
    ).

%   made_again(Row0, Written): Row0 becomes what Written says now.

made_again(segment(S, Kind0, Term0), segment(_, _, Written)) :-
    !,
    formed_term(Written, world_parameter, Term),
    (   Term == Term0
    ->  true
    ;   is_node_term(Term)
    ->  retractall_facts(segment(S, _, _)),
        assert_fact(segment(S, Kind0, Term))
    ;   drop_boundary(S),
        primitive_rows(Term, S, Kind),
        retractall_facts(segment(S, _, _)),
        assert_fact(segment(S, Kind, Term))
    ).
made_again(Row0, Written) :-
    Row0 =.. [Name|Values0],
    Written =.. [_|Arguments],
    maplist(value_again, Arguments, Values0, Values),
    Row =.. [Name|Values],
    (   Row == Row0
    ->  true
    ;   row_replaced(Row0, Row),
        formula_moved(Row0, Row, Written)
    ).

value_again(Argument, Value0, Value) :-
    (   Argument == Value0
    ->  Value = Value0
    ;   float(Value0)
    ->  formed(Argument, world_parameter, Number),
        model_float(Number, Value)
    ;   formed_wish(Argument, world_parameter, Value)
    ).

%   row_replaced(Row0, Row): a moved vertex takes planes and triangles with it,
%   which are made again.

row_replaced(Row0, Row) :-
    retractall_facts(Row0),
    assert_fact(Row),
    (   Row = v(S, _, _, _, _)
    ->  drop_pictures(S),
        retractall_facts(t(S, _, _, _, _, _)),
        retractall_facts(plane(S, _, _, _, _, _))
    ;   true
    ).

%   formula_moved(Row0, Row, Written): a row without a key names its formula.

formula_moved(Row0, Row, Written) :-
    (   formula(Row0, _)
    ->  retractall_facts(formula(Row0, _)),
        assert_fact(formula(Row, Written))
    ;   true
    ).
