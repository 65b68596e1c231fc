:- module(sg_oracle_contact_origin,
          [ contact_places_by_rule/2,   % +S, -Places
            contact_origins_by_rule/2   % +S, +Contacts
          ]).
:- use_module('../../rules/kernel', [contact_facts/2]).
:- use_module('../../rules/store',
              [ e/5, t/6, leaf_v/5, leaf_e/5, from_v/4, origin/3,
                edge_polygon/3, vertex_triangle/3,
                assert_fact/1, retractall_facts/1
              ]).
:- use_module(library(apply), [maplist/2, maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [member/2]).
:- use_module(library(ordsets), [ord_intersection/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> What vertices of a result were made to touch: the rule of
contact_places/2 and contact_origins/2 (c_kernels/solid/contact_places.h).
*/

%!  contact_places_by_rule(+S, -Places:list) is det.
%
%   Places are what contact_facts/2 says of contact_places/2 of S; [] if it has
%   none. True only inside the snapshot of resolve.pl.

contact_places_by_rule(S, Contacts) :-
    findall(V-Place,
            ( origin(S, v(V), near(Origin)),
              place(S, V, Origin, Place)
            ),
            Contacts).

place(S, V, Origin, place(Origin, Feature, Polygons)) :-
    (   leaf_v(S, V, _, _, _)
    ->  Feature = v(V),
        Polygons = []
    ;   polygons_at(S, V, Polygons),
        feature_at(S, V, Polygons, Feature)
    ).

polygons_at(S, V, Polygons) :-
    findall(P, ( e(S, E, V, _, _), edge_polygon(S, E, P) ), Polygons0),
    sort(Polygons0, Polygons1),
    (   Polygons1 == []                 % in the middle of a face
    ->  findall(P, ( vertex_triangle(S, V, T), t(S, P, T, _, _, _) ),
                Polygons2),
        sort(Polygons2, Polygons)
    ;   Polygons = Polygons1
    ).

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

%!  contact_origins_by_rule(+S, +Contacts:list) is det.
%
%   As contact_origins/2.

contact_origins_by_rule(S, Handles) :-
    maplist(facts_of, Handles, Contacts),
    named_again(S, Contacts).

facts_of(S-Handle, S-Facts) :-
    contact_facts(Handle, Facts).

named_again(_, []) :-
    !.
named_again(S, Contacts) :-
    findall(S0-Places,
            ( member(S0-Contacts0, Contacts),
              list_to_assoc(Contacts0, Places)
            ),
            Pairs),
    list_to_assoc(Pairs, Touched),
    findall(Origin-at(S0,V0,Feature),
            ( member(S0-Contacts0, Contacts),
              member(V0-place(Origin, Feature, _), Contacts0)
            ),
            Ats0),
    sort(Ats0, Ats),
    group_pairs_by_key(Ats, Points),
    findall(V-Origin,
            ( origin(S, v(V), Origin0),
              renamed(Touched, Origin0, Origin)
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

vertex_named(S, v(S1, V1), Ats, V) :-
    !,
    retractall_facts(from_v(S, V, _, _)),
    assert_fact(from_v(S, V, S1, V1)),
    findall(S0-Feature, member(at(S0, _, Feature), Ats), Places0),
    sort(Places0, Places),
    write_origin(S, V-near(on(S1-V1, Places))).
vertex_named(S, Origin, Ats, V) :-
    (   from_v(S, V, S0, V0),
        memberchk(at(S0, V0, v(_)), Ats)
    ->  true                            % one of the leaf's own
    ;   retractall_facts(from_v(S, V, _, _))
    ),
    write_origin(S, V-near(Origin)).

/* - - - vertices that cuts made - - - */

%   renamed(+Touched, +Origin0, -Origin) is semidet: Origin0 names what is gone,
%   or was moved.

renamed(Touched, v(S, V), near(Origin)) :-
    !,
    get_assoc(S, Touched, Places),
    get_assoc(V, Places, place(Origin0, Feature, _)),
    (   Feature == v(V)
    ->  Origin = v(S, V)
    ;   Origin = Origin0
    ).
renamed(Touched, Origin0, near(Origin)) :-
    Origin0 =.. [Name|Places0],
    \+ \+ ( member(Place, Places0), names_touched(Touched, Place, _) ),
    maplist(place_renamed(Touched), Places0, Places),
    Origin =.. [Name|Places].

names_touched(Touched, S-Vertices, Feature) :-
    get_assoc(S, Touched, Places),
    comma_member(V, Vertices),
    get_assoc(V, Places, place(_, Feature, _)).

place_renamed(Touched, S-Vertices, Place) :-
    names_touched(Touched, S-Vertices, Feature0),
    Feature0 \= v(_),
    !,
    get_assoc(S, Touched, Places),
    (   feature_of(Vertices, S, Places, Feature)
    ->  Place = S-Feature
    ;   Place = S-Feature0
    ).
place_renamed(_, Place, Place).

%   feature_of(+Vertices, +S, +Touched, -Feature): the ends of the edge of S
%   that the edge Vertices is a part of, or p(P), the face that has all of them.

feature_of((A,B), S, Touched, (V1,V2)) :-
    integer(B),
    ( member(V, [A,B]), get_assoc(V, Touched, place(_, e(E), _)) ),
    e(S, E, V1, V2, _),
    is_on(A, E, V1, V2, Touched),
    is_on(B, E, V1, V2, Touched),
    !.
feature_of(Vertices, S, Touched, p(P)) :-
    findall(Polygons,
            ( comma_member(V, Vertices),
              (   get_assoc(V, Touched, place(_, _, Polygons)),
                  Polygons \== []
              ->  true
              ;   polygons_at(S, V, Polygons)
              ) ),
            Lists),
    ord_intersection(Lists, [P|_]).

is_on(V, E, V1, V2, Touched) :-
    (   V == V1
    ->  true
    ;   V == V2
    ->  true
    ;   get_assoc(V, Touched, place(_, e(E), _))
    ).

comma_member(V, (V0,Vs)) :-
    !,
    (   V = V0
    ;   comma_member(V, Vs)
    ).
comma_member(V, V).
