/* A glue that gets one operand more has the rows of the glue of all, whether
   only what is near changed or all was made anew.
   covers: cell_added, cell_added_read_rows, cell_added_rows
   covers: cell_added_write_rows, region_content, region_content_rows */
:- module(test_glue_grown, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(store)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

%   at_once(Terms, Rows), one_by_one(Terms, Rows, Around): Rows are those of
%   the glue, Around says how often only what was near changed.

glue(99).

at_once(Terms, Rows) :-
    in_new_world(( forall(nth1(S, Terms, Term), operand(S, Term)),
                   length(Terms, N),
                   glued(N),
                   rows(Rows) )).

one_by_one([Term|Terms], Rows, Around) :-
    csg_statistics_reset,
    in_new_world(( operand(1, Term),
                   glued(1),
                   foldl(one_more, Terms, 1, _),
                   rows(Rows) )),
    csg_statistics(Statistics),
    Around = Statistics.around.

one_more(Term, N0, N) :-
    N is N0+1,
    operand(N, Term),
    glued(N).

operand(S, Term) :-
    assert_fact(segment(S, solid, Term)).

glued(N) :-
    glue(S),
    numlist(1, N, Ss),
    retractall_facts(segment(S, _, _)),
    assert_fact(segment(S, cells, glue(Ss))),
    evaluate(S).

rows(Rows) :-
    glue(S),
    findall(Row, ( row(S, Row), Row \= origin(_, node(_), _) ), Rows0),
    msort(Rows0, Rows).

row(S, Row) :-
    member(Name/Arity,
           [ v/5, e/5, p/3, plane/6, t/6, from_v/4, from_p/5, from_r/4,
             region/3, sides/4, lies_in/3, origin/3, segment/3 ]),
    functor(Row, Name, Arity),
    arg(1, Row, S),
    call(sg_store:Row).

cube(Steps, X-Y-Z, at([translate(X,Y,Z)|Steps], box(size(1,1,1)))).

cubes(N, Steps, Terms) :-
    Most is N-1,
    findall(Term,
            ( between(0, Most, X), between(0, Most, Y), between(0, Most, Z),
              cube(Steps, X-Y-Z, Term) ),
            Terms).

:- begin_tests(glue_grown).

test(rows, [ forall(grown(_, Terms, Around)), Rows-N == AtOnce-Around ]) :-
    one_by_one(Terms, Rows, N),
    at_once(Terms, AtOnce).

%   grown(What, Terms, Around): of the others more than what is near changes.

grown(cubes, Terms, 6) :-
    cubes(2, [], Terms).
grown(turned, Terms, 6) :-
    cubes(2, [rotate(axis(1,2,3),17.3)], Terms).
grown(hole_filled, Terms, 23) :-
    cubes(3, [], Terms0),
    nth1(14, Terms0, Middle, Terms1),
    append(Terms1, [Middle], Terms).
grown(apart, [A,B,C], 1) :-
    maplist(cube([]), [0-0-0,5-0-0,0-5-0], [A,B,C]).
grown(inside, [box(size(9,9,9)),B], 0) :-
    cube([], 1-1-1, B).
grown(round, [B,box(size(9,9,9))], 0) :-
    cube([], 1-1-1, B).
grown(doubled, [A,A], 1) :-
    cube([], 0-0-0, A).
grown(half_a_face, [A,B], 0) :-
    maplist(cube([]), [0-0-0,1-0.5-0], [A,B]).
grown(crossing, [A,B], 0) :-
    maplist(cube([]), [0-0-0,0.5-0.5-0.5], [A,B]).
grown(edge, [A,B], 1) :-
    maplist(cube([]), [8-8-8,9-9-8], [A,B]).
grown(vertex, [A,B], 1) :-
    maplist(cube([]), [8-8-8,9-9-9], [A,B]).
grown(tolerance, [A,B], 0) :-
    maplist(cube([]), [0-0-0,1-1-0], [A,B]).
grown(ring_closed, Terms, 7) :-
    findall(Cube,
            ( member(X-Y, [0-0,1-0,2-0,2-1,2-2,1-2,0-2,0-1]),
              X1 is X+8, cube([], X1-Y-0, Cube) ),
            Terms).

test(permuted, Different-Few == []-false) :-
    cubes(3, [], Terms),
    findall(Seed-N,
            ( between(1, 5, Seed), set_random(seed(Seed)),
              random_permutation(Terms, Some),
              one_by_one(Some, Rows, N0), at_once(Some, AtOnce),
              (   Rows == AtOnce -> N = N0 ; N = different ) ),
            Pairs),
    findall(Seed, member(Seed-different, Pairs), Different),
    aggregate_all(min(N), member(_-N, Pairs), Least),
    (   number(Least), Least > 15 -> Few = false ; Few = Least ).

:- end_tests(glue_grown).
