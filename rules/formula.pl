:- module(sg_formula,
          [ has_formula/1,              % @Term
            is_formula/1,               % @Term
            formula_parameter/2,        % @Term, -Name
            formula_value/3,            % +Formula, :Known, -Value
            formed/3,                   % +Term0, :Known, -Term
            renamed_parameters/3,       % +Renamed, +Term0, -Term
            formula_function/2,         % ?Name, ?Arity
            whole_number/2              % +Number0, -Number
          ]).
:- use_module(angle, [exact_sin_cos/3]).
:- use_module(kernel, [has_part/2]).
:- use_module(spelling, [near_words/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [member/2]).
/** <module> Formulas: arithmetic over the parameters of a model.

Where a term of a model file wants a number, it may have a formula:

    number   pi   param(Name)   -A   A+B   A-B   A*B   A/B   A**N
    sqrt(A)  abs(A)  min(A, B)  max(A, B)
    floor(A)  ceiling(A)  round(A)
    sin(A)  cos(A)  tan(A)                  of degrees
    asin(A)  acos(A)  atan(A)  atan2(A, B)  in degrees

A formula is computed step by step in doubles, each step rounded once, so it has
the same value on every machine: sines and cosines are those of angle.pl, angles
are multiples of 2^-40 degrees, and of a power, whose exponent is whole (or 0.5,
the square root), the exact value is rounded. A value that is whole, and no
larger than 2^53, becomes an integer, so a formula may stand for a count too.

Errors are model_error(formula(What, Formula)), What being

    unknown(Name, Near)    a parameter that is not there, and such as are
    no_number(Item)        what is neither a number nor a formula
    no_function(Name, N, Near)   with N arguments
    division_by_zero  not_real  too_large  power
*/

:- meta_predicate
    formula_value(+, 2, -),
    formed(+, 2, -).

%!  formula_function(?Name, ?Arity) is nondet.
%
%   Name is a function of formulas with Arity arguments; of none, a number with
%   a name.

formula_function(pi, 0).
formula_function(-, 1).
formula_function(+, 1).
formula_function(sqrt, 1).
formula_function(abs, 1).
formula_function(floor, 1).
formula_function(ceiling, 1).
formula_function(round, 1).
formula_function(sin, 1).
formula_function(cos, 1).
formula_function(tan, 1).
formula_function(asin, 1).
formula_function(acos, 1).
formula_function(atan, 1).
formula_function(+, 2).
formula_function(-, 2).
formula_function(*, 2).
formula_function(/, 2).
formula_function(**, 2).
formula_function(^, 2).
formula_function(min, 2).
formula_function(max, 2).
formula_function(atan2, 2).

%!  has_formula(@Term) is semidet.
%
%   True when Term, or a part of it, is a formula and no mere number.

has_formula(Term) :-
    formula_parts(Parts),
    has_part(Term, Parts).

:- dynamic formula_parts_/1.

formula_parts(Parts) :-
    formula_parts_(Parts),
    !.
formula_parts(Parts) :-
    findall(Name/Arity, ( formula_function(Name, Arity), Arity > 0 ), List),
    Parts =.. [parts,pi,param/1|List],
    assertz(formula_parts_(Parts)).

%!  is_formula(@Term) is semidet.
%
%   True when Term itself is one.

is_formula(pi).
is_formula(Term) :-
    compound(Term),
    compound_name_arity(Term, Name, Arity),
    (   Name/Arity == param/1
    ->  true
    ;   formula_function(Name, Arity)
    ->  true
    ).

%!  formula_parameter(@Term, -Name) is nondet.
%
%   Term has a part param(Name).

formula_parameter(Term, Name) :-
    compound(Term),
    (   Term = param(Name0),
        atom(Name0)
    ->  Name = Name0
    ;   arg(_, Term, Argument),
        formula_parameter(Argument, Name)
    ).

%!  renamed_parameters(+Renamed, +Term0, -Term) is det.
%
%   Term is Term0 with param(New) for every param(Old), where Old-New is in the
%   list Renamed.

renamed_parameters([], Term0, Term) :-
    !,
    Term = Term0.
renamed_parameters(Renamed, param(Old), Term) :-
    member(Old-New, Renamed),
    !,
    Term = param(New).
renamed_parameters(Renamed, Term0, Term) :-
    compound(Term0),
    !,
    compound_name_arguments(Term0, Name, Arguments0),
    maplist(renamed_parameters(Renamed), Arguments0, Arguments),
    compound_name_arguments(Term, Name, Arguments).
renamed_parameters(_, Term, Term).

%!  formed(+Term0, :Known, -Term) is det.
%
%   Term is Term0 with the values of its formulas in their places; Known as in
%   formula_value/3.
%
%   @error as formula_value/3

formed(Term0, Known, Term) :-
    (   is_formula(Term0)
    ->  formula_value(Term0, Known, Term)
    ;   Term0 = [_|_]
    ->  formed_each(Term0, Known, Term)
    ;   compound(Term0)
    ->  compound_name_arguments(Term0, Name, Arguments0),
        formed_each(Arguments0, Known, Arguments),
        compound_name_arguments(Term, Name, Arguments)
    ;   Term = Term0
    ).

formed_each(Terms0, Known, Terms) :-
    (   Terms0 = [Term0|Rest0]
    ->  Terms = [Term|Rest],
        formed(Term0, Known, Term),
        formed_each(Rest0, Known, Rest)
    ;   formed(Terms0, Known, Terms)
    ).

%!  formula_value(+Formula, :Known, -Value) is det.
%
%   Value is the number that Formula has, where call(Known, Name, V) is true of
%   the parameter Name with the value V, and fails of one that is not there.
%
%   @error error(model_error(formula(What, Formula)), _), as above

formula_value(Formula, Known, Value) :-
    value(Formula, Known, Formula, Float),
    whole_number(Float, Value).

%!  whole_number(+Number0, -Number) is det.
%
%   Number is Number0 as an integer, if it is whole and no larger than 2^53.

whole_number(Number0, Number) :-
    (   float(Number0),
        abs(Number0) =< 9007199254740992.0,
        Number0 =:= truncate(Number0)
    ->  Number is truncate(Number0)
    ;   Number = Number0
    ).

%   value(Term, Known, Formula, Float): Term is a part of Formula.

value(Term, _, Formula, Float) :-
    number(Term),
    !,
    (   number_float(Term, Float0)
    ->  Float = Float0
    ;   formula_error(no_number(Term), Formula)
    ).
value(pi, _, _, Float) :-
    !,
    Float = 3.141592653589793.
value(param(Name), Known, Formula, Float) :-
    !,
    (   \+ atom(Name)
    ->  formula_error(no_number(param(Name)), Formula)
    ;   call(Known, Name, Value)
    ->  Float is float(Value)
    ;   findall(Other, call(Known, Other, _), Others),
        near_words(Name, Others, Near),
        formula_error(unknown(Name, Near), Formula)
    ).
value(Term, Known, Formula, Float) :-
    compound(Term),
    compound_name_arguments(Term, Name, Arguments),
    Term \= [_|_],
    !,
    length(Arguments, Arity),
    (   formula_function(Name, Arity)
    ->  true
    ;   findall(Other, formula_function(Other, Arity), Others),
        near_words(Name, Others, Near),
        formula_error(no_function(Name, Arity, Near), Formula)
    ),
    maplist(argument_value(Known, Formula), Arguments, Floats),
    stepped(Name, Floats, Term, Float).
value(Term, _, Formula, _) :-
    formula_error(no_number(Term), Formula).

:- meta_predicate argument_value(2, +, +, -).

argument_value(Known, Formula, Term, Float) :-
    value(Term, Known, Formula, Float).

number_float(Number, Float) :-
    ( integer(Number) ; float(Number) ),
    catch(Float0 is float(Number), error(evaluation_error(_), _), fail),
    finite(Float0),
    !,
    Float is Float0 + 0.0.

finite(Float) :-
    float_class(Float, Class),
    memberchk(Class, [zero,subnormal,normal]).

formula_error(What, Formula) :-
    throw(error(model_error(formula(What, Formula)), _)).

%   stepped(Name, Floats, Term, Float): one step; its faults are of Term. What
%   the flags of arithmetic let through is found by its class.

stepped(Name, Floats, Term, Float) :-
    catch(once(step(Name, Floats, Float0)), error(Fault, _),
          step_fault(Fault, Term)),
    (   finite(Float0)
    ->  Float is Float0 + 0.0
    ;   step_fault(evaluation_error(float_overflow), Term)
    ).

step_fault(Fault, Term) :-
    (   Fault = evaluation_error(Why)
    ->  (   memberchk(Why-What,
                      [ zero_divisor-division_by_zero,
                        float_overflow-too_large, power-power ])
        ->  formula_error(What, Term)
        ;   formula_error(not_real, Term)
        )
    ;   throw(error(Fault, _))
    ).

refused(Why) :-
    throw(error(evaluation_error(Why), _)).

step(+, [A], A).
step(-, [A], B) :-
    B is 0.0-A.
step(+, [A, B], C) :-
    C is A+B.
step(-, [A, B], C) :-
    C is A-B.
step(*, [A, B], C) :-
    C is A*B.
step(/, [A, B], C) :-
    (   B =:= 0.0
    ->  refused(zero_divisor)
    ;   C is A/B
    ).
step(**, [A, N], C) :-
    power(A, N, C).
step(^, [A, N], C) :-
    power(A, N, C).
step(sqrt, [A], B) :-
    (   A < 0.0
    ->  refused(undefined)
    ;   B is sqrt(A)
    ).
step(abs, [A], B) :-
    B is abs(A).
step(min, [A, B], C) :-
    C is min(A, B).
step(max, [A, B], C) :-
    C is max(A, B).
step(floor, [A], B) :-
    B is float(floor(A)).
step(ceiling, [A], B) :-
    B is float(ceiling(A)).
step(round, [A], B) :-
    B is float(round(A)).
step(sin, [A], B) :-
    exact_sin_cos(A, B, _).
step(cos, [A], B) :-
    exact_sin_cos(A, _, B).
step(tan, [A], B) :-
    exact_sin_cos(A, Sin, Cos),
    step(/, [Sin, Cos], B).
step(asin, [A], B) :-
    within_one(A),
    in_degrees(asin(A), B).
step(acos, [A], B) :-
    within_one(A),
    in_degrees(acos(A), B).
step(atan, [A], B) :-
    in_degrees(atan(A), B).
step(atan2, [A, B], C) :-
    (   A =:= 0.0,
        B =:= 0.0
    ->  refused(undefined)
    ;   in_degrees(atan2(A, B), C)
    ).

within_one(A) :-
    (   abs(A) =< 1.0
    ->  true
    ;   refused(undefined)
    ).

in_degrees(Radians, Degrees) :-
    Degrees is round(Radians*180.0/pi*2.0**40)/2.0**40.

%   power(A, N, C): the exact power, rounded once. What would be too large, or
%   vanish, is not computed.

power(A, N, C) :-
    (   N =:= 0.5
    ->  step(sqrt, [A], C)
    ;   ( N =\= truncate(N) ; abs(N) > 1000.0 )
    ->  refused(power)
    ;   N =:= 0.0
    ->  C = 1.0
    ;   A =:= 0.0
    ->  (   N < 0.0
        ->  refused(zero_divisor)
        ;   C = 0.0
        )
    ;   Size is N*log(abs(A))/log(2.0),
        (   Size > 1030.0
        ->  refused(float_overflow)
        ;   Size < -1080.0
        ->  C = 0.0
        ;   Exponent is truncate(abs(N)),
            Power is rational(A)**Exponent,
            (   N > 0.0
            ->  C is float(Power)
            ;   C is float(1 rdiv Power)
            )
        )
    ).
