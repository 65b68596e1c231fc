:- module(sg_glue_left,
          [ operand_gone/3,             % +S, +Tolerance, +N
            made_first/4,               % +S, +N, +Reach, +Merging
            made_vertices/2             % +S, -Vs
          ]).
:- use_module(faces, [faces_merged/2]).
:- use_module('../kernel',
              [ cell_completed/7, regions_joined/3, segment_grain/2,
                segments_tolerance/3, solid_close/1, solid_take/2
              ]).
:- use_module('../near', [tolerance/2]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [ v/5, e/5, p/3, plane/6, edge_polygon/3, from_p/5, from_v/4,
                lies_in/3, origin/3, sides/4, assert_fact/1, retractall_facts/1
              ]).
:- use_module('../vector', [difference/3, dot_product/3]).
:- use_module(library(apply), [maplist/2, maplist/3, partition/4]).
:- use_module(library(lists), [member/2, min_member/2]).
:- use_module(library(ordsets), [ord_disjoint/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> A glue without one of its operands: only what is near it changes.

What only the operand had goes, and what it shares with others stays theirs.
Where a polygon goes the regions on its two sides become one; nothing else of
space changes. So the rows are those of the glue of the others, but for ids: if
nothing of the others was divided where the operand met them. What was divided
there shows as parts in one plane, or one line, that nothing else keeps apart.

A polygon, or a vertex, of several operands has the rows that the first of them
gave it (made_first/4).
*/

%!  operand_gone(+S, +Tolerance, +N) is semidet.
%
%   Take what segment N gave the glue S out of its rows; N itself is not looked
%   at. Fails where more than that would change; then rows may have changed.
%   Call it in a transaction.

operand_gone(S, Tolerance, N) :-
    \+ lies_in(S, _, _),
    segment_grain(S, Grain),
    Grain =:= 0,
    segments_tolerance([S], Reach, _),
    findall(P, from_p(S, P, N, _, _), Ps0),
    sort(Ps0, Ps),
    Ps \== [],
    merging(Tolerance, Reach, Near, Merging),
    inherited(S, N, Near, Merging, Ps),
    findall(P, from_p(S, P, N, _, _), Now0),
    sort(Now0, Now),
    partition(has_alone(S, N), Now, Alone, Shared),
    findall(A-B, ( member(P, Now), polygon_side(S, P, A, B) ), Sides0),
    sort(Sides0, Sides),
    findall(V, ( member(A-B, Sides), ( V = A ; V = B ) ), Vs0),
    sort(Vs0, Vs),
    made_vertices(S, Made),
    ord_disjoint(Vs, Made),
    stage(regions, regions_joined(S, N, Alone)),
    forall(member(P, Shared), retractall_facts(from_p(S, P, N, _, _))),
    maplist(polygon_dropped(S), Alone),
    maplist(vertex_left(S, N), Vs),
    \+ ( member(A-B, Sides), parted_side(S, A, B) ),
    \+ ( member(V, Vs), parted_line(S, V) ),
    same_reach(Tolerance, S, Reach).

%!  made_vertices(+S, -Vs:list) is det.
%
%   Vs are the vertices of segment S that a cut made, ascending: where they are
%   exactly v/5 does not say.

made_vertices(S, Vs) :-
    findall(V, origin(S, v(V), _), Vs0),
    sort(Vs0, Vs).

merging(default, Reach, Reach, own(Reach)) :-
    !.
merging(Tolerance, _, Tolerance, Tolerance).

%   same_reach(Tolerance, S, Reach): what is near is what it was before.

same_reach(default, S, Reach) :-
    !,
    segments_tolerance([S], Now, _),
    Now =:= Reach.
same_reach(_, _, _).

has_alone(S, N, P) :-
    \+ ( from_p(S, P, M, _, _), M =\= N ).

%   polygon_side(S, P, A, B): an edge of P runs between the vertices A < B.

polygon_side(S, P, A, B) :-
    p(S, P, Es),
    member(E, Es),
    e(S, E, V, W, _),
    A is min(V, W),
    B is max(V, W).

polygon_dropped(S, P) :-
    p(S, P, Es),
    retractall_facts(p(S, P, _)),
    forall(member(E, Es), retractall_facts(e(S, E, _, _, _))).

%   vertex_left(S, N, V): V goes if no edge is left there; else it was a vertex
%   of the first of those that have it.

vertex_left(S, N, V) :-
    (   \+ e(S, _, V, _, _)
    ->  retractall_facts(v(S, V, _, _, _))
    ;   from_v(S, V, N, _)
    ->  vertex_operands(S, V, Ms),
        min_member(M, Ms),
        vertex_of(S, V, M)
    ;   true
    ).

vertex_operands(S, V, Ms) :-
    findall(M, ( polygon_at(S, V, P), from_p(S, P, M, _, _) ), Ms).

polygon_at(S, V, P) :-
    e(S, E, V, _, _),
    edge_polygon(S, E, P).

%   vertex_of(S, V, M): V was a vertex of operand M.

vertex_of(S, V, M) :-
    v(S, V, X, Y, Z),
    findall(V0,
            ( polygon_at(S, V, P), from_p(S, P, M, P0, _),
              p(M, P0, Es), member(E, Es), e(M, E, V0, _, _),
              v(M, V0, X0, Y0, Z0),
              X0 =:= X, Y0 =:= Y, Z0 =:= Z ),
            V0s),
    min_member(First, V0s),
    retractall_facts(from_v(S, V, _, _)),
    assert_fact(from_v(S, V, M, First)).

%   parted_side(S, A, B): two parts of an operand, in one plane, have an edge
%   between A and B, and nothing else has.

parted_side(S, A, B) :-
    findall(P,
            ( ( e(S, E, A, B, _) ; e(S, E, B, A, _) ),
              edge_polygon(S, E, P) ),
            [P,Q]),
    (   P =:= Q
    ->  true
    ;   from_p(S, P, M, _, _),
        from_p(S, Q, M, _, _),
        plane(S, P, A1, B1, C1, _),
        plane(S, Q, A2, B2, C2, _),
        tolerance(surface, Nearly),
        abs(A1*A2+B1*B2+C1*C2) > 1-Nearly
    ),
    !.

%   parted_line(S, V): only two edges, in one line, end in V.

parted_line(S, V) :-
    findall(W, ( e(S, _, V, W, _) ; e(S, _, W, V, _) ), Ws0),
    sort(Ws0, [A,B]),
    maplist(place(S), [A,V,B], [PA,PV,PB]),
    difference(PA, PV, DA),
    difference(PB, PV, DB),
    dot_product(DA, DB, Dot),
    dot_product(DA, DA, AA),
    dot_product(DB, DB, BB),
    tolerance(surface, Nearly),
    Dot < 0,
    Dot*Dot > AA*BB*(1-Nearly).

place(S, V, p(X,Y,Z)) :-
    v(S, V, X, Y, Z).


                /*******************************
                *            FIRST             *
                *******************************/

%   inherited(S, N, Reach, Merging, Ps): those of the polygons Ps that N gave,
%   and others have, get the rows that the first of these gives.

inherited(S, N, Reach, Merging, Ps) :-
    findall(Heir-P,
            ( member(P, Ps), heir(S, N, P, Heir) ),
            Pairs0),
    sort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    forall(member(Heir-Of, Groups),
           given_anew(S, Heir, Reach, Merging, Of)).

heir(S, N, P, Heir) :-
    findall(M, ( from_p(S, P, M, _, _), M =\= N ), Ms),
    min_member(Heir, Ms),
    N < Heir.

%!  made_first(+S, +N, +Reach, +Merging) is semidet.
%
%   Operand N of the glue S is the last one that was added: those of its
%   polygons and vertices that it shares with operands after it alone get the
%   rows that it gives.

made_first(S, N, Reach, Merging) :-
    findall(P, ( p(N, P0, _), from_p(S, P, N, P0, _) ), Ps0),
    sort(Ps0, Ps),
    findall(P,
            ( member(P, Ps),
              findall(M, from_p(S, P, M, _, _), Ms),
              sort(Ms, [N,_|_]) ),
            Firsts),
    (   Firsts == []
    ->  true
    ;   given_anew(S, N, Reach, Merging, Firsts),
        regions_joined(S, S, [])
    ),
    findall(V,
            ( p(N, P0, _), from_p(S, P, N, P0, _), polygon_side(S, P, A, B),
              ( V = A ; V = B ), from_v(S, V, M, _), N < M ),
            Vs0),
    sort(Vs0, Vs),
    forall(member(V, Vs), vertex_of(S, V, N)).

%   given_anew(S, Heir, Reach, Merging, Ps): the polygons Ps, of operand Heir
%   and others, get the rows that Heir gives, but keep their numbers: so regions
%   do.

given_anew(S, Heir, Reach, Merging, Ps) :-
    maplist(known_of(S), Ps, Known),
    findall(P0-P, ( member(P, Ps), from_p(S, P, Heir, P0, _) ), Was0),
    sort(Was0, Was),
    findall(V, ( member(P, Ps), polygon_side(S, P, A, B), ( V = A ; V = B ) ),
            Vs0),
    sort(Vs0, Vs),
    maplist(polygon_dropped(S), Ps),
    forall(( member(V, Vs), \+ e(S, _, V, _, _) ),
           retractall_facts(v(S, V, _, _, _))),
    made_vertices(S, Made),
    solid_take([Heir], Solid),
    call_cleanup(
        ( faces_merged(Solid,
                       [tolerance(Merging),origins(separate),cells(true)]),
          cell_completed(S, Heir, Solid, Reach, Made, Was, Faces)
        ),
        solid_close(Solid)),
    length(Ps, Faces),
    maplist(known_again(S, Heir), Known).

%   known_of(S, P, known(Below, Above, Sources)): Sources are of(M,P0,Sense).

known_of(S, P, known(Below, Above, Sources)) :-
    sides(S, P, Below, Above),
    findall(of(M,P0,Sense), from_p(S, P, M, P0, Sense), Sources).

known_again(S, Heir, known(Below, Above, Sources)) :-
    member(of(Heir,P0,Sense0), Sources),
    !,
    from_p(S, P, Heir, P0, Sense),
    \+ sides(S, P, _, _),
    !,
    Turned is Sense*Sense0,
    (   Turned =:= 1
    ->  assert_fact(sides(S, P, Below, Above))
    ;   assert_fact(sides(S, P, Above, Below))
    ),
    forall(( member(of(M,P1,Sense1), Sources), M =\= Heir ),
           ( Sense2 is Turned*Sense1,
             assert_fact(from_p(S, P, M, P1, Sense2)) )).
