:- module(test_box_tree, []).
:- use_module(library(plunit)).
:- use_module(library(random)).
:- use_module(rules(polygon/box_tree)).

%   Boxes on a grid of Most places; some are equal, some points.

random_items(N, Most, Items) :-
    findall(b(X1, Y1, X2, Y2)-I,
            ( between(1, N, I),
              random(0, Most, A),
              random(0, Most, B),
              random(0, 3, W),
              random(0, 3, H),
              X1 is float(A), Y1 is float(B),
              X2 is X1+W, Y2 is Y1+H ),
            Items).

meeting_pairs(Items, Pairs) :-
    findall(I-J,
            ( member(Box1-I, Items), member(Box2-J, Items), I < J,
              boxes_meet(Box1, Box2) ),
            Pairs).

in_order(I-J, Low-High) :-
    Low is min(I, J),
    High is max(I, J).

outside(X-Y, b(X1, Y1, X2, Y2), _) :-
    \+ ( X1 =< X, X =< X2, Y1 =< Y, Y =< Y2 ).

noted(I, Is, [I|Is]).

:- begin_tests(box_tree).

test(each_pair_once, [forall(member(N, [0,1,2,4,5,9,30,100,200]))]) :-
    set_random(seed(N)),
    Most is 2+N//3,
    random_items(N, Most, Items),
    box_tree(Items, Tree),
    tree_pairs(Tree, Pairs0),
    maplist(in_order, Pairs0, Pairs1),
    msort(Pairs1, Pairs),
    meeting_pairs(Items, Wanted),
    assertion(Pairs == Wanted).
test(each_thing_that_is_not_left_out, [forall(member(N, [0,1,5,40,150]))]) :-
    set_random(seed(N)),
    random_items(N, 12, Items),
    box_tree(Items, Tree),
    forall(( between(0, 14, X), between(0, 14, Y) ),
           ( tree_fold(Tree, outside(X-Y), noted, [], Is0),
             msort(Is0, Is),
             findall(I, ( member(Box-I, Items), \+ outside(X-Y, Box, _) ),
                     Wanted),
             assertion(Is == Wanted) )).
test(points_are_in_their_box) :-
    Points = [p(1r3, -2r7), p(2r3, 5), p(1r2, 1r10**300)],
    points_box(Points, b(X1, Y1, X2, Y2)),
    forall(member(p(X, Y), Points),
           ( rational(X1) < X, X < rational(X2),
             rational(Y1) < Y, Y < rational(Y2) )).

:- end_tests(box_tree).
