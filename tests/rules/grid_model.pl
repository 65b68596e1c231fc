:- module(sg_test_grid_model,
          [ random_shape/1,             % -Shape
            random_map/1,               % -Map
            mapped_shape/3,             % +Map, +Shape0, -Shape
            add_shape/2,                % +S, +Shape
            shape_label/2               % +Shape, -Label
          ]).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(store)).

/** <module> Small solids and sheets on a coarse integer grid, at random.

A shape is shape(Label, Kind, Points, Faces): Kind as in segment/3, Points a
list of p(X,Y,Z), integers from 0 to 5 or so, a face a list of loops of point
numbers, counter-clockwise from outside, holes clockwise. The grid is so coarse
that vertices, edges and faces of two shapes touch more often than not.
*/

%!  random_shape(-Shape) is det.

random_shape(Shape) :-
    random_member(How, [prism,prism,prism,pyramid,pyramid,tetrahedron,sheet,
                        bent]),
    random_shape(How, Shape).

random_shape(prism, Shape) :-
    random_profile(Name, Loops),
    random_between(1, 3, H),
    prism(Loops, H, Points, Faces),
    placed(shape(prism(Name), solid, Points, Faces), Shape).
random_shape(pyramid, Shape) :-
    random_profile(Name, [Loop|_]),
    random_between(0, 3, X),
    random_between(0, 3, Y),
    random_between(1, 3, Z),
    pyramid(Loop, p(X,Y,Z), Points, Faces),
    placed(shape(pyramid(Name), solid, Points, Faces), Shape).
random_shape(tetrahedron, Shape) :-
    repeat,
    length(Points, 4),
    maplist(random_point, Points),
    tetrahedron(Points, Faces),
    !,
    Shape = shape(tetrahedron, solid, Points, Faces).
random_shape(sheet, Shape) :-
    random_profile(Name, Loops),
    flat(Loops, Points, Face),
    placed(shape(sheet(Name), surface, Points, [Face]), Shape).
random_shape(bent, Shape) :-
    random_between(1, 3, A),
    random_between(1, 2, B),
    random_between(-1, 1, C),
    placed(shape(bent, surface,
                 [ p(0,0,0), p(A,0,0), p(A,B,0), p(0,B,0), p(A,3,C), p(0,3,C)
                 ],
                 [[[1,2,3,4]], [[4,3,5,6]]]),
           Shape).

random_point(p(X,Y,Z)) :-
    maplist(random_between(0, 4), [X,Y,Z]).

%!  shape_label(+Shape, -Label) is det.

shape_label(shape(Label, _, _, _), Label).

/* - - - profiles: loops of X-Y, the outer one counter-clockwise - - - */

random_profile(Name, Loops) :-
    random_between(1, 3, A),
    random_between(1, 3, B),
    findall(N-L, profile(N, A, B, L), Profiles),
    random_member(Name-Loops, Profiles).

profile(box, A, B, [[0-0,A-0,A-B,0-B]]).
profile(box, A, B, [[0-0,A-0,A-B,0-B]]).
profile(triangle, A, B, [[0-0,A-0,1-B]]).
profile(diamond, _, _, [[1-0,2-1,1-2,0-1]]).
profile(l, _, _, [[0-0,2-0,2-1,1-1,1-2,0-2]]).
profile(u, _, B, [[0-0,3-0,3-C,2-C,2-1,1-1,1-C,0-C]]) :-
    C is B+1.
profile(arrow, _, _, [[0-0,2-1,4-0,2-3]]).
profile(ring, _, _, [[0-0,3-0,3-3,0-3], [1-1,1-2,2-2,2-1]]).
profile(window, _, _, [[0-0,4-0,4-4,0-4], [2-1,1-2,2-3,3-2]]).

%   flat(+Loops, -Points, -Face): in the plane Z = 0, from point 1 on.

flat(Loops, Points, Face) :-
    flat(Loops, 0, 1, Points, Face).

flat(Loops, Z, First, Points, Face) :-
    append(Loops, Places),
    findall(p(X,Y,Z), member(X-Y, Places), Points),
    foldl(numbered, Loops, Face, First, _).

numbered(Loop, Numbers, First, Next) :-
    length(Loop, N),
    Next is First+N,
    Last is Next-1,
    numlist(First, Last, Numbers).

prism(Loops, H, Points, [Bottom,Top|Sides]) :-
    flat(Loops, 0, 1, Low, Up),
    length(Low, N),
    First is N+1,
    flat(Loops, H, First, High, Top),
    append(Low, High, Points),
    maplist(reverse, Up, Bottom),
    findall([[A,B,D,C]],
            ( member(Loop, Up), side(Loop, A, B), C is A+N, D is B+N ),
            Sides).

side(Loop, A, B) :-
    Loop = [First|Rest],
    append(Rest, [First], Nexts),
    nth1(I, Loop, A),
    nth1(I, Nexts, B).

pyramid(Loop, Apex, Points, [[Bottom]|Sides]) :-
    flat([Loop], Low, [Base]),
    length(Low, N),
    Top is N+1,
    append(Low, [Apex], Points),
    reverse(Base, Bottom),
    findall([[A,B,Top]], side(Base, A, B), Sides).

tetrahedron([A,B,C,D], Faces) :-
    volume(A, B, C, D, Volume),
    (   Volume > 0
    ->  Faces = [[[1,3,2]], [[1,2,4]], [[2,3,4]], [[3,1,4]]]
    ;   Volume < 0
    ->  Faces = [[[1,2,3]], [[1,4,2]], [[2,4,3]], [[3,4,1]]]
    ).

volume(p(X0,Y0,Z0), p(X1,Y1,Z1), p(X2,Y2,Z2), p(X3,Y3,Z3), V) :-
    A is X1-X0, B is Y1-Y0, C is Z1-Z0,
    D is X2-X0, E is Y2-Y0, F is Z2-Z0,
    G is X3-X0, H is Y3-Y0, I is Z3-Z0,
    V is A*(E*I-F*H) - B*(D*I-F*G) + C*(D*H-E*G).

/* - - - placing - - - */

%   Axes are exchanged and turned round; what that mirrors is turned inside out.

placed(shape(Label, Kind, Points0, Faces0),
       shape(Label, Kind, Points, Faces)) :-
    random_permutation([1,2,3], Axes),
    length(Signs, 3),
    maplist(random_sign, Signs),
    length(By, 3),
    maplist(random_between(0, 2), By),
    maplist(placed_point(Axes, Signs, By), Points0, Points),
    (   mirrors(Axes, Signs)
    ->  maplist(maplist(reverse), Faces0, Faces)
    ;   Faces = Faces0
    ).

random_sign(Sign) :-
    random_member(Sign, [1,1,1,-1]).

placed_point(Axes, Signs, By, P, p(X,Y,Z)) :-
    maplist(placed_coordinate(P), Axes, Signs, By, [X,Y,Z]).

placed_coordinate(P, Axis, Sign, By, C) :-
    arg(Axis, P, C0),
    (   Sign =:= 1
    ->  C is C0+By
    ;   C is 3-C0+By
    ).

mirrors(Axes, Signs) :-
    findall(-1, ( nth1(I, Axes, A), nth1(J, Axes, B), I < J, A > B ), Swaps),
    append(Swaps, Signs, Factors),
    foldl(times, Factors, 1, -1).

times(X, Y0, Y) :-
    Y is X*Y0.

%!  random_map(-Map) is det.
%
%   A linear map of small integers that keeps orientation: three columns. What
%   touches goes on touching, but along no axis.

random_map(Map) :-
    repeat,
    length(Map, 3),
    maplist(random_column, Map),
    Map = [X,Y,Z],
    volume(p(0,0,0), X, Y, Z, Volume),
    Volume > 0,
    !.

random_column(p(X,Y,Z)) :-
    maplist(random_between(-2, 3), [X,Y,Z]).

%!  mapped_shape(+Map, +Shape0, -Shape) is det.

mapped_shape(Map, shape(Label, Kind, Points0, Faces),
             shape(Label, Kind, Points, Faces)) :-
    maplist(mapped_point(Map), Points0, Points).

mapped_point([p(A,B,C),p(D,E,F),p(G,H,I)], p(X0,Y0,Z0), p(X,Y,Z)) :-
    X is A*X0+D*Y0+G*Z0,
    Y is B*X0+E*Y0+H*Z0,
    Z is C*X0+F*Y0+I*Z0.

/* - - - into the world - - - */

%!  add_shape(+S, +Shape) is det.
%
%   As segment S: v/5, e/5 and p/3; the triangles are for complete_segments/0.

add_shape(S, shape(Label, Kind, Points, Faces)) :-
    assert_fact(segment(S, Kind, Label)),
    forall(nth1(V, Points, p(X0,Y0,Z0)),
           ( X is float(X0), Y is float(Y0), Z is float(Z0),
             assert_fact(v(S, V, X, Y, Z)) )),
    foldl(add_face(S), Faces, 1-1, _).

add_face(S, Loops, P-E0, P1-E1) :-
    findall(A-B, ( member(Loop, Loops), side(Loop, A, B) ), Sides),
    foldl(add_edge(S), Sides, Es, E0, E1),
    assert_fact(p(S, P, Es)),
    P1 is P+1.

add_edge(S, A-B, E, E, E1) :-
    assert_fact(e(S, E, A, B, 1)),
    E1 is E+1.
