:- module(test_development_rules, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(decision)).
:- use_module(rules(development/development)).
:- use_module(rules(development/development_record)).
:- use_module(rules(model/model)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(unfolding/unfold)).
:- use_module(tests('rules/development/development_model')).
:- use_module(tests('rules/pattern_checked')).

/* Rule files that say where seams go: the pattern follows, and nothing lies on
anything. docs/rules.md shows the two of the hopper. */

:- meta_predicate hopper(+, -, 0), with_term(+, +, -, 0).

%   hopper(+Files, -D, :Goal): Goal holds where D is the pattern of the hopper,
%   by these rule files.

hopper(Files, D, Goal) :-
    new_world(World),
    in_world(World,
             ( maplist(use_rules, Files),
               load_model('facts/patterns/hopper.pl'),
               unfold(1, [], D),
               Goal )).

%   seam_middles(D, Middles): of every seam its middle, X-Y-Z, and its length.

seam_middle(D, X-Y-Z) :-
    joint(D, _, E, _, seam, _),
    e(1, E, A, B, _),
    v(1, A, X1, Y1, Z1),
    v(1, B, X2, Y2, Z2),
    X is (X1+X2)/2,
    Y is (Y1+Y2)/2,
    Z is (Z1+Z2)/2.

%   upright(D, Ys): the y of the seams that do not lie in the ring.

upright(D, Ys) :-
    findall(Y, ( seam_middle(D, _-Y-Z), abs(Z-50.0) > 1 ), Ys).

%   with_term(+Text, +Term, -D, :Goal): by rules of this Text.

with_term(Text, Term, D, Goal) :-
    setup_call_cleanup(
        tmp_file_stream(File, Out, [extension(pl)]),
        ( write(Out, Text),
          close(Out),
          new_world(World),
          in_world(World,
                   ( use_rules(File),
                     add_primitive(Term, S),
                     complete_segments,
                     develop(S, [], D),
                     Goal )) ),
        delete_file(File)).

checked(D, Results) :-
    development_measures(D, M),
    Told = [reported(M.seam,M.pieces)],
    patterns_checked(told(D, Told), Results).

told(D, Told, Out) :-
    write_pattern(Out, pattern, D, Told).

%   An order and a veto that mean nothing.

by_chance("join_order(_, E, K) :- K is (E*7919) mod 1009.").
by_chance("join_order(_, E, K) :- K is -E.").
by_chance("may_join(_, E) :- E mod 7 =\\= 3.").
by_chance("may_join(_, _) :- fail.").
by_chance("join_order(_, E, x) :- E > 0.").

:- begin_tests(development_rules).

test(not_at_the_back_by_default) :-
    hopper([], D, upright(D, Ys)),
    \+ forall(member(Y, Ys), Y > 20).
test(seams_at_the_back, [true(Count-Back == 2-2)]) :-
    hopper(['docs/back_rules.pl'], D, upright(D, Ys)),
    length(Ys, Count),
    aggregate_all(count, ( member(Y, Ys), Y > 20 ), Back).
test(seam_no_longer, [true(Seam =:= Default)]) :-
    hopper([], D1, development_measures(D1, M1)),
    hopper(['docs/back_rules.pl'], D2, development_measures(D2, M2)),
    Seam is round(M2.seam*1.0e9),
    Default is round(M1.seam*1.0e9).
test(never_across_the_weld, [true(Folds-Pieces == 0-2)]) :-
    hopper(['docs/weld_rules.pl'], D,
           ( aggregate_all(count,
                           ( joint(D, _, E, _, fold, _), e(1, E, A, B, _),
                             v(1, A, _, _, 50.0), v(1, B, _, _, 50.0) ),
                           Folds),
             aggregate_all(max(K), piece(D, _, K), Pieces) )).
test(both, [true(Back-Pieces == 2-2)]) :-
    hopper(['docs/back_rules.pl','docs/weld_rules.pl'], D,
           ( upright(D, Ys),
             aggregate_all(max(K), piece(D, _, K), Pieces) )),
    aggregate_all(count, ( member(Y, Ys), Y > 20 ), Back).
test(checked, [forall(member(Files, [[], ['docs/back_rules.pl'],
                                     ['docs/weld_rules.pl']])),
               true(Faults == [])]) :-
    hopper(Files, D,
           ( development_measures(D, M),
             findall(P, unfolding_removed(P), Removed),
             patterns_checked(told(D, [ removed(Removed),
                                        reported(M.seam,M.pieces) ]),
                              [R]) )),
    findall(Fault, bad_pattern(R, 1.0e-12, Fault), Faults).

%   The rings of the hopper, polygons 1 and 50.

unfolding_removed(P) :-
    p(1, P, _),
    \+ ( segment(D, pattern, _), p(D, P, _) ).

test(by_chance, [forall(( by_chance(Rules),
                          member(Name, [hollow_cylinder,egg,
                                        oblique_elliptic_cylinder]) )),
                 true(Faults == [])]) :-
    figure_model(Name, [Term]),
    with_term(Rules, Term, D, checked(D, [R])),
    findall(Fault, bad_pattern(R, 1.0e-12, Fault), Faults).
test(nothing_joined, [true(Pieces == 6)]) :-
    with_term("may_join(_, _) :- fail.", box(size(1,2,3)), D,
              aggregate_all(max(K), piece(D, _, K), Pieces)).

:- end_tests(development_rules).
