:- module(sg_oracle_resolve,
          [ resolve_contacts_by_rule/2  % +Set, +Tolerance
          ]).
:- use_module(leaf, [leaves_kept_by_rule/1, place_kept/1]).
:- use_module('../../rules/kernel', [cut_resolve/5]).
:- use_module('../../rules/penetration/resolve', []).
:- use_module('../../rules/store',
              [ v/5, e/5, p/3, t/6, origin/3, edge_polygon/3, assert_fact/1,
                retractall_facts/1, fresh_id/3
              ]).
:- use_module(library(apply), [maplist/2, maplist/3]).
:- use_module(library(lists), [member/2]).
/** <module> The rule of resolve_contacts/2 (rules/penetration/resolve.pl), row
by row.
*/

%!  resolve_contacts_by_rule(+Set, +Tolerance) is semidet.
%
%   What resolve_contacts/2 does, in the same order.

resolve_contacts_by_rule(Set, Tolerance) :-
    sg_resolve:set_reach(Set, Tolerance, Reach),
    Reach > 0,
    sg_resolve:parts(Parts),
    closed_contacts(Parts, Set, Reach, Changes),
    Changes = changes(Vertices, Polygons),
    Vertices-Polygons \== []-[],
    findall(S-V, member(vertex(S, V, _, _, _, _), Vertices), Places),
    maplist(place_kept, Places),
    findall(S-P, member(polygon(S, P, _, _), Polygons), Cut),
    leaves_kept_by_rule(Cut),
    maplist(write_vertex, Vertices),
    maplist(write_polygon, Polygons).

closed_contacts([Part|Parts], Set, Tolerance, Changes) :-
    Reach is Part*Tolerance,
    cut_resolve(Set, Reach, What, Vertices, Polygons),
    (   atom(What)
    ->  Changes = changes(Vertices, Polygons)
    ;   Parts == []
    ->  print_message(warning, sanggwan(contacts(What))),
        Changes = changes([], [])
    ;   closed_contacts(Parts, Set, Tolerance, Changes)
    ).

write_vertex(vertex(S, V, X, Y, Z, Origin)) :-
    retractall_facts(v(S, V, _, _, _)),
    assert_fact(v(S, V, X, Y, Z)),
    (   origin(S, v(V), _)
    ->  true
    ;   assert_fact(origin(S, v(V), Origin))
    ).

%   The polygon keeps its number, and its edges that were not divided theirs.

write_polygon(polygon(S, P, Edges, Triangles)) :-
    p(S, P, Es0),
    !,
    sg_resolve:retract_one(p(S, P, Es0)),
    findall(E,
            ( member(E, Es0),
              \+ is_kept(S, E, Edges),
              \+ edge_polygon(S, E, _)
            ),
            Gone),
    maplist(write_edge(S), Edges, Es),
    forall(member(E, Gone), retractall_facts(e(S, E, _, _, _))),
    assert_fact(p(S, P, Es)),
    retractall_facts(t(S, P, _, _, _, _)),
    maplist(write_triangle(S, P), Triangles).

is_kept(S, E, Edges) :-
    e(S, E, V1, V2, _),
    memberchk(w(V1, V2, _, E), Edges).

write_edge(S, w(V1, V2, _, E), E) :-
    E > 0,
    e(S, E, V1, V2, _),
    !.
write_edge(S, w(V1, V2, Et, Old), E) :-
    fresh_id(e, S, E),
    assert_fact(e(S, E, V1, V2, Et)),
    (   Old > 0
    ->  assert_fact(origin(S, e(E), e(Old)))
    ;   assert_fact(origin(S, e(E), near))
    ).

write_triangle(S, P, t(V1, V2, V3)) :-
    fresh_id(t, S, T),
    assert_fact(t(S, P, T, V1, V2, V3)).
