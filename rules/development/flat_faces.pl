:- module(sg_flat_faces,
          [ flat_faces_united/1         % +D
          ]).
:- use_module(bend_corner, [model_segment/2, polygon_of_edge/3]).
:- use_module('../csg/placed_surface', [facet_surface/3]).
:- use_module('../near', [is_bend/1]).
:- use_module('../store',
              [ e/5, from_p/5, joint/6, p/3, piece/3,
                assert_fact/1, retractall_facts/1
              ]).
:- use_module('../polygon/triangulation', [pattern_completed/1]).
:- use_module(library(apply), [maplist/2]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [member/2, subtract/3]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
:- use_module(library(ugraphs), [reachable/3, vertices_edges_to_ugraph/3]).
/** <module> The polygons of a flat face of a pattern, as one.

A mesh has a flat face as several triangles. What a bend takes off, and a corner
relief, are of the whole face.
*/

%!  flat_faces_united(+D) is det.
%
%   Polygons of pattern D that folds connect at which a plate stays flat,
%   is_bend/1, become one, of the smallest number. Facets of curved surfaces,
%   and a face that has a seam in itself, keep their polygons.

flat_faces_united(D) :-
    findall(flat(J, E1, E2, P1, P2), flat_fold(D, J, E1, E2, P1, P2), Flats),
    (   Flats == []
    ->  true
    ;   findall(P-Q,
                ( member(flat(_, _, _, P1, P2), Flats),
                  ( P = P1, Q = P2 ; P = P2, Q = P1 ) ),
                Pairs),
        vertices_edges_to_ugraph([], Pairs, Graph),
        face_polygons(Graph, Graph, Faces),
        findall(P-First,
                ( member([First|Ps], Faces), member(P, [First|Ps]) ),
                Firsts),
        list_to_assoc(Firsts, FaceOf),
        findall(First-inner(J, E1, E2),
                ( member(flat(J, E1, E2, P1, _), Flats),
                  get_assoc(P1, FaceOf, First) ),
                Inners0),
        keysort(Inners0, Inners1),
        group_pairs_by_key(Inners1, Inners),
        list_to_assoc(Inners, InnerOf),
        findall(First,
                ( joint(D, _, E1, E2, seam, _),
                  polygon_of_edge(D, E1, P1),
                  get_assoc(P1, FaceOf, First),
                  polygon_of_edge(D, E2, P2),
                  get_assoc(P2, FaceOf, First) ),
                Parted),
        maplist(face_united(D, InnerOf, Parted), Faces),
        pattern_completed(D)
    ).

flat_fold(D, J, E1, E2, P1, P2) :-
    joint(D, J, E1, E2, fold, Degrees),
    \+ is_bend(Degrees),
    polygon_of_edge(D, E1, P1),
    polygon_of_edge(D, E2, P2),
    P1 \== P2,
    model_segment(D, S),
    \+ facet_surface(S, P1, _),
    \+ facet_surface(S, P2, _).

%   face_polygons(Vertices, Graph, Faces): the connected components of Graph,
%   the vertices of each in order.

face_polygons([], _, []).
face_polygons([P-_|Vertices], Graph, Faces) :-
    reachable(P, Graph, Face),
    (   Face = [P|_]
    ->  Faces = [Face|Faces1]
    ;   Faces = Faces1
    ),
    face_polygons(Vertices, Graph, Faces1).

%   face_united(D, InnerOf, Parted, Face): the polygons Face are the first of
%   them, without the edges between them. It comes from all of them.

face_united(D, InnerOf, Parted, [First|Ps]) :-
    (   memberchk(First, Parted)
    ->  true
    ;   get_assoc(First, InnerOf, Inners),
        findall(E,
                ( member(P, [First|Ps]), once(p(D, P, Es0)), member(E, Es0) ),
                Es1),
        findall(E, ( member(inner(_, E1, E2), Inners), member(E, [E1,E2]) ),
                Gone),
        subtract(Es1, Gone, Es),
        findall(from_p(D, First, S, P0, Sense),
                ( member(P, [First|Ps]), source(D, P, S, P0, Sense) ),
                Sources),
        once(piece(D, First, K)),
        forall(member(P, [First|Ps]), polygon_gone(D, P)),
        assert_fact(p(D, First, Es)),
        assert_fact(piece(D, First, K)),
        forall(member(Source, Sources), assert_fact(Source)),
        forall(member(Inner, Inners), inner_gone(D, Inner))
    ).

source(D, P, S, P0, Sense) :-
    (   from_p(D, P, _, _, _)
    ->  from_p(D, P, S, P0, Sense)
    ;   model_segment(D, S),
        P0 = P,
        Sense = 1
    ).

polygon_gone(D, P) :-
    retractall_facts(t(D, P, _, _, _, _)),
    retractall_facts(plane(D, P, _, _, _, _)),
    retractall_facts(piece(D, P, _)),
    retractall_facts(from_p(D, P, _, _, _)),
    retractall_facts(p(D, P, _)).

%   inner_gone(D, Inner): nor is there what nothing but Inner ends at.

inner_gone(D, inner(J, E1, E2)) :-
    once(e(D, E1, A, B, _)),
    retractall_facts(joint(D, J, _, _, _, _)),
    forall(member(E, [E1,E2]),
           ( retractall_facts(origin(D, e(E), _)),
             retractall_facts(e(D, E, _, _, _)) )),
    forall(member(V, [A,B]), vertex_gone(D, V)).

vertex_gone(D, V) :-
    (   ( e(D, _, V, _, _) ; e(D, _, _, V, _) )
    ->  true
    ;   retractall_facts(from_v(D, V, _, _)),
        retractall_facts(v(D, V, _, _, _))
    ).
