/* Glue in one place of a glue that has operands: what was kept apart, item by
   item; operands stay, and files too. Cells without operands are in
   contact_glue.plt. */
:- module(test_part_glue, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(model/model)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(solid/glue)).
:- use_module(rules(solid/part_glue)).
:- use_module(rules(store)).
:- use_module(tests(rules/glue_model)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   apart(Name, Seed): segment 3 is the glue of two parts, which are apart.

apart(Name, Seed) :-
    once(model(Name, Parts, _)),
    (   Seed =:= 0
    ->  Steps = []
    ;   turned(Seed, Steps)
    ),
    glue_made(Parts, Steps, 3),
    assert_fact(gluing(3, apart(1, 2))),
    evaluate(3).

counts(Counts) :-
    glue_report(3, Report),
    report_counts(Report, Counts).

twins(Pairs) :-
    findall(V-W, ( v(3, V, X, Y, Z), v(3, W, X, Y, Z), V < W ), Pairs).

:- begin_tests(part_glue).

test(vertices, [ forall(member(Seed, [0,1])),
                 Change-Counts == change(-1,0,0,0,-1,0,-1,0)
                                  -c(15,24,12,12,1,3,3,0) ]) :-
    in_new_world(( apart(two(vertex), Seed), twins([V-W]),
                   glue_vertices(3, V, W, Change), counts(Counts) )).
test(edges, [ forall(member(Seed, [0,1])),
              Change-Counts == change(-2,-1,0,0,-1,0,-1,0)
                               -c(14,23,12,12,1,3,3,0) ]) :-
    in_new_world(( apart(two(edge), Seed), twins([A-C,B-D]),
                   glue_edges(3, A-B, D-C, Change), counts(Counts) )).
test(half_an_edge, Counts == c(16,25,12,12,1,3,3,0)) :-
    in_new_world(( apart(two(half_edge), 0), twins([A-C,B-D]),
                   glue_edges(3, A-B, C-D, _), counts(Counts) )).

%   The part that both have: figure 7.

test(faces, [ forall(member(Name-Wanted, [two(face)-c(12,20,11,11,1,3,3,0),
                                          fig7-c(18,28,13,13,1,3,3,0)])),
              Counts == Wanted ]) :-
    in_new_world(( apart(Name, 0), shared(P, Q), glue_faces(3, P, Q, _),
                   counts(Counts) )).

shared(P, Q) :-
    origin(3, p(Q), slit(P)).

%   Figure 8: an apex in an edge and in a face, a ridge in a face.

test(mixed, [ forall(member(Name-Wanted,
                            [ fig8(edge)-c(13,21,11,11,1,3,3,0),
                              fig8(face)-c(13,20,11,12,1,3,3,0),
                              fig8(ridge)-c(14,21,11,12,1,3,3,0) ])),
              Counts == Wanted ]) :-
    in_new_world(( apart(Name, 0), mixed(Name, Item1, Item2),
                   glue_mixed(3, Item1, Item2, _), counts(Counts) )).

mixed(fig8(edge), v(W), e(E)) :-
    twins([V-W]),
    once(e(3, E, V, _, _)).
mixed(fig8(face), v(W), p(P)) :-
    twins([V-W]),
    lies_in(3, v(V), p(P)).
mixed(fig8(ridge), e(E), p(P)) :-
    twins([A-C,B-D]),
    once(e(3, E, C, D, _)),
    once(( e(3, Seam, A, B, _), p(3, P, Es), memberchk(Seam, Es) )).

%   One step of undo; the operands are as they were; a file says it again.

test(undo, Before == After) :-
    in_new_world(( apart(two(face), 0), counts(Before), shared(P, Q),
                   glue_faces(3, P, Q, _), facts_undo, counts(After) )).
test(unglue, Rows == Rows0) :-
    in_new_world(( apart(two(face), 0), operands(Rows0), shared(P, Q),
                   glue_faces(3, P, Q, _), unglue(3), operands(Rows) )).

operands(Vs-Ps) :-
    findall(v(S,V,X,Y,Z), ( member(S, [1,2]), v(S, V, X, Y, Z) ), Vs),
    findall(p(S,P,Es), ( member(S, [1,2]), p(S, P, Es) ), Ps).

test(file, Counts == c(12,20,11,11,1,3,3,0)) :-
    tmp_file_stream(File, Stream, [extension(pl)]),
    close(Stream),
    in_new_world(( apart(two(face), 0), shared(P, Q),
                   glue_faces(3, P, Q, _), save_model(File) )),
    in_new_world(( load_model(File), counts(Counts) )).

%   What is not in one place, or not there, or glued already.

test(apart, [ forall(member(Goal, [ glue_vertices(3, 1, 3, _),
                                    glue_edges(3, 1-2, 3-4, _),
                                    glue_faces(3, 1, 2, _) ])),
              error(geometry_error(part_glue(not_glued(3, _, _, apart)))) ]) :-
    in_new_world(( apart(two(face), 0), call(Goal) )).
test(beside, error(geometry_error(part_glue(not_glued(3, v(1), p(2),
                                                      beside))))) :-
    in_new_world(( apart(two(face), 0), glue_mixed(3, v(1), p(2), _) )).
test(none, [ forall(member(Goal-Type, [ glue_vertices(3, 1, 99, _)-vertex,
                                        glue_edges(3, 1-2, 1-99, _)-edge,
                                        glue_faces(3, 99, 2, _)-polygon ])),
             error(existence_error(Type, _)) ]) :-
    in_new_world(( apart(two(face), 0), call(Goal) )).

%   One vertex of two faces that lie on each other: on which side is what?

test(touching, error(geometry_error(part_glue(not_glued(3, _, _,
                                                        touching))))) :-
    in_new_world(( apart(two(face), 0), twins([V-W|_]),
                   glue_vertices(3, V, W, _) )).

:- end_tests(part_glue).
