:- module(sg_outline,
          [ outline_loops/4             % +Outline, +Holes, +Term, -Loops
          ]).
:- use_module('../kernel', [loops_are_sound/1]).
:- use_module(primitive_argument, [primitive_error/2]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3]).
:- use_module(library(lists), [append/3, last/2, member/2, nth1/3, reverse/2]).
/** <module> Polygons with holes in the plane, as primitives take them.

A loop is a list of X-Y of floats. Every decision is exact (rationals).
*/

%!  outline_loops(+Outline, +Holes, +Term, -Loops) is det.
%
%   Loops are Outline, counter-clockwise, and Holes, clockwise; either may be
%   given either way round.
%
%   @error model_error(primitive(What, Term)): few_points(Loop, N),
%   same_point(Loop, I), crossing(Loop1, I, Loop2, J) of edges that begin at
%   points I and J, hole_outside(Hole), hole_in_hole(Hole, Hole2). Loop is
%   `outline` or hole(N).

outline_loops(Outline, Holes, Term, [Loop|Loops]) :-
    named_holes(Holes, 1, Named),
    maplist(sound_loop(Term), [outline-Outline|Named]),
    (   loops_are_sound([Outline|Holes])
    ->  true
    ;   unsound([outline-Outline|Named], Term)
    ),
    turned_to(1, Outline, Loop),
    maplist(turned_to(-1), Holes, Loops).

named_holes([], _, []).
named_holes([Hole|Holes], N, [hole(N)-Hole|Named]) :-
    N1 is N+1,
    named_holes(Holes, N1, Named).

sound_loop(Term, Name-Points) :-
    length(Points, N),
    (   N < 3
    ->  primitive_error(few_points(Name, N), Term)
    ;   last(Points, Last),
        nth1(I, [Last|Points], Point),
        nth1(I, Points, Point)
    ->  primitive_error(same_point(Name, I), Term)
    ;   true
    ).

turned_to(Sign, Points, Loop) :-
    area2(Points, Area),
    (   Sign =:= sign(Area)
    ->  Loop = Points
    ;   reverse(Points, Loop)
    ).

%   area2(Points, Area): twice the signed area.

area2(Points, Area) :-
    last(Points, Last),
    foldl(trapezoid, Points, Last-0, _-Area).

trapezoid(X-Y, (X0-Y0)-Area0, (X-Y)-Area) :-
    Area is Area0 + rational(X0)*rational(Y) - rational(X)*rational(Y0).


%   unsound(Loops, Term): raises what is wrong, first of all. It has no answer
%   for sound loops: these are what loops_are_sound/1 is true of.

unsound(Loops, Term) :-
    Loops = [outline-Outline|Holes],
    no_crossing(Loops, Term),
    maplist(hole_place(Outline, Holes, Term), Holes),
    fail.


                /*******************************
                *           CROSSINGS          *
                *******************************/

%   no_crossing(Loops, Term): no two edges meet but neighbours at their common
%   point. A sweep over the edges, sorted by their least X.

no_crossing(Loops, Term) :-
    findall(edge(Low, High, A, B, Name, I, N),
            ( member(Name-Points, Loops),
              length(Points, N),
              loop_edge(Points, I, A, B),
              A = X1-_,
              B = X2-_,
              Low is min(X1, X2),
              High is max(X1, X2) ),
            Edges0),
    sort(0, @=<, Edges0, Edges),
    swept(Edges, Term).

loop_edge([First|Points], I, A, B) :-
    append([First|Points], [First], Round),
    step(Round, 1, I, A, B).

step([A, B|_], I, I, A, B).
step([_|Points], I0, I, A, B) :-
    I1 is I0+1,
    step(Points, I1, I, A, B).

swept([], _).
swept([Edge|Edges], Term) :-
    met_ahead(Edges, Edge, Term),
    swept(Edges, Term).

met_ahead([Edge2|Edges], Edge1, Term) :-
    arg(1, Edge2, Low),
    arg(2, Edge1, High),
    Low =< High,
    !,
    (   edges_meet(Edge1, Edge2)
    ->  crossing_error(Edge1, Edge2, Term)
    ;   true
    ),
    met_ahead(Edges, Edge1, Term).
met_ahead(_, _, _).

crossing_error(edge(_, _, _, _, Name1, I, _), edge(_, _, _, _, Name2, J, _),
               Term) :-
    msort([Name1-I, Name2-J], Pairs0),
    (   Pairs0 = [hole(_)-_, outline-_]
    ->  reverse(Pairs0, Pairs)
    ;   Pairs = Pairs0
    ),
    Pairs = [A-K, B-L],
    primitive_error(crossing(A, K, B, L), Term).

%   edges_meet(Edge1, Edge2): in more than the point of neighbours.

edges_meet(edge(_, _, A, B, Name, I, N), edge(_, _, C, D, Name, J, _)) :-
    (   J =:= I mod N + 1
    ->  Neighbours = [B, A, D]
    ;   I =:= J mod N + 1
    ->  Neighbours = [D, C, B]
    ;   fail
    ),
    !,
    folds_back(Neighbours).
edges_meet(edge(_, _, A, B, _, _, _), edge(_, _, C, D, _, _, _)) :-
    heights_meet(A, B, C, D),
    side(A, B, C, S1),
    side(A, B, D, S2),
    S1*S2 =< 0,
    side(C, D, A, S3),
    side(C, D, B, S4),
    S3*S4 =< 0.

%   heights_meet(...): where all four points are on one line the widths meet
%   already; of a vertical line the heights decide.

heights_meet(_-Y1, _-Y2, _-Y3, _-Y4) :-
    max(Y1, Y2) >= min(Y3, Y4),
    max(Y3, Y4) >= min(Y1, Y2).

folds_back([P, Q, R]) :-
    side(P, Q, R, 0),
    P = X0-Y0,
    Q = X1-Y1,
    R = X2-Y2,
    (rational(X1)-rational(X0))*(rational(X2)-rational(X0))
      + (rational(Y1)-rational(Y0))*(rational(Y2)-rational(Y0)) > 0.

%   side(A, B, C, Sign): 1 when C is left of the line from A to B.

side(X1-Y1, X2-Y2, X3-Y3, Sign) :-
    Sign is sign((rational(X2)-rational(X1))*(rational(Y3)-rational(Y1))
                 - (rational(Y2)-rational(Y1))*(rational(X3)-rational(X1))).


                /*******************************
                *             HOLES            *
                *******************************/

%   No edges meet: so one point of a hole says where all of it is.

hole_place(Outline, Named, Term, Name-Hole) :-
    Hole = [Point|_],
    (   \+ inside(Outline, Point)
    ->  primitive_error(hole_outside(Name), Term)
    ;   member(Name2-Hole2, Named),
        Name2 \== Name,
        inside(Hole2, Point)
    ->  primitive_error(hole_in_hole(Name, Name2), Term)
    ;   true
    ).

%   inside(Points, Point): a ray to the right crosses the loop oddly often.

inside(Points, Point) :-
    last(Points, Last),
    foldl(ray_crossed(Point), Points, Last-0, _-Count),
    Count mod 2 =:= 1.

ray_crossed(X-Y, X2-Y2, (X1-Y1)-Count0, (X2-Y2)-Count) :-
    (   Y1 =< Y, Y < Y2,
        side(X1-Y1, X2-Y2, X-Y, 1)
    ->  Count is Count0+1
    ;   Y2 =< Y, Y < Y1,
        side(X1-Y1, X2-Y2, X-Y, -1)
    ->  Count is Count0+1
    ;   Count = Count0
    ).
