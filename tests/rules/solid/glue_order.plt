/* What a glue does not depend on: the order of its operands, and how they are
   put together; how large they are. And what is near and not the same: pages at
   small angles, gaps of single precision.
   covers: glue */
:- module(test_glue_order, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(csg/csg), [complete_tree/2]).
:- use_module(rules(csg/source), [source_noted/2]).
:- use_module(rules(gluing/cycle), [radial_cycle/4]).
:- use_module(rules(polygon/triangulation),
              [complete_segments/0, complete_segments/1]).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(solid/glue)).
:- use_module(rules(store)).
:- use_module(tests(rules/glue_model)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

/* - - - boxes of a coarse grid - - - */

random_box(at([translate(X,Y,Z)], box(size(A,B,C)))) :-
    maplist(random_between(0, 3), [X,Y,Z]),
    maplist(random_between(1, 3), [A,B,C]).

random_boxes(Boxes) :-
    random_between(2, 5, N),
    length(Boxes, N),
    maplist(random_box, Boxes).

scaled(F, at([translate(X0,Y0,Z0)], box(size(A0,B0,C0))),
       at([translate(X,Y,Z)], box(size(A,B,C)))) :-
    maplist(times(F), [X0,Y0,Z0,A0,B0,C0], [X,Y,Z,A,B,C]).

times(F, N0, N) :-
    N is N0*F.

%   glue_cells(Boxes, Numbers, Shape, Cells): box I is segment Numbers[I]; Shape
%   is `flat(Order)` or `nested(Order, K)`, the first K of Order a glue of
%   their own. Cells are what comes out, in which numbers of boxes stand:
%   counts, and of each region its role, what it is inside and its volume.

glue_cells(Boxes, Numbers, Shape, Counts-Regions) :-
    in_new_world(( maplist(box_made, Numbers, Boxes),
                   shape_made(Shape, Numbers, S),
                   evaluate(S),
                   glue_report(S, Report) )),
    report_counts(Report, Counts),
    findall(Role-Inside-Volume,
            ( member(Region, Report.regions),
              Role = Region.role,
              findall(I, ( member(N, Region.inside), nth1(I, Numbers, N) ),
                      Inside0),
              sort(Inside0, Inside),
              Volume = Region.volume ),
            Regions0),
    msort(Regions0, Regions).

box_made(S, Term) :-
    assert_fact(segment(S, solid, Term)).

shape_made(flat(Order), Numbers, 20) :-
    numbers_of(Order, Numbers, Ss),
    assert_fact(segment(20, cells, glue(Ss))).
shape_made(nested(Order, K), Numbers, 20) :-
    numbers_of(Order, Numbers, Ss),
    length(Inner, K),
    append(Inner, Outer, Ss),
    assert_fact(segment(19, cells, glue(Inner))),
    assert_fact(segment(20, cells, glue([19|Outer]))).

numbers_of(Order, Numbers, Ss) :-
    findall(S, ( member(I, Order), nth1(I, Numbers, S) ), Ss).

rounded(Counts-Regions0, F, Counts-Regions) :-
    maplist(rounded_volume(F), Regions0, Regions1),
    msort(Regions1, Regions).

rounded_volume(F, Role-Inside-V0, Role-Inside-V) :-
    (   V0 == null
    ->  V = null
    ;   V is round(V0/F**3*1000)
    ).

/* - - - pages - - - */

%   pages_cycle(T, K, Way): K pages at the angles T, 2T ... K*T, as near as
%   doubles have them, glued without a tolerance: in order round their edge, one
%   way or the other, from anywhere.

pages_cycle(T, K, Way) :-
    in_new_world(( numlist(1, K, Ss),
                   random_permutation(Ss, Order),
                   maplist(page_made(T), Ss),
                   assert_fact(segment(99, cells, glue(Order))),
                   complete_segments,
                   evaluate(99, [tolerance(0)]),
                   v(99, A0, 0.0, 0.0, 0.0),
                   v(99, B0, 0.0, 0.0, 1.0),
                   msort([A0,B0], [A,B]),
                   radial_cycle(99, A, B, Pages),
                   findall(S, ( member(page(P,_,_), Pages),
                                once(from_p(99, P, S, _, _)) ),
                           Round) )),
    append(Before, [1|After], Round),
    !,
    append([1|After], Before, Turned),
    numlist(1, K, Up),
    (   Turned == Up
    ->  Way = up
    ;   Turned = [1|Down],
        reverse(Down, Rest),
        Up == [1|Rest],
        Way = down
    ).

page_made(T, S) :-
    Y is S*T,
    assert_fact(segment(S, surface, page)),
    forall(nth1(V, [[0,0,0],[1,Y,0],[1,Y,1],[0,0,1]], [A,B,C]),
           assert_fact(v(S, V, A, B, C))),
    forall(nth1(E, [1-2,2-3,3-4,4-1], V-W), assert_fact(e(S, E, V, W, 1))),
    assert_fact(p(S, 1, [1,2,3,4])).

/* - - - gaps - - - */

%   gap_glued(Gap, Counts, Misses): two cubes of a source in single precision.

gap_glued(Gap, Counts, Misses) :-
    X is 1.0+Gap,
    Grain is 2.0** -23,
    in_new_world(( box_made(1, box(size(1,1,1))),
                   box_made(2, at([translate(X,0,0)], box(size(1,1,1)))),
                   assert_fact(segment(3, cells, glue([1,2]))),
                   facts_transaction(( complete_tree([3], Incomplete),
                                       complete_segments(Incomplete) )),
                   source_noted(1, Grain),
                   source_noted(2, Grain),
                   evaluate(3),
                   glue_report(3, Report),
                   glue_misses(3, Misses) )),
    report_counts(Report, Counts).

:- begin_tests(glue_order).

test(any_order, [forall(between(1, 12, Seed))]) :-
    set_random(seed(Seed)),
    random_boxes(Boxes),
    length(Boxes, N),
    numlist(1, N, Up),
    random_permutation(Up, Order),
    random_permutation(Up, Numbers),
    glue_cells(Boxes, Up, flat(Up), Cells),
    glue_cells(Boxes, Up, flat(Order), Cells1),
    glue_cells(Boxes, Numbers, flat(Order), Cells2),
    assertion(Cells1 == Cells),
    assertion(Cells2 == Cells).
test(nested, [forall(between(1, 12, Seed))]) :-
    set_random(seed(Seed)),
    random_boxes(Boxes),
    length(Boxes, N),
    numlist(1, N, Up),
    random_permutation(Up, Order),
    random_between(1, N, K),
    glue_cells(Boxes, Up, flat(Up), Cells),
    glue_cells(Boxes, Up, nested(Order, K), Cells1),
    assertion(Cells1 == Cells).
test(scales, [forall(( between(1, 8, Seed), member(F, [1.0e-9,1.0e9]) ))]) :-
    set_random(seed(Seed)),
    random_boxes(Boxes),
    length(Boxes, N),
    numlist(1, N, Up),
    maplist(scaled(F), Boxes, Others),
    glue_cells(Boxes, Up, flat(Up), Cells0),
    glue_cells(Others, Up, flat(Up), Cells1),
    rounded(Cells0, 1, Cells),
    rounded(Cells1, F, Cells2),
    assertion(Cells2 == Cells).
test(twice_the_same, Counts-Insides == c(8,12,6,6,1,2,2,0)-[[],[1,2]]) :-
    Box = box(size(1,2,3)),
    glue_cells([Box,Box], [1,2], flat([1,2]), Counts-Regions),
    findall(Inside, member(_-Inside-_, Regions), Insides0),
    sort(Insides0, Insides).
test(pages, [ forall(( member(T, [1.0e-3,1.0e-6,1.0e-9,1.0e-12,1.0e-15]),
                       member(K, [3,8,20]) )),
              true(memberchk(Way, [up,down])) ]) :-
    pages_cycle(T, K, Way).
test(single_precision, Counts-Misses == c(12,20,11,11,1,3,3,0)-[]) :-
    gap_glued(1.0e-7, Counts, Misses).
test(gap, Counts-Gap == c(16,24,12,12,2,3,4,0)-10) :-
    gap_glued(1.0e-3, Counts, [miss(1-_,2-_,Gap0,_)]),
    Gap is round(Gap0*1.0e4).

:- end_tests(glue_order).
