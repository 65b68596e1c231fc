:- module(sg_integrity,
          [ model_defect/1,             % ?Defect
            edge_uses/3,                % +S, ?Edge, -Uses
            segment_volume/2            % +S, -Volume
          ]).
:- use_module(store, [v/5, e/5, p/3, t/6, segment/3]).
:- autoload(library(aggregate), [aggregate_all/3]).
:- autoload(library(lists), [member/2]).
:- set_prolog_flag(optimise, true).
/** <module> What is wrong with a model.

A bad model is a relation, not an exception: model_defect/1 is true of every
defect, in a fixed order.
*/

%!  model_defect(?Defect) is nondet.
%
%   True when the current world has Defect, segment after segment:
%
%     - open_edge(S, V1, V2)
%       in a solid, an edge V1-V2 without its opposite (PL-1)
%     - non_manifold_edge(S, V1, V2, Uses)
%       more than two polygons use the edge, V1 < V2
%     - unpaired_edge(S, V1, V2)
%       two polygons run along it in the same direction: one is inside out
%     - degenerate_face(S, P)
%       polygon P has no triangles: it has no area
%     - inside_out(S)
%       the normals of the closed solid S point inward: its volume is negative

model_defect(Defect) :-
    segments(Ss),
    member(S, Ss),
    segment_defect(S, Defect).

segments(Ss) :-
    findall(S, segment(S, _, _), Ss0),
    sort(Ss0, Ss).

segment_defect(S, Defect) :-
    segment(S, Kind, _),
    Kind \== curve,
    Kind \== cells,
    edge_uses(S, V1-V2, Uses),
    edge_defect(Uses, Kind, S, V1, V2, Defect).
segment_defect(S, degenerate_face(S, P)) :-
    findall(P0, p(S, P0, _), Ps0),
    sort(Ps0, Ps),
    member(P, Ps),
    \+ t(S, P, _, _, _, _).
segment_defect(S, inside_out(S)) :-
    segment(S, solid, _),
    \+ ( edge_uses(S, _, uses(F, B)), F =\= B ),
    segment_volume(S, Volume),
    Volume < 0.0.

edge_defect(uses(1, 0), solid, S, V1, V2, open_edge(S, V1, V2)).
edge_defect(uses(0, 1), solid, S, V1, V2, open_edge(S, V2, V1)).
edge_defect(uses(2, 0), _, S, V1, V2, unpaired_edge(S, V1, V2)).
edge_defect(uses(0, 2), _, S, V1, V2, unpaired_edge(S, V2, V1)).
edge_defect(uses(F, B), _, S, V1, V2,
            non_manifold_edge(S, V1, V2, Uses)) :-
    Uses is F+B,
    Uses > 2.

%!  edge_uses(+S, ?Edge, -Uses) is nondet.
%
%   True when real edges of segment S join Edge = V1-V2, V1 < V2; Uses is
%   uses(F, B): F of them run from V1 to V2, B back. A seam (both edges of the
%   pair in one polygon) counts as one of each. In the order of V1, V2.

edge_uses(S, V1-V2, Uses) :-
    findall(key(A, B, D), edge_key(S, A, B, D), Keys0),
    msort(Keys0, Keys),
    edge_runs(Keys, Runs),
    member(run(V1-V2, Uses), Runs).

edge_key(S, A, B, D) :-
    e(S, _, V1, V2, 1),
    (   V1 < V2
    ->  A = V1,
        B = V2,
        D = 1
    ;   A = V2,
        B = V1,
        D = 2
    ).

edge_runs([], []).
edge_runs([key(A, B, D)|Keys], [run(A-B, uses(F, K))|Runs]) :-
    counted(D, 0, 0, F1, K1),
    edge_run(Keys, A, B, F1, K1, F, K, Rest),
    edge_runs(Rest, Runs).

edge_run([key(A, B, D)|Keys], A, B, F0, K0, F, K, Rest) :-
    !,
    counted(D, F0, K0, F1, K1),
    edge_run(Keys, A, B, F1, K1, F, K, Rest).
edge_run(Rest, _, _, F, K, F, K, Rest).

counted(1, F0, K, F, K) :-
    F is F0+1.
counted(2, F, K0, F, K) :-
    K is K0+1.

%!  segment_volume(+S, -Volume) is det.
%
%   Volume inside the triangles of segment S, rounded; of a closed solid it is
%   positive. Reckoned from its first vertex, so that a model far from the
%   origin loses no digits.

segment_volume(S, Volume) :-
    (   v(S, _, X0, Y0, Z0)
    ->  aggregate_all(sum(V), corner_volume(S, X0, Y0, Z0, V), Sum),
        Volume is Sum/6.0
    ;   Volume = 0.0
    ).

corner_volume(S, X0, Y0, Z0, V) :-
    t(S, _, _, A, B, C),
    v(S, A, XA, YA, ZA),
    v(S, B, XB, YB, ZB),
    v(S, C, XC, YC, ZC),
    X1 is XA-X0, Y1 is YA-Y0, Z1 is ZA-Z0,
    X2 is XB-X0, Y2 is YB-Y0, Z2 is ZB-Z0,
    X3 is XC-X0, Y3 is YC-Y0, Z3 is ZC-Z0,
    V is X1*(Y2*Z3-Z2*Y3) - Y1*(X2*Z3-Z2*X3) + Z1*(X2*Y3-Y2*X3).
