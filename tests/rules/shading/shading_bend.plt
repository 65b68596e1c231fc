/* Normals of what was divided before: smooth(true).

% covers: shading_circle
*/
:- module(test_shading_bend, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(shading/seen)).
:- use_module(rules(shading/shading_scene)).
:- use_module(rules(store)).
:- use_module(tests('rules/polyhedron')).

:- begin_tests(shading_bend).

%   An ellipse of N corners, and the normal there.
outline(N, A, B, Corners) :-
    findall([X,Y],
            ( between(1, N, I), X is A*cos(2*pi*I/N), Y is B*sin(2*pi*I/N) ),
            Corners).

%   Seen from the front, 20 dots to a unit: normals at Xs of the line Y.
normals(Term, Y, Xs, Normals) :-
    in_new_world((
        assert_fact(segment(1, solid, Term)),
        shaded_model([1], Model),
        shaded_eye(Model, view(270.0,90.0,0.0,parallel), Eye),
        shaded_scene(Model, Eye, place(20.0,-5.0,5.0), 200-200, Scene),
        findall(vector(A,B,C),
                ( member(X, Xs), Dot is (X+5)*20,
                  seen_side(Scene, Dot, Y, _, vector(A,B,C)) ),
                Normals)
    )).

%   The angle to the normal of the ellipse, in degrees, at most.
off(A, B, Xs, Normals, Off) :-
    maplist(off_at(A, B), Xs, Normals, Offs),
    max_list(Offs, Off).

off_at(A, B, X, vector(U,V,W), Off) :-
    Y is -B*sqrt(1 - X*X/(A*A)),
    N is X/(A*A),
    M is Y/(B*B),
    Cosine is (N*U + M*V)/sqrt((N*N + M*M)*(U*U + V*V + W*W)),
    Off is acos(min(1.0, Cosine))*180/pi.

test(a_straight_prism, [ forall(member(N-Most, [24-1.6,48-0.45,96-0.12])),
                         true(Off < Most) ]) :-
    outline(N, 3.0, 2.0, Corners),
    numlist(-26, 26, Tenths),
    maplist([T,X]>>(X is T/10.0+0.013), Tenths, Xs),
    normals(prism(outline(Corners),height(2),smooth(true)), 80.5, Xs, Normals),
    off(3.0, 2.0, Xs, Normals, Off).
test(without_it_facets, true(Off > 3)) :-
    outline(24, 3.0, 2.0, Corners),
    numlist(-26, 26, Tenths),
    maplist([T,X]>>(X is T/10.0+0.013), Tenths, Xs),
    normals(prism(outline(Corners),height(2)), 80.5, Xs, Normals),
    off(3.0, 2.0, Xs, Normals, Off).

%   Placed as it is, also mirrored, and with several slices in one plane.
test(placed, [ forall(member(Steps, [[mirror(x)],[scale(-1,1,1)],
                                     [translate(1,1,1),translate(-1,-1,-1)]])),
               true(Off < 0.45) ]) :-
    outline(48, 3.0, 2.0, Corners),
    numlist(-26, 26, Tenths),
    maplist([T,X]>>(X is T/10.0+0.013), Tenths, Xs),
    normals(at(Steps,prism(outline(Corners),height(2),slices(3),smooth(true))),
            80.5, Xs, Normals),
    off(3.0, 2.0, Xs, Normals, Off).

%   A turning of a half circle in N parts, from cap to cap as in OpenSCAD, looks
%   as the sphere or, stretched, the ellipsoid does; of one in few parts as its
%   cones do.
rings(N, R, [[0,Low]|Outline]) :-
    findall([X,Z],
            ( between(1, N, I), A is (2*I-1)*pi/(2*N),
              X is R*sin(A), Z is -R*cos(A) ),
            Corners),
    Corners = [[_,Low]|_],
    High is -Low,
    append(Corners, [[0,High]], Outline).

test(a_turned_sphere, [ forall(member(A-N-Smooth,
                                      [1-15-true,1.5-15-true,1-5-false])),
                        true(Smooth-Off == Smooth-small) ]) :-
    rings(N, 3.0, Outline),
    numlist(-12, 12, Steps),
    maplist([T,X]>>(X is T/5.0+0.013), Steps, Xs),
    normals(at([scale(A,1,1)],
               turning(outline(Outline),facets(30),smooth(true))),
            80.5, Xs, Normals),
    Z is 5-80.5/20,
    findall(Off0,
            ( nth1(I, Xs, X), nth1(I, Normals, vector(U,V,W)),
              Y is -sqrt(9 - X*X/(A*A) - Z*Z),
              NX is X/(A*A),
              Cosine is (NX*U + Y*V + Z*W) / sqrt(NX*NX + Y*Y + Z*Z),
              Off0 is acos(min(1.0, Cosine))*180/pi ),
            Offs),
    max_list(Offs, Most),
    (   Smooth == true
    ->  ( Most < 0.6 -> Off = small ; Off = Most )
    ;   ( Most > 5 -> Off = small ; Off = Most )
    ).

%   A circle that is turned looks as the torus does, but where this hides
%   itself.
test(a_turned_circle, true(N < 5)) :-
    findall([X,Z],
            ( between(1, 24, I), X is 3+cos(pi*I/12), Z is sin(pi*I/12) ),
            Outline),
    numlist(-130, 130, Steps),
    maplist([T,X]>>(X is T/40.0), Steps, Xs),
    normals(at([rotate(x,60)],
               turning(outline(Outline),facets(48),smooth(true))),
            80.5, Xs, Normals),
    normals(at([rotate(x,60)], torus(radius(3),tube(1))), 80.5, Xs, Round),
    aggregate_all(count,
                  ( nth1(I, Normals, U), nth1(I, Round, V),
                    jump(U, V, Off),
                    Off > 4 ),
                  N).

%   What bends by more than 30 degrees stays an edge: both sides look as their
%   facets do.
test(a_crease, true(Normals = [vector(_,-1.0,_),vector(_,-1.0,_)])) :-
    normals(prism(outline([[-2,-2],[2,-2],[2,2],[-2,2]]),height(2),
                  smooth(true)), 80.5, [-1.9,1.9], Normals).

%   Across the borders of twisted triangles nothing jumps.
test(twisted, true(Most < 3)) :-
    outline(48, 3.0, 3.0, Corners),
    numlist(-80, 80, Steps),
    maplist([T,X]>>(X is T/40.0), Steps, Xs),
    normals(prism(outline(Corners),height(2),twist(20),slices(12),smooth(true)),
            80.5, Xs, Normals),
    findall(Off, ( append(_, [U,V|_], Normals), jump(U, V, Off) ), Offs),
    max_list(Offs, Most).

jump(vector(A,B,C), vector(D,E,F), Off) :-
    Cosine is A*D + B*E + C*F,
    Off is acos(min(1.0, Cosine))*180/pi.

test(twisted_facets, true(Most > 5)) :-
    outline(48, 3.0, 3.0, Corners),
    numlist(-80, 80, Steps),
    maplist([T,X]>>(X is T/40.0), Steps, Xs),
    normals(prism(outline(Corners),height(2),twist(20),slices(12)),
            80.5, Xs, Normals),
    findall(Off, ( append(_, [U,V|_], Normals), jump(U, V, Off) ), Offs),
    max_list(Offs, Most).

:- end_tests(shading_bend).
