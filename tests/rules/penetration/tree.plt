/* Trees kept with the world, and segments near each other. */
% covers: near_leaf
:- use_module(rules(store)).
:- use_module(rules(kernel)).
:- use_module(rules(primitive/primitive)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(penetration/penetration)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

:- begin_tests(tree).

boxes(Ats) :-
    forall(member(X-Y-Z, Ats),
           add_primitive(at([translate(X, Y, Z)], box(size(2, 2, 2))), _)),
    complete_segments.

opened(Pairs) :-
    cut_set_open(Pairs, Set),
    cut_set_close(Set).

candidates(Pairs, N) :-
    setup_call_cleanup(
        cut_set_open(Pairs, Set),
        aggregate_all(count, cut_candidate(Set, _, _), N),
        cut_set_close(Set)).

counts(Trees-Grown-Found) :-
    tree_statistics(S),
    _{trees:Trees, grown:Grown, found:Found} :< S.

%   moved(+S, +By): every vertex of the segment along x.

moved(S, By) :-
    findall(v(S, V, X, Y, Z), v(S, V, X, Y, Z), Vs),
    facts_transaction(
        forall(member(v(S, V, X, Y, Z), Vs),
               ( retractall_facts(v(S, V, _, _, _)),
                 X1 is X+By,
                 assert_fact(v(S, V, X1, Y, Z)) ))).

three :-
    boxes([0-0-0, 1-1-1, 2-0.5-0.5]).

test(none_at_first, Counts == 0-0-0) :-
    in_new_world(counts(Counts)).
test(kept, Counts == 2-2-2) :-
    in_new_world(( three, opened([1-2]), opened([1-2]), counts(Counts) )).
test(grown_when_wanted, Counts == 3-3-1) :-
    in_new_world(( three, opened([1-2]), opened([2-3]), counts(Counts) )).
test(only_what_changed, Counts == 2-3-1) :-
    in_new_world(( three, opened([1-2]), moved(1, 0.25), opened([1-2]),
                   counts(Counts) )).
test(undo_brings_back, Counts == 2-2-2) :-
    in_new_world(( three, opened([1-2]), moved(1, 0.25), facts_undo,
                   opened([1-2]), counts(Counts) )).
test(rolled_back, Counts == 2-2-2) :-
    in_new_world(( three, opened([1-2]),
                   \+ facts_transaction(( moved(1, 0.25), fail )),
                   opened([1-2]), counts(Counts) )).
test(snapshot, Counts == 2-4-2) :-
    in_new_world(( three, opened([1-2]),
                   facts_snapshot(( moved(1, 9.0), opened([1-2]) )),
                   opened([1-2]), counts(Counts) )).
test(gone, Counts == 1-2-0) :-
    in_new_world(( three, opened([1-3]),
                   retractall_facts(segment(1, _, _)),
                   opened([]),
                   counts(Counts) )).
test(worlds_apart, A-B == (2-2-0)-(0-0-0)) :-
    in_new_world(( three, opened([1-2]), counts(A) )),
    in_new_world(counts(B)).
test(bytes, true(Bytes > 24*36)) :-
    in_new_world(( three, opened([1-2]),
                   tree_statistics(S) )),
    Bytes = S.bytes.
test(what_changed_is_seen, [N0,N1,N2] == [N2,0,N0]) :-
    in_new_world(( three,
                   candidates([1-2], N0),
                   moved(1, -9.0), candidates([1-2], N1),
                   facts_undo, candidates([1-2], N2) )),
    N0 > 0.
test(held_by_a_set, N0 == N1) :-
    in_new_world(( three,
                   candidates([1-2], N0),
                   cut_set_open([1-2], Set),
                   moved(1, 9.0), opened([1-2]),
                   aggregate_all(count, cut_candidate(Set, _, _), N1),
                   cut_set_close(Set) )).

%   A thread sees the version before another one's open transaction.

test(threads, [condition(current_prolog_flag(threads, true)),
               Near == [1-2,1-3,2-3]-[2-3]-[1-2,1-3,2-3]]) :-
    new_world(World),
    in_world(World, ( three, opened([1-2,2-3]), near(0, Before) )),
    in_world(World,
             facts_transaction(
                 ( moved(1, 9.0),
                   opened([1-2]),
                   near(0, Mine),
                   thread_create(in_world(World, ( near(0, Near0),
                                                   thread_exit(Near0) )),
                                 Id),
                   thread_join(Id, exited(Theirs)) ))),
    Near = Before-Mine-Theirs.

/* - - - near - - - */

near(Reach, Pairs) :-
    findall(S1-S2, near_segments(Reach, S1, S2), Pairs).

test(nothing_near, Pairs == []) :-
    in_new_world(near(0, Pairs)).
test(touching, Pairs == [1-2]) :-
    in_new_world(( boxes([0-0-0, 2-0-0, 4.5-0-0]), near(0, Pairs) )).
test(within_reach, Pairs == [1-2,2-3]) :-
    in_new_world(( boxes([0-0-0, 2-0-0, 4.5-0-0]), near(0.5, Pairs) )).
test(after_a_join, Pairs == [1-2,1-3,2-3]) :-
    in_new_world(( three, opened([1-2]), near(0, Pairs) )).
test(after_a_change, Pairs == [2-3]) :-
    in_new_world(( three, opened([1-2,2-3]), moved(1, -9.0), near(0, Pairs) )).
test(last_is_det, Pairs == [1-2]) :-
    in_new_world(( boxes([0-0-0, 1-0-0]),
                   near_segments(0, S1, S2),
                   Pairs = [S1-S2] )).
test(reach_negative, error(domain_error(not_less_than_zero, -1))) :-
    in_new_world(near(-1, _)).
test(bound, [Second,Pairs] == [[2,3],[1-2]]) :-
    in_new_world(( three, boxes([9-9-9]),
                   findall(S2, near_segments(0, 1, S2), Second),
                   near_segments(0, 1, 2),
                   \+ near_segments(0, 2, 1),
                   findall(S1-2, near_segments(0, S1, 2), Pairs) )).
test(bound_to_what_is_no_segment, error(type_error(integer, a))) :-
    in_new_world(near_segments(0, a, _)).
test(near_of_some, Near == [1-[2],2-[1],3-[],9-[]]) :-
    in_new_world(( boxes([0-0-0, 1-0-0, 9-0-0, 0-1-0]),
                   near_segments_of(0, [3,9,1,2,1], Near) )).
test(near_of_none, Near == []) :-
    in_new_world(near_segments_of(0, [], Near)).
%   Two curves do not cut each other; a curve and a box may.

test(curves, Near-All-Pairs-Of == [1-2,1-3]-[1-2]-[]-[2-[3],3-[2]]) :-
    in_new_world(( boxes([0-0-0]),
                   add_primitive(line(from(0,0,0), to(3,1,1)), _),
                   add_primitive(line(from(0,0,0), to(1,3,1)), _),
                   near(0, Near),
                   near_pairs(0, [1,2], All),
                   near_pairs(0, [2,3], Pairs),
                   near_segments_of(0, [2,3], Of) )).
test(a_curve_with_a_polygon, Near == [1-2]) :-
    in_new_world(( boxes([0-0-0, 1-0-0]),
                   retractall_facts(segment(1, _, _)),
                   retractall_facts(segment(2, _, _)),
                   assert_fact(segment(1, curve, a)),
                   assert_fact(segment(2, curve, b)),
                   near(0, Near) )).
test(near_of_negative, error(domain_error(not_less_than_zero, -1))) :-
    in_new_world(near_segments_of(-1, [], _)).
test(near_of_list, error(type_error(list, 1))) :-
    in_new_world(near_segments_of(0, 1, _)).
test(random, Wrong == []) :-
    set_random(seed(17)),
    findall(I, ( between(1, 20, I), \+ right_scene ), Wrong).

right_scene :-
    length(Ats, 40),
    maplist(random_place, Ats),
    in_new_world(( boxes(Ats), near(0, Pairs) )),
    findall(I-J, ( nth1(I, Ats, A), nth1(J, Ats, B), I < J, meet(A, B) ),
            Expected),
    Pairs == Expected.

random_place(X-Y-Z) :-
    random_between(0, 12, X),
    random_between(0, 12, Y),
    random_between(0, 12, Z).

/* - - - many in each other - - - */

%   N boxes askew, each in the next one.

shells(N) :-
    forall(between(1, N, I),
           ( R is 1+0.1*I,
             Z is -R/2,
             add_primitive(at([translate(0,0,Z), rotate(x,30), rotate(y,20)],
                              box(size(R,R,R))), _) )),
    complete_segments.

test(in_each_other, Pairs-Some-Of == []-[]-29) :-
    in_new_world(( shells(30),
                   near(0, Pairs),
                   numlist(1, 30, Ss),
                   near_pairs(0, Ss, Some),
                   near_segments_of(0, Ss, [_-Others|_]), % by boxes
                   length(Others, Of) )).
test(through_some, Pairs-true == Expected-Some) :-
    in_new_world(( shells(30),
                   add_primitive(at([translate(0,0,1.25)],
                                    box(size(0.1,0.1,9))), _),
                   complete_segments,
                   near(0, Pairs),
                   findall(S-31, between(1, 30, S), All),
                   penetrate(All),
                   findall(S-31, line(_, S, _, _, _, 31, _, _, _), Met) )),
    sort(Met, Expected),
    (   Expected = [_|_], Expected \== All
    ->  Some = true
    ;   Some = false
    ).
test(within_reach_of_many, N =:= 30*29//2) :-
    in_new_world(( shells(30), near(3, Pairs) )),
    length(Pairs, N).
test(without_triangles, N =:= 30*29//2) :-
    in_new_world(( shells(30),
                   retractall_facts(t(7, _, _, _, _, _)),
                   near(0, Pairs) )),
    length(Pairs, N).
%   So many triangles of balls in one place are near each other that boxes are
%   taken: that of a small ball in the middle, too.
test(in_one_place, N =:= 41*40//2) :-
    in_new_world(( forall(between(1, 40, _),
                          add_primitive(sphere(radius(1), facets(16)), _)),
                   add_primitive(sphere(radius(0.1), facets(4)), _),
                   complete_segments,
                   near(0, Pairs) )),
    length(Pairs, N).
%   Balls on a grid face every way, and few are near each other: boxes are taken
%   before their triangles are compared, in less than twice the time
%   that the balls take.
test(beside_each_other, true(Near < 2*Made)) :-
    in_new_world(( statistics(process_cputime, Begin),
                   numlist(1, 5, Places),
                   forall(( member(X, Places), member(Y, Places),
                            member(Z, Places) ),
                          add_primitive(at([translate(X,Y,Z)],
                                           sphere(radius(1.1), facets(32))),
                                        _)),
                   complete_segments,
                   statistics(process_cputime, Before),
                   near(0, Pairs),
                   statistics(process_cputime, After) )),
    Near is After-Before,
    Made is Before-Begin,
    length(Pairs, N),
    assertion(N > 3000).
%   What is cut is what all pairs cut.
test(crowd, Wrong == []) :-
    findall(Seed,
            ( between(1, 4, Seed),
              cut_crowd(Seed, penetrate, Cut),
              \+ cut_crowd(Seed, all_pairs, Cut) ),
            Wrong).
test(crowd_is_one, true(N < 29*28//2-15)) :-
    in_new_world(( set_random(seed(1)), crowded(29), near(0, Pairs) )),
    length(Pairs, N).

cut_crowd(Seed, Cut, Lines-Vs) :-
    in_new_world(( set_random(seed(Seed)),
                   crowded(29),
                   call(Cut),
                   findall(L, cut_line(L), Lines),
                   findall(v(S,V,X,Y,Z), v(S, V, X, Y, Z), Vs) )).

cut_line(line(A,B,C,D,E,F,G,H,I)) :-
    line(A, B, C, D, E, F, G, H, I).

all_pairs :-
    findall(S1-S2,
            ( segment(S1, K1, _), segment(S2, K2, _), S1 < S2,
              \+ ( K1 == curve, K2 == curve ) ),
            Pairs),
    penetrate(Pairs).

%   Boxes round one middle, some sheets and lines, on a coarse grid: many touch.

crowded(N) :-
    forall(between(1, N, I), ( random_thing(I, Thing),
                               add_primitive(Thing, _) )),
    complete_segments.

random_thing(I, at([translate(0,0,Z)|Turned], box(size(A,B,C)))) :-
    I mod 4 > 0,
    !,
    maplist(random_between(4, 24), [A,B,C]),
    Z is -C/2,
    (   I mod 4 =:= 1
    ->  Turned = [rotate(x,30), rotate(y,20)]
    ;   Turned = []
    ).
random_thing(I, at([translate(0,0,Z)], rectangle(size(A,B)))) :-
    I mod 8 > 0,
    !,
    maplist(random_between(4, 24), [A,B]),
    random_between(-8, 8, Z).
random_thing(_, line(from(A,B,0), to(C,D,9))) :-
    maplist(random_between(-9, 9), [A,B,C,D]).

meet(X1-Y1-Z1, X2-Y2-Z2) :-
    abs(X1-X2) =< 2,
    abs(Y1-Y2) =< 2,
    abs(Z1-Z2) =< 2.

%   The decision is asked for those whose boxes meet.

test(asked_when_near, Lines == []) :-
    in_new_world(( boxes([0-0-0, 5-0-0]), penetrate,
                   findall(L, line(L,_,_,_,_,_,_,_,_), Lines) )).

:- end_tests(tree).
