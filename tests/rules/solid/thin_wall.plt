:- module(test_thin_wall, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(model/integrity), [model_defect/1, defect_weight/2]).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(store)).
:- use_module(tests('rules/boolean_case')).
:- use_module(tests('rules/random_solid')).

/* covers: face_merge_fold

   Walls, needles and wedges about as thin as the tolerance, and what other
   operands cut from them. What comes out is a solid none of whose faces is
   there twice; nothing moved farther than three tolerances, and a wall that is
   no longer what it was is told. */

%   What is said about moves is kept.

:- dynamic said/1, beside/1.

:- multifile user:message_hook/3.

user:message_hook(sanggwan(Said), _, _) :-
    functor(Said, Name, _),
    memberchk(Name, [tight,moved,flattened,as_rounded,opened,contacts]),
    assertz(test_thin_wall:said(Name)),
    (   Said = flattened(_, _, _, Beside, _)
    ->  assertz(test_thin_wall:beside(Beside))
    ;   true
    ).

tolerance(0.006).

%   thin(Family, Width, Solid): thin, round the origin, 4 long and high.

thin(plate, W, box(size(W,4,4))).
thin(needle, W, box(size(W,W,4))).
thin(wedge, W, prism(outline([[0,-2],[W,2],[0,2]]), height(4))).
thin(blade, W,
     prism(outline([[0,-2],[W,0],[0,2],[-0.1,0]]), height(4))).
thin(slotted, W,
     prism(outline([[-1,-2],[1,-2],[1,2],[W,2],[W,-1.5],[0,-1.5],[0,2],
                    [-1,2]]),
           height(4))).
thin(tube, W, hollow_cylinder(radius(0.5), inner(Inner), height(4),
                              facets(12))) :-
    Inner is 0.5-W.

operation(intersection, A, B, intersection([A,B])).
operation(union, A, B, union([A,B])).
operation(difference, A, B, difference([A,B])).
operation(taken_away, A, B, difference([B,A])).

%   A quarter of the tolerance wide to twice.

scene(Thin, Operation, Term) :-
    tolerance(T),
    random(R),
    Width is T*2**(3*R-2),
    thin(Thin, Width, Solid),
    random_block(Block),
    random_member(How, [square,turned]),
    (   How == square
    ->  Other = Block
    ;   random_rotation(Steps),
        placed(Steps, Block, Other)
    ),
    operation(Operation, at([translate(0,0,-2)], Solid), Other, Term).

random_block(at([translate(X,Y,Z)], box(size(A,B,C)))) :-
    maplist(random_in(0.5, 1.5), [A,B,C]),
    maplist(random_in(-0.4, 0), [X,Y,Z]).

random_in(Low, High, X) :-
    random(R),
    X is Low+(High-Low)*R.

fault(Thin-Operation-Seed-Fault) :-
    thin(Thin, 0.1, _),
    operation(Operation, _, _, _),
    sample(thin_wall, 6, Seed),
    set_random(seed(Seed)),
    scene(Thin, Operation, Term),
    tolerance(T),
    evaluated(Term, 0, Exact, _, _),
    evaluated(Term, T, Made, Defects, Words),
    fault(Term, Thin, Exact, Made, Defects, Words, Fault).

fault(_, _, _, Made, _, _, not_a_solid(Made)) :-
    Made.good \== yes.
fault(_, _, _, _, Defects, _, Defect) :-
    member(Defect, Defects).
fault(_, _, Exact, Made, _, _, far(Exact.volume, Made.volume)) :-
    tolerance(T),
    abs(Made.volume-Exact.volume) > 3*T*Exact.area.
fault(Term, Thin, Exact, Made, _, [], silent(Exact.volume, Made.volume)) :-
    % of the others what moves is a part of wide faces
    (   memberchk(Thin, [plate,wedge,slotted])
    ->  true
    ;   is_narrow(Term)
    ),
    abs(Made.volume-Exact.volume) > 1.0e-9.

%   is_narrow(+Term): a needle narrower than the tolerance, or its hole, is all
%   that may be lost.

is_narrow(intersection([at(_, box(size(Width,Width,_))),_])) :-
    tolerance(T),
    Width < T.
is_narrow(difference([_,at(_, box(size(Width,Width,_)))])) :-
    tolerance(T),
    Width < T.

evaluated(Term, Tolerance, Measures, Defects, Words) :-
    retractall(said(_)),
    retractall(beside(_)),
    new_world(World),
    in_world(World,
             ( assert_fact(segment(1, solid, Term)),
               evaluate(1, [tolerance(Tolerance)]),
               findall(Defect,
                       ( model_defect(Defect), defect_weight(Defect, fault) ),
                       Defects),
               measures(Measures) )),
    findall(Word, said(Word), Words).

measures(Measures) :-
    t(1, _, _, _, _, _),
    !,
    measured([1], [Measures]).
measures(_{good:yes, volume:0, area:0}).

:- begin_tests(thin_wall).

test(random, Faults == []) :-
    findall(Fault, fault(Fault), Faults).

%   Both sides of the edge of a blade that becomes flat are cut alone: nothing
%   of the blade's own is left at the slot but these.

test(slot, Words-Beside == [flattened]-wall) :-
    evaluated(difference([ at([translate(0,0,-0.5)], box(size(2,1,1))),
                           at([translate(0,0,-2)],
                              prism(outline([[0,-2],[0.009,0],[0,2],[-0.1,0]]),
                                    height(4)))
                         ]), 0.006, _, _, Words),
    forall(beside(wall(Thickness)), assertion(abs(Thickness-0.109) < 0.002)),
    findall(Kind, ( beside(What), functor(What, Kind, _) ), Kinds),
    sort(Kinds, [Beside]).

%   A wide slot has room for it.

test(wide_slot, Words == []) :-
    evaluated(difference([ at([translate(0,0,-0.5)], box(size(2,1,1))),
                           at([translate(0,0,-2)],
                              prism(outline([[0,-2],[0.009,0],[0,2],[-0.8,0]]),
                                    height(4)))
                         ]), 0.006, _, _, Words).

test(hole, Words == [flattened]) :-
    evaluated(difference([box(size(1,1,1)),
                          at([translate(0.2,0.2,-1)],
                             box(size(0.004,0.004,3)))]),
              0.006, Made, _, Words),
    assertion(abs(Made.volume-1) < 1.0e-9).

:- end_tests(thin_wall).
