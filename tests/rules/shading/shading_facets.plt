/* Shaded pictures of the facets that files have. */
:- module(test_shading_facets, []).
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(csg/csg)).
:- use_module(rules(picture/view)).
:- use_module(rules(shading/seen)).
:- use_module(rules(shading/shading_facets)).
:- use_module(rules(shading/shading_scene)).
:- use_module(rules(store)).
:- use_module(shaded_model).

:- begin_tests(shading_facets).

%   Seen from above, 100 dots to a unit.
scene(Model, Scene) :-
    shaded_eye(Model, view(270.0,0.0,1.0,parallel), Eye),
    shaded_scene(Model, Eye, place(100.0,-2.0,2.0), 400-400, Scene).

area(Scene, Area) :-
    aggregate_all(sum(A),
                  ( between(0, 399, I), Y is I+0.5, line_spans(Scene, Y, Spans),
                    member(span(X1,X2,_,_,_), Spans), A is (X2-X1)/256.0e4 ),
                  Area).

term(cylinder(radius(1.5),height(1),facets(N)), N).
term(hollow_cylinder(radius(1.5),inner(0.5),height(1),facets(N)), N).
term(cone(radius(1.5),top(0.5),height(1),facets(N)), N).

round(hollow_cylinder(_,_,_,_), Area) :-
    !,
    Area is pi*2.
round(_, Area) :-
    Area is pi*2.25.

test(area, [ forall(( term(Term, N), member(N, [12,30]) )),
             true(Wrong == false) ]) :-
    facet_part(N, Part),
    round(Term, Round),
    format(string(Text), "segment(1, solid, ~q).", [Term]),
    in_model(Text,
             ( shaded_model([1], True),
               faceted_model(True, Model),
               scene(True, Scene1), area(Scene1, Area1),
               scene(Model, Scene2), area(Scene2, Area2) )),
    (   abs(Area1/Round - 1) < 0.0005,
        abs(Area2/Round/Part - 1) < 0.0005
    ->  Wrong = false
    ;   Wrong = Area1-Area2
    ).

%   What a polygon of N sides has of its circle.
facet_part(N, Part) :-
    Part is N/(2*pi)*sin(2*pi/N).

test(faces, Names == [base,top,curved(side)-24]) :-
    in_model("segment(1, solid, cylinder(radius(1),height(1),facets(24))).",
             ( shaded_model([1], Model0),
               faceted_model(Model0, model([leaf(_,_,_,_,Faces)],_,_)) )),
    aggregate_all(count, member(_-curved(side), Faces), N),
    findall(What, ( member(_-What, Faces), What \= curved(_) ), Flat),
    append(Flat, [curved(side)-N], Names).
test(flat_is_as_it_was, Model == Model0) :-
    in_model("segment(1, solid, box(size(1,2,3))).",
             ( shaded_model([1], Model0), faceted_model(Model0, Model) )).
test(off, true(abs(Off - 2*(1-cos(pi/24))) < 1.0e-9)) :-
    in_model("segment(1, solid, union([cylinder(radius(1),height(1),facets(24)),
                  at([translate(5,0,0)], sphere(radius(2),facets(24)))])).",
             ( shaded_model([1], Model), facets_off(Model, Off) )).
test(nothing_is_round, fail) :-
    in_model("segment(1, solid, box(size(1,2,3))).",
             ( shaded_model([1], Model), facets_off(Model, _) )).

:- end_tests(shading_facets).
