:- encoding(utf8).
:- module(test_unfold, []).
:- use_module(library(plunit)).
:- use_module(rules(sanggwan)).
:- use_module(rules(kernel)).
:- use_module(rules(message/messages)).
:- use_module(rules(message/messages_ko)).
:- use_module(rules(development/polygon_name)).
:- use_module(rules(solid/trimmed)).
:- use_module(rules(unfolding/unfold)).
:- use_module(rules(message/unfold_en)).
:- use_module(rules(message/unfold_ko)).
:- use_module(tests('rules/pattern_measured')).

% From parts of a model to their patterns: wishes, trimming, edges that attach
% in parts, penetration lines.

with_parts(Terms, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Term, Terms), add_primitive(Term, _)),
               complete_segments,
               call(Goal) )).

quiet(Goal) :-
    setup_call_cleanup(asserta(silent, Ref), Goal, erase(Ref)).

:- dynamic silent/0.
:- multifile user:message_hook/3.
user:message_hook(sanggwan(unfold(_)), Kind, _) :-
    test_unfold:silent,
    memberchk(Kind, [informational, warning]).

edge_length(S, E, Length) :-
    once(e(S, E, A, B, _)),
    once(v(S, A, X1, Y1, Z1)),
    once(v(S, B, X2, Y2, Z2)),
    Length is sqrt((X2-X1)**2 + (Y2-Y1)**2 + (Z2-Z1)**2).

near(A, B) :-
    abs(A-B) =< 1.0e-9*max(1.0, abs(A)).

% Every edge of the pattern is as long as that of what was unfolded, and the
% area is the same; folds share their ends.
true_pattern(S, D) :-
    forall(e(D, E, _, _, 1),
           (   e(S, E, _, _, _)
           ->  edge_length(D, E, L1), edge_length(S, E, L2), near(L1, L2)
           ;   true
           )),
    forall(joint(D, _, E1, E2, fold, _),
           ( e(D, E1, A, B, _), e(D, E2, B, A, _) )),
    forall(joint(D, _, E1, E2, seam, _),
           ( edge_length(D, E1, L1), edge_length(D, E2, L2), near(L1, L2) )).

fold_between(D, P, Q) :-
    joint(D, _, E, F, fold, _),
    edge_polygon(D, E, P1),
    edge_polygon(D, F, Q1),
    msort([P,Q], Ps),
    msort([P1,Q1], Ps),
    !.

% with_pattern(+Terms, +Options, -D, :Goal): of the last of Terms.
with_pattern(Terms, Options, D, Goal) :-
    length(Terms, S),
    with_parts(Terms, ( quiet(unfold(S, Options, D)), call(Goal) )).

box(box(size(2, 3, 4))).

pipes([ at([rotate(y, 90), translate(-6, 0, 0)],
           cylinder(radius(2.5), height(12), facets(40))),
        at([rotate(y, 30), translate(0, 0.5, 0)],
           cylinder(radius(1.5), height(8), facets(24))) ]).

crossing([ at([translate(0, 0, -5)],    % DV-9
              cylinder(radius(2), height(10), facets(40))),
           at([translate(0, 0, -5), rotate(y, 90)],
              cylinder(radius(2), height(10), facets(40))) ]).

count(Goal, N) :-
    aggregate_all(count, Goal, N).

:- begin_tests(unfold).

test(box) :-
    box(Box),
    with_pattern([Box], [], D, true_pattern(1, D)).
test(term, Term == development(1)) :-
    box(Box),
    with_pattern([Box], [], D, segment(D, pattern, Term)).
test(as_predicate, D == 2) :-
    box(Box),
    with_parts([Box], unfold(1, D)).
test(twice, [D1,N] == [D2,1]) :-        % the second for the first
    box(Box),
    with_parts([Box], ( unfold(1, D1), unfold(1, D2),
                        count(segment(_, pattern, _), N) )).

% Wishes (DV-7).
test(fact) :-
    box(Box),
    with_parts([Box], ( assert_fact(unfolding(1, cut(base-side(1)))),
                        unfold(1, D),
                        \+ fold_between(D, 1, 3) )).
test(cut) :-
    box(Box),
    with_pattern([Box], [cut(base-side)], D,
                 \+ ( member(P, [3,4,5,6]), fold_between(D, 1, P) )).
test(keep) :-
    box(Box),
    with_pattern([Box], [keep(base-side)], D,
                 forall(member(P, [3,4,5,6]), fold_between(D, 1, P))).
test(order) :-
    box(Box),
    with_pattern([Box], [order([top,3,base,5])], D,
                 ( fold_between(D, 2, 3), fold_between(D, 1, 3),
                   fold_between(D, 1, 5) )).
test(removed, Ps == [3,4,5,6]) :-
    box(Box),
    with_pattern([Box], [removed([base,top])], D,
                 ( findall(P, p(D, P, _), Ps0), sort(Ps0, Ps) )).
test(root, K == 1) :-
    box(Box),
    with_pattern([Box], [root(top), cut(top-side)], D, piece(D, 2, K)).
test(contradiction, error(usage_error(unfold(1, keep(1-3), _)))) :-
    box(Box),
    with_parts([Box], unfold(1, [cut(base-3), keep(1-3)], _)).
test(no_segment, error(instantiation_error)) :-
    box(Box),
    with_parts([Box], unfold(_, _)).
test(tolerance, error(domain_error(tolerance, -1))) :-
    box(Box),
    with_parts([Box], unfold(1, [tolerance(-1)], _)).
test(tolerance_nan, error(domain_error(tolerance, _))) :-
    box(Box),
    Nan is nan,
    with_parts([Box], unfold(1, [tolerance(Nan)], _)).
test(tries, error(type_error(positive_integer, some))) :-
    box(Box),
    with_parts([Box], unfold(1, [minimize(area),tries(some)], _)).
test(after_a_fault, N == 1) :-          % the world is as it was
    box(Box),
    with_parts([Box],
               ( catch(unfold(1, [cut(9-3)], _), error(_, _), true),
                 count(segment(_, _, _), N) )).

% Trimmed (PL-10, DV-9).
test(saddle) :-
    pipes(Pipes),
    with_pattern(Pipes, [trim(outside)], D,
                 ( segment(D, _, development(T)),
                   trimmed_from(T, 2),
                   true_pattern(T, D) )).
test(saddle_without_ends, Names == [curved]) :-
    pipes(Pipes),
    with_pattern(Pipes, [trim(outside), removed(top)], D,
                 ( segment(D, _, development(T)),
                   findall(Name,
                           ( p(D, P, _), polygon_name(T, P, What),
                             functor(What, Name, _) ),
                           Names0),
                   sort(Names0, Names) )).
test(hole) :-
    pipes(Pipes),
    with_parts(Pipes,
               ( unfold(1, [trim(outside)], D),
                 segment(D, _, development(T)),
                 true_pattern(T, D) )).
test(equal_cylinders, Ns == [2,2]) :-
    crossing(Pipes),
    with_parts(Pipes,
               ( findall(N,
                         ( member(S, [1,2]),
                           unfold(S, [trim(outside), removed([base,top])], D),
                           segment(D, _, development(T)),
                           true_pattern(T, D),
                           aggregate_all(max(K), piece(D, _, K), N) ),
                         Ns) )).
test(inside) :-
    crossing(Pipes),
    with_parts(Pipes, ( unfold(1, [trim(inside)], D),
                        segment(D, _, development(T)),
                        true_pattern(T, D) )).
test(alone, S == 1) :-
    box(Box),
    with_parts([Box], ( quiet(unfold(1, [trim(outside)], D)),
                        segment(D, _, development(S)) )).
test(by, S == 1) :-
    crossing(Pipes),
    with_parts(Pipes, ( quiet(unfold(1, [trim(outside), by([])], D)),
                        segment(D, _, development(S)) )).

% Not trimmed: the lines lie in the polygons.
test(lines, true(N > 0)) :-
    pipes(Pipes),
    with_parts(Pipes,
               ( penetrate, unfold(2, D), true_pattern(2, D),
                 count(joint(D, _, _, _, line, _), N) )).

% Edges that attach in parts (DV-5).
strip(apart) :-
    assert_fact(segment(1, surface, strip)),
    forall(nth1(V, [0-0-0, 3-0-0, 3-1-0, 0-1-0, 1-0-1, 0-0-1, 1-0-0, 2-0-0,
                    2-0-1, 3-0-1],
                X0-Y0-Z0),
           ( X is float(X0), Y is float(Y0), Z is float(Z0),
             assert_fact(v(1, V, X, Y, Z)) )),
    forall(nth1(P, [[1,2,3,4], [7,1,6,5], [8,7,5,9], [2,8,9,10]], Vs),
           polygon(P, Vs)),
    complete_segments.

polygon(P, Vs) :-
    Vs = [First|Rest],
    append(Rest, [First], Nexts),
    findall(E, ( nth1(I, Vs, A), nth1(I, Nexts, B), E is 4*(P-1)+I,
                 assert_fact(e(1, E, A, B, 1)) ),
            Es),
    assert_fact(p(1, P, Es)).

%   Two squares that are Gap apart, along x: one piece if that is within the
%   tolerance.
squares(Gap) :-
    assert_fact(segment(1, surface, squares)),
    forall(( nth0(N, [[0-0,1-0,1-1,0-1], [1-0,2-0,2-1,1-1]], Corners),
             nth1(I, Corners, X0-Y0) ),
           ( V is 4*N + I,
             X is X0 + N*Gap + 0.0,
             Y is float(Y0),
             assert_fact(v(1, V, X, Y, 0.0)) )),
    polygon(1, [1,2,3,4]),
    polygon(2, [5,6,7,8]),
    complete_segments.

test(gap, [ forall(member(Tolerance-Pieces, [0-2,0.0-2,0.125-2,0.25-1,0.5-1])),
            true(Most == Pieces) ]) :-
    new_world(World),
    in_world(World,
             ( squares(0.25),
               quiet(unfold(1, [tolerance(Tolerance)], D)),
               aggregate_all(max(K), piece(D, _, K), Most) )).
test(part_edges, Ks == [1]) :-
    new_world(World),
    in_world(World,
             ( strip(apart),
               quiet(unfold(1, D)),
               findall(K, piece(D, _, K), Ks0),
               sort(Ks0, Ks),
               true_pattern(1, D) )).
test(part_edges_origin, Parents == [1]) :-
    new_world(World),
    in_world(World,
             ( strip(apart),
               quiet(unfold(1, D)),
               findall(E0, ( origin(D, e(E), e(E0)), e(D, E, _, _, _) ),
                       Parents0),
               sort(Parents0, Parents),
               \+ origin(1, _, _),
               findall(P, p(1, P, _), [1,2,3,4]) )).
test(part_edges_wish) :-                % a wish may speak of the parts
    new_world(World),
    in_world(World,
             ( strip(apart),
               quiet(unfold(1, [cut(1-2)], D)),
               \+ fold_between(D, 1, 2),
               quiet(unfold(1, [keep(1-2), keep(1-3)], D2)),
               fold_between(D2, 1, 2),
               fold_between(D2, 1, 3) )).
test(part_edges_twice, D1 == D2) :-
    new_world(World),
    in_world(World, ( strip(apart), quiet(unfold(1, D1)),
                      quiet(unfold(1, D2)) )).

% What cannot be unfolded.
test(curve, error(geometry_error(unfold(kind(1, curve))))) :-
    with_parts([line(from(0, 0, 0), to(1, 1, 1))], unfold(1, _)).
test(no_segment, error(existence_error(segment, 4))) :-
    box(Box),
    with_parts([Box], unfold(4, _)).
test(pattern_itself, error(geometry_error(unfold(kind(2, pattern))))) :-
    box(Box),
    with_parts([Box], ( unfold(1, D), unfold(D, _) )).

% The report.
test(measures, [P,K,W,H] == [6,1,4.0,3.0]) :-
    with_parts([box(size(1, 1, 1))],
               ( unfold(1, D), pattern_measured(D, M),
                 forall(member(Key-Value, [ seam-7, bound-7, area-6,
                                            pattern_area-6 ]),
                        ( get_dict(Key, M, Measure), near(Measure, Value) )),
                 findall(N, ( member(Key, [polygons,pieces,width,height]),
                              get_dict(Key, M, N) ),
                         [P,K,W,H]) )).
test(measures_removed, R == 2) :-
    with_parts([box(size(1, 1, 1))],
               ( unfold(1, [removed([base,top])], D), pattern_measured(D, M),
                 get_dict(pattern_area, M, Area), near(Area, 4),
                 get_dict(removed, M, R) )).

:- end_tests(unfold).
