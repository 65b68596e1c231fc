:- module(test_joined_picture, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(solid/csg_evaluate), [evaluate/0]).
:- use_module(rules(csg/csg_roots),
              [roots_alone/0, operand_lines/1, with_operand_lines/2]).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(kernel),
              [model_tolerance/1, cut_set_open/2, cut_set_close/1]).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(model/model), [load_model/1]).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(penetration/resolve), [resolve_contacts/2]).
:- use_module(tests('oracle/resolve')).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(picture/view)).
:- use_module(tests('rules/polyhedron'), [in_new_world/1]).
:- use_module(tests('rules/random_solid')).

/* A join is drawn as its operands are: where they touch, whatever rounding made
   of it, there is one line, a penetration line. */

%   lengths(+How, +Terms, +Lines, -Lengths): of the picture of the primitives
%   Terms, `apart` or `joined`.

lengths(How, Terms, Lines, Lengths) :-
    in_new_world(( maplist(add_primitive, Terms, Ss),
                   put_together(How, Ss),
                   pictured(Lines, Lengths) )).

%   pictured(+Lines, -Lengths): of the roots, in thousandths,
%   Visibility-Role-Length.

pictured(Lines, Lengths) :-
    complete_segments,
    evaluate,
    operand_lines(Seams),
    roots_alone,
    penetrate(all, [themselves(true)]),
    set_view(301, 57, 0),
    with_operand_lines(Seams, picture([lines(Lines)])),
    findall(Length, length_of(Length), Lengths).

put_together(apart, _).
put_together(joined, Ss) :-
    fresh_id(segment, 0, J),
    assert_fact(segment(J, solid, join(Ss))).

length_of(Visibility-Role-Length) :-
    aggregate(sum(L), part_length(Visibility, Role, L), Sum),
    Length is round(Sum*1.0e3).

part_length(Visibility, Role, L) :-
    drawn(_, S, E, From, To, Visibility, Role),
    e(S, E, V1, V2, _),
    screen(S, V1, X1, Y1, _),
    screen(S, V2, X2, Y2, _),
    L is (To-From)*sqrt((X2-X1)**2+(Y2-Y1)**2).

%   blocks(+Seed, -Terms): some that touch more often than not, all turned by
%   the same steps.

blocks(Seed, Terms) :-
    set_random(seed(Seed)),
    random_between(2, 4, N),
    random_rotation(Steps),
    length(Terms, N),
    maplist(block(Steps), Terms).

block(Steps, Term) :-
    random_blocks(_, Term0),
    placed(Steps, Term0, Term).

same_picture(Seed, Lines) :-
    blocks(Seed, Terms),
    lengths(apart, Terms, Lines, L1),
    lengths(joined, Terms, Lines, L2),
    (   L1 == L2
    ->  true
    ;   print_message(error, format("seed ~w: ~w and ~w", [Seed,L1,L2])),
        fail
    ).

%   bend(+Operation, -Lengths): of the penetration lines of the gallery's bend.

bend(Operation, Lengths) :-
    absolute_file_name(sanggwan('facts/gallery/elbow.pl'), File),
    in_new_world(( load_model(File),
                   segment(8, Kind, named(Name, union(Ss))),
                   retractall_facts(segment(8, _, _)),
                   Term =.. [Operation,Ss],
                   assert_fact(segment(8, Kind, named(Name, Term))),
                   pictured(penetration, Lengths) )).

%   touched(:Resolve, +Terms, -Rows): what a join of Terms is, made to touch.

touched(Resolve, Terms, Rows) :-
    in_new_world(( maplist(add_primitive, Terms, Ss),
                   put_together(joined, Ss),
                   complete_segments,
                   evaluate,
                   roots_alone,
                   segment(S, _, _),
                   model_tolerance(Tolerance),
                   cut_set_open([S-S], Set),
                   call(Resolve, Set, Tolerance),
                   cut_set_close(Set),
                   findall(Row, touched_row(S, Row), Rows) )).

touched_row(S, v(V,X,Y,Z)) :- v(S, V, X, Y, Z).
touched_row(S, e(E,V,W)) :- e(S, E, V, W, _).
touched_row(S, t(P,A,B,C)) :- t(S, P, _, A, B, C).
touched_row(S, origin(Item,Origin)) :- origin(S, Item, Origin).

:- begin_tests(joined_picture).

test(feature, Failed == []) :-
    findall(Seed, ( between(1, 100, Seed), \+ same_picture(Seed, feature) ),
            Failed).
test(all, Failed == []) :-
    findall(Seed, ( between(201, 230, Seed), \+ same_picture(Seed, all) ),
            Failed).

% The joints of a bend are those of the united one, all of them.
test(bend, Joined == United) :-
    bend(union, United),
    bend(join, Joined),
    memberchk(visible-penetration-_, United).

% A join in a join; something else that touches it.
test(nested, Lengths == Apart) :-
    blocks(1, [A,B,C|_]),
    lengths(apart, [A,B,C], feature, Apart),
    in_new_world(( maplist(add_primitive, [A,B,C], [S1,S2,S3]),
                   assert_fact(segment(4, solid, join([S1,S2]))),
                   assert_fact(segment(5, solid, join([S3,4]))),
                   pictured(feature, Lengths) )).
test(beside, Lengths == Apart) :-
    blocks(1, [A,B,C|_]),
    lengths(apart, [A,B,C], feature, Apart),
    in_new_world(( maplist(add_primitive, [A,B,C], [S1,S2,_]),
                   assert_fact(segment(4, solid, join([S1,S2]))),
                   pictured(feature, Lengths) )).

% Drawn again in the same world nothing changes.
test(again, Again == Once) :-
    blocks(7, Terms),
    in_new_world(( maplist(add_primitive, Terms, Ss),
                   put_together(joined, Ss),
                   pictured(feature, Once),
                   pictured(feature, Again) )).

% The kernel writes what the rule says.
test(by_rule, Kernel == Rule) :-
    blocks(1, Terms),
    touched(resolve_contacts, Terms, Kernel),
    touched(resolve_contacts_by_rule, Terms, Rule).

:- end_tests(joined_picture).
