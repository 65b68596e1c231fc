/* Light lines and dots of an answer: where they would stand on others. */
:- module(test_problem_drawing, []).
:- use_module(library(plunit)).
:- use_module(rules(problem/problem_drawing), []).

on(A, B, Truth) :-
    (   sg_problem_drawing:lies_on(A, B)
    ->  Truth = yes
    ;   Truth = no
    ).

place(Seen, Q-Texts) :-
    sg_problem_drawing:one_place(Seen, Q, Texts).

:- begin_tests(problem_drawing).

%   Also of lines far shorter, and far longer, than a millimetre.
test(lies_on, [ forall(( member(Size, [0.01,1,1000]),
                         member(Line-Truth,
       [ ((0-0)-(2-0))-yes, ((0.5-0)-(1-0))-yes, ((2-0)-(0-0))-yes,
         ((0-0)-(2.1-0))-no, ((-0.1-0)-(1-0))-no, ((0-0.1)-(2-0.1))-no,
         ((0-0)-(2-0.1))-no, ((3-0)-(4-0))-no, ((1-0)-(1-0))-yes ]) )),
                true(Found == Truth) ]) :-
    scaled(Size, Line, Scaled),
    scaled(Size, (0-0)-(2-0), Whole),
    on(Scaled, Whole, Found).
test(aslant, Found == [yes,no]) :-
    findall(Truth, ( member(Line, [(1-2)-(2-4),(1-2)-(2-4.1)]),
                     on(Line, (0-0)-(3-6), Truth) ), Found).
test(on_a_point, Found == no) :-
    on((1-1)-(1-1), (1-1)-(1-1), Found).
test(rounding, Found == [yes,no]) :-
    findall(Truth, ( member(Off, [1.0e-7,1.0e-4]), High is 2+Off,
                     on((0-0)-(High-0), (0-0)-(2-0), Truth) ), Found).

test(places, Places == [(1-1)-["1","3"],(2-2)-["2"]]) :-
    findall(Place,
            place(["1"-(1-1),"2"-(2-2),"3"-(1-1),"1"-(1-1)], Place),
            Places).
test(marked, Found == [yes,yes,no]) :-
    findall(Truth,
            ( member(Names, [all,[front,top],[top]]),
              ( sg_problem_drawing:marked_in(front, Names) -> Truth = yes
              ; Truth = no ) ),
            Found).

:- end_tests(problem_drawing).

scaled(Size, (A-B)-(C-D), (E-F)-(G-H)) :-
    E is A*Size,
    F is B*Size,
    G is C*Size,
    H is D*Size.
