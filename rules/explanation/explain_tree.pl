:- module(sg_explain_tree,
          [ tree_way/3,                 % +Scene, +Place, -Way
            false_reason/4,             % +Scene, +R, +In, -Reason
            takes_away/1                % +Step
          ]).
:- use_module('../csg/csg_term', [is_node_term/1, node_parts/4]).
:- use_module('../shading/shading_scene',
              [scene_leaf/2, scene_place/2, scene_root/2]).
:- use_module('../store', [segment/3]).
:- use_module(library(lists), [member/2]).

/** <module> Explain: the tree of a shaded root, with the names of its nodes.

The kernel knows a tree as a list of nodes, each before its operands
(kernel/shading.pl). Here that list is walked beside the terms it was made from,
so that each node has the segment it is, or 0.
*/

%!  tree_way(+Scene, +Place, -Way) is semidet.
%
%   Way leads from leaf Place of the kernel up to its root, the nearest first:
%   operand(I, Count, Operation, N), it is operand I of Count of the Operation
%   that segment N is, or 0; placed(N), it is placed elsewhere as segment N. A
%   section has no way.

tree_way(Scene, Place, Way) :-
    scene_place(Scene, place(Place,R,_)),
    root_tree(Scene, R, Nodes, _),
    way(Nodes, _, R, [], Place, Found),
    nonvar(Found),
    !,
    Way = Found.

%   root_tree(Scene, R, Nodes, Sections): Nodes are those of R itself; Sections
%   are the places of what it is intersected with, the last one first.

root_tree(Scene, R, Nodes, Sections) :-
    once(scene_root(Scene, root(R,All))),
    findall(Leaf, scene_leaf(Scene, leaf(Leaf,R,_,section,_)), Leaves),
    cut_open(Leaves, All, Nodes, Sections).

cut_open([_|Leaves], [node(intersection,2),node(leaf,Place)|All], Nodes,
         [Place|Places]) :-
    !,
    cut_open(Leaves, All, Nodes, Places).
cut_open(_, Nodes, Nodes, []).

%   way(Nodes0, Nodes, What, Above, Place, Found): What, a segment, a term or
%   `unknown`, is between Nodes0 and Nodes.

way([Node|Nodes0], Nodes, What0, Above0, Place, Found) :-
    resolved(What0, Above0, What, Above),
    (   Node = node(leaf,Here)
    ->  Nodes = Nodes0,
        (   Here =:= Place
        ->  Found = Above
        ;   true
        )
    ;   Node = node(Operation,Count),
        operands(What, Operation, Count, N, Whats),
        ways(Whats, 1, step(Count,Operation,N), Nodes0, Nodes, Above, Place,
             Found)
    ).

ways([], _, _, Nodes, Nodes, _, _, _).
ways([What|Whats], I, Step, Nodes0, Nodes, Above, Place, Found) :-
    Step = step(Count,Operation,N),
    way(Nodes0, Nodes1, What, [operand(I,Count,Operation,N)|Above], Place,
        Found),
    J is I+1,
    ways(Whats, J, Step, Nodes1, Nodes, Above, Place, Found).

%   resolved(What0, Above0, What, Above): behind placements.

resolved(What0, Above0, What, Above) :-
    (   what_term(What0, Term),
        is_node_term(Term),
        node_parts(Term, same, [Operand], _)
    ->  (   integer(What0)
        ->  Above1 = [placed(What0)|Above0]
        ;   Above1 = Above0
        ),
        resolved(Operand, Above1, What, Above)
    ;   What = What0,
        Above = Above0
    ).

what_term(S, Term) :-
    integer(S),
    !,
    segment(S, _, Term).
what_term(Term, Term).

%   operands(What, Operation, Count, N, Whats): as far as What has them.

operands(What, Operation, Count, N, Whats) :-
    (   what_term(What, Term),
        is_node_term(Term),
        node_parts(Term, Kind, Operands, _),
        shown_as(Kind, Operands, Operation, Whats0),
        length(Whats0, Count)
    ->  Whats = Whats0,
        (   integer(What)
        ->  N = What
        ;   N = 0
        )
    ;   N = 0,
        findall(unknown, between(1, Count, _), Whats)
    ).

shown_as(split(Plane,_), [Operand], intersection, [Operand,Plane]).
shown_as(split(inside), Operands, intersection, Operands).
shown_as(split(outside), Operands, difference, Operands).
shown_as(join, Operands, union, Operands).
shown_as(Operation, Operands, Operation, Operands).

%!  takes_away(+Step) is semidet.
%
%   True of a step of tree_way/3 from an operand that is taken away.

takes_away(operand(I,_,difference,_)) :-
    I > 1.

%!  false_reason(+Scene, +R, +In, -Reason) is det.
%
%   Reason is `true` if the tree of root R holds inside the leaves whose places
%   are In. Else it says why it does not: `cut`, by a plane;
%   taken_away(N, J, Operation), operand J of the node that is segment N, or 0,
%   of what is there otherwise; outside_all(N, Operation, Count), the line is in
%   no operand of it; or outside(Place), in no leaf Place.

false_reason(Scene, R, In, Reason) :-
    root_tree(Scene, R, Nodes, Sections),
    reason(Nodes, _, R, In, Reason0),
    (   Reason0 == true,
        member(Place, Sections),
        \+ memberchk(Place, In)
    ->  Reason = cut
    ;   Reason = Reason0
    ).

reason([Node|Nodes0], Nodes, What0, In, Reason) :-
    resolved(What0, [], What, _),
    (   Node = node(leaf,Place)
    ->  Nodes = Nodes0,
        (   memberchk(Place, In)
        ->  Reason = true
        ;   Reason = outside(Place)
        )
    ;   Node = node(Operation,Count),
        operands(What, Operation, Count, N, Whats),
        reasons(Whats, Nodes0, Nodes, In, Reasons),
        node_reason(Operation, Reasons, N, Reason)
    ).

reasons([], Nodes, Nodes, _, []).
reasons([What|Whats], Nodes0, Nodes, In, [Reason|Reasons]) :-
    reason(Nodes0, Nodes1, What, In, Reason),
    reasons(Whats, Nodes1, Nodes, In, Reasons).

node_reason(union, [], _, cut) :-       % nothing of it is on that side
    !.
node_reason(union, Reasons, N, Reason) :-
    (   memberchk(true, Reasons)
    ->  Reason = true
    ;   Reasons = [Only]
    ->  Reason = Only
    ;   Taken = taken_away(_,_,_),
        memberchk(Taken, Reasons)
    ->  Reason = Taken
    ;   length(Reasons, Count),
        Reason = outside_all(N,union,Count)
    ).
node_reason(intersection, Reasons, _, Reason) :-
    first_false(Reasons, Reason).
node_reason(difference, [First|Others], N, Reason) :-
    (   First \== true
    ->  Reason = First
    ;   true_operand(Others, 2, J)
    ->  Reason = taken_away(N,J,difference)
    ;   Reason = true
    ).

first_false([], true).
first_false([Reason0|Reasons], Reason) :-
    (   Reason0 == true
    ->  first_false(Reasons, Reason)
    ;   Reason = Reason0
    ).

true_operand([Reason|Reasons], I, J) :-
    (   Reason == true
    ->  J = I
    ;   I1 is I+1,
        true_operand(Reasons, I1, J)
    ).
