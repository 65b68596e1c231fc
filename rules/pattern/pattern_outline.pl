:- module(sg_pattern_outline,
          [ cut_loops/2,                % +Sides, -Loops
            loops_ranked/2,             % +Loops0, -Loops
            walked_sides/2,             % +Sides, -Loops
            loop_area/2                 % +Points, -Area
          ]).
:- use_module('../near', [less_part/2]).
:- use_module(library(apply), [exclude/3, foldl/4, maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [append/3, member/2, select/3]).
:- use_module(library(pairs), [group_pairs_by_key/2, pairs_values/2]).
/** <module> Where a piece is cut out: its outline in closed loops.

A side that is no fold and no penetration line is cut. The face lies on the left
of each, so the outline runs counter-clockwise round the piece and clockwise
round each hole.

Where bends take off from faces that are not alike (bend.pl), the two sides of a
fold end in two places on the bend line. The outline goes along it from one to
the other: that is a side of edge 0.
*/

:- set_prolog_flag(optimise, true).

%!  cut_loops(+Sides, -Loops) is det.
%
%   Loops are the sides (pattern_piece.pl) that are cut, each loop in the order
%   of the way round; those round holes first, as who cuts wants it, then the
%   larger ones last.

cut_loops(Sides, Loops) :-
    findall(W-Side,
            ( member(Side, Sides),
              Side = side(_, _, W-_, _, Joint),
              is_cut(Joint)
            ),
            Pairs1),
    fold_steps(Sides, Steps),
    append(Pairs1, Steps, Pairs),
    walked_pairs(Pairs, Loops1),
    (   Steps == []
    ->  Loops0 = Loops1
    ;   exclude(steps_alone(Steps), Loops1, Loops0)
    ),
    loops_ranked(Loops0, Loops).

%!  loops_ranked(+Loops0, -Loops) is det.
%
%   Loops are Loops0, lists of sides: those round holes first, then the larger
%   ones last.

loops_ranked(Loops0, Loops) :-
    maplist(loop_rank, Loops0, Ranked0),
    keysort(Ranked0, Ranked),
    pairs_values(Ranked, Loops).

%!  walked_sides(+Sides, -Loops) is det.
%
%   Loops are Sides, each loop in the order of the way round. As many sides
%   begin as end at each corner.

walked_sides(Sides, Loops) :-
    findall(W-Side,
            ( member(Side, Sides), Side = side(_, _, W-_, _, _) ),
            Pairs),
    walked_pairs(Pairs, Loops).

walked_pairs(Pairs0, Loops) :-
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    maplist(leaving, Groups, Corners),
    list_to_assoc(Corners, Leaving),
    walked_loops(Corners, Leaving, Loops).

%   leaving(W-Sides, W-Left): Left is left(Sides), those that leave corner W and
%   are in no loop yet; taken/2 changes it.

leaving(W-Sides, W-left(Sides)).

%   fold_steps(Sides, Steps): W-Side for each end of a fold that its two sides
%   have in two places.

fold_steps(Sides, Steps) :-
    findall(J-(Which-Side),
            ( member(Side, Sides),
              Side = side(_, _, _, _, fold(J,_,Which)) ),
            Folds0),
    keysort(Folds0, Folds),
    group_pairs_by_key(Folds, Groups),
    findall(W-side(0,P,W-A,V-B,border),
            ( member(_-[1-Side1,2-Side2], Groups),
              (   Side = Side1, Other = Side2
              ;   Side = Side2, Other = Side1
              ),
              Side = side(_, P, W-A, _, _),
              Other = side(_, _, _, V-B, _),
              W \== V ),
            Steps).

%   steps_alone(Steps, Loop): all round a corner within the piece.

steps_alone(Steps, Loop) :-
    \+ ( member(Side, Loop),
         \+ memberchk(_-Side, Steps) ).

is_cut(border).
is_cut(seam(_,_,_)).

%   walked_loops(Corners, Leaving, Loops): each begins at the first of Corners
%   that has a side left.

walked_loops([], _, []).
walked_loops([W-Left|Corners], Leaving, Loops) :-
    (   Left = left([First|_])
    ->  taken(Left, First),
        walked(First, W, Leaving, Rest),
        Loops = [[First|Rest]|Loops1],
        walked_loops([W-Left|Corners], Leaving, Loops1)
    ;   walked_loops(Corners, Leaving, Loops)
    ).

taken(Left, Side) :-
    Left = left(Sides0),
    once(select(Side, Sides0, Sides)),
    setarg(1, Left, Sides).

%   walked(Side, Start, Leaving, Loop): on from the end of Side until Start, or
%   until no side goes on.

walked(side(_,_,_,Start-_,_), Start, _, []) :-
    !.
walked(Side, Start, Leaving, Loop) :-
    Side = side(_, _, _, W-_, _),
    (   get_assoc(W, Leaving, Left),
        Left = left([One|Sides])
    ->  next_side([One|Sides], Side, Next),
        taken(Left, Next),
        Loop = [Next|Loop1],
        walked(Next, Start, Leaving, Loop1)
    ;   Loop = []
    ).

%   Where the piece is connected by a point alone several sides go on from
%   there. The face on the left of Side is on the left of the next one too: the
%   first one met clockwise from where Side came from.

next_side([Next], _, Next) :-
    !.
next_side(Sides, side(_,_,_-A,_-B,_), Next) :-
    maplist(turn_from(A, B), Sides, Turned0),
    keysort(Turned0, [_-Next|_]).

turn_from(XA-YA, XB-YB, Side, Turn-Side) :-
    Side = side(_, _, _, _-(XC-YC), _),
    Back is atan2(YA-YB, XA-XB),
    On is atan2(YC-YB, XC-XB),
    Turn0 is Back-On,
    (   \+ less_part(0.0, Turn0)
    ->  Turn is Turn0 + 2*pi
    ;   Turn = Turn0
    ).

%   Holes have an area below zero.

loop_rank(Loop, rank(Outer,Size)-Loop) :-
    findall(Point, member(side(_,_,_-Point,_,_), Loop), Points),
    loop_area(Points, Area),
    Size is abs(Area),
    (   Area < 0
    ->  Outer = 0
    ;   Outer = 1
    ).

%!  loop_area(+Points, -Area) is det.
%
%   Area is that within the closed line through Points, X-Y; below zero if it
%   runs clockwise.

loop_area([], 0.0).
loop_area([First|Points], Area) :-
    foldl(swept(First), Points, First-0.0, _-Twice),
    Area is Twice/2.

swept(X0-Y0, X2-Y2, (X1-Y1)-Area0, (X2-Y2)-Area) :-
    Area is Area0 + (X1-X0)*(Y2-Y0) - (X2-X0)*(Y1-Y0).
