:- module(sg_section_name,
          [ parts_named/3,              % -Names, +Parts0, -Parts
            named_strokes/3             % +Names, +Strokes0, -Strokes
          ]).
:- use_module('../sheet/stroke', [all_strokes/2]).
:- use_module('../store',
              [v/5, e/5, line/9, origin/3, from_p/5, edge_polygon/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [member/2, min_member/2, nth1/3]).
/** <module> What the lines of a section are in the model.

A line in the plane of a section lies in a face of the model, which the plane
cuts there: it has the number of that polygon. Any other line is an edge of the
model, or a part of one: it has the number of that. So who points at a line
learns what the model has there, though what is left of it has numbers of its
own.
*/

%!  parts_named(-Names, +Parts0, -Parts) is det.
%
%   Parts are Parts0, of section_seen/6, but for their edges: these are numbers
%   of Names, a term whose argument K says what edge K is in the model:
%   sides(S, Ps, Qs, Middle), polygons of S on its sides and a point of it; or
%   edge(E); or `none`, an outline.

parts_named(Names, Parts0, Parts) :-
    findall(of(S,N-E), member(part(_,_,S,N-E,_,_,_,_), Parts0), All0),
    sort(2, @<, All0, All),
    maplist(edge_sides(All), All, Sides),
    Names =.. [names|Sides],
    findall(Edge-K, nth1(K, All, of(_,Edge)), Pairs),
    list_to_assoc(Pairs, Numbers),
    maplist(part_named(Numbers, Names), Parts0, Parts).

part_named(Numbers, Names, part(V,Role,S0,Edge,F,T,A,B),
           part(V,Role,S,K,F,T,A,B)) :-
    get_assoc(Edge, Numbers, K),
    (   arg(K, Names, sides(S1,_,_,_))
    ->  S = S1
    ;   S = S0
    ).

%   edge_sides(All, Edge, Side): between two caps there is the face of another
%   segment, which is in this one.

edge_sides(All, of(S,N-E), Side) :-
    (   e(N, E, V1, V2, _)
    ->  sources(S, N, E, Ps),
        (   e(N, Twin, V2, V1, _)
        ->  sources(S, N, Twin, Qs)
        ;   Qs = []
        ),
        middle(N, V1, V2, Middle),
        (   Ps = [_|_]
        ->  Side = sides(S, Ps, Qs, Middle)
        ;   Qs = [_|_]
        ->  Side = sides(S, Qs, [], Middle)
        ;   origin(N, e(E), line(L)),
            line_face(L, N1, P1),
            memberchk(of(S1,N1-_), All),
            polygon_source(S1, N1, P1, P)
        ->  Side = sides(S1, [P], [], Middle)
        ;   Side = edge(E)              % of a curve
        )
    ;   Side = none
    ).

%   sources(S, N, E, Ps): polygons of S, of which the polygon of E has parts;
%   none of a cap.

sources(S, N, E, Ps) :-
    findall(P,
            ( edge_polygon(N, E, P0), polygon_source(S, N, P0, P) ),
            Ps).

polygon_source(S, N, P0, P) :-
    (   N == S
    ->  P = P0
    ;   from_p(N, P0, S, P, _)
    ).

line_face(L, N, P) :-
    line(L, N1, P1, _, _, N2, P2, _, _),
    ( N-P = N1-P1 ; N-P = N2-P2 ).

middle(N, V1, V2, p(X,Y,Z)) :-
    v(N, V1, X1, Y1, Z1),
    v(N, V2, X2, Y2, Z2),
    X is (X1+X2)/2,
    Y is (Y1+Y2)/2,
    Z is (Z1+Z2)/2.

%!  named_strokes(+Names, +Strokes0, -Strokes) is det.
%
%   Strokes are Strokes0, whose edges are numbers of Names, with numbers of the
%   current world, in which segments have cut each other: polygons, if their
%   role is `section`, else edges; 0 where it has no such one.

named_strokes(Names, Strokess, Strokes) :-
    all_strokes(Strokess, Strokes0),
    maplist(named_stroke(Names), Strokes0, Strokes).

named_stroke(Names, stroke(Visibility,Role,S,Ks,Points,Start,End),
             stroke(Visibility,Role,S,Edges,Points,Start,End)) :-
    maplist(named_edge(Role, Names), Ks, Edges).

named_edge(Role, Names, K, Edge) :-
    arg(K, Names, Side),
    (   side_name(Side, Role, Edge0)
    ->  Edge = Edge0
    ;   Edge = 0
    ).

side_name(edge(E), Role, E) :-
    Role \== section.
side_name(sides(_,Ps,_,_), section, P) :-
    !,
    Ps = [P|_].
side_name(sides(S,Ps,Qs,Middle), _, E) :-
    findall(Far-E0, edge_between(S, Ps, Qs, Middle, E0, Far), Fars),
    min_member(_-E, Fars).

%   edge_between(S, Ps, Qs, Middle, E, Far) is nondet: E has one of Ps on its
%   one side and, if there are any, one of Qs on the other; Middle is so far
%   from it, squared.

edge_between(S, Ps, Qs, Middle, E, Far) :-
    member(P, Ps),
    edge_polygon(S, E, P),
    e(S, E, V1, V2, _),
    (   e(S, Twin, V2, V1, _)
    ->  edge_polygon(S, Twin, Q),
        ( Qs == [] ; memberchk(Q, Qs) )
    ;   Qs == []
    ),
    away(S, V1, V2, Middle, Far).

away(S, V1, V2, p(X,Y,Z), Far) :-
    v(S, V1, X1, Y1, Z1),
    v(S, V2, X2, Y2, Z2),
    DX is X2-X1,
    DY is Y2-Y1,
    DZ is Z2-Z1,
    Along is DX*DX + DY*DY + DZ*DZ,
    (   Along > 0
    ->  At is max(0, min(1, ((X-X1)*DX + (Y-Y1)*DY + (Z-Z1)*DZ) / Along))
    ;   At = 0
    ),
    Far is (X1+At*DX-X)**2 + (Y1+At*DY-Y)**2 + (Z1+At*DZ-Z)**2.
