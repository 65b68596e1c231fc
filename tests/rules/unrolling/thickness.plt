/* Plates in other layers than the drawn one, cut by each other: how a pattern
   changes with the K-factor, and the tips of cones
   (rules/unrolling/true_apex.pl). THICKNESS_RANDOM=N: how many scenes of a
   kind. */
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(model/model_file)).
:- use_module(rules(development/seam_measure)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(unrolling/true_development)).
:- use_module(rules(unfolding/unfold_true)).
:- use_module(tests('rules/sample')).

% A plate is no torus: its facets lie on each other; that is told.
:- multifile user:message_hook/3.
user:message_hook(sanggwan(unfold(outline_crosses(2, 7))), warning, _).

:- begin_tests(thickness).

:- meta_predicate in_scene(+, 0).

in_scene(Terms, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Term, Terms), add_primitive(Term, _)),
               complete_segments,
               Goal )).

near(X, Y, Off) :-
    abs(X-Y) =< Off*(1.0+abs(Y)).

%   sound(D): every polygon has its triangles, and all are one piece.

sound(D) :-
    forall(p(D, P, _), once(t(D, P, _, _, _, _))),
    forall(piece(D, _, K), K =:= 1).


                /*******************************
                *             TIPS             *
                *******************************/

%   A right cone of 3:4:5, in a layer 1 outside or inside of it: generators of
%   50 turn through 216 degrees, and end 4/3 from the middle; within a twentieth
%   of that before they meet.

tip(inside, 51.333333333, 1.333333333).
tip(outside, 48.666666667, 0.066666667).

test(right_cone, [forall(( tip(Size, From, To),
                           member(Seam, [[],[seam(7)],[seam(355)]]) ))]) :-
    in_scene([cone(radius(30), height(40), facets(12))],
             ( true_development(1, side,
                                [ thickness(2), size(Size), chord(1.0e-4)
                                | Seam
                                ], D),
               sound(D),
               pattern_area(D, Area),
               aggregate_all(count, joint(D, _, _, _, seam, _), Seams) )),
    Exact is 0.6*pi*(From*From - To*To),
    near(Area, Exact, 1.0e-5),
    Seams =:= 1.

%   Generators end where the polygons do that they are drawn on.
test(generators_end_at_the_tip,
     [forall(member(Size-K, [inside-0.5,inside-0,outside-0.5]))]) :-
    in_scene([cone(radius(37,31), height(200), shift(20,5), facets(24))],
             ( true_development(1, side,
                                [thickness(3),size(Size),k_factor(K)], D),
               sound(D),
               forall(( origin(D, e(E), generator(_, _, _, _, _)),
                        e(D, E, A, B, _), member(V, [A,B]) ),
                      corner_there(D, V)) )).

%   A vertex of a polygon is where V is.

corner_there(D, V) :-
    v(D, V, X, Y, _),
    once(( p(D, _, Es), member(E, Es), e(D, E, W, _, 1),
           v(D, W, X2, Y2, _),
           abs(X-X2) + abs(Y-Y2) < 1.0e-6 )).

%   The top of a cone is narrower than its plate is thick: the layer within it
%   ends before its generators meet.
test(narrow_top) :-
    in_scene([cone(radius(50), top(1), height(200), facets(24))],
             ( true_development(1, side,
                              [thickness(4),size(outside),chord(1.0e-3)], D),
               sound(D),
               pattern_area(D, Area) )),
    Slant is sqrt(49*49 + 200*200),
    Sine is 49/Slant,
    From is 50/Sine - 2*200/49,
    To is 0.05*2*200/49,
    near(Area, pi*Sine*(From*From - To*To), 1.0e-4).

%   There it ends in an arc, however few facets the cone has: the middles of its
%   short edges are as far from the middle of the sector as their ends.
test(round_end, [forall(member(Top, [0,1,4])), true(Off < 2.0e-3)]) :-
    in_scene([cone(radius(50), top(Top), height(30), facets(6))],
             ( true_development(1, side,
                              [thickness(40),size(outside),chord(1.0e-3)], D),
               findall(X-Y, v(D, _, X, Y, _), Places),
               findall(A-B,
                       ( e(D, _, V1, V2, 1),
                         v(D, V1, X1, Y1, _), A = X1-Y1,
                         v(D, V2, X2, Y2, _), B = X2-Y2 ),
                       Edges) )),
    Wide is 50-Top,
    Slant is sqrt(Wide*Wide + 900),
    From is 50*Slant/Wide - 20*30/Wide,
    To is 0.05*20*30/Wide,
    middle(Places, From, Middle),
    findall(Off1,
            ( member(A-B, Edges),
              distance(A, Middle, R1), R1 < 2*To,
              distance(B, Middle, R2), R2 < 2*To,
              A = X1-Y1, B = X2-Y2,
              X is (X1+X2)/2, Y is (Y1+Y2)/2,
              distance(X-Y, Middle, R),
              Off1 is abs(R-To) ),
            Offs),
    length(Offs, N),
    N > 6,
    max_list(Offs, Off).

%   middle(Places, Radius, Middle): of a sector of more than half a circle,
%   whose middle generator stands upright.

middle(Places, Radius, X-Y) :-
    pairs_keys_values(Places, Xs, Ys),
    min_list(Xs, X1),
    max_list(Xs, X2),
    max_list(Ys, Y2),
    min_list(Ys, Y1),
    X is (X1+X2)/2,
    (   member(Y, [Y1+Radius,Y2-Radius]),
        forall(( member(P, Places), distance(P, X-Y, R), R > Radius/2 ),
               abs(R-Radius) < 0.01*Radius)
    ->  true
    ).

distance(X1-Y1, X2-Y2, D) :-
    D is sqrt((X1-X2)**2 + (Y1-Y2)**2).

%   in_one(D, P): polygon P has one outer loop: N half-edges of K outer loops
%   have N - 2*K triangles, and more with holes.

in_one(D, P) :-
    p(D, P, Es),
    length(Es, N),
    aggregate_all(count, t(D, P, _, _, _, _), Count),
    Count >= N-2.

%   The tube of a ring goes over one facet twice: its three parts are polygons
%   of their own, also of what the seam leaves of the facet; of one polygon only
%   one part was there.
test(facet_in_parts, [ condition(all_wanted),
                       true(near(Area, 33076.45, 1.0e-4)) ]) :-
    in_scene([ cone(radius(50), height(200), facets(12)),
               at([rotate(x,89),rotate(y,88),translate(-15,6,68)],
                  torus(radius(28), tube(9), facets(12))) ],
             ( true_patterns(1, wanted(none,[],[],[]),
                             [ trim(outside), thickness(3), k_factor(1),
                               set_in(true), chord(0.002), seam(183) ],
                             [D|_]),
               forall(p(D, P, _), in_one(D, P)),
               pattern_area(D, Area) )).


%   Holes that go over folds of facets: what bends take off ends their true
%   borders, not the chords of these; two polygons crossed themselves.
test(hole_over_bends, true((near(Area, 3310.95369, 1.0e-6), Rest == []))) :-
    in_scene([ cone(radius(50), height(200), facets(12)),
               at([rotate(x,89),rotate(y,88),translate(-15,6,68)],
                  torus(radius(28), tube(9), facets(12))) ],
             ( true_patterns(2, wanted(none,[],[],[]),
                             [ trim(outside), thickness(3), k_factor(1),
                               set_in(true), chord(0.002) ],
                             [D|Rest]),
               forall(p(D, P, _), in_one(D, P)),
               pattern_area(D, Area) )).


                /*******************************
                *           K-FACTOR           *
                *******************************/

%   What is cut off goes by the side that touches, whichever layer is unrolled;
%   so the area of the pattern is linear in the K-factor, as long as generators
%   do not meet.

part(cone, cone(radius(A,B), height(200), facets(24))) :-
    maplist(random_between(30, 60), [A,B]).
part(oblique_cone, cone(radius(A), height(200), shift(X,Y), facets(12))) :-
    random_between(30, 60, A),
    maplist(random_between(-20, 20), [X,Y]).
part(frustum, cone(radius(A,B), top(K), height(200), shift(X,Y),
                   facets(24))) :-
    maplist(random_between(30, 60), [A,B]),
    random_between(15, 60, K),
    maplist(random_between(-60, 60), [X,Y]).
part(cylinder, cylinder(radius(A,B), height(200), facets(24))) :-
    maplist(random_between(30, 60), [A,B]).

other(at([rotate(x,A),rotate(y,B),translate(X,Y,90)], Part)) :-
    maplist(random_between, [30,-90,-20,-20], [90,90,20,20], [A,B,X,Y]),
    random_member(Part, [ pyramid(base(34,22), height(260)),
                          cylinder(radius(14), height(260), facets(12)),
                          cone(radius(25), height(260), facets(9)),
                          box(size(20,30,260)) ]).

k_factor_area(Terms, K, Area) :-
    in_scene(Terms,
             ( true_patterns(1, wanted(none,[],[],[2]),
                             [ trim(outside), thickness(3), size(inside),
                               role(branch), chord(1.0e-3), k_factor(K)
                             ], [D|_]),
               forall(p(D, P, _), once(t(D, P, _, _, _, _))),
               seams_agree(D),
               pattern_area(D, Area) )).

seams_agree(D) :-
    forall(joint(D, _, E, F, _, _),
           ( length_of(D, E, L1), length_of(D, F, L2),
             near(L1, L2, 1.0e-9) )).

length_of(D, E, L) :-
    e(D, E, A, B, _),
    v(D, A, X1, Y1, _),
    v(D, B, X2, Y2, _),
    L is sqrt((X1-X2)**2 + (Y1-Y2)**2).

linear(Terms) :-
    maplist(k_factor_area(Terms), [0,0.5,1], [A,B,C]),
    near(B, (A+C)/2, 2.0e-6).

%   A pyramid set on a pointed elliptic cone: beside the hole the sides of
%   facets went to one point in all layers, through the hole.
test(pyramid_on_a_cone) :-
    linear([ cone(radius(37,31), height(200), facets(24)),
             at([rotate(x,47),rotate(y,-81),translate(0,2,90)],
                pyramid(base(34,22), height(260))) ]).

scenes(Most, N) :-
    (   getenv('THICKNESS_RANDOM', Text),
        atom_number(Text, N)
    ->  true
    ;   N = Most
    ).

test(random, [forall(sampled([],
                             ( scenes(1, N), between(1, N, Seed),
                               member(Kind, [cone,oblique_cone,frustum,
                                             cylinder]) )))]) :-
    set_random(seed(Seed)),
    part(Kind, Part),
    other(Other),
    linear([Part,Other]).

:- end_tests(thickness).
