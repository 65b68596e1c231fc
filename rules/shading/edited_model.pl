:- module(sg_edited_model,
          [ shaded_state/1,             % -State
            edited_model/5              % +State0, +State, +Model0, -Model,
                                        % -Changed
          ]).
:- use_module('../csg/csg_term', [is_node_term/1]).
:- use_module('../decision', [decision_is_default/1]).
:- use_module('../store',
              [current_world/1, light/2, look/2, segment/3, segment_stamps/2]).
:- use_module(shading_leaf, [known_leaf/4, last_matrix/4]).
:- use_module(shading_scene, [as_its_term/2, part_facts/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(pairs), [pairs_values/2]).
/** <module> A shaded model in which a few leaves have changed.

Most edits move a leaf, or change a size. Then the model need not be made again:
its other leaves are those that it had.
*/

%!  shaded_state(-State) is det.
%
%   State is all of the current world that a shaded model and its looks follow
%   from, as far as no rule decides.

shaded_state(state(World,Order,Segments,Stamps,dress(Looks,Lights))) :-
    current_world(World),
    findall(segment(S,Kind,Term), segment(S, Kind, Term), Segments0),
    maplist(arg(1), Segments0, Order),
    sort(Segments0, Segments),
    maplist(arg(1), Segments, Ss),
    segment_stamps(Ss, Pairs),
    pairs_values(Pairs, Stamps),
    findall(look(S,Property), look(S, Property), Looks),
    findall(light(N,Property), light(N, Property), Lights).

%!  edited_model(+State0, +State, +Model0, -Model, -Changed) is semidet.
%
%   Model is that of State, now, if Model0 is that of State0; their looks are
%   the same. Changed are the facts of the leaves that differ, before and after.
%   Fails if more has changed than primitives that are leaves, or may have:
%   roots are in the order of their facts.

edited_model(state(World,Order0,Segments0,Stamps0,Dress0),
             state(World,Order,Segments,Stamps,Dress),
             model(Leaves0,Facts0,Roots), model(Leaves,Facts,Roots), Changed) :-
    Dress0 == Dress,
    decision_is_default(surface_look/4),
    decision_is_default(tone/3),
    decision_is_default(ramp/3),
    changes(Segments0, Stamps0, Segments, Stamps, Changes),
    (   Changes == []
    ->  Leaves = Leaves0,
        Facts = Facts0,
        Changed = []
    ;   Order0 == Order
    ->  leaves_edited(Leaves0, Facts0, Changes, Leaves, Facts, Changed)
    ;   \+ ( member(root(R,_), Roots), memberchk(change(R,_,_), Changes) ),
        leaves_edited(Leaves0, Facts0, Changes, Leaves, Facts, Changed)
    ).

%   changes(Segments0, Stamps0, Segments, Stamps, Changes): Changes are
%   change(S, Term0, Term), each of a primitive that was, and is, its rows.

changes([], [], [], [], []).
changes([Segment0|Segments0], [Stamp0|Stamps0], [Segment|Segments],
        [Stamp|Stamps], Changes) :-
    (   Segment0 == Segment,
        Stamp0 =:= Stamp
    ->  Changes = Changes1
    ;   Segment0 = segment(S,Kind,Term0),
        Segment = segment(S,Kind,Term),
        \+ is_node_term(Term0),
        \+ is_node_term(Term),
        as_its_term(S, Term),
        Changes = [change(S,Term0,Term)|Changes1]
    ),
    changes(Segments0, Stamps0, Segments, Stamps, Changes1).

%   leaves_edited(Leaves0, Facts0, Changes, Leaves, Facts, Changed): the facts
%   of a leaf stand together. The half of all that a plane cuts off is as large
%   as what it cuts.

leaves_edited([], [], _, [], [], []).
leaves_edited([Leaf0|Leaves0], Facts0, Changes, [Leaf|Leaves], Facts,
              Changed) :-
    Leaf0 = leaf(Number,Root,S,_,Faces),
    Faces \= [1-cut],
    (   memberchk(change(S,Term0,Term), Changes)
    ->  leaf_edited(Term0, Term, Leaf0, Parts),
        Leaf = leaf(Number,Root,S,Placed,Faces),
        Parts = parts(Count,Placed,New),
        length(Old, Count),
        append(Old, Facts1, Facts0),
        append(New, Facts2, Facts),
        append(Old, New, Own),
        append(Own, Changed1, Changed)
    ;   Leaf = Leaf0,
        kept_facts(Facts0, Number, Facts1, Facts, Facts2),
        Changed = Changed1
    ),
    leaves_edited(Leaves0, Facts1, Changes, Leaves, Facts2, Changed1).

leaf_edited(Term0, Term, leaf(Number,_,S,Placed0,Faces),
            parts(Count,Placed,New)) :-
    last_matrix(S, Term0, Matrix, leaf(Placed0,Parts0,Shape,Faces)),
    known_leaf(S, Term, Matrix, leaf(Placed,Parts,Shape,Faces)),
    length(Parts0, Count),
    length(Parts, Count),
    part_facts(Number, Parts, New).

kept_facts([Fact|Facts0], Number, Facts1, [Fact|Facts], Facts2) :-
    arg(1, Fact, Number),
    !,
    kept_facts(Facts0, Number, Facts1, Facts, Facts2).
kept_facts(Facts0, _, Facts0, Facts, Facts).
