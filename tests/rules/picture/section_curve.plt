/* Sections of spheres and tori on their true curves:
   rules/picture/section_curve.pl. */
:- use_module(library(plunit)).
:- use_module(library(assoc)).
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
               section_on_surfaces(Section, _),
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

term(fine, torus(radius(3), tube(1))).

surface_off(ball, X, Y, Z, Off) :-
    Off is abs(sqrt(X*X + Y*Y + Z*Z) - 3).
surface_off(fine, X, Y, Z, Off) :-
    surface_off(ring, X, Y, Z, Off).
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

%   Where the plane touches the ring the curve crosses itself.

test(tangent, [forall(member(Plane, [plane(0,-1,0,4), plane(-1,0,0,3)])),
               true(Most < 1.0e-11)]) :-
    cut(ring, Plane, Offs),
    max_list(Offs, Most).

%   What is drawn between the corners is on the curve too, and goes round it:
%   no piece is far off it, none turns back.

test(followed, [forall(member(Shape-Plane,
                              [ ball-plane(1,2,3,-11), ring-plane(0,-1,0,2.5),
                                ring-plane(0,-1,0,4), ring-plane(0,-1,0,3.999),
                                ring-plane(0,-1,0,1.5), fine-plane(0,-1,0,4),
                                fine-plane(0,-1,0,3.999),
                                fine-plane(0,-1,0,4.001) ])),
                true(Count-Far-Back == Count-[]-[])]) :-
    followed(Shape, Plane, Pieces),
    length(Pieces, Count),
    assertion(Count > 60),
    findall(Off, ( member(piece(A,B,_), Pieces), middle_off(Shape, A, B, Off),
                   Off > 0.002 ),
            Far),
    findall(A-B, ( member(piece(A,B,Chord), Pieces), back(A, B, Chord) ), Back).

%   followed(Shape, Plane, Pieces): piece(A,B,Chord), p(X,Y,Z) beside 1, 2, 3;
%   Chord is the whole edge.

followed(Shape, Plane, Pieces) :-
    term(Shape, Term),
    new_world(World),
    in_world(World,
             ( add_primitive(at([translate(1,2,3)], Term), _),
               complete_segments,
               cut_away(Plane, Section),
               section_on_surfaces(Section, Curves),
               section_region(Section, _, _, N, Edges),
               findall(piece(A,B,P1-P2),
                       ( member(V1-V2, Edges),
                         once(v(N, V1, X1, Y1, Z1)),
                         once(v(N, V2, X2, Y2, Z2)),
                         P1 = p(X1,Y1,Z1), P2 = p(X2,Y2,Z2), P1 \== P2,
                         ( get_assoc(edge(N,V1,V2), Curves, Points)
                         -> true
                         ;  Points = []
                         ),
                         append([P1|Points], [P2], All),
                         nextto(A, B, All) ),
                       Pieces) )).

middle_off(Shape, p(X1,Y1,Z1), p(X2,Y2,Z2), Off) :-
    X is (X1+X2)/2-1, Y is (Y1+Y2)/2-2, Z is (Z1+Z2)/2-3,
    surface_off(Shape, X, Y, Z, Off).

back(p(X1,Y1,Z1), p(X2,Y2,Z2), p(X3,Y3,Z3)-p(X4,Y4,Z4)) :-
    (X2-X1)*(X4-X3) + (Y2-Y1)*(Y4-Y3) + (Z2-Z1)*(Z4-Z3) =< 0.

%   A plane that touches a ring twice cuts it in two circles (Villarceau), each
%   as large as the ring's axis.

test(two_circles, true(Off < 1.0e-9)) :-
    A is -1/3,
    C is sqrt(8)/3,
    D is -A - 3*C,
    followed(ring, plane(A,0,C,D), Pieces),
    length(Pieces, Count),
    assertion(Count > 100),
    findall(Off1,
            ( member(piece(p(X,Y,Z),_,_), Pieces),
              findall(Off2, ( member(Middle, [1,-1]),
                              Off2 is abs(sqrt((X-1)**2 + (Y-2-Middle)**2
                                               + (Z-3)**2) - 3) ),
                      Offs),
              min_list(Offs, Off1) ),
            All),
    max_list(All, Off).

%   What is flat stays as it is cut.

test(box, true(Vs1 == Vs2)) :-
    new_world(World),
    in_world(World,
             ( add_primitive(box(size(1,2,3)), _),
               complete_segments,
               cut_away(plane(0,0,1,-1), Section),
               findall(V-X-Y-Z, v(_, V, X, Y, Z), Vs1),
               section_on_surfaces(Section, _),
               findall(V-X-Y-Z, v(_, V, X, Y, Z), Vs2) )).

:- end_tests(section_curve).
