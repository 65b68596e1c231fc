/* Signs of the discriminant and of its slope: those of the exact numbers,
   whether floating point tells or not. And how near its least value counts. */
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(rules(unrolling/true_pipe)).
:- use_module(rules(unrolling/true_quadratic)).

:- begin_tests(true_quadratic).

%   A pipe of radius R across a cylinder of radius sqrt(Const), its axis Off
%   from that one's axis: the rows are those of true_pipe.pl.

across(Off, R, Const,
       [row(Off, R, 0, 0, 0),row(0, 0, 0, 1, 0),row(0, 0, R, 0, 0)],
       quadric(0, 0, 0, Const)).

askew([row(1r7, 2r9, -1r3, 4r11, -1r2),row(-3r8, 1r5, 2r7, 3r4, -1r2),
       row(2r5, -1r6, 1r9, -5r13, -1r2)],
      quadric(-1, 1, -1r3, 0)).

degree(T) :- between(-2, 41, I), T is I*9.25.

exact_signs(Rows, Quadric) :-
    signed_form(Rows, Quadric, Form),
    forall(degree(T),
           ( discriminant(Rows, Quadric, T, D, Slope),
             value_sign(Form, T, Sign1),
             slope_sign(Form, T, Sign2),
             Sign1 =:= sign(D),
             Sign2 =:= sign(Slope)
           )).

test(across) :-
    across(1r3, 1r2, 1, Rows, Quadric),
    exact_signs(Rows, Quadric).
test(askew) :-
    askew(Rows, Quadric),
    exact_signs(Rows, Quadric).

%   At 0 degrees the pipe touches the cylinder, but for so little that no float
%   holds it.

test(nearly_tangent, forall(member(Way, [1,-1,0]))) :-
    Gap is Way rdiv 10**30,
    Const is 100r441 + Gap,
    across(1r3, 1r7, Const, Rows, Quadric),
    signed_form(Rows, Quadric, Form),
    value_sign(Form, 0, Sign),
    Sign =:= sign(Gap),
    slope_sign(Form, 0, 0).

%   Numbers whose fourth powers are no floats.

test(scale, forall(member(Power, [120,-120,400]))) :-
    (   Power > 0
    ->  Scale is 10**Power
    ;   Scale is 1 rdiv 10**(-Power)
    ),
    Off is Scale rdiv 3,
    R is Scale rdiv 2,
    across(Off, R, 1, Rows, Quadric),
    exact_signs(Rows, Quadric).

%   A pipe that almost touches: where the line turns fast the discriminant is at
%   most twice its least.

test(size, forall(member(Gap, [1r100,1r1000,1r100000]))) :-
    Const is 25r36 + Gap,
    across(1r3, 1r2, Const, Rows, Quadric),
    discriminant(Rows, Quadric, 0, D, _),
    discriminant(Rows, Quadric, 180, Most, _),
    pipe_centers(pipe(Rows, Quadric, none,
                      [ extreme(0, D, none, true),
                        extreme(180, Most, none, false) ]),
                 [T-Size]),
    T =:= 0,
    discriminant(Rows, Quadric, Size, D1, _),
    Grown is D1/D,
    assertion(( Grown > 1.9, Grown < 2.1 )).

:- end_tests(true_quadratic).
