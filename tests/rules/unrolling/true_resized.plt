/* Primitives whose other sides are primitives too: every outline larger and
   smaller, and what is round against its offset surface. */
:- module(test_true_resized, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(primitive/primitive)).
:- use_module(rules(unrolling/true_resized)).
:- use_module(rules(unrolling/true_surface), [offset_surface/3]).

near(A, B) :-
    abs(A-B) < 1.0e-9.

%   moved(Corners0, By, Corners): each edge lies By to the right of what it was,
%   in its direction.

moved(Corners0, By, Corners) :-
    append(Corners0, [_], Round0),
    append(Corners, [_], Round),
    Corners0 = [First0|_],
    Corners = [First|_],
    last(Round0, First0),
    last(Round, First),
    forall(( nth1(I, Corners0, [X1,Y1]),
             nth1(I, Corners, [X3,Y3]),
             I1 is I+1,
             nth1(I1, Round0, [X2,Y2]),
             nth1(I1, Round, [X4,Y4]) ),
           ( Length is sqrt((X2-X1)**2 + (Y2-Y1)**2),
             Off1 is ((X3-X1)*(Y2-Y1) - (Y3-Y1)*(X2-X1))/Length,
             Off2 is ((X4-X1)*(Y2-Y1) - (Y4-Y1)*(X2-X1))/Length,
             Along is (X4-X3)*(X2-X1) + (Y4-Y3)*(Y2-Y1),
             near(Off1, By),
             near(Off2, By),
             Along > 0.0 )).

polygon([[0,0],[60,0],[75,40],[40,25],[10,45]]).
polygon([[0,0],[50,0],[50,50],[20,50],[20,30],[0,30]]).
polygon([[-3,-2],[9,-4],[2,11]]).

outline_of(Outline0, By, Outline) :-
    transition_resized(open_transition(base(Outline0), top(circle(50)),
                                       height(60)), By,
                       open_transition(base(Outline), top(circle(R)),
                                       height(60))),
    near(R, 50+By).

resized(circle(10), [12.5], [7.5]).
resized(ellipse(10,20), [12.5,22.5], [7.5,17.5]).
resized(rectangle(10,20), [15.0,25.0], [5.0,15.0]).
resized(rectangle(10,20,4), [15.0,25.0,6.5], [5.0,15.0,1.5]).

%   term(Term, Kind): of a term with this Kind of surface.

term(cylinder(radius(10), height(30))).
term(sphere(radius(10))).
term(hemisphere(radius(10))).
term(torus(radius(30), tube(10))).
term(cone(radius(20), top(10), height(30))).
term(cone(radius(10), top(20), height(30))).
term(cone(radius(20), height(30))).
term(named(pipe, at([translate(1,2,3)], cylinder(radius(10), height(30))))).

surface(Term, Surface) :-
    primitive_faces(Term, _, [_-Surface|_]).

same_numbers(A, B) :-
    (   number(A)
    ->  near(A, B)
    ;   compound_name_arguments(A, Name, As),
        compound_name_arguments(B, Name, Bs),
        maplist(same_numbers, As, Bs)
    ).

:- begin_tests(true_resized).

test(outlines, [ forall(resized(Outline0, Larger, Smaller)),
                 true(Larger1-Smaller1 == Larger-Smaller) ]) :-
    outline_of(Outline0, 2.5, Outline1),
    outline_of(Outline0, -2.5, Outline2),
    Outline0 =.. [Name|_],
    Outline1 =.. [Name|Larger1],
    Outline2 =.. [Name|Smaller1].
test(polygons, forall(( polygon(Corners0),
                        member(By, [2.0,-0.5]),
                        member(Way, [left,right]) ))) :-
    (   Way == left
    ->  Corners1 = Corners0,
        Right = By
    ;   reverse(Corners0, Corners1),
        Right is -By
    ),
    outline_of(polygon(Corners1), By, polygon(Corners)),
    moved(Corners1, Right, Corners).
% Nothing is left, or an edge would turn round, or edges lie on each other.
test(too_small, [ forall(member(Outline, [ circle(2),ellipse(9,2),ellipse(2,9),
                                           rectangle(4,9),rectangle(9,4),
                                           rectangle(9,9,2),
                                           polygon([[0,0],[9,0],[9,3],[0,3]]),
                                           polygon([[0,0],[5,0],[9,0],[0,9]])
                                         ])),
                  fail ]) :-
    transition_resized(transition(base(circle(20)), top(Outline), height(9)),
                       -2.0, _).
test(placed, [ nondet,
               true(Term == named(hood, at([], transition(top(circle(4.0)),
                                                          base(circle(3.0)))))
                   ) ]) :-
    transition_resized(named(hood, at([], transition(top(circle(3)),
                                                     base(circle(2))))),
                       1.0, Term).
test(others, fail) :-
    transition_resized(cylinder(radius(2), height(3)), 1.0, _).
test(areas, Areas == [6.0,-6.0,0.5]) :-
    maplist(outline_area,
            [ [[0,0],[3,0],[3,2],[0,2]],
              [[0,2],[3,2],[3,0],[0,0]],
              [[5,5],[6,5],[5,6]] ], Areas).
test(as, Term == at([s], named(n, transition(as(circle(1), circle(2)),
                                             base(circle(3)),
                                             top(circle(4)))))) :-
    transition_parts_as(at([t], named(m, transition(base(circle(1)),
                                                    top(circle(2))))),
                        at([s], named(n, transition(base(circle(3)),
                                                    top(circle(4))))),
                        Term).

%   The surface of what is enlarged is that of the term, moved.

test(enlarged, [ forall(( term(Term0), member(By, [2.0,-1.5]) )), nondet ]) :-
    term_enlarged(Term0, By, Term),
    surface(Term0, Surface0),
    surface(Term, Surface),
    offset_surface(Surface0, By, Offset),
    radii_same(Surface, Offset).
test(not_at_all, Same == Term) :-
    Term = box(size(1,2,3)),
    term_enlarged(Term, 0, Same).

%   Vectors across the axis; how far along the axis a cone begins is its own.

radii_same(Surface, Offset) :-
    arg(2, Surface, U),
    arg(2, Offset, U1),
    same_numbers(U, U1),
    arg(3, Surface, V),
    arg(3, Offset, V1),
    same_numbers(V, V1).

:- end_tests(true_resized).
