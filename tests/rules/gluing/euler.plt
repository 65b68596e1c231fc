/* Euler operators: each change is counted, each has its inverse, and is one
   step of undo. covers: cells_edit */
:- module(test_euler, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(library(yall)).
:- use_module(rules(gluing/euler)).
:- use_module(rules(gluing/regions)).
:- use_module(rules(store)).
:- use_module(tests(rules/gluing/cells_rows)).
:- use_module(tests(rules/gluing/face_soup)).
:- use_module(tests(rules/gluing/turned_soup)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   counts(Counts): of segment 1, as it is.

counts(Counts) :-
    regions_report(1, Report),
    report_counts(Report, Counts).

point(V, p(X,Y,Z)) :-
    v(1, V, X, Y, Z).

middle(A, B, p(X,Y,Z)) :-
    point(A, p(XA,YA,ZA)),
    point(B, p(XB,YB,ZB)),
    X is (XA+XB)/2,
    Y is (YA+YB)/2,
    Z is (ZA+ZB)/2.

made(Operation) :-
    made(Operation, _).

made(Operation, Change) :-
    euler(1, Operation, Change).

%   back(Operation): what is made and killed again leaves the same faces, and
%   what was undone the same rows.

back(Operation) :-
    cells_rows(1, Rows),
    cells_shape(1, Shape),
    made(make(Operation)),
    made(kill(Operation)),
    cells_shape(1, Shape1),
    Shape1 == Shape,
    facts_undo,
    facts_undo,
    cells_rows(1, Rows1),
    Rows1 == Rows.

cube :-
    cube_faces([0,0,0], Faces0),
    turned_faces(Faces0, Faces),
    made_soup(Faces, [[[5,0,0],[6,0,0],[5,1,0],[5,0,0]]]),
    regions_made(1, _).

:- begin_tests(euler).

%   A cube from nothing, operator by operator.

test(cube_from_nothing, All == [[1,0,0,0,1,1,1,0],[8,7,0,0,1,1,1,0],
                                [8,12,0,0,1,1,1,5],[8,12,5,5,1,1,1,0],
                                [8,12,6,6,1,2,2,0]]) :-
    in_new_world(( assert_fact(segment(1, cells, cube)),
                   made(make(vertex(A, p(0,0,0)))), counts(C1),
                   made(make(spur(_, A, B, p(1,0,0)))),
                   made(make(spur(_, B, C, p(1,1,0)))),
                   made(make(spur(_, C, D, p(0,1,0)))),
                   made(make(spur(_, A, E, p(0,0,1)))),
                   made(make(spur(_, B, F, p(1,0,1)))),
                   made(make(spur(_, C, G, p(1,1,1)))),
                   made(make(spur(_, D, H, p(0,1,1)))), counts(C2),
                   maplist([V-W]>>made(make(wire(_, V, W))),
                           [D-A,E-F,F-G,G-H,H-E]), counts(C3),
                   maplist([Vs]>>made(make(face(_, [Vs]))),
                           [[A,D,C,B],[A,B,F,E],[B,C,G,F],[C,D,H,G],
                            [D,A,E,H]]), counts(C4),
                   made(make(face(_, [[E,F,G,H]])), Change), counts(C5) )),
    Change == change(0,0,1,1,0,1,1,0),
    All = [C1,C2,C3,C4,C5].

test(wire_between_parts, Change == change(0,1,0,0,-1,0,-1,0)) :-
    in_new_world(( made_soup([], [[[0,0,0],[1,0,0]],[[0,1,0],[1,1,0]]]),
                   regions_made(1, _),
                   made(make(wire(_, 1, 2)), Change) )).

test(there_and_back, [forall(member(What, [vertex,spur,wire,split,face,chord])),
                      true]) :-
    set_random(seed(11)),
    in_new_world(( cube, what(What, Operation), back(Operation) )).

what(vertex, vertex(_, p(7,7,7))).
what(spur, spur(_, 1, _, P)) :-
    point(1, p(X0,Y0,Z0)),
    once(( v(1, V, X1, Y1, Z1), V > 1 )),
    X is 2*X0-X1,
    Y is 2*Y0-Y1,
    Z is 2*Z0-Z1-0.5,
    P = p(X,Y,Z).
what(wire, wire(_, V, W)) :-                  % through the cube
    once(( v(1, V, _, _, _), v(1, W, _, _, _), V < W,
           \+ ( p(1, _, Es), has(Es, V), has(Es, W) ) )).
what(split, split(A, B, _, P)) :-
    once(e(1, _, A, B, _)),
    middle(A, B, P).
what(face, face(_, [[A,B,C]])) :-             % on the wires
    maplist(vertex_at, [[5,0,0],[6,0,0],[5,1,0]], [A,B,C]).
what(chord, chord(P, A, C, _)) :-
    once(( p(1, P, [E,E1|_]), e(1, E, A, _, _), e(1, E1, _, C, _) )).

has(Es, V) :-
    member(E, Es),
    e(1, E, V, _, _),
    !.

test(refused, [forall(member(Operation, [ kill(wire(_, 1, 2)),
                                          kill(vertex(1, _)),
                                          make(wire(_, 1, 99)),
                                          make(face(_, [[1,2,7]])),
                                          nonsense ])),
               error(domain_error(euler_operation, _))]) :-
    in_new_world(( cube, made(Operation) )).

%   A vertex on a face, and not told to be: nothing is left of it.

test(rolled_back,
     Rows1-E == Rows-geometry_error(glue_law(1,[unsure_part-1]))) :-
    in_new_world(( cube_faces([0,0,0], Faces), made_soup(Faces, []),
                   regions_made(1, _), cells_rows(1, Rows),
                   catch(made(make(vertex(_, p(0.5,0.5,0)))), error(E, _),
                         true),
                   cells_rows(1, Rows1) )).
test(no_cells, error(type_error(cells, 1))) :-
    in_new_world(( assert_fact(segment(1, surface, none)),
                   made(make(vertex(_, p(0,0,0)))) )).

:- end_tests(euler).
