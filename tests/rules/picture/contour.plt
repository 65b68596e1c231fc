:- module(test_contour, []).
% covers: scene_divided
:- use_module(library(plunit)).
:- use_module(library(occurs), [sub_term/2]).
:- use_module(library(random)).
:- use_module(rules(picture/contour)).
:- use_module(rules(decision)).
:- use_module(rules(explanation/explain), [explanation/2]).
:- use_module(rules(picture/hidden_lines)).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation), [complete_segments/1]).
:- use_module(rules(picture/view)).
:- use_module(tests('rules/contour_same'), [same_as_rule/2]).
:- use_module(tests('rules/polyhedron'), [in_new_world/1]).
:- use_module(tests('rules/sample')).

:- multifile user:message_hook/3.

user:message_hook(sanggwan(not_flat(_, _, _, _)), warning, _).

% The picture of these primitives, segments 1, 2, ..., from there.

pictured(Terms, Theta, Phi, Options) :-
    forall(member(Term, Terms), add_primitive(Term, _)),
    findall(S, segment(S,_,_), Ss),
    complete_segments(Ss),
    set_view(Theta, Phi, 0),
    picture(Options).

drawn_length(Visibility, Role, Length) :-
    aggregate_all(sum(L), drawn_length_(Visibility, Role, L), Length).

drawn_length_(Visibility, Role, Length) :-
    drawn(_, S, E, From, To, Visibility, Role),
    line_ends(S, E, X1-Y1, X2-Y2),
    Length is (To-From)*sqrt((X2-X1)**2+(Y2-Y1)**2).

% Where a visible part of an edge ends, within it.
seen_end(X-Y) :-
    drawn(_, S, E, From, To, visible, _),
    E > 0,
    ( At = From, From > 0.0 ; At = To, To < 1.0 ),
    line_ends(S, E, X1-Y1, X2-Y2),
    X is X1 + At*(X2-X1),
    Y is Y1 + At*(Y2-Y1).

% Within a part of it.
near(X, Y, Part) :-
    abs(X-Y) =< Part*abs(Y).

% The places where pieces end, in the order of the standard, and how often.
piece_ends(Ends) :-
    findall(End,
            ( contour(S, K, _, _, _, _, _, _, _, _, _, _, _),
              contour_ends(S, K, Start, Finish),
              member(End, [Start,Finish]) ),
            Ends0),
    msort(Ends0, Sorted),
    clumped_ends(Sorted, Ends).

clumped_ends(Sorted, Ends) :-
    findall(E-x, member(E, Sorted), Pairs),
    group_pairs_by_key(Pairs, Groups),
    findall(E-N, ( member(E-Xs, Groups), length(Xs, N) ), Ends).

% By how many degrees the outline turns where two visible pieces meet, and how
% long the shorter one is.
visible_turn(Turn, Shorter) :-
    whole_piece(K1, Start, Corner),
    whole_piece(K2, Corner, End),
    K1 < K2,
    turn(Start, Corner, End, Turn),
    maplist(distance(Corner), [Start,End], Lengths),
    min_list(Lengths, Shorter).

distance(X1-Y1, X2-Y2, Distance) :-
    Distance is sqrt((X2-X1)**2 + (Y2-Y1)**2).

whole_piece(K, Start, End) :-
    drawn(_, S, E, 0.0, 1.0, visible, outline),
    E < 0,
    K is -E,
    contour_ends(S, K, A, B),
    ( Start-End = A-B ; Start-End = B-A ).

turn(X1-Y1, X2-Y2, X3-Y3, Turn) :-
    U is X2-X1,
    V is Y2-Y1,
    A is X3-X2,
    B is Y3-Y2,
    Turn is abs(atan2(U*B-V*A, U*A+V*B))*180/pi.

a_view(Seed, Theta, Phi) :-
    set_random(seed(Seed)),
    random(0.0, 360.0, Theta),
    random(1.0, 179.0, Phi).

smooth_body(sphere(radius(1), facets(40))).
smooth_body(sphere(radius(2,1,0.5), facets(48), bands(24))).
smooth_body(egg(radius(0.7), up(1.3), down(0.6), facets(40))).

% The segment is a mesh, no primitive.
nameless(S) :-
    segment(S, Kind, Term),
    retractall_facts(segment(S, _, _)),
    assert_fact(segment(S, Kind, mesh)),
    compound(Term).

% What is drawn of a cube with edges of 2^Power, a cylinder and a sphere.
scaled_picture(Power, Parts) :-
    A is 2.0**Power,
    R is A/4,
    H is 2*A,
    in_new_world(( pictured([ box(size(A,A,A)),
                              at([rotate(x,90),translate(0,A,R)],
                                 cylinder(radius(R),height(H))),
                              at([translate(A,0,0)],sphere(radius(R))) ],
                            300, 60, []),
                   findall(part(S,E,From,To,Visibility,Role),
                           drawn(_,S,E,From,To,Visibility,Role), Parts) )).

rounded_part(drawn(D,S,E,From,To,Visibility,Role)) :-
    drawn(D, S, E, From0, To0, Visibility, Role),
    From is round(From0*1.0e9),
    To is round(To0*1.0e9).

:- begin_tests(contour).

% Products of areas would leave the doubles.
test(as_small_as_can_be, Parts == Same) :-
    scaled_picture(0, Same),
    scaled_picture(-290, Parts).
test(as_large_as_can_be, Parts == Same) :-
    scaled_picture(0, Same),
    scaled_picture(290, Parts).

% Neither would those of an outline that turns back.
ring_lengths(Exponent, Lengths) :-
    R is 2.0**Exponent,
    Tube is 0.375*R,
    in_new_world(( pictured([torus(radius(R), tube(Tube), facets(36))], 280, 60,
                            []),
                   findall(Visibility-Length,
                           ( member(Visibility, [visible,hidden]),
                             drawn_length(Visibility, outline, Length0),
                             Length is round(Length0/R*1.0e6) ),
                           Lengths) )).

test(ring_of_any_size,
     [ forall(member(Exponent, [-280,280])), Lengths == Same ]) :-
    ring_lengths(0, Same),
    ring_lengths(Exponent, Lengths).

% ANCHORS: the true lengths, integrated.
test(torus) :-
    Phi is acos(1.1/sqrt(1.2**2+2.0**2+1.1**2))*180/pi,
    Theta is atan2(-2.0, 1.2)*180/pi,
    in_new_world(( pictured([torus(radius(1), tube(0.4), facets(100),
                                   sides(100))],
                            Theta, Phi, []),
                   drawn_length(visible, outline, Visible),
                   drawn_length(hidden, outline, Hidden) )),
    near(Visible, 9.132, 0.01),
    near(Hidden, 1.186, 0.01).
% Thin and thick ones, coarse and fine, from three sides: all lengths beside
% those of 260 facets by 260.
true_lengths(0.2, [9.6883-0.0000, 9.3180-0.0275, 8.8166-0.4239]).
true_lengths(0.4, [9.7236-0.5033, 9.0802-1.2451, 8.3168-2.3082]).
true_lengths(0.7, [10.0916-2.1023, 9.9886-2.5498, 9.8927-3.2665]).

most_off(40, 0.08, 0.04).
most_off(80, 0.015, 0.02).

test(cusps, [ forall(( true_lengths(Tube, True), most_off(N, MostV, MostH) )) ])
        :-
    in_new_world(( add_primitive(torus(radius(1), tube(Tube), facets(N),
                                       sides(N)), _),
                   complete_segments([1]),
                   findall(V-H,
                           ( member(Theta-Phi, [280-60, 300-65, 10-72]),
                             set_view(Theta, Phi, 0), picture,
                             drawn_length(visible, outline, V),
                             drawn_length(hidden, outline, H) ),
                           Lengths) )),
    foldl([V-H,V1-H1,V0-H0,V2-H2]>>( V2 is V0+abs(V-V1), H2 is H0+abs(H-H1) ),
          Lengths, True, 0-0, OffV-OffH),
    OffV < MostV,
    OffH < MostH.
% All of it, seen and hidden, beside the closed form: with the tube turned by U
% round the axis, the outline lies at tan V = -tan Phi cos U round the tube.
% What is off is in the square of the angle of a facet.
test(closed_form,
     [ forall(sampled([N,Phi], ( member(Phi, [20,50,62,75]),
                                 member(N-M, [8-6,12-8,24-12,48-24]) ))),
       true(Off < 0.35*Square) ]) :-
    Square is (2*pi/M)**2,
    outline_length(0.4, Phi, True),
    in_new_world(( pictured([torus(radius(1), tube(0.4), facets(N), sides(M))],
                            7, Phi, []),
                   drawn_length(_, outline, Length) )),
    Off is abs(Length-True).

outline_length(Tube, Phi, Length) :-
    findall(Step,
            ( member(Branch, [0,pi]),
              between(1, 2000, I),
              outline_place(Tube, Phi, Branch, I-1, P),
              outline_place(Tube, Phi, Branch, I, Q),
              distance(P, Q, Step) ),
            Steps),
    sum_list(Steps, Length).

outline_place(Tube, Phi, Branch, I, X-Y) :-
    U is 2*pi*I/2000,
    Sine is sin(Phi*pi/180),
    Cosine is cos(Phi*pi/180),
    V is atan2(-Sine*cos(U), Cosine) + Branch,
    Radius is 1 + Tube*cos(V),
    X is Radius*sin(U),
    Y is Tube*sin(V)*Sine - Radius*cos(U)*Cosine.

% However coarse the torus: where pieces begin and end, seen or hidden, they are
% on the closed form, within a hundredth of the square of the angle of a facet,
% a tenth at worst, where the outline turns back.
test(on_surface,
     [ forall(sampled([N,Phi], ( torus_turned(N, M),
                                 member(Phi, [20,50,62,75]) ))),
       true(( Mean < 0.01*Angle**2, Most < 0.1*Angle**2 )) ]) :-
    Angle is 2*pi/M,
    outline_places(0.4, Phi, Places),
    in_new_world(( pictured([torus(radius(1), tube(0.4), facets(N), sides(M))],
                            7, Phi, []),
                   piece_ends(Ends) )),
    findall(Off, ( member(End-_, Ends), off(End, Places, Off) ), Offs),
    max_list(Offs, Most),
    sum_list(Offs, Sum),
    length(Offs, Count),
    Mean is Sum/Count.

outline_places(Tube, Phi, Places) :-
    findall(P-Q,
            ( member(Branch, [0,pi]), between(1, 500, I),
              From is 4*(I-1), To is 4*I,
              outline_place(Tube, Phi, Branch, From, P),
              outline_place(Tube, Phi, Branch, To, Q) ),
            Places).

% How far a place is from the nearest of these segments.
off(End, Places, Off) :-
    aggregate_all(min(Off0), ( member(P-Q, Places), off(End, P, Q, Off0) ),
                  Off).

off(X-Y, X1-Y1, X2-Y2, Off) :-
    U is X2-X1,
    V is Y2-Y1,
    Part is max(0.0, min(1.0, ((X-X1)*U + (Y-Y1)*V)/(U*U + V*V))),
    Off is sqrt((X1+Part*U-X)**2 + (Y1+Part*V-Y)**2).

% The same of a coarse ball, which the eye sees as a circle from nearby, too;
% but for corners that pieces go by way of.
test(on_ball,
     [ forall(( member(Kind, [parallel,central]), member(Seed, [1,2,3]) )),
       true(Most < 1.01*Least) ]) :-
    a_view(Seed, Theta, Phi),
    in_new_world(( add_primitive(sphere(radius(1), facets(16)), _),
                   complete_segments([1]),
                   set_view(Theta, Phi, 3),
                   set_projection(Kind),
                   picture,
                   piece_ends(Ends) )),
    aggregate_all(r(min(Far),max(Far)),
                  ( member(End-_, Ends), distance(0-0, End, Far) ),
                  r(Least,Most)).

% Where it turns back, what is seen of it ends: two visible pieces turn by more
% than a right angle only where one is shorter than what a facet is off.
torus_turned(8, 6).
torus_turned(12, 8).
torus_turned(16, 10).
torus_turned(24, 16).
torus_turned(48, 24) :-
    all_wanted.

test(no_hooks,
     [ forall(torus_turned(N, M)), Hooks == [] ]) :-
    Facet is 2*pi*1.4/N,
    in_new_world(( add_primitive(torus(radius(1), tube(0.4), facets(N),
                                       sides(M)), _),
                   complete_segments([1]),
                   findall(Theta-Phi-Turn-Shorter,
                           ( from_outside(Theta, Phi),
                             visible_turn(Turn, Shorter),
                             Turn > 90,
                             Shorter > Facet*Facet/40 ),
                           Hooks) )).

from_outside(Theta, Phi) :-
    member(Theta-Phi, [300-62, 10-50, 20-55, 77-80]),
    set_view(Theta, Phi, 0),
    picture.

test(sphere, forall(member(Seed, [1,2,3,4,5,6]))) :-
    a_view(Seed, Theta, Phi),
    in_new_world(( pictured([sphere(radius(1), facets(64))], Theta, Phi, []),
                   drawn_length(visible, outline, Length),
                   drawn_length(_, _, All) )),
    near(Length, 2*pi, 0.004),
    Length =:= All.
% The eye at distance 3 sees a smaller circle: at an angle of asin(1/3), in the
% plane at distance 2 where the sphere begins.
test(sphere_central, forall(member(Seed, [1,2,3]))) :-
    a_view(Seed, Theta, Phi),
    in_new_world(( add_primitive(sphere(radius(1), facets(64)), _),
                   complete_segments([1]),
                   set_view(Theta, Phi, 3),
                   set_projection(central),
                   picture,
                   drawn_length(visible, outline, Length),
                   drawn_length(hidden, _, Hidden) )),
    near(Length, 2*pi*2*tan(asin(1/3)), 0.004),
    Hidden =:= 0.
test(convex_is_not_hidden,
     [ forall(sampled([Term,Seed], ( smooth_body(Term),
                                     between(1, 8, Seed) ))),
       Hidden =:= 0 ]) :-
    a_view(Seed, Theta, Phi),
    in_new_world(( pictured([Term], Theta, Phi, []),
                   drawn_length(hidden, _, Hidden) )).
test(closed, [ forall(sampled([Term,Theta-Phi],
                              ( smooth_body(Term),
                                member(Theta-Phi, [ 0-90, 270-90, 0-0, 30-60,
                                                    45-90 ]) ))),
               Odd == [] ]) :-
    in_new_world(( pictured([Term], Theta, Phi, []),
                   piece_ends(Ends),
                   findall(E, ( member(E-N, Ends), N mod 2 =:= 1 ), Odd) )).
test(generators, Lengths == [3.0,3.0]) :-
    in_new_world(( pictured([cylinder(radius(1), height(3), facets(24))],
                            10, 90, []),
                   \+ contour(_,_,_,_,_,_,_,_,_,_,_,_,_),
                   findall(L, ( drawn(_,S,E,From,To,visible,outline),
                                line_ends(S, E, X-Y1, X2-Y2),
                                abs(X-X2) < 1.0e-9,
                                L is (To-From)*abs(Y2-Y1) ),
                           Lengths) )).
test(folded, forall(member(Term, [ cone(radius(1), height(2), facets(24)),
                                   cylinder(radius(1), height(2), facets(12)),
                                   box(size(1,2,3)),
                                   hollow_cylinder(radius(2), inner(1),
                                                   height(1), facets(40))
                                 ]))) :-
    in_new_world(( pictured([Term], 33, 66, []),
                   \+ contour(_,_,_,_,_,_,_,_,_,_,_,_,_) )).
% The dome's outline ends where what is seen of its circle does.
test(meets_crease, forall(member(N, [12,36]))) :-
    in_new_world(( pictured([hemisphere(radius(1), facets(N))], 33, 60, []),
                   piece_ends(Ends),
                   findall(E, member(E-1, Ends), Single),
                   length(Single, 2),
                   forall(member(End, Single),
                          ( seen_end(End2), distance(End, End2, Off),
                            Off < 1.0e-9 )) )).
test(all_edges) :-
    in_new_world(( pictured([sphere(radius(1), facets(24))], 33, 60,
                            [lines(all)]),
                   \+ contour(_,_,_,_,_,_,_,_,_,_,_,_,_),
                   once(drawn(_,_,_,_,_,_,outline)) )).
% Facets of a known surface bend by one degree at most; those of a mesh by what
% they do.
test(crease,
     [ forall(member(Degrees-Kind-Expected,
                     [ 5-primitive-(true-false), 0.5-primitive-(false-true),
                       5-mesh-(false-true), 30-mesh-(true-false) ])),
       Outlines-Creases == Expected ]) :-
    in_new_world(( add_primitive(sphere(radius(1), facets(24)), _),
                   (   Kind == mesh
                   ->  nameless(1)
                   ;   true
                   ),
                   pictured([], 33, 60, [crease(Degrees)]),
                   truth(contour(_,_,_,_,_,_,_,_,_,_,_,_,_), Outlines),
                   truth(drawn(_,_,_,_,_,_,crease), Creases) )).
test(rule,
     [ forall(( member(Term, [ torus(radius(1), tube(0.4), facets(24),
                                     sides(16)),
                               sphere(radius(1), facets(16)) ]),
                member(Seed, [1,2]) )),
       Kernel == Rule ]) :-
    a_view(Seed, Theta, Phi),
    in_new_world(( pictured([Term], Theta, Phi, [method(kernel)]),
                   findall(D, rounded_part(D), Kernel),
                   picture([method(rule)]),
                   findall(D, rounded_part(D), Rule) )).

truth(Goal, Truth) :-
    (   call(Goal)
    ->  Truth = true
    ;   Truth = false
    ).

:- end_tests(contour).

ruled(torus(radius(1), tube(0.4), facets(24), sides(16))).
ruled(hemisphere(radius(2,1,1), facets(20))).
ruled(cone(radius(1), height(2), facets(16))).
ruled(at([rotate(x,40)], egg(radius(0.7), up(1.3), down(0.6), facets(16)))).
ruled(turning(outline([[0,0],[0.5,0.1],[1,0.4],[1.1,0.9],[0.7,1.4],[0.6,1.8],
                       [0,2]]), facets(16))).
ruled(turning(outline([[0.3,0],[1,0.2],[1.2,0.8],[1,1.4],[0.3,1.7]]),
              facets(12), angle(200))).
ruled(bezier(points([[0,0,0],[1,0,3],[2,0,-3],[3,0,0],
                     [0,1,1],[1,1,4],[2,1,-2],[3,1,1],
                     [0,2,-1],[1,2,3],[2,2,-4],[3,2,-1],
                     [0,3,0],[1,3,3],[2,3,-3],[3,3,0]]), facets(8))).

% Meshes, segment 1: coarse, and one with polygons that are not flat.

mesh(sphere(radius(1), facets(12), bands(8))).
mesh(torus(radius(1), tube(0.4), facets(14), sides(9))).
mesh(hemisphere(radius(2,1,1), facets(10))).
mesh(turning(outline([[0,0],[0.5,0.1],[1,0.4],[1.1,0.9],[0.7,1.4],[0.6,1.8],
                      [0,2]]), facets(9))).
mesh(sheet(points([[0,0,0],[1,0,0.6],[2,0,0],[0,1,0.5],[1,1,0],[2,1,0.7],
                   [0,2,0],[1,2,0.8],[2,2,0]]),
           faces([[1,2,5,4],[2,3,6,5],[4,5,8,7],[5,6,9,8]]))).

% Fine along its circles, coarse across.
pear :-
    add_primitive(turning(outline([[0,0],[0.5,0.1],[1,0.4],[1.1,0.9],
                                   [0.7,1.4],[0.6,1.8],[0,2]]),
                          facets(40)), S),
    nameless(S),
    complete_segments([S]).

stand_in_because(E, Because) :-
    contour(1, K, _, _, _, _, _, substitute, _, _, _, _, _),
    E is -K,
    explanation(hidden(1, E), [because(_, Because)]),
    memberchk(because(substitute_outline, []), Because).

within_visible(Because, From, To) :-
    member(because(visible_part(From1, To1), _), Because),
    From1 =< From+1.0e-9,
    To =< To1+1.0e-9,
    !.

eye(301, 65).
eye(20, 110).
eye(88, 91).

:- begin_tests(contour_rule).

test(kernel, forall(sampled([Term,Theta-Phi,Kind],
                            ( ruled(Term), eye(Theta, Phi),
                              member(Kind, [parallel,central]) )))) :-
    in_new_world(( add_primitive(Term, _), complete_segments([1]),
                   set_view(Theta, Phi, 0), set_projection(Kind),
                   picture([crease(50)]),
                   same_as_rule(1, 50) )).
test(mesh, forall(sampled([Term,Theta,Crease],
                          ( mesh(Term), eye(Theta, Phi),
                            member(Crease, [10,50]) )))) :-
    in_new_world(( add_primitive(Term, _), nameless(1),
                   complete_segments([1]),
                   set_view(Theta, Phi, 0),
                   picture([crease(Crease)]),
                   same_as_rule(1, Crease) )).
% The outline of a coarse ball is that of its facets: in vertices, closed.
test(coarse, Odd-Inner == []-[]) :-
    in_new_world(( add_primitive(sphere(radius(1), facets(12), bands(8)), _),
                   nameless(1), complete_segments([1]),
                   set_view(33, 62, 0), picture,
                   piece_ends(Ends), Ends = [_|_],
                   findall(E, ( member(E-N, Ends), N mod 2 =:= 1 ), Odd),
                   findall(X-Y, ( member((X-Y)-_, Ends),
                                  \+ screen(1, _, X, Y, _) ), Inner) )).
% Where triangles of a mesh turn from the eye, sides stand in for the outline:
% they are drawn where no line is near, and never hidden.
test(substitute_outline, forall(member(Theta-Phi, [20-110, 33-65, 20-80]))) :-
    in_new_world(( pear, set_view(Theta, Phi, 0), picture,
                   same_as_rule(1, 30),
                   findall(V, ( drawn(_, 1, E, _, _, V, _),
                                substitute_outline(1, E) ),
                           Vs),
                   sort(Vs, [visible]) )).
test(substitute_outline_by_rule, [ forall(member(Seed, [1,2,3,4,5])),
                          Kernel == Rule ]) :-
    a_view(Seed, Theta, Phi),
    in_new_world(( pear, set_view(Theta, Phi, 0),
                   picture([method(kernel)]),
                   findall(D, rounded_part(D), Kernel),
                   picture([method(rule)]),
                   findall(D, rounded_part(D), Rule) )).
% Why: what is drawn of it is seen, and in place of the rest is another line, or
% the surface goes on.
test(substitute_outline_because, Why == [drawn_instead,surface_goes_on]) :-
    in_new_world(( pear, set_view(20, 110, 0), picture,
                   findall(E-Because, stand_in_because(E, Because), All),
                   forall(( member(E-Because, All),
                            drawn(_, 1, E, From, To, _, _) ),
                          within_visible(Because, From, To)),
                   findall(Name, ( member(_-Because, All),
                                   member(Name, [surface_goes_on,
                                                 drawn_instead]),
                                   sub_term(Term, Because),
                                   compound(Term),
                                   compound_name_arity(Term, Name, _) ),
                           Names),
                   sort(Names, Why) )).
% A quadrangle with two corners up, seen across its fold, one half from behind.
test(fold, Outlines == [visible]) :-
    in_new_world(( add_primitive(sheet(points([[0,0,0],[2,0,1],[2,2,0],
                                               [0,2,1]]),
                                       faces([[1,2,3,4]])), _),
                   complete_segments([1]),
                   set_view(135, 80, 0), picture,
                   findall(V, drawn(_,1,_,_,_,V,outline), Outlines) )).

:- end_tests(contour_rule).

% A rule file can say that a segment is what its facets are.

:- begin_tests(contour_decision).

in_rules(Text, Goal) :-
    tmp_file_stream(File, Out, [encoding(utf8),extension(pl)]),
    call_cleanup(
        ( write(Out, Text), close(Out), use_rules(File), Goal, no_rules(File) ),
        delete_file(File)).

two_balls :-
    add_primitive(sphere(radius(1), facets(24)), _),
    add_primitive(at([translate(3,0,0)], sphere(radius(1), facets(24))), _),
    complete_segments([1,2]),
    set_view(33, 60, 0).

% S has outlines of this kind only: `triangles` or `edges`.
outlines(S, Kind) :-
    findall(E, drawn(_,S,E,_,_,_,outline), Es),
    Es = [_|_],
    (   Kind == triangles
    ->  forall(member(E, Es), E < 0)
    ;   forall(member(E, Es), E > 0)
    ).

test(faceted) :-
    in_new_world(( two_balls,
                   picture,
                   outlines(1, triangles),
                   outlines(2, triangles),
                   in_rules("smooth_segment(S) :- S =\\= 2.",
                            ( picture, outlines(1, triangles),
                              outlines(2, edges) )),
                   picture,
                   outlines(2, triangles) )).

:- end_tests(contour_decision).
