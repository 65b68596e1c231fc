:- module(test_contact_origin, []).
% covers: contact_places_rows, contact_origin_rows
% covers: contact_feature_rows, vertex_polygons_rows, contact_places
% covers: added_rows
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(kernel),
              [ contact_facts/2, contact_origins/2, contact_places/2,
                solid_close/1, solid_write/2
              ]).
:- use_module(rules(penetration/penetration), [leaf_lines/4]).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(solid/boolean)).
:- use_module(rules(store)).
:- use_module(tests('oracle/contact_origin')).

/* Origins of results that name what leaves have: the kernel beside the rule. */

:- begin_tests(contact_origin).

:- meta_predicate in_scene(+, 0).

in_scene(Solids, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Solid, Solids), add_primitive(Solid, _)),
               complete_segments,
               Goal )).

%   scene(?Name, -Solids, -Leaves): solids of which features touch but for
%   rounding, all turned alike; Leaves are the numbers of those to be combined.

scene(cylinders, [at([Turn], cylinder(radius(1), height(4), facets(24))),
                  at([rotate(axis(1,0,0),90),translate(0,2,2),Turn],
                     cylinder(radius(1), height(4), facets(24)))], [1,2]) :-
    turn(Turn).
scene(boxes, Boxes, [1,2,3,4,5,6]) :-
    turn(Turn),
    set_random(seed(7)),
    findall(at([translate(X,Y,Z),Turn], box(size(A,B,C))),
            ( between(1, 6, _),
              maplist(random_between(0, 3), [X,Y,Z]),
              maplist(random_between(1, 2), [A,B,C]) ),
            Boxes).

turn(rotate(axis(3,1,2), 37)).

/* - - - where leaves touch - - - */

test(places, [forall(scene(_, Solids, Leaves)), true(N > 0)]) :-
    in_scene(Solids, places_agree(Leaves, N)).

places_agree(Leaves, N) :-
    findall(A-B, ( member(A, Leaves), member(B, Leaves), A < B ), Pairs),
    boolean_tolerance(Leaves, [], Options),
    memberchk(tolerance(Tolerance), Options),
    facts_snapshot(leaf_lines(Pairs, Leaves, Tolerance,
                              compared(Leaves, N))).

compared(Leaves, N, _, _, _) :-
    maplist(places_of, Leaves, Counts),
    sum_list(Counts, N).

places_of(S, N) :-
    contact_places_by_rule(S, ByRule),
    (   contact_places(S, Contacts)
    ->  contact_facts(Contacts, Facts)
    ;   Facts = []
    ),
    assertion(Facts == ByRule),
    length(Facts, N).

test(none, fail) :-
    in_scene([box(size(1,1,1))], contact_places(1, _)).

/* - - - origins of results - - - */

%   Every operation, and a result that is a leaf again: its own origins are
%   near(_) already.

test(origins, [forall(( scene(Scene, Solids, Leaves), operation(Operation) )),
               true(N >= Least)]) :-
    Expression =.. [Operation,Leaves],
    in_scene(Solids, origins_agree(Expression, Leaves, 101, N)),
    least(Scene, Operation, Least).

%   There is something to name.

least(cylinders, _, 20).
least(boxes, Operation, Least) :-
    (   Operation == union
    ->  Least = 10
    ;   Least = 0
    ).

test(origins_of_results, true(N > 0)) :-
    scene(boxes, Solids, Leaves),
    in_scene(Solids,
             ( Leaves = [First|Others],
               boolean(union(Leaves), 50),
               boolean(difference([50,First]), 51),
               origins_agree(union([51|Others]), [51|Others], 101, N),
               origins_agree(difference([50,51]), [50,51], 103, _) )).

operation(union).
operation(intersection).
operation(difference).

%   origins_agree(+Expression, +Leaves, +S, -N): the result is written as S and
%   the next one. N vertices were made to touch.

origins_agree(Expression, Leaves, S, N) :-
    boolean_tolerance(Leaves, [], Options),
    S2 is S+1,
    setup_call_cleanup(
        sg_boolean:selected_solid(Expression, Leaves, Options, Solid, Contacts,
                                  _),
        maplist(written(Solid, Contacts),
                [S,S2], [contact_origins,contact_origins_by_rule]),
        solid_close(Solid)),
    maplist(named, [S,S2], Named),
    assertion(foldl(same, Named, _, _)),
    Named = [Origins-_|_],
    aggregate_all(count, member(_-near(_), Origins), N).

written(Solid, Contacts, S, Rule) :-
    assert_fact(segment(S, solid, S)),
    solid_write(Solid, S),
    call(Rule, S, Contacts).

%   In the order of the rows.

named(S, Origins-Sources) :-
    findall(Item-Origin, origin(S, Item, Origin), Origins),
    findall(V-(S0-V0), from_v(S, V, S0, V0), Sources).

same(Named, Named, Named).

:- end_tests(contact_origin).
