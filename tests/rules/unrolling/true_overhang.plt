/* Branches that hang over their headers, or end where they hit: what facets and
   true surfaces have in different order (rules/unrolling/true_tip.pl,
   true_border.pl, true_spike.pl). */
% covers: true_part_loop
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(solid/trimmed)).
:- use_module(rules(unrolling/true_development)).
:- use_module(tests('rules/sample')).

:- begin_tests(true_overhang).

%   A scene is scene(RH, NH, A, E, From, RB, NB): a header of radius RH and NH
%   facets, a branch of RB and NB that begins From along its axis, leans by A
%   and is E off.

header_and_branch(scene(RH, NH, A, E, From, RB, NB),
                  cylinder(radius(RH), height(400), facets(NH)),
                  at([translate(0,0,From),rotate(y,A),translate(0,E,200)],
                     cylinder(radius(RB), height(400), facets(NB)))).

:- meta_predicate unrolled(+, +, -, -, 0).

unrolled(Scene, S, T, D, Goal) :-
    header_and_branch(Scene, Header, Branch),
    Other is 3-S,
    new_world(World),
    in_world(World,
             ( add_primitive(Header, _),
               add_primitive(Branch, _),
               complete_segments,
               trimmed(S, [Other], outside, T),
               (   T == S
               ->  true
               ;   true_development(T, _, [], D),
                   Goal
               ) )).

%   Every polygon has its triangles: it does not cross itself.

valid(D) :-
    \+ ( p(D, P, _), \+ t(D, P, _, _, _, _) ).

area(D, Area) :-
    aggregate_all(sum(Part), triangle_area(D, Part), Area).

triangle_area(D, Area) :-
    t(D, _, _, A, B, C),
    v(D, A, X1, Y1, _),
    v(D, B, X2, Y2, _),
    v(D, C, X3, Y3, _),
    Area is ((X2-X1)*(Y3-Y1) - (X3-X1)*(Y2-Y1))/2.

%   Those that crossed themselves, by what they met.
hard(scene(58,12, 93,41,0,54,40)).      % past the rim of the branch
hard(scene(54,36,146,13,0,52,24)).
hard(scene(59,36, 47,10,0,50,24)).
hard(scene(43,36, 46, 3,0,47,12)).
hard(scene(52,24, 64,28,0,27,36)).      % past where the branch begins
hard(scene(42,12, 78,20,0,25,24)).
hard(scene(46,36,148,30,0,55,16)).
hard(scene(48,40, 83,55,0,11,36)).
hard(scene(57,12, 34,65,0,15,36)).

test(valid, [forall(( hard(Scene), member(S, [1,2]) ))]) :-
    unrolled(Scene, S, _, D, valid(D)).

%   As large as with fine facets, whose lines are nearly the true ones.
test(area, [forall(( hard(Scene), member(S, [1,2]) ))]) :-
    Scene = scene(RH,_,A,E,From,RB,_),
    unrolled(Scene, S, _, D, area(D, Area)),
    unrolled(scene(RH,96,A,E,From,RB,96), S, _, D2, area(D2, Fine)),
    abs(Area-Fine) =< 5.0e-4*Fine.

random_scene(Seed, scene(RH,NH,A,E,From,RB,NB)) :-
    set_random(seed(Seed)),
    random_between(40, 60, RH),
    random_between(10, 60, RB),
    random_between(50, 130, A),
    random_between(0, 90, E),
    random_member(NH, [12,16,24,36]),
    random_member(NB, [12,16,24,36]),
    random_member(From, [0,-200]).

test(random, [forall(( numbered(12, 40, Seed), member(S, [1,2]) ))]) :-
    random_scene(Seed, Scene),
    unrolled(Scene, S, _, D, valid(D)).

:- end_tests(true_overhang).
