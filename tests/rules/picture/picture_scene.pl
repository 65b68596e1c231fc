:- module(sg_test_picture_scene,
          [ random_scene/1,             % ?Class
            random_view/2,              % +Class, -View
            turned/3,                   % +Turn, +Digits, :Goal
            random_turn/1,              % -Turn
            turned_point/3              % +Turn, +Point0, -Point
          ]).
/** <module> Random scenes to be drawn, entered into the current world.

Seed the generator first: set_random(seed(N)). The coordinates of the classes
that begin with `grid` are whole numbers from 0 to 3 and they are looked at
along whole directions, so that lines lie behind lines, in faces and on each
other, faces are seen edge-on, and solids touch.
*/

:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(solid/boolean)).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(tests('rules/polyhedron')).
:- use_module(tests('rules/random_solid')).

%!  random_scene(?Class) is nondet.
%
%   Enter a scene of Class into the current world.

random_scene(grid_boxes) :-
    several(2, 4, grid_box).
random_scene(grid_solids) :-
    several(2, 4, grid_solid).
random_scene(grid_sheets) :-
    several(1, 4, grid_sheet).
random_scene(grid_triangles) :-
    several(3, 6, grid_triangle).
random_scene(grid_mixed) :-
    several(1, 2, grid_solid),
    several(1, 2, grid_sheet),
    several(1, 2, grid_curve).
random_scene(grid_shells) :-
    grid_shells,
    several(0, 1, grid_curve).
random_scene(grid_bad) :-
    several(1, 2, bad_solid),
    several(0, 1, grid_curve).
random_scene(grid_united) :-
    several(2, 3, grid_box),
    united.
random_scene(solids) :-
    several(2, 3, placed_solid),
    complete_segments.
random_scene(round) :-
    several(1, 2, round_solid),
    complete_segments.
random_scene(united) :-
    several(2, 3, placed_solid),
    complete_segments,
    united.
random_scene(mixed) :-
    several(1, 2, placed_solid),
    complete_segments,
    several(1, 2, sheet),
    several(1, 2, curve).
random_scene(shells) :-
    random_between(2, 3, N),
    findall(Points-Faces, ( between(1, N, _), any_prism(Points, Faces) ),
            Shells),
    shells(Shells).

%   several(+Least, +Most, :Goal): Goal(S) for so many new segments.

:- meta_predicate several(+, +, 1).

several(Least, Most, Goal) :-
    random_between(Least, Most, N),
    forall(between(1, N, _), ( next_segment(S), call(Goal, S) )).

next_segment(S) :-
    findall(S0, segment(S0, _, _), Ss),
    max_list([0|Ss], Last),
    S is Last+1.

%   The segments there are become one solid; nothing else is left.

united :-
    findall(S, segment(S, _, _), Ss),
    next_segment(New),
    boolean(union(Ss), New),
    forall(member(S, Ss), dropped(S)).

dropped(S) :-
    retractall_facts(t(S, _, _, _, _, _)),
    retractall_facts(plane(S, _, _, _, _, _)),
    retractall_facts(p(S, _, _)),
    retractall_facts(e(S, _, _, _, _)),
    retractall_facts(v(S, _, _, _, _)),
    retractall_facts(segment(S, _, _)).

                /*******************************
                *            TURNED            *
                *******************************/

:- meta_predicate turned(+, +, 0).
:- thread_local turn/2.

%!  turned(+Turn, +Digits, :Goal) is semidet.
%
%   In Goal scenes are turned before they are entered; their coordinates have
%   all the Digits of a double, or `single`: 24 bits after the point.

turned(Turn, Digits, Goal) :-
    setup_call_cleanup(asserta(turn(Turn, Digits), Ref),
                       Goal,
                       erase(Ref)).

%!  random_turn(-Turn) is det.
%
%   Turn is a matrix, [r(A,B,C), ...], from a random quaternion.

random_turn([ r(A,B,C), r(D,E,F), r(G,H,I) ]) :-
    maplist(random(-1.0, 1.0), [W0,X0,Y0,Z0]),
    L is sqrt(W0*W0+X0*X0+Y0*Y0+Z0*Z0),
    W is W0/L, X is X0/L, Y is Y0/L, Z is Z0/L,
    A is 1-2*(Y*Y+Z*Z), B is 2*(X*Y-W*Z), C is 2*(X*Z+W*Y),
    D is 2*(X*Y+W*Z), E is 1-2*(X*X+Z*Z), F is 2*(Y*Z-W*X),
    G is 2*(X*Z-W*Y), H is 2*(Y*Z+W*X), I is 1-2*(X*X+Y*Y).

%!  turned_point(+Turn, +Point0, -Point) is det.

turned_point(Rows, Point, p(X,Y,Z)) :-
    maplist(along(Point), Rows, [X,Y,Z]).

along(p(X,Y,Z), r(A,B,C), Sum) :-
    Sum is A*X+B*Y+C*Z.

placed(Points0, Points) :-
    turn(Turn, Digits),
    !,
    maplist(turned_point(Turn), Points0, Points1),
    maplist(with_digits(Digits), Points1, Points).
placed(Points, Points).

with_digits(all, Point, Point).
with_digits(single, p(X0,Y0,Z0), p(X,Y,Z)) :-
    maplist([A,B]>>(B is round(A*2**24)/2.0**24), [X0,Y0,Z0], [X,Y,Z]).

enter(S, Kind, Points0, Faces) :-
    placed(Points0, Points),
    polyhedron(S, Kind, Points, Faces).

enter_curve(S, Points0) :-
    placed(Points0, Points),
    curve(S, Points).

                /*******************************
                *          ON THE GRID         *
                *******************************/

grid_point(p(X,Y,Z)) :-
    maplist(random_between(0, 3), [X,Y,Z]).

grid_box(S) :-
    box_corners(Low, High),
    box_points(Low, High, Points),
    box_faces(Faces),
    enter(S, solid, Points, Faces).

box_corners(p(X,Y,Z), p(X1,Y1,Z1)) :-
    maplist(random_side, [X-X1,Y-Y1,Z-Z1]).

random_side(Low-High) :-
    random_between(0, 2, Low),
    Least is Low+1,
    random_between(Least, 3, High).

grid_solid(S) :-
    random_member(Shape, [box,box,wedge,tetrahedron,pyramid]),
    solid_shape(Shape, Points, Faces),
    enter(S, solid, Points, Faces).

solid_shape(box, Points, Faces) :-
    box_corners(Low, High),
    box_points(Low, High, Points),
    box_faces(Faces).
solid_shape(wedge, Points, Faces) :-
    box_corners(Low, High),
    box_points(Low, High, [P1,P2,P3,P4,P5,P6|_]),
    Points = [P1,P2,P3,P4,P5,P6],
    Faces = [[1,3,4,2],[1,2,6,5],[1,5,3],[2,4,6],[3,5,6,4]].
solid_shape(tetrahedron, [A,B,C,D], Faces) :-
    repeat,
    grid_point(A),
    grid_point(B),
    grid_point(C),
    grid_point(D),
    volume(A, B, C, D, Volume),
    Volume =\= 0,
    !,
    (   Volume > 0
    ->  Faces = [[1,3,2],[1,2,4],[2,3,4],[3,1,4]]
    ;   Faces = [[1,2,3],[1,4,2],[2,4,3],[3,4,1]]
    ).
solid_shape(pyramid, [P1,P2,P3,P4,Top], Faces) :-
    box_corners(p(X,Y,Z), p(X1,Y1,Z1)),
    P1 = p(X,Y,Z),
    P2 = p(X1,Y,Z),
    P3 = p(X1,Y1,Z),
    P4 = p(X,Y1,Z),
    random_between(0, 3, U),
    random_between(0, 3, V),
    Top = p(U,V,Z1),
    Faces = [[1,4,3,2],[1,2,5],[2,3,5],[3,4,5],[4,1,5]].

volume(p(X,Y,Z), p(X1,Y1,Z1), p(X2,Y2,Z2), p(X3,Y3,Z3), Volume) :-
    A is X1-X, B is Y1-Y, C is Z1-Z,
    D is X2-X, E is Y2-Y, F is Z2-Z,
    G is X3-X, H is Y3-Y, I is Z3-Z,
    Volume is A*(E*I-F*H) - B*(D*I-F*G) + C*(D*H-E*G).

%   A few triangles over a few points of the grid, not edge on edge always.

grid_sheet(S) :-
    length(Points0, 5),
    maplist(grid_point, Points0),
    sort(Points0, Points),
    length(Points, N),
    findall([A,B,C],
            ( between(1, 3, _),
              random_between(1, N, A),
              random_between(1, N, B),
              random_between(1, N, C),
              triangle(Points, A, B, C) ),
            Faces0),
    sort(Faces0, Faces),
    (   Faces == []
    ->  grid_sheet(S)
    ;   enter(S, surface, Points, Faces)
    ).

grid_triangle(S) :-
    Points = [_,_,_],
    repeat,
    maplist(grid_point, Points),
    triangle(Points, 1, 2, 3),
    !,
    enter(S, surface, Points, [[1,2,3]]).

triangle(Points, A, B, C) :-
    nth1(A, Points, p(X,Y,Z)),
    nth1(B, Points, p(X1,Y1,Z1)),
    nth1(C, Points, p(X2,Y2,Z2)),
    \+ ( (X1-X)*(Y2-Y) =:= (X2-X)*(Y1-Y),
         (Y1-Y)*(Z2-Z) =:= (Y2-Y)*(Z1-Z),
         (Z1-Z)*(X2-X) =:= (Z2-Z)*(X1-X) ).

grid_curve(S) :-
    length(Points0, 4),
    maplist(grid_point, Points0),
    without_steps(Points0, Points),
    (   Points = [_,_|_]
    ->  enter_curve(S, Points)
    ;   grid_curve(S)
    ).

%   No point twice in a row.

without_steps([P,P|Ps0], Ps) :-
    !,
    without_steps([P|Ps0], Ps).
without_steps([P|Ps0], [P|Ps]) :-
    without_steps(Ps0, Ps).
without_steps([], []).

%   Several solids as one segment.

grid_shells :-
    random_between(2, 3, N),
    findall(Points-Faces,
            ( between(1, N, _),
              random_member(Shape, [box,tetrahedron,pyramid]),
              solid_shape(Shape, Points, Faces) ),
            Shells),
    shells(Shells).

%   What is said to be a solid and is none, or not all of it: a part inside
%   out, a box whose top is twisted so that it goes through itself, a solid with
%   a face too many or one turned round, a heap of triangles.

bad_solid(S) :-
    random_member(Shape, [inside_out,twisted,doubled,reversed,heap]),
    bad_shape(Shape, Points, Faces),
    enter(S, solid, Points, Faces).

bad_shape(inside_out, Points, Faces) :-
    solid_shape(box, Points0, Faces0),
    solid_shape(tetrahedron, Points1, Faces1),
    maplist(reverse, Faces1, Faces2),
    with_shell(Points1-Faces2, Points0-Faces0, Points-Faces).
bad_shape(twisted, [P1,P2,P3,P4,P6,P5,P7,P8], Triangles) :-
    solid_shape(box, [P1,P2,P3,P4,P5,P6,P7,P8], Faces),
    maplist(triangles, Faces, Lists),
    append(Lists, Triangles).
bad_shape(doubled, Points, Faces) :-
    solid_shape(tetrahedron, Points, Faces0),
    random_member(Face, Faces0),
    append(Faces0, [Face], Faces).
bad_shape(reversed, Points, Faces) :-
    solid_shape(box, Points, Faces0),
    random_select(Face, Faces0, Rest),
    reverse(Face, Turned),
    random_member(Faces, [[Turned|Rest], [Turned,Face|Rest]]).
bad_shape(heap, Points, Faces) :-
    length(Points, 5),
    repeat,
    maplist(grid_point, Points),
    findall([A,B,C],
            ( between(1, 6, _),
              random_permutation([1,2,3,4,5], [A,B,C|_]),
              triangle(Points, A, B, C) ),
            Faces0),
    sort(Faces0, Faces),
    Faces \== [],
    !.

triangles([A,B,C,D], [[A,B,C],[A,C,D]]).

shells(Shells) :-
    foldl(with_shell, Shells, []-[], Points-Faces),
    random_member(Kind, [solid,surface]),
    next_segment(S),
    enter(S, Kind, Points, Faces).

with_shell(Points1-Faces1, Points0-Faces0, Points-Faces) :-
    length(Points0, N),
    maplist(maplist(plus(N)), Faces1, Moved),
    append(Points0, Points1, Points),
    append(Faces0, Moved, Faces).

                /*******************************
                *           ANYWHERE           *
                *******************************/

placed_solid(_) :-
    random_placed(Term),
    add_primitive(Term, _).

%   Finely divided.

round_solid(_) :-
    random_member(Term, [ sphere(radius(1), facets(48), bands(24)),
                          torus(radius(1), tube(0.4), facets(48), sides(24)),
                          cone(radius(1), height(2), facets(48)) ]),
    random_rotation(Rotation),
    any_point(p(X,Y,Z)),
    append(Rotation, [translate(X,Y,Z)], Steps),
    add_primitive(at(Steps, Term), _).

any_prism(Points, Faces) :-
    random_between(3, 7, N),
    R is 0.5+0.5*random_float,
    prism(N, R, 2.0, Points0, Faces),
    random_member(Move, [axes,by(0,0,0)]),
    moved(Move, Points0, Points1),
    any_point(p(X,Y,Z)),
    moved(by(X,Y,Z), Points1, Points).

any_point(p(X,Y,Z)) :-
    X is 2*random_float-1,
    Y is 2*random_float-1,
    Z is 2*random_float-1.

sheet(S) :-
    length(Points, 5),
    maplist(any_point, Points),
    polyhedron(S, surface, Points, [[1,2,3],[3,2,4],[4,2,5]]).

curve(S) :-
    length(Points, 5),
    maplist(any_point, Points),
    curve(S, Points).

%!  random_view(+Class, -View) is det.
%
%   View is a view for a scene of Class: along whole directions, or any.

random_view(Class, View) :-
    (   sub_atom(Class, 0, _, _, grid)
    ->  random_member(How, [name,direction,direction,near])
    ;   random_member(How, [angles,angles,central])
    ),
    view_of(How, View).

view_of(name, Name) :-
    random_member(Name, [front,right,top,left,back,bottom,iso]).
view_of(near, central(Name,Rho)) :-
    random_member(Name, [front,right,top,left,back,bottom]),
    random_between(4, 9, Rho).
view_of(direction, direction(X,Y,Z)) :-
    maplist(random_between(-2, 2), [X,Y,Z]),
    [X,Y,Z] \== [0,0,0],
    !.
view_of(direction, direction(1,-2,2)).
view_of(angles, angles(Theta,Phi)) :-
    any_angles(Theta, Phi).
view_of(central, central(Theta,Phi,Rho)) :-
    any_angles(Theta, Phi),
    Rho is 6+4*random_float.

any_angles(Theta, Phi) :-
    Theta is 360*random_float,
    Phi is 180*random_float.
