/* What is glued: counts by hand and by arithmetic, in place and turned; the
   regions, what each is inside, and taking it apart again.
   covers: coincident_faces, solid_seams, glue_wire */
:- module(test_glue, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(library(yall)).
:- use_module(rules(gluing/cycle)).
:- use_module(rules(gluing/regions)).
:- use_module(rules(model/model)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(solid/glue)).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

/* - - - models - - - */

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
model(book(K), Pages, c(V,E,K,K,1,1,1,0)) :-
    member(K, [1,2,3,8,64]),
    findall(Page, book_page(K, Page), Pages),
    V is 2+2*K,
    E is 1+3*K.
model(cubes(N), Boxes, c(V,E,F,F,1,R,R,0)) :-
    member(N, [1,2,3]),
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

:- dynamic quiet/0.
:- multifile user:message_hook/3.

user:message_hook(_, warning, _) :-
    test_glue:quiet.

:- begin_tests(glue).

test(counts, [forall(model(_, Parts, Wanted)), Counts == Wanted]) :-
    glue_counts(Parts, [], Counts).

test(turned, [ forall(( model(_, Parts, Wanted), member(Seed, [1,2,3]) )),
               Counts == Wanted ]) :-
    turned(Seed, Steps),
    glue_counts(Parts, Steps, Counts).

%   The paper's figures, as they are in files.

test(figures, [ forall(figure(Name, Wanted)), Counts == Wanted ]) :-
    atomic_list_concat(['facts/figures/glue_',Name,'.pl'], File),
    in_new_world(( load_model(File),
                   once(( segment(S, cells, _), region(S, _, _) )),
                   glue_report(S, Report) )),
    report_counts(Report, Counts).

figure(materials, c(58,91,38,38,1,5,5,0)).
figure(vertex, c(14,25,15,15,1,4,4,0)).
figure(crossing, c(13,28,21,21,1,6,6,0)).
figure(edge, c(14,18,5,5,1,1,1,0)).
figure(face, c(18,28,13,13,1,3,3,0)).
figure(mixed, c(24,38,21,23,1,5,5,0)).

%   Figure 1: cells of two materials, two each; two wires in the outside.

test(materials, Insides-Wires == [[1],[1],[2],[2],[]]-2) :-
    in_new_world(( load_model('facts/figures/glue_materials.pl'),
                   glue_report(6, Report) )),
    findall(Inside, ( member(Region, Report.regions),
                      Inside = Region.inside ), Insides0),
    msort(Insides0, [[]|Insides1]),
    append(Insides1, [[]], Insides),
    last(Report.regions, Outside),
    Wires = Outside.wires.

%   Figure 6: the order of the five pages, by the right hand.

test(pages, Ss == [1,2,3,4,5]) :-
    in_new_world(( load_model('facts/figures/glue_edge.pl'),
                   v(6, A, 0.0, 0.0, 1.0),
                   v(6, B, 0.0, 0.0, 3.0),
                   in_order(A, B, V1, V2, Way),
                   radial_cycle(6, V1, V2, Pages),
                   findall(S, ( member(page(P,_,_), Pages),
                                from_p(6, P, S, _, _) ), Ss0) )),
    turned_to(Way, Ss0, Ss1),
    once(append(Before, [1|After], Ss1)),
    append([1|After], Before, Ss).

in_order(A, B, A, B, 1) :-
    A < B,
    !.
in_order(A, B, B, A, -1).

turned_to(1, Ss, Ss).
turned_to(-1, Ss0, Ss) :-
    reverse(Ss0, Ss).

%   52 rooms of a building, their walls off by 1e-9: 52 cells, none of them
%   flat.

test(rooms, [ setup(asserta(test_glue:quiet, Ref)), cleanup(erase(Ref)),
              Counts-Flat == c(140,312,225,225,1,53,53,0)-0 ]) :-
    set_random(seed(5)),
    findall(size([A,B,C], [X,Y,Z]),
            ( between(0, 3, I),
              between(0, 12, J),
              maplist(noisy, [4,3,2.5,4*I,3*J,0], [A,B,C,X,Y,Z]) ),
            Rooms),
    in_new_world(( numlist(1, 52, Ss),
                   maplist(part_made([]), Ss, Rooms),
                   assert_fact(segment(53, cells, glue(Ss))),
                   evaluate(53, [tolerance(1.0e-8)]),
                   glue_report(53, Report) )),
    report_counts(Report, Counts),
    aggregate_all(count,
                  ( member(Region, Report.regions),
                    Region.role == cell,
                    Region.volume < 29.9 ),
                  Flat).

noisy(N0, N) :-
    random(-1.0e-9, 1.0e-9, Noise),
    N is N0+Noise.

%   A box and K sheets in general position, larger than it: its cells are as
%   many as K planes can make, if all of them meet inside; and so many if all go
%   through one point.

test(cake, [ forall(member(K-Cells, [1-2,2-4,3-8,4-15])), N == Cells ]) :-
    findall(Sheet, general_sheet(K, 1, Sheet), Sheets),
    cells_inside([box(4,[0,0,-2])|Sheets], N).
test(one_point, [ forall(member(K, [1,2,3,4])), N == Cells ]) :-
    findall(Sheet, general_sheet(K, 0, Sheet), Sheets),
    cells_inside([box(4,[0,0,-2])|Sheets], N),
    Cells is K*K-K+2.

cells_inside(Parts, N) :-
    in_new_world(( glue_made(Parts, [], S),
                   glue_report(S, Report) )),
    aggregate_all(count,
                  ( member(Region, Report.regions), Region.inside == [1] ),
                  N).

%   general_sheet(K, Off, Sheet): A*X + B*Y + C*Z = Off*D.

general_sheet(K, Off, plane_sheet(Plane, Off)) :-
    between(1, K, I),
    nth1(I, [p(3,1,1,0.2), p(-1,3,1,0.3), p(1,-1,3,-0.4), p(2,3,-3,0.1)],
         Plane).

%   What each region is inside: two boxes that cross, a wall round a hollow.

test(inside, Insides == [[1],[1,2],[2],[]]) :-
    insides([box(2,[0,0,0]),box(2,[1,1,1])], Insides).

test(void, Roles == [cell,cell,cell,cell,cell,cell,outside,void]) :-
    model(room, Walls, _),
    in_new_world(( glue_made(Walls, [], S),
                   findall(Role, region(S, _, Role), Roles0) )),
    msort(Roles0, Roles).

insides(Parts, Insides) :-
    in_new_world(( glue_made(Parts, [], S),
                   glue_report(S, Report) )),
    findall(Inside, ( member(Region, Report.regions),
                      Inside = Region.inside ), Insides0),
    sort(Insides0, Insides1),
    selectchk([], Insides1, Others),
    append(Others, [[]], Insides).

%   A face that two operands have is there once, and comes from both.

test(shared, Froms == [[1-1,2-(-1)]]) :-
    model(fig7, Parts, _),
    in_new_world(( glue_made(Parts, [], S),
                   findall(Pairs,
                           ( p(S, P, _),
                             findall(S0-Sense, from_p(S, P, S0, _, Sense),
                                     Pairs0),
                             sort(Pairs0, Pairs),
                             Pairs = [_,_|_] ),
                           Froms0) )),
    Froms0 = Froms.

%   The edge of the paper's figure 6: its pages on each part of it.

test(fig6, Lengths == [[3],[5],[2]]) :-
    model(fig6, Parts, _),
    in_new_world(( glue_made(Parts, [], S),
                   findall(Ns, axis_pages(S, Ns), Lengths) )).

axis_pages(S, Ns) :-
    member(Z1-Z2, [0.0-1.0,1.0-3.0,3.0-4.0]),
    v(S, A, 0.0, 0.0, Z1),
    v(S, B, 0.0, 0.0, Z2),
    msort([A,B], [V1,V2]),
    findall(N, ( radial_cycle(S, V1, V2, Pages), length(Pages, N) ), Ns).

%   Figure 8 b and c: a point loop, and a seam that the radial cycle has once.

test(point_loop, Point == [0.3,0.2,1.0]) :-
    model(fig8(face), Parts, _),
    in_new_world(( glue_made(Parts, [], S),
                   lies_in(S, v(V), p(P)),
                   v(S, V, X, Y, Z),
                   from_p(S, P, 1, _, 1) )),
    Point = [X,Y,Z].

test(seam, N-Twice == 3-1) :-
    model(fig8(ridge), Parts, _),
    in_new_world(( glue_made(Parts, [], S),
                   v(S, A, -1.0, 0.0, 1.0),
                   v(S, B, 1.0, 0.0, 1.0),
                   msort([A,B], [V1,V2]),
                   radial_cycle(S, V1, V2, Pages),
                   length(Pages, Sides),
                   sort(0, @<, Pages, _),
                   findall(P, member(page(P,_,_), Pages), Ps0),
                   sort(Ps0, Ps),
                   length(Ps, N) )),
    Twice is Sides-N.

%   Glue in glue is flat, and a Boolean of a glue is one of its solids.

test(flat, Counts == c(12,20,11,11,1,3,3,0)) :-
    in_new_world(( maplist(part_made([]), [1,2],
                           [box(1,[0,0,0]),box(1,[1,0,0])]),
                   assert_fact(segment(3, cells, glue([1,2]))),
                   assert_fact(segment(4, cells, glue([3,1]))),
                   evaluate(4),
                   glue_report(4, Report) )),
    report_counts(Report, Counts).

test(boolean, Volume =:= 1.5) :-
    in_new_world(( maplist(part_made([]), [1,2,3],
                           [ box(1,[0,0,0]),box(1,[1,0,0]),
                             size([2,1,1],[0.5,0,0.25]) ]),
                   assert_fact(segment(4, solid,
                                       intersection([glue([1,2]),3]))),
                   evaluate(4),
                   regions_report(4, Report) )),
    [Cell,_] = Report.regions,
    Volume = Cell.volume.

%   An edit makes the glue stale; undo needs no evaluation.

test(again, Counts == c(16,24,12,12,2,3,4,0)) :-
    in_new_world(( glue_made([box(1,[0,0,0]),box(1,[1,0,0])], [], S),
                   retractall_facts(segment(2, _, _)),
                   part_made([], 2, box(1,[3,0,0])),
                   evaluate(S),
                   glue_report(S, Report) )),
    report_counts(Report, Counts).

%   Taken apart, everything is as before it was glued.

test(unglue, After-N == Before-16) :-
    in_new_world(( maplist(part_made([]), [1,2],
                           [box(1,[0,0,0]),box(1,[1,0,0])]),
                   glued_apart,
                   all_rows(Before),
                   glued_apart,
                   all_rows(After),
                   aggregate_all(count, v(_,_,_,_,_), N) )).

glued_apart :-
    assert_fact(segment(3, cells, glue([1,2]))),
    evaluate(3),
    unglue(3).

all_rows(Rows) :-
    findall(v(A,B,C,D,E), v(A,B,C,D,E), Vs),
    findall(e(A,B,C,D,E), e(A,B,C,D,E), Es),
    findall(p(A,B,C), p(A,B,C), Ps),
    findall(segment(A,B,C), segment(A,B,C), Ss),
    findall(r(A,B,C), region(A,B,C), Rs),
    append([Vs,Es,Ps,Ss,Rs], Rows).

test(unglue_none, error(existence_error(segment, 7))) :-
    in_new_world(unglue(7)).
test(unglue_other, error(type_error(glue, 1))) :-
    in_new_world(( part_made([], 1, box(1,[0,0,0])), unglue(1) )).

/* - - - bad input: nothing is glued - - - */

open_box(polyhedron(points([[0,0,0],[1,0,0],[1,1,0],[0,1,0],[0,0,1],[1,0,1],
                            [1,1,1],[0,1,1]]),
                    faces([[1,4,3,2],[1,2,6,5],[2,3,7,6],[3,4,8,7],
                           [4,1,5,8]]))).

test(open, [ error(geometry_error(operand(1, [open_edges(4, _)]))) ]) :-
    in_new_world(( open_rows(1, solid),
                   part_made([], 2, box(1,[1,0,0])),
                   assert_fact(segment(3, cells, glue([1,2]))),
                   evaluate(3) )).

%   As a surface it is glued: its walls are laminar.

test(open_surface, Counts == c(12,20,10,10,1,2,2,0)) :-
    in_new_world(( open_rows(1, surface),
                   part_made([], 2, box(1,[1.5,0.5,0])),
                   assert_fact(segment(3, cells, glue([1,2]))),
                   evaluate(3),
                   glue_report(3, Report) )),
    report_counts(Report, Counts).

open_rows(S, Kind) :-
    open_box(polyhedron(points(Points), faces(Faces))),
    point_rows(S, Points),
    forall(nth1(P, Faces, Vs), loop_rows(S, P, Vs)),
    assert_fact(segment(S, Kind, open_box)).

point_rows(S, Points) :-
    forall(nth1(V, Points, [X0,Y0,Z0]),
           ( X is float(X0),
             Y is float(Y0),
             Z is float(Z0),
             assert_fact(v(S, V, X, Y, Z)) )).

loop_rows(S, P, [A|Rest]) :-
    append(Rest, [A], Next),
    forall(( nth1(I, [A|Rest], From), nth1(I, Next, To) ),
           ( E is 4*P+I,
             assert_fact(e(S, E, From, To, 1)) )),
    findall(E, ( nth1(I, Next, _), E is 4*P+I ), Es),
    assert_fact(p(S, P, Es)).

test(gap, Counts == c(16,24,12,12,2,3,4,0)) :-
    glue_counts([box(1,[0,0,0]),box(1,[1.001,0,0])], [], Counts).

test(noise, Counts == c(12,20,11,11,1,3,3,0)) :-
    in_new_world(( maplist(part_made([]), [1,2],
                           [box(1,[0,0,0]),box(1,[1.0000000000000002,0,0])]),
                   assert_fact(segment(3, cells, glue([1,2]))),
                   evaluate(3),
                   glue_report(3, Report) )),
    report_counts(Report, Counts).

test(twice, Counts == c(8,12,6,6,1,2,2,0)) :-
    glue_counts([box(1,[0,0,0]),box(1,[0,0,0])], [], Counts).

%   A solid whose faces all look in is glued as one whose faces look out.

test(inside_out, [ forall(member(Way, [out,in])),
                   Counts-Volumes == c(12,20,11,11,1,3,3,0)-[1.0,1.0] ]) :-
    in_new_world(( part_made([], 1, box(1,[0,0,0])),
                   box_rows(2, Way, [0.5,-0.5,0]),
                   once(p(2, 1, _)),
                   assert_fact(segment(3, cells, glue([1,2]))),
                   evaluate(3),
                   glue_report(3, Report),
                   findall(Inside,
                           ( member(Region, Report.regions),
                             Inside = Region.inside ),
                           Insides) )),
    report_counts(Report, Counts),
    Insides == [[1],[2],[]],
    findall(Volume, ( member(Region, Report.regions),
                      Region.role == cell,
                      Volume0 = Region.volume,
                      Volume is round(Volume0*1.0e9)/1.0e9 ), Volumes).

%   box_rows(S, Way, Low): a unit cube as rows, its faces looking out or in.

box_rows(S, Way, Low) :-
    open_box(polyhedron(points(Points0), faces(Open))),
    maplist(maplist([A,B,C]>>(C is A+B), Low), Points0, Points),
    append(Open, [[5,6,7,8]], Out),
    (   Way == out
    ->  Faces = Out
    ;   maplist(reverse, Out, Faces)
    ),
    point_rows(S, Points),
    forall(nth1(P, Faces, Vs), loop_rows(S, P, Vs)),
    assert_fact(segment(S, solid, rows)).

%   A wire that runs in a face is refused; nothing is glued.

test(wire_in_face, [ error(geometry_error(glue_wire(2, 1, _))) ]) :-
    glue_counts([box(2,[0,0,0]),wire([0,0,2], [0.5,0,2])], [], _).
test(wire_on_edge, [ error(geometry_error(glue_wire(2, 1, _))) ]) :-
    glue_counts([box(2,[0,0,0]),wire([1,1,1], [3,3,1])], [], _).

test(placed, error(model_error(csg(placed(_))))) :-
    in_new_world(( part_made([], 1, box(1,[0,0,0])),
                   assert_fact(segment(2, cells,
                                       at([translate(1,0,0)], glue([1])))),
                   evaluate(2) )).

test(joined, error(model_error(csg(cells(3, 2, join))))) :-
    in_new_world(( part_made([], 1, box(1,[0,0,0])),
                   assert_fact(segment(2, cells, glue([1]))),
                   assert_fact(segment(3, solid, join([1,2]))),
                   evaluate(3) )).

:- end_tests(glue).
