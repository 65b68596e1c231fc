:- module(test_line_end, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(occurs)).
:- use_module(library(random)).
:- use_module(rules(solid/csg_evaluate), [evaluate/0]).
:- use_module(rules(csg/csg_roots),
              [operand_lines/1, with_operand_lines/2, roots_alone/0]).
:- use_module(rules(explanation/explain), [explanation/3]).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).
:- use_module(rules(picture/view)).
:- use_module(tests('rules/contour_same'), [same_as_rule/2]).
:- use_module(tests('rules/picture/loose_end')).
:- use_module(tests('rules/polyhedron'), [in_new_world/1]).
:- use_module(tests('rules/sample'), [numbered/3,one_in/2]).

/* Penetration lines and creases on smooth surfaces, coarse ones too: what is
   seen of them ends where the outline of the surface does, and no short piece
   is hidden before that. */

%   scene(Name, N, Turn, How-Terms): solids of N facets, `one` tree or several
%   that are cut `apart`; turned by Turn.

scene(cut, N, Turn,
      one-[difference([sphere(radius(1), facets(N)),
                       at([translate(3.3,0,-3), Turn],
                          box(size(6,6,6)))])]).
scene(cap, N, Turn,
      one-[intersection([sphere(radius(1), facets(N)),
                         at([translate(3.5,0,-3), Turn],
                            box(size(6,6,6)))])]).
scene(lens, N, Turn,
      one-[intersection([sphere(radius(1), facets(N)),
                         at([Turn, translate(0.8,0.5,0.1)],
                            sphere(radius(0.9), facets(N)))])]).
scene(two_balls, N, Turn, one-[union([Ball,Other])]) :-
    balls(N, Turn, Ball, Other).
scene(balls_apart, N, Turn, apart-[Ball,Other]) :-
    balls(N, Turn, Ball, Other).
scene(block, N, Turn, one-[union([Ball,Block])]) :-
    ball_and_block(N, Turn, Ball, Block).
scene(block_apart, N, Turn, apart-[Block,Ball]) :-
    ball_and_block(N, Turn, Ball, Block).
scene(bore, N, Turn,
      one-[difference([sphere(radius(1), facets(N)),
                       at([translate(0.1,0.2,-2), Turn],
                          cylinder(radius(0.4), height(4), facets(N)))])]).
scene(rod, N, Turn,
      one-[union([sphere(radius(1), facets(N)),
                  at([translate(0.1,0.2,-2), Turn],
                     cylinder(radius(0.4), height(4), facets(N)))])]).
scene(tubes, N, Turn,
      one-[union([cylinder(radius(0.7), height(3), facets(N)),
                  at([translate(0,0,-1.5), rotate(x,90), Turn,
                      translate(0.1,0,1.4)],
                     cylinder(radius(0.5), height(3), facets(N)))])]).
scene(cone_and_tube, N, Turn,
      one-[union([cone(radius(1), top(0.3), height(2), facets(N)),
                  at([translate(0,0,-1.5), rotate(x,70), Turn,
                      translate(0.1,0,1)],
                     cylinder(radius(0.3), height(3), facets(N)))])]).

balls(N, Turn, sphere(radius(1), facets(N)),
      at([Turn, translate(0.8,0.5,0.1)], sphere(radius(0.7), facets(N)))).

ball_and_block(N, Turn, sphere(radius(1), facets(N)),
               at([Turn, translate(0.2,0.1,0)],
                  at([translate(0,0,-2)], box(size(1,0.7,4))))).

%   made_scene(Name, Seed, Options, Eyes): the scene of that name, with Options
%   for its pictures, and some eyes.

made_scene(Name, Seed, Options, Eyes) :-
    set_random(seed(Seed)),
    random_member(N, [16,20,24,30,36,48]),
    maplist(random(-1.0, 1.0), [A,B,C]),
    random(0.0, 360.0, Angle),
    scene(Name, N, rotate(axis(A,B,C),Angle), How-Terms),
    length(Eyes, 6),
    maplist(random_eye, Eyes),
    made(How, Terms, Options).

random_eye(Theta-Phi) :-
    random(0.0, 360.0, Theta),
    random(1.0, 179.0, Phi).

made(one, [Term], [segments([1])]) :-
    assert_fact(segment(1, solid, Term)),
    evaluate,
    complete_segments.
made(apart, Terms, []) :-
    maplist(add_primitive, Terms, _),
    complete_segments,
    penetrate.

pictured(Theta-Phi, Options) :-
    set_view(Theta, Phi, 0),
    operand_lines(Lines),
    with_operand_lines(Lines, picture(Options)).

drawing(Drawing) :-
    findall(part(S,E,From,To,Visibility,Role),
            drawn(_, S, E, From, To, Visibility, Role),
            Drawing).

%   fault(Name, Seed, Eye-Fault): in millimetres of a picture of 120 mm.

fault(Name, Seed, Eye-Fault) :-
    made_scene(Name, Seed, Options, Eyes),
    member(Eye, Eyes),
    pictured(Eye, Options),
    (   Fault = loose(S,E,Off),
        loose_end(120, 0.2, end(S,E,penetration,Off))
    ;   Name \== bore,                  % one edge of it is seen behind another
        Fault = gap(Ids,Length),
        short_gap(120, 0.5, gap(Ids,Length))
    ).

same_as_rules(Name, Seed) :-
    made_scene(Name, Seed, Options, Eyes),
    forall(( member(Eye, Eyes), segment_drawn(S, Options) ),
           ( pictured(Eye, [method(kernel)|Options]),
             drawing(Kernel),
             operand_lines(Lines),
             with_operand_lines(Lines, same_as_rule(S, 30)),
             pictured(Eye, [method(rule)|Options]),
             drawing(Rule),
             Kernel == Rule )).

segment_drawn(S, Options) :-
    (   memberchk(segments([S0]), Options)
    ->  S = S0
    ;   segment(S, _, _)
    ).

%   turned_wrongly(Name, Seed, Eye-Turn): a part of a drawn line that a smooth
%   surface turns from the eye is seen, or the explanation does not say so.

turned_wrongly(Name, Seed, Eye-turn(S,E,From,To)) :-
    made_scene(Name, Seed, Options, Eyes),
    member(Eye, Eyes),
    pictured(Eye, Options),
    drawn(_, S, E, _, _, _, penetration),
    line_facing(S, E, S2, T, From, To, _),
    From < To,
    \+ ( t(S2, P, T, _, _, _),
         explained(S, E, Options, turned_away(S2, P, From, To)),
         \+ ( drawn(_, S, E, A, B, visible, _),
              max(A, From) + 1.0e-9 < min(B, To) ) ).

explained(S, E, Options, Statement) :-
    operand_lines(Lines),
    with_operand_lines(Lines, explanation(hidden(S, E), Options, Because)),
    sub_term(Term, Because),
    nonvar(Term),
    Term = because(Statement, _),
    !.

:- begin_tests(line_end).

test(ends, [ forall(( scene(Name, 0, _, _), numbered(1, 8, Seed) )),
             true(Name-Seed-Faults == Name-Seed-[]) ]) :-
    in_new_world(findall(Fault, fault(Name, Seed, Fault), Faults)).
test(kernel_is_rule,
     [ forall(one_in(2, member(Name-Seed, [ two_balls-6, balls_apart-1,
                                            block_apart-6, cut-1 ]))) ]) :-
    in_new_world(same_as_rules(Name, Seed)).
test(explained,
     [ forall(member(Name-Seed, [lens-2, balls_apart-6])),
       true(Wrong == []) ]) :-
    in_new_world(findall(W, turned_wrongly(Name, Seed, W), Wrong)).
% A picture of all edges shows the triangles as they are.
test(all_edges) :-
    in_new_world(( made_scene(lens, 1, Options, [Eye|_]),
                   pictured(Eye, Options),
                   once(surface_facing(_, _, _, _, _, _)),
                   pictured(Eye, [lines(all)|Options]),
                   \+ surface_facing(_, _, _, _, _, _) )).

:- end_tests(line_end).
