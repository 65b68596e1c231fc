:- module(test_section, []).
:- use_module(library(plunit)).
:- use_module(rules(store)).
:- use_module(rules(picture/section)).
:- use_module(rules(solid/csg_evaluate), [evaluate/0]).
:- use_module(rules(csg/csg_roots), [operand_lines/1, roots_alone/0]).
:- use_module(rules(model/model), [load_model/1]).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).

:- meta_predicate in_new(0), with(+, 0), tree(+, 0).

in_new(Goal) :-
    new_world(World),
    in_world(World, Goal).

% Goal in a world of these primitives.
with(Terms, Goal) :-
    in_new(( forall(member(Term, Terms), add_primitive(Term, _)),
             complete_segments,
             Goal )).

% Goal in a world with what this CSG tree is.
tree(Term, Goal) :-
    in_new(( assert_fact(segment(1, solid, Term)), evaluate, roots_alone,
             Goal )).

% The area of the caps of segment S, in the plane of two of its axes.
cap_area(Section, S, Axes, Area) :-
    section_region(Section, S, _, N, Edges),
    findall(Twice,
            ( member(V1-V2, Edges),
              place(N, V1, Axes, A1, B1),
              place(N, V2, Axes, A2, B2),
              Twice is A1*B2-A2*B1 ),
            All),
    sum_list(All, Sum),
    Area is abs(Sum)/2.

place(N, V, Axes, A, B) :-
    v(N, V, X, Y, Z),
    memberchk(Axes-[A,B], [yz-[Y,Z], xz-[X,Z], xy-[X,Y]]).

% The same area without any Boolean: each triangle of segment S crosses the
% plane, an N-D, in a directed line; what they span is twice the area.
sliced_area(S, N-D, Area) :-
    findall(Twice,
            ( t(S, _, _, V1, V2, V3),
              maplist(vertex(S), [V1,V2,V3], Ps),
              maplist(height(N-D), Ps, Hs),
              slice(Ps, Hs, A, B),
              cross(A, B, C),
              dot(C, N, Twice) ),
            All),
    sum_list(All, Sum),
    dot(N, N, Square),
    Area is abs(Sum)/2/sqrt(Square).

vertex(S, V, [X,Y,Z]) :-
    v(S, V, X, Y, Z).

height(N-D, P, H) :-
    dot(N, P, H0),
    H is H0+D.

% From where the triangle goes up to where it goes down.
slice([P1,P2,P3], [H1,H2,H3], A, B) :-
    Edges = [e(P1,H1,P2,H2), e(P2,H2,P3,H3), e(P3,H3,P1,H1)],
    member(e(PA,HA,QA,KA), Edges),
    HA < 0, KA >= 0,
    !,
    crossing(PA, HA, QA, KA, A),
    member(e(PB,HB,QB,KB), Edges),
    HB >= 0, KB < 0,
    !,
    crossing(PB, HB, QB, KB, B).

crossing(P, H, Q, K, R) :-
    T is H/(H-K),
    maplist(part_of_the_way(T), P, Q, R).

part_of_the_way(T, A, B, C) :-
    C is A+T*(B-A).

cross([A,B,C], [X,Y,Z], [U,V,W]) :-
    U is B*Z-C*Y,
    V is C*X-A*Z,
    W is A*Y-B*X.

dot([A,B,C], [X,Y,Z], D) :-
    D is A*X+B*Y+C*Z.

% The area of the caps in space.
cap_area_in_space(Section, S, N, Area) :-
    section_region(Section, S, _, M, Edges),
    findall(Twice,
            ( member(V1-V2, Edges),
              vertex(M, V1, A),
              vertex(M, V2, B),
              cross(A, B, C),
              dot(C, N, Twice) ),
            All),
    sum_list(All, Sum),
    dot(N, N, Square),
    Area is abs(Sum)/2/sqrt(Square).

random_solid(at([rotate(x,A),rotate(z,B),translate(X,Y,Z)], Term)) :-
    maplist(random_between(0, 90), [A,B]),
    maplist(random_between(-1, 1), [X,Y,Z]),
    random_member(Term,
                  [ box(size(2,3,4)), sphere(radius(2), facets(12)),
                    cylinder(radius(1.5), height(4), facets(11)),
                    torus(radius(2), tube(0.7), facets(14), sides(7)),
                    hollow_cylinder(radius(2), inner(1), height(3),
                                    facets(9)) ]).

near(A, B) :-
    abs(A-B) =< 1.0e-9*max(1, abs(B)).

:- begin_tests(section).

test(plane, [forall(member(Text-Plane-Axis,
                    [ 'x=5'-plane(1,0,0,-5)-x, 'X = 5'-plane(1,0,0,-5)-x,
                      'y=5'-plane(0,-1,0,5)-y, 'z=-0.5'-plane(0,0,1,0.5)-z,
                      '1,2,3,-4'-plane(1,2,3,-4)-none ])),
             true(P-A == Plane-Axis)]) :-
    section_plane(Text, P, A).
test(middle, true(P == plane(0,0,1,-1.5))) :-
    with([box(size(1,2,3))], section_plane(z, P0, _)),
    P0 = plane(A,B,C,D0),
    D is D0+0.0,
    P = plane(A,B,C,D).
test(touching, [forall(member(Text, ['x=-0.5', 'x=0.5', 'z=0', 'z=3']))]) :-
    with([box(size(1,2,3))],
         ( section_plane(Text, Plane, _),
           \+ cut_away(Plane, _) )).
test(no_plane, [forall(member(Text, [ w, 'x=', 'x=a', 'w=1', '1,2,3', '',
                                      '0,0,0,1', '1,2,3,x', 'x=1=2' ])),
                fail]) :-
    with([box(size(1,2,3))], section_plane(Text, _, _)).
test(past, [forall(member(Text, ['x=7', 'x=-1', '1,1,1,100']))]) :-
    with([box(size(1,2,3))],
         ( section_plane(Text, Plane, _),
           \+ cut_away(Plane, _),
           once(segment(1, _, _)) )).
test(box, [forall(member(Text-Axes-Wanted, [x-yz-6.0, y-xz-3.0, z-xy-2.0])),
           true(near(Area, Wanted))]) :-
    with([box(size(1,2,3))],
         ( section_plane(Text, Plane, _),
           cut_away(Plane, Section),
           cap_area(Section, 1, Axes, Area) )).
test(what_stays) :-
    with([box(size(1,2,3))],
         ( cut_away(plane(0,0,1,-1), Section),
           Section = section(_, [piece(1,N,solid,[_])]),
           findall(Z, v(N,_,_,_,Z), Zs),
           max_list(Zs, 1.0),
           min_list(Zs, 0.0) )).
test(tube, true(near(Area, Wanted))) :- % two rectangles
    tree(difference([cylinder(radius(2), height(5), facets(32)),
                     cylinder(radius(1), height(9), facets(32))]),
         ( cut_away(plane(0,-1,0,0), Section),
           cap_area(Section, _, xz, Area) )),
    Wanted is 2*5*1.0.
test(ring, true(near(Area, Wanted))) :- % a polygon with a hole
    tree(difference([cylinder(radius(2), height(5), facets(24)),
                     cylinder(radius(1), height(9), facets(24))]),
         ( cut_away(plane(0,0,1,-2), Section),
           cap_area(Section, _, xy, Area) )),
    Wanted is 24/2*sin(2*pi/24)*(4-1).
test(flush, true(near(Area, 2.0))) :-   % a step in the plane is not cut
    tree(union([box(size(6,4,1)),
                at([translate(1,0,0)], box(size(2,1,3)))]),
         ( cut_away(plane(0,0,1,-1), Section),
           cap_area(Section, _, xy, Area) )).
test(flush_hole, true(near(Area, 12.0))) :- % nor is the floor of a pocket
    tree(difference([box(size(4,4,2)),
                     at([translate(0,0,1)], box(size(2,2,2)))]),
         ( cut_away(plane(0,0,1,-1), Section),
           cap_area(Section, _, xy, Area) )).
test(ellipse, true(near(Area, Wanted))) :- % 45 degrees: sqrt(2) in space
    with([cylinder(radius(1), height(10), facets(64))],
         ( cut_away(plane(1,0,1,-5), Section),
           cap_area(Section, 1, xy, Area) )),
    Wanted is 64/2*sin(2*pi/64).
test(random_areas, [forall(between(1, 60, Seed))]) :-
    set_random(seed(Seed)),
    random_solid(One),
    random_solid(Other),
    maplist(random_between(-3, 3), [A,B,C]),
    random_between(-10, 10, D0),
    D is D0/10,
    (   [A,B,C] == [0,0,0]
    ->  N = [1,2,3]
    ;   N = [A,B,C]
    ),
    append(N, [D], Numbers),
    Plane =.. [plane|Numbers],
    tree(difference([One,Other]),
         ( findall(S-Area, ( segment(S,_,_), p_once(S),
                             sliced_area(S, N-D, Area) ), Wanted),
           (   cut_away(Plane, Section)
           ->  true
           ;   Section = section(Plane, [])
           ),
           forall(member(S-Area, Wanted),
                  (   cap_area_in_space(Section, S, N, Found)
                  ->  abs(Found-Area) < 1.0e-6
                  ;   Area < 1.0e-6
                  )) )).
test(section_edges_close, [forall(member(Plane, [ plane(0,0,1,-1.0),
                                                  plane(1,2,3,-4.0) ]))]) :-
    with([box(size(1,2,3))],
         ( cut_away(Plane, Section),
           section_region(Section, 1, _, _, Edges),
           findall(V, member(V-_, Edges), Starts0),
           findall(V, member(_-V, Edges), Ends0),
           msort(Starts0, Vs),
           msort(Ends0, Vs) )).
test(segments_apart, true(Areas == [1,4])) :-
    with([box(size(1,1,1)), at([translate(5,0,0)], box(size(2,2,2)))],
         ( cut_away(plane(0,0,1,-0.5), Section),
           findall(A, ( member(S, [1,2]), cap_area(Section, S, xy, A0),
                        A is round(A0) ), Areas) )).
test(not_reached_stays_whole) :-
    with([box(size(1,1,1)), at([translate(5,0,0)], box(size(2,2,2))),
          at([translate(0,0,-9)], box(size(2,2,2)))],
         ( cut_away(plane(0,0,1,-1.5), section(_, Pieces)),
           memberchk(piece(1,1,below,[]), Pieces),
           memberchk(piece(2,_,solid,[_]), Pieces),
           memberchk(piece(3,3,below,[]), Pieces) )).
test(surface) :-                        % a roof: ends in one line
    with([sheet(points([[-2,-1,0],[2,-1,0],[2,1,0],[-2,1,0]]),
                faces([[1,2,3,4]]))],
         ( cut_away(plane(1,0,0,-0.5), Section),
           Section = section(_, [piece(1,N,surface,[])]),
           \+ section_region(Section, 1, _, _, _),
           findall(E, ( section_edges(Section, N, Es), member(E, Es) ), [_]),
           findall(X, v_used(N, X), Xs),
           max_list(Xs, 0.5),
           min_list(Xs, -2.0) )).
test(curve, true(Xs == [0.0,0.25,1.0])) :-
    in_new(( assert_fact(segment(1, curve, wire)),
             assert_fact(v(1,1,0.0,0.0,0.0)), assert_fact(v(1,2,1.0,0.0,2.0)),
             assert_fact(v(1,3,0.0,0.0,4.0)),
             assert_fact(e(1,1,1,2,1)), assert_fact(e(1,2,2,3,1)),
             assert_fact(segment(2, curve, low)),
             assert_fact(v(2,1,1.0,0.0,-1.0)),
             assert_fact(v(2,2,1.0,0.0,0.25)),
             assert_fact(e(2,1,1,2,1)),
             cut_away(plane(0,0,1,-0.5), _),
             findall(X, v_used(_, X), Xs0) )),
    sort(Xs0, Xs).
test(operand_lines_stay, true(Count-All == 8-16)) :- % a drilled block
    in_new(( assert_fact(segment(1, solid,
                 difference([at([translate(0,0,-2)], box(size(4,4,4))),
                             cylinder(radius(1), height(9), facets(16))]))),
             evaluate,
             operand_lines(Lines0),
             roots_alone,
             cut_away(plane(0,-1,0,0), Section),
             section_lines(Section, Lines0, Lines),
             length(Lines0, All),
             findall(E, section_edges(Section, _, E), [InPlane]),
             findall(L, ( member(L, Lines), L = border(N,_,V1,V2,_),
                          e(N,E,V1,V2,_), \+ memberchk(E, InPlane) ),
                     Others),
             length(Others, Count) )).

%   Figure 1 of the paper of 1996, cut across: four cells, and no two that have
%   a face in common alike; the sheet has one line outside on either side. Areas
%   are those of polygons of twelve corners.

test(cells, true(Colours-Areas-Surfaces ==
                 [1,1,2,2]-[1.5,1.5,1.875,1.875]-1)) :-
    materials(( cut_away(plane(0,0,1,-1), Section),
                Section = section(_, Pieces),
                findall(N-Two,
                        ( section_region(Section, 6, K, N, Edges),
                          cell_area(Edges, N, Area),
                          Two = K-Area ),
                        Cells0),
                findall(N, member(piece(6,N,surface,[]), Pieces), Ns),
                length(Ns, Surfaces),
                neighbours_differ(Cells0) )),
    findall(K, member(_-(K-_), Cells0), Colours0),
    msort(Colours0, Colours),
    findall(Area, member(_-(_-Area), Cells0), Areas0),
    msort(Areas0, Areas1),
    maplist([A0,A]>>(A is round(A0*1.0e6)/1.0e6), Areas1, Areas).

%   What the plane does not reach is as it was; what it reaches comes from the
%   same polygons.

test(cells_sources, true(Sources == Known)) :-
    materials(( findall(P, ( p(6, P, _), polygon_below(P) ), Known0),
                cut_away(plane(0,0,1,-1), section(_, Pieces)),
                findall(P, ( member(piece(6,N,_,_), Pieces),
                             from_p(N, _, 6, P, _) ),
                        Sources0) )),
    sort(Known0, Known),
    sort(Sources0, Sources).

materials(Goal) :-
    in_new(( load_model('facts/figures/glue_materials.pl'),
             roots_alone,
             Goal )).

cell_area(Edges, N, Area) :-
    findall(Twice,
            ( member(V1-V2, Edges),
              v(N, V1, X1, Y1, _),
              v(N, V2, X2, Y2, _),
              Twice is X1*Y2 - X2*Y1 ),
            All),
    sum_list(All, Sum),
    Area is Sum/2.

%   neighbours_differ(Cells): cells that have an edge of the caps in common.

neighbours_differ(Cells) :-
    findall(K1-K2,
            ( member(N1-(K1-_), Cells),
              member(N2-(K2-_), Cells),
              N1 < N2,
              once(common_edge(N1, N2)) ),
            Pairs),
    length(Pairs, 4),
    \+ memberchk(K-K, Pairs).

common_edge(N1, N2) :-
    cap_edge(N1, A, B),
    cap_edge(N2, B, A).

cap_edge(N, X1-Y1, X2-Y2) :-
    v(N, V1, X1, Y1, 1.0),
    e(N, _, V1, V2, _),
    v(N, V2, X2, Y2, 1.0).

polygon_below(P) :-
    p(6, P, Es),
    member(E, Es),
    e(6, E, V, _, _),
    v(6, V, _, _, Z),
    Z < 1,
    !.

p_once(S) :-
    once(p(S, _, _)).

v_used(N, X) :-
    e(N, _, V1, V2, _),
    member(V, [V1,V2]),
    v(N, V, X, _, _).

:- end_tests(section).
