/* What was glued, feature by feature: kinds by hand. */
:- module(test_glue_contact, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(plunit)).
:- use_module(library(yall)).
:- use_module(rules(solid/glue_contact)).
:- use_module(tests(rules/glue_model)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

kinds(Parts, Steps, Kinds) :-
    in_new_world(( glue_made(Parts, Steps, S),
                   findall(Kind, contact(S, Kind, _, _), All0) )),
    msort(All0, All),
    findall(Kind-1, member(Kind, All), Pairs),
    group_pairs_by_key(Pairs, Groups),
    maplist([Kind-Ones,Kind-N]>>length(Ones, N), Groups, Kinds).

:- begin_tests(glue_contact).

test(kinds, [ forall(( wanted(Name, Wanted), member(Seed, [0,1,2]) )),
              Kinds == Sorted ]) :-
    msort(Wanted, Sorted),
    once(model(Name, Parts, _)),
    (   Seed =:= 0
    ->  Steps = []
    ;   turned(Seed, Steps)
    ),
    kinds(Parts, Steps, Kinds).

%   Two boxes with a face, an edge, a vertex, half an edge in common; one on the
%   middle of another, and on a quarter of it; a tip on an edge and on a face, a
%   ridge on a face; a wire from the middle of a face to an edge.

wanted(two(face), ['vertex-vertex'-4,'edge-edge'-4,'face-face'-1]).
wanted(two(edge), ['vertex-vertex'-2,'edge-edge'-1]).
wanted(two(vertex), ['vertex-vertex'-1]).
wanted(two(half_edge), ['vertex-edge'-2,'edge-edge'-1]).
wanted(on_plate, ['vertex-face'-4,'edge-face'-4,'face-face'-1]).
wanted(fig7, ['vertex-face'-2,'edge-edge'-2,'edge-face'-4,'face-face'-1]).
wanted(fig8(edge), ['vertex-edge'-1]).
wanted(fig8(face), ['vertex-face'-1]).
wanted(fig8(ridge), ['vertex-face'-2,'edge-face'-1]).
wanted(wire(to_edge), ['vertex-face'-1,'vertex-edge'-1,'edge-face'-1]).
wanted(two(apart), []).

:- end_tests(glue_contact).
