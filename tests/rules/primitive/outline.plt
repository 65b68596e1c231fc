:- module(test_outline, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(time)).
:- use_module(rules(kernel), [loops_are_sound/1]).
:- use_module(rules(primitive/outline)).

/* The kernel says of loops what the rules say that find what is wrong. */

%   by_rule(Loops, Answer): sound, or what is wrong.

by_rule(Loops, Answer) :-
    Loops = [Outline|Holes],
    findall(hole(N)-Hole, nth1(N, Holes, Hole), Named),
    catch(( sg_outline:no_crossing([outline-Outline|Named], t),
            maplist(sg_outline:hole_place(Outline, Named, t), Named),
            Answer = sound ),
          error(model_error(primitive(What, _)), _),
          Answer = What).

random_loop(Size, Loop) :-
    random_between(3, 6, N),
    length(Loop, N),
    maplist(random_point(Size), Loop),
    append(Loop, [First], Round),
    Loop = [First|_],
    \+ ( append(_, [P,P|_], Round) ),
    !.
random_loop(Size, Loop) :-
    random_loop(Size, Loop).

random_point(Size, X-Y) :-
    random_between(0, Size, I),
    random_between(0, Size, J),
    X is I/1.0,
    Y is J/1.0.

%   Mostly an outline round them all; triangles in it that may touch.

random_loops([Outline|Holes]) :-
    random_member(Size, [3,4,12]),
    Size1 is Size+1.0,
    random_member(Outline0,
                  [ [-1.0-(-1.0),Size1-(-1.0),Size1-Size1,-1.0-Size1],
                    [-1.0-(-1.0),Size1-(-1.0),Size1-Size1] ]),
    random_loop(Size, Other),
    random_member(Outline, [Outline0,Outline0,Outline0,Other]),
    random_between(0, 4, N),
    length(Holes0, N),
    maplist(small_loop(Size), Holes0),
    High is Size+0.5,
    random_member(Holes,
                  [ Holes0,
                    Holes0,
                    [[-0.5-(-0.5),High-(-0.5),High-High,-0.5-High]|Holes0]
                  ]).

small_loop(Size, Loop) :-
    random_member(Wide, [1,2,8]),
    random_loop(Wide, Loop0),
    random_point(Size, Dx-Dy),
    maplist(moved(Dx, Dy), Loop0, Loop).

moved(Dx, Dy, X0-Y0, X-Y) :-
    X is X0+Dx,
    Y is Y0+Dy.

disagreement(Seed, Loops-Rule) :-
    set_random(seed(Seed)),
    random_loops(Loops),
    by_rule(Loops, Rule),
    (   loops_are_sound(Loops)
    ->  Rule \== sound
    ;   Rule == sound
    ).

%   many_holes(N, Loops): triangles in a square.

many_holes(N, [[-1.0-(-1.0),M-(-1.0),M-M,-1.0-M]|Holes]) :-
    C is ceiling(sqrt(N)),
    M is C+1.0,
    findall([X1-Y1,X2-Y2,X3-Y3],
            ( between(1, N, I),
              X is I//C, Y is I mod C,
              X1 is X+0.1, Y1 is Y+0.1, X2 is X+0.7, Y2 is Y+0.2,
              X3 is X+0.3, Y3 is Y+0.8 ),
            Holes).

%   comb(N, Loop): a loop of 4 N corners, whose edges are over each other.

comb(N, Loop) :-
    findall(P,
            ( between(1, N, I),
              Y is float(2*I), Y1 is Y+1,
              member(P, [1.0-Y,9.0-Y,9.0-Y1,1.0-Y1]) ),
            Teeth),
    Last is 2.0*N+1,
    append(Teeth, [0.0-Last,0.0-2.0], Loop).

cases(N) :-
    (   getenv('OUTLINE_CASES', Text)
    ->  atom_number(Text, N)
    ;   N = 3000
    ).

:- begin_tests(outline).

test(as_the_rules, Found == []) :-
    cases(N),
    findall(Seed-What,
            ( between(1, N, Seed), disagreement(Seed, What) ),
            Found),
    findall(Rule,
            ( between(1, 500, Seed), set_random(seed(Seed)),
              random_loops(Loops), by_rule(Loops, Rule0),
              functor(Rule0, Rule, _) ),
            Rules0),
    sort(Rules0, Rules),
    assertion(Rules == [crossing,hole_in_hole,hole_outside,sound]).
test(many_holes) :-
    many_holes(10000, Loops),
    call_with_time_limit(100, loops_are_sound(Loops)).
test(hole_in_the_last, fail) :-
    many_holes(10000, Loops),
    last(Loops, [X1-Y1,X2-Y2,X3-Y3]),
    Xa is X1+0.25,
    Ya is Y1+0.25,
    X is (X1+X2+X3)/3,
    Y is (Y1+Y2+Y3)/3,
    append(Loops, [[Xa-Ya,X-Ya,X-Y]], Loops1),
    call_with_time_limit(100, loops_are_sound(Loops1)).
test(comb) :-
    comb(5000, Loop),
    call_with_time_limit(100, outline_loops(Loop, [], t, [Loop1])),
    length(Loop1, 20002).
test(type, error(type_error(pair, a))) :-
    loops_are_sound([[a,b,c]]).
test(type, error(type_error(list, _))) :-
    loops_are_sound([1.0-2.0]).
test(few, error(domain_error(loop, [0.0-0.0,1.0-0.0]))) :-
    loops_are_sound([[0.0-0.0,1.0-0.0,1.0-1.0],[0.0-0.0,1.0-0.0]]).
test(none, error(domain_error(loops, []))) :-
    loops_are_sound([]).

:- end_tests(outline).
