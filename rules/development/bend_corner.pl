:- module(sg_bend_corner,
          [ polygon_corners/4,          % +D, +Offsets, +Es, -Corners
            corner_place/5,             % +D, +Offsets, +Corner, -X, -Y
            edge_inward/4,              % +D, +E, -NX, -NY
            list_to_first/2,            % +Pairs, -Table
            model_segment/2,            % +D, -S
            of_one_surface/3,           % +D, +E1, +E2
            polygon_of_edge/3           % +D, +E, -P
          ]).
:- use_module('../near', [is_straight/2]).
:- use_module('../csg/placed_surface', [facet_surface/3]).
:- use_module('../store', [e/5, edge_polygon/3, joint/6, segment/3, v/5]).
:- use_module(library(apply), [foldl/4]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(ordsets), [ord_memberchk/2]).
/** <module> The corners of a face that loses something at its bends.

The edges of a face move inward by what its bends take off (bend.pl), and its
corners go to where the moved lines meet. A hole that goes over a fold is a
chain of short edges; those that lie within what is taken off are left out.
*/

%!  polygon_corners(+D, +Offsets, +Es, -Corners) is det.
%
%   Corners are those of the polygon of the edges Es; one is corner(V, E1, E2,
%   Vs): E1 ends and E2 begins there, and Vs are its vertices, V among them:
%   more than one where edges of a border are taken off at a bend. Offsets is an
%   assoc from edges to how far they go inward.

polygon_corners(D, Offsets, Es, Corners) :-
    findall(A-E, ( member(E, Es), e(D, E, A, _, _) ), Outs),
    findall(B-E, ( member(E, Es), e(D, E, _, B, _) ), Ins),
    list_to_first(Ins, InTable),
    list_to_first(Outs, OutTable),
    findall(Corner,
            ( member(F, Es),
              get_assoc(F, Offsets, Half),
              Half > 0.0,
              corner_taken_off(D, F, Half, InTable, OutTable, Corner) ),
            Taken0),
    foldl(apart_from_others, Taken0, [], Taken),
    findall(V, ( member(corner(_, _, _, Vs), Taken), member(V, Vs) ), Gone0),
    sort(Gone0, Gone),
    findall(corner(V, E1, E2, [V]),
            ( member(V-E2, Outs),
              \+ ord_memberchk(V, Gone),
              get_assoc(V, InTable, E1) ),
            Kept),
    append(Taken, Kept, Corners).

%!  list_to_first(+Pairs, -Table) is det.
%
%   Table is an assoc from each key of Pairs to its first value.

list_to_first(Pairs0, Table) :-
    sort(1, @<, Pairs0, Pairs),
    list_to_assoc(Pairs, Table).

%   apart_from_others(Corner, Corners0, Corners): two that meet leave nothing
%   between them: only the first is taken off.

apart_from_others(Corner, Corners0, Corners) :-
    Corner = corner(_, _, _, Vs),
    (   member(corner(_, _, _, Others), Corners0),
        member(V, Vs),
        memberchk(V, Others)
    ->  Corners = Corners0
    ;   Corners = [Corner|Corners0]
    ).

%   corner_taken_off(D, F, Half, InTable, OutTable, Corner) is nondet: at an end
%   of the fold F. A hole that goes over a fold is a chain of short edges: those
%   of which no part is left beside the bend are left out.

corner_taken_off(D, F, Half, InTable, OutTable, Corner) :-
    e(D, F, A, B, _),
    edge_inward(D, F, NX, NY),
    v(D, A, X, Y, _),
    Line = line(X, Y, NX, NY, Half),
    (   left_out(D, from(OutTable), Line, B, Vs, E),
        Corner = corner(B, F, E, [B|Vs])
    ;   left_out(D, to(InTable), Line, A, Vs, E),
        Corner = corner(A, E, F, [A|Vs])
    ),
    Vs \== [].

%   left_out(D, Ends, Line, V, Vs, E): Vs are those after V on the border that
%   are nearer to the fold than Line, and E is the edge from the last of them.

left_out(D, Ends, Line, V, Vs, E) :-
    edge_at(Ends, D, V, E0, W),
    (   on_border(D, E0),
        nearer_than(Line, D, W),
        edge_at(Ends, D, W, E1, _),
        on_border(D, E1)
    ->  Vs = [W|Vs1],
        left_out(D, Ends, Line, W, Vs1, E)
    ;   Vs = [],
        E = E0
    ).

edge_at(from(Table), D, V, E, W) :-
    get_assoc(V, Table, E),
    once(e(D, E, _, W, _)).
edge_at(to(Table), D, V, E, W) :-
    get_assoc(V, Table, E),
    once(e(D, E, W, _, _)).

on_border(D, E) :-
    \+ joint(D, _, E, _, _, _),
    \+ joint(D, _, _, E, _, _).

nearer_than(line(X0, Y0, NX, NY, Half), D, W) :-
    v(D, W, X, Y, _),
    !,
    (X-X0)*NX + (Y-Y0)*NY < Half.

%!  corner_place(+D, +Offsets, +Corner, -X, -Y) is det.
%
%   Where the lines of the edges of Corner meet when they are moved inward.

corner_place(D, Offsets, corner(_, E1, E2, _), X, Y) :-
    edge_offset(Offsets, E1, D1),
    edge_offset(Offsets, E2, D2),
    once(e(D, E1, _, V1, _)),
    once(e(D, E2, V2, _, _)),
    once(v(D, V1, XA, YA, _)),
    once(v(D, V2, XB, YB, _)),
    (   D1 =:= 0.0,
        D2 =:= 0.0
    ->  X = XA,
        Y = YA
    ;   edge_inward(D, E1, X1, Y1),
        edge_inward(D, E2, X2, Y2),
        Cross is X1*Y2 - Y1*X2,
        (   \+ is_straight(Cross, 1.0)
        ->  Far is D2 + (XB-XA)*X2 + (YB-YA)*Y2,
            X is XA + (D1*Y2 - Far*Y1)/Cross,
            Y is YA + (X1*Far - X2*D1)/Cross
        ;   D1 =\= 0.0
        ->  X is XA + D1*X1,
            Y is YA + D1*Y1
        ;   X is XB + D2*X2,
            Y is YB + D2*Y2
        )
    ).

edge_offset(Offsets, E, Offset) :-
    (   get_assoc(E, Offsets, Offset)
    ->  true
    ;   Offset = 0.0
    ).


%!  edge_inward(+D, +E, -NX, -NY) is det.
%
%   The unit normal of edge E into its polygon, which lies on the left; (0, 0),
%   if E has no length.

edge_inward(D, E, NX, NY) :-
    e(D, E, A, B, _),
    v(D, A, X1, Y1, _),
    v(D, B, X2, Y2, _),
    Length is max(sqrt((X2-X1)**2 + (Y2-Y1)**2), 1.0e-300),
    NX is (Y1-Y2)/Length,
    NY is (X2-X1)/Length.

%!  model_segment(+D, -S) is det.
%
%   D is the pattern of segment S.

model_segment(D, S) :-
    (   segment(D, pattern, Term),
        memberchk(Term, [development(S0),true_development(S0, _)])
    ->  S = S0
    ;   S = D
    ).

%!  of_one_surface(+D, +E1, +E2) is semidet.
%
%   The polygons of edges E1 and E2 of pattern D are facets of one smooth
%   surface.

of_one_surface(D, E1, E2) :-
    model_segment(D, S),
    polygon_of_edge(D, E1, P1),
    polygon_of_edge(D, E2, P2),
    facet_surface(S, P1, Surface),
    facet_surface(S, P2, Surface).

%!  polygon_of_edge(+D, +E, -P) is det.
%
%   P is the polygon of edge E.

polygon_of_edge(D, E, P) :-
    once(edge_polygon(D, E, P)).
