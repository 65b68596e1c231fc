/* A pipe that ends in a torus: its pattern is seen from outside, and a warning
   says where facets decided. */
:- use_module(library(plunit)).
:- use_module(library(lists)).
:- use_module(rules(development/seam_measure)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(store)).
:- use_module(rules(unfolding/unfold_true)).

:- dynamic told/1.

user:message_hook(sanggwan(unfold(nearly_touching(S, By))), warning, _) :-
    assertz(told(S-By)).

%   unrolled(Offset, Told, Area): of a pipe of radius 10 that begins within a
%   torus of radii 60 and 20, its highest generator being Offset + 10 high. Told
%   is what is warned of, Area that of the pattern.

unrolled(Offset, Told, Area) :-
    retractall(told(_)),
    new_world(World),
    in_world(World,
             ( add_primitive(torus(radius(60), tube(20)), _),
               add_primitive(at([rotate(y,90),translate(40,0,Offset)],
                                cylinder(radius(10), height(80))), S),
               complete_segments,
               true_patterns(S, wanted(none,[],[],[]), [trim(outside)],
                             [D|_]),
               pattern_area(D, Area) )),
    findall(W, told(W), Told).

:- begin_tests(true_touch).

test(told, [ forall(member(Offset-Told,
                           [9-[], 9.9-[], 9.99-[2-1], 10.01-[2-1]])),
             true(Told0 == Told) ]) :-
    unrolled(Offset, Told0, _).

test(seen_from_outside, [ forall(member(Offset, [9.9,9.99])),
                          true(Area > 0.0) ]) :-
    unrolled(Offset, _, Area).

:- end_tests(true_touch).
