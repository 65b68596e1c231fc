:- module(sg_pattern_nest,
          [ nested/3,                   % +Outlines, +Paper, -Nested
            fits_on/2,                  % +Points, +Paper
            least_box/4,                % +Points, -Degrees, -Width, -Height
            hull/2                      % +Points, -Hull
          ]).
:- use_module('../kernel', [nest/8, nest_open/2, turned_boxes/3]).
:- use_module('../near', [tolerance/2]).
:- use_module(pattern_face, [first_of/3]).
:- use_module(library(apply), [foldl/4, foldl/6, maplist/3, maplist/4]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2, put_assoc/4]).
:- use_module(library(lists),
              [ append/2, append/3, last/2, max_list/2, member/2, nth0/4,
                nth1/3, reverse/2, sum_list/2
              ]).
:- use_module(library(pairs), [pairs_keys_values/3, pairs_values/2]).
/** <module> Pieces laid on sheets: turned, close together, none on another.

The kernel nest/8 places them one by one, as low as can be; here it is decided
at which angles, in which order and from which side of the sheet: upright, lying
and with the least box round them. Some usual orders are tried, large ones
first, then exchanges in the best one, as many as there is time for: that is
measured by the squares that were looked at, not by a clock, and chance is a row
of numbers that is always the same. Paper is what is free of a sheet,

    room(Width, Height, Gap)     a page, as many as are needed
    roll(Gap)                    one sheet, as large as needed

in millimetres; Gap is how far apart pieces stay.
*/

:- set_prolog_flag(optimise, true).

% What all trials together may look at, in squares and the like (nest/8): a
% second or so. The last one may take more.
most_work(6.0e7).
most_trials(200).

% With so many pieces, on so many sheets, the raster is fine.
fine_pieces(8, 200).
fine_sheets(6).

%!  nested(+Outlines, +Paper, -Nested) is det.
%
%   Nested is nested(Size,Places). Outlines are Name-Loops, lists of X-Y; Places
%   are Name-place(Sheet,Degrees,DX,DY) in the same order: turned
%   counter-clockwise, then moved. Size, W-H, is that of the room, or of what is
%   needed of a roll.

nested(Outlines, Paper, nested(Size,Places)) :-
    findall(Loops, member(_-Loops, Outlines), Loopss),
    nest_open(Loopss, Nest),
    findall(Way, ( nth1(I, Outlines, Outline),
                   outline_way(Paper, I, Outline, Way) ), Ways),
    best_trial(Ways, task(Paper,Nest), trial(_,_,Pairs,Size)),
    list_to_assoc(Pairs, ByName),
    findall(Name-Place,
            ( member(Name-_, Outlines), get_assoc(Name, ByName, Place) ),
            Places).

%   way(Name,I,Hull,Angles,Width,Height): piece I, its hull, at which angles it
%   is tried, and its box. A table, table(D,Part), is read from below or from
%   the right.

outline_way(_, I, Name-Loops, way(Name,I,Hull,[0.0,90.0],W,H)) :-
    Name = table(_, _),
    !,
    append(Loops, Points),
    hull(Points, Hull),
    points_box(Points, W, H).
outline_way(Paper, I, Name-Loops, way(Name,I,Hull,Angles,Width,Height)) :-
    append(Loops, Points),
    hull(Points, Hull),
    points_box(Points, W, H),
    hull_box(Hull, Degrees, LeastW, LeastH),
    (   LeastW*LeastH > 0.98*W*H,
        box_fits(Paper, W, H)
    ->  Width = W,
        Height = H,
        Angles = [0.0,90.0,180.0,270.0]
    ;   Width = LeastW,
        Height = LeastH,
        findall(Angle,
                ( member(Turn, [0.0,90.0,180.0,270.0]),
                  ( Angle is Degrees+Turn ; Angle = Turn )
                ),
                Angles)
    ).


                /*******************************
                *            TRIALS            *
                *******************************/

%   trial(Score,How,Pairs,Size): How is how(Ways,Side), in which order and from
%   which side; Pairs are Name-Place.

best_trial(Ways, Task, Best) :-
    Task = task(Paper, _),
    findall(how(Sorted,Side),
            ( member(Key, [longest,area,higher,wider]),
              sorted_ways(Key, Ways, Sorted),
              paper_side(Paper, Side)
            ),
            [First|Hows0]),
    most_work(Most),
    tried(Task, First, Trial, Work),
    note_tried(First, Work, left(Most,t), Left0),
    possible_trials(Ways, Paper, Possible),
    first_of(Possible, Hows0, Hows),
    length(Hows, N),
    Others is Possible-N,
    better_trials(Hows, Task, Trial, Better, Left0, Left),
    exchanged(Others, Task, 1, Better, Best, Left).

%   possible_trials(Ways, Paper, Count): after the first one; one piece needs
%   none, and few pieces have few orders.

possible_trials(Ways, Paper, Count) :-
    length(Ways, N),
    findall(Side, paper_side(Paper, Side), Sides),
    length(Sides, S),
    orders(N, Orders),
    most_trials(Most),
    Count is min(Most, (Orders-1)*S).

%   So many orders there are of N pieces, if not more.

orders(N, Orders) :-
    (   N =< 1
    ->  Orders = 1
    ;   N > 5
    ->  Orders = 720
    ;   N1 is N-1,
        orders(N1, Orders1),
        Orders is N*Orders1
    ).

sorted_ways(Key, Ways, Sorted) :-
    findall(Rank-Way,
            ( member(Way, Ways), way_rank(Key, Way, Rank) ),
            Ranked0),
    keysort(Ranked0, Ranked),
    pairs_values(Ranked, Sorted).

%   The larger a piece is the earlier it is placed.

way_rank(longest, way(_,_,_,_,W,H), Rank) :-
    Rank is -round(1000*max(W,H)).
way_rank(area, way(_,_,_,_,W,H), Rank) :-
    Rank is -round(1000*W*H).
way_rank(higher, way(_,_,_,_,W,H), Rank) :-
    Rank is -round(1000*(min(W,H) + 0.1*max(W,H))).
way_rank(wider, way(_,_,_,_,W,H), Rank) :-
    Rank is -round(1000*(W+H)).

%   From below; from the left too, if that is another thing. A roll may be wider
%   or narrower than usual.

paper_side(room(_,_,_), Side) :-
    member(Side, [below,left]).
paper_side(roll(_), width(Share)) :-
    member(Share, [1.0,0.85,1.2]).

better_trials([], _, Trial, Trial, Left, Left).
better_trials([How|Hows], Task, Trial0, Trial, Left0, Left) :-
    better_trial(Task, How, Trial0, Trial1, Left0, Left1),
    better_trials(Hows, Task, Trial1, Trial, Left1, Left).

%   better_trial(Task, How, Trial0, Trial, Left0, Left): Left is
%   left(Work,Tried): the work that may be done, and what was done already.
%   Without any work Trial0 stays. What was tried before was not better than
%   what was best then, so it is not better now: it counts, and is not done.

better_trial(_, _, Trial, Trial, Left, Left) :-
    no_work(Left),
    !.
better_trial(_, How, Trial, Trial, Left0, Left) :-
    Left0 = left(_,Tried),
    how_name(How, Name),
    get_assoc(Name, Tried, Work),
    !,
    note_tried(How, Work, Left0, Left).
better_trial(Task, How, Trial0, Trial, Left0, Left) :-
    tried(Task, How, Trial1, Work),
    note_tried(How, Work, Left0, Left),
    Trial0 = trial(Score0, _, _, _),
    Trial1 = trial(Score1, _, _, _),
    (   score_less(Score1, Score0)
    ->  Trial = Trial1
    ;   Trial = Trial0
    ).

no_work(left(Work,_)) :-
    Work =< 0.

note_tried(How, Work, left(Work0,Tried0), left(Work1,Tried)) :-
    how_name(How, Name),
    put_assoc(Name, Tried0, Work, Tried),
    Work1 is Work0-Work.

how_name(how(Ways,Side), Names-Side) :-
    maplist(way_name, Ways, Names).

way_name(way(Name,_,_,_,_,_), Name).

%   Better by next to nothing is no reason to move anything.

score_less(score(Left1,Sheets1,Used1), score(Left0,Sheets0,Used0)) :-
    (   Left1-Sheets1 @< Left0-Sheets0
    ->  true
    ;   Left1-Sheets1 == Left0-Sheets0,
        Used1 < 0.99*Used0
    ).

%   exchanged(Count, Task, Chance, Trial0, Trial, Left): Count times one piece
%   is put elsewhere in the order, as long as work is Left; what is better
%   stays.

exchanged(Count, _, _, Trial, Trial, Left) :-
    ( Count =< 0 ; no_work(Left) ),
    !.
exchanged(Count, Task, Chance0, Trial0, Trial, Left0) :-
    Trial0 = trial(_, how(Ways0,Side), _, _),
    length(Ways0, N),
    next_chance(Chance0, Chance1),
    next_chance(Chance1, Chance2),
    From is Chance1 mod N,
    To is Chance2 mod N,
    nth0(From, Ways0, Way, Others),
    To1 is min(To, N-1),
    nth0(To1, Ways, Way, Others),
    (   From =:= To1
    ->  Trial1 = Trial0,
        Left = Left0
    ;   better_trial(Task, how(Ways,Side), Trial0, Trial1, Left0, Left)
    ),
    Count1 is Count-1,
    exchanged(Count1, Task, Chance2, Trial1, Trial, Left).

%   The upper bits of a linear congruential generator (Knuth, TAOCP 2, 3.3.4).

next_chance(Chance0, Chance) :-
    Chance is (Chance0*6364136223846793005 + 1442695040888963407)
              /\ 0xffffffffffffffff >> 11.

%   tried(Task, How, Trial, Work): the pieces placed, at the cost of Work. Task
%   is task(Paper,Nest), Nest of nest_open/2.

tried(task(Paper,Nest), How, trial(Score,How,Pairs,Size), Work) :-
    How = how(Ways, Side),
    maplist(way_turn(Side), Ways, Names, Turns),
    paper_nesting(Paper, Side, Ways, W-H, One, Gap),
    raster(Paper, Ways, Raster),
    square(W, H, Gap, Paper, Raster, Square),
    Squares is max(1, ceiling(Gap/Square)),
    nest(W-H, Square, Squares, One, Nest, Turns, Places0, Work),
    maplist(seen_place(Side, W), Places0, Places1),
    last_sheet(Places1, Nested),
    foldl(placed_alone(Paper), Ways, Places1, Places, Nested, Sheets),
    pairs_keys_values(Pairs, Names, Places),
    used_size(Paper, Ways, Places, Size, Used),
    findall(x, member(place(0,_,_,_), Places), Xs),
    length(Xs, Unplaced),
    Score = score(Unplaced, Sheets, Used).

last_sheet(Places, Sheets) :-
    findall(I, member(place(I,_,_,_), Places), Is),
    max_list([0|Is], Sheets).

%   placed_alone(Paper, Way, Place0, Place, Sheets0, Sheets): what has room on a
%   page, but none in whole squares of its raster, has a page of its own.

placed_alone(room(RoomW,RoomH,_), way(_,_,Hull,_,_,_), place(0,_,_,_),
             place(Sheets,Degrees,DX,DY), Sheets0, Sheets) :-
    hull_box(Hull, Least, _, _),
    Across is Least+90.0,
    member(Degrees, [0.0,90.0,Least,Across]),
    maplist(turned(Degrees), Hull, Points),
    box_of(Points, box(X1,Y1,X2,Y2)),
    W is X2-X1,
    H is Y2-Y1,
    within(RoomW, RoomH, W, H),
    !,
    DX is -X1,
    DY is -Y1,
    Sheets is Sheets0+1.
placed_alone(_, _, Place, Place, Sheets, Sheets).

way_turn(Side, way(Name,I,_,Angles0,_,_), Name, turn(I,Angles)) :-
    (   Side == left,
        Name = table(_, _)
    ->  Angles = [90.0,180.0]
    ;   Angles = Angles0
    ).

%   From the left means from below on a sheet that stands, which is turned back.

seen_place(left, W, place(I,Degrees0,DX0,DY0), place(I,Degrees,DX,DY)) :-
    I > 0,
    !,
    (   Degrees0 >= 90
    ->  Degrees is Degrees0-90
    ;   Degrees is Degrees0+270
    ),
    DX = DY0,
    DY is W-DX0.
seen_place(_, _, Place, Place).

paper_nesting(room(W,H,Gap), below, _, W-H, false, Gap).
paper_nesting(room(W,H,Gap), left, _, H-W, false, Gap).
paper_nesting(roll(Gap), width(Share), Ways, Width-Height, true, Gap) :-
    findall(Area, ( member(way(_,_,_,_,W,H), Ways),
                    Area is (W+Gap)*(H+Gap) ), Areas),
    sum_list(Areas, All),
    findall(W, member(way(_,_,_,_,W,_), Ways), Ws),
    findall(Side, ( member(way(_,_,_,_,W,H), Ways), Side is max(W, H)+Gap ),
            Sides),
    max_list([1.0|Ws], Widest),
    sum_list(Sides, Longest),
    Width is max(Widest*1.02+Gap, Share*sqrt(1.15*All)),
    Height is max(1.0, min(Longest*1.1+Gap, 40*Width)).

%   raster(Paper, Ways, Raster): fine where that tells: for some pieces, but not
%   for many of them or many sheets, which would take too long.

raster(Paper, Ways, Raster) :-
    length(Ways, N),
    fine_pieces(Least, Most),
    findall(Area, ( member(way(_,_,_,_,W,H), Ways), Area is W*H ), Areas),
    sum_list(Areas, All),
    fine_sheets(Sheets),
    (   N >= Least,
        N =< Most,
        \+ ( Paper = room(RoomW, RoomH, _), All > Sheets*RoomW*RoomH )
    ->  Raster = fine
    ;   Raster = coarse
    ).

%   About 800 or 400 squares along the longer side of a page; of a roll along
%   the width.

square(W, H, Gap, Paper, Raster, Square) :-
    (   Raster == fine
    ->  Fine = 800
    ;   Fine = 400
    ),
    (   Paper = room(_, _, _)
    ->  Square is max(max(W,H)/Fine, Gap/90)
    ;   Square is max(max(W/Fine, H/16000), Gap/90)
    ).

%   used_size(Paper, Ways, Places, Size, Used): Used is how much of the last
%   sheet is used, up to a line across it.

used_size(Paper, Ways, Places, Size, Used) :-
    findall(I, member(place(I,_,_,_), Places), Is),
    max_list([0|Is], Last),
    findall(X-Y,
            ( nth1(N, Places, place(Last,Degrees,DX,DY)),
              nth1(N, Ways, way(_,_,Hull,_,_,_)),
              member(Point, Hull),
              turned(Degrees, Point, X0-Y0),
              X is X0+DX,
              Y is Y0+DY
            ),
            Points),
    foldl(farther, Points, 1.0-1.0, W-H),
    (   Paper = room(RoomW, RoomH, _)
    ->  Size = RoomW-RoomH,
        Used is min(W*RoomH, H*RoomW)
    ;   Size = W-H,
        Used is W*H
    ).

farther(X-Y, X0-Y0, X1-Y1) :-
    X1 is max(X0, X),
    Y1 is max(Y0, Y).

turned(Degrees, X0-Y0, X-Y) :-
    Angle is Degrees*pi/180,
    X is X0*cos(Angle) - Y0*sin(Angle),
    Y is X0*sin(Angle) + Y0*cos(Angle).

%!  fits_on(+Points, +Paper) is semidet.
%
%   True when a piece with these Points can be nested on one sheet.

fits_on(Points, Paper) :-
    (   points_box(Points, W, H)
    ;   least_box(Points, _, W, H)
    ),
    box_fits(Paper, W, H),
    !.

%   box_fits(Paper, W, H): also on its side.

box_fits(roll(_), _, _).
box_fits(room(RoomW,RoomH,_), W, H) :-
    (   within(RoomW, RoomH, W, H)
    ->  true
    ;   within(RoomW, RoomH, H, W)
    ).

within(RoomW, RoomH, W, H) :-
    tolerance(paper, Off),
    W =< RoomW+Off,
    H =< RoomH+Off.

points_box(Points, W, H) :-
    box_of(Points, box(X1,Y1,X2,Y2)),
    W is X2-X1,
    H is Y2-Y1.

box_of(Points, Box) :-
    Points = [X-Y|_],
    foldl(boxed, Points, box(X,Y,X,Y), Box).

boxed(X-Y, box(X1,Y1,X2,Y2), box(X3,Y3,X4,Y4)) :-
    X3 is min(X1, X),
    Y3 is min(Y1, Y),
    X4 is max(X2, X),
    Y4 is max(Y2, Y).

%!  least_box(+Points, -Degrees, -Width, -Height) is det.
%
%   Turned by Degrees the box round Points has the least area of all that lie
%   along a side of their hull; it is not higher than wide.

least_box(Points, Degrees, Width, Height) :-
    hull(Points, Hull),
    hull_box(Hull, Degrees, Width, Height).

hull_box(Hull, Degrees, Width, Height) :-
    hull_degrees(Hull, Angles),
    turned_boxes(Hull, Angles, Sizes),
    maplist(angle_box, Angles, Sizes, Boxes),
    msort(Boxes, [box(_,Degrees0,W0,H0)|_]),
    (   W0 >= H0
    ->  Degrees = Degrees0, Width = W0, Height = H0
    ;   Degrees is Degrees0+90, Width = H0, Height = W0
    ).

angle_box(Angle, W-H, box(Area,Angle,W,H)) :-
    Area is round(W*H*1.0e6).

%   At most some hundred directions.

hull_degrees(Hull, Angles) :-
    last(Hull, Last),
    append(Hull, [], Points),
    length(Points, N),
    Step is max(1, N//100),
    hull_sides(Points, Last, Step, 0, Angles0),
    sort([0.0|Angles0], Angles).

hull_sides([], _, _, _, []).
hull_sides([X-Y|Points], X0-Y0, Step, I, Angles) :-
    (   I mod Step =:= 0,
        ( X =\= X0 ; Y =\= Y0 )
    ->  Angle0 is -atan2(Y-Y0, X-X0)*180/pi,
        Angle is Angle0 - 90*floor(Angle0/90),
        Angles = [Angle|Angles1]
    ;   Angles = Angles1
    ),
    I1 is I+1,
    hull_sides(Points, X-Y, Step, I1, Angles1).

%!  hull(+Points, -Hull) is det.
%
%   Hull are those of Points, X-Y, that are corners of their convex hull,
%   counter-clockwise; all that there are of one or two.

hull(Points, Hull) :-
    sort(Points, Sorted),
    (   Sorted = [_,_,_|_]
    ->  half_hull(Sorted, Lower),
        reverse(Sorted, Backwards),
        half_hull(Backwards, Upper),
        append(Lower, Upper, Hull)
    ;   Hull = Sorted
    ).

%   Without its last point, which begins the other half.

half_hull(Points, Half) :-
    foldl(hulled, Points, [], [_|Half]).

hulled(C, [B,A|Rest], Hull) :-
    A = XA-YA,
    B = XB-YB,
    C = XC-YC,
    (XB-XA)*(YC-YA) - (YB-YA)*(XC-XA) =< 0,
    !,
    hulled(C, [A|Rest], Hull).
hulled(C, Points, [C|Points]).
