/* Auxiliary planes cut bodies where closed forms say, and meet the line in
   points of both true surfaces.
   covers: problem_plane */
:- module(test_problem_plane, []).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(problem/problem_plane)).
:- use_module(rules(problem/problem_point)).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

:- meta_predicate with_bodies(+, 0).

with_bodies(Primitives, Goal) :-
    in_new_world(( forall(member(Primitive, Primitives),
                          add_primitive(Primitive, _)),
                   complete_segments,
                   Goal )).

cone_and_cylinder([ cone(radius(45), height(90), facets(48)),
                    at([rotate(y, 90), translate(-60, 0, 30)],
                       cylinder(radius(10), height(120), facets(24)))
                  ]).

cone_and_sphere([ cone(radius(45), height(90), facets(48)),
                  at([translate(20, 0, 30)],
                     sphere(radius(15), facets(24)))
                ]).

:- begin_tests(problem_plane).

%   A level plane cuts the cone in a ring of its radius, closed, and the
%   cylinder in a rectangle.
test(sections, true(Counts == [48,2])) :-
    cone_and_cylinder(Primitives),
    with_bodies(Primitives,
                auxiliary_planes(z, [point(1, 1, none, p(0.0,0.0,33.0)),
                                     point(2, 1, none, p(9.0,9.0,33.0))],
                                 Planes)),
    Planes = [plane(z, 33.0, Sections)],
    length(Sections, 2),
    forall(( member(Section, Sections), member(p(_,_,Z), Section) ),
           abs(Z-33.0) < 1.0e-9),
    forall(member(Section, Sections),
           ( Section = [First|_], last(Section, First) )),
    Sections = [Ring,Long],
    R is 45*(1 - 33/90),
    findall(I, ( nth1(I, Ring, p(X,Y,_)), abs(sqrt(X*X+Y*Y)-R) < 1.0e-9 ),
            OnRing0),
    length(OnRing0, On0),
    On is min(48, On0),
    Half is sqrt(100-9),
    findall(Y, ( member(p(X,Y,_), Long), abs(abs(X)-60) < 1.0e-6,
                 abs(abs(Y)-Half) < 0.1 ),
            Ys0),
    maplist([Y0,S]>>(S is sign(Y0)), Ys0, Signs0),
    sort(Signs0, Signs),
    length(Signs, Two),
    Counts = [On,Two].

%   Of a square that is not closed the section is open.
test(open_section, true(Length =:= 10.0)) :-
    with_bodies([at([rotate(x, 90)], rectangle(size(10, 8)))],
                auxiliary_planes(z, [point(1, 1, none, p(0.0,0.0,1.0))],
                                 [plane(z, 1.0, [Section])])),
    Section = [p(X1,_,_)|_],
    last(Section, p(X2,_,_)),
    X1 =\= X2,
    Length is abs(X1-X2).

%   A plane beyond everything cuts nothing.
test(nothing_cut, true(Sections == [])) :-
    cone_and_cylinder(Primitives),
    with_bodies(Primitives,
                auxiliary_planes(x, [point(1, 1, none, p(99.0,0.0,0.0))],
                                 [plane(x, 99.0, Sections)])).

%   Points of planes lie on both true surfaces, each plane has two on the line
%   that goes round.
test(points, true(Levels-Count == 7-14)) :-
    cone_and_sphere(Primitives),
    with_bodies(Primitives,
                ( penetrate(all, []),
                  planes_points(z, 7, Points) )),
    length(Points, Count),
    forall(member(point(_, 1, none, p(X,Y,Z)), Points),
           ( R is 45*(1 - Z/90),
             abs(sqrt(X*X+Y*Y) - R) < 1.0e-5,
             abs((X-20)**2 + Y*Y + (Z-30)**2 - 225) < 1.0e-4 )),
    findall(Level, ( member(point(_, _, _, p(_,_,Z)), Points),
                     Level is round(Z*1.0e6) ),
            All),
    sort(All, Each),
    length(Each, Levels).

%   Planes that hold generators of both: those of the cone go through the
%   points, from its base to its apex.
test(straight, true(Count =:= 24)) :-
    cone_and_cylinder(Primitives),
    with_bodies(Primitives,
                ( facts_snapshot(( penetrate(all, []),
                                   numbered_points(2, 12, Points) )),
                  straight_lines(2, Points, Lines) )),
    length(Points, Count),
    forall(member(p(X1,Y1,Z1)-p(X2,Y2,Z2), Lines),
           ( abs(sqrt(X1*X1+Y1*Y1) - 45) < 1.0e-6, abs(Z1) < 1.0e-6,
             abs(X2)+abs(Y2) < 1.0e-6, abs(Z2-90) < 1.0e-6 )),
    forall(member(point(_, _, _, p(X,Y,Z)), Points),
           ( F is 1 - Z/90,
             member(p(XB,YB,_)-_, Lines),
             abs(X-F*XB) < 1.0e-4,
             abs(Y-F*YB) < 1.0e-4 )).

:- end_tests(problem_plane).
