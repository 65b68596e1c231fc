/* Formulas against arithmetic, step by step, and where they have no value. */
:- module(test_formula, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(formula)).

known(a, 3).
known(wall, 1.5).

value(Formula, Value) :-
    catch(formula_value(Formula, test_formula:known, Value),
          error(model_error(formula(What, _)), _), Value = no(What)).

%   step(Formula, Value): by what a pocket calculator has.

step(1+2, 3).
step(1-2.5, -1.5).
step(2*3.25, 6.5).
step(7/2, 3.5).
step(8/2, 4).
step(-(3), -3).
step(+(3), 3).
step(- a, no(no_number(a))).
step(param(a)*2, 6).
step(param(wall)+param(a), 4.5).
step(2**10, 1024).
step(2^10, 1024).
step(2** -2, 0.25).
step((-2)**3, -8).
step(9**0.5, 3).
step(0**0, 1).
step(5**0, 1).
step(0**3, 0).
step(0**(-1), no(division_by_zero)).
step(2**1.5, no(power)).
step(2**1000, Value) :-
    Value is 2.0**1000.
step(1**1000, 1).
step(1**1001, no(power)).
step(1**(-1000), 1).
step(1**(-1001), no(power)).
step(10**309, no(too_large)).
step(10**308, 1.0e308).
step(10**(-400), 0).
step(4**(-537), 5.0e-324).
step(4**(-540), 0).
step(4**511, Value) :-
    Value is 2.0**1022.
step(4**512, no(too_large)).
step((-1)**0.5, no(not_real)).
step(sqrt(16), 4).
step(sqrt(0), 0).
step(sqrt(-1.0e-300), no(not_real)).
step(abs(-2.5), 2.5).
step(min(2, 3), 2).
step(max(2, 3), 3).
step(floor(-2.5), -3).
step(ceiling(-2.5), -2).
step(round(2.5), 3).
step(round(-2.5), -3).
step(sin(30), 0.5).
step(cos(60), 0.5).
step(cos(180), -1).
step(tan(45), 1).
step(tan(90), no(division_by_zero)).
step(asin(1), 90).
step(asin(0.5), 30).
step(acos(0.5), 60).
step(acos(-1), 180).
step(acos(1.0000001), no(not_real)).
step(asin(-1.0000001), no(not_real)).
step(atan(1), 45).
step(atan2(1, 0), 90).
step(atan2(0, 1), 0).
step(atan2(-1, 0), -90).
step(atan2(0, 0), no(not_real)).
step(1/0, no(division_by_zero)).
step(0/0, no(division_by_zero)).
step(1.0e308*10, no(too_large)).
step(1.0e308+1.0e308, no(too_large)).
step(pi, 3.141592653589793).
step(2*pi/pi, 2).
step(2**53, 9007199254740992).
step(2**53*2, 1.8014398509481984e16).
step(0-2**53, -9007199254740992).
step(param(b), no(unknown(b, []))).
step(param(wal)+1, no(unknown(wal, [wall]))).
step(param(7), no(no_number(param(7)))).
step(sinn(3), no(no_function(sinn, 1, [sin]))).
step(sin(3, 4), no(no_function(sin, 2, [min]))).
step(foo, no(no_number(foo))).
step("3", no(no_number("3"))).
step([1], no(no_number([1]))).
step(1+[2], no(no_number([2]))).
step(1r3, no(no_number(1r3))).
step(inf, no(no_number(inf))).
step(3, 3).
step(3.0, 3).
step(3.25, 3.25).
step(-0.0, 0).

:- begin_tests(formula).

test(step, [ forall(step(Formula, Wanted)), true(Value == Wanted) ]) :-
    value(Formula, Value).
test(in_degrees, forall(( between(-20, 20, I), I =\= 0 ))) :-
    A is I/21.0,
    findall(Off,
            ( member(Formula-Radians,
                     [ asin(A)-asin(A), acos(A)-acos(A), atan(A)-atan(A),
                       atan2(A, 0.3)-atan2(A, 0.3) ]),
              value(Formula, Value),
              Off is abs(Value-Radians*180/pi),
              assertion(0.0 =:= Value*2.0**40-truncate(Value*2.0**40)) ),
            Offs),
    max_list(Offs, Most),
    Most < 1.0e-12.
%   The exact power, rounded once.
test(powers, [ forall(( member(A, [0.1,1.1,-0.7,3.3,1.0e-9]),
                        member(N, [2,3,7,30,-1,-3,-30]) )),
               true(Value =:= Wanted) ]) :-
    value(A**N, Value),
    (   N > 0
    ->  Wanted is float(rational(A)**N)
    ;   M is -N,
        Wanted is float(1 rdiv rational(A)**M)
    ).
test(fault_names_its_part, Part == 1/(2-2)) :-
    catch(formula_value(3+1/(2-2), test_formula:known, _),
          error(model_error(formula(division_by_zero, Part)), _), true).
test(fault_names_the_whole, Whole == 3+param(b)) :-
    catch(formula_value(3+param(b), test_formula:known, _),
          error(model_error(formula(unknown(_, _), Whole)), _), true).
test(formed, Term == at([translate(3,4,0.5)],box(size(a,"b",[6|x])))) :-
    formed(at([translate(param(a),2*2,1/2)],
              box(size(a,"b",[param(a)*2|x]))), test_formula:known, Term).
test(which_are, Found == [pi,param(a),1+2,sin(3),-(3),sqrt(2)]) :-
    include(is_formula,
            [pi,param(a),1+2,sin(3),-(3),sqrt(2),3,a,sin(1,2),param(a,b),
             box(1),[1]], Found).
test(has, Found == [pi,f(pi),f([1,param(a)]),f(1+2)]) :-
    include(has_formula,
            [pi,f(pi),f([1,param(a)]),f(1+2),3,a,f(3,[a,"x"]),-3,f(-3)], Found).
test(parameters, Names == [a,b,a]) :-
    findall(Name, formula_parameter(f(param(a)+param(b),[param(a)],param(3)),
                                    Name), Names).
test(renamed, Term == f(param(c)+param(b),[param(c)])) :-
    renamed_parameters([a-c], f(param(a)+param(b),[param(a)]), Term).
test(whole, Numbers == [3,3.5,9007199254740992,9007199254740994.0,-2,7]) :-
    maplist(whole_number, [3.0,3.5,9007199254740992.0,9007199254740994.0,-2.0,
                           7], Numbers).
test(functions_have_values, [ forall(( formula_function(Name, Arity),
                                       Arity > 0 )) ]) :-
    length(Arguments, Arity),
    maplist(=(1), Arguments),
    compound_name_arguments(Formula, Name, Arguments),
    value(Formula, Value),
    number(Value).

:- end_tests(formula).
