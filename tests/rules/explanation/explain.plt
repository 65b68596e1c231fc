:- encoding(utf8).
:- module(test_explain, []).
% covers: explain_pair
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(http/json)).
:- use_module(library(lists)).
:- use_module(library(occurs)).
:- use_module(rules(penetration/contact)).
:- use_module(rules(decision), [use_rules/1]).
:- use_module(rules(exact)).
:- use_module(rules(explanation/explain)).
:- use_module(rules(message/explain_words)).
:- use_module(rules(message/explain_en), []).
:- use_module(rules(message/explain_ko), []).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(store)).
:- use_module(tests('rules/grid_model')).
:- use_module(rules(polygon/triangulation)).

/* Explanations of hand-made contacts of every kind; what must hold of the
   explanation of every line of random boxes; both languages say everything. */

:- meta_predicate with_pieces(+, 0), turned(0).

%   with_pieces(+Polygons, :Goal): each of Polygons, a list of points, is a
%   segment with one polygon; penetrated.

with_pieces(Polygons, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(nth1(S, Polygons, Points), surface(S, Points)),
               complete_segments,
               penetrate,
               Goal )).

surface(S, Points) :-
    assert_fact(segment(S, surface, sheet)),
    forall(nth1(V, Points, [X,Y,Z]),
           ( Xf is float(X), Yf is float(Y), Zf is float(Z),
             assert_fact(v(S, V, Xf, Yf, Zf)) )),
    length(Points, N),
    forall(between(1, N, E),
           ( V2 is E mod N + 1,
             assert_fact(e(S, E, E, V2, 1)) )),
    numlist(1, N, Es),
    assert_fact(p(S, 1, Es)).

%   A square in the plane z = 0, and others against it.

floor([[0,0,0],[4,0,0],[4,4,0],[0,4,0]]).

through([[1,1,-1],[3,1,-1],[3,1,1],[1,1,1]]).      % edges pierce
across([[2.5,-1,-1],[2.5,5,-1],[2.5,5,1],[2.5,-1,1]]). % edges are pierced
standing([[1,1,0],[3,1,0],[2,1,2]]).               % corners inside
corner_to_corner([[0,0,0],[4,4,0],[2,2,3]]).
upon_edge([[1,0,0],[3,2,0],[2,1,3]]).              % a corner on the border
at_border([[0,-2,-2],[2,2,2],[2,3,-2]]).
beside([[5,0,0],[9,0,0],[9,4,0],[5,4,0]]).
flat_corner([[5,3.5,0],[9,0,0],[9,9,0],[3.5,5,0]]). % in one plane, apart
pointing([[1,1,0],[3,1,2],[1,3,2]]).               % touches in a point

%   kinds(+Other, -Kinds): the contacts of the floor and Other, sorted.

kinds(Name, Kinds) :-
    floor(Floor),
    call(Name, Other),
    with_pieces([Floor,Other],
                findall(Kind, said(line(_), contact(Kind, _, _)), Kinds0)),
    sort(Kinds0, Kinds).

%   said(+Item, ?Statement): a statement of its explanation, however deep.

said(Item, Statement) :-
    explanation(Item, Because),
    sub_term(Term, Because),
    nonvar(Term),
    Term = because(Statement, _).

pair_says(Name, Statement) :-
    floor(Floor),
    call(Name, Other),
    with_pieces([Floor,Other], findall(S, said(pair(1-1,2-1), S), All)),
    memberchk(Statement, All).

%   explained(+Item, -Text): what explain/1 prints.

explained(Item, Text) :-
    with_output_to(string(Text), explain(Item)).

boxes(Seed) :-
    set_random(seed(Seed)),
    forall(between(1, 4, _),
           ( random_between(-2, 2, X), random_between(-2, 2, Y),
             random_between(-2, 2, Z), random_between(1, 4, A),
             random_between(1, 4, B), random_between(1, 4, C),
             add_primitive(at([translate(X,Y,Z)], box(size(A,B,C))), _) )),
    complete_segments,
    penetrate.

%   shapes(+Seed): three solids or sheets on the integer grid of grid_model.pl,
%   penetrated.

shapes(Seed) :-
    set_random(seed(Seed)),
    random_map(Map),
    forall(between(1, 3, S),
           ( random_shape(Shape0),
             mapped_shape(Map, Shape0, Shape),
             add_shape(S, Shape) )),
    complete_segments,
    penetrate.

%   bad_line(-Fault): a line whose explanation does not hold: an end whose
%   features are not where it is, a side that proves nothing, or pieces that do
%   not reach from end to end.

bad_line(L-Fault) :-
    explanation(line(L), [because(Statement, Because)]),
    bad_reason(Statement, Because, Fault).

bad_reason(Statement, Because, no_ends(N)) :-
    aggregate_all(count, ( member(because(point(_,_,_,_,_,_), Facts), Because),
                           memberchk(because(contact(_,_,_), _), Facts) ),
                  N),
    (   functor(Statement, touch, _)
    ->  N =\= 1
    ;   N =\= 2
    ).
bad_reason(_, Because, Seat) :-
    sub_term(because(contact(_, Seat1, Seat2), _), Because),
    member(Seat, [Seat1,Seat2]),
    bad_seat(Seat).
bad_reason(_, Because, one_side(Facts)) :-
    sub_term(because(contact('edge-face', _, _), Facts), Because),
    findall(Side, member(because(side(_,_,_,Side,_), _), Facts), Sides0),
    sort(Sides0, Sides),
    Sides \== [above,below].
bad_reason(_, Because, no_pieces) :-
    \+ memberchk(because(pieces(_, _), _), Because),
    \+ memberchk(because(touching(_), _), Because).

%   The vertex is, exactly, on the line of its edge, between its ends; or on
%   the plane of its triangle.

bad_seat(seat(S, V, edge(A, B))) :-
    once(vertex_exact(S, V, X, Y, Z)),
    once(vertex_exact(S, A, Xa, Ya, Za)),
    once(vertex_exact(S, B, Xb, Yb, Zb)),
    \+ ( (X-Xa)*(Yb-Ya) =:= (Y-Ya)*(Xb-Xa),
         (Y-Ya)*(Zb-Za) =:= (Z-Za)*(Yb-Ya),
         (Z-Za)*(Xb-Xa) =:= (X-Xa)*(Zb-Za),
         (X-Xa)*(Xb-X) + (Y-Ya)*(Yb-Y) + (Z-Za)*(Zb-Z) > 0 ).
bad_seat(seat(S, V, face(_, triangle(A, B, C)))) :-
    \+ vertex_side(S, V, S-(A,B,C), on).

%   What touches but for rounding says so, with the features of the model.

turned(Goal) :-
    new_world(World),
    in_world(World,
             ( add_primitive(at([rotate(z,33), rotate(x,17)],
                                box(size(2,2,2))), _),
               add_primitive(at([translate(1,0.3,2), rotate(z,33),
                                 rotate(x,17)], box(size(2,2,2))), _),
               complete_segments,
               penetrate,
               Goal )).

%   unsaid(-Rule, -Name): a statement without a clause in a language.

unsaid(Rule, Name) :-
    member(Module-Rule,
           [sg_explain_en-statement_en, sg_explain_ko-statement_ko]),
    statement_keys(Name, Keys),
    length(Keys, Arity),
    functor(Statement, Name, Arity),
    Head =.. [Rule, Statement, _, _],
    \+ clause(Module:Head, _).

:- begin_tests(explain).

test(edge_face, Kinds == ['edge-face']) :-
    kinds(through, Kinds).
test(face_pierced_by_other, Kinds == ['edge-face']) :-
    kinds(across, Kinds).
test(vertex_face, Kinds == ['vertex-face']) :-
    kinds(standing, Kinds).
test(vertex_vertex, Kinds == ['vertex-vertex']) :-
    kinds(corner_to_corner, Kinds).
test(vertex_edge, Kinds == ['vertex-edge','vertex-face']) :-
    kinds(upon_edge, Kinds).
test(edge_edge, Kinds == ['edge-edge','edge-face']) :-
    kinds(at_border, Kinds).

test(boxes_apart) :-
    pair_says(beside, boxes_apart(x, 4.0, 5.0, first)).
test(all_above) :-
    with_pieces([[[0,0,0],[4,0,0],[4,4,2],[0,4,2]],
                 [[0,1,1],[4,1,1],[2,2,2]]],
                findall(S, said(pair(1-1,2-1), S), All)),
    memberchk(triangles(one_side(_), _), All),
    findall(Side, member(side(2,_,_,Side,_), All), Sides0),
    sort(Sides0, Sides),
    Sides == [above].
test(coplanar_apart) :-
    pair_says(flat_corner, triangles(coplanar_apart, _)).
test(intervals_apart) :-
    with_pieces([[[0,0,0],[4,0,0],[0,4,0]],
                 [[3,2,-1],[4,4,-1],[3.5,3,1]]],
                findall(S, said(pair(1-1,2-1), S), All)),
    memberchk(triangles(intervals_apart, 1), All).
test(point_alone, Kinds == ['vertex-face']) :-
    kinds(pointing, Kinds).

test(no_line) :-
    pair_says(flat_corner, no_line).

%   A triangle of a floor, and another floor on both sides of it: what they have
%   in common is no border.

test(inside_faces) :-
    new_world(World),
    in_world(World,
             ( add_shape(1, shape(floor, surface,
                                  [p(0,0,0), p(8,0,0), p(8,8,0), p(0,8,0),
                                   p(3,3,0), p(5,3,0), p(4,5,0)],
                                  [[[5,6,7]], [[1,2,3,4],[5,7,6]]])),
               add_shape(2, shape(floor, surface,
                                  [p(1,1,0), p(7,1,0), p(7,7,0), p(1,7,0)],
                                  [[[1,2,3,4]]])),
               complete_segments,
               penetrate,
               said(pair(1-1,2-1), no_line),
               said(pair(1-1,2-1), inside_faces),
               \+ line(_, 1, 1, _, _, 2, _, _, _) )),
    !.

%   A sheet that stands against an edge of a box meets both its faces there; the
%   line is that of one.

test(elsewhere, L == 1) :-
    new_world(World),
    in_world(World,
             ( add_primitive(box(size(2,2,2)), _),
               surface(2, [[1,-1,0.5],[2,-2,0.5],[2,-2,1.5],[1,-1,1.5]]),
               complete_segments,
               penetrate,
               line(1, 1, P1, _, _, 2, 1, _, _),
               p(1, P2, _),
               P2 \== P1,
               said(pair(1-P2, 2-1), elsewhere(L, 1, P1, 2, 1)),
               ! )).

test(same_segment) :-
    floor(Floor),
    with_pieces([Floor], said(pair(1, 1), same_segment)).
test(reversed_pair) :-
    floor(Floor),
    through(Other),
    with_pieces([Floor,Other],
                ( explanation(pair(1-1,2-1), A),
                  explanation(pair(2-1,1-1), B) )),
    A == B.

test(vertex_made) :-
    floor(Floor),
    through(Other),
    with_pieces([Floor,Other],
                ( origin(1, v(V), Origin),
                  once(said(vertex(1,V), made(Origin))),
                  once(said(vertex(1,V), also(2, _, edge(_, _)))),
                  once(said(vertex(1,V), vertex_lines([1]))) )).
test(vertex_of_model) :-
    floor(Floor),
    with_pieces([Floor],
                said(vertex(1, 3), original(1, 3, point(4.0,4.0,0.0)))).
test(edge_of_line) :-
    floor(Floor),
    through(Other),
    with_pieces([Floor,Other],
                ( origin(1, e(E), line(L)),
                  once(said(edge(1,E), edge_of_line(L))) )).
test(edge_divided, Parts == 2) :-
    floor(Floor),
    through(Other),
    with_pieces([Floor,Other],
                ( origin(2, e(_), e(Old)),
                  !,
                  aggregate_all(count, said(edge(2,Old), edge_part(_,_,_,_)),
                                Parts) )).
test(part_of) :-
    floor(Floor),
    through(Other),
    with_pieces([Floor,Other],
                ( origin(2, e(E), e(Old)),
                  !,
                  once(said(edge(2,E), part_of(2, Old, _, _))) )).

test(none, fail) :-
    floor(Floor),
    with_pieces([Floor], explanation(line(_), _)).
test(no_such, forall(member(Item, [foo, vertex(1,99), edge(1,99), line(9),
                                   pair(1,7), pair(1-1,1-9)])),
     fail) :-
    floor(Floor),
    with_pieces([Floor], explanation(Item, _)).

test(refused) :-
    tmp_file_stream(File, Out, [extension(pl), encoding(utf8)]),
    format(Out, "may_cut(_, _) :- fail.~n", []),
    close(Out),
    floor(Floor),
    through(Other),
    new_world(World),
    in_world(World,
             ( use_rules(File),
               surface(1, Floor),
               surface(2, Other),
               complete_segments,
               penetrate,
               once(said(pair(1-1,2-1), refused(1, 2, By))),
               once(said(pair(1, 2), refused(1, 2, By))) )),
    delete_file(File),
    By \== default.

test(not_merged, N-By0 == 2-default) :-
    tmp_file_stream(File, Out, [extension(pl), encoding(utf8)]),
    format(Out, "merge_line(_, _) :- fail.~n", []),
    close(Out),
    floor(Floor),
    through(Other),
    with_pieces([Floor,Other], once(said(line(_), pieces(_, By0)))),
    new_world(World),
    in_world(World,
             ( use_rules(File),
               surface(1, Floor),
               surface(2, Other),
               complete_segments,
               penetrate,
               aggregate_all(count, said(line(_), not_merged(_, _)), N) )),
    delete_file(File).

test(turned_contacts, Kinds == ['edge-edge','vertex-face']) :-
    turned(findall(Kind, said(line(_), contact(Kind, _, _)), Kinds0)),
    sort(Kinds0, Kinds).
test(turned_made) :-
    turned(( once(said(line(_), made(near(ll(_, _))))),
             once(said(line(_), made(near(v(_, _))))) )).
test(turned_seats) :-
    turned(( once(said(line(_), contact('vertex-face', A, B))),
             member(seat(S,V,vertex(_)), [A,B]),
             member(seat(S1,V1,face(_,_)), [A,B]),
             once(said(vertex(S,V), also(S1, V1, face(_,_)))),
             once(said(vertex(S1,V1), also(S, V, vertex(V)))) )).

test(apex, Kind-N == 'vertex-face'-2) :-
    with_pieces([[[0,0,0],[4,0,0],[4,4,0],[0,4,0]],
                 [[1,1,0],[2,1,2],[1,2,2]]],
                ( once(said(line(L), touch(L, 1, 1, 2, 1))),
                  once(said(line(L), contact(Kind, _, _))),
                  once(said(line(L), touching(N))) )).

test(moved, Z == 2.000000000000004) :-
    new_world(World),
    in_world(World,
             ( add_primitive(box(size(2,2,2)), _),
               add_primitive(at([translate(0,0,2.000000000000004)],
                                box(size(2,2,2))), _),
               complete_segments,
               penetrate,
               once(said(vertex(2,1), moved(2, 1, point(_,_,2.0)))),
               once(said(vertex(2,1), was_at(2, 1, point(_,_,Z)))) )).

%   After a second penetration the explanation is still that of the leaves.

test(after_second) :-
    floor(Floor),
    through(Other),
    across(Third),
    new_world(World),
    in_world(World,
             ( surface(1, Floor),
               surface(2, Other),
               complete_segments,
               penetrate,
               surface(3, Third),
               complete_segments,
               penetrate,
               findall(Fault, bad_line(Fault), Faults),
               aggregate_all(count, line(_,_,_,_,_,_,_,_,_), N) )),
    Faults == [],
    N > 1.
test(three_planes) :-
    floor(Floor),
    through(Other),
    across(Third),
    with_pieces([Floor,Other,Third],
                ( once(said(line(_), made(tpi(_, _, _)))),
                  once(said(line(_), contact('face-face', _, _))) )).

test(random_boxes, forall(between(1, 10, Seed))) :-
    new_world(World),
    in_world(World, ( boxes(Seed), findall(F, bad_line(F), Faults) )),
    assertion(Seed-Faults == Seed-[]).

test(grid_models, forall(between(1, 40, Seed))) :-
    new_world(World),
    in_world(World, ( shapes(Seed), findall(F, bad_line(F), Faults) )),
    assertion(Seed-Faults == Seed-[]).

test(text, Lines == ["line 1: polygon 1 of segment 1 (sheet) meets polygon 1 \c
                      of segment 2 (sheet)",
                     "  starts at (1, 1, 0), vertex 5 of segment 1 and \c
                      vertex 5 of segment 2"]) :-
    floor(Floor),
    through(Other),
    with_pieces([Floor,Other], explained(line(1), Text)),
    split_string(Text, "\n", "", [A,B|_]),
    Lines = [A,B].

test(json) :-
    floor(Floor),
    through(Other),
    with_pieces([Floor,Other],
                ( explanation(line(1), Because),
                  with_output_to(string(Text),
                                 print_explanations([line(1)-Because])) )),
    atom_json_dict(Text, [Dict], []),
    Dict.item == "line(1)",
    [First|_] = Dict.because,
    First.says == "line",
    First.line =:= 1.

test(all_said, Missing == []) :-
    findall(Rule-Name, unsaid(Rule, Name), Missing).

:- end_tests(explain).
