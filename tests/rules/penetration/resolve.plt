:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(random)).
:- use_module(library(solution_sequences)).
:- use_module(rules(penetration/chain)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(kernel),
              [cut_set_open/2, cut_set_close/1, model_tolerance/1]).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(penetration/resolve)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests('rules/sample')).
:- use_module(tests('oracle/resolve')).

/* Things that touch but for rounding. A scene whose solids touch exactly is
   turned as a whole by random rotations, which opens every contact by a
   rounding error or closes it; its lines must stay the same: the same polygons
   in the same points, each known by what made it. RESOLVE_TURNS=N in the
   environment turns each scene N times as often. */

turns(N0, N) :-
    (   getenv('RESOLVE_TURNS', Text)
    ->  atom_number(Text, Times)
    ;   Times = 1
    ),
    few(N0//10, N0, N1),
    N is max(1, N1)*Times.

/* - - - scenes - - - */

scene(boxes_sharing_part_of_a_face, 1000, [A, B]) :-
    box(2,2,2, 0,0,0, A), box(2,2,2, 2,1,0.5, B).
scene(box_beside_box_flush, 100, [A, B]) :-
    box(3,1,1, 0,0,0, A), box(1,1,2, 1,0,1, B).
scene(same_box_twice, 100, [A, A]) :-
    box(2,3,4, 0,0,0, A).
scene(box_on_a_plane, 1000, [rectangle(size(6,6)), A]) :-
    box(1,1,1, 0.25,0,0, A).
scene(apex_on_an_edge, 1000,
      [ A, at([rotate(x,180),translate(1,0.25,3)],
              pyramid(base(1,1), height(1))) ]) :-
    box(2,2,2, 0,0,0, A).
scene(apex_on_a_face, 100,
      [ A, at([rotate(x,180),translate(0.3,0.2,3)],
              pyramid(base(1,1), height(1))) ]) :-
    box(2,2,2, 0,0,0, A).
scene(edge_on_edge, 100,
      [ at([rotate(x,45)], A), at([rotate(y,45),translate(0,0,H)], A) ]) :-
    box(2,2,2, 0,0,-1, A),
    H is 2*sqrt(2).
scene(equal_cylinders, 1000,
      [ at([translate(0,0,-2)], A),
        at([translate(0,0,-2),rotate(x,90)], A) ]) :-
    A = cylinder(radius(1), height(4), facets(12)).
scene(pyramid_flush_on_a_box, 100,
      [ A, at([translate(0,0,2)], pyramid(base(2,2), height(1))) ]) :-
    box(2,2,2, 0,0,0, A).
scene(frustum_on_a_box, 60,
      [ A, at([translate(0.1,0,2)],
              cone(radius(0.7), top(0.3), height(1), facets(12))) ]) :-
    box(2,2,2, 0,0,0, A).
scene(stack_of_boxes, 60, [A, B, C]) :-
    box(3,3,1, 0,0,0, A), box(2,2,1, 0.5,0.5,1, B), box(1,1,1, 1,1,2, C).
scene(tower_of_cylinders, 20,
      [ cylinder(radius(1), height(1), facets(16)),
        at([translate(0,0,1)], A), at([rotate(z,7.5),translate(0,0,2)], A) ]) :-
    A = cylinder(radius(0.8), height(1), facets(16)).
scene(chain_of_boxes, 20, Boxes) :-
    findall(Box, ( between(0, 9, I), Y is 0.25*(I mod 3),
                   box(1,1,1, I,Y,0, Box) ),
            Boxes).
scene(boxes_on_a_floor, 5, [Floor|Boxes]) :-
    box(12,12,1, 0,0,-1, Floor),
    findall(at([rotate(z,A),translate(X,Y,0)], box(size(0.5,0.5,1))),
            ( between(0, 5, I), between(0, 5, J),
              X is 1.25*I-3, Y is 1.25*J-3, A is (6*I+J)*3.7 ),
            Boxes).
scene(two_u_in_each_other, 60, [u(0,0,0), u(1,1,1)]).
scene(l_on_l, 60, [l(0,0,0), l(0.5,0.25,1)]).

box(A, B, C, X, Y, Z, at([translate(X,Y,Z)], box(size(A,B,C)))).

%   entered(+Solid): a primitive, or a prism that is not convex.

entered(u(X,Y,Z)) :-
    !,
    prism([0-0, 3-0, 3-3, 2-3, 2-1, 1-1, 1-3, 0-3], X, Y, Z).
entered(l(X,Y,Z)) :-
    !,
    prism([0-0, 2-0, 2-1, 1-1, 1-2, 0-2], X, Y, Z).
entered(Primitive) :-
    add_primitive(Primitive, _).

prism(Base, X0, Y0, Z0) :-
    fresh_id(segment, 0, S),
    assert_fact(segment(S, solid, prism)),
    length(Base, N),
    forall(( between(0, 1, Up), nth1(I, Base, X-Y) ),
           ( V is Up*N+I, Px is float(X0+X), Py is float(Y0+Y),
             Pz is float(Z0+Up), assert_fact(v(S, V, Px, Py, Pz)) )),
    numlist(1, N, Top0),
    reverse(Top0, Bottom),
    Last is 2*N,
    First is N+1,
    numlist(First, Last, Top),
    polygon(S, Bottom),
    polygon(S, Top),
    forall(between(1, N, I),
           ( J is I mod N+1, A is I+N, B is J+N, polygon(S, [I,J,B,A]) )).

polygon(S, Corners) :-
    Corners = [First|Rest],
    append(Rest, [First], Next),
    maplist(edge(S), Corners, Next, Es),
    fresh_id(p, S, P),
    assert_fact(p(S, P, Es)).

edge(S, A, B, E) :-
    fresh_id(e, S, E),
    assert_fact(e(S, E, A, B, 1)).

/* - - - turning - - - */

%   turned(+Solids, +Rotation, :Goal): Goal holds where Solids, rotated, have
%   cut each other; with Pairs, where those have. Rotation is the rows of a
%   matrix.

:- meta_predicate turned(+, +, 0), turned(+, +, +, 0).

turned(Solids, Rotation, Goal) :-
    turned(Solids, Rotation, all, Goal).

turned(Solids, Rotation, Pairs, Goal) :-
    new_world(World),
    in_world(World,
             ( maplist(entered, Solids),
               forall(v(S, V, X, Y, Z), move(Rotation, S, V, X-Y-Z)),
               complete_segments,
               penetrate(Pairs, []),
               Goal )).

move(none, _, _, _) :-
    !.
move(Rows, S, V, At) :-
    maplist(times(At), Rows, [X,Y,Z]),
    facts_transaction(( retract_fact(v(S, V, _, _, _)),
                        assert_fact(v(S, V, X, Y, Z)) )).

times(X-Y-Z, A-B-C, R) :-
    R is A*X+B*Y+C*Z.

%   A random rotation, as a unit quaternion.

rotation([ A00-A01-A02, A10-A11-A12, A20-A21-A22 ]) :-
    maplist(random_between(-1000000, 1000000), [W0,X0,Y0,Z0]),
    Norm is sqrt(W0^2+X0^2+Y0^2+Z0^2),
    W is W0/Norm, X is X0/Norm, Y is Y0/Norm, Z is Z0/Norm,
    A00 is 1-2*(Y*Y+Z*Z), A01 is 2*(X*Y-Z*W), A02 is 2*(X*Z+Y*W),
    A10 is 2*(X*Y+Z*W), A11 is 1-2*(X*X+Z*Z), A12 is 2*(Y*Z-X*W),
    A20 is 2*(X*Z-Y*W), A21 is 2*(Y*Z+X*W), A22 is 1-2*(X*X+Y*Y).

/* - - - what must stay the same - - - */

%   lines(-Lines): each line by its polygons and the features of its ends; and
%   the chains by kind and number of lines.

lines(Lines-Chains) :-
    findall(line(S1-P1, S2-P2, Ends),
            ( line(_, S1, P1, A1, B1, S2, P2, A2, B2),
              maplist(end_feature, [S1-A1/S2-A2, S1-B1/S2-B2], Ends0),
              msort(Ends0, Ends) ),
            Lines0),
    msort(Lines0, Lines),
    findall(S1-S2-Kind-N,
            ( chain(_, S1, S2, Kind, Ls), length(Ls, N) ),
            Chains0),
    msort(Chains0, Chains).

end_feature(S1-V1/S2-V2, Feature) :-
    feature(S1, V1, F1),
    feature(S2, V2, F2),
    sort([F1,F2], Feature).

%   A vertex that was there is itself, wherever it moved; of a new one counts
%   what made it, touching or not.

feature(S, V, v(S, V)) :-
    before(S, Last),
    V =< Last,
    !.
feature(S, V, Feature) :-
    origin(S, v(V), Origin),
    (   Origin = near(Feature0)
    ->  true
    ;   Feature0 = Origin
    ),
    by_segments(Feature0, Feature).

%   The triangles that meet are named by corners, which may be others; and
%   where a chord is met depends on how a polygon was triangulated.

by_segments(ll(Line1, Line2), Feature) :-
    select(S-(A,B), [Line1,Line2], [Line]),
    \+ edge_before(S, A, B),
    !,
    Feature = lpi(Line, S).
by_segments(lpi(E, S-_), lpi(E, S)) :- !.
by_segments(tpi(S1-_, S2-_, S3-_), tpi(S1, S2, S3)) :- !.
by_segments(Feature, Feature).

:- dynamic before/2, edge_before/3.

count_before(Solids) :-
    retractall(before(_, _)),
    retractall(edge_before(_, _, _)),
    new_world(World),
    in_world(World,
             ( maplist(entered, Solids),
               forall(segment(S, _, _),
                      ( aggregate_all(max(V), v(S,V,_,_,_), Last),
                        assertz(before(S, Last)) )),
               forall(e(S, _, A, B, 1), assertz(edge_before(S, A, B))) )).

%   different(+Solids, +Expected, +Turns, -Count): Count of that many rotations
%   give other lines than Expected.

different(Solids, Expected, Turns, Count) :-
    findall(x,
            ( between(1, Turns, _),
              rotation(Rotation),
              \+ ( turned(Solids, Rotation, lines(Lines)),
                   Lines == Expected ) ),
            Different),
    length(Different, Count).

/* - - - tangles - - - */

%   Random solids on a coarse grid, where most contacts are of several kinds at
%   once. How a straight line is divided may differ when they are turned (by
%   chords), so what counts is how long the lines of two polygons are.

tangle(Seed, N, Solids) :-
    set_random(seed(Seed)),
    length(Solids, N),
    maplist(random_solid, Solids).

random_solid(Solid) :-
    random_member(Kind, [box,pyramid,l,u]),
    maplist(random_between(0, 3), [X,Y,Z]),
    maplist(random_between(1, 3), [A,B,C]),
    solid(Kind, X-Y-Z, A-B-C, Solid).

solid(box, X-Y-Z, A-B-C, Box) :-
    Px is X+A/2,
    Py is Y+B/2,
    box(A, B, C, Px, Py, Z, Box).
solid(pyramid, X-Y-Z, A-B-C, at([translate(X,Y,Z)], Pyramid)) :-
    A2 is 2*A,
    B2 is 2*B,
    Pyramid = pyramid(base(A2,B2), height(C)).
solid(l, X-Y-Z, _, l(X,Y,Z)).
solid(u, X-Y-Z, _, u(X,Y,Z)).

%   lengths(-Lengths): of the lines of each two polygons.

lengths(Lengths) :-
    findall(at(S1, P1, S2, P2)-Length,
            ( line(_, S1, P1, A, B, S2, P2, _, _),
              v(S1, A, X, Y, Z),
              v(S1, B, X1, Y1, Z1),
              Length is sqrt((X-X1)^2+(Y-Y1)^2+(Z-Z1)^2) ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    findall(Key-Sum,
            ( member(Key-Parts, Groups),
              sum_list(Parts, Sum0),
              Sum is round(Sum0*1.0e6),
              Sum > 0 ),
            Lengths).

%   edge_fault(-Fault): a polygon does not close, or an edge between two
%   polygons of a solid is not there once each way.

edge_fault(open(S, P)) :-
    p(S, P, Es),
    findall(V, ( member(E, Es), e(S, E, V, _, _) ), Starts0),
    findall(V, ( member(E, Es), e(S, E, _, V, _) ), Ends0),
    msort(Starts0, Starts),
    msort(Ends0, Ends),
    Starts \== Ends.
edge_fault(unpaired(S, A, B)) :-
    e(S, _, A, B, _),
    aggregate_all(count, e(S, _, A, B, _), There),
    aggregate_all(count, e(S, _, B, A, _), Back),
    There-Back \== 1-1.

:- begin_tests(resolve).

test(tangles, [ forall(member(N-Last, [2-40,3-40,4-20,6-8])),
                true(Bad == []) ]) :-
    findall(Seed-Fault,
            ( between(1, Last, Seed),
              tangle(Seed, N, Solids),
              once(turned(Solids, none, lengths(Expected))),
              rotation(Rotation),
              once(( tangle_fault(Solids, Rotation, Expected, Fault)
                   ; Fault = none )),
              Fault \== none ),
            Bad).

% Some pairs only: contacts are connected all the same.
test(some_pairs, Bad == []) :-
    findall(Seed-Pairs,
            ( between(1, 20, Seed),
              tangle(Seed, 3, Solids),
              rotation(Rotation),
              random_member(Pairs, [[1-2,1-3], [1-2], [1-3,2-3]]),
              once(turned(Solids, none, Pairs, lengths(Expected))),
              \+ ( turned(Solids, Rotation, Pairs,
                          ( lengths(Lengths), \+ edge_fault(_),
                            \+ origin(_, e(_), near) )),
                   Lengths == Expected ) ),
            Bad).

test(in_two_steps, Bad == []) :-
    findall(Seed,
            ( between(1, 20, Seed),
              tangle(Seed, 3, Solids),
              rotation(Rotation),
              once(turned(Solids, Rotation, lengths(Expected))),
              \+ ( turned_in_two_steps(Solids, Rotation, lengths(Lengths)),
                   Lengths == Expected ) ),
            Bad).

:- meta_predicate turned_in_two_steps(+, +, 0).

turned_in_two_steps(Solids, Rotation, Goal) :-
    append(First, [Last], Solids),
    new_world(World),
    in_world(World,
             ( maplist(entered, First),
               forall(v(S, V, X, Y, Z), move(Rotation, S, V, X-Y-Z)),
               complete_segments,
               penetrate,
               aggregate_all(count, segment(_, _, _), Before),
               entered(Last),
               forall(( v(S, V, X, Y, Z), S > Before ),
                      move(Rotation, S, V, X-Y-Z)),
               complete_segments,
               penetrate,
               Goal )).

tangle_fault(Solids, Rotation, Expected, Fault) :-
    turned(Solids, Rotation,
           ( lengths(Lengths),
             findall(F, limit(1, edge_fault(F)), Faults) )),
    (   Lengths \== Expected
    ->  Fault = lengths(Expected, Lengths)
    ;   Faults = [Fault]
    ).

% Writing by the kernel, and by the rule: the same rows, in order.
test(write, [forall(written_case(Solids)), true(Kernel == Rule)]) :-
    set_random(seed(7)),
    rotation(Rotation),
    rows_of(resolve_contacts, Solids, Rotation, Kernel),
    rows_of(resolve_contacts_by_rule, Solids, Rotation, Rule).

written_case(Solids) :-
    scene(_, _, Solids).
written_case(Solids) :-
    between(1, 30, Seed),
    N is 2+Seed mod 4,
    tangle(Seed, N, Solids).

%   rows_of(+Resolve, +Solids, +Rotation, -Rows): all that is in the world when
%   all contacts are resolved, and whether there were any.

rows_of(Resolve, Solids, Rotation, Done-Rows) :-
    new_world(World),
    in_world(World,
             ( maplist(entered, Solids),
               forall(v(S, V, X, Y, Z), move(Rotation, S, V, X-Y-Z)),
               complete_segments,
               facts_transaction(resolved_all(Resolve, Done)),
               findall(Row, world_row(Row), Rows) )).

resolved_all(Resolve, Done) :-
    findall(S1-S2, ( segment(S1, _, _), segment(S2, _, _), S1 < S2 ), Pairs),
    model_tolerance(Tolerance),
    setup_call_cleanup(
        cut_set_open(Pairs, Set),
        (   call(Resolve, Set, Tolerance)
        ->  Done = true
        ;   Done = false
        ),
        cut_set_close(Set)).

world_row(Row) :-
    member(Row, [ v(_, _, _, _, _), e(_, _, _, _, _), p(_, _, _),
                  t(_, _, _, _, _, _), origin(_, _, _), leaf_v(_, _, _, _, _),
                  leaf_e(_, _, _, _, _), leaf_p(_, _, _),
                  leaf_t(_, _, _, _, _, _) ]),
    call(Row).

% Many tips on a floor, in straight rows: one contact each, no thin triangle of
% the floor that another tip pierces.
test(tips_in_rows, N-Points == 576-576) :-
    findall(at([ rotate(x,180), rotate(z,A), translate(X,Y,1) ],
               pyramid(base(0.5,0.5), height(1))),
            ( between(0, 23, I), between(0, 23, J),
              X is 2*I-23.5, Y is 2*J-23.7, A is (6*I+J)*3.7 ),
            Tips),
    box(50,50,1, 0,0,-1, Floor),
    set_random(seed(3)),
    rotation(Rotation),
    turned([Floor|Tips], Rotation,
           ( aggregate_all(count, line(_, _, _, _, _, _, _, _, _), N),
             aggregate_all(count, line(_, _, _, A1, A1, _, _, _, _), Points) )).

test(turned, [forall(scene(_, Turns0, Solids)), true(Different == 0)]) :-
    set_random(seed(1988)),
    count_before(Solids),
    turned(Solids, none, lines(Expected)),
    turns(Turns0, Turns),
    different(Solids, Expected, Turns, Different).

:- end_tests(resolve).
