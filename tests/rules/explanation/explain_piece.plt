:- module(test_explain_piece, []).
:- use_module(library(plunit)).
:- use_module(library(occurs)).
:- use_module(rules(sanggwan)).

/* Why a piece is in a result: by what is round its witness, which is asked of
   the operands as they are. */

operands([ box(size(4,4,2)), at([translate(0.75,0.5,1)], box(size(2,2,9))) ]).
operands([ cylinder(radius(2), height(5), facets(9)),
           at([rotate(x,30),translate(0.5,0,1)], box(size(1,1,8))) ]).
operands([ sphere(radius(2), facets(9), bands(5)),
           at([translate(1,0.25,0)], sphere(radius(2), facets(9),
                                            bands(5))) ]).

% right(Operation, Rounds, Leaf, Sense): of a piece of Leaf, that is below it
% and not above; the other one is on neither side, or on both.
right(Operation, Rounds, Leaf, Sense) :-
    memberchk(round(Leaf,1,0), Rounds),
    member(round(Other,B,A), Rounds),
    Other =\= Leaf,
    !,
    B =:= A,
    sense(Operation, Leaf, B, Sense).

sense(union, _, 0, 1).
sense(intersection, _, 1, 1).
sense(difference, 1, 0, 1).
sense(difference, 2, 1, -1).

:- begin_tests(explain_piece).

test(rounds, forall(( operands(Terms),
                      member(Operation, [union,intersection,difference]) ))) :-
    new_world(World),
    in_world(World,
             ( forall(member(Term, Terms), add_primitive(Term, _)),
               Name =.. [Operation,[1,2]],
               assert_fact(segment(3, solid, Name)),
               evaluate,
               findall(P, p(3, P, _), Ps),
               Ps = [_,_,_|_],
               forall(member(P, Ps), explained(Operation, P)) )).

explained(Operation, P) :-
    explanation(piece(3,P), Because),
    findall(round(L,B,A), sub_term(because(round(L,B,A), _), Because), Rounds),
    sub_term(because(piece_of(Leaf,_,Sense), _), Because),
    sub_term(because(verdict(kept(Sense),_), _), Because),
    right(Operation, Rounds, Leaf, Sense),
    !.
explained(Operation, P) :-
    explanation(piece(3,P), Because),
    format(user_error, '~w ~w: ~q~n', [Operation,P,Because]),
    fail.

% Where faces of both lie on each other, that of the first leaf stands for them.
test(covered, Covered == [2-1,2-1]) :-
    new_world(World),
    in_world(World,
             ( add_primitive(box(size(4,4,2)), _),
               add_primitive(at([translate(2,0,0)], box(size(4,2,2))), _),
               assert_fact(segment(3, solid, union([1,2]))),
               evaluate,
               findall(S-By, ( p(S, P, _), S < 3,
                               explanation(piece(3,S-P), Because),
                               once(sub_term(because(verdict(covered(By),_),
                                                     _), Because)) ),
                       Covered) )).

:- end_tests(explain_piece).
