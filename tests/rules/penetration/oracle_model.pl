:- module(sg_test_oracle_model,
          [ penetration_faults/1,       % -Faults
            model_faults/2,             % +Before, -Faults
            model_before/1,             % -Before
            model_fault/2               % +Before, -Fault
          ]).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(rules(exact)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(store)).
:- use_module(tests('rules/penetration/oracle')).

/** <module> A whole penetration against the oracle.

What is true before is kept as before(Segments, Lines); afterwards the world is
asked for anything that is not as it must be. All of it is exact: vertices are
where their origins say.
*/

%!  penetration_faults(-Faults) is det.
%
%   Penetrate the current world, whose segments have triangles; Faults is what
%   is wrong then, and before with what penetration_chains/3 says.

penetration_faults(Faults) :-
    model_before(Before),
    penetration_chains(all, [tolerance(0)], Chains),
    findall(Fault, chains_fault(Before, Chains, Fault), Faults1),
    penetrate(all, [tolerance(0)]),
    model_faults(Before, Faults2),
    append(Faults1, Faults2, Faults).

%   chains_fault(+Before, +Chains, -Fault): the lines before they enter anything
%   are the same points; a chain is closed that ends where it begins.

chains_fault(before(_, Lines), Chains, Fault) :-
    member(lines(S1, S2, Common, Alone), Lines),
    pairs_values(Common, Pieces),
    runs(Pieces, Oracle),
    findall(Kind-Points,
            ( member(chain(S1, S2, Kind, Points0, _), Chains),
              maplist(chain_point, Points0, Points) ),
            Own),
    findall(A-B, ( member(_-Points, Own), append(_, [A,B|_], Points) ),
            EnginePieces),
    findall(A, member(point-[A], Own), EngineAlone0),
    msort(EngineAlone0, EngineAlone),
    (   runs(EnginePieces, Engine),
        Engine \== Oracle,
        Fault = chains(S1, S2, oracle(Oracle), engine(Engine))
    ;   EngineAlone \== Alone,
        Fault = chains(S1, S2, oracle(Alone), engine(EngineAlone))
    ;   member(Kind-[First|Points], Own),
        Points \== [],
        last(Points, Last),
        \+ ( First == Last -> Kind == closed ; Kind == open ),
        Fault = chain_kind(S1, S2, Kind)
    ).

chain_point(point(_, _, _, Origin), Point) :-
    origin_point(Origin, Point).

%!  model_faults(+Before, -Faults) is det.
%
%   All solutions of model_fault/2.

model_faults(Before, Faults) :-
    findall(Fault, model_fault(Before, Fault), Faults).

%!  model_before(-Before) is det.
%
%   Before is before(Segments, Lines): segment(S, Leaves, Areas, Boundary) for
%   each segment, lines(S1, S2, Lines, Points) for each pair, Points those that
%   they have in common on no line.

model_before(before(Segments, Lines)) :-
    findall(segment(S, Leaves, Areas, Boundary),
            ( segment(S, _, _),
              leaves(S, Leaves),
              findall(P-Area, ( p(S, P, _), polygon_area(S, P, Area) ),
                      Areas),
              boundary(S, Boundary)
            ),
            Segments),
    findall(lines(S1, S2, Common, Alone),
            ( member(segment(S1, Leaves1, _, _), Segments),
              member(segment(S2, Leaves2, _, _), Segments),
              S1 < S2,
              common_lines(Leaves1, Leaves2, Common),
              common_points(Leaves1, Leaves2, Points),
              pairs_values(Common, Pieces),
              runs(Pieces, Runs),
              exclude(on_a_run(Runs), Points, Alone)
            ),
            Lines).

on_a_run(Runs, Point) :-
    once(run_point(Runs, Point, _)).

polygon_edges(S, P, Edges) :-
    p(S, P, Es),
    !,
    findall(A-B, ( member(E, Es), e(S, E, A, B, _) ), Edges).

polygon_area(S, P, Area) :-
    polygon_edges(S, P, Edges),
    maplist(placed(S), Edges, Placed),
    vector_area(Placed, Area).

placed(S, A-B, P-Q) :-
    at(S, A, P),
    at(S, B, Q).

%   Where a vertex is, and whether that could be told.

at(S, V, P) :-
    (   exact_vertex(S, V, P0)
    ->  P = P0
    ;   vertex_point(S, V, P)
    ).

%   The edges of polygons that have no opposite, as sets of points, those in
%   either direction apart: an edge divided on one side alone is among them.

boundary(S, Runs) :-
    findall(Edge, ( p(S, P, _), polygon_edges(S, P, Edges),
                    member(Edge, Edges) ),
            All),
    uncancelled(All, Alone),
    maplist(placed(S), Alone, Placed),
    directed_runs(Placed, Runs).

%   uncancelled(+Edges, -Rest): as many A-B as B-A are gone.

uncancelled(Edges, Rest) :-
    msort(Edges, Sorted),
    findall(B-A, member(A-B, Sorted), Opposites0),
    msort(Opposites0, Opposites),
    less(Sorted, Opposites, Rest).

less([], _, []).
less([E|Es], [], [E|Es]) :-
    !.
less([E|Es], [F|Fs], Rest) :-
    compare(Order, E, F),
    (   Order = (=)
    ->  less(Es, Fs, Rest)
    ;   Order = (<)
    ->  Rest = [E|Rest1],
        less(Es, [F|Fs], Rest1)
    ;   less([E|Es], Fs, Rest)
    ).

/* - - - faults - - - */

%!  model_fault(+Before, -Fault) is nondet.
%
%   Fault is one of
%
%     - place(S, V)
%       v/5 is not where its origin says, rounded to the nearest; or the
%       origin does not say; or vertex_exact/5 says something else
%     - lines(S1, S2, oracle(Runs), engine(Runs))
%       the lines are not the same points
%     - points(S1, S2, oracle(Points), engine(Points))
%       nor the contacts in a point alone
%     - line_not_in(L)
%       a piece is not in both polygons it names, or no edge there
%     - not_divided(S1, S2, Point), needlessly_divided(S1, S2, Point)
%       see needed/5
%     - area(S, P), turned(S, T), sides(S, P)
%       the triangles of a polygon do not cover what the polygon was; one is
%       turned over; their sides are not the edges of the polygon. A polygon
%       without area has no triangles.
%     - boundary(S)
%       an edge is divided in one polygon only, or has lost its opposite

model_fault(_, place(S, V)) :-
    v(S, V, X, Y, Z),
    \+ well_placed(S, V, p(X,Y,Z)).
model_fault(before(_, Lines), lines(S1, S2, oracle(Oracle), engine(Engine))) :-
    member(lines(S1, S2, Common, _), Lines),
    pairs_values(Common, Pieces),
    runs(Pieces, Oracle),
    engine_pieces(S1, S2, EnginePieces),
    runs(EnginePieces, Engine),
    Oracle \== Engine.
model_fault(before(_, Lines), points(S1, S2, oracle(Oracle), engine(Engine))) :-
    member(lines(S1, S2, _, Oracle), Lines),
    findall(A, ( line(_, S1, _, A1, A1, S2, _, _, _), at(S1, A1, A) ),
            Engine0),
    msort(Engine0, Engine),
    Oracle \== Engine.
model_fault(before(_, Lines), line_not_in(L)) :-
    line(L, S1, P1, A1, B1, S2, P2, A2, B2),
    A1 \== B1,
    \+ ( polygon_edge(S1, P1, A1, B1),
         polygon_edge(S2, P2, A2, B2),
         memberchk(lines(S1, S2, Common, _), Lines),
         findall(Piece, member(P1-P2-Piece, Common), Pieces),
         runs(Pieces, Runs),
         at(S1, A1, A),
         at(S1, B1, B),
         covers(Runs, A-B)
       ).
model_fault(Before, Fault) :-
    Before = before(_, Lines),
    member(lines(S1, S2, Common, _), Lines),
    end_fault(Before, S1, S2, Common, Fault).
model_fault(before(Segments, _), Fault) :-
    member(segment(S, _, Areas, _), Segments),
    member(P-Area, Areas),
    polygon_fault(S, P, Area, Fault).
model_fault(before(Segments, _), boundary(S)) :-
    member(segment(S, _, _, Before), Segments),
    boundary(S, After),
    Before \== After.

well_placed(S, V, p(Xf,Yf,Zf)) :-
    exact_vertex(S, V, p(X,Y,Z)),
    maplist(nearest, [Xf,Yf,Zf], [X,Y,Z]),
    vertex_exact(S, V, X, Y, Z).

%   No double is nearer to rational X than F. (SWI-Prolog 9.0's own float/1
%   does not take the even one of two that are equally near.)

nearest(F, X) :-
    Off is abs(rational(F)-X),
    (   Off =:= 0
    ->  true
    ;   Up is nexttoward(F, 1.0e300),
        Down is nexttoward(F, -1.0e300),
        abs(rational(Up)-X) >= Off,
        abs(rational(Down)-X) >= Off
    ).

engine_pieces(S1, S2, Pieces) :-
    findall(A-B,
            ( line(_, S1, _, A1, B1, S2, _, _, _),
              A1 \== B1,
              at(S1, A1, A),
              at(S1, B1, B)
            ),
            Pieces).

polygon_edge(S, P, A, B) :-
    polygon_edges(S, P, Edges),
    (   memberchk(A-B, Edges)
    ;   memberchk(B-A, Edges)
    ),
    !.

covers(Runs, A-B) :-
    runs([A-B], [Line-[From-To]]),
    memberchk(Line-Parts, Runs),
    member(Low-High, Parts),
    Low =< From,
    To =< High.

/* - - - ends - - - */

%   The lines of two segments end where they must, and, if these are the only
%   two, nowhere else.

end_fault(before(Segments, Lines), S1, S2, Common, Fault) :-
    pairs_values(Common, Pieces),
    runs(Pieces, Runs),
    findall(Point, ( member(A-B, Pieces), member(Point, [A,B]) ), Points0),
    sort(Points0, Points),
    engine_pieces(S1, S2, EnginePieces),
    findall(Point, ( member(A-B, EnginePieces), member(Point, [A,B]) ),
            Ends0),
    sort(Ends0, Ends),
    (   member(Point, Points),
        \+ memberchk(Point, Ends),
        needed(Segments, S1, S2, Runs, Point),
        Fault = not_divided(S1, S2, Point)
    ;   Lines = [_],
        member(Point, Ends),
        \+ needed(Segments, S1, S2, Runs, Point),
        Fault = needlessly_divided(S1, S2, Point)
    ).

%   needed(+Segments, +S1, +S2, +Runs, +Point): a line of S1 and S2 ends there,
%   or two meet, or it comes to a vertex or to another real edge of either.

needed(_, _, _, Runs, Point) :-
    run_point(Runs, Point, end(_)),
    !.
needed(_, _, _, Runs, Point) :-
    run_point(Runs, Point, inside(Line1)),
    run_point(Runs, Point, inside(Line2)),
    Line1 \== Line2,
    !.
needed(Segments, S1, S2, Runs, Point) :-
    run_point(Runs, Point, inside(Line)),
    member(S, [S1,S2]),
    memberchk(segment(S, Leaves, _, _), Segments),
    member(leaf(_, Triangle, Real, _, _), Leaves),
    member(edge(Corners, _), Real),
    nth1(1, Corners, I),
    nth1(2, Corners, J),
    arg(I, Triangle, A),
    arg(J, Triangle, B),
    runs([A-B], Edge),
    run_point(Edge, Point, How),
    How \== inside(Line),
    !.

/* - - - polygons - - - */

polygon_fault(_, _, v(0,0,0), _) :-
    !,
    fail.
polygon_fault(S, P, Area, Fault) :-
    findall(T-[A-B,B-C,C-A], t(S, P, T, A, B, C), Triangles),
    pairs_values(Triangles, Sides0),
    append(Sides0, Sides),
    polygon_edges(S, P, Edges),
    (   maplist(placed(S), Edges, PlacedEdges),
        vector_area(PlacedEdges, Area1),
        Area1 \== Area,
        Fault = area(S, P)
    ;   uncancelled(Sides, Border),
        uncancelled(Edges, Border1),
        Border \== Border1,
        Fault = sides(S, P)
    ;   msort(Sides, Sorted),
        sort(Sides, Set),
        member(Edge, Edges),
        ( Sorted \== Set ; \+ memberchk(Edge, Set) ),
        Fault = sides(S, P)
    ;   member(T-Triangle, Triangles),
        maplist(placed(S), Triangle, Placed),
        vector_area(Placed, Normal),
        \+ same_way(Normal, Area),
        Fault = turned(S, T)
    ).

%   Seen along the largest component of the polygon's area, as polygons are
%   that are flat only within the tolerance.

same_way(Normal, Area) :-
    Area = v(X,Y,Z),
    Largest is max(abs(X), max(abs(Y), abs(Z))),
    arg(I, Area, Seen),
    abs(Seen) =:= Largest,
    !,
    arg(I, Normal, Part),
    Seen*Part > 0.
