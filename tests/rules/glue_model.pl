/* What is glued in tests: parts, and what must come out of them, by hand and by
   arithmetic. */
:- module(glue_model,
          [ model/3,                    % ?Name, -Parts, -Counts
            glue_made/3,                % +Parts, +Steps, -S
            glue_counts/3,              % +Parts, +Steps, -Counts
            report_counts/2,            % +Report, -Counts
            part_made/3,                % +Steps, +S, +Part
            turned/2                    % +Seed, -Steps
          ]).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(yall)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(solid/glue)).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   A model is a list of terms. c(V, E, F, L, C, R, S, G): what comes out.

model(two(apart), [box(1,[0,0,0]),box(1,[3,0,0])], c(16,24,12,12,2,3,4,0)).
model(two(vertex), [box(1,[0,0,0]),box(1,[1,1,1])], c(15,24,12,12,1,3,3,0)).
model(two(edge), [box(1,[0,0,0]),box(1,[1,1,0])], c(14,23,12,12,1,3,3,0)).
model(two(half_edge), [box(1,[0,0,0]),box(1,[1,1,0.5])],
      c(16,25,12,12,1,3,3,0)).
model(two(face), [box(1,[0,0,0]),box(1,[1,0,0])], c(12,20,11,11,1,3,3,0)).
model(two(nested), [box(3,[0,0,0]),box(1,[0,0,1])], c(16,24,12,12,2,3,4,0)).
model(two(crossing), [box(2,[0,0,0]),box(2,[1,1,1])],
      c(22,36,18,18,1,4,4,0)).
model(on_plate, [size([4,4,1],[0,0,0]),box(1,[0,0,1])],
      c(16,24,12,13,1,3,3,0)).
model(fig7, [size([2,2,1],[0,0,0]),size([2,2,1],[1,1,1])],
      c(18,28,13,13,1,3,3,0)).
model(fig8(edge), [size([4,4,1],[0,0,0]),tip([2,0.2,1])],
      c(13,21,11,11,1,3,3,0)).
model(fig8(face), [size([4,4,1],[0,0,0]),tip([0.3,0.2,1])],
      c(13,20,11,12,1,3,3,0)).
model(fig8(ridge), [size([8,8,1],[0,0,0]),roof(1)],
      c(14,21,11,12,1,3,3,0)).
model(fig6, [page(0,3,2,0),page(0,3,1,2),page(0,3,-1,2),page(1,4,-2,-1),
             page(1,4,1,-2)],
      c(14,18,5,5,1,1,1,0)).
model(fig4, [pyramid([[-4,-1,-1],[-4,1,-1],[-4,1,1],[-4,-1,1]]),
             pyramid([[-4,-4,6],[4,-4,6],[4,4,6],[-4,4,6]]),
             pyramid([[-1,-1,3],[1,-1,3],[1,1,3],[-1,1,3]])],
      c(13,24,15,15,1,4,4,0)).
model(fig5, [pyramid([[10,-1,-10],[10,1,-10],[10,1,10],[10,-1,10]]),
             pyramid([[10,-10,-1],[10,10,-1],[10,10,1],[10,-10,1]])],
      c(13,28,21,21,1,6,6,0)).
model(plate_through, [box(2,[0,0,0]),size([4,4,1],[0,0,0.5])], Counts) :-
    Counts = c(24,40,22,24,1,5,5,1).
model(flush_sheet, [box(2,[0,0,0]),flat(2,2,1)], c(12,20,11,11,1,3,3,0)).
model(large_sheet, [box(2,[0,0,0]),flat(4,4,1)], c(16,24,12,13,1,3,3,0)).
model(sheet(into), [box(2,[0,0,0]),Sheet], c(14,19,8,9,1,2,2,0)) :-
    Sheet = square([[-0.5,0.5,1],[0.5,0.5,1],[0.5,1.5,1],[-0.5,1.5,1]]).
model(sheet(out_of_three), [box(2,[0,0,0]),Sheet], c(16,23,9,9,1,2,2,0)) :-
    Sheet = square([[0,0,-1],[0,2,-1],[0,2,3],[0,0,3]]).
model(book(K), Pages, c(V,E,K,K,1,1,1,0)) :-
    member(K, [1,2,3,8,64,1024]),
    findall(Page, book_page(K, Page), Pages),
    V is 2+2*K,
    E is 1+3*K.
model(cubes(N), Boxes, c(V,E,F,F,1,R,R,0)) :-
    member(N, [1,2,3,4]),
    M is N-1,
    findall(box(1,[X,Y,Z]),
            ( between(0, M, X), between(0, M, Y), between(0, M, Z) ), Boxes),
    V is (N+1)**3,
    E is 3*N*(N+1)**2,
    F is 3*N*N*(N+1),
    R is N**3+1.
model(room, Walls, c(32,60,36,36,1,8,8,0)) :-
    Walls = [ size([5,5,1],[0,0,-1]),size([5,5,1],[0,0,3]),
              size([1,5,3],[-2,0,0]),size([1,5,3],[2,0,0]),
              size([3,1,3],[0,-2,0]),size([3,1,3],[0,2,0]) ].
model(nested(K), Boxes, c(V,E,F,F,K,R,S,0)) :-
    member(K, [1,2,5]),
    findall(box(Size,[0,0,Low]),
            ( between(1, K, I), Size is 2*I, Low is -I ), Boxes),
    V is 8*K,
    E is 12*K,
    F is 6*K,
    R is K+1,
    S is 2*K.
model(six_pyramids, Pyramids, c(9,20,18,18,1,7,7,0)) :-
    findall(pyramid(Face), cube_face(Face), Pyramids).
model(frame(plug), [frame,size([1,1,1],[0,0,0])], c(16,24,12,14,1,3,3,1)).
model(frame(alone), [frame], c(16,24,10,12,1,2,2,2)).

%   Wires: figure 4 with its wire; a cube with a wire and a cube at a corner;
%   one through a cell; one from inside to a face; one along an edge; one alone.

model(fig4(wire), [wire([0,0,0], [0,0,-3])|Parts], c(14,25,15,15,1,4,4,0)) :-
    model(fig4, Parts, _).
model(wire(corner), [box(1,[0,0,0]),box(1,[1,1,1]),
                     wire([0.5,0.5,1], [0.7,0.2,3])],
      c(16,25,12,12,1,3,3,0)).
model(wire(through), [box(2,[0,0,0]),wire([0,0.1,-1], [0.1,0.3,5])],
      c(12,15,6,8,1,2,2,1)).
model(wire(inside), [box(2,[0,0,0]),wire([0,0.1,1], [0.1,0.25,2])],
      c(10,13,6,7,1,2,2,0)).
model(wire(edge), [box(2,[0,0,0]),wire([1,1,0], [1,1,2])],
      c(8,12,6,6,1,2,2,0)).
model(wire(alone), [box(2,[0,0,0]),wire([4,0,0], [5,0,0])],
      c(10,13,6,6,2,2,3,0)).

%   Wires in the top of a box: from its middle, to an edge in its middle, right
%   across, from beyond to beyond, from corner to corner, crossing, round a
%   part of it, from a hole to the border; at the middle of an edge; a hair
%   above; two that cross in space.

model(wire(in_face), [box(2,[0,0,0]),wire([0,0,2], [0.5,0,2])],
      c(10,13,6,7,1,2,2,0)).
model(wire(to_edge), [box(2,[0,0,0]),wire([0,0,2], [1,0,2])],
      c(10,14,6,6,1,2,2,0)).
model(wire(across), [box(2,[0,0,0]),wire([-1,0,2], [1,0,2])],
      c(10,15,7,7,1,2,2,0)).
model(wire(beyond), [box(2,[0,0,0]),wire([-2,0,2], [2,0,2])],
      c(12,17,7,7,1,2,2,0)).
model(wire(corners), [box(2,[0,0,0]),wire([-1,-1,2], [1,1,2])],
      c(8,13,7,7,1,2,2,0)).
model(wire(crossing), [box(2,[0,0,0]),wire([-0.5,0,2], [0.5,0,2]),
                       wire([0,-0.5,2], [0,0.5,2])],
      c(13,16,6,7,1,2,2,0)).
model(wire(crossing_across), [box(2,[0,0,0]),wire([-1,0,2], [1,0,2]),
                              wire([0,-2,2], [0,2,2])],
      c(15,22,9,9,1,2,2,0)).
model(wire(round), [box(2,[0,0,0])|Wires], c(12,16,7,8,1,2,2,0)) :-
    Points = [[-0.5,-0.5,2],[0.5,-0.5,2],[0.5,0.5,2],[-0.5,0.5,2]],
    append(Points, [[-0.5,-0.5,2]], Round),
    findall(wire(A, B), nextto(A, B, Round), Wires).
model(wire(hole), [frame,wire([0.5,0,1], [1.5,0,1])],
      c(18,27,10,11,1,2,2,2)).
model(wire(at_edge), [box(2,[0,0,0]),wire([1,1,1], [3,3,1])],
      c(10,14,6,6,1,2,2,0)).
model(wire(hair), [box(2,[0,0,0]),wire([-1,0.3,2.0000000000001], [1,0,2])],
      c(10,15,7,7,1,2,2,0)).
model(wire(in_space), [wire([0,0,0], [2,2,0]),wire([0,2,0], [2,0,0])],
      c(5,4,0,0,1,1,1,0)).
model(wire(near_edge), [box(2,[0,0,0]),
                        wire([1.0000000000001,0.3,1], [3,0.3,1]),
                        wire([2,-1,1.0000000000001], [2,1,1])],
      c(13,16,6,7,1,2,2,0)).
model(wire(in_shared), [box(1,[0,0,0]),box(1,[1,0,0]),
                        wire([0.5,-0.5,0.5], [0.5,0.5,0.5])],
      c(14,23,12,12,1,3,3,0)).
model(wire(triangle), Wires, c(3,3,0,0,1,1,1,1)) :-
    wires([[0,0,0],[1,0,0],[0,1,0]], [1-2,2-3,3-1], Wires).
model(wire(tetrahedron), Wires, c(4,6,0,0,1,1,1,3)) :-
    wires([[0,0,0],[1,0,0],[0,1,0],[0,0,1]], [1-2,2-3,3-1,1-4,2-4,3-4],
          Wires).
model(wire(cube), Wires, c(8,12,0,0,1,1,1,5)) :-
    findall([X,Y,Z], ( member(X, [0,1]), member(Y, [0,1]), member(Z, [0,1]) ),
            Points),
    wires(Points, [1-2,3-4,5-6,7-8,1-3,2-4,5-7,6-8,1-5,2-6,3-7,4-8], Wires).
model(wire(only), [wire([4,0,0], [5,0,0])], c(2,1,0,0,1,1,1,0)).

%   A closed book of K wedges about an axis; cubes of six tetrahedra each; a box
%   and general sheets through it, larger than it: cake numbers; planes through
%   one point of it.

model(closed_book(K), Wedges, c(V,E,F,F,1,R,R,0)) :-
    member(K, [3,4,7]),
    findall(Wedge, wedge(K, Wedge), Wedges),
    V is 2*K+2,
    E is 5*K+1,
    F is 4*K,
    R is K+1.
model(tetrahedra(N), Tetrahedra, c(V,E,F,F,1,R,R,0)) :-
    member(N, [1,2]),
    M is N-1,
    findall(tetrahedron(Points),
            ( between(0, M, X), between(0, M, Y), between(0, M, Z),
              kuhn([X,Y,Z], Points) ),
            Tetrahedra),
    V is (N+1)**3,
    E is 7*N**3+9*N**2+3*N,
    F is 12*N**3+6*N**2,
    R is 6*N**3+1.

%   Sheets are operands of any kind: a Moebius band, and two triangles that are
%   turned against each other. A face that two sheets have is there once.

model(moebius, Faces, c(7,14,7,7,1,1,1,1)) :-
    findall(triangle([A,B,C]),
            ( between(0, 6, I),
              maplist(border_point(I), [0,1,2], [A,B,C]) ),
            Faces).
model(sheet(square), [flat(1,1,0)], c(4,4,1,1,1,1,1,0)).
model(against, [triangle([[0,0,0],[1,0,0],[0,1,0]]),
                triangle([[0,0,0],[1,0,0],[0,0,1]])],
      c(4,5,2,2,1,1,1,0)).
model(doubled, [flat(2,2,1),turned_flat(2,2,1)], c(4,4,1,1,1,1,1,0)).

wedge(K, prism([[0,0]|Ends])) :-
    between(1, K, I),
    findall([X,Y],
            ( member(J, [0,1]),
              A is 2*pi*((I+J) mod K)/K,
              X is cos(A),
              Y is sin(A) ),
            Ends).

kuhn([X,Y,Z], [[X,Y,Z]|Points]) :-
    permutation([0,1,2], Axes),
    foldl(axis_step, Axes, Points, [X,Y,Z], _).

axis_step(Axis, Next, Point, Next) :-
    nth0(Axis, Point, N0, Others),
    N is N0+1,
    nth0(Axis, Next, N, Others).

border_point(I, More, [X,Y,Z]) :-
    S is 4*pi*((4*(I+More)) mod 7)/7,
    X is (2+cos(S/2))*cos(S),
    Y is (2+cos(S/2))*sin(S),
    Z is sin(S/2).

book_page(K, page(0,1,X,Y)) :-
    between(1, K, I),
    A is 2*pi*I/K,
    X is cos(A),
    Y is sin(A).

cube_face(Face) :-
    member(Axis, [0,1,2]),
    member(Side, [-1,1]),
    findall(Point,
            ( member(U-V, [(-1)-(-1),1-(-1),1-1,(-1)-1]),
              nth0(Axis, Point, Side, [U,V]) ),
            Face).

%   term(Part, Term)

term(box(A, At), Term) :-
    term(size([A,A,A], At), Term).
term(size([A,B,C], [X,Y,Z]), at([translate(X,Y,Z)], box(size(A,B,C)))).
term(page(Z1, Z2, X, Y),
     sheet(points([[0,0,Z1],[0,0,Z2],[X,Y,Z1],[X,Y,Z2]]),
           faces([[1,3,4,2]]))).
term(wire([X1,Y1,Z1], [X2,Y2,Z2]), line(from(X1,Y1,Z1), to(X2,Y2,Z2))).
term(plane_sheet(p(A,B,C,D), Off),
     sheet(points([P1,P2,P3,P4]), faces([[1,2,3,4]]))) :-
    findall([X,Y,Z],
            ( member(X-Y, [(-9)-(-9),9-(-9),9-9,(-9)-9]),
              Z is (Off*D-A*X-B*Y)/C ),
            [P1,P2,P3,P4]).
term(triangle(Points), sheet(points(Points), faces([[1,2,3]]))).
term(square(Points), sheet(points(Points), faces([[1,2,3,4]]))).
term(turned_flat(A, B, Z),
     at([rotate(x,180),translate(0,0,Z)], rectangle(size(A,B)))).
term(tetrahedron([O,A,B,C]), polyhedron(points([O,A,B,C]), faces(Faces))) :-
    orientation(O, A, B, C, Sign),
    (   Sign > 0
    ->  Faces = [[1,3,2],[1,2,4],[2,3,4],[3,1,4]]
    ;   Faces = [[1,2,3],[1,4,2],[2,4,3],[3,4,1]]
    ).
term(prism([A,B,C]), polyhedron(points(Points),
                                faces([[3,2,1],[4,5,6],[1,2,5,4],[2,3,6,5],
                                       [3,1,4,6]]))) :-
    findall([X,Y,Z], ( member(Z, [0,1]), member([X,Y], [A,B,C]) ), Points).
term(flat(A, B, Z), at([translate(0,0,Z)], rectangle(size(A,B)))).
term(tip([X,Y,Z]), Term) :-
    Z1 is Z+1,
    findall([X1,Y1,Z1],
            ( member(U-V, [(-0.5)-(-0.5),0.5-(-0.5),0.5-0.5,(-0.5)-0.5]),
              X1 is X+U, Y1 is Y+V ),
            Base),
    term(cone([X,Y,Z], Base), Term).
term(pyramid(Base), Term) :-
    term(cone([0,0,0], Base), Term).
term(cone(Apex, Base), polyhedron(points([Apex|Base]), faces(Faces))) :-
    Out = [[2,3,4,5],[3,2,1],[4,3,1],[5,4,1],[2,5,1]],
    Base = [A,B,C|_],
    (   orientation(Apex, A, B, C, Sign),
        Sign > 0
    ->  Faces = Out
    ;   maplist(reverse, Out, Faces)
    ).
term(roof(Z),
     polyhedron(points([[-1,0,Z],[1,0,Z],[-1,-1,Z1],[1,-1,Z1],[1,1,Z1],
                        [-1,1,Z1]]),
                faces([[3,4,5,6],[1,2,4,3],[2,1,6,5],[1,3,6],[2,5,4]]))) :-
    Z1 is Z+1.
term(frame, difference([box(size(3,3,1)),
                        at([translate(0,0,-1)], box(size(1,1,3)))])).

%   orientation(O, A, B, C, Sign): of the determinant of A-O, B-O, C-O.

orientation(O, A, B, C, Sign) :-
    maplist(maplist([X,Y,Z]>>(Z is X-Y)), [A,B,C], [O,O,O],
            [[A1,A2,A3],[B1,B2,B3],[C1,C2,C3]]),
    Sign is A1*(B2*C3-B3*C2)-A2*(B1*C3-B3*C1)+A3*(B1*C2-B2*C1).

wires(Points, Pairs, Wires) :-
    findall(wire(A, B),
            ( member(I-K, Pairs), nth1(I, Points, A), nth1(K, Points, B) ),
            Wires).

%   glue_made(Parts, Steps, S): Parts, each placed by Steps, and the glue S.

glue_made(Parts, Steps, S) :-
    length(Parts, N),
    numlist(1, N, Ss),
    maplist(part_made(Steps), Ss, Parts),
    S is N+1,
    assert_fact(segment(S, cells, glue(Ss))),
    evaluate(S).

part_made(Steps, S, Part) :-
    term(Part, Term),
    assert_fact(segment(S, solid, at(Steps, named(part, Term)))).

glue_counts(Parts, Steps, Counts) :-
    in_new_world(( glue_made(Parts, Steps, S),
                   glue_report(S, Report) )),
    report_counts(Report, Counts).

report_counts(Report, c(V,E,F,L,C,R,S,G)) :-
    _{ vertices:V, edges:E, faces:F, loops:L, parts:C, regions:R, shells:S,
       genus:G } :< Report.counts.

turned(Seed, [rotate(axis(X,Y,Z),Angle),translate(A,B,C)]) :-
    set_random(seed(Seed)),
    randoms(X, Y, Z),
    random(0.0, 360.0, Angle),
    randoms(A, B, C).

randoms(X, Y, Z) :-
    maplist(random(-3.0, 3.0), [X,Y,Z]).
