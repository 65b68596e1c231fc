:- module(test_boolean_forms, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(solution_sequences)).
:- use_module(rules(kernel), [model_tolerance/1]).
:- use_module(tests('rules/boolean_case')).
:- use_module(tests('rules/random_solid')).

/* Solids whose volume, faces, vertices and edges are known, as they are and
   turned as a whole by random rotations, which opens every contact by a
   rounding error or closes it. BOOLEAN_CASES=50 turns each of the first ones
   1,000 times. */

%   form(Name, Turns, Terms, Expression, Volume, [Faces,Vertices,Edges])

form(flush_l, 20, [A,B], union([1,2]), 3, [8,12,18]) :-
    box(2,1,1, 0,0,0, A), box(1,1,1, 0,0,1, B).
form(cube2, 20, [A,B], union([1,2]), 2, [10,16,24]) :-
    box(1,1,1, 0,0,0, A), box(1,1,1, 1,0.5,0, B).
form(cube2_other, 4, [A,B], difference([1,2]), 1, [6,8,12]) :-
    box(1,1,1, 0,0,0, A), box(1,1,1, 1,0.5,0, B).
form(pyramid_flush, 10, [A,B], union([1,2]), V, [9,9,16]) :-
    box(2,2,2, 0,0,0, A),
    B = at([translate(1,1,2)], pyramid(base(2,2), height(1))),
    V is 8+4/3.
form(pyramid_inside, 6, [A,B], union([1,2]), V, [10,13,20]) :-
    box(2,2,2, 0,0,0, A),
    B = at([translate(1,0.8,2)], pyramid(base(1,1), height(1))),
    V is 8+1/3.
form(frustum, 10, [A,B], union([1,2]), V, [19,32,48]) :-
    box(2,2,2, -1,-1,0, A),
    B = at([translate(0.1,0,2)],
           cone(radius(0.7), top(0.3), height(1), facets(12))),
    ring(12, Ring),
    V is 8+Ring*(0.49+0.21+0.09)/3.
form(sphere_half_in, 10, [A,B], union([1,2]), V, [42,45,84]) :-
    box(2,2,2, -1,-1,0, A),
    B = at([translate(0,0,2)], sphere(radius(0.8), facets(12), bands(6))),
    cap(0, Half),
    V is 8+0.512*Half.
form(sphere_pit, 4, [A,B], difference([1,2]), V, [42,45,84]) :-
    box(2,2,2, -1,-1,0, A),
    B = at([translate(0,0,2)], sphere(radius(0.8), facets(12), bands(6))),
    cap(0, Half),
    V is 8-0.512*Half.
form(stacked_cylinders, 6, [A,B], union([1,2]), V, [14,24,36]) :-
    A = cylinder(radius(1), height(1), facets(12)),
    B = at([translate(0,0,1)], A),
    ring(12, Ring),
    V is 2*Ring.
form(hole, 6, [A,B], difference([1,2]), V, [18,32,48]) :-
    box(3,3,2, -1.5,-1.5,0, A),
    B = at([translate(0,0,-1)],
           cylinder(radius(1), height(4), facets(12))),
    ring(12, Ring),
    V is 18-2*Ring.
form(hole_flush, 6, [A,B], difference([1,2]), V, [18,32,48]) :-
    box(3,3,2, -1.5,-1.5,0, A),
    B = cylinder(radius(1), height(2), facets(12)),
    ring(12, Ring),
    V is 18-2*Ring.
form(hole_filled, 4, [A,B], union([difference([1,2]),2]), 18, [6,8,12]) :-
    box(3,3,2, -1.5,-1.5,0, A),
    B = cylinder(radius(1), height(2), facets(12)).
form(steinmetz, 6, [A,B], intersection([1,2]), V, [24,22,44]) :-
    crossing_cylinders(A, B),
    steinmetz(12, V).
form(steinmetz_outside, 6, [A,B], union([1,2]), V, none) :-
    crossing_cylinders(A, B),
    steinmetz(12, V1),
    ring(12, Ring),
    V is 8*Ring-V1.
form(sphere_cap, 6, [A,B], intersection([1,2]), V, [37,37,72]) :-
    A = sphere(radius(1), facets(12), bands(6)),
    box(4,4,4, -2,-2,0.25, B),
    cap(0.25, V).
form(chain_of_boxes, 4, Boxes, union(Numbers), 5.5, [6,8,12]) :-
    findall(Box, ( between(0, 9, I), X is 0.5*I, box(1,1,1, X,0,0, Box) ),
            Boxes),
    numlist(1, 10, Numbers).
form(chain_of_flush_boxes, 4, Boxes, union(Numbers), 10, [6,8,12]) :-
    findall(Box, ( between(0, 9, I), box(1,1,1, I,0,0, Box) ), Boxes),
    numlist(1, 10, Numbers).
form(chain_of_steps, 4, Boxes, union(Numbers), 10, [42,80,120]) :-
    findall(Box, ( between(0, 9, I), Y is 0.25*I, box(1,1,1, I,Y,0, Box) ),
            Boxes),
    numlist(1, 10, Numbers).
form(hollow, 4, [A,B], difference([1,2]), 26, [12,16,24]) :-
    box(3,3,3, 0,0,0, A), box(1,1,1, 1,1,1, B).
form(box_in_a_hollow, 4, [A,B,C], union([difference([1,2]),3]), 26.125,
     [18,24,36]) :-
    box(3,3,3, 0,0,0, A), box(1,1,1, 1,1,1, B),
    box(0.5,0.5,0.5, 1.25,1.25,1.25, C).
form(hollow_filled, 4, [A,B], union([difference([1,2]),2]), 27, [6,8,12]) :-
    box(3,3,3, 0,0,0, A), box(1,1,1, 1,1,1, B).
form(edge_in_common, 4, [A,B], union([1,2]), 2, [12,14,23]) :-
    box(1,1,1, 0,0,0, A), box(1,1,1, 1,1,0, B).
form(corner_in_common, 4, [A,B], union([1,2]), 2, [12,15,24]) :-
    box(1,1,1, 0,0,0, A), box(1,1,1, 1,1,1, B).
form(corner_in_common_and, 4, [A,B], intersection([1,2]), 0, [0,0,0]) :-
    box(1,1,1, 0,0,0, A), box(1,1,1, 1,1,1, B).
form(face_in_common_and, 4, [A,B], intersection([1,2]), 0, [0,0,0]) :-
    box(1,1,1, 0,0,0, A), box(1,1,1, 1,0.5,0, B).
form(apart, 2, [A,B], union([1,2]), 2, [12,16,24]) :-
    box(1,1,1, 0,0,0, A), box(1,1,1, 3,0,0, B).
form(apart_and, 2, [A,B], intersection([1,2]), 0, [0,0,0]) :-
    box(1,1,1, 0,0,0, A), box(1,1,1, 3,0,0, B).
form(inside_and, 2, [A,B], intersection([1,2]), 1, [6,8,12]) :-
    box(3,3,3, 0,0,0, A), box(1,1,1, 1,1,1, B).
form(inside_taken_away, 2, [A,B], difference([2,1]), 0, [0,0,0]) :-
    box(3,3,3, 0,0,0, A), box(1,1,1, 1,1,1, B).

%   A box by its size and its lowest corner.

box(A, B, C, X0, Y0, Z, at([translate(X,Y,Z)], box(size(A,B,C)))) :-
    X is X0+A/2.0,
    Y is Y0+B/2.0.

crossing_cylinders(at([translate(0,0,-2)], A),
                   at([translate(0,0,-2),rotate(y,90)], A)) :-
    A = cylinder(radius(1), height(4), facets(12)).

%   The area of a regular polygon of radius 1.

ring(N, Area) :-
    Area is N/2*sin(2*pi/N).

%   cap(From, Volume): what a sphere of radius 1, 12 facets and 6 bands has
%   above a height below its first ring: frusta between similar polygons.

cap(From, Volume) :-
    ring(12, Ring),
    R0 is 1+(cos(pi/6)-1)*From/0.5,
    Levels = [From-R0|Rings],
    findall(Z-R, ( between(1, 3, I), Z is sin(I*pi/6), R is cos(I*pi/6) ),
            Rings),
    frusta(Levels, 0, Sum),
    Volume is Ring*Sum.

frusta([_], Sum, Sum) :-
    !.
frusta([Z0-R0,Z-R|Rest], Sum0, Sum) :-
    Sum1 is Sum0+(Z-Z0)*(R0*R0+R0*R+R*R)/3,
    frusta([Z-R|Rest], Sum1, Sum).

%   steinmetz(N, Volume): of two prisms on N-gons of radius 1; at each height a
%   square, whose side is linear between corners.

steinmetz(N, Volume) :-
    Quarter is N//4,
    findall(Y-W, ( between(0, Quarter, I), Y is sin(2*pi*I/N),
                   W is 2*cos(2*pi*I/N) ),
            Levels),
    frusta(Levels, 0, Half),
    Volume is 2*Half.

form_fault(Name, Seed-Fault) :-
    form(Name, Turns, Terms0, Expression, Volume, Counts),
    (   Seed = straight,
        Terms = Terms0
    ;   sample(Name, Turns, Seed),
        set_random(seed(Seed)),
        random_rotation(Steps),
        maplist(placed(Steps), Terms0, Terms)
    ),
    catch(in_scene(Terms,
                   findall(F, limit(1, differs(Expression, Volume, Counts, F)),
                           Faults)),
          Error, Faults = [raised(Error)]),
    member(Fault, Faults),
    atomic_list_concat([Name,Seed], '_', File),
    keep_case(File, Terms, Expression).

differs(Expression, Volume, Counts, Fault) :-
    result(Expression, S),
    measured([1,S], [_,Measure]),
    counts(S, F, V, E),
    model_tolerance(Tolerance),
    edge_length(1, Length),
    Slack is 10*Tolerance*Length*Length,
    (   Measure.good \== yes,
        Fault = not_good(Measure)
    ;   Counts \== none,
        Counts \== [F,V,E],
        Fault = counts([F,V,E], wanted(Counts))
    ;   abs(Measure.volume-Volume) > Slack,
        Fault = volume(Measure.volume, wanted(Volume))
    ).

:- begin_tests(boolean_forms).

test(form, [forall(form(Name, _, _, _, _, _)), true(Faults == [])]) :-
    findall(Fault, form_fault(Name, Fault), Faults).

:- end_tests(boolean_forms).
