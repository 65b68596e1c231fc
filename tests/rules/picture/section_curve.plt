/* Sections of spheres and tori on their true curves:
   rules/picture/section_curve.pl. */
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(rules(picture/section)).
:- use_module(rules(picture/section_curve)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(store)).

:- begin_tests(section_curve).

%   cut(Term, Plane, Offs): how far the ends of the lines round the caps are off
%   the surface x^2 + y^2 + z^2 or that of a torus, which stands at 1, 2, 3, and
%   off Plane.

cut(Shape, Plane, Offs) :-
    term(Shape, Term),
    new_world(World),
    in_world(World,
             ( add_primitive(at([translate(1,2,3)], Term), _),
               complete_segments,
               cut_away(Plane, Section),
               section_on_surfaces(Section),
               section_region(Section, _, _, N, Edges),
               findall(Off,
                       ( member(V-_, Edges),
                         once(v(N, V, X0, Y0, Z0)),
                         X is X0-1, Y is Y0-2, Z is Z0-3,
                         surface_off(Shape, X, Y, Z, Off1),
                         Plane = plane(A,B,C,D),
                         Off2 is abs(A*X0 + B*Y0 + C*Z0 + D),
                         Off is max(Off1, Off2) ),
                       Offs) )).

term(ball, sphere(radius(3), facets(12))).
term(ring, torus(radius(3), tube(1), facets(20), sides(9))).

surface_off(ball, X, Y, Z, Off) :-
    Off is abs(sqrt(X*X + Y*Y + Z*Z) - 3).
surface_off(ring, X, Y, Z, Off) :-
    Off is abs(sqrt((sqrt(X*X + Y*Y) - 3)**2 + Z*Z) - 1).

%   Planes through, beside and at tangency from inside, y = 2 of the ring.

test(on_curve, [forall(member(Shape-Plane,
                              [ ball-plane(0,-1,0,2.5), ball-plane(1,2,3,-11),
                                ring-plane(0,-1,0,2.5), ring-plane(0,-1,0,4.01),
                                ring-plane(0,-1,0,3.99), ring-plane(1,2,2,-11.5)
                              ])),
                true(Most < 1.0e-11)]) :-
    cut(Shape, Plane, Offs),
    length(Offs, Count),
    assertion(Count >= 8),
    max_list(Offs, Most).

%   Where the plane touches the ring the curve crosses itself: two of its
%   points may be left beside that.

test(tangent, [true(Count =< 2)]) :-
    cut(ring, plane(0,-1,0,4), Offs),
    findall(Off, ( member(Off, Offs), Off > 1.0e-9 ), Far),
    length(Far, Count).

%   What is flat stays as it is cut.

test(box, true(Vs1 == Vs2)) :-
    new_world(World),
    in_world(World,
             ( add_primitive(box(size(1,2,3)), _),
               complete_segments,
               cut_away(plane(0,0,1,-1), Section),
               findall(V-X-Y-Z, v(_, V, X, Y, Z), Vs1),
               section_on_surfaces(Section),
               findall(V-X-Y-Z, v(_, V, X, Y, Z), Vs2) )).

:- end_tests(section_curve).
