:- module(sg_pattern_allowance,
          [ allowances/5,               % +Seam, +Width, +Pieces, -Strips, -Bare
            strip_depth/3               % +Seam, +Width, -Deep
          ]).
:- use_module('../near', [less_part/2, tolerance/2]).
:- use_module('../kernel', [shapes_add/2, shapes_free/3]).
:- use_module(pattern_outline, [cut_loops/2]).
:- use_module(pattern_tab, [piece_shapes/3]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3]).
:- use_module(library(lists), [append/3, last/2, member/2]).
/** <module> Seam allowances of sheet metal.

A lap seam needs a strip as wide as the lap on one of its two sides. A grooved
lock seam with pockets W wide takes three times W: half of that, 1.5 W, is added
to each side, whose edge is folded over W wide, that of one side up and that of
the other down. So the fold is half of W from the seam.

Strips of seams that follow each other round a curve go on into each other;
their ends are square, or, in a corner, notched: two strips in a corner of 90
degrees meet at 45.
*/

:- set_prolog_flag(optimise, true).

% Seams that turn by less, in cosines, go on into each other.
goes_on_cosine(0.5).

%!  allowances(+Seam, +Width, +Pieces, -Strips, -Bare) is det.
%
%   Seam is `lap` or `lock`; Width in millimetres is that of the lap, or of a
%   pocket. Strips are tab(D,E,A,B)-allowance(Points, Folds), for the side E of
%   a piece from vertex A to vertex B, as of tabs/5: Points are its part of the
%   outline, Folds are fold(Role,P,Q) within the strip. Bare lists the seams
%   that have no room on either side, or not on both, as (D-J)-E.

allowances(Seam, Width, Pieces, Strips, Bare) :-
    maplist(piece_shapes(Width), Pieces, Named),
    findall(chain(Name,Loop,Sides),
            ( member(piece(Name,_,Own), Pieces),
              cut_loops(Own, Loops),
              member(Loop, Loops),
              loop_chains(Seam, Loop, Chains),
              member(Sides, Chains) ),
            Chains),
    foldl(chain_strip(Seam, Width, Named), Chains, []-[], Strips0-Left0),
    (   Seam == lap
    ->  findall(chain(Name,Loop,[Side]),
                ( member(D-side(_,_,_,_,seam(J,_,1)), Left0),
                  member(piece(Name,_,Own), Pieces),
                  Name = name(D,_,_),
                  cut_loops(Own, Loops),
                  member(Loop, Loops),
                  member(Side, Loop),
                  Side = side(_,_,_,_,seam(J,_,2)) ),
                Others),
        foldl(chain_strip(lap, Width, Named), Others, Strips0-[],
              Strips-Left1),
        findall(D-side(E,P,A,B,seam(J,T,1)),
                ( member(D-side(E,P,A,B,seam(J,T,1)), Left0),
                  \+ \+ member(D-side(_,_,_,_,seam(J,_,2)), Left1) ),
                Left)
    ;   Strips = Strips0,
        Left = Left0
    ),
    findall((D-J)-E, member(D-side(E,_,_,_,seam(J,_,_)), Left), Bare0),
    sort(1, @<, Bare0, Bare).

/* - - - chains - - - */

has_strip(lap, side(_,_,_,_,seam(_,_,1))).
has_strip(lock, side(_,_,_,_,seam(_,_,_))).

%   loop_chains(Seam, Loop, Chains): sides that follow each other and have a
%   strip; a loop that is one chain all round begins with its first side.

loop_chains(Seam, Loop, Chains) :-
    (   append(Before, [Last,First|After], Loop),
        \+ linked(Seam, Last, First)
    ->  append([First|After], Before, Round0),
        append(Round0, [Last], Round)
    ;   Round = Loop
    ),
    chains(Round, Seam, Chains).

chains([], _, []).
chains([Side|Sides], Seam, Chains) :-
    (   has_strip(Seam, Side)
    ->  chain_on(Sides, Side, Seam, Chain, Rest),
        Chains = [[Side|Chain]|Chains1]
    ;   Rest = Sides,
        Chains = Chains1
    ),
    chains(Rest, Seam, Chains1).

chain_on([Side|Sides], Before, Seam, [Side|Chain], Rest) :-
    linked(Seam, Before, Side),
    !,
    chain_on(Sides, Side, Seam, Chain, Rest).
chain_on(Rest, _, _, [], Rest).

linked(Seam, Side1, Side2) :-
    has_strip(Seam, Side1),
    has_strip(Seam, Side2),
    way(Side1, U1, V1, _),
    way(Side2, U2, V2, _),
    goes_on_cosine(Least),
    U1*U2 + V1*V2 > Least.

way(side(_,_,_-(XA-YA),_-(XB-YB),_), U, V, Length) :-
    Length is sqrt((XB-XA)**2 + (YB-YA)**2),
    U is (XB-XA)/Length,
    V is (YB-YA)/Length.

/* - - - strips - - - */

%   chain_strip(Seam, Width, Named, Chain, Strips0-Left0, Strips-Left): one
%   strip for all, or one for each side that has room.

chain_strip(Seam, Width, Named, chain(Name,Loop,Sides), Strips0-Left0,
            Strips-Left) :-
    memberchk(Name-Shapes, Named),
    Name = name(D, _, _),
    (   strip(Seam, Width, Shapes, D, Loop, Sides, New)
    ->  append(New, Strips0, Strips),
        Left = Left0
    ;   Sides = [Side]
    ->  Strips = Strips0,
        Left = [D-Side|Left0]
    ;   findall(chain(Name,Loop,[Side]), member(Side, Sides), Singles),
        foldl(chain_strip(Seam, Width, Named), Singles, Strips0-Left0,
              Strips-Left)
    ).

strip(Seam, Width, Shapes, D, Loop, Sides, Strips) :-
    strip_depth(Seam, Width, Deep),
    end_slopes(Seam, Loop, Sides, Slope),
    offset(Sides, Deep, Slope, Outer),
    inner_corners(Sides, Inner),
    cells(Inner, Outer, Cells),
    tolerance(paper, Tolerance),
    \+ ( member(Cell, Cells), \+ shapes_free(Shapes, Cell, Tolerance) ),
    !,
    maplist(shapes_add(Shapes), Cells),
    (   Seam == lock
    ->  Half is Width/2,
        offset(Sides, Half, Slope, Fold)
    ;   Fold = none
    ),
    side_strips(Sides, Outer, Fold, D, first, Strips).

%   end_slopes(Seam, Loop, Sides, Slopes) is nondet: how far in each end of the
%   strip is, over its depth, Start-End. In a corner that opens by less than a
%   right angle it keeps off the other side; two strips share the corner.

end_slopes(Seam, Loop, Sides, Slope1-Slope2) :-
    Sides = [First|_],
    last(Sides, Last),
    neighbour(Loop, Before, First),
    neighbour(Loop, Last, After),
    end_slope(Seam, Before, First, Before, Start),
    end_slope(Seam, Last, After, After, End),
    (   Slope1 = Start,
        Slope2 = End
    ;   Slope1 is max(1.0, Start),
        Slope2 is max(1.0, End)
    ).

neighbour(Loop, Side1, Side2) :-
    last(Loop, Last),
    append(_, [Side1,Side2|_], [Last|Loop]),
    !.

end_slope(Seam, Side1, Side2, Other, Slope) :-
    way(Side1, U1, V1, _),
    way(Side2, U2, V2, _),
    Open0 is pi + atan2(U1*V2-V1*U2, U1*U2+V1*V2),
    (   has_strip(Seam, Other)
    ->  Open is Open0/2
    ;   Open is Open0
    ),
    (   \+ less_part(Open, pi/2)
    ->  Slope = 0.0
    ;   less_part(0.0, Open),
        Slope is 1/tan(Open)
    ).

%!  strip_depth(+Seam, +Width, -Deep) is semidet.
%
%   How far beyond its side the strip of a seam reaches; none but `lap` and
%   `lock` has one.

strip_depth(lap, Width, Width).
strip_depth(lock, Width, Deep) :-
    Deep is 1.5*Width.

inner_corners([side(_,_,_-A,_-B,_)|Sides], [A,B|Corners]) :-
    findall(C, member(side(_,_,_,_-C,_), Sides), Corners).

%   cells(Inner, Outer, Cells): what the strip covers, side by side.

cells([A,B|Inner], [P,Q|Outer], [[A,P,Q,B]|Cells]) :-
    !,
    cells([B|Inner], [Q|Outer], Cells).
cells(_, _, []).

%   offset(Sides, Deep, Slopes, Corners): the line Deep on the right of Sides,
%   one corner more than they are; the ends are as end_slopes/4 says.

offset(Sides, Deep, Slope-End, [Start|Corners]) :-
    Sides = [First|_],
    First = side(_, _, _-(XA-YA), _, _),
    way(First, U, V, Length1),
    XS is XA + Deep*(V + Slope*U),
    YS is YA + Deep*(Slope*V - U),
    Start = XS-YS,
    last(Sides, Last),
    way(Last, _, _, Length2),
    (   Sides = [_]
    ->  Length1 > (Slope+End)*Deep
    ;   Length1 > Slope*Deep,
        Length2 > End*Deep
    ),
    offset_corners(Sides, Deep, End, Corners).

offset_corners([Side], Deep, Slope, [X-Y]) :-
    !,
    Side = side(_, _, _, _-(XB-YB), _),
    way(Side, U, V, _),
    X is XB + Deep*(V - Slope*U),
    Y is YB - Deep*(Slope*V + U).
offset_corners([Side1,Side2|Sides], Deep, Slope, [X-Y|Corners]) :-
    Side1 = side(_, _, _, _-(XB-YB), _),
    way(Side1, U1, V1, _),
    way(Side2, U2, V2, _),
    Both is 1 + U1*U2 + V1*V2,
    X is XB + Deep*(V1+V2)/Both,
    Y is YB - Deep*(U1+U2)/Both,
    offset_corners([Side2|Sides], Deep, Slope, Corners).

%   side_strips(Sides, Outer, Fold, D, Place, Strips): to each side its part of
%   the outline, which goes on where that of the side before ended.

side_strips([Side|Sides], [P,Q|Outer], Fold, D, Place,
            [tab(D,E,WA,WB)-allowance(Points,Folds)|Strips]) :-
    Side = side(E, _, WA-A, WB-B, seam(_,_,Which)),
    (   Sides == []
    ->  Points0 = [P,Q,B]
    ;   Points0 = [P,Q]
    ),
    (   Place == first
    ->  Points = [A|Points0]
    ;   Points = Points0
    ),
    (   Fold = [F,G|Fold1]
    ->  fold_way(Which, Role),
        Folds = [fold(Role,F,G)],
        Fold2 = [G|Fold1]
    ;   Folds = [],
        Fold2 = none
    ),
    (   Sides == []
    ->  Strips = []
    ;   side_strips(Sides, [Q|Outer], Fold2, D, next, Strips)
    ).

fold_way(1, fold_up).
fold_way(2, fold_down).
