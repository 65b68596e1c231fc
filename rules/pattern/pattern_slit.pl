:- module(sg_pattern_slit,
          [ opened_slits/3              % +Pieces, +Butt, -Opened
          ]).
:- use_module(pattern_split, [parted_piece/3]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(assoc),
              [ empty_assoc/1, get_assoc/3, list_to_assoc/2, put_assoc/4 ]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Slits too narrow for a tab, opened: the piece is parted at folds.

The two sides of a slit are connected by folds, from face to face. Where one of
these folds is cut, the slit is the gap between two pieces, and has room for
tabs. That fold is taken first which opens the most slits; of several the
shortest, as it is a seam from now on.
*/

:- set_prolog_flag(optimise, true).

%!  opened_slits(+Pieces, +Butt, -Opened) is det.
%
%   Opened are Pieces (pattern_piece.pl), in their order, in place of each its
%   parts: those seams of Butt, an assoc with keys D-J, whose sides are both in
%   one piece are between two.

opened_slits(Pieces, Butt, Opened) :-
    foldl(piece_opened(Butt), Pieces, Opened, []).

piece_opened(Butt, Piece, Opened0, Opened) :-
    Piece = piece(name(D,_,_), _, Sides),
    fold_steps(Sides, Steps),
    findall(P1-P2, slit(D, Sides, Butt, P1, P2), Slits),
    sort(Slits, Pairs),
    (   Pairs == []
    ->  Opened0 = [Piece|Opened]
    ;   fold_tree(Sides, Steps, Tree),
        maplist(slit_folds(Tree), Pairs, Ways),
        folds_to_cut(Ways, Folds),
        parted_piece(Piece, Folds, Parts),
        append(Parts, Opened, Opened0)
    ).

%   The faces on the two sides of a seam without a tab.

slit(D, Sides, Butt, P1, P2) :-
    findall(J-P,
            ( member(side(_,P,_,_,seam(J,_,_)), Sides),
              get_assoc(D-J, Butt, _)
            ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    member(_-[P1,P2], Groups).

%   fold_steps(Sides, Steps): an assoc from each face to step(Next,fold(Size,J))
%   over each of its folds, the longest first; Size grows with the length.

fold_steps(Sides, Steps) :-
    findall(J-(P-Size),
            ( member(side(_,P,_-(XA-YA),_-(XB-YB),fold(J,_,_)), Sides),
              Size is round(1000*sqrt((XB-XA)**2 + (YB-YA)**2))
            ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Folds),
    findall(P-(Less-step(Q,fold(Size,J))),
            ( member(J-[A-Size,B-_], Folds),
              ( P-Q = A-B ; P-Q = B-A ),
              Less is -Size
            ),
            Steps0),
    sort(0, @=<, Steps0, Steps1),
    group_pairs_by_key(Steps1, Steps2),
    list_to_assoc(Steps2, Steps).

%   fold_tree(Sides, Steps, Tree): an assoc from each face to
%   way(Depth,Up,Fold): by which fold it hangs on which face.

fold_tree(Sides, Steps, Tree) :-
    findall(P, member(side(_,P,_,_,_), Sides), Ps0),
    sort(Ps0, Ps),
    empty_assoc(Tree0),
    foldl(tree_from(Steps), Ps, Tree0, Tree).

tree_from(Steps, P, Tree0, Tree) :-
    (   get_assoc(P, Tree0, _)
    ->  Tree = Tree0
    ;   put_assoc(P, Tree0, way(0,none,none), Tree1),
        tree_grown([P-0], Steps, Tree1, Tree)
    ).

%   Level by level, so that ways are short.

tree_grown([], _, Tree, Tree) :-
    !.
tree_grown(Level, Steps, Tree0, Tree) :-
    foldl(tree_step(Steps), Level, Tree0-Next0, Tree1-[]),
    tree_grown(Next0, Steps, Tree1, Tree).

tree_step(Steps, P-Depth, Tree0-Next0, Tree-Next) :-
    (   get_assoc(P, Steps, Own)
    ->  Deeper is Depth+1,
        foldl(tree_face(P, Deeper), Own, Tree0-Next0, Tree-Next)
    ;   Tree = Tree0,
        Next0 = Next
    ).

tree_face(P, Depth, _-step(Q,Fold), Tree0-Next0, Tree-Next) :-
    (   get_assoc(Q, Tree0, _)
    ->  Tree = Tree0,
        Next0 = Next
    ;   put_assoc(Q, Tree0, way(Depth,P,Fold), Tree),
        Next0 = [Q-Depth|Next]
    ).

%   slit_folds(Tree, P-Q, Folds): the folds between P and Q, sorted.

slit_folds(Tree, P-Q, Folds) :-
    folds_between(P, Q, Tree, Folds0),
    sort(Folds0, Folds).

folds_between(P, P, _, []) :-
    !.
folds_between(P, Q, Tree, [Fold|Folds]) :-
    get_assoc(P, Tree, way(DepthP,UpP,FoldP)),
    get_assoc(Q, Tree, way(DepthQ,UpQ,FoldQ)),
    (   DepthP >= DepthQ
    ->  Fold = FoldP,
        folds_between(UpP, Q, Tree, Folds)
    ;   Fold = FoldQ,
        folds_between(P, UpQ, Tree, Folds)
    ).

%   folds_to_cut(Ways, Js): one fold at least of each of Ways, lists of folds;
%   always the one that most of them have.

folds_to_cut([], []) :-
    !.
folds_to_cut(Ways, [J|Js]) :-
    findall(Fold, ( member(Way, Ways), member(Fold, Way) ), Folds0),
    msort(Folds0, Folds1),
    findall(Fold-x, member(Fold, Folds1), Pairs),
    group_pairs_by_key(Pairs, Groups),
    findall(rank(Less,Size,J1)-Fold,
            ( member(Fold-Xs, Groups),
              Fold = fold(Size, J1),
              length(Xs, Count),
              Less is -Count
            ),
            Ranked0),
    keysort(Ranked0, [_-Best|_]),
    Best = fold(_, J),
    findall(Way, ( member(Way, Ways), \+ memberchk(Best, Way) ), Left),
    folds_to_cut(Left, Js).
