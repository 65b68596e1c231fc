:- module(sg_true_pattern,
          [ pattern_written/3           % +Term, +Pattern, -D
          ]).
:- use_module('../csg/placed_surface', [kept_answer/4]).
:- use_module('../near', [same_direction/2]).
:- use_module('../development/development_record', [drop_pattern/1]).
:- use_module('../store',
              [ e/5, p/3, plane/6, segment/3, v/5, assert_fact/1, fresh_id/3
              ]).
:- use_module('../polygon/triangulation', [pattern_completed/1]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [foldl/4, foldl/5, foldl/6, maplist/3]).
:- use_module(library(assoc),
              [ assoc_to_list/2, empty_assoc/1, get_assoc/3, list_to_assoc/2,
                put_assoc/4
              ]).
:- use_module(library(lists),
              [append/2, append/3, max_member/2, member/2, nth1/3, reverse/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> The rows of a true development.

A pattern is pattern(S, Bends, Facets, Points, Curves, Marks): of segment S;
Bends is `bent`, `smooth` or creases(List), List of T-Degrees: by what the plate
bends at the generators T between facets, positive a mountain. Facets and their
keys as in true_shape.pl, Points from keys to X-Y, Curves from Key1-Key2 to the
points between them, Marks as in true_layout.pl.

An edge of S that nothing divided keeps its number, and so does a polygon; what
is new is numbered after the largest of S. Each side of an edge knows its
partner by what its ends are in S, on whichever side of the seam they lie.
*/

%!  pattern_written(+Term, +Pattern, -D) is det.
%
%   D is the segment of kind `pattern` called Term, with the rows of Pattern and
%   no others.

pattern_written(Term, Pattern, D) :-
    Pattern = pattern(S, Bends, Facets0, Points, Curves, Marks),
    emptied(Term, D),
    assert_fact(segment(D, pattern, Term)),
    highest(p, S, P0),
    foldl(numbered_polygon, Facets0, Facets, P0, _),
    vertices_written(Points, S, D, Vertices, W0),
    curve_vertices(Curves, D, Inner, W0, W1),
    once_edges(Facets, Once),
    highest(e, S, E0),
    foldl(facet_written(D, Vertices, Inner, Once), Facets, Lists, E0, E1),
    maplist(parent_written(S, D), Facets0, Facets),
    append(Lists, Sides),
    known_bends(Bends, Facets, Known),
    joints_written(Sides, S, Known, D, Folds),
    pieces_written(Facets, Folds, D),
    pattern_completed(D),
    foldl(mark_written(D), Marks, E1-W1, _).

emptied(Term, D) :-
    (   segment(D, pattern, Term)
    ->  drop_pattern(D)
    ;   fresh_id(segment, 0, D)
    ).

%   highest(What, S, N): the largest number of an edge, or of a polygon, of S.

highest(What, S, N) :-
    kept_answer(highest_number, S, What, N).

highest_number(S, e, E) :-
    aggregate_all(max(E0), e(S, E0, _, _, _), E).
highest_number(S, p, P) :-
    aggregate_all(max(P0), p(S, P0, _), P).

%   numbered_polygon(Facet0, Facet, P0, P): a part gets a number of its own.

numbered_polygon(facet(P0, T1, T2, Halves), facet(P, T1, T2, Halves), Next0,
                 Next) :-
    (   integer(P0)
    ->  P = P0,
        Next = Next0
    ;   Next is Next0+1,
        P = Next
    ).

parent_written(S, D, facet(P0, _, _, _), facet(P, _, _, _)) :-
    (   P0 == P
    ->  true
    ;   whole(P0, Whole),
        assert_fact(from_p(D, P, S, Whole, 1))
    ).

whole(P0/_, P) :-
    !,
    whole(P0, P).
whole(P, P).


                /*******************************
                *           VERTICES           *
                *******************************/

vertices_written(Points, S, D, Vertices, W) :-
    assoc_to_list(Points, Pairs),
    foldl(vertex_written(S, D), Pairs, Numbered, 0, W),
    list_to_assoc(Numbered, Vertices).

vertex_written(S, D, Key-(X-Y), Key-W, W0, W) :-
    W is W0+1,
    assert_fact(v(D, W, X, Y, 0.0)),
    Key = k(Id, _),
    (   integer(Id)
    ->  assert_fact(from_v(D, W, S, Id))
    ;   true
    ).

%   curve_vertices(Curves, D, Inner, W0, W): Inner is an assoc from Key1-Key2 to
%   the numbers of the vertices between.

curve_vertices(Curves, D, Inner, W0, W) :-
    assoc_to_list(Curves, Pairs),
    foldl(curve_written(D), Pairs, Numbered, W0, W),
    list_to_assoc(Numbered, Inner).

curve_written(D, Edge-Points, Edge-Ws, W0, W) :-
    foldl(point_written(D), Points, Ws, W0, W).

point_written(D, X-Y, W, W0, W) :-
    W is W0+1,
    assert_fact(v(D, W, X, Y, 0.0)).


                /*******************************
                *            EDGES             *
                *******************************/

%   once_edges(Facets, Once): an assoc from the edges that are in one half-edge.

once_edges(Facets, Once) :-
    findall(E,
            ( member(facet(_, _, _, Halves), Facets),
              member(half(_, _, edge(E)), Halves) ),
            Es0),
    msort(Es0, Es),
    once_only(Es, Pairs),
    list_to_assoc(Pairs, Once).

once_only([], []).
once_only([E,E|Es0], Pairs) :-
    !,
    dropped(E, Es0, Es),
    once_only(Es, Pairs).
once_only([E|Es], [E-true|Pairs]) :-
    once_only(Es, Pairs).

dropped(E, [E|Es0], Es) :-
    !,
    dropped(E, Es0, Es).
dropped(_, Es, Es).

%   facet_written(D, Vertices, Inner, Once, Facet, Sides, E0, E): a side is
%   side(Id1-Id2, P, E, W1, W2): a half-edge of polygon P in the pattern, and
%   what its ends are in the segment.

facet_written(D, Vertices, Inner, Once, facet(P, _, _, Halves), Sides, E0, E) :-
    foldl(half_written(D, P, Vertices, Inner, Once), Halves, Lists, E0, E),
    append(Lists, Sides),
    findall(Edge, member(side(_, _, Edge, _, _), Sides), Es),
    assert_fact(p(D, P, Es)).

half_written(D, P, Vertices, Inner, Once, half(A, B, Label), Sides, E0, E) :-
    get_assoc(A, Vertices, W1),
    get_assoc(B, Vertices, W2),
    inner_vertices(A, B, Inner, Between),
    A = k(Id1, _),
    B = k(Id2, _),
    append([Id1-W1|Between], [Id2-W2], Way),
    (   Between == [],
        Label = edge(Edge),
        get_assoc(Edge, Once, _)
    ->  assert_fact(e(D, Edge, W1, W2, 1)),
        Sides = [side(Id1-Id2, P, Edge, W1, W2)],
        E = E0
    ;   sides_written(Way, D, P, Label, Sides, E0, E)
    ).

%   inner_vertices(A, B, Inner, Between): Id-W for those on the curve, Id the
%   same from either side.

inner_vertices(A, B, Inner, Between) :-
    A = k(Id1, _),
    B = k(Id2, _),
    (   A @< B
    ->  Edge = A-B,
        Ids = Id1-Id2
    ;   Edge = B-A,
        Ids = Id2-Id1
    ),
    (   get_assoc(Edge, Inner, Ws)
    ->  findall(inner(Ids, I)-W, nth1(I, Ws, W), Between0),
        (   A @< B
        ->  Between = Between0
        ;   reverse(Between0, Between)
        )
    ;   Between = []
    ).

sides_written([_], _, _, _, [], E, E).
sides_written([Id1-W1,Id2-W2|Way], D, P, Label,
              [side(Id1-Id2, P, E1, W1, W2)|Sides], E0, E) :-
    E1 is E0+1,
    assert_fact(e(D, E1, W1, W2, 1)),
    (   Label = edge(Edge)
    ->  assert_fact(origin(D, e(E1), e(Edge)))
    ;   true
    ),
    sides_written([Id2-W2|Way], D, P, Label, Sides, E1, E).


                /*******************************
                *            JOINTS            *
                *******************************/

%   joints_written(Sides, S, Bends, D, Folds): Folds is the list of P1-P2.

joints_written(Sides, S, Bends, D, Folds) :-
    empty_assoc(Open),
    foldl(side_joined(S, Bends, D), Sides, joints(Open, 1, []),
          joints(_, _, Folds)).

side_joined(S, Bends, D, Side, joints(Open0, J0, Folds0),
            joints(Open, J, Folds)) :-
    Side = side(Id1-Id2, P2, E2, _, _),
    (   get_assoc(Id2-Id1, Open0, [Partner|Rest])
    ->  Partner = side(_, P1, E1, _, _),
        joint_kind(Partner, Side, Kind),
        joint_angle(Bends, Kind, S, P1, P2, Angle),
        assert_fact(joint(D, J0, E1, E2, Kind, Angle)),
        J is J0+1,
        put_assoc(Id2-Id1, Open0, Rest, Open),
        (   Kind == fold
        ->  Folds = [P1-P2|Folds0]
        ;   Folds = Folds0
        )
    ;   (   get_assoc(Id1-Id2, Open0, Others)
        ->  true
        ;   Others = []
        ),
        append(Others, [Side], Sides),
        put_assoc(Id1-Id2, Open0, Sides, Open),
        J = J0,
        Folds = Folds0
    ).

joint_kind(side(_, P1, _, A, B), side(_, P2, _, C, D), Kind) :-
    (   A-B \== D-C
    ->  Kind = seam
    ;   P1 =:= P2
    ->  Kind = line
    ;   Kind = fold
    ).

%   known_bends(Bends, Facets, Known): of creases also where facets lie, an
%   assoc from polygons to T1-T2.

known_bends(Bends, Facets, Known) :-
    (   Bends = creases(Creases)
    ->  findall(P-(T1-T2), member(facet(P, T1, T2, _), Facets), Pairs),
        list_to_assoc(Pairs, Between),
        Known = creases(Creases, Between)
    ;   Known = Bends
    ).

%   joint_angle(Bends, Kind, S, P1, P2, Angle): the plate of what unrolls is
%   smooth; that of a transition bends between its facets, or pieces.

joint_angle(creases(Creases, Between), Kind, _, P1, P2, Angle) :-
    Kind \== line,
    get_assoc(P1, Between, From1-To1),
    get_assoc(P2, Between, From2-To2),
    (   same_direction(To1, From2)
    ->  T = To1
    ;   same_direction(To2, From1),
        T = To2
    ),
    member(T0-Angle, Creases),
    same_direction(T0, T),
    !.
joint_angle(bent, Kind, S, P1, P2, Angle) :-
    Kind \== line,
    plane(S, P1, A1, B1, C1, D1),
    plane(S, P2, A2, B2, C2, _),
    !,
    X is B1*C2 - C1*B2,
    Y is C1*A2 - A1*C2,
    Z is A1*B2 - B1*A2,
    Angle0 is atan2(sqrt(X*X + Y*Y + Z*Z), A1*A2 + B1*B2 + C1*C2)*180.0/pi,
    (   polygon_above(S, P2, plane(A1,B1,C1,D1))
    ->  Angle is 0.0 - Angle0
    ;   Angle = Angle0
    ).
joint_angle(_, _, _, _, _, 0.0).

%   polygon_above(S, P, Plane): its vertex that is farthest from Plane is above.

polygon_above(S, P, plane(A,B,C,D)) :-
    findall(Far-Off,
            ( p(S, P, Es),
              member(E, Es),
              e(S, E, V, _, _),
              v(S, V, X, Y, Z),
              Off is A*X + B*Y + C*Z + D,
              Far is abs(Off) ),
            Offs),
    max_member(_-Off, Offs),
    Off > 0.0.


                /*******************************
                *       PIECES AND MARKS       *
                *******************************/

%   pieces_written(Facets, Folds, D): polygons that folds join, directly or not,
%   are one piece; the pieces are numbered in the order of the polygons.

pieces_written(Facets, Folds, D) :-
    findall(P, member(facet(P, _, _, _), Facets), Ps0),
    msort(Ps0, Ps),
    findall(P-Q,
            ( member(A-B, Folds), ( P = A, Q = B ; P = B, Q = A ) ),
            Pairs),
    keysort(Pairs, Sorted),
    group_pairs_by_key(Sorted, Groups),
    list_to_assoc(Groups, Neighbours),
    empty_assoc(Seen),
    foldl(piece_from(D, Neighbours), Ps, 1-Seen, _).

piece_from(D, Neighbours, P, K0-Seen0, K-Seen) :-
    (   get_assoc(P, Seen0, _)
    ->  K-Seen = K0-Seen0
    ;   reached([P], D, K0, Neighbours, Seen0, Seen),
        K is K0+1
    ).

reached([], _, _, _, Seen, Seen).
reached([P|Ps0], D, K, Neighbours, Seen0, Seen) :-
    (   get_assoc(P, Seen0, _)
    ->  Ps = Ps0,
        Seen1 = Seen0
    ;   put_assoc(P, Seen0, K, Seen1),
        assert_fact(piece(D, P, K)),
        (   get_assoc(P, Neighbours, Qs)
        ->  append(Qs, Ps0, Ps)
        ;   Ps = Ps0
        )
    ),
    reached(Ps, D, K, Neighbours, Seen1, Seen).

%   mark_written(D, Mark, E0-W0, E-W): an auxiliary edge of no polygon.

mark_written(D, mark(Number, Degrees, Position, From, To, X1-Y1, X2-Y2),
             E0-W0, E-W) :-
    E is E0+1,
    W1 is W0+1,
    W is W0+2,
    assert_fact(v(D, W1, X1, Y1, 0.0)),
    assert_fact(v(D, W, X2, Y2, 0.0)),
    assert_fact(e(D, E, W1, W, 0)),
    assert_fact(origin(D, e(E),
                       generator(Number, Degrees, Position, From, To))).
