:- module(sg_box_tree,
          [ box_tree/2,                 % +Items, -Tree
            tree_pairs/2,               % +Tree, -Pairs
            tree_fold/5,                % +Tree, :Skips, :Takes, +V0, -V
            points_box/2,               % +Points, -Box
            boxes_meet/2                % +Box1, +Box2
          ]).
:- use_module(library(apply), [foldl/4]).
:- use_module(library(lists), [append/3]).
/** <module> Trees of boxes of the plane.

A box is b(X1, Y1, X2, Y2) of floats, closed; an item is Box-Thing. A tree is
none, few(Box, Items), or both(Box, Tree, Tree): the box is round all below it,
and items are parted by their middles across the longer side of that. So what
is asked of n items in many places looks at about log n of them.
*/

:- meta_predicate tree_fold(+, 2, 3, +, -).

few_items(4).

%!  box_tree(+Items, -Tree) is det.
%
%   Cost: n log(n)**2.

box_tree([], none) :-
    !.
box_tree(Items, Tree) :-
    length(Items, N),
    grown(N, Items, Tree).

grown(N, Items, Tree) :-
    Items = [Box0-_|Rest],
    foldl(round_both, Rest, Box0, Box),
    few_items(Few),
    (   N =< Few
    ->  Tree = few(Box, Items)
    ;   Tree = both(Box, Left, Right),
        Box = b(X1, Y1, X2, Y2),
        (   X2/2-X1/2 >= Y2/2-Y1/2
        ->  Axis = 0
        ;   Axis = 1
        ),
        middles(Items, Axis, Keyed0),
        keysort(Keyed0, Keyed),
        Half is N//2,
        length(Lows, Half),
        append(Lows, Highs, Keyed),
        values(Lows, LeftItems),
        values(Highs, RightItems),
        OtherHalf is N-Half,
        grown(Half, LeftItems, Left),
        grown(OtherHalf, RightItems, Right)
    ).

round_both(b(X1, Y1, X2, Y2)-_, b(X3, Y3, X4, Y4), b(X5, Y5, X6, Y6)) :-
    X5 is min(X1, X3),
    Y5 is min(Y1, Y3),
    X6 is max(X2, X4),
    Y6 is max(Y2, Y4).

middles([], _, []).
middles([Item|Items], Axis, [Middle-Item|Keyed]) :-
    Item = b(X1, Y1, X2, Y2)-_,
    (   Axis =:= 0
    ->  Middle is X1/2+X2/2
    ;   Middle is Y1/2+Y2/2
    ),
    middles(Items, Axis, Keyed).

values([], []).
values([_-Value|Keyed], [Value|Values]) :-
    values(Keyed, Values).

%!  tree_pairs(+Tree, -Pairs) is det.
%
%   Pairs are Thing1-Thing2 for each two items whose boxes have a point in
%   common, each two once.

tree_pairs(Tree, Pairs) :-
    phrase(pairs_in(Tree), Pairs).

pairs_in(none) -->
    [].
pairs_in(few(_, Items)) -->
    pairs_among(Items).
pairs_in(both(_, Left, Right)) -->
    pairs_in(Left),
    pairs_in(Right),
    pairs_between(Left, Right).

pairs_among([]) -->
    [].
pairs_among([Item|Items]) -->
    pairs_with(Items, Item),
    pairs_among(Items).

pairs_with([], _) -->
    [].
pairs_with([Box2-Thing2|Items], Item) -->
    { Item = Box1-Thing1 },
    (   { boxes_meet(Box1, Box2) }
    ->  [Thing1-Thing2]
    ;   []
    ),
    pairs_with(Items, Item).

pairs_between(Tree1, Tree2) -->
    { arg(1, Tree1, Box1),
      arg(1, Tree2, Box2),
      boxes_meet(Box1, Box2)
    },
    !,
    pairs_below(Tree1, Tree2).
pairs_between(_, _) -->
    [].

pairs_below(both(_, Left, Right), Tree) -->
    pairs_between(Tree, Left),
    pairs_between(Tree, Right).
pairs_below(few(Box, Items), Tree) -->
    pairs_few(Tree, few(Box, Items)).

pairs_few(few(_, Items1), few(_, Items2)) -->
    pairs_across(Items1, Items2).
pairs_few(both(_, Left, Right), Few) -->
    pairs_between(Left, Few),
    pairs_between(Right, Few).

pairs_across([], _) -->
    [].
pairs_across([Item|Items1], Items2) -->
    pairs_with(Items2, Item),
    pairs_across(Items1, Items2).

%!  tree_fold(+Tree, :Skips, :Takes, +V0, -V) is det.
%
%   V0 becomes V by call(Takes, Thing, V1, V2) of one thing after another, those
%   left out for which call(Skips, Box, V1) is true of their box or of one round
%   it.

tree_fold(none, _, _, V, V).
tree_fold(few(Box, Items), Skips, Takes, V0, V) :-
    (   call(Skips, Box, V0)
    ->  V = V0
    ;   foldl(item_taken(Skips, Takes), Items, V0, V)
    ).
tree_fold(both(Box, Left, Right), Skips, Takes, V0, V) :-
    (   call(Skips, Box, V0)
    ->  V = V0
    ;   tree_fold(Right, Skips, Takes, V0, V1),
        tree_fold(Left, Skips, Takes, V1, V)
    ).

:- meta_predicate item_taken(2, 3, +, +, -).

item_taken(Skips, Takes, Box-Thing, V0, V) :-
    (   call(Skips, Box, V0)
    ->  V = V0
    ;   call(Takes, Thing, V0, V)
    ).

%!  points_box(+Points, -Box) is det.
%
%   Box is round Points, p(X, Y) of rationals: let out, since it has floats.

points_box([Point|Points], b(X1, Y1, X2, Y2)) :-
    Point = p(X, Y),
    foldl(round_point, Points, r(X, Y, X, Y), r(X3, Y3, X4, Y4)),
    X1 is nexttoward(float(X3), -1.797e308),
    Y1 is nexttoward(float(Y3), -1.797e308),
    X2 is nexttoward(float(X4), 1.797e308),
    Y2 is nexttoward(float(Y4), 1.797e308).

round_point(p(X, Y), r(X1, Y1, X2, Y2), r(X3, Y3, X4, Y4)) :-
    X3 is min(X, X1),
    Y3 is min(Y, Y1),
    X4 is max(X, X2),
    Y4 is max(Y, Y2).

%!  boxes_meet(+Box1, +Box2) is semidet.
%
%   They have a point in common.

boxes_meet(b(X1, Y1, X2, Y2), b(X3, Y3, X4, Y4)) :-
    X1 =< X4,
    X3 =< X2,
    Y1 =< Y4,
    Y3 =< Y2.
