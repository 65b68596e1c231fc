:- encoding(utf8).
:- module(test_operand_name, []).
:- use_module(library(plunit)).
:- use_module(rules(csg/operand_name)).

/* Names of operands in words. */

text(Body, Text) :-
    phrase(Body, Parts),
    maplist([Part,String]>>(   Part = Format-Arguments
                           ->  format(string(String), Format, Arguments)
                           ;   format(string(String), '~w', [Part])
                           ),
            Parts, Strings),
    atomics_to_string(Strings, Text).

:- begin_tests(operand_name).

test(ordinals, forall(member(I-Ordinal,
        [ 1-"1st", 2-"2nd", 3-"3rd", 4-"4th", 10-"10th", 11-"11th", 12-"12th",
          13-"13th", 14-"14th", 20-"20th", 21-"21st", 22-"22nd", 23-"23rd",
          24-"24th", 101-"101st", 110-"110th", 111-"111th", 112-"112th",
          113-"113th", 121-"121st", 1002-"1002nd", 1011-"1011th" ]))) :-
    text(operand_name_en(operand(I, union, 7)), Text),
    format(string(Wanted), "the ~s operand (union) of segment 7", [Ordinal]),
    Text == Wanted.
test(within, Text == "the 2nd operand (box) of the 1st operand (union) of \c
                      segment 7") :-
    text(operand_name_en(operand(2, box, operand(1, union, 7))), Text).
test(korean, Text == "세그먼트 7의 1번째 피연산자 (union)의 2번째 피연산자 \c
                      (box)") :-
    text(operand_name_ko(operand(2, box, operand(1, union, 7))), Text).

:- end_tests(operand_name).
