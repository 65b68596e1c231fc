/* Operands of a glue that are an earlier one once more: one of them is cut, and
   what comes out is named after all, whatever the numbers of their polygons. */
:- module(test_glue_copy, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(polygon/triangulation), [complete_segments/1]).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(solid/glue)).
:- use_module(rules(store)).
:- use_module(tests('rules/boolean_case'), [in_scene/2]).

%   glued(Terms, Change, Sources-(Counts-Regions)): of which polygons those of
%   the glue of segments with these terms are, what is counted of it, and
%   Role-Inside
%   of its regions.

:- meta_predicate glued(+, 0, -).

glued(Terms, Change, Sources-Counts) :-
    in_scene(Terms,
             ( call(Change),
               findall(S, segment(S, _, _), Ss0),
               sort(Ss0, Ss),
               fresh_id(segment, 0, Glue),
               assert_fact(segment(Glue, cells, glue(Ss))),
               evaluate(Glue),
               findall(S0-P-P0-Sense, from_p(Glue, P, S0, P0, Sense), Sources),
               glue_report(Glue, Report),
               findall(Role-Inside,
                       ( member(Region, Report.regions), Role = Region.role,
                         Inside = Region.inside ),
                       Regions),
               dict_pairs(Report.counts, _, Pairs),
               Counts = Pairs-Regions )).

box(X, at([translate(X,X,X)], box(size(1,1,1)))).

%   Segment 2 is the same with other numbers of polygons.

renumbered :-
    complete_segments([2]),
    findall(P-Es, p(2, P, Es), Polygons),
    retractall_facts(t(2, _, _, _, _, _)),
    retractall_facts(segment(2, _, _)),
    assert_fact(segment(2, solid, box)),
    forall(member(P-Es, Polygons),
           ( P1 is P+10,
             retractall_facts(plane(2, P, _, _, _, _)),
             retractall_facts(from_p(2, P, _, _, _)),
             retractall_facts(p(2, P, _)),
             assert_fact(p(2, P1, Es)) )),
    complete_segments([2]).

of_segment(S0, By, Sources0, Sources) :-
    findall(P-P1-Sense, ( member(S0-P-P0-Sense, Sources0), P1 is P0-By ),
            Sources).

:- begin_tests(glue_copy).

%   Three boxes in one place, and one that goes through them.

test(all_are_named, [forall(member(Change-By, [true-0,renumbered-10])),
                     true(S2-S3 == S1-S1)]) :-
    maplist(box, [0,0,0,0.5], Terms),
    glued(Terms, test_glue_copy:Change, Sources-_),
    of_segment(1, 0, Sources, S1),
    S1 = [_|_],
    of_segment(2, By, Sources, S2),
    of_segment(3, 0, Sources, S3).
test(as_two, Inside == [[1,2,3],[4],[1,2,3,4],[]]) :-
    maplist(box, [0,0,0,0.5], Terms),
    maplist(box, [0,0.5], Two),
    glued(Terms, true, _-(Counts-Regions)),
    glued(Two, true, _-(Counts-_)),
    findall(In, member(_-In, Regions), Inside).

%   Sheets too.

test(sheets, Same == true) :-
    Sheet = face([[0,0,0],[1,0,0],[1,1,0],[0,1,0]]),
    in_scene([],
             ( forall(between(1, 3, S), sheet(S, Sheet)),
               Term = at([translate(0.25,0.25,-0.5)], box(size(1,1,1))),
               assert_fact(segment(4, solid, Term)),
               assert_fact(segment(5, cells, glue([1,2,3,4]))),
               evaluate(5),
               findall(P, from_p(5, P, 1, _, 1), One),
               findall(P, from_p(5, P, 3, _, 1), Three),
               ( One == Three, One = [_,_|_] -> Same = true ; Same = One-Three )
             )).

sheet(S, face(Points)) :-
    assert_fact(segment(S, surface, sheet)),
    forall(nth1(V, Points, [X,Y,Z]), assert_fact(v(S, V, X, Y, Z))),
    forall(member(E-A-B, [1-1-2,2-2-3,3-3-4,4-4-1]),
           assert_fact(e(S, E, A, B, 1))),
    assert_fact(p(S, 1, [1,2,3,4])).

:- end_tests(glue_copy).
