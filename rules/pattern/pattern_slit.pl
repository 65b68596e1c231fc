:- module(sg_pattern_slit,
          [ opened_slits/5              % +Worth, +Flat, +Pieces, +Butt, -Opened
          ]).
:- use_module(pattern_split, [parted_piece/3]).
:- use_module(pattern_tab, [side_length/2]).
:- use_module(library(apply), [exclude/3, foldl/4, maplist/3]).
:- use_module(library(assoc),
              [ empty_assoc/1, get_assoc/3, list_to_assoc/2, put_assoc/4 ]).
:- use_module(library(lists), [append/2, member/2, nth1/3, sum_list/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Slits too narrow for a tab, opened: the piece is parted at folds.

The two sides of a slit are connected by folds, from face to face. Where one of
these folds is cut, the slit is the gap between two pieces, and has room for
tabs. That fold is taken first which opens the longest slits; of several the
shortest, as it is a seam from now on. What hangs together by folds that are not
drawn is one face, and stays one.
*/

:- set_prolog_flag(optimise, true).

%!  opened_slits(+Worth, +Flat, +Pieces, +Butt, -Opened) is det.
%
%   Opened are Pieces (pattern_piece.pl), in their order, in place of each its
%   parts: seams of Butt, an assoc with keys D-J, whose sides are both in one
%   piece are between two. Worth is worth(Most,Least,Need), in thousandths of a
%   millimetre of seam: a fold is cut that opens at least Most, and, until Need
%   is opened, one that opens at least Least. Folds that bend by no more than
%   Flat degrees are not cut.

opened_slits(Worth, Flat, Pieces, Butt, Opened) :-
    Worth = worth(Most, Least0, _),
    Least is min(Most, Least0),
    findall(Less-cut(I,J),
            ( nth1(I, Pieces, Piece),
              piece_cuts(Piece, Flat, Butt, Least, Cuts),
              member(Less-J, Cuts)
            ),
            Cuts0),
    keysort(Cuts0, Cuts1),
    worth_cutting(Cuts1, Worth, Cuts2),
    keysort(Cuts2, Cuts3),
    group_pairs_by_key(Cuts3, Groups),
    list_to_assoc(Groups, ByPiece),
    findall(Parts,
            ( nth1(I, Pieces, Piece),
              piece_parts(I, ByPiece, Piece, Parts)
            ),
            Partss),
    append(Partss, Opened).

piece_parts(I, Cuts, Piece, Parts) :-
    (   get_assoc(I, Cuts, Folds)
    ->  parted_piece(Piece, Folds, Parts)
    ;   Parts = [Piece]
    ).

%   worth_cutting(Ranked, Worth, Cuts): what opens most is first.

worth_cutting([Less-cut(I,J)|Ranked], worth(Most,Least,Need), [I-J|Cuts]) :-
    Gain is -Less,
    (   Gain >= Most
    ->  true
    ;   Need > 0,
        Gain >= Least
    ),
    !,
    Still is Need-Gain,
    worth_cutting(Ranked, worth(Most,Least,Still), Cuts).
worth_cutting(_, _, []).

%   piece_cuts(Piece, Flat, Butt, Least, Cuts): -Gain-J for each fold of Piece
%   to cut, the best first, as long as each gains Least.

piece_cuts(piece(name(D,_,_),_,Sides), Flat, Butt, Least, Cuts) :-
    findall((P1-P2)-Length, slit(D, Sides, Butt, P1, P2, Length), Slits0),
    (   Slits0 == []
    ->  Cuts = []
    ;   keysort(Slits0, Slits1),
        group_pairs_by_key(Slits1, Slits),
        fold_steps(Sides, Steps),
        fold_tree(Sides, Steps, Tree),
        maplist(slit_way(Tree, Flat), Slits, Ways),
        folds_to_cut(Ways, Least, Cuts)
    ).

%   The faces on the two sides of a seam without a tab, and how long it is.

slit(D, Sides, Butt, P1, P2, Length) :-
    findall(J-(P-Size),
            ( member(Side, Sides),
              Side = side(_, P, _, _, seam(J,_,_)),
              get_assoc(D-J, Butt, _),
              side_size(Side, Size)
            ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    member(_-[P1-Length,P2-_], Groups).

side_size(Side, Size) :-
    side_length(Side, Length),
    Size is round(1000*Length).

%   fold_steps(Sides, Steps): an assoc from each face to step(Next,Fold) over
%   each of its folds, fold(Size,J,Angle), Size its length, the longest first.

fold_steps(Sides, Steps) :-
    findall(fold(J,Angle)-(P-Size),
            ( member(Side, Sides),
              Side = side(_, P, _, _, fold(J,Angle,_)),
              side_size(Side, Size)
            ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Folds),
    findall(P-(Less-step(Q,fold(Size,J,Angle))),
            ( member(fold(J,Angle)-[A-Size,B-_], Folds),
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

%   slit_way(Tree, Flat, Slit, Way): Way is Folds-Length, the folds between
%   the two faces of Slit that may be cut, sorted.

slit_way(Tree, Flat, (P-Q)-Lengths, Folds-Length) :-
    folds_between(P, Q, Tree, Folds0),
    exclude(is_flat(Flat), Folds0, Folds1),
    sort(Folds1, Folds),
    sum_list(Lengths, Length).

is_flat(Flat, fold(_,_,Angle)) :-
    abs(Angle) =< Flat.

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

%   folds_to_cut(Ways, Least, Cuts): of Ways, Folds-Length, at least one fold
%   each; always the one that opens most.

folds_to_cut(Ways, Least, Cuts) :-
    findall(Fold-Length,
            ( member(Folds-Length, Ways), member(Fold, Folds) ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    findall(rank(Less,Fold),
            ( member(Fold-Lengths, Groups),
              sum_list(Lengths, Sum),
              Sum >= Least,
              Less is -Sum
            ),
            Ranked0),
    (   sort(Ranked0, [rank(Less,Best)|_])
    ->  Best = fold(_, J, _),
        Cuts = [Less-J|Cuts1],
        exclude(is_opened(Best), Ways, Left),
        folds_to_cut(Left, Least, Cuts1)
    ;   Cuts = []
    ).

is_opened(Fold, Folds-_) :-
    memberchk(Fold, Folds).
