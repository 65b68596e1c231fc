/* Glue in one place, against what the fused glue counts, in place and turned.
   covers: face_glue */
:- module(test_contact_glue, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(gluing/cycle)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(solid/part_glue)).
:- use_module(rules(gluing/regions)).
:- use_module(rules(store)).
:- use_module(tests(rules/gluing/cells_rows)).
:- use_module(tests(rules/gluing/face_soup)).
:- use_module(tests(rules/gluing/turned_soup)).
:- use_module(tests(rules/sample), [numbered/3]).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   soup(Turned, Faces): cells with these faces; vertices in one place are one,
%   but those of the faces after `apart`, which are added as they are.

two(Turned, Faces0, Others0) :-
    (   Turned == true
    ->  append(Faces0, Others0, All0),
        turned_faces(All0, All),
        length(Faces0, N),
        length(Faces, N),
        append(Faces, Others, All)
    ;   Faces = Faces0,
        Others = Others0
    ),
    made_soup(Faces, []),
    regions_made(1, _),
    faces_added(Others).

counts(Counts) :-
    regions_report(1, Report),
    \+ law_fault(Report, _, _),
    report_counts(Report, Counts).

%   twins(Pairs): vertices in one place, the older first.

twins(Pairs) :-
    findall(V-W, ( v(1, V, X, Y, Z), v(1, W, X, Y, Z), V < W ), Pairs).

pyramid(Apex, Points, Faces) :-
    append(Points, [First], Round),
    Points = [First|_],
    findall([[Apex,A,B]], append(_, [A,B|_], Round), Sides),
    reverse(Points, Base),
    append(Sides, [[Base]], Faces).

page(Low, High, X, Y, [[[0,0,Low],[0,0,High],[X,Y,High],[X,Y,Low]]]).

plate([ [[[-4,4,0],[4,4,0],[4,-4,0],[-4,-4,0]]],
        [[[-4,-4,1],[4,-4,1],[4,4,1],[-4,4,1]]],
        [[[-4,-4,0],[4,-4,0],[4,-4,1],[-4,-4,1]]],
        [[[4,-4,0],[4,4,0],[4,4,1],[4,-4,1]]],
        [[[4,4,0],[-4,4,0],[-4,4,1],[4,4,1]]],
        [[[-4,4,0],[-4,-4,0],[-4,-4,1],[-4,4,1]]] ]).

:- begin_tests(contact_glue, [setup(set_random(seed(4)))]).

%   Two cubes at a vertex.

test(vertices, [forall(member(Turned, [false,true])),
                true(C-Change == [15,24,12,12,1,3,3,0]
                                 -change(-1,0,0,0,-1,0,-1,0))]) :-
    cube_faces([0,0,0], One),
    cube_faces([1,1,1], Two),
    in_new_world(( two(Turned, One, Two),
                   twins([V-W]),
                   glue_vertices(1, V, W, Change0),
                   Change = Change0,
                   counts(C) )).

%   Figure 4: D2 into D3, both at the origin.

test(in_each_other, C == [9,16,10,10,1,3,3,0]) :-
    pyramid([0,0,0], [[-1,-1,3],[-1,1,3],[1,1,3],[1,-1,3]], D2),
    pyramid([0,0,0], [[-4,-4,6],[-4,4,6],[4,4,6],[4,-4,6]], D3),
    in_new_world(( two(false, D3, D2), twins([V-W]),
                   glue_vertices(1, V, W, _), counts(C) )).
%   A wire at one of them stays there.

test(wire, [forall(member(Turn, [V-W,W-V])),
            true(C == [16,25,12,12,1,3,3,0])]) :-
    cube_faces([0,0,0], One),
    cube_faces([1,1,1], Two),
    in_new_world(( made_soup(One, [[[1,1,1],[2,0,1]]]),
                   regions_made(1, _),
                   faces_added(Two),
                   twins([V-W]),
                   Turn = To-From,
                   glue_vertices(1, To, From, _),
                   counts(C) )).
test(one_step_of_undo, Rows1 == Rows) :-
    cube_faces([0,0,0], One),
    cube_faces([1,1,1], Two),
    in_new_world(( two(true, One, Two), twins([V-W]), cells_rows(1, Rows),
                   glue_vertices(1, V, W, _),
                   facts_undo,
                   cells_rows(1, Rows1) )).
test(crossing,
     error(geometry_error(part_glue(not_glued(1, v(_), v(_), crossing))))) :-
    pyramid([0,0,0], [[10,-1,-10],[10,-1,10],[10,1,10],[10,1,-10]], D1),
    pyramid([0,0,0], [[10,-10,-1],[10,-10,1],[10,10,1],[10,10,-1]], D2),
    in_new_world(( two(false, D1, D2), twins([V-W]),
                   glue_vertices(1, V, W, _) )).
test(touching,
     error(geometry_error(part_glue(not_glued(1, v(_), v(_), touching))))) :-
    cube_faces([0,0,0], One),
    cube_faces([1,1,0], Two),
    in_new_world(( two(false, One, Two), twins([V-W|_]),
                   glue_vertices(1, V, W, _) )).
test(apart,
     error(geometry_error(part_glue(not_glued(1, v(1), v(2), apart))))) :-
    cube_faces([0,0,0], One),
    in_new_world(( two(false, One, []), glue_vertices(1, 1, 2, _) )).
test(no_vertex, error(existence_error(vertex, 99))) :-
    cube_faces([0,0,0], One),
    in_new_world(( two(false, One, []), glue_vertices(1, 1, 99, _) )).

%   Figure 6: three pages and two, which have the middle in common.

test(edges, [forall(member(Turned, [false,true])),
             true(C-Pages == [14,18,5,5,1,1,1,0]-[2,3,5])]) :-
    findall(Page, ( member(X-Y, [2-0,1-2,(-1)-2]), page(0, 3, X, Y, Page) ),
            One),
    findall(Page, ( member(X-Y, [(-2)-(-1),1-(-2)]), page(1, 4, X, Y, Page) ),
            Two),
    in_new_world(( two(Turned, One, Two),
                   once(crowded(3, A-B)),
                   once(crowded(2, D-E)),
                   glue_edges(1, A-B, D-E, _),
                   counts(C),
                   findall(N, ( radial_cycle(1, _, _, Round),
                                length(Round, N), N > 1 ), Ns) )),
    msort(Ns, Pages).

crowded(N, A-B) :-
    radial_cycle(1, A, B, Pages),
    length(Pages, N).

test(cubes_at_an_edge, [forall(member(Turned, [false,true])),
                        true(C == [14,23,12,12,1,3,3,0])]) :-
    cube_faces([0,0,0], One),
    cube_faces([1,1,0], Two),
    in_new_world(( two(Turned, One, Two), twins([V-W,X-Y]),
                   glue_edges(1, V-X, W-Y, _), counts(C) )).
%   The same where faces lie on each other: two pages are in one direction, and
%   which of them is of which cube does not hang on their numbers.

test(cubes_at_an_edge_of_faces, [forall(( member(X, [1,-1]),
                                          member(Turned, [false,true]) )),
                                 true(C == [14,23,12,12,1,3,3,0])]) :-
    cube_faces([0,0,0], One),
    cube_faces([X,0,0], Two),
    in_new_world(( two(Turned, One, Two), twins(Twins),
                   member(V-W, Twins), member(V1-W1, Twins),
                   once(e(1, _, V, V1, _)), once(e(1, _, W1, W, _)),
                   glue_edges(1, V-V1, W-W1, _), counts(C) )).
test(edges_apart,
     error(geometry_error(part_glue(not_glued(1, e(_), e(_), apart))))) :-
    cube_faces([0,0,0], One),
    in_new_world(( two(false, One, []), e(1, _, A, B, _),
                   e(1, _, B, D, _), D \== A,
                   glue_edges(1, A-B, D-B, _) )).

%   Figure 7: faces in part; whole; one in the middle of the other.

faces(part, [2,2,1]-[0,0,0], [2,2,1]-[1,1,1], [18,28,13,13,1,3,3,0]).
faces(whole, [1,1,1]-[0,0,0], [1,1,1]-[0,0,1], [12,20,11,11,1,3,3,0]).
faces(inner, [4,4,1]-[0,0,0], [1,1,1]-[1,1,1], [16,24,12,13,1,3,3,0]).
faces(border, [4,4,1]-[0,0,0], [1,1,1]-[3,1,1], [16,25,12,12,1,3,3,0]).

test(faces, [forall(( faces(_, One0, Two0, Wanted),
                      member(Turned, [false,true]) )),
             true(C == Wanted)]) :-
    box_faces(One0, One),
    box_faces(Two0, Two),
    in_new_world(( two(Turned, One, Two),
                   glue_faces(1, 2, 7, _),
                   counts(C) )).
test(faces_apart, error(geometry_error(part_glue(not_glued(1, p(1), p(2),
                                                           apart))))) :-
    cube_faces([0,0,0], One),
    in_new_world(( two(false, One, []), glue_faces(1, 1, 2, _) )).

%   Eight cubes, face by face: twelve glues, and nothing else is to be done. In
%   between both laws hold each time, and there are eight cells of volume 1,
%   though faces that lie on each other, and are not glued yet, get edges in
%   common. In any order the same model comes out, but for ids.

test(face_by_face, C-N == [27,54,36,36,1,9,9,0]-12) :-
    in_new_world(( eight_cubes, all_glued(0, N0), N = N0, counts(C) )).
test(any_order, [ forall(( numbered(6, 100, Seed),
                           member(Turn, [[],[[3,4,0],[-4,3,0],[0,0,5]],
                                         [[1,2,2],[2,1,-2],[2,-2,1]]]) )),
                  Shape-N == Wanted-12 ]) :-
    in_new_world(( eight_cubes(Turn), all_glued(0, _),
                   places_shape(Wanted) )),
    set_random(seed(Seed)),
    in_new_world(( eight_cubes(Turn), glued_at_random(0, N0), N = N0,
                   places_shape(Shape) )).

glued_at_random(N0, N) :-
    twin_faces(Twins),
    (   Twins == []
    ->  N = N0
    ;   random_member(P-Q, Twins),
        glue_faces(1, P, Q, _),
        regions_report(1, Report),
        findall(Volume, ( member(Region, Report.regions),
                          Region.role == cell, Volume = Region.volume ),
                Volumes),
        length(Volumes, 8),
        sort(Volumes, [_]),
        N1 is N0+1,
        glued_at_random(N1, N)
    ).

%   places_shape(Shape): the faces, by their places, and of each region which
%   faces are round it.

places_shape(Faces-Regions) :-
    findall(Places, ( p(1, P, _), polygon_places(P, Places) ), Faces0),
    msort(Faces0, Faces),
    findall(Role-Round,
            ( region(1, R, Role),
              findall(Places,
                      ( ( sides(1, P, R, _) ; sides(1, P, _, R) ),
                        polygon_places(P, Places) ), Round0),
              msort(Round0, Round) ),
            Regions0),
    msort(Regions0, Regions).

eight_cubes :-
    eight_cubes([]).

%   eight_cubes(Turn): a matrix of integers, so faces stay flat.

eight_cubes(Turn) :-
    findall(Faces,
            ( member(X, [0,1]), member(Y, [0,1]), member(Z, [0,1]),
              cube_faces([X,Y,Z], Faces0),
              maplist(maplist(maplist(turned(Turn))), Faces0, Faces) ),
            [First|Rest]),
    two(false, First, []),
    maplist(faces_added, Rest).

turned([], Point, Point) :-
    !.
turned(Rows, Point, Turned) :-
    maplist(row_times(Point), Rows, Turned).

row_times([X,Y,Z], [A,B,C], N) :-
    N is A*X+B*Y+C*Z.

%   The paper glues vertices, then edges, then faces, each of which makes one
%   less of them: here a face comes with its border, in the order of the
%   dimensions. What it does in all is the same: two cubes take four vertices,
%   four edges and a face, eight cubes 37, 42 and 12. What follows, C R S G and
%   the counts between, has the laws.

test(events, Less-Then == [4,4,1]-[12,20,11,11,1,3,3,0]) :-
    cube_faces([0,0,0], One),
    cube_faces([1,0,0], Two),
    in_new_world(( two(false, One, Two),
                   events(all_glued(0, 1), Less, Then) )).
test(events_of_eight, Less-Then == [37,42,12]-[27,54,36,36,1,9,9,0]) :-
    in_new_world(( eight_cubes, events(all_glued(0, _), Less, Then) )).

:- meta_predicate events(0, -, -).

events(Goal, Less, Then) :-
    complete_segments,
    counts(Before),
    call(Goal),
    counts(Then),
    findall(Fewer,
            ( member(I, [1,2,3]), nth1(I, Before, N0), nth1(I, Then, N),
              Fewer is N0-N ),
            Less).

all_glued(N0, N) :-
    twin_faces(Twins),
    (   Twins = [P-Q|_]
    ->  glue_faces(1, P, Q, _),
        N1 is N0+1,
        all_glued(N1, N)
    ;   N = N0
    ).

twin_faces(Twins) :-
    findall(Places-P, ( p(1, P, _), polygon_places(P, Places) ), Pairs0),
    keysort(Pairs0, Pairs),
    findall(P-Q, append(_, [Places-P,Places-Q|_], Pairs), Twins).

polygon_places(P, Places) :-
    findall(p(X,Y,Z),
            ( p(1, P, Es), member(E, Es), e(1, E, V, _, _),
              v(1, V, X, Y, Z) ),
            Places0),
    sort(Places0, Places).

%   Figure 8: a vertex on an edge, on a face, an edge on a face.

test(vertex_on_edge, C-L == [13,21,11,11,1,3,3,0]-0) :-
    plate(Plate),
    pyramid([4,1,1], [[3,0,3],[3,2,3],[5,2,3],[5,0,3]], Tip),
    in_new_world(( two(false, Plate, Tip), vertex_at([4,1,1], V),
                   e(1, E, A, B, _), v(1, A, 4.0, _, 1.0), v(1, B, 4.0, _, 1.0),
                   glue_mixed(1, v(V), e(E), _), counts(C),
                   aggregate_all(count, lies_in(1, _, _), L) )).
test(vertex_on_face, C-L == [13,20,11,12,1,3,3,0]-1) :-
    plate(Plate),
    pyramid([0,1,1], [[-1,0,3],[-1,2,3],[1,2,3],[1,0,3]], Tip),
    in_new_world(( two(false, Plate, Tip), vertex_at([0,1,1], V),
                   glue_mixed(1, v(V), p(2), _), counts(C),
                   aggregate_all(count, lies_in(1, _, p(_)), L) )).
test(edge_on_face, C == [14,21,11,12,1,3,3,0]) :-
    plate(Plate),
    A = [-1,0,1],
    B = [1,0,1],
    Roof = [ [[A,B,[2,1,3],[-2,1,3]]], [[B,A,[-2,-1,3],[2,-1,3]]],
             [[A,[-2,1,3],[-2,-1,3]]], [[B,[2,-1,3],[2,1,3]]],
             [[[-2,1,3],[2,1,3],[2,-1,3],[-2,-1,3]]] ],
    in_new_world(( two(false, Plate, Roof), vertex_at(A, V), vertex_at(B, W),
                   once(e(1, E, V, W, _)),
                   glue_mixed(1, e(E), p(2), _), counts(C) )).
test(beside,
     error(geometry_error(part_glue(not_glued(1, v(_), p(2), beside))))) :-
    plate(Plate),
    pyramid([0,1,9], [[-1,0,11],[-1,2,11],[1,2,11],[1,0,11]], Tip),
    in_new_world(( two(false, Plate, Tip), vertex_at([0,1,9], V),
                   glue_mixed(1, v(V), p(2), _) )).

:- end_tests(contact_glue).
