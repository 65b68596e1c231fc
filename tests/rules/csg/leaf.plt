:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(exact)).
:- use_module(rules(csg/leaf)).
:- use_module(rules(model/model_file)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(model/model_writer)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests('oracle/leaf')).
:- use_module(tests('rules/whole_world')).

/* A second penetration: whatever order the segments come in, the same lines,
   as exact points, with the same origins. */

add(Primitives) :-
    forall(member(Primitive, Primitives), add_primitive(Primitive, _)),
    complete_segments.

%   In a new world, in steps: each step adds primitives and penetrates.

:- meta_predicate in_steps(+, 0).

in_steps(Steps, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Step, Steps), ( add(Step), penetrate )),
               Goal )).

%   exact_lines(-Lines): the lines and the origins of their points, all by
%   place; no number that a cut gave.

exact_lines(lines(Lines, Origins, Edges)) :-
    findall(line(S1, P1, S2, P2, Ends),
            ( line(_, S1, P1, A1, B1, S2, P2, A2, B2),
              place(S1, A1, A), place(S1, B1, B),
              place(S2, A2, A), place(S2, B2, B),
              msort([A,B], Ends) ),
            Lines0),
    msort(Lines0, Lines),
    findall(origin(S, Point, Origin),
            ( origin(S, v(V), Origin), place(S, V, Point) ),
            Origins0),
    msort(Origins0, Origins),
    findall(edge(S, A, B, Et),
            ( e(S, _, V1, V2, Et), place(S, V1, A), place(S, V2, B) ),
            Edges0),
    msort(Edges0, Edges).

place(S, V, p(X,Y,Z)) :-
    vertex_exact(S, V, X, Y, Z).

%   Steps that differ from all at once.

order_matters(Steps, Why) :-
    append(Steps, All),
    catch(in_steps(Steps, exact_lines(lines(Ls1, Os1, Es1))), E1, true),
    catch(in_steps([All], exact_lines(lines(Ls2, Os2, Es2))), E2, true),
    (   ( nonvar(E1) ; nonvar(E2) )
    ->  E1 \== E2,
        Why = E1-E2
    ;   Ls1 \== Ls2
    ->  Why = lines
    ;   Os1 \== Os2
    ->  Why = origins
    ;   Es1 \== Es2
    ->  Why = edges
    ).

random_shape(Grid, at([translate(X,Y,Z)|Turns], Shape)) :-
    findall(C, ( between(1, 3, _), coordinate(Grid, C) ), [X,Y,Z]),
    turns(Grid, Turns),
    random_between(1, 3, A),
    random_between(1, 3, B),
    random_between(1, 3, C),
    random_member(Shape,
                  [ box(size(A,B,C)), box(size(A,A,B)),
                    pyramid(base(A,B), height(C)),
                    cylinder(radius(A), height(B), facets(4)),
                    cylinder(radius(A), height(B), facets(3)),
                    rectangle(size(A,B))
                  ]).

coordinate(coarse, C) :-
    random_between(0, 3, C0),
    C is C0/2.0.
coordinate(irrational, C) :-
    random(C).

turns(coarse, Turns) :-
    random_member(Turns, [[], [], [rotate(x,90)], [rotate(y,180)]]).
turns(irrational, [rotate(x,A), rotate(z,B)]) :-
    random_between(0, 359, A),
    random_between(0, 359, B).

random_steps(Grid, Seed, Steps) :-
    set_random(seed(Seed)),
    findall(P, ( between(1, 4, _), random_shape(Grid, P) ), [P1,P2,P3,P4]),
    random_member(Steps, [ [[P1,P2],[P3]], [[P1],[P2],[P3]], [[P1],[P2,P3]],
                           [[P1,P2],[P3],[P4]], [[P1,P2],[P3,P4]] ]).

differing(Grid, N, Bad) :-
    findall(Seed-Why,
            ( between(1, N, Seed),
              random_steps(Grid, Seed, Steps),
              order_matters(Steps, Why) ),
            Bad).

:- begin_tests(leaf).

test(coarse, Bad == []) :-
    differing(coarse, 60, Bad).
test(irrational, Bad == []) :-
    differing(irrational, 40, Bad).

% The third goes exactly through an end, and through the middle, of a piece.
test(through_a_point, Bad == []) :-
    Box = box(size(2,2,2)),
    Bar = at([translate(1,0,0.5)], box(size(2,1,1))),
    findall(Why, ( member(At, [0.5, 1.0, 0.25]),
                   Third = at([translate(1,At,1.0)], box(size(1,1,1))),
                   order_matters([[Box,Bar],[Third]], Why) ), Bad).
test(curve, Bad == []) :-
    Line = line(from(-3,0.3,0.7), to(3,0.1,0.9)),
    Box = box(size(2,2,2)),
    Bar = at([rotate(z,31),translate(1,0,0.5)], box(size(2,1,1))),
    findall(Why, ( member(Steps, [ [[Box,Line],[Bar]], [[Line,Bar],[Box]],
                                   [[Line],[Box],[Bar]] ]),
                   order_matters(Steps, Why) ), Bad).

% Boxes that touch but for rounding: what was moved is moved back first.
test(nearly_touching, Bad == []) :-
    findall(Seed-Why,
            ( between(1, 25, Seed),
              turned_steps(Seed, Steps),
              order_matters(Steps, Why) ),
            Bad).
test(moved_back, After == Before) :-
    turned_steps(3, [[P1,P2],[P3]]),
    new_world(World),
    in_world(World,
             ( add([P1,P2,P3]),
               originals(Before),
               penetrate,
               facts_transaction(leaves_restored([1-2,1-3,2-3])),
               originals(After),
               \+ origin(_, _, _),
               \+ leaf_row(_) )).

turned_steps(Seed, [[P1,P2],[P3]]) :-
    set_random(seed(Seed)),
    random_between(1, 359, A),
    random_between(1, 359, B),
    Turn = [rotate(x,A),rotate(z,B)],
    P1 = at(Turn, box(size(2,2,2))),
    P2 = at([translate(0.5,0.25,2)|Turn], box(size(1,1,1))),
    P3 = at([translate(1.5,0,0.5)|Turn], box(size(1,1,2))).

% What is not met stays as it is, and so does what is met again by nothing.
test(far_away, Before == After) :-
    in_steps([[box(size(2,2,2)), at([translate(1,1,1)], box(size(2,2,2)))]],
             ( findall(L-A, line(L,_,_,A,_,_,_,_,_), Before),
               add([at([translate(9,9,9)], box(size(1,1,1)))]),
               penetrate,
               findall(L-A, line(L,_,_,A,_,_,_,_,_), After) )).
test(others_left_alone, Before == After) :-
    Near = [box(size(2,2,2)), at([translate(1,1,1)], box(size(2,2,2)))],
    Far = [at([translate(9,0,0)], box(size(2,2,2))),
           at([translate(10,1,1)], box(size(2,2,2)))],
    append(Near, Far, All),
    in_steps([All],
             ( findall(L-A, line(L,1,_,A,_,_,_,_,_), Before),
               add([at([translate(9,1,1)], box(size(1,1,2)))]),
               penetrate,
               findall(L-A, line(L,1,_,A,_,_,_,_,_), After) )).

% The leaves are what was there, and they name originals only.
test(kept, Bad == []) :-
    new_world(World),
    in_world(World,
             ( add([box(size(2,2,2)),
                    at([rotate(x,33),translate(1,1,1)], box(size(2,2,2)))]),
               originals(Before),
               penetrate,
               findall(E, leaf_row(E), Leaves),
               subtract(Leaves, Before, Bad) )).
test(restored, After == Before) :-
    new_world(World),
    in_world(World,
             ( add([box(size(2,2,2)),
                    at([rotate(x,33),translate(1,1,1)], box(size(2,2,2))),
                    line(from(-3,0.3,0.7), to(3,0.1,0.9))]),
               originals(Before),
               penetrate,
               facts_transaction(leaves_restored([1-2,1-3])),
               originals(After),
               \+ origin(_, _, _),
               \+ leaf_row(_) )).

% The kernel keeps what the rule keeps, in the same order; what is kept stays.
test(kernel_and_rule, Rows1-Again == Rows2-Rows1) :-
    kept(leaves_kept, Rows1, Again),
    kept(leaves_kept_by_rule, Rows2, _),
    length(Rows1, N),
    N > 100.
test(no_polygon, fail) :-
    in_steps([[box(size(2,2,2))]], leaves_kept([1-1, 1-99])).
test(no_polygon_to_keep, error(type_error(integer, a))) :-
    in_steps([[box(size(2,2,2))]], leaves_kept([1-a])).

kept(How, Rows, Again) :-
    new_world(World),
    in_world(World,
             ( add([ box(size(2,2,2)), sphere(radius(1), facets(6), bands(4)),
                     prism(outline([[0,0],[4,0],[0,4]]),
                           holes([[[1,1],[2,1],[1,2]]]), height(1)) ]),
               findall(S-P, p(S, P, _), Polygons0),
               reverse(Polygons0, Polygons1),
               Polygons1 = [One|_],
               call(How, [One]),
               append(Polygons1, [One], Polygons),
               call(How, Polygons),
               leaf_rows(Rows),
               call(How, Polygons),
               leaf_rows(Again) )).

leaf_rows(Rows) :-
    findall(Row, leaf_row(Row), Rows).

leaf_row(v(S, V, X, Y, Z)) :- leaf_v(S, V, X, Y, Z).
leaf_row(e(S, E, A, B, Et)) :- leaf_e(S, E, A, B, Et).
leaf_row(p(S, P, Es)) :- leaf_p(S, P, Es).
leaf_row(t(S, P, T, A, B, C)) :- leaf_t(S, P, T, A, B, C).

originals(Rows) :-
    findall(Row,
            ( member(Row, [v(_,_,_,_,_), e(_,_,_,_,_), p(_,_,_),
                           t(_,_,_,_,_,_), line(_,_,_,_,_,_,_,_,_)]),
              call(Row) ),
            Rows0),
    msort(Rows0, Rows).

% Saved and read back it is still exact.
test(saved, Lines == Wanted) :-
    set_random(seed(7)),
    findall(P, ( between(1, 3, _), random_shape(irrational, P) ),
            [P1,P2,P3]),
    in_steps([[P1,P2,P3]], exact_lines(Wanted)),
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [extension(pl)]), close(Out) ),
        ( in_steps([[P1,P2]], write_model(File)),
          new_world(World),
          in_world(World,
                   ( read_model(File, [], _),
                     add([P3]),
                     penetrate,
                     exact_lines(Lines) ))
        ),
        delete_file(File)).
test(written_twice, Text1 == Text2) :-
    setup_call_cleanup(
        ( tmp_file_stream(File, Out, [extension(pl)]), close(Out) ),
        ( in_steps([[box(size(2,2,2)),
                     at([rotate(x,33),translate(1,1,1)], box(size(2,2,2)))]],
                   write_model(File)),
          read_file_to_string(File, Text1, []),
          new_world(World),
          in_world(World, ( read_model(File, [], _), write_model(File) )),
          read_file_to_string(File, Text2, [])
        ),
        delete_file(File)).

% Without leaves what is there is cut, as it is.
test(leaves_missing, Ls == [1-2,1-3]) :-
    Boxes = [box(size(2,2,2)), at([translate(1,1,1)], box(size(2,2,2)))],
    in_steps([Boxes],
             ( retractall_facts(leaf_t(_, _, _, _, _, _)),
               retractall_facts(leaf_p(_, _, _)),
               retractall_facts(leaf_e(_, _, _, _, _)),
               add([at([translate(-1,-1,0.3)], box(size(1,1,1)))]),
               earlier_cuts([1-3,2-3], []),
               penetrate,
               findall(S1-S2, line(_,S1,_,_,_,S2,_,_,_), Ls0),
               sort(Ls0, Ls) )).

% What is called a curve and has polygons is cut as what it is.
test(curve_of_polygons, [forall(member(Kind, [curve,surface])),
                         true(Missing-Lines == []-Solid)]) :-
    called(solid, Solid, []),
    called(Kind, Lines, Missing).

called(Kind, Lines, Missing) :-
    new_world(World),
    in_world(World,
             ( add([box(size(2,2,2)),
                    at([translate(1,1,1),rotate(x,33)], box(size(2,2,2)))]),
               retract_fact(segment(2, solid, Term)),
               assert_fact(segment(2, Kind, Term)),
               penetrate,
               add([at([translate(-1,-1,0.3)], box(size(1,1,1)))]),
               penetrate,
               exact_lines(Lines),
               findall(Row-Id, dangling(Row, Id), Missing) )).

:- end_tests(leaf).
