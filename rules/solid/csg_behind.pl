:- module(sg_csg_behind,
          [ behind_surface/4            % +Surface, +Box, -Solid, -Skirt
          ]).
:- use_module('../csg/csg_term', [csg_error/1]).
:- use_module('../store', [v/5, t/6]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists),
              [ append/2, append/3, max_list/2, member/2, min_list/2, nth1/3,
                same_length/2
              ]).
:- use_module(library(ordsets), [ord_memberchk/2]).
/** <module> What is behind an open surface, as a solid.

To split a solid by an open surface it is cut with a solid that has the surface
as its front. From the border a skirt hangs down, straight back along the mean
normal, past all of the solid, and a cap closes it. If the skirt does not meet
the solid, what is behind the surface is just what is inside.

@see row DV-3
*/

%!  behind_surface(+Surface, +Box, -Solid, -Skirt) is det.
%
%   Solid is a primitive, polyhedron(points(...), faces(...)), for what is
%   behind the segment Surface within Box; its first points and faces are the
%   vertices and triangles of Surface in the order of their numbers. Skirt is
%   sheet(...), the rest of its faces. Its own corners are rounded.
%
%   @error model_error(csg(no_front(Surface))): it faces nowhere on the whole,
%   or neighbours face opposite ways

behind_surface(Surface, Box, polyhedron(points(Points), faces(Faces)),
               sheet(points(Points), faces(Skirt))) :-
    findall(V-[X,Y,Z], v(Surface, V, X, Y, Z), Vertices0),
    keysort(Vertices0, Vertices),
    findall(T-[A,B,C], t(Surface, _, T, A, B, C), Triangles0),
    keysort(Triangles0, Triangles),
    list_to_assoc(Vertices, Place),
    mean_normal(Surface, Triangles, Place, N),
    border(Surface, Triangles, Border),
    bottom(N, Box, Vertices, Low, Deep),
    findall(V, member(V-_, Border), Rim0),
    sort(Rim0, Rim),
    maplist(dropped(Place, N, Low), Rim, Ring),
    middle(Ring, Middle),
    moved(Middle, N, Deep, Apex),
    findall(P, member(_-P, Vertices), Points0),
    append([Points0, Ring, [Apex]], Points),
    numbers(Vertices, Rim, Number),
    maplist(numbered(Number), Triangles, Front),
    findall(Face, ( member(Edge, Border), skirt_face(Edge, Number, Face) ),
            Skirt),
    append(Front, Skirt, Faces).

%   mean_normal(Surface, Triangles, Place, N): a unit vector; rounded.

mean_normal(Surface, Triangles, Place, [X,Y,Z]) :-
    foldl(turn_added(Place), Triangles, 0.0-[0.0,0.0,0.0], Area-[A,B,C]),
    Length is sqrt(A*A + B*B + C*C),
    (   Length > 0.01*Area
    ->  X is A/Length,
        Y is B/Length,
        Z is C/Length
    ;   csg_error(no_front(Surface))
    ).

turn_added(Place, _-Corners, Area0-[A0,B0,C0], Area-[A,B,C]) :-
    maplist(placed(Place), Corners, [[X1,Y1,Z1], [X2,Y2,Z2], [X3,Y3,Z3]]),
    U is (Y2-Y1)*(Z3-Z1) - (Z2-Z1)*(Y3-Y1),
    V is (Z2-Z1)*(X3-X1) - (X2-X1)*(Z3-Z1),
    W is (X2-X1)*(Y3-Y1) - (Y2-Y1)*(X3-X1),
    Area is Area0 + sqrt(U*U + V*V + W*W),
    A is A0+U,
    B is B0+V,
    C is C0+W.

placed(Place, V, Point) :-
    get_assoc(V, Place, Point).

%   border(Surface, Triangles, Border): the half-edges A-B without an opposite.

border(Surface, Triangles, Border) :-
    findall(Edge, ( member(_-[A,B,C], Triangles),
                    member(Edge, [A-B, B-C, C-A]) ),
            Edges0),
    sort(Edges0, Edges),
    (   same_length(Edges0, Edges)
    ->  true
    ;   csg_error(no_front(Surface))    % two run along an edge the same way
    ),
    findall(A-B, ( member(A-B, Edges), \+ ord_memberchk(B-A, Edges) ),
            Border).

%   bottom(N, Box, Vertices, Low, Deep): Low is a height along N below all of
%   Box and of the surface; Deep, negative, how far below that the cap ends.

bottom(N, box(X1,Y1,Z1,X2,Y2,Z2), Vertices, Low, Deep) :-
    findall(H, ( ( member(X, [X1,X2]), member(Y, [Y1,Y2]),
                   member(Z, [Z1,Z2]),
                   P = [X,Y,Z]
                 ; member(_-P, Vertices)
                 ),
                 height(P, N, H) ),
            Heights),
    min_list(Heights, Least),
    max_list(Heights, Most),
    Size is max(Most-Least, sqrt((X2-X1)**2 + (Y2-Y1)**2 + (Z2-Z1)**2)),
    Low is Least - 0.1*Size,
    Deep is -0.1*Size.

height([X,Y,Z], [A,B,C], H) :-
    H is A*X + B*Y + C*Z.

moved([X0,Y0,Z0], [A,B,C], T, [X,Y,Z]) :-
    X is X0 + T*A,
    Y is Y0 + T*B,
    Z is Z0 + T*C.

dropped(Place, N, Low, V, Point) :-
    get_assoc(V, Place, Point0),
    height(Point0, N, H),
    T is Low-H,
    moved(Point0, N, T, Point).

middle(Points, [X,Y,Z]) :-
    aggregate_all(r(count, sum(A), sum(B), sum(C)),
                  member([A,B,C], Points), r(Count, U, V, W)),
    X is U/Count,
    Y is V/Count,
    Z is W/Count.

%   numbers(Vertices, Rim, Number): an association of V with the number of the
%   vertex, of low(V) with that below it, of apex.

numbers(Vertices, Rim, Number) :-
    length(Vertices, Count),
    findall(V-I, nth1(I, Vertices, V-_), Own),
    findall(low(V)-I, ( nth1(I0, Rim, V), I is I0+Count ), Low),
    length(Rim, RimCount),
    Last is Count+RimCount+1,
    append([Own, Low, [apex-Last]], Pairs),
    list_to_assoc(Pairs, Number).

numbered(Number, _-Vs, Is) :-
    maplist(number_of(Number), Vs, Is).

number_of(Number, V, I) :-
    get_assoc(V, Number, I).

%   skirt_face(Edge, Number, Face): the wall under an edge of the border, and
%   its part of the cap.

skirt_face(A-B, Number, Face) :-
    member(Vs, [[B,A,low(A)], [B,low(A),low(B)], [low(B),low(A),apex]]),
    maplist(number_of(Number), Vs, Face).
