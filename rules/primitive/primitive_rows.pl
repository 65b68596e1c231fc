:- module(sg_primitive_rows,
          [ add_primitive/2,            % +Term, -S
            without_rows/1,             % :Goal
            rows_left_out/0,
            commas_told/2,              % +Term, +Location
            goal_commas_told/1,         % +Goal
            add_shape/5,                % +Kind, +Term, +Points, +Chains, -S
            primitive_rows/3,           % +Term, +S, -Kind
            shape_rows/4                % +Kind, +S, +Points, +Chains
          ]).
:- use_module('../decimal', [decimal_comma/4]).
:- use_module('../kernel', [shape_write/4]).
:- use_module(primitive,
              [comma_argument/2, primitive_kind/2, primitive_shape/4]).
:- use_module('../store', [assert_fact/1, facts_transaction/1, fresh_id/3]).
:- use_module(library(occurs), [sub_term/2]).
/** <module> Primitives as rows of the world.

The shape of a primitive (primitive_shape/4) becomes the vertices, edges and
polygons of a segment, each numbered from 1 in the order of the shape.
*/

%!  add_primitive(+Term, -S) is det.
%
%   Add the primitive Term (primitive.pl) to the current world, as a new
%   segment S whose name is Term.
%
%   @error model_error(primitive(What, Term))

add_primitive(Term, S) :-
    rows_left_out,
    !,
    primitive_kind(Term, Kind),
    fresh_id(segment, 0, S),
    assert_fact(segment(S, Kind, Term)).
add_primitive(Term, S) :-
    primitive_shape(Term, Kind, Points, Chains),
    add_shape(Kind, Term, Points, Chains, S).

%!  without_rows(:Goal) is semidet.
%
%   While Goal runs, once, primitives are segments alone, without vertices:
%   their terms say all that is asked of them (rules/shading).

:- meta_predicate without_rows(0).

without_rows(Goal) :-
    b_setval(sg_without_rows, true),
    once(Goal),
    b_setval(sg_without_rows, false).

%!  rows_left_out is semidet.
%
%   True within without_rows/1.

rows_left_out :-
    nb_current(sg_without_rows, true).

%!  commas_told(+Term, +Location) is det.
%
%   A warning for each number of the primitive or tree Term in which a comma may
%   stand for the decimal point, comma_argument/2. Location is where Term is:
%   location(File, Line, Column), or `none`. It is for what people write, in
%   files and goals: programs compute whole numbers too.

commas_told(Term, Location) :-
    forall(comma_argument(Term, Argument),
           print_message(warning, sanggwan(comma(Argument, Location)))).

%!  goal_commas_told(+Goal) is det.
%
%   As commas_told/2, of a goal; also for set_parameter(d, 6,5).

goal_commas_told(Goal) :-
    commas_told(Goal, none),
    forall(parameter_comma(Goal, Call, Name, Point),
           print_message(warning,
                         sanggwan(parameter(decimal_comma(Call, Name,
                                                          Point))))).

parameter_comma(Goal, Call, Name, Point) :-
    sub_term(Term, Goal),
    compound(Term),
    compound_name_arguments(Term, Call, [Name,Whole,Part]),
    memberchk(Call, [set_parameter,param]),
    decimal_comma(Name, Whole, Part, Point).

%!  add_shape(+Kind, +Term, +Points, +Chains, -S) is semidet.
%
%   As add_primitive/2: S is a new segment of Kind with the name Term; Points
%   and Chains are as of primitive_shape/4. Fails, and nothing is added, if one
%   of Chains is no polygon.

add_shape(Kind, Term, Points, Chains, S) :-
    facts_transaction(
        sg_primitive_rows:new_segment(Kind, Term, Points, Chains, S)).

new_segment(Kind, Term, Points, Chains, S) :-
    fresh_id(segment, 0, S),
    assert_fact(segment(S, Kind, Term)),
    shape_rows(Kind, S, Points, Chains).

%!  primitive_rows(+Term, +S, -Kind) is det.
%
%   Add the rows of the primitive Term, which is of this Kind, to segment S,
%   that has none; segment/3 is left to the caller.
%
%   @error model_error(primitive(What, Term))

primitive_rows(Term, S, Kind) :-
    primitive_shape(Term, Kind, Points, Chains),
    shape_rows(Kind, S, Points, Chains).

%!  shape_rows(+Kind, +S, +Points, +Chains) is semidet.
%
%   Add Points as the vertices of segment S, that has no rows, and Chains as
%   its polygons; of a curve, as runs of its edges. Fails if one is no polygon.
%
%   @error model_error(value(v, coordinate, D, within(Most)))

shape_rows(Kind, S, Points, Chains) :-
    (   Kind == curve
    ->  Closed = false
    ;   Closed = true
    ),
    catch(shape_write(S, Points, Chains, Closed),
          error(domain_error(coordinate, D), _),
          throw(error(model_error(value(v, coordinate, D, within(1.0e90))),
                      _))).
