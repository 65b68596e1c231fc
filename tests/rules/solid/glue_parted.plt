/* What may not be glued: wishes and may_glue/3, against counts by hand, in
   place and turned; and against the kernel where all may be.
   covers: glue_choice */
:- module(test_glue_parted, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(decision)).
:- use_module(rules(gluing/regions)).
:- use_module(rules(model/integrity)).
:- use_module(rules(model/model)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(solid/glue)).
:- use_module(rules(solid/glue_contact)).
:- use_module(rules(store)).
:- use_module(tests(rules/glue_model)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   wanted(Model, Wish, Counts): what comes out of a model of glue_model.pl.

wanted(two(face), only(vertices), c(12,20,12,12,1,4,4,0)).
wanted(two(face), only(edges), c(12,20,12,12,1,4,4,0)).
wanted(two(face), only(faces), c(12,20,11,11,1,3,3,0)).
wanted(two(face), apart(1, 2), c(16,24,12,12,2,3,4,0)).
wanted(two(face), apart(1-p(4)), c(16,24,12,12,2,3,4,0)).
wanted(two(face), apart(1-p(2)), c(12,20,11,11,1,3,3,0)).
wanted(two(face), dissolve(1, 2), c(12,20,10,10,1,2,2,0)).
wanted(two(face), dissolve(region([2]), region([1])),
       c(12,20,10,10,1,2,2,0)).
wanted(two(face), dissolve(region([1],1), 2), c(12,20,10,10,1,2,2,0)).
wanted(two(edge), only(vertices), c(14,23,12,12,1,3,3,0)).
wanted(two(edge), only(edges), c(14,23,12,12,1,3,3,0)).
wanted(two(edge), only(faces), c(16,24,12,12,2,3,4,0)).
wanted(two(edge), apart(2, 1), c(16,24,12,12,2,3,4,0)).
wanted(two(vertex), only(edges), c(16,24,12,12,2,3,4,0)).
wanted(two(vertex), only(vertices), c(15,24,12,12,1,3,3,0)).
wanted(two(half_edge), apart(1, 2), c(18,26,12,12,2,3,4,0)).
wanted(fig7, only(faces), c(18,28,13,13,1,3,3,0)).
wanted(fig7, apart(1, 2), c(22,32,14,14,2,3,4,0)).
wanted(fig8(face), apart(1, 2), c(14,20,11,12,2,3,4,0)).
wanted(fig8(edge), only(faces), c(14,21,11,11,2,3,4,0)).

%   What goes through each other is glued in any case.

wanted(two(crossing), Wish, c(22,36,18,18,1,4,4,0)) :-
    member(Wish, [only(faces),only(vertices),apart(1, 2)]).
wanted(wire(through), apart(1, 2), c(12,15,6,8,1,2,2,1)).
wanted(wire(through_edge), apart(1, 2), c(11,15,6,6,1,2,2,0)).
wanted(wire(through_sheet), apart(1, 2), c(7,6,1,2,1,1,1,0)).
wanted(wire(at_edge), apart(1, 2), c(11,14,6,6,2,2,3,0)).

%   Four cubes about an edge: two neighbours are apart, and have the edge in
%   common by the others all the same. So their face opens to one side alone.

wanted(four, apart(1, 2), c(20,36,21,21,1,5,5,0)).
wanted(four, only(faces), c(18,33,20,20,1,5,5,0)).

parts(four, [box(1,[0,0,0]),box(1,[1,0,0]),box(1,[0,1,0]),box(1,[1,1,0])]) :-
    !.
parts(flush_on, [box(2,[0,0,0]),flat(1,1,2)]) :-
    !.
parts(wire(through_edge), [box(2,[0,0,0]),wire([2,0,-1], [0,0,1])]) :-
    !.
parts(wire(through_sheet), [flat(2,2,0),wire([0.2,0.1,-1], [0.2,0.1,1])]) :-
    !.
parts(Name, Parts) :-
    once(model(Name, Parts, _)).

parted(Name, Wishes, Steps, S) :-
    parts(Name, Parts),
    glue_made(Parts, Steps, S),
    forall(member(Wish, Wishes), assert_fact(gluing(S, Wish))),
    evaluate(S).

parted_counts(Name, Wishes, Steps, Counts) :-
    in_new_world(( parted(Name, Wishes, Steps, S),
                   glue_report(S, Report),
                   findall(Fault, law_fault(Report, Fault, _), Faults),
                   findall(Inside, ( member(Region, Report.regions),
                                     Region.role \== cell,
                                     Inside = Region.inside ), Insides) )),
    Faults == [],
    sort(Insides, [[]]),
    report_counts(Report, Counts).

turned_steps(0, []) :-
    !.
turned_steps(Seed, Steps) :-
    turned(Seed, Steps).

:- begin_tests(glue_parted).

test(wishes, [ forall(( wanted(Name, Wish, Wanted), member(Seed, [0,1,2]) )),
               Counts == Wanted ]) :-
    turned_steps(Seed, Steps),
    parted_counts(Name, [Wish], Steps, Counts).

%   Three pages at an edge, and two that have one of them in common and go
%   through there: the edge is glued, the page is there twice, with a slit.

test(through_edge, Counts == c(12,16,5,5,1,1,1,0)) :-
    tmp_file_stream(File, Stream, [encoding(utf8),extension(pl)]),
    format(Stream,
           "segment(1, surface, three). v(1,1,0,0,0). v(1,2,0,0,1).\n\c
            v(1,3,1,0,0). v(1,4,1,0,1). v(1,5,0,1,0). v(1,6,0,1,1).\n\c
            v(1,7,-1,-1,0). v(1,8,-1,-1,1). p(1,1,[1,3,4,2]).\n\c
            p(1,2,[1,5,6,2]). p(1,3,[1,7,8,2]). segment(2, surface, two).\n\c
            v(2,1,0,0,0). v(2,2,0,0,1). v(2,3,1,0,0). v(2,4,1,0,1).\n\c
            v(2,5,-1,0.5,0). v(2,6,-1,0.5,1). p(2,1,[1,3,4,2]).\n\c
            p(2,2,[1,2,6,5]). segment(3, cells, glue([1,2])).\n\c
            gluing(3, apart(1,2)).\n", []),
    close(Stream),
    in_new_world(( load_model(File), glue_report(3, Report) )),
    report_counts(Report, Counts).

%   A wish that they are glued is stronger.

test(glued, Counts == c(12,20,11,11,1,3,3,0)) :-
    parted_counts(two(face), [apart(1, 2),glued(2-p(6), 1-p(4))], [], Counts).
test(glued_edge, Counts == c(14,23,12,12,1,3,3,0)) :-
    parted_counts(two(edge), [only(faces),glued(1-e(3,7), 2-e(1,5))], [],
                  Counts).

%   What was dissolved is inside both.

test(dissolved, Insides == [[1,2],[]]) :-
    in_new_world(( parted(two(face), [dissolve(1, 2)], [], S),
                   glue_report(S, Report) )),
    findall(Inside, ( member(Region, Report.regions),
                      Inside = Region.inside ), Insides).

%   Without a wish again, and taken apart, all is as it was.

test(again, Rows == Rows0) :-
    in_new_world(( parted(two(face), [], [], S),
                   rows(S, Rows0),
                   assert_fact(gluing(S, apart(1, 2))),
                   evaluate(S),
                   retractall_facts(gluing(S, _)),
                   evaluate(S),
                   rows(S, Rows) )).

rows(S, rows(Vs, Ps, Rs)) :-
    findall(v(V,X,Y,Z), v(S, V, X, Y, Z), Vs),
    findall(P-Es, p(S, P, Es), Ps),
    findall(R-Role, region(S, R, Role), Rs).

%   The slit is meant, and no fault of the model.

test(no_fault, Defects == []) :-
    in_new_world(( parted(two(face), [only(edges)], [], S),
                   findall(Defect,
                           ( model_defect(Defect), arg(1, Defect, S) ),
                           Defects) )).

:- meta_predicate with_rule(+, 0).

%   may_glue/3 decides; where it lets all be glued the rule says what the
%   kernel says.

with_rule(Text, Goal) :-
    tmp_file_stream(File, Stream, [encoding(utf8),extension(pl)]),
    format(Stream, "~w~n", [Text]),
    close(Stream),
    setup_call_cleanup(use_rules(File), Goal, no_rules(File)).

test(rule_of_all, [ forall(member(Name, [two(face),fig7,fig8(ridge),four,room,
                                         cubes(2),wire(beyond)])),
                    Ruled == Kernel ]) :-
    parts(Name, Parts),
    in_new_world(( glue_made(Parts, [], S), rows(S, Kernel) )),
    in_new_world(with_rule("may_glue(_, _, _).",
                           ( glue_made(Parts, [], S1), rows(S1, Ruled) ))).
test(rule_of_none, Counts == c(24,36,18,18,3,4,6,0)) :-
    in_new_world(with_rule("may_glue(_, _, _) :- fail.",
                           ( glue_made([ box(1,[0,0,0]),box(1,[1,0,0]),
                                         box(1,[1,1,0]) ], [], S),
                             glue_report(S, Report) ))),
    report_counts(Report, Counts).

%   By kinds: where edges of one lie in edges of the other, and by operands.

test(rule_of_kinds, Counts == c(18,28,14,14,1,4,4,0)) :-
    in_new_world(with_rule("may_glue('edge-edge', _, _).\n\c
                            may_glue('edge-face', _, _).",
                           ( parts(fig7, Parts),
                             glue_made(Parts, [], S),
                             glue_report(S, Report) ))),
    report_counts(Report, Counts).
test(rule_of_operands, Counts == c(20,32,17,17,2,4,5,0)) :-
    in_new_world(with_rule("may_glue(_, seat(1,_,_), seat(2,_,_)).",
                           ( glue_made([ box(1,[0,0,0]),box(1,[1,0,0]),
                                         box(1,[2,0,0]) ], [], S),
                             glue_report(S, Report) ))),
    report_counts(Report, Counts).

%   Random cubes of a grid, some pairs apart: the laws hold, and the same
%   comes out turned.

test(random, [ forall(between(1, 12, Seed)), Turned == Counts ]) :-
    set_random(seed(Seed)),
    findall([X,Y,Z],
            ( member(X, [0,1,2]), member(Y, [0,1]), member(Z, [0,1]) ), All),
    random_permutation(All, Lows0),
    length(Lows, 5),
    append(Lows, _, Lows0),
    findall(box(1,Low), member(Low, Lows), Parts),
    findall(apart(S1, S2),
            ( between(1, 4, S1), between(S1, 5, S2), S1 < S2,
              random(1.0) < 0.4 ), Wishes),
    turned(Seed, Steps),
    in_new_world(counted(Parts, Wishes, [], Counts)),
    in_new_world(counted(Parts, Wishes, Steps, Turned)).

counted(Parts, Wishes, Steps, Counts) :-
    glue_made(Parts, Steps, S),
    forall(member(Wish, Wishes), assert_fact(gluing(S, Wish))),
    catch(( evaluate(S),
            glue_report(S, Report),
            report_counts(Report, Counts) ),
          error(geometry_error(What), _),
          ( functor(What, Name, _), Counts = refused(Name) )).

/* - - - wishes that cannot be: nothing is glued - - - */

test(no_such, [ forall(member(Wish, [ only(regions),apart(1, 9),
                                      apart(1-p(77)),apart(7-v(1)),
                                      glued(1-e(1,7), 2-v(1)),
                                      dissolve(1, 3),dissolve(1, 9),nothing,
                                      dissolve(region([1]), region([1,2])),
                                      dissolve(region([1],2), 2),
                                      apart(1-x(2)),apart(a) ])),
                error(geometry_error(part_glue(wish(_, Wish)))) ]) :-
    in_new_world(parted(two(face), [Wish], [], _)).

%   A sheet that lies on a box, and is apart from it: on which side?

test(no_side, error(geometry_error(part_glue(no_side(3))))) :-
    in_new_world(parted(flush_on, [apart(1, 2)], [], _)).

:- end_tests(glue_parted).
