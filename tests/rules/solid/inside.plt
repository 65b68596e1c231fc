:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(solid/inside)).
:- use_module(rules(kernel), [windings/3]).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests('oracle/winding')).

/* Points inside, outside and on solids: the fused kernel against the rule, and
   both against what is known. */

:- meta_predicate with(+, 0).

with(Primitives, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(P, Primitives), add_primitive(P, _)),
               complete_segments,
               Goal )).

random_point(point(X,Y,Z)) :-
    maplist(quarter, [X,Y,Z]).

quarter(X) :-
    random_between(-8, 8, I),
    X is I rdiv 4.

shape(box(size(2,3,2))).
shape(pyramid(base(3,2), height(2))).
shape(cylinder(radius(1), height(2), facets(8))).
shape(cone(radius(1.5), top(0.5), height(2), facets(7))).
shape(at([rotate(x,30),rotate(z,20)], box(size(2,2,2)))).
shape(rectangle(size(2,2))).

:- begin_tests(inside).

test(kernel, [forall(shape(Shape)), true(Bad-Length == []-300)]) :-
    set_random(seed(1988)),
    length(Points, 300),
    maplist(random_point, Points),
    with([Shape],
         ( windings(1, Points, Kernel),
           maplist(winding_by_rule(1), Points, Rule) )),
    findall(P-A-B, ( nth1(I, Points, P), nth1(I, Kernel, A), nth1(I, Rule, B),
                     A \== B ), Bad),
    length(Kernel, Length).
test(box, Ws == [1, 1, on, on, on, 0, 0]) :-
    with([box(size(2,2,2))],
         windings(1,
                  [ point(0,0,1), point(1r3,0.5,1.5), point(1,0,1),
                    point(1,1,1), point(1,1,2), point(2,0,1),
                    point(-2,0,1) ],
                  Ws)).
% The nearest double lies on the face, the point itself does not.
test(by_a_hair, Ws == [1, on, 0]) :-
    with([box(size(2,2,2))],
         ( Less is 1 - 1 rdiv 10**40,
           More is 1 + 1 rdiv 10**40,
           windings(1, [point(Less,0,1), point(1,0,1), point(More,0,1)], Ws) )).
test(inside, Ss == [1,3]) :-
    with([ box(size(4,4,4)), at([translate(9,0,0)], box(size(1,1,1))),
           cylinder(radius(1), height(4)), rectangle(size(2,2)) ],
         findall(S, inside(S, point(0.25,0.125,1)), Ss)).
test(no_triangles, W == 0) :-
    with([line(from(0,0,0), to(1,1,1))], winding(1, point(0,0,0), W)).
test(no_points, Ws == []) :-
    with([box(size(2,2,2))], windings(1, [], Ws)).
test(bad_point, error(type_error(point, _))) :-
    with([box(size(2,2,2))], winding(1, p(0,0,0), _)).
test(bad_number, error(type_error(_, foo))) :-
    with([box(size(2,2,2))], winding(1, point(0,0,foo), _)).

:- end_tests(inside).
