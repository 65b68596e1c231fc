:- module(sg_part_edges,
          [ parts_attached/3,           % +S, +Tolerance, -Changes
            edge_length/3               % +S, +E, -Length
          ]).
:- use_module('../kernel', [segment_borders/2]).
:- use_module('../solid/repair', [welded_vertex/2]).
:- use_module('../store',
              [ v/5, e/5, p/3, edge_polygon/3, assert_fact/1,
                retractall_facts/1, facts_transaction/1, fresh_id/3
              ]).
:- use_module('../polygon/triangulation', [complete_segments/1]).
:- use_module(library(apply), [foldl/4, maplist/2]).
:- use_module(library(assoc),
              [empty_assoc/1, get_assoc/3, put_assoc/4]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(pairs), [pairs_values/2]).
/** <module> Edges that attach to a part of another edge only (DV-5).

Models as they come often have polygons whose edge lies along a part of a longer
edge of the neighbour, or edges with vertices of their own in one place. Both
are borders then: nothing has a partner. Here such vertices become one, and such
edges are divided where vertices of others lie on them, so that parts attach to
parts.

Only borders are looked at: vertices at their ends, in boxes of space, so the
work is in proportion to the borders where vertices are about as far apart as
edges are long.

@see row DV-5; [DV] section 5.1, points 1, 2, 4 and 9 of figure 5
*/

%!  parts_attached(+S, +Tolerance, -Changes) is det.
%
%   Join what lies on each other along the borders of segment S, within
%   Tolerance (model units). Changes is changes(Welded, Divided): V-V0, vertex V
%   became V0, of each that did; E-Es, edge E was divided into Es, in order.
%   Parts are numbered after the largest edge; polygons keep their numbers, and
%   triangles of those that were divided get new ones. One transaction; callers
%   that want S as it was do this in a snapshot.

parts_attached(S, Tolerance, Changes) :-
    segment_borders(S, Borders),
    (   Borders == []
    ->  Changes = changes([], [])
    ;   facts_transaction(
            sg_part_edges:attached(S, Borders, Tolerance, Changes))
    ).

attached(S, Borders0, Tolerance, changes(Welded, Divided)) :-
    vertices_welded(S, Borders0, Tolerance, Welded),
    (   Welded == []
    ->  Borders = Borders0
    ;   segment_borders(S, Borders)
    ),
    edges_divided(S, Borders, Tolerance, Divided),
    (   Welded-Divided == []-[]
    ->  true
    ;   changed_polygons(S, Welded, Divided, Ps),
        forall(member(P, Ps),
               ( retractall_facts(t(S, P, _, _, _, _)),
                 retractall_facts(plane(S, P, _, _, _, _)) )),
        complete_segments([S])
    ).

changed_polygons(S, Welded, Divided, Ps) :-
    findall(P,
            ( member(_-[E|_], Divided),
              edge_polygon(S, E, P)
            ; member(_-V, Welded),
              ( e(S, E, V, _, _) ; e(S, E, _, V, _) ),
              edge_polygon(S, E, P)
            ),
            Ps0),
    sort(Ps0, Ps).

border_vertices(S, Borders, Vs) :-
    findall(V, ( member(E, Borders), e(S, E, A, B, _), member(V, [A,B]) ),
            Vs0),
    sort(Vs0, Vs).


                /*******************************
                *           VERTICES           *
                *******************************/

%   vertices_welded(S, Borders, Tolerance, Welded): ends of borders in one place
%   become the one with the smallest number. Ends of one edge never do.

vertices_welded(S, Borders, Tolerance, Welded) :-
    border_vertices(S, Borders, Vs),
    Size is max(Tolerance*1024, 1.0e-300),
    empty_assoc(None),
    foldl(vertex_first(S, Size, Tolerance), Vs, None-[], _-Welded0),
    findall(V-V0, ( member(V-V0, Welded0), \+ short_edge(S, V, V0) ), Welded),
    maplist(welded_vertex(S), Welded).

short_edge(S, V, W) :-
    (   e(S, _, V, W, _)
    ;   e(S, _, W, V, _)
    ),
    !.

%   vertex_first(S, Size, Tolerance, V, Boxes0-Welded0, Boxes-Welded): V is in
%   the place of one in Boxes0, or it is the first there. A vertex within the
%   tolerance of a side of its box is looked for beyond it as well.

vertex_first(S, Size, Tolerance, V, Boxes0-Welded0, Boxes-Welded) :-
    at(S, V, Place),
    (   box_of(Place, Size, Tolerance, Box),
        get_assoc(Box, Boxes0, Ws),
        member(W, Ws),
        at(S, W, There),
        distance(Place, There, Distance),
        Distance =< Tolerance
    ->  Boxes = Boxes0,
        Welded = [V-W|Welded0]
    ;   box_of(Place, Size, 0, Own)
    ->  (   get_assoc(Own, Boxes0, Others)
        ->  true
        ;   Others = []
        ),
        put_assoc(Own, Boxes0, [V|Others], Boxes),
        Welded = Welded0
    ).

box_of(at(X, Y, Z), Size, Tolerance, box(I, J, K)) :-
    box_along(X, Size, Tolerance, I),
    box_along(Y, Size, Tolerance, J),
    box_along(Z, Size, Tolerance, K).

box_along(X, Size, Tolerance, I) :-
    Low is floor((X-Tolerance)/Size),
    High is floor((X+Tolerance)/Size),
    between(Low, High, I).

at(S, V, at(X, Y, Z)) :-
    v(S, V, X, Y, Z),
    !.

%   Squares of lengths from here on have all their digits.

squared_from(1.0e-140).

%   distance(A, B, Distance): also where its square would be 0.

distance(at(X1, Y1, Z1), at(X2, Y2, Z2), Distance) :-
    Most is max(abs(X2-X1), max(abs(Y2-Y1), abs(Z2-Z1))),
    (   squared_from(Least),
        0 < Most, Most < Least
    ->  Distance is Most*sqrt(((X2-X1)/Most)**2 + ((Y2-Y1)/Most)**2 +
                              ((Z2-Z1)/Most)**2)
    ;   Distance is sqrt((X2-X1)**2 + (Y2-Y1)**2 + (Z2-Z1)**2)
    ).


                /*******************************
                *             EDGES            *
                *******************************/

%   edges_divided(S, Borders, Tolerance, Divided): where ends of other borders
%   lie on them. Boxes are as long as edges are in the mean.

edges_divided(S, Borders, Tolerance, Divided) :-
    mean_length(S, Borders, Mean),
    Size is max(Mean, Tolerance*4),
    border_vertices(S, Borders, Vs),
    empty_assoc(None),
    foldl(in_box(S, Size), Vs, None, Boxes),
    findall(E-On,
            ( member(E, Borders),
              vertices_on(S, E, Boxes, Size, Tolerance, On),
              On \== []
            ),
            Pairs),
    findall(E-Es, ( member(E-On, Pairs), edge_divided(S, E, On, Es) ),
            Divided).

mean_length(_, [], 1.0) :-
    !.
mean_length(S, Es, Mean) :-
    foldl(longer(S), Es, 0.0-0, Sum-N),
    Mean is Sum/N.

longer(S, E, Sum0-N0, Sum-N) :-
    edge_length(S, E, Length),
    Sum is Sum0+Length,
    N is N0+1.

%!  edge_length(+S, +E, -Length) is semidet.
%
%   Length, in model units, is that of edge E of segment S.

edge_length(S, E, Length) :-
    ends(S, E, A, B),
    distance(A, B, Length).

ends(S, E, A, B) :-
    e(S, E, V1, V2, _),
    !,
    at(S, V1, A),
    at(S, V2, B).

in_box(S, Size, V, Boxes0, Boxes) :-
    at(S, V, Place),
    once(box_of(Place, Size, 0, Box)),
    (   get_assoc(Box, Boxes0, Vs)
    ->  true
    ;   Vs = []
    ),
    put_assoc(Box, Boxes0, [V|Vs], Boxes).

%   vertices_on(S, E, Boxes, Size, Tolerance, On): the vertices in the middle of
%   E, from its start to its end.

vertices_on(S, E, Boxes, Size, Tolerance, On) :-
    e(S, E, V1, V2, _),
    !,
    at(S, V1, A),
    at(S, V2, B),
    findall(F-V,
            ( box_along_edge(A, B, Size, Tolerance, Box),
              get_assoc(Box, Boxes, Vs),
              member(V, Vs),
              V \== V1,
              V \== V2,
              at(S, V, Place),
              lies_on(Place, A, B, Tolerance, F)
            ),
            Pairs0),
    sort(Pairs0, Pairs),
    pairs_values(Pairs, On).

%   box_along_edge(A, B, Size, Tolerance, Box): the edge is cut into parts no
%   longer than a box, and the boxes of these are taken.

box_along_edge(A, B, Size, Tolerance, Box) :-
    distance(A, B, Length),
    N is max(1, ceiling(Length/Size)),
    findall(Box1,
            ( between(1, N, I),
              From is (I-1)/N,
              To is I/N,
              between_ends(A, B, From, C),
              between_ends(A, B, To, D),
              box_between(C, D, Size, Tolerance, Box1)
            ),
            Boxes0),
    sort(Boxes0, Boxes),
    member(Box, Boxes).

between_ends(at(X1, Y1, Z1), at(X2, Y2, Z2), F, at(X, Y, Z)) :-
    X is X1 + F*(X2-X1),
    Y is Y1 + F*(Y2-Y1),
    Z is Z1 + F*(Z2-Z1).

box_between(at(X1, Y1, Z1), at(X2, Y2, Z2), Size, Tolerance, box(I, J, K)) :-
    boxes_between(X1, X2, Size, Tolerance, I),
    boxes_between(Y1, Y2, Size, Tolerance, J),
    boxes_between(Z1, Z2, Size, Tolerance, K).

boxes_between(X1, X2, Size, Tolerance, I) :-
    Low is floor((min(X1, X2)-Tolerance)/Size),
    High is floor((max(X1, X2)+Tolerance)/Size),
    between(Low, High, I).

%   lies_on(Place, A, B, Tolerance, F): Place is within Tolerance of the edge
%   from A to B, at the fraction F of it, and farther from its ends.

lies_on(Place, A, B, Tolerance, F) :-
    Place = at(X, Y, Z),
    A = at(X1, Y1, Z1),
    B = at(X2, Y2, Z2),
    Square is (X2-X1)**2 + (Y2-Y1)**2 + (Z2-Z1)**2,
    Square > 0.0,
    F is ((X-X1)*(X2-X1) + (Y-Y1)*(Y2-Y1) + (Z-Z1)*(Z2-Z1))/Square,
    F > 0.0,
    F < 1.0,
    between_ends(A, B, F, Foot),
    distance(Place, Foot, Off),
    Off =< Tolerance,
    distance(Place, A, FromA),
    FromA > Tolerance,
    distance(Place, B, FromB),
    FromB > Tolerance.

%   edge_divided(S, E, On, Es): E becomes Es, from vertex to vertex, in its
%   polygons.

edge_divided(S, E, On, Es) :-
    e(S, E, V1, V2, Et),
    !,
    append([V1|On], [V2], Vs),
    new_edges(Vs, S, Et, Es),
    findall(P-Es0, ( edge_polygon(S, E, P), p(S, P, Es0) ), Polygons),
    forall(member(P-Es0, Polygons),
           ( append(Before, [E|After], Es0),
             append(Es, After, Es1),
             append(Before, Es1, Es2),
             retractall_facts(p(S, P, _)),
             assert_fact(p(S, P, Es2)) )),
    retractall_facts(e(S, E, _, _, _)).

new_edges([_], _, _, []) :-
    !.
new_edges([A,B|Vs], S, Et, [E|Es]) :-
    fresh_id(e, S, E),
    assert_fact(e(S, E, A, B, Et)),
    new_edges([B|Vs], S, Et, Es).
