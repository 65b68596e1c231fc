/* Regions of soups of faces: counts against arithmetic, both laws in each.
   covers: gluing */
:- module(test_regions, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(yall)).
:- use_module(rules(gluing/regions)).
:- use_module(rules(model/integrity)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(store)).
:- use_module(tests(rules/gluing/face_soup)).
:- use_module(tests(rules/gluing/turned_soup)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

:- dynamic hearing/0, dropped/1.
:- multifile user:message_hook/3.

user:message_hook(sanggwan(operand(repaired(duplicate, Count), _)), warning,
                  _) :-
    test_regions:hearing,
    assertz(test_regions:dropped(Count)).

:- meta_predicate heard(0, -).

heard(Goal, Counts) :-
    retractall(dropped(_)),
    setup_call_cleanup(asserta(hearing, Ref), once(Goal), erase(Ref)),
    findall(Count, dropped(Count), Counts).

faces_counts(Faces, Counts) :-
    soup_counts(Faces, [], Counts).

grid(N, Lows) :-
    Most is N-1,
    findall([X,Y,Z],
            ( between(0, Most, X), between(0, Most, Y), between(0, Most, Z) ),
            Lows).

%   A square with the axis x = y = 0 as a side, at angle I of K.

page(K, I, [[[0,0,0],[0,0,1],[X,Y,1],[X,Y,0]]]) :-
    A is 2*pi*I/K,
    X is cos(A),
    Y is sin(A).

%   The wedge between page I and the next one.

wedge(K, I, Faces) :-
    I1 is (I+1) mod K,
    I0 is I mod K,
    page(K, I0, [[O,U,P1,P0]]),
    page(K, I1, [[_,_,Q1,Q0]]),
    Faces = [[[O,U,P1,P0]], [[P0,Q0,Q1,P1]], [[O,P0,Q0]], [[U,Q1,P1]]].

%   Six tetrahedra from corner to corner of a cube, one for each order of axes.

kuhn([X,Y,Z], Points) :-
    permutation([0,1,2], [A,B,_]),
    axis_step([X,Y,Z], A, P1),
    axis_step(P1, B, P2),
    X1 is X+1,
    Y1 is Y+1,
    Z1 is Z+1,
    Points = [[X,Y,Z],P1,P2,[X1,Y1,Z1]].

axis_step(Point0, Axis, Point) :-
    nth0(Axis, Point0, X, Rest),
    X1 is X+1,
    nth0(Axis, Point, X1, Rest).

scaled_cube(F, Faces) :-
    cube_faces([-0.5,-0.5,-0.5], Faces0),
    maplist(scaled_face(F), Faces0, Faces).

scaled_face(F, Face0, Face) :-
    maplist(maplist(maplist(times(F))), Face0, Face).

times(F, X0, X) :-
    X is F*X0.

pyramid(Apex, [A,B,C,D], [[[A,B,C,D]], [[A,B,Apex]], [[B,C,Apex]],
                          [[C,D,Apex]], [[D,A,Apex]]]).

:- begin_tests(regions).

test(cube, N == [8,12,6,6,1,2,2,0]) :-
    cubes_faces([[0,0,0]], Faces),
    faces_counts(Faces, N).
test(cubes_apart, N == [16,24,12,12,2,3,4,0]) :-
    cubes_faces([[0,0,0],[3,0,0]], Faces),
    faces_counts(Faces, N).
test(cubes_at_a_vertex, N == [15,24,12,12,1,3,3,0]) :-
    cubes_faces([[0,0,0],[1,1,1]], Faces),
    faces_counts(Faces, N).
test(cubes_at_an_edge, N == [14,23,12,12,1,3,3,0]) :-
    cubes_faces([[0,0,0],[1,1,0]], Faces),
    faces_counts(Faces, N).
test(cubes_at_a_face, N == [12,20,11,11,1,3,3,0]) :-
    cubes_faces([[0,0,0],[0,0,1]], Faces),
    faces_counts(Faces, N).

test(book, [forall(member(K, [1,2,3,8,64,1024])),
            true(N == [V,E,K,K,1,1,1,0])]) :-
    numlist(1, K, Is),
    maplist(page(K), Is, Faces),
    V is 2+2*K,
    E is 1+3*K,
    faces_counts(Faces, N).
test(closed_book, [forall(member(K, [3,4,7,32])),
                   true(N == [V,E,F,F,1,R,R,0])]) :-
    numlist(1, K, Is),
    maplist(wedge(K), Is, Lists),
    append(Lists, Faces0),
    once_each(Faces0, Faces),
    V is 2*K+2,
    E is 5*K+1,
    F is 4*K,
    R is K+1,
    faces_counts(Faces, N).
test(cubes, [forall(member(K, [1,2,3,4])), true(N == [V,E,F,F,1,R,R,0])]) :-
    grid(K, Lows),
    cubes_faces(Lows, Faces),
    V is (K+1)**3,
    E is 3*K*(K+1)**2,
    F is 3*K**2*(K+1),
    R is K**3+1,
    faces_counts(Faces, N).
test(tetrahedra, [forall(member(K, [1,2,3])), true(N == [V,E,F,F,1,R,R,0])]) :-
    grid(K, Lows),
    findall(Fs, ( member(Low, Lows), kuhn(Low, Points),
                  tetrahedron_faces(Points, Fs) ),
            Lists),
    append(Lists, Faces0),
    once_each(Faces0, Faces),
    V is (K+1)**3,
    E is 7*K**3+9*K**2+3*K,
    F is 12*K**3+6*K**2,
    R is 6*K**3+1,
    faces_counts(Faces, N).
test(six_pyramids, N == [9,20,18,18,1,7,7,0]) :-
    cube_faces([-1,-1,-1], Cube),
    findall(Fs, ( member([Base], Cube),
                  pyramid([-0.5,-0.5,-0.5], Base, Fs) ),
            Lists),
    append(Lists, Faces0),
    once_each(Faces0, Faces),
    faces_counts(Faces, N).
test(nested_cubes, [forall(member(K, [2,3,9])),
                    true(N == [V,E,F,F,K,R,S,0])]) :-
    numlist(1, K, Fs),
    maplist(scaled_cube, Fs, Lists),
    append(Lists, Faces),
    V is 8*K,
    E is 12*K,
    F is 6*K,
    R is K+1,
    S is 2*K,
    faces_counts(Faces, N).

%   All unions of the cubes round a vertex: every way in which cubes can meet
%   there.

test(octants, Sums == [5023,9120,5376,5376,255,1280,1279,0]) :-
    grid(2, All),
    findall(N,
            ( between(1, 255, Set),
              findall(Low, ( nth0(I, All, Low), Set /\ (1<<I) =\= 0 ), Lows),
              cubes_faces(Lows, Faces),
              faces_counts(Faces, N) ),
            Counts),
    foldl([N,A,B]>>maplist([X,Y,Z]>>(Z is X+Y), N, A, B), Counts,
          [0,0,0,0,0,0,0,0], Sums0),
    %   The 256th has nothing at all, and the outside.
    Sums0 = [V,E,F,L,C,R0,S,G],
    R is R0+1,
    Sums = [V,E,F,L,C,R,S,G].

%   A box with a square hole through it, and with its plug.

square(A, Z, [[Low,Low,Z],[A,Low,Z],[A,A,Z],[Low,A,Z]]) :-
    Low is -A.

walls(A, [ [[[Low,Low,0],[A,Low,0],[A,Low,1],[Low,Low,1]]],
           [[[A,Low,0],[A,A,0],[A,A,1],[A,Low,1]]],
           [[[A,A,0],[Low,A,0],[Low,A,1],[A,A,1]]],
           [[[Low,A,0],[Low,Low,0],[Low,Low,1],[Low,A,1]]] ]) :-
    Low is -A.

holed(Faces) :-
    walls(2, Outer),
    walls(1, Inner),
    findall([O,I], ( member(Z, [0,1]), square(2, Z, O), square(1, Z, I0),
                     reverse(I0, I) ),
            Ends),
    append([Outer,Inner,Ends], Faces).

test(holed, N == [16,24,10,12,1,2,2,2]) :-
    holed(Faces),
    faces_counts(Faces, N).
test(plugged, N == [16,24,12,14,1,3,3,1]) :-
    holed(Faces0),
    square(1, 0, Low),
    square(1, 1, High),
    append(Faces0, [[Low],[High]], Faces),
    faces_counts(Faces, N).

wires(edge, [[[0,0,0],[1,0,0]]], [2,1,0,0,1,1,1,0]).
wires(triangle, [[[0,0,0],[1,0,0],[0,1,0],[0,0,0]]], [3,3,0,0,1,1,1,1]).
wires(tetrahedron, [[[0,0,0],[1,0,0],[0,1,0],[0,0,0],[0,0,1],[1,0,0]],
                    [[0,1,0],[0,0,1]]],
      [4,6,0,0,1,1,1,3]).
wires(cube, Wires, [8,12,0,0,1,1,1,5]) :-
    findall([A,B],
            ( between(0, 2, Axis), grid(2, Lows), member(A, Lows),
              nth0(Axis, A, 0), axis_step(A, Axis, B) ),
            Wires).
wires(lone, [[[0,0,0]],[[1,1,1]]], [2,0,0,0,2,1,2,0]).

test(wires, [forall(wires(_, Wires, Counts)), true(N == Counts)]) :-
    soup_counts([], Wires, N).

sheet(square, [[[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]]], [4,4,1,1,1,1,1,0]).
sheet(annulus, [[Outer,Inner]], [8,8,1,2,1,1,1,1]) :-
    square(2, 0, Outer),
    square(1, 0, Inner0),
    reverse(Inner0, Inner).
%   Seven triangles; the border goes round twice.

sheet(band, Faces, [7,14,7,7,1,1,1,1]) :-
    findall([[A,B,C]],
            ( between(0, 6, I),
              maplist(border_point(I), [0,1,2], [A,B,C]) ),
            Faces).

border_point(I, More, [X,Y,Z]) :-
    S is 4*pi*((4*(I+More)) mod 7)/7,
    X is (2+cos(S/2))*cos(S),
    Y is (2+cos(S/2))*sin(S),
    Z is sin(S/2).

test(sheets, [forall(( sheet(_, Faces, Counts),
                       member(Turned, [false,true]) )),
              true(N == Counts)]) :-
    placed(Turned, Faces, Placed),
    faces_counts(Placed, N).

placed(false, Faces, Faces).
placed(true, Faces, Placed) :-
    turned_faces(Faces, Placed).

%   Cubes round a room.

test(room, N-Roles-Volume == [64,144,108,108,1,28,28,0]-1-27.0) :-
    grid(3, Lows),
    cubes_faces(Lows, Faces),
    in_new_world(( made_soup(Faces, []),
                   regions_made(1, Report),
                   aggregate_all(count, region(1, _, outside), Roles) )),
    report_counts(Report, N),
    findall(One, ( member(Region, Report.regions), One = Region.volume,
                   number(One) ),
            Volumes),
    sum_list(Volumes, Volume).

test(neighbours, [forall(member(K, [2,3])), true(N == Wanted)]) :-
    grid(K, Lows),
    cubes_faces(Lows, Faces),
    Out is K**3+1,
    Wanted is 3*K**2*(K-1),
    in_new_world(( made_soup(Faces, []),
                   regions_made(1, _),
                   aggregate_all(count,
                                 ( region_neighbour(1, R1, R2, _),
                                   R1 < R2, R2 < Out ),
                                 N) )).

%   All modes give the same.

test(neighbour_modes, true) :-
    cubes_faces([[0,0,0],[1,0,0]], Faces),
    in_new_world(( made_soup(Faces, []),
                   regions_made(1, _),
                   findall(R1-R2-P, region_neighbour(1, R1, R2, P), All),
                   forall(member(R1-R2-P, All),
                          ( region_neighbour(1, R1, R2, P),
                            once(( region_neighbour(1, R1, R2, Q), Q == P
                                 ; region_neighbour(1, R1, _, Q), Q == P )),
                            once(( region_neighbour(1, _, R2, Q2), Q2 == P ))
                          )),
                   length(All, 22) )).

%   Contacts that are partial, cut as a glue would cut them.

test(vertex_in_a_face, N-In == [13,20,11,12,1,3,3,0]-true) :-
    box4(1, Box),
    pyramid([0.3,0.2,1], [[-1,-1,3],[1,-1,3],[1,1,3],[-1,1,3]], Roof),
    append(Box, Roof, Faces),
    in_new_world(( made_soup(Faces, []),
                   vertex_at([0.3,0.2,1], V),
                   once(top(P)),
                   assert_fact(lies_in(1, v(V), p(P))),
                   regions_made(1, Report),
                   ( lies_in(1, v(V), p(P)) -> In = true ; In = false ) )),
    \+ law_fault(Report, _, _),
    report_counts(Report, N).

box4(Z, [[[[Low,A,0],[A,A,0],[A,Low,0],[Low,Low,0]]],
         [[[Low,Low,Z],[A,Low,Z],[A,A,Z],[Low,A,Z]]]|Walls]) :-
    A = 2,
    Low = -2,
    walls(2, Walls).

top(P) :-
    p(1, P, Es),
    forall(( member(E, Es), e(1, E, V, _, _) ), v(1, V, _, _, 1.0)).

%   A sheet on a face, and nothing else: which side of it is it on?

test(sheet_on_a_face, Faults == [unsure_part-1]) :-
    box4(1, Box),
    square(1, 1, Sheet),
    in_new_world(( made_soup([[Sheet]|Box], []), regions_made(1, Report) )),
    findall(Fault-N, law_fault(Report, Fault, N), Faults).

%   On both sides of what it lies on is one region: so it is in that.

test(sheet_on_a_laminar_face, N == [14,19,8,8,2,2,3,0]) :-
    box4(1, Box),
    Flange = [[[2,2,1],[2,2,3],[-2,2,3],[-2,2,1]]],
    Sheet = [[[1,2,1.5],[1,2,2.5],[-1,2,2.5],[-1,2,1.5]]],
    faces_counts([Sheet,Flange|Box], N).

%   Nine cells on a box: nine of their faces lie in that of the box, the tenth
%   does not.

test(plate_on_a_face, N == [40,76,48,48,2,11,12,0]) :-
    box4(1, Box),
    findall([X,Y,1],
            ( member(X, [-1.5,-0.5,0.5]), member(Y, [-1.5,-0.5,0.5]) ), Lows),
    cubes_faces(Lows, Faces0),
    partition(low, Faces0, Low, Others),
    append([Low,Others,Box], Faces),
    faces_counts(Faces, N).

low([Loop]) :-
    forall(member([_,_,Z], Loop), Z =:= 1).

%   A cube between six walls, each with vertices of its own: all of its faces
%   lie on theirs.

test(filled_room, Faults-N == []-[56,84,42,42,7,8,14,0]) :-
    scaled_cube(3, Cube),
    in_new_world(( made_soup(Cube, []),
                   forall(wall(Size, At),
                          ( scaled_cube(1, Wall0),
                            maplist(wall_face(Size, At), Wall0, Wall),
                            own_rows(Wall) )),
                   regions_report(1, Report) )),
    findall(Fault-Count, law_fault(Report, Fault, Count), Faults),
    report_counts(Report, N).

wall([5,5,1], [0,0,Z]) :-
    member(Z, [-2,2]).
wall([1,5,3], [X,0,0]) :-
    member(X, [-2,2]).
wall([3,1,3], [0,Y,0]) :-
    member(Y, [-2,2]).

wall_face(Size, At, Face0, Face) :-
    maplist(maplist(maplist([By,To,C0,C]>>( C is By*C0+To ), Size, At)),
            Face0, Face).

%   Of two that are equal each would be inside the other one.

test(equal_parts, true(Faults \== [])) :-
    scaled_cube(2, Cube),
    in_new_world(( made_soup(Cube, []),
                   own_rows(Cube),
                   regions_report(1, Report) )),
    findall(Fault-Count, law_fault(Report, Fault, Count), Faults).

%   own_rows(Faces): faces with vertices and edges that no others have.

own_rows(Faces) :-
    fresh_id(v, 1, Least),
    forall(member([Loop], Faces), own_face(Least, Loop)),
    complete_segments.

own_face(Least, Loop) :-
    maplist(own_vertex(Least), Loop, Vs),
    Vs = [First|Rest],
    append(Rest, [First], Ends),
    maplist(own_edge, Vs, Ends, Es),
    fresh_id(p, 1, P),
    assert_fact(p(1, P, Es)).

own_vertex(Least, Point, V) :-
    maplist([C0,C]>>( C is float(C0)+0.0 ), Point, [X,Y,Z]),
    (   v(1, V, X, Y, Z),
        V >= Least
    ->  true
    ;   fresh_id(v, 1, V),
        assert_fact(v(1, V, X, Y, Z))
    ).

own_edge(A, B, E) :-
    fresh_id(e, 1, E),
    assert_fact(e(1, E, A, B, 1)).

test(edge_in_a_face, N == [14,21,11,12,1,3,3,0]) :-
    walls(4, Walls),
    square(4, 0, Low0),
    reverse(Low0, Low),
    square(4, 1, High),
    A = [-1,0,1],
    B = [1,0,1],
    Box = [[Low],[High,[A,B]]|Walls],
    Roof = [ [[A,B,[2,1,3],[-2,1,3]]], [[B,A,[-2,-1,3],[2,-1,3]]],
             [[A,[-2,1,3],[-2,-1,3]]], [[B,[2,-1,3],[2,1,3]]],
             [[[-2,1,3],[2,1,3],[2,-1,3],[-2,-1,3]]] ],
    append(Box, Roof, Faces),
    faces_counts(Faces, N).

%   Disks at a vertex: beside each other, in each other, and a wire.

test(vertex_glue, N == [14,25,15,15,1,4,4,0]) :-
    O = [0,0,0],
    pyramid(O, [[-4,-1,-1],[-4,1,-1],[-4,1,1],[-4,-1,1]], D1),
    pyramid(O, [[-1,-1,3],[1,-1,3],[1,1,3],[-1,1,3]], D2),
    pyramid(O, [[-4,-4,6],[4,-4,6],[4,4,6],[-4,4,6]], D3),
    append([D1,D2,D3], Faces),
    soup_counts(Faces, [[O,[0,0,-3]]], N).

%   Rows, kinds, faces that are there twice.

test(kind, Kinds == [cells,solid]) :-
    findall(Kind,
            ( member(Shape, [sheet(points([[0,0,0],[1,0,0],[0,1,0]]),
                                   faces([[1,2,3]])),
                             box(size(1,1,1))]),
              in_new_world(( add_primitive(Shape, S), regions_made(S, _),
                             segment(S, Kind, _) )) ),
            Kinds).
test(doubled, N-Said == [12,20,11,11,1,3,3,0]-[1]) :-
    cube_faces([0,0,0], One),
    cube_faces([0,0,1], Two),
    append(One, Two, Faces),
    heard(soup_counts(Faces, [], N), Said).
test(again, Same == true) :-
    cubes_faces([[0,0,0],[1,0,0]], Faces),
    in_new_world(( made_soup(Faces, [[[0.2,0.2,0.2],[0.8,0.2,0.2]]]),
                   regions_made(1, First),
                   findall(Row, region_row(Row), Rows),
                   regions_made(1, Again),
                   findall(Row, region_row(Row), RowsAgain) )),
    (   First =@= Again,
        Rows == RowsAgain
    ->  Same = true
    ;   Same = false
    ).

region_row(region(A, B, C)) :-
    region(A, B, C).
region_row(sides(A, B, C, D)) :-
    sides(A, B, C, D).
region_row(lies_in(A, B, C)) :-
    lies_in(A, B, C).

%   What was not to be glued lies in one place twice, and none of it goes.

test(kept_apart, Counts-Faces == []-12) :-
    Near = at([translate(1,0,0)], box(size(1,1,1))),
    in_new_world(( assert_fact(segment(1, solid, box(size(1,1,1)))),
                   assert_fact(segment(2, solid, Near)),
                   assert_fact(segment(3, cells, glue([1,2]))),
                   assert_fact(gluing(3, apart(1, 2))),
                   evaluate(3),
                   heard(regions_made(3, _), Counts),
                   aggregate_all(count, p(3, _, _), Faces) )).

%   A hollow of a solid is a void.

test(hollow, Roles == [cell,void,outside]) :-
    scaled_cube(1, Inner0),
    maplist(maplist(reverse), Inner0, Inner),
    scaled_cube(2, Outer),
    append(Outer, Inner, Faces),
    in_new_world(( solid_soup(Faces),
                   regions_made(1, _),
                   findall(Role, region(1, _, Role), Roles) )).

solid_soup(Faces0) :-
    %   made_soup/2 turns each third face: they are turned back before.
    findall(Face,
            ( nth1(I, Faces0, Face0),
              (   I mod 3 =:= 0
              ->  maplist(reverse, Face0, Face)
              ;   Face = Face0
              ) ),
            Faces),
    made_soup(Faces, []),
    retractall_facts(segment(1, _, _)),
    assert_fact(segment(1, solid, soup)).

test(no_segment, error(existence_error(segment, 7))) :-
    in_new_world(regions_made(7, _)).
test(no_face, error(geometry_error(wrong_triangles(1, 1)))) :-
    in_new_world(( made_soup([[[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]]], []),
                   assert_fact(plane(1, 1, 0, 0, 1, 0)),
                   assert_fact(t(1, 1, 1, 1, 2, 3)),
                   regions_made(1, _) )).
test(nothing_half_made, Rows == []) :-
    in_new_world(( made_soup([[[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]]], []),
                   assert_fact(plane(1, 1, 0, 0, 1, 0)),
                   assert_fact(t(1, 1, 1, 1, 2, 3)),
                   catch(regions_made(1, _), error(_, _), true),
                   findall(Row, region_row(Row), Rows) )).

%   What a book has is no defect of cells, but of a solid.

test(book_is_no_defect, Faults == []) :-
    numlist(1, 5, Is),
    maplist(page(5), Is, Faces),
    in_new_world(( made_soup(Faces, []), regions_made(1, _),
                   findall(Defect, model_defect(Defect), Faults) )).

:- end_tests(regions).
