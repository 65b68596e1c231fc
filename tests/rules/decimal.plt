/* Numbers as people write them, and what only Prolog writes. */
:- module(test_decimal, []).
:- use_module(library(plunit)).
:- use_module(rules(decimal)).

number_of(Text, Number) :-
    (   decimal_number(Text, Number0)
    ->  Number = Number0
    ;   Number = none
    ).

:- begin_tests(decimal).

test(number, [ forall(member(Text-Number,
                             [ "12"-12, "-12.5"-(-12.5), "+3"-3, " 7 "-7,
                               ".5"-0.5, "-.5"-(-0.5), "+.25"-0.25,
                               "1e-3"-1.0e-3, "2E3"-2.0e3, "1.5e+2"-150.0,
                               "007"-7, '8'-8 ])),
               true(Found =:= Number) ]) :-
    number_of(Text, Found).
test(none, [ forall(member(Text, [ "", " ", "x", "0x1F", "0'a", "1r3", "inf",
                                   "nan", "1 000", "1_000", "1,5", "--1", "-",
                                   ".", "1.5.2", "- 1", "1e", "e3", "1.0Inf",
                                   "1\n2" ])),
              true(Found == none) ]) :-
    number_of(Text, Found).
test(point, Points == ['3.5','-3.0']) :-
    findall(Point, ( member(Whole-Part, [3-5,(-3)-0,3-(-5),3.0-5,3-a]),
                     decimal_comma(width, Whole, Part, Point) ),
            Points).
test(of_a_name, fail) :-
    decimal_comma(f(x), 3, 5, _).

:- end_tests(decimal).
