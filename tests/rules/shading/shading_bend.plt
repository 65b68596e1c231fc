/* Normals of what was divided before: smooth(true). */
:- module(test_shading_bend, []).
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
