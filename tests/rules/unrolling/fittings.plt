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

:- multifile user:message_hook/3.
:- dynamic user:message_hook/3.

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

near(X, Y) :-
    near(X, Y, 1.0e-9).

near(X, Y, Off) :-
    (   abs(X-Y) =< Off*(1.0+abs(Y))
    ->  true
    ;   print_message(error, format('~w is not ~w', [X,Y])),
        fail
    ).


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

lengths(Rows, Lengths) :-
    findall(Length, member(row(_, _, _, _, _, Length, _, _, _), Rows),
            Lengths).

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

%   From another seam on: the same ones, but for one that is there twice.

same_lengths(Rows, Exact0) :-
    lengths(Rows, [_|Lengths0]),
    Exact0 = [_|Exact1],
    msort(Lengths0, Lengths),
    msort(Exact1, Exact),
    maplist(near, Lengths, Exact).


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
                *     THE FILES, BY ORDER      *
                *******************************/

%   ordered(Name, Settings, S, Patterns): Area-Rows of the patterns of segment S
%   of facts/fittings/Name.pl with these parameters, as the file says.

ordered(Name, Settings, S, Patterns) :-
    format(atom(Local), 'facts/fittings/~w.pl', [Name]),
    absolute_file_name(sanggwan(Local), File),
    new_world(World),
    in_world(World,
             ( load_model(File, [parameters(Settings)]),
               other_parts(S, [], Others),
               how_wished(S, [by(Others)], Options),
               wishes(S, [], Wishes),
               wanted_of(S, Wishes, Wanted),
               true_patterns(S, Wanted, Options, Ds),
               findall(Area-Rows,
                       ( member(D, Ds),
                         segment(D, _, true_development(_, _)),
                         true_length_rows(D, Rows),
                         Rows = [_,_|_],
                         pattern_area(D, Area) ),
                       Patterns) )).

test(elbow_ordered,
     [forall(member(D-R-N-A-T-Seam,
                    [114.3-171.45-4-90-4-0, 60.3-76-2-45-2.9-180,
                     610-915-6-90-9.5-77]))]) :-
    ordered(elbow, [d=D,r=R,pieces=N,angle=A,t=T,seam=Seam], 1, Patterns),
    length(Patterns, N),
    Middle is (D-T)/2,
    Half is A*pi/(360*(N-1)),
    forall(nth1(I, Patterns, _-Rows),
           ( ( memberchk(I, [1,N]) -> K = 1 ; K = 2 ),
             forall(nth0(J, Rows, row(_, _, Arc, _, _, Length, _, _, _)),
                    ( Exact is K*(R - Middle*cos(J*pi/12 + Seam*pi/180))
                               *tan(Half),
                      near(Length, Exact),
                      near(Arc, J*pi/12*Middle) )) )).

test(offset_ordered,
     [forall(member(X-H-Seam, [150-180-0,40-300-90,200-200-(-33)]))]) :-
    ordered(offset, [d=100,x=X,h=H,ends=150,t=4,seam=Seam], 1,
            [_-Rows1,_-Rows2,_-Rows3]),
    Tan is tan(atan2(X, H)/2),
    Slope is sqrt(X*X + H*H),
    forall(nth0(J, Rows1, row(_, _, _, _, _, Length, _, _, _)),
           near(Length, 150 - 48*cos(J*pi/12 + Seam*pi/180)*Tan)),
    forall(member(row(_, _, _, _, _, Length, _, _, _), Rows2),
           near(Length, Slope)),
    forall(nth0(J, Rows3, row(_, _, _, _, _, Length, _, _, _)),
           near(Length, 150 + 48*cos(J*pi/12 + Seam*pi/180)*Tan)).

%   The inside of the branch meets the outside of the header; of one diameter
%   they meet by their middles.

tee(168.3, 114.3, 6, 5, 90, 0).
tee(168.3, 60.3, 6, 2.9, 45, 0).
tee(323.9, 168.3, 8, 6.3, 60, 40).
tee(323.9, 168.3, 8, 6.3, 110, -60).
tee(168.3, 168.3, 5, 5, 90, 0).
tee(168.3, 168.3, 5, 5, 60, 0).

test(tee_ordered, [forall(( tee(D, B, T, TB, A, E),
                            member(Seam, [0,130]) ))]) :-
    ordered(tee, [ d=D,b=B,t=T,tb=TB,angle=A,offset=E,height=400,length=1000,
                   seam=Seam ],
            2, [_-Rows]),
    (   D =:= B
    ->  Inside is (B-TB)/2,
        Outside is (D-T)/2
    ;   Inside is B/2-TB,
        Outside is D/2
    ),
    Neutral is (B-TB)/2,
    Radians is A*pi/180,
    forall(nth0(J, Rows, row(_, _, Arc, _, _, Length, _, _, _)),
           ( At is J*pi/12 + Seam*pi/180,
             Deep is sqrt(max(0.0, Outside**2 - (E + Inside*sin(At))**2)),
             Exact is 400 - (Deep + Inside*cos(At)*cos(Radians))/sin(Radians),
             near(Length, Exact),
             near(Arc, Neutral*J*pi/12) )).

test(wye_ordered, [forall(member(D-A-T-Seam,
                                 [ 114.3-60-4-0, 168.3-90-7.1-45,
                                   200-120-3-180 ]))]) :-
    ordered(wye, [d=D,angle=A,stem=200,legs=260,t=T,seam=Seam], 1,
            [_-Rows1,_-Rows2,_-Rows3]),
    R is (D-T)/2,
    Half is A*pi/360,
    findall(Length,
            ( between(0, 24, I),
              Length is 200 - R*abs(cos(I*pi/12))*tan(Half/2) ),
            Stems),
    findall(Length,
            ( between(0, 24, I),
              Out is R*cos(I*pi/12),
              Length is 260 - max(-Out*tan(Half/2), Out/tan(Half)) ),
            Legs),
    same_lengths(Rows1, Stems),
    same_lengths(Rows2, Legs),
    same_lengths(Rows3, Legs).

test(reducer_ordered,
     [forall(( member(D-D2-H-T, [168.3-114.3-140-4,114.3-168.3-100-3,
                                 508-323.9-508-9.5]),
               member(Seam, [0,90]) ))]) :-
    ordered(reducer, [d=D,d2=D2,h=H,t=T,seam=Seam], 1, [_-Rows]),
    Off is abs(D-D2)/2,
    Slant is sqrt(H*H + Off*Off),
    Sine is Off/Slant,
    Near is min(D, D2)/2/Sine - T/2*H/Off,
    forall(nth0(J, Rows, row(_, _, Angle, From, To, Length, _, _, _)),
           ( near(Angle, J*15*Sine),
             near(min(From, To), Near),
             near(max(From, To), Near+Slant),
             near(Length, Slant) )).

%   An eccentric one: at the angle t of the circles a generator runs by
%   g = (e + k*cos(t), k*sin(t), h), k the difference of the radii. Its length
%   is that of g in every layer. From t to t+dt it turns in the pattern by
%   |k|*|n|/(g*g) and its normal by |n x n'|/(n*n), where
%   n = (h*cos(t), h*sin(t), -e*cos(t)-k); so a layer T/2 within is as large as
%   the surface less T/2 times length times the turn of the normal.

test(eccentric_ordered,
     [forall(( member(D-D2-H-E-T, [168.3-114.3-140-27-4,168.3-114.3-140-(-60)-0,
                                   114.3-168.3-100-20-3,
                                   508-323.9-508-92.05-9.5]),
               member(Seam, [0,90,200]) ))]) :-
    ordered(reducer, [d=D,d2=D2,h=H,e=E,t=T,seam=Seam], 1, [Area-Rows]),
    K is (D2-D)/2,
    From is Seam*pi/180,
    forall(nth0(J, Rows, row(_, _, Angle, _, _, Length, _, _, _)),
           ( To is From + J*pi/12,
             generator_length(K, E, H, To, Exact),
             near(Length, Exact),
             integral(turned(K, E, H), From, To, Radians),
             near(Angle, Radians*180/pi) )),
    Whole is From + 2*pi,
    integral(ring(D/2, D2/2, E, H, T/2), From, Whole, Exact),
    near(Area, Exact, 1.0e-3).

generator_length(K, E, H, T, Length) :-
    Length is sqrt((E + K*cos(T))**2 + (K*sin(T))**2 + H*H).

turned(K, E, H, T, By) :-
    generator_length(K, E, H, T, Length),
    By is abs(K)*sqrt(H*H + (E*cos(T) + K)**2)/(Length*Length).

%   N' x N of the normal N, and its square.

ring(R1, R2, E, H, In, T, Area) :-
    K is R2-R1,
    generator_length(K, E, H, T, Length),
    turned(K, E, H, T, By),
    Z is E*cos(T) + K,
    Square is H*H + Z*Z,
    X1 is H*cos(T), Y1 is H*sin(T),
    X2 is -H*sin(T), Y2 is H*cos(T), Z2 is E*sin(T),
    CX is Y1*Z2 + Z*Y2,
    CY is -Z*X2 - X1*Z2,
    CZ is X1*Y2 - Y1*X2,
    Turn is sqrt(CX*CX + CY*CY + CZ*CZ)/Square,
    Area is abs(R2*R2 - R1*R1)/(K*K)*Length*Length/2*By - In*Length*Turn.

%   integral(F, A, B, I): of call(F, T, Value) from A to B, by Simpson's rule.

:- meta_predicate integral(2, +, +, -).

integral(F, A, B, I) :-
    N = 1000,
    Step is (B-A)/N,
    findall(Part,
            ( between(0, N, J),
              T is A + J*Step,
              call(F, T, Value),
              (   ( J =:= 0 ; J =:= N )
              ->  Part = Value
              ;   Part is Value*(2 + 2*(J mod 2))
              ) ),
            Parts),
    sum_list(Parts, Sum),
    I is Sum*Step/3.

%   The lengths from a corner of the neutral layer to points of its circle.
test(square_to_round_ordered,
     [forall(member(A-B-D-H-X-Y-T,
                    [300-200-160-150-0-0-2, 500-500-250-300-0-0-3,
                     200-400-180-220-0-0-0, 300-200-160-150-70-0-2,
                     500-500-250-300-(-130)-45-3]))]) :-
    ordered(square_to_round, [a=A,b=B,d=D,h=H,x=X,y=Y,t=T], 1, [_-Rows]),
    R is (D-T)/2,
    findall(Length, member(row(_, _, _, _, _, Length, _, _, _), Rows),
            Lengths),
    forall(( member(SX-SY, [1-1,-1-1,-1-(-1),1-(-1)]),
             between(0, 4, J) ),
           ( At is J*pi/8,
             Exact is sqrt((SX*(A-T)/2 - X - SX*R*cos(At))**2
                           + (SY*(B-T)/2 - Y - SY*R*sin(At))**2 + H*H),
             (   member(Length, Lengths),
                 abs(Length-Exact) < 1.0e-9*Exact
             ->  true
             ) )).

%   Trapezoids of the neutral layer, the opening moved by X; each loses half of
%   BD along its two bends, whose angle is that between the normals of the
%   sides.
test(hopper_ordered,
     [forall(member(T-R-X, [2-2-0,3-6-0,5-1-0,2-2-120,3-4-(-250)]))]) :-
    ordered(hopper, [a=600,b=500,c=200,d=150,h=400,t=T,r=R,x=X], 1, [Area-_]),
    A is 600-T, B is 500-T, C is 200-T, D is 150-T,
    OutY is (B-D)/2,
    SlantY is sqrt(400*400 + OutY*OutY),
    Layer is R + 0.5*T,
    findall(Part,
            ( member(OutX, [(A-C)/2 + X, (A-C)/2 - X]),
              SlantX is sqrt(400*400 + OutX**2),
              Edge is sqrt(400*400 + OutX**2 + OutY*OutY),
              Turn is acos(OutX*OutY/(SlantX*SlantY)),
              Deduction is 2*tan(Turn/2)*Layer - Turn*Layer,
              Part is SlantX*(B+D)/2 - 4*Edge*Deduction/2 ),
            Parts),
    sum_list(Parts, Sides),
    Exact is Sides + SlantY*(A+C),
    near(Area, Exact).

%   Barrel, cone and pipes of the cyclone are as wide as their neutral layers.
test(cyclone_ordered, [forall(member(D-T, [300-2,800-4]))]) :-
    ordered(cyclone, [d=D,t=T], 2, [_-[row(_, _, _, Near, Far, _, _, _, _)|_]]),
    Off is (D - 0.375*D)/2,
    Slant is sqrt((2.5*D)**2 + Off*Off),
    near(abs(Far-Near), Slant),
    near(max(Near, Far), D/2*Slant/Off - T/2*2.5*D/Off),
    forall(member(S-Width, [3-0.375,5-0.5]),
           ( ordered(cyclone, [d=D,t=T], S, [_-Rows]),
             last(Rows, row(_, _, Arc, _, _, _, _, _, _)),
             near(Arc, pi*(Width*D - T)) )),
    ordered(cyclone, [d=D,t=T], 1, [_-Barrel]),
    last(Barrel, row(_, _, Around, _, _, _, _, _, _)),
    near(Around, pi*(D-T)).


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

%   What no fitting can have is refused, or told with its range. What has none
%   may be to either side. The range of another size may follow from it.
test(bad_values, [forall(member(Name, [elbow,tee,wye,offset,reducer,
                                       square_to_round,hopper,cyclone])),
                  nondet]) :-
    format(atom(Local), 'facts/fittings/~w.pl', [Name]),
    absolute_file_name(sanggwan(Local), File),
    new_world(World),
    in_world(World, ( load_model(File, []),
                      findall(P, param(P, _), Ps) )),
    Ps = [_,_|_],
    forall(( member(P, Ps), member(Value, [0,-3,-500,2.5]) ),
           value_right(Name, File, P, Value)).

free(reducer, e).
free(square_to_round, x).
free(square_to_round, y).
free(hopper, x).

value_right(Name, File, P, Value) :-
    new_world(World),
    catch(in_world(World,
                   ( told_warnings(load_model(File, [parameters([P=Value])]),
                                   Told),
                     range_of(P, Least, Most, Step) )),
          Error, true),
    (   nonvar(Error)
    ->  Error = error(model_error(_), _)
    ;   free(Name, P)
    ->  Told == []
    ;   number(Least),
        ( atom(Step) ; number(Step) ),
        (   ( Value < Least ; number(Most), Value > Most )
        ->  memberchk(parameter(range(P, Value, Least, Most)), Told)
        ;   \+ memberchk(parameter(range(P, _, _, _)), Told)
        )
    ),
    !.
value_right(Name, _, P, Value) :-
    print_message(error, format("~q", [Name-P-Value])),
    fail.

:- meta_predicate told_warnings(0, -).

told_warnings(Goal, Told) :-
    nb_setval(told, []),
    setup_call_cleanup(
        asserta((user:message_hook(sanggwan(What), warning, _) :-
                     nb_getval(told, Told0),
                     nb_setval(told, [What|Told0])), Ref),
        Goal,
        erase(Ref)),
    nb_getval(told, Told).

%   The size that is at fault is told by its name, whether the fitting can be
%   made or not.

named_fault(reducer, d2, 0, 1, none).
named_fault(reducer, d, 0, 1, none).
named_fault(tee, b, 219.1, 1, 168.3).
named_fault(tee, offset, 28, -27, 27).
named_fault(tee, height, 84, 84.15, none).
named_fault(elbow, r, 57, 57.15, none).
named_fault(wye, legs, 98.9, 98.9867037, none).
named_fault(wye, stem, 15.3, 15.3132963, none).
named_fault(offset, ends, 20, 20.6911538, none).

test(named_fault, [forall(named_fault(Name, P, Value, Least, Most)),
                   Told == [parameter(range(P, Value, Least, Most))]]) :-
    format(atom(Local), 'facts/fittings/~w.pl', [Name]),
    absolute_file_name(sanggwan(Local), File),
    new_world(World),
    told_warnings(catch(in_world(World,
                                 load_model(File, [parameters([P=Value])])),
                        error(model_error(primitive(_, _)), _), true),
                  Told).

%   And who orders by these words finds them in both languages.
test(words, [forall(member(Name, [elbow,tee,wye,offset,reducer,
                                  square_to_round,hopper,cyclone]))]) :-
    format(atom(Local), 'facts/fittings/~w.pl', [Name]),
    absolute_file_name(sanggwan(Local), File),
    new_world(World),
    in_world(World, ( load_model(File, []),
                      forall(( param(P, _), \+ free(Name, P) ),
                             ( about_text(P, en, _),
                               about_text(P, ko, _) )) )).

:- end_tests(fittings).
