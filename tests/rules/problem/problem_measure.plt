:- encoding(utf8).
/* Measures of problem sheets are what closed forms say, however coarse the
   facets are.
   covers: problem_measure, problem_item */
:- module(test_problem_measure, []).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(problem/problem_item)).
:- use_module(rules(problem/problem_measure)).
:- use_module(rules(problem/problem_point)).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   value(Primitives, Measure, Tolerance, Value): in a world of these, the last
%   one being the branch.

value(Primitives, Measure, Tolerance, Value) :-
    in_new_world(( forall(member(Primitive, Primitives),
                          add_primitive(Primitive, _)),
                   complete_segments,
                   length(Primitives, Branch),
                   facts_snapshot(( penetrate(all, []),
                                    numbered_points(Branch, 12, Points) )),
                   measured(Measure, Tolerance, 12, Points, Value) )).

%   A header along x of radius 40, and a branch of radius 20 that rises from its
%   axis.

tee([ at([rotate(y, 90), translate(-100, 0, 0)],
         cylinder(radius(40), height(200), facets(24))),
      cylinder(radius(20), height(100), facets(20))
    ]).

%   saddle(Area): that of the branch outside, unrolled, by Simpson's rule.

saddle(Area) :-
    N = 400,
    findall(Part,
            ( between(0, N, I),
              T is 2*pi*I/N,
              Length is 100 - sqrt(1600 - 400*sin(T)**2),
              ( memberchk(I, [0,N]) -> W = 1
              ; I mod 2 =:= 1 -> W = 4
              ; W = 2
              ),
              Part is W*Length ),
            Parts),
    sum_list(Parts, Sum),
    Area is 20*Sum*2*pi/N/3.

:- begin_tests(problem_measure).

closed(shortest_generator(2), 60.0).
closed(longest_generator(2), Length) :-
    Length is 100 - sqrt(1200).
closed(generator(2, 1), 60.0).
closed(generator(2, 4), Length) :-
    Length is 100 - sqrt(1200).
closed(generator(2, 2), Length) :-
    Length is 100 - sqrt(1600 - 100).
closed(area(2), Area) :-                % with the disc on top
    saddle(Area0),
    Area is Area0 + pi*400.
closed(volume(2), Volume) :-
    Volume is pi*400*100.
closed(coordinate(1, z), Z) :-          % above the lowest of the header
    member(Square, [1600,1500,1300,1200]),
    Z is 40 + sqrt(Square).

test(tee, [forall(member(Measure, [ shortest_generator(2),
                                    longest_generator(2), generator(2, 1),
                                    generator(2, 2), generator(2, 4), area(2),
                                    volume(2), coordinate(1, z) ])),
           true(Off < 0.01)]) :-
    tee(Primitives),
    value(Primitives, Measure, 0.1, Value),
    findall(Off0, ( closed(Measure, Closed), Off0 is abs(Value-Closed) ),
            Offs),
    min_list(Offs, Off).

solid(box(size(2, 3, 4)), 24.0).
solid(pyramid(base(6, 6), height(4)), 48.0).
solid(cylinder(radius(2, 3), height(4), shift(1, 1), facets(8)), V) :-
    V is 24*pi.
solid(cone(radius(3), height(4), facets(8)), V) :-
    V is 12*pi.
solid(cone(radius(4), top(2), height(3), facets(8)), V) :-
    V is pi*3*(16+8+4)/3.
solid(hollow_cylinder(radius(5), inner(3), height(2), facets(8)), V) :-
    V is 32*pi.
solid(sphere(radius(3), facets(8)), V) :-
    V is 36*pi.
solid(hemisphere(radius(3), facets(8)), V) :-
    V is 18*pi.
solid(torus(radius(5), tube(2), facets(8)), V) :-
    V is 2*pi*pi*5*4.

test(volume, [forall(solid(Primitive, Volume)), true(Off < 1.0e-9*Volume)]) :-
    value([at([rotate(x, 30), translate(1, 2, 3)], Primitive)], volume(1), 0.1,
          Value),
    Off is abs(Value-Volume).

pattern(box(size(60, 40, 30)), area(1), 10800.0).
pattern(box(size(60, 40, 30)), perimeter(1), 520.0).
pattern(cone(radius(30), height(40), facets(12)), area(1), Area) :-
    Area is pi*30*50 + pi*900.
pattern(cone(radius(30), height(40), facets(12)), perimeter(1), Length) :-
    Length is 100 + 4*pi*30.
pattern(cone(radius(30), height(40), facets(12)), sector(1), 216.0).
pattern(cone(radius(30), top(15), height(20), facets(12)), sector(1), 216.0).
pattern(cylinder(radius(30), height(40), facets(12)), perimeter(1), Length) :-
    Length is 80 + 8*pi*30.
pattern(cylinder(radius(30), height(40), facets(12)), generator(1, 5), 40.0).
pattern(box(size(60, 40, 30)), angle(1, 2, 1, 3), Angle) :-
    Angle is atan(40/60)*180/pi.

test(pattern, [forall(pattern(Primitive, Measure, Closed)),
               true(Off < 0.02)]) :-
    value([Primitive], Measure, 0.1, Value),
    Off is abs(Value-Closed).

%   What is asked more exactly is known more exactly.
test(exactly, true(Off < 0.006)) :-
    value([cone(radius(30), height(40), facets(12))], area(1), 0.05, Value),
    Off is abs(Value - (pi*30*50 + pi*900)).

test(shown, [forall(member(Tolerance-Unit-Text,
                           [ 0.1-mm-"23.5 mm", 0.05-mm-"23.46 mm",
                             1-mm-"23 mm", 0.1-cm-"2.3 cm",
                             0.1-deg-"23.5°" ])),
             true(Shown == Text)]) :-
    measure_shown(23.456, Unit, Tolerance, Shown).

:- end_tests(problem_measure).
