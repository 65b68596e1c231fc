:- module(test_explain_seam, []).
% covers: development_given, development_instead, laid_joint
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(yall)).
:- use_module(rules(decision)).
:- use_module(rules(development/development)).
:- use_module(rules(development/development_record)).
:- use_module(rules(explanation/explain)).
:- use_module(rules(message/explain_en)).
:- use_module(rules(message/explain_ko)).
:- use_module(rules(model/model)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(unrolling/true_development)).
:- use_module(rules(unfolding/unfold)).

/* Why an edge is a seam, and what another choice costs. */

:- meta_predicate with_model(+, 0), with_rules(+, 0).

with_model(Term, Goal) :-
    new_world(World),
    in_world(World,
             ( add_primitive(Term, _),
               complete_segments,
               Goal )).

with_rules(Text, Goal) :-
    setup_call_cleanup(
        tmp_file_stream(File, Out, [extension(pl)]),
        ( write(Out, Text),
          close(Out),
          use_rules(File),
          Goal ),
        delete_file(File)).

%   says(+Item, ?Statement): somewhere in the explanation of Item.

says(Item, Statement) :-
    explanation(Item, Because),
    said(Because, Statement).

said(Because, Statement) :-
    member(because(Statement0, Others), Because),
    (   Statement = Statement0
    ;   said(Others, Statement)
    ).

%   with_attached(Goal): with a face whose edge 1 is three times as long as
%   those of the three faces at it.

:- meta_predicate with_attached(0), quietly(0).

with_attached(Goal) :-
    new_world(World),
    in_world(World,
             ( assert_fact(segment(1, surface, strip)),
               forall(nth1(V, [ 0-0-0, 3-0-0, 3-1-0, 0-1-0, 1-0-1, 0-0-1,
                                1-0-0, 2-0-0, 2-0-1, 3-0-1 ],
                           X0-Y0-Z0),
                      ( X is float(X0), Y is float(Y0), Z is float(Z0),
                        assert_fact(v(1, V, X, Y, Z)) )),
               forall(nth1(P, [ [1,2,3,4], [7,1,6,5], [8,7,5,9],
                                [2,8,9,10] ],
                           Vs),
                      polygon(P, Vs)),
               complete_segments,
               quietly(Goal) )).

polygon(P, Vs) :-
    Vs = [First|Rest],
    append(Rest, [First], Nexts),
    findall(E, ( nth1(I, Vs, A), nth1(I, Nexts, B), E is 4*(P-1)+I,
                 assert_fact(e(1, E, A, B, 1)) ),
            Es),
    assert_fact(p(1, P, Es)).

quietly(Goal) :-
    setup_call_cleanup(
        ( current_prolog_flag(verbose, Verbose),
          set_prolog_flag(verbose, silent) ),
        Goal,
        set_prolog_flag(verbose, Verbose)).

%   wall(Heights): a closed wall, where its faces meet as high as they say.

wall(Heights) :-
    length(Heights, N),
    assert_fact(segment(1, surface, wall)),
    forall(nth0(I, Heights, Height),
           ( X is 5*cos(2*pi*I/N),
             Y is 5*sin(2*pi*I/N),
             Low is 2*I+1,
             High is 2*I+2,
             Top is float(Height),
             assert_fact(v(1, Low, X, Y, 0.0)),
             assert_fact(v(1, High, X, Y, Top)) )),
    forall(between(1, N, P),
           ( A is 2*P-1,
             B is 2*(P mod N)+1,
             C is B+1,
             D is A+1,
             polygon(P, [A,B,C,D]) )),
    complete_segments.

%   wall_folds(Heights, Count-Least, Lengths): what is said of its one seam.

wall_folds(Heights, Joined, Lengths) :-
    new_world(World),
    in_world(World,
             ( wall(Heights),
               quietly(once(explanation(seam(_), Because))) )),
    once(( said(Because, joined_already(Count, _, Least)),
           Joined = Count-Least )),
    findall(Length, said(Because, fold_on_the_way(_, _, _, Length)), Lengths).

long_box(box(size(1, 2, 3))).

hollow(hollow_cylinder(radius(1), inner(0.6), height(1.6), facets(24))).

:- begin_tests(explain_seam).

test(every_seam, [true(Es == Seams)]) :-
    long_box(Box),
    with_model(Box,
               ( findall(E, says(seam(_), seam_edge(_, E, _, _, _, _)), Es),
                 develop(1, [], D),
                 findall(E, joint(D, _, E, _, seam, _), Seams) )).
%   Of a pattern that is there, whatever patterns of others are.
test(pattern_that_is_there, [ forall(member(S, [1,2])),
                              true(Es == Seams) ]) :-
    long_box(Box),
    with_model(Box,
               ( add_primitive(at([translate(9,0,0)], Box), 2),
                 complete_segments,
                 facts_snapshot(( develop(S, [], Plain),
                                  joint(Plain, _, Fold, _, Kind, _),
                                  Kind \== seam )),
                 Other is 3-S,
                 ( S =:= 2 -> develop(Other, [], _) ; true ),
                 develop(S, [cut([Fold])], D),
                 ( S =:= 1 -> develop(Other, [], _) ; true ),
                 findall(E, joint(D, _, E, _, seam, _), Seams),
                 memberchk(Fold, Seams),
                 findall(E, ( member(E, Seams),
                              once(says(seam(S, E),
                                        seam_edge(_, E, _, _, _, _))) ), Es),
                 once(says(seam(S, Fold), cut_by_wish)) )).
test(one_of_both, [true(Lengths == [L,L])]) :-
    long_box(Box),
    with_model(Box,
               ( develop(1, [], D),
                 once(joint(D, _, E1, E2, seam, _)),
                 findall(Length,
                         ( member(E, [E1,E2]),
                           says(seam(1, E), seam_edge(_, E, _, _, _, Length)) ),
                         Lengths),
                 Lengths = [L|_] )).
test(no_fold_on_the_way_is_shorter) :-
    long_box(Box),
    with_model(Box,
               forall(( explanation(seam(_),
                                    [because(seam_edge(_,_,_,_,_,L), Why)]),
                        said(Why, fold_on_the_way(_, _, _, Fold)) ),
                      Fold >= L-1.0e-9)).
%   Up to eight folds are told in the order of the way, of more the shortest.
test(folds_told, [ forall(member(N, [4,8,9,10,13])),
                   true(Told == Wanted) ]) :-
    numlist(1, N, Ks),
    maplist([K,H]>>( H is 2+(K*7) mod 17 ), Ks, Heights),
    wall_folds(Heights, Count-Least, Told0),
    min_list(Heights, Seam),
    once(selectchk(Seam, Heights, Folds)),
    length(Folds, Count0),
    assertion(Count0 == Count),
    maplist([H,L]>>( L is round(H) ), Told0, Told),
    msort(Folds, Sorted),
    Sorted = [Least0|_],
    assertion(Least0 =:= Least),
    (   Count =< 8
    ->  once(append(Before, [Seam|After], Heights)),
        append(After, Before, Way),
        reverse(Way, Back),
        ( Told == Way -> Wanted = Way ; Wanted = Back )
    ;   length(Wanted, 8),
        once(append(Wanted, _, Sorted))
    ).
test(cut_instead_costs, [true(Costs == [yes])]) :-
    long_box(Box),
    with_model(Box,
               findall(Yes,
                       ( says(seam(_), cut_instead(_, Difference)),
                         ( Difference >= -1.0e-9 -> Yes = yes ; Yes = no ) ),
                       Costs0)),
    sort(Costs0, Costs).
test(what_is_said_of_keeping_is_so) :-
    long_box(Box),
    with_model(Box,
               ( develop(1, [], D),
                 once(joint(D, _, E, _, seam, _)),
                 once(says(seam(E), kept_instead(Difference, 1, 1))),
                 seam_length(1, [], Before),
                 seam_length(1, [keep([E])], After) )),
    assertion(abs(After-Before-Difference) < 1.0e-12).
test(overlap, [true(Ps == [yes])]) :-
    hollow(Term),
    with_model(Term,
               findall(yes, ( says(seam(_), would_overlap(_, P1, P2)),
                              P1 =\= P2 ), Ps0)),
    sort(Ps0, Ps).
test(too_short) :-
    with_model(sheet(points([ [0,0,0], [1,-1,0], [1,1,0], [0,0.0001,0],
                              [-1,0,1] ]),
                     faces([[1,2,3,4], [4,5,1]])),
               ( says(seam(1, E), too_short),
                 says(pattern(1, 2), too_short),
                 catch(develop(1, [keep([E])], _),
                       error(geometry_error(development(1, Why)), _),
                       true),
                 Why = edge_length(E) )), !.
test(why_a_piece_is_alone, [nondet]) :-
    hollow(Term),
    with_model(Term,
               says(pattern(1, 2), would_overlap(1, _, _))).
test(one_piece) :-
    long_box(Box),
    with_model(Box,
               ( says(pattern(1, 1), pattern_piece(1, 1, 6, 1)),
                 says(pattern(1, 1), no_seam_out) )), !.
test(cut_by_wish) :-
    long_box(Box),
    with_model(Box,
               ( assert_fact(unfolding(1, cut(1))),
                 says(seam(1), cut_by_wish) )), !.
test(kept_by_wish) :-
    long_box(Box),
    with_model(Box,
               ( assert_fact(unfolding(1, keep(1))),
                 says(fold(1), kept_by_wish) )), !.
test(refused_by_a_rule) :-
    long_box(Box),
    with_model(Box,
               with_rules("may_join(_, E) :- E > 4.",
                          says(seam(1), may_not_join(1, 1, _)) )), !.
test(pieces_refused_by_a_rule, [true(Is-Count == Es-3)]) :-
    long_box(Box),
    with_model(Box,
               with_rules("may_join(_, _) :- fail.",
                          ( explanation(pattern(1, 2), [because(_, [Why])]),
                            Why = because(seams_out(4), Refused),
                            findall(E-I,
                                    ( member(because(Seam, [No]), Refused),
                                      Seam = seam_edge(1, E, _, _, _, _),
                                      No = because(may_not_join(1, I, _), []) ),
                                    Pairs) ))),
    pairs_keys_values(Pairs, Es, Is),
    length(Es, Count).
test(order_of_a_rule) :-
    long_box(Box),
    with_model(Box,
               with_rules("join_order(_, E, E).",
                          ( says(seam(_), joined_in_order(By)),
                            By \== default ) )), !.
test(cut_by_an_option) :-
    long_box(Box),
    with_model(Box,
               ( explanation(seam(1), [cut(1)], Because),
                 said(Because, cut_by_wish),
                 \+ says(seam(1), cut_by_wish) )), !.
test(kept_and_a_root_by_option) :-
    long_box(Box),
    with_model(Box,
               ( findall(E, says(seam(_), seam_edge(_, E, _, _, _, _)), [E|_]),
                 explanation(fold(E), [keep(E), root(top)], Because),
                 said(Because, kept_by_wish) )), !.
test(objective_of_an_option, [true(Asked == Seams)]) :-
    hollow(Term),
    with_model(Term,
               ( findall(E, ( explanation(seam(_), [minimize(pieces)], Why),
                              Why = [because(seam_edge(_,E,_,_,_,_), _)] ),
                         Asked),
                 unfold(1, [minimize(pieces)], D),
                 findall(E, joint(D, _, E, _, seam, _), Seams) )).
test(parts, [true(Reasons-Unknown == [fold,fold,fold]-[])]) :-
    with_attached(
        ( findall(fold, ( explanation(fold(1), [because(Joint,_)]),
                          functor(Joint, fold_edge, _) ),
                  Reasons),
          findall(x, says(seam(_), changed_since), Unknown) )), !.
test(parts_of_a_pattern_that_is_there, [true(Es == Folds)]) :-
    with_attached(
        ( quietly(unfold(1, [cut(1-2)], D)),
          findall(E, joint(D, _, E, _, fold, _), Folds),
          findall(E, says(fold(_), fold_edge(_, E, _, _, _, _, _)), Es),
          says(seam(_), cut_by_wish) )), !.
test(a_part_by_its_number) :-
    with_attached(
        ( quietly(unfold(1, D)),
          joint(D, _, _, E, fold, _),
          origin(D, e(E), e(1)),
          says(fold(D, E), cut_here(_, _, _)) )), !.
test(changed_since, [true(Known == [])]) :-
    with_attached(
        ( quietly(unfold(1, [cut(1-2)], _)),
          assert_fact(v(1, 11, 9.0, 9.0, 9.0)),
          findall(x, quietly(says(seam(_), cut_by_wish)), Known) )).
test(border) :-
    with_model(rectangle(size(1, 2)),
               says(seam(1), border_edge(1, 1, 1))), !.
test(by_the_number_of_the_pattern) :-
    long_box(Box),
    with_model(Box,
               ( develop(1, [], D),
                 once(joint(D, _, E, _, seam, _)),
                 says(seam(D, E), seam_edge(1, E, _, _, _, _)) )), !.
test(nothing_stays, [true(Patterns == [])]) :-
    long_box(Box),
    with_model(Box,
               ( once(says(seam(_), _)),
                 findall(D, segment(D, pattern, _), Patterns) )).
test(no_such_edge, [fail]) :-
    long_box(Box),
    with_model(Box, says(seam(99), _)).

%   Every statement has words, in both languages, and its parts fit them.

test(sentences, [forall(member(Rule, [sg_explain_en:statement_en,
                                      sg_explain_ko:statement_ko])),
                 true(Unsaid == [])]) :-
    hollow(Term),
    with_model(Term,
               findall(Statement,
                       ( member(Item, [seam(_),fold(1),pattern(1,_)]),
                         says(Item, Statement),
                         \+ sentence(Rule, Statement) ),
                       Unsaid)).

sentence(Rule, Statement) :-
    phrase(call(Rule, Statement), Parts),
    forall(member(Format-Arguments, Parts),
           format(string(_), Format, Arguments)).

seam_length(S, Options, Length) :-
    develop(S, Options, D),
    aggregate_all(sum(L), ( joint(D, _, E, _, seam, _), edge_length(D, E, L) ),
                  Length).

edge_length(D, E, Length) :-
    e(D, E, A, B, _),
    v(D, A, X1, Y1, _),
    v(D, B, X2, Y2, _),
    Length is sqrt((X2-X1)**2+(Y2-Y1)**2).

% Patterns that were read from files.

test(measures_of_a_file, [true(Again == Before)]) :-
    hollow(Term),
    with_model(Term, ( develop(1, [], D), measured(D, Before),
                       saved(File) )),
    with_file(File, ( development(1, D1), measured(D1, Again) )).
test(reasons_of_a_file, [true(Again == Before)]) :-
    hollow(Term),
    with_model(Term,
               ( develop(1, [], D),
                 findall(E-R, reason_of(D, E, R), Before),
                 saved(File) )),
    with_file(File,
              ( development(1, D1),
                findall(E-R, reason_of(D1, E, R), Again) )).
test(a_cut_of_a_file) :-
    long_box(Box),
    with_model(Box, ( joint_between(1, 3, E), develop(1, [cut([E])], _),
                      saved(File) )),
    with_file(File,
              ( says(seam(1, E), could_be_joined)
              ; says(seam(1, E), joined_already(_, _, _)) )), !.
test(parts_of_a_file, [true(Es-Unknown == Folds-[])]) :-
    with_attached(( unfold(1, [cut(1-2)], D),
                    findall(E, joint(D, _, E, _, fold, _), Folds),
                    saved(File) )),
    with_file(File,
              quietly(( findall(E, says(fold(_), fold_edge(_,E,_,_,_,_,_)),
                                Es),
                        findall(x, says(_, changed_since), Unknown) ))).
test(another_segment_than_that_of_the_file,
     error(existence_error(development, _))) :-
    long_box(Box),
    with_model(Box, ( develop(1, _), saved(File) )),
    with_file(File,
              ( v(1, 1, X, Y, Z),
                X1 is X-1,
                facts_transaction(( retract_fact(v(1, 1, X, Y, Z)),
                                    assert_fact(v(1, 1, X1, Y, Z)) )),
                development(1, D),
                development_measures(D, _) )).

% What is trimmed, or unrolled.

test(trimmed, [true(Ss-Es == [3]-Seams)]) :-
    with_pipes(
        ( findall(S-E, ( explanation(seam(2, _), [trim(outside)], Because),
                         said(Because, seam_edge(S, E, _, _, _, _)) ),
                  Found),
          pairs_keys_values(Found, Ss0, Es),
          sort(Ss0, Ss),
          facts_snapshot(( unfold(2, [trim(outside)], D),
                           findall(E, joint(D, _, E, _, seam, _), Seams) )) )).
test(unrolled, [true(Parts == [side])]) :-
    with_pipes(
        ( findall(Part, ( explanation(seam(2, _), [true(true)], Because),
                          said(Because, cut_open(Part)) ),
                  Parts0),
          sort(Parts0, Parts) )).
test(unrolled_of_a_file, [true(Parts == [side])]) :-
    with_pipes(( true_development(1, side, [], _), saved(File) )),
    with_file(File,
              ( findall(Part, says(seam(1, _), cut_open(Part)), Parts0),
                sort(Parts0, Parts) )).

%   Parts of an edge that another segment divides are all joined or all cut.

test(cut_instead_of_parts, true(Set == [0.0])) :-
    new_world(World),
    in_world(World,
             ( add_primitive(box(size(2, 2, 2)), _),
               add_primitive(at([translate(1.1,0.7,0.6)], box(size(2, 2, 2))),
                             _),
               complete_segments,
               penetrate,
               unfold(2, D),
               findall(Difference,
                       ( seam_part(D, E),
                         once(says(seam(2, E), cut_instead(_, Cost))),
                         Difference is round(Cost*1.0e9)/1.0e9 ),
                       Differences) )),
    sort(Differences, Set).

seam_part(D, E) :-
    joint(D, _, E, _, seam, _),
    edge_length(D, E, Length),
    Length < 2-1.0e-9.

%   What is kept is against joining one more.

test(held_by_kept) :-
    with_model(box(size(60, 40, 30)),
               ( unfold(1, [keep(base-side(1)),keep(base-side(2))], D),
                 edge_between(D, 3, 4, E),
                 assertion(says(seam(1, E), held_by_kept)),
                 assertion(\+ says(seam(1, E), kept_instead(_, _, _))) )).

%   Of many joints a few are tried; the others say so, and are when asked alone.

test(of_many_a_few) :-
    with_model(sphere(radius(1), facets(40), bands(20)),
               ( findall(E-Why, explanation(fold(1, E), Why), All),
                 findall(E, ( member(E-Why, All), said(Why, not_tried) ), Not),
                 findall(E,
                         ( member(E-Why, All),
                           said(Why, cut_here(_, _, _)) ),
                         Tried),
                 length(Tried, N),
                 assertion(N >= 4),
                 assertion(N < 60),
                 last(Not, E),
                 assertion(says(fold(1, E), cut_here(_, _, _))),
                 assertion(\+ says(fold(1, E), not_tried)) )).

said(Why, Statement) :-
    member(because(Statement0, Why1), Why),
    (   Statement0 = Statement
    ;   said(Why1, Statement)
    ),
    !.

edge_between(D, P, Q, E) :-
    joint(D, _, E, F, seam, _),
    edge_polygon(D, E, P),
    edge_polygon(D, F, Q).

:- end_tests(explain_seam).

measured(D, Seam-Bound-Pieces) :-
    development_measures(D, M),
    Seam is round(M.seam*1.0e9),
    Bound is round(M.bound*1.0e9),
    Pieces = M.pieces.

%   reason_of(D, E, R): why edge E is a seam; of overlaps which ones depends on
%   what was joined by then.

reason_of(D, E, R) :-
    joint(D, J, E, _, seam, _),
    seam_reason(D, J, R0),
    functor(R0, R, _).

joint_between(P, Q, E) :-
    p(1, P, Es),
    member(E, Es),
    once(e(1, E, A, B, _)),
    e(1, F, B, A, _),
    p(1, Q, Fs),
    memberchk(F, Fs),
    !.

saved(File) :-
    tmp_file_stream(File, Out, [extension(pl)]),
    close(Out),
    save_model(File).

:- meta_predicate with_file(+, 0), with_pipes(0).

with_file(File, Goal) :-
    setup_call_cleanup(
        true,
        ( new_world(World),
          in_world(World, ( load_model(File, []), once(Goal) )) ),
        delete_file(File)).

with_pipes(Goal) :-
    new_world(World),
    in_world(World,
             ( add_primitive(cylinder(radius(2), height(8), facets(24)), _),
               add_primitive(at([rotate(y,90),translate(0,0,4)],
                                cylinder(radius(1), height(6), facets(24))),
                             _),
               complete_segments,
               Goal )).
