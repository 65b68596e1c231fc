% covers: seen
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(csg/csg)).
:- use_module(rules(shading/seen)).
:- use_module(rules(shading/shading_scene)).
:- use_module(rules(store)).
:- use_module(tests('rules/polyhedron')).

/* Trees that are one solid are one picture: the same spans, as far as anything
   is seen, and the same depth and normal; and what is nothing is not seen. */

:- begin_tests(same_picture).

% The solids: flush, tangent, one in another, turned.
a(box(size(4,4,2))).
b(at([translate(1,1,1)], box(size(2,2,2)))).
c(at([rotate(axis(1,2,3),40)], cylinder(radius(1),height(3),facets(24)))).
d(sphere(radius(2),facets(24))).

solids(A, B, C, D) :-
    a(A),
    b(B),
    c(C),
    d(D).

same(commuted, union([A,B,C,D]), union([D,C,B,A])) :-
    solids(A, B, C, D).
same(commuted, intersection([A,D,B]), intersection([B,A,D])) :-
    solids(A, B, _, D).
same(de_morgan, difference([A,union([B,C])]),
     intersection([difference([A,B]),difference([A,C])])) :-
    solids(A, B, C, _).
same(de_morgan, difference([D,intersection([A,C])]),
     union([difference([D,A]),difference([D,C])])) :-
    solids(A, _, C, D).
same(twice, D, union([D,D])) :-
    d(D).
same(twice, difference([A,C]), union([difference([A,C]),A1])) :-
    solids(A, _, C, _),
    A1 = intersection([A,difference([A,C])]).
same(one_after_the_other, difference([difference([A,B]),C]),
     difference([A,union([B,C])])) :-
    solids(A, B, C, _).
same(halves, D, union([split(D,Plane,below),split(D,Plane,above)])) :-
    d(D),
    Plane = plane(1,2,3,0.5).
same(halves, C, union([split(C,Plane,below),split(C,Plane,above)])) :-
    c(C),
    Plane = plane(0,1,0,0).
same(mirrored_twice, C, at([mirror(x),translate(1,0,0),mirror(x)],
                           at([translate(1,0,0)], C))) :-
    c(C).
same(absorbed, A, union([A,intersection([A,B])])) :-
    solids(A, B, _, _).
same(glued, union([A,B,C,D]), glue([A,B,C,D])) :-
    solids(A, B, C, D).
same(glued, difference([D,union([A,C])]), difference([D,glue([A,C])])) :-
    solids(A, _, C, D).
same(boxes_on_one_another,
     box(size(2,2,2)),
     union([box(size(2,2,1)), at([translate(0,0,1)], box(size(2,2,1)))])).

nothing(difference([D,D])) :-
    d(D).
nothing(difference([C,union([C,D])])) :-
    solids(_, _, C, D).
nothing(intersection([box(size(1,1,1)),
                      at([translate(0,0,1)], box(size(1,1,1)))])).

view(view(300.0,65.0,0.0,parallel)).
view(view(270.0,90.0,0.0,parallel)).
view(view(300.0,65.0,20.0,central)).

scene(Term, View, Scene) :-
    assert_fact(segment(1, solid, Term)),
    shaded_model([1], Model),
    shaded_eye(Model, View, Eye0),
    (   View = view(_,_,_,central)
    ->  setarg(5, Eye0, 16.0)           % the nearest point would differ
    ;   true
    ),
    shaded_scene(Model, Eye0, place(12.5,-4.0,4.0), 100-100, Scene).

seen_parts(Term, View, Parts) :-
    in_new_world(( scene(Term, View, Scene),
                   findall(Y-Seen,
                           ( between(0, 24, I),
                             Y is 4*I + 0.625,
                             line_spans(Scene, Y, Spans),
                             joined(Spans, Joined),
                             sides(Joined, Scene, Y, Seen) ),
                           Parts) )).

joined([], []).
joined([span(X1,X2,_,_,_)|Spans], Joined) :-
    (   Spans = [span(X2,X3,_,_,_)|Rest]
    ->  joined([span(X1,X3,0,0,0)|Rest], Joined)
    ;   Joined = [X1-X2|Joined1],
        joined(Spans, Joined1)
    ).

sides([], _, _, []).
sides([X1-X2|Joined], Scene, Y, [X1-X2-Sides|Seen]) :-
    findall(Depth-[A,B,C],
            ( member(Part, [0.13,0.41,0.77]),
              X is (X1 + Part*(X2-X1))/256,
              seen_side(Scene, X, Y, Depth0, vector(A0,B0,C0)),
              maplist(rounded, [Depth0,A0,B0,C0], [Depth,A,B,C]) ),
            Sides),
    sides(Joined, Scene, Y, Seen).

rounded(X, Y) :-
    Y is round(X*1.0e5).

test(same, [ forall(( same(Name, Term1, Term2), view(View) )),
             true(Parts1 == Parts2) ]) :-
    atom(Name),
    seen_parts(Term1, View, Parts1),
    seen_parts(Term2, View, Parts2).
test(something_is_seen, true(Seen > 10)) :-
    same(_, _, Term),
    view(View),
    seen_parts(Term, View, Parts),
    aggregate_all(count, ( member(_-[_|_], Parts) ), Seen),
    !.
test(nothing, [ forall(( nothing(Term), view(View) )), true(Seen == []) ]) :-
    seen_parts(Term, View, Parts),
    findall(Y, member(Y-[_|_], Parts), Seen).

:- end_tests(same_picture).
