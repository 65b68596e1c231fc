:- module(sg_leaf_face,
          [ leaf_face/5,                % ?S, ?P, -Leaf, -Called, -What
            roots_alone_named/0
          ]).
:- use_module('../csg/csg', [root_segment/1, is_node/1]).
:- use_module('../csg/csg_roots', [roots_alone/0]).
:- use_module('../primitive/primitive_face', [face_of/3]).
:- use_module('../csg/provenance', [polygon_from/5]).
:- use_module('../store', [p/3, segment/3, origin/3, assert_fact/1]).
:- use_module(library(apply), [maplist/2]).
:- use_module(library(lists), [member/2]).
/** <module> What the polygons of a result are, of the leaves of its tree.

A polygon of a node's boundary comes from polygons of leaves (polygon_from/5),
and these are something of a primitive (face_of/3). When a root becomes a plain
segment its leaves are gone; then what its polygons were is remembered beside
them, and goes into model files:

    origin(S, p(P), faces([face(Leaf, Called, What), ...]))
*/

%!  leaf_face(?S, ?P, -Leaf, -Called, -What) is nondet.
%
%   True when polygon P of segment S has a part of what is What of leaf Leaf, a
%   segment; Called is the name that was given to it, or Leaf.

leaf_face(S, P, Leaf, Called, What) :-
    origin(S, p(P), faces(Faces)),
    member(face(Leaf, Called, What), Faces).
leaf_face(S, P, Leaf, Called, What) :-
    evaluated(S),
    polygon_of(S, P),
    faces_of(S, P, Faces),
    member(face(Leaf, Called, What), Faces).

evaluated(S) :-
    (   nonvar(S)
    ->  once(segment(S, _, _)),
        is_node(S)
    ;   segment(S, _, _),
        is_node(S)
    ).

polygon_of(S, P) :-
    (   integer(P)
    ->  once(p(S, P, _))
    ;   var(P)
    ->  p(S, P, _)
    ).

faces_of(S, P, Faces) :-
    findall(face(Leaf, Called, What),
            ( polygon_from(S, P, Leaf, P0, _),
              once(face_of(Leaf, P0, What)),
              called(Leaf, Called) ),
            Faces0),
    sort(Faces0, Faces).

called(Leaf, Called) :-
    (   segment(Leaf, _, Term),
        given_name(Term, Name)
    ->  Called = Name
    ;   Called = Leaf
    ).

given_name(named(Name, _), Name).
given_name(at(_, Term), Name) :-
    given_name(Term, Name).

%!  roots_alone_named is det.
%
%   As roots_alone/0, and what the polygons of the roots are stays known.

roots_alone_named :-
    findall(origin(S, p(P), faces(Faces)),
            ( root_segment(S),
              is_node(S),
              p(S, P, _),
              faces_of(S, P, Faces),
              Faces = [_|_] ),
            Facts),
    roots_alone,
    maplist(assert_fact, Facts).
