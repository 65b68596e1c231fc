:- module(test_faces_of_meshes, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(solution_sequences)).
:- use_module(rules(penetration/chain)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(picture/view)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(store)).
:- use_module(tests('rules/grid_model')).
:- use_module(tests('rules/penetration/oracle')).

/* Faces make lines, not polygons: solids and sheets on a coarse grid, once of
true polygons and once as meshes, their polygons triangulated at random with
more points inside and on edges, have the same lines, contacts and pictures.
Model I is made from seed I. FACE_MODELS=N makes N models (default 60), from
number FACE_FIRST (default 1) on. */

models(First, Last) :-
    from_environment('FACE_FIRST', 1, First),
    from_environment('FACE_MODELS', 60, N),
    Last is First+N-1.

from_environment(Name, Default, N) :-
    (   getenv(Name, Text)
    ->  atom_number(Text, N)
    ;   N = Default
    ).

model_shapes(I, Shapes) :-
    set_random(seed(I)),
    random_member(N, [2,2,3]),
    length(Shapes0, N),
    maplist(random_shape, Shapes0),
    (   random_member(grid, [grid,grid,map])
    ->  Shapes = Shapes0
    ;   random_map(Map),
        maplist(mapped_shape(Map), Shapes0, Shapes)
    ).

in_scene(Shapes, Goal) :-
    new_world(World),
    in_world(World,
             ( foldl(add_next, Shapes, 1, _),
               complete_segments,
               call(Goal) )).

add_next(Shape, S, S1) :-
    add_shape(S, Shape),
    S1 is S+1.

/* - - - meshes of shapes - - - */

%   meshes(+Shapes, -Meshes): of triangles, their corners exact.

meshes(Shapes, Meshes) :-
    in_scene(Shapes,
             findall(S-Triangles, segment_triangles(S, Triangles), All)),
    maplist(mesh, Shapes, All, Meshes).

segment_triangles(S, Triangles) :-
    segment(S, _, _),
    findall(t(P,A,B,C), t(S, P, _, A, B, C), Triangles).

mesh(shape(Label,Kind,Points0,_), _-Triangles0,
     shape(mesh(Label),Kind,Points,Faces)) :-
    random_between(0, 8, Steps),
    changed(Steps, Points0-Triangles0, Points-Triangles),
    findall([[A,B,C]], member(t(_,A,B,C), Triangles), Faces).

changed(0, Mesh, Mesh) :-
    !.
changed(N, Mesh0, Mesh) :-
    random_member(How, [flip,flip,inside,edge]),
    (   change(How, Mesh0, Mesh1)
    ->  true
    ;   Mesh1 = Mesh0
    ),
    N1 is N-1,
    changed(N1, Mesh1, Mesh).

change(inside, Points0-Triangles0, Points-Triangles) :-
    random_select(t(P,A,B,C), Triangles0, Rest),
    maplist(nth_point(Points0), [A,B,C], [p(X1,Y1,Z1),p(X2,Y2,Z2),p(X3,Y3,Z3)]),
    X is (2*X1+X2+X3) rdiv 4,
    Y is (2*Y1+Y2+Y3) rdiv 4,
    Z is (2*Z1+Z2+Z3) rdiv 4,
    append(Points0, [p(X,Y,Z)], Points),
    length(Points, N),
    Triangles = [t(P,A,B,N),t(P,B,C,N),t(P,C,A,N)|Rest].
change(edge, Points0-Triangles0, Points-Triangles) :-
    random_member(T, Triangles0),
    side(T, A, B, _),
    maplist(nth_point(Points0), [A,B], [p(X1,Y1,Z1),p(X2,Y2,Z2)]),
    X is (X1+X2) rdiv 2,
    Y is (Y1+Y2) rdiv 2,
    Z is (Z1+Z2) rdiv 2,
    append(Points0, [p(X,Y,Z)], Points),
    length(Points, N),
    foldl(halved(A, B, N), Triangles0, [], Triangles).
change(flip, Points-Triangles0, Points-Triangles) :-
    random_permutation(Triangles0, Mixed),
    select(t(P,A0,B0,C0), Mixed, Rest0),
    side(t(P,A0,B0,C0), A, B, C),
    select(t(P,A1,B1,C1), Rest0, Rest),
    side(t(P,A1,B1,C1), B, A, D),
    normal(Points, A, B, C, N),
    normal(Points, A, D, C, N1),
    normal(Points, D, B, C, N2),
    same_way(N, N1),
    same_way(N, N2),
    !,
    Triangles = [t(P,A,D,C),t(P,D,B,C)|Rest].

nth_point(Points, I, Point) :-
    nth1(I, Points, Point).

side(t(_,A,B,C), A, B, C).
side(t(_,A,B,C), B, C, A).
side(t(_,A,B,C), C, A, B).

halved(A, B, N, t(P,V1,V2,V3), Triangles, [t(P,U,N,X),t(P,N,W,X)|Triangles]) :-
    side(t(P,V1,V2,V3), U, W, X),
    ( U-W == A-B ; U-W == B-A ),
    !.
halved(_, _, _, Triangle, Triangles, [Triangle|Triangles]).

normal(Points, A, B, C, n(X,Y,Z)) :-
    maplist(nth_point(Points), [A,B,C], [p(X1,Y1,Z1),p(X2,Y2,Z2),p(X3,Y3,Z3)]),
    X is (Y2-Y1)*(Z3-Z1) - (Z2-Z1)*(Y3-Y1),
    Y is (Z2-Z1)*(X3-X1) - (X2-X1)*(Z3-Z1),
    Z is (X2-X1)*(Y3-Y1) - (Y2-Y1)*(X3-X1).

same_way(n(X1,Y1,Z1), n(X2,Y2,Z2)) :-
    X1*X2 + Y1*Y2 + Z1*Z2 > 0.

/* - - - what must be the same - - - */

%   exact(-Found): the lines of each two segments as sets of points, and the
%   contacts; then the chains, how many of each kind.

exact(Found) :-
    penetration_chains(all, [tolerance(0)], Chains),
    findall(S1-S2-Kind, member(chain(S1,S2,Kind,_,_), Chains), Kinds0),
    msort(Kinds0, Kinds),
    penetrate(all, [tolerance(0)]),
    findall(S1-S2-lines(Runs,Alone),
            ( segment(S1, _, _), segment(S2, _, _), S1 < S2,
              pieces(S1, S2, Pieces),
              runs(Pieces, Runs),
              findall(A, ( line(_, S1, _, V, V, S2, _, _, _),
                           exact_vertex(S1, V, A) ), Alone0),
              msort(Alone0, Alone) ),
            Lines),
    Found = found(Kinds,Lines).

pieces(S1, S2, Pieces) :-
    findall(A-B,
            ( line(_, S1, _, V1, V2, S2, _, _, _), V1 \== V2,
              exact_vertex(S1, V1, A), exact_vertex(S1, V2, B) ),
            Pieces).

different(I, I-Labels-Polygons-OfMeshes) :-
    model_shapes(I, Shapes),
    meshes(Shapes, Meshes),
    in_scene(Shapes, found(exact(Polygons), Polygons)),
    in_scene(Meshes, found(exact(OfMeshes), OfMeshes)),
    Polygons \== OfMeshes,
    maplist(shape_label, Shapes, Labels).

found(Goal, Found) :-
    catch(Goal, Error, Found = Error).

%   loose(+Shape0, -Shape): no two faces have a point in common.

loose(shape(Label,Kind,Points0,Faces0),
      shape(loose(Label),Kind,Points,Faces)) :-
    foldl(loose_face(Points0), Faces0, Faces, []-1, Points1-_),
    reverse(Points1, Points).

loose_face(Points0, Loops0, Loops, State0, State) :-
    foldl(loose_loop(Points0), Loops0, Loops, State0, State).

loose_loop(Points0, Loop0, Loop, Points1-N1, Points-N) :-
    length(Loop0, Corners),
    N is N1+Corners,
    Last is N-1,
    numlist(N1, Last, Loop),
    maplist(nth_point(Points0), Loop0, New),
    reverse(New, Turned),
    append(Turned, Points1, Points).

loose_different(I, I-Labels-Whole-Loose) :-
    model_shapes(I, Shapes),
    meshes(Shapes, Meshes),
    maplist(loose, Meshes, LooseMeshes),
    in_scene(Meshes, found(exact(Whole), Whole)),
    in_scene(LooseMeshes, found(exact(Loose), Loose)),
    Whole \== Loose,
    maplist(shape_label, Meshes, Labels).

%   turned(-Found): after it was turned, so that nothing touches exactly any
%   more: lengths.

turned_lines(Found) :-
    penetrate,
    findall(S1-S2-Kind, chain(_, S1, S2, Kind, _), Kinds0),
    msort(Kinds0, Kinds),
    findall(S1-S2-Length,
            ( segment(S1, _, _), segment(S2, _, _), S1 < S2,
              aggregate_all(sum(L), ( chain(_, S1, S2, Kind, Ls),
                                      Kind \== point,
                                      chain_length(Ls, L) ), Length0),
              Length is round(Length0*1.0e6) ),
            Lengths),
    Found = found(Kinds,Lengths).

turned_different(I, I-Labels-Polygons-OfMeshes) :-
    model_shapes(I, Shapes0),
    meshes(Shapes0, Meshes0),
    random_turn(Turn),
    maplist(turned_shape(Turn), Shapes0, Shapes),
    maplist(turned_shape(Turn), Meshes0, Meshes),
    in_scene(Shapes, found(turned_lines(Polygons), Polygons)),
    in_scene(Meshes, found(turned_lines(OfMeshes), OfMeshes)),
    \+ near(Polygons, OfMeshes),
    maplist(shape_label, Shapes, Labels).

near(found(Kinds,Lengths1), found(Kinds,Lengths2)) :-
    maplist(near_length, Lengths1, Lengths2).
near(error(E,_), error(E,_)).

near_length(S-T-L1, S-T-L2) :-
    abs(L1-L2) =< 2.

%   random_turn(-Turn): about a random axis, through the matrix of a quaternion.

random_turn([[A,B,C],[D,E,F],[G,H,I]]) :-
    maplist(random(-1.0, 1.0), [W0,X0,Y0,Z0]),
    S is sqrt(W0*W0+X0*X0+Y0*Y0+Z0*Z0),
    maplist(divided(S), [W0,X0,Y0,Z0], [W,X,Y,Z]),
    A is 1-2*(Y*Y+Z*Z), B is 2*(X*Y-W*Z), C is 2*(X*Z+W*Y),
    D is 2*(X*Y+W*Z), E is 1-2*(X*X+Z*Z), F is 2*(Y*Z-W*X),
    G is 2*(X*Z-W*Y), H is 2*(Y*Z+W*X), I is 1-2*(X*X+Y*Y).

divided(S, X0, X) :-
    X is X0/S.

turned_shape(Turn, shape(Label,Kind,Points0,Faces),
             shape(Label,Kind,Points,Faces)) :-
    maplist(turned_point(Turn), Points0, Points).

turned_point(Rows, p(X0,Y0,Z0), p(X,Y,Z)) :-
    maplist(row_times(X0, Y0, Z0), Rows, [X,Y,Z]).

row_times(X, Y, Z, [A,B,C], Value) :-
    Value is float(A*X + B*Y + C*Z).

%   pictured(+Theta, +Phi, -Lengths): what is drawn of each role.

pictured(Theta, Phi, Lengths) :-
    penetrate,
    set_view(Theta, Phi, 0),
    picture([lines(penetration)]),
    aggregate_all(sum(L), drawn_length(visible, L), Visible),
    aggregate_all(sum(L), drawn_length(hidden, L), Hidden),
    maplist(rounded, [Visible,Hidden], Lengths).

drawn_length(Visibility, L) :-
    drawn(_, S, E, From, To, Visibility, penetration),
    once(e(S, E, V1, V2, _)),
    once(screen(S, V1, X1, Y1, _)),
    once(screen(S, V2, X2, Y2, _)),
    L is (To-From)*sqrt((X2-X1)**2+(Y2-Y1)**2).

rounded(L, N) :-
    N is round(L*1.0e5).

pictured_different(I, I-Labels-Polygons-OfMeshes) :-
    model_shapes(I, Shapes),
    meshes(Shapes, Meshes),
    random(0.0, 360.0, Theta),
    random(10.0, 80.0, Phi),
    in_scene(Shapes, found(pictured(Theta, Phi, Polygons), Polygons)),
    in_scene(Meshes, found(pictured(Theta, Phi, OfMeshes), OfMeshes)),
    \+ maplist(near_number, Polygons, OfMeshes),
    maplist(shape_label, Shapes, Labels).

near_number(A, B) :-
    abs(A-B) =< 2.

bad(Different_, Bad) :-
    models(First, Last),
    findall(Model, limit(3, ( between(First, Last, I),
                              call(Different_, I, Model) )), Bad).

:- multifile user:message_hook/3.

user:message_hook(sanggwan(not_flat(_, _, _, _)), warning, _).

:- begin_tests(faces_of_meshes).

test(exact, Bad == []) :-
    bad(different, Bad).
test(turned, Bad == []) :-
    bad(turned_different, Bad).
test(pictured, Bad == []) :-
    bad(pictured_different, Bad).

%   Triangles as STL has them, each with corners of its own.

test(loose, Bad == []) :-
    bad(loose_different, Bad).

:- end_tests(faces_of_meshes).
