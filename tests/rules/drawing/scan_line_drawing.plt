/* One scan line from above: what is red is what seen_at/4 says, and backs of
   what adds, fronts of what takes away are never candidates. Open surfaces are
   seen from both sides. */
% covers: scan_line_file
:- module(test_scan_line_drawing, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(plunit)).
:- use_module(rules(drawing/scan_line_drawing)).
:- use_module(rules(model/model)).
:- use_module(rules(picture/view)).
:- use_module(rules(shading/seen)).
:- use_module(rules(shading/shading_scene)).
:- use_module(rules(store)).
:- use_module(tests('rules/polyhedron')).

%   lines_of(Scene, Y, Role, Lines): S-Points of each stroke of Role.

lines_of(Scene, Y, Role, Lines) :-
    scan_line_drawing(Scene, Y, drawing(_, [view('',Strokes,[])])),
    findall(S-Points, member(stroke(visible,Role,S,[],Points,_,_), Strokes),
            Lines).

%   red(Lines, Scale, X, Ss): segments of Lines that are at X, in dots.

red(Lines, Scale, X, Ss) :-
    findall(S,
            ( member(S-Points, Lines),
              Points = [X1-_|_],
              last(Points, X2-_),
              At is X*Scale*1000,
              X1 =< At,
              At < X2 ),
            Ss).

file_scene(File, Scene) :-
    load_model(File, [evaluate(false),rows(false)]),
    shading_scene(420-300, Scene).

:- begin_tests(scan_line_drawing).

test(red_is_seen,
     forall(member(File-Y, [ 'facts/figures/csg05.pl'-170.5,
                             'facts/figures/csg06.pl'-120.5,
                             'facts/shaded_block.pl'-140.5 ]))) :-
    in_new_world((
        file_scene(File, Scene),
        lines_of(Scene, Y, penetration, Lines),
        Scale is 210.0/420,
        findall(X-Ss-Seen,
                ( between(0, 418, I),
                  X is I + 0.517,
                  red(Lines, Scale, X, Ss),
                  (   seen_at(Scene, X, Y, seen(_,Leaf,_))
                  ->  once(scene_leaf(Scene, leaf(Leaf,_,S,_,_))),
                      Seen = [S]
                  ;   Seen = []
                  ) ),
                All),
        aggregate_all(count, member(_-[_]-_, All), N),
        N > 100,
        forall(member(_-Ss-Seen, All), Ss == Seen)
    )).

%   Of the box two fronts, of what is taken away two backs, and the others.
test(candidates, Segments-Never == [1,1,2,2]-[1,1,2,2]) :-
    in_new_world((
        file_scene('facts/figures/csg05.pl', Scene),
        lines_of(Scene, 170.5, outline, Lines),
        lines_of(Scene, 170.5, construction, Others)
    )),
    pairs_keys(Lines, Segments0),
    msort(Segments0, Segments),
    pairs_keys(Others, Never0),
    msort(Never0, Never).

%   A patch over a ball, from above and from below: it hides, and is hidden.
test(surface_has_two_sides,
     forall(member(Phi-Seens, [0-[1,1], 180-[1,2]]))) :-
    in_new_world((
        assert_fact(segment(1, surface, rectangle(size(4,4)))),
        assert_fact(segment(2, solid, at([translate(0,0,-2)],
                                         sphere(radius(1),facets(24))))),
        assert_fact(segment(3, surface, union([1,2]))),
        set_view(270, Phi, 0),
        shading_scene(100-100, Scene),
        findall(S,
                ( member(X, [10.5,50.5]),
                  seen_at(Scene, X, 50.5, seen(3,Leaf,_)),
                  once(scene_leaf(Scene, leaf(Leaf,_,S,_,_))) ),
                Ss)
    )),
    Ss == Seens.

% What is seen of a torus bends all the way, also where it goes on from one
% slice to the next.
test(seen_torus_is_nowhere_flat, Flat-Some == []-true) :-
    in_new_world((
        assert_fact(segment(1, solid, torus(radius(3),tube(1),facets(48)))),
        shading_scene(420-300, Scene),
        findall(Y-X1-X2,
                ( member(Y, [100.3,150.3,170.3]),
                  lines_of(Scene, Y, penetration, Lines),
                  member(_-Points, Lines),
                  append(_, [X1-Z,_-Z,X2-Z|_], Points),
                  X2-X1 > 1500 ),
                Flat),
        lines_of(Scene, 150.3, penetration, [_|More]),
        ( More == [] -> Some = false ; Some = true )
    )).

:- end_tests(scan_line_drawing).
