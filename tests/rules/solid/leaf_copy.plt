/* Operands that are an earlier one once more: the first few stand for all of
   them, and the result is what it is where each is cut by itself, but for the
   order of its rows and for names of points that have several.

   BOOLEAN_CASES=N tries N times as many trees.
*/
:- module(test_leaf_copy, []).
% covers: leaf_copy_rows
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(decision), [use_rules/1, no_rules/1]).
:- use_module(rules(kernel), [leaf_copies/3]).
:- use_module(rules(penetration/penetration), [penetrate/0]).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(solid/boolean)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(store)).
:- use_module(tests('rules/boolean_case'), [in_scene/2, sample/3]).
:- use_module(tests('rules/random_solid')).
:- use_module(tests('rules/solid/fresh_tree')).

/* - - - which are - - - */

box(X, at([translate(X,0,0)], box(size(1,1,1)))).

%   copies(Terms, Change, Copies): of segments with these terms, changed.

:- meta_predicate copies(+, 0, -).

copies(Terms, Change, Copies) :-
    in_scene(Terms,
             ( call(Change),
               findall(S, segment(S, _, _), Ss0),
               sort(Ss0, Ss),
               leaf_copies(Ss, 1, Copies) )).

vertex_moved :-
    v(2, 8, X, Y, Z),
    !,
    X1 is X+0.125,
    exchanged(v(2, 8, X, Y, Z), v(2, 8, X1, Y, Z)).

exchanged(Row0, Row) :-
    facts_transaction(( retract_fact(Row0), assert_fact(Row) )).

kind_changed :-
    retract_fact(segment(2, _, Term)),
    assert_fact(segment(2, surface, Term)).

edge_changed :-
    e(2, 1, V1, V2, 1),
    !,
    exchanged(e(2, 1, V1, V2, 1), e(2, 1, V1, V2, 0)).

source_changed :-
    assert_fact(origin(2, s(2), source(0.001))).

/* - - - what is made of them - - - */

%   tree(How, Seed, Terms, Expression): of leaves several of which are equal,
%   each once in Expression; How is `few` or `many`.

tree(How, Seed, Terms, Expression) :-
    set_random(seed(Seed)),
    leaves(How, Least, Most, MostKinds),
    random_between(1, MostKinds, Kinds),
    random_member(Class, [blocks,turned,placed]),
    findall(Term, ( between(1, Kinds, _), term(Class, Term) ), Different),
    random_between(Least, Most, N),
    findall(Term, ( between(1, N, _), random_member(Term, Different) ), Terms),
    numlist(1, N, Ss0),
    random_permutation(Ss0, Ss),
    expression(Ss, Expression).

leaves(few, 2, 6, 3).
leaves(many, 12, 20, 2).

term(blocks, Term) :-
    random_blocks(_, Term).
term(turned, at([rotate(axis(1,2,3),20)], Term)) :-
    term(blocks, Term).
term(placed, Term) :-
    random_placed(Term).

expression([S], Expression) :-
    !,
    Expression = S.
expression(Ss, Expression) :-
    random_member(Operation, [union,intersection,difference]),
    length(Ss, N),
    random_between(1, N, Most),
    parts(Ss, Most, Parts),
    maplist(expression, Parts, Es),
    Expression =.. [Operation,Es].

parts(Ss, 1, Parts) :-
    !,
    (   Ss = [S,T|Rest]
    ->  Parts = [[S],[T|Rest]]
    ;   Parts = [Ss]
    ).
parts(Ss, Most, [Part|Parts]) :-
    length(Ss, N),
    N > Most,
    !,
    random_between(1, Most, M),
    length(Part, M),
    append(Part, Rest, Ss),
    parts(Rest, Most, Parts).
parts(Ss, _, Parts) :-
    findall([S], member(S, Ss), Parts).

%   made(How, Terms, Expression, Result): what it is, or what is said. Of few
%   leaves all rows, of many what has one name.

made(How, Terms, Expression, Result) :-
    in_scene(Terms, result_of(How, Expression, Result)).

result_of(How, Expression, Result) :-
    catch(boolean(Expression, 100), error(Error, _), true),
    (   nonvar(Error)
    ->  Result = Error
    ;   How == few
    ->  rows(100, Result)
    ;   boundary(100, boundary(Vertices, Polygons)),
        findall(Place-From, member(vertex(Place, From, _), Vertices), Places),
        findall(p(Edges, Plane, Sources),
                member(polygon(Edges, _, Plane, Sources), Polygons), Ps),
        Result = Places-Ps
    ).

rows(S, Rows) :-
    findall(Row,
            ( member(Row, [ v(S,_,_,_,_), e(S,_,_,_,_), p(S,_,_),
                            t(S,_,_,_,_,_), from_v(S,_,_,_),
                            from_p(S,_,_,_,_), origin(S,_,_) ]),
              call(Row) ),
            Rows).

%   each_made(How, Terms, Expression, Result): the same with a rule that decides
%   as the default does, so each leaf is asked for.

each_made(How, Terms, Expression, Result) :-
    in_scene(Terms, with_rule(result_of(How, Expression, Result))).

:- meta_predicate with_rule(0).

with_rule(Goal) :-
    tmp_file_stream(File, Stream, [extension(pl)]),
    format(Stream, "stays(E, C, S) :- default(stays(E, C, S)).~n", []),
    close(Stream),
    call_cleanup(( use_rules(File),
                   call_cleanup(Goal, no_rules(File))
                 ),
                 delete_file(File)).

differs(How, Seed) :-
    tree(How, Seed, Terms, Expression),
    made(How, Terms, Expression, Result1),
    each_made(How, Terms, Expression, Result2),
    Result1 \== Result2,
    format("~q~n~q~n", [Terms,Expression]).

/* - - - and made again - - - */

%   faults(Edits, Faults): a tree after each of Edits, S-Term, that is not as it
%   is in a fresh world.

faults(Expression, Terms, Edits, Faults) :-
    findall(segment(S, solid, Term), nth1(S, Terms, Term), Segments),
    tree_world([segment(100, solid, Expression)|Segments], World),
    in_world(World,
             ( evaluate(100),
               findall(S-Term,
                       ( member(S-Term, Edits),
                         replaced(S, Term),
                         evaluate(100),
                         \+ is_as_fresh ),
                       Faults) )).

is_as_fresh :-
    boundary(100, Here),
    fresh(World),
    in_world(World, ( evaluate(100), boundary(100, There) )),
    Here == There.

random_edits(Seed, Expression, Terms, Edits) :-
    tree(many, Seed, Terms, Expression),
    length(Terms, N),
    findall(S-Term,
            ( between(1, 6, _),
              random_between(1, N, S),
              (   maybe
              ->  random_member(Term, Terms)
              ;   term(blocks, Term)
              ) ),
            Edits).

:- begin_tests(leaf_copy).

test(copies, Copies == [3-1,5-2,6-1]) :-
    maplist(box, [0,1,0,2,1,0], Terms),
    copies(Terms, true, Copies).
test(by_other_ways, Copies == [2-1]) :-
    copies([ at([translate(1,2,3)], box(size(1,1,1))),
             at([translate(1,0,0),translate(0,2,3)], box(size(1,1,1))) ],
           true, Copies).
test(mirrored, Copies == []) :-
    copies([ box(size(1,1,1)),
             at([scale(-1,1,1)], box(size(1,1,1))) ],
           true, Copies).
test(differ, [forall(member(Change, [ vertex_moved, kind_changed, edge_changed,
                                      source_changed ])),
              Copies == []]) :-
    box(0, Box),
    copies([Box,Box], Change, Copies).
test(cut, Copies == []) :-
    copies([ box(size(1,1,1)), box(size(1,1,1)),
             at([translate(0.5,0.5,0.5)], box(size(1,1,1))) ],
           penetrate, Copies).
test(empty, Copies == []) :-
    copies([], ( assert_fact(segment(1, solid, union([]))),
                 assert_fact(segment(2, solid, union([]))) ), Copies).

test(same, [ forall(( member(How, [few,many]),
                      sample(leaf_copy, 20, Seed) )),
             fail ]) :-
    differs(How, Seed).

%   What is taken away is the same ten times, and once not.

test(apart, Faults == []) :-
    findall(Term, ( between(1, 11, _), box(0, Term) ), Terms),
    maplist(box, [5,0,0.5], [Far,Back,Half]),
    numlist(1, 10, Ss),
    faults(difference([11|Ss]), Terms,
           [11-Far,11-Back,1-Far,11-Half,9-Half,10-Half,11-Far,1-Back],
           Faults).
test(again, [forall(sample(leaf_copy, 6, Seed)), Faults == []]) :-
    random_edits(Seed, Expression, Terms, Edits),
    faults(Expression, Terms, Edits, Faults).

:- end_tests(leaf_copy).
