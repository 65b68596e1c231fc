/* What is glued: counts by hand and by arithmetic, in place and turned; the
   regions, what each is inside, and taking it apart again.
   covers: coincident_faces, solid_seams, glue_wire, glue_divide */
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
:- use_module(tests(rules/glue_model)).
:- use_module(tests(rules/polyhedron),
              [box_faces/1, box_points/3, in_new_world/1, polyhedron/4]).

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

%   All sets of the eight cubes round a vertex, which touch in every way that
%   cubes do, and some of them turned: the sums of V, E, F, C, R, S and G are
%   those that a count of the cells of the grid gives.

test(subsets, Sums == [5023,9120,5376,255,1280,1279,0]) :-
    numlist(1, 255, Sets),
    foldl(subset_added, Sets, [0,0,0,0,1,0,0], Sums).

subset_added(Set, Sums0, Sums) :-
    findall(box(1,[X,Y,Z]),
            ( between(0, 7, I),
              Set >> I /\ 1 =:= 1,
              X is I /\ 1,
              Y is I >> 1 /\ 1,
              Z is I >> 2 ),
            Boxes),
    (   Set mod 5 =:= 0
    ->  turned(Set, Steps)
    ;   Steps = []
    ),
    glue_counts(Boxes, Steps, c(V,E,F,_,C,R,S,G)),
    maplist([A,B,Sum]>>(Sum is A+B), Sums0, [V,E,F,C,R,S,G], Sums).

%   Wires between points of a grid, in and beside a box with a sheet in it: both
%   laws hold, and turned the same comes out.

test(wires, [ forall(between(1, 40, Seed)), Turned == Counts ]) :-
    set_random(seed(Seed)),
    length(Wires, 5),
    maplist(grid_wire, Wires),
    Parts = [box(2,[0,0,0]),flat(4,4,1)|Wires],
    glue_counts(Parts, [], Counts),
    turned(Seed, Steps),
    glue_counts(Parts, Steps, Turned).

grid_wire(wire(A, B)) :-
    repeat,
    maplist(grid_point, [A,B]),
    A \== B,
    !.

grid_point([X,Y,Z]) :-
    maplist([C]>>( random_between(-2, 2, N), C is N/2.0 ), [X,Y]),
    random_between(0, 4, K),
    Z is K/2.0.

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

%   Each is half of its prism of twelve facets.

test(halves, Volumes == [3.0,3.0,3.75,3.75]) :-
    in_new_world(( load_model('facts/figures/glue_materials.pl'),
                   glue_report(6, Report) )),
    findall(Volume,
            ( member(Region, Report.regions), Region.role == cell,
              Volume is round(Region.volume*1.0e9)/1.0e9 ),
            Volumes0),
    msort(Volumes0, Volumes).

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

test(cake, [ forall(( nth1(K, [2,4,8,15,26,42], Cells),
                      member(Seed, [0,7]) )),
             N == Cells ]) :-
    sheets_inside(K, 1, Seed, N).
test(one_point, [ forall(( member(K, [1,2,3,4]), member(Seed, [0,7]) )),
                  N == Cells ]) :-
    sheets_inside(K, 0, Seed, N),
    Cells is K*K-K+2.

sheets_inside(K, Off, Seed, N) :-
    findall(Sheet, general_sheet(K, Off, Sheet), Sheets),
    steps(Seed, Steps),
    in_new_world(( glue_made([box(4,[0,0,-2])|Sheets], Steps, S),
                   glue_report(S, Report) )),
    aggregate_all(count,
                  ( member(Region, Report.regions), Region.inside == [1] ),
                  N).

steps(0, []) :-
    !.
steps(Seed, Steps) :-
    turned(Seed, Steps).

%   general_sheet(K, Off, Sheet): A*X + B*Y + C*Z = Off*D.

general_sheet(K, Off, plane_sheet(Plane, Off)) :-
    between(1, K, I),
    nth1(I, [p(3,1,1,0.2), p(-1,3,1,0.3), p(1,-1,3,-0.4), p(2,3,-3,0.1),
             p(4,1,-3,0.5), p(4,-3,-2,0.7)],
         Plane).

%   What each region is inside: two boxes that cross, a wall round a hollow.

test(inside, Insides == [[1],[1,2],[2],[]]) :-
    insides([box(2,[0,0,0]),box(2,[1,1,1])], Insides).

test(void, Roles == [cell,cell,cell,cell,cell,cell,outside,void]) :-
    model(room, Walls, _),
    in_new_world(( glue_made(Walls, [], S),
                   findall(Role, region(S, _, Role), Roles0) )),
    msort(Roles0, Roles).

%   Faces in two triangles each, as in a mesh: a face of the glue comes from
%   both.

test(triangles, Insides == [[1],[1,2],[2],[]]) :-
    in_new_world(( triangle_box(1, p(0,0,0), p(2,2,2)),
                   triangle_box(2, p(1,1,1), p(3,3,3)),
                   assert_fact(segment(3, cells, glue([1,2]))),
                   evaluate(3),
                   findall(Inside,
                           ( region(3, R, Role),
                             memberchk(Role, [cell,outside]),
                             findall(S, from_r(3, R, S, _), Inside) ),
                           Insides0) )),
    msort(Insides0, [Outside|Others]),
    append(Others, [Outside], Insides).

triangle_box(S, Low, High) :-
    box_points(Low, High, Points),
    box_faces(Faces0),
    findall(Face,
            ( member([A,B,C,D], Faces0),
              member(Face, [[A,B,C],[A,C,D]]) ),
            Faces),
    polyhedron(S, solid, Points, Faces).

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

%   Each edge of it has three pages: it, and one of either box.

test(shared_edges, [ forall(member(Seed, [0,1,2])), Lengths == [3,3,3,3] ]) :-
    model(fig7, Parts, _),
    steps(Seed, Steps),
    in_new_world(( glue_made(Parts, Steps, S),
                   from_p(S, P, 1, _, Sense1),
                   from_p(S, P, 2, _, Sense2),
                   p(S, P, Es),
                   findall(N, ( member(E, Es), edge_pages(S, E, N) ),
                           Lengths) )),
    Sense1 =:= -Sense2.

edge_pages(S, E, N) :-
    e(S, E, V, W, _),
    msort([V,W], [A,B]),
    radial_cycle(S, A, B, Pages),
    length(Pages, N).

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

%   What is thinner than the tolerance is glued, or named.

flat(H, pyramid(base(4,4),height(H))).
flat(H, pyramid(base(6,6),height(H))).
flat(H, cone(radius(4),height(H),facets(8))).
flat(H, prism(outline([[0,0],[4,0],[0,1]]),height(H))).

flat_glued(K, Z, Kind) :-
    H is 2.0**K,
    flat(H, Flat),
    in_new_world(( assert_fact(segment(1, solid, box(size(4,4,1)))),
                   assert_fact(segment(2, solid,
                                       at([translate(0.5,0.25,Z)], Flat))),
                   assert_fact(segment(3, cells, glue([1,2]))),
                   catch(( evaluate(3), Kind = glued ),
                         error(geometry_error(Fault), _),
                         functor(Fault, Kind, _)) )).

test(thin, [ setup(asserta(test_glue:quiet, Ref)), cleanup(erase(Ref)),
             true(Kinds == [glued,thin_operand]) ]) :-
    setof(Kind,
          K^Z^( (   member(K, [-50,-49,-44,-40]),
                    member(Z, [0,1])
                ;   K = -53,
                    Z = 0.5
                ),
                flat_glued(K, Z, Kind) ),
          Kinds).

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
