/* Faces that become one: rules/solid/faces.pl. */
:- use_module(library(aggregate)).
% covers: source
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(solid/arrangement)).
:- use_module(rules(solid/boolean)).
:- use_module(rules(decision), [use_rules/1]).
:- use_module(rules(solid/faces)).
:- use_module(rules(kernel)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests('oracle/solid_rows'), [solid_counts/4]).
:- use_module(tests('rules/boolean_case'), [measured/2]).

%   merged(+Terms, +Expression, +Options, -Counts): of solids 1, 2, ..., Counts
%   being Faces/Vertices/Edges.

merged(Terms, Expression, Options, Counts) :-
    in_model(Terms, ( solid_of(Expression, Solid),
                      faces_merged(Solid, Options),
                      counted(Solid, Counts) )).

:- meta_predicate in_model(+, 0).

in_model(Terms, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Term, Terms), add_primitive(Term, _)),
               complete_segments,
               Goal )).

solid_of(Expression, Solid) :-
    expression_leaves(Expression, Leaves),
    with_arrangement(Leaves, [], boundary(Expression, Solid)).

boundary(Expression, Solid, Arrangement) :-
    select_boundary(Arrangement, Expression, Solid).

counted(Solid, Faces/Vertices/Edges) :-
    solid_counts(Solid, Vertices, Faces, _),
    solid_faces(Solid, Rows),
    findall(A-B,
            ( member(face(_, _, _, Ts), Rows), border(Ts, A, B), A < B ),
            Edges0),
    sort(Edges0, Edges1),
    length(Edges1, Edges).

border(Ts, A, B) :-
    findall(A1-B1, ( member(T, Ts), half_edge(T, A1, B1) ), Pairs0),
    sort(Pairs0, Pairs),
    member(A-B, Pairs),
    \+ memberchk(B-A, Pairs).

half_edge(t(A, B, _, _), A, B).
half_edge(t(_, B, C, _), B, C).
half_edge(t(A, _, C, _), C, A).

:- begin_tests(faces).

pair(l, [box(size(1, 1, 3)), at([translate(1, 0, 0)], box(size(1, 1, 1)))],
     8/12/18).
pair(cube2, [box(size(2, 2, 2)), at([translate(2, 0, 1)], box(size(2, 2, 2)))],
     10/16/24).
pair(on_top, [box(size(2, 2, 2)), at([translate(0, 0, 2)], box(size(1, 1, 1)))],
     11/16/24).
pair(stack, [box(size(2, 2, 2)), at([translate(0, 0, 2)], box(size(2, 2, 1)))],
     6/8/12).
pair(pyramid, [ box(size(2, 2, 2)),
                at([translate(0, 0, 2)], pyramid(base(2, 2), height(1)))
              ], 9/9/16).
pair(frustum, [ box(size(4, 4, 2)),
                at([translate(0, 0, 2)],
                   cone(radius(1), top(0.5), height(1), facets(12)))
              ], 19/32/48).
pair(in_an_edge, [ box(size(2, 2, 2)),
                   at([translate(2, 2, 0)], box(size(2, 2, 2)))
                 ], 12/14/23).

test(union, [forall(pair(_, Terms, Counts)), true(Got == Counts)]) :-
    merged(Terms, union([1,2]), [], Got).
test(turned, [forall(pair(Name, Terms, Counts)), true(Bad-Name == 0-Name)]) :-
    set_random(seed(7)),
    findall(x, ( between(1, 20, _),
                 turned(Terms, Turned),
                 merged(Turned, union([1,2]), [], Got),
                 Got \== Counts ),
            Bads),
    length(Bads, Bad).

turned(Terms, Turned) :-
    length(Numbers, 7),
    maplist(random, Numbers),
    Numbers = [X, Y, Z, U, V, W, Part],
    Angle is 360 * Part,
    findall(at([rotate(axis(X, Y, Z), Angle), translate(U, V, W)], Term),
            member(Term, Terms),
            Turned).

wedge(polyhedron(points([ [-2.5,0,0], [2.5,0,0], [-2.5,-1,2], [2.5,-1,2],
                          [-2.5,1,2], [2.5,1,2]
                        ]),
                 faces([ [1,2,4,3], [2,1,5,6], [3,4,6,5], [1,3,5], [2,6,4] ]))).

test(difference, [true(Got == 10/16/24)]) :- % a tunnel
    merged([ box(size(4, 4, 4)),
             at([translate(0, 0, 1)], box(size(2, 4, 2)))
           ], difference([1,2]), [], Got).
test(origins_separate, [true(Got == 12/16/26)]) :-
    pair(cube2, Terms, _),
    merged(Terms, union([1,2]), [origins(separate)], Got).
%   A wedge stands with its edge on two slabs that become one face, beside pegs
%   that are nearer to the edge than its ends are: it stays a chord of the face.

test(edge_in_the_middle, [true(Faces-Good-InLine-Shared == 26-yes-0-2)]) :-
    wedge(Wedge),
    Terms = [ at([translate(-1.5, 0, -1)], box(size(3, 6, 1))),
              at([translate(1.5, 0, -1)], box(size(3, 6, 1))),
              Wedge,
              at([translate(1.2, 0.4, 0)], box(size(0.1, 0.4, 0.3))),
              at([translate(-1.2, -0.4, 0)], box(size(0.1, 0.4, 0.3))),
              at([translate(1.3, -0.4, 0)], box(size(0.1, 0.4, 0.3)))
            ],
    in_model(Terms, ( boolean(union([1,2,3,4,5,6]), 7),
                      measured([7], [Measure]),
                      aggregate_all(count, p(7, _, _), Faces) )),
    Good = Measure.good,
    InLine = Measure.in_line,
    Shared = Measure.shared.
test(parts) :-
    pair(l, Terms, _),
    in_model(Terms, ( solid_of(union([1,2]), Solid),
                      faces_merged(Solid, []),
                      solid_faces(Solid, Faces),
                      solid_parts(Solid, Parts) )),
    findall(S, member(face(S, _, 1, _), Faces), Ss0),
    msort(Ss0, [1,1,1,1,1,1,2,2]),
    findall(S, member(part(_, S, _, 1), Parts), [2,2,2]).

test(neighbours) :-
    pair(l, Terms, _),
    in_model(Terms, ( solid_of(union([1,2]), Solid),
                      solid_neighbours(Solid, 1.0e-9, Pairs) )),
    length(Pairs, 3),
    forall(member(part(S1, _, 1)-part(S2, _, 1), Pairs), S1-S2 == 1-2).

test(decision, [true(Got == 10/14/22)]) :-
    tmp_file_stream(File, Out, [extension(pl), encoding(utf8)]),
    format(Out, "merge_faces(part(S, _, _), part(S, _, _)).~n", []),
    format(Out, "merge_faces(part(1, P, _), _) :- P =:= 1.~n", []),
    close(Out),
    pair(l, Terms, _),
    in_model(Terms, ( use_rules(File),
                      solid_of(union([1,2]), Solid),
                      faces_merged(Solid, []),
                      counted(Solid, Got) )),
    delete_file(File).

%   A box of 1 beside one of 10^12: its own tolerance is the smaller one.

test(by_size, [true(Counts == [6,6])]) :-
    Terms = [ box(size(1.0e12, 1.0e12, 1)), box(size(1, 1, 0.5)) ],
    in_model(Terms, findall(Faces, small_faces(Faces), Counts)).

small_faces(Faces) :-
    member(S-Options, [11-[], 12-[faces(pieces)]]),
    boolean(intersection([1,2]), S, Options),
    aggregate_all(count, p(S, _, _), Faces).

%   Two walls are a hundredth off one plane: a number merges them, and what is
%   as large for the model does not, as the solid is so small; unless that is
%   asked.

test(as_given, [ forall(member(Options-Faces,
                               [ [tolerance(0.02)]-6,
                                 [tolerance(own(0.02))]-7,
                                 [tolerance(0.02),by_size(true)]-7,
                                 [tolerance(own(0.02)),by_size(false)]-6 ])),
                 true(Found == Faces) ]) :-
    in_model([prism(outline([[0,0],[2,0],[2,1],[1,1.01],[0,1]]), height(1))],
             ( solid_take([1], Solid),
               faces_merged(Solid, Options),
               counted(Solid, Found/_/_) )).

test(bad_tolerance, [error(domain_error(not_less_than_zero, -1))]) :-
    in_model([box(size(1, 1, 1))], ( solid_take([1], Solid),
                                     faces_merged(Solid, [tolerance(-1)]) )).
test(bad_origins, [error(domain_error(origins, apart))]) :-
    in_model([box(size(1, 1, 1))], ( solid_take([1], Solid),
                                     faces_merged(Solid, [origins(apart)]) )).
test(bad_part, [error(type_error(part, x))]) :-
    in_model([box(size(1, 1, 1))],
             ( solid_take([1], Solid),
               solid_merge(Solid, 0, [apart([x-part(1, 1, 1)])], _) )).
test(bad_sense, [error(domain_error(sense, 0))]) :-
    in_model([box(size(1, 1, 1))],
             ( solid_take([1], Solid),
               solid_merge(Solid, 0, [apart([part(1, 1, 0)-part(1, 1, 1)])],
                           _) )).
test(bad_list, [error(type_error(list, x))]) :-
    in_model([box(size(1, 1, 1))], ( solid_take([1], Solid),
                                     solid_merge(Solid, 0, [apart(x)], _) )).
test(closed, [error(existence_error(solid, _))]) :-
    in_model([box(size(1, 1, 1))], ( solid_take([1], Solid),
                                     solid_close(Solid),
                                     solid_merge(Solid, 0, [], _) )).

:- end_tests(faces).
