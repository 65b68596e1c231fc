:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(time)).
:- use_module(rules(solid/arrangement)).
:- use_module(rules(solid/boolean)).
:- use_module(rules(kernel)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(tests('oracle/solid_rows')).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).

/* Solids under way: taken from segments, written as new ones. */

:- meta_predicate with_primitives(+, 0).

with_primitives(Primitives, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Primitive, Primitives),
                      add_primitive(Primitive, _)),
               complete_segments,
               Goal )).

two_boxes([box(size(2,2,2)), box(size(3,3,3))]).

:- begin_tests(solid_taken).

test(take, Counts == counts(16, 12, 24)) :-
    two_boxes(Boxes),
    with_primitives(Boxes,
                    ( solid_take([2, 1, 2], Solid),
                      solid_counts(Solid, Vertices, Faces, Triangles) )),
    Counts = counts(Vertices, Faces, Triangles).
test(take_one, Vertices-Faces == 8-6) :-
    two_boxes(Boxes),
    with_primitives(Boxes,
                    ( solid_take([2], Solid),
                      solid_counts(Solid, Vertices, Faces, _) )).
test(take_nothing, Vertices-Faces-Triangles == 0-0-0) :-
    with_primitives([], ( solid_take([7], Solid),
                          solid_counts(Solid, Vertices, Faces, Triangles) )).
test(by_polygon, Sizes == [1-2, 2-1]) :-
    with_primitives([],
        ( maplist(assert_fact,
                  [ v(1,1,0,0,0), v(1,2,1,0,0), v(1,3,1,1,0), v(1,4,0,1,0),
                    p(1,2,[]), p(1,1,[]), t(1,1,9,1,2,3), t(1,2,5,1,3,2),
                    t(1,1,3,1,3,4) ]),
          solid_take([1], Solid),
          solid_faces(Solid, Faces),
          findall(P-N, ( member(face(1, P, 1, Ts), Faces), length(Ts, N) ),
                  Sizes) )).

test(closed, error(existence_error(solid, _))) :-
    with_primitives([box(size(2,2,2))],
                    ( solid_take([1], Solid),
                      solid_close(Solid),
                      solid_counts(Solid, _, _, _) )).
test(not_a_solid, error(type_error(solid, 1))) :-
    solid_counts(1, _, _, _).
test(no_solid, error(instantiation_error)) :-
    solid_counts(_, _, _, _).
test(not_segments, error(type_error(integer, a))) :-
    solid_take([a], _).

:- end_tests(solid_taken).

:- begin_tests(solid_written).

%   rows_of(+S, -Rows): all but planes, whose last digits are nobody's.

rows_of(S, Rows) :-
    findall(Row, row_of(S, Row), Rows).

row_of(S, v(V, X, Y, Z))        :- v(S, V, X, Y, Z).
row_of(S, e(E, A, B, Et))       :- e(S, E, A, B, Et).
row_of(S, p(P, Es))             :- p(S, P, Es).
row_of(S, t(P, T, A, B, C))     :- t(S, P, T, A, B, C).
row_of(S, from_v(V, T, W))      :- from_v(S, V, T, W).
row_of(S, from_p(P, T, Q, Way)) :- from_p(S, P, T, Q, Way).
row_of(S, origin(Item, Origin)) :- origin(S, Item, Origin).

plane_differs(S1, S2, P) :-
    plane(S1, P, A1, B1, C1, D1),
    \+ ( plane(S2, P, A2, B2, C2, D2),
         maplist([X,Y]>>(abs(X-Y) < 1.0e-12), [A1,B1,C1,D1], [A2,B2,C2,D2]) ).

%   both_ways(+Solid, -Rows, -Differ): by the kernel and by the rule.

both_ways(Solid, Rows, Differ) :-
    facts_transaction(solid_write(Solid, 501)),
    facts_transaction(solid_written_by_rule(Solid, 502)),
    rows_of(501, Rows),
    rows_of(502, Rows2),
    findall(P, ( plane_differs(501, 502, P) ; plane_differs(502, 501, P) ),
            Differ0),
    (   Rows == Rows2
    ->  Differ = Differ0
    ;   subtract(Rows, Rows2, Only1),
        subtract(Rows2, Rows, Only2),
        Differ = [only(Only1, Only2)|Differ0]
    ).

several([ box(size(1,2,3)), cylinder(radius(1), height(2), facets(70)),
          hollow_cylinder(radius(2), inner(1), height(1), facets(9)),
          sphere(radius(1), facets(8), bands(5)),
          torus(radius(3), tube(1), facets(7), sides(5)) ]).

:- meta_predicate with_several(0).

with_several(Goal) :-
    several(Primitives),
    with_primitives(Primitives, Goal).

test(kernel_and_rule, Differ == []) :-
    with_several(( solid_take([1,2,3,4,5], Solid),
                   both_ways(Solid, _, Differ) )).
test(kernel_and_rule_after_cuts,
     [forall(member(Expression, [union([1,2]), difference([1,2]),
                                 intersection([1,2])])),
      true(Differ-Made == []-made)]) :-
    with_primitives([ box(size(2,2,2)),
                      at([translate(1,0.5,0.7), rotate(z, 20)],
                         box(size(2,2,2))) ],
        ( with_arrangement([1,2], [],
                           selected(Expression, Solid)),
          both_ways(Solid, Rows, Differ) )),
    (   memberchk(origin(v(_), _), Rows)
    ->  Made = made
    ;   Made = none
    ).

:- public selected/3.

selected(Expression, Solid, Arrangement) :-
    select_boundary(Arrangement, Expression, Solid).

test(same_as_before, Parts1 == Parts2) :-
    with_several(( census(Parts1a),
                   maplist(measures(0), Parts1a, Parts1),
                   forall(between(1, 5, S),
                          ( solid_take([S], Solid),
                            S2 is S+10,
                            solid_write(Solid, S2),
                            segment(S, Kind, Name),
                            assert_fact(segment(S2, Kind, Name)) )),
                   census(All),
                   append(_, Parts2a, All),
                   length(Parts2a, 5),
                   maplist(measures(10), Parts2a, Parts2) )).

%   measures(+Shift, +Part, -Measures): what must be the same, volumes to 12
%   digits.

measures(Shift, part(S, Counts, Box, Area, Volume, _, Shells, Defects),
         part(S0, Counts, Box, Area1, Volume1, N, Defects)) :-
    S0 is S-Shift,
    length(Shells, N),
    Area1 is round(Area*1.0e12),
    Volume1 is round(Volume*1.0e12).

test(unused_vertices, Vs == [0.0, 1.0, 2.0]) :-
    with_primitives([],
        ( maplist(assert_fact,
                  [ v(1,1,0,0,0), v(1,2,9,9,9), v(1,3,1,0,0), v(1,4,2,1,0),
                    p(1,1,[]), t(1,1,1,1,3,4) ]),
          solid_take([1], Solid),
          both_ways(Solid, _, []),
          findall(X, v(501, _, X, _, _), Vs) )).
test(auxiliary_edges, Ets == [1, 0, 1]) :-
    with_primitives([],
        ( maplist(assert_fact,
                  [ v(1,1,0,0,0), v(1,2,1,0,0), v(1,3,0,1,0),
                    e(1,1,1,2,1), e(1,2,2,3,0), e(1,3,3,1,1),
                    p(1,1,[1,2,3]), t(1,1,1,1,2,3) ]),
          solid_take([1], Solid),
          both_ways(Solid, _, []),
          findall(Et, e(501, _, _, _, Et), Ets) )).
test(no_area, Ps == [2]) :-
    with_primitives([],
        ( maplist(assert_fact,
                  [ v(1,1,0,0,0), v(1,2,1,0,0), v(1,3,2,0,0), v(1,4,0,1,0),
                    p(1,1,[]), p(1,2,[]), p(1,3,[]),
                    t(1,1,1,1,2,3), t(1,2,2,1,2,4), t(1,3,3,1,3,2) ]),
          solid_take([1], Solid),
          both_ways(Solid, _, []),
          findall(P, plane(501, P, _, _, _, _), Ps) )).
test(nothing, Rows == []) :-
    with_primitives([], ( solid_take([1], Solid),
                          both_ways(Solid, Rows, []) )).

test(has_rows, error(permission_error(write, segment, 1))) :-
    with_primitives([box(size(1,1,1))],
                    ( solid_take([1], Solid), solid_write(Solid, 1) )).
test(has_origins, error(permission_error(assert, fact, origin/3))) :-
    with_primitives([box(size(1,1,1))],
                    ( assert_fact(origin(2, node(2), n)),
                      assert_fact(origin(2, v(1), mine)),
                      solid_take([1], Solid),
                      solid_write(Solid, 2) )).
test(has_no_rows_any_more, Rows1 == Rows2) :-
    with_primitives([box(size(1,1,1))],
                    ( solid_take([1], Solid),
                      solid_write(Solid, 2),
                      rows_of(2, Rows1),
                      facts_transaction(
                          maplist(retractall_facts,
                                  [ v(2,_,_,_,_), e(2,_,_,_,_), p(2,_,_),
                                    plane(2,_,_,_,_,_), t(2,_,_,_,_,_),
                                    from_v(2,_,_,_), from_p(2,_,_,_,_) ])),
                      solid_write(Solid, 2),
                      rows_of(2, Rows2) )).
test(rolled_back, Rows-Vs == []-[1]) :-
    with_primitives([box(size(1,1,1))],
                    ( solid_take([1], Solid),
                      \+ facts_transaction(( solid_write(Solid, 2), fail )),
                      rows_of(2, Rows),
                      fresh_id(v, 2, V),
                      Vs = [V] )).
test(undone, Counts == [8, 0, 8]) :-
    with_primitives([box(size(1,1,1))],
                    ( solid_take([1], Solid),
                      facts_transaction(solid_write(Solid, 2)),
                      count(2, N1),
                      facts_undo,
                      count(2, N2),
                      facts_redo,
                      count(2, N3),
                      Counts = [N1,N2,N3] )).

count(S, N) :-
    findall(V, v(S, V, _, _, _), Vs),
    length(Vs, N).

:- end_tests(solid_written).
