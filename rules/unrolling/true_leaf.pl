:- module(sg_true_leaf,
          [ composed_leaves/2,          % +S, -Leaves
            plate_leaves/2,             % +Expression, -Leaves
            large_enough/3,             % +S, +By, +Plates
            leaves_replaced/3,          % +Made, +Expression0, -Expression
            composed_tolerance/2,       % +Expression, -Options
            composed_known/4            % +S, +S1, -P1, -P
          ]).
:- use_module('../csg/csg', [is_node/1]).
:- use_module('../csg/csg_rows', [segment_box/2]).
:- use_module('../csg/placed_surface',
              [drawn_polygon/4, placed_polygon/4, placed_term/2]).
:- use_module('../kernel', [segments_tolerance/3]).
:- use_module('../solid/csg_flat',
              [flat_expression/2, flat_leaves/2, is_half/1]).
:- use_module('../store', [origin/3]).
:- use_module(library(apply), [maplist/3, partition/4]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [member/2]).
/** <module> The leaves of a CSG tree whose result is made of plate.

The faces of a leaf that is united or intersected are plate, and lie where the
plate touches (true_parts.pl). What only takes away, a plane that splits or what
is subtracted, is a tool: it cuts where it is drawn, in whatever layer.
*/

%!  composed_leaves(+S, -Leaves) is semidet.
%
%   S is the result of a CSG tree, and Leaves are those of its leaves whose
%   faces are faces of S and so plate; others only take away.

composed_leaves(S, Leaves) :-
    is_node(S),
    \+ placed_term(S, _),
    flat_expression(S, Expression),
    plate_leaves(Expression, Leaves).

%!  plate_leaves(+Expression, -Leaves) is det.
%
%   Leaves are those of Expression, of flat_expression/2, whose faces are plate.

plate_leaves(Expression, Leaves) :-
    findall(Leaf, plate_leaf(Expression, Leaf), Leaves0),
    sort(Leaves0, Leaves).

plate_leaf(Leaf0, Leaf) :-
    integer(Leaf0),
    !,
    \+ is_half(Leaf0),
    Leaf = Leaf0.
plate_leaf(difference([Expression|_]), Leaf) :-
    !,
    plate_leaf(Expression, Leaf).
plate_leaf(Expression, Leaf) :-
    arg(1, Expression, Expressions),
    member(Expression1, Expressions),
    plate_leaf(Expression1, Leaf).

%!  large_enough(+S, +By, +Plates) is det.
%
%   Half-spaces are made a twentieth larger than what they cut
%   (csg_half_space.pl); so the leaves Plates of S may grow by By.
%
%   @error geometry_error(true(no_offset(S)))

large_enough(S, By, Plates) :-
    findall(Box, ( member(Leaf, Plates), segment_box(Leaf, Box) ), Boxes),
    (   By =< 0
    ->  true
    ;   forall(member(box(X1,Y1,Z1,X2,Y2,Z2), Boxes),
               By < 0.02*sqrt((X2-X1)**2 + (Y2-Y1)**2 + (Z2-Z1)**2))
    ->  true
    ;   throw(error(geometry_error(true(no_offset(S))), _))
    ).

%!  composed_tolerance(+Expression, -Options) is det.
%
%   Options are those of boolean/3: a half-space says nothing about the size of
%   the model.

composed_tolerance(Expression, Options) :-
    flat_leaves(Expression, Leaves),
    partition(is_half, Leaves, Halves, Own),
    (   Halves == []
    ->  Options = []
    ;   segments_tolerance(Own, Reach, _),
        Options = [tolerance(own(Reach))]
    ).

%!  leaves_replaced(+Made, +Expression0, -Expression) is det.
%
%   Expression has Leaf1 for each Leaf, Made a list of Leaf-Leaf1.

leaves_replaced(Made, Leaf, Leaf1) :-
    integer(Leaf),
    !,
    memberchk(Leaf-Leaf1, Made).
leaves_replaced(Made, Expression0, Expression) :-
    Expression0 =.. [Operation,Expressions0],
    maplist(leaves_replaced(Made), Expressions0, Expressions),
    Expression =.. [Operation,Expressions].

%!  composed_known(+S, +S1, -P1, -P) is nondet.
%
%   Polygon P1 of S1, which is S of leaves made again, and P of S are of one
%   polygon of a leaf.

composed_known(S, S1, P1, P) :-
    findall(Leaf-P0-P2, placed_polygon(S, P2, Leaf, P0), Pairs0),
    sort(1, @<, Pairs0, Pairs),
    list_to_assoc(Pairs, Drawn),
    findall(P1-P2,
            ( placed_polygon(S1, P1, Leaf1, PL),
              leaf_drawn(Leaf1, PL, Leaf, P0),
              get_assoc(Leaf-P0, Drawn, P2) ),
            Known0),
    sort(1, @<, Known0, Known),
    member(P1-P, Known).

leaf_drawn(Leaf1, P1, Leaf, P) :-
    (   origin(Leaf1, node(Leaf1), plate(_))
    ->  once(drawn_polygon(Leaf1, P1, Leaf, P))
    ;   Leaf-P = Leaf1-P1
    ).
