:- module(test_known_surface, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(random)).
:- use_module(rules(picture/contour)).
:- use_module(rules(csg/csg), [root_segment/1]).
:- use_module(rules(solid/csg_evaluate), [evaluate/0]).
:- use_module(rules(decision)).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(csg/known_surface)).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(penetration/penetration), [penetrate/0]).
:- use_module(rules(primitive/primitive_face),
              [face_of/3, smooth_surface/3, surface_point/4]).
:- use_module(rules(vector), [cross_product/3, difference/3,
                                     dot_product/3]).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation), [complete_segments/1]).
:- use_module(rules(picture/view)).
:- use_module(tests('rules/contour_same'), [same_as_rule/2]).
:- use_module(tests('rules/polyhedron'), [in_new_world/1]).
:- use_module(tests('oracle/known_surface')).

% Which polygons stand for which surface, and how it looks: against
% primitive_face.pl, which makes the whole shape, and surface_point/4.

round_primitive(sphere(radius(1,2,0.5), facets(9), bands(5))).
round_primitive(sphere(radius(1), facets(300), bands(3))).
round_primitive(egg(radius(1), up(2), down(1), facets(9))).
round_primitive(hemisphere(radius(1,2,3), facets(10), bands(3))).
round_primitive(torus(radius(2), tube(0.5), facets(9), sides(6))).
round_primitive(torus(radius(2), tube(0.5), facets(9), sides(4))).
round_primitive(cylinder(radius(1,2), height(3), facets(9), shift(1,2))).
round_primitive(cylinder(radius(1), height(3), facets(8))).
round_primitive(cone(radius(1,2), height(3), facets(12), shift(0.5,0))).
round_primitive(cone(radius(2), top(1), height(3), facets(12))).
round_primitive(cone(radius(2,1), top(0.5,0.7), height(3), facets(12))).
round_primitive(hollow_cylinder(radius(2), inner(1), height(1), facets(9))).
round_primitive(turning(outline([[0,0],[1,0],[1.5,1],[1.5,2],[0,3]]),
                        facets(10))).
round_primitive(turning(outline([[1,0],[2,0.5],[1,1]]), angle(200),
                        facets(9))).
round_primitive(bezier(points([[0,0,0],[1,0,3],[2,0,-3],[3,0,0],
                               [0,1,1],[1,1,4],[2,1,-2],[3,1,1],
                               [0,2,-1],[1,2,3],[2,2,-4],[3,2,-1],
                               [0,3,0],[1,3,3],[2,3,-3],[3,3,0]]),
                       facets(4))).

placed(Term, Term).
placed(Term, at([rotate(axis(1,2,3),40), scale(1,-2,3), translate(1,2,3)],
                Term)).
placed(Term, at([matrix([[1,0.3,0,4],[0,2,0.5,1],[0.2,0,1,7]])], Term)).

wide(Ranges, Surface) :-
    functor(Surface, Name, _),
    member(From-To, Ranges),
    (   memberchk(Name, [cylinder,cone,ruled])
    ->  abs(To-From) >= 45-1.0e-5
    ;   abs(To-From) >= 90-1.0e-5
    ).

same_surface(S, P) :-
    (   face_of(S, P, curved(Part, Ranges)),
        smooth_surface(S, Part, Surface),
        \+ wide(Ranges, Surface)
    ->  polygon_surface(S, P, S-K, _),
        once(( findall(Name, smooth_surface(S, Name, _), Names),
               nth1(K, Names, Part) ))
    ;   \+ polygon_surface(S, P, _, _)
    ).

% The normal by differences of points.

parameters(Surface, T, H) :-
    functor(Surface, Name, _),
    (   Name == bezier
    ->  member(T, [0.05,0.3,0.7,0.95])
    ;   member(T, [10,75,200,300])
    ),
    (   memberchk(Name, [sphere,torus])
    ->  member(H, [20,-35,70])
    ;   member(H, [0.1,0.5,0.8])
    ).

numeric_normal(Surface, T, H, Point, Normal) :-
    T1 is T+0.001,
    T0 is T-0.001,
    H1 is H+0.0001,
    H0 is H-0.0001,
    maplist(at_parameters(Surface), [T-H,T1-H,T0-H,T-H1,T-H0],
            [Point,A1,A0,B1,B0]),
    difference(A1, A0, A),
    difference(B1, B0, B),
    cross_product(A, B, Normal).

at_parameters(Surface, T-H, p(X,Y,Z)) :-
    surface_point(Surface, T, H, point(X,Y,Z)).

across(Surface, Plain, T-H) :-
    numeric_normal(Surface, T, H, Point, Normal),
    surface_normal(Plain, Point, Normal, Unit),
    dot_product(Normal, Unit, Dot),
    dot_product(Normal, Normal, Square),
    dot_product(Unit, Unit, One),
    abs(One-1) < 1.0e-9,
    Dot > (1-1.0e-7)*sqrt(Square).

:- begin_tests(known_surface).

% Facets of 45 degrees and more of a cylinder or cone stand for nothing round;
% of a sphere or torus those of 90.
test(widest, forall(member(Term-Round,
        [ cylinder(radius(1), height(1), facets(9))-yes,
          cylinder(radius(1), height(1), facets(8))-no,
          cylinder(radius(1), height(1), facets(7))-no,
          cone(radius(1), height(1), facets(9))-yes,
          cone(radius(1), height(1), facets(7))-no,
          cone(radius(2), top(1), height(1), facets(8))-no,
          sphere(radius(1), facets(9), bands(5))-yes,
          sphere(radius(1), facets(5), bands(3))-yes,
          sphere(radius(1), facets(4), bands(2))-no,
          torus(radius(2), tube(0.5), facets(5), sides(5))-yes,
          torus(radius(2), tube(0.5), facets(9), sides(4))-no ]))) :-
    in_new_world(( add_primitive(Term, S),
                   (   p(S, P, _), polygon_surface(S, P, _, _)
                   ->  Found = yes
                   ;   Found = no
                   ) )),
    (   Found == Round
    ->  true
    ;   format(user_error, '~w: ~w~n', [Term,Found]),
        fail
    ).

test(polygons, [ forall(( round_primitive(Term0), placed(Term0, Term) )),
                 Wrong == [] ]) :-
    in_new_world(( add_primitive(Term, S),
                   findall(P, ( p(S, P, _), \+ same_surface(S, P) ), Wrong)
                 )).
test(normals, [ forall(( round_primitive(Term0), placed(Term0, Term) )),
                Wrong == [] ]) :-
    in_new_world(( add_primitive(Term, S),
                   segment_surfaces(S, Plains, _),
                   findall(Surface, smooth_surface(S, _, Surface), Surfaces),
                   findall(I-T-H,
                           ( nth1(I, Surfaces, Surface),
                             nth1(I, Plains, Plain),
                             parameters(Surface, T, H),
                             \+ across(Surface, Plain, T-H) ),
                           Wrong) )).
test(apex, fail) :-
    in_new_world(( add_primitive(cone(radius(1), height(2), facets(12)), S),
                   segment_surfaces(S, [Cone], _),
                   surface_normal(Cone, p(0.0,0.0,2.0), p(1.0,0.0,1.0), _) )).
test(not_a_facet, fail) :-
    in_new_world(( add_primitive(sphere(radius(1)), S),
                   segment_surfaces(S, [Sphere], _),
                   surface_normal(Sphere, p(1.0,0.0,0.0), p(0.1,0.0,1.0), _)
                 )).
% A box bored through twice, with half a ring on its top. The first bore cuts
% the ten facets of the second in two, the second four of the first's twelve.
test(followed, Found == [tapered-1-16, tapered-2-20, torus-3-192]) :-
    in_new_world(( assert_fact(segment(1, solid,
                      at([rotate(y,20),scale(2)],
                         difference([ union([box(size(2,2,2)),
                                             at([translate(0,0,2)],
                                                torus(radius(0.7), tube(0.2),
                                                      facets(24),
                                                      sides(16)))]),
                                      at([translate(0,0,-1)],
                                         cylinder(radius(0.4), height(5),
                                                  facets(12))),
                                      at([rotate(x,90),translate(0,3,1)],
                                         cylinder(radius(0.2), height(6),
                                                  facets(10))) ])))),
                   evaluate,
                   findall(Kind-Id, ( p(1, P, _),
                                      polygon_surface(1, P, Id,
                                                      surface(Kind,_,_,_)) ),
                           Found0),
                   counted(Found0, Found) )).

counted(List, Counts) :-
    msort(List, Sorted),
    findall(X-x, member(X, Sorted), Pairs),
    group_pairs_by_key(Pairs, Groups),
    findall(Kind-I-N, ( nth1(I, Groups, (Kind-_)-Xs), length(Xs, N) ), Counts).

:- end_tests(known_surface).

% What is drawn.

pictured(Terms, Options) :-
    forall(member(Term, Terms), add_primitive(Term, _)),
    findall(S, segment(S,_,_), Ss),
    complete_segments(Ss),
    picture(Options).

roles(Options, Roles) :-
    picture(Options),
    findall(Role, drawn(_,_,_,_,_,_,Role), Roles0),
    sort(Roles0, Roles).

% The first comes down two to one along u, the second goes on by Slope.
two_patches(Slope, N, bezier(facets(N), points(Points),
                             patches([First,Second]))) :-
    findall([X,Y,Z],
            ( member(Y, [0,1,2,3]),
              member(X-Z, [0-0, 1-2, 2-2, 3-0, 4-Slope, 5-Slope, 6-0]) ),
            Points),
    findall(I, ( between(0, 3, V), between(1, 4, U), I is 7*V+U ), First),
    findall(I, ( between(0, 3, V), between(4, 7, U), I is 7*V+U ), Second).

on_meeting(E) :-
    e(1, E, A, B, _),
    v(1, A, 3.0, _, _),
    v(1, B, 3.0, _, _).

coarse(bezier(facets(2), points([[0,0,0],[1,0,2],[2,0,2],[3,0,0],
                                 [0,1,2],[1,1,5],[2,1,5],[3,1,2],
                                 [0,2,2],[1,2,5],[2,2,5],[3,2,2],
                                 [0,3,0],[1,3,2],[2,3,2],[3,3,0]])),
       [border,outline]).
coarse(sphere(radius(1), facets(12), bands(8)), [outline]).
coarse(sphere(radius(1), facets(5), bands(3)), [outline]).
coarse(torus(radius(1), tube(0.3), facets(10), sides(5)), [outline]).
coarse(egg(radius(1), up(2), down(1), facets(8)), [outline]).
coarse(cylinder(radius(1), height(2), facets(9)), [crease,outline]).
coarse(cone(radius(1), height(2), facets(9)), [crease,outline]).
coarse(hemisphere(radius(1), facets(8)), [crease,outline]).

% The lines of a cylinder's side: outlines where it turns from the eye.
sides(S, Role, Lines) :-
    findall(E, ( drawn(_,S,E,_,_,_,Role), E > 0, e(S, E, A, B, _),
                 v(S, A, _, _, Z1), v(S, B, _, _, Z2), abs(Z1-Z2) > 1.0e-9 ),
            Lines).

:- begin_tests(known_surface_drawn).

test(no_crease, [ forall(coarse(Term, Expected)), Roles == Expected ]) :-
    in_new_world(( set_view(33, 62, 0), pictured([Term], []),
                   roles([], Roles) )).
% Two patches that meet in a line: with a common tangent plane there they are
% one surface, however coarse, without one they have a crease.
test(net, [ forall(( member(Slope-Expected, [-2-[], 0-[crease], 2-[crease]]),
                     member(N, [1,3,8]) )), Roles == Expected ]) :-
    two_patches(Slope, N, Net),
    in_new_world(( set_view(20, 10, 0),
                   pictured([Net], []),
                   findall(Role, ( drawn(_,1,E,_,_,_,Role),
                                   on_meeting(E), Role \== outline ),
                           Roles0),
                   sort(Roles0, Roles) )).
test(all_edges, [ forall(coarse(Term, _)) ]) :-
    in_new_world(( set_view(33, 62, 0), pictured([Term], []),
                   roles([lines(all)], Roles),
                   memberchk(smooth, Roles) )),
    \+ memberchk(mesh, Roles).
test(generators, Outlines-Creases == 2-0) :-
    in_new_world(( set_view(33, 62, 0),
                   pictured([cylinder(radius(1), height(2), facets(10))], []),
                   sides(1, outline, Os), sides(1, crease, Cs),
                   length(Os, Outlines), length(Cs, Creases) )).
test(prism, Outlines-Creases == 2-4) :-
    in_new_world(( set_view(33, 62, 0),
                   pictured([cylinder(radius(1), height(2), facets(6))], []),
                   sides(1, outline, Os), sides(1, crease, Cs),
                   length(Os, Outlines), length(Cs, Creases) )).
test(faceted, Roles == [crease,outline]) :-
    in_new_world(( set_view(33, 62, 0),
                   pictured([sphere(radius(1), facets(8))], []),
                   in_rules("smooth_segment(S) :- S =\\= 1.",
                            roles([], Roles)) )).
test(faceted_all_edges) :-
    in_new_world(( set_view(33, 62, 0),
                   pictured([sphere(radius(1), facets(8))], []),
                   in_rules("smooth_segment(S) :- S =\\= 1.",
                            roles([lines(all)], Roles)) )),
    memberchk(crease, Roles).
% As long as the ellipse that a sphere of few facets is seen as, but for what
% its chords take.
test(round, [ forall(member(N, [8,12,16,24])), true(Length > Least*2*pi) ]) :-
    Least is cos(pi/N)**2,
    in_new_world(( set_view(33, 62, 0),
                   pictured([sphere(radius(1), facets(N))], []),
                   aggregate_all(sum(L),
                                 ( drawn(_,S,E,F,T,visible,outline),
                                   line_ends(S, E, X1-Y1, X2-Y2),
                                   L is (T-F)*sqrt((X2-X1)**2+(Y2-Y1)**2) ),
                                 Length),
                   Length < 2*pi )).

in_rules(Text, Goal) :-
    tmp_file_stream(File, Out, [encoding(utf8),extension(pl)]),
    call_cleanup(
        ( write(Out, Text), close(Out), use_rules(File), Goal, no_rules(File) ),
        delete_file(File)).

:- end_tests(known_surface_drawn).

% The kernel against the rule: facets wider than the crease angle, placed, cut,
% combined.

scene(Term, [Term]) :-
    member(Term, [ sphere(radius(1), facets(10), bands(4)),
                   torus(radius(1), tube(0.4), facets(9), sides(5)),
                   egg(radius(0.7), up(1.3), down(0.6), facets(8)),
                   at([scale(1,-2,1),rotate(y,30)],
                      hemisphere(radius(1), facets(8))),
                   hollow_cylinder(radius(2), inner(1), height(1),
                                   facets(10)),
                   turning(outline([[0,0],[1,0],[1.2,0.3],[1.25,0.6],[1.1,1],
                                    [0,1.4]]), facets(9)) ]).
scene(union, [ union([at([translate(0,0,2)],
                         hemisphere(radius(1), facets(10))),
                      cylinder(radius(1), height(2), facets(10)),
                      at([translate(0.4,0,1)],
                         sphere(radius(1), facets(9)))]) ]).
scene(difference, [ at([scale(-1,2,1)],
                       difference([at([translate(0,0,-0.4)],
                                      sphere(radius(1), facets(10))),
                                   at([rotate(x,20),translate(0,0,-1.5)],
                                      cylinder(radius(0.4), height(4),
                                               facets(9)))])) ]).
scene(join, [ join([at([translate(3,0,0)], sphere(radius(1), facets(9))),
                    difference([cylinder(radius(1), height(1), facets(10)),
                                at([translate(1,0,0.5)],
                                   sphere(radius(0.4), facets(9)))])]) ]).
scene(moved_join, [ at([rotate(x,30),scale(1,2,1),translate(1,2,3)],
                       join([ box(size(0.2,0.2,0.2)),
                              at([translate(3,0,0)],
                                 sphere(radius(1), facets(9))),
                              cylinder(radius(1), height(1),
                                       facets(10)) ])) ]).
scene(cut, [ sphere(radius(1), facets(9)),
             at([translate(0.5,0.2,0.1)], torus(radius(1), tube(0.3),
                                                facets(9), sides(6))) ]).

seen(301, 65).
seen(20, 110).

:- begin_tests(known_surface_rule).

test(kernel, [ forall(( scene(Name, Terms), seen(Theta, Phi) )),
               nondet ]) :-
    in_new_world(( forall(nth1(S, Terms, Term),
                          assert_fact(segment(S, solid, Term))),
                   made_drawable(Name, Terms, Ss),
                   set_view(Theta, Phi, 0),
                   picture([segments(Ss)]),
                   forall(member(S, Ss), same_as_rule(S, 30)) )).

made_drawable(Name, Terms, Ss) :-
    length(Terms, N),
    numlist(1, N, Ss),
    (   atom(Name),
        Name \== cut
    ->  evaluate
    ;   retractall_facts(segment(_, _, _)),
        forall(member(Term, Terms), add_primitive(Term, _)),
        complete_segments(Ss),
        (   Name == cut
        ->  penetrate
        ;   true
        )
    ).

%   A join that was moved as a whole: its facets are of the same surfaces as
%   those of its parts, moved one by one.

test(moved_join, true(Wrong == [])) :-
    Steps = [rotate(x,30), scale(-1,2,1), translate(1,2,3)],
    Sphere = sphere(radius(1), facets(9)),
    Cylinder = cylinder(radius(0.5), height(4), facets(10)),
    in_new_world(( assert_fact(segment(1, solid,
                                       at(Steps, join([Sphere,Cylinder])))),
                   evaluate,
                   root_surfaces(Found) )),
    findall(Surface,
            ( member(Term, [Sphere,Cylinder]),
              in_new_world(( add_primitive(at(Steps, Term), S),
                             segment_surfaces(S, [Surface|_], _) )) ),
            Wanted),
    length(Found, 2),
    findall(Surface, ( member(Surface, Found),
                       \+ ( member(Same, Wanted), near(Surface, Same) ) ),
            Wrong).

root_surfaces(Found) :-
    root_segment(S),
    findall(Id-Surface, ( p(S, P, _), polygon_surface(S, P, Id, Surface) ),
            Pairs0),
    sort(1, @<, Pairs0, Pairs),
    pairs_values(Pairs, Found).

near(surface(Kind,Frame1,A,B), surface(Kind,Frame2,A,B)) :-
    maplist(near_number, Frame1, Frame2).

near_number(X, Y) :-
    abs(X-Y) < 1.0e-12.

:- end_tests(known_surface_rule).
