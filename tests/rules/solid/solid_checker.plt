:- module(test_solid_checker, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(tests('rules/polyhedron')).
:- use_module(tests('rules/checked')).

/* The checker of results is checked itself: on meshes whose faults are known,
and on random heaps of triangles against a definition in rationals. */

%   said(+Options, +Points, +Faces, -Result): what it says of a mesh.

said(Options, Points, Faces, Result) :-
    setup_call_cleanup(
        tmp_file_stream(File, Stream, [extension(off)]),
        ( close(Stream),
          write_off(File, Points, Faces),
          checked(Options, [File], [Result])
        ),
        delete_file(File)).

said(Points, Faces, Result) :-
    said([], Points, Faces, Result).

box(Low, High, Points, Faces) :-
    box_points(Low, High, Points),
    box_faces(Faces).

%   Two meshes as one.

both(Points1, Faces1, Points2, Faces2, Points, Faces) :-
    length(Points1, N),
    maplist(maplist(plus(N)), Faces2, Moved),
    append(Points1, Points2, Points),
    append(Faces1, Moved, Faces).

two_boxes(Low1, High1, Low2, High2, Points, Faces) :-
    box(Low1, High1, Points1, Faces1),
    box(Low2, High2, Points2, Faces2),
    both(Points1, Faces1, Points2, Faces2, Points, Faces).

%   Of a result the keys that are asked.

has(Result, Wanted) :-
    Wanted :< Result.

:- begin_tests(solid_checker).

test(box, [true((V =:= 24, A =:= 52))]) :-
    box(p(0,0,0), p(2,3,4), Points, Faces),
    said(Points, Faces, R),
    has(R, _{good:yes, closed:yes, triangles:12, faces:6, euler:2,
             components:1, volume:V, area:A}).
test(open_box) :-
    box(p(0,0,0), p(1,1,1), Points, [_|Faces]),
    said(Points, Faces, R),
    has(R, _{good:no, closed:no, open:4, unbalanced:4, euler:1}).
test(one_face_turned) :-
    box(p(0,0,0), p(1,1,1), Points, [Face0|Faces]),
    reverse(Face0, Face),
    said(Points, [Face|Faces], R),
    has(R, _{good:no, closed:no, open:0, unbalanced:4}).
test(inside_out, [true(N =:= -1.0)]) :-
    box(p(0,0,0), p(1,1,1), Points, Faces0),
    maplist(reverse, Faces0, Faces),
    said(Points, Faces, R),
    has(R, _{volume:N, good:no, closed:yes, misturned:1}).
test(hollow, [true(N =:= 19.0)]) :-
    box(p(0,0,0), p(3,3,3), Points1, Faces1),
    box(p(0.5,0.5,0.5), p(2.5,2.5,2.5), Points2, Faces2),
    maplist(reverse, Faces2, Turned),
    both(Points1, Faces1, Points2, Turned, Points, Faces),
    said(Points, Faces, R),
    has(R, _{volume:N, good:yes, components:2, euler:4}).
test(box_in_a_box) :-
    two_boxes(p(0,0,0), p(3,3,3), p(1,1,1), p(2,2,2), Points, Faces),
    said(Points, Faces, R),
    has(R, _{good:no, closed:yes, crossing:0, misturned:1}).
test(crossing_boxes, [true(N > 0)]) :-
    two_boxes(p(0,0,0), p(2,2,2), p(1,1,1), p(3,3,3), Points, Faces),
    said(Points, Faces, R),
    has(R, _{crossing:N, good:no, closed:yes, overlap:0, in_line:0}).
test(flush_boxes, [true(N > 0)]) :-
    two_boxes(p(0,0,0), p(1,1,1), p(1,0.2,0.2), p(2,0.5,0.5), Points, Faces),
    said(Points, Faces, R),
    has(R, _{overlap:N, good:no, crossing:0}).
test(boxes_with_a_common_edge) :-
    two_boxes(p(0,0,0), p(1,1,1), p(1,1,0), p(2,2,1), Points, Faces),
    said(Points, Faces, R),
    has(R, _{good:yes, shared:1, pinched:2, components:1, in_line:0}),
    said(['-i'], Points, Faces, Copies),
    has(Copies, _{good:yes, shared:0, components:2}).
test(boxes_with_a_common_vertex) :-
    two_boxes(p(0,0,0), p(1,1,1), p(1,1,1), p(2,2,2), Points, Faces),
    said(Points, Faces, R),
    has(R, _{good:yes, shared:0, pinched:1, in_point:0, components:2}).
test(corner_on_a_face, [true(N > 0)]) :-
    box(p(0,0,0), p(2,2,2), Points1, Faces1),
    Points2 = [p(1,1.2,2), p(1,1,3), p(1.5,1,3), p(1,1.5,3)],
    Faces2 = [[1,3,2], [1,4,3], [1,2,4], [2,3,4]],
    both(Points1, Faces1, Points2, Faces2, Points, Faces),
    said(Points, Faces, R),
    has(R, _{in_point:N, good:yes, crossing:0, in_line:0}).
test(edge_on_a_face, [true(N > 0)]) :-
    box(p(0,0,0), p(4,4,1), Points1, Faces1),
    Points2 = [p(1,2,1), p(3,2,1), p(2,1,2), p(2,3,2)],
    Faces2 = [[1,2,4], [2,1,3], [3,4,2], [4,3,1]],
    both(Points1, Faces1, Points2, Faces2, Points, Faces),
    said(Points, Faces, R),
    has(R, _{in_line:N, good:no, crossing:0, overlap:0}).
test(no_area) :-
    box(p(0,0,0), p(1,1,1), Points0, [Face|Faces]),
    append(Points0, [p(0.5,0,0)], Points),
    Face = [A,B,C,D],
    said(Points, [[A,B,C],[A,C,D],[1,2,9]|Faces], R),
    has(R, _{good:no, zero_area:1}).
test(l_prism, [true(N =:= 3.0)]) :-
    Points = [ p(0,0,0),p(2,0,0),p(2,1,0),p(1,1,0),p(1,2,0),p(0,2,0),
               p(0,0,1),p(2,0,1),p(2,1,1),p(1,1,1),p(1,2,1),p(0,2,1) ],
    said(Points, [ [6,5,4,3,2,1],[7,8,9,10,11,12],[1,2,8,7],[2,3,9,8],
                   [3,4,10,9],[4,5,11,10],[5,6,12,11],[6,1,7,12] ], R),
    has(R, _{volume:N, good:yes, faces:8, triangles:20, unclear:0}).
test(a_hair_apart) :-
    Next is nexttoward(1.0, 2.0),
    two_boxes(p(0,0,0), p(1,1,1), p(Next,0,0), p(2,1,1), Points, Faces),
    said(Points, Faces, R),
    has(R, _{good:yes, components:2}).
test(a_hair_in, [true(N > 0)]) :-
    Next is nexttoward(1.0, 0.0),
    two_boxes(p(0,0,0), p(1,1,1), p(Next,0.5,0.5), p(2,2,2), Points, Faces),
    said(Points, Faces, R),
    has(R, _{crossing:N, good:no}).
test(not_there, [error(existence_error(mesh, 'tests/none.off'))]) :-
    checked(['tests/none.off'], _).

test(random_heaps, [forall(between(1, 6, Seed)), true(Said == Known)]) :-
    set_random(seed(Seed)),
    Grid is Seed mod 4+2,
    length(Triangles, 24),
    maplist(random_triangle(Grid), Triangles),
    append(Triangles, All),
    sort(All, Points),
    maplist(maplist(place(Points)), Triangles, Faces),
    said(Points, Faces, R),
    has(R, _{crossing:C, overlap:O, in_line:L, in_point:P}),
    Said = [C,O,L,P],
    findall(Kind,
            ( append(_, [T1|Rest], Triangles), member(T2, Rest),
              common(T1, T2, Kind) ),
            Kinds),
    maplist(times(Kinds), [crossing,overlap,in_line,in_point], Known).

:- end_tests(solid_checker).

/* - - - two triangles in rationals: one is clipped by the other - - - */

random_triangle(Grid, [A,B,C]) :-
    repeat,
    maplist(random_point(Grid), [A,B,C]),
    normal(A, B, C, N),
    N \== n(0,0,0),
    !.

random_point(Grid, p(X,Y,Z)) :-
    maplist(random_between(0, Grid), [X,Y,Z]).

place(Points, P, I) :-
    nth1(I, Points, P),
    !.

times(Kinds, Kind, N) :-
    aggregate_all(count, member(Kind, Kinds), N).

normal(p(X,Y,Z), p(X1,Y1,Z1), p(X2,Y2,Z2), n(A,B,C)) :-
    A is (Y1-Y)*(Z2-Z)-(Z1-Z)*(Y2-Y),
    B is (Z1-Z)*(X2-X)-(X1-X)*(Z2-Z),
    C is (X1-X)*(Y2-Y)-(Y1-Y)*(X2-X).

height(n(A,B,C), p(X0,Y0,Z0), p(X,Y,Z), H) :-
    H is A*(X-X0)+B*(Y-Y0)+C*(Z-Z0).

%   common(+T1, +T2, -Kind): fails if they have nothing but shared corners and
%   the edge between two.

common(T1, [A,B,C], Kind) :-
    normal(A, B, C, N),
    opposite(N, Back),
    clipped(T1, N, A, P1),
    clipped(P1, Back, A, P2),
    foldl(inner_side(N), [A-B,B-C,C-A], P2, P3),
    sort(P3, Points),
    Points \== [],
    kind(Points, T1, [A,B,C], Kind).

opposite(n(A0,B0,C0), n(A,B,C)) :-
    A is -A0, B is -B0, C is -C0.

inner_side(n(A,B,C), p(X,Y,Z)-p(X1,Y1,Z1), Polygon0, Polygon) :-
    Mx is B*(Z1-Z)-C*(Y1-Y),
    My is C*(X1-X)-A*(Z1-Z),
    Mz is A*(Y1-Y)-B*(X1-X),
    clipped(Polygon0, n(Mx,My,Mz), p(X,Y,Z), Polygon).

%   clipped(+Polygon0, +N, +P, -Polygon): what is not below the plane.

clipped([], _, _, []) :-
    !.
clipped(Polygon0, N, P, Polygon) :-
    Polygon0 = [First|Rest],
    append(Rest, [First], Nexts),
    foldl(clipped_edge(N, P), Polygon0, Nexts, Polygon, []).

clipped_edge(N, P, A, B, Points0, Points) :-
    height(N, P, A, Ha),
    height(N, P, B, Hb),
    (   Ha >= 0
    ->  Points0 = [A|Points1]
    ;   Points0 = Points1
    ),
    (   Ha*Hb < 0
    ->  A = p(X,Y,Z),
        B = p(X1,Y1,Z1),
        T is Ha rdiv (Ha-Hb),
        X2 is X+T*(X1-X), Y2 is Y+T*(Y1-Y), Z2 is Z+T*(Z1-Z),
        Points1 = [p(X2,Y2,Z2)|Points]
    ;   Points1 = Points
    ).

kind([Point], T1, T2, in_point) :-
    !,
    \+ ( member(Point, T1), member(Point, T2) ).
kind([A,B|Rest], _, _, overlap) :-
    member(C, Rest),
    normal(A, B, C, N),
    N \== n(0,0,0),
    !.
kind(Points, T1, T2, Kind) :-
    Points = [A|_],
    last(Points, B),
    \+ ( member(A, T1), member(A, T2), member(B, T1), member(B, T2) ),
    (   straddles(T1, T2),
        straddles(T2, T1)
    ->  Kind = crossing
    ;   Kind = in_line
    ).

straddles(T1, [A,B,C]) :-
    normal(A, B, C, N),
    maplist(height(N, A), T1, Hs),
    min_list(Hs, Low),
    max_list(Hs, High),
    Low < 0,
    High > 0.
