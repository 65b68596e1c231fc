:- module(sg_passing,
          [ passing_places/2,           % +S, -Passing
            passing_named/2             % +S, +Passing
          ]).
:- use_module(store,
              [ v/5, e/5, t/6, leaf_v/5, leaf_e/5, from_v/4, origin/3,
                edge_polygon/3, assert_fact/1, retractall_facts/1
              ]).
:- autoload(library(apply), [maplist/2, maplist/3]).
:- autoload(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- autoload(library(lists), [member/2]).
:- autoload(library(ordsets), [ord_intersection/2]).
:- autoload(library(pairs), [group_pairs_by_key/2]).
/** <module> Vertices that leaves have in passing.

Before solids are combined, what is nearer than the tolerance is made to touch
(resolve.pl): leaves get vertices in the middle of edges and faces, which are
gone again when the snapshot is. What came of them in the result is said here in
terms of what the leaves keep: their vertices, edges and faces.

  - A vertex V of one leaf S that was put on others is that vertex, and has the
    origin near(on(S-V, Places)): Places are S0-e(E) and S0-p(P), edges and faces
    of other leaves that it was put on.
  - Where edges pass each other, the vertex has the origin near(ll(Edge1,Edge2)).
  - A cut that was made with a part of an edge, or with a triangle of a face,
    was made with that edge, or (S-p(P)) with that face: near(lpi(...)).
*/

%!  passing_places(+S, -Passing) is det.
%
%   Passing is V-place(Origin, Feature, Polygons) of the vertices V that S has
%   got where it was made to touch: Origin as of resolve.pl, Feature the edge
%   e(E) or face p(P) that S had there before, Polygons the faces that now have
%   V. To be asked while S has them.

passing_places(S, Passing) :-
    findall(V-place(Origin, Feature, Polygons),
            ( origin(S, v(V), near(Origin)),
              \+ leaf_v(S, V, _, _, _),
              polygons_at(S, V, Polygons),
              feature_at(S, V, Polygons, Feature)
            ),
            Passing).

polygons_at(S, V, Polygons) :-
    findall(P, corner_of(S, V, P), Polygons0),
    sort(Polygons0, Polygons).

corner_of(S, V, P) :-
    e(S, E, V, _, _),
    edge_polygon(S, E, P).
corner_of(S, V, P) :-
    t(S, P, _, V, _, _).
corner_of(S, V, P) :-
    t(S, P, _, _, V, _).
corner_of(S, V, P) :-
    t(S, P, _, _, _, V).

feature_at(S, V, [P|_], Feature) :-
    findall(E,
            ( ( e(S, Part, V, _, _) ; e(S, Part, _, V, _) ),
              part_of(S, Part, E)
            ),
            Es0),
    sort(Es0, Es),
    (   Es = [E|_]
    ->  Feature = e(E)
    ;   Feature = p(P)
    ).

%   part_of(+S, +Part, -E): Part is a part of edge E, which S had before.

part_of(S, Part, E) :-
    origin(S, e(Part), e(E0)),
    (   part_of(S, E0, E1)
    ->  E = E1
    ;   leaf_e(S, E0, _, _, _)
    ->  E = E0
    ).

%!  passing_named(+S, +Passing) is det.
%
%   Rewrites from_v/4 and origin/3 of the result S so that they name nothing of
%   Passing, a list of S0-Passing0 as passing_places/2 gave it for leaf S0,
%   which is gone now.

passing_named(_, []) :-
    !.
passing_named(S, Passing) :-
    findall(S0-Places,
            ( member(S0-Passing0, Passing),
              findall(V-Place, ( member(V-Place, Passing0),
                                 \+ v(S0, V, _, _, _) ), Gone),
              Gone \== [],
              list_to_assoc(Gone, Places)
            ),
            Pairs),
    list_to_assoc(Pairs, Gone),
    findall(Origin-at(S0,V0,Feature),
            ( member(S0-Passing0, Passing),
              member(V0-place(Origin, Feature, _), Passing0)
            ),
            Ats0),
    sort(Ats0, Ats),
    group_pairs_by_key(Ats, Points),
    findall(V-Origin,
            ( origin(S, v(V), Origin0),
              renamed(Gone, Origin0, Origin)
            ),
            Made),
    maplist(point_named(S), Points),
    maplist(write_origin(S), Made).

write_origin(S, V-Origin) :-
    retractall_facts(origin(S, v(V), _)),
    assert_fact(origin(S, v(V), Origin)).

/* - - - vertices that leaves had - - - */

point_named(S, Origin-Ats) :-
    findall(V, vertex_at(S, Origin, Ats, V), Vs0),
    sort(Vs0, Vs),
    maplist(vertex_named(S, Origin, Ats), Vs).

vertex_at(S, v(S1, V1), _, V) :-
    from_v(S, V, S1, V1).
vertex_at(S, _, Ats, V) :-
    member(at(S0, V0, _), Ats),
    from_v(S, V, S0, V0).

vertex_named(S, Origin, Ats, V) :-
    retractall_facts(from_v(S, V, _, _)),
    (   Origin = v(S1, V1)
    ->  assert_fact(from_v(S, V, S1, V1)),
        findall(S0-Feature, member(at(S0, _, Feature), Ats), Places0),
        sort(Places0, Places),
        write_origin(S, V-near(on(S1-V1, Places)))
    ;   write_origin(S, V-near(Origin))
    ).

/* - - - vertices that cuts made - - - */

%   renamed(+Gone, +Origin0, -Origin) is semidet: Origin0 names what is gone.

renamed(Gone, Origin0, near(Origin)) :-
    Origin0 =.. [Name|Places0],
    \+ \+ ( member(Place, Places0), names_gone(Gone, Place) ),
    (   maplist(place_renamed(Gone), Places0, Places)
    ->  Origin =.. [Name|Places]
    ;   Origin = Origin0
    ).

names_gone(Gone, S-Vertices) :-
    get_assoc(S, Gone, Places),
    comma_member(V, Vertices),
    get_assoc(V, Places, _),
    !.

place_renamed(Gone, S-Vertices, Place) :-
    (   names_gone(Gone, S-Vertices)
    ->  get_assoc(S, Gone, Places),
        feature_of(Vertices, S, Places, Feature),
        Place = S-Feature
    ;   Place = S-Vertices
    ).
place_renamed(_, Place, Place) :-
    Place \= _-_.

%   feature_of(+Vertices, +S, +Gone, -Feature): the ends of the edge of S that
%   the edge Vertices is a part of, or p(P), the face that has all of them.

feature_of((A,B), S, Gone, (V1,V2)) :-
    integer(B),
    ( member(V, [A,B]), get_assoc(V, Gone, place(_, e(E), _)) ),
    e(S, E, V1, V2, _),
    is_on(A, E, V1, V2, Gone),
    is_on(B, E, V1, V2, Gone),
    !.
feature_of(Vertices, S, Gone, p(P)) :-
    findall(Polygons,
            ( comma_member(V, Vertices),
              (   get_assoc(V, Gone, place(_, _, Polygons))
              ->  true
              ;   polygons_at(S, V, Polygons)
              ) ),
            Lists),
    ord_intersection(Lists, [P|_]).

is_on(V, E, V1, V2, Gone) :-
    (   V == V1
    ->  true
    ;   V == V2
    ->  true
    ;   get_assoc(V, Gone, place(_, e(E), _))
    ).

comma_member(V, (V0,Vs)) :-
    !,
    (   V = V0
    ;   comma_member(V, Vs)
    ).
comma_member(V, V).
