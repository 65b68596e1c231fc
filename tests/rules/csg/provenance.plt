/* What of a result comes from which leaf. */
:- module(test_provenance, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(explanation/explain)).
:- use_module(rules(csg/provenance)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests('rules/csg/csg_tree'), [with_tree/2]).
:- use_module(tests(rules/polyhedron), [polyhedron/4]).

:- begin_tests(provenance).

test(origin_unknown, error(instantiation_error, _)) :-
    origin_feature(_, _, _).

%   A hole bored through a box by a placed prism: 3 is the result.

bored([ box(size(4,4,1)), box(size(1,1,9)),
        difference([1, at([translate(1,0,-2)], 2)]) ]).

test(vertices, all(S0-V0s == [1-[1,2,3,4,5,6,7,8]])) :-
    bored(Terms),
    with_tree(Terms, findall(S0-V0, vertex_from(3, _, S0, V0), All0)),
    sort(All0, All),
    setof(V0, member(S0-V0, All), V0s).
test(polygons, Froms == [1-1-1, 1-2-1, 1-3-1, 1-4-1, 1-5-1, 1-6-1,
                         2-3-(-1), 2-4-(-1), 2-5-(-1), 2-6-(-1)]) :-
    bored(Terms),
    with_tree(Terms,
              findall(S0-P0-Sense, polygon_from(3, _, S0, P0, Sense),
                      Froms0)),
    sort(Froms0, Froms).
test(edges, [Boxes, Bored, Rims] == [12, 4, 8]) :-
    bored(Terms),
    with_tree(Terms,
              findall(From-(A-B),
                      ( e(3, E, A, B, _), A < B, edge_from(3, E, From) ),
                      All)),
    aggregate_all(count, member(edge(1,_)-_, All), Boxes),
    aggregate_all(count, member(edge(2,_)-_, All), Bored),
    aggregate_all(count, member(cut(_,_)-_, All), Rims).
test(edge_is_on_its_origin) :-
    bored(Terms),
    with_tree(Terms,
              forall(( e(3, E, A, B, _), edge_from(3, E, edge(1, E0)) ),
                     ( e(1, E0, A0, B0, _),
                       maplist(place, [3-A,3-B,1-A0,1-B0], [P,Q,P0,Q0]),
                       ( [P,Q] == [P0,Q0] ; [P,Q] == [Q0,P0] )
                     ))).

place(S-V, X-Y-Z) :-
    v(S, V, X, Y, Z).

%   A box split by a roof: its top within the box is a vertex of the result, its
%   four sides are polygons of it.

test(split, Vs-Ps == [2-5]-[2-1,2-2,2-3,2-4]) :-
    with_tree([ box(size(2,2,2)) ],
              ( polyhedron(2, surface,
                           [p(-3,-3,0.5), p(3,-3,0.5), p(3,3,0.5), p(-3,3,0.5),
                            p(0,0,1.5)],
                           [[1,2,5], [2,3,5], [3,4,5], [4,1,5]]),
                complete_segments,
                assert_fact(segment(3, solid, split(1, 2, below))),
                evaluate,
                findall(S-V, ( vertex_from(3, _, S, V), S =\= 1 ), Vs0),
                findall(S-P, ( polygon_from(3, _, S, P, _), S =\= 1 ),
                        Ps0) )),
    sort(Vs0, Vs),
    sort(Ps0, Ps).

%   Every polygon of the result is said to be kept, with the sense that
%   polygon_from/5 has; and what became of polygons of operands.

test(kept, Bad == []) :-
    bored(Terms),
    with_tree(Terms,
              findall(P-Sense,
                      ( from_p(3, P, K, P0, Sense),
                        \+ ( explanation(piece(3, P), [because(_, Parts)]),
                             memberchk(because(piece_of(K, P0, Sense), Facts),
                                       Parts),
                             last(Facts, because(verdict(kept(Sense), default),
                                                 [])) ) ),
                      Bad)).
test(became, Verdicts-Polygons == [dropped, kept(1)]-1) :-
    bored(Terms),
    with_tree(Terms,
              explanation(piece(3, 1-1), [because(_, Facts)])),
    findall(Verdict, member(because(triangles_of(_, Verdict), _), Facts),
            Verdicts),
    aggregate_all(count, member(because(became(3, _, 1), _), Facts),
                  Polygons).
test(covered, Verdict == covered(1)) :-
    with_tree([ box(size(2,2,2)), box(size(2,2,1)), union([1,2]) ],
              explanation(piece(3, 2-1), [because(_, Facts)])),
    Facts = [because(triangles_of(_, Verdict), _)].
test(placed_twice, N == 1) :-
    with_tree([ box(size(4,4,1)), box(size(1,1,3)),
                difference([1, at([translate(1,0,-1)], 2),
                               at([translate(-1,0,-1)], 2)]) ],
              aggregate_all(count, explanation(piece(3, 2-1), _), N)).
test(said, forall(member(Language, [en, ko]))) :-
    bored(Terms),
    current_prolog_flag(message_language, Old),
    setup_call_cleanup(
        set_prolog_flag(message_language, Language),
        with_tree(Terms,
                  with_output_to(string(Text), explain(piece(3, _)))),
        set_prolog_flag(message_language, Old)),
    \+ sub_string(Text, _, _, _, "because("),
    string_length(Text, Length),
    Length > 1000.

:- end_tests(provenance).
