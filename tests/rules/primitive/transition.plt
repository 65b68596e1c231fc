/* Transitions: rules/primitive/primitive_transition.pl, and their true
developments,
   rules/unrolling/true_composed.pl. */
% covers: transition_division, transition_facet, transition_outline
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(random)).
:- use_module(rules(development/development)).
:- use_module(rules(model/integrity)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(penetration/penetration)).
:- use_module(rules(primitive/primitive_face)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(solid/trimmed)).
:- use_module(rules(unrolling/true_development)).
:- use_module(rules(unrolling/true_plate)).
:- use_module(rules(unrolling/true_resized), [transition_resized/3]).
:- use_module(rules(unrolling/true_table)).
:- use_module(rules(unfolding/unfold_true)).
:- use_module(tests('rules/sample')).

:- begin_tests(transition).

:- meta_predicate in_scene(+, 0).

in_scene(Terms, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Term, Terms), add_primitive(Term, _)),
               complete_segments,
               Goal )).

:- meta_predicate developed(+, +, -, 0).

developed(Term, Options, D, Goal) :-
    in_scene([Term], ( true_development(1, side, Options, D), Goal )).

near(X, Y) :-
    near(X, Y, 1.0e-9).

near(X, Y, Off) :-
    abs(X-Y) =< Off*(1.0+abs(Y)).

area(D, Area) :-
    aggregate_all(sum(Part), triangle_area(D, Part), Area).

triangle_area(D, Area) :-
    t(D, _, _, A, B, C),
    v(D, A, X1, Y1, _),
    v(D, B, X2, Y2, _),
    v(D, C, X3, Y3, _),
    Area is ((X2-X1)*(Y3-Y1) - (X3-X1)*(Y2-Y1))/2.

pattern_area(Term, Options, Area) :-
    developed(Term, Options, D, area(D, Area)).

square_to_round(transition(base(rectangle(100,80)), top(circle(30)),
                           height(60))).

lengths(D, Lengths) :-
    true_length_rows(D, Rows),
    findall(Length, member(row(_,_,_,_,_,Length,_,_,_), Rows), Lengths).


                /*******************************
                *            SOLIDS            *
                *******************************/

%   Every vertex is below the plane of every side, or in it.

convex_hull(S) :-
    \+ ( plane(S, P, A, B, C, D),
         \+ ( face_of(S, P, What), memberchk(What, [base,top]) ),
         v(S, _, X, Y, Z),
         A*X + B*Y + C*Z + D > 1.0e-7 ).

faultless(S) :-
    \+ model_defect(S, _).

model_defect(S, Defect) :-
    integrity:model_defect(Defect),
    arg(1, Defect, S).

%   Sums of the six parts of a square to round, right above: prismatoid.
test(volume) :-
    Term = transition(base(rectangle(100,80)), top(circle(30)), height(60),
                      facets(400)),
    in_scene([Term], volume(1, Volume)),
    %  h/6 * (A1 + 4*Am + A2); the middle section is a rectangle 50 x 40 with
    %  corners of radius 15, all round
    Middle is (50+30)*(40+30) - (4-pi)*225,
    Exact is 60/6*(8000 + 4*Middle + pi*900),
    near(Volume, Exact, 1.0e-4).

volume(S, Volume) :-
    aggregate_all(sum(Part),
                  ( t(S, _, _, A, B, C), tetrahedron(S, A, B, C, Part) ),
                  Volume).

tetrahedron(S, A, B, C, Part) :-
    v(S, A, X1, Y1, Z1),
    v(S, B, X2, Y2, Z2),
    v(S, C, X3, Y3, Z3),
    Part is (X1*(Y2*Z3-Y3*Z2) - X2*(Y1*Z3-Y3*Z1) + X3*(Y1*Z2-Y2*Z1))/6.

outline(circle(R)) :- random_between(5, 40, R).
outline(ellipse(A,B)) :- random_between(5, 40, A), random_between(5, 40, B).
outline(rectangle(A,B)) :- random_between(10, 80, A), random_between(10, 80, B).
outline(rectangle(A,B,R)) :-
    random_between(10, 80, A),
    random_between(10, 80, B),
    R is min(A, B)/4.
outline(polygon([[-20,-15],[30,-10],[25,20],[-5,35]])).
outline(polygon([[X,Y],[30,0],[0,30]])) :-
    random_between(-50, 0, X),
    random_between(-50, 0, Y).

random_transition(Seed, transition(base(Base), top(Top), height(60), shift(X,Y),
                                   tilt(A,B), turn(C), facets(N))) :-
    set_random(seed(Seed)),
    findall(Outline, clause(outline(Outline), _), Forms),
    random_member(Form1, Forms),
    random_member(Form2, Forms),
    copy_term(Form1, Base),
    copy_term(Form2, Top),
    once(outline(Base)),
    once(outline(Top)),
    random_between(-30, 30, X),
    random_between(-30, 30, Y),
    random_between(0, 30, A),
    random_between(0, 360, B),
    random_between(0, 90, C),
    random_member(N, [12,17,40]).

test(random_ones_are_hulls,
     [ forall(numbered(25, 80, Seed)),
       true ]) :-
    random_transition(Seed, Term),
    catch(in_scene([Term], ( convex_hull(1), closed(1) )),
          error(model_error(primitive(planes_cross, _)), _), true).

closed(S) :-
    \+ ( e(S, _, A, B, _), \+ e(S, _, B, A, _) ).

%   A circle to a larger one is the oblique cone.
test(similar_arcs_are_a_cone) :-
    in_scene([transition(base(circle(40)), top(circle(30)), height(60),
                         shift(20,10))],
             ( smooth_surface(1, cone(1), Surface),
               \+ smooth_surface(1, cone(2), _) )),
    Surface = cone(_, vector(40.0,_,_), _, vector(20.0,10.0,60.0), K),
    near(K, 0.75).

test(equal_circles_are_a_cylinder) :-
    in_scene([transition(base(circle(30)), top(circle(30)), height(60),
                         shift(20,10))],
             smooth_surface(1, cone(1), Surface)),
    Surface = cylinder(_, _, _, _).

test(parallel_edges_are_trapezoids) :-
    in_scene([transition(base(rectangle(80,60)), top(rectangle(60,30)),
                         height(60), shift(20,10))],
             aggregate_all(count, p(1, _, _), N)),
    N == 6.

%   Each step along an arc becomes three. The flat sides stay as they are; and a
%   cone that no other one follows.
test(divided, [forall(member(Outlines,
                             [[base(rectangle(99,80)),top(circle(30))],
                              [base(circle(40)),top(ellipse(30,20))],
                              [base(rectangle(60,60,9)),top(circle(20))]]))
                ]) :-
    Common = [height(60),shift(10,5),tilt(15,40),facets(12)|Outlines],
    Whole =.. [transition|Common],
    Divided =.. [transition,divided(3)|Common],
    in_scene([Whole,Divided],
             ( faultless(2),
               findall(Fan, smooth_surface(1, side(_), Fan), Fans1),
               findall(Fan, smooth_surface(2, side(_), Fan), Fans2),
               round_facets(1, N1),
               round_facets(2, N2) )),
    maplist(near_surface, Fans1, Fans2),
    N2 =:= 3*N1.

round_facets(S, N) :-
    aggregate_all(count, face_of(S, _, curved(_, _)), N).

near_surface(Surface1, Surface2) :-
    term_numbers(Surface1, Numbers1),
    term_numbers(Surface2, Numbers2),
    maplist(near, Numbers1, Numbers2).

term_numbers(Term, Numbers) :-
    (   number(Term)
    ->  Numbers = [Term]
    ;   Term =.. [_|Terms],
        maplist(term_numbers, Terms, Lists),
        append(Lists, Numbers)
    ).

%   What lies between arcs that are not similar: the pattern has the facets that
%   are drawn, but is that of the smooth surface, few as they are: corners that
%   few and many facets have in common are equally far from each other.
smooth_between([base(circle(40)),top(ellipse(30,20))]).
smooth_between([base(circle(60)),top(circle(35)),tilt(20)]).
smooth_between([base(ellipse(25,40)),top(circle(30)),shift(20,-10),
                tilt(10,50)]).

test(smooth_surface_between,
     [forall(sampled([], smooth_between(Outlines)))]) :-
    rim_corners(Outlines, 8, 0.01, Corners8),
    rim_corners(Outlines, 16, 0.002, Corners16),
    findall(Off,
            ( member(P-A, Corners8),
              member(Q-B, Corners8),
              P @< Q,
              same_corner(P, Corners16, C),
              same_corner(Q, Corners16, D),
              distance(A, B, L1),
              distance(C, D, L2),
              Off is abs(L1-L2) ),
            Offs),
    length(Offs, Count),
    Count > 50,
    max_list(Offs, Most),
    Most < 0.01.

%   The same with a plate, whose neutral layer has as many parts.
test(plate_between, [forall(sampled([], smooth_between(Outlines)))]) :-
    Term =.. [transition,height(80),facets(8)|Outlines],
    in_scene([Term],
             ( complete_patterns([thickness(2),size(outside)], D),
               area(D, Area) )),
    Fine =.. [transition,height(80),facets(16)|Outlines],
    in_scene([Fine],
             ( complete_patterns([thickness(2),size(outside)], D1),
               area(D1, Area1) )),
    near(Area, Area1, 1.0e-4).

complete_patterns(Options, D) :-
    true_patterns(1, wanted(none, [], [], []), Options, [D|_]).

%   rim_corners(Outlines, Facets, Chord, Corners): Place-(X-Y), of corners of
%   the primitive that are once in the pattern.
rim_corners(Outlines, Facets, Chord, Corners) :-
    Term =.. [transition,height(80),facets(Facets)|Outlines],
    in_scene([Term],
             ( aggregate_all(count, face_of(1, _, curved(_, _)), Sides),
               complete_patterns([chord(Chord),seam(10)], D),
               aggregate_all(count, p(D, _, _), Polygons),
               once(from_v(D, _, S, _)),
               findall([X,Y,Z]-(X2-Y2),
                       ( v(1, _, X, Y, Z),
                         corner_copy(S, X, Y, Z, V),
                         findall(X1-Y1,
                                 ( from_v(D, W, S, V),
                                   v(D, W, X1, Y1, _) ),
                                 [X2-Y2]) ),
                       Corners) )),
    Polygons =< Sides+2,
    Polygons >= Sides.

corner_copy(S, X, Y, Z, V) :-
    v(S, V, X0, Y0, Z0),
    abs(X-X0) + abs(Y-Y0) + abs(Z-Z0) < 1.0e-6,
    !.

same_corner([X,Y,Z], Corners, Place) :-
    member([X1,Y1,Z1]-Place, Corners),
    abs(X-X1) + abs(Y-Y1) + abs(Z-Z1) < 1.0e-6,
    !.

distance(X1-Y1, X2-Y2, Distance) :-
    Distance is sqrt((X1-X2)**2 + (Y1-Y2)**2).

test(open, [true(Kind-N == surface-0)]) :-
    in_scene([open_transition(base(circle(30)), top(rectangle(50,60)),
                              height(60))],
             ( segment(1, Kind, _),
               aggregate_all(count,
                             ( face_of(1, _, What),
                               memberchk(What, [base,top]) ), N) )).

fault(transition(base(polygon([[0,0],[9,0],[3,3],[0,9]])), top(circle(3)),
                 height(5)), not_convex(_, _)).
fault(transition(base(polygon([[0,0],[9,0],[9,4],[9,9]])), top(circle(3)),
                 height(5)), not_convex(_, _)).
fault(transition(base(circle(30)), top(circle(30)), height(20), tilt(60)),
      planes_cross).
fault(transition(base(rectangle(10,6,4)), top(circle(30)), height(20)),
      corners_too_round(_)).
fault(transition(base(square(10)), top(circle(30)), height(20)),
      wrong_argument(_, _)).
fault(transition(base(circle(0)), top(circle(30)), height(20)),
      wrong_argument(_, _)).
fault(transition(base(circle(5)), height(20)), missing(top)).

test(faults, [forall(fault(Term, What))]) :-
    catch(in_scene([Term], true), error(model_error(primitive(What0, _)), _),
          true),
    subsumes_term(What, What0).


                /*******************************
                *         DEVELOPMENT          *
                *******************************/

%   Pythagoras: corners are at 50, 40; the circle is divided in 16.
test(generators_of_a_square_to_round) :-
    square_to_round(Term),
    developed(Term, [generators(16),seam(0)], D, true_length_rows(D, Rows)),
    length(Rows, 22),
    forall(( nth1(I, Rows, row(_,_,_,_,_,Length,_,_,_)),
             I > 1, I < 7 ),
           ( T is (I-2)*22.5*pi/180,
             X is 50 - 30*cos(T),
             Y is 40 - 30*sin(T),
             Exact is sqrt(X*X + Y*Y + 3600),
             near(Length, Exact) )),
    Rows = [row(1,_,_,_,_,First,_,_,_)|_],
    Exact1 is sqrt(20*20 + 3600.0),
    near(First, Exact1),
    last(Rows, row(1,_,_,_,_,Last,_,_,_)),
    near(Last, Exact1).

%   Four triangles, and four parts of cones by quadrature.
test(area_of_a_square_to_round) :-
    square_to_round(Term),
    pattern_area(Term, [chord(1.0e-4)], Area),
    Triangles is 100*sqrt(10*10+3600.0) + 80*sqrt(20*20+3600.0),
    cone_area(Cone),
    Exact is Triangles + 4*Cone,
    near(Area, Exact, 1.0e-5).

%   Half the integral of |g x g'|, by Simpson's rule.
cone_area(Area) :-
    N = 2000,
    findall(Part,
            ( between(0, N, I),
              T is I*pi/2/N,
              (   ( I =:= 0 ; I =:= N )
              ->  W = 1
              ;   W is 2 + 2*(I mod 2)
              ),
              GX is 30*cos(T)-50, GY is 30*sin(T)-40,
              DX is -30*sin(T), DY is 30*cos(T),
              CX is -60*DY, CY is 60*DX, CZ is GX*DY - GY*DX,
              Part is W*sqrt(CX*CX + CY*CY + CZ*CZ) ),
            Parts),
    sum_list(Parts, Sum),
    Area is Sum*(pi/2/N)/3/2.

%   The rims keep their lengths: those of the outlines.
test(rims_keep_their_lengths, [forall(member(Shift, [0-0,20-10,35-0]))]) :-
    Shift = X-Y,
    Term = transition(base(rectangle(100,80)), top(circle(30)), height(60),
                      shift(X,Y)),
    developed(Term, [chord(1.0e-5)], D, border(D, Border)),
    in_seam(Term, Seam),
    Exact is 360 + 2*pi*30 + 2*Seam,
    near(Border, Exact, 1.0e-5).

in_seam(Term, Length) :-
    developed(Term, [], D, ( lengths(D, [Length|_]) )).

border(D, Length) :-
    aggregate_all(sum(Part),
                  ( e(D, E, A, B, 1),
                    \+ joint(D, _, E, _, fold, _),
                    \+ joint(D, _, _, E, fold, _),
                    v(D, A, X1, Y1, _),
                    v(D, B, X2, Y2, _),
                    Part is sqrt((X1-X2)**2 + (Y1-Y2)**2) ),
                  Length).

%   Pieces that touch: no bend between them, whatever the tilt.
test(no_creases, [forall(member(Tilt, [0,20,35]))]) :-
    Term = transition(base(rectangle(100,80)), top(ellipse(30,20)), height(60),
                      shift(10,5), tilt(Tilt,70), turn(25)),
    developed(Term, [], D,
              aggregate_all(max(Bend), ( joint(D, _, _, _, fold, A),
                                         Bend is abs(A) ), Most)),
    Most < 1.0e-5.

%   Nor between cones that take turns; a generator and a diagonal for each part.
test(cones_in_turns) :-
    Term = open_transition(base(circle(60)), top(circle(35)), height(80),
                           tilt(20), facets(24)),
    developed(Term, [generators(12)], D,
              ( aggregate_all(max(Bend), ( joint(D, _, _, _, fold, A),
                                           Bend is abs(A) ), Most),
                lengths(D, Lengths) )),
    Most =:= 0.0,
    length(Lengths, 25).

%   A hood of flat sides is what develop/3 makes of its faces.
test(folds_of_a_hood) :-
    Term = transition(base(rectangle(80,80)), top(rectangle(60,60)),
                      turn(45), height(60), shift(20,10)),
    in_scene([Term],
             ( true_development(1, side, [], D),
               develop(1, [], D2),
               findall(A, ( joint(D, _, _, _, fold, A0), A0 =\= 0.0,
                            A is round(A0*1.0e6) ), As),
               findall(B, ( joint(D2, _, _, _, _, B0),
                            B is round(B0*1.0e6) ), Bs) )),
    length(As, 8),
    forall(member(A, As), memberchk(A, Bs)).

test(random_ones_unroll,
     [ forall(numbered(15, 40, Seed)) ]) :-
    random_transition(Seed, Term),
    catch(unrolls(Term), error(model_error(primitive(planes_cross, _)), _),
          true).

%   One piece, of the area of the facets or a little more, faultless.
unrolls(Term) :-
    in_scene([Term],
             ( true_development(1, side, [seam(33)], D),
               area(D, Area),
               aggregate_all(sum(Part), side_area(Part), Facets),
               aggregate_all(max(K), piece(D, _, K), Pieces),
               aggregate_all(count, joint(D, _, _, _, seam, _), Seams),
               aggregate_all(count, p(D, _, _), Polygons),
               aggregate_all(count, t(D, _, _, _, _, _), Triangles) )),
    Pieces =:= 1,
    Seams =:= 1,
    Triangles >= Polygons,
    Area >= Facets - 1.0e-6*Facets,
    Area =< 1.05*Facets.

side_area(Area) :-
    t(1, P, _, A, B, C),
    once(( face_of(1, P, What), \+ memberchk(What, [base,top]) )),
    v(1, A, X1, Y1, Z1),
    v(1, B, X2, Y2, Z2),
    v(1, C, X3, Y3, Z3),
    UX is X2-X1, UY is Y2-Y1, UZ is Z2-Z1,
    WX is X3-X1, WY is Y3-Y1, WZ is Z3-Z1,
    Area is sqrt((UY*WZ-UZ*WY)**2 + (UZ*WX-UX*WZ)**2 + (UX*WY-UY*WX)**2)/2.

%   Mirrored, it is as large, and still seen from outside.
test(mirrored) :-
    Term = transition(base(rectangle(100,80)), top(circle(30)), height(60),
                      shift(20,10), tilt(15,30)),
    pattern_area(Term, [chord(1.0e-4)], Area),
    pattern_area(at([mirror(x),rotate(z,20)], Term), [chord(1.0e-4)],
                 Mirrored),
    Area > 0,
    near(Area, Mirrored, 1.0e-6).

test(half) :-
    square_to_round(Term),
    pattern_area(Term, [seam(0)], Whole),
    pattern_area(Term, [seam(0),half(true)], Half),
    near(Half, Whole/2, 1.0e-9).

test(half_of_what_differs,
     [throws(error(geometry_error(true(not_symmetric(1, side))), _))]) :-
    developed(transition(base(rectangle(100,80)), top(circle(30)), height(60),
                         shift(20,10)), [half(true)], _, true).

%   Opened elsewhere, the pattern is as large.
test(seam_anywhere, [forall(member(Seam, [0,10,45,90,123.4,359.9]))]) :-
    square_to_round(Term),
    developed(Term, [seam(Seam)], D,
              ( area(D, Area), lengths(D, Lengths),
                aggregate_all(max(K), piece(D, _, K), 1) )),
    pattern_area(Term, [], Exact),
    near(Area, Exact, 1.0e-4),
    Lengths = [First|_],
    last(Lengths, Last),
    near(First, Last).

%   Drawn outside, the neutral layer has outlines smaller all round.
test(thickness,
     [ forall(member(Size-By, [inside-1.0,outside-(-1.0),middle-0.0])) ]) :-
    square_to_round(Term),
    A is 100+2*By,
    B is 80+2*By,
    R is 30+By,
    pattern_area(Term, [thickness(2),size(Size)], Area),
    pattern_area(transition(base(rectangle(A,B)), top(circle(R)), height(60)),
                 [], Exact),
    near(Area, Exact, 1.0e-5).

test(thick_polygon) :-
    Term = transition(base(polygon([[0,0],[60,0],[60,40],[0,40]])),
                      top(circle(10)), height(60)),
    transition_resized(Term, 2.0, Larger),
    Larger = transition(base(polygon(Corners)), top(circle(12.0)), height(60)),
    Corners = [[-2.0,-2.0],[62.0,-2.0],[62.0,42.0],[-2.0,42.0]].

%   Legs of a hood bend: each bend takes off BD of the neutral layer.
test(bends_take_off) :-
    Term = transition(base(rectangle(80,60)), top(rectangle(80,60)),
                      height(50)),
    developed(Term, [thickness(2),bend_radius(3),seam(0)], D, width(D, Width)),
    Off is (3+0.5*2)*(2-pi/2),
    Exact is 280 - 4*Off,
    near(Width, Exact).

width(D, Width) :-
    findall(X, ( p(D, _, Es), member(E, Es), e(D, E, A, _, _),
                 v(D, A, X, _, _) ), Xs),
    max_list(Xs, X1),
    min_list(Xs, X0),
    Width is X1-X0.

%   Then its generators lie on the folds still.
test(generators_go_with_bends) :-
    Term = transition(base(rectangle(80,60)), top(rectangle(50,60)),
                      height(50)),
    developed(Term, [thickness(2),bend_radius(3),seam(0)], D,
              forall(generator_mark(D, _, P, Q), side_at(D, P, Q))).

side_at(D, X1-Y1, X2-Y2) :-
    e(D, E, A, B, 1),
    \+ origin(D, e(E), generator(_, _, _, _, _)),
    v(D, A, X3, Y3, _),
    v(D, B, X4, Y4, _),
    (   abs(X1-X3)+abs(Y1-Y3)+abs(X2-X4)+abs(Y2-Y4) < 1.0e-6
    ;   abs(X1-X4)+abs(Y1-Y4)+abs(X2-X3)+abs(Y2-Y3) < 1.0e-6
    ),
    !.


                /*******************************
                *         PENETRATION          *
                *******************************/

%   A pipe through a flat side leaves an ellipse there.
test(hole_in_a_flat_side) :-
    square_to_round(Term),
    Pipe = at([rotate(y,90),translate(20,5,25)],
              cylinder(radius(12), height(80))),
    in_scene([Term,Pipe],
             ( trimmed(1, [2], outside, T),
               true_development(T, 1/side, [chord(1.0e-5)], D),
               area(D, Area) )),
    pattern_area(Term, [chord(1.0e-5)], Whole),
    Hole is pi*144*sqrt(20*20+3600.0)/60,
    near(Area, Whole-Hole, 1.0e-4).

%   Over the border of a flat side and a part of a cone: however many facets.
test(hole_over_a_border) :-
    hole_area(24, Coarse),
    hole_area(96, Fine),
    near(Coarse, Fine, 2.0e-4).

hole_area(N, Area) :-
    in_scene([transition(base(rectangle(100,80)), top(circle(30)), height(60),
                         facets(N)),
              at([rotate(y,90),translate(20,20,25)],
                 cylinder(radius(12), height(80), facets(N)))],
             ( trimmed(1, [2], outside, T),
               true_development(T, 1/side, [chord(1.0e-4)], D),
               area(D, Area) )).

:- end_tests(transition).
