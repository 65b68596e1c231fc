/* Penetration lines as a pupil counts them: what goes on through a point where
   more than two pieces meet is one line. */
:- module(test_problem_loop, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(penetration/chain), [chains/1]).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(problem/problem_loop)).
:- use_module(rules(store)).
:- use_module(rules(vector)).

:- meta_predicate cut(+, 0).

cut(Terms, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Term, Terms), add_primitive(Term, _)),
               complete_segments,
               penetrate,
               Goal )).

%   lines(Terms, Lines): how(Kind, Whole, Turn) of each line: whether it is one
%   way without a gap, and its sharpest turn in degrees.

lines(Terms, Lines) :-
    cut(Terms,
        ( whole_chains(Chains),
          assertion(each_once(Chains)),
          findall(how(Kind,Whole,Turn),
                  ( member(chain(S,_,Kind,Steps), Chains),
                    maplist(ends(S), Steps, Ends),
                    (   one_way(Kind, Ends)
                    ->  Whole = whole
                    ;   Whole = broken
                    ),
                    turns(Ends, Turn) ),
                  Lines0) )),
    msort(Lines0, Lines).

each_once(Chains) :-
    findall(L, ( member(chain(_,_,_,Steps), Chains), member(Step, Steps),
                 L is abs(Step) ), Ls0),
    msort(Ls0, Ls),
    findall(L, ( line(L, _, _, A, B, _, _, _, _), A =\= B ), All0),
    msort(All0, All),
    Ls == All.

ends(S, Step, P-Q) :-
    step_ends(S, Step, P, Q, _).

one_way(Kind, Ends) :-
    forall(append(_, [_-Q,P-_|_], Ends), P == Q),
    (   Kind == closed
    ->  Ends = [First-_|_],
        last(Ends, _-Last),
        First == Last
    ;   true
    ).

turns(Ends, Turn) :-
    findall(Degrees,
            ( append(_, [P-Q,Q-R|_], Ends),
              difference(Q, P, U),
              difference(R, Q, V),
              angle_between(U, V, Radians),
              Degrees is Radians*180/pi ),
            All),
    max_list([0|All], Turn).

:- begin_tests(problem_loop).

%   Two equal cylinders: four chains between two points, two curves that cross.
test(equal_cylinders, [ forall(member(Facets, [16,24,32])),
                        true(Found == [closed-whole,closed-whole]) ]) :-
    Cylinder = cylinder(radius(1),height(6),facets(Facets)),
    Terms = [ at([translate(0,0,-3)], Cylinder),
              at([rotate(y,90),translate(-3,0,0)], Cylinder) ],
    cut(Terms, ( chains(Chains0), findall(K, member(chain(_,_,K,_), Chains0),
                                          Kinds) )),
    assertion(Kinds == [open,open,open,open]),
    lines(Terms, Lines),
    findall(Kind-Whole, member(how(Kind,Whole,_), Lines), Found),
    forall(member(how(_,_,Turn), Lines), assertion(Turn < 40)).
%   Through: two loops apart stay two.
test(through, Found == [closed-whole,closed-whole]) :-
    lines([ at([translate(0,0,-3)], cylinder(radius(1),height(6),facets(24))),
            at([rotate(y,90),translate(-3,0,0)],
               cylinder(radius(0.5),height(6),facets(16))) ], Lines),
    findall(Kind-Whole, member(how(Kind,Whole,_), Lines), Found).
%   A line that ends at borders stays open, whichever way its pieces run.
test(open, Found == [open-whole]) :-
    lines([ rectangle(size(4,4)),
            at([rotate(x,90),translate(0,0.5,0.1)], rectangle(size(2,2))) ],
          Lines),
    findall(Kind-Whole, member(how(Kind,Whole,_), Lines), Found).

%   Chains in a row, each entered at its first or its last piece.
test(followed, [ forall(member(Pairs-Joined,
       [ []-[open-[1,2],open-[3,4],open-[5]],
         [1/last-2/first]-[open-[1,2,3,4],open-[5]],
         [1/last-2/first,2/last-3/last]-[open-[1,2,3,4,-5]],
         [1/first-2/first]-[open-[-4,-3,1,2],open-[5]],
         [1/first-2/last,2/first-3/first]-[open-[-5,3,4,1,2]],
         [1/first-3/last,1/last-2/last]-[open-[5,1,2,-4,-3]],
         [1/last-2/first,2/last-3/first,3/last-1/first]
             -[closed-[1,2,3,4,5]],
         [1/last-2/last,2/first-3/last,3/first-1/first]
             -[closed-[1,2,-4,-3,-5]],
         [1/last-1/first]-[closed-[1,2],open-[3,4],open-[5]] ])),
                 true(Found == Joined) ]) :-
    findall(Link, ( member(A-B, Pairs), ( Link = A-B ; Link = B-A ) ), Links),
    once(sg_problem_loop:followed([[1,2],[3,4],[5]], Links, Found)).

:- end_tests(problem_loop).
