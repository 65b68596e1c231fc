/* Fittings against their closed forms: pipes of several pieces
   (rules/primitive/primitive_pipe.pl), and what CSG trees cut of plate
   (rules/unrolling/true_leaf.pl). */
% covers: true_mitre
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(csg/csg_term)).
:- use_module(rules(development/seam_measure)).
:- use_module(rules(model/model)).
:- use_module(rules(model/model_file)).
:- use_module(rules(model/parameter_about)).
:- use_module(rules(primitive/primitive)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(store)).
:- use_module(rules(unfolding/unfold)).
:- use_module(rules(unfolding/unfold_how)).
:- use_module(rules(unfolding/unfold_true)).
:- use_module(rules(unrolling/true_plate)).
:- use_module(rules(unrolling/true_table)).
:- use_module(tests(rules/unrolling/measured_near)).

:- begin_tests(fittings).

:- meta_predicate in_model(+, 0).

%   in_model(Facts, Goal): in a world of these facts, its trees evaluated.

in_model(Facts, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Fact, Facts), fact_in(Fact)),
               evaluate,
               complete_segments,
               Goal )).

fact_in(segment(_, _, Term)) :-
    is_primitive(Term),
    \+ is_node_term(Term),
    !,
    add_primitive(Term, _).
fact_in(Fact) :-
    assert_fact(Fact).

%   true_rows(S, Removed, Options, Rowss): the tables of true lengths of the
%   patterns of segment S, and their areas.

true_rows(S, Wishes, Options, Patterns) :-
    findall(wish(Wish, fact), member(Wish, Wishes), Wanted0),
    wanted_of(S, Wanted0, Wanted),
    true_patterns(S, Wanted, Options, Ds),
    findall(Area-Rows,
            ( member(D, Ds),
              segment(D, _, true_development(_, _)),
              true_length_rows(D, Rows),
              pattern_area(D, Area) ),
            Patterns).


                /*******************************
                *            ELBOWS            *
                *******************************/

%   elbow(D, R, Pieces, Angle, Ends, Thickness, Size, K, Seam)

elbow(100, 150, 4, 90, 0, 0, middle, 0.5, 0).
elbow(114.3, 171.45, 5, 90, 0, 6.3, outside, 0.5, 180).
elbow(114.3, 152, 2, 90, 120, 6.3, outside, 0.4, 0).
elbow(508, 762, 7, 90, 50, 12.7, outside, 0.5, 90).
elbow(300, 250, 3, 45, 100, 4, inside, 0.5, 0).
elbow(300, 160, 5, 60, 0, 5, middle, 0.3, 270).
elbow(80, 400, 9, 180, 10, 2, inside, 0.45, 0).
elbow(60, 90, 2, 30, 40, 0, middle, 0.5, 0).

test(elbow, [forall(elbow(D, R, N, A, L, T, Size, K, Seam))]) :-
    Term = elbow(diameter(D), radius(R), pieces(N), angle(A), ends(L),
                 facets(24)),
    in_model([segment(1, solid, Term)],
             true_rows(1, [removed([base,top])],
                       [ thickness(T), size(Size), k_factor(K), seam(Seam),
                         generators(12)
                       ], Patterns)),
    length(Patterns, N),
    middle_radius(Size, D, T, Middle),
    neutral_radius(Size, D, T, K, Neutral),
    Half is A*pi/(360.0*(N-1)),
    forall(nth1(I, Patterns, Area-Rows),
           ( (   memberchk(I, [1,N])
             ->  Gores = 1,
                 Straight = L
             ;   Gores = 2,
                 Straight = 0
             ),
             length(Rows, 13),
             forall(nth0(J, Rows, row(_, _, Arc, _, _, Length, _, _, _)),
                    ( At is (Seam + 30*J)*pi/180.0,
                      Exact is Straight
                               + Gores*(R - Middle*cos(At))*tan(Half),
                      near(Length, Exact),
                      near(Arc, Neutral*J*pi/6.0) )),
             ExactArea is 2*pi*Neutral*(Straight + Gores*R*tan(Half)),
             near(Area, ExactArea, 1.0e-6) )).

middle_radius(inside, D, T, R) :- R is (D+T)/2.0.
middle_radius(middle, D, _, R) :- R is D/2.0.
middle_radius(outside, D, T, R) :- R is (D-T)/2.0.

neutral_radius(Size, D, T, K, R) :-
    middle_radius(Size, D, T, Middle),
    R is Middle - T/2.0 + K*T.

%   The same pieces, cut out of pipes by planes by hand, trimmed by each other
%   or not.
test(split_in_plate,
     [forall(member(Options,
                    [[], [trim(outside),by([2])]]))]) :-
    Pipe1 = at([translate(0,0,-200)], cylinder(radius(50), height(400))),
    Pipe2 = at([rotate(y,90),translate(-200,0,0)],
               cylinder(radius(50), height(400))),
    in_model([ segment(1, solid, split(Pipe1, plane(-1,0,1,0), below)),
               segment(2, solid, split(Pipe2, plane(-1,0,1,0), above))
             ],
             true_rows(1, [],
                       [thickness(4),size(outside),generators(8)|Options],
                       [Area-Rows])),
    near(Area, 96*pi*200, 1.0e-6),
    findall(Length, member(row(_, _, _, _, _, Length, _, _, _), Rows),
            Lengths0),
    msort(Lengths0, Lengths),
    Lengths = [Least,Least2|_],
    last(Lengths, Most),
    near(Least, 152),
    near(Least2, 152),
    near(Most, 248).

%   What is subtracted is a tool: a hole of radius 20 through a pipe, whichever
%   side of the plate is drawn.
test(tool_stays, [forall(member(Size-R, [inside-52,middle-50,outside-48]))]) :-
    Hole = at([translate(0,0,-200)], cylinder(radius(20), height(400))),
    Pipe = at([rotate(y,90),translate(-200,0,0)],
              cylinder(radius(50), height(400), facets(96))),
    in_model([segment(1, solid, difference([Pipe,Hole]))],
             ( true_rows(1, [], [thickness(4),size(Size)], Patterns),
               aggregate_all(max(Area), member(Area-_, Patterns), Area) )),
    findall(Strip,
            ( between(0, 9999, I),
              A is (I+0.5)*pi/20000,
              Strip is 4*pi/20000*20*cos(A)*20*cos(A)
                       /sqrt(1 - (20*sin(A)/R)**2) ),
            Strips),
    sum_list(Strips, Half),
    near(Area, 2*pi*R*400 - 2*Half, 1.0e-5).


                /*******************************
                *        MITRED PIPES          *
                *******************************/

%   An offset by 150 in 180: lengths along the axis, less or more by the mitres.
test(offset, [forall(member(T-R, [0-50.0,4-48.0]))]) :-
    Term = mitred_pipe(diameter(100),
                       through([[0,0,0],[0,0,120],[150,0,300],[150,0,500]])),
    in_model([segment(1, solid, Term)],
             true_rows(1, [removed([base,top])],
                       [thickness(T),size(outside),generators(4),seam(0)],
                       [_-Rows1,_-Rows2,_-Rows3])),
    Tan is tan(atan2(150, 180)/2),
    lengths(Rows1, [A1,B1,C1|_]),
    near(A1, 120 - R*Tan),
    near(B1, 120),
    near(C1, 120 + R*Tan),
    Slope is sqrt(150*150 + 180*180),
    lengths(Rows2, [A2,B2,C2|_]),
    maplist(near, [A2,B2,C2], [Slope,Slope,Slope]),
    lengths(Rows3, [A3,B3,C3|_]),
    near(A3, 200 + R*Tan),
    near(B3, 200),
    near(C3, 200 - R*Tan).

%   Pieces in three directions: none of it is in one plane, and the generators
%   of each piece go on where the next one begins.
test(in_space) :-
    Term = mitred_pipe(diameter(80),
                       through([[0,0,0],[0,0,200],[150,0,300],[150,220,400],
                                [400,220,400]]), facets(16)),
    in_model([segment(1, solid, Term)],
             ( true_rows(1, [removed([base,top])], [generators(16)], Patterns),
               aggregate_all(count, v(1, _, _, _, _), Count) )),
    Count =:= 16*5,
    Long2 is sqrt(150*150 + 100*100),
    Long3 is sqrt(220*220 + 100*100),
    forall(nth1(I, [200,Long2,Long3,250], Long),
           ( nth1(I, Patterns, Area-_),
             near(Area, 80*pi*Long, 1.0e-6) )).


                /*******************************
                *             WYES             *
                *******************************/

%   A generator of a leg, at the angle U from the plane of the axes, begins on
%   the mitre with the stem or with the other leg.

wye(100, 60, 120, 200, 0, 50.0).
wye(168.3, 90, 200, 250, 7.1, 80.6).
wye(200, 120, 150, 180, 3, 98.5).

test(wye, [forall(wye(D, A, Stem, Legs, T, R))]) :-
    Term = wye(diameter(D), angle(A), stem(Stem), legs(Legs), facets(48)),
    in_model([segment(1, solid, Term)],
             true_rows(1, [removed([base,cap])],
                       [thickness(T),size(outside),generators(24)],
                       [_-Rows1,_-Rows2,_-Rows3])),
    Half is A*pi/360.0,
    FromStem is tan(Half/2),
    FromLeg is 1/tan(Half),
    findall(Length,
            ( between(0, 24, I),
              U is I*pi/12,
              Length is Stem - R*abs(cos(U))*FromStem ),
            Stems),
    findall(Length,
            ( between(0, 24, I),
              Out is R*cos(I*pi/12),
              Length is Legs - max(-Out*FromStem, Out*FromLeg) ),
            Lengths),
    same_lengths(Rows1, Stems),
    same_lengths(Rows2, Lengths),
    same_lengths(Rows3, Lengths).


                /*******************************
                *             CONES            *
                *******************************/

%   The table of a cone agrees with its pattern, in whatever layer.
test(reducer,
     [forall(member(D-D2-H-T-Size-K,
                    [ 200-120-150-0-middle-0.5, 200-120-150-3-outside-0.5,
                      200-120-150-3-inside-0.4, 120-200-150-5-outside-0.5,
                      609.6-508-508-9.53-outside-0.5
                    ]))]) :-
    R1 is D/2.0,
    R2 is D2/2.0,
    in_model([segment(1, solid, cone(radius(R1), top(R2), height(H)))],
             true_rows(1, [removed([base,top])],
                       [thickness(T),size(Size),k_factor(K),generators(12)],
                       [Area-Rows])),
    Slant is sqrt(H*H + (R1-R2)**2),
    Sine is abs(R1-R2)/Slant,
    neutral_radius(Size, 0, T, K, Layer),
    Near is min(R1, R2)/Sine + Layer*H/abs(R1-R2),
    Far is Near+Slant,
    forall(nth0(I, Rows, row(_, _, Angle, From, To, Length, Step1, Step2, _)),
           ( near(Angle, I*30*Sine),
             near(min(From, To), Near),
             near(max(From, To), Far),
             near(Length, Slant),
             (   I < 12
             ->  Chord is 2*sin(15*Sine*pi/180),
                 near(min(Step1, Step2), Near*Chord),
                 near(max(Step1, Step2), Far*Chord)
             ;   true
             ) )),
    near(Area, pi*Sine*(Far*Far - Near*Near), 1.0e-3).


                /*******************************
                *            FAULTS            *
                *******************************/

fault(elbow(diameter(100), pieces(3)), missing(radius)).
fault(elbow(diameter(100), radius(150), pieces(1)), few(pieces, 1, 2)).
fault(elbow(diameter(100), radius(150), pieces(2), angle(180)),
      sharp_turn(2)).
fault(elbow(diameter(100), radius(150), turns(2)),
      unknown_argument(turns(2))).
fault(mitred_pipe(diameter(10), through([[0,0,0]])), few(through, 1, 2)).
fault(mitred_pipe(diameter(10), through([[0,0,0],[0,0,0]])), same_point(1)).
fault(mitred_pipe(diameter(10), through([[0,0,0],[0,0,9],[0,0,1]])),
      sharp_turn(2)).

test(fault, [forall(fault(Term, What)),
             error(model_error(primitive(What, Term)))]) :-
    in_model([segment(1, solid, Term)], true).

test(short_piece, error(model_error(primitive(short_piece(1, _, _),
                                              _)))) :-
    in_model([segment(1, solid, elbow(diameter(310), radius(150)))], true).
test(short_leg, error(model_error(primitive(short_piece(2, 100.0, _),
                                            _)))) :-
    in_model([segment(1, solid,
                      wye(diameter(100), angle(40), stem(90), legs(100)))],
             true).

%   A fitting is a node wherever one may be, and what it stands for is a solid.
test(operand) :-
    Elbow = elbow(diameter(20), radius(30)),
    in_model([segment(1, solid,
                      difference([ at([translate(5,0,0)], Elbow),
                                   box(size(100,100,5))
                                 ]))],
             forall(model_defect(Defect), Defect == none)).

test(odd, error(model_error(primitive(odd_facets(9), _)))) :-
    in_model([segment(1, solid, wye(diameter(10), stem(90), legs(100),
                                    facets(9)))],
             true).


                /*******************************
                *     SAID BY THE MODEL        *
                *******************************/

test(how, Options == [seam(7),true(true),thickness(4),size(outside),
                      seam(90)]) :-
    in_model([ segment(1, solid, box(size(1,1,1))),
               unfolding(1, true_lengths), unfolding(1, thickness(4)),
               unfolding(1, size(outside)), unfolding(1, seam(90)),
               unfolding(1, removed(top))
             ],
             how_wished(1, [seam(7)], Options)).

test(how_needs, error(model_error(unfold(1, size(inside),
                                         needs('thickness(T)'))))) :-
    in_model([ segment(1, solid, box(size(1,1,1))),
               unfolding(1, size(inside))
             ],
             how_wished(1, [], _)).

how_fault(thickness(-1), how_form('thickness(T), T from 0')).
how_fault(bend_radius(-1), how_form('bend_radius(R), R from 0')).
how_fault(other_thickness(a), how_form('other_thickness(T), T from 0')).
how_fault(trim(left), how_form('trim(outside) or trim(inside)')).
how_fault(generators(1), how_form('generators(N), N from 2 to 3600')).
how_fault(true_lengths(1), how_form(true_lengths)).
how_fault(k_factor(2), how_form('k_factor(K), K from 0 to 1')).

test(how_form, [forall(how_fault(Wish, What)),
                error(model_error(unfold(1, Wish, What)))]) :-
    in_model([segment(1, solid, box(size(1,1,1))), unfolding(1, Wish)],
             ( wishes(1, [], Wishes),
               wanted_of(1, Wishes, _) )).

test(how_twice, error(model_error(unfold(1, seam(90), twice(seam(0)))))) :-
    in_model([ segment(1, solid, cylinder(radius(1), height(1))),
               unfolding(1, true_lengths), unfolding(1, seam(0)),
               unfolding(1, seam(90))
             ],
             ( wishes(1, [], Wishes),
               wanted_of(1, Wishes, _) )).


                /*******************************
                *       WHAT CANNOT BE         *
                *******************************/

%   thickest(Term, Removed, Size, Most): plate must be thinner than Most. The
%   cone of 3:4:5 is 40 from its axis at the top: 40*4/5 at right angles to it.

thickest(cylinder(radius(50), height(90)), [base,top], outside, 50).
thickest(cylinder(radius(50), height(90)), [base,top], middle, 100).
thickest(cylinder(radius(50.0,20.0), height(90)), [base,top], outside, 20).
thickest(at([rotate(axis(1,2,3),40),translate(1,2,3)],
            cylinder(radius(50), height(90))), [base,top], outside, 50).
thickest(cone(radius(100), top(40), height(80)), [base,top], outside, 32).
thickest(at([mirror(z)], cone(radius(40), top(100), height(80))), [base,top],
         outside, 32).
thickest(cone(radius(100), top(40), height(80), shift(9,0)), [base,top],
         outside, 40).
thickest(elbow(diameter(100), radius(150), pieces(4), angle(90)), [base,top],
         outside, 50).
thickest(wye(diameter(100), angle(60), stem(150), legs(250)), [base,cap],
         outside, 50).
thickest(mitred_pipe(diameter(100), through([[0,0,0],[0,0,200],[90,0,400]])),
         [base,top], middle, 100).
thickest(transition(base(rectangle(300, 200)), top(circle(60)), height(90)),
         [base,top], outside, 60).
thickest(transition(base(rectangle(300, 90)), top(ellipse(80,60)),
                    height(90)), [base,top], outside, 45).
thickest(hemisphere(radius(50), facets(12), bands(6)), [base], outside, 50).
thickest(at([mirror(z)], hemisphere(radius(30), facets(12), bands(6))), [base],
         middle, 60).

test(too_thick, [ forall(thickest(Term, Removed, Size, Most)),
                  error(geometry_error(true(too_thick(1, T, Found)))) ]) :-
    T is Most*1.01,
    catch(in_model([segment(1, solid, Term)],
                   true_rows(1, [removed(Removed)],
                             [thickness(T),size(Size)], _)),
          error(geometry_error(true(too_thick(1, T, Found))), Context),
          ( near(Found, Most),
            throw(error(geometry_error(true(too_thick(1, T, Found))),
                        Context)) )).

test(thick_enough, [forall(thickest(Term, Removed, Size, Most))]) :-
    T is Most*0.9,
    in_model([segment(1, solid, Term)],
             ( plate_fits(1, [thickness(T),size(Size)]),
               plate_fits(1, [thickness(1000),size(inside)]),
               true_rows(1, [removed(Removed)],
                         [thickness(1),size(Size)], [_|_]) )).

%   A pointed cone has a tip that no plate leaves hollow: its base counts.
test(pointed, error(geometry_error(true(too_thick(1, 49, _))))) :-
    in_model([segment(1, solid, cone(radius(60), height(80)))],
             ( plate_fits(1, [thickness(47),size(outside)]),
               plate_fits(1, [thickness(49),size(outside)]) )).

%   A pipe of a CSG tree; what is bored out of it is no plate.
test(tree_too_thick, error(geometry_error(true(too_thick(1, 60, _))))) :-
    in_model([ segment(1, solid,
                       difference([ cylinder(radius(50), height(90)),
                                    at([rotate(y,90),translate(0,0,45)],
                                       cylinder(radius(9), height(99)))
                                  ]))
             ],
             ( plate_fits(1, [thickness(40),size(outside)]),
               true_rows(1, [removed([base,top])],
                         [thickness(60),size(outside)], _) )).

%   A branch that ends within its header is told by its own number, not by that
%   of the plate that is trimmed for it.
test(nothing_left, error(geometry_error(trim(nothing_left(2, outside))))) :-
    in_model([ segment(1, solid, at([rotate(y,90),translate(-250,0,0)],
                                    cylinder(radius(84), height(500)))),
               segment(2, solid, cylinder(radius(57), height(50)))
             ],
             true_rows(2, [removed([base,top])],
                       [ thickness(5), size(outside), trim(outside),
                         by([1]) ], _)).

:- end_tests(fittings).
