:- module(test_touching, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(library(occurs)).
:- use_module(rules(solid/csg_evaluate), [evaluate/1]).
:- use_module(rules(csg/csg_roots)).
:- use_module(rules(explanation/explain)).
:- use_module(rules(kernel), [operand_borders/2]).
:- use_module(rules(csg/provenance)).
:- use_module(rules(model/solid_file), [output_statistics/1]).
:- use_module(rules(store)).
:- use_module(tests('rules/boolean_case')).
:- use_module(tests('rules/random_solid')).
:- use_module(tests('oracle/operand_border')).

/* Bodies that touch faces of others inside, with a vertex or an edge, from
outside or from within, as they are and turned: what comes out of any operation
is clean in the relations, in OFF, whose numbers are those of the relations, and
in STL. */

%   touching(Kind, X, Y, Solid): it touches the top of a box from 0 to 2, near
%   (X,Y), or shares a part of it.

touching(edge, X, Y,
         at([translate(X,Y,2),rotate(axis(1,0,0),45),translate(0.5,0.5,0)],
            box(size(Length,1,1)))) :-
    random_member(Length, [1,2,4,6]).
touching(edge_across, X, Y,
         at([translate(X,Y,2),rotate(axis(0,1,0),-45),translate(0.5,0.5,0)],
            box(size(1,Length,1)))) :-
    random_member(Length, [1,2,4,6]).
touching(apex, X, Y,
         at([translate(X,Y,3),rotate(axis(1,0,0),180)],
            pyramid(base(1,1), height(1)))).
touching(apex_inside, X, Y,
         at([translate(X,Y,0.5)], pyramid(base(1,1), height(1.5)))).
touching(edge_inside, X, Y,
         at([translate(X,Y,1.2),rotate(axis(1,0,0),90)],
            prism(outline([[0,0],[1,0],[0.5,0.8]]), height(Length)))) :-
    random_member(Length, [1,2,3]).
touching(face, X, Y, at([translate(X,Y,Z)], box(size(0.5,0.5,Height)))) :-
    random_member(Z, [0,1,2]),
    random_member(Height, [1,2]).

one_touching(Solid) :-
    random_member(Kind, [edge,edge_across,apex,apex_inside,edge_inside,face]),
    random_between(-4, 4, I),
    random_between(-4, 4, J),
    X is 0.25*I,
    Y is 0.25*J,
    touching(Kind, X, Y, Solid).

scene(Seed, Solids) :-
    set_random(seed(Seed)),
    random_between(1, 4, N),
    length(Others, N),
    maplist(one_touching, Others),
    Solids0 = [box(size(4,4,2))|Others],
    (   Seed mod 4 =:= 0
    ->  Solids = Solids0
    ;   random_rotation(Steps),
        maplist(placed(Steps), Solids0, Solids)
    ).

%   operation(N, Expression): of N operands.

operation(N, union(Ss)) :-
    numlist(1, N, Ss).
operation(N, difference(Ss)) :-
    numlist(1, N, Ss).
operation(N, union([difference([1,2])|Ss])) :-
    numlist(3, N, Ss).
operation(N, difference([union(Ss),N])) :-
    N > 2,
    numlist(1, N, Ss).

clean(Name, Solids, Expression) :-
    result(Expression, S),
    measured([S], [M]),
    files_measured([S], off, [Off]),
    files_measured([S], stl, [Stl]),
    (   M.good+Off.good+Stl.good == yes+yes+yes
    ->  true
    ;   keep_case(Name, Solids, Expression),
        format("~w ~w: ~p~n", [Name,Expression,[M,Off,Stl]]),
        fail
    ).

%   named(+S): every vertex of S says where it comes from, by vertices, edges
%   and polygons that are there; one that is no vertex of a leaf lies on two
%   features of leaves.

named(S) :-
    forall(v(S, V, _, _, _), vertex_named(S, V)),
    forall(from_v(S, _, S0, V0), v(S0, V0, _, _, _)).

vertex_named(S, V) :-
    findall(S0-Feature, vertex_on(S, V, S0, Feature), Places),
    forall(member(Place, Places), is_there(Place)),
    forall(( origin(S, v(V), Origin),
             sub_term(S0-(A,B), Origin),
             comma_member(V0, (A,B)) ),
           v(S0, V0, _, _, _)),
    (   vertex_from(S, V, _, _)
    ->  true
    ;   Places = [_,_|_]
    ),
    explanation(vertex(S, V), _),
    !.
vertex_named(S, V) :-
    findall(Origin, origin(S, v(V), Origin), Origins),
    format("vertex ~w of ~w: ~w~n", [V,S,Origins]),
    fail.

is_there(S-v(V)) :-
    v(S, V, _, _, _).
is_there(S-e(E)) :-
    e(S, E, _, _, _).
is_there(S-p(P)) :-
    p(S, P, _).

comma_member(V, (A,B)) :-
    !,
    ( V = A ; comma_member(V, B) ).
comma_member(V, V).

%   What touches with an edge or an apex in the middle of a face.

one(edge, 10).
one(edge_across, 10).
one(apex, 10).
one(apex_inside, 10).
one(edge_inside, 10).

rounds(Rounds) :-
    output_statistics(Statistics),
    Rounds = Statistics.rounds.

:- begin_tests(touching).

%   Nothing is rounded in OFF, so nothing has to be united again.

test(one, [ forall(( one(Kind, N), sample(Kind, N, Seed) )),
            true(After == Before)
          ]) :-
    set_random(seed(Seed)),
    touching(Kind, 0.3, 0.2, Solid),
    random_rotation(Steps),
    maplist(placed(Steps), [box(size(4,4,2)),Solid], Solids),
    rounds(Before),
    in_scene(Solids,
             forall(member(Operation, [union,difference]),
                    ( Expression =.. [Operation,[1,2]],
                      result(Expression, S),
                      measured([S], [M]),
                      files_measured([S], off, [Off]),
                      M.good+Off.good == yes+yes ))),
    rounds(After).
test(origins, forall(sample(origins, 12, Seed))) :-
    scene(Seed, Solids),
    length(Solids, N),
    in_scene(Solids,
             forall(operation(N, Expression),
                    ( result(Expression, S), named(S) ))).
test(borders, forall(sample(borders, 8, Seed))) :-
    scene(Seed, Solids),
    length(Solids, N),
    in_scene(Solids,
             forall(operation(N, Expression),
                    ( result(Expression, S),
                      findall(Border, operands_meet(S, Border), Rule0),
                      sort(Rule0, Rule),
                      operand_borders([S], Kernel0),
                      sort(Kernel0, Kernel),
                      Kernel == Rule ))).

%   Bodies on each other: a line all round where they join, also where no vertex
%   was made.

test(joint, [ forall(member(Turn-Solid-N,
                            [ turned-box(size(2,1,1))-4,
                              straight-box(size(2,1,1))-4,
                              turned-cylinder(radius(1), height(1),
                                              facets(12))-12,
                              straight-cylinder(radius(1), height(1),
                                                facets(12))-12 ])),
              true(Lines == N)
            ]) :-
    Solids0 = [ box(size(4,4,2)), at([translate(0,0,2)], Solid) ],
    set_random(seed(7)),
    random_rotation(Steps),
    (   Turn == turned
    ->  maplist(placed(Steps), Solids0, Solids)
    ;   Solids = Solids0
    ),
    in_scene(Solids,
             ( assert_fact(segment(3, solid, union([1,2]))),
               evaluate(all),
               operand_lines(Found) )),
    length(Found, Lines).
test(several, forall(sample(touching, 25, Seed))) :-
    scene(Seed, Solids),
    length(Solids, N),
    atom_concat(touching_, Seed, Name),
    in_scene(Solids,
             forall(operation(N, Expression),
                    clean(Name, Solids, Expression))).

:- end_tests(touching).
