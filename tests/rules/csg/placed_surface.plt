:- module(test_placed_surface, []).
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(prolog_wrap)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(csg/placed_surface)).
:- use_module(rules(model/model), [load_model/1]).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(unrolling/true_development)).
:- use_module(rules(unfolding/unfold)).
:- use_module(rules(unfolding/unfold_true)).

/* Copies that a CSG tree places, and what is made of them, unrolled as the
round surfaces that they are where they stand. */

%   of_tree(Term, S, Goal): segments 1, a cylinder, and 2, a box that is askew,
%   and S, a node that is Term.

:- meta_predicate of_tree(+, -, 0).

of_tree(Term, 9, Goal) :-
    new_world(World),
    in_world(World,
             ( add_primitive(named(can, cylinder(radius(2), height(5),
                                                 facets(16))), 1),
               add_primitive(at([rotate(y,40),translate(0,0,4)],
                                box(size(9,9,3))), 2),
               placed_too(Term),
               assert_fact(segment(9, solid, Term)),
               evaluate,
               complete_segments,
               once(Goal) )).

%   placed_too(Term): the copies that Term names.

placed_too(Term) :-
    forall(( sub_term(N, Term), member(N, [5,6]) ),
           ( Of is N-4,
             assert_fact(segment(N, solid, at([rotate(x,30),translate(9,0,0)],
                                              Of))) )).

sub_term(Term, Term).
sub_term(Sub, Term) :-
    compound(Term),
    arg(_, Term, Argument),
    sub_term(Sub, Argument).

%   area(S, Area, Polygons): of the round part of S, unrolled.

area(S, Area, Polygons) :-
    true_development(S, _, [], D),
    aggregate_all(count, p(D, _, _), Polygons),
    aggregate_all(sum(A), triangle_area(D, A), Area).

triangle_area(D, Area) :-
    t(D, _, _, A, B, C),
    v(D, A, X1, Y1, _),
    v(D, B, X2, Y2, _),
    v(D, C, X3, Y3, _),
    Area is ((X2-X1)*(Y3-Y1) - (X3-X1)*(Y2-Y1))/2.

%   The length of an ellipse.

ellipse(A, B, Length) :-
    N = 2000,
    aggregate_all(sum(Step),
                  ( between(1, N, I), T is 2*pi*I/N,
                    Step is sqrt((A*sin(T))**2+(B*cos(T))**2)*2*pi/N ),
                  Length).

near(A, B) :-
    abs(A-B) < 1.0e-3*abs(B).

very_near(A, B) :-
    abs(A-B) < 1.0e-9*abs(B).

%   all_known(Known): what each polygon is, asked one by one.

all_known(Known) :-
    findall(known(S, P, Faces, Polygons, Surfaces),
            ( segment(S, _, _),
              p(S, P, _),
              findall(What, placed_face(S, P, What), Faces),
              findall(Leaf-P0, placed_polygon(S, P, Leaf, P0), Polygons),
              findall(Surface, facet_surface(S, P, Surface), Surfaces) ),
            Known).

%   known_once(Term, Kind): the surface of segment 1, which is Term and then not
%   there any more.

known_once(Term, Kind) :-
    facts_snapshot(( add_primitive(Term, 1),
                     once(( p(1, P, _), facet_surface(1, P, Surface) )),
                     functor(Surface, Kind, _) )).

%   segment_asked(Goal, Times): how often Goal asks segment/3.

:- meta_predicate segment_asked(0, -).

segment_asked(Goal, Times) :-
    flag(test_segment_asked, _, 0),
    setup_call_cleanup(
        wrap_predicate(sg_store:segment(_, _, _), counted, Asked,
                       ( flag(test_segment_asked, N, N+1), Asked )),
        once(Goal),
        unwrap_predicate(sg_store:segment/3, counted)),
    flag(test_segment_asked, Times, Times).

saddle_unrolled :-
    asked_once(forall(member(S-Other, [1-2,2-1]),
                      ( wanted_of(S, [], Wanted),
                        true_patterns(S, Wanted,
                                      [true(true),trim(outside),by([Other])],
                                      Ds),
                        Ds = [_|_] ))).

:- begin_tests(placed_surface).

test(a_copy, [true(Polygons == 16)]) :-
    of_tree(at([rotate(x,30),translate(9,0,0)], 1), S,
            area(S, Area, Polygons)),
    near(Area, 4*pi*5).
test(what_is_cut_as_it_was, [forall(member(Term,
        [ at([rotate(x,30),translate(9,0,0)], difference([1,2])),
          difference([5,6]),
          at([rotate(y,200)], at([rotate(z,33)], difference([1,2]))) ])),
                             true(Polygons == Same)]) :-
    of_tree(difference([1,2]), S0, area(S0, Area0, Same)),
    of_tree(Term, S, area(S, Area, Polygons)),
    very_near(Area, Area0).
test(scaled_to_another_size) :-
    of_tree(at([scale(3,3,3),rotate(x,70)], 1), S, area(S, Area, _)),
    near(Area, 9*4*pi*5).
test(scaled_to_an_ellipse) :-
    of_tree(at([scale(1,2,1),rotate(x,30)], 1), S, area(S, Area, _)),
    ellipse(2, 4, Length),
    near(Area, 5*Length).
test(turned_over) :-
    of_tree(difference([1,2]), S0, area(S0, Area0, _)),
    of_tree(at([scale(-1,1,1)], difference([1,2])), S, area(S, Area, _)),
    very_near(Area, Area0).
test(its_surface, [true(C-W == point(9.0,0.0,0.0)-vector(0.0,0.0,-5.0))]) :-
    of_tree(at([rotate(x,180),translate(9,0,0)], 1), S,
            placed_surface(S, side, cylinder(C, _, _, W0))),
    W0 = vector(X,Y,Z),
    Y1 is round(Y*1.0e9)/1.0e9+0.0,
    W = vector(X,Y1,Z).
test(with_what_is_flat, [true(Count == 2)]) :-
    of_tree(difference([5,6]), S,
            ( wanted_of(S, [], Wanted),
              true_patterns(S, Wanted, [true(true)], Ds) )),
    length(Ds, Count).

test(asked_once, [forall(member(Term, [ difference([1,2]), union([5,2]),
                                        difference([5,6]) ])),
                  true(Once == Each)]) :-
    of_tree(Term, _, ( all_known(Each), asked_once(all_known(Once)) )).
test(another_segment_of_the_number, [true(Kinds == [cylinder,sphere])]) :-
    new_world(World),
    in_world(World, asked_once(maplist(known_once,
                                       [ cylinder(radius(1), height(1)),
                                         sphere(radius(1)) ],
                                       Kinds))).
test(asked_once_of_a_saddle, [true(Times < 1000)]) :-
    new_world(World),
    in_world(World,
             ( load_model('facts/patterns/saddle.pl'),
               complete_segments,
               segment_asked(saddle_unrolled, Times) )).

:- end_tests(placed_surface).
