:- module(sg_dxf_arc,
          [ ring_circle/2,              % +Points, -Circle
            arcs_found/4                % +Points, +Edges, +Among, -Corners
          ]).
:- use_module(library(lists), [append/3]).
:- use_module(library(ordsets), [ord_memberchk/2]).
/** <module> Arcs among the sides of a smooth outline.

The outline of a true pattern is a polyline within the chord tolerance. Where
its corners lie on a circle, up to the thousandths to which a sheet is
rounded, and are as close as such corners are, a circle is what was meant.
Reliefs of plates that are folded along straight edges have corners farther
apart; there it is known which edges may be part of an arc.

Points are X-Y, thousandths, y down.
*/

:- set_prolog_flag(optimise, true).

%   So far corners may be off, thousandths. Round says what may be an arc:
%   round(Sides, Long), so many sides at least, each so long at most, over the
%   radius. Reliefs have a corner each 5 degrees at least (corner_cut.pl).

most_off(2.0).

smooth_round(round(12, 0.063)).
relief_round(round(3, 0.09)).

%!  ring_circle(+Points, -Circle) is semidet.
%
%   The closed polyline Points, whose last is its first, is circle(X-Y, R), in
%   thousandths.

ring_circle(Points, circle(X-Y, R)) :-
    Points = [First|_],
    append(Open, [First], Points),
    !,
    corner_term(Open, Corners, N),
    N >= 24,
    I is 1 + N//3,
    J is 1 + 2*N//3,
    circle_through(Corners, 1, I, J, Circle),
    \+ ( between(1, N, K), \+ near_circle(Corners, K, Circle) ),
    side_term(Points, Sides),
    N1 is N+1,
    smooth_round(round(_, Most)),
    close_sides(Sides, 1, N1, Circle, Most, Length),
    Circle = c(X0, Y0, R0),
    Length < 6.3*R0,
    X is round(X0),
    Y is round(-Y0),
    R is round(R0).

%!  arcs_found(+Points, +Edges, +Among, -Corners) is det.
%
%   Corners is a list of corner(Point, Edge, Bulge), one for the beginning of
%   each straight side or arc, in order, then end(Point): Edge is a list with
%   the edge that is there, or none; Bulge is 0, or of an arc the tangent of a
%   quarter of its angle, above zero to the left, as DXF has it. Among is `all`,
%   or the ordered set of the edges that may be sides of an arc.

arcs_found(Points, Edges, Among, Corners) :-
    corner_term(Points, Term, N),
    parts(1, N, Term, Points, Edges, Among, Corners).

parts(N, N, _, [Point], _, _, [end(Point)]) :-
    !.
parts(I, N, Term, [Point|Points], Edges, Among,
      [corner(Point,Edge,Bulge)|Corners]) :-
    (   Edges = [E|_]
    ->  Edge = [E]
    ;   Edge = []
    ),
    (   may_be_round(Among, Edges, I, N, End, Round),
        arc_from(Term, I, End, Round, J, Bulge)
    ->  true
    ;   J is I+1,
        Bulge = 0
    ),
    Sides is J-I-1,
    dropped(Sides, Points, Points1),
    By is J-I,
    dropped(By, Edges, Edges1),
    parts(J, N, Term, Points1, Edges1, Among, Corners).

%   may_be_round(Among, Edges, I, N, End, Round): from corner I to End.

may_be_round(all, _, _, N, N, Round) :-
    !,
    smooth_round(Round).
may_be_round(Among, [E|Edges], I, N, End, Round) :-
    ord_memberchk(E, Among),
    relief_round(Round),
    I1 is I+1,
    run_end(Edges, Among, I1, N, End).

run_end([E|Edges], Among, I, N, End) :-
    I < N,
    ord_memberchk(E, Among),
    !,
    I1 is I+1,
    run_end(Edges, Among, I1, N, End).
run_end(_, _, I, _, I).

dropped(0, List, List) :-
    !.
dropped(_, [], []) :-
    !.
dropped(N, [_|List0], List) :-
    N1 is N-1,
    dropped(N1, List0, List).

corner_term(Points, Term, N) :-
    length(Points, N),
    compound_name_arguments(Term, corners, Points).

side_term(Points, Term) :-
    compound_name_arguments(Term, corners, Points).

%   arc_from(Term, I, N, Round, J, Bulge): the longest arc from corner I; by
%   doubling, and then by halves.

arc_from(Term, I, N, round(Least, Most), J, Bulge) :-
    J0 is I+Least,
    J0 =< N,
    on_arc(Term, I, J0, Most, _),
    doubled(Term, I, N, Most, Least, Good, Bad),
    halved(Term, I, Most, Good, Bad, Sides),
    J is I+Sides,
    on_arc(Term, I, J, Most, Bulge).

doubled(Term, I, N, Long, Good0, Good, Bad) :-
    Most is N-I,
    Next is min(Most, 2*Good0),
    (   Good0 =:= Most
    ->  Good = Good0,
        Bad is Good0+1
    ;   J is I+Next,
        on_arc(Term, I, J, Long, _)
    ->  doubled(Term, I, N, Long, Next, Good, Bad)
    ;   Good = Good0,
        Bad = Next
    ).

halved(_, _, _, Good, Bad, Good) :-
    Bad =:= Good+1,
    !.
halved(Term, I, Long, Good0, Bad0, Good) :-
    Middle is (Good0+Bad0)//2,
    J is I+Middle,
    (   on_arc(Term, I, J, Long, _)
    ->  halved(Term, I, Long, Middle, Bad0, Good)
    ;   halved(Term, I, Long, Good0, Middle, Good)
    ).

%   on_arc(Term, I, J, Long, Bulge): the corners from I to J lie on one arc.

on_arc(Term, I, J, Long, Bulge) :-
    M is (I+J)//2,
    circle_through(Term, I, M, J, Circle),
    \+ ( between(I, J, K), \+ near_circle(Term, K, Circle) ),
    close_sides(Term, I, J, Circle, Long, Length),
    Circle = c(_, _, R),
    Length < 6.0*R,
    corner(Term, I, XI, YI),
    corner(Term, J, XJ, YJ),
    corner(Term, M, XM, YM),
    Half is sqrt((XJ-XI)**2 + (YJ-YI)**2)/2.0,
    Half > 0.0,
    Off is sqrt(max(0.0, R*R - Half*Half)),
    (   Length > pi*R
    ->  Rise is R+Off
    ;   Rise is R-Off
    ),
    (   (XM-XI)*(YJ-YI) - (YM-YI)*(XJ-XI) > 0
    ->  Bulge is Rise/Half
    ;   Bulge is -Rise/Half
    ).

corner(Term, I, X, Y) :-
    arg(I, Term, X-Y0),
    Y is -Y0.

circle_through(Term, I, J, K, c(X, Y, R)) :-
    corner(Term, I, X1, Y1),
    corner(Term, J, X2, Y2),
    corner(Term, K, X3, Y3),
    A is X2-X1, B is Y2-Y1,
    C is X3-X1, D is Y3-Y1,
    Cross is 2*(A*D - B*C),
    Cross =\= 0,
    AB is A*A + B*B,
    CD is C*C + D*D,
    U is float(D*AB - B*CD)/Cross,
    V is float(A*CD - C*AB)/Cross,
    R is sqrt(U*U + V*V),
    X is X1+U,
    Y is Y1+V.

near_circle(Term, I, c(X0, Y0, R)) :-
    corner(Term, I, X, Y),
    most_off(Most),
    abs(sqrt((X-X0)**2 + (Y-Y0)**2) - R) =< Most.

%   close_sides(Term, I, J, Circle, Long, Length): all sides are short, Long
%   times the radius at most, and go the same way round; Length is that of all.

close_sides(Term, I, J, Circle, Long, Length) :-
    way_round(Term, I, Circle, Way),
    Circle = c(_, _, R),
    Most is Long*R,
    close_sides(I, J, Term, Circle, Way-Most, 0.0, Length).

close_sides(J, J, _, _, _, Length, Length) :-
    !.
close_sides(I, J, Term, Circle, Way-Most, Length0, Length) :-
    way_round(Term, I, Circle, Way),
    I1 is I+1,
    corner(Term, I, X1, Y1),
    corner(Term, I1, X2, Y2),
    Side is sqrt((X2-X1)**2 + (Y2-Y1)**2),
    Side =< Most,
    Length1 is Length0+Side,
    close_sides(I1, J, Term, Circle, Way-Most, Length1, Length).

way_round(Term, I, c(X0, Y0, _), Way) :-
    corner(Term, I, X1, Y1),
    I1 is I+1,
    corner(Term, I1, X2, Y2),
    (   (X1-X0)*(Y2-Y0) - (Y1-Y0)*(X2-X0) > 0
    ->  Way = left
    ;   Way = right
    ).
