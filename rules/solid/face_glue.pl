:- module(sg_face_glue,
          [ faces_joined/4              % +S, +P1, +P2, -Change
          ]).
:- use_module('../csg/csg_record', [drop_record/1]).
:- use_module('../csg/csg_rows', [drop_boundary/1]).
:- use_module('../gluing/cells_edit',
              [ cells_edited/3, edge_divided/4, polygon_gone/2,
                polygon_there/3, vertices_renamed/3 ]).
:- use_module('../gluing/contact_glue', [vertex_inside/3, vertices_between/5]).
:- use_module(glue, [glued_boundary/3]).
:- use_module('../polygon/triangulation', [complete_segments/1]).
:- use_module('../store',
              [ v/5, e/5, p/3, segment/3, from_p/5, lies_in/3, assert_fact/1,
                retractall_facts/1, fresh_id/3 ]).
:- use_module('../vocabulary', [facet_loops/2]).
:- use_module(library(apply), [maplist/2, maplist/3]).
:- use_module(library(lists), [append/2, append/3, member/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Glue of two faces in one plane (NG-4).

Each is cut by the other one, as surfaces are that are glued; what both have
is one face then. Borders come first: edges are divided where the other face's
border meets them, for all their pages, and vertices in one place are one. */

%!  faces_joined(+S, +P1, +P2, -Change) is det.
%
%   Glue the polygons P1 and P2 of the cells S in what they have in common.
%   Change is as of cells_edited/3; one transaction.
%
%   @error geometry_error(part_glue(not_glued(S, p(P1), p(P2), apart))): they
%          have no area in common; those of glued_boundary/3 and cells_edited/3

faces_joined(S, P1, P2, Change) :-
    cells_edited(S, sg_face_glue:faces_glued(S, P1, P2), Change).

faces_glued(S, P1, P2) :-
    maplist(face_alone(S), [P1,P2], [S1,S2]),
    complete_segments([S1,S2]),
    fresh_id(segment, 0, S3),
    assert_fact(segment(S3, cells, face)),
    glued_boundary([S1,S2], S3, []),
    (   from_p(S3, P, S1, _, _),
        from_p(S3, P, S2, _, _)
    ->  true
    ;   Fault = not_glued(S, p(P1), p(P2), apart),
        throw(error(geometry_error(part_glue(Fault)), _))
    ),
    polygons_vertices(S, [P1,P2], Own),
    findall(V3, v(S3, V3, _, _, _), Vs3),
    maplist(vertex_of(S, S3, Own), Vs3, Vs),
    polygons_vertices(S, [P1,P2], Both),
    findall(V,
            ( p(S3, P3, _), piece_from(S3, P3, S1), piece_from(S3, P3, S2),
              piece_loops(S, S3-P3, Vs, Both, Loops),
              member(Loop, Loops), member(V, Loop) ),
            Ends0),
    one_each(S, Ends0, Ends),
    borders_divided(S, [P1,P2], Vs, Ends),
    findall(V, ( member(P0, [P1,P2]), lies_in(S, v(V), p(P0)) ), Points),
    append(Points, Ends, Others),
    maplist(known_vertices(S, Others), [S1-P1,S2-P2], Known),
    maplist(sources(S), [S1-P1,S2-P2], Sources),
    maplist(polygon_gone(S), [P1,P2]),
    findall(P3, p(S3, P3, _), Ps3),
    maplist(piece_there(S, S3, Vs-Known, Sources), Ps3, Pieces),
    complete_segments([S]),
    forall(member(V, Points), point_loop_again(S, Pieces, V)),
    maplist(dropped, [S3,S1,S2]).

%   face_alone(S, P, S1): surface S1 has polygon P alone, with its numbers.

face_alone(S, P, S1) :-
    fresh_id(segment, 0, S1),
    assert_fact(segment(S1, surface, face)),
    polygons_vertices(S, [P], Vs),
    forall(( member(V, Vs), v(S, V, X, Y, Z) ),
           assert_fact(v(S1, V, X, Y, Z))),
    once(p(S, P, Es)),
    forall(( member(E, Es), e(S, E, A, B, Real) ),
           assert_fact(e(S1, E, A, B, Real))),
    assert_fact(p(S1, P, Es)).

polygons_vertices(S, Ps, Vs) :-
    findall(V, ( member(P, Ps), p(S, P, Es), member(E, Es), e(S, E, V, _, _) ),
            Vs0),
    sort(Vs0, Vs).

%   vertex_of(S, S3, Own, V3, V3-V): V is there in S; those of Own in its place
%   become V.

vertex_of(S, S3, Own, V3, V3-V) :-
    once(v(S3, V3, X, Y, Z)),
    findall(W, ( member(W, Own), v(S, W, X, Y, Z) ), Ws),
    (   Ws = [V|Others]
    ->  forall(member(W, Others), vertices_renamed(S, W, V))
    ;   fresh_id(v, S, V),
        assert_fact(v(S, V, X, Y, Z))
    ).

%   one_each(S, Vs0, Vs): of those of Vs0 that are in one place one is left.

one_each(S, Vs0, Vs) :-
    sort(Vs0, Vs1),
    findall(p(X,Y,Z)-V, ( member(V, Vs1), v(S, V, X, Y, Z) ), Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    findall(V, member(_-[V|_], Groups), Vs),
    forall(( member(_-[V|Others], Groups), member(W, Others) ),
           vertices_renamed(S, W, V)).

%   borders_divided(S, Ps, Vs3, Ends): the edges of Ps are divided where the
%   vertices of Vs3, or Ends, lie in them.

borders_divided(S, Ps, Vs3, Ends) :-
    findall(V, ( member(_-V, Vs3) ; member(V, Ends) ), Vs0),
    sort(Vs0, Vs),
    findall(A-B,
            ( member(P, Ps), p(S, P, Es), member(E, Es), e(S, E, A0, B0, _),
              A is min(A0, B0), B is max(A0, B0) ),
            Edges0),
    sort(Edges0, Edges),
    forall(member(A-B, Edges),
           ( vertices_between(S, A, B, Vs, Inner),
             divided(S, A, B, Inner) )).

divided(_, _, _, []).
divided(S, A, B, [V|Vs]) :-
    edge_divided(S, A, B, V),
    divided(S, V, B, Vs).

sources(S, S0-P, S0-From) :-
    findall(S1-P1-Sense, from_p(S, P, S1, P1, Sense), From).

%   known_vertices(S, Others, S0-P, S0-Vs): those of P, and the Others.

known_vertices(S, Others, S0-P, S0-Vs) :-
    polygons_vertices(S, [P], Border),
    append(Border, Others, Vs).

piece_from(S3, P3, S0) :-
    from_p(S3, P3, S0, _, _),
    !.

%   piece_there(S, S3, Vs-Known, Sources, P3, P): polygon P of S is P3 of S3.
%   Its edges end at all vertices that were Known of what it comes from: for
%   others a straight border may have some that a face alone does not need.

piece_there(S, S3, Vs-Known, Sources, P3, P) :-
    findall(V, ( member(S0-Known0, Known), piece_from(S3, P3, S0),
                 member(V, Known0) ), Through0),
    sort(Through0, Through),
    piece_loops(S, S3-P3, Vs, Through, Loops),
    polygon_there(S, Loops, P),
    forall(lies_in(S3, v(V3), p(P3)),
           ( renamed(Vs, V3, V), assert_fact(lies_in(S, v(V), p(P))) )),
    forall(( from_p(S3, P3, S0, _, Sense0), member(S0-From, Sources),
             member(S1-P1-Sense1, From) ),
           ( Sense is Sense0*Sense1,
             assert_fact(from_p(S, P, S1, P1, Sense)) )).

%   piece_loops(S, S3-P3, Vs, Through, Loops): its loops in vertices of S, also
%   those that they go Through.

piece_loops(S, S3-P3, Vs, Through, Loops) :-
    facet_loops(S3-P3, Loops3),
    maplist(maplist(renamed(Vs)), Loops3, Loops0),
    maplist(loop_through(S, Through), Loops0, Loops).

loop_through(S, Known, [First|Vs], Loop) :-
    append([First|Vs], [First], Path),
    findall([A|Inner],
            ( append(_, [A,B|_], Path),
              vertices_between(S, A, B, Known, Inner) ),
            Lists),
    append(Lists, Loop).

%   point_loop_again(S, Pieces, V): V, which was inside a face, is so again, or
%   in the border of a piece.

point_loop_again(S, Pieces, V) :-
    (   member(P, Pieces),
        vertex_inside(S, V, P)
    ->  (   lies_in(S, v(V), p(P))
        ->  true
        ;   assert_fact(lies_in(S, v(V), p(P)))
        )
    ;   true
    ).

renamed(Vs, V3, V) :-
    memberchk(V3-V, Vs).

dropped(S) :-
    drop_record(S),
    drop_boundary(S),
    retractall_facts(segment(S, _, _)).
