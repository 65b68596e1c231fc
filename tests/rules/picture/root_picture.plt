:- module(test_root_picture, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(rules(picture/contour), [line_ends/4]).
:- use_module(rules(csg/csg), [root_segment/1]).
:- use_module(rules(solid/csg_evaluate), [evaluate/0]).
:- use_module(rules(csg/csg_roots),
              [roots_alone/0, operand_lines/1, with_operand_lines/2]).
:- use_module(rules(csg/csg_term), [is_node_term/1]).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(kernel), [known_facets/3]).
:- use_module(rules(csg/known_surface)).
:- use_module(rules(model/model), [load_model/1, save_model/1]).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(picture/view)).
:- use_module(tests('rules/polyhedron'), [in_new_world/1]).
:- use_module(tests('oracle/known_surface')).

/* What a picture needs to know of smooth surfaces stays known when the roots of
   a CSG tree are alone, when they are turned, and when they are written. */

round(cylinder, cylinder(radius(1), height(2), facets(10))).
round(ball,     at([translate(0.2,0.9,1.5)], sphere(radius(0.8), facets(12)))).
round(ring,     at([rotate(x,90)], torus(radius(1), tube(0.3), facets(10),
                                         sides(6)))).
round(spire,    cone(radius(1), top(0.3), height(2), facets(9))).

block(at([translate(0.3,0.2,0.5)], box(size(2,2,2)))).

tree(Name-Term) :-
    round(Name, Round),
    block(Block),
    member(Term, [union([Round,Block]), difference([Round,Block]),
                  difference([Block,Round])]).
tree(joined-join([difference([Round,Block]), at([translate(4,0,0)], Ball)])) :-
    round(cylinder, Round),
    round(ball, Ball),
    block(Block).
tree(moved_join-at([rotate(x,30),scale(1,2,-1),translate(1,2,3)],
                   join([difference([Round,Ball]),
                         at([translate(4,0,0)], Ball), Block]))) :-
    round(cylinder, Round),
    round(ball, Ball),
    block(Block).
tree(moved_twice-at([rotate(axis(1,2,3),50)],
                    join([ at([translate(0,0,5)],
                              join([union([Round,Block]),
                                    at([translate(4,0,0)],
                                       difference([Ball,Round]))])),
                           at([translate(-4,0,0)], Round) ]))) :-
    round(cylinder, Round),
    round(ball, Ball),
    block(Block).
tree(united_join-union([at([rotate(y,20)], join([Round,
                                                 at([translate(3,0,0)],
                                                    Round)])), Block])) :-
    round(spire, Round),
    block(Block).

%   evaluated_tree(Term): segment 1, its boundary made; or primitive Term.

evaluated_tree(Term) :-
    (   is_node_term(Term)
    ->  assert_fact(segment(1, solid, Term)),
        evaluate
    ;   add_primitive(Term, 1)
    ),
    complete_segments.

%   picture_lengths(-Lengths): Visibility-Role-Length, in millionths, of the
%   picture of the roots.

picture_lengths(Lengths) :-
    operand_lines(Lines),
    picture_lengths(Lines, Lengths).

picture_lengths(Lines, Lengths) :-
    findall(S, root_segment(S), Ss),
    penetrate(all, [themselves(true)]),
    set_view(33, 62, 0),
    with_operand_lines(Lines, picture([segments(Ss)])),
    findall(Visibility-Role-Length,
            ( aggregate(sum(L), part_length(Visibility, Role, L), Sum),
              Length is round(Sum*1.0e6) ),
            Lengths).

part_length(Visibility, Role, L) :-
    drawn(_, S, E, From, To, Visibility, Role),
    line_ends(S, E, X1-Y1, X2-Y2),
    L is (To-From)*sqrt((X2-X1)**2+(Y2-Y1)**2).

near(known(S,Surfaces1,Runs), known(S,Surfaces2,Runs)) :-
    maplist(near_surface, Surfaces1, Surfaces2).

near_surface(surface(Kind,Frame1,A,B), surface(Kind,Frame2,A,B)) :-
    maplist(near_number, Frame1, Frame2).

near_number(X, Y) :-
    abs(X-Y) < 1.0e-12.

by_rule(S, known(S,Surfaces,Runs)) :-
    segment_facets(S, Surfaces, Runs),
    Runs \== [].

%   facet_crease(Facets, -Edge): a crease of segment 1 that is drawn between
%   facets of one surface, by Facets, P-Id.

facet_crease(Facets, E) :-
    drawn(_, 1, E, _, _, _, crease),
    e(1, E, V1, V2, _),
    e(1, Twin, V2, V1, _),
    edge_polygon(1, E, P),
    edge_polygon(1, Twin, Q),
    memberchk(P-Id, Facets),
    memberchk(Q-Id, Facets).

:- begin_tests(facets_of_results).

test(kernel, [ forall(tree(_-Term)), true(Wrong == []) ]) :-
    in_new_world(( evaluated_tree(Term),
                   findall(S, segment(S, _, _), Ss0),
                   sort(Ss0, Ss),
                   facets_of(Ss, Facets),
                   findall(Known, ( member(S, Ss), by_rule(S, Known) ), Rule),
                   ( maplist(near, Facets, Rule)
                   ->  Wrong = []
                   ;   Wrong = Facets-Rule
                   ) )).
% All facets of the leaves, as far as they are there still; no face of a box.
test(found, [ forall(tree(_-Term)), true(Count >= 5) ]) :-
    in_new_world(( evaluated_tree(Term),
                   aggregate_all(count,
                                 ( p(1, P, _), polygon_surface(1, P, _, _) ),
                                 Count) )).
% A file may say that polygons come from themselves.
test(no_end, fail) :-
    in_new_world(( assert_fact(segment(1, solid, loop)),
                   assert_fact(v(1, 1, 0.0, 0.0, 0.0)),
                   assert_fact(v(1, 2, 1.0, 0.0, 0.0)),
                   assert_fact(v(1, 3, 0.0, 1.0, 0.0)),
                   assert_fact(e(1, 1, 1, 2, 1)),
                   assert_fact(e(1, 2, 2, 3, 1)),
                   assert_fact(e(1, 3, 3, 1, 1)),
                   assert_fact(p(1, 1, [1,2,3])),
                   assert_fact(from_p(1, 1, 1, 1, 1)),
                   polygon_surface(1, 1, _, _) )).
test(number, error(domain_error(surface_number, 2))) :-
    in_new_world(known_facets([known(1,[],[run(1,1,2)])], [], _)).

:- end_tests(facets_of_results).

:- begin_tests(root_picture).

test(alone, [ forall(tree(_-Term)), true(Alone == Together) ]) :-
    in_new_world(( evaluated_tree(Term),
                   picture_lengths(Together) )),
    in_new_world(( evaluated_tree(Term),
                   operand_lines(Lines),
                   roots_alone,
                   picture_lengths(Lines, Alone) )).
test(silhouette, [ forall(member(Name, [ball,ring])) ]) :-
    tree(Name-Term),
    in_new_world(( evaluated_tree(Term),
                   roots_alone,
                   picture_lengths([], _),
                   once(contour(_, _, _, _, _, _, _, _, _, _, _, _, _)) )),
    !.
test(no_creases, [ forall(tree(_-Term)), true(Creases == []) ]) :-
    in_new_world(( evaluated_tree(Term),
                   findall(P-Id, ( p(1, P, _), polygon_surface(1, P, Id, _) ),
                           Facets),
                   roots_alone,
                   picture_lengths([], _),
                   findall(E, facet_crease(Facets, E), Creases) )).
test(written, true(Read == Alone)) :-
    tree(moved_twice-Term),
    tmp_file_stream(File, Out, [encoding(utf8),extension(pl)]),
    close(Out),
    call_cleanup(
        ( in_new_world(( evaluated_tree(Term),
                         roots_alone,
                         save_model(File),
                         picture_lengths([], Alone) )),
          in_new_world(( load_model(File),
                         picture_lengths([], Read) )) ),
        delete_file(File)).
% A file of its own numbers, read after another one.
test(written_second, true(Kinds == [tapered])) :-
    tree(cylinder-Term),
    tmp_file_stream(File, Out, [encoding(utf8),extension(pl)]),
    close(Out),
    call_cleanup(
        ( in_new_world(( evaluated_tree(Term),
                         roots_alone,
                         save_model(File) )),
          in_new_world(( load_model(File),
                         load_model(File),
                         findall(S, segment(S, _, _), Ss),
                         last(Ss, Last),
                         facets_of([Last], [known(Last,Surfaces,_)]),
                         findall(Kind, member(surface(Kind,_,_,_), Surfaces),
                                 Kinds) )) ),
        delete_file(File)),
    !.
test(operand_again, true(Kinds == [tapered])) :- % of a result that was written
    tree(cylinder-Term),
    in_new_world(( evaluated_tree(Term),
                   roots_alone,
                   assert_fact(segment(7, solid, at([scale(2)], 1))),
                   evaluate,
                   facets_of([7], [known(7,Surfaces,_)]),
                   findall(Kind, member(surface(Kind,_,_,_), Surfaces), Kinds)
                 )),
    !.

:- end_tests(root_picture).

% Pictures of a model that was turned: as if it had been placed so.

up(y, [rotate(x,90)]).
up(x, [rotate(y,-90)]).

turned(Name-Term) :-
    round(Name, Term).
turned(Tree) :-
    tree(Tree).

:- begin_tests(turned_picture).

test(up, [ forall(( up(Axis, Steps), turned(_-Term) )), true(Up == Placed) ]) :-
    in_new_world(( evaluated_tree(Term),
                   with_up(Axis, ( picture_lengths(Up0), Up = Up0 )) )),
    in_new_world(( evaluated_tree(at(Steps, Term)),
                   picture_lengths(Placed) )).
test(and_back, [ forall(turned(_-Term)), true(After == Before) ]) :-
    in_new_world(( evaluated_tree(Term),
                   findall(S, segment(S, _, _), Ss),
                   facets_of(Ss, Before),
                   with_up(x, true),
                   remembered_facets([]),
                   facets_of(Ss, After) )).
test(origin, [ forall(turned(_-Term)), true(After == Before) ]) :-
    in_new_world(( evaluated_tree(Term), picture_lengths(Before) )),
    in_new_world(( evaluated_tree(Term),
                   operand_lines(Lines),
                   roots_alone,
                   move_origin([2.0,-1.0,0.5]),
                   picture_lengths(Lines, After) )).

:- end_tests(turned_picture).
