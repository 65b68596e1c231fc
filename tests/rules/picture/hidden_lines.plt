:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(picture/view)).
:- use_module(rules(kernel)).
:- use_module(rules(primitive/primitive)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(decision)).
:- use_module(tests('rules/polyhedron')).

box(S, Low, High) :-
    box_points(Low, High, Points),
    box_faces(Faces),
    polyhedron(S, solid, Points, Faces).

% What is drawn: the parts, and their lengths in the picture.
parts(Visibility, Role, N) :-
    aggregate_all(count, drawn(_,_,_,_,_,Visibility,Role), N).

drawn_length(Visibility, Length) :-
    aggregate_all(sum(L), drawn_length_(Visibility, L), Length).

drawn_length_(Visibility, Length) :-
    drawn(_, S, E, From, To, Visibility, _),
    e(S, E, V1, V2, _),
    screen(S, V1, X1, Y1, _),
    screen(S, V2, X2, Y2, _),
    Length is (To-From)*sqrt((X2-X1)**2+(Y2-Y1)**2).

near(X, Y) :-
    abs(X-Y) < 1.0e-9.

% A quadrangle seen from above, which turns right at its second corner.
bent_edges_lie(Z2, Z3, Z4) :-
    in_new_world(( polyhedron(1, surface,
                              [p(0,0,0), p(2,0,Z2), p(3,-1,Z3), p(0,3,Z4)],
                              [[1,2,3,4]]),
                   set_view(top), picture,
                   open_scene(Scene, []),
                   forall(( scene_edge(Scene, 1, E, _, Look),
                            e(1, E, V1, V2, _) ),
                          ( arg(4, Look, Left), left_in_picture(V1, V2, Left) ))
                 )).

left_in_picture(V1, V2, Left) :-
    t(1, _, _, A, B, C),
    select(V1, [A,B,C], [D,F]),
    select(V2, [D,F], [V3]),
    !,
    screen(1, V1, X1, Y1, _),
    screen(1, V2, X2, Y2, _),
    screen(1, V3, X3, Y3, _),
    (   (X2-X1)*(Y3-Y1) > (Y2-Y1)*(X3-X1)
    ->  Left =:= 1
    ;   Left =:= 0
    ).

:- begin_tests(hidden_lines).

test(square_box) :-
    in_new_world(( box(1, p(0,0,0), p(1,1,1)),
                   forall(member(Name, [front,back,left,right,top,bottom]),
                          ( set_view(Name), picture([lines(all)]),
                            parts(visible, _, 4), parts(hidden, _, 0) )) )).
test(box) :-
    in_new_world(( box(1, p(0,0,0), p(1,1,1)), set_view(300, 60, 5), picture,
                   parts(visible, outline, 6), parts(visible, crease, 3),
                   parts(hidden, crease, 3), parts(_, _, 12) )).
test(box_from_near) :-
    in_new_world(( box(1, p(-1,-1,-1), p(1,1,1)), set_view(270, 90, 5),
                   set_projection(central), picture,
                   parts(visible, outline, 4), parts(hidden, _, 8) )).
% A polygon that is not flat lies to the eye, at each of its edges, as the
% triangle does that has the edge.
test(bent_polygon_lies_as_its_triangle, Bad == []) :-
    findall(Z2-Z3-Z4,
            ( member(Z2, [-3,0,2]), member(Z3, [-4,-1,4]), member(Z4, [0,1,4]),
              \+ bent_edges_lie(Z2, Z3, Z4) ),
            Bad).
test(numbers_in_order, all(D == [1,2,3,4])) :-
    in_new_world(( box(1, p(0,0,0), p(1,1,1)), set_view(front), picture,
                   findall(D0, drawn(D0,_,_,_,_,_,_), Ds) )),
    member(D, Ds).
test(again) :-
    in_new_world(( box(1, p(0,0,0), p(1,1,1)), set_view(top), picture,
                   set_view(front), picture, parts(_, _, 4),
                   findall(x, screen(_,_,_,_,_), Xs), length(Xs, 8) )).
% What is kept of a model is used for the rows it was made from only.
test(changed_model, Ns == [4,5,4,8]) :-
    in_new_world(( box(1, p(0,0,0), p(1,1,1)), set_view(front), picture,
                   parts(_, _, N1),
                   facts_transaction(curve(2, [p(2,0,0), p(3,0,0)])), picture,
                   parts(_, _, N2), facts_undo, picture,
                   parts(_, _, N3),
                   facts_transaction(box(2, p(2,0,0), p(3,1,1))), picture,
                   parts(_, _, N4) )),
    Ns = [N1,N2,N3,N4].
test(changed_edge, Ns == [4,3,4]) :-
    in_new_world(( polyhedron(1, surface, [p(0,0,0),p(1,0,0),p(1,0,1),p(0,0,1)],
                              [[1,2,3,4]]),
                   set_view(front), picture, parts(_, _, N1),
                   facts_transaction(( retract_fact(p(1,1,Es)),
                                       retract_fact(e(1,2,V1,V2,1)),
                                       assert_fact(e(1,2,V1,V2,0)),
                                       assert_fact(p(1,1,Es)) )), picture,
                   parts(_, _, N2), facts_undo, picture,
                   parts(_, _, N3) )),
    Ns = [N1,N2,N3].
test(other_segments, Ns == [4,8,4]) :-
    in_new_world(( box(1, p(0,0,0), p(1,1,1)), box(2, p(2,0,0), p(3,1,1)),
                   set_view(front),
                   forall(member(_, [1,2]), picture([segments([1])])),
                   parts(_, _, N1), picture, parts(_, _, N2),
                   picture([segments([2])]), parts(_, _, N3) )),
    Ns = [N1,N2,N3].
% A picture is no step: what was done before it is taken back, and with it the
% picture.
test(no_step) :-
    in_new_world(( facts_transaction(box(1, p(0,0,0), p(1,1,1))), picture,
                   facts_undo, parts(_, _, 0), \+ screen(_,_,_,_,_),
                   \+ v(_,_,_,_,_), \+ facts_undo )).
test(empty_world) :-
    in_new_world(( picture, parts(_, _, 0) )).

test(curve_through_square) :-
    in_new_world(( polyhedron(1, surface,
                              [p(-1,-1,0),p(1,-1,0),p(1,1,0),p(-1,1,0)],
                              [[1,2,3,4]]),
                   curve(2, [p(0,0,-0.2), p(0,0,0), p(0,0,1)]),
                   set_view(270, 60, 5), picture,
                   findall(E-V, drawn(_,2,E,_,_,V,curve), Parts),
                   Parts == [1-hidden,2-visible], parts(visible, border, 4) )).
test(some_segments) :-
    in_new_world(( box(1, p(0,0,0), p(1,1,1)), box(2, p(0,-5,0), p(1,-4,1)),
                   set_view(front),
                   picture([segments([1])]), parts(visible, _, 4),
                   \+ drawn(_,2,_,_,_,_,_),
                   picture, parts(visible, _, 4), parts(hidden, _, 0),
                   \+ drawn(_,2,_,_,_,hidden,_) )).
test(two_lines_one_picture) :-
    in_new_world(( curve(1, [p(0,0,0), p(1,0,0)]),
                   curve(2, [p(0.5,1,0), p(2,1,0)]),
                   set_view(front), picture,
                   findall(d(S,F,T), drawn(_,S,_,F,T,_,_), Parts),
                   Parts = [d(1,0.0,1.0),d(2,F2,1.0)], near(F2, 1/3) )).
test(seen_end_on) :-
    in_new_world(( curve(1, [p(0,0,0), p(0,1,0), p(1,1,0)]),
                   set_view(front), picture, parts(_, _, 1) )).
test(crease_option) :-
    in_new_world(( prism(12, 1, 2, Points, Faces),
                   polyhedron(1, solid, Points, Faces), set_view(290, 60, 9),
                   picture, parts(_, crease, N), picture([crease(29)]),
                   parts(_, crease, M), M is N+10 )).
test(all_lines) :-
    in_new_world(( prism(12, 1, 2, Points, Faces),
                   polyhedron(1, solid, Points, Faces), set_view(290, 60, 9),
                   picture([lines(all)]), parts(_, smooth, 10) )).
test(one_copy_of_a_line) :-
    in_new_world(( forall(member(S-Y, [1-1,2-(-1)]),
                          polyhedron(S, surface,
                                     [p(0,0,0),p(1,0,0),p(0,Y,1)], [[1,2,3]])),
                   assert_fact(line(1, 1,1,1,2, 2,1,1,2)),
                   set_view(300, 30, 9), picture,
                   findall(S, drawn(_,S,_,_,_,_,penetration), [1]),
                   picture([lines(penetration)]), parts(_, _, 1),
                   picture([segments([2])]),
                   findall(S, drawn(_,S,_,_,_,_,penetration), [2]) )).
test(bad_lines, error(domain_error(lines, some))) :-
    picture([lines(some)]).
test(bad_segments, error(type_error(_, _))) :-
    in_new_world(picture([segments([a])])).
test(not_drawn, error(existence_error(drawn_edge, 99))) :-
    in_new_world(( project_world, open_scene(Scene, []),
                   occluder(Scene, 1, 99, _, _, _, _) )).

test(hidden_by, S-T == 2-1) :-
    in_new_world(( curve(1, [p(-1,1,0), p(1,1,0)]),
                   polyhedron(2, surface, [p(0,0,-1),p(1,0,-1),p(0,0,1)],
                              [[1,2,3]]),
                   set_view(front), project_world,
                   hidden_by(1, 1, S, T, From, To),
                   near(From, 0.5), near(To, 0.75) )).
test(hidden_by_polygon, Parts == [part(2,1,0.25,0.75)]) :-
    in_new_world(( curve(1, [p(-1,1,0), p(1,1,0)]),
                   polyhedron(2, surface,
                              [p(0.5,0,0),p(0,0,1),p(-0.5,0,0),p(0,0,-1)],
                              [[1,2,3,4]]),
                   set_view(front), project_world,
                   findall(part(S,P,From,To),
                           hidden_by_polygon(1, 1, S, P, From, To), Parts) )).
test(hidden_interval_order, all(F-T == [0.25-0.5,0.5-0.75])) :-
    in_new_world(( curve(1, [p(-1,1,0), p(1,1,0)]),
                   polyhedron(2, surface,
                              [p(0.5,0,0),p(0,0,1),p(-0.5,0,0),p(0,0,-1)],
                              [[1,2,4],[4,2,3]]),
                   set_view(front), project_world, open_scene(Scene, []),
                   findall(F0-T0, hidden_interval(Scene, 1, 1, F0, T0), Is) )),
    member(F-T, Is).

% Every mode of the joins, and no choice point after the last answer.
test(scene_edge_modes) :-
    in_new_world(( box(1, p(0,0,0), p(1,1,1)), set_view(300, 60, 5),
                   project_world, open_scene(Scene, []),
                   findall(S-E, scene_edge(Scene, S, E, _, _), All),
                   length(All, 12),
                   findall(E, scene_edge(Scene, 1, E, _, _), Es),
                   length(Es, 12),
                   findall(E, scene_edge(Scene, 2, E, _, _), []),
                   forall(member(E, Es),
                          findall(S, scene_edge(Scene, S, E, _, _), [1])) )).
test(scene_edge_det, Left == false) :-
    in_new_world(( box(1, p(0,0,0), p(1,1,1)), project_world,
                   open_scene(Scene, []),
                   call_cleanup(scene_edge(Scene, 1, 1, _, _), Det = true),
                   ( Det == true -> Left = false ; Left = true ) )).
test(occluder_det, Left == false) :-
    in_new_world(( curve(1, [p(-1,1,0), p(1,1,0)]),
                   polyhedron(2, surface, [p(0,0,-1),p(1,0,-1),p(0,0,1)],
                              [[1,2,3]]),
                   set_view(front), project_world, open_scene(Scene, []),
                   call_cleanup(occluder(Scene, 1, 1, _, _, _, _), Det = true),
                   ( Det == true -> Left = false ; Left = true ) )).

:- end_tests(hidden_lines).

% The fused kernel against the rules, on random scenes.
:- begin_tests(hidden_lines_kernel).

test(random_scenes) :-
    forall(between(1, 60, Seed), kernel_is_rule(Seed)).
test(degenerate_scenes) :-
    forall(( named_view(Name, _, _), member(Lines, [all,feature]),
             member(Kind, [parallel,central]) ),
           kernel_is_rule_on_grid(Name, Lines, Kind)).

kernel_is_rule(Seed) :-
    set_random(seed(Seed)),
    in_new_world((
        forall(between(1, 5, S), random_segment(S)),
        Theta is 360*random_float,
        Phi is 180*random_float,
        set_view(Theta, Phi, 9),
        random_member(Kind, [parallel,central]),
        set_projection(Kind),
        random_member(Lines, [all,feature]),
        same_pictures(Lines, Seed)
    )).

% Boxes on a small grid, so that everything touches or lies in line.
kernel_is_rule_on_grid(Name, Lines, Kind) :-
    set_random(seed(5)),
    in_new_world((
        forall(between(1, 6, S),
               (   random_between(0, 2, X), random_between(0, 2, Y),
                   random_between(0, 2, Z), random_between(1, 2, D),
                   X1 is X+D, Y1 is Y+1, Z1 is Z+1,
                   box(S, p(X,Y,Z), p(X1,Y1,Z1))
               )),
        set_view(Name),
        set_projection(Kind),
        same_pictures(Lines, Name-Kind)
    )).

same_pictures(Lines, Case) :-
    picture([lines(Lines),method(kernel)]),
    findall(d(A,B,C,D,E,F,G), drawn(A,B,C,D,E,F,G), Kernel),
    picture([lines(Lines),method(rule)]),
    findall(d(A,B,C,D,E,F,G), drawn(A,B,C,D,E,F,G), Rule),
    (   Kernel == Rule
    ->  true
    ;   throw(different_pictures(Case))
    ).

random_segment(S) :-
    random_member(Kind, [solid,surface,curve]),
    random_segment(Kind, S).

random_segment(curve, S) :-
    findall(P, ( between(1, 5, _), random_point(P) ), Points),
    curve(S, Points).
random_segment(surface, S) :-
    findall(P, ( between(1, 5, _), random_point(P) ), Points),
    polyhedron(S, surface, Points, [[1,2,3],[3,2,4],[4,2,5]]).
random_segment(solid, S) :-
    random_between(3, 9, N),
    R is 0.3+random_float,
    prism(N, R, 1.5, Points0, Faces),
    random_point(p(X,Y,Z)),
    moved(by(X,Y,Z), Points0, Points1),
    random_member(Move, [axes,by(0,0,0)]),
    moved(Move, Points1, Points),
    polyhedron(S, solid, Points, Faces).

random_point(p(X,Y,Z)) :-
    X is 3*random_float-1.5,
    Y is 3*random_float-1.5,
    Z is 3*random_float-1.5.

:- end_tests(hidden_lines_kernel).

% Rule files that replace the two decisions.
:- begin_tests(hidden_lines_decision).

in_rules(Text, Goal) :-
    tmp_file_stream(File, Out, [encoding(utf8),extension(pl)]),
    call_cleanup(
        ( write(Out, Text), close(Out), use_rules(File), Goal, no_rules(File) ),
        delete_file(File)).

behind_a_square :-
    curve(1, [p(-1,1,0), p(1,1,0)]),
    polyhedron(2, surface, [p(-0.5,0,-1),p(0.5,0,-1),p(0.5,0,1),p(-0.5,0,1)],
               [[1,2,3,4]]),
    set_view(front).

test(glass) :-
    in_new_world(( behind_a_square, picture, parts(hidden, curve, 1),
                   in_rules("may_hide(S2, T, S, E) :- S2 =\\= 2, \c
                                 default(may_hide(S2, T, S, E)).",
                            ( picture, parts(hidden, _, 0) )),
                   picture, parts(hidden, curve, 1) )).
%   One decision for two segments keeps the kernel: a box of glass in front
%   of another, the back of both, and what only some see through.

boxes :-
    box(1, p(0,0,0), p(1,1,1)),
    box(2, p(0.2,-5,0.1), p(1.3,-4,1.2)),
    box(3, p(-0.4,3,-0.3), p(0.4,4,0.4)),
    set_view(280, 75, 30).

same_by_rule :-
    picture([method(kernel),lines(all)]),
    findall(d(A,B,C,D,E,F,G), drawn(A,B,C,D,E,F,G), Kernel),
    picture([method(rule),lines(all)]),
    findall(d(A,B,C,D,E,F,G), drawn(A,B,C,D,E,F,G), Rule),
    Kernel == Rule.

test(glass_segment) :-
    in_new_world(( boxes, picture, drawn_length(hidden, H0),
                   in_rules("may_hide(S, _) :- S =\\= 2.",
                            ( same_by_rule, picture,
                              drawn_length(hidden, H),
                              \+ drawn(_,2,_,_,_,hidden,_),
                              once(drawn(_,1,_,_,_,hidden,_)) )),
                   H < H0 )).
test(some_pairs) :-
    in_new_world(( boxes,
                   in_rules("may_hide(S2, S) :- S-S2 \\== 3-1.",
                            ( same_by_rule, picture,
                              once(drawn(_,1,_,_,_,hidden,_)),
                              once(drawn(_,3,_,_,_,hidden,_)) )) )).
test(smooth_glass) :-
    in_new_world(( add_primitive(torus(radius(2), tube(0.7)), _),
                   add_primitive(at([translate(0,4,0)], box(size(1,1,1))), _),
                   complete_segments,
                   set_view(280, 75, 30), picture,
                   once(drawn(_,1,_,_,_,hidden,outline)),
                   in_rules("may_hide(S, _) :- S =\\= 1.",
                            ( same_by_rule, picture,
                              \+ drawn(_,1,_,_,_,hidden,_) )) )).
test(nothing_hides, N == 0) :-
    in_new_world(( boxes,
                   in_rules("may_hide(_, _) :- fail.",
                            ( same_by_rule, picture, parts(hidden, _, N) )) )).
test(own_role) :-
    in_new_world(( behind_a_square,
                   in_rules("edge_role(S, E, Look, Crease, Role) :- \c
                                 default(edge_role(S, E, Look, Crease, R)), \c
                                 ( R == curve -> Role = section ; Role = R ).",
                            ( picture, parts(visible, section, 2),
                              parts(_, curve, 0) )) )).
test(other_world) :-
    in_new_world(( behind_a_square,
                   in_rules("may_hide(_, _, _, _) :- fail.",
                            ( in_new_world(( behind_a_square, picture,
                                             parts(hidden, curve, 1) )),
                              picture, parts(hidden, _, 0) )) )).
test(listed, all(By == [default,default,default])) :-
    in_new_world(findall(B, ( member(D, [edge_role/5,may_hide/2,may_hide/4]),
                              decision(D, _, _, B) ), Bs)),
    member(By, Bs).

:- end_tests(hidden_lines_decision).
