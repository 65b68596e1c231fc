/* How disks at one vertex lie to each other: figures 4 and 5 of the paper of
   1996, cones over random cells against set inclusion, and the paper's way by
   one plane (docs/plane_rules.pl). */
:- module(test_vertex_disk, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(library(yall)).
:- use_module(rules(decision)).
:- use_module(rules(gluing/cycle)).
:- use_module(rules(gluing/vertex_disk)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(store)).
:- use_module(tests(rules/gluing/cone)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).
:- use_module(tests(rules/sample), [few/3]).

%   sphere_relation(+Cone1, +Cone2, -Relation): by the rules of the current
%   world.

sphere_relation(Cone1, Cone2, Relation) :-
    in_new_world(( cone_made(1, Cone1), cone_made(2, Cone2),
                   complete_segments([1,2]),
                   disk_relation(disk(1,1,1), disk(2,1,1), Relation0),
                   Relation = Relation0 )).

plane_relation(Cone1, Cone2, Relation) :-
    in_new_world(( cone_made(1, Cone1), cone_made(2, Cone2),
                   complete_segments([1,2]),
                   absolute_file_name(sanggwan('docs/plane_rules.pl'), File),
                   use_rules(File),
                   disk_relation(disk(1,1,1), disk(2,1,1), Relation0),
                   Relation = Relation0 )).

%   locations(Cone1, Cone2, N): for their relation it is asked N times where one
%   disk lies in the other: once for each, and of no other pair of zones.

locations(Cone1, Cone2, N) :-
    nb_setval(test_vertex_disk_asked, 0),
    setup_call_cleanup(
        wrap_predicate(sg_vertex_disk:seen_in(_,_,_), test_vertex_disk_count,
                       Wrapped,
                       ( test_vertex_disk:asked_once,
                         Wrapped )),
        sphere_relation(Cone1, Cone2, _),
        unwrap_predicate(sg_vertex_disk:seen_in/3, test_vertex_disk_count)),
    nb_getval(test_vertex_disk_asked, N).

asked_once :-
    nb_getval(test_vertex_disk_asked, N0),
    N is N0+1,
    nb_setval(test_vertex_disk_asked, N).

d(1, faces([[-4,-1,-1],[-4,1,-1],[-4,1,1],[-4,-1,1]])).
d(2, faces([[-1,-1,3],[-1,1,3],[1,1,3],[1,-1,3]])).
d(3, faces([[-4,-4,6],[-4,4,6],[4,4,6],[4,-4,6]])).
d(4, wire([0,0,-3])).

/* Figure 5: what goes from direction I to J of eight, in the plane z = 0, is
   thickened to a lens; or all but what goes from J to I. Directions are those
   of a circle, in sixteen steps. */

direction(I, Z, [X,Y,Z]) :-
    A is I*pi/8,
    X is round(1000*cos(A)),
    Y is round(1000*sin(A)).

lens(I, I, _, wire(P)) :-
    !,
    A is 2*I,
    direction(A, 0, P).
lens(I, J, H, faces(Points)) :-
    span(I, J, Span),
    Low is 2*I+1,
    High is 2*(I+Span)-1,
    Low1 is 2*I,
    High1 is 2*(I+Span),
    direction(Low1, 0, First),
    direction(High1, 0, Last),
    numlist(Low, High, Between),
    Deep is -H,
    findall(P, ( member(K, Between), direction(K, Deep, P) ), Lower0),
    findall(P, ( member(K, Between), direction(K, H, P) ), Upper),
    reverse(Lower0, Lower),
    append([[First],Upper,[Last],Lower], Points).

span(I, J, Span) :-
    Span is (J-I-1) mod 8 + 1.

turned_out(faces(Points0), faces(Points)) :-
    reverse(Points0, Points).

%   in_plane(I, J, Set): the eight parts of the circle that are inside.

in_plane(I, J, Set) :-
    (   I =:= J
    ->  Set = []
    ;   span(I, J, Span),
        Most is Span-1,
        findall(K, ( between(0, Most, D), K is (I+D) mod 8 ), Set0),
        sort(Set0, Set)
    ).

%   set_relation(Set1, Set2, All, Relation) is nondet: all that hold.

set_relation(Set1, Set2, All, Relation) :-
    ord_intersection(Set1, Set2, Both),
    ord_union(Set1, Set2, Any),
    (   Both == [],
        Relation = disjoint
    ;   Any == All,
        Relation = cover
    ;   Both == Set1,
        Relation = within
    ;   Both == Set2,
        Relation = around
    ).

%   figure5(Case, Cone1, Cone2, Relations): 392 of them. Relations hold in the
%   plane; the lenses are as thick as they must be for the first of them.

figure5(J-K-L, Cone1, Cone2, Relations) :-
    numlist(0, 7, All),
    between(1, 7, J),
    between(0, 7, K),
    between(0, 7, L),
    K =\= L,
    in_plane(0, J, Set1),
    in_plane(K, L, Set2),
    findall(R, set_relation(Set1, Set2, All, R), Relations),
    (   Relations = [Relation|_]
    ->  true
    ;   Relation = cross
    ),
    thick(Relation, J, K-L, Cone1, Cone2).

figure5_sample(Case, Cone1, Cone2, Relations) :-
    few(40, 392, Size),
    call_nth(figure5(Case, Cone1, Cone2, Relations), N),
    N*Size mod 392 < Size.

thick(disjoint, J, K-L, Cone1, Cone2) :-
    lens(0, J, 300, Cone1),
    lens(K, L, 200, Cone2).
thick(cross, J, K-L, Cone1, Cone2) :-
    thick(disjoint, J, K-L, Cone1, Cone2).
thick(around, J, K-L, Cone1, Cone2) :-
    thick(disjoint, J, K-L, Cone1, Cone2).
thick(within, J, K-L, Cone1, Cone2) :-
    lens(0, J, 200, Cone1),
    lens(K, L, 300, Cone2).
thick(cover, J, K-L, Cone1, Cone2) :-
    lens(J, 0, 200, Cone0),
    turned_out(Cone0, Cone1),
    lens(K, L, 300, Cone2).

/* Cones over cells of the surface of a cube, 3 x 3 on each side: cell(Face,
   I, J). What is inside is known for each cell. */

cell(cell(Face,I,J)) :-
    between(0, 5, Face),
    between(0, 2, I),
    between(0, 2, J).

%   corner(Face, I, J, Point): of the grid, twice as far as the middle is.

corner(Face, I, J, Point) :-
    Axis is Face//2,
    X is 6*(Face mod 2)-3,
    Y is 2*I-3,
    Z is 2*J-3,
    nth0(Axis, Point, X, [Y,Z]).

%   cell_edge(Cell, A-B): Cell is to the left of it, seen from outside.

cell_edge(cell(Face,I,J), Edge) :-
    I1 is I+1,
    J1 is J+1,
    maplist(corner(Face), [I,I1,I1,I], [J,J,J1,J1], Points),
    Points = [P,Q,R,S],
    member(A-B, [P-Q,Q-R,R-S,S-P]),
    (   memberchk(Face, [1,2,5])        % where the other axes turn to the left
    ->  Edge = A-B
    ;   Edge = B-A
    ).

%   border(Cells, Edges): Cells are to the right of them.

border(Cells, Edges) :-
    findall(A-B, ( member(Cell, Cells), cell_edges(Cell, All),
                   member(B-A, All) ),
            Edges0),
    findall(B-A, member(A-B, Edges0), Back0),
    sort(Edges0, Edges1),
    sort(Back0, Back),
    ord_subtract(Edges1, Back, Edges).

:- table cell_edges/2, next_to/2.

cell_edges(Cell, Edges) :-
    findall(Edge, cell_edge(Cell, Edge), Edges).

hangs_together([First|Edges0]) :-
    spread([First], Edges0, []).

spread([], Rest, Rest).
spread([A-B|Edges], Rest0, Rest) :-
    partition(meets(A, B), Rest0, Next, Rest1),
    append(Next, Edges, Edges1),
    spread(Edges1, Rest1, Rest).

meets(A, B, C-D) :-
    (   memberchk(C, [A,B])
    ->  true
    ;   memberchk(D, [A,B])
    ).

next_to(Cell, Nexts) :-
    cell_edges(Cell, Edges),
    findall(Other,
            ( cell(Other), cell_edges(Other, Others),
              member(A-B, Edges), memberchk(B-A, Others) ),
            Nexts).

grown(N, Cells) :-
    findall(Cell, cell(Cell), All),
    random_member(Cell, All),
    grown(N, [Cell], Cells).

grown(N, Cells0, Cells) :-
    length(Cells0, N0),
    (   N0 >= N
    ->  sort(Cells0, Cells)
    ;   random_member(Cell, Cells0),
        next_to(Cell, Nexts),
        random_member(Next, Nexts),
        (   memberchk(Next, Cells0)
        ->  grown(N, Cells0, Cells)
        ;   grown(N, [Next|Cells0], Cells)
        )
    ).

%   some_cells(Cells): a random set with a border that hangs together.

some_cells(Cells, Edges) :-
    repeat,
    random_between(1, 40, N),
    grown(N, Cells0),
    (   maybe(0.3)
    ->  findall(Cell, ( cell(Cell), \+ memberchk(Cell, Cells0) ), Cells)
    ;   Cells = Cells0
    ),
    border(Cells, Edges),
    Edges \== [],
    hangs_together(Edges),
    !.

%   two_sets(Cone1, Cone2, Relations): whose borders have no point in common.

two_sets(arcs(Edges1), arcs(Edges2), Relations) :-
    repeat,
    some_cells(Cells1, Edges1),
    some_cells(Cells2, Edges2),
    edges_points(Edges1, Points1),
    edges_points(Edges2, Points2),
    ord_disjoint(Points1, Points2),
    !,
    findall(Cell, cell(Cell), All),
    findall(R, set_relation(Cells1, Cells2, All, R), Relations).

edges_points(Edges, Points) :-
    findall(P, ( member(A-B, Edges), member(P, [A,B]) ), Points0),
    sort(Points0, Points).

:- begin_tests(vertex_disk).

test(locations, [forall(( d(I, Cone1), d(J, Cone2), I < J )), N == 2]) :-
    locations(Cone1, Cone2, N).

test(random_sets, Wrong-Kinds == []-[around,cover,disjoint,within]) :-
    set_random(seed(5)),
    few(60, 300, N),
    findall(Right-Relation,
            ( between(1, N, _),
              two_sets(Cone1, Cone2, Wanted),
              sphere_relation(Cone1, Cone2, Relation),
              (   memberchk(Relation, Wanted)
              ->  Right = true
              ;   Right = Cone1-Cone2
              ) ),
            All),
    findall(Right-R, ( member(Right-R, All), Right \== true ), Wrong),
    findall(R, member(_-R, All), Kinds0),
    sort(Kinds0, Kinds).
test(figure5, Wrong == []) :-
    findall(Case-Relation-Wanted,
            ( figure5_sample(Case, Cone1, Cone2, Wanted),
              sphere_relation(Cone1, Cone2, Relation),
              \+ right(Relation, Wanted) ),
            Wrong).
test(figure5_by_a_plane, Wrong == []) :-
    findall(Case-Relation-Wanted,
            ( figure5_sample(Case, Cone1, Cone2, Wanted),
              plane_relation(Cone1, Cone2, Relation),
              \+ right(Relation, Wanted) ),
            Wrong).

%   As it is printed the angle is at most half a turn: of three directions and
%   the first, all different, it gives another order, or none.

test(printed_angle, Right-Wrong-Undecided == 40-80-90) :-
    findall(Said,
            ( member(J, [1,2,3,4,5,6,7]), member(K, [1,2,3,4,5,6,7]),
              member(L, [1,2,3,4,5,6,7]), J =\= K, K =\= L, J =\= L,
              maplist(folded, [J,K,L], Angles),
              printed(Angles, [J,K,L], Said) ),
            All),
    count(right, All, Right),
    count(wrong, All, Wrong),
    count(undecided, All, Undecided).

folded(J, Angle) :-
    Angle is min(J, 8-J).

printed(Angles, [J,K,L], Said) :-
    numlist(0, 7, Circle),
    in_plane(0, J, Set1),
    in_plane(K, L, Set2),
    findall(R, set_relation(Set1, Set2, Circle, R), Relations),
    sort(Angles, Sorted),
    (   \+ length(Sorted, 3)
    ->  Said = undecided
    ;   in_order(Angles, Sorted, Relation),
        right(Relation, Relations)
    ->  Said = right
    ;   Said = wrong
    ).

in_order([A,B,C], Sorted, Relation) :-
    (   memberchk(Sorted-Relation0, [ [A,B,C]-disjoint, [C,B,A]-cover,
                                      [A,C,B]-within, [B,C,A]-around ])
    ->  Relation = Relation0
    ;   Relation = cross
    ).

count(What, All, N) :-
    aggregate_all(count, member(What, All), N).

right(cross, []).
right(Relation, Relations) :-
    memberchk(Relation, Relations).

test(figure4, [forall(member(I-J-Wanted, [1-2-disjoint,1-3-disjoint,
                                          1-4-disjoint,2-3-within,
                                          3-2-around,2-4-disjoint,
                                          4-3-disjoint])),
               true(Relation == Wanted)]) :-
    d(I, Cone1),
    d(J, Cone2),
    sphere_relation(Cone1, Cone2, Relation).
test(inside_out_covers, Relation == cover) :-
    d(3, faces(Points)),
    reverse(Points, Back),
    d(1, Cone),
    sphere_relation(faces(Back), Cone, Relation0),
    Relation0 == around,
    sphere_relation(faces(Back),
                    faces([[-9,-9,6],[-9,9,6],[9,9,6],[9,-9,6]]), Relation).

%   Figure 5 where one plane fails: the disks cross in four places.

crossing(faces([[10,-1,-10],[10,-1,10],[10,1,10],[10,1,-10]]),
         faces([[10,-10,-1],[10,-10,1],[10,10,1],[10,10,-1]])).

test(plane_fails, [Relation,Plane,Back] == [cross,around,around]) :-
    crossing(Cone1, Cone2),
    sphere_relation(Cone1, Cone2, Relation),
    plane_relation(Cone1, Cone2, Plane),
    plane_relation(Cone2, Cone1, Back).

:- end_tests(vertex_disk).
