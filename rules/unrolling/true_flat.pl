:- module(sg_true_flat,
          [ flat_resized/3              % +S, +By, -S1
          ]).
:- use_module('../near', [is_on_surface/2]).
:- use_module('../store',
              [ e/5, p/3, plane/6, segment/3, v/5, edge_polygon/3,
                assert_fact/1, fresh_id/3
              ]).
:- use_module('../polygon/triangulation', [complete_segments/1]).
:- use_module(true_convex, [convex_resized/3]).
:- use_module('../vector',
              [difference/3, dot_product/3, scaled/3, unit/2, vector_sum/3]).
:- use_module(library(apply), [foldl/4]).
:- use_module(library(lists), [member/2]).
/** <module> The other surface of a plate with flat faces.

Each face goes outward by the same distance, and stays parallel; a vertex goes,
the shortest way, to where the planes of its faces have gone. That of an open
sheet that lies in one plane or two goes at right angles to these. Where more
than three faces meet, as in the apex of a pyramid, their planes may have no
point in common then: the corner parts, which is known of convex solids
(true_convex.pl). A face that is small may turn round.
*/

%!  flat_resized(+S, +By, -S1) is semidet.
%
%   S1 is a new segment: S, whose faces are all flat, with each By farther out
%   (model units; negative: within). Polygons and the term have their numbers
%   and names; so have vertices and edges, if no corner parts. Fails if there is
%   no such segment.

flat_resized(S, By, S1) :-
    findall(V-Place, ( v(S, V, _, _, _), vertex_moved(S, By, V, Place) ),
            Places),
    (   forall(v(S, V, _, _, _), memberchk(V-point(_,_,_), Places))
    ->  written(S, Places, S1)
    ;   convex_resized(S, By, S1),
        complete_segments([S1])
    ).

written(S, Places, S1) :-
    segment(S, Kind, Term),
    !,
    fresh_id(segment, 0, S1),
    assert_fact(segment(S1, Kind, Term)),
    forall(member(V-point(X,Y,Z), Places), assert_fact(v(S1, V, X, Y, Z))),
    forall(e(S, E, A, B, Et), assert_fact(e(S1, E, A, B, Et))),
    forall(p(S, P, Es), assert_fact(p(S1, P, Es))),
    edges_kept(S, S1),
    complete_segments([S1]).

%   edges_kept(S, S1): no edge turned round.

edges_kept(S, S1) :-
    \+ ( e(S, E, A, B, _),
         edge_way(S, A, B, Way0),
         e(S1, E, _, _, _),
         edge_way(S1, A, B, Way),
         dot_product(Way0, Way, Along),
         Along =< 0.0
       ).

edge_way(S, A, B, Way) :-
    v(S, A, X1, Y1, Z1),
    v(S, B, X2, Y2, Z2),
    !,
    difference(p(X2,Y2,Z2), p(X1,Y1,Z1), Way).

%   vertex_moved(S, By, V, Place): by the shortest way W with N*W = By for the
%   unit normals N of all faces at V.

vertex_moved(S, By, V, point(X,Y,Z)) :-
    v(S, V, X0, Y0, Z0),
    !,
    findall(Normal, normal_at(S, V, Normal), Normals0),
    sort(Normals0, Normals),
    foldl(plane_moved(By), Normals, moved(p(0.0,0.0,0.0), []),
          moved(p(DX,DY,DZ), _)),
    X is X0+DX,
    Y is Y0+DY,
    Z is Z0+DZ.

normal_at(S, V, Normal) :-
    e(S, E, V, _, _),
    edge_polygon(S, E, P),
    plane(S, P, A, B, C, _),
    unit(p(A,B,C), Normal).

%   plane_moved(By, Normal, Moved0, Moved): Moved is moved(Way, Basis), Basis
%   unit vectors at right angles that span the normals so far. What a normal has
%   besides them takes Way to its plane; if it has nothing, it must be there.

plane_moved(By, Normal, moved(Way0, Basis0), moved(Way, Basis)) :-
    foldl(less_along, Basis0, Normal, Rest),
    dot_product(Rest, Rest, Square),
    dot_product(Normal, Way0, Done),
    Left is By-Done,
    (   \+ is_on_surface(sqrt(Square), 1.0)
    ->  F is Left/Square,
        added(Way0, F, Rest, Way),
        G is 1.0/sqrt(Square),
        added(p(0.0,0.0,0.0), G, Rest, Unit),
        Basis = [Unit|Basis0]
    ;   is_on_surface(Left, abs(By)),
        Way = Way0,
        Basis = Basis0
    ).

less_along(Unit, Way0, Way) :-
    dot_product(Unit, Way0, Along),
    F is -Along,
    added(Way0, F, Unit, Way).

added(Way0, F, Normal, Way) :-
    scaled(F, Normal, More),
    vector_sum(Way0, More, Way).
