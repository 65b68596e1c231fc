:- module(sg_contact,
          [ vertex_place/4,             % +S, +V, ?P, -Place
            vertex_seats/3,             % +S, +V, -Seats
            contact_kind/3,             % +Place1, +Place2, -Kind
            line_end/4,                 % +L, ?End, -Seat1, -Seat2
            edge_part/4                 % +S, +E, -Root, -Way
          ]).
:- use_module('../store',
              [ e/5, t/6, leaf_v/5, leaf_e/5, origin/3, line/9,
                vertex_triangle/3
              ]).
:- use_module(library(lists), [member/2]).

/** <module> Which features touch in a point of a penetration line.

A point that segments share lies, in each of them, on the smallest feature
that holds it, its *place*:

    vertex(V)              a vertex that the model had before any cut
    edge(V1, V2)           inside the real edge between V1 and V2, V1 < V2
    face(P, Corners)       inside polygon P; Corners is triangle(A,B,C) or
                           diagonal(A,B): the part of its triangulation that
                           made the point; `none` where that was another's

Nothing is stored for this: origin/3 and the edges say it.

@see docs/internals/penetration.md
*/

%!  vertex_place(+S, +V, ?P, -Place) is semidet.
%
%   True when vertex V of segment S, seen from its polygon P, lies on Place. P
%   matters for faces only; unbound, it is found.

vertex_place(S, V, _, vertex(V)) :-
    \+ was_made(S, V),
    !.
vertex_place(S, V, _, edge(V1, V2)) :-
    part_at(S, V, E),
    edge_part(S, E, _, Start-End),
    !,
    V1 is min(Start, End),
    V2 is max(Start, End).
vertex_place(S, V, P, face(P, Corners)) :-
    vertex_polygon(S, V, P),
    !,
    face_corners(S, V, Corners).

%   was_made(+S, +V): V is no vertex of the model. One that was only moved, so
%   that it touches, is.

was_made(S, V) :-
    origin(S, v(V), Origin),
    !,
    (   Origin = near(_)
    ->  \+ leaf_v(S, V, _, _, _)
    ;   true
    ).

edge_at(S, V, E) :-
    e(S, E, V, _, 1).
edge_at(S, V, E) :-
    e(S, E, _, V, 1).

part_at(S, V, E) :-
    edge_at(S, V, E),
    origin(S, e(E), e(_)).

vertex_polygon(_, _, P) :-
    nonvar(P),
    !.
vertex_polygon(S, V, P) :-
    vertex_triangle(S, V, T),
    t(S, P, T, _, _, _).

face_corners(S, V, Corners) :-
    origin(S, v(V), Origin),
    Origin =.. [Made|Places],
    memberchk(Made, [lpi,ll,tpi]),
    member(S-Named, Places),
    !,
    (   Named = (A,B,C)
    ->  Corners = triangle(A, B, C)
    ;   Named = (A,B),
        Corners = diagonal(A, B)
    ).
face_corners(_, _, none).

%!  edge_part(+S, +E, -Root, -Way) is semidet.
%
%   True when edge E of S is a part of the edge Root of the model, which ran
%   the Way V1-V2 and was divided. Fails for an edge that is whole.

edge_part(S, E, Root, V1-V2) :-
    origin(S, e(E), e(Old)),
    edge_root(S, Old, Root),
    leaf_e(S, Root, V1, V2, _),
    !.

edge_root(S, E, Root) :-
    (   origin(S, e(E), e(Old))
    ->  edge_root(S, Old, Root)
    ;   Root = E
    ).

%!  vertex_seats(+S, +V, -Seats) is det.
%
%   Seats is the list of seat(S, V, Place), by segment, of the vertices that
%   are the same point: all those with the same origin, or that came from
%   vertex V of S.

vertex_seats(S, V, Seats) :-
    findall(S1-V1, same_point(S, V, S1, V1), Names0),
    sort([S-V|Names0], Names),
    findall(seat(S1, V1, Place),
            ( member(S1-V1, Names), vertex_place(S1, V1, _, Place) ),
            Seats).

%   One origin is one point, as is the vertex it names.

same_point(S, V, S1, V1) :-
    (   origin(S, v(V), Origin)
    ;   member(Origin, [v(S, V), near(v(S, V))])
    ),
    (   origin(S1, v(V1), Origin)
    ;   memberchk(Origin, [v(S1, V1), near(v(S1, V1))])
    ).

%!  line_end(+L, ?End, -Seat1, -Seat2) is nondet.
%
%   True when End, `start` or `end`, of line L is seat(S, V, Place) of its
%   first and of its second segment.

line_end(L, End, seat(S1, V1, Place1), seat(S2, V2, Place2)) :-
    line(L, S1, P1, A1, B1, S2, P2, A2, B2),
    member(End-V1-V2, [start-A1-A2, end-B1-B2]),
    vertex_place(S1, V1, P1, Place1),
    vertex_place(S2, V2, P2, Place2).

%!  contact_kind(+Place1, +Place2, -Kind) is det.
%
%   Kind names the pair of features, the smaller first: `vertex-vertex`,
%   `vertex-edge`, `vertex-face`, `edge-edge`, `edge-face`; `face-face` for a
%   point that a third segment, or another part of one of the two, has made.

contact_kind(Place1, Place2, Kind) :-
    functor(Place1, Name1, _),
    functor(Place2, Name2, _),
    kind(Name1, Name2, Kind),
    !.

kind(vertex, vertex, 'vertex-vertex').
kind(vertex, edge, 'vertex-edge').
kind(edge, vertex, 'vertex-edge').
kind(vertex, face, 'vertex-face').
kind(face, vertex, 'vertex-face').
kind(edge, edge, 'edge-edge').
kind(edge, face, 'edge-face').
kind(face, edge, 'edge-face').
kind(face, face, 'face-face').
