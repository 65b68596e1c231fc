:- module(sg_exploded,
          [ cells_exploded/1,           % +Factor
            cells_parted/0,
            cells_parted/1,             % +S
            wire_seam/4,                % +S, -E, -A, -B
            faces_once/0,
            segment_exploded/3,         % +S, +Factor, -Parts
            region_copied/3             % +S, +R, -Ns
          ]).
:- use_module('../csg/csg_rows', [drop_boundary/1]).
:- use_module('../csg/known_surface',
              [facets_of/2, moved_surface/3, remember_facets/1]).
:- use_module('../polygon/triangulation', [complete_segments/1]).
:- use_module('../near', [tolerance/2]).
:- use_module(regions, [regions_made/2]).
:- use_module('../store',
              [ v/5, e/5, p/3, t/6, plane/6, edge_polygon/3, segment/3,
                region/3, sides/4, assert_fact/1, retractall_facts/1,
                facts_transaction/1, fresh_id/3
              ]).
:- use_module('../vector', [cross_product/3]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/2, maplist/3]).
:- use_module(library(lists), [append/2, append/3, member/2]).
/** <module> Exploded cells: each region moved out, to be seen.

Each cell becomes a solid of its own, region(S, R), moved away from the middle
of the model. Faces with one region on both sides go with it, as a surface; what
bounds no cell is a surface that stays where it is.
*/

%!  cells_exploded(+Factor) is det.
%
%   Instead of each segment S of kind `cells` there are its regions
%   (regions_made/2): the middle of the box of each is moved by Factor times the
%   way from the middle of the box of S. One transaction; what was made from S
%   goes with it.

cells_exploded(Factor) :-
    facts_transaction(
        ( forall(( segment(S, cells, _), \+ region(S, _, _) ),
                 regions_made(S, _)),
          forall(segment(S, cells, _), sg_exploded:exploded(S, Factor)) )).

exploded(S, Factor) :-
    segment_exploded(S, Factor, Parts),
    forall(member(part(N,_,_), Parts),
           retractall_facts(from_p(N, _, _, _, _))),
    drop_boundary(S),
    retractall_facts(segment(S, _, _)).

%!  cells_parted is det.
%
%   As cells_exploded/1 with 0, also of surfaces that bound cells, and of solids
%   that bound several. What bounds none is as of faces_once/0. One transaction.

cells_parted :-
    facts_transaction(
        ( forall(( segment(S, Kind, _), Kind \== curve,
                   \+ region(S, _, _) ),
                 regions_made(S, _)),
          forall(( segment(S, Kind, _), sg_exploded:has_cells(S, Kind) ),
                 sg_exploded:exploded(S, 0)),
          faces_once )).

has_cells(S, Kind) :-
    findall(R, region(S, R, cell), [_|Others]),
    (   Kind == solid
    ->  Others \== []
    ;   true
    ).

%!  cells_parted(+S) is det.
%
%   Of segment S alone: each of its cells is a solid, and what else there is
%   surfaces and curves. Edges that a wire alone made, in a face or between two
%   that would be one, are a curve too, so that they come again when all is
%   glued.

cells_parted(S) :-
    (   region(S, _, _)
    ->  true
    ;   regions_made(S, _)
    ),
    facts_transaction(( sg_exploded:seams_kept(S),
                        sg_exploded:exploded(S, 0) )).

seams_kept(S) :-
    findall(E-(A-B), wire_seam(S, E, A, B), Seams),
    curve_kept(S, seams(S), Seams, _).

%!  wire_seam(+S, -E, -A, -B) is nondet.
%
%   A wire alone keeps edge E, from vertex A to B: of the faces at it there are
%   two, or one from both sides, in one plane and between the same regions.

wire_seam(S, E, A, B) :-
    e(S, E, A, B, 1),
    A < B,
    edge_polygon(S, E, P),
    findall(E1-Q, page(S, A, B, E1, Q), Pages),
    Pages = [_,_],
    once(( member(E1-Q, Pages), E1 \== E )),
    (   Q == P
    ->  true
    ;   once(( E1 > E ; e(S, E1, B, A, _) )),
        sides(S, P, Below, Above),
        once(( sides(S, Q, Below, Above) ; sides(S, Q, Above, Below) )),
        in_one_plane(S, P, Q)
    ).

page(S, A, B, E, P) :-
    ( e(S, E, A, B, _) ; e(S, E, B, A, _) ),
    edge_polygon(S, E, P).

in_one_plane(S, P, Q) :-
    maplist(a_normal(S), [P,Q], [N1,N2]),
    cross_product(N1, N2, p(X,Y,Z)),
    tolerance(rounding, Near),
    abs(X)+abs(Y)+abs(Z) =< Near.

a_normal(S, P, N) :-
    once(plane(S, P, X, Y, Z, _)),
    N = p(X,Y,Z).

%!  faces_once is det.
%
%   Segments of kind `cells` become surfaces, which have each face once. One
%   transaction.

faces_once :-
    facts_transaction(
        forall(segment(S, cells, Name),
               ( retractall_facts(segment(S, _, _)),
                 assert_fact(segment(S, surface, Name)) ))).

%!  segment_exploded(+S, +Factor, -Parts:list) is det.
%
%   The same of segment S alone, which stays: Parts are part(N, Kind, R), where
%   N is a new segment of Kind. Of a solid or a surface from_p/5 says which
%   polygons of S it has; R is 0 of the wires. Call it in a transaction.

segment_exploded(S, Factor, Parts) :-
    findall(V, v(S, V, _, _, _), Vs),
    middle(S, Vs, Middle),
    findall(R-Role, region(S, R, Role), Regions),
    maplist(region_moved(S, Factor, Middle), Regions, Lists),
    wires_kept(S, Wires),
    append([Wires|Lists], Parts),
    findall(N, member(part(N,_,_), Parts), Ns),
    complete_segments(Ns).

%!  region_copied(+S, +R, -Ns:list) is det.
%
%   The cell R of segment S once more: the first of the new segments Ns is a
%   solid, another one the surface of the sheets in it. Call it in a
%   transaction.

region_copied(S, R, Ns) :-
    findall(V, v(S, V, _, _, _), Vs),
    middle(S, Vs, Middle),
    region_moved(S, 0.0, Middle, R-cell, Parts),
    findall(N, member(part(N,_,_), Parts), Ns),
    complete_segments(Ns).

middle(S, Vs, m(X, Y, Z)) :-
    aggregate_all(r(min(X0), max(X0), min(Y0), max(Y0), min(Z0), max(Z0)),
                  ( member(V, Vs), v(S, V, X0, Y0, Z0) ),
                  r(X1, X2, Y1, Y2, Z1, Z2)),
    X is (X1+X2)/2,
    Y is (Y1+Y2)/2,
    Z is (Z1+Z2)/2.

%   region_moved(S, Factor, Middle, R-Role, Parts)

region_moved(S, Factor, Middle, R-Role, Parts) :-
    findall(P-1, sides(S, P, R, R), Inner),
    (   Role == cell
    ->  findall(P-Sense, border(S, R, P, Sense), Borders),
        polygons_vertices(S, Borders, Vs),
        middle(S, Vs, Own),
        shift(Factor, Middle, Own, Shift),
        copied(S, R, Shift, solid, Borders, Solids),
        Sheets = Inner
    ;   Shift = m(0.0, 0.0, 0.0),
        Solids = [],
        findall(P-Sense, ( border(S, R, P, Sense), no_cell(S, P, R) ),
                Borders),
        append(Inner, Borders, Sheets)
    ),
    copied(S, R, Shift, surface, Sheets, Surfaces),
    append(Solids, Surfaces, Parts).

%   no_cell(S, P, R): beyond P is no cell either, and P is not one of those of
%   the region there.

no_cell(S, P, R) :-
    ( sides(S, P, R, Other) ; sides(S, P, Other, R) ),
    Other > R,
    region(S, Other, Role),
    Role \== cell,
    !.

border(S, R, P, 1) :-
    sides(S, P, R, Above),
    Above =\= R.
border(S, R, P, -1) :-
    sides(S, P, Below, R),
    Below =\= R.

shift(Factor, m(X0,Y0,Z0), m(X1,Y1,Z1), m(X,Y,Z)) :-
    X is Factor*(X1-X0),
    Y is Factor*(Y1-Y0),
    Z is Factor*(Z1-Z0).

polygons_vertices(S, Polygons, Vs) :-
    findall(V,
            ( member(P-_, Polygons),
              (   p(S, P, Es),
                  member(E, Es),
                  e(S, E, V, _, _)
              ;   t(S, P, _, A, B, C),
                  member(V, [A,B,C])
              ) ),
            Vs0),
    sort(Vs0, Vs).

%   copied(S, R, Shift, Kind, Polygons, Parts): a new segment has Polygons,
%   P-Sense, turned over where Sense is -1, moved by Shift; no Polygons, none.

copied(_, _, _, _, [], []) :-
    !.
copied(S, R, Shift, Kind, Polygons, [part(N,Kind,R)]) :-
    fresh_id(segment, 0, N),
    assert_fact(segment(N, Kind, region(S, R))),
    polygons_vertices(S, Polygons, Vs),
    maplist(vertex_copied(S, N, Shift), Vs),
    maplist(polygon_copied(S, N), Polygons),
    facets_of([N], Facets0),
    maplist(known_moved(Shift), Facets0, Facets),
    remember_facets(Facets).

known_moved(m(X,Y,Z), known(N,Surfaces0,Runs), known(N,Surfaces,Runs)) :-
    maplist(moved_surface([ [1.0,0.0,0.0,X],
                            [0.0,1.0,0.0,Y],
                            [0.0,0.0,1.0,Z]
                          ]),
            Surfaces0, Surfaces).

vertex_copied(S, N, m(DX,DY,DZ), V) :-
    v(S, V, X0, Y0, Z0),
    X is X0+DX,
    Y is Y0+DY,
    Z is Z0+DZ,
    assert_fact(v(N, V, X, Y, Z)).

polygon_copied(S, N, P-Sense) :-
    p(S, P, Es),
    forall(member(E, Es),
           ( e(S, E, V1, V2, Et),
             turned(Sense, V1, V2, A, B),
             assert_fact(e(N, E, A, B, Et)) )),
    assert_fact(p(N, P, Es)),
    assert_fact(from_p(N, P, S, P, Sense)),
    forall(t(S, P, T, A, B, C),
           ( turned(Sense, B, C, B1, C1),
             assert_fact(t(N, P, T, A, B1, C1)) )).

turned(1, A, B, A, B).
turned(-1, A, B, B, A).

%   wires_kept(S, Parts): edges of S without a polygon are a curve of their own.

wires_kept(S, Parts) :-
    findall(E-(V1-V2),
            ( e(S, E, V1, V2, 1),
              \+ edge_polygon(S, E, _) ),
            Wires),
    curve_kept(S, wires(S), Wires, Parts).

%   curve_kept(S, Name, Edges, Parts): edges E-(V1-V2) of S are a curve.

curve_kept(_, _, [], []) :-
    !.
curve_kept(S, Name, Edges, [part(N,curve,0)]) :-
    fresh_id(segment, 0, N),
    assert_fact(segment(N, curve, Name)),
    findall(V, ( member(_-(V1-V2), Edges), member(V, [V1,V2]) ), Vs0),
    sort(Vs0, Vs),
    maplist(vertex_copied(S, N, m(0.0,0.0,0.0)), Vs),
    forall(member(E-(V1-V2), Edges), assert_fact(e(N, E, V1, V2, 1))).
