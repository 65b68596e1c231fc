/* Plates with flat faces that meet pipes: rules/unrolling/true_flat.pl,
true_plate.pl,
   true_rim.pl, and what is said of them. */
% covers: true_convex, true_seam
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(lists)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(development/seam_measure)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(solid/trimmed)).
:- use_module(rules(unrolling/true_flat)).
:- use_module(rules(unrolling/true_plate)).
:- use_module(rules(unrolling/true_table)).
:- use_module(rules(unfolding/unfold)).
:- use_module(tests('rules/pattern_measured')).
:- use_module(rules(unfolding/unfold_true)).
:- use_module(rules(unfolding/unfold_wish)).
:- use_module(tests('rules/sample')).

:- begin_tests(plates).

:- meta_predicate in_scene(+, 0).

in_scene(Terms, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Term, Terms), add_primitive(Term, _)),
               complete_segments,
               Goal )).

near(X, Y) :-
    near(X, Y, 1.0e-9).

near(X, Y, Off) :-
    abs(X-Y) =< Off*(1.0+abs(Y)).

box(S, X1-X2, Y1-Y2, Z1-Z2) :-
    aggregate_all(r(min(X), max(X), min(Y), max(Y), min(Z), max(Z)),
                  v(S, _, X, Y, Z), r(X1, X2, Y1, Y2, Z1, Z2)).


                /*******************************
                *          FLAT FACES          *
                *******************************/

test(box) :-
    in_scene([box(size(10,20,30))], ( flat_resized(1, 2.0, S),
                                      box(S, X, Y, Z) )),
    X-Y-Z == (-7.0-7.0)-(-12.0-12.0)-(-2.0-32.0).

test(turned_box) :-
    in_scene([at([rotate(axis(1,2,3),40),translate(1,2,3)],
                 box(size(10,20,30)))],
             ( flat_resized(1, -1.5, S), volume(S, Volume) )),
    near(Volume, 7*17*27).

volume(S, Volume) :-
    aggregate_all(sum(Part),
                  ( t(S, _, _, A, B, C), tetrahedron(S, A, B, C, Part) ),
                  Volume).

tetrahedron(S, A, B, C, Part) :-
    v(S, A, X1, Y1, Z1),
    v(S, B, X2, Y2, Z2),
    v(S, C, X3, Y3, Z3),
    Part is (X1*(Y2*Z3-Y3*Z2) - X2*(Y1*Z3-Y3*Z1) + X3*(Y1*Z2-Y2*Z1))/6.

%   Every face of a prism that is not convex, with a hole, is as far out.
test(prism) :-
    in_scene([prism(outline([[0,0],[40,0],[40,40],[20,15],[0,40]]),
                    holes([[[15,4],[25,4],[20,10]]]), height(30))],
             ( flat_resized(1, 0.5, S),
               forall(plane(1, P, A, B, C, D),
                      ( plane(S, P, A2, B2, C2, D2),
                        near(A, A2), near(B, B2), near(C, C2),
                        near(D2, D-0.5) )) )).

test(apex_of_four) :-
    in_scene([pyramid(base(20,20), height(30))],
             ( flat_resized(1, 1.0, S), box(S, _, _, Z1-Z2) )),
    near(Z1, -1.0),
    %  the sides lean by 10 in 30
    near(Z2, 30 + sqrt(30*30+10*10)/10).

%   The apex of this one becomes an edge: of 5 faces, each 1 farther out.
test(apex_that_parts, [forall(member(By, [1.0,-0.5])), true(Count == 6)]) :-
    in_scene([pyramid(base(20,10), height(30), shift(7,2))],
             ( flat_resized(1, By, S),
               aggregate_all(count, v(S, _, _, _, _), Count),
               aggregate_all(count, e(S, _, _, _, _), 18),
               forall(e(S, _, A, B, _), e(S, _, B, A, _)),
               forall(plane(1, P, NX, NY, NZ, D),
                      ( plane(S, P, NX2, NY2, NZ2, D2),
                        near(NX, NX2), near(NY, NY2), near(NZ, NZ2),
                        near(D2, D-By) )) )).

%   Not convex: an arrow in plan, with an apex over its four corners.
test(apex_of_a_hollow_one, fail) :-
    in_scene([polyhedron(points([[0,0,0],[20,-15,0],[5,0,0],[20,15,0],
                                 [6,1,20]]),
                         faces([[1,4,3,2],[1,2,5],[2,3,5],[3,4,5],[4,1,5]]))],
             flat_resized(1, 1.0, _)).

%   A pipe on a pyramid that is not square, of plate: where the apex parts is
%   far from where they meet. What is no box or pipe is wider than any pipe.
test(pipe_on_a_pyramid, [forall(member(S-Size, [1-outside,2-outside,
                                                2-inside]))]) :-
    patterns([ pyramid(base(120,100), height(107)),
               at([rotate(y,70),translate(0,0,40)],
                  cylinder(radius(15), height(150), facets(12))) ], S,
             [thickness(2),size(Size)], Ds,
             forall(( member(D, Ds), p(D, P, _) ),
                    once(t(D, P, _, _, _, _)))).

test(turned_round, fail) :-
    in_scene([box(size(10,20,30))], flat_resized(1, -6.0, _)).

test(sheet) :-
    in_scene([rectangle(size(10,20))],
             ( flat_resized(1, 2.0, S), box(S, X, Y, Z) )),
    X-Y-Z == (-5.0-5.0)-(-10.0-10.0)-(2.0-2.0).


                /*******************************
                *           MEETING            *
                *******************************/

%   patterns(Terms, S, Options, Ds, Goal)

:- meta_predicate patterns(+, +, +, -, 0).

patterns(Terms, S, Options, Ds, Goal) :-
    in_scene(Terms,
             ( true_patterns(S, wanted(none,[],[],[]), [trim(outside)|Options],
                             Ds),
               Goal )).

duct([box(size(200,100,80)),
      at([translate(10,0,40)], cylinder(radius(30), height(100)))]).

%   Set on, the pipe ends at the outside of the duct; set in, at its inside.
test(pipe_on_a_duct,
     [ forall(member(Size-In-Height, [ outside-false-60, outside-true-62,
                                       inside-false-58, inside-true-60,
                                       middle-false-59, middle-true-61 ])) ]) :-
    duct(Terms),
    patterns(Terms, 2, [thickness(2),size(Size),set_in(In)], [D|_],
             box(D, _, Y1-Y2, _)),
    near(Y2-Y1, Height, 1.0e-6).

%   The hole in a roof that leans by 30 degrees is an ellipse.
test(hole_in_a_roof,
     [ forall(member(In-R, [false-28,true-30])) ]) :-
    patterns([ at([rotate(y,30)], rectangle(size(400,300))),
               at([translate(0,0,-100)],
                  cylinder(radius(30), height(250), facets(12))) ], 1,
             [thickness(2),size(outside),set_in(In),chord(1.0e-3)], [D],
             area(D, Area)),
    Exact is 120000 - pi*R*R*2/sqrt(3),
    near(Area, Exact, 1.0e-6).

%   A hole over the ridge of a roof: on either side the part of an ellipse that
%   lies there, with its corners on the ridge, where a fold or a seam is; none
%   of the sides is lost. X is how far the pipe stands beside the ridge.
test(hole_over_a_ridge,
     [ forall(sampled([X],
                      member(X-Facets, [ 0-12, 0-7, 5-48, 5-12, 5-7, -9-24,
                                         -9-5, 17-12, 17-9, 17.9-12, 17.9-7,
                                         14.7-30 ]))) ]) :-
    patterns([ prism(outline([[-60,0],[60,0],[0,50]]), height(120)),
               at([rotate(x,-90),translate(X,20,60)],
                  cylinder(radius(18), height(120), facets(Facets))) ], 1,
             [chord(1.0e-4)], [D],
             ( forall(p(D, P, _), once(plane(D, P, _, _, _, _))),
               findall(Y, ridge_corner(D, Y), Ys),
               pattern_area(D, Area),
               pattern_measured(D, Measures) )),
    Slant is sqrt(60*60 + 50*50)/60,
    Exact is 120*120*(1+Slant) + 2*60*50 - pi*18*18*Slant,
    near(Area, Exact, 1.0e-6),
    near(Measures.pattern_area, Exact, 1.0e-6),
    Measures.bound == null,
    Half is sqrt(18*18 - X*X),
    Ys = [_|_],
    forall(member(Y, Ys), near(Y, Half, 1.0e-9)).

%   Where no arc is wanted that fine, corners are moved all the same.
test(coarse_over_a_ridge, Planes == 5) :-
    patterns([ prism(outline([[-60,0],[60,0],[0,50]]), height(120)),
               at([rotate(x,-90),translate(5,20,60)],
                  cylinder(radius(18), height(120), facets(24))) ], 1,
             [chord(10)], [D],
             ( forall(ridge_corner(D, Y), near(Y, sqrt(18*18-5*5))),
               aggregate_all(count, plane(D, _, _, _, _, _), Planes) )).

%   A pipe that ends within the wall: where its facets meet its end, corners of
%   the hole are on no true curve. Those facets have chords; no side is lost.
test(pipe_ends_in_the_wall, Planes-Told == 6-true) :-
    patterns([ box(size(61,73,73)),
               at([rotate(x,-55),rotate(y,21),translate(-16,-13,1)],
                  cylinder(radius(13), height(260), facets(12))) ], 1,
             [], [D],
             ( aggregate_all(count, plane(D, _, _, _, _, _), Planes),
               pattern_area(D, Area) )),
    (   Area < 2*(61*73*2 + 73*73)
    ->  Told = true
    ;   Told = false
    ).

%   The pipe goes over the ridge, but its facets do not: no side is lost.
test(facets_miss_a_ridge, Count == 5) :-
    patterns([ prism(outline([[-60,0],[60,0],[0,50]]), height(120)),
               at([rotate(x,-90),translate(17,20,60)],
                  cylinder(radius(18), height(120), facets(9))) ], 1,
             [], [D],
             ( complete_segments,
               aggregate_all(count, plane(D, _, _, _, _, _), Count) )).

%   ridge_corner(D, Y): Y is how far a corner of the hole is from the middle of
%   the roof, 120 long, along the ridge.
ridge_corner(D, Y) :-
    joint(D, _, E, _, _, Angle),
    Angle > 79.0,
    Angle < 80.0,
    e(D, E, V, W, _),
    v(D, V, X1, Y1, _),
    v(D, W, X2, Y2, _),
    Y is 60 - sqrt((X1-X2)**2 + (Y1-Y2)**2).

area(D, Area) :-
    aggregate_all(sum(Part), triangle_area(D, Part), Area).

triangle_area(D, Area) :-
    t(D, _, _, A, B, C),
    v(D, A, X1, Y1, _),
    v(D, B, X2, Y2, _),
    v(D, C, X3, Y3, _),
    Area is ((X2-X1)*(Y3-Y1) - (X3-X1)*(Y2-Y1))/2.

%   A square duct on a round header: the header's hole is that of its inside.
test(duct_on_a_pipe) :-
    Terms = [cylinder(radius(100), height(300)),
             at([rotate(y,90),translate(0,0,150)],
                prism(outline([[-30,-30],[30,-30],[30,30],[-30,30]]),
                      height(180)))],
    patterns(Terms, 1, [thickness(2),size(outside)], [D|_], area(D, Area)),
    patterns(Terms, 1, [thickness(0)], [D2|_], area(D2, Whole)),
    %  56 wide on 100, but drawn in the neutral layer, 99
    Cut is 56*2*99*asin(28/100.0),
    Cut0 is 60*2*100*asin(30/100.0),
    Exact is Whole + Cut0 - 2*pi*300 - Cut,
    near(Area, Exact, 2.0e-4).

%   Pipes of one radius meet in a mitre, by their middles: at 90 degrees the
%   shortest generator ends by the middle radius below the other axis.
test(mitre,
     [ forall(member(Size-R, [outside-29,middle-30,inside-31])) ]) :-
    patterns([ cylinder(radius(30), height(100)),
               at([rotate(y,90),translate(-200,0,100)],
                  cylinder(radius(30), height(200))) ], 1,
             [thickness(2),size(Size)], [D|_],
             ( box(D, X1-X2, _, _), seam_drawn(D, Seam, _) )),
    near(X2-X1, 2*pi*R),
    near(Seam, 100-R, 1.0e-6).

%   The seam of a header goes round its hole.
test(seam_beside_the_hole) :-
    patterns([ cylinder(radius(50), height(300)),
               at([rotate(y,90),translate(0,0,150)],
                  cylinder(radius(30), height(150))) ], 1, [], [D|_],
             seam_drawn(D, Seam, Longest)),
    near(Seam, 300),
    near(Longest, 300).

%   So it does in whatever is round, wherever its shortest generator is.
round_with_hole(cone(radius(90), top(30), height(200), shift(30,0))).
round_with_hole(transition(base(circle(90)), top(circle(50)), height(200),
                           shift(30,0))).
round_with_hole(transition(base(rectangle(200,200)), top(circle(50)),
                           height(200))).
round_with_hole(transition(base(ellipse(90,60)), top(circle(50)),
                           height(200), shift(0,20))).

test(seam_beside_any_hole,
     [forall(( round_with_hole(Term), member(Turn, [0,90]) ))]) :-
    patterns([ Term,
               at([rotate(y,90),rotate(z,Turn),translate(0,0,100)],
                  cylinder(radius(20), height(150))) ], 1, [], [D|_],
             seam_drawn(D, Seam, Longest)),
    near(Longest, Seam).

%   The steps of a generator that the hole interrupts go past the hole.
test(steps_past_a_hole) :-
    patterns([ cylinder(radius(50), height(300)),
               at([rotate(y,90),translate(0,0,150)],
                  cylinder(radius(30), height(150))) ], 1,
             [generators(12),seam(180)], [D|_], true_length_rows(D, Rows)),
    findall(Number-StepFrom-StepTo,
            member(row(Number,_,_,_,_,_,StepFrom,StepTo,_), Rows), Steps),
    length(Steps, 16),
    Step is 2*pi*50/12,
    forall(member(_-A-B, Steps),
           (   A == none
           ->  B == none
           ;   near(A, Step),
               near(B, Step)
           )),
    aggregate_all(count, member(_-none-_, Steps), 4).

%   What is said names what was asked for, and measures what is drawn.
test(named) :-
    duct(Terms),
    patterns(Terms, 2, [thickness(2),size(outside)], [D|_],
             pattern_measured(D, M)),
    _{segment:2, seam:Seam, longest:Longest} :< M,
    near(Seam, 60, 1.0e-6),
    near(Longest, Seam).

test(part_named, [true(S == 2)]) :-
    duct(Terms),
    in_scene(Terms, ( plate_parts(2, [1], [thickness(2),size(outside)], _,
                                  S1-_),
                      part_named(S1, S) )).

%   Legs of 40 and 60 and 100 wide: the seams of a bent tray begin where the
%   reliefs of its corners end, where the bends do.
test(seam_after_bending) :-
    in_scene([box(size(100,60,40))],
             ( unfold(1, [removed(top),thickness(1),size(outside),
                          bend_radius(1),k_factor(0.5)], D),
               seam_drawn(D, Seam, Longest) )),
    near(Seam, 4*38.0),
    near(Longest, 38.0).

:- end_tests(plates).
