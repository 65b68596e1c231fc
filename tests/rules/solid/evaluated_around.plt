/* A long tree of which a leaf is edited is made anew around that leaf alone,
   and has the boundary that it would have if it were evaluated for the first
   time, but for the ids.

   AROUND_CASES=N tries N times as many trees.
*/
:- module(test_evaluated_around, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(decision), [use_rules/1, no_rules/1]).
:- use_module(rules(store)).
:- use_module(tests('rules/solid/fresh_tree')).
:- use_module(tests('rules/random_solid')).

/* - - - a street of solids - - - */

%   Leaves 1, 2, ... stand along x, each meeting, or touching, a few of those
%   before and after it. Under 100 some of them are united, the others taken
%   away.

street(Kind, N, Segments) :-
    numlist(1, N, Leaves),
    findall(segment(S, solid, Term),
            ( member(S, Leaves), house(Kind, S, Term) ),
            Houses),
    findall(S, ( member(S, Leaves), S mod 3 =\= 0 ), Added),
    findall(S, ( member(S, Leaves), S mod 3 =:= 0 ), Removed),
    append(Houses,
           [segment(100, solid, difference([union(Added)|Removed]))],
           Segments).

%   Blocks are of a grid, so that many faces coincide; `wall`: at some places
%   they have the same front, and become one face over many leaves.

house(blocks, S, at([translate(X,0,0)], Primitive)) :-
    X is 3*S,
    random_blocks(_, Primitive).
house(turned, S, at([rotate(axis(1,2,3),20)], Term)) :-
    house(blocks, S, Term).
house(anywhere, S, at([translate(X,0,0)], Primitive)) :-
    X is 1.25*S,
    random_placed(Primitive).
house(wall, S, at([translate(X,0.5,0)], box(size(W,1,H)))) :-
    random_member(W, [0.75,1,1.25]),
    random_member(H, [1,2]),
    X is S.

edit(Kind, S, Term) :-
    random_member(Edit, [shape,shifted]),
    edit(Edit, Kind, S, Term).

edit(shape, Kind, S, Term) :-
    house(Kind, S, Term).
edit(shifted, _, S, at([translate(0,Y,0)], Term)) :-
    segment(S, _, Term),
    !,
    random_member(Y, [-0.5,-0.25,0.25,0.5]).

/* - - - as if it were the first time - - - */

%   edited(Kind, Edits, Seed, Faults, Around): a street after each of so many
%   edits that make it another one. Faults are those after which it is not as in
%   a fresh world; Around: how many evaluations were around an edit alone.

edited(Kind, Edits, Seed, Faults, Around) :-
    set_random(seed(Seed)),
    street(Kind, 20, Segments),
    tree_world(Segments, World),
    in_world(World,
             ( evaluate(100),
               csg_statistics_reset,
               findall(Seed-I,
                       ( between(1, Edits, I),
                         once(edited_once(Kind, I)),
                         evaluate(100),
                         \+ is_as_fresh ),
                       Faults),
               csg_statistics(Statistics)
             )),
    Around = Statistics.around.

%   Every fourth time what was done is undone, and something else is done.

edited_once(Kind, I) :-
    (   I mod 4 =:= 0
    ->  facts_undo,
        facts_undo
    ;   true
    ),
    random_between(1, 20, S),
    edit(Kind, S, Term),
    facts_transaction(sg_test_fresh_tree:replaced(S, Term)).

is_as_fresh :-
    boundary(100, Boundary),
    file_of(100, File),
    fresh(Other),
    in_world(Other, ( evaluate(100),
                      boundary(100, Expected),
                      file_of(100, ExpectedFile) )),
    Boundary == Expected,
    File == ExpectedFile.

faults(Kind, N, Edits, Faults, Around) :-
    (   getenv('AROUND_CASES', Text),
        atom_number(Text, Times)
    ->  Last is N*Times
    ;   Last = N
    ),
    numlist(1, Last, Seeds),
    maplist(edited(Kind, Edits), Seeds, Lists, Arounds),
    append(Lists, Faults),
    sum_list(Arounds, Sum),
    Around is Sum/(Last*Edits).

/* - - - a rule file - - - */

%   ruled(Text, How, Fresh): a street is evaluated following a rule file of this
%   Text; then nothing is followed, and it is evaluated after each of two edits.
%   How: what of it was around these alone; Fresh: was it as in a fresh world?

ruled(Text, How, Fresh) :-
    set_random(seed(1)),
    street(wall, 20, Segments),
    tree_world(Segments, World),
    in_world(World,
             setup_call_cleanup(
                 rule_file(Text, File),
                 ( use_rules(File),
                   evaluate(100),
                   no_rules(File),
                   maplist(evaluated_as(wall), [4,15], How, Fresh)
                 ),
                 delete_file(File))).

rule_file(Text, File) :-
    tmp_file_stream(File, Stream, [extension(pl)]),
    write(Stream, Text),
    close(Stream).

evaluated_as(Kind, S, How, Fresh) :-
    once(edit(Kind, S, Term)),
    facts_transaction(sg_test_fresh_tree:replaced(S, Term)),
    csg_statistics_reset,
    evaluate(100),
    csg_statistics(Statistics),
    (   Statistics.around =:= 1
    ->  How = around
    ;   How = whole
    ),
    (   is_as_fresh
    ->  Fresh = true
    ;   Fresh = false
    ).

:- begin_tests(evaluated_around).

test(blocks, Faults == []) :-
    faults(blocks, 3, 8, Faults, Around),
    assertion(Around > 0.9).
test(turned, Faults == []) :-
    faults(turned, 3, 8, Faults, Around),
    assertion(Around > 0.9).
test(anywhere, Faults == []) :-
    faults(anywhere, 3, 8, Faults, Around),
    assertion(Around > 0.9).
test(wall, Faults == []) :-
    faults(wall, 3, 8, Faults, Around),
    assertion(Around > 0.8).

% What a rule file decided is not to stay beside what is made without it.

test(merged_by_rule, How-Fresh == [whole,around]-[true,true]) :-
    ruled("merge_faces(part(S,_,_), part(S,_,_)).", How, Fresh).
test(chosen_by_rule, How-Fresh == [whole,around]-[true,true]) :-
    ruled("stays(E, C, Sense) :- C = component(_, S, _, _, _, _), S =\\= 9,\n\c
             default(stays(E, C, Sense)).", How, Fresh).

:- end_tests(evaluated_around).
