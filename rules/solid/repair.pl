:- module(sg_repair,
          [ repair_operand/1,           % +S
            repaired/2,                 % +S, -Repairs
            welded_vertex/2             % +S, +Twin
          ]).
:- use_module('../kernel', [census/1]).
:- use_module('../store',
              [ v/5, e/5, p/3, segment/3, edge_polygon/3,
                assert_fact/1, retractall_facts/1, facts_transaction/1
              ]).
:- use_module('../polygon/triangulation', [complete_segments/0]).
:- use_module('../vocabulary', [shell_facets/2]).
:- use_module(library(apply), [maplist/2]).
:- use_module(library(error), [existence_error/2]).
:- use_module(library(lists), [member/2, reverse/2, subtract/3]).
/** <module> Mending a segment for a Boolean, only when that is asked for.

Each repair is a rule. None moves anything or closes a hole: vertices in exactly
one place become one, what then has no sides goes, what is there twice goes
once, and shells that are inside out are turned. What is still wrong afterwards
is said by operand_faults/2.

@see operand.pl
*/

%!  repair_operand(+S) is det.
%
%   Mend segment S; a warning is printed for each sort of repair. One
%   transaction.
%
%   @error existence_error(segment, S)

repair_operand(S) :-
    repaired(S, Repairs),
    forall(member(Repair, Repairs),
           print_message(warning, sanggwan(operand(Repair, S)))).

%!  repaired(+S, -Repairs:list) is det.
%
%   The same without warnings. Repairs says what was done, repaired(What, N), N
%   times, What one of
%
%     - welded
%       A vertex in the place of another: its edges are now those of the one
%       with the smallest number.
%     - no_area
%       A face whose edges cancel each other, there and back.
%     - duplicate
%       A face with the same directed edges as one of a smaller number.
%     - turned
%       A shell that is inside out: each if S as a whole is, else one that an
%       even number of others go round (so it is no hollow).

repaired(S, Repairs) :-
    (   segment(S, _, _)
    ->  true
    ;   existence_error(segment, S)
    ),
    facts_transaction(sg_repair:all_repaired(S, Repairs)).

all_repaired(S, Repairs) :-
    findall(repaired(What, N),
            ( member(What, [welded,no_area,duplicate,turned]),
              repair(What, S, N),
              N > 0 ),
            Repairs).

repair(welded, S, N) :-
    twins(S, Twins),
    maplist(welded_vertex(S), Twins),
    length(Twins, N).
repair(no_area, S, N) :-
    findall(P, cancelled_face(S, P), Ps),
    maplist(drop_face(S), Ps),
    length(Ps, N).
repair(duplicate, S, N) :-
    duplicates(S, Ps),
    maplist(drop_face(S), Ps),
    length(Ps, N).
repair(turned, S, N) :-
    complete_segments,
    turned_shells(S, Shells),
    maplist(turn_shell(S), Shells),
    complete_segments,
    length(Shells, N).

/* - - - vertices - - - */

%   twins(+S, -Twins): the V-First of vertices in one place, First the smallest.

twins(S, Twins) :-
    findall(at(X,Y,Z)-V, v(S, V, X, Y, Z), Vs0),
    msort(Vs0, Vs),
    same_places(Vs, Twins).

same_places([], []).
same_places([At-First|Vs], Twins) :-
    same_place(Vs, At, First, Twins, Twins1, Rest),
    same_places(Rest, Twins1).

same_place([At-V|Vs], At, First, [V-First|Twins], Twins1, Rest) :-
    !,
    same_place(Vs, At, First, Twins, Twins1, Rest).
same_place(Rest, _, _, Twins, Twins, Rest).

%!  welded_vertex(+S, +Twin) is det.
%
%   Twin is V-First: the edges of vertex V of segment S are now those of First,
%   and V is no more. Polygons lose the triangles that they had.

welded_vertex(S, V-First) :-
    findall(e(E,A,B,T), ( e(S, E, V, B, T), A = First ), From),
    maplist(replace_edge(S), From),
    findall(e(E,A,B,T), ( e(S, E, A, V, T), B = First ), To),
    maplist(replace_edge(S), To),
    retractall_facts(origin(S, v(V), _)),
    retractall_facts(v(S, V, _, _, _)).

%   An edge without length leaves its polygon; the triangles of that come anew.

replace_edge(S, e(E,A,B,T)) :-
    findall(P, edge_polygon(S, E, P), Ps),
    maplist(forget_triangles(S), Ps),
    retractall_facts(e(S, E, _, _, _)),
    (   A == B
    ->  maplist(without_edge(S, E), Ps)
    ;   assert_fact(e(S, E, A, B, T))
    ).

forget_triangles(S, P) :-
    retractall_facts(t(S, P, _, _, _, _)).

without_edge(S, E, P) :-
    p(S, P, Es0),
    !,
    subtract(Es0, [E], Es),
    retractall_facts(p(S, P, _)),
    assert_fact(p(S, P, Es)).

/* - - - faces - - - */

cancelled_face(S, P) :-
    p(S, P, Es),
    findall(A-B, ( member(E, Es), e(S, E, A, B, _) ), Edges0),
    findall(B-A, member(A-B, Edges0), Back0),
    msort(Edges0, Edges),
    msort(Back0, Edges).

duplicates(S, Ps) :-
    findall(Edges-P,
            ( p(S, P, Es),
              findall(A-B, ( member(E, Es), e(S, E, A, B, _) ), Edges0),
              msort(Edges0, Edges) ),
            Faces0),
    msort(Faces0, Faces),
    findall(P, later(Faces, P), Ps).

later([Edges-_,Edges-P|_], P).
later([_|Faces], P) :-
    later(Faces, P).

drop_face(S, P) :-
    p(S, P, Es),
    !,
    forget_triangles(S, P),
    retractall_facts(plane(S, P, _, _, _, _)),
    retractall_facts(p(S, P, _)),
    forall(member(E, Es),
           ( retractall_facts(e(S, E, _, _, _)),
             retractall_facts(origin(S, e(E), _)) )).

/* - - - shells - - - */

%   turned_shells(+S, -Ps): of each shell to be turned its lowest polygon. A
%   shell that is not closed has no inside.

turned_shells(S, Ps) :-
    census(Parts),
    (   memberchk(part(S, _, _, _, Volume, _, Shells, _), Parts)
    ->  findall(P,
                ( member(shell(P,_,_,_,_,true,_,_,Own,Depth), Shells),
                  inside_out(Volume, Own, Depth) ),
                Ps)
    ;   Ps = []
    ).

inside_out(Volume, _, _) :-
    Volume < 0.0,
    !.
inside_out(_, Own, Depth) :-
    Own < 0.0,
    Depth mod 2 =:= 0.

turn_shell(S, First) :-
    shell_facets(S-First, Facets),
    findall(P, member(_-P, Facets), Ps),
    maplist(turn_face(S), Ps).

turn_face(S, P) :-
    p(S, P, Es),
    !,
    forget_triangles(S, P),
    retractall_facts(plane(S, P, _, _, _, _)),
    forall(( member(E, Es), e(S, E, A, B, T) ),
           ( retractall_facts(e(S, E, _, _, _)),
             assert_fact(e(S, E, B, A, T)) )),
    reverse(Es, Back),
    retractall_facts(p(S, P, _)),
    assert_fact(p(S, P, Back)).
