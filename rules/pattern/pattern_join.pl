:- module(sg_pattern_join,
          [ joined_parts/4              % +Piece, +Parts0, +Paper, -Parts
          ]).
:- use_module('../near', [is_rounding/2]).
:- use_module('../disjoint_sets', [set_root/3, sets_joined/4]).
:- use_module(pattern_nest, [fits_on/2, hull/2]).
:- use_module(pattern_piece, [piece_points/2]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(assoc),
              [empty_assoc/1, get_assoc/3, list_to_assoc/2, put_assoc/4]).
:- use_module(library(lists), [append/3, member/2, nth1/3]).
:- use_module(library(pairs), [group_pairs_by_key/2, pairs_values/2]).
/** <module> Parts of a piece that fit on a page together are not parted.

Pieces are divided by halves (pattern_split.pl), which leaves parts that have
room for others. They are joined again over the folds that were lost, over the
longest first. Whether parts fit together is seen by their hulls, so a join
costs nothing for the faces that they have.
*/

:- set_prolog_flag(optimise, true).

%!  joined_parts(+Piece, +Parts0, +Paper, -Parts) is det.
%
%   Parts are those of Parts0, parts of Piece (pattern_piece.pl), some of them
%   joined over folds of Piece; in the order of the first of each.

joined_parts(_, [Part], _, [Part]) :-
    !.
joined_parts(Piece, Parts0, Paper, Parts) :-
    fold_ranks(Piece, Ranks),
    parted_folds(Ranks, Parts0, Pairs),
    empty_assoc(Sets0),
    findall(I-Hull, part_hull(Parts0, I, Hull), Hulls),
    list_to_assoc(Hulls, Hulls0),
    foldl(joined_pair(Paper), Pairs, Sets0-Hulls0, Sets-_),
    set_groups(Parts0, Sets, Groups),
    maplist(joined_piece(Ranks), Groups, Parts).

%   fold_ranks(Piece, Ranks): an assoc of the folds, the longest has rank 1.

fold_ranks(piece(_,_,Sides), Ranks) :-
    findall(Less-J,
            ( member(side(_,_,_-(XA-YA),_-(XB-YB),fold(J,_,1)), Sides),
              Less is -((XB-XA)**2 + (YB-YA)**2)
            ),
            Folds0),
    keysort(Folds0, Folds),
    pairs_values(Folds, Js),
    findall(J-Rank, nth1(Rank, Js, J), Ranked),
    list_to_assoc(Ranked, Ranks).

part_hull(Parts, I, Hull) :-
    nth1(I, Parts, Part),
    piece_points(Part, Points),
    hull(Points, Hull).

%   parted_folds(Ranks, Parts, Pairs): places of parts on both sides of a fold
%   that was lost. A face that a line divided has a fold several times: its
%   sides that lie in one place are pairs.

parted_folds(Ranks, Parts, Pairs) :-
    findall(Rank-end(Which,I,Side),
            ( nth1(I, Parts, piece(_,_,Sides)),
              member(Side, Sides),
              Side = side(_, _, _, _, seam(J,_,Which)),
              get_assoc(J, Ranks, Rank)
            ),
            Ends0),
    keysort(Ends0, Ends),
    group_pairs_by_key(Ends, Groups),
    findall(I1-I2,
            ( member(_-Group, Groups),
              member(end(1,I1,Side1), Group),
              member(end(2,I2,Side2), Group),
              same_place(Side1, Side2)
            ),
            Pairs).

%   same_place(Side1, Side2): one runs back along the other.

same_place(side(_,_,_-(XA-YA),_-(XB-YB),_),
           side(_,_,_-(XC-YC),_-(XD-YD),_)) :-
    Size is abs(XB-XA) + abs(YB-YA),
    is_rounding(abs(XA-XD) + abs(YA-YD), Size),
    is_rounding(abs(XB-XC) + abs(YB-YC), Size).

joined_pair(Paper, I-J, Sets0-Hulls0, Sets-Hulls) :-
    set_root(Sets0, I, A),
    set_root(Sets0, J, B),
    (   A \== B,
        get_assoc(A, Hulls0, HullA),
        get_assoc(B, Hulls0, HullB),
        append(HullA, HullB, Points),
        fits_on(Points, Paper)
    ->  sets_joined(A, B, Sets0, Sets),
        set_root(Sets, A, Root),
        hull(Points, Hull),
        put_assoc(Root, Hulls0, Hull, Hulls)
    ;   Sets = Sets0,
        Hulls = Hulls0
    ).

%   set_groups(Parts, Sets, Groups): lists of Parts that are one now.

set_groups(Parts, Sets, Groups) :-
    findall(Root-(I-Part),
            ( nth1(I, Parts, Part), set_root(Sets, I, Root) ),
            Rooted0),
    keysort(Rooted0, Rooted),
    group_pairs_by_key(Rooted, Grouped),
    findall(First-Group,
            ( member(_-Numbered, Grouped),
              Numbered = [First-_|_],
              pairs_values(Numbered, Group)
            ),
            Firsts0),
    keysort(Firsts0, Firsts),
    pairs_values(Firsts, Groups).

%   Seams whose two sides came together are folds again.

joined_piece(_, [Part], Part) :-
    !.
joined_piece(Ranks, Parts, piece(Name,Faces,Sides)) :-
    Parts = [piece(Name,_,_)|_],
    findall(Face, ( member(piece(_,Own,_), Parts), member(Face, Own) ),
            Faces),
    findall(Side, ( member(piece(_,_,Own), Parts), member(Side, Own) ),
            Sides0),
    findall(J-Side,
            ( member(Side, Sides0),
              Side = side(_, _, _, _, seam(J,_,_)),
              get_assoc(J, Ranks, _)
            ),
            Lost0),
    keysort(Lost0, Lost1),
    group_pairs_by_key(Lost1, Lost2),
    list_to_assoc(Lost2, Lost),
    maplist(joined_side(Lost), Sides0, Sides).

joined_side(Lost, Side0, Side) :-
    Side0 = side(E, P, A, B, seam(J,Angle,Which)),
    get_assoc(J, Lost, Seams),
    Other is 3-Which,
    Side1 = side(_, _, _, _, seam(_,_,Other)),
    member(Side1, Seams),
    same_place(Side0, Side1),
    !,
    Side = side(E, P, A, B, fold(J,Angle,Which)).
joined_side(_, Side, Side).
