:- module(sg_test_penetration_fault,
          [ penetration_fault/1,        % -Fault
            edge_fault/1,               % -Fault
            line_fault/1,               % -Fault
            chain_fault/1,              % -Fault
            faults/1                    % -Faults
          ]).
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(rules(store)).
:- use_module(rules(penetration/chain)).
:- use_module(rules(exact)).
:- use_module(library(solution_sequences), [limit/2]).
/** <module> What must hold of every model that was penetrated. */

%!  penetration_fault(-Fault) is nondet.

penetration_fault(Fault) :- edge_fault(Fault).
penetration_fault(Fault) :- line_fault(Fault).
penetration_fault(Fault) :- area_fault(Fault).
penetration_fault(Fault) :- origin_fault(Fault).
penetration_fault(Fault) :- chain_fault(Fault).

%!  edge_fault(-Fault) is nondet.
%
%   In a solid every directed edge of a polygon is in that one alone, and has
%   exactly one opposite.

edge_fault(Fault) :-
    findall(S-(V1-V2),
            ( segment(S, Kind, _), Kind \== curve, p(S, _, Es),
              member(E, Es), e(S, E, V1, V2, _) ),
            Edges),
    msort(Edges, Sorted),
    (   append(_, [Edge,Edge|_], Sorted),
        Fault = twice(Edge)
    ;   member(S-(V1-V2), Edges),
        segment(S, solid, _),
        \+ ( e(S, E, V2, V1, _), p(S, _, Es), memberchk(E, Es) ),
        Fault = alone(S, V1, V2)
    ;   e(S, E, V1, V2, _),
        \+ segment(S, curve, _),
        \+ ( p(S, _, Es), memberchk(E, Es) ),
        Fault = unused(S, E, V1, V2)
    ).

%!  line_fault(-Fault) is nondet.
%
%   A piece is a real edge in both segments, at the same places. A contact in a
%   point alone is at no piece's end, in both its polygons or their planes.

line_fault(Fault) :-
    line(L, S1, P1, A, A, S2, P2, B, B),
    (   \+ same_place(S1, A, S2, B),
        Fault = elsewhere(L)
    ;   line(M, S1, _, A1, B1, S2, _, A2, B2),
        M \== L,
        ( memberchk(A, [A1,B1]) ; memberchk(B, [A2,B2]) ),
        Fault = not_alone(L, M)
    ;   member(S-P-V, [S1-P1-A,S2-P2-B]),
        \+ polygon_edge(S, P, V, _),
        \+ isolated_in(S, P, V),
        Fault = not_in(L, S, P)
    ).
line_fault(Fault) :-
    line(L, S1, P1, A1, B1, S2, P2, A2, B2),
    A1 \== B1,
    (   \+ edge_pair(S1, A1, B1),
        Fault = no_edge(L, S1)
    ;   \+ edge_pair(S2, A2, B2),
        Fault = no_edge(L, S2)
    ;   ( v(S1, A1, X, Y, Z), \+ v(S2, A2, X, Y, Z)
        ; v(S1, B1, X, Y, Z), \+ v(S2, B2, X, Y, Z)
        ),
        Fault = elsewhere(L)
    ;   \+ polygon_edge(S1, P1, A1, B1),
        Fault = not_in(L, S1, P1)
    ;   \+ polygon_edge(S2, P2, A2, B2),
        Fault = not_in(L, S2, P2)
    ).

same_place(S1, A, S2, B) :-
    vertex_exact(S1, A, X, Y, Z),
    vertex_exact(S2, B, X, Y, Z).

isolated_in(S, P, V) :-
    \+ e(S, _, V, _, _),
    v(S, V, X, Y, Z),
    plane(S, P, Nx, Ny, Nz, D),
    abs(X*Nx + Y*Ny + Z*Nz + D) < 1.0e-9*(1+abs(X)+abs(Y)+abs(Z)).

edge_pair(S, A, B) :-
    (   e(S, _, A, B, 1)
    ;   e(S, _, B, A, 1)
    ),
    !.

polygon_edge(S, P, A, B) :-
    (   e(S, E, A, B, _)
    ;   e(S, E, B, A, _)
    ),
    p(S, P, Es),
    memberchk(E, Es),
    !.

%   The triangles of a polygon cover it: both have the same vector area.

area_fault(area(S, P, Area, Sum)) :-
    p(S, P, Es),
    findall(C, ( member(E, Es), e(S, E, A, B, _), cross(S, A, B, C) ), Cs),
    vector_sum(Cs, Area),
    findall(C, ( t(S, P, _, V1, V2, V3),
                 member(A-B, [V1-V2,V2-V3,V3-V1]),
                 cross(S, A, B, C) ), Ts),
    vector_sum(Ts, Sum),
    \+ near(Area, Sum).
area_fault(turned(S, P, T)) :-
    t(S, P, T, V1, V2, V3),
    plane(S, P, Nx, Ny, Nz, _),
    findall(C, ( member(A-B, [V1-V2,V2-V3,V3-V1]), cross(S, A, B, C) ), Cs),
    vector_sum(Cs, v(X,Y,Z)),
    X*Nx + Y*Ny + Z*Nz =< 0.
area_fault(no_triangles(S, P)) :-
    p(S, P, _),
    \+ t(S, P, _, _, _, _).

cross(S, A, B, v(X,Y,Z)) :-
    v(S, A, X1, Y1, Z1),
    v(S, B, X2, Y2, Z2),
    X is Y1*Z2-Z1*Y2,
    Y is Z1*X2-X1*Z2,
    Z is X1*Y2-Y1*X2.

vector_sum(Vs, v(X,Y,Z)) :-
    aggregate_all(sum(A), member(v(A,_,_), Vs), X),
    aggregate_all(sum(A), member(v(_,A,_), Vs), Y),
    aggregate_all(sum(A), member(v(_,_,A), Vs), Z).

near(v(X1,Y1,Z1), v(X2,Y2,Z2)) :-
    abs(X1-X2) =< 1.0e-9,
    abs(Y1-Y2) =< 1.0e-9,
    abs(Z1-Z2) =< 1.0e-9.

%   Every vertex and edge that is an end of a line has an origin or was there.

origin_fault(no_place(S, V)) :-
    origin(S, v(V), _),
    \+ v(S, V, _, _, _).
origin_fault(no_edge(S, E)) :-
    origin(S, e(E), _),
    \+ e(S, E, _, _, _).
origin_fault(unused(S, V)) :-
    origin(S, v(V), _),
    \+ e(S, _, V, _, _),
    \+ line(_, S, _, V, V, _, _, _, _),
    \+ line(_, _, _, _, _, S, _, V, V).

%!  chain_fault(-Fault) is nondet.
%
%   The lines of a chain follow each other, and each line is in one chain.

chain_fault(chain(S1, S2, Lines)) :-
    chains(Chains),
    member(chain(S1, S2, Kind, Lines), Chains),
    (   chain_vertices(Lines, S1, Vs),
        chain_vertices(Lines, S2, _)
    ->  Vs = [First|_],
        last(Vs, Last),
        Kind == closed,
        First \== Last
    ;   true
    ).
chain_fault(count(N, M)) :-
    chains(Chains),
    aggregate_all(count,
                  ( member(chain(_,_,_,Lines), Chains), member(_, Lines) ),
                  N),
    aggregate_all(count, line(_,_,_,_,_,_,_,_,_), M),
    N =\= M.

%!  faults(-Faults) is det.
%
%   The first of them, no more than 5.

faults(Faults) :-
    findall(Fault, limit(5, penetration_fault(Fault)), Faults).
