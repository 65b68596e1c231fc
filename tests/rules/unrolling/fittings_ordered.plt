/* Fittings as a workshop orders them (facts/fittings/): against their closed
   forms, and what no fitting can have. */
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(development/seam_measure)).
:- use_module(rules(model/model)).
:- use_module(rules(model/model_file)).
:- use_module(rules(model/parameter_about)).
:- use_module(rules(model/parameter)).
:- use_module(rules(store)).
:- use_module(rules(unfolding/unfold)).
:- use_module(rules(unfolding/unfold_how)).
:- use_module(rules(unfolding/unfold_true)).
:- use_module(rules(unrolling/true_table)).
:- use_module(tests(rules/unrolling/measured_near)).
:- multifile user:message_hook/3.
:- dynamic user:message_hook/3.

:- begin_tests(fittings_ordered).

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
                *       WHAT CANNOT BE         *
                *******************************/

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

:- end_tests(fittings_ordered).
