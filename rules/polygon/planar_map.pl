:- module(sg_planar_map,
          [ planar_map/2,               % +Figures, -Map
            map_border/3,               % +Map, :Inside, -Cycles
            map_point/3                 % +Map, +V, -Point
          ]).
:- use_module(box_tree,
              [box_tree/2, points_box/2, tree_fold/5, tree_pairs/2]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [append/3, last/2, member/2, nth0/3]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
:- use_module(library(sort), [predsort/3]).
/** <module> The planar map of figures: what the plane is divided into.

A figure is a list of loops, a loop a list of X-Y of floats that closes itself.
The inside of a figure is what its loops go round oddly often, so they may cross
each other and themselves. All edges of all figures divide each other; the map
has their points, the pieces between them, and on either side of each piece the
figures that are there: a set of bits, bit I for the I-th figure, from 0.

Everything is exact (rationals). This is arranging once and selecting many, as
solids have it, in the plane: map_border/3 selects.

A map is map(Points, Ends, Clockwise, Sides): the points p(X, Y) in
lexicographic order; of half-edge H where it ends, the next half-edge clockwise
round where it starts, and the figures at its left. Piece K is the half-edges
2*K-1, upwards in the order of points, and 2*K.
*/

:- meta_predicate map_border(+, 1, -).

%!  planar_map(+Figures, -Map) is det.

planar_map(Figures, map(Points, Ends, Clockwise, Sides)) :-
    figure_edges(Figures, Edges),
    cut_edges(Edges, Cuts),
    pieces(Edges, Cuts, Pieces0),
    point_numbers(Pieces0, Points, Pieces),
    piece_ends(Pieces, Ends),
    clockwise(Points, Ends, Outgoing, Clockwise),
    sides(Points, Pieces, Ends, Clockwise, Outgoing, Sides).

%!  map_point(+Map, +V, -Point) is det.
%
%   Point = p(X, Y), of rationals, is the V-th point of Map.

map_point(map(Points, _, _, _), V, Point) :-
    arg(V, Points, Point).

array(Name, List, Array) :-
    compound_name_arguments(Array, Name, List).


                /*******************************
                *             CUTS             *
                *******************************/

%   figure_edges(Figures, Edges): edge(Box, A, B, Figure), Box of floats; A and
%   B are points of rationals.

figure_edges(Figures, Edges) :-
    findall(edge(b(Left, Low, Right, High), A, B, N),
            ( nth0(N, Figures, Loops),
              member(Loop, Loops),
              loop_step(Loop, X1-Y1, X2-Y2),
              rational_point(X1, Y1, A),
              rational_point(X2, Y2, B),
              A \== B,
              Left is float(min(X1, X2)),
              Low is float(min(Y1, Y2)),
              Right is float(max(X1, X2)),
              High is float(max(Y1, Y2)) ),
            Edges).

rational_point(X0, Y0, p(X, Y)) :-
    X is rational(X0),
    Y is rational(Y0).

loop_step(Loop, P, Q) :-
    last(Loop, Last),
    append(_, [P, Q|_], [Last|Loop]).

%   cut_edges(Edges, Cuts): Cuts are N-Point, Point on the N-th edge.

cut_edges(Edges, Cuts) :-
    numbered(Edges, 1, Numbered),
    box_tree(Numbered, Tree),
    tree_pairs(Tree, Pairs),
    phrase(meetings(Pairs), Cuts).

numbered([], _, []).
numbered([Edge|Edges], N, [Box-e(N, Edge)|Numbered]) :-
    arg(1, Edge, Box),
    N1 is N+1,
    numbered(Edges, N1, Numbered).

meetings([]) -->
    [].
meetings([Edge1-Edge2|Pairs]) -->
    meeting(Edge1, Edge2),
    meetings(Pairs).

meeting(e(N, edge(_, A, B, _)), e(M, edge(_, C, D, _))) -->
    { side(A, B, C, S1),
      side(A, B, D, S2),
      S1*S2 =< 0,
      side(C, D, A, S3),
      side(C, D, B, S4),
      S3*S4 =< 0
    },
    !,
    (   { S1*S2*S3*S4 =\= 0 }
    ->  { crossing(A, B, C, D, P) },
        [N-P, M-P]
    ;   end_cut(S1, N, C, A, B),
        end_cut(S2, N, D, A, B),
        end_cut(S3, M, A, C, D),
        end_cut(S4, M, B, C, D)
    ).
meeting(_, _) -->
    [].

%   side(A, B, C, Sign): 1 when C is left of the line from A to B.

side(p(X1, Y1), p(X2, Y2), p(X3, Y3), Sign) :-
    Sign is sign((X2-X1)*(Y3-Y1) - (Y2-Y1)*(X3-X1)).

%   end_cut(Side, N, Point, A, B)//: Point cuts edge N from A to B, if it is on
%   it: on its line, and between its ends.

end_cut(0, N, P, A, B) -->
    { P \== A,
      P \== B,
      between_ends(P, A, B)
    },
    !,
    [N-P].
end_cut(_, _, _, _, _) -->
    [].

between_ends(P, A, B) :-
    (   A @< B
    ->  A @< P,
        P @< B
    ;   B @< P,
        P @< A
    ).

crossing(p(X1, Y1), p(X2, Y2), p(X3, Y3), p(X4, Y4), p(X, Y)) :-
    DX is X2-X1,
    DY is Y2-Y1,
    EX is X4-X3,
    EY is Y4-Y3,
    T is ((X3-X1)*EY - (Y3-Y1)*EX) rdiv (DX*EY - DY*EX),
    X is X1 + T*DX,
    Y is Y1 + T*DY.


                /*******************************
                *            PIECES            *
                *******************************/

%   pieces(Edges, Cuts, Pieces): (P-Q)-Figures, P @< Q, each once; what a figure
%   has twice it has not at all.

pieces(Edges, Cuts, Pieces) :-
    keysort(Cuts, Sorted),
    group_pairs_by_key(Sorted, Groups),
    phrase(edge_pieces(Edges, 1, Groups), Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Grouped),
    phrase(odd_pieces(Grouped), Pieces).

edge_pieces([], _, _) -->
    [].
edge_pieces([edge(_, A, B, Figure)|Edges], N, Groups0) -->
    { (   Groups0 = [N-Points0|Groups]
      ->  sort([A, B|Points0], Points)
      ;   Groups = Groups0,
          sort([A, B], Points)
      ),
      N1 is N+1
    },
    steps(Points, Figure),
    edge_pieces(Edges, N1, Groups).

steps([P, Q|Points], Figure) -->
    !,
    [(P-Q)-Figure],
    steps([Q|Points], Figure).
steps(_, _) -->
    [].

odd_pieces([]) -->
    [].
odd_pieces([Piece-Figures0|Groups]) -->
    { msort(Figures0, Figures1),
      odd_ones(Figures1, Figures)
    },
    (   { Figures == [] }
    ->  []
    ;   [Piece-Figures]
    ),
    odd_pieces(Groups).

odd_ones([N, N|Figures], Odd) :-
    !,
    odd_ones(Figures, Odd).
odd_ones([N|Figures], [N|Odd]) :-
    !,
    odd_ones(Figures, Odd).
odd_ones([], []).

%   point_numbers(Pieces0, Points, Pieces): Pieces are piece(U, V, Figures).

point_numbers(Pieces0, Array, Pieces) :-
    findall(P, ( member((A-B)-_, Pieces0), member(P, [A, B]) ), Points0),
    sort(Points0, Points),
    array(points, Points, Array),
    findall(P-V, arg(V, Array, P), Pairs),
    list_to_assoc(Pairs, Numbers),
    maplist(piece_numbered(Numbers), Pieces0, Pieces).

piece_numbered(Numbers, (P-Q)-Figures, piece(U, V, Figures)) :-
    get_assoc(P, Numbers, U),
    get_assoc(Q, Numbers, V).

piece_ends(Pieces, Ends) :-
    findall(End, ( member(piece(U, V, _), Pieces), member(End, [V, U]) ),
            List),
    array(ends, List, Ends).

twin(H, Twin) :-
    Twin is ((H-1) xor 1) + 1.


                /*******************************
                *         ROUND A POINT        *
                *******************************/

%   clockwise(Points, Ends, Outgoing, Clockwise): Outgoing are V-Hs, the
%   half-edges from V counter-clockwise, beginning behind the ray downwards.

clockwise(Points, Ends, Outgoing, Clockwise) :-
    compound_name_arity(Ends, _, Count),
    findall(V-H, ( between(1, Count, H), twin(H, Twin), arg(Twin, Ends, V) ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    maplist(ordered_round(Points, Ends), Groups, Outgoing),
    compound_name_arity(Clockwise, clockwise, Count),
    forall_linked(Outgoing, Clockwise).

ordered_round(Points, Ends, V-Hs0, V-Hs) :-
    arg(V, Points, p(X0, Y0)),
    findall(Half-d(X, Y, H),
            ( member(H, Hs0),
              arg(H, Ends, W),
              arg(W, Points, p(X1, Y1)),
              X is X1-X0,
              Y is Y1-Y0,
              (   W > V
              ->  Half = 0
              ;   Half = 1
              ) ),
            Directions0),
    predsort(turning_left, Directions0, Directions),
    findall(H, member(_-d(_, _, H), Directions), Hs).

%   Pieces do not overlap, so no two directions are equal.

turning_left(Order, Half1-d(X1, Y1, _), Half2-d(X2, Y2, _)) :-
    (   Half1 =\= Half2
    ->  compare(Order, Half1, Half2)
    ;   Cross is X1*Y2 - X2*Y1,
        compare(Order, 0, Cross)
    ).

forall_linked([], _).
forall_linked([_-Hs|Outgoing], Clockwise) :-
    last(Hs, Last),
    linked(Hs, Last, Clockwise),
    forall_linked(Outgoing, Clockwise).

linked([], _, _).
linked([H|Hs], Before, Clockwise) :-
    arg(H, Clockwise, Before),
    linked(Hs, H, Clockwise).


                /*******************************
                *             SIDES            *
                *******************************/

%   sides(Points, Pieces, Ends, Clockwise, Outgoing, Sides): figures change
%   across a piece by its own. The least point of each connected part asks what
%   is above the next piece below it: that is of a part with a lesser point,
%   which knows.

sides(Points, Pieces, Ends, Clockwise, Outgoing, Sides) :-
    compound_name_arity(Ends, _, Count),
    compound_name_arity(Sides, sides, Count),
    findall(Figures, member(piece(_, _, Figures), Pieces), List),
    array(figures, List, Figures),
    Map = m(Figures, Clockwise, Sides),
    parts(Outgoing, below(Points, Pieces, _), Map).

%   below(Points, Pieces, Tree): Tree is a variable until somebody asks.

parts([], _, _).
parts([V-Hs|Outgoing], Below, Map) :-
    arg(3, Map, Sides),
    last(Hs, H),
    arg(H, Sides, Side),
    (   nonvar(Side)
    ->  true
    ;   next_below(V, Below, Next),
        (   Next = next(K, _, _, _)
        ->  Upper is 2*K-1,
            arg(Upper, Sides, Side0)
        ;   Side0 = 0
        ),
        flooded([H-Side0], Map)
    ),
    parts(Outgoing, Below, Map).

%   next_below(V, Below, Next): Next is what not_next/3 says, of piece K next
%   below point V, or none. V is on no piece that it does not end.

next_below(1, _, none) :-
    !.
next_below(V, below(Points, Pieces, Tree), Next) :-
    (   var(Tree)
    ->  piece_boxes(Pieces, 1, Points, Items),
        box_tree(Items, Tree)
    ;   true
    ),
    arg(V, Points, Point),
    points_box([Point], Box),
    tree_fold(Tree, not_next(Box), nearer(Point), none, Next).

%   piece_boxes(Pieces, K, Points, Items): of those that are not vertical.

piece_boxes([], _, _, []).
piece_boxes([piece(U, V, _)|Pieces], K, Points, Items) :-
    arg(U, Points, A),
    arg(V, Points, B),
    (   arg(1, A, X1),
        arg(1, B, X2),
        X1 < X2
    ->  points_box([A,B], Box),
        Items = [Box-k(K, A, B)|Items1]
    ;   Items = Items1
    ),
    K1 is K+1,
    piece_boxes(Pieces, K1, Points, Items1).

%   not_next(Point, Box, Next): what is in Box has no place below Point, a box,
%   or is below Next, next(K, Low, Height, Slope): piece K with its height
%   there, which is above Low, a float.

not_next(b(X1, _, X2, Y2), b(X3, Y3, X4, Y4), Next) :-
    (   X1 > X4
    ->  true
    ;   X3 > X2
    ->  true
    ;   Y3 > Y2
    ->  true
    ;   Next = next(_, Low, _, _),
        Y4 < Low
    ).

%   nearer(Point, Piece, Next0, Next): just right of Point, if not there.

nearer(p(X, Y), k(K, p(X1, Y1), p(X2, Y2)), Next0, Next) :-
    (   X1 =< X,
        X < X2,
        Slope is (Y2-Y1) rdiv (X2-X1),
        Height is Y1 + (X-X1)*Slope,
        Height < Y,
        is_higher(Next0, Height, Slope)
    ->  Low is nexttoward(float(Height), -1.797e308),
        Next = next(K, Low, Height, Slope)
    ;   Next = Next0
    ).

is_higher(none, _, _).
is_higher(next(_, _, Height0, Slope0), Height, Slope) :-
    (   Height =:= Height0
    ->  Slope > Slope0
    ;   Height > Height0
    ).

flooded([], _).
flooded([H-Side|Queue0], Map) :-
    arg(3, Map, Sides),
    arg(H, Sides, Known),
    (   nonvar(Known)
    ->  Queue = Queue0
    ;   round_face(H, Side, Map, Queue0, Queue)
    ),
    flooded(Queue, Map).

%   round_face(H, Side, Map, Queue0, Queue): the half-edges round the face left
%   of H get Side, their twins are queued.

round_face(H, Side, Map, Queue0, Queue) :-
    Map = m(Figures, Clockwise, Sides),
    arg(H, Sides, Known),
    (   nonvar(Known)
    ->  Queue = Queue0
    ;   Known = Side,
        twin(H, Twin),
        K is (H+1)//2,
        arg(K, Figures, Change),
        foldl(toggled, Change, Side, Other),
        arg(Twin, Clockwise, Next),
        round_face(Next, Side, Map, [Twin-Other|Queue0], Queue)
    ).


toggled(N, Bits0, Bits) :-
    Bits is Bits0 xor (1<<N).


                /*******************************
                *            BORDERS           *
                *******************************/

%!  map_border(+Map, :Inside, -Cycles) is det.
%
%   Cycles are the lists of points (numbers) round what is inside, which is at
%   their left: faces of Map for whose figures call(Inside, Bits) is true. A
%   cycle does not cross itself or another one; it may touch.

map_border(map(_, Ends, Clockwise, Sides), Inside, Cycles) :-
    compound_name_arity(Ends, _, Count),
    compound_name_arity(Kept, kept, Count),
    compound_name_arguments(Sides, _, List),
    sort(List, Different),
    findall(Bits-in, ( member(Bits, Different), call(Inside, Bits) ), Pairs),
    list_to_assoc(Pairs, Ins),
    forall_kept(Count, Sides, Ins, Kept),
    cycles(1, Count, map(Ends, Clockwise, Kept), Cycles).

%   Kept has 1 for a half-edge of the border, 0 for another, and 2 behind it.

forall_kept(0, _, _, _) :-
    !.
forall_kept(H, Sides, Ins, Kept) :-
    twin(H, Twin),
    arg(H, Sides, Left),
    arg(Twin, Sides, Right),
    arg(H, Kept, k(Mark)),
    (   get_assoc(Left, Ins, _),
        \+ get_assoc(Right, Ins, _)
    ->  Mark = 1
    ;   Mark = 0
    ),
    H1 is H-1,
    forall_kept(H1, Sides, Ins, Kept).

cycles(H, Count, _, []) :-
    H > Count,
    !.
cycles(H, Count, Map, Cycles) :-
    arg(3, Map, Kept),
    arg(H, Kept, K),
    (   K == k(1)
    ->  cycle(H, Map, Cycle),
        Cycles = [Cycle|Cycles1]
    ;   Cycles = Cycles1
    ),
    H1 is H+1,
    cycles(H1, Count, Map, Cycles1).

cycle(H, Map, [V|Vs]) :-
    Map = map(Ends, Clockwise, Kept),
    arg(H, Kept, K),
    setarg(1, K, 2),
    arg(H, Ends, V),
    twin(H, Twin),
    next_kept(Twin, Clockwise, Kept, Next),
    arg(Next, Kept, k(Mark)),
    (   Mark =:= 2
    ->  Vs = []
    ;   cycle(Next, Map, Vs)
    ).

next_kept(H, Clockwise, Kept, Next) :-
    arg(H, Clockwise, H1),
    arg(H1, Kept, k(Mark)),
    (   Mark =\= 0
    ->  Next = H1
    ;   next_kept(H1, Clockwise, Kept, Next)
    ).
