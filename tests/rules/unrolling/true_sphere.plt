/* Gores and zones of spheres, against their closed forms:
   rules/unrolling/true_sphere.pl, sphere_facet.pl. */
% covers: sphere_facet, true_join
:- use_module(library(plunit)).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(command/cli)).
:- use_module(rules(solid/csg_evaluate), [evaluate/0]).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(polygon/triangulation)).
:- use_module(rules(store)).
:- use_module(rules(unfolding/unfold_true)).
:- use_module(rules(unrolling/true_table)).

:- begin_tests(true_sphere).

:- meta_predicate patterns(+, +, -, 0).

%   patterns(Terms, Options, Ds, Goal): Ds are the true patterns of the first of
%   Terms; Goal asks about them.

patterns(Terms, Options, Ds, Goal) :-
    new_world(World),
    in_world(World,
             ( maplist([Term,S]>>add_primitive(Term, S), Terms, [S1|_]),
               complete_segments,
               true_patterns(S1, wanted(none, [], [], []), Options, Ds),
               call(Goal) )).

pattern_area(D, Area) :-
    aggregate_all(sum(A),
                  ( t(D, _, _, V1, V2, V3),
                    v(D, V1, X1, Y1, _), v(D, V2, X2, Y2, _),
                    v(D, V3, X3, Y3, _),
                    A is ((X2-X1)*(Y3-Y1) - (X3-X1)*(Y2-Y1))/2.0 ),
                  Area).

pieces(D, N) :-
    aggregate_all(max(K), piece(D, _, K), N).

%   gore_corner(D, K, X, Y): Y from the middle of the piece K.

gore_corners(D, K, Corners) :-
    findall(X-Y,
            ( piece(D, P, K), p(D, P, Es), member(E, Es), e(D, E, V, _, _),
              v(D, V, X, Y, _) ),
            All),
    findall(Y, member(_-Y, All), Ys),
    min_list(Ys, Low),
    max_list(Ys, High),
    Middle is (Low+High)/2.0,
    findall(X-Off, ( member(X-Y, All), Off is Y-Middle ), Corners).

%   A corner of a gore is as far from its middle as half of its parallel.

corner_right(R, N, Low, X-Off) :-
    S is X/R + Low*pi/180,
    Half is pi*R*cos(S)/N,
    abs(abs(Off)-Half) < 1.0e-9*R.

test(gores, forall(member(N-R, [2-1.0,3-7.5,8-50,12-1.0e6]))) :-
    patterns([sphere(radius(R), facets(20), bands(10))], [gores(N)], [D],
             gores_right(D, N, R)).

gores_right(D, N, R) :-
    pieces(D, N),
    forall(between(1, N, K),
           ( gore_corners(D, K, Corners),
             forall(member(Corner, Corners),
                    corner_right(R, N, -90, Corner)) )),
    pattern_area(D, Area),
    Area =< 4*pi*R*R,
    Area > 4*pi*R*R*0.999.

test(gores_of_a_hemisphere, true(abs(Area/(2*pi*900) - 1) < 1.0e-3)) :-
    patterns([hemisphere(radius(30), facets(20), bands(5))], [gores(6)],
             [D,Base],
             ( pieces(D, 6),
               forall(between(1, 6, K),
                      ( gore_corners(D, K, Corners),
                        forall(member(C, Corners),
                               hemisphere_corner(C)) )),
               pattern_area(D, Area),
               pieces(Base, 1) )).

hemisphere_corner(X-Off) :-
    X < 1.0e-6,                         % on the rim
    !,
    abs(Off) < 30*pi/6 + 1.0e-9.
hemisphere_corner(Corner) :-
    corner_right(30, 6, 0, Corner).

%   Zones are cut open beside holes: wherever the pipe is, all of the seam of
%   its zone is left; unless somebody says where.

zone_seam(Turn, Options, Length) :-
    patterns([ sphere(radius(50), facets(20), bands(10)),
               at([rotate(y,90),rotate(z,Turn)],
                  cylinder(radius(10), height(90))) ],
             [zones(5),trim(outside)|Options], [D],
             aggregate_all(sum(L),
                           ( joint(D, _, E, _, seam, _),
                             edge_length(D, E, L) ),
                           Length)).

test(zone_beside_a_hole, [forall(member(Turn, [0,45,90,200]))]) :-
    zone_seam(Turn, [], Length),
    zone_seam(90, [seam(0)], Whole),
    zone_seam(0, [seam(0)], Cut),
    assertion(abs(Length-Whole) < 0.01),
    assertion(Whole-Cut > 19.0).

%   Many meridians of a zone are whole, but for rounding.

test(zone_with_whole_meridians, [ forall(member(N, [3,6])),
                                  true(abs(Length-Whole) < 0.01) ]) :-
    near_the_pole(N, [], Length),
    near_the_pole(N, [seam(180)], Whole),
    near_the_pole(N, [seam(0)], Cut),
    assertion(Whole-Cut > 9.0).

near_the_pole(N, Options, Length) :-
    patterns([ sphere(radius(50), facets(20), bands(18)),
               at([translate(20,0,-60)], cylinder(radius(9), height(200))) ],
             [zones(N),trim(outside)|Options], [D],
             aggregate_all(sum(L),
                           ( joint(D, _, E, _, seam, _),
                             edge_length(D, E, L) ),
                           Length)).

%   The neutral layer: of 4 inside 50, it is 48 (drawn by the outside), and K
%   moves it.

test(gore_of_plate,
     forall(member(Options-R, [ [thickness(4)]-50.0,
                                [thickness(4),size(outside)]-48.0,
                                [thickness(4),size(inside),k_factor(0.25)]-51.0
                              ]))) :-
    patterns([sphere(radius(50))], [gores(10)|Options], [D],
             ( gore_corners(D, 1, Corners),
               forall(member(C, Corners), corner_right(R, 10, -90, C)) )).

%   Zones: frustums through their circles; the length of a seam is the chord.

test(zones, forall(member(N-R, [2-1.0,5-40,12-1.0e6]))) :-
    patterns([sphere(radius(R), facets(20), bands(10))], [zones(N)], [D],
             zones_right(D, N, R)).

zones_right(D, N, R) :-
    pieces(D, N),
    Length is 2*R*sin(pi/(2*N)),
    aggregate_all(sum(A),
                  ( between(1, N, I),
                    A is pi*Length*R*( sin(pi*(I-1)/N) + sin(pi*I/N) ) ),
                  Exact),
    pattern_area(D, Area),
    abs(Area/Exact - 1) < 1.0e-3,
    %   straight seams at both ends of each
    aggregate_all(count,
                  ( joint(D, _, E, F, seam, _),
                    edge_length(D, E, L1), abs(L1-Length) < 1.0e-9*R,
                    edge_length(D, F, L2), abs(L2-Length) < 1.0e-9*R ),
                  N).

edge_length(D, E, L) :-
    e(D, E, A, B, _),
    v(D, A, X1, Y1, _),
    v(D, B, X2, Y2, _),
    L is sqrt((X1-X2)**2 + (Y1-Y2)**2).

%   What a pipe takes away: each corner of the hole is on the pipe, and the area
%   is that of the cap, for a gore keeps areas.

test(hole_of_a_pipe, true(abs(Area/Exact - 1) < 1.0e-3)) :-
    R = 50,
    Exact is 2*pi*R*(R + sqrt(R*R - 400)),
    patterns([ sphere(radius(R)),
               cylinder(radius(20), height(90)) ],
             [gores(8),trim(outside)], [D],
             pattern_area(D, Area)).

test(hole_beside_the_axis, true(N > 40)) :-
    patterns([ sphere(radius(50)),
               at([translate(11,7,0)], cylinder(radius(8), height(90))) ],
             [gores(4),trim(outside)], [D],
             ( findall(Off,
                       ( between(1, 4, K),
                         gore_corners(D, K, Corners),
                         member(C, Corners),
                         \+ corner_right(50, 4, -90, C),
                         on_pipe(C, K, Off) ),
                       Offs),
               length(Offs, N),
               forall(member(Off, Offs), abs(Off) < 1.0e-9*50) )).

%   Seen from outside with north to the right, east is down.

on_pipe(X-Y, K, Off) :-
    S is X/50 - pi/2,
    T is (K-0.5)*pi/2 - Y/(50*cos(S)),
    PX is 50*cos(S)*cos(T) - 11,
    PY is 50*cos(S)*sin(T) - 7,
    Off is sqrt(PX*PX + PY*PY) - 8.

%   A dome that a plane cuts off keeps the area 2*pi*R*H.

test(cap, true(abs(Area/(2*pi*50*25) - 1) < 1.0e-3)) :-
    new_world(World),
    in_world(World,
             ( add_primitive(sphere(radius(50)), S),
               complete_segments,
               assert_fact(segment(9, solid,
                                   split(S, plane(0,0,1,-25), above))),
               evaluate,
               true_patterns(9, wanted(none, [], [], []), [gores(6)], [D,_]),
               pattern_area(D, Area) )).

test(seam, true(Turned == Areas)) :-
    Pipe = at([translate(11,7,0)], cylinder(radius(13), height(90))),
    findall(A, hole_area([Pipe], 0, A), Areas0),
    findall(A, hole_area([at([rotate(z,25)], Pipe)], 25, A), Turned0),
    maplist([A0,A1]>>(A1 is round(A0*1000)), Areas0, Areas),
    maplist([A0,A1]>>(A1 is round(A0*1000)), Turned0, Turned).

hole_area(Pipes, Seam, Area) :-
    patterns([sphere(radius(50))|Pipes], [gores(5),seam(Seam),trim(outside)],
             [D], pattern_area(D, Area)).

%   A hole that a tool makes is no matter; but beside another round part that is
%   plate the sphere stays in its facets: those of gores would not meet it.

composed(Term, Ds, Goal) :-
    new_world(World),
    in_world(World,
             ( assert_fact(segment(9, solid, Term)),
               primitives_and_nodes,
               true_patterns(9, wanted(none, [], [], []), [gores(6)], Ds),
               call(Goal) )).

:- meta_predicate composed(+, -, 0).

primitives_and_nodes :-
    complete_segments,
    evaluate,
    complete_segments.

test(hole_of_a_tool, true(Ns == [1,1,6])) :-
    composed(difference([ hemisphere(radius(50)),
                          at([translate(10,20,0)],
                             cylinder(radius(10), height(120))) ]),
             Ds, ( maplist(pieces, Ds, Ns0), msort(Ns0, Ns) )).
test(silo, true(Kinds == [development,true_development])) :-
    composed(union([ cylinder(radius(50), height(120)),
                     at([translate(0,0,120)], hemisphere(radius(50))) ]),
             Ds,
             ( findall(Kind,
                       ( member(D, Ds), segment(D, pattern, Term),
                         functor(Term, Kind, _) ),
                       Kinds0),
               sort(Kinds0, Kinds),
               length(Ds, 2) )).

%   The table says where to mark a gore: the widths of its parallels, which are
%   those of the sphere and not of the chords of its outline.

test(table, [ forall(member(Term-Options-R-N,
                            [ sphere(radius(50))-[]-50-11,
                              sphere(radius(7))-[thickness(1),size(outside)]-
                                  6.5-11,
                              hemisphere(radius(30))-[]-30-12 ])),
              Wrong-Count == []-N ]) :-
    patterns([Term], [gores(8),generators(12)|Options], [D|_],
             ( true_length_rows(D, Rows),
               length(Rows, Count),
               findall(Row, ( member(Row, Rows), \+ row_right(R, Row) ),
                       Wrong) )).

row_right(R, row(_, S, _, From, To, L, _, _, _)) :-
    Exact is pi*R*cos(S*pi/180)/4,
    abs(L-Exact) < 1.0e-9*R,
    abs(From+To) < 1.0e-9*R.

test(half, error(geometry_error(true(no_option(1, half))))) :-
    patterns([sphere(radius(1))], [half(true)], _, true).
test(generators_of_zones,
     error(geometry_error(true(no_option(1, generators))))) :-
    patterns([sphere(radius(1))], [zones(3),generators(8)], _, true).

%   It is the segment of the user that is told of, not the leaf.
test(half_of_a_tree, error(geometry_error(true(no_option(9, half))))) :-
    new_world(World),
    in_world(World,
             ( assert_fact(segment(9, solid,
                                   split(sphere(radius(50)), plane(0,0,1,0),
                                         above))),
               evaluate,
               true_patterns(9, wanted(none, [], [], []), [half(true)], _) )).

:- end_tests(true_sphere).
